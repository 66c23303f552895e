"""Least squares, the bounds of P along runs, the Kalman filter and the normalised gradient.

1/P = 1/P(0) + int e^(-lambda_0 (t - s)) phi_f^2/r^2 ds of one function, and, where forgetting is
0 and phi_f is constant, 1/P = 1/P(0) + phi_f^2 t/r^2;

    (P(0)^-1 + int phi_f phi_f^T/r^2)^-1 <= P <= P(0)/rho,    tr P <= tr P(0)
"""

import numpy as np
import pytest
from error_sentences import says
from law_blocks import alone, everything, of_law, off, square, still
from scipy.integrate import cumulative_trapezoid, quad, simpson

import clpt_control as clpt

SQUARES = ("least-squares", "composite-least-squares")
THETA = np.array([[0.6], [-0.4]])
USUAL = {"rate": 1.0, "filter": 1.5, "noise": 0.3, "largest": 0.8**2}
USUAL |= {"information": np.array([1 / 0.8**2]), "alpha_0": np.zeros((2, 1))}


def seen(t, forgetting):
    """int e^(-lambda_0 s) ds."""
    return -np.expm1(-forgetting * t) / forgetting if forgetting else t


@pytest.mark.parametrize("forgetting", [0.0, 0.2])
def test_a_constant_regressor_has_a_closed_form(forgetting):
    """phi_f(0) = 1 stays 1: 1/P comes to 1/P(0) + 1/(lambda_0 r^2) by e^(-lambda_0 t)."""
    t, law = (
        np.linspace(0, 30, 31),
        still(clpt.laws()["least-squares"], **USUAL, forgetting=forgetting),
    )
    s, _ = alone(
        law, t, np.ones((1, 31)), THETA, P=0.8**2, rho=1.0, phi_f=1.0, q=-THETA
    )

    def P(t):
        return 1 / (1 / 0.8**2 + seen(t, forgetting) / 0.3**2)

    np.testing.assert_allclose(s["phi_f"], 1.0, rtol=1e-10)
    np.testing.assert_allclose(s["P"][0], P(t), rtol=1e-9)
    held = s["rho"][0] * P(t) / 0.8**2
    np.testing.assert_allclose(-s["alpha"], THETA * (1 - held), atol=1e-9)
    total = [quad(P, 0, end, epsabs=1e-12)[0] for end in t]
    # eta'/eta
    np.testing.assert_allclose(held, np.exp(np.array(total) / -(0.3**2)), rtol=1e-7)


def test_what_is_never_seen_is_never_forgotten_beyond_the_bound():
    """phi = 0: P stays at its bound whatever is forgotten; below it P grows and stays below."""
    law = still(clpt.laws()["least-squares"], **USUAL, forgetting=2.0)
    at, state = law.state_labels.index("P[0]"), np.zeros(law.nstates)
    for share in (1.0, 0.999, 0.5, 0.01):
        state[at] = share * 0.8**2
        rate = law.dynamics(0.0, state, np.zeros(law.ninputs))[at]
        assert rate == pytest.approx(2.0 * (1 - share) * share * 0.8**2, abs=1e-15)


def along(law, seed):
    """A run over random waypoints with random priors, and its scenario."""
    random, table = np.random.default_rng(seed), "learning." + law.replace("-", "_")
    points = random.normal(size=(5, 2)) * 2
    more = {
        "reference": {"kind": "waypoints", "points": points.tolist(), "dwell": 4.0},
        f"{table}.priors": random.uniform(0.2, 2.0, 3).tolist(),
        f"{table}.forgetting": float(random.choice([0.0, 0.05, 0.5])),
        "learning.parameters": random.normal(size=(2, 3)).tolist(),
    }
    scenario = of_law(law, {**more, "run.duration": 60.0, "run.output_step": 0.02})
    return scenario, everything(scenario, **{"run.rtol": 1e-10, "run.atol": 1e-12})


