"""Arrays without values: what a function is called with, to be read.

An `Array` is a value of a record that grows (`Tape`).  NumPy's own protocols write down what a
function does with it: ``np.exp(a)``, ``a @ b``, ``np.outer(a, b)``.  What is written into it
(``y[0] = ...``) is kept element by element, and views share what is written, as NumPy's do.
"""

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from math import prod
from threading import local
from typing import Any

import numpy as np
from numpy.lib.mixins import NDArrayOperatorsMixin

from .numbers import UFUNCS
from .record import Operation, Ref, Shape, key_of

MOST_OPERATIONS = 200_000  # a longer record is given up
CONDITIONS = frozenset({"lt", "le", "gt", "ge", "eq", "ne", "and", "or", "not"})
MOVED = frozenset({"view", "stack", "join"})  # hold what their arguments hold

# what an array is asked for, by the files that know it: each puts in its own
PARTS: dict[str, Any] = {}


class Unread(Exception):
    """Why a function cannot be read: what it does, and what to write instead."""

    def __init__(self, sentence: str):
        super().__init__(sentence)
        if (tape := active()) is not None:
            tape.stopped = self  # a function may catch it


_ACTIVE = local()


def active() -> "Tape | None":
    """Return the tape on which this thread reads a function now, if it does."""
    return getattr(_ACTIVE, "tape", None)


@contextmanager
def reading_on(tape: "Tape") -> Iterator[None]:
    """Make a tape the one on which this thread reads."""
    before, _ACTIVE.tape = active(), tape
    try:
        yield
    finally:
        _ACTIVE.tape = before


def is_free(at: tuple[str, str]) -> bool:
    """Return whether a leaf changes along a run: all but parameters, and `interval` of these."""
    return at[0] != "p" or at[1] == "interval"


class Tape:
    """A record as it grows; equal operations are one."""

    def __init__(self) -> None:
        self.operations: list[Operation] = []
        self.stopped: Exception | None = None  # what ends the reading
        self.free: list[bool] = []  # of each: whether it depends on time, states or inputs
        self.truth: list[bool] = []  # of each: whether it holds truth values
        self._known: dict[Any, int] = {}

    def add(self, kind: str, arguments: Sequence[Ref], shape: Shape, at: Any = None) -> "Array":
        """Return the value of an operation, written down where it is new."""
        if kind in ("eq", "ne") and arguments[0] == arguments[1]:
            at = "NaN"  # x == x asks for NaN
        key = (kind, tuple(map(key_of, arguments)), shape, at)
        place = self._known.get(key)
        if place is None:
            place = self._known[key] = len(self.operations)
            self.operations.append(Operation(kind, tuple(arguments), shape, at))
            own = [a for a in arguments if type(a) is int]
            self.free.append(any(self.free[a] for a in own) or (kind == "leaf" and is_free(at)))
            self.truth.append(
                kind in CONDITIONS
                or (
                    kind in MOVED and len(own) == len(arguments) and all(self.truth[a] for a in own)
                )
            )
            if place > MOST_OPERATIONS:
                raise Unread(f"takes more than {MOST_OPERATIONS} operations")
        return Array(self, place, shape)

    def question(self, ref: Ref) -> bool:
        """Answer whether a condition holds, where Python asks."""
        raise Unread("a choice that depends on a signal")

    def numbers(self, ref: Ref) -> np.ndarray:
        """Return the value that Python asks for."""
        raise Unread("a number that depends on a signal")

    def whole(self, number: "Array") -> int:
        """Return the whole number that Python counts with."""
        raise Unread("a whole number that depends on a signal")


def broadcast(*shapes: Shape) -> Shape:
    """Return the shape to which shapes are broadcast."""
    found = []
    for d in range(-max(map(len, shapes)), 0):
        long = {shape[d] for shape in shapes if -d <= len(shape)} - {1}
        if len(long) > 1:
            raise ValueError(f"operands could not be broadcast together with shapes {shapes}")
        found.append(long.pop() if long else 1)
    return tuple(found)


