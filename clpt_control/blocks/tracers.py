"""Tracers: numbers without a value, of which only the place in the record is known.

They stand for the time, states, inputs and parameters.  A function that is called
with them computes nothing; what it does is written on the tape.  Whatever needs a
tracer's value (`if`, `==`, an index) is refused, with what to write instead.
"""

from collections.abc import Callable, Iterator, Sequence
from typing import Any

import numpy as np

from ..equations.scalars import Ref
from ..errors import BlockError

MOST_OPERATIONS = 300_000  # a longer record is given up: Python runs the diagram


class Refused(Exception):
    """What is not allowed, and what to write instead."""

    def __init__(self, what: str, instead: str):
        super().__init__(f"{what} is not allowed here; {instead}")


class TooLong(BlockError):
    """Equations whose record is too long to keep; Python runs them."""


class Tape:
    """A record as it grows."""

    def __init__(self) -> None:
        self.operations: list[tuple] = []
        self.marks: list[tuple[int, str]] = []

    def add(self, *operation: Any) -> "Number":
        """Append an operation and return its value."""
        self.operations.append(operation)
        if len(self.operations) > MOST_OPERATIONS:
            raise TooLong(f"takes more than {MOST_OPERATIONS} operations")
        return Number(self, len(self.operations) - 1)

    def turns(self, *bounds: Any) -> Iterator[int]:
        """Do what `range` does, and mark every turn."""
        numbers = range(*bounds)
        self.marks.append((len(self.operations), "enter"))
        try:
            for k in numbers:
                self.marks.append((len(self.operations), "turn"))
                if len(self.marks) > MOST_OPERATIONS:
                    raise TooLong(f"takes more than {MOST_OPERATIONS} turns")
                yield k
        finally:
            self.marks.append((len(self.operations), "leave"))


def operand(value: Any) -> Ref | None:
    """Return a value's place, or a constant; None for no number."""
    if isinstance(value, Number):
        return value.ref
    if isinstance(value, Condition):
        return value.number().ref
    if isinstance(value, int | float | np.integer | np.floating | np.bool_):
        return float(value)
    return None


def _refuse(what: str, instead: str) -> Callable[..., Any]:
    def refused(self: Any, *arguments: Any) -> Any:
        raise Refused(what, instead)

    return refused


_EQUAL = _refuse(
    "`==` between signals or parameters",
    "compare with <, <=, >, >=, or write where(math.fabs(a - b) < tolerance, ...)",
)
_CHOICE = _refuse("a choice that depends on a signal or parameter", "use where(condition, a, b)")
_INDEX = _refuse("a signal or parameter as an index or a count", "use lookup(table, index)")
_VALUE = _refuse(
    "making a Python number of a signal or parameter",
    "use arithmetic, math.*, and the words of blocks.words",
)


def _binary(name: str) -> tuple[Callable, Callable]:
    def forward(self: Any, other: Any) -> Any:
        ref = operand(other)
        return NotImplemented if ref is None else self.tape.add(name, self.ref, ref)

    def backward(self: Any, other: Any) -> Any:
        ref = operand(other)
        return NotImplemented if ref is None else self.tape.add(name, ref, self.ref)

    return forward, backward


def _comparison(name: str) -> Callable:
    def compare(self: Any, other: Any) -> Any:
        ref = operand(other)
        if ref is None:
            return NotImplemented
        return Condition(self.tape, self.tape.add(name, self.ref, ref).ref)

    return compare


class Number:
    """A number that a run will have."""

    __slots__ = ("ref", "tape")

    def __init__(self, tape: Tape, ref: Ref):
        self.tape = tape
        self.ref: Any = ref

    __add__, __radd__ = _binary("add")
    __sub__, __rsub__ = _binary("sub")
    __mul__, __rmul__ = _binary("mul")
    __truediv__, __rtruediv__ = _binary("div")
    __floordiv__, __rfloordiv__ = _binary("floordiv")
    __mod__, __rmod__ = _binary("mod")
    _pow, __rpow__ = _binary("pow")
    __lt__, __le__, __gt__, __ge__ = map(_comparison, ("lt", "le", "gt", "ge"))

    def __pow__(self, other: Any) -> Any:
        if isinstance(other, int | float) and other in (2, 3, 4):
            square = self * self
            return square if other == 2 else square * (self if other == 3 else square)
        return self._pow(other)

    def __neg__(self) -> "Number":
        return self.tape.add("neg", self.ref)

    def __pos__(self) -> "Number":
        return self

    def __abs__(self) -> "Number":
        return self.tape.add("fabs", self.ref)

    __eq__ = __ne__ = _EQUAL
    __hash__ = None  # type: ignore[assignment]
    __bool__ = _CHOICE
    __index__ = __int__ = _INDEX
    __float__ = __complex__ = __round__ = _VALUE


