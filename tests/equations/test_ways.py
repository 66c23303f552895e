"""Helpers that ask questions are joined where they are called, and give what Python gives."""

import functools
import math

import numpy as np
import pytest
from recorded import as_it_runs, static

import clpt_control as clpt
from clpt_control.equations.arrays import Unread


def limited(v, low=-1.0, high=1.0):
    if v > high:
        return high
    if v < low:
        return low
    return v


def dead(v, width=0.1):
    return 0 if abs(v) < width else v - math.copysign(width, v)


def thrust(n):
    n = limited(dead(n), high=0.9)
    return 2.0 * n * n if n >= 0 else -1.2 * n * n


def raising(v):
    if v < 0:
        raise ValueError("no root")
    return np.sqrt(v)


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


def caught(v):
    try:
        return raising(v)
    except ValueError:
        return -1.0


RATIOS = [1.0, 2.5, 4.0]
FUNCTIONS = {
    "limits": lambda t, x, u, p: [limited(v) for v in u],
    "by name": lambda t, x, u, p: [limited(v, high=0.5) for v in u],
    "held": lambda t, x, u, p: [functools.partial(limited, low=-0.2)(v) for v in u],
    "within": lambda t, x, u, p: [thrust(v) for v in u],
    "two numbers": lambda t, x, u, p: [a * b for a, b in map(halves, u)],
    "errors": lambda t, x, u, p: [caught(v) for v in u],
    "places": lambda t, x, u, p: [RATIOS[gear(v)] * v for v in u],
    "counts": lambda t, x, u, p: [sum(u[: gear(abs(v))]) for v in u],
    "truths": lambda t, x, u, p: [1.0 if high(v) else v for v in u],
    "asked before": lambda t, x, u, p: [limited(v) if v > 1.0 else 2 * limited(v) for v in u],
    "a cache": lambda t, x, u, p: [cached(float(v)) for v in u],
}


@pytest.mark.parametrize("name", FUNCTIONS)
def test_what_helpers_give_is_what_python_gives(name):
    block, numbers = static(FUNCTIONS[name], 3, 3), np.random.default_rng(1)
    for size in (0.3, 1.0, 3.0) * 10:
        as_it_runs(block, "output", 0.0, [], np.round(size * numbers.normal(size=3), 1))


def test_ways_of_helpers_add_up():
    """Eight thrusters with six ways each, 6^8 of them, are machine code."""
    rov = static(lambda t, x, u, p: [thrust(v) for v in u], 8, 8)
    as_it_runs(rov, "output", 0.0, [], np.linspace(-2, 2, 8))
    run = clpt.simulate(rov, [0.0, 1.0], np.linspace(-2, 2, 8))
    assert run.attrs["engine"] == "native"


def test_helpers_of_helpers_of_helpers_end_in_a_sentence():
    def gears(v):
        return gear(v) + gear(v + 3) * gear(v - 3)

    def more(v):
        return gears(v) + gears(2 * v) * gears(3 * v)

    def most(v):
        return more(v) + more(4 * v) * more(5 * v)

    block = static(lambda t, x, u, p: [most(v) + most(v + 9) for v in u], 1, 1)
    with pytest.raises(Unread, match="has helpers in helpers, of more than 10000 ways"):
        block.array_record("output")
