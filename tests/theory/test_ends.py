"""Ends of loops: each premise of LaSalle's principle and of Barbalat's lemma, held and broken.

A loop that breaks a premise has a witness: states at which nothing moves, off the rest of V, or
a closed form in the comment of its row.
"""

import numpy as np
import pytest
import sympy
from lyapunov_cases import ORDER as STRONGEST_FIRST
from text_systems import TICKS, conclusion_of, signals, written

import clpt_control as clpt
from clpt_control.engine.model.declaration import Each

ORDER = (*STRONGEST_FIRST, "")
AS, REST, RATES, ZERO, INTEGRAL, STABLE, *_ = ORDER
SIZE = "V = x**2 + y**2"
TURNED = "V = v**2/2 + 1 - cos(x)"

BROKEN = {  # kind -> text, the strongest true conclusion, a state at which nothing moves
    "zero at the numbers": [
        ("x' = -x + (a - b)*y; y' = -(a - b)*x; a = 2; b = 2", REST, [0, 1]),
        ("x' = -x + sin(a)*y; y' = -sin(a)*x; a = 0", REST, [0, 1]),
        ("x' = -x + maximum(a, 0)*y; y' = -maximum(a, 0)*x; a = -3", REST, [0, -2]),
        ("x' = -x + (a**2 - 4)*y; y' = -(a**2 - 4)*x; a = -2", REST, [0, 5]),
        ("x' = -x + (k - 2*m)*y**3; y' = -(k - 2*m)*x*y**2; k = 2; m = 1", REST, [0, 3]),
        ("x' = -x + floor(a)*y; y' = -floor(a)*x; a = 0.4", REST, [0, 1]),
        (  # in phase both swing for ever: no rest
            "x' = v; p' = q; v' = -a*x - (v - q); q' = -b*p - (q - v); a = 3; b = 3; "
            "V = v**2 + q**2 + a*x**2 + b*p**2", ZERO, None,
        ),
    ],
    "a margin of parameters that is zero, or not enough": [
        ("x' = -(1 - r)*x; r = 1", STABLE, [2]),
        ("x' = -y*(b - a) - x; y' = x*(b - a); a = 2; b = 2", REST, [0, 1]),
        ("x' = -(4*a - b**2)*x; y' = -y; a = 1; b = 2", REST, [1, 0]),
        ("x' = v; v' = -x - (b - a)*v; a = 0.3; b = 0.3", STABLE, None),
        ("x' = v; v' = -x - (b - a)*v - sign(v); a = 1; b = 2", ZERO, None),
        ("x' = v; v' = -x - (b - a)*v*maximum(x, 0)**2; a = 1; b = 2", ZERO, None),
        ("x' = -(b - a)*x*where(y > 0, 0, 1)**2; y' = -y; a = 1; b = 2", ZERO, None),
        ("x' = -(1 - r)*x; y' = -y*x**2; r = 0.5", REST, [0, 1]),
        ("x' = -(b - a)*x/(1 + y**2); y' = y; a = 1; b = 2; V = x**2", "V does not increase", None),
        ("x' = -(b - a)*x; y' = y**2; a = 1; b = 2; V = x**2", "square-integrable", None),
        ("x' = -(b - a)*exp(-t)*x; a = 1; b = 2", STABLE, None),
        ("x' = -(b - a)*x*exp(-y**2); y' = 1; a = 1; b = 2; V = x**2", "V does not increase", None),
    ],
    "a friction at one side alone": [
        ("x' = v; v' = -sin(x) - minimum(v, 0); " + TURNED, ZERO, None),  # turns on
        ("x' = v; v' = -x - minimum(v, 0); p' = q; q' = -p", ZERO, None),
        ("x' = -minimum(x, 0)", REST, [1]),
        ("x' = -maximum(x, 0); y' = -y", REST, [-1, 0]),
        ("x' = v; v' = -x - minimum(v, 0)*maximum(v, 0)", STABLE, None),
        ("x' = v; v' = -x - minimum(v, 0)**2*maximum(x, 0)**2*v", ZERO, None),
        ("x' = v; v' = -x*(x**2 - 1)**2 - minimum(v, 0); V = v**2/2 + (x**2 - 1)**3/6",
         ZERO, [1, 0]),
        ("x' = v*where(y > 0, 0, 1); v' = -x*where(y > 0, 0, 1) - minimum(v, 0); y' = -y",
         ZERO, None),
        ("x' = v; v' = -x - exp(-t)*minimum(v, 0)", STABLE, None),
        ("x' = v; v' = -x - u**2*minimum(v, 0); input u", INTEGRAL, None),
    ],
    "a loss that fades with time": [  # x stays above x(0) exp(-integral of the rate)
        ("x' = -x*exp(-t)", STABLE, None),
        ("x' = -x*(exp(-t) + exp(-2*t)); y' = -y", "goes to zero", None),
        ("x' = -x**3*exp(-t)*(1 + exp(-2*t))", STABLE, None),
        ("x' = -x/(1 + exp(t))", STABLE, None),
        ("x' = -x/(1 + t**4)", STABLE, None),
        ("x' = -x/(1 + t)**2", STABLE, None),
        ("x' = -x/(1 + t)**2*(2 + sin(t))", STABLE, None),
        ("x' = -x*cos(t)**2*exp(-t)", STABLE, None),
        ("x' = -x*sin(t)**2/(1 + t**2)", STABLE, None),
        ("x' = -x/(1 + t); y' = -y/(1 + t)**2", STABLE, None),
        ("x' = -x*where(t > 3, 0, 1)", STABLE, None),
        ("x' = -x*maximum(5 - t, 0)", STABLE, None),
        ("x' = -x*where(y > 0, 0, 1)**2/(1 + t); y' = -y/(1 + t)", STABLE, None),
        ("x' = -x/(1 + t)*u**2; input u", INTEGRAL, None),
        ("x' = -x/((1 + t)*(1 + u**2)); input u", STABLE, None),
        ("x' = v; v' = -x - v/(1 + t)**2", STABLE, None),
        ("x' = -x/(1 + t)**1.5", STABLE, None),
        ("x' = -x*(1 + sin(t))**2/(1 + t)**2", STABLE, None),
        ("x' = -x*cos(t)**2; y' = -y*exp(-t)", STABLE, None),
        ("x' = -x*y**2/(1 + t); y' = -y*x**2/(1 + t)", STABLE, [0, 1]),
        ("x' = -x*(1 + cos(t))*where(y > 0, 0, 1)**2; y' = -y*(1 + cos(t))", STABLE, None),
        ("x' = -(b - a)*x/(1 + t); a = 2; b = 2; y' = -y/(1 + t)", STABLE, [1, 0]),
        ("x' = v; v' = -x - (2 + t**2)*v", ZERO, None),  # overdamped: x stays
    ],
    "a loss whose weight may fade": [
        ("x' = -x*w**2; input w", INTEGRAL, None),
        ("x' = -x*w**2*(1 + w**2); y' = -y; input w", ZERO, None),
        ("x' = -x*(1 + w**2)*exp(-t); input w", STABLE, None),
        ("x' = -x*(1 + w**2)*where(y > 0, 0, 1)**2; y' = -y; input w", ZERO, None),
        ("x' = -x/(1 + w**2); input w", INTEGRAL, None),
        ("x' = -x/(1 + y**2); y' = y**3; V = x**2/2", "V does not increase", None),
        ("x' = -x*y**2*(1 + w**2); y' = -y*(1 + w**2); input w", ZERO, None),
        ("x' = y*w - x*(1 + w**2); y' = -x*w; input w", ZERO, [0, 1]),
    ],
    "zero to the rounding of its sum": [  # as it runs in doubles, exactly or to 1e-15
        ("x' = v; v' = -x - sin(a)*v; a = 3.141592653589793", STABLE, None),
        ("x' = v; v' = -x - (1 - tanh(a))*v; a = 20", STABLE, [0, 0]),
        ("x' = v; v' = -x - exp(-a)*v; a = 1000", STABLE, [0, 0]),
        ("x' = v; v' = -x - a**200*v; a = 0.01", STABLE, [0, 0]),
        ("x' = v; v' = -x - (c - a*b)*v; a = 1.4142135623730951; b = 1.7320508075688772; "
         "c = 2.4494897427831783", STABLE, [0, 0]),
        ("x' = -(1 + cos(a))*x**3; y' = -y; a = 3.141592653589793", REST, [1, 0]),
        (  # q alone swings for ever
            "x' = v; p' = q; v' = -x - (1 - cos(a))*(x - p) - 0.3*v; "
            "q' = -p - (1 - cos(a))*(p - x); a = 6.283185307179586; "
            "V = v**2 + q**2 + x**2 + p**2 + (1 - cos(a))*(x - p)**2", ZERO, None,
        ),
        (  # both have frequency 1, and swing in phase
            "x' = v; p' = q; v' = -x - (v - q); q' = cos(b)*p - (q - v); "
            "b = 3.141592653589793; V = v**2 + q**2 + x**2 - cos(b)*p**2", ZERO, None,
        ),
    ],
    "rates that jump": [  # sticks: the rates on both sides of v = 0 push back to it
        ("x' = v; v' = -x - 0.5*sign(v)", ZERO, None),
        ("x' = v; v' = -x - v - where(v > 0, 1.0, -1.0)", ZERO, None),
        ("x' = v; v' = -sin(x) - 0.2*v - 0.3*sign(v); " + TURNED, ZERO, None),
        ("x' = v; v' = -x**3 - F*sign(v); F = 2; V = v**2/2 + x**4/4", ZERO, None),
        ("v' = -v; x' = -y*sign(v); y' = x*sign(v)", ZERO, None),  # turns at speed 1
        ("v' = -v; x' = -y*floor(2 + tanh(v)); y' = x*floor(2 + tanh(v))", ZERO, None),
    ],
    "words of numbers": [
        ("x' = -x + y*maximum(x, 0); y' = -x*maximum(x, 0)", REST, [0, 3]),
        ("x' = -x + y*minimum(x, 0); y' = -x*minimum(x, 0)", REST, [0, 3]),
        ("x' = -x + y*abs(x); y' = -x*abs(x)", REST, [0, -3]),
        ("x' = -x + y*clip(x, -1, 2); y' = -x*clip(x, -1, 2)", REST, [0, 4]),
        ("x' = -x + y*(x - clip(x, -1, 1)); y' = -x*(x - clip(x, -1, 1))", REST, [0, 4]),
        ("x' = -x + y*where(x > 0, 2*x, x); y' = -x*where(x > 0, 2*x, x)", REST, [0, 4]),
        ("x' = -x + y*maximum(minimum(x, 1), 0); y' = -x*maximum(minimum(x, 1), 0)", REST, [0, 1]),
    ],
    "rests in a line": [  # the angle of (a, b) is the integral of a power of s that has none
        ("s' = -s**3; a' = -s*b; b' = s*a", RATES, [0, 1, 1]),
        ("s' = -s**3; a' = -s**2*b; b' = s**2*a", RATES, [0, 1, 1]),
        ("s' = -s**5; a' = -3*s**2*b; b' = 3*s**2*a", RATES, [0, 0, 1]),
        ("s' = -s**3; a' = -s*b/(1 + s**2); b' = s*a/(1 + s**2)", RATES, [0, 2, 0]),
        ("s' = -s**3; a' = -tanh(s)*b; b' = tanh(s)*a", RATES, [0, 2, 0]),
        ("s' = -s**3; a' = -maximum(s, 0)*b; b' = maximum(s, 0)*a", RATES, [0, 2, 0]),
    ],
    "forms that step": [  # an input that is on for 2**-n after n = 1, 2, ...
        ("x' = -where(u > 0.5, 1, 0)*x; input u", INTEGRAL, None),
        ("x' = -where(u < -1, 3, 0)*x; input u", INTEGRAL, None),
        ("x' = -sign(u)**2*x; input u", INTEGRAL, None),
        ("x' = -floor(clip(u, 0, 1))**2*x; input u", INTEGRAL, None),
        # ever shorter pulses, of which the sum is finite
        (
            "x' = -where(sin(c) > 1 - 1/(1 + c**4), 1, 0)**2*x; c' = 1 + 0*c; V = x**2",
            INTEGRAL, None,
        ),
    ],
    "losses that step": [  # y and z stay above 0, so x stands still
        ("x' = -x*where(y*z > 0, 0, 1)**2; y' = -y; z' = -2*z", ZERO, None),
        ("x' = -x*floor(1/(1 + y**2))**2; y' = -y", ZERO, None),
        ("x' = -x*where(y*y <= 0, 1, 0)**2 - x*y**2; y' = -y**3 - y", ZERO, None),
    ],
    "losses that fade": [  # the integral of tanh(exp(-t))^2 is at most 1/2: x stays off 0
        ("x' = -x*tanh(exp(-t))**2", ZERO, None),
        ("x' = -x*arctan(exp(-t))**2; y' = -y", ZERO, None),
    ],
}  # fmt: skip
HELD = {  # kind -> text, what must be shown
    "not zero at the numbers": [
        ("x' = -x + (a - b)*y; y' = -(a - b)*x; a = 2; b = 1", AS),
        ("x' = -x + sin(a)*y; y' = -sin(a)*x; a = 1", AS),
        ("x' = -x + maximum(a, 0)*y; y' = -maximum(a, 0)*x; a = 3", AS),
        ("x' = -x + (a**2 - 4)*y; y' = -(a**2 - 4)*x; a = -1", AS),
        (
            "x' = v; p' = q; v' = -a*x - (v - q); q' = -b*p - (q - v); a = 3; b = 2; "
            "V = v**2 + q**2 + a*x**2 + b*p**2", AS,
        ),
        ("x' = -x + a*y; y' = -a*x; a = 0.5", AS),
    ],
    "rates without jumps": [
        ("x' = v; v' = -x - 0.5*tanh(v)", AS),
        ("x' = v; v' = -x - where(v > 0, v, 2*v)", AS),  # meets at v = 0
        ("x' = v; v' = -x**3 - v*abs(v); V = v**2/2 + x**4/4", AS),
        ("x' = v; v' = -tanh(x) - v; V = v**2/2 + log(cosh(x))", AS),
        ("x' = v; v' = -x - clip(v, -1, 1)", AS),
        ("v' = -v - sign(v)", AS),  # V' < 0 but at the rest: no premise is asked for
        ("x' = -y - x - sign(x); y' = x - y", AS),
        ("s' = -2*sign(s) + sin(t)", AS),  # slides, as |sin(t)| < 2
    ],
    "words that are not zero": [
        ("x' = -x + y*(1 + maximum(x, 0)); y' = -x*(1 + maximum(x, 0))", AS),
        ("x' = -x + y*where(x > -1, 1, 1); y' = -x", AS),
        ("x' = -x + y*clip(x + 2, 1, 3); y' = -x*clip(x + 2, 1, 3)", AS),
    ],
    "rests that stand alone": [
        ("x' = v; v' = x - x**3 - v; V = v**2/2 + (x**2 - 1)**2/4", REST),
        ("x' = v; v' = -sin(x) - v; " + TURNED, REST),
        ("x' = v; v' = -sin(2*x) - 3*v; V = v**2 + 1 - cos(2*x)", REST),
        ("a' = b - a; b' = a - b", REST),  # linear: each run converges
        ("e' = -e - k*e; k' = e**2", REST),  # k only rises
        (  # a body, damped about one axis: at each level of V it turns about one of two others
            "x' = -y*z - x; y' = x*z; z' = -x*y/3; V = x**2 + 2*y**2 + 3*z**2", REST,
        ),
        ("x' = -x*(x - 1)**2", REST),
    ],
    "forms without steps": [
        ("e' = -e + th*r; th' = -e*r; V = e**2 + th**2; input r", ZERO),
        ("e' = -abs(e)*e + th*r; th' = -e*r; V = e**2 + th**2; input r", ZERO),
        ("e' = -e + th*r - maximum(e, 0); th' = -e*r; V = e**2 + th**2; input r", ZERO),
        ("e' = -(1 + where(r > 0, 1, 0))*e + th*r; th' = -e*r; V = e**2 + th**2; input r", ZERO),
        ("x' = -(2 + exp(minimum(t, 5)))*x + y; y' = -x", ZERO),
        ("x' = -where(u > 0, 2, 0)**2*x; y' = -y; input u", ZERO),  # y
    ],
    "losses that step, but not to zero": [
        ("x' = -x*where(y > 0, 1, 2)**2; y' = -y", AS),
    ],
    "losses beside squares": [
        ("x' = -x/sqrt(1 + x**2); y' = -y", AS),
        ("v' = -v*exp(-v**2); a' = -3*a + b; b' = -a - b", AS),
        ("x' = -x*exp(-y**2); y' = -y", AS),
        ("x' = -x*(x - 1)**2; y' = -y*(x - 1)**2", REST),
        ("a' = -a + b*r; b' = -a*r - (b - c)*r**2; c' = (b - c)*r**2; input r", ZERO),
        (  # V' = -b d (exp(u) - 1)^2 - a c (exp(w) - 1)^2
            "u' = a - a*exp(w) - d*(exp(u) - 1); w' = b*(exp(u) - 1) - c*(exp(w) - 1); "
            "a = 1; b = 2; c = 3; d = 0.3; V = b*(exp(u) - u) + a*(exp(w) - w)", AS,
        ),
    ],
    "one factor of several": [  # by cases: no run stays in the others
        ("x' = v; v' = -x - (4 - x**2)**2*v", AS),
        ("x' = v; v' = -x - sin(x)**2*v", AS),
        ("x' = v; v' = -x - v*(x**2 - 4)**2*(v - 1)**2", AS),
        ("x' = y*(x**2 + y**2); y' = -x*(x**2 + y**2) - y*(x - y)**2", AS),
        ("x' = -x*y**2; y' = -y*x**2", REST),  # on one of two axes
        ("x' = y + z; y' = z - x - y*(x - 1)**2; z' = -x - y", REST),  # 0, or (1, -1, 1)
        ("x' = v; v' = -x - v*(x**2 + v**2 - 1)**2", ZERO),  # may turn on the circle
        ("x' = v; v' = -x - y**2*v; y' = -y*v**2", ZERO),  # may swing where y = 0
        ("x' = v; v' = -x - maximum(x, 0)**2*v", ZERO),
        ("x' = -x*(x**2 + y**2 - 1)**2; y' = -y*(x**2 + y**2 - 1)**2", RATES),
    ],
    "a friction at one side of a rate": [
        ("x' = v; v' = -x - minimum(v, 0)", AS),
        ("x' = v; v' = -x**3 - 2*maximum(v, 0); V = v**2/2 + x**4/4", AS),
        ("x' = -v; v' = x - k*maximum(0, v); k = 2", AS),
    ],
    "a rate without a finite integral": [
        ("x' = -x/(1 + t)", AS),
        ("x' = -x**3*t/(1 + t**2)", AS),
        ("x' = -k*cos(t)**2*x; k = 2", AS),
        ("x' = y - x*(1 + sin(2*t)); y' = -x - y*(1 + sin(2*t))", AS),
    ],
    "what fades beside what stays": [
        ("x' = -x*(1 + exp(-t))", AS),
        ("x' = -x - exp(-2*t)*v; v' = x - v; V = x**2 + (1 + exp(-2*t))*v**2", AS),
    ],
    "a weight of an input": [
        ("x' = -x*(1 + w**2); input w", AS),
        ("x' = y*w - x*(1 + w**2); y' = -x*w - y*(2 + w**2); input w", AS),
    ],
    "a zero of a function that rises": [
        ("x' = v; v' = 2 - 2*exp(x) - tanh(v); V = 2*exp(x) - 2*x + v**2/2", AS),
        ("x' = v; v' = -x*abs(x) - v; V = v**2/2 + abs(x)**3/3", AS),
        ("x' = v; v' = -x - tanh(x) - v; V = v**2/2 + x**2/2 + log(cosh(x))", AS),
        ("x' = v; v' = -sinh(x) - (tanh(x) - 0.5)**2*v; V = v**2/2 + cosh(x)", AS),
        ("x' = v; v' = -x - (arctan(x) - 1)**2*v", AS),
        (  # Lotka and Volterra, with friction of w
            "u' = a - a*exp(w); w' = -b + b*exp(u) - d*(exp(w) - 1)**3; a = 1; b = 2; d = 0.3; "
            "V = b*(exp(u) - u) + a*(exp(w) - w)", AS,
        ),
    ],
}  # fmt: skip


