"""Taylor series: smooth runs against closed forms, SciPy and DOP853; what has none is refused."""

from itertools import pairwise
from math import factorial

import control
import numpy as np
import pytest
from engine_runs import NativeDiagram
from refusals import refuses
from scipy.integrate import quad, solve_ivp

import clpt_control as clpt

SERIES = {"method": "taylor"}


def system(rates, states=1, inputs=0, **params):
    return control.nlsys(
        rates, None, states=states, inputs=inputs, params=params, name="smooth"
    )


def of_state(rate):
    return system(lambda t, x, u, p: [rate(x[0])])


def of_time(rate):
    return system(lambda t, x, u, p: [rate(t)])


def end(diagram, start, times, inputs=None, **given):
    run = clpt.simulate(diagram, times, inputs, start, **SERIES, **given)
    return run.states.values[-1], run.attrs["method"]


# --- every operation ---------------------------------------------------------------------------

FUNCTIONS = [
    *(np.exp, np.expm1, np.log, np.log1p, np.log2, np.log10, np.sqrt, np.tanh),
    *(np.sin, np.cos, np.tan, np.arctan, np.arcsin, np.arccos, np.arcsinh),
    *(np.sinh, np.cosh, np.arctanh, np.square, np.reciprocal),
    lambda a: np.arccosh(1.0 + a),
    lambda a: np.hypot(a, 0.3),
    lambda a: a**-1.5 + a**0.7 + a**9 + a**11.3,
    lambda a: (0.3 + a) ** a / (1.0 + a**2),
]


@pytest.mark.parametrize("function", FUNCTIONS)
def test_each_function_has_its_series(function):
    def rates(t, x, u, p):
        inner = 0.4 + 0.2 * np.cos(2.0 * t) + 0.1 * np.sin(x[1])
        return [function(inner) - x[0], x[0] - 0.5 * x[1]]

    tight = {"method": "DOP853", "rtol": 1e-12, "atol": 1e-13}
    exact = solve_ivp(lambda t, x: rates(t, x, None, None), (0, 5), [0.3, 0.2], **tight)
    found, method = end(system(rates, 2), [0.3, 0.2], [0.0, 5.0])
    assert method == "Taylor 13"
    np.testing.assert_allclose(found, exact.y[:, -1], rtol=1e-8, atol=1e-8)


# --- traps -------------------------------------------------------------------------------------

RUNS = {  # rate, start, end, value there, error
    "flat at the start": (of_time(lambda t: t**16.0), 0.0, 1.5, 1.5**17 / 17, 1e-9),
    "flat for long": (of_time(lambda t: t**30.0), 0.0, 1.5, 1.5**31 / 31, 1e-6),
    "a pulse": (
        of_time(lambda t: np.exp(-(((t - 5.0) / 0.05) ** 2))),
        *(0.0, 10.0, 0.05 * np.sqrt(np.pi), 1e-9),
    ),
    "a fast sine": (
        of_time(lambda t: np.sin(50 * t)),
        *(0.0, 3.0, (1 - np.cos(150.0)) / 50, 1e-9),
    ),
    "near a pole": (of_state(lambda x: x * x), 1.0, 0.9, 10.0, 1e-6),
    "a root": (of_state(lambda x: -np.sqrt(x)), 1.0, 1.9, 0.0025, 1e-9),
    "a power": (of_state(lambda x: -(x**1.5)), 1.0, 10.0, 1 / 36.0, 1e-9),
    "slow": (of_state(lambda x: -1e-18 * x), 1.0, 2e18, np.exp(-2.0), 1e-9),
    "quick": (of_state(lambda x: -1e18 * x), 1.0, 2e-18, np.exp(-2.0), 1e-9),
    "gone": (of_state(lambda x: -x), 1.0, 1000.0, 0.0, 1e-9),
    "at rest": (of_state(lambda x: 0.0 * x), 3.0, 10.0, 3.0, 0.0),
    "a constant rate": (of_state(lambda x: 1.0 + 0.0 * x), 3.0, 10.0, 13.0, 1e-13),
}


