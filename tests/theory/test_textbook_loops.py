"""Loops of textbooks are proved as there, and traps beside them are not."""

import numpy as np
import pytest
from text_systems import conclusion_of, written

import clpt_control as clpt

AT_REST = "asymptotically stable"


def judged(text, **more):
    """The verdict on a loop as text, with options of `lyapunov`."""
    system, V, *given = written(text)
    return clpt.lyapunov(system, V, **(given[0] if given else {}), **more)


# --- numbers that doubles hold exactly ----------------------------------------------------------


@pytest.mark.long
@pytest.mark.parametrize("a", [1e16, 2.0**52 + 0.5])
@pytest.mark.parametrize("sign", [1, -1])
def test_a_small_difference_of_exact_numbers_is_no_rounding(a, sign):
    """x' = (b - a) x leaves 0 where b > a, however large both are."""
    b = float(np.nextafter(a, sign * np.inf))
    for more in ("", "; y' = -y"):
        verdict = judged(f"x' = (b - a)*x{more}; a = {a!r}; b = {b!r}")
        expected = ("open", "") if sign > 0 else ("proved", AT_REST)
        assert (verdict.status, conclusion_of(verdict)) == expected


# --- reasons ------------------------------------------------------------------------------------

POSITIVE = {"x": (0, None), "y": (0, None)}


def test_a_search_that_finds_nothing_is_no_reason():
    # bounded, and least at 0 alone
    verdict = judged("x' = -x; V = x**2/(1 + x**2)")
    assert verdict.status == "open"
    assert [step.claim for step in verdict.failed] == ["V is positive definite"]


@pytest.mark.long
def test_a_divisor_is_judged_with_the_parameters_numbers():
    verdict = judged("x' = -x/(k - d); k = 2; input d", where={"d": (-1, 1)})
    assert (conclusion_of(verdict), verdict.failed) == (AT_REST, ())
    assert "with the parameters' values k = 2" in verdict.sentence
    assert judged("x' = -x/(k - d); k = 2; input d", where={"d": (-1, 2)}).failed


def test_a_loss_of_an_input_and_of_time_holds_for_times_from_0():
    assert "for t >= 0" in judged("x' = -x*w**2*exp(-t); input w").sentence


# --- inputs of any size -------------------------------------------------------------------------


@pytest.mark.parametrize("points", [1, 20, 200])
@pytest.mark.parametrize("seed", [0, 1])
def test_a_push_that_friction_outgrows_refutes_nothing(points, seed):
    """V' = -v^2 + v d is negative far off, V' = d v^2 nowhere with d > 1."""
    text = "x' = v; v' = -sin(x) - {}; V = v**2/2 + 1 - cos(x); input d"
    verdict = judged(text.format("v + d"), points=points, seed=seed)
    assert (verdict.status, verdict.conclusion) == ("proved", "comes to rest")
    assert "where d = 0" in verdict.sentence
    grown = judged(text.format("v*(1 + d)"), points=points, seed=seed)
    assert grown.status == "refuted"


# --- ways to decide, each with traps ------------------------------------------------------------

OBSERVED = "x' = -x - x**3; z' = -z - z**3 + x - z; V = (x - z)**2/2"
BESIDE = "e' = -e*(1 + x**2); x' = {}; V = e**2/2"
PUSHED = "h' = {}; V = h**2/2; input w"
ROSENBROCK = "V = (1 - x)**2 + (y - x**2)**2"
OPEN = ""


@pytest.mark.parametrize(
    ("text", "conclusion", "of"),
    [
        # a smooth function whose slope keeps its sign: Slotine and Li, Strogatz, Khalil
        ("x' = sin(x)**2 - x", AT_REST, None),
        ("x' = 1.1*sin(x)**2 - x", OPEN, None),
        ("x' = -(x + tan(x))", OPEN, None),
        ("x' = -x - 1/(1 - x) + 1 - sin(x)", OPEN, None),
        ("x' = -y*(x - sin(x)); y' = -y", OPEN, None),
        ("x' = v; v' = -20*x - v - 9.8*sin(x); V = v**2/2 + 10*x**2 + 9.8*(1 - cos(x))",
         AT_REST, None),
        ("x' = v; v' = -x - v - 9.8*sin(x); V = v**2/2 + x**2/2 + 9.8*(1 - cos(x))",
         "all rates go to zero", None),
        # what fades
        ("x' = -x*exp(-2*t)", "stable", None),
        # the loss itself, where no form of it is known: normalised gradients
        (PUSHED.format("-h*w**2/(1 + w**2)"), "square-integrable", None),
        (PUSHED.format("-h*w**2/(1 + w**2)*exp(-t)"), "stable", None),
        # a state beside V whose rate has an odd power that leads: observers
        (OBSERVED, "goes to zero", "-x + z goes"),
        (BESIDE.format("-x**3 + e*x**2"), "goes to zero", "e, e*x go"),
        (BESIDE.format("-x**4 + e*x**2"), "square-integrable", None),
        (BESIDE.format("x**3 + e*x**2"), "square-integrable", None),
        (BESIDE.format("-x**3*exp(-t) + e*x**2"), "square-integrable", None),
        # the loss state by state: a gradient flow
        (f"x' = 2*(1 - x) + 4*x*(y - x**2); y' = -2*(y - x**2); {ROSENBROCK}", AT_REST, None),
        (f"x' = 0*x; y' = -2*(y - x**2); {ROSENBROCK}", "comes to rest", "-x**2 + y goes"),
    ],
)  # fmt: skip
def test_what_textbooks_decide(text, conclusion, of):
    verdict = judged(text)
    assert conclusion_of(verdict) == conclusion
    assert of is None or verdict.of == of


