"""The law of a team: several vehicles that learn one flow.

V is the sum of the vehicles' V,

    V' = -sum_i e_i^T KD_i e_i - (kappa/gamma) sum |alpha_i - alpha_j|^2    over the edges (i, j)

Each vehicle has its own phi, zc, KD, GammaD and alpha_M; theta, gamma and kappa are one.  Proved
for two vehicles, three in a row and three in a circle, for every N.  As V never rises, e goes to
zero by the argument of Theorem 3.2, and so do the differences between neighbours.
"""

from collections.abc import Iterator
from functools import partial
from itertools import chain
from typing import Any

import numpy as np

from ...engine.diagram.interconnection import Diagram, connect
from ...engine.model.ports import named, split, within
from ...paper.laws.consensus import total_candidate
from ...paper.scenario.team import TEAM_LAW, Team
from ...simulation.team_loops import team_blocks
from .same_as_running import running_step
from .steps import Proof, Step, where_all_hold
from .symbolic_loop import symbolic_loop
from .theorem_loop import (
    SOURCES,
    Loop,
    rate_of_V,
    theorem_candidate,
    theorem_scenario,
    zero_step,
)

POINTS = 1_000  # at which the running blocks are called
N = 2  # functions of a vehicle that runs
GRAPHS = {
    "two vehicles": (("a", "b"),),
    "three in a row": (("a", "b"), ("b", "c")),
    "three in a circle": (("a", "b"), ("b", "c"), ("a", "c")),
}
CITED = (
    "where the pooled Gramian is positive definite in every window alike, the flow parameters of "
    "all vehicles go to theta exponentially (Chen, Wen, Hua and Sun 2014, IEEE Transactions on "
    "Automatic Control 59(1))"
)
COUPLING = 0.6  # stands for any kappa > 0
CLAIM = "V' = -sum e^T KD e - (kappa/gamma) sum over edges |alpha_i - alpha_j|^2"


def proof_of_team() -> Proof:
    """Prove the law of a team."""
    claim = f"{CLAIM}, so CLPE goes to zero and the vehicles agree: {', '.join(GRAPHS)}"
    return where_all_hold("proved", claim, team_steps(), CITED)


def team_steps() -> Iterator[Step]:
    """Yield the steps of the proof one by one."""
    for name, edges in GRAPHS.items():
        diagram, rest = (
            partial(team_diagram, edges, N),
            partial(beside_claim, edges=edges),
        )
        yield zero_step(f"{CLAIM}, {name}, every N", diagram, rest)
    row = team_diagram(GRAPHS["three in a row"], N)
    yield running_step(lambda: symbolic_loop(row), POINTS, ", three in a row")


def team_diagram(edges: tuple[tuple[str, str], ...], N: int) -> Diagram:
    """Wire a team with its V, whose vehicles differ in all that may differ.

    phi_x, phi_z and zc of each vehicle are inputs.
    """
    members = {
        name: theorem_scenario(N, TEAM_LAW).with_values(
            {
                "vehicle.feedback": [1.0 + 0.3 * k, 0.7 + 0.2 * k],
                "vehicle.feedforward": [1.2 - 0.4 * k, -0.5 - 0.1 * k],
            }
        )
        for k, name in enumerate(sorted({*chain(*edges)}))
    }
    blocks = team_blocks(Team(members=members, edges=edges, coupling=COUPLING))
    sources = [block for block in blocks if split(block.name)[1] in SOURCES]
    external = [port for block in sources for port in block.output_ports]
    blocks = [block for block in blocks if block not in sources]
    blocks += [within(theorem_candidate(one), name) for name, one in members.items()]
    return connect([*blocks, total_candidate(list(members))], external, name="team")


def beside_claim(loop: Loop, edges: tuple[tuple[str, str], ...]) -> list[Any]:
    """Return what V' has beside the claim."""
    p, signals = loop.parameters, loop.signals
    kappa, gamma = p[named("a", "consensus")].coupling, p[named("a", "adaptation")].gain
    falls = [
        np.sum(p[named(name, "vehicle_controller")].KD * signals[named(name, "e")] ** 2)
        for name in sorted({*chain(*edges)})
    ]
    apart = [
        np.sum((signals[named(one, "alpha")] - signals[named(other, "alpha")]) ** 2)
        for one, other in edges
    ]
    return [rate_of_V(loop) + sum(falls) + kappa / gamma * sum(apart)]
