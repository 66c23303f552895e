"""Fleet: a row for each vehicle, events that need a pilot, and the command that alerts.

Each row is made of what `clpt replay --json` prints of a vehicle, at a time, now.  It asks for a
pilot where

    overdue         now is past the time of the next surfacing by more than its half width
    OUT             two dives running, at least, surfaced outside their ellipses
    cannot be read  there is no replay, for a reason that the row says

in this order, which is that of the rows; then come those that surface next.  A record that ended
more than 30 days ago (`surfacing.RECENT`) is not overdue, and comes last.

A command of the user's own is run when something asks for a pilot.  It is run without a shell.
`{}` in its words is the sentence; its standard input has the sentence on the first line, and on the
second one JSON object: id, vehicle, event, dive, fix, sentence, next_dive.  The id of an event is
vehicle, kind and the time of the fix after its dive, because dive numbers begin again when a
vehicle is redeployed and some files give all their dives one number.  The command is run for each
event until it ends well; then the event's id goes into a file beside the results.  So none is lost:
a command that was killed between the two is run again, with the same id.  A command that fails or
lasts too long is one sentence.
"""

import json
import shlex
import shutil
import subprocess
import time
from collections.abc import Sequence
from contextlib import suppress
from itertools import takewhile
from pathlib import Path
from typing import Any, NamedTuple
from urllib.parse import quote

from ...base.errors import DataError, ScenarioError
from ...base.files import write_file
from ...base.files.reading import read_text
from ...base.html import safe
from ...base.page import Page, Section
from ...base.progress import tell
from ...base.units import seconds_since_1970
from ..estimation.fix_model import PERCENT
from .cards import attributes, overdue_marks
from .replay_page import AGAIN, ranked_table
from .surfacing import RECENT, overdue_times
from .table_rows import (
    Columns,
    Report,
    Row,
    age,
    cells,
    clock,
    date,
    half_axes,
    in_minutes,
    is_outside,
    within,
)

OVERDUE, OUT, UNREAD = "overdue", "OUT", "cannot be read"
ORDER = (OVERDUE, OUT, UNREAD)


class Event(NamedTuple):
    """A reason to call a pilot: its kind, the dive that began it, the fix after, a sentence.

    The fix is its time, ISO 8601.
    """

    name: str
    dive: int
    fix: str
    sentence: str


def events(report: Report, now: float) -> list[Event]:
    """Return what asks for a pilot, s since 1970, of what `--json` prints of a vehicle."""
    rows = report["each_dive"]
    ahead = report["next_dive"]
    happened = []
    last = rows[-1]
    late, until = overdue_times(ahead, last["end"])
    if late < now <= until:
        why = _overdue(last["dive"], ahead)
        happened.append(Event(OVERDUE, last["dive"], last["end"], why))
    if (running := _running(rows)) > 1:
        first_row = rows[-running]
        since = f"{running} dives running, since dive {first_row['dive']}"
        why = f"{OUT}: {since}, outside their {PERCENT} ellipses"
        happened.append(Event(OUT, first_row["dive"], first_row["end"], why))
    return happened


def _overdue(last: int, ahead: Row) -> str:
    """Return the sentence on a vehicle that is overdue after its last dive."""
    expected = f"{clock(ahead['time'])} {within(ahead)}"
    return f"{OVERDUE} after dive {last}: should have surfaced at {expected}"


def standing(report: Report, page: str, now: float) -> Row:
    """Return a row of the fleet, for JSON; `page` is where the vehicle's own page is."""
    asks = events(report, now)
    last = report["each_dive"][-1]
    return {
        "vehicle": report["vehicle"],
        "kind": report["kind"],
        "page": page,
        "asks": [event.name for event in asks],
        "said": [event.sentence for event in asks],
        "dive": last["dive"],
        "time": last["end"],
        "latitude": last["end_latitude"],
        "longitude": last["end_longitude"],
        "age_hours": (now - seconds_since_1970(last["end"])) / 3600,
        "next_dive": report["next_dive"],
        "headlines": report["forecast"],
        "out_running": _running(report["each_dive"]),
    }


def unread(vehicle: str, why: str) -> Row:
    """Return the row of a vehicle without a replay."""
    return {
        "vehicle": vehicle,
        "page": None,
        "asks": [UNREAD],
        "said": [f"{UNREAD}: {why}"],
    }


def ordered(rows: list[Row]) -> list[Row]:
    """Return rows, what asks for a pilot first, then by the time of the next surfacing."""

    def sort_key(row: Row) -> tuple[int, bool, str]:
        rank = min(map(ORDER.index, row["asks"]), default=len(ORDER))
        if "dive" not in row:
            return rank, False, ""
        return rank, 3600 * row["age_hours"] > RECENT, row["next_dive"]["time"]

    return sorted(rows, key=sort_key)


def _out(running: int) -> str:
    return f"{OUT} x{running}" if running > 1 else OUT if running else "in"


def _record(headlines: Row) -> str:
    count = headlines["judged"]
    return f"{headlines['inside']} of {count}" if count else "-"


FLEET: Columns = {
    "vehicle": (0, lambda row: row["vehicle"]),
    "last fix (UTC)": (3, lambda row: f"{row['time'][:4]}-{date(row['time'])}"),
    "age": (0, lambda row: age(row["age_hours"])),
    "position": (5, lambda row: in_minutes(row["latitude"], row["longitude"])),
    "next (UTC)": (
        1,
        lambda row: f"{date(row['next_dive']['time'])} {within(row['next_dive'])}",
    ),
    "half axes (m)": (4, lambda row: half_axes(row["next_dive"])),
    f"{PERCENT} so far": (2, lambda row: _record(row["headlines"])),
    PERCENT: (0, lambda row: _out(row["out_running"])),
    "pilot": (0, lambda row: ", ".join(row["asks"])),
}