class Masked(NDArrayOperatorsMixin):
    """The elements of an array where a condition holds: ``x[x > 0] *= 2``."""

    def __init__(self, full: Any, mask: "Array"):
        self.full, self.mask = full, mask

    def __array_ufunc__(self, ufunc: Any, method: str, *inputs: Any, **more: Any) -> Any:
        more.pop("out", None)
        for one in inputs:
            apart = one.mask.ref != self.mask.ref if isinstance(one, Masked) else np.ndim(one)
            if apart or method != "__call__":
                raise Unread("joins elements taken by a condition with others; write np.where")
        own = [one.full if isinstance(one, Masked) else one for one in inputs]
        return Masked(ufunc(*own, **more), self.mask)

    def sum(self) -> Any:
        """Return the sum of the elements."""
        return np.sum(where(self.mask, self.full, 0.0))


class Array(NDArrayOperatorsMixin):
    """A value of a tape, of a known shape, used as NumPy's arrays are."""

    __slots__ = ("fixed", "index", "node", "parent", "shape", "store", "tape")
    __array_priority__ = 1000

    def __init__(self, tape: Tape, node: int, shape: Shape, parent: Any = None, index: Any = None):
        self.tape, self.node, self.shape = tape, node, shape
        self.fixed = False  # whether nothing may be written into it
        self.parent: Array | None = parent
        self.index = index
        self.store: np.ndarray | None = None  # its elements, once one was written

    # --- the value ----------------------------------------------------------------------

    @property
    def ref(self) -> Ref:
        """Its place on the tape, as it stands now."""
        store = self._written()
        if store is None:
            return self.node
        return operand(packed(self.tape, store))

    def _written(self) -> np.ndarray | None:
        if self.store is None and self.parent is not None:
            above = self.parent._written()
            if above is not None:
                part = self.index(above) if callable(self.index) else above[self.index]
                self.store = np.asarray(part, dtype=object)
        return self.store

    @property
    def ndim(self) -> int:
        """Number of axes."""
        return len(self.shape)

    @property
    def size(self) -> int:
        """Number of elements."""
        return prod(self.counted())

    @property
    def dtype(self) -> np.dtype:
        """What NumPy's array would hold."""
        return np.dtype(bool if self.is_condition else float)

    @property
    def is_condition(self) -> bool:
        """Whether it holds truth values."""
        return self.store is None and is_condition(self.tape, self.node)

    def counted(self) -> tuple[int, ...]:
        """Return the shape, which Python counts with: no open size."""
        for n in self.shape:
            if not isinstance(n, int):
                raise Unread(f"counting with the open size {n}")
        return self.shape

    # --- elements -----------------------------------------------------------------------

    def __len__(self) -> int:
        if not self.shape:
            raise TypeError("len() of unsized object")
        return self.counted()[0]

    def __iter__(self) -> Iterator[Any]:
        return (self[k] for k in range(len(self)))

    def __getitem__(self, index: Any) -> Any:
        index = index if isinstance(index, tuple) else (index,)
        if any(isinstance(i, Array) for i in index):
            return self._picked(index)
        if any(isinstance(i, list | tuple | np.ndarray) and np.ndim(i) for i in index):
            return packed(self.tape, self.elements()[index])
        if any(isinstance(i, np.ndarray) for i in index):
            index = tuple(i[()] if isinstance(i, np.ndarray) else i for i in index)
        mapped, shape = PARTS["index_map"](index, self.shape)
        return PARTS["view"](self, mapped, shape, index)

    def _picked(self, index: tuple) -> Any:
        """Return elements at places that are signals."""
        return PARTS["pick"](self, index)

    def __setitem__(self, index: Any, value: Any) -> None:
        root = self
        while root.parent is not None:
            root = root.parent
        if root.fixed:
            raise Unread("writes into its states, inputs or parameters; write into a copy")
        if root.store is None:
            root.store = np.asarray(root.elements(), dtype=object)
        store = self._written()
        assert store is not None
        if isinstance(value, Masked):
            value = value.full
        value = lifted(self.tape, value)
        if isinstance(index, Array) and index.is_condition:
            store[...] = elements(where(index, value, lifted(self.tape, self)))
            return
        index = _known(index)
        store[index] = elements(value) if isinstance(store[index], np.ndarray) else _single(value)

    def elements(self) -> np.ndarray:
        """Return its elements in an array of objects."""
        if (store := self._written()) is not None:
            return store.copy()
        known = numbers_of(self)
        if known is not None:
            return known.astype(object)
        found = np.empty(self.counted(), dtype=object)
        if not self.shape:
            return _element(self)
        for place in np.ndindex(found.shape):
            found[place] = self[place]
        return found

    # --- NumPy's protocols ----------------------------------------------------------------

    def __array_ufunc__(self, ufunc: Any, method: str, *inputs: Any, **more: Any) -> Any:
        if not self.shape and not more and ufunc in UFUNCS and method == "__call__":
            return elementwise(UFUNCS[ufunc], *inputs)
        return PARTS["called"](self.tape, ufunc, method, inputs, more)

    def __array_function__(self, function: Any, types: Any, inputs: Any, more: Any) -> Any:
        return PARTS["applied"](self.tape, function, inputs, more)

    def __array__(self, dtype: Any = None, copy: Any = None) -> np.ndarray:
        if dtype is not None and np.dtype(dtype).kind == "O":
            return self.elements() if self.shape else _element(self)
        return self.tape.numbers(self.ref).astype(dtype or float)

    def __getattr__(self, name: str) -> Any:
        if name not in PARTS["methods"]:
            known = None if name.startswith("__") else numbers_of(self)
            if known is not None:
                return getattr(known, name)
            raise AttributeError(f"an array of the record has no {name!r}")
        return lambda *arguments, **more: PARTS["methods"][name](self, *arguments, **more)

    def __eq__(self, other: Any) -> Any:
        return False if other is None or isinstance(other, str) else np.equal(self, other)

    def __ne__(self, other: Any) -> Any:
        return True if other is None or isinstance(other, str) else np.not_equal(self, other)

    real = property(lambda self: self)
    imag = property(lambda self: np.zeros(self.counted())[()])
    flat = property(lambda self: iter(self.elements().ravel()))

    @property
    def T(self) -> "Array":
        """The array with its axes the other way round."""
        turned = tuple((self.ndim - 1 - d, 0, 1) for d in range(self.ndim))
        return PARTS["view"](self, turned, self.shape[::-1], np.transpose)

    # --- Python asks for a value ----------------------------------------------------------

    def __bool__(self) -> bool:
        if self.shape and self.size != 1:
            raise ValueError("the truth value of an array with more than one element is ambiguous")
        one = self if not self.shape else self[(0,) * self.ndim]
        if not isinstance(one, Array):
            return bool(one)
        return self.tape.question(one.ref if one.is_condition else elementwise("ne", one, 0.0).ref)

    def __float__(self) -> float:
        return float(self.tape.numbers(self.ref).item())

    __complex__ = __float__

    def __int__(self) -> int:
        return int(self.tape.numbers(self.ref).item())

    def __index__(self) -> int:
        return self.tape.whole(self)

    def __format__(self, spec: str) -> str:
        return repr(self)

    def __hash__(self) -> int:
        return id(self)

    def __round__(self, digits: Any = None) -> Any:
        return PARTS["rounded"](self, digits)

    def __repr__(self) -> str:
        return f"<v{self.node} {self.shape}>"


