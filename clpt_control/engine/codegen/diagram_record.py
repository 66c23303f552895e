"""Record of a diagram for the code generator, and the layout of its parameters.

    v0 = load X[0:2]            v1 = add(v0, v7)            v2 = sum(v1 over 0)
    x[i] of a block -> X        p.field[k] -> P, or T where runs share it

An axis becomes a loop if its size has a name or is above `SHORT`.  Each entry has an owner, its
block, because only terms of different blocks may cancel (`merged_sums`); wires have no owner.
Fields with equal values share a slot, so common expressions of several blocks are found equal.  An
input of the diagram is a straight line in time: behind the fields, P has the times where the lines
begin, their values there and their slopes.  Prepared values are the last numbers of P.
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from math import pi, prod
from operator import attrgetter
from typing import Any, Literal, NamedTuple

import numpy as np

from ..diagram.merged_record import RecordMerger
from ..diagram.wiring import Wiring
from ..model.block import Block
from ..model.ports import places
from ..model.system import System
from ..record.graph import PIVOT, Operation, Record, bound
from ..record.operations import named
from ..record.unread import Unread
from ..trace.arrays import Tape, operand
from ..trace.elementwise import spread
from .switching_conditions import LOCKED, Decisions, Event, Port

# an axis up to SHORT is unrolled, but from NAMED on where it has a name
SHORT = 16
NAMED = 2
SIGNED = named(attrgetter("signed_zero"))
# inverses, of which angles are folded
FOLDS = {"asin": "sin", "acos": "cos", "atan": "tan"}
WIRE = -1  # the owner of the operations of wires
LARGE = 512  # numbers: a larger array is a table that runs share
# the lengths from which on an axis without and with a name loops
LOOPED_FROM = {None: (SHORT + 1, NAMED), "unrolled": (10**9, 10**9), "looped": (2, 2)}
MARGIN_ROUNDING = 1e-9  # of margins that have no unit, as shares have none
Ref = Any  # the place of an entry (int), or a constant (float)


# (block, field, index in it) of varied parameters
Varied = tuple[tuple[int, str, int], ...]


class Form(NamedTuple):
    """Form in which a diagram's record is written."""

    axes: Literal["unrolled", "looped"] | None = (
        None  # all axes; else short ones unroll
    )
    locking: bool = True  # decisions are locked for a step
    held: tuple[Any, ...] = ()  # switches on which runs slide (`sliding_rates`)
    directions: tuple[Varied, ...] = ()  # of derivatives, behind the states
    exact: bool = False  # of guaranteed runs: neither locked nor rounded, as pi is

    @property
    def copies(self) -> int:
        """Number of vectors as long as the state: the state and its derivatives."""
        return 1 + len(self.directions)


PLAIN = Form()


# --- where each number lies ------------------------------------------------------------------


class Slot(NamedTuple):
    """Location of a parameter field: array P, or T, which runs share, and offset."""

    array: str
    offset: int


class TimeTable(NamedTuple):
    """A table over time plus a constant, whose rows are breakpoints."""

    times: np.ndarray  # of the rows
    offset: int  # in P, of the number of rows before now
    continuous: bool  # what is read there does not jump at a row


@dataclass
class Layout:
    """The slots of all parameters of a diagram, and the diagram's own values of P and T."""

    # of (block, field)
    slots: dict[tuple[int, str], Slot] = field(default_factory=dict)
    # block -> its `interval` in P
    intervals: dict[int, int] = field(default_factory=dict)
    # block -> place in P: `JUMPS` or 0
    jumps: dict[int, int] = field(default_factory=dict)
    # by rows, shift and side
    time_tables: dict[tuple, TimeTable] = field(default_factory=dict)
    P: np.ndarray = field(default_factory=lambda: np.zeros(0))
    T: np.ndarray = field(default_factory=lambda: np.zeros(1))  # never empty

    @property
    def pattern(self) -> tuple:
        """All places, and so which fields share a slot: part of the key of compiled code."""
        tables = ((key, table.offset) for key, table in self.time_tables.items())
        lengths = len(self.P), len(self.T)
        return *self.slots.items(), *self.jumps.items(), *tables, *lengths

    def inputs(self, count: int) -> int:
        """Return the length of P with `count` inputs of the diagram."""
        return len(self.P) + 1 + 2 * count

    def packed(self, parameters: Sequence[Any]) -> np.ndarray:
        """Return P for other parameters of the same blocks; fields that share stay equal."""
        P = self.P.copy()
        values_by_offset = dict[int, np.ndarray]()
        for (k, name), (array, offset) in self.slots.items():
            if array == "T":
                continue
            value = np.asarray(getattr(parameters[k], name), dtype=float).ravel()
            shared_value = values_by_offset.setdefault(offset, value)
            if not np.array_equal(shared_value, value):
                raise ValueError(
                    f"{name} of block {k} no longer equals the field it stands with"
                )
            P[offset : offset + len(value)] = value
        return P


