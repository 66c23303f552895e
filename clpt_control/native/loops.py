"""Find the loops of a record: `roll`.

The marks of a record say where turns begin; `turns` says which are the same.  What is
found is expanded again, turn by turn, and must give the record; else turns stay apart.
"""

from collections.abc import Iterable
from math import copysign, inf
from typing import Any

from ..equations.scalars import LEAVES, Scalars
from ..errors import BlockError
from .program import Loop, Step, Store
from .rolled import Constant, Place, Rolled, Table, expanded, numbered
from .turns import Different, Merge, Shared

LEAST = 5  # turns; fewer stay apart


def roll(record: Scalars, least: float = LEAST) -> Rolled:
    """Return a record with the loops that can be kept; fewer turns than `least` stay apart."""
    record = record.without_opaque()
    found = Roller(record, least).run()
    known: dict = {}
    if expanded(found, len(record.outputs), known) == numbered(record, known):
        return found
    if least == inf:
        raise BlockError("loops that do not expand to what was recorded")
    return Roller(record, inf).run()


class Roller:
    """A pass over a record."""

    def __init__(self, record: Scalars, least: float):
        self.record, self.least = record, least
        last_use = [0] * len(record.operations)
        for k, (name, *arguments) in enumerate(record.operations):
            if name not in LEAVES:
                for a in arguments:
                    if type(a) is int:
                        last_use[a] = k
        for ref in record.outputs:
            if type(ref) is int:
                last_use[ref] = len(record.operations)
        self.shared = Shared(len(record.operations), last_use)

    def run(self) -> Rolled:
        """Return the record with its loops."""
        items = self.items(self.tree())
        items += stored([self.argument(ref) for ref in self.record.outputs])
        return Rolled(tuple(items), tuple(self.shared.constants), self.shared.room)

    def tree(self) -> list:
        """Return operations, those of a loop turn by turn."""
        root: list = []
        lists: list[list] = [root]
        open_loops: list[list] = []
        marks = list(self.record.marks)
        at = 0
        for k in range(len(self.record.operations) + 1):
            while at < len(marks) and marks[at][0] == k:
                event = marks[at][1]
                at += 1
                if event in ("enter", "every"):
                    turns: list[list] = []
                    lists[-1].append([turns, k, event])
                    open_loops.append(lists[-1][-1])
                    lists.append([])
                elif open_loops:
                    lists.pop()
                    if event == "turn":
                        lists.append([])
                        open_loops[-1][0].append(lists[-1])
                    else:
                        open_loops.pop()[1] = k
            if k < len(self.record.operations):
                lists[-1].append(k)
        return root

    def argument(self, a: Any) -> Any:
        """Return what an argument is: a value, a constant or a place."""
        if type(a) is float:
            return Constant(a, copysign(1.0, a))
        name, *where = self.record.operations[a]
        if name == "t":
            return Place("t", 0)
        if name == "p":
            return Place(("p", where[0]), where[1])
        if name in LEAVES:
            return Place(name, where[0])
        return self.shared.alias.get(a, a)

    def items(self, nodes: Iterable) -> list:
        """Return the items of operations and loops."""
        found: list = []
        for node in nodes:
            if type(node) is not int:
                found += self.loop(*node)
                continue
            name, *arguments = self.record.operations[node]
            if name in LEAVES:
                continue
            if name == "table":
                field, first, stride, count = arguments[1]
                table = Table(Place(("p", field), first), stride, count)
                found.append(Step(node, name, (self.argument(arguments[0]), table)))
                continue
            found.append(Step(node, name, tuple(map(self.argument, arguments))))
        return found

    def loop(self, nodes: list[list], end: int, event: str) -> list:
        """Return one loop, or the items of its turns one after the other."""
        turns = [self.items(turn) for turn in nodes]
        apart = [item for turn in turns for item in turn]
        if event == "enter" and (len(turns) < self.least or not apart):
            return apart
        before = self.shared.copy()
        try:
            return [Merge(self.shared, turns, end).loop()]
        except Different:
            if event == "every":
                raise BlockError(
                    "turns of a loop over all functions differ, or hand on more than a sum"
                ) from None
            self.shared = before
            return apart


def stored(values: list) -> list:
    """Return the stores that fill `out`, in loops where they can be."""
    items: list = []
    k = 0
    while k < len(values):
        first, count = values[k], 1
        if isinstance(first, Place) and k + 1 < len(values) and isinstance(values[k + 1], Place):
            step = values[k + 1].base - first.base
            while k + count < len(values) and values[k + count] == Place(
                first.array, first.base + count * step
            ):
                count += 1
        if count >= LEAST:
            source = first._replace(steps=((0, step),) if step else ())
            items.append(Loop(0, count, (Store("out", k, ((0, 1),), source),), ()))
        else:
            count = 1
            items.append(Store("out", k, (), first))
        k += count
    return items
