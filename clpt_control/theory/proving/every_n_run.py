"""Run a block's function once for every number N of basis functions.

A loop `for k in range(p.N)` takes three turns with an index that nobody can ask for its
value.  At the start of the second turn, of the third and at the end the function must
stand in the same state: the same local variables, each what the turn before made of it.
Then every further turn does what the third did, and three stand for N; fewer turns are
the first of them.  What the turns compute is compared in the record (`native.loops`).

A whole number is c + n N + m k, k = 0 ... N - 1 the index of such a loop, good in its own
turn alone.  In a record N is 10^9 and k is 0, 1, 2, so that a place tells c, n and k apart.
"""

import dis
import sys
from collections.abc import Callable, Iterator
from types import CodeType, FrameType
from typing import Any

from ...blocks.functions import substituted
from ...blocks.trace import SUBSTITUTES, stand_in_for_opaque
from ...blocks.tracers import Condition, Number, Refused, Tape, operand
from ...equations.scalars import Scalars

BIG = 10**9
TURNS = 3


class Turn:
    """One turn of a loop over all functions."""

    def __init__(self, number: int):
        self.number, self.over = number, False


def _refuse(what: str) -> Callable[..., Any]:
    def refused(self: Any, *arguments: Any) -> Any:
        raise Refused(what, "for every N an index is used in sums, products and places only")

    return refused


class WholeNumber:
    """c + n N + m k."""

    __slots__ = ("c", "m", "n", "turn")

    def __init__(self, c: int, n: int = 0, m: int = 0, turn: Turn | None = None):
        self.c, self.n, self.m, self.turn = c, n, m, turn

    @classmethod
    def of(cls, value: Any) -> "WholeNumber":
        """Return a value as a whole number; refuse any other."""
        if type(value) is int:
            return cls(value)
        if not isinstance(value, WholeNumber):
            raise Refused("what is no whole number, as an index or a count", "use lookup")
        if value.turn is not None and value.turn.over:
            raise Refused("an index behind its loop", "use it within the loop over all functions")
        return value

    @property
    def code(self) -> int:
        """The value in a record."""
        return self.c + self.n * BIG + (self.m * self.turn.number if self.turn else 0)

    @property
    def key(self) -> tuple[int, int, int | None]:
        """The place in `out`: c, n and the turn, None for a single place."""
        return self.c, self.n, self.turn.number if self.turn else None

    def _added(self, other: Any, sign: int) -> Any:
        if not isinstance(other, int | WholeNumber):
            return NotImplemented
        a, b = WholeNumber.of(self), WholeNumber.of(other)
        if a.turn and b.turn and a.turn is not b.turn:
            raise Refused("two indices in one place", "use one loop over all functions")
        m = a.m + sign * b.m
        return WholeNumber(a.c + sign * b.c, a.n + sign * b.n, m, (a.turn or b.turn) if m else None)

    def __add__(self, other: Any) -> Any:
        return self._added(other, 1)

    def __sub__(self, other: Any) -> Any:
        return self._added(other, -1)

    def __mul__(self, other: Any) -> Any:
        if type(other) is not int:
            return NotImplemented
        a = WholeNumber.of(self)
        return WholeNumber(a.c * other, a.n * other, a.m * other, a.turn if other else None)

    def __neg__(self) -> Any:
        return self * -1

    def __rsub__(self, other: Any) -> Any:
        return -self + other

    __radd__, __rmul__ = __add__, __mul__
    __eq__ = __ne__ = _refuse("comparing an index or a number of functions")
    __lt__ = __le__ = __gt__ = __ge__ = _refuse("comparing an index or a number of functions")
    __hash__ = None  # type: ignore[assignment]
    __bool__ = _refuse("a choice by an index or a number of functions")
    __float__ = __int__ = __index__ = _refuse("the value of an index or a number of functions")


class Vector:
    """x, u or out, as long as a whole number, or a view of it that begins at `start`.

    `written` holds what was written into out, by `WholeNumber.key`.
    """

    __iter__ = None  # nothing walks through it but a loop over range

    def __init__(
        self, tape: Tape, name: str, start: WholeNumber, length: WholeNumber, written: Any = None
    ):
        self.tape, self.name, self.start, self.length = tape, name, start, length
        self.written = written

    def _place(self, index: Any) -> WholeNumber:
        at = WholeNumber.of(index)
        n = self.length.n - at.n - at.m  # room behind it: c + n N, for k = N - 1
        c = self.length.c - at.c - (0 if at.m else 1)
        if at.c < 0 or at.n < 0 or at.m not in (0, 1) or n < 0 or c + n < 0:
            raise Refused("a place that lies outside for some N", "stay within the ports")
        return self.start + at

    def __getitem__(self, index: Any) -> Any:
        if isinstance(index, slice):
            return self._view(index)
        place = self._place(index)
        if self.written is None:
            return self.tape.add(self.name, place.code)
        if place.key not in self.written:
            raise Refused("reading the last argument before it is written", "write it first")
        return self.written[place.key]

    def _view(self, index: slice) -> "Vector":
        first = WholeNumber.of(0 if index.start is None else index.start)
        last = self.length if index.stop is None else WholeNumber.of(index.stop)
        if index.step is not None or first.m or last.m:
            raise Refused("a slice like this one", "for every N use a slice from place to place")
        size, rest = last - first, self.length - last
        if any(one.n < 0 or one.c + one.n < 0 for one in (size, rest)) or min(first.c, first.n) < 0:
            raise Refused("a slice that lies outside for some N", "stay within the ports")
        return Vector(self.tape, self.name, self.start + first, size, self.written)

    def __setitem__(self, index: Any, value: Any) -> None:
        ref = operand(value)
        if self.written is None or ref is None:
            raise Refused("this assignment", "write numbers, into the last argument only")
        self.written[self._place(index).key] = (
            value if isinstance(value, Number) else Number(self.tape, ref)
        )


