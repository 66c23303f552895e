"""Runs over kinks and switches, against closed forms."""

import itertools

import control
import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

import clpt_control as clpt
from clpt_control.errors import SimulationError
from clpt_control.native import python_diagram
from clpt_control.native.python_diagram import PythonDiagram
from clpt_control.theory import refuting

RTOL, ATOL = 1e-10, 1e-12
T = np.linspace(0.0, 10.0, 101)


def thermostat(t, x, u, p):
    """A relay with hysteresis, as it is at a sample: on below 19, off above 21."""
    return [1.0 if u[0] < 19.0 else 0.0 if u[0] > 21.0 else x[0]]


def test_a_relay_with_hysteresis_is_its_closed_form():
    """A room of 10 degrees outside, 20 more with the heating on, its relay sampled each 0.05."""
    relay = control.nlsys(thermostat, inputs="T", outputs="on", states=1, dt=0.05, name="relay")
    room = control.ss([[-1.0]], [[20.0]], [[1.0]], 0, inputs="on", outputs="heat", name="room")
    outside = control.nlsys(
        None, lambda t, x, u, p: u[0] + 10.0, inputs="heat", outputs="T", name="outside"
    )
    loop = clpt.connect([room, relay, outside])
    found = clpt.simulate(loop, 0.05 * np.arange(201), rtol=RTOL, atol=ATOL)
    heat, on, wanted = 0.0, 0.0, []
    for _ in range(201):
        wanted.append(heat)
        seen = heat + 10
        heat = 20 * on + (heat - 20 * on) * np.exp(-0.05)
        on = 1.0 if seen < 19 else 0.0 if seen > 21 else on  # what a sample says counts at the next
    assert found.attrs["engine"] == "native"
    np.testing.assert_allclose(found.heat, wanted, rtol=0, atol=1e-9)
    assert 3 < np.abs(np.diff(found.on.values)).sum() < 60


def system(f, n):
    return control.nlsys(f, None, inputs=0, outputs=n, states=n, name="s")


def run(f, x0, t=T):
    found = clpt.simulate(system(f, len(x0)), t, None, x0, rtol=RTOL, atol=ATOL)
    assert found.attrs["engine"] == "native"
    return found


def saturated(t, x, u, p):
    return [np.clip(2.0 - x[0], -0.5, 0.5)]


@pytest.mark.parametrize(("speed", "gain"), [(12.0, 3.6), (1.0, 1.0), (1e3, 1e3)])
def test_a_run_that_begins_on_a_kink_leaves_it(speed, gain):
    """x - z is 0 where the run begins, and rounded to 4e-16 as it leaves."""

    def apart(t, x, u, p):
        e = x[0] - x[1]
        return [speed, -speed, np.maximum(gain * e, 0.0), np.minimum(gain * e * x[2], 0.0)]

    found = clpt.simulate(system(apart, 4), [0.0, 10.0], None, [2.0, 2.0, 0.0, 0.0])
    assert found.attrs["solver_steps"] < 100
    last = found.states.values[-1]
    np.testing.assert_allclose(last[2:], [100 * gain * speed, 0.0], rtol=1e-9, atol=1e-12)


def dead_zone(t, x, u, p):
    e = x[0]
    return [-(e - 1.0) if e > 1.0 else -(e + 1.0) if e < -1.0 else 0.25 * np.cos(t) * 0.0]


def played(t, x, u, p):
    """Backlash: the driven side moves only where the gap is used up and the driving one goes on."""
    speed, gap = 2.0 * np.cos(t), 2.0 * np.sin(t) - x[0]
    pushed = (gap >= 0.5 and speed > 0) or (gap <= -0.5 and speed < 0)
    return [speed if pushed else 0.0]


def behind(t):
    """The driving side less half the gap, or what was reached last: 1.5, then -1.5 and so on."""
    wave, half = 2.0 * np.sin(t), (t - np.pi / 2) // np.pi  # turns of the driving side so far
    first = np.maximum(wave - 0.5, 0.0)
    down = np.minimum(wave + 0.5, 1.5)
    return np.where(half < 0, first, np.where(half % 2 == 0, down, np.maximum(wave - 0.5, -1.5)))


def geared(t, x, u, p):
    """A mass between springs, with a gap of 2: nothing acts on it within."""
    return [x[1], -4.0 * (x[0] - np.clip(x[0], -1.0, 1.0))]


