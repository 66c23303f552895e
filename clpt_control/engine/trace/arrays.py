"""Tracer arrays: the arguments of a function while it is traced.

An `Array` is a value of a record that grows, the `Tape`.  NumPy's own protocols record each
operation: ``np.exp(a)``, ``a @ b``, ``np.outer(a, b)``.  An array into which a function writes
(``y[0] = ...``) stores its elements one by one, and its views share them, as NumPy's views do.
"""

import sys
from collections.abc import Iterator, Sequence
from functools import partial
from math import prod
from typing import Any

import numpy as np
from numpy.lib.mixins import NDArrayOperatorsMixin

from ..record.graph import Operation, Ref, Shape, key_of, values_among
from ..record.operations import CONDITIONS, UFUNCS
from ..record.unread import Unread

OUTLIVES = "which outlives the call"  # in each sentence on hidden state
REMEMBERS = (
    f"writes to {{}}, {OUTLIVES}, and machine code keeps nothing between calls. "
    "Make it a state, set it in a jump, or use parts.relay or parts.backlash"
)
LASTING = "an array"  # that outlives the call, for the sentence
MOST_OPERATIONS = 200_000  # a longer record is given up
MOVED = frozenset({"view", "stack", "join", "part"})  # hold what their arguments hold

# functions of modules that import this one, by name; each module registers its own
HOOKS: dict[str, Any] = {}


class Tape:
    """A record that grows; equal operations are one value."""

    def __init__(self) -> None:
        self.operations: list[Operation] = []
        self.stopped: Unread | None = None  # why tracing stops
        self.runs = 0  # execution paths so far, of helpers too
        self.texts: Unread | None = None  # error of a text that was made of a signal
        self.merging = False  # whether statements and helpers are merged
        self.free: list[
            bool
        ] = []  # of each: whether it depends on time, states or inputs
        self.truth: list[bool] = []  # of each: whether it holds truth values
        self._known: dict[Any, int] = {}

    def add(
        self, kind: str, arguments: Sequence[Ref], shape: Shape, at: Any = None
    ) -> "Array":
        """Return the value of an operation; record the operation if it is new."""
        key = kind, tuple(map(key_of, arguments)), shape, at
        if (ref := self._known.get(key)) is None:
            ref = self._known[key] = len(self.operations)
            self.append(Operation(kind, tuple(arguments), shape, at))
            if ref > MOST_OPERATIONS:
                raise Unread(f"takes more than {MOST_OPERATIONS} operations")
        return Array(self, ref, shape)

    def value(self, ref: Ref) -> Any:
        """Return the value of a reference: an array, or a number as it is."""
        return Array(self, ref, self.operations[ref].shape) if type(ref) is int else ref

    def append(self, operation: Operation) -> None:
        """Record an operation, even if an equal one is on the tape."""
        kind, arguments, _, static = operation
        self.operations.append(operation)
        values = values_among(arguments)
        # during a run
        changes = kind == "leaf" and (static[0] != "p" or static[1] == "interval")
        self.free.append(changes or any(self.free[a] for a in values))
        self.truth.append(
            kind in CONDITIONS
            or (
                kind in MOVED
                and len(values) == len(arguments)
                and all(self.truth[a] for a in values)
            )
        )

    def question(self, ref):
        """Return a truth value, numbers or a whole number, if Python needs one."""
        raise Unread("what Python asks of a signal")

    numbers = whole = parameter = question


