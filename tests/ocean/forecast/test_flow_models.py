"""Flow models that carry a glider: closed forms, gridded forecasts, fitted bases, refusals."""

import math
import shutil
from dataclasses import replace
from datetime import UTC, datetime

import netCDF4
import numpy as np
import pytest
from geodesics import place_from
from gridded_currents import as_it_is, gridded_current, saying
from refusals import refuses
from synthetic_vehicle import Made

from clpt_control.currents import fit_current, read_currents
from clpt_control.gliders import make_dive
from clpt_control.replay import read_flow_model, replay_dives

nan = math.nan
DEPTH = np.array([0.0, 10.0, 50.0, 100.0, 200.0, 400.0, 1000.0, 2000.0])

START = datetime(2020, 6, 1, tzinfo=UTC).timestamp()
LAT, LON = np.linspace(40.5, 41.5, 21), np.linspace(-70.0, -68.5, 31)
HOURS = np.arange(0.0, 49.0, 0.25)
W = 2 * math.pi / (12.42 * 3600)  # rad/s


def dive_at(hour=3.0, hours=6.0, way=(4000.0, 2500.0), lat=41.0, lon=-69.3, **more):
    """A dive that ended where it began."""
    t = START + 3600 * hour
    return make_dive(1, (t, lat, lon), (t + 3600 * hours, lat, lon), way, **more)


def ended(dive, east, north):
    """The same dive, surfaced where a flow took it."""
    way = dive.dr_east + east, dive.dr_north + north
    lat, lon = place_from(dive.lat_gps2, dive.lon_gps2, *way)
    return replace(dive, lat_gpse=lat, lon_gpse=lon, gps_east=way[0], gps_north=way[1])


def write(path, u, v, lat=LAT, lon=LON, hours=HOURS, depth=None, change=as_it_is):
    """Write a current, shapes (time, [depth,] lat, lon), m/s."""
    made = gridded_current(u, v, lat, lon, hours, since="2020-06-01", depth=depth)
    change(made).to_netcdf(path)
    return path


def model_of(path, u, v, *axes, **how):
    return read_flow_model(write(path, u, v, *axes, **how))


def turning(hours, shape, speed=0.3):
    """A current that is the same everywhere and turns with M2."""
    angle = W * 3600 * hours.reshape(-1, *(1 for _ in shape))
    return (
        np.broadcast_to(speed * f(angle), (len(hours), *shape))
        for f in (np.cos, np.sin)
    )


def turned(dive, speed=0.3):
    """Its way over a dive, integrated by hand, m."""
    a, b = W * (dive.t_gps2 - START), W * (dive.t_gpse - START)
    return speed / W * np.array([math.sin(b) - math.sin(a), math.cos(a) - math.cos(b)])


def carried(dive, model):
    """A dive as a replay of it alone has it, wherever it surfaced."""
    ways = []
    for east, north in ((0.0, 0.0), (3000.0, -2000.0)):
        (step,) = replay_dives([ended(dive, east, north)], flow_model=model).steps
        ways.append((step.dive.model_east, step.dive.model_north))
    assert ways[0] == ways[1]
    return step.dive


def model_way(dive, model):
    found = carried(dive, model)
    assert found.uncovered is None
    return np.array([found.model_east, found.model_north])


def closed_forms():
    """A dive, a flow, and where that carries it, m, to how many m."""
    dive, w, k, n = dive_at(), 1e-4, 2e-5, 1e-5
    T, dr = dive.duration, np.array([dive.dr_east, dive.dr_north])
    # Z' = v + omega J z: z(T) = (v_x sin + v_y (cos - 1), v_x (1 - cos) + v_y sin) / omega
    (vx, vy), s, c = dr / T, math.sin(w * T), math.cos(w * T)
    end = np.array([vx * s + vy * (c - 1), vx * (1 - c) + vy * s]) / w
    yield "rotation", dive, lambda t, x, y: (-w * y, w * x), end - dr, 0.01
    # x' = v_x + k y, y = v_y t: the flow adds k v_y T^2 / 2
    yield "shear", dive, lambda t, x, y: (k * y, 0.0), (k * vy * T**2 / 2, 0.0), 1e-6
    end = 0.5 / W * np.array([math.sin(W * T), 1 - math.cos(W * T)])
    yield (
        "tide",
        dive,
        lambda t, x, y: (0.5 * math.cos(W * t), 0.5 * math.sin(W * t)),
        end,
        0.01,
    )
    # all the way east in the first half, at rest in the second; the flow grows eastward:
    # x' = v + n x, then x' = n x: x(T) = (v / n) (e^(nT/2) - 1) e^(nT/2)
    way, grown = 5000.0, math.exp(n * T / 2)
    track = (np.array([0, T / 2, T]), np.array([0, way, way]), np.zeros(3))
    tracked, east = dive_at(way=(way, 0.0), track=track), (lambda t, x, y: (n * x, 0.0))
    yield (
        "track",
        tracked,
        east,
        (2 * way / T / n * (grown - 1) * grown - way, 0.0),
        0.05,
    )
    straight = way / T / n * (math.exp(n * T) - 1) - way
    yield "no track", replace(tracked, track=None), east, (straight, 0.0), 0.01


