"""Regions from which every run comes to rest, against samples of V' in plain NumPy and runs."""

import control
import numpy as np
import pytest
import sympy
from hypothesis import given, settings
from hypothesis import strategies as st
from written_systems import NUMPY, written

import clpt_control as clpt
from clpt_control.errors import ClptError
from clpt_control.theory import lyapunov
from clpt_control.theory.proving.words import CLIP, GT, MAXIMUM, SIGN, WHERE
from clpt_control.theory.region import enclosed

X, Y = sympy.symbols("x y", real=True)


OSCILLATOR = "a' = -b; b' = a + (a**2 - 1)*b"  # Khalil's example 8.9
INSIDE = "(abs(a - 0.5) < 1e-3) & (abs(b - 0.25) < 1e-3)"
CASES = {  # rates, V, box
    "Khalil's oscillator": (OSCILLATOR, "1.5*a**2 - a*b + b**2", 3.0),
    "a pendulum at the top, with a limited torque": (
        "a' = b; b' = sin(a) - clip(8*a + 4*b, -2, 2)",
        "(9*a**2 + a*b + b**2)/7",
        2.0,
    ),
    "a drag, whose slope has a kink at rest": (
        "a' = -2*a + abs(b)*b; b' = -b - 0.1*abs(b)*b",
        "a**2 + b**2",
        9.0,
    ),
    "a pocket that is hard to see": (f"a' = where({INSIDE}, 9.0, -a); b' = -b", "a**2 + b**2", 1.0),
}


@pytest.mark.parametrize("name", CASES)
def test_the_level_is_where_samples_of_the_rate_first_fail(name):
    text, V_text, half = CASES[name]
    box = dict.fromkeys("ab", (-half, half))
    plant, level = written(f"{text}; V = {V_text}")
    found = lyapunov(plant, level, within=box)
    assert found.status == "proved in a region"
    V = eval(f"lambda a, b: {V_text}", NUMPY)
    a, b = np.meshgrid(*[np.linspace(-half, half, 2001)] * 2)
    rates = [eval(part[5:], NUMPY, {"a": a, "b": b}) for part in text.split("; ")]
    h = 1e-6
    slopes = (V(a + h, b) - V(a - h, b)) / (2 * h), (V(a, b + h) - V(a, b - h)) / (2 * h)
    rate = sum(slope * own for slope, own in zip(slopes, rates, strict=True))
    away = np.hypot(a, b) > 1e-3
    edge = (np.abs(a) == half) | (np.abs(b) == half)
    fails = V(a, b)[edge | (away & (rate >= 0))].min()
    assert 0.98 * fails < found.level <= fails


def test_khalils_oscillator_is_found_without_a_v_and_its_region_ends_within_the_cycle():
    oscillator, _ = written(OSCILLATOR)
    found = lyapunov(oscillator, within={"a": (-3, 3), "b": (-3, 3)})
    assert str(found.V) == "3*a**2/2 - a*b + b**2"  # P of A'P + PA = -I, by hand
    assert 2.25 < found.level < 2.31  # Khalil reads 2.25 off a contour
    around = np.linspace(0, 2 * np.pi, 9)[:-1]
    for way in np.stack([np.cos(around), np.sin(around)], axis=1):
        size = np.sqrt(0.999 * found.level / (1.5 * way[0] ** 2 - way[0] * way[1] + way[1] ** 2))
        assert np.abs(clpt.simulate(oscillator, [0, 40.0], 0, size * way).states[-1]).max() < 1e-4


def judged(text, *box):
    plant, V, *more = written(text)
    return lyapunov(plant, V, within={"x": box}, **dict(*more))


def test_a_level_is_exact_where_it_is_known_by_hand():
    cubic = "x' = -x + x**3; V = x**2"  # V' < 0 for 0 < x^2 < 1
    assert 0.999 <= judged(cubic, -3, 2).level <= 1.0
    assert 0.249 <= judged(cubic, -0.5, 2).level <= 0.25  # V on the nearer edge
    found = judged("x' = sin(x); V = 1 + cos(x); at x = pi", 1, 5)  # V' = -sin(x)^2
    assert 0.999 * (1 + np.cos(5)) <= found.level <= 1 + np.cos(5)


