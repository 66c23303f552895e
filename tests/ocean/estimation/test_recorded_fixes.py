"""Flow learned from recorded fixes, against missions made with a known flow.

The truth of each mission is its own: Eq. (1) by SciPy, in a flow of Eq. (3) whose theta is chosen
here.  A drifter in a uniform flow has theta = displacement over time.
"""

import csv
import json
import sys
from datetime import UTC, datetime, timedelta
from pathlib import Path

import numpy as np
import pytest
import xarray
from pyproj import Geod, Proj
from refusals import refuses
from scipy.integrate import solve_ivp

import clpt_control as clpt

ORIGIN = 36.7, -122.1
PLANE = Proj(proj="aeqd", ellps="WGS84", lat_0=ORIGIN[0], lon_0=ORIGIN[1])
CENTERS = np.array([[0.0, 0.0], [12e3, 0.0], [6e3, 10e3]])
THETA = np.array([[0.15, -0.20, 0.10], [-0.10, 0.15, 0.25]])
SCENARIO = {
    "origin": ORIGIN,
    "units": {"length": "km", "time": "h"},
    "basis": {
        "kernel": "gaussian",
        "centers": (CENTERS / 1e3).tolist(),
        "widths": [8.0] * 3,
        "constituents": ["steady"] * 3,
    },
    "learning": {"law": "fix-regression"},
}
UNIFORM = {
    "basis": {
        "kernel": "gaussian",
        "centers": [[0, 0]],
        "widths": [1e6],
        "constituents": ["steady"],
    },
    "learning": {"law": "fix-regression"},
}
LAWS = ("fix-regression", "kalman-flow", "least-squares")
FIELDS = (
    *("number", "t_gps2", "lat_gps2", "lon_gps2", "t_gpse", "lat_gpse", "lon_gpse"),
    *("dr_east", "dr_north"),
)
HEAD = "dive,t_gps2,lat_gps2,lon_gps2,t_gpse,lat_gpse,lon_gpse,dr_east_m,dr_north_m"


def flow(x):
    """Theta phi(x), m/s."""
    return THETA @ np.exp(-np.sum((x - CENTERS) ** 2, axis=1) / (2 * 8e3**2))


def straight_mission(legs=24, seed=3, noise=10.0, flow=flow, aims=CENTERS):
    """Legs of 2 h, straight at 1 m/s, each fix with noise: rows of a table of legs."""
    random = np.random.default_rng(seed)
    x, t, rows = np.array([1e3, 2e3]), 1.7e9, []
    measured = x + random.normal(0, noise, 2)
    for k in range(legs):
        aim = aims[random.integers(len(aims))] + random.normal(0, 4e3, 2)
        velocity = (aim - x) / np.hypot(*(aim - x))
        start = measured
        x = moved(x, velocity, flow)
        measured = x + random.normal(0, noise, 2)
        east_north = in_degrees(start, 7200 * velocity)
        rows.append([k + 1, t, *place(start), t + 7200, *place(measured), *east_north])
        t += 7200
    return rows


def moved(x, velocity, flow):
    """Position after 2 h with a velocity through the water, m."""
    rate = (lambda t, x: flow(x) + velocity), (0.0, 7200.0)
    return solve_ivp(*rate, x, "DOP853", rtol=1e-10, atol=1e-6).y[:, -1]


def place(x):
    """Latitude and longitude of a point."""
    longitude, latitude = PLANE(*x, inverse=True)
    return latitude, longitude


def in_degrees(x, displacement):
    """East and north of a displacement in the plane, by the direction of north there."""
    latitude, longitude = place(x)
    north = np.subtract(PLANE(longitude, latitude + 1e-4), x)
    north /= np.hypot(*north)
    east = np.array([north[1], -north[0]])
    return float(east @ displacement), float(north @ displacement)


def write(path, rows, head=HEAD):
    """Write a table."""
    path.write_text(
        "\n".join([head, *(",".join(map(repr, row)) for row in rows)]) + "\n"
    )
    return path