@pytest.mark.parametrize(
    ("dive", "flow", "expected", "tolerance"),
    [pytest.param(*case, id=name) for name, *case in closed_forms()],
)
def test_closed_forms(dive, flow, expected, tolerance):
    assert model_way(dive, Made(flow)) == pytest.approx(expected, abs=tolerance)


def test_a_perfect_forecast_leaves_no_error(tmp_path):
    """A tide on a grid, a glider in it: CLPE is the error of interpolation, in the middle dives."""
    model = model_of(tmp_path / "tide.nc", *turning(HOURS, (len(LAT), len(LON))))
    assert "one level only" in model.about
    dives, at = [], (41.0, -69.3)
    for k in range(6):
        dive = dive_at(7.0 * k + 0.6, 6.0, (3000.0 * (-1) ** k, 2000.0), *at)
        dives.append(replace(ended(dive, *turned(dive)), number=k))
        at = dives[-1].lat_gpse, dives[-1].lon_gpse
    replay = replay_dives(dives, flow_model=model)
    for step in replay.steps:  # u'' h^2 / 8 = 0.3 (W 900 s)^2 / 8 for six hours: 13 m
        assert step.clpe["no_flow"] > 1000
        assert step.clpe["flow_model"] < 13
    found = replay.summary()
    assert (found["flow_model"]["covered"], found["flow_model"]["source"]) == (
        6,
        "tide.nc",
    )
    assert found["clpe_rms"]["flow_model"] < 13 < found["clpe_rms"]["adaptive"]


@pytest.mark.long
def test_the_column_is_averaged(tmp_path):
    """U = 0.4 - 0.5 z / 1000 down to 800 m, nothing below, to the north 0.1 everywhere."""
    shape = (4, len(DEPTH), len(LAT), len(LON))
    u = np.broadcast_to((0.4 - 0.5 * DEPTH / 1000)[:, None, None], shape).copy()
    v, T = np.full(shape, 0.1), 21600.0
    axes = {"hours": np.array([0.0, 6.0, 12.0, 18.0]), "depth": DEPTH}
    model = model_of(tmp_path / "column.nc", u, v, **axes)

    def eastward(depth):
        return model_way(dive_at(way=(0.0, 0.0), depth_max=depth), model)[0] / T

    for depth, mean in ((150.0, 0.075), (700.0, 0.35), (None, 0.5), (3.0, 0.0015)):
        # None: down to 1000 m; the plane turns the rest
        assert eastward(depth) == pytest.approx(0.4 - 0.5 * mean, abs=1e-4)
    u[:, 5:] = np.nan  # the bottom is at 200 m
    model = model_of(tmp_path / "c.nc", u, v, **axes)
    assert eastward(900.0) == pytest.approx(0.4 - 0.5 * 0.1, abs=1e-4)
    flipped = write(tmp_path / "f.nc", u[:, ::-1], v, **axes | {"depth": -DEPTH[::-1]})
    one, two = (
        read_currents(file, column=True) for file in (flipped, tmp_path / "c.nc")
    )
    assert np.array_equal(one.u, two.u, equal_nan=True)


