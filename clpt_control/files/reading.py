"""Files of text: read whole, once, in bounded time and memory.

Text is UTF-8, with or without a byte order mark; a few stray bytes are let
through, for they stand in comments and notes.

A file is read once, so that a pipe that is already open (`/dev/stdin`, or a shell's
`<(command)`) is text too; other things that are no files are refused.
"""

import stat
from pathlib import Path

from ..errors import DataError

STRAY = 0.05  # largest share of characters that are no UTF-8 text
LARGEST = 2 * 10**8  # bytes of a table
OPEN = ("/dev/stdin", "/dev/fd/", "/proc/self/fd/")  # a pipe with another name may wait forever
UTF_16 = (b"\xff\xfe", b"\xfe\xff")  # its byte order marks
NO_FILES = {
    stat.S_ISDIR: "a folder",
    stat.S_ISFIFO: "a pipe with a name",
    stat.S_ISCHR: "a device",
    stat.S_ISBLK: "a device",
    stat.S_ISSOCK: "a socket",
}


def read_bytes(path: str | Path, other: tuple[bytes, ...] = ()) -> bytes:
    """Read a file or an open pipe, such as ``/dev/stdin``, once.

    Of a file that begins with one of `other`, 4 bytes each, these are all that is read.
    """
    path = Path(path)
    try:
        mode = path.stat().st_mode
        open_pipe = stat.S_ISFIFO(mode) and str(path).startswith(OPEN)
        if not (stat.S_ISREG(mode) or open_pipe):
            raise DataError(f"{path}: is {kind_of(mode)}; give a file")
        with path.open("rb") as file:
            raw = file.read(4)
            if raw not in other:
                raw += file.read(LARGEST)
    except OSError as error:
        raise DataError(f"{path}: cannot be read: {error.strerror}") from None
    if len(raw) > LARGEST:
        raise DataError(
            f"{path}: is larger than {LARGEST // 10**6} MB, the most that text may be; split it"
        )
    return raw


def kind_of(mode: int) -> str:
    """Return in words what a mode is that is no file's."""
    return next((kind for test, kind in NO_FILES.items() if test(mode)), "no file")


def read_text(path: str | Path, no_text: str) -> str:
    """Read a file that must be text; `no_text` is said, behind its name, where it is none."""
    return text_of(read_bytes(path), path, no_text)


def text_of(raw: bytes, path: str | Path, no_text: str) -> str:
    """Return a whole file's bytes as text, those that are no UTF-8 as U+FFFD."""
    if raw.startswith(UTF_16):
        raise DataError(f"{path}: is text in UTF-16; must be in UTF-8: save it so")
    text = raw.decode("utf-8-sig", "replace")
    if "\0" in text or text.count("\ufffd") > STRAY * len(text):
        raise DataError(f"{path}: {no_text}")
    return text