def test_a_gradient_of_a_sum_loses_in_steps_of_time_what_sums_to_a_number():
    """Goodwin and Sin: V falls by e^2 (2 - w^2/(1 + w^2)) w^2/(1 + w^2) at each step."""
    rates = {"h": lambda x, u: x.h - u.w**2 * x.h / (1 + u.w**2)}
    loop = clpt.Block(
        "lms",
        update=lambda t, x, u, p: {"h": rates["h"](x, u)},
        states={"h": 1},
        inputs={"w": 1},
        dt=1.0,
    )
    verdict = clpt.lyapunov(loop, lambda s: s.h**2)
    assert verdict.conclusion == "goes to zero"
    assert verdict.of == "h**2*(w(t)**2 + 2)*w(t)**2/(w(t)**2 + 1)**2 goes"
    turn = clpt.Block(
        "turn",
        update=lambda t, x, u, p: {
            "x": 0.6 * x.x - 0.8 * x.y,
            "y": 0.8 * x.x + 0.6 * x.y,
        },
        states={"x": 1, "y": 1},
        dt=1.0,
    )
    verdict = clpt.lyapunov(turn, lambda s: s.x**2 + s.y**2)
    assert (verdict.conclusion, verdict.of) == ("stable", "")


CLOSED = {"a": (0, None), "b": (0, None), "c": (0, None)}
LOG = "V = x - log(x)"


@pytest.mark.parametrize(
    ("text", "where", "conclusion"),
    [
        # a sum of states that stay at 0 or above is 0 where each is: compartments
        ("a' = -2.3*a + b + c; b' = a - b; c' = a - c; V = a + b + c", CLOSED, AT_REST),
        ("a' = -a*c; b' = a*c - b; c' = 0*c; V = 2*a + b + c", CLOSED, "comes to rest"),
        # log(x) is any number: logistic growth, Volterra's loop with friction
        (f"x' = x*(1 - x); {LOG}; at x = 1", {"x": (0, None)}, AT_REST),
        (f"x' = x*(1 - x); {LOG}; at x = 2", {"x": (0, None)}, OPEN),
        ("x' = x*(1 - x); V = -log(x); at x = 1", {"x": (0, None)}, OPEN),
        (f"x' = -x; {LOG}; at x = 1", {"x": (0, None)}, OPEN),
        (f"x' = x*(2 - x - y); y' = y*(x - 1); {LOG} + y - log(y); at x = 1; at y = 1",
         POSITIVE, AT_REST),
        (f"x' = x*(1 - y); y' = y*(x - 1); {LOG} + y - log(y); at x = 1; at y = 1",
         POSITIVE, "stable"),
    ],
)  # fmt: skip
def test_what_textbooks_decide_in_sets(text, where, conclusion):
    assert conclusion_of(judged(text, where=where)) == conclusion


def test_logs_of_several_states_are_a_form_as_they_are():
    text = "x' = 0*x; y' = 0*y; V = (2*log(x) - log(y))**2; at x = 1; at y = 1"
    claims = [step.claim for step in judged(text, where=POSITIVE).steps]
    assert "V is positive definite in 2*log(x) - log(y)" in claims


def test_a_claim_under_an_input_is_said_beside_what_follows_at_zero():
    verdict = judged("x' = -x + d; input d", claim=lambda s: (s.d**2 - s.x**2) / 2)
    assert verdict.claim == "V' <= -x**2/2 + d(t)**2/2 as claimed, V' <= -x**2/2 <= 0"
    assert "where d = 0" in verdict.sentence


@pytest.mark.parametrize(
    ("root", "bounds", "is_real"),
    [
        (lambda r: np.sqrt(4 - r**2), (-0.5, 0.5), True),
        (lambda r: np.sqrt(1 - r**2), (-1, 0.5), True),
        (lambda r: np.sqrt(1 - r**2), (-2, 0.5), False),
        (lambda r: np.sqrt(1 - r**2), (0.5, None), False),
    ],
)
def test_roots_of_squares_of_bounded_inputs(root, bounds, is_real):
    loop = clpt.Block(
        "loop",
        update=lambda t, x, u, p: -x.x * root(u.r),
        **{"states": {"x": 1}, "inputs": {"r": 1}},
    )
    verdict = clpt.lyapunov(loop, lambda s: s.x**2 / 2, where={"r": bounds})
    assert (verdict.status == "proved") == is_real
    assert ("which may be negative" in verdict.sentence) != is_real
