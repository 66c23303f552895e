"""Runs over kinks and switches, against closed forms."""

import control
import numpy as np
import pytest

import clpt_control as clpt
from clpt_control.theory import refuting

RTOL, ATOL = 1e-10, 1e-12
T = np.linspace(0.0, 10.0, 101)


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


def sawtooth(t):
    """The integral of an angle that grows by 3 and comes back by pi."""
    return ((3 * t + np.pi / 2) % np.pi - np.pi / 2) ** 2 / 6


def triangle(t):
    """The integral of asin(sin 3t): of straight lines up and down between -pi/2 and pi/2."""
    n = np.floor(3 * t / np.pi + 0.5)
    inner, top = (3 * t - n * np.pi) ** 2 / 6, np.pi**2 / 24
    return np.where(n % 2 == 0, inner, 2 * top - inner)


FORMS = {  # rates, start, which state, what it is at t
    "saturation": (saturated, [0.0], lambda t: np.where(t < 3, t / 2, 2 - np.exp(3 - t) / 2)),
    "|sin t|": (
        lambda t, x, u, p: [abs(np.sin(t))],
        [0.0],
        lambda t: 2 * np.floor(t / np.pi) + 1 - np.cos(t % np.pi),
    ),
    "bang-bang": (lambda t, x, u, p: [x[1], -1.0 if x[0] > 0 else 1.0], [0.5, 0.0], bang),
    "backlash": (played, [0.0], behind),
    "floor": (lambda t, x, u, p: [1.0, np.floor(x[0])], [0.0, 0.0], whole, 1),
    "mod": (
        lambda t, x, u, p: [2.0, np.mod(x[0], 1.0)],
        [0.0, 0.0],
        lambda t: (np.floor(2 * t) + (2 * t % 1.0) ** 2) / 4,
        1,
    ),
    "a heading": (  # the integral of a wrapped angle, w^2/4 of its rate 2
        lambda t, x, u, p: [2.0, np.arctan2(np.sin(x[0]), np.cos(x[0]))],
        [0.0, 0.0],
        lambda t: ((2 * t + np.pi) % (2 * np.pi) - np.pi) ** 2 / 4,
        1,
    ),
    "a triangle of time": (lambda t, x, u, p: [np.arcsin(np.sin(3 * t))], [0.0], triangle),
    "a triangle": (lambda t, x, u, p: [3.0, np.arcsin(np.sin(x[0]))], [0.0, 0.0], triangle, 1),
    "a triangle by acos": (  # acos(cos(a + pi/2)) = pi/2 + asin(sin a)
        lambda t, x, u, p: [3.0, np.pi / 2 - np.arccos(np.cos(x[0] + np.pi / 2))],
        [0.0, 0.0],
        lambda t: -triangle(t),
        1,
    ),
    "a sawtooth": (lambda t, x, u, p: [3.0, np.arctan(np.tan(x[0]))], [0.0, 0.0], sawtooth, 1),
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


@pytest.mark.parametrize("width", [0.4, 0.01])
@pytest.mark.parametrize("ahead", [0.3, 0.001])
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


@pytest.mark.parametrize("case", ["saturation", "bang-bang", "maximum", "floor", "a heading"])
def test_neither_samples_nor_company_change_what_a_run_over_kinks_gives(case):
    f, x0, *_ = FORMS[case]
    few, many = run(f, x0, [0.0, 10.0]), run(f, x0, np.linspace(0.0, 10.0, 1001))
    np.testing.assert_allclose(few.states[-1], many.states[-1], rtol=1e-9, atol=1e-9)
    assert many.attrs["solver_steps"] == few.attrs["solver_steps"]
    runner, close = clpt.native.compile(system(f, len(x0))), {"rtol": RTOL, "atol": ATOL}
    starts = np.array([x0]) + np.linspace(0.0, 0.3, 11)[:, None]
    for start, found in zip(starts, runner.run_many(starts, T, **close), strict=True):
        alone = runner.run(start, T, **close).x
        np.testing.assert_allclose(found, alone, rtol=1e-9, atol=1e-9)


def test_a_kink_takes_few_evaluations():
    assert run(saturated, [0.0]).attrs["solver_evaluations"] < 500


def test_a_heading_turns_at_the_back_alone():
    """x' = 1 + wrap(x)/10 grows as an exponential from -pi to pi, again and again."""

    def turning(t, x, u, p):
        return [1.0 + 0.1 * np.arctan2(np.sin(x[0]), np.cos(x[0])), -x[2], np.arctan2(x[1], 9.0)]

    def back(a):
        return 10.0 * np.log((1.0 + 0.1 * np.pi) / (1.0 + 0.1 * a))

    found = clpt.simulate(system(turning, 3), [0.0, 40.0], None, [0.0, 0.1, 0.0], rtol=1e-8)
    turns, rest = divmod(40.0 - back(0.0), back(-np.pi))
    wanted = 2.0 * np.pi * (turns + 1) - 10.0 + (10.0 - np.pi) * np.exp(0.1 * rest)
    np.testing.assert_allclose(found.states[-1, 0], wanted, rtol=1e-9)
    assert found.attrs["solver_evaluations"] < 2000


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
    start, runner = clpt.initial_state(scenario), clpt.native.compile(loop)
    found = runner.run(start, [0.0, end], rtol=1e-8 * tight, atol=1e-10 * tight)
    assert found.statistics["steps"] < 5_000
    free = runner.unlocked().run(start, [0.0, end], rtol=1e-13, atol=1e-14)
    np.testing.assert_allclose(found.x[-1], free.x[-1], rtol=1e-7, atol=1e-7)


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


@pytest.mark.parametrize("start", [86_400.0, 1e6, 1e8, 1.7e9])
def test_a_run_that_begins_late_finds_its_switches_as_one_from_zero(start):
    slows = control.nlsys(
        lambda t, x, u, p: [1.0 if x[0] < 1 else 0.25], None, inputs=0, states=1, outputs=1
    )
    run = clpt.simulate(slows, start + np.array([0.0, 0.3, 3.0]), rtol=1e-9, atol=1e-12)
    assert abs(run["y"].values[-1] - 1.5) < 1e-14 * start

    def follows(t, x, u, p):
        return [x[1], max(-0.3, min(0.3, u[0] - x[0])) - 4 * x[0] - x[1]]

    system = control.nlsys(follows, None, inputs=1, states=2, outputs=2)
    times = np.arange(60.0)
    samples = np.convolve(np.random.default_rng(0).normal(size=60), np.ones(5) / 5, "same")
    early, late = (clpt.simulate(system, t, inputs=samples) for t in (times, start + times))
    assert early.attrs["method"] == late.attrs["method"] == "DOP853"
    assert late.attrs["solver_restarts"] == early.attrs["solver_restarts"] > 10
    np.testing.assert_allclose(late["y"], early["y"], atol=1e-6)