def learned(path, scenario=SCENARIO, **values):
    """Return the results for a table."""
    legs, _ = clpt.gliders.read_dives(path, least_duration=0.0)
    scenario = clpt.Scenario(**scenario).with_values(values)
    return clpt.currents.flow_estimate(legs, scenario)


@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize("units", [("km", "h", 1.0), ("m", "s", 1e3)])
def test_straight_legs_teach_the_flow(tmp_path, law, units):
    """Theta to 0.01 m/s and within its standard errors, in any units."""
    path = write(tmp_path / "legs.csv", straight_mission())
    length, time, size = units
    data = learned(
        path,
        **{
            "learning.law": law,
            "units": {"length": length, "time": time},
            "basis.centers": (CENTERS / 1e3 * size).tolist(),
            "basis.widths": [8.0 * size] * 3,
        },
    )
    off = data.flow_parameters_estimate.values[-1] - THETA
    assert np.abs(off).max() < 0.010
    assert np.all(np.abs(off) < 4 * data.standard_error.values[-1])
    error = np.hypot(*data.position_error.values.T)
    assert error[0] > 800  # 2 h in the flow, nothing learned
    assert np.median(error[12:]) < 60
    assert data.inside.values[4:].mean() > 0.8


@pytest.mark.long
def test_standard_errors_hold(tmp_path):
    """Over 20 missions the errors of theta are about as large as their standard errors say."""
    ratios = []
    for seed in range(20):
        rows = straight_mission(legs=12, seed=seed, noise=60.0)
        data = learned(write(tmp_path / "legs.csv", rows))
        off = data.flow_parameters_estimate.values[-1] - THETA
        ratios.append(off / data.standard_error.values[-1])
    assert 0.3 < np.sqrt(np.mean(np.square(ratios))) < 1.3


def test_a_log_with_turns_is_as_good_as_its_way(tmp_path):
    """A log of course and speed; as a table of legs alone the bends are told and counted."""
    log = Path(clpt.__file__).parent / "data" / "made_auv_mission.csv"
    by_log = learned(log)
    assert np.abs(by_log.flow_parameters_estimate.values[-1] - THETA).max() < 0.010
    legs, _ = clpt.gliders.read_dives(log)
    rows = [[getattr(leg, name) for name in FIELDS] for leg in legs]
    by_legs = learned(write(tmp_path / "legs.csv", rows))
    off = np.abs(by_legs.flow_parameters_estimate.values[-1] - THETA)
    assert np.all(off < 3 * by_legs.standard_error.values[-1])
    assert "as if the vehicle had turned" in by_legs.attrs["notes"][0]
    assert not by_log.attrs["notes"]


def test_course_and_speed_of_a_leg(tmp_path):
    """A table of legs may have course and speed in place of the displacement."""
    rows = straight_mission(legs=6)
    polar = [
        [
            *row[:7],
            float(np.degrees(np.arctan2(x, y))) % 360,
            float(np.hypot(x, y)) / 7200,
        ]
        for row in rows
        for x, y in [row[7:]]
    ]
    head = HEAD.replace("dr_east_m,dr_north_m", "course,speed")
    first = learned(write(tmp_path / "a.csv", rows))
    second = learned(write(tmp_path / "b.csv", polar, head))
    np.testing.assert_allclose(
        first.flow_parameters_estimate, second.flow_parameters_estimate, atol=1e-9
    )


def test_rows_of_displacement_are_rows_of_course(tmp_path):
    """A log of displacements is the log of course and speed that makes them."""
    log = Path(clpt.__file__).parent / "data" / "made_auv_mission.csv"
    rows = list(csv.DictReader(log.read_text().splitlines()[1:]))
    stretches, before = [], None
    for row in rows:
        time = datetime.fromisoformat(row["time"]).timestamp()
        way = 0.0 if before is None else (time - before[0]) * float(before[1]["speed"])
        angle = 0.0 if before is None else np.radians(float(before[1]["course"]))
        cells = [row["latitude"], row["longitude"]]
        stretches.append([time, *cells, way * np.sin(angle), way * np.cos(angle)])
        before = time, row
    text = "time,latitude,longitude,dr_east_m,dr_north_m\n" + "\n".join(
        ",".join(map(str, row)) for row in stretches
    )
    (tmp_path / "log.csv").write_text(text)
    np.testing.assert_allclose(
        learned(tmp_path / "log.csv").flow_parameters_estimate,
        learned(log).flow_parameters_estimate,
        atol=1e-9,
    )


