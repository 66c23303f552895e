"""What a run says of the speed limit: shares, the first time and the longest stretch."""

import json

import numpy as np
import pytest
from hypothesis import given, seed, settings
from hypothesis import strategies as st

import clpt_control as clpt
from clpt_control.scenario.tables import Units
from clpt_control.simulation.scenario_run import SpeedWatch, faster_flow, speeds_of

PAPER = clpt.paper_scenario()


def watched(flags, cuts=()):
    """Figures of samples a second apart, taken in parts that begin at the cuts."""
    watch, flags = SpeedWatch(1.0), np.asarray(flags)
    for part in np.split(np.arange(len(flags)), sorted(cuts)):
        if len(part):
            speeds = np.column_stack([np.where(flags[part], 2.0, 0.5), np.zeros(len(part))])
            watch.add(part.astype(float), speeds[:, ::-1], speeds)
    return watch.figures()


@seed(2)
@settings(max_examples=200, deadline=None)
@given(flags=st.lists(st.booleans(), min_size=2, max_size=30), data=st.data())
def test_parts_give_what_the_whole_gives(flags, data):
    cuts = data.draw(st.lists(st.integers(1, len(flags) - 1), max_size=4))
    found = watched(flags, cuts)
    assert found == watched(flags)
    spans = "".join("x" if flag else " " for flag in flags[:-1])
    assert found["share_at_limit"] == pytest.approx(spans.count("x") / len(spans))
    if not any(flags):
        assert found["faster_flow"] is None
        return
    faster = found["faster_flow"]
    assert faster["first"] == flags.index(True)
    assert faster["longest"] == max(map(len, spans.split(" ")))
    assert faster["share"] == found["share_at_limit"]


def drifting(**values):
    still = {"kind": "waypoints", "points": [[0.0, 0.0]], "dwell": 100.0}
    base = {"flow.parameters": [[0.0] * 3] * 2, "reference": still, "vehicle.max_speed": 1.0}
    return PAPER.with_values({**base, **values})


def test_a_flow_that_comes_and_goes():
    # 2 sin(2 pi t/12) is above 1 from 1 to 5, and so is its size again from 7 to 11
    wave = {"kind": "sine", "amplitude": [2.0, 0.0], "period": 12.0}
    values = {"flow.disturbance": wave, "run.duration": 24, "run.output_step": 0.01}
    run = clpt.simulate(drifting(**values))
    found = speeds_of(run, 1.0)
    assert faster_flow(found, Units()) in run.attrs["message"]
    assert found["faster_flow"]["first"] == pytest.approx(1.0, abs=0.02)
    assert found["faster_flow"]["longest"] == pytest.approx(4.0, abs=0.02)
    assert found["faster_flow"]["share"] == pytest.approx(2 / 3, abs=2e-3)


def test_a_calm_run_says_nothing_and_its_share_is_right():
    # x = 5 e^-t is commanded back at |v_c| = x: flown at 1 until x = 1, at t = 4
    run = clpt.simulate(
        drifting(**{"vehicle.position": [3.0, 4.0], "run.duration": 16, "run.output_step": 0.125})
    )
    assert run.attrs["message"] == "finished: the end of the span was reached"
    share = run.attrs["share_at_speed_limit"]
    assert share == pytest.approx(0.25, abs=1 / 128)  # the sample where it ends may count
    speed = np.hypot(*run.velocity.values.T)
    assert speed.max() <= 1.0 + 1e-12
    np.testing.assert_allclose(np.hypot(*run.commanded_velocity.values[0]), 5.0)
    assert run.velocity.attrs["units"] == run.commanded_velocity.attrs["units"] == "m s-1"


def test_a_run_without_a_limit_has_nothing_of_it():
    run = clpt.simulate(PAPER.with_values({"run.duration": 5}))
    assert "velocity" not in run
    assert "share_at_speed_limit" not in run.attrs


def test_the_limit_that_ran_is_the_one_that_is_meant():
    short = PAPER.with_values({"run.duration": 40, "vehicle.max_speed": 10.0})
    assert "faster" not in clpt.simulate(short).attrs["message"]
    slow = clpt.simulate(short, params={"speed_limit.max_speed": 0.5})
    assert "the vehicle (0.5 m/s)" in slow.attrs["message"]


def test_the_command_says_it(clpt, tmp_path):
    file = tmp_path / "slow.toml"
    assert clpt("init", file).status == 0
    text = file.read_text().replace("duration = 2000", "duration = 400")
    file.write_text(text.replace("\n[vehicle]", "\n[vehicle]\nmax_speed = 1.5", 1))
    outcome = clpt("run", file, "--out", tmp_path / "run.nc", "--json")
    printed = json.loads(outcome.out)
    assert printed["speed"]["max_speed"] == 1.5
    assert 0.01 < printed["speed"]["faster_flow"]["share"] < printed["speed"]["share_at_limit"] < 1
    assert faster_flow(printed["speed"], Units()) in printed["message"]
    outcome = clpt("run", file, "--out", tmp_path / "run.nc")
    assert "share of time at the speed limit" in outcome.out
    assert "the flow was faster" in outcome.out
    file.write_text(text.replace("\n[vehicle]", "\n[vehicle]\nmax_speed = 9.0", 1))
    outcome = clpt("run", file, "--out", tmp_path / "run.nc")
    assert "never" in outcome.out
