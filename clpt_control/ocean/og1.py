"""OceanGliders OG1 trajectory files: one NetCDF file per mission.

The format (OceanGliders community, "OG1.0 format user manual") has one dimension
`N_MEASUREMENTS` with `TIME`, `LATITUDE`, `LONGITUDE` along the track and `TIME_GPS`,
`LATITUDE_GPS`, `LONGITUDE_GPS` at the fixes.  It standardizes neither dives nor
dead reckoning; names are those of the converter seagliderOG1: `DIVE_NUMBER`,
`EAST_DISPLACEMENT`, `NORTH_DISPLACEMENT` (m since the sample before),
`DAVG_CURR_EAST`, `DAVG_CURR_NORTH` (depth-averaged current, m/s).

A dive lies between two fixes with more than ten minutes and a measurement
deeper than 5 m between them (any measurement, where there is no `DEPTH`): what
lacks one is a long surfacing.  Without displacements, dead reckoning is what the
file's own current leaves,

    dr = (displacement between the fixes) - current * duration.

The writer adds `GPS_FIX`, which says what each fix is to its dive, so that a file
reads back to the same dives whatever their fixes.
"""

from dataclasses import replace
from math import nan
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from ..errors import DataError
from ..files import open_netcdf
from .classic import check_whole
from .dives import Dive, make_dive
from .geodesy import displacement
from .og1_names import EAST, FIXES, GPS1, GPS2, GPSE, NORTH, NUMBERS, QUALITY, STEPS, VARIATION
from .og1_writer import write_og1 as write_og1
from .samples import track_of, values

if TYPE_CHECKING:
    import xarray

LEAST_GAP = 600.0  # s between two fixes with a dive between them
LEAST_DEPTH = 5.0  # m that a dive reaches
LARGEST_HOLE = 0.1  # share of a dive that may be without samples


def is_og1(data: "xarray.Dataset") -> bool:
    """Whether a NetCDF file is an OG1 trajectory."""
    return "N_MEASUREMENTS" in data.dims or any(name in data.variables for name in FIXES)


def read_og1(path: str | Path) -> list[Dive]:
    """Read the dives of an OG1 trajectory file.

    Parameters
    ----------
    path : str or Path
        The file.

    Returns
    -------
    list of Dive
        By time; NaN where the way through the water is not in the file.

    Raises
    ------
    DataError
        If the file is missing, damaged or without fixes.
    """
    path = Path(path)
    if path.is_file():
        check_whole(path)
    with open_netcdf(path) as data:
        return dives_of(data, path)


def dives_of(data: "xarray.Dataset", path: Path) -> list[Dive]:
    """Give the dives of an open OG1 file.

    Parameters
    ----------
    data : xarray.Dataset
        The file.
    path : Path
        Its name, for messages.

    Returns
    -------
    list of Dive
        As `read_og1`.

    Raises
    ------
    DataError
        If it has no fixes.
    """
    missing = [name for name in FIXES if name not in data.variables]
    if missing:
        raise DataError(f"{path}: no variable {' and no '.join(missing)}; OG1 has the fixes there")
    columns = {name: values(data, name) for name in FIXES}
    length = len(columns["TIME_GPS"])
    if any(column.shape != (length,) for column in columns.values()):
        raise DataError(f"{path}: {', '.join(FIXES)} differ in length; must be one per measurement")
    for name in ("TIME_GPS", "TIME"):
        units = str(data[name].attrs.get("units", "")) if name in data.variables else ""
        if " since " in units and not units.startswith("seconds since 1970-01-01"):
            raise DataError(f"{path}: {name} is in '{units}'; must be seconds since 1970-01-01")
    for key, names in (
        ("time", ("TIME", "TIME_GPS")), ("east", STEPS[:1]), ("north", STEPS[1:]), ("u", EAST),
        ("v", NORTH), ("number", NUMBERS), ("qc", QUALITY), ("magvar", VARIATION),
        ("kind", ("GPS_FIX",)), ("depth", ("DEPTH", "GLIDER_DEPTH")),
    ):  # fmt: skip
        found = [values(data, name) for name in names if name in data.variables]
        same = [column for column in found if column.shape == (length,)]
        columns[key] = same[0] if same else np.full(length, nan)
    if np.isfinite(columns["kind"]).any():
        return _by_kind(columns)
    dives = _by_gaps(columns)
    if not dives:
        raise DataError(
            f"{path}: no two fixes more than {LEAST_GAP:g} s apart in TIME_GPS; a dive needs one "
            "before and one after it"
        )
    return dives


def _fix(columns: dict[str, np.ndarray], row: int) -> tuple[float, float, float]:
    time, lat, lon = (float(columns[name][row]) for name in FIXES)
    return time, lat, lon


