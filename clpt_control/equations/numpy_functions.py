"""What NumPy's functions and methods do with arrays of the record.

What is not here is tried on arrays of objects, element by element, by NumPy's own code.
"""

from collections.abc import Callable
from functools import reduce
from typing import Any

import numpy as np

from .arrays import (
    UFUNCS,
    Array,
    Tape,
    Unread,
    constant,
    elementwise,
    lifted,
    operand,
    packed,
    stacked,
    total,
    where,
)


def called(tape: Tape, ufunc: Any, method: str, inputs: Any, more: dict) -> Any:
    """Write down a ufunc."""
    out = more.pop("out", None)
    condition = more.pop("where", True)
    more.pop("casting", None), more.pop("dtype", None), more.pop("subok", None)
    if method == "reduce":
        found = _reduced(tape, ufunc, inputs[0], **more)
    elif method == "outer":
        a, b = (lifted(tape, one) for one in inputs)
        found = called(tape, ufunc, "__call__", (_spread(a, np.ndim(b)), b), {})
    elif method != "__call__" or more:
        raise Unread(f"np.{ufunc.__name__}.{method} of signals")
    elif ufunc is np.matmul:
        found = matmul(*(lifted(tape, one) for one in inputs))
    elif ufunc in COMPOSED:
        found = COMPOSED[ufunc](*(lifted(tape, one) for one in inputs))
    elif ufunc in UFUNCS:
        found = elementwise(UFUNCS[ufunc], *(lifted(tape, one) for one in inputs))
    else:
        raise Unread(f"np.{ufunc.__name__} of a signal")
    if condition is not True:
        held = out[0] if out is not None else 0.0
        found = where(lifted(tape, condition), found, lifted(tape, held))
    if out is None:
        return found
    if not isinstance(out[0], Array):
        raise Unread("writing signals into an array of numbers")
    out[0][...] = found
    return out[0]


def _spread(a: Any, more: int) -> Any:
    return a[(..., *[None] * more)] if isinstance(a, Array) and more else a


def _reduced(
    tape: Tape, ufunc: Any, a: Any, axis: Any = 0, keepdims: Any = False, initial: Any = None
) -> Any:
    a = lifted(tape, a)
    if ufunc is np.add:
        return summed(a, axis, keepdims)
    return folded(lambda v, w: called(tape, ufunc, "__call__", (v, w), {}), a, axis, keepdims)


def folded(join: Callable[[Any, Any], Any], a: Array, axis: Any, keepdims: Any = False) -> Any:
    """Join the elements along an axis, or all, one after the other."""
    if axis is None:
        return reduce(join, a.elements().ravel())
    axis %= a.ndim
    parts = [a[(*[slice(None)] * axis, k)] for k in range(a.counted()[axis])]
    if not parts:
        raise ValueError("zero-size array to reduction operation")
    found = reduce(join, parts)
    return found[(*[slice(None)] * axis, None)] if keepdims and isinstance(found, Array) else found


def summed(a: Any, axis: Any = None, keepdims: Any = False, **more: Any) -> Any:
    """Return the sum over all axes, one or some."""
    axes = range(a.ndim) if axis is None else [axis] if isinstance(axis, int) else axis
    for d in sorted((d % a.ndim for d in axes), reverse=True):
        a = total(a, d)
        if keepdims and isinstance(a, Array):
            a = a[(*[slice(None)] * d, None)]
    return a


def matmul(a: Any, b: Any) -> Any:
    """Return a @ b."""
    if not np.ndim(a) or not np.ndim(b):
        raise ValueError("matmul: an operand is a scalar")
    if a.ndim == 1 and b.ndim == 1:
        return total(_times(a, b), 0)
    if b.ndim == 1:
        return total(_times(a, b), a.ndim - 1)
    if a.ndim == 1:
        return total(_times(a[:, None], b), 0) if b.ndim == 2 else _none("matmul of more axes")
    if a.ndim > 2 or b.ndim > 2:
        _none("matmul of more than two axes")
    return total(_times(a[:, :, None], b[None, :, :]), 1)


def _none(what: str) -> Any:
    raise Unread(f"{what} of signals")


def _times(a: Any, b: Any) -> Any:
    return elementwise("mul", a, b)


