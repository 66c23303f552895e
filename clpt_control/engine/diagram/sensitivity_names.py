"""Names of what may be varied in a diagram: parameters, initial states and inputs.

Where a state crosses a jump, the derivatives of a run (`codegen.directional_derivatives`) would
need one more term, which is missing: `may_jump` says where a function may jump.
"""

import operator
import re
from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np

from ..model.block import Block
from ..model.ports import ports_of
from ..model.system import System
from ..record.operations import JUMP, named
from .evaluation_order import unsampled
from .wiring import Wiring, call_names

JUMPING = named(lambda row: row.smoothness >= JUMP)


class Place(NamedTuple):
    """Location of a value: in fields of blocks, in the initial state, in the inputs."""

    fields: tuple[tuple[int, str], ...] = ()  # (block, field)
    states: tuple[int, ...] = ()
    inputs: tuple[int, ...] = ()
    element: Any = ...  # of a field


def places_of(
    wiring: Wiring, parameters: Sequence[Any], states: Sequence[str], inputs: Sequence[str] = ()
) -> dict[str, list[Place]]:
    """Return every name that may vary, with its places; a name with two places is ambiguous.

    `given` are the parameters of the blocks; states and inputs are labels.
    """
    locations: dict[str, list[Place]] = {}
    for name, fields in _fields_by_name(wiring).items():
        shapes = {np.shape(getattr(parameters[k], field)) for k, field in fields}
        groups = [(one,) for one in fields] if len(shapes) > 1 else [tuple(fields)]
        locations[name] = [Place(group) for group in groups]
    for kind, labels in (("states", states), ("inputs", inputs)):
        named = {label: [k] for k, label in enumerate(labels)} | ports_of(labels)
        for name, positions in named.items():
            group: Any = {kind: tuple(positions)}
            locations.setdefault(name, []).append(Place(**group))
    return locations


def place_of(key: str, names: Mapping[str, list[Place]], parameters: Sequence[Any]) -> Place | None:
    """Return the only place of a name, or of an element of an array, ``plant.A[0,1]``."""
    array, _, inside = key.removesuffix("]").rpartition("[")
    if key in names or len(names.get(array, ())) != 1:
        candidates = names.get(key, ())
        return candidates[0] if len(candidates) == 1 else None
    if not re.fullmatch(r"\d+(\s*,\s*\d+)*", inside):  # -1 and 0:2 are no places of one number
        return None
    location = names[array][0]
    element = tuple(map(int, inside.split(",")))
    shape = (
        np.shape(getattr(parameters[location.fields[0][0]], location.fields[0][1]))
        if location.fields
        else ()
    )
    inner = len(element) == len(shape) and all(map(operator.lt, element, shape))
    return location._replace(element=element) if inner and location.fields else None


def value_at(location: Place, parameters: Sequence[Any], start: np.ndarray) -> np.ndarray:
    """Return the value that parameters of blocks, or a start, have at a place."""
    if location.fields:
        k, name = location.fields[0]
        return np.array(getattr(parameters[k], name), dtype=float)[location.element]
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


def _fields_by_name(wiring: Wiring) -> dict[str, list[tuple[int, str]]]:
    """Return the blocks' parameters by the names that a call gives them: (block, field)."""
    fields: dict[str, list[tuple[int, str]]] = {}
    for k, node in enumerate(wiring.nodes):
        block = node.system
        inner = getattr(block, "inner", block)  # of one that is sampled
        for name, field in call_names(node.name, block).items():
            is_whole = isinstance(getattr(block.parameters, field), int)
            unread = isinstance(inner, System) and not inner.reads(field)
            if field != "interval" and not is_whole and not unread:
                fields.setdefault(name, []).append((k, field))
    return fields


def read_as_number(block: Block, field: str) -> str | None:
    """Return the function in which a parameter was read as a number, if there is one."""
    inner = unsampled(block)
    for role in inner.records:
        if field in inner.read_with.get(role, ((), ""))[0]:
            return role
    return None


def may_jump(block: Block) -> bool:
    """Return whether a block's functions may jump where a state or time crosses something."""
    if block.opaque and block.of_package:
        return False
    records = [block.array_record(role) for role in block.records if role != "guard"]
    kinds = {operation.kind for record in records for operation in record.operations}
    return not JUMPING.isdisjoint(kinds) or {"atan", "tan"} <= kinds
