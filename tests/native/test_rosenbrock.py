"""The coefficients of Rodas5P: order conditions, and the orders that runs show."""

import numpy as np
import pytest

from clpt_control.equations import Block, Guard
from clpt_control.native import rosenbrock, solver
from clpt_control.native.batch import Batch
from clpt_control.native.native_diagram import NativeDiagram
from clpt_control.native.python_diagram import PythonDiagram

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


def test_the_solver_knows_the_number_of_stages():
    assert len(rosenbrock.C) == solver.RODAS5P - 1


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


def test_the_estimate_is_of_order_four_and_the_method_damps_what_is_stiff():
    """Without the last stage it is a method of order 4; R(z) is 0 at infinity."""
    alpha, gamma, b = table()
    ones, beta = np.ones(S), alpha + gamma
    lower = np.array([[*row, *[0.0] * (S - len(row))] for row in rosenbrock.C])
    weights = np.array([*rosenbrock.weights(S - 1), 0.0])
    fourth = weights @ np.linalg.inv(np.eye(S) / rosenbrock.GAMMA - lower)
    for found, wanted in (
        (fourth @ ones, 1),
        (fourth @ beta @ ones, 1 / 2),
        (fourth @ (alpha @ ones) ** 2, 1 / 3),
        (fourth @ beta @ beta @ ones, 1 / 6),
        (fourth @ (alpha @ ones) ** 3, 1 / 4),
        (fourth @ beta @ beta @ beta @ ones, 1 / 24),
    ):
        assert found == pytest.approx(wanted, abs=1e-12)
    at_infinity = 1.0 - b @ np.linalg.solve(beta, ones)
    assert at_infinity == pytest.approx(0.0, abs=1e-12)
    for z in 1j * np.logspace(-3, 4, 400):  # on the imaginary axis
        stable = 1.0 + z * b @ np.linalg.solve(np.eye(S) - z * beta, ones)
        assert abs(stable) <= 1.0 + 1e-12


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


def test_the_interpolant_shows_order_four():
    """Within one step the error falls as its fifth power; only a guard asks for it."""
    guard = Guard(lambda t, x, u, p: 9.0 - x[0], "stop", lambda t, u, p: "too far")
    runner = NativeDiagram(Block("swung", update=swung, states={"s": 2}, guard=guard))
    start, shares, errors = np.array([1.0, 0.3]), np.linspace(0.0, 1.0, 9), []
    for h in (0.2, 0.1, 0.05):
        times = h * shares
        exact = runner.run(start, times, rtol=1e-13, atol=1e-14, method="dop853").x
        callee = runner.implicit()
        pieces = [runner.schedule(0.0, h)]
        batch = Batch(callee, start[None], np.zeros((1, 0)), times[[0, -1]], pieces, None, h, h)
        batch.advance(1e6, 0.0, 1)
        assert batch.now == h
        batch.Z[:2] = start
        found = [[solver.between(batch.Z, 2, 1, 0, i, s) for i in range(2)] for s in shares]
        errors.append(np.abs(found - exact).max())
    assert np.all(np.log2(np.divide(errors[:-1], errors[1:])) > 4.6)
