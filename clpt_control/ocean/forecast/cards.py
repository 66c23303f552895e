"""Cards of a replay's page: the numbers that a pilot reads first.

The distance made good is from the first fix of the last day's dives to the last fix, the
time at the surface included.  Ages and hours are those at the time of computing; the
script `clock.js` counts them on.
"""

import re
from math import hypot
from typing import Any

from ...base.geodesy import displacement, distance
from ...base.html import safe
from ...base.units import seconds_since_1970
from . import places, wording
from .cells import ellipse_words, half_axes
from .habits import Way
from .layers import place_in
from .surfacing import CLOCK, overdue_times

Found = dict[str, Any]
FIRST, ALARM = "first", "alarm"  # styles of a card
DAY, WEEK = 86400.0, 604800.0  # s
UNBROKEN = re.compile(  # angles, times and sizes that stay on one line
    r"\d+(?: \d\d)?\.\d+ [NSEW]\b|\+- [\d.]+ \w+|\d+ x \d+ m\b|\d+ of \d+|"
    r"(?:\d{4}-)?\d\d-\d\d \d\d:\d\d"
)


def unbroken(text: str) -> str:
    """Return a text as HTML that keeps angles, times and sizes on one line.

    >>> unbroken("42 55.80 S")
    '<span class="whole">42 55.80 S</span>'
    """
    return UNBROKEN.sub(lambda one: f'<span class="whole">{one[0]}</span>', safe(text))


def cards(found: Found) -> list[str]:
    """Return the cards of what `clpt replay --json` prints, with one dive at least."""
    made = [_surfacing(found), _place(found)]
    made += [_aim(found, leg) for leg in found["aim"][:1]]
    made += [_to_go(found, leg) for leg in found["aim"][:1]]
    made += [_plan(found), _last_dive(found), _made_good(found), _current(found)]
    if found["each_dive"][-1]["speed_factor"] is not None:
        made.append(_speed_factor(found))
    made.append(_position_error(found))
    return made


def time_of_computing(found: Found) -> str:
    """Return the line on the time that hours count from."""
    ahead = found["next_dive"]
    when = unbroken(places.clock(ahead["now"]))
    if ahead["now_is"] != CLOCK:
        line = f"An old record: hours count from the end of its last dive, {when}."
    else:
        since = f'<span data-since="{safe(ahead["now"])}">hours count from then</span>'
        line = f"Computed {when}, {since}."
    return f'<p class="soft">{line}</p>'


def overdue_marks(ahead: Found, end: str) -> dict[str, str]:
    """Return the times by which the script knows that a vehicle is overdue."""
    late, until = overdue_times(ahead, end)
    return {
        "time": ahead["time"],
        "overdue": places.utc(late),
        "until": places.utc(until),
    }


def attributes(marks: dict[str, str]) -> str:
    """Return data attributes of an element."""
    return "".join(f' data-{name}="{safe(value)}"' for name, value in marks.items())


def card(
    title: str,
    value: str,
    below: str,
    style: str = "",
    marks: dict[str, str] | None = None,
) -> str:
    """Return a card; the script reads its marks."""
    return (
        f'<section class="card {style}"{attributes(marks or {})}><h2>{safe(title)}</h2>'
        f"<b>{unbroken(value)}</b><small>{unbroken(below)}</small></section>"
    )


def _surfacing(found: Found) -> str:
    ahead = found["next_dive"]
    value = f"{places.clock(ahead['time'])} {wording.within(ahead)}"
    below = wording.from_now(ahead["hours_from_now"])
    if ahead["now_is"] != CLOCK:
        below = f"{below} from the {ahead['now_is']}"
        return card("Next surfacing", value, below, FIRST)
    late = wording.is_overdue(ahead)
    title = "Overdue: next surfacing" if late else "Next surfacing"
    style = f"{FIRST} {ALARM}" if late else FIRST
    below = f"expected {below}" if late else below
    marks = overdue_marks(ahead, found["each_dive"][-1]["end"])
    return card(title, value, below, style, marks)


def _place(found: Found) -> str:
    ahead = found["next_dive"]
    where = places.in_degrees(ahead["latitude"], ahead["longitude"])
    parts = [where, ellipse_words(ahead), wording.wide(ahead)]
    below = "; ".join(filter(None, parts))
    return card("Place of the next surfacing", ahead["place"], below, FIRST)


def _aim(found: Found, leg: Found) -> str:
    parts = [leg["state"]]
    if leg["state"] == wording.AGAINST:
        current = places.velocity(leg["current_east"], leg["current_north"])
        speed = f"{leg['speed_expected']:.2f} m/s"
        parts = [f"cannot be made against the current, {current}, at {speed}"]
    if leg["crab"] is not None:
        parts.append(f"crab {leg['crab']:+z.0f} degrees")
    made, full = leg["made_good"], leg["through_water_full"]
    parts.append(
        f"the dive brings it {made:.0f} m nearer, of {full:.0f} m through the water"
    )
    parts.append(f"expected position error {leg['expected_miss']:.0f} m")
    if half_axes(leg) != half_axes(found["next_dive"]):
        parts.append(ellipse_words(leg))
    return card("Aim", wording.heading_words(leg), "; ".join(parts), FIRST)


