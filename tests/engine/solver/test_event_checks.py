"""Jumps of the rates that no decision announces: in Python they are found from the rates.

Each right answer is a closed form; scipy's RK45 at the same tolerance is 1e-6 to 1e-4 off.
"""

import bisect
from itertools import pairwise

import control
import numpy as np
import pytest
from scipy.integrate import solve_ivp

import clpt_control as clpt

TIMES = np.linspace(0.0, 30.0, 61)
TAU = 3.0


def held(function):
    """Return a system with x' = f(t, u) - x / 3 for one piecewise constant f."""
    rate = lambda t, x, u, p: [function(t, u) - x[0] / TAU]  # noqa: E731
    return control.nlsys(rate, None, inputs=1, outputs=1, states=1, name="tank")


def exact(cuts, value, times=TIMES):
    """Integrate x' = value - x / 3 from 0, constant between sorted cuts."""
    x, found, ends = 0.0, [], np.union1d(np.concatenate([[0.0], cuts]), times)
    states = {0.0: 0.0}
    for a, b in pairwise(ends):
        level = TAU * value(0.5 * (a + b))
        x = level + (x - level) * np.exp((a - b) / TAU)
        states[b] = x
    found = [states[t] for t in times]
    return np.array(found)


STEPS = np.array([0.0, 1.3, 2.9, 7.77, 12.0, 21.5])
LEVELS = np.array([1.0, -2.0, 0.5, 3.0, 0.0, 1.0])


def pulse(t, u):
    return float(t % 3.0 < 1.0)


def hold(t, u):
    return LEVELS[bisect.bisect_right(STEPS.tolist(), t) - 1]


def twice(t, u):
    return float(t > 4.0) + float(t > 4.0 + 1e-6)


CASES = {
    "pulses": (pulse, np.concatenate([3.0 * np.arange(11), 3.0 * np.arange(11) + 1.0])),
    "a hold": (hold, STEPS),
    "two jumps close by": (twice, np.array([4.0, 4.0 + 1e-6])),
    "a relay by a sine": (
        lambda t, u: float(np.sin(2.0 * t) > 0),
        np.arange(1, 20) * np.pi / 2,
    ),
}


@pytest.mark.parametrize("name", CASES)
@pytest.mark.parametrize("rtol", [1e-6, 1e-8])
def test_jumps_in_time(name, rtol):
    """At 1e-8 to 3e-7; at a looser tolerance no less exact than scipy's RK45."""
    function, cuts = CASES[name]
    tolerances = {"rtol": rtol, "atol": rtol / 100}
    right = exact(cuts[(cuts > 0) & (cuts < 30)], lambda t: function(t, None))
    rate = lambda t, x: [function(t, None) - x[0] / TAU]  # noqa: E731
    theirs = solve_ivp(rate, (0.0, 30.0), [0.0], t_eval=TIMES, **tolerances).y[0]
    run = clpt.simulate(
        held(function), TIMES, 0.0, [0.0], engine="python", **tolerances
    )
    error, most = (
        np.abs(one - right).max() for one in (run.states.values[:, 0], theirs)
    )
    assert error < (3e-7 if rtol < 1e-7 else 1.001 * most)


def test_inputs_that_pass_a_threshold():
    """u is straight between samples and passes 0.4 to and fro."""
    times = np.linspace(0.0, 30.0, 301)
    u = np.sin(1.1 * times) + 0.3 * np.cos(3.7 * times)
    function = lambda t, u: 2.0 if u[0] > 0.4 else -0.5  # noqa: E731
    run = clpt.simulate(held(function), times, u, [0.0], engine="python")
    above = u - 0.4
    turns = np.flatnonzero(above[1:] * above[:-1] < 0)
    cuts = times[turns] + 0.1 * above[turns] / (above[turns] - above[turns + 1])
    level = lambda t: function(t, [np.interp(t, times, u)])  # noqa: E731
    assert np.abs(run.states.values[:, 0] - exact(cuts, level, times)).max() < 2e-6


def test_a_pulse_of_one_sample_is_seen():
    times = np.linspace(0.0, 10.0, 1001)
    u = np.where(np.arange(1001) == 500, 1.0, 0.0)
    function = lambda t, u: 100.0 if u[0] > 0.5 else 0.0  # noqa: E731
    for engine in ("native", "python"):
        run = clpt.simulate(held(function), times, u, [0.0], engine=engine)
        right = exact(
            [4.995, 5.005], lambda t: 100.0 if 4.995 < t < 5.005 else 0.0, times
        )
        assert np.abs(run.states.values[:, 0] - right).max() < 3e-6


def test_states_that_pass_a_threshold():
    """x' = 2 below 1, and 0.5 above: x = 2 t, and 1 + 0.5 (t - 0.5)."""
    climb = control.nlsys(
        lambda t, x, u, p: [2.0 if x[0] < 1.0 else 0.5], inputs=0, outputs=1, states=1
    )
    run = clpt.simulate(climb, [0.0, 0.4, 0.5, 2.5], engine="python")
    np.testing.assert_allclose(run.states[:, 0], [0.0, 0.8, 1.0, 2.0], atol=1e-9)


def test_smooth_rates_take_few_evaluations_more():
    """Of a swing of large and small steps no jump is seen."""
    swing = control.nlsys(
        lambda t, x, u, p: [x[1], 5 * (1 - x[0] ** 2) * x[1] - x[0]],
        inputs=0,
        states=2,
        outputs=2,
    )
    run = clpt.simulate(
        swing, [0.0, 40.0], 0, [2.0, 0.0], engine="python", rtol=1e-8, atol=1e-8
    )
    native = clpt.simulate(swing, [0.0, 40.0], 0, [2.0, 0.0], rtol=1e-8, atol=1e-8)
    assert run.solver_evaluations < 1.7 * native.solver_evaluations
    np.testing.assert_allclose(run.states, native.states, atol=2e-5)


@pytest.mark.parametrize("engine", ["native", "python"])
def test_an_input_that_comes_to_a_threshold_and_stays(engine):
    """u reaches 1 exactly at a sample, where the gear changes, and stays there."""
    gear = control.nlsys(
        lambda t, x, u, p: [1.0 if u[0] >= 1.0 else -1.0], inputs=1, outputs=1, states=1
    )
    run = clpt.simulate(
        gear, [0.0, 1.0, 2.0, 3.0], [0.0, 1.0, 1.0, 1.0], [0.0], engine=engine
    )
    np.testing.assert_allclose(run.states[:, 0], [0.0, -1.0, 0.0, 1.0], atol=1e-6)
