"""Map layers of a replay, made of what `clpt replay --json` prints; GeoJSON and KML of them.

A layer is a list of points, lines or rings of one kind.  Four writers take them: the map of the
page, replay.png, GeoJSON and KML.

East and north of an ellipse are those at the start of its dive, where its covariance is resolved.
"""

from collections.abc import Callable
from itertools import pairwise
from operator import itemgetter
from typing import NamedTuple

from ...base.geodesy import displacement
from ...base.map_files import BLUE, ORANGE, PURPLE, Feature, geojson, kml, ring
from ..estimation.fix_model import PERCENT
from .surfacing import ELLIPSE
from .table_rows import (
    Place,
    Report,
    Row,
    compass,
    ellipse_words,
    is_outside,
    place_in,
    placed,
    velocity,
    within,
)

LAST = 5  # dives whose ellipses are drawn
AHEAD = ("way", "next", "ring next", "target", "made", "ring aimed")


def ring_of(row: Row, begin: Place, end: Place) -> list[Place]:
    """Return the closed ring of an ellipse about the end of a way."""
    return ring(begin, displacement(*begin, *end), *(row[name] for name in ELLIPSE))


def words_of_next(ahead: Row) -> str:
    """Return the popup's words on the next surfacing."""
    bearing = compass(ahead["ellipse_bearing"])
    when = f"{ahead['time']} {within(ahead)}"
    size = ellipse_words(ahead)
    return f"{when}, {ahead['place']}; {size}, the long axis to {bearing}"


def words_of_dive(row: Row) -> str:
    """Return the popup's words on a dive."""
    error = f"position error {row['clpe']['adaptive']:.0f} m"
    if row["forecast"] is not None:
        where = "outside" if is_outside(row) else "in"
        off = f"{row['forecast']['error']:.0f} m off, {where} its {PERCENT} ellipse"
        error += f"; the forecast before the dive was {off}"
    current = velocity(row["current_east"], row["current_north"])
    return f"surfaced {row['end']}, {error}; current {current}"


class Kind(NamedTuple):
    """A kind of layer: its rows, the prefixes of its places in a row, and its look on maps."""

    rows: str
    places: tuple[str, ...]
    name: str = ""
    colour: str = ""
    words: Callable[[Row], str] = lambda row: ""
    time: str = ""


WAY, MADE_GOOD = ("from_", ""), ("from_", "end_")
KINDS = {
    "miss": Kind("dives", ("reckoned_", "end_")),
    "track": Kind("dives", ("start_", "end_"), "track", BLUE),
    "reckoned": Kind("dives", ("reckoned_",)),
    "fix": Kind("dives", ("end_",), "dive {dive}", BLUE, words_of_dive, "end"),
    "drift": Kind("stays", ("before_", "start_")),
    "forecast": Kind("forecasts", ("",)),
    "ring": Kind("last forecasts", ("start_", "")),
    "way": Kind("next", WAY, "way to the next surfacing", PURPLE),
    "next": Kind("next", ("",), "next surfacing", PURPLE, words_of_next, "time"),
    "ring next": Kind("next", WAY, f"{PERCENT} ellipse", PURPLE, time="time"),
    "target": Kind("legs", ("",), "waypoint", ORANGE, itemgetter("place")),
    "aim": Kind("legs", WAY),
    "made": Kind("legs", MADE_GOOD, "distance made good", ORANGE),
    "ring aimed": Kind(
        "legs", MADE_GOOD, f"{PERCENT} ellipse, aimed", ORANGE, time="end"
    ),
}


def layers_of(report: Report) -> dict[str, list[Feature]]:
    """Return the layers of what `--json` prints by kind, of dives in their order.

    The ellipses are those of the last dives with a forecast.
    """
    dives = report["each_dive"]
    ahead = report.get("next_dive")
    stays = [
        row | placed("before_", *place_in(before, "end_"))
        for before, row in pairwise(dives)
    ]
    forecasts = [row | row["forecast"] for row in dives if row["forecast"] is not None]
    rows = {
        "dives": dives,
        "stays": stays,
        "forecasts": forecasts,
        "last forecasts": forecasts[-LAST:],
        "next": [] if ahead is None else [ahead],
        "legs": report.get("aim") or [],
    }
    return {
        kind: [_feature(kind, row) for row in rows[KINDS[kind].rows]] for kind in KINDS
    }


def _feature(kind: str, row: Row) -> Feature:
    """Return a feature of a row; only points have the values of the row."""
    _, prefixes, name, colour, words_of, time = KINDS[kind]
    points = [place_in(row, prefix) for prefix in prefixes]
    words = words_of(row)
    when = row[time] if time else ""
    shape = "LineString"
    properties = {"time": when} if when else {}
    if kind.startswith("ring"):
        shape, points = "Polygon", ring_of(row, *points)
    if len(points) == 1:
        shape = "Point"
        properties = {key: value for key, value in row.items() if value is not None}
    if kind == "next":
        properties = {"description": words, **properties}
    return Feature(name.format_map(row), shape, points, colour, when, words, properties)


def next_geojson(report: Report) -> str:
    """Return the next surfacing as GeoJSON: last fix, way, forecast, ellipse, waypoints."""
    layers = layers_of(report)
    row = report["each_dive"][-1]
    properties = {"dive": row["dive"], "time": row["end"]}
    last_place = layers["way"][0].places[:1]
    last = Feature("last fix", "Point", last_place, BLUE, properties=properties)
    return geojson([last, *(feature for kind in AHEAD for feature in layers[kind])])


def track_kml(report: Report, name: str) -> str:
    """Return the whole track as KML: fixes with times, the next surfacing, waypoints."""
    layers = layers_of(report)
    fixes = layers["fix"]
    track = layers["track"][0]
    points = [track.places[0], *(fix.places[0] for fix in fixes)]
    ahead = (feature for kind in AHEAD for feature in layers[kind])
    return kml([track._replace(places=points), *fixes, *ahead], name)
