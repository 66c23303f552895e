"""The limit of the vehicle's speed, and what of a velocity could not be flown.

    v   = v_c v_max / max(|v_c|, v_max)       flown: as commanded, or v_max in its direction
    d   = v_c - v                             not flown; 0 up to v_max

v_c is the velocity through the water that Eq. (7) commands.  The learning model takes d off its
own velocity (hedging), z' = F_M + v_z - d, and so e' of Eq. (10) does not know of the limit.
Source: Johnson and Calise 2003, Journal of Guidance, Control, and Dynamics 26(6), hedging.

Ports, length per time: v_c[2] -> v_x[2], v = v_x; v_c[2], v_x[2] -> unflown[2], d.
"""

import math
from typing import NamedTuple

from ..equations.block import Block
from .words import maximum


class SpeedLimitParameters(NamedTuple):
    """How fast the vehicle is."""

    max_speed: float  # v_max > 0, through the water, length per time


def limited(t, x, u, p, y):
    """v = v_c v_max / max(|v_c|, v_max), for Eq. (1): u = v_c[2], y = v_x[2] (length per time)."""
    share = p.max_speed / maximum(math.sqrt(u[0] * u[0] + u[1] * u[1]), p.max_speed)
    for i in range(2):
        y[i] = share * u[i]


def difference(t, x, u, p, y):
    """d = v_c - v, for Eq. (2): u = v_c[2], v_x[2], y = unflown[2] (length per time)."""
    for i in range(2):
        y[i] = u[i] - u[2 + i]


def speed_limit(parameters: SpeedLimitParameters) -> Block:
    """Make the limit of the vehicle's speed."""
    return Block(
        "speed_limit",
        output=limited,
        inputs={"v_c": 2},
        outputs={"v_x": 2},
        parameters=parameters,
    )


def hedging() -> Block:
    """Make the block that tells the learner what could not be flown."""
    return Block("hedging", output=difference, inputs={"v_c": 2, "v_x": 2}, outputs={"unflown": 2})
