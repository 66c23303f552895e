"""Slocum gliders: dives from the files of the flight computer (`slocum_file`).

A file is a segment of a mission; a dive is of the file with its end.  Where the file
does not hold the fix before the dive, those before it, in the same folder, are merged
with it.  A dive lies between two fixes (m_gps_lat, m_gps_lon in ddmm.mmm, where m_gps_status
is 0) with a depth of more than 5 m between them.

The glider's dead reckoning is a place at each time: m_lat, m_lon, which it rotated to
true north itself, else m_x_lmc, m_y_lmc, whose y axis is magnetic north.  It is logged
every ten minutes in some files; from the last one to the end of the dive it goes on
with the median speed v along the heading h,

    dr = (last place - fix) + v sum_i (t_i - t_{i-1}) (sin(h_i + D), cos(h_i + D)).

D is the variation, degrees east: -m_gps_mag_var, which is positive west, else IGRF's.

The places of m_lat, m_lon are relative to the fix before the dive, to which the glider had set
them; those of m_x_lmc, m_y_lmc to theirs when it dived.

The glider's own current w (m_water_vx, m_water_vy after the dive, on magnetic axes) is its
miss over the time under water.  A glider may add w of the dive before to its dead reckoning
(u_use_current_correction), and then that times the time under water is taken off.  Dead reckoning
that contradicts w is not used: dr is the displacement between the fixes less w times the duration.
Where neither is known a dive that may hold a current is not used.

The plan of the next dive is the way to the waypoint c_wpt_lat, c_wpt_lon (ddmm.mmm), else
c_heading (rad from magnetic north), as last logged.
"""

from dataclasses import replace
from math import isfinite, nan
from pathlib import Path

import numpy as np
import pandas

from ...base.errors import DataError
from ...base.geodesy import displacement
from .dive_fields import HEADINGS
from .dives import (
    CONTRADICTS,
    LEAST_DEPTH,
    Dive,
    DivesOrSkipped,
    Fix,
    Three,
    ThroughWater,
    cut_dives,
    dive_between,
    fixes_in,
    planned_course,
)
from .mission_files import dives_across_files, logged
from .samples import (
    LARGEST_HOLE,
    LONGEST_GAP,
    LONGEST_WAIT,
    SURFACE,
    deepest,
    degrees,
    hole_under_water,
    track_of,
    turned,
    variation,
    within,
)
from .slocum_file import FIX, LOCAL, PLACE, PLAN, WATER, Segment, read_segment
from .slocum_file import MAGIC as MAGIC

SHORT = 60.0  # s of a dive's end without a place that are left alone
CORRECTS = "the glider corrects for the current itself (u_use_current_correction)"
OWN_CURRENT = 1800.0  # s after the fix in which the glider has worked its current out


def rows_between(of: pandas.DataFrame, start: float, end: float) -> pandas.DataFrame:
    """Return what was logged after a time, to another."""
    return of[(of.index > start) & (of.index <= end)]


def own_currents(
    of: pandas.DataFrame, dived: float, end: float, east_of_north: float
) -> np.ndarray:
    """Return the own current of the dive before and of that to a fix, (2, 2), NaN if not known.

    A file repeats the former in its first cycle until the latter is worked out.
    """
    time, *water = logged(of, *WATER)
    currents = np.column_stack([[nan, nan], turned(water, east_of_north)])
    last = currents[:, np.searchsorted(time, end - SHORT, "right")]
    known = int(np.searchsorted(time, dived, "right"))
    if known and time[known - 1] < dived - LONGEST_WAIT:
        known = 0  # it is that of an earlier dive
    after = currents[:, 1:][:, (time > end - SHORT) & (time <= end + OWN_CURRENT)]
    new = after[:, (after != last[:, None]).any(axis=0)]
    now = new[:, 0] if new.size else np.full(2, nan)
    return np.array([currents[:, known], now])


