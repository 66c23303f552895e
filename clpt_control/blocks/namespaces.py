"""Blocks of several vehicles in one diagram: `west/vehicle` makes `west/x[2]`.

A block is made once, for one vehicle; in a namespace its name and the names of its ports
carry the vehicle's name, and its equations are the same.
"""

from .block import Block
from .declaration import states_as_outputs

BETWEEN = "/"


def named(space: str, own: str) -> str:
    """Return a name in a namespace."""
    return f"{space}{BETWEEN}{own}"


def split(name: str) -> tuple[str, str]:
    """Return the namespace of a name, empty where it has none, and the name in it."""
    space, _, own = name.rpartition(BETWEEN)
    return space, own


def within(block: Block, space: str) -> Block:
    """Return a block with its name and all its ports in a namespace."""

    def moved(ports: dict[str, int]) -> dict[str, int]:
        return {named(space, port): size for port, size in ports.items()}

    output = block.output_function
    by_states = output is states_as_outputs
    return Block(
        named(space, block.name),
        update=block.update_function,
        output=None if by_states else output,
        inputs=moved(block.input_ports),
        outputs=None if by_states else moved(block.output_ports),
        states=moved(block.state_ports),
        parameters=block.parameters,
        feedthrough=block.feedthrough,
        opaque=block.opaque,
        breakpoints=block.breakpoints_function,
        jump=block.jump_function,
        guard=block.guard,
    )
