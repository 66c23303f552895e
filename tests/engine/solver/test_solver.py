"""The explicit methods: SciPy's steps and dense output, and what loose tolerances give."""

import ctypes
import math

import control
import numpy as np
import pytest
from engine_runs import NativeDiagram, PythonDiagram, wiring_of
from scipy.integrate import solve_ivp
from text_systems import written

import clpt_control as clpt

every_engine = pytest.mark.parametrize("engine", [NativeDiagram, PythonDiagram])


# Lotka and Volterra's equations
HUNTED, _ = written("q' = q*(1.1 - 0.9*r); r' = r*(1.3*q - 0.7)")
START, TIMES = np.array([1.0, 0.4]), np.linspace(0.0, 9.0, 91)


@every_engine
@pytest.mark.parametrize("tolerance", [1e-3, 1e-6, 1e-9, 1e-12])
def test_steps_and_dense_output_are_scipys(engine, tolerance):
    close = {"rtol": tolerance, "atol": tolerance}
    found = engine(wiring_of(HUNTED)).run(START, TIMES, method="dop853", **close)
    theirs = solve_ivp(
        lambda t, x: HUNTED.dynamics(t, x, []),
        (0.0, 9.0),
        START,
        "DOP853",
        dense_output=True,
        max_step=np.inf if engine is NativeDiagram else 9.0 / 51.2,
        **close,
    )
    assert (found.method, found.statistics["steps"]) == ("DOP853", len(theirs.t) - 1)
    np.testing.assert_allclose(found.x, theirs.sol(TIMES).T, rtol=0, atol=1e-10)


@every_engine
@pytest.mark.parametrize("rtol", [1e-6, 1e-8, 1e-10, 1e-12])
def test_samples_within_a_step_are_as_exact_as_its_ends(engine, rtol):
    """One state fades, one follows it at once and alone keeps the step short.

    SciPy's DOP853 is up to 25,000 tolerances off, its LSODA is not.
    """
    times = np.linspace(0.0, 10.0, 301)
    slow, fast = np.exp(-times), np.exp(-30.0 * times)
    exact = np.column_stack([slow, (30.0 * slow - fast) / 29.0])
    runner = engine(wiring_of(written("q' = -q; r' = 30*(q - r)")[0]))
    found = runner.run([1.0, 1.0], times, rtol=rtol, atol=1e-3 * rtol)
    assert np.max(np.abs(found.x - exact) / (1e-3 * rtol + rtol * exact)) < 200.0
    if engine is NativeDiagram:  # most samples lie within steps
        assert found.statistics["steps"] < 250


SINE = ctypes.PyDLL(None).sin  # no reading goes into it
SINE.restype, SINE.argtypes = ctypes.c_double, [ctypes.c_double]
SAMPLES = np.linspace(0.0, 10.0, 201)
INPUTS = {
    "constant": np.ones(201),
    "smooth": np.sin(SAMPLES),
    "step": np.where(SAMPLES < 3.0, 0.0, 1.0),
    "saw": np.abs(SAMPLES % 2.0 - 1.0),
}


def pendulum(sine):
    rates = lambda t, x, u, params: [x[1], -sine(x[0]) - 0.1 * x[1] + u[0]]  # noqa: E731
    return control.nlsys(rates, None, states=2, inputs=1, outputs=2, name="pendulum")


@pytest.mark.filterwarnings("ignore:pendulum runs in Python")
@pytest.mark.parametrize("rtol", [1e-3, 1e-5, 1e-7])
@pytest.mark.parametrize("name", INPUTS)
def test_runs_in_python_are_as_good_as_asked_for(name, rtol):
    found, exact = (
        clpt.simulate(pendulum(sine), SAMPLES, INPUTS[name], [0.5, 0.0], rtol=own)
        for sine, own in ((lambda a: SINE(float(a)), rtol), (math.sin, 1e-11))
    )
    assert (found.engine, exact.engine) == ("python", "native")
    assert np.abs(found.states - exact.states).max() < 100 * rtol


@pytest.mark.parametrize("error", [KeyboardInterrupt, TypeError])
def test_what_a_function_raises_ends_the_run(error):
    """Machine code calls it; it is asked no more."""
    asked = []

    def rates(t, x, u, p):
        asked.append(t)
        if t > 1.0:
            raise error("enough")
        return [-x[0]]

    runner = PythonDiagram(clpt.Block("weary", update=rates, states={"s": 1}))
    with pytest.raises(
        KeyboardInterrupt if error is KeyboardInterrupt else clpt.ClptError
    ):
        runner.run([1.0], [0.0, 20.0])
    assert sum(t > 1.0 for t in asked) == 1