class Array(NDArrayOperatorsMixin):
    """A value of a tape, with a shape and the interface of NumPy's arrays."""

    __slots__ = (
        "_below",
        "_boxed",
        "_fixed",
        "_node",
        "_of_python",
        "_parent",
        "_select",
        "_shape",
        "_store",
        "_tape",
        "_whole",
    )
    __array_priority__ = 1000

    def __init__(
        self,
        tape: Tape,
        node: int,
        shape: Shape,
        parent: Any = None,
        select: Any = None,
    ):
        self._tape = tape
        self._node = node
        self._shape = shape
        self._fixed: Any = False  # whether it is read-only, or LASTING
        self._boxed = False  # without axes: an array of NumPy, and no number
        # NumPy's integers, and Python's own number; None if that depends on a branch
        self._whole: bool | None = False
        self._of_python: bool | None = False
        self._below: int | None = None  # upper bound of a whole number from 0 on
        self._parent: Array | None = parent
        # function of NumPy from the parent's elements to this view's
        self._select = select
        self._store: np.ndarray | None = None  # elements, after one was written

    # --- the value ----------------------------------------------------------------------

    @property
    def shape(self) -> Shape:
        """Shape, which is read-only."""
        if self._of_python:
            refuse_of_python("shape")
        return self._shape

    @property
    def _ref(self) -> Ref:
        """Reference of its present value on the tape."""
        store = self._written()
        return (
            self._node if store is None else operand(HOOKS["lifted"](self._tape, store))
        )

    @property
    def _root(self) -> "Array":
        """Array of which this one is a view, or itself."""
        return self if self._parent is None else self._parent._root

    def _keep(self) -> None:
        """Store each element separately from now on."""
        if self._store is None:
            self._store = self._elements()

    def _blank(self) -> np.ndarray:
        """Return an array of NumPy with the same layout in memory."""
        if self._parent is None:
            return np.empty(self._counted())
        return self._select(self._parent._blank())

    def _written(self) -> np.ndarray | None:
        """Return the elements if one was written; views share them."""
        if self._store is None and self._parent is not None:
            above = self._parent._written()
            if above is not None:
                self._store = np.asarray(self._select(above), dtype=object)
        return self._store

    @property
    def ndim(self) -> int:
        """Number of axes."""
        if self._of_python is not False:
            refuse_of_python("ndim")
        return len(self._shape)

    @property
    def size(self) -> int:
        """Number of elements."""
        if self._of_python is not False:
            refuse_of_python("size")
        return prod(self._counted())

    @property
    def dtype(self) -> np.dtype:
        """Type of the numbers: bool or float."""
        if self._of_python is not False:
            refuse_of_python("dtype")
        return np.dtype(bool if self._is_condition else float)

    @property
    def _is_condition(self) -> bool:
        """True for an array of truth values."""
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

    def __getitem__(self, index):
        return HOOKS["item"](self, index if isinstance(index, tuple) else (index,))

    def __setitem__(self, index: Any, value: Any) -> None:
        HOOKS["put"](self, index, value)

    def _elements(self) -> np.ndarray:
        """Return the elements in an array of objects."""
        if (store := self._written()) is not None:
            return store.copy()
        if (numbers := numbers_of(self)) is not None:
            return numbers.astype(object)
        elements = (
            self[index] if self.shape else Array(self._tape, self._node, ())
            for index in np.ndindex(self._counted())
        )
        return np.fromiter(elements, object).reshape(self.shape)

    # --- NumPy's protocols ----------------------------------------------------------------

    def __array_ufunc__(
        self, ufunc: Any, method: str, *inputs: Any, **options: Any
    ) -> Any:
        if not self.shape and not options and ufunc in UFUNCS and method == "__call__":
            return HOOKS["elementwise"](UFUNCS[ufunc], *inputs)
        return HOOKS["ufunc"](ufunc, method, self._tape, *inputs, **options)

    def __array_function__(self, function, types, inputs, options):
        return HOOKS["function"](function, self._tape, *inputs, **options)

    def __array__(self, dtype: Any = None, copy: Any = None) -> np.ndarray:
        if dtype is not None and np.dtype(dtype).kind == "O":
            return self._elements()
        return self._tape.numbers(self._ref).astype(dtype or self.dtype)

    def __getattr__(self, name: str) -> Any:
        if self._of_python is not False:
            refuse_of_python(name)
        if (method := HOOKS["method"](name)) is not None:
            return partial(method, self)
        raise AttributeError(f"an array of the record has no {name!r}")

    def __eq__(self, other):
        if getattr(other, "__array_ufunc__", self) is None:
            return NotImplemented
        return (
            False if other is None or isinstance(other, str) else np.equal(self, other)
        )

    def __ne__(self, other):
        return (
            True
            if other is None or isinstance(other, str)
            else np.not_equal(self, other)
        )

    real = property(lambda self: self)
    flat = property(lambda self: iter(self._elements().ravel()))
    T = property(lambda self: self.transpose())

    # --- Python asks for a value ----------------------------------------------------------

    def __bool__(self) -> bool:
        number = single(self)
        if not isinstance(number, Array):
            return bool(number)
        if number.shape:
            raise ValueError(
                "the truth value of an array with more than one element is ambiguous"
            )
        return self._tape.question(
            (number if number._is_condition else number != 0.0)._ref
        )

    def __float__(self) -> float:
        return float(self._tape.numbers(self._ref).item())

    def __int__(self) -> int:
        return int(float(self))

    def __index__(self) -> int:
        return self._tape.whole(self)

    def __format__(self, spec: str) -> str:
        ref = self._ref
        value = ref if type(ref) is float else self._tape.parameter(ref)
        if value is not None:
            return format(value, spec)
        # of an error, it may
        self._tape.texts = Unread("makes a text of a signal", stops=False)
        return repr(self)

    def __str__(self) -> str:
        return format(self, "")

    def __hash__(self) -> int:
        if self.shape:
            raise TypeError("unhashable type: 'numpy.ndarray'")
        if moves(self):
            raise Unread(
                "looks a signal up in a dict or set. Write `if`, or lookup of a row"
            )
        return hash(float(self))

    def __round__(self, digits=None):
        if digits and self._of_python is not False:
            raise Unread("rounds to digits, which Python does otherwise than np.round")
        if digits is not None:
            return np.round(self, digits)
        new: Any = np.round(self) + 0.0  # as a whole number
        new._of_python = new._whole = True
        return new

    def __repr__(self) -> str:
        return f"<v{self._node} {self.shape}>"


