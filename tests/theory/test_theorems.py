"""The proof desk: what is printed, what holds, what fails when an equation is wrong."""

import json
import os

import numpy as np
import pytest

from analysis.theorems import page
from clpt_control.blocks.laws.table import LAWS
from clpt_control.errors import DiagramError
from clpt_control.theory.proving.all_proofs import GRAPHS, statements
from clpt_control.theory.proving.misprints import misprints
from clpt_control.theory.proving.outcomes import CachedOutcomes, prove_all
from clpt_control.theory.proving.proof import Step, checked, cited, proof_or_failure, theorem
from clpt_control.theory.proving.theorems import audit


@pytest.fixture(scope="module")
def proofs():
    """The theorems' proofs, kept as `clpt prove` keeps them."""
    wanted = [one for one in statements() if one.room == "theorems"]
    kept = CachedOutcomes()
    kept.store(prove_all([one for one in wanted if one not in kept.outcomes]))
    return {one.name: kept.outcomes[one] for one in wanted}


FOUND = {  # number -> status, whether a part is cited, points at which the blocks are called
    "3.1": ("corrected", False, [1000]),
    "3.2": ("proved", False, [10_000]),
    "3.3": ("corrected", True, []),
    "3.4": ("corrected", True, [1000]),
}


@pytest.mark.parametrize("number", FOUND)
def test_what_is_found_of_a_theorem(proofs, number):
    (status, cites, points), proof = FOUND[number], proofs[number]
    hows = [step.how for step in proof.steps]
    assert (proof.status, proof.for_every_N) == (status, True)
    assert all(step.holds and (step.every_N or step.how != "exact") for step in proof.steps)
    assert bool(proof.cited) == ("cited" in hows) == cites
    assert bool(proof.corrected) == ("counterexample" in hows) == (status == "corrected")
    called = [step.detail for step in proof.steps if step.how == "sampled"]
    assert [text.split(" points")[0] for text in called] == [f"N = 3, {n}" for n in points]
    assert proof.assumptions
    assert proof.not_proved
    one = Step("for N = 2 alone", True, "exact", every_N=False)
    assert not theorem("", (), (*proof.steps, one), "").for_every_N


@pytest.mark.parametrize("number", range(len(misprints())))
def test_a_misprint_fails_as_printed_and_passes_corrected(number):
    misprint = misprints()[number]
    assert not misprint.holds(True)
    assert misprint.holds(False)
    assert misprint.confirmed


@pytest.mark.usefixtures("few_calls")
def test_prove_prints_json(clpt, monkeypatch):
    """By this process alone; `test_cached_proofs` asks two."""
    monkeypatch.setattr(os, "cpu_count", lambda: 1)
    outcome = clpt("prove", "--json")
    assert outcome.status == 0
    printed = json.loads(outcome.out)
    assert {name: one["status"] for name, one in printed["theorems"].items()} == {
        name: status for name, (status, *_) in FOUND.items()
    }
    steps = [step for found in printed["theorems"].values() for step in found["steps"]]
    assert {step["how"] for step in steps} == {"exact", "cited", "counterexample", "sampled"}
    assert {"equation", "printed", "corrected", "check"} <= set(printed["misprints"][0])
    limited, team, laws = (printed[room] for room in ("limited_speed", "team", "laws"))
    assert {name: (one["status"], one["for_every_N"]) for name, one in limited.items()} == {
        "with hedging": ("proved", True),
        "every law with hedging": ("proved", False),
        "without hedging": ("corrected", True),
    }
    (of_laws,) = limited["every law with hedging"]["steps"]
    assert of_laws["detail"].split(", ") == [law.name for law in LAWS.values() if not law.at_fixes]
    assert limited["without hedging"]["corrected"].startswith("int |e|^2")
    assert (team["status"], team["for_every_N"]) == ("proved", True)
    assert [step["how"] for step in team["steps"]] == [*["exact"] * len(GRAPHS), "sampled"]
    assert list(laws) == list(LAWS)
    for found in laws.values():
        assert found["status"] in ("proved", "bounded")
        assert found["claim"]
        assert any(step["how"] == "sampled" and step["holds"] for step in found["steps"])
        assert found["status"] == "bounded" or all(step["holds"] for step in found["steps"])
    for name, status in (("learned-flow", "proved"), ("known-flow", "bounded")):
        assert (laws[name]["status"], laws[name]["for_every_N"]) == (status, True)


def test_prove_one_theorem_and_refuse_another(clpt):
    outcome = clpt("prove", "--theorem", "3.2")
    assert outcome.status == 0
    assert "Theorem 3.2: proved" in outcome.out
    outcome = clpt("prove", "--theorem", "4.1")
    assert outcome.status == 2
    assert "3.1, 3.2, 3.3, 3.4" in outcome.err


def of_the_papers_gain(turn):
    """Eqs. (21)-(23), turned where the gain is the paper's own."""
    right = LAWS["learned-flow"].rates

    def rates(t, x, u, p):
        return {port: turn(p) * rate for port, rate in right(t, x, u, p).items()}

    return rates


@pytest.mark.parametrize(
    ("turn", "said"),
    [
        (lambda p: np.where(p.gain == 0.8, -1.0, 1.0), "left over"),
        (lambda p: -1.0 if p.gain == 0.8 else 1.0, "asks for the value of its parameter gain"),
    ],
    ids=["where", "if"],
)
def test_a_law_that_turns_at_the_papers_gain_is_not_proved(monkeypatch, turn, said):
    law = LAWS["learned-flow"]._replace(rates=of_the_papers_gain(turn))
    monkeypatch.setitem(LAWS, "learned-flow", law)
    proof = audit("3.2")["3.2"]
    assert proof.status == "failed"
    assert said in proof.failed[0].detail


def test_a_step_that_cannot_be_checked_fails():
    def refused():
        raise DiagramError("alpha' has no value")

    step = checked("V falls", refused)
    assert (step.holds, step.detail) == (False, "cannot be checked: alpha' has no value")


def test_an_error_of_the_package_says_nothing_of_a_claim():
    with pytest.raises(ZeroDivisionError):
        checked("one over zero", lambda: 1 / 0)
    with pytest.raises(ZeroDivisionError):
        proof_or_failure("open", lambda: 1 / 0)


def test_sampled_steps_alone_prove_nothing():
    sampled = theorem("", (), (Step("seen often", True, "sampled"),), "")
    assert sampled.status == "sampled"
    exact = Step("shown", True, "exact")
    assert theorem("", (), (exact, cited("known", "a book")), "").status == "cited"
    assert theorem("", (), (exact,), "", corrected="better").status == "failed"


def test_the_page(proofs):
    text = page(proofs, misprints())
    assert text.count("## Theorem") == 4
    assert "**no**" not in text
