"""Models in Python have the events, jumps, methods and errors of machine code: closed forms."""

import _thread
import math
import random
import threading
import time

import control
import numpy as np
import pytest
from engine_runs import PythonDiagram
from scipy.integrate import solve_ivp
from text_systems import ticking

import clpt_control as clpt
from benchmarks.stiff_problems import PROBLEMS
from clpt_control import Block, Guard

G = 9.81
every_engine = pytest.mark.parametrize("engine", ["native", "python"])


def simulate(model, times, start, engine="python", **more):
    return clpt.simulate(
        model, times, initial_state=start, engine=engine, rtol=1e-9, **more
    )


def ball(name="ball", r=0.8):
    return Block(
        name,
        states={f"{name}_h": 1, f"{name}_v": 1},
        update=lambda t, x, u, p: [x[1], -G],
        jump=lambda t, x, u, p: [0.0, -p.r * x[1]],
        parameters={"r": r},
        guard=Guard(lambda t, x, u, p: x[0], "jump"),
    )


def bouncing(t, h, r):
    """Return height and velocity of a ball that was at rest at a height."""
    v = np.sqrt(2 * G * h)
    t = t - v / G
    if t < 0.0:
        return h - 0.5 * G * (t + v / G) ** 2, -G * (t + v / G)
    while t >= 2 * r * v / G:
        v *= r
        t -= 2 * v / G
    return r * v * t - 0.5 * G * t**2, r * v - G * t


def moving(distance, policy="stop", rates=lambda t, x, u, p: [1.0], **more):
    guard = Guard(distance, policy, lambda t, u, p: f"left at {t:.6g}")
    return Block("cart", update=rates, states={"s": 1}, guard=guard, **more)


# --- guards -------------------------------------------------------------------------------------

# distance of s = t, and the time at which it is left
DISTANCES = {
    "straight": (lambda t, x, u, p: 1.25 - x[0], 1.25),
    "curved": (lambda t, x, u, p: 2.0 - np.exp(x[0]), np.log(2.0)),
    "left and entered again": (lambda t, x, u, p: (x[0] - 1.0) ** 2 - 1e-4, 0.99),
    "by an if": (lambda t, x, u, p: 1.0 if x[0] < 0.7 else -1.0, 0.7),
    "of time": (lambda t, x, u, p: np.cos(t), np.pi / 2),
    "large numbers": (lambda t, x, u, p: 1e9 + 1.5e9 - 1e9 * (x[0] + 1.0), 1.5),
    "small numbers": (lambda t, x, u, p: 1.5e-12 - 1e-12 * x[0], 1.5),
}


@every_engine
@pytest.mark.parametrize("name", DISTANCES)
def test_a_guard_stops_where_it_is_left(name, engine):
    distance, left = DISTANCES[name]
    run = simulate(moving(distance), np.linspace(0.0, 4.0, 9), [0.0], engine)
    assert run.attrs["status"] == "stopped"
    np.testing.assert_allclose(run.time[-1], left, atol=1e-9)
    np.testing.assert_allclose(run.s.values.ravel(), run.time, atol=1e-9)


@every_engine
def test_late_times_and_short_runs(engine):
    begin = 1e6
    block = moving(lambda t, x, u, p: 0.5 - x[0])
    run = simulate(block, [begin, begin + 2.0], [0.0], engine)
    np.testing.assert_allclose(run.time[-1] - begin, 0.5, atol=1e-8)
    run = simulate(moving(lambda t, x, u, p: 5e-7 - x[0]), [0.0, 1e-6], [0.0], engine)
    np.testing.assert_allclose(run.time[-1], 5e-7, atol=1e-15)


@every_engine
def test_a_run_at_rest_on_the_edge_goes_on(engine):
    block = moving(lambda t, x, u, p: 1.0 - x[0], rates=lambda t, x, u, p: [1.0 - x[0]])
    run = simulate(block, [0.0, 60.0], [1.0], engine)
    assert run.attrs["status"] == "finished"
    assert run.attrs["solver_steps"] < 2_000


