"""Ordinary Python is read as it runs: objects, tables, helpers that ask."""

import functools
import math
from collections import deque, namedtuple
from math import exp
from types import SimpleNamespace

import numpy as np
import pytest
from engine_runs import Unread
from recorded_blocks import as_it_runs, static
from scipy.interpolate import CubicSpline, interp1d

import clpt_control as clpt

TABLE = [1.0, 2.0, 4.0]
WHOLE = np.array([[0, 1, 3], [-2, -3, 1], [1, 1, 1]])
PLATE = SimpleNamespace(
    drag=np.array([[2.0, 0.5, 0.0], [0.5, 3.0, 0.0], [0.0, 0.0, 1.0]])
)
SAIL = namedtuple("Sail", "plate drag")(PLATE, PLATE.drag.T - 1.0)
ENDS = SimpleNamespace(low=-0.5, high=0.5)
KNOTS = np.linspace(-3.0, 3.0, 9)
CURVE = np.sin(KNOTS)
BENT = [
    interp1d(KNOTS, CURVE, kind=kind, fill_value="extrapolate")
    for kind in ("slinear", "quadratic", "cubic")
]
SHORT = interp1d(
    [0, 1, 2, 3], [[0, 2], [1, 0], [4, 1], [2, 3]], "cubic", axis=0, fill_value=7
)
FILLED = interp1d(KNOTS / 5, CURVE, kind=3, bounds_error=False, fill_value=(7.0, -2.0))
POINTS = (
    [0.3, -0.7, 2.0],
    [-1.2, 0.4, -0.1],
    [1.0, 1.0, 1.0],
    [2.5, 0.5, 0.2],
    [0.0, 0.0, 0.0],
)
AT = np.clip(np.random.default_rng(1).normal(size=(12, 3)) * 2, -2.9, 2.9)


def says_try(t, x, u, p):
    try:
        return u[0] * TABLE[1]
    finally:
        pass


def says_gain(t, x, u, p):
    return says_gain.gain * u[0]


says_gain.gain = 3.0


def says_divided(t, x, u, p):
    low, *_, high = sorted([u[0], u[1], 0.3])
    whole, rest = divmod(u[2], 2.0)
    several = any([u[0] > 0, u[1] > 0]) and all(v < 2 for v in u)
    return [
        low + rest,
        high + whole + several,
        TABLE[min(np.searchsorted([0.0, 0.5], u[0]), 1)],
    ]


def says_math(t, x, u, p):
    y = (
        math.sqrt(u[0] ** 2 + 1)
        + math.copysign(2.0, u[1])
        + math.fmod(u[2], 0.7)
        + exp(-1.0)
    )
    return (
        y + math.degrees(u[0]) + math.dist([u[0], 0.0], [0.0, u[1]]) + math.floor(u[2])
    )


def says_columns(t, x, u, p):
    A = np.outer(u, [1.0, 2.0])
    M = np.reshape([*u, 1.0], (2, 2), order="F")
    return [
        *A.ravel("F"),
        *M.flatten(order="F"),
        *M[0],
        *(A.T @ A).reshape(4, order="F"),
    ]


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
        self.inertia = PLATE.drag
        self.turned = np.array([[0, 1, 0], [-1, 0, 0], [0, 0, 2]])
        self.rudder = SimpleNamespace(angles=self.angles)

    def tables(self, t, x, u, p):
        return self.drag(u[0]) * u[1] + self.curves["lift"](u[2])

    def rows(self, t, x, u, p):
        k = int(abs(u[0]))
        return [
            self.angles[k],
            self.angles[-1 - k] / 2,
            self.gears[k % 3],
            self.slopes[20 * k],
        ]

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


def held(place, speed, ends):
    """No speed out of the ends, at most 0.7: 15 ways, of which 9 can be."""
    if (place <= ends.low and speed <= 0) or (place >= ends.high and speed >= 0):
        return 0.0
    return -0.7 if speed <= -0.7 else 0.7 if speed >= 0.7 else speed


