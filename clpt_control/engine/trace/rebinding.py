"""Rebinding: while a function is traced, names stand for tracer functions and arrays.

Functions are copied, each with the names of its module and its closure.  In objects, lists, dicts
and classes, which cannot be copied, tracer values take the place of the real ones for the length of
one execution path, under a lock.  After each path everything is put back, and a path that changed
anything outside of the function is refused: the function has hidden state.
"""

import threading
from collections.abc import Iterator
from contextlib import contextmanager
from functools import cached_property
from operator import is_, is_not
from types import CellType, FunctionType, MethodType, ModuleType
from typing import Any

import numpy as np

from ..record.graph import MOST_NUMBERS
from ..record.unread import Unread
from .arrays import LASTING, REMEMBERS
from .contents import ARRAY, HOLDERS, Content, Mutable, restore
from .elementwise import boxed, constant
from .execution_paths import merge_calls
from .fingerprint import Fingerprint
from .references import LIBRARIES, code_names, code_texts, is_library, root_of
from .rewriting import NAMES, rewritten
from .tracer_modules import BUILTINS, TracerModule, real_type, tracer_value, type_of

LOCK = threading.RLock()  # while tracer values are in objects and classes
ENGINE = __package__.rpartition(".")[0]
TRACER_MODULES = tuple(
    f"{ENGINE}.{name}"
    for name in ("trace.arrays", "trace.elementwise", "record.graph", "trace.views")
)
# which Python puts into the module that it warns of
OF_WARNINGS = "__warningregistry__"


