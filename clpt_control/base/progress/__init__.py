"""Progress bars, notes and warnings on standard error.

Work of more than two seconds shows its progress: one line of a terminal, which is overwritten, or a
line every ten seconds in a log.  A line that cannot be printed is dropped and the work goes on;
control characters are escaped.
"""

import os
import re
import sys
import time
import warnings
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from datetime import timedelta
from shutil import get_terminal_size
from traceback import walk_stack
from typing import TextIO

PATIENCE = 2.0  # seconds before the first line
LOG_EVERY = 10.0  # seconds between lines without a terminal
LONGEST = 1e9  # seconds left that are printed
# clears the rest of a terminal's line and returns to its start
CLEARED = "\x1b[K\r"
CONTROLS = (
    re.compile(  # except tab and newline; with marks that reverse the direction of text
        r"[\x00-\x08\x0b-\x1f\x7f-\x9f\u061c\u200e\u200f\u2028-\u202e\u2066-\u2069]"
    )
)


@contextmanager
def progress_bar(
    title: str, total: float, counted: str = ""
) -> Iterator[Callable[[float], None]]:
    """Print percent and time left, or the number of `counted` things and their rate.

    Yield ``report(done)``, which may be called often; its first call has the number that an
    earlier run had done.

    >>> with progress_bar("running", 10, "members") as report:
    ...     report(5)
    """
    start = time.monotonic()
    terminal = sys.stderr.isatty()
    earlier = None
    printed = float("-inf")

    def report(count: float) -> None:
        nonlocal printed, earlier
        now = time.monotonic()
        if earlier is None:
            earlier = count
            if counted and count:
                note(f"{title}: {count} of {total} {counted} were there already")
        if now - start < PATIENCE or now - printed < (0.1 if terminal else LOG_EVERY):
            return
        printed = now
        rate = (count - earlier) / (now - start)
        state = (
            f"{count} of {total} {counted}"
            if counted
            else f"{100 * count / total:.0f} %"
        )
        if rate > 0:
            state += f", {rate:.4g} a second" if counted else ""
            remaining = round(min((total - count) / rate, LONGEST))
            state += f", {timedelta(seconds=remaining)} left"
        if terminal:
            tell(f"{title}: {state}"[: get_terminal_size().columns - 1], CLEARED)
        else:
            tell(f"{title}: {state}")

    try:
        yield report
    finally:
        if terminal and printed > 0:
            tell("", CLEARED)


@contextmanager
def progress_shown(
    progress: bool | Callable[[int], None] | None, members: int
) -> Iterator[Callable[[int], None]]:
    """Yield a function of the number of members done: a progress bar, the caller's, or none."""
    if progress is True:
        with progress_bar("ensemble", members, "members") as report:
            yield report
    else:
        yield progress or (lambda done: None)


def note(sentence: str) -> None:
    """Print a sentence of clpt on standard error, such as the reason for a delay."""
    tell(f"clpt: {sentence}")


def tell(line: str, end: str = "\n") -> None:
    """Print a line on standard error; drop it if that fails."""
    try:
        print(escaped(line), end=end, file=sys.stderr, flush=True)
    except (OSError, ValueError):
        discard(sys.stderr)


def escaped(text: str) -> str:
    r"""Return text with its control characters escaped, so that a terminal shows them.

    >>> escaped("a title\x1b[2J") == r"a title\x1b[2J"
    True
    """
    return CONTROLS.sub(lambda match: ascii(match[0])[1:-1], text)


def discard(stream: TextIO) -> None:
    """Redirect a broken standard stream to the null device."""
    with suppress(OSError, ValueError):
        os.dup2(os.open(os.devnull, os.O_WRONLY), stream.fileno())


def warn(sentence: str) -> None:
    """Warn at the line that called the package."""
    package, outside = __package__.partition(".")[0], 1
    for level, (frame, _) in enumerate(walk_stack(sys._getframe()), 2):
        if frame.f_globals.get("__name__", "").partition(".")[0] == package:
            outside = level
    warnings.warn(sentence, stacklevel=outside)
