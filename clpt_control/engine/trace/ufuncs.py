"""NumPy's ufuncs on tracer arrays."""

from collections.abc import Callable
from functools import partial, reduce
from itertools import accumulate
from typing import Any

import numpy as np

from ..record.operations import UFUNCS
from ..record.unread import Unread
from .arrays import HOOKS, Array, Tape, operand
from .elementwise import (
    as_condition,
    as_number,
    elementwise,
    is_of_python,
    is_truth,
    lifted,
    total,
    where,
)
from .references import words
from .views import (
    converted,
    copied,
    depends,
    into,
    on_numbers,
    on_parameters,
    refuse,
    tape_of,
)

LONG_ROW = 24  # numbers of which the least is found by one operation


def apply_ufunc(
    ufunc: Any, method: str, tape: Tape, /, *inputs: Any, **options: Any
) -> Any:
    """Record a ufunc."""
    out = options.pop("out", None)
    if isinstance(out, tuple):
        (out,) = out
    if method == "__call__" and len(inputs) > ufunc.nin:
        *inputs, out = inputs  # type: ignore[assignment]
    condition = options.pop("where", True) if method == "__call__" else True
    check_doubles(options.pop("dtype", None))
    for unused in ("casting", "subok", "order"):
        options.pop(unused, None)
    try:
        result = _apply(tape, ufunc, method, inputs, options)
    except Unread as why:
        result = on_parameters(tape, getattr(ufunc, method), inputs, options, why)
    if condition is not True:
        result = np.where(condition, result, 0.0 if out is None else out)
    return into(out, result)


def check_doubles(dtype: Any) -> None:
    """Refuse types other than doubles, and an array to write into given by position."""
    if dtype is None:
        return
    if isinstance(dtype, Array) or np.dtype(dtype) not in (np.float64, np.object_):
        refuse(f"an operation in {np.dtype(dtype)}")


def _apply(tape: Tape, ufunc: Any, method: str, inputs: Any, options: dict) -> Any:
    """Record a method of a ufunc: a call, `reduce` or `accumulate`."""
    if method != "at" and not depends(inputs):
        return on_numbers(tape, getattr(ufunc, method), inputs, options)
    if method == "reduce" and "where" not in options:
        return reduced(ufunc, *inputs, **options)
    if method == "accumulate":
        return accumulated(ufunc, *inputs, **options)
    if method != "__call__":
        return refuse(f"np.{ufunc.__name__}.{method}")
    inputs = [lifted(tape, a) if isinstance(a, list | tuple) else a for a in inputs]
    if ufunc in UFUNCS and not options:
        return elementwise(UFUNCS[ufunc], *inputs)
    if ufunc in BITWISE:
        return BITWISE[ufunc](*inputs) if all(map(is_truth, inputs)) else refuse("bits")
    name = ufunc.__name__
    if options:
        return refuse(f"np.{name}.__call__")
    arguments = [a if type(a) is int else lifted(tape, a) for a in inputs]
    if name not in TAKING_TRUTHS and all(map(is_truth, arguments)):
        refuse(f"np.{name} of truth values, in short floats,")
    return COMPOSED[name](*arguments) if name in COMPOSED else refuse(f"np.{name}")


def reduced(ufunc, a, axis=0, keepdims=False, initial=None):
    """Reduce the elements along an axis, or all, one after the other; a sum is one operation."""
    a = lifted(tape_of([a]), a)
    a = a if np.ndim(a) else copied(a)
    if ufunc in (np.logical_and, np.logical_or):
        a = as_condition(a)
    axes = [axis] if isinstance(axis, int) else axis
    if axis is None and ufunc is np.add:
        axes = range(a.ndim)
    elif axis is None:
        a = np.ravel(a)
        axes = [0]
        keepdims = False
        if a.size > LONG_ROW and ufunc in (np.minimum, np.maximum):
            row = as_number(a)
            a = row[place_of_the_least(row if ufunc is np.minimum else -row)]
            axes = []
    for d in sorted((d % a.ndim for d in axes), reverse=True):
        a = total(a, d) if ufunc is np.add else _folded(ufunc, [*np.moveaxis(a, d, 0)])
        if keepdims and isinstance(a, Array):
            a = np.expand_dims(a, d)
    return a if initial is None else ufunc(a, initial)


def place_of_the_least(row: Array) -> Any:
    """Return the index of the least number of a row, as one operation."""
    index = row._tape.add("argmin", (operand(row),), ())
    index._whole = True
    index._below = row.size
    return index


