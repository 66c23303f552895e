"""The vehicle, Eq. (1), and its controller, Eq. (7).

    dx/dt = F_R(x, t) + v                                   Eq. (1)
    v = -alpha_M phi(x, t) - KD x + GammaD zc               Eq. (7)

x is the true position (length), F_R the true flow and v the through-water
velocity (length per time).  KD and GammaD are diagonal.
"""

from typing import NamedTuple

import numpy as np

from .block import Block


class ControllerParameters(NamedTuple):
    """Gains and flow model of the vehicle controller, Eq. (7).

    Attributes
    ----------
    N : int
        Number of basis functions.
    alpha_M : ndarray, shape (2, N)
        Parameters of the modelled flow, length per time.
    KD : ndarray, shape (2,)
        Feedback gains, diagonal, per time.
    GammaD : ndarray, shape (2,)
        Feedforward gains, diagonal, per time.
    """

    N: int
    alpha_M: np.ndarray
    KD: np.ndarray
    GammaD: np.ndarray


def kinematics(t, x, u, p, dx):
    """X' = F_R + v, Eq. (1): u = flow_x[2], v_x[2] (length per time), state x[2]."""
    for i in range(2):
        dx[i] = u[i] + u[2 + i]


def controller(t, x, u, p, y):
    """V = -alpha_M phi(x) - KD x + GammaD zc, Eq. (7): u = x[2], zc[2], phi_x[N], y = v_x[2]."""
    position, zc, phi = u[0:2], u[2:4], u[4 : 4 + p.N]
    for i in range(2):
        cancelled = 0.0
        for k in range(p.N):
            cancelled += p.alpha_M[i, k] * phi[k]
        y[i] = -cancelled - p.KD[i] * position[i] + p.GammaD[i] * zc[i]


def vehicle() -> Block:
    """Make the vehicle block, Eq. (1).

    Ports: flow_x[2], v_x[2] (length per time) -> x[2] (length), the state.

    Returns
    -------
    Block
        Two states, no feedthrough.

    Examples
    --------
    >>> vehicle().dynamics(0, [0, 0], [1, 0, 0, 2])
    array([1., 2.])
    """
    return Block("vehicle", update=kinematics, inputs={"flow_x": 2, "v_x": 2}, states={"x": 2})


def vehicle_controller(parameters: ControllerParameters) -> Block:
    """Make the vehicle controller, Eq. (7).

    Ports: x[2], zc[2] (length), phi_x[N] -> v_x[2] (length per time).

    Parameters
    ----------
    parameters : ControllerParameters
        Flow model alpha_M and the gains KD, GammaD.

    Returns
    -------
    Block
        A static block with feedthrough.

    Examples
    --------
    >>> p = ControllerParameters(1, np.zeros((2, 1)), np.ones(2), np.ones(2))
    >>> vehicle_controller(p).output(0, [], [1, 2, 4, 4, 0.5])
    array([3., 2.])
    """
    return Block(
        "vehicle_controller",
        output=controller,
        inputs={"x": 2, "zc": 2, "phi_x": parameters.N},
        outputs={"v_x": 2},
        parameters=parameters,
    )
