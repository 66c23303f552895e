"""How far work that lasts over two seconds has come, on standard error.

A bar on a terminal, a plain line now and then elsewhere; a note on what happens once.
What is told goes on where nobody hears it, and steers no terminal.
"""

import os
import re
import sys
import time
import warnings
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from traceback import walk_stack
from typing import TextIO

PATIENCE = 2.0  # seconds before the bar appears
LOG_EVERY = 10.0  # seconds between lines where there is no terminal
STEERS = re.compile(  # a terminal: controls but tab and newline, marks that turn text around
    r"[\x00-\x08\x0b-\x1f\x7f-\x9f\u061c\u200e\u200f\u2028-\u202e\u2066-\u2069]"
)


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
            if counted and done:
                note(f"{what}: {done} of {total} {counted} were there already")
        if now - start < PATIENCE or now - shown < (0.1 if terminal else LOG_EVERY):
            return
        shown = now
        rate = (done - before) / (now - start)
        state = f"{done} of {total} {counted}" if counted else f"{100 * done / total:.0f} %"
        if rate > 0:
            state += f", {rate:.4g} a second" if counted else ""
            state += f", {clock((total - done) / rate)} left"
        if not terminal:
            tell(f"{what}: {state}")
            return
        if bar is None:
            from rich.console import Console
            from rich.progress import BarColumn, Progress, TextColumn

            name = TextColumn("{task.fields[what]}", markup=False)
            columns = (name, BarColumn(), TextColumn("{task.description}", markup=False))
            bar = Progress(*columns, console=Console(stderr=True), transient=True)
            bar.start()
            task = bar.add_task(state, total=total, what=plain(what))
        bar.update(task, completed=done, description=state)

    try:
        yield report
    finally:
        if bar is not None:
            bar.stop()


def note(sentence: str) -> None:
    """Print a line on standard error: why what follows takes longer than usual."""
    tell(f"clpt: {sentence}")


def tell(line: str) -> None:
    """Print a line on standard error; where that cannot be, go on without."""
    try:
        print(plain(line), file=sys.stderr, flush=True)
    except (OSError, ValueError):
        let_go(sys.stderr)


def plain(text: str) -> str:
    r"""Return text whose controls a terminal shows, and does not obey.

    >>> plain("a title\x1b[2J") == r"a title\x1b[2J"
    True
    """
    return STEERS.sub(lambda found: ascii(found[0])[1:-1], text)


def let_go(stream: TextIO) -> None:
    """Drop what is left for a standard stream that takes no more."""
    with suppress(OSError, ValueError):
        os.dup2(os.open(os.devnull, os.O_WRONLY), stream.fileno())


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