@pytest.mark.filterwarnings("ignore:the run ends at its start")
@every_engine
@pytest.mark.parametrize("policy", ["stop", "raise"])
def test_a_guard_that_is_left_where_the_run_begins(policy, engine):
    block = moving(lambda t, x, u, p: -1.0 - x[0], policy)
    if policy == "raise":
        with pytest.raises(clpt.SimulationError, match=r"^left at 0"):
            simulate(block, [0.0, 1.0], [0.0], engine)
        return
    run = simulate(block, [0.0, 1.0], [0.0], engine)
    assert (run.attrs["status"], run.time.values.tolist()) == ("stopped", [0.0])


@every_engine
def test_the_first_of_two_guards_stops_the_run(engine):
    carts = [
        Block(
            name,
            update=lambda t, x, u, p: [1.0],
            states={name: 1},
            parameters={"end": end},
            guard=Guard(
                lambda t, x, u, p: p.end - x[0], "stop", lambda t, u, p: "left"
            ),
        )
        for name, end in (("far", 2.0), ("near", 1.0))
    ]
    run = simulate(clpt.connect(carts), [0.0, 3.0], [0.0, 0.0], engine)
    np.testing.assert_allclose(run.time[-1], 1.0, atol=1e-9)


@every_engine
def test_stop_of_a_model_that_python_control_has(engine):
    """x = cos t falls to 1/2 at pi/3."""
    swing = control.nlsys(
        lambda t, x, u, p: [x[1], -x[0]], inputs=0, outputs=2, states=2, name="swing"
    )
    stop = lambda t, y, u: y[0] - 0.5  # noqa: E731
    run = simulate(swing, np.linspace(0.0, 9.0, 10), [1.0, 0.0], engine, stop=stop)
    np.testing.assert_allclose(run.time[-1], np.pi / 3, atol=1e-8)
    np.testing.assert_allclose(run.states[:, 0], np.cos(run.time), atol=1e-8)


@every_engine
def test_a_guard_of_an_input_that_jumps_up_and_down(engine):
    """The input is 1 at one sample, and passes 1/2 halfway before it."""
    block = moving(lambda t, x, u, p: 0.5 - u[0], inputs={"force": 1})
    times = np.linspace(0.0, 10.0, 101)
    pulse = np.where(np.arange(101) == 50, 1.0, 0.0)
    run = clpt.simulate(block, times, pulse, [0.0], engine=engine)
    np.testing.assert_allclose(run.time[-1], 4.95, atol=1e-9)


@every_engine
def test_a_stiff_model_stops_at_its_guard(engine):
    rates = lambda t, x, u, p: [-1e6 * (x[0] - np.sin(t)) + np.cos(t)]  # noqa: E731
    block = moving(lambda t, x, u, p: 0.5 - x[0], rates=rates)
    run = simulate(block, np.linspace(0.0, 2.0, 21), [0.0], engine)
    np.testing.assert_allclose(run.time[-1], np.arcsin(0.5), atol=1e-8)
    assert run.attrs["solver_steps"] < 2_000


# --- jumps --------------------------------------------------------------------------------------


@every_engine
def test_a_bouncing_ball(engine):
    times = np.append(np.linspace(0.0, 3.0, 31), 3.2)
    run = simulate(ball(), times, [1.0, 0.0], engine)
    expected = [bouncing(t, 1.0, 0.8) for t in times]
    np.testing.assert_allclose(run.states.values, expected, atol=1e-8)
    assert run.attrs["method"] == "DOP853, 7 jumps at levels"


@every_engine
def test_a_sample_at_a_jump_is_behind_it(engine):
    """s = t is set back by 1 whenever it is 1."""
    saw = Block(
        "saw",
        update=lambda t, x, u, p: [1.0],
        states={"s": 1},
        jump=lambda t, x, u, p: [x[0] - 1.0],
        guard=Guard(lambda t, x, u, p: 1.0 - x[0], "jump"),
    )
    run = simulate(saw, [0.0, 0.5, 1.0, 1.5, 2.0, 2.75], [0.0], engine)
    expected = [0.0, 0.5, 0.0, 0.5, 0.0, 0.75]
    np.testing.assert_allclose(run.s.values.ravel(), expected, atol=1e-9)


