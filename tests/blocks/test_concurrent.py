"""Concurrent learning against closed forms and integrals made another way.

One function seen without CLPE, phi = 1: after m windows S = m/(m + 1), B = theta S, and eta
shrinks by exp(-gamma_c S T) over a window.  S of the paper's track by Simpson's rule.
"""

from itertools import pairwise

import numpy as np
import pytest
from responses import response
from scipy.integrate import simpson

import clpt_control as clpt
from clpt_control.blocks.laws.concurrent import LAW

PAPERS = 0.257  # largest error of the paper's law at t = 200, its gains adapted
HELD = {
    "learning.adapt_gains": False,
    "learning.feedback": [1, 1],
    "learning.feedforward": [1, 1],
}
INPUTS = {"e": 2, "phi_x": 1, "z": 2, "zc": 2, "x": 2, "v_x": 2}


def of_paper(duration=200.0, **more):
    paper = clpt.paper_scenario()
    return paper.with_values({"learning.law": "concurrent", "run.duration": duration, **more})


def alone(N, t, phi, theta, start, gamma=2.0, T=0.5):
    """Run the law alone, without CLPE: x is the integral of theta phi, v = 0."""
    own = {"gain": 0.8, "memory_gain": gamma, "window": T}
    law = LAW.of(N, gain_K=0.0, gain_Gamma=0.0, **own)
    u = np.zeros((10 + N, len(t)))
    u[2 : 2 + N] = phi
    flow = theta @ phi
    steps = np.diff(t) * (flow[:, 1:] + flow[:, :-1]) / 2  # inputs are straight lines
    u[6 + N : 8 + N, 1:] = np.cumsum(steps, axis=1)
    loop = clpt.connect([law], external=list({**INPUTS, "phi_x": N}))
    return response(loop, t, u, start, rtol=1e-11, atol=1e-13).states


def test_one_function_is_the_closed_form():
    theta, first, T, gamma = np.array([[0.6], [-0.4]]), np.array([0.3, 0.9]), 0.5, 2.0
    t = T * np.arange(13)
    start = np.zeros(13)
    start[:2], start[9] = first, T
    x = alone(1, t, np.ones((1, len(t))), theta, start)
    S = np.arange(13) / np.arange(1, 14)
    np.testing.assert_allclose(x[6], S, rtol=1e-12)
    np.testing.assert_allclose(x[7:9], theta * S, atol=1e-12)
    np.testing.assert_allclose(x[9] ** 2, T**2 * np.arange(1, 14), rtol=1e-12)
    shrunk = np.exp(-gamma * T * np.append(0.0, np.cumsum(S[:-1])))
    np.testing.assert_allclose(x[:2] + theta, (first[:, None] + theta) * shrunk, atol=1e-8)


def test_what_was_shown_once_is_learned_though_nothing_more_is_shown():
    theta = np.array([[0.6, -0.4], [0.2, 0.9]])
    t = np.linspace(0, 30, 3001)
    seen = t <= 4.0
    phi = np.array([seen, seen * (t - 2.0)])
    start = np.zeros(21)
    start[16] = 0.5  # sigma, after alpha, K, Gamma, S, B
    x = alone(2, t, phi, theta, start)
    late = t >= 5.0
    S = x[8:12, late].T.reshape(-1, 2, 2)
    np.testing.assert_allclose(S, np.broadcast_to(S[0], S.shape), atol=1e-12)
    least = np.linalg.eigvalsh(S[0])[0]
    off = np.linalg.norm(x[:4, late].T + theta.ravel(), axis=1)
    wanted = off[0] * np.exp(-2.0 * least * (t[late] - t[late][0]))
    assert least > 0.1
    assert np.all(off <= wanted * (1 + 1e-6) + 1e-12)
    assert off[-1] < 0.01 * off[0]


