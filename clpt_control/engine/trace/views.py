"""Views of tracer arrays, stacks, joins and other shapes.

A view is an index of each axis of an array, or (axis of the view, start, step).  Views of views, of
stacks and of numbers are computed at once.

Functions that are not recorded run NumPy's own code: on numbers if they depend on parameters alone,
otherwise on arrays of objects.
"""

from collections.abc import Callable, Iterator, Sequence
from functools import lru_cache
from math import prod
from operator import itemgetter
from typing import Any

import numpy as np

from ..record.graph import MOST_NUMBERS, Ref, Shape, is_known, viewed
from ..record.scalar_graph import moved
from ..record.unread import Unread
from .arrays import HOOKS, Array, Tape, moves, numbers_of, objects, operand, whole
from .elementwise import (
    TRUTH,
    as_number,
    as_numpy_number,
    boxed,
    constant,
    in_a_try,
    is_whole,
    lifted,
    stacked,
)

# --- NumPy's own code --------------------------------------------------------------------------


def arrays_in(value: Any) -> Iterator[Array]:
    """Yield the tracer arrays among arguments, and in lists, tuples and dicts."""
    if isinstance(value, Array):
        yield value
        return
    has_objects = isinstance(value, np.ndarray) and value.dtype == object and value.ndim
    if has_objects or isinstance(value, list | tuple | dict):
        for item in value.values() if isinstance(value, dict) else value:
            yield from arrays_in(item)


def tape_of(values):
    """Return the tape of the first tracer array among values, or None."""
    for value in values:  # usually one of these
        if isinstance(value, Array):
            return value._tape
    return next((array._tape for array in arrays_in(values)), None)


def depends(values: Any) -> bool:
    """Return whether arguments contain a signal or a parameter."""
    return any(numbers_of(array) is None for array in arrays_in(values))


def arrays_as(value: Any, convert: Callable[[Array], Any]) -> Any:
    """Return arguments with each tracer array converted, also in lists, tuples and dicts."""
    if isinstance(value, Array):
        return convert(value)
    if isinstance(value, dict):
        return {name: arrays_as(item, convert) for name, item in value.items()}
    if type(value) in (list, tuple):
        return type(value)(arrays_as(item, convert) for item in value)
    return value


def on_numbers(tape: Tape, function: Callable, inputs: Any, options: dict) -> Any:
    """Run NumPy's own function on numbers; parameters are then pinned.

    Return None if a signal is among the arguments, or if the result shares memory with one.
    """

    def number(array: Array) -> np.ndarray:
        numbers = numbers_of(array)
        if numbers is None:
            ref = array._ref
            parameter = None if type(ref) is float else tape.parameter(ref)
            numbers = tape.numbers(ref) if parameter is None else np.asarray(parameter)
        return numbers.astype(int) if is_whole(array) else numbers.copy()

    if any(map(moves, arrays_in((*inputs, *options.values())))):
        return None
    arguments = arrays_as(inputs, number)
    result = function(*arguments, **arrays_as(options, number))
    if any(share(argument, result) for argument in arguments):
        return None
    return repacked(tape, result)


def share(a: Any, b: Any) -> bool:
    """Return whether values are arrays that may share memory."""
    return (
        isinstance(a, np.ndarray)
        and isinstance(b, np.ndarray)
        and np.may_share_memory(a, b)
    )


def fresh(tape: Tape, value: Any) -> Any:
    """Return NumPy's new array of doubles as a tracer array, into which signals may be written."""
    if type(value) is np.ndarray and value.dtype == float and value.ndim:
        return constant(tape, value) if value.size < MOST_NUMBERS else value
    return value


def refuse(operation: str) -> Any:
    """Raise that an operation of signals is not traced."""
    raise Unread(
        f"{operation} of signals is not traced. Write its arithmetic, or call it before the run"
    )


def repacked(tape: Tape, value: Any) -> Any:
    """Return NumPy's arrays of objects as tracer arrays."""
    if isinstance(value, tuple | list):
        make = getattr(type(value), "_make", type(value))  # of a named tuple
        return make(repacked(tape, item) for item in value)
    if isinstance(value, np.ndarray) and value.dtype == object:
        return boxed(tape, lifted(tape, value))
    return fresh(tape, value)


def on_parameters(
    tape: Tape, function: Callable, inputs: Any, options: dict, why: Unread
) -> Any:
    """Run NumPy's own function if it depends on parameters alone; otherwise raise an error."""
    result = on_numbers(tape, function, inputs, options)
    if result is None:
        raise why
    tape.stopped = None
    return result


