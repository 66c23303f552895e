"""The words and `math`: Python, Numba and SymPy give the same numbers."""

import importlib
import math
from typing import NamedTuple

import numpy as np
import pytest
import sympy
from hypothesis import HealthCheck, assume, example, given, settings
from hypothesis import strategies as st

from clpt_control.blocks.readers import compiled, traced
from clpt_control.blocks.rules import check_equations
from clpt_control.blocks.words import (
    WORDS,
    clip,
    floor,
    lookup,
    maximum,
    minimum,
    sign,
    symbolic_substitutes,
    where,
)
from clpt_control.errors import BlockError

numbers = st.floats(-1e6, 1e6, allow_nan=False, allow_subnormal=False)
repeatable = settings(
    derandomize=True, deadline=None, max_examples=60, suppress_health_check=list(HealthCheck)
)


def choose(t, x, u, p, y):
    y[0] = where(u[0] < u[1], u[2], u[0])
    y[1] = where(u[0] >= u[1], u[2], u[0])


def smaller_and_larger(t, x, u, p, y):
    y[0] = minimum(u[0], u[1])
    y[1] = maximum(u[0], u[1])
    y[2] = clip(u[2], -1.0, 1.0)


def steps(t, x, u, p, y):
    y[0] = sign(u[0])
    y[1] = floor(u[0])
    y[2] = u[0] % 3.0
    y[3] = -floor(-u[1])


class Table(NamedTuple):
    values: np.ndarray


def looked_up(t, x, u, p, y):
    y[0] = lookup(p.values, u[0])


def elementary(t, x, u, p, y):
    y[0] = math.sin(u[0]) + math.cos(u[1])
    y[1] = math.exp(-math.fabs(u[0]) / 1e6)
    y[2] = math.sqrt(u[0] ** 2 + u[1] ** 2 + 1.0)
    y[3] = math.log(1.0 + math.fabs(u[1]))
    y[4] = math.tanh(u[0] / 1e6) + math.atan2(u[1], u[0] + 2e6)
    y[5] = math.hypot(u[0], u[1]) + math.log1p(u[0] ** 2) + math.expm1(u[1] / 1e6)
    y[6] = math.pi * u[2]


READINGS: dict = {}


def readings(function, u, size):
    """What Python, Numba and SymPy make of the same inputs."""
    u = np.array(u, dtype=float)
    python, numba = np.full(size, np.nan), np.full(size, np.nan)
    function(0.0, np.zeros(0), u, (), python)
    compiled(function)(0.0, np.zeros(0), u, (), numba)
    if function not in READINGS:
        symbols = [sympy.Symbol(f"u{k}", real=True) for k in range(len(u))]
        out = traced(function, 0.0, None, np.array(symbols, dtype=object), None, size)
        READINGS[function] = sympy.lambdify(symbols, list(out), "math")
    return python, numba, np.array(READINGS[function](*u), dtype=float)


def agree(function, u, size, tolerance=0.0):
    python, numba, symbolic = readings(function, u, size)
    assert np.all(np.isfinite(python))
    np.testing.assert_allclose(numba, python, rtol=tolerance, atol=tolerance)
    np.testing.assert_allclose(symbolic, python, rtol=tolerance, atol=tolerance)
    return python


@repeatable
@given(numbers, numbers, numbers)
@example(1.0, 1.0, 5.0)
@example(0.0, -0.0, 5.0)
def test_where(a, b, c):
    first, second = agree(choose, [a, b, c], 2)
    assert {first, second} <= {a, c}
    assert first == (c if a < b else a)
    assert first + second == pytest.approx(a + c, rel=1e-15)


@repeatable
@given(numbers, numbers, numbers)
@example(2.0, 2.0, 1.0)
@example(-1.0, 1.0, -1.0)
def test_minimum_maximum_clip(a, b, c):
    low, high, clipped = agree(smaller_and_larger, [a, b, c], 3)
    assert low <= high
    assert sorted([a, b]) == [low, high]
    assert -1.0 <= clipped <= 1.0
    assert clipped == c or abs(clipped) == 1.0


@repeatable
@given(numbers, numbers)
@example(0.0, 0.0)
@example(-0.5, 3.0)
@example(7.0, -7.0)
def test_sign_floor_remainder(a, b):
    # SymPy's printer asks for the sign with copysign, and its Mod and floor are math's own
    s, whole, rest, ceiling = agree(steps, [a, b], 4, tolerance=1e-9)
    assert s * abs(a) == a
    assert whole <= a < whole + 1
    assert whole == int(whole)
    assert 0.0 <= rest <= 3.0
    assert ceiling >= b > ceiling - 1


