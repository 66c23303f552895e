"""Order of computation of a program: prepared values first, then loops by level.

The level of a component is the number of nested sums before it.  All components of one level with
axes of one length share a loop, across blocks; nests of two axes follow, and so on.  Components
that depend on parameters alone are computed once per time segment (`prepare`) and stored at the end
of P.  Values that every iteration of a nest reads, or that later levels read, are stored in W.
"""

from itertools import groupby
from math import prod
from typing import Any, NamedTuple

import numpy as np

from ..record.graph import deep
from ..record.operations import CONDITIONS
from .diagram_record import DiagramRecord
from .fused_expressions import BOUND, Component, Components, Loops, Write, row_strides
from .merged_sums import MergedSums
from .switching_conditions import Port

NO_TABLES = np.zeros(0)
LARGEST = 4096  # numbers of an array that is prepared
Argument = tuple[int, Loops]  # component, and the loop of each of its axes


class Nest(NamedTuple):
    """Loops, the outermost first, of which `vector` does eight iterations at once; or no loop."""

    lengths: Loops
    vector: int
    items: tuple[Write, ...]


class Program(NamedTuple):
    """The functions of a diagram, as nests of loops over components.

    derivative: D = dx/dt; signals: W = all block outputs; jump: D = states after the jumps that
    P asks for, empty without any; decide: D = decisions, their distances and the rounding of these
    (`switching_conditions`).  Guards are the last events; in place of the decision they have the
    distance with the decisions made now.
    """

    components: tuple[Component, ...]
    functions: dict[str, tuple[Nest, ...]]
    prepared: dict[int, int]  # component -> place in P
    constants: tuple[float, ...]  # K
    parameters: int  # length of P
    room: int  # length of W
    decided: int  # how many numbers are decided
    # of each decision: its first number, and where it is made
    deciding: tuple[tuple, ...]
    timed: bool = False  # whether steps are short, as time may do much in little of it
    ramped: bool = False  # the same where inputs change along straight lines
    tables: np.ndarray = NO_TABLES  # large constants, behind the parameters in T
    guarded: int = 0  # number of guards, which follow the decisions


