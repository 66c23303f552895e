"""Seaglider basestation files: NetCDF, one per dive.

The basestation (University of Washington and Kongsberg) stores the displacement through
the water since the sample before, by its hydrodynamic model, in
`east_displacement`, `north_displacement` (m): their sums are the dead reckoning,

    dr = sum_i (displacement of sample i),

and where that model is missing the glide-slope model (`_gsm`) is read.  Times are
`ctd_time` or `time`, whichever has the dimension of the displacement: one
`sg_data_point` in files to version 2, one per instrument in those of version 3.

The three fixes of a dive, `log_gps_time`, `log_gps_lat`, `log_gps_lon`, shape (3,), are
GPS1 (first fix of the surfacing before the dive), GPS2 (last fix before it) and GPSE
(first after it).  A receiver that times out is logged at 0 N 0 E with a horizontal dilution of
precision (hdop) of 99.  The fix before the dive is the later of GPS1 and GPS2:
where GPS2 failed, an older one may stand in its place.

The plan is that of the dive which was flown, and the next one's as far as it goes on: `log_HEADING`
(degrees, below 0 where none is commanded), else the way to `log_TGT_LATLONG` (ddmm.mmm,dddmm.mmm)
until it is within `log_TGT_RADIUS` (m).
"""

import re
from math import isfinite, nan
from pathlib import Path

import numpy as np
import xarray

from ...base.errors import DataError
from ...base.units import finite_or_none, number
from ...paper.currents.flags import is_bad
from .dive_fields import NUMBERS, VARIATIONS, whole_number
from .dives import (
    Dive,
    Fix,
    Skipped,
    Three,
    ThroughWater,
    dive_between,
    is_fix,
    planned_course,
    usual_surfacing,
)
from .samples import (
    columns_of,
    deepest,
    degrees,
    metres,
    pairs_of,
    scalar,
    seconds,
    summed,
    values,
    within,
)

FIXES = ("log_gps_time", "log_gps_lat", "log_gps_lon")
NAMES = ("GPS1", "GPS2", "GPSE")
GOOD = (0.0, 1.0, 2.0)  # flags of a fix: no change, good, probably good
FAILED = 99.0  # hdop of a receiver that timed out


def fixes_of(data: xarray.Dataset, first_sample: float) -> tuple[Three, list[str]]:
    """Return the fixes of a file whose first sample is at a time (s, NaN where not known).

    A fix that failed is NaN, and its note says so; the first is None where it cannot be used.
    """
    missing = [name for name in FIXES if name not in data.variables]
    if missing:
        raise DataError(
            f"no variable {' and no '.join(missing)}; a Seaglider basestation file has "
            "its fixes there"
        )
    columns = [seconds(data, FIXES[0]), *(values(data, name) for name in FIXES[1:])]
    if any(column.shape != (3,) for column in columns):
        raise DataError(
            f"{columns[0].size} fixes in {FIXES[0]}; must be 3: GPS1, GPS2 and GPSE"
        )
    notes = []
    of = np.array(columns)
    hdop = _of_fixes(data, "log_gps_hdop")
    for k, name in enumerate(NAMES):
        flag, bad = _flag_of(data, k)
        if hdop[k] >= FAILED:
            of[:, k] = nan
            notes.append(f"{name} has a hdop of {hdop[k]:g}: the receiver found no fix")
        elif bad:
            of[:, k] = nan
            notes.append(f"the file flags {name} {flag:g}, bad: left out")
        elif k and isfinite(flag) and flag not in GOOD:
            notes.append(f"the file flags {name} {flag:g}")
    gps1, start, end = ((time, lat, lon) for time, lat, lon in of.T.tolist())
    if not (isfinite(gps1[0]) and is_fix(*gps1[1:])):
        return (None, start, end), notes
    if start[0] < gps1[0]:
        is_used = gps1[0] <= first_sample
        outcome = "taken as the fix before the dive" if is_used else "left out"
        notes.append(
            f"GPS2 is {gps1[0] - start[0]:.0f} s older than GPS1, which is {outcome}"
        )
        return (None, gps1 if is_used else start, end), notes
    return (gps1, start, end), notes


def _flag_of(data: xarray.Dataset, k: int) -> tuple[float, bool]:
    """Return the flag of a fix, NaN where it has none, and whether it is bad."""
    found = [
        (values(data, name).flat[at], np.atleast_1d(is_bad(data[name], True)).flat[at])
        for name, at in ((f"{NAMES[k]}_qc", 0), ("log_gps_qc", k))
        if name in data.variables and data[name].size > at
    ]
    bad = [flag for flag, is_bad_flag in found if is_bad_flag]
    stated = [flag for flag, _ in found if isfinite(flag) and flag]
    return (*bad, *stated, nan)[0], bool(bad)


def _of_fixes(data: xarray.Dataset, name: str) -> np.ndarray:
    """Return a number of each of three fixes, NaN where there are none."""
    numbers = values(data, name) if name in data.variables else np.empty(0)
    return numbers if numbers.shape == (3,) else np.full(3, nan)


