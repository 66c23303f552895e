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

The dive's notes say which it was where it was not the first.  A speed may be on fewer rows than the
heading, or on others, as where two instruments write one file: it holds until the next.
"""

from math import isfinite, isnan, nan
from pathlib import Path

import numpy as np
import pandas
import xarray

from ...base.errors import DataError
from .dives import (
    LEAST_DEPTH,
    LEAST_GAP,
    Dive,
    DivesOrSkipped,
    Fix,
    Pair,
    Skipped,
    Three,
    ThroughWater,
    cut_dives,
    dive_between,
    usual_surfacing,
    without_current,
)
from .og1_columns import (
    FIXES,
    currents_of,
    fixes_and_others,
    has_ends,
    measurements_of,
    segments_of,
    with_steady_clock,
)
from .samples import REPAIRABLE, deepest, known_names, summed, variation

MOST_STALLS = 4  # of the flight model in a dive
RARE = 0.03  # share of the speeds that a stall follows, and of samples at one time
UNDER_WATER = (1, 2, 4, 5)  # PHASE: ascent, descent, parking, inflexion


def is_known(data: xarray.Dataset) -> bool:
    """Return whether a NetCDF file is an OG1 trajectory."""
    names = known_names(data)
    return "N_MEASUREMENTS" in data.dims or any(name in names for name in FIXES)


def through_water(
    rows: pandas.DataFrame, start: Fix, end: Fix, current: Pair
) -> ThroughWater:
    """Return the displacement through the water of one dive from its rows, by time."""
    reckoned = _summed(rows, rows, start, end)
    steps = rows.attrs["steps"]
    if reckoned is not None and steps.upper().endswith("_GSM"):
        note = f"dead reckoning of the glide-slope model ({steps})"
        return reckoned._replace(notes=(*reckoned.notes, note))
    sure = rows.attrs["north"] == "true" or rows.magvar.notna().any()
    has_current = all(map(isfinite, current))
    if reckoned is None and (sure or not has_current):
        reckoned = _along_heading(rows, start, end)
    if reckoned is None and has_current:
        total = without_current(start, end, current)
        note = "dead reckoning computed from the file's depth-averaged current"
        return ThroughWater(total, notes=[note])
    lacking = (
        "no EAST_DISPLACEMENT, NORTH_DISPLACEMENT, no speed and heading, "
        "no depth-averaged current"
    )
    return reckoned or ThroughWater(notes=[lacking])


def _along_heading(rows: pandas.DataFrame, start: Fix, end: Fix) -> ThroughWater | None:
    """Return the dead reckoning of speed and heading; None where a dive has neither.

    A row with a heading and no speed is a stall of the flight model: no step.  If there are more
    of them than stalls, speeds have a rate of their own, and each holds until the next.
    """
    turned, north = _variation_of(rows, start, end)
    flown = rows.dropna(subset=["speed", "heading"], how="all")
    gap = flown.speed.isna()
    holes = gap.groupby((~gap).cumsum()).sum()
    if (holes > 0).sum() > max(MOST_STALLS, RARE * len(holes)):
        if holes.max() > max(2 * holes.median(), REPAIRABLE * len(flown)):
            note = (
                f"{holes.max()} of {len(flown)} samples in a row have a heading and no speed, in a "
                "stall or between two speeds"
            )
            return ThroughWater(notes=[note])
        flown = flown.assign(speed=flown.speed.ffill().bfill())
    steered = flown.dropna(subset="heading")
    step = steered.speed * steered.time.diff().fillna(0.0)
    heading = np.radians(steered.heading + (turned or 0.0))
    flown = steered.assign(east=step * np.sin(heading), north=step * np.cos(heading))
    reckoned = _summed(flown.dropna(subset="east"), rows, start, end)
    if reckoned is None or not isfinite(reckoned.total[0]):
        return reckoned
    note = f"dead reckoning of the flight model's speed and the heading, {north}"
    return reckoned._replace(turned=turned, notes=(*reckoned.notes, note))


def _variation_of(
    rows: pandas.DataFrame, start: Fix, end: Fix
) -> tuple[float | None, str]:
    """Return the variation of a dive's heading (degrees east), None if true; which north it has."""
    north = rows.attrs["north"]
    measured = rows.magvar[rows.magvar != 0].dropna()
    if north not in ("", "magnetic", "true"):
        raise DataError(
            f"the north of the heading is not clear: {north!r}. Let its comment say only 'true' or "
            "'magnetic'"
        )
    if north == "true":
        return None, north
    degrees = 0.0
    source = "not known"
    if len(measured):
        degrees = float(measured.median())
        source = "of the file"
    elif north and isfinite(igrf := variation(0.5 * (start[0] + end[0]), *start[1:])):
        degrees = igrf
        source = "by IGRF"
    name = north or "of a north that the file does not name"
    return (
        degrees,
        f"{name}, variation {degrees:.0f} degrees ({source}; --variation gives another)",
    )


def _summed(
    rows: pandas.DataFrame, every: pandas.DataFrame, start: Fix, end: Fix
) -> ThroughWater | None:
    """Sum the steps east and north of a dive's rows; None where it has none.

    `every` has all rows of the dive, with their depths.
    """
    with_step = rows.dropna(subset=["east", "north"])
    if with_step.empty:
        return None
    rows = (
        with_step
        if _spanning(rows, with_step)
        else rows[rows.wet | rows.index.isin(with_step.index)]
    )
    notes = []
    duration = end[0] - start[0]
    again = rows.time.diff() == 0
    if rows.loc[again, ["east", "north"]].any(axis=None):
        notes.append(f"{again.sum()} samples have the time of the one before, left out")
        at_once = rows.groupby("time")[["east", "north", "depth"]].nunique() > 1
        if at_once.any(axis=1).mean() > RARE:
            return ThroughWater(notes=notes)
    rows = rows[~again]
    since = (rows.time - start[0]).to_numpy()
    steps = rows[["east", "north"]].to_numpy().T
    depths = (every.time - start[0]).to_numpy(), every.depth.to_numpy()
    return summed(since, steps, depths, duration, every.attrs["surfacing"], notes)


