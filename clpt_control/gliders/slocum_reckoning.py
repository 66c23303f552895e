"""A Slocum's dead reckoning and its own current, on axes along true north (`slocum`).

The places of m_lat, m_lon are relative to the fix before the dive, to which the glider had set
them; those of m_x_lmc, m_y_lmc to theirs when it dived.
"""

from math import hypot, nan

import numpy as np

from ..geodesy import displacement
from .dives import Fix
from .slocum_file import Series

SHORT = 60.0  # s of a dive's end without a place that are left alone
CLEAR = 0.03  # m/s: from here on it is seen whether a current was added
Of = dict[str, Series]


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
