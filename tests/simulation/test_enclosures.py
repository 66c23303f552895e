"""Guaranteed runs: boxes contain every run, and end with a sentence where they cannot."""

import itertools
import math

import control
import mpmath
import numpy as np
import pytest

import clpt_control as clpt


def block(function, n=2, **more):
    return clpt.Block("model", update=function, states={"x": n}, **more)


def oscillator(t, x, u, p):
    return [x[1], -x[0]]


def pendulum(t, x, u, p):
    return [x[1], -np.sin(x[0])]


def decay(t, x, u, p):
    return -p.k * x.x + u.d


def of_decay(**more):
    return block(decay, 1, inputs={"d": 1}, parameters={"k": 1.0}, **more)


def inside(tube, k, exact):
    """Return whether numbers of 40 digits lie in the boxes of states at a sample."""
    bounds = zip(tube.lower[k].values, exact, tube.upper[k].values, strict=False)
    return all(mpmath.mpf(low) <= x <= mpmath.mpf(high) for low, x, high in bounds)


# --- closed forms, without margin --------------------------------------------------------------


def test_a_turned_box_is_found_to_the_last_digits():
    start, times = [(0.9, 1.1), (-0.1, 0.1)], np.linspace(0, 20, 5)
    tube = clpt.enclose(block(oscillator), times, initial_state=start)
    for k, t in enumerate(times):
        with mpmath.workdps(40):
            c, s = mpmath.cos(mpmath.mpf(t)), mpmath.sin(mpmath.mpf(t))
            half = abs(c) * (mpmath.mpf(1.1) - mpmath.mpf(0.9)) / 2 + abs(s) / 10
            middle = (mpmath.mpf(0.9) + mpmath.mpf(1.1)) / 2 * c
            assert inside(tube, k, [middle - half])
            assert inside(tube, k, [middle + half])
        width = float(tube.upper[k, 0] - tube.lower[k, 0])
        assert width < 2 * float(half) * (1 + 1e-4)


def test_boxes_that_are_too_narrow_by_one_part_in_1e12_are_found():
    times = np.linspace(0, 3, 4)
    tube = clpt.enclose(block(oscillator), times, initial_state=[1.0, 0.0])
    for k, t in enumerate(times[1:], 1):
        with mpmath.workdps(40):
            state = [mpmath.cos(mpmath.mpf(t)), -mpmath.sin(mpmath.mpf(t))]
        assert inside(tube, k, state)
        for bound, sign in (("lower", 1), ("upper", -1)):
            narrow = tube.copy(deep=True)
            narrow[bound][k] += sign * 1e-12 * abs(narrow[bound][k])
            assert not inside(narrow, k, state)


@pytest.mark.parametrize("inputs", [{"d": (0.4, 0.6)}, [(0.4, 0.6)]])
def test_an_input_may_be_any_function_of_time_in_its_bounds(inputs):
    tube = clpt.enclose(of_decay(), [0, 5], inputs, [0.0])
    with mpmath.workdps(40):
        rise = 1 - mpmath.exp(-5)
        low, high = mpmath.mpf(0.4) * rise, mpmath.mpf(0.6) * rise
    assert inside(tube, 1, [low])
    assert inside(tube, 1, [high])
    assert float(tube.upper[-1, 0] - tube.lower[-1, 0]) < 0.2 * (1 + 1e-9)


def test_a_parameter_and_a_state_are_intervals():
    tube = clpt.enclose(of_decay(), [0, 1], 0.0, [(1, 2)], {"model.k": (0.9, 1.1)})
    with mpmath.workdps(40):
        assert inside(tube, 1, [mpmath.exp(-mpmath.mpf(1.1))])
        assert inside(tube, 1, [2 * mpmath.exp(-mpmath.mpf(0.9))])


# --- against series of 30 digits ---------------------------------------------------------------


class Series:
    """Coefficients of a Taylor series in numbers of mpmath."""

    def __init__(self, *a):
        self.a = [mpmath.mpf(x) for x in a]

    def at(self, k):
        return self.a[k] if k < len(self.a) else mpmath.mpf(0)

    def each(self, other, operation):
        other = other if isinstance(other, Series) else Series(other)
        count = max(len(self.a), len(other.a))
        return Series(*(operation(self, other, k) for k in range(count)))

    def __add__(self, other):
        return self.each(other, lambda a, b, k: a.at(k) + b.at(k))

    def __mul__(self, other):
        return self.each(
            other,
            lambda a, b, k: mpmath.fsum(a.at(j) * b.at(k - j) for j in range(k + 1)),
        )

    def power(self, exponent):
        f = [self.a[0] ** exponent]
        for k in range(1, len(self.a)):
            terms = ((exponent * (k - j) - j) * self.a[k - j] * f[j] for j in range(k))
            f.append(mpmath.fsum(terms) / (k * self.a[0]))
        return Series(*f)

    def sin(self):
        s, c = [mpmath.sin(self.a[0])], [mpmath.cos(self.a[0])]
        for k in range(1, len(self.a)):
            slopes = [j * self.a[j] / k for j in range(1, k + 1)]
            s, c = (
                [*s, mpmath.fsum(m * c[k - j] for j, m in enumerate(slopes, 1))],
                [*c, -mpmath.fsum(m * s[k - j] for j, m in enumerate(slopes, 1))],
            )
        return Series(*s)


def final_state(rates, start, end, steps, order=24):
    """Return the state at the end of a run of rates of series, to some 25 digits."""
    state = [mpmath.mpf(x) for x in start]
    h = mpmath.mpf(end) / steps
    for _ in range(steps):
        series = [Series(x) for x in state]
        for k in range(order):
            rows = rates(series)
            for x, rate in zip(series, rows, strict=True):
                x.a.append(rate.at(k) / (k + 1))
        state = [mpmath.polyval(x.a[::-1], h) for x in series]
    return state


MODELS = [
    (
        lambda t, x, u, p: [
            10.0 * (x[1] - x[0]),
            x[0] * (28.0 - x[2]) - x[1],
            x[0] * x[1] - 2.5 * x[2],
        ],
        lambda x: [
            (x[1] + x[0] * -1) * 10,
            x[0] * (x[2] * -1 + 28) + x[1] * -1,
            x[0] * x[1] + x[2] * -2.5,
        ],
        [1.0, 1.0, 1.0],
        0.5,
        25,
    ),
    (pendulum, lambda x: [x[1], x[0].sin() * -1], [1.0, 0.5], 2.0, 8),
    (
        lambda t, x, u, p: [
            x[2],
            x[3],
            -x[0] / np.hypot(x[0], x[1]) ** 3,
            -x[1] * (x[0] ** 2 + x[1] ** 2) ** -1.5,
        ],
        lambda x: [
            x[2],
            x[3],
            x[0] * (x[0] * x[0] + x[1] * x[1]).power(-1.5) * -1,
            x[1] * (x[0] * x[0] + x[1] * x[1]).power(-1.5) * -1,
        ],
        [0.75, 0.0, 0.0, 1.25],
        1.0,
        8,
    ),
]


