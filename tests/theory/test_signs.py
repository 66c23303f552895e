"""Signs of parameters that a proof needs: each a condition, in the sentence and in the theorem.

Each case has a loop, V and the signs without which the theorem is false, by a line of algebra.
"""

import control
import numpy as np
import pytest
import sympy
from text_systems import written

import clpt_control as clpt

HALF = lambda s: np.sum(s.x**2) / 2  # noqa: E731
ENERGY = lambda s: (s.v**2 - s.k * s.x**2) / 2  # noqa: E731


def block(update, states=1, inputs=(), **parameters):
    ports = {"x": states} if isinstance(states, int) else dict.fromkeys(states, 1)
    return clpt.Block(
        "s",
        update=update,
        states=ports,
        inputs=dict.fromkeys(inputs, 1),
        parameters=parameters,
    )


def signs_of(verdict):
    named = {condition.name: condition.of for condition in verdict.conditions}
    return named.get("signs", "")


def turning(t, x, u, p):
    return {"x": p.w * x.y - p.c * x.x, "y": -p.w * x.x - p.c * x.y}


def spring(t, x, u, p):
    return {"x": x.v, "v": p.k * x.x + p.c * x.v}


CASES = {
    "V' has the sign of b": (
        block(lambda t, x, u, p: {"x": p.b * x.x}, b=-2.0),
        HALF,
        "b < 0",
    ),
    "V has the sign of -b": (
        block(lambda t, x, u, p: {"x": p.b * x.x}, b=-2.0),
        lambda s: -s.b * s.x**2 / 2,
        "b < 0",
    ),
    "a positive one": (
        block(lambda t, x, u, p: {"x": -p.b * x.x}, b=2.0),
        lambda s: s.b * s.x**2 / 2,
        "b > 0",
    ),
    "a product": (
        block(lambda t, x, u, p: {"x": p.k * p.m * x.x}, k=-2.0, m=1.0),
        HALF,
        "m > 0 and k < 0",
    ),
    "a divisor": (block(lambda t, x, u, p: {"x": x.x / p.b}, b=-2.0), HALF, "b < 0"),
    "an even power beside 1": (
        block(lambda t, x, u, p: {"x": -(1 + p.b**2) * x.x}, b=-2.0),
        HALF,
        "",
    ),
    "forces that do no work": (
        block(turning, ("x", "y"), w=-3.0, c=1.0),
        lambda s: (s.x**2 + s.y**2) / 2,
        "c > 0",
    ),
    "elements of a vector": (
        block(
            lambda t, x, u, p: {"x": np.array([-1.0, 1.0]) * p.g * x.x},
            2,
            g=np.array([2.0, -1.0]),
        ),
        HALF,
        "g[0] > 0 and g[1] < 0",
    ),
    "an energy": (block(spring, ("x", "v"), k=-2.0, c=-1.0), ENERGY, "c, k < 0"),
    "a state outside of V": (
        block(lambda t, x, u, p: {"x": -x.x, "y": p.d * x.y + x.x}, ("x", "y"), d=-2.0),
        HALF,
        "d < 0",
    ),
    "an input": (
        block(
            lambda t, x, u, p: {"x": p.b * x.x + p.h * u.u},
            inputs=("u",),
            b=-2.0,
            h=-1.0,
        ),
        HALF,
        "b < 0",
    ),
    "the place of the rest": (
        block(lambda t, x, u, p: {"x": p.r - x.x}, r=-2.0),
        lambda s: (s.x - s.r) ** 2 / 2,
        "",
    ),
    "python-control's": (
        control.nlsys(
            lambda t, x, u, p: [p["b"] * x[0]],
            states=["x"],
            inputs=0,
            outputs=["x"],
            params={"b": -2.0},
            name="n",
        ),
        HALF,
        "b < 0",
    ),
}


@pytest.mark.parametrize(("system", "V", "signs"), CASES.values(), ids=CASES)
def test_the_signs_that_a_proof_needs_are_its_conditions(system, V, signs):
    verdict = clpt.lyapunov(system, V)
    assert (verdict.status, signs_of(verdict)) == ("proved", signs), verdict
    assert (f"where {signs}" in verdict.sentence) == bool(signs)
    assumed = verdict.latex().partition("Conditions: ")[2].partition("\n")[0]
    assert assumed.count("> 0$") + assumed.count("< 0$") == signs.count(" 0")


def test_the_other_sign_is_refuted():
    wrong = clpt.lyapunov(block(lambda t, x, u, p: {"x": p.b * x.x}, b=2.0), HALF)
    assert (wrong.status, wrong.conditions) == ("refuted", ())


