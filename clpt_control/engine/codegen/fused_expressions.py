"""Fused expressions: the scalar operations of a diagram, with long axes as loops.

    add(load X[4 + k], load P[9 + k])        one component, of the axis k of length 50

A component is an operation, its arguments and the lengths of its axes.  A short axis of an array is
unrolled: each of its elements is a component.  A long axis becomes an axis of a single component.
Equal components are stored once.  An argument is a constant or (component, axes): `axes` has the
number of each of its axes in the new component, or `BOUND` for the axis of a sum.  During
construction an axis is a symbol (length, number) and an index is (symbol, start, step).
"""

from collections.abc import Callable, Iterable, Iterator
from functools import partial, reduce
from itertools import count, product
from math import inf, prod
from typing import Any, NamedTuple

import numpy as np

from ...base.errors import Uncompiled
from ..record.graph import Operation, key_of
from ..record.operations import CONDITIONS, LOGICAL, ON_ROWS, named
from ..record.scalar_graph import Elements
from .diagram_record import LARGE, Ref
from .switching_conditions import Port

MOST = 60_000  # components; a larger diagram runs in Python
BOUND = -1
MOST_POWER = 8.0  # the largest exponent of a power that is products
# a function each, printed once a module
OUT_OF_LINE = named(lambda row: row.numpy and row.llvm == "function")
LIBRARY = named(lambda row: row.llvm == "libm")
LONG = OUT_OF_LINE | LIBRARY | ON_ROWS | {"div", "sqrt"}  # costly
Symbol = tuple[int, int]
Loops = tuple[int, ...]  # a number of each loop, the outermost first
Index = Any  # a whole number, or (symbol, start, step)
Value = Any  # a constant, or (component, symbols)
Element = Callable[[Ref, tuple], Value]


class Component(NamedTuple):
    """One operation on elements; of a load the arguments are array, first place and strides."""

    name: str
    arguments: tuple
    lengths: Loops


class Write(NamedTuple):
    """array[first + strides * indices] = value, or the sum of values over the innermost loop."""

    array: str
    first: int
    strides: Loops
    lengths: Loops  # of the loops
    value: Value
    saves: int = -1  # the component that is read from there from now on
    summed: bool = False


