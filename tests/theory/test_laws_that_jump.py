"""A proof of a law whose states jump says what is known of V across jumps."""

import math
from typing import NamedTuple

import numpy as np
import pytest
from own_laws import N, filled

from clpt_control.blocks import Block
from clpt_control.errors import DiagramError
from clpt_control.theory.proving.every_n_loop import every_n_loop
from clpt_control.theory.proving.own_law import prove
from clpt_control.theory.proving.symbolic_loop import symbolic_loop
from clpt_control.theory.proving.theorem_loop import theorem_loop


class Jumping(NamedTuple):
    N: int
    gain: float
    interval: float = -1.0


def ticks(p, t0, t1):
    times = np.arange(1.0, math.floor(t1) + 1)
    return times[(times > t0) & (times <= t1)]


def with_memory(t, x, u, p, dx):
    """The paper's law, and a memory m that only jumps, section III."""
    for i in range(2):
        filled(x, u, p, dx, p.gain, u[i], i)
    dx[2 * p.N + 4] = 0.0


def reverse(t, x, u, p, dx):
    """Every sign flipped, section III."""
    for i in range(2):
        filled(x, u, p, dx, -p.gain, u[i], i)
    dx[2 * p.N + 4] = 0.0


def remember(t, x, u, p, new):
    """m = |e|^2 after a jump, section III."""
    for i in range(2 * p.N + 4):
        new[i] = x[i]
    new[2 * p.N + 4] = u[0] ** 2 + u[1] ** 2


def halve(t, x, u, p, new):
    """alpha halved, section III."""
    for i in range(2 * p.N + 4):
        new[i] = x[i]
    for i in range(2 * p.N):
        new[i] = 0.5 * x[i]
    new[2 * p.N + 4] = 0.0


def fade(t, x, u, p, new):
    """m halved, section III."""
    for i in range(2 * p.N + 4):
        new[i] = x[i]
    new[2 * p.N + 4] = 0.5 * x[2 * p.N + 4]


def of_memory(t, x, u, p, y):
    """V = (|e|^2 + m^2)/2."""
    y[0] = (u[0] ** 2 + u[1] ** 2 + u[2] ** 2) / 2


def jumping(jump, update=with_memory):
    return Block(
        "own",
        update=update,
        inputs={"e": 2, "phi_x": N, "z": 2, "zc": 2},
        states={"alpha": 2 * N, "K": 2, "Gamma": 2, "m": 1},
        parameters=Jumping(N, 0.5),
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


@pytest.mark.parametrize("read", [symbolic_loop, every_n_loop])
def test_other_proofs_refuse_jumps(read):
    diagram = theorem_loop(N, "learned-flow", law_block=jumping(remember))
    with pytest.raises(DiagramError, match=r"^own: its states jump, and this proof speaks of no"):
        read(diagram)
