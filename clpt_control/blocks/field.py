"""A gridded current as the true flow, in place of Eq. (3).

    F_R(x, t) = sum_{m, j, i} c_{m j i} B(t - t_m) B(x2 - y_j) B(x1 - x_i) + Delta

B is the cubic B-spline of the grid's step, c the coefficients that make the
sum go through the grid's values: twice continuously differentiable in space
and time, as an integrator of high order needs it.  Outside the grid the value
at its edge is held; the block's guard says what a run does there.

Ports: x[2] (length), delta[2] where disturbed -> flow_x[2] (length per time).
"""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from ..equations.block import Block
from ..equations.declaration import Guard
from .words import clip, floor, lookup, minimum, where

ADVICE = 'flow.outside = "clip" or "stop" goes on or ends there'  # what a scenario may say


class FieldParameters(NamedTuple):
    """Spline coefficients of a gridded current."""

    shape: np.ndarray  # numbers of grid points nt, n2, n1: in time, x2 and x1
    start: np.ndarray  # first grid point in time, x2 and x1
    step: np.ndarray  # spacing in time, x2 and x1
    u: np.ndarray  # coefficients of the flow along x1, length per time, flat with time slowest:
    v: np.ndarray  # along x2; (nt + 2) * (n2 + 2) * (n1 + 2), one more on each side


def coordinate(value, p, axis):
    """Return a position in grid steps along an axis, held at the edges."""
    return clip((value - p.start[axis]) / p.step[axis], 0.0, p.shape[axis] - 1)


def cell(position, p, axis):
    """Return the index of the grid cell that holds a position in grid steps."""
    return minimum(floor(position), p.shape[axis] - 2)


def spline(d):
    """Return the cubic B-spline at distance d in [0, 2] grid steps."""
    return where(d < 1, (4 - 6 * d**2 + 3 * d**3) / 6, (2 - d) ** 3 / 6)


def weight(position, first, k):
    """Return the weight of the k-th of four coefficients, k = 0 ... 3."""
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
    """Return the grid steps from a coordinate to the nearer edge of its axis."""
    here = (value - p.start[axis]) / p.step[axis]
    return minimum(here, p.shape[axis] - 1 - here)


def inside(t, x, u, p, y):
    """Grid steps to the edge of the field, negative outside, Eq. (3): u = x[2] (length)."""
    y[0] = minimum(
        steps_inside(t, p, 0), minimum(steps_inside(u[1], p, 1), steps_inside(u[0], p, 2))
    )


def spline_coefficients(values: np.ndarray) -> np.ndarray:
    """Return the flat coefficients whose spline meets values of shape (nt, n2, n1)."""
    from scipy.ndimage import spline_filter

    coefficients = spline_filter(values, order=3, mode="mirror")
    return np.pad(coefficients, 1, mode="reflect").ravel()


def gridded_flow(
    grid, outside: str = "raise", disturbed: bool = False, units=None, position: str = "x"
) -> Block:
    """Make the true flow of a gridded current (`currents.field_file.GriddedField`).

    Outside of it ``"raise"`` fails a run, ``"stop"`` ends it, ``"clip"`` holds the edge's value.
    `units` are named in the message; `position` is the port of the true position.
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
    guard = Guard(inside, outside, LeftTheField(length, time), ADVICE)
    return Block(
        "true_flow",
        output=gridded_disturbed if disturbed else gridded,
        inputs={position: 2} | ({"delta": 2} if disturbed else {}),
        outputs={"flow_x": 2},
        parameters=parameters,
        opaque=True,
        guard=None if outside == "clip" else guard,
    )


@dataclass(frozen=True)
class LeftTheField:
    """Write where and when a vehicle left the field; length and time are names of units."""

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
