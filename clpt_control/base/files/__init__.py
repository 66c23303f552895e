"""Atomic writing of files, and the user's cache.

A file is written under a temporary name in its folder and renamed, so that an interrupt leaves the
old file or none.  `files.reading` opens files.
"""

import errno
import os
import platform
import re
import secrets
import shutil
import stat
import sys
import zlib
from collections.abc import Iterator, Mapping, Sequence
from contextlib import ExitStack, contextmanager, suppress
from pathlib import Path
from typing import TYPE_CHECKING, Any

from ..errors import ClptError, DataError
from ..progress.interrupt import check, folders, remove, unfinished
from .reading import OPENED, SLASH, AnyPath, netcdf_engine, opened, opened_name, renamed

if TYPE_CHECKING:
    import xarray
    from matplotlib.figure import Figure

CACHE = "CLPT_CONTROL_CACHE"  # environment variable with another folder for the cache
LONGEST_NAME, LONGEST_PATH = 200, 3000  # bytes, less the length of the temporary suffix
NETCDF_NAME = re.compile(
    r"[^\x00-/:-@\[-^`{-\x7f][^\x00-\x1f/\x7f]{,200}(?<! )"
).fullmatch
HERE = f"{zlib.crc32(platform.node().encode()):08x}"  # this machine
# temporary name: name of the file, process of this machine
PART = re.compile(rf"\.(.+)\.{HERE}-(\d{{1,7}})-[0-9a-f]{{8}}\.part")


@contextmanager
def atomic_path(path: AnyPath, folder: bool = False) -> Iterator[Path]:
    """Make a hidden empty file or folder next to a path, and rename it to the path at the end.

    Its name is ``.NAME.MACHINE-PROCESS-CHANCE.part``.  It is removed if the work fails.  Files of
    killed processes of this machine are removed by the next call.  The mode is that of the replaced
    file, or of a new file by the umask; a link is followed.
    """
    target, mode = _target(path)
    suffix = f"{HERE}-{os.getpid()}-{secrets.token_hex(4)}.part"
    partial = target.parent / f".{target.name}.{suffix}"
    try:
        _remove_abandoned(target)
        unfinished.add(partial)
        if folder:
            partial.mkdir()
        else:
            new_mode = 0o666 if mode is None else 0o600  # the umask is applied
            os.close(os.open(partial, os.O_CREAT | os.O_EXCL | os.O_WRONLY, new_mode))
        yield partial
        check()  # after a dropped interrupt the file may be incomplete
        if mode is not None and not folder:
            partial.chmod(mode)
        partial.replace(target)
    except OSError as error:
        reason = error.strerror or error
        if error.errno in (errno.ENOTEMPTY, errno.EEXIST):
            reason = "another command made that folder meanwhile; let it end, or give another name"
        raise DataError(f"{path}: cannot be written: {reason}") from None
    finally:
        remove(partial)
        unfinished.discard(partial)


def _remove_abandoned(target: Path) -> None:
    """Remove temporary files for a target that killed processes of this machine left."""
    readable = os.access(target.parent, os.R_OK)
    for name in os.listdir(target.parent) if readable else ():  # noqa: PTH208  paths are slow
        match = PART.fullmatch(name) if name.startswith(".") else None
        if match and match[1] == target.name and _is_dead(int(match[2])):
            remove(target.with_name(name))


def _target(path: AnyPath) -> tuple[Path, int | None]:
    """Return the path of a file to write, links resolved, and the mode of the present file.

    A device, a pipe or a socket is refused: a file would replace it.
    """
    path = Path(path)
    check_name(path)
    target = Path(os.path.realpath(path)) if path.is_symlink() else path
    if not target.parent.is_dir():
        raise DataError(
            f"{path}: cannot be written: the folder {target.parent} does not exist"
        )
    try:
        mode = target.stat().st_mode
    except FileNotFoundError:
        return target, None
    except OSError as error:
        raise DataError(
            f"{path}: cannot be written: {error.strerror or error}"
        ) from None
    if not (stat.S_ISREG(mode) or stat.S_ISDIR(mode)):
        raise DataError(f"{path}: is not a regular file. Give another name")
    return target, stat.S_IMODE(mode)


def _is_dead(process: int) -> bool:
    """Return True if a process of this machine has ended; False on Windows, without a test."""
    if os.name != "posix":
        return False
    try:
        os.kill(process, 0)
    except OSError as error:
        return isinstance(error, ProcessLookupError)
    return False


def write_together(
    results: "Mapping[Path, str | bytes | xarray.Dataset | Figure]",
) -> None:
    """Write files under temporary names, then rename them; none if one cannot be written.

    A result is a text, bytes, a figure, or a dataset, whose variables with NaN get NaN as
    _FillValue.  The first file is renamed last: if it is new, all files are new.
    """
    with ExitStack() as renamed:
        for path in results:
            check_writable(path)
        for path, result in results.items():
            _write(result, renamed.enter_context(atomic_path(path)), Path(path))


