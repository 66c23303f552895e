"""Columns of an OG1 file under common names (`samples`), in SI units.

Every column has one number per row, NaN where there is none.  Rows are those of
`N_MEASUREMENTS`; fixes that stand on a dimension of their own follow as further
rows.  Where there is no `TIME_GPS`, a fix has the `TIME` of its row.  Where there is no
`LATITUDE_GPS`, fixes are the places with `DEAD_RECKONING` = 0, which the receiver gave.
Times of fixes without units are in the unit in which most of them lie among the
measurements, or within a day of them.  A displacement without a time is between its neighbours.

A heading is from true or from magnetic north by the words of its attributes: `APPLIED` is a
correction for the variation, which `DENIED` takes back ("declination applied", "not corrected for
declination").  Words that contradict are refused where the heading is used.

Some files, of Spray, say of every measurement where and when its dive ended:
`TIME_GPS_END`, `LATITUDE_GPS_END`, `LONGITUDE_GPS_END` are the fix after the dive,
repeated at its measurements, `TIME_GPS`, `LATITUDE_GPS`, `LONGITUDE_GPS` the one
before it.  Where that one is missing, it follows from the middle of the segment under
water (`TIME_UV`, `LATITUDE_UV`, `LONGITUDE_UV`), which its maker defines as halfway
between both fixes (Scripps Institution of Oceanography, comments of sp028_20230202T1637):

    start = 2 middle - end,

good to twice the last digit of the file, some 10 m.

The receiver times the fixes, a clock of the vehicle the samples.  If that clock is set back, the
samples after it have times that were there before: sorted by time, two parts of a dive, or two
dives, are mixed.  The order of the rows still tells which came first.

A clock was set back where, from one row under water to the next, time falls by more than
`LEAST_FALL`, the depth goes on, and times rise on both sides.  From there on the fall and one usual
step are added to the times, until a fix whose own time agrees with the clock again.
"""

import re
from collections.abc import Sequence
from math import nan
from typing import Any

import numpy as np
import pandas
import xarray

from ...base.errors import DataError
from ...base.units import DAY
from ...paper.currents.flags import said
from .dives import LEAST_DEPTH, Fix, fixes_in, is_fix
from .samples import (
    ANGLES,
    ENDS,
    PLACE,
    PLACES,
    QUANTITIES,
    SURFACE,
    checked_angles,
    columns_of,
    known_names,
    metres_per_second,
    pairs_of,
    seconds,
    values,
)
from .usable_dives import SMALLER

FIXES = ("TIME_GPS", "LATITUDE_GPS", "LONGITUDE_GPS")
TO_WEST = re.compile(r"deg\w*(_west|_south|_?W|_S)")  # units of a place
FLAG = "DEAD_RECKONING"  # 0 where a place is a fix
SURFACING = 1800.0  # s after a dive in which its current may be dated
# what attributes of a heading say of its north, without other signs than . , ; +
VERB = r"(correct|appl|adjust|compensat|includ|account|remov|add|convert|turn|rotat|plus)\w*"
ANGLE = r"(declination|variation|true)\b"
WORDS = r"( (\d+\.)?\w+)"
APPLIED = rf"\b(un)?{VERB}{WORDS}{{0,6}} {ANGLE}|\b{ANGLE}{WORDS}{{0,4}} (un)?{VERB}"
DENIED = (
    r"\b(not?|un|without|before|never|needs?|must|should|to|\w*n t|lack\w*|ignor\w*|exclud\w*)"
    r"( (be|been|has|have|yet|still|any|is|was|the|magnetic|declination|variation|further))*"
    rf" ?{VERB}|\b({VERB}|{ANGLE}) (no|none|false|0|pending|missing|required|needed)\b"
    r"|\b(add|apply|correct|convert|subtract)\b"
)
NEITHER = r"\bnot? (magnetic|true)\b(?! (decl|vari|corr))|\b(magnetic|true|north) (false|no|0)\b"
NO_NORTH = (  # both and none
    r"\b(ccw|(counter|anti) ?clockwise|from( the)? (east|south|west))\b"
    r"|\+ ?(magnetic )?(declination|variation)"
)
TRUE = rf"\b(true|geographic)|\b(deg\w*|units) ?t\b|{NO_NORTH}"
MAGNETIC = rf"\bmag(netic)?\b(?! (declination|variation))|\b(deg|units ?)m\b|{NO_NORTH}"
FASTEST_CLIMB = 1.0  # m/s: no glider comes up faster
LEAST_FALL = 60.0  # s: rows of two instruments may be exchanged by less
DEEPER = 10.0  # m from one sample to the next, more than they usually differ
USUAL = 5.0  # times the usual step that a step beside the fall may have
MOST_FALLS = 5  # ; a file with more of them is not in order of time


