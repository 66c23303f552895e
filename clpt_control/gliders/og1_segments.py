"""OG1 files that say of every measurement where and when its dive ended: Spray.

`TIME_GPS_END`, `LATITUDE_GPS_END`, `LONGITUDE_GPS_END` are the fix after the dive,
repeated at its measurements, `TIME_GPS`, `LATITUDE_GPS`, `LONGITUDE_GPS` the one
before it.  Where that one is missing, it follows from the middle of the segment under
water (`TIME_UV`, `LATITUDE_UV`, `LONGITUDE_UV`), which its maker defines as halfway
between both fixes (Scripps Institution of Oceanography, comments of sp028_20230202T1637):

    start = 2 middle - end,

good to twice the last digit of the file, some 10 m.
"""

from math import isfinite, nan
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from ..errors import DataError
from ..geodesy import is_place
from .dives import Fix
from .og1_columns import known_names
from .samples import seconds, values

if TYPE_CHECKING:
    import xarray

NAMES = ("TIME{}", "LATITUDE{}", "LONGITUDE{}")
END, START, MIDDLE = ("_GPS_END", "_GPS", "_UV")
FLAG = "GPS_END_QC"
DOUBTFUL = (3.0, 4.0)  # flags of a fix: questionable, bad


class Segment(NamedTuple):
    """The fixes of a dive, NaN where there is none, and notes."""

    start: Fix
    end: Fix
    notes: list[str]


def is_known(data: "xarray.Dataset") -> bool:
    """Whether the file has a fix after the dive for each measurement."""
    return all(name.format(END) in known_names(data) for name in NAMES)


def segments_of(data: "xarray.Dataset", path: Path) -> list[Segment]:
    """Return the segments between fixes by time, one for each fix after a dive."""
    known = known_names(data)
    of = {suffix: _fixes(data, known, suffix, path) for suffix in (END, START, MIDDLE)}
    ends = of[END]
    if not np.isfinite(ends).all(axis=0).any():
        raise DataError(
            f"{path}: TIME_GPS_END, LATITUDE_GPS_END, LONGITUDE_GPS_END have no fix; a dive needs "
            "one before and one after it"
        )
    flags = values(data, known[FLAG]) if FLAG in known else np.full(ends.shape[1], nan)
    found = []
    for time in np.unique(ends[0][np.isfinite(ends).all(axis=0)]):
        rows = np.flatnonzero(ends[0] == time)
        end = _fix(ends, rows)
        start, middle = _fix(of[START], rows), _fix(of[MIDDLE], rows)
        notes = []
        if not _whole(start) and _whole(middle):
            start = 2 * middle[0] - end[0], 2 * middle[1] - end[1], 2 * middle[2] - end[2]
            notes.append("the fix before the dive computed from the segment's middle and its end")
        if flags.shape == ends[0].shape and flags[rows[0]] in DOUBTFUL:
            notes.append(f"the file flags the fix after the dive {flags[rows[0]]:g}")
        found.append(Segment(start, end, notes))
    return found


def _fixes(data: "xarray.Dataset", known: dict[str, str], suffix: str, path: Path) -> np.ndarray:
    """Return time (s), latitude and longitude with a suffix, (3, n); what is no place is NaN.

    A file that has none has one of NaN for each end.
    """
    names = [name.format(suffix) for name in NAMES]
    if not all(name in known for name in names):
        return np.full((3, data[known[NAMES[0].format(END)]].size), nan)
    time = seconds(data, known[names[0]], path)
    lat, lon = (values(data, known[name]) for name in names[1:])
    if not (time.ndim == 1 and time.shape == lat.shape == lon.shape):
        raise DataError(f"{path}: {', '.join(names)} differ in length; must be one per measurement")
    places = zip(lat.tolist(), lon.tolist(), strict=True)
    good = np.array([is_place(*place) and place != (0.0, 0.0) for place in places], dtype=bool)
    return np.where(good, [time, lat, lon], nan)


def _fix(columns: np.ndarray, rows: np.ndarray) -> Fix:
    """Return the first fix that is whole among rows, else NaN."""
    own = columns[:, rows]
    whole = own[:, np.isfinite(own).all(axis=0)]
    if not whole.size:
        return nan, nan, nan
    time, lat, lon = whole[:, 0].tolist()
    return time, lat, lon


def _whole(fix: Fix) -> bool:
    return all(isfinite(number) for number in fix)