@pytest.mark.parametrize("seed", range(4))
@pytest.mark.parametrize("law", SQUARES)
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
        total = simpson(np.einsum("ti,tj->tij", phi_f, phi_f), dx=0.02, axis=0)
        least = np.linalg.inv(np.diag(1 / priors) + total / r**2)
        assert np.linalg.eigvalsh(P[end] - least).min() >= -1e-7
        assert np.linalg.eigvalsh(P[end]).min() > 0
    if law == "least-squares":
        eta = (run.alpha + run.flow_parameters).values
        size = np.einsum("tik,tkj,tij->t", eta, np.linalg.inv(P), eta)
        assert np.all(np.diff(size) <= 1e-7 * size[0])
        assert np.all(np.sum(eta**2, axis=(1, 2)) <= priors.sum() * size * (1 + 1e-9))


APART = {
    "flow.disturbance": {"kind": "constant", "amplitude": [0.3, -0.2]},
    "localization": {"noise": 0.3, "noise_period": 5},
}


@pytest.mark.parametrize("law", SQUARES)
@pytest.mark.parametrize("apart", APART)
def test_V_weighs_the_error_by_P_also_where_the_regression_is_not_exact(law, apart):
    """2 V = |e|^2 + r^2 |eta|^2/(w P), 1/P = 1/P(0) + int phi_f^2/r^2, of one function."""
    own = {"noise": 0.5, "prior": 2.0, "forgetting": 0.0}
    own |= {} if law == "least-squares" else {"weight": 1.0}
    one = {"centers": [[1.0, 0.0]], "widths": [3.0], "periods": [np.inf]}
    values = {
        "basis": {"kernel": "gaussian", **one},
        "flow.parameters": THETA.tolist(),
        "model.parameters": [[0.0], [0.0]],
        **{"learning.parameters": None, "learning.gain": None},
        "learning." + law.replace("-", "_"): own,
        **{"run.duration": 60, "run.output_step": 0.02, apart: APART[apart]},
    }
    run = clpt.simulate(clpt.closed_loop(of_law(law, values, held=True)))
    total = cumulative_trapezoid(run.phi_f.values**2 / 0.5**2, dx=0.02, initial=0)
    eta = (run.alpha.values + run.flow_parameters.values)[:, :, 0]
    e = (run.position - run.predicted_position).values
    V = np.sum(e**2 + 0.5**2 * eta**2 * (1 / 2.0**2 + total)[:, None], axis=1) / 2
    np.testing.assert_allclose(run.lyapunov, V, rtol=1e-3)


# --- the Kalman filter and the normalised gradient ----------------------------------------------

PAPER = clpt.paper_scenario()
TRUE = np.array(PAPER.flow.parameters)


def filtered(duration, step=1.0, **own):
    """The paper's scenario with the filter; `own` are keys of its table."""
    values = {"learning.law": "kalman-flow", "learning.parameters": None}
    values |= {f"learning.kalman_flow.{key}": value for key, value in own.items()}
    return PAPER.with_values(
        {**values, "run.duration": duration, "run.output_step": step}
    )


@pytest.mark.parametrize("walk", [0.2, 0.5])
def test_the_filter_of_one_function_is_the_closed_form(walk):
    r, P0, first, t = 0.3, 0.64, np.array([[0.1], [0.2]]), np.linspace(0, 3, 7)
    law = still(clpt.laws()["kalman-flow"], noise=r, walk=walk, filter=1.5)
    start = {"theta_hat": first, "P": P0, "phi_f": 1.0, "q": -THETA}
    found, _ = alone(law, t, np.ones((1, 7)), THETA, **start)
    p, s = walk * r, walk * t / r
    P = p * (P0 + p * np.tanh(s)) / (p + P0 * np.tanh(s))
    np.testing.assert_allclose(found["P"][0], P, rtol=1e-9)
    left = (first - THETA) / (np.cosh(s) + P0 / p * np.sinh(s))
    np.testing.assert_allclose(found["theta_hat"] - THETA, left, atol=1e-9)


