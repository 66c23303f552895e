"""Replay of a glider: figures of SG542, causality, mistakes, rows, the dataset; growing records."""

import json
import math
import re
import time
from dataclasses import replace
from datetime import UTC, datetime

import numpy as np
import pytest
import xarray
from geodesics import displacement, place_from
from hypothesis import given, settings
from hypothesis import strategies as st
from refusals import refuses
from synthetic_vehicle import vehicle

from clpt_control import ArgumentError, ScenarioError
from clpt_control.gliders import make_dive, sample_dives
from clpt_control.replay import Replay, replay_dives

DIVES = sample_dives()


def test_sg542_without_learning_and_with_it(sg542):
    # the 13 after the first, which has no dive before it; all 14, the first with no flow
    found = sg542.summary()
    after = found["clpe_rms_after_3"]
    for key, no_flow, previous in (
        ("clpe_rms", 1853, 1213),
        ("clpe_rms_all", 1950, 1407),
    ):
        assert found[key]["no_flow"] == pytest.approx(no_flow, abs=1)
        assert found[key]["previous_dive"] == pytest.approx(previous, abs=1)
    assert after["previous_dive"] == pytest.approx(1167, rel=0.01)
    assert after["adaptive"] <= 0.88 * after["previous_dive"]
    assert 0.75 <= found["hindsight"]["inside"] / 14 <= 1
    assert found["dac_identity_median"] < 1e-3
    one = replay_dives([sg542.steps[0].dive]).summary()
    assert set(one["clpe_rms"].values()) == {None}
    assert one["clpe_rms_all"]["previous_dive"] == pytest.approx(2931, abs=1)


def test_mistakes_are_sentences():
    dives, replay = vehicle(1, 2), Replay()
    replay.step(dives[1])
    refuses("ends before dive 1", replay.step, dives[0])
    refuses(
        "must be finite", replay.step, replace(dives[1], t_gpse=2e9, gps_east=math.nan)
    )
    said = "'p5420304.nc'.*must be a list of Dives.*read_dives"
    refuses(said, replay_dives, ["p5420304.nc"], error=ArgumentError)


def test_the_next_surfacing_is_that_of_the_next_dive():
    """Planned as it was flown, the next dive's forecast is the one the replay gives it."""
    *earlier, last = DIVES
    before = replay_dives(earlier)
    found = before.next_dive(last.duration, (last.dr_east, last.dr_north))
    start = before.start()
    assert start[0] == earlier[-1].t_gpse + found.as_dict()["surface_time"]
    step = before.step(last)
    # but for the drift at the surface: it starts at the fix where the glider came up
    assert found.forecast == pytest.approx(step.forecast, abs=15)
    # and for what a dive scatters by that is flown as planned
    assert np.linalg.eigvalsh(found.covariance - step.covariance).min() > 0
    way = found.forecast + np.array([last.dr_east, last.dr_north])
    assert (found.latitude, found.longitude) == place_from(*start[1:], *way)
    for plan in ((0.0, (0.0, 0.0)), (3600.0, (math.inf, 0.0))):
        refuses("through the water", before.next_dive, *plan, error=ScenarioError)


def test_what_is_learned_is_said_as_it_is():
    said = replay_dives(vehicle(1, 2)).summary()["said"]
    assert "M2 0.0" in said
    assert "(odds 1:" in said or "(odds below 1:99)" in said
    tidal = replay_dives(vehicle(3, 40, flow="M2", fix=5.0))
    # the made tide turns by 0.15 m/s one way and 0.075 the other
    size = re.search(r"M2 (\S+) m/s \(odds above 99:1\)", tidal.summary()["said"])[1]
    assert float(size) == pytest.approx(0.15, abs=0.02)
    assert replay_dives([]).summary()["said"] == "nothing"
    bare = replay_dives(vehicle(1, 3), flow=("steady",), learn_speed=False)
    assert bare.summary()["said"].endswith("over the last dive")
    noted = replace(vehicle(1, 3)[1], notes=("filled 2 samples",))
    found = replay_dives([vehicle(1, 3)[0], noted]).summary()
    assert found["notes"] == [{"dive": 1, "note": "filled 2 samples"}]


