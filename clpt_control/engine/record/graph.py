"""The record of a function: what it does to arrays, in single assignment.

    v0 = leaf t                 ()
    v1 = leaf x.alpha           (2, N)
    v2 = view v1[0, :]          (N,)
    v3 = mul(v0, v2)            (N,)
    v4 = sum(v3, axis 0)        ()

An operation is a kind, its arguments, the shape of its value and what else it is made with.
An argument is a value (int: its place in the list) or a constant (float).  An axis is as long
as a number says, or as a name: ``"N"`` is a size that the record leaves open.

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
| search | sorted row of numbers, value | side, and what is at the joints (`lookup_tables`) |
| argmin | row of numbers | |

`computed` is a record on NumPy's numbers, in the order in which it was written.
"""

import sys
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cached_property
from math import copysign, erf, erfc, prod
from typing import Any, NamedTuple

import numpy as np

MOST_NUMBERS = 20_000  # of an array that is a value, and is compared with what it was
Ref = Any  # int: the place of a value; float: a constant
Shape = tuple[Any, ...]  # of whole numbers and names of sizes


def key_of(ref: Ref) -> Any:
    """Return what tells arguments apart: 0.0 is not -0.0, 1.0 not the value 1."""
    return (ref, copysign(1.0, ref)) if type(ref) is float else ref


class Operation(NamedTuple):
    """One line of a record."""

    kind: str
    arguments: tuple[Ref, ...]
    shape: Shape
    at: Any = None


@dataclass(frozen=True, eq=False)
class Record:
    """What a function did to arrays; equal records have the same machine code."""

    operations: tuple[Operation, ...]
    outputs: tuple[Ref, ...]  # one for each port
    shapes: tuple[Shape, ...]  # of the ports; an output of fewer axes is broadcast

    @cached_property
    def _key(self) -> tuple:
        lines = [(o.kind, tuple(map(key_of, o.arguments)), o.shape, o.at) for o in self.operations]
        return tuple(lines), tuple(map(key_of, self.outputs)), self.shapes

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Record) and self._key == other._key

    def __hash__(self) -> int:
        return hash(self._key)

    def leaves(self, group: str) -> list[str]:
        """Return the names of the leaves of a group that outputs depend on."""
        names = [o.at[1] for o in self.operations if o.kind == "leaf" and o.at[0] == group]
        return list(dict.fromkeys(names))

    def values(self, leaf: Callable[[str, str], Any], sizes: dict[str, int]) -> list[np.ndarray]:
        """Compute the outputs in NumPy; ``leaf("x", "alpha")`` is an array."""
        outputs = computed(self, lambda *at: np.asarray(leaf(*at))[..., None], sizes)
        return [value[..., 0] for value in outputs]

    def renamed(self, names: dict[tuple[str, str], tuple[str, str]]) -> "Record":
        """Return the record with other leaves: {(group, name): (group, name)}."""
        moved = [
            o._replace(at=names.get(o.at, o.at)) if o.kind == "leaf" else o for o in self.operations
        ]
        return Record(tuple(moved), self.outputs, self.shapes)


def bound(shape: Shape, sizes: Mapping[str, int]) -> Shape:
    """Return a shape with the sizes that are known in the place of their names."""
    return tuple([sizes.get(n, n) for n in shape])


@contextmanager
def deep() -> Iterator[None]:
    """Allow recursion as deep as records are."""
    before = sys.getrecursionlimit()
    sys.setrecursionlimit(max(before, 1_000_000))
    try:
        yield
    finally:
        sys.setrecursionlimit(before)


def reached(operations: Iterable[Any], roots: Iterable[Ref]) -> set[int]:
    """Return the values that roots depend on."""
    lines = operations if isinstance(operations, list | tuple) else list(operations)
    found: set[int] = set()
    stack = [root for root in roots if type(root) is int]
    while stack:
        value = stack.pop()
        if value not in found:
            found.add(value)
            stack += [a for a in lines[value].arguments if type(a) is int and a not in found]
    return found


def compact(
    operations: list[Operation], outputs: list[Ref], shapes: Iterable[Shape] | None = None
) -> Record:
    """Return the record of these outputs: only what they depend on."""
    used = sorted(reached(operations, outputs))
    place = {old: new for new, old in enumerate(used)}
    lines = []
    for k in used:
        kind, arguments, shape, at = operations[k]
        moved = tuple([place[a] if type(a) is int else a for a in arguments])
        lines.append(Operation(kind, moved, shape, at))
    of_outputs = [operations[r].shape if type(r) is int else () for r in outputs]
    refs = tuple([place[r] if type(r) is int else r for r in outputs])
    return Record(tuple(lines), refs, tuple(of_outputs if shapes is None else shapes))


# --- on numbers --------------------------------------------------------------------------------


MOST_ANGLE = 2.0**50  # rad; beyond it doubles are a quarter apart and an angle means nothing

