"""Samples of a file: quantities under common names in SI units, their sums, magnetic variation.

One table, `QUANTITIES`, serves OG1 (`og1_columns`) and the Seaglider basestation (`seaglider`).
Case does not matter.  OG1 1.0 standardizes the fixes, `TIME`, `DEPTH` and `PHASE`, its vocabulary
`WCUR_X`, `WCUR_Y` and `DEAD_RECKONING`; numbers of dives, displacements, the flight model's speed
and the depth-averaged current are named as by seagliderOG1 and votoutils, or by the basestation.

Files of different makers give the same sample as seconds since 1970 or as nanoseconds since the
first of them, a depth as m or cm, a speed as cm/s or m s-1; a variable without units is taken as s,
m or m/s.

A step is the displacement since the sample before, so a track is their running sum, from rest at
the fix before the dive to rest at the fix after it.  A step that is not finite, or longer than
5 m/s and 100 m allow, is none: a few of them are filled from their neighbours.

Magnetic variation is how far a compass points from true north, by IGRF,

    D = atan2(B_east, B_north), degrees, positive east

of the International Geomagnetic Reference Field, 14th generation (IAGA, 2024), whose
coefficients `ppigrf` carries.  Good to about half a degree at sea; near the magnetic poles no
compass is of use.
"""

import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from datetime import UTC, datetime
from functools import partial
from math import isfinite, nan
from typing import Any

import numpy as np
import xarray
from numpy.typing import ArrayLike

from ...base.errors import DataError, import_optional
from ...base.units import (
    finite_or_none,
    length_in_metres,
    number,
    seconds_since_1970,
    speed_in_metres_per_second,
)
from ...paper.currents.cf_times import decoded
from ...paper.currents.flags import IS_FLAG, said, without_flagged
from .dive_fields import FILLS, FILLS_OF, HEADINGS, TURNS, VARIATIONS, size_of_unit
from .dives import FASTEST, LEAST_DEPTH, LEAST_GAP, Dive, ThroughWater, Track

Pairs = tuple[np.ndarray, np.ndarray]  # times and numbers
PLACES = ("TIME", "LATITUDE", "LONGITUDE")
PLACE = ("lat", "lon")
HEADING = ("HEADING", "GLIDER_HEADING", "ENG_HEAD")
# of a dive: how names end
ENDS = {"after": "_GPS_END", "before": "_GPS", "middle": "_UV"}
PITCHES = (-90.0, 90.0)  # degrees
READ = re.compile(  # names of the variables that dives are made of
    r"(^|_)(time|lat|lon|east_disp|north_disp|head|velo|speed|davg|[uvw]cur|dac_|depth$)",
    re.IGNORECASE,
)
ENDLESS = 2.0**63  # its negative, the smallest integer of 64 bits, is a missing time
LONGEST_SINGLE = (
    8e7  # s; single precision counts times so long after a date by some 10 s
)
SURFACE = 20.0  # m: above, a vehicle may be on its way to the surface or from it
LONGEST_WAIT = 3600.0  # s that a vehicle at the surface may wait for a fix
LARGEST_HOLE = 0.1  # share of a dive that may be without samples under water
LONGEST_GAP = 900.0  # s between samples that is mentioned, less beside the surface
LONGEST_STEP = 100.0  # m, beyond what is possible at 5 m/s
REPAIRABLE = 0.05  # largest share of samples that is filled from their neighbours
DEEPEST = 12000.0  # m: no sea is deeper


def degrees(ddmm: np.ndarray) -> np.ndarray:
    """Return degrees of ddmm.mmm, NaN where it has 60 minutes or more.

    >>> degrees(np.array([5138.0368, -12818.26, 69696969.0])).round(5)
    array([  51.63395, -128.30433,          nan])
    """
    with np.errstate(invalid="ignore"):  # of what is endless
        whole_degrees, minutes = np.divmod(np.abs(ddmm), 100.0)
    return np.where(
        (minutes < 60.0) & (whole_degrees < 400.0),
        np.sign(ddmm) * (whole_degrees + minutes / 60),
        nan,
    )


