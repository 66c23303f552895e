"""Record of a diagram: the records of its blocks, connected at their ports.

The record of each block is written again with its sources in place of its inputs.  If one port
feeds a whole input port, the array of that port is the input.  Gains and sums of wires are
arithmetic on arrays.  Permuted signals are joined from pieces.

`RecordMerger` has two users.  The code generator (`codegen.diagram_record`) has numbers for sizes.
`TapeRecord` writes on a tape.  There a size stays open, unless `closed`, if it has the same name
and value in all blocks.
"""

from collections.abc import Callable, Mapping, Sequence
from functools import partial
from itertools import groupby
from math import prod
from typing import Any, NamedTuple

from ..model.block import Block
from ..model.ports import places, spans_of
from ..record.graph import Operation, Record, Ref, Shape, replayed
from ..record.unread import Unread
from ..trace.arrays import Tape, objects, operand
from ..trace.elementwise import lifted, spread
from .wiring import Node, Part, Row, Wiring

Values = dict[tuple[str, str], Any]  # (block, port) -> Array or number
# name_of(group, node, name): name of the leaf of a state ("x") or a parameter ("p") of a block
NameOf = Callable[[str, Node, str], Any]
# outputs of a block without a record, from its inputs and output shapes; None for other blocks
StandIn = Callable[[Node, dict[str, Any], dict[str, Shape]], dict[str, Any] | None]


def open_sizes(wiring: Wiring) -> dict[str, int]:
    """Return the sizes that have one name and one value in all blocks."""
    nodes = wiring.nodes
    sizes = dict.fromkeys(size for node in nodes for size in node.system.sizes.items())
    names = [name for name, _ in sizes]
    return {name: value for name, value in sizes if names.count(name) == 1}


class Source(NamedTuple):
    """Signals of a port, as the source of an input k of a block."""

    external: bool  # an input port of the diagram, or an output port of a block
    start: int  # first signal of the port
    offset: int  # of the signal in the port, minus k: equal for consecutive signals
    gain: float


class RecordMerger:
    """Writes the records of a diagram's blocks one after the other, each with its sources."""

    # methods of the two users
    add: Callable[..., Ref]  # write an operation: kind, arguments, shape, at
    # write a block's operation: k, role, record, operation, arguments
    put: Callable[..., Ref]
    # time, a state or a parameter of a block: k, group, name, shape
    leaf: Callable[..., Ref]
    # elements of a value from an offset on: ref, offset, shape
    part: Callable[..., Ref]
    shape: Callable[..., Shape]  # a shape of a block in this record: block, shape

    def __init__(self, wiring: Wiring, input_sizes: Mapping[int, int]):
        """Begin without values; `input_sizes` has the diagram's input ports by first signal."""
        self.wiring = wiring
        self.inputs: dict[int, Ref] = {}  # of the diagram, by first signal
        self.outputs: dict[int, Ref] = {}  # of blocks so far, by first signal
        output_sizes = {
            node.outputs.start + signals.start: signals.stop - signals.start
            for node in wiring.nodes
            for signals, _ in places(node.system.output_shapes).values()
        }
        # sizes of ports by first signal, and the first signal of each signal's port
        self._sizes = output_sizes, input_sizes
        self._starts = [
            [start for start, size in sizes.items() for _ in range(size)]
            for sizes in self._sizes
        ]

    # --- a block ------------------------------------------------------------------------------

    def run(self, k: int, role: str, fed: Mapping[str, Ref]) -> list[Ref]:
        """Write a block's record with its inputs; return the value of each port."""
        record = self.wiring.nodes[k].system.array_record(role)

        def leaf(group: str, name: str, shape: Shape) -> Ref:
            return fed[name] if group == "u" else self.leaf(k, group, name, shape)

        return replayed(record, leaf, partial(self.put, k, role, record))

    def fed(self, k: int) -> dict[str, Ref]:
        """Return the value of each input port of a block."""
        node = self.wiring.nodes[k]
        block = node.system
        declared = block.declared["inputs"]
        return {
            port: self.joined(
                node,
                port,
                range(signals.start, signals.stop),
                self.shape(block, declared[port]),
            )
            for port, (signals, _) in places(block.input_shapes).items()
        }

    def joined(self, node: Node, port: str, inputs: range, shape: Shape) -> Ref:
        """Return the value of the inputs of a port: an array, or several joined."""
        values = []
        for sources, group in groupby(inputs, lambda k: self._sources(node.rows[k], k)):
            indices = [*group]
            if len(indices) == len(inputs):
                return self._sum(sources, indices[0], shape)
            size = (len(indices),)
            value = self._sum(sources, indices[0], size)
            values.append(self._as_array(value, size))
        if not values:
            return 0.0
        vector = self.add("join", values, (len(inputs),))
        return self.part(vector, 0, shape)

    def _as_array(self, value: Ref, shape: Shape) -> Ref:
        return value if type(value) is int else self.add("fill", (value,), shape)

    def _sum(self, sources: list[Source], k: int, shape: Shape) -> Ref:
        """Return the sum of the sources of consecutive inputs, the first of which is k."""
        total = None
        for external, start, offset, gain in sources:
            known_values = self.inputs if external else self.outputs
            size = (self._sizes[external][start],)
            ref = self._as_array(known_values[start], size)
            value = self.part(ref, offset + k, shape)
            if gain != 1.0:
                value = self.add("mul", (value, gain), shape)
            if total is not None:
                value = self.add("add", (total, value), shape)
            total = value
        return 0.0 if total is None else total

    def _sources(self, row: Row, k: int) -> list[Source]:
        """Return the sources of an input k that have values.

        A block that is evaluated in two steps may have a source without a value in the first.
        """
        sources = []
        for signal, gain in row.items():
            external = signal < 0
            number = ~signal if external else signal
            start = self._starts[external][number]
            known_values = self.inputs if external else self.outputs
            if start in known_values:
                offset = number - start - k
                sources.append(Source(external, start, offset, gain))
        return sorted(sources)