def drifter_table(path, hours=24):
    """A drifter in 0.2 m/s to the north-east, by geodesics: fixes each hour, no motion."""
    geod = Geod(ellps="WGS84")
    latitude, longitude, lines = 0.2, 8.0, ["time,latitude,longitude"]
    begin = datetime(2026, 3, 1, tzinfo=UTC)
    for k in range(hours):
        lines.append(
            f"{(begin + timedelta(hours=k)).isoformat()},{latitude},{longitude}"
        )
        longitude, latitude, _ = geod.fwd(longitude, latitude, 45.0, 720.0)
    path.write_text("\n".join(lines))
    return path


def test_a_drifter_teaches_its_own_drift(tmp_path, clpt):
    """0.2 m/s to the north-east; without --drifter the sentence names the remedies."""
    table, scenario = drifter_table(tmp_path / "d.csv"), tmp_path / "s.toml"
    scenario.write_text(
        '[basis]\nkernel="gaussian"\ncenters=[[0,0]]\nwidths=[1e6]\nconstituents=["steady"]\n'
        '[learning]\nlaw="fix-regression"\n'
    )
    words = ["estimate", table, "--scenario", scenario]
    status, out, _ = clpt(*words, "--drifter", "--json")
    report = json.loads(out)
    assert status == 0
    np.testing.assert_allclose(
        report["theta_m_s"], [[0.2 * np.sqrt(0.5)]] * 2, atol=2e-3
    )
    assert report["legs"][-1]["flow"]["towards"] == pytest.approx(45.0, abs=0.5)
    status, _, err = clpt(*words)
    assert status == 2
    assert "course (degrees)" in err
    assert "--drifter" in err


@pytest.mark.long
def test_a_wild_fix_teaches_little(tmp_path):
    """One end fix 2 km off: it is told, and theta hardly moves."""
    rows = straight_mission()
    rows[15][5] += 0.018
    data = learned(write(tmp_path / "legs.csv", rows))
    off = np.abs(data.flow_parameters_estimate.values[-1] - THETA)
    assert off.max() < 0.03
    assert any("leg 16: the fix lies outside" in note for note in data.attrs["notes"])


def test_command_writes_scenario_figure_results_and_page(tmp_path, clpt, monkeypatch):
    """Each file is written; the scenario runs; the page is made of the results."""
    monkeypatch.chdir(tmp_path)
    words = "estimate --sample --out known.toml --figure f.png --results l.nc --json"
    status, out, err = clpt(*words.split())
    assert status == 0, err
    report = json.loads(out)
    assert np.abs(np.array(report["theta_m_s"]) - THETA).max() < 0.010
    assert (tmp_path / "f.png").read_bytes().startswith(b"\x89PNG")
    known = sys.modules["clpt_control"].load_scenario("known.toml")
    np.testing.assert_allclose(
        np.array(known.learning.theta_estimate) / 3.6, report["theta_m_s"], rtol=1e-12
    )
    assert clpt("run", "known.toml", "--out", "run.nc")[0] == 0
    run = sys.modules["clpt_control"].load_run("run.nc")
    assert np.abs(run.clpe).max() < 1e-9
    assert run.time[-1] == pytest.approx(48.0)  # h, of the mission
    assert np.hypot(*run.reference.values.T).max() < 10.0  # km
    assert clpt("report", "l.nc", "-o", "page.html")[0] == 0
    page = (tmp_path / "page.html").read_text()
    assert "Flow learned from fixes" in page
    assert all(leg["end"][:16].replace("T", " ") in page for leg in report["legs"])


