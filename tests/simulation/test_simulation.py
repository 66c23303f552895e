"""Runs against exact solutions, and what is said when one cannot go on."""

import itertools
import math
import pickle
from typing import NamedTuple

import control
import numpy as np
import pytest

import clpt_control as clpt
from clpt_control.blocks import Block, disturbance, field, reference, vehicle
from clpt_control.blocks.declaration import states_as_outputs
from clpt_control.currents.field_file import GriddedField
from clpt_control.diagrams.interconnection import connect
from clpt_control.errors import ClptError, DataError, ScenarioError, SimulationError
from clpt_control.native.python_diagram import PythonDiagram
from clpt_control.simulation.integrate import sample_times
from clpt_control.simulation.loops import initial_state

PAPER = clpt.paper_scenario()
KD, GammaD = np.array([0.5, 2.0]), np.array([1.5, -1.0])
POINTS = [[1.0, 2.0], [-3.0, 0.5], [0.0, -1.0]]
DWELL = 0.7
CALM = PAPER.with_values(
    {
        "flow.parameters": [[0.0] * 3] * 2,
        "vehicle.feedback": KD,
        "vehicle.feedforward": GammaD,
        "vehicle.position": [4.0, -2.0],
        "reference": {"kind": "waypoints", "points": POINTS, "dwell": DWELL},
        "run.duration": 5.0,
        "run.output_step": 0.1,
    }
)


def exact_positions(times, x0=(4.0, -2.0)):
    """x' = -KD x + GammaD zc, zc held: an exponential in each interval."""
    out = []
    for t in times:
        x, start, k = np.array(x0), 0.0, 0
        while True:
            end = min(t, DWELL * (k + 1))
            rest = GammaD * POINTS[k % 3] / KD
            x = rest + (x - rest) * np.exp(-KD * (end - start))
            if end == t:
                break
            start, k = end, k + 1
        out.append(x)
    return np.array(out)


# --- exact solutions --------------------------------------------------------------------------


def test_calm_water_across_waypoints():
    run = clpt.simulate(CALM, rtol=1e-11, atol=1e-13)
    exact = exact_positions(run.time.values)
    assert len(exact) == 51
    np.testing.assert_allclose(run.position.values, exact, rtol=0, atol=1e-9)


def test_calm_water_at_the_default_tolerance():
    run = clpt.simulate(CALM)
    np.testing.assert_allclose(run.position.values, exact_positions(run.time.values), atol=2e-7)


def test_tolerance_buys_accuracy():
    errors = []
    for rtol in (1e-4, 1e-6, 1e-8, 1e-10):
        run = clpt.simulate(CALM, rtol=rtol, atol=rtol / 100)
        errors.append(np.abs(run.position.values - exact_positions(run.time.values)).max())
    assert errors[0] < 1e-2
    assert errors[-1] < 1e-8
    assert all(later < earlier / 5 for earlier, later in itertools.pairwise(errors))


class Rate(NamedTuple):
    k: float


def decays(t, x, u, p, dx):
    """x' = -k x + u, section 2: u[1], x[1]."""
    dx[0] = -p.k * x[0] + u[0]


def oscillates(t, x, u, p, dx):
    """x'' = -x, section 2: x[2]."""
    dx[0] = x[1]
    dx[1] = -x[0]


def decaying(k=2.0):
    block = Block("decay", update=decays, inputs={"u": 1}, states={"x": 1}, parameters=Rate(k))
    return control.interconnect(
        [block],
        inplist=["decay.u[0]"],
        outlist=["decay.x[0]"],
        inputs=["u"],
        outputs=["x"],
        connections=False,
        name="one",
    )


def test_circle_of_a_linear_oscillator():
    block = Block("spring", update=oscillates, states={"x": 2})
    loop = control.interconnect(
        [block],
        outlist=["spring.x[0]", "spring.x[1]"],
        name="loop",
        connections=False,
        outputs=["a", "b"],
    )
    times = np.linspace(0, 20 * math.pi, 41)  # every quarter turn
    run = clpt.simulate(loop, times, initial_state=[1, 0], rtol=1e-11, atol=1e-13)
    np.testing.assert_allclose(run.outputs[0, ::4], 1.0, atol=1e-8)
    np.testing.assert_allclose(run.outputs[0, 2::4], -1.0, atol=1e-8)
    np.testing.assert_allclose(run.outputs[1, ::2], 0.0, atol=1e-8)


