"""Copies of functions, whose modules and built-in names are stand-ins.

A function runs as it is written; only what its names stand for is replaced, in a copy of it and
of the functions that it calls by name, and what the objects hold that it reaches (``self.table``):
for the length of a way through it, under a lock.  A helper that is reached through an object runs
with its own names, so for that time its module holds stand-ins too.
"""

import functools
from collections.abc import Iterator
from contextlib import contextmanager, nullcontext
from operator import is_
from types import CellType, FunctionType, MethodType
from typing import Any

import numpy as np

from .answers import LIBRARIES, joined
from .arrays import Tape, Unread
from .elementwise import boxed, constant
from .kept import GONE, LOCK, Snapshot, refuse_unwatched, same
from .lookup_tables import is_table
from .record import MOST_NUMBERS
from .stand_ins import BUILTINS, SHADOWS, stand_in
from .unchanged import is_plain, names_in, texts_in

# modules that read
READERS = tuple(f"{__package__}.{name}" for name in ("arrays", "elementwise", "record", "views"))
OF_WARNINGS = "__warningregistry__"  # which Python puts into the module that it warns of


class Copies:
    """The copies of one reading; `check` refuses a function that changed a name outside it."""

    def __init__(self, tape: Tape, snapshot: Snapshot) -> None:
        self.tape, self.snapshot = tape, snapshot
        self._known: dict[int, tuple[Any, Any]] = {}  # a value, alive, and what stands for it
        self._spaces: dict[int, dict[str, Any]] = {}  # the copied names of each module
        # of modules and objects
        self._changes: dict[tuple[int, int], list[tuple[dict, str, Any, Any]]] = {}
        # names of modules, containers and cells, copied: as they began, and in words
        self._copied: dict[int, tuple[Any, Any, str]] = {}
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
        if type(value) is np.ndarray and value.dtype in (float, int) and value.size:
            return self._numbers(value)
        if is_table(value):
            return stand_in(value)
        refuse_unwatched(value)
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
            raise Unread("calls np.vectorize; write a loop")
        kind = type(value)
        make = tuple if kind is tuple else getattr(kind, "_make", None)  # of a NamedTuple
        if (make or kind is list) and len(value) < 100:
            own_items = [self.of(one) for one in value]
            if all(map(is_, own_items, value)):
                return value
            return make(own_items) if make else self._watched(own_items)
        if type(value) is dict and len(value) < 100:
            self.texts.update(value)
            items = {key: self.of(one) for key, one in value.items()}
            return value if all(map(is_, items.values(), value.values())) else self._watched(items)
        return stand_in(value)

    def changes(
        self, space: dict[str, Any], names: set[str] | None
    ) -> list[tuple[dict, str, Any, Any]]:
        """Return what stands for these names of a module, or for tables that an object holds.

        Each with the names, its own, what has it, and what takes its place.
        """
        key = id(space), len(names or ())
        if key not in self._changes:
            if names is not None:
                found = {k: SHADOWS[k] for k in names & SHADOWS.keys()}
                found |= {k: stand_in(space[k]) for k in names & space.keys() if k[:2] != "__"}
            else:
                held = (np.ndarray, list, tuple, dict)
                found = {k: self.of(v) for k, v in space.items() if type(v) in held or is_table(v)}
            pairs = [(space, name, space.get(name, GONE), new) for name, new in found.items()]
            self._changes[key] = [one for one in pairs if one[2] is not one[3]]
        return self._changes[key]

    def _watched(self, container: Any) -> Any:
        """Return a list or dict that `check` compares with what it holds now."""
        return self._copy(container, "an item of a dict" if type(container) is dict else "a list")

    def _copy(self, copied: Any, words: str) -> Any:
        self._copied[id(copied)] = copied, copied.copy(), words
        return copied

    def _numbers(self, value: np.ndarray) -> Any:
        """Return numbers as an array of the record, which takes signals where NumPy's does not."""
        if value.size >= MOST_NUMBERS:
            return value
        numbers = constant(self.tape, value) if value.ndim else boxed(self.tape, float(value))
        numbers._fixed, numbers._whole = True, value.dtype == int
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
        self._copy(vars(copy), "an attribute")
        copy.__defaults__ = function.__defaults__ and tuple(map(self.of, function.__defaults__))
        if function.__kwdefaults__:
            copy.__kwdefaults__ = {k: self.of(v) for k, v in function.__kwdefaults__.items()}
        names = function.__code__.co_freevars
        for cell, old, name in zip(cells, function.__closure__ or (), names, strict=True):
            try:
                cell.cell_contents = self.of(old.cell_contents)
                words = f"{name!r} of the function around it"
                self._copied[id(cell)] = cell, [cell.cell_contents], words
            except ValueError:  # not bound yet
                continue
        for name in names_in(function.__code__):
            if name in function.__globals__ and first[name] is space[name]:
                space[name] = first[name] = self.of(function.__globals__[name])
        return joined(copy) if is_plain(function) else copy

    def _space(self, names: dict[str, Any]) -> tuple[dict, dict]:
        """Return the copied names of a module, and these as they began."""
        if id(names) not in self._spaces:
            own = {OF_WARNINGS: {}} | names | {"__builtins__": BUILTINS}
            self._spaces[id(names)] = self._copy(own, "the global")
        copied = self._spaces[id(names)]
        return copied, self._copied[id(copied)][1]

    def check(self, name: str) -> None:
        """Refuse a function that changed what it does not make: what it keeps is a state."""
        for thing, before, words in self._copied.values():
            now = [thing.cell_contents] if isinstance(thing, CellType) else thing
            if same(now, before):
                continue
            if isinstance(now, dict):
                names = [k for k, one in now.items() if one is not before.get(k, GONE)]
                words = f"{words} {[*names, 'that is gone'][0]!r}"
            raise Unread(f"{name} changes {words}; make it a state, or a parameter")


@contextmanager
def borrowed(copies: Copies) -> Iterator[None]:
    """Put stand-ins into modules and objects for as long as a function is read."""
    objects = [(one, None) for one in copies.snapshot.attributes.values()]
    borrowing = [*objects, *copies.snapshot.spaces.values()]
    changes = [one for of in borrowing for one in copies.changes(*of)]
    with LOCK if changes else nullcontext():
        try:
            for space, name, _, new in changes:
                space[name] = new
            yield
        finally:
            for space, name, value, new in changes:
                if space.get(name) is not new:  # the function changed it
                    continue
                if value is GONE:
                    del space[name]
                else:
                    space[name] = value
