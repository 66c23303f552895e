"""Arrays without values: what a function is called with, to be read.

An `Array` is a value of a record that grows (`Tape`).  NumPy's own protocols write down what a
function does with it: ``np.exp(a)``, ``a @ b``, ``np.outer(a, b)``.  What is written into it
(``y[0] = ...``) is kept element by element, and views share what is written, as NumPy's do.
"""

import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from functools import partial
from math import prod
from operator import attrgetter
from threading import local
from typing import Any

import numpy as np
from numpy.lib.mixins import NDArrayOperatorsMixin

from .record import UFUNCS, Operation, Record, Ref, Shape, key_of

MOST_OPERATIONS = 200_000  # a longer record is given up
LOGICAL = frozenset({"and", "or", "not"})  # of conditions
COMPARISONS = frozenset({"lt", "le", "gt", "ge", "eq", "ne"})
CONDITIONS = LOGICAL | COMPARISONS
TRUTH = np.dtype(bool)
TRUTHS_ALLOWED = CONDITIONS | {"where"}  # operations on truth values alone
MOVED = frozenset({"view", "stack", "join"})  # hold what their arguments hold
# of whole numbers, a whole number
OF_WHOLE = frozenset(
    {"add", "sub", "mul", "neg", "mod", "minimum", "maximum", "where", "sum", "fill", "stack"}
    | {"floordiv", "pow", "sign"}
)
OF_TRUTHS = {"mul": "and", "minimum": "and", "maximum": "or"}  # what NumPy makes of truth values
RAISING = frozenset({"div", "floordiv", "mod", "pow"})  # where Python's floats raise

# what arrays call in files that import this one; each file puts in its own
HOOKS: dict[str, Any] = {}


class Unread(Exception):
    """Why a function cannot be read: what it does, and what to write instead."""

    def __init__(self, sentence: str):
        super().__init__(sentence)
        if (tape := active()) is not None:
            tape.stopped = self  # a function may catch it


_ACTIVE = local()


def active() -> "Tape | None":
    """Return the tape on which this thread reads a function now, or None."""
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
        self.parameters: Mapping[str, Any] = {}  # as they were given
        self.has_floats = False  # whether some signals are Python's floats, not NumPy's
        self.free: list[bool] = []  # of each: whether it depends on time, states or inputs
        self.truth: list[bool] = []  # of each: whether it holds truth values
        self._known: dict[Any, int] = {}

    def add(self, kind: str, arguments: Sequence[Ref], shape: Shape, at: Any = None) -> "Array":
        """Return the value of an operation, written down where it is new."""
        key = (kind, tuple(map(key_of, arguments)), shape, at)
        place = self._known.get(key)
        if place is None:
            place = self._known[key] = len(self.operations)
            self.append(Operation(kind, tuple(arguments), shape, at))
            if place > MOST_OPERATIONS:
                raise Unread(f"takes more than {MOST_OPERATIONS} operations")
        return Array(self, place, shape)

    def append(self, operation: Operation) -> None:
        """Write an operation down, also where an equal one stands."""
        kind, arguments, _, at = operation
        self.operations.append(operation)
        own = [a for a in arguments if type(a) is int]
        self.free.append(any(self.free[a] for a in own) or (kind == "leaf" and is_free(at)))
        self.truth.append(
            kind in CONDITIONS
            or (kind in MOVED and len(own) == len(arguments) and all(self.truth[a] for a in own))
        )

    def replayed(self, record: Record, leaf: Callable[[str, str, Shape], Any]) -> list[Any]:
        """Write a record down again on other leaves; return its outputs."""
        values: list[Any] = []
        for kind, arguments, shape, at in record.operations:
            refs = [operand(values[a]) if type(a) is int else a for a in arguments]
            values.append(
                leaf(at[0], at[1], shape) if kind == "leaf" else self.add(kind, refs, shape, at)
            )
        return [values[ref] if type(ref) is int else ref for ref in record.outputs]

    def question(self, ref: Any) -> Any:
        """Answer where Python asks for a truth value, numbers or a whole number."""
        raise Unread("what Python asks of a signal")

    numbers = whole = parameter = question


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
            apart = one.mask._ref != self.mask._ref if isinstance(one, Masked) else np.ndim(one)
            if apart or method != "__call__":
                raise Unread("joins elements taken by a condition with others; write np.where")
        own = [one.full if isinstance(one, Masked) else one for one in inputs]
        return Masked(ufunc(*own, **more), self.mask)

    def sum(self, axis: Any = None, dtype: Any = None, out: Any = None) -> Any:
        """Return the sum of the elements."""
        return np.sum(where(self.mask, self.full, 0.0), dtype=dtype)


