"""Columns of an OG1 file: whatever it calls them, under one name, in SI units.

Every column has one number per row, NaN where there is none.  Rows are those of
`N_MEASUREMENTS`; fixes that stand on a dimension of their own follow as further
rows.  Where there is no `TIME_GPS`, a fix has the `TIME` of its row.
"""

from math import nan
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from ..errors import DataError
from ..geodesy import is_place
from . import og1_names as names
from .sample_units import metres, metres_per_second, seconds
from .samples import SURFACE, values

if TYPE_CHECKING:
    import xarray


class Columns(NamedTuple):
    """Columns by name, and what the file says of its heading.

    `t_fix`, `lat`, `lon`, `kind` are of the fixes; `time`, `east`, `north` (steps,
    m), `speed`, `heading` (degrees), `u`, `v`, `number`, `qc`, `magvar`, `depth`,
    `depth_max` and `phase` of the measurements.
    """

    of: dict[str, np.ndarray]
    north: str  # "magnetic", "true" or "" where the file does not say
    steps: str  # name of the displacement


def is_og1(data: "xarray.Dataset") -> bool:
    """Whether a NetCDF file is an OG1 trajectory."""
    known = _known(data)
    return "N_MEASUREMENTS" in data.dims or any(name in known for name in names.FIXES)


def columns_of(data: "xarray.Dataset", path: Path) -> Columns:
    """Read the columns of an open OG1 file.

    Parameters
    ----------
    data : xarray.Dataset
        The file.
    path : Path
        Its name, for messages.

    Returns
    -------
    Columns
        Columns of one length.

    Raises
    ------
    DataError
        If it has no fixes or units that cannot be read.
    """
    known = _known(data)
    t_name = next((name for name in ("TIME_GPS", "TIME") if name in known), "TIME_GPS")
    missing = [name for name in (t_name, *names.FIXES[1:]) if name not in known]
    if missing:
        raise DataError(
            f"{path}: no variable {' and no '.join(missing)}; OG1 has the fixes there, which are "
            "needed, as is the way through the water; a CSV table of dives can give both"
        )
    fixes = [seconds(data, known[t_name], path)]
    fixes += [values(data, known[name]) for name in names.FIXES[1:]]
    if any(fix.shape != fixes[0].shape or fix.ndim != 1 for fix in fixes):
        raise DataError(
            f"{path}: {t_name}, {', '.join(names.FIXES[1:])} differ in length; must be one per fix"
        )
    time = seconds(data, known["TIME"], path) if "TIME" in known else fixes[0]
    same = time.shape == fixes[0].shape

    def column(candidates, read, rows):
        for name in candidates:
            if name in known:
                found = read(data, known[name], path)
                if data[known[name]].ndim == 0:  # one number for the mission
                    found = np.full(rows, found[0])
                if found.shape == (rows,) and np.isfinite(found).any():
                    return found
        return np.full(rows, nan)

    def plain(data, name, _):
        return values(data, name)

    steps = next(
        (pair for pair in (names.STEPS, names.STEPS_GSM) if set(pair) <= set(known)), names.STEPS
    )
    of = {"time": time}
    for key, candidates, read in (
        ("east", steps[:1], metres),
        ("north", steps[1:], metres),
        ("speed", names.SPEED, metres_per_second),
        ("heading", names.HEADING, _degrees),
        ("u", names.EAST, metres_per_second),
        ("v", names.NORTH, metres_per_second),
        ("number", names.NUMBERS, plain),
        ("qc", names.QUALITY, plain),
        ("magvar", names.VARIATION, plain),
        ("depth", names.DEPTH, metres),
        ("depth_max", names.DEPTH_MAX, metres),
        ("phase", ("PHASE",), plain),
    ):
        of[key] = column(candidates, read, time.size)
    kind = column(("GPS_FIX",), plain, fixes[0].size)
    of |= dict(zip(("t_fix", "lat", "lon", "kind"), (*fixes, kind), strict=True))
    if not same:
        count = time.size
        for key in ("t_fix", "lat", "lon", "kind"):
            of[key] = np.concatenate([np.full(count, nan), of[key]])
        of = {
            key: np.concatenate([a, np.full(count + fixes[0].size - a.size, nan)])
            for key, a in of.items()
        }
    return Columns(of, _frame(data, known), f"{known.get(steps[0], steps[0])}")


def fixes_in(of: dict[str, np.ndarray], path: Path) -> tuple[np.ndarray, np.ndarray]:
    """Rows of the fixes by time, and times of what is none.

    Where fixes stand under water too, each was repeated until the next; the first
    of each is taken.

    Parameters
    ----------
    of : dict of str to ndarray
        Columns.
    path : Path
        The file's name, for messages.

    Returns
    -------
    rows : ndarray of int
        Of the fixes, in order of time.
    failed : ndarray
        Times of rows with half a fix, one off the Earth or one at 0 N 0 E.

    Raises
    ------
    DataError
        If the fixes are interpolated under water.
    """
    some = np.isfinite(of["lat"]) | np.isfinite(of["lon"])
    places = zip(of["lat"].tolist(), of["lon"].tolist(), strict=True)
    good = np.array([is_place(*place) and place != (0.0, 0.0) for place in places], dtype=bool)
    good &= some & np.isfinite(of["t_fix"]) & (of["t_fix"] > 0)
    rows = np.flatnonzero(good)
    failed = of["t_fix"][some & ~good]
    deep = of["depth"][rows] > SURFACE
    if deep.any():
        new = [np.diff(of[key][rows], prepend=np.inf) != 0 for key in ("lat", "lon")]
        first = new[0] | new[1]
        if (first & deep).sum() > deep.sum() / 2:
            raise DataError(
                f"{path}: LATITUDE_GPS, LONGITUDE_GPS change under water, {deep.sum()} times; they "
                "must be fixes at the surface, and missing between them"
            )
        rows = rows[first & ~deep]
    return rows[np.argsort(of["t_fix"][rows], kind="stable")], failed


def _known(data: "xarray.Dataset") -> dict[str, str]:
    """Names in the file by their capitals; a name in capitals goes before others."""
    return {str(name).upper(): str(name) for name in sorted(map(str, data.variables), reverse=True)}


def _degrees(data: "xarray.Dataset", name: str, _: Path) -> np.ndarray:
    radians = str(data[name].attrs.get("units", "")).lower().startswith("rad")
    return np.degrees(values(data, name)) if radians else values(data, name)


def _frame(data: "xarray.Dataset", known: dict[str, str]) -> str:
    """Which north the heading has, by the words of its attributes."""
    name = next((known[name] for name in names.HEADING if name in known), None)
    if name is None:
        return ""
    said = " ".join(str(value) for value in data[name].attrs.values()).lower()
    return "magnetic" if "magnetic" in said else "true" if "true" in said else ""
