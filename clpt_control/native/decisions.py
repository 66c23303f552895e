"""Decisions: where equations are not smooth, and how they are locked for the length of a step.

    where(a < b, c, d),  minimum(a, b),  |a|,  sign(a),  floor(a),  a row read at a place

A step of the solver over a kink is worth little.  So while it is taken the rates keep every
decision as it was where the step began: they are smooth, also a little beyond the kink.  Where a
step has gone beyond one, `solver` finds the crossing and begins anew there, decided again.

    H    what was decided: 1 or -1, the whole number of a floor, the place in a row; kept in P
    D    what is decided now, of all decisions, and then for each whether the step has passed it:
         the difference of what is compared has the other sign than H, by more than rounding

The gridded current, which is smooth, stays as it is.  Discontinuity locking: Cellier and
Kofman, Continuous System Simulation, 2006, chapter 9.
"""

from collections.abc import Sequence
from math import prod
from typing import Any, NamedTuple

from ..equations.record import reached

COMPARED = {"lt": -1.0, "le": -1.0, "gt": 1.0, "ge": 1.0}  # the sign of a - b where they hold
WHOLE = ("floor", "ceil", "trunc", "floordiv")
LOCKED = frozenset({*COMPARED, *WHOLE, "minimum", "maximum", "fabs", "sign", "mod", "pick"})
ROUNDING = 1e-12  # of what is compared
Ref = Any


class Decision(NamedTuple):
    """A decision: its first place, its axes and which of them loop, its value; whose it is."""

    first: int
    shape: tuple[int, ...]
    long: tuple[bool, ...]
    ref: Ref
    of: tuple[int, str, str]  # number of the block, its function, the operation


def questions(kind: str, own: Sequence[Ref]) -> list[tuple[str, Ref, Ref]]:
    """Return what an operation decides: comparisons and whole numbers."""
    if kind in COMPARED or kind == "floordiv":
        return [(kind, own[0], own[1])]
    if kind in ("minimum", "maximum"):
        return [("lt" if kind == "minimum" else "gt", own[0], own[1])]
    if kind == "sign":
        return [("gt", own[0], 0.0), ("lt", own[0], 0.0)]
    if kind == "fabs":
        return [("ge", own[0], 0.0)]
    if kind == "mod":
        return [("floordiv", own[0], own[1])]
    return [("trunc", own[1], 0.0)] if kind == "pick" else [(kind, own[0], 0.0)]


class Decisions:
    """The decisions of a diagram's rates, asked as they are and then locked."""

    def __init__(self, record: Any, first: int):
        self.record, self.grain = record, first  # place in P of the least difference that counts
        self.first = first + 1
        self.locking = False
        self.now: list[Decision] = []
        self.passed: list[Decision] = []
        self._next = 0

    def lock(self) -> bool:
        """Begin to write the rates down again, locked; return whether there is anything to lock."""
        self.locking, self.count, self._next = True, self._next, 0
        return self.count > 0

    def read(self, kind: str, own: list[Ref], axes: tuple, owner: int, role: str) -> Ref | None:
        """Note what an operation decides; return its locked value, or None."""
        if kind not in LOCKED or not any(map(self.record.is_moving, own)):
            return None
        (shape, long), held = axes, []

        def add(kind: str, *given: Ref) -> Ref:
            return self.record.add(kind, given, shape, None, owner)

        for name, a, b in questions(kind, own):
            place = self._next
            self._next += prod(shape)
            given = (a, b) if name in COMPARED or name == "floordiv" else (a,)
            if not self.locking:
                found = add(name, *given)
                if name in COMPARED:
                    found = add("where", found, 1.0, -1.0)
                self.now.append(Decision(place, shape, long, found, (owner, role, kind)))
                continue
            H = self.record.load("P", self.first + place, shape)
            beyond = self._passed(name, given, H, shape)
            self.passed.append(Decision(place, shape, long, beyond, (owner, role, kind)))
            held.append(add("gt", H, 0.0) if name in COMPARED else H)
        if not self.locking:
            return None
        if kind in COMPARED or kind in WHOLE:
            return held[0]
        if kind == "sign":
            return add("where", held[0], 1.0, add("where", held[1], -1.0, 0.0))
        if kind == "fabs":
            return add("where", held[0], own[0], add("neg", own[0]))
        if kind == "mod":
            beyond = add("sub", own[0], add("mul", own[1], held[0]))
            same = add("eq", add("floordiv", *own), held[0])
            return add("where", same, add("mod", *own), beyond)
        return add("pick", own[0], held[0]) if kind == "pick" else add("where", held[0], *own)

    def _passed(self, name: str, given: tuple, H: Ref, shape: tuple) -> Ref:
        """Return whether a step has passed a decision, as 1 or 0."""

        def add(kind: str, *arguments: Ref) -> Ref:
            return self.record.add(kind, arguments, shape)

        grain = self.record.load("P", self.grain, ())
        size = add("fabs", given[0])
        if name in COMPARED:
            apart = add("sub", *given)
            if given[1] != 0.0:
                size = add("add", size, add("fabs", given[1]))
            beyond = add("neg", apart) if COMPARED[name] < 0 else apart
            least = add("add", add("mul", size, ROUNDING), grain)
            found = add("lt", add("mul", beyond, H), add("neg", least))
        else:
            least = add("add", add("mul", size, ROUNDING), grain)
            found = add(
                "and",
                *(
                    add("ne", add(name, add(side, given[0], least), *given[1:]), H)
                    for side in ("add", "sub")
                ),
            )
        return add("where", found, 1.0, 0.0)

    def kept(self, rates: Sequence[Ref]) -> int:
        """Keep the decisions that rates depend on; return how many places they and others take."""
        own = {d.first: d for d in self.passed}
        entries = self.record.entries
        loads = {
            entry.at[1] - self.first: k
            for k, entry in enumerate(entries)
            if entry.kind == "load" and entry.at[0] == "P" and entry.at[1] >= self.first
        }
        used = reached(entries, rates)
        while True:
            found = [first for first in own if loads.get(first) in used]
            more = used | reached(entries, [own[first].ref for first in found])
            if more == used:
                break
            used = more
        dropped = own.keys() - set(found)
        self.now = [d._replace(ref=1.0) if d.first in dropped else d for d in self.now]
        self.passed = [d._replace(ref=0.0) if d.first in dropped else d for d in self.passed]
        return self.count if found else 0
