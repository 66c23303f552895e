"""Glider files in the dialects of other vehicles, made of a vehicle whose displacement is known.

It swims on the equator at VELOCITY (m/s east and north) from FIRST seconds after the fix
before the dive to LAST before the one after it, in a triangle to DEPTH, while a
current carries its fixes by DRIFT degrees of longitude.  On the equator a degree of
longitude is 6378137 m * pi/180 (WGS84), so every number is known without a reader.
"""

import netCDF4
import numpy as np

from clpt_control.gliders.dive_files import read_dive_file

VELOCITY = np.array([0.24, -0.10])  # m/s through the water, east and north
T0, DURATION, FIRST, LAST, DEPTH = 1.5e9, 9000.0, 60.0, 140.0, 400.0
DRIFT = 0.04  # degrees of longitude between the fixes
SWUM = VELOCITY * (DURATION - FIRST - LAST)  # m
GPS_EAST = 6378137.0 * np.radians(DRIFT)  # m
VARIATION = -15.0  # degrees east
SPEED, BEARING = np.hypot(*VELOCITY), np.degrees(np.arctan2(*VELOCITY))


def dives_in(path):
    """Return the dives of a file."""
    return read_dive_file(path)[0]


def swim(count):
    """Return times since the fix, depths and steps of a dive, steps (count, 2)."""
    since = np.linspace(FIRST, DURATION - LAST, count)
    depth = DEPTH * (1 - np.abs(2 * (since - FIRST) / (since[-1] - FIRST) - 1))
    return since, depth, np.diff(since, prepend=FIRST)[:, None] * VELOCITY


def current():
    """Return the current averaged over the dive, m/s."""
    return np.array([GPS_EAST - SWUM[0], -SWUM[1]]) / DURATION


def write(path, sizes, variables, attributes=(), form="NETCDF4"):
    """Write variables of (dimensions, numbers, attributes); a number has no dimension."""
    with netCDF4.Dataset(path, "w", format=form) as data:
        data.setncatts(dict(attributes))
        for name, size in sizes.items():
            data.createDimension(name, size)
        for name, (dims, numbers, attrs) in variables.items():
            made = data.createVariable(name, np.asarray(numbers).dtype, dims)
            made[...] = numbers
            made.setncatts(attrs)
    return path


def fixes(number, lon):
    """Return GPS1, GPS2 and GPSE of a dive: times, latitudes, longitudes."""
    start = T0 + (number - 1) * 10000.0
    lons = np.array([lon, lon, (lon + DRIFT + 180.0) % 360.0 - 180.0])
    return np.array([start - 300.0, start, start + DURATION]), np.zeros(3), lons


EPOCH = {"units": "seconds since 1970-1-1 00:00:00"}
CM, M = {"units": "cm"}, {"units": "meters"}
CTD = ("ctd_data_point",)


def in_all(number, lon, of, steps):
    """Return what both versions of basestations say alike; steps by the dimension `of`."""
    times, lats, lons = fixes(number, lon)
    info, u = ("gps_info",), current()
    return times[1], {
        "log_gps_time": (info, times, EPOCH),
        "log_gps_lat": (info, lats, {}),
        "log_gps_lon": (info, lons, {}),
        "east_displacement": (of, steps[:, 0], M),
        "north_displacement": (of, steps[:, 1], M),
        "depth_avg_curr_east": ((), u[0], {}),
        "depth_avg_curr_north": ((), u[1], {}),
    }


def basestation(path, number=7, lon=8.0, drop=(), count=400, **changed):
    """Write a dive as basestations of version 2 do: one dimension, classic NetCDF."""
    since, depth, steps = swim(count)
    of = ("sg_data_point",)
    start, variables = in_all(number, lon, of, steps)
    variables |= {
        "time": (of, start + since, EPOCH),
        "ctd_time": (of, start + since + 0.5, EPOCH),
        "depth": (of, depth, M),
        "magnetic_variation": ((), VARIATION, {}),
    }
    variables = {k: v for k, v in (variables | changed).items() if k not in drop}
    sizes = {"sg_data_point": count, "gps_info": 3}
    return write(path, sizes, variables, {"dive_number": number}, "NETCDF3_CLASSIC")


