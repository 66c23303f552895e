"""Arrays of the record in other shapes: stacked, joined, reshaped, copied."""

from typing import Any

import numpy as np

from .arrays import Array, as_number, lifted, objects, operand, stacked
from .opened import tape_of, unread
from .views import turned

LONG = 64  # an array that is joined to others as it is


def stack(parts: Any, axis: int = 0, **more: Any) -> Any:
    """Return np.stack(parts)."""
    tape = tape_of(parts)
    made = stacked(tape, [lifted(tape, p) for p in parts])
    return np.moveaxis(made, 0, axis) if axis else made


def join(parts: Any, axis: Any = 0, **more: Any) -> Any:
    """Return np.concatenate(parts)."""
    tape = tape_of(parts)
    own = [p for p in (lifted(tape, p) for p in parts) if p.shape != (0,)]
    known = all(isinstance(n, int) for p in own for n in p.shape)
    if axis == 0 and known and any(p.shape[0] > LONG for p in own):
        shape = (sum(p.shape[0] for p in own), *own[0].shape[1:])
        return tape.add("join", [operand(p) for p in own], shape)
    return lifted(tape, np.concatenate([objects(p) for p in own], axis=axis))


def reshaped(a: Array, *shape: Any, **more: Any) -> Any:
    """Return the same elements in another shape."""
    new = more.get("shape", shape[0] if len(shape) == 1 else shape)
    new = tuple(new) if isinstance(new, tuple | list) else (new,)
    if a.ndim < 2 and tuple(n for n in new if n != 1) in ((-1,), a.shape):  # new axes alone
        return a[tuple(slice(None) if n != 1 and a.ndim else None for n in new)]
    return a._part(
        lambda store: store.reshape(new), lambda: lifted(a._tape, objects(a).reshape(new))
    )


def squeezed(a: Array, axis: Any = None) -> Any:
    """Return a without axes of length 1."""
    axes = range(a.ndim) if axis is None else [axis] if isinstance(axis, int) else axis
    dropped = {d % a.ndim for d in axes if a.shape[d] == 1}
    return a[tuple(0 if d in dropped else slice(None) for d in range(a.ndim))] if dropped else a


def transposed(a: Array, *axes: Any, **named: Any) -> Any:
    """Return a with its axes in another order."""
    given = named.get("axes", axes[0] if len(axes) == 1 else axes)
    return turned(a, [d % a.ndim for d in given] if given else list(range(a.ndim))[::-1])


def swapped(a: Array, first: int, second: int) -> Any:
    """Return a with two axes in each other's place."""
    order = list(range(a.ndim))
    order[first], order[second] = order[second], order[first]
    return turned(a, order)


def expanded(a: Array, axis: Any) -> Any:
    """Return a with new axes."""
    axes = axis if isinstance(axis, tuple) else (axis,)
    n = a.ndim + len(axes)
    new = {d % n for d in axes}
    return a[tuple(None if d in new else slice(None) for d in range(n))]


def at_least(axes: int, *given: Any) -> Any:
    """Return np.atleast_1d or np.atleast_2d."""
    own = [lifted(tape_of(given), one) for one in given]
    made = [(np.asarray(a) if type(a) is float else a)[(None,) * (axes - np.ndim(a))] for a in own]
    return made[0] if len(made) == 1 else tuple(made)


def copied(a: Any, *arguments: Any, **more: Any) -> Any:
    """Return a copy, which no longer shares what is written."""
    if not a.shape:
        return a
    ref = a._ref
    return Array(a._tape, ref, a.shape) if type(ref) is int else ref


def converted(a: Any, dtype: Any = float, *more: Any, **named: Any) -> Any:
    """Return a copy of numbers of another kind."""
    kind = np.dtype(dtype).kind
    if kind in "iu":
        return np.trunc(as_number(a))
    if kind == "b":
        return a if a._is_condition else a != 0
    return unread(f"numbers of {np.dtype(dtype)}") if kind == "c" else copied(as_number(a))