def _to_go(found: Found, leg: Found) -> str:
    value = f"{leg['distance'] / 1000:.1f} km"
    if leg["bearing"] is not None:
        value += f" to {places.compass(leg['bearing'])}"
    parts = [f"waypoint {leg['place']}"]
    if leg["dives"] is not None:
        parts.append(f"there in {leg['dives']:.1f} dives, {leg['hours']:.0f} h")
    rows = _last_day(found["each_dive"])
    target = place_in(leg, "")
    before = distance(*place_in(rows[0], "start_"), *target)
    after = distance(*place_in(rows[-1], "end_"), *target)
    nearer = (before - after) / 1000 * DAY / _seconds(rows)
    parts.append(f"{nearer:z.1f} km per day nearer over the last {_hours(rows)}")
    return card("Distance to go", value, "; ".join(parts))


def _plan(found: Found) -> str:
    ahead = found["next_dive"]
    east, north = ahead["dr_east"], ahead["dr_north"]
    value = f"{ahead['duration'] / 3600:.2f} h, {hypot(east, north):.0f} m"
    angle = places.direction(east, north)
    if angle is not None:
        value += f" to {places.compass(angle)}"
    below = f"through the water; {wording.BASES[ahead['basis']]}"
    return card("Next dive", value, below)


def _last_dive(found: Found) -> str:
    last, ahead = found["each_dive"][-1], found["next_dive"]
    depth = "depth not in its file"
    if last["depth_max"] is not None:
        depth = f"{last['depth_max']:.0f} m deep"
    duration = f"{last['duration'] / 3600:.2f} h"
    title, end = f"Last dive, {last['dive']}", places.clock(last["end"])
    if ahead["now_is"] != CLOCK:
        return card(title, end, f"surfaced after {duration}; {depth}")
    hours = _age_hours(found)
    below = f"surfaced {end} after {duration}; {depth}"
    return card(title, f"{wording.age(hours)} ago", below, marks={"end": last["end"]})


def _age_hours(found: Found) -> float:
    """Return the age of the last dive at the time of computing, hours."""
    ahead, last = found["next_dive"], found["each_dive"][-1]
    now = seconds_since_1970(ahead["now"])
    return max(now - last["end_time"], 0.0) / 3600


def _last_day(rows: list[Found]) -> list[Found]:
    """Return the last dives, of a day at least where the record is that long."""
    first = len(rows) - 1
    while first > 0 and rows[-1]["end_time"] - rows[first]["start_time"] < DAY:
        first -= 1
    return rows[first:]


def _seconds(rows: list[Found]) -> float:
    """Return the time from the first start to the last end, s."""
    return float(rows[-1]["end_time"] - rows[0]["start_time"])


def _hours(rows: list[Found]) -> str:
    return f"{_seconds(rows) / 3600:.0f} h"


def made_good(rows: list[Found]) -> Way:
    """Return the way made good of about a day: straight, from fix to fix."""
    rows = _last_day(rows)
    ends = place_in(rows[0], "start_"), place_in(rows[-1], "end_")
    return Way(*displacement(*ends[0], *ends[1]), _seconds(rows))


def _made_good(found: Found) -> str:
    rows = _last_day(found["each_dive"])
    way = made_good(rows)
    speed = hypot(way.east, way.north) / way.seconds
    value = f"{speed:.2f} m/s, {speed * DAY / 1000:.1f} km per day"
    angle = places.direction(way.east, way.north)
    toward = "" if angle is None else f"to {places.compass(angle)}; "
    below = f"{toward}fix to fix, dives {rows[0]['dive']} to {rows[-1]['dive']}"
    return card(f"Speed made good, last {_hours(rows)}", value, below)


def _current(found: Found) -> str:
    last = found["each_dive"][-1]
    error = max(last["current_east_error"], last["current_north_error"])
    current = places.velocity(last["current_east"], last["current_north"])
    return card(f"Current, dive {last['dive']}", current, f"+- {error:.2f} m/s")


def _speed_factor(found: Found) -> str:
    rows = found["each_dive"]
    parts = ["1: as fast as its files say"]
    week_ago = _week_ago(rows)
    if week_ago is not None:
        parts.append(f"a week ago {_factor(week_ago)}, dive {week_ago['dive']}")
    return card("Factor on speed", _factor(rows[-1]), "; ".join(parts))


def _factor(row: Found) -> str:
    return f"{row['speed_factor']:.2f} +- {row['speed_factor_error']:.2f}"


def _week_ago(rows: list[Found]) -> Found | None:
    """Return the last dive that ended a week before the last one, None of a shorter record."""
    until = rows[-1]["end_time"] - WEEK
    return next((row for row in reversed(rows) if row["end_time"] <= until), None)


def _position_error(found: Found) -> str:
    last = found["each_dive"][-1]
    before = f"with the previous dive's current: {last['clpe']['previous_dive']:.0f} m"
    if not last["inside_90"]:
        before += "; outside the 90 % ellipse"
    value = f"{last['clpe']['adaptive']:.0f} m"
    return card(f"Position error, dive {last['dive']}", value, before)