@every_engine
def test_balls_that_land_at_one_instant(engine):
    balls = clpt.connect([ball("a", 0.8), ball("b", 0.5)])
    times = np.linspace(0.0, 1.2, 7)
    run = simulate(balls, times, [1.0, 0.0, 1.0, 0.0], engine)
    for name, r in (("a", 0.8), ("b", 0.5)):
        expected = [bouncing(t, 1.0, r)[0] for t in times]
        np.testing.assert_allclose(run[f"{name}_h"].values.ravel(), expected, atol=1e-8)


@every_engine
def test_jumps_without_end(engine):
    with pytest.raises(clpt.SimulationError, match="ball jumps at its level without"):
        simulate(ball(r=0.5), [0.0, 20.0], [1.0, 0.0], engine)


@every_engine
def test_a_run_that_begins_outside_of_its_level(engine):
    with pytest.raises(clpt.SimulationError, match="begins outside of the guard"):
        simulate(ball(), [0.0, 1.0], [-1.0, 0.0], engine)


@every_engine
def test_a_jump_in_time_at_the_instant_of_a_level(engine):
    """A clock resets s at t = 1, 2, ...; its level of 1 is met at the same instants."""

    def jump(t, x, u, p):
        return [x[0] - 1.0, x[1] + 1.0]

    saw = Block(
        "saw",
        update=lambda t, x, u, p: [1.0, 0.0],
        states={"s": 1, "count": 1},
        jump=jump,
        guard=Guard(lambda t, x, u, p: 1.0 - x[0], "jump"),
    )
    tick = ticking(
        lambda t, x, u, p: 0.0,
        lambda t, x, u, p: x + 1.0,
        "clock",
        outputs={"y": 1},
        output=lambda t, x, u, p: x,
    )
    run = simulate(clpt.connect([saw, tick]), [0.0, 1.0, 2.5], [0.0] * 3, engine)
    np.testing.assert_allclose(run.s.values.ravel(), [0.0, 0.0, 0.5], atol=1e-9)
    np.testing.assert_array_equal(run["count"].values.ravel(), [0.0, 1.0, 2.0])
    np.testing.assert_array_equal(run.y.values.ravel(), [0.0, 1.0, 2.0])


# --- samples, inputs, methods -------------------------------------------------------------------


@pytest.mark.parametrize("method", ["dop853", "rodas5p", "auto"])
def test_methods_and_samples(method):
    times = np.linspace(0.0, 5.0, 501)
    model = control.nlsys(
        lambda t, x, u, p: [-x[0], np.cos(t)], inputs=0, outputs=2, states=2, name="m"
    )
    run = simulate(model, times, [1.0, 0.0], method=method)
    expected = np.column_stack([np.exp(-times), np.sin(times)])
    np.testing.assert_allclose(run.states, expected, atol=2e-8)
    name = "Rodas5P" if method == "rodas5p" else "DOP853"
    assert run.attrs["method"] == name
    assert run.attrs["engine"].startswith("python")


@every_engine
def test_inputs_that_bend_and_a_sample_at_each_bend(engine):
    """x' = u is the integral of straight lines."""
    times = np.array([0.0, 1.0, 1.0 + 1e-9, 2.0, 5.0])
    u = np.array([0.0, 0.0, 3.0, 3.0, -3.0])
    model = control.nlsys(
        lambda t, x, u, p: [u[0]], inputs=1, outputs=1, states=1, name="sum"
    )
    run = clpt.simulate(model, times, u, [0.0], engine=engine)
    areas = 0.5 * (u[1:] + u[:-1]) * np.diff(times)
    expected = np.append(0.0, np.cumsum(areas))
    np.testing.assert_allclose(run.states[:, 0], expected, atol=1e-9)


def test_a_part_with_times_of_its_own_beside_a_model_in_python():
    """A relay of time turns at t = 1 and 2; s is the integral of 1, -1, 1."""
    turning = Block(
        "turning",
        output=lambda t, x, u, p: [1.0 - 2.0 * (p.interval % 2)],
        outputs={"y": 1},
        parameters={"interval": -1.0},
        breakpoints=lambda p, t0, t1: np.array([t for t in (1.0, 2.0) if t0 < t <= t1]),
    )
    total = Block(
        "total", update=lambda t, x, u, p: u.y, states={"s": 1}, inputs={"y": 1}
    )
    times = np.linspace(0.0, 3.0, 13)
    run = simulate(clpt.connect([turning, total]), times, [0.0])
    expected = np.interp(times, [0.0, 1.0, 2.0, 3.0], [0.0, 1.0, 0.0, 1.0])
    np.testing.assert_allclose(run.s.values.ravel(), expected, atol=1e-12)
    assert run.attrs["solver_restarts"] == 3