class Array(NDArrayOperatorsMixin):
    """A value of a tape, of a known shape, used as NumPy's arrays are."""

    __slots__ = (
        *("_boxed", "_fixed", "_node", "_parent", "_select", "_shape", "_store", "_tape", "_whole"),
    )
    __array_priority__ = 1000

    def __init__(self, tape: Tape, node: int, shape: Shape, parent: Any = None, select: Any = None):
        self._tape, self._node, self._shape = tape, node, shape
        self._fixed = False  # whether nothing may be written into it
        self._boxed = False  # whether, without axes, it is NumPy's array and no number
        self._whole = False  # whether what is written into it is cut to a whole number
        self._parent: Array | None = parent
        self._select = select  # takes this part of the parent's elements
        self._store: np.ndarray | None = None  # its elements, once one was written

    # --- the value ----------------------------------------------------------------------

    shape = property(attrgetter("_shape"), doc="Its shape, which nobody sets.")

    @property
    def _ref(self) -> Ref:
        """Its place on the tape, as it stands now."""
        store = self._written()
        return self._node if store is None else operand(lifted(self._tape, store))

    @property
    def _root(self) -> "Array":
        """The array that it is a part of."""
        return self if self._parent is None else self._parent._root

    def _keep(self) -> None:
        """Keep each element by itself from now on."""
        if self._store is None:
            self._store = self._elements()

    def _blank(self) -> np.ndarray:
        """Return an array without numbers that lies in memory as NumPy's would."""
        if self._parent is None:
            return np.empty(self._counted())
        return self._select(self._parent._blank())

    def _written(self) -> np.ndarray | None:
        """Return its elements, once one was written; parts share them, as NumPy's views do."""
        if self._store is None and self._parent is not None:
            above = self._parent._written()
            if above is not None:
                self._store = np.asarray(self._select(above), dtype=object)
        return self._store

    @property
    def ndim(self) -> int:
        """Number of axes."""
        return len(self.shape)

    @property
    def size(self) -> int:
        """Number of elements."""
        return prod(self._counted())

    @property
    def dtype(self) -> np.dtype:
        """What NumPy's array would hold."""
        return np.dtype(bool if self._is_condition else float)

    @property
    def _is_condition(self) -> bool:
        """Whether it holds truth values."""
        return self._store is None and self._tape.truth[self._node]

    def _counted(self) -> tuple[int, ...]:
        """Return the shape in whole numbers; refuse an open size."""
        for n in self.shape:
            if not isinstance(n, int):
                raise Unread(f"counting with the open size {n}")
        return self.shape

    # --- elements -----------------------------------------------------------------------

    def __len__(self) -> int:
        if not self.shape:
            raise TypeError("len() of unsized object")
        return self._counted()[0]

    def __iter__(self) -> Iterator[Any]:
        return (self[k] for k in range(len(self)))

    def __getitem__(self, index: Any) -> Any:
        return HOOKS["item"](self, index if isinstance(index, tuple) else (index,))

    def __setitem__(self, index: Any, value: Any) -> None:
        root = self._root
        if root._fixed or root._is_condition:
            what = "truth values" if root._is_condition else "its states, inputs or parameters"
            raise Unread(f"writes into {what}; write into a copy")
        root._keep()
        store = self._written()
        assert store is not None
        if isinstance(value, Masked):
            if getattr(index, "_ref", None) != value.mask._ref:
                raise Unread("puts elements taken by one condition where another holds")
            value = value.full
        value = lifted(self._tape, value)
        if root._whole:
            value = np.trunc(value)
        if isinstance(index, Array) and index._is_condition and not moves(index):
            index = np.asarray(index)
        elif isinstance(index, Array) and index._is_condition:
            index, value = ..., where(index, value, self)
        index, new = whole(index), objects(value)
        store[index] = new if isinstance(store[index], np.ndarray) else new.item()

    def _elements(self) -> np.ndarray:
        """Return its elements in an array of objects."""
        if (store := self._written()) is not None:
            return store.copy()
        known = numbers_of(self)
        if known is not None:
            return known.astype(object)
        found = np.empty(self.size, dtype=object)
        for k, place in enumerate(np.ndindex(self.shape)):
            found[k] = self[place] if self.shape else Array(self._tape, self._node, ())
        return found.reshape(self.shape)

    # --- NumPy's protocols ----------------------------------------------------------------

    def __array_ufunc__(self, ufunc: Any, method: str, *inputs: Any, **more: Any) -> Any:
        if not self.shape and not more and ufunc in UFUNCS and method == "__call__":
            return elementwise(UFUNCS[ufunc], *inputs)
        return HOOKS["ufunc"](self._tape, ufunc, method, inputs, more)

    def __array_function__(self, function: Any, types: Any, inputs: Any, more: Any) -> Any:
        return HOOKS["function"](self._tape, function, inputs, more)

    def __array__(self, dtype: Any = None, copy: Any = None) -> np.ndarray:
        if dtype is not None and np.dtype(dtype).kind == "O":
            return self._elements()
        return self._tape.numbers(self._ref).astype(dtype or self.dtype)

    def __getattr__(self, name: str) -> Any:
        if (method := HOOKS["method"](name)) is not None:
            return partial(method, self)
        raise AttributeError(f"an array of the record has no {name!r}")

    def __eq__(self, other: Any) -> Any:
        return False if other is None or isinstance(other, str) else np.equal(self, other)

    def __ne__(self, other: Any) -> Any:
        return True if other is None or isinstance(other, str) else np.not_equal(self, other)

    real = property(lambda self: self)
    imag = property(lambda self: np.zeros(self._counted())[()])
    flat = property(lambda self: iter(self._elements().ravel()))
    T = property(lambda self: self.transpose())

    # --- Python asks for a value ----------------------------------------------------------

    def __bool__(self) -> bool:
        one = single(self)
        if not isinstance(one, Array):
            return bool(one)
        if one.shape:
            raise ValueError("the truth value of an array with more than one element is ambiguous")
        return self._tape.question(as_condition(one)._ref)

    def __float__(self) -> float:
        return float(self._tape.numbers(self._ref).item())

    __complex__ = __float__

    def __int__(self) -> int:
        return int(self._tape.numbers(self._ref).item())

    def __index__(self) -> int:
        return self._tape.whole(self)

    def __format__(self, spec: str) -> str:
        ref = self._ref
        value = ref if type(ref) is float else self._tape.parameter(ref)
        return repr(self) if value is None else format(value, spec)

    def __str__(self) -> str:
        return format(self, "")

    def __hash__(self) -> int:
        if self.shape:
            raise TypeError("unhashable type: 'numpy.ndarray'")
        if moves(self):
            raise Unread("looks a signal up in a dict or set; write `if`, or lookup of a row")
        return hash(self._tape.numbers(self._ref).item())

    def __round__(self, digits: Any = None) -> Any:
        if digits and not is_of_numpy(self):
            raise Unread("rounds to digits, which Python does otherwise than np.round")
        return np.round(self, digits) if digits else np.round(self) + 0.0  # as a whole number

    def __repr__(self) -> str:
        return f"<v{self._node} {self.shape}>"


