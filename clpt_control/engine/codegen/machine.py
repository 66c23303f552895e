"""Machine code: LLVM's text compiled for this processor, cached in the user's folder, and loaded.

The name of a file is a hash of its sources, the versions and the processor, so no file is ever
stale.  A file begins with the hash of its content, so one that was cut short is made again.  One
thread at a time uses LLVM.

The solver's text, `solver.ll`, is `solver.py` and its pages as Numba compiles them for no processor
in particular (`tools/print_solver.py`); so is that of `enclosure.ball_series`.  Functions take one
array: the numbers of their arguments, as Numba has them.  Those of an array are two references that
it does not own, count, size of an item, address, shape and strides.
"""

import hashlib
import os
import re
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager, suppress
from ctypes import CFUNCTYPE, addressof, c_char, c_int64, c_void_p
from functools import cache, lru_cache
from pathlib import Path
from threading import RLock
from types import SimpleNamespace
from typing import Any

import llvmlite.binding as llvm
import numpy as np
from llvmlite import __version__ as llvm_version

from ...base.files import cache_folder, read_cached, write_cached
from ...base.progress import note

VARIABLE = "CLPT_CONTROL_PROCESSOR"
ENGINE = "CLPT_CONTROL_ENGINE"  # environment variable that names another default
LANES = 8  # runs side by side, or iterations of a loop at once
# of a family, "solver-" or none, some 6 kB each; the least recently used go.  All tests of a state
# of the engine make up to 3,500
MOST_FILES = 8000
HASH = hashlib.sha256().digest_size
LOCK = RLock()
HERE = Path(__file__).parent
TEXT = HERE.parent / "solver" / "solver.ll"
ROWS = HERE / "rows.ll"  # functions of rows of numbers
# of the engine: files that print a program, given its components, or say how it is compiled
PRINTERS = (
    "codegen/*.[lp]*",
    "methods/*.py",
    "record/*.py",
    "trace/*.py",
    "solver/diagram_code.py",
    "solver/solver_layout.py",
)
BALLS = HERE.parent / "enclosure" / "ball_series.ll"
# or calls of its own functions
BRANCHES = re.compile(r'\n\s+br |call [^\n@]*@"?(?!"?llvm\.)')


@contextmanager
def _alone() -> Iterator[None]:
    with LOCK:
        yield


one_at_a_time = _alone()  # as a decorator: one thread at a time may run it


def once(most: int | None = None) -> Callable:
    """Cache what a function returns; threads that call it at the same time get the same."""
    cached = lru_cache(most)
    return lambda function: cached(one_at_a_time(cached(function)))


# --- the processor --------------------------------------------------------------------------


@cache
def _host() -> tuple[str, str]:
    return llvm.get_host_cpu_name(), llvm.get_host_cpu_features().flatten()


def processor() -> tuple[str, str]:
    """Return its name and features; CLPT_CONTROL_PROCESSOR names another, such as ``generic``."""
    name = os.environ.get(VARIABLE)
    return (name, "") if name else _host()


def fuses() -> bool:
    """Return whether a product and a sum are one instruction."""
    return "+fma" in processor()[1] or "+neon" in processor()[1]


def scales() -> bool:
    """Return whether several numbers times powers of two are one instruction."""
    return "+avx512vl" in processor()[1]


def target_machine(level: int = 3) -> Any:
    """Return LLVM's description of the processor, for code of an optimisation level from 0 to 3."""
    llvm.initialize_native_target()
    llvm.initialize_native_asmprinter()
    name, features = processor()
    target = llvm.Target.from_default_triple()
    return target.create_target_machine(
        cpu=name, features=features, opt=level, jit=True
    )


# --- the cache ------------------------------------------------------------------------------


def code_name(*sources: str) -> str:
    """Return the name of the code that these texts become on this machine."""
    texts = (*sources, *processor(), llvm.get_default_triple(), llvm_version)
    return hashlib.sha256("\n".join(texts).encode()).hexdigest()[:32]


def cached_code(name: str) -> bytes | None:
    """Return code from the cache, if it is whole and only the user could have written it."""
    if (folder := cache_folder()) is None:
        return None
    path = folder / f"{name}.o"
    content = read_cached(path)
    if content is None or content[:HASH] != hashlib.sha256(content[HASH:]).digest():
        return None
    with suppress(OSError):
        os.utime(path)
    return content[HASH:]


def cache_code(name: str, code: bytes) -> None:
    """Write code into the cache, if there is one; code of diagrams does not remove the solver's."""
    if (folder := cache_folder()) is not None:
        content = hashlib.sha256(code).digest() + code
        write_cached(folder / f"{name}.o", content, MOST_FILES)


