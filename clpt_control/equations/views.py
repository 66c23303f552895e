"""Views of values, and values in other shapes: what an index makes of an array, joined, reshaped.

A view says for each axis of what it views an index, or (axis of the view, start, step).  A view
of a view, of a stack or of numbers is made at once.

At times they are NumPy's own: as numbers where they depend on nothing, else as objects.
"""

from collections.abc import Callable, Sequence
from itertools import pairwise
from operator import itemgetter
from typing import Any

import numpy as np

from .arrays import (
    HOOKS,
    TRUTH,
    Array,
    Masked,
    Tape,
    Unread,
    as_number,
    constant,
    lifted,
    numbers_of,
    objects,
    operand,
    stacked,
    whole,
)
from .record import Ref, Shape, viewed

# --- as NumPy's own ----------------------------------------------------------------------------


MOST_NUMBERS = 20_000  # of an array that is written down


def depends(value: Any) -> bool:
    """Return whether arguments hold a signal or a parameter."""
    if isinstance(value, Array):
        return numbers_of(value) is None
    if isinstance(value, list | tuple):
        return any(map(depends, value))
    return isinstance(value, np.ndarray) and value.dtype == object


def arrays_as(value: Any, to: Callable[[Array], Any]) -> Any:
    """Return arguments with `to` of each array of the record, in lists, tuples and dicts too."""
    if isinstance(value, Array):
        return to(value)
    if isinstance(value, dict):
        return {name: arrays_as(item, to) for name, item in value.items()}
    return type(value)(arrays_as(v, to) for v in value) if type(value) in (list, tuple) else value


def of_numbers(tape: Tape, function: Callable, inputs: Any, more: dict) -> Any:
    """Run NumPy's own function on arguments that depend on nothing."""
    return fresh(tape, function(*arrays_as(inputs, numbers_of), **arrays_as(more, numbers_of)))


def fresh(tape: Tape, value: Any) -> Any:
    """Return NumPy's new array of doubles as one that signals may be written into."""
    if type(value) is np.ndarray and value.dtype == float and value.ndim:
        return constant(tape, value) if value.size < MOST_NUMBERS else value
    return value


def refuse(what: str) -> Any:
    """Refuse what cannot be read."""
    raise Unread(f"{what} of signals")


def repacked(tape: Tape, value: Any) -> Any:
    """Return what NumPy made of arrays of objects."""
    if isinstance(value, tuple | list):
        return type(value)(repacked(tape, one) for one in value)
    if isinstance(value, np.ndarray) and value.dtype == object:
        return lifted(tape, value)
    return fresh(tape, value)


def on_objects(tape: Tape, function: Any, inputs: Any, more: dict) -> Any:
    """Run NumPy's own function on arrays of objects."""
    arguments = arrays_as(inputs, objects)
    try:
        result = function(*arguments, **arrays_as(more, objects))
    except (Unread, IndexError, ValueError):
        raise
    except Exception as error:
        raise Unread(f"np.{function.__name__} of signals ({error})") from None
    if result is None and inputs:  # NumPy wrote into its first argument
        inputs[0][...] = arguments[0]
    return repacked(tape, result)


def into(out: Any, value: Any) -> Any:
    """Return a value, or the array `out` into which it is written."""
    if out is None or (isinstance(out, Array) and not out.shape):  # a number is replaced
        return value
    if not isinstance(out, Array):
        raise Unread("writes signals into an array made elsewhere; make it where it is filled")
    out[...] = value
    return out


def tape_of(values: Any) -> Any:
    """Return the tape of the first array of the record among values, or None."""
    for value in values:
        if isinstance(value, Array):
            return value._tape
        if isinstance(value, list | tuple) or (
            isinstance(value, np.ndarray) and value.dtype == object and value.ndim
        ):
            tape = tape_of(value)
            if tape is not None:
                return tape
    return None


# --- views -------------------------------------------------------------------------------------


LONG = 64  # an array that is joined to others as it is


