"""Elements of a diagram's arrays: short axes apart, a long axis as one element for all k.

    add(load X[4 + k], load P[9 + k])        one component, of the axis k of length 50

A component is an operation, its arguments and the lengths of its axes; equal ones are one.  An
argument is a constant, or (component, axes): which axis of the new component each axis of the old
one is, `BOUND` the one that a sum is over.  While components are made, an axis is a symbol
(length, number) and an index (symbol, start, step).
"""

import sys
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from functools import partial, reduce
from itertools import count, product
from math import copysign, prod
from typing import Any, NamedTuple

import numpy as np

from ..equations.arrays import CONDITIONS
from ..errors import Uncompiled
from .decisions import Port
from .diagram_record import Ref

MOST = 60_000  # components; more are left to Python
BOUND = -1
APART = frozenset(  # of many instructions: printed once a module, and called
    (
        *("exp", "expm1", "log", "log1p", "log2", "log10", "hypot", "pow", "mod", "floordiv"),
        *("sinh", "cosh", "tanh", "asinh", "acosh", "atanh"),
        *("sin", "cos", "tan", "asin", "acos", "atan", "atan2"),
    )
)
LONG = APART | {"div", "sqrt", "erf", "erfc", "lookup"}  # costly
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
    """array[first + strides * turns] = value, or the sum of values over the innermost loop."""

    array: str
    first: int
    strides: tuple[int, ...]
    lengths: tuple[int, ...]  # of the loops
    value: Value
    saves: int = -1  # the component that is read from there, once it is written
    summed: bool = False


@contextmanager
def deep() -> Iterator[None]:
    """Allow functions to call themselves as deep as records are."""
    before = sys.getrecursionlimit()
    sys.setrecursionlimit(max(before, 1_000_000))
    try:
        yield
    finally:
        sys.setrecursionlimit(before)


