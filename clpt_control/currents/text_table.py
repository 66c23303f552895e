"""Cells of a CSV table under a header, with comments, by pandas.

    # latitude: 41.2
    time,u (m/s),v (m/s)
    2019-01-01T00:00:00Z,0.12,-0.05

Blank lines and lines that begin with `#` are left out; of `# NAME: TEXT` or
`# NAME = TEXT` the text is kept.
"""

import re
from io import StringIO
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from ..errors import DataError

if TYPE_CHECKING:
    import pandas

COMMENT = re.compile(r"#\s*(\w+)\s*[:=]\s*(.+?)\s*")
OPENS = re.compile(r'(^|,)\s*"')  # a quoted cell
OTHER_MARKS = {";": "semicolons", "\t": "tabs", "|": "bars"}


class TextTable(NamedTuple):
    """Cells as text, and what comments say, by name in small letters.

    The index of `cells` is the line in the file, from 1; its columns are the header.
    """

    cells: "pandas.DataFrame"
    said: dict[str, str]


def table_of(text: str, name: str | Path, must_be: str) -> TextTable:
    r"""Return the cells of a table, without spaces about them, '' where a line is too short.

    >>> cells, said = table_of("# latitude: 41.2\n\ntime,u\n0, 1,2\n3", "mine.csv", "a table")
    >>> said, list(cells.columns), list(cells.index), cells.values.tolist()
    ({'latitude': '41.2'}, ['time', 'u'], [4, 5], [['0', '1'], ['3', '']])
    """
    from pandas import read_csv
    from pandas.errors import ParserError

    lines, said = text.splitlines(), {}
    for k, line in enumerate(lines):
        if line.lstrip().startswith("#"):
            if found := COMMENT.fullmatch(line.strip()):
                said[found[1].lower()] = found[2]
            lines[k] = ""
        elif line.count('"') % 2 and OPENS.search(line):  # it would join the next: one cell
            lines[k] = '"' + line.replace('"', "'") + '"'
    filled = [k for k, line in enumerate(lines, 1) if line.strip()]
    if not filled:
        raise DataError(f"{name}: is empty; must be {must_be}")
    commas = lines[filled[0] - 1].count(",")
    width = range(commas + 1)
    lines.append("-" + "," * commas)  # one line at least is as wide as the header
    try:
        cells = read_csv(
            StringIO("\n".join(lines)),
            header=None,
            names=width,
            usecols=width,
            dtype=str,
            na_filter=False,
            skip_blank_lines=False,
            skipinitialspace=True,
        )
    except ParserError as error:
        raise DataError(f"{name}: cannot be read as CSV: {error}") from None
    if len(cells) != len(lines):
        raise DataError(f"{name}: a quotation mark joins two lines; take it out")
    cells.index += 1
    cells = cells.loc[filled].apply(lambda column: column.str.strip())
    return TextTable(cells.iloc[1:].set_axis(list(cells.iloc[0]), axis=1), said)


def other_marks(header: str, name: str) -> str:
    """Return what to do where other marks than commas separate columns, else ''.

    `name` is that of a column that must be there.

    >>> other_marks("Time;u (m/s);v (m/s)", "time")
    'columns are separated by semicolons; use commas, and points in numbers'
    """
    for mark, marks in OTHER_MARKS.items():
        cells = [cell.strip(' "').lower() for cell in header.split(mark)]
        if len(cells) > 1 and name in cells:
            return f"columns are separated by {marks}; use commas, and points in numbers"
    return ""
