"""Proof of the law of a team: several vehicles that learn one flow.

    V' = -sum_i e_i^T KD_i e_i - (kappa/gamma) sum |alpha_i - alpha_j|^2    over the edges (i, j)

V is the sum of the vehicles' V.  Each vehicle has its own phi, zc, KD, GammaD and alpha_M; theta,
gamma and kappa are shared.  Proved for two vehicles, three in a row and three in a circle, for
every N.  As V is non-increasing, e goes to zero by the argument of Theorem 3.2, and so do the
differences between neighbours.
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
from ...simulation.loops import team_blocks
from .same_as_running import running_step
from .proof import Proof, where_all_hold
from .steps import Step
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
N = 2  # basis functions of each running vehicle
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
COUPLING = 0.6  # becomes a symbol, kappa > 0
CLAIM = "V' = -sum e^T KD e - (kappa/gamma) sum over edges |alpha_i - alpha_j|^2"


def proof_of_team() -> Proof:
    """Prove the law of a team."""
    claim = f"{CLAIM}, so CLPE goes to zero and the vehicles agree: {', '.join(GRAPHS)}"
    return where_all_hold("proved", claim, team_steps(), CITED)


def team_steps() -> Iterator[Step]:
    """Yield the steps of the proof one by one."""
    for name, edges in GRAPHS.items():
        diagram = partial(team_diagram, edges, N)
        residuals = partial(residuals_of_claim, edges=edges)
        yield zero_step(f"{CLAIM}, {name}, every N", diagram, residuals)
    row = team_diagram(GRAPHS["three in a row"], N)
    yield running_step(lambda: symbolic_loop(row), POINTS, ", three in a row")


def team_diagram(edges: tuple[tuple[str, str], ...], N: int) -> Diagram:
    """Wire a team with its V; its vehicles differ in all parameters that may differ.

    phi_x, phi_z and zc of each vehicle are inputs.
    """
    scenario = theorem_scenario(N, TEAM_LAW)
    members = {}
    for k, name in enumerate(vehicles(edges)):
        settings = {
            "vehicle.feedback": [1.0 + 0.3 * k, 0.7 + 0.2 * k],
            "vehicle.feedforward": [1.2 - 0.4 * k, -0.5 - 0.1 * k],
        }
        members[name] = scenario.with_values(settings)
    team = Team(members=members, edges=edges, coupling=COUPLING)
    blocks, external = [], []
    for block in team_blocks(team):
        if split(block.name)[1] in SOURCES:
            external += [*block.output_ports]
        else:
            blocks.append(block)
    for name, member in members.items():
        blocks.append(within(theorem_candidate(member), name))
    return connect([*blocks, total_candidate([*members])], external, name="team")


def vehicles(edges: tuple[tuple[str, str], ...]) -> list[str]:
    """Return the names of the vehicles of a graph."""
    return sorted({*chain(*edges)})


def residuals_of_claim(loop: Loop, edges: tuple[tuple[str, str], ...]) -> list[Any]:
    """Return V' less the claim."""
    kappa = loop.parameters[named("a", "consensus")].coupling
    gamma = loop.parameters[named("a", "adaptation")].gain
    residual = rate_of_V(loop)
    for name in vehicles(edges):
        KD = loop.parameters[named(name, "vehicle_controller")].KD
        residual = residual + np.sum(KD * loop.signals[named(name, "e")] ** 2)
    for edge in edges:
        alpha_i, alpha_j = (loop.signals[named(name, "alpha")] for name in edge)
        residual = residual + kappa / gamma * np.sum((alpha_i - alpha_j) ** 2)
    return [residual]
