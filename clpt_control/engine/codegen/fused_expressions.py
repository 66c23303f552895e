"""Elements of a diagram's arrays: one for each place of a short axis, one for all of a long one.

    add(load X[4 + k], load P[9 + k])        one component, of the axis k of length 50

A component is an operation, its arguments and the lengths of its axes; equal components are one.
An argument is a constant or (component, axes).  `axes` says which axis of the new component each
axis of the old one is; `BOUND` is the axis of a sum.  While components are made, an axis is a
symbol (length, number) and an index is (symbol, start, step).
"""

from collections.abc import Callable, Iterable, Iterator
from functools import partial, reduce
from itertools import count, product
from math import copysign, inf, prod
from typing import Any, NamedTuple

import numpy as np

from ...errors import Uncompiled
from ..record.scalar_graph import Elements
from ..trace.arrays import CONDITIONS
from .diagram_record import LARGE, Ref
from .elementary import FUNCTIONS, LIBRARY
from .switching_conditions import Port

MOST = 60_000  # components; a larger diagram runs in Python
BOUND = -1
SHORT_ONES = {"minimum", "maximum", "sign", "place", "floor", "trunc", "ceil"}
OUT_OF_LINE = FUNCTIONS.keys() - SHORT_ONES  # a function each, printed once a module
LONG = OUT_OF_LINE | {"div", "sqrt", "lookup", "search", "argmin", *LIBRARY}  # costly
Symbol = tuple[int, int]
Index = Any  # a whole number, or (symbol, start, step)
Value = Any  # a constant, or (component, symbols)
Element = Callable[[Ref, tuple], Value]


class Component(NamedTuple):
    """One operation on elements; of a load the arguments are array, first place and strides."""

    name: str
    arguments: tuple
    lengths: tuple[int, ...]


