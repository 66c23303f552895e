"""Ordinary Python is read as it runs: branches, NumPy, closures, objects, text or none."""

import functools
import math
from collections import deque, namedtuple
from math import exp
from types import SimpleNamespace

import numpy as np
import pytest
from recorded import as_it_runs, static
from scipy.interpolate import CubicSpline, interp1d

TABLE = [1.0, 2.0]
WHOLE = np.array([[0, 1, 3], [-2, -3, 1], [1, 1, 1]])
PLATE = SimpleNamespace(drag=np.array([[2.0, 0.5, 0.0], [0.5, 3.0, 0.0], [0.0, 0.0, 1.0]]))
SAIL = namedtuple("Sail", "plate drag")(PLATE, PLATE.drag.T - 1.0)
ENDS = SimpleNamespace(low=-0.5, high=0.5)
KNOTS = np.linspace(-3.0, 3.0, 9)
CURVE = np.sin(KNOTS)
BENT = [
    interp1d(KNOTS, CURVE, kind=kind, fill_value="extrapolate")
    for kind in ("slinear", "quadratic", "cubic")
]
SHORT = interp1d([0, 1, 2, 3], [[0, 2], [1, 0], [4, 1], [2, 3]], "cubic", axis=0, fill_value=7)
FILLED = interp1d(KNOTS / 5, CURVE, kind=3, bounds_error=False, fill_value=(7.0, -2.0))
RATE = 0.5
POINTS = ([0.3, -0.7, 2.0], [-1.2, 0.4, -0.1], [1.0, 1.0, 1.0], [2.5, 0.5, 0.2], [0.0, 0.0, 0.0])


def says_if(t, x, u, p):
    y = 0.0
    if u[0] > 0:
        y = 1.0 + u[1]
    elif u[1] > u[2]:
        y = u[2]
    return y


def says_inner(t, x, u, p):
    scale = u[0]

    def inner(a):
        return scale * a

    return inner(u[1]) + inner(RATE)


def says_try(t, x, u, p):
    try:
        return u[0] * TABLE[1]
    finally:
        pass


def says_divided(t, x, u, p):
    low, *_, high = sorted([u[0], u[1], 0.3])
    whole, rest = divmod(u[2], 2.0)
    several = any([u[0] > 0, u[1] > 0]) and all(v < 2 for v in u)
    return [low + rest, high + whole + several, TABLE[min(np.searchsorted([0.0, 0.5], u[0]), 1)]]


def says_math(t, x, u, p):
    y = math.sqrt(u[0] ** 2 + 1) + math.copysign(2.0, u[1]) + math.fmod(u[2], 0.7) + exp(-1.0)
    return y + math.degrees(u[0]) + math.dist([u[0], 0.0], [0.0, u[1]]) + math.floor(u[2])


def says_solve(t, x, u, p):
    A = np.array([[2.0, u[0]], [u[1], 3.0 + u[2] ** 2]])
    return [*np.linalg.solve(A, [1.0, u[0]]), np.linalg.inv(A)[1, 1]]


def says_columns(t, x, u, p):
    A = np.outer(u, [1.0, 2.0])
    M = np.reshape([*u, 1.0], (2, 2), order="F")
    return [*A.ravel("F"), *M.flatten(order="F"), *M[0], *(A.T @ A).reshape(4, order="F")]


def says_objects(t, x, u, p):
    y = np.empty(2, dtype=object)
    y[0], y[1] = u[0], 2 * u[1]
    return [*y, *np.array([u[2], 1, u[0] > 0], dtype=object)]


def says_delays(t, x, u, p):
    line = deque(u, maxlen=3)
    line.appendleft(0.5 * u[1])
    return 2.0 * np.array(line)


def says_curves(t, x, u, p):
    return [*[f(u[0]) for f in BENT], *FILLED(u), *SHORT(abs(u[1]))]


class Motor:
    """An object with numbers."""

    def __init__(self, k):
        self.k = k

    def torque(self, i, *, most=2.0):
        return min(self.k * i, most)

    def __call__(self, t, x, u, p):
        return self.torque(u[0]) - self.k

    def output(self, t, x, u, p):
        return self.torque(u[1])


