"""Write dives as an OceanGliders OG1 trajectory file.

A measurement is a fix or a sample of the track, in turn: GPS1, GPS2, samples,
GPSE of each dive.  Positions of samples are dead reckoning plus the share of the
miss that has passed, miss * (time since the fix) / duration, so that the track
ends at the fix after the dive.  `DEPTH`, which OG1 wants, is known at the fixes
only; the greatest depth of a dive is `DEPTH_MAX` in each of its rows.
"""

from collections.abc import Iterable, Mapping
from datetime import UTC, datetime
from importlib.metadata import version
from math import nan
from pathlib import Path
from time import time

import numpy as np

from ..files import write_netcdf
from ..geodesy import place_from
from .dives import Dive
from .og1_attributes import ATTRIBUTES, NOT_KNOWN, SCALARS
from .og1_names import (
    DEPTH,
    DEPTH_MAX,
    EAST,
    FIXES,
    GPS1,
    GPS2,
    GPSE,
    NORTH,
    QUALITY,
    STEPS,
    VARIATION,
)


def write_og1(
    dives: Iterable[Dive],
    path: str | Path,
    platform: str = "glider",
    attributes: Mapping[str, str] | None = None,
) -> None:
    """Write dives as an OG1 trajectory file.

    Parameters
    ----------
    dives : iterable of Dive
        In the order to write.
    path : str or Path
        The file.
    platform : str
        Name of the vehicle, for the trajectory's identifier.
    attributes : mapping of str to str, optional
        Global attributes that dives do not know, such as `contributor_name`;
        those that OG1 wants and that are not given are "unknown".

    Raises
    ------
    DataError
        If the file cannot be written.
    """
    import xarray

    columns = dives_to_rows(dives)
    fixes = np.flatnonzero(np.isfinite(columns["TIME_GPS"]))
    first = int(fixes[np.argmin(columns["TIME_GPS"][fixes])]) if fixes.size else None
    deployed = [nan if first is None else float(columns[name][first]) for name in FIXES]
    start = _stamp(0.0 if first is None else deployed[0])
    identifier = f"{platform}_{start}_delayed"
    now = _stamp(time())
    scalars = (identifier, "unknown", platform, "unknown", *deployed)
    data = xarray.Dataset(
        {name: ("N_MEASUREMENTS", column, ATTRIBUTES[name]) for name, column in columns.items()}
        | {name: ((), value, SCALARS[name]) for name, value in zip(SCALARS, scalars, strict=True)},
        attrs={
            "title": "OceanGliders trajectory file",
            "Conventions": "CF-1.10, ACDD-1.3, OG-1.0",
            "featureType": "trajectory",
            "platform": "sub-surface gliders",
            "platform_vocabulary": "https://vocab.nerc.ac.uk/collection/L06/current/27/",
            "id": identifier,
            "summary": "fixes of a glider's dives and its dead reckoning between them",
            "keywords": "glider, dead reckoning, depth-averaged current",
            "rtqc_method": "No QC applied",
            "start_date": start,
            "date_created": now,
            "history": f"{now}: written by clpt-control {version('clpt-control')}",
            "comment": "DIVE_NUMBER, displacements and DAVG_CURR named as by seagliderOG1",
        }
        | dict.fromkeys(NOT_KNOWN, "unknown")
        | dict(attributes or {}),
    ).set_coords(["TIME", "LATITUDE", "LONGITUDE", "DEPTH"])
    write_netcdf(data, path)


def _stamp(when: float) -> str:
    """Date and time of day as OG1 has it in names and attributes."""
    try:
        return f"{datetime.fromtimestamp(when, UTC):%Y%m%dT%H%M%S}"
    except (OverflowError, ValueError, OSError):
        return f"{datetime.fromtimestamp(0.0, UTC):%Y%m%dT%H%M%S}"


def dives_to_rows(dives: Iterable[Dive]) -> dict[str, np.ndarray]:
    """Return the measurements of an OG1 file in their order.

    Parameters
    ----------
    dives : iterable of Dive
        In the order to write.

    Returns
    -------
    dict of str to ndarray
        A column per OG1 variable.
    """
    names = (
        "TIME",
        *FIXES,
        "GPS_FIX",
        "DIVE_NUMBER",
        *STEPS,
        EAST[0],
        NORTH[0],
        QUALITY[0],
        VARIATION[0],
        DEPTH_MAX[0],
        "PHASE",
        "LATITUDE",
        "LONGITUDE",
        DEPTH[0],
    )
    rows: list[tuple[float, ...]] = []

    def add(dive, at, fix, kind, steps, place):
        of_dive = (dive.dac_east, dive.dac_north, dive.dac_qc, dive.magvar, dive.depth_max)
        phase = 3.0 if kind else 0.0  # surfacing; unknown, as depth is not known here
        known = (nan if value is None else value for value in of_dive)
        rows.append(
            (at, *fix, kind, dive.number, *steps, *known, phase, *place, 0.0 if kind else nan)
        )

    for dive in dives:
        if dive.t_gps1 is not None:
            first = (dive.t_gps1, dive.lat_gps1, dive.lon_gps1)
            add(dive, dive.t_gps1, first, GPS1, (nan, nan), first[1:])
        start = (dive.t_gps2, dive.lat_gps2, dive.lon_gps2)
        end = (dive.t_gpse, dive.lat_gpse, dive.lon_gpse)
        when, east, north = _inside(dive)
        add(dive, start[0], start, GPS2, (nan, nan), start[1:])
        at_east, at_north = 0.0, 0.0
        for k in range(len(when)):
            share = when[k] / dive.duration
            step = east[k] - at_east, north[k] - at_north
            at_east, at_north = east[k], north[k]
            way = at_east + share * dive.miss_east, at_north + share * dive.miss_north
            place = place_from(start[1], start[2], *way)
            add(dive, start[0] + when[k], (nan, nan, nan), 0, step, place)
        rest = dive.dr_east - at_east, dive.dr_north - at_north
        add(dive, end[0], end, GPSE, rest, end[1:])
    columns = np.array(rows, dtype=float).reshape(-1, len(names)).T
    return dict(zip(names, columns, strict=True))


def _inside(dive: Dive) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Samples of the track strictly between the fixes."""
    if dive.track is None:
        return np.array([]), np.array([]), np.array([])
    time, east, north = dive.track
    within = (time > 0) & (time < dive.duration)
    return time[within], east[within], north[within]
