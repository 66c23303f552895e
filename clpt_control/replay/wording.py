"""A replay in words: times, places and velocities, sentences, columns of a table.

A place is written in decimal degrees, and in degrees and minutes of two decimals (18 m).  The
last decimals of minutes are counted as whole numbers, so that 59.999 carries to the next degree.
A direction is where something goes to, clockwise from true north, [0, 360).

Sentences and cells are made of what `clpt replay --json` prints.  The table has a row for each
dive, on terminals and pages.  A column of a lower rank stands before others where there is no room
for all; those of rank 0 always stand.
"""

from datetime import UTC, datetime
from math import atan2, degrees, hypot
from typing import Any

from ..geodesy import near
from .doubts import Anomaly

Place = tuple[float, float]  # degrees north and east
REACHED, UNDER_WAY, AGAINST = "reached", "under way", "cannot be made"  # of a waypoint


def utc(time: float) -> str:
    """Return a time, s since 1970 UTC, as ISO 8601 to the second.

    >>> utc(1454292746.4)
    '2016-02-01T02:12:26Z'
    """
    return datetime.fromtimestamp(round(time), UTC).strftime("%Y-%m-%dT%H:%M:%SZ")


def clock(time: str) -> str:
    """Return an ISO 8601 time to the minute, as a sentence has it.

    >>> clock("2016-02-01T02:12:26Z")
    '2016-02-01 02:12 UTC'
    """
    return f"{time[:10]} {time[11:16]} UTC"


def direction(east: float, north: float) -> float | None:
    """Return where a vector points, degrees clockwise from north; None where it has no length.

    >>> direction(-1.0, 0.0), direction(0.0, 0.0)
    (270.0, None)
    """
    if hypot(east, north) == 0.0:
        return None
    angle = degrees(atan2(east, north)) % 360.0
    return 0.0 if angle == 360.0 else angle  # of -1e-15


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
    return f"{hypot(east, north):.2f} m/s" + ("" if angle is None else f" to {compass(angle)}")


def east_of(lon: float) -> float:
    """Return a longitude between -180 and 180 degrees.

    >>> east_of(190.0), east_of(-180.0), east_of(180.0), east_of(-540.0)
    (-170.0, -180.0, 180.0, -180.0)
    """
    return lon if -180.0 <= lon <= 180.0 else near(lon, 0.0)


def in_degrees(lat: float, lon: float) -> str:
    """Return a place in decimal degrees.

    >>> in_degrees(-42.93, 8.42), in_degrees(0.0, 190.0)
    ('42.9300 S 8.4200 E', '0.0000 N 170.0000 W')
    """
    pairs = ((round(lat, 4), "NS"), (round(east_of(lon), 4), "EW"))
    return " ".join(f"{abs(angle):.4f} {names[angle < 0]}" for angle, names in pairs)


def degrees_minutes(angle: float, decimals: int) -> tuple[int, str]:
    """Return an angle's size as whole degrees and minutes of two digits and some decimals.

    >>> degrees_minutes(-42.99999, 2), degrees_minutes(8.42, 0)
    ((43, '00.00'), (8, '25'))
    """
    size = 10**decimals
    whole, rest = divmod(round(60 * size * abs(angle)), 60 * size)
    return whole, f"{rest // size:02d}" + f".{rest % size:0{decimals}d}" * bool(decimals)


def in_minutes(lat: float, lon: float) -> str:
    """Return a place in degrees and decimal minutes.

    >>> in_minutes(-42.93, 8.42), in_minutes(-0.00001, -179.99999)
    ('42 55.80 S 8 25.20 E', '0 00.00 N 180 00.00 W')
    """
    words = []
    for angle, names in ((lat, "NS"), (east_of(lon), "EW")):
        whole, minutes = degrees_minutes(angle, 2)
        words.append(f"{whole} {minutes} {names[round(6000 * angle) < 0]}")
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