@pytest.mark.parametrize("name", RUNS)
def test_traps(name):
    diagram, start, last, expected, error = RUNS[name]
    found, method = end(diagram, [start], [0.0, last])
    assert abs(found[0] - expected) <= error
    assert method == "Taylor 13"


def test_a_late_start_and_a_quick_state():
    rate = of_time(lambda t: 1e6 * np.cos(1e6 * t))
    found, _ = end(rate, [np.sin(1e6)], [1.0, 1.0 + 1e-5])
    assert found[0] == pytest.approx(np.sin(1e6 + 10.0), abs=1e-7)


# --- what ends a series ------------------------------------------------------------------------


def test_a_root_that_begins_at_zero_is_that_of_dop853():
    root = system(lambda t, x, u, p: [1.0 + 0.0 * x[0], np.sqrt(x[0])], 2)
    found, method = end(root, [0.0, 0.0], [0.0, 1.0])
    assert method == "Taylor 13, from t = 0 DOP853"
    assert found[1] == pytest.approx(2.0 / 3.0, rel=1e-6)


def test_a_stiff_run_goes_on_with_other_methods():
    stiff = system(lambda t, x, u, p: [-1e7 * (x[0] - np.cos(t))])
    times = np.linspace(0.0, 10.0, 11)
    run = clpt.simulate(stiff, times, initial_state=[0.0], **SERIES)
    assert "DOP853, from t" in run.attrs["method"]
    expected = (1e14 * np.cos(times) + 1e7 * np.sin(times)) / (1e14 + 1)
    np.testing.assert_allclose(run.states[1:, 0], expected[1:], atol=1e-7)


def test_a_pole_is_the_error_of_dop853():
    diagram = of_state(lambda x: x * x)
    said = "stopped at t = (1|0.99999)"
    refuses(said, end, diagram, [1.0], [0.0, 2.0], error=clpt.SimulationError)


# --- refusals ----------------------------------------------------------------------------------


def many(t, x, u, p):
    return [np.sin(np.roll(x, k) @ x) * np.exp(np.cos(x[k])) for k in range(len(x))]


REFUSED = {
    "conditions or kinks": of_state(lambda x: 1.0 - np.abs(x - 1.0)),
    "conditions": of_state(lambda x: -1.0 if x > 0.5 else -0.5),
    "kinks": of_state(lambda x: np.minimum(x, 0.5)),
    "more than 15000 operations": system(many, 24),
    "degree 600": of_state(lambda x: (x * x * x) ** 144 * (1.0 - x) ** 168),
    "degree 500": of_time(lambda t: np.cos(t) ** 500),
    "discrete time": control.ss([[0.5]], [[1.0]], [[1.0]], 0, dt=1.0),
}


@pytest.mark.parametrize("why", REFUSED)
def test_what_has_no_series_is_refused(why):
    diagram = REFUSED[why]
    start = [0.1] * diagram.nstates
    run = (clpt.simulate, diagram, [0.0, 1.0], 0.0 if diagram.ninputs else None, start)
    refuses(f"{why}|{why}", *run, **SERIES, error=clpt.SimulationError)


def test_sampled_blocks_are_refused():
    law = clpt.Block(
        "law", output=lambda t, x, u, p: -u.y, inputs={"y": 1}, outputs={"u": 1}
    )
    plant = control.ss(
        [[-1.0]], [[1.0]], [[1.0]], 0, inputs="u", outputs="y", name="plant"
    )
    loop = clpt.connect([plant, clpt.Sampled(law, 0.1)])
    run = (clpt.simulate, loop, [0.0, 1.0])
    refuses("sample", *run, **SERIES, error=clpt.SimulationError)


# --- samples, inputs, steps --------------------------------------------------------------------


