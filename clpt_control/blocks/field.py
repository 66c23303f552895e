"""A gridded current as the true flow, in place of Eq. (3).

    F_R(x, t) = sum_{m, j, i} c_{m j i} B(t - t_m) B(x2 - y_j) B(x1 - x_i) + Delta

B is the cubic B-spline of the grid's step, c the coefficients that make the
sum go through the grid's values: twice continuously differentiable in space
and time, as an integrator of high order needs it.  Outside the grid the value
at its edge is held; the block's guard says what a run does there.
"""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from .block import Block
from .ports import Guard
from .words import clip, floor, lookup, minimum, where


class FieldParameters(NamedTuple):
    """Spline coefficients of a gridded current.

    Attributes
    ----------
    shape : ndarray, shape (3,)
        Grid points in time, x2 and x1.
    start, step : ndarray, shape (3,)
        First grid point and spacing in time, x2 and x1.
    u, v : ndarray, shape ((nt + 2) * (n2 + 2) * (n1 + 2),)
        Coefficients of the flow along x1 and x2, length per time, with one
        more on each side, time slowest.
    """

    shape: np.ndarray
    start: np.ndarray
    step: np.ndarray
    u: np.ndarray
    v: np.ndarray


def coordinate(value, p, axis):
    """Position in grid steps along an axis, held at the edges."""
    return clip((value - p.start[axis]) / p.step[axis], 0.0, p.shape[axis] - 1)


def cell(position, p, axis):
    """Index of the grid cell that holds a position in grid steps."""
    return minimum(floor(position), p.shape[axis] - 2)


def spline(d):
    """Cubic B-spline at distance d in [0, 2] grid steps."""
    return where(d < 1, (4 - 6 * d**2 + 3 * d**3) / 6, (2 - d) ** 3 / 6)


def weight(position, first, k):
    """Weight of the k-th of four coefficients, k = 0 ... 3."""
    d = position - (first + k - 1)
    return spline(where(d > 0, d, -d))


def gridded(t, x, u, p, y):
    """F_R from the grid, in place of Eq. (3): u = x[2] (length), y = flow_x[2] (length/time)."""
    at, a2, a1 = coordinate(t, p, 0), coordinate(u[1], p, 1), coordinate(u[0], p, 2)
    m, j, i = cell(at, p, 0), cell(a2, p, 1), cell(a1, p, 2)
    flow_1, flow_2 = 0, 0
    for km in range(4):
        wt = weight(at, m, km)
        for kj in range(4):
            w = wt * weight(a2, j, kj)
            row = ((m + km) * (p.shape[1] + 2) + j + kj) * (p.shape[2] + 2) + i
            for ki in range(4):
                c = w * weight(a1, i, ki)
                flow_1 += c * lookup(p.u, row + ki)
                flow_2 += c * lookup(p.v, row + ki)
    y[0], y[1] = flow_1, flow_2


def gridded_disturbed(t, x, u, p, y):
    """F_R from the grid plus Delta, Eq. (32): u = x[2], delta[2], y = flow_x[2]."""
    gridded(t, x, u, p, y)
    for i in range(2):
        y[i] += u[2 + i]


def steps_inside(value, p, axis):
    """Grid steps from a coordinate to the nearer edge of its axis."""
    here = (value - p.start[axis]) / p.step[axis]
    return minimum(here, p.shape[axis] - 1 - here)


def inside(t, x, u, p, y):
    """Grid steps to the edge of the field, negative outside, beside Eq. (3): u = x[2] (length)."""
    y[0] = minimum(
        steps_inside(t, p, 0), minimum(steps_inside(u[1], p, 1), steps_inside(u[0], p, 2))
    )


def spline_coefficients(values: np.ndarray) -> np.ndarray:
    """Return the spline coefficients that meet the grid values.

    Parameters
    ----------
    values : ndarray, shape (nt, n2, n1)
        Finite values on the grid.

    Returns
    -------
    ndarray, shape ((nt + 2) * (n2 + 2) * (n1 + 2),)
        With one mirrored coefficient on each side, flattened.

    Examples
    --------
    >>> spline_coefficients(np.ones((2, 3, 4))).shape
    (120,)
    """
    from scipy.ndimage import spline_filter

    coefficients = spline_filter(values, order=3, mode="mirror")
    return np.pad(coefficients, 1, mode="reflect").ravel()


def gridded_flow(grid, outside: str = "raise", disturbed: bool = False, units=None) -> Block:
    """Make the true flow of a gridded current.

    Ports: x[2] (length), and delta[2] where disturbed -> flow_x[2] (length per
    time).

    Parameters
    ----------
    grid : clpt_control.currents.gridded.GriddedField
        The current on a regular grid, in the units of the diagram.
    outside : str, optional
        ``"raise"``, ``"clip"`` or ``"stop"``.
    disturbed : bool, optional
        Whether the block has the input delta.
    units : Units, optional
        Names of the units, for messages.

    Returns
    -------
    Block
        An opaque static block with feedthrough, guarded unless clipped.

    Examples
    --------
    >>> from clpt_control.currents.gridded import GriddedField
    >>> axis = np.arange(4.0)
    >>> grid = GriddedField(axis, axis, axis, np.ones((4, 4, 4)), np.zeros((4, 4, 4)))
    >>> gridded_flow(grid).output(1.3, [], [2.2, 0.4]).round(12)
    array([1., 0.])
    """
    axes = (grid.time, grid.x2, grid.x1)
    parameters = FieldParameters(
        np.array([len(axis) for axis in axes], dtype=float),
        np.array([axis[0] for axis in axes]),
        np.array([(axis[-1] - axis[0]) / (len(axis) - 1) for axis in axes]),
        spline_coefficients(grid.u),
        spline_coefficients(grid.v),
    )
    length, time = (units.length, units.time) if units is not None else ("", "")

    return Block(
        "true_flow",
        output=gridded_disturbed if disturbed else gridded,
        inputs={"x": 2} | ({"delta": 2} if disturbed else {}),
        outputs={"flow_x": 2},
        parameters=parameters,
        opaque=True,
        guard=None if outside == "clip" else Guard(inside, outside, Leaving(length, time)),
    )


@dataclass(frozen=True)
class Leaving:
    """Say where and when a vehicle left the field.

    Attributes
    ----------
    length, time : str
        Names of the units.
    """

    length: str
    time: str

    def __call__(self, t, u, p) -> str:
        """Return the sentence: position, time and the field's bounds."""
        end = p.start + p.step * (p.shape - 1)
        return (
            f"the vehicle left the field at position ({u[0]:.6g}, {u[1]:.6g}) {self.length}, "
            f"time {t:.6g} {self.time}; the field covers x1 {p.start[2]:.6g} to {end[2]:.6g}, "
            f"x2 {p.start[1]:.6g} to {end[1]:.6g} {self.length}, "
            f"time {p.start[0]:.6g} to {end[0]:.6g} {self.time}"
        )