# --- inputs -----------------------------------------------------------------------------------


def test_constant_input():
    times = np.linspace(0, 3, 13)
    exact = 2.5 * (1 - np.exp(-2 * times))  # rest at u/k = 5/2
    for inputs in (
        5.0,
        [5.0],
        np.array([5.0]),
        lambda t: np.array([5.0]),
        lambda t: [5.0],
        np.full((1, 13), 5.0),
        np.full(13, 5.0),
    ):
        run = clpt.simulate(decaying(), times, inputs, rtol=1e-11, atol=1e-13)
        np.testing.assert_allclose(run.outputs.ravel(), exact, atol=1e-9)
        np.testing.assert_allclose(run.inputs.ravel(), 5.0)


def test_array_is_joined_by_straight_lines_and_its_kinks_are_hit():
    # u = t on [0, 1], then 2 - t on [1, 2]: x' = -x + u from 0
    times = np.array([0.0, 1.0, 2.0])
    run = clpt.simulate(decaying(1.0), times, [[0.0, 1.0, 0.0]], rtol=1e-12, atol=1e-14)
    one = math.exp(-1)  # x(1) = 1 - 1 + e^-1
    # on [1, 2] with s = t - 1: x' = -x + 1 - s, x = (x1 - 2) e^-s + 2 - s
    two = (one - 2) * math.exp(-1) + 1
    np.testing.assert_allclose(run.outputs.ravel(), [0, one, two], atol=1e-10)


def test_callable_input():
    # x' = -x + cos t from 1/2: x = (cos t + sin t)/2
    times = np.linspace(0, 10, 21)
    run = clpt.simulate(
        decaying(1.0), times, lambda t: [math.cos(t)], initial_state=[0.5], rtol=1e-11, atol=1e-13
    )
    np.testing.assert_allclose(run.outputs.ravel(), (np.cos(times) + np.sin(times)) / 2, atol=1e-9)
    np.testing.assert_allclose(run.inputs.ravel(), np.cos(times), rtol=1e-15)


def test_no_input_is_zero():
    run = clpt.simulate(decaying(), [0.0, 1.0], initial_state=[1.0], rtol=1e-11, atol=1e-13)
    assert run.outputs.ravel()[-1] == pytest.approx(math.exp(-2), abs=1e-10)


def test_inputs_that_do_not_fit():
    loop = clpt.closed_loop(PAPER, external=("zc",))
    with pytest.raises(SimulationError, match="inputs"):
        clpt.simulate(loop, [0, 1, 2], [1.0, 2.0, 3.0, 4.0])
    with pytest.raises(SimulationError, match=r"inputs: shape \(2, 2\) must be \(2, 3\)"):
        clpt.simulate(loop, [0, 1, 2], np.zeros((2, 2)))
    with pytest.raises(SimulationError, match="inputs: must be finite"):
        clpt.simulate(loop, [0, 1], [[0, np.nan], [0, 0]])
    with pytest.raises(ClptError, match="inputs"):
        clpt.simulate(loop, [0, 1], lambda t: [1.0, 2.0, 3.0])
    with pytest.raises(SimulationError, match="a scenario has no inputs"):
        clpt.simulate(PAPER, [0, 1], inputs=1.0)


def test_initial_state_that_does_not_fit():
    with pytest.raises(SimulationError, match="initial_state"):
        clpt.simulate(clpt.closed_loop(PAPER), [0, 1], initial_state=[1.0, 2.0, 3.0])
    with pytest.raises(SimulationError, match="initial_state"):
        clpt.simulate(PAPER, [0, 1], initial_state=[1.0, 2.0, 3.0])


# --- times of the samples ---------------------------------------------------------------------


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


@pytest.mark.parametrize("times", [[1.0], [0.0, 0.0], [1.0, 0.0], [0.0, np.nan], [0.0, np.inf]])
def test_times_that_cannot_be(times):
    for system in (PAPER, clpt.closed_loop(PAPER)):
        with pytest.raises(SimulationError, match="timepts"):
            clpt.simulate(system, times)


def test_a_diagram_needs_times():
    with pytest.raises(SimulationError, match="timepts: is required"):
        clpt.simulate(clpt.closed_loop(PAPER))


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
    run = clpt.simulate(loop, times)
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


