"""Record of a function: its array operations, in single assignment.

    v0 = leaf t                 ()
    v1 = leaf x.alpha           (2, N)
    v2 = view v1[0, :]          (N,)
    v3 = mul(v0, v2)            (N,)
    v4 = sum(v3, axis 0)        ()

An operation has a kind, arguments, the shape of its value and further attributes, `at`.
An argument is a value (int: its index in the list) or a constant (float).  The length of an axis is
a number, or the name of an open size, ``"N"``.

| kind | arguments | `at` |
|---|---|---|
| leaf | | group (t, x, u, p) and name |
| constant | | its numbers, as bytes of doubles |
| an elementwise one: add, exp, where, ... | each broadcast to the shape | |
| sum | array | axis |
| view | array | for each of its axes an index, or (axis of the view, start, step) |
| fill | number | the number everywhere, of the operation's shape | |
| stack | arrays of one shape | along a new first axis |
| join | arrays | one behind the other, along the first axis |
| part | array | first of the elements, row by row, that the shape takes |
| pick | row of numbers, index | the number at a whole place; NaN outside |
| search | sorted row of numbers, value | side, and what is at the joints (`interpolators`) |
| argmin | row of numbers | |

`evaluated` computes a record in NumPy, in the order in which it was written.
"""

import sys
from collections.abc import Callable, Container, Iterable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cached_property
from math import copysign, prod
from typing import Any, NamedTuple

import numpy as np

from .operations import COMPARISONS, ELEMENTWISE

MOST_NUMBERS = 20_000  # of an array that is a value, and is compared with what it was
MOST_CONDITIONS = 128  # of the comparisons of a record
PIVOT = "pivot"  # `at` of a comparison that chooses a pivot
Ref = Any  # int: the place of a value; float: a constant
Shape = tuple[Any, ...]  # of whole numbers and names of sizes


def key_of(ref: Ref) -> Any:
    """Return what tells arguments apart: 0.0 is not -0.0, 1.0 not the value 1; NaN is NaN."""
    if type(ref) is not float:
        return ref
    return (ref if ref == ref else "NaN", copysign(1.0, ref))


class Operation(NamedTuple):
    """One line of a record."""

    kind: str
    arguments: tuple[Ref, ...]
    shape: Shape
    at: Any = None


@dataclass(frozen=True, eq=False)
class Record:
    """Operations of a function on arrays; equal records have the same machine code."""

    operations: tuple[Operation, ...]
    outputs: tuple[Ref, ...]  # one for each port
    shapes: tuple[Shape, ...]  # of the ports; an output of fewer axes is broadcast

    @cached_property
    def _key(self) -> tuple:
        lines = tuple(
            operation._replace(arguments=tuple(map(key_of, operation.arguments)))
            for operation in self.operations
        )
        return lines, tuple(map(key_of, self.outputs)), self.shapes

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Record) and self._key == other._key

    def __hash__(self) -> int:
        return hash(self._key)

    def leaves(self, group: str) -> list[str]:
        """Return the names of the leaves of a group that outputs depend on."""
        leaves = (line.at for line in self.operations if line.kind == "leaf")
        return [*dict.fromkeys(name for of_group, name in leaves if of_group == group)]

    def renamed(self, names: dict[tuple[str, str], tuple[str, str]]) -> "Record":
        """Return the record with other leaves: {(group, name): (group, name)}."""
        operations = tuple(
            operation._replace(at=names.get(operation.at, operation.at))
            if operation.kind == "leaf"
            else operation
            for operation in self.operations
        )
        return Record(operations, self.outputs, self.shapes)


def bound(shape: Shape, sizes: Mapping[str, int]) -> Shape:
    """Return a shape with the sizes that are known in the place of their names."""
    return tuple([sizes.get(n, n) for n in shape])


def is_known(shape: Shape) -> bool:
    """Return whether all sizes of a shape are numbers."""
    return all(isinstance(n, int) for n in shape)


