"""Vehicles with mass: a point, and surge, sway and yaw, with thrusters and a current.

    point       m v' = F - d v - q |v| v,   x' = v + c
    planar      M nu' + C(nu) nu + D nu + Q |nu| nu = tau
                eta' = R(psi) nu + (c, 0),  nu = (u, v, r), eta = (x, y, psi)
                C(nu) nu = (-(m22 v + m23 r) r,  m11 u r,  (m22 v + m23 r) u - m11 u v)
    thrusters   T f' = min(max(f_c, low), high) - f,   tau = sum_k f_k (cos a_k, sin a_k,
                                                                  x_k sin a_k - y_k cos a_k)

M holds the added mass, m12 = m13 = 0 as for a body that is alike to port and starboard.  v and nu
are through the water, c is the flow, a velocity in the plane, steady and without shear.

Ports: force[n], flow[n] -> x[n], v[n]; tau[3] (N, N, N m), flow[2] -> eta[3] (m, m, rad), nu[3];
thrust[k] (N) -> tau[3].  Units are the user's, such as kg, m, s.
Source: Fossen 2011, Handbook of Marine Craft Hydrodynamics and Motion Control, sections 7.1 (in the
plane), 8.3 (current) and 12.3 (thrusters).
"""

from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ..base.arguments import Count, brief, finite, numbers, public
from ..base.errors import BlockError
from ..engine.model.block import Block
from .common import checked_sizes, make_block, ordered, positive


def point_rates(t, x, u, p):
    """m v' = F - d v - q |v| v, x' = v + c (Fossen 2011, section 7.1, one axis each)."""
    drag = p.damping * x.v + p.quadratic * np.abs(x.v) * x.v
    return {"x": x.v + u.flow, "v": (u.force - drag) / p.mass}


@public
def point_vehicle(
    mass: ArrayLike,
    damping: ArrayLike,
    quadratic: ArrayLike = 0.0,
    axes: Count = 2,
    name: str = "point_vehicle",
    **ports: str,
) -> Block:
    """Make a vehicle of second order, a point with mass and drag.

    Parameters
    ----------
    mass : float or array_like
        Mass, with what water it carries; one for all axes, or one for each.
    damping, quadratic : float or array_like
        The drag d by speed, and q by its square, on each axis.
    axes : int, optional
        Number of axes.
    name : str, optional
        Name of the block.
    **ports : str
        A port under another name, ``flow="flow_x"``.

    Returns
    -------
    Block
        With ports force and flow, and x and v.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> glider = clpt.parts.point_vehicle(mass=60, damping=30)
    >>> clpt.simulate(glider, [0, 60], [15, 0, 0.1, 0]).v[-1].values.round(3).tolist()
    [0.5, 0.0]
    """
    values = checked_sizes(name, axes, mass=mass, damping=damping, quadratic=quadratic)
    rules = positive("mass"), positive("damping", "quadratic", or_zero=True)
    inputs, states = (
        dict.fromkeys(keys, axes) for keys in (("force", "flow"), ("x", "v"))
    )
    return make_block(
        name, ports, values, rules, update=point_rates, inputs=inputs, states=states
    )


def planar_rates(t, x, u, p):
    """M nu' + C(nu) nu + D nu + Q |nu| nu = tau, eta' = R nu + c (Fossen 2011, section 7.1)."""
    surge, sway, yaw = x.nu
    m11, m22, m23, m33 = p.M[0, 0], p.M[1, 1], p.M[1, 2], p.M[2, 2]
    ahead, aside = m11 * surge, m22 * sway + m23 * yaw  # momentum
    X, Y, N = u.tau - p.D @ x.nu - p.Q @ (np.abs(x.nu) * x.nu)
    X, Y, N = X + aside * yaw, Y - ahead * yaw, N - aside * surge + ahead * sway
    determinant = m22 * m33 - m23**2
    sway_rate = (m33 * Y - m23 * N) / determinant
    yaw_rate = (m22 * N - m23 * Y) / determinant
    c, s = np.cos(x.eta[2]), np.sin(x.eta[2])
    over_ground = [
        c * surge - s * sway + u.flow[0],
        s * surge + c * sway + u.flow[1],
        yaw,
    ]
    return {"eta": over_ground, "nu": [X / m11, sway_rate, yaw_rate]}


