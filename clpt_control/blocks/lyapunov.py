"""The Lyapunov candidates, Eqs. (17) and (24).

    V = (|e|^2 + |K - KD|^2/gamma + |GammaD - Gamma|^2/gamma) / 2               Eq. (17)
    V = Eq. (17) + |theta + alpha|^2 / (2 gamma)                                Eq. (24)

The paper has one gain gamma; here each error is weighed by its own, `one_gain` is the
paper's.

V is a signal like any other: a block that reads the diagram's outputs.  Runs
record it and the proofs differentiate it, both from the functions here.
"""

from typing import NamedTuple

import numpy as np

from .block import Block


class LyapunovParameters(NamedTuple):
    """The true parameters that V measures the distance to.

    Attributes
    ----------
    N : int
        Number of basis functions.
    gain : ndarray, shape (2, N)
        Adaptation gains gamma > 0 of alpha, one number in the paper.
    gain_K, gain_Gamma : ndarray, shape (2,)
        Adaptation gains of K and Gamma, the same number.
    theta : ndarray, shape (2, N)
        True flow parameters, length per time.
    KD, GammaD : ndarray, shape (2,)
        Gains of the vehicle controller, per time.
    """

    N: int
    gain: np.ndarray
    gain_K: np.ndarray
    gain_Gamma: np.ndarray
    theta: np.ndarray
    KD: np.ndarray
    GammaD: np.ndarray


def one_gain(
    gain: float, theta: np.ndarray, KD: np.ndarray, GammaD: np.ndarray
) -> LyapunovParameters:
    """Return the parameters of Eqs. (17) and (24): one gain gamma.

    Parameters
    ----------
    gain : float
        Adaptation gain gamma > 0.
    theta : array_like, shape (2, N)
        True flow parameters, length per time.
    KD, GammaD : array_like, shape (2,)
        Gains of the vehicle controller, per time.

    Returns
    -------
    LyapunovParameters
        Every error weighed by the same gain.

    Examples
    --------
    >>> one_gain(0.5, np.zeros((2, 1)), np.ones(2), np.ones(2)).gain_K
    array([0.5, 0.5])
    """
    theta, KD, GammaD = (np.asarray(a, dtype=float) for a in (theta, KD, GammaD))
    two = np.full(2, gain)
    N = theta.shape[1]
    return LyapunovParameters(N, np.full(theta.shape, gain), two, two, theta, KD, GammaD)


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
    """Make the block that computes V, Eq. (17) or (24).

    Ports: e[2] (length), alpha[2N] (length per time), K[2], Gamma[2] (per
    time) -> V[1].

    Parameters
    ----------
    law : str
        ``"known-flow"`` for Eq. (17), ``"learned-flow"`` for Eq. (24).
    parameters : LyapunovParameters
        The true parameters and the adaptation gains.

    Returns
    -------
    Block
        A static block with feedthrough.

    Raises
    ------
    KeyError
        If the law is unknown.

    Examples
    --------
    >>> p = one_gain(0.5, np.zeros((2, 1)), np.ones(2), np.ones(2))
    >>> block = lyapunov_candidate("learned-flow", p)
    >>> block.output(0, [], [3, 4, 1, 0, 1, 1, 1, 2])
    array([14.5])
    """
    return Block(
        "lyapunov",
        output=LAWS[law],
        inputs={"e": 2, "alpha": 2 * parameters.N, "K": 2, "Gamma": 2},
        outputs={"V": 1},
        parameters=parameters,
    )