def dot(a: Any, b: Any) -> Any:
    """Return np.dot(a, b)."""
    return matmul(a, b) if np.ndim(a) and np.ndim(b) else elementwise("mul", a, b)


def norm(a: Any, ord: Any = None, axis: Any = None, keepdims: Any = False) -> Any:
    """Return a norm of a vector, or of rows or columns."""
    if ord == np.inf:
        return maximum_of(elementwise("fabs", a), axis)
    if ord == 1 and (a.ndim == 1 or axis is not None):
        return summed(elementwise("fabs", a), axis, keepdims)
    if ord not in (None, 2, "fro") or (ord == 2 and axis is None and a.ndim > 1):
        _none(f"norm of order {ord}")
    return root(summed(elementwise("mul", a, a), axis, keepdims))


def root(a: Any) -> Any:
    """Return the square root."""
    return elementwise("sqrt", a) if isinstance(a, Array) else np.sqrt(a)


def clip(a: Any, low: Any = None, high: Any = None, out: Any = None, **more: Any) -> Any:
    """Return a within limits."""
    low, high = more.get("min", low), more.get("max", high)
    tape = next(v.tape for v in (a, low, high) if isinstance(v, Array))
    a, low, high = (None if v is None else lifted(tape, v) for v in (a, low, high))
    if low is not None:
        a = np.maximum(a, low)
    return np.minimum(a, high) if high is not None else a


def trace(a: Any, **more: Any) -> Any:
    """Return the sum of the diagonal."""
    return total(diagonal(a), 0)


def diagonal(a: Array) -> Any:
    """Return the diagonal of a matrix."""
    from .arrays import tape_viewed

    n = a.shape[0]
    if a.shape[0] != a.shape[1] or a._written() is not None:
        own = a.elements()
        return packed(a.tape, own.diagonal())
    return tape_viewed(a.tape, a.ref, ((0, 0, 1), (0, 0, 1)), (n,))


def diag(a: Array) -> Any:
    """Return the diagonal of a matrix, or the matrix of a diagonal."""
    if a.ndim == 2:
        return diagonal(a)
    made = np.zeros((len(a), len(a)), dtype=object)
    for k in range(len(a)):
        made[k, k] = a[k]
    return packed(a.tape, made)


def maximum_of(a: Any, axis: Any = None, keepdims: Any = False, **more: Any) -> Any:
    """Return the largest element."""
    return folded(lambda v, w: np.maximum(v, w), a, axis, keepdims)


def minimum_of(a: Any, axis: Any = None, keepdims: Any = False, **more: Any) -> Any:
    """Return the smallest element."""
    return folded(lambda v, w: np.minimum(v, w), a, axis, keepdims)


def product_of(a: Any, axis: Any = None, keepdims: Any = False, **more: Any) -> Any:
    """Return the product of the elements."""
    return folded(lambda v, w: v * w, a, axis, keepdims)


def mean(a: Any, axis: Any = None, **more: Any) -> Any:
    """Return the mean."""
    count = a.size if axis is None else a.counted()[axis]
    return summed(a, axis) / count


def join(parts: Any, axis: Any = 0, **more: Any) -> Any:
    """Return np.concatenate(parts)."""
    tape = next(p.tape for p in parts if isinstance(p, Array))
    own = [lifted(tape, p) for p in parts]
    if axis == 0 and all(isinstance(n, int) for p in own for n in p.shape) and any(
        p.shape[0] > 64 for p in own
    ):
        shape = (sum(p.shape[0] for p in own), *own[0].shape[1:])
        return tape.add("join", [operand(p) for p in own], shape)
    return packed(tape, np.concatenate([objects(p) for p in own], axis=axis))


def objects(value: Any) -> np.ndarray:
    """Return an array of objects."""
    if isinstance(value, Array):
        found = value.elements()
        return found if value.shape else np.asarray(found, dtype=object)
    return np.asarray(value, dtype=object)


def pick(array: Array, index: tuple) -> Any:
    """Return elements at places that are signals."""
    (k, *rest) = index
    if rest or array.ndim != 1 or not isinstance(k, Array):
        return array[tuple(int(i) if isinstance(i, Array) else i for i in index)]
    if k.is_condition:
        _none("a choice of elements by a condition")
    return array[int(k)] if not k.shape else array[[int(i) for i in k]]


