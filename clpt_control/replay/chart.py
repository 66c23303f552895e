"""A chart of small extent: Mercator on WGS84, metres of its middle latitude, and its grid.

Meridians and parallels are straight and angles are true (J. P. Snyder, "Map projections - a working
manual", USGS 1395, 1987, section 7).  Longitudes are counted from that of the first place, so
that no chart is cut at 180 degrees.
"""

from collections.abc import Sequence
from math import ceil, floor
from typing import Any

from .rings import Place, near
from .wording import east_of

STEPS = (0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 15, 30, 60, 120, 300, 600, 1800)  # minutes
LENGTHS = tuple(m * 10**n for n in range(1, 7) for m in (1, 2, 5))  # m, of scale bars
MOST = 89.5  # degrees; a Mercator chart has no pole
NARROWEST = 0.6  # height over width, and width over height
MARGIN = 0.06  # of the width, on each side
LEAST = 500.0  # m, of a side


class Chart:
    """A chart around places: `xy` gives m east and north of its middle.

    `west, east, south, north` are its edges, m; it is neither very wide nor very high.
    """

    def __init__(self, places: Sequence[Place]) -> None:
        from pyproj import Proj

        lats = [_shown(lat) for lat, _ in places]
        self.middle = (min(lats) + max(lats)) / 2
        self.first = places[0][1]
        self._proj: Any = Proj(proj="merc", ellps="WGS84", lat_ts=self.middle)
        self._zero = self._proj(0.0, self.middle)[1]
        points = [self.xy(*place) for place in places]
        spans = [(min(values), max(values)) for values in zip(*points, strict=True)]
        (west, east), (south, north) = spans
        size = max(east - west, north - south, LEAST)
        wide, high = (max(b - a, NARROWEST * size) + 2 * MARGIN * size for a, b in spans)
        x, y = (west + east) / 2, (south + north) / 2
        self.west, self.east, self.south, self.north = (
            x - wide / 2,
            x + wide / 2,
            y - high / 2,
            y + high / 2,
        )

    def xy(self, lat: float, lon: float) -> tuple[float, float]:
        """Return where a place (degrees) lies, m."""
        x = self._proj(1.0, 0.0)[0] * (near(lon, self.first) - self.first)
        return x, self._proj(0.0, _shown(lat))[1] - self._zero

    def place(self, x: float, y: float) -> Place:
        """Return what place lies there; longitude as counted from the first place."""
        lat = self._proj(0.0, y + self._zero, inverse=True)[1]
        return lat, self.first + x / self._proj(1.0, 0.0)[0]

    def grid(self, lines: int) -> tuple[float, list[float], float, list[float]]:
        """Return steps (minutes) and places (degrees) of parallels, then of meridians."""
        south, west = self.place(self.west, self.south)
        north, east = self.place(self.east, self.north)
        up, along = (step_of(span * 60 / lines) for span in (north - south, east - west))
        return up, _marks(south, north, up), along, _marks(west, east, along)


def _shown(lat: float) -> float:
    return min(max(lat, -MOST), MOST)


def step_of(minutes: float) -> float:
    """Return the step of a grid that is at least so many minutes.

    >>> step_of(1.2), step_of(7)
    (2, 10)
    """
    return next((step for step in STEPS if step >= minutes), STEPS[-1])


def length_of(metres: float) -> float:
    """Return the length of a scale bar, at most so many metres.

    >>> length_of(3400.0)
    2000
    """
    return next((length for length in reversed(LENGTHS) if length <= metres), LENGTHS[0])


def _marks(low: float, high: float, step: float) -> list[float]:
    first, last = ceil(60 * low / step), floor(60 * high / step)
    return [k * step / 60 for k in range(first, last + 1)]


def mark(angle: float, names: str, step: float) -> str:
    """Return degrees and minutes of a parallel ("NS") or meridian ("EW") of a grid.

    >>> mark(-42.9, "NS", 2), mark(190.505, "EW", 0.1), mark(8.0, "EW", 60)
    ("42°54'S", "169°29.7'W", '8°E')
    """
    angle = east_of(angle) if names == "EW" else angle
    decimals = 0 if step >= 1 else 1 if step >= 0.1 else 2
    whole, minutes = divmod(round(abs(angle) * 60, decimals), 60)
    letter = names[angle < 0]
    if step >= 60:
        return f"{whole:.0f}°{letter}"
    return f"{whole:.0f}°{minutes:0{2 + bool(decimals) + decimals}.{decimals}f}'{letter}"