def measurements_of(data: xarray.Dataset) -> pandas.DataFrame:
    """Return the columns of a file by name, and in `attrs` what it says of them.

    `t_fix`, `lat`, `lon` are of the fixes; `time`, `east`, `north` (steps, m), `speed`,
    `heading` (degrees), `u`, `v`, `number`, `qc`, `magvar`, `depth`, `depth_max` and
    `phase` of the measurements, and with `_before`, `_after` and `_middle` time and place of the
    fixes around their dive and of its middle, where the file has them.  `attrs` has the `north` of
    the heading, "magnetic", "true" or "" where the file does not say, the names of the `steps` and
    of the times of the fixes (`fix_clock`), `own_currents` that stand on a dimension of their own
    (`_currents_elsewhere`), and `notes` on all dives.
    """
    names = known_names(data)
    fixes, t_name = _fix_columns(data, names)
    clock = names["TIME" if "TIME" in names else t_name]
    time = seconds(data, clock).ravel()
    dims = data[clock].dims
    notes = []
    unsaid = not said(data[names[t_name]])
    if unsaid and (unit := unit_of_times(fixes[0], time)):
        fixes[0] = fixes[0] / SMALLER[unit]
        notes.append(f"{t_name} has no units and is read as {unit}, as its numbers are")
    columns: dict[str, Any] = {"time": time}
    used = {}
    for key in QUANTITIES:
        columns[key] = nan
        for name, numbers in columns_of(data, key):
            column = numbers.ravel()
            if key in ANGLES:
                column, doubts = checked_angles(column, key, said(data[name]), name)
                notes += doubts
            if data[name].ndim == 0:  # one number for the mission
                column = column[0]
            elif data[name].dims != dims:
                if key in ("east", "speed", "heading"):
                    notes.append(
                        f"{name} is not read: it does not have the dimensions of {clock}"
                    )
                continue
            if np.isfinite(column).any():
                columns[key], used[key] = column, name
                break
    fix_table = pandas.DataFrame(dict(zip(("t_fix", *PLACE), fixes, strict=True)))
    # as columns, or as rows if fixes have a dimension of their own
    columns_axis = int(data[names[t_name]].dims == dims)
    table = pandas.concat([pandas.DataFrame(columns), fix_table], axis=columns_axis)
    # sums of larger are infinite
    table = _timed(table.where(abs(table) < 1e300).reset_index(drop=True))
    table.attrs = {
        "north": _frame(data[used["heading"]]) if "heading" in used else "",
        "steps": used.get("east", ""),
        "fix_clock": t_name,
        "own_currents": _currents_elsewhere(data, time.size),
        "notes": tuple(notes),
    }
    return table


def _timed(table: pandas.DataFrame) -> pandas.DataFrame:
    """Return the columns with a time for each displacement, between those of its neighbours."""
    lost = table.time.isna() & (table.east.abs() + table.north.abs() > 0)
    times = table.time.fillna(table.t_fix)
    if lost.any() and not times.dropna().is_monotonic_increasing:
        raise DataError(
            f"{lost.sum()} displacements have no time, the first in row {lost.argmax()} (from 0), "
            "and rows or fixes are not in order of time. Give the times, or sort the rows"
        )
    interpolated = times.interpolate(limit_area="inside")
    return table.assign(time=table.time.where(~lost, interpolated))


def _currents_elsewhere(
    data: xarray.Dataset, rows: int
) -> list[tuple[float, float, float]]:
    """Return time (s, NaN if not known), u and v of currents on a dimension of their own."""
    for pair in pairs_of(data, "u", "v"):
        u, v = (data[name] for name in pair)
        if u.ndim != 1 or u.dims != v.dims or u.size == rows:
            continue
        times = (
            seconds(data, name)
            for name in map(str, data.variables)
            if data[name].dims == u.dims and " since " in said(data[name]).lower()
        )
        time = next(times, np.full(u.size, nan))
        columns = (time, *(metres_per_second(data, name) for name in pair))
        return list(zip(*(column.tolist() for column in columns), strict=True))
    return []


