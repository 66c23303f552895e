"""How the vehicles of a fleet stand, and what asks for a pilot.

Each row is made of what `clpt replay --json` prints of a vehicle, at a time, now.  It asks for a
pilot where

    overdue         now is past the headline's time by more than the 90 % of that time
    OUT             two dives running, at least, came up outside their 90 % ellipses
    SPEED           the speed changed within the last `SETTLED` dives
    cannot be read  there is no replay, for a reason that the row says

in this order, which is that of the rows; then come those that surface next.  A record that ended
long ago (`surfacing.RECENT`) is not overdue, and comes last.
"""

from datetime import datetime
from itertools import takewhile
from typing import Any, NamedTuple

from ..html import document, paragraphs
from .doubts import SETTLED, Anomaly
from .page import cell_table
from .sentences import date, within
from .surfacing import RECENT
from .wording import clock, in_minutes

OVERDUE, OUT, SPEED, UNREAD = "overdue", "OUT", "SPEED", "cannot be read"
ORDER = (OVERDUE, OUT, SPEED, UNREAD)
SOON = 48.0  # hours that are not said in days
FLEET = {  # title of a column: its rank
    "vehicle": 0,
    "last fix (UTC)": 3,
    "age": 0,
    "at": 5,
    "next (UTC)": 1,
    "90 % within (m)": 4,
    "held": 2,
    "90 %": 0,
    "mark": 0,
    "pilot": 0,
}


class Event(NamedTuple):
    """What asks for a pilot: its name, the dive from which on it does, and a sentence."""

    name: str
    dive: int
    said: str


def events(found: dict[str, Any], now: float) -> list[Event]:
    """Return what asks for a pilot, s since 1970, of what `--json` prints of a vehicle."""
    each, ahead = found["each_dive"], found["next_dive"]
    happened = []
    last, late = each[-1]["dive"], now - _seconds(ahead["time"])
    if late > ahead["time_90"] and now - _seconds(each[-1]["end"]) <= RECENT:
        said = f"after dive {last}: should have come up at {clock(ahead['time'])} {within(ahead)}"
        happened.append(Event(OVERDUE, last, f"{OVERDUE} {said}"))
    if (running := _running(each)) > 1:
        since = each[-running]["dive"]
        said = f"{OUT}: {running} dives running, since dive {since}, outside their 90 % ellipses"
        happened.append(Event(OUT, since, said))
    if anomaly := _anomaly(each):
        happened.append(Event(SPEED, anomaly["dive"], f"{SPEED}: {Anomaly(**anomaly)}"))
    return happened


def standing(found: dict[str, Any], page: str, now: float) -> dict[str, Any]:
    """Return a row of the fleet, for JSON; `page` is where the vehicle's own page is."""
    asks, last = events(found, now), found["each_dive"][-1]
    return {
        "vehicle": found["vehicle"],
        "kind": found["kind"],
        "page": page,
        "asks": [event.name for event in asks],
        "said": [event.said for event in asks],
        "dive": last["dive"],
        "time": last["end"],
        "latitude": last["end_latitude"],
        "longitude": last["end_longitude"],
        "age_hours": (now - _seconds(last["end"])) / 3600,
        "next_dive": found["next_dive"],
        "headlines": found["headlines"],
        "out_running": _running(found["each_dive"]),
        "anomaly": _anomaly(found["each_dive"]),
    }


def unread(vehicle: str, why: str) -> dict[str, Any]:
    """Return the row of a vehicle without a replay."""
    return {"vehicle": vehicle, "page": None, "asks": [UNREAD], "said": [f"{UNREAD}: {why}"]}


def ordered(rows: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """Return rows, what asks for a pilot first, then by the time of the next surfacing."""

    def place(row: dict[str, Any]) -> tuple[int, bool, str]:
        first = min(map(ORDER.index, row["asks"]), default=len(ORDER))
        if "dive" not in row:
            return first, False, ""
        return first, 3600 * row["age_hours"] > RECENT, row["next_dive"]["time"]

    return sorted(rows, key=place)


def fleet_cells(row: dict[str, Any]) -> dict[str, str]:
    """Return the cells of a row by the titles of their columns."""
    cells = dict.fromkeys(FLEET, "")
    cells |= {"vehicle": row["vehicle"], "pilot": ", ".join(row["asks"])}
    if "dive" not in row:
        return cells
    ahead, anomaly, running = row["next_dive"], row["anomaly"], row["out_running"]
    hours, judged = row["age_hours"], row["headlines"]["judged"]
    return cells | {
        "last fix (UTC)": date(row["time"]),
        "age": f"{hours:.1f} h" if hours < SOON else f"{hours / 24:.0f} d",
        "at": in_minutes(row["latitude"], row["longitude"]),
        "next (UTC)": f"{date(ahead['time'])} {within(ahead)}",
        "90 % within (m)": f"{ahead['ellipse_90_long']:.0f} x {ahead['ellipse_90_short']:.0f}",
        "held": f"{row['headlines']['place_held']} of {judged}" if judged else "-",
        "90 %": f"{OUT} x{running}" if running > 1 else OUT if running else "in",
        "mark": "" if anomaly is None else SPEED if anomaly["certain"] else f"{SPEED}?",
    }


def fleet_page(found: dict[str, Any]) -> str:
    """Return the fleet as one HTML file, which links the page of each vehicle."""
    rows = found["vehicles"]
    cells = [fleet_cells(row) | {"pilot": "; ".join(row["said"])} for row in rows]
    pages = [row["page"] for row in rows]
    body = "\n".join(
        [
            "<h1>Fleet</h1>",
            paragraphs([f"{fleet_sentence(rows)}. Written {clock(found['now'])}."]),
            '<div class="fleet">',
            *cell_table("What asks for a pilot first", cells, FLEET, (), pages),
            "</div>",
        ]
    )
    again = '<meta http-equiv="refresh" content="60">\n'
    return document(f"Fleet, {clock(found['now'])}", body, "replay.css", head=again)


def fleet_sentence(rows: list[dict[str, Any]]) -> str:
    """Return how many vehicles there are, and how many ask for a pilot."""
    asks = sum(bool(row["asks"]) for row in rows)
    return f"{len(rows)} vehicle{'s'[: len(rows) != 1]}, {asks} asking for a pilot"


def _running(each: list[dict[str, Any]]) -> int:
    """Return how many dives in a row, up to the last one, came up outside their ellipses."""
    return len(list(takewhile(lambda row: not row["inside_90"], reversed(each))))


def _anomaly(each: list[dict[str, Any]]) -> dict[str, Any] | None:
    """Return the last anomaly of the speed among the last dives."""
    return next((row["anomaly"] for row in each[: -SETTLED - 1 : -1] if row["anomaly"]), None)


def _seconds(time: str) -> float:
    return datetime.fromisoformat(time).timestamp()
