"""One follower per folder of results.

Two processes that write the same results would each take the other's half
written files for leavings.  The file `.clpt-lock` in the state is locked by the
system (flock) for as long as its process lives, so the lock of a process that
was killed is free at once; the process's number stands in it for the message.
Where the system has no such locks, nothing is locked.
"""

import os
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from ..errors import DataError
from ..files import make_folder

try:
    import fcntl
except ImportError:  # pragma: no cover - Windows
    fcntl = None  # type: ignore[assignment]

LOCK = ".clpt-lock"


def check_folders(folder: str | Path, out: str | Path) -> None:
    """Refuse to follow what is no folder, or that of the results.

    Parameters
    ----------
    folder : str or Path
        Where files arrive.
    out : str or Path
        Where results are to lie.

    Raises
    ------
    DataError
        If files cannot arrive there.
    """
    folder, out = Path(folder), Path(out)
    if not os.path.isdir(folder):  # noqa: PTH112 - never raises
        raise DataError(f"{folder}: no such folder; give the folder where dives arrive")
    for place in (out, out / "state"):
        if os.path.realpath(place) == os.path.realpath(folder) or _same(place, folder):
            raise DataError(
                f"--out {out}: results would lie in the followed folder {folder} and count as new "
                "files there; give another folder, or leave --out away"
            )


def _same(one: Path, other: Path) -> bool:
    try:
        return one.samefile(other)
    except OSError:
        return False


@contextmanager
def alone(state: str | Path) -> Iterator[Path]:
    """Let no other process follow into these results.

    Parameters
    ----------
    state : str or Path
        Folder of what was read; made if missing.

    Yields
    ------
    Path
        That folder.

    Raises
    ------
    DataError
        If another process follows there, or the folder cannot be written to.
    """
    state = make_folder(state)
    if fcntl is None:  # pragma: no cover - Windows
        yield state
        return
    handle = _locked(state)
    try:
        with suppress(OSError):  # a full disk: the number is for the message alone
            os.truncate(handle, 0)
            os.pwrite(handle, str(os.getpid()).encode(), 0)
        yield state
    finally:
        (state / LOCK).unlink(missing_ok=True)  # before it is free: the next makes its own
        os.close(handle)


def _locked(state: Path) -> int:
    """Open and lock the file; one that another removed meanwhile locks nothing."""
    while True:
        try:
            handle = os.open(state / LOCK, os.O_RDWR | os.O_CREAT, 0o644)
        except OSError as error:
            raise DataError(f"{state}: cannot be written to: {error.strerror}") from None
        try:
            fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            number = os.read(handle, 20).decode("ascii", "replace").strip() or "unknown"
            os.close(handle)
            raise DataError(
                f"{state}: another clpt follows here (process {number}); end it, or give another "
                "--out"
            ) from None
        except OSError:  # a file system without locks
            return handle
        with suppress(OSError):
            if os.path.samestat(os.fstat(handle), os.stat(state / LOCK)):  # noqa: PTH116
                return handle
        os.close(handle)
