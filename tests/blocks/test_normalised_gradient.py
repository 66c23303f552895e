"""The normalised gradient against closed forms: a rate of at most gamma_n, V' along a run."""

import numpy as np
import pytest
from responses import response
from scipy.integrate import simpson

import clpt_control as clpt
from clpt_control.blocks.laws import normalised_gradient
from clpt_control.simulation.loops import paper_blocks
from clpt_control.simulation.starts import state_columns

LAW = normalised_gradient.LAW.of(
    1,
    gain=0.8,
    gain_K=0.0,
    gain_Gamma=0.0,
    alpha_M=np.zeros((2, 1)),
    rate=1.0,
    filter=1.5,
    regression_gain=0.7,
)


@pytest.mark.parametrize("regressor", [0.1, 1.0, 30.0])
def test_a_constant_regressor_is_learned_at_its_rate(regressor):
    """phi_f(0) = phi stays, e = 0: eta = theta e^(-gamma_n phi^2 t/(1 + phi^2))."""
    theta, t = np.array([0.6, -0.4]), np.linspace(0, 8, 9)
    u, state = np.zeros((LAW.ninputs, len(t))), np.zeros(LAW.nstates)
    u[2], u[7:9] = regressor, theta[:, None] * regressor * t
    columns = state_columns([LAW])
    state[columns["phi_f"]], state[columns["q"]] = regressor, -theta * regressor
    loop = clpt.connect([LAW], external=list(LAW.input_ports))
    found = response(loop, t, u, state, rtol=1e-11, atol=1e-13).states[columns["alpha"]]
    rate = 0.7 * regressor**2 / (1 + regressor**2)
    np.testing.assert_allclose(
        theta[:, None] + found, np.outer(theta, np.exp(-rate * t)), atol=1e-8
    )


def test_V_falls_as_the_theorem_says():
    more = {"learning.law": "normalised-gradient", "learning.gain": 0.8}
    scenario = clpt.paper_scenario().with_values(
        {**more, "run.duration": 20.0, "run.output_step": 0.005, "run.rtol": 1e-11}
    )
    run, columns = clpt.simulate(scenario), state_columns(paper_blocks(scenario))
    start = clpt.initial_state(scenario)
    x = response(
        clpt.closed_loop(scenario), run.time.values, None, start, rtol=1e-11, atol=1e-13
    ).states
    phi_f, V = x[columns["phi_f"]].T, run.lyapunov.values
    eta = run.alpha.values + run.flow_parameters.values
    seen = np.sum(np.einsum("tik,tk->ti", eta, phi_f) ** 2, -1)
    lost = 4.0 * seen / (0.8 * (1 + np.sum(phi_f**2, -1)))  # gamma_n = 4, k = 1
    for i in range(2):
        off = np.stack([run.feedback_gain.values[:, i] - 1, run.feedforward_gain.values[:, i] - 1])
        Q = x[columns[f"Q_{i + 1}"]].T.reshape(-1, 2, 2)
        lost += np.einsum("at,tab,bt->t", off, Q, off)
    rate = -np.sum(run.clpe.values**2, -1) - lost
    parts = [slice(2000 * k, 2000 * k + 2001) for k in range(2)]  # waypoints change at 10
    found = sum(simpson(rate[part], x=run.time.values[part]) for part in parts)
    assert found == pytest.approx(V[-1] - V[0], rel=1e-5)
