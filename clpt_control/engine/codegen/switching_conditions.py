"""Switching conditions: points where equations are not smooth, locked during a step.

    where(a < b, c, d),  minimum(a, b),  |a|,  sign(a),  floor(a),  atan2,  a row read at a place

A step across a kink is inaccurate, so the rates use the decisions of the step's beginning for the
whole step and are smooth.  The solver (`event_checks`, `event_location`) locates the crossing of a
condition and begins a new step there, with new decisions.

    H    decisions in force, in P: 1 or -1, the integer of a floor, the index in a row
    D    current decisions; the distance of each, positive while H holds; its rounding error

Source: Cellier and Kofman, Continuous System Simulation, 2006, chapter 9 (discontinuity locking).
"""

from collections.abc import Callable, Iterable, Sequence
from math import prod
from operator import attrgetter
from typing import Any, NamedTuple

import numpy as np

from ..record.graph import reached, values_among
from ..record.operations import SMOOTH, TABLE, named
from ..record.unread import Unread
from ..trace.arrays import Array, operand
from ..trace.derivative import Direction
from ..trace.elementwise import where
from ..trace.interpolators import lookup
from ..trace.ufuncs import place_of_the_least

# the sign of a - b where they hold
COMPARED = {"lt": -1.0, "le": -1.0, "gt": 1.0, "ge": 1.0}
WHOLE = ("floor", "ceil", "trunc", "floordiv")
PLACES = ("search", "argmin")
LOCKED = named(attrgetter("decisions"))
# functions without narrow peaks: sums and products of sines are as wide as their waves
WIDE = {"add", "sub", "mul", "neg", "sin", "cos", "sqrt"}
PEAKED = named(lambda row: row.smoothness == SMOOTH and row.slopes) - WIDE
ROUNDING = 1e-12  # relative, of the numbers that are compared
OF_TIME = 2e-15  # the same of time and parameters, which have no error of integration
NAN_IF_ANY = ("sign", "minimum", "maximum")  # NaN where an argument is NaN
Ref = Any


class Event(NamedTuple):
    """A switching condition or a guard: values that `decide` computes, ordered as a `Port`."""

    first: int
    shape: tuple[int, ...]
    long: tuple[bool, ...]
    now: Ref  # the decision; of a guard the distance with the decisions made now
    distance: Ref  # with the decisions of a step's beginning
    rounding: Ref
    unfixed: Ref = 0.0  # the distance, of fixed decisions too


class Port(NamedTuple):
    """A value that is stored: its first place, lengths of its axes, and which of them loop."""

    first: int
    shape: tuple[int, ...]
    long: tuple[bool, ...]
    ref: Ref


def operands(kind: str, name: str, arguments: tuple[Ref, ...]) -> tuple[Ref, ...]:
    """Return the arguments of an operation that a question is about."""
    if kind == "atan2":
        # which jumps where its first argument is 0 and its second is negative
        return arguments[0], 0.0
    if name in COMPARED:
        threshold = arguments[1] if len(arguments) > 1 else 0.0
        return arguments[0], threshold
    return arguments if name in ("floordiv", "search") else arguments[-1:]


def _locked_value(kind: str, arguments: list[Any], outcomes: list[Array]) -> Array:
    """Return the value of an operation with the outcomes of its decisions."""
    outcome = outcomes[0]
    if kind in COMPARED or kind in WHOLE or kind in PLACES:
        return outcome
    if kind == "sign":
        return where(outcome, 1.0, where(outcomes[1], -1.0, 0.0))
    if kind == "fabs":
        return where(outcome, arguments[0], -arguments[0])
    if kind == "mod":
        a, b = arguments
        is_same_turn = a // b == outcome
        return where(is_same_turn, a % b, a - b * outcome)
    if kind == "atan2":
        y, x = arguments
        turns = where(y < 0.0, 1.0, 0.0) - where(outcome, 1.0, 0.0)
        has_turned = np.logical_and(x < 0.0, turns != 0.0)
        angle = np.atan2(y, x)
        return where(has_turned, angle + turns * (2.0 * np.pi), angle)
    if kind == "pick":
        return lookup(arguments[0], outcome)
    return where(outcome, *arguments)


