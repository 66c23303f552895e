"""A proof of a law whose states jump says what is known of V across jumps."""

import math

import numpy as np
import pytest
from own_laws import GAIN, LEARNED, N, filled, law

from clpt_control.equations import Block
from clpt_control.errors import DiagramError
from clpt_control.theory.proving.array_loop import array_loop
from clpt_control.theory.proving.own_law import prove
from clpt_control.theory.proving.symbolic_loop import symbolic_loop
from clpt_control.theory.proving.theorem_loop import theorem_loop


def ticks(p, t0, t1):
    times = np.arange(1.0, math.floor(t1) + 1)
    return times[(times > t0) & (times <= t1)]


def with_memory(t, x, u, p):
    """The paper's law, and a memory m that only jumps, section III."""
    return filled(u, p.gain, u.e) | {"m": 0.0}


def reverse(t, x, u, p):
    """Every sign flipped, section III."""
    return filled(u, -p.gain, u.e) | {"m": 0.0}


def kept(x):
    return {port: getattr(x, port) for port in (*LEARNED, "m")}


def remember(t, x, u, p):
    """m = |e|^2 after a jump, section III."""
    return kept(x) | {"m": u.e @ u.e}


def halve(t, x, u, p):
    """alpha halved, section III."""
    return kept(x) | {"alpha": 0.5 * x.alpha, "m": 0.0}


def fade(t, x, u, p):
    """m halved, section III."""
    return kept(x) | {"m": 0.5 * x.m}


def of_memory(t, x, u, p):
    """V = (|e|^2 + m^2)/2."""
    return {"V": (u.e @ u.e + u.m @ u.m) / 2}


def jumping(jump, update=with_memory):
    return law(
        update,
        GAIN | {"interval": -1.0},
        states={**LEARNED, "m": 1},
        breakpoints=ticks,
        jump=jump,
    )


CASES = {
    "V reads nothing that jumps": (remember, "proved", ""),
    "V may rise": (halve, "proved between jumps", "V changes by"),
}


@pytest.mark.parametrize("name", CASES)
def test_what_is_known_of_jumps_is_said(name):
    jump, status, detail = CASES[name]
    verdict = prove(jumping(jump), points=200)
    across = verdict.steps[-1]
    assert (verdict.status, across.holds) == (status, status == "proved")
    assert across.claim == "V does not rise where states of own jump"
    assert across.detail.startswith(detail)
    assert not verdict.for_every_N


@pytest.mark.parametrize(("jump", "holds"), [(fade, True), (remember, False)])
def test_V_may_fall_where_states_jump(jump, holds):
    V = Block("lyapunov", output=of_memory, inputs={"e": 2, "m": 1}, outputs={"V": 1})
    assert prove(jumping(jump), V, points=200).steps[-1].holds == holds


def test_a_wrong_law_is_refuted_all_the_same():
    assert prove(jumping(remember, reverse), points=200).status == "refuted"


@pytest.mark.parametrize("read", [symbolic_loop, array_loop])
def test_other_proofs_refuse_jumps(read):
    diagram = theorem_loop(N, "learned-flow", law_block=jumping(remember))
    with pytest.raises(DiagramError, match=r"^own: its states jump, and this proof speaks of no"):
        read(diagram)


def turned(port):
    def turn(t, x, u, p):
        """A sign turned, section III."""
        return kept(x) | {port: -getattr(x, port)}

    return turn


def all_turned(t, x, u, p):
    """Every sign turned, section III."""
    return {port: -own for port, own in kept(x).items()}


def axes_swapped(t, x, u, p):
    """What is learned of one axis is taken for the other's, section III."""
    return kept(x) | {"alpha": x.alpha[::-1]}


def nudged(t, x, u, p):
    """0.1 more at each jump, section III."""
    return kept(x) | {"K": x.K + 0.1}


def turned_in_a_region(t, x, u, p):
    """Turned in a region alone, section III."""
    return kept(x) | {"alpha": np.where(np.abs(x.K[0]) > 1.0, x.alpha, -3.0 * x.alpha)}


def one_halved(t, x, u, p):
    """A leak at jumps of one function's flow, section III."""
    return kept(x) | {"alpha": np.where(np.arange(N) == 0, 0.5, 1.0) * x.alpha}


def test_a_jump_that_forgets_is_not_refuted():
    assert prove(jumping(one_halved), points=200).status == "proved between jumps"


WRONG = [*map(turned, LEARNED), all_turned, axes_swapped, nudged, turned_in_a_region]


@pytest.mark.parametrize("jump", WRONG)
def test_a_jump_at_which_V_rises_refutes(jump):
    verdict = prove(jumping(jump), points=200)
    assert verdict.status == "refuted at a jump"
    before, after = (verdict.diagram.output(*one)[-1] for one in (verdict.point, verdict.after))
    assert verdict.point.t == verdict.after.t == math.floor(verdict.point.t) > 0
    assert after > before
    assert not verdict.for_every_N
