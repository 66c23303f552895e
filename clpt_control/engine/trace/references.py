"""References of a function: the allow-list of what it may call, and the names that its code loads.

A traced function may call what is on the list: values that no call changes, and functions that
change and read nothing.  Anything else of the standard library or of NumPy, SciPy and matplotlib,
such as ``open``, ``os.remove`` or ``np.save``, keeps a function from being traced.

    os.path.join(a, b)  ->  Reference("global", "os", ("path", "join"), line)
    import os           ->  Reference("import", "os", (), line)

The byte code is read for names alone; what a function computes is found by tracing it.
"""

import datetime
import dis
import functools
import random
import re
import sys
from abc import ABC
from collections import Counter, OrderedDict, defaultdict
from collections.abc import Iterator
from decimal import Decimal
from enum import Enum
from fractions import Fraction
from itertools import takewhile
from types import (
    BuiltinFunctionType,
    CodeType,
    EllipsisType,
    FunctionType,
    MemberDescriptorType,
    MethodDescriptorType,
    ModuleType,
    NoneType,
    SimpleNamespace,
    WrapperDescriptorType,
)
from typing import Any, Generic, NamedTuple, Protocol

import numpy as np

from ...base.arguments import attribute_of

PACKAGE = __package__.partition(".")[0]
LIBRARIES = frozenset(("numpy", "scipy", "matplotlib", "pandas", "xarray", "sympy"))

IMMUTABLE = frozenset(
    (
        int,
        bool,
        str,
        bytes,
        complex,
        NoneType,
        EllipsisType,
        range,
        slice,
        type(NotImplemented),
        Fraction,
        Decimal,
        re.Pattern,
        np.dtype,
        datetime.date,
        datetime.datetime,
        datetime.time,
        datetime.timedelta,
        datetime.timezone,
    )
)


PURE_OBJECTS = (np.r_, np.c_, np.s_, np.index_exp, np.mgrid, np.ogrid)
# methods of a class that is written in C
OF_C = (WrapperDescriptorType, MethodDescriptorType)
CHANCE = (np.random.Generator, np.random.RandomState, random.Random)
PLAIN_BASES = frozenset(  # whose objects keep nothing but items and attributes
    (
        object,
        tuple,
        list,
        dict,
        frozenset,
        ABC,
        Enum,
        SimpleNamespace,
        np.ndarray,
        OrderedDict,
        defaultdict,
        Counter,
        Generic,
        Protocol,
    )
)

CLOCK = "asks a clock; t is the run's time"
UNSEEDED = "draws random numbers. Draw them before the run, or make them an input"
OUTSIDE = (
    "which may change or read what is outside of the function. "
    "Call it before or after the run"
)


def words(text: str) -> frozenset[str]:
    """Return the words of a text."""
    return frozenset(text.split())


PURE_MODULES = words(
    """
    math cmath operator _operator itertools functools _functools bisect _bisect heapq
    _heapq statistics _statistics fractions numbers copy collections _collections
    collections.abc dataclasses typing types enum abc _abc string re struct _struct
    array datetime _datetime textwrap contextlib
    """
)
OF_PATHS = words("join basename dirname split splitext normpath commonprefix")
OF_LOGGING = words("debug info warning warn error critical exception log")
PURE_NAMES = words(  # of other modules
    """
    warnings.warn _warnings.warn _py_warnings.warn sys.exit decimal.Decimal logging.getLogger
    logging.Logger pathlib.PurePath pathlib.PurePosixPath pathlib.PureWindowsPath
    """
)
PURE_NAMES |= {f"logging.{name}" for name in OF_LOGGING}
for path in ("posixpath", "ntpath", "genericpath"):
    PURE_NAMES |= {f"{path}.{name}" for name in OF_PATHS}
# silent while a function is traced, as loggers are
STREAMS = ("sys.stdout", "sys.stderr")
PURE_SCIPY = (
    "scipy.special",
    "scipy.interpolate",
    "scipy.linalg",
    "scipy.optimize",
    "scipy.integrate",
    "scipy.signal",
    "scipy.spatial",
    "scipy.ndimage",
    "scipy.sparse",
    "scipy.fft",
    "scipy.constants",
    "scipy._lib",
)
IMPURE_BUILTINS = words(
    """
    open input eval exec compile globals locals vars breakpoint help __import__
    memoryview
    """
)
IMPURE_NUMPY = words(
    """
    load save savez savez_compressed savetxt loadtxt genfromtxt fromfile fromregex
    memmap open_memmap DataSource seterr seterrcall setbufsize set_printoptions rand
    randn random seed test datetime64 vectorize
    """
)
SEEDED = ("numpy.random.default_rng", "numpy.random._generator.default_rng")
CLOCKS = frozenset(("now", "utcnow", "today"))
CALLABLE = (
    BuiltinFunctionType,
    FunctionType,
    type,
    np.ufunc,
    type(np.sum),
    MethodDescriptorType,
    WrapperDescriptorType,
    type(float.real),
    type(dict.fromkeys),
)


@functools.lru_cache(maxsize=256)
def is_library(root: str) -> bool:
    """Return whether a package is of Python or a known library, whose functions are not traced."""
    return root in LIBRARIES or (root in sys.stdlib_module_names and root != "__main__")


def root_of(value: Any) -> str:
    """Return the first name of the module that defines a value."""
    return module_of(value).partition(".")[0]


