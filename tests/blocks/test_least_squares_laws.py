"""Recursive least squares against closed forms, and the bounds of P along runs.

1/P = 1/P(0) + int e^(-lambda_0 (t - s)) phi_f^2/r^2 ds of one function, and, where forgetting is 0
and phi_f is constant, 1/P = 1/P(0) + phi_f^2 t/r^2;

    (P(0)^-1 + int phi_f phi_f^T/r^2)^-1 <= P <= P(0)/rho,    tr P <= tr P(0)
"""

import numpy as np
import pytest
from law_blocks import alone
from responses import response
from scipy.integrate import quad, simpson

import clpt_control as clpt
from clpt_control.blocks.laws.least_squares import LEAST_SQUARES
from clpt_control.simulation.loops import paper_blocks
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
    """A run over random waypoints with random priors; states by port, and the scenario."""
    random = np.random.default_rng(seed)
    points = random.normal(size=(5, 2)) * 2
    table = "learning." + law.replace("-", "_")
    more = {
        "reference": {"kind": "waypoints", "points": points.tolist(), "dwell": 4.0},
        "learning.law": law,
        "learning.gain": None,
        f"{table}.priors": random.uniform(0.2, 2.0, 3).tolist(),
        f"{table}.forgetting": float(random.choice([0.0, 0.05, 0.5])),
        "learning.parameters": random.normal(size=(2, 3)).tolist(),
    }
    scenario = clpt.paper_scenario().with_values(more)
    loop, times = clpt.closed_loop(scenario), np.linspace(0, 60, 3001)
    state = clpt.initial_state(scenario)
    found = response(loop, times, None, state, rtol=1e-10, atol=1e-12).states
    columns = state_columns(paper_blocks(scenario))
    s = {port: found[column] for port, column in columns.items()}
    return scenario, times, s


@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize("seed", range(4))
def test_the_bounds_of_P_are_kept(law, seed):
    scenario, times, s = along(law, seed)
    priors = np.array(scenario.learning.settings["priors"]) ** 2
    r = scenario.learning.row.block(scenario.known_to_law).parameters.noise
    P, rho = s["P"].T.reshape(-1, 3, 3), s["rho"][0]
    np.testing.assert_allclose(P, np.swapaxes(P, 1, 2), atol=1e-12)
    assert np.trace(P, axis1=1, axis2=2).max() <= priors.sum() * (1 + 1e-9)
    assert np.all(np.diff(rho) <= 1e-12)
    assert np.all(np.linalg.eigvalsh(np.diag(priors) - rho[:, None, None] * P) >= -1e-9)
    for end in (1000, 2000, 3000):
        outer = np.einsum("it,jt->tij", *[s["phi_f"][:, : end + 1]] * 2)
        seen = simpson(outer, x=times[: end + 1], axis=0)
        least = np.linalg.inv(np.diag(1 / priors) + seen / r**2)
        assert np.linalg.eigvalsh(P[end] - least).min() >= -1e-7
        assert np.linalg.eigvalsh(P[end]).min() > 0


@pytest.mark.parametrize("seed", range(4))
def test_the_error_over_P_never_rises(seed):
    scenario, _, s = along("least-squares", seed)
    eta = (s["alpha"] + np.ravel(scenario.flow.parameters)[:, None]).T.reshape(-1, 2, 3)
    P = s["P"].T.reshape(-1, 3, 3)
    size = np.einsum("tik,tkj,tij->t", eta, np.linalg.inv(P), eta)
    assert np.all(np.diff(size) <= 1e-7 * size[0])
    largest = np.sum(np.array(scenario.learning.settings["priors"]) ** 2)
    assert np.all(np.sum(eta**2, axis=(1, 2)) <= largest * size * (1 + 1e-9))


def test_alpha_does_not_know_K_and_Gamma():
    """What is learned of the flow is the same whatever K and Gamma are."""
    paper = clpt.paper_scenario().with_values(
        {"learning.law": "least-squares", "learning.gain": None, "run.duration": 50.0}
    )
    far = paper.with_values({"learning.feedback": [3.0, 0.5], "learning.feedforward": [-1.0, 2.0]})
    one, other = (clpt.simulate(scenario).alpha.values for scenario in (paper, far))
    np.testing.assert_allclose(one, other, atol=1e-6)


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
    run = clpt.simulate(scenario)
    states = dict(zip(run.state.values, run.states.values.T, strict=True))
    seen = states["adaptation_phi_f[0]"] ** 2 / 0.5**2 * 0.02
    seen = np.concatenate([[0.0], np.cumsum((seen[1:] + seen[:-1]) / 2)])
    eta = (run.alpha.values + run.flow_parameters.values)[:, :, 0]
    e = (run.position - run.predicted_position).values
    V = np.sum(e**2 + 0.5**2 * eta**2 * (1 / 2.0**2 + seen)[:, None], axis=1) / 2
    np.testing.assert_allclose(run.lyapunov, V, rtol=1e-3)
