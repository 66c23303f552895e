"""A law whose states jump is proved only where jumps keep its relations, its cone and V."""

import pytest

from clpt_control.blocks.laws.concurrent import LAW, next_window
from clpt_control.theory.proving import judgement, kept_loop


@pytest.fixture(autouse=True)
def few_points(monkeypatch):
    monkeypatch.setattr(judgement, "POINTS", 100)
    monkeypatch.setattr(kept_loop, "SIZES", (1, 2))


def forgets_where_it_was(t, x, u, p):
    """As Eqs. (21)-(23) have it, but the window begins where the last one began."""
    return next_window(t, x, u, p) | {"origin": x.origin}


def takes_away(t, x, u, p):
    """S and B of Eqs. (21)-(23) with the other sign: B = theta S still holds."""
    return next_window(t, x, u, p) | {"S": -x.S, "B": -x.B}


def starts_again(t, x, u, p):
    """alpha of Eq. (21) set back to 0, which may be farther from the truth."""
    return next_window(t, x, u, p) | {"alpha": 0.0}


def the_same(t, x, u, p):
    """K of Eq. (22) and all else as it is."""
    return next_window(t, x, u, p)


@pytest.mark.parametrize(
    ("jump", "said"),
    [
        (forgets_where_it_was, "and is kept where they jump"),
        (takes_away, "Q_1, Q_2, S >= 0 is not left where they jump"),
        (starts_again, "V does not rise where they jump"),
    ],
)
def test_a_jump_that_breaks_the_proof_leaves_the_law_open(jump, said):
    found = judgement.judged_law(LAW._replace(jump=jump))
    assert found.status == "open"
    assert found.claim.startswith(said)


def test_the_same_jump_is_proved():
    assert judgement.judged_law(LAW._replace(jump=the_same)).status == "proved"


def test_of_a_law_of_which_errors_shrink_jumps_are_not_judged():
    found = judgement.judged_law(LAW._replace(shrinking="S", says=""))
    assert found.status == "open"
    assert any("its states jump" in step.detail for step in found.steps)
