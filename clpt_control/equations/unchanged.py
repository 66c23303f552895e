"""Whether a function would be read as before: a key of all that it reaches.

    key = (code, defaults, closure, the globals that it names, and what these reach in turn)

Numbers, texts and arrays of numbers count as they are now, and so do objects of plain classes, by
what they hold and what their class does: a changed global has another key at once.  Whatever could
change unseen has no key: other objects, modules, what a function imports by itself, files.  Then it
is read anew.
"""

import cmath
import copy
import dis
import functools
import itertools
import math
import operator
from collections.abc import Iterator, Mapping
from types import CodeType, FunctionType, MethodType, ModuleType, NoneType, SimpleNamespace
from typing import Any

import control
import numpy as np

from .declaration import Parameters
from .lookup_tables import is_table
from .record import MOST_NUMBERS

MANY = 100  # things in a list
DIGITS = (int, bool, str, bytes, NoneType)
READ = ("open", "input", "load", "loadtxt", "genfromtxt", "fromfile", "memmap", "random")
OPENED = ("globals", "vars", "eval", "exec", "compile", "__import__", "__dict__", "__globals__")
SEES = frozenset((*READ, *OPENED))  # names by which a function reaches more than it names
UNUSED = ("__repr__", "__annotate__", "__annotate_func__")  # by what equations compute
FIXED = {  # modules that nobody changes
    one.__name__: one for one in (math, cmath, copy, functools, itertools, operator, np, np.linalg)
}
TABLE = (  # what an interpolator is made of
    *("x", "y", "c", "points", "grid", "values", "method", "fill_value"),
    *("extrapolate", "bounds_error"),
)
CALLED = (FunctionType, type(math.sin), type(np.sin), type(np.dot), type)


class Unkeyed(Exception):
    """The value could change unseen, so it has no key."""


class Keys:
    """Makes keys; a place in a key is that of an object in `held`, which must live as long.

    What is `alike` has one key; else what can change has the key of its place too, so that one
    stands for the other also after it has changed.
    """

    def __init__(self, alike: bool = False) -> None:
        self.alike = alike
        self.held: list[Any] = []
        self._seen: dict[int, int] = {}

    def of(self, value: Any) -> Any:
        """Return the key of a value; raise `Unkeyed` where it has none."""
        kind = type(value)
        if kind in DIGITS:
            return kind, value
        if kind in (float, np.float64):
            return kind, value.hex()  # 0.0 is not -0.0
        if kind is complex:
            return kind, value.real.hex(), value.imag.hex()
        if kind is tuple and len(value) < MANY:
            return kind, *map(self.of, value)
        if isinstance(value, Parameters) or is_fixed(value):
            return self.place(value)
        if id(value) in self._seen:  # one that holds itself, too
            return "seen", self._seen[id(value)]
        self._seen[id(value)] = len(self._seen)
        if kind is np.ndarray and value.dtype.kind in "fiubc" and value.size <= MOST_NUMBERS:
            key: Any = value.dtype, value.shape, value.tobytes()
        elif kind is list and len(value) < MANY:
            key = kind, *map(self.of, value)
        elif kind is dict and len(value) < MANY:
            key = kind, *self.named(value)
        elif kind is FunctionType:
            key = self._function(value)
        elif kind is functools.partial:
            key = self.of(value.func), self.of(value.args), *self.named(value.keywords)
        elif is_table(value):
            parts = (getattr(value, name, None) for name in TABLE)
            key = self.place(value), *map(self.of, parts)
        elif isinstance(value, control.InputOutputSystem):
            key = self._system(value)
        elif kind is MethodType:
            key = self.of(value.__func__), self.of(value.__self__)
        else:
            key = self._object(value)
        return key if self.alike else (self.place(value), key)

    def named(self, values: Mapping[Any, Any]) -> tuple[Any, ...]:
        """Return the keys of values by name."""
        return tuple([(self.of(name), self.of(value)) for name, value in values.items()])

    def place(self, value: Any) -> int:
        """Return where an object lies; it then lives as long as the keys."""
        self.held.append(value)
        return id(value)

    def _system(self, system: Any) -> Any:
        """Return the key of one of python-control's own systems, by its attributes."""
        if not (type(system).__module__ or "").startswith("control."):
            raise Unkeyed
        fields = {k: v for k, v in vars(system).items() if not k.endswith(("_labels", "_prefix"))}
        return self.place(system), *self.named(fields)

    def _object(self, value: Any) -> Any:
        """Return the key of an object by what it holds, and by what its class does."""
        kind = type(value)
        if kind is type:
            return self._class(value)
        if kind in (SimpleNamespace, ModuleType) and len(vars(value)) < MANY:
            held = {k: own for k, own in vars(value).items() if not _of_python(k, own)}
            return kind, *self.named(held)
        return self._class(kind), *self.named(vars(value))

    def _class(self, kind: type) -> Any:
        """Return the key of a plain class, written in Python."""
        own = vars(kind)
        rooted = "__weakref__" in own or not {*kind.__bases__} <= {object}
        plain = type(kind) is type and kind.__new__ is object.__new__ and rooted
        if not plain or "__slots__" in own:
            raise Unkeyed  # its objects may hold what no attribute shows
        does = {k: _functions(one) for k, one in own.items() if not _of_python(k, one)}
        bases = [self._class(one) for one in kind.__bases__ if one is not object]
        return kind.__qualname__, *bases, *self.named(does)

    def _function(self, function: FunctionType) -> Any:
        names = named(function.__code__)
        if names is None or function.__dict__:
            raise Unkeyed
        space = function.__globals__
        try:
            cells = [self.of(cell.cell_contents) for cell in function.__closure__ or ()]
        except ValueError:  # not bound yet
            raise Unkeyed from None
        return (
            self.place(function.__code__),
            self.of(function.__defaults__),
            self.of(function.__kwdefaults__),
            *cells,
            *[(name, self.of(space[name])) for name in names if name in space],
        )


