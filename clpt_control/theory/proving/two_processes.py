"""Statements proved by two processes: this one, and another that takes them one by one.

This process takes statements from the front, the other from behind, so that not both compile what
the first ones run.
"""

import gc
import os
from collections import deque
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


def begin(pool: Pool | None) -> None:
    """Start the other process, which imports what proves while this one does so, too."""
    if pool is not None:
        pool.submit(make_ready)


def make_ready() -> None:
    """Import what proves."""
    gc.disable()
    from . import all_proofs  # noqa: F401


def prove_all(
    statements: "list[Statement]",
    report: Callable[[float], None] = lambda done: None,
    pool: Pool | None = None,
) -> "Outcomes":
    """Prove statements, some of them in a pool; `report` is called with the number done."""
    left, found, theirs = deque(statements), dict["Statement", "Outcome"](), []

    def hand_over(done: Future | None = None) -> None:
        """Hand the last that is left to the other process, which has nothing to do."""
        assert pool is not None
        with suppress(IndexError):
            one = left.pop()
            try:
                future = pool.submit(one.prove)
            except RuntimeError:  # the pool is broken
                left.append(one)
            else:
                theirs.append((one, future))
                future.add_done_callback(hand_over)

    if pool is not None and len(statements) > 2:
        hand_over()
    while len(found) < len(statements):
        interrupt.check()
        try:
            one = left.popleft()
        except IndexError:
            interrupt.wait(0.05)
        else:
            found[one] = one.prove()
        for one, future in theirs:
            if one not in found and future.done():
                found[one] = one.prove() if future.exception() else future.result()
        report(len(found))
    return found
