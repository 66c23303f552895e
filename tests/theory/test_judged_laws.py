"""Every law of the table is proved or bounded with its own V; gains of their own, gains held."""

import pytest
import sympy

from clpt_control.blocks.laws import learned_flow
from clpt_control.blocks.laws.law import Gains
from clpt_control.blocks.laws.table import LAWS
from clpt_control.theory.proving import judged_laws
from clpt_control.theory.proving.judged_laws import judged
from clpt_control.theory.proving.own_law import prove
from clpt_control.theory.proving.theorem_loop import law_and_V

POINTS = 200


@pytest.fixture(autouse=True)
def few_points(monkeypatch):
    monkeypatch.setattr(judged_laws, "POINTS", POINTS)


@pytest.mark.parametrize("name", LAWS)
def test_every_law_may_stand_in_the_table(name):
    found = judged(LAWS[name])
    assert found.law == name
    assert found.holds, found.claim
    assert any(step.how == "sampled" and step.holds for step in found.steps)


def test_the_papers_laws_are_proved_for_every_N():
    for name, status in (("learned-flow", "proved"), ("known-flow", "bounded")):
        found = judged(LAWS[name])
        assert (found.status, found.for_every_N) == (status, True)


def gains(parameters, feedback, feedforward):
    return learned_flow.learned_flow_law(
        learned_flow.LearnedFlowGains(2, parameters, feedback, feedforward)
    )


def test_a_gain_each_is_proved_for_every_N_and_every_gain():
    verdict = prove(gains(0.5, 0.2, 0.7), points=POINTS)
    assert (verdict.status, verdict.for_every_N, verdict.residual) == ("proved", True, 0)


def test_gains_held_true_fall_alike_and_others_push():
    verdict = prove(gains(0.5, 0.0, 0.0), points=POINTS)
    assert verdict.status != "proved"  # K and Gamma may be anything
    names = {str(s): s for s in verdict.residual.free_symbols}
    true = {names[f"{g}_{i}"]: names[f"{g}D_{i}"] for g in ("K", "Gamma") for i in (1, 2)}
    assert sympy.expand(verdict.residual.subs(true)) == 0


def test_a_wrong_law_would_not_stand_in_the_table():
    def backwards(known):
        return learned_flow.block(known._replace(gains=Gains(-0.8, -0.8, -0.8, one=True)))

    law = LAWS["learned-flow"]
    _, V = law_and_V(law, judged_laws.N)
    found = judged(law._replace(block=backwards, V=lambda p, truth: V))
    assert not found.holds
    assert "V' " in found.claim


def test_equations_that_cannot_be_read_leave_a_law_open():
    def unread(known):
        raise ValueError("no such equation")

    found = judged(LAWS["learned-flow"]._replace(block=unread))
    assert (found.status, found.holds) == ("open", False)
    assert "no such equation" in found.claim
