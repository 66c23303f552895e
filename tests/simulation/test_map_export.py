"""Runs in latitude and longitude: waypoints, variables, maps and degree axes."""

import json
from xml.etree import ElementTree

import numpy as np
import pytest
import xarray
from error_sentences import says
from matplotlib.collections import QuadMesh
from matplotlib.quiver import Quiver
from pyproj import Geod
from small_scenarios import kernels

import clpt_control as clpt

ORIGIN = (41.225, -69.45)
CORNERS = [[41.3, -69.55], [41.3, -69.35], [41.15, -69.35], [41.15, -69.55]]
WGS84 = Geod(ellps="WGS84")
NAMESPACE = "http://www.opengis.net/kml/2.2"
PAPER = clpt.paper_scenario()


def at_sea(**changes):
    """Return the paper's learner on a track in degrees, in km and h."""
    values = {
        "origin": ORIGIN,
        "units.length": "km",
        "units.time": "h",
        "reference.kind": "waypoints",
        "reference.points_lat_lon": CORNERS,
        "run.duration": 40.0,
    }
    return PAPER.with_values({**values, **changes})


def geodesic(lat, lon):
    """Return points in km from distance and bearing of the geodesic from the origin."""
    lats, lons = np.full(len(lat), ORIGIN[0]), np.full(len(lat), ORIGIN[1])
    bearing, _, metres = WGS84.inv(lons, lats, lon, lat)
    bearing = np.deg2rad(bearing)
    return metres[:, None] / 1000 * np.column_stack([np.sin(bearing), np.cos(bearing)])


@pytest.mark.parametrize(("unit", "size"), [("km", 1.0), ("m", 1000.0)])
def test_waypoints_in_degrees_have_the_geodesic_distance_and_bearing(unit, size):
    scenario = at_sea(**{"units.length": unit})
    expected = size * geodesic(*np.transpose(CORNERS))
    np.testing.assert_allclose(scenario.waypoints, expected, rtol=1e-9)


@pytest.mark.parametrize(("unit", "size"), [("km", 1.0), ("m", 1000.0)])
def test_starts_in_degrees_have_the_geodesic_distance_and_bearing(unit, size, tmp_path):
    starts = {
        "vehicle.position": None,
        "vehicle.position_lat_lon": [41.3, -69.55],
        "learning.position": None,
        "learning.position_lat_lon": [41.1, -69.4],
        "units.length": unit,
    }
    scenario = at_sea(**starts)
    x, z = size * geodesic(np.array([41.3, 41.1]), np.array([-69.55, -69.4]))
    run = clpt.simulate(scenario, [0.0, 1.0])
    np.testing.assert_allclose(run.position[0], x, rtol=1e-9)
    np.testing.assert_allclose(run.predicted_position[0], z, rtol=1e-9)
    np.testing.assert_allclose(
        [run.latitude[0], run.longitude[0]], [41.3, -69.55], atol=1e-9
    )
    clpt.save_scenario(scenario, tmp_path / "sea.toml")
    assert "position_lat_lon = [41.3, -69.55]" in (tmp_path / "sea.toml").read_text()
    assert clpt.load_scenario(tmp_path / "sea.toml") == scenario
    moved = scenario.with_values({"origin": [41.3, -69.55]})
    np.testing.assert_allclose(moved.vehicle.position, 0.0, atol=1e-9 * size)
    said = "vehicle.position: give either position"
    says(clpt.ScenarioError, said, scenario.with_values, {"vehicle.position": [0, 0]})


def test_a_run_has_latitude_and_longitude():
    run = clpt.simulate(at_sea(), np.linspace(0, 40, 9))
    expected = geodesic(run.latitude.values, run.longitude.values)
    np.testing.assert_allclose(run.position.values, expected, atol=1e-9)
    assert (run.latitude.units, run.longitude.units) == (
        "degrees_north",
        "degrees_east",
    )
    assert "latitude" not in clpt.simulate(PAPER, [0.0, 1.0])


def test_a_team_has_latitude_and_longitude():
    east = at_sea().with_values({"vehicle.position": [3.0, 0.0]})
    team = clpt.Team(members={"west": at_sea(), "east": east}, coupling=0.5)
    run = clpt.simulate(team, [0.0, 1.0])
    with pytest.raises(clpt.DataError, match="Give that of one vehicle"):
        clpt.flow_map(run)
    assert run.latitude.dims == ("vehicle", "time")
    assert run.clpt.plot().size == 3


