"""Logs of robots: their columns, units, clocks, and positions that repeat."""

import json
import tomllib
from math import atan2, cos, degrees, pi, radians, sin

import numpy as np
import pytest
from geodesics import place_from
from made_missions import BEGIN, CURRENT, HEAD, LEG, UNIFORM, mission, table
from refusals import refuses

import clpt_control as clpt

ROWS = mission(16, scatter=0.0, fix=3.0)
EVERYWHERE = clpt.Scenario(**tomllib.loads(UNIFORM))


@pytest.fixture
def estimate(tmp_path, clpt):
    """Run `clpt estimate` on the text of a log and return its report, or its error."""
    (tmp_path / "s.toml").write_text(UNIFORM)

    def run(text):
        (tmp_path / "log.csv").write_text(text)
        words = tmp_path / "log.csv", "--scenario", tmp_path / "s.toml", "--json"
        done = clpt("estimate", *words)
        return json.loads(done.out) if done.status == 0 else done.err

    return run


def off(report, current=CURRENT):
    return np.abs(np.array(report["theta_m_s"])[:, 0] - current).max()


def text_of(head, cells):
    """A log of all rows, written by a function of time, position and velocity."""
    lines = []
    for time, latitude, longitude, course, speed in ROWS:
        east, north = speed * sin(radians(course)), speed * cos(radians(course))
        position = f"{latitude:.8f},{longitude:.8f}"
        lines.append(cells(time, position, east, north))
    return "\n".join([head, *lines])


def course_of(east, north):
    return degrees(atan2(east, north))


COLUMNS = {
    "stamp.sec,stamp.nanosec,lat,lon,heading,speed": lambda t, p, e, n: (
        f"{int(t) - 1},1000000000,{p},{course_of(e, n)},1.0"
    ),
    "timestamp,latitude,longitude,heading (rad),speed": lambda t, p, e, n: (
        f"{1e9 * t:.0f},{p},{atan2(e, n)},1.0"
    ),
    "__time,latitude,longitude,yaw,speed (cm s-1)": lambda t, p, e, n: (
        f"{t},{p},{atan2(n, e)},100"
    ),
    "utc,lat,lon,yaw (deg),speed [m s^-1]": lambda t, p, e, n: (
        f"{t},{p},{degrees(atan2(n, e))},1"
    ),
    "time (seconds since 1970-01-01),lat,lon,v_east,v_north": lambda t, p, e, n: (
        f"{t},{p},{e},{n}"
    ),
    "time,lat,lon,velocity_east (cm s-1),velocity_north (cm s-1)": lambda t, p, e, n: (
        f"{t},{p},{100 * e},{100 * n}"
    ),
}


@pytest.mark.parametrize("head", COLUMNS)
def test_columns_and_units_of_robots_are_read(estimate, head):
    """Yaw is anticlockwise from east, as in ROS (REP 103)."""
    assert off(estimate(text_of(head, COLUMNS[head]))) < 0.002


@pytest.mark.parametrize("missing", ["time", "latitude", "longitude"])
def test_the_error_is_that_of_the_table_that_shares_most_columns(estimate, missing):
    head = HEAD.replace(missing, "my_column")
    said = estimate(text_of(head, lambda t, p, e, n: f"{t},{p},0,1"))
    assert f"no column {missing}; has {head}; a log begins with {HEAD}" in said


@pytest.mark.parametrize(("epoch", "size"), [(719529, 86400), (0, 3600), (0, 60)])
def test_times_in_longer_units_are_refused(estimate, epoch, size):
    """Days of MATLAB, hours and minutes since 1970."""
    cells = text_of(HEAD, lambda t, p, e, n: f"{t / size + epoch},{p},0,1")
    assert "times look like minutes, hours or days" in estimate(cells)


