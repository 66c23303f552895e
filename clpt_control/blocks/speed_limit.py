"""The limit of the vehicle's speed, and what of a velocity could not be flown.

    v   = v_c v_max / max(|v_c|, v_max)       flown: as commanded, or v_max in its direction
    d   = v_c - v                             not flown; 0 up to v_max

v_c is the velocity through the water that Eq. (7) commands.  The learning model takes d off its
own velocity (hedging), z' = F_M + v_z - d, and so e' of Eq. (10) does not know of the limit.
Source: Johnson and Calise 2003, Journal of Guidance, Control, and Dynamics 26(6), hedging.

Ports, length per time: v_c[2] -> v_x[2], v = v_x; v_c[2], v_x[2] -> unflown[2], d.
"""

import numpy as np

from ..equations.block import Block


def limited(t, x, u, p):
    """v = v_c v_max / max(|v_c|, v_max), for Eq. (1)."""
    return p.max_speed / np.maximum(np.sqrt(u.v_c @ u.v_c), p.max_speed) * u.v_c


def difference(t, x, u, p):
    """d = v_c - v, for Eq. (2)."""
    return u.v_c - u.v_x


def speed_limit(max_speed: float) -> Block:
    """Make the limit of the vehicle's speed, length per time."""
    return Block(
        "speed_limit",
        output=limited,
        inputs={"v_c": 2},
        outputs={"v_x": 2},
        parameters={"max_speed": float(max_speed)},
    )


def hedging() -> Block:
    """Make the block that tells the learner what could not be flown."""
    return Block("hedging", output=difference, inputs={"v_c": 2, "v_x": 2}, outputs={"unflown": 2})
