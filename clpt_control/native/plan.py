"""In which order a diagram's components are computed: what is prepared, and loops by level.

A component's level is the number of sums before it, one inside the other.  Of each level, what
loops over axes of one length is one loop, across blocks; then come nests of two axes, and so on.
What depends on parameters alone is computed once a piece of time (`prepare`) and kept at the end
of P; what a nest reads at every turn, and what later levels read, is saved in W.
"""

from itertools import groupby
from math import prod
from typing import Any, NamedTuple

from ..equations.arrays import CONDITIONS
from .components import BOUND, Component, Components, Write, deep, rows
from .diagram_record import DiagramRecord, Port
from .joined_sums import JoinedSums

LARGEST = 4096  # numbers of an array that is prepared
Argument = tuple[int, tuple[int, ...]]  # component, and the loop that each of its axes is


class Nest(NamedTuple):
    """Loops, the outermost first, of which one takes eight turns at once; none at all: numbers."""

    lengths: tuple[int, ...]
    vector: int
    items: tuple[Write, ...]


class Program(NamedTuple):
    """The functions of a diagram, as nests of loops over components.

    derivative: D = dx/dt; signals: W = all block outputs; margin: D[0] = least distance to a
    guard's edge; jump: D = states after the jumps that P asks for, empty without any; decide: D =
    what is decided, and what of it a step has passed (`decisions`); slope, in some: D = df/dx v +
    df/dt s, where v and s lie behind the states.
    """

    components: tuple[Component, ...]
    functions: dict[str, tuple[Nest, ...]]
    prepared: dict[int, int]  # component -> place in P
    constants: tuple[float, ...]  # K
    parameters: int  # length of P
    room: int  # length of W
    decided: int  # numbers that are decided
    deciding: tuple[tuple, ...]  # of each decision: first number, whose it is


