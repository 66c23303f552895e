"""The paper's scenario with few basis functions, and numbers that no two parameters share."""

import numpy as np

import clpt_control as clpt

FIXES = {  # settings of a law that learns at fixes
    "localization": {"interval": 5.0},
    **dict.fromkeys(("learning.gain", "learning.feedback", "learning.feedforward")),
}


def paper_of(N, law="learned-flow", **values):
    """Return the scenario of a law of the table with N functions; `values` have _ for dots."""
    signs, row = np.array([[1.0], [-1.0]]) * np.arange(1, N + 1), clpt.laws()[law]
    basis = {
        "centers": [[float(k), float(-k)] for k in range(N)],
        "widths": [1.0 + k for k in range(N)],
        "periods": [2.0 + k for k in range(N)],
        "phases": [0.0] * N,
    }
    settings = {f"basis.{key}": value for key, value in basis.items()} | {
        "flow.parameters": (0.1 * signs).tolist(),
        "model.parameters": (-0.3 * signs).tolist(),
        "vehicle.feedback": [1.0, 0.7],
        "vehicle.feedforward": [1.2, -0.5],
        "learning.law": law,
        "learning.parameters": (
            None if row.alpha_is_constant else (0.2 * signs).tolist()
        ),
    }
    if row.given_estimate:
        settings["learning.theta_estimate"] = (0.4 * signs).tolist()
    if row.at_fixes:
        settings |= FIXES
    return clpt.paper_scenario().with_values(settings | values)


def kernels(scenario, t, points):
    """exp(-d/(2 sigma)) cos(omega t), by hand, (n, N)."""
    basis = scenario.basis
    d = np.linalg.norm(points[:, None] - np.array(basis.centers), axis=-1)
    turns = np.cos(2 * np.pi * t / np.array(basis.periods))
    return np.exp(-d / (2 * np.array(basis.widths))) * turns


def uniform_flow(law="fix-regression", **settings):
    """A scenario in km and h of one function that is the same everywhere, for fixes."""
    return clpt.Scenario(
        basis={
            "kernel": "gaussian",
            "centers": [[0, 0]],
            "widths": [1e5],
            "constituents": ["steady"],
        },
        units={"length": "km", "time": "h"},
        learning={"law": law} | ({"fix_regression": settings} if settings else {}),
    )
