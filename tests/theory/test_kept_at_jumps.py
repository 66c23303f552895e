"""A law whose states jump is proved only where jumps keep its relations, its cone and V."""

import pytest

import clpt_control as clpt
from clpt_control.blocks.laws.concurrent import LAW, concurrent, take_in, windows
from clpt_control.theory.proving import judged_laws, kept_loop


@pytest.fixture(autouse=True)
def few_points(monkeypatch):
    monkeypatch.setattr(judged_laws, "POINTS", 100)
    monkeypatch.setattr(kept_loop, "SIZES", (1, 2))


def taking(jump):
    """The law with another jump."""

    def block(known):
        own = LAW.block(known)
        return clpt.Block(
            own.name,
            update=concurrent,
            inputs=own.input_ports,
            states=own.state_ports,
            parameters=own.parameters,
            breakpoints=windows,
            jump=jump,
        )

    return LAW._replace(block=block)


def forgets_where_it_was(t, x, u, p, new):
    """As Eqs. (21)-(23) have it, but the window begins where the last one began."""
    take_in(t, x, u, p, new)
    origin = 4 * p.N + 5 + p.N * p.N + p.N
    for i in range(2):
        new[origin + i] = x[origin + i]


def takes_away(t, x, u, p, new):
    """S and B of Eqs. (21)-(23) with the other sign: B = theta S still holds."""
    take_in(t, x, u, p, new)
    S = 2 * p.N + 4
    for k in range(S, S + p.N * p.N + 2 * p.N):
        new[k] = -new[k]


def starts_again(t, x, u, p, new):
    """alpha of Eq. (21) set back to 0, which may be farther from the truth."""
    take_in(t, x, u, p, new)
    for k in range(2 * p.N):
        new[k] = 0.0


def the_same(t, x, u, p, new):
    """K of Eq. (22) and all else as it is."""
    take_in(t, x, u, p, new)


@pytest.mark.parametrize(
    ("jump", "said"),
    [
        (forgets_where_it_was, "and is kept where they jump"),
        (takes_away, "S >= 0 is not left where they jump"),
        (starts_again, "V does not rise where they jump"),
    ],
)
def test_a_jump_that_breaks_the_proof_leaves_the_law_open(jump, said):
    found = judged_laws.judged(taking(jump))
    assert found.status == "open"
    assert found.claim.startswith(said)


def test_the_same_jump_is_proved():
    assert judged_laws.judged(taking(the_same)).status == "proved"


def test_of_a_law_of_which_errors_shrink_jumps_are_not_judged():
    found = judged_laws.judged(LAW._replace(shrinking="sigma", says=""))
    assert found.status == "open"
    assert any("its states jump" in step.detail for step in found.steps)
