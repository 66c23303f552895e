"""All that `clpt prove` judges, part by part, and each part as plain values and back."""

from dataclasses import asdict
from typing import Any, NamedTuple

from ...blocks.laws.table import LAWS
from ...errors import ClptError
from .judged_laws import JudgedLaw
from .judged_laws import judged as judged_law
from .limited_speed import LIMITS
from .misprints import misprints
from .proof import Proof, Step, judged
from .team import JudgedTeam, judged_team
from .theorems import THEOREMS

Verdicts = dict["Part", Any]
KINDS: dict[str, Any] = {one.__name__: one for one in (Proof, JudgedLaw, JudgedTeam)}


class Part(NamedTuple):
    """One of the things that are judged."""

    room: str  # "theorems", "misprints", "laws", "limited_speed" or "team"
    name: str = ""

    def judged(self) -> Any:
        """Judge it now."""
        if self.room == "misprints":
            keys = ("equation", "printed", "corrected", "check", "confirmed")
            return [{key: getattr(one, key) for key in keys} for one in misprints()]
        if self.room == "laws":
            return judged_law(LAWS[self.name])
        if self.room == "team":
            return judged_team()
        proofs = THEOREMS if self.room == "theorems" else LIMITS
        return judged(self.name, proofs[self.name])


def parts(theorem: str | None = None) -> list[Part]:
    """Return what is judged: one theorem and the misprints, or everything."""
    if theorem is not None and theorem not in THEOREMS:
        raise ClptError(f"theorem {theorem}: must be one of {', '.join(THEOREMS)}")
    found = [Part("theorems", name) for name in THEOREMS if theorem in (None, name)]
    if theorem is None:
        found.append(Part("team"))
        found += [Part("limited_speed", name) for name in LIMITS]
        found += [Part("laws", name) for name in LAWS]
    return [*found, Part("misprints")]


def plain(judged: Any) -> Any:
    """Return a verdict as plain values."""
    if isinstance(judged, list):
        return judged
    said = asdict(judged) if isinstance(judged, Proof) else judged._asdict()
    steps = [asdict(step) if isinstance(step, Step) else step for step in said["steps"]]
    return {**said, "steps": steps, "kind": type(judged).__name__}


def restored(said: Any) -> Any:
    """Return a verdict from plain values, as JSON keeps them."""
    if isinstance(said, list):
        return said
    kept = {name: tuple(v) if isinstance(v, list) else v for name, v in said.items()}
    kept["steps"] = tuple(Step(**step) for step in said["steps"])
    return KINDS[str(kept.pop("kind"))](**kept)


def holds(judged: Any) -> bool:
    """Return whether a verdict is what the package claims."""
    if isinstance(judged, list):
        return all(one["confirmed"] for one in judged)
    return bool(judged.holds)
