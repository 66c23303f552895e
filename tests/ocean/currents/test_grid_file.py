"""A gridded current as Zarr, in files, in blocks; its plane, gaps that are filled, the field."""

import numpy as np
import pytest
import xarray
from gridded_currents import gridded_current
from pyproj import Geod
from refusals import refuses
from scipy.interpolate import make_interp_spline
from xarray.backends.netCDF4_ import NetCDF4ArrayWrapper

from clpt_control.base.files import write_file
from clpt_control.base.geodesy import LocalPlane
from clpt_control.currents import fit_current, read_currents
from clpt_control.engine.model.block import evaluate
from clpt_control.paper.blocks.field import gridded_flow
from clpt_control.paper.currents import plane
from clpt_control.paper.currents.plane import fill_gaps
from clpt_control.paper.scenario.tables import Units
from clpt_control.replay import read_flow_model

HOURS = np.arange(26.0)
LAT, LON = np.linspace(40.9, 41.5, 7), np.linspace(-69.9, -69.0, 8)


def current(land=False):
    """Return a tide that differs from place to place; no water in a corner where there is land."""
    tide = np.cos(2 * np.pi * HOURS / 12.42)[:, None, None]
    u = 0.3 * tide * np.linspace(0.8, 1.2, 7)[:, None] + 0.1 * np.linspace(0, 1, 8)
    v = 0.2 * tide + 0.05 + 0 * u
    if land:
        u[:, :2, :3] = v[:, :2, :3] = 0.0
    return gridded_current(u, v, LAT, LON, HOURS, since="2024-01-01")


def same(a, b):
    assert a.start == b.start
    for name in ("lat", "lon", "depth", "time", "u", "v"):
        np.testing.assert_allclose(getattr(a, name), getattr(b, name), atol=1e-12)


def test_land_as_zeros_is_a_gap_and_is_said(tmp_path):
    still = current().assign(u=0 * current().u, v=0 * current().v)
    for name in "uv":
        still[name].attrs = {"units": "m/s"}
    for name, data in (
        ("land", current(land=True)),
        ("sea", current()),
        ("still", still),
    ):
        data.to_netcdf(tmp_path / f"{name}.nc")
    land, sea, still = (
        read_currents(tmp_path / f"{n}.nc") for n in ("land", "sea", "still")
    )
    assert (land.land, sea.land, (~land.measured).sum()) == (6, 0, 6 * 26)
    assert not land.measured[:, :2, :3].any()
    assert still.measured.all()  # water at rest everywhere
    report = fit_current(tmp_path / "land.nc", rows=2, columns=2).report
    assert report["cells_of_zeros_taken_as_land"] == report["cells_never_measured"] == 6
    assert "6 cells of nothing but zeros" in read_flow_model(tmp_path / "land.nc").about
    assert "zeros" not in read_flow_model(tmp_path / "sea.nc").about


@pytest.mark.parametrize("form", [2, 3])
def test_zarr_is_read_as_the_file_is(tmp_path, form):
    pytest.importorskip("zarr")
    current().to_netcdf(tmp_path / "c.nc")
    current().to_zarr(tmp_path / "c.zarr", zarr_format=form, consolidated=form == 2)
    plain = read_currents(tmp_path / "c.nc")
    same(read_currents(tmp_path / "c.zarr"), plain)
    box = (41.0, 41.3, -69.8, -69.2)
    same(read_currents(tmp_path / "c.zarr", box), read_currents(tmp_path / "c.nc", box))
    assert (
        fit_current(tmp_path / "c.zarr", rows=2, columns=2).report["samples"]
        == plain.u.size
    )
    assert read_flow_model(tmp_path / "c.zarr").source == "c.zarr"
    metadata = tmp_path / "c.zarr" / ("zarr.json" if form == 3 else ".zgroup")
    metadata.write_text("{")
    refuses(r"c\.zarr: cannot be read as Zarr", read_currents, tmp_path / "c.zarr")