def along(duration, step, **more):
    """A run with K and Gamma held true, its outputs by port, shape (time, ...)."""
    scenario = of_paper(duration, **HELD, **more)
    loop, times = clpt.closed_loop(scenario), np.arange(0, duration + step / 2, step)
    found = response(loop, times, None, clpt.initial_state(scenario), rtol=1e-11, atol=1e-13)
    ports = np.array([label.split("[")[0] for label in loop.output_labels])
    return times, {port: found.outputs[ports == port].T for port in set(ports)}


def test_the_memory_is_the_mean_of_the_windows():
    times, run = along(6.0, 0.01, **{"vehicle.position": [1.3, -0.7]})
    s, S = 1.0, np.zeros((3, 3))  # T = 1/KD = 1
    for a, b in pairwise(range(0, 601, 100)):
        Phi = simpson(run["phi_x"][a : b + 1], x=times[a : b + 1], axis=0)
        S = (s * S + np.outer(Phi, Phi)) / (s + Phi @ Phi)
        s += Phi @ Phi
        np.testing.assert_allclose(run["S"][b].reshape(3, 3), S, atol=1e-9)
        assert run["sigma"][b, 0] ** 2 == pytest.approx(s, rel=1e-8)
        assert np.trace(S) < 1


def test_V_falls_as_the_theorem_says_between_windows_and_across():
    times, run = along(20.0, 0.01)
    theta = np.array(clpt.paper_scenario().flow.parameters)
    eta = run["alpha"].reshape(-1, 2, 3) + theta
    V = np.sum(run["e"] ** 2, axis=1) / 2 + np.sum(eta**2, axis=(1, 2)) / (2 * 0.8)
    fallen = 0.0
    for a, b in pairwise(range(0, len(times), 100)):
        S = run["S"][a].reshape(3, 3)
        lost = np.einsum("tik,kj,tij->t", eta[a : b + 1], S, eta[a : b + 1]) * 5.0 / 0.8
        rate = np.sum(run["e"][a : b + 1] ** 2, axis=1) + lost
        fallen += simpson(rate, x=times[a : b + 1])
    assert V[0] - V[-1] == pytest.approx(fallen, rel=1e-7)
    late = range(1000, len(times))
    least = min(np.linalg.eigvalsh(run["S"][k].reshape(3, 3))[0] for k in late)
    bound = V[1000] * np.exp(-min(2.0, 2 * 5.0 * least) * (times[1000:] - times[1000]))
    assert least > 0.01
    assert np.all(V[1000:] <= bound * (1 + 1e-6))


@pytest.mark.parametrize("held", [{}, HELD], ids=["adapted", "held"])
def test_the_flow_is_learned_a_hundred_times_closer_than_by_the_papers_law(held):
    run = clpt.simulate(of_paper(**held))
    off = np.abs(run.flow_parameters_estimate - run.flow_parameters).isel(time=-1)
    assert float(off.max()) <= PAPERS / 100
    assert np.all(np.diff(run.lyapunov) <= 1e-12)


def test_python_runs_the_same():
    scenario = of_paper(3.0, **{"run.output_step": 0.5})
    native, python = (clpt.simulate(scenario, engine=engine) for engine in ("native", "python"))
    np.testing.assert_allclose(native.alpha, python.alpha, atol=1e-9)


def test_members_have_windows_of_their_own():
    scenario = of_paper(40.0, **{"learning.concurrent": {"window": 1.0}})
    lengths = [0.5, 1.0, 3.0]
    vary = f"learning.concurrent.window={lengths}"
    found = clpt.ensemble.run_ensemble(scenario, vary, 6, trajectories=True)
    drawn = found["learning.concurrent.window"].values
    assert len(set(drawn)) > 1
    for k, length in enumerate(drawn):
        own = {"learning.concurrent.window": float(length)}
        one = clpt.simulate(scenario.with_values(own))
        there = found.alpha.isel(member=k, time=-1)
        np.testing.assert_allclose(there, one.alpha.isel(time=-1), atol=1e-9)
