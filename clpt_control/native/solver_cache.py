"""The solver as machine code, compiled once by Numba and kept in the user's cache.

Numba makes LLVM's text of `solver.py` itself; what it makes is kept as object code, named by a
hash of the text, the versions and the processor.  Where it is kept, Numba is not even imported.

A function is called as Numba lays down: where its result and an error go, then the numbers of its
arguments one by one; of an array these are two references that it does not own, count, size of
an item, address, shape and strides.
"""

import sys
from ctypes import CFUNCTYPE, byref, c_double, c_int32, c_int64, c_void_p
from functools import cache
from importlib import util
from importlib.metadata import version
from pathlib import Path
from types import FunctionType, ModuleType
from typing import Any

import numpy as np

from ..errors import Uncompiled
from ..files.user_cache import cache_folder
from ..progress import note
from . import solver
from .object_code import keep, kept, loaded, name_of, one_at_a_time, target_machine

OPTIONS: dict[str, Any] = {
    "nogil": True,
    "error_model": "numpy",
    "_nrt": False,
    "no_cpython_wrapper": True,  # Python calls the object code alone
    "no_cfunc_wrapper": True,
}
ENTRIES = ("advance", "advance_fixed", "signals_at")  # what is called from Python
USUAL = ("advance", "signals_at")  # what every run calls
# the rest is put in where it is called
APART = (*ENTRIES, "watch", "take", "sample", "leap", "keep")
ENTRY = "entry"  # the name of each in its own object code


class Entry:
    """A function of the solver as machine code, to be called with numbers and arrays."""

    def __init__(self, name: str):
        self.name = name
        self._engine: Any = None
        self._function: Any = None

    def __call__(self, *arguments: Any) -> int:
        """Call it; arrays are contiguous, of float64 or int64."""
        if self._function is None:
            self._load(arguments)
        result, error = c_int64(), c_void_p()
        status = self._function(byref(result), byref(error), *numbers(arguments))
        if status:
            raise RuntimeError(f"{self.name}: machine code ended with {status}")
        return result.value

    @property
    def ready(self) -> bool:
        """Whether it need not be compiled."""
        return self._function is not None or kept(_named(self.name)) is not None

    @one_at_a_time
    def _load(self, arguments: tuple) -> None:
        if self._function is not None:  # another thread may have been first
            return
        name = _named(self.name)
        code = kept(name)
        if code is None:
            _say()
            code = _compiled(self.name, arguments)
            keep(name, code)
        self._engine = loaded(code)
        types = [c_double if type(one) is float else c_int64 for one in numbers(arguments)]
        address = self._engine.get_function_address(ENTRY)
        self._function = CFUNCTYPE(c_int32, c_void_p, c_void_p, *types)(address)


def numbers(value: Any) -> list[Any]:
    """Return the numbers that stand for an argument, or for several."""
    found: list[Any] = []
    _put(value, found)
    return found


def _put(value: Any, found: list[Any]) -> None:
    if type(value) is tuple:
        for one in value:
            _put(one, found)
    elif type(value) is np.ndarray:
        if not value.flags.c_contiguous or value.dtype.char not in "dl":
            raise TypeError(f"the solver takes no array of {value.dtype}, {value.strides}")
        address = value.__array_interface__["data"][0]
        found += (0, 0, value.size, value.itemsize, address, *value.shape, *value.strides)
    else:
        found.append(value)


class CompiledSolver:
    """The functions of `solver` that are called from Python, as machine code."""

    def __init__(self) -> None:
        self.advance, self.advance_fixed, self.signals_at = map(Entry, ENTRIES)


@cache
def compiled_solver() -> CompiledSolver:
    """Return the solver as machine code, each function compiled or loaded when first called."""
    return CompiledSolver()


def ready() -> bool:
    """Whether the solver need not be compiled: it is in memory, or in the cache."""
    return all(getattr(compiled_solver(), name).ready for name in USUAL)


@cache
def _say() -> None:
    if cache_folder() is None:
        note("compiling, some ten seconds, each time: there is no folder to keep it in")
    else:
        note("compiling once for every kind of diagram, some ten seconds; later runs start at once")


def _named(name: str) -> str:
    """Return the name of a function's code in the cache."""
    made_of = (*_texts(), *map(version, ("numba", "numpy")), sys.version)
    return f"solver-{name_of(name, *made_of)}"


@cache
def _texts() -> list[str]:
    files = ("solver", "address_call", "solver_cache")
    return [Path(__file__).with_name(f"{name}.py").read_text("utf-8") for name in files]


def _compiled(name: str, arguments: tuple) -> bytes:
    """Return the object code of a function of the solver, as it is called with such arguments."""
    import llvmlite.binding as llvm
    from numba import typeof
    from numba.core.compiler_lock import global_compiler_lock

    with global_compiler_lock:
        function = getattr(_numba_solver(), name)
        types = tuple(map(typeof, arguments))
        function.compile(types)
        own = function.overloads[types].fndesc.mangled_name
        parsed = llvm.parse_assembly(function.inspect_llvm(types))
    for one in (*parsed.functions, *parsed.global_variables):
        if not one.is_declaration:
            one.linkage = "internal"
    entry = parsed.get_function(own)
    entry.linkage, entry.name = "external", ENTRY
    machine = target_machine()
    options = llvm.create_pipeline_tuning_options(speed_level=1)  # to drop what is not called
    passes = llvm.create_pass_builder(machine, options)
    passes.getModulePassManager().run(parsed, passes)
    asked = [one.name for one in parsed.functions if one.is_declaration]
    if unknown := [one for one in asked if not one.startswith(("llvm.", "mem"))]:
        raise Uncompiled(
            f"this version of Numba calls {unknown[0]} in the solver, and no other process could: "
            "install another one, or ask for engine = 'python'"
        )
    return bytes(machine.emit_object(parsed))


@cache
def _numba_solver() -> ModuleType:
    """Return the solver's module with its functions for Numba to compile."""
    from numba import njit

    from .address_call import call_address

    spec = util.spec_from_file_location("clpt_control_solver", solver.__file__)
    assert spec is not None
    assert spec.loader is not None
    module = util.module_from_spec(spec)
    sys.modules[spec.name] = module
    spec.loader.exec_module(module)

    module.call = call_address  # type: ignore[attr-defined]
    for name, function in list(vars(module).items()):
        if isinstance(function, FunctionType):
            compiled = njit(function, forceinline=name not in APART, **OPTIONS)
            setattr(module, name, compiled)
    return module
