"""Views of values, and values in other shapes: what an index makes of an array, joined, reshaped.

A view says for each axis of what it views an index, or (axis of the view, start, step).  A view
of a view, of a stack or of numbers is made at once.

At times they are NumPy's own: as numbers where they depend on nothing, else as objects.
"""

from collections.abc import Callable, Iterator, Sequence
from functools import lru_cache
from math import prod
from operator import itemgetter
from typing import Any

import numpy as np

from ..record.graph import MOST_NUMBERS, Ref, Shape, viewed
from .arrays import HOOKS, Array, Tape, Unread, moves, numbers_of, objects, operand, whole
from .elementwise import (
    TRUTH,
    as_number,
    boxed,
    constant,
    in_a_try,
    is_whole,
    lifted,
    of_numpy,
    stacked,
)

# --- as NumPy's own ----------------------------------------------------------------------------


def arrays_in(value: Any) -> Iterator[Array]:
    """Yield the arrays of the record among arguments, in what holds them too."""
    if isinstance(value, Array):
        yield value
    elif isinstance(value, list | tuple | dict) or (
        isinstance(value, np.ndarray) and value.dtype == object and value.ndim
    ):
        for one in value.values() if isinstance(value, dict) else value:
            yield from arrays_in(one)


def tape_of(values: Any) -> Any:
    """Return the tape of the first array of the record among values, or None."""
    for value in values:  # most often one of them
        if isinstance(value, Array):
            return value._tape
    return next((one._tape for one in arrays_in(values)), None)


def depends(values: Any) -> bool:
    """Return whether arguments hold a signal or a parameter."""
    return any(numbers_of(one) is None for one in arrays_in(values))


def arrays_as(value: Any, to: Callable[[Array], Any]) -> Any:
    """Return arguments with `to` of each array of the record, in lists, tuples and dicts too."""
    if isinstance(value, Array):
        return to(value)
    if isinstance(value, dict):
        return {name: arrays_as(item, to) for name, item in value.items()}
    return type(value)(arrays_as(v, to) for v in value) if type(value) in (list, tuple) else value


def on_numbers(tape: Tape, function: Callable, inputs: Any, more: dict) -> Any:
    """Run NumPy's own function on what depends on nothing or on parameters, which are then pinned.

    Return None if it writes, gives a part of what it is given, or signals are among that.
    """

    def number(one: Array) -> np.ndarray:
        if (known := numbers_of(one)) is not None:
            return known.astype(int) if one._whole else known.copy()
        ref = one._ref
        given = None if type(ref) is float else tape.parameter(ref)
        numbers = tape.numbers(ref) if given is None else np.asarray(given)
        return numbers.astype(int) if is_whole(one) else numbers

    if any(map(moves, arrays_in((*inputs, *more.values())))):
        return None
    given = arrays_as(inputs, number)
    result = function(*given, **arrays_as(more, number))
    return None if any(share(one, result) for one in given) else repacked(tape, result)


def share(a: Any, b: Any) -> bool:
    """Return whether arrays share what is written."""
    return isinstance(a, np.ndarray) and isinstance(b, np.ndarray) and np.may_share_memory(a, b)


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
        make = getattr(type(value), "_make", type(value))  # that of a tuple with names
        return make(repacked(tape, one) for one in value)
    if isinstance(value, np.ndarray) and value.dtype == object:
        return boxed(tape, lifted(tape, value))
    return fresh(tape, value)


def on_parameters(tape: Tape, function: Callable, inputs: Any, more: dict, why: Unread) -> Any:
    """Run NumPy's own function on what parameters alone decide; else say why it is not read."""
    if (result := on_numbers(tape, function, inputs, more)) is None:
        raise why
    tape.stopped = None
    return result


def on_objects(tape: Tape, function: Any, inputs: Any, more: dict) -> Any:
    """Run NumPy's own function on arrays of objects."""
    arguments = arrays_as(inputs, objects)
    own = getattr(function, "_implementation", function)  # np.roots would ask each element
    try:
        result = own(*arguments, **arrays_as(more, objects))
    except (Unread, IndexError, ValueError):
        raise
    except Exception:
        module = function.__module__.replace("numpy", "np", 1)
        raise Unread(
            f"{module}.{function.__name__} of signals is not traced; write its arithmetic, or call "
            "it before the run"
        ) from None
    if result is None and inputs:  # NumPy wrote into its first argument
        inputs[0][...] = arguments[0]
    elif result is None:
        refuse(f"np.{function.__name__} with names of what it writes into,")
    if any(share(one, result) for one in arguments):
        refuse(f"np.{function.__name__} that gives a part")
    return repacked(tape, result)