def swung(t):
    """From rest at 2: a quarter of a swing, the gap at speed 2, half a swing, and back."""
    quarter, gap = np.pi / 4, 1.0
    t = t % (4 * quarter + 2 * gap)
    side, t = np.where(t < 2 * quarter + gap, 1.0, -1.0), t % (2 * quarter + gap)
    falls, far = 1 + np.cos(2 * t), -1 + np.sin(-2 * (t - quarter - gap))
    return side * np.where(
        t < quarter, falls, np.where(t < quarter + gap, 1 - 2 * (t - quarter), far)
    )


def bang(t):
    phase = t % 4.0
    first, second = 0.5 - phase**2 / 2, (phase - 1) ** 2 / 2 - (phase - 1)
    return np.where(
        phase < 1, first, np.where(phase < 3, second, (phase - 3) - (phase - 3) ** 2 / 2)
    )


def whole(t):
    k = np.floor(t)
    return k * (k - 1) / 2 + k * (t - k)


LN2 = np.log(2.0)
FORMS = {  # rates, start, which state, what it is at t
    "saturation": (saturated, [0.0], lambda t: np.where(t < 3, t / 2, 2 - np.exp(3 - t) / 2)),
    "|sin t|": (
        lambda t, x, u, p: [abs(np.sin(t))],
        [0.0],
        lambda t: 2 * np.floor(t / np.pi) + 1 - np.cos(t % np.pi),
    ),
    "bang-bang": (lambda t, x, u, p: [x[1], -1.0 if x[0] > 0 else 1.0], [0.5, 0.0], bang),
    "dead zone": (dead_zone, [3.0], lambda t: 1 + 2 * np.exp(-t)),
    "backlash": (played, [0.0], behind),
    "a gap between springs": (geared, [2.0, 0.0], swung),
    "floor": (lambda t, x, u, p: [1.0, np.floor(x[0])], [0.0, 0.0], whole, 1),
    "mod": (
        lambda t, x, u, p: [2.0, np.mod(x[0], 1.0)],
        [0.0, 0.0],
        lambda t: (np.floor(2 * t) + (2 * t % 1.0) ** 2) / 4,
        1,
    ),
    "a pulse of time": (
        lambda t, x, u, p: [1.0 if 5.0 < t < 5.05 else 0.0],
        [0.0],
        lambda t: np.clip(t - 5.0, 0.0, 0.05),
    ),
    "maximum": (
        lambda t, x, u, p: [-x[0], np.maximum(x[0], 0.5)],
        [1.0, 0.0],
        lambda t: np.where(t < LN2, 1 - np.exp(-t), 0.5 + (t - LN2) / 2),
        1,
    ),
    "minimum": (
        lambda t, x, u, p: [1.0, min(x[0], 3.0) ** 2],
        [0.0, 0.0],
        lambda t: np.where(t < 3, t**3 / 3, 9 + 9 * (t - 3)),
        1,
    ),
}


@pytest.mark.parametrize("case", FORMS)
def test_runs_over_kinks_are_as_their_closed_forms(case):
    f, x0, wanted, *which = FORMS[case]
    found = run(f, x0).states.values[:, which[0] if which else 0]
    np.testing.assert_allclose(found, wanted(T), rtol=1e-9, atol=1e-9)


@pytest.mark.parametrize("rtol", [1e-6, 1e-8, 1e-10])
@pytest.mark.parametrize("edge", [0.9, 0.97, 0.99])
def test_what_goes_beyond_a_kink_and_back_within_a_step_is_seen(edge, rtol):
    """x = sin t is beyond the edge for less than a step, once in each of ten turns."""

    def beyond(t, x, u, p):
        return [x[1], -x[0], np.maximum(x[0] - edge, 0.0)]

    end = [0.0, 20.0 * np.pi]
    found = clpt.simulate(system(beyond, 3), end, None, [0.0, 1.0, 0.0], rtol=rtol, atol=rtol / 100)
    wide = np.arccos(edge)
    wanted = 20.0 * (np.sin(wide) - edge * wide)
    np.testing.assert_allclose(found.states[-1, 2], wanted, atol=10 * rtol)
    assert found.attrs["solver_restarts"] == 21


