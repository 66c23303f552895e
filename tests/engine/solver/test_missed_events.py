"""No sign change within a step is missed: cases that were silently wrong, against closed forms."""

import control
import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

import clpt_control as clpt

G = 9.81


def model(rates, n, **options):
    return control.nlsys(
        rates, None, inputs=0, states=n, outputs=n, name="m", **options
    )


def final(rates, start, end, **options):
    """Return the last state of a run by machine code."""
    times = np.atleast_1d(end) if np.ndim(end) else [0.0, end]
    run = clpt.simulate(model(rates, len(start)), times, None, start, **options)
    assert run.attrs["engine"] == "native"
    return run.states.values[-1]


# --- something steps while a run slides ------------------------------------------------------

T = np.linspace(0.0, 4.0, 17)


def held_at_a_set_point():
    """x' = -2 sign(x - ref) + 0.5 cos t, where ref steps from 0 to 1 at t = 2."""
    rises = lambda t: 2.0 * (t - 2.0) + 0.5 * (np.sin(t) - np.sin(2.0))  # noqa: E731
    falls = lambda t: 0.3 - 2.0 * t + 0.5 * np.sin(t)  # noqa: E731
    first = brentq(falls, 0.0, 1.0)
    reach = brentq(lambda t: rises(t) - 1.0, 2.0, 4.0)
    return np.select([first > T, T < 2.0, reach > T], [falls(T), 0.0, rises(T)], 1.0)


REFERENCES = {
    "if": lambda t, clock: 1.0 if t > 2.0 else 0.0,
    "where": lambda t, clock: np.where(t > 2.0, 1.0, 0.0),
    "heaviside": lambda t, clock: np.heaviside(t - 2.0, 0.0),
    "floor": lambda t, clock: np.minimum(np.floor(t / 2.0), 1.0),
    "sign in sign": lambda t, clock: 0.5 + 0.5 * np.sign(t - 2.0),
    "state": lambda t, clock: 1.0 if clock > 2.0 else 0.0,
}


@pytest.mark.parametrize("name", REFERENCES)
def test_a_set_point_steps_while_the_run_slides(name):
    def rates(t, x, u, p):
        return [-2.0 * np.sign(x[0] - REFERENCES[name](t, x[1])) + 0.5 * np.cos(t), 1.0]

    run = clpt.simulate(model(rates, 2), T, None, [0.3, 0.0])
    assert "sliding" in run.attrs["method"]
    assert np.abs(run.states.values[:, 0] - held_at_a_set_point()).max() < 1e-6


def held(ref):
    return control.nlsys(
        lambda t, x, u, p: [-2.0 * np.sign(x[0] - u[0]) + 0.5 * np.cos(t)],
        None,
        inputs=ref,
        outputs="x",
        states=1,
        name="plant",
    )


def test_a_set_point_jumps_at_a_level_or_is_sampled_while_the_run_slides():
    level = clpt.Block(
        "level",
        update=lambda t, x, u, p: [0.0, 1.0],
        states={"ref": 1, "clock": 1},
        output=lambda t, x, u, p: [x[0]],
        outputs={"set": 1},
        jump=lambda t, x, u, p: [1.0, -9.0],
        guard=clpt.Guard(lambda t, x, u, p: 2.0 - x[1], "jump"),
    )
    sampled = clpt.Block(
        "sampled",
        update=lambda t, x, u, p: [x[0] + 1.0],
        states={"k": 1},
        output=lambda t, x, u, p: [1.0 if x[0] > 3.5 else 0.0],
        outputs={"set": 1},
        dt=0.5,
    )
    for block in (level, sampled):
        loop = clpt.connect([held("set"), block])
        start = [0.3, *[0.0] * (loop.nstates - 1)]
        run = clpt.simulate(loop, T, None, start)
        assert np.abs(run.states.values[:, 0] - held_at_a_set_point()).max() < 1e-6


@pytest.mark.parametrize("end", [2.0, 4.0, 10.0, 100.0])
def test_a_force_that_steps_while_friction_holds_moves_the_mass_at_once(end):
    def rates(t, x, u, p):
        return [(0.5 if t < 1 else 1.5) - np.sign(x[0])]

    # x rests from t = 0.5 to 1
    assert abs(final(rates, [0.25], end)[0] - 0.5 * (end - 1.0)) < 1e-6


