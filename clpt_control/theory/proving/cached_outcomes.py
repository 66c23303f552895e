"""The outcomes of proofs that were reached before, in the user's cache.

The file's name is a digest of all that an outcome depends on: the package's own files, in which the
equations are, the versions of what they stand on, the processor and the engine, by which
counterexamples are computed.  So the outcome of other equations is never read.  What proves is
imported only where the file is there.
"""

import os
import platform
from contextlib import suppress
from datetime import UTC, datetime
from functools import cache
from importlib.metadata import version
from pathlib import Path
from typing import TYPE_CHECKING, Any

from ...files import cache_folder, read_cached, write_cached
from ...native.machine import ENGINE, code_name
from .proof import Proof

if TYPE_CHECKING:
    from .all_proofs import Outcome, Outcomes, Statement

PACKAGE = Path(__file__).parents[2]
REQUIRED = ("clpt-control", "control", "numpy", "scipy", "sympy", "llvmlite")
READ = (".py", ".toml", ".ll", ".c")  # equations, the paper's numbers, the solver
MOST_FILES = 5  # of this and other versions that stay


class CachedOutcomes:
    """The outcomes in the user's cache, and the times at which they were reached."""

    def __init__(self) -> None:
        folder = cache_folder()
        self.path = folder / f"verdicts-{digest()}.json" if folder else None
        self.outcomes: Outcomes = {}
        self.times: dict[Statement, str] = {}
        text = None if self.path is None else read_cached(self.path)
        with suppress(ValueError):
            for statement, time, outcome in rows().validate_json(text) if text else []:
                self.outcomes[statement], self.times[statement] = outcome, time

    def store(self, new: "Outcomes") -> None:
        """Store outcomes that were reached now; those that fail are proved again another time."""
        now = datetime.now(UTC).isoformat(timespec="seconds")
        self.outcomes |= new
        self.times |= dict.fromkeys(new, now)
        if self.path is None:
            return
        good = [(one, self.times[one], own) for one, own in self.outcomes.items() if holds(own)]
        write_cached(self.path, rows().dump_json(good), MOST_FILES)


@cache
def rows() -> Any:
    """Return the adapter that reads and writes statements, times and outcomes as JSON."""
    from pydantic import TypeAdapter

    from .all_proofs import Outcome, Statement

    return TypeAdapter(list[tuple[Statement, str, Outcome]])


def holds(outcome: "Outcome") -> bool:
    """Return whether an outcome is what the package claims."""
    if isinstance(outcome, Proof):
        return outcome.holds
    return all(one["confirmed"] for one in outcome)


def digest() -> str:
    """Return a name for all that an outcome depends on."""
    paths = sorted(path for path in PACKAGE.rglob("*") if path.suffix in READ)
    files = (f"{path.relative_to(PACKAGE)}\n{path.read_text('utf-8')}" for path in paths)
    versions = platform.python_version(), *map(version, REQUIRED)
    return code_name(*files, *versions, os.environ.get(ENGINE, ""))
