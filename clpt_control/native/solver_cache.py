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
import sys
from contextlib import suppress
from functools import cache
from importlib import util
from importlib.metadata import version
from pathlib import Path
from types import FunctionType, ModuleType
from typing import Any

from ..errors import DataError
from ..files import beside
from ..files.user_cache import cache_folder, trusted
from ..progress import note
from .processor import processor

KEPT = 4  # compiled solvers of other versions that stay
OPTIONS: dict[str, Any] = {"nogil": True, "error_model": "numpy"}
ENTRIES = ("advance", "advance_fixed", "signals_at", "between")  # what is called from Python
USUAL = ("advance", "signals_at")  # what every run calls
# the rest is put in where it is called
APART = (*ENTRIES[:3], "watch", "take", "sample", "leap", "keep")


def compiled_solver() -> ModuleType:
    """Return the solver's module with its functions compiled."""
    from numba.core.compiler_lock import global_compiler_lock

    with global_compiler_lock:
        return _compiled()


@cache
def _compiled() -> ModuleType:
    from . import solver as text

    folder = cache_folder()
    if not ready():
        lasts = "there is no folder to keep it in" if folder is None else "later runs start at once"
        note(f"compiling once for every kind of diagram, some ten seconds; {lasts}")
    place = None if folder is None else _place(folder, Path(text.__file__))
    spec = util.spec_from_file_location("clpt_control_solver", place or text.__file__)
    assert spec is not None
    assert spec.loader is not None
    module = util.module_from_spec(spec)
    sys.modules[spec.name] = module
    spec.loader.exec_module(module)
    _compile(module, place is not None)
    return module


def ready() -> bool:
    """Whether the solver need not be compiled: it is in memory, or in the cache."""
    if _compiled.cache_info().currsize:
        return True
    folder = cache_folder()
    if folder is None:
        return False
    files = folder / f"solver-{_key()}" / "__pycache__"
    return all(any(files.glob(f"solver.{name}-*.nbc")) for name in USUAL)


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

    files = (
        Path(__file__).with_name(f"{name}.py")
        for name in ("solver", "address_call", "solver_cache")
    )
    made_of = [file.read_text("utf-8") for file in files]
    made_of += [version(name) for name in ("numba", "llvmlite", "numpy")]
    made_of += [os.environ.get("NUMBA_OPT", ""), llvm.get_default_triple()]
    made_of += [sys.version, *processor()]
    return hashlib.sha256("\n".join(made_of).encode()).hexdigest()[:24]


def _compile(module: ModuleType, kept: bool) -> None:
    from numba import njit
    from numba.extending import overload

    from .address_call import call_address

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