@pytest.mark.long
@pytest.mark.parametrize(("model", "rates", "start", "end", "steps"), MODELS)
def test_orbits_lie_within_boxes(model, rates, start, end, steps):
    tube = clpt.enclose(block(model, len(start)), [0, end], initial_state=start)
    with mpmath.workdps(32):
        state = final_state(rates, start, end, steps)
    assert inside(tube, 1, state)
    assert float((tube.upper - tube.lower)[-1].max()) < 1e-11
    # so does every orbit of a small set
    near = [(x - 1e-3, x + 1e-3) for x in start]
    tube = clpt.enclose(block(model, len(start)), [0, end], initial_state=near)
    with mpmath.workdps(32):
        corner = final_state(rates, [x for x, _ in near], end, steps)
    assert inside(tube, 1, state)
    assert inside(tube, 1, corner)


SMOOTH = (
    *("exp", "sin", "cos", "tan", "tanh", "atan", "log", "sqrt", "sinh", "cosh"),
    *("expm1", "log1p", "log2", "log10", "asin", "acos"),
)


@pytest.mark.parametrize("name", SMOOTH)
def test_functions_along_time(name):
    """x' = f'(t) by a quotient of differences is not known; x' = f(x) with x = t is."""
    function = getattr(np, name)
    exact = (lambda a: mpmath.log(a, 2)) if name == "log2" else getattr(mpmath, name)
    model = block(lambda t, x, u, p: [1.0 + 0.0 * x[1], function(x[0])])
    tube = clpt.enclose(model, [0, 0.5], initial_state=[0.25, 0.0])
    with mpmath.workdps(40):
        integral = mpmath.quad(exact, [mpmath.mpf(0.25), mpmath.mpf(0.75)])
        assert inside(tube, 1, [mpmath.mpf(0.75), integral])
    assert float((tube.upper - tube.lower)[-1].max()) < 1e-13


# --- known times, switches, traps ---------------------------------------------------------------


def test_samples_of_inputs_are_known_times():
    times = [0.0, 1.0, 1.0, 2.0]
    tube = clpt.enclose(of_decay(), times, [0.0, 1.0, -1.0, 0.5], [1.0])
    with mpmath.workdps(40):
        e = mpmath.exp(-1)
        first = e + e
        # x' = -x - 1 + 3/2 s from `first`, s after 1
        last = (first + mpmath.mpf(5) / 2) * e - mpmath.mpf(5) / 2 + mpmath.mpf(3) / 2
    assert inside(tube, 1, [first])
    assert inside(tube, 2, [last])
    assert float((tube.upper - tube.lower)[-1].max()) < 1e-13


def test_a_switch_of_a_point_costs_little():
    def saturated(t, x, u, p):
        return [x[1], -np.clip(x[0] + x[1], -0.3, 0.3)]

    times = np.linspace(0, 8, 9)
    tube = clpt.enclose(block(saturated), times, initial_state=[1.0, 0.0])
    run = clpt.simulate(block(saturated), times, initial_state=[1.0, 0.0], rtol=1e-12)
    states = run.states.values
    assert np.all(tube.lower <= states + 1e-9)
    assert np.all(tube.upper >= states - 1e-9)
    assert float((tube.upper - tube.lower).max()) < 1e-7


TRAPS = {
    "escapes": (lambda t, x, u, p: x.x * x.x, [1.0], 0.9, 1.0),
    "a divisor reaches 0": (lambda t, x, u, p: -1.0 / x.x, [1.0], 0.4, 0.5),
    "begins at a divisor of 0": (lambda t, x, u, p: 1.0 / x.x, [0.0], 0.0, 0.0),
    "a set with a divisor of 0": (lambda t, x, u, p: 1.0 / x.x, [(-1, 1)], 0.0, 0.0),
    "a root reaches 0": (lambda t, x, u, p: -np.sqrt(x.x), [0.25], 0.9, 1.0),
    "a root of less than 0": (lambda t, x, u, p: np.sqrt(x.x), [-1.0], 0.0, 0.0),
    "a logarithm of 0": (lambda t, x, u, p: np.log(x.x), [0.5], 0.3, 1.0),
    "an arc sine beyond 1": (lambda t, x, u, p: 1.0 + np.asin(x.x), [0.0], 0.3, 1.0),
    "a power of 0": (lambda t, x, u, p: -(x.x**0.3), [1.0], 1.3, 1.43),
    "huge": (lambda t, x, u, p: np.exp(x.x), [(0.0, 1e9)], 0.0, 0.0),
    "too large to be squared": (lambda t, x, u, p: x.x * x.x, [1e200], 0.0, 1e-199),
    "an infinite number": (lambda t, x, u, p: 1e308 * x.x * 10.0, [1.0], 0.0, 0.1),
    "no number": (lambda t, x, u, p: x.x * np.nan, [1.0], 0.0, 0.0),
    "a set at a jump": (lambda t, x, u, p: 1e3 * np.sign(x.x), [(-1, 1)], 0.0, 2.0),
}


@pytest.mark.parametrize("trap", TRAPS)
def test_a_trap_ends_with_a_time_and_a_sentence(trap):
    rate, start, after, before = TRAPS[trap]
    tube = clpt.enclose(block(rate, 1), [0, 2], initial_state=start)
    if tube.status == "finished":
        assert trap == "a set at a jump"
        assert tube.lower[-1] < -2000 < 2000 < tube.upper[-1]
        return
    assert tube.status == "stopped"
    assert np.isnan(tube.lower[-1]).all()
    assert np.isnan(tube.over_upper[-1]).all()
    end, why = tube.message.split(" to t = ")[1].split("; ")[:2]
    assert after <= float(end) <= before
    assert why.startswith("the boxes end there, as ")


