"""The true flow, Eq. (3), and the modelled flow, Eq. (4).

    F_R(x, t) = theta phi(x, t)                   Eq. (3)
    F_R(x, t) = theta phi(x, t) + Delta           Eq. (32)
    F_M(z, t) = alpha_M phi(z, t)                 Eq. (4)

Velocities in length per time.  `blocks.field` has a measured current as the true flow.

Ports: x[2] (length), phi_x[N], delta[2] where disturbed -> flow_x[2]; phi_z[N] -> flow_z[2].
"""

from typing import Any

from ..equations.block import Block
from ..equations.namespaces import renamed


def true(t, x, u, p):
    """F_R = theta phi(x), Eq. (3)."""
    return p.theta @ u.phi_x


def true_disturbed(t, x, u, p):
    """F_R = theta phi(x) + Delta, Eq. (32)."""
    return true(t, x, u, p) + u.delta


def modeled(t, x, u, p):
    """F_M = alpha_M phi(z), Eq. (4)."""
    return p.alpha_M @ u.phi_z


def true_flow(theta: Any, disturbed: bool = False, position: str = "x") -> Block:
    """Make the true flow at a position, Eq. (3), or with the input delta, Eq. (32)."""
    inputs: dict[str, Any] = {"x": 2, "phi_x": "N"} | ({"delta": 2} if disturbed else {})
    block = Block(
        "true_flow",
        output=true_disturbed if disturbed else true,
        inputs=inputs,
        outputs={"flow_x": 2},
        parameters={"theta": theta},
        shapes={"theta": (2, "N")},
    )
    return at_position(block, position)


def at_position(block: Block, position: str) -> Block:
    """Return a block that reads another position than x, and phi there."""
    if position == "x":
        return block
    return renamed(block, block.name, {"x": position, "phi_x": f"phi_{position}"}, {})


def modeled_flow(alpha_M: Any) -> Block:
    """Make the modelled flow, Eq. (4)."""
    return Block(
        "modeled_flow",
        output=modeled,
        inputs={"phi_z": "N"},
        outputs={"flow_z": 2},
        parameters={"alpha_M": alpha_M},
        shapes={"alpha_M": (2, "N")},
    )