class Rebinding:
    """The tracer values of one tracing."""

    def __init__(self, tape: Any, reached: Fingerprint, trusted: bool):
        self.tape = tape
        self.reached = reached
        self.trusted = trusted  # of this package: not rewritten
        self.texts: set[str] = set()  # in the functions, which may be names of params
        self._known: dict[
            int, tuple[Any, Any]
        ] = {}  # a value, kept alive, and its tracer value
        self._unmerged: dict[
            int, FunctionType
        ] = {}  # copies, by those that merge their paths
        self._spaces: dict[int, Mutable] = {}  # copied names of each module
        self._copies: list[Mutable] = []

    def of(self, value):
        """Return the tracer value of a value: a copy of a function, a tracer array, or itself."""
        if isinstance(value, int | float | str):
            return value
        if id(value) not in self._known:
            self._known[id(value)] = value, value  # of a value that holds itself
            self._known[id(value)] = value, self._tracer_value(value)
        return self._known[id(value)][1]

    def _tracer_value(self, value):
        if isinstance(value, FunctionType):
            single = root_of(value) == "functools" and hasattr(value, "registry")
            return self._dispatching(value) if single else self._function(value)
        if type(value) is np.ndarray and value.dtype in (float, int) and value.size:
            return self._numbers(value)
        if holder := HOLDERS.get(type(value)):
            assert holder.make is not None
            return holder.make(*map(self._item, holder.read(value).items))
        if root_of(type(value)) == "numba":
            return self.of(value.py_func)
        if isinstance(value, tuple):
            items = [self.of(item) for item in value]
            if all(map(is_, items, value)):
                return value
            return getattr(type(value), "_make", tuple)(items)
        if isinstance(value, ModuleType) and not is_library(root_of(value)):
            return TracerModule(value, self.of)
        return tracer_value(value)

    def _item(self, value):
        """Return the tracer value of what a function or its holder has, a dict as a copy."""
        if type(value) is dict:
            return {name: self.of(item) for name, item in value.items()}
        return self.of(value)

    def _dispatching(self, value: Any) -> Any:
        """Return the tracer function of a `functools.singledispatch`."""
        copies = {function: self.of(function) for function in value.registry.values()}

        def dispatching(*arguments, **options):
            kind = real_type(type_of(arguments[0]))
            return copies[value.dispatch(kind)](*arguments, **options)

        return dispatching

    def _numbers(self, value: np.ndarray) -> Any:
        """Return numbers as a tracer array, which takes signals where NumPy's does not."""
        if value.size >= MOST_NUMBERS:
            return value
        numbers = (
            constant(self.tape, value) if value.ndim else boxed(self.tape, float(value))
        )
        numbers._fixed = LASTING
        numbers._whole = value.dtype == int
        return numbers

    def root(self, function):
        """Return the tracer function of the function to trace, whose own paths are not merged."""
        if isinstance(function, MethodType):
            return MethodType(self.root(function.__func__), self.of(function.__self__))
        copy = self.of(function)
        return self._unmerged.get(id(copy), copy)

    # --- copies -----------------------------------------------------------------------------

    def _function(self, function: FunctionType) -> Any:
        """Return a copy of a function, whose names are tracer values."""
        if function.__module__ in TRACER_MODULES:
            return function
        if root_of(function) in LIBRARIES:
            return tracer_value(function)
        code = function.__code__ if self.trusted else rewritten(function.__code__)
        self.texts.update(code_texts(code))
        cells = tuple(CellType() for _ in function.__closure__ or ())
        space = self._space(function.__globals__)
        copy = FunctionType(code, space.value, function.__name__, None, cells or None)
        copy.__module__ = function.__module__
        copy.__qualname__ = function.__qualname__
        result = merge_calls(copy) if self.tape.merging else copy
        self._unmerged[id(result)] = copy
        self._known[id(function)] = function, result
        vars(result).update(self._item(vars(function)))
        copy.__defaults__ = self.of(function.__defaults__)
        copy.__kwdefaults__ = self._item(function.__kwdefaults__)
        for cell, old, name in zip(
            cells, function.__closure__ or (), code.co_freevars, strict=True
        ):
            if old != CellType():  # else it is not bound yet
                cell.cell_contents = self.of(old.cell_contents)
                self._copies.append(
                    Mutable(cell, f"{name!r} of the function around it")
                )
        self._copies.append(Mutable(vars(result), f"{function.__name__}"))
        for name in code_names(code):
            if name in function.__globals__:
                space.value[name] = self.of(function.__globals__[name])
        space.before = space.kind.read(space.value)
        return result

    def _space(self, names: dict[str, Any]) -> Mutable:
        """Return the copied names of a module."""
        if id(names) not in self._spaces:
            builtins = BUILTINS | {"__import__": self._imported}
            copied = {OF_WARNINGS: {}} | names | NAMES | {"__builtins__": builtins}
            self._spaces[id(names)] = Mutable(copied, "the globals")
            self._copies.append(self._spaces[id(names)])
        return self._spaces[id(names)]

    def _imported(self, *arguments, **options):
        """Return the tracer value of a module that a function imports by itself."""
        return self.of(__import__(*arguments, **options))

    # --- in place ---------------------------------------------------------------------------

    @cached_property
    def _contents(self) -> list[tuple[Mutable, Content]]:
        """The content of every mutable value with tracer values in it."""
        return [(mutable, self._content(mutable)) for mutable in self.reached.mutables]

    def _content(self, mutable: Mutable) -> Content:
        before = mutable.before
        if mutable.kind is ARRAY:
            return before
        items = [
            self.of(item) if mutable.names is None or key in mutable.names else item
            for key, item in zip(before.keys, before.items, strict=True)
        ]
        return before._replace(items=items)

    @contextmanager
    def installed(self, name: str) -> Iterator[None]:
        """Have tracer values in place for one execution path; refuse a path that changes any."""
        contents = self._contents
        lasting = [*self._copies, *self.reached.mutables]
        self.tape.persistent |= {id(mutable.value) for mutable in lasting}

        def check() -> None:
            copies = [(mutable, mutable.before) for mutable in self._copies]
            for mutable, content in (*copies, *contents):
                if words := mutable.changed(content):
                    raise Unread(f"{name} {REMEMBERS.format(words)}")

        self.tape.check = check
        with LOCK:
            try:
                for mutable, content in contents:
                    if any(map(is_not, content.items, mutable.before.items)):
                        mutable.put(content)
                yield
                check()
            finally:
                restore([*self._copies, *self.reached.mutables])
