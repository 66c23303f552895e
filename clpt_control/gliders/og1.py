"""OceanGliders OG1 trajectory files: one NetCDF file per mission.

The format (OceanGliders community, "OG1.0 format user manual") has one dimension
`N_MEASUREMENTS` with `TIME`, `LATITUDE`, `LONGITUDE`, `DEPTH` along the track and
`TIME_GPS`, `LATITUDE_GPS`, `LONGITUDE_GPS` at the fixes.  It standardizes neither
dives nor dead reckoning; `og1_names` has what converters call them.

A dive lies between two fixes with more than ten minutes and a measurement under
water between them: deeper than 5 m, else of a `PHASE` under water, else any.  What
lacks one is a long surfacing.  Dives without a fix between them are one.  The
writer adds `GPS_FIX`, which says what each fix is to its dive, so that a file
reads back to the same dives whatever their fixes.
"""

from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from ..errors import DataError
from ..files import open_netcdf
from .dives import Dive, Fix, make_dive
from .og1_columns import Columns, columns_of, fixes_in
from .og1_columns import is_og1 as is_og1
from .og1_names import GPS1, GPS2, GPSE, UNDER_WATER
from .og1_way import way_of
from .og1_writer import write_og1 as write_og1
from .own_current import compared
from .samples import deepest

if TYPE_CHECKING:
    import xarray

LEAST_GAP = 600.0  # s between two fixes with a dive between them
LEAST_DEPTH = 5.0  # m that a dive reaches


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
    with open_netcdf(path) as data:
        return dives_of(data, path)


def dives_of(data: "xarray.Dataset", path: Path) -> list[Dive]:
    """Return the dives of an open OG1 file.

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
        If it has no fixes, or none far enough apart for a dive.
    """
    columns = columns_of(data, path)
    if np.isfinite(columns.of["kind"]).any():
        return _by_kind(columns)
    dives = _by_gaps(columns, path)
    if not dives:
        raise DataError(
            f"{path}: no two fixes more than {LEAST_GAP:g} s apart in LATITUDE_GPS, LONGITUDE_GPS; "
            "a dive needs one before and one after it"
        )
    return dives


def _fix(columns: Columns, row: int) -> Fix:
    time, lat, lon = (float(columns.of[name][row]) for name in ("t_fix", "lat", "lon"))
    return time, lat, lon


def _by_kind(columns: Columns) -> list[Dive]:
    """Dives of a file of `write_og1`: each begins at its first fix."""
    kind = columns.of["kind"]
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


def _by_gaps(columns: Columns, path: Path) -> list[Dive]:
    """Dives of any OG1 file: between fixes that are far apart in time."""
    of = columns.of
    rows, failed = fixes_in(of, path)
    when = of["t_fix"][rows]
    gaps = np.flatnonzero(np.diff(when) > LEAST_GAP).tolist()
    wet = _under_water(of)
    inside = [np.flatnonzero((of["time"] > when[k]) & (of["time"] <= when[k + 1])) for k in gaps]
    under = [bool(wet[part].any()) for part in inside]
    dives: list[Dive] = []
    surfaced = 0  # first fix since the dive before
    for k, part, dived in zip(gaps, inside, under, strict=True):
        if not dived and any(under):
            continue
        start, end = _fix(columns, rows[k]), _fix(columns, rows[k + 1])
        first = _fix(columns, rows[surfaced]) if k > surfaced else None
        surfaced = k + 1
        notes = []
        if np.any(np.diff(of["time"][part]) < 0):
            notes.append("the measurements were not in order of time, sorted")
        part = part[np.argsort(of["time"][part], kind="stable")]
        numbers = np.unique(of["number"][part[wet[part]]])
        numbers = numbers[np.isfinite(numbers)]
        if numbers.size > 1:
            notes.append(
                f"no fix between dives {numbers[0]:.0f} and {numbers[-1]:.0f}: taken as one"
            )
        bad = int(np.sum((failed >= start[0]) & (failed <= end[0])))
        if bad:
            notes.append(f"{bad} fix(es) that are no place or 0 N 0 E left out")
        dives.append(_dive(columns, part, start, end, first, len(dives) + 1, wet, notes))
    return dives


def _under_water(of: dict[str, np.ndarray]) -> np.ndarray:
    """Which rows are measurements under water."""
    known = np.isfinite(of["phase"]) & (of["phase"] != 0)
    wet = np.where(known, np.isin(of["phase"], UNDER_WATER), True) & ~np.isfinite(of["lat"])
    return np.where(np.isfinite(of["depth"]), of["depth"] > LEAST_DEPTH, wet)


def _dive(
    columns: Columns,
    rows: np.ndarray,
    start: Fix,
    end: Fix,
    first: Fix | None,
    otherwise: int,
    wet: np.ndarray | None = None,
    notes: list[str] | None = None,
) -> Dive:
    of = columns.of

    def of_dive(key: str, among: np.ndarray = rows) -> float | None:
        found = of[key][among]
        found = found[np.isfinite(found)]
        return float(np.median(found)) if found.size else None

    number = of_dive("number", rows if wet is None else rows[wet[rows]])
    if number is None:
        number = of_dive("number")
    u, v = of_dive("u"), of_dive("v")
    if notes and any("taken as one" in note for note in notes):
        u = v = None
    found = way_of(columns, rows, start, end, (u, v), whole=wet is not None)
    before: dict[str, Any] = {}
    if first is not None:
        before = dict(zip(("t_gps1", "lat_gps1", "lon_gps1"), first, strict=True))
    greatest = of_dive("depth_max")
    dive = make_dive(
        otherwise if number is None else int(number),
        start,
        end,
        found.total,
        **before,
        dac_east=u,
        dac_north=v,
        dac_qc=of_dive("qc"),
        magvar=of_dive("magvar"),
        depth_max=deepest(of["depth"][rows]) if greatest is None else greatest,
        track=found.track,
        notes=(*(notes or []), *found.notes),
    )
    return dive if wet is None else compared(dive)