def adaptive(b, sign):
    """Model reference: x' = a x + b u, u = k_x x + k_r r, laws with the sign of b."""

    def rates(t, x, u, p):
        e = x.x - x.m
        return {
            "x": p.a * x.x + p.b * (x.k_x * x.x + x.k_r * u.r),
            "m": p.a_m * (u.r - x.m),
            "k_x": -sign * p.gamma * e * x.x,
            "k_r": -sign * p.gamma * e * u.r,
        }

    states = ("x", "m", "k_x", "k_r")
    return block(rates, states, ("r",), a=1.0, b=b, a_m=4.0, gamma=2.0)


def V_of_adaptive(s):
    missed = (s.k_x + (s.a_m + s.a) / s.b) ** 2 + (s.k_r - s.a_m / s.b) ** 2
    return (s.x - s.m) ** 2 / 2 + abs(s.b) / (2 * s.gamma) * missed


@pytest.mark.long
@pytest.mark.parametrize("b", [3.0, -2.0])
@pytest.mark.sampled
def test_model_reference_control_assumes_the_sign_of_b_but_not_of_a(b):
    verdict = clpt.lyapunov(adaptive(b, np.sign(b)), V_of_adaptive)
    signs = "a_m, b, gamma > 0" if b > 0 else "a_m, gamma > 0 and b < 0"
    assert (verdict.conclusion, signs_of(verdict)) == ("goes to zero", signs)


@pytest.mark.long
def test_a_refutation_is_typeset_with_its_point():
    verdict = clpt.lyapunov(adaptive(-2.0, 1.0), V_of_adaptive)
    text = verdict.latex()
    assert verdict.status == "refuted"
    assert "proof" not in text
    (refuted,) = (
        line for line in text.splitlines() if line.startswith("Refuted: $\\dot V > 0$")
    )
    assert all(f"${name} = " in refuted for name in ("x", "m", "k_{x}", "r", "b"))
    assert f" $x = {verdict.point.x[0]:.6g}$," in refuted


@pytest.mark.long
def test_values_are_printed_where_the_proof_is_of_them():
    system = block(
        lambda t, x, u, p: {"x": p.m * np.tanh(x.x) - p.k * x.x}, k=2.0, m=0.1
    )
    verdict = clpt.lyapunov(system, HALF)
    assert verdict.sentence.endswith("with the parameters' values k = 2, m = 0.1")
    assert "values $k = 2$, $m = 0.1$." in verdict.latex()


@pytest.mark.long
def test_values_are_fixed_only_of_parameters_that_need_them():
    """A number in V, the model's pole 3, leaves the plant's a and the gain g symbols.

    V = e^2 + 2/g ((kr - 3/2)^2 + (ky - (3 + a)/2)^2), e = y - ym: V' = -6 e^2 by hand.
    """

    def adaptive(t, x, u, p):
        e = x.y - x.ym
        control = x.kr * u.r - x.ky * x.y
        return {
            "y": p.a * x.y + 2 * control,
            "ym": p.am * (u.r - x.ym),
            "kr": -p.g * u.r * e,
            "ky": p.g * x.y * e,
        }

    def V(s):
        apart = (s.kr - 1.5) ** 2 + (s.ky - (3.0 + s.a) / 2) ** 2
        return (s.y - s.ym) ** 2 + 2 * apart / s.g

    states = dict.fromkeys(("y", "ym", "kr", "ky"), 1)
    loop = block(adaptive, states, ["r"], a=1.0, am=3.0, g=2.0)
    found = clpt.lyapunov(loop, V)
    assert (found.status, found.conclusion) == ("proved", "goes to zero")
    conditions = {condition.name: condition.of for condition in found.conditions}
    assert conditions["values"] == "am = 3"
    assert conditions["signs"] == "g > 0"


@pytest.mark.parametrize(
    ("text", "signs", "values"),
    [
        ("x' = v; v' = -k*x - c*v; k = 9; c = 2; V = 4.5*x**2 + v**2/2", "c > 0", "k = 9"),
        (
            "x' = v; v' = -k*x - c*v; p' = -m*p; k = 9; c = 2; m = 1; "
            "V = 4.5*x**2 + v**2/2 + p**2", "c, m > 0", "k = 9",
        ),
        (
            "e' = -k*e + (h - w)*r; h' = -g*e*r; k = 1; g = 5; w = 7; "
            "V = e**2/2 + (h - w)**2/10; input r", "k > 0", "g = 5",
        ),
        (
            "e' = -k*e + (h - w)*r; h' = -g*e*r; k = 1; g = 5; w = 7; "
            "V = e**2/2 + (h - 7)**2/(2*g); input r", "g, k > 0", "w = 7",
        ),
        ("x' = a*x - b*x**3; y' = -m*y; a = 1; b = 1; m = 3", "m > 0", "a = 1, b = 1"),
    ],
)  # fmt: skip
def test_a_number_in_V_fixes_no_other_parameter(text, signs, values):
    plant, V = written(text)
    found = clpt.lyapunov(plant, V)
    assert found.status == "proved"
    conditions = {condition.name: condition.of for condition in found.conditions}
    assert (conditions["signs"], conditions["values"]) == (signs, values)


