"""OceanGliders OG1 trajectory files: one NetCDF file per mission.

The format (OceanGliders community, "OG1.0 format user manual") has one dimension
`N_MEASUREMENTS` with `TIME`, `LATITUDE`, `LONGITUDE`, `DEPTH` along the track and
`TIME_GPS`, `LATITUDE_GPS`, `LONGITUDE_GPS` at the fixes (`og1_columns`).  It
standardizes neither dives nor dead reckoning.

A dive lies between two fixes with more than ten minutes and a measurement under
water between them: deeper than 5 m, else of a `PHASE` under water, else any.  What
lacks one is a long surfacing.  Dives without a fix between them are one.  Files that give
both fixes with each measurement are read as they say (`og1_columns`).

The displacement dr through the water is the first that the file allows of

1. displacements (m since the sample before): dr = sum_i d_i;
2. the flight model's horizontal speed s and the heading h from true north, or
   from magnetic north where the variation is in the file:
   d_i = s_i (t_i - t_{i-1}) (sin h_i, cos h_i);
3. the file's depth-averaged current c:
   dr = (displacement between the fixes) - c (t_E - t_2);
4. as 2 with a magnetic heading, rotated by IGRF's variation in the middle of the dive
   (`samples.variation`), or a heading of which the file does not say from which north, taken as
   true.

The dive's notes say which it was where it was not the first.
"""

from math import isfinite, nan
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from ..errors import DataError
from ..estimation.dive import Track
from .dives import (
    LEAST_DEPTH,
    Dive,
    Fix,
    Skipped,
    Three,
    cut_dives,
    dive_between,
    fixes_at,
    without_current,
)
from .og1_columns import Columns, columns_of, fixes_in, has_ends, segments_of
from .og1_columns import is_known as is_known
from .samples import LAST, deepest, hole_under_water, track_of, variation

if TYPE_CHECKING:
    import xarray

LEAST_GAP = 600.0  # s between two fixes with a dive between them
UNDER_WATER = (1, 2, 4, 5)  # PHASE: ascent, descent, parking, inflexion


class ThroughWater(NamedTuple):
    """Displacement east and north (m), NaN where the file has none, its track, notes."""

    total: tuple[float, float]
    track: Track | None
    notes: list[str]
    turned: float | None = None  # by which a magnetic heading was turned, degrees east


def through_water(
    columns: Columns,
    rows: np.ndarray,
    start: Fix,
    end: Fix,
    current: tuple[float | None, float | None],
) -> ThroughWater:
    """Return the displacement through the water of one dive from its rows, by time."""
    of = columns.of
    duration = end[0] - start[0]
    found = _summed(of, rows, (of["east"], of["north"]), start[0], duration)
    if found is not None:
        if columns.steps.upper().endswith("_GSM"):
            found.notes.append(f"dead reckoning of the glide-slope model ({columns.steps})")
        return found
    sure = columns.north == "true" or bool(np.isfinite(of["magvar"][rows]).any())
    found = _along_heading(columns, rows, start, end) if sure else None
    u, v = current
    if found is None and u is not None and v is not None:
        total = without_current(start, end, (u, v))
        note = "dead reckoning computed from the file's depth-averaged current"
        return ThroughWater(total, None, [note])
    found = found or _along_heading(columns, rows, start, end)
    if found is None:
        lacking = (
            "no EAST_DISPLACEMENT, NORTH_DISPLACEMENT, no speed and heading, no depth-averaged "
            "current"
        )
        return ThroughWater((nan, nan), None, [lacking])
    return found


def _along_heading(columns: Columns, rows: np.ndarray, start: Fix, end: Fix) -> ThroughWater | None:
    """Return the dead reckoning of speed and heading; None where a dive has neither."""
    of = columns.of
    turned, north = _variation_of(columns, rows, start, end)
    found = _summed(of, rows, _flown(of, rows, turned or 0.0), start[0], end[0] - start[0])
    if found is None or not isfinite(found.total[0]):
        return found
    found.notes.append(f"dead reckoning of the flight model's speed and the heading, {north}")
    return found._replace(turned=turned)


def _variation_of(
    columns: Columns, rows: np.ndarray, start: Fix, end: Fix
) -> tuple[float | None, str]:
    """Return the variation of a dive's heading (degrees east), None if true; which north it has."""
    if columns.north == "true":
        return None, "true"
    each = columns.of["magvar"][rows]
    if np.isfinite(each).any():
        found = float(np.median(each[np.isfinite(each)]))
        north = columns.north or "of a north that the file does not name"
        return found, f"{north}, turned by the file's variation of {found:g} degrees"
    if not columns.north:
        return 0.0, ("of a north that the file does not name, taken as true (--variation turns it)")
    found = variation(0.5 * (start[0] + end[0]), *start[1:])
    if not isfinite(found):
        return 0.0, f"magnetic, taken as true: IGRF ends in {LAST} (--variation turns it)"
    return found, (
        f"magnetic, turned by IGRF's variation of {found:.0f} degrees (--variation gives another)"
    )