@pytest.mark.parametrize("end", [0.1, 0.5])
@pytest.mark.parametrize("duty", [0.02, 0.3])
def test_a_converter_that_switches_thousands_of_times_meets_each_switch(duty, end):
    """x' = 1 for `duty` of each period of 50 us, samples at multiples of it: x = duty t."""
    pulses = system(lambda t, x, u, p: [1.0 if (t * 20e3) % 1.0 < duty else 0.0], 1)
    times = np.linspace(0.0, end, 6)
    found = clpt.simulate(pulses, times, None, 0.0)
    np.testing.assert_allclose(found.states[:, 0], duty * times, rtol=1e-9, atol=1e-12)
    assert found.attrs["solver_restarts"] >= 2 * 20e3 * end - 2


def test_switches_that_are_too_many_to_be_met_are_told():
    fast = system(lambda t, x, u, p: [-x[0] + (1.0 if np.sin(1e9 * t) > 0.9999 else 0.0)], 1)
    told = pytest.warns(UserWarning, match="time decides so often from t = 0 on that not every")
    with told, pytest.raises(SimulationError, match="switches to and fro"):
        clpt.simulate(fast, [0.0, 1000.0], None, 0.0)


CARRIERS = {  # of period 1, and the share of the time that they are above a level
    "sine": (lambda s: np.sin(2.0 * np.pi * s), lambda level: 0.5 - np.arcsin(level) / np.pi),
    "triangle": (lambda s: 2.0 * np.abs(2.0 * (s % 1.0) - 1.0) - 1.0, lambda b: 0.5 - 0.5 * b),
}


def compared(carrier, level, frequency=10.0):
    """A carrier in one block, compared in a second one, whose yes and no a third integrates."""
    made = control.nlsys(
        None,
        lambda t, x, u, params: carrier(params["frequency"] * t),
        inputs=0,
        outputs="c",
        name="carrier",
        params={"frequency": frequency},
    )
    above = control.nlsys(
        None,
        lambda t, x, u, p: np.where(u > level, 1.0, 0.0),
        inputs="c",
        outputs="v",
        name="above",
    )
    return clpt.connect([made, above, control.tf([1], [1, 0], inputs="v", outputs="y", name="y")])


@pytest.mark.parametrize("level", [0.0, 0.3, 0.9])
@pytest.mark.parametrize("carrier", CARRIERS)
def test_a_carrier_of_one_block_that_another_compares_meets_each_switch(carrier, level):
    wave, share = CARRIERS[carrier]
    found = clpt.simulate(compared(wave, level, 137.0), [0.0, 10.0])
    np.testing.assert_allclose(found.y[-1], 10.0 * share(level), rtol=1e-9)


def test_members_whose_carriers_differ_switch_at_times_of_their_own():
    wave, share = CARRIERS["sine"]
    vary = {"carrier.frequency": [3.0, 10.0, 137.0]}
    found = clpt.run_ensemble(compared(wave, 0.3), vary, timepts=[0.0, 10.0], trajectories=True)
    np.testing.assert_allclose(found.y[:, -1], 10.0 * share(0.3), rtol=1e-9)


@pytest.mark.parametrize("level", [0.0, 0.3, 0.9, 0.999])
@pytest.mark.parametrize("frequency", [1.0, 10.0, 137.0])
def test_a_phase_that_turns_many_times_in_a_step_meets_each_switch(level, frequency):
    """No state has an error that would shorten a step: rates are constant between switches."""

    def turning(t, x, u, p):
        return [2.0 * np.pi * frequency, 1.0 if np.sin(x[0]) > level else 0.0]

    found = clpt.simulate(system(turning, 2), [0.0, 10.0], None, 0.0)
    wanted = 10.0 * (0.5 - np.arcsin(level) / np.pi)
    np.testing.assert_allclose(found.states[-1, 1], wanted, rtol=1e-8)


@pytest.mark.parametrize("pulse", [0.4, 0.1, 0.02])
def test_a_kink_that_is_not_felt_may_make_another_one_felt(pulse):
    """While s = sin(2 pi f t) is within a pulse, and then alone, what is clipped leaves its end."""

    def rate(s):
        inside = np.logical_and(s > -0.7, s < pulse - 0.7)
        return np.clip(0.6 * s + np.where(inside, 0.87, -0.17), 0.43, 0.5)

    def turning(t, x, u, p):
        return [2.0 * np.pi * 13.8, rate(np.sin(x[0]))]

    found = clpt.simulate(system(turning, 2), [0.0, 10.0], None, 0.0)
    wanted = 10.0 * rate(np.sin(2.0 * np.pi * (np.arange(1e6) + 0.5) / 1e6)).mean()
    np.testing.assert_allclose(found.states[-1, 1], wanted, rtol=1e-6)


