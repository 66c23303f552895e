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

from math import hypot, nan
from pathlib import Path

import numpy as np

from ..errors import DataError
from ..geodesy import displacement, is_place
from .dives import Dive, Fix, Skipped, compared, make_dive
from .magnetic import variation
from .samples import deepest, hole_under_water
from .segments import files_before
from .slocum_file import MAGIC as MAGIC
from .slocum_file import SUFFIXES as SUFFIXES
from .slocum_file import Segment, read_segment
from .slocum_reckoning import (
    SHORT,
    Of,
    between,
    dead_reckoning,
    degrees,
    turned,
    was_added,
    water_between,
)

LEAST_DEPTH = 5.0  # m
LEAST_GAP = 300.0  # s between two fixes with a dive between them
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
    time, depth = between(of["m_depth"], start[0], end[0])
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


def _variation(of: Of, fix: Fix) -> float:
    """Return the variation at a fix, degrees east."""
    time, west = of["m_gps_mag_var"]
    rows = np.flatnonzero(time <= fix[0] + SHORT)
    if rows.size and abs(west[rows[-1]]) < np.pi:
        return float(-np.degrees(west[rows[-1]]))
    return float(variation(*fix)[0])