class _Constants(Keys):
    """Makes keys of what nobody changes: numbers, texts, and functions of these alone."""

    def of(self, value: Any) -> Any:
        constant = type(value) in (*DIGITS, float, np.float64, tuple, FunctionType)
        if not constant and not is_fixed(value):
            raise Unkeyed
        return super().of(value)


def is_plain(function: FunctionType) -> bool:
    """Return whether a function cannot change, and reaches nothing that can."""
    try:
        return bool(_Constants().of(function))
    except Unkeyed:
        return False


def _of_python(name: str, own: Any) -> bool:
    """Return whether an attribute is what Python itself holds in a class or module."""
    special = name.startswith("__") and name.endswith("__")
    return name in UNUSED or (special and not isinstance(own, FunctionType))


def _functions(own: Any) -> tuple[Any, ...]:
    """Return the functions that an attribute of a class consists of, or what it is."""
    if isinstance(own, property):
        return own.fget, own.fset, own.fdel
    return (own.__func__ if isinstance(own, staticmethod | classmethod) else own,)


def is_fixed(value: Any) -> bool:
    """Return whether a value is a module, function or type that nobody changes."""
    if isinstance(value, ModuleType):
        return any(value is one for one in FIXED.values())
    root = (getattr(value, "__module__", None) or "").partition(".")[0]
    return (
        type(value) in CALLED
        and root in ("builtins", "math", "cmath", "numpy", "types", "dataclasses", "_warnings")
        and isinstance(getattr(value, "__self__", None), ModuleType | NoneType)
        and value.__name__ not in SEES
    )


@functools.lru_cache(maxsize=1024)
def named(code: CodeType) -> tuple[str, ...] | None:
    """Return the globals that code names; None where it reaches more than it names."""
    lines = [line for one in _all_code(code) for line in dis.get_instructions(one)]
    for k, line in enumerate(lines):  # of an import, level and names are loaded before
        if line.opname == "IMPORT_NAME" and (line.argval not in FIXED or lines[k - 2].argval != 0):
            return None
    found = {
        line.argval: None for line in lines if "_GLOBAL" in line.opname or "_NAME" in line.opname
    }
    return None if SEES.intersection(names_in(code)) else tuple(found)


@functools.lru_cache(maxsize=1024)
def names_in(code: CodeType) -> tuple[str, ...]:
    """Return the names that code reads, with those of the functions in it."""
    return tuple(dict.fromkeys(name for one in _all_code(code) for name in one.co_names))


def texts_in(code: CodeType) -> Iterator[Any]:
    """Yield the texts in code, and its other constants, with those of the functions in it."""
    for value in (value for one in _all_code(code) for value in one.co_consts):
        yield from value if isinstance(value, tuple | frozenset) else [value]


def _all_code(code: CodeType) -> Iterator[CodeType]:
    """Yield code, and that of the functions in it."""
    yield code
    for one in code.co_consts:
        if isinstance(one, CodeType):
            yield from _all_code(one)