@pytest.mark.parametrize(("rows", "late"), [([5], 86400), ([6, 7, 8], 1e5), ([0], 4e6)])
def test_rows_dated_ahead_cost_their_legs_alone(tmp_path, estimate, rows, late):
    dated = [(r[0] + late * (k in rows), *r[1:]) for k, r in enumerate(ROWS)]
    report = estimate(table(tmp_path / "log.csv", dated).read_text())
    assert off(report) < 0.002
    whys = [skip["why"] for skip in report["skipped"]]
    assert all(any(f"line {row + 2}:" in why for why in whys) for row in rows)
    assert len(report["legs"]) >= 16 - len(rows) - 2


def test_two_courses_at_one_second_are_read(estimate):
    """The second holds; a row in full seconds comes twice a second."""
    latitude, longitude, lines = 36.7, -122.1, [HEAD]
    for leg in range(8):
        t, course = BEGIN + 600.0 * leg, 80.0 * leg % 360
        lines.append(f"{t},{latitude:.8f},{longitude:.8f},{course + 90},1.0")
        for second in range(600):
            lines += [f"{t + second},,,{course + turn},1.0" for turn in (45, 0)]
        way = sin(radians(course)) + CURRENT[0], cos(radians(course)) + CURRENT[1]
        latitude, longitude = place_from(latitude, longitude, *(600 * w for w in way))
    lines.append(f"{BEGIN + 4800},{latitude:.8f},{longitude:.8f},0,1.0")
    report = estimate("\n".join(lines))
    assert off(report) < 0.003
    assert report["skipped"] == []


# --- positions that repeat ------------------------------------------------------------------------


def repeated(every, digits):
    """Rows each `every` s, in which the last fix is repeated, rounded to some digits."""
    for time, latitude, longitude, course, speed in ROWS:
        for k in range(round(LEG / every)):
            position = round(latitude, digits), round(longitude, digits)
            yield (time + every * k, *position, course, speed)


@pytest.mark.parametrize(("every", "digits"), [(600.0, 6), (60.0, 5)])
def test_repeated_positions_are_no_fixes(estimate, every, digits):
    rows = list(repeated(every, digits))
    report = estimate("\n".join([HEAD, *(",".join(map(repr, row)) for row in rows)]))
    assert off(report) < 0.002
    (skipped,) = report["skipped"]
    assert f"{len(rows) - 17} held" in skipped["why"]


@pytest.mark.parametrize("every", [0.5 * LEG, 100.0])
@pytest.mark.long
def test_a_live_learner_takes_no_repeated_position(every):
    learner, notes = clpt.currents.FlowEstimator(EVERYWHERE), []
    for time, *position, course, speed in repeated(every, 6):
        notes.append(learner.fix(time, *position).note)
        way = speed * every
        east, north = way * sin(radians(course)), way * cos(radians(course))
        learner.move(time + every, east, north)
    assert np.abs(learner.flow_parameters[:, 0] - CURRENT).max() < 0.002
    assert sum("held: " in note for note in notes) == len(notes) - 17


def test_a_position_repeats_where_the_vehicle_rests():
    """Without motion it is a fix: of still water."""
    learner = clpt.currents.FlowEstimator(EVERYWHERE)
    for k in range(6):
        learned = learner.fix(3600.0 * k, 36.7, -122.1)
        learner.move(3600.0 * (k + 1), 0.0, 0.0)
    assert learner.legs == 5
    np.testing.assert_allclose(learned.flow_parameters, 0.0, atol=1e-12)


def test_a_log_with_two_motions_is_refused(tmp_path):
    head = f"{HEAD},dr_east_m,dr_north_m"
    (tmp_path / "log.csv").write_text(f"{head}\n0,1,1,0,1,0,0")
    refuses("has both course, speed", clpt.gliders.read_dives, tmp_path / "log.csv")


def test_yaw_in_degrees_without_its_unit_is_refused(tmp_path):
    """A yaw without a unit is in rad."""
    text = text_of("time,lat,lon,yaw,speed", lambda t, p, e, n: f"{t},{p},{60 * pi},1")
    (tmp_path / "log.csv").write_text(text)
    refuses("yaw is .*; must be -180 to 540", clpt.gliders.read_dives, tmp_path)
