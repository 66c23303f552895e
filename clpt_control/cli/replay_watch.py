"""`clpt replay --follow`: a folder, watched for new files of dives."""

import time
from collections.abc import Callable, Sequence
from math import isfinite
from pathlib import Path
from typing import Any

import typer

from ..progress import interrupt
from .replay_report import RESULTS, Ahead, write

LONGEST = 86400.0  # s between looks
Take = Callable[[Any, Any], tuple[Any, list]]  # dives and what was unread -> replay, skipped


def check_pace(every: float, patience: float) -> None:
    """Refuse times (s) between looks, or without a new file, that cannot be."""
    from ..errors import ScenarioError

    if not (isfinite(every) and 0 < every <= LONGEST):
        raise ScenarioError(
            f"--every {every:g} s: must be above 0 s and at most {LONGEST:g} s, a day"
        )
    if not patience >= 0:
        raise ScenarioError(f"--patience {patience:g} s: must be 0 s or more")


def watch(
    take: Take,
    folder: Path,
    out: Path,
    ahead: Ahead,
    kinds: Sequence[str],
    every: float,
    patience: float,
) -> tuple[Any, list]:
    """Replay all dives of a folder whenever a file arrives; return the last replay.

    Times are in s.  Ctrl-C or SIGTERM ends it: while it waits, with the last replay; while
    it learns, by a `KeyboardInterrupt`, as no replay has all dives yet.
    """
    from ..files import remove_left
    from ..replay.follow import following

    with interrupt.terminated(), following(folder, out) as follower:
        remove_left(out, *RESULTS)
        found: tuple[Any, list] | None = None  # None while results are not those of all files
        since = time.monotonic()
        try:
            while True:
                before = follower.here
                arrived = follower.look()
                if arrived or follower.here != before or found is None:
                    found = None
                    learned = take(*follower.dives())
                    line = said_of(*learned, len(arrived), out, ahead, kinds)
                    found = learned  # from where the line is seen, an interrupt has its results
                    typer.echo(line, err=True)
                    if arrived:
                        since = time.monotonic()
                left = since + patience - time.monotonic()
                if left <= 0:
                    return found
                interrupt.wait(min(every, left))
        except KeyboardInterrupt:  # the user's way to end it
            if found is None:
                raise
            interrupt.answer()
            return found


def said_of(
    replay: Any, skipped: list, files: int, out: Path, ahead: Ahead, kinds: Sequence[str]
) -> str:
    """Write a replay's results; return a line on the new files and the last dive."""
    from ..replay.sentences import aimed, when
    from ..replay.wording import place

    used = len(replay.steps)
    line = f"{files} new file{'s'[: files != 1]}, {used} dive{'s'[: used != 1]} used"
    if not used:
        return line
    write(replay, skipped, out, ahead, kinds, again=True)
    step, goal = replay.steps[-1], ahead.next_dive(replay).as_dict()
    legs = ahead.aims(replay)
    return (
        f"{line}; dive {step.dive.number}: miss {step.clpe['adaptive']:.0f} m"
        + (f"; speed anomaly: {step.anomaly}" if step.anomaly else "")
        + f"; next surfacing {when(goal)}, near {place(goal['latitude'], goal['longitude'])}"
        + (f"; {aimed(legs[0].as_dict())}" if legs else "")
    )
