"""Copies of functions, whose modules and built-in names are stand-ins.

A function runs as it is written; only what its names stand for is replaced, in a copy of it and
of the functions that it calls by name.  A helper that is reached through an object runs with its
own names; where it asks for the number of a signal, `Borrowed` puts stand-ins into its module for
the length of a reading, under a lock, and then puts the module's own names back.

Objects and containers that a function reaches could keep something from one call to the next
(`Snapshot`): a reading leaves them as they were.  What the first reading changed is unknown to the
second, a leaf of its own, or a text as it was left: a record that depends on it is no function of
time, states and inputs.
What holds no leaf, an array or a generator of chance, may not change at all.
"""

import functools
import pickle
import random
import sys
import threading
from array import array
from collections import deque
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from enum import Enum
from io import IOBase
from operator import is_
from types import (
    BuiltinFunctionType,
    CellType,
    FunctionType,
    MethodType,
    ModuleType,
    NoneType,
)
from typing import Any

import numpy as np

from .arrays import Array, Tape, Unread
from .lookup_tables import is_table
from .stand_ins import BUILTINS, SHADOWS, UNSEEDED, stand_in, vectorized
from .unchanged import MOST as MOST_NUMBERS
from .unchanged import names_in, texts_in
from .views import fresh

LIBRARIES = ("numpy", "scipy", "matplotlib")  # run as they are
READERS = tuple(f"{__package__}.{name}" for name in ("arrays", "record", "views"))  # that read
_LOCK = threading.RLock()
_NONE = object()
OF_WARNINGS = "__warningregistry__"  # which Python puts into the module that it warns of
DEEP = 3  # objects within objects
MOST = 200  # objects that are remembered
OWN = __package__.partition(".")[0]
GROWN = 1000  # unknown numbers behind what was appended
SIMPLE = (int, float, complex, str, bytes, np.generic, Enum, np.ndarray, NoneType)
NUMBERS = (int, float, complex, np.generic, np.ndarray, Array)
PLAIN = (int, float, str, bytes, tuple, Array)
CHANCE: dict[type, tuple[Callable, Callable]] = {  # its state, to be compared, and put back
    np.random.Generator: (
        lambda own: pickle.dumps(own.bit_generator.state),
        lambda own, state: setattr(own.bit_generator, "state", pickle.loads(state)),
    ),
    np.random.RandomState: (
        lambda own: [v if np.isscalar(v) else v.tobytes() for v in own.get_state()],
        lambda own, state: own.set_state((state[0], np.frombuffer(state[1], "u4"), *state[2:])),
    ),
    random.Random: (random.Random.getstate, random.Random.setstate),
}
OF_ALL: tuple[Any, ...] = (  # whose numbers the functions of these modules draw
    vars(random)["random"].__self__,
    vars(np.random)["random"].__self__,
)


