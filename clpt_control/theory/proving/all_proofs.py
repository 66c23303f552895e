"""All that `clpt prove` proves: theorems, laws, a team.

Every law of the table is proved with its own V on the equations that run.  One with
V' <= -e^T KD e is proved; one with V' <= -e^T KD e + what is bounded is bounded, and the set that V
comes to is said.  A law that is given an estimate of the flow has the V' of Theorem 3.1, and is
bounded in the mean square by the error of the estimate.  A law that learns at fixes keeps V from
rising there.  Of a team V is the sum of the vehicles' V,

    V' = -sum_i e_i^T KD_i e_i - (kappa/gamma) sum |alpha_i - alpha_j|^2    over the edges (i, j)

Each vehicle has its own phi, zc, KD, GammaD and alpha_M; theta, gamma and kappa are one.  Shown
for two vehicles, three in a row and three in a circle, exactly for every N.  As V
never rises, e goes to zero by the lemma of Theorem 3.2 and neighbours agree likewise.
"""

from collections.abc import Callable, Iterator
from functools import partial
from typing import Any, NamedTuple

import numpy as np

from ...blocks.consensus import total_candidate
from ...blocks.laws.law import Law
from ...blocks.laws.table import LAWS
from ...diagrams.interconnection import Diagram, connect
from ...equations.ports import named, split, within
from ...scenario.team import TEAM_LAW, Team
from ...simulation.team_loops import team_blocks
from .fixes import fix_steps
from .invariants import invariant_steps
from .limited_speed import LIMITED_SPEED
from .misprints import misprints
from .own_law import prove
from .proof import Proof, Step, proof_or_failure, where_all_hold
from .running_rate import running_step
from .symbolic_loop import symbolic_loop
from .theorem_loop import (
    KNOWN_ERROR,
    SOURCES,
    Loop,
    decay_and_known_error,
    falls_as_claimed,
    identity_steps,
    law_and_V,
    theorem_candidate,
    theorem_scenario,
)
from .theorems import THEOREMS, numbers_of

POINTS = 1_000  # at which the running blocks are called
N = 2  # functions; a proof for every N says so
MEAN = f"{KNOWN_ERROR}: in the mean |e| <= |(theta - theta_hat) phi| over the least of KD"


def proof_of_law(law: Law) -> Proof:
    """Prove one law; equations that cannot be read leave it open."""
    return proof_or_failure("open", lambda: _of_law(law))


def _of_law(law: Law) -> Proof:
    if law.at_fixes:  # V does not rise, but CLPE is only what fixes leave
        claim = f"V' = {law.V_rate}; |eta_k| <= (2 V(0) P_kk)^(1/2)/r"
        return where_all_hold("bounded", claim, fix_steps(law, POINTS))
    if law.invariants is not None:
        status, end = "proved", "so CLPE goes to zero"
        if law.perturbation is not None:
            status, end = "bounded", "in the mean |e| <= |eta phi| over the least of KD"
        claim = f"V' <= {law.V_rate}, {end}"
        return where_all_hold(status, claim, invariant_steps(law, POINTS))
    if law.given_estimate:
        steps = identity_steps(KNOWN_ERROR, law.name, decay_and_known_error, POINTS)
        return where_all_hold("bounded", MEAN, steps)
    verdict = prove(law_and_V(law, N)[0], lambda truth, p: law.V(p, truth), points=POINTS)
    return Proof(verdict.status, verdict.claim, verdict.for_every_N, verdict.steps)


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
        diagram, claim = partial(team_diagram, edges, N), partial(claimed_rate, edges=edges)
        yield falls_as_claimed(f"{CLAIM}, {name}, every N", diagram, claim)
    loop = team_diagram(GRAPHS["three in a row"], N)
    yield running_step(lambda: (loop, symbolic_loop(loop)), POINTS, ", three in a row")


def team_of(edges: tuple[tuple[str, str], ...], N: int) -> Team:
    """Return a team on a graph whose vehicles differ in all that may differ."""
    names = sorted({name for edge in edges for name in edge})
    members = {
        name: theorem_scenario(N, TEAM_LAW).with_values(
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
        blocks.append(within(theorem_candidate(scenario), name))
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


Outcome = Proof | list[dict[str, Any]]  # of misprints the rows of a table
PROOFS: dict[str, tuple[str, dict[str, Callable[[], Proof]]]] = {  # room -> status where unread
    "theorems": ("failed", THEOREMS),
    "team": ("open", {"": proof_of_team}),
    "limited_speed": ("failed", LIMITED_SPEED),
    "laws": ("open", {name: partial(proof_of_law, law) for name, law in LAWS.items()}),
}


class Statement(NamedTuple):
    """One of the things that are proved."""

    room: str  # of `PROOFS`, or "misprints"
    name: str = ""

    def prove(self) -> Outcome:
        """Prove it now."""
        if self.room == "misprints":
            keys = ("equation", "printed", "corrected", "check", "confirmed")
            return [{key: getattr(one, key) for key in keys} for one in misprints()]
        status, proofs = PROOFS[self.room]
        return proof_or_failure(status, proofs[self.name])


Outcomes = dict[Statement, Outcome]


def statements(theorem: str | None = None) -> list[Statement]:
    """Return what is proved: one theorem and the misprints, or everything."""
    others = [room for room in PROOFS if room != "theorems" and theorem is None]
    wanted = [("theorems", number) for number in numbers_of(theorem)]
    wanted += [(room, name) for room in others for name in PROOFS[room][1]]
    return [Statement(*one) for one in [*wanted, ("misprints", "")]]
