"""Scalar graph of a record: the elements of its arrays, each computed once.

    y_ij  of  v = add(a, b):  a_ij + b_ij        v = sum(a over 0):  a_0j + a_1j + ...

A subclass of `Elements` gives the type of an element: an expression (`symbolic`), a component
(`codegen.fused_expressions`) or the set of inputs that an element depends on (`InputsOf`).  Along
an axis of unknown length the index is a name.
"""

from collections.abc import Callable, Mapping, Sequence
from math import prod
from typing import Any

import numpy as np

from .graph import Operation, Record, Ref, Shape, bound, is_known
from .operations import ON_ROWS
from .unread import Unread

# an index of each axis: an int, a name, or (symbol, start, step) in `codegen.fused_expressions`
Index = tuple[Any, ...]
# elements of an array that are computed in order, so that nothing goes deep
MOST_AT_ONCE = 256
MOST = 300_000  # elements; more are given up


class Elements:
    """The elements of the values of a record or a tape."""

    most: float = MOST  # elements
    # methods of a subclass
    leaf: Callable[..., Any]  # an element of a leaf: (group, name), shape, index
    apply: Callable[..., Any]  # an operation on elements: ref, kind, arguments

    def __init__(
        self, operations: Sequence[Operation], sizes: Mapping[str, int] | None = None
    ):
        self.operations = operations
        self.sizes = sizes or {}
        self.values: dict[tuple[int, Index], Any] = {}

    # --- methods of a subclass --------------------------------------------------------------

    def number(self, value: float) -> Any:
        """Return a constant."""
        return value

    def sum_over(self, array: Ref, axis: int, index: Index, size: str) -> Any:
        """Return a sum over an axis of unknown length."""
        raise Unread(f"a sum over the open size {size}")

    # --- elements ---------------------------------------------------------------------------

    def outputs(self, record: Record) -> list[Any]:
        """Return the elements of a record's outputs, port by port, row by row."""
        for k in range(len(self.operations)):
            shape = self._shape_of(k)
            if prod(shape) <= MOST_AT_ONCE:
                for index in np.ndindex(shape):
                    self.at(k, index)
        elements = []
        for ref, declared in zip(record.outputs, record.shapes, strict=True):
            shape = bound(declared, self.sizes)
            elements += [self.at(ref, index) for index in np.ndindex(shape)]
        return elements

    def _shape_of(self, ref: int) -> Shape:
        return bound(self.operations[ref].shape, self.sizes)

    def at(self, ref: Ref, index: Index) -> Any:
        """Return one element; a shorter array is broadcast."""
        if type(ref) is float:
            return self.number(ref)
        key = ref, self.trimmed(ref, index)
        if key not in self.values:
            self.values[key] = self._element(*key)
            if len(self.values) > self.most:
                raise Unread(f"takes more than {MOST} operations on single numbers")
        return self.values[key]

    def trimmed(self, ref: int, index: Index) -> Index:
        """Return an index without the axes along which a value is broadcast."""
        shape = self._shape_of(ref)
        extra_axes = len(index) - len(shape)
        pairs = zip(index[extra_axes:], shape, strict=True)
        return tuple([0 if n == 1 else k for k, n in pairs])

    def source(self, ref: int, index: Index) -> tuple[Ref, Index] | None:
        """Return the value and index that an element is copied from; None if it is computed."""
        kind, arguments, shape, static = self.operations[ref]
        if kind == "view":
            return arguments[0], tuple(moved(axis, index) for axis in static)
        if kind == "fill":
            return arguments[0], ()
        if kind == "part":
            outer = self._shape_of(arguments[0])
            offset = static + np.ravel_multi_index(index, shape)
            position = np.unravel_index(offset, outer)
            return arguments[0], tuple(map(int, position))
        if kind not in ("stack", "join"):
            return None
        k, *inner_index = index
        if not isinstance(k, int):
            raise Unread("elements that differ along an axis of unknown length")
        if kind == "stack":
            return arguments[k], tuple(inner_index)
        for section in arguments:
            n = self._shape_of(section)[0]
            if k < n:
                return section, (k, *inner_index)
            k -= n
        raise IndexError(index)

    def _element(self, ref: int, index: Index) -> Any:
        kind, arguments, shape, static = self.operations[ref]
        if kind == "leaf":
            return self.leaf(static, bound(shape, self.sizes), index)
        if kind == "constant":
            numbers = np.frombuffer(static).reshape(shape)
            return self.number(float(numbers[index]))
        source = self.source(ref, index)
        if source is not None:
            return self.at(*source)
        if kind == "sum":
            return self._sum(ref, arguments[0], static, index)
        single = arguments[kind in ON_ROWS :]
        elements = [self.at(argument, index) for argument in single]
        if kind in ("pick", "argmin"):
            elements += self.all_of(arguments[0])
        return self.apply(ref, kind, tuple(elements))

    def all_of(self, ref: Ref) -> list[Any]:
        """Return every element of a value."""
        shape = () if type(ref) is float else self._shape_of(ref)
        if not is_known(shape):
            raise Unread("every element of an array of unknown length")
        return [self.at(ref, index) for index in np.ndindex(*shape)]

    def _sum(self, ref: int, array: Ref, axis: int, index: Index) -> Any:
        size = self._shape_of(array)[axis]
        if not isinstance(size, int):
            return self.sum_over(array, axis, index, size)
        if size == 0:
            return self.number(0.0)
        before = index[:axis]
        after = index[axis:]
        summands = [self.at(array, (*before, k, *after)) for k in range(size)]
        return self.apply(ref, "sum", tuple(summands))


def moved(axis: Any, index: Index) -> Any:
    """Return the index in an array, along one of its axes, of an element or view of a view."""
    if isinstance(axis, int):
        return axis
    view_axis, start, step = axis
    position = index[view_axis]
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
    """Inputs that each element depends on, as (port, index); a product with 0 depends on none."""

    def outputs(self, record: Record) -> list[Any]:
        """Return the inputs that the elements of a record's outputs depend on."""
        return [inputs - ZERO for inputs in super().outputs(record)]

    def number(self, value: float) -> Any:
        """Depend on nothing."""
        return ZERO if value == 0.0 else frozenset()

    def leaf(self, key: tuple[str, str], shape: Shape, index: Index) -> Any:
        """Depend on the input itself."""
        position = int(np.ravel_multi_index(index, shape)) if shape else 0
        group, name = key
        return frozenset([(name, position)] if group == "u" else [])

    def apply(self, ref: int, kind: str, arguments: tuple) -> Any:
        """Depend on all inputs of the arguments."""
        if kind == "mul" and ZERO in arguments:
            return ZERO
        return frozenset().union(*arguments) - ZERO