def test_profiles_with_holes(tmp_path):
    depth, hours = np.array([5.0, 20.0, 60.0]), np.array([0.0, 12.0, 24.0])

    def eastward(k, deepest):
        """The mean of a profile down to a depth, by a dive in it."""
        shape = len(hours), len(depth), len(LAT), len(LON)
        whole = np.broadcast_to(u[k][:, None, None], shape)
        v, path = np.zeros(shape), tmp_path / f"{k}.nc"
        model = model_of(path, whole, v, hours=hours, depth=depth)
        dive = dive_at(way=(0.0, 0.0), depth_max=deepest)
        way = carried(dive, model).model_east
        return nan if way is None else way / dive.duration

    u = np.array([[0.2, 0.5, nan], [nan, 0.5, 0.1], [nan, nan, 0.1], [0.2, nan, 0.6]])
    # 5 m of 0.2 and 15 of 0.35 | 20 of 0.5 and 10 of 0.45 | none | 5 of 0.2 and 25 to 0.2 + 2/11
    expected = [6.25 / 20, 14.5 / 30, nan, (1 + 25 * (0.2 + 1 / 11)) / 30]
    means = [eastward(k, 30.0) for k in range(4)]
    assert means == pytest.approx(expected, abs=1e-4, nan_ok=True)
    assert eastward(0, 2.0) == pytest.approx(0.2, abs=1e-4)


@pytest.mark.parametrize(
    ("west", "count", "to"),
    [(0.0, 720, 8e3), (-180.0, 721, -8e3), (-180.3, 720, -8e3), (-180.3, 721, 8e3)],
)
def test_a_dive_goes_over_the_seam_of_a_grid_around_the_earth(
    tmp_path, west, to, count
):
    """A current of 0.2 + 0.1 cos(lon), the same wherever it is cut; meridians lean a little."""
    globe, lat, hours = west + 0.5 * np.arange(count), LAT[::10], HOURS[::40]
    shape = len(hours), len(lat), len(globe)
    u = np.broadcast_to(0.2 + 0.1 * np.cos(np.radians(globe)), shape)
    model = model_of(tmp_path / "g.nc", u, -u, lat, globe, hours)
    start = west - 0.03 * np.sign(to)  # 2.5 km before the seam
    expected = (0.2 + 0.1 * math.cos(math.radians(west))) * 5 * 3600
    for turn in (0.0, 360.0):
        dive = dive_at(
            way=(to, 0.0), hours=5.0, lon=start + (turn if start < 0 else 0.0)
        )
        assert model_way(dive, model) == pytest.approx([expected, -expected], abs=15)


def test_what_is_not_covered(tmp_path):
    u, v = (w.copy() for w in turning(HOURS, (len(LAT), len(LON))))
    u[:, 12, 15] = np.nan
    model = model_of(tmp_path / "gap.nc", u, v)
    for dive, why in (
        (dive_at(lat=39.0), "outside the forecast's area"),
        (dive_at(lon=110.0), "outside the forecast's area"),
        (dive_at(lat=41.48, way=(0.0, 9000.0)), "outside the forecast's area"),
        (dive_at(hour=-0.1), "outside the forecast's steps"),
        (dive_at(hour=43.0), "outside the forecast's steps"),
        (dive_at(lat=LAT[12] - 0.01, lon=LON[15] - 0.01, way=(0.0, 0.0)), "in a gap"),
        (
            dive_at(lat=LAT[12] - 0.01, lon=LON[15] - 0.08, hours=2.0, way=(9e3, 0.0)),
            "in a gap",
        ),
    ):
        found = carried(dive, model)
        assert (found.model_east, found.model_north) == (None, None), why
        assert why in found.uncovered
    refuses("must be finite", carried, dive_at(way=(nan, 0.0)), model)
    assert carried(dive_at(), Made(lambda t, x, y: (nan, 0.0))).model_east is None


@pytest.mark.long
def test_a_gap_of_the_steps_is_not_bridged(tmp_path):
    """Six-hourly steps from 0 to 18 h, none until 84 h, then to 102 h: as files with a hole."""
    hours = np.array([0.0, 6.0, 12.0, 18.0, 84.0, 90.0, 96.0, 102.0])
    u = np.full((len(hours), len(LAT), len(LON)), 0.2)
    model = model_of(tmp_path / "hole.nc", u, 0 * u, hours=hours)
    for hour in (11.9, 12.1, 18.0, 50.0, 83.9, 84.0, 90.0):
        found = carried(dive_at(hour=hour, way=(0.0, 0.0)), model)
        covered = hour < 12 or hour >= 84
        assert (found.model_east is not None) == covered, hour
        assert (
            covered
            or found.uncovered == "outside the forecast's steps, or in a gap of them"
        )
    # 1, 3 and 6 h
    coarser = np.array([*range(10), 12.0, 15.0, 18.0, 21.0, 27.0, 33.0, 39.0])
    u = np.full((len(coarser), len(LAT), len(LON)), 0.2)
    model = model_of(tmp_path / "coarser.nc", u, 0 * u, hours=coarser)
    for hour in range(0, 33, 4):
        assert (
            carried(dive_at(hour=hour, way=(0.0, 0.0)), model).model_east is not None
        ), hour
    # two gaps, of 36 and 42 hours
    hours = 6 * np.array([0.0, 1, 2, 8, 15, 16, 17])
    u = np.full((len(hours), len(LAT), len(LON)), 0.2)
    model = model_of(tmp_path / "holes.nc", u, 0 * u, hours=hours)
    for hour in (0.0, 5.9, 12.1, 40.0, 48.1, 70.0, 90.0, 95.9):
        way = carried(dive_at(hour=hour, way=(0.0, 0.0)), model).model_east
        assert (way is not None) == (hour < 6 or hour >= 90), hour


