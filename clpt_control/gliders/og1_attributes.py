"""Attributes of the variables of an OG1 file, as CF and the OG1.0 manual have them.

`ATTRIBUTES` is per measurement, `SCALARS` per mission; `NOT_KNOWN` are global
attributes that OG1 wants and a dive does not know.
"""

import numpy as np

from .og1_names import GPS1, GPS2, GPSE

SECONDS = "seconds since 1970-01-01T00:00:00Z"
ATTRIBUTES: dict[str, dict[str, object]] = {
    "TIME": {
        "long_name": "time of measurement and gps location",
        "standard_name": "time",
        "units": SECONDS,
        "calendar": "gregorian",
    },
    "TIME_GPS": {
        "long_name": "time of each gps location",
        "units": SECONDS,
        "calendar": "gregorian",
    },
    "LATITUDE_GPS": {
        "long_name": "latitude of each gps location",
        "standard_name": "latitude",
        "units": "degrees_north",
    },
    "LONGITUDE_GPS": {
        "long_name": "longitude of each gps location",
        "standard_name": "longitude",
        "units": "degrees_east",
    },
    "GPS_FIX": {
        "long_name": "what the fix is to its dive",
        "units": "1",
        "flag_values": np.array([0.0, GPS1, GPS2, GPSE]),
        "flag_meanings": "none first_of_the_surfacing last_before_dive first_after_dive",
    },
    "DIVE_NUMBER": {"long_name": "dive number", "units": "1"},
    "EAST_DISPLACEMENT": {
        "long_name": "way east through the water since the sample before",
        "units": "m",
    },
    "NORTH_DISPLACEMENT": {
        "long_name": "way north through the water since the sample before",
        "units": "m",
    },
    "DAVG_CURR_EAST": {
        "long_name": "depth-averaged current in eastward direction",
        "standard_name": "eastward_sea_water_velocity",
        "units": "m s-1",
    },
    "DAVG_CURR_NORTH": {
        "long_name": "depth-averaged current in northward direction",
        "standard_name": "northward_sea_water_velocity",
        "units": "m s-1",
    },
    "DAVG_CURR_EAST_QC": {
        "long_name": "quality flag of the depth-averaged current",
        "standard_name": "status_flag",
        "units": "1",
        "flag_values": np.array([0.0, 1, 2, 3, 4, 5, 6, 8, 9]),
        "flag_meanings": "no_change good probably_good probably_bad bad "
        "changed unsampled interpolated missing",
    },
    "MAGNETIC_VARIATION": {"long_name": "magnetic variation, east of north", "units": "degree"},
    "DEPTH_MAX": {"long_name": "greatest depth of the dive", "units": "m"},
    "PHASE": {
        "long_name": "behaviour of the glider at sea",
        "units": "1",
        "flag_values": np.array([0.0, 3.0]),
        "flag_meanings": "unknown surfacing",
    },
    "LATITUDE": {
        "long_name": "latitude of each measurement and gps location",
        "standard_name": "latitude",
        "units": "degrees_north",
    },
    "LONGITUDE": {
        "long_name": "longitude of each measurement and gps location",
        "standard_name": "longitude",
        "units": "degrees_east",
    },
    "DEPTH": {
        "long_name": "depth of the glider, known at the fixes only",
        "standard_name": "depth",
        "units": "m",
        "positive": "down",
        "axis": "Z",
    },
}
SCALARS: dict[str, dict[str, object]] = {
    "TRAJECTORY": {"cf_role": "trajectory_id", "long_name": "trajectory name"},
    "PLATFORM_MODEL": {"long_name": "model of the glider"},
    "PLATFORM_SERIAL_NUMBER": {"long_name": "glider serial number"},
    "WMO_IDENTIFIER": {"long_name": "WMO identifier"},
    "DEPLOYMENT_TIME": {
        "long_name": "time of the first fix",
        "standard_name": "time",
        "units": SECONDS,
        "calendar": "gregorian",
    },
    "DEPLOYMENT_LATITUDE": {
        "long_name": "latitude of the first fix",
        "standard_name": "latitude",
        "units": "degrees_north",
    },
    "DEPLOYMENT_LONGITUDE": {
        "long_name": "longitude of the first fix",
        "standard_name": "longitude",
        "units": "degrees_east",
    },
}
NOT_KNOWN = (
    "contributor_name",
    "contributor_email",
    "contributor_role",
    "contributor_role_vocabulary",
    "contributing_institutions",
    "contributing_institutions_role",
    "contributing_institutions_role_vocabulary",
)
