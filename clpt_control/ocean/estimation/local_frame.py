"""Local frame of a scenario: its plane and its time, in units of length and time.

Outside: m, m/s to the east and to the north, s since 1970 UTC, degrees.  Inside: the plane around
the origin, x1 and x2 (`base.geodesy`), with t = 0 at a given time.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ...base.geodesy import LocalPlane
from ...base.units import METRES, SECONDS
from ...paper.scenario.tables import Units

Pair = tuple[float, float]


@dataclass(frozen=True)
class LocalFrame:
    """Frame with its origin at a time (s since 1970 UTC) and a place (degrees)."""

    time: float
    place: Pair
    units: Units

    @cached_property
    def plane(self) -> LocalPlane:
        """Plane around the origin."""
        return LocalPlane(*self.place, self.units.length)

    @property
    def metres(self) -> float:
        """Size of the unit of length, m."""
        return METRES[self.units.length]

    @property
    def seconds(self) -> float:
        """Size of the unit of time, s."""
        return SECONDS[self.units.time]

    def own_time(self, time: float) -> float:
        """Return a time since t = 0."""
        return (time - self.time) / self.seconds

    def date(self, t: float) -> float:
        """Return a time of the frame in s since 1970 UTC."""
        return self.time + t * self.seconds

    def point(self, latitude: float, longitude: float) -> np.ndarray:
        """Return a place as a point, (2,)."""
        return _numbers(self.plane.to_plane(latitude, longitude))

    def position(self, point: np.ndarray) -> Pair:
        """Return latitude and longitude of a point."""
        latitude, longitude = _numbers(self.plane.to_earth(*point))
        return float(latitude), float(longitude)

    def displacement(self, point: np.ndarray, east: float, north: float) -> np.ndarray:
        """Return a displacement from a point as one in the plane, (2,)."""
        rotated = self.plane.rotate(*self.position(point), east, north)
        return _numbers(rotated) / self.metres

    def velocity(self, point: np.ndarray, velocity: np.ndarray) -> Pair:
        """Return a velocity in the plane as m/s to the east and to the north."""
        place = self.position(point)
        east = _numbers(self.plane.rotate(*place, 1.0, 0.0))
        north = _numbers(self.plane.rotate(*place, 0.0, 1.0))
        size = self.metres / self.seconds
        return float(east @ velocity) * size, float(north @ velocity) * size


def _numbers(pair: tuple[np.ndarray, np.ndarray]) -> np.ndarray:
    return np.array([float(x) for x in pair])
