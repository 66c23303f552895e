"""The solver as machine code, compiled once by Numba and kept in the user's cache.

The text that is compiled is `solver.py` itself, copied into a folder named by a hash
of what is compiled, the versions and the processor, so that what lies there
is never stale; Numba keeps the machine code beside it.  Diagrams are not kept: LLVM
prints them in a few hundredths of a second.
"""

import hashlib
import os
import pickletools
import shutil
import stat
import sys
from contextlib import suppress
from functools import cache
from importlib import util
from importlib.metadata import version
from pathlib import Path
from types import FunctionType, ModuleType
from typing import Any

from numba.core.compiler_lock import global_compiler_lock

from ..errors import DataError
from ..files import beside
from .machine import call_address, processor

FOLDER = "CLPT_CONTROL_CACHE"  # environment variable that names another folder
KEPT = 4  # compiled solvers of other versions that stay
OPTIONS: dict[str, Any] = {"nogil": True, "error_model": "numpy"}
ENTRIES = ("advance", "advance_fixed", "signals_at", "between")  # what is called from Python
# the rest is put in where it is called
APART = (*ENTRIES[:3], "watch", "take", "sample", "leap", "keep")


def cache_folder() -> Path | None:
    """Return the folder of compiled code, made if need be.

    None where it cannot be written to, or where another user could have put code there.
    """
    import platformdirs

    try:
        wanted = os.environ.get(FOLDER) or platformdirs.user_cache_dir("clpt-control")
        folder = Path(wanted)
        folder.mkdir(parents=True, exist_ok=True, mode=0o700)
        return folder if trusted(folder) and os.access(folder, os.W_OK) else None
    except (OSError, RuntimeError):  # RuntimeError: a user without a home
        return None


def trusted(folder: Path) -> bool:
    """Whether a folder is the user's own and closed to others."""
    if not hasattr(os, "getuid"):
        return True  # Windows: the user's profile is closed to others
    found = folder.stat()
    others = found.st_mode & (stat.S_IWGRP | stat.S_IWOTH)
    return found.st_uid in (os.getuid(), 0) and not others


@cache
@global_compiler_lock
@cache
def compiled_solver() -> ModuleType:
    """Return the solver's module with its functions compiled."""
    from . import solver as text

    folder = cache_folder()
    place = None if folder is None else _place(folder, Path(text.__file__))
    spec = util.spec_from_file_location("clpt_control_solver", place or text.__file__)
    assert spec is not None
    assert spec.loader is not None
    module = util.module_from_spec(spec)
    sys.modules[spec.name] = module
    spec.loader.exec_module(module)
    _compile(module, place is not None)
    return module


def _place(folder: Path, text: Path) -> Path | None:
    """Return the solver's text in the folder of this code and machine."""
    own = folder / f"solver-{_key()}"
    path = own / "solver.py"
    try:
        if path.exists() and trusted(own) and not _whole(own):
            shutil.rmtree(own)
        if not path.exists():
            with suppress(DataError), beside(own, folder=True) as made:
                shutil.copyfile(text, made / "solver.py")  # another process may be first
            _forget(folder, own)
        os.utime(own)
        return path if trusted(own) and path.read_bytes() == text.read_bytes() else None
    except OSError:
        return None


def _whole(own: Path) -> bool:
    """Whether Numba's files can be read to their ends; after a full disk they cannot."""
    for file in own.glob("__pycache__/*.nb[ci]"):
        try:
            with file.open("rb") as data:
                for _ in range(2 if file.suffix == ".nbi" else 1):  # .nbi: a version, an index
                    for _ in pickletools.genops(data):  # read, not run
                        pass
        except FileNotFoundError:  # another process is at it
            continue
        except ValueError:
            return False
    return True


def _forget(folder: Path, own: Path) -> None:
    """Remove all but the newest of what other versions left."""
    others = [one for one in folder.glob("solver-*") if one != own and one.is_dir()]
    others.sort(key=lambda one: one.stat().st_mtime, reverse=True)
    for one in others[KEPT:]:
        shutil.rmtree(one, ignore_errors=True)


def _key() -> str:
    """Return a name for the files that are compiled, the versions and the processor."""
    import llvmlite.binding as llvm
    from numba import config

    files = (
        Path(__file__).with_name(f"{name}.py") for name in ("solver", "machine", "solver_cache")
    )
    made_of = [file.read_text("utf-8") for file in files]
    made_of += [version(name) for name in ("numba", "llvmlite", "numpy")]
    made_of += [sys.version, *processor(), str(vars(config)["OPT"]), llvm.get_default_triple()]
    return hashlib.sha256("\n".join(made_of).encode()).hexdigest()[:24]


def _compile(module: ModuleType, kept: bool) -> None:
    from numba import njit
    from numba.extending import overload

    @overload(module.call, inline="always")
    def _(function, t, X, first, P, T, W, D, to):
        def by_address(function, t, X, first, P, T, W, D, to):
            call_address(function, t, X, first, P, T, W, D, to)  # type: ignore[call-arg]

        return by_address

    for name, function in list(vars(module).items()):
        if isinstance(function, FunctionType) and function is not module.call:
            compiled = njit(function, forceinline=name not in APART, **OPTIONS)
            if kept and name in ENTRIES:
                compiled.enable_caching()
            setattr(module, name, compiled)