def currents_of(
    dives: Sequence[tuple[Fix, Fix]], currents: Sequence[tuple[float, float, float]]
) -> list[tuple[float, float]]:
    """Return the current of each dive, NaN if not known, of currents with times.

    A time is within its dive or in the surfacing after it, whichever of both the file means.
    Without times the currents are of the dives in their order, if they are as many.

    >>> fixes = [(time, 40.0, 8.0) for time in (0.0, 9000.0, 9900.0, 18000.0)]
    >>> dives = [(fixes[0], fixes[1]), (fixes[2], fixes[3])]
    >>> currents_of(dives, [(9100.0, 0.1, 0.2), (18000.0, 0.3, 0.4)])
    [(0.1, 0.2), (0.3, 0.4)]
    >>> currents_of(dives, [(nan, 0.1, 0.2)])
    [(nan, nan), (nan, nan)]
    """
    times = np.array([time for time, _, _ in currents])
    if np.isnan(times).all() and len(currents) == len(dives):
        return [(u, v) for _, u, v in currents]
    dive_currents = []
    for start, end in dives:
        later = (later_start[0] for later_start, _ in dives)
        until = min(t for t in (end[0] + SURFACING, *later) if t >= end[0])
        indices = np.flatnonzero(
            (times >= start[0]) & (times < max(until, end[0] + 1.0))
        )
        dive_currents.append(
            currents[indices[0]][1:] if indices.size == 1 else (nan, nan)
        )
    return dive_currents


def _fix_columns(
    data: xarray.Dataset, file_names: dict[str, str]
) -> tuple[list[np.ndarray], str]:
    """Return time (s), latitude and longitude of the fixes, and the name of that time."""
    latitude = file_names.get("LATITUDE_GPS")
    names = FIXES
    fixed = np.array(True)
    bare = latitude is None or not np.isfinite(values(data, latitude)).any()
    if bare and {*PLACES, FLAG} <= set(file_names):
        names = PLACES
        fixed = values(data, file_names[FLAG]) == 0
    elif "TIME_GPS" not in file_names and "TIME" in file_names:
        names = "TIME", *FIXES[1:]
    missing = [name for name in names if name not in file_names]
    if missing:
        raise DataError(
            f"no variable {' and no '.join(missing)}; OG1 has the fixes there, which are "
            "needed, as is the displacement through the water; a CSV table of dives with both"
        )
    time = seconds(data, file_names[names[0]])
    coordinates = []
    for name in names[1:]:
        degrees = values(data, file_names[name])
        if TO_WEST.fullmatch(said(data[file_names[name]])):
            degrees = -degrees
        coordinates.append(np.where(fixed, degrees, nan))
    dims = {data[file_names[name]].dims for name in names}
    if len(dims) > 1 or time.ndim != 1:
        raise DataError(
            f"{', '.join(names)} have the dimensions {sorted(dims)}; must have the same one. "
            "Give a file for each trajectory, with its fixes in one row"
        )
    return [time, *coordinates], names[0]


def unit_of_times(fixes: np.ndarray, time: np.ndarray) -> str:
    """Return the unit smaller than s in which times of fixes lie among measurements (s), or ''.

    >>> measured = np.array([1.0e9, 1.1e9])
    >>> unit_of_times(np.array([1.01e18, np.nan]), measured), unit_of_times(measured, measured)
    ('nanoseconds', '')
    """
    middle = pandas.Series(fixes).median()
    measured = pandas.Series(time)
    earliest = measured.min() - DAY
    latest = measured.max() + DAY
    return next(
        (unit for unit, size in SMALLER.items() if earliest <= middle / size <= latest),
        "",
    )


def fixes_and_others(of: pandas.DataFrame) -> tuple[list[Fix], np.ndarray]:
    """Return the fixes by time, and times of fixes that are left out.

    These are half a fix, one off the Earth, and one under water: in a row deeper than
    20 m, at a time at which the vehicle cannot be up from there.  Where most fixes are,
    the file is refused.  Where fixes stand under water too, each was repeated until the
    next; the first of each is taken.
    """
    lat, lon, when, time, depth = of[[*PLACE, "t_fix", "time", "depth"]].to_numpy().T
    has_number = np.isfinite(lat) | np.isfinite(lon)
    good = is_fix(lat, lon) & (when > 0)
    rows = np.flatnonzero(good)
    failed = when[has_number & ~good]
    deep = depth[rows] > SURFACE
    if deep.any():
        moved = [np.diff(axis[rows], prepend=np.inf) != 0 for axis in (lat, lon)]
        is_new = moved[0] | moved[1]
        afloat = ~deep | (when[rows] - time[rows] >= depth[rows] / FASTEST_CLIMB)
        wrong = rows[is_new & ~afloat]
        if wrong.size > is_new.sum() / 2:
            raise DataError(
                f"LATITUDE_GPS, LONGITUDE_GPS have {wrong.size} new fixes under water, the first "
                f"in row {wrong[0]} (from 0); fixes are made at the surface: set both to NaN there"
            )
        failed = np.concatenate([failed, when[wrong]])
        rows = rows[is_new & afloat]
    rows = rows[np.argsort(when[rows], kind="stable")]
    return fixes_in(when[rows], lat[rows], lon[rows]), failed