def on_objects(tape: Tape, function: Any, inputs: Any, options: dict) -> Any:
    """Run NumPy's own function on arrays of objects."""
    arguments = arrays_as(inputs, objects)
    # np.roots would ask each element
    real = getattr(function, "_implementation", function)
    try:
        result = real(*arguments, **arrays_as(options, objects))
    except (Unread, IndexError, ValueError):
        raise
    except Exception:
        module = function.__module__.replace("numpy", "np", 1)
        refuse(f"{module}.{function.__name__}")
    if result is None and not inputs:
        refuse(f"np.{function.__name__} with names of what it writes into,")
    if result is None:  # NumPy wrote into its first argument
        inputs[0][...] = arguments[0]
    if any(share(argument, result) for argument in arguments):
        refuse(f"np.{function.__name__} that gives a part")
    return repacked(tape, result)


def into(out, value):
    """Return a value, or the array `out` into which it is written; a number is replaced."""
    is_number = isinstance(out, Array) and not out.shape and not out._boxed
    if out is None or is_number:
        return value
    if not isinstance(out, Array):
        raise Unread(
            "writes signals into an array made elsewhere. Make it where it is filled"
        )
    out[...] = value
    return out


# --- views -------------------------------------------------------------------------------------


LONG = 16  # shorter arrays are stacks of elements
MANY = 2**16 + 1  # positions along an axis of unknown length


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
    is_int = array._root._whole
    if is_int is False:
        return new
    if isinstance(new, Array):
        new._whole = is_int
        return new
    return np.int64(new) if is_int else new


def part(a: Any, function: Callable[[np.ndarray], Any]) -> Any:
    """Return function(a), where NumPy's function selects or moves elements.

    The result shares memory with the array if NumPy's result does.  Until an element of either is
    written it is a view on the tape.
    """
    if not isinstance(a, Array):
        return function(a)
    store = a._written()
    if store is not None:
        return _part_of_elements(a, function, store)
    mapping = _mapped(a.shape, function)
    if mapping is not None:
        new = tape_viewed(a._tape, a._node, *mapping)
    else:
        new = _in_another_shape(a, function)
        new = lifted(a._tape, function(a._elements())) if new is None else new
    # ravel of an array whose elements are not adjacent in memory is a copy
    may_copy = mapping is None or (
        a._parent is not None and not isinstance(function, itemgetter)
    )
    if may_copy and is_known(a._root.shape):
        blank = a._blank()
        if not share(blank, function(blank)):
            return new
    if not getattr(new, "shape", ()):
        has_array = a.shape or a._boxed
        if not has_array or not isinstance(
            function(_positions(a.shape)[0]), np.ndarray
        ):
            return as_numpy_number(new)
        new = boxed(a._tape, new)
    view = Array(a._tape, new._node, new.shape, a, function)
    view._boxed = not new.shape
    return view


def _part_of_elements(a: Array, function: Callable, store: np.ndarray) -> Any:
    """Return a part of an array of which an element was written."""
    elements = function(store)
    if not isinstance(elements, np.ndarray):
        return as_numpy_number(elements)
    new = Array(a._tape, -1, elements.shape, a, function)
    new._store = elements
    new._boxed = True
    return new


def _in_another_shape(a: Array, function: Callable) -> Any:
    """Return many elements in another shape if their order stays; otherwise None."""
    if numbers_of(a) is not None or not is_known(a.shape):
        return None
    positions = function(np.arange(a.size).reshape(a.shape))
    if positions.size <= LONG or np.any(np.diff(positions.ravel()) != 1):
        return None
    return _reshaped(a._tape, a._node, positions.item(0), positions.shape)


def _reshaped(tape: Tape, node: int, start: int, shape: Shape) -> Array:
    """Return the elements from `start` on, row by row, in a shape."""
    operation = tape.operations[node]
    if operation.kind == "part":
        return _reshaped(tape, operation.arguments[0], operation.at + start, shape)
    if operation.shape == shape:
        return Array(tape, node, shape)
    return tape.add("part", (node,), shape, start)


