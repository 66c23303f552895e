"""A passive particle in a gridded current, as a block: what a user would write.

    dx/dt = F_R(x, t), linear between the grid points in time, x2 and x1

Outside the grid the value at its edge is held.
"""

from typing import NamedTuple

import numpy as np

import clpt_control as clpt
from clpt_control import Block
from clpt_control.blocks.words import clip, floor, lookup, minimum

from .engines import timed


class LinearCurrent(NamedTuple):
    """A current on a regular grid of time, x2 and x1."""

    shape: np.ndarray  # grid points, shape (3,)
    start: np.ndarray  # first grid point
    scale: np.ndarray  # 1 / spacing
    u: np.ndarray  # flow along x1 and x2, flattened, time slowest
    v: np.ndarray


def place(value, p, axis):
    """Return a position in grid steps along an axis, held at the edges."""
    return clip((value - p.start[axis]) * p.scale[axis], 0.0, p.shape[axis] - 1)


def mix(a, b, share):
    """Go from a to b by a share of the way."""
    return a + share * (b - a)


def plane(f, at, row, s2, s1):
    """Return the bilinear value at one time of the grid."""
    low = mix(lookup(f, at), lookup(f, at + 1), s1)
    return mix(low, mix(lookup(f, at + row), lookup(f, at + row + 1), s1), s2)


def drift(t, x, u, p, dx):
    """X' = F_R(x, t), Eq. (3) from a grid; state x[2]."""
    at, a2, a1 = place(t, p, 0), place(x[1], p, 1), place(x[0], p, 2)
    m, j = minimum(floor(at), p.shape[0] - 2), minimum(floor(a2), p.shape[1] - 2)
    i = minimum(floor(a1), p.shape[2] - 2)
    row = p.shape[2]
    sheet = p.shape[1] * row
    corner = m * sheet + j * row + i
    st, s2, s1 = at - m, a2 - j, a1 - i
    dx[0] = mix(plane(p.u, corner, row, s2, s1), plane(p.u, corner + sheet, row, s2, s1), st)
    dx[1] = mix(plane(p.v, corner, row, s2, s1), plane(p.v, corner + sheet, row, s2, s1), st)


def drifter(time: np.ndarray, axis: np.ndarray, u: np.ndarray, v: np.ndarray) -> Block:
    """Return the block of one particle in a current (time, x2, x1): no inputs -> x[2]."""
    axes = (time, axis, axis)
    parameters = LinearCurrent(
        np.array([len(a) for a in axes], dtype=float),
        np.array([a[0] for a in axes]),
        np.array([1 / (a[1] - a[0]) for a in axes]),
        u.ravel(),
        v.ravel(),
    )
    return Block("drifter", update=drift, states={"x": 2}, parameters=parameters, opaque=True)


def advect(time, axis, u, v, x1, x2, step: float, steps: int) -> tuple[np.ndarray, float]:
    """Move passive particles by RK4; return final positions (2, n) and seconds."""
    native = clpt.native.compile(clpt.connect([drifter(time, axis, u, v)], name="drifter"))
    starts = np.column_stack([x1, x2])
    ends = np.array([0.0, step * steps])
    native.run_many(starts[:2], ends, step=step)
    found, seconds = timed(lambda: native.run_many(starts, ends, step=step))
    return found[:, -1].T, seconds