def module_of(value: Any) -> str:
    """Return the module that defines a function or class, or the name of a module."""
    if isinstance(value, ModuleType):
        return value.__name__
    if isinstance(value, FunctionType):
        # by its names, since anybody may set __module__
        name = value.__globals__.get("__name__", "")
        is_current = (
            getattr(sys.modules.get(name), "__dict__", None) is value.__globals__
        )
        return name if is_current else ""
    owner = None if isinstance(value, type) else attribute_of(value, "__objclass__")
    if isinstance(owner, type):  # of a method of a built-in type
        return module_of(owner)
    holder = attribute_of(value, "__self__")  # module or class of a built-in function
    if isinstance(holder, ModuleType | type):
        return module_of(holder)
    module = attribute_of(value, "__module__")
    return module if isinstance(module, str) else ""


def attributes_of(value: Any) -> dict[str, Any] | None:
    """Return an object's own attributes, and never what its class's `__getattr__` makes up."""
    try:
        return object.__getattribute__(value, "__dict__")
    except AttributeError:
        return None


@functools.lru_cache(maxsize=256)
def is_plain(kind: type) -> bool:
    """Return whether the state of an object is in attributes, items or slots that Python has."""
    classes = [base for base in kind.__mro__ if base not in PLAIN_BASES]
    methods = (
        method
        for base in classes
        for method in vars(base).values()
        if isinstance(method, OF_C)
    )
    library = any(is_library(root_of(base)) for base in classes)
    return not library and not any(method.__objclass__ in classes for method in methods)


def is_pure(value: Any) -> bool:
    """Return whether a function, type or object neither keeps nor changes anything when called."""
    if not isinstance(value, CALLABLE):
        is_listed = any(value is listed for listed in PURE_OBJECTS)
        return (
            is_listed
            or isinstance(value, FIELDS)
            or type(value).__module__ == "dataclasses"
        )
    module = module_of(value)
    name = attribute_of(value, "__name__", "")
    root = module.partition(".")[0]
    if module == "datetime" and name in CLOCKS:
        return False
    if root == PACKAGE:
        return isinstance(value, type)
    if root == "builtins":
        return name not in IMPURE_BUILTINS
    if root == "numpy":
        drawn = (
            module.startswith("numpy.random") and f"numpy.random.{name}" not in SEEDED
        )
        return name not in IMPURE_NUMPY and not drawn
    if root == "scipy" or isinstance(value, np.ufunc):
        return isinstance(value, np.ufunc) or module.startswith(PURE_SCIPY)
    return module in PURE_MODULES or f"{module}.{name}" in PURE_NAMES


def reason(label: str, value: Any) -> str:
    """Return why code that references a function or type is not traced."""
    module = module_of(value)
    last = label.rpartition(".")[2]
    if module == "time" or last in CLOCKS:
        return CLOCK
    if module == "random" or module.startswith("numpy.random"):
        return UNSEEDED
    name = attribute_of(value, "__name__", last)
    return f"calls {label if name == last else f'{label} ({name})'}, {OUTSIDE}"


# --- names in the code of a function ------------------------------------------------------------

LOADS = {
    **dict.fromkeys(("LOAD_GLOBAL", "LOAD_NAME"), "global"),
    **dict.fromkeys(
        ("LOAD_DEREF", "LOAD_CLASSDEREF", "LOAD_FROM_DICT_OR_DEREF"), "cell"
    ),
    "LOAD_FROM_DICT_OR_GLOBALS": "global",
}
ATTRIBUTES = ("LOAD_ATTR", "LOAD_METHOD", "STORE_ATTR", "DELETE_ATTR")


class Reference(NamedTuple):
    """A name that code loads, with the attributes that the code loads of its value at once."""

    space: str  # "global", "cell", or "import" of a module by the function itself
    name: str
    attributes: tuple[str, ...]
    line: int


# of slots and of named tuples
FIELDS = (MemberDescriptorType, type(vars(Reference)["name"]))


@functools.lru_cache(maxsize=1024)
def references(code: CodeType) -> tuple[Reference, ...]:
    """Return what code references, with the functions in it; each once."""
    by_name: dict[tuple, Reference] = {}
    for inner in all_code(code):
        for reference in _references_of(inner):
            if reference.space != "cell" or reference.name in code.co_freevars:
                by_name.setdefault(reference[:3], reference)
    return tuple(by_name.values())


def _references_of(code: CodeType) -> Iterator[Reference]:
    lines = list(dis.get_instructions(code))
    for k, line in enumerate(lines):
        number = (line.positions and line.positions.lineno) or 0
        if line.opname == "IMPORT_NAME":
            yield Reference(
                "import", "." * lines[k - 2].argval + line.argval, (), number
            )
        elif line.opname in LOADS:
            following = takewhile(
                lambda instruction: instruction.opname in ATTRIBUTES, lines[k + 1 :]
            )
            attributes = tuple(instruction.argval for instruction in following)
            yield Reference(LOADS[line.opname], line.argval, attributes, number)


@functools.lru_cache(maxsize=1024)
def code_names(code: CodeType) -> tuple[str, ...]:
    """Return the names that code loads, with those of the functions in it."""
    return tuple(
        dict.fromkeys(name for inner in all_code(code) for name in inner.co_names)
    )


@functools.lru_cache(maxsize=1024)
def code_texts(code: CodeType) -> frozenset[str]:
    """Return the texts among the constants of code, with those of the functions in it."""
    constants = [value for item in all_code(code) for value in item.co_consts]
    items = [
        item
        for value in constants
        for item in (value if type(value) is tuple else [value])
    ]
    return frozenset(item for item in items if isinstance(item, str))


def all_code(code: CodeType) -> Iterator[CodeType]:
    """Yield code, and that of the functions in it."""
    yield code
    for constant in code.co_consts:
        if isinstance(constant, CodeType):
            yield from all_code(constant)
