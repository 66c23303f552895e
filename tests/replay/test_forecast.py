"""Gridded forecasts: depth mean, longitudes of any kind, what is not covered."""

import math
from dataclasses import replace
from datetime import UTC, datetime
from pathlib import Path

import numpy as np
import pytest
from pyproj import Geod
from synthetic_forecast import (
    HOURS,
    LAT,
    LON,
    Made,
    dive_at,
    ended,
    model_way,
    turned,
    turning,
    write,
)

from clpt_control.currents.grid_file import missing_steps, read_currents
from clpt_control.errors import DataError
from clpt_control.gliders.dive_files import sample_dives
from clpt_control.gliders.dives import make_dive
from clpt_control.gliders.usable_dives import usable
from clpt_control.replay.carried_dives import carried
from clpt_control.replay.flow_models import depth_mean, read_flow_model
from clpt_control.replay.outcome import summary
from clpt_control.replay.replay import replay_dives

MARACOOS = Path(__file__).parents[2] / "clpt_control/data/maracoos_hfr_2019-01-01.nc"
DEPTH = np.array([0.0, 10.0, 50.0, 100.0, 200.0, 400.0, 1000.0, 2000.0])


def test_a_perfect_forecast_leaves_no_error(tmp_path):
    """A tide on a grid, a glider in it: CLPE is the error of interpolation, in the middle dives."""
    path = write(tmp_path / "tide.nc", *turning(HOURS, (len(LAT), len(LON))))
    model = read_flow_model(path)
    assert "one level only" in model.about
    dives = []
    for k in range(6):
        dive = replace(dive_at(7.0 * k + 0.6, way=(3000.0 * (-1) ** k, 2000.0)), number=k)
        dives.append(ended(dive, *turned(dive)))
    replay = replay_dives(dives, flow_model=model)
    for step in replay.steps:  # u'' h^2 / 8 = 0.3 (W 900 s)^2 / 8 for six hours: 13 m
        assert step.clpe["no_flow"] > 1000
        assert step.clpe["flow_model"] < 13
    found = summary(replay)
    assert found["flow_model"]["covered"] == 6
    assert found["flow_model"]["source"] == "tide.nc"
    assert found["clpe_rms"]["flow_model"] < 13 < found["clpe_rms"]["adaptive"]


def test_the_column_is_averaged(tmp_path):
    """U = 0.4 - 0.5 z / 1000 down to 800 m, nothing below, to the north 0.1 everywhere."""
    shape = (4, len(DEPTH), len(LAT), len(LON))
    u = np.broadcast_to((0.4 - 0.5 * DEPTH / 1000)[:, None, None], shape).copy()
    v = np.full(shape, 0.1)
    hours = np.array([0.0, 6.0, 12.0, 18.0])
    path = write(tmp_path / "column.nc", u, v, hours=hours, depth=DEPTH)
    model, T = read_flow_model(path), 21600.0
    still = {"way": (0.0, 0.0), "hours": 6.0}

    def eastward(depth):
        return model_way(dive_at(depth_max=depth, **still), model)[0] / T

    assert eastward(150.0) == pytest.approx(0.4 - 0.5 * 0.075, abs=1e-4)  # plane turns the rest
    assert eastward(700.0) == pytest.approx(0.4 - 0.5 * 0.35, abs=1e-4)
    assert eastward(None) == pytest.approx(0.4 - 0.5 * 0.5, abs=1e-4)  # down to 1000 m
    assert eastward(3.0) == pytest.approx(0.4 - 0.5 * 0.0015, abs=1e-4)
    u[:, 5:] = np.nan  # the bottom is at 200 m
    model = read_flow_model(write(tmp_path / "c.nc", u, v, hours=hours, depth=DEPTH))
    assert eastward(900.0) == pytest.approx(0.4 - 0.5 * 0.1, abs=1e-4)
    flipped = write(tmp_path / "f.nc", u[:, ::-1], v, hours=hours, depth=-DEPTH[::-1])
    one, two = (read_currents(file, column=True) for file in (flipped, tmp_path / "c.nc"))
    assert np.array_equal(one.u, two.u, equal_nan=True)


