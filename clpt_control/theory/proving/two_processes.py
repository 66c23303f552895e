"""Parts judged by two processes: this one, and another that is asked part by part.

The other answers only where it judges by the same: its digest may differ from ours, as for
equations that were changed in memory.  This process takes parts
from the front, the other from behind, so that not both compile what the first ones run.
"""

import os
from collections import deque
from collections.abc import Callable, Iterator
from concurrent.futures import Future
from contextlib import contextmanager, suppress
from functools import cache
from typing import TYPE_CHECKING

from ...files.user_cache import cache_folder
from ...progress import interrupt
from ...progress.processes import Pool, processes

if TYPE_CHECKING:  # the other process starts before all this is imported
    from .judgement import Part, Verdict, Verdicts


@contextmanager
def second_process() -> Iterator[Pool | None]:
    """Yield a pool of one process, where there is a core for it."""
    os.environ.setdefault("SYMPY_CACHE_SIZE", "100000")  # 1,000 by default; asked by its import
    if (os.cpu_count() or 1) < 2:
        yield None
        return
    with processes(1) as pool:
        yield pool


@cache
def own_digest() -> str:
    """Return the digest of what this process judges by."""
    from .judgement import digest

    return digest()


def answer(part: "Part", digest: str) -> "Verdict | None":
    """Return the verdict on a part, in the other process; None where it judges by other things."""
    return part.judged() if digest == own_digest() else None


def nothing_kept() -> bool:
    """Whether no verdict was ever kept; what is kept of other equations takes long to tell."""
    folder = cache_folder()
    return folder is None or not any(folder.glob("verdicts-*.json"))


def judge(
    parts: "list[Part]",
    digest: str,
    report: Callable[[float], None] = lambda done: None,
    pool: Pool | None = None,
) -> "Verdicts":
    """Judge parts, some of them in a pool; `report` is called with the number done."""
    left, asked, found = deque(parts), dict["Part", Future](), dict["Part", "Verdict"]()

    def ask(done: Future | None = None) -> None:
        """Hand the last part that is left to the pool, and again when it is done."""
        with suppress(IndexError, RuntimeError):  # nothing is left, or the pool is broken
            if pool is not None and digest:
                part = left.pop()
                asked[part] = pool.submit(answer, part, digest)
                asked[part].add_done_callback(ask)

    if len(left) > 2:
        ask()
    while left:
        interrupt.check()
        with suppress(IndexError):  # the pool took the last one
            part = left.popleft()
            found[part] = part.judged()
        report(len(found) + sum(one.done() for one in list(asked.values())))
    for part in parts:
        while part in asked and not asked[part].done():
            interrupt.wait(0.05)
        if part not in found:
            theirs = None
            if part in asked and asked[part].exception() is None:
                theirs = asked[part].result()
            found[part] = part.judged() if theirs is None else theirs
    return {part: found[part] for part in parts}