def into(out: Any, value: Any) -> Any:
    """Return a value, or the array `out` into which it is written; a number is replaced."""
    if out is None or (isinstance(out, Array) and not out.shape and not out._boxed):
        return value
    if not isinstance(out, Array):
        raise Unread("writes signals into an array made elsewhere; make it where it is filled")
    out[...] = value
    return out


# --- views -------------------------------------------------------------------------------------


LONG = 16  # numbers of an array that is written down as it is made, not one by one
MANY = 2**16 + 1  # places along an axis of unknown length


def item(array: Array, index: tuple) -> Any:
    """Return array[index]."""
    if any(isinstance(i, Array) for i in index):
        new = _picked(array, *index)
    elif index and isinstance(index[0], list) and tape_of(index[0]) is not None:
        new = np.stack([array[(k, *index[1:])] for k in index[0]])
    elif any(isinstance(i, list | tuple | np.ndarray) and np.ndim(i) for i in index):
        new = lifted(array._tape, array._elements()[index])
    else:
        new = part(array, itemgetter(index))
    if (counted := array._root._whole) is False:
        return new
    if isinstance(new, Array):
        new._whole = counted
    return new if isinstance(new, Array) or counted is not True else np.int64(new)


def part(a: Any, function: Callable[[np.ndarray], Any]) -> Any:
    """Return what NumPy's function makes of an array, with which it shares what is written.

    Until an element of either is written it is a view, if NumPy's function makes one.
    """
    if not isinstance(a, Array):
        return function(a)
    if (store := a._written()) is not None:
        elements = function(store)
        if not isinstance(elements, np.ndarray):
            return of_numpy(elements)
        new = Array(a._tape, -1, elements.shape, a, function)
        new._store, new._boxed = elements, True
        return new
    node, seen = a._node, _mapped(a.shape, function)
    if seen is None:
        new = _in_another_shape(a, function)
        new = lifted(a._tape, function(a._elements())) if new is None else new
    else:
        new = tape_viewed(a._tape, node, *seen)
    cuts = seen is None or (a._parent is not None and not isinstance(function, itemgetter))
    if cuts and all(isinstance(n, int) for n in a._root.shape):
        blank = a._blank()  # ravel of what does not lie side by side is a copy
        if not share(blank, function(blank)):
            return new
    if not getattr(new, "shape", ()):  # NumPy's number, or its array without axes
        if not (a.shape or a._boxed) or not isinstance(function(_places(a.shape)[0]), np.ndarray):
            return of_numpy(new)
        new = boxed(a._tape, new)
    view = Array(a._tape, new._node, new.shape, a, function)
    view._boxed = not new.shape
    return view


def _in_another_shape(a: Array, function: Callable) -> Any:
    """Return many elements that stay row by row in another shape; None of others."""
    if numbers_of(a) is not None or not all(isinstance(n, int) for n in a.shape):
        return None
    places = function(np.arange(a.size).reshape(a.shape))
    if places.size <= LONG or np.any(np.diff(places.ravel()) != 1):
        return None
    return _parted(a._tape, a._node, places.item(0), places.shape)


def _parted(tape: Tape, node: int, first: int, shape: Shape) -> Array:
    kind, arguments, old, at = tape.operations[node]
    if kind == "part":
        return _parted(tape, arguments[0], at + first, shape)
    return Array(tape, node, old) if old == shape else tape.add("part", (node,), shape, first)