def test_profiles_with_holes():
    depth = np.array([5.0, 20.0, 60.0])
    no = np.nan
    u = np.array([[0.2, 0.5, no], [no, 0.5, 0.1], [no, no, 0.1], [0.2, no, 0.6]])
    # 5 m of 0.2 and 15 of 0.35 | 20 of 0.5 and 10 of 0.45 | none | 5 of 0.2 and 25 to 0.2 + 2/11
    expected = [6.25 / 20, 14.5 / 30, no, (1 + 25 * (0.2 + 1 / 11)) / 30]
    means = [depth_mean(depth, profile, 30.0).real for profile in u]
    assert means == pytest.approx(expected, nan_ok=True)
    assert depth_mean(depth, u[0], 2.0) == 0.2


def test_a_gradient_on_a_grid_and_longitudes_of_any_kind(tmp_path):
    """V = k (lon - lon_0): bilinear is exact, whatever longitudes the file counts in.

    No place lies at lon_0: a place of nothing but zeros is read as land.
    """
    k = 0.4
    u = np.zeros((len(HOURS), len(LAT), len(LON)))
    v = np.broadcast_to(k * (LON + 69.31), u.shape)
    one = read_flow_model(write(tmp_path / "a.nc", u, v))
    two = read_flow_model(write(tmp_path / "b.nc", u, v, lon=LON % 360))
    mixed = np.roll(np.arange(len(LON)), 7)
    three = read_flow_model(write(tmp_path / "c.nc", u, v[..., mixed], lon=LON[mixed] + 720))
    dive = dive_at(way=(6000.0, 0.0), hours=5.0)
    degree = Geod(ellps="WGS84").line_length([-69.3, -68.3], [41.0, 41.0])
    mean = k * (3000 / degree + 0.01)
    for model in (one, two, three):
        assert model_way(dive, model)[1] == pytest.approx(mean * dive.duration, rel=2e-3)
    east = write(tmp_path / "date.nc", u, v, lon=(LON + 249.3 + 180) % 360 - 180)
    assert model_way(replace(dive, lon_gps2=180.0), read_flow_model(east)) == pytest.approx(
        model_way(dive, one), abs=1e-3
    )
    globe = np.arange(0.0, 360.0, 5.0)
    flow = np.full((len(HOURS), len(LAT), len(globe)), 0.2)
    around = read_flow_model(write(tmp_path / "g.nc", flow, 0 * flow, lon=globe))
    assert model_way(replace(dive, lon_gps2=358.0), around)[0] == pytest.approx(3600.0, abs=5)


@pytest.mark.parametrize("west", [0.0, -180.0, -180.3])
@pytest.mark.parametrize("count", [720, 721])
@pytest.mark.parametrize("to", [-8000.0, 8000.0])
def test_a_dive_goes_over_the_seam_of_a_grid_around_the_earth(tmp_path, west, to, count):
    """A current of 0.2 + 0.1 cos(lon), the same wherever it is cut; meridians lean a little."""
    globe, lat, hours = west + 0.5 * np.arange(count), LAT[::10], HOURS[::40]
    shape = len(hours), len(lat), len(globe)
    u = np.broadcast_to(0.2 + 0.1 * np.cos(np.radians(globe)), shape)
    model = read_flow_model(write(tmp_path / "g.nc", u, -u, lat, globe, hours))
    start = west - 0.03 * np.sign(to)  # 2.5 km before the seam
    expected = (0.2 + 0.1 * math.cos(math.radians(west))) * 5 * 3600
    for turn in (0.0, 360.0):
        dive = dive_at(way=(to, 0.0), hours=5.0, lon=start + (turn if start < 0 else 0.0))
        assert model_way(dive, model) == pytest.approx([expected, -expected], abs=15)


def test_what_is_not_covered(tmp_path):
    u, v = (w.copy() for w in turning(HOURS, (len(LAT), len(LON))))
    u[:, 12, 15] = np.nan
    model = read_flow_model(write(tmp_path / "gap.nc", u, v))
    nan = math.nan
    for dive, why in (
        (dive_at(lat=39.0), "outside the forecast's area"),
        (dive_at(lon=110.0), "outside the forecast's area"),
        (dive_at(lat=41.48, way=(0.0, 9000.0)), "outside the forecast's area"),
        (dive_at(hour=-0.1), "outside the forecast's steps"),
        (dive_at(hour=43.0), "outside the forecast's steps"),
        (dive_at(lat=LAT[12] - 0.01, lon=LON[15] - 0.01, way=(0.0, 0.0)), "in a gap"),
        (dive_at(lat=LAT[12] - 0.01, lon=LON[15] - 0.08, hours=2.0, way=(9e3, 0.0)), "in a gap"),
        (dive_at(way=(nan, 0.0)), "not finite"),
    ):
        found = carried(dive, model)
        assert (found.model_east, found.model_north) == (None, None), why
        assert why in found.uncovered
    assert carried(dive_at(), Made(lambda t, x, y: (nan, 0.0))).model_east is None