def dead_reckoning(
    of: pandas.DataFrame, start: Fix, wet: np.ndarray, east_of_north: float
) -> tuple[np.ndarray | None, str]:
    """Return time since the fix (s), metres east and north of it to the end under water; or why."""
    time, *positions = _positions(of, start, wet, east_of_north)
    if time.size < 2:
        return (
            None,
            "fewer than two places of dead reckoning (m_lat, m_lon or m_x_lmc, m_y_lmc)",
        )
    speed = float(np.median(np.hypot(*np.diff(positions)) / np.diff(time)))
    path = np.hstack([np.zeros((3, 1)), [time - start[0], *positions]])
    remaining = wet[-1] - time[-1]
    if remaining > max(LONGEST_GAP, LARGEST_HOLE * (wet[-1] - start[0])):
        return None, f"no place for the last {remaining:.0f} s under water"
    if remaining > SHORT:
        log, heading = logged(rows_between(of, start[0], wet[-1] + SHORT), "m_heading")
        _, outside = within(np.degrees(heading), HEADINGS)
        if not log.size or 2 * outside.sum() > log.size:
            why = f"no heading for the last {remaining:.0f} s under water"
            return None, why + ": m_heading is not in radians" * bool(log.size)
        log, heading = log[~outside], heading[~outside]
        later = np.append(log[(log > time[-1]) & (log < wet[-1])], wet[-1])
        h = np.radians(east_of_north) + np.interp(later, log, np.unwrap(heading))
        step = speed * np.diff(later, prepend=time[-1])
        flown = np.cumsum(step * [np.sin(h), np.cos(h)], axis=1)
        path = np.hstack([path, [later - start[0], *(path[1:, -1:] + flown)]])
        if remaining > LARGEST_HOLE * (wet[-1] - start[0]):
            return path, f"the last {remaining:.0f} s under water are of the heading"
    return path, ""


def _positions(
    of: pandas.DataFrame, start: Fix, wet: np.ndarray, east_of_north: float
) -> np.ndarray:
    """Return times of the dead reckoning and its places east and north of the fix, m, (3, n)."""
    rows_near = rows_between(of, start[0] - SHORT, wet[-1])
    time, lat, lon = logged(rows_near, *PLACE)
    times, x, y = logged(rows_near, *LOCAL)
    lat, lon = degrees(lat), degrees(lon)
    # a place that is held to the last digit is no new one
    is_new = np.append(True, (np.diff(lat) != 0) | (np.diff(lon) != 0))[: time.size]
    good = np.isfinite(lat) & np.isfinite(lon) & (time > start[0]) & is_new
    if good.sum() >= 2:
        moved = [
            displacement(*start[1:], a, b)
            for a, b in zip(lat[good], lon[good], strict=True)
        ]
        return np.array([time[good], *np.transpose(moved)])
    if times.size < 2:
        return np.empty((3, 0))
    # it was reset to the fix until the dive
    later = max(times[0] - max(wet[0], start[0]), 0.0)
    origin = [
        np.interp(start[0], times, c) - np.diff(c)[0] / np.diff(times)[0] * later
        for c in (x, y)
    ]
    rows = times > start[0]
    positions = turned((x[rows] - origin[0], y[rows] - origin[1]), east_of_north)
    return np.array([times[rows], *positions])


def reconciled(
    path: np.ndarray,
    dived: float,
    gps: np.ndarray,
    duration: float,
    own_currents: np.ndarray,
    used: float,
) -> tuple[np.ndarray | None, np.ndarray, str]:
    """Return a path through the water that agrees with the own current, its end, and a note.

    `own_currents` has the current of the dive before and of this one. `used` is 1 if the glider
    reports that it added the former, which is then taken off from `dived`, s after the fix. A path
    that contradicts the latter, or may hold the former, is None.
    """
    before, now = own_currents
    note = ""
    size = float(np.hypot(*before))
    if used == 1 and np.isfinite(size):
        under = np.clip(path[0] - dived, 0.0, None)
        path = np.vstack([path[:1], path[1:] - np.outer(before, under)])
        note = f"the current of the dive before, {size:.3f} m/s, is taken off"
    end = path[1:, -1]
    if np.isfinite(now).all():
        off = float(np.hypot(*((gps - end) / duration - now)))
        if off <= CONTRADICTS:
            return path, end, note
        note = f"dead reckoning contradicts the glider's own current by {1e3 * off:.0f} mm/s"
        return None, gps - now * duration, f"{note}: not used, that current is"
    if used == 0 or note:
        return path, end, note
    note = (
        "no file says whether the glider's dead reckoning holds a current of its own, so that the "
        "learned current may be 0. Give u_use_current_correction, m_water_vx and m_water_vy"
    )
    if used == 1 or size > CONTRADICTS:
        return None, np.full(2, nan), f"{note}: not used"
    return path, end, note


def dives_of(path: Path) -> DivesOrSkipped:
    """Return the dives that end in a file."""
    segment = read_segment(path)
    log = segment.of
    of, found, unknown = dives_across_files(
        path, log, lambda file: read_segment(file).of, _fixes_and_wet
    )
    fixes, _ = _fixes_and_wet(of)
    if of.m_depth.isna().all() and cut_dives(fixes, None):
        raise DataError(
            f"{path}: the Slocum file has fixes and no m_depth, by which dives are found. Give "
            "files with m_depth, such as .dbd or .mbd, or a CSV table of dives"
        )
    dives = [_dive(of, segment, fixes_of_dive, lost) for fixes_of_dive, lost in found]
    if len(dives) > 1:
        labels = [
            f"dive {k} of {len(dives)} in {path.name}" for k in range(1, len(dives) + 1)
        ]
        dives = [
            replace(d, notes=(w, *d.notes)) for d, w in zip(dives, labels, strict=True)
        ]
    return [*unknown, *dives]