ENGINE = __package__.rpartition(".")[0]


def refuse_of_python(name: str) -> None:
    """Raise where a user's function reads an attribute that Python's own numbers do not have."""
    user = sys._getframe(2).f_globals.get("__name__", "")
    if not (user.startswith((ENGINE, "numpy")) or hasattr(0.0, name)):
        raise AttributeError(f"'float' object has no attribute {name!r}")


def moves(value: Any) -> bool:
    """Return whether a value depends on time, states or inputs."""
    ref = value._ref if isinstance(value, Array) else 0.0
    return type(ref) is int and value._tape.free[ref]


def numbers_of(array: Array) -> np.ndarray | None:
    """Return the numbers of a constant array; None for any other."""
    store = array._written()
    if store is None:
        if type(array) is not Array:  # all states or inputs
            return None
        operation = array._tape.operations[array._node]
        return (
            np.frombuffer(operation.at).reshape(operation.shape)
            if operation.kind == "constant"
            else None
        )
    plain = all(type(element) is not Array for element in store.flat)
    return store.astype(float) if plain else None


def whole(index):
    """Return an index in whole numbers; each signal in it becomes one on each path."""
    if isinstance(index, tuple):
        return tuple(map(whole, index))
    if not isinstance(index, Array):
        return index
    return [item.__index__() for item in index] if index.shape else index.__index__()


def single(value):
    """Return the number in an array of one element, which `math` and float accept."""
    if isinstance(value, Array) and value.shape and value.size == 1:
        return value[(0,) * value.ndim]
    return value


def objects(value: Any) -> np.ndarray:
    """Return an array of objects."""
    return (
        value._elements()
        if isinstance(value, Array)
        else np.asarray(value, dtype=object)
    )


def operand(value: Any) -> Ref:
    """Return the reference of a value: its index on the tape, or a number."""
    return value._ref if isinstance(value, Array) else float(value)