class Decisions:
    """The decisions of a diagram's rates, as they are and as they were when a step began."""

    def __init__(self, record: Any, tolerances: int):
        self.record = record
        self.tolerances = tolerances  # offset in P: relative, absolute
        self.first = tolerances + 2  # offset in P of the decisions
        self.events: list[Event] = []
        self.of: list[tuple] = []  # first place of each, and where it is made
        self.count = 0  # how many numbers are decided
        # whether time alone decides, or is read by a function that may have narrow peaks
        self.timed = False
        self.ramped = False  # whether such a function reads inputs
        self.first_count = 0  # of the first rates
        self._first = dict[
            int, Ref
        ]()  # entries with locked decisions of the first rates
        self._numbers = dict[tuple, int]()  # of each operation's decisions in these
        self._block = 0  # how many numbers were decided before
        self._sources: dict[int, frozenset[str]] = {}  # arrays that an entry reads
        # change of values with states that change by rounding
        self._bound = change_with(record, lambda size: ROUNDING * size)

    def lock(
        self, rates: list[Port], fixed: Sequence[int] = (), flipped: Sequence[int] = ()
    ) -> list[Port]:
        """Write the rates again with locked decisions; return them.

        Decisions that are `fixed` stay for good.  The second and later times, those that are
        `flipped` are on their other side, which P holds in the next `first_count` numbers; what
        does not depend on them is shared with the first rates.
        """
        record = self.record
        entries = sorted(reached(record.entries, [port.ref for port in rates]))
        self._mark_peaks(entries)
        locked = dict[int, Ref]()
        # entries with fixed decisions on their side, and others as they are
        settled = dict[int, Ref]()
        again = self.count > 0
        self._block = self.count
        # entries that change within a step, with locked decisions
        moving: set[Ref] = set()

        def current(ref: Ref) -> Ref:
            return locked.get(ref, ref) if type(ref) is int else ref

        for k in entries:
            kind, exact, _, at = record.entries[k]
            refs = values_among(exact)
            is_moving = kind == "load" and at[0] in ("X", "t")
            moves = is_moving or not moving.isdisjoint(refs)
            arguments = tuple(map(current, exact))
            exact_settled = tuple(
                settled.get(a, a) if type(a) is int else a for a in exact
            )
            is_shared = again and all(
                locked.get(ref) == self._first.get(ref) for ref in refs
            )
            if k in record.decided_by and moves:
                self.timed |= self._arrays_of([k]).isdisjoint("UX")
                locked[k], settled[k] = self._lock(
                    k, arguments, exact_settled, fixed, flipped, is_shared
                )
                moves = kind not in (*COMPARED, *WHOLE, *PLACES, "sign")
            elif not locked.keys().isdisjoint(refs):
                locked[k] = self._first[k] if is_shared else self._of(k, arguments)
            if k not in settled and exact_settled != exact:
                settled[k] = self._of(k, exact_settled)
            if moves:
                moving.add(k)
        if again:
            self.count += self.first_count
        else:
            self._first = locked
            self.first_count = self.count
        return [p._replace(ref=current(p.ref)) for p in rates]

    def _mark_peaks(self, entries: Iterable[int]) -> None:
        """Note whether functions with narrow peaks read time, or inputs without states."""
        timely: set[int] = set()  # entries that depend on time, and not on inputs
        for k in entries:
            kind, arguments, _, at = self.record.entries[k]
            has_inputs = "U" in self._arrays_of([k])
            is_time = kind == "load" and at[0] == "t"
            is_timely = is_time or not timely.isdisjoint(values_among(arguments))
            if is_timely and not has_inputs and kind not in COMPARED:
                timely.add(k)
            if kind not in PEAKED:
                continue
            peaked = values_among(
                arguments[kind == "div" :]
            )  # of a quotient, the divisor
            sources = [{"U", "X"} & self._arrays_of([ref]) for ref in peaked]
            self.ramped |= {"U"} in sources
            self.timed |= not has_inputs and not timely.isdisjoint(peaked)

    def _of(self, k: int, arguments: tuple[Ref, ...]) -> Ref:
        """Write an entry again, of other arguments."""
        kind, _, shape, at = self.record.entries[k]
        return self.record.add(kind, arguments, shape, at, self.record.owners[k])

    def distance_of(self, number: int) -> Ref:
        """Return the distance of a single decision from its switching point."""
        for event in self.events:
            offset = number - event.first
            if 0 <= offset < prod(event.shape):
                return self.record.part(event.unfixed, offset, ())
        raise IndexError(number)

    def _lock(
        self,
        k: int,
        arguments: tuple[Ref, ...],
        settled: tuple[Ref, ...],
        fixed: Sequence[int],
        flipped: Sequence[int],
        is_shared: bool,
    ) -> tuple[Ref, Ref]:
        """Note what an operation decides of `settled` arguments, with fixed decisions.

        Return its locked value, of locked arguments, and its value with fixed decisions.
        `is_shared` says that the arguments are those of the first rates.
        """
        record = self.record
        value_of = record.tape.value
        kind, exact, shape, at = record.entries[k]
        long, made_in = record.decided_by[k]
        side = at if kind == "search" else None
        outcomes = list[Array]()
        in_force = list[Array]()
        size = prod(shape)
        flips = False
        stays = np.zeros(shape, dtype=bool)

        def loaded(number: int) -> Array:
            return value_of(record.load("P", self.first + number, shape))

        for position, name in enumerate(TABLE[kind].decisions):
            first = self._numbers.setdefault((k, position), self.count)
            number = first + self._block
            numbers = np.arange(first, first + size).reshape(shape)
            is_fixed = np.isin(numbers, fixed)
            stays |= is_fixed
            H = loaded(number)
            # the decision now, and its distance from the decision in force
            now, distance, least, unfixed = H, 1.0, 0.0, 1.0
            if not is_shared:
                decided = operands(kind, name, settled)
                now = record.tape.add(name, decided, shape, side)
                if name in COMPARED:
                    now = where(now, 1.0, -1.0)
                    # `isfinite` compares with infinity: it may read NaN
                    reads = () if np.inf in decided else values_among(decided)
                    for read in map(value_of, reads):
                        now = where(read == read, now, np.nan)
                compared = operands(kind, name, arguments)
                distance, least = self._distance(name, compared, H)
                least = least + self._rounding(operand(distance))
                unfixed = distance
                # fixed decisions stay as they are
                now = _chosen(is_fixed, H, now)
                distance = _chosen(is_fixed, 1.0, distance)
            values = map(operand, (now, distance, least, unfixed))
            self.events.append(Event(number, shape, long, *values))
            self.of.append((number, made_in))
            if is_shared:
                other_side = np.isin(numbers, flipped)
                flips |= bool(other_side.any())
                H = _chosen(other_side, H, loaded(first))
            if self._block == 0:
                self.count += size
            outcomes.append(H > 0.0 if name in COMPARED else H)
            in_force.append(H)

        def locked_value(refs: tuple[Ref, ...]) -> Array:
            value = _locked_value(kind, [*map(value_of, refs)], outcomes)
            if kind not in NAN_IF_ANY:
                return value
            # 1, or NaN
            return value * (in_force[0] * in_force[0])

        value = k if settled == exact else self._of(k, settled)
        if stays.any():
            value = operand(_chosen(stays, locked_value(settled), value_of(value)))
        if is_shared and not flips:
            return self._first[k], value
        locked = operand(locked_value(arguments))
        record.owners.setdefault(locked, record.owners[k])
        return locked, value

    def _distance(self, name: str, of: tuple[Ref, ...], H: Array) -> tuple[Any, Any]:
        """Return the distance of a decision from its turn, smooth in a step, and its rounding.

        That of a whole number is the product of those from the two places where it turns.
        """
        a, *others = map(self.record.tape.value, of)
        if name == "argmin":
            return _distance_of_least(a, H)
        if name == "search":
            return _distance_in_row(a, others[0], H)
        size = abs(a)
        if name in COMPARED and of[1] != 0.0:
            size = size + abs(others[0])
        arrays = self._arrays_of(of)
        is_of_time = "t" in arrays and arrays <= {*"tPU"}
        least = size * (OF_TIME if is_of_time else ROUNDING)
        if name in COMPARED:
            difference = a - others[0]
            if COMPARED[name] < 0:
                difference = -difference
            return difference * H, least
        low = H
        high = H + 1.0
        if name in ("ceil", "trunc"):
            low = H - 1.0
        if name == "ceil":
            high = H
        if name == "trunc":
            low = where(H > 0.0, H, low)
            high = where(H < 0.0, H, high)
        if name == "floordiv":
            divisor = others[0]
            low = low * divisor
            high = high * divisor
            least = least * abs(divisor)
        return (a - low) * (high - a), least

    def _arrays_of(self, refs: Sequence[Ref]) -> frozenset[str]:
        """Return the arrays that values are computed of: t, X, P and T; U of inputs in P."""
        entries = self.record.entries
        for k in sorted(reached(entries, refs, self._sources)):
            kind, arguments, _, at = entries[k]
            own = at[0] if kind == "load" else ""
            if own == "P" and at[1] >= len(self.record.layout.P):
                own = "U"
            self._sources[k] = self._union_of(arguments).union(own)
        return self._union_of(refs)

    def _union_of(self, refs: Sequence[Ref]) -> frozenset[str]:
        return frozenset[str]().union(
            *(self._sources[ref] for ref in values_among(refs))
        )

    def rounding_of(self, distance: Ref) -> Ref:
        """Return the rounding error of a guard's distance: of its operands, and of its states."""
        tape = self.record.tape
        rounding = self._rounding(distance)
        if type(distance) is float:
            return rounding
        kind, arguments, *_ = tape.operations[distance]
        if kind in ("add", "sub"):
            for ref in arguments:
                value = tape.value(ref) if type(ref) is int else ref
                rounding = rounding + ROUNDING * np.fabs(value)
        return operand(rounding)

    def _rounding(self, distance: Ref) -> Any:
        """Return by how much a distance changes with states that change by rounding."""
        if type(distance) is float:
            return 0.0
        try:
            return self._bound.of(self.record.tape.value(distance))
        except Unread:
            return 0.0


