"""What stands for NumPy, `math` and built-in names while a function is read.

NumPy's own protocols reach arrays of the record wherever one is an argument.  They do not reach
``np.array([x[0], 1.0])``, ``np.zeros(2)`` that is filled afterwards, ``math.sin(x[0])``,
``float(x[0])`` and ``max(x[0], 0)``: these have stand-ins, which do what the real ones do where
nothing is read, or where no signal is among their arguments.
"""

import bisect
import builtins
import functools
import logging
import math
import sys
from collections import deque
from collections.abc import Callable, Iterable
from types import BuiltinFunctionType, FunctionType, GeneratorType, ModuleType
from typing import Any

import numpy as np

from .allow_list import OF_LOGGING, UNSEEDED
from .arrays import Array, Tape, Unread, active, single, whole
from .elementwise import (
    all_of,
    boxed,
    chosen,
    elementwise,
    is_of_python,
    is_whole,
    lifted,
    raise_in_a_try,
    where,
)
from .interpolators import function_of, searched
from .number_types import TYPES, has, is_a, of_python, real_of, type_of
from .numpy_functions import apply_function
from .ufuncs import LONG_ROW, apply_ufunc, least_of
from .views import converted, copied, fresh, share, tape_of

FUNCTIONS = (FunctionType, BuiltinFunctionType, type(np.sum))
ITERATORS = (GeneratorType, map, zip, filter, deque)


class StandIn:
    """Stands for a function: `own` writes on a tape what the real one does."""

    def __init__(self, real: Any, own: Callable):
        self.real, self.own = real, own
        functools.update_wrapper(self, real, updated=())

    def __call__(self, *arguments: Any, **more: Any) -> Any:
        """Run the real one, or write down what it does."""
        tape = active()
        if more:
            more = {name: real_of(one) for name, one in more.items()}
        if tape is None:
            return self.real(*arguments, **more)
        arguments = tuple(list(one) if isinstance(one, ITERATORS) else one for one in arguments)
        if tape_of((*arguments, *more.values())) is None:
            given = tuple(map(real_of, arguments))
            result = self.real(*given, **more)
            seen = any(share(one, result) for one in (*given, *more.values()))
            return result if seen else fresh(tape, result)
        return self.own(tape, *arguments, **more)

    def __getattr__(self, name: str) -> Any:
        attribute = getattr(self.real, name)
        if isinstance(self.real, np.ufunc) and callable(attribute):
            return StandIn(
                attribute, lambda tape, *a, **more: apply_ufunc(tape, self.real, name, a, more)
            )
        return attribute


# --- `math` and built-in functions --------------------------------------------------


def rounded_off(total: Any, value: Any, new: Any) -> Any:
    """Return what rounding took from total + value."""
    first = np.fabs(total) >= np.fabs(value)
    return where(first, (total - new) + value, (value - new) + total)


def remainder(a: Any, b: Any) -> Any:
    """Return math.remainder(a, b), from the rest of two periods: without rounding."""
    rest = np.fmod(a, 2.0 * b)
    return rest - b * np.rint(rest / b)


MATH: dict[str, Callable] = {
    **{name: f for name in vars(math) if isinstance(f := getattr(np, name, None), np.ufunc)},
    **{name: functools.partial(elementwise, name) for name in ("erf", "erfc")},
    "log": lambda a, base=None: np.log(a) if base is None else np.log(a) / np.log(base),
    "hypot": lambda *a: np.hypot(*a) if len(a) == 2 else functools.reduce(np.hypot, a, 0.0),
    "remainder": remainder,
    "dist": lambda a, b: functools.reduce(np.hypot, map(np.subtract, a, b), 0.0),
    "prod": lambda a, start=1: functools.reduce(lambda v, w: v * w, a, start),
}
RAISING = frozenset(  # where a number is out of range
    {"sqrt", "log", "log2", "log10", "log1p", "asin", "acos", "acosh", "atanh", "exp", "exp2"}
    | {"expm1", "sinh", "cosh", "pow", "fmod", "remainder"}
)


def of_math(name: str, tape: Tape, *arguments: Any, **more: Any) -> Any:
    """Write down a function of `math`."""
    numbers = tuple(map(single, arguments))
    if name in RAISING:
        raise_in_a_try(name, *numbers)
    new = MATH[name](*numbers, **more)
    return of_python(new, name in ("floor", "ceil", "trunc") or (name == "prod" and is_whole(new)))


