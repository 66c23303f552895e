"""Cards of a replay's page: the numbers that a pilot reads first.

The distance made good is from the first fix of the last day's dives to the last fix, the
time at the surface included.  Ages and hours are those at the time of computing; the
script `clock.js` counts them on.
"""

from math import hypot

from ...base.geodesy import direction, displacement, distance
from ...base.html import safe, unbroken
from ...base.units import DAY, seconds_since_1970
from ..estimation.fix_model import PERCENT
from .surfacing import CLOCK, overdue_times
from .table_rows import (
    AGAINST,
    BASES,
    Report,
    Row,
    against,
    age,
    clock,
    compass,
    ellipse_words,
    from_now,
    half_axes,
    heading_words,
    in_degrees,
    is_outside,
    is_overdue,
    place_in,
    utc,
    velocity,
    wide,
    within,
)

FIRST, ALARM = "first", "alarm"  # styles of a card


def cards(report: Report) -> list[str]:
    """Return the cards of what `clpt replay --json` prints, with one dive at least."""
    ahead, rows = report["next_dive"], report["each_dive"]
    last = rows[-1]
    texts = [_surfacing(ahead, last), _place(ahead)]
    for leg in report["aim"][:1]:
        texts += [_aim(ahead, leg), _to_go(rows, leg)]
    texts += [_plan(ahead), _last_dive(ahead, last), _made_good(rows), _current(last)]
    if last["speed_factor"] is not None:
        texts.append(_speed_factor(rows))
    return [*texts, _position_error(last)]


def time_of_computing(report: Report) -> str:
    """Return the line on the time that hours count from."""
    ahead = report["next_dive"]
    when = unbroken(clock(ahead["now"]))
    if ahead["now_is"] != CLOCK:
        line = f"An old record: hours count from the end of its last dive, {when}."
    else:
        since = f'<span data-since="{safe(ahead["now"])}">hours count from then</span>'
        line = f"Computed {when}, {since}."
    return f'<p class="soft">{line}</p>'


def overdue_marks(ahead: Row, end: str) -> dict[str, str]:
    """Return the times by which the script knows that a vehicle is overdue."""
    late, until = overdue_times(ahead, end)
    return {"time": ahead["time"], "overdue": utc(late), "until": utc(until)}


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


def _surfacing(ahead: Row, last: Row) -> str:
    value = f"{clock(ahead['time'])} {within(ahead)}"
    below = from_now(ahead["hours_from_now"])
    if ahead["now_is"] != CLOCK:
        below = f"{below} from the {ahead['now_is']}"
        return card("Next surfacing", value, below, FIRST)
    title, style = "Next surfacing", FIRST
    if is_overdue(ahead):
        title, style = "Overdue: next surfacing", f"{FIRST} {ALARM}"
        below = f"expected {below}"
    return card(title, value, below, style, overdue_marks(ahead, last["end"]))


def _place(ahead: Row) -> str:
    where = in_degrees(ahead["latitude"], ahead["longitude"])
    texts = [where, ellipse_words(ahead), wide(ahead)]
    below = "; ".join(filter(None, texts))
    return card("Place of the next surfacing", ahead["place"], below, FIRST)


def _aim(ahead: Row, leg: Row) -> str:
    is_against = leg["state"] == AGAINST
    texts = [against(leg) if is_against else leg["state"]]
    if leg["crab"] is not None:
        texts.append(f"crab {leg['crab']:+z.0f} degrees")
    texts.append(
        f"the dive brings it {leg['made_good']:.0f} m nearer, of "
        f"{leg['through_water_full']:.0f} m through the water"
    )
    texts.append(f"expected position error {leg['expected_miss']:.0f} m")
    if half_axes(leg) != half_axes(ahead):
        texts.append(ellipse_words(leg))
    return card("Aim", heading_words(leg), "; ".join(texts), FIRST)