class Planner:
    """Plans the functions of a program; `preparing` while it plans the function `prepare`."""

    def __init__(self, components: Components):
        self.components, self.all, self.preparing = components, components.all, False
        self.prepared: dict[int, int] = {}
        self.preparation: list[Write] = []  # what `prepare` writes into P
        self.rank = [len(c.lengths) for c in components.all]

    def arguments(self, c: int) -> list[Argument]:
        """Return the components from which a function computes one; none if it reads that."""
        name, arguments, _ = self.all[c]
        read = name in ("load", "table") or self.is_prepared(c)
        return [] if read else [a for a in arguments if type(a) is tuple]

    def buffer(self, c: int) -> int:
        """Return the buffer that a component reads, or -1."""
        name, arguments, _ = self.all[c]
        return arguments[-1] if name in ("load", "table") else -1

    # --- what is prepared -----------------------------------------------------------------

    def is_prepared(self, c: int) -> bool:
        """Return whether a component is read from P: of parameters alone, and costly enough."""
        if self.preparing or not self.components.steady[c]:
            return False
        name, arguments, lengths = self.all[c]
        if name == "load":
            return len(lengths) == 1 and arguments[2][0] != 1
        return name not in CONDITIONS and name != "table" and prod(lengths) <= LARGEST

    def fills(self, buffer: int) -> bool:
        """Return whether a function itself writes a buffer."""
        writes = self.components.buffers[buffer]
        return self.preparing or not writes or writes[0].array == "W"

    def live(self, writes: list[Write]) -> tuple[set[int], list[Write]]:
        """Return the components that are computed or read, and all that is written."""
        live = set()
        every = []
        stack: list[int] = []
        filled_buffers = set()

        def write(new_writes: list[Write]) -> None:
            every.extend(new_writes)
            stack.extend(w.value[0] for w in new_writes if type(w.value) is tuple)

        write(writes)
        while stack:
            c = stack.pop()
            if c in live:
                continue
            live.add(c)
            buffer = self.buffer(c)
            if buffer >= 0 and buffer not in filled_buffers:
                filled_buffers.add(buffer)
                filling = self.components.buffers[buffer]
                if self.fills(buffer):
                    write(filling)
                else:
                    self.preparation += filling
            if self.is_prepared(c) and c not in self.prepared:
                lengths = self.all[c].lengths
                offset = self.prepared[c] = self.components.prepared
                self.components.prepared += prod(lengths)
                value = whole_value(c, lengths)
                item = Write("P", offset, row_strides(lengths), lengths, value)
                self.preparation.append(item)
            stack += [a for a, _ in self.arguments(c)]
        return live, every

    # --- levels ---------------------------------------------------------------------------

    def nests(self, writes: list[Write]) -> tuple[Nest, ...]:
        """Return the loops of a function that writes these."""
        live, writes = self.live(writes)
        level: dict[int, int] = {}

        def ready(value: Any) -> int:
            if type(value) is not tuple:
                return 0
            c = value[0]
            is_summed = self.all[c].name == "sum" and not self.is_prepared(c)
            return level[c] + is_summed

        for c in sorted(live):
            levels = [ready(a) for a in self.arguments(c)]
            buffer = self.buffer(c)
            if buffer >= 0 and self.fills(buffer):
                levels += [1 + ready(w.value) for w in self.components.buffers[buffer]]
            level[c] = max(levels, default=0)
        items = [(ready(w.value), w) for w in dict.fromkeys(writes)]
        components = self.components
        for c in self.saved(live, level):
            name, arguments, lengths = self.all[c]
            strides = row_strides(lengths)
            value = whole_value(c, lengths)
            item = Write("W", components.room, strides, lengths, value, c)
            if name == "sum":
                (value, axes), count = arguments  # the summed axis is the innermost
                loops = tuple(len(lengths) if k == BOUND else k for k in axes)
                item = item._replace(
                    lengths=(*lengths, count), value=(value, loops), summed=True
                )
            items.append((level[c], item))
            if lengths:  # a single number is not written
                components.room += prod(lengths)

        def key(item: tuple[int, Write]) -> tuple:
            item_level, write = item
            return item_level, len(write.lengths), write.lengths, self.vector(write)

        items.sort(key=key)
        return tuple(
            Nest(lengths, vector, tuple(item for _, item in group))
            for (_, _, lengths, vector), group in groupby(items, key)
        )

    def saved(self, live: set[int], level: dict[int, int]) -> list[int]:
        """Return the components that are saved in W, in their order: sums, and some with axes."""
        saved = set()
        for c in live:
            name = self.all[c].name
            if name == "sum" and not self.is_prepared(c):
                saved.add(c)
            inner = self.rank[c] + (name == "sum")
            for a, _ in self.arguments(c):
                plain = self.all[a].name in ("load", *CONDITIONS) or self.is_prepared(a)
                later = inner > self.rank[a] or level[c] > level[a]
                if self.rank[a] and later and not plain:
                    saved.add(a)
        return sorted(saved)

    # --- which loop does eight iterations at once -----------------------------------------

    def vector(self, item: Write) -> int:
        """Return the loop along which the fewest reads and writes are strided."""
        if len(item.lengths) < 2:
            return 0
        strided = [0] * len(item.lengths)
        if item.saves < 0:
            strided = [stride not in (0, 1) for stride in item.strides]
        visited = set()
        stack = [item.value] if type(item.value) is tuple else []
        while stack:
            c, loops = argument = stack.pop()
            if argument in visited:
                continue
            visited.add(argument)
            name, arguments, lengths = self.all[c]
            if name == "load" or self.is_prepared(c):
                strides = row_strides(lengths) if self.is_prepared(c) else arguments[2]
                for loop, stride in zip(loops, strides, strict=True):
                    strided[loop] += stride not in (0, 1)
            elif name != "sum":
                stack += [
                    (a, tuple(loops[k] for k in axes)) for a, axes in self.arguments(c)
                ]
        return min(reversed(range(len(strided))), key=strided.__getitem__)


def whole_value(c: int, lengths: Loops) -> Argument:
    """Return a component as an argument, each axis in its own loop."""
    return c, tuple(range(len(lengths)))


def program_of(record: DiagramRecord, room: int, prepared: int) -> Program:
    """Return the program of a diagram.

    W has `room` places for signals, P `prepared` places for parameters and inputs.
    """
    decisions = record.decisions
    count = decisions.count
    first_prepared = prepared + 2 + count if count else prepared
    components = Components(record, room, first_prepared)
    # behind the decisions D has their distances, then the rounding errors of these
    guards = [guard._replace(first=count + guard.first) for guard in record.guards]
    events = count + len(guards)
    decided = [
        Port(number * events + first, shape, long, values[number])
        for number in range(3)
        for first, shape, long, *values in (*decisions.events, *guards)
    ]
    with deep():
        writes = {
            "derivative": components.writes(
                record.rates, "D", MergedSums(components).element
            ),
            "signals": components.writes(record.signals, "W"),
            "jump": components.writes(record.leaps, "D") if record.layout.jumps else [],
            "decide": components.writes(decided, "D"),
        }
    planner = Planner(components)
    functions = {name: planner.nests(written) for name, written in writes.items()}
    planner.preparing = True
    functions["prepare"] = planner.nests(planner.preparation)
    return Program(
        components=tuple(components.all),
        functions=functions,
        prepared=planner.prepared,
        constants=tuple(components.constants),
        parameters=components.prepared,
        room=components.room,
        decided=count,
        deciding=tuple(decisions.of),
        timed=decisions.timed,
        ramped=decisions.ramped,
        tables=np.concatenate([NO_TABLES, *components.tables]),
        guarded=len(guards),
    )
