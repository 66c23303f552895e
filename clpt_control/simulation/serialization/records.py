"""Records as plain data, and the check of records that are read from a file.

Plain data are dicts, lists, strings, numbers and booleans, as in JSON.  Machine code does not check
indices: a view beyond the end of its array would read foreign memory.  Therefore every operation
of a record from a file is checked: its arguments, its shape and its indices.
"""

from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from math import prod
from typing import Any

import numpy as np

from ...base.errors import BlockError
from ...engine.record.graph import Operation, Record, Shape, bound
from ...engine.record.operations import ELEMENTWISE

MAX_VALUE_SIZE = 10**7  # numbers of one value of a record
MAX_RECORD_SIZE = 10**8  # numbers of all values of a record

Leaves = Mapping[str, Mapping[str, Shape]]  # group -> name -> shape
BoundShape = tuple[int, ...]


def plain_data(value: Any) -> Any:
    """Return a record, bytes of numbers or an array as types of JSON."""
    if isinstance(value, Record):
        parts = ("operations", "outputs", "shapes")
        return {name: getattr(value, name) for name in parts}
    return (np.frombuffer(value) if isinstance(value, bytes) else value).tolist()


def record_of(plain: Mapping[str, Any]) -> Record:
    """Return the record of plain data."""
    lines = []
    for kind, arguments, shape, plain_data in plain["operations"]:
        data = _as_tuples(plain_data)
        if kind == "constant":
            data = np.array(plain_data, dtype=float).tobytes()
        lines.append(Operation(kind, tuple(arguments), shape_of(shape), data))
    shapes = tuple(map(shape_of, plain["shapes"]))
    return Record(tuple(lines), tuple(plain["outputs"]), shapes)


def shape_of(plain: Any) -> Shape:
    """Return the shape of plain data, of names and numbers."""
    return tuple(n if isinstance(n, str) else size_of(n) for n in plain)


def size_of(value: Any) -> int:
    """Return a size; raise `BlockError` unless it is a whole number of moderate size."""
    if type(value) is not int or not 0 <= value <= MAX_VALUE_SIZE:
        raise BlockError(
            f"a size is {value!r:.40}; must be a whole number up to {MAX_VALUE_SIZE:g}"
        )
    return value


def _as_tuples(value: Any) -> Any:
    return tuple(map(_as_tuples, value)) if isinstance(value, list) else value


def check_record(
    record: Record,
    leaves: Leaves,
    sizes: Mapping[str, int],
    ports: Mapping[str, BoundShape],
) -> None:
    """Raise `BlockError` unless a record is valid for these leaves and output ports."""
    shapes: list[BoundShape] = []
    for line, operation in enumerate(record.operations):
        shape = bound(operation.shape, sizes)
        valid = False
        with suppress(Exception):  # damaged data can raise anything
            arguments = [_argument_shape(ref, shapes) for ref in operation.arguments]
            valid = _is_valid(operation, shape, arguments, leaves)
        if prod(shape) > MAX_VALUE_SIZE or not valid:
            raise BlockError(
                f"line {line} of a record, {operation.kind!s:.20}, is none"
            )
        shapes.append(shape)
    count = sum(map(prod, shapes))
    if count > MAX_RECORD_SIZE:
        raise BlockError(
            f"a record has {count:.3g} numbers; at most {MAX_RECORD_SIZE:g} are allowed"
        )
    rows = zip(record.outputs, record.shapes, ports.values(), strict=True)
    for ref, shape, port_shape in rows:
        fits = _broadcasts(_argument_shape(ref, shapes), port_shape)
        if not fits or bound(shape, sizes) != port_shape:
            raise BlockError("an output of a record has another shape than its port")


def _argument_shape(ref: Any, shapes: Sequence[BoundShape]) -> BoundShape:
    if type(ref) is float:
        return ()
    if type(ref) is not int or ref not in range(len(shapes)):
        raise BlockError(
            f"a record refers to its value {ref!r:.20}, which is not defined yet"
        )
    return shapes[ref]


def _broadcasts(shape: BoundShape, target: BoundShape) -> bool:
    """Return True if NumPy broadcasts a shape to a target; raise ValueError or return False."""
    return shape == target or np.broadcast_shapes(shape, target) == target


def _is_valid(
    operation: Operation, shape: BoundShape, arguments: list[BoundShape], leaves: Leaves
) -> bool:
    """Return True if an operation has the arguments, data and shape of its kind."""
    kind, data = operation.kind, operation.at
    if kind == "leaf":
        group, name = data
        return not arguments and leaves[group][name] == shape
    if kind in RULES:
        return RULES[kind](data, shape, *arguments)
    count = 3 if kind == "where" else getattr(ELEMENTWISE[kind], "nin", 1)
    return len(arguments) == count and all(_broadcasts(a, shape) for a in arguments)


def _is_sum(axis: Any, shape: BoundShape, array: BoundShape) -> bool:
    if type(axis) is not int or axis not in range(len(array)):
        return False
    return array[:axis] + array[axis + 1 :] == shape


def _is_view(axes: Any, shape: BoundShape, array: BoundShape) -> bool:
    pairs = zip(axes, array, strict=True)
    return all(_is_inside(axis, length, shape) for axis, length in pairs)


def _is_inside(mapped: Any, length: int, shape: BoundShape) -> bool:
    """Return True if the indices of a view on one axis are inside that axis."""
    if type(mapped) is int:
        return mapped in range(length)
    axis, start, step = mapped
    if not all(type(n) is int for n in mapped) or axis not in range(len(shape)):
        return False
    ends = (start, start + step * (shape[axis] - 1))
    return not shape[axis] or all(end in range(length) for end in ends)


def _is_slice(offset: Any, shape: BoundShape, array: BoundShape) -> bool:
    if type(offset) is not int or not array:
        return False
    return 0 <= offset <= prod(array) - prod(shape)


# operations on whole arrays: (data, shape, *arguments) -> validity
RULES: dict[str, Callable[..., bool]] = {
    "constant": lambda numbers, shape: len(numbers) == 8 * prod(shape),
    "sum": _is_sum,
    "view": _is_view,
    "part": _is_slice,
    "search": lambda options, shape, table, values: (
        len(table) == 1 and values == shape and options[0] in ("left", "right")
    ),
    "fill": lambda _, shape, number: number == (),
    "stack": lambda _, shape, *arrays: (
        len(arrays) == shape[0] and all(_broadcasts(a, shape[1:]) for a in arrays)
    ),
    "join": lambda _, shape, *arrays: (
        sum(a[0] for a in arrays) == shape[0]
        and all(a[1:] == shape[1:] for a in arrays)
    ),
    "pick": lambda _, shape, row, index: len(row) == 1 and index == shape,
    "argmin": lambda _, shape, row: shape == () and len(row) == 1 and row[0] > 0,
}