def moves(value: Any) -> bool:
    """Return whether a value depends on time, states or inputs."""
    ref = value._ref if isinstance(value, Array) else 0.0
    return type(ref) is int and value._tape.free[ref]


def is_of_numpy(number: Array) -> bool:
    """Return whether a number is surely one of NumPy's, not of Python's."""
    return moves(number) and not number._tape.has_floats


def numbers_of(array: Array) -> np.ndarray | None:
    """Return an array that depends on nothing as numbers; None for any other."""
    store = array._written()
    if store is None:
        if type(array) is not Array:  # all states or inputs
            return None
        own = array._tape.operations[array._node]
        return np.frombuffer(own.at).reshape(own.shape) if own.kind == "constant" else None
    plain = all(type(one) is not Array for one in store.flat)
    return store.astype(float) if plain else None


def whole(index: Any) -> Any:
    """Return an index in whole numbers; each signal in it is asked which one it is."""
    if isinstance(index, tuple):
        return tuple(map(whole, index))
    if not isinstance(index, Array):
        return index
    return [one.__index__() for one in index] if index.shape else index.__index__()


def single(value: Any) -> Any:
    """Return the number in an array of one, which `math` and float take."""
    if isinstance(value, Array) and value.shape and value.size == 1:
        return value[(0,) * value.ndim]
    return value