def test_guards_jumps_at_a_level_and_systems_without_states_are_refused():
    def margin(t, x, u, p):
        return x[0] + 2.0

    stops = block(oscillator, guard=clpt.Guard(margin, "stop"))
    jumps = block(
        oscillator,
        guard=clpt.Guard(margin, "jump"),
        jump=lambda t, x, u, p: {"x": -x.x},
    )
    for model in (stops, jumps):
        with pytest.raises(clpt.SimulationError, match="guards, or jumps at a level"):
            clpt.enclose(model, [0, 1], initial_state=[1.0, 0.0])
    with pytest.raises(clpt.SimulationError, match="has no states"):
        clpt.enclose(control.ss([], [], [], 1.0, 1.0), [0, 1], [(0, 1)])


def test_a_function_without_a_series_is_refused():
    model = block(lambda t, x, u, p: -math.erf(x.x[0]), 1)
    with pytest.raises(clpt.SimulationError, match="operation erf"):
        clpt.enclose(model, [0, 1], initial_state=[1.0])


def test_pairs_in_the_wrong_order_and_of_names_are_refused():
    with pytest.raises(clpt.ArgumentError, match="lower, upper"):
        clpt.enclose(block(pendulum), [0, 1], initial_state=[(2, 1), 0])
    with pytest.raises(clpt.ArgumentError, match="finite width"):
        clpt.enclose(block(pendulum), [0, 1], initial_state=[(-1.7e308, 1.7e308), 0])
    with pytest.raises(clpt.BlockError, match="unknown parameter"):
        clpt.enclose(
            block(pendulum), [0, 1], initial_state=[0, 0], params={"k": (1, 2)}
        )


def test_names_and_ports_of_states():
    model = block(lambda t, x, u, p: [x[1], u.d[0] - x[0]], inputs={"d": 1})
    by_name = [
        [(0.0, 0.1), 1.0],
        {"x": [(0.0, 0.1), 1.0]},
        {"x[0]": (0.0, 0.1), "x[1]": 1.0},
        {"x": ([0.0, 1.0], [0.1, 1.0])},
    ]
    tubes = [clpt.enclose(model, [0, 1], {"d": (0.0, 0.1)}, start) for start in by_name]
    assert all(tube.identical(tubes[0]) for tube in tubes)


def test_the_tube_is_drawn():
    tube = clpt.enclose(of_decay(), [0, 1, 2], {"d": (-0.1, 0.1)}, [1.0])
    assert tube.clpt.kind == "tube"
    (axes,) = np.ravel(tube.clpt.plot())
    assert axes.get_ylabel() == "x"
    texts = [text.get_text() for text in axes.get_legend().get_texts()]
    assert texts == ["over each interval", "at the times"]
    grows = control.nlsys(
        lambda t, x, u, p: [x[0] ** 2], states=["x"], inputs=0, name="grows"
    )
    grows.units = {"x": "m s-1"}
    ended = clpt.enclose(grows, [0, 0.5, 0.9, 1.2], initial_state=[(0.9, 1.0)])
    (axes,) = np.ravel(ended.clpt.plot())
    assert axes.get_ylabel() == "x (m/s)"
    assert axes.lines[-1].get_label() == "boxes end"
    assert axes.lines[-1].get_xdata()[0] == 0.9
    assert np.all(tube.over_lower[1:] <= np.minimum(tube.lower[1:], tube.lower[:-1]))


def if_of_a_parameter(t, x, u, p):
    return -x.x if p.k > 0.7 else x.x


def test_an_interval_of_a_parameter_that_an_if_reads_is_refused():
    model = block(if_of_a_parameter, 1, parameters={"k": 1.0})
    with pytest.raises(clpt.SimulationError, match="asks for the value"):
        clpt.enclose(model, [0, 1], None, [1.0], {"model.k": (0.5, 1.0)})
    tube = clpt.enclose(model, [0, 1], None, [1.0], {"model.k": 0.5})
    assert inside(tube, 1, [mpmath.e])


def test_a_condition_of_an_interval_takes_in_both_sides():
    def switched(t, x, u, p):
        return np.where(p.k > 0.7, -x.x, x.x)

    model = block(switched, 1, parameters={"k": 1.0})
    params = {"model.k": (0.5, 1.0)}
    tube = clpt.enclose(model, [0, 0.1], initial_state=[1.0], params=params)
    assert tube.lower[-1, 0] <= np.exp(-0.1)
    assert tube.upper[-1, 0] >= np.exp(0.1)


def test_pairs_of_inputs_beside_samples():
    model = block(lambda t, x, u, p: u.a + u.d - x.x, 1, inputs={"a": 1, "d": 1})
    inputs = {"a": [0.0, 1.0, 0.0], "d": (-0.1, 0.1)}
    tube = clpt.enclose(model, [0, 1, 2], inputs, [0.0])
    for d in (-0.1, 0.1):
        run = clpt.simulate(
            model,
            [0, 1, 2],
            {**inputs, "d": d},
            initial_state=[0.0],
            rtol=1e-13,
            atol=1e-14,
        )
        assert np.all(tube.lower[:, 0] <= run.states[:, 0].values + 1e-12)
        assert np.all(tube.upper[:, 0] >= run.states[:, 0].values - 1e-12)
    with pytest.raises(clpt.ArgumentError, match="one shape"):
        clpt.enclose(model, [0, 1, 2], {"a": 0.0, "d": (0.0, [0.1, 0.2, 0.3])}, [0.0])


@pytest.mark.long
def test_the_loop_of_the_paper_from_its_own_start_through_two_waypoints():
    loop = clpt.closed_loop(clpt.paper_scenario())
    times, start = [0.0, 5.0, 45.0], [0.0] * 14
    tube = clpt.enclose(loop, times, None, start)
    states = clpt.simulate(loop, times, None, start, rtol=1e-12, atol=1e-13).states
    n = states.shape[1]
    assert np.all(np.abs(tube.lower[:, :n] - states.values) < 1e-10)
    assert np.all(np.abs(tube.upper[:, :n] - states.values) < 1e-10)


def test_logarithms_of_constants_are_enclosed():
    """x' = -2^x has 2^-x = 1/2 + t log 2."""
    model = block(lambda t, x, u, p: -(2.0**x.x), 1)
    tube = clpt.enclose(model, [0, 1], initial_state=[1.0])
    with mpmath.workdps(40):
        log2 = mpmath.log(2)
        assert inside(tube, 1, [-mpmath.log(mpmath.mpf(0.5) + log2) / log2])
    assert float((tube.upper - tube.lower)[-1].max()) < 1e-13


