"""Switching conditions: points where equations are not smooth, locked during a step.

    where(a < b, c, d),  minimum(a, b),  |a|,  sign(a),  floor(a),  atan2,  a row read at a place

A step across a kink is inaccurate, so the rates use the decisions of the step's beginning for the
whole step and are smooth.  The solver (`event_checks`, `event_location`) locates the crossing of a
condition and begins a new step there, with new decisions.

    H    decisions in force, in P: 1 or -1, the integer of a floor, the index in a row
    D    current decisions; the distance of each, positive while H holds; its rounding error

Source: Cellier and Kofman, Continuous System Simulation, 2006, chapter 9 (discontinuity locking).
"""

from collections.abc import Callable, Collection, Iterable, Sequence
from math import prod
from operator import attrgetter
from typing import Any, NamedTuple

import numpy as np

from ..record.graph import reached, values_among
from ..record.operations import SMOOTH, TABLE, named
from ..record.unread import Unread
from ..trace.arrays import operand
from ..trace.derivative import Direction

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
Add = Callable[..., Ref]  # writes an operation of arguments; returns its value


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


def _locked_value(
    kind: str, arguments: tuple[Ref, ...], outcomes: list[Ref], add: Add
) -> Ref:
    """Return the value of an operation with the outcomes of its decisions."""
    outcome = outcomes[0]
    if kind in COMPARED or kind in WHOLE or kind in PLACES:
        return outcome
    if kind == "sign":
        negative = add("where", outcomes[1], -1.0, 0.0)
        return add("where", outcome, 1.0, negative)
    if kind == "fabs":
        negative = add("neg", arguments[0])
        return add("where", outcome, arguments[0], negative)
    if kind == "mod":
        multiple = add("mul", arguments[1], outcome)
        beyond = add("sub", arguments[0], multiple)
        quotient = add("floordiv", *arguments)
        is_same_turn = add("eq", quotient, outcome)
        remainder = add("mod", *arguments)
        return add("where", is_same_turn, remainder, beyond)
    if kind == "atan2":
        angle = add("atan2", *arguments)
        behind = add("lt", arguments[1], 0.0)
        is_below = add("lt", arguments[0], 0.0)
        now = add("where", is_below, 1.0, 0.0)
        before = add("where", outcome, 1.0, 0.0)
        turns = add("sub", now, before)
        change = add("mul", turns, 2.0 * np.pi)
        continued = add("add", angle, change)
        is_other_turn = add("ne", turns, 0.0)
        has_turned = add("and", behind, is_other_turn)
        return add("where", has_turned, continued, angle)
    if kind == "pick":
        return add("pick", arguments[0], outcome)
    return add("where", outcome, *arguments)


