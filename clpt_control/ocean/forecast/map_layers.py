"""Map layers of a replay, made of what `clpt replay --json` prints.

A layer is a point, a line or a ring, by the name of a GeoJSON geometry; its kind says what it is.
Four writers take them: the map of the page, replay.png, GeoJSON and KML.

The ring of a forecast, with half axes a and b and the bearing B of the long one, is

    centre + a cos(s) (sin B, cos B) + b sin(s) (-cos B, sin B),   s = 0 .. 2 pi,

east and north at the start of the dive, where its covariance is resolved: counter-clockwise.
"""

from collections import defaultdict
from math import cos, pi, radians, sin
from typing import Any, NamedTuple

from ...base.geodesy import displacement, place_from
from ..estimation.learned_fix import PERCENT
from .geographic import Place, compass, velocity
from .surfacing import ELLIPSE
from .table_rows import ellipse_words
from .text_report import within

CORNERS = 48
LAST = 5  # dives whose ellipses are drawn


class Layer(NamedTuple):
    """Places, the row, next dive or leg that they are `of`, words on it, and its time."""

    kind: str
    shape: str
    places: list[Place]
    of: dict[str, Any]
    words: str = ""
    when: str = ""


def place_in(row: dict[str, Any], prefix: str) -> Place:
    """Return a place of a row, such as its ``"end_"``."""
    return row[f"{prefix}latitude"], row[f"{prefix}longitude"]


def is_outside(row: dict[str, Any]) -> bool:
    """Return whether a dive ended outside the ellipse of its forecast; False without one."""
    return row["forecast"] is not None and not row["forecast"]["inside"]


def ring_of(row: dict[str, Any], begin: Place, end: Place) -> list[Place]:
    """Return the closed ring of an ellipse about the end of a way."""
    long, short, bearing = (row[name] for name in ELLIPSE)
    east, north = displacement(*begin, *end)
    sine, cosine = sin(radians(bearing)), cos(radians(bearing))
    points = []
    for k in range(CORNERS):
        along_axis, across = (
            long * cos(2 * pi * k / CORNERS),
            short * sin(2 * pi * k / CORNERS),
        )
        away = along_axis * sine - across * cosine, along_axis * cosine + across * sine
        points.append(place_from(*begin, east + away[0], north + away[1]))
    return [*points, points[0]]


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


def layers_of(report: dict[str, Any]) -> dict[str, list[Layer]]:
    """Return the layers of what `--json` prints by kind, of dives in their order.

    The ellipses are those of the last dives with a forecast.
    """
    layers: list[Layer] = []
    rings: list[Layer] = []
    before = None
    for row in report["each_dive"]:
        start, end, reckoned = (
            place_in(row, prefix) for prefix in ("start_", "end_", "reckoned_")
        )
        layers += [
            Layer("miss", "LineString", [reckoned, end], row),
            Layer("track", "LineString", [start, end], row),
            Layer("reckoned", "Point", [reckoned], row),
            Layer("fix", "Point", [end], row, words_of_dive(row), row["end"]),
        ]
        if before is not None:
            layers.append(Layer("drift", "LineString", [before, start], row))
        if row["forecast"] is not None:
            goal = place_in(row["forecast"], "")
            ring = ring_of(row["forecast"], start, goal)
            layers.append(Layer("forecast", "Point", [goal], row))
            rings.append(Layer("ring", "Polygon", ring, row))
        before = end
    layers += rings[-LAST:]
    ahead = report.get("next_dive")
    if ahead is not None:
        last, goal = (place_in(ahead, prefix) for prefix in ("from_", ""))
        layers += [
            Layer("way", "LineString", [last, goal], ahead),
            Layer("next", "Point", [goal], ahead, words_of_next(ahead), ahead["time"]),
            Layer(
                "ring next",
                "Polygon",
                ring_of(ahead, last, goal),
                ahead,
                when=ahead["time"],
            ),
        ]
    for leg in report.get("aim") or ():
        target, (begin, end) = (
            place_in(leg, ""),
            (place_in(leg, prefix) for prefix in ("from_", "end_")),
        )
        layers += [
            Layer("target", "Point", [target], leg, leg["place"]),
            Layer("aim", "LineString", [begin, target], leg),
            Layer("made", "LineString", [begin, end], leg),
            Layer(
                "ring aimed", "Polygon", ring_of(leg, begin, end), leg, when=leg["end"]
            ),
        ]
    by_kind = defaultdict(list)
    for layer in layers:
        by_kind[layer.kind].append(layer)
    return by_kind