def within(
    angles: np.ndarray, limits: tuple[float, float]
) -> tuple[np.ndarray, np.ndarray]:
    """Return angles, NaN outside limits such as `HEADINGS`, and which were outside.

    >>> within(np.array([350.0, -999.0, np.nan, 9.97e36]), HEADINGS)
    (array([350.,  nan,  nan,  nan]), array([False,  True, False,  True]))
    """
    low, high = limits
    outside = (angles < low) | (angles > high)
    return np.where(outside, nan, angles), outside


def unflagged(data: xarray.Dataset) -> tuple[xarray.Dataset, list[str]]:
    """Return a file with NaN where what dives are made of is flagged bad, and notes on it.

    A depth-averaged current of a Seaglider stays, because its dives have its flag, `dac_qc`.
    """
    columns = dict[str, xarray.DataArray]()
    notes = list[str]()
    names = [name for name in map(str, data.variables) if READ.search(name)]
    flags = [name for name in map(str, data.variables) if IS_FLAG.search(name.lower())]
    few = data[names + flags]  # of hundreds of variables
    for name in names:
        values, flagged = without_flagged(few, [name], is_fix="GPS" in name.upper())
        if flagged:
            columns[name] = values
            notes += flagged
    return data.assign(columns), notes


def values(data: xarray.Dataset, name: str) -> np.ndarray:
    """Return a variable as floats, NaN where it is no number."""
    raw = np.atleast_1d(data[name].values)
    if raw.dtype.kind in "iufb":
        return raw.astype(float)
    return np.reshape([number(item) for item in raw.ravel()], raw.shape)


def scalar(data: xarray.Dataset, name: str) -> float | None:
    """Return a single finite number, or None."""
    if name not in data.variables:
        return None
    numbers = values(data, name)
    return finite_or_none(numbers.flat[0]) if numbers.size else None


def seconds(data: xarray.Dataset, name: str) -> np.ndarray:
    """Return times as seconds since 1970 UTC, NaN where missing.

    >>> import xarray
    >>> units = {"units": "nanoseconds since 2010-07-29 13:31:04"}
    >>> data = xarray.Dataset({"TIME": ("n", np.array([0, 234_000_000_000]), units)})
    >>> seconds(data, "TIME") - 1280410264.0
    array([  0., 234.])
    """
    numbers = values(data, name)
    missing = np.isin(numbers, FILLS) | ~(np.abs(numbers) < ENDLESS)
    numbers = np.where(missing, nan, numbers)
    units = said(data[name])
    if " since " not in units.lower():
        units = "seconds since 1970-1-1"
    dates = decoded(np.array([0.0, 1.0]), units)  # of two numbers, so that digits stay
    if dates is None:
        raise DataError(
            f"{name} is in '{units}'; use a unit such as 'seconds since 1970-01-01 00:00:00'"
        )
    epoch, step = (dates - [np.datetime64("1970-01-01"), dates[0]]) / np.timedelta64(
        1, "s"
    )
    span = step * np.nanmax(np.abs(numbers), initial=0.0)
    if data[name].dtype == np.float32 and span > LONGEST_SINGLE:
        raise DataError(
            f"{name} is in single precision, whose numbers are over 8 s apart so long after its "
            "reference date. Write it in double precision"
        )
    times = epoch + step * numbers
    return np.where(times > 0, times, nan)


def in_units(
    usual: str, size_of: Callable[[str, str], float], data: xarray.Dataset, name: str
) -> np.ndarray:
    """Return a variable in SI units or degrees, NaN where missing; without units in the usual."""
    return values(data, name) * size_of(said(data[name]) or usual, name)


def metres(data: xarray.Dataset, name: str) -> np.ndarray:
    """Return lengths in m, depths positive down, NaN where missing.

    >>> import xarray
    >>> data = xarray.Dataset({"eng_depth": ("n", [150.0], {"units": "cm"})})
    >>> metres(data, "eng_depth")
    array([1.5])
    """
    up = said(data[name], "positive").lower() == "up"
    lengths = in_units("m", length_in_metres, data, name)
    return -lengths if up else lengths


metres_per_second: Any = partial(in_units, "m/s", speed_in_metres_per_second)
_degrees: Any = partial(in_units, "", partial(size_of_unit, TURNS))
ANGLES = {"heading": HEADINGS, "magvar": VARIATIONS}


