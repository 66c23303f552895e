"""A diagram as one list of operations: every block's record, run through the wiring.

What is computed twice is computed once, what nobody reads is left out, and what
depends on parameters alone is computed once a piece of time (`prepare`).
"""

from collections.abc import Callable, Iterable
from math import copysign
from typing import Any

from ..blocks.record import Record
from ..diagrams.wiring import Node
from .program import CONDITIONS, Item, Load, Program, Ref, Step, Store
from .simplify import simplified
from .sources import Sources


class Flat:
    """Operations in single assignment, each once.

    Attributes
    ----------
    operations : list of tuple
        ``("load", (array, place))`` or ``(name, *arguments)``.
    """

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
        """Return what values are made of, in order, up to what is ready."""
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


def run_block(flat: Flat, record: Record, sources: Sources, k: int, inputs: list[Ref]) -> list[Ref]:
    """Run a block's record on the operations of a diagram."""
    node = sources.wiring.nodes[k]

    def leaf(name: str, *where: Any) -> Ref:
        if name == "t":
            return flat.add("load", ("t", 0))
        if name == "x":
            return flat.add("load", ("X", node.states.start + where[0]))
        if name == "u":
            return inputs[where[0]]
        array, first = sources.parameter(k, where[0])
        return flat.add("load", (array, first + where[1]))

    def apply(name: str, *arguments: Any) -> Ref:
        if name == "table":
            field, first, stride, count = arguments[1]
            array, start = sources.parameter(k, field)
            return flat.add(name, arguments[0], (array, start + first, (), stride, count))
        return flat.add(name, *arguments)

    return record.opened().replay(leaf, apply)


def gather(flat: Flat, sources: Sources, node: Node, signals: list[Ref]) -> list[Ref]:
    """Return what the wiring brings to a block's inputs."""
    found: list[Ref] = []
    signed = sources.signed(node)
    for terms in sources.inputs(node):
        total: Ref | None = None
        for gain, external, source in terms:
            value = _external(flat, sources, source) if external else signals[source]
            gained = value if gain == 1.0 else flat.add("mul", gain, value)
            total = gained if total is None else flat.add("add", total, gained)
        if signed and total is not None:
            total = flat.add("add", total, 0.0)
        found.append(0.0 if total is None else total)
    return found


def _external(flat: Flat, sources: Sources, place: int) -> Ref:
    """An input of the diagram: straight between its samples."""
    begin, value, slope = (flat.add("load", ("P", at)) for at in sources.external(place))
    since = flat.add("sub", flat.add("load", ("t", 0)), begin)
    return flat.add("add", value, flat.add("mul", since, slope))


def flat_program(sources: Sources) -> Program:
    """Return the program of a diagram, all loops unrolled.

    Parameters
    ----------
    sources : Sources
        The diagram, read.

    Returns
    -------
    Program
        Without loops.
    """
    flat, nodes = Flat(), sources.wiring.nodes
    signals: list[Ref] = [0.0] * nodes[-1].outputs.stop
    rates: list[Ref] = [0.0] * nodes[-1].states.stop
    for k in sources.wiring.order:
        node = nodes[k]
        inputs = gather(flat, sources, node, signals) if node.system.feedthrough else []
        inputs = inputs or [0.0] * node.system.ninputs
        signals[node.outputs] = run_block(flat, node.system.output_record, sources, k, inputs)
    margins: list[Ref] = []
    for k, node in enumerate(nodes):
        block, inputs = node.system, gather(flat, sources, node, signals)
        if block.update_record is not None:
            rates[node.states] = run_block(flat, block.update_record, sources, k, inputs)
        if block.guard_record is not None:
            margins += run_block(flat, block.guard_record, sources, k, inputs)
    return programmed(flat, sources, simplified(flat, rates), signals, margins)


def programmed(
    flat: Flat, sources: Sources, rates: list[Ref], signals: list[Ref], margins: list[Ref]
) -> Program:
    """Return the program that computes these values."""
    least: Ref = 1.0
    for margin in margins:
        least = flat.add("minimum", least, margin)
    steady: list[bool] = []
    for name, *arguments in flat.operations:
        own = arguments[0][0] in "PT" if name == "load" else True
        steady.append(own and all(steady[a] for a in arguments if type(a) is int))
    places: dict[int, int] = {}  # of what is prepared, in P

    def prepared(value: int) -> bool:
        return steady[value] and flat.operations[value][0] not in ("load", *CONDITIONS)

    def item(value: int) -> Item:
        name, *arguments = flat.operations[value]
        return Load(value, *arguments[0]) if name == "load" else Step(value, name, tuple(arguments))

    def function(array: str, roots: list[Ref]) -> tuple[Item, ...]:
        items: list[Item] = []
        for value in flat.reached(roots, prepared):
            if prepared(value):
                place = places.setdefault(value, sources.prepared + len(places))
                items.append(Load(value, "P", place))
            else:
                items.append(item(value))
        return (*items, *(Store(array, k, (), root) for k, root in enumerate(roots)))

    derivative, of_signals = function("D", rates), function("W", signals)
    distance = function("D", [least])
    prepare = [item(value) for value in flat.reached(places)]
    prepare += [Store("P", place, (), value) for value, place in places.items()]
    size = sources.prepared + len(places)
    return Program(derivative, of_signals, distance, tuple(prepare), (), size, len(signals))