def reshaped(a: Array, *shape: Any, **more: Any) -> Any:
    """Return the same elements in another shape."""
    new = shape[0] if len(shape) == 1 else shape
    new = (new,) if isinstance(new, int) else tuple(new)
    if a.ndim == 1 and new == (-1,):
        return a
    if not a.shape and all(n in (1, -1) for n in new):
        return a[(None,) * len(new)] if new else a
    return packed(a.tape, objects(a).reshape(new))


def rounded(a: Array, digits: Any = None, **more: Any) -> Any:
    """Return numbers rounded to even."""
    if digits:
        _none("rounding to digits")
    low = np.floor(a)
    rest, odd = a - low, np.remainder(low, 2.0)
    return where((rest > 0.5) | ((rest == 0.5) & (odd > 0.5)), low + 1.0, low)


def itself(a: Any, *arguments: Any, **more: Any) -> Any:
    """Return the array as it is."""
    return a


def copied(a: Any, *arguments: Any, **more: Any) -> Any:
    """Return a copy, which no longer shares what is written."""
    ref = a.ref
    return Array(a.tape, ref, a.shape) if type(ref) is int else ref


def filled(value: float) -> Callable:
    """Return what makes an array like another, of one number."""
    return lambda a, *more, **named: constant_like(a, value)


def constant_like(a: Array, value: float) -> Any:
    """Return an array of one number, of a's shape."""
    if all(isinstance(n, int) for n in a.shape):
        return constant(a.tape, np.full(a.shape, value))
    return a.tape.add("add", (a.tape.add("mul", (a.ref, 0.0), a.shape).ref, value), a.shape)


def exploded(tape: Tape, function: Any, inputs: Any, more: dict) -> Any:
    """Run NumPy's own function on arrays of objects."""

    def opened(value: Any) -> Any:
        if isinstance(value, Array):
            return objects(value)
        if isinstance(value, list | tuple):
            return type(value)(opened(one) for one in value)
        return value

    try:
        found = function(*opened(tuple(inputs)), **{k: opened(v) for k, v in more.items()})
    except (Unread, IndexError, ValueError):
        raise
    except Exception as error:
        raise Unread(f"np.{function.__name__} of signals ({error})") from None
    if isinstance(found, tuple | list):
        return type(found)(packed(tape, np.asarray(one, dtype=object)) for one in found)
    return packed(tape, np.asarray(found, dtype=object))


def applied(tape: Tape, function: Any, inputs: Any, more: dict) -> Any:
    """Write down one of NumPy's functions."""
    if function not in FUNCTIONS:
        return exploded(tape, function, inputs, more)
    return FUNCTIONS[function](*inputs, **more)


def _of_arrays(function: Callable, count: int) -> Callable:
    """Return a function whose first arguments are made arrays of the record."""

    def made(*inputs: Any, **more: Any) -> Any:
        given = [v for v in inputs if v is not None]
        tape = _tape_of(given)
        own = [lifted(tape, v) for v in inputs[:count]]
        return function(*own, *inputs[count:], **more)

    return made


def _tape_of(values: Any) -> Any:
    for value in values:
        if isinstance(value, Array):
            return value.tape
        if isinstance(value, list | tuple | np.ndarray) and (found := _tape_of(value)):
            return found
    return None


def stack(parts: Any, axis: int = 0, **more: Any) -> Any:
    """Return np.stack(parts)."""
    tape = _tape_of(parts)
    if axis == 0:
        return stacked(tape, [lifted(tape, p) for p in parts])
    return exploded(tape, np.stack, (parts, axis), {})


def outer(a: Any, b: Any) -> Any:
    """Return a b^T."""
    a, b = (v if getattr(v, "ndim", 0) == 1 else packed(_tape_of((a, b)), objects(v).ravel()) for v in (a, b))
    return elementwise("mul", a[:, None], b[None, :])


def power(a: Any, b: Any) -> Any:
    """Return a**b; of a small whole power a product, as NumPy makes a square."""
    return elementwise("mul", a, a) if type(b) is float and b == 2.0 else elementwise("pow", a, b)


