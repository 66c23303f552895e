"""The known-flow law, Eqs. (14)-(15): K and Gamma adapt, the flow is known by other means.

    alpha  = alpha_M
    K'     = -gamma z e                           Eq. (14)
    Gamma' =  gamma zc e                          Eq. (15)

theta_hat, the estimate of theta, is given to the injection, Eq. (13).  V of Eq. (17) then has
V' = -e^T KD e + e^T (theta - theta_hat) phi, Theorem 3.1: in the mean square |e| is at most
|(theta - theta_hat) phi| over the least of KD, and goes to zero where theta_hat is theta.
Source: Cho, Zhang, Edwards 2016, section III.

Ports: e[2] (length), phi_x[N], z[2], zc[2] (length) -> K[2], Gamma[2] (per time), the states,
and alpha[2N] (length per time), constant.
"""

from typing import Any, NamedTuple

import numpy as np

from ...equations.block import Block
from ..lyapunov import lyapunov_candidate, weighed
from .law import Known, Law, Truth, adapt_feedback, adapt_feedforward


class KnownFlowParameters(NamedTuple):
    """Parameters of the known-flow law."""

    N: int  # number of basis functions
    gain: float  # gamma > 0, per length squared per time squared
    alpha_M: np.ndarray  # shape (2, N), what alpha stays at, length per time

    @property
    def gain_K(self):
        """gamma of K."""
        return self.gain

    @property
    def gain_Gamma(self):
        """gamma of Gamma."""
        return self.gain


class KnownFlowGains(NamedTuple):
    """The same with a gain each, 0 to hold; per length squared per time squared."""

    N: int  # number of basis functions
    gain_K: float
    gain_Gamma: float
    alpha_M: np.ndarray  # shape (2, N), length per time


def known_flow(t, x, u, p, dx):
    """K' and Gamma' of Eq. (14)-(15): u = e[2], phi_x[N], z[2], zc[2]; states K[2], Gamma[2]."""
    e, z, zc = u[0:2], u[2 + p.N : 4 + p.N], u[4 + p.N : 6 + p.N]
    for i in range(2):
        dx[i] = adapt_feedback(p.gain_K, e[i], z[i])
        dx[2 + i] = adapt_feedforward(p.gain_Gamma, e[i], zc[i])


def known_flow_output(t, x, u, p, y):
    """alpha = alpha_M and the states K, Gamma, Eqs. (14)-(15): y = alpha[2N], K[2], Gamma[2]."""
    n = p.N
    for i in range(2):
        for k in range(n):
            y[i * n + k] = p.alpha_M[i, k]
    for i in range(4):
        y[2 * n + i] = x[i]


def known_flow_law(parameters: KnownFlowParameters | KnownFlowGains) -> Block:
    """Make the law of Eqs. (14)-(15), with one gain or one each."""
    N = parameters.N
    return Block(
        "adaptation",
        update=known_flow,
        output=known_flow_output,
        inputs={"e": 2, "phi_x": N, "z": 2, "zc": 2},
        outputs={"alpha": 2 * N, "K": 2, "Gamma": 2},
        states={"K": 2, "Gamma": 2},
        feedthrough=False,
        parameters=parameters,
    )


def block(known: Known) -> Block:
    """Make the law of what is known."""
    N, gains, alpha_M = known.N, known.gains, known.alpha_M
    if gains.one:
        return known_flow_law(KnownFlowParameters(N, gains.feedback, alpha_M))
    return known_flow_law(KnownFlowGains(N, gains.feedback, gains.feedforward, alpha_M))


def V(p: Any, truth: Truth) -> Block:
    """Make V of Eq. (17)."""
    return lyapunov_candidate("known-flow", weighed((1.0, p.gain_K, p.gain_Gamma), *truth))


LAW = Law(
    "known-flow",
    promise="in the mean, CLPE at most the error of the given flow over the least of KD "
    "(Theorem 3.1)",
    needs="an estimate of theta, learning.theta_estimate",
    block=block,
    V=V,
    alpha_by_gain=False,
    given_estimate=True,
)