def never_negative(record: Record, ref: Ref) -> bool:
    """Return whether a value is seen to be 0 or above at all times: max(a, 0), where(c, 1, 0)."""
    if type(ref) is float:
        return ref >= 0.0
    kind, arguments, *_ = record.operations[ref]
    if kind == "fabs":
        return True
    values = arguments[1:] if kind == "where" else arguments
    above = (never_negative(record, value) for value in values)
    if kind == "maximum":
        return any(above)
    return kind in ("where", "minimum", "add", "mul", "view") and all(above)


@contextmanager
def deep() -> Iterator[None]:
    """Allow recursion as deep as records are."""
    before = sys.getrecursionlimit()
    sys.setrecursionlimit(max(before, 1_000_000))
    try:
        yield
    finally:
        sys.setrecursionlimit(before)


def values_among(refs: Iterable[Ref]) -> list[int]:
    """Return the references that are no constants."""
    return [ref for ref in refs if type(ref) is int]


def reached(
    operations: Iterable[Any], roots: Iterable[Ref], known: Container[int] = ()
) -> set[int]:
    """Return the values that roots depend on, except known ones and what these depend on."""
    lines = operations if isinstance(operations, list | tuple) else list(operations)
    values = set()
    stack = values_among(roots)
    while stack:
        value = stack.pop()
        if value not in values and value not in known:
            values.add(value)
            arguments = values_among(lines[value].arguments)
            stack += [a for a in arguments if a not in values]
    return values


def compact(
    operations: list[Operation],
    outputs: list[Ref],
    shapes: Iterable[Shape] | None = None,
) -> Record:
    """Return the record of these outputs: only what they depend on."""
    used = sorted(reached(operations, outputs))
    position = {old: new for new, old in enumerate(used)}

    def moved(refs: Iterable[Ref]) -> tuple[Ref, ...]:
        return tuple([position[ref] if type(ref) is int else ref for ref in refs])

    lines = tuple(
        operations[k]._replace(arguments=moved(operations[k].arguments)) for k in used
    )
    if shapes is None:
        shapes = [operations[ref].shape if type(ref) is int else () for ref in outputs]
    return Record(lines, moved(outputs), tuple(shapes))


def conditions_of(operations: list[Operation], refs: Iterable[Ref]) -> Record:
    """Return the record of the comparisons that values of a record depend on."""
    used = sorted(reached(operations, refs))
    comparisons = [k for k in used if operations[k].kind in COMPARISONS]
    return compact(operations, comparisons[:MOST_CONDITIONS])


def replayed(
    record: Record, leaf: Callable[..., Ref], put: Callable[[Operation, list[Ref]], Ref]
) -> list[Ref]:
    """Write a record again; return its outputs.

    ``leaf(group, name, shape)`` is another value for a leaf, ``put(operation, arguments)`` writes.
    """
    values: list[Ref] = []
    for operation in record.operations:
        refs = [values[a] if type(a) is int else a for a in operation.arguments]
        is_leaf = operation.kind == "leaf"
        values.append(
            leaf(*operation.at, operation.shape) if is_leaf else put(operation, refs)
        )
    return [values[ref] if type(ref) is int else ref for ref in record.outputs]


# --- on numbers --------------------------------------------------------------------------------


def picked(numbers: np.ndarray, index: Any) -> np.ndarray:
    """Return numbers of a row at integer indices, NaN outside; columns are separate rows."""
    if not len(numbers):
        return np.full(np.shape(index), np.nan)
    count = len(numbers)
    positions = np.trunc(index)
    from_end = positions < 0
    positions = np.where(from_end, positions + count, positions)
    inside = (positions >= 0) & (positions < count)
    rows = [np.arange(n) for n in numbers.shape[1:]]
    inner = np.where(inside, positions, 0).astype(int)
    picked_numbers = numbers[inner, *rows]
    return np.where(inside, picked_numbers, np.nan)