COMPOSED: dict[Any, Callable] = {
    np.power: power,
    np.square: lambda a: elementwise("mul", a, a),
    np.reciprocal: lambda a: elementwise("div", 1.0, a),
    np.positive: itself,
    np.fmin: lambda a, b: elementwise("minimum", a, b),
    np.fmax: lambda a, b: elementwise("maximum", a, b),
    np.deg2rad: lambda a: elementwise("mul", a, np.pi / 180),
    np.radians: lambda a: elementwise("mul", a, np.pi / 180),
    np.rad2deg: lambda a: elementwise("mul", a, 180 / np.pi),
    np.degrees: lambda a: elementwise("mul", a, 180 / np.pi),
    np.exp2: lambda a: elementwise("pow", 2.0, a),
    np.cbrt: lambda a: np.sign(a) * np.fabs(a) ** (1 / 3),
    np.rint: rounded,
    np.isnan: lambda a: elementwise("ne", a, a),
    np.isfinite: lambda a: elementwise("lt", elementwise("fabs", a), np.inf),
    np.isinf: lambda a: elementwise("eq", elementwise("fabs", a), np.inf),
    np.heaviside: lambda a, b: where(a == 0, b, where(a > 0, 1.0, 0.0)),
    np.copysign: lambda a, b: where((b < 0) | (elementwise("div", 1.0, b) < 0), -np.fabs(a), np.fabs(a)),
    np.logical_xor: lambda a, b: elementwise("ne", a, b),
}
FUNCTIONS: dict[Any, Callable] = {
    np.sum: _of_arrays(summed, 1),
    np.dot: _of_arrays(dot, 2),
    np.vdot: _of_arrays(dot, 2),
    np.outer: _of_arrays(outer, 2),
    np.where: lambda c, *ab: where(c, *(lifted(_tape_of((c, *ab)), v) for v in ab)),
    np.linalg.norm: _of_arrays(norm, 1),
    np.clip: clip,
    np.trace: trace,
    np.diag: diag,
    np.diagonal: diagonal,
    np.stack: stack,
    np.concatenate: join,
    np.max: _of_arrays(maximum_of, 1),
    np.min: _of_arrays(minimum_of, 1),
    np.prod: _of_arrays(product_of, 1),
    np.mean: _of_arrays(mean, 1),
    np.any: lambda a, axis=None, **more: folded(lambda v, w: elementwise("or", v, w), a, axis),
    np.all: lambda a, axis=None, **more: folded(lambda v, w: elementwise("and", v, w), a, axis),
    np.reshape: _of_arrays(reshaped, 1),
    np.ravel: lambda a, **more: reshaped(a, -1),
    np.transpose: lambda a, axes=None: a.T if axes is None else exploded(a.tape, np.transpose, (a, axes), {}),
    np.round: _of_arrays(rounded, 1),
    np.copy: copied,
    np.zeros_like: filled(0.0),
    np.ones_like: filled(1.0),
    np.shape: lambda a: a.counted(),
    np.ndim: lambda a: a.ndim,
    np.size: lambda a: a.size,
    np.atleast_1d: lambda a: a if a.shape else a[None],
    np.real: itself,
    np.iscomplexobj: lambda a: False,
}
METHODS: dict[str, Callable] = {
    "sum": summed,
    "dot": lambda a, b: np.dot(a, b),
    "clip": clip,
    "trace": trace,
    "max": maximum_of,
    "min": minimum_of,
    "prod": product_of,
    "mean": mean,
    "any": lambda a, **more: np.any(a, **more),
    "all": lambda a, **more: np.all(a, **more),
    "reshape": reshaped,
    "ravel": lambda a, *more: reshaped(a, -1),
    "flatten": lambda a, *more: copied(reshaped(a, -1)),
    "copy": copied,
    "astype": lambda a, *more, **named: copied(as_float(a)),
    "item": lambda a, *at: a[at] if at else (objects(a).ravel()[0] if a.shape else a),
    "tolist": lambda a: objects(a).tolist(),
    "squeeze": lambda a, *more: packed(a.tape, objects(a).squeeze()),
    "transpose": lambda a, *more: a.T if not more else np.transpose(a, *more),
    "round": rounded,
    "cumsum": lambda a, *more, **named: exploded(a.tape, np.cumsum, (a, *more), named),
    "fill": lambda a, value: a.__setitem__(..., value),
    "diagonal": diagonal,
}


def as_float(a: Any) -> Any:
    """Return truth values as numbers."""
    from .arrays import as_number

    return as_number(a)


