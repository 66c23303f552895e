"""Decisions: points where equations are not smooth, and how they are locked during a step.

    where(a < b, c, d),  minimum(a, b),  |a|,  sign(a),  floor(a),  atan2,  a row read at a place

A step of the solver across a kink is not accurate.  So during a step the rates hold every decision
as it was at the beginning of the step: they are smooth, also a little beyond the kink.  If a step
has passed a kink, at its end or at one of seven places before it, and states feel it, `kinks`
locates the crossing and begins anew there, with new decisions.  A step is cut short where a kink
may hide between two of these places.

    H    decisions in force: 1 or -1, the whole number of a floor, the place in a row; they lie in P
    D    all decisions as they are now; for each its distance, the difference that is compared,
         above 0 where it is as H says; and what rounding makes of the distance

The gridded current, which is smooth, stays as it is.  Discontinuity locking: Cellier and
Kofman, Continuous System Simulation, 2006, chapter 9.
"""

from collections.abc import Callable, Sequence
from math import prod
from typing import Any, NamedTuple

import numpy as np

from ..record.graph import reached

COMPARED = {"lt": -1.0, "le": -1.0, "gt": 1.0, "ge": 1.0}  # the sign of a - b where they hold
WHOLE = ("floor", "ceil", "trunc", "floordiv")
# the questions that other operations decide: comparisons with 0 or of both, or whole numbers
QUESTIONS = {
    **{"minimum": ("lt",), "maximum": ("gt",), "sign": ("gt", "lt"), "fabs": ("ge",)},
    **{"mod": ("floordiv",), "pick": ("trunc",), "atan2": ("lt",)},
}
PLACES = ("search", "argmin")
LOCKED = frozenset({*COMPARED, *WHOLE, *QUESTIONS, *PLACES})
ROUNDING = 1e-12  # relative, of the numbers that are compared
Ref = Any


class Port(NamedTuple):
    """A value that is stored: its first place, lengths of its axes, and which of them loop."""

    first: int
    shape: tuple[int, ...]
    long: tuple[bool, ...]
    ref: Ref


def operands(kind: str, name: str, arguments: tuple[Ref, ...]) -> tuple[Ref, ...]:
    """Return the arguments of an operation that a question is about."""
    if kind == "atan2":  # which jumps where the first is 0 and the second below
        return arguments[0], 0.0
    if name in COMPARED:
        return arguments[0], arguments[1] if len(arguments) > 1 else 0.0
    return arguments if name in ("floordiv", "search") else arguments[-1:]