@pytest.mark.parametrize(
    ("rate", "start", "end", "exact", "jumps"),
    [
        (lambda t, x, u, p: 1.0 + np.floor(x.x), 0.5, 1.5, 11 / 3, True),
        (
            lambda t, x, u, p: np.where(t < 0.5, 1.0, -1.0) + 0.0 * x.x,
            0.0,
            2.0,
            -1.0,
            True,
        ),
        (lambda t, x, u, p: np.maximum(t - 1.0, 0.0) + 0.0 * x.x, 0.0, 2.0, 0.5, False),
        (lambda t, x, u, p: np.abs(x.x), 0.0, 1.0, 0.0, False),
        (lambda t, x, u, p: -np.sign(x.x), 1.0, 2.0, 0.0, True),
        (lambda t, x, u, p: np.sqrt(np.abs(x.x)), 0.0, 1.0, 0.25, False),
        (lambda t, x, u, p: np.sqrt(np.abs(x.x)), 0.0, 1.0, 0.0, False),
    ],
)
def test_runs_over_switches_lie_within_boxes(rate, start, end, exact, jumps):
    tube = clpt.enclose(block(rate, 1), [0, end], initial_state=[start])
    assert tube.status == "finished"
    assert ("Filippov" in tube.message) == jumps
    assert tube.steps >= tube.steps_beside_switches > 0
    assert tube.lower[-1, 0] <= exact + 1e-15
    assert tube.upper[-1, 0] >= exact - 1e-15


def test_a_name_means_what_it_means_in_a_run():
    double = control.nlsys(
        *(lambda t, x, u, p: [-x[0]], lambda t, x, u, p: [2 * x[0]]),
        **{"states": ["x"], "outputs": ["x"], "inputs": 0, "name": "double"},
    )
    swapped = control.nlsys(
        *(lambda t, x, u, p: [-x[0], -2 * x[1]], lambda t, x, u, p: [x[1], x[0]]),
        **{"states": ["x", "z"], "outputs": ["x", "z"], "inputs": 0, "name": "swapped"},
    )
    shifted = block(
        *(lambda t, x, u, p: [-x[1], -x[0]],),
        outputs={"x": 2, "x_state": 1},
        output=lambda t, x, u, p: {"x": x.x * [1.0, 2.0], "x_state": x.x[:1] + 5.0},
    )
    for system in (double, swapped, shifted):
        start = [1.0] if system.nstates == 1 else [1.0, 2.0]
        tube = clpt.enclose(system, [0, 1], initial_state=start)
        run = clpt.simulate(system, [0, 1], initial_state=start, rtol=1e-12)
        assert len({*tube.name.values}) == len(tube.name)
        for port in {*run.data_vars} - {"states"}:
            for k, value in enumerate(np.ravel(run[port][-1])):
                row = tube.sel(name=f"{port}[{k}]")
                assert np.allclose([row.lower[-1], row.upper[-1]], value, 1e-9)


def test_outputs_of_a_diagram_are_sums_of_signals():
    first, second = (
        control.nlsys(
            *(lambda t, x, u, p: [u[0] - x[0]], lambda t, x, u, p: [2 * x[0]]),
            **{"states": 1, "inputs": ["u"], "outputs": ["y"], "name": name},
        )
        for name in ("first", "second")
    )
    loop = control.interconnect(
        [first, second],
        [["second.u", "first.y"]],
        inplist=["first.u"],
        inputs=["r"],
        outlist=[["-first.y", "second.u"], ["second.y"]],
        outputs=["y", "w"],
    )
    tube = clpt.enclose(loop, [0, 1], {"r": (0.9, 1.1)}, [1.0, 0.0])
    assert [*tube.name.values[-2:]] == ["y[0]", "w[0]"]
    run = clpt.simulate(loop, [0, 1], {"r": 1.1}, [1.0, 0.0], rtol=1e-12)
    for name in ("y", "w"):
        row, value = tube.sel(name=f"{name}[0]"), run[name][-1] + 1e-9
        assert row.lower[-1] <= value <= row.upper[-1] + 2e-9


@pytest.mark.parametrize(
    ("rate", "start", "why"),
    [
        (
            lambda t, x, u, p: np.exp(x.x),
            (-3000.0, 3000.0),
            "exp of 3000 is not finite",
        ),
        (lambda t, x, u, p: np.log(x.x), (0.0, 1.0), "logarithm may be 0 or less"),
        (lambda t, x, u, p: 1 / np.abs(x.x), (-1.0, 1.0), "a kink"),
    ],
)
def test_a_sentence_names_the_cause(rate, start, why):
    tube = clpt.enclose(block(rate, 1), [0, 1], initial_state=[start])
    assert why in tube.message


@pytest.mark.parametrize("name", ["a", "unread"])
def test_a_parameter_with_the_name_of_a_state_and_one_that_nothing_reads(name):
    model = control.nlsys(
        lambda t, x, u, p: [-p["a"] * x[0]],
        **{"states": ["a"], "inputs": 0, "outputs": 1, "name": "model"},
        params={"a": 1.0, "unread": 1.0},
    )
    tube = clpt.enclose(model, [0, 1], None, [1.0], {name: (1.0, 1.1)})
    slow, fast = math.exp(-1.0), math.exp(-1.1 if name == "a" else -1.0)
    assert fast - 1e-2 < tube.lower[-1, 0] <= fast + 1e-15
    assert slow - 1e-15 <= tube.upper[-1, 0] < slow + 1e-2


def test_arrays_of_parameters_take_a_pair_of_arrays():
    model = block(lambda t, x, u, p: -p.k * x.x, parameters={"k": np.ones(2)})
    pair = np.array([1.0, 1.0]), np.array([1.0, 1.1])
    tube = clpt.enclose(model, [0, 1], None, [1.0, 1.0], {"model.k": pair})
    assert np.all(tube.lower[-1] <= np.exp([-1.0, -1.1]) + 1e-15)
    assert np.allclose(tube.upper[-1] - tube.lower[-1], [0, 0.035], atol=3e-3)
    with pytest.raises(clpt.ArgumentError, match="Give a pair of arrays"):
        clpt.enclose(model, [0, 1], None, [1, 1], {"model.k": [1.0, (1.0, 1.1)]})