def test_samples_within_steps_are_exact():
    times = np.sort(np.random.default_rng(3).uniform(0.0, 20.0, 400))
    turn = system(lambda t, x, u, p: [x[1], -x[0]], 2)
    run = clpt.simulate(
        turn, times, initial_state=[np.sin(times[0]), np.cos(times[0])], **SERIES
    )
    np.testing.assert_allclose(run.states[:, 0], np.sin(times), atol=1e-9)
    assert run.solver_steps < 40
    short = clpt.simulate(
        turn, [0.0, 20.0], initial_state=[0, 1], max_step=0.1, **SERIES
    )
    assert short.solver_steps >= 200


@pytest.mark.parametrize("scale", [1e-9, 1.0, 1e9])
def test_inputs_are_segments_of_time(scale):
    times = np.array([0.0, 1.0, 1.0, 1.7, 3.0, 3.2, 5.0]) * scale
    u = np.array([[0.0, 1.0, -2.0, 0.5, 0.5, 3.0, 0.0]])
    lag = system(lambda t, x, u, p: [(u[0] - x[0]) / scale], inputs=1)
    run = clpt.simulate(lag, times, u, [0.3], **SERIES)
    x, expected = 0.3, [0.3]
    for (t0, u0), (t1, u1) in pairwise(zip(times / scale, u[0], strict=True)):
        if t1 > t0:  # x = line - slope + c exp(-t)
            slope = (u1 - u0) / (t1 - t0)
            x = u1 - slope + (x - u0 + slope) * np.exp(t0 - t1)
            expected.append(x)
    np.testing.assert_allclose(run.states[:, 0], expected, atol=1e-9)
    assert run.solver_restarts >= 5


@pytest.mark.parametrize(
    ("count", "given"),
    [
        (1000, {}),
        (20_000, {"max_step": 10.0}),
        (20_001, {}),
        (25_000, {"max_step": 0.7}),
    ],
)  # a call of machine code ends after 20,000 tries
def test_many_short_segments_are_sums_of_trapezoids(count, given):
    times = np.arange(count + 1.0)
    u = np.random.default_rng(1).standard_normal(count + 1)
    exact = np.append(0.0, np.cumsum(0.5 * (u[1:] + u[:-1])))
    run = clpt.simulate(
        system(lambda t, x, u, p: [u[0]], 1, 1), times, u, **SERIES, **given
    )
    assert run.attrs["method"] == "Taylor 13"
    np.testing.assert_allclose(run.states[:, 0], exact, atol=1e-7)


def test_parameters_count_and_runs_repeat():
    decay = system(
        lambda t, x, u, p: [-(p["k"] ** 1.1) / (1 + p["c"]) * x[0]], k=1.0, c=0
    )
    for k in (1.0, 2.0, 1.0):
        found, _ = end(decay, [1.0], [0.0, 2.0], params={"k": k, "c": 1.0})
        assert found[0] == pytest.approx(np.exp(-(k**1.1)), rel=1e-8)


def test_long_orbits_stay_exact():
    def orbit(t, x, u, p):
        cube = (x[0] ** 2 + x[1] ** 2) ** -1.5
        return [x[2], x[3], -x[0] * cube, -x[1] * cube]

    last, e = 2000.0, 0.6
    anomaly = last
    for _ in range(50):  # Kepler's equation
        anomaly -= (anomaly - e * np.sin(anomaly) - last) / (1 - e * np.cos(anomaly))
    tight = {"rtol": 1e-15, "atol": 1e-16}
    found, method = end(system(orbit, 4), [0.4, 0, 0, 2.0], [0.0, last], **tight)
    expected = np.cos(anomaly) - e, np.sqrt(1 - e * e) * np.sin(anomaly)
    np.testing.assert_allclose(found[:2], expected, atol=1e-9)
    assert method == "Taylor 19"


@pytest.mark.long
def test_loops_are_unrolled_and_progress_is_told():
    chain = clpt.Block(
        "chain",
        update=lambda t, x, u, p: {"q": x.v, "v": -x.q},
        states={"q": 9, "v": 9},
    )
    told = []
    run = clpt.simulate(
        chain, [0.0, 40.0], initial_state=[1.0] * 9 + [0.0] * 9, **SERIES, max_step=1e-3,
        progress=told.append,
    )  # fmt: skip
    np.testing.assert_allclose(run.states[-1, :9], np.cos(40.0), atol=1e-8)
    assert told


