"""One record of a diagram: the records of its blocks, merged at their ports.

The record of each block is written again, on what feeds the block.  A port that one port feeds as a
whole is the array of that port.  Gains and sums of wires are arithmetic on arrays; what permutes
signals is put together piece by piece.  `RecordMerger` serves both users.  The engine
(`native.diagram_record`) has numbers for sizes.  The proofs take a tape on which a size stays open,
unless `closed`, if it has a name and one value in all blocks.
"""

from collections.abc import Callable, Mapping, Sequence
from itertools import groupby
from math import prod
from typing import Any

import numpy as np

from ..model.block import Block
from ..model.ports import counts_of, places
from ..record.graph import Operation, Record, Ref, Shape
from ..trace.arrays import Tape, Unread, objects, operand
from ..trace.elementwise import lifted, spread
from .wiring import Node, Part, Row, Wiring

Values = dict[tuple[str, str], Any]  # (block, port) -> Array or number
# functions that make the values with which a record begins
Leaf = Callable[[str, Node, str, Shape], Any]  # of group x or p, a block, its port or field, shape
Input = Callable[[str, Shape, Shape], Any]  # an input of the diagram: port, shape, as declared
# outputs of a block that is not read, of what feeds it and their shapes; None where it is read
StandIn = Callable[[Node, dict[str, Any], dict[str, Shape]], dict[str, Any] | None]


def open_sizes(wiring: Wiring) -> dict[str, int]:
    """Return the sizes that have one name and one value in all blocks."""
    found: dict[str, set[int]] = {}
    for node in wiring.nodes:
        for name, value in node.system.sizes.items():
            found.setdefault(name, set()).add(value)
    return {name: values.pop() for name, values in found.items() if len(values) == 1}


class RecordMerger:
    """Writes the records of a diagram's blocks one after the other, each on what feeds it."""

    # what each user writes in its own way
    add: Callable[..., Ref]  # an operation of no block: kind, arguments, shape, at
    put: Callable[..., Ref]  # one of a block's: k, role, record, operation, its own arguments
    leaf: Callable[..., Ref]  # time, a state or a parameter of a block: k, group, name, shape
    part: Callable[..., Ref]  # elements of a value from a place on, row by row: ref, first, shape
    shape: Callable[..., Shape]  # a shape of a block as this record has it: block, shape

    def __init__(self, wiring: Wiring, outside: Mapping[int, int]):
        """Begin without values; `outside` has the sizes of the diagram's inputs by first signal."""
        self.wiring = wiring
        self.inputs: dict[int, Ref] = {}  # of the diagram, by first signal
        self.outputs: dict[int, Ref] = {}  # of blocks so far, by first signal
        sizes = {
            part.start + node.outputs.start: part.stop - part.start
            for node in wiring.nodes
            for part, _ in places(node.system.output_shapes).values()
        }
        self._sizes = sizes, outside  # of the ports of blocks, and of the diagram, by first signal
        self._firsts = [[at for at, n in own.items() for _ in range(n)] for own in self._sizes]

    # --- a block ------------------------------------------------------------------------------

    def run(self, k: int, role: str, fed: Mapping[str, Ref]) -> list[Ref]:
        """Write a block's record on what feeds it; return the value of each port."""
        record = self.wiring.nodes[k].system.array_record(role)
        values: list[Ref] = []
        for operation in record.operations:
            kind, arguments, shape, at = operation
            if kind == "leaf":
                values.append(fed[at[1]] if at[0] == "u" else self.leaf(k, at[0], at[1], shape))
            else:
                own = [values[a] if type(a) is int else a for a in arguments]
                values.append(self.put(k, role, record, operation, own))
        return [values[ref] if type(ref) is int else ref for ref in record.outputs]

    def fed(self, k: int) -> dict[str, Ref]:
        """Return the value that feeds each input port of a block."""
        node, values, first = self.wiring.nodes[k], {}, 0
        for port, shape in node.system.declared["inputs"].items():
            places = range(first, first := first + prod(node.system.input_shapes[port]))
            values[port] = self.brought(node, port, places, self.shape(node.system, shape))
        return values

    def brought(self, node: Node, port: str, places: range, shape: Shape) -> Ref:
        """Return what feeds the inputs of a port: a whole array if it can, else joined pieces."""
        pieces: list[Ref] = []
        for sources, group in groupby(places, lambda to: self._sources(node.rows[to], to)):
            to, *more = group
            own = shape if len(more) + 1 == len(places) else (len(more) + 1,)
            total: Ref | None = None
            for external, first, ahead, gain in sources:
                ref = (self.inputs if external else self.outputs)[first]
                if type(ref) is not int:
                    ref = self.add("fill", (ref,), (self._sizes[external][first],))
                value = self.part(ref, ahead + to, own)
                value = value if gain == 1.0 else self.add("mul", (value, gain), own)
                total = value if total is None else self.add("add", (total, value), own)
            if len(more) + 1 < len(places) and type(total) is not int:
                total = self.add("fill", (0.0 if total is None else total,), own)
            pieces.append(0.0 if total is None else total)
        if len(pieces) == 1:
            return pieces[0]
        return self.part(self.add("join", pieces, (len(places),)), 0, shape) if pieces else 0.0

    def _sources(self, row: Row, to: int) -> list[tuple[bool, int, int, float]]:
        """Return (if external, first signal of the source's port, place in it less `to`, gain)."""
        found = []
        for k, gain in row.items():
            external, source = k < 0, ~k if k < 0 else k
            first = self._firsts[external][source]
            if first in (self.inputs if external else self.outputs):
                found.append((external, first, source - first - to, gain))
            # else its block is run twice, and this time does not need it
        return sorted(found)


