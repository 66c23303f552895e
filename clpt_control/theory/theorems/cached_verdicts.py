"""Cache of outcomes of proofs, and the proofs of statements that are not in the cache.

The name of the cache file is a digest of everything that an outcome depends on: the files of the
package, which contain the equations, the versions of its dependencies, the processor and the
engine, which computes counterexamples.  So an outcome of other equations is never read.

Two processes prove new statements: this one takes statements from the front, the other from the
back, so that they do not compile the same equations.
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
from ..proofs.proof import Proof

if TYPE_CHECKING:  # imported late: the other process starts first
    from .all_proofs import Outcome, Outcomes, Statement

PACKAGE = Path(__file__).parents[2]
REQUIRED = ("clpt-control", "control", "numpy", "scipy", "sympy", "llvmlite")
SUFFIXES = (".py", ".toml", ".ll", ".c")  # equations, the paper's numbers, the solver
MOST_FILES = 5  # of all versions in the cache


class CachedOutcomes:
    """The outcomes in the user's cache, and the times of their proofs."""

    def __init__(self) -> None:
        folder = cache_folder()
        self.path = folder / f"verdicts-{digest()}.json" if folder else None
        self.outcomes: Outcomes = {}
        self.times: dict[Statement, str] = {}
        text = read_cached(self.path) if self.path else None
        if not text:
            return
        with suppress(ValueError):
            for statement, time, outcome in rows().validate_json(text):
                self.outcomes[statement] = outcome
                self.times[statement] = time

    def store(self, new: "Outcomes") -> None:
        """Store new outcomes; a failure is not written, so it is proved again next time."""
        now = datetime.now(UTC).isoformat(timespec="seconds")
        self.outcomes |= new
        self.times |= dict.fromkeys(new, now)
        if self.path is None:
            return
        written = [
            (statement, self.times[statement], outcome)
            for statement, outcome in self.outcomes.items()
            if holds(outcome)
        ]
        write_cached(self.path, rows().dump_json(written), MOST_FILES)


@cache
def rows() -> Any:
    """Return the adapter of JSON to statements, times and outcomes."""
    from pydantic import TypeAdapter

    from .all_proofs import Outcome, Statement

    return TypeAdapter(list[tuple[Statement, str, Outcome]])


def holds(outcome: "Outcome") -> bool:
    """Return whether an outcome is what the package claims."""
    if isinstance(outcome, Proof):
        return outcome.as_expected
    return all(misprint["confirmed"] for misprint in outcome)


def digest() -> str:
    """Return a digest of everything that an outcome depends on."""
    paths = sorted(path for path in PACKAGE.rglob("*") if path.suffix in SUFFIXES)
    texts = []
    for path in paths:
        name = path.relative_to(PACKAGE)
        texts.append(f"{name}\n{path.read_text('utf-8')}")
    versions = [platform.python_version(), *map(version, REQUIRED)]
    return code_name(*texts, *versions, os.environ.get(ENGINE, ""))


@contextmanager
def second_process() -> Iterator[Pool | None]:
    """Yield a pool of one process, or None on one core; garbage collection is off."""
    # 1,000 by default; SymPy reads it when it is imported
    os.environ.setdefault("SYMPY_CACHE_SIZE", "100000")
    gc.disable()  # a collection takes 0.1 s and frees little: SymPy caches expressions
    has_core = (os.cpu_count() or 1) > 1
    try:
        with processes(1) if has_core else nullcontext() as pool:
            yield pool
    finally:
        gc.freeze()  # otherwise all expressions are searched now
        gc.enable()


def make_ready() -> None:
    """Import the proofs in the other process, while this process imports them as well."""
    gc.disable()
    from . import all_proofs  # noqa: F401


def prove_all(
    statements: "list[Statement]",
    report: Callable[[float], None] = lambda count: None,
    pool: Pool | None = None,
) -> "Outcomes":
    """Prove statements, some of them in a pool; `report` is called with the number done."""
    queue = deque(statements)
    outcomes: Outcomes = {}

    def prove_in_pool(pool: Pool) -> None:
        """Submit the last statement of the queue to the other process, until none is left."""
        with suppress(IndexError):
            while statement := queue.pop():
                try:
                    outcomes[statement] = pool.submit(statement.prove).result()
                except Exception:
                    # the pool is broken, or this process raises the same error
                    queue.append(statement)
                    break

    if pool is not None and len(statements) > 2:
        Thread(target=prove_in_pool, args=(pool,), daemon=True).start()
    while len(outcomes) < len(statements):
        interrupt.check()
        try:
            statement = queue.popleft()
        except IndexError:
            interrupt.wait(0.05)
        else:
            outcomes[statement] = statement.prove()
        report(len(outcomes))
    return outcomes
