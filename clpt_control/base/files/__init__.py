"""Files: written whole or not at all, and the user's cache.

A file is written beside its place first and renamed there, so that an interrupt leaves the old
file or none.  `files.reading` opens files.
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

CACHE = "CLPT_CONTROL_CACHE"  # environment variable that names another folder for it
LONGEST_NAME, LONGEST_PATH = 200, 3000  # bytes, with room for what is written beside
NETCDF_NAME = re.compile(
    r"[^\x00-/:-@\[-^`{-\x7f][^\x00-\x1f/\x7f]{,200}(?<! )"
).fullmatch
HERE = f"{zlib.crc32(platform.node().encode()):08x}"  # this machine
# of a process here
PART = re.compile(rf"\.(.+)\.{HERE}-(\d{{1,7}})-[0-9a-f]{{8}}\.part")


@contextmanager
def beside(path: AnyPath, folder: bool = False) -> Iterator[Path]:
    """Make a hidden empty file, or folder, beside a place, and rename it there at the end.

    Its name is ``.NAME.MACHINE-PROCESS-CHANCE.part``.  It is removed where the work fails; the next
    one removes what a killed process of this machine left.  It has the mode of the file that it
    replaces, or that of a new file by the umask; a link is followed.
    """
    place, mode = _place(path)
    part = (
        place.parent / f".{place.name}.{HERE}-{os.getpid()}-{secrets.token_hex(4)}.part"
    )
    try:
        readable = os.access(place.parent, os.R_OK)
        for left in os.listdir(place.parent) if readable else ():  # noqa: PTH208  paths are slow
            found = PART.fullmatch(left) if left.startswith(".") else None
            if found and found[1] == place.name and _is_dead(int(found[2])):
                remove(place.with_name(left))
        unfinished.add(part)
        if folder:
            part.mkdir()
        else:
            new = 0o666 if mode is None else 0o600  # less what the umask takes
            os.close(os.open(part, os.O_CREAT | os.O_EXCL | os.O_WRONLY, new))
        yield part
        check()  # an interrupt that was dropped may have changed what was written
        if mode is not None and not folder:
            part.chmod(mode)
        part.replace(place)
    except OSError as error:
        why = error.strerror or error
        if error.errno in (errno.ENOTEMPTY, errno.EEXIST):
            why = "another command made that folder meanwhile; let it end, or give another name"
        raise DataError(f"{path}: cannot be written: {why}") from None
    finally:
        remove(part)
        unfinished.discard(part)


def _place(path: AnyPath) -> tuple[Path, int | None]:
    """Return where a file is to be written, and the mode of the one that stands there.

    A device, a pipe or a socket is refused: it would be replaced by a file.
    """
    path = Path(path)
    check_name(path)
    place = Path(os.path.realpath(path)) if path.is_symlink() else path
    if not place.parent.is_dir():
        raise DataError(
            f"{path}: cannot be written: the folder {place.parent} does not exist"
        )
    try:
        mode = place.stat().st_mode
    except FileNotFoundError:
        return place, None
    except OSError as error:
        raise DataError(
            f"{path}: cannot be written: {error.strerror or error}"
        ) from None
    if not (stat.S_ISREG(mode) or stat.S_ISDIR(mode)):
        raise DataError(f"{path}: is no regular file; give the name of one")
    return place, stat.S_IMODE(mode)


def _is_dead(process: int) -> bool:
    """Return whether a process of this machine has ended; on Windows it may not be asked."""
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
    """Write files beside their places, then rename them; none where one cannot be written.

    Each is a text, bytes, a dataset, whose variables with NaN get them as _FillValue, or a
    figure.  The first is renamed last: where it is new, all are.
    """
    with ExitStack() as renamed:
        for path in results:
            check_writable(path)
        for path, result in results.items():
            _put(result, renamed.enter_context(beside(path)), Path(path))


def _put(result: Any, part: Path, path: Path) -> None:
    if isinstance(result, str | bytes):
        part.write_bytes(result.encode() if isinstance(result, str) else result)
        return
    if hasattr(result, "savefig"):
        from ..figures import save_figure

        save_figure(result, part, path.suffix[1:].lower())
        return
    engine, encoding = netcdf_engine(), {}
    result = renamed(result, "/", SLASH)
    for name, values in result.variables.items():
        if not NETCDF_NAME(str(name)):
            raise DataError(
                f"{path}: NetCDF has no name {str(name)!r:.40}; call it otherwise"
            )
        has_nan = values.dtype.kind == "f" and bool(values.isnull().any())
        encoding[name] = {"_FillValue": float("nan") if has_nan else None}
        if engine == "netcdf4" and values.ndim and values.dtype.kind in "fiu":
            encoding[name]["fletcher32"] = (
                True  # a checksum that the library asks when it reads
            )
    try:
        with _no_cluster(), part.open("rb") as held:
            # its library takes a \\ for a folder
            place = opened_name(held.fileno(), part)
            result.to_netcdf(place, engine=engine, encoding=encoding)
    except (
        RuntimeError,
        PermissionError,
        UnicodeError,
    ) as error:  # of a full disk, too
        full = shutil.disk_usage(part.parent).free < 2**20
        reason = getattr(error, "strerror", None) or str(error)
        if isinstance(error, UnicodeError):
            reason = (
                "the name of its folder, or a text in it, holds bytes that are no text"
            )
        reason = "no space left" if full else reason
        raise DataError(f"{path}: cannot be written: {reason}") from None


@contextmanager
def _no_cluster() -> Iterator[None]:
    """Keep xarray from importing dask's cluster, to ask whether one writes too.

    No cluster writes where nobody has imported it.
    """
    sys.modules.setdefault("distributed", None)  # type: ignore[arg-type]
    try:
        yield
    finally:
        if sys.modules["distributed"] is None:
            del sys.modules["distributed"]


def write_file(path: AnyPath, result: "str | bytes | xarray.Dataset | Figure") -> None:
    """Write one file, whole or not at all."""
    write_together({Path(path): result})


def check_name(path: AnyPath) -> None:
    """Refuse a name that is too long or no text: nothing can be written under it."""
    try:
        longest = max((len(part.encode()) for part in Path(path).parts), default=0)
    except UnicodeEncodeError:
        raise DataError(f"{path}: its name holds bytes that are no text") from None
    if longest > LONGEST_NAME or len(str(path)) > LONGEST_PATH:
        raise DataError(f"{str(path)[:40]}...: the name is too long")


def make_folder(path: AnyPath) -> Path:
    """Make a folder for results; a command removes it if it stays empty."""
    path = Path(path)
    check_name(path)
    new = [folder for folder in (path, *path.parents) if not os.path.lexists(folder)]
    folders.extend(reversed(new))
    try:
        path.mkdir(parents=True, exist_ok=True)
    except FileExistsError:
        raise ClptError(f"{path}: is a file; give a folder") from None
    except OSError as error:
        raise ClptError(f"{path}: cannot be made: {error.strerror}") from None
    return path


def check_writable(path: AnyPath, what: str = "", endings: Sequence[str] = ()) -> None:
    """Refuse, before work begins, a file that could not be written: no folder, or read-only.

    Its name must have one of the `endings`, if there are any; `what` is what it is to be, such as
    "a figure".
    """
    place, _ = _place(path)
    if place.is_dir():
        raise DataError(f"{path}: is a folder; give another name, or move it away")
    if not os.access(place.parent, os.W_OK):
        raise DataError(
            f"{path}: cannot be written: the folder {place.parent} is read-only"
        )
    if endings and Path(path).suffix.lower() not in endings:
        allowed = " or ".join(", ".join(endings).rsplit(", ", 1))
        raise DataError(f"{path}: {what}'s name must end in {allowed}")


# --- the user's cache: compiled code, verdicts ---------------------------------------------------


def cache_folder() -> Path | None:
    """Return the cache's folder; make it if need be.

    Return None where it cannot be written to, or another user could have put something there.
    """
    try:
        caches = os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache"
        folder = Path(os.environ.get(CACHE) or Path(caches, "clpt-control"))
        folder.mkdir(parents=True, exist_ok=True, mode=0o700)
        return folder if trusted(folder.stat()) and os.access(folder, os.W_OK) else None
    except (OSError, RuntimeError):  # RuntimeError: a user without a home
        return None


def trusted(state: os.stat_result) -> bool:
    """Return whether a folder or a file is the user's own and others may not write to it."""
    if not hasattr(os, "getuid"):
        return True  # Windows: the user's profile is closed to others
    others = state.st_mode & (stat.S_IWGRP | stat.S_IWOTH)
    return state.st_uid in (os.getuid(), 0) and not others


