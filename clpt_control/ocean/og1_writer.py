"""Write dives as an OceanGliders OG1 trajectory file.

A measurement is a fix or a sample of the track, in turn: GPS1, GPS2, samples,
GPSE of each dive.  Positions of samples are dead reckoning plus the share of the
miss that has passed, miss * (time since the fix) / duration, so that the track
ends at the fix after the dive.  `DEPTH`, which OG1 wants, is not known here.
"""

from collections.abc import Iterable
from datetime import UTC, datetime
from math import nan
from pathlib import Path

import numpy as np

from ..files import write_netcdf
from .dives import Dive
from .geodesy import place_from
from .og1_names import EAST, FIXES, GPS1, GPS2, GPSE, NORTH, QUALITY, STEPS, VARIATION

SECONDS = "seconds since 1970-01-01T00:00:00Z"
ATTRIBUTES: dict[str, dict[str, object]] = {
    "TIME": {"long_name": "time of measurement and gps location", "standard_name": "time",
             "units": SECONDS, "calendar": "gregorian"},
    "TIME_GPS": {"long_name": "time of each gps location", "units": SECONDS,
                 "calendar": "gregorian"},
    "LATITUDE_GPS": {"long_name": "latitude of each gps location", "units": "degrees_north"},
    "LONGITUDE_GPS": {"long_name": "longitude of each gps location", "units": "degrees_east"},
    "GPS_FIX": {"long_name": "what the fix is to its dive", "units": "1",
                "flag_values": np.array([0.0, GPS1, GPS2, GPSE]),
                "flag_meanings": "none first_of_the_surfacing last_before_dive first_after_dive"},
    "DIVE_NUMBER": {"long_name": "dive number", "units": "1"},
    "EAST_DISPLACEMENT": {"long_name": "way east through the water since the sample before",
                          "units": "m"},
    "NORTH_DISPLACEMENT": {"long_name": "way north through the water since the sample before",
                           "units": "m"},
    "DAVG_CURR_EAST": {"long_name": "depth-averaged current in eastward direction",
                       "standard_name": "eastward_sea_water_velocity", "units": "m s-1"},
    "DAVG_CURR_NORTH": {"long_name": "depth-averaged current in northward direction",
                        "standard_name": "northward_sea_water_velocity", "units": "m s-1"},
    "DAVG_CURR_EAST_QC": {"long_name": "quality flag of the depth-averaged current",
                          "standard_name": "status_flag", "units": "1"},
    "MAGNETIC_VARIATION": {"long_name": "magnetic variation, east of north", "units": "degrees"},
    "PHASE": {"long_name": "behaviour of the glider at sea", "units": "1",
              "flag_values": np.array([0.0, 3.0]), "flag_meanings": "unknown surfacing"},
    "LATITUDE": {"long_name": "latitude of each measurement and gps location",
                 "standard_name": "latitude", "units": "degrees_north"},
    "LONGITUDE": {"long_name": "longitude of each measurement and gps location",
                  "standard_name": "longitude", "units": "degrees_east"},
}  # fmt: skip


def write_og1(dives: Iterable[Dive], path: str | Path, platform: str = "glider") -> None:
    """Write dives as an OG1 trajectory file.

    Parameters
    ----------
    dives : iterable of Dive
        In the order to write.
    path : str or Path
        The file.
    platform : str
        Name of the vehicle, for the trajectory's identifier.

    Raises
    ------
    DataError
        If the file cannot be written.
    """
    import xarray

    columns = dives_to_rows(dives)
    times = columns["TIME"][np.isfinite(columns["TIME"])]
    first = datetime.fromtimestamp(times.min() if times.size else 0.0, UTC)
    identifier = f"{platform}_{first:%Y%m%dT%H%M%S}_delayed"
    data = xarray.Dataset(
        {name: ("N_MEASUREMENTS", column, ATTRIBUTES[name]) for name, column in columns.items()}
        | {"TRAJECTORY": ((), identifier, {"cf_role": "trajectory_id"})},
        attrs={
            "title": "OceanGliders trajectory file",
            "Conventions": "CF-1.8, ACDD-1.3, OG-1.0",
            "featureType": "trajectory",
            "platform": "Autonomous Underwater Vehicle",
            "platform_vocabulary": "https://vocab.nerc.ac.uk/collection/L06/current/27/",
            "id": identifier,
            "comment": "fixes and dead reckoning of dives; DIVE_NUMBER, displacements and "
            "DAVG_CURR named as by seagliderOG1",
        },
    ).set_coords(["TIME", "LATITUDE", "LONGITUDE"])
    write_netcdf(data, path)


def dives_to_rows(dives: Iterable[Dive]) -> dict[str, np.ndarray]:
    """Give the measurements of an OG1 file in their order.

    Parameters
    ----------
    dives : iterable of Dive
        In the order to write.

    Returns
    -------
    dict of str to ndarray
        A column per OG1 variable.
    """
    names = ("TIME", *FIXES, "GPS_FIX", "DIVE_NUMBER", *STEPS, EAST[0], NORTH[0], QUALITY[0],
             VARIATION[0], "PHASE", "LATITUDE", "LONGITUDE")  # fmt: skip
    rows: list[tuple[float, ...]] = []

    def add(dive, time, fix, kind, steps, place):
        of_dive = (dive.dac_east, dive.dac_north, dive.dac_qc, dive.magvar)
        phase = 3.0 if kind else 0.0  # surfacing; unknown, as depth is not known here
        known = (nan if value is None else value for value in of_dive)
        rows.append((time, *fix, kind, dive.number, *steps, *known, phase, *place))

    for dive in dives:
        if dive.t_gps1 is not None:
            first = (dive.t_gps1, dive.lat_gps1, dive.lon_gps1)
            add(dive, dive.t_gps1, first, GPS1, (nan, nan), first[1:])
        start = (dive.t_gps2, dive.lat_gps2, dive.lon_gps2)
        end = (dive.t_gpse, dive.lat_gpse, dive.lon_gpse)
        time, east, north = _inside(dive)
        add(dive, start[0], start, GPS2, (nan, nan), start[1:])
        at_east, at_north = 0.0, 0.0
        for k in range(len(time)):
            share = time[k] / dive.duration
            step = east[k] - at_east, north[k] - at_north
            at_east, at_north = east[k], north[k]
            way = at_east + share * dive.miss_east, at_north + share * dive.miss_north
            place = place_from(start[1], start[2], *way)
            add(dive, start[0] + time[k], (nan, nan, nan), 0, step, place)
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