def _flown(
    of: dict[str, np.ndarray], rows: np.ndarray, variation: float
) -> tuple[np.ndarray, np.ndarray]:
    """Return steps of speed and heading, m; NaN where a row has none.

    A row with a heading and no speed is a stall of the flight model: no step.
    """
    steps = np.full(of["time"].shape, nan), np.full(of["time"].shape, nan)
    steered = rows[np.isfinite(of["time"][rows]) & np.isfinite(of["heading"][rows])]
    since = np.diff(of["time"][steered], prepend=of["time"][steered[:1]])
    heading = np.radians(of["heading"][steered] + variation)
    for step, part in zip(steps, (np.sin(heading), np.cos(heading)), strict=True):
        step[steered] = of["speed"][steered] * since * part
    return steps


def _summed(
    of: dict[str, np.ndarray],
    rows: np.ndarray,
    steps: tuple[np.ndarray, np.ndarray],
    start: float,
    duration: float,
) -> ThroughWater | None:
    """Sum the steps of a dive; None where it has none."""
    rows = rows[np.all([np.isfinite(a[rows]) for a in (of["time"], *steps)], axis=0)]
    if not rows.size:
        return None
    since, notes = of["time"][rows] - start, []
    again = np.diff(since, prepend=-1.0) == 0
    if again.any() and np.any([step[rows][again] != 0 for step in steps]):
        notes.append(f"{again.sum()} samples have the time of the one before, left out")
    rows, since = rows[~again], since[~again]
    east, north = (step[rows] for step in steps)
    total = float(np.sum(east)), float(np.sum(north))
    if np.any(np.diff(since) <= 0) or since[0] < 0:
        return ThroughWater(total, None, [*notes, "no track: the times are not in order"])
    hole = hole_under_water(since, of["depth"][rows], duration)
    if hole:
        return ThroughWater((nan, nan), None, [*notes, hole])
    return ThroughWater(total, track_of(since, east, north, duration), notes)


def dives_of(data: "xarray.Dataset") -> tuple[list[Dive], list[Skipped]]:
    """Return the dives of a file by time, between fixes that are far apart in time."""
    columns = columns_of(data)
    if has_ends(data):
        return _of_segments(columns, segments_of(data))
    of = columns.of
    rows, failed = fixes_in(of)
    wet, time = _under_water(of), of["time"]
    fixes = fixes_at(rows, of["t_fix"], of["lat"], of["lon"])
    under = np.sort(time[wet & np.isfinite(time)])
    found = cut_dives(fixes, under, LEAST_GAP) or cut_dives(fixes, None, LEAST_GAP)
    dives: list[Dive] = []
    for count, (first, start, end) in enumerate(found, 1):
        notes = []
        part = np.flatnonzero((time > start[0]) & (time <= end[0]))
        if np.any(np.diff(time[part]) < 0):
            notes.append("the measurements were not in order of time, sorted")
        bad = int(np.sum((failed >= start[0]) & (failed <= end[0])))
        if bad:
            notes.append(f"{bad} fix(es) that are no place, 0 N 0 E or under water left out")
        dives.append(_dive(columns, wet, (first, start, end), count, notes))
    if not dives:
        raise DataError(
            f"no two fixes more than {LEAST_GAP:g} s apart in LATITUDE_GPS, LONGITUDE_GPS; "
            "a dive needs one before and one after it"
        )
    return dives, []


def _of_segments(
    columns: Columns, segments: list[tuple[Fix, Fix, list[str]]]
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
        dives.append(_dive(columns, wet, (None, start, end), count, notes))
    return dives, skipped


def _under_water(of: dict[str, np.ndarray]) -> np.ndarray:
    """Return which rows are measurements under water."""
    known = np.isfinite(of["phase"]) & (of["phase"] != 0)
    wet = np.where(known, np.isin(of["phase"], UNDER_WATER), True) & ~np.isfinite(of["lat"])
    return np.where(np.isfinite(of["depth"]), of["depth"] > LEAST_DEPTH, wet)


def _dive(
    columns: Columns, wet: np.ndarray, fixes: Three, otherwise: int, notes: list[str]
) -> Dive:
    """Make the dive between fixes; `otherwise` is its number where none is known."""
    of, (_, start, end) = columns.of, fixes
    rows = np.flatnonzero((of["time"] > start[0]) & (of["time"] <= end[0]))
    rows = rows[np.argsort(of["time"][rows], kind="stable")]
    wet = rows[wet[rows]]

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
    found = through_water(columns, rows, start, end, current)
    greatest = of_dive("depth_max")
    return dive_between(
        otherwise if number is None else int(number),
        fixes,
        found.total,
        dac_east=current[0],
        dac_north=current[1],
        dac_qc=of_dive("qc"),
        magvar=of_dive("magvar") if found.turned is None else found.turned,
        turned=found.turned,
        depth_max=deepest(of["depth"][rows]) if greatest is None else greatest,
        track=found.track,
        notes=(*notes, *found.notes, *columns.notes),
    )
