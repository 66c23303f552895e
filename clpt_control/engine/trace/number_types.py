"""What stands for the types of numbers, and answers for a signal what Python asks of a number.

``float(x[0])``, ``isinstance(x, float)``, ``type(x)``, ``hasattr(x, "shape")``: a signal is a float
and a vector an array.  Whether a number is Python's or NumPy's, whole or not, may hang on what was
chosen; where the answers differ, the function is not read.
"""

from collections.abc import Callable
from itertools import product
from typing import Any

import numpy as np

from .arrays import Array, single
from .elementwise import as_number, is_of_python, is_whole, told
from .views import converted


class StandInType(type):
    """A stand-in of a type: a type too, for ``dtype=float`` and ``isinstance(x, float)``."""

    _real: type
    _make: Callable

    def __getattr__(cls, name: str) -> Any:
        """Return an attribute of the real type; a method of a signal is that of the array."""
        attribute = getattr(cls._real, name)

        def method(*arguments: Any, **more: Any) -> Any:
            if arguments and isinstance(arguments[0], Array):
                return getattr(arguments[0], name)(*arguments[1:], **more)
            return attribute(*arguments, **more)

        return method if callable(attribute) else attribute

    def __call__(cls, *arguments: Any, **more: Any) -> Any:
        """Convert a signal, or make a number of the real type."""
        if arguments and isinstance(single(arguments[0]), Array):
            return cls._make(single(arguments[0]))
        return cls._real(*arguments, **more)

    def __instancecheck__(cls, value: Any) -> bool:
        return is_a(value, cls._real)

    def __subclasscheck__(cls, kind: type) -> bool:
        return issubclass(kind, cls._real)

    def __eq__(cls, other: Any) -> bool:
        return other is cls or other is cls._real

    def __hash__(cls) -> int:
        return hash(cls._real)


def stand_in_type(real: type, make: Callable) -> StandInType:
    """Return what stands for a type of numbers."""
    names = {"_real": real, "_make": staticmethod(make), "dtype": np.dtype(real)}
    names["__doc__"] = f"What stands for {real.__name__}."
    return StandInType(real.__name__, (), names)


def real_of(value: Any) -> Any:
    """Return what a stand-in of a type stands for."""
    return value._real if isinstance(value, StandInType) else value


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


# what numbers are to Python, by whether they are whole, and whether they are its own
EXAMPLES: dict[Any, Any] = {(0, 0): np.float64(0.0), (0, 1): 0.0, (1, 0): np.int64(0), (1, 1): 0}


def _answer(value: Array, ask: Callable[[Any], Any]) -> Any:
    """Return what is so of an example of what a value of a record is to Python."""
    ref = value._ref
    if value.shape or value._boxed:
        return ask(np.zeros(0))
    if (given := ref if type(ref) is float else value._tape.parameter(ref)) is not None:
        return ask(given)
    if value._is_condition:
        return ask(np.bool_(False))
    kinds = is_whole(value), is_of_python(value)
    might = product(*((False, True) if kind is None else (kind,) for kind in kinds))
    answers = {ask(EXAMPLES[kind]) for kind in might}
    told(True if len(answers) == 1 else None)
    return answers.pop()


def as_float(value: Array) -> Any:
    """Return float(value)."""
    if value.shape:
        raise TypeError("only 0-dimensional arrays can be converted to Python scalars")
    return of_python(as_number(value[()]))


def of_python(number: Any, whole: Any = False) -> Any:
    """Return a number as one of Python's: a float, or a whole one, which is never -0."""
    if not isinstance(number, Array) or number.shape:
        return number
    new = Array(number._tape, (number + 0.0 if whole else number)._ref, ())
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
