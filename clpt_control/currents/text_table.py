"""Lines and cells of a text table: CSV under a header, with comments.

    # latitude: 41.2
    time,u (m/s),v (m/s)
    2019-01-01T00:00:00Z,0.12,-0.05

Blank lines and lines that begin with `#` are left out; of `# NAME: TEXT` or
`# NAME = TEXT` the text is kept.
"""

import csv
import re
from typing import NamedTuple

COMMENT = re.compile(r"#\s*(\w+)\s*[:=]\s*(.+?)\s*")
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


def lines_of(text: str) -> TextTable:
    r"""Return the lines of a table, comments apart.

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
    """Return the cells of a line, none where it is no CSV.

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