def sums(t, x, u, p, dx):
    """s' = [delta, zc], section 2: u = delta[2], zc[2], state s[4]."""
    for i in range(4):
        dx[i] = u[i]


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


# --- how a run ended --------------------------------------------------------------------------


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


def test_response_is_python_controls_own():
    loop = clpt.closed_loop(CALM)
    run = clpt.simulate(loop, [0, 1, 2], initial_state=initial_state(CALM))
    assert isinstance(run, control.TimeResponseData)
    assert run.success
    assert list(run.output_labels) == loop.output_labels
    assert list(run.state_labels) == loop.state_labels
    assert run.outputs.shape == (loop.noutputs, 3)
    np.testing.assert_allclose(run.states[:2].T, exact_positions([0, 1, 2]), atol=1e-6)


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


# --- what cannot be computed ------------------------------------------------------------------


def test_infinite_parameter_is_named():
    loop = clpt.closed_loop(PAPER)
    with pytest.raises(SimulationError) as caught:
        clpt.simulate(loop, [5.0, 6.0], params={"true_flow.theta": np.full((2, 3), np.inf)})
    sentence = str(caught.value)
    assert "t = 5" in sentence
    assert "flow_x[0]" in sentence
    assert "true_flow" in sentence


def test_infinite_state_is_named():
    x0 = initial_state(PAPER)
    x0[1] = np.nan
    with pytest.raises(ScenarioError, match=r"vehicle\.position\[1\] = nan: must be a finite"):
        clpt.simulate(PAPER, [0, 1], initial_state=x0)
    for engine in ("native", "python"):
        with pytest.raises(SimulationError, match=r"t = 0.*x\[1\].*vehicle"):
            clpt.simulate(clpt.closed_loop(PAPER), [0, 1], initial_state=x0, engine=engine)


class Nothing(NamedTuple):
    pass


def blows_up(t, x, u, p, dx):
    """x' = x^2, section 2: x[1]."""
    dx[0] = x[0] ** 2


def leaves_its_range(t, x, u, p, y):
    """y = sqrt(1 - x), section 2: u = x[1], y = root[1]."""
    y[0] = math.sqrt(1 - u[0])


def grows(t, x, u, p, dx):
    """x' = 1, section 2: x[1]; u = root[1]."""
    dx[0] = 1.0 + 0.0 * u[0]


def test_blow_up_is_a_sentence():
    block = Block("burst", update=blows_up, states={"x": 1})
    loop = control.interconnect([block], outlist=["burst.x[0]"], outputs=["x"], connections=False)
    with pytest.raises(SimulationError, match=r"stopped at t = (0\.9|1)") as caught:
        clpt.simulate(loop, [0.0, 2.0], initial_state=[1.0])
    assert "\n" not in str(caught.value)


def test_signal_that_leaves_its_range_is_named():
    blocks = [
        Block("root", output=leaves_its_range, inputs={"x": 1}, outputs={"root": 1}),
        Block("line", update=grows, inputs={"root": 1}, states={"x": 1}),
    ]
    with pytest.raises(SimulationError, match=r"root\[0\] of block root is not finite"):
        clpt.simulate(connect(blocks), [0.0, 2.0], initial_state=[0.0])


def test_nan_input_of_a_callable_is_an_error():
    with pytest.raises(SimulationError, match="not finite"):
        clpt.simulate(decaying(), [0.0, 1.0], lambda t: [math.nan])


# --- guards of a gridded field ----------------------------------------------------------------


def drift(outside, u=1.0, v=0.0, end=10.0):
    """A vehicle that swims nowhere in a uniform current on x1 = -2 ... 2, x2 = -1 ... 1."""
    axes = [np.linspace(0, end, 5), np.linspace(-1, 1, 5), np.linspace(-2, 2, 9)]
    shape = tuple(len(axis) for axis in axes)
    grid = GriddedField(*axes, np.full(shape, u), np.full(shape, v))
    units = PAPER.units.model_copy(update={"length": "km", "time": "h"})
    return connect(
        [field.gridded_flow(grid, outside, units=units), vehicle.vehicle()], external=["v_x"]
    )


def test_leaving_raises_with_position_time_and_bounds():
    with pytest.raises(SimulationError) as caught:
        clpt.simulate(drift("raise"), np.linspace(0, 5, 11), initial_state=[0.0, 0.5])
    sentence = str(caught.value)
    for part in ("(2, 0.5) km", "time 2 h", "x1 -2 to 2", "x2 -1 to 1", "time 0 to 10"):
        assert part in sentence, (part, sentence)
    assert "clip" in sentence
    assert "stop" in sentence