def test_a_scenario_in_degrees_is_written_and_read(tmp_path):
    clpt.save_scenario(at_sea(), tmp_path / "sea.toml")
    assert clpt.load_scenario(tmp_path / "sea.toml") == at_sea()


@pytest.mark.parametrize(
    "values",
    [
        {"reference.points_lat_lon": None, "reference.points": CORNERS},
        {"vehicle.position": [41.3, -69.5]},
        {"vehicle.position": [-69.5, 41.3]},
        {"basis.centers": [[41.3, -69.5]] * 3},
    ],
)
def test_degrees_given_as_lengths_are_refused(values):
    *_, key = values
    says(
        clpt.ScenarioError,
        f"{key} = .*looks like degrees, but is in km",
        at_sea,
        **values,
    )


def test_lengths_of_a_place_near_zero_degrees_are_lengths():
    at_the_equator = {
        "origin": [0.5, 0.5],
        "reference.points_lat_lon": [[0.6, 0.6]],
        "vehicle.position": [0.5, 0.5],
    }
    assert at_sea(**at_the_equator).vehicle.position == (0.5, 0.5)


@pytest.mark.parametrize(
    ("values", "said"),
    [
        ({"origin": None}, "origin: is required with reference.points_lat_lon"),
        (
            {"vehicle.position": None, "vehicle.position_lat_lon": [141.2, -69.5]},
            "must be latitude",
        ),
        (
            {"learning.position": None, "learning.position_lat_lon": [95.0, 1.0]},
            "must be latitude",
        ),
        (
            {"vehicle.position": None, "vehicle.position_lat_lon": [10.0, 10.0]},
            "vehicle.position_lat_lon: .* km from the origin",
        ),
        ({"origin": [91.0, 0.0]}, "must be latitude and longitude in degrees"),
        ({"reference.points_lat_lon": [[-169.5, 41.2]]}, "must be latitude"),
        ({"reference.points_lat_lon": [[10.0, 10.0]]}, "km from the origin"),
        ({"reference.points": [[0.0, 1.0]]}, "give either points"),
    ],
)
def test_mistakes_are_sentences(values, said):
    says(clpt.ScenarioError, said, at_sea, **values)


def test_maps_have_track_prediction_waypoints_start_and_end(tmp_path, request):
    run = clpt.simulate(at_sea(), np.linspace(0, 40, 11))
    run.attrs["time_origin"] = "2019-01-01T00:00:00"
    clpt.export(run, tmp_path / "run.geojson")
    features = json.loads((tmp_path / "run.geojson").read_text())["features"]
    by_name = {feature["properties"]["name"]: feature for feature in features}
    waypoints = [f"waypoint {k}" for k in range(1, 5)]
    assert [*by_name] == ["track", "prediction", *waypoints, "start", "end"]
    track = by_name["track"]["geometry"]["coordinates"]
    places = np.column_stack([run.longitude, run.latitude])
    np.testing.assert_allclose(track, places, atol=1e-6)
    assert by_name["waypoint 2"]["geometry"]["coordinates"] == [-69.35, 41.3]
    assert by_name["end"]["properties"]["time"] == "2019-01-02T16:00:00Z"

    clpt.save_run(run, tmp_path / "run.nc")
    command = request.getfixturevalue("clpt")
    done = command("export", tmp_path / "run.nc", "-o", tmp_path / "run.kml")
    assert done.status == 0
    root = ElementTree.fromstring((tmp_path / "run.kml").read_text("utf-8"))
    lines = root.findall(f".//{{{NAMESPACE}}}LineString/{{{NAMESPACE}}}coordinates")
    assert [len(line.text.split()) for line in lines] == [11, 11]