def _mapped(shape: Shape, function: Callable) -> tuple[tuple, Shape] | None:
    """Return what NumPy's function makes of each axis, and the shape of the view; None of a copy.

    It is run on the places along each axis: where a part begins, and its strides, say what it is.
    """
    try:
        parts = [(places, np.asarray(function(places))) for places in _places(shape)]
    except IndexError:
        for n in shape:
            _refuse_part_of(n)
        raise
    new_shape: list[Any] = [*parts[0][1].shape]
    mapped: list[Any] = []
    for n, (places, seen) in zip(shape, parts, strict=False):
        if seen.ndim and seen.base is not places.base:
            return None
        moving = [d for d, stride in enumerate(seen.strides) if stride]
        if len(moving) > 1:  # an axis of length 1 may have any stride
            moving = [d for d in moving if new_shape[d] != 1] or moving[:1]
        if len(moving) > 1:
            return None
        start: Any = seen.item(0) if seen.size else 0
        for d in moving:
            start = d, start, seen.strides[d] // seen.itemsize
        mapped.append(start)
        if not isinstance(n, int):
            if not moving or start[1:] != (0, 1) or new_shape[moving[0]] not in (MANY, n):
                _refuse_part_of(n)
            new_shape[moving[0]] = n
    return tuple(mapped), tuple(new_shape)


def _refuse_part_of(n: Any) -> None:
    """Refuse a part of an axis of open size."""
    if not isinstance(n, int):
        raise Unread(f"a part of the open size {n}")


@lru_cache(maxsize=256)
def _places(shape: Shape) -> list[np.ndarray]:
    """Return for each axis an array of the places along it; one of no axes for a number."""
    counts = [n if isinstance(n, int) else MANY for n in shape]
    return [
        np.ndarray(counts, int, np.arange(max(n, 1)), 0, [8 * (d == k) for d in range(len(counts))])
        for k, n in enumerate(counts or [1])
    ]


def _picked(array: Array, *index: Any) -> Any:
    """Return elements at indices that are signals."""
    first = index[0]
    if isinstance(first, Array) and first._is_condition:
        if moves(first):
            return refuse("elements taken by a condition, which np.where chooses,")
        return array[(first._tape.numbers(first._ref) != 0.0, *index[1:])]
    axis = next(k for k, one in enumerate(index) if isinstance(one, Array))
    if not _is_place(array, index, axis):
        return array[whole(index)]
    rows = part(array, lambda a: np.moveaxis(a, axis, 0)) if axis else array
    found = _row(rows, index[axis])
    rest = (*index[:axis], *index[axis + 1 :])
    return found[rest] if rest else found


def _is_place(array: Array, index: tuple, axis: int) -> bool:
    """Return whether an index is one whole number that moves, of an array that is as it was."""
    place = index[axis]
    kinds = (int, slice, list) if array.ndim == 2 else (int, slice)
    plain = all(isinstance(one, kinds) or getattr(one, "shape", 0) == () for one in index)
    known = all(isinstance(n, int) for n in array.shape) and axis < array.ndim
    counts = place._whole is True and moves(place) and not place.shape
    return plain and known and counts and array._written() is None and not in_a_try()


def _row(array: Array, place: Array) -> Any:
    """Return the row of an array at a place that is a signal: NaN outside, from the end below 0."""
    tape, size = array._tape, prod(array.shape[1:])
    if array.ndim == 1:
        return tape.add("pick", (operand(array), place._ref), ())
    flat = part(array, lambda a: np.reshape(a, -1))
    places = lifted(tape, place * float(size) + np.arange(size, dtype=float))
    row = tape.add("pick", (operand(flat), operand(places)), (size,))
    return part(row, lambda a: np.reshape(a, array.shape[1:]))


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
    if kind == "stack" and isinstance(mapped[0], int):
        item = arguments[mapped[0]]
        if type(item) is float:
            return constant(tape, np.full(shape, item))  # a number, or one with new axes
        return tape_viewed(tape, item, mapped[1:], shape)
    return tape.add("view", (node,), shape, mapped)


# --- stacks ------------------------------------------------------------------------------------


SHORTEST_RUN = 8  # neighbouring elements that become one view in a long stack


def stack_of(tape: Tape, refs: Sequence[Ref], shape: Shape) -> Any:
    """Return values of one shape as an array; neighbouring elements of one array are its view."""
    stacked_shape = len(refs), *shape
    if 1 < len(refs) == _end_of_run(tape, refs, 0):
        return _run(tape, refs, shape)
    if all(isinstance(n, int) for n in shape) and prod(stacked_shape) > LONG:
        pieces = list(_pieces(tape, refs, shape))
        if len(pieces) > 1:
            return tape.add("join", [operand(piece) for piece in pieces], stacked_shape)
    return tape.add("stack", refs, stacked_shape)


