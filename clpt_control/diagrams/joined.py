"""One record of a diagram: the records of its blocks, joined at their ports as arrays.

Each block's record is written down again on one tape, on what feeds it.  What feeds a port is a sum
of gains times whole ports; where the wires take ports apart it is put together element by element.
A size that has a name, and the same value in all blocks, stays open unless `closed`.
"""

from collections.abc import Callable
from dataclasses import dataclass, field
from math import prod
from typing import Any

import control
import numpy as np

from ..equations.arrays import Tape, Unread, lifted, objects, operand
from ..equations.block import Block
from ..equations.declaration import ports_of
from ..equations.record import Record, Shape
from .wiring import Node, Wiring

Values = dict[tuple[str, str], Any]  # (block, port) -> Array or number
# what makes the values with which a record begins
Leaf = Callable[[str, Node, str, Shape], Any]  # of group x or p, a block, its port or field, shape
Given = Callable[[str, Shape, Shape], Any]  # an input of the diagram: port, shape, as declared
# outputs of a block that is not read, of what feeds it and their shapes; None where it is read
StandIn = Callable[[Node, dict[str, Any], dict[str, Shape]], dict[str, Any] | None]


@dataclass
class Joined:
    """The values of a diagram on one tape, by block and port."""

    tape: Tape
    inputs: dict[str, Any] = field(default_factory=dict)  # of the diagram, by port
    fed: Values = field(default_factory=dict)  # what feeds the blocks
    signals: Values = field(default_factory=dict)  # what they put out
    rates: Values = field(default_factory=dict)
    jumps: Values = field(default_factory=dict)  # what states jump to
    fields: dict[str, dict[str, Shape]] = field(default_factory=dict)  # of parameters, by block
    pinned: set[tuple[str, str]] = field(default_factory=set)  # parameters that are numbers
    owners: dict[int, str] = field(default_factory=dict)  # operation -> "block.role"


def open_sizes(wiring: Wiring) -> dict[str, int]:
    """Return the sizes that have one name and one value in all blocks."""
    found: dict[str, set[int]] = {}
    for node in wiring.nodes:
        for name, value in getattr(node.system, "sizes", {}).items():
            found.setdefault(name, set()).add(value)
    return {name: values.pop() for name, values in found.items() if len(values) == 1}


def external_ports(diagram: control.NonlinearIOSystem) -> dict[str, int]:
    """Return the diagram's input ports and their numbers of signals."""
    return {port: len(own) for port, own in ports_of(diagram.input_labels).items()}