OF_MATH = [StandIn(getattr(math, name), functools.partial(of_math, name)) for name in MATH]


def of_values(real: Callable, own: Callable[[list], Any]) -> Callable:
    """Return the stand-in of a function of values, given one by one or in one."""

    @functools.wraps(real)
    def function(*arguments: Any, **more: Any) -> Any:
        values = list(arguments[0]) if len(arguments) == 1 else list(arguments)
        return real(values, **more) if more or tape_of(values) is None else own(values)

    return function


def best(better: Callable, values: list) -> Any:
    """Return the best value: what is better takes the place of what was best."""
    kinds = {(is_of_python(one), is_whole(one)) for one in map(single, values)}
    if len(values) > LONG_ROW and len(kinds) == 1:
        row = lifted(tape_of(values), [*map(single, values)])
        new = least_of(row) if better is np.less else -least_of(-row)
        ((new._of_python, new._whole),) = kinds
        return new
    return functools.reduce(lambda a, b: chosen(better(b, a), b, a), map(single, values))


def compensated(values: Iterable[Any], start: Any = 0) -> Any:
    """Return Python's sum: of its own floats, since 3.12, with what rounding took from it.

    Of whole numbers among them since 3.14; a number of NumPy ends it, and one that may be NumPy's.
    """
    values = list(values)
    if tape_of((start, *values)) is None:
        return sum(values, start)
    total, lost, count = start, 0.0, 0
    for value in values:
        if not all_of([is_of_python(total), is_of_python(value)]):
            break
        new = total + value
        exact = is_whole(total) or (sys.version_info < (3, 14) and is_whole(value))
        lost = lost if exact else lost + rounded_off(total, value, new)
        total, count = new, count + 1
    if isinstance(lost, Array) or lost:
        total = where(np.isfinite(lost), total + lost, total)
    return sum(values[count:], total)


def printed(*values: Any, **more: Any) -> None:
    """Print, but nothing of a way that is only read: its numbers have no values."""
    if active() is None:
        print(*values, **more)


SHADOWS: dict[str, Any] = {  # built-in names that have stand-ins
    "float": TYPES[float],
    "int": TYPES[int],
    "max": of_values(max, functools.partial(best, np.greater)),
    "min": of_values(min, functools.partial(best, np.less)),
    "any": of_values(any, lambda values: functools.reduce(np.logical_or, values, False)),
    "all": of_values(all, lambda values: functools.reduce(np.logical_and, values, True)),
    "isinstance": is_a,
    "hasattr": has,
    "type": type_of,
    "print": printed,
    **({"sum": compensated} if sys.version_info >= (3, 12) else {}),
}


# --- NumPy ------------------------------------------------------------


def of_numpy(real: Any) -> StandIn:
    """Return the stand-in of a function of NumPy, for lists that hold signals."""
    if real in MAKERS:
        return StandIn(real, MAKERS[real])
    if isinstance(real, np.ufunc):
        return StandIn(real, lambda tape, *a, **more: apply_ufunc(tape, real, "__call__", a, more))
    return StandIn(real, lambda tape, *a, **more: apply_function(tape, real, a, more))


def array(tape: Any, value: Any, dtype: Any = None, *, ndmin: int = 0, **more: Any) -> Any:
    """Return np.array of what holds signals."""
    new = lifted(tape, value)
    if dtype is not None:
        new = converted(new, dtype)
    elif more.get("copy", True):
        new = copied(new)
    return boxed(tape, new[(None,) * (ndmin - new.ndim)] if ndmin > new.ndim else new)


def same_array(tape: Any, value: Any, dtype: Any = None, **more: Any) -> Any:
    """Return np.asarray of what holds signals."""
    if isinstance(value, Array) and (dtype is None or np.dtype(dtype) == float):
        return boxed(tape, value)
    return array(tape, value, dtype)


def full(tape: Tape, shape: Any, value: Any, dtype: Any) -> Any:
    """Return np.full of a signal."""
    new = lifted(tape, np.zeros(whole(shape))) + lifted(tape, value)
    new._whole = is_whole(value)
    return boxed(tape, new if dtype is None else converted(new, dtype))


