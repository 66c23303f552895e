"""Rings and lines of places, degrees, as charts take them: whole, or cut at 180 degrees east.

The ring of a forecast, with half axes a and b and the bearing B of the long one, is

    centre + a cos(s) (sin B, cos B) + b sin(s) (-cos B, sin B),   s = 0 .. 2 pi,

east and north at the start of the dive, where its covariance is resolved: counter-clockwise.
What crosses 180 degrees is cut there (RFC 7946, sections 3.1.6 and 3.1.9).
"""

from collections.abc import Sequence
from itertools import pairwise
from math import cos, pi, radians, sin
from typing import Any

from ..geodesy import displacement, place_from

Place = tuple[float, float]  # degrees north, degrees east
DIVE, NEXT, AIMED = ("start_", "forecast_"), ("from_", ""), ("from_", "end_")  # start, centre
CORNERS = 48
HALF = 180.0


def place_in(row: dict[str, Any], which: str) -> Place:
    """Return a place of a row, such as its ``"end_"``."""
    return row[f"{which}latitude"], row[f"{which}longitude"]


def ring_of(row: dict[str, Any], kind: tuple[str, str] = DIVE) -> list[Place]:
    """Return the closed ring of the 90 % ellipse of a dive, of the next one or of an aimed one."""
    begin, end = (place_in(row, which) for which in kind)
    east, north = displacement(*begin, *end)
    long, short = row["ellipse_90_long"], row["ellipse_90_short"]
    turn = radians(row["ellipse_90_bearing"])
    places = []
    for k in range(CORNERS):
        along, across = long * cos(2 * pi * k / CORNERS), short * sin(2 * pi * k / CORNERS)
        away = along * sin(turn) - across * cos(turn), along * cos(turn) + across * sin(turn)
        places.append(place_from(*begin, east + away[0], north + away[1]))
    return [*places, places[0]]


def near(lon: float, other: float) -> float:
    """Return a longitude, counted on so that it lies within 180 degrees of another.

    >>> near(-179.5, 179.0)
    180.5
    """
    return other + (lon - other + HALF) % 360.0 - HALF


def unbroken(places: Sequence[Place]) -> list[Place]:
    """Return places with each longitude counted on from the one before; the first in -180..180."""
    found: list[Place] = []
    for lat, lon in places:
        found.append((lat, near(lon, found[-1][1] if found else 0.0)))
    return found


def line_pieces(places: Sequence[Place]) -> list[list[Place]]:
    """Return a line, cut where it crosses 180 degrees; longitudes are in -180..180.

    >>> line_pieces([(0.0, 179.0), (1.0, -179.0)])
    [[(0.0, 179.0), (0.5, 180.0)], [(0.5, -180.0), (1.0, -179.0)]]
    """
    whole = unbroken(places)
    pieces = [[(whole[0][0], near(whole[0][1], 0.0))]]
    for (lat1, lon1), (lat2, lon2) in pairwise(whole):
        last = pieces[-1][-1][1]
        end = last + lon2 - lon1
        if abs(end) > HALF:
            edge = HALF if end > 0 else -HALF
            lat = lat1 + (lat2 - lat1) * (edge - last) / (end - last)
            pieces[-1].append((lat, edge))
            pieces.append([(lat, -edge)])
            end -= 2 * edge
        pieces[-1].append((lat2, end))
    return [piece for piece in pieces if len(set(piece)) > 1] or pieces[:1]


def ring_pieces(ring: Sequence[Place]) -> list[list[Place]]:
    """Return a closed convex ring, cut along 180 degrees into one or two."""
    whole = unbroken(ring)[:-1]
    pieces = []
    for turns in (-360.0, 0.0, 360.0):
        part = [(lat, lon + turns) for lat, lon in whole]
        part = _kept(_kept(part, HALF, 1.0), -HALF, -1.0)
        if len(part) > 2:
            pieces.append([*part, part[0]])
    return pieces


def _kept(ring: list[Place], edge: float, sign: float) -> list[Place]:
    """Return what a meridian leaves of a ring: sign * (longitude - edge) <= 0."""
    kept: list[Place] = []
    for (lat1, lon1), (lat2, lon2) in zip(ring, [*ring[1:], *ring[:1]], strict=True):
        inside, next_inside = sign * (lon1 - edge) <= 0, sign * (lon2 - edge) <= 0
        if inside:
            kept.append((lat1, lon1))
        if inside != next_inside and edge not in (lon1, lon2):
            kept.append((lat1 + (lat2 - lat1) * (edge - lon1) / (lon2 - lon1), edge))
    return kept
