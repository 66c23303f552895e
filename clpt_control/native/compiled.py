"""Compiled diagrams, cached on disk.

The generated module lies in the user's cache folder under a hash of its own
text (which holds every block's equations and the whole solver) and of the
versions and the processor, so that it is never stale; Numba keeps the machine
code beside it.
"""

import hashlib
import importlib.util
import os
import sys
import tempfile
from functools import lru_cache
from pathlib import Path
from types import CodeType, ModuleType

from .fuse import Fused

FOLDER = "CLPT_CONTROL_CACHE"  # environment variable that names another folder


def cache_folder() -> Path:
    """Give the folder of compiled diagrams, made if need be.

    Returns
    -------
    Path
        ``$CLPT_CONTROL_CACHE``, the user's cache, or a temporary folder
        where neither can be written to.

    Examples
    --------
    >>> cache_folder().is_dir()
    True
    """
    import platformdirs

    wanted = os.environ.get(FOLDER) or platformdirs.user_cache_dir("clpt-control")
    try:
        Path(wanted).mkdir(parents=True, exist_ok=True)
        if os.access(wanted, os.W_OK):
            return Path(wanted)
    except OSError:
        pass
    return Path(tempfile.mkdtemp(prefix="clpt-control-"))


def compiled_module(fused: Fused, method: str = "dop853") -> ModuleType:
    """Compile a fused diagram, or load it from the cache.

    Parameters
    ----------
    fused : Fused
        As `fuse` gives it.
    method : str, optional
        ``"dop853"``, or ``"vern7"`` with `advance` alone.

    Returns
    -------
    module
        With the functions `advance` and `record`.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> from clpt_control.native.fuse import fuse
    >>> module = compiled_module(fuse(clpt.closed_loop(clpt.paper_scenario())))
    >>> module.NX
    14
    """
    return _module(fused.source, fused.nstates, fused.nsignals, fused.guarded, method=method)


def lane_module_or_none(fused: Fused) -> ModuleType | None:
    """Compile for eight runs at once where it pays.

    Parameters
    ----------
    fused : Fused
        As `fuse` gives it.

    Returns
    -------
    module or None
        With the functions `many` and `many_rk4`; None for a diagram with a
        guard and on a processor without fused multiply-add.
    """
    import llvmlite.binding as llvm

    if fused.guarded or not llvm.get_host_cpu_features().get("fma", False):
        return None
    return _module(fused.source, fused.nstates, fused.nsignals, False, lanes=True)


def _digest(code: CodeType) -> str:
    """Give what a function does as text, the same in every process."""
    constants = (
        _digest(value) if isinstance(value, CodeType) else repr(value) for value in code.co_consts
    )
    names = (" ".join(code.co_names), " ".join(code.co_varnames))
    return "\n".join([code.co_code.hex(), *names, *constants])


@lru_cache(maxsize=1)
def _solver_key() -> str:
    """Give what the module's text is made of beside the diagram, without making it.

    Taken from the functions and texts in memory, which make the module.
    """
    import llvmlite
    import numba
    import numpy
    import scipy

    from ..blocks.words import WORDS
    from . import dormand_prince, lane_text, solver_text, verner

    makers = [*vars(dormand_prince).values(), *WORDS.values()]
    codes = [_digest(maker.__code__) for maker in makers if hasattr(maker, "__code__")]
    texts = [room.HEADER + room.SOLVER + room.OPTIONS for room in (solver_text, lane_text)]
    texts.append(f"{solver_text.MOST_STEPS} {verner.ADVANCE} {verner.A} {verner.B} {verner.B6}")
    here = Path(__file__).parent
    rooms = [here / "elementary.py", *sorted((here / "lanes").glob("*.py"))]
    versions = [package.__version__ for package in (numba, llvmlite, numpy, scipy)]
    read = [room.read_text("utf-8") for room in rooms]
    return "\n".join([sys.version, *versions, *codes, *texts, *read])


@lru_cache(maxsize=64)
def _module(
    source: str, nx: int, nw: int, guarded: bool, lanes: bool = False, method: str = "dop853"
) -> ModuleType:
    made_of = "\n".join([source, f"{nx} {nw} {guarded} {lanes} {method}", _solver_key()])
    name = f"fused_{hashlib.sha256(made_of.encode()).hexdigest()[:24]}"
    path = cache_folder() / f"{name}.py"
    if not path.exists():
        from .lane_text import lane_module_text
        from .solver_text import module_text

        text = (
            lane_module_text(source, nx, nw)
            if lanes
            else module_text(source, nx, nw, guarded, method)
        )
        handle, beside = tempfile.mkstemp(dir=path.parent, prefix=f".{name}.")
        with os.fdopen(handle, "w", encoding="utf-8") as file:
            file.write(text)
        Path(beside).replace(path)
    spec = importlib.util.spec_from_file_location(f"clpt_control_{name}", path)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = module
    spec.loader.exec_module(module)
    return module