MAKERS: dict[Any, Callable] = {
    np.array: array,
    **dict.fromkeys((np.asarray, np.asanyarray), same_array),
    np.full: lambda tape, shape, value, dtype=None, **more: full(tape, shape, value, dtype),
    **{
        make: lambda tape, *counts, make=make, **more: fresh(tape, make(*whole(counts), **more))
        for make in (np.zeros, np.ones, np.empty, np.eye, np.identity)
    },
    np.isscalar: lambda tape, a: isinstance(a, Array) and not (a.shape or a._boxed),
}


class Joiner:
    """np.r_ and np.c_: what stands in brackets, one behind the other."""

    def __init__(self, real: Any, join: Callable):
        self.real, self.join = real, join

    def __getitem__(self, parts: Any) -> Any:
        given = parts if isinstance(parts, tuple) else (parts,)
        if tape_of(given) is None:
            tape, result = active(), self.real[parts]
            return result if tape is None else fresh(tape, result)
        return self.join(
            [np.atleast_1d(self.real[p] if isinstance(p, slice) else p) for p in given]
        )


# --- modules ------------------------------------------------------------------------------------


class Module(ModuleType):
    """What stands for a module, with tracer values of its names; nobody can change it."""

    def __init__(self, real: ModuleType, tracer_value: Callable):
        vars(self).update(__name__=real.__name__, _real=real, _tracer_value=tracer_value)

    def __getattr__(self, name: str) -> Any:
        return self._tracer_value(getattr(self._real, name))

    def __setattr__(self, name: str, *value: Any) -> None:
        raise Unread(f"changes {self.__name__}.{name}; make it a state")

    __delattr__ = __setattr__


def errstate(**arguments: Any) -> Any:
    """Return np.errstate; refuse to raise, which nothing does while it is read."""
    if active() is not None and {"raise", "call", "log"} & {*arguments.values()}:
        raise Unread("np.errstate that raises; ask by `if` before")
    return np.errstate(**arguments)


def _refused(real: Callable, sentence: str) -> Callable:
    """Return what stands for a function whose answer no record holds."""

    def function(*arguments: Any, **more: Any) -> Any:
        if active() is not None and not arguments and not more:
            raise Unread(sentence)
        return real(*arguments, **more)

    return function


class SilentLogger:
    """A logger that does nothing."""

    def __getattr__(self, name: str) -> Callable:
        return lambda *arguments, **more: None


BISECT: dict[Any, Callable] = {
    bisect.bisect_left: lambda tape, row, value: searched(row, value, "left"),
    bisect.bisect_right: lambda tape, row, value: searched(row, value, "right"),
}
_KNOWN: dict[int, Any] = {
    **{id(real): StandIn(real, own) for real, own in BISECT.items()},
    id(np.random.default_rng): _refused(np.random.default_rng, UNSEEDED),
    id(np.errstate): errstate,
    id(logging.getLogger): lambda *name: SilentLogger(),
    **{id(getattr(logging, name)): getattr(SilentLogger(), name) for name in OF_LOGGING},
    id(np.r_): Joiner(np.r_, np.concatenate),
    id(np.c_): Joiner(np.c_, np.column_stack),
    **{id(real): made for real, made in TYPES.items()},
    **{id(made.real): made for made in OF_MATH},
    **{id(getattr(builtins, name)): made for name, made in SHADOWS.items()},
}


def stand_in(value: Any) -> Any:
    """Return what stands for a module, function, type or interpolator; else the value itself."""
    if (known := _KNOWN.get(id(value))) is not None:
        return known
    if isinstance(value, logging.Logger | logging.LoggerAdapter):
        return SilentLogger()
    if isinstance(value, ModuleType):
        return _KNOWN.setdefault(id(value), Module(value, stand_in))
    of_them = isinstance(value, FUNCTIONS) and any(
        vars(module).get(value.__name__) is value for module in (np, np.linalg)
    )
    if isinstance(value, np.ufunc) or of_them:
        return _KNOWN.setdefault(id(value), of_numpy(value))
    table = function_of(value)
    return value if table is None else StandIn(value, table)


BUILTINS: dict[str, Any] = {**vars(builtins), **SHADOWS}
