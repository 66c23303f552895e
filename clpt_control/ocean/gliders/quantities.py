"""Quantities of glider files: their names, and numbers in SI units.

One table serves OG1 (`og1_columns`) and the Seaglider basestation (`seaglider`).  Case does not
matter.  OG1 1.0 standardizes the fixes, `TIME`, `DEPTH` and `PHASE`, its vocabulary `WCUR_X`,
`WCUR_Y` and `DEAD_RECKONING`; numbers of dives, displacements, the flight model's speed and the
depth-averaged current are named as by seagliderOG1 and votoutils, or by the basestation.
"""

from collections.abc import Iterator

import numpy as np
import xarray

from ...base.errors import DataError
from ...paper.currents.flags import said
from .samples import (
    HEADINGS,
    VARIATIONS,
    metres,
    metres_per_second,
    seconds,
    values,
    within,
)

PLACES = ("TIME", "LATITUDE", "LONGITUDE")
PLACE = ("lat", "lon")
HEADING = ("HEADING", "GLIDER_HEADING", "ENG_HEAD")
# of a dive: how names end
ENDS = {"after": "_GPS_END", "before": "_GPS", "middle": "_UV"}


def _degrees(data: xarray.Dataset, name: str) -> np.ndarray:
    radians = said(data[name]).lower().startswith("rad")
    return np.degrees(values(data, name)) if radians else values(data, name)


ANGLES = {"heading": HEADINGS, "magvar": VARIATIONS}


def checked_angles(
    angles: np.ndarray, key: str, units: str, name: str
) -> tuple[np.ndarray, list[str]]:
    """Return angles (degrees), NaN outside their limits, and notes."""
    low, high = ANGLES[key]
    angles, outside = within(angles, (low, high))
    notes = []
    if outside.any():
        notes.append(
            f"{outside.sum()} numbers of {name} are not within {low:g} to {high:g} degrees: "
            "taken as gaps"
        )
    if key == "heading":
        notes += _doubtful_units(angles[np.isfinite(angles)], units, name)
    return angles, notes


def _doubtful_units(angles: np.ndarray, units: str, name: str) -> list[str]:
    """Refuse headings that look like radians and do not say so; return notes on the units."""
    small = angles.any() and np.abs(angles).max() <= 2 * np.pi
    if units.lower().startswith("rad") or not small:
        return []
    said_degrees = units.lower().startswith("deg") or "\N{DEGREE SIGN}" in units
    if said_degrees and np.ptp(angles) <= np.pi:
        doubt = f"{name} has only numbers within 2 pi, and the units {units!r}"
        return [f"{doubt}; if they are radians, set its units to 'radian'"]
    raise DataError(
        f"{name} has the units {units!r} and only numbers within 2 pi, which look like radians. "
        "Set its units to 'radian', or to 'degrees' if they are degrees"
    )


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
    names, (candidates, read) = known_names(data), QUANTITIES[key]
    for name in (names[known] for known in candidates if known in names):
        yield name, read(data, name)


def pairs_of(data: xarray.Dataset, key: str, other: str) -> Iterator[tuple[str, str]]:
    """Yield names of the variables of two components, such as east and north."""
    names = known_names(data)
    for pair in zip(QUANTITIES[key][0], QUANTITIES[other][0], strict=True):
        if {*pair} <= {*names}:
            yield names[pair[0]], names[pair[1]]
