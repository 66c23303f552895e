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
from types import CodeType, FunctionType, MethodType, ModuleType, NoneType
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
OF_TYPES = frozenset(("type", "__class__", "__new__", "super"))  # by which the class is reached
FIXED = {  # modules that nobody changes
    one.__name__: one for one in (math, cmath, copy, functools, itertools, operator, np, np.linalg)
}
TABLE = (  # what an interpolator is made of
    *("x", "y", "c", "t", "k", "points", "grid", "values", "method", "fill_value", "ext"),
    *("extrapolate", "bounds_error", "_eval_args", "coef", "domain", "window"),
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
        """Return the key of an object of a plain class: what it holds, and what its class does."""
        kind = type(value)
        plain = kind.__bases__ == (object,) and kind.__new__ is object.__new__
        if not plain or "__dict__" not in vars(kind):
            raise Unkeyed  # it may hold what no attribute shows
        of_class = []
        for name, own in vars(kind).items():
            if isinstance(own, FunctionType):
                if OF_TYPES.intersection(names_in(own.__code__)):
                    raise Unkeyed  # it may make another, by what is left out here
                of_class += [name] if name == "__init__" else [name, self.of(own)]
            elif isinstance(own, property):
                of_class += [name, *map(self.of, (own.fget, own.fset, own.fdel))]
            elif isinstance(own, staticmethod):
                of_class += [name, self.of(own.__func__)]
            elif not (name.startswith("__") and name.endswith("__")):
                of_class += [name, self.of(own)]
        return kind.__qualname__, *of_class, *self.named(vars(value))

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


def is_fixed(value: Any) -> bool:
    """Return whether a value is a module, function or type that nobody changes."""
    if isinstance(value, ModuleType):
        return any(value is one for one in FIXED.values())
    root = (getattr(value, "__module__", None) or "").partition(".")[0]
    return (
        type(value) in CALLED
        and root in ("builtins", "math", "cmath", "numpy", "_warnings")
        and isinstance(getattr(value, "__self__", None), ModuleType | NoneType)
        and value.__name__ not in SEES
    )


@functools.lru_cache(maxsize=1024)
def named(code: CodeType) -> tuple[str, ...] | None:
    """Return the names that code reads; None where it reaches more than it names."""
    names = names_in(code)
    fixed = all(all(_imports(one)) for one in _all_code(code))
    return names if fixed and not SEES.intersection(names) else None


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


def _imports(code: CodeType) -> Iterator[bool]:
    """Yield for each import whether it is of a module that nobody changes."""
    lines = list(dis.get_instructions(code))
    for k, line in enumerate(lines):
        if line.opname == "IMPORT_NAME":  # level and names are loaded before
            yield line.argval in FIXED and lines[k - 2].argval == 0
