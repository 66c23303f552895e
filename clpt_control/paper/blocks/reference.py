"""Waypoints, section IV: the desired position zc(t).

    zc(t) = w_{j mod n},   j tau <= t < (j + 1) tau
    circle: w_j = r [cos(2 pi j / n), sin(2 pi j / n)]

n waypoints are visited in turn, each for the dwell time tau, again and again.  The block jumps at
j tau and reads j from its parameter `interval`, never from t.  zc has n values, so it is bounded
(Remark 3.1).

Ports: none -> zc[2] (length).
"""

from typing import Any

import numpy as np

from ...engine.model.block import Block
from ...engine.model.declaration import Each
from ...engine.trace.interpolators import lookup
from .ports import paper_block


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
    x1, x2 = np.transpose(points)
    parameters = {"x1": x1, "x2": x2, "dwell": dwell}
    return paper_block(
        "reference",
        "-> zc",
        parameters,
        output=waypoint,
        opaque=True,
        breakpoints=Each("dwell"),
    )
