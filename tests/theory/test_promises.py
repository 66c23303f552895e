"""Promises of laws are asked along runs: right laws keep them, wrong ones are found out."""

import json

import numpy as np
import pytest

import clpt_control as clpt_package
from clpt_control.paper.laws.law import Promise
from clpt_control.paper.laws.paper import learned_flow
from clpt_control.paper.laws.table import LAWS
from clpt_control.theory.promises import (
    CHECKS,
    CONDITIONS,
    UNIFORM,
    checked_promises,
    promises_in_words,
    rise,
)
from clpt_control.theory.refuting import BROKEN, NUMBERS, TIGHT, drawn, lasts, refute

LONG = 300.0  # seconds; what is wrong is found long before
PAPER = clpt_package.paper_scenario()
DELTA = {"kind": "sine", "amplitude": [1e-3, 1e-3], "period": 5.0}


def with_law(name):
    """The paper's scenario with a law, its functions the same everywhere where fixes ask it."""
    row = LAWS[name]
    values = {"learning.law": name, "run.duration": 60, "run.output_step": 0.02}
    values |= (
        {"learning.theta_estimate": [[0.9, 0.5, 0.7]] * 2} if row.given_estimate else {}
    )
    values |= {"learning.parameters": None} if row.alpha_is_constant else {}
    if row.at_fixes:
        values |= {
            f"learning.{key}": None for key in ("gain", "feedback", "feedforward")
        }
        values |= {"localization.interval": 5.0, "basis.widths": [2 * UNIFORM] * 3}
    return PAPER.with_values(values)


@pytest.mark.parametrize("name", LAWS)
def test_a_law_keeps_its_promises_on_the_papers_scenario(name):
    found = checked_promises(with_law(name))
    assert set(found) == {promise.claim for promise in LAWS[name].promises}
    assert max(found.values()) <= BROKEN
    assert all(promises_in_words(LAWS[name]).values())


def test_what_is_not_known_of_the_flow_may_cost_what_v_does_not_hold():
    """From a true start V(0) is 0: all that is allowed is of theta_hat - theta."""
    scenario = with_law("known-flow")
    true = {
        f"learning.{key}": getattr(scenario.vehicle, key)
        for key in ("position", "feedback", "feedforward")
    }
    assert 0.0 < checked_promises(scenario.with_values(true))["mean square"] < 1.0


def test_each_promise_has_a_predicate_and_conditions():
    promises = [promise for law in LAWS.values() for promise in law.promises]
    assert all(law.promises for law in LAWS.values())
    assert {promise.claim for promise in promises} == set(CHECKS)
    assert {name for promise in promises for name in promise.conditions} == set(
        CONDITIONS
    )


ASKED = [
    ("drem", {"localization": {"noise": 0.02, "noise_period": 1.0}}, set()),
    ("projection", {"learning.projection.largest_feedforward": 1.0}, {"balls"}),
    ("dead-zone", {"flow.disturbance": DELTA}, {"falls", "zone"}),
    (
        "dead-zone",
        {"flow.disturbance": DELTA | {"amplitude": [1e-3, 1.0]}},
        set(),
    ),  # too large
    (
        "dead-zone",
        {"flow.disturbance": DELTA | {"kind": "noise"}},
        set(),
    ),  # it has no bound
]


@pytest.mark.parametrize(("law", "values", "asked"), ASKED)
def test_a_promise_is_asked_only_where_its_conditions_hold(law, values, asked):
    assert set(checked_promises(with_law(law).with_values(values))) == asked


def test_a_rise_is_seen_whatever_came_between():
    assert rise(np.array([2.0, 1.0, 0.5, 0.75])) == pytest.approx(1.5, rel=1e-6)
    assert rise(np.array([2.0, 1.0, 1.0])) == 1.0
    assert rise(np.array([[1.0, 1.0], [0.5, 3.0]])) == pytest.approx(3.0, rel=1e-6)


@pytest.mark.parametrize("name", LAWS)
def test_every_point_is_a_scenario(name):
    inner = np.random.default_rng(1).random((20, NUMBERS))
    for point in (*inner, np.zeros(NUMBERS), np.full(NUMBERS, 1 - 1e-12)):
        assert drawn(name, point).learning.law == name


# --- laws that break a promise -------------------------------------------------------------------


def other_sign(t, x, u, p):
    """Gamma' of Eq. (23) with the other sign."""
    rates = learned_flow(t, x, u, p)
    return {**rates, "Gamma": -rates["Gamma"]}


FORGETS = LAWS["composite-memory"].rates


def forgets_all(t, x, u, p):
    """alpha' of Eq. (21) with a memory, which forgets all by and by."""
    rates = FORGETS(t, x, u, p)
    return {**rates, "Q": rates["Q"] - 0.02 * x.Q, "b": rates["b"] - 0.02 * x.b}


ANYWHERE = (Promise("shrinks", ("exact",)),)
WRONG = {
    "learned-flow": ({"rates": other_sign}, {"falls", "settles", "mean square"}),
    "composite-memory": ({"rates": forgets_all}, {"exponential"}),
    "drem": (
        {"promises": ANYWHERE},
        {"shrinks"},
    ),  # beside a flow outside the basis too
}


@pytest.mark.parametrize("name", WRONG)
def test_a_law_that_breaks_its_promise_is_found_out(name, monkeypatch):
    changes, breaks = WRONG[name]
    monkeypatch.setitem(LAWS, name, LAWS[name]._replace(**changes))
    found = refute(name, budget=LONG)
    assert found.status == "refuted"
    assert found.runs <= 100
    again = checked_promises(found.scenario, **TIGHT)
    assert set() < {what for what, value in again.items() if value > BROKEN} <= breaks
    assert found.broken in promises_in_words(LAWS[name]).values()


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


def test_the_command_writes_a_scenario_that_repeats_it(clpt, tmp_path, monkeypatch):
    monkeypatch.setitem(LAWS, "drem", LAWS["drem"]._replace(promises=ANYWHERE))
    file = tmp_path / "broken.toml"
    outcome = clpt("prove", "drem", "--search", LONG, "--out", file, "--json")
    report = json.loads(outcome.out)
    assert (outcome.status, report["status"]) == (1, "refuted")
    assert report["closest"]["shrinks"] > BROKEN
    assert "drem breaks its promise: each parameter's error only shrinks" in outcome.err
    assert (
        checked_promises(clpt_package.load_scenario(file), **TIGHT)["shrinks"] > BROKEN
    )


def test_the_command_says_that_nothing_was_found(clpt, refused, tmp_path):
    outcome = clpt(
        "prove", "known-flow", "--search", 0.1, "--out", tmp_path / "none.toml"
    )
    assert outcome.status == 0
    assert "known-flow: not refuted by" in outcome.out
    assert not (tmp_path / "none.toml").exists()
    assert "seed = -5" in refused("prove", "known-flow", "--search", 60, "--seed", -5)


def test_what_the_solver_leaves_breaks_no_promise():
    """An error of 2e-12, read beside 1e-9 of what it was, is 1.003 times as large as before."""
    for once, again in ((1.053, 1.0032), (2.0, 1.0005)):
        assert not lasts(once, again)
    for once, again in ((2.0, 1.99), (np.inf, np.inf)):
        assert lasts(once, again)
