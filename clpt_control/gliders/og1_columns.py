"""Columns of an OG1 file: whatever it calls them, under one name, in SI units.

Case does not matter.  OG1 1.0 standardizes the fixes, `TIME`, `DEPTH` and `PHASE`;
numbers of dives, displacements, the flight model's speed and the depth-averaged
current are named as by seagliderOG1 and votoutils, or kept from the basestation.

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
from .samples import SURFACE, metres, metres_per_second, seconds, values

if TYPE_CHECKING:
    import xarray

FIXES = ("TIME_GPS", "LATITUDE_GPS", "LONGITUDE_GPS")
STEPS = ("EAST_DISPLACEMENT", "NORTH_DISPLACEMENT")
STEPS_GSM = ("EAST_DISPLACEMENT_GSM", "NORTH_DISPLACEMENT_GSM")
HEADING = ("HEADING", "GLIDER_HEADING", "ENG_HEAD")


class Columns(NamedTuple):
    """Columns by name, and what the file says of its heading.

    `t_fix`, `lat`, `lon` are of the fixes; `time`, `east`, `north` (steps, m), `speed`,
    `heading` (degrees), `u`, `v`, `number`, `qc`, `magvar`, `depth`, `depth_max` and
    `phase` of the measurements.
    """

    of: dict[str, np.ndarray]
    north: str  # "magnetic", "true" or "" where the file does not say
    steps: str  # name of the displacement


def is_known(data: "xarray.Dataset") -> bool:
    """Whether a NetCDF file is an OG1 trajectory."""
    known = _known(data)
    return "N_MEASUREMENTS" in data.dims or any(name in known for name in FIXES)


def columns_of(data: "xarray.Dataset", path: Path) -> Columns:
    """Return the columns of a file, of one length."""
    known = _known(data)
    t_name = next((name for name in ("TIME_GPS", "TIME") if name in known), "TIME_GPS")
    missing = [name for name in (t_name, *FIXES[1:]) if name not in known]
    if missing:
        raise DataError(
            f"{path}: no variable {' and no '.join(missing)}; OG1 has the fixes there, which are "
            "needed, as is the displacement through the water; a CSV table of dives can give both"
        )
    fixes = [seconds(data, known[t_name], path)]
    fixes += [values(data, known[name]) for name in FIXES[1:]]
    if any(fix.shape != fixes[0].shape or fix.ndim != 1 for fix in fixes):
        raise DataError(
            f"{path}: {t_name}, {', '.join(FIXES[1:])} differ in length; must be one per fix"
        )
    time = seconds(data, known["TIME"], path) if "TIME" in known else fixes[0]
    steps = next((pair for pair in (STEPS, STEPS_GSM) if set(pair) <= set(known)), STEPS)
    of = {"time": time}
    for key, candidates, read in (
        ("east", steps[:1], metres),
        ("north", steps[1:], metres),
        ("speed", ("GLIDER_HORZ_VELO_MODEL", "HORZ_SPEED", "HORZ_SPEED_GSM"), metres_per_second),
        ("heading", HEADING, _degrees),
        ("u", ("DAVG_CURR_EAST", "UCUR", "DAC_EAST", "DEPTH_AVG_CURR_EAST"), metres_per_second),
        ("v", ("DAVG_CURR_NORTH", "VCUR", "DAC_NORTH", "DEPTH_AVG_CURR_NORTH"), metres_per_second),
        ("number", ("DIVE_NUMBER", "DIVE_NUM", "DIVENUM", "DIVE_NUM_CAST"), _plain),
        ("qc", ("DAVG_CURR_EAST_QC", "DAVG_CURR_QC", "DEPTH_AVG_CURR_QC"), _plain),
        ("magvar", ("MAGNETIC_VARIATION",), _plain),
        ("depth", ("DEPTH", "GLIDER_DEPTH"), metres),
        ("depth_max", ("DEPTH_MAX",), metres),
        ("phase", ("PHASE",), _plain),
    ):
        of[key] = np.full(time.size, nan)
        for name in (known[one] for one in candidates if one in known):
            found = read(data, name, path)
            if data[name].ndim == 0:  # one number for the mission
                found = np.full(time.size, found[0])
            if found.shape == time.shape and np.isfinite(found).any():
                of[key] = found
                break
    of |= dict(zip(("t_fix", "lat", "lon"), fixes, strict=True))
    if time.shape != fixes[0].shape:  # fixes on a dimension of their own
        count, further = time.size, fixes[0].size
        of = {
            key: np.concatenate([np.full(count, nan), column])
            if key in ("t_fix", "lat", "lon")
            else np.concatenate([column, np.full(further, nan)])
            for key, column in of.items()
        }
    return Columns(of, _frame(data, known), f"{known.get(steps[0], steps[0])}")


def fixes_in(of: dict[str, np.ndarray], path: Path) -> tuple[np.ndarray, np.ndarray]:
    """Return rows of the fixes by time, and times of rows with half a fix or one off the Earth.

    Where fixes stand under water too, each was repeated until the next; the first
    of each is taken.
    """
    some = np.isfinite(of["lat"]) | np.isfinite(of["lon"])
    places = zip(of["lat"].tolist(), of["lon"].tolist(), strict=True)
    good = np.array([is_place(*place) and place != (0.0, 0.0) for place in places], dtype=bool)
    good &= some & np.isfinite(of["t_fix"]) & (of["t_fix"] > 0)
    rows = np.flatnonzero(good)
    failed = of["t_fix"][some & ~good]
    deep = of["depth"][rows] > SURFACE
    if deep.any():
        moved = [np.diff(of[key][rows], prepend=np.inf) != 0 for key in ("lat", "lon")]
        first = moved[0] | moved[1]
        wrong = rows[first & deep]
        if wrong.size > deep.sum() / 2:
            others = f" and {wrong.size - 1} more rows" if wrong.size > 1 else ""
            raise DataError(
                f"{path}: LATITUDE_GPS, LONGITUDE_GPS have a new fix {of['depth'][wrong[0]]:.0f} m "
                f"under water in row {wrong[0]}{others} (the first row is 0); fixes are made at "
                "the surface: set both to NaN there"
            )
        rows = rows[first & ~deep]
    return rows[np.argsort(of["t_fix"][rows], kind="stable")], failed


def _known(data: "xarray.Dataset") -> dict[str, str]:
    """Return names in the file by their capitals; a name in capitals goes before others."""
    return {str(name).upper(): str(name) for name in sorted(map(str, data.variables), reverse=True)}


def _plain(data: "xarray.Dataset", name: str, _: Path) -> np.ndarray:
    return values(data, name)


def _degrees(data: "xarray.Dataset", name: str, _: Path) -> np.ndarray:
    radians = str(data[name].attrs.get("units", "")).lower().startswith("rad")
    return np.degrees(values(data, name)) if radians else values(data, name)


def _frame(data: "xarray.Dataset", known: dict[str, str]) -> str:
    """Return which north the heading has, by the words of its attributes."""
    name = next((known[name] for name in HEADING if name in known), None)
    if name is None:
        return ""
    said = " ".join(str(value) for value in data[name].attrs.values()).lower()
    return "magnetic" if "magnetic" in said else "true" if "true" in said else ""
