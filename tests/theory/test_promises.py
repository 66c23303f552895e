"""Promises of laws are asked along runs: right laws keep them, wrong ones are found out."""

import json

import numpy as np
import pytest
from altered_rows import replaced

import clpt_control as clpt_package
from clpt_control import refute

LONG = 300.0  # seconds; what is wrong is found long before
LAWS = clpt_package.laws()


def of_law(name, **changes):
    """Return one promise of a law with other fields."""
    return LAWS[name].promises[0]._replace(**changes)


@pytest.mark.thirds
@pytest.mark.parametrize("name", LAWS)
def test_a_law_keeps_its_promises_along_runs(name):
    """Each promise is asked in one run at least; with seed 37 one has a uniform flow."""
    found = refute(name, budget=2.0, seed=37)
    assert (found.status, found.scenario, found.broken) == ("not refuted", None, "")
    assert set(found.closest) == {promise.claim for promise in LAWS[name].promises}
    assert max(found.closest.values()) <= 1.001
    assert found.runs > 0


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


@pytest.mark.thirds
@pytest.mark.parametrize(("name", "claim", "condition"), NEEDED)
def test_a_promise_is_asked_only_where_its_conditions_hold(name, claim, condition):
    (promise,) = (one for one in LAWS[name].promises if one.claim == claim)
    fewer = tuple(one for one in promise.conditions if one != condition)
    assert condition in promise.conditions
    with replaced(name, promises=(promise._replace(conditions=fewer),)):
        found = refute(name, budget=20.0)
    assert (found.status, [*found.closest]) == ("refuted", [claim])
    assert found.closest[claim] > 1.001


def test_a_promise_without_conditions_is_asked_in_every_run():
    without = of_law("fix-regression", conditions=())
    with replaced("fix-regression", promises=(without,)):
        assert refute("fix-regression", budget=1.0).runs > 0
    assert refute("fix-regression", budget=1.0).runs == 0  # no flow is uniform


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
def test_a_law_that_breaks_its_promise_is_found_out(name, printed):
    with replaced(name, **WRONG[name]):
        found = refute(name, budget=LONG)
        said = printed("laws", name)["laws"][name]["promises"]
    assert (found.status, found.broken in said) == ("refuted", True)
    assert found.runs <= 100
    broken = {claim for claim, ratio in found.closest.items() if ratio > 1.001}
    assert set() < broken <= BREAKS[name]


@pytest.mark.parametrize("name", ["learned-flow", "drem"])
def test_a_run_of_the_scenario_shows_the_broken_promise(name):
    """By its V, or by the errors of its parameters: at rtol = 1e-12, of the run itself."""
    with replaced(name, **WRONG[name]):
        found = refute(name, budget=LONG)
        run = clpt_package.simulate(found.scenario, rtol=1e-12, atol=1e-14)
    error = np.abs(run.flow_parameters_estimate - run.flow_parameters).values
    values = run.lyapunov.values if name == "learned-flow" else error
    rises = values / np.minimum.accumulate(values, axis=0)
    largest = np.max(rises[values > 1e-6 * np.max(values[0])])
    assert largest > 1.001
    ratio = found.closest["falls" if name == "learned-flow" else "shrinks"]
    assert ratio == 0.0 or largest == pytest.approx(ratio, rel=1e-3)


def test_a_search_is_repeated_whatever_the_clock(monkeypatch):
    first = refute("sigma", budget=2.0, seed=3)
    monkeypatch.setattr("time.monotonic", iter(range(10**6)).__next__)
    assert refute("sigma", budget=2.0, seed=3) == first
    assert 0 < first.runs <= 10


@pytest.mark.parametrize(
    ("law", "budget"), [("no-law", 1.0), ("sigma", 0.0), ("sigma", np.inf)]
)
def test_what_cannot_be_searched_is_refused(law, budget):
    with pytest.raises(clpt_package.ClptError, match=r"law: 'no-law'|budget"):
        refute(law, budget=budget)


def test_the_command_writes_a_scenario_that_repeats_it(clpt, tmp_path):
    file = tmp_path / "broken.toml"
    with replaced("drem", promises=ANYWHERE):
        found = refute("drem", budget=LONG)
        outcome = clpt("prove", "drem", "--search", LONG, "--out", file, "--json")
    report = json.loads(outcome.out)
    assert (outcome.status, report["status"]) == (1, "refuted")
    assert report["closest"] == pytest.approx(found.closest)
    assert report["closest"]["shrinks"] > 1.001
    assert "drem breaks its promise: each parameter's error only shrinks" in outcome.err
    assert clpt_package.load_scenario(file) == found.scenario


def test_the_command_says_that_nothing_was_found(clpt, refused, tmp_path):
    outcome = clpt(
        "prove", "known-flow", "--search", 0.1, "--out", tmp_path / "none.toml"
    )
    assert outcome.status == 0
    assert "known-flow: not refuted by" in outcome.out
    assert not (tmp_path / "none.toml").exists()
    assert "seed = -5" in refused("prove", "known-flow", "--search", 60, "--seed", -5)


OF_PROOFS = ("--theorem", "3.2"), ("--again",), ("--certificates", "folder")
OF_SEARCH = ("--seed", 0), ("--out", "broken.toml")
UNUSED = [
    *(("--coq", "folder", *words) for words in (*OF_PROOFS, *OF_SEARCH, ("sigma",))),
    *(("sigma", "--search", 1, *words) for words in OF_PROOFS),
    *(("sigma", *words) for words in OF_SEARCH),
]


@pytest.mark.parametrize("words", UNUSED, ids=lambda words: " ".join(map(str, words)))
def test_an_option_that_would_be_ignored_is_refused(
    words, refused, tmp_path, monkeypatch
):
    monkeypatch.chdir(tmp_path)
    assert words[0 if words[0] == "--coq" else 1] in refused("prove", *words)
    assert [*tmp_path.iterdir()] == []
