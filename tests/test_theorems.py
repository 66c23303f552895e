"""The proof desk: what is printed, what holds, what fails when an equation is wrong."""

import json

import pytest
import sympy

import clpt_control as clpt
from clpt_control.blocks import adaptation, vehicle
from clpt_control.theory.audit import audit_latex, audit_markdown
from clpt_control.theory.misprints import misprints
from clpt_control.theory.own_law import prove
from clpt_control.theory.proof import Proof, Step, checked
from clpt_control.theory.theorems import audit


@pytest.fixture(scope="module")
def proofs():
    return audit()


def test_statuses(proofs):
    assert {number: proof.status for number, proof in proofs.items()} == {
        "3.1": "corrected", "3.2": "proved", "3.3": "corrected", "3.4": "corrected",
    }  # fmt: skip
    assert all(proof.for_every_N for proof in proofs.values())
    assert all(step.holds for proof in proofs.values() for step in proof.steps)


def test_false_statements_meet_a_counterexample_and_carry_a_correction(proofs):
    for number in ("3.1", "3.3", "3.4"):
        assert proofs[number].corrected
        assert any(step.how == "counterexample" for step in proofs[number].steps)
    assert not proofs["3.2"].corrected


def test_every_proof_says_what_is_assumed_and_what_is_not_shown(proofs):
    for proof in proofs.values():
        assert proof.assumptions
        assert proof.not_proved


@pytest.mark.parametrize("number", range(len(misprints())))
def test_a_misprint_fails_as_printed_and_passes_corrected(number):
    misprint = misprints()[number]
    assert misprint.holds(True) is False or misprint.holds(True) == False  # noqa: E712
    assert misprint.holds(False)
    assert misprint.confirmed


def test_prove_prints_json(clpt, tmp_path):
    outcome = clpt("prove", "--json", "--tex", tmp_path / "audit.tex")
    assert outcome.status == 0
    printed = json.loads(outcome.out)
    assert set(printed["theorems"]) == {"3.1", "3.2", "3.3", "3.4"}
    for theorem in printed["theorems"].values():
        assert theorem["status"] in ("proved", "refuted", "corrected")
        for step in theorem["steps"]:
            assert step["how"] in ("symbolic", "definite form", "counterexample", "sampled")
    assert {"equation", "printed", "corrected", "check"} <= set(printed["misprints"][0])
    assert (tmp_path / "audit.tex").read_text().startswith("\\documentclass")


def test_prove_one_theorem_and_refuse_another(clpt):
    outcome = clpt("prove", "--theorem", "3.2")
    assert outcome.status == 0
    assert "Theorem 3.2: proved" in outcome.out
    outcome = clpt("prove", "--theorem", "4.1")
    assert outcome.status == 2
    assert "3.1, 3.2, 3.3, 3.4" in outcome.err


def wrong_kinematics(t, x, u, p, dx):
    """x' = F_R - v, not Eq. (1): u = flow_x[2], v_x[2], state x[2]."""
    for i in range(2):
        dx[i] = u[i] - u[2 + i]


def test_a_wrong_equation_fails_and_is_named(clpt, monkeypatch):
    monkeypatch.setattr(vehicle, "kinematics", wrong_kinematics)
    outcome = clpt("prove", "--theorem", "3.2")
    assert outcome.status == 1
    assert "the proof fails: 3.2 at step 'V' = -e^T KD e, N = 1'" in outcome.err


def test_a_step_that_cannot_be_checked_fails():
    step = checked("one over zero", "symbolic", lambda: 1 / 0)
    assert not step.holds
    assert "ZeroDivisionError" in step.detail
    with pytest.raises(ValueError, match="how"):
        checked("", "guessed", lambda: True)


def test_sampled_steps_alone_prove_nothing():
    sampled = Proof("x", "", (), (Step("seen often", True, "sampled"),), True, "")
    assert sampled.status != "proved"


def test_the_page_and_the_document(proofs):
    page = audit_markdown(proofs, misprints())
    assert page.count("## Theorem") == 4
    assert "**no**" not in page
    document = audit_latex(proofs, misprints())
    assert document.count(r"\begin{longtable}") == document.count(r"\end{longtable}") == 5


# --- a law of your own -----------------------------------------------------------------


def law(update, gain=0.5, N=2):
    return clpt.Block(
        "own", update=update, inputs={"e": 2, "phi_x": N, "z": 2, "zc": 2},
        states={"alpha": 2 * N, "K": 2, "Gamma": 2},
        parameters=adaptation.LearnedFlowParameters(N, gain),
    )  # fmt: skip


def without_feedforward(t, x, u, p, dx):
    """Eqs. (21)-(22), Gamma held: u = e[2], phi_x[N], z[2], zc[2]; alpha, K, Gamma."""
    n = p.N
    for i in range(2):
        for k in range(n):
            dx[i * n + k] = -p.gain * u[i] * u[2 + k]
        dx[2 * n + i] = -p.gain * u[2 + n + i] * u[i]
        dx[2 * n + 2 + i] = 0.0


def wrong_way(t, x, u, p, dx):
    """alpha' of the wrong sign, section III: u = e[2], phi_x[N], z[2], zc[2]; alpha, K, Gamma."""
    n = p.N
    for i in range(2):
        for k in range(n):
            dx[i * n + k] = p.gain * u[i] * u[2 + k]
        dx[2 * n + i] = -p.gain * u[2 + n + i] * u[i]
        dx[2 * n + 2 + i] = p.gain * u[4 + n + i] * u[i]


def test_the_papers_law_is_proved_for_every_N():
    verdict = prove(adaptation.adaptation(adaptation.LearnedFlowParameters(3, 2.5)))
    assert verdict.status == "proved"
    assert verdict.for_every_N
    assert verdict.residual == 0


@pytest.mark.parametrize("update", [without_feedforward, wrong_way])
def test_a_wrong_law_is_refuted_at_a_point(update):
    verdict = prove(law(update))
    assert verdict.status == "refuted"
    assert verdict.rate > 0
    assert verdict.point
    assert verdict.residual != 0


def test_the_residual_of_a_held_gain_is_the_term_that_misses():
    rest = prove(law(without_feedforward)).residual
    names = {str(symbol) for symbol in rest.free_symbols}
    assert {"Gamma_1", "GammaD_1", "x_1", "z_1"} <= names
    assert not {"theta_1[1]", "K_1"} & names
    assert isinstance(rest, sympy.Expr)
