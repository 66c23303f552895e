"""The controlled Lagrangian prediction error, Eq. (10).

    e = x - z

True position minus predicted position (length).  Its dynamics, the lines that
follow in Eq. (10), are what the wired diagram gives; they are not written again.

Ports: x[2], z[2] (length) -> e[2] (length).
"""

from ..equations.block import Block


def prediction_error(t, x, u, p):
    """e = x - z, Eq. (10)."""
    return u.x - u.z


def clpe() -> Block:
    """Make the block of the prediction error, Eq. (10)."""
    return Block("clpe", output=prediction_error, inputs={"x": 2, "z": 2}, outputs={"e": 2})
