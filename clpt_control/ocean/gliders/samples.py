"""Samples of a dive: steps summed to dead reckoning, and magnetic variation.

A step is the displacement since the sample before, so a track is their running sum, from rest at
the fix before the dive to rest at the fix after it.  A step that is not finite, or longer than
5 m/s and 100 m allow, is none: a few of them are filled from their neighbours.

Magnetic variation is how far a compass points from true north, by IGRF,

    D = atan2(B_east, B_north), degrees, positive east

of the International Geomagnetic Reference Field, 14th generation (IAGA, 2024), whose
coefficients `ppigrf` carries.  Good to about half a degree at sea; near the magnetic poles no
compass is of use.
"""

from collections.abc import Sequence
from dataclasses import replace
from datetime import UTC, datetime
from math import isfinite, nan

import numpy as np
from numpy.typing import ArrayLike

from ...base.errors import import_optional
from .dives import Dive, ThroughWater, Track
from .usable_dives import FASTEST

SURFACE = 20.0  # m: a vehicle last seen above needs no samples until its fix
LARGEST_HOLE = 0.1  # share of a dive that may be without samples under water
LONGEST_GAP = 900.0  # s between samples that is mentioned
LONGEST_STEP = 100.0  # m, beyond what is possible at 5 m/s
REPAIRABLE = 0.05  # largest share of samples that is filled from their neighbours
DEEPEST = 12000.0  # m: no sea is deeper


def fill(time: np.ndarray, steps: np.ndarray, bad: np.ndarray) -> np.ndarray:
    """Fill steps (m) where bad by the speed of their neighbours; times (s) increase.

    >>> time = np.array([0.0, 10.0, 20.0, 40.0])
    >>> fill(time, np.array([0.0, 2.0, np.nan, 8.0]), np.array([False, False, True, False]))
    array([0. , 2. , 2.66..., 8. ])
    """
    since = np.diff(time, prepend=time[0])
    good = ~bad & (since > 0)
    speed = (
        np.interp(time, time[good], steps[good] / since[good])
        if good.any()
        else 0 * time
    )
    return np.where(bad, speed * since, steps)


def track_of(since: np.ndarray, steps: np.ndarray, duration: float) -> Track:
    """Sum steps (m) at times since the fix before the dive (s) to a track of the whole dive."""
    path = np.vstack([since, np.cumsum(steps, axis=1)])
    if since[0] > 0:
        path = np.hstack([np.zeros((3, 1)), path])
    if since[-1] < duration:
        path = np.hstack([path, [[duration], *path[1:, -1:]]])
    return path[0], path[1], path[2]


def hole_under_water(
    since: np.ndarray, depth: np.ndarray, duration: float
) -> tuple[str, bool]:
    """Return which part of a dive lacks samples, empty where it is short; if it is over a tenth.

    At the surface, before its first sample and after its last, a vehicle has no
    displacement through the water to sum.  A depth that is not known counts as deep.

    >>> since = np.array([50.0, 400.0, 800.0])
    >>> hole_under_water(since, np.array([1.0, 90.0, 3.0]), 4000.0)
    ('', False)
    >>> hole_under_water(since, np.array([1.0, 40.0, 90.0]), 4000.0)
    ('no samples for 3200 s of 4000 s, from 90 m depth on', True)
    """
    times = np.concatenate([[0.0], since, [duration]])
    depths = np.concatenate([[0.0], depth, [0.0]])
    holes = np.diff(times)
    surface = np.maximum(depths[:-1], depths[1:]) <= SURFACE  # False where not known
    holes[surface] = 0.0
    longest = int(np.argmax(holes))
    large = bool(holes[longest] > LARGEST_HOLE * duration)
    if not (large or holes[longest] > LONGEST_GAP):
        return "", False
    hole = f"no samples for {holes[longest]:.0f} s of {duration:.0f} s"
    if depths[longest] > SURFACE:
        hole += f", from {depths[longest]:.0f} m depth on"
    return hole, large


