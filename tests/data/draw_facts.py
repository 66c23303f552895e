"""Draw the facts of this folder from the measured files in `../shared/data`, by hand.

    python tests/data/draw_facts.py ../shared/data

Every file keeps its place, format, names, dimensions, types, fill values and packing.  Of
its variables those stay that a reader reads or may take for another, of its attributes
those that say what a number is and whose, and of its samples every k-th.  A displacement
is the sum since the sample that was kept before, so that a dive's total is that of the
whole file; the deepest sample and all fixes stay.  A Slocum's segments are whole.
"""

import shutil
import sys
from pathlib import Path

import netCDF4
import numpy as np

HERE = Path(__file__).parent
PACKAGE = HERE.parents[1] / "clpt_control" / "data"
STEPS = [
    f"{axis}_displacement{model}"
    for axis in ("east", "north")
    for model in ("", "_gsm")
]
SAYS = """
units calendar positive standard_name scale_factor valid_min valid_max comment missing_value
long_name unit_long cf_role coordinates flag_values
"""
MANY = 5  # attributes of a variable: HDF5 spends some 4 kB where there are more
WHOSE = """
dive_number glider platform_id id title summary source institution project license Conventions
featureType file_version base_station_version references date_created naming_authority
creator_name acknowledgment credit trimmed history
"""
LARGE = 500  # numbers that are worth their packing
LONGEST = 200  # characters of an attribute

OF_A_DIVE = """
log_gps_time log_gps_lat log_gps_lon log_gps_hdop log_gps_magvar log_gps_qc GPS1_qc GPS2_qc GPSE_qc
log_DIVE time ctd_time aanderaa4330_results_time aa4831_time depth ctd_depth eng_depth
depth_avg_curr_east depth_avg_curr_north depth_avg_curr_qc depth_avg_curr_error magnetic_variation
flight_avg_speed_east flight_avg_speed_north total_flight_time_s
"""
OF_OG1 = """
TIME TIME_GPS LATITUDE_GPS LONGITUDE_GPS DEPTH HEADING HORZ_GLIDER_SPEED
dive_num
"""
OF_SPRAY = """
profile_index time time_gps latitude_gps longitude_gps time_gps_end latitude_gps_end
longitude_gps_end latitude longitude depth wcur_x wcur_y time_uv latitude_uv longitude_uv
"""


def thinned(source, target, names, kept, summed=()):
    """Copy variables, of each dimension in `kept` the given rows; steps are summed up."""
    target.parent.mkdir(parents=True, exist_ok=True)
    with (
        netCDF4.Dataset(source) as old,
        netCDF4.Dataset(target, "w", format=old.data_model) as new,
    ):
        new.setncatts(kept_of(old, WHOSE.split()))
        own = [name for name in names if name in old.variables]
        used = {dim for name in own for dim in old[name].dimensions}
        for name, dim in old.dimensions.items():
            if name in used:
                count = len(kept.get(name, range(len(dim))))
                new.createDimension(name, None if dim.isunlimited() else count)
        for name in own:
            was = old[name]
            was.set_auto_maskandscale(False)
            values = was[...]
            for axis, dim in enumerate(was.dimensions):
                if dim in kept and name in summed:
                    values = np.add.reduceat(values, np.append(0, kept[dim][:-1] + 1))
                elif dim in kept:
                    values = np.take(values, kept[dim], axis)
            grows = any(old.dimensions[dim].isunlimited() for dim in was.dimensions)
            large = np.size(values) > LARGE and new.data_model != "NETCDF3_CLASSIC"
            how = {"compression": "zlib"} if large else {}
            how["chunksizes"] = values.shape if large or grows else None
            how["fill_value"] = getattr(was, "_FillValue", None)
            made = new.createVariable(name, was.dtype, was.dimensions, **how)
            made.set_auto_maskandscale(False)
            made.setncatts(dict(list(kept_of(was, SAYS.split()).items())[:MANY]))
            made[...] = values


def kept_of(item, names):
    """Return attributes by name, of a long text its beginning."""
    found = {name: item.getncattr(name) for name in names if name in item.ncattrs()}
    long = [
        n
        for n, value in found.items()
        if isinstance(value, str) and len(value) > LONGEST
    ]
    return found | {name: f"{found[name][:LONGEST]} (cut)" for name in long}


def every(k, count, *also):
    """Return the first row, every k-th, the last and some others."""
    return np.unique([0, *range(0, count, k), count - 1, *also])


def dive(source, target, k, copies=1):
    """Draw a dive of a Seaglider basestation; some of its files hold themselves twice."""
    with netCDF4.Dataset(source) as data:
        deepest = {}
        for name in ("depth", "ctd_depth", "eng_depth"):
            if name in data.variables:
                deepest.setdefault(data[name].dimensions[0], []).append(
                    np.nanargmax(data[name][:])
                )
        dims = {
            n: len(dim)
            for n, dim in data.dimensions.items()
            if n.endswith("_data_point")
        }
        kept = {name: every(k, n, *deepest.get(name, ())) for name, n in dims.items()}
    thinned(source, target, OF_A_DIVE.split() + STEPS, kept, STEPS)
    target.write_bytes(target.read_bytes() * copies)


