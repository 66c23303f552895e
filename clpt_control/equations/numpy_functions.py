"""What NumPy's functions and methods do with arrays of the record.

What is not here is tried on arrays of objects, element by element, by NumPy's own code.
"""

from collections.abc import Callable
from typing import Any

import numpy as np

from . import elimination, tables
from .arrays import PARTS, Array, Tape, elementwise, lifted, packed, stacked, total, where
from .opened import as_numbers, depends, exploded, fresh, objects, tape_of, unread
from .reshaping import (
    at_least,
    converted,
    copied,
    filled,
    full_like,
    join,
    reshaped,
    squeezed,
    stack,
    transposed,
)
from .ufuncs import accumulated, folded, matmul, rounded, summed
from .views import tape_viewed


def applied(tape: Tape, function: Any, inputs: Any, more: dict) -> Any:
    """Write down one of NumPy's functions."""
    if not depends(tuple(inputs)) and not depends(list(more.values())):
        known = {name: as_numbers(value) for name, value in more.items()}
        return fresh(tape, function(*as_numbers(tuple(inputs)), **known))
    if function not in FUNCTIONS:
        return exploded(tape, function, inputs, more)
    return FUNCTIONS[function](*inputs, **more)


def _of_arrays(function: Callable, count: int = 1) -> Callable:
    """Return a function whose first arguments are made arrays of the record."""

    def made(*inputs: Any, **more: Any) -> Any:
        tape = tape_of((*inputs, *more.values()))
        return function(*(lifted(tape, v) for v in inputs[:count]), *inputs[count:], **more)

    return made


# --- products, sums and norms ---------------------------------------------------------------


def dot(a: Any, b: Any, out: Any = None) -> Any:
    """Return np.dot(a, b)."""
    return matmul(a, b) if np.ndim(a) and np.ndim(b) else elementwise("mul", a, b)


def outer(a: Any, b: Any, out: Any = None) -> Any:
    """Return a b^T."""
    a, b = (v if np.ndim(v) == 1 else np.reshape(v, -1) for v in (a, b))
    return elementwise("mul", a[:, None], b[None, :])


def norm(a: Any, ord: Any = None, axis: Any = None, keepdims: Any = False) -> Any:
    """Return a norm of a vector, or of rows or columns."""
    vector = a.ndim == 1 or isinstance(axis, int)
    if ord in (np.inf, -np.inf) and vector:
        return (largest if ord > 0 else smallest)(np.fabs(a), axis)
    if ord == 1 and vector:
        return summed(np.fabs(a), axis, keepdims=keepdims)
    if ord not in (None, 2, "fro") or (ord == 2 and not vector):
        if not vector or not isinstance(ord, int | float):
            return unread(f"a norm of order {ord}")
        return summed(np.fabs(a) ** ord, axis, keepdims=keepdims) ** (1.0 / ord)
    return np.sqrt(summed(elementwise("mul", a, a), axis, keepdims=keepdims))


def product(
    a: Any, axis: Any = None, dtype: Any = None, out: Any = None, keepdims: Any = False
) -> Any:
    """Return the product of the elements."""
    if axis is None and not a.size:
        return 1.0
    return folded(lambda v, w: v * w, a, axis, keepdims)


def largest(a: Any, axis: Any = None, out: Any = None, keepdims: Any = False, **more: Any) -> Any:
    """Return the largest element."""
    return folded(np.maximum, a, axis, keepdims)


def smallest(a: Any, axis: Any = None, out: Any = None, keepdims: Any = False, **more: Any) -> Any:
    """Return the smallest element."""
    return folded(np.minimum, a, axis, keepdims)


def mean(
    a: Any, axis: Any = None, dtype: Any = None, out: Any = None, keepdims: Any = False
) -> Any:
    """Return the mean."""
    count = a.size if axis is None else a.counted()[axis]
    return summed(a, axis, keepdims=keepdims) / count


def variance(a: Any, axis: Any = None, dtype: Any = None, out: Any = None, ddof: int = 0) -> Any:
    """Return the mean square of what differs from the mean."""
    count = a.size if axis is None else a.counted()[axis]
    apart = a - mean(a, axis, keepdims=True) if axis is not None else a - mean(a)
    return summed(apart * apart, axis) / (count - ddof)


def trace(a: Any, *more: Any, **named: Any) -> Any:
    """Return the sum of the diagonal."""
    return total(diagonal(a, *more, **named), 0)