def placed(which: str, lat: float, lon: float) -> dict[str, float]:
    """Return a place as rows have it, by the name of the place.

    >>> placed("end_", -42.9, 8.4)
    {'end_latitude': -42.9, 'end_longitude': 8.4}
    """
    return {f"{which}latitude": lat, f"{which}longitude": lon}


def vector(which: str, east: float, north: float) -> dict[str, float]:
    """Return a vector as rows have it, by its name."""
    return {f"{which}east": float(east), f"{which}north": float(north)}


def from_now(hours: float) -> str:
    """Return when something is, in hours from now.

    >>> from_now(4.26), from_now(-0.52)
    ('in 4.3 h', '0.5 h ago')
    """
    return f"{-hours:.1f} h ago" if round(hours, 1) < 0 else f"in {abs(hours):.1f} h"


BASES = {  # what the next dive is guessed by
    "planned": "as the last dives went along the plan in the files",
    "repeated": "as the last dives went, with their spread",
    "given": "as given or aimed, with the spread of the last dives",
}
MODELS = {  # name of a flow model: its column
    "no_flow": "no flow",
    "previous_dive": "previous",
    "adaptive": "adaptive",
    "flow_model": "model",
}
RANKS = {  # title of a column: its rank
    "dive": 0,
    "ended (UTC)": 1,
    "no flow": 4,
    "previous": 0,
    "adaptive": 0,
    "model": 1,
    "current to": 2,
    "current E N (m/s)": 6,
    "speed": 3,
    "over ground": 7,
    "drift (m) to": 8,
    "E N of DR (m)": 9,
    "90 % ellipse (m, deg)": 5,
    "90 %": 0,
    "mark": 0,
}


def cells(row: dict[str, Any]) -> dict[str, str]:
    """Return the cells of a row of `--json` by the titles of their columns, in their order."""
    clpe, drift = row["clpe"], row["drift"]
    current = [
        f"{row[f'current_{axis}']:+.3f}({1000 * row[f'current_{axis}_error']:.0f})"
        for axis in ("east", "north")
    ]
    speed = {}
    if row["speed_factor"] is not None:
        speed["speed"] = f"{row['speed_factor']:.3f}({1000 * row['speed_factor_error']:.0f})"
    return {
        "dive": str(row["dive"]),
        "ended (UTC)": date(row["end"]),
        **{MODELS[name]: metres(size) for name, size in clpe.items()},
        "current to": _toward(row, "current_"),
        "current E N (m/s)": " ".join(current),
        **speed,
        "over ground": _toward(row["over_ground"]),
        "drift (m) to": "-" if drift is None else f"{drift['distance']:.0f}, {_toward(drift)}",
        "E N of DR (m)": f"{row['forecast_east']:+.0f} {row['forecast_north']:+.0f}",
        "90 % ellipse (m, deg)": _ellipse(row),
        "90 %": "in" if row["inside_90"] else "OUT",
        "mark": speed_mark(row["anomaly"]),
    }


def cells_ahead(ahead: dict[str, Any]) -> dict[str, str]:
    """Return what is known of the next dive: when and how near it ends."""
    known = {"dive": "next", "ended (UTC)": date(ahead["time"])}
    return {**dict.fromkeys(RANKS, ""), **known, "90 % ellipse (m, deg)": _ellipse(ahead)}


def metres(size: float | None) -> str:
    """Return a length as a cell of the table, m."""
    return "-" if size is None else f"{size:.0f}"


def _toward(way: dict[str, Any], prefix: str = "") -> str:
    """Return a speed, m/s, and where to, degrees."""
    speed, direction = way[f"{prefix}speed"], way[f"{prefix}direction"]
    known = "-" if speed is None else f"{speed:.2f}"
    return known if direction is None else f"{known} {compass(direction)}"


def half_axes(row: dict[str, Any]) -> str:
    """Return the half axes of a 90 % ellipse, m."""
    return f"{row['ellipse_90_long']:.0f} x {row['ellipse_90_short']:.0f}"


def _ellipse(row: dict[str, Any]) -> str:
    return f"{half_axes(row)}, {row['ellipse_90_bearing']:.0f}"


