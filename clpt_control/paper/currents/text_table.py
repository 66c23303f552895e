"""CSV tables: cells under a header with comments, and a current at one place.

    # latitude: 41.2
    time,u (m/s),v (m/s)
    2019-01-01T00:00:00Z,0.12,-0.05

Blank lines and lines that begin with `#` are left out; of `# NAME: TEXT` or
`# NAME = TEXT` the text is read.

A current at one place is such a table:

    # latitude: 41.2
    time,u (cm/s),v (cm/s)
    2019-01-01T00:00:00Z,12.3,-4.5
    2019-01-01T01:00:00Z,,

Columns `time`, `u` (to the east) and `v` (to the north), in any order, others
are left alone; in place of u and v `speed` and `direction`, the one to which it flows, degrees
from true north.  Units stand behind the names, in () or [], or for both in a
comment `# units: cm/s`; a table without units is refused.  Times are ISO 8601, UTC unless they
say.  An empty cell or nan is a gap.
Lines that begin with `#` are comments; `# latitude: DEG` is read.
"""

import re
from collections.abc import Hashable
from csv import Error, reader
from pathlib import Path
from typing import Any

import numpy as np
import pandas
import xarray

from ...base.errors import DataError, naming
from ...base.files.reading import read_text
from ...base.units import number
from .cf import VELOCITY
from .constituents import checked_times
from .flags import without_flagged
from .valid_values import check_fill_value, speed_unit

COMMENT = re.compile(r"#\s*(\w+)\s*[:=](.*)")
MOST = 10**8  # cells
OTHER_MARKS = {";": "semicolons", "\t": "tabs", "|": "bars"}
NAMES = {
    "time": ("time", "date", "datetime"),
    "u": VELOCITY["eastward"][1],
    "v": VELOCITY["northward"][1],
}
POLAR = {
    "time": NAMES["time"],
    "speed": ("speed", "current_speed", "velocity", "spd", "magnitude", "mag"),
    "direction": ("direction", "current_direction", "dir", "heading"),
}
SUFFIXES = (".csv", ".txt", ".dat")
UTC = re.compile(r"(iso ?8601|y{4}[-ymdhst:.z/ ]*)?[, ]*(utc|gmt|z)?", re.IGNORECASE)
# without spaces: they would be tried
HEADER = re.compile(r"([^([]*)(?:[(\[]([^)\]]*)[)\]])?")


def table_of(
    text: str, name: str | Path, must_be: str, mark: str = ","
) -> pandas.DataFrame:
    r"""Return the cells of a table, separated by `mark`, without spaces around them.

    The index is the line in the file, from 1; the columns are the header.  `attrs` has the texts of
    comments, by name in small letters, and in "wrong_lines" the cells of the lines that are left
    out because they have fewer cells than the header, or more, with a sentence.

    >>> cells = table_of("# latitude: 41.2\n\ntime,u\n0, 1,\n3\n4,5", "mine.csv", "a table")
    >>> cells.attrs["latitude"], list(cells.columns), list(cells.index), cells.values.tolist()
    ('41.2', ['time', 'u'], [4, 6], [['0', '1'], ['4', '5']])
    >>> cells.attrs["wrong_lines"]
    {5: (['3'], 'has 1 cell, the header 2')}
    """
    comments: dict[Hashable, Any] = {}
    rows: dict[int, list[str]] = {}
    for k, line in enumerate(map(str.strip, text.splitlines()), 1):
        comment = COMMENT.fullmatch(line)
        if comment and comment[2].strip():
            comments[comment[1].lower()] = comment[2].strip()
        elif line and not line.startswith("#"):
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
    cells.attrs = comments | {"wrong_lines": wrong_lines}
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


def is_table(path: Path) -> bool:
    """Return whether a file is named as a table is.

    Examples
    --------
    >>> is_table(Path("mooring.csv")), is_table(Path("mooring.nc"))
    (True, False)
    """
    return path.suffix.lower() in SUFFIXES


def read_table(
    path: Path, units: str | None, notes: list[str]
) -> tuple[np.ndarray, np.ndarray, np.ndarray, float | None]:
    """Return times (datetime64[ms], UTC), u, v (m/s, NaN in gaps) and latitude of a table.

    Rows stay in the file's order; the latitude, degrees north, is that of the comment or None.
    Values that a column such as u_qc flags as bad are gaps, which the notes count.
    """
    text = read_text(
        path, "is not text; must be a table of time, u and v, or NetCDF (.nc)"
    )
    cells = table_of(text, path, "a table of time, u and v")
    for line, (_, why) in cells.attrs["wrong_lines"].items():
        raise DataError(f"{path}, line {line}: {why}. Leave gaps as empty cells")
    cells = _with_units_of_second_row(cells)
    header, comments = list(cells.columns), cells.attrs
    stated = {_name_and_unit(cell)[0] for cell in header}
    polar = bool(stated & set(POLAR["speed"])) and not stated & set(NAMES["u"])
    allowed_names = POLAR if polar else NAMES
    with naming(path):
        columns = _header(header, comments.get("units"), units, allowed_names)
        if cells.empty:
            raise DataError(
                "has a header and no rows; must be a table of time, u and v"
            )
    time_column = columns.pop("time")[0]
    times = _times(cells.iloc[:, time_column], path)
    u, v = (
        size * _numbers(cells.iloc[:, k], name, path)
        for name, (k, size) in columns.items()
    )
    names = [_name_and_unit(cell)[0] for cell in header]
    rows = xarray.Dataset(
        {name: ("row", cells.iloc[:, k].to_numpy(str)) for k, name in enumerate(names)}
    )
    for (k, _), values in zip(columns.values(), (u, v), strict=True):
        numbers = rows.assign({names[k]: ("row", values)})
        values[:], flagged = without_flagged(numbers, [names[k], names[time_column]])
        notes += flagged
    with naming(path):
        if polar:
            _check_polar(u, v)
        for name, values in zip(columns, (u, v), strict=True):
            unit = "degrees" if name == "direction" else "m/s"
            check_fill_value(values, f"{name} ({unit})")
    if polar:
        u, v = u * np.sin(np.radians(v)), u * np.cos(np.radians(v))
    latitude = number(comments["latitude"]) if "latitude" in comments else None
    return times, u, v, latitude