def test_taylor_is_refused():
    with pytest.raises(clpt.SimulationError, match="'taylor' does not take this model"):
        simulate(ball(), [0.0, 1.0], [1.0, 0.0], method="taylor")


@pytest.mark.parametrize("name", ["van der Pol", "Robertson", "HIRES"])
@pytest.mark.parametrize("rtol", [1e-6, 1e-8])
def test_a_stiff_model_takes_at_most_half_more_evaluations_than_lsoda(name, rtol):
    """LSODA at a thirtieth of the tolerances, whose error is below the tolerances."""
    problem = PROBLEMS[name]
    atol = rtol * problem.absolute
    lsoda = solve_ivp(
        lambda t, x: problem.rates(t, x, None, None),
        (0.0, problem.end),
        problem.start,
        "LSODA",
        rtol=rtol / 30,
        atol=atol / 30,
        max_step=problem.end / 256,
    )
    count = [0]

    def rates(t, x, u, p):
        count[0] += 1
        return problem.rates(t, x, u, p)

    block = Block("stiff", update=rates, states={"s": len(problem.start)})
    times = np.linspace(0.0, problem.end, 51)
    run = PythonDiagram(block).run(problem.start, times, rtol=rtol, atol=atol)
    assert count[0] < 1.5 * lsoda.nfev
    assert run.statistics["evaluations"] == pytest.approx(count[0], rel=0.02)
    error = np.abs(run.x[-1] - problem.exact)
    assert (error / (atol + rtol * np.abs(problem.exact))).max() < 10.0


# --- errors -------------------------------------------------------------------------------------

ROLES = ["update", "output", "guard", "jump"]


def failing(role, error, count):
    """A ball one of whose functions raises an error behind t = 0.3, before or at its landing."""

    def function(values, is_role):
        def wrapped(t, x, u, p):
            if is_role and t > 0.3:
                count[0] += 1
                raise error("no more")
            return values(t, x)

        return wrapped

    functions = {
        "update": lambda t, x: [x[1], -G],
        "output": lambda t, x: [x[0]],
        "guard": lambda t, x: x[0],
        "jump": lambda t, x: [0.0, -x[1]],
    }
    wrapped = {
        name: function(values, name == role) for name, values in functions.items()
    }
    wrapped["guard"] = Guard(wrapped["guard"], "jump")
    return Block("ball", states={"h": 1, "v": 1}, outputs={"y": 1}, **wrapped)


@pytest.mark.parametrize("role", ROLES)
@pytest.mark.parametrize("error", [KeyboardInterrupt, TypeError])
def test_an_exception_ends_the_run(role, error):
    """Once; no function is called after it."""
    count = [0]
    expected = clpt.ClptError if error is TypeError else error
    with pytest.raises(expected, match="no more") as caught:
        PythonDiagram(failing(role, error, count)).run([1.0, 0.0], [0.0, 2.0])
    assert count == [1]
    if error is TypeError:
        assert f"ball.{role}" in str(caught.value)


@pytest.mark.filterwarnings("error")
def test_ctrl_c_at_any_time():
    """Each is raised, also one that arrives between two calls of the model."""
    random.seed(5)
    model = control.nlsys(
        lambda t, x, u, p: [x[1], -x[0]], inputs=0, outputs=2, states=2, name="swing"
    )
    for _ in range(20):
        timer = threading.Timer(random.uniform(0.01, 0.03), _thread.interrupt_main)
        timer.start()
        with pytest.raises(KeyboardInterrupt):
            simulate(model, [0.0, 1e6], [1.0, 0.0], max_step=1e-2)
        timer.join()


def test_a_run_after_a_failed_one():
    count = [0]
    runner = PythonDiagram(failing("update", TypeError, count))
    for _ in range(2):
        with pytest.raises(clpt.ClptError):
            runner.run([1.0, 0.0], [0.0, 2.0])
        run = runner.run([1.0, 0.0], [0.0, 0.25])
        np.testing.assert_allclose(run.x[-1, 0], 1.0 - 0.5 * G / 16, atol=1e-9)