def test_a_gap_of_the_steps_is_not_bridged(tmp_path):
    """Six-hourly steps from 0 to 18 h, none until 84 h, then to 102 h: as files with a hole."""
    hours = np.array([0.0, 6.0, 12.0, 18.0, 84.0, 90.0, 96.0, 102.0])
    u = np.full((len(hours), len(LAT), len(LON)), 0.2)
    model = read_flow_model(write(tmp_path / "hole.nc", u, 0 * u, hours=hours))
    for hour, covered in (
        (11.9, True),
        (12.1, False),
        (18.0, False),
        (50, False),
        (83.9, False),
        (84.0, True),
        (90.0, True),
    ):
        found = carried(dive_at(hour=hour, way=(0.0, 0.0)), model)
        assert (found.model_east is not None) == covered, hour
        assert found.uncovered == (
            None if covered else "outside the forecast's steps, or in a gap of them"
        )
    coarser = np.array([*range(10), 12.0, 15.0, 18.0, 21.0, 27.0, 33.0, 39.0])  # 1, 3 and 6 h
    u = np.full((len(coarser), len(LAT), len(LON)), 0.2)
    model = read_flow_model(write(tmp_path / "coarser.nc", u, 0 * u, hours=coarser))
    for hour in range(0, 33, 4):
        assert carried(dive_at(hour=hour, way=(0.0, 0.0)), model).model_east is not None, hour
    assert missing_steps(np.array([0.0, 6.0])).tolist() == [0]
    assert missing_steps(np.array([0.0, 6.0, 72.0])).tolist() == [0, 10]
    assert missing_steps(6 * np.array([0.0, 1, 2, 8, 15, 16, 17])).tolist() == [0, 0, 5, 6, 0, 0]


def test_measured_surface_current():
    model = read_flow_model(MARACOOS)
    data = read_currents(MARACOOS, column=True)
    whole = np.isfinite(data.u).all(axis=(0, 1))
    measured = np.lib.stride_tricks.sliding_window_view(whole, (4, 4)).all(axis=(2, 3))
    j, i = np.argwhere(measured)[0] + 1  # whole round about, as the dive drifts
    t = datetime(2019, 1, 1, 2, 30, tzinfo=UTC).timestamp()
    place = (data.lat[j : j + 2].mean(), data.lon[i : i + 2].mean())
    dive = make_dive(1, (t, *place), (t + 7200, *place), (100.0, 50.0))
    way = model_way(dive, model)
    corners = (data.u[2:5, 0, j : j + 2, i : i + 2], data.v[2:5, 0, j : j + 2, i : i + 2])
    for k in range(2):
        assert corners[k].min() * 7200 - 50 < way[k] < corners[k].max() * 7200 + 50
    replay = replay_dives(usable(sample_dives())[0], flow_model=model)
    found = summary(replay)
    assert found["clpe_rms"]["flow_model"] is None
    assert found["flow_model"]["covered"] == 0
    (why,) = {entry["why"] for entry in found["flow_model"]["uncovered"]}
    assert why.startswith("outside the forecast's")


def test_units_of_a_forecast_that_has_none_are_given(tmp_path, refused):
    import netCDF4

    path = write(tmp_path / "bare.nc", *turning(HOURS, (len(LAT), len(LON))))
    with netCDF4.Dataset(path, "a") as file:
        for name in "uv":
            file[name].delncattr("units")
            file[name][:] = 100.0 * file[name][:]
    with pytest.raises(DataError, match=r"has no units.*--units"):
        read_flow_model(path)
    dive = dive_at()
    found = model_way(dive, read_flow_model(path, units="cm/s"))
    assert found == pytest.approx(turned(dive), rel=0.01)
    fit = tmp_path / "fit.toml"
    fit.write_text("")
    with pytest.raises(DataError, match="a fit has its units in the file"):
        read_flow_model(fit, units="m/s")
    said = refused("replay", "--sample", "--units", "m/s")
    assert "--units m/s: is for --flow-model FILE" in said