def _folded(ufunc: Any, slices: list[Any]) -> Any:
    if not slices and ufunc.identity is None:
        raise ValueError("zero-size array to reduction operation")
    return (
        reduce(ufunc, slices[1:], copied(slices[0]))
        if slices
        else float(ufunc.identity)
    )


def accumulated(ufunc, a, axis=0):
    """Return the partial results of a reduction along an axis, as np.cumsum does."""
    a = as_number(lifted(tape_of([a]), a))
    if axis is None:
        a = np.ravel(a)
        axis = 0
    return np.stack([*accumulate(np.moveaxis(a, axis, 0), ufunc)], axis)


def matmul(a, b):
    """Return a @ b."""
    if not np.ndim(a) or not np.ndim(b):
        raise ValueError("matmul: an operand is a scalar")
    if is_truth(a) and is_truth(b):
        return refuse("a product of matrices of truth values")
    if a.shape[-1] != b.shape[-2:][0]:
        raise ValueError(f"matmul: shapes {a.shape} and {b.shape} do not fit")
    if b.ndim == 1:
        return total(a * b, -1)
    if a.ndim == 1:
        return total(a[:, None] * b, -2)
    return total(a[..., None] * b[..., None, :, :], -2)


def rounded(a: Array, decimals: Any = None) -> Any:
    """Return numbers rounded to even."""
    if decimals:
        scale = 10.0 ** abs(int(decimals))
        return (
            rounded(a * scale) / scale if decimals > 0 else rounded(a / scale) * scale
        )
    low = np.floor(a)
    fraction = a - low
    odd = np.remainder(low, 2.0)
    return where((fraction > 0.5) | ((fraction == 0.5) & (odd > 0.5)), np.ceil(a), low)


def signbit(a: Array) -> Any:
    """Return whether a sign is a minus, of -0 too."""
    inverse = a._tape.add("div", (1.0, operand(a)), a.shape)  # which raises in no `try`
    return (a < 0) | (inverse == -np.inf)


def copysign(a, b):
    """Return |a| with the sign of b."""
    size = np.fabs(a)
    return (
        where(signbit(b), -size, size)
        if isinstance(b, Array)
        else np.copysign(1.0, b) * size
    )


def fmod(a, b):
    """Return the remainder of a / b, with the sign of a."""
    remainder = elementwise("mod", np.fabs(a), np.fabs(b))
    return where(a < 0, -remainder, remainder)


def logaddexp(a, b):
    """Return log(exp(a) + exp(b)); its derivatives are right for any offset."""
    offset = np.maximum(a, b)
    return offset + np.log(np.exp(a - offset) + np.exp(b - offset))


BITWISE: dict[Any, Callable] = {  # of truth values
    np.bitwise_and: np.logical_and,
    np.bitwise_or: np.logical_or,
    np.bitwise_xor: np.not_equal,
    np.invert: lambda a: np.logical_not(a) if is_of_python(a) is False else refuse("~"),
}
TAKING_TRUTHS = words("logical_xor isnan isfinite isinf square conjugate rint")
COMPOSED: dict[str, Callable] = {  # by the ufunc's name; those of scipy.special too
    "vecdot": lambda a, b: total(a * b, -1),
    **dict.fromkeys(("matmul", "matvec"), matmul),
    "square": lambda a: a * a,
    "reciprocal": lambda a: 1.0 / a,
    **dict.fromkeys(("positive", "conjugate"), copied),
    **dict.fromkeys(("deg2rad", "radians"), lambda a: a * (np.pi / 180)),
    **dict.fromkeys(("rad2deg", "degrees"), lambda a: a * (180 / np.pi)),
    "fabs": lambda a: converted(np.abs(a)),
    "exp2": lambda a: 2.0**a,
    "cbrt": lambda a: np.sign(a) * np.fabs(a) ** (1 / 3),
    "rint": rounded,
    "isnan": lambda a: a != a,
    "isfinite": lambda a: np.abs(a) < np.inf,
    "isinf": lambda a: np.abs(a) == np.inf,
    "heaviside": lambda a, b: where(a > 0, 1.0, where(a < 0, 0.0, where(a == 0, b, a))),
    "logical_xor": lambda a, b: (a != 0) != (b != 0),
    "modf": lambda a: (a - np.trunc(a), np.trunc(a)),
    "divmod": lambda a, b: (np.floor_divide(a, b), np.remainder(a, b)),
    **{
        composed.__name__: composed for composed in (copysign, fmod, logaddexp, signbit)
    },
    **{name: partial(elementwise, name) for name in ("erf", "erfc")},
    "gamma": partial(elementwise, "tgamma"),
    "expit": lambda a: 1.0 / (1.0 + np.exp(-a)),
}


HOOKS.update(ufunc=apply_ufunc)
