"""What stands for built-in names: float, int, max, min, any, all, sorted, isinstance, imports.

A stand-in of a type is a type, for ``dtype=float`` and ``isinstance(x, float)``.
"""

import functools
import numbers
from collections.abc import Callable
from typing import Any

import numpy as np

from .arrays import Array, elementwise, where
from .math_functions import single
from .numpy_functions import in_order
from .opened import tape_of

MOST_SORTED = 16


class StandInType(type):
    """A stand-in of a type: a type too, for ``dtype=float`` and ``isinstance(x, float)``."""

    real: type
    make: Callable

    def __call__(cls, *given: Any, **more: Any) -> Any:
        """Convert a signal, or make a number of the real type."""
        if given and isinstance(single(given[0]), Array):
            return cls.make(single(given[0]))
        return cls.real(*given, **more)

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
    own = {"real": real, "make": staticmethod(make), "dtype": np.dtype(real)}
    own["__doc__"] = f"What stands for {real.__name__}."
    return StandInType(real.__name__, (), own)


def as_float(value: Array) -> Any:
    """Return float(value)."""
    if value.shape:
        raise TypeError("only 0-dimensional arrays can be converted to Python scalars")
    return elementwise("where", value, 1.0, 0.0) if value.is_condition else value


FLOAT = stand_in_type(float, as_float)
FLOAT64 = stand_in_type(np.float64, lambda value: value)
INT = stand_in_type(int, lambda value: np.trunc(as_float(value)))
INT64 = stand_in_type(np.int64, lambda value: np.trunc(as_float(value)))
NUMBERS = (float, np.float64, np.floating, np.inexact, np.number, np.generic)


def is_a(value: Any, kinds: Any) -> bool:
    """Return isinstance(value, kinds), for which a signal is a float and a vector an array."""
    if isinstance(kinds, tuple):
        return any(is_a(value, kind) for kind in kinds)
    kind = real_of(kinds)
    if not isinstance(value, Array):
        return isinstance(value, kind)
    if value.shape:
        return kind in (np.ndarray, object, Array)
    return kind in (*NUMBERS, object, Array, numbers.Number, numbers.Real, numbers.Complex)


def extreme(real: Callable, better: str) -> Callable:
    """Return the stand-in of `max` or `min`: what is better takes the place of what was best."""

    @functools.wraps(real)
    def function(*given: Any, **more: Any) -> Any:
        values = list(given[0]) if len(given) == 1 else list(given)
        if more or not values or tape_of(values) is None:
            return real(values, **more) if len(given) == 1 or not more else real(*given, **more)
        best = single(values[0])
        for value in map(single, values[1:]):
            signal = isinstance(value, Array) or isinstance(best, Array)
            holds = (
                elementwise(better, value, best)
                if signal
                else (value < best if better == "lt" else value > best)
            )
            best = chosen_number(holds, value, best)
        return best

    return function


def chosen_number(condition: Any, a: Any, b: Any) -> Any:
    """Return a where a condition holds, else b."""
    return where(condition, a, b) if isinstance(condition, Array) else (a if condition else b)


def joined(real: Callable, name: str) -> Callable:
    """Return the stand-in of `any` or `all`, without a question for each."""

    @functools.wraps(real)
    def function(values: Any) -> Any:
        given = list(values)
        if tape_of(given) is None:
            return real(given)
        return functools.reduce(
            lambda v, w: elementwise(name, v, w) if tape_of((v, w)) else real((v, w)), given
        )

    return function


def ordered(values: Any, **more: Any) -> list[Any]:
    """Return sorted(values), without a question where there is no key."""
    given = list(values)
    if more or tape_of(given) is None or len(given) > MOST_SORTED:
        return sorted(given, **more)
    return in_order(given)


SHADOWS: dict[str, Any] = {  # built-in names that have stand-ins
    "float": FLOAT,
    "int": INT,
    "max": extreme(max, "gt"),
    "min": extreme(min, "lt"),
    "any": joined(any, "or"),
    "all": joined(all, "and"),
    "sorted": ordered,
    "isinstance": is_a,
}
_REAL = {FLOAT: float, FLOAT64: np.float64, INT: int, INT64: np.int64}


def real_of(value: Any) -> Any:
    """Return what a stand-in of a type stands for."""
    return _REAL.get(value, value) if isinstance(value, StandInType) else value