class TapeRecord(RecordMerger):
    """The values of a diagram on one tape, by block and port, with open sizes unless `closed`."""

    def __init__(
        self,
        diagram: Part,
        wiring: Wiring,
        leaf: Leaf,
        input_of: Input,
        tape: Tape,
        stand_in: StandIn = lambda node, u, shapes: None,
        closed: bool = False,
    ):
        """Write the blocks in their order; `leaf`, `input_of`, `stand_in` make the first values."""
        external, at = dict[str, tuple[int, int]](), 0
        for port, size in counts_of(diagram.input_labels).items():
            external[port] = at, size
            at += size
        super().__init__(wiring, dict(external.values()))
        self.tape, self.own_leaf = tape, leaf
        self.open = {} if closed else open_sizes(wiring)
        self.given: dict[str, Any] = {}  # inputs of the diagram, by port
        self.signals: Values = {}  # outputs of blocks
        self.rates: Values = {}
        self.jumps: Values = {}  # what states jump to
        self.fields = {node.name: self.fields_of(node.system) for node in wiring.nodes}
        self.pinned = set[tuple[str, str]]()  # parameters that are numbers
        self.owners: dict[int, str] = {}  # operation -> "block.role"
        for port, (first, size) in external.items():
            self.given[port] = input_of(port, *self.outside_shape(first, size))
            self.inputs[first] = operand(self.given[port])
        for k in wiring.order:
            node, at = wiring.nodes[k], wiring.nodes[k].outputs.start
            u = self.arrays(k) if node.system.feedthrough or node.system.opaque else {}
            declared = node.system.declared["outputs"]
            shapes = {port: self.shape(node.system, shape) for port, shape in declared.items()}
            made = stand_in(node, u, shapes)
            if made is None:
                made = self.ports(k, "output", u)
            for port, value in made.items():
                self.signals[node.name, port] = value
                self.outputs[at] = operand(value)
                at += prod(node.system.output_shapes[port])
        for k, node in enumerate(wiring.nodes):
            u = self.arrays(k)
            for role, into in (("update", self.rates), ("jump", self.jumps)):
                if getattr(node.system, f"{role}_function") is not None:
                    made = self.ports(k, role, u)
                    into.update({(node.name, port): value for port, value in made.items()})

    def fields_of(self, block: Block) -> dict[str, Shape]:
        """Return the shapes of a block's parameters."""
        shapes = block.parameter_shapes
        return {
            own: self.shape(block, shapes.get(own, np.shape(value)))
            for own, value in block.parameters._asdict().items()
        }

    def outside_shape(self, first: int, size: int) -> tuple[Shape, Shape]:
        """Return the shape of a diagram's input, also as the port that it feeds declares it."""
        for node in self.wiring.nodes:
            fed = {source: to for to, source, _ in node.fed(external=True)}
            for own, (at, bound) in places(node.system.input_shapes).items():
                if fed.get(first) == at.start and prod(bound) == size:
                    declared = node.system.declared["inputs"][own]
                    return self.shape(node.system, declared), declared
        return (size,), (size,)

    def shape(self, block: Block, shape: Shape) -> Shape:
        """Return a shape in which only the diagram's open sizes have names."""
        return tuple(n if isinstance(n, int) or n in self.open else block.sizes[n] for n in shape)

    # --- on the tape ----------------------------------------------------------------------------

    def add(self, kind: str, arguments: Sequence[Ref], shape: Shape, at: Any = None) -> Ref:
        """Write an operation."""
        return self.tape.add(kind, arguments, shape, at)._node

    def put(self, k: int, role: str, record: Record, operation: Operation, own: list[Ref]) -> Ref:
        """Write down an operation of a block."""
        shape = self.shape(self.wiring.nodes[k].system, operation.shape)
        return self.add(operation.kind, own, shape, operation.at)

    def leaf(self, k: int, group: str, name: str, shape: Shape) -> Ref:
        """Return time, or the value of a state or a parameter."""
        if group == "t":
            return self.add("leaf", (), (), ("t", "t"))
        node = self.wiring.nodes[k]
        return operand(self.own_leaf(group, node, name, self.shape(node.system, shape)))

    def part(self, ref: Ref, first: int, shape: Shape) -> Ref:
        """Return elements of a value from a place on; an array of an open size has no parts."""
        value = self.tape.value(ref)
        if first == 0 and value.shape == shape:
            return ref
        if any(isinstance(n, str) for n in (*shape, *value.shape)):
            raise Unread("is not fed function by function, whole ports alike")
        own = objects(value).ravel()[first : first + prod(shape)]
        return operand(lifted(self.tape, own.reshape(shape)))

    def brought(self, node: Node, port: str, places: range, shape: Shape) -> Ref:
        """Return what feeds the inputs of a port, in all of its shape."""
        try:
            found = self.tape.value(super().brought(node, port, places, shape))
            return operand(spread(self.tape, found, shape))
        except Unread as error:
            raise Unread(f"{node.name}.{port} {error}") from None

    def arrays(self, k: int) -> dict[str, Any]:
        """Return what feeds each input port of a block, as arrays."""
        return {port: self.tape.value(ref) for port, ref in self.fed(k).items()}

    def ports(self, k: int, role: str, u: dict[str, Any]) -> dict[str, Any]:
        """Return the results of a block's function on this tape, by port."""
        node = self.wiring.nodes[k]
        block, first = node.system, len(self.tape.operations)
        self.check_open(node, role, block.array_record(role))
        pinned, _ = block.read_with.get(role, ((), ""))
        self.pinned |= {(node.name, own) for own in pinned}
        values = self.run(k, role, {port: operand(value) for port, value in u.items()})
        declared = block.declared["outputs" if role == "output" else "states"]
        made = {
            port: spread(self.tape, self.tape.value(value), self.shape(block, shape))
            for (port, shape), value in zip(declared.items(), values, strict=True)
        }
        for place in range(first, len(self.tape.operations)):
            self.owners[place] = f"{node.name}.{role}"
        return made

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