def test_friction_holds_from_rest_against_a_table_of_time():
    times = np.linspace(0.0, 10.0, 11)
    forces = 0.4 * times * (times < 2.5)

    def rates(t, x, u, p):
        return [np.interp(t, times, forces) - 0.5 * np.sign(x[0])]

    # from t = 1.25 to 2 the force is 0.4 t, then it falls to 0 at t = 3; x stops by friction
    x = final(rates, [0.0], [0.0, 1.25, 2.0])
    assert abs(x[0] - (0.2 * (4.0 - 1.25**2) - 0.5 * 0.75)) < 1e-8


@pytest.mark.parametrize("unit", [1e-12, 1e-9, 1.0, 1e9])
def test_a_run_slides_along_a_curve_in_any_unit(unit):
    """x = y^2/unit is held while y grows."""

    def rates(t, x, u, p):
        return [-x[0] - 2 * unit * np.sign(x[0] - x[1] ** 2 / unit), 0.3 * unit]

    x, y = final(rates, [0.5 * unit, 0.1 * unit], 2.0, atol=1e-10 * unit) / unit
    assert abs(y - 0.7) < 1e-9
    assert abs(x - y * y) < 1e-8


# --- thresholds in any unit ------------------------------------------------------------------


@pytest.mark.parametrize("unit", [1e12, 1.0, 1e-9, 1e-12, 1e-15])
def test_small_and_large_numbers_that_are_compared_switch(unit):
    def rates(t, x, u, p):
        return [-x[0], 1.0 if unit * x[0] > 0.5 * unit else 0.0]

    assert abs(final(rates, [1.0, 0.0], 2.0)[1] - np.log(2)) < 1e-7


@pytest.mark.parametrize("size", [1e-8, 1e-10, 1e-12])
def test_a_state_far_below_atol_switches(size):
    def rates(t, x, u, p):
        return [-x[0], 1.0 if x[0] > 0.5 * size else 0.0]

    assert abs(final(rates, [size, 0.0], 2.0)[1] - np.log(2)) < 1e-3


@pytest.mark.parametrize("atol", [1e-3, 1.0, 100.0])
def test_atol_does_not_move_a_threshold(atol):
    def rates(t, x, u, p):
        return [-x[0], 1e7 if x[0] / 1e7 > 0.5 else 0.0]

    open_for = final(rates, [1e7, 0.0], 2.0, atol=atol)[1] / 1e7
    assert abs(open_for - np.log(2)) < 1e-4


# --- near the top of a path ------------------------------------------------------------------


@pytest.mark.parametrize("depth", [1e-2, 1e-3, 1e-4, 1e-5])
@pytest.mark.parametrize("rtol", [1e-6, 1e-8, 1e-10])
def test_a_threshold_near_the_top_of_a_path_is_passed(depth, rtol):
    def rates(t, x, u, p):
        return [x[1], -x[0], 1.0 if x[0] > 1.0 - depth else 0.0]

    start = [0.0, 1.0, 0.0]
    above = final(rates, start, np.pi, rtol=rtol, atol=1e-2 * rtol)[2]
    wanted = 2.0 * np.arccos(1.0 - depth)
    error_of_the_top = 30.0 * rtol / depth  # relative to the depth
    assert abs(above - wanted) < (1e-6 + error_of_the_top) * wanted


def test_at_a_loose_tolerance_the_path_of_the_run_itself_decides():
    depth, end = 1e-2, 200 * np.pi

    def rates(t, x, u, p):
        return [x[1], -x[0], 1.0 if x[0] > 1.0 - depth else 0.0]

    times = np.linspace(0.0, end, 200_001)
    start = [0.0, 1.0, 0.0]
    run = clpt.simulate(model(rates, 3), times, None, start, rtol=1e-3, atol=1e-5)
    x = run.states.values
    time_above = (x[:, 0] > 1.0 - depth).mean() * end
    assert abs(x[-1, 2] - time_above) < 0.02 * time_above


def test_a_kink_near_the_top_of_a_path_is_passed():
    def rates(t, x, u, p):
        return [x[1], -x[0], np.maximum(x[0] - 0.999, 0.0) / 1e-3**1.5]

    wide = np.arccos(0.999)
    wanted = 2.0 * (np.sin(wide) - 0.999 * wide) / 1e-3**1.5
    assert abs(final(rates, [0.0, 1.0, 0.0], np.pi)[2] - wanted) < 1e-6