# --- ensembles and derivatives -----------------------------------------------------------------


def lorenz(t, x, u, p):
    return [
        10.0 * (x[1] - x[0]),
        x[0] * (28.0 - x[2]) - x[1],
        x[0] * x[1] - p["b"] * x[2],
    ]


def test_members_in_lanes_are_the_runs_one_by_one():
    model = system(lorenz, ["a", "b", "c"], b=8.0 / 3.0)
    first = np.linspace(0.5, 1.5, 21)
    given = {"timepts": [0.0, 0.4, 2.0], "initial_state": [1.0, 1.0, 1.0], **SERIES}
    data = clpt.run_ensemble(model, {"a": first.tolist()}, **given)
    for k, x0 in enumerate(first):
        alone = clpt.simulate(model, [0.0, 0.4, 2.0], None, [x0, 1.0, 1.0], **SERIES)
        assert float(data.a_final[k]) == float(alone.states[-1, 0])


def test_members_with_inputs_wait_for_each_other_at_corners():
    lag = system(lambda t, x, u, p: [u[0] - p["k"] * x[0]], ["a"], 1, k=1.0)
    times, inputs = np.arange(5.0), [[0.0, 3.0, -1.0, 2.0, 2.0]]
    rates = np.linspace(0.1, 3.0, 8)
    given = {"inputs": inputs, "initial_state": [0.0], **SERIES}
    data = clpt.run_ensemble(lag, {"k": rates.tolist()}, timepts=times, **given)
    for k, found in zip(rates, data.a_final.values, strict=True):
        alone = clpt.simulate(lag, times, params={"k": k}, **given)
        assert float(found) == float(alone.states[-1, 0])


@pytest.mark.filterwarnings("ignore")
def test_members_whose_series_ends_are_those_of_dop853():
    blow = system(lambda t, x, u, p: [p["k"] * x[0] ** 2], ["a"], k=1.0)
    data = clpt.run_ensemble(
        blow, {"k": [0.5, 0.9, 1.1, 2.0] * 3}, timepts=[0.0, 1.0], initial_state=[1.0], **SERIES
    )  # fmt: skip
    finished = data.status.values == 1
    np.testing.assert_array_equal(finished, [True, True, False, False] * 3)
    np.testing.assert_allclose(data.a_final[finished], [2.0, 10.0] * 3, rtol=1e-6)


def test_sensitivities_by_series():
    decay = system(lambda t, x, u, p: [-p["k"] * x[0]], k=1.5)
    run = clpt.sensitivity(decay, [0.0, 1.0], to="k", initial_state=[1.0], **SERIES)
    native = NativeDiagram(decay)
    assert native.run([1.0], [0.0, 1.0], **SERIES).method == "Taylor 13"
    assert any(
        np.allclose(values.values[-1], -np.exp(-1.5), rtol=1e-7)
        for values in run.data_vars.values()
        if values.ndim and values.shape[0] == 2
    )


def turned(t, x):
    """A point that turns with its distance from 0 as speed: x' = |x| J x."""
    r = np.hypot(*x)
    turn = np.array([[np.cos(r * t), -np.sin(r * t)], [np.sin(r * t), np.cos(r * t)]])
    quarter = np.array([[0.0, -1.0], [1.0, 0.0]])
    return turn + t * quarter @ turn @ np.outer(x, x) / r


