"""Places on charts: layers of a replay, and Mercator charts.

What is drawn of a replay are layers, made of what `clpt replay --json` prints.  A layer
is a point, a line or a ring, by the name of a GeoJSON geometry; its kind says what it is.  Four
writers take them: the map of the page, map.png, GeoJSON and KML.

The ring of a forecast, with half axes a and b and the bearing B of the long one, is

    centre + a cos(s) (sin B, cos B) + b sin(s) (-cos B, sin B),   s = 0 .. 2 pi,

east and north at the start of the dive, where its covariance is resolved: counter-clockwise.

A chart of small extent is Mercator on WGS84, in metres of its middle latitude.
Meridians and parallels are straight and angles are true (J. P. Snyder, "Map projections - a working
manual", USGS 1395, 1987, section 7).  Longitudes are counted from that of the first place, so
that no chart is cut at 180 degrees.
"""

from collections import defaultdict
from collections.abc import Iterable, Sequence
from functools import lru_cache
from itertools import product
from math import ceil, cos, floor, pi, radians, sin
from typing import Any, NamedTuple

import numpy as np

from ..errors import needed
from ..geodesy import displacement, near, place_from
from .cells import half_axes
from .places import Place, compass, degrees_minutes, east_of, velocity
from .wording import within

DIVE, NEXT, AIMED = ("start_", "forecast_"), ("from_", ""), ("from_", "end_")  # start, centre
CORNERS = 48
LAST = 12  # dives whose ellipses are always drawn
STEPS = (0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 15, 30, 60, 120, 300, 600, 1800)  # minutes
LENGTHS = tuple(m * 10**n for n in range(1, 7) for m in (1, 2, 5))  # m, of scale bars
MOST = 89.5  # degrees; a Mercator chart has no pole
NARROWEST = 0.6  # height over width, and width over height
MARGIN = 0.06  # of the width, on each side
LEAST = 500.0  # m, of a side


def place_in(row: dict[str, Any], which: str) -> Place:
    """Return a place of a row, such as its ``"end_"``."""
    return row[f"{which}latitude"], row[f"{which}longitude"]


def ring_of(row: dict[str, Any], kind: tuple[str, str] = DIVE) -> list[Place]:
    """Return the closed ring of the 90 % ellipse of a dive, of the next one or of an aimed one."""
    sizes = (row[f"ellipse_90_{name}"] for name in ("long", "short", "bearing"))
    return _ring(*(place_in(row, which) for which in kind), *sizes)


@lru_cache(10_000)  # a watch draws all its dives again with each new one
def _ring(begin: Place, end: Place, long: float, short: float, bearing: float) -> list[Place]:
    east, north = displacement(*begin, *end)
    sine, cosine = sin(radians(bearing)), cos(radians(bearing))
    places = []
    for k in range(CORNERS):
        along, across = long * cos(2 * pi * k / CORNERS), short * sin(2 * pi * k / CORNERS)
        away = along * sine - across * cosine, along * cosine + across * sine
        places.append(place_from(*begin, east + away[0], north + away[1]))
    return [*places, places[0]]


class Chart:
    """A chart around places: `xy` gives m east and north of its middle.

    `west, east, south, north` are its edges, m; it is neither very wide nor very high.
    """

    def __init__(self, places: Sequence[Place]) -> None:
        lats, lons = np.transpose(places)
        if not (np.abs(lats) <= 90.0).all():
            raise ValueError("a latitude is beyond the poles")
        ends = _below_the_poles(np.array([lats.min(), lats.max()]))
        self.middle = ends.sum().item() / 2
        self.first = places[0][1]
        self._proj = needed("pyproj").Proj(proj="merc", ellps="WGS84", lat_ts=self.middle)
        self._degree = self._proj(1.0, 0.0)[0]  # m along the middle
        self._zero = self._proj(0.0, self.middle)[1]
        spans = [(one.min().item(), one.max().item()) for one in self.xy(lats, lons)]
        (west, east), (south, north) = spans
        size = max(east - west, north - south, LEAST)
        wide, high = (max(b - a, NARROWEST * size) + 2 * MARGIN * size for a, b in spans)
        x, y = (west + east) / 2, (south + north) / 2
        self.west, self.east = x - wide / 2, x + wide / 2
        self.south, self.north = y - high / 2, y + high / 2

    def xy(self, lat: Any, lon: Any) -> tuple[Any, Any]:
        """Return where a place (degrees) lies, m, or where many do."""
        x = self._degree * (near(lon, self.first) - self.first)
        lat = np.asarray(_below_the_poles(lat))
        # as lists: pyproj takes an array of one for a number
        y = np.asarray(self._proj((0.0 * lat).tolist(), lat.tolist())[1])[()]
        return x, y - self._zero

    def place(self, x: float, y: float) -> Place:
        """Return what place lies there; longitude as counted from the first place."""
        lat = self._proj(0.0, y + self._zero, inverse=True)[1]
        return lat, self.first + x / self._degree

    def grid(self, lines: int) -> tuple[float, list[float], float, list[float]]:
        """Return steps (minutes) and places (degrees) of parallels, then of meridians."""
        south, west = self.place(self.west, self.south)
        north, east = self.place(self.east, self.north)
        up, along = (step_of(span * 60 / lines) for span in (north - south, east - west))
        return up, _marks(south, north, up), along, _marks(west, east, along)


