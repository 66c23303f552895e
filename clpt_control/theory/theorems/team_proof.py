"""Proof of the law of a team: several vehicles that learn one flow.

    V' = -sum_i e_i^T KD_i e_i - (kappa/gamma) sum |alpha_i - alpha_j|^2    over the edges (i, j)

V is the sum of the vehicles' V.  Each vehicle has its own phi, zc, KD, GammaD and alpha_M; theta,
gamma and kappa are shared.  Proved for two vehicles, three in a row and three in a circle, for
every N.  As V is non-increasing, e goes to zero by the argument of Theorem 3.2, and so do the
differences between neighbours.
"""

from itertools import chain

import numpy as np

from ...engine.diagram.interconnection import Diagram, connect
from ...engine.model.ports import named, split, within
from ...paper.laws.consensus import total_candidate
from ...paper.scenario.team import TEAM_LAW, Team
from ...simulation.loops import team_blocks
from ..laws.paper_loop import PaperLoop, line
from ..laws.theorem_loop import SOURCES, WIRED, theorem_candidate, theorem_scenario
from ..proofs.conclusions import Condition
from ..proofs.proof import Proof, where_all_hold
from ..proofs.same_as_running import running_step
from ..proofs.steps import Step
from ..proofs.symbolic_loop import ArrayLoop, symbolic_loop

POINTS = 1_000  # at which the running blocks are called
N = 2  # basis functions of each running vehicle
GRAPHS = {
    "two vehicles": (("a", "b"),),
    "three in a row": (("a", "b"), ("b", "c")),
    "three in a circle": (("a", "b"), ("b", "c"), ("a", "c")),
}
CITED = (
    "where the pooled Gramian is positive definite, and phi has bounded variation, in every window "
    "alike, the flow parameters of all vehicles go to theta exponentially (Chen, Wen, Hua and Sun "
    "2014, IEEE Transactions on Automatic Control 59(1))"
)
COUPLING = 0.6  # becomes a symbol, kappa > 0
DRIVEN = "phi, zc are"
CLAIM = "V' = -sum e^T KD e - (kappa/gamma) sum over edges |alpha_i - alpha_j|^2"


def proof_of_team() -> Proof:
    """Prove the law of a team."""
    steps = [step for name, edges in GRAPHS.items() for step in steps_of(name, edges)]
    row = team_diagram(GRAPHS["three in a row"], N)
    steps.append(running_step(lambda: symbolic_loop(row), POINTS, ", three in a row"))
    where = (
        Condition("graphs", ", ".join(GRAPHS)),
        Condition("bounded inputs", DRIVEN),
    )
    of = "CLPE and each alpha_i - alpha_j go"
    return where_all_hold(CLAIM, steps, "jumps", where, of=of, cited=CITED)


def steps_of(name: str, edges: tuple[tuple[str, str], ...]) -> list[Step]:
    """Return the steps of one graph, for every N."""
    loop = ArrayLoop(team_diagram(edges, WIRED))
    team = {v: PaperLoop(loop=loop, vehicle=v) for v in vehicles(edges)}
    members = team.values()
    member = next(iter(members))
    kappa = loop.parameters[named("a", "consensus")].coupling
    differences = [team[i].alpha - team[j].alpha for i, j in edges]
    pairs = [
        (v, [team[j] for edge in edges if i in edge for j in edge if j != i])
        for i, v in team.items()
    ]
    fall = sum(np.sum(v.KD * v.e**2) for v in members)
    fall = fall + kappa / member.gamma * sum(np.sum(d**2) for d in differences)
    V = sum(v.sum_of_squares() for v in members)
    x_rates = [v.rate(v.x) - v.vehicle_rate for v in members]
    e_rates = [v.rate(v.e) - v.error_rate for v in members]
    sums = {
        v: kappa * sum(v.alpha - w.alpha for w in neighbours) for v, neighbours in pairs
    }
    alpha_rates = [
        v.rate(v.alpha) + v.gamma * np.outer(v.e, v.phi) + pull
        for v, pull in sums.items()
    ]
    positive = member.positive(*(v.KD for v in members))
    return [
        line(
            f"{CLAIM}, {name}",
            member.zero(member.rate(V) + fall),
            shows="values falls loses",
        ),
        line(
            "V is half the sum of squares of the errors of all vehicles, each with a positive "
            f"weight, {name}",
            member.zero(member.V - V),
            shows="definite",
        ),
        line(
            "x_i is bounded, Eq. (9)", positive, member.zero(*x_rates), shows="exists"
        ),
        line(
            "(27)  e_i' and alpha_i' are made of phi, zc and what V and x_i bound",
            member.zero(*e_rates, *alpha_rates),
            shows="limit",
        ),
    ]


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
