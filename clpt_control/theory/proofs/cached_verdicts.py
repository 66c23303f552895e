"""Outcomes of proofs: those that were reached before, in the user's cache, and new ones.

The file's name is a digest of all that an outcome depends on: the package's own files, in which the
equations are, the versions of what they stand on, the processor and the engine, by which
counterexamples are computed.  So the outcome of other equations is never read.  What proves is
imported only where the file is there.

New ones are proved by two processes: this one takes statements from the front, the other from
behind, so that not both compile what the first ones run.
"""

import gc
import os
import platform
from collections import deque
from collections.abc import Callable, Iterator
from contextlib import contextmanager, nullcontext, suppress
from datetime import UTC, datetime
from functools import cache
from importlib.metadata import version
from pathlib import Path
from threading import Thread
from typing import TYPE_CHECKING, Any

from ...base.files import cache_folder, read_cached, write_cached
from ...base.progress import interrupt
from ...base.progress.processes import Pool, processes
from ...engine.codegen.machine import ENGINE, code_name
from .steps import Proof

if TYPE_CHECKING:  # the other process starts before all this is imported
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
        good = [
            (one, self.times[one], own)
            for one, own in self.outcomes.items()
            if holds(own)
        ]
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
    files = (
        f"{path.relative_to(PACKAGE)}\n{path.read_text('utf-8')}" for path in paths
    )
    versions = platform.python_version(), *map(version, REQUIRED)
    return code_name(*files, *versions, os.environ.get(ENGINE, ""))


@contextmanager
def second_process() -> Iterator[Pool | None]:
    """Yield a pool of one process, where there is a core for it; no garbage is looked for."""
    # 1,000 by default; SymPy reads it when it is imported
    os.environ.setdefault("SYMPY_CACHE_SIZE", "100000")
    gc.disable()  # a search takes a tenth of a second, and finds little: expressions stay
    try:
        with processes(1) if (os.cpu_count() or 1) > 1 else nullcontext() as pool:
            yield pool
    finally:
        gc.freeze()  # else it is looked for among all of them now
        gc.enable()


def make_ready() -> None:
    """Import what proves, which another process does while this one does so, too."""
    gc.disable()
    from . import all_proofs  # noqa: F401


def prove_all(
    statements: "list[Statement]",
    report: Callable[[float], None] = lambda done: None,
    pool: Pool | None = None,
) -> "Outcomes":
    """Prove statements, some of them in a pool; `report` is called with the number done."""
    left, found = deque(statements), dict["Statement", "Outcome"]()

    def hand_over() -> None:
        """Hand the last that is left to the other process, again and again."""
        assert pool is not None
        with suppress(IndexError):
            while one := left.pop():
                try:
                    found[one] = pool.submit(one.prove).result()
                except Exception:
                    # the pool is broken, or this process says what is wrong
                    left.append(one)
                    break

    if pool is not None and len(statements) > 2:
        Thread(target=hand_over, daemon=True).start()
    while len(found) < len(statements):
        interrupt.check()
        try:
            one = left.popleft()
        except IndexError:
            interrupt.wait(0.05)
        else:
            found[one] = one.prove()
        report(len(found))
    return found
