"""What stands for a function or a type while a function is read.

It does what the real one does where nothing is read, or where no signal is among its arguments.
"""

import functools
import numbers
from collections.abc import Callable
from types import GeneratorType
from typing import Any

import numpy as np

from .arrays import Array, active, elementwise, single
from .opened import fresh, tape_of
from .ufuncs import called

ITERATORS = (GeneratorType, map, zip, filter)
NUMBERS = (float, np.float64, np.floating, np.inexact, np.number, np.generic)


class StandIn:
    """What stands for a function; its own way writes on a tape what the real one does."""

    def __init__(self, real: Any, own: Callable):
        self.real, self.own = real, own
        functools.update_wrapper(self, real, updated=())

    def __call__(self, *given: Any, **more: Any) -> Any:
        """Run the real one, or write down what it does."""
        tape = active()
        if more:
            more = {name: real_of(one) for name, one in more.items()}
        if tape is None:
            return self.real(*given, **more)
        given = tuple(list(one) if isinstance(one, ITERATORS) else one for one in given)
        if tape_of((*given, *more.values())) is None:
            return fresh(tape, self.real(*map(real_of, given), **more))
        return self.own(tape, *given, **more)

    def __getattr__(self, name: str) -> Any:
        found = getattr(self.real, name)
        if isinstance(self.real, np.ufunc) and callable(found):
            return StandIn(found, lambda tape, *a, **more: called(tape, self.real, name, a, more))
        return found


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


def real_of(value: Any) -> Any:
    """Return what a stand-in of a type stands for."""
    return value.real if isinstance(value, StandInType) else value


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


def as_float(value: Array) -> Any:
    """Return float(value)."""
    if value.shape:
        raise TypeError("only 0-dimensional arrays can be converted to Python scalars")
    return elementwise("where", value, 1.0, 0.0) if value._is_condition else value


TYPES = {  # of numbers: what stands for them
    real: stand_in_type(real, make)
    for real, make in (
        (float, as_float),
        (np.float64, lambda value: value),
        (int, lambda value: np.trunc(as_float(value))),
        (np.int64, lambda value: np.trunc(as_float(value))),
    )
}
