"""What stands for the types of numbers, and answers for a signal what Python asks of a number.

``float(x[0])``, ``isinstance(x, float)``, ``type(x)``, ``hasattr(x, "shape")``: a signal is a float
and a vector an array.  Where a number may be one of Python or of NumPy, whole or not, and the
answers differ, the function is not read.
"""

from collections.abc import Callable
from typing import Any

import numpy as np

from .arrays import Array, Unread, is_of_numpy, moves, single
from .elementwise import counts, elementwise
from .views import converted, is_whole


class StandInType(type):
    """A stand-in of a type: a type too, for ``dtype=float`` and ``isinstance(x, float)``."""

    real: type
    make: Callable

    def __call__(cls, *arguments: Any, **more: Any) -> Any:
        """Convert a signal, or make a number of the real type."""
        if arguments and isinstance(single(arguments[0]), Array):
            return cls.make(single(arguments[0]))
        return cls.real(*arguments, **more)

    def __instancecheck__(cls, value: Any) -> bool:
        return is_a(value, cls.real)

    def __subclasscheck__(cls, kind: type) -> bool:
        return issubclass(kind, cls.real)

    def __eq__(cls, other: Any) -> bool:
        return other is cls or other is cls.real

    def __hash__(cls) -> int:
        return hash(cls.real)


def stand_in_type(real: type, make: Callable) -> StandInType:
    """Return what stands for a type of numbers."""
    names = {"real": real, "make": staticmethod(make), "dtype": np.dtype(real)}
    names["__doc__"] = f"What stands for {real.__name__}."
    return StandInType(real.__name__, (), names)


def real_of(value: Any) -> Any:
    """Return what a stand-in of a type stands for."""
    return value.real if isinstance(value, StandInType) else value


def is_a(value: Any, kinds: Any) -> bool:
    """Return isinstance(value, kinds), for which a signal is a float and a vector an array."""
    kind = tuple(map(real_of, kinds)) if isinstance(kinds, tuple) else real_of(kinds)
    if not isinstance(value, Array) or kind is Array:
        return isinstance(value, kind)
    return _answer(value, lambda one: isinstance(one, kind))


def has(value: Any, name: str) -> bool:
    """Return hasattr(value, name)."""
    if not isinstance(value, Array):
        return hasattr(value, name)
    return name in getattr(value, "_ports", ()) or _answer(value, lambda one: hasattr(one, name))


def type_of(*arguments: Any, **more: Any) -> Any:
    """Return type(value), or a new type."""
    if len(arguments) > 1 or more:
        return type(*arguments, **more)
    (value,) = arguments
    kind = _answer(value, type) if isinstance(value, Array) else type(value)
    return TYPES.get(kind, kind)


def _answer(value: Array, ask: Callable[[Any], Any]) -> Any:
    """Return what is so of all that a value of a record may be to Python."""
    answers = {ask(one) for one in _may_be(value)}
    if len(answers) > 1:
        raise Unread("asks whether a signal is a number of Python or of NumPy, whole or not")
    return answers.pop()


def _may_be(value: Array) -> list[Any]:
    """Return examples: of a parameter as it was given, of others of NumPy or of Python."""
    ref, tape = value._ref, value._tape
    if value.shape or value._boxed:
        return [np.zeros(0)]
    if (given := ref if type(ref) is float else tape.parameter(ref)) is not None:
        return [given]
    if value._is_condition:
        return [np.bool_(False)]
    of_python = [] if is_of_numpy(value) else [0.0]
    of_whole = any(isinstance(one, int) for one in tape.parameters.values())
    counted = counts(value) or is_whole(tape, ref) or (of_whole and not moves(value))
    return [np.float64(0.0), *of_python, *([0, np.int64(0)] if counted else [])]


def as_float(value: Array) -> Any:
    """Return float(value)."""
    if value.shape:
        raise TypeError("only 0-dimensional arrays can be converted to Python scalars")
    value._tape.has_floats = True
    number = elementwise("where", value, 1.0, 0.0) if value._is_condition else value[()]
    return of_python(number)


def of_python(number: Any, whole: bool | None = False) -> Any:
    """Return a number as one of Python's: a float, or a whole one."""
    if not isinstance(number, Array) or number.shape:
        return number
    new = Array(number._tape, number._ref, ())
    new._of_python, new._whole = True, whole
    return new


TYPES = {  # of numbers: what stands for them
    real: stand_in_type(real, make)
    for real, make in (
        (float, as_float),
        (np.float64, lambda value: converted(value[()])),
        (int, lambda value: of_python(np.trunc(as_float(value)), whole=True)),
        (np.int64, lambda value: converted(value[()], np.int64)),
    )
}