def speed_mark(anomaly: dict[str, Any] | None) -> str:
    """Return the mark of a dive whose speed left its range, empty where none did."""
    return "" if anomaly is None else "SPEED" if anomaly["certain"] else "SPEED?"


def date(time: str) -> str:
    """Return month, day, hour and minute of an ISO time."""
    return time[5:16].replace("T", " ")


def next_surfacing(ahead: dict[str, Any]) -> str:
    """Return the sentence on `NextDive.as_dict`."""
    uncovered = ahead["flow_model_covers"] is False
    return (
        f"next surfacing {when(ahead)}, "
        f"after {ahead['duration'] / 3600:.2f} h and {ahead['dr_east']:+.0f} m "
        f"east, {ahead['dr_north']:+.0f} m north through the water ({BASES[ahead['basis']]}): "
        f"{place(ahead['latitude'], ahead['longitude'])}, 90 % within "
        f"{half_axes(ahead)} m"
        + (f"; the flow model does not cover it: {ahead['why_uncovered']}" if uncovered else "")
    )


def within(ahead: dict[str, Any]) -> str:
    """Return how far off the time may be, 90 %."""
    return f"+- {ahead['time_90'] / 60:.0f} min"


def record_sentence(headlines: dict[str, Any]) -> str:
    """Return how many of the headlines so far held.

    >>> record_sentence({"judged": 13, "place_held": 12, "time_held": 13})
    'headlines so far: 12 of 13 held the place, 13 the time'
    """
    count = headlines["judged"]
    if not count:
        return "no headline before this one: its widths are those of vehicles at large"
    held = f"{headlines['place_held']} of {count} held the place"
    return f"headlines so far: {held}, {headlines['time_held']} the time"


def when(ahead: dict[str, Any]) -> str:
    """Return when the next surfacing is, of `NextDive.as_dict`.

    >>> when({"time": "2016-02-03T14:19:59Z", "time_90": 1800.0, "hours_from_now": 4.5,
    ...       "now_is": "clock"})
    '2016-02-03 14:19 UTC +- 30 min, in 4.5 h'
    """
    words = f"{clock(ahead['time'])} {within(ahead)}, {from_now(ahead['hours_from_now'])}"
    return words if ahead["now_is"] == "clock" else f"{words} from the {ahead['now_is']}"


def aim_sentence(leg: dict[str, Any]) -> str:
    """Return the sentence on `Aim.as_dict`."""
    bears = "here"
    if leg["bearing"] is not None:
        bears = f"{leg['distance'] / 1000:.1f} km to {compass(leg['bearing'])}"
    text = f"aim at {place(leg['latitude'], leg['longitude'])}, {bears}: "
    against = leg["state"] == AGAINST
    if against:
        current = velocity(leg["current_east"], leg["current_north"])
        text += (
            f"cannot be made against the current, {current}, at {leg['speed_expected']:.2f} m/s; "
            "best "
        )
    if leg["heading"] is None:
        text += "stay"
    else:
        text += f"heading {compass(leg['heading'])}"
        if leg["heading_magnetic"] is not None:
            text += f" (magnetic {compass(leg['heading_magnetic'])})"
        if leg["crab"] is not None:
            text += f", crab {leg['crab']:+.0f}"
    full = f"{leg['through_water_full']:.0f} m"
    if leg["state"] == REACHED:
        end = clock(leg["end"])
        text += f", {leg['through_water']:.0f} of {full} through the water; there at {end}"
    else:
        made = leg["made_good"]
        text += f", {made:.0f} m made good of {full}" if made >= 0 else f", {-made:.0f} m are lost"
        text += f", then {leg['left'] / 1000:.1f} km"
        text += "" if against else f"; there in {leg['dives']:.1f} dives, {leg['hours']:.0f} h"
    return f"{text}; expected miss {leg['expected_miss']:.0f} m, 90 % within {half_axes(leg)} m"


