"""Promises of laws are checked along runs: right laws keep them, wrong ones break them."""

import numpy as np
import pytest
from altered_rows import replaced
from levels_of_laws import LEVELS, proved_and_closed_form
from promises_along_runs import (
    BROKEN,
    CHECKS,
    CONDITIONS,
    TIGHT,
    drawn_ratios,
    first_broken,
)

import clpt_control as clpt_package

MOST_RUNS = 100  # what is wrong is found long before
LAWS = clpt_package.laws()


def of_law(name, **changes):
    """Return one promise of a law with other fields."""
    return LAWS[name].promises[0]._replace(**changes)


@pytest.mark.long
@pytest.mark.parametrize("name", LAWS)
def test_a_law_keeps_its_promises_along_runs(name):
    """Each promise is checked in one run at least; with seed 4 one has a uniform flow."""
    asked = set()
    for scenario, ratios in drawn_ratios(name, 10, seed=4):
        assert max(ratios.values(), default=0.0) <= BROKEN, (ratios, scenario)
        asked |= {*ratios}
    assert asked == {promise.claim for promise in LAWS[name].promises}


@pytest.mark.parametrize("name", LEVELS)
@pytest.mark.parametrize("delta", [(0.0, 0.0), (0.1, 0.0), (0.05, 0.2), (1.0, 3.0)])
def test_the_level_that_is_proved_is_not_above_the_closed_form(name, delta):
    proved, closed_form = proved_and_closed_form(name, delta)
    assert 0 < proved <= closed_form * (1 + 1e-9)


def test_each_promise_has_a_predicate_and_each_condition_a_check():
    promises = [promise for law in LAWS.values() for promise in law.promises]
    assert {promise.claim for promise in promises} == CHECKS.keys()
    conditions = {name for promise in promises for name in promise.conditions}
    assert conditions == CONDITIONS.keys()


def test_each_promise_is_said_with_its_conditions(printed):
    listed = printed("laws")["laws"]
    for name, law in LAWS.items():
        said = listed[name]["promises"]
        assert len(said) == len(law.promises) > 0
        for promise, words in zip(law.promises, said, strict=True):
            assert (", where: " in words) == bool(promise.conditions)
            assert words.count("; ") == max(len(promise.conditions) - 1, 0)


# a law, a promise, and a condition without which runs break it
NEEDED = [
    ("learned-flow", "falls", "spanned"),
    ("learned-flow", "falls", "exact"),
    ("switching-sigma", "falls", "within"),
    ("dead-zone", "zone", "small"),
    ("least-squares", "estimate", "exact"),
    ("composite-memory", "exponential", "spanned"),
    ("drem", "readout", "spanned"),
    ("drem", "shrinks", "exact"),
]


@pytest.mark.long
@pytest.mark.parametrize(("name", "claim", "condition"), NEEDED)
def test_a_promise_holds_only_under_its_conditions(name, claim, condition):
    (promise,) = (one for one in LAWS[name].promises if one.claim == claim)
    fewer = tuple(one for one in promise.conditions if one != condition)
    assert condition in promise.conditions
    with replaced(name, promises=(promise._replace(conditions=fewer),)):
        _, ratios = first_broken(name, MOST_RUNS)
    assert [*ratios] == [claim]


@pytest.mark.long
def test_a_promise_without_conditions_is_checked_in_every_run():
    def count():
        return sum(bool(ratios) for _, ratios in drawn_ratios("fix-regression", 5))

    with replaced(
        "fix-regression", promises=(of_law("fix-regression", conditions=()),)
    ):
        assert count() > 0
    assert count() == 0  # no flow is uniform


# --- laws that break a promise -------------------------------------------------------------------


def other_sign(t, x, u, p):
    """Gamma' of Eq. (23) with the other sign."""
    rates = LAWS["learned-flow"].rates(t, x, u, p)
    return {**rates, "Gamma": -rates["Gamma"]}


def forgets_all(t, x, u, p):
    """alpha' of Eq. (21) with a memory, which forgets all by and by."""
    rates = LAWS["composite-memory"].rates(t, x, u, p)
    return {**rates, "Q": rates["Q"] - 0.02 * x.Q, "b": rates["b"] - 0.02 * x.b}


ANYWHERE = (of_law("drem", claim="shrinks", conditions=("exact",)),)
WRONG = {
    "learned-flow": {"rates": other_sign},
    "composite-memory": {"rates": forgets_all},
    "drem": {"promises": ANYWHERE},  # beside a flow outside the basis too
}
BREAKS = {
    "learned-flow": {"falls", "settles", "mean square"},
    "composite-memory": {"exponential"},
    "drem": {"shrinks"},
}


@pytest.mark.long
@pytest.mark.parametrize("name", WRONG)
def test_a_wrong_law_breaks_its_promise(name):
    with replaced(name, **WRONG[name]):
        _, ratios = first_broken(name, MOST_RUNS)
    broken = {claim for claim, ratio in ratios.items() if ratio > BROKEN}
    assert set() < broken <= BREAKS[name]


@pytest.mark.sampled
@pytest.mark.parametrize("name", ["learned-flow", "drem"])
def test_a_run_of_the_scenario_shows_the_broken_promise(name):
    """By its V, or by the errors of its parameters: at rtol = 1e-12, of the run itself."""
    with replaced(name, **WRONG[name]):
        scenario, ratios = first_broken(name, MOST_RUNS)
        run = clpt_package.simulate(scenario, **TIGHT)
    error = np.abs(run.flow_parameters_estimate - run.flow_parameters).values
    values = run.lyapunov.values if name == "learned-flow" else error
    rises = values / np.minimum.accumulate(values, axis=0)
    largest = np.max(rises[values > 1e-6 * np.max(values[0])])
    assert largest > BROKEN
    ratio = ratios["falls" if name == "learned-flow" else "shrinks"]
    assert largest == pytest.approx(ratio, rel=1e-3)


OF_PROOFS = ("--theorem", "3.2"), ("sigma", "--theorem", "3.2")


@pytest.mark.parametrize("words", OF_PROOFS, ids=lambda w: " ".join(w))
def test_an_option_that_would_be_ignored_is_refused(
    words, refused, tmp_path, monkeypatch
):
    monkeypatch.chdir(tmp_path)
    assert "--coq" in refused("prove", "--coq", "folder", *words)
    assert [*tmp_path.iterdir()] == []
