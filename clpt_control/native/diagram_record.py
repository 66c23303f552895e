"""One record of a diagram: its blocks' records, joined at their ports as arrays.

    v0 = load X[0:2]            v1 = add(v0, v7)            v2 = sum(v1 over 0)

A port whose signals come whole from one port is that array; gains and sums of wires are arithmetic
on arrays; what permutes is put together piece by piece.  An axis is long, and loops, where a size
has a name or the number is beyond `SHORT`.  Every entry knows the block it comes from, so that
terms of different blocks can be told apart (`joined_sums`); wires belong to none.
"""

import itertools
from bisect import bisect
from collections.abc import Sequence
from math import prod
from typing import Any, NamedTuple

from ..diagrams.wiring import Node, Wiring
from ..equations.block import Block
from ..equations.record import reached
from .decisions import Decisions
from .layout import Layout

SHORT, NAMED = 16, 3  # an axis up to SHORT is unrolled, but from NAMED on where it has a name
SIGNED = frozenset({"atan2", "pow", "floordiv", "mod"})  # tell -0.0 from 0.0, as divisors do
WIRE = -1  # the owner of what wires do
Ref = Any  # the place of an entry (int), or a constant (float)


class Entry(NamedTuple):
    """One line of the record; kinds as in `equations.record`, with loads in place of leaves.

    `at` of a load is (array, first place); of a sum (axis, length, whether it loops); of a part
    the first place among all elements of its argument, row by row.
    """

    kind: str
    arguments: tuple[Ref, ...]
    shape: tuple[int, ...]
    at: Any
    owner: int


class Port(NamedTuple):
    """A value that is stored: its first place, lengths of its axes, and which of them loop."""

    first: int
    shape: tuple[int, ...]
    long: tuple[bool, ...]
    ref: Ref


def _places(node: Node) -> range:
    return range(node.outputs.start, node.outputs.stop)