def test_a_number_that_is_not_finite_names_its_signal():
    with np.errstate(all="raise"):  # is not that of the functions
        block = moving(
            lambda t, x, u, p: 9.0,
            rates=lambda t, x, u, p: np.log(1.0 - x) - np.log(1.0 - x) + 1.0,
        )
        with pytest.raises(
            clpt.SimulationError, match=r"derivative of s\[0\] of block cart"
        ):
            simulate(block, [0.0, 2.0], [0.0])


def test_steps_beyond_an_edge_of_numbers_are_tried_again():
    """x' = -sqrt(x) has x = (1 - t/2)^2; math.sqrt raises an error below 0."""
    model = control.nlsys(
        lambda t, x, u, p: [-math.sqrt(x[0])],
        inputs=0,
        outputs=1,
        states=1,
        name="tank",
    )
    run = simulate(model, [0.0, 1.0, 1.9], [1.0])
    np.testing.assert_allclose(run.states[:, 0], [1.0, 0.25, 0.0025], atol=1e-8)


def test_a_guard_that_is_not_a_number():
    block = moving(lambda t, x, u, p: np.nan if x[0] > 0.5 else 1.0)
    with pytest.raises(clpt.SimulationError, match="guard of cart is not a number"):
        simulate(block, [0.0, 1.0], [0.0])


def test_a_model_that_simulates_another_one():
    """x[k+1] = y(1), where y' = -y begins at x[k]."""
    inner = control.nlsys(
        lambda t, x, u, p: [-x[0]], inputs=0, outputs=1, states=1, name="inner"
    )

    def update(t, x, u, p):
        return simulate(inner, [0.0, 1.0], [float(x[0])]).states.values[-1]

    sizes = {"inputs": 0, "outputs": 1, "states": 1, "dt": 1.0}
    outer = control.nlsys(update, None, **sizes, name="outer")
    run = clpt.simulate(outer, [0.0, 1.0, 2.0, 3.0], None, [1.0], engine="python")
    np.testing.assert_allclose(run.states[:, 0], np.exp(-run.time), atol=1e-8)


def test_threads():
    def work(k):
        model = control.nlsys(
            lambda t, x, u, p: [-k * x[0]], inputs=0, outputs=1, states=1, name="m"
        )
        found[k] = float(simulate(model, [0.0, 1.0], [1.0]).states[-1, 0])

    found = {}
    threads = [threading.Thread(target=work, args=(k,)) for k in range(1, 5)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    for k in range(1, 5):
        np.testing.assert_allclose(found[k], np.exp(-k), atol=1e-8)


def test_progress_is_shown_as_a_run_goes():
    seen = []
    model = control.nlsys(
        lambda t, x, u, p: time.sleep(1e-5) or [-x[0]],
        inputs=0,
        outputs=1,
        states=1,
        name="slow",
    )
    simulate(model, [0.0, 1.0], [1.0], progress=seen.append)
    assert seen == sorted(seen)
    assert seen[-1] == 1.0


@pytest.mark.long
def test_a_relay_that_chatters_ends_with_a_sentence():
    """In Python no run slides on a switch; it would take hours."""
    relay = control.nlsys(
        lambda t, x, u, p: [0.5 - np.sign(x[0])], inputs=0, outputs=1, states=1
    )
    with pytest.raises(clpt.SimulationError, match="too many steps"):
        clpt.simulate(relay, [0.0, 2.0], None, [0.5], engine="python")


def test_slow_functions_take_the_same_steps():
    """Calls of the solver are as many tries long on a busy machine: no number changes."""
    problem, found = PROBLEMS["HIRES"], []
    for pause in (0.0, 2e-4):
        slept = lambda t, x, u, p: time.sleep(pause) or problem.rates(t, x, u, p)  # noqa: B023, E731
        block = Block("slow", update=slept, states={"s": 8})
        run = PythonDiagram(block).run(problem.start, [0.0, 5.0], rtol=1e-4, atol=1e-4)
        found.append((run.x.tolist(), run.method, run.statistics["steps"]))
    assert found[0] == found[1]
