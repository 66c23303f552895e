"""A progress bar on standard error, for work that lasts over two seconds."""

import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager

PATIENCE = 2.0  # seconds before the bar appears


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
    bar = task = None
    shown = 0.0

    def report(done: float) -> None:
        nonlocal bar, task, shown
        now = time.monotonic()
        if now - start < PATIENCE or now - shown < 0.1:
            return
        shown = now
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