def rows(table):
    """Rows of all kinds with their names."""
    for kind, texts in table.items():
        for k, row in enumerate(texts, 1):
            yield pytest.param(*row, id=f"{kind} {k}")


def judged(text):
    plant, V, *rest = written(text)
    return plant, clpt.lyapunov(plant, V, points=20, **dict(*rest))


@pytest.mark.parametrize(("text", "strongest", "rest"), [*rows(BROKEN)])
def test_a_broken_premise_says_no_more_than_is_true(text, strongest, rest):
    plant, found = judged(text)
    assert found.status == "proved"
    assert ORDER.index(found.conclusion) >= ORDER.index(strongest), found
    if rest is not None:
        t, u = 0.0, np.zeros(plant.ninputs)
        assert np.abs(plant.dynamics(t, np.array(rest, float), u)).max() == 0.0


@pytest.mark.parametrize(("text", "conclusion"), [*rows(HELD)])
def test_a_premise_that_holds_is_used(text, conclusion):
    _, found = judged(text)
    assert (found.status, conclusion_of(found)) == ("proved", conclusion), found


@pytest.mark.parametrize(
    ("text", "going"),
    [
        ("x' = -where(u > 0, 2, 0)**2*x; y' = -y; input u", "y goes"),
        ("x' = -2*x + r*y; y' = -r*x - r**2*y; input r", "x goes"),
        ("e' = -e + th*r; th' = -e*r - (th*r)**2*th; input r", "e goes"),
        ("x' = -y*z - x; y' = x*z; z' = -x*y/3; V = x**2 + 2*y**2 + 3*z**2", "x, y*z go"),
        ("x' = v; v' = -x - (4 - x**2)**2*v", "v, x go"),
    ],
)  # fmt: skip
def test_barbalats_lemma_is_applied_to_each_form(text, going):
    _, found = judged(text)
    assert (found.status, found.of) == ("proved", going)
    assert not found.failed


