"""How far an ensemble has come, how fast, and how long it will take.

A bar on a terminal, a plain line now and then elsewhere; both on standard error.
"""

import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager

from ..progress import LOG_EVERY, PATIENCE


@contextmanager
def member_counter(what: str, members: int) -> Iterator[Callable[[int], None]]:
    """Show members done, members a second and the time left.

    Parameters
    ----------
    what : str
        What is being done.
    members : int
        How many there are.

    Yields
    ------
    callable
        ``report(done)``; the first call tells what was done before.

    Examples
    --------
    >>> with member_counter("waiting", 10) as report:
    ...     report(5)
    """
    start = time.monotonic()
    terminal = sys.stderr.isatty()
    bar = task = before = None
    shown = float("-inf")

    def report(done: int) -> None:
        nonlocal bar, task, shown, before
        now = time.monotonic()
        if before is None:
            before = done
        if now - start < PATIENCE or now - shown < (0.1 if terminal else LOG_EVERY):
            return
        shown = now
        rate = (done - before) / (now - start)
        state = f"{done} of {members} members{speed(rate, members - done)}"
        if not terminal:
            print(f"{what}: {state}", file=sys.stderr, flush=True)
            return
        if bar is None:
            from rich.console import Console
            from rich.progress import BarColumn, Progress, TextColumn

            columns = (TextColumn(what), BarColumn(), TextColumn("{task.description}"))
            bar = Progress(*columns, console=Console(stderr=True), transient=True)
            bar.start()
            task = bar.add_task(state, total=members)
        bar.update(task, completed=done, description=state)

    try:
        yield report
    finally:
        if bar is not None:
            bar.stop()


def speed(rate: float, left: int) -> str:
    """Say members a second and the time left.

    Parameters
    ----------
    rate : float
        Members a second.
    left : int
        Members to do.

    Returns
    -------
    str
        Empty before the first member.

    Examples
    --------
    >>> speed(1600.0, 320000)
    ', 1600 a second, 3:20 left'
    """
    if not rate > 0:
        return ""
    minutes, seconds = divmod(round(left / rate), 60)
    hours, minutes = divmod(minutes, 60)
    clock = f"{hours}:{minutes:02d}:{seconds:02d}" if hours else f"{minutes}:{seconds:02d}"
    return f", {rate:.4g} a second, {clock} left"
