"""`clpt replay --follow`: a folder, watched for new files of dives."""

import time
from math import isfinite
from pathlib import Path
from typing import Any

import typer

from ..progress import interrupt
from .replay_results import RESULT, advance, write
from .replay_table import place

LONGEST = 86400.0  # s between looks


def check_pace(every: float, patience: float) -> None:
    """Refuse times between looks and before the end that cannot be.

    Parameters
    ----------
    every, patience : float
        As `watch` takes them, s.

    Raises
    ------
    ScenarioError
        If one is not a time.
    """
    from ..errors import ScenarioError

    if not (isfinite(every) and 0 < every <= LONGEST):
        raise ScenarioError(
            f"--every {every:g} s: must be above 0 s and at most {LONGEST:g} s, a day"
        )
    if not patience >= 0:
        raise ScenarioError(f"--patience {patience:g} s: must be 0 s or more")


def watch(
    session: Any, folder: Path, out: Path, ahead: tuple, every: float, patience: float
) -> None:
    """Replay a folder on whenever a file arrives.

    An interrupt or SIGTERM ends it: in the usual way while it waits, as a
    `KeyboardInterrupt` while it learns, when there is no result yet to end with.

    Parameters
    ----------
    session : Session
        That has taken no dive.
    folder, out : Path
        Where files arrive; where results and the folder ``state`` lie.
    ahead : tuple
        Plan of the next dive: duration, s, and way, m; empty is the last one's.
    every, patience : float
        Time between looks, and without a new file before the end, s.

    Raises
    ------
    DataError
        If another process follows there, or a folder cannot be read or written.
    """
    from ..files import remove_left
    from ..replay.follow import Follower
    from ..replay.follow_alone import alone, check_folders

    check_folders(folder, out)
    with interrupt.terminated(), alone(out / "state") as state:
        remove_left(state, "*.json")
        remove_left(out, RESULT, "map.png", "clpe.png", "current.png")
        follower = Follower(folder, state)
        settled = False  # whether results are those of all files read
        said: set[str] = set()
        since = time.monotonic()
        try:
            while True:
                before = follower.here
                arrived = follower.look()
                if arrived or follower.here != before or not settled:
                    settled = False
                    session.take(*follower.dives())
                    line = learn(session, out, ahead, len(arrived), said)
                    settled = True  # from where the line is seen, an interrupt has its results
                    typer.echo(line, err=True)
                    if arrived:
                        since = time.monotonic()
                left = since + patience - time.monotonic()
                if left <= 0:
                    return
                interrupt.wait(min(every, left))
        except KeyboardInterrupt:  # the user's way to end it
            if not settled:
                raise
            interrupt.answer()


def learn(session: Any, out: Path, ahead: tuple, arrived: int, said: set[str]) -> str:
    """Replay what a session has taken and write it.

    Parameters
    ----------
    session : Session
        That has taken all dives so far.
    out : Path
        Where results lie.
    ahead : tuple
        Plan of the next dive.
    arrived : int
        Number of files that are new.
    said : set of str
        Complaints so far: each is said once.

    Returns
    -------
    str
        What was learned, on a line.
    """
    from ..errors import DataError
    from ..replay.session import check_tides
    from ..replay.surfacing import next_dive

    try:
        check_tides(session.replay.model.flow, session.used)
    except DataError as error:
        if not said:  # the record grows
            said.add(f"so far, {error}")
            typer.echo(f"so far, {error}", err=True)
    advance(session)
    used = len(session.used)
    line = f"{arrived} new file{'s'[: arrived != 1]}, {used} dive{'s'[: used != 1]} used"
    if used:
        write(session.replay, out, ahead)
        step, goal = session.replay.steps[-1], next_dive(session.replay, *ahead)
        line += (
            f"; dive {step.dive.number}: CLPE {step.clpe['adaptive']:.0f} m"
            + (f"; speed anomaly: {step.anomaly}" if step.anomaly else "")
            + f"; next surfacing near {place(goal.latitude, goal.longitude)}"
        )
    return line
