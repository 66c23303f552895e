"""A diagram with its loops: every block's record, rolled, one after the other.

Signals pass through W.  What a loop reads of its inputs must lie in turn; where the
wiring brings sums, gains, gaps or another order, inputs are first gathered in W.
"""

from collections.abc import Iterable
from itertools import product
from typing import Any

from ..equations.scalars import Scalars
from .layout import Sources, Term
from .loops import LEAST, roll
from .optimise import prepared
from .program import Item, Load, Loop, Program, Ref, Step, Store
from .rolled import Constant, Place, Rolled, Table


def looped_program(sources: Sources, least: int = LEAST) -> Program:
    """Return the program of a diagram with its loops; fewer turns than `least` are unrolled."""
    writer = _Writer(sources, least)
    nodes = sources.wiring.nodes
    outputs = [item for k in sources.wiring.order for item in writer.output(k)]
    states = [item for k in range(len(nodes)) for item in writer.states(k)]
    rates: list[Item] = []
    margins: list[Ref] = []
    guards: list[Item] = []
    for k, node in enumerate(nodes):
        if node.system.update_record is not None:
            rates += writer.block(k, node.system.update_record, "D", node.states.start)
        if node.system.guard_record is not None:
            place = writer.room
            writer.room += 1
            guards += writer.block(k, node.system.guard_record, "W", place)
            margin = writer.value()
            guards.append(Load(margin, "W", place))
            margins.append(margin)
    least_margin: Ref = 1.0
    for one in margins:
        least_margin = writer.step(guards, "minimum", least_margin, one)
    guards.append(Store("D", 0, (), least_margin))
    jump = [item for k in range(len(nodes)) for item in writer.after(k)]
    first = sources.prepared
    prepare: list[Item] = []
    functions: list[tuple[Item, ...]] = []
    kept = [*outputs, *jump] if sources.layout.jumps else []
    for items in ([*outputs, *rates], [*outputs, *states], [*outputs, *guards], kept):
        left, early, count = prepared(items, first)
        functions.append(left)
        prepare += early
        first += count
    derivative, signals, distance, leap = functions
    constants = tuple(writer.constants)
    return Program(
        derivative, signals, distance, tuple(prepare), constants, first, writer.room, leap
    )


class _Writer:
    def __init__(self, sources: Sources, least: int):
        self.sources, self.least = sources, least
        self.room = sources.wiring.nodes[-1].outputs.stop
        self.constants: list[float] = []
        self.values = 0

    def value(self) -> int:
        self.values += 1
        return self.values

    def step(self, items: list[Item], name: str, a: Ref, b: Ref) -> int:
        """Add a calculation to items; return its value."""
        value = self.value()
        items.append(Step(value, name, (a, b)))
        return value

    def output(self, k: int) -> list[Item]:
        """Return what computes a block's outputs; nothing where they are its states."""
        node = self.sources.wiring.nodes[k]
        if self.sources.direct(k):
            return []
        return self.block(k, node.system.output_record, "W", node.outputs.start)

    def states(self, k: int) -> list[Item]:
        """Return what copies states that are outputs."""
        node = self.sources.wiring.nodes[k]
        if not self.sources.direct(k) or not node.system.nstates:
            return []
        value = self.value()
        copy = (
            Load(value, "X", node.states.start, ((0, 1),)),
            Store("W", node.outputs.start, ((0, 1),), value),
        )
        return [Loop(0, node.system.nstates, copy, ())]

    def after(self, k: int) -> list[Item]:
        """Return what computes a block's states after its jump, where P asks for it."""
        if not self.sources.layout.jumps:
            return []
        states = self.sources.wiring.nodes[k].states
        n, turn = states.stop - states.start, ((0, 1),)
        old = self.value()
        items: list[Item] = []
        body: list[Item] = [Load(old, "X", states.start, turn)]
        ref: Ref = old
        if k in self.sources.layout.jumps:
            room, new, asked = self.room, self.value(), self.value()
            self.room += n
            items = self.block(k, self.sources.wiring.nodes[k].system.jump_record, "W", room)
            body += [Load(new, "W", room, turn), Load(asked, "P", self.sources.layout.jumps[k])]
            jumps, ref = self.step(body, "gt", asked, 0.5), self.value()
            body.append(Step(ref, "where", (jumps, new, old)))
        body.append(Store("D", states.start, turn, ref))
        return [*items, Loop(0, n, tuple(body), ())] if n else []

    def block(self, k: int, record: Scalars, array: str, first: int) -> list[Item]:
        """Return a block's items; its last argument lies in an array from a place."""
        found = roll(record, self.least)
        block = _Block(self, k, found, (array, first))
        items = block.items(found.items, {}, {})
        return [*block.before, *items]