def test_runs_without_an_origin_have_no_map(tmp_path):
    run = clpt.simulate(PAPER, [0.0, 1.0])
    for path, said in (
        (
            tmp_path / "run.kml",
            "no latitude and longitude. Give its scenario an origin",
        ),
        (tmp_path / "run.c", "must end in .kml, .geojson or .nc"),
        (None, "is required for a run"),
    ):
        says(clpt.ClptError, said, clpt.export, run, path)
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(("lat", "lon"), [(41.2, -69.5), (-10.0, 179.98)])
def test_ticks_are_at_even_degrees(lat, lon):
    corners = [[lat + a, lon + b] for a, b in ((0, 0), (0.1, 0), (0.1, 0.1))]
    changes = {"origin": (lat, lon), "reference.points_lat_lon": corners}
    ax = clpt.simulate(at_sea(**changes)).clpt.plot("track")
    ax.figure.draw_without_rendering()
    for tick in ax.yaxis.get_major_ticks():
        degrees, letter = tick.label1.get_text().split("° ")
        latitude = float(degrees) * {"N": 1, "S": -1}[letter]
        _, _, metres = WGS84.inv(lon, lat, lon, latitude)
        x2 = np.copysign(metres / 1000, latitude - lat)
        assert x2 == pytest.approx(tick.get_loc(), abs=1e-3)
    letters = {label.get_text()[-1] for label in ax.get_xticklabels()}
    assert letters == ({"W"} if lon < 0 else {"E", "W"})  # 180 degrees are crossed


# --- the learned flow as data --------------------------------------------------------------------


def test_a_map_is_the_last_estimate_and_its_error_inside_of_the_track():
    run = clpt.simulate(PAPER.with_values({"run.duration": 40.0}))
    north, east = [-0.5, 0.0, 1.0], [0.5, 2.0]
    flow = clpt.flow_map(run, north, east, [30.0, 40.0])
    assert flow.u.dims == ("time", "y", "x")
    x, y = np.meshgrid(east, north)
    points = np.column_stack([x.ravel(), y.ravel()])
    theta = run.flow_parameters_estimate.values[-1]
    phi = kernels(PAPER, 30.0, points)
    learned, true = phi @ theta.T, phi @ np.array(PAPER.flow.parameters).T
    for k, name in enumerate("uv"):
        np.testing.assert_allclose(flow[name][0].values.ravel(), learned[:, k])
        np.testing.assert_allclose(flow[f"true_{name}"][0].values.ravel(), true[:, k])
    error = np.linalg.norm(learned - true, axis=1)
    np.testing.assert_allclose(flow.error[0].values.ravel(), error)
    assert flow.u.attrs["units"] == "m s-1"
    low, high = run.position.values.min(0), run.position.values.max(0)
    far = at_sea().plane.to_plane
    says(clpt.DataError, r"\A.*km from the origin.*swapped lat.*\Z", far, 57.0, -20.0)
    outside = clpt.flow_map(run, [low[1] - 1, high[1]], [low[0], high[0] + 1])
    assert outside.u.isnull().values[0].tolist() == [[True, True], [False, True]]
    with pytest.raises(clpt.DataError, match="has no date"):
        clpt.flow_map(run, time=np.datetime64("2020-01-01"))


def test_a_chart_of_a_map_has_learned_and_true_flow_and_the_error():
    run = clpt.simulate(PAPER.with_values({"run.duration": 40.0}))
    ax = run.clpt.plot("map")
    true, learned = (c for c in ax.collections if isinstance(c, Quiver))
    estimate = run.flow_parameters_estimate.values[-1]
    for arrows, theta in ((true, PAPER.flow.parameters), (learned, estimate)):
        flow = kernels(PAPER, 40.0, arrows.XY) @ np.array(theta).T
        np.testing.assert_allclose(np.column_stack([arrows.U, arrows.V]), flow)
    assert true.scale == learned.scale
    flow = clpt.flow_map(run)
    [shade] = (c for c in ax.collections if isinstance(c, QuadMesh))
    np.testing.assert_array_equal(shade.get_array().ravel(), flow.error.values.ravel())
    np.testing.assert_array_equal(ax.lines[0].get_xydata(), run.position.values)


def test_a_chart_of_an_estimate_has_fixes_in_degrees_and_its_standard_error():
    values = {"run.duration": 20.0, "run.output_step": 0.1, "origin": ORIGIN}
    run = clpt.simulate(PAPER.with_values(values))
    estimate = clpt.currents.flow_estimate(run, every=5.0)
    assert clpt.flow_map(estimate).time.attrs["standard_name"] == "time"
    ax = estimate.clpt.plot("map")
    places = np.column_stack([estimate.longitude, estimate.latitude])
    drawn = ax.lines[0].get_xydata()  # the first leg begins at the origin
    np.testing.assert_allclose(drawn[1:], places, rtol=0, atol=1e-9)
    np.testing.assert_allclose(drawn[0], ORIGIN[::-1], rtol=0, atol=1e-3)
    [shade] = (c for c in ax.collections if isinstance(c, QuadMesh))
    error = clpt.flow_map(estimate).standard_error.values
    np.testing.assert_array_equal(shade.get_array().ravel(), error.ravel())


