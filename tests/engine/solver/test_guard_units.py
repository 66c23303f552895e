"""Guards in units of length from 1e-14 to 1e9 and of time: closed forms that scale with them."""

import control
import numpy as np
import pytest

import clpt_control as clpt

G = 9.81
LENGTHS = [1e-14, 1e-12, 1e-10, 1e-9, 1e-6, 1.0, 1e9]
DURATIONS = [1e-14, 1e-12, 1e-8, 1.0, 1e9]
T = np.linspace(0.0, 1.0, 9)
# thrown up from 1 at speed 1, a stone falls past 0.3 at this time
LANDING = (1.0 + np.sqrt(1.0 + 2.0 * G * 0.7)) / G

every_engine = pytest.mark.parametrize("engine", ["native", "python"])
every_length = pytest.mark.parametrize("length", LENGTHS)


def close(length):
    return {"rtol": 1e-9, "atol": 1e-11 * length}


def stone(length, duration=1.0, **given):
    gravity = G * length / duration**2
    return clpt.Block(
        "stone", update=lambda t, x, u, p: [x[1], -gravity], states={"x": 2}, **given
    )


def thrown(block, length, duration=1.0, **given):
    start = [length, length / duration]
    tolerances = {"rtol": 1e-9, "atol": 1e-11 * min(start)}
    return clpt.simulate(block, T * duration, None, start, **tolerances, **given)


def assert_landed(run, length, duration=1.0):
    assert run.attrs["status"] == "stopped"
    samples = T[T < LANDING]
    np.testing.assert_allclose(
        run.time.values / duration, [*samples, LANDING], rtol=1e-8
    )
    height = float(run.states.values[-1, 0])
    assert height / length == pytest.approx(0.3, abs=1e-8)


@every_engine
@every_length
def test_a_run_stops_and_raises_at_a_height_in_any_unit(length, engine):
    def above(t, x, u, p):
        return x[0] - 0.3 * length

    run = thrown(stone(length, guard=clpt.Guard(above, "stop")), length, engine=engine)
    assert_landed(run, length)
    system = stone(length)
    for stop in (
        lambda t, y, u: y[0] - 0.3 * length,
        lambda t, y, u: y[0] > 0.3 * length,
    ):
        assert_landed(thrown(system, length, engine=engine, stop=stop), length)
    with pytest.raises(clpt.SimulationError, match=f"at t = {LANDING:.6g}"):
        thrown(stone(length, guard=clpt.Guard(above, "raise")), length, engine=engine)


@every_engine
@pytest.mark.parametrize("duration", DURATIONS)
def test_a_run_stops_at_a_time_in_any_unit(duration, engine):
    system = stone(1.0, duration)
    run = thrown(system, 1.0, duration, engine=engine, stop=lambda t, y, u: y[0] - 0.3)
    assert_landed(run, 1.0, duration)


def test_a_small_current_stops():
    decay = control.nlsys(
        lambda t, x, u, p: [-1e-12], inputs=0, outputs=1, states=1, name="charge"
    )
    run = clpt.simulate(
        decay, [0, 1, 2], None, [1e-12], stop=lambda t, y, u: y[0] - 3e-13
    )
    np.testing.assert_allclose(run.time.values, [0.0, 0.7], rtol=1e-9)


def bouncing(t, r):
    """Height and velocity of a ball that falls from 1, flight by flight."""
    h, v, landing = 1.0, 0.0, np.sqrt(2.0 / G)
    while t >= landing:
        v = -r * (v - G * landing)
        t, h, landing = t - landing, 0.0, 2.0 * v / G
    return h + v * t - 0.5 * G * t * t, v - G * t


def ball(length, duration=1.0, floor=0.0):
    """A ball that bounces on a floor."""
    return stone(
        length,
        duration,
        jump=lambda t, x, u, p: [x[0], -0.8 * x[1]],
        guard=clpt.Guard(lambda t, x, u, p: x[0] - floor, "jump"),
    )


@every_length
@pytest.mark.parametrize("floor", [0.0, 0.7, -3.0])
def test_a_ball_bounces_in_any_unit(length, floor):
    """The height after a jump is that before it: beside the floor, by rounding."""
    block = ball(length, floor=floor * length)
    start = [(1.0 + floor) * length, 0.0]
    run = clpt.simulate(block, 2.5 * T, None, start, **close(length))
    wanted = [bouncing(t, 0.8) for t in 2.5 * T] + np.array([floor, 0.0])
    np.testing.assert_allclose(run.states.values / length, wanted, atol=1e-7)


