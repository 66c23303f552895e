"""A passive particle in a gridded current, as a block: what a user would write.

    dx/dt = F_R(x, t), linear between the grid points in time, x2 and x1

Outside the grid the value at its edge is held.
"""

import numpy as np

import clpt_control as clpt
from clpt_control import Block, lookup
from clpt_control.engine.solver.batch import Batch
from clpt_control.engine.solver.native_diagram import compile
from clpt_control.engine.solver.runner import RunOptions

from .engines import timed
from .rk4 import RK4


def place(t, x, p):
    """Return a place in grid steps of time, x2 and x1, held at the edges."""
    return np.clip((np.stack([t, x[1], x[0]]) - p.start) * p.scale, 0.0, p.shape - 1)


def mix(a, b, share):
    """Go from a to b by a share of the way."""
    return a + share * (b - a)


def plane(f, at, row, s2, s1):
    """Return the bilinear value at one time of the grid."""
    low = mix(lookup(f, at), lookup(f, at + 1), s1)
    return mix(low, mix(lookup(f, at + row), lookup(f, at + row + 1), s1), s2)


def drift(t, x, u, p):
    """X' = F_R(x, t), Eq. (3) from a grid."""
    here = place(t, x, p)
    cell = np.minimum(np.floor(here), p.shape - 2)
    st, s2, s1 = here - cell
    row = p.shape[2]
    sheet = p.shape[1] * row
    corner = cell[0] * sheet + cell[1] * row + cell[2]
    planes = [
        [plane(f, at, row, s2, s1) for at in (corner, corner + sheet)]
        for f in (p.u, p.v)
    ]
    return [mix(*ends, st) for ends in planes]


def drifter(time: np.ndarray, axis: np.ndarray, u: np.ndarray, v: np.ndarray) -> Block:
    """Return the block of one particle in a current (time, x2, x1): no inputs -> x[2]."""
    axes = (time, axis, axis)
    parameters = {
        "shape": [float(len(a)) for a in axes],
        "start": [a[0] for a in axes],
        "scale": [1 / (a[1] - a[0]) for a in axes],  # 1 / spacing
        "u": u.ravel(),  # flow along x1 and x2, time slowest
        "v": v.ravel(),
    }
    return Block(
        "drifter", update=drift, states={"x": 2}, parameters=parameters, opaque=True
    )


def advect(
    time, axis, u, v, x1, x2, step: float, steps: int
) -> tuple[np.ndarray, float]:
    """Move passive particles by RK4; return final positions (2, n) and seconds."""
    block = drifter(time, axis, u, v)
    native = compile(clpt.connect([block], name="drifter")).in_form(locking=False)
    starts = np.column_stack([x1, x2])
    ends = np.array([0.0, step * steps])

    def moved(starts: np.ndarray) -> np.ndarray:
        callee = native.callee(native.lanes(len(starts)), RK4)
        parameters = np.tile(native.parameters(), (len(starts), 1))
        segments = [native.schedule(ends)]
        batch = Batch(callee, starts, parameters, ends, segments, longest=step)
        batch.finish(RunOptions())
        return batch.out

    moved(starts[:2])
    found, seconds = timed(lambda: moved(starts))
    return found[:, -1].T, seconds
