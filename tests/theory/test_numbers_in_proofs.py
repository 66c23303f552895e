"""Doubles in proofs: each is itself, and another one a single ulp beside it is another number.

Right values: exact fractions of the doubles, and the last digit that tells doubles apart.
"""

import re
from fractions import Fraction

import control
import numpy as np
import pytest
import sympy
from coq_files import REALS, compiled
from text_systems import written

import clpt_control as clpt

ABOVE_1 = float(np.nextafter(1.0, 2.0))
BELOW_1 = float(np.nextafter(1.0, 0.0))
HALF = lambda s: s.x**2 / 2  # noqa: E731


def loop(rates, names="x", **more):
    states = dict.fromkeys(names, 1)
    return clpt.Block(
        "loop", update=lambda t, x, u, p: rates(x, u, p), states=states, **more
    )


def printed_rate(verdict):
    """V' of a sentence, as it is read, with exact numbers."""
    text = re.search(r"V' = (.*?) <= ", verdict.sentence)[1]
    names = {str(s): s for s in verdict.rate.free_symbols}
    return sympy.parse_expr(text, names)


@pytest.mark.parametrize("share", [BELOW_1, 1.0, ABOVE_1])
def test_a_gain_of_one_is_not_one_and_an_ulp(share):
    """x+ = share x, V = x^2/2: V falls if share < 1, stays if it is 1, and rises above."""
    assert (Fraction(float(share)) > 1) == (share == ABOVE_1)
    verdict = clpt.lyapunov(loop(lambda x, u, p: {"x": share * x.x}, dt=1.0), HALF)
    assert (verdict.status == "proved") == (share <= 1)
    stable = "asymptotically stable" if share < 1 else "stable"
    assert verdict.conclusion == (stable if share <= 1 else "")


@pytest.mark.parametrize("third", [1 / 3, np.nextafter(1 / 3, 1)])
def test_a_third_is_not_the_double_beside_it(third):
    """V' = -(x - y/3)^2 - (1/9 - third^2) y^2, of the double above a third indefinite."""
    V = lambda s: s.x**2 / 2  # noqa: E731
    system = loop(lambda x, u, p: {"x": -x.x + third * x.y, "y": 0 * x.y}, "xy")
    claim = lambda s: -((s.x - s.y / 6) ** 2) + s.y**2 / 36  # noqa: E731
    verdict = clpt.lyapunov(system, V, claim=claim)
    assert (verdict.status == "proved") == (third == 1 / 3)


@pytest.mark.parametrize("y_weight", [0.25, 0.2499999999999999])
def test_a_weight_of_V_is_itself(y_weight):
    """V = x^2/2 + w y^2/2, x' = -x + y, y' = -y: V' <= 0 for w >= 1/4."""
    V = lambda s: s.x**2 / 2 + y_weight * s.y**2 / 2  # noqa: E731
    verdict = clpt.lyapunov(loop(lambda x, u, p: {"x": -x.x + x.y, "y": -x.y}, "xy"), V)
    assert (verdict.status == "proved") == (Fraction(y_weight) >= Fraction(1, 4))


@pytest.mark.long
@pytest.mark.parametrize("r", [1.0, ABOVE_1])
def test_a_parameter_is_itself(r):
    """Lorenz with V = x^2/s + y^2 + z^2: V' <= 0 for r <= 1."""
    verdict = clpt.lyapunov(
        *written(
            "x' = s*(y - x); y' = r*x - y - x*z; z' = x*y - b*z; "
            f"V = x**2/s + y**2 + z**2; s = 10; r = {r!r}; b = 3"
        )
    )
    assert (verdict.status == "proved") == (r == 1)


def test_bounds_of_inputs_print_their_last_digit():
    """x' = -x + d, V = x^2/2, |d| <= 2 or an ulp more: the level is above its square over 2."""
    sentences = set()
    for most in (2.0, float(np.nextafter(2.0, 3.0))):
        system = loop(lambda x, u, p: {"x": -x.x + u.d}, inputs={"d": 1})
        verdict = clpt.lyapunov(system, HALF, where={"d": (-most, most)})
        assert f"d <= {most!r}".removesuffix(".0") in verdict.sentence
        assert Fraction(float(verdict.level)) >= Fraction(most) ** 2 / 2
        sentences.add(verdict.sentence)
    assert len(sentences) == 2


