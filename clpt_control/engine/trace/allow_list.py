"""Allow-list of tracing: values that no call changes, and functions that change and read nothing.

A traced function may call what is here.  Anything else of the standard library or of NumPy, SciPy
and matplotlib, such as ``open``, ``os.remove`` or ``np.save``, keeps a function from being traced.
"""

import datetime
import random
import re
import sys
from abc import ABC
from collections import Counter, OrderedDict, defaultdict
from decimal import Decimal
from enum import Enum
from fractions import Fraction
from functools import lru_cache
from types import (
    BuiltinFunctionType,
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

PACKAGE = __package__.partition(".")[0]
LIBRARIES = frozenset(("numpy", "scipy", "matplotlib", "pandas", "xarray", "sympy"))

IMMUTABLE = frozenset(
    (
        *(int, bool, str, bytes, complex, NoneType, EllipsisType, range, slice),
        type(NotImplemented),
        *(Fraction, Decimal, re.Pattern, np.dtype),
        *(
            datetime.date,
            datetime.datetime,
            datetime.timedelta,
            datetime.time,
            datetime.timezone,
        ),
    )
)


class _Named(NamedTuple):
    field: int


# of slots and of named tuples
FIELDS = (MemberDescriptorType, type(vars(_Named)["field"]))
PURE_OBJECTS = (np.r_, np.c_, np.s_, np.index_exp, np.mgrid, np.ogrid)
CHANCE = (np.random.Generator, np.random.RandomState, random.Random)
PLAIN_BASES = frozenset(  # whose objects keep nothing but items and attributes
    (
        *(object, tuple, list, dict, frozenset, ABC, Enum, SimpleNamespace, np.ndarray),
        *(OrderedDict, defaultdict, Counter, Generic, Protocol),
    )
)

CLOCK = "asks a clock; t is the run's time"
UNSEEDED = "draws by chance; draw before the run, or take it as an input"
OUTSIDE = (
    "which may change or read what is outside of the function; "
    "call it before or after the run"
)

PURE_MODULES = frozenset(
    (
        *(
            "math",
            "cmath",
            "operator",
            "_operator",
            "itertools",
            "functools",
            "_functools",
        ),
        *(
            "bisect",
            "_bisect",
            "heapq",
            "_heapq",
            "statistics",
            "_statistics",
            "fractions",
        ),
        *(
            "numbers",
            "copy",
            "collections",
            "_collections",
            "collections.abc",
            "dataclasses",
        ),
        *(
            "typing",
            "types",
            "enum",
            "abc",
            "_abc",
            "string",
            "re",
            "struct",
            "_struct",
        ),
        *("array", "datetime", "_datetime", "textwrap", "contextlib"),
    )
)
OF_PATHS = (
    "join",
    "basename",
    "dirname",
    "split",
    "splitext",
    "normpath",
    "commonprefix",
)
OF_LOGGING = (
    "debug",
    "info",
    "warning",
    "warn",
    "error",
    "critical",
    "exception",
    "log",
)
PURE_NAMES = frozenset(  # of other modules
    (
        *(
            "warnings.warn",
            "_warnings.warn",
            "_py_warnings.warn",
            "sys.exit",
            "decimal.Decimal",
        ),
        *("pathlib.PurePath", "pathlib.PurePosixPath", "pathlib.PureWindowsPath"),
        *(
            f"{path}.{name}"
            for path in ("posixpath", "ntpath", "genericpath")
            for name in OF_PATHS
        ),
        *(f"logging.{name}" for name in ("getLogger", "Logger", *OF_LOGGING)),
    )
)
# silent while a function is traced, as loggers are
STREAMS = ("sys.stdout", "sys.stderr")
PURE_SCIPY = tuple(
    f"scipy.{name}"
    for name in (
        *(
            "special",
            "interpolate",
            "linalg",
            "optimize",
            "integrate",
            "signal",
            "spatial",
        ),
        *("ndimage", "sparse", "fft", "constants", "_lib"),
    )
)
IMPURE_BUILTINS = frozenset(
    (
        *(
            "open",
            "input",
            "eval",
            "exec",
            "compile",
            "globals",
            "locals",
            "vars",
            "breakpoint",
        ),
        *("help", "__import__", "memoryview"),
    )
)
IMPURE_NUMPY = frozenset(
    (
        *(
            "load",
            "save",
            "savez",
            "savez_compressed",
            "savetxt",
            "loadtxt",
            "genfromtxt",
        ),
        *(
            "fromfile",
            "fromregex",
            "memmap",
            "open_memmap",
            "DataSource",
            "seterr",
            "seterrcall",
        ),
        *("setbufsize", "set_printoptions", "rand", "randn", "random", "seed", "test"),
        *("datetime64", "vectorize"),
    )
)
SEEDED = ("numpy.random.default_rng", "numpy.random._generator.default_rng")
CLOCKS = frozenset(("now", "utcnow", "today"))
CALLABLE = (
    *(BuiltinFunctionType, FunctionType, type, np.ufunc, type(np.sum)),
    *(
        MethodDescriptorType,
        WrapperDescriptorType,
        type(float.real),
        type(dict.fromkeys),
    ),
)


@lru_cache(maxsize=256)
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
    owner = None if isinstance(value, type) else getattr(value, "__objclass__", None)
    if isinstance(owner, type):  # of a method of a built-in type
        return module_of(owner)
    holder = getattr(value, "__self__", None)  # module or class of a built-in function
    if isinstance(holder, ModuleType | type):
        return module_of(holder)
    module = getattr(value, "__module__", None)
    return module if isinstance(module, str) else ""


def attributes_of(value: Any) -> dict[str, Any] | None:
    """Return an object's own attributes, and never what its class's `__getattr__` makes up."""
    try:
        return object.__getattribute__(value, "__dict__")
    except AttributeError:
        return None


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
    name = getattr(value, "__name__", "")
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
    name = getattr(value, "__name__", last)
    return f"calls {label if name == last else f'{label} ({name})'}, {OUTSIDE}"