# --- Barbalat's lemma again, for rates: where time or inputs rule out LaSalle ---------------------


@pytest.mark.parametrize(
    ("text", "going"),
    [
        ("x' = v; v' = -x - (2 + sin(t))*v", "v, x go"),
        ("x' = v; v' = 3 - x - (2 + sin(t))*v; V = v**2 + (x - 3)**2; at x = 3", "v, 3 - x go"),
        ("x' = v; v' = -x**3 - (2 + cos(t))*v; V = v**2/2 + x**4/4", "v, x go"),
        ("x' = v; v' = -sin(x) - (2 + cos(t))*v; " + TURNED, "v, sin(x) go"),
        ("x' = v; v' = -tanh(x) - (2 + cos(t))*v; V = v**2/2 + log(cosh(x))", "v, x go"),
        ("a' = b; b' = c - a; c' = -b - (2 + sin(t))*c", "c, b, a go"),
        ("x' = (2 + sin(t))*v; v' = -(2 + sin(t))*x - v", "v, x go"),
        ("x' = v; v' = -x - (2 + sin(u))*v; input u", "v, x go"),  # u' may have no bound
        ("x' = -(2 + exp(minimum(t, 5)))*x + y; y' = -x", "x, y go"),
        # x converges, in general not to 0: its rate is at most |v|/(1 + t)^2 or |v| exp(-t)
        ("x' = v/(1 + t)**2; v' = -x/(1 + t)**2 - v", "v goes"),
        ("x' = v*exp(-t); v' = -x*exp(-t) - v", "v goes"),
        ("x' = v*(1 - tanh(t)); v' = -x*(1 - tanh(t)) - v", "v goes"),
        # u = 0 for ever: x stands still
        ("x' = v*u; v' = -x*u - v; input u", "v goes"),
        # y = 0: x stands still
        ("x' = y*v*(2 + sin(t)); y' = 0*y; v' = -y*x*(2 + sin(t)) - v", "v goes"),
        # sticks where |x| < 1/2
        ("x' = v; v' = -x - 0.5*sign(v) - exp(-t)*v", "v goes"),
    ],
)  # fmt: skip
def test_barbalats_lemma_is_applied_to_rates_of_what_goes_to_zero(text, going):
    _, found = judged(text)
    assert (found.status, found.conclusion, found.of) == ("proved", ZERO, going), found