def test_leaving_stops_where_it_leaves():
    run = clpt.simulate(drift("stop"), np.linspace(0, 5, 11), initial_state=[0.0, 0.5])
    assert run.time.tolist()[:-1] == pytest.approx([0, 0.5, 1, 1.5, 2][: len(run.time) - 1])
    assert run.time[-1] == pytest.approx(2.0, abs=1e-9)
    np.testing.assert_allclose(run.states[:, -1], [2.0, 0.5], atol=1e-8)
    assert "time 2 h" in run.message
    assert run.message.startswith("stopped")


def test_leaving_between_samples_is_kept():
    run = clpt.simulate(drift("stop"), [0.0, 1.0, 3.0], initial_state=[0.75, 0.5])
    np.testing.assert_allclose(run.time, [0.0, 1.0, 1.25], atol=1e-9)
    np.testing.assert_allclose(run.states[0], [0.75, 1.75, 2.0], atol=1e-8)


def test_clip_goes_on_with_the_flow_at_the_edge():
    run = clpt.simulate(drift("clip", v=-0.5), [0.0, 4.0, 20.0], initial_state=[0.0, 0.0])
    np.testing.assert_allclose(run.states[:, 1], [4.0, -2.0], atol=1e-8)
    np.testing.assert_allclose(run.states[:, 2], [20.0, -10.0], atol=1e-8)


def test_leaving_in_time():
    with pytest.raises(SimulationError, match=r"time 3 h; .*time 0 to 3 h"):
        clpt.simulate(drift("raise", u=0.1, end=3.0), [0.0, 5.0], initial_state=[0.0, 0.0])
    run = clpt.simulate(drift("stop", u=0.1, end=3.0), [0.0, 5.0], initial_state=[0.0, 0.0])
    np.testing.assert_allclose(run.time, [0.0, 3.0], atol=1e-9)


def test_ending_at_the_edge_is_inside():
    run = clpt.simulate(drift("raise"), [0.0, 2.0], initial_state=[0.0, 1.0])
    np.testing.assert_allclose(run.states[:, -1], [2.0, 1.0], atol=1e-9)


def test_starting_outside():
    with pytest.raises(SimulationError, match=r"\(3, 0\) km, time 0 h"):
        clpt.simulate(drift("raise"), [0.0, 1.0], initial_state=[3.0, 0.0])
    run = clpt.simulate(drift("stop"), [0.0, 1.0], initial_state=[3.0, 0.0])
    assert run.time.tolist() == [0.0]


@pytest.mark.parametrize("farthest", [4.04, 2.02])
def test_out_and_back_within_a_step_is_found(farthest):
    # x1 = a sin(pi t/10) against a current of 1: out at the first time where it is 2
    def velocity(t):
        return [-1.0 + farthest * math.pi / 10 * math.cos(math.pi * t / 10), 0.0]

    run = clpt.simulate(drift("stop"), [0.0, 9.9], velocity, initial_state=[0.0, 0.0])
    leaves = 10 / math.pi * math.asin(2 / farthest)
    assert run.time[-1] == pytest.approx(leaves, abs=1e-6)
    assert run.states[0, -1] == pytest.approx(2.0, abs=1e-8)


# --- python-control's own systems beside blocks -----------------------------------------------


@pytest.mark.filterwarnings("ignore:.*runs in Python, not as machine code")
def test_plain_systems_in_a_loop_with_blocks():
    """An oscillator: a Block's integrator, closed by two of python-control's own parts."""
    integrator = Block("speed", update=passes, inputs={"u": 1}, states={"s": 1})
    position = control.ss([[0.0]], [[1.0]], [[1.0]], [[0.0]], name="place")
    spring = control.nlsys(None, lambda t, x, u, params: -u, inputs=1, outputs=1, name="spring")
    loop = control.interconnect(
        [integrator, position, spring],
        connections=[
            ["place.u[0]", "speed.s[0]"],
            ["spring.u[0]", "place.y[0]"],
            ["speed.u[0]", "spring.y[0]"],
        ],
        outlist=["place.y[0]"],
        outputs=["x"],
        inputs=0,
        name="loop",
        check_unused=False,
    )
    times = np.linspace(0, 10, 21)
    run = clpt.simulate(loop, times, initial_state=[0.0, 1.0], rtol=1e-11, atol=1e-13)
    np.testing.assert_allclose(run.outputs.ravel(), np.cos(times), atol=1e-9)