@pytest.mark.parametrize("rate", [1.0, ABOVE_1])
def test_a_relation_that_leaves_by_an_ulp_is_not_kept(rate):
    """y = x of x' = -x, y' = -rate y."""
    system = loop(lambda x, u, p: {"x": -x.x, "y": -rate * x.y}, "xy")
    verdict = clpt.lyapunov(system, HALF, keeps=lambda s: [s.y - s.x])
    assert (verdict.status == "proved") == (rate == 1)


@pytest.mark.sampled
@pytest.mark.parametrize("value", ["2.0", "2.0000000000000004"])
def test_values_of_parameters_print_their_last_digit(value):
    """x' = -(k - 1) x needs the value of k where k > 1 is not assumed."""
    verdict = clpt.lyapunov(*written(f"x' = -sin(k)*x; V = x**2/2; k = {value}"))
    assert verdict.status == "proved"
    assert f"k = {value.removesuffix('.0')}" in verdict.sentence + str(
        verdict.conditions
    )


NUMBERS = [
    1e-13,
    1 + 1e-13,
    ABOVE_1,
    1 / 7,
    2**0.5,
    1e-9 * 1.0000002384626434,
    12345678.912345678,
]


@pytest.mark.parametrize("number", NUMBERS)
def test_the_printed_rate_is_the_one_that_was_judged(number):
    """V' = -x^4 - c x^2: both of its printed numbers are the doubles."""
    verdict = clpt.lyapunov(loop(lambda x, u, p: {"x": -(x.x**3) - number * x.x}), HALF)
    printed = sympy.Poly(printed_rate(verdict)).as_dict()
    judged = sympy.Poly(verdict.rate).as_dict()
    assert {m: float(c) for m, c in printed.items()} == {
        m: float(c) for m, c in judged.items()
    }
    assert float(-judged[(2,)]) == number


def test_a_rate_near_another_is_printed_as_itself():
    """-x ((x - 1)^2 + 1e-13): V' as it reads is below 0 at x = 1."""
    system = loop(lambda x, u, p: {"x": -x.x * ((x.x - 1) ** 2 + 1e-13)})
    rate = printed_rate(clpt.lyapunov(system, HALF))
    (x,) = rate.free_symbols
    assert rate.subs(x, 1) < 0


def test_a_long_rate_says_that_its_digits_are_few():
    """A model of identified numbers: a line has six digits of them, `whole` and LaTeX all."""
    numbers = np.random.default_rng(3).uniform(0.5, 2.0, 8)
    names = [f"x{k}" for k in range(8)]
    system = loop(
        lambda x, u, p: {
            n: -c * getattr(x, n) for n, c in zip(names, numbers, strict=True)
        },
        names,
    )
    verdict = clpt.lyapunov(
        system, lambda s: sum(getattr(s, n) ** 2 for n in names) / 2
    )
    assert verdict.status == "proved"
    assert "(6 digits)" in verdict.sentence
    assert len(verdict.sentence) <= 300
    assert all(f"{float(number)!r}" in verdict.claim.whole for number in numbers)
    assert all(f"{float(number)!r}" in verdict.latex() for number in numbers)


# --- coqc ---------------------------------------------------------------------------------------

NEGATIVE = {
    "a cubic": "x' = -x*(x**2 - a)**2; V = x**2/2; a = -1",
    "two states": "x' = -x + v*x; v' = -v - x**2 + 2*a*v**3; V = x**2/2 + v**2/2; a = -2",
    "two of them": "x' = 3*a*x + 2*b*a*x**3; V = x**2/2; a = -1; b = 2",
}


@pytest.mark.coq
@pytest.mark.parametrize("name", NEGATIVE)
def test_weights_of_negative_parameters_compile(name, tmp_path):
    verdict = clpt.lyapunov(*written(NEGATIVE[name]))
    assert verdict.status == "proved"
    assert compiled(tmp_path, verdict.coq()) == (True, REALS)


def test_states_with_names_of_arrays_are_signals():
    """x' = -x, size' = size: V = x^2 + size^2 rises, though an array has a size of 2."""
    loop = control.nlsys(
        lambda t, x, u, p: [-x[0], x[1]],
        inputs=0,
        states=["x", "size"],
        outputs=["x", "size"],
    )
    verdict = clpt.lyapunov(loop, lambda s: s.x**2 + s.size**2)
    assert verdict.status == "refuted"