def _write(result: Any, partial: Path, path: Path) -> None:
    if isinstance(result, str | bytes):
        partial.write_bytes(result.encode() if isinstance(result, str) else result)
        return
    if hasattr(result, "savefig"):
        from ..figures import save_figure

        save_figure(result, partial, path.suffix[1:].lower())
        return
    engine, encoding = netcdf_engine(), {}
    result = renamed(result, "/", SLASH)
    for name, values in result.variables.items():
        if not NETCDF_NAME(str(name)):
            raise DataError(f"{path}: NetCDF has no name {str(name)!r:.40}. Rename it")
        has_nan = values.dtype.kind == "f" and bool(values.isnull().any())
        encoding[name] = {"_FillValue": float("nan") if has_nan else None}
        if engine == "netcdf4" and values.ndim and values.dtype.kind in "fiu":
            encoding[name]["fletcher32"] = True  # checksum, verified on reading
    try:
        with _no_cluster(), partial.open("rb") as file:
            # the library would read a \\ of the path as a folder
            name = opened_name(file.fileno(), partial)
            result.to_netcdf(name, engine=engine, encoding=encoding)
    except (
        RuntimeError,
        PermissionError,
        UnicodeError,
    ) as error:  # of a full disk, too
        full = shutil.disk_usage(partial.parent).free < 2**20
        reason = getattr(error, "strerror", None) or str(error)
        if isinstance(error, UnicodeError):
            reason = (
                "the name of its folder, or a text in it, holds bytes that are no text"
            )
        reason = "no space left" if full else reason
        raise DataError(f"{path}: cannot be written: {reason}") from None


@contextmanager
def _no_cluster() -> Iterator[None]:
    """Keep xarray from importing `distributed` to look for a cluster that writes.

    Without an import of it by the user there is no cluster.
    """
    sys.modules.setdefault("distributed", None)  # type: ignore[arg-type]
    try:
        yield
    finally:
        if sys.modules["distributed"] is None:
            del sys.modules["distributed"]


def write_file(path: AnyPath, result: "str | bytes | xarray.Dataset | Figure") -> None:
    """Write one file atomically."""
    write_together({Path(path): result})


def check_name(path: AnyPath) -> None:
    """Refuse a name that is too long or not text."""
    try:
        longest = max(
            (len(component.encode()) for component in Path(path).parts), default=0
        )
    except UnicodeEncodeError:
        raise DataError(f"{path}: its name is not valid text. Rename it") from None
    if longest > LONGEST_NAME or len(str(path)) > LONGEST_PATH:
        raise DataError(f"{str(path)[:40]}...: the name is too long")


def make_folder(path: AnyPath) -> Path:
    """Create a folder for results; a command removes it if it stays empty."""
    path = Path(path)
    check_name(path)
    new = [folder for folder in (path, *path.parents) if not os.path.lexists(folder)]
    folders.extend(reversed(new))
    try:
        path.mkdir(parents=True, exist_ok=True)
    except FileExistsError:
        raise ClptError(f"{path}: is a file. Give a folder") from None
    except OSError as error:
        raise ClptError(f"{path}: cannot be made: {error.strerror}") from None
    return path


def check_writable(
    path: AnyPath | None, kind: str = "", endings: Sequence[str] = ()
) -> None:
    """Refuse, before work begins, a file that could not be written: no folder, or read-only.

    The name must have one of the `endings`, if any; `kind` is the kind of file, such as
    "a figure", for the message.
    """
    if path is None:  # no file is asked for
        return
    target, _ = _target(path)
    if target.is_dir():
        raise DataError(f"{path}: is a folder. Give another name, or move it away")
    if not os.access(target.parent, os.W_OK):
        raise DataError(
            f"{path}: cannot be written: the folder {target.parent} is read-only"
        )
    if endings and Path(path).suffix.lower() not in endings:
        allowed = " or ".join(", ".join(endings).rsplit(", ", 1))
        raise DataError(f"{path}: {kind}'s name must end in {allowed}")


# --- the user's cache of compiled code -----------------------------------------------------------


def cache_folder() -> Path | None:
    """Return the cache's folder, created if necessary.

    Return None if it is not writable, or another user could have written into it.
    """
    try:
        caches = os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache"
        folder = Path(os.environ.get(CACHE) or Path(caches, "clpt-control"))
        folder.mkdir(parents=True, exist_ok=True, mode=0o700)
        return folder if trusted(folder.stat()) and os.access(folder, os.W_OK) else None
    except (OSError, RuntimeError):  # RuntimeError: a user without a home
        return None


def trusted(state: os.stat_result) -> bool:
    """Return True if a folder or file belongs to the user and others may not write to it."""
    if not hasattr(os, "getuid"):
        return True  # Windows: the user's profile is closed to others
    writable = state.st_mode & (stat.S_IWGRP | stat.S_IWOTH)
    return state.st_uid in (os.getuid(), 0) and not writable


@contextmanager
def _through_folder(path: Path) -> Iterator[Path]:
    """Yield a path to a file of the cache through the descriptor of its checked folder.

    Other users may rename parents of the folder meanwhile; the descriptor stays the checked folder.
    On a system without ``/proc`` only the check by name in `cache_folder` remains.
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


def read_cached(path: Path) -> bytes | None:
    """Return the content of a file of the cache; None if it is missing or not the user's."""
    with (
        suppress(DataError, OSError),
        _through_folder(path) as safe,
        opened(safe) as file,
    ):
        if trusted(os.fstat(file.fileno())):
            return file.read()
    return None


def write_cached(path: Path, data: bytes, most: int) -> None:
    """Write a file of the cache, readable only by the user; failures are ignored.

    Of the files FAMILY-NAME with the same ending about the newest `most` are kept.  When there are
    more, a sixteenth is removed at once, so that few writes sort all files.
    """
    with suppress(DataError, OSError), _through_folder(path) as safe:
        safe.unlink(missing_ok=True)  # its mode may differ
        with atomic_path(safe) as partial:
            partial.chmod(0o600)
            partial.write_bytes(data)
    with suppress(OSError):
        family, ending = path.stem.rpartition("-")[0], path.suffix
        names = (name for name in os.listdir(path.parent) if name.endswith(ending))  # noqa: PTH208
        family_names = [name for name in names if name.rpartition("-")[0] == family]
        if len(family_names) > most:
            files = sorted(
                map(path.with_name, family_names),
                key=lambda file: -file.stat().st_mtime,
            )
            for file in files[most - most // 16 :]:
                file.unlink(missing_ok=True)
