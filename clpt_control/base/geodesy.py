"""Displacements between places on the WGS84 ellipsoid.

Geodesics by `pyproj.Geod` (C. F. F. Karney, "Algorithms for geodesics", J. Geod.
87, 43-55, 2013).  The displacement from A to B has the length s of the geodesic and
its azimuth a at A:

    east = s sin(a),  north = s cos(a).
"""

from functools import cache
from math import atan2, cos, degrees, hypot, isfinite, nan, radians, sin
from typing import Any

from .errors import import_optional


@cache
def _ellipsoid() -> Any:
    return import_optional("pyproj").Geod(ellps="WGS84")


def is_place(lat: Any, lon: Any) -> Any:
    """Return True for latitudes and longitudes that are a place on Earth, degrees."""
    return (abs(lat) <= 90.0) & (abs(lon) <= 360.0)  # False for NaN


def displacement(
    lat1: float, lon1: float, lat2: float, lon2: float
) -> tuple[float, float]:
    """Return the displacement east and north (m) between two places (degrees).

    East and north are those at the first place; NaN if one is no place on Earth.

    >>> east, north = displacement(-43.0, 8.0, -42.9, 8.0)
    >>> round(east, 6) + 0.0, round(north, 1)
    (0.0, 11109.2)
    """
    if not (is_place(lat1, lon1) and is_place(lat2, lon2)):
        return nan, nan
    azimuth, _, length = _ellipsoid().inv(lon1, lat1, lon2, lat2)
    return length * sin(radians(azimuth)), length * cos(radians(azimuth))


def distance(lat1: float, lon1: float, lat2: float, lon2: float) -> float:
    """Return the length (m) of the geodesic between two places (degrees); NaN if one is none."""
    return hypot(*displacement(lat1, lon1, lat2, lon2))


def place_from(
    lat: float, lon: float, east: float, north: float
) -> tuple[float, float]:
    """Return the place (degrees) at the end of a displacement (m) from a place.

    NaN if a number is not finite.

    >>> round(place_from(-43.0, 8.0, *displacement(-43.0, 8.0, -42.9, 8.1))[1], 9)
    8.1
    """
    length = hypot(east, north)
    if not (is_place(lat, lon) and isfinite(length)):
        return nan, nan
    lon2, lat2, _ = _ellipsoid().fwd(lon, lat, degrees(atan2(east, north)), length)
    return lat2, lon2


def angle_near(lon: Any, reference: Any) -> Any:
    """Return an angle plus full turns that is within 180 degrees of a reference.

    >>> angle_near(-179.5, 179.0)
    180.5
    """
    return reference + (lon - reference + 180.0) % 360.0 - 180.0