def _spanning(rows: pandas.DataFrame, with_step: pandas.DataFrame) -> bool:
    """Return whether a step after samples without one covers their time too, by its length."""
    step_time = with_step.time.diff()
    row_time = rows.time.diff()[with_step.index]
    length = np.hypot(with_step.east, with_step.north)
    after = step_time > row_time
    speed = (length / row_time)[~after & (row_time > 0)].median()
    return not (length - 0.5 * speed * (step_time + row_time))[after].median() < 0


def dives_of(data: xarray.Dataset, _path: Path) -> DivesOrSkipped:
    """Return the dives of a file by time, between fixes that are far apart in time."""
    of = measurements_of(data)
    # under water: by the depth; without depth by the phase, and without a fix
    wet = (of.phase.isna() | of.phase.isin((0, *UNDER_WATER))) & of.lat.isna()
    of["wet"] = wet.where(of.depth.isna(), of.depth > LEAST_DEPTH)
    of["behind"] = 0.0
    if has_ends(data):
        return _of_segments(of, segments_of(of))
    of = with_steady_clock(of, of.attrs["fix_clock"])
    fixes, failed = fixes_and_others(of)
    under = np.sort(of.time[of.wet].dropna())
    dive_fixes = cut_dives(fixes, under) or cut_dives(fixes, None)
    dives: DivesOrSkipped = []
    of.attrs["surfacing"] = usual_surfacing(dive_fixes)
    dated_currents = of.attrs["own_currents"]
    currents = currents_of(
        [(start, end) for _, start, end in dive_fixes], dated_currents
    )
    for count, fixes_of_dive in enumerate(dive_fixes, 1):
        notes = []
        _, start, end = fixes_of_dive
        if (_rows_between(of, start, end).time.diff() < 0).any():
            notes.append("the measurements were not in order of time, sorted")
        wrong_fixes = int(np.sum((failed >= start[0]) & (failed <= end[0])))
        if wrong_fixes:
            notes.append(
                f"{wrong_fixes} fix(es) that are no place, 0 N 0 E or under water left out"
            )
        if dated_currents and isnan(currents[count - 1][0]):
            notes.append(
                "no depth-averaged current of the file has a time of this dive alone"
            )
        dives.append(_dive(of, fixes_of_dive, count, notes, currents[count - 1]))
    if not dives:
        raise DataError(
            f"no two fixes more than {LEAST_GAP:g} s apart in LATITUDE_GPS, LONGITUDE_GPS; "
            "a dive requires one before and one after it"
        )
    return dives


def _of_segments(
    of: pandas.DataFrame, segments: list[tuple[Fix, Fix, list[str]]]
) -> DivesOrSkipped:
    """Return the dives of segments with a measurement under water, and the others."""
    dives: DivesOrSkipped = []
    of.attrs["surfacing"] = usual_surfacing([])
    for count, (start, end, notes) in enumerate(segments, 1):
        inside = _rows_between(of, start, end)
        if isfinite(start[0]) and not inside.wet.any():
            numbers = inside.number.dropna().tolist()
            number = int(numbers[0]) if numbers else None
            dives.append(
                Skipped(number, "no measurement under water between its fixes")
            )
        else:
            dives.append(_dive(of, (None, start, end), count, notes))
    return dives


def _rows_between(of: pandas.DataFrame, start: Fix, end: Fix) -> pandas.DataFrame:
    return of[(of.time > start[0]) & (of.time <= end[0])]


def _dive(
    of: pandas.DataFrame,
    fixes: Three,
    count: int,
    notes: list[str],
    dated_current: Pair = (nan, nan),
) -> Dive:
    """Make the dive between fixes.

    `count` is its number if no row has one, and `dated_current` its current.
    """
    _, start, end = fixes
    rows = _rows_between(of, start, end).sort_values("time", kind="stable")
    wet = rows[rows.wet]
    middle = rows.median()
    current = dated_current if isnan(middle.u) else (middle.u, middle.v)
    numbers = np.unique(wet.number.dropna())
    number = wet.number.median() if numbers.size else middle.number
    if numbers.size > 1:
        notes.append(
            f"no fix between dives {numbers[0]:.0f} and {numbers[-1]:.0f}: taken as one"
        )
        current = nan, nan
    reckoned = through_water(rows, start, end, current)
    if (behind := float(rows.behind.max())) > 0:
        notes.append(
            f"the clock of its samples was set back by {behind:.0f} s under water: "
            "used without its track"
        )
        reckoned = reckoned._replace(track=None)
    greatest = middle.depth_max
    return dive_between(
        count if isnan(number) else int(number),
        fixes,
        reckoned,
        dac_east=current[0],
        dac_north=current[1],
        dac_qc=middle.qc,
        magvar=middle.magvar if reckoned.turned is None else reckoned.turned,
        depth_max=deepest(rows.depth.to_numpy()) if isnan(greatest) else greatest,
        notes=(*notes, *reckoned.notes, *of.attrs["notes"]),
    )
