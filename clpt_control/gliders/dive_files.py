"""Files of dives, told apart by what is in them, and the plain table of dives, for any vehicle.

Each path is a file or a folder of files; a file is of one of the dialects
below, found by its content.  A damaged file among good ones is left out with its
reason and the good dives are used; what was named and does not exist is an error.

A dialect is a module with two functions: `is_known(content)`, and `dives_of(content)`, which
returns its dives and what holds none, with the path where a dialect
asks its name.  The content is an open xarray.Dataset or a text.  A further format is a module and
its place in `read_dive_file`.

A text that is of no dialect is a plain table of dives, CSV: one row per dive under a header.
Required columns: `dive`, `t_gps2`, `lat_gps2`, `lon_gps2`, `t_gpse`, `lat_gpse`, `lon_gpse` (s
since 1970 UTC or ISO 8601, degrees) and `dr_east_m`, `dr_north_m` (dead reckoning through the
water, m) or `dac_east`, `dac_north` (the vehicle's own depth-averaged current c, m/s), of which
dead reckoning is computed,

    dr = (displacement between the fixes) - c (t_gpse - t_gps2).

Optional: `t_gps1`, `lat_gps1`, `lon_gps1`, `dac_east`, `dac_north`, `dac_qc`,
`magvar` (degrees), `depth_max` (m), `next_course` (plan of the next dive, degrees from true north),
`vehicle` (its name).  Lines that begin with `#` are
comments, other columns are left alone, and the displacement between the fixes is computed,
never read.
"""

import re
from collections.abc import Iterable, Sequence
from dataclasses import replace
from importlib import resources
from math import isfinite, nan
from pathlib import Path
from stat import S_ISDIR
from typing import Any

from ..arguments import public
from ..currents.text_table import other_marks, table_of
from ..errors import DataError, naming
from ..estimation.dive import Dive, make_dive, without_current
from ..files import write_file
from ..files.reading import NETCDF, open_netcdf, read_bytes
from ..progress.interrupt import check
from ..units import seconds_since_1970
from . import og1, seaexplorer, seaglider, slocum
from .dives import NUMBERS, SLOCUM_FILES, Skipped, in_order, is_segment, whole_number

START = ("t_gps2", "lat_gps2", "lon_gps2")
END = ("t_gpse", "lat_gpse", "lon_gpse")
THROUGH_WATER = ("dr_east_m", "dr_north_m")
CURRENT = ("dac_east", "dac_north")
REQUIRED = ("dive", *START, *END, *THROUGH_WATER)
AS_TIME = "must be seconds since 1970 UTC, or a date such as 2016-01-31T22:04:50Z"
OTHERWISE = "; dac_east, dac_north (m/s), the vehicle's own current, may stand instead"
GPS1 = ("t_gps1", "lat_gps1", "lon_gps1")
TIMES = (GPS1[0], START[0], END[0])
OPTIONAL = (*GPS1, *CURRENT, "dac_qc", "magvar", "depth_max", "next_course")

LONGEST = 40  # letters; a longer one is no name
FILES = (
    re.compile(r"(.+?)-\d{4}-\d+-\d+-\d+"),  # of a Slocum: rosie_713-2019-166-0-156
    re.compile(r"(sea\d+)\.\d+\.", re.IGNORECASE),  # of a SeaExplorer: sea035.10.gli.sub.12.gz
)
DATED = re.compile(r"(.+?)_\d{8}")  # SG015_20040929T140907_delayed


def table_dives(text: str, path: str | Path) -> list[Dive | Skipped]:
    r"""Return the dives of a table, NaN where a number is missing, and lines that hold none.

    >>> header = "dive,t_gps2,lat_gps2,lon_gps2,t_gpse,lat_gpse,lon_gpse,dr_east_m,dr_north_m"
    >>> (dive,) = table_dives(header + "\n1,0,-43,8,9000,-43,8.1,8000,0", "mine.csv")
    >>> round(dive.miss_east), dive.magvar
    (154, None)
    """
    cells = table_of(text, path, f"NetCDF or a table with {', '.join(REQUIRED)}")
    header = list(cells.columns)
    _check_header(header, path)
    return [
        _dive(dict(zip(header, row, strict=True)), f"{path}, line {line}")
        for line, row in zip(cells.index, cells.to_numpy(), strict=True)
    ]


