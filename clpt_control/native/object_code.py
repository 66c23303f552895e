"""Object code: LLVM's text made for this processor, kept in the user's cache, and loaded.

A file is named by a hash of what it is made of, the versions and the processor, so what lies there
is never stale; it begins with the hash of what follows, so one cut short is made again.  LLVM is
asked by one thread at a time.
"""

import hashlib
import os
from collections.abc import Callable
from contextlib import suppress
from functools import cache, wraps
from importlib.metadata import version
from pathlib import Path
from threading import RLock
from typing import Any, ParamSpec, TypeVar

import llvmlite.binding as llvm

from ..errors import DataError
from ..files import beside
from ..files.user_cache import cache_folder, trusted
from .processor import processor

KEPT = 200  # files of a family, "solver-" or none; the least recently used go
HASH = hashlib.sha256().digest_size
LOCK = RLock()
P = ParamSpec("P")
R = TypeVar("R")


def one_at_a_time(function: Callable[P, R]) -> Callable[P, R]:
    """Return a function that one thread at a time may run."""

    @wraps(function)
    def locked(*arguments: P.args, **named: P.kwargs) -> R:
        with LOCK:
            return function(*arguments, **named)

    return locked


def name_of(*made_of: str) -> str:
    """Return the name of code that is made of these texts, here."""
    known = (*made_of, *processor(), llvm.get_default_triple(), version("llvmlite"))
    return hashlib.sha256("\n".join(known).encode()).hexdigest()[:32]


def kept(name: str) -> bytes | None:
    """Return code from the cache, if it is whole and nobody else could have put it there."""
    folder = _folder()
    if folder is None:
        return None
    path = folder / f"{name}.o"
    with suppress(OSError):
        if trusted(path):
            found = path.read_bytes()
            if found[:HASH] == hashlib.sha256(found[HASH:]).digest():
                os.utime(path)
                return found[HASH:]
    return None


def keep(name: str, code: bytes) -> None:
    """Put code into the cache, where there is one; diagrams do not push out the solver."""
    folder = _folder()
    if folder is None:
        return
    with suppress(DataError, OSError):
        with beside(folder / f"{name}.o") as made:
            made.write_bytes(hashlib.sha256(code).digest() + code)
        family = name.rpartition("-")[0]
        files = [one for one in folder.glob("*.o") if one.stem.rpartition("-")[0] == family]
        files.sort(key=lambda one: one.stat().st_mtime, reverse=True)
        for one in files[KEPT:]:
            one.unlink(missing_ok=True)


def _folder() -> Path | None:
    above = cache_folder()
    if above is None:
        return None
    with suppress(OSError):
        folder = above / "code"
        folder.mkdir(exist_ok=True, mode=0o700)
        return folder if trusted(folder) else None
    return None


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


def loaded(code: bytes) -> Any:
    """Return an engine that holds object code and knows the addresses of its functions."""
    engine = llvm.create_mcjit_compiler(llvm.parse_assembly(""), target_machine())
    engine.add_object_file(llvm.ObjectFileRef.from_data(code))
    engine.finalize_object()
    return engine
