"""The user's folder of what was made before: compiled code, verdicts."""

import os
import stat
import sys
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from ..errors import DataError
from . import beside
from .reading import OPENED, opened, opened_name

FOLDER = "CLPT_CONTROL_CACHE"  # environment variable that names another folder


def cache_folder() -> Path | None:
    """Return the folder, made if need be.

    None where it cannot be written to, or where another user could have put something there.
    """
    try:
        folder = Path(os.environ.get(FOLDER) or usual() / "clpt-control")
        folder.mkdir(parents=True, exist_ok=True, mode=0o700)
        return folder if trusted(folder.stat()) and os.access(folder, os.W_OK) else None
    except (OSError, RuntimeError):  # RuntimeError: a user without a home
        return None


def usual() -> Path:
    """Return where a user's programs keep what can be made again."""
    if sys.platform == "win32":
        return Path(os.environ.get("LOCALAPPDATA") or Path.home() / "AppData" / "Local")
    caches = "Library/Caches" if sys.platform == "darwin" else ".cache"
    named = os.environ.get("XDG_CACHE_HOME", "")
    return Path(named) if Path(named).is_absolute() else Path.home() / caches


def trusted(found: os.stat_result) -> bool:
    """Whether a folder or a file is the user's own and others may not write to it."""
    if not hasattr(os, "getuid"):
        return True  # Windows: the user's profile is closed to others
    others = found.st_mode & (stat.S_IWGRP | stat.S_IWOTH)
    return found.st_uid in (os.getuid(), 0) and not others


@contextmanager
def _own(path: Path) -> Iterator[Path]:
    """Yield the way to a file of the cache through its folder, which is opened and asked.

    Its parents may be renamed by others meanwhile: the folder that is asked is the one that is
    used.  Where a system has no ``/proc``, `cache_folder` asked it by its name.
    """
    if not os.path.isdir(OPENED):  # noqa: PTH112
        yield path
        return
    folder = os.open(path.parent, os.O_RDONLY)
    try:
        if not trusted(os.fstat(folder)):
            raise DataError(f"{path.parent}: others may write to it")
        yield Path(opened_name(folder, path.parent), path.name)
    finally:
        os.close(folder)


def kept(path: Path) -> bytes | None:
    """Return what a file of the cache holds; None where it is not there, or not the user's own."""
    with suppress(DataError, OSError), _own(path) as own, opened(own) as file:
        if trusted(os.fstat(file.fileno())):
            return file.read()
    return None


def keep(path: Path, data: bytes) -> None:
    """Write a file of the cache for the user alone; where that cannot be, go on without."""
    with suppress(DataError, OSError), _own(path) as own:
        own.unlink(missing_ok=True)  # whose mode may be another
        with beside(own) as made:
            made.chmod(0o600)
            made.write_bytes(data)
