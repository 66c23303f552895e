"""Statements proved by two processes: this one, and another that takes them one by one.

This process takes statements from the front, the other from behind, so that not both compile what
the first ones run.
"""

import os
from collections.abc import Callable, Iterator
from concurrent.futures import Future
from contextlib import contextmanager, nullcontext, suppress
from typing import TYPE_CHECKING

from ...progress import interrupt
from ...progress.processes import Pool, processes

if TYPE_CHECKING:  # the other process starts before all this is imported
    from .all_proofs import Outcome, Outcomes, Statement


@contextmanager
def second_process() -> Iterator[Pool | None]:
    """Yield a pool of one process, where there is a core for it."""
    # 1,000 by default; SymPy reads it when it is imported
    os.environ.setdefault("SYMPY_CACHE_SIZE", "100000")
    with processes(1) if (os.cpu_count() or 1) > 1 else nullcontext() as pool:
        yield pool


def begin(pool: Pool | None) -> None:
    """Start the other process, which imports what proves while this one does so, too."""
    if pool is not None:
        pool.submit(make_ready)


def make_ready() -> None:
    """Import what proves."""
    from . import all_proofs  # noqa: F401


def answer(statement: "Statement") -> "Outcome":
    """Return an outcome from the other process."""
    return statement.prove()


def prove_all(
    statements: "list[Statement]",
    report: Callable[[float], None] = lambda done: None,
    pool: Pool | None = None,
) -> "Outcomes":
    """Prove statements, some of them in a pool; `report` is called with the number done."""
    found, theirs = dict["Statement", "Outcome"](), dict["Statement", Future]()
    if pool is not None and len(statements) > 2:
        with suppress(RuntimeError):  # the pool is broken
            for one in reversed(statements):
                theirs[one] = pool.submit(answer, one)
    for one in statements:
        interrupt.check()
        future = theirs.pop(one, None)
        if future is None or future.cancel():  # the other has not begun it
            found[one] = one.prove()
        else:
            while not future.done():
                interrupt.wait(0.05)
            found[one] = one.prove() if future.exception() else future.result()
        report(len(found) + sum(future.done() for future in theirs.values()))
    return found
