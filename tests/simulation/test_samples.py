"""At which times a run has samples, what it carries, and what it says of the speed limit."""

import re

import control
import numpy as np
import pytest
from still_water import CALM, DWELL, PAPER, POINTS, exact_positions

import clpt_control as clpt
from clpt_control import SimulationError

SAMPLES = [  # of a duration and a step
    (1.0, 0.25, [0, 0.25, 0.5, 0.75, 1]),
    (1.0, 0.3, [0, 0.3, 0.6, 3 * 0.3, 1]),
    (0.3, 0.1, [0, 0.1, 0.2, 0.3]),
    (2.0, 5.0, [0, 2]),
    (0.7, 0.1, [0, 0.1, 0.2, 3 * 0.1, 0.4, 0.5, 6 * 0.1, 0.7]),
]


def test_samples_at_multiples_and_the_end_or_where_asked():
    for duration, step, expected in SAMPLES:
        run = clpt.simulate(
            CALM.with_values({"run.duration": duration, "run.output_step": step})
        )
        assert run.time.values.tolist() == expected
    times = [0.35, 1.23456, 2.1]
    run = clpt.simulate(CALM, times, rtol=1e-11, atol=1e-13)
    assert run.time.values.tolist() == times
    np.testing.assert_allclose(run.position.values, exact_positions(times), atol=1e-9)
    with pytest.raises(SimulationError, match="timepts: is required"):
        clpt.simulate(clpt.closed_loop(PAPER, errors=True))


CONVERTER = control.nlsys(
    None,
    lambda t, x, u, p: [u[0], np.floor(u[0]), np.ceil(u[0])],
    inputs=1,
    outputs=3,
    name="bits",
)


@pytest.mark.parametrize("engine", ["native", "python"])
def test_inputs_at_samples_are_those_given(engine):
    for end, count in ((4.0, 41), (1.3, 24), (0.7, 8)):
        # a ramp, of which sums are not those of linspace
        given = np.linspace(-5, 5, count)
        run = clpt.simulate(CONVERTER, np.linspace(0, end, count), given, engine=engine)
        assert run.attrs["engine"] == engine
        wanted = np.transpose([given, np.floor(given), np.ceil(given)])
        np.testing.assert_array_equal(run.y.values, wanted)


DECAY = clpt.Block(
    "decay", update=lambda t, x, u, p: u - x, inputs={"u": 1}, states={"x": 1}
)


@pytest.mark.parametrize("engine", ["native", "python"])
def test_inputs_are_held_or_joined_by_straight_lines_whose_kinks_are_hit(engine):
    exact, tight = 1 - np.exp(-np.linspace(0, 3, 13)), {"rtol": 1e-11, "atol": 1e-13}
    for inputs in (
        5.0,
        [5.0],
        np.array([5.0]),
        np.full((1, 13), 5.0),
        np.full(13, 5.0),
    ):
        run = clpt.simulate(
            DECAY, np.linspace(0, 3, 13), inputs, engine=engine, **tight
        )
        np.testing.assert_allclose(run.x, 5.0 * exact, atol=1e-9)
    # u = t on [0, 1], then 2 - t on [1, 2]: x(1) = e^-1, then with s = t - 1
    # x' = -x + 1 - s, so x = (x(1) - 2) e^-s + 2 - s
    run = clpt.simulate(
        DECAY, [0.0, 1.0, 2.0], [[0.0, 1.0, 0.0]], engine=engine, **tight
    )
    one = np.exp(-1)
    np.testing.assert_allclose(run.x, [0, one, (one - 2) * one + 1], atol=1e-10)


