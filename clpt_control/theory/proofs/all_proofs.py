"""All that `clpt prove` proves: theorems, laws, a team.

Every law of the table is proved with its own V on the equations that run.  One with
V' <= -e^T KD e is proved; one with V' <= -e^T KD e + what is bounded is bounded, and the set that V
comes to is said.  A law that is given an estimate of the flow has the V' of Theorem 3.1, and is
bounded in the mean square by the error of the estimate.  A law that learns at fixes keeps V from
rising there.
"""

from collections.abc import Callable
from functools import partial
from typing import Any, NamedTuple

from ...paper.laws.law import Law
from ...paper.laws.table import LAWS
from .fixes import fix_steps
from .invariants import invariant_steps
from .limited_speed import LIMITED_SPEED
from .misprints import misprints
from .paper_loop import PaperLoop
from .prove_law import prove
from .steps import Proof, proof_or_failure, where_all_hold
from .team_proof import proof_of_team
from .theorem_loop import law_and_V
from .theorems import KNOWN_ERROR, THEOREMS, known_flow_steps, numbers_of

POINTS = 1_000  # at which the running blocks are called
N = 2  # functions of a law of the table; a proof for every N says so


MEAN = "in the mean |e| <= |(theta - theta_hat) phi| over the least of KD"


def proof_of_law(law: Law) -> Proof:
    """Prove one law."""
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
        steps = known_flow_steps(PaperLoop(law.name), POINTS)
        return where_all_hold("bounded", f"{KNOWN_ERROR}: {MEAN}", steps)
    verdict = prove(
        law_and_V(law, N)[0], lambda truth, p: law.V(p, truth), points=POINTS
    )
    return Proof(verdict.status, verdict.claim, verdict.for_every_N, verdict.steps)


Outcome = Proof | list[dict[str, Any]]  # of misprints the rows of a table
PROOFS: dict[
    str, tuple[str, dict[str, Callable[[], Proof]]]
] = {  # room -> status where unread
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
    every = {
        room: list(proofs) for room, (_, proofs) in PROOFS.items() if theorem is None
    }
    wanted = {**every, "theorems": numbers_of(theorem), "misprints": [""]}
    return [Statement(room, name) for room, names in wanted.items() for name in names]
