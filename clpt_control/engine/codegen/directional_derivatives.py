"""Derivatives of a diagram's functions along directions: parameters and initial states.

    x' = f(t, x, u, p),     S' = df/dx S + df/dp,     y = h(t, x, u, p),  W = dh/dx S + dh/dp

`add_derivatives` differentiates the record of the whole diagram, wires included.  The derivatives S
along each direction are stored behind the states, and the same for rates, signals and jumps.
Breakpoints, samples and guards are not differentiated.  At a jump in time S is multiplied by the
derivative of the jump.  At a jump in state (`may_jump`) one term is missing.  `places_of` has the
names of the values that may vary, with their locations.
"""

import operator
import re
from collections.abc import Iterable, Mapping, Sequence
from math import prod
from typing import Any, NamedTuple

import numpy as np

from ..diagram.block_numbers import call_names
from ..diagram.wiring import Wiring
from ..model.block import Block
from ..model.declaration import check_rules
from ..model.ports import indices_by_name
from ..record.operations import JUMP, named
from ..trace.arrays import operand
from ..trace.derivative import OF_ROOTS, Direction
from ..trace.elementwise import lifted
from .diagram_record import DiagramRecord, Varied, is_read

JUMPING = named(lambda row: row.smoothness >= JUMP)


def add_derivatives(record: DiagramRecord, directions: tuple[Varied, ...]) -> None:
    """Append the derivatives along directions to rates, jumps and signals of a record.

    There is one direction for each tuple of varied parameters.
    """
    last_node = record.wiring.nodes[-1]
    nstates = last_node.states.stop
    nsignals = last_node.outputs.stop
    groups = [
        (record.rates, nstates),
        (record.leaps, nstates),
        (record.signals, nsignals),
    ]
    originals = [[*ports] for ports, _ in groups]
    for number, varied in enumerate(directions, 1):
        direction = _direction(record, varied, number * nstates)
        for original, (ports, count) in zip(originals, groups, strict=True):
            for port in original:
                value = record.tape.value(port.ref)
                slope = operand(direction.of(value))
                offset = number * count + port.first
                ports.append(port._replace(first=offset, ref=slope))


def _direction(record: DiagramRecord, varied: Varied, state_offset: int) -> Direction:
    """Return the direction of varied parameters and of the derivatives of states in X."""
    tape = record.tape
    layout = record.layout
    parameter_slopes = np.zeros(len(layout.P))
    for block, field, index in varied:
        slot = layout.slots[block, field]
        parameter_slopes[slot.offset + index] = 1.0

    def slope_of(k: int) -> Any:
        _, _, shape, (array, offset) = record.entries[k]
        if array == "X":
            return tape.value(record.load("X", state_offset + offset, shape))
        end = offset + prod(shape)
        numbers = parameter_slopes[offset:end]
        if array != "P" or not numbers.any():
            return None
        return lifted(tape, numbers.reshape(shape))

    return Direction(tape, slope_of, undefined=OF_ROOTS)


# --- names of varied values -----------------------------------------------------------------


class Place(NamedTuple):
    """Location of a value: in fields of blocks, in the initial state, in the inputs."""

    fields: tuple[tuple[int, str], ...] = ()  # (block, field)
    states: tuple[int, ...] = ()
    inputs: tuple[int, ...] = ()
    element: Any = ...  # of a field

    def elements(self, parameters: Sequence[Any]) -> Varied:
        """Return each element of its fields: (block, field, index)."""
        elements = []
        for k, field in self.fields:
            shape = np.shape(getattr(parameters[k], field))
            indices = np.arange(prod(shape)).reshape(shape)[self.element]
            elements += [(k, field, index) for index in np.ravel(indices).tolist()]
        return tuple(elements)


