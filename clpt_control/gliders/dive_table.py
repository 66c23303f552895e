"""A plain table of dives, for any vehicle: CSV.

One row per dive under a header.  Required columns: `dive`, `t_gps2`, `lat_gps2`,
`lon_gps2`, `t_gpse`, `lat_gpse`, `lon_gpse` (s since 1970 UTC, degrees),
`dr_east_m`, `dr_north_m` (dead reckoning through the water, m).  Optional:
`t_gps1`, `lat_gps1`, `lon_gps1`, `dac_east`, `dac_north` (m/s), `dac_qc`,
`magvar` (degrees), `depth_max` (m).  Lines that begin with `#` are comments, other columns are
left alone, and the way between the fixes is computed, never read.
"""

from collections.abc import Iterable
from datetime import UTC, datetime
from importlib import resources
from math import isfinite, nan
from pathlib import Path

from ..currents.text_table import other_marks, table_of
from ..errors import DataError
from ..files import write_text
from ..files.reading import read_text
from .dive_faults import NUMBERS, whole_number
from .dives import Dive, Skipped, make_dive

START = ("t_gps2", "lat_gps2", "lon_gps2")
END = ("t_gpse", "lat_gpse", "lon_gpse")
WAY = ("dr_east_m", "dr_north_m")
REQUIRED = ("dive", *START, *END, *WAY)
OPTIONAL = (
    "t_gps1",
    "lat_gps1",
    "lon_gps1",
    "dac_east",
    "dac_north",
    "dac_qc",
    "magvar",
    "depth_max",
)
NO_TEXT = "is neither NetCDF nor text; must be a Seaglider or OG1 file or a CSV table"


def read_dive_table(path: str | Path) -> tuple[list[Dive], list[Skipped]]:
    """Read a CSV table of dives.

    Parameters
    ----------
    path : str or Path
        The file.

    Returns
    -------
    dives : list of Dive
        In the file's order; NaN where a required number is missing.
    skipped : list of Skipped
        Lines that hold no dive.

    Raises
    ------
    DataError
        If the file is missing, empty, no text or lacks required columns.
    """
    return parse_dive_table(read_text(path, NO_TEXT), str(path))


def parse_dive_table(text: str, name: str) -> tuple[list[Dive], list[Skipped]]:
    r"""Read a table of dives from text.

    Parameters
    ----------
    text : str
        The table with its header.
    name : str
        Where it comes from, for messages.

    Returns
    -------
    tuple
        As `read_dive_table`.

    Raises
    ------
    DataError
        If it is empty or lacks required columns.

    Examples
    --------
    >>> header = "dive,t_gps2,lat_gps2,lon_gps2,t_gpse,lat_gpse,lon_gpse,dr_east_m,dr_north_m"
    >>> dives, skipped = parse_dive_table(header + "\n1,0,-43,8,9000,-43,8.1,8000,0", "mine.csv")
    >>> round(dives[0].miss_east), dives[0].magvar, skipped
    (154, None, [])
    """
    cells = table_of(text, name, f"NetCDF or a table with {', '.join(REQUIRED)}").cells
    header = list(cells.columns)
    _check_header(header, name)
    dives: list[Dive] = []
    skipped: list[Skipped] = []
    for line, row in zip(cells.index, cells.to_numpy(), strict=True):
        found = _dive(dict(zip(header, row, strict=True)), f"{name}, line {line}")
        if isinstance(found, Dive):
            dives.append(found)
        else:
            skipped.append(found)
    return dives, skipped


