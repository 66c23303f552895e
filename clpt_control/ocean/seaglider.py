"""Seaglider basestation files: NetCDF, one per dive.

The basestation (University of Washington and Kongsberg) stores the three fixes
GPS1, GPS2, GPSE in `log_gps_time`, `log_gps_lat`, `log_gps_lon` and the way
through the water since the sample before, by its hydrodynamic model, in
`east_displacement`, `north_displacement`: their sums are the dead reckoning,

    dr = sum_i (displacement of sample i),

from which the file's own `depth_avg_curr_east`, `_north` was computed.  Where
the hydrodynamic model is missing the glide-slope model (`_gsm`) is read.
"""

import re
from math import nan
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from ..errors import DataError
from ..files import open_netcdf
from .classic import check_whole
from .dives import Dive, make_dive
from .samples import fill, scalar, track_of, values

if TYPE_CHECKING:
    import xarray

FIXES = ("log_gps_time", "log_gps_lat", "log_gps_lon")
LONGEST_STEP = 1e5  # m in one sample: beyond, a fill value
REPAIRABLE = 0.05  # largest share of samples that is filled from their neighbours
LONGEST_GAP = 900.0  # s between samples that is mentioned
GOOD = (0.0, 1.0, 2.0)  # flags of a fix: no change, good, probably good


def is_seaglider(data: "xarray.Dataset") -> bool:
    """Whether a NetCDF file is of the Seaglider basestation."""
    return any(name in data.variables for name in FIXES) or "sg_data_point" in data.dims


def read_seaglider(path: str | Path) -> Dive:
    """Read one dive of a Seaglider basestation file.

    Parameters
    ----------
    path : str or Path
        Such as ``p5420304.nc``.

    Returns
    -------
    Dive
        NaN where a fix or the way through the water is missing.

    Raises
    ------
    DataError
        If the file is missing, damaged, or without fixes or dive number.
    """
    path = Path(path)
    if path.is_file():
        check_whole(path)
    with open_netcdf(path) as data:
        return dive_of(data, path)


def dive_of(data: "xarray.Dataset", path: Path) -> Dive:
    """Give the dive of an open basestation file.

    Parameters
    ----------
    data : xarray.Dataset
        The file.
    path : Path
        Its name, for messages and for a missing dive number.

    Returns
    -------
    Dive
        As `read_seaglider`.

    Raises
    ------
    DataError
        If it has no fixes or no dive number.
    """
    missing = [name for name in FIXES if name not in data.variables]
    if missing:
        raise DataError(
            f"{path}: no variable {' and no '.join(missing)}; a Seaglider basestation file has "
            "its fixes there"
        )
    fixes = [values(data, name) for name in FIXES]
    if any(fix.shape != (3,) for fix in fixes):
        raise DataError(
            f"{path}: {len(fixes[0])} fixes in {FIXES[0]}; must be 3: GPS1, GPS2 and GPSE"
        )
    first, start, end = (tuple(float(fix[k]) for fix in fixes) for k in range(3))
    through_water, track, notes = _way(data, start[0], end[0])
    for name in ("GPS2_qc", "GPSE_qc"):
        flag = scalar(data, name)
        if flag is not None and flag not in GOOD:
            notes.append(f"the file flags {name[:4]} {flag:g}")
    known = all(np.isfinite(first))
    return make_dive(
        _number(data, path),
        start,  # type: ignore[arg-type]
        end,  # type: ignore[arg-type]
        through_water,
        t_gps1=first[0] if known else None,
        lat_gps1=first[1] if known else None,
        lon_gps1=first[2] if known else None,
        dac_east=scalar(data, "depth_avg_curr_east"),
        dac_north=scalar(data, "depth_avg_curr_north"),
        dac_qc=scalar(data, "depth_avg_curr_qc"),
        magvar=scalar(data, "magnetic_variation"),
        track=track,
        notes=tuple(notes),
    )


def number_in_name(path: Path) -> int | None:
    """Give the dive of a name pSSSDDDD.nc (vehicle, dive), or None."""
    named = re.fullmatch(r"p\d{3}(\d{4})", path.stem)
    return int(named[1]) if named else None


def _number(data: "xarray.Dataset", path: Path) -> int:
    for text in (data.attrs.get("dive_number"), scalar(data, "log_DIVE")):
        try:
            return int(float(text))  # type: ignore[arg-type]
        except (TypeError, ValueError, OverflowError):
            continue
    named = number_in_name(path)
    if named is not None:
        return named
    raise DataError(f"{path}: no attribute dive_number, and the name is not such as p5420304.nc")


def _way(data: "xarray.Dataset", start: float, end: float) -> tuple[Any, Any, list[str]]:
    """Sum the way through the water; give it, its track and notes."""
    for suffix in ("", "_gsm"):
        names = [f"{axis}_displacement{suffix}" for axis in ("east", "north")]
        if all(name in data.variables for name in names):
            break
    else:
        return (nan, nan), None, ["no variables east_displacement, north_displacement"]
    notes = [f"dead reckoning of the glide-slope model ({names[0]})"] if suffix else []
    east, north = (values(data, name) for name in names)
    time = values(data, "time") if "time" in data.variables else np.array([])
    if east.shape != north.shape or east.ndim != 1 or not east.size:
        return (
            (nan, nan),
            None,
            [*notes, f"{names[0]} and {names[1]} differ in length or are empty"],
        )
    timed = time.shape == east.shape and bool(np.all(np.isfinite(time)))
    timed = timed and bool(np.all(np.diff(time) > 0))
    if not timed:
        notes.append("no track: the times of the samples are missing, not finite or not in order")
    bad = ~((np.abs(east) < LONGEST_STEP) & (np.abs(north) < LONGEST_STEP))
    if bad.any():
        said = f"{bad.sum()} of {bad.size} samples of the displacement are not finite"
        if not timed or bad.mean() > REPAIRABLE:
            return (nan, nan), None, [*notes, said]
        east, north = (fill(time, steps, bad) for steps in (east, north))
        notes.append(f"{said}, filled from their neighbours' speed")
    total = float(np.sum(east)), float(np.sum(north))
    if not timed:
        return total, None, notes
    if time.size > 1 and np.max(np.diff(time)) > LONGEST_GAP:
        notes.append(f"a gap of {np.max(np.diff(time)):.0f} s in the samples")
    return total, track_of(time - start, east, north, end - start), notes