@repeatable
@given(st.lists(numbers, min_size=1, max_size=9), st.integers(0, 8))
def test_lookup(values, k):
    assume(k < len(values))
    table, index = np.array(values), np.array([float(k)])
    python, numba = np.zeros(1), np.zeros(1)
    looked_up(0.0, np.zeros(0), index, Table(table), python)
    compiled(looked_up)(0.0, np.zeros(0), index, Table(table), numba)
    assert python[0] == numba[0] == values[k]
    symbols = np.array([sympy.Symbol(f"w{j}") for j in range(len(values))], dtype=object)
    whole = np.array([sympy.Integer(k)], dtype=object)
    assert traced(looked_up, 0, None, whole, Table(symbols), 1)[0] == symbols[k]


def test_lookup_at_a_symbol_is_undefined():
    s = sympy.Symbol("s")
    out = traced(looked_up, 0, None, np.array([s], dtype=object), Table(np.zeros(3)), 1)
    assert out[0] == sympy.Function("lookup")(s)


@repeatable
@given(numbers, numbers, numbers)
@example(0.0, 0.0, 0.0)
def test_math(a, b, c):
    agree(elementary, [a, b, c], 7, tolerance=1e-9)


ONE = ("acos", "asin", "atan", "cos", "cosh", "erf", "erfc", "exp", "expm1", "fabs")
ONE += ("log", "log1p", "sin", "sinh", "sqrt", "tan", "tanh")


@pytest.mark.parametrize("name", ONE)
def test_math_of_one_argument_is_read_by_sympy(name):
    reading = getattr(symbolic_substitutes()["math"], name)
    for a in (0.25, 0.8):
        expected = getattr(math, name)(a)
        assert float(reading(sympy.Float(a, 30))) == pytest.approx(expected, rel=1e-14, abs=1e-15)


@pytest.mark.parametrize("name", ["atan2", "hypot", "log"])
def test_math_of_two_arguments_is_read_by_sympy(name):
    reading = getattr(symbolic_substitutes()["math"], name)
    expected = getattr(math, name)(0.7, 2.5)
    given_exactly = [sympy.Float(a, 30) for a in (0.7, 2.5)]
    assert float(reading(*given_exactly)) == pytest.approx(expected, rel=1e-14)


def calls_of_math():
    for name in sorted(n for n in dir(math) if not n.startswith("_")):
        if not callable(getattr(math, name)):
            yield name, f"math.{name}"
            continue
        for call in (f"math.{name}(u[0])", f"math.{name}(u[0], u[1])"):
            try:
                value = eval(call, {"math": math, "u": [0.8, 2.5]})
            except (TypeError, ValueError):
                continue
            if isinstance(value, float | int) and call != "math.hypot(u[0])":
                yield name, call


def test_every_name_of_math_is_read_or_refused(tmp_path, monkeypatch):
    calls = list(calls_of_math())
    lines = ["import math"]
    for k, (_, call) in enumerate(calls):
        lines += ["", "", f"def f{k}(t, x, u, p, y):", f"    y[0] = {call}"]
    (tmp_path / "every_math.py").write_text("\n".join(lines) + "\n")
    monkeypatch.syspath_prepend(tmp_path)
    module = importlib.import_module("every_math")
    u, symbols = np.array([0.8, 2.5]), np.array(sympy.symbols("a b", real=True), dtype=object)
    wrong = []
    for k, (_, call) in enumerate(calls):
        function, python = getattr(module, f"f{k}"), np.zeros(1)
        try:
            check_equations(function, "mine.output")
        except BlockError:
            continue
        function(0.0, None, u, None, python)
        try:
            read = traced(function, 0, None, symbols, None, 1)[0]
            value = float(sympy.sympify(read).subs(dict(zip(symbols, u, strict=True))))
        except (AttributeError, TypeError, ValueError) as error:
            wrong.append(f"{call}: {error}")
            continue
        if not np.isclose(value, python[0], rtol=1e-12, atol=0, equal_nan=True):
            wrong.append(f"{call}: {value} for {python[0]}")
    assert len(calls) > 30
    assert not wrong, "allowed, but not read by SymPy: " + "; ".join(wrong)


def test_every_word_has_a_symbolic_reading():
    assert set(WORDS) | {"math"} == set(symbolic_substitutes())
    assert all(word.__doc__ for word in WORDS.values())


def test_where_takes_nan_from_neither_side_alone():
    assert where(True, 1.0, math.nan) == 1.0
    assert where(False, math.nan, 2.0) == 2.0


@pytest.mark.parametrize(
    ("word", "arguments", "value"),
    [
        (clip, (-3.0, -1.0, 1.0), -1.0),
        (clip, (0.25, -1.0, 1.0), 0.25),
        (clip, (9.0, -1.0, 1.0), 1.0),
        (sign, (-2.0,), -1.0),
        (sign, (0.0,), 0.0),
        (sign, (4.0,), 1.0),
        (floor, (-0.5,), -1.0),
        (floor, (-2.0,), -2.0),
        (floor, (2.999,), 2.0),
        (minimum, (1.0, -1.0), -1.0),
        (maximum, (1.0, -1.0), 1.0),
        (lookup, ([4.0, 5.0], 1.0), 5.0),
    ],
)
def test_words_at_points(word, arguments, value):
    assert word(*arguments) == value