def check_masses(name, matrices):
    """Refuse matrices that cannot be those of a vehicle."""
    for key, value in matrices.items():
        if np.shape(value) != (3, 3):
            raise BlockError(
                f"{name}: {key} = {brief(value)}: must have the shape (3, 3)"
            )
    M = np.asarray(matrices["M"], dtype=float)
    if (
        not np.allclose(M, M.T, atol=0)
        or np.any(M[0, 1:])
        or np.min(np.linalg.eigvalsh(M)) <= 0
    ):
        raise BlockError(
            f"{name}: M = {brief(M)}: must be symmetric and positive definite, with m12 = m13 = 0"
        )


@public
def planar_vehicle(
    M: ArrayLike,
    D: ArrayLike,
    Q: Any = None,
    name: str = "planar_vehicle",
    **ports: str,
) -> Block:
    """Make a vehicle of surge, sway and yaw, as Fossen writes it.

    Parameters
    ----------
    M : array_like, shape (3, 3)
        Mass and added mass; symmetric, positive definite, m12 = m13 = 0.
    D : array_like, shape (3, 3)
        Linear damping.
    Q : array_like, shape (3, 3), optional
        Damping by the square, of ``|nu| nu``; 0 by default.
    name : str, optional
        Name of the block.
    **ports : str
        A port under another name.

    Returns
    -------
    Block
        With ports tau and flow, and eta (x, y, psi) and nu (surge, sway, yaw rate).

    Raises
    ------
    BlockError
        If M cannot be that of a vehicle.

    Examples
    --------
    >>> import numpy as np
    >>> import clpt_control as clpt
    >>> auv = clpt.parts.planar_vehicle(M=np.diag([60, 90, 20]), D=np.diag([30, 60, 20]))
    >>> clpt.simulate(auv, [0, 60], [15, 0, 2, 0, 0]).nu[-1].values.round(3).tolist()
    [0.469, -0.07, 0.149]
    """
    given = {"M": M, "D": D, "Q": np.zeros((3, 3)) if Q is None else Q}
    return make_block(
        name,
        ports,
        given,
        [check_masses],
        update=planar_rates,
        inputs={"tau": 3, "flow": 2},
        states={"eta": 3, "nu": 3},
    )


def thruster_lag(t, x, u, p):
    """T f' = min(max(f_c, low), high) - f (Fossen 2011, section 12.3)."""
    return (np.clip(u.thrust, p.low, p.high) - x.f) / p.lag


def allocated(t, x, u, p):
    """tau = B f (Fossen 2011, section 12.3)."""
    return p.B @ x.f


@public
def thrusters(
    places: ArrayLike,
    angles: ArrayLike,
    low: ArrayLike,
    high: ArrayLike,
    lag: ArrayLike,
    name: str = "thrusters",
    **ports: str,
) -> Block:
    """Make thrusters with limits and a lag, for a planar vehicle.

    Parameters
    ----------
    places : array_like, shape (k, 2)
        Where each is: forward and to starboard of the center of the vehicle.
    angles : array_like, shape (k,)
        Where each pushes to: radians from forward to starboard.
    low, high : float or array_like
        Limits of the thrust.
    lag : float or array_like
        The time in which thrust follows.
    name : str, optional
        Name of the block.
    **ports : str
        A port under another name.

    Returns
    -------
    Block
        With ports thrust and tau.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> pair = clpt.parts.thrusters([(-0.8, -0.2), (-0.8, 0.2)], [0, 0], -10, 20, lag=0.3)
    >>> clpt.simulate(pair, [0, 9], [50, 10]).tau[-1].values.round(6).tolist()
    [30.0, 0.0, 2.0]
    """
    points = finite(f"{name}: places", numbers(f"{name}: places", places, None, 2))
    a = finite(f"{name}: angles", angles)
    if a.ndim != 1 or points.shape != (a.size, 2) or not a.size:
        raise BlockError(
            f"{name}: places = {brief(places)}, angles = {brief(angles)}: must be a list of "
            "pairs, and an angle for each"
        )
    if np.any(np.abs(a) > 2 * np.pi):
        raise BlockError(
            f"{name}: angles = {brief(angles)}: is in radians, within a turn. Give "
            "np.radians(angles)"
        )
    values = checked_sizes(name, a.size, low=low, high=high, lag=lag)
    forward, starboard = points.T
    B = np.array([np.cos(a), np.sin(a), forward * np.sin(a) - starboard * np.cos(a)])
    return make_block(
        name,
        ports,
        {"B": B, **values},
        [positive("lag"), ordered("low", "high")],
        update=thruster_lag,
        output=allocated,
        inputs={"thrust": a.size},
        outputs={"tau": 3},
        states={"f": a.size},
    )