# --- code -----------------------------------------------------------------------------------


def _load(
    name: str, text: Callable[[], str], plain: bool = False, level: int = 3
) -> Any:
    """Return LLVM's engine with code from the cache, or else compiled; it knows the addresses.

    In `plain` text, and in text without branches, most of LLVM's passes find nothing.
    """
    if (code := cached_code(name)) is None:
        machine = target_machine(level)
        parsed = llvm.parse_assembly(printed := text())
        parsed.triple, parsed.data_layout = machine.triple, str(machine.target_data)
        options = llvm.create_pipeline_tuning_options(speed_level=3)
        # the text has vectors already
        options.loop_vectorization = options.slp_vectorization = False
        options.loop_unrolling = options.loop_interleaving = False
        passes = llvm.create_pass_builder(machine, options)
        manager = passes.getModulePassManager()
        if plain or not BRANCHES.search(printed):
            manager = llvm.create_new_module_pass_manager()
            manager.add_instruction_combine_pass()
        manager.run(parsed, passes)
        code = bytes(machine.emit_object(parsed))
        cache_code(name, code)
    engine = llvm.create_mcjit_compiler(llvm.parse_assembly(""), target_machine())
    engine.add_object_file(llvm.ObjectFileRef.from_data(code))
    engine.finalize_object()
    return engine


class Machine:
    """Functions of arrays as machine code.

    `addresses` holds the address of each, valid for as long as this object lives.  `source` stands
    for all that the text of `module` and the optimisation `level` depend on; `plain` is that of
    `_load`.
    """

    @one_at_a_time
    def __init__(
        self,
        names: Iterable[str],
        source: str,
        module: Callable[[], Any],
        plain: bool = False,
        level: int = 3,
    ):
        name = code_name(source, _printers())
        self._engine = _load(name, lambda: str(module()), plain, level)
        self.addresses = {
            name: self._engine.get_function_address(name) for name in names
        }


@cache
def _printers() -> str:
    """Return a hash of what LLVM's text of a program depends on besides the program."""
    files = [file for place in PRINTERS for file in sorted(HERE.parent.glob(place))]
    texts = b"".join(file.read_bytes() for file in files)
    return hashlib.sha256(texts).hexdigest() + np.__version__


# --- the solver -----------------------------------------------------------------------------


ENTRY = CFUNCTYPE(
    c_int64, c_void_p
)  # takes the address of the numbers of its arguments


def numbers_of(*arguments: Any) -> np.ndarray:
    """Return the numbers of whole numbers, contiguous arrays, and tuples of these."""
    return np.array(flattened(arguments, []), dtype=np.int64)


def address_of(array: np.ndarray) -> int:
    """Return where the elements of a contiguous array are."""
    flags = array.flags
    if not flags.c_contiguous or array.dtype.char not in "dl":
        raise TypeError(f"the solver takes no array of {array.dtype}, {array.strides}")
    if flags.writeable:  # six times as quick as `__array_interface__`
        return addressof(c_char.from_buffer(array.data))
    return int(array.__array_interface__["data"][0])


def flattened(arguments: tuple, numbers: list[Any]) -> list[Any]:
    """Return numbers, and behind them those that stand for arguments, one after the other."""
    for value in arguments:
        if type(value) is np.ndarray:
            address = address_of(value) if value.size else 0
            size, item = value.size, value.itemsize
            numbers += (0, 0, size, item, address, *value.shape, *value.strides)
        elif isinstance(value, tuple):
            flattened(value, numbers)
        elif type(value) is list:  # of numbers
            numbers += value
        else:
            numbers.append(value)
    return numbers


@once()
def compiled_solver() -> SimpleNamespace:
    """Return the solver's functions as machine code, from the cache or compiled."""
    text = TEXT.read_text("utf-8")

    def announced() -> str:
        often = (
            "once" if cache_folder() else "each time: there is no folder to keep it in"
        )
        note(
            f"making the solver's machine code for this processor, a few seconds, {often}"
        )
        return text

    engine = _load(f"solver-{code_name(text)}", announced)
    entries = {
        name: ENTRY(engine.get_function_address(name))
        for name in ("advance", "evaluate")
    }
    return SimpleNamespace(engine=engine, **entries)


@once()
def compiled_series() -> SimpleNamespace:
    """Return the function `coefficients` of `enclosure.ball_series` as machine code."""
    text = BALLS.read_text("utf-8")
    engine = _load(f"solver-{code_name(text)}", lambda: text)
    entry = ENTRY(engine.get_function_address("coefficients"))
    return SimpleNamespace(engine=engine, coefficients=entry)
