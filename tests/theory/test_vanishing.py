"""`vanishes`: zero where it is, not zero where it is not, whatever is divided by."""

import pytest
import sympy
from hypothesis import given, settings
from hypothesis import strategies as st

from clpt_control.theory.proving.signs import vanishes

x, y, z = sympy.symbols("x y z", real=True)
f = sympy.Function("f")(x)
d = 1 + x**2

ZERO = [
    sympy.Integer(0),
    (x + y) ** 2 - x**2 - 2 * x * y - y**2,
    1 / (1 + 1 / d) - d / (d + 1),
    x / d**3 + 1 / d**2 - (x + d) / d**3,
    f * (y + 1 / f) - 1 - y * f,
    sympy.sqrt(d) ** 3 / sympy.sqrt(d) - d,
    0.5 * x - x / 2,
    (x**2 - y**2) / (x - y) - x - y,
]
NOT_ZERO = [
    sympy.Integer(1),
    (x + y) ** 2 - x**2 - y**2,
    1 / (1 + 1 / d) - d / (d + 2),
    f - sympy.Function("g")(x),
    sympy.sqrt(d) - d,
    1 / x,
]


@pytest.mark.parametrize("expression", ZERO, ids=str)
def test_what_is_zero_vanishes(expression):
    assert vanishes(expression)


@pytest.mark.parametrize("expression", NOT_ZERO, ids=str)
def test_what_is_not_zero_does_not(expression):
    assert not vanishes(expression)


def test_a_division_by_what_is_zero_does_not_vanish():
    hidden = (x + y) ** 2 - x**2 - 2 * x * y - y**2
    assert not vanishes(z / hidden)
    assert not vanishes(z / (1 / x + 1 / y - (x + y) / (x * y)))


SIMPLE = st.sampled_from([x, y, z, sympy.Integer(2), sympy.Rational(-1, 3)])
EXPRESSIONS = st.recursive(
    SIMPLE,
    lambda own: st.one_of(
        st.builds(sympy.Add, own, own),
        st.builds(sympy.Mul, own, own),
        st.builds(lambda a: 1 / (a**2 + 1), own),
    ),
    max_leaves=6,
)


@settings(max_examples=60, derandomize=True, deadline=None)
@given(EXPRESSIONS, EXPRESSIONS)
def test_it_says_what_cancelling_says(one, other):
    assert vanishes(one - sympy.expand(one))
    assert vanishes(one - other) == (sympy.cancel(sympy.together(one - other)) == 0)
