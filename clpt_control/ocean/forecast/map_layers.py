"""Map layers of a replay, made of what `clpt replay --json` prints.

A layer is a point, a line or a ring, by the name of a GeoJSON geometry; its kind says what it is.
Four writers take them: the map of the page, map.png, GeoJSON and KML.

The ring of a forecast, with half axes a and b and the bearing B of the long one, is

    centre + a cos(s) (sin B, cos B) + b sin(s) (-cos B, sin B),   s = 0 .. 2 pi,

east and north at the start of the dive, where its covariance is resolved: counter-clockwise.
"""

from collections import defaultdict
from math import cos, pi, radians, sin
from typing import Any, NamedTuple

from ...base.geodesy import displacement, place_from
from .geographic import Place, compass, velocity
from .table_rows import ellipse_words
from .text_report import within

# start, centre
DIVE, NEXT, AIMED = (("start_", "forecast_"), ("from_", ""), ("from_", "end_"))
CORNERS = 48
LAST = 12  # dives whose ellipses are drawn


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


def ring_of(row: dict[str, Any], kind: tuple[str, str] = DIVE) -> list[Place]:
    """Return the closed ring of the 90 % ellipse of a dive, of the next one or of an aimed one."""
    long, short, bearing = (
        row[f"ellipse_90_{name}"] for name in ("long", "short", "bearing")
    )
    begin, end = (place_in(row, prefix) for prefix in kind)
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
    bearing = compass(ahead["ellipse_90_bearing"])
    when = f"{ahead['time']} {within(ahead)}"
    size = ellipse_words(ahead)
    return f"{when}, {ahead['place']}; {size}, the long axis to {bearing}"


def words_of_dive(row: dict[str, Any]) -> str:
    """Return the popup's words on a dive."""
    miss = row["clpe"]["adaptive"]
    return (
        f"surfaced {row['end']}, {miss:.0f} m from the forecast, "
        f"{'in' if row['inside_90'] else 'outside'} its 90 % ellipse; current "
        f"{velocity(row['current_east'], row['current_north'])}"
    )


def layers_of(report: dict[str, Any]) -> dict[str, list[Layer]]:
    """Return the layers of what `--json` prints by kind, of dives in their order.

    The first dive has no forecast; the ellipses are those of the last ones.
    """
    layers: list[Layer] = []
    before = None
    for row in report["each_dive"]:
        start, end, reckoned, forecast = (
            place_in(row, prefix)
            for prefix in ("start_", "end_", "reckoned_", "forecast_")
        )
        layers += [
            Layer("miss", "LineString", [reckoned, end], row),
            Layer("track", "LineString", [start, end], row),
            Layer("reckoned", "Point", [reckoned], row),
            Layer("fix", "Point", [end], row, words_of_dive(row), row["end"]),
        ]
        if before is not None:
            layers += [
                Layer("drift", "LineString", [before, start], row),
                Layer("forecast", "Point", [forecast], row),
            ]
        before = end
    layers += [
        Layer("ring", "Polygon", ring_of(row), row)
        for row in report["each_dive"][1:][-LAST:]
    ]
    ahead = report.get("next_dive")
    if ahead is not None:
        last, goal = (place_in(ahead, prefix) for prefix in NEXT)
        layers += [
            Layer("way", "LineString", [last, goal], ahead),
            Layer("next", "Point", [goal], ahead, words_of_next(ahead), ahead["time"]),
            Layer(
                "ring next", "Polygon", ring_of(ahead, NEXT), ahead, when=ahead["time"]
            ),
        ]
    for leg in report.get("aim") or ():
        target, (begin, end) = (
            place_in(leg, ""),
            (place_in(leg, prefix) for prefix in AIMED),
        )
        layers += [
            Layer("target", "Point", [target], leg, leg["place"]),
            Layer("aim", "LineString", [begin, target], leg),
            Layer("made", "LineString", [begin, end], leg),
            Layer("ring aimed", "Polygon", ring_of(leg, AIMED), leg, when=leg["end"]),
        ]
    by_kind = defaultdict(list)
    for layer in layers:
        by_kind[layer.kind].append(layer)
    return by_kind