class Copies:
    """The copies of one reading; `check` refuses a function that changed a name outside it."""

    def __init__(self, tape: Tape, snapshot: "Snapshot") -> None:
        self.tape, self.snapshot = tape, snapshot
        self._known: dict[int, tuple[Any, Any]] = {}  # a value, alive, and what stands for it
        self._spaces: dict[int, tuple[dict, dict]] = {}  # names of a module: copied, as they began
        self._cells: list[tuple[CellType, Any, str]] = []
        self.texts: set[Any] = set()  # in the functions, which may be names of params

    def of(self, value: Any) -> Any:
        """Return what stands for a value: a copy of a function, a stand-in, or itself."""
        if isinstance(value, int | float | str):
            self.texts.add(value)
            return value
        if id(value) not in self._known:
            self._known[id(value)] = value, value  # of a value that holds itself
            self._known[id(value)] = value, self._stand_in_of(value)
        return self._known[id(value)][1]

    def _stand_in_of(self, value: Any) -> Any:
        if isinstance(value, FunctionType):
            return self._function(value)
        if type(value) is np.ndarray and value.dtype == float and value.size:
            return self._numbers(value)
        if is_table(value):
            return stand_in(value)
        if isinstance(value, Iterator) and not isinstance(value, IOBase):
            raise Unread("reads an iterator, which goes on at the next call; make it a list")
        self.snapshot.add(value)
        if isinstance(value, MethodType):
            self.snapshot.add(value.__self__)
            for kind in type(value.__self__).__mro__:
                own = (one for one in vars(kind).values() if isinstance(one, FunctionType))
                self.texts.update(*(texts_in(one.__code__) for one in own))
            return MethodType(self.of(value.__func__), value.__self__)
        if isinstance(value, functools.partial):
            keywords = {name: self.of(one) for name, one in value.keywords.items()}
            return functools.partial(self.of(value.func), *map(self.of, value.args), **keywords)
        if isinstance(value, functools._lru_cache_wrapper) or hasattr(value, "py_func"):
            return self.of(getattr(value, "py_func", None) or value.__wrapped__)
        if isinstance(value, np.vectorize):
            return vectorized(np.vectorize(self.of(value.pyfunc)))
        if type(value) in (list, tuple) and len(value) < 100:
            own_items = [self.of(one) for one in value]
            changed = any(a is not b for a, b in zip(own_items, value, strict=True))
            return type(value)(own_items) if changed else value
        if type(value) is dict and len(value) < 100:
            self.texts.update(value)
            items = {key: self.of(one) for key, one in value.items()}
            return items if any(items[key] is not value[key] for key in value) else value
        return stand_in(value)

    def _numbers(self, value: np.ndarray) -> Any:
        """Return numbers as an array of the record, which takes signals where NumPy's does not."""
        numbers = fresh(self.tape, value)
        if isinstance(numbers, Array):
            numbers._fixed = True
        return numbers

    def _function(self, function: FunctionType) -> Any:
        if (function.__module__ or "").partition(".")[0] in LIBRARIES:
            return stand_in(function)
        if function.__module__ in READERS:
            return function
        self.texts.update(texts_in(function.__code__))
        space, first = self._space(function.__globals__)
        cells = tuple(CellType() for _ in function.__closure__ or ())
        copy = FunctionType(function.__code__, space, function.__name__, None, cells or None)
        copy.__module__, copy.__qualname__ = function.__module__, function.__qualname__
        self._known[id(function)] = function, copy
        attributes = {name: v for name, v in vars(function).items() if not name.startswith("__")}
        vars(copy).update({name: self.of(value) for name, value in attributes.items()})
        self._spaces[id(copy)] = vars(copy), dict(vars(copy))
        copy.__defaults__ = function.__defaults__ and tuple(map(self.of, function.__defaults__))
        if function.__kwdefaults__:
            copy.__kwdefaults__ = {k: self.of(v) for k, v in function.__kwdefaults__.items()}
        names = function.__code__.co_freevars
        for cell, old, name in zip(cells, function.__closure__ or (), names, strict=True):
            try:
                cell.cell_contents = self.of(old.cell_contents)
                self._cells.append((cell, cell.cell_contents, name))
            except ValueError:  # not bound yet
                continue
        for name in names_in(function.__code__):
            if name in function.__globals__ and first[name] is space[name]:
                space[name] = first[name] = self.of(function.__globals__[name])
        return copy

    def _space(self, names: dict[str, Any]) -> tuple[dict, dict]:
        if id(names) not in self._spaces:
            copied = {**names, "__builtins__": BUILTINS}
            self._spaces[id(names)] = copied, dict(copied)
        return self._spaces[id(names)]

    def check(self) -> None:
        """Refuse a function that changed a name outside it: what it keeps is a state."""
        for space, first in self._spaces.values():
            if len(space) == len(first) and all(map(is_, space.values(), first.values())):
                continue
            for name, value in space.items():
                if value is not first.get(name, _NONE) and name != OF_WARNINGS:
                    raise Unread(f"changes the global {name!r}; make it a state, or a parameter")
        for cell, first, name in self._cells:
            if cell.cell_contents is not first:
                raise Unread(f"changes {name!r} of the function around it; make it a state")