class DiagramRecord:
    """All entries of a diagram, and what its functions store.

    Axes loop from the length `long` on, where they have a name from `named` on.
    """

    def __init__(
        self,
        wiring: Wiring,
        layout: Layout,
        long: int = SHORT + 1,
        named: int = NAMED,
        locking: bool = True,
    ):
        self.wiring, self.layout, self.long, self.named = wiring, layout, long, named
        self.entries: list[Entry] = []
        self.moving: list[bool] = []  # of each entry: whether it changes along a run
        self.rates: list[Port] = []
        self.signals: list[Port] = []
        self.margins: list[Ref] = []
        self._known: dict[Entry, int] = {}
        self._ports: dict[int, Ref] = {}
        self.decisions = Decisions(self, layout.inputs(wiring.ninputs))
        self._jumped: dict[int, dict[str, Ref]] = {}  # states of a block after jumps, once known
        self._external = self._inputs()
        self._sizes: dict[int, int] = {}  # of output ports, by their first signal
        for node in wiring.nodes:
            at = node.outputs.start
            for shape in node.system.output_shapes.values():
                if prod(shape):
                    self._sizes[at] = prod(shape)
                at += prod(shape)
        self._firsts = list(self._sizes)
        self._rates()
        exact, ports, rates = self.signals, self._ports, self.rates
        self.margins = [m for k in range(len(wiring.nodes)) for m in self._margins(k)]
        self.decided = 0  # numbers that are decided, of rates that are locked
        if locking and not wiring.dt and self.decisions.lock():
            self._ports, self.signals, self.rates = {}, [], []
            self._rates()
            self.decided = self.decisions.kept([port.ref for port in self.rates])
            self._ports, self.signals = ports, exact
        if not self.decided:
            self.rates = rates
        self._jumped = {k: self._leap(k) for k in range(len(wiring.nodes))}
        self._sample()
        self.leaps = [
            port
            for k, node in enumerate(wiring.nodes)
            for port in self._stored(
                node.system, "states", node.states.start, [*self._jumped[k].values()]
            )
        ]

    def add(
        self, kind: str, arguments: Sequence[Ref], shape: tuple, at: Any = None, owner: int = WIRE
    ) -> int:
        """Add an entry; return its place."""
        self.entries.append(Entry(kind, tuple(arguments), shape, at, owner))
        own = kind == "load" and (at[0] in "Xt" or (at[0] == "P" and at[1] > self.decisions.grain))
        self.moving.append(own or any(map(self.is_moving, arguments)))
        return len(self.entries) - 1

    def is_moving(self, ref: Ref) -> bool:
        """Whether a value changes along a run."""
        return type(ref) is int and self.moving[ref]

    def shape_of(self, ref: Ref) -> tuple[int, ...]:
        """Return the shape of a value."""
        return self.entries[ref].shape if type(ref) is int else ()

    # --- blocks ---------------------------------------------------------------------------

    def _output(self, k: int, deciding: bool = True) -> list[Port]:
        node = self.wiring.nodes[k]
        fed = self._fed(node) if node.system.feedthrough else {}
        values = self._run(k, "output", fed, deciding)
        ports = self._stored(node.system, "outputs", node.outputs.start, values)
        self._ports.update({port.first: port.ref for port in ports if prod(port.shape)})
        return ports

    def _rates(self) -> None:
        """Write down what the rates of all states are."""
        for k in self.wiring.order:
            own = _places(self.wiring.nodes[k])
            before = [port for port in self.signals if port.first not in own]
            self.signals = before + self._output(k)
        for k, node in enumerate(self.wiring.nodes):
            if node.system.update_function is not None:
                values = self._run(k, "update", self._fed(node), True)
                self.rates += self._stored(node.system, "states", node.states.start, values)

    def _margins(self, k: int) -> list[Ref]:
        node = self.wiring.nodes[k]
        return self._run(k, "guard", self._fed(node)) if node.system.guard is not None else []

    def _leap(self, k: int) -> dict[str, Ref]:
        """Return the states of a block after the jumps that P asks for."""
        node, place = self.wiring.nodes[k], self.layout.jumps.get(k)
        shapes = node.system.state_shapes
        states = {name: self._leaf(k, "x", name, shape, {}) for name, shape in shapes.items()}
        if place is not None:
            asked = self.add("gt", (self.load("P", place, ()), 0.5), ())
            new = self._run(k, "jump", self._fed(node))
            for (name, shape), value in zip(shapes.items(), new, strict=True):
                states[name] = self.add("where", (asked, value, states[name]), shape)
        return states

    def _sample(self) -> None:
        """Hold what feeds the blocks that sample, signals being those of the states jumped to."""
        nodes, self._ports = self.wiring.nodes, {}
        sampling = [k for k, node in enumerate(nodes) if node.system.kept is not None]
        for k in self.wiring.order if sampling else ():
            if k in sampling:
                self._hold(k)
            self._output(k, deciding=False)
        for k in sampling:  # what feeds it may have come after it
            self._hold(k)

    def _hold(self, k: int) -> None:
        node, P = self.wiring.nodes[k], self.load("P", self.layout.jumps[k], ())
        sampled = self.add("ne", (P, 0.0), ())
        fed, states = self._fed(node).values(), self._jumped[k]
        for name, value in zip([*states][-len(fed) :], fed, strict=True):
            shape = node.system.state_shapes[name]
            states[name] = self.add("where", (sampled, value, states[name]), shape)

    def _stored(self, block: Block, kind: str, first: int, values: list[Ref]) -> list[Port]:
        ports = []
        for shape, ref in zip(block.declared[kind].values(), values, strict=True):
            ports.append(Port(first, *self._axes(block, shape), ref))
            first += prod(ports[-1].shape)
        return ports

    def _axes(self, block: Block, shape: tuple) -> tuple[tuple[int, ...], tuple[bool, ...]]:
        """Return lengths of axes, and which of them loop."""
        own = tuple(n if isinstance(n, int) else block.sizes[n] for n in shape)
        long = zip(own, shape, strict=True)
        return own, tuple(
            n >= self.long or (isinstance(name, str) and n >= self.named) for n, name in long
        )

    def _run(self, k: int, role: str, fed: dict[str, Ref], deciding: bool = False) -> list[Ref]:
        """Write down a block's record on what feeds it; return what each port is."""
        node = self.wiring.nodes[k]
        record = node.system.array_record(role)
        values: list[Ref] = []
        axes = [self._axes(node.system, o.shape) for o in record.operations]
        deciding = deciding and not (node.system.opaque and node.system.of_package)
        deciding = deciding and node.system.kept is None  # what is sampled stays for a step
        for (kind, arguments, _, at), (shape, looping) in zip(record.operations, axes, strict=True):
            if kind == "leaf":
                values.append(self._leaf(k, at[0], at[1], shape, fed))
                continue
            own = [values[a] if type(a) is int else a for a in arguments]
            if kind == "opaque":
                values.append(own[0])
                continue
            if deciding:
                locked = self.decisions.read(kind, own, (shape, looping), k, role)
                if locked is not None:
                    values.append(locked)
                    continue
            if kind == "sum":
                length, long = axes[arguments[0]] if type(arguments[0]) is int else ((), ())
                at = at, length[at], long[at]
            values.append(self.add(kind, own, shape, at, k))
        return [values[ref] if type(ref) is int else ref for ref in record.outputs]

    def _leaf(self, k: int, group: str, name: str, shape: tuple, fed: dict[str, Ref]) -> Ref:
        if group == "u":
            return fed[name]
        array, first = "t", 0
        if group == "p":
            array, first = self.layout.slots[k, name]
        elif group == "x" and name in self._jumped.get(k, {}):
            return self._jumped[k][name]
        elif group == "x":
            block = self.wiring.nodes[k].system
            before = list(block.state_shapes)
            sizes = [prod(block.state_shapes[port]) for port in before[: before.index(name)]]
            array, first = "X", self.wiring.nodes[k].states.start + sum(sizes)
        return self.load(array, first, shape)

    def load(self, array: str, first: int, shape: tuple) -> int:
        """Return the numbers of an array from a place, row by row; the same once."""
        entry = Entry("load", (), shape, (array, first), WIRE)
        if entry not in self._known:
            self._known[entry] = self.add(*entry[:4])
        return self._known[entry]

    # --- wires ----------------------------------------------------------------------------

    def _inputs(self) -> int:
        """Return the diagram's inputs: straight lines in time, value + slope (t - begin)."""
        n, ramp = self.wiring.ninputs, len(self.layout.P)
        begin, t = self.load("P", ramp, ()), self.load("t", 0, ())
        since = self.add("sub", (t, begin), ())
        rise = self.add("mul", (since, self.load("P", ramp + 1 + n, (n,))), (n,))
        return self.add("add", (self.load("P", ramp + 1, (n,)), rise), (n,))

    def _fed(self, node: Node) -> dict[str, Ref]:
        """Return what feeds each input port of a block."""
        found, first = {}, 0
        signed = self._signed(node.system)
        for port, shape in node.system.input_shapes.items():
            ref = self._brought(node, first, shape)
            if signed and type(ref) is int:  # sums in Python begin at 0.0, are never -0.0
                ref = self.add("add", (ref, 0.0), shape)
            found[port] = ref
            first += prod(shape)
        return found

    def _signed(self, block: Block) -> bool:
        """Return whether a block tells -0.0 from 0.0."""
        roles = [*block._roles] if block.output_function else [*block._roles, "output"]
        for lines in (block.array_record(role).operations for role in roles):
            for kind, arguments, _, _ in lines:
                divisor = [a for a in arguments[1:] if kind == "div" and type(a) is int]
                if kind in SIGNED or any(_moves(lines, a) for a in divisor):
                    return True
        return False

    def _brought(self, node: Node, first: int, shape: tuple) -> Ref:
        """Return what wires bring to a port: arrays where they lie whole, else pieces joined."""
        size = prod(shape)
        terms = [t for wire in node.wires for t in self._terms(wire, first, first + size)]
        cuts = sorted({0, size, *(at for t in terms for at in (t[0], t[0] + t[1]))})
        pieces: list[Ref] = []
        for start, stop in itertools.pairwise(cuts):
            own = shape if stop - start == size else (stop - start,)
            total: Ref | None = None
            for to, n, gain, ref, at in terms:
                if to <= start and stop <= to + n:
                    value = self.part(ref, at + start - to, own)
                    value = value if gain == 1.0 else self.add("mul", (value, gain), own)
                    total = value if total is None else self.add("add", (total, value), own)
            if len(cuts) > 2 and type(total) is not int:
                total = self.add("fill", (0.0 if total is None else total,), own)
            pieces.append(0.0 if total is None else total)
        if len(pieces) == 1:
            return pieces[0]
        return self.part(self.add("join", pieces, (size,)), 0, shape) if pieces else 0.0

    def _terms(self, wire: Any, first: int, last: int) -> list[tuple[int, int, float, Ref, int]]:
        """Return (place, count, gain, source port, place in it) of a wire within [first, last)."""
        found = []
        at, stop = max(wire.to, first), min(wire.to + wire.size, last)
        while at < stop:
            source, n = wire.source + at - wire.to, stop - at
            ref: Ref = self._external
            if not wire.external:
                start = self._firsts[bisect(self._firsts, source) - 1]
                n, source = min(n, start + self._sizes[start] - source), source - start
                ref = self._ports.get(start, 0.0)  # none yet, where only half of a block is run
                shape = (self._sizes[start],)
                ref = ref if type(ref) is int else self.add("fill", (ref,), shape)
            found.append((at - first, n, wire.gain, ref, source))
            at += n
        return found

    def part(self, ref: int, first: int, shape: tuple) -> int:
        """Return elements of a value from a place on, row by row, in a shape."""
        entry = self.entries[ref]
        if entry.shape == shape and first == 0:
            return ref
        if entry.kind == "load":
            array, start = entry.at
            return self.load(array, start + first, shape)
        return self.add("part", (ref,), shape, first)


def _moves(lines: Sequence[Any], ref: int) -> bool:
    """Return whether a value depends on more than parameters."""
    return any(lines[k].kind == "leaf" and lines[k].at[0] != "p" for k in reached(lines, [ref]))
