"""A plain table of a current at one place: CSV.

    # latitude: 41.2
    time,u (cm/s),v (cm/s)
    2019-01-01T00:00:00Z,12.3,-4.5
    2019-01-01T01:00:00Z,,

Columns `time`, `u` (to the east) and `v` (to the north), in any order, others
are left alone.  Units stand behind the names, in () or [], or for both in a
comment `# units: cm/s`; a table without units is refused.  Times are ISO 8601
(UTC unless they say) or seconds since 1970 UTC.  An empty cell or nan is a gap.
Lines that begin with `#` are comments; `# latitude: DEG` is read.
"""

import re
from datetime import UTC, datetime
from math import isfinite, nan
from pathlib import Path

import numpy as np

from ...errors import DataError
from ...files.reading import read_text
from ...units import speed_in_metres_per_second
from ..cf import VELOCITY
from ..nodal import checked_times
from ..text_table import cells_of, lines_of, other_marks

NAMES = {
    "time": ("time", "date", "datetime"),
    "u": VELOCITY["eastward"][1],
    "v": VELOCITY["northward"][1],
}
SUFFIXES = (".csv", ".txt", ".dat")
HEADER = re.compile(r"\s*([^([]*?)\s*(?:[(\[]\s*([^)\]]*?)\s*[)\]])?\s*")


def is_table(path: Path) -> bool:
    """Return whether a file is named as a table is.

    Examples
    --------
    >>> is_table(Path("mooring.csv")), is_table(Path("mooring.nc"))
    (True, False)
    """
    return path.suffix.lower() in SUFFIXES


def read_table(path: Path) -> tuple[np.ndarray, np.ndarray, np.ndarray, float | None]:
    """Read a table of a current.

    Parameters
    ----------
    path : Path
        The file.

    Returns
    -------
    time : ndarray of datetime64[ms], shape (n,)
        UTC, in the file's order.
    u, v : ndarray, shape (n,)
        m/s, NaN in gaps.
    latitude : float or None
        Degrees north, of the comment.

    Raises
    ------
    DataError
        If the file is missing, empty, no such table, or a cell is no number.
    """
    text = read_text(path, "is no text; must be a table of time, u and v, or NetCDF (.nc)")
    lines, said = lines_of(text)
    if not lines:
        raise DataError(f"{path}: is empty; must be a table of time, u and v")
    columns, sizes = _header(lines[0][1], said.get("units"), path)
    table: list[list[float]] = []
    for number, line in lines[1:]:
        where = f"{path}, line {number}"
        cells = cells_of(line)
        cells += [""] * (1 + max(columns) - len(cells))
        time, *flow = (cells[k].strip() for k in columns)
        table.append([_seconds(time, where), *(_value(cell, where) for cell in flow)])
    if not table:
        raise DataError(f"{path}: has a header and no rows; must be a table of time, u and v")
    seconds, u, v = np.array(table).T
    try:
        times = checked_times(np.round(1000 * seconds).astype("datetime64[ms]"))
    except DataError as error:
        raise DataError(f"{path}: {error}") from None
    latitude = None
    if "latitude" in said:
        latitude = _value(said["latitude"].split()[0], f"{path}: the comment latitude")
    return times, u * sizes[0], v * sizes[1], latitude


def _header(line: str, units: str | None, path: Path) -> tuple[list[int], list[float]]:
    """Return the columns of time, u and v, and what one unit of u and v is in m/s."""
    cells = [HEADER.fullmatch(cell) for cell in cells_of(line)]
    names = [cell[1].lower() if cell else "" for cell in cells]
    columns, sizes = [], []
    for what, allowed in NAMES.items():
        found = [k for k, name in enumerate(names) if name in allowed]
        if not found and (marks := other_marks(line, NAMES["time"][0])):
            raise DataError(f"{path}: {marks}")
        if len(found) != 1:
            raise DataError(
                f"{path}: {'no column' if not found else 'more than one column'} {what}; the table "
                f"must begin with a line such as 'time,u (m/s),v (m/s)', this one does with "
                f"{line.strip()[:60]!r}"
            )
        columns.append(found[0])
        if what == "time":
            continue
        cell = cells[found[0]]
        unit = (cell[2] if cell else None) or units
        if unit is None:
            raise DataError(
                f"{path}: {what} has no units; write them behind the name, such as 'u (m/s)', or "
                "in a line '# units: m/s'"
            )
        sizes.append(speed_in_metres_per_second(unit, f"{path}: {what}"))
    return columns, sizes


def _seconds(text: str, where: str) -> float:
    """Return seconds since 1970 UTC."""
    try:
        seconds = float(text)
    except ValueError:
        try:
            date = datetime.fromisoformat(text)
        except ValueError:
            raise DataError(
                f"{where}: time is {text[:30]!r}; must be such as 2019-01-01T06:00:00Z, or seconds "
                "since 1970"
            ) from None
        return (date if date.tzinfo else date.replace(tzinfo=UTC)).timestamp()
    if not (isfinite(seconds) and abs(seconds) < 1e11):
        raise DataError(f"{where}: time is {text[:30]!r} s; must be seconds since 1970")
    return seconds


def _value(text: str, where: str) -> float:
    try:
        return float(text) if text else nan
    except ValueError:
        raise DataError(
            f"{where}: {text[:20]!r} is no number; a gap is an empty cell or nan"
        ) from None
