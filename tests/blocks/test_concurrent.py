"""Concurrent learning against closed forms and integrals made another way.

One function seen without CLPE, phi = 1: from the second window on S = M/(1 + M), M = (t - T)/(2 T),
B = theta S, and eta' = -gamma_c S eta.  S of the paper's track is M (1 + M)^-1 with M summed
over windows, each by Simpson's rule.
"""

from itertools import pairwise

import numpy as np
import pytest
from law_blocks import alone, everything, of_law
from scipy.integrate import simpson

from clpt_control.blocks.laws.remembering import CONCURRENT as LAW

GAMMA, T = 2.0, 0.5


def law_of(N):
    own = {"gain": 0.8, "memory_gain": GAMMA, "window": T, "rate": 1.0}
    return LAW.of(N, gain_K=0.0, gain_Gamma=0.0, alpha_M=np.zeros((2, N)), **own)


def test_one_function_is_the_closed_form():
    theta, first, t = np.array([[0.6], [-0.4]]), np.array([[0.3], [0.9]]), np.linspace(0, 6, 61)
    x, _ = alone(law_of(1), t, np.ones((1, 61)), theta, alpha=first)
    M = np.maximum(0.0, t - T) / (2 * T)
    np.testing.assert_allclose(x["S"][0], M / (1 + M), atol=1e-9)
    np.testing.assert_allclose(x["B"], theta * M / (1 + M), atol=1e-9)
    shrunk = np.exp(-GAMMA * 2 * T * (M - np.log(1 + M)))
    np.testing.assert_allclose(x["alpha"] + theta, (first + theta) * shrunk, atol=1e-8)


@pytest.mark.parametrize("after", [0.0, 1.0], ids=["nothing more", "one direction"])
def test_what_was_shown_once_is_learned_exponentially_and_for_good(after):
    theta = np.array([[0.6, -0.4], [0.2, 0.9]])
    t = np.linspace(0, 60, 6001)
    seen = t <= 4.0
    phi = np.array([np.where(seen, 1.0, after), seen * (t - 2.0)])
    x, _ = alone(law_of(2), t, phi, theta)
    least = np.linalg.eigvalsh(x["S"].T.reshape(-1, 2, 2))[:, 0]
    assert np.all(np.diff(least) >= -1e-9)  # as Chowdhary and Johnson ask of a stack
    k = 500  # t = 5
    off = np.linalg.norm(x["alpha"].T + theta.ravel(), axis=1)[k:]
    assert least[k] > 0.1
    assert np.all(off <= off[0] * np.exp(-2.0 * least[k] * (t[k:] - t[k])) * (1 + 1e-6) + 1e-12)
    assert off[-1] < 1e-9 * off[0]


def test_the_memory_is_that_of_all_windows_each_normalised_by_itself():
    start = {"vehicle.position": [1.3, -0.7], "run.duration": 6.0, "run.output_step": 0.01}
    run = everything(of_law("concurrent", start, held=True))
    times, phi, M, T = run.time.values, run.phi_x.values, np.zeros((3, 3)), 1.0  # T = 1/KD
    for a, b in pairwise(range(0, 501, 100)):
        Phi = simpson(phi[a : b + 1], x=times[a : b + 1], axis=0)
        M += np.outer(Phi, Phi) / (T**2 + Phi @ Phi)  # taken in while the next window runs
        S = M @ np.linalg.inv(np.eye(3) + M)
        np.testing.assert_allclose(run.S[b + 100].values.reshape(3, 3), S, atol=1e-9)
