"""The Lyapunov candidates, Eqs. (17) and (24).

    V = (|e|^2 + |K - KD|^2/gamma + |GammaD - Gamma|^2/gamma) / 2               Eq. (17)
    V = Eq. (17) + |theta + alpha|^2 / (2 gamma)                                Eq. (24)

The paper has one gain gamma (`one_gain`); here each error is weighed by its own.
V is a signal like any other: runs keep it and proofs differentiate it, both from
the functions here.

Ports: e[2] (length), alpha[2N] (length per time), K[2], Gamma[2] (per time) -> V[1].
"""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from ..equations.block import Block


class LyapunovParameters(NamedTuple):
    """The true parameters that V measures the distance to."""

    N: int  # number of basis functions
    gain: np.ndarray  # shape (2, N), gamma > 0 of alpha
    gain_K: np.ndarray  # shape (2,), gamma of K
    gain_Gamma: np.ndarray  # shape (2,), gamma of Gamma
    theta: np.ndarray  # shape (2, N), length per time
    KD: np.ndarray  # shape (2,), feedback gains of the vehicle, per time
    GammaD: np.ndarray  # shape (2,), feedforward gains, per time


def weighed(
    gains: Sequence[float], theta: np.ndarray, KD: np.ndarray, GammaD: np.ndarray
) -> LyapunovParameters:
    """Return the parameters of V for the gains of alpha, K and Gamma; a gain of 0 has no error."""
    theta, KD, GammaD = (np.asarray(a, dtype=float) for a in (theta, KD, GammaD))
    alpha, K, Gamma = (gain if gain > 0 else np.inf for gain in gains)
    every = np.full(theta.shape, alpha)
    return LyapunovParameters(
        theta.shape[1], every, np.full(2, K), np.full(2, Gamma), theta, KD, GammaD
    )


def one_gain(
    gain: float, theta: np.ndarray, KD: np.ndarray, GammaD: np.ndarray
) -> LyapunovParameters:
    """Return the parameters of Eqs. (17) and (24): one gain gamma."""
    return weighed((gain, gain, gain), theta, KD, GammaD)


def known_flow(t, x, u, p, y):
    """V of Eq. (17): u = e[2] (length), alpha[2N], K[2], Gamma[2]; y = V[1]."""
    n = p.N
    e, K, Gamma = u[0:2], u[2 + 2 * n : 4 + 2 * n], u[4 + 2 * n : 6 + 2 * n]
    V = 0.0
    for i in range(2):
        V += e[i] ** 2 / 2
        V += (K[i] - p.KD[i]) ** 2 / (2 * p.gain_K[i])
        V += (p.GammaD[i] - Gamma[i]) ** 2 / (2 * p.gain_Gamma[i])
    y[0] = V


def learned_flow(t, x, u, p, y):
    """V of Eq. (24): u = e[2] (length), alpha[2N], K[2], Gamma[2]; y = V[1]."""
    n = p.N
    known_flow(t, x, u, p, y)
    for i in range(2):
        for k in range(n):
            y[0] += (p.theta[i, k] + u[2 + i * n + k]) ** 2 / (2 * p.gain[i, k])


LAWS = {"known-flow": known_flow, "learned-flow": learned_flow}


def lyapunov_candidate(law: str, parameters: LyapunovParameters) -> Block:
    """Make V: Eq. (17) for the law ``"known-flow"``, Eq. (24) for ``"learned-flow"``."""
    return Block(
        "lyapunov",
        output=LAWS[law],
        inputs={"e": 2, "alpha": 2 * parameters.N, "K": 2, "Gamma": 2},
        outputs={"V": 1},
        parameters=parameters,
    )
