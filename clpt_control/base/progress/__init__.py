"""The progress of work that lasts over two seconds, on standard error.

One line on a terminal, written anew; a line now and then elsewhere; a note on what happens once.
A line that cannot be printed is dropped and the work goes on; control characters are escaped.
"""

import os
import re
import sys
import time
import warnings
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from shutil import get_terminal_size
from traceback import walk_stack
from typing import TextIO

PATIENCE = 2.0  # seconds before the first line
LOG_EVERY = 10.0  # seconds between lines where there is no terminal
# the rest of a terminal's line goes, and the next is written over it
CLEARED = "\x1b[K\r"
CONTROLS = (
    re.compile(  # all but tab and newline, and marks that reverse the direction of text
        r"[\x00-\x08\x0b-\x1f\x7f-\x9f\u061c\u200e\u200f\u2028-\u202e\u2066-\u2069]"
    )
)


@contextmanager
def progress_bar(
    what: str, total: float, counted: str = ""
) -> Iterator[Callable[[float], None]]:
    """Print percent and time left, or, where things are counted, how many a second.

    Yield ``report(done)``, to be called as often as you like; its first call tells how much
    an earlier run had done.

    >>> with progress_bar("running", 10, "members") as report:
    ...     report(5)
    """
    start = time.monotonic()
    terminal = sys.stderr.isatty()
    earlier = None
    printed = float("-inf")

    def report(done: float) -> None:
        nonlocal printed, earlier
        now = time.monotonic()
        if earlier is None:
            earlier = done
            if counted and done:
                note(f"{what}: {done} of {total} {counted} were there already")
        if now - start < PATIENCE or now - printed < (0.1 if terminal else LOG_EVERY):
            return
        printed = now
        rate = (done - earlier) / (now - start)
        state = (
            f"{done} of {total} {counted}" if counted else f"{100 * done / total:.0f} %"
        )
        if rate > 0:
            state += f", {rate:.4g} a second" if counted else ""
            state += f", {clock((total - done) / rate)} left"
        if terminal:
            tell(f"{what}: {state}"[: get_terminal_size().columns - 1], CLEARED)
        else:
            tell(f"{what}: {state}")

    try:
        yield report
    finally:
        if terminal and printed > 0:
            tell("", CLEARED)


@contextmanager
def progress_shown(
    progress: bool | Callable[[int], None] | None, title: str, members: int
) -> Iterator[Callable[[int], None]]:
    """Yield a function of the number of members done: a progress bar, the caller's, or none."""
    if progress is True:
        with progress_bar(title, members, "members") as report:
            yield report
    else:
        yield progress or (lambda done: None)


def note(sentence: str) -> None:
    """Print a sentence of clpt on standard error, such as why work takes longer than usual."""
    tell(f"clpt: {sentence}")


def tell(line: str, end: str = "\n") -> None:
    """Print a line on standard error; drop it where that fails."""
    try:
        print(escaped(line), end=end, file=sys.stderr, flush=True)
    except (OSError, ValueError):
        discard(sys.stderr)


def escaped(text: str) -> str:
    r"""Return text with its control characters escaped, so that a terminal shows them.

    >>> escaped("a title\x1b[2J") == r"a title\x1b[2J"
    True
    """
    return CONTROLS.sub(lambda found: ascii(found[0])[1:-1], text)


def discard(stream: TextIO) -> None:
    """Send the rest of a standard stream that takes no more to nowhere."""
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
