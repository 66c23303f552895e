"""Reader of gridded currents, local plane, gaps, and the field block."""

import netCDF4
import numpy as np
import pytest
import xarray
from gridded_currents import as_it_is, gridded_current, saying
from paths import DATA
from refusals import refuses

from clpt_control.currents import read_currents, sample_currents

GRIDS = DATA / "grids"
BOX = (40.9, 41.55, -69.9, -69.0)
LAT, LON, TIME = (
    np.linspace(41.0, 41.5, 6),
    np.linspace(-69.9, -69.1, 8),
    np.arange(10.0),
)


def sample():
    rng = np.random.default_rng(7)
    return rng.normal(size=(2, len(TIME), len(LAT), len(LON)))


def write(path, u, v, lat=LAT, lon=LON, time=TIME, depth=None, change=as_it_is, **how):
    """Write a gridded current, of which one thing is changed."""
    made = gridded_current(
        u, v, lat, lon, time, since="2019-01-01 06:00:00", depth=depth
    )
    change(made).to_netcdf(path, **how)
    return path


def standard(data):
    """Names by which nothing is found, and standard ones."""
    saying("u", standard_name="eastward_sea_water_velocity", units="cm s-1")(data)
    saying("v", standard_name="northward_sea_water_velocity", units="cm s-1")(data)
    return data.rename(u="east", v="north")


def named(data):
    return saying("u v", units="km/h")(data).rename(u="water_u", v="water_v")


def reversed_axes(data):
    return data.isel(lat=slice(None, None, -1), time=slice(None, None, -1))


SPELLINGS = [
    (1.0, as_it_is, {}),
    (100.0, saying("u v", units="cm/s"), {}),
    (100.0, standard, {}),
    (3.6, named, {}),
    (1.0, reversed_axes, {}),
    (1.0, lambda data: data.transpose("lon", "time", "lat"), {}),
    (1.0, as_it_is, {"lon": LON + 360}),
    (1.0, saying("time", units="minutes since 2019-01-01 06:00"), {"time": TIME * 60}),
    (1.0, saying("time", units="Hours Since 2019-01-01 06:00"), {}),
    (1.0, saying("time", units="days since 2019-01-01"), {"time": TIME / 24 + 0.25}),
]


@pytest.mark.parametrize(("size", "change", "axes"), SPELLINGS)
def test_every_spelling_gives_the_same_current(tmp_path, size, change, axes):
    u, v = sample()
    path = write(tmp_path / "c.nc", size * u, size * v, change=change, **axes)
    for box in (None, BOX):
        currents = read_currents(path, box)
        np.testing.assert_allclose(currents.u, u, atol=1e-12)
        np.testing.assert_allclose(currents.v, v, atol=1e-12)
        np.testing.assert_array_equal(currents.lat, LAT)
        np.testing.assert_allclose(currents.time, TIME, atol=1e-9)
        assert currents.start == "2019-01-01T06:00:00"
    np.testing.assert_allclose(currents.lon, LON, atol=1e-9)


def levels(u, v):
    """A second level, 20 m/s faster."""
    return [np.stack([part, part + 20.0], axis=1) for part in (u, v)]


def test_level_nearest_the_surface_is_taken(tmp_path):
    u, v = sample()
    how = {"depth": [0.5, 10.0], "change": saying("depth", units=None)}
    currents = read_currents(write(tmp_path / "d.nc", *levels(u, v), **how))
    np.testing.assert_array_equal(currents.u, u)
    assert currents.box == (41.0, 41.5, -69.9, -69.1)


def packed(scale, fill):
    """How u and v are written in 16 bits."""
    how = {"dtype": "i2", "scale_factor": scale, "_FillValue": fill}
    return {"encoding": {"u": how, "v": how}}


def test_packed_values_and_gaps_of_either_component(tmp_path):
    u, v = np.round(sample(), 2)
    u[2, 3, 4] = v[5, 1, 0] = np.nan
    currents = read_currents(
        write(tmp_path / "c.nc", u, v, **packed(0.01, -32768)), BOX
    )
    gap = np.isnan(u) | np.isnan(v)
    np.testing.assert_array_equal(~currents.measured, gap)
    np.testing.assert_array_equal(np.isnan(currents.v), gap)
    np.testing.assert_allclose(currents.u[~gap], u[~gap], atol=1e-12)


