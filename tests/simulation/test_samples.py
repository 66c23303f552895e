"""At which times a run has samples, and what it carries."""

import numpy as np
import pytest
from calm_water import CALM, DWELL, KD, PAPER, POINTS, GammaD, exact_positions
from responses import response

import clpt_control as clpt
from clpt_control.blocks import disturbance, reference
from clpt_control.diagrams.interconnection import connect
from clpt_control.equations import Block
from clpt_control.errors import SimulationError
from clpt_control.native.python_diagram import PythonDiagram
from clpt_control.simulation.integrate import sample_times
from clpt_control.simulation.starts import initial_state


@pytest.mark.parametrize(
    ("duration", "step", "expected"),
    [
        (1.0, 0.25, [0, 0.25, 0.5, 0.75, 1]),
        (1.0, 0.3, [0, 0.3, 0.6, 3 * 0.3, 1]),
        (0.3, 0.1, [0, 0.1, 0.2, 0.3]),
        (2.0, 5.0, [0, 2]),
        (0.7, 0.1, [0, 0.1, 0.2, 3 * 0.1, 0.4, 0.5, 6 * 0.1, 0.7]),
    ],
)
def test_samples_at_multiples_and_the_end(duration, step, expected):
    assert sample_times(duration, step).tolist() == expected
    run = clpt.simulate(CALM.with_values({"run.duration": duration, "run.output_step": step}))
    assert run.time.values.tolist() == expected


def test_samples_where_asked():
    times = [0.35, 1.23456, 2.1]
    run = clpt.simulate(CALM, times, rtol=1e-11, atol=1e-13)
    assert run.time.values.tolist() == times
    np.testing.assert_allclose(run.position.values, exact_positions(times), atol=1e-9)


def test_a_diagram_needs_times():
    with pytest.raises(SimulationError, match="timepts: is required"):
        clpt.simulate(clpt.error_loop(PAPER))


def test_values_at_a_jump_are_right_limits():
    times = sorted(
        {k * DWELL for k in range(8)} | {float(np.nextafter(k * DWELL, 0)) for k in range(1, 8)}
    )
    run = clpt.simulate(CALM, times)
    for t, zc in zip(times, run.reference.values, strict=True):
        k = sum(1 for j in range(1, 9) if j * DWELL <= t)
        assert zc.tolist() == POINTS[k % 3], t


def test_square_wave_in_a_run_switches_exactly():
    period = 1.7951958
    loop = connect([disturbance.disturbance("square", [1.0, -1.0], period=period)], name="loop")
    switches = 0.5 * period * np.arange(1, 200)
    times = np.unique(np.concatenate([[0.0], switches, np.nextafter(switches, 0)]))
    run = response(loop, times)
    signs = 1 - 2 * (np.searchsorted(switches, times, side="right") % 2)
    np.testing.assert_array_equal(run.outputs[0], signs)


