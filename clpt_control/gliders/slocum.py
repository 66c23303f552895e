"""Slocum gliders: dives from the files of the flight computer (`slocum_file`).

A file is a segment of a mission; a dive is of the file with its end.  Where the file
does not hold the fix before the dive, those before it, in the same folder, are joined to
it.  A dive lies between two fixes (m_gps_lat, m_gps_lon in ddmm.mmm, where m_gps_status
is 0) with a depth of more than 5 m between them.

The glider's dead reckoning is a place at each time: m_lat, m_lon, which it turned to
true north itself, else m_x_lmc, m_y_lmc, whose y axis is magnetic north.  It is logged
every ten minutes in some files; from the last one to the end of the dive it goes on
with the median speed v along the heading h,

    dr = (last place - fix) + v sum_i (t_i - t_{i-1}) (sin(h_i + D), cos(h_i + D)).

D is the variation, degrees east: -m_gps_mag_var, which is positive west, else IGRF's.

The places of m_lat, m_lon are relative to the fix before the dive, to which the glider had set
them; those of m_x_lmc, m_y_lmc to theirs when it dived.

The glider's own current w (m_water_vx, m_water_vy at the end of the dive, on magnetic
axes) is its miss over the time under water.  A glider may add w0, of the dive before, to
its dead reckoning (u_use_current_correction); whether it did is seen in w: without it

    (displacement between the fixes - dr)/duration = w,   with it w - w0,

and then w0 times the time under water is taken off dr.
"""

from math import hypot, nan
from pathlib import Path

import numpy as np

from ..geodesy import displacement
from .dives import LEAST_DEPTH, Dive, Fix, Skipped, Three, dive_between, is_fix, joined_dives
from .magnetic import variation
from .samples import deepest, hole_under_water
from .slocum_file import MAGIC as MAGIC
from .slocum_file import SUFFIXES as SUFFIXES
from .slocum_file import Segment, Series, read_segment

SHORT = 60.0  # s of a dive's end without a place that are left alone
CLEAR = 0.03  # m/s: from here on it is seen whether a current was added
Of = dict[str, Series]
OWN_CURRENT = 1800.0  # s after the fix in which the glider has worked its current out
YEARS = (0.0, 7.3e9)  # s since 1970: to 2200
NAMES = (
    "m_gps_lat",
    "m_gps_lon",
    "m_gps_status",
    "m_gps_mag_var",
    "m_lat",
    "m_lon",
    "m_x_lmc",
    "m_y_lmc",
    "m_water_vx",
    "m_water_vy",
    "m_depth",
    "m_heading",
    "u_use_current_correction",
)


def degrees(ddmm: np.ndarray) -> np.ndarray:
    """Return degrees of ddmm.mmm, NaN where it has 60 minutes or more.

    >>> degrees(np.array([5138.0368, -12818.26, 69696969.0])).round(5)
    array([  51.63395, -128.30433,          nan])
    """
    whole, minutes = np.divmod(np.abs(ddmm), 100.0)
    return np.where((minutes < 60.0) & (whole < 400.0), np.sign(ddmm) * (whole + minutes / 60), nan)


def between(series: Series, start: float, end: float) -> Series:
    """Return what was logged after a time, to another."""
    rows = (series[0] > start) & (series[0] <= end)
    return series[0][rows], series[1][rows]


def turned(water: tuple[float, float], east_of_north: float) -> tuple[float, float]:
    """Turn a vector from axes along magnetic north to true ones.

    >>> east, north = turned((0.0, 1.0), 90.0)
    >>> round(east), round(north)
    (1, 0)
    """
    sine, cosine = np.sin(np.radians(east_of_north)), np.cos(np.radians(east_of_north))
    x, y = water
    return float(x * cosine + y * sine), float(-x * sine + y * cosine)