def test_files_of_one_current_are_joined(tmp_path):
    whole = current()
    whole.to_netcdf(tmp_path / "c.nc")
    plain = read_currents(tmp_path / "c.nc")
    folder = tmp_path / "days"
    folder.mkdir()
    (folder / "readme.txt").write_text("x")
    for k, steps in enumerate((slice(0, 1), slice(1, 14), slice(12, 26))):
        part = whole.isel(time=steps)
        if k == 1:  # the step that the third file has too, and an epoch of its own
            part = part.copy(deep=True)
            part["u"][11:] = 0.45
            part["time"] = (
                "time",
                part.time.values - 1,
                {"units": "hours since 2024-01-01 01:00"},
            )
        part.to_netcdf(folder / f"day{k}.nc")
    same(read_currents(folder), plain)
    same(
        read_currents(folder, column=True),
        read_currents(tmp_path / "c.nc", column=True),
    )
    assert fit_current(folder, rows=2, columns=2).report["source"] == "days"
    assert read_flow_model(folder).source == "days"
    whole.isel(lat=slice(1, None)).to_netcdf(folder / "other.nc")
    refuses(r"other\.nc has another lat than day0\.nc", read_currents, folder)


@pytest.mark.parametrize("minutes", [1, 5, 10, 20, 30])
def test_a_step_of_two_files_is_one_however_it_is_counted(tmp_path, minutes):
    """A sixth of an hour has no end in binary: hours since 1970 differed by 6e-11 h."""
    dates = np.datetime64("2019-01-01T03:00") + np.timedelta64(
        minutes, "m"
    ) * np.arange(15)
    for k, since in enumerate(("2019-01-01", "1950-01-01")):
        days = (dates[5 * k : 5 * k + 10] - np.datetime64(since)) / np.timedelta64(
            1, "D"
        )
        part = current().isel(time=range(10))
        part["time"] = ("time", days, {"units": f"days since {since}"})
        part["u"][:] = k
        part.to_netcdf(tmp_path / f"day{k}.nc")
    found = read_currents(tmp_path)
    np.testing.assert_allclose(found.time, minutes / 60 * np.arange(15), atol=1e-12)
    np.testing.assert_array_equal(found.u[:, 0, 0], [0.0] * 5 + [1.0] * 10)


def test_a_folder_without_a_current_is_one_sentence(tmp_path):
    refuses("has neither Zarr nor NetCDF files", read_currents, tmp_path)
    current().isel(time=[3]).to_netcdf(tmp_path / "3.nc")
    refuses("has 1 of the 2", read_currents, tmp_path)


def test_a_box_is_read_as_one_block(tmp_path, monkeypatch):
    """Of columns that are not a slice, as across 180 degrees, each unpacked the whole step."""
    lat, lon = np.linspace(-80, 80, 161), np.arange(-180.0, 180.0, 0.25)
    one = np.random.default_rng(1).integers(-900, 900, (3, 161, 1440)) / 1000.0
    whole = {"zlib": True, "complevel": 1, "chunksizes": (1, 161, 1440)}
    data = gridded_current(one, one, lat, lon, HOURS[:3])
    data.to_netcdf(tmp_path / "c.nc", encoding={"u": whole, "v": whole})
    blocks, read = [], NetCDF4ArrayWrapper.__getitem__
    monkeypatch.setattr(
        NetCDF4ArrayWrapper,
        "__getitem__",
        lambda of, key: blocks.append(key.tuple) or read(of, key),
    )
    for box in ((10, 12, 10, 15), (10, 12, 177.5, -177.5)):
        blocks.clear()
        found = read_currents(tmp_path / "c.nc", box)
        steps = [key for key in blocks if len(key) == 3]
        assert len(steps) == 2  # of u and of v
        assert all(isinstance(part, slice) for key in steps for part in key)
    rows = np.flatnonzero((lat >= 10) & (lat <= 12))
    columns = [*range(1430, 1440), *range(11)]
    np.testing.assert_allclose(found.u, one[:, rows][:, :, columns])


NANTUCKET = LocalPlane(41.225, -69.45)


def test_plane_both_ways_and_true_distances():
    rng = np.random.default_rng(1)
    lat, lon = 41.225 + rng.uniform(-0.5, 0.5, 50), -69.45 + rng.uniform(-0.5, 0.5, 50)
    x1, x2 = NANTUCKET.to_plane(lat, lon)
    back = NANTUCKET.to_earth(x1, x2)
    np.testing.assert_allclose(back, [lat, lon], atol=1e-9)
    _, _, metres = Geod(ellps="WGS84").inv(
        np.full(50, -69.45), np.full(50, 41.225), lon, lat
    )
    np.testing.assert_allclose(np.hypot(x1, x2), metres / 1000, rtol=1e-9)
    refuses("Choose a smaller box", NANTUCKET.to_plane, 60.0, -69.0)
    refuses("km from the origin", NANTUCKET.to_plane, np.nan, -69.0)
    refuses("latitude", LocalPlane, 91.0, 0.0)


