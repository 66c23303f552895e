"""A replay for other programs: GeoJSON (RFC 7946) and KML 2.2 (OGC 07-147r2).

Both are made of what `clpt replay --json` prints.  Places are WGS84, longitude first; rings turn
counter-clockwise; nothing crosses 180 degrees.  A text of a file loses characters that XML
does not have.
"""

import json
from collections.abc import Sequence
from typing import Any
from xml.etree import ElementTree

from ..html.text import plain
from .chart import AIMED, NEXT, Place, line_pieces, place_in, ring_of, ring_pieces
from .wording import compass, velocity

DIGITS = 6  # decimals of a degree: 0.1 m
KML = "http://www.opengis.net/kml/2.2"
STYLES = {  # colours as KML has them: alpha, blue, green, red
    "track": "ffb27200",
    "fix": "ffb27200",
    "forecast": "ff739e00",
    "next": "ffa779cc",
    "aim": "ff009fe6",
}


def said_of_next(ahead: dict[str, Any]) -> str:
    """Return what a popup says of the next surfacing."""
    half = f"{ahead['ellipse_90_long']:.0f} x {ahead['ellipse_90_short']:.0f} m"
    bearing = compass(ahead["ellipse_90_bearing"])
    return f"{ahead['time']}, {ahead['place']}; 90 % within {half}, the long axis to {bearing}"


def said_of_dive(row: dict[str, Any]) -> str:
    """Return what a popup says of a dive."""
    miss = row["clpe"]["adaptive"]
    return (
        f"surfaced {row['end']}, {miss:.0f} m from the forecast, "
        f"{'in' if row['inside_90'] else 'outside'} its 90 % ellipse; current "
        f"{velocity(row['current_east'], row['current_north'])}"
    )


def next_geojson(found: dict[str, Any]) -> str:
    """Return the next surfacing as GeoJSON: last fix, way, forecast, 90 % ellipse, waypoints."""
    ahead = found["next_dive"]
    last, goal = (place_in(ahead, which) for which in NEXT)
    numbers = {key: value for key, value in ahead.items() if value is not None}
    end = found["each_dive"][-1]
    legs = found.get("aim") or []
    features = [
        _feature("last fix", _point(last), dive=end["dive"], time=end["end"]),
        _feature("way to the next surfacing", _line([last, goal])),
        _feature("90 % ellipse", _polygon(ring_of(ahead, NEXT)), time=ahead["time"]),
        _feature("next surfacing", _point(goal), description=said_of_next(ahead), **numbers),
        *(one for leg in legs for one in _aimed(leg)),
    ]
    lines = ",\n".join(json.dumps(feature, allow_nan=False) for feature in features)
    return f'{{"type": "FeatureCollection", "features": [\n{lines}\n]}}\n'


def _aimed(leg: dict[str, Any]) -> list[dict[str, Any]]:
    numbers = {key: value for key, value in leg.items() if value is not None}
    start, end = (place_in(leg, which) for which in AIMED)
    return [
        _feature("waypoint", _point(place_in(leg, "")), **numbers),
        _feature("way made good", _line([start, end])),
        _feature("90 % ellipse, aimed", _polygon(ring_of(leg, AIMED)), time=leg["end"]),
    ]


def _feature(name: str, geometry: dict[str, Any], **properties: Any) -> dict[str, Any]:
    properties = {"name": name, **properties}
    return {"type": "Feature", "geometry": geometry, "properties": properties}


def _pair(place: Place) -> list[float]:
    return [round(place[1], DIGITS), round(place[0], DIGITS)]


def _point(place: Place) -> dict[str, Any]:
    return {"type": "Point", "coordinates": _pair(line_pieces([place])[0][0])}


def _line(places: Sequence[Place]) -> dict[str, Any]:
    pieces = [[_pair(place) for place in piece] for piece in line_pieces(places)]
    if len(pieces) == 1:
        return {"type": "LineString", "coordinates": pieces[0]}
    return {"type": "MultiLineString", "coordinates": pieces}