class TapeRecord(RecordMerger):
    """The values of a diagram on one tape, by block and port, with open sizes unless `closed`."""

    def __init__(
        self,
        diagram: Part,
        wiring: Wiring,
        tape: Tape,
        name_of: NameOf = lambda group, node, name: (node.name, name),
        stand_in: StandIn = lambda node, u, shapes: None,
        closed: bool = False,
    ):
        """Write the blocks in their order."""
        spans = spans_of(diagram.input_labels)
        sizes = {span.start: span.stop - span.start for span in spans.values()}
        super().__init__(wiring, sizes)
        self.tape = tape
        self.name_of = name_of
        self.open = {} if closed else open_sizes(wiring)
        # (group, name) of a leaf -> the block and its name there, and the leaf
        self.leaves: dict[Any, tuple[Node, str, Any]] = {}
        # inputs of the diagram, by port, and the shapes that their users declare
        self.external: dict[str, Any] = {}
        self.declared: dict[str, Shape] = {}
        self.signals: Values = {}  # outputs of blocks
        self.rates: Values = {}
        self.jumps: Values = {}  # states after a jump
        self.levels: Values = {}  # distances of guards at which states jump
        self.pinned = set[tuple[str, str]]()  # parameters that are numbers
        self.owners: dict[int, str] = {}  # operation -> "block.role"

        for port, start in zip(spans, sizes, strict=True):
            shape, self.declared[port] = self._input_shape(start, sizes[start])
            self.external[port] = tape.add("leaf", (), shape, ("u", port))
            self.inputs[start] = operand(self.external[port])
        for k in wiring.order:
            self._write_outputs(k, stand_in)
        for k, node in enumerate(wiring.nodes):
            fed = self.fed(k)
            for role, results in (
                ("update", self.rates),
                ("jump", self.jumps),
                ("guard", self.levels if node.system.jumps_at_level else None),
            ):
                if role in node.system._roles and results is not None:
                    for port, value in self._results(k, role, fed).items():
                        results[node.name, port] = value

    def _write_outputs(self, k: int, stand_in: StandIn) -> None:
        node = self.wiring.nodes[k]
        block = node.system
        needs_inputs = block.feedthrough or block.opaque
        fed = self.fed(k) if needs_inputs else {}
        u = {port: self.tape.value(ref) for port, ref in fed.items()}
        declared = block.declared["outputs"]
        shapes = {port: self.shape(block, shape) for port, shape in declared.items()}
        values = stand_in(node, u, shapes)
        if values is None:
            values = self._results(k, "output", fed)
        for port, (signals, _) in places(block.output_shapes).items():
            start = node.outputs.start + signals.start
            self.signals[node.name, port] = values[port]
            self.outputs[start] = operand(values[port])

    def _input_shape(self, start: int, size: int) -> tuple[Shape, Shape]:
        """Return the shape of a diagram's input, and the shape that its user declares."""
        for node in self.wiring.nodes:
            block = node.system
            inputs = {source: to for to, source, _ in node.fed(external=True)}
            for port, (signals, shape) in places(block.input_shapes).items():
                if inputs.get(start) == signals.start and prod(shape) == size:
                    declared = block.declared["inputs"][port]
                    return self.shape(block, declared), declared
        return (size,), (size,)

    def shape(self, block: Block, shape: Shape) -> Shape:
        """Return a shape in which only the diagram's open sizes have names."""
        return tuple(
            n if isinstance(n, int) or n in self.open else block.sizes[n] for n in shape
        )

    # --- on the tape ----------------------------------------------------------------------------

    def add(
        self, kind: str, arguments: Sequence[Ref], shape: Shape, at: Any = None
    ) -> Ref:
        """Write an operation."""
        return self.tape.add(kind, arguments, shape, at)._node

    def put(
        self,
        k: int,
        role: str,
        record: Record,
        operation: Operation,
        arguments: list[Ref],
    ) -> Ref:
        """Write an operation of a block."""
        shape = self.shape(self.wiring.nodes[k].system, operation.shape)
        return self.add(operation.kind, arguments, shape, operation.at)

    def leaf(self, k: int, group: str, name: str, shape: Shape) -> Ref:
        """Return time, or the value of a state or a parameter."""
        if group == "t":
            return self.add("leaf", (), (), ("t", "t"))
        node = self.wiring.nodes[k]
        shape = self.shape(node.system, shape)
        key = group, self.name_of(group, node, name)
        leaf = self.tape.add("leaf", (), shape, key)
        self.leaves[key] = node, name, leaf
        return operand(leaf)

    def part(self, ref: Ref, offset: int, shape: Shape) -> Ref:
        """Return elements of a value; an array of an open size is returned as a whole only."""
        value = self.tape.value(ref)
        if offset == 0 and value.shape == shape:
            return ref
        if any(isinstance(n, str) for n in (*shape, *value.shape)):
            raise Unread("is not fed function by function, whole ports alike")
        end = offset + prod(shape)
        elements = objects(value).ravel()[offset:end]
        array = lifted(self.tape, elements.reshape(shape))
        return operand(array)

    def joined(self, node: Node, port: str, inputs: range, shape: Shape) -> Ref:
        """Return the value of the inputs of a port, in all of its shape."""
        try:
            ref = super().joined(node, port, inputs, shape)
            value = spread(self.tape, self.tape.value(ref), shape)
            return operand(value)
        except Unread as error:
            raise Unread(f"{node.name}.{port} {error}") from None

    def _results(self, k: int, role: str, fed: dict[str, Ref]) -> dict[str, Any]:
        """Return the results of a block's function on this tape, by port."""
        begin = len(self.tape.operations)
        node = self.wiring.nodes[k]
        block = node.system
        self._check_open(node, role, block.array_record(role))
        pinned, _ = block.read_with.get(role, ((), ""))
        self.pinned |= {(node.name, name) for name in pinned}
        refs = self.run(k, role, fed)
        kind = "outputs" if role == "output" else "states"
        ports = {"distance": ()} if role == "guard" else block.declared[kind]
        results = {
            port: spread(self.tape, self.tape.value(ref), self.shape(block, shape))
            for (port, shape), ref in zip(ports.items(), refs, strict=True)
        }
        for index in range(begin, len(self.tape.operations)):
            self.owners[index] = f"{node.name}.{role}"
        return results

    def _check_open(self, node: Node, role: str, record: Record) -> None:
        """Refuse a record for one size if the block's sizes are open."""
        block = node.system
        declared = {"x": block.declared["states"], "u": block.declared["inputs"]}
        for operation in record.operations:
            if operation.kind != "leaf" or operation.at[0] not in declared:
                continue
            group, name = operation.at
            open_shape = self.shape(block, declared[group][name])
            if open_shape != self.shape(block, operation.shape):
                _, why = block.read_with.get(role, ((), ""))
                sizes = " and ".join(self.open)
                raise Unread(f"{node.name}.{role} is not read for every {sizes}: {why}")