@pytest.mark.parametrize("read", [list, np.array, np.float32])
@pytest.mark.parametrize("other", [list, lambda a: np.array(a, float)])
def test_ends_of_arrays_of_any_kind_are_read(read, other):
    model = control.nlsys(
        lambda t, x, u, p: [-p["w"][0] * x[0], -p["w"][1] * x[1]],
        **{"states": ["a", "b"], "inputs": 0, "outputs": ["a", "b"], "name": "model"},
        params={"w": np.array([1.0, 5.0])},
    )
    for pair in ((read([1, 5]), other([2, 6])), (other([1, 5]), read([2, 6]))):
        tube = clpt.enclose(model, [0, 0.1], None, [1.0, 1.0], {"w": pair})
        assert np.all(tube.lower[-1] <= np.exp([-0.2, -0.6]))
        assert np.all(tube.upper[-1] >= np.exp([-0.1, -0.5]))
        assert np.all(tube.upper[-1] - tube.lower[-1] < 0.3)


@pytest.mark.parametrize("read", [np.array, lambda a: np.array(a, float), int, float])
def test_ends_of_a_number_of_any_kind_are_read(read):
    model = control.nlsys(
        lambda t, x, u, p: -p["k"] * x, None, inputs=0, states=1, params={"k": 1.0}
    )
    tube = clpt.enclose(model, [0, 0.1], None, [1.0], {"k": (read(1), read(2))})
    assert tube.lower[-1, 0] <= math.exp(-0.2) < math.exp(-0.1) <= tube.upper[-1, 0]


def test_what_may_be_one_pair_or_two_is_refused():
    model = block(lambda t, x, u, p: -x, inputs={})
    for start in (((0, 1), (2, 3)), {"x": ((0, 1), (2, 3))}):
        with pytest.raises(clpt.ArgumentError, match="may be"):
            clpt.enclose(model, [0, 1], initial_state=start)
    for shape in ((np.eye(2), np.eye(3)), (None, 1.0), ([], []), (4, 3)):
        with pytest.raises(clpt.ArgumentError, match="a finite width and one shape"):
            clpt.enclose(model, [0, 1], initial_state={"x": shape})


def test_a_state_that_stays_0_beside_an_input_costs_no_steps():
    model = control.nlsys(
        lambda t, x, u, p: [-x[0], -2 * x[1] + u[0]],
        **{"states": ["x", "z"], "inputs": ["b"], "outputs": ["x", "z"], "name": "m"},
    )
    tube = clpt.enclose(model, [0, 1, 2], {"b": (3, 4)})
    share = (1 - math.exp(-4.0)) / 2
    assert tube.lower[-1, 1] <= 3 * share <= 4 * share <= tube.upper[-1, 1]
    assert tube.lower[-1, 0] <= 0 <= tube.upper[-1, 0] < 1e-40
    assert tube.steps < 20


def test_a_first_time_one_ulp_before_a_sample_costs_no_steps():
    loop = clpt.connect(
        [clpt.parts.hold(0.5, u="u", y="h"), clpt.parts.lag(2.0, u="h", y="y")],
        external="u",
    )
    tube = clpt.enclose(loop, [np.nextafter(0.5, 0), 0.5, 1], [(1, 2)], 0)
    share = 1 - math.exp(-0.25)
    low, high = tube.lower[-1, 1], tube.upper[-1, 1]
    assert low <= share <= 2 * share <= high
    assert tube.steps < 400


def test_a_pair_for_a_port_of_several_is_refused():
    three = block(lambda t, x, u, p: -x.x, 3)
    assert clpt.enclose(three, [0, 1], None, {"x": (1, 2)}).status == "finished"
    model = block(lambda t, x, u, p: u.d - x.x, 2, inputs={"d": 2})
    for given in ({"initial_state": {"x": (1, 2)}}, {"inputs": {"d": (1, 2)}}):
        with pytest.raises(clpt.ArgumentError, match="may be one pair or two numbers"):
            clpt.enclose(model, [0, 1], **given)
    pairs = [(0, 0.1), (0.2, 0.3)]
    tube = clpt.enclose(model, [0, 1], {"d": pairs}, {"x": pairs})
    assert np.all(tube.lower[-1] <= [0, 0.2])
    assert np.all(tube.upper[-1] >= [0.1, 0.3])


TIMED = {  # rates, how the block is made, its inputs and whether the set is kept
    "falls": (lambda t, x, u, p: -x.x, {}, None, True),
    "is pushed": (lambda t, x, u, p: u.d - x.x, {"inputs": {"d": 1}}, 0.2, True),
    "a ramp": (lambda t, x, u, p: u.d - x.x, {"inputs": {"d": 1}}, [0.1, 2.0], False),
    "time": (lambda t, x, u, p: (t - 2) * x.x, {}, None, False),
    "a time": (lambda t, x, u, p: np.where(t < 9, -x.x, x.x), {}, None, False),
    "a map": (lambda t, x, u, p: x.x / 2, {"dt": 1.0}, None, True),
    "a map of time": (lambda t, x, u, p: (t - 1) * x.x, {"dt": 1.0}, None, False),
}


@pytest.mark.parametrize(("rates", "made", "u", "is_kept"), TIMED.values(), ids=TIMED)
def test_boxes_hold_for_ever_where_nothing_depends_on_time(rates, made, u, is_kept):
    model = clpt.Block("model", update=rates, states={"x": 1}, **made)
    tube = clpt.enclose(model, [0, 1], u, [(-1.0, 1.0)])
    assert ("hold for ever" in tube.message) == is_kept


@pytest.mark.parametrize("dt", [0, 1.0])
def test_an_output_of_time_leaves_its_box(dt):
    model = clpt.Block(
        "model",
        update=lambda t, x, u, p: x.x / 2 if dt else -x.x,
        output=lambda t, x, u, p: np.maximum(t, 5.0),
        **{"states": {"x": 1}, "outputs": {"o": 1}, "dt": dt},
    )
    tube = clpt.enclose(model, [0, 1, 2], None, [(-1.0, 1.0)])
    assert np.all(np.abs([tube.lower[-1, 0], tube.upper[-1, 0]]) < 1)
    assert "hold for ever" not in tube.message


def test_a_sampled_loop_that_grows_is_not_said_to_stay():
    # x' = 2.5 x - 3.9 y - 2 h, y' = 2.9 x - 2.6 y - 1.4 h, h of x each 1: 1.66 per sample
    plant = control.ss([[2.5, -3.9], [2.9, -2.6]], [[-2], [-1.4]], [1, 0], 0, name="p")
    plant.set_inputs(["h"])
    plant.set_outputs(["y"])
    loop = clpt.connect([clpt.parts.hold(1.0, u="y", y="h"), plant])
    tube = clpt.enclose(loop, [0, 0.5, 1, 1.5], None, [(-1, 1), (-1, 1), (-0.2, 0.2)])
    assert np.all(np.abs([tube.lower[-1, 1], tube.upper[-1, 1]]) <= 1)
    assert "hold for ever" not in tube.message


