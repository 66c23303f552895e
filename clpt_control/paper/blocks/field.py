"""A gridded current as the true flow, in place of Eq. (3).

    F_R(x, t) = sum_{m, j, i} c_{m j i} B(t - t_m) B(x2 - y_j) B(x1 - x_i) + Delta

B is the cubic B-spline of the grid's step; the coefficients c make the sum interpolate the
grid's values.  The flow is twice continuously differentiable in space and time, as integrators
of high order need, with an error of fourth order in the step up to the edges.  Outside the grid
the flow is that at the nearest edge; the block's guard decides if a run may go on there.

Ports: x[2] (length), delta[2] if disturbed -> flow_x[2] (length per time).
"""

from functools import partial

import numpy as np

from ...engine.model.block import Block
from ...engine.model.declaration import Guard
from ...engine.trace.interpolators import lookup
from .flow import disturbed_flow
from .ports import paper_block

# last words of the guard's message
ADVICE = 'flow.outside = "clip" or "stop" goes on or ends there'
# at a point, four splines of each axis are not zero: offsets of their coefficients
OFFSETS = np.arange(4.0)


def grid_coordinates(t, u, p):
    """Return the position on the grid: steps in time, along x2 and along x1."""
    return (np.stack([t, u[1], u[0]]) - p.start) / p.step


def spline(d):
    """Return the cubic B-spline at distance d in [0, 2] grid steps."""
    return np.where(d < 1, (4 - 6 * d**2 + 3 * d**3) / 6, (2 - d) ** 3 / 6)


def gridded(t, x, u, p):
    """F_R from the grid, in place of Eq. (3), plus Delta of Eq. (32) if disturbed."""
    point = np.clip(grid_coordinates(t, u, p), 0.0, p.shape - 1)
    cell = np.minimum(np.floor(point), p.shape - 2)
    indices = cell[:, None] + OFFSETS
    m, j, i = indices
    b_t, b_2, b_1 = spline(np.abs(point[:, None] - (indices - 1)))
    weight = b_t[:, None, None] * b_2[:, None] * b_1
    row = m[:, None, None] * (p.shape[1] + 2) + j[:, None]
    index = row * (p.shape[2] + 2) + i
    u_1 = np.sum(weight * lookup(p.u, index))
    u_2 = np.sum(weight * lookup(p.v, index))
    return disturbed_flow(np.stack([u_1, u_2]), u)


def inside(t, x, u, p):
    """Grid steps to the edge of the field, negative outside, Eq. (3)."""
    point = grid_coordinates(t, u, p)
    return np.min(np.minimum(point, p.shape - 1 - point))


def spline_coefficients(values: np.ndarray) -> np.ndarray:
    """Return the flat coefficients of the spline through values of shape (nt, n2, n1).

    Along each axis c = f - f''/6 of the interpolating spline f (not-a-knot).
    """
    from scipy.interpolate import CubicSpline

    for _ in range(3):
        steps = np.arange(len(values))
        c = values - CubicSpline(steps, values)(steps, 2) / 6
        before, after = 6 * values[[0, -1]] - 4 * c[[0, -1]] - c[[1, -2]]
        values = np.moveaxis(np.stack([before, *c, after]), 0, -1)
    return values.ravel()


def gridded_flow(
    grid,
    outside: str = "raise",
    disturbed: bool = False,
    units=None,
    position: str = "x",
) -> Block:
    """Make the true flow of a gridded current (`currents.plane.GriddedField`).

    Outside the grid ``"raise"`` fails a run, ``"stop"`` ends it, ``"clip"`` uses the edge's value.
    `units` are named in the message; `position` is the port of the true position.
    """
    axes = grid.time, grid.x2, grid.x1
    length, time = (units.length, units.time) if units is not None else ("", "")
    guard = Guard(inside, outside, partial(left_the_field, length, time), ADVICE)
    return paper_block(
        "true_flow",
        f"{position}{' delta' * disturbed} -> flow_x",
        {
            "shape": [len(axis) for axis in axes],  # grid points in time, x2 and x1
            "start": [axis[0] for axis in axes],  # the first grid point
            "step": [(axis[-1] - axis[0]) / (len(axis) - 1) for axis in axes],
            # spline coefficients of the flow along x1 and x2, length per time, flat with time
            # slowest: (nt + 2) (n2 + 2) (n1 + 2), one outside each edge
            "u": spline_coefficients(grid.u),
            "v": spline_coefficients(grid.v),
        },
        output=gridded,
        opaque=True,
        guard=None if outside == "clip" else guard,
    )


def left_the_field(length, time, t, u, p) -> str:
    """Return the message for a vehicle that left the field: position, time, and the bounds."""
    end = p.start + p.step * (p.shape - 1)
    return (
        f"the vehicle left the field at position ({u[0]:.6g}, {u[1]:.6g}) {length}, "
        f"time {t:.6g} {time}; the field covers x1 {p.start[2]:.6g} to {end[2]:.6g}, "
        f"x2 {p.start[1]:.6g} to {end[1]:.6g} {length}, "
        f"time {p.start[0]:.6g} to {end[0]:.6g} {time}"
    )
