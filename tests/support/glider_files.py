"""Glider files in the dialects of other vehicles, made of a vehicle whose displacement is known.

It swims on the equator at VELOCITY (m/s east and north) from FIRST seconds after the fix
before the dive to LAST before the one after it, in a triangle to DEPTH, while a
current carries its fixes by DRIFT degrees of longitude.  On the equator a degree of
longitude is 6378137 m * pi/180 (WGS84), so every number is known without a reader.
"""

from tempfile import TemporaryDirectory

import netCDF4
import numpy as np

from clpt_control.gliders import read_dives, write_dive_table

VELOCITY = np.array([0.24, -0.10])  # m/s through the water, east and north
T0, DURATION, FIRST, LAST, DEPTH = 1.5e9, 9000.0, 60.0, 140.0, 400.0
DRIFT = 0.04  # degrees of longitude between the fixes
SWUM = VELOCITY * (DURATION - FIRST - LAST)  # m
GPS_EAST = 6378137.0 * np.radians(DRIFT)  # m
VARIATION = -15.0  # degrees east
SPEED, BEARING = np.hypot(*VELOCITY), np.degrees(np.arctan2(*VELOCITY))


def dives_in(path):
    """Return the dives of a file."""
    return read_dives(path, usable=False)[0]


def used_numbers(dives):
    """Return the numbers of the dives that are used, read back from a table."""
    if not dives:
        return []
    with TemporaryDirectory() as folder:
        write_dive_table(dives, f"{folder}/dives.csv")
        return [dive.number for dive in read_dives(f"{folder}/dives.csv")[0]]


def error_of(dive):
    """Return fix less dead reckoning, m, and how far it is from the file's own current, m/s."""
    error = dive.miss
    own = np.array([dive.dac_east, dive.dac_north], float)
    return error, np.hypot(*(error / dive.duration - own))


def swim(count):
    """Return times since the fix, depths and steps of a dive, steps (count, 2)."""
    since = np.linspace(FIRST, DURATION - LAST, count)
    depth = DEPTH * (1 - np.abs(2 * (since - FIRST) / (since[-1] - FIRST) - 1))
    return since, depth, np.diff(since, prepend=FIRST)[:, None] * VELOCITY


def current():
    """Return the current averaged over the dive, m/s."""
    return np.array([GPS_EAST - SWUM[0], -SWUM[1]]) / DURATION


def write(path, variables, attributes=(), form="NETCDF4", drop=()):
    """Write variables of (dimensions, numbers, attributes); a number has no dimension."""
    with netCDF4.Dataset(path, "w", format=form) as data:
        data.setncatts(dict(attributes))
        for name, (dims, numbers, attrs) in variables.items():
            if name not in drop:
                for dim, size in zip(dims, np.shape(numbers), strict=True):
                    if dim not in data.dimensions:
                        data.createDimension(dim, size)
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
CTD, TRUCK, INFO = ("ctd_data_point",), ("sg_data_point",), ("gps_info",)


def in_all(number, lon, of, steps):
    """Return what both versions of basestations say alike; steps by the dimension `of`."""
    times, lats, lons = fixes(number, lon)
    u = current()
    return times[1], {
        "log_gps_time": (INFO, times, EPOCH),
        "log_gps_lat": (INFO, lats, {}),
        "log_gps_lon": (INFO, lons, {}),
        "east_displacement": (of, steps[:, 0], M),
        "north_displacement": (of, steps[:, 1], M),
        "depth_avg_curr_east": ((), u[0], {}),
        "depth_avg_curr_north": ((), u[1], {}),
    }


def basestation(path, number=7, lon=8.0, drop=(), count=400, **changed):
    """Write a dive as basestations of version 2 do: one dimension, classic NetCDF."""
    since, depth, steps = swim(count)
    start, variables = in_all(number, lon, TRUCK, steps)
    variables |= {
        "time": (TRUCK, start + since, EPOCH),
        "ctd_time": (TRUCK, start + since + 0.5, EPOCH),
        "depth": (TRUCK, depth, M),
        "magnetic_variation": ((), VARIATION, {}),
    }
    return write(
        path, variables | changed, {"dive_number": number}, "NETCDF3_CLASSIC", drop
    )


def basestation3(path, number=7, lon=8.0, drop=(), count=1800, **changed):
    """Write a dive as basestation3 does: a dimension per instrument, NetCDF-4."""
    since, depth, steps = swim(count)
    slow, shallow, _ = swim(300)
    start, variables = in_all(number, lon, CTD, steps)
    variables |= {
        "log_gps_hdop": (INFO, [0.9, 0.9, 1.1], {}),
        "log_gps_magvar": (INFO, np.full(3, VARIATION), {}),
        "time": (TRUCK, start + slow, EPOCH),
        "eng_depth": (TRUCK, 100 * shallow, CM),
        "legato_time": (("legato_data_point",), start + since, EPOCH),
        "ctd_time": (CTD, start + since, EPOCH),
        "ctd_depth": (CTD, depth, M),
    }
    return write(path, variables | changed, {"dive_number": number}, drop=drop)


MAGNETIC = {"units": "degrees", "comment": "Vehicle heading (magnetic)"}


def og1_rows(numbers=(1, 2, 3), lon=8.0, count=400):
    """Return the columns of an OG1 mission: GPS1, GPS2, samples, GPSE of each dive."""
    columns: dict[str, list] = {}
    (since, depth, steps), nan, u = swim(count), np.nan, current()
    for number in numbers:
        times, lats, lons = fixes(number, lon + DRIFT * (number - 1))
        for name, samples, fix in (
            ("TIME", times[1] + since, times),
            ("LATITUDE_GPS", nan, lats),
            ("LONGITUDE_GPS", nan, (lons + 180.0) % 360.0 - 180.0),
            ("DEPTH", depth, 0.0),
            ("PHASE", np.where(since < DURATION / 2, 2.0, 1.0), 3.0),
            ("divenum", number, number),
            ("EAST_DISPLACEMENT", steps[:, 0], nan),
            ("NORTH_DISPLACEMENT", steps[:, 1], nan),
            ("DAVG_CURR_EAST", u[0], nan),
            ("DAVG_CURR_NORTH", u[1], nan),
            ("GLIDER_HORZ_VELO_MODEL", 100 * SPEED, nan),
            ("HEADING", (BEARING - VARIATION) % 360.0, nan),
        ):
            row, ends = np.broadcast_to(samples, count), np.broadcast_to(fix, 3)
            columns.setdefault(name, []).append(
                np.concatenate([ends[:2], row, ends[2:]])
            )
    return {name: np.concatenate(parts) for name, parts in columns.items()}


MS = {"units": "m/s"}
UNITS = {
    "TIME": EPOCH,
    "DEPTH": {"units": "m"},
    "DAVG_CURR_EAST": MS,
    "DAVG_CURR_NORTH": MS,
}
UNITS |= {"GLIDER_HORZ_VELO_MODEL": {"units": "cm/s"}, "HEADING": MAGNETIC}


def og1(path, drop=(), columns=None, units=None, **more):
    """Write an OG1 mission of the early dialect: no TIME_GPS, `divenum`."""
    columns, of = og1_rows() if columns is None else columns, UNITS | (units or {})
    rows = {
        k: (("N_MEASUREMENTS",), a, of.get(k, {}))
        for k, a in columns.items()
        if k not in drop
    }
    return write(path, rows | more)
