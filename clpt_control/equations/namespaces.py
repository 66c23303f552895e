"""A block under other names: of several vehicles in one diagram, or between two others.

A block is made once, for one vehicle; in a namespace its name and the names of its ports
carry the vehicle's name, `west/vehicle` makes `west/x[2]`, and its equations are the same.
"""

from collections.abc import Mapping

from .block import Block

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
    ports = {*block.input_ports, *block.output_ports, *block.state_ports}
    moved = {port: named(space, port) for port in ports}
    return renamed(block, named(space, block.name), moved, moved, moved)


def renamed(
    block: Block,
    name: str,
    inputs: Mapping[str, str],
    outputs: Mapping[str, str],
    states: Mapping[str, str] | None = None,
) -> Block:
    """Return a block under another name, some of its ports under others: {old: new}."""
    made = block.copy(name=name)
    by_states = block.states_are_outputs
    kinds = {"inputs": inputs, "outputs": outputs, "states": outputs if by_states else states or {}}
    made._name_ports(kinds)
    return made