@pytest.mark.parametrize("engine", ["native", "python"])
@pytest.mark.parametrize("depth", [1e-3, 3e-5, 1e-5])
def test_a_run_stops_near_the_top_of_a_path(engine, depth):
    block = clpt.Block(
        "b",
        update=lambda t, x, u, p: [np.cos(t)],
        states={"s": 1},
        guard=clpt.Guard(lambda t, x, u, p: 1.0 - depth - x[0], "stop"),
    )
    run = clpt.simulate(block, [0.0, np.pi], None, [0.0], engine=engine)
    assert abs(run.time.values[-1] - np.arcsin(1.0 - depth)) < 1e-4


@pytest.mark.parametrize("depth", [1e-3, 3e-5, 1e-5])
def test_a_guard_near_the_top_of_a_path_is_left(depth):
    block = clpt.Block(
        "b",
        update=lambda t, x, u, p: [np.cos(t), 0.0],
        states={"s": 1, "n": 1},
        jump=lambda t, x, u, p: [x[0] - 1.0, x[1] + 1.0],
        guard=clpt.Guard(lambda t, x, u, p: 1.0 - depth - x[0], "jump"),
    )
    run = clpt.simulate(block, [0.0, np.pi], None, [0.0, 0.0])
    assert run.states.values[-1, 1] == 1.0


# --- decisions that hide behind one another --------------------------------------------------


def test_a_decision_that_depends_on_another_one_is_followed():
    count = 600_000
    t = (np.arange(count) + 0.5) * 6.0 / count
    x = -2.5 + t + 0.3 * (1.0 - np.cos(t))

    def entries(t, x):
        return np.array([np.sin(3.0 * t), 0.5 * x, 0.3 - t / 3.0])

    for rounded in (np.rint, np.round, lambda v: np.floor(v + 0.5)):
        wanted = rounded(entries(t, x)).sum(0).mean() * 6.0

        def rates(t, x, u, p, rounded=rounded):
            v = np.array([np.sin(3.0 * t), 0.5 * x[0], 0.3 - t / 3.0])
            return [1.0 + 0.3 * np.sin(t), rounded(v).sum()]

        assert abs(final(rates, [-2.5, 0.0], 6.0)[1] - wanted) < 1e-4


@pytest.mark.parametrize("width", [1e-2, 1e-5, 1e-8])
def test_a_pulse_between_two_events_of_one_step_is_met(width):
    """One decision alone changes nothing; the pulse is between both."""

    def rates(t, x, u, p):
        inside = (x[0] > 0.5) & (x[0] < 0.5 + width)
        return [1.0, np.where(inside, 1.0 / width, 0.0)]

    assert abs(final(rates, [0.0, 0.0], 1.0)[1] - 1.0) < 1e-6


@pytest.mark.long
def test_pulses_of_any_width_and_place_are_met():
    random = np.random.default_rng(5)
    for k in range(60):
        place, rate = random.uniform(0.1, 0.9), random.uniform(0.5, 2.0)
        width = 10.0 ** random.uniform(-8, -1)

        def pulse(x, place=place, width=width, k=k):
            if k % 3 == 0:
                return np.where((x > place) & (x < place + width), 1.0 / width, 0.0)
            if k % 3 == 1:
                return 1.0 / width if place < x < place + width else 0.0
            return (np.sign(x - place) - np.sign(x - place - width)) / (2.0 * width)

        def rates(t, x, u, p, rate=rate, pulse=pulse):
            return [rate, rate * pulse(x[0])]

        assert abs(final(rates, [0.0, 0.0], 2.0 / rate)[1] - 1.0) < 1e-4


def test_a_force_behind_an_event_without_effect_is_met():
    """max(g, 0) times a factor: 0 at the event and at the end of the run, not between."""

    def rates(t, x, u, p):
        return [1.0, 1e3 * np.maximum(x[0] - 0.3, 0.0) * np.sin(2.0 * np.pi * t) ** 2]

    nodes, weights = np.polynomial.legendre.leggauss(60)
    s = 0.3 + 0.35 * (nodes + 1.0)
    integral = 0.35 * np.sum(weights * 1e3 * (s - 0.3) * np.sin(2.0 * np.pi * s) ** 2)
    assert abs(final(rates, [0.0, 0.0], 1.0)[1] - integral) < 1e-5


