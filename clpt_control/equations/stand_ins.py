"""What stands for NumPy, `math` and built-in names while a function is read.

NumPy's own protocols reach arrays of the record wherever one is an argument.  They do not reach
``np.array([x[0], 1.0])``, ``np.zeros(2)`` that is filled afterwards, ``math.sin(x[0])``,
``float(x[0])`` and ``max(x[0], 0)``: these have stand-ins, which do what the real ones do where
nothing is read, or where no signal is among their arguments.
"""

import builtins
import math
from collections.abc import Callable
from types import ModuleType
from typing import Any

import numpy as np

from .arrays import Array, Tape, active, lifted, objects
from .numpy_functions import applied
from .opened import fresh, tape_of
from .python_functions import OF_MATH, READ, SHADOWS
from .reshaping import converted
from .standing import TYPES, StandIn
from .ufuncs import called


def of_numpy(real: Any) -> StandIn:
    """Return the stand-in of a function of NumPy, for lists that hold signals."""
    if real in MAKERS:
        return StandIn(real, MAKERS[real])
    if isinstance(real, np.ufunc):
        return StandIn(real, lambda tape, *a, **more: called(tape, real, "__call__", a, more))
    return StandIn(real, lambda tape, *a, **more: applied(tape, real, a, more))


def array(tape: Any, value: Any, dtype: Any = None, *, ndmin: int = 0, **more: Any) -> Any:
    """Return np.array of what holds signals."""
    made = lifted(tape, value)
    made = converted(made, dtype or float) if dtype is not None or more.get("copy", True) else made
    return made[(None,) * (ndmin - made.ndim)] if ndmin > made.ndim else made


def same_array(tape: Any, value: Any, dtype: Any = None, **more: Any) -> Any:
    """Return np.asarray of what holds signals."""
    if isinstance(value, Array) and (dtype is None or np.dtype(dtype).kind == "f"):
        return value
    return array(tape, value, dtype)


MAKERS: dict[Any, Callable] = {
    np.array: array,
    np.asarray: same_array,
    np.asanyarray: same_array,
    np.ascontiguousarray: same_array,
    np.full: lambda tape, *a, **more: lifted(tape, np.zeros(a[0])) + lifted(tape, a[1]),
    np.isscalar: lambda tape, a: isinstance(a, Array) and not a.shape,
}


def vectorized(real: np.vectorize) -> StandIn:
    """Return the stand-in of a function made by np.vectorize, which is run for each element."""

    def function(tape: Tape, *given: Any, **more: Any) -> Any:
        own = np.broadcast_arrays(*(objects(lifted(tape, one)) for one in given))
        found = np.empty(own[0].size, dtype=object)
        for k, values in enumerate(zip(*(one.ravel() for one in own), strict=True)):
            found[k] = real.pyfunc(*values, **more)
        return lifted(tape, found).reshape(own[0].shape)

    return StandIn(real, function)


class Joiner:
    """np.r_ and np.c_: what stands in brackets, one behind the other."""

    def __init__(self, real: Any, join: Callable):
        self.real, self.join = real, join

    def __getitem__(self, parts: Any) -> Any:
        given = parts if isinstance(parts, tuple) else (parts,)
        if tape_of(given) is None:
            tape, found = active(), self.real[parts]
            return found if tape is None else fresh(tape, found)
        return self.join(
            [np.atleast_1d(self.real[p] if isinstance(p, slice) else p) for p in given]
        )


# --- modules ------------------------------------------------------------------------------------


class Module(ModuleType):
    """What stands for a module: its names, of which some are stand-ins."""

    def __init__(self, real: ModuleType):
        super().__init__(real.__name__)
        self.__dict__["_stands_for"] = real

    def __getattr__(self, name: str) -> Any:
        found = stand_in(getattr(self._stands_for, name))
        self.__dict__[name] = found
        return found


_KNOWN: dict[int, Any] = {
    id(math): Module(math),
    id(np): Module(np),
    id(np.vectorize): lambda *given, **more: vectorized(np.vectorize(*given, **more)),
    id(np.r_): Joiner(np.r_, np.concatenate),
    id(np.c_): Joiner(np.c_, np.column_stack),
    **{id(real): made for real, made in TYPES.items()},
    **{id(made.real): made for made in OF_MATH},
    **{id(getattr(builtins, name)): made for name, made in SHADOWS.items()},
}


def stand_in(value: Any) -> Any:
    """Return what stands for a module, function or type; a value without one as it is."""
    found = _KNOWN.get(id(value))
    if found is not None:
        return found
    if isinstance(value, ModuleType):
        if value.__name__.partition(".")[0] == "numpy" and "random" not in value.__name__:
            return _KNOWN.setdefault(id(value), Module(value))
        return value
    name = getattr(value, "__name__", None)
    of_them = isinstance(name, str) and any(vars(m).get(name) is value for m in (np, np.linalg))
    if isinstance(value, np.ufunc) or (of_them and not isinstance(value, type)):
        return _KNOWN.setdefault(id(value), of_numpy(value))
    return value


def imported(name: str, *given: Any, **more: Any) -> Any:
    """Return a module that a function imports by itself, or what stands for it."""
    return stand_in(builtins.__import__(name, *given, **more))


BUILTINS: dict[str, Any] = {**vars(builtins), **SHADOWS, "__import__": imported, READ: True}