def test_velocities_turn_as_displacements_do():
    geod = Geod(ellps="WGS84")
    for lat, lon in ((41.5, -69.0), (40.9, -69.9), (41.2, -68.0)):
        for bearing in (0.0, 35.0, 90.0, 200.0):
            lon1, lat1, _ = geod.fwd(lon, lat, bearing, 1.0)  # one metre further
            here, there = NANTUCKET.to_plane(lat, lon), NANTUCKET.to_plane(lat1, lon1)
            moved = 1000 * (np.array(there) - np.array(here))
            u, v = np.sin(np.radians(bearing)), np.cos(np.radians(bearing))
            np.testing.assert_allclose(
                NANTUCKET.rotate(lat, lon, u, v), moved, atol=2e-4
            )
    leaning = NANTUCKET.rotate(41.5, -69.0, 0.0, 1.0)[0]
    # 0.3 degrees: what is forgotten without turning
    assert 0.004 < abs(leaning) < 0.007


def test_filling_keeps_measured_values_and_their_range():
    rng = np.random.default_rng(3)
    u, v = rng.normal(size=(2, 8, 6, 7))
    gap = rng.random(u.shape) < 0.4
    gap[:, :2, :2] = True  # a corner that was never seen
    u[gap] = np.nan
    *full, filled = fill_gaps(
        np.arange(8.0), np.arange(6.0) * 6, np.arange(7.0) * 5, u, v
    )
    np.testing.assert_array_equal(np.array(full)[:, ~gap], [u[~gap], v[~gap]])
    assert np.all(np.isfinite(full))
    assert np.nanmin(u) <= full[0].min()
    assert full[0].max() <= np.nanmax(u)
    np.testing.assert_array_equal(filled, gap)


EVEN = 0.3 * np.arange(6.0), 4 * np.arange(5.0), 6 * np.arange(7.0)
UNEVEN = (
    np.array([0, 1, 3, 4, 7.0]),
    np.array([0, 5, 6, 9.0]),
    np.array([-3, 0, 1, 8, 9.0]),
)


HARMONIC = [
    (EVEN, lambda t, y, x: (2 * (10 * t) ** 2 - x**2 - y**2, x * y + x**2 - y**2)),
    (UNEVEN, lambda t, y, x: (1 + 2 * x - y + 0.3 * t, 5 - t)),
]


@pytest.mark.parametrize(("axes", "flow"), HARMONIC)
def test_filling_solves_the_laplace_equation(axes, flow):
    """What is harmonic in (10 km/h t, x2, x1) comes back from its edges alone."""
    uv = np.array(flow(*np.meshgrid(*axes, indexing="ij")))
    with_gap = uv.copy()
    with_gap[:, 1:-1, 1:-1, 1:-1] = np.nan
    *full, _ = fill_gaps(*axes, *with_gap)
    np.testing.assert_allclose(full, uv, atol=1e-10)


def test_field_of_a_plane_flow_is_that_flow():
    """A flow linear in plane and time comes out the same on the regular grid."""
    local = LocalPlane(41.25, -69.5)
    x1, x2 = local.to_plane(LAT[:, None], LON[None, :])
    uneven = np.array([0.0, 1.0, 2.5, 3.0, 4.5, 6.0])
    t = uneven[:, None, None]
    u, v = 1 + 0.02 * x1 - 0.03 * x2 + 0.1 * t, 0.01 * x2 + 0.001 * x1 * x2 - 0.2 * t
    field = plane.regular_grid(
        uneven, LAT, LON, u, v, local, np.zeros(u.shape[1:], bool)
    )
    np.testing.assert_allclose(field.time, np.linspace(0, 6, 6))
    T, Y, X = np.meshgrid(field.time, field.x2, field.x1, indexing="ij")
    np.testing.assert_allclose(field.u, 1 + 0.02 * X - 0.03 * Y + 0.1 * T, atol=1e-6)
    np.testing.assert_allclose(field.v, 0.01 * Y + 0.001 * X * Y - 0.2 * T, atol=1e-6)


def random_field():
    rng = np.random.default_rng(5)
    axes = np.linspace(0, 6, 7), np.linspace(-20, 20, 6), np.linspace(-30, 30, 8)
    return plane.GriddedField(*axes, *rng.normal(size=(2, 7, 6, 8)))


