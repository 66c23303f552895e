"""A progress bar on standard error, for work that lasts over two seconds.

Where standard error is no terminal, a plain line now and then stands in for it.
"""

import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager

PATIENCE = 2.0  # seconds before the bar appears
LOG_EVERY = 10.0  # seconds between lines where there is no terminal


@contextmanager
def progress_bar(what: str, total: float) -> Iterator[Callable[[float], None]]:
    """Show how far a long work has come, on standard error.

    Parameters
    ----------
    what : str
        What is being done.
    total : float
        Where it ends, in any unit.

    Yields
    ------
    callable
        ``report(done)``: call it as often as you like.

    Examples
    --------
    >>> with progress_bar("waiting", 1.0) as report:
    ...     report(0.5)
    """
    start = time.monotonic()
    terminal = sys.stderr.isatty()
    bar = task = None
    shown = float("-inf")

    def report(done: float) -> None:
        nonlocal bar, task, shown
        now = time.monotonic()
        if now - start < PATIENCE or now - shown < (0.1 if terminal else LOG_EVERY):
            return
        shown = now
        if not terminal:
            print(f"{what}: {100 * done / total:.0f} %", file=sys.stderr, flush=True)
            return
        if bar is None:
            from rich.console import Console
            from rich.progress import BarColumn, Progress, TextColumn, TimeRemainingColumn

            bar = Progress(
                TextColumn("{task.description}"),
                BarColumn(),
                TextColumn("{task.percentage:>3.0f} %"),
                TimeRemainingColumn(),
                console=Console(stderr=True),
                transient=True,
            )
            bar.start()
            task = bar.add_task(what, total=total)
        bar.update(task, completed=done)

    try:
        yield report
    finally:
        if bar is not None:
            bar.stop()