OVER_A_DIVISOR = {  # loss, as one fraction: x^2 y^2 - x^2 y + x^2 + y^2, and (x - 1)^2 q
    "Khalil, ex. 4.3": "x' = -x + x*y; y' = -y; V = log(1 + x**2) + y**2",
    "a gene that stops itself": "x' = 2/(1 + x**2) - x; V = (x - 1)**2/2; at x = 1",
    "a cosine as it is written": "r' = -r*cos(a)**2; a' = -a",
    "a rest off the origin": "x' = (1 - x)*(x**2 + x + 2); V = (x - 1)**2/2; at x = 1",
}


@pytest.mark.parametrize("name", OVER_A_DIVISOR)
def test_a_loss_over_a_divisor_that_is_bounded(name):
    plant, V, *rest = written(OVER_A_DIVISOR[name])
    found = clpt.lyapunov(plant, V, **dict(*rest))
    assert found.implies("asymptotically stable"), found


@pytest.mark.parametrize(
    "text",
    [  # a zero of the loss beside the rest; a divisor that grows with what V does not hold
        "x' = -x*(x - 1)**2/(1 + x**2); V = x**2/2",
        "x' = -x/(1 + y**2); y' = y; V = x**2/2",
    ],
)
def test_a_loss_over_a_divisor_that_leaves_other_rests(text):
    plant, V, *_ = written(text)
    assert not clpt.lyapunov(plant, V).implies("asymptotically stable")


@pytest.mark.sampled
@pytest.mark.parametrize("b", [3.0, 0.5])
def test_a_gain_of_any_size_keeps_a_function_definite(b):
    plant, V, *_ = written(
        "x' = v; v' = -a*tanh(x) - b*tanh(v); V = a*log(cosh(x)) + v**2/2; a = 2; "
        f"b = {b}"
    )
    found = clpt.lyapunov(plant, V)
    assert found.implies("asymptotically stable")
    assert signs_of(found) == "a, b > 0"


CHAIN = "x' = s*(y - x); y' = r*x - y - x*z; z' = x*y - b*z; s = 10; r = 0.5; b = 2; "
BETWEEN = [  # text -> the textbook's conditions
    ("x' = a*x - b*x; a = 1; b = 2; V = x**2/2", "b > a", ""),
    ("x' = -(a + b)*x; a = -2; b = 3; V = x**2/2", "a + b > 0", ""),
    ("x' = -x + b*y; y' = -a*y; a = 1; b = 1; V = x**2 + y**2", "4*a > b**2", ""),
    ("x' = -a*x + b*y; y' = -c*x - d*y; a = 1; b = 2; c = 2; d = 1; V = x**2 + y**2",
     "4*a*d + 2*b*c > b**2 + c**2", "d > 0"),
    ("x' = -(b - a)*x - x**3; y' = -(1 - r)*y; a = 1; b = 2; r = 0.5", "b > a, r < 1", ""),
    (CHAIN + "V = x**2/s + y**2 + z**2", "r < 1", "b, r, s > 0"),  # Lorenz
    ("x' = -(a*b - 1)*x; a = -2; b = -1; V = x**2/2", "a*b > 1", "b < 0"),
]  # fmt: skip


@pytest.mark.long
@pytest.mark.parametrize(("text", "between", "signs"), BETWEEN)
def test_a_condition_between_parameters_stands_for_their_values(text, between, signs):
    """V' <= 0 at random states and parameters that meet the conditions."""
    plant, V, *_ = written(text)
    found = clpt.lyapunov(plant, V)
    assert found.implies("asymptotically stable"), found
    conditions = {condition.name: condition.of for condition in found.conditions}
    assert (conditions["between"], conditions.get("signs", "")) == (between, signs)
    assert "values" not in conditions
    random, symbols = np.random.default_rng(0), sorted(found.rate.free_symbols, key=str)
    names = [*map(str, symbols)]
    points = dict(zip(names, random.uniform(-3, 3, (len(names), 4000)), strict=True))
    signed = (
        f"{name} {signs[-3:]}" for name in signs[:-4].split(", ") if name in names
    )
    rules = [eval(rule, {}, points) for rule in (*between.split(", "), *signed)]
    kept = np.logical_and.reduce(rules)
    values = sympy.lambdify(symbols, found.rate)(*points.values())
    assert kept.sum() > 50
    assert values[kept].max() <= 1e-9


def test_a_file_has_the_margin_as_a_parameter():
    plant, V = written(BETWEEN[0][0])
    assert "margin_1 stands for -a + b." in clpt.lyapunov(plant, V).coq()
