"""What is proved for every number of functions: V' is read once for all of them."""

import numpy as np
import pytest
import user_laws
from user_laws import FLOW, beside, changed, driven

from clpt_control import prove

POINTS = 50
# the third elementary symmetric polynomial of q = tanh(phi), of power sums: zero for N = 1, 2
ELEMENTARY = (
    "(sum(tanh(phi_x))**3 - 3*sum(tanh(phi_x))*sum(tanh(phi_x)**2)"
    " + 2*sum(tanh(phi_x)**3))/6"
)
SHARE = "phi_x @ phi_x/(1 + phi_x @ phi_x)"
ADDED = {  # what is added to K', zero for N = 2; for every N; that is known
    "sum(outer(phi_x, phi_x)) - sum(phi_x)**2": True,
    "sum(e[0]*phi_x + 2*phi_x) - (e[0] + 2)*sum(phi_x)": True,
    "trace(outer(phi_x, phi_x)) - sum(phi_x**2)": True,
    "sum(tanh(phi_x)*e[0]) - e[0]*sum(tanh(phi_x))": True,
    "exp(-sum(phi_x**2))*sum(phi_x) - sum(phi_x*exp(-phi_x @ phi_x))": True,
    "sum(0*phi_x + e[0]) - e[0]*sum(0*phi_x + 1)": True,
    "sum(0*phi_x + e[0]) - 2*e[0]": False,  # N e_1
    ELEMENTARY: False,
    "phi_x[0] + phi_x[1] - sum(phi_x)": False,
    "phi_x[0]*phi_x[1] - (sum(phi_x)**2 - phi_x @ phi_x)/2": False,
    "sum(phi_x*where(arange(len(phi_x)) == 4, 1.0, 0.0))": False,
}


def sizes_of(verdict):
    return [condition.of for condition in verdict.conditions if condition.name == "N"]


@pytest.mark.parametrize("added", ADDED)
def test_what_is_added_is_zero_for_every_N_or_for_two(added):
    verdict = prove(changed(f"K' = dK + ({added})")(), points=POINTS)
    assert (verdict.status, verdict.conclusion) == ("proved", "goes to zero")
    assert verdict.for_every_N == ADDED[added]
    assert sizes_of(verdict) == ["every N" if ADDED[added] else "N = 2"]


@pytest.mark.long
def test_a_sum_over_two_indices_of_a_matrix_is_read_for_every_N():
    cancels = "phi_x @ P @ tanh(phi_x) - tanh(phi_x) @ P.T @ phi_x"
    rates = f"P' = outer(phi_x, phi_x) - P; K' = dK + ({cancels})"
    verdict = prove(beside(rates, {"P": ("N", "N")})(), points=POINTS)
    assert (verdict.status, sizes_of(verdict)) == ("proved", ["every N"])


@pytest.mark.long
def test_a_choice_by_the_number_of_the_function_is_decided():
    """For N = 2 no function is the fifth."""
    fifth = "sum(where(arange(len(phi_x)) == 4, phi_x, 0.0))"
    verdict = prove(changed(f"K' = dK + {fifth}")(), points=POINTS)
    assert (verdict.status, sizes_of(verdict)) == ("proved", ["N = 2"])


NOT_ONE_SUM = pytest.mark.xfail(strict=True, reason="a sum in a divisor is not read")


@NOT_ONE_SUM
def test_a_sum_in_a_divisor_is_read_for_every_N():
    added = f"{SHARE} - 1 + 1/(1 + sum(phi_x**2))"
    verdict = prove(changed(f"K' = dK + ({added})")(), points=POINTS)
    assert (verdict.status, sizes_of(verdict)) == ("proved", ["every N"])


WRONG = [  # not zero for N = 2
    "sum(outer(phi_x, phi_x)) - sum(phi_x**2)",
    f"{SHARE} - 1 + 1/(1 + sum(phi_x)**2)",
    "exp(-sum(phi_x**2))*sum(phi_x) - sum(phi_x*exp(-phi_x**2))",
    "sum(0*phi_x + e[0]) - e[0]",
]


@pytest.mark.parametrize("added", WRONG)
def test_what_is_not_zero_is_not_proved(added):
    verdict = prove(changed(f"K' = dK + ({added})")(), points=POINTS)
    assert verdict.status != "proved"
    assert not verdict.for_every_N


READ = {  # m' of a state that nothing reads -> whether it is alike for all functions
    "phi_x @ phi_x": True,
    "sum(tanh(phi_x)*e[0])": True,
    "sum(alpha @ phi_x)": True,
    "phi_x[-1]": False,
    "phi_x[0]": False,
    "sum(phi_x[1:]*phi_x[:-1])": False,
    "sum(phi_x*roll(phi_x, 1))": False,
    "arange(len(phi_x)) @ phi_x": False,
    "prod(phi_x)": False,
    "mean(phi_x)": False,
}


@pytest.mark.parametrize("rate", READ)
def test_what_is_not_alike_for_all_functions_is_proved_for_two(rate):
    verdict = prove(beside(f"m' = {rate}", {"m": 1})(), points=POINTS)
    assert (verdict.status, verdict.conclusion) == ("proved", "goes to zero")
    assert verdict.for_every_N == READ[rate]
    step = next(s for s in verdict.steps if s.claim == "the same for every N")
    assert step.holds == READ[rate]
    assert not verdict.failed  # what is shown for N = 2 alone is shown
    assert READ[rate] or "is not read for every N" in step.detail


@pytest.mark.long
@pytest.mark.parametrize("N", [1, 2, 5])
def test_a_law_is_proved_for_every_N_from_each(N):
    verdict = prove(
        user_laws.law(user_laws.paper().update_function, n=N), points=POINTS
    )
    assert (verdict.status, sizes_of(verdict)) == ("proved", ["every N"])


@pytest.mark.long
@pytest.mark.parametrize(
    "law",
    [
        driven("e"),
        driven("(sin(e[0])**2 + cos(e[0])**2)*e"),
        changed("alpha' = dalpha - 0.3*outer(tanh(eps), phi_x)", more=FLOW),
    ],
    ids=["the paper's", "times one", "composite"],
)
def test_V_of_the_running_blocks_falls_as_is_proved(law):
    """By differences along the rates, at points that no proof has seen."""
    verdict, random = prove(law(), points=POINTS), np.random.default_rng(7)
    diagram, KD, h = verdict.diagram, np.array([1.0, 0.7]), 1e-5
    labels = diagram.output_labels
    for _ in range(10):
        t, x = random.uniform(0, 9), random.normal(size=diagram.nstates)
        u = random.normal(size=diagram.ninputs)
        rates = diagram.dynamics(t, x, u)
        ahead, behind = (diagram.output(t, x + s * rates, u)[-1] for s in (h, -h))
        e = diagram.output(t, x, u)[[labels.index(f"e[{i}]") for i in range(2)]]
        slope = (ahead - behind) / (2 * h)
        assert slope <= -KD @ e**2 + 1e-6 * (1 + abs(slope))
