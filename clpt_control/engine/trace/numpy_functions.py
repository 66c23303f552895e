"""What NumPy's functions and methods do with arrays of the record.

What is not here is tried on arrays of objects, element by element, by NumPy's own code.
"""

from collections.abc import Callable
from typing import Any

import numpy as np

from . import interpolators as lookup_tables
from . import views
from .arrays import HOOKS, Array, Tape, Unread, objects
from .elementwise import as_number, boxed, filled, is_truth, is_whole, lifted, of_python, where
from .linear_algebra import determinant, dot, norm, outer, solve
from .ufuncs import LONG_ROW, accumulated, check_doubles, place_of_the_least, reduced, rounded
from .views import depends, into, on_numbers, on_objects, on_parameters, refuse, tape_of

IMPLEMENTED: dict[Any, Callable] = {}  # NumPy's: what writes them down
BOXED = {  # whose results are arrays, also without axes
    *(np.where, np.select, np.piecewise, np.copy),
    *(np.zeros_like, np.ones_like, np.empty_like, np.full_like),
}


def apply_function(tape: Tape, function: Any, inputs: Any, options: dict) -> Any:
    """Write down one of NumPy's functions."""
    out = options.pop("out", None)
    result = None
    if function not in SHARES and not depends((*inputs, *options.values())):
        result = on_numbers(tape, function, inputs, options)
    elif function in IMPLEMENTED:
        result = IMPLEMENTED[function](*inputs, **options)
        return into(out, boxed(tape, result) if function in BOXED else result)
    if result is None:
        try:
            result = on_objects(tape, function, inputs, options)
        except Unread as why:
            result = on_parameters(tape, function, inputs, options, why)
    return into(out, result)


def implements(*functions: Any, arrays: int = 1) -> Callable:
    """Register what does NumPy's functions; its first arguments are made arrays of the record."""

    def register(record: Callable) -> Callable:
        def function(*inputs: Any, **options: Any) -> Any:
            tape = tape_of((*inputs, *options.values()))
            return record(*(lifted(tape, v) for v in inputs[:arrays]), *inputs[arrays:], **options)

        IMPLEMENTED.update(dict.fromkeys(functions, function if arrays else record))
        return record

    return register


# --- means and slopes -------------------------------------------------------------


