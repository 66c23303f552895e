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
        for item in value.values() if isinstance(value, dict) else value:
            yield from arrays_in(item)


def tape_of(values: Any) -> Any:
    """Return the tape of the first array of the record among values, or None."""
    for value in values:  # most often one of them
        if isinstance(value, Array):
            return value._tape
    return next((array._tape for array in arrays_in(values)), None)


def depends(values: Any) -> bool:
    """Return whether arguments hold a signal or a parameter."""
    return any(numbers_of(array) is None for array in arrays_in(values))


def arrays_as(value: Any, to: Callable[[Array], Any]) -> Any:
    """Return arguments with `to` of each array of the record, in lists, tuples and dicts too."""
    if isinstance(value, Array):
        return to(value)
    if isinstance(value, dict):
        return {name: arrays_as(item, to) for name, item in value.items()}
    return type(value)(arrays_as(v, to) for v in value) if type(value) in (list, tuple) else value


def on_numbers(tape: Tape, function: Callable, inputs: Any, options: dict) -> Any:
    """Run NumPy's own function on what depends on nothing or on parameters, which are then pinned.

    Return None if it writes, gives a part of what it is given, or signals are among that.
    """

    def number(array: Array) -> np.ndarray:
        if (numbers := numbers_of(array)) is not None:
            return numbers.astype(int) if array._whole else numbers.copy()
        ref = array._ref
        parameter = None if type(ref) is float else tape.parameter(ref)
        numbers = tape.numbers(ref) if parameter is None else np.asarray(parameter)
        return numbers.astype(int) if is_whole(array) else numbers

    if any(map(moves, arrays_in((*inputs, *options.values())))):
        return None
    arguments = arrays_as(inputs, number)
    result = function(*arguments, **arrays_as(options, number))
    return None if any(share(array, result) for array in arguments) else repacked(tape, result)


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
        return make(repacked(tape, item) for item in value)
    if isinstance(value, np.ndarray) and value.dtype == object:
        return boxed(tape, lifted(tape, value))
    return fresh(tape, value)


def on_parameters(tape: Tape, function: Callable, inputs: Any, options: dict, why: Unread) -> Any:
    """Run NumPy's own function on what parameters alone decide; else say why it is not read."""
    if (result := on_numbers(tape, function, inputs, options)) is None:
        raise why
    tape.stopped = None
    return result


def on_objects(tape: Tape, function: Any, inputs: Any, options: dict) -> Any:
    """Run NumPy's own function on arrays of objects."""
    arguments = arrays_as(inputs, objects)
    real = getattr(function, "_implementation", function)  # np.roots would ask each element
    try:
        result = real(*arguments, **arrays_as(options, objects))
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
    if any(share(argument, result) for argument in arguments):
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
        new._store = elements
        new._boxed = True
        return new
    node = a._node
    mapping = _mapped(a.shape, function)
    if mapping is None:
        new = _in_another_shape(a, function)
        new = lifted(a._tape, function(a._elements())) if new is None else new
    else:
        new = tape_viewed(a._tape, node, *mapping)
    cuts = mapping is None or (a._parent is not None and not isinstance(function, itemgetter))
    if cuts and all(isinstance(n, int) for n in a._root.shape):
        blank = a._blank()  # ravel of what does not lie side by side is a copy
        if not share(blank, function(blank)):
            return new
    if not getattr(new, "shape", ()):  # NumPy's number, or its array without axes
        if not (a.shape or a._boxed) or not isinstance(
            function(_positions(a.shape)[0]), np.ndarray
        ):
            return of_numpy(new)
        new = boxed(a._tape, new)
    view = Array(a._tape, new._node, new.shape, a, function)
    view._boxed = not new.shape
    return view


def _in_another_shape(a: Array, function: Callable) -> Any:
    """Return many elements that stay row by row in another shape; None of others."""
    if numbers_of(a) is not None or not all(isinstance(n, int) for n in a.shape):
        return None
    positions = function(np.arange(a.size).reshape(a.shape))
    if positions.size <= LONG or np.any(np.diff(positions.ravel()) != 1):
        return None
    return _parted(a._tape, a._node, positions.item(0), positions.shape)


def _parted(tape: Tape, node: int, start: int, shape: Shape) -> Array:
    kind, arguments, old, at = tape.operations[node]
    if kind == "part":
        return _parted(tape, arguments[0], at + start, shape)
    return Array(tape, node, old) if old == shape else tape.add("part", (node,), shape, start)


def _mapped(shape: Shape, function: Callable) -> tuple[tuple, Shape] | None:
    """Return what NumPy's function makes of each axis, and the shape of the view; None of a copy.

    It is run on the places along each axis: where a part begins, and its strides, say what it is.
    """
    try:
        samples = [(positions, np.asarray(function(positions))) for positions in _positions(shape)]
    except IndexError:
        for n in shape:
            _refuse_part_of(n)
        raise
    new_shape: list[Any] = [*samples[0][1].shape]
    mapped: list[Any] = []
    for n, (positions, sample) in zip(shape, samples, strict=False):
        if sample.ndim and sample.base is not positions.base:
            return None
        moving = [d for d, stride in enumerate(sample.strides) if stride]
        if len(moving) > 1:  # an axis of length 1 may have any stride
            moving = [d for d in moving if new_shape[d] != 1] or moving[:1]
        if len(moving) > 1:
            return None
        start: Any = sample.item(0) if sample.size else 0
        for d in moving:
            start = d, start, sample.strides[d] // sample.itemsize
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
def _positions(shape: Shape) -> list[np.ndarray]:
    """Return for each axis an array of the places along it; one of no axes for a number."""
    counts = [n if isinstance(n, int) else MANY for n in shape]
    return [
        np.ndarray(counts, int, np.arange(max(n, 1)), 0, [8 * (d == k) for d in range(len(counts))])
        for k, n in enumerate(counts or [1])
    ]