def test_units_of_a_forecast_that_has_none_are_given(tmp_path):
    u, v = (100.0 * w for w in turning(HOURS, (len(LAT), len(LON))))
    path = write(tmp_path / "bare.nc", u, v, change=saying("u v", units=None))
    refuses("has no units.*--units", read_flow_model, path)
    found = model_way(dive_at(), read_flow_model(path, units="cm/s"))
    assert found == pytest.approx(turned(dive_at()), rel=0.01)
    (tmp_path / "fit.toml").write_text("")
    said = "a fit has its units in the file"
    refuses(said, read_flow_model, tmp_path / "fit.toml", units="m/s")


@pytest.fixture(scope="module")
def known(tmp_path_factory):
    """The fit of a known current, 0.2 east and a tide of 0.3 turning, and its folder."""
    folder = tmp_path_factory.mktemp("known")
    u, v = turning(HOURS[::4], (len(LAT), len(LON)))
    path = write(folder / "known.nc", u + 0.2, v, hours=HOURS[::4])
    fit = fit_current(path, rows=4, columns=4, width_km=60.0, radius_km=5.0)
    fit.save(folder / "fit.toml")
    return fit, folder


@pytest.mark.long
def test_a_fitted_basis(known):
    """As far from the known flow as the fit's own residual, and turned to east and north."""
    fit, folder = known
    model = read_flow_model(folder / "fit.toml")
    assert model.about.startswith("fitted basis of 48 functions")
    assert repr(model) == f"<Fitted fit.toml: {model.about}>"
    for hour, place in ((3.0, (41.0, -69.3)), (20.0, (41.2, -68.9))):
        dive = dive_at(hour, lat=place[0], lon=place[1])
        expected = turned(dive) + np.array([0.2 * dive.duration, 0.0])
        most = fit.report["residual_max"] / 3.6 * dive.duration
        assert most < 500  # m, of some 5 km
        assert np.hypot(*(model_way(dive, model) - expected)) < most
    assert "outside the fit's area" in carried(dive_at(lat=39.0), model).uncovered


def test_files_that_are_no_flow_model(known, tmp_path):
    shutil.copytree(known[1], tmp_path, dirs_exist_ok=True)
    (tmp_path / "bare.toml").write_text((tmp_path / "fit.toml").read_text())
    with netCDF4.Dataset(tmp_path / "fit_field.nc", "a") as file:
        report = file.fit_report
        file.fit_report = "{}"
    (tmp_path / "model.csv").write_text("u,v\n")
    deep = np.zeros((2, 3, len(LAT), len(LON)))
    write(tmp_path / "deep.nc", deep, deep, hours=HOURS[:2], depth=[0.0, 1.0, 1.0])
    levels = {"depth": [0.0, 0.5, 1.0], "change": saying("depth", units="1")}
    write(tmp_path / "sigma.nc", deep, deep, hours=HOURS[:2], **levels)
    for name, says in (
        ("model.csv", "is not a flow model"),
        ("none.nc", "no such file"),
        ("fit_field.nc", "Give the .toml file"),
        ("bare.toml", "is not a fit with its field"),
        ("deep.nc", "each once"),
        ("sigma.nc", "depth has units '1'"),
    ):
        refuses(says, read_flow_model, tmp_path / name)
    with netCDF4.Dataset(tmp_path / "fit_field.nc", "a") as file:
        file.fit_report = report.replace('"theta": [[', '"theta": [[0.0, ', 1)
    refuses("Write both anew", read_flow_model, tmp_path / "fit.toml")