@pytest.mark.parametrize(
    ("head", "row", "sentence"),
    [
        ("time,latitude,longitude,course,speed", "0,1,2,720,1", "course is 720"),
        ("time,latitude,longitude,course,speed", "0,1,2,72,-1", "speed is -1"),
        (
            "time,latitude,longitude,course,speed",
            "0,1,,72,1\n9,1,2,72,1",
            "one of latitude",
        ),
        ("time,latitude,longitude,course,speed", "x,1,2,72,1", "time is 'x'"),
        (
            "time,latitude,longitude,course,speed,dr_east_m,dr_north_m",
            "0,1,2,3,4,5,6",
            "has both",
        ),
        (
            "time,latitude,longitude,course,speed,vehicle",
            "0,1,2,3,1,a\n9,1,2,3,1,b",
            "2 vehicles",
        ),
        (
            "time,latitude,longitude,course,speed",
            "9,1,2,3,1\n0,1,2,3,1",
            "not later than",
        ),
    ],
)
def test_wrong_logs_are_refused(tmp_path, head, row, sentence):
    """Each wrong cell is named."""
    (tmp_path / "log.csv").write_text(f"{head}\n{row}\n")
    with pytest.raises(clpt.DataError, match=sentence):
        clpt.gliders.read_dives(tmp_path / "log.csv")


def test_a_scenario_for_fixes_does_not_simulate():
    """The message names the missing table and the command that does without."""
    scenario = clpt.Scenario(**SCENARIO)
    with pytest.raises(clpt.ScenarioError, match="leaves this table out"):
        clpt.simulate(scenario)
    with pytest.raises(clpt.ScenarioError, match="missing key flow"):
        clpt.Scenario(**{**SCENARIO, "learning": {"law": "learned-flow", "gain": 1.0}})


def test_laws_without_a_regression_of_fixes_are_refused():
    """The sentence lists the laws that learn from recorded fixes."""
    with pytest.raises(
        clpt.ScenarioError, match="kalman-flow, least-squares, fix-regression"
    ):
        clpt.currents.FlowEstimator(clpt.paper_scenario())


def test_functions_that_the_track_does_not_feel_are_told(tmp_path):
    """An origin 300 km away: nothing is learned, and the run says so."""
    path = write(tmp_path / "legs.csv", straight_mission(legs=6))
    data = learned(path, origin=[39.4, -122.1])
    assert any("all functions hardly learned" in note for note in data.attrs["notes"])
    data = learned(path, **{"basis.centers": [[0, 0], [12, 0], [400, 0]]})
    assert any("functions 3 hardly learned" in note for note in data.attrs["notes"])


@pytest.mark.long
def test_a_map_of_an_estimate_is_everywhere(tmp_path):
    """Off the track too: theta_hat phi(x) and its error, 15 km from the functions."""
    data = learned(write(tmp_path / "legs.csv", straight_mission()))
    x = np.array([6e3, -15e3])
    latitude, longitude = place(x)
    flow = clpt.flow_map(data, [latitude], [longitude])
    phi = np.exp(-np.sum((x - CENTERS) ** 2, axis=1) / (2 * 8e3**2))
    theta, P = data.flow_parameters_estimate.values[-1], data.covariance.values[-1][0]
    # functions show the flow at their centres, legs at their fixes but for a share of 1e-3
    starts, ends = (
        np.column_stack(PLANE(data[f"{of}longitude"], data[f"{of}latitude"]))
        for of in ("start_", "")
    )
    fixes = np.vstack([starts[:1], ends])
    legs = [0, *range(len(ends))]
    shown_at = np.vstack([CENTERS, fixes])

    def kernel(a, b):
        return np.exp(-np.sum((a - b) ** 2, axis=-1) / (2 * 8e3**2))

    like = kernel(shown_at[:, None], shown_at) + 1e-3 * np.eye(len(shown_at))
    of_x = kernel(shown_at, x)
    v = 0.5**2 * (1 - of_x @ np.linalg.solve(like, of_x))
    # the flow on the legs of the two nearest fixes differs from the learned flow on their ways
    nearest = np.argsort(np.hypot(*(fixes - x).T))[:2]
    ways = starts + np.linspace(0, 1, 2001)[:, None, None] * (ends - starts)
    on_ways = kernel(ways[:, :, None], CENTERS).mean(axis=0) @ theta.T
    misfits = np.mean((data.leg_flow.values - on_ways) ** 2, axis=1)
    off = max(misfits[legs[k]] for k in nearest) + misfits[legs].mean()
    variance = phi @ P @ phi + v + kernel(fixes[nearest[0]], x) ** 2 * off
    expected = [*(theta @ phi), np.sqrt(variance)]
    shown = [float(flow[name].squeeze()) for name in ("u", "v", "standard_error")]
    np.testing.assert_allclose(shown, expected, rtol=2e-3)


