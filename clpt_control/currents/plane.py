"""A local plane in km: x1 east, x2 north, origin at a given place.

The plane is the azimuthal equidistant projection of the WGS84 ellipsoid
(J. P. Snyder, "Map Projections: A Working Manual", US Geological Survey
Professional Paper 1395, 1987, pages 191-202), by pyproj: distance and bearing
from the origin are true, and 50 km away lengths are off by 1e-5.

Away from the origin's meridian, north is not x2: it leans by the meridian
convergence, about dlon sin(lat), 0.3 degrees at the edge of a box of 70 km at
41 N.  Velocities are turned by it; their speed is kept.
"""

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from ..errors import DataError, needed

WIDEST = 1000.0  # km from the origin; beyond, lengths across are off by more than 0.4 %


@dataclass(frozen=True)
class LocalPlane:
    """The plane around one place.

    >>> plane = LocalPlane(41.0, -69.0)
    >>> x1, x2 = plane.to_plane(41.1, -69.0)
    >>> round(float(x1), 6) + 0.0, round(float(x2), 2)
    (0.0, 11.11)
    """

    lat: float  # of the origin, degrees north
    lon: float  # degrees east

    def __post_init__(self):
        if not (abs(self.lat) <= 90 and np.isfinite(self.lon)):
            raise DataError(
                f"origin ({self.lat}, {self.lon}): must be a latitude of -90 to 90 and a "
                "finite longitude, degrees"
            )

    @cached_property
    def _projection(self) -> Any:
        return needed("pyproj").Proj(
            proj="aeqd", ellps="WGS84", lat_0=self.lat, lon_0=self.lon, units="km"
        )

    def to_plane(self, lat: Any, lon: Any) -> tuple[np.ndarray, np.ndarray]:
        """Return x1 and x2 in km of places in degrees, 1000 km from the origin at most."""
        lat, lon = np.broadcast_arrays(np.asarray(lat, float), np.asarray(lon, float))
        x1, x2 = self._projection(lon, lat)
        distance = np.hypot(x1, x2)
        if not np.all(distance <= WIDEST):  # also where not finite
            raise DataError(
                f"a place is {np.max(distance):.4g} km from the origin ({self.lat:g}, "
                f"{self.lon:g}); a local plane is allowed {WIDEST:g} km: choose a smaller box"
            )
        return x1, x2

    def to_earth(self, x1: Any, x2: Any) -> tuple[np.ndarray, np.ndarray]:
        """Return latitude and longitude of points in km.

        The longitude lies within 180 degrees of the origin's.
        """
        x1, x2 = np.broadcast_arrays(np.asarray(x1, float), np.asarray(x2, float))
        lon, lat = self._projection(x1, x2, inverse=True)
        return lat, self.lon + (lon - self.lon + 180.0) % 360.0 - 180.0

    def turn(self, lat: Any, lon: Any, u: Any, v: Any) -> tuple[np.ndarray, np.ndarray]:
        """Turn velocities at places in degrees from east and north to x1 and x2."""
        lat, lon = np.broadcast_arrays(np.asarray(lat, float), np.asarray(lon, float))
        factors = self._projection.get_factors(lon, lat)
        # where east points in the plane
        angle = np.arctan2(factors.dy_dlam, factors.dx_dlam)
        # the directions east and north stay at a right angle to 1e-5 within 50 km
        c, s = np.cos(angle), np.sin(angle)
        return c * u - s * v, s * u + c * v