def _below_the_poles(lat: Any) -> Any:
    return np.clip(lat, -MOST, MOST)


def step_of(minutes: float) -> float:
    """Return the step of a grid that is at least so many minutes.

    >>> step_of(1.2), step_of(7)
    (2, 10)
    """
    return next((step for step in STEPS if step >= minutes), STEPS[-1])


def bar_of(metres: float) -> tuple[float, str]:
    """Return the length of a scale bar, at most so many metres, and its name.

    >>> bar_of(3400.0)
    (2000, '2 km')
    """
    length = next((length for length in reversed(LENGTHS) if length <= metres), LENGTHS[0])
    return length, f"{length / 1000:g} km" if length >= 1000 else f"{length:g} m"


def _marks(low: float, high: float, step: float) -> list[float]:
    first, last = ceil(60 * low / step), floor(60 * high / step)
    return [k * step / 60 for k in range(first, last + 1)]


def grid_label(angle: float, names: str, step: float) -> str:
    """Return degrees and minutes of a parallel ("NS") or meridian ("EW") of a grid.

    >>> grid_label(-42.9, "NS", 2), grid_label(190.505, "EW", 0.1), grid_label(8.0, "EW", 60)
    ("42°54'S", "169°29.7'W", '8°E')
    """
    angle = east_of(angle) if names == "EW" else angle
    decimals = 0 if step >= 1 else 1 if step >= 0.1 else 2
    whole, minutes = degrees_minutes(angle, decimals)
    letter = names[angle < 0]
    return f"{whole}°{letter}" if step >= 60 else f"{whole}°{minutes}'{letter}"


def with_room(points: np.ndarray, tried: Iterable[int], room: tuple[float, float]) -> list[int]:
    """Return which of those that are tried have room for a number beside points, (n, 2)."""
    cells = np.floor(points / room).astype(int).tolist()
    there: dict[tuple[int, int], list[int]] = defaultdict(list)
    found = []
    for k in tried:
        i, j = cells[k]
        beside = product((i - 1, i, i + 1), (j - 1, j, j + 1))
        around = [n for cell in beside for n in there.get(cell, ())]
        if (np.abs(points[around] - points[k]) >= room).any(1).all():
            found.append(k)
            there[i, j].append(k)
    return found


class Layer(NamedTuple):
    """Places, the row, next dive or leg that they are `of`, words on it, and its time."""

    kind: str
    shape: str
    places: list[Place]
    of: dict[str, Any]
    words: str = ""
    when: str = ""


def words_of_next(ahead: dict[str, Any]) -> str:
    """Return the popup's words on the next surfacing."""
    bearing = compass(ahead["ellipse_90_bearing"])
    when = f"{ahead['time']} {within(ahead)}"
    return f"{when}, {ahead['place']}; 90 % within {half_axes(ahead)} m, the long axis to {bearing}"


def words_of_dive(row: dict[str, Any]) -> str:
    """Return the popup's words on a dive."""
    miss = row["clpe"]["adaptive"]
    return (
        f"surfaced {row['end']}, {miss:.0f} m from the forecast, "
        f"{'in' if row['inside_90'] else 'outside'} its 90 % ellipse; current "
        f"{velocity(row['current_east'], row['current_north'])}"
    )


def drawn_dives(rows: Sequence[dict[str, Any]]) -> list[dict[str, Layer]]:
    """Return the layers of each dive by kind, as they are drawn; the first has no forecast."""
    found: list[dict[str, Layer]] = []
    before = None
    for row in rows:
        start, end, reckoned, forecast = (
            place_in(row, which) for which in ("start_", "end_", "reckoned_", "forecast_")
        )
        layers = [
            Layer("ring", "Polygon", ring_of(row), row),
            Layer("drift", "LineString", [before or start, start], row),
            Layer("miss", "LineString", [reckoned, end], row),
            Layer("track", "LineString", [start, end], row),
            Layer("reckoned", "Point", [reckoned], row),
            Layer("forecast", "Point", [forecast], row),
            Layer("fix", "Point", [end], row, words_of_dive(row), row["end"]),
        ]
        none = () if before else ("ring", "drift", "forecast")
        found.append({layer.kind: layer for layer in layers if layer.kind not in none})
        before = end
    return found


def layers_ahead(ahead: dict[str, Any] | None, legs: Sequence[dict[str, Any]]) -> list[Layer]:
    """Return what is drawn of the next dive and of each leg to a waypoint."""
    found = []
    if ahead is not None:
        last, goal = (place_in(ahead, which) for which in NEXT)
        found = [
            Layer("way", "LineString", [last, goal], ahead),
            Layer("next", "Point", [goal], ahead, words_of_next(ahead), ahead["time"]),
            Layer("ring next", "Polygon", ring_of(ahead, NEXT), ahead, when=ahead["time"]),
        ]
    for leg in legs:
        target, (begin, end) = place_in(leg, ""), (place_in(leg, which) for which in AIMED)
        found += [
            Layer("target", "Point", [target], leg, leg["place"]),
            Layer("aim", "LineString", [begin, target], leg),
            Layer("made", "LineString", [begin, end], leg),
            Layer("ring aimed", "Polygon", ring_of(leg, AIMED), leg, when=leg["end"]),
        ]
    return found