def test_values_at_a_jump_are_right_limits():
    jumps = DWELL * np.arange(8)
    run = clpt.simulate(CALM, np.sort([*jumps, *np.nextafter(jumps[1:], 0)]))
    assert run.reference.values.tolist() == [POINTS[i // 2 % 3] for i in range(15)]


@pytest.mark.parametrize("engine", ["native", "python"])
def test_jumps_of_two_blocks_at_one_time(engine):
    # half periods at 0.1 k and waypoints at 0.3 k, which differ by rounding alone
    wave = {"kind": "square", "amplitude": [1.0, -2.0], "period": 0.2}
    way = {"kind": "waypoints", "points": [[1.0, 0.0], [0.0, 1.0]], "dwell": 0.3}
    blocks = {
        block.name: block
        for block in clpt.paper_blocks(
            PAPER.with_values({"flow.disturbance": wave, "reference": way})
        )
    }
    ports = {"inputs": {"delta": 2, "zc": 2}, "states": {"s": 4}}
    sum_up = clpt.Block("sum", update=lambda t, x, u, p: u, **ports)
    loop = clpt.connect([blocks["reference"], blocks["disturbance"], sum_up])
    k = np.arange(31)
    run = clpt.simulate(loop, 0.1 * k, rtol=1e-11, atol=1e-13, engine=engine)
    first = 0.1 * (3 * (k // 6) + np.minimum(k % 6, 3))
    exact = [0.1 * (k % 2), -0.2 * (k % 2), first, 0.1 * k - first]
    np.testing.assert_allclose(run.s, np.transpose(exact), atol=1e-12)
    assert run.attrs["solver_restarts"] == 30


def test_status_statistics_and_progress():
    reached = []
    run = clpt.simulate(CALM, progress=reached.append)
    assert (run.status, run.message[:9], run.solver_restarts) == (
        "finished",
        "completed",
        8,
    )
    assert run.attrs["solver_steps"] >= 8  # 5.0 / 0.7: intervals begun
    assert run.attrs["solver_evaluations"] >= 11 * run.attrs["solver_steps"]
    assert reached == sorted(reached)
    assert reached[-1] == 5.0


def test_units_and_dimensions():
    run = clpt.simulate(
        CALM.with_values({"units": {"length": "km", "time": "h"}}), [0, 1]
    )
    assert run.position.dims == ("time", "axis")
    assert run.alpha.dims == ("time", "axis", "basis")
    units = {"position": "km", "time": "h", "alpha": "km h-1", "feedback_gain": "h-1"}
    units["lyapunov"] = "km2"
    assert {name: run[name].units for name in units} == units
    assert run.attrs["Conventions"].startswith("CF-")
    np.testing.assert_array_equal(run.flow_parameters_estimate, -run.alpha)
    np.testing.assert_allclose(
        run.clpe, run.position - run.predicted_position, atol=1e-15
    )


@pytest.mark.parametrize("engine", ["native", "python"])
def test_samples_that_miss_a_jump_by_rounding_are_right_limits(engine):
    # so that k of a step often lies just below the same time as j dwells
    hour = 1 / 3600
    scenario = clpt.paper_scenario().with_values(
        {
            "reference.dwell": 5 * hour,
            "run.output_step": hour,
            "run.duration": 40 * hour,
        }
    )
    run = clpt.simulate(scenario, engine=engine)
    number = np.arange(41) // 5
    np.testing.assert_array_equal(run.reference.values, scenario.waypoints[number % 10])
    np.testing.assert_allclose(run.time.values, hour * np.arange(41), rtol=1e-12)


def drifting(**values):
    still = {"kind": "waypoints", "points": [[0.0, 0.0]], "dwell": 100.0}
    base = {
        "flow.parameters": [[0.0] * 3] * 2,
        "reference": still,
        "vehicle.max_speed": 1.0,
    }
    return PAPER.with_values({**base, **values})


def test_a_flow_that_comes_and_goes(reported):
    # 2 sin(2 pi t/12) is above 1 from 1 to 5, and so is its size again from 7 to 11
    wave = {"kind": "sine", "amplitude": [2.0, 0.0], "period": 12.0}
    values = {"flow.disturbance": wave, "run.duration": 24, "run.output_step": 0.01}
    summary, _ = reported(drifting(**values))
    found = summary["speed"]["faster_flow"]
    wanted = {"first": (1.0, 1e-3), "longest": (4.0, 1e-3), "share": (2 / 3, 1e-3)}
    for key, (value, off) in wanted.items():
        assert found[key] == pytest.approx(value, abs=off)
    said = r"the flow was faster than the vehicle \(1 m/s\), which .*: first at "
    said += r"t = 1[.\d]* s, 66\.\d* % of the time by the samples, 4 s the longest"
    for message in (summary["message"], clpt.simulate(drifting(**values)).message):
        assert re.search(said, message)


def test_a_calm_run_says_nothing_and_its_share_is_right():
    # x = 5 e^-t is commanded back at |v_c| = x: flown at 1 until x = 1, at t = 4
    start = {
        "vehicle.position": [3.0, 4.0],
        "run.duration": 16,
        "run.output_step": 0.125,
    }
    run = clpt.simulate(drifting(**start))
    assert run.attrs["message"] == "completed (t = 16 s)"
    share = run.attrs["share_at_speed_limit"]
    assert share == pytest.approx(0.25, abs=1e-4)
    assert np.hypot(*run.velocity.values.T).max() <= 1.0 + 1e-12
    np.testing.assert_allclose(np.hypot(*run.commanded_velocity.values[0]), 5.0)
    assert (
        run.velocity.attrs["units"] == run.commanded_velocity.attrs["units"] == "m s-1"
    )


def test_the_limit_that_ran_is_the_one_that_is_said():
    short = PAPER.with_values({"run.duration": 40, "vehicle.max_speed": 10.0})
    assert "faster" not in clpt.simulate(short).attrs["message"]
    slow = clpt.simulate(short, params={"speed_limit.max_speed": 0.5})
    assert "the vehicle (0.5 m/s)" in slow.attrs["message"]
    free = clpt.simulate(PAPER.with_values({"run.duration": 5}))
    assert not {"velocity", "share_at_speed_limit"} & {*free, *free.attrs}


def test_the_command_says_it(clpt, printed, tmp_path):
    file, run = tmp_path / "slow.toml", tmp_path / "run.nc"
    assert clpt("init", file).status == 0
    text = file.read_text().replace("duration = 2000", "duration = 400")
    file.write_text(text.replace("\n[vehicle]", "\n[vehicle]\nmax_speed = 1.5", 1))
    found = printed("run", file, "--out", run)
    assert found["speed"]["max_speed"] == 1.5
    assert (
        0.01
        < found["speed"]["faster_flow"]["share"]
        < found["speed"]["share_at_limit"]
        < 1
    )
    assert "the flow was faster than the vehicle (1.5 m/s)" in found["message"]
    said = clpt("run", file, "--out", run).out
    assert all(
        words in said
        for words in ("share of time at the speed limit", "the flow was faster")
    )