def summed(
    since: np.ndarray,
    steps: np.ndarray,
    depth: np.ndarray,
    duration: float,
    notes: Sequence[str],
) -> ThroughWater:
    """Sum steps east and north (m) at times since the fix before the dive (s).

    Unless samples are missing.
    """
    notes, length = list(notes), np.hypot(*steps)
    most = FASTEST * np.abs(np.diff(since, prepend=0.0)) + LONGEST_STEP
    bad = ~np.isfinite(length) | (length > most)
    if bad.any():
        note = (
            f"{bad.sum()} of {bad.size} samples of the displacement are not finite "
            "or above 5 m/s"
        )
        if bad.mean() > REPAIRABLE:
            return ThroughWater(notes=[*notes, note])
        steps = np.array([fill(since, component, bad) for component in steps])
        notes.append(f"{note}, filled from their neighbours' speed")
    hole, large = hole_under_water(since, depth, duration)
    notes += [hole] if hole else []
    if large:
        return ThroughWater(notes=notes)
    east, north = steps
    total = float(np.sum(east)), float(np.sum(north))
    return ThroughWater(total, track_of(since, steps, duration), notes)


def deepest(depth: np.ndarray) -> float | None:
    """Return the greatest depth that is one of the sea, m, or None.

    >>> deepest(np.array([1.0, 985.5, 9.97e36, np.nan]))
    985.5
    """
    depths = depth[np.isfinite(depth) & (depth > 0) & (depth < DEEPEST)]
    return float(depths.max()) if depths.size else None


FIRST, LAST = 1900, 2030  # years of IGRF-14
NEAREST = 89.9  # degrees: at a pole itself there is no north


def variation(time: float, lat: float, lon: float) -> float:
    """Return the variation at a time (s since 1970 UTC) and a place (degrees), degrees east.

    NaN outside the years that IGRF covers, or where anything is not finite.

    >>> round(variation(1.0963e9, 66.9, -57.1), 1)  # Labrador Sea, September 2004
    -36.9
    >>> variation(4.0e9, 66.9, -57.1)  # the year 2096
    nan
    """
    earliest, latest = (
        datetime(year, 1, 1, tzinfo=UTC).timestamp() for year in (FIRST, LAST)
    )
    if not (earliest <= time <= latest and isfinite(lat) and isfinite(lon)):
        return nan
    when = datetime.fromtimestamp(time, UTC).replace(tzinfo=None)
    igrf = import_optional("ppigrf").igrf  # it reads pandas
    east, north, _ = igrf(lon, np.clip(lat, -NEAREST, NEAREST), 0.0, when)
    return np.degrees(np.arctan2(east, north)).item()


def turned(vectors: Sequence[ArrayLike], clockwise: float) -> np.ndarray:
    """Rotate vectors, east and north, by an angle in degrees: from magnetic to true axes.

    >>> turned((0.0, 1.0), 90.0).round(9)
    array([1., 0.])
    """
    sine, cosine = np.sin(np.radians(clockwise)), np.cos(np.radians(clockwise))
    return np.array([[cosine, sine], [-sine, cosine]]) @ np.asarray(vectors)


def with_variation(dive: Dive, degrees: float) -> Dive:
    """Rotate dead reckoning that was made of a magnetic heading to another variation, degrees east.

    A heading h + a moves (sin, cos) clockwise by a; other dead reckoning stays.

    >>> from clpt_control.ocean.gliders.dives import make_dive
    >>> fixes = (0.0, 0.0, 8.0), (9000.0, 0.0, 8.0)
    >>> round(with_variation(make_dive(1, *fixes, (0.0, 100.0), turned=0.0), 90.0).dr_east)
    100
    """
    if dive.turned is None:
        return dive
    angle = degrees - dive.turned
    east, north = turned(dive.through_water, angle)
    track = dive.track and (dive.track[0], *turned(dive.track[1:], angle))
    return replace(
        dive,
        dr_east=float(east),
        dr_north=float(north),
        track=track,
        turned=degrees,
        magvar=degrees,
        notes=(*dive.notes, f"--variation: turned by {degrees:g} degrees instead"),
    )