def test_a_map_has_no_truth_where_nothing_was_ever_measured(tmp_path):
    lat, lon = np.linspace(41, 41.5, 8), np.linspace(-70, -69.4, 9)
    speed = np.full((25, 8, 9), 0.2)
    speed[:, 3:5, 4:7] = np.nan  # land
    speed[:20, 1, 1] = np.nan  # a gap
    flow = ("time", "lat", "lon"), speed, {"units": "m/s"}
    hours = ("time", np.arange(25.0), {"units": "hours since 2026-05-01"})
    data = xarray.Dataset(
        {"u": flow, "v": flow}, {"time": hours, "lat": lat, "lon": lon}
    )
    few = {"rows": 2, "columns": 2, "width_km": 60, "constituents": ("steady",)}
    scenario = clpt.currents.fit_current(data, **few).save(tmp_path / "land.toml")
    run = clpt.simulate(scenario.with_values({"run.duration": 2.0}))
    found = clpt.flow_map(run, lat[1:-1], lon[1:-1])
    for name in ("true_u", "true_v", "error"):
        is_known = np.isfinite(found[name].values[0])
        np.testing.assert_array_equal(is_known, np.isfinite(speed[-1, 1:-1, 1:-1]))
    assert np.isfinite(found.u).all()
    np.testing.assert_allclose(found.true_u.min(), 0.72, rtol=1e-3)  # km/h


def test_a_map_in_degrees_has_east_and_north_and_opens_anywhere(tmp_path):
    scenario = at_sea()
    run = clpt.simulate(scenario)
    clpt.export(run, tmp_path / "map.nc")
    with xarray.open_dataset(tmp_path / "map.nc") as opened:
        flow = opened.load()
    assert flow.u.dims == ("time", "latitude", "longitude")
    assert flow.u.attrs["standard_name"] == "eastward_sea_water_velocity"
    assert flow.latitude.attrs["units"] == "degrees_north"
    assert flow.u.attrs["units"] == "km h-1"
    lat, lon = flow.latitude.values[20], flow.longitude.values[35]
    x = np.column_stack(scenario.plane.to_plane(lat, lon))
    np.testing.assert_allclose(x, geodesic(np.array([lat]), np.array([lon])), atol=1e-6)
    np.testing.assert_allclose(scenario.plane.to_earth(*x.T), [[lat], [lon]])
    phi = kernels(scenario, 40.0, x)[0]
    in_plane = run.flow_parameters_estimate.values[-1] @ phi
    east = geodesic(np.array([lat]), np.array([lon + 1e-4])) - x
    direction = (east / np.linalg.norm(east))[0]
    assert flow.u[0, 20, 35] == pytest.approx(in_plane @ direction, abs=1e-6)
    across = [-direction[1], direction[0]]
    assert flow.v[0, 20, 35] == pytest.approx(in_plane @ across, abs=1e-6)


@pytest.mark.parametrize("method", ["kalman", "tomography"])
@pytest.mark.sampled
def test_a_map_of_an_estimate_has_standard_errors(tmp_path, method):
    values = {"run.duration": 20.0, "run.output_step": 0.1, "origin": ORIGIN}
    scenario = PAPER.with_values(values)
    run = clpt.simulate(scenario)
    estimate = clpt.currents.flow_estimate(run, every=5.0, method=method)
    lat, lon = float(estimate.latitude[-1]), float(estimate.longitude[-1])
    flow = clpt.flow_map(estimate, lat, lon)
    np.testing.assert_allclose(
        [flow.u.item(), flow.v.item()], estimate.flow.values[-1], atol=1e-9
    )
    [phi] = kernels(scenario, 20.0, np.column_stack(scenario.plane.to_plane(lat, lon)))
    P = estimate.covariance.isel(leg=-1).values
    errors = [np.diag(of_axis) ** 0.5 for of_axis in P]
    np.testing.assert_allclose(np.max(errors, axis=0), estimate.standard_error[-1])
    of_axes = [(phi @ of_axis @ phi) ** 0.5 for of_axis in P]
    assert flow.standard_error.item() == pytest.approx(max(of_axes))
    assert (of_axes[0] == of_axes[1]) == (method == "kalman")
    assert flow.time.values[0] == estimate.end_time.values[-1]
    estimate.to_netcdf(tmp_path / "fixes.nc")
    with xarray.open_dataset(tmp_path / "fixes.nc", decode_times=False) as data:
        again = clpt.flow_map(data, lat, lon)
    np.testing.assert_allclose(again.u, flow.u)


