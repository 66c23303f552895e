"""The law of a team, proved: V' of the sum of the vehicles' V on the blocks that run.

    V' = -sum_i e_i^T KD_i e_i - (kappa/gamma) sum |alpha_i - alpha_j|^2    over the edges (i, j)

Each vehicle has its own phi, zc, KD, GammaD and alpha_M; theta, gamma and kappa are one.  Shown
for two vehicles, three in a row and three in a circle, exactly for N = 1, 2 and every N.  As V
never rises, e goes to zero by the lemma of Theorem 3.2 and neighbours agree likewise.
"""

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
import sympy

from ...blocks.lyapunov import lyapunov_candidate, one_gain
from ...blocks.team import total_candidate
from ...diagrams.interconnection import Diagram, connect
from ...equations.namespaces import named, split, within
from ...scenario.team import LAW, Team
from ...simulation.teams import team_blocks
from .every_n_loop import EveryNLoop, every_n_loop
from .every_n_signals import Summed
from .lyapunov import short
from .proof import Step, checked, first_failure
from .running_rate import compared
from .symbolic_loop import SymbolicLoop, symbolic_loop
from .theorem_loop import SOURCES, theorem_scenario

GRAPHS = {
    "two vehicles": (("a", "b"),),
    "three in a row": (("a", "b"), ("b", "c")),
    "three in a circle": (("a", "b"), ("b", "c"), ("a", "c")),
}
SIZES = (1, 2)  # numbers of functions
POINTS = 1_000  # at which the running blocks are called
CITED = (
    "where the pooled Gramian is positive definite in every window alike, the flow parameters of "
    "all vehicles go to theta exponentially (Chen, Wen, Hua and Sun 2014, IEEE Transactions on "
    "Automatic Control 59(1))"
)
COUPLING = 0.6  # stands for any kappa > 0
CLAIM = "V' = -sum e^T KD e - (kappa/gamma) sum over edges |alpha_i - alpha_j|^2"


class JudgedTeam(NamedTuple):
    """What is known of V' of a team."""

    status: str  # "proved" or "open"
    claim: str
    for_every_N: bool
    steps: tuple[Step, ...]
    cited: str = CITED

    @property
    def holds(self) -> bool:
        """Whether V' is proved."""
        return self.status == "proved"


def judged_team() -> JudgedTeam:
    """Judge the law of a team; equations that cannot be read leave it open."""
    steps = tuple(team_steps())
    failed = first_failure(steps)
    claim = failed or f"{CLAIM}, so CLPE goes to zero and the vehicles agree"
    return JudgedTeam("open" if failed else "proved", claim, not failed, steps)


def team_steps() -> Iterator[Step]:
    """Yield the steps of the proof one by one."""
    for name, edges in GRAPHS.items():
        yield exact_step(name, edges)
        yield every_N_step(name, edges)
    yield running_step("three in a row")


def exact_step(graph: str, edges: tuple[tuple[str, str], ...]) -> Step:
    """Check V' term by term for each number of functions."""

    def holds() -> tuple[bool, str]:
        for N in SIZES:
            diagram = team_diagram(edges, N)
            loop = symbolic_loop(diagram)
            left = sympy.expand(loop.derivative(loop.signals["V"][0]) - claimed_rate(loop, edges))
            if left != 0:
                return False, f"N = {N}, left over: {short(left)}"
            if loop.undefined:
                return False, loop.undefined[0]
        return True, ""

    return checked(f"{CLAIM}, {graph}, N = 1, 2", "exact", holds, False)


def every_N_step(graph: str, edges: tuple[tuple[str, str], ...]) -> Step:
    """Check V' for every N, base and summand over the functions."""

    def holds() -> tuple[bool, str]:
        loop = every_n_loop(team_diagram(edges, SIZES[-1]))
        rate = loop.derivative(loop.signals["V", None, 0])
        wanted = claimed_summed(loop, edges)
        base, term = (sympy.expand(a - b) for a, b in zip(rate, wanted, strict=True))
        if base != 0 or term != 0:
            return False, f"left over: {short(base)}; summand {short(term)}"
        return not loop.undefined, loop.undefined[0] if loop.undefined else ""

    return checked(f"the same for every N, {graph}", "exact", holds)


def running_step(graph: str) -> Step:
    """Check that the running blocks give the same V'."""

    def holds() -> tuple[bool, str]:
        diagram = team_diagram(GRAPHS[graph], SIZES[-1])
        loop = symbolic_loop(diagram)
        return compared(diagram, loop, claimed_rate(loop, GRAPHS[graph]), POINTS).outcome

    return checked(f"the running blocks give the same V', {graph}", "sampled", holds, False)


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


def claimed_rate(loop: SymbolicLoop, edges: tuple[tuple[str, str], ...]) -> sympy.Expr:
    """Return what is claimed of V' for the loop's own N."""
    p, signals = loop.parameters, loop.signals
    names = sorted({name for edge in edges for name in edge})
    kappa, gamma = p[named("a", "consensus")].coupling, p[named("a", "adaptation")].gain
    rate = sympy.Integer(0)
    for name in names:
        KD = p[named(name, "vehicle_controller")].KD
        rate -= sum(KD[i] * signals[named(name, "e")][i] ** 2 for i in range(2))
    for one, other in edges:
        apart = signals[named(one, "alpha")] - signals[named(other, "alpha")]
        rate -= kappa / gamma * sum(apart**2)
    return rate


def claimed_summed(loop: EveryNLoop, edges: tuple[tuple[str, str], ...]) -> Summed:
    """Return the same for every N: base, and summand over the functions."""
    names = sorted({name for edge in edges for name in edge})
    kappa = loop.parameter(loop.names[named("a", "consensus"), "coupling"])
    gamma = loop.parameter(loop.names[named("a", "adaptation"), "gain"])
    base, term = sympy.Integer(0), sympy.Integer(0)
    for name in names:
        KD = loop.names[named(name, "vehicle_controller"), "KD"]
        for i in range(2):
            base -= loop.parameter(KD, i) * loop.signals[named(name, "e"), None, i].base ** 2
    for one, other in edges:
        for i in range(2):
            alphas = [loop.signals[named(name, "alpha"), i, None] for name in (one, other)]
            term -= kappa / gamma * (alphas[0] - alphas[1]) ** 2
    return Summed(base, term)
