"""A diagram as one list of operations: every block's record, run through the wiring.

What is computed twice is computed once, what nobody reads is left out, and what
depends on parameters alone is computed once a piece of time (`prepare`).
"""

from collections.abc import Callable, Iterable
from math import copysign
from typing import Any

from ..diagrams.wiring import Node
from ..equations.scalars import Scalars
from .layout import Sources
from .optimise import simplified
from .program import CONDITIONS, Item, Load, Program, Ref, Step, Store


class Operations:
    """Operations in single assignment, each once: ("load", (array, place)) or (name, ...)."""

    def __init__(self) -> None:
        self.operations: list[tuple] = []
        self._known: dict[tuple, int] = {}

    def add(self, name: str, *arguments: Any) -> Ref:
        """Add an operation, or find it; return its value."""
        keys = [_key(a) for a in arguments]
        key = (name, *(sorted(keys) if name in ("add", "mul") else keys))
        if key not in self._known:
            self._known[key] = len(self.operations)
            self.operations.append((name, *arguments))
        return self._known[key]

    def reached(
        self, roots: Iterable[Ref], ready: Callable[[int], bool] = lambda value: False
    ) -> list[int]:
        """Return what values are ops of, in order, up to what is ready."""
        found: set[int] = set()
        stack = [root for root in roots if type(root) is int]
        while stack:
            value = stack.pop()
            if value not in found:
                found.add(value)
                if not ready(value):
                    stack += [a for a in self.operations[value][1:] if type(a) is int]
        return sorted(found)


def _key(argument: Any) -> tuple:
    """Return what tells arguments apart, and orders them; 0.0 is not -0.0."""
    if type(argument) is float:
        return 1, argument, copysign(1.0, argument)
    return (0, argument) if type(argument) is int else (2, argument)


def run_block(
    ops: Operations, record: Scalars, sources: Sources, k: int, inputs: list[Ref]
) -> list[Ref]:
    """Run a block's record on the operations of a diagram."""
    node = sources.wiring.nodes[k]

    def leaf(name: str, *where: Any) -> Ref:
        if name == "t":
            return ops.add("load", ("t", 0))
        if name == "x":
            return ops.add("load", ("X", node.states.start + where[0]))
        if name == "u":
            return inputs[where[0]]
        array, first = sources.parameter(k, where[0])
        return ops.add("load", (array, first + where[1]))

    def apply(name: str, *arguments: Any) -> Ref:
        if name == "table":
            field, first, stride, count = arguments[1]
            array, start = sources.parameter(k, field)
            return ops.add(name, arguments[0], (array, start + first, (), stride, count))
        return ops.add(name, *arguments)

    return record.without_opaque().replay(leaf, apply)


def gather(ops: Operations, sources: Sources, node: Node, signals: list[Ref]) -> list[Ref]:
    """Return what the wiring brings to a block's inputs."""
    found: list[Ref] = []
    signed = sources.signed(node)
    for terms in sources.inputs(node):
        total: Ref | None = None
        for gain, external, source in terms:
            value = _external(ops, sources, source) if external else signals[source]
            gained = value if gain == 1.0 else ops.add("mul", gain, value)
            total = gained if total is None else ops.add("add", total, gained)
        if signed and total is not None:
            total = ops.add("add", total, 0.0)
        found.append(0.0 if total is None else total)
    return found


def _external(ops: Operations, sources: Sources, place: int) -> Ref:
    """Return an input of the diagram: straight between its samples."""
    begin, value, slope = (ops.add("load", ("P", at)) for at in sources.external(place))
    since = ops.add("sub", ops.add("load", ("t", 0)), begin)
    return ops.add("add", value, ops.add("mul", since, slope))


def unrolled_program(sources: Sources) -> Program:
    """Return the program of a diagram, all loops unrolled."""
    ops, nodes = Operations(), sources.wiring.nodes
    signals: list[Ref] = [0.0] * nodes[-1].outputs.stop
    rates: list[Ref] = [0.0] * nodes[-1].states.stop
    for k in sources.wiring.order:
        node = nodes[k]
        inputs = gather(ops, sources, node, signals) if node.system.feedthrough else []
        inputs = inputs or [0.0] * node.system.ninputs
        signals[node.outputs] = run_block(ops, node.system.output_record, sources, k, inputs)
    margins: list[Ref] = []
    for k, node in enumerate(nodes):
        block, inputs = node.system, gather(ops, sources, node, signals)
        if block.update_record is not None:
            rates[node.states] = run_block(ops, block.update_record, sources, k, inputs)
        if block.guard_record is not None:
            margins += run_block(ops, block.guard_record, sources, k, inputs)
    rates = simplified(ops, rates)
    after = _after_jumps(ops, sources, signals) if sources.layout.jumps else []
    return programmed(ops, sources, rates, signals, margins, after)


def _after_jumps(ops: Operations, sources: Sources, signals: list[Ref]) -> list[Ref]:
    """Return all states after the jumps of the blocks that P marks."""
    nodes = sources.wiring.nodes
    after: list[Ref] = [ops.add("load", ("X", i)) for i in range(nodes[-1].states.stop)]
    for k, place in sources.layout.jumps.items():
        node, record = nodes[k], nodes[k].system.jump_record
        new = run_block(ops, record, sources, k, gather(ops, sources, node, signals))
        jumps = ops.add("gt", ops.add("load", ("P", place)), 0.5)
        pairs = zip(new, after[node.states], strict=True)
        after[node.states] = [ops.add("where", jumps, one, old) for one, old in pairs]
    return after


def programmed(
    ops: Operations,
    sources: Sources,
    rates: list[Ref],
    signals: list[Ref],
    margins: list[Ref],
    after: list[Ref],
) -> Program:
    """Return the program that computes these values."""
    least: Ref = 1.0
    for margin in margins:
        least = ops.add("minimum", least, margin)
    steady: list[bool] = []
    for name, *arguments in ops.operations:
        own = arguments[0][0] in "PT" if name == "load" else True
        steady.append(own and all(steady[a] for a in arguments if type(a) is int))
    places: dict[int, int] = {}  # of what is prepared, in P

    def prepared(value: int) -> bool:
        return steady[value] and ops.operations[value][0] not in ("load", *CONDITIONS)

    def item(value: int) -> Item:
        name, *arguments = ops.operations[value]
        return Load(value, *arguments[0]) if name == "load" else Step(value, name, tuple(arguments))

    def function(array: str, roots: list[Ref]) -> tuple[Item, ...]:
        items: list[Item] = []
        for value in ops.reached(roots, prepared):
            if prepared(value):
                place = places.setdefault(value, sources.prepared + len(places))
                items.append(Load(value, "P", place))
            else:
                items.append(item(value))
        return (*items, *(Store(array, k, (), root) for k, root in enumerate(roots)))

    derivative, of_signals = function("D", rates), function("W", signals)
    distance, jump = function("D", [least]), function("D", after)
    prepare = [item(value) for value in ops.reached(places)]
    prepare += [Store("P", place, (), value) for value, place in places.items()]
    size = sources.prepared + len(places)
    return Program(derivative, of_signals, distance, tuple(prepare), (), size, len(signals), jump)
