"""The true flow, Eq. (3), and the modelled flow, Eq. (4).

    F_R(x, t) = theta phi(x, t)                   Eq. (3)
    F_R(x, t) = theta phi(x, t) + Delta           Eq. (32)
    F_M(z, t) = alpha_M phi(z, t)                 Eq. (4)

Velocities in length per time.  `blocks.field` has a measured current as the true flow.

Ports: x[2] (length), phi_x[N], delta[2] where disturbed -> flow_x[2]; phi_z[N] -> flow_z[2].
"""

from typing import NamedTuple

import numpy as np

from ..equations.block import Block


class TrueFlowParameters(NamedTuple):
    """The flow parameters that the learner does not know."""

    N: int  # number of basis functions
    theta: np.ndarray  # shape (2, N), length per time


class ModeledFlowParameters(NamedTuple):
    """The flow parameters of the model."""

    N: int  # number of basis functions
    alpha_M: np.ndarray  # shape (2, N), length per time


def true(t, x, u, p, y):
    """F_R = theta phi(x), Eq. (3): u = x[2], phi_x[N], y = flow_x[2] (length per time)."""
    phi = u[2 : 2 + p.N]
    for i in range(2):
        flow = 0.0
        for k in range(p.N):
            flow += p.theta[i, k] * phi[k]
        y[i] = flow


def true_disturbed(t, x, u, p, y):
    """F_R = theta phi(x) + Delta, Eq. (32): u = x[2], phi_x[N], delta[2], y = flow_x[2]."""
    true(t, x, u, p, y)
    for i in range(2):
        y[i] += u[2 + p.N + i]


def modeled(t, x, u, p, y):
    """F_M = alpha_M phi(z), Eq. (4): u = phi_z[N], y = flow_z[2] (length per time)."""
    for i in range(2):
        flow = 0.0
        for k in range(p.N):
            flow += p.alpha_M[i, k] * u[k]
        y[i] = flow


def true_flow(
    parameters: TrueFlowParameters, disturbed: bool = False, position: str = "x"
) -> Block:
    """Make the true flow at a position, Eq. (3), or with the input delta, Eq. (32)."""
    inputs = {position: 2, f"phi_{position}": parameters.N} | ({"delta": 2} if disturbed else {})
    return Block(
        "true_flow",
        output=true_disturbed if disturbed else true,
        inputs=inputs,
        outputs={"flow_x": 2},
        parameters=parameters,
    )


def modeled_flow(parameters: ModeledFlowParameters) -> Block:
    """Make the modelled flow, Eq. (4)."""
    return Block(
        "modeled_flow",
        output=modeled,
        inputs={"phi_z": parameters.N},
        outputs={"flow_z": 2},
        parameters=parameters,
    )