def passes(t, x, u, p, dx):
    """s' = u, section 2: u[1], s[1]."""
    dx[0] = u[0]


@pytest.mark.filterwarnings("ignore:.*runs in Python, not as machine code")
def test_parameters_of_a_plain_system():
    lag = control.nlsys(
        lambda t, x, u, params: -params["k"] * x,
        None,
        inputs=1,
        outputs=1,
        states=1,
        name="lag",
        params={"k": 1.0},
    )
    block = Block("speed", update=passes, inputs={"u": 1}, states={"s": 1})
    loop = control.interconnect(
        [lag, block],
        connections=[["speed.u[0]", "lag.y[0]"]],
        outlist=["speed.s[0]"],
        outputs=["s"],
        inputs=0,
        name="loop",
        check_unused=False,
    )
    for k in (1.0, 3.0):
        run = clpt.simulate(
            loop, [0.0, 2.0], initial_state=[1.0, 0.0], params={"k": k}, rtol=1e-11, atol=1e-13
        )
        assert np.ravel(run.outputs)[-1] == pytest.approx((1 - math.exp(-2 * k)) / k, abs=1e-9)


@pytest.mark.filterwarnings("ignore:.*runs in Python, not as machine code")
def test_a_plain_system_alone():
    run = clpt.simulate(control.ss(-2, 1, 1, 0), [0.0, 1.0], 4.0, rtol=1e-11, atol=1e-13)
    assert np.ravel(run.outputs)[-1] == pytest.approx(2 - 2 * math.exp(-2), abs=1e-9)


# --- repeating a run --------------------------------------------------------------------------


def test_run_from_its_file_repeats_itself(tmp_path):
    scenario = PAPER.with_values(
        {
            "run.duration": 45.0,
            "run.output_step": 2.5,
            "flow.disturbance": {
                "kind": "noise",
                "amplitude": [0.1, 0.2],
                "period": 3.0,
                "seed": 4,
            },
        }
    )
    run = clpt.simulate(scenario)
    clpt.save_run(run, tmp_path / "run.nc")
    loaded = clpt.load_run(tmp_path / "run.nc")
    assert set(loaded.variables) == set(run.variables)
    for name in run.variables:
        np.testing.assert_array_equal(loaded[name], run[name])
        assert loaded[name].attrs == run[name].attrs
    again = clpt.simulate(clpt.load_scenario(tmp_path / "run.nc"))
    for name in run.variables:
        np.testing.assert_array_equal(again[name], run[name])
    assert loaded.attrs["status"] == "finished"


def test_what_is_no_run_is_an_error(tmp_path):
    (tmp_path / "text.nc").write_text("no netcdf")
    for path in ("text.nc", "none.nc"):
        with pytest.raises(DataError, match=path):
            clpt.load_run(tmp_path / path)


def test_runs_are_the_same_in_any_order():
    plain = PythonDiagram(clpt.closed_loop(CALM))
    x0 = initial_state(CALM)
    first = plain.run(x0, [0.0, 3.0]).x
    plain.run(x0 + 1.0, [1.0, 2.0])
    np.testing.assert_array_equal(plain.run(x0, [0.0, 3.0]).x, first)


def test_a_run_in_two_parts_is_the_run():
    loop, x0 = clpt.closed_loop(CALM), initial_state(CALM)
    whole = clpt.simulate(loop, [0.0, 1.0, 3.0], initial_state=x0, rtol=1e-11, atol=1e-13)
    part = clpt.simulate(loop, [0.0, 1.0], initial_state=x0, rtol=1e-11, atol=1e-13)
    rest = clpt.simulate(loop, [1.0, 3.0], initial_state=part.states[:, -1], rtol=1e-11, atol=1e-13)
    np.testing.assert_allclose(rest.states[:, -1], whole.states[:, -1], atol=1e-9)


def test_pickled_blocks_run_the_same():
    loop = clpt.closed_loop(CALM)
    for block in loop.syslist:
        twin = pickle.loads(pickle.dumps(block))
        assert twin.name == block.name
        assert twin.update_function is block.update_function
        assert twin.output_function in (block.output_function, states_as_outputs)