def tape_view(tape: Tape, refs: Sequence[Ref]) -> Any:
    """Return the array whose elements follow each other in this stack, or None."""
    lines = [tape.operations[ref] for ref in refs if type(ref) is int]
    views = [line for line in lines if line.kind == "view"]
    if len(views) < max(2, len(refs)) or len({line.arguments for line in views}) > 1:
        return None
    maps = [line.at for line in views]
    varying = [d for d in range(len(maps[0])) if len({m[d] for m in maps}) > 1]
    places = [m[d] for m in maps for d in varying]
    if len(varying) != 1 or not all(isinstance(p, int) for p in places):
        return None
    step = places[1] - places[0]
    if step < 1 or any(b - a != step for a, b in pairwise(places)):
        return None
    mapped = tuple(
        (0, places[0], step) if k in varying else p if isinstance(p, int) else (p[0] + 1, *p[1:])
        for k, p in enumerate(maps[0])
    )
    return tape_viewed(tape, views[0].arguments[0], mapped, (len(refs), *views[0].shape))


def item(array: Array, index: tuple) -> Any:
    """Return array[index]."""
    if any(isinstance(i, Array) for i in index):
        return _picked(array, *index)
    if any(isinstance(i, list | tuple | np.ndarray) and np.ndim(i) for i in index):
        return lifted(array._tape, array._elements()[index])
    return array._part(
        itemgetter(index),
        lambda: tape_viewed(array._tape, array._node, *_mapped(index, array.shape)),
    )


def _mapped(index: tuple, shape: Shape) -> tuple[tuple, Shape]:
    """Return what a basic index makes of each axis, and the shape of the view."""
    named = sum(i is not None and i is not Ellipsis for i in index)
    if named > len(shape):
        raise IndexError("too many indices for array")
    at = index.index(Ellipsis) if Ellipsis in index else len(index)
    mapped: list[Any] = []
    new_shape: list[Any] = []
    for i in (*index[:at], *[slice(None)] * (len(shape) - named), *index[at + 1 :]):
        if i is None:
            new_shape.append(1)
            continue
        n = shape[len(mapped)]
        if i == slice(None):
            mapped.append((len(new_shape), 0, 1))
            new_shape.append(n)
        elif not isinstance(n, int):
            raise Unread(f"a part of the open size {n}")
        elif isinstance(i, slice):
            places = range(*i.indices(n))
            mapped.append((len(new_shape), places.start, places.step))
            new_shape.append(len(places))
        else:
            k = i.__index__()
            if not -n <= k < n:
                raise IndexError(f"index {k} is out of bounds for axis with size {n}")
            mapped.append(k % n)
    return tuple(mapped), tuple(new_shape)


def _picked(array: Array, k: Any, *rest: Any) -> Any:
    """Return elements at places that are signals."""
    if isinstance(k, Array) and k._is_condition:
        if not k._tape.free[k._node]:
            return array[(k._tape.numbers(k._ref) != 0.0, *rest)]
        same = not rest and k.shape == array.shape
        return Masked(array, k) if same else refuse("taking elements by a condition")
    if not rest and array.ndim == 1 and isinstance(array.shape[0], int) and not k.shape:
        counts = k._tape.operations[k._node].kind in ("trunc", "floor", "ceil", "pick")
        if counts and k._tape.free[k._node] and array._written() is None:
            return array._tape.add("pick", (operand(array), k._ref), ())
    return array[whole((k, *rest))]


def permuted(a: Array, order: Sequence[int]) -> Any:
    """Return a with its axes in another order."""
    mapped = tuple((order.index(d), 0, 1) for d in range(a.ndim))
    shape = tuple(a.shape[d] for d in order)
    return a._part(
        lambda store: store.transpose(order), lambda: tape_viewed(a._tape, a._node, mapped, shape)
    )


def tape_viewed(tape: Tape, node: int, mapped: tuple, shape: Shape) -> Any:
    """Return a view; a view of a view, of a stack or of numbers is made at once."""
    kind, arguments, old, at = tape.operations[node]
    if mapped == tuple((d, 0, 1) for d in range(len(old))) and shape == old:
        return Array(tape, node, old)
    if kind == "constant":
        return constant(tape, viewed(np.frombuffer(at).reshape(old), mapped, shape))
    if kind == "view":
        inner = list(at)
        for d, m in enumerate(inner):
            if not isinstance(m, int):
                outer = mapped[m[0]]
                if isinstance(outer, int):
                    inner[d] = m[1] + m[2] * outer
                else:
                    inner[d] = (outer[0], m[1] + m[2] * outer[1], m[2] * outer[2])
        return tape_viewed(tape, arguments[0], tuple(inner), shape)
    if kind == "fill":
        (number,) = arguments
        if shape:
            return tape.add("fill", (number,), shape)
        return number if type(number) is float else Array(tape, number, ())
    if kind == "join":
        part = _of_join(tape, arguments, mapped, shape)
        if part is not None:
            return part
    if kind == "stack" and isinstance(mapped[0], int):
        item = arguments[mapped[0]]
        if type(item) is float:
            return constant(tape, np.full(shape, item))  # a number, or one with new axes
        return tape_viewed(tape, item, mapped[1:], shape)
    return tape.add("view", (node,), shape, mapped)