class ParameterArray:
    """A parameter array; an axis of N numbers takes an index k.

    It has no `shape` to ask.
    """

    __iter__ = None  # nothing walks through it but a loop over range

    def __init__(self, tape: Tape, field: str, sizes: tuple[int, ...], N: int, before: tuple = ()):
        self.tape, self.field, self.sizes, self.N, self.before = tape, field, sizes, N, before

    def __getitem__(self, index: Any) -> Any:
        places = list(self.before)
        for one in index if isinstance(index, tuple) else (index,):
            at = WholeNumber.of(one)
            size = self.sizes[len(places)] if len(places) < len(self.sizes) else 0
            single = at.m == 0 and at.n == 0 and 0 <= at.c < size
            if not single and ((at.c, at.n, at.m) != (0, 0, 1) or size != self.N):
                raise Refused(f"this place of `p.{self.field}`", "for every N use i or k itself")
            places.append(at)
        if len(places) < len(self.sizes):
            return ParameterArray(self.tape, self.field, self.sizes, self.N, tuple(places))
        code = 0
        for at in places:
            code = code * BIG + at.code
        return self.tape.add("p", self.field, code)


def run(function: Any, tape: Tape, given: tuple, written: dict) -> Scalars:
    """Run a block's function on (t, x, u, p, out) for every N and return the record.

    What it leaves in `out` is put into `written`, whose order the record's outputs have.
    """
    loops = _Loops(function.__code__, tape, written)
    length = lambda array: array.length if isinstance(array, Vector) else len(array)  # noqa: E731
    substitutes = {**SUBSTITUTES, "range": loops.over, "len": length}
    if substituted(function, substitutes, stand_in_for_opaque)(*given) is not None:
        raise Refused("returning a value", "fill the last argument: out[0] = ...")
    refs = tuple(number.ref for number in written.values())
    return Scalars(tuple(tape.operations), refs, tuple(tape.marks))


class _Loops:
    """The loops over all functions of a run."""

    def __init__(self, top: CodeType, tape: Tape, written: dict):
        self.top, self.tape, self.written = top, tape, written
        self.open = False

    def over(self, *bounds: Any) -> Iterator[Any]:
        """Return the turns in place of `range`: of N, or of a known number."""
        if all(type(bound) is int for bound in bounds):
            return self.tape.turns(*bounds)
        first, last = (0, *bounds) if len(bounds) == 1 else bounds[:2]
        N = WholeNumber.of(last)
        if len(bounds) > 2 or type(first) is not int or first or (N.c, N.n, N.m) != (0, 1, 0):
            raise Refused("a loop over a part or a multiple of the functions", "use range(p.N)")
        return self._all()

    def _all(self) -> Iterator[WholeNumber]:
        if self.open:
            raise Refused("a loop over all functions inside another", "keep sums apart")
        marks, tape = self.tape.marks, self.tape
        marks.append((len(tape.operations), "every"))
        self.open, starts, states = True, [len(tape.operations)], []
        for number in range(TURNS):
            turn = Turn(number)
            marks.append((len(tape.operations), "turn"))
            yield WholeNumber(0, 0, 1, turn)
            turn.over = True
            frame = sys._getframe(1)
            if dis.opname[frame.f_code.co_code[frame.f_lasti]] != "FOR_ITER":
                raise Refused("`range` without a loop", "use `for k in range(p.N)`")
            states.append(self._state(frame, starts))
            starts.append(len(tape.operations))
            if states[-1] != states[0]:
                raise Refused("turns that differ", "let every function be treated alike")
        self.open = False
        marks.append((len(tape.operations), "leave"))

    def _state(self, frame: FrameType | None, starts: list[int]) -> list:
        """Return all that a later turn depends on, relative to the turn that ended."""
        found: list[Any] = [len(self.tape.operations) - starts[-1]]

        def seen(value: Any) -> Any:
            if isinstance(value, Number | Condition):
                ref = value.ref
                if type(ref) is float:
                    return "constant", repr(ref)
                return ("before", ref) if ref < starts[0] else ("turn", ref - starts[-1])
            if isinstance(value, WholeNumber):
                return "whole", value.c, value.n, value.m, value.turn is not None
            if isinstance(value, Vector):
                return value.name, *map(seen, (value.start, value.length))
            if isinstance(value, ParameterArray):
                return value.field, *map(seen, value.before)
            if isinstance(value, int | float | bool | None):
                return type(value).__name__, repr(value)
            if type(value) is tuple:
                return tuple(map(seen, value))
            if hasattr(value, "_fields"):
                return type(value).__name__
            raise Refused(f"a {type(value).__name__} kept from turn to turn", "keep numbers")

        while frame is not None:
            found.append({name: seen(value) for name, value in frame.f_locals.items()})
            if frame.f_code is self.top:
                break
            frame = frame.f_back
        found.append({key: seen(v) for key, v in self.written.items() if key[2] is None})
        return found