def diagonal(a: Array, offset: int = 0, **more: Any) -> Any:
    """Return the diagonal of a matrix."""
    n = a.shape[0]
    if a.ndim != 2 or offset or a.shape[0] != a.shape[1] or a._written() is not None:
        return packed(a.tape, objects(a).diagonal(offset))
    return tape_viewed(a.tape, a.ref, ((0, 0, 1), (0, 0, 1)), (n,))


def diag(a: Array, k: int = 0) -> Any:
    """Return the diagonal of a matrix, or the matrix of a diagonal."""
    if a.ndim == 2:
        return diagonal(a, k)
    made = np.zeros((len(a) + abs(k),) * 2, dtype=object)
    for i in range(len(a)):
        made[i + max(0, -k), i + max(0, k)] = a[i]
    return packed(a.tape, made)


# --- limits and choices -----------------------------------------------------------------------


def clip(a: Any, low: Any = None, high: Any = None, out: Any = None, **more: Any) -> Any:
    """Return a within limits."""
    low, high = more.get("min", more.get("a_min", low)), more.get("max", more.get("a_max", high))
    tape = tape_of((a, low, high))
    a, low, high = (None if v is None else lifted(tape, v) for v in (a, low, high))
    if low is not None:
        a = np.maximum(a, low)
    return np.minimum(a, high) if high is not None else a


def chosen(condition: Any, *values: Any) -> Any:
    """Return np.where(condition, a, b)."""
    if not values:
        return unread("np.where without values, which counts,")
    tape = tape_of((condition, *values))
    return where(
        condition if isinstance(condition, Array) else np.asarray(condition),
        *(lifted(tape, v) for v in values),
    )


def selected(conditions: Any, values: Any, default: Any = 0.0) -> Any:
    """Return np.select: the value of the first condition that holds."""
    found = default
    for condition, value in zip(reversed(conditions), reversed(values), strict=True):
        found = (
            np.where(condition, value, found)
            if np.ndim(condition)
            else chosen(condition, value, found)
        )
    return found


def piecewise(x: Any, conditions: Any, functions: Any, *more: Any, **named: Any) -> Any:
    """Return np.piecewise: what the function of the last condition that holds gives."""
    given = [f(x, *more, **named) if callable(f) else f for f in functions]
    found = given.pop() if len(given) > len(conditions) else 0.0
    for condition, value in zip(conditions, given, strict=True):
        found = chosen(condition, value, found)
    return found


def close(a: Any, b: Any, rtol: float = 1e-5, atol: float = 1e-8, equal_nan: bool = False) -> Any:
    """Return whether numbers are about the same, as np.isclose does."""
    return np.fabs(a - b) <= atol + rtol * np.fabs(b)


def polynomial(coefficients: Any, x: Any) -> Any:
    """Return np.polyval, by Horner's rule."""
    found = np.zeros_like(x)
    for one in coefficients:
        found = found * x + one
    return found


def any_of(a: Any, axis: Any = None, out: Any = None, keepdims: Any = False, **more: Any) -> Any:
    """Return whether any holds."""
    return folded(np.logical_or, a, axis, keepdims)


def all_of(a: Any, axis: Any = None, out: Any = None, keepdims: Any = False, **more: Any) -> Any:
    """Return whether all hold."""
    return folded(np.logical_and, a, axis, keepdims)


def whole_numbers(
    a: Any, copy: bool = True, nan: float = 0.0, posinf: Any = None, neginf: Any = None
) -> Any:
    """Return np.nan_to_num(a)."""
    most = np.finfo(float).max
    a = where(a != a, nan, a)
    a = where(a == np.inf, most if posinf is None else posinf, a)
    return where(a == -np.inf, -most if neginf is None else neginf, a)


def in_order(values: list[Any]) -> list[Any]:
    """Return numbers sorted: neighbours change places where they must, until none does."""
    found = list(values)
    for end in range(len(found) - 1, 0, -1):
        for k in range(end):
            a, b = found[k], found[k + 1]
            swap = b < a
            found[k], found[k + 1] = where(swap, b, a), where(swap, a, b)
    return found


def in_rows(a: Any, axis: int = -1, **more: Any) -> Any:
    """Return np.sort(a) of a vector."""
    if a.ndim != 1 or a.size > 16:
        return unread("sorting more than 16 numbers, or rows,")
    return stacked(a.tape, in_order(list(a.elements())))