def _frame(heading: xarray.DataArray) -> str:
    """Return which north a heading has, by its attributes; the attributes if they contradict.

    It is true if a correction for the variation was applied, and magnetic if it was not.
    """
    attributes = "; ".join(f"{key} {text}" for key, text in heading.attrs.items())
    words = re.sub(NEITHER, "", re.sub(r"[^\w.,;+]+|_", " ", attributes.lower()))
    unapplied = re.sub(APPLIED, "", words)
    corrected = unapplied != words
    denied = re.search(DENIED, words)
    true = re.search(TRUE, unapplied) or (corrected and not denied)
    magnetic = denied if corrected else re.search(MAGNETIC, unapplied)
    if true and magnetic:
        return attributes
    return "magnetic" if magnetic else "true" if true else ""


def has_ends(data: xarray.Dataset) -> bool:
    """Return whether the file has a fix after the dive for each measurement."""
    return {f"{name}{ENDS['after']}" for name in PLACES} <= set(known_names(data))


def segments_of(of: pandas.DataFrame) -> list[tuple[Fix, Fix, list[str]]]:
    """Return the fixes before and after each dive by time, NaN where there is none, and notes."""
    columns_of_ends = []
    for end in ENDS:
        time, lat, lon = (of[f"{key}_{end}"] for key in ("time", *PLACE))
        good = is_fix(lat, lon) & time.notna()
        columns_of_ends += [column.where(good) for column in (time, lat, lon)]
    if columns_of_ends[0].isna().all():
        raise DataError(
            "TIME_GPS_END, LATITUDE_GPS_END, LONGITUDE_GPS_END have no fix; a dive needs "
            "one before and one after it"
        )
    columns = pandas.concat(columns_of_ends, axis=1)
    segments = []
    for row in columns.groupby("time_after", as_index=False).first().to_numpy():
        # what is there, of each end
        end = row[:3]
        start = row[3:6]
        middle = row[6:9]
        notes = []
        if np.isnan(start).any() and not np.isnan(middle).any():
            start = 2 * middle - end
            notes.append(
                "the fix before the dive computed from the segment's middle and its end"
            )
        segments.append((tuple(start.tolist()), tuple(end.tolist()), notes))
    return segments


def set_back(time: np.ndarray, depth: np.ndarray, fix: np.ndarray) -> list[int]:
    """Return the rows at which a clock was set back; `fix` are times of fixes, NaN elsewhere.

    >>> time = np.array([9000.0, 9060, 9120, 9180, 5640, 5700, 5760])
    >>> set_back(time, np.array([0.0, 10, 20, 30, 40, 30, 20]), np.full(7, nan))
    [4]
    """
    rows = np.flatnonzero(np.isfinite(time) & (depth > LEAST_DEPTH))
    step = np.diff(time[rows])
    sink = np.abs(np.diff(depth[rows]))
    if not (step > 0).any():
        return []
    usual = USUAL * np.median(step[step > 0])
    is_usual = (step > 0) & (step <= usual)
    is_usual = np.pad(is_usual, 1)  # False beside the first and the last step
    fixes_between = np.diff(np.cumsum(np.isfinite(fix))[rows])
    falls = step < -max(LEAST_FALL, usual)
    is_set_back = falls & is_usual[:-2] & is_usual[2:] & (fixes_between == 0)
    is_set_back &= sink <= DEEPER + 2 * np.median(sink)
    return rows[1:][is_set_back].tolist() if falls.sum() <= MOST_FALLS else []


def with_steady_clock(of: pandas.DataFrame, fix_clock: str) -> pandas.DataFrame:
    """Return columns of an OG1 file with a steady `time`, and in `behind` what was added, s.

    `fix_clock` is the name of the times of the fixes, which must not be those of the samples.
    """
    time, depth, fix = (of[name].to_numpy(float) for name in ("time", "depth", "t_fix"))
    afloat = of.lat.notna().to_numpy() & ~(depth > LEAST_DEPTH)
    fix = np.where(afloat, fix, nan)
    behind = np.zeros(time.size)
    for row in set_back(time, depth, fix):
        before = time[:row][np.isfinite(time[:row])]
        late = float(before[-1] - time[row] + np.median(np.abs(np.diff(before))))
        if fix_clock.upper() == "TIME":
            raise DataError(
                f"TIME falls by {late:.0f} s in row {row} (from 0), under water, and has the fixes "
                "too. Correct it there, or give the receiver's times of the fixes in TIME_GPS"
            )
        agrees = np.abs(time - fix) < np.abs(time + behind + late - fix)
        behind[row:][~np.maximum.accumulate(agrees[row:])] += late
    return of.assign(time=time + behind, behind=behind)