class Condition:
    """A comparison of such numbers; as a number it is 1 or 0."""

    __slots__ = ("ref", "tape")

    def __init__(self, tape: Tape, ref: Ref):
        self.tape, self.ref = tape, ref

    def number(self) -> Number:
        """Return 1 where it holds, else 0."""
        return self.tape.add("where", self.ref, 1.0, 0.0)

    def _joined(self, name: str, other: Any) -> Any:
        if not isinstance(other, Condition):
            return NotImplemented
        return Condition(self.tape, self.tape.add(name, self.ref, other.ref).ref)

    def __and__(self, other: Any) -> Any:
        return self._joined("and", other)

    def __or__(self, other: Any) -> Any:
        return self._joined("or", other)

    def __invert__(self) -> "Condition":
        return Condition(self.tape, self.tape.add("not", self.ref).ref)

    def __mul__(self, other: Any) -> Any:
        return NotImplemented if isinstance(other, Condition) else self.number() * other

    __rmul__ = __mul__
    __eq__ = __ne__ = _EQUAL
    __hash__ = None  # type: ignore[assignment]
    __bool__ = _CHOICE
    __index__ = __int__ = _INDEX


SHOWN = ("shape", "size", "ndim", "T", "flat", "tape")  # of an array, to equations and the trace


class TracerArray(np.ndarray):
    """An array of tracers; what is written becomes a number."""

    tape: Tape

    def __getattribute__(self, name: str) -> Any:
        if name in SHOWN or name.startswith("_"):
            return super().__getattribute__(name)
        raise Refused(f"`{name}` of an array", "use a `for i in range(n)` loop")

    def __array_wrap__(self, array: Any, context: Any = None, scalar: bool = False) -> Any:
        return array.view(TracerArray) if array.ndim else array[()]

    def __setitem__(self, index: Any, value: Any) -> None:
        if isinstance(value, np.ndarray | tuple | list):
            value = np.asarray(value, dtype=object)
            value = value if value.ndim else value[()]
        if not isinstance(value, np.ndarray):
            super().__setitem__(index, self._number(value))
            return
        if not isinstance(self[index], np.ndarray):
            raise Refused("writing an array into one number", "give one, as in u[0]")
        numbers = np.empty(value.shape, dtype=object)
        for place in np.ndindex(value.shape):
            numbers[place] = self._number(value[place])
        super().__setitem__(index, numbers)

    def _number(self, value: Any) -> Number:
        ref = operand(value)
        if ref is None:
            raise Refused(f"writing a {type(value).__name__}", "a block computes numbers only")
        return value if isinstance(value, Number) else Number(self.tape, ref)

    def __array_finalize__(self, other: Any) -> None:
        self.tape = getattr(other, "tape", None)  # type: ignore[assignment]


def tracer_array(tape: Tape, refs: Sequence[Ref], shape: tuple[int, ...]) -> TracerArray:
    """Return an array that holds these values."""
    array = np.empty(len(refs), dtype=object)
    for k, ref in enumerate(refs):
        array[k] = Number(tape, ref)
    made = array.reshape(shape).view(TracerArray)
    made.tape = tape
    return made


class Table:
    """A long parameter array: its slices and numbers can be read."""

    def __init__(self, tape: Tape, field: str, places: np.ndarray):
        self.tape, self.field, self.places = tape, field, places
        self.shape = places.shape

    def __len__(self) -> int:
        return len(self.places)

    def __getitem__(self, index: Any) -> Any:
        found = self.places[index]
        if isinstance(found, np.ndarray):
            return Table(self.tape, self.field, found)
        return self.tape.add("p", self.field, int(found))