def water_between(of: Of, start: float, end: float, first: bool) -> tuple[float, float]:
    """Return the first or the last own current between two times, NaN where there is none."""
    time, x = between(of["m_water_vx"], start, end)
    also, y = between(of["m_water_vy"], start, end)
    _, at, other = np.intersect1d(time, also, return_indices=True)
    if not at.size:
        return nan, nan
    k = 0 if first else -1
    return float(x[at[k]]), float(y[other[k]])


def dead_reckoning(
    of: Of, start: Fix, wet: np.ndarray, east_of_north: float
) -> tuple[tuple[np.ndarray, np.ndarray, np.ndarray] | None, str]:
    """Return time since the fix (s), metres east and north of it to the end under water; or why."""
    time, east, north = _places(of, start, wet, east_of_north)
    if time.size < 2:
        return None, "fewer than two places of dead reckoning (m_lat, m_lon or m_x_lmc, m_y_lmc)"
    steps = np.diff(time)
    speed = float(np.median(np.hypot(np.diff(east), np.diff(north)) / steps))
    since = np.concatenate([[0.0], time - start[0]])
    east, north = np.concatenate([[0.0], east]), np.concatenate([[0.0], north])
    rest = wet[-1] - time[-1]
    if rest > SHORT:
        log, heading = between(of["m_heading"], start[0], wet[-1] + SHORT)
        if not log.size:
            return None, f"no heading for the last {rest:.0f} s under water"
        later = np.append(log[(log > time[-1]) & (log < wet[-1])], wet[-1])
        h = np.radians(east_of_north) + np.interp(later, log, np.unwrap(heading))
        step = speed * np.diff(later, prepend=time[-1])
        since = np.append(since, later - start[0])
        east = np.append(east, east[-1] + np.cumsum(step * np.sin(h)))
        north = np.append(north, north[-1] + np.cumsum(step * np.cos(h)))
    return (since, east, north), ""


