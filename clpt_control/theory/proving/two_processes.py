"""Statements proved by two processes: this one, and another that takes them one by one.

The other answers only where it has the same equations: its digest may differ from ours, as where
equations were changed in memory.  This process takes statements from the front, the other from
behind, so that not both compile what the first ones run.
"""

import os
from collections import deque
from collections.abc import Callable, Iterator
from concurrent.futures import Future
from contextlib import contextmanager, suppress
from functools import cache
from typing import TYPE_CHECKING

from ...files import cache_folder
from ...progress import interrupt
from ...progress.processes import Pool, processes

if TYPE_CHECKING:  # the other process starts before all this is imported
    from .all_proofs import Outcome, Outcomes, Statement


@contextmanager
def second_process() -> Iterator[Pool | None]:
    """Yield a pool of one process, where there is a core for it."""
    os.environ.setdefault(
        "SYMPY_CACHE_SIZE", "100000"
    )  # 1,000 by default; SymPy reads it when it is imported
    if (os.cpu_count() or 1) < 2:
        yield None
        return
    with processes(1) as pool:
        yield pool


@cache
def own_digest() -> str:
    """Return the digest of what this process proves by."""
    from .all_proofs import digest

    return digest()


def answer(statement: "Statement", digest: str) -> "Outcome | None":
    """Return an outcome from the other process; None where its equations or files are others."""
    return statement.prove() if digest == own_digest() else None


def nothing_cached() -> bool:
    """Whether no outcome was ever stored; to tell whose equations it is of takes long."""
    folder = cache_folder()
    return folder is None or not any(folder.glob("verdicts-*.json"))


def prove_all(
    statements: "list[Statement]",
    digest: str,
    report: Callable[[float], None] = lambda done: None,
    pool: Pool | None = None,
) -> "Outcomes":
    """Prove statements, some of them in a pool; `report` is called with the number done."""
    left, mine = deque(statements), dict["Statement", "Outcome"]()
    theirs = dict["Statement", Future]()

    def hand_over(done: Future | None = None) -> None:
        """Hand the last statement that is left to the pool, and again when it is done."""
        with suppress(IndexError, RuntimeError):  # nothing is left, or the pool is broken
            if pool is not None and digest:
                one = left.pop()
                theirs[one] = pool.submit(answer, one, digest)
                theirs[one].add_done_callback(hand_over)

    if len(left) > 2:
        hand_over()
    while left:
        interrupt.check()
        with suppress(IndexError):  # the pool took the last one
            one = left.popleft()
            mine[one] = one.prove()
        report(len(mine) + sum(future.done() for future in list(theirs.values())))
    for one in statements:
        while one in theirs and not theirs[one].done():
            interrupt.wait(0.05)
        if one not in mine:
            outcome = None
            if one in theirs and theirs[one].exception() is None:
                outcome = theirs[one].result()
            mine[one] = one.prove() if outcome is None else outcome
    return {one: mine[one] for one in statements}