class Components(Elements):
    """The elements of a diagram's record that its functions need, each once.

    From place `prepared` on, P has room for what is computed once a piece of time; where it is None
    nothing is prepared.
    """

    most = inf

    def __init__(self, record: Any, room: int, prepared: int | None = None):
        super().__init__(record.entries)
        self.record = record
        self.all: list[Component] = []
        self.preparing = prepared is not None
        self.steady: list[bool] = []  # depends on parameters alone, and is prepared
        self.room = room  # next free offset in W
        self.prepared = prepared or 0  # next free offset in P
        self.constants: list[float] = []  # K
        self.tables: list[np.ndarray] = []  # behind the numbers in T
        self.buffers: dict[
            int, list[Write]
        ] = {}  # arrays that are written before they are read
        self._indices: dict[Any, int] = {}
        self._arrays: dict[
            Any, tuple[str, int, int]
        ] = {}  # entry -> array, offset, buffer or -1

    # --- components -----------------------------------------------------------------------

    def add(self, name: str, *values: Value, bound: Symbol | None = None) -> Value:
        """Return the component of an operation."""
        computed = [value for value in values if type(value) is tuple]
        axes = [symbol for _, symbols in computed for symbol in symbols]
        free_axes = [symbol for symbol in axes if symbol != bound]
        symbols = tuple(dict.fromkeys(free_axes))
        axis_numbers = {symbol: k for k, symbol in enumerate(symbols)}
        axis_numbers[bound] = BOUND
        arguments = [with_axes(value, axis_numbers) for value in values]
        if bound is not None:
            arguments.append(bound[0])
        steady = all(self.steady[component] for component, _ in computed)
        lengths = tuple([length for length, _ in symbols])
        component = Component(name, tuple(arguments), lengths)
        return self._index_of(component, steady), symbols

    def _index_of(self, component: Component, steady: bool) -> int:
        key = component._replace(arguments=tuple(map(key_of, component.arguments)))
        if key not in self._indices:
            self._indices[key] = len(self.all)
            self.all.append(component)
            self.steady.append(steady and self.preparing)
            if len(self.all) > MOST:
                raise Uncompiled(
                    f"the diagram takes more than {MOST} operations apart from loops: write what "
                    "repeats as operations on arrays"
                )
        return self._indices[key]

    def load(
        self,
        array: str,
        offset: int,
        terms: Iterable[tuple[Index, int]],
        buffer: int = -1,
    ) -> Value:
        """Return array[offset + sum of stride * index]; `buffer` is -1 for other arrays."""
        offset, strides = _strides(offset, terms)
        lengths = tuple([length for length, _ in strides])
        arguments = array, offset, tuple(strides.values()), buffer
        component = Component("load", arguments, lengths)
        return self._index_of(component, array in "PTK"), tuple(strides)

    # --- elements of entries --------------------------------------------------------------

    def source(self, ref: int, index: tuple[Index, ...]) -> tuple[Ref, tuple] | None:
        """Return which element of another value an element is; None where it is computed."""
        kind = self.operations[ref].kind
        if kind in ("stack", "join") and type(index[0]) is not int:
            return None
        if kind == "part" and not all(type(i) is int for i in index):
            return None
        return super().source(ref, index)

    def _element(self, ref: int, index: tuple[Index, ...]) -> Value:
        kind, arguments, shape, at = self.operations[ref]
        if kind == "load":
            array, offset = at
            return self.load(array, offset, zip(index, row_strides(shape), strict=True))
        if kind == "sum":
            return self._summed(arguments[0], index, *at)
        if kind in ON_ROWS:
            values = [self.at(argument, index) for argument in arguments[1:]]
            is_right = [float(at[0] == "right")] if kind == "search" else []
            return self.add(kind, *values, self._row(arguments[0]), *is_right)
        is_generic = not all(type(i) is int for i in index)
        is_array = kind in ("constant", "stack", "join") and is_generic
        if is_array and self.source(ref, index) is None:
            return self._read(ref, shape, index)
        if kind == "part" and self.source(ref, index) is None:  # elements row by row
            return self._read(arguments[0], shape, index, at)
        return super()._element(ref, index)

    def _summed(
        self, ref: Ref, index: tuple, axis: int, count: int, long: bool
    ) -> Value:
        before = index[:axis]
        after = index[axis:]

        def summand(i: Index) -> Value:
            value = self.at(ref, (*before, i, *after))
            return self.as_number(value)

        if long:
            used = [i[0] for i in index if type(i) is tuple]
            candidates = ((count, k) for k in range(len(used) + 1))
            symbol = next(symbol for symbol in candidates if symbol not in used)
            return self.total(summand((symbol, 0, 1)), symbol)
        total = 0.0
        for k in range(count):
            total = self.add("add", total, summand(k))
        return total

    def total(self, value: Value, symbol: Symbol) -> Value:
        """Return the sum over a symbol."""
        if type(value) is float or symbol not in value[1]:
            return self.add("mul", float(symbol[0]), value)
        return self.add("sum", value, bound=symbol)

    def product(self, factors: list[Value]) -> Value:
        """Return a product, from the left."""
        return reduce(partial(self.add, "mul"), factors)

    def operation(self, value: Value) -> tuple[str, list[Value]]:
        """Return the operation whose result a value is: its name, and its arguments as values."""
        if type(value) is not tuple:
            return "", []
        component, axes = value
        name, arguments, _ = self.all[component]
        if name in ("load", "table", "sum"):
            return name, []
        return name, [with_axes(argument, axes) for argument in arguments]

    def _row(self, table: Ref) -> Value:
        """Return the component of a row of numbers that lies in an array."""
        count = self._shape_of(table)[0]
        symbol = count, 0
        value = self.at(table, ((symbol, 0, 1),))
        if self.operation(value)[0] == "load":
            array, offset, strides, buffer = self.all[value[0]].arguments
            stride = sum(strides)
        else:
            array, offset, buffer = self._buffer(table)
            stride = 1
        row = Component("table", (array, offset, stride, count, buffer), ())
        return self._index_of(row, array in "PTK"), ()

    def apply(self, ref: int, kind: str, arguments: tuple) -> Value:
        """Return the component of an operation on elements."""
        if kind in LOGICAL:
            return self.add(kind, *map(self.truth, arguments))
        if kind == "where":
            condition, *choices = arguments
            condition = self.truth(condition)
            return self.add(kind, condition, *map(self.as_number, choices))
        values = [self.as_number(argument) for argument in arguments]
        if kind == "pow":
            return self._power(*values)
        if kind == "div":
            return self._quotient(*values)
        return self.add(kind, *values)

    def _power(self, base: Value, exponent: Value) -> Value:
        """Return a power; with a small whole or half exponent, products, a root and a quotient."""
        is_number = type(exponent) is float
        if not is_number or not 0.0 < abs(exponent) <= MOST_POWER or 2 * exponent % 1:
            return self.add("pow", base, exponent)
        count, half = divmod(abs(exponent), 1.0)
        multiply = partial(self.add, "mul")
        factors = [whole_power(multiply, base, int(count))] if count else []
        if half:
            # the root of -0.0 is -0.0, and its powers are 0.0 and inf
            is_signed = exponent != 0.5 and not count % 2
            factors.append(
                self.add("sqrt", self.add("add", base, 0.0) if is_signed else base)
            )
        value = self.product(factors)
        return value if exponent > 0.0 else self._quotient(1.0, value)

    def _quotient(self, a: Value, b: Value) -> Value:
        """Return a / b; a product if b is the same for a whole run and a is not."""
        if not self.is_steady(b) or self.is_steady(a):
            return self.add("div", a, b)
        if type(b) is float and b != 0.0:
            return self.add("mul", a, 1.0 / b)
        inverse = self.add("div", 1.0, b)
        return self.add("mul", a, inverse)

    def as_number(self, value: Value) -> Value:
        """Return a truth value as 1 or 0, a number as it is."""
        return self.add("where", value, 1.0, 0.0) if self._is_truth(value) else value

    def truth(self, value: Value) -> Value:
        """Return whether a number is not zero; a truth value as it is."""
        return value if self._is_truth(value) else self.add("ne", value, 0.0)

    def _is_truth(self, value: Value) -> bool:
        if type(value) is float:
            return False
        component, _ = value
        return self.all[component].name in CONDITIONS

    def is_steady(self, value: Value) -> bool:
        """Return whether a value depends on parameters alone, and is prepared."""
        return self.preparing and (type(value) is float or self.steady[value[0]])

    # --- arrays that are written first ----------------------------------------------------

    def _read(
        self, ref: int, shape: tuple, index: tuple[Index, ...], after: int = 0
    ) -> Value:
        """Return an element of a value in a buffer, read in a shape from element `after` on."""
        array, offset, buffer = self._buffer(ref)
        terms = zip(index, row_strides(shape), strict=True)
        return self.load(array, offset + after, terms, buffer)

    def _buffer(self, ref: int) -> tuple[str, int, int]:
        """Return array, offset and buffer of a value; a constant lies in K or T, in no buffer."""
        entry = self.operations[ref]
        is_constant = entry.kind == "constant"
        key = entry.at if is_constant else ref
        if key not in self._arrays:
            if is_constant:
                self._arrays[key] = self._constant(np.frombuffer(entry.at))
            else:
                self._arrays[key] = self._written(ref, entry)
        return self._arrays[key]

    def _constant(self, numbers: np.ndarray) -> tuple[str, int, int]:
        """Store constant numbers; return array, offset and -1 for no buffer."""
        if numbers.size > LARGE:  # not in the program's text
            offset = len(self.record.layout.T) + sum(map(len, self.tables))
            self.tables.append(numbers)
            return "T", offset, -1
        offset = len(self.constants)
        self.constants += numbers.tolist()
        return "K", offset, -1

    def _written(self, ref: int, entry: Operation) -> tuple[str, int, int]:
        """Plan the writes of a value into a new buffer; return array, offset and buffer."""
        size = prod(entry.shape)
        number = len(self.buffers)
        looped = tuple([length >= self.record.named for length in entry.shape])
        array = "W"
        start = self.room
        self.buffers[number] = []
        self.room += size
        port = Port(start, entry.shape, looped, ref)
        writes = self.writes([port], array)
        if all(self.is_steady(w.value) for w in writes):
            array = "P"
            shift = self.prepared - start
            writes = [w._replace(array=array, first=w.first + shift) for w in writes]
            start = self.prepared
            self.prepared += size
        self.buffers[number] = writes
        return array, start, number

    def writes(
        self, ports: Iterable[Port], array: str, element: Element | None = None
    ) -> list[Write]:
        """Return what writes values into an array, row by row; long axes loop.

        `element` makes the elements, by default `at`.
        """
        element = element or self.at
        return [write for port in ports for write in self._writes(port, array, element)]

    def _writes(self, port: Port, array: str, element: Element) -> Iterator[Write]:
        offset, shape, long, ref = port
        entry = self.operations[ref] if type(ref) is int else None
        if (
            entry is not None
            and entry.kind in ("stack", "join")
            and entry.shape == shape
        ):
            for section in entry.arguments:
                lengths = shape[1:]
                axes = long[1:]
                if entry.kind == "join":
                    lengths = (self._shape_of(section)[0], *lengths)
                    axes = long
                inner = Port(offset, lengths, axes, section)
                yield from self._writes(inner, array, element)
                offset += prod(lengths)
            return
        loops = count()
        indices: list[Iterable[Index]] = []
        for length, looped in zip(shape, long, strict=True):
            if looped:
                symbol = length, next(loops)
                indices.append([(symbol, 0, 1)])
            else:
                indices.append(range(length))
        for index in product(*indices):
            terms = zip(index, row_strides(shape), strict=True)
            start, strides = _strides(offset, terms)
            # outermost first
            loop_numbers = {symbol: k for k, symbol in enumerate(strides)}
            number = self.as_number(element(ref, index))
            value = with_axes(number, loop_numbers)
            lengths = tuple([length for length, _ in strides])
            yield Write(array, start, tuple(strides.values()), lengths, value)


def _strides(
    offset: int, terms: Iterable[tuple[Index, int]]
) -> tuple[int, dict[Symbol, int]]:
    """Return offset + sum of stride * index: the number, and the stride of each symbol."""
    strides: dict[Symbol, int] = {}
    for index, stride in terms:
        if type(index) is tuple:
            symbol, start, step = index
            offset += stride * start
            strides[symbol] = strides.get(symbol, 0) + stride * step
        else:
            offset += stride * index
    return offset, strides


def whole_power(multiply: Callable[..., Value], base: Value, exponent: int) -> Value:
    """Return a power as products of squares."""
    if exponent == 1:
        return base
    root = whole_power(multiply, base, exponent // 2)
    square = multiply(root, root)
    return multiply(square, base) if exponent % 2 else square


def with_axes(value: Value, axes: Any) -> Value:
    """Return a value with other names of its axes; a constant as it is."""
    if type(value) is not tuple:
        return value
    component, old_axes = value
    return component, tuple([axes[axis] for axis in old_axes])


def row_strides(lengths: Loops) -> Loops:
    """Return the strides of an array that is stored row by row."""
    return tuple([prod(lengths[k + 1 :]) for k in range(len(lengths))])
