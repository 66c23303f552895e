"""The methods: SciPy's steps and dense output, Rodas5P's conditions, what loose tolerances give."""

import ctypes
import math

import control
import numpy as np
import pytest
from scipy.integrate import solve_ivp

import clpt_control as clpt
from clpt_control.equations import Block, Guard
from clpt_control.native import numbering, rosenbrock
from clpt_control.native.batch import Batch
from clpt_control.native.native_diagram import NativeDiagram
from clpt_control.native.python_diagram import PythonDiagram

START, TIMES = np.array([1.0, 0.4]), np.linspace(0.0, 9.0, 91)


def hunted(t, x, u, p):
    """Lotka and Volterra's equations."""
    return [x[0] * (1.1 - 0.9 * x[1]), x[1] * (1.3 * x[0] - 0.7)]


METHODS = {"dop853": "DOP853", "dopri5": "RK45"}  # the names are SciPy's


def by_scipy(method, tolerance):
    def rate(t, x):
        return [x[0] * (1.1 - 0.9 * x[1]), x[1] * (1.3 * x[0] - 0.7)]

    return solve_ivp(
        rate, (0.0, 9.0), START, METHODS[method], rtol=tolerance, atol=tolerance, dense_output=True
    )


@pytest.mark.parametrize("engine", [NativeDiagram, PythonDiagram])
@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("tolerance", [1e-3, 1e-6, 1e-9, 1e-12])
def test_steps_and_dense_output_are_scipys(engine, tolerance, method):
    block = Block("hunted", update=hunted, states={"s": 2})
    found = engine(block).run(START, TIMES, rtol=tolerance, atol=tolerance, method=method)
    theirs = by_scipy(method, tolerance)
    assert found.method == method.upper()
    assert found.statistics["steps"] == len(theirs.t) - 1
    np.testing.assert_allclose(found.x, theirs.sol(TIMES).T, rtol=0, atol=1e-10)


@pytest.mark.parametrize("engine", [NativeDiagram, PythonDiagram])
def test_rounding_of_times_adds_no_fixed_step(engine):
    """Samples 0.1 apart are two steps of 0.05 apart, also where times are known to 2e-13 alone."""
    block = Block("hunted", update=hunted, states={"s": 2})
    times = 1500.0 + 0.1 * np.arange(101)
    found = engine(block).run(START, times, step=0.05)
    assert found.statistics["steps"] == 200


def fading(t, x, u, p):
    """One state fades, one follows it at once: the step is kept short by the second alone."""
    return [-x[0], 30.0 * (x[0] - x[1])]


@pytest.mark.parametrize("engine", [NativeDiagram, PythonDiagram])
@pytest.mark.parametrize("rtol", [1e-6, 1e-8, 1e-10, 1e-12])
def test_samples_within_a_step_are_as_exact_as_its_ends(engine, rtol):
    """SciPy's are up to 12,000 tolerances off."""
    times = np.linspace(0.0, 10.0, 301)
    slow, fast = np.exp(-times), np.exp(-30.0 * times)
    exact = np.column_stack([slow, (30.0 * slow - fast) / 29.0])
    runner = engine(Block("fading", update=fading, states={"s": 2}))
    found = runner.run([1.0, 1.0], times, rtol=rtol, atol=1e-3 * rtol, method="dop853")
    off = np.abs(found.x - exact) / (1e-3 * rtol + rtol * exact)
    assert off.max() < 200.0
    assert found.statistics["steps"] < 250  # most samples lie within steps


SINE = ctypes.PyDLL(None).sin  # no reading goes into it
SINE.restype, SINE.argtypes = ctypes.c_double, [ctypes.c_double]
SAMPLES = np.linspace(0.0, 10.0, 201)
INPUTS = {
    "constant": np.ones(201),
    "smooth": np.sin(SAMPLES),
    "step": np.where(SAMPLES < 3.0, 0.0, 1.0),
    "saw": np.abs(SAMPLES % 2.0 - 1.0),
}


def pendulum(t, x, u, params):
    return [x[1], -SINE(float(x[0])) - 0.1 * x[1] + u[0]]


def readable(t, x, u, params):
    return [x[1], -math.sin(x[0]) - 0.1 * x[1] + u[0]]


def run(function, name, rtol, engine=None):
    system = control.nlsys(function, None, states=2, inputs=1, outputs=2, name="pendulum")
    return clpt.simulate(system, SAMPLES, INPUTS[name], [0.5, 0.0], rtol=rtol, engine=engine)


@pytest.mark.filterwarnings("ignore:pendulum runs in Python")
@pytest.mark.parametrize("rtol", [1e-3, 1e-5, 1e-7])
@pytest.mark.parametrize("name", INPUTS)
def test_runs_are_as_good_as_asked_for(name, rtol):
    found, exact = run(pendulum, name, rtol), run(readable, name, 1e-11)
    assert (found.engine, exact.engine) == ("python", "native")
    assert np.abs(found.states - exact.states).max() < 100 * rtol


S = len(rosenbrock.C)


def table():
    """The coefficients as they are derived: alpha, Gamma and b."""
    a, c = np.zeros((S + 1, S)), np.zeros((S, S))
    for s in range(S + 1):
        a[s, : len(rosenbrock.weights(s))] = rosenbrock.weights(s)
    for s, row in enumerate(rosenbrock.C):
        c[s, : len(row)] = row
    gamma = np.linalg.inv(np.eye(S) / rosenbrock.GAMMA - c)
    return a[:S] @ gamma, gamma, a[S] @ gamma