def is_known(data: xarray.Dataset) -> bool:
    """Return whether a NetCDF file is of the Seaglider basestation."""
    return any(name in data.variables for name in FIXES) or "sg_data_point" in data.dims


def dives_of(data: xarray.Dataset, path: Path) -> list[Dive | Skipped]:
    """Return the one dive of a file, NaN where a fix or the displacement is missing."""
    names = next(pairs_of(data, "east", "north"), None)
    time, why_not = _times(data, names[0]) if names else (None, "")
    fixes, doubts = fixes_of(data, nan if time is None else float(time[0]))
    reckoned = _dead_reckoning(data, names, time, fixes)
    depths = (deepest(numbers) for _, numbers in columns_of(data, "depth"))
    dive = dive_between(
        _number(data, path),
        fixes,
        reckoned,
        dac_east=_number_of(data, "u"),
        dac_north=_number_of(data, "v"),
        dac_qc=_number_of(data, "qc"),
        magvar=_variation(data),
        depth_max=next((depth for depth in depths if depth is not None), None),
        next_course=_next_course(data, fixes[2]),
        notes=(*reckoned.notes, *([why_not] if why_not else []), *doubts),
    )
    return [dive]


def number_in_name(path: Path) -> int | None:
    """Return the dive of a name pSSSDDDD.nc (vehicle, dive), or None."""
    named = re.fullmatch(r"p\d{3}(\d{4})", path.stem)
    return int(named[1]) if named else None


def _number(data: xarray.Dataset, path: Path) -> int:
    """Return the number of the dive."""
    named = (
        data.attrs.get("dive_number"),
        scalar(data, "log_DIVE"),
        number_in_name(path),
    )
    for value in named:
        number = whole_number(value)
        if number is not None:
            return number
    raise DataError(
        f"neither dive_number nor log_DIVE is a whole number below {NUMBERS}, and the name is not "
        "such as p5420304.nc"
    )


def _number_of(data: xarray.Dataset, key: str) -> float | None:
    """Return a quantity of the whole dive, None where the file has none."""
    numbers = (
        float(column.flat[0]) for _, column in columns_of(data, key) if column.size
    )
    return next(filter(isfinite, numbers), None)


def _variation(data: xarray.Dataset) -> float | None:
    """Return the magnetic variation, that of GPS2 where the file has one per fix."""
    stated = _number_of(data, "magvar")
    if stated is None:
        stated = _of_fixes(data, "log_gps_magvar").tolist()[1]
    degrees, _ = within(np.array(stated), VARIATIONS)
    return finite_or_none(degrees)


def _next_course(data: xarray.Dataset, end: Fix) -> float | None:
    """Return the course of the next dive by the plan of this one, None where there is none."""
    heading = scalar(data, "log_HEADING")
    if heading is not None and 0.0 <= heading <= 360.0:
        return heading % 360.0
    text = data["log_TGT_LATLONG"].values if "log_TGT_LATLONG" in data else np.array("")
    words = text.astype(str).item().split(",") if text.size == 1 else []
    if len(words) != 2:
        return None
    target = degrees(np.array([*map(number, words)])).tolist()
    return planned_course(end, target, scalar(data, "log_TGT_RADIUS") or 0.0)


def _times(data: xarray.Dataset, reference: str) -> tuple[np.ndarray | None, str]:
    """Return times of the samples that a variable has, or why there are none."""
    time_names = sorted(
        name for name in map(str, data.variables) if name.endswith("_time")
    )
    for name in ("ctd_time", "time", *time_names):
        if name not in data or data[name].dims != data[reference].dims:
            continue
        time = seconds(data, name)
        if time.size and np.all(np.isfinite(time)) and np.all(np.diff(time) > 0):
            return time, ""
    return None, f"no track: no times in order with the dimension of {reference}"


def _dead_reckoning(
    data: xarray.Dataset,
    names: tuple[str, str] | None,
    time: np.ndarray | None,
    fixes: Three,
) -> ThroughWater:
    """Sum the displacement through the water."""
    if names is None:
        return ThroughWater(
            notes=["no variables east_displacement, north_displacement"]
        )
    notes = []
    if names[0].endswith("_gsm"):
        notes.append(f"dead reckoning of the glide-slope model ({names[0]})")
    east, north = (metres(data, name) for name in names)
    if east.shape != north.shape or east.ndim != 1 or not east.size:
        wrong = f"{names[0]} and {names[1]} differ in length or are empty"
        return ThroughWater(notes=[*notes, wrong])
    if time is None:
        return ThroughWater((float(np.sum(east)), float(np.sum(north))), notes=notes)
    depths = (
        numbers
        for name, numbers in columns_of(data, "depth")
        if data[name].dims == data[names[0]].dims
    )
    _, start, end = fixes
    since = time - start[0]
    depth = since, next(depths, np.full(east.shape, nan))
    steps = np.array([east, north])
    surfacing = usual_surfacing([fixes])
    return summed(since, steps, depth, end[0] - start[0], surfacing, notes)