# --- guards ----------------------------------------------------------------------------------


def bell(t):
    return 0.5 - np.exp(-(((t - 3.3) / 0.1) ** 2))


def door(t):
    return -1.0 if 3.3 < t < 3.5 else 1.0


def block(distance, policy, **own):
    return clpt.Block(
        "b",
        update=lambda t, x, u, p: [1.0, 0.0],
        states={"s": 1, "n": 1},
        guard=clpt.Guard(distance, policy),
        **own,
    )


EDGES = {bell: 3.3 - 0.1 * np.sqrt(np.log(2)), door: 3.3}


@pytest.mark.parametrize("engine", ["native", "python"])
@pytest.mark.parametrize("distance", EDGES)
def test_a_guard_that_reads_time_is_left(engine, distance):
    def of_time(t, x, u, p):
        return distance(t) + 2.0 * x[1]

    options = {"initial_state": [0, 0], "engine": engine}
    stopped = clpt.simulate(block(of_time, "stop"), [0, 10], **options)
    assert abs(stopped.time.values[-1] - EDGES[distance]) < 1e-6
    with pytest.raises(clpt.SimulationError, match=r"at t = 3\.[23]"):
        clpt.simulate(block(of_time, "raise"), [0, 10], **options)
    if engine == "native":
        counts = {"jump": lambda t, x, u, p: [x[0], x[1] + 1.0]}
        jumped = clpt.simulate(block(of_time, "jump", **counts), [0, 10], **options)
        assert jumped.states.values[-1, 1] == 1.0
    plain = model(lambda t, x, u, p: [1.0], 1)
    stopped = clpt.simulate(
        plain, [0, 10], None, [0.0], stop=lambda t, y, u: distance(t), engine=engine
    )
    assert abs(stopped.time.values[-1] - EDGES[distance]) < 1e-6


def ball(distance, policy="jump", rebound=0.8):
    own = {"jump": lambda t, x, u, p: [0.0, -rebound * x[1]]}
    return clpt.Block(
        "ball",
        update=lambda t, x, u, p: [x[1], -G],
        states={"h": 1, "v": 1},
        guard=clpt.Guard(distance, policy),
        **(own if policy == "jump" else {}),
    )


def falling(t, x, u, p):
    return x[0] if x[1] < 0 else 1.0


@pytest.mark.parametrize("start", [0.0, 100.0, 1e6, 1e9])
def test_a_guard_of_one_direction_is_left_at_any_time(start):
    lands = (1.0 + np.sqrt(1.0 + 2 * G * 0.1)) / G
    times = [start, start + 1.0]
    run = clpt.simulate(ball(falling, "stop"), times, initial_state=[0.1, 1.0])
    assert abs(run.time.values[-1] - start - lands) < 1e-6 + 1e-15 * start
    last = clpt.simulate(ball(falling), times, initial_state=[0.1, 1.0])
    v = 0.8 * np.sqrt(1.0 + 2 * G * 0.1)
    flown = 1.0 - lands
    while flown > 2.0 * v / G:
        flown, v = flown - 2.0 * v / G, 0.8 * v
    h = v * flown - 0.5 * G * flown**2
    assert abs(last.states.values[-1, 0] - h) < 1e-6 + 1e-14 * start


def test_bounces_that_accumulate_end_with_a_sentence():
    with pytest.raises(clpt.SimulationError, match="without end"):
        clpt.simulate(ball(falling, rebound=0.5), [0, 5], initial_state=[1.0, 0.0])


def test_a_run_that_begins_outside_of_a_level_is_refused():
    with pytest.raises(
        clpt.SimulationError, match="begins outside of the guard of ball"
    ):
        clpt.simulate(ball(lambda t, x, u, p: x[0]), [0, 4], initial_state=[-5.0, 25.0])


def switched(distance, **own):
    jump = {"jump": lambda t, x, u, p: [x[0], 1.0]}
    return block(distance, "jump", **jump, **own)


