"""The law of a team, proved: V' of the sum of the vehicles' V on the blocks that run.

    V' = -sum_i e_i^T KD_i e_i - (kappa/gamma) sum |alpha_i - alpha_j|^2    over the edges (i, j)

Each vehicle has its own phi, zc, KD, GammaD and alpha_M; theta, gamma and kappa are one.  Shown
for two vehicles, three in a row and three in a circle, exactly for every N.  As V
never rises, e goes to zero by the lemma of Theorem 3.2 and neighbours agree likewise.
"""

from collections.abc import Iterator
from typing import Any

import numpy as np

from ...blocks.lyapunov import lyapunov_candidate, one_gain
from ...blocks.team import total_candidate
from ...diagrams.interconnection import Diagram, connect
from ...equations.namespaces import named, split, within
from ...scenario.team import LAW, Team
from ...simulation.teams import team_blocks
from .lyapunov import Loop, rate_of_V, zero_step
from .proof import Proof, Step, where_all_hold
from .running_rate import running_step
from .symbolic_loop import symbolic_loop
from .theorem_loop import SOURCES, theorem_scenario

GRAPHS = {
    "two vehicles": (("a", "b"),),
    "three in a row": (("a", "b"), ("b", "c")),
    "three in a circle": (("a", "b"), ("b", "c"), ("a", "c")),
}
WIRED = 2  # functions of the diagrams that are read
POINTS = 1_000  # at which the running blocks are called
CITED = (
    "where the pooled Gramian is positive definite in every window alike, the flow parameters of "
    "all vehicles go to theta exponentially (Chen, Wen, Hua and Sun 2014, IEEE Transactions on "
    "Automatic Control 59(1))"
)
COUPLING = 0.6  # stands for any kappa > 0
CLAIM = "V' = -sum e^T KD e - (kappa/gamma) sum over edges |alpha_i - alpha_j|^2"


def judged_team() -> Proof:
    """Judge the law of a team; equations that cannot be read leave it open."""
    claim = f"{CLAIM}, so CLPE goes to zero and the vehicles agree"
    return where_all_hold("proved", claim, team_steps(), CITED)


def team_steps() -> Iterator[Step]:
    """Yield the steps of the proof one by one."""
    for name, edges in GRAPHS.items():
        yield zero_step(
            f"{CLAIM}, {name}, every N",
            lambda edges=edges: team_diagram(edges, WIRED),  # type: ignore[misc]
            lambda loop, edges=edges: [rate_of_V(loop) - claimed_rate(loop, edges)],  # type: ignore[misc]
        )
    yield same_rate_step("three in a row")


def same_rate_step(graph: str) -> Step:
    """Check that the running blocks give the same V'."""

    def read() -> tuple:
        loop = symbolic_loop(diagram := team_diagram(GRAPHS[graph], WIRED))
        return diagram, loop, claimed_rate(loop, GRAPHS[graph])

    return running_step(read, POINTS, f", {graph}")


def team_of(edges: tuple[tuple[str, str], ...], N: int) -> Team:
    """Return a team on a graph whose vehicles differ in all that may differ."""
    names = sorted({name for edge in edges for name in edge})
    members = {
        name: theorem_scenario(N, LAW).with_values(
            {
                "vehicle.feedback": [1.0 + 0.3 * k, 0.7 + 0.2 * k],
                "vehicle.feedforward": [1.2 - 0.4 * k, -0.5 - 0.1 * k],
            }
        )
        for k, name in enumerate(names)
    }
    return Team(members=members, edges=edges, coupling=COUPLING)


def team_diagram(edges: tuple[tuple[str, str], ...], N: int) -> Diagram:
    """Wire a team with its V; phi_x, phi_z and zc of each vehicle are inputs."""
    team = team_of(edges, N)
    blocks = team_blocks(team)
    sources = [block for block in blocks if split(block.name)[1] in SOURCES]
    external = [port for block in sources for port in block.output_ports]
    blocks = [block for block in blocks if block not in sources]
    for name, scenario in team.members.items():
        truth = (scenario.flow.parameters, scenario.vehicle.feedback, scenario.vehicle.feedforward)
        p = one_gain(scenario.learning.used_gains.parameters, *map(np.array, truth))
        blocks.append(within(lyapunov_candidate(LAW, p), name))
    return connect([*blocks, total_candidate(list(team.members))], external, name="team")


def claimed_rate(loop: Loop, edges: tuple[tuple[str, str], ...]) -> Any:
    """Return what is claimed of V'."""
    p, signals = loop.parameters, loop.signals
    kappa, gamma = p[named("a", "consensus")].coupling, p[named("a", "adaptation")].gain
    falls = [
        np.sum(p[named(name, "vehicle_controller")].KD * signals[named(name, "e")] ** 2)
        for name in sorted({name for edge in edges for name in edge})
    ]
    apart = [
        np.sum((signals[named(one, "alpha")] - signals[named(other, "alpha")]) ** 2)
        for one, other in edges
    ]
    return -sum(falls) - kappa / gamma * sum(apart)
