"""Arrays of the record in other shapes: stacked, joined, reshaped, copied."""

from collections.abc import Callable
from typing import Any

import numpy as np

from .arrays import PARTS, Array, Masked, as_number, constant, lifted, operand, packed, stacked
from .opened import exploded, objects, shared, tape_of, unread


def stack(parts: Any, axis: int = 0, **more: Any) -> Any:
    """Return np.stack(parts)."""
    tape = tape_of(parts)
    if axis == 0:
        return stacked(tape, [lifted(tape, p) for p in parts])
    return exploded(tape, np.stack, (parts, axis), {})


def join(parts: Any, axis: Any = 0, **more: Any) -> Any:
    """Return np.concatenate(parts)."""
    tape = tape_of(parts)
    own = [lifted(tape, p) for p in parts]
    own = [p for p in own if p.shape != (0,)]
    if (
        axis == 0
        and all(isinstance(n, int) for p in own for n in p.shape)
        and any(p.shape[0] > 64 for p in own)
    ):
        shape = (sum(p.shape[0] for p in own), *own[0].shape[1:])
        return tape.add("join", [operand(p) for p in own], shape)
    return packed(tape, np.concatenate([objects(p) for p in own], axis=axis))


def pick(array: Array, index: tuple) -> Any:
    """Return elements at places that are signals."""
    (k, *rest) = index
    if isinstance(k, Array) and k.is_condition:
        if not k.tape.free[k.node]:
            return array[(k.tape.numbers(k.ref) != 0.0, *rest)]
        same = not rest and k.shape == array.shape
        return Masked(array, k) if same else unread("taking elements by a condition")
    if not rest and array.ndim == 1 and isinstance(array.shape[0], int) and not k.shape:
        whole = k.tape.operations[k.node].kind in ("trunc", "floor", "ceil", "pick")
        if whole and k.tape.free[k.node] and array._written() is None:
            return array.tape.add("pick", (operand(array), k.ref), ())
    own = [
        i
        if not isinstance(i, Array)
        else i.__index__()
        if not i.shape
        else [j.__index__() for j in i]
        for i in index
    ]
    return array[tuple(own)]


def reshaped(a: Array, *shape: Any, **more: Any) -> Any:
    """Return the same elements in another shape."""
    new = more.get("shape", shape[0] if len(shape) == 1 else shape)
    new = (new,) if not isinstance(new, tuple | list) else tuple(new)
    if a.ndim == 1 and new == (-1,):
        return a
    if not a.shape and all(n in (1, -1) for n in new):
        return a[(None,) * len(new)] if new else a
    if (
        a.ndim == 1
        and a._written() is None
        and new in ((-1, 1), (1, -1), (*a.shape, 1), (1, *a.shape))
    ):
        return a[:, None] if new[-1] == 1 and new[0] != 1 else a[None, :]
    return shared(a, lambda store: store.reshape(new))


def squeezed(a: Array, axis: Any = None) -> Any:
    """Return a without axes of length 1."""
    axes = range(a.ndim) if axis is None else [axis] if isinstance(axis, int) else axis
    dropped = {d % a.ndim for d in axes if a.shape[d] == 1}
    return a[tuple(0 if d in dropped else slice(None) for d in range(a.ndim))] if dropped else a


def transposed(a: Array, *axes: Any) -> Any:
    """Return a with its axes in another order."""
    order: Any = axes[0] if len(axes) == 1 else axes or None
    return a.T if order is None else exploded(a.tape, np.transpose, (a, order), {})


def at_least(axes: int) -> Callable:
    """Return np.atleast_1d or np.atleast_2d."""
    return lambda *a: (
        a[0][(None,) * max(0, axes - np.ndim(a[0]))]
        if len(a) == 1
        else tuple(map(at_least(axes), a))
    )


def copied(a: Any, *arguments: Any, **more: Any) -> Any:
    """Return a copy, which no longer shares what is written."""
    if not a.shape:
        return a
    ref = a.ref
    return Array(a.tape, ref, a.shape) if type(ref) is int else ref


def converted(a: Any, dtype: Any = float, *more: Any, **named: Any) -> Any:
    """Return a copy of numbers of another kind."""
    kind = np.dtype(dtype).kind
    if kind in "iu":
        return np.trunc(as_number(a))
    if kind == "b":
        return a if a.is_condition else a != 0
    return unread(f"numbers of {np.dtype(dtype)}") if kind == "c" else copied(as_number(a))


def filled(value: float) -> Callable:
    """Return what makes an array like another, of one number."""
    return lambda a, *more, **named: constant_like(a, value)


def constant_like(a: Array, value: float) -> Any:
    """Return an array of one number, of a's shape."""
    if all(isinstance(n, int) for n in a.shape):
        return constant(a.tape, np.full(a.shape, value))
    return a.tape.add("fill", (value,), a.shape)


def full_like(a: Array, value: Any, **more: Any) -> Any:
    """Return an array of a's shape with one value."""
    return constant_like(a, 0.0) + value


PARTS.update(pick=pick)
