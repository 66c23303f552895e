"""Exact algebra that proofs rest on: zero tests, factors, sums of squares, and enclosures."""

import numpy as np
import pytest
import sympy
from error_sentences import says
from hypothesis import given, settings
from hypothesis import strategies as st

from clpt_control import ClptError
from clpt_control.theory.algebra.exact import factored, vanishes
from clpt_control.theory.algebra.facts import CLIP, GT, MAXIMUM, SIGN, WHERE
from clpt_control.theory.algebra.gram import sum_of_squares
from clpt_control.theory.algebra.sums_of_squares import squares
from clpt_control.theory.proofs.region import enclosed

x, y, z = sympy.symbols("x y z", real=True)
f, d = sympy.Function("f")(x), 1 + x**2

HIDDEN = (x + y) ** 2 - x**2 - 2 * x * y - y**2
VANISHES = [
    HIDDEN,
    1 / (1 + 1 / d) - d / (d + 1),
    x / d**3 + 1 / d**2 - (x + d) / d**3,
    f * (y + 1 / f) - 1 - y * f,
    sympy.sqrt(d) ** 3 / sympy.sqrt(d) - d,
    0.5 * x - x / 2,
    (x**2 - y**2) / (x - y) - x - y,
]
DOES_NOT = [
    1 / (1 + 1 / d) - d / (d + 2),
    f - sympy.Function("g")(x),
    sympy.sqrt(d) - d,
    1 / x,
    z / HIDDEN,  # divided by what is zero
    z / (1 / x + 1 / y - (x + y) / (x * y)),
]


@pytest.mark.parametrize("expression", VANISHES + DOES_NOT, ids=str)
def test_what_is_zero_vanishes_and_nothing_else(expression):
    assert vanishes(expression) is (expression in VANISHES)


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


# --- sums of squares ---

SUMS = "x**2 + x*y + y**2; (y + x**3)**2 + x**2; k*(1 - cos(x)) + y**2; exp(x) - x - 1"
RISING = "x**2*exp(-y); x*atan(x) - log(1 + x**2)/2"
NO_SUMS = "x**2 + 3*x*y + y**2; x**4 - 2*x**3 + 0.999*x**2; x**3; x**2*y**2 - x*y"


@pytest.mark.parametrize("chance", [1, 12, 16])
def test_what_has_no_factors_is_told_whatever_places_sympy_draws(chance):
    """With SymPy's own few places it took minutes or more after these."""
    a, b, c, x, y = sympy.symbols("a b c x y", real=True)
    of_x = (x**2 - 1) * (180 * x**2 - 200 * x * a - 189 * x * sympy.tanh(x))
    of_y = y * (b * y * (55 * y * sympy.cos(y) + 110 * sympy.sin(y) + 220))
    of_y += y * c * (50 * y * sympy.cos(y) + 100 * sympy.sin(y) + 200)
    whole = sympy.expand(of_x - of_y * sympy.exp(x**2))
    sympy.core.cache.clear_cache()
    sympy.core.random.seed(chance)
    assert sympy.expand(factored(whole) - whole) == 0


@pytest.mark.parametrize("text", f"{SUMS}; {RISING}; {NO_SUMS}".split("; "))
def test_sums_of_squares(text):
    names = {s: sympy.Symbol(s, real=True) for s in "xy"} | {
        "k": sympy.Symbol("k", positive=True)
    }
    V = sympy.nsimplify(sympy.sympify(text, locals=names), rational=True)
    found = squares(V, {names["k"]})
    assert (found is None) == (text in NO_SUMS.split("; "))
    if found is not None:
        assert sympy.simplify(sympy.Add(*found.terms) + found.constant - V) == 0
        random = np.random.default_rng(0)
        at = [
            dict(zip(names.values(), abs(random.normal(size=3)), strict=True))
            for _ in range(50)
        ]
        assert (
            min([float(term.subs(one)) for one in at for term in found.terms]) > -1e-9
        )


# --- enclosures ---

X, Y = sympy.symbols("x y", real=True)
ENDS_OF_TREES = st.one_of(
    st.sampled_from([X, Y]),
    st.integers(-3, 3).map(sympy.Integer),
    st.just(sympy.Rational(1, 7)),
)
ONE = [
    sympy.sin,
    sympy.cos,
    sympy.exp,
    sympy.tanh,
    sympy.atan,
    sympy.cosh,
    SIGN,
    sympy.Abs,
]
ONE += [
    lambda a: a**2,
    lambda a: a**3,
    lambda a: 1 / (2 + a**2),
    lambda a: sympy.sqrt(1 + a**2),
]
TWO = [sympy.Add, sympy.Mul, MAXIMUM, lambda a, b: CLIP(a, -1, b)]
TWO += [lambda a, b: WHERE(GT(a, b), a, 2)]
FUNCTIONS = st.recursive(
    ENDS_OF_TREES,
    lambda inner: (
        st.builds(lambda f, a: f(a), st.sampled_from(ONE), inner)
        | st.builds(lambda f, a, b: f(a, b), st.sampled_from(TWO), inner, inner)
    ),
    max_leaves=8,
)
WORDS = {
    "clip": lambda a, low, high: np.minimum(np.maximum(a, low), high),
    "gt": lambda a, b: np.where(a > b, 1.0, 0.0),
    "where": lambda c, a, b: np.where(c != 0, a, b),
}


@settings(max_examples=60, deadline=None, derandomize=True)
@given(FUNCTIONS, st.floats(-3, 3), st.floats(-3, 3), st.floats(0, 2), st.floats(0, 2))
def test_an_enclosure_holds_every_sample(expression, x, y, wide, high):
    boxes = {
        s: np.array([[at], [at + size]]) for s, at, size in ((X, x, wide), (Y, y, high))
    }
    low, top = (float(end[0]) for end in enclosed(expression, boxes))
    share = np.linspace(0, 1, 7)
    a, b = np.meshgrid(x + wide * share, y + high * share)
    with np.errstate(all="ignore"):
        values = sympy.lambdify([X, Y], expression, [WORDS, "numpy"])(a, b) + 0 * a
    known = values[np.isfinite(values)]
    slack = 1e-13 * (1 + np.abs(known))  # the samples are rounded, too
    assert np.all((known >= low - slack) & (known <= top + slack))


def test_what_has_no_value_in_a_box_is_not_enclosed():
    box = {X: (np.array([-1.0, 0.5]), np.array([1.0, 2.0]))}
    for e in (
        1 / X,
        sympy.log(X),
        sympy.sqrt(X),
        X ** sympy.Rational(-1, 3),
        0 * Y + X**-2,
    ):
        low, high = enclosed(e, box)
        assert np.isfinite([low, high]).all(axis=0).tolist() == [False, True]
    says(
        ClptError,
        "not a function whose range in a box is known",
        enclosed,
        sympy.gamma(X),
        box,
    )


@pytest.mark.parametrize("power", [-400, 0, 400])
def test_a_sum_of_squares_has_coefficients_that_no_double_holds(power):
    """10^power ((x - y)^2 + x^2 + x^4)."""
    p = sympy.expand(sympy.Integer(10) ** power * ((x - y) ** 2 + x**2 + x**4))
    found = sum_of_squares(p)
    assert sympy.expand(sum(w * g * form**2 for w, g, form in found.terms)) == p
    assert all(w > 0 for w, _, _ in found.terms)
