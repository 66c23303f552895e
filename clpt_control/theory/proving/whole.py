"""Whole numbers and arrays of a block whose number of functions N is any.

A whole number is c + n N + m k, k = 0 ... N - 1 the index of a loop over all
functions.  The loop takes three turns, which stand for all: the index is good in its own
turn alone, and nothing may ask for its value.  In a record N is 10^9 and k is 0, 1, 2, so
that a place tells c, n and k apart.
"""

from collections.abc import Callable
from typing import Any

from ...blocks.tracers import Number, Refused, Tape, operand

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


class Whole:
    """c + n N + m k."""

    __slots__ = ("c", "m", "n", "turn")

    def __init__(self, c: int, n: int = 0, m: int = 0, turn: Turn | None = None):
        self.c, self.n, self.m, self.turn = c, n, m, turn

    @classmethod
    def of(cls, value: Any) -> "Whole":
        """Return a whole number; refuse what is none."""
        if type(value) is int:
            return cls(value)
        if not isinstance(value, Whole):
            raise Refused("what is no whole number, as an index or a count", "use lookup")
        if value.turn is not None and value.turn.over:
            raise Refused("an index behind its loop", "use it within the loop over all functions")
        return value

    @property
    def code(self) -> int:
        """Its value in a record."""
        return self.c + self.n * BIG + (self.m * self.turn.number if self.turn else 0)

    @property
    def key(self) -> tuple[int, int, int | None]:
        """What tells a place written by turns from a single one."""
        return self.c, self.n, self.turn.number if self.turn else None

    def _added(self, other: Any, sign: int) -> Any:
        if not isinstance(other, int | Whole):
            return NotImplemented
        a, b = Whole.of(self), Whole.of(other)
        if a.turn and b.turn and a.turn is not b.turn:
            raise Refused("two indices in one place", "use one loop over all functions")
        m = a.m + sign * b.m
        return Whole(a.c + sign * b.c, a.n + sign * b.n, m, (a.turn or b.turn) if m else None)

    def __add__(self, other: Any) -> Any:
        return self._added(other, 1)

    def __sub__(self, other: Any) -> Any:
        return self._added(other, -1)

    def __mul__(self, other: Any) -> Any:
        if type(other) is not int:
            return NotImplemented
        a = Whole.of(self)
        return Whole(a.c * other, a.n * other, a.m * other, a.turn if other else None)

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


class Cells:
    """A vector as long as a whole number, or a view of one.

    Parameters
    ----------
    tape : Tape
        The record as it grows.
    name : str
        ``"x"``, ``"u"`` or ``"out"``.
    start, length : Whole
        Where it begins in the whole, and how long it is; without an index.
    written : dict, optional
        What was written into `out`, by `Whole.key`.
    """

    __iter__ = None  # nothing walks through it but a loop over range

    def __init__(self, tape: Tape, name: str, start: Whole, length: Whole, written: Any = None):
        self.tape, self.name, self.start, self.length = tape, name, start, length
        self.written = written

    def _place(self, index: Any) -> Whole:
        at = Whole.of(index)
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

    def _view(self, index: slice) -> "Cells":
        first = Whole.of(0 if index.start is None else index.start)
        last = self.length if index.stop is None else Whole.of(index.stop)
        if index.step is not None or first.m or last.m:
            raise Refused("a slice like this one", "for every N use a slice from place to place")
        size, rest = last - first, self.length - last
        if any(one.n < 0 or one.c + one.n < 0 for one in (size, rest)) or min(first.c, first.n) < 0:
            raise Refused("a slice that lies outside for some N", "stay within the ports")
        return Cells(self.tape, self.name, self.start + first, size, self.written)

    def __setitem__(self, index: Any, value: Any) -> None:
        ref = operand(value)
        if self.written is None or ref is None:
            raise Refused("this assignment", "write numbers, into the last argument only")
        self.written[self._place(index).key] = (
            value if isinstance(value, Number) else Number(self.tape, ref)
        )


class Held:
    """A parameter array; an axis of N numbers takes an index k.

    It has no `shape` to ask.
    """

    __iter__ = None  # nothing walks through it but a loop over range

    def __init__(self, tape: Tape, field: str, sizes: tuple[int, ...], N: int, before: tuple = ()):
        self.tape, self.field, self.sizes, self.functions, self.before = (
            tape,
            field,
            sizes,
            N,
            before,
        )

    def __getitem__(self, index: Any) -> Any:
        places = list(self.before)
        for one in index if isinstance(index, tuple) else (index,):
            at = Whole.of(one)
            size = self.sizes[len(places)] if len(places) < len(self.sizes) else 0
            single = at.m == 0 and at.n == 0 and 0 <= at.c < size
            if not single and ((at.c, at.n, at.m) != (0, 0, 1) or size != self.functions):
                raise Refused(f"this place of `p.{self.field}`", "for every N use i or k itself")
            places.append(at)
        if len(places) < len(self.sizes):
            return Held(self.tape, self.field, self.sizes, self.functions, tuple(places))
        code = 0
        for at in places:
            code = code * BIG + at.code
        return self.tape.add("p", self.field, code)