@pytest.mark.parametrize("width", [0.4, 0.05, 0.01])
@pytest.mark.parametrize("ahead", [0.3, 0.02, 0.001])
def test_a_pulse_soon_behind_a_kink_that_is_not_felt_is_met(ahead, width):
    """While s = sin(2 pi f t) falls, a step that nothing reads is passed before the pulse."""

    def rate(s):
        steps = np.floor((s - ahead) / 3.0)
        return np.where(np.logical_and(s < 0.0 * steps, s > -width), 1.0, 0.2)

    def turning(t, x, u, p):
        return [2.0 * np.pi * 7.9, rate(np.sin(x[0]))]

    found = clpt.simulate(system(turning, 2), [0.0, 10.0], None, 0.0)
    wanted = 2.0 + 8.0 * 2.0 * np.arcsin(width) / (2.0 * np.pi)
    np.testing.assert_allclose(found.states[-1, 1], wanted, rtol=1e-7)


@pytest.mark.parametrize("engine", ["native", "python"])
@pytest.mark.parametrize("level", [0.5, 0.9, 0.95])
@pytest.mark.parametrize("frequency", [1.0, 10.0, 137.0])
def test_a_run_stops_where_a_swinging_output_first_reaches_a_level(frequency, level, engine):
    """y = t/10 sin(2 pi f t), whose rates are constant: no error shortens a step."""

    def y(t):
        return 0.1 * t * np.sin(2.0 * np.pi * frequency * t)

    spiral = control.nlsys(
        lambda t, x, u, p: [2.0 * np.pi * frequency, 0.1],
        lambda t, x, u, p: x[1] * np.sin(x[0]),
        inputs=0,
        outputs=1,
        states=2,
        name="spiral",
    )
    found = clpt.simulate(
        spiral, T, None, 0.0, stop=lambda t, y, u: level - y[0], engine=engine, rtol=1e-8
    )
    peaks = (np.arange(10 * frequency) + 0.25) / frequency  # y is largest within 1e-4 of them
    reached = np.flatnonzero(y(peaks) > level)
    if not len(reached):
        assert found.attrs["status"] == "finished"
        return
    end = peaks[reached[0]]
    wanted = brentq(lambda t: y(t) - level, end - 0.25 / frequency, end)
    told = float(found.attrs["message"].split("t = ")[1])
    np.testing.assert_allclose(told, wanted, atol=1e-6)


