"""All that `clpt prove` judges, part by part, and what the same prover said of it before.

Verdicts are kept in the user's cache.  The file's name is a digest of all that a verdict depends
on: the package's own files, the versions of what they stand on, the processor and the engine, by
which counterexamples are computed, and the records of the equations that are judged.  So a verdict
on other equations is never found.
"""

import hashlib
import os
import platform
from contextlib import suppress
from datetime import UTC, datetime
from functools import cache
from importlib.metadata import version
from pathlib import Path
from typing import Any, NamedTuple

from ...blocks.laws.table import LAWS
from ...equations.block import Block
from ...errors import ClptError, DataError
from ...files import write_text
from ...files.user_cache import cache_folder, trusted
from ...native.engines import VARIABLE
from ...native.processor import processor
from ...simulation.loops import error_loop, paper_blocks
from ...simulation.teams import team_blocks
from .judged_laws import judged as judged_law
from .limited_speed import LIMITS
from .misprints import misprints
from .proof import Proof, judged
from .team import GRAPHS, judged_team, team_of
from .theorem_loop import law_and_V, theorem_scenario
from .theorems import THEOREMS

PACKAGE = Path(__file__).parents[2]
STOOD_ON = ("clpt-control", "control", "numpy", "scipy", "sympy", "llvmlite")
KEPT = 4  # files of other versions that stay
N = 2  # functions of the equations that are looked at
Verdict = Proof | list[dict[str, Any]]  # of misprints the rows of a table


class Part(NamedTuple):
    """One of the things that are judged."""

    room: str  # "theorems", "misprints", "laws", "limited_speed" or "team"
    name: str = ""

    def judged(self) -> Verdict:
        """Judge it now."""
        if self.room == "misprints":
            keys = ("equation", "printed", "corrected", "check", "confirmed")
            return [{key: getattr(one, key) for key in keys} for one in misprints()]
        if self.room == "laws":
            return judged_law(LAWS[self.name])
        if self.room == "team":
            return judged("open", judged_team)
        proofs = THEOREMS if self.room == "theorems" else LIMITS
        return judged("failed", proofs[self.name])


Verdicts = dict[Part, Verdict]


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


class Kept:
    """The verdicts that were kept, and the times at which they were reached."""

    def __init__(self) -> None:
        self.digest, self.folder = digest(), cache_folder()
        self.path = None
        if self.folder is not None and self.digest:
            self.path = self.folder / f"verdicts-{self.digest}.json"
        self.verdicts: Verdicts = {}
        self.times: dict[Part, str] = {}
        with suppress(OSError, ValueError):
            if self.path is not None and trusted(self.path):
                for part, time, said in rows().validate_json(self.path.read_bytes()):
                    self.verdicts[part], self.times[part] = said, time

    def keep(self, new: Verdicts) -> None:
        """Keep verdicts that were reached now; those that fail are judged again another time."""
        now = datetime.now(UTC).isoformat(timespec="seconds")
        self.verdicts |= new
        self.times |= dict.fromkeys(new, now)
        if self.path is None or self.folder is None:
            return
        good = [(part, self.times[part], said) for part, said in self.verdicts.items()]
        good = [row for row in good if holds(row[2])]
        with suppress(DataError, OSError):
            write_text(self.path, rows().dump_json(good).decode())
            others = [one for one in self.folder.glob("verdicts-*.json") if one != self.path]
            others.sort(key=lambda one: one.stat().st_mtime, reverse=True)
            for one in others[KEPT:]:
                one.unlink(missing_ok=True)


@cache
def rows() -> Any:
    """Return what reads and writes verdicts as JSON: their part, time and what is said."""
    from pydantic import TypeAdapter

    return TypeAdapter(list[tuple[Part, str, Verdict]])


def holds(verdict: Verdict) -> bool:
    """Return whether a verdict is what the package claims."""
    if isinstance(verdict, Proof):
        return verdict.holds
    return all(one["confirmed"] for one in verdict)


def digest() -> str:
    """Return a name for all that a verdict depends on; nothing where equations cannot be read."""
    try:
        said = [_said(block) for block in _judged_blocks()]
    except ClptError:
        return ""
    found = hashlib.sha256()
    for path in sorted(PACKAGE.rglob("*.py")):
        found.update(f"{path.relative_to(PACKAGE)}\n".encode() + path.read_bytes())
    made_of = [platform.python_version(), *(version(name) for name in STOOD_ON)]
    made_of += [*processor(), os.environ.get(VARIABLE, ""), *said]
    found.update("\n".join(made_of).encode())
    return found.hexdigest()[:32]


def _judged_blocks() -> list[Block]:
    """Return the blocks whose equations are judged."""
    blocks = team_blocks(team_of(GRAPHS["three in a circle"], N))
    for law in LAWS.values():
        blocks += law_and_V(law, N)
        blocks += paper_blocks(theorem_scenario(N, law.name, disturbed=True))
    blocks += paper_blocks(theorem_scenario(N, "learned-flow", speed="hedged"))
    errors: Any = error_loop(theorem_scenario(N, "learned-flow"))
    return [*blocks, *errors.syslist]


def _said(block: Block) -> str:
    """Return all that is known of a block's equations."""
    ports = block.input_ports, block.output_ports, block.state_ports
    return "\n".join(map(str, (block.name, ports, block.parameters, block.records)))
