"""The paper's learned-flow law, Eqs. (21)-(23): alpha, K and Gamma adapt.

    alpha' = -gamma e phi(x)^T                    Eq. (21)
    K'     = -gamma z e                           Eq. (22)
    Gamma' =  gamma zc e                          Eq. (23)

alpha is driven to -theta where the track excites.  V of Eq. (24) has V' = -e^T KD e, so e goes
to zero, Theorem 3.2.  Source: Cho, Zhang, Edwards 2016, section III.

Ports: e[2] (length), phi_x[N], z[2], zc[2] (length) -> alpha[2N] (length per time), K[2],
Gamma[2] (per time), the states.
"""

from typing import Any, NamedTuple

from ...equations.block import Block
from ..lyapunov import lyapunov_candidate, weighed
from .law import Known, Law, Truth, adapt_feedback, adapt_feedforward


class LearnedFlowParameters(NamedTuple):
    """Parameters of the learned-flow law."""

    N: int  # number of basis functions
    # gamma > 0: per time squared in Eq. (21), per length squared per time squared in
    # Eqs. (22)-(23), one number in the paper
    gain: float

    @property
    def gain_K(self):
        """gamma of K."""
        return self.gain

    @property
    def gain_Gamma(self):
        """gamma of Gamma."""
        return self.gain


class LearnedFlowGains(NamedTuple):
    """The same with a gain each, 0 to hold K or Gamma."""

    N: int  # number of basis functions
    gain: float  # gamma of alpha, per time squared
    gain_K: float  # per length squared per time squared
    gain_Gamma: float  # per length squared per time squared


def adapt_axis(i, e, u, p, dx):
    """Fill alpha', K', Gamma' of axis i by Eq. (21), Eq. (22), Eq. (23), driven by e."""
    n = p.N
    phi, z, zc = u[2 : 2 + n], u[2 + n : 4 + n], u[4 + n : 6 + n]
    for k in range(n):
        dx[i * n + k] = -p.gain * e * phi[k]
    dx[2 * n + i] = adapt_feedback(p.gain_K, e, z[i])
    dx[2 * n + 2 + i] = adapt_feedforward(p.gain_Gamma, e, zc[i])


def learned_flow(t, x, u, p, dx):
    """alpha', K', Gamma' of Eq. (21), Eq. (22), Eq. (23).

    u = e[2], phi_x[N], z[2], zc[2]; states alpha[2N], K[2], Gamma[2].
    """
    for i in range(2):
        adapt_axis(i, u[i], u, p, dx)


def learned_flow_law(parameters: LearnedFlowParameters | LearnedFlowGains) -> Block:
    """Make the law of Eqs. (21)-(23), with one gain or one each."""
    N = parameters.N
    return Block(
        "adaptation",
        update=learned_flow,
        inputs={"e": 2, "phi_x": N, "z": 2, "zc": 2},
        states={"alpha": 2 * N, "K": 2, "Gamma": 2},
        parameters=parameters,
    )


def block(known: Known) -> Block:
    """Make the law of what is known."""
    N, gains = known.N, known.gains
    if gains.one:
        return learned_flow_law(LearnedFlowParameters(N, gains.parameters))
    return learned_flow_law(
        LearnedFlowGains(N, gains.parameters, gains.feedback, gains.feedforward)
    )


def V(p: Any, truth: Truth) -> Block:
    """Make V of Eq. (24), each error weighed by its own gain."""
    return lyapunov_candidate("learned-flow", weighed((p.gain, p.gain_K, p.gain_Gamma), *truth))


LAW = Law(
    "learned-flow",
    promise="CLPE goes to zero (Theorem 3.2); alpha to -theta where the track excites",
    needs="nothing but a gain",
    block=block,
    V=V,
)
