"""The solver takes the steps of SciPy's DOP853, and its dense output is SciPy's.

In Python it takes those of RK45 at loose tolerances, as python-control does.
"""

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from clpt_control.equations import Block
from clpt_control.native import method, solver
from clpt_control.native.ending import Status
from clpt_control.native.native_diagram import FUNCTIONS, NativeDiagram
from clpt_control.native.python_diagram import PythonDiagram
from clpt_control.native.ways import LOOSE

START, TIMES = np.array([1.0, 0.4]), np.linspace(0.0, 9.0, 91)


def hunted(t, x, u, p):
    """Lotka and Volterra's equations."""
    return [x[0] * (1.1 - 0.9 * x[1]), x[1] * (1.3 * x[0] - 0.7)]


def by_scipy(tolerance, name="DOP853"):
    def rate(t, x):
        return [x[0] * (1.1 - 0.9 * x[1]), x[1] * (1.3 * x[0] - 0.7)]

    return solve_ivp(
        rate, (0.0, 9.0), START, name, rtol=tolerance, atol=tolerance, dense_output=True
    )


def test_the_solver_finds_each_function_and_formula_in_its_place():
    for status in Status:
        assert getattr(solver, status.name) == status
        assert status.sentence
    for number, more in ((solver.DOP853, 3), (solver.RODAS5P, 0), (solver.RK4, 0)):
        places = list(method.formulas(number, 1))
        for name in ("ATTEMPT", "JUDGE", "SIZES", "TRIAL", "FIRST", "ACCEPT", "DENSE"):
            assert places[getattr(solver, name) - len(FUNCTIONS)] == name.lower()
        for s in range(1, number + more):
            assert places[solver.STAGE + s - len(FUNCTIONS)] == f"stage_{s}"
    assert list(method.formulas(solver.DOP853, 1))[solver.STIFFNESS - len(FUNCTIONS)] == "stiffness"
    for k, name in enumerate(FUNCTIONS):
        assert getattr(solver, name.upper()) == k


@pytest.mark.parametrize("engine", [NativeDiagram, PythonDiagram])
@pytest.mark.parametrize("tolerance", [1e-3, 1e-6, 1e-9, 1e-12])
def test_steps_and_dense_output_are_scipys(engine, tolerance):
    block = Block("hunted", update=hunted, states={"s": 2})
    found = engine(block).run(START, TIMES, rtol=tolerance, atol=tolerance)
    loose = engine is PythonDiagram and tolerance >= LOOSE
    theirs = by_scipy(tolerance, "RK45" if loose else "DOP853")
    assert found.statistics["steps"] == len(theirs.t) - 1
    np.testing.assert_allclose(found.x, theirs.sol(TIMES).T, rtol=0, atol=1e-10)


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


def test_dense_output_has_order_seven():
    """Between the ends of steps, the error falls as the seventh power of the step or faster."""
    block = Block("hunted", update=hunted, states={"s": 2})
    exact = by_scipy(1e-13).sol(TIMES).T
    errors, steps = [], []
    for tolerance in (1e-4, 1e-7, 1e-10):
        found = NativeDiagram(block).run(START, TIMES, rtol=tolerance, atol=tolerance)
        errors.append(np.abs(found.x - exact).max())
        steps.append(found.statistics["steps"])
    orders = np.diff(np.log(errors)) / -np.diff(np.log(steps))
    assert np.all(orders > 6.0), orders
