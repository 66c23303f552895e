"""Lines and cells of a text table: CSV under a header, with comments.

    # latitude: 41.2
    time,u (m/s),v (m/s)
    2019-01-01T00:00:00Z,0.12,-0.05

Text is UTF-8, with or without a byte order mark; a few stray bytes are let
through, for they stand in comments and notes.  Blank lines and lines that begin
with `#` are left out; of `# NAME: TEXT` or `# NAME = TEXT` the text is kept.
"""

import csv
import re
from pathlib import Path
from typing import NamedTuple

from ..errors import DataError

COMMENT = re.compile(r"#\s*(\w+)\s*[:=]\s*(.+?)\s*")
STRAY = 0.05  # largest share of characters that are no UTF-8 text


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
    try:
        text = Path(path).read_bytes().decode("utf-8-sig", "replace")
    except OSError as error:
        raise DataError(f"{path}: cannot be read: {error.strerror}") from None
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