def test_without_a_walk_the_error_is_the_prior_error_weighed_by_P():
    run = everything(filtered(60.0, 5.0, walk=0.0, noise=0.3, prior=0.7))
    d, P = run.flow_parameters_estimate.values - TRUE, square(run, "P")
    np.testing.assert_allclose(d, d[0] @ P / 0.7**2, atol=1e-9)
    assert np.abs(d[-1]).max() < 0.2 * np.abs(d[0]).max()


def test_a_filter_that_starts_true_is_the_known_flow_law():
    start = {"learning.theta_estimate": TRUE, "model.parameters": 0.5 * TRUE}
    known = filtered(100.0).with_values({"learning.law": "known-flow", **start})
    made, given = (
        everything(known.with_values({"learning.law": "kalman-flow"})),
        everything(known),
    )
    for name in ("clpe", "predicted_position", "feedback_gain", "alpha", "lyapunov"):
        np.testing.assert_allclose(made[name], given[name], atol=1e-7, err_msg=name)
    assert np.abs(made.flow_parameters_estimate - TRUE).max() < 1e-7
    assert np.abs(given.clpe.values).max() > 0.01


def test_clpe_vanishes_with_the_gains_adapted():
    run = clpt.simulate(filtered(2000.0, step=0.5))
    last = run.clpe.sel(time=slice(1800.0, 2000.0))
    assert off(run).sel(time=200.0) < 0.05 * np.abs(TRUE).min()
    assert float(np.sqrt((last**2).sum("axis").mean())) < 1e-4
    assert np.ptp(run.feedback_gain.values) > 0.5  # K adapts


def test_a_block_of_ones_own_may_make_the_estimate():
    scenario = filtered(60.0)
    table = clpt.paper_blocks(scenario)[-1]
    ports = {"inputs": table.input_shapes, "outputs": table.output_shapes}
    own = {
        "states": table.state_shapes,
        "parameters": table.parameters._replace(walk=0.5),
    }
    mine = clpt.Block(
        "mine",
        update=table.update_function,
        output=table.output_function,
        **ports,
        **own,
    )
    loop = clpt.closed_loop(scenario, law=mine)
    run = clpt.simulate(loop)
    assert loop.syslist[-3].input_ports == {"phi_x": 3, "theta_hat": 6}
    assert np.ptp(run.alpha.values) == 0
    assert np.ptp(run.flow_parameters_estimate.values) > 0.1


def test_alpha_and_its_start_are_those_of_the_known_flow_law():
    said = 'parameters: law = "kalman-flow" has no use for it. Remove'
    says(
        clpt.ScenarioError,
        said,
        filtered(10.0).with_values,
        {"learning.parameters": TRUE},
    )
    run = clpt.simulate(filtered(10.0).with_values({"model.parameters": 0.5 * TRUE}))
    np.testing.assert_array_equal(run.flow_parameters_estimate[0], 0.5 * TRUE)
    np.testing.assert_array_equal(run.alpha[-1], 0.5 * TRUE)


@pytest.mark.parametrize("regressor", [0.1, 1.0, 30.0])
def test_a_constant_regressor_is_learned_at_its_rate(regressor):
    """phi_f(0) = phi stays, e = 0: eta = theta e^(-gamma_n phi^2 t/(1 + phi^2))."""
    t, own = (
        np.linspace(0, 8, 9),
        {"gain": 0.8, "rate": 1.0, "filter": 1.5, "regression_gain": 0.7},
    )
    start = {"phi_f": regressor, "q": -THETA * regressor}
    law, phi = (
        still(clpt.laws()["normalised-gradient"], **own),
        np.full((1, 9), regressor),
    )
    found, _ = alone(law, t, phi, THETA, **start)
    rate = 0.7 * regressor**2 / (1 + regressor**2)
    np.testing.assert_allclose(
        THETA + found["alpha"], THETA * np.exp(-rate * t), atol=1e-8
    )