def places_of(
    wiring: Wiring,
    parameters: Sequence[Any],
    states: Sequence[str],
    inputs: Sequence[str] = (),
) -> dict[str, list[Place]]:
    """Return every name that may vary, with its places; a name with two places is ambiguous.

    `parameters` are those of the blocks; `states` and `inputs` are labels.
    """
    locations = {}
    for name, fields in _fields_by_name(wiring).items():
        shapes = {np.shape(getattr(parameters[k], field)) for k, field in fields}
        if len(shapes) > 1:
            locations[name] = [Place((field,)) for field in fields]
        else:
            locations[name] = [Place(tuple(fields))]
    for name, indices in indices_by_name(states).items():
        locations.setdefault(name, []).append(Place(states=tuple(indices)))
    for name, indices in indices_by_name(inputs).items():
        locations.setdefault(name, []).append(Place(inputs=tuple(indices)))
    return locations


def place_of(
    key: str, names: Mapping[str, list[Place]], parameters: Sequence[Any]
) -> Place | None:
    """Return the only place of a name, or of an element of an array, ``plant.A[0,1]``."""
    array, _, inside = key.removesuffix("]").rpartition("[")
    arrays = names.get(array, ())
    if key in names or len(arrays) != 1:
        candidates = names.get(key, ())
        return candidates[0] if len(candidates) == 1 else None
    if not re.fullmatch(r"\d+(\s*,\s*\d+)*", inside):
        # -1 and 0:2 are no single elements
        return None
    location = arrays[0]
    if not location.fields:
        return None
    block, field = location.fields[0]
    shape = np.shape(getattr(parameters[block], field))
    element = tuple(map(int, inside.split(",")))
    if len(element) != len(shape) or not all(map(operator.lt, element, shape)):
        return None
    return location._replace(element=element)


def value_at(
    location: Place, parameters: Sequence[Any], start: np.ndarray
) -> np.ndarray:
    """Return the value that parameters of blocks, or a start, have at a place."""
    if location.fields:
        k, name = location.fields[0]
        array = np.array(getattr(parameters[k], name), dtype=float)
        return array[location.element]
    values = start[list(location.states)]
    return values if len(values) > 1 else values[0]


def put(location: Place, value: Any, parameters: list[Any], start: np.ndarray) -> None:
    """Set the value that parameters of blocks, or a start, have at a place."""
    for k, name in location.fields:
        number = np.array(getattr(parameters[k], name), dtype=float)
        number[location.element] = value
        parameters[k] = parameters[k]._replace(**{name: number[()]})
    if location.states:
        start[list(location.states)] = value


def with_values(
    wiring: Wiring,
    parameters: Sequence[Any],
    start: np.ndarray,
    values: Iterable[tuple[Place, Any]],
) -> tuple[list[Any], np.ndarray]:
    """Return parameters of blocks, and a start, with values at places; rules are checked."""
    parameters, start = list(parameters), start.copy()
    for location, value in values:
        put(location, value, parameters, start)
    for (_, block), its in zip(wiring.blocks, parameters, strict=True):
        check_rules(block, its)
    return parameters, start


def _fields_by_name(wiring: Wiring) -> dict[str, list[tuple[int, str]]]:
    """Return the blocks' parameters by the names that a call gives them: (block, field)."""
    fields: dict[str, list[tuple[int, str]]] = {}
    for k, node in enumerate(wiring.nodes):
        block = node.system
        for name, field in call_names(node.name, block).items():
            value = getattr(block.parameters, field)
            varies = field != "interval" and not isinstance(value, int)
            if varies and is_read(block, field):
                fields.setdefault(name, []).append((k, field))
    return fields


def read_as_number(block: Block, field: str) -> str | None:
    """Return the function in which a parameter was read as a number, if there is one."""
    inner = block.unsampled
    for role in inner.records:
        fields, _ = inner.read_with.get(role, ((), ""))
        if field in fields:
            return role
    return None


def is_remade(wiring: Wiring, fields: Iterable[tuple[int, str]]) -> bool:
    """Return whether blocks are made anew for other values of fields: modes and counts."""
    return any(read_as_number(wiring.nodes[k].system, field) for k, field in fields)


def may_jump(block: Block) -> bool:
    """Return whether a block's functions may jump where a state or time crosses something."""
    if block.opaque and block.of_package:
        return False
    records = [block.array_record(role) for role in block.records if role != "guard"]
    kinds = {operation.kind for record in records for operation in record.operations}
    has_folded_angle = {"atan", "tan"} <= kinds
    return has_folded_angle or not JUMPING.isdisjoint(kinds)
