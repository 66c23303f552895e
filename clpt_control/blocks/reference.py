"""Waypoints, section IV: the desired position zc(t).

    zc(t) = w_{j mod n},   j tau <= t < (j + 1) tau
    circle: w_j = r [cos(2 pi j / n), sin(2 pi j / n)]

n waypoints are visited in turn, each for the dwell tau, and start again after
the last.  The block jumps at j tau; it reads j from its parameter `interval`,
never from t.

Ports: none -> zc[2] (length).
"""

import math
from typing import Any

import numpy as np

from ..equations.block import Block
from ..equations.words import lookup
from ..errors import BlockError

MOST_JUMPS = 2 * 10**7  # times of jumps that are listed


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


def dwell_ends(p: Any, t0: float, t1: float) -> np.ndarray:
    """Return the times in (t0, t1] at which the next waypoint is taken."""
    return multiples(p.dwell, t0, t1)


def waypoint(t, x, u, p):
    """zc = waypoint (interval mod n), section IV."""
    j = p.interval % len(p.x1)
    return [lookup(p.x1, j), lookup(p.x2, j)]


def circle(radius: float, count: int) -> np.ndarray:
    """Return count points on a circle, section IV: shape (count, 2), counter-clockwise."""
    angle = 2 * np.pi * np.arange(count) / count
    return radius * np.column_stack([np.cos(angle), np.sin(angle)])


def reference(points: Any, dwell: float) -> Block:
    """Make the reference: waypoints of shape (n, 2) in turn, each for the time `dwell`."""
    x1, x2 = np.asarray(points, dtype=float).T
    return Block(
        "reference",
        output=waypoint,
        outputs={"zc": 2},
        parameters={"x1": x1, "x2": x2, "dwell": float(dwell), "interval": -1.0},
        opaque=True,
        breakpoints=dwell_ends,
    )