def _picked(array: Array, *index: Any) -> Any:
    """Return elements at indices that are signals."""
    head = index[0]
    if isinstance(head, Array) and head._is_condition:
        if moves(head):
            return refuse("elements taken by a condition, which np.where chooses,")
        return array[(head._tape.numbers(head._ref) != 0.0, *index[1:])]
    axis = next(k for k, item in enumerate(index) if isinstance(item, Array))
    if not _is_place(array, index, axis):
        return array[whole(index)]
    rows = part(array, lambda a: np.moveaxis(a, axis, 0)) if axis else array
    row = _row(rows, index[axis])
    remaining = (*index[:axis], *index[axis + 1 :])
    return row[remaining] if remaining else row


def _is_place(array: Array, index: tuple, axis: int) -> bool:
    """Return whether an index is one whole number that moves, of an array that is as it was."""
    signal = index[axis]
    kinds = (int, slice, list) if array.ndim == 2 else (int, slice)
    plain = all(isinstance(item, kinds) or getattr(item, "shape", 0) == () for item in index)
    has_sizes = all(isinstance(n, int) for n in array.shape) and axis < array.ndim
    counts = signal._whole is True and moves(signal) and not signal.shape
    return plain and has_sizes and counts and array._written() is None and not in_a_try()


def _row(array: Array, index: Array) -> Any:
    """Return the row of an array at a place that is a signal: NaN outside, from the end below 0."""
    tape = array._tape
    size = prod(array.shape[1:])
    if array.ndim == 1:
        return tape.add("pick", (operand(array), index._ref), ())
    flat = part(array, lambda a: np.reshape(a, -1))
    positions = lifted(tape, index * float(size) + np.arange(size, dtype=float))
    row = tape.add("pick", (operand(flat), operand(positions)), (size,))
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
        joined = list(_runs_and_stacks(tape, refs, shape))
        if len(joined) > 1:
            return tape.add("join", [operand(array) for array in joined], stacked_shape)
    return tape.add("stack", refs, stacked_shape)


def _runs_and_stacks(tape: Tape, refs: Sequence[Ref], shape: Shape) -> Iterator[Any]:
    """Yield the pieces of a stack: long runs, and stacks of the values between them."""
    alone: list[Ref] = []
    position = 0
    while position < len(refs):
        end = _end_of_run(tape, refs, position)
        if end - position < SHORTEST_RUN:
            alone.append(refs[position])
            position += 1
            continue
        if alone:
            yield tape.add("stack", alone, (len(alone), *shape))
            alone = []
        yield _run(tape, refs[position:end], shape)
        position = end
    if alone:
        yield tape.add("stack", alone, (len(alone), *shape))


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
    before = tape.operations[a]
    after = tape.operations[b]
    if before.kind != "view" or after.kind != "view" or before.arguments != after.arguments:
        return None
    step = []
    for index, next_index in zip(before.at, after.at, strict=True):
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


def stack(arrays: Any, axis: int = 0, **options: Any) -> Any:
    """Return np.stack(parts)."""
    tape = tape_of(arrays)
    new = stacked(tape, [lifted(tape, array) for array in arrays])
    return np.moveaxis(new, 0, axis) if axis else new


def join(inputs: Any, axis: Any = 0, **options: Any) -> Any:
    """Return np.concatenate(parts); long arrays are one operation."""
    tape = tape_of(inputs)
    arrays = [array for array in (lifted(tape, value) for value in inputs) if array.shape != (0,)]
    is_known = all(isinstance(n, int) for array in arrays for n in array.shape)
    is_long = is_known and any(prod(array.shape) > LONG for array in arrays)
    if axis is None or not is_long:
        return lifted(tape, np.concatenate([objects(array) for array in arrays], axis=axis))
    rows = [np.moveaxis(array, axis, 0) for array in arrays]
    shape = (sum(array.shape[0] for array in rows), *rows[0].shape[1:])
    joined = tape.add("join", [operand(array) for array in rows], shape)
    return np.moveaxis(joined, 0, axis) if axis else joined


# --- other shapes ------------------------------------------------------------


def copied(a: Any, *arguments: Any, **options: Any) -> Any:
    """Return a copy, which no longer shares what is written."""
    if not isinstance(a, Array) or not (a.shape or a._boxed):
        return a
    ref = a._ref
    if type(ref) is float:
        return ref
    copy = Array(a._tape, ref, a.shape)
    copy._whole = a._whole
    return copy


def converted(a: Any, dtype: Any = float, *arguments: Any, **options: Any) -> Any:
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
