"""CSV tables: cells under a header, separated by commas, semicolons, tabs or bars.

    # a comment
    time,latitude,longitude,speed (kn)
    2019-01-01T00:00:00Z,36.70,-122.10,1.9

Blank lines, lines that begin with `#`, and the line `sep=;` of a spreadsheet are left out.
Where commas do not separate cells, they are decimal commas.
"""

import re
from csv import Error, reader
from pathlib import Path

import pandas

from ...base.errors import DataError

MOST = 10**8  # cells
MARKS = ",;\t|"
ROW = re.compile(r'\s*(?!#|"?sep=)\S', re.IGNORECASE)
SUFFIXES = (".csv", ".txt", ".dat")


def header_of(text: str) -> tuple[list[str], str]:
    """Return the cells of the header, and the mark between cells: the most frequent one in it."""
    header = next(filter(ROW.match, text.splitlines()), "")
    mark = max(MARKS, key=header.count)
    return header.split(mark), mark


def table_of(text: str, name: Path, must_be: str) -> pandas.DataFrame:
    r"""Return the cells of a table, without spaces around them, with points in numbers.

    The index is the line in the file, from 1; the columns are the header.  `attrs` has in
    "wrong_lines" the cells of the lines that are left out because they have fewer cells than the
    header, or more, with a sentence.

    >>> cells = table_of("# a comment\n\ntime,u\n0, 1,\n3\n4,5", "mine.csv", "a table")
    >>> list(cells.columns), list(cells.index), cells.values.tolist()
    (['time', 'u'], [4, 6], [['0', '1'], ['4', '5']])
    >>> cells.attrs["wrong_lines"]
    {5: (['3'], 'has 1 cell, the header 2')}
    """
    _, mark = header_of(text)
    decimal = "." if mark == "," else ","
    rows = {}
    for k, line in enumerate(text.splitlines(), 1):
        if ROW.match(line):
            try:
                row = next(
                    reader([line], delimiter=mark, skipinitialspace=True, strict=True)
                )
            except Error:
                # a quotation mark that is not closed: one cell, of this line alone
                row = [line]
            rows[k] = [cell.strip().replace(decimal, ".") for cell in row]
    if not rows:
        raise DataError(f"{name}: is empty. Give {must_be}")
    (_, *lines), (header, *rows_below) = rows, rows.values()
    if len(header) * len(rows_below) > MOST:
        raise DataError(
            f"{name}: has {len(rows_below)} lines of {len(header)} cells. Split it"
        )
    while len(header) > 1 and not header[-1]:  # each line may end with a mark
        header.pop()
    right_lines = {}
    wrong_lines = {}
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
