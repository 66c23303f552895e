"""Map layers of a replay, made of what `clpt replay --json` prints.

A layer is a list of points, lines or rings of one kind.  Four writers take them: the map of the
page, replay.png, GeoJSON and KML.

The ring of a forecast, with half axes a and b and the bearing B of the long one, is

    centre + a cos(s) (sin B, cos B) + b sin(s) (-cos B, sin B),   s = 0 .. 2 pi,

east and north at the start of the dive, where its covariance is resolved: counter-clockwise.
"""

from collections import defaultdict
from math import cos, pi, radians, sin
from typing import Any

import numpy as np

from ...base.geodesy import displacement, place_from
from ...base.map_files import BLUE, ORANGE, PURPLE, Feature
from ..estimation.learned_fix import PERCENT
from .geographic import Place, compass, velocity
from .surfacing import ELLIPSE
from .table_rows import ellipse_words, is_outside, place_in, within

NAMES = {  # kind of a layer in KML and GeoJSON: its name and its colour
    "track": ("track", BLUE),
    "fix": ("dive", BLUE),
    "last": ("last fix", BLUE),
    "way": ("way to the next surfacing", PURPLE),
    "next": ("next surfacing", PURPLE),
    "ring next": (f"{PERCENT} ellipse", PURPLE),
    "target": ("waypoint", ORANGE),
    "made": ("distance made good", ORANGE),
    "ring aimed": (f"{PERCENT} ellipse, aimed", ORANGE),
}
CORNERS = 48
LAST = 5  # dives whose ellipses are drawn


def ring_of(row: dict[str, Any], begin: Place, end: Place) -> list[Place]:
    """Return the closed ring of an ellipse about the end of a way."""
    long, short, bearing = (row[name] for name in ELLIPSE)
    center = displacement(*begin, *end)
    sine, cosine = sin(radians(bearing)), cos(radians(bearing))
    angle = 2 * pi * (np.arange(CORNERS + 1) % CORNERS) / CORNERS
    along_axis, across = long * np.cos(angle), short * np.sin(angle)
    east = center[0] + along_axis * sine - across * cosine
    north = center[1] + along_axis * cosine + across * sine
    return [place_from(*begin, *away) for away in zip(east, north, strict=True)]


def words_of_next(ahead: dict[str, Any]) -> str:
    """Return the popup's words on the next surfacing."""
    bearing = compass(ahead["ellipse_bearing"])
    when = f"{ahead['time']} {within(ahead)}"
    size = ellipse_words(ahead)
    return f"{when}, {ahead['place']}; {size}, the long axis to {bearing}"


def words_of_dive(row: dict[str, Any]) -> str:
    """Return the popup's words on a dive."""
    error = f"position error {row['clpe']['adaptive']:.0f} m"
    if row["forecast"] is not None:
        where = "outside" if is_outside(row) else "in"
        error += f", {where} the {PERCENT} ellipse of its forecast"
    current = velocity(row["current_east"], row["current_north"])
    return f"surfaced {row['end']}, {error}; current {current}"


def layers_of(report: dict[str, Any]) -> dict[str, list[Feature]]:
    """Return the layers of what `--json` prints by kind, of dives in their order.

    The ellipses are those of the last dives with a forecast.
    """
    layers: dict[str, list[Feature]] = defaultdict(list)

    def add(
        kind: str,
        places: list[Place],
        of: dict[str, Any],
        words: str = "",
        when: str = "",
    ) -> None:
        layers[kind].append(_feature(kind, places, of, words, when))

    before = None
    for row in report["each_dive"]:
        start, end, reckoned = (
            place_in(row, prefix) for prefix in ("start_", "end_", "reckoned_")
        )
        add("miss", [reckoned, end], row)
        add("track", [start, end], row)
        add("reckoned", [reckoned], row)
        add("fix", [end], row, words_of_dive(row), row["end"])
        if before is not None:
            add("drift", [before, start], row)
        if row["forecast"] is not None:
            goal = place_in(row["forecast"], "")
            add("forecast", [goal], row)
            add("ring", ring_of(row["forecast"], start, goal), row)
        before = end
    del layers.get("ring", [])[:-LAST]
    ahead = report.get("next_dive")
    if ahead is not None:
        last, goal = (place_in(ahead, prefix) for prefix in ("from_", ""))
        add("last", [last], {"dive": row["dive"], "time": row["end"]})
        add("way", [last, goal], ahead)
        add("next", [goal], ahead, words_of_next(ahead), ahead["time"])
        add("ring next", ring_of(ahead, last, goal), ahead, when=ahead["time"])
    for leg in report.get("aim") or ():
        target, begin, end = (place_in(leg, prefix) for prefix in ("", "from_", "end_"))
        add("target", [target], leg, leg["place"])
        add("aim", [begin, target], leg)
        add("made", [begin, end], leg)
        add("ring aimed", ring_of(leg, begin, end), leg, when=leg["end"])
    return layers


def _feature(
    kind: str, places: list[Place], of: dict[str, Any], words: str, when: str
) -> Feature:
    """Return a feature of a row, next dive or leg; only points have its values."""
    name, colour = NAMES.get(kind, ("", ""))
    if len(places) > 1:
        shape = "Polygon" if kind.startswith("ring") else "LineString"
        properties = {"time": when} if when else {}
    else:
        shape = "Point"
        properties = {key: value for key, value in of.items() if value is not None}
    if kind == "next":
        properties = {"description": words, **properties}
    if kind == "fix":
        name = f"{name} {of['dive']}"
    return Feature(name, shape, places, colour, when, words, properties)