def test_jumps_of_two_blocks_at_one_time():
    # half periods at 0.1 k and waypoints at 0.3 k, which differ by rounding alone
    delta = disturbance.disturbance("square", [1.0, -2.0], period=0.2)
    sum_up = Block("sum", update=sums, inputs={"delta": 2, "zc": 2}, states={"s": 4})
    loop = connect([reference.reference([[1.0, 0.0], [0.0, 1.0]], dwell=0.3), delta, sum_up])
    solution = PythonDiagram(loop).run(np.zeros(4), 0.1 * np.arange(31), rtol=1e-11, atol=1e-13)
    k = np.arange(31)
    np.testing.assert_allclose(solution.x[:, 0], 0.1 * (k % 2), atol=1e-12)
    np.testing.assert_allclose(solution.x[:, 1], -0.2 * (k % 2), atol=1e-12)
    first = 0.1 * np.array([3 * (j // 6) + min(j % 6, 3) for j in k])
    np.testing.assert_allclose(solution.x[:, 2], first, atol=1e-12)
    np.testing.assert_allclose(solution.x[:, 3], 0.1 * k - first, atol=1e-12)
    assert solution.statistics["restarts"] == 30


def sums(t, x, u, p):
    """s' = [delta, zc], section 2: u = delta[2], zc[2], state s[4]."""
    return u


def test_pinned_interval_holds_one_waypoint():
    run = clpt.simulate(CALM, [0.0, 2.0], params={"reference.interval": 1.0}, rtol=1e-11)
    rest = GammaD * POINTS[1] / KD
    expected = rest + ([4.0, -2.0] - rest) * np.exp(-2 * KD)
    np.testing.assert_allclose(run.position.values[-1], expected, atol=1e-9)
    np.testing.assert_array_equal(run.reference.values, [POINTS[1]] * 2)


def test_parameters_at_call_time():
    run = clpt.simulate(CALM, [0.0, 0.5], params={"vehicle_controller.KD": [1.0, 4.0]}, rtol=1e-11)
    rest = GammaD * POINTS[0] / [1.0, 4.0]
    expected = rest + ([4.0, -2.0] - rest) * np.exp([-0.5, -2.0])
    np.testing.assert_allclose(run.position.values[-1], expected, atol=1e-9)
    again = clpt.simulate(CALM, [0.0, 0.5], rtol=1e-11, atol=1e-13)
    np.testing.assert_allclose(again.position.values, exact_positions([0.0, 0.5]), atol=1e-9)


def test_status_and_statistics():
    run = clpt.simulate(CALM)
    assert run.attrs["status"] == "finished"
    assert run.attrs["message"].startswith("finished")
    assert run.attrs["solver_restarts"] == 8  # 5.0 / 0.7: intervals begun
    assert run.attrs["solver_steps"] >= 8
    assert run.attrs["solver_evaluations"] >= 11 * run.attrs["solver_steps"]


def test_progress_reaches_the_end():
    reached = []
    clpt.simulate(CALM, progress=reached.append)
    assert reached == sorted(reached)
    assert reached[-1] == 5.0


def test_a_diagrams_run_holds_its_states_by_name():
    loop = clpt.closed_loop(CALM)
    run = clpt.simulate(loop, [0, 1, 2], initial_state=initial_state(CALM))
    assert run.attrs["status"] == "finished"
    assert run.state.values.tolist() == loop.state_labels
    np.testing.assert_allclose(run.states[:, :2], exact_positions([0, 1, 2]), atol=1e-6)
    same = clpt.simulate(CALM, [0, 1, 2])
    assert set(same.data_vars) < set(run.data_vars)
    for name in same.data_vars:
        np.testing.assert_allclose(run[name], same[name], rtol=0, atol=1e-7)
        assert run[name].dims == same[name].dims
        assert run[name].attrs == same[name].attrs


def test_units_and_dimensions():
    run = clpt.simulate(CALM.with_values({"units": {"length": "km", "time": "h"}}), [0, 1])
    assert run.position.dims == ("time", "axis")
    assert run.alpha.dims == ("time", "axis", "basis")
    assert run.position.units == "km"
    assert run.time.units == "h"
    assert run.alpha.units == "km h-1"
    assert run.feedback_gain.units == "h-1"
    assert run.lyapunov.units == "km2"
    assert run.attrs["Conventions"].startswith("CF-")
    np.testing.assert_array_equal(run.flow_parameters_estimate, -run.alpha)
    np.testing.assert_allclose(run.clpe, run.position - run.predicted_position, atol=1e-15)


@pytest.mark.parametrize("engine", ["native", "python"])
def test_samples_that_miss_a_jump_by_rounding_are_right_limits(engine):
    hour = 1 / 3600  # so that k of a step often lies just below the same time as j dwells
    scenario = clpt.paper_scenario().with_values(
        {"reference.dwell": 5 * hour, "run.output_step": hour, "run.duration": 40 * hour}
    )
    run = clpt.simulate(scenario, engine=engine)
    number = np.arange(41) // 5
    np.testing.assert_array_equal(run.reference.values, scenario.waypoints[number % 10])
    np.testing.assert_allclose(run.time.values, hour * np.arange(41), rtol=1e-12)
