"""Times, parts, levels and grids of current files: corrected, noted or refused with the remedy.

Levels have the current 0.5 - 0.004 z m/s, whose mean from the surface to D is 0.5 - 0.002 D.
"""

import numpy as np
import pytest
import xarray
from gridded_currents import gridded_current
from refusals import refuses

from clpt_control import ClptError
from clpt_control.currents import fit_current, read_currents

HOURS, LAT, LON = np.arange(25.0), np.linspace(41, 41.6, 7), np.linspace(-70, -69.1, 10)
CURE = "regrid it to latitudes and longitudes, by cdo remapbil or xESMF"
MS = {"units": "m/s"}


def current(units="hours since 2019-03-01", times=HOURS):
    rng = np.random.default_rng(1)
    u, v = rng.normal(0.0, 0.1, (2, 25, 7, 10))
    data = gridded_current(u, v, LAT, LON, HOURS)
    return data.assign_coords(time=("time", times, {"units": units}))


@pytest.mark.parametrize("zone", ["EST", "CET", "PDT", "AEST", "local", "Asia/Tokyo"])
def test_the_name_of_a_time_zone_is_refused(tmp_path, zone):
    current(f"hours since 2019-03-01 00:00 {zone}").to_netcdf(tmp_path / "c.nc")
    said = f"time zone {zone}, .* Write UTC, or an offset such as -5:00"
    refuses(said, fit_current, tmp_path / "c.nc")


OFFSETS = {
    "2019-03-01 00:00 UTC": "2019-03-01T00:00:00",
    "2019-03-01 00:00:00 GMT": "2019-03-01T00:00:00",
    "2019-03-01T00:00:00Z": "2019-03-01T00:00:00",
    "2019-03-01 00:00 -7:00": "2019-03-01T07:00:00",
    "2019-03-01 00:00 UTC-5:00": "2019-03-01T05:00:00",
    "2019-03-01 +5:30": "2019-02-28T18:30:00",
}


@pytest.mark.parametrize(("date", "start"), OFFSETS.items())
def test_universal_time_and_offsets_are_read(tmp_path, date, start):
    current(f"hours since {date}").to_netcdf(tmp_path / "c.nc")
    assert read_currents(tmp_path / "c.nc").start == start


def test_times_that_overflowed_are_refused_or_noted(tmp_path):
    seconds = (2**31 - 10 * 3600 + 3600 * np.arange(25)).astype("i8").astype("i4")
    current("seconds since 1970-01-01", seconds).to_netcdf(tmp_path / "in.nc")
    said = (
        "time goes from 2038-01-19 to 1901-12-13 in one step: its integers overflowed"
    )
    refuses(said, read_currents, tmp_path / "in.nc")
    epoch = np.datetime64("2019-03-01") - np.datetime64("1950-01-01")
    seconds = epoch // np.timedelta64(1, "s") + 3600 * np.arange(25)
    wrapped = seconds.astype("i8").astype("i4")
    current("seconds since 1950-01-01", wrapped).to_netcdf(tmp_path / "all.nc")
    (note,) = fit_current(tmp_path / "all.nc").report["notes"]
    assert note.startswith(
        "time is of the years 1883 to 1883; if they are wrong, its int"
    )
    assert read_currents(current()).notes == ()


def folder(path, **parts):
    path.mkdir()
    for name, data in parts.items():
        data.to_netcdf(path / f"{name}.nc")
    return path


@pytest.mark.long
def test_u_and_v_in_files_of_their_own_are_joined(tmp_path):
    data = current()
    u, v = data[["u"]], data[["v"]]
    single = {
        f"{name}{k:02d}": part.isel(time=k)
        for name, part in (("u", u), ("v", v))
        for k in range(25)
    }
    days = {"u0": u.isel(time=slice(9)), "u1": u.isel(time=slice(9, None)), "v": v}
    apart = [
        folder(tmp_path / "two", u=u, v=v),
        folder(tmp_path / "days", **days),
        folder(tmp_path / "single", **single),
        sorted((tmp_path / "days").iterdir()),
    ]
    for source in apart:
        found = read_currents(source)
        np.testing.assert_array_equal(found.u, data.u)
        np.testing.assert_array_equal(found.v, data.v)
        assert found.notes == ()


def test_parts_that_do_not_fit_are_refused_or_noted(tmp_path):
    u, v = current()[["u"]], current()[["v"]]
    late = folder(tmp_path / "late", u=u, v=v.isel(time=slice(5, None)))
    found = read_currents(late)
    assert found.measured.any(axis=(1, 2)).sum() == 20
    assert found.notes == ("5 steps have values of u or v alone: left out",)
    refuses("no file has the velocity v", read_currents, folder(tmp_path / "u", u=u))
    grid = folder(tmp_path / "grid", u=u, v=v.isel(lat=slice(1, None)))
    refuses("has another lat than", read_currents, grid)
    later = v.assign_coords(time=("time", HOURS + 100, v.time.attrs))
    refuses("no step in common", read_currents, folder(tmp_path / "off", u=u, v=later))


def levels(depths, units="m", scale=1.0, **attributes):
    shape = (25, len(depths), 7, 10)
    u = (0.5 - 0.004 * np.abs(depths) * scale)[:, None, None] * np.ones(shape)
    v = u * np.cos(HOURS)[:, None, None, None]
    data = gridded_current(u, v, LAT, LON, HOURS, depth=np.array(depths, float))
    data.depth.attrs = {"units": units} | attributes
    return data