def _to_go(rows: list[Row], leg: Row) -> str:
    value = f"{leg['distance'] / 1000:.1f} km"
    if leg["bearing"] is not None:
        value += f" to {compass(leg['bearing'])}"
    texts = [f"waypoint {leg['place']}"]
    if leg["dives"] is not None:
        texts.append(f"there in {leg['dives']:.1f} dives, {leg['hours']:.0f} h")
    first, last, seconds = _last_day(rows)
    target = place_in(leg, "")
    before = distance(*place_in(first, "start_"), *target)
    after = distance(*place_in(last, "end_"), *target)
    nearer = (before - after) / 1000 * DAY / seconds
    hours = f"{seconds / 3600:.0f} h"
    texts.append(f"{nearer:z.1f} km per day nearer over the last {hours}")
    return card("Distance to go", value, "; ".join(texts))


def _plan(ahead: Row) -> str:
    east = ahead["dr_east"]
    north = ahead["dr_north"]
    value = f"{ahead['duration'] / 3600:.2f} h, {hypot(east, north):.0f} m"
    angle = direction(east, north)
    if angle is not None:
        value += f" to {compass(angle)}"
    below = f"through the water; {BASES[ahead['basis']]}"
    return card("Next dive", value, below)


def _last_dive(ahead: Row, last: Row) -> str:
    depth = "depth not in its file"
    if last["depth_max"] is not None:
        depth = f"{last['depth_max']:.0f} m deep"
    duration = f"{last['duration'] / 3600:.2f} h"
    title = f"Last dive, {last['dive']}"
    end = clock(last["end"])
    if ahead["now_is"] != CLOCK:
        return card(title, end, f"surfaced after {duration}; {depth}")
    hours = max(seconds_since_1970(ahead["now"]) - last["end_time"], 0.0) / 3600
    below = f"surfaced {end} after {duration}; {depth}"
    return card(title, f"{age(hours)} ago", below, marks={"end": last["end"]})


def _last_day(rows: list[Row]) -> tuple[Row, Row, float]:
    """Return the first and the last of the last dives, and the time between their ends, s.

    They are of a day at least where the record is that long.
    """
    last = rows[-1]
    since = (
        row for row in reversed(rows) if last["end_time"] - row["start_time"] >= DAY
    )
    first = next(since, rows[0])
    return first, last, float(last["end_time"] - first["start_time"])


def _made_good(rows: list[Row]) -> str:
    first, last, seconds = _last_day(rows)
    east, north = displacement(*place_in(first, "start_"), *place_in(last, "end_"))
    speed = hypot(east, north) / seconds
    value = f"{speed:.2f} m/s, {speed * DAY / 1000:.1f} km per day"
    angle = direction(east, north)
    toward = "" if angle is None else f"to {compass(angle)}; "
    below = f"{toward}fix to fix, dives {first['dive']} to {last['dive']}"
    return card(f"Speed made good, last {seconds / 3600:.0f} h", value, below)


def _current(last: Row) -> str:
    error = max(last["current_east_error"], last["current_north_error"])
    current = velocity(last["current_east"], last["current_north"])
    return card(f"Current, dive {last['dive']}", current, f"± {error:.2f} m/s")


def _speed_factor(rows: list[Row]) -> str:
    texts = ["1: as fast as its files say"]
    until = rows[-1]["end_time"] - 7 * DAY
    week_ago = next((row for row in reversed(rows) if row["end_time"] <= until), None)
    if week_ago is not None:
        texts.append(f"a week ago {_factor(week_ago)}, dive {week_ago['dive']}")
    return card("Factor on speed", _factor(rows[-1]), "; ".join(texts))


def _factor(row: Row) -> str:
    return f"{row['speed_factor']:.2f} ± {row['speed_factor_error']:.2f}"


def _position_error(last: Row) -> str:
    before = f"with the previous dive's current: {last['clpe']['previous_dive']:.0f} m"
    if is_outside(last):
        error = last["forecast"]["error"]
        off = f"{error:.0f} m off, outside its {PERCENT} ellipse"
        before += f"; the forecast before the dive was {off}"
    value = f"{last['clpe']['adaptive']:.0f} m"
    return card(f"Position error, dive {last['dive']}", value, before)