@pytest.mark.parametrize(("factor", "said"), [(1.5, "too slow"), (0.6, "too fast")])
def test_a_speed_far_from_one_is_a_sentence(factor, said):
    replay = replay_dives(vehicle(4, 30, factor=factor))
    assert f": your flight model is {said}; compass" in replay.summary()["said"]
    replay.steps[-1].speed = 1 - 2.99 * replay.steps[-1].speed_error
    assert "flight model" not in replay.summary()["said"]


ONE = replay_dives(DIVES[:1])


@pytest.mark.long
@settings(derandomize=True, max_examples=200, deadline=None)
@given(st.floats(-90, 90), st.floats(-360, 360))
def test_minutes_are_the_degrees(lat, lon):
    """In the row of a waypoint, wherever it is."""
    words = ONE.aims([(lat, lon)])[0].as_dict()["place"].split()
    found = [
        (int(whole) + float(minutes) / 60) * (-1 if name in "SW" else 1)
        for whole, minutes, name in (words[:3], words[3:])
    ]
    assert all(0 <= float(minutes) < 60 for minutes in (words[1], words[4]))
    assert found[0] == pytest.approx(lat, abs=0.0051 / 60)
    turns = (found[1] - lon) / 360
    assert turns == pytest.approx(round(turns), abs=0.0051 / 60 / 360)
    assert abs(found[1]) <= 180


def test_drift_is_from_where_it_came_up():
    first = make_dive(7, (0.0, 0.0, 179.9), (9000.0, 0.0, 179.99), (0.0, 0.0))
    next_one = make_dive(8, (9600.0, 0.0, -179.99), (19000.0, 0.0, -179.9), (0.0, 0.0))

    def drift(*dives):
        return replay_dives(dives).summary()["each_dive"][-1]["drift"]

    way = drift(first, next_one)
    degree = math.radians(1) * 6378137.0  # along the equator
    # over the date line
    assert way["distance"] == pytest.approx(0.02 * degree, rel=1e-9)
    assert way["direction"] == pytest.approx(90.0)
    assert way["speed"] == pytest.approx(0.02 * degree / 600)
    assert drift(first, replace(next_one, number=9)) is None  # a dive is missing
    gps1 = replace(next_one, number=9, t_gps1=9300.0, lat_gps1=0.0, lon_gps1=-180.0)
    assert drift(first, gps1)["distance"] == pytest.approx(0.01 * degree, rel=1e-9)
    assert drift(first, replace(gps1, t_gps1=math.nan)) is None
    at_once = make_dive(8, (9020.0, 0.0, 179.99), (19000.0, 0.0, -179.9), (0.0, 0.0))
    still = drift(first, at_once)
    assert still["direction"] is still["speed"] is None


def test_each_dive_has_its_row(sg542):
    rows = sg542.summary()["each_dive"]
    text = json.dumps(rows, allow_nan=False)
    assert (json.loads(text), [row["dive"] for row in rows]) == (
        rows,
        list(range(304, 318)),
    )
    assert len({tuple(row) for row in rows}) == 1
    for row, step in zip(rows, sg542.steps, strict=True):
        dive = step.dive
        apart = displacement(dive.lat_gps1, dive.lon_gps1, dive.lat_gps2, dive.lon_gps2)
        if dive.number != 307:  # up for 51 minutes, GPS1 is a later fix
            assert row["drift"]["distance"] == pytest.approx(
                math.hypot(*apart), abs=1e-6
            )
        speed = math.hypot(dive.gps_east, dive.gps_north) / dive.duration
        assert row["over_ground"]["speed"] == pytest.approx(speed)
        assert row["current_speed"] == pytest.approx(np.linalg.norm(step.current))
        forecast = row["hindsight"]["latitude"], row["hindsight"]["longitude"]
        miss = math.hypot(*displacement(*forecast, dive.lat_gpse, dive.lon_gpse))
        assert miss == pytest.approx(row["clpe"]["adaptive"], rel=1e-3, abs=1)
    assert rows[0]["start"] == "2016-01-31T22:04:50Z"