def numbers_of(array: Array) -> np.ndarray | None:
    """Return an array that depends on nothing as numbers, else None."""
    store = array._written()
    if store is None:
        if type(array) is not Array:  # all states or inputs
            return None
        own = array.tape.operations[array.node]
        return np.frombuffer(own.at).reshape(own.shape) if own.kind == "constant" else None
    plain = all(type(one) is not Array for one in store.flat)
    return store.astype(float) if plain else None


def _known(index: Any) -> Any:
    """Return an index whose signals are asked which whole numbers they are."""
    if isinstance(index, tuple):
        return tuple(map(_known, index))
    return index.__index__() if isinstance(index, Array) else index


def _single(value: Any) -> Any:
    """Return the element that an array of one holds, as NumPy puts it in a place of one."""
    return value.elements().item() if isinstance(value, Array) and value.shape else value


def _element(value: Array) -> np.ndarray:
    held = np.empty(1, dtype=object)
    held[0] = value
    return held.reshape(())


def is_condition(tape: Tape, ref: Ref) -> bool:
    """Return whether a value is a truth value."""
    return type(ref) is int and tape.truth[ref]


def operand(value: Any) -> Ref:
    """Return a value's place, or a constant."""
    return value.ref if isinstance(value, Array) else float(value)


def lifted(tape: Tape, value: Any) -> Any:
    """Return a number as it is, and anything that NumPy makes an array of as an array."""
    if isinstance(value, Array):
        if value.tape is not tape:
            raise Unread("keeps values from one call to the next; make them states")
        return value
    if isinstance(value, bool | int | float | np.bool_ | np.integer | np.floating):
        return float(value)
    try:
        if isinstance(value, np.ndarray) and value.dtype != object:
            return constant(tape, value)
        if isinstance(value, np.ndarray) and not value.ndim:
            return lifted(tape, value.item())
        parts = [lifted(tape, one) for one in value]
    except TypeError:
        raise Unread(f"calculating with a {type(value).__name__}") from None
    if not any(isinstance(one, Array) for one in parts):
        return constant(tape, np.asarray(value, dtype=float))
    return stacked(tape, parts)


