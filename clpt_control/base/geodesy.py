"""Displacements between places on the WGS84 ellipsoid.

Geodesics by `pyproj.Geod` (C. F. F. Karney, "Algorithms for geodesics", J. Geod.
87, 43-55, 2013).  The displacement from A to B has the length s of the geodesic and
its azimuth a at A:

    east = s sin(a),  north = s cos(a).

A local plane, x1 east, x2 north, is the azimuthal equidistant projection of the ellipsoid (J. P.
Snyder, "Map Projections: A Working Manual", US Geological Survey Professional Paper 1395, 1987,
pages 191-202): distance and bearing from the origin are true, and 50 km away lengths are off by
1e-5.  Away from the origin's meridian, north leans from x2 by the meridian convergence, about
dlon sin(lat), 0.3 degrees at the edge of a box of 70 km at 41 N.  Velocities are rotated by it.
"""

from functools import cache
from math import atan2, cos, degrees, hypot, isfinite, nan, radians, sin
from typing import Any

import numpy as np

from .errors import DataError, import_optional

RADIUS = 6371e3  # m, of the Earth
LATEST = 1e11  # s since 1970: the year 5138, in milliseconds 1973
WIDEST = 1000.0  # km from the origin; beyond, lengths across are off by more than 0.4 %


@cache
def _ellipsoid() -> Any:
    return import_optional("pyproj").Geod(ellps="WGS84")


def is_place(lat: Any, lon: Any) -> Any:
    """Return True for latitudes and longitudes that are a place on Earth, degrees."""
    return (abs(lat) <= 90.0) & (abs(lon) <= 360.0)  # False for NaN


def check_place(time: float, *place: float) -> None:
    """Refuse a time that is no number of seconds since 1970, and a place that is none."""
    if not abs(time) < LATEST:
        message = "must be finite, s since 1970. Divide milliseconds by 1000"
        raise DataError(f"time {time:.15g}: {message}")
    if place and not is_place(*place):
        raise DataError(f"place {place}: must be latitude and longitude, degrees")


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


def convergence(lat: float, lon: float, east: float, north: float) -> float:
    """Return the angle from the axes at a place to those at the end of a displacement, rad.

    Anticlockwise, with directions along the geodesic as they are: it is s sin(a) tan(lat)/R.

    >>> round(convergence(60.0, 8.0, 10e3, 0.0), 6)  # 10 km tan(60)/6394 km
    0.002709
    """
    length, azimuth = hypot(east, north), degrees(atan2(east, north))
    *_, back = _ellipsoid().fwd(lon, lat, azimuth, length)
    return radians(angle_near(back + 180.0 - azimuth, 0.0))


def direction(east: float, north: float) -> float | None:
    """Return where a vector points, degrees clockwise from north; None where it has no length.

    >>> direction(-1.0, 0.0), direction(0.0, 0.0)
    (270.0, None)
    """
    if hypot(east, north) == 0.0:
        return None
    angle = degrees(atan2(east, north)) % 360.0
    return 0.0 if angle == 360.0 else angle  # of -1e-15


def check_near(distance: float) -> None:
    """Refuse a distance from the origin of a plane, km, that is too large or not finite."""
    if not distance <= WIDEST:
        raise DataError(
            f"a place is {distance:.4g} km from the origin, at most {WIDEST:g}. Choose a "
            "smaller box, or an origin in its middle, or correct swapped latitude and longitude"
        )


def angle_near(lon: Any, reference: Any) -> Any:
    """Return an angle plus full turns that is within 180 degrees of a reference.

    >>> angle_near(-179.5, 179.0)
    180.5
    """
    return reference + (lon - reference + 180.0) % 360.0 - 180.0


def east_of(lon: float) -> float:
    """Return a longitude between -180 and 180 degrees.

    >>> east_of(190.0), east_of(-180.0), east_of(180.0), east_of(-540.0)
    (-170.0, -180.0, 180.0, -180.0)
    """
    return lon if -180.0 <= lon <= 180.0 else angle_near(lon, 0.0)


class LocalPlane:
    """The plane around a place: latitude and longitude of its origin, degrees.

    >>> plane = LocalPlane(41.0, -69.0)
    >>> x1, x2 = plane.to_plane(41.1, -69.0)
    >>> round(float(x1), 6) + 0.0, round(float(x2), 2)
    (0.0, 11.11)
    """

    def __init__(self, lat: float, lon: float, unit: str = "km"):
        if not (abs(lat) <= 90 and np.isfinite(lon)):
            raise DataError(
                f"origin ({lat}, {lon}): must be latitude and longitude, degrees"
            )
        self.lat, self.lon = lat, lon
        self.widest = WIDEST if unit == "km" else 1000 * WIDEST
        aeqd = {"proj": "aeqd", "ellps": "WGS84", "units": unit}
        self._projection = import_optional("pyproj").Proj(aeqd, lat_0=lat, lon_0=lon)

    def _project(
        self, first: np.ndarray, second: np.ndarray, inverse: bool = False
    ) -> tuple[np.ndarray, np.ndarray]:
        # pyproj converts an array of one element to a number, which NumPy deprecates.
        if first.size != 1:
            return self._projection(first, second, inverse=inverse)
        pair = self._projection(first.item(), second.item(), inverse=inverse)
        return np.full(first.shape, pair[0]), np.full(first.shape, pair[1])

    def to_plane(self, lat: Any, lon: Any) -> tuple[np.ndarray, np.ndarray]:
        """Return x1 and x2 of places in degrees, 1000 km from the origin at most."""
        lat, lon = np.broadcast_arrays(lat, lon)
        x1, x2 = self._project(lon, lat)
        check_near(float(np.max(np.hypot(x1, x2))) / self.widest * WIDEST)
        return x1, x2

    def to_earth(self, x1: Any, x2: Any) -> tuple[np.ndarray, np.ndarray]:
        """Return latitude and longitude of points.

        The longitude lies within 180 degrees of the origin's.
        """
        x1, x2 = np.broadcast_arrays(x1, x2)
        lon, lat = self._project(x1, x2, inverse=True)
        return lat, angle_near(lon, self.lon)

    def rotate(
        self, lat: Any, lon: Any, u: Any, v: Any, inverse: bool = False
    ) -> tuple[np.ndarray, np.ndarray]:
        """Rotate velocities at places in degrees from east and north to x1 and x2, or back."""
        lat, lon = np.broadcast_arrays(lat, lon)
        factors = self._projection.get_factors(lon, lat)
        # where east points in the plane
        angle = np.arctan2(factors.dy_dlam, factors.dx_dlam)
        # the directions east and north stay at a right angle to 1e-5 within 50 km
        c, s = np.cos(angle), np.sin(-angle if inverse else angle)
        return c * u - s * v, s * u + c * v