def test_inputs_and_parameters_as_they_are_are_said():
    box = {"x": (-1, 1)}
    damped = control.nlsys(lambda t, x, u, p: -x + x**3, states=["x"], inputs=0, params={"k": 1.0})
    assert "as they are" not in lyapunov(damped, lambda s: s.x**2, within=box).claim
    said = judged("x' = -k*x; k = 2; V = x**2", -1, 1).claim
    assert "with the parameters as they are: what begins there comes to rest" in said
    found = judged("x' = -x + x**3 + d; input d; V = x**2", -2, 2)
    assert (found.status, found.inputs) == ("proved in a region where d = 0", ("d",))


NOT_SHOWN = {
    "unstable": "x' = x",
    "no rest": "x' = 1 - x",
    "an edge at the rest": "x' = -sign(x)",
    "no value beside it": "x' = -x + x/(x - 1)",
}


@pytest.mark.parametrize("name", NOT_SHOWN)
def test_what_is_not_shown_is_open(name):
    found = judged(f"{NOT_SHOWN[name]}; V = x**2", -2, 2)
    assert (found.status, found.level) == ("open", None)


@pytest.mark.parametrize(
    ("text", "within", "sentence"),
    [
        ("x' = -x", {"q": (-1, 1)}, "has no 'q'; states are x"),
        ("x' = -x", {"x": (1, 2)}, "x from 1 to 2; must be finite, with the rest, 0, between"),
        ("x' = -x", {"x": (-1, np.inf)}, "must be finite"),
        ("x' = -x", {"x": (-1, 0, 1)}, "must be an array of numbers"),
        ("x' = -x*(2 + sin(t))", {"x": (-1, 1)}, "no region that lasts, for it moves with t"),
    ],
)
def test_a_box_or_a_system_that_has_no_region_is_refused(text, within, sentence):
    with pytest.raises(ClptError, match=sentence):
        lyapunov(*written(text), within=within)


# --- enclosures ----------------------------------------------------------------------------------

LEAVES = st.one_of(
    st.sampled_from([X, Y]), st.integers(-3, 3).map(sympy.Integer), st.just(sympy.Rational(1, 7))
)
ONE = [sympy.sin, sympy.cos, sympy.exp, sympy.tanh, sympy.atan, sympy.cosh, SIGN, sympy.Abs]
ONE += [lambda a: a**2, lambda a: a**3, lambda a: 1 / (2 + a**2), lambda a: sympy.sqrt(1 + a**2)]
TWO = [
    sympy.Add,
    sympy.Mul,
    MAXIMUM,
    lambda a, b: CLIP(a, -1, b),
    lambda a, b: WHERE(GT(a, b), a, 2),
]
EXPRESSIONS = st.recursive(
    LEAVES,
    lambda inner: st.one_of(
        st.tuples(st.sampled_from(ONE), inner).map(lambda p: p[0](p[1])),
        st.tuples(st.sampled_from(TWO), inner, inner).map(lambda p: p[0](p[1], p[2])),
    ),
    max_leaves=8,
)
WORDS = {
    "clip": lambda a, low, high: np.minimum(np.maximum(a, low), high),
    "maximum": np.maximum,
    "sign": np.sign,
    "gt": lambda a, b: np.where(a > b, 1.0, 0.0),
    "where": lambda c, a, b: np.where(c != 0, a, b),
}


@settings(max_examples=60, deadline=None, derandomize=True)
@given(EXPRESSIONS, st.floats(-3, 3), st.floats(-3, 3), st.floats(0, 2), st.floats(0, 2))
def test_an_enclosure_holds_every_sample(expression, x, y, wide, high):
    boxes = {
        s: (np.array([at]), np.array([at + size])) for s, at, size in ((X, x, wide), (Y, y, high))
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
    for e in (1 / X, sympy.log(X), sympy.sqrt(X), X ** sympy.Rational(-1, 3), 0 * Y + X**-2):
        low, high = enclosed(e, box)
        assert np.isfinite([low, high]).all(axis=0).tolist() == [False, True]
    with pytest.raises(ClptError, match="no function whose range in a box is known"):
        enclosed(sympy.gamma(X), box)