@pytest.mark.parametrize("duration", DURATIONS)
def test_a_ball_bounces_in_any_unit_of_time(duration):
    times = 2.5 * T * duration
    tolerances = {"rtol": 1e-9, "atol": 1e-11 * min(1.0, 1.0 / duration)}
    run = clpt.simulate(ball(1.0, duration), times, None, [1.0, 0.0], **tolerances)
    wanted = [bouncing(t, 0.8) for t in 2.5 * T]
    np.testing.assert_allclose(run.states.values * [1.0, duration], wanted, atol=1e-7)


@every_length
def test_bounces_that_accumulate_end_in_any_unit(length):
    with pytest.raises(clpt.SimulationError, match="jumps at its level without end"):
        clpt.simulate(ball(length), [0.0, 20.0], None, [length, 0.0], **close(length))


@every_length
def test_a_valve_opens_and_closes_in_any_unit(length):
    """A level rises by 1 a second up to 2 and falls by 1 a second down to 1."""
    high, low = 2.0 * length, length
    valve = clpt.Block(
        "valve",
        update=lambda t, x, u, p: [x[1] * length, 0.0],
        states={"level": 1, "side": 1},
        jump=lambda t, x, u, p: [x[0], -x[1]],
        guard=clpt.Guard(
            lambda t, x, u, p: np.where(x[1] > 0, high - x[0], x[0] - low), "jump"
        ),
    )
    times = np.linspace(0.0, 9.0, 37)[1::2]
    run = clpt.simulate(valve, np.append(0.0, times), None, [1.5 * length, 1.0])
    phase = (0.5 + times) % 2.0
    wanted = np.where(phase < 1.0, 1.0 + phase, 3.0 - phase)
    np.testing.assert_allclose(run.level.values.ravel()[1:] / length, wanted, rtol=1e-8)


@every_length
def test_a_start_or_a_jump_outside_is_refused_in_any_unit(length):
    block = stone(
        length,
        jump=lambda t, x, u, p: [-1e-3 * length, -x[1]],
        guard=clpt.Guard(lambda t, x, u, p: x[0], "jump"),
    )
    for start in ([-1e-3 * length, 0.0], [length, 0.0]):
        with pytest.raises(clpt.SimulationError, match=r"outside of (its|the) guard"):
            clpt.simulate(block, T, None, start, **close(length))


@every_length
def test_a_level_has_no_width_for_others(length):
    """For linear models and for python-control."""
    block = ball(length)
    linear = clpt.linearize(block, [1e-3 * length, 0.0])
    np.testing.assert_array_equal(linear.A, [[0.0, 1.0], [0.0, 0.0]])
    with pytest.raises(clpt.DiagramError, match="jump at this point"):
        clpt.linearize(block, [0.0, length])
    with pytest.raises(clpt.ClptError, match="python-control ignores"):
        control.input_output_response(block, T, 0, [length, 0.0])


@pytest.mark.parametrize("begin", [0.0, 100.0, 1e6, 1e9])
def test_a_time_is_met_within_the_rounding_of_times(begin):
    """A comparison of time with a number has no error of integration, however late it is."""
    end = begin + 4.3
    times = [begin, begin + 5, begin + 10]
    near = 1e-14 * (begin + 10) + 1e-12

    def rates(t, x, u, p):
        return [1.0 if t > end else 0.0]

    model = control.nlsys(rates, None, inputs=0, outputs=1, states=1, name="late")
    run = clpt.simulate(model, times)
    assert run.states.values[:, 0] == pytest.approx([0, begin + 5 - end, 5.7], abs=near)
    stopped = clpt.simulate(model, times, stop=lambda t, y, u: t < end)
    assert stopped.time.values[-1] == pytest.approx(end, rel=0, abs=near)


@pytest.mark.parametrize("speed", [1e-13, 1e-10, 1e-7])
def test_a_state_that_creeps_to_a_threshold_passes_it_once(speed):
    """A distance of 1e-8 is 1e4 times its rounding, 3e-12: so exactly is the time known."""
    crossing = 1e-8 / speed

    def rates(t, x, u, p):
        return [speed, 1.0 if x[0] > 1.0 else 0.0]

    model = control.nlsys(rates, None, inputs=0, outputs=2, states=2, name="creeper")
    times = [0.0, crossing, 2.0 * crossing]
    run = clpt.simulate(model, times, None, [1.0 - 1e-8, 0.0])
    assert run.states.values[-1, 1] == pytest.approx(crossing, rel=5e-4)
    assert run.attrs["solver_steps"] < 100
