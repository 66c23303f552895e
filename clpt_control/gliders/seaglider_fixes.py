"""The three fixes of a Seaglider dive, and whether they can be trusted.

`log_gps_time`, `log_gps_lat`, `log_gps_lon`, shape (3,), are GPS1 (first fix of
the surfacing before the dive), GPS2 (last fix before it) and GPSE (first after
it).  A receiver that times out is logged at 0 N 0 E with a horizontal dilution of
precision (hdop) of 99.  The fix before the dive is the later of GPS1 and GPS2:
where GPS2 failed, an older one may stand in its place.
"""

from math import isfinite, nan
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from ..errors import DataError
from ..geodesy import is_place
from .dives import Fix
from .samples import scalar, seconds, values

if TYPE_CHECKING:
    import xarray

FIXES = ("log_gps_time", "log_gps_lat", "log_gps_lon")
NAMES = ("GPS1", "GPS2", "GPSE")
GOOD = (0.0, 1.0, 2.0)  # flags of a fix: no change, good, probably good
POOR = 10.0  # hdop that is mentioned; a good one is about 1
FAILED = 99.0  # hdop of a receiver that timed out


class Fixes(NamedTuple):
    """Fixes of a dive; the first is None where there is none that can be used."""

    first: Fix | None
    start: Fix
    end: Fix
    notes: list[str]


def fixes_of(data: "xarray.Dataset", path: Path, first_sample: float) -> Fixes:
    """Return the fixes of a file whose first sample is at a time (s, NaN where not known).

    A fix that failed is NaN, and its note says so.
    """
    missing = [name for name in FIXES if name not in data.variables]
    if missing:
        raise DataError(
            f"{path}: no variable {' and no '.join(missing)}; a Seaglider basestation file has "
            "its fixes there"
        )
    columns = [seconds(data, FIXES[0], path), *(values(data, name) for name in FIXES[1:])]
    if any(column.shape != (3,) for column in columns):
        raise DataError(
            f"{path}: {columns[0].size} fixes in {FIXES[0]}; must be 3: GPS1, GPS2 and GPSE"
        )
    notes: list[str] = []
    fixes = [_checked(data, k, columns, notes) for k in range(3)]
    first: Fix | None
    first, start, end = fixes
    if not (isfinite(first[0]) and is_place(*first[1:])) or first[1] == first[2] == 0.0:
        first = None
    elif start[0] < first[0]:
        late = f"GPS2 is {first[0] - start[0]:.0f} s older than GPS1"
        if first[0] <= first_sample:
            notes.append(f"{late}, so GPS1 is taken as the fix before the dive")
            start = first
        else:
            notes.append(f"{late}, which is left out")
        first = None
    return Fixes(first, start, end, notes)


def _checked(data: "xarray.Dataset", k: int, columns: list[np.ndarray], notes: list[str]) -> Fix:
    time, lat, lon = (float(column[k]) for column in columns)
    name = NAMES[k]
    flags = [scalar(data, f"{name}_qc")]
    for other in ("log_gps_qc", "log_gps_hdop"):
        found = values(data, other) if other in data.variables else np.array([])
        flags.append(float(found[k]) if found.shape == (3,) else None)
    flag = flags[0] if flags[0] is not None else flags[1]
    hdop = flags[2]
    if name != "GPS1" and flag is not None and isfinite(flag) and flag not in GOOD:
        notes.append(f"the file flags {name} {flag:g}")
    if hdop is None or not hdop > POOR:
        return time, lat, lon
    if hdop < FAILED:
        notes.append(f"{name} has a hdop of {hdop:g}: up to some {10 * hdop:.0f} m off")
        return time, lat, lon
    notes.append(f"{name} has a hdop of {hdop:g}: the receiver found no fix")
    return nan, nan, nan