def test_a_pair_alone_is_no_argument_of_inputs():
    tank = clpt.parts.lag(1.0)
    for pair in ((0, 1), ((0, 1), (2, 3))):
        with pytest.raises(clpt.ArgumentError, match="may be one pair or two numbers"):
            clpt.enclose(tank, [0, 1], pair)


@pytest.mark.parametrize(
    ("states", "inputs", "outputs"),
    [
        (["x[0]", "x[1]"], "u", ["x[1]"]),
        (["x", "x_state"], "u", ["x_state", "x"]),
        (["x[0]", "x"], "u", ["y"]),
        (["a", "b"], "u", ["states"]),
        (["x", "b"], "x", ["y"]),
    ],
)
def test_names_of_two_signals_are_refused(states, inputs, outputs):
    model = control.nlsys(
        lambda t, x, u, p: [-x[0], -2 * x[1]],
        lambda t, x, u, p: [x[1] + 10, x[0] + 20][: len(outputs)],
        **{"states": states, "inputs": inputs, "outputs": outputs, "name": "m"},
    )
    with pytest.raises(clpt.ArgumentError, match="is the name of two signals, or of"):
        clpt.enclose(model, [0, 1], 0, [1, 2])


def test_boxes_over_intervals_are_those_of_the_intervals():
    """x = r cos t, r in (0.9, 1.1); a step of the series is longer than 10 intervals."""
    times = np.linspace(0, 20, 201)
    start = [(0.9, 1.1), 0.0]
    tube = clpt.enclose(block(oscillator), times, initial_state=start)
    for k, (begin, end) in enumerate(itertools.pairwise(times), 1):
        x = np.cos(np.linspace(begin, end, 11))
        low, high = np.min([0.9 * x, 1.1 * x]), np.max([0.9 * x, 1.1 * x])
        assert tube.over_lower[k, 0] <= low + 1e-15
        assert tube.over_upper[k, 0] >= high - 1e-15
    assert float((tube.over_upper - tube.over_lower)[1:].max()) < 1.5


@pytest.mark.long
@pytest.mark.parametrize(
    ("rate", "start", "end"),
    [
        (lambda t, x, u, p: np.round(t) + 0.0 * x.x, 0.0, 2.0),
        (lambda t, x, u, p: np.where(x.x == 1.0, 5.0, 1.0), 1.0, 3.0),
        (lambda t, x, u, p: np.where(np.logical_not(t < 1), 1, 0) + 0 * x.x, 0.0, 1.0),
    ],
)
def test_conditions_of_conditions_may_be_true_or_false(rate, start, end):
    tube = clpt.enclose(block(rate, 1), [0, 2], initial_state=[start])
    assert tube.lower[-1, 0] <= end <= tube.upper[-1, 0]
    assert float((tube.upper - tube.lower)[-1].max()) < 1e-9


# --- discrete time, samples and jumps at known times ---------------------------------------------


def map_of(function, n=1, dt=0.5, **more):
    return block(function, n, dt=dt, **more)


def contains(row, *exact):
    """Return whether numbers lie in a row of bounds: lower, then upper."""
    low, high = (mpmath.mpf(float(end)) for end in row)
    return all(low <= x <= high for x in exact)


def test_a_discrete_system_with_sets_of_states_inputs_and_parameters():
    model = map_of(decay_map, inputs={"d": 1}, parameters={"k": 0.9})
    tube = clpt.enclose(
        *(model, 0.5 * np.arange(6), {"d": (-0.1, 0.2)}, [(1.0, 2.0)]),
        {"model.k": (0.9, 0.9)},
    )
    assert tube.attrs["status"] == "finished"
    low, high = mpmath.mpf(1), mpmath.mpf(2)
    with mpmath.workdps(40):
        for lower, upper in zip(tube.lower[:, 0], tube.upper[:, 0], strict=True):
            assert contains([lower, upper], low, high)
            assert float(upper - lower) < float(high - low) * (1 + 1e-12)
            low = low * mpmath.mpf(0.9) + mpmath.mpf(-0.1)
            high = high * mpmath.mpf(0.9) + mpmath.mpf(0.2)


def decay_map(t, x, u, p):
    return p.k * x.x + u.d


def test_the_logistic_map_of_points_and_of_multiples_of_dt():
    model = map_of(lambda t, x, u, p: 3.75 * x.x * (1.0 - x.x), dt=1.0)
    tube = clpt.enclose(model, [2.0, 4.0, 9.0], initial_state=[0.3])
    x, orbit = mpmath.mpf(0.3), []
    with mpmath.workdps(300):
        for _ in range(8):
            orbit.append(x)
            x = mpmath.mpf(3.75) * x * (1 - x)
        for k, step in enumerate((0, 2, 7)):
            bounds = [tube.lower[k, 0], tube.upper[k, 0]]
            assert contains(bounds, orbit[step])
            assert float(bounds[1] - bounds[0]) < 1e-12
        between = [tube.over_lower[2, 0], tube.over_upper[2, 0]]
        assert contains(between, *orbit[2:8])
    set_of = clpt.enclose(model, [0.0, 3.0], initial_state=[(0.3, 0.31)])
    assert set_of.lower[1, 0] <= float(orbit[3]) <= set_of.upper[1, 0]


MAPS = {
    "grows": (lambda t, x, u, p: x.x * x.x, [10.0], 8),
    "a divisor of 0": (lambda t, x, u, p: 1.0 / (x.x - 3.0), [3.0], 0),
    "a set with a divisor of 0": (lambda t, x, u, p: 1.0 / x.x, [(-1, 2)], 0),
    "no number": (lambda t, x, u, p: x.x * np.nan, [1.0], 0),
    "a root below 0": (lambda t, x, u, p: np.sqrt(x.x) - 2.0, [1.0], 1),
    "a logarithm of 0": (lambda t, x, u, p: np.log(x.x), [1.0], 1),
}


@pytest.mark.parametrize("trap", MAPS)
def test_a_map_ends_with_a_time_and_a_sentence(trap):
    function, start, last = MAPS[trap]
    tube = clpt.enclose(map_of(function), 0.5 * np.arange(12), initial_state=start)
    assert tube.attrs["status"] == "stopped"
    assert f"to t = {0.5 * last:g}; the boxes end there, as" in tube.message
    assert np.isfinite(tube.upper[: last + 1]).all()
    assert np.isnan(tube.upper[last + 1 :]).all()
    assert np.isnan(tube.over_upper[last + 1 :]).all()


