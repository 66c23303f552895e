"""NumPy's functions and methods on tracer arrays.

Functions that are not here run NumPy's own code on arrays of objects, element by element.
"""

from collections.abc import Callable, Iterator
from functools import partial
from math import prod
from typing import Any

import numpy as np

from ..record.graph import PIVOT
from ..record.unread import Unread
from . import views
from .arrays import HOOKS, Array, Tape, moves, objects, operand
from .elementwise import (
    as_number,
    boxed,
    filled,
    in_a_try,
    is_truth,
    is_whole,
    lifted,
    of_python,
    refuse_in_a_try,
    where,
)
from .interpolators import interpolated, searched
from .references import words
from .ufuncs import (
    LONG_ROW,
    accumulated,
    check_doubles,
    place_of_the_least,
    reduced,
    rounded,
)
from .views import depends, into, on_numbers, on_objects, on_parameters, refuse, tape_of

BOXED = {  # functions whose results are arrays, also without axes
    np.where,
    np.select,
    np.piecewise,
    np.copy,
    np.zeros_like,
    np.ones_like,
    np.empty_like,
    np.full_like,
}


def apply_function(function: Any, tape: Tape, /, *inputs: Any, **options: Any) -> Any:
    """Record a function of NumPy."""
    out = options.pop("out", None)
    result = None
    try:
        if function not in SHARES and not depends((*inputs, *options.values())):
            result = on_numbers(tape, function, inputs, options)
        elif function in IMPLEMENTED:
            result = IMPLEMENTED[function](*inputs, **options)
        if result is None:
            result = on_objects(tape, function, inputs, options)
    except Unread as why:
        result = on_parameters(tape, function, inputs, options, why)
    return into(out, boxed(tape, result) if function in BOXED else result)


# --- means and slopes -------------------------------------------------------------