def _polygon(ring: Sequence[Place]) -> dict[str, Any]:
    pieces = [[[_pair(place) for place in piece]] for piece in ring_pieces(ring)]
    if len(pieces) == 1:
        return {"type": "Polygon", "coordinates": pieces[0]}
    return {"type": "MultiPolygon", "coordinates": pieces}


def track_kml(found: dict[str, Any], name: str) -> str:
    """Return the whole track as KML: fixes with times, forecasts, the next surfacing."""
    rows, ahead = found["each_dive"], found["next_dive"]
    kml = ElementTree.Element("kml", xmlns=KML)
    document = _within(kml, "Document", name=name)
    for key, colour in STYLES.items():
        style = ElementTree.SubElement(document, "Style", id=key)
        _within(style, "IconStyle", color=colour, scale="0.8")
        _within(style, "LineStyle", color=colour, width="2")
        _within(style, "PolyStyle", fill="0")
    ends = [place_in(row, "end_") for row in rows]
    track = [place_in(rows[0], "start_"), *ends]
    _placemark(document, "track", "track", _lines(track))
    fixes = _within(document, "Folder", name="surfacings")
    rings = _within(document, "Folder", name="forecasts, 90 %", visibility="0")
    for row, end in zip(rows, ends, strict=True):
        label = f"dive {row['dive']}"
        _placemark(fixes, label, "fix", _points(end), said_of_dive(row), row["end"])
        if row is not rows[0]:  # the first has no dive before it to learn from
            _placemark(rings, label, "forecast", _rings(ring_of(row)), hidden=True)
    goal = place_in(ahead, "")
    told = said_of_next(ahead)
    _placemark(document, "next surfacing", "next", _points(goal), told, ahead["time"])
    _placemark(document, "next surfacing, 90 %", "next", _rings(ring_of(ahead, NEXT)))
    for leg in found.get("aim") or []:
        target, way = place_in(leg, ""), [place_in(leg, which) for which in AIMED]
        _placemark(document, "waypoint", "aim", _points(target), leg["place"])
        _placemark(document, "way made good", "aim", _lines(way))
        _placemark(document, "aimed, 90 %", "aim", _rings(ring_of(leg, AIMED)))
    ElementTree.indent(kml)
    return '<?xml version="1.0" encoding="UTF-8"?>\n' + ElementTree.tostring(kml, "unicode") + "\n"


def _within(parent: Any, tag: str, **texts: str) -> Any:
    """Add an element, and an element with a text in it for each further argument."""
    made = ElementTree.SubElement(parent, tag)
    for key, text in texts.items():
        ElementTree.SubElement(made, key).text = plain(text)
    return made


def _placemark(
    parent: Any,
    name: str,
    style: str,
    shapes: list,
    said: str = "",
    when: str = "",
    hidden: bool = False,
) -> None:
    made = _within(parent, "Placemark", name=name)
    for key, text in (("visibility", "0" if hidden else ""), ("description", said)):
        if text:
            ElementTree.SubElement(made, key).text = plain(text)
    if when:
        _within(made, "TimeStamp", when=when)
    ElementTree.SubElement(made, "styleUrl").text = f"#{style}"
    if len(shapes) > 1:
        made = ElementTree.SubElement(made, "MultiGeometry")
    made.extend(shapes)


def _coordinates(shape: Any, places: Sequence[Place]) -> None:
    pairs = (_pair(place) for place in places)
    ElementTree.SubElement(shape, "coordinates").text = " ".join(f"{x},{y}" for x, y in pairs)


def _points(place: Place) -> list:
    point = ElementTree.Element("Point")
    _coordinates(point, line_pieces([place])[0])
    return [point]


def _lines(places: Sequence[Place]) -> list:
    made = []
    for piece in line_pieces(places):
        made.append(ElementTree.Element("LineString"))
        ElementTree.SubElement(made[-1], "tessellate").text = "1"
        _coordinates(made[-1], piece)
    return made


def _rings(ring: Sequence[Place]) -> list:
    made = []
    for piece in ring_pieces(ring):
        made.append(ElementTree.Element("Polygon"))
        outer = ElementTree.SubElement(made[-1], "outerBoundaryIs")
        _coordinates(ElementTree.SubElement(outer, "LinearRing"), piece)
    return made
