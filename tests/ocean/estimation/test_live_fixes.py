"""Fixes one by one, as lines of JSON, with a state on disk: the numbers of all at once."""

import io
import json
import random
import subprocess
import sys
import time
from datetime import datetime
from pathlib import Path

import numpy as np
import pytest
from subprocesses import CLPT, GUARD, ran
from test_recorded_fixes import SCENARIO, straight_mission

import clpt_control as clpt

EXAMPLE = Path(__file__).parents[3] / "examples" / "nmea_fixes.py"
SCENARIO_TEXT = """
origin = [36.7, -122.1]
[units]
length = "km"
time = "h"
[basis]
kernel = "gaussian"
centers = [[0, 0], [12, 0], [6, 10]]
widths = [8.0, 8.0, 8.0]
constituents = ["steady", "steady", "steady"]
[learning]
law = "fix-regression"
"""


def stream(fixes, seed=4):
    """Lines of a vehicle that changes its course twice between two fixes, in a current."""
    numbers = np.random.default_rng(seed)
    latitude, longitude, t = 36.7, -122.1, 1.7e9
    lines = [{"time": t, "latitude": latitude, "longitude": longitude}]
    for _ in range(fixes):
        for _ in range(2):
            course = float(numbers.uniform(0, 360))
            lines.append({"time": t, "course": course, "speed": 1.0})
            t += 900.0
            angle = np.radians(course)
            latitude += (900 * (np.cos(angle) - 0.1)) / 111e3
            longitude += (900 * (np.sin(angle) + 0.2)) / 89e3
        # the vehicle is kept near the functions
        latitude, longitude = (
            float(np.clip(latitude, 36.6, 36.8)),
            float(np.clip(longitude, -122.2, -122.0)),
        )
        lines.append({"time": t, "latitude": latitude, "longitude": longitude})
    return [json.dumps(line) for line in lines]


@pytest.fixture
def scenario(tmp_path):
    path = tmp_path / "mine.toml"
    path.write_text(SCENARIO_TEXT)
    return path


@pytest.fixture
def estimate(clpt, scenario, monkeypatch):
    """Run `clpt estimate -` in-process on lines of standard input."""

    def run(lines, *words, status=0):
        monkeypatch.setattr(sys, "stdin", io.StringIO("\n".join(lines)))
        done = clpt("estimate", "-", "--scenario", scenario, *words)
        assert done.status == status, done.err
        return done

    return run


def answers(out):
    return [json.loads(line) for line in out.splitlines()]


def test_legs_one_by_one_are_legs_at_once(tmp_path, estimate):
    """The table's numbers, to the last bit, from lines of the same legs."""
    rows = straight_mission(legs=10)
    names = ["number", "start", "lat0", "lon0", "end", "lat1", "lon1", "east", "north"]
    lines = []
    for row in rows:
        leg = dict(zip(names, row, strict=True))
        lines += [
            {"time": leg["start"], "latitude": leg["lat0"], "longitude": leg["lon0"]},
            {"time": leg["end"], "dr_east_m": leg["east"], "dr_north_m": leg["north"]},
            {"time": leg["end"], "latitude": leg["lat1"], "longitude": leg["lon1"]},
        ]
    done = estimate(map(json.dumps, lines))
    head = "dive,t_gps2,lat_gps2,lon_gps2,t_gpse,lat_gpse,lon_gpse,dr_east_m,dr_north_m"
    table = tmp_path / "legs.csv"
    table.write_text("\n".join([head, *(",".join(map(repr, row)) for row in rows)]))
    legs, _ = clpt.gliders.read_dives(table)
    data = clpt.currents.flow_estimate(legs, clpt.Scenario(**SCENARIO))
    live = [a for a in answers(done.out) if a.get("error_m") is not None]
    expected = data.flow_parameters_estimate.values.tolist()
    assert [answer["theta_m_s"] for answer in live] == expected


