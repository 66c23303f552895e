"""Rows of a replay: what `clpt replay --json` prints of a dive, the next dive and an aim.

Table, page, map, files and sentences take the words on a number from here.  A column of a lower
rank stands before others where there is no room for all; those of rank 0 always stand.

A place is written in decimal degrees, and in degrees and minutes of two decimals (18 m).  The
last decimals of minutes are counted as whole numbers, so that 59.999 carries to the next degree.
A direction is where something goes to, clockwise from true north, [0, 360).
"""

from collections.abc import Callable
from math import hypot
from typing import Any

from ...base.geodesy import direction, east_of
from ...base.units import iso
from ..estimation.fix_model import PERCENT

Place = tuple[float, float]  # degrees north and east
PLANNED, REPEATED, GIVEN = "planned", "repeated", "given"
BASES = {  # of the guess of the next dive
    PLANNED: "duration and speed of the last dives, along the plan in the files",
    REPEATED: "mean of the last dives, with their spread",
    GIVEN: "as given or aimed, with the spread of the last dives",
}
REACHED, UNDER_WAY, AGAINST = "reached", "under way", "cannot be made"  # of a waypoint
SOON = 48.0  # hours; a longer age is in days
Row = dict[str, Any]
Report = dict[str, Any]  # of a replay, ready for JSON
# title: rank, and cell of a row
Columns = dict[str, tuple[int, Callable[[Row], str | None]]]


# --- places, directions and times -----------------------------------------------------------------


def utc(time: float) -> str:
    """Return a time, s since 1970 UTC, as ISO 8601 to the second.

    >>> utc(1454292746.4)
    '2016-02-01T02:12:26Z'
    """
    return iso(round(time))


def clock(time: str) -> str:
    """Return an ISO 8601 time to the minute, as a sentence has it.

    >>> clock("2016-02-01T02:12:26Z")
    '2016-02-01 02:12 UTC'
    """
    return f"{time[:10]} {time[11:16]} UTC"


def compass(angle: float) -> str:
    """Return a direction in whole degrees, three digits.

    >>> compass(7.2), compass(359.6), compass(-90.0)
    ('007', '000', '270')
    """
    return f"{round(angle) % 360:03d}"


def velocity(east: float, north: float) -> str:
    """Return a current in m/s and where it goes to.

    >>> velocity(0.0, -0.21), velocity(0.0, 0.0)
    ('0.21 m/s to 180', '0.00 m/s')
    """
    angle = direction(east, north)
    return f"{hypot(east, north):.2f} m/s" + (
        "" if angle is None else f" to {compass(angle)}"
    )


def in_degrees(lat: float, lon: float) -> str:
    """Return a place in decimal degrees.

    >>> in_degrees(-42.93, 8.42), in_degrees(0.0, 190.0)
    ('42.9300 S 8.4200 E', '0.0000 N 170.0000 W')
    """
    pairs = (round(lat, 4), "NS"), (round(east_of(lon), 4), "EW")
    return " ".join(f"{abs(angle):.4f} {names[angle < 0]}" for angle, names in pairs)


def degrees_minutes(angle: float, decimals: int) -> tuple[int, str]:
    """Return an angle's size as whole degrees and minutes of two digits and some decimals.

    >>> degrees_minutes(-42.99999, 2), degrees_minutes(8.42, 0)
    ((43, '00.00'), (8, '25'))
    """
    size = 10**decimals
    degrees, remainder = divmod(round(60 * size * abs(angle)), 60 * size)
    return (
        degrees,
        f"{remainder // size:02d}"
        + f".{remainder % size:0{decimals}d}" * bool(decimals),
    )


def in_minutes(lat: float, lon: float) -> str:
    """Return a place in degrees and decimal minutes.

    >>> in_minutes(-42.93, 8.42), in_minutes(-0.00001, -179.99999)
    ('42 55.80 S 8 25.20 E', '0 00.00 N 180 00.00 W')
    """
    words = []
    for angle, names in ((lat, "NS"), (east_of(lon), "EW")):
        degrees, minutes = degrees_minutes(angle, 2)
        words.append(f"{degrees} {minutes} {names[round(6000 * angle) < 0]}")
    return " ".join(words)


def minutes(angle: float) -> str:
    """Return an angle as gliders take it: degrees and minutes in one number, ddmm.mmmm.

    >>> minutes(-42.8), minutes(8.4), minutes(-0.99999999)
    ('-4248.0000', '824.0000', '-100.0000')
    """
    return "-" * (angle < 0) + "".join(map(str, degrees_minutes(angle, 4)))