def objects(value: Any) -> np.ndarray:
    """Return an array of objects."""
    return value._elements() if isinstance(value, Array) else np.asarray(value, dtype=object)


def operand(value: Any) -> Ref:
    """Return a value's place, or a constant."""
    return value._ref if isinstance(value, Array) else float(value)


def lifted(tape: Tape, value: Any) -> Any:
    """Return a number as it is, and what NumPy makes arrays of as an array of the record."""
    if isinstance(value, Array):
        if value._tape is not tape:
            raise Unread("keeps values from one call to the next; make them states")
        return value
    if isinstance(value, bool | int | float | np.bool_ | np.integer | np.floating):
        return float(value)
    if isinstance(value, np.ndarray) and type(value) not in (np.ndarray, np.memmap):
        raise Unread(f"calculating with a {type(value).__name__}; write np.asarray of it")
    try:
        if isinstance(value, np.ndarray) and value.dtype != object:
            return constant(tape, value)
        if isinstance(value, np.ndarray) and not value.ndim:
            return lifted(tape, value.item())
        if isinstance(value, str):  # each of its letters is a text again
            raise TypeError
        parts = [lifted(tape, one) for one in value]
    except TypeError:
        raise Unread(f"calculating with a {type(value).__name__}") from None
    if not parts:
        return constant(tape, np.asarray(value, dtype=float))
    new, of = stacked(tape, parts), zip(parts, value, strict=True)
    new._whole = all(counts(part if isinstance(part, Array) else one) for part, one in of)
    return new


def constant(tape: Tape, value: np.ndarray) -> Any:
    """Return an array of numbers; a single one is a float."""
    value = np.asarray(value, order="C")  # ascontiguousarray would make an axis of a number
    if value.dtype.kind not in "fiub":
        raise Unread(f"calculating with an array of {value.dtype}")
    value = value.astype(float)
    return tape.add("constant", (), value.shape, value.tobytes()) if value.shape else float(value)


def filled(tape: Tape, value: Any, shape: Shape) -> Any:
    """Return an array of a shape that holds one number everywhere."""
    if type(value) is float and all(isinstance(n, int) for n in shape):
        return constant(tape, np.full(shape, value))
    return tape.add("fill", (operand(value),), shape)


def spread(tape: Tape, value: Any, shape: Shape) -> Any:
    """Return a value broadcast to a shape."""
    own = getattr(value, "shape", ())
    if own == shape:
        return value
    whole = tape.add("fill", (0.0 if own else operand(value),), shape)
    return elementwise("add", whole, value) if own else whole


def stacked(tape: Tape, parts: Sequence[Any]) -> Any:
    """Return arrays of one shape along a new first axis."""
    shapes = {getattr(part, "shape", ()) for part in parts}
    if len(shapes) > 1:
        raise ValueError(
            f"all input arrays must have the same shape, not {sorted(map(str, shapes))}"
        )
    if not all(map(is_truth, parts)):
        parts = [as_number(part) for part in parts]
    refs = [operand(part) for part in parts]
    if all(type(ref) is float for ref in refs):
        return constant(tape, np.array(refs))
    seen = HOOKS["tape_view"](tape, refs)
    return tape.add("stack", refs, (len(refs), *shapes.pop())) if seen is None else seen