@pytest.mark.long
def test_a_restarted_learner_has_the_same_numbers(tmp_path, scenario, estimate):
    """Stopped after any line and started anew with its state: equal to the last bit."""
    lines = stream(25)
    expected = answers(estimate(lines).out)[-1]
    state = tmp_path / "state.json"
    cuts = sorted(random.Random(2).sample(range(2, len(lines)), 3))
    for begin, end in zip([0, *cuts], [*cuts, len(lines)], strict=True):
        # a sender that is not sure what arrived sends three lines again
        again = lines[max(begin - 3, 0) : end]
        done = estimate(again, "--state", state)
    assert answers(done.out)[-1] == expected
    # by a process of its own, too
    words = [*CLPT, "estimate", "-", "--scenario", scenario]
    alone = ran(*words, input="\n".join(lines)).stdout
    assert answers(alone)[-1] == expected


def fresh(path):
    """Return the number of answers that are no repetition."""
    return path.read_text().count("error_m")


@pytest.mark.processes
def test_a_killed_learner_has_the_same_numbers(tmp_path, scenario):
    """1,000 fixes, killed ten times at random, fed again from the start: equal to the last bit."""
    lines = stream(1000)
    whole = ran(*CLPT, "estimate", "-", "--scenario", scenario, input="\n".join(lines))
    expected = answers(whole.stdout)[-1]
    state = tmp_path / "state.json"
    words = [*CLPT, "estimate", "-", "--scenario", scenario, "--state", state]
    chance, killed = random.Random(5), 0
    (tmp_path / "lines").write_text("\n".join(lines))
    for _ in range(10):
        out = tmp_path / "out"
        with (tmp_path / "lines").open() as fed, out.open("w") as answered:
            process = subprocess.Popen(
                [*map(str, words)],
                stdin=fed,
                stdout=answered,
                stderr=subprocess.DEVNULL,
            )
            least = chance.randint(60, 110)  # answers that are new, about
            while process.poll() is None and fresh(out) < least:
                time.sleep(0.01)
            time.sleep(chance.random() * 0.05)
            killed += process.poll() is None
            process.kill()
            process.wait(GUARD)
    assert killed == 10
    done = ran(*words, input="\n".join(lines))
    assert answers(done.stdout)[-1] == expected


def test_a_plan_is_forecast(estimate):
    """The next fix: the plan's displacement, drifted by the learned flow."""
    lines = stream(40)
    last = json.loads(lines[-1])
    end = last["time"] + 3600
    plan = {"plan": [{"time": end, "course": 90.0, "speed": 1.0}]}
    lines[-1] = json.dumps(last | plan)
    ahead = answers(estimate(lines).out)[-1]["next"]
    assert datetime.fromisoformat(ahead["time"]).timestamp() == end
    way = (ahead["longitude"] - last["longitude"]) * 89.3e3
    assert 3600 < way < 3600 * 1.5  # 1 m/s to the east and a current to the east
    assert 0 < ahead["radius_m"] < 3000


@pytest.mark.parametrize(
    ("line", "sentence"),
    [
        ("{", "is not JSON"),
        ("[1]", "must be an object"),
        ('{"latitude": 1, "longitude": 2}', 'with "time"'),
        ('{"time": 1, "lat": 2}', "unknown key 'lat'"),
        ('{"time": 1, "latitude": 2}', "latitude without the other"),
        ('{"time": NaN, "course": 1, "speed": 2}', "must be a finite number"),
        ('{"time": 1, "course": 900, "speed": 2}', "course is 900"),
        ('{"time": 1, "dr_east_m": 1, "dr_north_m": 2}', "no fix yet"),
    ],
)
def test_a_wrong_line_is_told_and_left_out(estimate, line, sentence):
    """The others are learned as if it were not there; the status is 2."""
    lines = stream(3)
    good, done = estimate(lines), estimate([line, *lines], status=2)
    assert sentence in done.err
    assert done.out == good.out