ROWS = np.random.default_rng(3).normal(size=150)
HELD = (  # samples of 0.1 s, held
    lambda t: ROWS[min(int(t / 0.1), 149)],
    lambda t: ROWS[int(t // 0.1)],
    lambda t: ROWS[np.searchsorted(0.1 * np.arange(150), t, side="right") - 1],
    lambda t: ROWS[(int(t / 0.1) + 1) - 1],
)


@pytest.mark.parametrize("held", HELD)
def test_a_held_table_in_time_is_read_at_a_place_that_is_reckoned(held):
    table = system(lambda t, x, u, p: [held(t)], 1)
    found = clpt.simulate(table, np.linspace(0.0, 10.0, 11), None, 0.0)
    wanted = 0.1 * np.concatenate([[0.0], np.cumsum(ROWS)])[::10][:11]
    np.testing.assert_allclose(found.states[:, 0], wanted, atol=1e-9)
    assert found.attrs["engine"] == "native"


@pytest.mark.parametrize("case", ["saturation", "bang-bang", "maximum", "floor"])
def test_samples_do_not_change_what_a_run_over_kinks_gives(case):
    f, x0, *_ = FORMS[case]
    few, many = run(f, x0, [0.0, 10.0]), run(f, x0, np.linspace(0.0, 10.0, 1001))
    np.testing.assert_allclose(few.states[-1], many.states[-1], rtol=1e-9, atol=1e-9)
    assert many.attrs["solver_steps"] == few.attrs["solver_steps"]


def test_a_kink_takes_few_evaluations():
    assert run(saturated, [0.0]).attrs["solver_evaluations"] < 500


@pytest.mark.parametrize("case", ["saturation", "bang-bang", "floor"])
def test_runs_side_by_side_stop_at_their_own_kinks(case):
    f, x0, *_ = FORMS[case]
    runner = clpt.native.compile(system(f, len(x0)))
    starts = np.array([x0]) + np.linspace(0.0, 0.3, 11)[:, None]
    together = runner.run_many(starts, T, rtol=RTOL, atol=ATOL)
    for start, found in zip(starts, together, strict=True):
        alone = runner.run(start, T, rtol=RTOL, atol=ATOL).x
        np.testing.assert_allclose(found, alone, rtol=1e-9, atol=1e-9)


def sliding(t, x, u, p):
    return [-np.sign(x[0]) + 0.3 * np.sin(t)]


def test_a_switch_that_chatters_slides_at_loose_tolerances_and_is_said_at_tight_ones():
    """x' = -sign x + 0.3 sin t stays at 0 once it is there."""
    found = clpt.simulate(system(sliding, 1), T, None, [0.5], rtol=1e-2, atol=1e-2)
    assert np.all(np.abs(found.states.values[T > 1, 0]) < 1e-3)
    with pytest.raises(
        SimulationError, match=r"t = 0\.54.* `sign` in s.update switches to and fro"
    ):
        run(sliding, [0.5])


@pytest.mark.parametrize("rtol", [1e-1, 3e-3, 1e-6, 1e-12])
@pytest.mark.parametrize(
    ("f", "x0"),
    [(sliding, [0.5]), (lambda t, x, u, p: [x[1], -2.0 if x[0] + x[1] > 0 else 2.0], [1.0, 0.0])],
)
def test_a_sliding_mode_is_told_or_run_soon(f, x0, rtol, monkeypatch):
    batches, said, ended = [], "", python_diagram.ended
    monkeypatch.setattr(
        python_diagram, "ended", lambda s, batch, u: batches.append(batch) or ended(s, batch, u)
    )
    made = system(f, len(x0))
    try:
        found = clpt.simulate(made, T, None, x0, rtol=rtol, atol=1e-2 * rtol)
    except SimulationError as error:
        said = str(error)
    _, evaluations, *_ = batches[0].counts[0]
    assert evaluations < 20_000_000
    if said:
        assert "switches to and fro without going on; give the switch a hysteresis" in said
    else:
        assert np.all(np.abs(found.states.values[-1]) < rtol)


def test_a_switch_that_no_tolerance_ends_is_an_error():
    with pytest.raises(SimulationError, match="switches to and fro"):
        run(lambda t, x, u, p: [-1e6 * np.sign(x[0]) + np.sin(1e3 * t)], [0.5])


def test_with_a_boundary_layer_it_runs():
    found = run(lambda t, x, u, p: [-np.clip(x[0] / 0.01, -1.0, 1.0)], [0.5]).states.values[:, 0]
    np.testing.assert_allclose(found[T <= 0.4], 0.5 - T[T <= 0.4], atol=1e-9)
    assert abs(found[-1]) < 1e-9


def at_rest(t, x, u, p):  # rounding alone decides who is larger
    return [
        np.minimum(x[1], x[1] * (1.0 + 1e-16)) - x[0],
        0.0 * x[1],
        abs(0.3 - 0.1 * 3.0 + 0 * x[2]),
    ]


def test_rounding_is_no_kink():
    found = run(at_rest, [0.0, 1.0, 0.0])
    np.testing.assert_allclose(found.states.values[:, 0], 1.0 - np.exp(-T), atol=1e-9)
    assert found.attrs["solver_restarts"] < 5


@pytest.mark.parametrize(("seed", "which", "tight"), [(1, 3, 1.0), (2, 30, 1e-4)])
def test_a_kink_that_is_met_at_a_tangent_is_crossed(seed, which, tight):
    """Rates of the projection law turn along a ball: a step cut at the kink ends before it."""
    points = np.random.default_rng(seed).random((which + 1, refuting.NUMBERS))
    scenario = refuting.drawn("projection", points[which])
    loop, end = clpt.closed_loop(scenario), scenario.run.duration
    x = start = clpt.initial_state(scenario)
    runner = clpt.native.compile(loop)
    found = runner.run(start, [0.0, end], rtol=1e-8 * tight, atol=1e-10 * tight)
    assert found.statistics["steps"] < 5_000
    sweep = PythonDiagram(loop).sweep
    edges = [0.0, *(t for t in sweep.breakpoints(0.0, end) if t < end), end]
    for begin, until in itertools.pairwise(edges):
        sweep.enter(begin)
        x = solve_ivp(
            lambda t, x: sweep.rates(t, x), (begin, until), x, "DOP853", rtol=1e-12, atol=1e-14
        ).y[:, -1]
    np.testing.assert_allclose(found.x[-1], x, rtol=1e-7, atol=1e-7)


def test_a_kink_that_no_state_feels_is_not_looked_for():
    """As CLPE fades, rounding decides when the part that points outward changes its sign."""
    paper = clpt.paper_scenario()
    held = {"adapt_gains": False, "feedback": paper.vehicle.feedback, "feedforward": (1.0, 1.0)}
    flow = np.array([[1.6364560402879789, 1.0247647578068995, -0.06970075676595029],
                     [-0.5937390761332392, 0.6756090018185217, 0.5399735459926727]])  # fmt: skip
    keys = {f"learning.{key}": value for key, value in held.items()}
    run = clpt.simulate(
        paper.with_values({"flow.parameters": flow, "learning.law": "projection", **keys})
    )
    assert run.attrs["solver_steps"] < 10_000
    np.testing.assert_allclose(run.flow_parameters_estimate.values[-1], flow, atol=1e-7)


EMPTYING = {  # Torricelli: beyond the switch the rate has no value, or no slope
    "if": lambda t, x, u, p: [-p["k"] * np.sqrt(x[0])] if x[0] >= 0 else [0.0],
    "max": lambda t, x, u, p: [-p["k"] * np.sqrt(max(x[0], 0.0))],
    "sign": lambda t, x, u, p: [-p["k"] * np.sqrt(abs(x[0])) * np.sign(x[0])],
}


@pytest.mark.parametrize("name", EMPTYING)
def test_a_tank_that_runs_empty_stays_so(name):
    """x = (1 - k t/2)^2 until it is empty, one by one and in lanes."""
    tank = control.nlsys(
        EMPTYING[name], states=["x"], inputs=0, outputs=["x"], params={"k": 1.0}, name="tank"
    )
    times = np.linspace(0.0, 3.0, 31)
    right = np.maximum(1.0 - times / 2, 0.0) ** 2
    run = clpt.simulate(tank, times, initial_state=[1.0])
    assert run.attrs["engine"] == "native"
    np.testing.assert_allclose(run.x.values.ravel(), right, atol=1e-8)
    k = np.array([0.5, 1.0, 2.0, 3.0])
    many = clpt.run_ensemble(tank, {"k": k}, timepts=times, initial_state=[1.0])
    assert np.all(many.status == 1)
    np.testing.assert_allclose(many.x_final, np.maximum(1.0 - 1.5 * k, 0.0) ** 2, atol=1e-8)


def test_what_has_no_value_on_either_side_is_still_told():
    f = control.nlsys(
        lambda t, x, u, p: [np.log(x[0]) if x[0] > -1 else 0.0],
        states=["x"], inputs=0, outputs=0, name="falling",
    )  # fmt: skip
    with pytest.raises(SimulationError, match="derivative of x of block falling is not finite"):
        clpt.simulate(f, [0.0, 3.0], initial_state=[0.5])


def test_a_root_of_a_magnitude_that_begins_at_zero_goes_on():
    """Bouc and Wen's hysteresis at rest: |z|^0.5 has no value where the sign of z is held."""

    def rate(t, x, u, p):
        q, v, z = x
        slip = 0.6 * np.abs(v) * np.abs(z) ** 0.5 * z + 0.3 * v * np.abs(z) ** 1.5
        return [v, np.sin(t) - 0.2 * v - q - 0.5 * z, v - slip]

    system = control.nlsys(rate, None, inputs=0, outputs=3, states=["q", "v", "z"], name="bouc")
    times = np.linspace(0.0, 5.0, 51)
    run = clpt.simulate(system, times, None, [0.01, 0.0, 0.0])
    assert "switches not located" in run.attrs["method"]
    close = {"rtol": 1e-10, "atol": 1e-12}
    theirs = control.input_output_response(
        system, times, 0, [0.01, 0.0, 0.0], solve_ivp_kwargs=close
    )
    np.testing.assert_allclose(run.states.values, theirs.states.T, atol=1e-6)
    many = clpt.run_ensemble(system, {"q": [0.01]}, timepts=times, initial_state=[0.0, 0.0, 0.0])
    np.testing.assert_allclose(many.y_final.values[0], run.states.values[-1], atol=1e-7)
