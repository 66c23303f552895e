"""A diagram with its derivatives along directions: parameters and initial states.

    x' = f(t, x, u, p),     S' = df/dx S + df/du V + df/dp,     y = h(...),  W = dh/dx S + ...

Each block becomes one that has the derivatives of each port behind it: ``d_x`` of shape
(directions, 2) behind x.  Wires, breakpoints, jumps, samples and guards stay as they are, so every
engine and method runs the whole, and the record is still compared with Python's functions.  At a
jump in time S is multiplied by the derivative of the jump.  A jump where a state crosses something
would need one more term, which is missing: `may_jump` says where that may be.
"""

import operator
import re
from collections.abc import Mapping, Sequence
from dataclasses import replace
from math import prod
from typing import Any, NamedTuple

import numpy as np

from ..model.block import Block
from ..model.ports import ports_of
from ..model.sampled import other_equations
from ..model.system import System
from ..model.vectorized import on_arrays
from ..record.derivative import STEPS, Direction
from ..record.graph import Record, Shape, bound, compact
from ..trace.arrays import Array, Tape, operand
from ..trace.elementwise import elementwise, lifted, spread, stacked
from .evaluation_order import unsampled
from .wiring import Row, Wiring, call_names, ordered_wiring

ALONG = "d_"  # before the name of a port: its derivatives, a row for each direction
JUMPING = STEPS | {"mod", "pick", "atan2"}
Seeds = Mapping[str, np.ndarray]  # field of a block -> its derivatives, a row for each direction


class VariedBlock(Block):
    """A block with its derivatives; `seeds` are those of its parameters."""

    def __init__(self, inner: Block, parameters: Any, seeds: Seeds, count: int):
        self.inner, self.seeds, self.count = inner, seeds, count
        own = inner.input_shapes, inner.output_shapes, inner.state_shapes
        inputs, outputs, states = map(self._beside, own)
        self.inputs, self.outputs, self.states = (places_along(one, count) for one in own)
        super().__init__(
            inner.name,
            update=other_equations if inner.update_function else None,
            output=other_equations if inner.output_function else None,
            inputs=inputs,
            outputs=outputs if inner.output_function else None,
            states=states,
            parameters=parameters,
            breakpoints=inner.breakpoints_function,
            jump=other_equations if inner.jump_function else None,
            guard=inner.guard and inner.guard._replace(sentence=self._sentence),
        )
        self.raised, self.dt, self.of_package = inner.raised, inner.dt, inner.of_package
        self.first_held = None if inner.first_held is None else inner.first_held * (1 + count)

    def _beside(self, shapes: Mapping[str, Shape]) -> dict[str, Shape]:
        """Return ports, each with its derivatives behind it."""
        found: dict[str, Shape] = {}
        for port, shape in shapes.items():
            found |= {port: shape, ALONG + port: (self.count, *shape)}
        return found

    def _sentence(self, t: float, u: np.ndarray, p: Any) -> str:
        assert self.inner.guard is not None
        return self.inner.guard.sentence(t, u[self.inputs[0]], p)

    def _try_equations(self) -> None:
        """Do nothing: the inner block was tried."""

    def samples_at(self, t: float) -> bool:
        """Whether inputs are sampled at a time."""
        return self.inner.samples_at(t)

    def values(self, role: str, size: int, t: float, x: Any, u: Any, p: Any) -> np.ndarray:
        """Return the results of the inner block's functions, and their derivatives."""
        inner_x, inner_u = np.asarray(x)[self.states[0]], np.asarray(u)[self.inputs[0]]
        if role == "guard":
            return self.inner.values(role, size, t, inner_x, inner_u, p)
        at = (self.outputs if role == "output" else self.states)[0]
        found = on_arrays(self, role, t, np.asarray(x), np.asarray(u), p)
        found[at] = self.inner.values(role, len(at), t, inner_x, inner_u, p)
        return found

    def _read(self, role: str) -> Record:
        record = self.inner.array_record(role)
        if role == "guard":
            return record
        tape, along = Tape(), [dict[int, Any]() for _ in range(self.count)]

        def leaf(group: str, name: str, shape: Shape) -> Array:
            made = tape.add("leaf", (), shape, (group, name))
            if group in ("x", "u"):
                rows = tape.add("leaf", (), (self.count, *shape), (group, ALONG + name))
                for k, own in enumerate(along):
                    own[operand(made)] = rows[k]
            elif group == "p" and name in self.seeds:
                for own, seed in zip(along, self.seeds[name], strict=True):
                    own[operand(made)] = lifted(tape, seed) if np.any(seed) else None
            return made

        closed = [o._replace(shape=bound(o.shape, self.inner.sizes)) for o in record.operations]
        values = tape.replayed(replace(record, operations=tuple(closed)), leaf)
        ways = [_Along(tape, own) for own in along]
        shapes = self.inner.output_shapes if role == "output" else self.inner.state_shapes
        found: list[Any] = []
        for value, shape in zip(values, shapes.values(), strict=True):
            slopes = [spread(tape, way.of(value), shape) for way in ways]
            found += [value, stacked(tape, slopes)]
        ports = self.output_shapes if role == "output" else self.state_shapes
        return compact(tape.operations, [operand(one) for one in found], ports.values())


class _Along(Direction):
    """A direction along which |x| at x = 0, a root of squares, has the slope 0 and not 0/0.

    So has a power of |x|, as in |x|^0.5 x.
    """

    def _along(self, k: int) -> Any:
        found, kind = super()._along(k), self.tape.operations[k].kind
        if found is None or kind not in ("sqrt", "hypot", "pow"):
            return found
        nothing = (self.tape.value(k) == 0.0) & (found != found)
        return elementwise("where", nothing, 0.0, found)