class _Block:
    """One record's places and values, turned into those of the program."""

    def __init__(self, writer: _Writer, k: int, found: Rolled, out: tuple[str, int]):
        self.writer, self.k, self.node = writer, k, writer.sources.wiring.nodes[k]
        self.arrays: dict[Any, tuple[str, int]] = {
            "t": ("t", 0),
            "x": ("X", self.node.states.start),
            "out": out,
            "S": ("W", writer.room),
            "K": ("K", len(writer.constants)),
        }
        writer.room += found.room
        writer.constants += found.constants
        self.names: dict[int, int] = {}
        self.before: list[Item] = []
        self.terms = writer.sources.inputs(self.node)
        self.signed = writer.sources.signed(self.node)
        self.gathered: int | None = None

    def items(self, items: Iterable, counts: dict[int, int], held: dict) -> list[Item]:
        """Turn items into a program's; `held` are places that have been read."""
        made: list[Item] = []
        held = dict(held)

        def ref(a: Any) -> Any:
            if isinstance(a, Constant):
                return a.value
            if isinstance(a, Table):
                at = self.place(a.place, counts)
                return at.array, at.base, at.steps, a.stride, a.count
            if isinstance(a, Place):
                at = self.place(a, counts)
                if at not in held:
                    held[at] = self.writer.value()
                    made.append(Load(held[at], *at))
                return held[at]
            return self.named(a)

        for item in items:
            if isinstance(item, Step):
                arguments = tuple(map(ref, item.arguments))
                made.append(Step(self.named(item.value), item.name, arguments))
            elif isinstance(item, Store):
                at = self.place(Place(item.array, item.base, item.steps), counts)
                made.append(Store(*at, ref(item.value)))
            else:
                firsts = [ref(s.first) for s in item.sums]
                body = self.items(item.body, {**counts, item.level: item.count}, held)
                sums = tuple(
                    s._replace(
                        first=first,
                        within=self.named(s.within),
                        turned=self.named(s.turned),
                        result=self.named(s.result),
                    )
                    for s, first in zip(item.sums, firsts, strict=True)
                )
                made.append(Loop(item.level, item.count, tuple(body), sums))
        return made

    def named(self, value: int) -> int:
        if value not in self.names:
            self.names[value] = self.writer.value()
        return self.names[value]

    def place(self, at: Place, counts: dict[int, int]) -> Place:
        if at.array == "u":
            return self.input(at, counts)
        if at.array[0] == "p":
            array, first = self.writer.sources.parameter(self.k, at.array[1])
        else:
            array, first = self.arrays[at.array]
        return Place(array, first + at.base, at.steps)

    # --- inputs ---------------------------------------------------------------------------

    def input(self, at: Place, counts: dict[int, int]) -> Place:
        """Return where the wiring brings inputs, gathered if they do not lie in turn."""
        found = self.brought(at, counts)
        if found is None:
            if self.gathered is None:
                self.gather()
            assert self.gathered is not None
            return Place("W", self.gathered + at.base, at.steps)
        return found

    def source(self, j: int) -> tuple[str, int] | None:
        """Return where one input comes from; None for a sum, a gain or nothing."""
        if len(self.terms[j]) != 1 or self.signed:
            return None
        gain, external, source = self.terms[j][0]
        return None if external or gain != 1.0 else self.writer.sources.signals[source]

    def brought(self, at: Place, counts: dict[int, int]) -> Place | None:
        first = self.source(at.base)
        if first is None:
            return None
        steps = []
        for level, step in at.steps:
            following = self.source(at.base + step)
            if following is None:
                return None
            steps.append((level, following[1] - first[1]))
        for turns in product(*(range(counts[level]) for level, _ in at.steps)):
            j = at.base + sum(s * turn for (_, s), turn in zip(at.steps, turns, strict=True))
            place = first[1] + sum(s * turn for (_, s), turn in zip(steps, turns, strict=True))
            if self.source(j) != (first[0], place):
                return None
        return Place(first[0], first[1], tuple(steps))

    def gather(self) -> None:
        """Write all inputs of the block side by side."""
        writer = self.writer
        self.gathered = writer.room
        writer.room += len(self.terms)
        j = 0
        while j < len(self.terms):
            steps, count = self.alike(j)
            turn = ((0, 1),) if count > 1 else ()
            body: list[Item] = []
            total: Ref = 0.0
            for at, (gain, external, source) in enumerate(self.terms[j]):
                value = self.signal(body, external, source, steps[at] if count > 1 else 0)
                if gain != 1.0:
                    value = writer.step(body, "mul", gain, value)
                total = writer.step(body, "add", total, value) if at else value
            if self.signed:
                total = writer.step(body, "add", total, 0.0)
            body.append(Store("W", self.gathered + j, turn, total))
            self.before += body if count == 1 else [Loop(0, count, tuple(body), ())]
            j += count

    def alike(self, j: int) -> tuple[list[int], int]:
        """Return how far sources move from input j on, and for how many inputs alike."""

        def moved(by: int) -> list[Term] | None:
            if j + by >= len(self.terms) or len(self.terms[j + by]) != len(self.terms[j]):
                return None
            return self.terms[j + by]

        following = moved(1)
        if following is None or not self.terms[j]:
            return [], 1
        steps = [b.source - a.source for a, b in zip(self.terms[j], following, strict=True)]
        count = 1
        while (others := moved(count)) is not None and all(
            b[:2] == a[:2] and self.lies(b) == self.lies(a, count * step)
            for a, b, step in zip(self.terms[j], others, steps, strict=True)
        ):
            count += 1
        return steps, count if count >= LEAST else 1

    def lies(self, term: Term, ahead: int = 0) -> tuple[str, int]:
        """Return array and place of a term's source, moved ahead."""
        if term.external:
            return "ext", term.source + ahead
        array, place = self.writer.sources.signals[term.source]
        return array, place + ahead

    def signal(self, body: list[Item], external: bool, source: int, step: int) -> Ref:
        """Read a signal, or an input of the diagram, which is a straight line in time."""
        writer = self.writer
        steps = ((0, step),) if step else ()

        def load(array: str, place: int, steps: Any) -> int:
            value = writer.value()
            body.append(Load(value, array, place, steps))
            return value

        if not external:
            return load(*writer.sources.signals[source], steps)
        begin, value, slope = writer.sources.external(source)
        since = writer.step(body, "sub", load("t", 0, ()), load("P", begin, ()))
        rise = writer.step(body, "mul", since, load("P", slope, steps))
        return writer.step(body, "add", load("P", value, steps), rise)