LEVELS = [0.0, 5.0, 10.0, 30.0, 60.0, 100.0]
MEANS = [
    (levels(np.array(LEVELS)), 50.0, 0.4),
    (levels(np.array(LEVELS[::-1])), 50.0, 0.4),
    (levels(np.array([0.0, -10.0, -60.0]), positive="up"), 20.0, 0.46),
    (levels(np.array([0.0, 500.0, 2000.0]), "cm", 0.01), 10.0, 0.48),
    (levels(np.array([0.0, 20.0])), 500.0, 0.46),  # to the deepest level
    (levels(np.array([10.0, 20.0])), 4.0, 0.46),  # constant above the first level
]


@pytest.mark.parametrize(("data", "depth", "mean"), MEANS)
def test_the_mean_to_a_depth_is_that_of_a_linear_profile(data, depth, mean):
    found = read_currents(data, depth=depth)
    np.testing.assert_allclose(found.u, mean, atol=1e-12)
    np.testing.assert_allclose(found.v[:, 0, 0], mean * np.cos(HOURS), atol=1e-12)
    assert found.notes[-1].startswith("u and v are means from the surface to ")


def test_levels_below_the_sea_floor_are_left_out_of_the_mean():
    data = levels(np.array([0.0, 10.0, 20.0]))
    data["u"] = data.u.where((data.depth < 15) | (data.lat > 41.25))
    found = read_currents(data, depth=20.0)
    np.testing.assert_allclose(found.u[:, 3:], 0.46)
    np.testing.assert_allclose(found.u[:, :3], (0.5 * 0.25 + 0.46 * 0.5) / 0.75)


@pytest.mark.long
def test_the_command_notes_the_level_and_takes_a_depth(tmp_path, printed, clpt):
    levels(np.array(LEVELS)).to_netcdf(tmp_path / "c.nc")
    words = ["fit", tmp_path / "c.nc", "--out", tmp_path / "c.toml"]
    surface = "depth has 6 levels: the level nearest the surface is read, 0 m. --depth"
    assert printed(*words)["notes"][0].startswith(surface)
    assert surface in clpt(*words).out
    mean = "u and v are means from the surface to 50 m, of 5 levels"
    assert printed(*words, "--depth", "50")["notes"] == [mean]
    field = xarray.open_dataset(tmp_path / "c_field.nc")
    np.testing.assert_allclose(
        field.u, 0.4 * 3.6, rtol=1e-2
    )  # km/h, turned to the plane
    refuses("has one level", fit_current, current(), depth=50.0)
    refuses("a number, positive", fit_current, current(), error=ClptError, depth=-1.0)


def on(dims, shape, **more):
    return dims, np.full(shape, 0.1), MS | more


PLACES = np.meshgrid(np.linspace(41, 42, 8), np.linspace(-70, -69, 9), indexing="ij")
TIME = {"units": "hours since 2019-03-01"}
ROMS, MESH = ("ocean_time", "s_rho", "eta_rho", "xi_rho"), ("time", "siglay", "nele")
UNLIKE = {
    "ROMS, on its own axes": (
        {
            "u": on(("ocean_time", "eta_u", "xi_u"), (5, 8, 8)),
            "v": on(("ocean_time", "eta_v", "xi_v"), (5, 7, 9)),
        },
        "lat_rho has the dimensions .*: a curvilinear grid",
    ),
    "ROMS, to the east": (
        {"u_eastward": on(ROMS, (5, 3, 8, 9)), "v_northward": on(ROMS, (5, 3, 8, 9))},
        "lat_rho has the dimensions .*: a curvilinear grid",
    ),
    "FVCOM": (
        {"u": on(MESH, (5, 3, 20)), "v": on(MESH, (5, 3, 20))},
        "on a triangular grid",
    ),
    "FVCOM, mean over depth": (
        {"ua": on(MESH[::2], (5, 20)), "va": on(MESH[::2], (5, 20))},
        "on a triangular grid",
    ),
    "UGRID": (
        {
            "u": on(("time", "faces"), (5, 20), mesh="mesh2d"),
            "v": on(("time", "faces"), (5, 20), mesh="mesh2d"),
        },
        "on a triangular grid",
    ),
}


@pytest.mark.parametrize("model", UNLIKE)
def test_a_grid_that_is_not_regular_is_refused_at_once(model):
    flow, said = UNLIKE[model]
    time = next(iter(flow.values()))[0][0]
    axes = {
        time: (time, np.arange(5.0), TIME),
        "lat_rho": (ROMS[2:], PLACES[0]),
        "lon_rho": (ROMS[2:], PLACES[1]),
    }
    refuses(
        f"{said}; {CURE}.* turn u and v to east",
        fit_current,
        xarray.Dataset(flow, axes),
    )


def test_east_and_north_of_roms_on_a_regular_grid_are_read():
    """Before u and v, which are along the axes of its grid."""
    data = current().rename(time="ocean_time", lat="lat_rho", lon="lon_rho")
    data = data.assign(u_eastward=data.u, v_northward=data.v, u=9 * data.u, v=data.u)
    found = read_currents(data)
    np.testing.assert_array_equal(found.u, current().u)
    np.testing.assert_array_equal(found.v, current().v)
