"""What the same prover said of the same equations, kept in the user's cache.

The file's name is a digest of all that a verdict depends on: the package's own files, the versions
of what they stand on, the processor and the engine, by which counterexamples are computed, and the
records of the equations that are judged.  So a verdict on other equations is never found.
"""

import hashlib
import json
import os
import platform
from contextlib import suppress
from datetime import UTC, datetime
from importlib.metadata import version
from pathlib import Path
from typing import Any

from ...blocks.laws.table import LAWS
from ...equations.block import Block
from ...errors import ClptError, DataError
from ...files import write_text
from ...files.user_cache import cache_folder, trusted
from ...native.engines import VARIABLE
from ...native.processor import processor
from ...simulation.loops import error_loop, paper_blocks
from ...simulation.teams import team_blocks
from .judgement import Part, Verdicts, holds, plain, restored
from .team import GRAPHS, team_of
from .theorem_loop import law_and_V, theorem_scenario

PACKAGE = Path(__file__).parents[2]
STOOD_ON = ("clpt-control", "control", "numpy", "scipy", "sympy", "llvmlite")
KEPT = 4  # files of other versions that stay
N = 2  # functions of the equations that are looked at


class Kept:
    """The verdicts that were kept, and the times at which they were reached."""

    def __init__(self) -> None:
        self.digest = digest()
        self.folder = cache_folder()
        self.path = None
        if self.folder is not None and self.digest:
            self.path = self.folder / f"verdicts-{self.digest}.json"
        self.verdicts: Verdicts = {}
        self.times: dict[Part, str] = {}
        if self.path is not None:
            with suppress(OSError, ValueError, KeyError, TypeError, AttributeError):
                self._read(self.path)

    def _read(self, path: Path) -> None:
        if not trusted(path):
            return
        for one in json.loads(path.read_text("utf-8")):
            part = Part(*one["part"])
            self.verdicts[part], self.times[part] = restored(one["said"]), str(one["time"])

    def keep(self, new: Verdicts) -> None:
        """Keep verdicts that were reached now; those that fail are judged again another time."""
        now = datetime.now(UTC).isoformat(timespec="seconds")
        self.verdicts |= new
        self.times |= dict.fromkeys(new, now)
        if self.path is None or self.folder is None:
            return
        rows = [
            {"part": part, "time": self.times[part], "said": plain(said)}
            for part, said in self.verdicts.items()
            if holds(said)
        ]
        with suppress(DataError, OSError):
            write_text(self.path, json.dumps(rows))
            others = [one for one in self.folder.glob("verdicts-*.json") if one != self.path]
            others.sort(key=lambda one: one.stat().st_mtime, reverse=True)
            for one in others[KEPT:]:
                one.unlink(missing_ok=True)


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