class Joining:
    """A diagram's blocks, put on one tape."""

    def __init__(self, wiring: Wiring, tape: Tape, leaf: Leaf, closed: bool = False):
        self.wiring, self.tape, self.leaf = wiring, tape, leaf
        self.open = {} if closed else open_sizes(wiring)
        self.found = Joined(tape)
        self.places = [  # of each signal of the bus: block, port, place in it
            (node, port, k)
            for node in wiring.nodes
            for port, size in node.system.output_ports.items()
            for k in range(size)
        ]
        self.outside: list[tuple[str, int]] = []

    def shape(self, block: Block, shape: Shape) -> Shape:
        """Return a shape in which only the diagram's open sizes have names."""
        return tuple(n if isinstance(n, int) or n in self.open else block.sizes[n] for n in shape)

    def joined(
        self,
        external: dict[str, int],
        given: Given,
        stand_in: StandIn,
    ) -> Joined:
        """Put the blocks on the tape in their order."""
        self.outside = [(port, k) for port, size in external.items() for k in range(size)]
        found = self.found
        for port, size in external.items():
            found.inputs[port] = given(port, *self.outside_shape(port, size))
        for k in self.wiring.order:
            node = self.wiring.nodes[k]
            u = self.fed(node) if node.system.feedthrough or node.system.opaque else {}
            declared = node.system.declared["outputs"]
            shapes = {port: self.shape(node.system, shape) for port, shape in declared.items()}
            made = stand_in(node, u, shapes)
            if made is None:
                made = self.run(node, "output", u)
            found.signals.update({(node.name, port): value for port, value in made.items()})
        for node in self.wiring.nodes:
            found.fields[node.name] = self.fields(node.system)
            u = self.fed(node)
            found.fed.update({(node.name, port): value for port, value in u.items()})
            for role, into in (("update", found.rates), ("jump", found.jumps)):
                if getattr(node.system, f"{role}_function") is not None:
                    made = self.run(node, role, u)
                    into.update({(node.name, port): value for port, value in made.items()})
        return found

    def fields(self, block: Block) -> dict[str, Shape]:
        """Return the shapes of a block's parameters."""
        shapes = block.parameter_shapes
        return {
            own: self.shape(block, shapes.get(own, np.shape(value)))
            for own, value in block.parameters._asdict().items()
        }

    def outside_shape(self, port: str, size: int) -> tuple[Shape, Shape]:
        """Return the shape of an input of the diagram, and as the port that it feeds has it."""
        first = self.outside.index((port, 0))
        for node in self.wiring.nodes:
            for wire in node.wires:
                if wire.external and wire.source <= first < wire.source + wire.size:
                    at, start = first - wire.source + wire.to, 0
                    for own, n in node.system.input_ports.items():
                        if start == at and n == size:
                            declared = node.system.declared["inputs"][own]
                            return self.shape(node.system, declared), declared
                        start += n
        return (size,), (size,)

    # --- what feeds a block -----------------------------------------------------------------

    def fed(self, node: Node) -> dict[str, Any]:
        """Return what feeds each input port of a block."""
        block, found, at = node.system, {}, 0
        for port, size in block.input_ports.items():
            shape = self.shape(block, block.declared["inputs"][port])
            found[port] = self.port(node, port, slice(at, at := at + size), shape)
        return found

    def port(self, node: Node, port: str, places: slice, shape: Shape) -> Any:
        """Return the sum of what feeds a port."""
        parts: list[tuple[Any, list[tuple[int, int]], float]] = []
        for wire in node.wires:
            pairs: dict[tuple[str, str], list[tuple[int, int]]] = {}
            for j in range(max(wire.to, places.start), min(wire.to + wire.size, places.stop)):
                source = wire.source + j - wire.to
                if wire.external:
                    name, k = self.outside[source]
                    key = ("", name)
                else:
                    other, name, k = self.places[source]
                    key = (other.name, name)
                pairs.setdefault(key, []).append((j - places.start, k))
            for (owner, name), pair in pairs.items():
                known: Any = self.found.inputs if not owner else self.found.signals
                place: Any = (owner, name) if owner else name
                if place in known:  # else its block is run twice, and now for what does not need it
                    parts.append((known[place], pair, wire.gain))
        size = places.stop - places.start
        total: Any = None
        whole = [(k, k) for k in range(size)]
        if all(pair == whole and self.fits(value, shape) for value, pair, _ in parts):
            for value, _, gain in parts:
                gained = value if gain == 1.0 else value * gain
                total = gained if total is None else total + gained
            return self.filled(0.0, shape) if total is None else total
        return self.gathered(node, port, parts, shape)

    def fits(self, value: Any, shape: Shape) -> bool:
        """Return whether a value has a shape."""
        return getattr(value, "shape", ()) == shape

    def gathered(self, node: Node, port: str, parts: list, shape: Shape) -> Any:
        """Return a port that is fed signal by signal."""
        if any(isinstance(n, str) for v, *_ in parts for n in (*shape, *getattr(v, "shape", ()))):
            raise Unread(f"{node.name}.{port} is not fed function by function, whole ports alike")
        flat = np.full(prod(shape), 0.0, dtype=object)
        fresh = np.ones(len(flat), dtype=bool)
        for value, pairs, gain in parts:
            own = objects(value).ravel()
            for to, k in pairs:
                gained = own[k] if gain == 1.0 else own[k] * gain
                flat[to] = gained if fresh[to] else flat[to] + gained
                fresh[to] = False
        return lifted(self.tape, flat.reshape(shape))

    # --- a block's record --------------------------------------------------------------------

    def run(self, node: Node, role: str, u: dict[str, Any]) -> dict[str, Any]:
        """Return what a block's function returns on this tape, by port."""
        block = node.system
        kind = "outputs" if role == "output" else "states"
        record, first = block.array_record(role), len(self.tape.operations)
        self.check_open(node, role, record)
        pinned, _ = block.read_with.get(role, ((), ""))
        self.found.pinned |= {(node.name, own) for own in pinned}

        def leaf(group: str, name: str, shape: Shape) -> Any:
            if group == "t":
                return self.tape.add("leaf", (), (), ("t", "t"))
            return u[name] if group == "u" else self.leaf(group, node, name, shape)

        values = self.replayed(block, record, leaf)
        made = {}
        for port, value in zip(block.declared[kind], values, strict=True):
            made[port] = self.filled(value, self.shape(block, block.declared[kind][port]))
        for k in range(first, len(self.tape.operations)):
            self.found.owners[k] = f"{node.name}.{role}"
        return made

    def replayed(self, block: Block, record: Record, leaf: Callable[..., Any]) -> list[Any]:
        """Write a record down again; return its outputs."""
        values: list[Any] = []
        for kind, arguments, shape, at in record.operations:
            own = self.shape(block, shape)
            if kind == "leaf":
                values.append(leaf(*at, own))
            else:
                refs = [operand(values[a]) if type(a) is int else a for a in arguments]
                values.append(self.tape.add(kind, refs, own, at))
        return [values[ref] if type(ref) is int else ref for ref in record.outputs]

    def filled(self, value: Any, shape: Shape) -> Any:
        """Return a value of fewer axes in all of its shape."""
        if getattr(value, "shape", ()) == shape:
            return value
        if getattr(value, "shape", ()) == ():
            return self.tape.add("fill", (operand(value),), shape)
        return self.tape.add("add", (operand(value), operand(self.filled(0.0, shape))), shape)

    def check_open(self, node: Node, role: str, record: Record) -> None:
        """Refuse a record for one size where the block's sizes shall stay open."""
        block = node.system
        declared = {"x": block.declared["states"], "u": block.declared["inputs"]}
        for kind, _, shape, at in record.operations:
            if kind != "leaf" or at[0] not in declared:
                continue
            if self.shape(block, declared[at[0]][at[1]]) != self.shape(block, shape):
                _, why = block.read_with.get(role, ((), ""))
                sizes = " and ".join(self.open)
                raise Unread(f"{node.name}.{role} is not read for every {sizes}: {why}")


def joined(
    diagram: control.NonlinearIOSystem,
    wiring: Wiring,
    leaf: Leaf,
    given: Given,
    stand_in: StandIn = lambda node, u, shapes: None,
    tape: Tape | None = None,
    closed: bool = False,
) -> Joined:
    """Return a diagram's record; `leaf`, `given` and `stand_in` make what it begins with."""
    joining = Joining(wiring, tape or Tape(), leaf, closed)
    return joining.joined(external_ports(diagram), given, stand_in)
