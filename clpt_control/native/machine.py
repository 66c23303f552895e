"""Machine code: LLVM's text made for this processor, kept in the user's cache, and loaded.

A file is named by a hash of what it is made of, the versions and the processor, so what lies there
is never stale; it begins with the hash of what follows, so one cut short is made again.  LLVM is
asked by one thread at a time.

The solver's text, `solver.ll`, is that of `solver.py` as Numba reads it, for no processor in
particular (`tools/print_solver.py`).  Its functions are called as Numba lays down: where result and
error go, then the numbers of the arguments one by one; of an array these are two references that
it does not own, count, size of an item, address, shape and strides.
"""

import hashlib
import os
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager, suppress
from ctypes import CFUNCTYPE, addressof, byref, c_char, c_double, c_int32, c_int64, c_void_p
from functools import cache, lru_cache
from importlib.metadata import version
from pathlib import Path
from threading import RLock
from types import SimpleNamespace
from typing import Any

import llvmlite.binding as llvm
import numpy as np

from ..files import user_cache
from ..files.user_cache import cache_folder
from ..progress import note

VARIABLE = "CLPT_CONTROL_PROCESSOR"
LANES = 8  # runs side by side, or turns of a loop at once
KEPT = 4000  # files of a family, "solver-" or none, of some 6 kB; the least recently used go
HASH = hashlib.sha256().digest_size
LOCK = RLock()
HERE = Path(__file__).parent
TEXT = HERE / "solver.ll"


@contextmanager
def _alone() -> Iterator[None]:
    with LOCK:
        yield


one_at_a_time = _alone()  # as a decorator: one thread at a time may run it


def once(most: int | None = None) -> Callable:
    """Keep what a function returned; threads that ask at once are given the same."""
    kept = lru_cache(most)
    return lambda function: kept(one_at_a_time(kept(function)))


# --- the processor --------------------------------------------------------------------------


@cache
def _host() -> tuple[str, str]:
    return llvm.get_host_cpu_name(), llvm.get_host_cpu_features().flatten()


def processor() -> tuple[str, str]:
    """Return its name and features; CLPT_CONTROL_PROCESSOR names another, such as ``generic``."""
    name = os.environ.get(VARIABLE)
    return (name, "") if name else _host()


def fuses() -> bool:
    """Whether a product and a sum are one instruction."""
    return "+fma" in processor()[1] or "+neon" in processor()[1]


@cache
def _prepare() -> None:
    with suppress(RuntimeError):  # of new versions, which need it not
        llvm.initialize()
    llvm.initialize_native_target()
    llvm.initialize_native_asmprinter()


def target_machine() -> Any:
    """Return LLVM's description of the processor."""
    _prepare()
    name, features = processor()
    target = llvm.Target.from_default_triple()
    return target.create_target_machine(cpu=name, features=features, opt=3, jit=True)


# --- the cache ------------------------------------------------------------------------------


def name_of(*made_of: str) -> str:
    """Return the name of code that is made of these texts, here."""
    known = (*made_of, *processor(), llvm.get_default_triple(), version("llvmlite"))
    return hashlib.sha256("\n".join(known).encode()).hexdigest()[:32]


def kept(name: str) -> bytes | None:
    """Return code from the cache, if it is whole and nobody else could have put it there."""
    folder = cache_folder()
    if folder is None:
        return None
    path = folder / f"{name}.o"
    found = user_cache.kept(path)
    if found is None or found[:HASH] != hashlib.sha256(found[HASH:]).digest():
        return None
    with suppress(OSError):
        os.utime(path)
    return found[HASH:]


def keep(name: str, code: bytes) -> None:
    """Put code into the cache, where there is one; diagrams do not push out the solver."""
    folder = cache_folder()
    if folder is None:
        return
    user_cache.keep(folder / f"{name}.o", hashlib.sha256(code).digest() + code)
    with suppress(OSError):
        family = name.rpartition("-")[0]
        files = [one for one in folder.glob("*.o") if one.stem.rpartition("-")[0] == family]
        if len(files) > KEPT:
            files.sort(key=lambda one: one.stat().st_mtime, reverse=True)
        for one in files[KEPT:]:
            one.unlink(missing_ok=True)


# --- code -----------------------------------------------------------------------------------