@pytest.mark.parametrize(
    ("friction", "motion"),
    [
        ("2 + exp(t)", lambda t: 1 + sympy.exp(-t)),
        ("(1 + t)**2 + 1 + t + 2/(1 + t)", lambda t: 1 + 1 / (1 + t)),
    ],
)
def test_friction_that_grows_may_hold_x_off_zero(friction, motion):
    """x goes to 1 by its closed form, so no verdict may say that it goes to 0."""
    plant, found = judged(f"x' = v; v' = -x - ({friction})*v")
    assert "x" not in found.of
    t = sympy.Symbol("t")
    x, v, rate = (sympy.diff(motion(t), t, order) for order in range(3))
    for now in (0.0, 1.0, 3.0):
        x_now, v_now, rate_now = (float(e.subs(t, now)) for e in (x, v, rate))
        rates = plant.dynamics(now, np.array([x_now, v_now]), np.zeros(0))
        assert rates == pytest.approx([v_now, rate_now])


def test_what_goes_to_zero_by_rates_is_named_beyond_the_file():
    _, found = judged("x' = v; v' = -x - (2 + sin(t**2))*v")
    beyond = [step.claim for step in found.beyond_coq()]
    assert "x goes to zero, as rates of v do" in beyond


# --- losses with a step: y > 0 stays, so x does not move -----------------------------------------

