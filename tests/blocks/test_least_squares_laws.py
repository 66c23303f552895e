"""Recursive least squares against closed forms, and the bounds of P along runs.

1/P = 1/P(0) + int e^(-lambda_0 (t - s)) phi_f^2/r^2 ds of one function, and, where forgetting is 0
and phi_f is constant, 1/P = 1/P(0) + phi_f^2 t/r^2;

    (P(0)^-1 + int phi_f phi_f^T/r^2)^-1 <= P <= P(0)/rho,    tr P <= tr P(0)
"""

import numpy as np
import pytest
from law_blocks import alone, everything, of_law, square
from scipy.integrate import cumulative_trapezoid, quad, simpson

import clpt_control as clpt
from clpt_control.blocks.laws.least_squares import LEAST_SQUARES
from clpt_control.simulation.starts import state_columns

LAWS = ("least-squares", "composite-least-squares")
THETA = np.array([[0.6], [-0.4]])
PARAMETERS = {
    "gain_K": 0.0,
    "gain_Gamma": 0.0,
    "alpha_M": np.zeros((2, 1)),
    "rate": 1.0,
    "filter": 1.5,
    "noise": 0.3,
    "forgetting": 0.2,
    "largest": 0.8**2,
    "information": np.array([1 / 0.8**2]),
    "alpha_0": np.zeros((2, 1)),
}


@pytest.mark.parametrize("forgetting", [0.0, 0.2])
def test_a_constant_regressor_has_a_closed_form(forgetting):
    """phi_f(0) = 1 stays 1: 1/P comes to 1/P(0) + 1/(lambda_0 r^2) by e^(-lambda_0 t)."""
    t = np.linspace(0, 30, 31)
    law = LEAST_SQUARES.of(1, **{**PARAMETERS, "forgetting": forgetting})
    s, _ = alone(law, t, np.ones((1, 31)), THETA, P=0.8**2, rho=1.0, phi_f=1.0, q=-THETA)
    seen = -np.expm1(-forgetting * t) / forgetting if forgetting else t
    P = 1 / (1 / 0.8**2 + seen / 0.3**2)
    np.testing.assert_allclose(s["phi_f"], 1.0, rtol=1e-10)
    np.testing.assert_allclose(s["P"][0], P, rtol=1e-9)
    held = s["rho"][0] * P / 0.8**2
    np.testing.assert_allclose(-s["alpha"], THETA * (1 - held), atol=1e-9)
    eta = np.exp(-seen_at(t, forgetting))  # eta' = -P eta/r^2
    np.testing.assert_allclose(held, eta, rtol=1e-7)


def seen_at(t, forgetting):
    """int P/r^2, with P of the closed form."""

    def rate(s):
        seen = -np.expm1(-forgetting * s) / forgetting if forgetting else s
        return 1 / (0.3**2 / 0.8**2 + seen)

    return np.array([quad(rate, 0, end, epsabs=1e-12)[0] for end in t])


def test_what_is_never_seen_is_never_forgotten_beyond_the_bound():
    """phi = 0: P stays at its bound whatever is forgotten; below it P grows and stays below."""
    law = LEAST_SQUARES.of(1, **{**PARAMETERS, "forgetting": 2.0})
    at = state_columns([law])["P"].start
    for share in (1.0, 0.999, 0.5, 0.01):
        state = np.zeros(law.nstates)
        state[at] = share * PARAMETERS["largest"]
        rate = law.dynamics(0.0, state, np.zeros(law.ninputs))[at]
        assert rate == pytest.approx(2.0 * (1 - share) * share * PARAMETERS["largest"], abs=1e-15)