# rates of x and p = 1.3; derivative by the start 0.6, and by p
SLOPES = {
    "root": (
        lambda x, p: -p * np.sqrt(x),
        lambda t, a, p: (1.0 - 0.5 * p * t / np.sqrt(a), 0.5 * p * t**2 - t * np.sqrt(a)),
    ),
    "logarithm": (
        lambda x, p: -p * x * np.log(x),
        lambda t, a, p: (
            a ** np.exp(-p * t) * np.exp(-p * t) / a,
            -t * np.log(a) * np.exp(-p * t) * a ** np.exp(-p * t),
        ),
    ),
    "power": (
        lambda x, p: -p * x**1.5,
        lambda t, a, p: (
            (1.0 + 0.5 * p * t * a**0.5) ** -3,
            -t * (a**-0.5 + 0.5 * p * t) ** -3,
        ),
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", SLOPES)
def test_sensitivities_of_roots_by_series(name):
    rate, right = SLOPES[name]
    model = system(lambda t, x, u, p: [rate(x[0], p["p"])], p=1.3)
    found = clpt.sensitivity(
        model, [0.0, 0.8], "states", ["x0", "p"], None, [0.6], **SERIES
    )
    assert found.attrs["method"] == "Taylor 13"
    np.testing.assert_allclose(
        np.ravel(found.states.values[-1]), right(0.8, 0.6, 1.3), rtol=1e-6
    )


@pytest.mark.long
@pytest.mark.parametrize(
    "norm", [np.linalg.norm, lambda x: np.hypot(x[0], x[1]), lambda x: (x @ x) ** 0.5]
)
def test_sensitivities_of_norms_by_series(norm):
    def rates(t, x, u, p):
        r = norm(x[:2])
        return [-r * x[1], r * x[0], 0.0 * x[2]]

    start = [0.8, -0.5]
    found = clpt.sensitivity(
        system(rates, 3), [0.0, 3.0], "states", "x0", None, [*start, 1.0], **SERIES
    )
    assert found.attrs["method"] == "Taylor 13"
    slopes = found.states.values[-1, :2, :2]
    np.testing.assert_allclose(slopes, turned(3.0, np.array(start)), atol=1e-6)


@pytest.mark.long
def test_orbits_in_space_have_series():
    """Kepler's motion keeps the derivatives of energy and angular momentum by the start."""

    def rates(t, x, u, p):
        return np.concatenate([x[3:], -x[:3] / np.linalg.norm(x[:3]) ** 3])

    start = np.array([1.0, 0.0, 0.2, 0.0, 1.0, 0.3])
    orbit = system(rates, 6)
    found = clpt.sensitivity(orbit, [0.0, 7.0], "states", "x0", None, start, **SERIES)
    assert found.attrs["method"] == "Taylor 13"
    end_state = clpt.simulate(orbit, [0.0, 7.0], None, start, rtol=1e-12).states[-1]

    def slopes_of_invariants(x):
        r, v = x[:3], x[3:]
        energy = np.concatenate([r / np.linalg.norm(r) ** 3, v])
        momentum = [np.concatenate([np.cross(v, a), np.cross(a, r)]) for a in np.eye(3)]
        return np.array([energy, *momentum])

    kept = slopes_of_invariants(end_state.values) @ found.states.values[-1]
    np.testing.assert_allclose(kept, slopes_of_invariants(start), atol=1e-5)


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("last", [1e300, 1e308])
def test_times_as_large_as_numbers_make_no_warning(last):
    """exp(t) is the largest number at its logarithm."""
    said = refuses(
        "state .* is not finite", end, of_state(lambda x: x), [1.0], [0.0, last],
        error=clpt.SimulationError,
    )  # fmt: skip
    reached = float(said.partition("t = ")[2].partition(":")[0])
    assert reached == pytest.approx(np.log(np.finfo(float).max), rel=1e-6)


# --- what a step must not leap over --------------------------------------------------------------


def of_ramp(rate):
    return system(lambda t, x, u, p: [rate(u[0])], inputs=1)


def of_clock(rate, before=1.0):
    return system(lambda t, x, u, p: [before + 0.0 * x[0], rate(x[0])], 2)


def test_a_power_whose_first_coefficients_are_zero():
    run = clpt.simulate(
        of_ramp(lambda u: 100 * u**14 * (1 - u)),
        [0.0, 1.0, 2.0, 3.0],
        [[0.0, 1.0, 0.0, 1.0]],
        **SERIES,
    )
    exact = 100 * (1 / 15 - 1 / 16)
    expected = [0.0, exact, 2 * exact, 3 * exact]
    np.testing.assert_allclose(run.states[:, 0], expected, rtol=1e-7)


@pytest.mark.parametrize("power", [12, 20, 32])
def test_a_peak_of_a_high_power(power):
    rate = of_clock(lambda x: (4 * x * (1 - x)) ** power)
    found, _ = end(rate, [0.0, 0.0], [0.0, 1.0])
    expected = 4.0**power * factorial(power) ** 2 / factorial(2 * power + 1)
    assert found[1] == pytest.approx(expected, rel=1e-6)


@pytest.mark.long
def test_a_turn_whose_angle_is_a_high_power():
    found, _ = end(of_clock(lambda x: np.cos(2 * np.pi * x**16)), [0.0, 0.0], [0, 1.0])
    expected, _ = quad(lambda x: np.cos(2 * np.pi * x**16), 0.0, 1.0, epsabs=1e-13)
    assert found[1] == pytest.approx(expected, abs=1e-7)


@pytest.mark.parametrize("width", [0.3, 0.03, 0.003])
def test_narrow_pulses(width):
    area = width * np.sqrt(np.pi)
    pulse = lambda x: np.exp(-(((x - 3.7) / width) ** 2))  # noqa: E731
    found, _ = end(of_clock(pulse), [0.0, 0.0], [0.0, 10.0])
    assert found[1] == pytest.approx(area, abs=1e-8)
    found, _ = end(of_ramp(pulse), [0.0], [0.0, 10.0], inputs=[0.0, 10.0])
    assert found[0] == pytest.approx(area, abs=1e-8)
    decay = system(lambda t, x, u, p: [-x[0], x[0] * pulse(10 * x[0])], 2)
    found, _ = end(decay, [1.0, 0.0], [0.0, 30.0])
    assert found[1] == pytest.approx(area / 10, abs=1e-8)


@pytest.mark.parametrize(
    "bump",
    [
        lambda q: 1.0 / np.cosh(q),
        lambda q: 1.0 - np.tanh(q) ** 2,
        lambda q: (1.0 + q * q) ** -8,
        lambda q: 1.0 / (1.0 + q * q) ** 8,
    ],
)
def test_bumps_that_few_coefficients_show(bump):
    found, _ = end(of_clock(lambda x: bump((x - 3.7) / 0.02)), [0.0, 0.0], [0.0, 10.0])
    expected, _ = quad(bump, -100.0, 100.0, epsabs=1e-12, limit=500, points=[0.0])
    assert found[1] == pytest.approx(0.02 * expected, abs=1e-7)


@pytest.mark.parametrize(
    "size",
    [
        lambda q: np.hypot(q, 0.0),
        lambda q: np.sqrt(q * q),
        lambda q: (q * q) ** 0.5,
        lambda q: np.sqrt(np.sum(np.array([q, 0.0]) ** 2)),
    ],
)
def test_a_hidden_kink_that_is_crossed_twice(size):
    kinks = of_clock(lambda x: size((x - 1.0) ** 2 - 0.25))
    found, _ = end(kinks, [0.0, 0.0], [0.0, 3.0])
    assert found[1] == pytest.approx(2.25 + 1 / 3, rel=1e-7)


@pytest.mark.parametrize(("begin", "scale"), [(1e9, 1e-3), (1e9, 1e-5), (1e3, 1e-9)])
def test_late_starts_take_the_steps_of_rounded_times(begin, scale):
    turn = system(lambda t, x, u, p: [x[1] / scale, -x[0] / scale], 2)
    last = begin + 20 * scale
    found, _ = end(turn, [1.0, 0.0], [begin, last])
    angle = (last - begin) / scale
    np.testing.assert_allclose(found, [np.cos(angle), -np.sin(angle)], atol=1e-7)