GATED = "x' = -x*where(y > 0, 0, 2)**2; y' = -3*y"


def gate(s):
    """Factor that is 0 where y > 0."""
    return np.where(s.y > 0, 0.0, 1.0) ** 2


def test_a_claim_that_steps_shows_no_rest():
    plant, V = written(GATED)
    claim = lambda s: -(s.x**2) * gate(s) - s.y**2  # noqa: E731
    found = clpt.lyapunov(plant, V, claim=claim)
    assert (found.status, found.conclusion, found.of) == ("proved", ZERO, "y goes")


@pytest.mark.long
def test_squares_of_a_claim_are_lost_as_written():
    """A composite law: d = f - (v - w) - c w falls as exp(-t), and with E = (a - c) w
    V' = -2 v^2 - E (E - d) - d^2 = -2 v^2 - (E - d/2)^2 - 3 d^2/4.
    """
    plant, _ = written(
        "v' = a*v - 2*v - c*v; a' = -v**2 - w*(v - w + a*w - f); w' = v - w; "
        "f' = a*v - 2*v - f; c = 0.5"
    )

    def forms(s):
        d = s.f - (s.v - s.w) - s.c * s.w
        return s.v, d, (s.a - s.c) * s.w - d / 2

    def V(s):
        v, d, _ = forms(s)
        return (v**2 + (s.a - s.c) ** 2 + d**2) / 2

    def claim(s):
        v, d, E = forms(s)
        return -2 * v**2 - 3 * d**2 / 4 - E**2

    found = clpt.lyapunov(plant, V, claim=claim)
    assert (found.status, found.conclusion) == ("proved", ZERO)
    assert "parameters' values" not in found.sentence