def _fixes_and_wet(of: pandas.DataFrame) -> tuple[list[Fix], np.ndarray]:
    """Return the valid fixes and the times under water."""
    time, *coordinates = logged(of[of.m_gps_status.fillna(0.0) == 0.0], *FIX[:2])
    wet = of.index[of.m_depth > LEAST_DEPTH].to_numpy()
    return fixes_in(time, *map(degrees, coordinates)), wet


def _dive(of: pandas.DataFrame, segment: Segment, fixes: Three, lost: str) -> Dive:
    """Make the dive between two fixes that is under water at some times.

    Rows that are `lost` leave its displacement unknown.
    """
    _, start, end = fixes
    notes = list(segment.notes)
    east_of_north = _variation(of, start)
    time, depth, note = _depths(rows_between(of, start[0], end[0]))
    notes.append(note)
    wet = time[(depth > LEAST_DEPTH) | np.isnan(depth)]
    duration = end[0] - start[0]
    path, why = dead_reckoning(of, start, wet, east_of_north)
    since = time - start[0]
    hole, large = hole_under_water(
        since, (since, depth), duration, of.attrs["surfacing"]
    )
    notes.append(lost or why or hole)
    if large or lost:
        path = None
    currents = own_currents(of, wet[0], end[0], east_of_north)
    used = of.u_use_current_correction[: end[0]].ffill().iloc[-1]
    notes += [CORRECTS] if used == 1 else []
    total = np.full(2, nan)
    if path is not None:
        gps = np.array(displacement(*start[1:], *end[1:]))
        path, total, note = reconciled(
            path, wet[0] - start[0], gps, duration, currents, used
        )
        notes.append(note)
    track = None if path is None else track_of(path, duration)
    return dive_between(
        segment.number,
        fixes,
        ThroughWater((float(total[0]), float(total[1])), track),
        dac_east=currents[1, 0],
        dac_north=currents[1, 1],
        magvar=east_of_north,
        depth_max=deepest(depth),
        next_course=_next_course(of, end, east_of_north),
        notes=tuple(filter(None, notes)),
    )


def _depths(log: pandas.DataFrame) -> tuple[np.ndarray, np.ndarray, str]:
    """Return times and depths of a dive, NaN where only its place is known, and a note.

    Some gliders log m_depth on the descent only.  Where it is missing for more than `LONGEST_GAP`
    after a deep sample, the places in between are under water too.
    """
    time, depth = logged(log, "m_depth")
    position_times = log[[*PLACE, *LOCAL]].dropna(how="all").index.to_numpy()
    k = np.searchsorted(time, position_times, "right") - 1
    gaps = np.diff(time, append=log.index[-1])
    added_times = position_times[
        (k >= 0) & (depth[k] > SURFACE) & (gaps[k] > LONGEST_GAP)
    ]
    added_times = added_times[~np.isin(added_times, time)]
    if not added_times.size:
        return time, depth, ""
    last = depth[np.searchsorted(time, added_times[0]) - 1]
    columns = (
        np.append(time, added_times),
        np.append(depth, np.full(added_times.size, nan)),
    )
    order = np.argsort(columns[0], kind="stable")
    note = f"no m_depth after {last:.0f} m, but places: taken as under water"
    return columns[0][order], columns[1][order], note


def _next_course(of: pandas.DataFrame, end: Fix, east_of_north: float) -> float | None:
    """Return the course of the next dive, degrees: to the last waypoint, else as last commanded."""
    lat, lon, heading = of.loc[: end[0] + OWN_CURRENT, [*PLAN]].ffill().to_numpy()[-1]
    if isfinite(lat) and isfinite(lon):
        return planned_course(end, degrees(np.array([lat, lon])).tolist())
    if 0.0 <= heading < 2 * np.pi:
        return (float(np.degrees(heading)) + east_of_north) % 360.0
    return None


def _variation(of: pandas.DataFrame, fix: Fix) -> float:
    """Return the variation at a fix, degrees east."""
    west = of.m_gps_mag_var[: fix[0] + SHORT].ffill().iloc[-1]
    return float(-np.degrees(west)) if abs(west) < np.pi else variation(*fix)