def _loaded(name: str, text: Callable[[], str]) -> Any:
    """Return an engine that holds code, from the cache or made, and knows its addresses."""
    code = kept(name)
    if code is None:
        machine, parsed = target_machine(), llvm.parse_assembly(text())
        parsed.triple, parsed.data_layout = machine.triple, str(machine.target_data)
        options = llvm.create_pipeline_tuning_options(speed_level=3)
        # vectors are printed as such
        options.loop_vectorization = options.slp_vectorization = False
        options.loop_unrolling = options.loop_interleaving = False
        passes = llvm.create_pass_builder(machine, options)
        passes.getModulePassManager().run(parsed, passes)
        code = bytes(machine.emit_object(parsed))
        keep(name, code)
    engine = llvm.create_mcjit_compiler(llvm.parse_assembly(""), target_machine())
    engine.add_object_file(llvm.ObjectFileRef.from_data(code))
    engine.finalize_object()
    return engine


class Machine:
    """Functions of arrays as machine code.

    `addresses` says where the code of each lies, for as long as this object lives; `made_of` is
    all that the printed text depends on.
    """

    @one_at_a_time
    def __init__(self, names: Iterable[str], made_of: str, printed: Callable[[], Any]):
        self._engine = _loaded(name_of(made_of, _printed_by()), lambda: str(printed()))
        self.addresses = {name: self._engine.get_function_address(name) for name in names}


@cache
def _printed_by() -> str:
    """Return a hash of what LLVM's text of a program depends on beside the program."""
    files = [*sorted(HERE.glob("*.py")), HERE.parent / "equations" / "arrays.py"]
    texts = b"".join(one.read_bytes() for one in files)
    return hashlib.sha256(texts).hexdigest() + version("numpy")


# --- the solver -----------------------------------------------------------------------------


class Entry:
    """A function of the solver as machine code, to be called with whole numbers and arrays."""

    def __init__(self, engine: Any, name: str):
        self.name, self._engine = name, engine
        self._function: Any = None

    def __call__(self, *arguments: Any) -> int:
        """Call it; arrays are contiguous, of float64 or int64."""
        given = numbers(arguments)
        if self._function is None:
            made = CFUNCTYPE(c_int32, c_void_p, c_void_p, *[c_int64] * len(given))
            self._function = made(self._engine.get_function_address(self.name))
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
            flags, size, address = one.flags, one.size, 0
            if not flags.c_contiguous or one.dtype.char not in "dl":
                raise TypeError(f"the solver takes no array of {one.dtype}, {one.strides}")
            if size and flags.writeable:
                address = addressof(c_char.from_buffer(one.data))
            elif size:
                address = one.__array_interface__["data"][0]
            found += (0, 0, size, one.itemsize, address, *one.shape, *one.strides)
        else:
            found.append(one)
    return found


POINTERS = CFUNCTYPE(None, *[c_void_p] * 6)


def called(
    function: Callable, n: int, places: int, array: str, count: int, raised: list[BaseException]
) -> Any:
    """Return a function of time, n states and the beginning of P as the solver calls it.

    So many numbers are written, into D or W.  After what it raises nothing is asked any more.
    """

    def call(t: int, X: int, P: int, T: int, W: int, D: int) -> None:
        if raised:
            return
        try:
            found = function(float(_seen(t, 1)[0]), _seen(X, n), _seen(P, places))
            _seen(W if array == "W" else D, count)[:] = found
        except BaseException as error:  # machine code would drop it
            raised.append(error)

    return POINTERS(call)


def _seen(address: int, count: int) -> np.ndarray:
    """Return the numbers that lie there."""
    there: Any = (c_double * count).from_address(address or 0)
    return np.ndarray(count, buffer=there)


@once()
def compiled_solver() -> SimpleNamespace:
    """Return the functions of `solver` as machine code, found in the cache or made."""
    text = TEXT.read_text("utf-8")

    def told() -> str:
        once = "once" if cache_folder() else "each time: there is no folder to keep it in"
        note(f"making the solver's machine code for this processor, a few seconds, {once}")
        return text

    engine = _loaded(f"solver-{name_of(text)}", told)
    return SimpleNamespace(advance=Entry(engine, "advance"), ask=Entry(engine, "ask"))
