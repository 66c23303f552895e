"""Lines and cells of a text table: CSV under a header, with comments.

    # latitude: 41.2
    time,u (m/s),v (m/s)
    2019-01-01T00:00:00Z,0.12,-0.05

Text is UTF-8, with or without a byte order mark; a few stray bytes are let
through, for they stand in comments and notes.  Blank lines and lines that begin
with `#` are left out; of `# NAME: TEXT` or `# NAME = TEXT` the text is kept.

A file is read once, so that a pipe that is already open (`/dev/stdin`, or a shell's
`<(command)`) is a table too; other things that are no files are refused.
"""

import csv
import re
import stat
from pathlib import Path
from typing import NamedTuple

from ..errors import DataError

COMMENT = re.compile(r"#\s*(\w+)\s*[:=]\s*(.+?)\s*")
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
OTHER_MARKS = {";": "semicolons", "\t": "tabs", "|": "bars"}


class TextTable(NamedTuple):
    """Lines of a table and what its comments say.

    Attributes
    ----------
    lines : list of tuple
        Number in the file, from 1, and text; the first is the header.
    said : dict of str to str
        Comments by name, in small letters.
    """

    lines: list[tuple[int, str]]
    said: dict[str, str]


def read_bytes(path: str | Path, other: tuple[bytes, ...] = ()) -> bytes:
    """Read a file or an open pipe, once.

    Parameters
    ----------
    path : str or Path
        A file, or a pipe that is open, such as ``/dev/stdin``.
    other : tuple of bytes
        Beginnings, of 4 bytes, of files that are no tables: no more is read.

    Returns
    -------
    bytes
        All of it, or one of `other`.

    Raises
    ------
    DataError
        If it cannot be read, is no file, or is larger than a table may be.
    """
    path = Path(path)
    try:
        mode = path.stat().st_mode
        open_pipe = stat.S_ISFIFO(mode) and str(path).startswith(OPEN)
        if not (stat.S_ISREG(mode) or open_pipe):
            kind = next((kind for test, kind in NO_FILES.items() if test(mode)), "no file")
            raise DataError(f"{path}: is {kind}; give a file")
        with path.open("rb") as file:
            raw = file.read(4)
            if raw not in other:
                raw += file.read(LARGEST)
    except OSError as error:
        raise DataError(f"{path}: cannot be read: {error.strerror}") from None
    if len(raw) > LARGEST:
        raise DataError(
            f"{path}: is larger than {LARGEST // 10**6} MB, the most that a table may be; split it"
        )
    return raw


def read_text(path: str | Path, no_text: str) -> str:
    """Read a file that must be text.

    Parameters
    ----------
    path : str or Path
        The file.
    no_text : str
        What to say, behind its name, of a file that is no text.

    Returns
    -------
    str
        Bytes that are no UTF-8 as U+FFFD.

    Raises
    ------
    DataError
        If the file cannot be read or is no text.
    """
    return text_of(read_bytes(path), path, no_text)


def text_of(raw: bytes, path: str | Path, no_text: str) -> str:
    """Give bytes as text.

    Parameters
    ----------
    raw : bytes
        The whole file.
    path : str or Path
        Its name, for messages.
    no_text : str
        As `read_text`.

    Returns
    -------
    str
        As `read_text`.

    Raises
    ------
    DataError
        If they are no text, or text in another encoding than UTF-8.
    """
    if raw.startswith(UTF_16):
        raise DataError(f"{path}: is text in UTF-16; must be in UTF-8: save it so")
    text = raw.decode("utf-8-sig", "replace")
    if "\0" in text or text.count("\ufffd") > STRAY * len(text):
        raise DataError(f"{path}: {no_text}")
    return text


def lines_of(text: str) -> TextTable:
    r"""Give the lines of a table, comments apart.

    Parameters
    ----------
    text : str
        The whole table.

    Returns
    -------
    TextTable
        Without lines where there is nothing else.

    Examples
    --------
    >>> lines_of("# latitude: 41.2\n\ntime,u,v\n0,1,2")
    TextTable(lines=[(3, 'time,u,v'), (4, '0,1,2')], said={'latitude': '41.2'})
    """
    lines, said = [], {}
    for number, line in enumerate(text.splitlines(), 1):
        bare = line.strip()
        if bare.startswith("#"):
            if found := COMMENT.fullmatch(bare):
                said[found[1].lower()] = found[2]
        elif bare:
            lines.append((number, line))
    return TextTable(lines, said)


def cells_of(line: str) -> list[str]:
    """Give the cells of a line, none where it is no CSV.

    Parameters
    ----------
    line : str
        Without its end.

    Returns
    -------
    list of str
        Quotes taken off, spaces kept.

    Examples
    --------
    >>> cells_of('7,"a, b", 2')
    ['7', 'a, b', ' 2']
    """
    try:
        return next(csv.reader([line]), [])
    except csv.Error:  # a cell of more than 128 KiB
        return []


def other_marks(header: str, name: str) -> str:
    """Say what parts the cells of a header, if not commas.

    Parameters
    ----------
    header : str
        The first line.
    name : str
        Of a column that must be there.

    Returns
    -------
    str
        What to do about it; empty where commas part them, or it is no header.

    Examples
    --------
    >>> other_marks("Time;u (m/s);v (m/s)", "time")
    'semicolons part its cells; use commas, and points in numbers'
    >>> other_marks("time,u (m/s),v (m/s)", "time")
    ''
    """
    for mark, marks in OTHER_MARKS.items():
        cells = [cell.strip(' "').lower() for cell in header.split(mark)]
        if len(cells) > 1 and name in cells:
            return f"{marks} part its cells; use commas, and points in numbers"
    return ""