def test_a_jump_at_the_last_sample_ends_the_run():
    def by_time(t, x, u, p):
        return (1.0 if t < 1 else -1.0) if x[1] < 0.5 else 1.0

    for times in ([0, 1, 2], [0, 1]):
        run = clpt.simulate(switched(by_time), times, initial_state=[0, 0])
        assert run.attrs["status"] == "finished"
        assert abs(run.states.values[-1, 0] - times[-1]) < 1e-9

    def by_input(t, x, u, p):
        return 0.5 - u[0] if x[1] < 0.5 else 1.0

    for times, values in (([0, 1, 1, 2], [0, 0, 1, 1]), ([0, 1, 1], [0, 0, 1])):
        mode = switched(by_input, inputs={"u": 1})
        run = clpt.simulate(mode, times, values, [0, 0])
        assert run.states.values[-1, 1] == 1.0
    v = 0.10383677554261883  # the third landing is at 6 v / G, to the last bit
    run = clpt.simulate(ball(falling, rebound=1.0), [0, 6 * v / G], None, [0, v])
    assert abs(run.states.values[-1, 0]) < 1e-9


def test_whole_periods_of_a_pulse_end_at_the_last_sample():
    run = clpt.simulate(
        model(lambda t, x, u, p: [1.0 if t % 0.1 < 0.03 else 0.0], 1),
        np.linspace(0.0, 2.0, 21),
        None,
        [0.0],
    )
    assert abs(run.states.values[-1, 0] - 0.6) < 1e-9


def test_a_guard_with_decisions_runs_as_machine_code():
    """The distances that are compared with Python's have the decisions of their own time."""

    def saw(t, x, u, p):
        return 2.5 - np.floor(x[0]) - (0.4 if x[0] > 1.5 else 0.0)

    run = clpt.simulate(block(saw, "stop"), [0, 10], initial_state=[0.3, 0])
    assert run.attrs["engine"] == "native"
    assert abs(run.time.values[-1] - 2.7) < 1e-9


# --- Python's path, and functions ------------------------------------------------------------


def test_pulses_in_python_are_not_stepped_over():
    from scipy.special import jv

    def infusion(t, x, u, p):
        python = 0.0 * jv(0, 1.0 + 0.0 * x[0])
        return [(10.0 if t % 12.0 < 0.5 else 0.0) - 0.2 * x[0] + python]

    amount = 0.0
    for begin in np.arange(0.0, 100.0, 12.0):
        amount += 50.0 * (
            np.exp(-0.2 * (99.5 - begin)) - np.exp(-0.2 * (100.0 - begin))
        )
    with pytest.warns(UserWarning, match="runs in Python"):
        run = clpt.simulate(model(infusion, 1), [0.0, 100.0], None, [0.0])
    assert abs(run.states.values[-1, 0] - amount) < 1e-3


FUNCTIONS = {
    "sign": np.sign,
    "clip": lambda v: np.clip(v, -1.0, 1.0),
    "minimum": lambda v: np.minimum(v, 0.5),
    "maximum": lambda v: np.maximum(0.5, v),
    "median": lambda v: np.median(np.array([v, 1.0, 2.0])),
    "sort": lambda v: np.sort(np.array([v, 1.0]))[-1],
}


@pytest.mark.parametrize("name", FUNCTIONS)
def test_a_number_that_is_not_finite_passes_on(name):
    """(1 - e^x)/(1 + e^x) is NaN for x > 709, which 1000 sin(pi t) passes between samples."""

    def rates(t, x, u, p):
        ratio = (1.0 - np.exp(x[1])) / (1.0 + np.exp(x[1]))
        return [FUNCTIONS[name](ratio), 1000.0 * np.pi * np.cos(np.pi * t)]

    with pytest.raises(clpt.SimulationError, match=r"t = 0\.2512.*not finite"):
        clpt.simulate(model(rates, 2), [0.0, 1.0], None, [0.0, 0.0])


def test_a_limit_of_an_infinite_number_is_the_limit():
    def rates(t, x, u, p):
        return [np.minimum(np.exp(1e4 * t), 2.0) + np.sign(-np.inf * (1.0 + x[0]))]

    assert abs(final(rates, [0.0], 1.0)[0] - 1.0) < 1e-3


@pytest.mark.parametrize("name", ["/", "%", "//", "**"])
def test_a_division_by_zero_that_is_caught_is_a_branch(name):
    operation = {
        "/": lambda t: 1 / t,
        "%": lambda t: 1 % t,
        "//": lambda t: 1 // t,
        "**": lambda t: t**-1,
    }[name]

    def rates(t, x, u, p):
        try:
            gain = operation(t)
        except ZeroDivisionError:
            gain = 5.0
        return [min(gain, 10.0) - x[0]]

    system = model(rates, 1)
    if name == "**":
        with pytest.raises(clpt.DiagramError, match="may raise in a `try`"):
            clpt.equations(system)
    else:
        assert "5" in str(clpt.equations(system))


