"""What stands for NumPy, `math` and built-in names while a function is read.

NumPy's own protocols reach arrays of the record wherever one is an argument.  They do not reach
``np.array([x[0], 1.0])``, ``np.zeros(2)`` that is filled afterwards, ``math.sin(x[0])``,
``float(x[0])`` and ``max(x[0], 0)``: these have stand-ins, which do what the real ones do where
nothing is read, or where no signal is among their arguments.
"""

import builtins
import functools
import math
import numbers
import sys
from collections.abc import Callable
from types import ModuleType
from typing import Any

import numpy as np

from .arrays import Array, active, elementwise, lifted, where
from .numpy_functions import applied, converted, in_order, tape_of
from .ufuncs import called, fresh, objects, unread

MOST_SORTED = 16


class NumPyFunction:
    """One of NumPy's functions, for lists that hold signals, and arrays that will be filled."""

    def __init__(self, real: Any):
        self.real = real
        functools.update_wrapper(self, real, updated=())

    def __call__(self, *given: Any, **more: Any) -> Any:
        """Run the real one, or write down what it does."""
        tape = active()
        if "dtype" in more:
            more["dtype"] = real_of(more["dtype"])
        if tape is None:
            return self.real(*given, **more)
        if tape_of((*given, *more.values())) is None:
            return fresh(tape, self.real(*map(real_of, given), **more))
        if self.real in MAKERS:
            return MAKERS[self.real](tape, *given, **more)
        if isinstance(self.real, np.ufunc):
            return called(tape, self.real, "__call__", given, more)
        return applied(tape, self.real, given, more)

    def __getattr__(self, name: str) -> Any:
        found = getattr(self.real, name)
        if not (isinstance(self.real, np.ufunc) and callable(found)):
            return found

        def method(*given: Any, **more: Any) -> Any:
            tape = active()
            if tape is None or tape_of(given) is None:
                return found(*given, **more)
            return called(tape, self.real, name, given, more)

        return method


def array(tape: Any, value: Any, dtype: Any = None, *, ndmin: int = 0, **more: Any) -> Any:
    """Return np.array of what holds signals."""
    made = lifted(tape, value)
    made = converted(made, dtype or float) if dtype is not None or more.get("copy", True) else made
    return made[(None,) * (ndmin - made.ndim)] if ndmin > made.ndim else made


def same_array(tape: Any, value: Any, dtype: Any = None, **more: Any) -> Any:
    """Return np.asarray of what holds signals."""
    if isinstance(value, Array) and (dtype is None or np.dtype(dtype).kind == "f"):
        return value
    return array(tape, value, dtype)


MAKERS: dict[Any, Callable] = {
    np.array: array,
    np.asarray: same_array,
    np.asanyarray: same_array,
    np.ascontiguousarray: same_array,
    np.full: lambda tape, *a, **more: lifted(tape, np.zeros(a[0])) + lifted(tape, a[1]),
    np.isscalar: lambda tape, a: isinstance(a, Array) and not a.shape,
    np.vectorize: lambda tape, *a, **more: unread("np.vectorize"),
}


class Vectorized:
    """np.vectorize: a function of each element."""

    def __init__(self, function: Callable, *more: Any, **named: Any):
        self.function, self.real = function, np.vectorize(function, *more, **named)

    def __call__(self, *given: Any, **more: Any) -> Any:
        """Run the function for each element."""
        tape = tape_of(given)
        if tape is None:
            return self.real(*given, **more)
        own = np.broadcast_arrays(*(objects(lifted(tape, one)) for one in given))
        found = np.empty(own[0].size, dtype=object)
        for k, values in enumerate(zip(*(one.ravel() for one in own), strict=True)):
            found[k] = self.function(*values, **more)
        return lifted(tape, found).reshape(own[0].shape)


class Joiner:
    """np.r_ and np.c_: what stands in brackets, one behind the other."""

    def __init__(self, real: Any, join: Callable):
        self.real, self.join = real, join

    def __getitem__(self, parts: Any) -> Any:
        given = parts if isinstance(parts, tuple) else (parts,)
        if tape_of(given) is None:
            tape, found = active(), self.real[parts]
            return found if tape is None else fresh(tape, found)
        return self.join(
            [np.atleast_1d(self.real[p] if isinstance(p, slice) else p) for p in given]
        )


# --- math ------------------------------------------------------------------------------------

NAMED_AS = {
    **{"asin": "arcsin", "acos": "arccos", "atan": "arctan", "atan2": "arctan2", "pow": "power"},
    **{"asinh": "arcsinh", "acosh": "arccosh", "atanh": "arctanh"},
}
OF_NUMPY = (
    *("sin", "cos", "tan", "sinh", "cosh", "tanh", "exp", "expm1", "exp2", "cbrt", "log1p", "log2"),
    *("log10", "sqrt", "fabs", "floor", "ceil", "trunc", "copysign", "fmod", "radians", "degrees"),
    *("isnan", "isinf", "isfinite", "modf", *NAMED_AS),
)


def logarithm(a: Any, base: Any = None) -> Any:
    """Return math.log(a, base)."""
    return np.log(a) if base is None else np.log(a) / np.log(base)