def lay_out(
    wiring: Wiring,
    parameters: Sequence[Any],
    apart: Mapping[tuple[int, str], Any] = {},
    tables: bool = True,
) -> Layout:
    """Return slots for the parameters of a diagram's blocks.

    `apart` maps fields that differ from run to run, (block, field), to a value; two of them share a
    slot only if these values are equal.  Without `tables`, P has parameters and what an integrator
    sets alone.
    """
    layout = Layout()
    slots = dict[tuple, Slot]()
    arrays: dict[str, list[np.ndarray]] = {"P": [np.zeros(0)], "T": []}

    def slot(array: str, numbers: np.ndarray) -> Slot:
        offset = sum(filled.size for filled in arrays[array])
        arrays[array].append(numbers.ravel())
        return Slot(array, offset)

    for k, (node, p) in enumerate(zip(wiring.nodes, parameters, strict=True)):
        block = node.system
        for name, value in zip(p._fields, p, strict=True):
            if isinstance(value, int) or not is_read(block, name):
                continue
            numbers = np.asarray(value, dtype=float)
            varied = apart.get((k, name))
            key: tuple = (name, numbers.shape, numbers.tobytes(), varied)
            if name == "interval":
                key = name, k
            if key not in slots:
                is_shared = numbers.size > LARGE and (k, name) not in apart
                array = "T" if is_shared else "P"
                slots[key] = slot(array, numbers)
            layout.slots[k, name] = slots[key]
            if name == "interval" and block.breakpoints_function is not None:
                layout.intervals[k] = slots[key].offset
        if block.jump_function is not None:
            layout.jumps[k] = slot("P", np.zeros(1)).offset
        if wiring.dt or not tables:
            continue
        for key in tables_over_time(block):
            if key not in layout.time_tables:
                rows, shift, (_, joints) = key
                offset = slot("P", np.zeros(1)).offset
                times = np.frombuffer(rows) - shift
                is_continuous = joints != "jumps"
                layout.time_tables[key] = TimeTable(times, offset, is_continuous)
    layout.P = np.concatenate(arrays["P"])
    layout.T = np.concatenate([*arrays["T"], np.zeros(1)])
    return layout


def is_read(block: Block, name: str) -> bool:
    """Return whether a block's functions read a parameter; python-control hands down others too."""
    inner = block.unsampled
    if not isinstance(inner, System) or name == "interval":
        return True
    return inner.reads(name)


def tables_over_time(block: Block) -> Iterator[tuple]:
    """Yield rows, shift and side of the tables that a block reads at time plus a constant."""
    for role in (*block._roles, "output"):
        with suppress(Unread):
            operations = block.array_record(role).operations
            for operation in operations:
                if operation.kind != "search":
                    continue
                row, value = operation.arguments
                shift = shift_of(operations, value)
                if shift is not None and operations[row].kind == "constant":
                    yield operations[row].at, shift, operation.at


