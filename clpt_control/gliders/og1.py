"""OceanGliders OG1 trajectory files: one NetCDF file per mission.

The format (OceanGliders community, "OG1.0 format user manual") has one dimension
`N_MEASUREMENTS` with `TIME`, `LATITUDE`, `LONGITUDE`, `DEPTH` along the track and
`TIME_GPS`, `LATITUDE_GPS`, `LONGITUDE_GPS` at the fixes (`og1_columns`).  It
standardizes neither dives nor dead reckoning.

A dive lies between two fixes with more than ten minutes and a measurement under
water between them: deeper than 5 m, else of a `PHASE` under water, else any.  What
lacks one is a long surfacing.  Dives without a fix between them are one.  Files that give
both fixes with each measurement are read as they say (`og1_segments`).

The displacement through the water is that of `og1_through_water`.
"""

from math import isfinite
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from ..errors import DataError
from . import og1_segments
from .dives import Dive, Fix, Skipped, compared, make_dive
from .og1_columns import Columns, columns_of, fixes_in
from .og1_columns import is_known as is_known
from .og1_through_water import through_water
from .samples import deepest

if TYPE_CHECKING:
    import xarray

LEAST_GAP = 600.0  # s between two fixes with a dive between them
LEAST_DEPTH = 5.0  # m that a dive reaches
UNDER_WATER = (1, 2, 4, 5)  # PHASE: ascent, descent, parking, inflexion


def dives_of(data: "xarray.Dataset", path: Path) -> tuple[list[Dive], list[Skipped]]:
    """Return the dives of a file by time, between fixes that are far apart in time."""
    columns = columns_of(data, path)
    if og1_segments.is_known(data):
        return _of_segments(columns, og1_segments.segments_of(data, path))
    of = columns.of
    rows, failed = fixes_in(of, path)
    when = of["t_fix"][rows]
    gaps = np.flatnonzero(np.diff(when) > LEAST_GAP).tolist()
    wet = _under_water(of)
    inside = [np.flatnonzero((of["time"] > when[k]) & (of["time"] <= when[k + 1])) for k in gaps]
    under = [bool(wet[part].any()) for part in inside]
    fixes = [_fix(of, row) for row in rows]
    dives: list[Dive] = []
    surfaced = 0  # first fix since the dive before
    for k, part, dived in zip(gaps, inside, under, strict=True):
        if not dived and any(under):
            continue
        before = fixes[surfaced] if k > surfaced else None
        surfaced = k + 1
        notes = []
        if np.any(np.diff(of["time"][part]) < 0):
            notes.append("the measurements were not in order of time, sorted")
        part = part[np.argsort(of["time"][part], kind="stable")]
        bad = int(np.sum((failed >= when[k]) & (failed <= when[k + 1])))
        if bad:
            notes.append(f"{bad} fix(es) that are no place, 0 N 0 E or under water left out")
        three = (before, fixes[k], fixes[k + 1])
        dives.append(_dive(columns, part, part[wet[part]], three, len(dives) + 1, notes))
    if not dives:
        raise DataError(
            f"{path}: no two fixes more than {LEAST_GAP:g} s apart in LATITUDE_GPS, LONGITUDE_GPS; "
            "a dive needs one before and one after it"
        )
    return dives, []


def _of_segments(
    columns: Columns, segments: list[og1_segments.Segment]
) -> tuple[list[Dive], list[Skipped]]:
    """Return the dives of segments with a measurement under water, and the others."""
    of = columns.of
    wet = _under_water(of)
    dives: list[Dive] = []
    skipped: list[Skipped] = []
    for count, (start, end, notes) in enumerate(segments, 1):
        inside = np.flatnonzero((of["time"] > start[0]) & (of["time"] <= end[0]))
        if isfinite(start[0]) and not wet[inside].any():
            known = of["number"][inside][np.isfinite(of["number"][inside])]
            number = int(known[0]) if known.size else None
            skipped.append(Skipped(number, "no measurement under water between its fixes"))
            continue
        order = inside[np.argsort(of["time"][inside], kind="stable")]
        three = (None, start, end)
        dives.append(_dive(columns, order, order[wet[order]], three, count, notes))
    return dives, skipped


def _fix(of: dict[str, np.ndarray], row: int) -> Fix:
    return float(of["t_fix"][row]), float(of["lat"][row]), float(of["lon"][row])


def _under_water(of: dict[str, np.ndarray]) -> np.ndarray:
    """Return which rows are measurements under water."""
    known = np.isfinite(of["phase"]) & (of["phase"] != 0)
    wet = np.where(known, np.isin(of["phase"], UNDER_WATER), True) & ~np.isfinite(of["lat"])
    return np.where(np.isfinite(of["depth"]), of["depth"] > LEAST_DEPTH, wet)


def _dive(
    columns: Columns,
    rows: np.ndarray,
    wet: np.ndarray,
    fixes: tuple[Fix | None, Fix, Fix],
    otherwise: int,
    notes: list[str],
) -> Dive:
    """Make the dive of some rows, wet or not; `otherwise` is its number where none is known."""
    of = columns.of

    def of_dive(key: str, among: np.ndarray = rows) -> float | None:
        found = of[key][among]
        found = found[np.isfinite(found)]
        return float(np.median(found)) if found.size else None

    numbers = np.unique(of["number"][wet][np.isfinite(of["number"][wet])])
    number = of_dive("number", wet if numbers.size else rows)
    current = of_dive("u"), of_dive("v")
    if numbers.size > 1:
        first, last = numbers[[0, -1]]
        notes.append(f"no fix between dives {first:.0f} and {last:.0f}: taken as one")
        current = None, None
    before, start, end = fixes
    found = through_water(columns, rows, start, end, current)
    greatest = of_dive("depth_max")
    dive = make_dive(
        otherwise if number is None else int(number),
        start,
        end,
        found.total,
        **dict(zip(("t_gps1", "lat_gps1", "lon_gps1"), before or (None,) * 3, strict=True)),
        dac_east=current[0],
        dac_north=current[1],
        dac_qc=of_dive("qc"),
        magvar=of_dive("magvar") if found.turned is None else found.turned,
        turned=found.turned,
        depth_max=deepest(of["depth"][rows]) if greatest is None else greatest,
        track=found.track,
        notes=(*notes, *found.notes, *columns.notes),
    )
    return compared(dive)