@pytest.mark.parametrize(
    "units", [Units(length="km", time="h"), Units(length="m", time="s")]
)
def test_field_file_read_back_equals_the_data_at_nodes(tmp_path, units):
    field = random_field()
    data = plane.field_dataset(field, Units(length="km", time="h"), {"title": "test"})
    write_file(tmp_path / "f.nc", data)
    read = plane.read_field(tmp_path / "f.nc", units)
    T, Y, X = (
        w.ravel() for w in np.meshgrid(read.time, read.x2, read.x1, indexing="ij")
    )
    values = evaluate(gridded_flow(read), T, np.column_stack([X, Y]))
    size = 1.0 if units.length == "km" else 1000.0 / 3600.0
    wanted = size * np.column_stack([field.u.ravel(), field.v.ravel()])
    np.testing.assert_allclose(values, wanted, atol=1e-12)
    assert read.x1[-1] == pytest.approx(30.0 if units.length == "km" else 30000.0)


def test_field_block_equals_scipys_interpolating_spline():
    """Independent: B-splines by collocation, not-a-knot, axis after axis."""
    field = random_field()
    rng = np.random.default_rng(6)
    t, x2, x1 = (
        rng.uniform(0, 6, 40),
        rng.uniform(-20, 20, 40),
        rng.uniform(-30, 30, 40),
    )
    mine = evaluate(gridded_flow(field), t, np.column_stack([x1, x2]))
    for k in range(40):
        for component, values in enumerate((field.u, field.v)):
            for axis, at in ((field.time, t[k]), (field.x2, x2[k]), (field.x1, x1[k])):
                values = make_interp_spline(axis, values, k=3)(at)
            assert mine[k, component] == pytest.approx(float(values), abs=1e-10)


def test_a_dataset_and_a_list_are_read_as_their_files(tmp_path):
    data = current(land=True)
    data.to_netcdf(tmp_path / "whole.nc")
    whole = read_currents(tmp_path / "whole.nc")
    with xarray.open_dataset(tmp_path / "whole.nc") as opened:
        read = read_currents(opened)
    same(whole, read)
    assert (whole.land, whole.source) == (read.land, "whole.nc")
    files = []
    for k, part in enumerate((slice(0, 10), slice(10, None))):
        files.append(tmp_path / f"part{k}.nc")
        data.isel(time=part).to_netcdf(files[-1])
    parts = read_currents(files[::-1])
    same(whole, parts)
    assert (read.source, parts.source) == ("Dataset", "2 files")
    assert fit_current(data, rows=2, columns=2).report["source"] == "Dataset"


def test_packed_values_and_masks_of_a_dataset(tmp_path):
    data = current()
    packing = {"dtype": "int16", "scale_factor": 1e-4, "_FillValue": -32768}
    data.u[3, 2, 2] = np.nan
    data.to_netcdf(tmp_path / "packed.nc", encoding={"u": packing, "v": packing})
    from_file = read_currents(tmp_path / "packed.nc")
    with xarray.open_dataset(tmp_path / "packed.nc") as opened:
        same(from_file, read_currents(opened))
    assert np.isnan(from_file.u[3, 2, 2])


def test_velocities_by_the_names_of_the_user(tmp_path):
    data = current().rename(u="speed_x", v="speed_y")
    for name in ("speed_x", "speed_y"):
        data[name].attrs.pop("standard_name", None)
    data.to_netcdf(tmp_path / "own.nc")
    names = {"u": "speed_x", "v": "speed_y"}
    same(read_currents(current()), read_currents(tmp_path / "own.nc", names=names))
    swapped = read_currents(data, names={"u": "speed_y", "v": "speed_x"})
    np.testing.assert_array_equal(swapped.u, read_currents(data, names=names).v)
    refuses("Give --u and --v, or names=", read_currents, data)
    said = "Dataset: no variable w; must be one of speed_x, speed_y"
    refuses(said, read_currents, data, names=names | {"u": "w"})
    refuses("names: has u; must have u and v", read_currents, data, names={"u": "w"})
    refuses("an empty list. Give at least one file", read_currents, [])


def test_a_missing_time_is_refused_in_a_file_and_in_a_dataset(tmp_path):
    """NaT becomes the least integer in the file that xarray writes."""
    current().to_netcdf(tmp_path / "whole.nc")
    with xarray.open_dataset(tmp_path / "whole.nc") as opened:
        data = opened.load()
    data = data.assign_coords(time=data.time.where(data.time != data.time[3]))
    data.time.encoding = {"dtype": "int64", "units": "hours since 2024-01-01"}
    data.to_netcdf(tmp_path / "missing.nc")
    for source in (data, tmp_path / "missing.nc"):
        refuses(
            "time is not finite at 1 of 26 steps, first at step 3", fit_current, source
        )