def test_order_conditions_hold_up_to_order_five():
    """Hairer and Wanner, Solving Ordinary Differential Equations II, section IV.7."""
    alpha, gamma, b = table()
    beta, ones = alpha + gamma, np.ones(S)
    a, d = alpha @ ones, beta @ ones
    conditions = {
        "1": (b @ ones, 1),
        "2": (b @ d, 1 / 2),
        "3a": (b @ a**2, 1 / 3),
        "3b": (b @ beta @ d, 1 / 6),
        "4a": (b @ a**3, 1 / 4),
        "4b": (b @ (a * (alpha @ d)), 1 / 8),
        "4c": (b @ beta @ a**2, 1 / 12),
        "4d": (b @ beta @ beta @ d, 1 / 24),
        "5a": (b @ a**4, 1 / 5),
        "5b": (b @ (a**2 * (alpha @ d)), 1 / 10),
        "5c": (b @ (a * (alpha @ a**2)), 1 / 15),
        "5d": (b @ (a * (alpha @ beta @ d)), 1 / 30),
        "5e": (b @ (alpha @ d) ** 2, 1 / 20),
        "5f": (b @ beta @ a**3, 1 / 20),
        "5g": (b @ beta @ (a * (alpha @ d)), 1 / 40),
        "5h": (b @ beta @ beta @ a**2, 1 / 60),
        "5i": (b @ beta @ beta @ beta @ d, 1 / 120),
    }
    for name, (found, wanted) in conditions.items():
        assert found == pytest.approx(wanted, abs=1e-13), name
    np.testing.assert_allclose(a, rosenbrock.TIMES, atol=1e-13)
    np.testing.assert_allclose(gamma @ ones, rosenbrock.OF_TIME, atol=1e-13)


def swung(t, x, u, p):
    """A pendulum that is pushed."""
    return [x[1], -np.sin(x[0]) + np.cos(2.0 * t) * x[1]]


@pytest.mark.parametrize("engine", [NativeDiagram, PythonDiagram])
def test_runs_show_order_five(engine):
    runner = engine(Block("swung", update=swung, states={"s": 2}))
    ends = [0.0, 4.0]
    exact = runner.run([1.0, 0.3], ends, rtol=1e-13, atol=1e-14, method="dop853").x
    errors = []
    for count in (16, 32, 64):
        h = 4.0 / count
        found = runner.run(
            [1.0, 0.3], ends, rtol=1e6, atol=0.0, method="rodas5p", max_step=h, first_step=h
        )
        assert found.statistics["steps"] == count
        errors.append(np.abs(found.x[-1] - exact[-1]).max())
    assert np.all(np.log2(np.divide(errors[:-1], errors[1:])) > 4.7)


def test_a_loose_run_in_python_goes_on_from_where_it_is_stiff():
    block = Block("lag", update=lambda t, x, u, p: [-1e5 * (x[0] - np.cos(t))], states={"s": 1})
    found = PythonDiagram(block).run([0.0], [0.0, 1.0], rtol=1e-4, atol=1e-6)
    assert found.method.startswith("DOPRI5, from t = ")
    assert found.statistics["evaluations"] < 20_000
    assert found.x[-1, 0] == pytest.approx(np.cos(1.0), abs=1e-3)


def test_the_interpolant_shows_order_four():
    """Within one step the error falls as its fifth power; only a guard asks for it."""
    guard = Guard(lambda t, x, u, p: 9.0 - x[0], "stop", lambda t, u, p: "too far")
    runner = NativeDiagram(Block("swung", update=swung, states={"s": 2}, guard=guard))
    start, shares, errors = np.array([1.0, 0.3]), np.linspace(0.0, 1.0, 9), []
    for h in (0.2, 0.1, 0.05):
        times = h * shares
        exact = runner.run(start, times, rtol=1e-13, atol=1e-14, method="dop853").x
        callee = runner.implicit()
        pieces = [runner.schedule((0.0, h))]
        batch = Batch(callee, start[None], np.zeros((1, 0)), times[[0, -1]], pieces, None, h, h)
        batch.advance(1e6, 0.0, 1)
        assert batch.now == h
        batch.Z[:2] = start
        found = [[numbering.interpolate(batch.Z, 2, 1, 0, i, s) for i in range(2)] for s in shares]
        errors.append(np.abs(found - exact).max())
    assert np.all(np.log2(np.divide(errors[:-1], errors[1:])) > 4.6)


@pytest.mark.parametrize("error", [KeyboardInterrupt, TypeError])
def test_what_a_function_raises_ends_the_run(error):
    """Machine code calls it; it is asked no more."""
    asked = []

    def rates(t, x, u, p):
        asked.append(t)
        if t > 1.0:
            raise error("enough")
        return [-x[0]]

    runner = PythonDiagram(Block("weary", update=rates, states={"s": 1}))
    with pytest.raises(KeyboardInterrupt if error is KeyboardInterrupt else clpt.ClptError):
        runner.run([1.0], [0.0, 20.0])
    assert sum(t > 1.0 for t in asked) == 1