def constant(tape: Tape, value: np.ndarray) -> Any:
    """Return an array of numbers; a single one is a float."""
    value = np.asarray(value, order="C")  # ascontiguousarray would make an axis of a number
    if value.dtype.kind not in "fiub":
        raise Unread(f"calculating with an array of {value.dtype}")
    value = value.astype(float)
    return tape.add("constant", (), value.shape, value.tobytes()) if value.shape else float(value)


def packed(tape: Tape, elements: np.ndarray) -> Any:
    """Return an array of objects as one value."""
    if not isinstance(elements, np.ndarray):
        return lifted(tape, elements)
    if not elements.shape:
        return lifted(tape, elements[()])
    if not elements.size:
        return constant(tape, np.zeros(elements.shape))
    return stacked(tape, [packed(tape, one) for one in elements])


def stacked(tape: Tape, parts: Sequence[Any]) -> Any:
    """Return arrays of one shape along a new first axis."""
    shapes = {getattr(part, "shape", ()) for part in parts}
    if len(shapes) > 1:
        raise ValueError(
            f"all input arrays must have the same shape, not {sorted(map(str, shapes))}"
        )
    refs = [operand(part) for part in parts]
    if all(type(ref) is float for ref in refs):
        return constant(tape, np.array(refs))
    seen = PARTS["tape_view"](tape, refs)
    return tape.add("stack", refs, (len(refs), *shapes.pop())) if seen is None else seen


def elementwise(name: str, *arguments: Any) -> Any:
    """Return an elementwise operation of arrays and numbers."""
    tape = next(a.tape for a in arguments if isinstance(a, Array))
    logical, refs, shapes = name in ("and", "or", "not"), [], set()
    for k, one in enumerate(arguments):
        one = one if type(one) is float else lifted(tape, one)
        if isinstance(one, Array):
            if one.is_condition != (logical or (name == "where" and k == 0)):
                one = as_number(one) if one.is_condition else as_condition(one)
            shapes.add(one.shape)
        refs.append(operand(one))
    shape = shapes.pop() if len(shapes) == 1 else broadcast(*shapes)
    return tape.add(name, refs, shape)


def as_number(value: Any) -> Any:
    """Return truth values as 1 and 0, and all else as it is."""
    if isinstance(value, Array) and value.is_condition:
        return value.tape.add("where", (value.ref, 1.0, 0.0), value.shape)
    return value


def as_condition(value: Any) -> Any:
    """Return numbers as whether they are not zero."""
    if isinstance(value, Array) and not value.is_condition:
        return elementwise("ne", value, 0.0)
    return value


def where(condition: Any, a: Any, b: Any) -> Any:
    """Return a where a condition holds, else b."""
    if not isinstance(condition, Array):
        if not np.ndim(condition):
            return a if condition else b
        tape = next(v.tape for v in (a, b) if isinstance(v, Array))
        condition = constant(tape, np.asarray(condition, dtype=float))
    return elementwise("where", condition, a, b)


def elements(value: Any) -> Any:
    """Return the elements of an array, or a number as it is."""
    return value.elements() if isinstance(value, Array) else value


def total(array: Array, axis: int) -> Any:
    """Return the sum over one axis."""
    array = as_number(array)
    axis %= array.ndim
    shape = array.shape[:axis] + array.shape[axis + 1 :]
    return array.tape.add("sum", (array.ref,), shape, axis)