UFUNCS: dict[Any, str] = {
    np.add: "add",
    np.subtract: "sub",
    np.multiply: "mul",
    np.true_divide: "div",
    np.floor_divide: "floordiv",
    np.remainder: "mod",
    np.float_power: "pow",
    np.negative: "neg",
    np.absolute: "fabs",
    np.less: "lt",
    np.less_equal: "le",
    np.greater: "gt",
    np.greater_equal: "ge",
    np.equal: "eq",
    np.not_equal: "ne",
    np.logical_and: "and",
    np.logical_or: "or",
    np.logical_not: "not",
    **{
        getattr(np, name): name
        for name in (
            *("exp", "expm1", "log", "log1p", "log2", "log10", "sqrt", "pow", "hypot"),
            *("sin", "cos", "tan", "asin", "acos", "atan", "atan2", "sinh", "cosh", "tanh"),
            *("asinh", "acosh", "atanh", "minimum", "maximum", "sign", "floor", "ceil", "trunc"),
        )
    },
}


def picked(numbers: np.ndarray, index: Any) -> np.ndarray:
    """Return numbers of a row at whole places, NaN outside; of rows side by side, each its own."""
    if not len(numbers):
        return np.full(np.shape(index), np.nan)
    whole = np.trunc(index)
    whole = np.where(whole < 0, whole + len(numbers), whole)
    inside = (whole >= 0) & (whole < len(numbers))
    side_by_side = [np.arange(n) for n in numbers.shape[1:]]
    return np.where(inside, numbers[np.where(inside, whole, 0).astype(int), *side_by_side], np.nan)


def searched(row: np.ndarray, values: Any, side: Any) -> np.ndarray:
    """Return how many numbers of a sorted row, of shape (n, 1), are below values, or equal."""
    return np.where(np.isnan(values), 0, np.searchsorted(row[:, 0], values, side))


def _circular(function: Callable) -> Callable:
    return lambda a: function(np.where(np.abs(a) < MOST_ANGLE, a, np.nan))


OPERATIONS: dict[str, Callable[..., Any]] = {
    **{name: ufunc for ufunc, name in UFUNCS.items()},
    "where": np.where,
    **{one.__name__: np.vectorize(one, otypes=[float]) for one in (erf, erfc)},
    **{one.__name__: _circular(one) for one in (np.sin, np.cos, np.tan)},
}


def viewed(array: np.ndarray, mapped: tuple, shape: tuple[int, ...]) -> np.ndarray:
    """Return a view: what `mapped` says of each axis of an array."""
    if 0 in shape:
        return np.zeros(shape)
    first = array[tuple([m if isinstance(m, int) else slice(m[1], None) for m in mapped])]
    strides = [0] * len(shape)
    kept = zip((m for m in mapped if not isinstance(m, int)), first.strides, strict=True)
    for (axis, _, step), stride in kept:
        strides[axis] += step * stride
    return np.lib.stride_tricks.as_strided(first, shape, strides, writeable=False)


def computed(
    record: Any, leaf: Callable[[str, str], Any], sizes: Mapping[str, int]
) -> list[np.ndarray]:
    """Compute the outputs of a record; `leaf` gives the array of a group and name.

    All arrays have one more axis, the last: what is computed for each, or 1.
    """
    values: list[np.ndarray] = []

    def sized(shape: tuple, value: Any) -> tuple[int, ...]:
        """Return a shape with its open sizes filled in, and the last axis of a value."""
        return *bound(shape, sizes), *(np.shape(value)[-1:] or (1,))

    def full(value: Any, shape: tuple) -> np.ndarray:
        """Return a value in all of its shape."""
        return np.broadcast_to(value, sized(shape, value))

    with np.errstate(all="ignore"):
        for kind, arguments, shape, at in record.operations:
            args: list[Any] = [values[a] if type(a) is int else np.array([a]) for a in arguments]
            value: Any
            if kind == "leaf":
                value = np.asarray(leaf(*at))
            elif kind == "constant":
                value = np.frombuffer(at).reshape((*shape, 1))
            elif kind == "sum":
                value = np.sum(args[0], axis=at)
            elif kind == "view":
                value = viewed(args[0], (*at, (len(shape), 0, 1)), sized(shape, args[0]))
            elif kind == "stack":
                value = np.stack(np.broadcast_arrays(*args))
            elif kind == "join":
                count = max(a.shape[-1] for a in args)
                value = np.concatenate([np.broadcast_to(a, (*a.shape[:-1], count)) for a in args])
            elif kind == "part":
                elements = args[0].reshape(-1, args[0].shape[-1])[at : at + prod(shape)]
                value = elements.reshape(*shape, -1)
            elif kind == "pick":
                value = picked(args[0], args[1])
            elif kind == "search":
                value = searched(args[0], args[1], at[0])
            elif kind == "argmin":
                value = np.argmin(args[0], axis=0)
            elif kind == "fill":
                value = args[0]
            else:
                value = OPERATIONS[kind](*args)
            values.append(full(value, shape))
    outputs = zip(record.outputs, record.shapes, strict=True)
    return [full(values[r] if type(r) is int else r, shape).astype(float) for r, shape in outputs]