@pytest.mark.parametrize("gap", [-32768, -32767, 32767])
def test_packed_gaps_that_the_fill_value_does_not_name_are_refused(tmp_path, gap):
    scale = 1e-4  # of which every number of 16 bits is a speed that a sea has
    whole = np.round(0.1 * sample() / scale)
    whole[:, 2:4, :, 1] = gap
    path = write(tmp_path / "c.nc", *whole * scale, **packed(scale, -999))
    said = f"u is exactly {gap * scale:.6g} at 12 of 479 places, .*: a fill value"
    refuses(said, read_currents, path)
    right = write(tmp_path / "c.nc", *whole * scale, **packed(scale, gap))
    assert np.isnan(read_currents(right).u[2:4, :, 1]).all()
    whole[:, 2:4, :, 1] = 0
    whole *= 32767 / np.abs(whole).max()  # whole range: its ends are data
    path = write(tmp_path / "c.nc", *np.rint(whole) * scale, **packed(scale, -32768))
    assert np.isfinite(read_currents(path).u).all()


@pytest.mark.parametrize("unlimited", [(), ("time",)])
@pytest.mark.parametrize("kind", ["NETCDF3_CLASSIC", "NETCDF3_64BIT"])
def test_every_cut_of_a_classic_file_is_refused(tmp_path, kind, unlimited):
    write(tmp_path / "whole.nc", *sample(), format=kind, unlimited_dims=unlimited)
    whole = (tmp_path / "whole.nc").read_bytes()
    np.testing.assert_array_equal(read_currents(tmp_path / "whole.nc").u, sample()[0])
    for percent in (1, 50, 99.99):
        (tmp_path / "cut.nc").write_bytes(whole[: int(percent * len(whole) / 100)])
        refuses(
            "cut.nc: damaged or cut short: less than",
            read_currents,
            tmp_path / "cut.nc",
        )


@pytest.mark.parametrize(
    ("box", "rows"), [(None, (0, 8)), ((41, 41.5, 178.5, -178.5), (3, 6))]
)
def test_a_file_or_a_box_across_180_degrees_has_no_jump(tmp_path, box, rows):
    u, v = sample()
    lon = np.array([176.0, 177, 178, 179, -180, -179, -178, -177])
    currents = read_currents(write(tmp_path / "c.nc", u, v, lon=lon), box)
    np.testing.assert_array_equal(currents.lon, np.arange(176, 184)[slice(*rows)])
    np.testing.assert_array_equal(currents.u, u[:, :, slice(*rows)])


def test_a_grid_around_the_earth_begins_where_the_file_does(tmp_path):
    # the last step is shorter, roundings differ
    lon = np.arange(-180.0, 180.0, 0.7) + 0.1
    u, v = 0.3 * np.random.default_rng(2).normal(size=(2, 10, 6, len(lon)))
    path = write(tmp_path / "c.nc", u, v, lon=lon)
    np.testing.assert_array_equal(read_currents(path).lon, lon)


@pytest.mark.parametrize("step", [1.0, -1.0])
def test_a_grid_that_ends_with_its_first_meridian_is_as_one_that_does_not(
    tmp_path, step
):
    lon = np.arange(-180.0, 181.0)[:: int(step)]
    u, v = 0.3 * np.random.default_rng(2).normal(size=(2, 10, 6, 361))
    u[..., -1], v[..., -1] = u[..., 0], v[..., 0]
    closed, open_ = write(tmp_path / "c.nc", u, v, lon=lon), tmp_path / "o.nc"
    write(open_, u[..., :-1], v[..., :-1], lon=lon[:-1])
    for box in (None, (41.0, 41.5, 178.0, -178.0)):
        one, other = (read_currents(path, box) for path in (closed, open_))
        for name in ("lat", "lon", "u", "v"):
            np.testing.assert_array_equal(getattr(one, name), getattr(other, name))
    np.testing.assert_array_equal(one.lon, np.arange(178.0, 183.0))


def empty(name):
    axes = {"lat": LAT, "lon": LON, name: np.zeros(0)}
    return {
        "flow": np.zeros((2, 10, len(axes["lat"]), len(axes["lon"]))),
        name: np.zeros(0),
    }


def time_says(units, **more):
    return saying("time", units=units, **more)


def no_dates(calendar):
    return time_says("hours since 2019-02-28 20:00", calendar=calendar)


def of_levels(depth, **attributes):
    return {
        "flow": levels(*sample()),
        "depth": depth,
        "change": saying("depth", **attributes),
    }


