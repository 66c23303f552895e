"""Systems that one way of proving alone answers: a way that is removed fails a test here.

The right answers are known by hand.  A stable matrix has a quadratic Lyapunov function.  A system
x' = A x + d with a stable A comes to -A^-1 d.  A condition that always holds can be left out.
"""

import numpy as np
import pytest
import scipy.linalg

import clpt_control as clpt

pytestmark = pytest.mark.long  # by `make test-long`

SIZES = [3, 4, 3, 4, 3, 4, 3, 4]
PUSHED_SIZES = [2, 3, 2, 3, 2, 3]


def stable(size, seed, margin):
    """A random matrix, two decimals, whose eigenvalues have real parts below -margin/2."""
    A = np.random.default_rng(seed).normal(size=(size, size))
    A -= np.eye(size) * (np.linalg.eigvals(A).real.max() + margin)
    A = np.round(A, 2)
    assert np.linalg.eigvals(A).real.max() < -margin / 2
    return A


def linear(A, d=0.0):
    """The system s' = A s + d."""
    return clpt.Block(
        "linear", update=lambda t, x, u, p: {"s": A @ x.s + d}, states={"s": len(A)}
    )


@pytest.mark.parametrize(("seed", "size"), [*enumerate(SIZES)])
def test_a_V_of_a_stable_matrix_is_found(seed, size):
    found = clpt.lyapunov(linear(stable(size, seed, 0.2)))
    assert found.implies("asymptotically stable")


def test_a_region_inside_an_unstable_cycle_is_found():
    """Van der Pol's oscillator backwards: the rest is stable, the cycle is not."""

    def backwards(t, x, u, p):
        """Van der Pol 1926, with -t for t."""
        return {"x": -x.y, "y": x.x - (1 - x.x**2) * x.y}

    cycle = clpt.Block("cycle", update=backwards, states={"x": 1, "y": 1})
    found = clpt.lyapunov(cycle, within={"x": (-3, 3), "y": (-3, 3)})
    assert found.conclusion == "asymptotically stable in a region"
    assert found.level > 0


@pytest.mark.parametrize(("seed", "size"), [*enumerate(PUSHED_SIZES)])
def test_a_constant_push_is_bounded_for_a_V_with_products(seed, size):
    """V = s^T P s comes below its level, and V at the rest -A^-1 d is below it too."""
    A = stable(size, seed, 0.4)
    d = np.round(np.random.default_rng(100 + seed).normal(size=size), 1)
    P = scipy.linalg.solve_continuous_lyapunov(A.T, -np.eye(size))
    P = np.round(P, 2)
    Q = -(A.T @ P + P @ A)
    assert min(np.linalg.eigvalsh(P).min(), np.linalg.eigvalsh(Q).min()) > 0
    found = clpt.lyapunov(linear(A, d), lambda s: s.s @ P @ s.s)
    assert found.conclusion == "ultimately bounded"
    rest = -np.linalg.solve(A, d)
    assert found.level >= rest @ P @ rest


CONDITIONS = {
    "not (x > 1 and x <= 1)": lambda x, y: np.logical_not(
        np.logical_and(x > 1, x <= 1)
    ),
    "x > 0 or x <= 0": lambda x, y: np.logical_or(x > 0, x <= 0),
    "x > y or y >= x": lambda x, y: np.logical_or(x > y, y >= x),
}


@pytest.mark.parametrize("name", CONDITIONS)
def test_a_condition_that_always_holds_is_left_out(name):
    """x' = -x where it holds, else x' = 2 x."""

    def rates(t, x, u, p):
        """A choice of signs, section III."""
        sign = np.where(CONDITIONS[name](x.x, x.y), 1.0, -2.0)
        return {"x": -sign * x.x, "y": -x.y}

    choice = clpt.Block("choice", update=rates, states={"x": 1, "y": 1})
    found = clpt.lyapunov(choice, lambda s: (s.x**2 + s.y**2) / 2)
    assert found.implies("asymptotically stable")