def test_a_map_that_switches_takes_in_both_sides():
    model = map_of(lambda t, x, u, p: 0.5 * x.x - np.sign(x.x))
    tube = clpt.enclose(model, [0, 0.5], initial_state=[(-1.0, 2.0)])
    assert tube.lower[1, 0] <= -1.0
    assert tube.upper[1, 0] >= 0.5
    assert "Filippov" not in tube.message


@pytest.mark.parametrize("times", [[0, 0.5, 1.0], [0, 0.25, 1.75], [0, 0.1, 0.6, 0.9]])
def test_a_sampled_controller_in_a_continuous_loop(times):
    """x' = v - x/4, w+ = w + e, v = 1.5 e + w/2, e = r - x at each multiple of 0.5."""
    error = control.summing_junction(["r", "-y"], "e", name="error")
    pi = control.ss(1, 1, 0.5, 1.5, 0.5, inputs="e", outputs="v", name="pi")
    tank = control.ss(-0.25, 1, 1, 0, inputs="v", outputs="y", name="tank")
    loop = clpt.connect([error, pi, tank], external="r")
    tube = clpt.enclose(loop, times, 1.0, {"tank_x[0]": 0.25})
    bounds = {name: tube.sel(name=name) for name in ("tank_x[0]", "v[0]")}
    with mpmath.workdps(40):
        x, w, t, v = mpmath.mpf(0.25), mpmath.mpf(0), mpmath.mpf(0), None
        row = 0
        for k in range(5):
            v = (1 - x) * 3 / 2 + w / 2
            while row < len(times) and times[row] < 0.5 * (k + 1):
                decay = mpmath.exp(-(mpmath.mpf(times[row]) - t) / 4)
                exact = {"tank_x[0]": x * decay + 4 * v * (1 - decay), "v[0]": v}
                for name, value in exact.items():
                    both = bounds[name].lower[row], bounds[name].upper[row]
                    assert contains(both, value)
                    assert float(both[1] - both[0]) < 1e-13
                row += 1
            w, t = w + 1 - x, t + mpmath.mpf(0.5)
            decay = mpmath.exp(-mpmath.mpf(1) / 8)
            x = x * decay + 4 * v * (1 - decay)
    # both the output before the sample and that after it are in the interval
    assert np.all(tube.over_lower[1:] <= np.minimum(tube.lower[1:], tube.lower[:-1]))


def test_a_parameter_of_a_sampled_controller_is_an_interval():
    controller = clpt.Block(
        "c",
        update=lambda t, x, u, p: x.v * 0.0 - p.k * u.e,
        inputs={"e": 1},
        outputs={"v": 1},
        output=lambda t, x, u, p: x.v,
        states={"v": 1},
        parameters={"k": 1.0},
        dt=1.0,
    )
    plant = clpt.Block(
        "p",
        update=lambda t, x, u, p: u.v,
        inputs={"v": 1},
        outputs={"e": 1},
        output=lambda t, x, u, p: x.e,
        states={"e": 1},
    )
    loop = clpt.connect([controller, plant])
    tube = clpt.enclose(loop, [0, 1, 2, 2.5], None, {"p_e": 1.0}, {"c.k": (0.25, 0.5)})
    final = tube.sel(name="p_e[0]")
    # 0 until 1, then -k e(0): e(2) = 1 - k, e(2.5) = 1 - k - k/2
    assert np.all(final.lower[1:] <= [1.0, 0.5, 0.25])
    assert np.all(final.upper[1:] >= [1.0, 0.75, 0.625])
    assert float(final.upper[-1] - final.lower[-1]) < 0.376


def kicked(jump):
    """Return x' = -x with a jump of x at each multiple of 0.5."""
    return block(
        lambda t, x, u, p: -x.x,
        1,
        jump=jump,
        breakpoints=lambda p, t0, t1: (
            np.arange(1, 9)[
                (0.5 * np.arange(1, 9) > t0) & (0.5 * np.arange(1, 9) <= t1)
            ]
            * 0.5
        ),
        parameters={"interval": -1.0},
    )


def test_jumps_at_known_times_also_at_the_end():
    model = kicked(lambda t, x, u, p: {"x": x.x * x.x + 1.0})
    tube = clpt.enclose(model, [0, 0.5, 1.0], initial_state=[1.0])
    with mpmath.workdps(40):
        half = mpmath.exp(-mpmath.mpf(0.5))
        first = half * half + 1
        last = (first * half) ** 2 + 1
        assert inside(tube, 1, [first])
        assert inside(tube, 2, [last])
        assert contains([tube.over_lower[1, 0], tube.over_upper[1, 0]], half, 1, first)
    assert float((tube.upper - tube.lower).max()) < 1e-13


def test_a_jump_without_bounds_ends_the_boxes_before_it():
    model = kicked(lambda t, x, u, p: {"x": 1.0 / (x.x - np.exp(-0.5))})
    tube = clpt.enclose(model, [0, 0.25, 0.5, 0.75], initial_state=[1.0])
    assert "to t = 0.5; the boxes end there, as" in tube.message
    assert np.isnan([*tube.upper[2:, 0], *tube.over_upper[2:, 0]]).all()
    assert np.isfinite(tube.over_upper[:2]).all()


# --- pieces, and sets that come back -------------------------------------------------------------


def test_pieces_tighten_the_boxes_and_leave_nothing_out():
    """x = x0 exp(-k t), from 1 exp(-1.1) to 2 exp(-0.9)."""
    start, params, width = [(1.0, 2.0)], {"model.k": (0.9, 1.1)}, []
    for pieces in (1, 4, 8):
        tube = clpt.enclose(of_decay(), [0, 1], 0.0, start, params, pieces=pieces)
        with mpmath.workdps(40):
            assert inside(tube, 1, [mpmath.exp(-mpmath.mpf(1.1))])
            assert inside(tube, 1, [2 * mpmath.exp(-mpmath.mpf(0.9))])
        width.append(float(tube.upper[1, 0] - tube.lower[1, 0]))
    assert width[0] > width[1] > width[2]
    assert width[2] < 1.04 * (2 * math.exp(-0.9) - math.exp(-1.1))
    assert tube.message.endswith("to t = 1, in 8 pieces")