def fleet_cells(row: Row) -> dict[str, str]:
    """Return the cells of a row by the titles of their columns."""
    if "dive" in row:
        return cells(row, FLEET)
    return {
        **dict.fromkeys(FLEET, ""),
        "vehicle": row["vehicle"],
        "pilot": ", ".join(row["asks"]),
    }


def fleet_page(fleet: Report) -> Page:
    """Return the page of a fleet, which links the page of each vehicle."""
    rows = fleet["vehicles"]
    cells_of_rows = [
        fleet_cells(row) | {"pilot": "; ".join(row["said"])} for row in rows
    ]
    pages = [row["page"] and quote(row["page"]) for row in rows]
    title = "Those that need a pilot first"
    times = [*map(_times, rows)]
    vehicles = ranked_table(title, cells_of_rows, FLEET, times, pages)
    since = f'<span data-since="{safe(fleet["now"])}">ages are of then</span>'
    sentence = fleet_sentence(rows)
    return Page(
        "Replay of the dives of several vehicles",
        f"Fleet, {clock(fleet['now'])}",
        [sentence],
        [],
        [Section("vehicles", "Vehicles", vehicles)],
        f"<p>{since}: {sentence}.</p>",
        ("clock.js",),
        AGAIN,
    )


def _times(row: Row) -> str:
    """Return the times and the sentence of a row by which the script counts on."""
    if "dive" not in row:
        return ""
    ahead = row["next_dive"]
    words = {"end": row["time"], "words": _overdue(row["dive"], ahead)}
    return attributes(overdue_marks(ahead, row["time"]) | words)


def fleet_sentence(rows: list[Row]) -> str:
    """Return how many vehicles there are, and how many need a pilot."""
    asks = sum(bool(row["asks"]) for row in rows)
    verb = "needs" if asks == 1 else "need"
    return f"{len(rows)} vehicle{'s'[: len(rows) != 1]}, {asks} {verb} a pilot"


def _running(rows: list[Row]) -> int:
    """Return how many dives in a row, up to the last one, came up outside their ellipses."""
    return len(list(takewhile(is_outside, reversed(rows))))


LONGEST = 60.0  # s that a command may take
TOLD = ".clpt-told"  # in the folder of results


def checked_command(text: str) -> list[str]:
    """Return the words of a command, or refuse what cannot be run."""
    words = []
    with suppress(ValueError):  # a quotation without its end
        words = shlex.split(text)
    if not words or shutil.which(words[0]) is None:
        raise ScenarioError(f"--alert {text}: command not found. Give an executable")
    return words


def plain_argument(sentence: str) -> str:
    """Return a sentence that a command cannot take for an option.

    A vehicle without a name in its files has that of its folder.

    >>> plain_argument("-rf: overdue after dive 8"), plain_argument("SG171: OUT")
    ('vehicle -rf: overdue after dive 8', 'SG171: OUT')
    """
    begins_well = sentence[:1].isalnum() or sentence[:1] == "_"
    return sentence if begins_well else f"vehicle {sentence}"


class Alerts:
    """Runs a command, or none, for each new event; `out` has those that were told."""

    def __init__(self, command: Sequence[str], out: Path):
        self.command = list(command)
        self.path = out / TOLD
        self.told: list[str] = []
        self.failed: set[str] = set()
        with suppress(DataError, ValueError):
            # none yet, or none that can be read: told again
            keys = json.loads(read_text(self.path, "is not text"))
            self.told = [str(key) for key in keys] if isinstance(keys, list) else []

    def tell(self, report: Report) -> None:
        """Run the command for what is new in what `--json` prints of a vehicle."""
        if not (self.command and report["each_dive"]):
            return
        vehicle = report["vehicle"]
        for event in events(report, time.time()):
            key = f"{vehicle} {event.name} {event.fix}"
            if key in self.told:
                continue
            sentence = plain_argument(f"{vehicle}: {event.sentence}")
            data = {
                "id": key,
                "vehicle": vehicle,
                "event": event.name,
                "dive": event.dive,
                "fix": event.fix,
                "sentence": sentence,
                "next_dive": report["next_dive"],
            }
            why = self._run(sentence, json.dumps(data))
            if not why:
                self.told.append(key)
                write_file(self.path, json.dumps(self.told))
            elif why not in self.failed:
                self.failed.add(why)
                tell(
                    f"--alert {shlex.join(self.command)}: {why}; is run again at the next look"
                )

    def _run(self, sentence: str, data: str) -> str:
        """Run the command; return why it failed, empty where it did not."""
        words = [sentence if word == "{}" else word for word in self.command]
        text = f"{sentence}\n{data}\n".encode()
        quiet: Any = dict.fromkeys(("stdout", "stderr"), subprocess.DEVNULL)
        try:
            process = subprocess.run(
                words, input=text, timeout=LONGEST, check=False, **quiet
            )
        except subprocess.TimeoutExpired:
            return f"takes longer than {LONGEST:g} s"
        except (
            OSError,
            UnicodeError,
        ) as error:  # a name may not be in the locale's letters
            return f"cannot be run: {getattr(error, 'strerror', None) or error}"
        return f"ended with status {process.returncode}" if process.returncode else ""
