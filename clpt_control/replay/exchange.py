"""A replay for other programs: GeoJSON (RFC 7946) and KML 2.2 (OGC 07-147r2).

Both are made of what `clpt replay --json` prints.  Places are WGS84, longitude first; rings turn
counter-clockwise; nothing crosses 180 degrees.  A text of a file loses characters that XML
does not have.
"""

import json
from typing import Any
from xml.etree import ElementTree

from ..html import plain
from .chart import Layer, Place, dive_layers, layers_ahead, line_pieces, ring_pieces

DIGITS = 6  # decimals of a degree: 0.1 m
KML = "http://www.opengis.net/kml/2.2"
STYLES = {  # colours as KML has them: alpha, blue, green, red
    "track": "ffb27200",
    "fix": "ffb27200",
    "forecast": "ff739e00",
    "next": "ffa779cc",
    "aim": "ff009fe6",
}
FEATURES = {  # kind of a layer: its name in GeoJSON
    "last": "last fix",
    "way": "way to the next surfacing",
    "next": "next surfacing",
    "ring next": "90 % ellipse",
    "target": "waypoint",
    "made": "way made good",
    "ring aimed": "90 % ellipse, aimed",
}
PLACEMARKS = {  # kind of a layer: its name in KML and its style
    "next": ("next surfacing", "next"),
    "ring next": ("next surfacing, 90 %", "next"),
    "target": ("waypoint", "aim"),
    "made": ("way made good", "aim"),
    "ring aimed": ("aimed, 90 %", "aim"),
}


def _pieces(layer: Layer) -> list[list[list[float]]]:
    """Return longitudes and latitudes of a layer, cut at 180 degrees."""
    cut = ring_pieces if layer.shape == "Polygon" else line_pieces
    return [[_pair(place) for place in piece] for piece in cut(layer.places)]


def _pair(place: Place) -> list[float]:
    return [round(place[1], DIGITS), round(place[0], DIGITS)]


def next_geojson(found: dict[str, Any]) -> str:
    """Return the next surfacing as GeoJSON: last fix, way, forecast, 90 % ellipse, waypoints."""
    way, goal, ring, *legs = layers_ahead(found["next_dive"], found.get("aim") or [])
    end = found["each_dive"][-1]
    last = Layer("last", "Point", way.places[:1], {"dive": end["dive"], "time": end["end"]})
    features = [
        _feature(layer) for layer in (last, way, ring, goal, *legs) if layer.kind in FEATURES
    ]
    lines = ",\n".join(json.dumps(feature, allow_nan=False) for feature in features)
    return f'{{"type": "FeatureCollection", "features": [\n{lines}\n]}}\n'


def _feature(layer: Layer) -> dict[str, Any]:
    more: dict[str, Any] = {"time": layer.when} if layer.when else {}
    if layer.shape == "Point":
        more = {"description": layer.words} if layer.kind == "next" else {}
        more |= {key: value for key, value in layer.of.items() if value is not None}
    pieces: list[Any] = _pieces(layer)
    shapes = {"Point": [piece[0] for piece in pieces], "Polygon": [[piece] for piece in pieces]}
    each = shapes.get(layer.shape, pieces)
    several = len(each) > 1
    kind, coordinates = (f"Multi{layer.shape}", each) if several else (layer.shape, each[0])
    return {
        "type": "Feature",
        "geometry": {"type": kind, "coordinates": coordinates},
        "properties": {"name": FEATURES[layer.kind], **more},
    }


def track_kml(found: dict[str, Any], name: str) -> str:
    """Return the whole track as KML: fixes with times, forecasts, the next surfacing."""
    kml = ElementTree.Element("kml", xmlns=KML)
    document = _within(kml, "Document", name=name)
    for key, colour in STYLES.items():
        style = ElementTree.SubElement(document, "Style", id=key)
        _within(style, "IconStyle", color=colour, scale="0.8")
        _within(style, "LineStyle", color=colour, width="2")
        _within(style, "PolyStyle", fill="0")
    dives = [{layer.kind: layer for layer in each} for each in dive_layers(found["each_dive"])]
    track = [dives[0]["track"].places[0], *(each["fix"].places[0] for each in dives)]
    _placemark(document, "track", "track", Layer("track", "LineString", track, {}))
    fixes = _within(document, "Folder", name="surfacings")
    rings = _within(document, "Folder", name="forecasts, 90 %", visibility="0")
    for each in dives:
        label = f"dive {each['fix'].of['dive']}"
        _placemark(fixes, label, "fix", each["fix"])
        if "ring" in each:
            _placemark(rings, label, "forecast", each["ring"], hidden=True)
    for layer in layers_ahead(found["next_dive"], found.get("aim") or []):
        if layer.kind in PLACEMARKS:
            _placemark(document, *PLACEMARKS[layer.kind], layer)
    ElementTree.indent(kml)
    return '<?xml version="1.0" encoding="UTF-8"?>\n' + ElementTree.tostring(kml, "unicode") + "\n"


def _within(parent: Any, tag: str, **texts: str) -> Any:
    """Add an element, and an element with a text in it for each further argument."""
    made = ElementTree.SubElement(parent, tag)
    for key, text in texts.items():
        ElementTree.SubElement(made, key).text = plain(text)
    return made


def _placemark(parent: Any, name: str, style: str, layer: Layer, hidden: bool = False) -> None:
    texts = {"name": name, "visibility": "0" if hidden else "", "description": layer.words}
    made = _within(parent, "Placemark", **{key: text for key, text in texts.items() if text})
    if layer.when and layer.shape == "Point":
        _within(made, "TimeStamp", when=layer.when)
    _within(made, "styleUrl").text = f"#{style}"
    pieces = _pieces(layer)
    parent = ElementTree.SubElement(made, "MultiGeometry") if len(pieces) > 1 else made
    for piece in pieces:
        shape = ElementTree.SubElement(parent, layer.shape)
        if layer.shape == "LineString":
            _within(shape, "tessellate").text = "1"
        if layer.shape == "Polygon":
            shape = _within(_within(shape, "outerBoundaryIs"), "LinearRing")
        pairs = piece[:1] if layer.shape == "Point" else piece
        _within(shape, "coordinates").text = " ".join(f"{x},{y}" for x, y in pairs)
