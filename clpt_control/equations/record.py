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
| pick | row of numbers, index | the number at a whole place; NaN outside |
| opaque | value, arguments | name: SymPy reads a function of the arguments |
"""

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from math import copysign
from typing import Any, NamedTuple

import numpy as np

from .numbers import computed

Ref = Any  # int: the place of a value; float: a constant
Shape = tuple[Any, ...]  # of whole numbers and names of sizes


class Operation(NamedTuple):
    """One line of a record."""

    kind: str
    arguments: tuple[Ref, ...]
    shape: Shape
    at: Any = None


@dataclass(frozen=True)
class Record:
    """What a function did to arrays."""

    operations: tuple[Operation, ...]
    outputs: tuple[Ref, ...]  # one for each port
    shapes: tuple[Shape, ...]  # of the ports; an output of fewer axes is broadcast

    def leaves(self, group: str) -> list[str]:
        """Return the names of the leaves of a group that outputs depend on."""
        found = [o.at[1] for o in self.operations if o.kind == "leaf" and o.at[0] == group]
        return list(dict.fromkeys(found))

    def values(self, leaf: Callable[[str, str], Any], sizes: dict[str, int]) -> list[np.ndarray]:
        """Compute the outputs in NumPy; ``leaf("x", "alpha")`` is an array."""
        found = computed(self, lambda *at: np.asarray(leaf(*at))[..., None], sizes)
        return [value[..., 0] for value in found]

    def renamed(self, names: dict[tuple[str, str], tuple[str, str]]) -> "Record":
        """Return the record with other leaves: {(group, name): (group, name)}."""
        moved = [
            o._replace(at=names.get(o.at, o.at)) if o.kind == "leaf" else o for o in self.operations
        ]
        return Record(tuple(moved), self.outputs, self.shapes)


def key_of(ref: Ref) -> Any:
    """Return what tells arguments apart: 0.0 is not -0.0, 1.0 not the value 1."""
    return (ref, copysign(1.0, ref)) if type(ref) is float else ref


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
    own = [operations[r].shape if type(r) is int else () for r in outputs]
    return Record(
        tuple(lines),
        tuple([place[r] if type(r) is int else r for r in outputs]),
        tuple(own if shapes is None else shapes),
    )
