"""Runs over kinks and switches, those too that time decides, against closed forms."""

import control
import numpy as np
import pytest
from drawn_scenarios import NUMBERS, drawn
from engine_runs import compile, run_many
from law_blocks import HELD
from scipy.optimize import brentq
from text_systems import written

import clpt_control as clpt

RTOL, ATOL = 1e-10, 1e-12
T = np.linspace(0.0, 10.0, 101)


def system(rates, n=1):
    """A system of what is written, or of a function."""
    if isinstance(rates, str):
        return written(rates)[0]
    return control.nlsys(rates, None, inputs=0, outputs=n, states=n, name="s")


def located(found):
    """Return a run whose switches were located: it is not the second try, which steps over them."""
    assert "switches not located" not in found.attrs["method"]
    return found


def run(rates, x0, t=T):
    found = located(
        clpt.simulate(system(rates, len(x0)), t, None, x0, rtol=RTOL, atol=ATOL)
    )
    assert found.attrs["engine"] == "native"
    return found


@pytest.mark.parametrize(("speed", "gain"), [(12.0, 3.6), (1.0, 1.0), (1e3, 1e3)])
def test_a_run_that_begins_on_a_kink_leaves_it(speed, gain):
    """a - b is 0 where the run begins, and rounded to 4e-16 as it leaves."""
    rates = f"a' = {speed}; b' = {-speed}; c' = maximum({gain}*(a - b), 0)"
    apart = system(f"{rates}; d' = minimum({gain}*(a - b)*c, 0)")
    found = located(clpt.simulate(apart, [0.0, 10.0], None, [2.0, 2.0, 0.0, 0.0]))
    assert found.attrs["solver_steps"] < 100
    last = [100 * gain * speed, 0.0]
    np.testing.assert_allclose(found.states[-1, 2:], last, rtol=1e-9, atol=1e-12)


