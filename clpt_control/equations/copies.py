"""Copies of functions, whose modules and built-in names are stand-ins.

A function runs as it is written; only what its names stand for is replaced, in a copy of it and
of the functions that it calls by name.  A helper that is reached through an object runs with its
own names; where it asks for the number of a signal, `Borrowed` puts stand-ins into its module for
the length of a reading, under a lock, and then puts the module's own names back.

Objects and containers that a function reaches could keep something from one call to the next
(`Snapshot`): a reading leaves them as they were.  What the first reading changed is unknown to the
second (a leaf of its own): a record that depends on it is no function of time, states and inputs.
"""

import functools
import threading
from collections import deque
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from operator import is_
from types import BuiltinFunctionType, CellType, FunctionType, MethodType, ModuleType
from typing import Any

import numpy as np

from .arrays import Array, Tape, Unread
from .lookup_tables import is_table
from .stand_ins import BUILTINS, SHADOWS, stand_in, vectorized
from .unchanged import names_in, texts_in
from .views import fresh

LIBRARIES = ("numpy", "scipy", "matplotlib")  # run as they are
READERS = tuple(f"{__package__}.{name}" for name in ("arrays", "record", "views"))  # that read
_LOCK = threading.RLock()
_NONE = object()
OF_WARNINGS = "__warningregistry__"  # which Python puts into the module that it warns of
DEEP = 3  # objects within objects
MOST = 200  # objects that are remembered
PLAIN = (int, float, str, bytes, tuple, type, ModuleType, FunctionType, MethodType)


class Copies:
    """The copies of one reading; `check` refuses a function that changed a name outside it."""

    def __init__(self, tape: Tape) -> None:
        self.tape, self.snapshot = tape, Snapshot()
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
        array = fresh(self.tape, value)
        if isinstance(array, Array):
            array._fixed = True
        return array

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
        self._changed: dict[tuple[int, Any], Any] = {}  # by object and key: what holds it

    def add(self, value: Any, deep: int = DEEP) -> None:
        """Remember an object, and those within it."""
        if value is None or isinstance(value, (*PLAIN, BuiltinFunctionType, np.ndarray)):
            return
        if id(value) in self._objects or len(self._objects) >= MOST:
            return
        inside = _container_of(value)
        if inside is None:
            return
        before = inside.copy()
        self._objects[id(value)] = value, inside, before
        if deep:
            for one in list(before.values() if isinstance(before, dict) else before)[:MOST]:
                self.add(one, deep - 1)

    def hide(self, leaf: Any) -> None:
        """Put unknown numbers in the places that changed; what was appended stays."""
        for k, ((_, key), inside) in enumerate(self._changed.items()):
            if not isinstance(inside, list | deque) or key < len(inside):
                inside[key] = leaf(k)

    def restore(self) -> None:
        """Make all as it was; note what had changed."""
        for place, (_, inside, before) in self._objects.items():
            now, first = _entries(inside.copy()), _entries(before)
            changed = [k for k, one in now.items() if one is not first.get(k, _NONE)]
            if changed or len(now) != len(first) or isinstance(inside, set):
                self._changed.update({(place, key): inside for key in changed})
                inside.clear()
                fill = inside.extend if isinstance(inside, list | deque) else inside.update
                fill(before)


class Slots:
    """What an object keeps in `__slots__`, used as a dict is."""

    def __init__(self, value: Any, names: Sequence[str]) -> None:
        self.value, self.names = value, names

    def __setitem__(self, name: str, value: Any) -> None:
        object.__setattr__(self.value, name, value)

    def copy(self) -> dict[str, Any]:
        """Return the attributes as they are now."""
        return {name: getattr(self.value, name) for name in self.names if hasattr(self.value, name)}

    def clear(self) -> None:
        """Delete the attributes."""
        for name in self.copy():
            object.__delattr__(self.value, name)

    def update(self, values: dict[str, Any]) -> None:
        """Set attributes."""
        for name, value in values.items():
            self[name] = value


def _container_of(value: Any) -> Any:
    """Return the container that holds what an object keeps, or None."""
    if isinstance(value, list | dict | set | deque):
        return value
    attributes = getattr(value, "__dict__", None)
    if type(attributes) is dict:
        return attributes
    slots = [vars(kind).get("__slots__", ()) for kind in type(value).__mro__]
    names = [name for one in slots for name in ([one] if isinstance(one, str) else one)]
    return Slots(value, names) if names else None


def _entries(inside: Any) -> dict:
    """Return what a container holds in places that have keys; a set has none."""
    if isinstance(inside, dict):
        return inside
    return {} if isinstance(inside, set) else dict(enumerate(inside))


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