def test_in_discrete_time_a_loss_that_steps_shows_no_rest():
    """x+ = x where y > 0, else x/2: V falls by 3/8 (x^2 where y <= 0, and y^2)."""
    plant = clpt.Block(
        "plant",
        update=lambda t, x, u, p: {"x": x.x * (1 - gate(x) / 2), "y": x.y / 2},
        states={"x": 1, "y": 1},
        dt=1.0,
    )
    claim = lambda s: -3 * (s.x**2 * gate(s) + s.y**2) / 8  # noqa: E731
    found = clpt.lyapunov(plant, signals(None, ["x", "y"]), claim=claim)
    assert (found.status, found.conclusion) == ("proved", ZERO)
    assert plant.dynamics(0, [1.0, 1.0], [])[0] == 1.0


def test_in_a_region_a_loss_that_steps_shows_no_rest():
    plant, V = written(GATED)
    box = {"x": (-2, 2), "y": (-2, 2)}
    assert clpt.lyapunov(plant, V, within=box).status == "open"
    assert plant.dynamics(0, [1.0, 1.0], [])[0] == 0.0


@pytest.mark.parametrize("text", [row[0] for row in BROKEN["zero at the numbers"]])
def test_a_V_that_is_searched_for_says_no_more(text):
    plant, V, *_ = written(text)
    given, searched = (clpt.lyapunov(plant, function) for function in (V, None))
    if searched.status == "proved":
        assert ORDER.index(searched.conclusion) >= ORDER.index(given.conclusion)