def checked_angles(
    angles: np.ndarray, key: str, units: str, name: str
) -> tuple[np.ndarray, list[str]]:
    """Return angles (degrees), NaN outside their limits, and notes.

    Two different numbers outside are no fill value: the units are wrong.
    """
    good, outside = within(angles, ANGLES[key])
    if key == "heading":  # of AIS and NMEA 2000
        good[np.isin(np.round(good, 6), FILLS_OF["degrees"])] = nan
    wrong = angles[outside]
    finite = good[np.isfinite(good)]
    limits = "{:g} to {:g} degrees".format(*ANGLES[key])
    fault = f"{wrong.size} numbers of {name} are not within {limits}"
    if np.unique(wrong).size > 1:
        raise DataError(
            f"{fault}, such as {wrong.min():g} and {wrong.max():g}. Correct its units, {units!r}, "
            "or set these to NaN"
        )
    notes = [f"{fault}: taken as gaps"] if wrong.size else []
    is_small = finite.any() and np.abs(finite).max() <= 2 * np.pi
    in_degrees = units.lower().startswith(("deg", "°"))
    if key == "heading" and is_small and (in_degrees or units in ("", "1")):
        if not in_degrees or np.ptp(finite) > np.pi:
            raise DataError(
                f"{name} has the units {units!r} and only numbers within 2 pi, which look like "
                "radians. Set its units to 'radian', or to 'degrees' if they are degrees"
            )
        doubt = f"{name} has only numbers within 2 pi, and the units {units!r}"
        notes.append(f"{doubt}; if they are radians, set its units to 'radian'")
    return good, notes


QUANTITIES = {  # of a measurement: what files call it, and how it is read
    "east": (("EAST_DISPLACEMENT", "EAST_DISPLACEMENT_GSM"), metres),
    "north": (("NORTH_DISPLACEMENT", "NORTH_DISPLACEMENT_GSM"), metres),
    "speed": (
        ("GLIDER_HORZ_VELO_MODEL", "HORZ_SPEED", "HORZ_SPEED_GSM", "HORZ_GLIDER_SPEED"),
        metres_per_second,
    ),
    "heading": (HEADING, _degrees),
    "u": (
        ("DAVG_CURR_EAST", "UCUR", "DAC_EAST", "DEPTH_AVG_CURR_EAST", "WCUR_X"),
        metres_per_second,
    ),
    "v": (
        ("DAVG_CURR_NORTH", "VCUR", "DAC_NORTH", "DEPTH_AVG_CURR_NORTH", "WCUR_Y"),
        metres_per_second,
    ),
    "number": (
        ("DIVE_NUMBER", "DIVE_NUM", "DIVENUM", "DIVE_NUM_CAST", "PROFILE_INDEX"),
        values,
    ),
    "qc": (
        ("DAVG_CURR_EAST_QC", "DAVG_CURR_QC", "DEPTH_AVG_CURR_QC", "WCUR_QC"),
        values,
    ),
    "magvar": (("MAGNETIC_VARIATION",), _degrees),
    "depth": (("DEPTH", "GLIDER_DEPTH", "CTD_DEPTH", "ENG_DEPTH"), metres),
    "depth_max": (("DEPTH_MAX",), metres),
    "phase": (("PHASE",), values),
    **{
        f"{key}_{end}": ((f"{name}{suffix}",), read)
        for end, suffix in ENDS.items()
        for key, name, read in zip(
            ("time", *PLACE), PLACES, (seconds, values, values), strict=True
        )
    },
}


def known_names(data: xarray.Dataset) -> dict[str, str]:
    """Return names in the file by their capitals; a name in capitals goes before others."""
    return {
        str(name).upper(): str(name)
        for name in sorted(map(str, data.variables), reverse=True)
    }


def columns_of(data: xarray.Dataset, key: str) -> Iterator[tuple[str, np.ndarray]]:
    """Yield name and numbers of the variables that have a quantity, the preferred one before."""
    names = known_names(data)
    candidates, read = QUANTITIES[key]
    for name in (names[column] for column in candidates if column in names):
        yield name, read(data, name)


def pairs_of(data: xarray.Dataset, key: str, other: str) -> Iterator[tuple[str, str]]:
    """Yield names of the variables of two components, such as east and north."""
    names = known_names(data)
    for pair in zip(QUANTITIES[key][0], QUANTITIES[other][0], strict=True):
        if {*pair} <= {*names}:
            yield names[pair[0]], names[pair[1]]


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


