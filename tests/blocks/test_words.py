"""The words and `math`: every reading gives what Python does."""

import math
from functools import cache, partial
from typing import NamedTuple

import numpy as np
import pytest
import sympy
from hypothesis import HealthCheck, example, given, settings
from hypothesis import strategies as st

from clpt_control.blocks import Block, symbolic
from clpt_control.blocks.symbolic import expressions
from clpt_control.blocks.trace import COUNTS
from clpt_control.blocks.words import (
    MATH,
    WORDS,
    clip,
    floor,
    lookup,
    maximum,
    minimum,
    sign,
    where,
)
from clpt_control.errors import BlockError
from clpt_control.native import readings
from clpt_control.native.elementary import OPERATIONS

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


@cache
def asked(function, inputs, size):
    """Every reading of a function of inputs alone."""
    block = Block("mine", output=function, inputs={"u": inputs}, outputs={"y": size})
    return readings(block)


def agree(function, u, size, tolerance=0.0):
    """What the function itself computes, which every reading must give."""
    python = np.full(size, np.nan)
    function(0.0, np.zeros(0), [float(number) for number in u], (), python)
    assert np.all(np.isfinite(python))
    for name, ask in asked(function, len(u), size).items():
        found = ask(0.0, [], u)[1]
        np.testing.assert_allclose(found, python, rtol=tolerance, atol=tolerance, err_msg=name)
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
    s, whole, rest, ceiling = agree(steps, [a, b], 4)
    assert s * abs(a) == a
    assert whole <= a < whole + 1
    assert whole == int(whole)
    assert 0.0 <= rest <= 3.0
    assert ceiling >= b > ceiling - 1


@pytest.mark.parametrize("size", [1, 4, 9])
def test_lookup(size):
    table = np.random.default_rng(size).normal(size=size)
    block = Block(
        "mine", output=looked_up, inputs={"u": 1}, outputs={"y": 1}, parameters=Table(table)
    )
    for name, ask in readings(block).items():
        for index in range(-size, size):
            for away in (0.0, 0.5 if index >= 0 else -0.5):  # towards zero
                assert ask(0.0, [], [index + away])[1][0] == table[index], (name, index)
        for index in (size, -size - 1, math.inf, -math.inf, math.nan, 1e300):
            assert math.isnan(ask(0.0, [], [index])[1][0]), (name, index)


def test_lookup_at_a_symbol_is_undefined():
    block = Block(
        "mine", output=looked_up, inputs={"u": 1}, outputs={"y": 1}, parameters=Table(np.zeros(3))
    )
    s = sympy.Symbol("s")
    names = {"t": None, "p": None, "u": s, "table": "the_table"}
    (found,) = expressions(block.output_record, lambda name, *where: names[name])
    assert found.func.__name__ == "lookup_the_table"
    assert found.args == (s,)


@repeatable
@given(numbers, numbers, numbers)
@example(0.0, 0.0, 0.0)
def test_math(a, b, c):
    agree(elementary, [a, b, c], 7, tolerance=1e-13)


U = (0.8, 2.5)


def calls_of_math():
    for name in sorted(n for n in dir(math) if not n.startswith("_")):
        if not callable(getattr(math, name)):
            yield f"math.{name} + 0.0 * u[0]"
            continue
        for arguments in ("u[0]", "u[1]", "u[0], u[1]", "u[0], u[1], u[0]"):
            try:
                value = eval(f"math.{name}({arguments})", {"math": math, "u": U})
            except (TypeError, ValueError):
                continue
            if isinstance(value, float | int):
                yield f"math.{name}({arguments})"


@pytest.mark.parametrize("call", list(calls_of_math()))
def test_every_name_of_math_is_read_or_refused(call):
    space = {"math": math}
    exec(f"def f(t, x, u, p, y):\n    y[0] = {call}", space)
    make = partial(Block, "mine", output=space["f"], inputs={"u": 2}, outputs={"y": 1})
    name, numbers = call.removeprefix("math.").split("(")[0].split(" ")[0], call.count("u[")
    if name not in MATH or numbers != COUNTS.get(name, 1):
        with pytest.raises(BlockError, match=f"`(math.)?{name}`"):
            make()
        return
    block = make()
    space["f"](0.0, None, U, None, python := [0.0])
    for name, ask in readings(block).items():
        assert ask(0.0, [], U)[1][0] == pytest.approx(python[0], rel=1e-14, abs=1e-16), name


def test_every_word_is_read_and_says_what_it_does():
    assert set(WORDS) - {"lookup"} <= set(OPERATIONS)
    assert set(WORDS) - {"lookup"} <= set(symbolic.OPERATIONS)
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