@implements(np.mean)
def mean(a: Any, axis: Any = None, dtype: Any = None, keepdims: Any = False) -> Any:
    """Return the mean."""
    check_doubles(dtype)
    total = np.sum(a, axis, keepdims=keepdims)
    return total / (a.size // total.size)


@implements(np.var)
def variance(a: Any, axis: Any = None, dtype: Any = None, ddof: Any = 0, keepdims: Any = 0) -> Any:
    """Return the mean square of what differs from the mean."""
    check_doubles(dtype)
    deviation = a - mean(a, axis, keepdims=axis is not None)
    total = np.sum(deviation * deviation, axis, keepdims=keepdims)
    return total / (a.size // total.size - ddof)


@implements(np.diff)
def differences(a: Any, n: Any = 1, axis: int = -1, **options: Any) -> Any:
    """Return np.diff(a, n)."""
    if options or is_truth(a) or not a.ndim or n < 1:
        return on_objects(a._tape, np.diff, (a, n, axis), options)
    rows = np.moveaxis(a, axis, 0)
    for _ in range(n):
        rows = rows[1:] - rows[:-1]
    return np.moveaxis(rows, 0, axis)


@implements(np.gradient)
def gradient(f: Any, *steps: Any, axis: Any = None, edge_order: int = 1) -> Any:
    """Return np.gradient along one axis, by one step."""
    direction = 0 if axis is None and f.ndim == 1 else axis
    if (
        not isinstance(direction, int)
        or len(steps) > 1
        or edge_order != 1
        or np.ndim([*steps, 1][0])
    ):
        return refuse("np.gradient along several axes, by places, or of another order")
    f = np.moveaxis(f, direction, 0)
    h = [*steps, 1.0][0]
    slopes = [(f[1:2] - f[:1]) / h, (f[2:] - f[:-2]) / (2.0 * h), (f[-1:] - f[-2:-1]) / h]
    return np.moveaxis(np.concatenate(slopes), 0, direction)


@implements(np.cross, arrays=2)
def cross(a: Any, b: Any, **options: Any) -> Any:
    """Return np.cross; of vectors of 3 along the last axis as NumPy computes it."""
    if options or (a.shape[-1], b.shape[-1]) != (3, 3):
        return on_objects(a._tape, np.cross, (a, b), options)
    (a0, a1, a2), (b0, b1, b2) = np.moveaxis(a, -1, 0), np.moveaxis(b, -1, 0)
    return np.stack([a1 * b2 - a2 * b1, a2 * b0 - a0 * b2, a0 * b1 - a1 * b0], -1)


# --- limits and choices -----------------------------------------------------------------------


@implements(np.clip)
def clip(a: Any, a_min: Any = None, a_max: Any = None, *, min: Any = None, max: Any = None) -> Any:
    """Return a within limits."""
    low = a_min if min is None else min
    high = a_max if max is None else max
    if low is not None:
        a = np.maximum(a, low)
    return np.minimum(a, high) if high is not None else a


def place_of_the_first(function: Any, better: Any) -> Callable:
    """Return what does np.argmax or np.argmin: of a short row one comparison an element."""

    def place(a: Any, *axis: Any, **options: Any) -> Any:
        if axis or options:
            return on_objects(a._tape, function, (a, *axis), options)
        if a.size > LONG_ROW:
            return place_of_the_least(as_number(np.ravel(a if better is np.less else -a)))
        best, *candidates = as_number(np.ravel(a))
        index: Any = 0
        for k, candidate in enumerate(candidates, 1):
            closer = better(candidate, best)
            best = where(closer, candidate, best)
            index = where(closer, k, index)
        if candidates:
            index._below = 1 + len(candidates)
        return index

    return place


implements(np.argmax)(place_of_the_first(np.argmax, np.greater))
implements(np.argmin)(place_of_the_first(np.argmin, np.less))


@implements(np.sort)
def sort(a: Any, *axis: Any, **options: Any) -> Any:
    """Return a row sorted: neighbours change places, in as many rounds as it has elements."""
    if axis or options or a.ndim != 1:
        return refuse("np.sort along an axis")
    row = list(as_number(a))
    for k in range(len(row)):
        for j in range(k % 2, len(row) - 1, 2):
            row[j : j + 2] = np.minimum(*row[j : j + 2]), np.maximum(*row[j : j + 2])
    return lifted(a._tape, row)


@implements(np.median)
def median(a: Any, *axis: Any, **options: Any) -> Any:
    """Return the mean of the one or two in the middle."""
    if axis or options:
        return refuse("np.median along an axis")
    row = sort(np.ravel(a))
    return np.mean(row[(len(row) - 1) // 2 : len(row) // 2 + 1])


@implements(np.where, arrays=0)
def placed(condition: Any, *values: Any) -> Any:
    """Return np.where(condition, a, b)."""
    if not values:
        return refuse("np.where without values, which counts,")
    tape = tape_of((condition, *values))
    return where(boxed(tape, lifted(tape, condition)), *values)


@implements(np.select, arrays=0)
def selected(conditions: Any, values: Any, default: Any = 0) -> Any:
    """Return np.select: the value of the first condition that holds."""
    result = default
    for condition, value in zip(reversed(conditions), reversed(values), strict=True):
        result = placed(condition, value, result)
    return result


@implements(np.isclose, arrays=2)
def close(a: Any, b: Any, rtol: float = 1e-5, atol: float = 1e-8, equal_nan: bool = False) -> Any:
    """Return whether numbers are about the same, as np.isclose does."""
    is_close = (np.fabs(a - b) <= atol + rtol * np.fabs(b)) & (np.fabs(b) < np.inf) | (a == b)
    return is_close | ((a != a) & (b != b)) if equal_nan else is_close


# --- others ------------------------------------------------------------------------------------


def along(join: Callable, ufunc: Any) -> Callable:
    """Return what joins the elements of an array by a ufunc, all, or those along an axis."""

    def joined(a: Any, axis: Any = None, dtype: Any = None, **options: Any) -> Any:
        if "where" in options:
            return refuse("joining some elements, which np.where chooses,")
        if not is_truth(a) or isinstance(dtype, Array):
            check_doubles(dtype)
        return join(ufunc, a, axis, **options)

    return joined


def alike(a: Array, value: float, dtype: Any = None, **named: Any) -> Any:
    """Return a number everywhere in an array of the shape and kind of another."""
    if is_whole(a) is not False and dtype is None:
        return refuse("an array like one of truth values or whole numbers")
    check_doubles(dtype)
    return filled(a._tape, value, a.shape)


implements(np.dot, arrays=2)(dot)
implements(np.outer, arrays=2)(outer)
implements(np.vdot, arrays=2)(lambda a, b: dot(np.ravel(a), np.ravel(b)))
implements(np.linalg.norm)(norm)
implements(np.linalg.solve, arrays=2)(solve)
implements(np.linalg.det)(determinant)
for unread in (np.shares_memory, np.may_share_memory, np.ix_):
    implements(unread, arrays=0)(lambda *_, name=unread.__name__: refuse(f"np.{name}"))
implements(np.sum)(along(reduced, np.add))
implements(np.prod)(along(reduced, np.multiply))
implements(np.max, np.amax)(along(reduced, np.maximum))
implements(np.min, np.amin)(along(reduced, np.minimum))
implements(np.any)(along(reduced, np.logical_or))
implements(np.all)(along(reduced, np.logical_and))
implements(np.ptp)(lambda a, *more, **named: np.max(a, *more, **named) - np.min(a, *more, **named))
implements(np.std)(lambda a, *more, **named: np.sqrt(np.var(a, *more, **named)))
implements(np.trace)(lambda a, *more, **named: np.sum(np.diagonal(a, *more, **named)))
implements(np.linalg.inv)(lambda A: solve(A, np.eye(A.shape[0])))
implements(np.cumsum)(along(accumulated, np.add))
implements(np.cumprod)(along(accumulated, np.multiply))
implements(np.allclose, arrays=2)(lambda *given, **more: np.all(close(*given, **more)))
implements(np.interp)(lookup_tables.interpolated)
implements(np.searchsorted, arrays=0)(lookup_tables.searched)
implements(np.digitize, arrays=0)(
    lambda x, bins, right=False: np.searchsorted(bins, x, "left" if right else "right")
)
implements(np.take)(
    lambda a, k, axis=None: (
        np.moveaxis(a, axis or 0, 0)[k] if a.ndim == 1 or axis is not None else np.ravel(a)[k]
    )
)
implements(np.count_nonzero)(lambda a: np.sum(a != 0))
implements(np.stack, arrays=0)(views.stack)
implements(np.concatenate, arrays=0)(views.join)
implements(np.round, np.around)(rounded)
implements(np.fix)(np.trunc)
implements(np.copy)(views.copied)
implements(np.zeros_like, np.empty_like)(lambda a, *more, **named: alike(a, 0.0, *more, **named))
implements(np.ones_like)(lambda a, *more, **named: alike(a, 1.0, *more, **named))
implements(np.full_like)(lambda a, value, *more, **named: alike(a, 0.0, *more, **named) + value)
implements(np.shape)(lambda a: a._counted())
implements(np.size)(lambda a, axis=None: a.size if axis is None else a._counted()[axis])

# --- parts, which share what is written -----------------------------------------------------


def sharing(function: Any) -> Callable:
    """Return what does a function of NumPy whose result shares what is written."""

    def shared(a: Any, *arguments: Any, **options: Any) -> Any:
        if {"A", "K"} & {v for v in (*arguments, *options.values()) if isinstance(v, str)}:
            return refuse("elements in the order of memory")
        return views.part(a, lambda positions: function(positions, *arguments, **options))

    return shared


def of_each(function: Any) -> Callable:
    """Return what does such a function for each of its arguments."""

    def record(*values: Any) -> Any:
        """Return what the function makes of the one argument, or a tuple for several."""
        tape = tape_of(values)
        results = [views.part(lifted(tape, value), function) for value in values]
        return results[0] if len(results) == 1 else tuple(results)

    return record


SHARES: dict[Any, Callable] = {
    function: sharing(function)
    for function in (
        *(np.reshape, np.ravel, np.squeeze, np.transpose, np.swapaxes, np.moveaxis),
        *(np.expand_dims, np.flip, np.flipud, np.fliplr, np.diagonal, np.diag, np.broadcast_to),
        *(np.rot90, np.rollaxis, np.atleast_3d),
    )
}
OWN: tuple[Any, ...] = (  # of these NumPy's own code does
    *(np.split, np.array_split, np.hsplit, np.vsplit, np.dsplit),
    *(np.real, np.imag, np.isreal, np.ndim, np.iscomplexobj, np.isrealobj),
)
SHARES.update({function: function._implementation for function in OWN})
SHARES.update({function: of_each(function) for function in (np.atleast_1d, np.atleast_2d)})
for real, made in SHARES.items():
    implements(real)(made)


def as_list(a: Array) -> Any:
    """Return elements in lists, which Python has as its own numbers."""
    elements = objects(a)
    elements_of_python = np.empty(elements.shape, dtype=object)
    for index, element in np.ndenumerate(elements):
        elements_of_python[index] = of_python(element, is_whole(element))
    return elements_of_python.tolist()


def astype(a: Array, *kind: Any, **options: Any) -> Any:
    """Return numbers of another kind."""
    new = views.converted(a, *kind, **options)
    return boxed(a._tape, new) if a._boxed else new


METHODS: dict[str, Callable] = {  # that are not NumPy's functions
    "reshape": sharing(np.ndarray.reshape),
    "transpose": sharing(np.ndarray.transpose),
    "flatten": lambda a, order="C": views.copied(np.ravel(a, order)),
    **dict.fromkeys(("__copy__", "__deepcopy__"), views.copied),
    "astype": astype,
    "item": lambda a, *at: as_list(a[at] if at else objects(a).ravel()[0]),
    "tolist": as_list,
    "fill": lambda a, value: a.__setitem__(..., value),
    "is_integer": lambda a: np.floor(a) == a,
}
# other than NumPy's functions of these names
OTHER = frozenset({"sort", "partition", "resize", "compress", "conj", "conjugate"})


def method(name: str) -> Callable | None:
    """Return the method of a name: NumPy's function, where an array has one of its name.

    NumPy asks elements of arrays of objects for ufuncs.
    """
    if name in METHODS or name in OTHER:
        return METHODS.get(name)
    function = vars(np).get(name)
    if isinstance(function, np.ufunc) or (callable(function) and hasattr(np.ndarray, name)):
        return function
    return None


HOOKS.update(function=apply_function, method=method)
