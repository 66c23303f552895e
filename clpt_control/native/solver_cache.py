"""The solver as machine code, made once for this machine and kept in the user's cache.

`solver.ll` is LLVM's text of `solver.py`, as Numba reads it, for no processor in particular
(`tools/print_solver.py`); LLVM makes this processor's code of it.

A function is called as Numba lays down: where its result and an error go, then the numbers of its
arguments one by one; of an array these are two references that it does not own, count, size of
an item, address, shape and strides.
"""

from ctypes import CFUNCTYPE, addressof, byref, c_char, c_double, c_int32, c_int64, c_void_p
from functools import cache
from pathlib import Path
from typing import Any

import llvmlite.binding as llvm
import numpy as np

from ..files.user_cache import cache_folder
from ..progress import note
from .object_code import keep, kept, loaded, name_of, one_at_a_time, target_machine

TEXT = Path(__file__).with_name("solver.ll")


class Entry:
    """A function of the solver as machine code, to be called with numbers and arrays."""

    def __init__(self, engine: Any, name: str):
        self.name = name
        self._address = engine.get_function_address(name)
        self._function: Any = None

    def __call__(self, *arguments: Any) -> int:
        """Call it; arrays are contiguous, of float64 or int64."""
        given = numbers(arguments)
        if self._function is None:
            types = [c_double if type(one) is float else c_int64 for one in given]
            made = CFUNCTYPE(c_int32, c_void_p, c_void_p, *types)
            self._function = made(self._address)
        result, error = c_int64(), c_void_p()
        status = self._function(byref(result), byref(error), *given)
        if status:
            raise RuntimeError(f"{self.name}: machine code ended with {status}")
        return result.value


def numbers(arguments: tuple) -> list[Any]:
    """Return the numbers that stand for arguments, one after the other."""
    found: list[Any] = []
    for one in arguments:
        if type(one) is tuple:
            found += numbers(one)
        elif type(one) is np.ndarray:
            if not one.flags.c_contiguous or one.dtype.char not in "dl":
                raise TypeError(f"the solver takes no array of {one.dtype}, {one.strides}")
            if one.flags.writeable and one.size:
                address = addressof(c_char.from_buffer(one.data))
            else:
                address = one.__array_interface__["data"][0]
            found += (0, 0, one.size, one.itemsize, address, *one.shape, *one.strides)
        else:
            found.append(one)
    return found


class CompiledSolver:
    """The functions of `solver` that are called from Python, as machine code."""

    def __init__(self, code: bytes) -> None:
        self._engine = engine = loaded(code)
        self.advance = Entry(engine, "advance")
        self.advance_fixed = Entry(engine, "advance_fixed")
        self.signals_at = Entry(engine, "signals_at")


@cache
@one_at_a_time
@cache
def compiled_solver() -> CompiledSolver:
    """Return the solver as machine code, found in the cache or made."""
    text = TEXT.read_text("utf-8")
    name = f"solver-{name_of(text)}"
    code = kept(name)
    if code is None:
        once = "each time: there is no folder to keep it in" if cache_folder() is None else "once"
        note(f"making the solver's machine code for this processor, a few seconds, {once}")
        code = _optimised(text)
        keep(name, code)
    return CompiledSolver(code)


def _optimised(text: str) -> bytes:
    """Return the object code of the solver's text."""
    machine = target_machine()
    parsed = llvm.parse_assembly(text)
    parsed.triple, parsed.data_layout = machine.triple, str(machine.target_data)
    options = llvm.create_pipeline_tuning_options(speed_level=3)
    passes = llvm.create_pass_builder(machine, options)
    passes.getModulePassManager().run(parsed, passes)
    return bytes(machine.emit_object(parsed))