def test_a_map_of_some_legs_is_that_of_an_estimate_of_them(tmp_path):
    """In any order of the legs; and its box begins at the first fix."""
    rows = straight_mission(legs=9)
    part = learned(write(tmp_path / "part.csv", rows[:4]))
    whole = learned(write(tmp_path / "legs.csv", rows))
    some = clpt.flow_map(whole.isel(leg=[2, 0, 3, 1]))
    expected = clpt.flow_map(part)
    for name in ("u", "v", "standard_error"):
        np.testing.assert_allclose(some[name], expected[name], rtol=1e-9)
    north = [row[2] for row in rows[:4]] + [rows[3][5]]
    np.testing.assert_allclose(
        [expected.latitude.min(), expected.latitude.max()],
        [min(north), max(north)],
        atol=1e-4,
    )


def test_a_file_without_the_flow_beside_the_functions_has_no_map(tmp_path):
    """As an older version wrote it."""
    data = learned(write(tmp_path / "legs.csv", straight_mission(2)))
    del data["leg_flow"]
    with pytest.raises(clpt.DataError, match="older version"):
        clpt.flow_map(data)


def without(data, name):
    """An estimate without a variable or an attribute."""
    lacking = data.drop_vars(name, errors="ignore")
    lacking.attrs.pop(name, None)
    return lacking


def unknown(data, name):
    """An estimate with NaN, or no time, in the last number of a variable or an attribute."""
    data = data.copy(deep=True)
    values = data[name].values if name in data else np.array(data.attrs[name], float)
    values[(-1,) * values.ndim] = "NaT" if values.dtype.kind == "M" else np.nan
    if name in data.attrs:
        data.attrs[name] = values
    return data


ATTRIBUTES = ("origin", "has_origin", "unspanned_flow", "scatter", "walk")
STARTS = ("start_latitude", "start_longitude")
PLACES_READ = ("latitude", "longitude", "end_time", *STARTS)
READ = (*PLACES_READ, "leg_flow", "flow_parameters_estimate", "covariance", *ATTRIBUTES)
TRACK_READ = (
    *PLACES_READ,
    *("predicted_latitude", "predicted_longitude", "position_error"),
    *("forecast_radius", "has_origin"),
)


DRAWN = (*TRACK_READ[:2], *TRACK_READ[3:9], "flow", "origin")
REPORTED = (
    *("start_time", "end_time", "position_error", "forecast_radius", "flow"),
    *("guaranteed", "flow_parameters_estimate", "standard_error", "turn"),
    *("noise_scale", "origin"),
)
NO_NUMBERS = ("leg", "inside", "time_origin", "fix_method", "guarantee")


@pytest.mark.long
def test_an_estimate_that_is_not_whole_has_no_page_and_no_drawing(tmp_path):
    data = learned(write(tmp_path / "legs.csv", straight_mission(3)))
    page = tmp_path / "page.html"
    for name in DRAWN:
        for damaged in (without(data, name), unknown(data, name)):
            refuses(f"no finite {name}", damaged.clpt.plot)
    for name in REPORTED:
        refuses(f"no finite {name}", clpt.report, unknown(data, name), page)
    for name in (*REPORTED, *NO_NUMBERS):
        refuses(f"no finite {name}", clpt.report, without(data, name), page)
    assert not page.exists()
    turned = data.isel(axis=[1, 0])
    drawn, again = (one.clpt.plot()[0].collections for one in (data, turned))
    for name in "UV":  # arrows, by the labels of axes
        assert [getattr(a, name).tolist() for a in drawn if hasattr(a, name)] == [
            getattr(a, name).tolist() for a in again if hasattr(a, name)
        ]


