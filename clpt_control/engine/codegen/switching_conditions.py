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
from ..record.operations import TABLE, named

COMPARED = {"lt": -1.0, "le": -1.0, "gt": 1.0, "ge": 1.0}  # the sign of a - b where they hold
WHOLE = ("floor", "ceil", "trunc", "floordiv")
PLACES = ("search", "argmin")
LOCKED = named(lambda row: row.decisions)
ROUNDING = 1e-12  # relative, of the numbers that are compared
Ref = Any
Add = Callable[..., Ref]  # writes an operation of arguments; returns its value


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


def _locked_value(kind: str, arguments: tuple[Ref, ...], outcomes: list[Ref], add: Add) -> Ref:
    """Return the value of an operation with the outcomes of its decisions."""
    outcome = outcomes[0]
    if kind in COMPARED or kind in WHOLE or kind in PLACES:
        return outcome
    if kind == "sign":
        negative = add("where", outcomes[1], -1.0, 0.0)
        return add("where", outcome, 1.0, negative)
    if kind == "fabs":
        return add("where", outcome, arguments[0], add("neg", arguments[0]))
    if kind == "mod":
        beyond = add("sub", arguments[0], add("mul", arguments[1], outcome))
        is_same_turn = add("eq", add("floordiv", *arguments), outcome)
        return add("where", is_same_turn, add("mod", *arguments), beyond)
    if kind == "atan2":
        angle = add("atan2", *arguments)
        behind = add("lt", arguments[1], 0.0)
        now = add("where", add("lt", arguments[0], 0.0), 1.0, 0.0)
        turns = add("sub", now, add("where", outcome, 1.0, 0.0))
        continued = add("add", angle, add("mul", turns, 2.0 * np.pi))
        has_turned = add("and", behind, add("ne", turns, 0.0))
        return add("where", has_turned, continued, angle)
    if kind == "pick":
        return add("pick", arguments[0], outcome)
    return add("where", outcome, *arguments)


