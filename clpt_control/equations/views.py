"""Views of values: what an index makes of an array, and elements that follow each other.

A view says for each axis of what it views an index, or (axis of the view, start, step).  A view
of a view, of a stack or of numbers is made at once.
"""

from collections.abc import Sequence
from itertools import pairwise
from typing import Any

import numpy as np

from .arrays import PARTS, Array, Tape, Unread, constant
from .numbers import viewed
from .record import Ref, Shape


def tape_view(tape: Tape, refs: Sequence[Ref]) -> "Array | None":
    """Return the array whose elements follow each other in this stack, or None."""
    own = [tape.operations[ref] if type(ref) is int else None for ref in refs]
    if any(o is None or o.kind != "view" for o in own):
        return None
    maps = [o.at for o in own if o is not None]
    source = {o.arguments[0] for o in own if o is not None}
    if len(source) != 1:
        return None
    turning = [d for d in range(len(maps[0])) if len({m[d] for m in maps}) > 1]
    if len(turning) != 1 or len(refs) < 2:
        return None
    (d,) = turning
    places = [m[d] for m in maps]
    if not all(isinstance(p, int) for p in places):
        return None
    step = places[1] - places[0]
    if step < 1 or any(b - a != step for a, b in pairwise(places)):
        return None
    first = own[0]
    assert first is not None
    shape = (len(refs), *first.shape)
    mapped = tuple(
        (0, places[0], step) if k == d else p if isinstance(p, int) else (p[0] + 1, *p[1:])
        for k, p in enumerate(maps[0])
    )
    return tape_viewed(tape, first.arguments[0], mapped, shape)


def index_map(index: tuple, shape: Shape) -> tuple[tuple, Shape]:
    """Return what a basic index makes of each axis, and the shape of the view."""
    named = sum(i is not None and i is not Ellipsis for i in index)
    if Ellipsis not in index:
        index = (*index, Ellipsis)
    at = index.index(Ellipsis)
    filled = (*index[:at], *[slice(None)] * (len(shape) - named), *index[at + 1 :])
    mapped: list[Any] = []
    found: list[Any] = []
    for i in filled:
        if i is None:
            found.append(1)
            continue
        if len(mapped) == len(shape):
            raise IndexError("too many indices for array")
        n = shape[len(mapped)]
        if isinstance(i, slice):
            if i == slice(None):
                start, step, count = 0, 1, n
            else:
                if not isinstance(n, int):
                    raise Unread(f"a part of the open size {n}")
                places = range(*i.indices(n))
                start, step, count = places.start, places.step, len(places)
            mapped.append((len(found), start, step))
            found.append(count)
        else:
            k = i.__index__()
            if isinstance(n, int) and not -n <= k < n:
                raise IndexError(f"index {k} is out of bounds for axis with size {n}")
            if not isinstance(n, int):
                raise Unread(f"element {k} of the open size {n}")
            mapped.append(k % n)
    return tuple(mapped), tuple(found)


def view(array: Array, mapped: tuple, shape: Shape, index: Any) -> Any:
    """Return a view of an array, which shares what is written into either."""
    if (store := array._written()) is not None:
        part = index(store) if callable(index) else store[index]
        if not isinstance(part, np.ndarray):
            return part
        found = Array(array.tape, -1, shape, array, index)
        found.store = part
        return found
    made = tape_viewed(array.tape, array.node, mapped, shape)
    if isinstance(made, Array) and shape:
        return Array(array.tape, made.node, shape, array, index)
    return made


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
        number = arguments[0]
        return tape.add("fill", (number,), shape) if shape else _value(tape, number)
    if kind == "join":
        found = _of_join(tape, arguments, mapped, shape)
        if found is not None:
            return found
    if kind == "stack" and isinstance(mapped[0], int):
        item = arguments[mapped[0]]
        if type(item) is float:
            return constant(tape, np.full(shape, item))  # a number, or one with new axes
        return tape_viewed(tape, item, mapped[1:], shape)
    return tape.add("view", (node,), shape, mapped)


def _value(tape: Tape, ref: Ref) -> Any:
    return ref if type(ref) is float else Array(tape, ref, tape.operations[ref].shape)


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


PARTS.update(index_map=index_map, view=view, tape_view=tape_view)