def _check_header(header: list[str], name: str) -> None:
    """Refuse a header without a required column, or with a column twice."""
    line = ",".join(header)
    missing = [column for column in REQUIRED if column not in header]
    marks = other_marks(line, REQUIRED[0])
    if missing and marks:
        raise DataError(f"{name}: {marks}")
    if missing and not set(missing) - {cell.lower() for cell in header}:
        raise DataError(f"{name}: no column {', '.join(missing)} in lower case; write it so")
    if missing == list(REQUIRED):
        raise DataError(
            f"{name}: neither NetCDF nor a table of dives; such a table begins with "
            f"{','.join(REQUIRED)}, this file with {line[:40]!r}"
        )
    if missing:
        raise DataError(f"{name}: no column {', '.join(missing)}; has {', '.join(header)[:300]}")
    double = [column for column in (*REQUIRED, *OPTIONAL) if header.count(column) > 1]
    if double:
        raise DataError(
            f"{name}: the column {', '.join(double)} stands there twice; once is allowed"
        )


def _dive(row: dict[str, str], where: str) -> Dive | Skipped:
    number = whole_number(row.get("dive"))
    if number is None:
        given = repr(row.get("dive", "")[:30])
        return Skipped(None, f"{where}: dive is {given}; must be a whole number below {NUMBERS}")
    notes, found = [], {}
    for column in (*REQUIRED[1:], *OPTIONAL):
        text = (row.get(column) or "").strip()
        value = _number(text)
        if value is None and text and column in (START[0], END[0]):
            return Skipped(number, f"{where}: {column} is {text[:30]!r}; {_in_seconds(text)}")
        if value is None and text:
            notes.append(f"{where}: {column} is {text[:20]!r}, no number")
        elif column in REQUIRED and not text:
            notes.append(f"{where}: {column} is empty")
        if column in REQUIRED:
            found[column] = nan if value is None else value
        else:
            found[column] = value if value is not None and isfinite(value) else None  # type: ignore
    start, end, way = ([found[column] for column in columns] for columns in (START, END, WAY))
    return make_dive(
        number,
        (start[0], start[1], start[2]),
        (end[0], end[1], end[2]),
        (way[0], way[1]),
        **{column: found[column] for column in OPTIONAL},
        notes=tuple(notes),
    )


def _number(text: str | None) -> float | None:
    try:
        return float(text)  # type: ignore[arg-type]
    except (TypeError, ValueError):
        return None


def _in_seconds(text: str) -> str:
    """Say how a time that is no number must be written."""
    try:
        date = datetime.fromisoformat(text)
    except ValueError:
        return "must be seconds since 1970 UTC"
    seconds = (date if date.tzinfo else date.replace(tzinfo=UTC)).timestamp()
    return f"must be seconds since 1970 UTC, which is {seconds:.10g}"


def write_dive_table(dives: Iterable[Dive], path: str | Path, comment: str = "") -> None:
    """Write dives as a CSV table that reads back to the same numbers.

    Parameters
    ----------
    dives : iterable of Dive
        In the order to write.
    path : str or Path
        The file.
    comment : str
        Lines for its head, written behind ``#``.

    Raises
    ------
    DataError
        If the file cannot be written.
    """
    lines = [f"# {line}".rstrip() for line in comment.splitlines()]
    lines.append(",".join((*REQUIRED, "gps_east_m", "gps_north_m", *OPTIONAL)))
    for dive in dives:
        numbers = (
            *(getattr(dive, name) for name in (*START, *END)),
            dive.dr_east,
            dive.dr_north,
            dive.gps_east,
            dive.gps_north,
            *(getattr(dive, name) for name in OPTIONAL),
        )
        cells = ("" if value is None else repr(float(value)) for value in numbers)
        lines.append(",".join((str(dive.number), *cells)))
    write_text(path, "\n".join(lines) + "\n")


def sample_dives() -> list[Dive]:
    """Return the fourteen dives of Seaglider SG542 in the package.

    Returns
    -------
    list of Dive
        Southern Ocean, 31 January to 3 February 2016; without tracks.

    Examples
    --------
    >>> dives = sample_dives()
    >>> len(dives), dives[0].number, round(dives[0].miss_east)
    (14, 304, 1371)
    """
    text = (resources.files("clpt_control.data") / "sg542_dives.csv").read_text("utf-8")
    return parse_dive_table(text, "sg542_dives.csv")[0]
