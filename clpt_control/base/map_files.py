"""GeoJSON (RFC 7946) and KML 2.2 (OGC 07-147r2): documents of points, lines and rings.

Places are WGS84, longitude first, in degrees, counted on where a line or a ring crosses 180
degrees.  Text in KML loses characters that XML does not have.

The ring of a region with half axes a and b, and the bearing B of the long one, is

    centre + a cos(s) (sin B, cos B) + b sin(s) (-cos B, sin B),   s = 0 .. 2 pi,

east and north at an origin: counter-clockwise.
"""

import json
from collections.abc import Iterable
from math import cos, pi, radians, sin
from typing import Any, NamedTuple

import numpy as np

from .geodesy import angle_near, east_of, place_from
from .html import safe

DIGITS = 6  # decimals of a degree: 0.1 m
CORNERS = 48  # of a ring
# colours of KML: aabbggrr
BLUE, GREEN = "ffb27200", "ff739e00"
PURPLE, ORANGE = "ffa779cc", "ff009fe6"
NAMESPACE = "http://www.opengis.net/kml/2.2"
SHAPES = {  # of KML, around coordinates
    "Point": ("<Point>", "</Point>"),
    "LineString": ("<LineString><tessellate>1</tessellate>", "</LineString>"),
    "Polygon": (
        "<Polygon><outerBoundaryIs><LinearRing>",
        "</LinearRing></outerBoundaryIs></Polygon>",
    ),
}


class Feature(NamedTuple):
    """A point, line or ring on a map."""

    name: str
    shape: str  # Point, LineString or Polygon
    places: Any  # latitude and longitude of each point, degrees, (n, 2)
    colour: str  # of KML: aabbggrr
    time: str = ""  # ISO 8601
    description: str = ""
    properties: dict[str, Any] = {}  # noqa: RUF012 - never changed; of GeoJSON


def ring(
    origin: tuple[float, float],
    centre: tuple[float, float],
    long: float,
    short: float,
    bearing: float,
) -> list[tuple[float, float]]:
    """Return the closed ring of an ellipse; the centre is east and north of the origin, m."""
    sine, cosine = sin(radians(bearing)), cos(radians(bearing))
    angle = 2 * pi * (np.arange(CORNERS + 1) % CORNERS) / CORNERS
    along_axis, across = long * np.cos(angle), short * np.sin(angle)
    east = centre[0] + along_axis * sine - across * cosine
    north = centre[1] + along_axis * cosine + across * sine
    return [place_from(*origin, *away) for away in zip(east, north, strict=True)]


def coordinates(places: Any) -> list[list[float]]:
    """Return longitudes and latitudes of places; the first longitude is in -180..180."""
    first_longitude = east_of(places[0][1])
    return [
        [
            round(float(angle_near(lon, first_longitude)), DIGITS),
            round(float(lat), DIGITS),
        ]
        for lat, lon in places
    ]


def geojson(features: Iterable[Feature]) -> str:
    """Return features as a GeoJSON document."""
    lines = ",\n".join(
        json.dumps(_geojson_feature(feature), allow_nan=False) for feature in features
    )
    return f'{{"type": "FeatureCollection", "features": [\n{lines}\n]}}\n'


def _geojson_feature(feature: Feature) -> dict[str, Any]:
    points = coordinates(feature.places)
    nested = {"Point": points[0], "Polygon": [points]}.get(feature.shape, points)
    return {
        "type": "Feature",
        "geometry": {"type": feature.shape, "coordinates": nested},
        "properties": {"name": feature.name, **feature.properties},
    }


def kml(features: Iterable[Feature], name: str) -> str:
    """Return features as a KML document with a name."""
    features = [*features]
    lines = [
        '<?xml version="1.0" encoding="UTF-8"?>',
        f'<kml xmlns="{NAMESPACE}"><Document><name>{safe(name)}</name>',
        *map(_style, dict.fromkeys(feature.colour for feature in features)),
        *map(_placemark, features),
        "</Document></kml>",
    ]
    return "\n".join(lines) + "\n"


def _style(colour: str) -> str:
    return (
        f'<Style id="{colour}"><IconStyle><color>{colour}</color><scale>0.8</scale></IconStyle>'
        f"<LineStyle><color>{colour}</color><width>2</width></LineStyle>"
        "<PolyStyle><fill>0</fill></PolyStyle></Style>"
    )


def _placemark(feature: Feature) -> str:
    texts = [f"<name>{safe(feature.name)}</name>"]
    if feature.description:
        texts.append(f"<description>{safe(feature.description)}</description>")
    if feature.time and feature.shape == "Point":
        texts.append(f"<TimeStamp><when>{safe(feature.time)}</when></TimeStamp>")
    texts.append(f"<styleUrl>#{feature.colour}</styleUrl>")
    begin, end = SHAPES[feature.shape]
    points = " ".join(f"{lon},{lat}" for lon, lat in coordinates(feature.places))
    return f"<Placemark>{''.join(texts)}{begin}<coordinates>{points}</coordinates>{end}</Placemark>"
