"""Sixty right and sixty wrong loops: no false word is said of either."""

import re

import numpy as np
import pytest
import sympy
from judged_loops import RIGHT, WRONG

import clpt_control as clpt

pytestmark = pytest.mark.long  # by `make test-long`

SLOW = (  # a refuting point is searched for: some by `make test`, all by `make test-slow`
    "a claim of zero",
    "a cube that grows",
    "a gain that turns at t = 50",
    "a lag that grows",
    "a leak that feeds",
    "a loop gain above 1",
    "a product that is lost",
    "a region of what grows",
    "a region with a drift",
    "a V that grows too fast",
    "discrete: -1.01",
    "discrete: a cube",
    "discrete: a turn that gains",
    "Rayleigh's friction",
)
WITHOUT_INPUTS = ("stable", "square-integrable", "V does not increase")


def cases(table):
    """Names of loops with their marks."""
    for name in table:
        marks = [pytest.mark.slow] if name in SLOW else []
        yield pytest.param(name, marks=marks)


def falls_as_said(found):
    """Return whether V' <= -k V at random points, k that of the verdict's decay."""
    (power,) = found.decay.atoms(sympy.exp)
    k = -power.args[0] / next(s for s in power.free_symbols if s.name == "t")
    symbols = sorted((found.V + found.rate).free_symbols, key=str)
    numpy = [{"gt": np.greater, "lt": np.less}, "numpy"]
    excess = sympy.lambdify(symbols, found.rate + k * found.V, numpy)
    points = np.random.default_rng(3).normal(size=(len(symbols), 500)) * 4
    positive = [s.is_positive or False for s in symbols]
    points[positive] = np.abs(points[positive])
    return np.max(excess(*points)) < 1e-9


def said(loop):
    """Judge a loop; where it is proved each word must be true."""
    found = clpt.lyapunov(loop.plant, loop.V, points=20, **loop.more)
    if found.status == "proved":
        if found.implies("exponentially stable"):
            assert falls_as_said(found), found
            assert "asymptotically stable" in loop.true, found
        else:
            assert found.conclusion in loop.true, found
        conditions = {condition.name for condition in found.conditions}
        if found.conclusion in WITHOUT_INPUTS:  # no rate is asked for
            conditions |= {"bounded inputs"}
        assert conditions >= {*loop.needs}, found
        for state in loop.never:
            going = re.findall(r"[^,]+", re.sub(r" goe?s?$", "", found.of))
            assert state not in [text.strip() for text in going], found
    else:
        assert (found.conclusion, found.conditions) == ("", ()), found
    return found.status


@pytest.mark.parametrize("name", [*cases(RIGHT)])
def test_a_right_loop_is_not_refuted(name):
    assert said(RIGHT[name]) in ("proved", "open")


@pytest.mark.parametrize("name", [*cases(WRONG)])
def test_of_a_wrong_loop_nothing_false_is_proved(name):
    status = said(WRONG[name])
    assert status in ("proved", "open", "refuted")
    assert WRONG[name].true or status != "proved"


def test_there_are_sixty_of_each():
    assert min(len(RIGHT), len(WRONG)) >= 60