def test_an_estimate_that_is_not_whole_has_no_map(tmp_path, refused_for):
    """The one sentence names what lacks, or is NaN, or has lost a dimension."""
    data = learned(write(tmp_path / "legs.csv", straight_mission(3)))
    for damaged in (without, unknown):
        for name in READ:
            refuses(f"no finite {name}", clpt.flow_map, damaged(data, name))
        for name in TRACK_READ:
            track = tmp_path / "track.kml"
            refuses(f"no finite {name}", clpt.export, damaged(data, name), track)
    refuses("no finite time_origin", clpt.flow_map, without(data, "time_origin"))
    refuses("no finite latitude", clpt.flow_map, data.isel(leg=0))
    refuses("no finite latitude", clpt.flow_map, data.isel(leg=[]))
    refuses("axis", clpt.flow_map, data.isel(axis=[0]))
    without(data, "covariance").to_netcdf(tmp_path / "cut.nc")
    refused_for(["covariance"], "export", tmp_path / "cut.nc", "-o", tmp_path / "m.nc")


def test_axes_of_an_estimate_are_read_by_their_labels(tmp_path):
    data = learned(write(tmp_path / "legs.csv", straight_mission(3)))
    xarray.testing.assert_identical(
        clpt.flow_map(data.isel(axis=[1, 0])), clpt.flow_map(data)
    )


@pytest.mark.parametrize("law", ["fix-regression", "kalman-flow"])
def test_the_error_of_a_map_grows_with_the_walk_of_the_flow(tmp_path, law):
    """By (walk |phi|)^2 in each unit of time before and behind the last fix."""
    data = learned(
        write(tmp_path / "legs.csv", straight_mission(6)), **{"learning.law": law}
    )
    hours, latitude, longitude = (
        np.array([0.0, 6.0, -3.0]),
        *place(np.array([6e3, 0.0])),
    )
    end = data.end_time.values[-1]
    times = end + (hours * 3600e9).astype("m8[ns]")
    flow = clpt.flow_map(data, [latitude], [longitude], times)
    phi = np.exp(-np.sum((np.array([6e3, 0.0]) - CENTERS) ** 2, axis=1) / (2 * 8e3**2))
    walk = 0.02 * (law == "kalman-flow")  # m/s in a day
    grown = np.diff(flow.standard_error.values.ravel()[[0, 1, 0, 2]] ** 2)[::2]
    expected = walk**2 * np.abs(hours[1:]) / 24 * (phi @ phi)
    np.testing.assert_allclose(grown, expected, rtol=1e-3, atol=1e-12)


def test_a_map_is_at_finite_places_and_times(tmp_path):
    data = learned(write(tmp_path / "legs.csv", straight_mission(3)))
    for name in ("time", "latitude", "longitude"):
        for value in (np.nan, [0.0, np.inf]):
            refuses(
                f"{name}.*finite",
                clpt.flow_map,
                data,
                error=clpt.ClptError,
                **{name: value},
            )
    refuses(
        "time.*finite",
        clpt.flow_map,
        data,
        error=clpt.ClptError,
        time=np.datetime64("NaT"),
    )


def sheared(shear):
    """A flow that the functions do not span, m/s."""
    return lambda x: np.array([0.22 + shear * x[1], -0.11])


CONSTANT = {  # one more function
    "basis.centers": [[0, 0], *(CENTERS / 1e3).tolist()],
    "basis.widths": [1e6, 8.0, 8.0, 8.0],
    "basis.constituents": ["steady"] * 4,
}