def _pieces(tape: Tape, refs: Sequence[Ref], shape: Shape) -> Iterator[Any]:
    """Yield the pieces of a stack: long runs, and stacks of the values between them."""
    between: list[Ref] = []
    position = 0
    while position < len(refs):
        end = _end_of_run(tape, refs, position)
        if end - position < SHORTEST_RUN:
            between.append(refs[position])
            position += 1
            continue
        if between:
            yield tape.add("stack", between, (len(between), *shape))
            between = []
        yield _run(tape, refs[position:end], shape)
        position = end
    if between:
        yield tape.add("stack", between, (len(between), *shape))


def _end_of_run(tape: Tape, refs: Sequence[Ref], start: int) -> int:
    """Return the end of the run from `start` on: numbers, or elements of one array in one step."""
    end = start + 1
    step = _step(tape, refs[start], refs[end]) if end < len(refs) else None
    while step is not None and end < len(refs) and _step(tape, refs[end - 1], refs[end]) == step:
        end += 1
    return end


def _step(tape: Tape, a: Ref, b: Ref) -> tuple[int, ...] | None:
    """Return the step along each axis between elements of one array, or None; () of numbers."""
    if type(a) is float or type(b) is float:
        return () if type(a) is type(b) else None
    first, second = tape.operations[a], tape.operations[b]
    if first.kind != "view" or second.kind != "view" or first.arguments != second.arguments:
        return None
    step = []
    for index, next_index in zip(first.at, second.at, strict=True):
        is_index = isinstance(index, int) and isinstance(next_index, int)
        if not is_index and index != next_index:
            return None
        step.append(next_index - index if is_index else 0)
    moving = [distance for distance in step if distance]
    return tuple(step) if len(moving) == 1 and moving[0] > 0 else None


def _run(tape: Tape, refs: Sequence[Ref], shape: Shape) -> Any:
    """Return a run as a row of numbers, or as a view whose first axis goes through it."""
    step = _step(tape, refs[0], refs[1])
    if not step:
        return constant(tape, np.array(refs))
    _, (array,), _, indices = tape.operations[refs[0]]
    mapped: list[Any] = []
    for index, distance in zip(indices, step, strict=True):
        if distance:
            mapped.append((0, index, distance))
        elif isinstance(index, int):
            mapped.append(index)
        else:
            axis, start, stride = index
            mapped.append((axis + 1, start, stride))
    return tape_viewed(tape, array, tuple(mapped), (len(refs), *shape))


def stack(parts: Any, axis: int = 0, **more: Any) -> Any:
    """Return np.stack(parts)."""
    tape = tape_of(parts)
    new = stacked(tape, [lifted(tape, part) for part in parts])
    return np.moveaxis(new, 0, axis) if axis else new


def join(parts: Any, axis: Any = 0, **more: Any) -> Any:
    """Return np.concatenate(parts); long arrays are one operation."""
    tape = tape_of(parts)
    arrays = [array for array in (lifted(tape, part) for part in parts) if array.shape != (0,)]
    is_known = all(isinstance(n, int) for array in arrays for n in array.shape)
    is_long = is_known and any(prod(array.shape) > LONG for array in arrays)
    if axis is None or not is_long:
        return lifted(tape, np.concatenate([objects(array) for array in arrays], axis=axis))
    rows = [np.moveaxis(array, axis, 0) for array in arrays]
    shape = (sum(array.shape[0] for array in rows), *rows[0].shape[1:])
    joined = tape.add("join", [operand(array) for array in rows], shape)
    return np.moveaxis(joined, 0, axis) if axis else joined


# --- other shapes ------------------------------------------------------------


def copied(a: Any, *arguments: Any, **more: Any) -> Any:
    """Return a copy, which no longer shares what is written."""
    if not isinstance(a, Array) or not (a.shape or a._boxed):
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
        numbers = np.trunc(as_number(a)) + 0.0
        if isinstance(numbers, Array):
            numbers._whole = True
        return numbers
    if kind == TRUTH:
        return a if a._is_condition else a != 0
    if kind not in (np.float64, np.object_):  # objects are the numbers themselves
        refuse(f"numbers of {kind}")
    new = copied(as_number(a))
    counted = isinstance(new, Array) and new._whole is not False
    return Array(new._tape, new._ref, new.shape) if counted else new


HOOKS.update(item=item, stack_of=stack_of)