def _check_header(header: list[str], name: str | Path) -> None:
    """Refuse a header without a required column, or with a column twice."""
    line = ",".join(header)
    missing = [column for column in REQUIRED if column not in header]
    if set(CURRENT) <= set(header) and not {cell.lower() for cell in header} & set(THROUGH_WATER):
        missing = [column for column in missing if column not in THROUGH_WATER]
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
        raise DataError(
            f"{name}: no column {', '.join(missing)}; has {', '.join(header)[:300]}"
            f"{OTHERWISE if set(missing) & set(THROUGH_WATER) else ''}"
        )
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
    notes: list[str] = []
    found: dict[str, Any] = {}
    for column in (*REQUIRED[1:], *OPTIONAL):
        text = row.get(column, "")
        value = _time(text) if column in TIMES else _number(text)
        if value is None and text:
            if column in (START[0], END[0]):
                return Skipped(number, f"{where}: {column} is {text[:30]!r}; {AS_TIME}")
            notes.append(f"{where}: {column} is {text[:20]!r}, no number")
        elif column in REQUIRED and not text and column in row:
            notes.append(f"{where}: {column} is empty")
        missing = nan if column in REQUIRED else None
        known = value is not None and (column in REQUIRED or isfinite(value))
        found[column] = value if known else missing
    start, end, through_water = (
        tuple(found[column] for column in columns) for columns in (START, END, THROUGH_WATER)
    )
    if not set(THROUGH_WATER) & set(row):
        current = found["dac_east"], found["dac_north"]
        if None in current:
            through_water = nan, nan
            notes.append("dac_east or dac_north is no number, and there is no dead reckoning")
        else:
            through_water = without_current(start, end, current)
            notes.append("dead reckoning computed from dac_east, dac_north")
    return make_dive(
        number,
        start,
        end,
        through_water,
        **{column: found[column] for column in OPTIONAL},
        vehicle=name_of(row.get("vehicle")),
        notes=tuple(notes),
    )


def _number(text: str) -> float | None:
    try:
        return float(text)
    except ValueError:
        return None


def _time(text: str) -> float | None:
    """Return s since 1970 UTC of a number of them or a date of ISO 8601, or None."""
    number = _number(text)
    if number is None and text:
        try:
            return seconds_since_1970(text)
        except ValueError:
            return None
    return number


@public
def write_dive_table(dives: Iterable[Dive], path: str | Path, comment: str = "") -> None:
    """Write dives as a CSV table that reads back bit for bit.

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

    Examples
    --------
    >>> from tempfile import TemporaryDirectory
    >>> from clpt_control.gliders import read_dives
    >>> with TemporaryDirectory() as folder:
    ...     write_dive_table(sample_dives(), f"{folder}/dives.csv", "fourteen dives of SG542")
    ...     read_dives(folder)[0] == sample_dives()
    True
    """
    lines = [f"# {line}".rstrip() for line in comment.splitlines()]
    lines.append(",".join((*REQUIRED, "gps_east_m", "gps_north_m", *OPTIONAL)))
    columns = (*START, *END, "dr_east", "dr_north", "gps_east", "gps_north", *OPTIONAL)
    for dive in dives:
        numbers = (getattr(dive, column) for column in columns)
        cells = ("" if value is None else repr(float(value)) for value in numbers)
        lines.append(",".join((str(dive.number), *cells)))
    write_file(path, "\n".join(lines) + "\n")


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
    return _told_apart(table_dives(text, "sg542_dives.csv"), "SG542", "Seaglider")[0]