@pytest.mark.parametrize("suffix", ["geojson", "kml"])
@pytest.mark.parametrize("legs", [16, 1])
def test_fixes_of_an_estimate_with_the_regions_of_their_forecasts(
    legs, suffix, clpt, tmp_path
):
    """A region is a circle about the forecast; the line begins at the first fix."""
    source, path = tmp_path / "learned.nc", tmp_path / f"track.{suffix}"
    clpt("estimate", "--sample", "--results", source)
    with xarray.open_dataset(source) as found:
        learned = found.load().isel(leg=slice(legs))
    learned.to_netcdf(source)
    clpt("export", source, "-o", path)
    fixes = np.column_stack([learned.longitude, learned.latitude])
    forecasts = np.column_stack(
        [learned.predicted_longitude, learned.predicted_latitude]
    )
    if suffix == "kml":
        marks = [*ElementTree.parse(path).iter(f"{{{NAMESPACE}}}Placemark")]
        assert len(marks) == 2 * legs + 1
        when = f"{{{NAMESPACE}}}when"
        times = [mark.find(f".//{when}") for mark in marks]
        assert sum(time is not None for time in times) == legs
        return
    features = json.loads(path.read_text())["features"]
    shapes: dict[str, list] = {"LineString": [], "Point": [], "Polygon": []}
    for feature in features:
        shape = feature["geometry"]
        shapes[shape["type"]].append(shape["coordinates"])
    [line] = shapes["LineString"]
    np.testing.assert_allclose(line[1:], fixes, atol=1e-6)
    np.testing.assert_allclose(shapes["Point"], fixes, atol=1e-6)
    radii = learned.forecast_radius.values
    for (region,), (lon, lat), radius in zip(
        shapes["Polygon"], forecasts, radii, strict=True
    ):
        count = len(region)
        away = WGS84.inv(*np.tile([[lon], [lat]], count), *np.transpose(region))[2]
        np.testing.assert_allclose(away, radius, rtol=1e-3, atol=0.2)


DEGREES = {"degrees_north": "latitude", "degrees_east": "longitude"}


@pytest.fixture(scope="module")
def files(tmp_path_factory):
    """Return NetCDF files of runs, of an estimate, of their maps and of a replay."""
    folder = tmp_path_factory.mktemp("cf")
    short = {"run.duration": 20.0, "run.output_step": 0.1}
    run = clpt.simulate(PAPER.with_values({**short, "origin": ORIGIN}))
    plane = clpt.simulate(PAPER.with_values(short))
    learned = clpt.currents.flow_estimate(run, every=5.0)
    for name, data in {"run": run, "plane": plane, "learned": learned}.items():
        data.to_netcdf(folder / f"{name}.nc")
        clpt.export(data, folder / f"map_of_{name}.nc")
    replay = clpt.replay.replay_dives(clpt.gliders.sample_dives())
    replay.dataset().to_netcdf(folder / "replay.nc")
    return sorted(folder.glob("*.nc"))


def test_files_are_as_the_CF_conventions_ask(files):
    assert len(files) == 7
    for file in files:
        with xarray.open_dataset(file, decode_coords="all") as data:
            assert data.attrs["Conventions"].startswith("CF-"), file.name
            for name, variable in data.variables.items():
                label = f"{file.name}: {name}"
                attributes = variable.attrs
                is_text = variable.dtype.kind in "OSU"
                assert is_text or {"long_name", "standard_name"} & {*attributes}, label
                standard = attributes.get("standard_name")
                if name in DEGREES.values():
                    assert standard == DEGREES[attributes["units"]], label
                assert standard != "time" or variable.dtype.kind == "M", label