class Snapshot:
    """The state of objects as it was before a reading."""

    def __init__(self) -> None:
        self._objects: dict[int, tuple[Any, Any, Any]] = {}  # object, what holds its state, before
        self._changed: dict[tuple[int, Any], tuple[Any, Any, list]] = {}  # holder, before, since
        self._rows: dict[int, Any] = {}  # lists that changed
        self._kept: dict[int, tuple[Any, Any]] = {}  # what holds no leaf, as it was
        self.refused = ""  # why, where one of these changed
        for one in OF_ALL:
            self.add(one)

    def add(self, value: Any, deep: int = DEEP) -> None:
        """Remember an object, and those within it."""
        value = getattr(value, "__func__", value)  # of a method
        if value is None or isinstance(value, (*PLAIN, BuiltinFunctionType)):
            return
        if id(value) in self._objects or len(self._objects) + len(self._kept) >= MOST:
            return
        if (kept := _kept_in(value)) is not None:
            self._kept[id(value)] = value, kept
            return
        inside = _container_of(value)
        if inside is None:
            return
        with _LOCK:  # no other thread's stand-ins are in a module
            before = inside.copy()
        self._objects[id(value)] = value, inside, before
        if deep:
            for one in list(before.values() if isinstance(before, dict) else before)[:MOST]:
                self.add(one, deep - 1)
            if not isinstance(value, list | dict | deque | type | ModuleType | FunctionType):
                self.add(type(value), deep)
            for function in vars(value).values() if isinstance(value, type) else ():
                self.add(function, deep - 1)

    @property
    def turns(self) -> int:
        """How many readings there are after the first, so that each text that was left is read."""
        return max((len(values) for *_, values in self._changed.values()), default=1)

    def hide(self, leaf: Any, turn: int) -> None:
        """Put unknown numbers where numbers changed, and in turn what else was left.

        A list may then be any, and longer.
        """
        for k, ((_, key), (inside, before, values)) in enumerate([*self._changed.items()]):
            now = values[(turn - 1) % len(values)]
            unknown = isinstance(now, Array) or (before is not None and isinstance(now, NUMBERS))
            inside[key] = leaf(k) if unknown else now
            self.add(now)
        for place, row in self._rows.items():
            count = len(row) + GROWN
            row.clear()
            row.extend([leaf(place)] * count)

    def restore(self) -> None:
        """Make all as it was; note what had changed."""
        for value, kept in self._kept.values():
            if _kept_in(value) != kept:
                self.refused = _put_back(value, kept)
        for place, (_, inside, before) in self._objects.items():
            with _LOCK:
                now = inside.copy()
            if isinstance(inside, list | deque):
                if len(now) != len(before) or not all(map(is_, now, before)):
                    self._rows[place] = inside
                    inside.clear()
                    inside.extend(before)
                continue
            changed = [k for k, one in now.items() if one is not before.get(k, _NONE)]
            if changed or len(now) != len(before):
                for key in changed:
                    was = inside, before.get(key), list[Any]()
                    *_, values = self._changed.setdefault((place, key), was)
                    if not any(_alike(now[key], one) for one in values):
                        values.append(now[key])
                inside.clear()
                inside.update(before)


def _alike(a: Any, b: Any) -> bool:
    """Return whether what two calls left is one: of signals and objects only the first counts."""
    if isinstance(a, np.ndarray) and isinstance(b, np.ndarray):
        return a.tobytes() == b.tobytes()
    return not isinstance(a, SIMPLE) or (type(a) is type(b) and a == b)


def _kept_in(value: Any) -> Any:
    """Return what a thing keeps that can hold no leaf, to be compared; None for any other."""
    if not isinstance(value, (*CHANCE, set, np.ndarray, array)) and not hasattr(
        type(value), "to_numpy"
    ):
        return None
    for kind, (state_of, _) in CHANCE.items():
        if isinstance(value, kind):
            return state_of(value)
    if isinstance(value, set):
        return frozenset(value)
    if np.size(value) > MOST_NUMBERS:
        return None
    numbers = np.asarray(value)  # of pandas, too
    return numbers.tobytes() if numbers.dtype.kind in "fiubc" else None