def route_sentences(route: dict[str, Any]) -> list[str]:
    """Return a sentence for each waypoint of a route, and for each area."""
    lines = []
    for one in route["waypoints"]:
        times = [clock(one[key]) if one[key] else "" for key in ("not_before", "time", "by")]
        early, middle, late = times
        text = f"there {middle}" if middle else "not there"
        text += f"; cannot be made before {early} (90 %)" if early else ""
        text += f", made by {late} (90 %)" if late else ""
        if one["made"] < 1:
            within = f"within {route['dives']} dives"
            text += f"; made {within} in {100 * one['made']:.0f} % of {route['draws']} draws"
        lines.append(f"route to {one['place']}: {text}")
    entered = ((area["name"], 100 * area["entered"]) for area in route["areas"])
    return lines + [f"{name}: entered in {share:.0f} % of the draws" for name, share in entered]


def remarks(summary: dict[str, Any]) -> list[str]:
    """Return lines on what was learned, noted and skipped, of what `--json` prints."""
    lines: list[str] = []
    if "flow_model" in summary and summary["each_dive"]:
        lines += coverage(summary["flow_model"], summary["used"])
    lines += [f"speed anomaly: {Anomaly(**found)}" for found in summary["anomalies"]]
    if summary["dac_identity_median"] is not None:
        lines.append(
            "miss / duration differs from the file's depth-averaged current by "
            f"{1000 * summary['dac_identity_median']:.2g} mm/s (median)"
        )
    if summary["each_dive"]:
        lines.append(record_sentence(summary["headlines"]))
        lines.append(f"surfaced in the 90 % ellipse: {100 * summary['inside_90']:.0f} %")
        if summary["parts"]:
            chances = ", ".join(f"{name} {p:.2f}" for name, p in summary["parts"].items())
            lines.append(f"probability that a part is present: {chances}")
        lines.append(f"learned: {summary['said']['sentence']}")
    if summary["held"]:
        lines.append(f"not yet known from these dives: {shortened(summary['held'])}")
    lines += by_reason(summary["notes"], "note")
    for entry in summary["skipped"]:
        name = "a file" if entry["dive"] is None else f"dive {entry['dive']}"
        lines.append(f"skipped {name}: {entry['why']}")
    return lines


def shortened(names: list[str]) -> str:
    """Return names of parameters on a line, gaussians by their number.

    >>> shortened(["speed", "gaussian[0,0]_east", "gaussian[0,0]_north"])
    'speed, 2 of gaussians'
    """
    plain = [name for name in names if not name.startswith("gaussian[")]
    places = len(names) - len(plain)
    return ", ".join([*plain, *([f"{places} of gaussians"] if places else [])])


def coverage(model: dict[str, Any], used: int) -> list[str]:
    """Return lines that say which dives a flow model covers, and why not the others.

    >>> none = {"dive": 7, "why": "outside the forecast's area"}
    >>> model = {"source": "f.nc", "about": "gridded", "covered": 3, "uncovered": [none]}
    >>> for line in coverage(model, 4):
    ...     print(line)
    flow model f.nc (gridded) covers 3 of 4 dives
    no flow model for dive 7: outside the forecast's area
    """
    lines = [
        f"flow model {model['source']} ({model['about']}) covers {model['covered']} of {used} dives"
    ]
    return [*lines, *by_reason(model["uncovered"], "why", "no flow model for ")]


def by_reason(entries: list[dict[str, Any]], key: str, before: str = "") -> list[str]:
    """Return a line for each reason, with the dives that share it.

    >>> by_reason([{"dive": 3, "note": "odd"}, {"dive": 5, "note": "odd"}], "note")
    ['dives 3, 5: odd']
    """
    reasons: dict[str, list[str]] = {}
    for entry in entries:
        reasons.setdefault(entry[key], []).append(str(entry["dive"]))
    lines = []
    for why, dives in reasons.items():
        named = f"dive{'s'[: len(dives) > 1]} {', '.join(dives)}"
        if len(dives) > 6:
            named = f"{len(dives)} dives from {dives[0]} to {dives[-1]}"
        lines.append(f"{before}{named}: {why}")
    return lines