def _with_units_of_second_row(cells: pandas.DataFrame) -> pandas.DataFrame:
    """Return a table with the units of ERDDAP's second row in its header."""
    header = list(cells.columns)
    times = [k for k, name in enumerate(header) if name.lower() in NAMES["time"]]
    if not (len(cells) and times):
        return cells
    units = cells.iloc[0].tolist()
    if not (units[times[0]] and UTC.fullmatch(units[times[0]])):
        return cells
    named = [
        f"{name} ({unit})" if unit else name
        for name, unit in zip(header, units, strict=True)
    ]
    return cells.iloc[1:].set_axis(named, axis=1)


def _check_polar(speed: np.ndarray, direction: np.ndarray) -> None:
    """Refuse negative speeds, and directions that are no angles."""
    if (speed < 0).any():
        raise DataError(
            f"speed reaches {np.nanmin(speed):.4g} m/s; must be 0 or more. Leave gaps empty"
        )
    wrong = direction[(direction < -180) | (direction > 360)]
    if wrong.size:
        raise DataError(
            f"direction reaches {wrong[0]:.4g}; must be -180 to 360 degrees. Leave gaps empty"
        )


def _name_and_unit(cell: str) -> tuple[str, str | None]:
    """Return the name in small letters and the unit of a cell of the header."""
    matched = HEADER.fullmatch(cell)
    if matched is None:
        return "", None
    return matched[1].strip().lower(), matched[2] and matched[2].strip()


def _header(
    header: list[str],
    comment: str | None,
    units: str | None,
    allowed_names: dict[str, tuple[str, ...]],
) -> dict[str, tuple[int, float]]:
    """Return the columns of time and flow, and what one unit of each is in s, m/s or degrees."""
    names, stated = zip(*map(_name_and_unit, header), strict=True)
    columns = {}
    for column, allowed in allowed_names.items():
        matches = [k for k, name in enumerate(names) if name in allowed]
        if not matches and (marks := other_marks(",".join(header), NAMES["time"][0])):
            raise DataError(marks)
        if len(matches) != 1:
            count, beginning = (
                "more than one" if matches else "no",
                ",".join(header)[:60],
            )
            raise DataError(
                f"{count} column {column}; must begin as 'time,u,v', not {beginning!r}"
            )
        unit = stated[matches[0]]
        if column == "direction" and unit and not unit.lower().startswith(("deg", "°")):
            raise DataError(
                f"direction is in '{unit}'; must be in degrees from true north"
            )
        if column == "time" and unit and not UTC.fullmatch(unit):
            raise DataError(f"time is in '{unit}'; must be in UTC")
        if column in ("time", "direction"):
            columns[column] = matches[0], 1.0
            continue
        cure = "Write them behind the name, as in 'u (m/s)'"
        columns[column] = matches[0], speed_unit(unit or comment, units, column, cure)
    return columns


def _times(cells: pandas.Series, path: Path) -> np.ndarray:
    """Return times of ISO 8601 as datetime64 in ms."""
    dates = pandas.to_datetime(cells, utc=True, format="ISO8601", errors="coerce")
    _refuse(dates.isna(), cells, "time", "such as 2019-01-01T06:00:00Z", path)
    with naming(path):
        return checked_times(dates.dt.tz_localize(None).dt.round("ms"))


def _numbers(cells: pandas.Series, column: str, path: Path) -> np.ndarray:
    """Return a column's numbers, NaN in gaps."""
    numbers = pandas.to_numeric(cells, errors="coerce")
    wrong = numbers.isna() & ~cells.str.lower().isin(("", "nan"))
    _refuse(wrong, cells, column, "a number; a gap is an empty cell or nan", path)
    return numbers.to_numpy(float)


def _refuse(
    wrong: pandas.Series, cells: pandas.Series, column: str, must_be: str, path: Path
) -> None:
    """Raise an error that names the first line with a wrong cell."""
    if wrong.any():
        line = wrong.idxmax()
        raise DataError(
            f"{path}, line {line}: {column} is {cells[line][:30]!r}; must be {must_be}"
        )
