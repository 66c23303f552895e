"""The vehicle, Eq. (1), its controller, Eq. (7), and the limit of its speed.

    dx/dt = F_R(x, t) + v                                   Eq. (1)
    v = -alpha_M phi(x, t) - KD x + GammaD zc               Eq. (7)

x is the true position (length), F_R the true flow and v the through-water
velocity (length per time).  KD and GammaD are diagonal.  With a speed limit, Eq. (7) gives
v_c, the commanded velocity, and

    v   = v_c v_max / max(|v_c|, v_max)       flown: as commanded, or v_max in its direction
    d   = v_c - v                             not flown; 0 up to v_max

The learning model subtracts d from its velocity (hedging), z' = F_M + v_z - d, so that e' of
Eq. (10) does not depend on the limit.
Source: Johnson and Calise 2003, Journal of Guidance, Control, and Dynamics 26(6), hedging.

Ports: flow_x[2], v_x[2] (length per time) -> x[2] (length), a state, or x_true[2] if the
position is measured with noise (`localization`);
x[2] or z[2], zc[2] (length), phi_x[N] or phi_z[N] -> v_x[2], or v_c[2] with a speed limit.
v_c[2] -> v_x[2]; v_c[2], v_x[2] -> unflown[2], d.
"""

from typing import Any

import numpy as np

from ...engine.model.block import Block
from .flow import at_position
from .ports import paper_block


def kinematics(t, x, u, p):
    """x' = F_R + v, Eq. (1)."""
    return u.flow_x + u.v_x


def controller(t, x, u, p):
    """v = -alpha_M phi(x) - KD x + GammaD zc, Eq. (7)."""
    return -(p.alpha_M @ u.phi_x) - p.KD * u.x + p.GammaD * u.zc


def true_position(t, x, u, p):
    """y = x, the state of Eq. (1)."""
    return x.x


def vehicle(position: str = "x") -> Block:
    """Make the vehicle, Eq. (1); its position is the port ``"x"`` or ``"x_true"``."""
    if position == "x":
        return paper_block("vehicle", "flow_x v_x -> x", update=kinematics)
    return paper_block(
        "vehicle",
        f"flow_x v_x -> {position}",
        update=kinematics,
        output=true_position,
        states={"x": 2},
    )


def vehicle_controller(
    alpha_M: Any, KD: Any, GammaD: Any, limited: bool = False, position: str = "x"
) -> Block:
    """Make the vehicle controller, Eq. (7); with a speed limit its output is v_c.

    The gains KD and GammaD are per time.  The controller reads the port `position`: ``"x"``, or
    ``"z"`` between fixes.
    """
    ports = "x zc phi_x -> v_c" if limited else "x zc phi_x -> v_x"
    parameters = {"alpha_M": alpha_M, "KD": KD, "GammaD": GammaD}
    block = paper_block("vehicle_controller", ports, parameters, output=controller)
    return at_position(block, position)


def limited(t, x, u, p):
    """v = v_c v_max / max(|v_c|, v_max), for Eq. (1)."""
    return p.max_speed / np.maximum(np.sqrt(u.v_c @ u.v_c), p.max_speed) * u.v_c


def difference(t, x, u, p):
    """d = v_c - v, for Eq. (2)."""
    return u.v_c - u.v_x


def speed_limit(max_speed: float) -> Block:
    """Make the limit of the vehicle's speed, length per time."""
    parameters = {"max_speed": max_speed}
    return paper_block("speed_limit", "v_c -> v_x", parameters, output=limited)


def hedging() -> Block:
    """Make the block of the unflown velocity d, an input of the learning model."""
    return paper_block("hedging", "v_c v_x -> unflown", output=difference)