def along(law, seed):
    """A run over random waypoints with random priors, and its scenario."""
    random = np.random.default_rng(seed)
    points = random.normal(size=(5, 2)) * 2
    table = "learning." + law.replace("-", "_")
    more = {
        "reference": {"kind": "waypoints", "points": points.tolist(), "dwell": 4.0},
        f"{table}.priors": random.uniform(0.2, 2.0, 3).tolist(),
        f"{table}.forgetting": float(random.choice([0.0, 0.05, 0.5])),
        "learning.parameters": random.normal(size=(2, 3)).tolist(),
        **{"run.duration": 60.0, "run.output_step": 0.02},
    }
    scenario = of_law(law, more)
    return scenario, everything(scenario, **{"run.rtol": 1e-10, "run.atol": 1e-12})


@pytest.mark.parametrize("seed", range(4))
@pytest.mark.parametrize("law", LAWS)
def test_the_bounds_of_P_are_kept(law, seed):
    """And, where CLPE has no part in it, the error over P never rises."""
    scenario, run = along(law, seed)
    priors = np.array(scenario.learning.settings["priors"]) ** 2
    r = scenario.learning.row.block(scenario.known_to_law).parameters.noise
    P, rho = square(run, "P"), run.rho.values.ravel()
    np.testing.assert_allclose(P, np.swapaxes(P, 1, 2), atol=1e-12)
    assert np.trace(P, axis1=1, axis2=2).max() <= priors.sum() * (1 + 1e-9)
    assert np.all(np.diff(rho) <= 1e-12)
    assert np.all(np.linalg.eigvalsh(np.diag(priors) - rho[:, None, None] * P) >= -1e-9)
    for end in (1000, 2000, 3000):
        phi_f = run.phi_f.values[: end + 1]
        outer = np.einsum("ti,tj->tij", phi_f, phi_f)
        seen = simpson(outer, x=run.time.values[: end + 1], axis=0)
        least = np.linalg.inv(np.diag(1 / priors) + seen / r**2)
        assert np.linalg.eigvalsh(P[end] - least).min() >= -1e-7
        assert np.linalg.eigvalsh(P[end]).min() > 0
    if law == "least-squares":
        eta = (run.alpha + run.flow_parameters).values
        size = np.einsum("tik,tkj,tij->t", eta, np.linalg.inv(P), eta)
        assert np.all(np.diff(size) <= 1e-7 * size[0])
        assert np.all(np.sum(eta**2, axis=(1, 2)) <= priors.sum() * size * (1 + 1e-9))


@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize(
    "apart",
    [
        {"flow.disturbance": {"kind": "constant", "amplitude": [0.3, -0.2]}},
        {"localization": {"noise": 0.3, "noise_period": 5}},
    ],
    ids=["disturbance", "noise"],
)
def test_V_weighs_the_error_by_P_also_where_the_regression_is_not_exact(law, apart):
    """2 V = |e|^2 + r^2 |eta|^2/(w P), 1/P = 1/P(0) + int phi_f^2/r^2, of one function."""
    table = "learning." + law.replace("-", "_")
    weight = {} if law == "least-squares" else {f"{table}.weight": 1.0}
    one = {"centers": [[1.0, 0.0]], "widths": [3.0], "periods": [np.inf]}
    scenario = clpt.paper_scenario().with_values(
        {
            "basis": {"kernel": "gaussian", **one},
            "flow.parameters": THETA.tolist(),
            "model.parameters": [[0.0], [0.0]],
            "learning": {"law": law, "feedback": [1.0, 1.0], "feedforward": [1.0, 1.0]},
            "learning.adapt_gains": False,
            f"{table}.noise": 0.5,
            f"{table}.prior": 2.0,
            f"{table}.forgetting": 0.0,
            **weight,
            "run.duration": 60,
            "run.output_step": 0.02,
            **apart,
        }
    )
    run = clpt.simulate(clpt.closed_loop(scenario))
    seen = cumulative_trapezoid(run.phi_f.values**2 / 0.5**2, dx=0.02, initial=0)
    eta = (run.alpha.values + run.flow_parameters.values)[:, :, 0]
    e = (run.position - run.predicted_position).values
    V = np.sum(e**2 + 0.5**2 * eta**2 * (1 / 2.0**2 + seen)[:, None], axis=1) / 2
    np.testing.assert_allclose(run.lyapunov, V, rtol=1e-3)