def test_a_gap_begins_a_leg(estimate):
    """A time of unknown displacement teaches nothing, and is told."""
    first = {"time": 0, "latitude": 36.7, "longitude": -122.1}
    later = {"time": 7200, "latitude": 36.75, "longitude": -122.0}
    answer = answers(estimate(map(json.dumps, [first, later])).out)[-1]
    assert answer["legs"] == 0
    assert "7200 s before it is not known" in answer["note"]


def test_the_state_of_another_scenario_is_refused(tmp_path, scenario, estimate):
    """So is a file that is no state; nothing is written."""
    state = tmp_path / "state.json"
    estimate(stream(2), "--state", state)
    before = state.read_text()
    scenario.write_text(SCENARIO_TEXT.replace("8.0, 8.0, 8.0", "8.0, 8.0, 9.0"))
    done = estimate([], "--state", state, status=2)
    assert "state of another scenario" in done.err
    assert state.read_text() == before
    state.write_text("{}")
    assert "is not the state" in estimate([], "--state", state, status=2).err


def test_nmea_sentences_become_lines():
    """RMC is a fix, VHW course and speed; a wrong checksum is left out."""
    sentences = [
        checked("GPRMC,120000,A,3642.000,N,12206.000,W,0.0,0.0,010526,,"),
        checked("IIVHW,90.0,T,80.0,M,2.0,N,3.7,K"),
        checked("GPRMC,130000,V,,,,,0.0,0.0,010526,,"),
        "$IIVHW,45.0,T,80.0,M,2.0,N,3.7,K*00",
    ]
    done = ran(sys.executable, EXAMPLE, input="\n".join(sentences))
    fix, steering = answers(done.stdout)
    assert fix["latitude"] == pytest.approx(36.7)
    assert fix["longitude"] == pytest.approx(-122.1)
    assert fix["time"] == 1777636800.0  # 2026-05-01 12:00 UTC
    assert steering["course"] == 90.0
    assert steering["speed"] == pytest.approx(1.02889, abs=1e-5)


def checked(body):
    """Return a sentence with its checksum."""
    total = 0
    for letter in body.encode():
        total ^= letter
    return f"${body}*{total:02x}"


def before_a_fix(late):
    """A leg of 2 h whose first hour is told by a line of its own."""
    at = "2026-05-01T0{}:00:00Z".format
    fixes = [{"latitude": 36.7, "longitude": y} for y in (-122.1, -122.03)]
    course = json.dumps({"time": at(1), "course": 90, "speed": 1.0})
    first, last = (
        json.dumps({"time": at(k), **f}) for k, f in zip((0, 2), fixes, strict=True)
    )
    return [first, late, course, last]


@pytest.mark.parametrize(
    ("line", "status"),
    [
        ('{"time": "2026-05-01T00:00:00Z", "course": 90, "speed": null}', 0),
        ('{"time": "2026-05-01T00:00:00Z", "course": 90, "speed": 60}', 0),
        ('{"time": "2026-05-01T00:00:00Z", "course": 90, "spe', 2),
    ],
)
def test_an_hour_of_unknown_motion_is_no_hour_at_rest(estimate, line, status):
    """A leg that a later course ends is not learned, as in a table with the same rows."""
    last = answers(estimate(before_a_fix(line), status=status).out)[-1]
    assert last["legs"] == 0
    assert "3600 s before it is not known" in last["note"]


@pytest.mark.long
def test_a_torn_line_is_remembered_by_the_state(scenario, tmp_path):
    """A process that ends behind a torn line answers as one that goes on."""
    state = tmp_path / "state"
    command = [*CLPT, "estimate", "-", "--scenario", scenario, "--state", state]
    lines = before_a_fix('{"time": "2026-05-01T00:00:00Z", "course": 90, "spe')
    ran(*command, input="\n".join(lines[:2]) + "\n", status=2)
    done = ran(*command, input="\n".join(lines[2:]) + "\n")
    assert answers(done.stdout)[-1]["legs"] == 0
