"""The vehicle, Eq. (1), and its controller, Eq. (7).

    dx/dt = F_R(x, t) + v                                   Eq. (1)
    v = -alpha_M phi(x, t) - KD x + GammaD zc               Eq. (7)

x is the true position (length), F_R the true flow and v the through-water
velocity (length per time).  KD and GammaD are diagonal.  Where the speed is limited, Eq. (7) gives
v_c, and `speed_limit` makes v of it.

Ports: flow_x[2], v_x[2] (length per time) -> x[2] (length), a state, or x_true[2] where the
vehicle does not read it as it is (`localization`);
x[2] or z[2], zc[2] (length), phi_x[N] or phi_z[N] -> v_x[2], or v_c[2] where the speed is limited.
"""

from typing import NamedTuple

import numpy as np

from ..equations.block import Block


class ControllerParameters(NamedTuple):
    """Gains and flow model of the vehicle controller, Eq. (7)."""

    N: int  # number of basis functions
    alpha_M: np.ndarray  # shape (2, N), length per time
    KD: np.ndarray  # shape (2,), feedback gains, per time
    GammaD: np.ndarray  # shape (2,), feedforward gains, per time


def kinematics(t, x, u, p, dx):
    """x' = F_R + v, Eq. (1): u = flow_x[2], v_x[2] (length per time), state x[2]."""
    for i in range(2):
        dx[i] = u[i] + u[2 + i]


def controller(t, x, u, p, y):
    """v = -alpha_M phi(x) - KD x + GammaD zc, Eq. (7).

    u = x[2], zc[2], phi_x[N], or z[2], zc[2], phi_z[N] between fixes; y = v_x[2], or v_c[2] where
    the speed is limited.
    """
    position, zc, phi = u[0:2], u[2:4], u[4 : 4 + p.N]
    for i in range(2):
        cancelled = 0.0
        for k in range(p.N):
            cancelled += p.alpha_M[i, k] * phi[k]
        y[i] = -cancelled - p.KD[i] * position[i] + p.GammaD[i] * zc[i]


def true_position(t, x, u, p, y):
    """y = x, the state of Eq. (1): y = x_true[2] (length)."""
    for i in range(2):
        y[i] = x[i]


def vehicle(position: str = "x") -> Block:
    """Make the vehicle, Eq. (1); its position is the port ``"x"`` or ``"x_true"``."""
    inputs, states = {"flow_x": 2, "v_x": 2}, {"x": 2}
    if position == "x":
        return Block("vehicle", update=kinematics, inputs=inputs, states=states)
    return Block(
        "vehicle",
        update=kinematics,
        output=true_position,
        inputs=inputs,
        outputs={position: 2},
        states=states,
        feedthrough=False,
    )


def vehicle_controller(
    parameters: ControllerParameters, limited: bool = False, position: str = "x"
) -> Block:
    """Make the vehicle controller, Eq. (7); its velocity is v_c where the speed is limited.

    It steers on the port `position`: ``"x"``, or ``"z"`` between fixes.
    """
    return Block(
        "vehicle_controller",
        output=controller,
        inputs={position: 2, "zc": 2, f"phi_{position}": parameters.N},
        outputs={"v_c" if limited else "v_x": 2},
        parameters=parameters,
    )