def searched(row: np.ndarray, values: Any, from_side: Any) -> np.ndarray:
    """Return how many numbers of a sorted row, of shape (n, 1), are below values, or equal."""
    positions = np.searchsorted(row[:, 0], values, from_side)
    return np.where(np.isnan(values), 0, positions)


def viewed(array: np.ndarray, mapped: tuple, shape: tuple[int, ...]) -> np.ndarray:
    """Return a view; `mapped` has an index, or (axis of the view, start, step), for each axis."""
    if 0 in shape:
        return np.zeros(shape)
    begins = [m if isinstance(m, int) else slice(m[1], None) for m in mapped]
    corner = array[tuple(begins)]
    axes = [m for m in mapped if not isinstance(m, int)]
    strides = [0] * len(shape)
    for (axis, _, step), stride in zip(axes, corner.strides, strict=True):
        strides[axis] += step * stride
    return np.lib.stride_tricks.as_strided(corner, shape, strides, writeable=False)


def evaluated(
    record: Record,
    leaf: Callable[[Any, Any], Any],
    sizes: Mapping[str, int] = {},
    points: int = 1,
) -> np.ndarray:
    """Return the outputs of a record at several points, a row for each element.

    ``leaf("x", "alpha")`` returns the array of a leaf, with a last axis for the points: as long as
    their number, or 1.
    """

    def sized(shape: Shape, value: Any) -> tuple[int, ...]:
        """Return a shape with its open sizes filled in, and the last axis of a value."""
        return *bound(shape, sizes), *(np.shape(value)[-1:] or (1,))

    values: list[np.ndarray] = []

    def value_of(ref: Ref) -> np.ndarray:
        return values[ref] if type(ref) is int else np.array([ref])

    with np.errstate(all="ignore"):
        for operation in record.operations:
            kind, refs, shape, at = operation
            arguments = [value_of(ref) for ref in refs]
            if kind == "leaf":
                value = np.asarray(leaf(*at))
            elif kind == "view":
                array = arguments[0]
                axes = *at, (len(shape), 0, 1)
                value = viewed(array, axes, sized(shape, array))
            elif kind in ARRAY_OPERATIONS:
                value = ARRAY_OPERATIONS[kind](operation, *arguments)
            else:
                value = ELEMENTWISE[kind](*arguments)
            size = sized(shape, value)
            values.append(
                value if np.shape(value) == size else np.broadcast_to(value, size)
            )
    rows = [np.zeros((0, points))]
    for ref, shape in zip(record.outputs, record.shapes, strict=True):
        elements = np.broadcast_to(value_of(ref), (*bound(shape, sizes), points))
        rows.append(elements.reshape(-1, points))
    return np.concatenate(rows)


def _joined(_: Operation, *arrays: np.ndarray) -> np.ndarray:
    points = max(array.shape[-1] for array in arrays)
    shapes = [(*array.shape[:-1], points) for array in arrays]
    return np.concatenate(list(map(np.broadcast_to, arrays, shapes)))


def _section(operation: Operation, array: np.ndarray) -> np.ndarray:
    start = operation.at
    stop = start + prod(operation.shape)
    rows = array.reshape(-1, array.shape[-1])
    elements = rows[start:stop]
    return elements.reshape(*operation.shape, -1)


# operations on whole arrays: operation, arguments -> value
ARRAY_OPERATIONS: dict[str, Callable[..., Any]] = {
    "constant": lambda operation: np.frombuffer(operation.at).reshape(
        (*operation.shape, 1)
    ),
    "sum": lambda operation, array: np.sum(array, axis=operation.at),
    "fill": lambda _, number: number,
    "stack": lambda _, *arrays: np.stack(np.broadcast_arrays(*arrays)),
    "join": _joined,
    "part": _section,
    "pick": lambda _, row, index: picked(row, index),
    "search": lambda operation, row, values: searched(row, values, operation.at[0]),
    "argmin": lambda _, row: np.argmin(row, axis=0),
}
