"""Loops of textbooks are proved as there, and traps beside them are not."""

import numpy as np
import pytest
from text_systems import written

import clpt_control as clpt

AT_REST = "asymptotically stable"


def judged(text, **more):
    """The verdict on a loop as text, with options of `lyapunov`."""
    system, V, *given = written(text)
    return clpt.lyapunov(system, V, **(given[0] if given else {}), **more)


# --- numbers that doubles hold exactly ----------------------------------------------------------


@pytest.mark.parametrize("a", [1e16, 9e15, 2.0**52 + 0.5])
@pytest.mark.parametrize("sign", [1, -1])
def test_a_small_difference_of_exact_numbers_is_no_rounding(a, sign):
    """x' = (b - a) x leaves 0 where b > a, however large both are."""
    b = float(np.nextafter(a, sign * np.inf))
    for more in ("", "; y' = -y"):
        verdict = judged(f"x' = (b - a)*x{more}; a = {a!r}; b = {b!r}")
        expected = ("open", "") if sign > 0 else ("proved", AT_REST)
        assert (verdict.status, verdict.conclusion) == expected


# --- reasons ------------------------------------------------------------------------------------

POSITIVE = {"x": (0, None), "y": (0, None)}


@pytest.mark.parametrize(
    ("text", "where"),
    [
        # bounded, and least at 0 alone
        ("x' = -x; V = x**2/(1 + x**2)", None),
        # least at (1, 1): Volterra
        ("x' = x*(1 - y); y' = y*(x - 1); V = x - log(x) + y - log(y)", POSITIVE),
    ],
)
def test_a_search_that_finds_nothing_is_no_reason(text, where):
    verdict = judged(text, where=where)
    assert verdict.status == "open"
    assert [step.claim for step in verdict.failed] == ["V is positive definite"]


def test_a_divisor_is_judged_with_the_parameters_numbers():
    verdict = judged("x' = -x/(k - d); k = 2; input d", where={"d": (-1, 1)})
    assert (verdict.conclusion, verdict.failed) == (AT_REST, ())
    assert "with the parameters' values k = 2" in verdict.sentence
    assert judged("x' = -x/(k - d); k = 2; input d", where={"d": (-1, 2)}).failed


# --- inputs of any size -------------------------------------------------------------------------


@pytest.mark.parametrize("points", [1, 5, 20, 200])
@pytest.mark.parametrize("seed", [0, 1])
def test_a_push_that_friction_outgrows_refutes_nothing(points, seed):
    """V' = -v^2 + v d is negative far off, V' = d v^2 nowhere with d > 1."""
    text = "x' = v; v' = -sin(x) - {}; V = v**2/2 + 1 - cos(x); input d"
    verdict = judged(text.format("v + d"), points=points, seed=seed)
    assert (verdict.status, verdict.conclusion) == ("proved", "comes to rest")
    assert "where d = 0" in verdict.sentence
    grown = judged(text.format("v*(1 + d)"), points=points, seed=seed)
    assert grown.status == "refuted"
