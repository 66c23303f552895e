"""The Kalman filter and the normalised gradient against closed forms and along a run."""

import numpy as np
import pytest
from law_blocks import alone, everything, square

import clpt_control as clpt
from clpt_control.blocks.laws import least_squares, paper

PAPER = clpt.paper_scenario()
THETA = np.array(PAPER.flow.parameters)


def filtered(duration, step=1.0, **own):
    """The paper's scenario with the filter; `own` are keys of its table."""
    values = {"learning.law": "kalman-flow", "learning.parameters": None}
    values |= {f"learning.kalman_flow.{key}": value for key, value in own.items()}
    return PAPER.with_values({**values, "run.duration": duration, "run.output_step": step})


@pytest.mark.parametrize("walk", [0.2, 0.5])
def test_one_function_is_the_closed_form(walk):
    r, pole, P0, theta, t = 0.3, 1.5, 0.64, np.array([[0.6], [-0.4]]), np.linspace(0, 3, 7)
    own = {"noise": r, "walk": walk, "filter": pole, "alpha_M": np.zeros((2, 1))}
    law = paper.KALMAN_FLOW.of(1, gain_K=0.0, gain_Gamma=0.0, **own)
    first = np.array([[0.1], [0.2]])
    start = {"theta_hat": first, "P": P0, "phi_f": 1.0, "q": -theta}
    found, _ = alone(law, t, np.ones((1, 7)), theta, **start)
    p, s = walk * r, walk * t / r
    np.testing.assert_allclose(
        found["P"][0], p * (P0 + p * np.tanh(s)) / (p + P0 * np.tanh(s)), rtol=1e-9
    )
    left = (first - theta) / (np.cosh(s) + P0 / p * np.sinh(s))
    np.testing.assert_allclose(found["theta_hat"] - theta, left, atol=1e-9)


def test_without_a_walk_the_error_is_the_prior_error_weighed_by_P():
    run = everything(filtered(60.0, 5.0, walk=0.0, noise=0.3, prior=0.7))
    d, P = run.flow_parameters_estimate.values - THETA, square(run, "P")
    np.testing.assert_allclose(d, d[0] @ P / 0.7**2, atol=1e-9)
    assert np.abs(d[-1]).max() < 0.2 * np.abs(d[0]).max()


def test_a_filter_that_starts_true_is_the_known_flow_law():
    known = PAPER.with_values(
        {
            "learning.law": "known-flow",
            "learning.parameters": None,
            "learning.theta_estimate": THETA,
            "model.parameters": 0.5 * THETA,
            "run.duration": 100.0,
        }
    )
    made, given = everything(known.with_values({"learning.law": "kalman-flow"})), everything(known)
    for name in ("clpe", "predicted_position", "feedback_gain", "alpha", "lyapunov"):
        np.testing.assert_allclose(made[name], given[name], atol=1e-7, err_msg=name)
    estimate = np.broadcast_to(THETA, made.flow_parameters_estimate.shape)
    np.testing.assert_allclose(made.flow_parameters_estimate, estimate, atol=1e-7)
    assert np.abs(given.clpe.values).max() > 0.01


def test_clpe_vanishes_with_the_gains_adapted():
    run = clpt.simulate(filtered(2000.0, step=0.5))
    off = np.abs(run.flow_parameters_estimate.sel(time=200.0) - THETA).max()
    last = run.clpe.sel(time=slice(1800.0, 2000.0))
    assert off < 0.05 * np.abs(THETA).min()
    assert float(np.sqrt((last**2).sum("axis").mean())) < 1e-4
    assert np.ptp(run.feedback_gain.values) > 0.5  # K adapts


def test_a_block_of_ones_own_may_make_the_estimate():
    scenario = filtered(60.0)
    table = clpt.paper_blocks(scenario)[-1]
    mine = clpt.Block(
        "mine",
        update=paper.kalman_flow,
        output=table.output_function,
        inputs=table.input_shapes,
        outputs=table.output_shapes,
        states=table.state_shapes,
        parameters=table.parameters._replace(walk=0.5),
    )
    run = clpt.simulate(clpt.closed_loop(scenario, law=mine))
    injected = clpt.closed_loop(scenario, law=mine).syslist[-3]
    assert injected.input_ports == {"phi_x": 3, "theta_hat": 6}
    assert np.ptp(run.alpha.values) == 0
    assert np.ptp(run.flow_parameters_estimate.values) > 0.1


def test_alpha_and_its_start_are_those_of_the_known_flow_law():
    with pytest.raises(
        clpt.ScenarioError, match=r'parameters: law = "kalman-flow" has no use for it; remove'
    ):
        filtered(10.0).with_values({"learning.parameters": THETA})
    start = filtered(10.0).with_values({"model.parameters": 0.5 * THETA})
    run = clpt.simulate(start)
    np.testing.assert_array_equal(run.flow_parameters_estimate[0], 0.5 * THETA)
    np.testing.assert_array_equal(run.alpha[-1], 0.5 * THETA)


@pytest.mark.parametrize("regressor", [0.1, 1.0, 30.0])
def test_a_constant_regressor_is_learned_at_its_rate(regressor):
    """phi_f(0) = phi stays, e = 0: eta = theta e^(-gamma_n phi^2 t/(1 + phi^2))."""
    own = {"gain": 0.8, "rate": 1.0, "filter": 1.5, "regression_gain": 0.7}
    gains = {"gain_K": 0.0, "gain_Gamma": 0.0}
    law = least_squares.NORMALISED_GRADIENT.of(1, alpha_M=np.zeros((2, 1)), **gains, **own)
    theta, t = np.array([[0.6], [-0.4]]), np.linspace(0, 8, 9)
    start = {"phi_f": regressor, "q": -theta * regressor}
    found, _ = alone(law, t, np.full((1, 9), regressor), theta, **start)
    rate = 0.7 * regressor**2 / (1 + regressor**2)
    np.testing.assert_allclose(theta + found["alpha"], theta * np.exp(-rate * t), atol=1e-8)
