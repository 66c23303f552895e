"""What fixes alone say of a vehicle: its drift at the surface, its way over ground.

    drift before a dive = start of the dive - end of the dive before,

where the numbers of the two follow one another; where they do not, or the dive is the first
known, from the first fix of the surfacing (GPS1), if the file has it.  Ways are geodesics.
"""

from collections.abc import Sequence
from math import hypot, isfinite
from statistics import median
from typing import Any, NamedTuple

from ..geodesy import displacement
from ..gliders.dives import Dive
from .wording import direction

SHORTEST = 60.0  # s; a fix of 4 m makes more than 0.1 m/s of less
LONGEST = 86400.0  # s; who is longer at the surface does not only wait for a fix


class Way(NamedTuple):
    """A way over ground: m east and north, and the time it took, s."""

    east: float
    north: float
    seconds: float

    def as_dict(self) -> dict[str, float | None]:
        """Return length (m), speed (m/s), direction (degrees) and time (s), None if unknown."""
        length = hypot(self.east, self.north)
        long = self.seconds >= SHORTEST
        return {
            "distance": length,
            "duration": self.seconds,
            "speed": length / self.seconds if long else None,
            "direction": direction(self.east, self.north),
        }


def drift(dive: Dive, before: Dive | None) -> Way | None:
    """Return the drift at the surface before a dive; None where it is not known."""
    fix: tuple[Any, Any, Any] = dive.t_gps1, dive.lat_gps1, dive.lon_gps1
    if before is not None and dive.number == before.number + 1:
        fix = before.t_gpse, before.lat_gpse, before.lon_gpse
    if any(value is None or not isfinite(value) for value in fix):
        return None
    seconds = dive.t_gps2 - fix[0]
    way = displacement(*fix[1:], dive.lat_gps2, dive.lon_gps2)
    known = 0.0 <= seconds <= LONGEST and isfinite(way[0])
    return Way(*way, seconds) if known else None


def over_ground(dive: Dive) -> Way:
    """Return a dive's way from fix to fix."""
    return Way(dive.gps_east, dive.gps_north, dive.duration)


def drifts(dives: Sequence[Dive]) -> list[Way | None]:
    """Return the drift before each dive."""
    return [drift(d, dives[k - 1] if k else None) for k, d in enumerate(dives)]


def at_the_surface(dives: Sequence[Dive]) -> float:
    """Return how long the vehicle stays up between dives, s: the median; zero if not known."""
    return float(median([way.seconds for way in drifts(dives) if way is not None] or [0.0]))
