"""All proofs of `clpt prove`: theorems, limited speed, laws and the team.

Every law of the table is proved with its own V on the equations that run.  A law with
V' <= -e^T KD e is proved.  A law with V' <= -e^T KD e + bounded terms is bounded, and the claim
states the set that V reaches.  A law with a given estimate of the flow has the V' of Theorem 3.1,
and is bounded in the mean square by the error of the estimate.  V of a law that learns at fixes
does not rise at fixes.
"""

from collections.abc import Callable
from functools import partial
from typing import Any, NamedTuple

from ...paper.laws.law import Law
from ...paper.laws.table import LAWS
from ..algebra.texts import bound_text
from ..laws.prove_law import verdict_on_row
from ..laws.theorem_loop import law_and_V
from ..proofs.proof import Proof, proof_or_failure
from .limited_speed import LIMITED_SPEED
from .misprints import misprints
from .team_proof import proof_of_team
from .theorems import THEOREMS, numbers_of

POINTS = 1_000  # at which the running blocks are called
N = 2  # basis functions of a law of the table; a proof for every N says so


def proof_of_law(law: Law) -> Proof:
    """Prove one law; return what is written of its verdict: its fields as text and numbers."""
    verdict = verdict_on_row(law, POINTS, law_and_V(law, N)[0])
    level = None if verdict.level is None else bound_text(verdict.level)
    return Proof(**{**verdict.judged, "level": level})


Outcome = Proof | list[dict[str, Any]]  # of misprints, the rows of a table
PROOFS: dict[str, dict[str, Callable[[], Proof]]] = {
    "theorems": THEOREMS,
    "team": {"": proof_of_team},
    "limited_speed": LIMITED_SPEED,
    "laws": {name: partial(proof_of_law, law) for name, law in LAWS.items()},
}


class Statement(NamedTuple):
    """A statement that `clpt prove` proves."""

    room: str  # of `PROOFS`, or "misprints"
    name: str = ""

    def prove(self) -> Outcome:
        """Prove the statement."""
        if self.room == "misprints":
            keys = ("equation", "printed", "corrected", "check", "confirmed")
            rows = misprints()
            return [{key: getattr(row, key) for key in keys} for row in rows]
        return proof_or_failure(PROOFS[self.room][self.name])


def statements(theorem: str | None, law: str | None) -> list[Statement]:
    """Return one theorem and the misprints, or one law, or all statements."""
    if law is not None:
        return [Statement("laws", law)]
    names = {}
    if theorem is None:
        names = {room: [*proofs] for room, proofs in PROOFS.items()}
    names["theorems"] = numbers_of(theorem)
    names["misprints"] = [""]
    return [Statement(room, name) for room in names for name in names[room]]