def _put_back(value: Any, kept: Any) -> str:
    """Make a thing as it was; return what is said of a function that changed it."""
    for kind, (_, give) in CHANCE.items():
        if isinstance(value, kind):
            if value not in OF_ALL:  # from which other threads draw
                give(value, kept)
            return UNSEEDED
    if isinstance(value, set):
        value.clear()
        value.update(kept)
    else:
        numbers = np.asarray(value)
        before = np.frombuffer(kept, numbers.dtype).reshape(numbers.shape)
        if hasattr(type(value), "to_numpy"):
            value[:] = before
        else:
            np.copyto(numbers, before)
    return f"changes a {type(value).__name__} that its next call reads; make it a state"


class Names:
    """Some names of an object, a class or a module, used as a dict is."""

    def __init__(self, value: Any, names: Iterable[str]) -> None:
        self.value, self.names = value, names
        self.fixed = isinstance(value, type | ModuleType)  # keeps its names

    def __setitem__(self, name: str, value: Any) -> None:
        (setattr if self.fixed else object.__setattr__)(self.value, name, value)

    def copy(self) -> dict[str, Any]:
        """Return the attributes as they are now."""
        return {name: getattr(self.value, name) for name in self.names if hasattr(self.value, name)}

    def clear(self) -> None:
        """Delete the attributes."""
        for name in () if self.fixed else self.copy():
            object.__delattr__(self.value, name)

    def update(self, values: dict[str, Any]) -> None:
        """Set attributes."""
        for name, value in values.items():
            self[name] = value


def _container_of(value: Any) -> Any:
    """Return the container that holds what an object keeps, or None."""
    if isinstance(value, list | dict | deque):
        return value
    if isinstance(value, type | ModuleType | FunctionType):
        return _names_of(value)
    attributes = getattr(value, "__dict__", None)
    if type(attributes) is dict:
        return attributes
    slots = [vars(kind).get("__slots__", ()) for kind in type(value).__mro__]
    names = [name for one in slots for name in ([one] if isinstance(one, str) else one)]
    return Names(value, names) if names else None


@functools.lru_cache(maxsize=256)
def _is_library(root: str) -> bool:
    """Return whether a package is no user's: what its classes and modules keep are caches."""
    if root == "__main__":
        return False
    file = getattr(sys.modules.get(root), "__file__", None) or ""
    return root in (OWN, *sys.stdlib_module_names) or "-packages" in file


def _names_of(value: Any) -> Names | None:
    """Return names of a user's class or module, or of the module of a user's function."""
    name = value.__name__ if isinstance(value, ModuleType) else value.__module__
    if _is_library((name or "").partition(".")[0]):
        return None
    if isinstance(value, FunctionType):
        module = sys.modules.get(name)
        return Names(module, frozenset(names_in(value.__code__))) if module else None
    own = vars(value).items()
    return Names(value, [k for k, one in own if k[:2] != "__" and not hasattr(one, "__get__")])


@contextmanager
def borrowed(spaces: list[dict[str, Any]]) -> Iterator[None]:
    """Put stand-ins into modules for as long as a function is read."""
    if not spaces:
        yield
        return
    with _LOCK:
        undo: list[tuple[dict, str, Any]] = []
        try:
            for space in spaces:
                for name in {**SHADOWS, **space}:
                    value = space.get(name, _NONE)
                    new = SHADOWS[name] if value is _NONE else stand_in(value)
                    if new is not value and not name.startswith("__"):
                        undo.append((space, name, value))
                        space[name] = new
            yield
        finally:
            for space, name, value in reversed(undo):
                if value is _NONE:
                    del space[name]
                else:
                    space[name] = value
