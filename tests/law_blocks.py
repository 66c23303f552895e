"""Laws of the user's own for tests: what a module of theirs would hold.

u = e[2], phi_x[N], z[2], zc[2]; states alpha[2N], K[2], Gamma[2], section III.
"""

from typing import NamedTuple

from clpt_control.blocks import Block
from clpt_control.blocks.laws.learned_flow import LearnedFlowParameters, learned_flow


class Remembering(NamedTuple):
    N: int
    gain: float
    start: float  # of what it remembers


def remembering(t, x, u, p, dx):
    """alpha' = -gamma e phi^T, K and Gamma held, and a count m' = p.start, section III."""
    n = p.N
    for i in range(2):
        for k in range(n):
            dx[i * n + k] = -p.gain * u[i] * u[2 + k]
        dx[2 * n + i] = 0.0
        dx[2 * n + 2 + i] = 0.0
    dx[2 * n + 4] = p.start


def remembering_law(N=3, gain=0.8, start=0.5):
    return Block(
        "mine",
        update=remembering,
        inputs={"e": 2, "phi_x": N},
        states={"alpha": 2 * N, "K": 2, "Gamma": 2, "m": 1},
        parameters=Remembering(N, gain, start),
    )


def papers_law(N=3, gain=0.8, name="mine"):
    """The paper's own, as a block that no table knows."""
    return Block(
        name,
        update=learned_flow,
        inputs={"e": 2, "phi_x": N, "z": 2, "zc": 2},
        states={"alpha": 2 * N, "K": 2, "Gamma": 2},
        parameters=LearnedFlowParameters(N, gain),
    )