@pytest.mark.long
def test_the_earliest_end_of_a_piece_counts():
    """x = x0/(1 - x0 t) leaves all bounds at 1/x0."""
    model = block(lambda t, x, u, p: x.x * x.x, 1)
    times = np.linspace(0, 1.5, 16)
    tube = clpt.enclose(model, times, None, [(0.5, 1.0)], pieces=6)
    end = float(tube.message.split("to t = ")[1].split(",")[0])
    assert "in 6 pieces; the boxes end there, as" in tube.message
    assert 0.8 < end <= 1.0
    reached = times <= end
    assert np.all(tube.lower[reached, 0] <= 0.5 / (1 - 0.5 * times[reached]))
    assert np.all(tube.upper[reached, 0] >= 1.0 / (1 - times[reached]))
    assert np.isnan(tube.upper[~reached]).all()


def test_a_point_and_noise_have_no_pieces():
    given = of_decay(), [0, 1], {"d": (0.4, 0.6)}, [1.0]
    one, more = (clpt.enclose(*given, pieces=pieces) for pieces in (1, 4))
    assert one.identical(more)
    with pytest.raises(clpt.ArgumentError, match="pieces = 0: must be a whole number"):
        clpt.enclose(*given, pieces=0)


@pytest.mark.long
def test_the_box_of_van_der_pol_reaches_7_in_pieces():
    """ARCH competition 2018, mu = 1: y < 2.75."""
    model = block(lambda t, x, u, p: [x[1], (1 - x[0] ** 2) * x[1] - x[0]])
    start = [(1.25, 1.55), (2.25, 2.35)]
    times = np.linspace(0, 7, 71)
    tube = clpt.enclose(model, times, None, start, pieces=16)
    assert tube.status == "finished"
    assert float(tube.over_upper[:, 1].max()) < 2.75
    for corner in itertools.product(*start):
        run = clpt.simulate(model, times, None, corner, rtol=1e-12, atol=1e-13)
        states = run.states.values
        assert np.all(tube.lower.values <= states + 1e-9)
        assert np.all(tube.upper.values >= states - 1e-9)


def damped(t, x, u, p):
    return {"a": x.w, "w": -np.sin(x.a) - x.w}


def test_a_set_that_comes_back_into_the_region_of_a_verdict():
    def V(s):
        return 0.75 * s.a**2 + 0.5 * s.a * s.w + 0.5 * s.w**2

    model = clpt.Block(
        "pendulum",
        update=damped,
        output=lambda t, x, u, p: V(x),
        states={"a": 1, "w": 1},
        outputs={"V": 1},
    )
    box = {"a": (-0.8, 0.8), "w": (-0.8, 0.8)}
    tube = clpt.enclose(model, [0, 1, 2, 3, 4], None, box)
    assert "; at t = 3 all states are within the bounds that they began" in tube.message
    within = {"a": (-1, 1), "w": (-1, 1)}
    verdict = clpt.lyapunov(model, V, within=within)
    V_of_box = tube.upper.sel(name="V[0]").values
    assert V_of_box[0] > 1.0 > verdict.level > 0.4 > V_of_box[-1]
    # a box that grows does not come back
    grows = block(lambda t, x, u, p: x.x)
    tube = clpt.enclose(grows, [0, 1], None, [(-1.0, 1.0), 0.0])
    assert "all states are within" not in tube.message


def test_outputs_of_a_small_set_have_bounds_by_their_slopes():
    """y = x w and s = x + w of an oscillator: both are known at each time."""
    model = clpt.Block(
        "model",
        update=oscillator,
        output=lambda t, x, u, p: {"y": x.x[0] * x.x[1], "s": x.x[0] + x.x[1]},
        states={"x": 2},
        outputs={"y": 1, "s": 1},
    )
    times = np.linspace(0, 3, 7)
    start = [(0.99, 1.01), (-0.01, 0.01)]
    tube = clpt.enclose(model, times, None, start)
    c, s = np.cos(times), np.sin(times)
    for x, w in itertools.product(*start):
        now = x * c + w * s, w * c - x * s
        for name, value in (("y[0]", now[0] * now[1]), ("s[0]", now[0] + now[1])):
            row = tube.sel(name=name)
            assert np.all(row.lower <= value + 1e-15)
            assert np.all(row.upper >= value - 1e-15)
    row = tube.sel(name="s[0]")
    exact = 0.02 * (np.abs(c - s) + np.abs(c + s))
    assert np.all(row.upper - row.lower < exact * (1 + 1e-9))


def test_limits_may_be_infinite_and_other_numbers_may_not():
    def limited(t, x, u, p):
        return -np.clip(x.x, p.least, p.most)

    model = block(limited, 1, parameters={"least": -np.inf, "most": np.inf})
    tube = clpt.enclose(model, [0, 1], None, [1.0])
    with mpmath.workdps(40):
        assert inside(tube, 1, [mpmath.exp(-1)])
    for rate in (
        lambda t, x, u, p: np.mod(x.x, p.most),
        lambda t, x, u, p: np.exp(-p.most) + 0 * x.x,
        lambda t, x, u, p: np.minimum(x.x, p.most * 0.0),
    ):
        model = block(rate, 1, parameters={"most": np.inf})
        tube = clpt.enclose(model, [0, 1], None, [1.0])
        assert "the boxes end there, as" in tube.message
        assert np.isnan(tube.upper[1]).all()


class Rises:
    """Breakpoints where the input `go` rises."""

    trigger = "go"

    def __call__(self, p, t0, t1):
        return np.zeros(0)

    def after(self, p, rises):
        return rises


def test_jumps_where_an_input_rises_need_a_known_input():
    model = clpt.Block(
        "model",
        update=lambda t, x, u, p: -x.x,
        states={"x": 1},
        inputs={"go": 1},
        jump=lambda t, x, u, p: {"x": x.x + 1.0},
        breakpoints=Rises(),
        parameters={"interval": -1.0},
    )
    loop = clpt.connect([model], external="go")
    tube = clpt.enclose(loop, [0, 0.5, 1, 2], {"go": [0, 0, 1, 1]}, [1.0])
    with mpmath.workdps(40):
        first = mpmath.exp(-1) + 1
        assert inside(tube, 2, [first])
        assert inside(tube, 3, [first * mpmath.exp(-1)])
    with pytest.raises(clpt.SimulationError, match="where an input may rise"):
        clpt.enclose(loop, [0, 1], {"go": (0, 1)}, [1.0])