def change_with(record: Any, change: Callable[[Any], Any]) -> Direction:
    """Return by how much values change at most with states that change as their sizes say."""

    def slope_of(k: int) -> Any:
        array, _ = record.entries[k].at
        return change(np.fabs(record.tape.value(k))) if array == "X" else None

    return Direction(record.tape, slope_of, bound=True)


def _chosen(mask: np.ndarray, value: Any, other: Any) -> Any:
    """Return a value where a constant mask is true, and another elsewhere."""
    if mask.all():
        return value
    return where(mask, value, other) if mask.any() else other


def _distance_in_row(points: Array, x: Any, H: Array) -> tuple[Any, Any]:
    """Return the distance of a value from the ends of its segment in a sorted row."""
    low = x - lookup(np.concatenate([points[:1], points]), H)
    high = lookup(np.concatenate([points, points[-1:]]), H) - x
    # the segments at the ends of the row have one end
    is_last = float(len(points)) <= H
    is_first = H < 1.0
    distance = where(is_first, high, where(is_last, low, low * high))
    width = where(np.logical_or(is_first, is_last), 1.0, low + high)
    return distance, abs(x) * ROUNDING * width


def _distance_of_least(row: Array, H: Array) -> tuple[Any, Any]:
    """Return by how much the second least number of a row is above the least."""
    remaining = where(np.arange(float(row.size)) == H, np.inf, row)
    least = lookup(row, H)
    second_least = lookup(remaining, place_of_the_least(remaining))
    return second_least - least, (abs(least) + abs(second_least)) * ROUNDING
