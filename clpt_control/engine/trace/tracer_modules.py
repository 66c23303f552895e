"""Tracer functions, types and modules: NumPy, `math` and built-in names while a function is traced.

NumPy's own protocols reach tracer arrays wherever one is an argument.  They do not reach
``np.array([x[0], 1.0])``, ``np.zeros(2)`` that is filled afterwards, ``math.sin(x[0])``,
``float(x[0])`` and ``max(x[0], 0)``.  These names are rebound to the tracer functions here, which
call the real ones if no signal is among their arguments.

To ``isinstance``, ``hasattr`` and ``type`` a signal is a float and a vector is an array.
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

from ..record.unread import Unread, active
from .arrays import REMEMBERS, Array, Tape, single, whole
from .elementwise import (
    all_of,
    as_number,
    boxed,
    chosen,
    definite,
    is_of_python,
    is_whole,
    lifted,
    of_python,
    raise_in_a_try,
    where,
)
from .interpolators import function_of, searched
from .numpy_functions import apply_function
from .references import OF_LOGGING, UNSEEDED, words
from .ufuncs import COMPOSED, LONG_ROW, apply_ufunc
from .views import converted, copied, fresh, share, tape_of

FUNCTIONS = (FunctionType, BuiltinFunctionType, type(np.sum))
ITERATORS = (GeneratorType, map, zip, filter, deque)


class TracerFunction:
    """A function that is recorded if a signal is among its arguments.

    `record` takes the tape and the arguments; otherwise the `real` function runs.
    """

    def __init__(self, real: Any, record: Callable):
        self.real = real
        self.record = record
        functools.update_wrapper(self, real, updated=())

    def __call__(self, *arguments, **options):
        """Run the real function, or record the call."""
        tape = active()
        if options:
            options = {name: real_type(value) for name, value in options.items()}
        if tape is None:
            return self.real(*arguments, **options)
        arguments = tuple(list(a) if isinstance(a, ITERATORS) else a for a in arguments)
        if tape_of((*arguments, *options.values())) is not None:
            return self.record(tape, *arguments, **options)
        inputs = tuple(map(real_type, arguments))
        result = self.real(*inputs, **options)
        is_view = any(share(value, result) for value in (*inputs, *options.values()))
        return result if is_view else fresh(tape, result)

    def __getattr__(self, name: str) -> Any:
        attribute = getattr(self.real, name)
        if not isinstance(self.real, np.ufunc) or not callable(attribute):
            return attribute
        return TracerFunction(
            attribute, functools.partial(apply_ufunc, self.real, name)
        )


# --- types of numbers ---------------------------------------------------------------------------


class TracerType(type):
    """A type of numbers that converts signals; a type, for ``dtype=float`` and isinstance."""

    _real: type
    _convert: Callable

    def __getattr__(cls, name: str) -> Any:
        """Return an attribute of the real type; a method of a signal is a method of its array."""
        attribute = getattr(cls._real, name)
        if not callable(attribute):
            return attribute
        return TracerFunction(
            attribute, lambda tape, value, *a: getattr(value, name)(*a)
        )

    def __call__(cls, *arguments, **options):
        """Convert a signal, or make a number of the real type."""
        value = single(arguments[0]) if arguments else None
        return (
            cls._convert(value)
            if isinstance(value, Array)
            else cls._real(*arguments, **options)
        )

    def __instancecheck__(cls, value: Any) -> bool:
        return is_instance(value, cls._real)

    def __subclasscheck__(cls, kind: type) -> bool:
        return issubclass(kind, cls._real)

    def __eq__(cls, value: Any) -> bool:
        return real_type(value) is cls._real

    def __hash__(cls) -> int:
        return hash(cls._real)


def tracer_type(real: type, convert: Callable) -> TracerType:
    """Return the tracer type of a type of numbers."""
    names = {"_real": real, "_convert": staticmethod(convert), "dtype": np.dtype(real)}
    return TracerType(
        real.__name__, (), {"__doc__": f"Tracer type of {real.__name__}.", **names}
    )


def real_type(value):
    """Return the real type of a tracer type; any other value as it is."""
    return value._real if isinstance(value, TracerType) else value


def is_instance(value: Any, kinds: Any) -> bool:
    """Return isinstance(value, kinds)."""
    kind = (
        tuple(map(real_type, kinds)) if isinstance(kinds, tuple) else real_type(kinds)
    )
    if not isinstance(value, Array) or kind is Array:
        return isinstance(value, kind)
    return _of_example(value, lambda example: isinstance(example, kind))


def has_attribute(value: Any, name: str) -> bool:
    """Return hasattr(value, name)."""
    if not isinstance(value, Array):
        return hasattr(value, name)
    is_port = name in getattr(value, "_ports", ())
    return is_port or _of_example(value, lambda example: hasattr(example, name))


def type_of(*arguments, **options):
    """Return type(value), or a new type."""
    if len(arguments) > 1 or options:
        return type(*arguments, **options)
    (value,) = arguments
    kind = _of_example(value, type) if isinstance(value, Array) else type(value)
    return TYPES.get(kind, kind)


# numbers, by whether they are whole and whether they are Python's own
EXAMPLES = (
    (False, False, np.float64(0)),
    (False, True, 0.0),
    (True, False, np.int64(0)),
    (True, True, 0),
)


def _of_example(value: Array, answer: Callable[[Any], Any]) -> Any:
    """Return the answer for an example of a value; refuse if it depends on a branch."""
    if value.shape or value._boxed:
        return answer(np.zeros(0))
    ref = value._ref
    number = ref if type(ref) is float else value._tape.parameter(ref)
    if number is not None:
        return answer(number)
    is_python = is_of_python(value)
    if value._is_condition:
        return answer(False if definite(is_python) else np.bool_(False))
    is_int = is_whole(value)
    answers = {
        answer(example)
        for example_is_int, example_is_python, example in EXAMPLES
        if is_int in (example_is_int, None) and is_python in (example_is_python, None)
    }
    definite(True if len(answers) == 1 else None)
    return answers.pop()


def as_float(value: Array) -> Any:
    """Return float(value)."""
    if value.shape:
        raise TypeError("only 0-dimensional arrays can be converted to Python scalars")
    return of_python(as_number(value[()]))


CONVERSIONS: dict[type, Callable] = {
    float: as_float,
    np.float64: lambda value: converted(value[()]),
    int: lambda value: of_python(np.trunc(as_float(value)), is_int=True),
    bool: bool,
    np.int64: lambda value: converted(value[()], np.int64),
}
TYPES = {real: tracer_type(real, convert) for real, convert in CONVERSIONS.items()}


# --- `math` and built-in functions --------------------------------------------------------------


def rounded_off(total, value, new):
    """Return the rounding error of new = total + value."""
    is_larger = np.fabs(total) >= np.fabs(value)
    return where(is_larger, (total - new) + value, (value - new) + total)


def hypot(*numbers):
    """Return math.hypot of any count of numbers."""
    return functools.reduce(np.hypot, numbers) if numbers[1:] else np.fabs(*numbers)


def remainder(a, b):
    """Return math.remainder(a, b), from the remainder of two periods: without rounding."""
    double_remainder = np.fmod(a, 2.0 * b)
    return double_remainder - b * np.rint(double_remainder / b)


def isclose(a, b, *, rel_tol=1e-9, abs_tol=0.0):
    """Return math.isclose(a, b): two infinite numbers are close if they are equal."""
    largest = np.maximum(np.fabs(a), np.fabs(b))
    is_near = np.fabs(a - b) <= np.maximum(rel_tol * largest, abs_tol)
    return is_near & (largest < np.inf) | (a == b)


MATH: dict[str, Callable] = {
    **{
        name: f
        for name in vars(math)
        if isinstance(f := getattr(np, name, None), np.ufunc)
    },
    **{name: COMPOSED[name] for name in ("erf", "erfc", "gamma")},
    "log": lambda a, base=None: np.log(a) if base is None else np.log(a) / np.log(base),
    "hypot": hypot,
    "remainder": remainder,
    "isclose": isclose,
    "dist": lambda a, b: hypot(*map(np.subtract, a, b)),
    "prod": lambda a, start=1: functools.reduce(lambda v, w: v * w, a, start),
}
RAISING = words(  # if a number is out of range
    """
    sqrt log log2 log10 log1p asin acos acosh atanh exp exp2 expm1 sinh cosh pow fmod
    remainder
    """
)


def of_math(name: str, tape: Tape, *arguments: Any, **options: Any) -> Any:
    """Record a function of `math`."""
    numbers = tuple(map(single, arguments))
    if name in RAISING:
        raise_in_a_try(name, *numbers)
    value = MATH[name](*numbers, **options)
    is_int = name in ("floor", "ceil", "trunc") or (name == "prod" and is_whole(value))
    if isinstance(value, tuple):
        return tuple(map(of_python, value))
    return of_python(value, is_int)


MATH_FUNCTIONS = [
    TracerFunction(getattr(math, name), functools.partial(of_math, name))
    for name in MATH
]


def of_values(real: Callable, record: Callable[[list], Any]) -> Callable:
    """Return the tracer function of a function of values, given one by one or in a list."""

    @functools.wraps(real)
    def function(*arguments, **options):
        tape = active()
        if real in (any, all) and tape is not None and not tape.merging:
            return real(
                *arguments
            )  # which leaves the values behind the first that decides
        values = list(arguments[0]) if len(arguments) == 1 else list(arguments)
        if options or tape_of(values) is None:
            return real(values, **options)
        return record(values)

    return function


def best(better: Callable, values: list) -> Any:
    """Return max or min: a value replaces the best value so far if it is better."""
    numbers = [*map(single, values)]
    kinds = {(is_of_python(number), is_whole(number)) for number in numbers}
    if len(values) > LONG_ROW and len(kinds) == 1:
        row = lifted(tape_of(values), numbers)
        value = np.min(row) if better is np.less else np.max(row)
        ((value._of_python, value._whole),) = kinds
        return value
    return functools.reduce(lambda a, b: chosen(better(b, a), b, a), numbers)


def compensated(values: Iterable[Any], start: Any = 0) -> Any:
    """Return Python's sum, which since Python 3.12 compensates rounding in sums of its own floats.

    Since 3.14 whole numbers among them are compensated too.  Compensation ends at a number of
    NumPy, or one that may be NumPy's.
    """
    values = list(values)
    if tape_of((start, *values)) is None:
        return sum(values, start)
    total = start
    lost = 0.0
    count = 0
    for value in values:
        if not all_of([is_of_python(total), is_of_python(value)]):
            break
        new = total + value
        is_exact = is_whole(total) or (sys.version_info < (3, 14) and is_whole(value))
        lost = lost if is_exact else lost + rounded_off(total, value, new)
        total = new
        count += 1
    if isinstance(lost, Array) or lost:
        total = where(np.isfinite(lost), total + lost, total)
    return sum(values[count:], total)


def printed(*values: Any, **options: Any) -> None:
    """Print, except while a function is traced: its numbers have no values."""
    if active() is None:
        print(*values, **options)


BUILTIN_FUNCTIONS: dict[str, Any] = {
    "float": TYPES[float],
    "int": TYPES[int],
    "max": of_values(max, functools.partial(best, np.greater)),
    "min": of_values(min, functools.partial(best, np.less)),
    "any": of_values(
        any, lambda values: of_python(functools.reduce(np.logical_or, values, False))
    ),
    "all": of_values(
        all, lambda values: of_python(functools.reduce(np.logical_and, values, True))
    ),
    "isinstance": is_instance,
    "hasattr": has_attribute,
    "type": type_of,
    "print": printed,
    **({"sum": compensated} if sys.version_info >= (3, 12) else {}),
}
BUILTINS: dict[str, Any] = vars(builtins) | BUILTIN_FUNCTIONS


# --- NumPy --------------------------------------------------------------------------------------


def tracer_of_numpy_function(real: Any) -> TracerFunction:
    """Return the tracer function of a function of NumPy, for lists that hold signals."""
    if isinstance(real, np.ufunc):
        return TracerFunction(real, functools.partial(apply_ufunc, real, "__call__"))
    record = functools.partial(apply_function, real)
    return TracerFunction(real, MAKERS.get(real, record))


def new_array(
    tape: Any, value: Any, dtype: Any = None, *, ndmin: int = 0, **options: Any
) -> Any:
    """Return np.array of values that hold signals."""
    new = lifted(tape, value)
    if dtype is not None:
        new = converted(new, dtype)
    elif options.get("copy", True):
        new = copied(new)
    return boxed(tape, new[(None,) * (ndmin - new.ndim)] if ndmin > new.ndim else new)


def same_array(tape, value, dtype=None, **options):
    """Return np.asarray of values that hold signals."""
    if isinstance(value, Array) and (dtype is None or np.dtype(dtype) == float):
        return boxed(tape, value)
    return new_array(tape, value, dtype)


def full(tape: Tape, shape: Any, value: Any, dtype: Any = None, **options: Any) -> Any:
    """Return np.full of a signal."""
    new = lifted(tape, np.zeros(whole(shape))) + lifted(tape, value)
    new._whole = is_whole(value)
    return boxed(tape, new if dtype is None else converted(new, dtype))


def of_counts(real: Callable) -> Callable:
    """Return the record of np.zeros and such functions: new arrays whose sizes are signals."""
    return lambda tape, *counts, **options: fresh(tape, real(*whole(counts), **options))


MAKERS: dict[Any, Callable] = {
    np.array: new_array,
    **dict.fromkeys((np.asarray, np.asanyarray), same_array),
    np.full: full,
    **{
        real: of_counts(real)
        for real in (np.zeros, np.ones, np.empty, np.eye, np.identity)
    },
    np.isscalar: lambda tape, a: isinstance(a, Array) and not (a.shape or a._boxed),
}


class Joiner:
    """np.r_ or np.c_: arrays in brackets are concatenated."""

    def __init__(self, real: Any, join: Callable):
        def joined(tape: Tape, index: Any) -> Any:
            values = index if isinstance(index, tuple) else (index,)
            arrays = [real[v] if isinstance(v, slice) else v for v in values]
            return join([*map(np.atleast_1d, arrays)])

        self.at = TracerFunction(real.__getitem__, joined)

    def __getitem__(self, index):
        return self.at(index)


# --- modules ------------------------------------------------------------------------------------


class TracerModule(ModuleType):
    """A module whose names have tracer values; nobody can change it."""

    def __init__(self, real: ModuleType, tracer_value: Callable):
        vars(self).update(
            __name__=real.__name__, _real=real, _tracer_value=tracer_value
        )

    def __getattr__(self, name: str) -> Any:
        return self._tracer_value(getattr(self._real, name))

    def __setattr__(self, name: str, *value: Any) -> None:
        raise Unread(REMEMBERS.format(f"{self.__name__}.{name}"))

    __delattr__ = __setattr__


def errstate(**arguments):
    """Return np.errstate; refuse to raise, as no operation raises while it is traced."""
    if active() is not None and {"raise", "call", "log"} & {*arguments.values()}:
        raise Unread("np.errstate that raises. Test with `if` before")
    return np.errstate(**arguments)


def unseeded(*seed, **options):
    """Return np.random.default_rng of a seed; refuse one without a seed."""
    if active() is not None and not seed and not options:
        raise Unread(UNSEEDED)
    return np.random.default_rng(*seed, **options)


class SilentLogger:
    """A logger that does nothing."""

    def __getattr__(self, name: str) -> Callable:
        return lambda *arguments, **options: None


SILENT = SilentLogger()
_known: dict[int, Any] = {  # by the identity of the real value
    id(bisect.bisect_left): TracerFunction(
        bisect.bisect_left, lambda tape, row, value: searched(row, value, "left")
    ),
    id(bisect.bisect_right): TracerFunction(
        bisect.bisect_right, lambda tape, row, value: searched(row, value, "right")
    ),
    id(np.random.default_rng): unseeded,
    id(np.errstate): errstate,
    id(logging.getLogger): lambda *name: SILENT,
    **{id(getattr(logging, name)): getattr(SILENT, name) for name in OF_LOGGING},
    id(np.r_): Joiner(np.r_, np.concatenate),
    id(np.c_): Joiner(np.c_, np.column_stack),
    **{id(real): traced for real, traced in TYPES.items()},
    **{id(traced.real): traced for traced in MATH_FUNCTIONS},
    **{
        id(getattr(builtins, name)): traced
        for name, traced in BUILTIN_FUNCTIONS.items()
    },
}


def tracer_value(value):
    """Return the tracer value of a module, function, type or interpolator; others as they are."""
    if (known := _known.get(id(value))) is not None:
        return known
    if isinstance(value, logging.Logger | logging.LoggerAdapter):
        return SILENT
    if isinstance(value, ModuleType):
        return _known.setdefault(id(value), TracerModule(value, tracer_value))
    is_function = isinstance(value, FUNCTIONS) and any(
        vars(module).get(value.__name__) is value for module in (np, np.linalg)
    )
    if isinstance(value, np.ufunc) or is_function:
        return _known.setdefault(id(value), tracer_of_numpy_function(value))
    table = function_of(value)
    return value if table is None else TracerFunction(value, table)