class Decisions:
    """The decisions of a diagram's rates, as they are and as they were when a step began."""

    def __init__(self, record: Any, grain: int):
        self.record = record
        self.grain = grain  # offset in P of the least difference that counts
        self.now: list[Port] = []
        self.distances: list[Port] = []
        self.least: list[Port] = []
        self.of: list[tuple] = []  # first place of each, and where it is made
        self.count = 0  # how many numbers are decided
        self.timed = False  # whether time alone decides
        self._true: list[Port] = []  # distances, also of numbers that are held

    def lock(self, rates: list[Port], fixed: Sequence[int] = ()) -> list[Port]:
        """Write the rates again with locked decisions; return them.

        Decisions that are `fixed` stay for good; they are counted from the first of these rates on.
        """
        record = self.record
        locked = dict[int, Ref]()
        first_decision = self.count
        moving: set[Ref] = set()  # entries that change within a step, with locked decisions
        fed: set[Ref] = set()  # entries that depend on states, or on inputs
        inputs = len(record.layout.P)

        def current(ref: Ref) -> Ref:
            return locked.get(ref, ref) if type(ref) is int else ref

        for k in sorted(reached(record.entries, [port.ref for port in rates])):
            kind, exact, shape, at = record.entries[k]
            refs = [argument for argument in exact if type(argument) is int]
            array, offset = at if kind == "load" else ("", 0)
            is_input = array == "P" and offset >= inputs
            if array == "X" or is_input or fed.intersection(refs):
                fed.add(k)
            moves = array in ("X", "t") or bool(moving.intersection(refs))
            arguments = tuple(map(current, exact))
            if k in record.decided_by and moves:
                self.timed |= k not in fed
                fixed_decisions = [first_decision + number for number in fixed]
                locked[k] = self._lock(k, arguments, fixed_decisions)
                moves = kind not in (*COMPARED, *WHOLE, *PLACES, "sign")
            elif not locked.keys().isdisjoint(refs):
                locked[k] = record.add(kind, arguments, shape, at, record.owners[k])
            if moves:
                moving.add(k)
        return [p._replace(ref=current(p.ref)) for p in rates]

    def distance_of(self, number: int) -> Ref:
        """Return the distance of one number from its turn."""
        port = next(p for p in self._true if p.first <= number < p.first + prod(p.shape))
        return self.record.part(port.ref, number - port.first, ())

    def _lock(self, k: int, arguments: tuple[Ref, ...], fixed: Sequence[int]) -> Ref:
        """Note what an operation decides; return its locked value, of locked arguments."""
        record = self.record
        kind, exact, shape, at = record.entries[k]
        owner = record.owners[k]
        long, made_in = record.decided_by[k]
        outcomes = list[Ref]()

        def add(kind: str, *refs: Ref, shape: Any = shape) -> Ref:
            return record.add(kind, refs, shape, at if kind == "search" else None, owner)

        for name in TABLE[kind].decisions:
            now = add(name, *operands(kind, name, exact))
            if name in COMPARED:
                now = add("where", now, 1.0, -1.0)
            H = record.load("P", self.grain + 1 + self.count, shape)
            compared = operands(kind, name, arguments)
            distance, least = self._distance(name, compared, H, add)
            self._true.append(Port(self.count, shape, long, distance))
            numbers = np.arange(self.count, self.count + prod(shape))
            stays = np.isin(numbers, fixed).astype(float)
            if stays.any():
                mask = record.add("constant", (), shape, stays.tobytes()) if shape else 1.0
                now = add("where", mask, H, now)
                distance = add("where", mask, 1.0, distance)
            self.now.append(Port(self.count, shape, long, now))
            self.distances.append(Port(self.count, shape, long, distance))
            self.least.append(Port(self.count, shape, long, least))
            self.of.append((self.count, made_in))
            self.count += prod(shape)
            outcomes.append(add("gt", H, 0.0) if name in COMPARED else H)
        return _locked_value(kind, arguments, outcomes, add)

    def _distance(self, name: str, of: tuple, H: Ref, add: Add) -> tuple[Ref, Ref]:
        """Return the distance of a decision from its turn, smooth in a step, and its rounding.

        That of a whole number is the product of those from the two places where it turns.
        """
        if name == "argmin":
            return self._distance_of_least(of[0], H, add)
        if name == "search":
            return self._distance_in_row(of[0], of[1], H, add)
        a = of[0]
        size = add("fabs", of[0])
        if name in COMPARED and of[1] != 0.0:
            size = add("add", size, add("fabs", of[1]))
        least = self._rounding(size, add)
        if name in COMPARED:
            difference = add("sub", *of)
            holds = add("neg", difference) if COMPARED[name] < 0 else difference
            return add("mul", holds, H), least
        low = H
        high = add("add", H, 1.0)
        if name in ("ceil", "trunc"):
            low = add("sub", H, 1.0)
        if name == "ceil":
            high = H
        if name == "trunc":
            low = add("where", add("gt", H, 0.0), H, low)
            high = add("where", add("lt", H, 0.0), H, high)
        if name == "floordiv":
            low = add("mul", low, of[1])
            high = add("mul", high, of[1])
            least = add("mul", least, add("fabs", of[1]))
        return add("mul", add("sub", a, low), add("sub", high, a)), least

    def _distance_in_row(self, row: Ref, x: Ref, H: Ref, add: Add) -> tuple[Ref, Ref]:
        """Return the distance of a value from the ends of its segment in a sorted row."""
        points = np.frombuffer(self.record.entries[row].at)
        below, above = (
            self.record.add("constant", (), bounds.shape, bounds.tobytes())
            for bounds in (np.append(points[:1], points), np.append(points, points[-1:]))
        )
        low = add("sub", x, add("pick", below, H))
        high = add("sub", add("pick", above, H), x)
        # the segments at the ends of the row have one end
        inside = add("mul", low, high)
        is_last = add("ge", H, float(len(points)))
        is_first = add("lt", H, 1.0)
        distance = add("where", is_first, high, add("where", is_last, low, inside))
        is_at_end = add("or", is_first, is_last)
        width = add("where", is_at_end, 1.0, add("add", low, high))
        least = self._rounding(add("fabs", x), add)
        return distance, add("mul", least, width)

    def _distance_of_least(self, row: Ref, H: Ref, add: Add) -> tuple[Ref, Ref]:
        """Return by how much the second least number of a row is above the least."""
        shape = self.record.shape_of(row)
        numbers = np.arange(float(shape[0]))
        positions = self.record.add("constant", (), shape, numbers.tobytes())
        is_least = add("eq", positions, H, shape=shape)
        remaining = add("where", is_least, np.inf, row, shape=shape)
        least = add("pick", row, H)
        second_least = add("pick", remaining, add("argmin", remaining))
        size = add("add", add("fabs", least), add("fabs", second_least))
        rounding = self._rounding(size, add)
        return add("sub", second_least, least), rounding

    def _rounding(self, size: Ref, add: Add) -> Ref:
        """Return the rounding of a difference of numbers of a size."""
        return add("add", add("mul", size, ROUNDING), self.record.load("P", self.grain, ()))