def mission(source, target, names, rows, k):
    """Draw the first rows of an OG1 mission, all fixes among them."""
    with netCDF4.Dataset(source) as data:
        (name,) = (name for name in data.dimensions if name.lower() == "n_measurements")
        fix = next(
            key for key in ("LATITUDE_GPS", "time_gps_end") if key in data.variables
        )
        places = np.ma.filled(data[fix][:rows], np.nan)
        is_new = np.isfinite(places) & (np.diff(places, prepend=np.nan) != 0)
        thinned(source, target, names, {name: every(k, rows, *np.flatnonzero(is_new))})


def dive_rows(source, target):
    """Draw a row for each dive of a vehicle: fixes, dead reckoning and the file's own current."""
    lines = ["dive,t_gps2,lat_gps2,lon_gps2,t_gpse,lat_gpse,lon_gpse"]
    lines[0] += ",dr_east_m,dr_north_m,dac_east,dac_north"
    for path in sorted(source.glob("*.nc")):
        with netCDF4.Dataset(path) as data:
            fixes = [
                data[f"log_gps_{name}"][:].tolist() for name in ("time", "lat", "lon")
            ]
            steps = [float(np.sum(data[name][:])) for name in STEPS[::2]]
            own = [
                float(data[f"depth_avg_curr_{axis}"][...]) for axis in ("east", "north")
            ]
            numbers = [*(column[k] for k in (1, 2) for column in fixes), *steps, *own]
            lines.append(",".join(map(repr, [int(data.dive_number), *numbers])))
    target.write_text("\n".join(lines) + "\n")


def corner(source, target, names, **spans):
    """Draw the hours and the box of a gridded current: dimension = (first, last) value."""
    with netCDF4.Dataset(source) as data:
        kept = {}
        for name, (first, last) in spans.items():
            values = np.arange(len(data[name])) if name == "time" else data[name][:]
            kept[name] = np.flatnonzero((values >= first) & (values <= last))
    thinned(source, target, [*spans, *names], kept)


def segments(source, target):
    """Draw a Slocum's segments, whole, and of their list of sensors those that are logged."""
    (source_list,) = (source / "cac").glob("6b016a2e.cac")
    logged = [line.split() for line in source_list.read_bytes().splitlines()]
    total, logged = len(logged), [words for words in logged if words[3] != b"-1"]
    for k, words in enumerate(logged):
        words[2] = b"%d" % k
    for folder in ("sbd", "cac"):
        (target / folder).mkdir(parents=True, exist_ok=True)
    lines = (b" ".join(words) + b"\n" for words in logged)
    (target / "cac" / source_list.name).write_bytes(b"".join(lines))
    for file in sorted((source / "sbd").glob("*.sbd")):
        head, tag, cycles = file.read_bytes().partition(b"sensor_list_factored")
        counts = (b"total_num_sensors:    %d\n" % n for n in (total, len(logged)))
        (target / "sbd" / file.name).write_bytes(head.replace(*counts) + tag + cycles)


def main(shared):
    """Draw all of them."""
    for number in range(304, 310):
        name = f"glider/basestation/p5420{number}.nc"
        whole = number == 306  # the one that tests damage
        dive(shared / name, HERE / name, 8 if whole else 24, 2 if whole else 1)
    for number in range(100, 103):
        name = f"glider/sg171/p1710{number}.nc"
        dive(shared / name, HERE / name, 16)
    dive_rows(shared / "glider/sg171", HERE / "glider/sg171_dives.csv")
    for name, names, rows, k in (
        ("sg015_20040929T140907_delayed.nc", OF_OG1.split(), 2002, 4),
        ("sp028_20230202T1637_R.nc", OF_SPRAY.split(), 372, 6),
    ):
        mission(
            shared / "glider/og1" / name, HERE / "glider/og1" / name, names, rows, k
        )
    segments(shared / "glider/slocum_rosie", HERE / "glider/slocum_rosie")
    for name in ("sea035m10_dives.csv", "sg542_2016_dives.csv", "sg171_adcp.csv"):
        shutil.copyfile(shared / "glider" / name, HERE / "glider" / name)
    radar = {"time": (0, 23), "lat": (40.84, 41.61), "lon": (-69.98, -68.92)}
    rtofs = {"time": (0, 8), "lat": (47.5, 48.1), "lon": (-125.3, -124.2)}
    cmems = {"time": (0, 5), "latitude": (24.0, 31.0), "longitude": (-84.0, -76.0)}
    shipped = "maracoos_hfr_2019-01-01.nc"  # with the package
    corner(shared / "field" / shipped, PACKAGE / shipped, ("u", "v"), **radar)
    grids, target = shared / "grids", HERE / "grids"
    for name, names, spans in (
        ("wa_RTOFS_global.nc", ("water_u", "water_v"), rtofs),
        ("cmems_1deg.nc", ("uo", "vo", "depth"), cmems),
    ):
        corner(grids / name, target / name, names, **spans)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(Path(sys.argv[1]))
