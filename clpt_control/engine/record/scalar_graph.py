"""The elements of a record's arrays, each computed once.

    y_ij  of  v = add(a, b):  a_ij + b_ij        v = sum(a over 0):  a_0j + a_1j + ...

What an element is, the reading says: an expression (`symbolic`), the inputs that it depends on,
a number of another library.  Along an axis of unknown length the place is a name (`symbolic`).
"""

from collections.abc import Mapping, Sequence
from math import prod
from typing import Any

import numpy as np

from ..trace.arrays import Unread
from .graph import Operation, Record, Ref, Shape, bound

# places; a name is a generic one, and so is (symbol, start, step), which `native.components` has
Index = tuple[Any, ...]
MOST_AT_ONCE = 256  # elements of an array that are computed in order, so that nothing goes deep
MOST = 300_000  # elements; more are given up


class Elements:
    """The elements of the values of a record or a tape."""

    most: float = MOST  # elements

    def __init__(self, operations: Sequence[Operation], sizes: Mapping[str, int] | None = None):
        self.operations = operations
        self.sizes = sizes or {}
        self.known: dict[tuple[int, Index], Any] = {}

    # --- what a reading says ----------------------------------------------------------------

    def number(self, value: float) -> Any:
        """Return a constant."""
        return value

    def leaf(self, at: tuple[str, str], shape: Shape, index: Index) -> Any:
        """Return an element of a leaf."""
        raise NotImplementedError

    def apply(self, ref: int, kind: str, arguments: tuple) -> Any:
        """Return what an operation makes of elements."""
        raise NotImplementedError

    def sum_over(self, array: Ref, axis: int, index: Index, size: str) -> Any:
        """Return a sum over an axis of unknown length."""
        raise Unread(f"a sum over the open size {size}")

    # --- elements ---------------------------------------------------------------------------

    def outputs(self, record: Record) -> list[Any]:
        """Return the elements of a record's outputs, port by port, row by row."""
        for k, operation in enumerate(self.operations):
            shape = bound(operation.shape, self.sizes)
            if prod(shape) <= MOST_AT_ONCE:
                for index in np.ndindex(shape):
                    self.at(k, index)
        shapes = [bound(shape, self.sizes) for shape in record.shapes]
        pairs = zip(record.outputs, shapes, strict=True)
        return [self.at(ref, index) for ref, shape in pairs for index in np.ndindex(shape)]

    def at(self, ref: Ref, index: Index) -> Any:
        """Return one element; a shorter array is broadcast."""
        if type(ref) is float:
            return self.number(ref)
        index = self.trimmed(ref, index)
        if (ref, index) not in self.known:
            self.known[ref, index] = self._element(ref, index)
            if len(self.known) > self.most:
                raise Unread(f"takes more than {MOST} operations on single numbers")
        return self.known[ref, index]

    def trimmed(self, ref: int, index: Index) -> Index:
        """Return an index without the axes along which a value is broadcast."""
        shape = bound(self.operations[ref].shape, self.sizes)
        index = index[len(index) - len(shape) :]
        return tuple([0 if n == 1 else k for k, n in zip(index, shape, strict=True)])

    def source(self, ref: int, index: Index) -> tuple[Ref, Index] | None:
        """Return which element of another value an element is; None where it is computed."""
        kind, arguments, shape, at = self.operations[ref]
        if kind == "view":
            return arguments[0], tuple([_moved(m, index) for m in at])
        if kind == "fill":
            return arguments[0], ()
        if kind == "part":
            outer = bound(self.operations[arguments[0]].shape, self.sizes)
            position = np.unravel_index(at + np.ravel_multi_index(index, shape), outer)
            return arguments[0], tuple(map(int, position))
        if kind not in ("stack", "join"):
            return None
        k, *inner_index = index
        if not isinstance(k, int):
            raise Unread("elements that differ along an axis of unknown length")
        if kind == "stack":
            return arguments[k], tuple(inner_index)
        for section in arguments:
            n = bound(self.operations[section].shape, self.sizes)[0]
            if k < n:
                return section, (k, *inner_index)
            k -= n
        raise IndexError(index)

    def _element(self, ref: int, index: Index) -> Any:
        kind, arguments, shape, at = self.operations[ref]
        if kind == "leaf":
            return self.leaf(at, bound(shape, self.sizes), index)
        if kind == "constant":
            return self.number(float(np.frombuffer(at).reshape(shape)[index]))
        if (source := self.source(ref, index)) is not None:
            return self.at(*source)
        if kind == "sum":
            return self._sum(ref, arguments[0], at, index)
        if kind == "pick":
            position = self.at(arguments[1], index)
            return self.apply(ref, kind, (position, *self.all_of(arguments[0])))
        if kind == "search":
            return self.apply(ref, kind, (self.at(arguments[1], index),))
        if kind == "argmin":
            return self.apply(ref, kind, tuple(self.all_of(arguments[0])))
        return self.apply(ref, kind, tuple([self.at(a, index) for a in arguments]))

    def all_of(self, ref: Ref) -> list[Any]:
        """Return every element of a value."""
        shape = () if type(ref) is float else bound(self.operations[ref].shape, self.sizes)
        if not all(isinstance(n, int) for n in shape):
            raise Unread("every element of an array of unknown length")
        return [self.at(ref, index) for index in np.ndindex(*shape)]

    def _sum(self, ref: int, array: Ref, axis: int, index: Index) -> Any:
        size = bound(self.operations[array].shape, self.sizes)[axis]
        if not isinstance(size, int):
            return self.sum_over(array, axis, index, size)
        summands = [self.at(array, (*index[:axis], k, *index[axis:])) for k in range(size)]
        return self.apply(ref, "sum", tuple(summands)) if summands else self.number(0.0)


def _moved(m: Any, index: Index) -> Any:
    """Return where an element of a view lies along one axis of the array."""
    if isinstance(m, int):
        return m
    d, start, step = m
    position = index[d]
    if isinstance(position, int):
        return start + step * position
    if isinstance(position, tuple):
        symbol, offset, every = position
        return symbol, start + step * offset, step * every
    if (start, step) != (0, 1):
        raise Unread("a part of an axis of unknown length")
    return position


ZERO = frozenset(["0"])


class InputsOf(Elements):
    """The inputs that each element depends on: port and place in it.

    What is multiplied by a constant 0 depends on nothing.
    """

    def outputs(self, record: Record) -> list[Any]:
        """Return what the elements of a record's outputs depend on."""
        return [inputs - ZERO for inputs in super().outputs(record)]

    def number(self, value: float) -> Any:
        """Depend on nothing."""
        return ZERO if value == 0.0 else frozenset()

    def leaf(self, at: tuple[str, str], shape: Shape, index: Index) -> Any:
        """Depend on the input itself."""
        position = int(np.ravel_multi_index(index, shape)) if shape else 0
        return frozenset([(at[1], position)] if at[0] == "u" else [])

    def apply(self, ref: int, kind: str, arguments: tuple) -> Any:
        """Depend on all that the arguments depend on."""
        if kind == "mul" and ZERO in arguments:
            return ZERO
        return frozenset().union(*arguments) - ZERO