def mean(a, axis=None, dtype=None, keepdims=False, ddof=0):
    """Return the mean."""
    check_doubles(dtype)
    total = np.sum(a, axis, keepdims=keepdims)
    return total / (a.size // total.size - ddof)


def variance(a, axis=None, dtype=None, ddof=0, keepdims=0):
    """Return the mean square of the deviation from the mean."""
    deviation = a - mean(a, axis, dtype, keepdims=axis is not None)
    return mean(deviation * deviation, axis, dtype, keepdims, ddof)


def differences(a: Any, n: Any = 1, axis: int = -1, **options: Any) -> Any:
    """Return np.diff(a, n)."""
    if options or is_truth(a) or not a.ndim or n < 1:
        return None
    rows = np.moveaxis(a, axis, 0)
    for _ in range(n):
        rows = rows[1:] - rows[:-1]
    return np.moveaxis(rows, 0, axis)


def gradient(f, h=1.0, *steps, axis=None, edge_order=1):
    """Return np.gradient along one axis, by one step."""
    axis = 0 if axis is None and f.ndim == 1 else axis
    if steps or np.ndim(h) or edge_order != 1 or not isinstance(axis, int):
        return refuse("np.gradient along several axes, by places, or of another order")
    f = np.moveaxis(f, axis, 0)
    inner = (f[2:] - f[:-2]) / (2.0 * h)
    slopes = [(f[1:2] - f[:1]) / h, inner, (f[-1:] - f[-2:-1]) / h]
    return np.moveaxis(np.concatenate(slopes), 0, axis)


# --- linear algebra ------------------------------------------------------------------------------
#
# A x = b by elimination, det A as the product of its pivots: the largest number of a column, as
# np.linalg.solve chooses them, by `where`.

MOST_ROWS = 24  # of linear equations


def dot(a, b):
    """Return np.dot(a, b)."""
    if np.ndim(a) and np.ndim(b) > 2:
        return np.tensordot(a, b, (-1, -2))
    return a @ b if np.ndim(a) and np.ndim(b) else a * b


def outer(a, b):
    """Return a b^T."""
    a, b = (v if np.ndim(v) == 1 else np.reshape(v, -1) for v in (a, b))
    return a[:, None] * b[None, :]


def norm(a, ord=None, axis=None, keepdims=False):
    """Return the root of a sum of squares; other norms are NumPy's own, of each element."""
    if ord in (None, "fro") or (ord == 2 and (a.ndim == 1 or isinstance(axis, int))):
        return np.sqrt(np.sum(a * a, axis, keepdims=keepdims))
    return None


def _rows(matrix: Any) -> list[Any]:
    count = len(matrix)
    if count > MOST_ROWS:
        raise Unread(
            f"linear equations of more than {MOST_ROWS} rows with signals in their matrix"
        )
    return [matrix[k] for k in range(count)]


def _is_better_pivot(a: Any, b: Any) -> Any:
    """Return |a| > |b|; no switch to locate, as x is the same with either pivot."""
    if (tape := tape_of((a, b))) is None:
        return abs(a) > abs(b)
    sizes = [tape.add("fabs", (operand(v),), (), PIVOT)._ref for v in (a, b)]
    return tape.add("gt", sizes, (), PIVOT)


def _eliminate(rows: list[Any], divisor: Callable = lambda pivot: pivot) -> Any:
    """Make rows triangular, in place; return the sign of their permutation."""
    sign = 1.0
    count = len(rows)
    if in_a_try() and any(map(moves, rows)):  # a singular matrix would raise
        refuse_in_a_try()
    for k in range(count):
        # the row with the largest number in column k comes first
        for i in range(k + 1, count):
            upper = rows[k]
            lower = rows[i]
            is_larger = _is_better_pivot(lower[k], upper[k])
            rows[k] = where(is_larger, lower, upper)
            rows[i] = where(is_larger, upper, lower)
            sign = where(is_larger, -sign, sign)
        for i in range(k + 1, count):
            factor = rows[i][k] / divisor(rows[k][k])
            rows[i] = rows[i] - rows[k] * factor
    return sign


def solve(A, b):
    """Return the x of A x = b, as np.linalg.solve does."""
    n = A.shape[0]
    if A.ndim != 2 or A.shape != (n, n) or b.shape[0] != n:
        raise ValueError("solve: A must be square, b as long")
    columns = np.reshape(b, (n, -1))
    rows = [np.concatenate([row, columns[k]]) for k, row in enumerate(_rows(A))]
    _eliminate(rows)
    solved: list[Any] = [None] * n
    for k in reversed(range(n)):
        total = rows[k][n:]
        for i in range(k + 1, n):
            total = total - solved[i] * rows[k][i]
        solved[k] = total / rows[k][k]
    return np.reshape(np.stack(solved), b.shape)


def determinant(A):
    """Return the determinant: the product of the pivots."""
    rows = _rows(A)
    sign = _eliminate(rows, lambda pivot: where(pivot == 0.0, 1.0, pivot))
    return prod((row[k] for k, row in enumerate(rows)), start=sign)


# --- limits and choices -----------------------------------------------------------------------


def clip(a, a_min=None, a_max=None, *, min=None, max=None):
    """Return a within limits."""
    low = a_min if min is None else min
    high = a_max if max is None else max
    if low is not None:
        a = np.maximum(a, low)
    return np.minimum(a, high) if high is not None else a


def index_of_best(better: Any) -> Callable:
    """Return the record of np.argmax or np.argmin: one comparison for each element, if few."""

    def record(a, *axis, **options):
        if axis or options:
            return None
        if a.size > LONG_ROW:
            return place_of_the_least(
                as_number(np.ravel(a if better is np.less else -a))
            )
        best, *candidates = as_number(np.ravel(a))
        index: Any = 0
        for k, candidate in enumerate(candidates, 1):
            is_better = better(candidate, best)
            best = where(is_better, candidate, best)
            index = where(is_better, k, index)
        if candidates:
            index._below = 1 + len(candidates)
        return index

    return record


def sort(a, *axis, **options):
    """Return a row sorted by merge exchange (Knuth, Sorting and Searching, 1998, 5.2.2 M)."""
    if axis or options or a.ndim != 1:
        return refuse("np.sort along an axis")
    row = list(as_number(a))
    for first, second in merge_exchanges(len(row)):
        pair = row[first], row[second]
        row[first], row[second] = np.minimum(*pair), np.maximum(*pair)
    return lifted(a._tape, row)


def merge_exchanges(n: int) -> Iterator[tuple[int, int]]:
    """Yield the pairs of n places that merge exchange compares: about n log(n)^2 / 4."""
    largest = 1 << (n - 1).bit_length() >> 1
    p = largest
    while p > 0:
        q, r, distance = largest, 0, p
        while distance > 0:
            for i in range(n - distance):
                if i & p == r:
                    yield i, i + distance
            distance, q, r = q - p, q >> 1, p
        p >>= 1


def median(a, *axis, **options):
    """Return the mean of the one or two in the middle."""
    if axis or options:
        return refuse("np.median along an axis")
    row = sort(np.ravel(a))
    start = (len(row) - 1) // 2
    return np.mean(row[start : len(row) // 2 + 1])


def placed(condition, *values):
    """Return np.where(condition, a, b)."""
    if not values:
        return refuse("np.where without values, which counts,")
    tape = tape_of((condition, *values))
    return where(boxed(tape, lifted(tape, condition)), *values)


def selected(conditions, values, default=0):
    """Return np.select: the value of the first condition that holds."""
    result = default
    for condition, value in zip(reversed(conditions), reversed(values), strict=True):
        result = placed(condition, value, result)
    return result


def close(
    a: Any, b: Any, rtol: float = 1e-5, atol: float = 1e-8, equal_nan: bool = False
) -> Any:
    """Return whether numbers are about the same, as np.isclose does."""
    is_near = np.fabs(a - b) <= atol + rtol * np.fabs(b)
    is_close = is_near & (np.fabs(b) < np.inf) | (a == b)
    return is_close | ((a != a) & (b != b)) if equal_nan else is_close


def sinc(a):
    """Return np.sinc(a) = sin(pi a)/(pi a), which is 1 at 0."""
    angle = np.pi * placed(a == 0.0, 1e-20, a)
    return np.sin(angle) / angle


# --- reductions, and functions composed of others ------------------------------------------------


def reducing(reduce: Callable, ufunc: Any) -> Callable:
    """Return the record of a function that reduces all elements, or elements along an axis."""

    def record(a, axis=None, dtype=None, **options):
        if "where" in options:
            return refuse("joining some elements, which np.where chooses,")
        if not is_truth(a) or isinstance(dtype, Array):
            check_doubles(dtype)
        return reduce(ufunc, a, axis, **options)

    return record


def like(value: float, a: Array, dtype: Any = None, **options: Any) -> Any:
    """Return a number everywhere in an array of the shape and kind of another."""
    if is_whole(a) is not False and dtype is None:
        return refuse("an array like one of truth values or whole numbers")
    check_doubles(dtype)
    return filled(a._tape, value, a.shape)


def taken(a, indices, axis=None, mode="raise"):
    """Return np.take(a, indices, axis), which shares no memory with a."""
    rows = np.ravel(a) if axis is None else np.moveaxis(a, axis, 0)
    if mode == "wrap":
        indices = indices % len(rows)
    elif mode == "clip":
        indices = np.clip(indices, 0, len(rows) - 1)
    return views.copied(rows[indices])


# --- views, which share memory -------------------------------------------------------------------


def sharing(function: Any) -> Callable:
    """Return the record of a function of NumPy whose result is a view."""

    def record(a, *arguments, **options):
        orders = {v for v in (*arguments, *options.values()) if isinstance(v, str)}
        if orders & {"A", "K"}:
            return refuse("elements in the order of memory")
        return views.part(
            a, lambda positions: function(positions, *arguments, **options)
        )

    return record


def sharing_each(function: Any) -> Callable:
    """Return the record of a function of NumPy that returns a view of each argument."""

    def record(*values):
        tape = tape_of(values)
        results = [views.part(lifted(tape, value), function) for value in values]
        return results[0] if len(results) == 1 else tuple(results)

    return record


VIEWS = (
    np.reshape,
    np.ravel,
    np.squeeze,
    np.transpose,
    np.swapaxes,
    np.moveaxis,
    np.expand_dims,
    np.flip,
    np.flipud,
    np.fliplr,
    np.diagonal,
    np.diag,
    np.broadcast_to,
    np.rot90,
    np.rollaxis,
    np.atleast_3d,
)
NUMPY_CODE: tuple[Any, ...] = (  # functions whose own code runs on tracer arrays
    np.split,
    np.array_split,
    np.hsplit,
    np.vsplit,
    np.dsplit,
    np.real,
    np.isreal,
    np.ndim,
    np.iscomplexobj,
    np.isrealobj,
)
SHARES: dict[Any, Callable] = {
    **{function: sharing(function) for function in VIEWS},
    **{function: function._implementation for function in NUMPY_CODE},
    **{function: sharing_each(function) for function in (np.atleast_1d, np.atleast_2d)},
}


# --- all functions -------------------------------------------------------------------------------
#
# A record returns None for arguments with which NumPy's own code runs.

AS_GIVEN: dict[Any, Callable] = {
    np.where: placed,
    np.select: selected,
    np.searchsorted: searched,
    np.digitize: lambda x, bins, right=False: searched(
        bins, x, "left" if right else "right"
    ),
    np.stack: views.stack,
    np.concatenate: views.join,
    **{
        function: lambda *_, name=function.__name__, **__: refuse(f"np.{name}")
        for function in (
            np.shares_memory,
            np.may_share_memory,
            np.ix_,
            np.quantile,
            np.percentile,
            np.partition,
            np.argpartition,
        )
    },
}
OF_AN_ARRAY: dict[Any, Callable] = {
    **SHARES,
    np.sum: reducing(reduced, np.add),
    np.prod: reducing(reduced, np.multiply),
    **dict.fromkeys((np.max, np.amax), reducing(reduced, np.maximum)),
    **dict.fromkeys((np.min, np.amin), reducing(reduced, np.minimum)),
    np.any: reducing(reduced, np.logical_or),
    np.all: reducing(reduced, np.logical_and),
    np.cumsum: reducing(accumulated, np.add),
    np.cumprod: reducing(accumulated, np.multiply),
    np.argmax: index_of_best(np.greater),
    np.argmin: index_of_best(np.less),
    np.mean: mean,
    np.var: variance,
    np.std: lambda *a, **options: np.sqrt(np.var(*a, **options)),
    np.ptp: lambda *a, **options: np.max(*a, **options) - np.min(*a, **options),
    np.median: median,
    np.count_nonzero: lambda a: np.sum(a != 0),
    np.diff: differences,
    np.gradient: gradient,
    np.sort: sort,
    np.clip: clip,
    np.sinc: sinc,
    np.imag: np.zeros_like,
    np.interp: interpolated,
    np.take: taken,
    **dict.fromkeys((np.round, np.around), rounded),
    np.fix: np.trunc,
    np.trace: lambda *a, **options: np.sum(np.diagonal(*a, **options)),
    np.linalg.norm: norm,
    np.linalg.det: determinant,
    np.linalg.inv: lambda A: solve(A, np.eye(A.shape[0])),
    np.copy: views.copied,
    **dict.fromkeys((np.zeros_like, np.empty_like), partial(like, 0.0)),
    np.ones_like: partial(like, 1.0),
    np.full_like: lambda a, value, *dtype, **options: (
        like(0.0, a, *dtype, **options) + value
    ),
    np.shape: lambda a: a._counted(),
    np.size: lambda a, axis=None: a.size if axis is None else a._counted()[axis],
}
OF_TWO_ARRAYS: dict[Any, Callable] = {
    np.dot: dot,
    np.outer: outer,
    np.vdot: lambda a, b: dot(np.ravel(a), np.ravel(b)),
    np.linalg.solve: solve,
    np.isclose: close,
    np.allclose: lambda *a, **options: np.all(close(*a, **options)),
}


def of_arrays(record: Callable, count: int) -> Callable:
    """Return the record of a function whose first arguments become tracer arrays."""

    def function(*inputs, **options):
        tape = tape_of((*inputs, *options.values()))
        arrays = [lifted(tape, value) for value in inputs[:count]]
        return record(*arrays, *inputs[count:], **options)

    return function


IMPLEMENTED = {  # NumPy's function -> its record
    function: of_arrays(record, count)
    for count, records in enumerate((AS_GIVEN, OF_AN_ARRAY, OF_TWO_ARRAYS))
    for function, record in records.items()
}


# --- methods -------------------------------------------------------------------------------------


def as_list(a: Array) -> Any:
    """Return elements in lists, as Python's own numbers."""
    elements = objects(a)
    numbers = (of_python(element, is_whole(element)) for element in elements.flat)
    return np.fromiter(numbers, object).reshape(elements.shape).tolist()


def item(a: Array, *index: Any) -> Any:
    """Return a.item(index)."""
    return as_list(a[index] if index else objects(a).ravel()[0])


def astype(a: Array, *kind: Any, **options: Any) -> Any:
    """Return numbers of another kind."""
    new = views.converted(a, *kind, **options)
    return boxed(a._tape, new) if a._boxed else new


METHODS: dict[str, Callable] = {  # which are no functions of NumPy
    "reshape": sharing(np.ndarray.reshape),
    "transpose": sharing(np.ndarray.transpose),
    "flatten": lambda a, order="C": views.copied(np.ravel(a, order)),
    "__copy__": views.copied,
    "__deepcopy__": views.copied,
    "astype": astype,
    "item": item,
    "tolist": as_list,
    "fill": lambda a, value: a.__setitem__(..., value),
    "is_integer": lambda a: np.floor(a) == a,
}
# methods that differ from NumPy's functions of these names
DIFFERENT = words("sort partition resize compress conj conjugate")


def method(name: str) -> Callable | None:
    """Return the method of a name: NumPy's function if arrays have a method of its name.

    NumPy looks for ufuncs by name on the elements of arrays of objects.
    """
    if name in METHODS or name in DIFFERENT:
        return METHODS.get(name)
    function = vars(np).get(name)
    if isinstance(function, np.ufunc) or (
        callable(function) and hasattr(np.ndarray, name)
    ):
        return function
    return None


HOOKS.update(function=apply_function, method=method)
