"""CSV tables: cells under a header.

    # a comment
    time,latitude,longitude,speed (kn)
    2019-01-01T00:00:00Z,36.70,-122.10,1.9

Blank lines and lines that begin with `#` are left out.
"""

from csv import Error, reader
from pathlib import Path

import pandas

from ...base.errors import DataError

MOST = 10**8  # cells
OTHER_MARKS = {";": "semicolons", "\t": "tabs", "|": "bars"}
SUFFIXES = (".csv", ".txt", ".dat")


def table_of(
    text: str, name: str | Path, must_be: str, mark: str = ","
) -> pandas.DataFrame:
    r"""Return the cells of a table, separated by `mark`, without spaces around them.

    The index is the line in the file, from 1; the columns are the header.  `attrs` has in
    "wrong_lines" the cells of the lines that are left out because they have fewer cells than the
    header, or more, with a sentence.

    >>> cells = table_of("# a comment\n\ntime,u\n0, 1,\n3\n4,5", "mine.csv", "a table")
    >>> list(cells.columns), list(cells.index), cells.values.tolist()
    (['time', 'u'], [4, 6], [['0', '1'], ['4', '5']])
    >>> cells.attrs["wrong_lines"]
    {5: (['3'], 'has 1 cell, the header 2')}
    """
    rows: dict[int, list[str]] = {}
    for k, line in enumerate(map(str.strip, text.splitlines()), 1):
        if line and not line.startswith("#"):
            try:
                row = next(
                    reader([line], delimiter=mark, skipinitialspace=True, strict=True)
                )
            except Error:
                # a quotation mark that is not closed: one cell, of this line alone
                row = [line]
            rows[k] = [cell.strip() for cell in row]
    if not rows:
        raise DataError(f"{name}: is empty. Give {must_be}")
    (_, *lines), (header, *rows_below) = rows, rows.values()
    if len(header) * len(rows_below) > MOST:
        raise DataError(
            f"{name}: has {len(rows_below)} lines of {len(header)} cells. Split it"
        )
    while len(header) > 1 and not header[-1]:  # each line may end with a mark
        header.pop()
    right_lines, wrong_lines = {}, {}
    for line_number, row in zip(lines, rows_below, strict=True):
        while len(row) > len(header) and not row[-1]:
            row.pop()
        if len(row) == len(header):
            right_lines[line_number] = row
        else:
            count = f"{len(row)} cell{'s' if len(row) > 1 else ''}"
            wrong_lines[line_number] = row, f"has {count}, the header {len(header)}"
    cells = pandas.DataFrame(
        list(right_lines.values()), list(right_lines), header, dtype=str
    )
    cells.attrs = {"wrong_lines": wrong_lines}
    return cells


def other_marks(header: str, name: str) -> str:
    """Return what to do where other marks than commas separate columns, else ''.

    `name` is that of a column that must be there.

    >>> other_marks("Time;u (m/s);v (m/s)", "time")
    'columns are separated by semicolons. Use commas, and points in numbers'
    """
    for mark, marks in OTHER_MARKS.items():
        cells = [cell.strip(' "').lower() for cell in header.split(mark)]
        if len(cells) > 1 and name in cells:
            return (
                f"columns are separated by {marks}. Use commas, and points in numbers"
            )
    return ""