MOST_BYTES = 4 * 10**9  # of memory that the dives of a file may take
KINDS = (
    "Seaglider or OG1 NetCDF files, .sbd, .mbd or .dbd of a Slocum, .gli of a SeaExplorer, "
    "a CSV table of dives"
)
SUFFIXES = (".nc", ".csv", *SLOCUM_FILES)
FROM_GLIDER = "from-glider"  # where a dockserver keeps what a glider sent


def may_hold_dives(path: Path) -> bool:
    """Whether a name in a folder is that of a file of dives; hidden ones are not."""
    named = path.suffix.lower() in SUFFIXES or is_segment(path)
    return named and not path.name.startswith(".")


def dive_paths(paths: Iterable[str | Path]) -> list[Path]:
    """Return the files that paths name; those of a folder by name, hidden ones left out.

    Of a glider's folder on a dockserver they are those in ``from-glider``.
    """
    files: list[Path] = []
    for path in map(Path, paths):
        try:
            inside = list(path.iterdir()) if S_ISDIR(path.stat().st_mode) else None
        except (FileNotFoundError, NotADirectoryError):
            raise DataError(f"{path}: no such file; give {KINDS}, or a folder of them") from None
        except OSError as error:
            raise DataError(f"{path}: cannot be read: {error.strerror}") from None
        if inside is None:
            files.append(path)
            continue
        dives = [file for file in inside if may_hold_dives(file)]
        if not dives and (sent := [file for file in inside if file.name.lower() == FROM_GLIDER]):
            dives = dive_paths(sent)
        if not dives:
            raise DataError(f"{path}: the folder has no {', '.join(SUFFIXES)} or .gli file")
        files += sorted(dives, key=in_order)
    return files


def read_dive_file(path: str | Path) -> tuple[list[Dive], list[Skipped]]:
    """Read a file of any dialect: its dives, and lines of a text that hold none.

    A text may be a pipe that is open.
    """
    path = Path(path)
    raw = read_bytes(path, (*NETCDF, slocum.MAGIC))
    if not raw:
        raise DataError(f"{path}: is empty; must be one of {KINDS}")
    if raw in NETCDF:
        return _told_apart(*_of_netcdf(path))
    name = name_of_file(path.name)
    if raw == slocum.MAGIC or slocum.MAGIC in raw[3:9]:  # the first letters of a compressed block
        return _told_apart(slocum.dives_of(path), name, "Slocum")
    no_text = f"is neither NetCDF nor text; must be one of {KINDS}"
    text = seaexplorer.text_in(raw, path, no_text)
    if raw.startswith(seaexplorer.GZIP) or seaexplorer.is_known(text):
        return _told_apart(seaexplorer.dives_of(text, path), name, "SeaExplorer")
    return _told_apart(table_dives(text, path), name, None)


def _told_apart(
    found: Sequence[Dive | Skipped], name: str | None, kind: str | None
) -> tuple[list[Dive], list[Skipped]]:
    """Return dives with the name of their vehicle, unless they have one, and its kind; the rest."""
    dives = [one for one in found if isinstance(one, Dive)]
    named = [replace(dive, vehicle=dive.vehicle or name, kind=kind) for dive in dives]
    return named, [one for one in found if isinstance(one, Skipped)]


def _of_netcdf(path: Path) -> tuple[Sequence[Dive | Skipped], str | None, str | None]:
    """Return what a file holds, the vehicle's name and its kind."""
    with open_netcdf(path, MOST_BYTES) as data, naming(path):
        if seaglider.is_known(data):
            return [seaglider.dive_of(data, path)], name_in(data), "Seaglider"
        if og1.is_known(data):
            return og1.dives_of(data), name_in(data), None
        names = ", ".join(map(str, list(data.variables)[:8])) or "no variables"
    raise DataError(
        f"{path}: neither a Seaglider file (with log_gps_time) nor OG1 (with LATITUDE_GPS): it has "
        f"{names}, not the fixes and the displacement through the water that a dive needs; a CSV "
        "table of dives can give both"
    )