def place(lat: float, lon: float) -> str:
    """Return a place both ways.

    >>> place(-42.93, 8.42)
    '42 55.80 S 8 25.20 E (42.9300 S 8.4200 E)'
    """
    return f"{in_minutes(lat, lon)} ({in_degrees(lat, lon)})"


def placed(prefix: str, lat: float, lon: float) -> dict[str, float]:
    """Return a place as rows have it, by the name of the place.

    >>> placed("end_", -42.9, 8.4)
    {'end_latitude': -42.9, 'end_longitude': 8.4}
    """
    return {f"{prefix}latitude": lat, f"{prefix}longitude": lon}


def vector(prefix: str, east: float, north: float) -> dict[str, float]:
    """Return a vector as rows have it, by its name."""
    return {f"{prefix}east": float(east), f"{prefix}north": float(north)}


def date(time: str) -> str:
    """Return month, day, hour and minute of an ISO time."""
    return time[5:16].replace("T", " ")


# --- words on rows --------------------------------------------------------------------------------


def place_in(row: Row, prefix: str) -> Place:
    """Return a place of a row, such as its ``"end_"``."""
    return row[f"{prefix}latitude"], row[f"{prefix}longitude"]


def is_outside(row: Row) -> bool:
    """Return whether a dive ended outside the ellipse of its forecast; False without one."""
    return row["forecast"] is not None and not row["forecast"]["inside"]


def half_axes(row: Row) -> str:
    """Return the half axes of an ellipse, m."""
    return f"{row['ellipse_long']:.0f} x {row['ellipse_short']:.0f}"


def ellipse_words(row: Row) -> str:
    """Return the size of an ellipse.

    >>> ellipse_words({"ellipse_long": 3163.2, "ellipse_short": 2955.0}).replace(PERCENT, "P %")
    'P % ellipse with half axes 3163 x 2955 m'
    """
    return f"{PERCENT} ellipse with half axes {half_axes(row)} m"


def age(hours: float) -> str:
    """Return an age in hours, or in days if it is two days or more.

    >>> age(8.94), age(100.0)
    ('8.9 h', '4 d')
    """
    return f"{hours:.1f} h" if hours < SOON else f"{hours / 24:.0f} d"


def from_now(hours: float) -> str:
    """Return when something is, in hours from now.

    >>> from_now(4.26), from_now(-0.52), from_now(-100.0)
    ('in 4.3 h', '0.5 h ago', '4 d ago')
    """
    return f"{age(-hours)} ago" if round(hours, 1) < 0 else f"in {abs(hours):.1f} h"


def is_overdue(ahead: Row) -> bool:
    """Return whether a vehicle is later than the half width of its time, of `NextDive.as_dict`."""
    late = -3600 * ahead["hours_from_now"]
    return ahead["now_is"] == "clock" and late > ahead["time_half_width"]


def due(ahead: Row) -> str:
    """Return when the next surfacing is, from now, and that it is overdue.

    >>> due({"time_half_width": 1800.0, "hours_from_now": -0.6, "now_is": "clock"})
    'overdue, expected 0.6 h ago'
    """
    words = from_now(ahead["hours_from_now"])
    return f"overdue, expected {words}" if is_overdue(ahead) else words


def wide(ahead: Row) -> str:
    """Return a warning if an ellipse is longer than its dive, and what helps.

    >>> wide({"dr_east": 800.0, "dr_north": 0.0, "ellipse_long": 900.0,
    ...       "basis": "repeated"})
    'wide: no plan in the files. Give --next or --aim'
    """
    if ahead["ellipse_long"] <= hypot(ahead["dr_east"], ahead["dr_north"]):
        return ""
    if ahead["basis"] == GIVEN:
        return "wide: longer than the way through the water; more dives narrow it"
    why = "no plan in the files"
    if ahead.get("plan_in_files"):
        why = "few dives went along the plan in the files"
    return f"wide: {why}. Give --next or --aim"


def within(ahead: Row) -> str:
    """Return the half width of a time."""
    return f"+- {ahead['time_half_width'] / 60:.0f} min"


def when(ahead: Row) -> str:
    """Return when the next surfacing is, of `NextDive.as_dict`.

    >>> when({"time": "2016-02-03T14:19:59Z", "time_half_width": 1800.0, "hours_from_now": 4.5,
    ...       "now_is": "clock"})
    '2016-02-03 14:19 UTC +- 30 min, in 4.5 h'
    """
    words = f"{clock(ahead['time'])} {within(ahead)}, {due(ahead)}"
    return (
        words if ahead["now_is"] == "clock" else f"{words} from the {ahead['now_is']}"
    )