def _by_kind(columns: dict[str, np.ndarray]) -> list[Dive]:
    """Dives of a file of `write_og1`: each begins at its first fix."""
    kind = columns["kind"]
    dives = []
    starts = np.flatnonzero(kind == GPS2).tolist()
    for start in starts:
        ends = np.flatnonzero(kind[start:] == GPSE)
        if not ends.size:
            continue
        end = start + int(ends[0])
        before = start - 1 if start > 0 and kind[start - 1] == GPS1 else None
        first = None if before is None else _fix(columns, before)
        rows = np.arange(start, end + 1)
        dives.append(_dive(columns, rows, _fix(columns, start), _fix(columns, end), first, start))
    return dives


def _by_gaps(columns: dict[str, np.ndarray]) -> list[Dive]:
    """Dives of any OG1 file: between fixes that are far apart in time."""
    valid = np.all([np.isfinite(columns[name]) for name in FIXES], axis=0)
    valid &= (np.abs(columns["LATITUDE_GPS"]) <= 90) & (np.abs(columns["LONGITUDE_GPS"]) <= 360)
    rows = np.flatnonzero(valid & (columns["TIME_GPS"] > 0))
    rows = rows[np.argsort(columns["TIME_GPS"][rows], kind="stable")]
    when = columns["TIME_GPS"][rows]
    gaps = np.flatnonzero(np.diff(when) > LEAST_GAP).tolist()
    under = [_under_water(columns, when[k], when[k + 1]) for k in gaps]
    dives: list[Dive] = []
    surfaced = 0  # first fix since the dive before
    for k, dived in zip(gaps, under, strict=True):
        if dived or not any(under):
            start, end = _fix(columns, rows[k]), _fix(columns, rows[k + 1])
            first = _fix(columns, rows[surfaced]) if k > surfaced else None
            surfaced = k + 1
            inside = np.flatnonzero((columns["time"] > start[0]) & (columns["time"] <= end[0]))
            inside = inside[np.argsort(columns["time"][inside], kind="stable")]
            dives.append(_whole(_dive(columns, inside, start, end, first, len(dives) + 1)))
    return dives


def _under_water(columns: dict[str, np.ndarray], start: float, end: float) -> bool:
    inside = (columns["time"] > start) & (columns["time"] < end)
    depth = columns["depth"][inside]
    if np.isfinite(columns["depth"]).any():
        return bool(np.any(depth > LEAST_DEPTH))
    return bool(inside.any())


def _whole(dive: Dive) -> Dive:
    """Leave a dive without its sum where a good part of it has no samples."""
    if dive.track is None:
        return dive
    hole = float(np.max(np.diff(dive.track[0])))
    if hole <= LARGEST_HOLE * dive.duration:
        return dive
    note = f"no samples of the displacement for {hole:.0f} s of {dive.duration:.0f} s"
    return replace(dive, dr_east=nan, dr_north=nan, track=None, notes=(*dive.notes, note))


def _dive(
    columns: dict[str, np.ndarray],
    rows: np.ndarray,
    start: tuple[float, float, float],
    end: tuple[float, float, float],
    first: tuple[float, float, float] | None,
    otherwise: int,
) -> Dive:
    def of_dive(key: str) -> float | None:
        found = columns[key][rows]
        found = found[np.isfinite(found)]
        return float(np.median(found)) if found.size else None

    number, u, v = of_dive("number"), of_dive("u"), of_dive("v")
    time, east, north = (columns[key][rows] for key in ("time", "east", "north"))
    sampled = np.isfinite(time) & np.isfinite(east) & np.isfinite(north)
    track, notes = None, []
    way = nan, nan
    if sampled.any():
        way = float(np.sum(east[sampled])), float(np.sum(north[sampled]))
        since = time[sampled] - start[0]
        if sampled.sum() > 1 and np.all(np.diff(since) > 0):
            track = track_of(since, east[sampled], north[sampled], end[0] - start[0])
    elif u is not None and v is not None and not np.isfinite(columns["kind"]).any():
        gps, duration = displacement(*start[1:], *end[1:]), end[0] - start[0]
        way = gps[0] - u * duration, gps[1] - v * duration
        notes.append("dead reckoning computed from the file's own depth-averaged current")
    else:
        notes.append("neither EAST_DISPLACEMENT, NORTH_DISPLACEMENT nor DAVG_CURR_EAST, _NORTH")
    before: dict[str, Any] = {}
    if first is not None:
        before = dict(zip(("t_gps1", "lat_gps1", "lon_gps1"), first, strict=True))
    return make_dive(
        otherwise if number is None else int(number),
        start,
        end,
        way,
        **before,
        dac_east=u,
        dac_north=v,
        dac_qc=of_dive("qc"),
        magvar=of_dive("magvar"),
        track=track,
        notes=tuple(notes),
    )