def test_of_a_map_a_factor_of_size_one_is_not_below_one():
    """x+ = -cos(pi) x is x, each x a rest: cos(pi) is -1 in doubles, and not quite as decimals."""
    plant = clpt.Block(
        "plant",
        update=lambda t, x, u, p: {"x": -np.cos(p.a) * x.x, "y": x.y / 2},
        states={"x": 1, "y": 1},
        parameters={"a": np.pi},
        dt=1.0,
    )
    found = clpt.lyapunov(plant, lambda s: s.x**2 + s.y**2)
    assert (found.status, found.conclusion) in {("proved", REST), ("proved", ZERO)}
    assert plant.dynamics(0, [1.0, 0.0], []) == pytest.approx([1.0, 0.0], abs=0)


def test_a_map_that_takes_off_a_clipped_state_comes_to_zero():
    """x+ = x - clip(x, -1/2, 1/2): |x| falls by 1/2 each time, and then to 0."""
    update = lambda t, x, u, p: {"x": x.x - np.clip(x.x, -0.5, 0.5)}  # noqa: E731
    plant = clpt.Block("plant", update=update, states={"x": 1}, dt=1.0)
    found = clpt.lyapunov(plant, lambda s: s.x**2)
    assert (found.status, found.conclusion) == ("proved", AS)


@pytest.mark.sampled
@pytest.mark.parametrize("a", [3.141592652589793, 3.141592653579793])
def test_a_function_of_a_number_is_printed_as_it_is(a):
    plant, V, *_ = written(f"x' = v; v' = -x - sin(a)*v; a = {a}")
    found = clpt.lyapunov(plant, V)
    assert (found.status, found.conclusion) == ("proved", AS)
    number = found.sentence.removeprefix("V' = -").partition("*v**2 <= 0")[0]
    assert float(number) == pytest.approx(np.sin(a), rel=1e-3)


def test_a_claim_where_inputs_are_zero_is_said_of_inputs_of_zero():
    plant, V, *_ = written("x' = -x + w; input w")
    found = clpt.lyapunov(plant, V, claim=lambda s: s.w**2 - s.x**2 / 2)
    claimed = (
        "V' <= -x**2/2 + w(t)**2 as claimed, V' <= -x**2/2 <= 0, so the rest is expo"
    )
    assert found.sentence.startswith(claimed)
    assert found.sentence.endswith("; where w = 0")


# --- states that jump ----------------------------------------------------------------------------


def swapped(breakpoints, **parameters):
    """x and y are swapped, x' = -x: V = x^2 + y^2 stays at jumps."""
    return clpt.Block(
        "plant",
        update=lambda t, x, u, p: {"x": -x.x, "y": 0.0 * x.y},
        jump=lambda t, x, u, p: {"x": x.y, "y": x.x},
        states={"x": 1, "y": 1},
        parameters={"interval": -1.0, **parameters},
        breakpoints=breakpoints,
    )


def halved(p, t0, t1):
    """Times n and n + 2^-n."""
    times = np.array([t for n in range(1, 60) for t in (float(n), n + 2.0**-n)])
    return times[(times > t0) & (times <= t1)]


