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

The glider's own current w (m_water_vx, m_water_vy at the end of the dive, on magnetic
axes) is its miss over the time under water.  A glider may add w0, of the dive before, to
its dead reckoning (u_use_current_correction); whether it did is seen in w: without it

    (displacement between the fixes - dr)/duration = w,   with it w - w0,

and then w0 times the time under water is taken off dr.
"""

import re
from math import hypot, nan
from pathlib import Path

import numpy as np

from ..errors import DataError
from ..geodesy import displacement, is_place
from .dives import Dive, Fix, Skipped, compared, make_dive
from .magnetic import variation
from .samples import deepest, hole_under_water
from .slocum_file import MAGIC as MAGIC
from .slocum_file import SUFFIXES as SUFFIXES
from .slocum_file import Segment, Series, read_segment

BACK = 6  # files before one that are joined to it at most
LEAST_DEPTH = 5.0  # m
LEAST_GAP = 300.0  # s between two fixes with a dive between them
OWN_CURRENT = 1800.0  # s after the fix in which the glider has worked its current out
SHORT = 60.0  # s of a dive's end without a place that are left alone
YEARS = (0.0, 7.3e9)  # s since 1970: to 2200
CLEAR = 0.03  # m/s: from here on it is seen whether a current was added
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
Of = dict[str, Series]


def dives_of(path: Path) -> tuple[list[Dive], list[Skipped]]:
    """Return the dives that end in a file."""
    own = read_segment(path, NAMES)
    parts = [own]
    for before in reversed(files_before(path)):
        if _has_start(_joined(parts)):
            break
        try:
            parts.insert(0, read_segment(before, NAMES))
        except DataError:  # named where it is read for itself
            continue
    return _dives(_joined(parts), own), []


def files_before(path: Path) -> list[Path]:
    """Return the files before one of the same vehicle in its folder, the nearest last."""
    try:
        inside = [
            file
            for file in path.parent.iterdir()
            if file.suffix.lower() == path.suffix.lower() and not file.name.startswith(".")
        ]
    except OSError:
        return []
    vehicle, order = _order(path)
    known = sorted((_order(file)[1], file) for file in inside if _order(file)[0] == vehicle)
    return [file for place, file in known if place < order][-BACK:]


def _order(path: Path) -> tuple[str, list[int]]:
    """Return the vehicle of a name such as rosie_713-2019-166-0-156 or 00970156, and its place."""
    found = re.fullmatch(r"(.*?)-?(\d+)-(\d+)-(\d+)-(\d+)", path.stem)
    if found:
        return found[1], [int(found[k]) for k in range(2, 6)]
    return re.sub(r"\d", "", path.stem), [int(number) for number in re.findall(r"\d+", path.stem)]


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


def _has_start(of: Of) -> bool:
    """Whether a fix stands before the first time under water."""
    fixes, wet = _fixes(of), _wet(of)
    return bool(fixes) and (wet.size == 0 or fixes[0][0] <= wet[0])


def _wet(of: Of) -> np.ndarray:
    time, depth = of["m_depth"]
    return time[depth > LEAST_DEPTH]


def _fixes(of: Of) -> list[Fix]:
    """Return the valid fixes by time."""
    time, at, other = np.intersect1d(of["m_gps_lat"][0], of["m_gps_lon"][0], return_indices=True)
    lat, lon = degrees(of["m_gps_lat"][1][at]), degrees(of["m_gps_lon"][1][other])
    failed = set(of["m_gps_status"][0][of["m_gps_status"][1] != 0].tolist())
    return [
        (t, a, b)
        for t, a, b in zip(time.tolist(), lat.tolist(), lon.tolist(), strict=True)
        if is_place(a, b) and not (a == b == 0.0) and t not in failed
    ]


def degrees(ddmm: np.ndarray) -> np.ndarray:
    """Return degrees of ddmm.mmm, NaN where it has 60 minutes or more.

    >>> degrees(np.array([5138.0368, -12818.26, 69696969.0])).round(5)
    array([  51.63395, -128.30433,          nan])
    """
    whole, minutes = np.divmod(np.abs(ddmm), 100.0)
    return np.where((minutes < 60.0) & (whole < 400.0), np.sign(ddmm) * (whole + minutes / 60), nan)


def _dives(of: Of, own: Segment) -> list[Dive]:
    fixes, wet = _fixes(of), _wet(of)
    own_fixes = set(own.of["m_gps_lat"][0].tolist()) if "m_gps_lat" in own.of else set()
    when = np.array([fix[0] for fix in fixes])
    gaps = [
        k
        for k in range(len(fixes) - 1)
        if when[k + 1] - when[k] > LEAST_GAP
        and np.searchsorted(wet, when[k], "right") < np.searchsorted(wet, when[k + 1], "right")
    ]
    dives: list[Dive] = []
    surfaced = 0  # first fix since the dive before
    for k in gaps:
        before = fixes[surfaced] if k > surfaced else None
        surfaced = k + 1
        if fixes[k + 1][0] in own_fixes:
            under = wet[(wet > when[k]) & (wet <= when[k + 1])]
            dives.append(_dive(of, own, (before, fixes[k], fixes[k + 1]), under))
    return dives


def _dive(of: Of, own: Segment, fixes: tuple[Fix | None, Fix, Fix], wet: np.ndarray) -> Dive:
    """Make the dive between two fixes that is under water at some times."""
    before, start, end = fixes
    notes = list(own.notes)
    east_of_north = _variation(of, start)
    time, depth = _between(of["m_depth"], start[0], end[0])
    duration = end[0] - start[0]
    track, why = _dead_reckoning(of, start, wet, east_of_north)
    hole = hole_under_water(time - start[0], depth, duration)
    if why or hole:
        notes.append(why or hole)
    gps = displacement(*start[1:], *end[1:])
    current = _turned(_last_water(of, end[0] - SHORT, end[0] + OWN_CURRENT, True), east_of_north)
    if track is not None and not hole:
        added = _turned(_last_water(of, -np.inf, wet[0], False), east_of_north)
        if _was_added(of, gps, track, duration, current, added):
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
    return compared(
        make_dive(
            own.number,
            start,
            end,
            (nan, nan) if track is None else (float(track[1][-1]), float(track[2][-1])),
            **dict(zip(("t_gps1", "lat_gps1", "lon_gps1"), before or (None,) * 3, strict=True)),
            dac_east=None if np.isnan(current[0]) else current[0],
            dac_north=None if np.isnan(current[1]) else current[1],
            magvar=east_of_north,
            depth_max=deepest(depth),
            track=track,
            notes=tuple(notes),
        )
    )


def _between(series: Series, start: float, end: float) -> Series:
    rows = (series[0] > start) & (series[0] <= end)
    return series[0][rows], series[1][rows]


def _variation(of: Of, fix: Fix) -> float:
    """Return the variation at a fix, degrees east."""
    time, west = of["m_gps_mag_var"]
    rows = np.flatnonzero(time <= fix[0] + SHORT)
    if rows.size and abs(west[rows[-1]]) < np.pi:
        return float(-np.degrees(west[rows[-1]]))
    return float(variation(*fix)[0])


def _turned(water: tuple[float, float], east_of_north: float) -> tuple[float, float]:
    """Turn a vector from axes along magnetic north to true ones.

    >>> east, north = _turned((0.0, 1.0), 90.0)
    >>> round(east), round(north)
    (1, 0)
    """
    sine, cosine = np.sin(np.radians(east_of_north)), np.cos(np.radians(east_of_north))
    x, y = water
    return float(x * cosine + y * sine), float(-x * sine + y * cosine)


def _last_water(of: Of, start: float, end: float, first: bool) -> tuple[float, float]:
    """Return the first or the last own current between two times, NaN where there is none."""
    time, x = _between(of["m_water_vx"], start, end)
    also, y = _between(of["m_water_vy"], start, end)
    _, at, other = np.intersect1d(time, also, return_indices=True)
    if not at.size:
        return nan, nan
    k = 0 if first else -1
    return float(x[at[k]]), float(y[other[k]])


def _dead_reckoning(
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
        log, heading = _between(of["m_heading"], start[0], wet[-1] + SHORT)
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
        first, second = (_between(of[name], start[0] - SHORT, wet[-1]) for name in names)
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
    turned = [
        _turned(one, east_of_north)
        for one in zip(x[rows] - origin[0], y[rows] - origin[1], strict=True)
    ]
    east, north = np.array(turned).reshape(-1, 2).T
    return times[rows], east, north


def _was_added(
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
