"""Runs against exact solutions: held waypoints, oscillators, inputs."""

import itertools
import math

import numpy as np
from calm_water import CALM, exact_positions

import clpt_control as clpt


def test_tolerance_buys_accuracy():
    errors = []
    for rtol in (1e-4, 1e-6, 1e-8, 1e-11):
        run = clpt.simulate(CALM, rtol=rtol, atol=rtol / 100)
        errors.append(np.abs(run.position.values - exact_positions(run.time.values)).max())
    assert errors[0] < 1e-2
    assert errors[-1] < 1e-9
    assert all(later < earlier / 5 for earlier, later in itertools.pairwise(errors))


def decaying(k=2.0):
    """x' = -k x + u."""
    return clpt.Block(
        "decay",
        update=lambda t, x, u, p: -p.k * x + u.u,
        inputs={"u": 1},
        states={"x": 1},
        parameters={"k": k},
    )


def run_of(system, *args, **given):
    return clpt.simulate(system, *args, rtol=1e-11, atol=1e-13, **given)


def test_constant_input_and_none():
    times = np.linspace(0, 3, 13)
    exact = 2.5 * (1 - np.exp(-2 * times))  # rest at u/k = 5/2
    for inputs in (5.0, [5.0], np.array([5.0]), np.full((1, 13), 5.0), np.full(13, 5.0)):
        run = run_of(decaying(), times, inputs)
        np.testing.assert_allclose(run.x, exact, atol=1e-9)
        np.testing.assert_allclose(run.u, 5.0)
    run = run_of(decaying(), times, initial_state=[1.0])
    np.testing.assert_allclose(run.x, np.exp(-2 * times), atol=1e-9)


def test_array_is_joined_by_straight_lines_and_its_kinks_are_hit():
    # u = t on [0, 1], then 2 - t on [1, 2]: x' = -x + u from 0
    run = run_of(decaying(1.0), [0.0, 1.0, 2.0], [[0.0, 1.0, 0.0]])
    one = math.exp(-1)  # x(1) = 1 - 1 + e^-1
    # on [1, 2] with s = t - 1: x' = -x + 1 - s, x = (x1 - 2) e^-s + 2 - s
    two = (one - 2) * math.exp(-1) + 1
    np.testing.assert_allclose(run.x, [0, one, two], atol=1e-10)


def test_an_input_that_is_a_block():
    # x' = -x + cos t from 1/2: x = (cos t + sin t)/2
    times = np.linspace(0, 10, 21)
    wave = clpt.Block("wave", output=lambda t, x, u, p: np.cos(t), outputs={"u": 1})
    run = run_of(clpt.connect([wave, decaying(1.0)]), times, initial_state=[0.5])
    np.testing.assert_allclose(run.x, (np.cos(times) + np.sin(times)) / 2, atol=1e-9)