def elementwise(name: str, *arguments: Any) -> Any:
    """Return an elementwise operation of arrays and numbers."""
    tape = next(a._tape for a in arguments if isinstance(a, Array))
    refs, shapes = [], set()
    if name not in TRUTHS_ALLOWED and all(map(is_truth, arguments)):
        if name not in OF_TRUTHS:
            raise Unread(
                "calculates with truth values alone, of which NumPy and Python make different "
                "things; write float(...), or np.logical_or"
            )
        name = OF_TRUTHS[name]
    if name in RAISING and (tape.has_floats or not moves(arguments[-1])):
        refuse_in_a_try(arguments[-1])
    for k, one in enumerate(arguments):
        convert = as_condition if name in LOGICAL or (name == "where" and not k) else as_number
        one = one if type(one) is float else convert(lifted(tape, one))
        if isinstance(one, Array):
            shapes.add(one.shape)
        refs.append(operand(one))
    shape = shapes.pop() if len(shapes) == 1 else broadcast(*shapes)
    new = tape.add(name, refs, shape)
    new._whole = name in OF_WHOLE and all(map(counts, arguments[name == "where" :]))
    return new


def counts(value: Any) -> bool:
    """Return whether NumPy has it as whole numbers, or as truth values."""
    if isinstance(value, Array):
        return value._whole or value._is_condition
    kind = getattr(getattr(value, "dtype", None), "kind", "f")
    return isinstance(value, int) or kind in "iub"


def refuse_in_a_try(*arguments: Any) -> None:
    """Refuse what may raise with these, signals or zero, where a function may catch it."""
    if in_a_try() and any(moves(one) or not np.all(one) for one in arguments):
        raise Unread("may raise in a `try`; ask by `if` before")


READ = "__read__"  # among the built-in names of a copy that is read


def in_a_try() -> bool:
    """Return whether a function that is read may catch what is raised now."""
    frame = sys._getframe(1)
    while frame is not None and frame.f_globals.get("__name__") != f"{__package__}.reading":
        names = frame.f_globals.get("__builtins__")
        if isinstance(names, dict) and READ in names and frame.f_code.co_exceptiontable:
            return True
        frame = frame.f_back  # type: ignore[assignment]
    return False


def as_number(value: Any) -> Any:
    """Return truth values as 1 and 0, and all else as it is."""
    if isinstance(value, Array) and value._is_condition:
        return value._tape.add("where", (value._ref, 1.0, 0.0), value.shape)
    return value


def as_condition(value: Any) -> Any:
    """Return numbers as conditions: whether they are not zero."""
    if isinstance(value, Array) and not value._is_condition:
        return elementwise("ne", value, 0.0)
    return value


def is_truth(value: Any) -> bool:
    """Return whether a value is a truth value, or an array of them."""
    if isinstance(value, Array):
        return value._is_condition
    return isinstance(value, bool | np.bool_) or getattr(value, "dtype", None) == TRUTH


def boxed(tape: Tape, value: Any) -> Any:
    """Return a number as an array without axes: ``+=`` changes it by each name that it has."""
    if type(value) is float:
        value = tape.add("fill", (value,), ())
    if not isinstance(value, Array) or value.shape or value._boxed or value._is_condition:
        return value
    new = Array(tape, value._node, ())
    new._boxed, new._whole = True, value._whole
    return new


def where(condition: Any, a: Any, b: Any) -> Any:
    """Return a where a condition holds, else b."""
    if not isinstance(condition, Array) and not np.ndim(condition):
        return a if condition else b
    if is_truth(a) and is_truth(b):
        condition = as_condition(condition)
        parts = [_both(condition, a), _both(elementwise("not", condition), b)]
        found = [part for part in parts if part is not None]
        return elementwise("or", *found) if len(found) > 1 else found[0] if found else False
    return elementwise("where", condition, a, b)


def _both(condition: Array, truth: Any) -> Array | None:
    """Return whether both hold; None for never."""
    if isinstance(truth, Array) or np.ndim(truth):
        return elementwise("and", condition, truth)
    return condition if truth else None


def total(array: Array, axis: int) -> Any:
    """Return the sum over one axis."""
    array = as_number(array)
    axis %= array.ndim
    shape = array.shape[:axis] + array.shape[axis + 1 :]
    return array._tape.add("sum", (array._ref,), shape, axis)
