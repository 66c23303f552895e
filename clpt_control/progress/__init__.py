"""How far work that lasts over two seconds has come, on standard error.

A bar on a terminal, a plain line now and then elsewhere; a note on what happens once.
"""

import sys
import time
import warnings
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from traceback import walk_stack

PATIENCE = 2.0  # seconds before the bar appears
LOG_EVERY = 10.0  # seconds between lines where there is no terminal


@contextmanager
def progress_bar(what: str, total: float, counted: str = "") -> Iterator[Callable[[float], None]]:
    """Show percent and time left, or, where things are counted, how many a second.

    Yield ``report(done)``, to be called as often as you like; its first call says what
    was done before.

    >>> with progress_bar("running", 10, "members") as report:
    ...     report(5)
    """
    start = time.monotonic()
    terminal = sys.stderr.isatty()
    bar = task = before = None
    shown = float("-inf")

    def report(done: float) -> None:
        nonlocal bar, task, shown, before
        now = time.monotonic()
        if before is None:
            before = done
        if now - start < PATIENCE or now - shown < (0.1 if terminal else LOG_EVERY):
            return
        shown = now
        rate = (done - before) / (now - start)
        state = f"{done} of {total} {counted}" if counted else f"{100 * done / total:.0f} %"
        if rate > 0:
            state += f", {rate:.4g} a second" if counted else ""
            state += f", {clock((total - done) / rate)} left"
        if not terminal:
            print(f"{what}: {state}", file=sys.stderr, flush=True)
            return
        if bar is None:
            from rich.console import Console
            from rich.progress import BarColumn, Progress, TextColumn

            plain = TextColumn("{task.fields[what]}", markup=False)
            columns = (plain, BarColumn(), TextColumn("{task.description}", markup=False))
            bar = Progress(*columns, console=Console(stderr=True), transient=True)
            bar.start()
            task = bar.add_task(state, total=total, what=what)
        bar.update(task, completed=done, description=state)

    try:
        yield report
    finally:
        if bar is not None:
            bar.stop()


def note(sentence: str) -> None:
    """Print a line on standard error: why what follows takes longer than usual."""
    print(f"clpt: {sentence}", file=sys.stderr, flush=True)


def warn(sentence: str) -> None:
    """Warn at the line that called the package."""
    package, outside = __package__.partition(".")[0], 1
    for level, (frame, _) in enumerate(walk_stack(sys._getframe()), 2):
        if frame.f_globals.get("__name__", "").partition(".")[0] == package:
            outside = level
    warnings.warn(sentence, stacklevel=outside)


def clock(seconds: float) -> str:
    """Return seconds as a clock shows them.

    >>> clock(200.0), clock(7265.0)
    ('3:20', '2:01:05')
    """
    minutes, rest = divmod(round(seconds), 60)
    hours, minutes = divmod(minutes, 60)
    return f"{hours}:{minutes:02d}:{rest:02d}" if hours else f"{minutes}:{rest:02d}"