def track_of(path: np.ndarray, duration: float) -> Track:
    """Return the track of a whole dive by a path: time since its fix (s), east and north (m)."""
    if path[0, 0] > 0:
        path = np.hstack([np.zeros((3, 1)), path])
    if path[0, -1] < duration:
        path = np.hstack([path, [[duration], *path[1:, -1:]]])
    return path[0], path[1], path[2]


def hole_under_water(
    since: np.ndarray, depths: Pairs, duration: float, surfacing: float
) -> tuple[str, bool]:
    """Return which part of a dive lacks samples, empty where it is short; if it is over a tenth.

    `depths` are times and numbers of the depth's own rows, which may be others than those of the
    samples, at `since`, s.  At the surface a vehicle has no displacement through the water to sum.
    It is there between two depths of at most `SURFACE` if that is no longer than its usual
    `surfacing`; of two under water, than the shortest dive; from the surface to a fix, than
    `LONGEST_WAIT`.  Else there may be a dive between them.  A depth that is not known counts as
    deep.

    >>> since = np.array([220.0, 400.0, 590.0])
    >>> hole_under_water(since, (since, np.array([1.0, 90.0, 3.0])), 4000.0, 600.0)
    ('', False)
    >>> hole_under_water(since, (since, np.array([1.0, 40.0, 90.0])), 4000.0, 600.0)
    ('no samples for 3410 s of 4000 s, from 90 m depth on', True)
    >>> hole_under_water(since, (since, np.array([1.0, 90.0, 12.0])), 4000.0, 600.0)
    ('no samples for 3410 s of 4000 s', True)
    """
    is_known = np.isfinite(depths[1])
    ends = np.array([0.0, duration])
    times = np.unique(np.concatenate([ends, since, depths[0][is_known]]))
    depth = np.full(times.size, nan)
    depth[np.searchsorted(times, depths[0][is_known])] = depths[1][is_known]
    depth[np.searchsorted(times, ends)] = 0.0
    rests = np.diff(times)
    upper = np.minimum(depth[:-1], depth[1:])
    lower = np.maximum(depth[:-1], depth[1:])
    longest_rest = np.where(upper <= LEAST_DEPTH, surfacing, LEAST_GAP)
    longest_rest[[0, -1]] = np.where(lower <= LEAST_DEPTH, LONGEST_WAIT, surfacing)[
        [0, -1]
    ]
    rests[(lower <= SURFACE) & (rests <= longest_rest)] = 0.0  # False where not known
    samples = np.searchsorted(times, np.union1d(since, ends))
    holes = np.diff(np.append(0.0, np.cumsum(rests))[samples])
    longest = int(np.argmax(holes))
    large = bool(holes[longest] > LARGEST_HOLE * duration)
    # beside the surface its step is that of a vehicle at rest
    is_deep = np.min(depth[samples[longest : longest + 2]]) > SURFACE
    share = 1.0 if is_deep else REPAIRABLE
    if not (large or holes[longest] > min(LONGEST_GAP, share * duration)):
        return "", False
    hole = f"no samples for {holes[longest]:.0f} s of {duration:.0f} s"
    if (deep := depth[samples[longest]]) > SURFACE:
        hole += f", from {deep:.0f} m depth on"
    return hole, large


def summed(
    since: np.ndarray,
    steps: np.ndarray,
    depths: Pairs,
    duration: float,
    surfacing: float,
    notes: Sequence[str],
) -> ThroughWater:
    """Sum steps east and north (m) at times since the fix before the dive (s).

    Unless samples are missing (`hole_under_water`).
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
    hole, large = hole_under_water(since, depths, duration, surfacing)
    notes += [hole] if hole else []
    if large:
        return ThroughWater(notes=notes)
    east, north = steps
    total = float(np.sum(east)), float(np.sum(north))
    path = np.vstack([since, np.cumsum(steps, axis=1)])
    return ThroughWater(total, track_of(path, duration), notes)


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
    earliest, latest = (seconds_since_1970(f"{year}-01-01") for year in (FIRST, LAST))
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
    sine = np.sin(np.radians(clockwise))
    cosine = np.cos(np.radians(clockwise))
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