def heading_words(leg: Row) -> str:
    """Return what to command, of `Aim.as_dict`."""
    if leg["heading"] is None:
        return "stay"
    magnetic = leg["heading_magnetic"]
    magnetic_text = "" if magnetic is None else f" (magnetic {compass(magnetic)})"
    return f"heading {compass(leg['heading'])}{magnetic_text}"


def against(leg: Row) -> str:
    """Return that a waypoint cannot be made, and why."""
    current = velocity(leg["current_east"], leg["current_north"])
    speed = f"{leg['speed_expected']:.2f} m/s"
    return f"{AGAINST} against the current, {current}, at {speed}"


# --- cells ----------------------------------------------------------------------------------------


def metres(size: float | None) -> str:
    """Return a length as a cell of the table, m."""
    return "-" if size is None else f"{size:.0f}"


def _miss(row: Row, model: str) -> str | None:
    """Return the miss of a flow model, None where there is none."""
    return metres(row["clpe"][model]) if model in row["clpe"] else None


def _toward(motion: Row, prefix: str = "") -> str:
    """Return a speed, m/s, and where to, degrees."""
    speed = motion[f"{prefix}speed"]
    direction = motion[f"{prefix}direction"]
    speed_text = "-" if speed is None else f"{speed:.2f}"
    return speed_text if direction is None else f"{speed_text} {compass(direction)}°"


def _current(row: Row) -> str:
    """Return the current east and north, and the standard error of its last digits."""
    components = (
        (row[f"current_{axis}"], row[f"current_{axis}_error"])
        for axis in ("east", "north")
    )
    return " ".join(f"{value:+z.3f}({1000 * error:.0f})" for value, error in components)


def _speed(row: Row) -> str | None:
    """Return the factor on speed, None where none is learned."""
    value = row["speed_factor"]
    return (
        None
        if value is None
        else f"{value:.3f}({1000 * row['speed_factor_error']:.0f})"
    )


def _drift(row: Row) -> str:
    drift = row["drift"]
    return "-" if drift is None else f"{drift['distance']:.0f} m at {_toward(drift)}"


def _ellipse(row: Row | None) -> str:
    return "-" if row is None else f"{half_axes(row)}, {row['ellipse_bearing']:.0f}"


def in_words(row: Row) -> str:
    """Return whether a dive ended in the ellipse of its forecast, as a cell."""
    return "-" if row["forecast"] is None else "OUT" if is_outside(row) else "in"


TITLE = "Position error (CLPE, m) one dive ahead; currents in m/s"
MODELS = ("no flow", "previous", "adaptive", "model")  # columns of the flow models
ELLIPSE = f"{PERCENT} half axes m, deg"
COLUMNS: Columns = {
    "dive": (0, lambda row: str(row["dive"])),
    "ended (UTC)": (1, lambda row: date(row["end"])),
    "no flow": (4, lambda row: _miss(row, "no_flow")),
    "previous": (0, lambda row: _miss(row, "previous_dive")),
    "adaptive": (0, lambda row: _miss(row, "adaptive")),
    "model": (1, lambda row: _miss(row, "flow_model")),
    "current to": (2, lambda row: _toward(row, "current_")),
    "current E N (m/s)": (6, _current),
    "speed": (3, _speed),
    "over ground m/s": (7, lambda row: _toward(row["over_ground"])),
    "drift to": (8, _drift),
    "E N of DR (m)": (
        9,
        lambda row: (
            f"{row['hindsight']['east']:+z.0f} {row['hindsight']['north']:+z.0f}"
        ),
    ),
    ELLIPSE: (5, lambda row: _ellipse(row["forecast"])),
    PERCENT: (0, in_words),
}


def cells(row: Row, columns: Columns = COLUMNS) -> dict[str, str]:
    """Return the cells of a row by the titles of its columns, in their order."""
    pairs = ((title, cell(row)) for title, (_, cell) in columns.items())
    return {title: text for title, text in pairs if text is not None}


def cells_ahead(ahead: Row) -> dict[str, str]:
    """Return what is known of the next dive: when and how near it ends."""
    known_cells = {
        "dive": "next",
        "ended (UTC)": date(ahead["time"]),
        ELLIPSE: _ellipse(ahead),
    }
    return dict.fromkeys(COLUMNS, "") | known_cells