class Components:
    """The elements of a diagram's record that its functions need, each once.

    From `prepared` on P has room for what is computed once a piece of time; without, all is
    computed where it is asked for.
    """

    def __init__(self, record: Any, room: int, prepared: int | None = None):
        self.record, self.entries = record, record.entries
        self.all: list[Component] = []
        self.preparing = prepared is not None
        self.steady: list[bool] = []  # depends on parameters alone, and is prepared
        self.room, self.prepared = room, prepared or 0  # next free places in W, and in P
        self.constants: list[float] = []  # K
        self.kept: dict[int, list[Write]] = {}  # arrays that are written before they are read
        self._places: dict[Any, int] = {}
        self._found: dict[tuple, Value] = {}
        self._arrays: dict[Any, tuple[str, int, int]] = {}  # entry -> array, place, which kept

    # --- components -----------------------------------------------------------------------

    def add(self, name: str, *given: Value, bound: Symbol | None = None) -> Value:
        """Return the component of an operation."""
        own = [s for a in given if type(a) is tuple for s in a[1] if s != bound]
        symbols = tuple(dict.fromkeys(own))
        place = {s: k for k, s in enumerate(symbols)} | {bound: BOUND}
        arguments = [
            (a[0], tuple([place[s] for s in a[1]])) if type(a) is tuple else a for a in given
        ]
        if bound is not None:
            arguments.append(bound[0])
        steady = all(self.steady[a[0]] for a in given if type(a) is tuple)
        found = self._place(
            Component(name, tuple(arguments), tuple([s[0] for s in symbols])), steady
        )
        return found, symbols

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
        self, array: str, first: int, places: Iterable[tuple[Index, int]], kept: int = -1
    ) -> Value:
        """Return array[first + sum of stride * index]; `kept` says when it has been written."""
        first, strides = _along(first, places)
        lengths = tuple([s[0] for s in strides])
        own = (array, first, tuple(strides.values()), kept)
        return self._place(Component("load", own, lengths), array in "PTK"), tuple(strides)

    # --- elements of entries --------------------------------------------------------------

    def at(self, ref: Ref, index: tuple[Index, ...]) -> Value:
        """Return an element of a value; a shorter one is broadcast."""
        if type(ref) is float:
            return ref
        index = self.trimmed(ref, index)
        if (ref, index) not in self._found:
            self._found[ref, index] = self._element(ref, index)
        return self._found[ref, index]

    def trimmed(self, ref: int, index: tuple[Index, ...]) -> tuple[Index, ...]:
        """Return an index without what a value is broadcast along."""
        shape = self.entries[ref].shape
        index = index[len(index) - len(shape) :]
        return tuple([0 if n == 1 else i for i, n in zip(index, shape, strict=True)])

    def _element(self, ref: int, index: tuple[Index, ...]) -> Value:
        kind, arguments, shape, at = self.entries[ref]
        if kind == "load":
            return self.load(at[0], at[1], zip(index, rows(shape), strict=True))
        if kind == "constant":
            numbers = np.frombuffer(at).reshape(shape)
            if all(type(i) is int for i in index):
                return float(numbers[index])
            return self._read(ref, shape, index)
        moved = self.moved(ref, index)
        if moved is not None:
            return self.at(*moved)
        if kind in ("stack", "join"):
            return self._read(ref, shape, index)
        if kind == "part":  # elements row by row, in another shape
            return self._read(arguments[0], shape, index, at)
        if kind == "sum":
            return self._summed(arguments[0], index, *at)
        if kind == "pick":
            return self._picked(arguments[0], arguments[1], index)
        return self._calculated(kind, [self.at(a, index) for a in arguments], at)

    def moved(self, ref: int, index: tuple[Index, ...]) -> tuple[Ref, tuple] | None:
        """Return which element of another value an element is; None where it is computed."""
        kind, arguments, shape, at = self.entries[ref]
        if kind == "view":
            moved = [m if isinstance(m, int) else _moved(index[m[0]], m[1], m[2]) for m in at]
            return arguments[0], tuple(moved)
        if kind == "fill":
            return arguments[0], ()
        if kind == "part":
            outer = self.entries[arguments[0]].shape
            lead, size = len(outer) - len(shape), prod(shape)
            if all(type(i) is int for i in index):
                at += sum([s * i for s, i in zip(rows(shape), index, strict=True)])
                lead, size, index = len(outer), 1, ()
            elif lead < 0 or outer[lead:] != shape or at % size:
                return None
            before = np.unravel_index(at // size, outer[:lead]) if lead else ()
            return arguments[0], (*map(int, before), *index)
        if kind not in ("stack", "join") or type(index[0]) is not int:
            return None
        if kind == "stack":
            return arguments[index[0]], index[1:]
        k, part = index[0], 0
        while k >= (n := self.record.shape_of(arguments[part])[0]):
            k, part = k - n, part + 1
        return arguments[part], (k, *index[1:])

    def _summed(self, ref: Ref, index: tuple, axis: int, count: int, long: bool) -> Value:
        def one(i: Index) -> Value:
            return self.number(self.at(ref, (*index[:axis], i, *index[axis:])))

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

    def made_of(self, value: Value) -> tuple[str, list[Value]]:
        """Return the name of what made a value, and its arguments as values."""
        name, arguments, _ = self.all[value[0]] if type(value) is tuple else ("", (), ())
        if name in ("load", "table", "sum"):
            return name, []
        own = [
            (a[0], tuple([value[1][k] for k in a[1]])) if type(a) is tuple else a for a in arguments
        ]
        return name, own

    def _picked(self, table: Ref, place: Ref, index: tuple) -> Value:
        whole = self.at(place, index)
        count = self.record.shape_of(table)[0]
        value = self.at(table, (((count, 0), 0, 1),))
        if self.made_of(value)[0] == "load":
            array, first, strides, kept = self.all[value[0]].arguments
            stride = sum(strides)
        else:
            (array, first, kept), stride = self._kept(table), 1
        at = self._place(
            Component("table", (array, first, stride, count, kept), ()), array in "PTK"
        )
        return self.add("lookup", whole, (at, ()))

    def _calculated(self, kind: str, a: list[Value], at: Any) -> Value:
        logical = len(a) if kind in ("and", "or", "not") else kind == "where"
        a = [self.answer(v) if k < logical else self.number(v) for k, v in enumerate(a)]
        if kind == "pow" and a[1] in (2.0, 3.0):
            return self.product([a[0]] * int(a[1]))
        if kind == "pow" and a[1] == 4.0:
            return self.product([self.product([a[0]] * 2)] * 2)
        if kind == "pow" and a[1] == 0.5:
            return self.add("sqrt", a[0])
        if kind == "div" and self.is_steady(a[1]) and not self.is_steady(a[0]):
            known = type(a[1]) is float and a[1] != 0.0
            return self.add("mul", a[0], 1.0 / a[1] if known else self.add("div", 1.0, a[1]))
        return self.add(kind, *a)

    def number(self, value: Value) -> Value:
        """Return an answer as 1 or 0, a number as it is."""
        if type(value) is float or self.all[value[0]].name not in CONDITIONS:
            return value
        return self.add("where", value, 1.0, 0.0)

    def answer(self, value: Value) -> Value:
        """Return a number as whether it is not zero, an answer as it is."""
        if type(value) is tuple and self.all[value[0]].name in CONDITIONS:
            return value
        return self.add("ne", value, 0.0)

    def is_steady(self, value: Value) -> bool:
        """Whether a value depends on parameters alone, and is prepared."""
        return self.preparing and (type(value) is float or self.steady[value[0]])

    # --- arrays that are written first ----------------------------------------------------

    def _read(self, ref: int, shape: tuple, index: tuple[Index, ...], after: int = 0) -> Value:
        """Return an element, in a shape, of a value that is kept in an array, `after` so many."""
        array, first, kept = self._kept(ref)
        return self.load(array, first + after, zip(index, rows(shape), strict=True), kept)

    def _kept(self, ref: int) -> tuple[str, int, int]:
        """Return array, first place and number of a value that is written before it is read."""
        entry = self.entries[ref]
        key = entry.at if entry.kind == "constant" else ref
        if key in self._arrays:
            return self._arrays[key]
        if entry.kind == "constant":
            self._arrays[key] = "K", len(self.constants), -1
            self.constants += np.frombuffer(entry.at).tolist()
            return self._arrays[key]
        size, number = prod(entry.shape), len(self.kept)
        long = tuple([n >= self.record.named for n in entry.shape])
        array, first = "W", self.room
        self.kept[number] = []
        self.room += size
        writes = self.writes([Port(first, entry.shape, long, ref)], array)
        if all(self.is_steady(w.value) for w in writes):
            array, moved = "P", self.prepared - first
            writes = [w._replace(array=array, first=w.first + moved) for w in writes]
            first, self.prepared = self.prepared, self.prepared + size
        self.kept[number] = writes
        self._arrays[key] = array, first, number
        return self._arrays[key]

    def writes(
        self, ports: Iterable[Port], array: str, element: Element | None = None
    ) -> list[Write]:
        """Return what writes values into an array, row by row; long axes loop.

        `element` makes the elements; `at` does by itself.
        """
        return [write for p in ports for write in self._written(p, array, element or self.at)]

    def _written(self, port: Port, array: str, element: Element) -> Iterator[Write]:
        first, shape, long, ref = port
        entry = self.entries[ref] if type(ref) is int else None
        if entry is not None and entry.kind in ("stack", "join") and entry.shape == shape:
            for part in entry.arguments:
                own, axes = shape[1:], long[1:]
                if entry.kind == "join":
                    own, axes = (self.record.shape_of(part)[0], *own), long
                yield from self._written(Port(first, own, axes, part), array, element)
                first += prod(own)
            return
        loops = count()
        places = [
            [((n, next(loops)), 0, 1)] if turns else range(n)
            for n, turns in zip(shape, long, strict=True)
        ]
        for index in product(*places):
            start, strides = _along(first, zip(index, rows(shape), strict=True))
            value = self.number(element(ref, index))
            if type(value) is tuple:  # its axes are the turns of the loops, outermost first
                value = value[0], tuple([[*strides].index(s) for s in value[1]])
            lengths = tuple([s[0] for s in strides])
            yield Write(array, start, tuple(strides.values()), lengths, value)


def _along(first: int, places: Iterable[tuple[Index, int]]) -> tuple[int, dict[Symbol, int]]:
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


def rows(lengths: tuple[int, ...]) -> tuple[int, ...]:
    """Return strides of an array that lies row by row."""
    return tuple([prod(lengths[k + 1 :]) for k in range(len(lengths))])


def _moved(index: Index, start: int, step: int) -> Index:
    """Return start + step * index."""
    if type(index) is tuple:
        return index[0], start + step * index[1], step * index[2]
    return start + step * index
