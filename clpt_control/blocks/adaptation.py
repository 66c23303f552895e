"""The adaptive laws, Eqs. (14)-(15) and (21)-(23).

    alpha' = -gamma e phi(x)^T                    Eq. (21)
    K'     = -gamma z e                           Eq. (14), Eq. (22)
    Gamma' =  gamma zc e                          Eq. (15), Eq. (23)

The known-flow law keeps alpha = alpha_M and adapts the gains alone; the
learned-flow law adapts all three and drives alpha to -theta.  z and zc are
diagonal matrices in the paper, so each axis i has its own e_i, z_i, zc_i.

Ports: e[2] (length), phi_x[N], z[2], zc[2] (length) -> alpha[2N] (length per
time), K[2], Gamma[2] (per time), the states; in the known-flow law alpha is a constant output.
"""

from typing import NamedTuple

import numpy as np

from .block import Block


class KnownFlowParameters(NamedTuple):
    """Parameters of the known-flow law."""

    N: int  # number of basis functions
    gain: float  # gamma > 0, per length squared per time squared
    alpha_M: np.ndarray  # shape (2, N), what alpha stays at, length per time


class LearnedFlowParameters(NamedTuple):
    """Parameters of the learned-flow law."""

    N: int  # number of basis functions
    # gamma > 0: per time squared in Eq. (21), per length squared per time squared in
    # Eqs. (22)-(23), one number in the paper
    gain: float


def adapt_feedback(gamma, e, z):
    """Return K_i' = -gamma z_i e_i, Eq. (14) and Eq. (22)."""
    return -gamma * z * e


def adapt_feedforward(gamma, e, zc):
    """Return Gamma_i' = gamma zc_i e_i, Eq. (15) and Eq. (23)."""
    return gamma * zc * e


def known_flow(t, x, u, p, dx):
    """K' and Gamma' of Eq. (14)-(15): u = e[2], phi_x[N], z[2], zc[2]; states K[2], Gamma[2]."""
    e, z, zc = u[0:2], u[2 + p.N : 4 + p.N], u[4 + p.N : 6 + p.N]
    for i in range(2):
        dx[i] = adapt_feedback(p.gain, e[i], z[i])
        dx[2 + i] = adapt_feedforward(p.gain, e[i], zc[i])


def known_flow_output(t, x, u, p, y):
    """alpha = alpha_M and the states K, Gamma, Eqs. (14)-(15): y = alpha[2N], K[2], Gamma[2]."""
    n = p.N
    for i in range(2):
        for k in range(n):
            y[i * n + k] = p.alpha_M[i, k]
    for i in range(4):
        y[2 * n + i] = x[i]


def learned_flow(t, x, u, p, dx):
    """alpha', K', Gamma' of Eq. (21), Eq. (22), Eq. (23).

    u = e[2], phi_x[N], z[2], zc[2]; states alpha[2N], K[2], Gamma[2].
    """
    n = p.N
    e, phi, z, zc = u[0:2], u[2 : 2 + n], u[2 + n : 4 + n], u[4 + n : 6 + n]
    for i in range(2):
        for k in range(n):
            dx[i * n + k] = -p.gain * e[i] * phi[k]
        dx[2 * n + i] = adapt_feedback(p.gain, e[i], z[i])
        dx[2 * n + 2 + i] = adapt_feedforward(p.gain, e[i], zc[i])


def adaptation(parameters: KnownFlowParameters | LearnedFlowParameters) -> Block:
    """Make the adaptive law, Eqs. (14)-(15) or (21)-(23), by the class of its parameters."""
    N = parameters.N
    inputs = {"e": 2, "phi_x": N, "z": 2, "zc": 2}
    everything = {"alpha": 2 * N, "K": 2, "Gamma": 2}
    if isinstance(parameters, LearnedFlowParameters):
        return Block(
            "adaptation",
            update=learned_flow,
            inputs=inputs,
            states=everything,
            parameters=parameters,
        )
    return Block(
        "adaptation",
        update=known_flow,
        output=known_flow_output,
        inputs=inputs,
        outputs=everything,
        states={"K": 2, "Gamma": 2},
        feedthrough=False,
        parameters=parameters,
    )
