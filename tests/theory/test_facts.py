"""The table of facts about functions, each row against NumPy at random points and at the ends."""

from functools import cache

import numpy as np
import pytest
import sympy

from clpt_control.theory.algebra.decided import decided
from clpt_control.theory.algebra.facts import (
    FACTS,
    NUMPY_OF,
    fact_of,
    interval,
    pieces_of,
    sector_of,
)
from clpt_control.theory.algebra.slopes import along, degree

S, A, B = sympy.symbols("s a b", real=True)
# arguments of functions that take more than one, and numbers for them
ARGUMENTS = {
    "clip": (S, -1, 2),
    "inside": (S, -1, 2),
    "where": (sympy.Function("gt", real=True)(S, 0), A, B),
    "pick": (sympy.Integer(1), A, B),
    "mod": (S, 3),
    "atan2": (S, A),
    "and_": tuple(sympy.Function("gt", real=True)(x, 0) for x in (S, A)),
    "or_": tuple(sympy.Function("gt", real=True)(x, 0) for x in (S, A)),
    "not_": (sympy.Function("gt", real=True)(S, 0),),
    **dict.fromkeys(("maximum", "minimum", "gt", "ge", "lt", "le"), (S, A)),
}
ENDS = (-1e3, -2.0, -1.0, 0.0, 0.5, 1.0, 2.0, 1e3)
DOMAIN = {"log": (1e-3, 1e3), "acosh": (1.0, 1e3), "asin": (-1, 1), "acos": (-1, 1)}
DOMAIN |= {
    "atanh": (-0.999, 0.999),
    **dict.fromkeys(("exp", "sinh", "cosh"), (-50, 50)),
}


def call_of(name):
    arguments = ARGUMENTS.get(name, (S,))
    function = getattr(sympy, name, None) or sympy.Function(name, real=True)
    if name in NUMPY_OF and name not in ("sin", "cos", "tan", "exp", "log", "sign"):
        function = sympy.Function(name, real=True)
    if name == "Abs":
        function = sympy.Abs
    return function(*arguments)


def points():
    """Values of s, a and b: random ones of wide ranges, and the ends of pieces."""
    random = np.random.default_rng(0)
    drawn = random.standard_normal((300, 3)) * 10.0 ** random.uniform(-2, 2, (300, 1))
    grid = np.array(np.meshgrid(ENDS, ENDS, ENDS)).reshape(3, -1).T
    return np.vstack([drawn, grid])


@cache
def function_of(e):
    """An expression as a function, functions with pieces by NumPy."""
    return sympy.lambdify((S, A, B), e, [NUMPY_OF, "scipy", "numpy"])


def value_of(e, values):
    """An expression as a number."""
    return float(np.asarray(function_of(e)(*values), dtype=float))


def within_domain(name):
    low, high = DOMAIN.get(name, (-np.inf, np.inf))
    return [p for p in points() if low <= p[0] <= high]


@pytest.mark.parametrize("name", [n for n in FACTS if n != "pick"])
def test_a_range_holds_everywhere(name):
    call = call_of(name)
    low, high = map(float, interval(call))
    for p in within_domain(name)[::3]:
        value = value_of(call, p)
        slack = 1e-12 * abs(value)
        assert low - slack <= value <= high + slack


@pytest.mark.parametrize("name", [n for n, fact in FACTS.items() if fact.sector])
def test_an_odd_function_lies_in_its_sector_and_rises(name):
    call = call_of(name)
    low, high = map(float, FACTS[name].sector)
    s = np.array([p[0] for p in within_domain(name) if p[0] != 0])
    ratios = np.array([value_of(call, (v, 0, 0)) for v in s]) / s
    assert np.all(ratios >= low - 1e-12)
    assert np.all(ratios <= high + 1e-12)
    ordered = np.sort(s)
    assert np.all(np.diff([value_of(call, (v, 0, 0)) for v in ordered]) >= 0)


@pytest.mark.parametrize("name", ["sign", "floor", "trunc", "ceil", "clip"])
def test_a_function_with_a_sector_lies_in_it(name):
    call = sympy.Function(name, real=True)(*ARGUMENTS.get(name, (S,)))
    sector = sector_of(call)
    for p in points():
        factor, value = value_of(sector.factor, p), value_of(call, p)
        offset = value - float(sector.offset)
        ends = sorted(
            [float(sector.low) * factor, float(sector.high) * factor if factor else 0.0]
        )
        assert ends[0] - 1e-9 <= offset <= ends[1] + 1e-9 or name in ("floor", "ceil")


@pytest.mark.parametrize("name", [n for n, fact in FACTS.items() if fact.pieces])
def test_pieces_cover_all_points_and_give_the_value(name):
    call = call_of(name)
    pieces = pieces_of(call)
    for p in points():
        covering = [
            replaced
            for conditions, replaced in pieces
            if all(value_of(c, p) >= 0 for c in conditions)
        ]
        assert covering
        values = [value_of(call.xreplace(replaced), p) for replaced in covering]
        assert value_of(call, p) == pytest.approx(
            min(values, key=lambda v: abs(v - value_of(call, p)))
        )


@pytest.mark.parametrize("name", [n for n, fact in FACTS.items() if fact.number])
def test_numbers_are_carried_out_as_numpy_does(name):
    call = call_of(name)
    for p in points()[::5]:
        numbers = dict(zip((S, A, B), map(sympy.Rational, map(str, p)), strict=True))
        assert float(decided(call.xreplace(numbers))) == pytest.approx(
            value_of(call, p)
        )


@pytest.mark.parametrize(
    "name", [n for n, fact in FACTS.items() if fact.growth != "unknown"]
)
def test_no_function_grows_faster_than_its_row_says(name):
    call = call_of(name)
    power = degree(call, {S, A, B}.__contains__)
    assert power <= 1
    for p in within_domain(name)[::3]:
        size = 1 + np.abs(p).max() ** power
        assert abs(value_of(call, p)) <= 4 * size


@pytest.mark.parametrize(
    "name", [n for n in FACTS if n not in ("pick", "mod", "atan2")]
)
def test_the_slope_is_that_of_differences_away_from_kinks(name):
    call, h = call_of(name), 1e-6
    slope = along(call, {S: sympy.S.One})
    low = DOMAIN.get(name, (-np.inf,))[0]
    for p in within_domain(name)[:100]:
        if p[0] < low + 1e-3:
            continue
        if (
            fact_of(call).kind != "smooth"
            and min(abs(p[0] - end) for end in (*ENDS, p[1])) < 1e-3
        ):
            continue
        near = [value_of(call, (p[0] + d, p[1], p[2])) for d in (-h, h)]
        wanted = (near[1] - near[0]) / (2 * h)
        if name in ("floor", "trunc", "ceil") and wanted:
            continue  # a step in between
        assert value_of(slope, p) == pytest.approx(wanted, rel=1e-4, abs=1e-4)
