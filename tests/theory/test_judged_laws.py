"""Laws judged with their own V: gains of their own, gains held, wrong laws and unread ones."""

import pytest
import sympy

from clpt_control.blocks.laws.table import LAWS
from clpt_control.theory.proving import judgement
from clpt_control.theory.proving.judgement import judged_law
from clpt_control.theory.proving.own_law import prove

POINTS = 200


@pytest.fixture(autouse=True)
def few_points(monkeypatch):
    monkeypatch.setattr(judgement, "POINTS", POINTS)


def gains(parameters, feedback, feedforward):
    return LAWS["learned-flow"].of(2, gain=parameters, gain_K=feedback, gain_Gamma=feedforward)


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
    law = LAWS["learned-flow"]

    def backwards(t, x, u, p):
        return {port: -rate for port, rate in law.rates(t, x, u, p).items()}

    found = judged_law(law._replace(rates=backwards))
    assert not found.holds
    assert "V' " in found.claim


def test_equations_that_cannot_be_read_leave_a_law_open():
    def unread(t, x, u, p):
        raise ValueError("no such equation")

    found = judged_law(LAWS["learned-flow"]._replace(rates=unread))
    assert (found.status, found.holds) == ("open", False)
    assert "no such equation" in found.claim