@pytest.mark.parametrize(
    ("late", "which"),
    [(7200, "clock"), (-60, "end of the last dive"), (40 * 86400, "end of the")],
)
def test_hours_from_the_clock_or_the_last_end(sg542, monkeypatch, late, which):
    end = sg542.steps[-1].dive.t_gpse
    monkeypatch.setattr(time, "time", lambda: end + late)
    said = sg542.next_dive().as_dict()
    since = late if which == "clock" else 0
    assert said["now_is"].startswith(which)
    now = datetime.fromtimestamp(round(end + since), UTC)
    assert datetime.fromisoformat(said["now"]) == now
    assert 0 < said["surface_time"] < 1800
    hours = (said["surface_time"] + said["duration"] - since) / 3600
    assert said["hours_from_now"] == pytest.approx(hours)


def test_the_dataset_is_a_cf_trajectory(sg542, tmp_path):
    rows, ahead = sg542.summary()["each_dive"], sg542.next_dive()
    sg542.dataset().to_netcdf(tmp_path / "replay.nc")
    with xarray.open_dataset(tmp_path / "replay.nc") as data:
        assert data.attrs["featureType"] == "trajectory"
        assert (data.trajectory.attrs["cf_role"], data.sizes["dive"]) == (
            "trajectory_id",
            14,
        )
        assert str(data.time.values[0])[:10] == "2016-02-01"
        names = (
            ("hindsight", "inside"),
            ("drift", "distance"),
            ("over_ground", "speed"),
            ("over_ground", "direction"),
        )
        for key, inner in (*names, ("clpe", "adaptive")):
            assert data[f"{key}_{inner}"].values.tolist() == [
                row[key][inner] for row in rows
            ]
        assert data.current_direction.values.tolist() == [
            row["current_direction"] for row in rows
        ]
        inside = [row["forecast"]["inside"] for row in rows[1:]]
        assert data.forecast_inside.values.tolist() == [-1, *inside]
        assert data.attrs["level"] == sg542.summary()["level"]
        assert str(data.next_time.values)[:19] == ahead.as_dict()["time"][:19]
        assert float(data.next_latitude) == ahead.latitude
    bare = replay_dives(vehicle(1, 3), flow=("steady",), learn_speed=False)
    assert "speed_factor" not in bare.dataset()


def said(replay):
    """All that is said of a replay, as text."""
    ahead = {**replay.surfacing().as_dict(), "now": None}
    return json.dumps([replay.summary(), ahead])


def tracked(dive):
    """A dive with a straight track, made anew."""
    line = np.linspace(0.0, 1.0, 5)
    track = line * dive.duration, line * dive.dr_east, line * dive.dr_north
    return replace(dive, track=track, dac_east=float("nan"))


class Counted(Replay):
    """A replay that lists the numbers of the dives that it learns."""

    def __init__(self):
        super().__init__()
        self.learned = []

    def step(self, dive):
        self.learned.append(dive.number)
        return super().step(dive)


def test_dive_by_dive_is_all_at_once():
    growing = Replay()
    for count in (1, 2, 5, 5, 9, 14):
        assert said(growing.feed(DIVES[:count])) == said(replay_dives(DIVES[:count]))
    for more, once in (({"dac_east": 0.1}, True), ({}, False)):
        # NaN is never taken as the same
        growing = Counted()
        for count in range(1, 15):
            growing.feed([replace(tracked(dive), **more) for dive in DIVES[:count]])
        assert (growing.learned == [dive.number for dive in DIVES]) == once


@pytest.mark.long
def test_what_changed_is_learned_anew():
    eight = vehicle(2, 8)
    fourth = eight[3]
    for others in (
        [replace(fourth, notes=("read again",))],
        [tracked(fourth)],
        [replace(fourth, track=tracked(fourth).track)],
        [replace(fourth, lat_gpse=fourth.lat_gpse + 1e-9)],
        [],
        None,
    ):
        changed = eight[:4] if others is None else [*eight[:3], *others, *eight[4:]]
        growing = Counted().feed(eight)
        growing.learned.clear()
        growing.feed(changed)
        assert (len(growing.learned), said(growing)) == (
            len(changed),
            said(replay_dives(changed)),
        )


def test_an_interrupt_leaves_what_was_learned():
    growing = Counted()

    def cut(done):
        if done == 6:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        growing.feed(DIVES, cut)
    assert said(growing.feed(DIVES)) == said(replay_dives(DIVES))
    assert growing.learned[:14] == [dive.number for dive in DIVES]