SOUTH = np.where(LAT > 41.2, LAT, np.nan)
REFUSED = [  # a change, or how a file is written, and what is said of it
    (time_says("hours since 01/02/2019"), "time has units 'hours since 01/02/2019'"),
    (time_says(None), "time has units '' and .* must be such as 'hours since"),
    (
        lambda data: data.rename(u="p"),
        "no eastward velocity: .*'eastward_sea_water_velocity'.*p, v",
    ),
    (lambda data: data.drop_vars("lat"), "no latitude: .*standard_name 'latitude'"),
    (saying("u", units=None), "u has no units. Give units"),
    (saying("u", units="kelvin"), "u: units = 'kelvin' is not a speed"),
    (
        lambda data: data.assign_coords(lat=data.lat.astype(str)),
        "lat has the type .*; must be numbers",
    ),
    (time_says("hours since 0001-01-01"), "'hours since 0001.* and no calendar"),
    (no_dates("360_day"), "calendar '360_day', whose dates are not real. Convert"),
    (no_dates("mayan"), "calendar 'mayan'; must be such as"),
    (no_dates(""), "calendar ''; must be such as"),
    (
        {"time": TIME * np.nan},
        "time is not finite at 10 of 10 steps, .* data.isel.time=data.time",
    ),
    ({"lat": SOUTH}, "lat reaches nan; must be a latitude"),
    ({"time": np.zeros(10)}, "time has a time twice."),
    (
        {"lon": np.append(LON[:-1], LON[2] + 360.0 + 1e-10)},
        "lon has a value twice .0 and",
    ),
    ({"flow": sample()[:, :1], "time": TIME[:1]}, "time has 1 of the 2 required steps"),
    ({"flow": np.full((2, 10, 6, 8), np.nan)}, "no finite value in the box"),
    ({"flow": np.full((2, 10, 6, 8), 9999.0)}, "reaches 9999 m/s: check its units"),
    (of_levels([-30.0, -1.0]), "reaches"),
    (
        of_levels([0.5, 10.0], standard_name="height_above_sea_floor"),
        "depth counts up from",
    ),
    (of_levels([0.5, 10.0], positive="up"), "depth counts up from"),
    (empty("lat"), "lat has the length zero; must have at least one"),
    (empty("lon"), "lon has the length zero; must have at least one"),
]


@pytest.mark.parametrize(("how", "sentence"), REFUSED)
def test_each_mistake_of_a_file_is_one_sentence(tmp_path, how, sentence):
    how = {"flow": sample(), **(how if isinstance(how, dict) else {"change": how})}
    refuses(sentence, read_currents, write(tmp_path / "c.nc", *how.pop("flow"), **how))


def test_each_mistake_of_a_box_is_one_sentence(tmp_path):
    path = write(tmp_path / "c.nc", *sample())
    for box, sentence in (
        (
            (50, 51, -69.9, -69),
            "lat has 0 of the 2 cells that are needed; it goes from 41 to 41.5",
        ),
        ((41.0, 41.05, -69.9, -69), "lat has 1 of the 2 cells"),
        ((41.0, 41.5, -69.0, -69.9), "must be SOUTH NORTH"),
        ((41.0, np.inf, -69.9, -69), "must be SOUTH NORTH"),
    ):
        refuses(sentence, read_currents, path, box)


PLACES = np.meshgrid(
    np.linspace(41.0, 41.3, 4), np.linspace(-69.3, -69.0, 4), indexing="ij"
)


def flow_on(*dims):
    flow = (("time", *dims), np.full((5, *(4,) * len(dims)), 0.3), {"units": "m/s"})
    time = ("time", np.arange(5.0), {"units": "hours since 2019-01-01"})
    return {"u": flow, "v": flow, "time": time}


def places_on(*dims):
    """Latitudes and longitudes of a grid, or of single places."""
    lat, lon = PLACES if len(dims) == 2 else (PLACES[0][:, 0], PLACES[1][0])
    return {"lat": (dims, lat), "lon": (dims, lon)}


CURVED = r"lat has the dimensions \(y, x\): a curvilinear grid; regrid it .* cdo remapbil or xESMF"
PROJECTED = {
    n: (n, np.arange(4.0), {"standard_name": f"projection_{n}_coordinate"})
    for n in "xy"
}
UNLIKE = [
    (("y", "x"), places_on("y", "x"), CURVED),
    (("node",), places_on("node"), "lat and lon are along node, not a grid; regrid it"),
    (
        ("y", "x"),
        PROJECTED,
        "has a projected grid, of x and y, and no latitude; regrid it",
    ),
]