def _mapped(shape: Shape, function: Callable) -> tuple[tuple, Shape] | None:
    """Return index or (axis, start, step) of each axis, and the shape; None if NumPy copies.

    The function runs on the positions along each axis.  The first element of its result and the
    strides are start and step.
    """
    try:
        samples = [
            (positions, np.asarray(function(positions)))
            for positions in _positions(shape)
        ]
    except IndexError:
        for n in shape:
            _refuse_part_of(n)
        raise
    new_shape = [*samples[0][1].shape]
    mapped = []
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
            is_whole_axis = bool(moving) and start[1:] == (0, 1)
            if not is_whole_axis or new_shape[moving[0]] not in (MANY, n):
                _refuse_part_of(n)
            new_shape[moving[0]] = n
    return tuple(mapped), tuple(new_shape)


def _refuse_part_of(n: Any) -> None:
    """Refuse a part of an axis of open size."""
    if not isinstance(n, int):
        raise Unread(f"a part of the open size {n}")


@lru_cache(maxsize=256)
def _positions(shape: Shape) -> list[np.ndarray]:
    """Return for each axis an array of the positions along it; one of no axes for a number."""
    counts = [n if isinstance(n, int) else MANY for n in shape]
    arrays = []
    for axis, count in enumerate(counts or [1]):
        strides = [8 * (d == axis) for d in range(len(counts))]
        arrays.append(np.ndarray(counts, int, np.arange(max(count, 1)), 0, strides))
    return arrays


def _picked(array: Array, *index: Any) -> Any:
    """Return elements at indices that are signals."""
    condition = index[0]
    if isinstance(condition, Array) and condition._is_condition:
        if moves(condition):
            return refuse("elements taken by a condition, which np.where chooses,")
        mask = condition._tape.numbers(condition._ref) != 0.0
        return array[(mask, *index[1:])]
    axis = next(k for k, item in enumerate(index) if isinstance(item, Array))
    if not _is_row_index(array, index, axis):
        return array[whole(index)]
    rows = part(array, lambda a: np.moveaxis(a, axis, 0)) if axis else array
    row = _row(rows, index[axis])
    remaining = (*index[:axis], *index[axis + 1 :])
    return row[remaining] if remaining else row


def _is_row_index(array: Array, index: tuple, axis: int) -> bool:
    """Return whether an index of an unchanged array has one signal, a whole number."""
    signal = index[axis]
    if signal.shape or signal._whole is not True or not moves(signal):
        return False
    kinds = (int, slice, list) if array.ndim == 2 else (int, slice)
    if not all(
        isinstance(item, kinds) or getattr(item, "shape", 0) == () for item in index
    ):
        return False
    root = array._root
    return (
        is_known(array.shape)
        and axis < array.ndim
        and array._written() is None
        and not in_a_try()
        and (array.ndim == 1 or root._fixed or array._tape.merging)
    )


def _row(array: Array, index: Array) -> Any:
    """Return array[index] of a signal: NaN outside; a negative index counts from the end."""
    tape = array._tape
    if array.ndim == 1:
        return tape.add("pick", (operand(array), index._ref), ())
    size = prod(array.shape[1:])
    flat = part(array, lambda a: np.reshape(a, -1))
    positions = lifted(tape, index * float(size) + np.arange(size, dtype=float))
    picked = tape.add("pick", (operand(flat), operand(positions)), (size,))
    # a view in NumPy: what is written into either would be lost in the other
    picked._fixed = array._root._fixed = True
    return part(picked, lambda a: np.reshape(a, array.shape[1:]))


def tape_viewed(tape: Tape, node: int, mapped: tuple, shape: Shape) -> Any:
    """Return a view; views of views, of stacks and of numbers are computed at once."""
    kind, arguments, old_shape, at = tape.operations[node]
    is_identity = mapped == tuple((d, 0, 1) for d in range(len(old_shape)))
    if is_identity and shape == old_shape:
        return Array(tape, node, old_shape)
    if kind == "constant":
        return constant(
            tape, viewed(np.frombuffer(at).reshape(old_shape), mapped, shape)
        )
    if kind == "view":
        composed = tuple(moved(entry, mapped) for entry in at)
        return tape_viewed(tape, arguments[0], composed, shape)
    if kind == "fill":
        (number,) = arguments
        if shape:
            return tape.add("fill", (number,), shape)
        return number if type(number) is float else Array(tape, number, ())
    if kind == "stack" and isinstance(mapped[0], int):
        element = arguments[mapped[0]]
        if type(element) is float:
            # a number, or one with new axes
            return constant(tape, np.full(shape, element))
        return tape_viewed(tape, element, mapped[1:], shape)
    return tape.add("view", (node,), shape, mapped)