def _places(
    of: Of, start: Fix, wet: np.ndarray, east_of_north: float
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return times of the dead reckoning and its places east and north of the fix, m."""
    pairs = []
    for names in (("m_lat", "m_lon"), ("m_x_lmc", "m_y_lmc")):
        first, second = (between(of[name], start[0] - SHORT, wet[-1]) for name in names)
        time, at, other = np.intersect1d(first[0], second[0], return_indices=True)
        pairs.append((time, first[1][at], second[1][other]))
    (time, lat, lon), (times, x, y) = pairs
    lat, lon = degrees(lat), degrees(lon)
    good = np.isfinite(lat) & np.isfinite(lon) & (time > start[0])
    if good.sum() >= 2:
        moved = [displacement(*start[1:], a, b) for a, b in zip(lat[good], lon[good], strict=True)]
        east, north = np.array(moved).T
        return time[good], east, north
    if times.size < 2:
        return np.empty(0), np.empty(0), np.empty(0)
    later = max(times[0] - max(wet[0], start[0]), 0.0)  # it was reset to the fix until the dive
    origin = [
        np.interp(start[0], times, c) - np.diff(c)[0] / np.diff(times)[0] * later for c in (x, y)
    ]
    rows = times > start[0]
    moved = [
        turned(one, east_of_north)
        for one in zip(x[rows] - origin[0], y[rows] - origin[1], strict=True)
    ]
    east, north = np.array(moved).reshape(-1, 2).T
    return times[rows], east, north


def was_added(
    of: Of,
    gps: tuple[float, float],
    track: tuple[np.ndarray, np.ndarray, np.ndarray],
    duration: float,
    current: tuple[float, float],
    added: tuple[float, float],
) -> bool:
    """Whether the current of the dive before is in the dead reckoning."""
    if not np.isfinite(added).all():
        return False
    miss = [(gps[k] - track[k + 1][-1]) / duration for k in (0, 1)]
    without = hypot(miss[0] - current[0], miss[1] - current[1])
    with_it = hypot(miss[0] + added[0] - current[0], miss[1] + added[1] - current[1])
    if hypot(*added) > CLEAR and np.isfinite(without):
        return with_it < without
    used = of["u_use_current_correction"][1]
    return bool(used.size and used[-1] == 1)


def dives_of(path: Path) -> tuple[list[Dive], list[Skipped]]:
    """Return the dives that end in a file."""
    own = read_segment(path, NAMES)
    of, found = joined_dives(path, own, lambda one: read_segment(one, NAMES), _joined, _seen)
    own_fixes = set(own.of["m_gps_lat"][0].tolist()) if "m_gps_lat" in own.of else set()
    return [_dive(of, own, three) for three in found if three[2][0] in own_fixes], []


def _joined(parts: list[Segment]) -> Of:
    """Return the sensors of segments by time; what has no time, or no number, is left out."""
    of: Of = {}
    for name in NAMES:
        found = [part.of[name] for part in parts if name in part.of]
        time, value = (
            np.concatenate([series[k] for series in found] or [np.empty(0)]) for k in (0, 1)
        )
        good = np.isfinite(value) & (time > YEARS[0]) & (time < YEARS[1])
        time, value = time[good], value[good]
        _, first = np.unique(time, return_index=True)
        of[name] = time[first], value[first]
    return of


def _seen(of: Of) -> tuple[list[Fix], np.ndarray]:
    """Return the valid fixes and the times under water."""
    time, at, other = np.intersect1d(of["m_gps_lat"][0], of["m_gps_lon"][0], return_indices=True)
    lat, lon = degrees(of["m_gps_lat"][1][at]), degrees(of["m_gps_lon"][1][other])
    failed = set(of["m_gps_status"][0][of["m_gps_status"][1] != 0].tolist())
    fixes = [
        (t, a, b)
        for t, a, b in zip(time.tolist(), lat.tolist(), lon.tolist(), strict=True)
        if is_fix(a, b) and t not in failed
    ]
    when, depth = of["m_depth"]
    return fixes, when[depth > LEAST_DEPTH]


def _dive(of: Of, own: Segment, fixes: Three) -> Dive:
    """Make the dive between two fixes that is under water at some times."""
    _, start, end = fixes
    notes = list(own.notes)
    east_of_north = _variation(of, start)
    time, depth = between(of["m_depth"], start[0], end[0])
    wet = time[depth > LEAST_DEPTH]
    duration = end[0] - start[0]
    track, why = dead_reckoning(of, start, wet, east_of_north)
    hole = hole_under_water(time - start[0], depth, duration)
    if why or hole:
        notes.append(why or hole)
    gps = displacement(*start[1:], *end[1:])
    current = turned(water_between(of, end[0] - SHORT, end[0] + OWN_CURRENT, True), east_of_north)
    if track is not None and not hole:
        added = turned(water_between(of, -np.inf, wet[0], False), east_of_north)
        if was_added(of, gps, track, duration, current, added):
            under = np.clip(track[0] - (wet[0] - start[0]), 0.0, None)
            track = track[0], track[1] - added[0] * under, track[2] - added[1] * under
            notes.append(
                f"the glider's dead reckoning holds the current of the dive before, "
                f"{hypot(*added):.3f} m/s: taken off"
            )
        since, east, north = track
        track = (
            np.append(since, duration),
            np.append(east, east[-1]),
            np.append(north, north[-1]),
        )
    else:
        track = None
    return dive_between(
        own.number,
        fixes,
        (nan, nan) if track is None else (float(track[1][-1]), float(track[2][-1])),
        dac_east=None if np.isnan(current[0]) else current[0],
        dac_north=None if np.isnan(current[1]) else current[1],
        magvar=east_of_north,
        depth_max=deepest(depth),
        track=track,
        notes=tuple(notes),
    )


def _variation(of: Of, fix: Fix) -> float:
    """Return the variation at a fix, degrees east."""
    time, west = of["m_gps_mag_var"]
    rows = np.flatnonzero(time <= fix[0] + SHORT)
    if rows.size and abs(west[rows[-1]]) < np.pi:
        return float(-np.degrees(west[rows[-1]]))
    return float(variation(*fix)[0])
