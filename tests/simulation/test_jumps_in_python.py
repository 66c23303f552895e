"""Jumps of rates in functions that run in Python: each is located, against closed forms.

x' = 1 and y' = integer part of x, so y is the integral of a staircase: with x = t, y at the whole
number n is n (n - 1)/2, and grows by n per time from there.
"""

import math

import control
import numpy as np
import pytest

import clpt_control as clpt

TIMES = np.linspace(0, 9.5, 39)


def staircase(t, x, u, p):
    """Rates that Python runs: modf is not traced."""
    return [1.0, math.modf(x[0])[1]]


def area(t):
    """Return the integral of the staircase."""
    whole = np.floor(t)
    return whole * (whole - 1) / 2 + whole * (t - whole)


def run(function):
    system = control.nlsys(function, None, inputs=0, outputs=2, states=2, name="stairs")
    with pytest.warns(UserWarning, match="runs in Python"):
        return clpt.simulate(system, TIMES, None, [0.0, 0.0])


def test_every_jump_is_located():
    """Nine jumps, one behind the other: an error of the tolerance, and few restarts."""
    response = run(staircase)
    np.testing.assert_allclose(response.states.values[:, 1], area(TIMES), atol=1e-7)
    assert response.attrs["status"] == "finished"
    assert response.attrs["solver_restarts"] < 40
    assert response.attrs["solver_evaluations"] < 10_000


def test_jumps_of_two_functions_are_located():
    """A second staircase of half the width is twice as often and as right."""

    def two(t, x, u, p):
        return [1.0, math.modf(x[0])[1] + 0.5 * math.modf(2 * x[0])[1]]

    expected = area(TIMES) + 0.25 * area(2 * TIMES)
    np.testing.assert_allclose(run(two).states.values[:, 1], expected, atol=1e-7)