def test_of_a_state_that_jumps_at_times_of_any_kind_an_integral_is_known():
    """x is 1 again and again: x falls in 2^-n, and rests as y else."""
    found = clpt.lyapunov(swapped(halved), lambda s: s.x**2 + s.y**2)
    assert (found.status, found.conclusion) == ("proved", INTEGRAL)
    (failed,) = found.failed
    assert "it jumps with plant" in failed.detail


def test_of_a_state_that_jumps_each_period_the_zero_is_known():
    found = clpt.lyapunov(
        swapped(Each("period"), period=2.0), lambda s: s.x**2 + s.y**2
    )
    assert (found.status, found.conclusion) == ("proved", ZERO)


def test_what_does_not_jump_goes_to_zero_whatever_else_jumps():
    still = clpt.Block(
        "plant",
        update=lambda t, x, u, p: {
            "e": -x.e + x.k * u.r,
            "k": -x.e * u.r,
            "m": 0 * x.m,
        },
        jump=lambda t, x, u, p: {"e": x.e, "k": x.k, "m": x.e},
        states={"e": 1, "k": 1, "m": 1},
        inputs={"r": 1},
        **TICKS,
    )
    found = clpt.lyapunov(still, signals("e**2 + k**2", ["e", "k", "m"]))
    assert (found.status, found.conclusion, found.of) == ("proved", ZERO, "e goes")


def test_a_V_that_may_rise_at_a_jump_is_open():
    kicked = clpt.Block(
        "plant",
        update=lambda t, x, u, p: {"x": -x.x},
        jump=lambda t, x, u, p: {"x": x.x * np.cos(3 * t) * 1.5},
        states={"x": 1},
        **TICKS,
    )
    found = clpt.lyapunov(kicked, lambda s: s.x**2)
    assert (found.status, found.conclusion, found.conditions) == ("open", "", ())
    assert "V does not rise where states of plant jump" in found.claim


def test_a_V_that_is_not_between_two_functions_is_no_rest():
    """V = p x^2, V' = -x^2: of p = 1 + t^4 sin(t)^2 x comes back at each k pi."""
    found, _ = judged_at_peaks()
    assert found.conclusion not in (AS, ZERO)


def judged_at_peaks():
    def rate(t, x, u, p):
        top = 1 + t**4 * np.sin(t) ** 2
        slope = 4 * t**3 * np.sin(t) ** 2 + 2 * t**4 * np.sin(t) * np.cos(t)
        return {"x": -(1 + slope) / (2 * top) * x.x}

    plant = clpt.Block("plant", update=rate, states={"x": 1}, parameters={})
    V = lambda s: (1 + s.t**4 * np.sin(s.t) ** 2) * s.x**2  # noqa: E731
    return clpt.lyapunov(plant, V), plant


@pytest.mark.parametrize(
    ("V", "rate"),
    [
        ("log(cosh(e))", "-e*tanh(e)"),
        ("sqrt(1 + e**2) - 1", "-e**2/sqrt(1 + e**2)"),
        ("abs(e) - log(1 + abs(e))", "-e**2/(1 + Abs(e))"),
        ("2*abs(e) - 2*log(1 + abs(e))", "-2*e**2/(1 + Abs(e))"),
    ],
)
def test_measures_that_grow_less_than_a_square_are_definite(V, rate):
    """Along e' = -e, V' = -e dV/de; the slope of |e| - log(1 + |e|) is e/(1 + |e|)."""
    _, found = judged(f"e' = -e; V = {V}")
    assert (found.status, found.conclusion) == ("proved", AS)
    e = sympy.Symbol("e", real=True)
    assert sympy.simplify(found.rate - sympy.sympify(rate, {"e": e})) == 0


@pytest.mark.sampled
@pytest.mark.parametrize("V", ["log(1 + abs(e))", "2*abs(e) - log(1 + abs(e))"])
def test_a_measure_with_a_kink_at_rest_is_not_smoothed(V):
    """Its slope at 0 jumps from -1 to 1."""
    _, found = judged(f"e' = -e; V = {V}")
    assert found.rate.has(sympy.Function("sign", real=True))
    assert found.conclusion != AS


def test_a_spring_of_bounded_force_comes_to_rest():
    """V' = -v^2: the terms of x cancel, as d/dx (|x| - log(1 + |x|)) = x/(1 + |x|)."""
    V = "abs(x) - log(1 + abs(x)) + v**2/2"
    _, found = judged(f"x' = v; v' = -x/(1 + abs(x)) - v; V = {V}")
    assert (f"{found.rate}", found.conclusion) == ("-v**2", AS)