class Decisions:
    """The decisions of a diagram's rates, as they are and as they were when a step began."""

    def __init__(self, record: Any, grain: int):
        self.record, self.grain = record, grain  # place in P of the least difference that counts
        self.now: list[Port] = []
        self.distances: list[Port] = []
        self.least: list[Port] = []
        self.of: list[tuple] = []  # first place of each, and where it is made
        self.count = 0  # how many numbers are decided
        self.timed = False  # whether time alone decides
        self._true: list[Port] = []  # distances, also of numbers that are held

    def lock(self, rates: list[Port], held: Sequence[int] = ()) -> list[Port]:
        """Write the rates again with locked decisions; return them.

        Numbers that are `held` stay for good; they are counted from the first of these rates on.
        """
        record, locked, first = self.record, dict[int, Ref](), self.count
        moving: set[Ref] = set()  # entries that change within a step, with locked decisions
        fed: set[Ref] = set()  # entries that depend on states, or on inputs
        inputs = len(record.layout.P)

        def current(ref: Ref) -> Ref:
            return locked.get(ref, ref) if type(ref) is int else ref

        for k in sorted(reached(record.entries, [port.ref for port in rates])):
            kind, exact, shape, at = record.entries[k]
            places = [a for a in exact if type(a) is int]
            array, start = at if kind == "load" else ("", 0)
            moves = array in ("X", "t") or bool(moving.intersection(places))
            if array == "X" or (array == "P" and start >= inputs) or fed.intersection(places):
                fed.add(k)
            arguments = tuple(map(current, exact))
            if k in record.decided_by and moves:
                self.timed |= k not in fed
                locked[k] = self._lock(k, arguments, [first + place for place in held])
                moves = kind not in (*COMPARED, *WHOLE, *PLACES, "sign")
            elif not locked.keys().isdisjoint(places):
                locked[k] = record.add(kind, arguments, shape, at, record.owners[k])
            if moves:
                moving.add(k)
        return [p._replace(ref=current(p.ref)) for p in rates]

    def distance_of(self, place: int) -> Ref:
        """Return the distance of one number from its turn."""
        port = next(p for p in self._true if p.first <= place < p.first + prod(p.shape))
        return self.record.part(port.ref, place - port.first, ())

    def _lock(self, k: int, arguments: tuple[Ref, ...], held: Sequence[int]) -> Ref:
        """Note what an operation decides; return its locked value, of locked arguments."""
        (kind, exact, shape, at), owner = self.record.entries[k], self.record.owners[k]
        (long, of), answers = self.record.decided_by[k], list[Ref]()

        def add(kind: str, *refs: Ref, shape: Any = shape) -> Ref:
            return self.record.add(kind, refs, shape, at if kind == "search" else None, owner)

        for name in QUESTIONS.get(kind, (kind,)):
            now = add(name, *operands(kind, name, exact))
            if name in COMPARED:
                now = add("where", now, 1.0, -1.0)
            H = self.record.load("P", self.grain + 1 + self.count, shape)
            about = operands(kind, name, arguments)
            distance, least = self._distance(name, about, H, add)
            self._true.append(Port(self.count, shape, long, distance))
            stays = np.isin(np.arange(self.count, self.count + prod(shape)), held).astype(float)
            if stays.any():
                mask = self.record.add("constant", (), shape, stays.tobytes()) if shape else 1.0
                now, distance = add("where", mask, H, now), add("where", mask, 1.0, distance)
            self.now.append(Port(self.count, shape, long, now))
            self.distances.append(Port(self.count, shape, long, distance))
            self.least.append(Port(self.count, shape, long, least))
            self.of.append((self.count, of))
            self.count += prod(shape)
            answers.append(add("gt", H, 0.0) if name in COMPARED else H)
        if kind in COMPARED or kind in WHOLE or kind in PLACES:
            return answers[0]
        if kind == "sign":
            return add("where", answers[0], 1.0, add("where", answers[1], -1.0, 0.0))
        if kind == "fabs":
            return add("where", answers[0], arguments[0], add("neg", arguments[0]))
        if kind == "mod":
            beyond = add("sub", arguments[0], add("mul", arguments[1], answers[0]))
            same = add("eq", add("floordiv", *arguments), answers[0])
            return add("where", same, add("mod", *arguments), beyond)
        if kind == "atan2":
            angle, behind = add("atan2", *arguments), add("lt", arguments[1], 0.0)
            now = add("where", add("lt", arguments[0], 0.0), 1.0, 0.0)
            turns = add("sub", now, add("where", answers[0], 1.0, 0.0))
            on = add("add", angle, add("mul", turns, 2.0 * np.pi))
            return add("where", add("and", behind, add("ne", turns, 0.0)), on, angle)
        if kind == "pick":
            return add("pick", arguments[0], answers[0])
        return add("where", answers[0], *arguments)

    def _distance(self, name: str, of: tuple, H: Ref, add: Callable[..., Ref]) -> tuple[Ref, Ref]:
        """Return the distance of a decision from its turn, smooth in a step, and its rounding.

        That of a whole number is the product of those from the two places where it turns.
        """
        if name == "argmin":
            return self._distance_of_least(of[0], H, add)
        if name == "search":
            return self._distance_in_row(of[0], of[1], H, add)
        a, size = of[0], add("fabs", of[0])
        if name in COMPARED and of[1] != 0.0:
            size = add("add", size, add("fabs", of[1]))
        least = add("add", add("mul", size, ROUNDING), self.record.load("P", self.grain, ()))
        if name in COMPARED:
            difference = add("sub", *of)
            holds = add("neg", difference) if COMPARED[name] < 0 else difference
            return add("mul", holds, H), least
        low, high = H, add("add", H, 1.0)
        if name in ("ceil", "trunc"):
            low = add("sub", H, 1.0)
        if name == "ceil":
            high = H
        if name == "trunc":
            low = add("where", add("gt", H, 0.0), H, low)
            high = add("where", add("lt", H, 0.0), H, high)
        if name == "floordiv":
            low, high = add("mul", low, of[1]), add("mul", high, of[1])
            least = add("mul", least, add("fabs", of[1]))
        return add("mul", add("sub", a, low), add("sub", high, a)), least

    def _distance_in_row(self, row: Ref, x: Ref, H: Ref, add: Any) -> tuple[Ref, Ref]:
        """Return the distance of a value from the ends of its segment in a sorted row."""
        points = np.frombuffer(self.record.entries[row].at)
        below, above = (
            self.record.add("constant", (), one.shape, one.tobytes())
            for one in (np.append(points[:1], points), np.append(points, points[-1:]))
        )
        low, high = add("sub", x, add("pick", below, H)), add("sub", add("pick", above, H), x)
        inside = add("mul", low, high)  # the segments at the ends have one end
        last = add("ge", H, float(len(points)))
        distance = add("where", add("lt", H, 1.0), high, add("where", last, low, inside))
        width = add("where", add("or", add("lt", H, 1.0), last), 1.0, add("add", low, high))
        least = add(
            "add", add("mul", add("fabs", x), ROUNDING), self.record.load("P", self.grain, ())
        )
        return distance, add("mul", least, width)

    def _distance_of_least(self, row: Ref, H: Ref, add: Any) -> tuple[Ref, Ref]:
        """Return by how much the second least number of a row is above the least."""
        shape = self.record.shape_of(row)
        numbers = np.arange(float(shape[0]))
        places = self.record.add("constant", (), shape, numbers.tobytes())
        same = add("eq", places, H, shape=shape)
        others = add("where", same, np.inf, row, shape=shape)
        least = add("pick", row, H)
        second = add("pick", others, add("argmin", others))
        size = add("add", add("fabs", least), add("fabs", second))
        rounding = add("add", add("mul", size, ROUNDING), self.record.load("P", self.grain, ()))
        return add("sub", second, least), rounding