def whole_rest(a: Any, b: Any) -> Any:
    """Return math.remainder(a, b)."""
    return a - b * np.rint(a / b)


def about(a: Any, b: Any, *, rel_tol: float = 1e-9, abs_tol: float = 0.0) -> Any:
    """Return math.isclose(a, b)."""
    size = np.maximum(np.fabs(a), np.fabs(b))
    return (np.fabs(a - b) <= rel_tol * size) | (np.fabs(a - b) <= abs_tol)


def total_of(values: Any, start: Any = 0) -> Any:
    """Return the sum of numbers, one after the other."""
    return functools.reduce(lambda v, w: v + w, values, start)


DOMAINS: dict[str, Callable] = {  # outside, `math` raises
    "sqrt": lambda a: a < 0,
    "log": lambda a, *base: a <= 0,
    "log2": lambda a: a <= 0,
    "log10": lambda a: a <= 0,
    "asin": lambda a: np.fabs(a) > 1,
    "acos": lambda a: np.fabs(a) > 1,
}


def in_a_try() -> bool:
    """Return whether a function that is read may catch what is raised now."""
    frame = sys._getframe(2)
    while frame is not None and frame.f_globals.get("__name__") != f"{__package__}.reading":
        if frame.f_globals.get("__builtins__") is BUILTINS and frame.f_code.co_exceptiontable:
            return True
        frame = frame.f_back  # type: ignore[assignment]
    return False


MATH: dict[str, Callable] = {
    **{name: getattr(np, NAMED_AS.get(name, name)) for name in OF_NUMPY},
    "erf": lambda a: elementwise("erf", a),
    "erfc": lambda a: elementwise("erfc", a),
    "log": logarithm,
    "remainder": whole_rest,
    "hypot": lambda *a: np.hypot(*a) if len(a) == 2 else np.sqrt(total_of(v * v for v in a)),
    "dist": lambda a, b: np.sqrt(total_of((v - w) ** 2 for v, w in zip(a, b, strict=True))),
    "isclose": about,
    "fsum": total_of,
    "prod": lambda a, start=1: functools.reduce(lambda v, w: v * w, a, start),
    "ldexp": lambda a, k: a * 2.0**k,
}


def single(value: Any) -> Any:
    """Return the number in an array of one, which `math` and float take."""
    if isinstance(value, Array) and value.shape and value.size == 1:
        return value[(0,) * value.ndim]
    return value


def of_math(name: str, real: Any) -> Callable:
    """Return the stand-in of a function of `math`."""

    @functools.wraps(real)
    def function(*given: Any, **more: Any) -> Any:
        if active() is None or tape_of(given) is None:
            return real(*given, **more)
        own = tuple(map(single, given))
        if name in DOMAINS and in_a_try() and DOMAINS[name](*own):
            raise ValueError("math domain error")
        return MATH[name](*own, **more)

    return function


# --- built-in names ---------------------------------------------------------------------------


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


def imported(name: str, *given: Any, **more: Any) -> Any:
    """Return a module that a function imports by itself, or what stands for it."""
    return stand_in(builtins.__import__(name, *given, **more))


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
BUILTINS: dict[str, Any] = {**vars(builtins), **SHADOWS, "__import__": imported}

# --- modules ------------------------------------------------------------------------------------


class Module(ModuleType):
    """What stands for a module: its names, of which some are stand-ins."""

    def __init__(self, real: ModuleType):
        super().__init__(real.__name__)
        self.__dict__["_stands_for"] = real

    def __getattr__(self, name: str) -> Any:
        found = stand_in(getattr(self._stands_for, name))
        self.__dict__[name] = found
        return found


_REAL = {FLOAT: float, FLOAT64: np.float64, INT: int, INT64: np.int64}
_KNOWN: dict[int, Any] = {
    id(math): Module(math),
    id(np): Module(np),
    id(float): FLOAT,
    id(int): INT,
    id(np.float64): FLOAT64,
    id(np.int64): INT64,
    id(np.vectorize): Vectorized,
    id(np.r_): Joiner(np.r_, np.concatenate),
    id(np.c_): Joiner(np.c_, np.column_stack),
    **{id(getattr(math, name)): of_math(name, getattr(math, name)) for name in MATH},
    **{id(getattr(builtins, name)): made for name, made in SHADOWS.items()},
}


def real_of(value: Any) -> Any:
    """Return what a stand-in of a type stands for."""
    return _REAL.get(value, value) if isinstance(value, StandInType) else value


def stand_in(value: Any) -> Any:
    """Return what stands for a module, function or type; a value without one as it is."""
    found = _KNOWN.get(id(value))
    if found is not None:
        return found
    if isinstance(value, ModuleType):
        if value.__name__.partition(".")[0] == "numpy" and "random" not in value.__name__:
            return _KNOWN.setdefault(id(value), Module(value))
        return value
    if isinstance(value, np.ufunc) or (
        callable(value)
        and not isinstance(value, type)
        and (getattr(value, "__module__", None) or "").partition(".")[0] == "numpy"
        and hasattr(value, "__name__")
        and getattr(np, value.__name__, getattr(np.linalg, value.__name__, None)) is value
    ):
        return _KNOWN.setdefault(id(value), NumPyFunction(value))
    return value