# --- stacks ------------------------------------------------------------------------------------


SHORTEST_RUN = 8  # neighbouring elements that become one view in a long stack


def stack_of(tape: Tape, refs: Sequence[Ref], shape: Shape) -> Any:
    """Return values of one shape as an array; neighbouring elements of one array are its view."""
    stacked_shape = len(refs), *shape
    if 1 < len(refs) == _end_of_run(tape, refs, 0):
        return _run(tape, refs, shape)
    if is_known(shape) and prod(stacked_shape) > LONG:
        joined = list(_runs_and_stacks(tape, refs, shape))
        if len(joined) > 1:
            return tape.add("join", [operand(array) for array in joined], stacked_shape)
    return tape.add("stack", refs, stacked_shape)


def _runs_and_stacks(tape: Tape, refs: Sequence[Ref], shape: Shape) -> Iterator[Any]:
    """Yield the pieces of a stack: long runs, and stacks of the values between them."""
    groups: list[Any] = [[]]  # stacks and runs in turn
    position = 0
    while position < len(refs):
        end = _end_of_run(tape, refs, position)
        if end - position < SHORTEST_RUN:
            groups[-1].append(refs[position])
            position += 1
        else:
            groups += [refs[position:end], []]
            position = end
    for k, group in enumerate(groups):
        if k % 2:
            yield _run(tape, group, shape)
        elif group:
            yield tape.add("stack", group, (len(group), *shape))


def _end_of_run(tape: Tape, refs: Sequence[Ref], start: int) -> int:
    """Return the end of the run from `start` on: numbers, or elements of one array in one step."""
    end = start + 1
    step = _step(tape, refs[start], refs[end]) if end < len(refs) else None
    while (
        step is not None
        and end < len(refs)
        and _step(tape, refs[end - 1], refs[end]) == step
    ):
        end += 1
    return end


def _step(tape: Tape, a: Ref, b: Ref) -> tuple[int, ...] | None:
    """Return the step along each axis between elements of one array, or None; () of numbers."""
    if type(a) is float or type(b) is float:
        return () if type(a) is type(b) else None
    before = tape.operations[a]
    after = tape.operations[b]
    if (
        before.kind != "view"
        or after.kind != "view"
        or before.arguments != after.arguments
    ):
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
    mapped = tuple(
        (0, index, distance)
        if distance
        else index
        if isinstance(index, int)
        else (index[0] + 1, *index[1:])
        for index, distance in zip(indices, step, strict=True)
    )
    return tape_viewed(tape, array, mapped, (len(refs), *shape))


def stack(arrays: Any, axis: int = 0, **options: Any) -> Any:
    """Return np.stack(parts)."""
    tape = tape_of(arrays)
    new = stacked(tape, [lifted(tape, array) for array in arrays])
    return np.moveaxis(new, 0, axis) if axis else new


def join(inputs, axis=0, **options):
    """Return np.concatenate(parts); long arrays are one operation."""
    tape = tape_of(inputs)
    arrays = [
        array
        for array in (lifted(tape, value) for value in inputs)
        if array.shape != (0,)
    ]
    has_sizes = all(is_known(array.shape) for array in arrays)
    is_long = has_sizes and any(prod(array.shape) > LONG for array in arrays)
    if axis is None or not is_long:
        return lifted(
            tape, np.concatenate([objects(array) for array in arrays], axis=axis)
        )
    rows = [np.moveaxis(array, axis, 0) for array in arrays]
    shape = (sum(array.shape[0] for array in rows), *rows[0].shape[1:])
    joined = tape.add("join", [operand(array) for array in rows], shape)
    return np.moveaxis(joined, 0, axis) if axis else joined


# --- other shapes ------------------------------------------------------------


def copied(a, *arguments, **options):
    """Return a copy, which no longer shares what is written."""
    if not isinstance(a, Array) or not (a.shape or a._boxed):
        return a
    ref = a._ref
    if type(ref) is float:
        return ref
    new = Array(a._tape, ref, a.shape)
    new._whole = a._whole
    return new


def converted(a, dtype=float, *arguments, **options):
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
        refuse(f"a conversion to {kind}")
    new = copied(as_number(a))
    counted = isinstance(new, Array) and new._whole is not False
    return Array(new._tape, new._ref, new.shape) if counted else new


HOOKS.update(item=item, stack_of=stack_of)
