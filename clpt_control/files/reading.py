"""The one way in: how every file is opened to be read, and read whole where it is text.

A file is opened once, without waiting, and asked through what was opened: it is a regular file of
bounded size, or a pipe that is already open (`/dev/stdin`, or a shell's `<(command)`).  All else is
refused in a sentence.  A library that opens by name (NetCDF) gets a name of what was opened, where
the system has one; Zarr's, which lists a folder itself, gets paths that open so.

Text is UTF-8, with or without a byte order mark; a few stray bytes are let
through, for they stand in comments and notes.
"""

import os
import re
import stat
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from functools import partial
from math import inf
from pathlib import Path
from typing import Any, BinaryIO

from ..errors import DataError, needed

STRAY = 0.05  # largest share of characters that are no UTF-8 text
LARGEST = 2 * 10**8  # bytes of a file that is read whole
OPEN = re.compile(r"/dev/stdin|(/dev|/proc/self)/fd/\d+")  # any other pipe may wait for ever
OPENED = "/proc/self/fd"  # where what a process has opened has names again
NETCDF = (b"CDF\x01", b"CDF\x02", b"CDF\x05", b"\x89HDF")  # first bytes
UTF_16 = (b"\xff\xfe", b"\xfe\xff")  # its byte order marks
NO_FILES = {  # what is none, by the first letter that `ls -l` shows
    **{"d": "a folder", "p": "a pipe with a name", "l": "a link", "s": "a socket"},
    **dict.fromkeys("cb", "a device"),
}


@contextmanager
def opened(
    path: str | Path, most: float = LARGEST, hint: str = "give the name of a file"
) -> Iterator[BinaryIO]:
    """Open a file of at most so many bytes; `hint` ends the sentence where there is none."""
    try:
        with open(path, "rb", opener=at_once) as file:
            _ask(file, path, most)
            yield file
    except FileNotFoundError:
        raise DataError(f"{path}: no such file; {hint}") from None
    except IsADirectoryError:
        raise DataError(f"{path}: is a folder; give a file") from None
    except OSError as error:
        raise DataError(f"{path}: cannot be read: {error.strerror or error}") from None


def _ask(file: BinaryIO, path: str | Path, most: float) -> None:
    """Refuse what was opened where it is no file, nor an open pipe, or is too large."""
    found = os.fstat(file.fileno())
    if stat.S_ISFIFO(found.st_mode) and OPEN.fullmatch(str(path)):
        os.set_blocking(file.fileno(), True)
    elif not stat.S_ISREG(found.st_mode):
        raise DataError(f"{path}: is {kind_of(found.st_mode)}; give a file")
    if found.st_size > most:
        raise DataError(_too_large(path, most))


def at_once(name: str, flags: int, more: int = 0) -> int:
    """Open as `open` asks, but do not wait for who writes into a pipe."""
    return os.open(name, flags | more | getattr(os, "O_NONBLOCK", 0))


def opened_name(number: int, path: str | Path) -> str:
    """Return a name of what was opened, whatever its own means by now; its own elsewhere."""
    return f"{OPENED}/{number}" if os.path.isdir(OPENED) else str(path)  # noqa: PTH112


def _too_large(path: str | Path, most: float) -> str:
    return f"{path}: is larger than {most / 1e6:.0f} MB, the most that is read; split it"


def read_bytes(
    path: str | Path,
    other: tuple[bytes, ...] = (),
    hint: str = "give the name of a file",
    most: int | None = None,
) -> bytes:
    """Read a file or an open pipe, such as ``/dev/stdin``, once; `LARGEST` bytes where no `most`.

    Of a file that begins with one of `other`, 4 bytes each, these are all that is read.
    """
    most = most or LARGEST
    with opened(path, inf if other else most, hint) as file:
        raw = file.read(4)
        if raw not in other:
            raw += file.read(most)
    if len(raw) > most:
        raise DataError(_too_large(path, most))
    return raw


class _Inner(type(Path())):  # type: ignore[misc]
    """A path within a folder, whose file is read by the one way in and is no link."""

    def open(self, mode: str = "r", *how: Any, **more: Any) -> Any:
        """Open the file; to be read, it is asked."""
        if mode != "rb":
            return super().open(mode, *how, **more)
        with ExitStack() as refused:
            opener = partial(at_once, more=getattr(os, "O_NOFOLLOW", 0))
            file = refused.enter_context(open(self, "rb", opener=opener))
            _ask(file, self, inf)
            refused.pop_all()
        return file


def zarr_store(folder: Path, read_only: bool = True) -> Any:
    """Return a folder as Zarr reads it, and writes it unless it is `read_only`.

    Anything in it, at any depth, that is neither a file nor a folder is refused: Zarr would follow
    it elsewhere.
    """
    needed("zarr")
    from zarr.storage import LocalStore

    for place, folders, files in os.walk(folder):
        for name in (*folders, *files):
            mode = os.lstat(path := Path(place, name)).st_mode
            if not (stat.S_ISREG(mode) or stat.S_ISDIR(mode)):
                raise DataError(f"{path}: is {kind_of(mode)}; must be a file of {folder}")
    return LocalStore(_Inner(folder), read_only=read_only)


def kind_of(mode: int) -> str:
    """Return in words what a mode is that is no file's."""
    return NO_FILES.get(stat.filemode(mode)[0], "no file")


def read_text(path: str | Path, no_text: str, most: int | None = None) -> str:
    """Read a file that must be text; `no_text` is said, behind its name, where it is none."""
    return text_of(read_bytes(path, most=most), path, no_text)


def text_of(raw: bytes, path: str | Path, no_text: str) -> str:
    """Return a whole file's bytes as text, those that are no UTF-8 as U+FFFD."""
    if raw.startswith(UTF_16):
        raise DataError(f"{path}: is text in UTF-16; must be in UTF-8: save it so")
    text = raw.decode("utf-8-sig", "replace")
    if "\0" in text or text.count("\ufffd") > STRAY * len(text):
        raise DataError(f"{path}: {no_text}")
    return text
