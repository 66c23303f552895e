"""Runs in Python at loose tolerances: where they stop, and that they are as good as asked for."""

import ctypes
import math

import control
import numpy as np
import pytest

import clpt_control as clpt
from clpt_control.native.ways import sharp

SINE = ctypes.PyDLL(None).sin  # no reading goes into it
SINE.restype, SINE.argtypes = ctypes.c_double, [ctypes.c_double]
TIMES = np.linspace(0.0, 10.0, 201)
INPUTS = {
    "constant": np.ones(201),
    "smooth": np.sin(TIMES),
    "step": np.where(TIMES < 3.0, 0.0, 1.0),
    "saw": np.abs(TIMES % 2.0 - 1.0),
}
STOPS = {"constant": 0, "smooth": 0, "step": 2, "saw": 9}


def pendulum(t, x, u, params):
    return [x[1], -SINE(float(x[0])) - 0.1 * x[1] + u[0]]


def readable(t, x, u, params):
    return [x[1], -math.sin(x[0]) - 0.1 * x[1] + u[0]]


def run(function, name, rtol, engine=None):
    system = control.nlsys(function, None, states=2, inputs=1, outputs=2, name="pendulum")
    return clpt.simulate(system, TIMES, INPUTS[name], [0.5, 0.0], rtol=rtol, engine=engine)


@pytest.mark.parametrize("name", INPUTS)
def test_a_run_stops_where_its_input_turns_sharply(name):
    assert len(sharp(TIMES, INPUTS[name][None], 1e-3)) == STOPS[name]
    smooth = len(sharp(TIMES, INPUTS["smooth"][None], 1e-7))
    assert smooth > 190  # what is smooth to one tolerance is not to another


@pytest.mark.filterwarnings("ignore:pendulum runs in Python")
@pytest.mark.parametrize("rtol", [1e-3, 1e-5, 1e-7])
@pytest.mark.parametrize("name", INPUTS)
def test_runs_are_as_good_as_asked_for(name, rtol):
    found, exact = run(pendulum, name, rtol), run(readable, name, 1e-11)
    assert (found.engine, exact.engine) == ("python", "native")
    assert np.abs(found.states - exact.states).max() < 100 * rtol


def test_what_goes_to_infinity_is_named():
    system = control.nlsys(
        lambda t, x, u, p: [x[0] ** 2], None, states=1, inputs=1, outputs=1, name="burst"
    )
    with pytest.raises(clpt.SimulationError, match="stopped at t = "):
        clpt.simulate(system, [0.0, 2.0], 0, [1.0], rtol=1e-4, engine="python")
