"""Times, places and a row for each dive: closed forms, carries, edges; no NaN in JSON."""

import json
import math
from dataclasses import replace

import numpy as np
import pytest
import xarray
from hypothesis import given, settings
from hypothesis import strategies as st
from synthetic_vehicle import vehicle

from clpt_control.estimation.fix_model import FixModel
from clpt_control.geodesy import displacement
from clpt_control.gliders.dive_files import sample_dives
from clpt_control.gliders.dives import make_dive
from clpt_control.replay import habits, places, surfacing
from clpt_control.replay.facts import replay_dataset
from clpt_control.replay.outcome import summary
from clpt_control.replay.replay import next_dive, replay_dives


@settings(derandomize=True, max_examples=200)
@given(st.floats(-90, 90), st.floats(-360, 360))
def test_minutes_are_the_degrees(lat, lon):
    words = places.in_minutes(lat, lon).split()
    found = []
    for whole, minutes, name in (words[:3], words[3:]):
        assert 0 <= float(minutes) < 60
        found.append((int(whole) + float(minutes) / 60) * (-1 if name in "SW" else 1))
    assert found[0] == pytest.approx(lat, abs=0.0051 / 60)
    turns = (found[1] - lon) / 360
    assert turns == pytest.approx(round(turns), abs=0.0051 / 60 / 360)
    assert abs(found[1]) <= 180


def test_drift_is_from_where_it_came_up():
    first = make_dive(7, (0.0, 0.0, 179.9), (9000.0, 0.0, 179.99), (0.0, 0.0))
    next_one = make_dive(8, (9600.0, 0.0, -179.99), (19000.0, 0.0, -179.9), (0.0, 0.0))
    way = habits.drift(next_one, first)
    degree = math.radians(1) * 6378137.0  # along the equator
    assert way.east == pytest.approx(0.02 * degree, rel=1e-9)  # over the date line
    said = way.as_dict()
    assert said["direction"] == pytest.approx(90.0)
    assert said["speed"] == pytest.approx(0.02 * degree / 600)
    assert habits.drift(replace(next_one, number=9), first) is None  # a dive is missing
    gps1 = replace(next_one, number=9, t_gps1=9300.0, lat_gps1=0.0, lon_gps1=-180.0)
    assert habits.drift(gps1, first).east == pytest.approx(0.01 * degree, rel=1e-9)
    assert habits.drift(replace(gps1, t_gps1=math.nan), first) is None
    still = habits.Way(0.0, 0.0, 20.0).as_dict()
    assert still["direction"] is still["speed"] is None


def test_each_dive_has_its_row():
    replay = replay_dives(sample_dives())
    rows = summary(replay)["each_dive"]
    text = json.dumps(rows, allow_nan=False)
    assert json.loads(text) == rows
    assert [row["dive"] for row in rows] == list(range(304, 318))
    assert len({tuple(row) for row in rows}) == 1
    for row, step in zip(rows, replay.steps, strict=True):
        dive = step.dive
        apart = displacement(dive.lat_gps1, dive.lon_gps1, dive.lat_gps2, dive.lon_gps2)
        if dive.number != 307:  # up for 51 minutes, GPS1 is a later fix
            assert row["drift"]["distance"] == pytest.approx(math.hypot(*apart), abs=1e-6)
        assert row["over_ground"]["speed"] == pytest.approx(
            math.hypot(dive.gps_east, dive.gps_north) / dive.duration
        )
        assert row["current_speed"] == pytest.approx(np.linalg.norm(step.current))
        miss = displacement(
            row["forecast_latitude"], row["forecast_longitude"], dive.lat_gpse, dive.lon_gpse
        )
        assert math.hypot(*miss) == pytest.approx(row["clpe"]["adaptive"], rel=1e-3, abs=1)
    assert rows[0]["start"] == "2016-01-31T22:04:50Z"


@pytest.mark.parametrize("learns", [False, True])
def test_a_speed_that_is_not_learned_is_no_number_of_a_dive(learns):
    replay = replay_dives(vehicle(1, 3), model=FixModel(("steady",), learn_speed=learns))
    assert ("speed_factor" in replay_dataset(replay)) == learns


def test_hours_from_the_clock_or_the_last_end(monkeypatch):
    replay = replay_dives(sample_dives()[:4])
    end = replay.steps[-1].dive.t_gpse
    found = next_dive(replay)
    for clock, which, late in (
        (end + 7200, "clock", 7200),
        (end - 60, "end of the last dive", 0),
        (end + 40 * 86400, "end of the last dive", 0),
    ):
        monkeypatch.setattr(surfacing.time, "time", lambda clock=clock: clock)
        said = found.as_dict()
        assert said["now_is"] == which
        assert said["now"] == places.utc(end + late)
        surface = said["surface_time"]
        assert 0 < surface < 1800
        hours = (surface + said["duration"] - late) / 3600
        assert said["hours_from_now"] == pytest.approx(hours)


def test_the_dataset_says_when_and_where():
    replay = replay_dives(sample_dives()[:5])
    ahead = next_dive(replay)
    data = replay_dataset(replay)
    rows = summary(replay)["each_dive"]
    for key, inner, name in (
        ("drift", "distance", "drift_distance"),
        ("over_ground", "speed", "over_ground_speed"),
        ("over_ground", "direction", "over_ground_direction"),
    ):
        assert data[name].values.tolist() == [row[key][inner] for row in rows]
    assert data.current_direction.values.tolist() == [row["current_direction"] for row in rows]
    when = xarray.decode_cf(data).next_time.values
    assert str(when)[:19] == ahead.as_dict()["time"][:19]
    assert float(data.next_latitude) == ahead.latitude