def basestation3(path, number=7, lon=8.0, drop=(), count=1800, sizes=(), **changed):
    """Write a dive as basestation3 does: a dimension per instrument, NetCDF-4."""
    since, depth, steps = swim(count)
    slow, shallow, _ = swim(300)
    truck, info = ("sg_data_point",), ("gps_info",)
    start, variables = in_all(number, lon, CTD, steps)
    variables |= {
        "log_gps_hdop": (info, [0.9, 0.9, 1.1], {}),
        "log_gps_magvar": (info, np.full(3, VARIATION), {}),
        "time": (truck, start + slow, EPOCH),
        "eng_depth": (truck, 100 * shallow, CM),
        "legato_time": (("legato_data_point",), start + since, EPOCH),
        "ctd_time": (CTD, start + since, EPOCH),
        "ctd_depth": (CTD, depth, M),
    }
    variables = {k: v for k, v in (variables | changed).items() if k not in drop}
    own = {"ctd_data_point": count, "sg_data_point": 300, "legato_data_point": count}
    return write(path, own | {"gps_info": 3} | dict(sizes), variables, {"dive_number": number})


MAGNETIC = {"units": "degrees", "comment": "Vehicle heading (magnetic)"}


def og1_rows(numbers=(1, 2, 3), lon=8.0, count=400):
    """Return the columns of an OG1 mission: GPS1, GPS2, samples, GPSE of each dive."""
    columns: dict[str, list] = {}
    since, depth, steps = swim(count)
    for number in numbers:
        times, lats, lons = fixes(number, lon + DRIFT * (number - 1))
        nothing = np.full(count, np.nan)
        phase = np.where(since < DURATION / 2, 2.0, 1.0)
        for name, samples, fix in (
            ("TIME", times[1] + since, times),
            ("LATITUDE_GPS", nothing, lats),
            ("LONGITUDE_GPS", nothing, (lons + 180.0) % 360.0 - 180.0),
            ("DEPTH", depth, np.zeros(3)),
            ("PHASE", phase, np.full(3, 3.0)),
            ("divenum", np.full(count, number), np.full(3, number)),
            ("EAST_DISPLACEMENT", steps[:, 0], np.full(3, np.nan)),
            ("NORTH_DISPLACEMENT", steps[:, 1], np.full(3, np.nan)),
            ("DAVG_CURR_EAST", np.full(count, current()[0]), np.full(3, np.nan)),
            ("DAVG_CURR_NORTH", np.full(count, current()[1]), np.full(3, np.nan)),
            ("GLIDER_HORZ_VELO_MODEL", np.full(count, 100 * SPEED), np.full(3, np.nan)),
            ("HEADING", np.full(count, (BEARING - VARIATION) % 360.0), np.full(3, np.nan)),
        ):
            rows = np.concatenate([fix[:2], samples, fix[2:]])
            columns.setdefault(name, []).append(rows)
    return {name: np.concatenate(parts) for name, parts in columns.items()}


UNITS = {
    "TIME": EPOCH,
    "DEPTH": {"units": "m"},
    "GLIDER_HORZ_VELO_MODEL": {"units": "cm/s"},
    "HEADING": MAGNETIC,
    "DAVG_CURR_EAST": {"units": "m/s"},
    "DAVG_CURR_NORTH": {"units": "m/s"},
}


def og1(path, drop=(), columns=None, units=None, sizes=(), **more):
    """Write an OG1 mission of the early dialect: no TIME_GPS, `divenum`."""
    columns = og1_rows() if columns is None else columns
    of = UNITS | (units or {})
    variables = {
        name: (("N_MEASUREMENTS",), numbers, of.get(name, {}))
        for name, numbers in columns.items()
        if name not in drop
    }
    own = {"N_MEASUREMENTS": len(columns["TIME"])}
    return write(path, own | dict(sizes), variables | more)