FUNCTIONS: dict[Any, Callable] = {
    np.sum: _of_arrays(summed),
    np.dot: _of_arrays(dot, 2),
    np.vdot: _of_arrays(dot, 2),
    np.outer: _of_arrays(outer, 2),
    np.where: chosen,
    np.select: selected,
    np.piecewise: piecewise,
    np.isclose: _of_arrays(close, 2),
    np.allclose: lambda *a, **more: all_of(_of_arrays(close, 2)(*a, **more)),
    np.nan_to_num: _of_arrays(whole_numbers),
    np.polyval: polynomial,
    np.sort: _of_arrays(in_rows),
    np.interp: _of_arrays(tables.interpolated),
    np.searchsorted: lambda a, v, side="left", **more: tables.place_in(
        np.asarray(tables.known(a), dtype=float), v, side
    ),
    np.digitize: lambda x, bins, right=False: tables.place_in(
        np.asarray(tables.known(bins), dtype=float), x, "left" if right else "right"
    ),
    np.linalg.norm: _of_arrays(norm),
    np.linalg.solve: _of_arrays(elimination.solve, 2),
    np.linalg.inv: _of_arrays(elimination.inverse),
    np.linalg.det: _of_arrays(elimination.determinant),
    np.clip: clip,
    np.trace: _of_arrays(trace),
    np.diag: _of_arrays(diag),
    np.diagonal: _of_arrays(diagonal),
    np.stack: stack,
    np.concatenate: join,
    np.max: _of_arrays(largest),
    np.amax: _of_arrays(largest),
    np.min: _of_arrays(smallest),
    np.amin: _of_arrays(smallest),
    np.prod: _of_arrays(product),
    np.mean: _of_arrays(mean),
    np.var: _of_arrays(variance),
    np.std: lambda *a, **more: np.sqrt(_of_arrays(variance)(*a, **more)),
    np.cumsum: lambda a, axis=None, **more: accumulated(np.add, a, axis),
    np.cumprod: lambda a, axis=None, **more: accumulated(np.multiply, a, axis),
    np.any: _of_arrays(any_of),
    np.all: _of_arrays(all_of),
    np.reshape: _of_arrays(reshaped),
    np.ravel: lambda a, *more, **named: reshaped(a, -1),
    np.squeeze: _of_arrays(squeezed),
    np.transpose: _of_arrays(transposed),
    np.round: _of_arrays(rounded),
    np.around: _of_arrays(rounded),
    np.fix: _of_arrays(np.trunc),
    np.copy: copied,
    np.zeros_like: filled(0.0),
    np.empty_like: filled(0.0),
    np.ones_like: filled(1.0),
    np.full_like: full_like,
    np.shape: lambda a: a.counted(),
    np.ndim: lambda a: a.ndim,
    np.size: lambda a, axis=None: a.size if axis is None else a.counted()[axis],
    np.atleast_1d: at_least(1),
    np.atleast_2d: at_least(2),
    np.real: lambda a: a,
    np.iscomplexobj: lambda a: False,
    np.isrealobj: lambda a: True,
    np.isreal: lambda a: a == a,
}
METHODS: dict[str, Callable] = {
    "sum": summed,
    "dot": lambda a, b: np.dot(a, b),
    "clip": clip,
    "trace": trace,
    "max": largest,
    "min": smallest,
    "prod": product,
    "mean": mean,
    "var": variance,
    "std": lambda a, *more, **named: np.sqrt(variance(a, *more, **named)),
    "any": any_of,
    "all": all_of,
    "reshape": reshaped,
    "ravel": lambda a, *more, **named: reshaped(a, -1),
    "flatten": lambda a, *more: copied(reshaped(a, -1)),
    "copy": copied,
    "__copy__": copied,
    "__deepcopy__": copied,
    "astype": converted,
    "item": lambda a, *at: a[at] if at else (objects(a).ravel()[0] if a.shape else a),
    "tolist": lambda a: objects(a).tolist(),
    "squeeze": squeezed,
    "transpose": transposed,
    "round": rounded,
    "cumsum": lambda a, axis=None, **more: accumulated(np.add, a, axis),
    "fill": lambda a, value: a.__setitem__(..., value),
    "diagonal": diagonal,
    "is_integer": lambda a: np.floor(a) == a,
    "conj": lambda a: a,
    "conjugate": lambda a: a,
    **{  # what NumPy asks of the elements of arrays of objects
        name: (lambda ufunc: lambda a, *b: ufunc(a, *b))(getattr(np, name))
        for name in (
            *("sin", "cos", "tan", "arcsin", "arccos", "arctan", "arctan2", "sinh", "cosh", "tanh"),
            *("exp", "expm1", "log", "log1p", "log2", "log10", "sqrt", "cbrt", "hypot", "fmod"),
            *("floor", "ceil", "trunc", "rint", "fabs", "sign", "square", "deg2rad", "rad2deg"),
        )
    },
}


PARTS.update(applied=applied, methods=METHODS)