def test_an_unsuitable_result_of_a_function_is_told():
    system = model(lambda t, x, u, p: {"a": -x[0], "b": x[0]}.values(), 2)
    with (
        pytest.warns(UserWarning, match="returns dict_values"),
        pytest.raises(clpt.ClptError, match="must return numbers"),
    ):
        clpt.simulate(system, [0.0, 1.0], None, [0.0, 1.0])


@pytest.mark.long
def test_a_controller_that_keeps_its_last_call_is_named_where_a_run_fails():
    class Pid:
        def __init__(self):
            self.last_time, self.last_error = None, 0.0

        def __call__(self, t, error):
            step = 0.0 if self.last_time is None else t - self.last_time
            slope = (error - self.last_error) / step if step > 0 else 0.0
            self.last_time, self.last_error = t, error
            return 2.0 * error + 0.1 * slope

    pid = Pid()
    system = model(lambda t, x, u, p: [pid(t, 1.0 - x[0]) - x[0]], 1)
    with (
        pytest.warns(UserWarning, match="outlives the call"),
        pytest.raises(clpt.SimulationError, match=r"'last_t.*outlives the call"),
    ):
        clpt.simulate(system, [0.0, 2.0], None, [0.0])


def test_a_table_with_given_slopes_is_read():
    from scipy.interpolate import CubicHermiteSpline

    table = CubicHermiteSpline([0, 1, 2], [0, 1, 0], [1, 0, -1])
    assert abs(final(lambda t, x, u, p: [table(t)], [0.0], 2.0)[0] - 7 / 6) < 1e-8


def test_gains_scheduled_by_two_variables_run_as_machine_code():
    plant = control.nlsys(
        lambda t, x, u, p: [x[1], u[0] - 0.2 * x[1]],
        None,
        inputs=["f"],
        outputs=["x", "v"],
        states=["x", "v"],
        name="cart",
    )
    points = [(x, v) for x in (-1.0, 1.0) for v in (-2.0, 0.0, 2.0)]
    gains = [np.array([[1.0 + 0.1 * x, 1.5 + 0.1 * v]]) for x, v in points]
    _, loop = control.create_statefbk_iosystem(
        plant, (gains, points), gainsched_indices=["x", "v"]
    )
    times = np.linspace(0.0, 3.0, 7)
    inputs = np.zeros((3, 7))
    run = clpt.simulate(loop, times, inputs, [0.5, 0.0])

    def rates(t, x):
        return [x[1], -(1.0 + 0.1 * x[0]) * x[0] - (1.7 + 0.1 * x[1]) * x[1]]

    wanted = solve_ivp(rates, (0, 3), [0.5, 0.0], "DOP853", times, rtol=1e-10)
    assert run.attrs["engine"] == "native"
    assert np.abs(run.states.values.T - wanted.y).max() < 1e-6


@pytest.mark.long
def test_a_burst_that_is_followed_by_rest_is_not_refused():
    """The burst needs 1.2 million steps in 1 s; at that pace the rest would need 1e14."""

    def rates(t, x, u, p):
        on = 1.0 if t < 1.0 else 0.0
        return [on * 7e5 * x[1], -on * 7e5 * x[0], on]

    burst = control.nlsys(rates, None, inputs=0, outputs=3, states=3, name="burst")
    for times in ([0.0, 1.0, 1e4], [0.0, 1.0, 1e8]):
        a, b, q = clpt.simulate(burst, times, None, [1, 0, 0]).states.values[-1]
        # the floor of a step is 1e-13 of the run
        assert abs(q - 1.0) < 1e-9 + 1e-13 * times[-1]
        assert abs(a * a + b * b - 1.0) < 0.02


def test_a_run_that_needs_a_day_of_steps_is_refused():
    """x'' = -1e30 x for a thousand seconds."""
    oscillator = control.ss([[0, 1], [-1e30, 0]], [[0], [1]], np.eye(2), 0, name="one")
    with pytest.raises(clpt.SimulationError, match="too many steps"):
        clpt.simulate(oscillator, [0.0, 1e3], None, [1.0, 0.0], method="dop853")