class Hull:
    """An object with tables and rows, in which a whole number of the run is a place."""

    def __init__(self):
        self.drag = interp1d([-3.0, 0.0, 3.0], [2.0, 0.5, 1.0])
        self.curves = {"lift": CubicSpline([-3.0, 0.0, 3.0], [1.0, 0.0, 2.0])}
        self.slopes = np.array([0.01 * k * (k - 90) for k in range(100)])
        self.angles = [0.1, -0.2, 0.3]
        self.gears = np.array([4, 2, 1])
        self.inertia = np.array([[2.0, 0.5, 0.0], [0.5, 3.0, 0.0], [0.0, 0.0, 1.0]])
        self.turned = np.array([[0, 1, 0], [-1, 0, 0], [0, 0, 2]])
        self.rudder = SimpleNamespace(angles=self.angles)

    def tables(self, t, x, u, p):
        return self.drag(u[0]) * u[1] + self.curves["lift"](u[2])

    def rows(self, t, x, u, p):
        k = int(abs(u[0]))
        return [self.angles[k], self.angles[-1 - k] / 2, self.gears[k % 3], self.slopes[20 * k]]

    def within(self, t, x, u, p):
        return u * self.rudder.angles[int(abs(u[1]))]

    def matrices(self, t, x, u, p):
        moved = self.inertia[0].copy()
        moved[1] = u[0]
        return self.inertia.dot(u) - self.turned.T.dot(u) + moved


@functools.lru_cache
def kept(k):
    return 2.0 * k


def says_helpers(t, x, u, p):
    motor = Motor(1.5)
    return motor.torque(u[0], most=1.0) + kept(3) * u[1] + functools.reduce(max, u)


def closure(gain):
    def output(t, x, u, p):
        return gain * u[0]

    return output


def held(place, speed, ends):
    """No speed out of the ends, at most 0.7: 15 ways, of which 9 can be."""
    if (place <= ends.low and speed <= 0) or (place >= ends.high and speed >= 0):
        return 0.0
    return -0.7 if speed <= -0.7 else 0.7 if speed >= 0.7 else speed


FUNCTIONS = {name: f for name, f in dict(globals()).items() if name.startswith("says_")}
FUNCTIONS |= {
    "ternary": lambda t, x, u, p: u[1] if u[0] > 0 else -u[1],
    "and or not": lambda t, x, u, p: 1.0 if (u[0] > 0 and not u[1] > 0) or u[2] > 1 else u[0],
    "numpy": lambda t, x, u, p: (
        np.exp(u[0]) + np.hypot(u[1], u[2]) - np.linalg.norm(u) + u.max() + u.sum()
    ),
    "builtins": lambda t, x, u, p: (
        max(u[0], u[1]) + min(u) + abs(u[2]) + sum(u) + sorted(u)[1] + round(u[0])
    ),
    "generators": lambda t, x, u, p: sum(a * a for a in u) + math.prod(map(abs, u)),
    "cross": lambda t, x, u, p: np.cross(u, [1.0, 2.0, 3.0]) + np.cumsum(u) + np.roll(u, 1),
    "stacked": lambda t, x, u, p: np.hstack([u[:1], np.vstack([u, 2 * u])[1, 1:]]),
    "mapping": lambda t, x, u, p: {"y": np.flip(u)},
    "gear": lambda t, x, u, p: [0.5, 0.25, 0.125][int(np.clip(u[2], 0.0, 2.0))] * u[0],
    "ways that can be": lambda t, x, u, p: (
        held(u[0], u[1], ENDS) + (2 if u[2] > 0.1 else 3) * held(u[2], u[0] + t, ENDS)
    ),
    "a closure": closure(2.5),
    "a partial": functools.partial(lambda k, t, x, u, p: k * u[0], 3.0),
    "a method": Motor(2.0).output,
    "a namespace": lambda t, x, u, p: PLATE.drag.dot(u),
    "a named tuple": lambda t, x, u, p: SAIL.drag.dot(u) - SAIL.plate.drag[1].dot(u),
    "whole numbers": lambda t, x, u, p: WHOLE.dot(u) + WHOLE[1] // 2,
    **{name: getattr(Hull(), name) for name in ("tables", "rows", "within", "matrices")},
    "an object": Motor(0.5),
}


@pytest.mark.parametrize("name", FUNCTIONS)
def test_ordinary_python_is_read_as_it_runs(name):
    function = FUNCTIONS[name]
    given = function(0.0, np.zeros(0), np.array(POINTS[0]), None)
    block = static(function, 3, np.size(given["y"] if isinstance(given, dict) else given))
    for u in POINTS:
        as_it_runs(block, "output", 0.7, [], u, 1e-13)