def behind(t):
    """The driving side less half the gap, or what was reached last: 1.5, then -1.5 and so on."""
    # turns of the driving side so far
    wave, half = (2.0 * np.sin(t), (t - np.pi / 2) // np.pi)
    down, up = np.minimum(wave + 0.5, 1.5), np.maximum(wave - 0.5, -1.5 * (half > 0))
    return np.where(half % 2 == 0, down, up)


def bang(t):
    phase = t % 4.0
    second, third = (a - a**2 / 2 for a in (phase - 1, phase - 3))
    return np.where(phase < 1, 0.5 - phase**2 / 2, np.where(phase < 3, -second, third))


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


FORMS = {  # rates, what the last state is at t, and a start that is not 0
    "saturation": (
        "x' = clip(2 - x, -0.5, 0.5)",
        lambda t: np.where(t < 3, t / 2, 2 - np.exp(3 - t) / 2),
    ),
    "|sin t|": (
        "x' = abs(sin(t))",
        lambda t: 2 * np.floor(t / np.pi) + 1 - np.cos(t % np.pi),
    ),
    "bang-bang": ("v' = -1 if x > 0 else 1; x' = v", bang, [0.0, 0.5]),
    "backlash": (  # the driven side moves where the gap is used up and the driving one goes on
        "x' = 2*cos(t) if (2*sin(t) - x >= 0.5 and cos(t) > 0) or "
        "(2*sin(t) - x <= -0.5 and cos(t) < 0) else 0",
        behind,
    ),
    "floor": ("s' = 1; x' = floor(s)", whole),
    "mod": (
        "s' = 2; x' = mod(s, 1)",
        lambda t: (np.floor(2 * t) + (2 * t % 1.0) ** 2) / 4,
    ),
    "a heading": (  # the integral of a wrapped angle, w^2/4 of its rate 2
        "s' = 2; x' = arctan2(sin(s), cos(s))",
        lambda t: ((2 * t + np.pi) % (2 * np.pi) - np.pi) ** 2 / 4,
    ),
    "a triangle of time": ("x' = arcsin(sin(3*t))", triangle),
    "a triangle": ("s' = 3; x' = arcsin(sin(s))", triangle),
    "a triangle by acos": (  # acos(cos(a + pi/2)) = pi/2 + asin(sin a)
        "s' = 3; x' = arccos(cos(s + pi/2)) - pi/2",
        triangle,
    ),
    "a sawtooth": ("s' = 3; x' = arctan(tan(s))", sawtooth),
    "a pulse of time": (
        "x' = 1 if 5 < t < 5.05 else 0",
        lambda t: np.clip(t - 5.0, 0.0, 0.05),
    ),
    "maximum": (
        "s' = -s; x' = maximum(s, 0.5)",
        lambda t: np.where(t < LN2, 1 - np.exp(-t), 0.5 + (t - LN2) / 2),
        [1.0, 0.0],
    ),
}


def case_of(name):
    """The rates of a case, its start, and what its last state is."""
    rates, wanted, *start = FORMS[name]
    return rates, start[0] if start else [0.0] * rates.count("' ="), wanted


@pytest.mark.parametrize("case", FORMS)
def test_runs_over_kinks_are_as_their_closed_forms(case):
    rates, x0, wanted = case_of(case)
    np.testing.assert_allclose(
        run(rates, x0).states[:, -1], wanted(T), rtol=1e-9, atol=1e-9
    )


@pytest.mark.parametrize("rtol", [1e-6, 1e-8, 1e-10])
@pytest.mark.parametrize("edge", [0.9, 0.97, 0.99])
def test_what_goes_beyond_a_kink_and_back_within_a_step_is_seen(edge, rtol):
    """x = sin t is beyond the edge for less than a step, once in each of ten turns."""
    beyond, end = (
        system(f"x' = v; v' = -x; s' = maximum(x - {edge}, 0)"),
        [0.0, 20.0 * np.pi],
    )
    found = located(
        clpt.simulate(beyond, end, None, [0.0, 1.0, 0.0], rtol=rtol, atol=rtol / 100)
    )
    wide = np.arccos(edge)
    wanted = 20.0 * (np.sin(wide) - edge * wide)
    np.testing.assert_allclose(found.states[-1, 2], wanted, atol=10 * rtol)
    assert found.attrs["solver_restarts"] <= 21  # fewer where a kink has no effect


@pytest.mark.parametrize("width", [0.4, 0.01])
@pytest.mark.parametrize("ahead", [0.3, 0.001])
def test_a_pulse_soon_behind_a_kink_that_is_not_felt_is_met(ahead, width):
    """While s = sin(2 pi f t) falls, a step that nothing reads is passed before the pulse."""
    met = f"(sin(a) < 0*floor((sin(a) - {ahead})/3)) & (sin(a) > -{width})"
    turning = system(f"a' = 2*pi*7.9; x' = where({met}, 1.0, 0.2)")
    found = located(clpt.simulate(turning, [0.0, 10.0], None, 0.0))
    wanted = 2.0 + 8.0 * 2.0 * np.arcsin(width) / (2.0 * np.pi)
    np.testing.assert_allclose(found.states[-1, 1], wanted, rtol=1e-7)


@pytest.mark.parametrize(
    "case", ["saturation", "bang-bang", "maximum", "floor", "a heading"]
)
def test_neither_samples_nor_company_change_what_a_run_over_kinks_gives(case):
    rates, x0, _ = case_of(case)
    few, many = (
        run(rates, x0, [0.0, 10.0]),
        run(rates, x0, np.linspace(0.0, 10.0, 1001)),
    )
    np.testing.assert_allclose(few.states[-1], many.states[-1], rtol=1e-9, atol=1e-9)
    assert many.attrs["solver_steps"] == few.attrs["solver_steps"]
    runner, close = compile(system(rates)), {"rtol": RTOL, "atol": ATOL}
    starts = np.array([x0]) + np.linspace(0.0, 0.3, 11)[:, None]
    alone = [runner.run(start, T, **close).x for start in starts]
    np.testing.assert_allclose(
        run_many(runner, starts, T, RTOL), alone, rtol=1e-9, atol=1e-9
    )


def test_a_kink_takes_few_evaluations():
    assert run(FORMS["saturation"][0], [0.0]).attrs["solver_evaluations"] < 500


def test_a_heading_turns_at_the_back_alone():
    """x' = 1 + wrap(x)/10 grows as an exponential from -pi to pi, again and again."""
    turning = system("x' = 1 + arctan2(sin(x), cos(x))/10; y' = -z; z' = arctan2(y, 9)")

    def back(a):
        return 10.0 * np.log((1.0 + 0.1 * np.pi) / (1.0 + 0.1 * a))

    found = located(
        clpt.simulate(turning, [0.0, 40.0], None, [0.0, 0.1, 0.0], rtol=1e-8)
    )
    turns, rest = divmod(40.0 - back(0.0), back(-np.pi))
    wanted = 2.0 * np.pi * (turns + 1) - 10.0 + (10.0 - np.pi) * np.exp(0.1 * rest)
    np.testing.assert_allclose(found.states[-1, 0], wanted, rtol=1e-9)
    assert found.attrs["solver_evaluations"] < 2000


def test_rounding_is_no_kink():
    """Rounding alone decides who is larger."""
    found = run(
        "x' = minimum(y, y*(1 + 1e-16)) - x; y' = 0*y; z' = abs(0.3 - 0.1*3 + 0*z)",
        [0.0, 1.0, 0.0],
    )
    np.testing.assert_allclose(found.states[:, 0], 1.0 - np.exp(-T), atol=1e-9)
    assert found.attrs["solver_restarts"] < 5


@pytest.mark.sampled
@pytest.mark.parametrize(("seed", "which", "tight"), [(1, 3, 1.0), (2, 30, 1e-4)])
def test_a_kink_that_is_met_at_a_tangent_is_crossed(seed, which, tight):
    """Rates of the projection law turn along a ball: a step cut at the kink ends before it."""
    points = np.random.default_rng(seed).random((which + 1, NUMBERS))
    scenario = drawn("projection", points[which])
    loop, end = clpt.closed_loop(scenario), scenario.run.duration
    start, runner = clpt.initial_state(scenario), compile(loop)
    found = runner.run(start, [0.0, end], rtol=1e-8 * tight, atol=1e-10 * tight)
    assert found.statistics["steps"] < 5_000
    free = runner.in_form(locking=False).run(start, [0.0, end], rtol=1e-13, atol=1e-14)
    np.testing.assert_allclose(found.x[-1], free.x[-1], rtol=1e-7, atol=1e-7)


def test_a_kink_that_no_state_feels_is_not_looked_for():
    """As CLPE fades, rounding decides when the part that points outward changes its sign."""
    flow = np.array([[1.6364560402879789, 1.0247647578068995, -0.06970075676595029],
                     [-0.5937390761332392, 0.6756090018185217, 0.5399735459926727]])  # fmt: skip
    values = {"flow.parameters": flow, "learning.law": "projection", **HELD}
    run = located(clpt.simulate(clpt.paper_scenario().with_values(values)))
    assert run.attrs["solver_steps"] < 10_000
    np.testing.assert_allclose(run.flow_parameters_estimate.values[-1], flow, atol=1e-7)


@pytest.mark.parametrize("start", [86_400.0, 1e6, 1e8, 1.7e9])
def test_a_run_that_begins_late_finds_its_switches_as_one_from_zero(start):
    slows = system("x' = 1 if x < 1 else 0.25")
    run = located(
        clpt.simulate(slows, start + np.array([0.0, 0.3, 3.0]), rtol=1e-9, atol=1e-12)
    )
    assert abs(run.states[-1, 0] - 1.5) < 1e-14 * start
    follows = system("x' = v; v' = max(-0.3, min(0.3, r - x)) - 4*x - v; input r")
    times = np.arange(60.0)
    samples = np.convolve(
        np.random.default_rng(0).normal(size=60), np.ones(5) / 5, "same"
    )
    early, late = (
        clpt.simulate(follows, t, inputs=samples) for t in (times, start + times)
    )
    assert early.attrs["method"] == late.attrs["method"] == "DOP853"
    assert max(run.attrs["solver_restarts"] for run in (early, late)) < 20
    np.testing.assert_allclose(late.states, early.states, atol=1e-6)


# --- switches that time decides, or a phase that turns often: each is met -------------------------


@pytest.mark.parametrize("end", [0.1, 0.5])
@pytest.mark.parametrize("duty", [0.02, 0.3])
def test_a_converter_that_switches_thousands_of_times_meets_each_switch(duty, end):
    """x' = 1 for `duty` of each period of 50 us, samples at multiples of it: x = duty t."""
    pulses, times = (
        system(f"x' = 1 if t*20e3 % 1.0 < {duty} else 0"),
        np.linspace(0.0, end, 6),
    )
    found = located(clpt.simulate(pulses, times, None, 0.0))
    np.testing.assert_allclose(found.states[:, 0], duty * times, atol=5e-9)
    assert found.attrs["solver_restarts"] >= 2 * 20e3 * end - 2


CARRIERS = {  # of period 1, and the share of the time that they are above a level
    "sine": (
        lambda s: np.sin(2.0 * np.pi * s),
        lambda level: 0.5 - np.arcsin(level) / np.pi,
    ),
    "triangle": (
        lambda s: 2.0 * np.abs(2.0 * (s % 1.0) - 1.0) - 1.0,
        lambda b: 0.5 - 0.5 * b,
    ),
}


def compared(carrier, level, frequency=10.0):
    """A carrier in one block, compared in a second one, whose yes and no a third integrates."""
    own = {"inputs": 0, "outputs": "c", "params": {"frequency": frequency}}
    yes = {"inputs": "c", "outputs": "v", "name": "above"}
    return clpt.connect([
        control.nlsys(None, lambda t, x, u, p: carrier(p["frequency"] * t), name="carrier", **own),
        control.nlsys(None, lambda t, x, u, p: np.where(u > level, 1.0, 0.0), **yes),
        control.tf([1], [1, 0], inputs="v", outputs="y", name="y"),
    ])  # fmt: skip


@pytest.mark.parametrize("level", [0.0, 0.3, 0.9])
@pytest.mark.parametrize("carrier", CARRIERS)
def test_a_carrier_of_one_block_that_another_compares_meets_each_switch(carrier, level):
    wave, share = CARRIERS[carrier]
    found = located(clpt.simulate(compared(wave, level, 137.0), [0.0, 10.0]))
    np.testing.assert_allclose(found.y[-1], 10.0 * share(level), rtol=1e-9)


def test_members_whose_carriers_differ_switch_at_times_of_their_own():
    wave, share = CARRIERS["sine"]
    vary = {"carrier.frequency": [3.0, 10.0, 137.0]}
    found = clpt.run_ensemble(
        compared(wave, 0.3), vary, timepts=[0.0, 10.0], trajectories=True
    )
    np.testing.assert_allclose(found.y[:, -1], 10.0 * share(0.3), rtol=1e-9)


@pytest.mark.parametrize("level", [0.0, 0.3, 0.9, 0.999])
@pytest.mark.parametrize("frequency", [1.0, 10.0, 137.0])
def test_a_phase_that_turns_many_times_in_a_step_meets_each_switch(level, frequency):
    """No state has an error that would shorten a step: rates are constant between switches."""
    turning = system(f"a' = 2*pi*{frequency}; x' = 1 if sin(a) > {level} else 0")
    found = located(clpt.simulate(turning, [0.0, 10.0], None, 0.0))
    np.testing.assert_allclose(
        found.states[-1, 1], 10.0 * CARRIERS["sine"][1](level), rtol=1e-8
    )


SWINGS = [
    *(
        (frequency, engine)
        for frequency in (1.0, 10.0)
        for engine in ("native", "python")
    ),
    (137.0, "native"),
    pytest.param(137.0, "python", marks=pytest.mark.slow),
]


@pytest.mark.parametrize("level", [0.5, 0.9, 0.95])
@pytest.mark.parametrize(("frequency", "engine"), SWINGS)
def test_a_run_stops_where_a_swinging_output_first_reaches_a_level(
    frequency, level, engine
):
    """y = t/10 sin(2 pi f t), whose rates are constant: no error shortens a step."""

    def y(t):
        return 0.1 * t * np.sin(2.0 * np.pi * frequency * t)

    sizes = {"inputs": 0, "outputs": 1, "states": 2}
    rates = lambda t, x, u, p: [2.0 * np.pi * frequency, 0.1]  # noqa: E731
    spiral = control.nlsys(rates, lambda t, x, u, p: x[1] * np.sin(x[0]), **sizes)
    stop = {"stop": lambda t, y, u: level - y[0], "engine": engine}
    found = located(clpt.simulate(spiral, T, None, 0.0, rtol=1e-8, **stop))
    peaks = (
        np.arange(10 * frequency) + 0.25
    ) / frequency  # y is largest within 1e-4 of them
    reached = np.flatnonzero(y(peaks) > level)
    if not len(reached):
        assert found.attrs["status"] == "finished"
        return
    end = peaks[reached[0]]
    wanted = brentq(lambda t: y(t) - level, end - 0.25 / frequency, end)
    told = float(found.attrs["message"].split("t = ")[1])
    np.testing.assert_allclose(told, wanted, atol=1e-6)


ROWS = np.random.default_rng(3).normal(size=150)
TABLES = (  # samples of 0.1 s, held
    lambda t: ROWS[min(int(t / 0.1), 149)],
    lambda t: ROWS[int(t // 0.1)],
    lambda t: ROWS[np.searchsorted(0.1 * np.arange(150), t, side="right") - 1],
    lambda t: ROWS[(int(t / 0.1) + 1) - 1],
)


@pytest.mark.parametrize("held", TABLES)
def test_a_held_table_in_time_is_read_at_a_place_that_is_reckoned(held):
    table = system(lambda t, x, u, p: [held(t)], 1)
    found = located(clpt.simulate(table, np.linspace(0.0, 10.0, 11), None, 0.0))
    wanted = 0.1 * np.concatenate([[0.0], np.cumsum(ROWS)])[::10][:11]
    np.testing.assert_allclose(found.states[:, 0], wanted, atol=1e-9)
    assert found.attrs["engine"] == "native"


def test_pivots_of_linear_equations_are_no_switches():
    """A x' = b, with the other row on top in each half turn; no step ends at the change."""

    def rates(t, x, u, p):
        c, s = np.cos(3.0 * t), np.sin(3.0 * t)
        return np.linalg.solve(np.array([[c, -s], [s, c]]), [c - s, s + c])

    found = run(rates, [0.0, 0.0])
    np.testing.assert_allclose(found.states, np.transpose([T, T]), atol=1e-9)
    assert found.attrs["solver_restarts"] <= 1