def shift_of(lines: Sequence[Operation], ref: Ref) -> float | None:
    """Return by how much a value is later than time; None where it is no such time."""

    def is_time(ref: Ref) -> bool:
        if type(ref) is not int or lines[ref].shape:
            return False
        return lines[ref].at in (("t", "t"), ("t", 0))

    if is_time(ref):
        return 0.0
    if type(ref) is not int:  # a number, such as an input without a wire
        return None
    kind, arguments, *_ = lines[ref]
    if kind not in ("add", "sub") or not is_time(arguments[0]):
        return None
    shift = arguments[1]
    if type(shift) is not float:
        return None
    return shift if kind == "add" else -shift


# --- the record ------------------------------------------------------------------------------


class DiagramRecord(RecordMerger):
    """All operations of a diagram, and the values that its functions store.

    Kinds are those of `record.graph`, with loads in place of leaves.  `at` of a load is (array,
    offset), of a sum (axis, length, is it a loop?), of a part the offset among all elements of its
    argument, row by row.  An axis without a name is a loop from the length `long` on, an axis with
    a name from the length `named` on.
    """

    def __init__(self, wiring: Wiring, layout: Layout, form: Form):
        super().__init__(wiring, {0: wiring.ninputs})
        self.layout = layout
        self.long, self.named = LOOPED_FROM[form.axes]
        self.locking = form.locking
        self.exact = form.exact
        self.tape = Tape()
        self.entries = self.tape.operations
        self.owners: dict[int, int] = {}  # the blocks that entries come from
        self.decided_by: dict[
            int, tuple
        ] = {}  # entry that may decide -> its long axes, and where
        self.rates: list[Port] = []
        self._jumped: dict[
            int, dict[str, Ref]
        ] = {}  # states of a block after jumps, once known
        self.inputs[0] = self._inputs()
        self.signals = self._rates()
        self.decisions = Decisions(self, layout.inputs(wiring.ninputs))
        self.guards: list[Event] = []
        for k, node in enumerate(wiring.nodes):
            if node.system.guard is not None:
                (margin,) = self.run(k, "guard", self.fed(k))
                self.require(margin, self.decisions.rounding_of(margin))
        if self.locking and not (form.held or form.exact or wiring.dt):
            self.rates = self.lock()
        self._jumped = {k: self._leap(k) for k in range(len(wiring.nodes))}
        self._sample()
        self.leaps: list[Port] = []
        for k, states in self._jumped.items():
            self.leaps += self._stored(k, "states", [*states.values()])

    def add(
        self,
        kind: str,
        arguments: Sequence[Ref],
        shape: tuple,
        at: Any = None,
        owner: int = WIRE,
    ) -> int:
        """Add an entry; return its index."""
        index = len(self.entries)
        self.tape.append(Operation(kind, tuple(arguments), shape, at))
        self.owners[index] = owner
        return index

    def lock(self, **options: Any) -> list[Port]:
        """Return the rates with locked decisions; those of guards are locked as well."""
        margins = [Port(0, (), (), guard.now) for guard in self.guards]
        locked = self.decisions.lock(self.rates + margins, **options)
        for k, port in enumerate(locked[len(self.rates) :]):
            self.guards[k] = self.guards[k]._replace(distance=port.ref)
        return locked[: len(self.rates)]

    def require(self, margin: Ref, rounding: Ref = MARGIN_ROUNDING) -> None:
        """End a run where a margin, by default one without unit, falls below 0."""
        self.guards.append(Event(len(self.guards), (), (), margin, margin, rounding))

    # --- blocks ---------------------------------------------------------------------------

    def _output(self, k: int) -> list[Port]:
        node = self.wiring.nodes[k]
        fed = self.fed(k) if node.system.feedthrough else {}
        values = self.run(k, "output", fed)
        ports = [
            port for port in self._stored(k, "outputs", values) if prod(port.shape)
        ]
        for port in ports:
            self.outputs[port.first] = port.ref
        return ports

    def _rates(self) -> list[Port]:
        """Write the rates of all states; return all signals."""
        signals: dict[
            int, Port
        ] = {}  # of a block that is run twice, those of the second run
        for k in self.wiring.order:
            signals |= {port.first: port for port in self._output(k)}
        for k, node in enumerate(self.wiring.nodes):
            if node.system.update_function is not None:
                rates = self.run(k, "update", self.fed(k))
                self.rates += self._stored(k, "states", rates)
        return [*signals.values()]

    def _leap(self, k: int) -> dict[str, Ref]:
        """Return the states of a block after the jumps that P requests."""
        node = self.wiring.nodes[k]
        request = self.layout.jumps.get(k)
        shapes = node.system.state_shapes
        states = {
            name: self.leaf(k, "x", name, shape) for name, shape in shapes.items()
        }
        if request is not None:
            requested = self.load("P", request, ())
            jumps = self.add("gt", (requested, 0.5), ())
            values = self.run(k, "jump", self.fed(k))
            self._change(k, states, jumps, values)
        return states

    def _change(
        self, k: int, states: dict[str, Ref], condition: Ref, values: list[Ref]
    ) -> None:
        """Change the last states of a block where a condition holds."""
        shapes = self.wiring.nodes[k].system.state_shapes
        names = [*states][-len(values) :]
        for name, value in zip(names, values, strict=True):
            choice = condition, value, states[name]
            states[name] = self.add("where", choice, shapes[name])

    def _sample(self) -> None:
        """Sample the inputs of blocks that sample, with the signals after all jumps."""
        nodes = self.wiring.nodes
        self.outputs = {}
        sampling = [
            k for k, node in enumerate(nodes) if node.system.first_held is not None
        ]
        if not sampling:
            return
        for k in self.wiring.order:
            if k in sampling:
                self._hold(k)
            self._output(k)
        for k in sampling:  # a block that feeds it may come after it in the order
            self._hold(k)

    def _hold(self, k: int) -> None:
        requested = self.load("P", self.layout.jumps[k], ())
        samples = self.add("ne", (requested, 0.0), ())
        inputs = [*self.fed(k).values()]
        self._change(k, self._jumped[k], samples, inputs)

    def _stored(self, k: int, kind: str, values: list[Ref]) -> list[Port]:
        node = self.wiring.nodes[k]
        ports = list[Port]()
        offset = getattr(node, kind).start
        shapes = node.system.declared[kind].values()
        for shape, ref in zip(shapes, values, strict=True):
            lengths, long = self._axes(node.system, shape)
            ports.append(Port(offset, lengths, long, ref))
            offset += prod(lengths)
        return ports

    def _axes(
        self, block: Block, shape: tuple
    ) -> tuple[tuple[int, ...], tuple[bool, ...]]:
        """Return lengths of axes, and which of them loop."""
        lengths = bound(shape, block.sizes)
        long = []
        for length, name in zip(lengths, shape, strict=True):
            is_named = isinstance(name, str)
            limit = min(self.long, self.named) if is_named else self.long
            long.append(length >= limit)
        return lengths, tuple(long)

    def shape(self, block: Block, shape: tuple) -> tuple[int, ...]:
        """Return lengths of axes."""
        return self._axes(block, shape)[0]

    def put(
        self, k: int, role: str, record: Record, operation: Operation, refs: list[Ref]
    ) -> Ref:
        """Write an operation of a block."""
        block = self.wiring.nodes[k].system
        kind, arguments, shape, static = operation
        if kind == "part":
            return self.part(refs[0], static, shape)
        if kind == "sum":
            summed_shape = record.operations[arguments[0]].shape
            lengths, long = self._axes(block, summed_shape)
            static = static, lengths[static], long[static]
        lengths, long = self._axes(block, shape)
        samples = block.first_held is not None  # samples stay for a step
        is_smooth = samples or static == PIVOT or (block.opaque and block.of_package)

        def put(kind: str, *operands: Ref) -> Ref:
            entry = self.add(kind, operands, lengths, static, k)
            if (
                kind not in LOCKED
                or is_smooth
                or self._is_smooth(kind, operands, static)
            ):
                return entry
            self.decided_by[entry] = long, (k, role, kind)
            return entry

        if kind == "search" and self.locking:
            row, value = refs
            key = self.entries[row].at, shift_of(self.entries, value), static
            if table := self.layout.time_tables.get(key):
                return self.load("P", table.offset, ())
        if kind in FOLDS and not self.exact and type(refs[0]) is int:
            inner = self.entries[refs[0]]
            if inner.kind == FOLDS[kind]:
                return _folded(kind, inner.arguments[0], put)
        return put(kind, *refs)

    def _is_smooth(self, kind: str, refs: Sequence[Ref], static: Any) -> bool:
        """Return whether an operation reads a table whose rows lie closer than tolerances tell."""
        if kind == "pick" and type(refs[1]) is int:
            kind, _, _, static = self.entries[refs[1]]
        return kind == "search" and static[1] == "smooth"

    def leaf(self, k: int, group: str, name: str, shape: tuple) -> Ref:
        """Return time, a parameter, or a state, after jumps where these are known."""
        node = self.wiring.nodes[k]
        block = node.system
        array = "t"
        offset = 0
        if group == "p":
            array, offset = self.layout.slots[k, name]
        elif group == "x":
            jumped = self._jumped.get(k, {})
            if name in jumped:
                return jumped[name]
            positions, _ = places(block.state_shapes)[name]
            array = "X"
            offset = node.states.start + positions.start
        lengths = self.shape(block, shape)
        return self.load(array, offset, lengths)

    def load(self, array: str, offset: int, shape: tuple) -> int:
        """Return the entry that reads an array from a place, row by row; equal ones are one."""
        return self.tape.add("load", (), shape, (array, offset))._node

    # --- wires ----------------------------------------------------------------------------

    def _inputs(self) -> int:
        """Return the diagram's inputs: straight lines in time, value + slope (t - begin)."""
        n = self.wiring.ninputs
        ramp = len(self.layout.P)
        begin = self.load("P", ramp, ())
        t = self.load("t", 0, ())
        since = self.add("sub", (t, begin), ())
        slope = self.load("P", ramp + 1 + n, (n,))
        rise = self.add("mul", (since, slope), (n,))
        value = self.load("P", ramp + 1, (n,))
        return self.add("add", (value, rise), (n,))

    def fed(self, k: int) -> dict[str, Ref]:
        """Return the value that feeds each input port of a block."""
        fed = super().fed(k)
        block = self.wiring.nodes[k].system
        records = block.records.values()
        kinds = {
            operation.kind for record in records for operation in record.operations
        }
        if kinds & {"join", "part"}:  # which take whole arrays
            for port, declared in block.declared["inputs"].items():
                value = self.tape.value(fed[port])
                fed[port] = operand(
                    spread(self.tape, value, self.shape(block, declared))
                )
        if kinds & SIGNED:
            for port, ref in fed.items():
                if type(ref) is int:  # sums in Python begin at 0.0, are never -0.0
                    fed[port] = self.add("add", (ref, 0.0), self.entries[ref].shape)
        return fed

    def part(self, ref: Ref, offset: int, shape: tuple) -> Ref:
        """Return elements of a value from a place on, row by row, in a shape."""
        if type(ref) is float:  # such as a view of 0.0
            return ref
        entry = self.entries[ref]
        if entry.shape == shape and offset == 0:
            return ref
        if entry.kind == "load":
            array, start = entry.at  # as it was read: a record in C has moved it in `p`
            return DiagramRecord.load(self, array, start + offset, shape)
        if entry.kind == "view" and len(entry.at) == 1:
            _, start, step = entry.at[0]
            if step == 1:
                return self.part(entry.arguments[0], start + offset, shape)
        return self.add("part", (ref,), shape, offset)


def _folded(kind: str, a: Ref, put: Callable[..., Ref]) -> Ref:
    """Return asin(sin a), acos(cos a) or atan(tan a), whose kinks are those of |x| and a % b."""
    turn = pi if kind == "atan" else 2.0 * pi
    ahead = pi if kind == "acos" else 0.5 * pi
    shifted = put("add", a, ahead)
    angle = put("mod", shifted, turn)
    if kind == "atan":
        return put("sub", angle, 0.5 * pi)
    difference = put("sub", angle, pi)
    away = put("fabs", difference)
    return away if kind == "acos" else put("sub", 0.5 * pi, away)
