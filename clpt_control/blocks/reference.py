"""Waypoints, section IV: the desired position zc(t).

    zc(t) = w_{j mod n},   j tau <= t < (j + 1) tau
    circle: w_j = r [cos(2 pi j / n), sin(2 pi j / n)]

n waypoints are visited in turn, each for the dwell tau, and start again after
the last.  The block jumps at j tau; it reads j from its parameter `interval`,
never from t.

Ports: none -> zc[2] (length).
"""

import math
from typing import NamedTuple

import numpy as np

from ..equations.block import Block
from ..errors import BlockError
from .words import lookup

MOST_JUMPS = 2 * 10**7  # times of jumps that are listed


class WaypointParameters(NamedTuple):
    """Waypoints and how long each is held."""

    n: int  # number of waypoints
    x1: np.ndarray  # shape (n,), length
    x2: np.ndarray  # shape (n,), length
    dwell: float  # time tau at each waypoint
    interval: float = -1.0  # its number j, kept by the integrator; -1: found from t


def multiples(period: float, t0: float, t1: float) -> np.ndarray:
    """Return the multiples k * period, k >= 1, in (t0, t1]: sorted, each rounded once."""
    count = abs(t1 - t0) / period if period > 0 else math.inf
    if not count <= MOST_JUMPS:
        raise BlockError(
            f"a period of {period:g} has {count:.3g} multiples from {t0:g} to {t1:g}; at most "
            f"{MOST_JUMPS:.0e} are allowed"
        )
    first = max(1, math.floor(t0 / period) - 1)
    last = math.floor(t1 / period) + 1
    times = period * np.arange(first, last + 1)
    return times[(times > t0) & (times <= t1)]


def dwell_ends(p: WaypointParameters, t0: float, t1: float) -> np.ndarray:
    """Return the times in (t0, t1] at which the next waypoint is taken."""
    return multiples(p.dwell, t0, t1)


def waypoint(t, x, u, p, y):
    """zc = waypoint (interval mod n), section IV: no inputs, y = zc[2] (length)."""
    y[0] = lookup(p.x1, p.interval % p.n)
    y[1] = lookup(p.x2, p.interval % p.n)


def circle(radius: float, count: int) -> np.ndarray:
    """Return count points on a circle, section IV: shape (count, 2), counter-clockwise."""
    angle = 2 * np.pi * np.arange(count) / count
    return radius * np.column_stack([np.cos(angle), np.sin(angle)])


def reference(points: np.ndarray, dwell: float) -> Block:
    """Make the reference: waypoints of shape (n, 2) in turn, each for the time `dwell`."""
    points = np.asarray(points, dtype=float)
    return Block(
        "reference",
        output=waypoint,
        outputs={"zc": 2},
        parameters=WaypointParameters(len(points), points[:, 0], points[:, 1], dwell),
        feedthrough=False,
        opaque=True,
        breakpoints=dwell_ends,
    )