class Write(NamedTuple):
    """array[first + strides * indices] = value, or the sum of values over the innermost loop."""

    array: str
    first: int
    strides: tuple[int, ...]
    lengths: tuple[int, ...]  # of the loops
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
        self.room, self.prepared = room, prepared or 0  # next free places in W, and in P
        self.constants: list[float] = []  # K
        self.tables: list[np.ndarray] = []  # behind the numbers in T
        self.buffers: dict[int, list[Write]] = {}  # arrays that are written before they are read
        self._places: dict[Any, int] = {}
        self._arrays: dict[Any, tuple[str, int, int]] = {}  # entry -> array, place, buffer or -1

    # --- components -----------------------------------------------------------------------

    def add(self, name: str, *values: Value, bound: Symbol | None = None) -> Value:
        """Return the component of an operation."""
        axes = [s for a in values if type(a) is tuple for s in a[1] if s != bound]
        symbols = tuple(dict.fromkeys(axes))
        place = {s: k for k, s in enumerate(symbols)} | {bound: BOUND}
        arguments = [
            (a[0], tuple([place[s] for s in a[1]])) if type(a) is tuple else a for a in values
        ]
        if bound is not None:
            arguments.append(bound[0])
        steady = all(self.steady[a[0]] for a in values if type(a) is tuple)
        component = Component(name, tuple(arguments), tuple([s[0] for s in symbols]))
        return self._place(component, steady), symbols

    def _place(self, component: Component, steady: bool) -> int:
        signs = tuple([copysign(1.0, a) for a in component.arguments if type(a) is float])
        key = component, signs
        if key not in self._places:
            self._places[key] = len(self.all)
            self.all.append(component)
            self.steady.append(steady and self.preparing)
            if len(self.all) > MOST:
                raise Uncompiled(
                    f"the diagram takes more than {MOST} operations apart from loops: write what "
                    "repeats as operations on arrays"
                )
        return self._places[key]

    def load(
        self, array: str, first: int, places: Iterable[tuple[Index, int]], buffer: int = -1
    ) -> Value:
        """Return array[first + sum of stride * index]; `buffer` is -1 where it is no buffer's."""
        first, strides = _strides(first, places)
        lengths = tuple([s[0] for s in strides])
        arguments = (array, first, tuple(strides.values()), buffer)
        return self._place(Component("load", arguments, lengths), array in "PTK"), tuple(strides)

    # --- elements of entries --------------------------------------------------------------

    def source(self, ref: int, index: tuple[Index, ...]) -> tuple[Ref, tuple] | None:
        """Return which element of another value an element is; None where it is computed."""
        kind, arguments, shape, at = self.operations[ref]
        if kind in ("stack", "join") and type(index[0]) is not int:
            return None
        if kind != "part" or all(type(i) is int for i in index):
            return super().source(ref, index)
        outer = self.operations[arguments[0]].shape
        lead, size = len(outer) - len(shape), prod(shape)
        if lead < 0 or outer[lead:] != shape or at % size:
            return None
        before = np.unravel_index(at // size, outer[:lead]) if lead else ()
        return arguments[0], (*map(int, before), *index)

    def _element(self, ref: int, index: tuple[Index, ...]) -> Value:
        kind, arguments, shape, at = self.operations[ref]
        if kind == "load":
            return self.load(at[0], at[1], zip(index, row_strides(shape), strict=True))
        if kind == "sum":
            return self._summed(arguments[0], index, *at)
        if kind == "pick":
            return self.add("lookup", self.at(arguments[1], index), self._row(arguments[0]))
        if kind == "search":
            side = float(at[0] == "right")
            return self.add(kind, self.at(arguments[1], index), self._row(arguments[0]), side)
        if kind == "argmin":
            return self.add(kind, self._row(arguments[0]))
        generic = not all(type(i) is int for i in index)
        if kind in ("constant", "stack", "join") and generic and self.source(ref, index) is None:
            return self._read(ref, shape, index)
        if kind == "part" and self.source(ref, index) is None:  # elements row by row
            return self._read(arguments[0], shape, index, at)
        return super()._element(ref, index)

    def _summed(self, ref: Ref, index: tuple, axis: int, count: int, long: bool) -> Value:
        def one(i: Index) -> Value:
            return self.as_number(self.at(ref, (*index[:axis], i, *index[axis:])))

        if long:
            used = [i[0] for i in index if type(i) is tuple]
            symbol = next(s for k in range(len(used) + 1) if (s := (count, k)) not in used)
            return self.total(one((symbol, 0, 1)), symbol)
        total: Value = 0.0
        for k in range(count):
            total = self.add("add", total, one(k))
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
        name, arguments, _ = self.all[value[0]] if type(value) is tuple else ("", (), ())
        if name in ("load", "table", "sum"):
            return name, []
        values = [
            (a[0], tuple([value[1][k] for k in a[1]])) if type(a) is tuple else a for a in arguments
        ]
        return name, values

    def _row(self, table: Ref) -> Value:
        """Return the component of a row of numbers that lies in an array."""
        count = self.record.shape_of(table)[0]
        value = self.at(table, (((count, 0), 0, 1),))
        if self.operation(value)[0] == "load":
            array, first, strides, buffer = self.all[value[0]].arguments
            stride = sum(strides)
        else:
            (array, first, buffer), stride = self._buffer(table), 1
        row = Component("table", (array, first, stride, count, buffer), ())
        return self._place(row, array in "PTK"), ()

    def apply(self, ref: int, kind: str, arguments: tuple) -> Value:
        """Return the component of an operation on elements."""
        logical = len(arguments) if kind in ("and", "or", "not") else kind == "where"
        of = (self.truth(v) if k < logical else self.as_number(v) for k, v in enumerate(arguments))
        a = list(of)
        if kind == "pow" and a[1] in (2.0, 3.0):
            return self.product([a[0]] * int(a[1]))
        if kind == "pow" and a[1] == 4.0:
            return self.product([self.product([a[0]] * 2)] * 2)
        if kind == "pow" and a[1] == 0.5:
            return self.add("sqrt", a[0])
        if kind == "div" and self.is_steady(a[1]) and not self.is_steady(a[0]):
            constant = type(a[1]) is float and a[1] != 0.0
            return self.add("mul", a[0], 1.0 / a[1] if constant else self.add("div", 1.0, a[1]))
        return self.add(kind, *a)

    def as_number(self, value: Value) -> Value:
        """Return a truth value as 1 or 0, a number as it is."""
        if type(value) is float or self.all[value[0]].name not in CONDITIONS:
            return value
        return self.add("where", value, 1.0, 0.0)

    def truth(self, value: Value) -> Value:
        """Return whether a number is not zero; a truth value as it is."""
        if type(value) is tuple and self.all[value[0]].name in CONDITIONS:
            return value
        return self.add("ne", value, 0.0)

    def is_steady(self, value: Value) -> bool:
        """Whether a value depends on parameters alone, and is prepared."""
        return self.preparing and (type(value) is float or self.steady[value[0]])

    # --- arrays that are written first ----------------------------------------------------

    def _read(self, ref: int, shape: tuple, index: tuple[Index, ...], after: int = 0) -> Value:
        """Return an element of a value in a buffer, read in a shape from place `after` on."""
        array, first, buffer = self._buffer(ref)
        return self.load(array, first + after, zip(index, row_strides(shape), strict=True), buffer)

    def _buffer(self, ref: int) -> tuple[str, int, int]:
        """Return array, first place and buffer of a value; a constant lies in K, in no buffer."""
        entry = self.operations[ref]
        key = entry.at if entry.kind == "constant" else ref
        if key in self._arrays:
            return self._arrays[key]
        if entry.kind == "constant":
            numbers = np.frombuffer(entry.at)
            if numbers.size > LARGE:  # is no part of the program's text
                first = len(self.record.layout.T) + sum(map(len, self.tables))
                self._arrays[key] = "T", first, -1
                self.tables.append(numbers)
            else:
                self._arrays[key] = "K", len(self.constants), -1
                self.constants += numbers.tolist()
            return self._arrays[key]
        size, number = prod(entry.shape), len(self.buffers)
        long = tuple([n >= self.record.named for n in entry.shape])
        array, first = "W", self.room
        self.buffers[number] = []
        self.room += size
        writes = self.writes([Port(first, entry.shape, long, ref)], array)
        if all(self.is_steady(w.value) for w in writes):
            array, offset = "P", self.prepared - first
            writes = [w._replace(array=array, first=w.first + offset) for w in writes]
            first, self.prepared = self.prepared, self.prepared + size
        self.buffers[number] = writes
        self._arrays[key] = array, first, number
        return self._arrays[key]

    def writes(
        self, ports: Iterable[Port], array: str, element: Element | None = None
    ) -> list[Write]:
        """Return what writes values into an array, row by row; long axes loop.

        `element` makes the elements, by default `at`.
        """
        return [write for p in ports for write in self._writes(p, array, element or self.at)]

    def _writes(self, port: Port, array: str, element: Element) -> Iterator[Write]:
        first, shape, long, ref = port
        entry = self.operations[ref] if type(ref) is int else None
        if entry is not None and entry.kind in ("stack", "join") and entry.shape == shape:
            for part in entry.arguments:
                lengths, axes = shape[1:], long[1:]
                if entry.kind == "join":
                    lengths, axes = (self.record.shape_of(part)[0], *lengths), long
                yield from self._writes(Port(first, lengths, axes, part), array, element)
                first += prod(lengths)
            return
        loops = count()
        places = [
            [((n, next(loops)), 0, 1)] if looped else range(n)
            for n, looped in zip(shape, long, strict=True)
        ]
        for index in product(*places):
            start, strides = _strides(first, zip(index, row_strides(shape), strict=True))
            value = self.as_number(element(ref, index))
            if type(value) is tuple:  # its axes are the loops, outermost first
                value = value[0], tuple([[*strides].index(s) for s in value[1]])
            lengths = tuple([s[0] for s in strides])
            yield Write(array, start, tuple(strides.values()), lengths, value)


def _strides(first: int, places: Iterable[tuple[Index, int]]) -> tuple[int, dict[Symbol, int]]:
    """Return first + sum of stride * index: the number, and the stride of each symbol."""
    strides: dict[Symbol, int] = {}
    for index, stride in places:
        if type(index) is tuple:
            symbol, start, step = index
            first += stride * start
            strides[symbol] = strides.get(symbol, 0) + stride * step
        else:
            first += stride * index
    return first, strides


def row_strides(lengths: tuple[int, ...]) -> tuple[int, ...]:
    """Return the strides of an array that is stored row by row."""
    return tuple([prod(lengths[k + 1 :]) for k in range(len(lengths))])