@pytest.mark.parametrize(("dims", "axes", "sentence"), UNLIKE)
def test_other_grids_are_refused_with_the_cure(tmp_path, dims, axes, sentence):
    xarray.Dataset(flow_on(*dims) | axes).to_netcdf(tmp_path / "grid.nc")
    for column in (False, True):
        refuses(sentence, read_currents, tmp_path / "grid.nc", column=column)


def test_units_can_be_given_where_a_file_has_none(refused, facts, tmp_path):
    path = facts / "grids/wa_RTOFS_global.nc"
    refuses("water_u has no units.*--units", read_currents, path)
    metres, knots = read_currents(path, units="m/s"), read_currents(path, units="knots")
    assert np.nanmax(np.abs(knots.u * 3600 / 1852 - metres.u)) < 1e-9
    said = write(tmp_path / "said.nc", *sample())
    sentence = "u is in 'm/s'; units = 'cm/s' is for a file without"
    refuses(sentence, read_currents, said, units="cm/s")
    assert read_currents(said, units="m s-1").u.max() == pytest.approx(
        sample()[0].max()
    )
    assert "furlongs" in refused(
        "fit", path, "--out", tmp_path / "s.toml", "--units", "furlongs"
    )


def test_a_wind_is_no_current_whatever_its_name(tmp_path):
    path = write(
        tmp_path / "c.nc", *sample(), change=saying("u", standard_name="eastward_wind")
    )
    refuses("no eastward velocity", read_currents, path)
    with netCDF4.Dataset(path, "a") as file:
        file.createVariable("uo", "f8", file["v"].dimensions)[:] = file["v"][:]
        file["uo"].units = "m/s"
    currents = read_currents(path)
    np.testing.assert_array_equal(currents.u, currents.v)


def test_an_attribute_of_several_numbers_is_no_name_and_no_unit(tmp_path):
    numbers = saying("u lat", standard_name=np.arange(3))
    path = write(tmp_path / "c.nc", *sample(), change=numbers)
    assert read_currents(path).u.shape == read_currents(path).v.shape
    write(
        path,
        *sample(),
        change=lambda data: saying("u", units=np.arange(3))(numbers(data)),
    )
    refuses(r"u.*\[0 1 2\]", read_currents, path, units="m/s")


def test_maracoos_is_read_as_its_provenance_says():
    currents = read_currents(sample_currents(), BOX)
    assert (currents.u.shape, currents.start) == ((24, 12, 16), "2019-01-01T00:00:00")
    assert (~currents.measured).mean() == pytest.approx(0.28, abs=0.005)
    assert currents.measured.all(axis=0).sum() == 84
    speed = np.sqrt(np.nanmean(currents.u**2 + currents.v**2))
    assert speed == pytest.approx(0.52, abs=0.02)


def test_a_global_model_is_read_as_netcdf4_reads_it():
    """CMEMS: float32 latitudes, whole days, m s-1, land as NaN."""
    currents = read_currents(GRIDS / "cmems_1deg.nc")
    with netCDF4.Dataset(GRIDS / "cmems_1deg.nc") as file:
        names = "uo", "latitude", "longitude", "time"
        u, lat, lon, days = (np.ma.filled(file[name][:], np.nan) for name in names)
    np.testing.assert_allclose(currents.lat, np.sort(lat))
    np.testing.assert_allclose(currents.lon, np.sort(lon))
    np.testing.assert_allclose(currents.time, 24.0 * (days - days[0]))
    np.testing.assert_allclose(currents.u, u[:, np.argsort(lat)])
    assert currents.start == "2024-01-03T00:00:00"
    assert not currents.measured.all()  # Florida


def test_a_chosen_name_against_its_standard_name_is_refused(tmp_path):
    """By standard names east is eastward: as v it would turn the current."""
    write(tmp_path / "c.nc", *sample(), change=standard)
    right = read_currents(tmp_path / "c.nc", names={"u": "east", "v": "north"})
    np.testing.assert_array_equal(right.u, read_currents(tmp_path / "c.nc").u)
    said = "north as the eastward velocity: its standard_name is northward_sea_water_"
    swapped = {"u": "north", "v": "east"}
    refuses(said, read_currents, tmp_path / "c.nc", names=swapped)