def name_in(data: Any) -> str | None:
    """Return the vehicle's name in an open xarray.Dataset: its identifier, or its serial number.

    >>> import xarray
    >>> name_in(xarray.Dataset(attrs={"id": "SG015_20040929T140907_delayed"}))
    'SG015'
    >>> name_in(xarray.Dataset(attrs={"id": "x", "platform_id": " SG171 "}))
    'SG171'
    """
    serial = data.get("platform_serial_number")
    values = [data.attrs.get("platform_id"), None]
    if serial is not None and serial.ndim == 0 and serial.dtype.kind in "SUO":
        value = serial.values.item()
        values[1] = value.decode("utf-8", "replace") if isinstance(value, bytes) else value
    dated = DATED.match(str(data.attrs.get("id", "")))
    return name_of(*values, dated and dated[1])


def name_of_file(file: str) -> str | None:
    """Return the vehicle's name in that of a file of a Slocum or a SeaExplorer.

    >>> name_of_file("rosie_713-2019-166-0-156.sbd"), name_of_file("sea035.10.gli.sub.12.gz")
    ('rosie_713', 'sea035')
    >>> name_of_file("dives.csv") is None
    True
    """
    matches = (pattern.match(file) for pattern in FILES)
    return name_of(*(found[1] for found in matches if found))


def name_of(*values: Any) -> str | None:
    """Return the first value that is a name, None where none is."""
    for value in values:
        name = value.strip() if isinstance(value, str) else ""
        if 0 < len(name) <= LONGEST and name.isprintable():
            return name
    return None


def alike(faults: Iterable[tuple[Path, Skipped]]) -> list[Skipped]:
    """Return what was skipped of files; reasons that are the same but for the file once.

    >>> faults = [(Path(name), Skipped(None, f"{name}: is empty")) for name in "ab"]
    >>> alike(faults)
    [Skipped(dive=None, why='a: is empty (one of 2 files)')]
    """
    same: dict[tuple[int | None, str], list[str]] = {}
    for file, one in faults:
        same.setdefault((one.dive, one.why.removeprefix(str(file))), []).append(one.why)
    return [
        Skipped(dive, whys[0] + (f" (one of {len(whys)} files)" if len(whys) > 1 else ""))
        for (dive, _), whys in same.items()
    ]


@public
def read_dives(paths: str | Path | Iterable[str | Path]) -> tuple[list[Dive], list[Skipped]]:
    """Read all dives of files and folders.

    Parameters
    ----------
    paths : str, Path or iterable of them
        Files and folders, of any kinds together.

    Returns
    -------
    dives : list of Dive
        As the files have them; `usable` sorts and chooses.
    skipped : list of Skipped
        Damaged files and lines, each with its reason.

    Raises
    ------
    DataError
        If a path does not exist, or no file holds a dive.

    Examples
    --------
    >>> from tempfile import TemporaryDirectory
    >>> from clpt_control.gliders import sample_dives, write_dive_table
    >>> with TemporaryDirectory() as folder:
    ...     write_dive_table(sample_dives(), f"{folder}/sg542.csv")
    ...     dives, skipped = read_dives(folder)
    >>> len(dives), skipped
    (14, [])
    """
    files = dive_paths([paths] if isinstance(paths, str | Path) else paths)
    dives: list[Dive] = []
    skipped: list[Skipped] = []
    faults: list[tuple[Path, Skipped]] = []
    for file in files:
        check()
        try:
            found, bad = read_dive_file(file)
        except DataError as error:
            faults.append((file, Skipped(seaglider.number_in_name(file), str(error))))
            continue
        dives += found
        skipped += bad
    skipped += alike(faults)
    if dives:
        return dives, skipped
    if len(skipped) == 1 and not skipped[0].why.endswith(" files)"):
        raise DataError(skipped[0].why)
    if skipped and len(files) == 1:
        raise DataError(f"{files[0]}: no line holds a dive; the first: {skipped[0].why}")
    if skipped:
        raise DataError(f"none of {len(files)} files holds a dive; the first: {skipped[0].why}")
    raise DataError(f"{', '.join(map(str, files)) or 'no file'}: no dives")
