"""Peaks of time alone, a 48th of the run wide, against their closed-form integral."""

import math

import control
import numpy as np
import pytest

import clpt_control as clpt

WIDTH = 1 / 96
PLACES = np.linspace(0.1, 0.9, 17)


def gaussian(t, x, u, p):
    return [np.exp(-(((t - p["c"]) / WIDTH) ** 2)) / WIDTH / np.sqrt(np.pi)]


def bell(t, x, u, p):
    """A Lorentz curve of area 1 over all time."""
    return [1 / (np.pi * WIDTH * (1 + ((t - p["c"]) / WIDTH) ** 2))]


def on_a_lag(t, x, u, p):
    """The state decays, and a peak of area 1 lifts it."""
    s = (t - p["c"]) / WIDTH
    return [-x[0] + 0.5 / WIDTH / math.cosh(s) ** 2]


def model(rate):
    return control.nlsys(
        rate, states=1, inputs=0, outputs=1, params={"c": 0.5}, name="peak"
    )


@pytest.mark.parametrize("c", PLACES)
def test_no_peak_is_missed(c):
    final = {
        rate: clpt.simulate(model(rate), [0, 1], params={"c": c}).states.values[-1, 0]
        for rate in (gaussian, bell, on_a_lag)
    }
    assert final[gaussian] == pytest.approx(1, abs=1e-7)
    area = np.arctan((1 - c) / WIDTH) + np.arctan(c / WIDTH)
    assert final[bell] == pytest.approx(area / np.pi, abs=1e-7)
    # sech^2 / 2 times exp(t): x(1) = exp(c - 1) (pi w / 2) / sin(pi w / 2)
    moment = np.pi * WIDTH / 2 / np.sin(np.pi * WIDTH / 2)
    assert final[on_a_lag] == pytest.approx(np.exp(c - 1) * moment, abs=1e-7)


def test_members_of_an_ensemble_miss_no_peak():
    data = clpt.run_ensemble(model(gaussian), {"c": PLACES.tolist()}, timepts=[0, 1])
    np.testing.assert_allclose(data.y_final, 1, atol=1e-7)


@pytest.mark.parametrize("c", PLACES[::4])
def test_no_peak_of_an_input_on_a_straight_line_is_missed(c):
    of_input = control.nlsys(
        lambda t, x, u, p: gaussian(u[0], x, u, p),
        **{
            "states": 1,
            "inputs": 1,
            "outputs": 1,
            "params": {"c": 0.5},
            "name": "peak",
        },
    )
    run = clpt.simulate(of_input, [0, 1, 2], [[0, 1, 0]], params={"c": c})
    assert run.states.values[-1, 0] == pytest.approx(2, abs=1e-7)
    # steps stay long where inputs are constant
    assert clpt.simulate(of_input, [0, 1], 0.0, params={"c": c}).solver_steps < 20


def test_sines_of_time_need_no_short_steps():
    swung = control.nlsys(
        lambda t, x, u, p: [x[1], -x[0] + np.sin(0.5 * t) * np.cos(t)],
        **{"states": 2, "inputs": 0, "outputs": 2, "name": "swung"},
    )
    assert clpt.simulate(swung, [0, 1]).attrs["solver_steps"] < 20