def places_along(shapes: Mapping[str, Shape], count: int) -> np.ndarray:
    """Return the places of signals among theirs and their derivatives.

    A row has their own, then there is one for each direction.
    """
    found, first = [np.zeros((1 + count, 0), dtype=int)], 0
    for size in map(prod, shapes.values()):
        found.append(first + np.arange((1 + count) * size).reshape(1 + count, size))
        first += (1 + count) * size
    return np.hstack(found)


# --- the diagram ------------------------------------------------------------------------------


class VariedWiring(NamedTuple):
    """A wiring with its derivatives, and the places of its states and signals.

    Places have a row for their own, then one for each direction.
    """

    wiring: Wiring
    states: np.ndarray
    signals: np.ndarray


def varied(wiring: Wiring, given: Sequence, seeds: Sequence[Seeds], count: int) -> VariedWiring:
    """Return a diagram with its derivatives along `count` directions.

    `given` are the parameters of its blocks, `seeds` their derivatives.
    """
    parts = zip(wiring.nodes, given, seeds, strict=True)
    blocks = [VariedBlock(node.system, p, own, count) for node, p, own in parts]

    def places(kind: str) -> np.ndarray:
        pairs = zip(wiring.nodes, blocks, strict=True)
        each = ((getattr(node, kind).start, getattr(block, kind)) for node, block in pairs)
        return np.hstack([own + (1 + count) * start for start, own in each])

    inputs, signals, states = map(places, ("inputs", "outputs", "states"))
    fed: list[Row] = [{} for _ in range(inputs.size)]
    for node in wiring.nodes:
        own = inputs[:, node.inputs]
        for to, source, gain in node.fed():
            for a, b in zip(own[:, to], signals[:, source], strict=True):
                fed[a][int(b)] = gain
        for to, source, gain in node.fed(external=True):
            fed[own[0, to]][~source] = gain
    named = [(node.name, block) for node, block in zip(wiring.nodes, blocks, strict=True)]
    how = wiring.ninputs, wiring.outputs, wiring.dt, wiring.order
    return VariedWiring(ordered_wiring(named, fed, *how), states, signals)


# --- what may be varied -----------------------------------------------------------------------


class Place(NamedTuple):
    """Where a value lies: in fields of blocks, in the initial state, in the inputs."""

    fields: tuple[tuple[int, str], ...] = ()  # (block, field)
    states: tuple[int, ...] = ()
    inputs: tuple[int, ...] = ()
    element: Any = ...  # of a field


def places_of(
    wiring: Wiring, given: Sequence[Any], states: Sequence[str], inputs: Sequence[str] = ()
) -> dict[str, list[Place]]:
    """Return every name that may vary, with its places; a name with two places is ambiguous.

    `given` are the parameters of the blocks; states and inputs are labels.
    """
    found: dict[str, list[Place]] = {}
    for name, fields in _fields_by_name(wiring).items():
        shapes = {np.shape(getattr(given[k], field)) for k, field in fields}
        apart = [(one,) for one in fields] if len(shapes) > 1 else [tuple(fields)]
        found[name] = [Place(own) for own in apart]
    for kind, labels in (("states", states), ("inputs", inputs)):
        named = {label: [k] for k, label in enumerate(labels)} | ports_of(labels)
        for name, places in named.items():
            own: Any = {kind: tuple(places)}
            found.setdefault(name, []).append(Place(**own))
    return found


def place_of(key: str, names: Mapping[str, list[Place]], given: Sequence[Any]) -> Place | None:
    """Return the only place of a name, or of an element of an array, ``plant.A[0,1]``."""
    whole, _, inside = key.removesuffix("]").rpartition("[")
    if key in names or len(names.get(whole, ())) != 1:
        own = names.get(key, ())
        return own[0] if len(own) == 1 else None
    if not re.fullmatch(r"\d+(\s*,\s*\d+)*", inside):  # -1 and 0:2 are no places of one number
        return None
    place, element = names[whole][0], tuple(map(int, inside.split(",")))
    shape = np.shape(getattr(given[place.fields[0][0]], place.fields[0][1])) if place.fields else ()
    inner = len(element) == len(shape) and all(map(operator.lt, element, shape))
    return place._replace(element=element) if inner and place.fields else None


def value_at(place: Place, given: Sequence[Any], start: np.ndarray) -> np.ndarray:
    """Return the value that parameters of blocks, or a start, have at a place."""
    if place.fields:
        k, name = place.fields[0]
        return np.array(getattr(given[k], name), dtype=float)[place.element]
    found = start[list(place.states)]
    return found if len(found) > 1 else found[0]


def put(place: Place, value: Any, given: list[Any], start: np.ndarray) -> None:
    """Set the value that parameters of blocks, or a start, have at a place."""
    for k, name in place.fields:
        number = np.array(getattr(given[k], name), dtype=float)
        number[place.element] = value
        given[k] = given[k]._replace(**{name: number[()]})
    if place.states:
        start[list(place.states)] = value


def _fields_by_name(wiring: Wiring) -> dict[str, list[tuple[int, str]]]:
    """Return the blocks' parameters by the names that a call gives them: (block, field)."""
    found: dict[str, list[tuple[int, str]]] = {}
    for k, node in enumerate(wiring.nodes):
        block = node.system
        inner = getattr(block, "inner", block)  # of one that is sampled
        for name, field in call_names(node.name, block).items():
            whole = isinstance(getattr(block.parameters, field), int)
            unread = isinstance(inner, System) and not inner.reads(field)
            if field != "interval" and not whole and not unread:
                found.setdefault(name, []).append((k, field))
    return found


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
    kinds = {one.kind for record in records for one in record.operations}
    return not JUMPING.isdisjoint(kinds) or {"atan", "tan"} <= kinds