@contextmanager
def _through_folder(path: Path) -> Iterator[Path]:
    """Yield a path to a file of the cache that begins at its opened folder, which is checked.

    Others may rename its parents meanwhile: so the folder that is checked is the one that is used.
    Where a system has no ``/proc``, `cache_folder` has checked it by its name.
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
    """Return what a file of the cache holds; None where it is not there, or not the user's own."""
    with (
        suppress(DataError, OSError),
        _through_folder(path) as safe,
        opened(safe) as file,
    ):
        if trusted(os.fstat(file.fileno())):
            return file.read()
    return None


def write_cached(path: Path, data: bytes, most: int) -> None:
    """Write a file of the cache for the user alone; where that fails, go on without.

    Of files FAMILY-NAME with its ending the newest `most` stay, or a few less: so that not each
    file that is written asks for the times of all.
    """
    with suppress(DataError, OSError), _through_folder(path) as safe:
        safe.unlink(missing_ok=True)  # its mode may be another
        with beside(safe) as part:
            part.chmod(0o600)
            part.write_bytes(data)
    with suppress(OSError):
        family, ending = path.stem.rpartition("-")[0], path.suffix
        names = (name for name in os.listdir(path.parent) if name.endswith(ending))  # noqa: PTH208
        own = [name for name in names if name.rpartition("-")[0] == family]
        if len(own) > most:
            files = sorted(
                map(path.with_name, own), key=lambda file: -file.stat().st_mtime
            )
            for file in files[most - most // 16 :]:
                file.unlink(missing_ok=True)