@pytest.mark.long
@pytest.mark.parametrize("values", [{}, CONSTANT])
@pytest.mark.parametrize("shear", [0.0, 8e-6])
def test_errors_of_a_map_hold_the_flow_beside_the_functions(tmp_path, shear, values):
    """Shares within 1.64 standard errors, 0 to 5 widths from a fix, by the flow that is known."""
    flow, widths = sheared(shear), np.array([0, 1, 2, 3, 5])
    inside, errors = [], []
    for seed in range(2):
        rows = straight_mission(seed=seed, flow=flow)
        data = learned(write(tmp_path / "legs.csv", rows), **values)
        fixes = np.column_stack(PLANE(data.longitude, data.latitude))
        for fix in fixes[::4]:
            outwards = (fix - fixes.mean(axis=0)) / np.hypot(
                *(fix - fixes.mean(axis=0))
            )
            for x in fix + 8e3 * np.outer(widths, outwards):
                shown = clpt.flow_map(data, *place(x)).squeeze()
                errors.append(shown.standard_error)
                off = np.abs(np.array([shown.u, shown.v]) - flow(x))
                inside.append(off < 1.64 * errors[-1].values)
    shares = np.reshape(inside, (-1, len(widths), 2)).mean(axis=(0, 2))
    assert np.all(shares >= 0.85), shares
    errors = np.median(np.reshape(errors, (-1, len(widths))), axis=0)
    assert errors[0] < 0.3
    assert 0.49 < errors[-1] < 0.65


def test_a_constant_function_spans_a_uniform_flow(tmp_path):
    path = write(tmp_path / "legs.csv", straight_mission(flow=sheared(0.0)))
    data = learned(path, UNIFORM, **{"basis.widths": [1e8]})
    far = clpt.flow_map(data, *place(np.array([9e5, 0.0])))
    at_fix = data.standard_error[-1].item()
    # the prior of 0.5 m/s far off, what the legs show beside the function at a fix
    assert far.standard_error.item() == pytest.approx(np.hypot(0.5, at_fix), rel=1e-6)
    near = clpt.flow_map(data, data.latitude[-1:], data.longitude[-1:])
    assert at_fix < near.standard_error.item() < 0.02


@pytest.mark.long
@pytest.mark.parametrize("shear", [0.0, 8e-6])
def test_regions_hold_fixes_that_leave_the_functions(tmp_path, shear):
    """Legs to the east, out of all functions."""
    inside, aims = [], np.array([[1e6, 0.0]])
    for seed in range(4):
        rows = straight_mission(12, seed, flow=sheared(shear), aims=aims)
        inside += [learned(write(tmp_path / "legs.csv", rows)).inside.values]
    assert np.mean(inside, axis=0).min() >= 0.75
    assert np.mean(inside) >= 0.9


def test_the_first_region_far_from_all_functions_is_that_of_the_prior(tmp_path):
    """Student's t with two degrees of freedom: 0.5 m/s, noise of fixes, kinds of scatter."""
    path = write(tmp_path / "legs.csv", straight_mission(legs=1))
    radius = learned(path, origin=[39.4, -122.1]).forecast_radius.item()
    sizes = np.outer([0.3, 1.2, 5.0], [1.0, 0.8, 1.6])
    variance = (0.5**2 + (0.02 * sizes) ** 2) * 7200.0**2 + 2 * 10.0**2
    outside = sizes / (1 + radius**2 / (2 * variance))
    assert np.sum(outside) / np.sum(sizes) == pytest.approx(0.1, rel=2e-3)


@pytest.mark.parametrize(
    ("factor", "said"), [(3.6, "km/h"), (3600 / 1852, "knots"), (1.0, "")]
)
@pytest.mark.parametrize("scenario", [SCENARIO, UNIFORM])
def test_a_wrong_unit_is_told_only_where_it_is(tmp_path, scenario, factor, said):
    """Among eddies, also by a learner whose functions do not have them."""
    rows = straight_mission(legs=16, noise=1.0)
    path = write(
        tmp_path / "l.csv", [(*r[:7], factor * r[7], factor * r[8]) for r in rows]
    )
    notes = " ".join(learned(path, scenario).attrs["notes"])
    assert f"speeds look like {said}" in notes if said else "look" not in notes