class Planner:
    """Makes the program of components; `early` while that is of what is prepared."""

    def __init__(self, made: Components):
        self.made, self.all, self.early = made, made.all, False
        self.prepared: dict[int, int] = {}
        self.before: list[Write] = []  # what writes into P what is prepared
        self.rank = [len(c.lengths) for c in made.all]

    def arguments(self, c: int) -> list[Argument]:
        """Return the components that a function makes one of."""
        name, arguments, _ = self.all[c]
        none = name in ("load", "table") or self.left(c)
        return [] if none else [a for a in arguments if type(a) is tuple]

    def kept(self, c: int) -> int:
        """Return which kept array a component reads, or -1."""
        name, arguments, _ = self.all[c]
        return arguments[-1] if name in ("load", "table") else -1

    def program(
        self, writes: dict[str, list[Write]], decided: int, deciding: tuple[tuple, ...]
    ) -> Program:
        """Return the program whose functions write these."""
        made, functions = self.made, {name: self.nests(own) for name, own in writes.items()}
        self.early = True
        functions["prepare"] = self.nests(self.before)
        constants, sizes = tuple(made.constants), (made.prepared, made.room, decided)
        return Program(tuple(self.all), functions, self.prepared, constants, *sizes, deciding)

    # --- what is prepared -----------------------------------------------------------------

    def left(self, c: int) -> bool:
        """Whether a function reads a component from P: of parameters alone, and worth a place."""
        if self.early or not self.made.steady[c]:
            return False
        name, arguments, lengths = self.all[c]
        if name == "load":
            return len(lengths) == 1 and arguments[2][0] != 1
        return name not in CONDITIONS and name != "table" and prod(lengths) <= LARGEST

    def prepare(self, c: int) -> None:
        """Find a place in P for a component."""
        if c not in self.prepared:
            lengths = self.all[c].lengths
            place = self.prepared[c] = self.made.prepared
            self.made.prepared += prod(lengths)
            self.before.append(Write("P", place, rows(lengths), lengths, _whole(c, lengths)))

    def own(self, number: int) -> bool:
        """Whether a function itself writes a kept array."""
        writes = self.made.kept[number]
        return self.early or not writes or writes[0].array == "W"

    def live(self, writes: list[Write]) -> tuple[set[int], list[Write]]:
        """Return the components that are computed or read, and all that is written."""
        live: set[int] = set()
        found: list[Write] = []
        stack: list[int] = []
        done: set[int] = set()

        def write(own: list[Write]) -> None:
            found.extend(own)
            stack.extend(w.value[0] for w in own if type(w.value) is tuple)

        write(writes)
        while stack:
            c = stack.pop()
            if c in live:
                continue
            live.add(c)
            number = self.kept(c)
            if number >= 0 and number not in done:
                done.add(number)
                own = self.made.kept[number]
                if self.own(number):
                    write(own)
                else:
                    self.before += own
            if self.left(c):
                self.prepare(c)
            stack += [a for a, _ in self.arguments(c)]
        return live, found

    # --- levels ---------------------------------------------------------------------------

    def nests(self, writes: list[Write]) -> tuple[Nest, ...]:
        """Return the loops of a function that writes these."""
        live, writes = self.live(writes)
        level: dict[int, int] = {}

        def ready(value: Any) -> int:
            if type(value) is not tuple:
                return 0
            c = value[0]
            return level[c] + (self.all[c].name == "sum" and not self.left(c))

        for c in sorted(live):
            own = [ready(a) for a in self.arguments(c)]
            if (number := self.kept(c)) >= 0 and self.own(number):
                own += [1 + ready(w.value) for w in self.made.kept[number]]
            level[c] = max(own, default=0)
        items = [(ready(w.value), w) for w in dict.fromkeys(writes)]
        for c in self.saved(live, level):
            name, arguments, lengths = self.all[c]
            item = Write("W", self.made.room, rows(lengths), lengths, _whole(c, lengths), c)
            if name == "sum":
                (value, axes), count = arguments  # the summed axis is the innermost
                turns = tuple(len(lengths) if k == BOUND else k for k in axes)
                item = item._replace(lengths=(*lengths, count), value=(value, turns), summed=True)
            items.append((level[c], item))
            self.made.room += prod(lengths) if lengths else 0  # one number is not written

        def key(item: tuple[int, Write]) -> tuple:
            return item[0], len(item[1].lengths), item[1].lengths, self.vector(item[1])

        items.sort(key=key)
        return tuple(
            Nest(lengths, vector, tuple(item[1] for item in own))
            for (_, _, lengths, vector), own in groupby(items, key)
        )

    def saved(self, live: set[int], level: dict[int, int]) -> list[int]:
        """Return sums, and the components with axes that are saved in W, in their order."""
        found: set[int] = set()
        for c in live:
            name, own = self.all[c].name, self.arguments(c)
            if name == "sum" and not self.left(c):
                found.add(c)
            inner = self.rank[c] + (name == "sum")
            for a, _ in own:
                plain = self.all[a].name in ("load", *CONDITIONS) or self.left(a)
                later = inner > self.rank[a] or level[c] > level[a]
                if self.rank[a] and later and not plain:
                    found.add(a)
        return sorted(found)

    # --- which loop takes eight turns at once ---------------------------------------------

    def vector(self, item: Write) -> int:
        """Return the loop along which most of what is read and stored lies in turn."""
        if len(item.lengths) < 2:
            return 0
        apart = [0] * len(item.lengths)
        if item.saves < 0:
            apart = [stride not in (0, 1) for stride in item.strides]
        seen, stack = set(), [item.value] if type(item.value) is tuple else []
        while stack:
            c, turns = argument = stack.pop()
            if argument in seen:
                continue
            seen.add(argument)
            name, arguments, own = self.all[c]
            if name == "load" or self.left(c):
                moves = arguments[2] if name == "load" and not self.left(c) else rows(own)
                along: dict[int, int] = {}
                for turn, stride in zip(turns, moves, strict=True):
                    along[turn] = along.get(turn, 0) + stride
                for turn, stride in along.items():
                    apart[turn] += stride not in (0, 1)
            elif name != "sum":
                stack += [(a, tuple(turns[k] for k in axes)) for a, axes in self.arguments(c)]
        return min(reversed(range(len(apart))), key=apart.__getitem__)


def _whole(c: int, lengths: tuple[int, ...]) -> Argument:
    return c, tuple(range(len(lengths)))


def program_of(
    record: DiagramRecord, room: int, prepared: int, slopes: list[Port] | None = None
) -> Program:
    """Return the program of a diagram: W has so much room for signals, P for what is given.

    With `slopes`, of the rates along a direction, it has the function `slope`, which writes them.
    """
    decisions, count = record.decisions, record.decisions.count
    made = Components(record, room, prepared + (1 + count if count else 0))
    passed = [port._replace(first=port.first + count) for port in decisions.passed]
    with deep():
        writes = {
            "derivative": made.writes(record.rates, "D", JoinedSums(made).element),
            "signals": made.writes(record.signals, "W"),
            "margin": [_least(made)],
            "jump": made.writes(record.leaps, "D") if record.layout.jumps else [],
            "decide": made.writes([*decisions.now, *passed], "D"),
        }
        if slopes is not None:
            writes["slope"] = made.writes(slopes, "D")
    return Planner(made).program(writes, count, tuple(decisions.of))


def _least(made: Components) -> Write:
    least: Any = 1.0
    for margin in made.record.margins:
        least = made.add("minimum", least, made.at(margin, ()))
    return Write("D", 0, (), (), least)
