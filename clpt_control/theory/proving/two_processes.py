"""Statements proved by two processes: this one, and another that takes them one by one.

This process takes statements from the front, the other from behind, so that not both compile what
the first ones run.
"""

import os
from collections import deque
from collections.abc import Callable, Iterator
from concurrent.futures import Future
from contextlib import contextmanager, suppress
from typing import TYPE_CHECKING

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


def answer(statement: "Statement") -> "Outcome":
    """Return an outcome from the other process."""
    return statement.prove()


def prove_all(
    statements: "list[Statement]",
    report: Callable[[float], None] = lambda done: None,
    pool: Pool | None = None,
) -> "Outcomes":
    """Prove statements, some of them in a pool; `report` is called with the number done."""
    left, found = deque(statements), dict["Statement", "Outcome"]()
    theirs = dict["Statement", Future]()

    def hand_over(done: Future | None = None) -> None:
        """Hand the last statement that is left to the pool, and again when it is done."""
        with suppress(IndexError, RuntimeError):  # nothing is left, or the pool is broken
            if pool is not None:
                one = left.pop()
                theirs[one] = pool.submit(answer, one)
                theirs[one].add_done_callback(hand_over)

    if len(left) > 2:
        hand_over()
    while left:
        interrupt.check()
        with suppress(IndexError):  # the pool took the last one
            one = left.popleft()
            found[one] = one.prove()
        report(len(found) + sum(future.done() for future in list(theirs.values())))
    for one in statements:
        while one in theirs and not theirs[one].done():
            interrupt.wait(0.05)
        if one not in found:
            proved = one in theirs and theirs[one].exception() is None
            found[one] = theirs[one].result() if proved else one.prove()
    return found