class Decisions:
    """The decisions of a diagram's rates, as they are and as they were when a step began."""

    def __init__(self, record: Any, tolerances: int):
        self.record = record
        self.tolerances = tolerances  # offset in P: relative, absolute
        self.first = tolerances + 2  # offset in P of the decisions
        self.now: list[Port] = []
        self.distances: list[Port] = []
        self.least: list[Port] = []
        self.of: list[tuple] = []  # first place of each, and where it is made
        self.operations: list[int] = []  # the first decision of each operation
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
        self._bounded: set[int] = set()  # entries whose states have a rounding error
        self._bound = Direction(record.tape, {}, bound=True)
        self._true: list[Port] = []  # distances, also of numbers that are held

    def lock(
        self,
        rates: list[Port],
        fixed: Sequence[int] = (),
        flipped: Sequence[int] = (),
        passed: Collection[int] = (),
    ) -> list[Port]:
        """Write the rates again with locked decisions; return them.

        Decisions that are `fixed` stay for good.  The second and later times, those that are
        `flipped` are on their other side, which P holds in the next `first_count` numbers; what
        does not depend on them is shared with the first rates.  Operations that are `passed`,
        counted in the order in which they are locked, are not.
        """
        record = self.record
        entries = sorted(reached(record.entries, [port.ref for port in rates]))
        self._mark_peaks(entries)
        locked = dict[int, Ref]()
        # entries with fixed decisions on their side, and others as they are
        settled = dict[int, Ref]()
        again = self.count > 0
        self._block = self.count
        operation = -1  # of those that decide
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
            decides = k in record.decided_by and moves
            operation += decides
            if decides and operation not in passed:
                self.operations.append(self.count)
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
        for port in self._true:
            offset = number - port.first
            if 0 <= offset < prod(port.shape):
                return self.record.part(port.ref, offset, ())
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
        kind, exact, shape, at = record.entries[k]
        owner = record.owners[k]
        long, made_in = record.decided_by[k]
        outcomes = list[Ref]()
        in_force = list[Ref]()
        size = prod(shape)
        flips = False
        stays = np.zeros(shape, dtype=bool)

        def add(kind: str, *refs: Ref, shape: Any = shape) -> Ref:
            side = at if kind == "search" else None
            return record.add(kind, refs, shape, side, owner)

        for position, name in enumerate(TABLE[kind].decisions):
            first = self._numbers.setdefault((k, position), self.count)
            number = first + self._block
            numbers = np.arange(first, first + size).reshape(shape)
            is_fixed = np.isin(numbers, fixed)
            stays |= is_fixed
            H = record.load("P", self.first + number, shape)
            # the decision now, and its distance from the decision in force
            now, distance, least = H, 1.0, 0.0
            if not is_shared:
                now = add(name, *operands(kind, name, settled))
                if name in COMPARED:
                    now = add("where", now, 1.0, -1.0)
                compared = operands(kind, name, arguments)
                distance, least = self._distance(name, compared, H, add)
                least = operand(record.tape.value(least) + self._rounding(distance))
                if kind in NAN_IF_ANY:
                    now = self._unless_nan(
                        operands(kind, name, settled), now, np.nan, add
                    )
                    distance = self._unless_nan(compared, distance, -1.0, add)
                    least = self._unless_nan(compared, least, 0.0, add)
                self._true.append(Port(number, shape, long, distance))
                # fixed decisions stay as they are
                now = self._chosen(is_fixed, H, now, add)
                distance = self._chosen(is_fixed, 1.0, distance, add)
            self.now.append(Port(number, shape, long, now))
            self.distances.append(Port(number, shape, long, distance))
            self.least.append(Port(number, shape, long, least))
            self.of.append((number, made_in))
            if is_shared:
                other_side = np.isin(numbers, flipped)
                flips |= bool(other_side.any())
                shared = record.load("P", self.first + first, shape)
                H = self._chosen(other_side, H, shared, add)
            if self._block == 0:
                self.count += size
            outcome = add("gt", H, 0.0) if name in COMPARED else H
            outcomes.append(outcome)
            in_force.append(H)

        def locked_value(refs: tuple[Ref, ...]) -> Ref:
            value = _locked_value(kind, refs, outcomes, add)
            if kind not in NAN_IF_ANY:
                return value
            # 1, or NaN
            return add("mul", value, add("mul", in_force[0], in_force[0]))

        value = k if settled == exact else self._of(k, settled)
        if stays.any():
            held = locked_value(settled)
            value = self._chosen(stays, held, value, add)
        if is_shared and not flips:
            return self._first[k], value
        return locked_value(arguments), value

    def _unless_nan(self, of: tuple, value: Ref, other: Ref, add: Add) -> Ref:
        """Return a value, or another where one of the operands is NaN."""
        for ref in of:
            if type(ref) is not float:
                value = add("where", add("eq", ref, ref), value, other)
        return value

    def _chosen(self, mask: np.ndarray, value: Ref, other: Ref, add: Add) -> Ref:
        """Return a value where a constant mask is true, and another elsewhere."""
        if mask.all():
            return value
        if not mask.any():
            return other
        return add("where", self._row(mask.astype(float)), value, other)

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
            threshold_size = add("fabs", of[1])
            size = add("add", size, threshold_size)
        arrays = self._arrays_of(of)
        is_of_time = "t" in arrays and arrays <= {*"tPU"}
        least = add("mul", size, OF_TIME if is_of_time else ROUNDING)
        if name in COMPARED:
            difference = add("sub", *of)
            if COMPARED[name] < 0:
                difference = add("neg", difference)
            return add("mul", difference, H), least
        low = H
        high = add("add", H, 1.0)
        if name in ("ceil", "trunc"):
            low = add("sub", H, 1.0)
        if name == "ceil":
            high = H
        if name == "trunc":
            is_positive = add("gt", H, 0.0)
            low = add("where", is_positive, H, low)
            is_negative = add("lt", H, 0.0)
            high = add("where", is_negative, H, high)
        if name == "floordiv":
            divisor = of[1]
            low = add("mul", low, divisor)
            high = add("mul", high, divisor)
            divisor_size = add("fabs", divisor)
            least = add("mul", least, divisor_size)
        above_low = add("sub", a, low)
        below_high = add("sub", high, a)
        return add("mul", above_low, below_high), least

    def _distance_in_row(self, row: Ref, x: Ref, H: Ref, add: Add) -> tuple[Ref, Ref]:
        """Return the distance of a value from the ends of its segment in a sorted row."""
        points = np.frombuffer(self.record.entries[row].at)
        below = self._row(np.append(points[:1], points))
        above = self._row(np.append(points, points[-1:]))
        segment_start = add("pick", below, H)
        low = add("sub", x, segment_start)
        segment_end = add("pick", above, H)
        high = add("sub", segment_end, x)
        # the segments at the ends of the row have one end
        inside = add("mul", low, high)
        is_last = add("ge", H, float(len(points)))
        is_first = add("lt", H, 1.0)
        not_first = add("where", is_last, low, inside)
        distance = add("where", is_first, high, not_first)
        is_at_end = add("or", is_first, is_last)
        inside_width = add("add", low, high)
        width = add("where", is_at_end, 1.0, inside_width)
        size = add("fabs", x)
        least = add("mul", size, ROUNDING)
        return distance, add("mul", least, width)

    def _row(self, numbers: np.ndarray) -> Ref:
        return self.record.add("constant", (), numbers.shape, numbers.tobytes())

    def _distance_of_least(self, row: Ref, H: Ref, add: Add) -> tuple[Ref, Ref]:
        """Return by how much the second least number of a row is above the least."""
        shape = self.record.shape_of(row)
        positions = self._row(np.arange(float(shape[0])))
        is_least = add("eq", positions, H, shape=shape)
        remaining = add("where", is_least, np.inf, row, shape=shape)
        least = add("pick", row, H)
        index = add("argmin", remaining)
        second_least = add("pick", remaining, index)
        least_size = add("fabs", least)
        second_size = add("fabs", second_least)
        size = add("add", least_size, second_size)
        rounding = add("mul", size, ROUNDING)
        return add("sub", second_least, least), rounding

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
        record = self.record
        if type(distance) is float:
            return 0.0
        new = reached(record.entries, [distance], self._bounded)
        self._bounded |= new
        for k in new:
            kind, _, _, at = record.entries[k]
            if kind == "load" and at[0] == "X":
                self._bound.known.setdefault(
                    k, ROUNDING * np.fabs(record.tape.value(k))
                )
        try:
            return self._bound.of(record.tape.value(distance))
        except Unread:
            return 0.0