def _of_join(tape: Tape, parts: Sequence[Ref], mapped: tuple, shape: Shape) -> Any:
    """Return a view of joined arrays that lies within one of them; None where it does not."""
    first, *rest = mapped
    count = 1 if isinstance(first, int) else shape[first[0]]
    start, step = (first, 1) if isinstance(first, int) else first[1:]
    last, at = start + step * (count - 1), 0
    for part in parts:
        n = tape.operations[part].shape[0]
        if count and at <= min(start, last) and max(start, last) < at + n:
            moved = start - at if isinstance(first, int) else (first[0], start - at, step)
            return tape_viewed(tape, part, (moved, *rest), shape)
        at += n
    return None


# --- other shapes ------------------------------------------------------------


def stack(parts: Any, axis: int = 0, **more: Any) -> Any:
    """Return np.stack(parts)."""
    tape = tape_of(parts)
    new = stacked(tape, [lifted(tape, p) for p in parts])
    return np.moveaxis(new, 0, axis) if axis else new


def join(parts: Any, axis: Any = 0, **more: Any) -> Any:
    """Return np.concatenate(parts)."""
    tape = tape_of(parts)
    arrays = [p for p in (lifted(tape, p) for p in parts) if p.shape != (0,)]
    known = all(isinstance(n, int) for p in arrays for n in p.shape)
    if axis == 0 and known and any(p.shape[0] > LONG for p in arrays):
        shape = (sum(p.shape[0] for p in arrays), *arrays[0].shape[1:])
        return tape.add("join", [operand(p) for p in arrays], shape)
    return lifted(tape, np.concatenate([objects(p) for p in arrays], axis=axis))


def reshaped(a: Array, *shape: Any, **more: Any) -> Any:
    """Return the same elements in another shape."""
    if more.get("order", "C") != "C":
        return refuse("elements in another order than row by row")
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
    order = named.get("axes", axes[0] if len(axes) == 1 else axes)
    return permuted(a, [d % a.ndim for d in order] if order else list(range(a.ndim))[::-1])


def swapped(a: Array, first: int, second: int) -> Any:
    """Return a with two axes in each other's place."""
    order = list(range(a.ndim))
    order[first], order[second] = order[second], order[first]
    return permuted(a, order)


def expanded(a: Array, axis: Any) -> Any:
    """Return a with new axes."""
    axes = axis if isinstance(axis, tuple) else (axis,)
    n = a.ndim + len(axes)
    new = {d % n for d in axes}
    return a[tuple(None if d in new else slice(None) for d in range(n))]


def at_least(axes: int, *values: Any) -> Any:
    """Return np.atleast_1d or np.atleast_2d."""
    arrays = [lifted(tape_of(values), one) for one in values]
    result = [
        (np.asarray(a) if type(a) is float else a)[(None,) * (axes - np.ndim(a))] for a in arrays
    ]
    return result[0] if len(result) == 1 else tuple(result)


def copied(a: Any, *arguments: Any, **more: Any) -> Any:
    """Return a copy, which no longer shares what is written."""
    if not a.shape:
        return a
    ref = a._ref
    if type(ref) is float:
        return ref
    copy = Array(a._tape, ref, a.shape)
    copy._whole = a._whole
    return copy


def converted(a: Any, dtype: Any = float, *more: Any, **named: Any) -> Any:
    """Return a copy of numbers of another kind."""
    kind = np.dtype(dtype)
    if kind == np.int64:
        numbers = np.trunc(as_number(a))
        if isinstance(numbers, Array):
            numbers._whole = True
        return numbers
    if kind == TRUTH:
        return a if a._is_condition else a != 0
    return copied(as_number(a)) if kind == np.float64 else refuse(f"numbers of {kind}")


HOOKS.update(item=item, tape_view=tape_view)