FUNCTIONS = {name: f for name, f in dict(globals()).items() if name.startswith("says_")}
FUNCTIONS |= {
    "builtins": lambda t, x, u, p: (
        sum(u) + sorted(u)[1] + round(u[0]) + math.prod(map(abs, u))
    ),
    "gear": lambda t, x, u, p: [0.5, 0.25, 0.125][int(np.clip(u[2], 0.0, 2.0))] * u[0],
    "ways that can be": lambda t, x, u, p: (
        held(u[0], u[1], ENDS) + (2 if u[2] > 0.1 else 3) * held(u[2], u[0] + t, ENDS)
    ),
    "a partial": functools.partial(lambda k, t, x, u, p: k * u[0], 3.0),
    "a method": Motor(2.0).output,
    "a namespace": lambda t, x, u, p: PLATE.drag.dot(u),
    "a named tuple": lambda t, x, u, p: SAIL.drag.dot(u) - SAIL.plate.drag[1].dot(u),
    "whole numbers": lambda t, x, u, p: WHOLE.dot(u) + WHOLE[1] // 2,
    **{
        name: getattr(Hull(), name) for name in ("tables", "rows", "within", "matrices")
    },
    "an object": Motor(0.5),
}


# --- helpers that ask, whose ways are joined where they are called ------------------------------


def limited(v, low=-1.0, high=1.0):
    if v > high:
        return high
    if v < low:
        return low
    return v


def thrust(n):
    n = limited(0 if abs(n) < 0.1 else n - math.copysign(0.1, n), high=0.9)
    return 2.0 * n * n if n >= 0 else -1.2 * n * n


def root(v):
    if v < 0:
        raise ValueError("no root")
    return np.sqrt(v)


def caught(v):
    try:
        return root(v)
    except ValueError:
        return -1.0


def gear(v):
    if v < 0.2:
        return 0
    return 1 if v < 0.6 else 2


def halves(v):
    return (v, 1) if v > 0 else (0.0, -v)


def high(v):
    return bool(v > 0.3)


@functools.lru_cache
def cached(v):
    return v if v > 0 else -2 * v


HELPED = {
    "held": lambda t, x, u, p: [
        functools.partial(limited, low=-0.2)(v, high=0.5) for v in u
    ],
    "within": lambda t, x, u, p: [thrust(v) for v in u],
    "two numbers": lambda t, x, u, p: [a * b for a, b in map(halves, u)],
    "errors": lambda t, x, u, p: [caught(v) for v in u],
    "places": lambda t, x, u, p: [TABLE[gear(v)] * v for v in u],
    "counts": lambda t, x, u, p: [sum(u[: gear(abs(v))]) for v in u],
    "truths": lambda t, x, u, p: [1.0 if high(v) else v for v in u],
    "asked before": lambda t, x, u, p: [
        limited(v) if v > 1.0 else 2 * limited(v) for v in u
    ],
    "a cache": lambda t, x, u, p: [cached(float(v)) for v in u],
}


@pytest.mark.parametrize(
    "function", [*FUNCTIONS.values(), *HELPED.values()], ids=[*FUNCTIONS, *HELPED]
)
def test_ordinary_python_is_read_as_it_runs(function):
    given = function(0.0, np.zeros(0), np.array(POINTS[0]), None)
    block = static(function, 3, np.size(given))
    for u in (*POINTS, *np.round(AT, 1)):
        as_it_runs(block, "output", 0.7, [], u, 1e-13)


def test_ways_of_helpers_add_up():
    """Eight thrusters with six ways each, 6^8 of them, are machine code."""
    rov = static(lambda t, x, u, p: [thrust(v) for v in u], 8, 8)
    as_it_runs(rov, "output", 0.0, [], np.linspace(-2, 2, 8))
    run = clpt.simulate(rov, [0.0, 1.0], np.linspace(-2, 2, 8))
    assert run.attrs["engine"] == "native"


@pytest.mark.long
def test_helpers_of_helpers_of_helpers_end_in_a_sentence():
    def gears(v):
        return gear(v) + gear(v + 3) * gear(v - 3)

    def more(v):
        return gears(v) + gears(2 * v) * gears(3 * v)

    def most(v):
        return more(v) + more(4 * v) * more(5 * v)

    block = static(lambda t, x, u, p: [most(v) + most(v + 9) for v in u], 1, 1)
    with pytest.raises(Unread, match=r"more than (10000|256) execution paths"):
        block.array_record("output")
