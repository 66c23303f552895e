"""The map of a replay's page: SVG whose marks keep their size when it is zoomed.

It is `WIDTH` units wide, y down.  A mark is a group at its place; what is in it is scaled by the
style sheet.  Numbers of dives have the zoom from which they have room: `n0` on a telephone, each
next one at twice the scale.
"""

from collections.abc import Iterable, Sequence
from itertools import islice
from math import atan2, degrees, hypot
from typing import Any

import numpy as np

from ..geodesy import displacement
from ..html import safe
from . import chart
from .places import Place, compass

WIDTH = 1000.0
LINES = 5  # of the grid, about
ROOM = (34.0, 15.0)  # of a number, px
PHONE = 0.36  # px per unit where a telephone shows the map
LEVELS = 7
CORNER = 60.0  # units above the lower edge, where meridians have their names
LARGER = 1.6  # times, that a waypoint may make the chart
EDGE = 26.0  # units, of an arrow from the edge
ARROW = "M0-11 7 6 0 2-7 6Z"
STAR = "M0-10 2.4-3.2 9.5-3.1 3.8 1.2 5.9 8.1 0 4 -5.9 8.1 -3.8 1.2 -9.5-3.1 -2.4-3.2Z"
MARKS = {  # kind of a point: its style and its shape
    "reckoned": ("reckoned", "M-4-4 4 4M-4 4 4-4"),
    "forecast": ("forecast", "M-5.5 0H5.5M0-5.5V5.5"),
    "next": ("star", STAR),
    "target": ("target", "M0-9A9 9 0 1 1-.01-9ZM-13 0H13M0-13V13"),
}


class Drawing:
    """A chart in units of the SVG."""

    def __init__(self, places: Sequence[Place]) -> None:
        self.chart = chart.Chart(places)
        self.metres = (self.chart.east - self.chart.west) / WIDTH  # per unit
        self.height = (self.chart.north - self.chart.south) / self.metres

    def at(self, place: Any) -> tuple[Any, Any]:
        """Return where a place is drawn, or where many are: their latitudes, their longitudes."""
        x, y = self.chart.xy(*place)
        return (x - self.chart.west) / self.metres, (self.chart.north - y) / self.metres

    def points(self, places: Any) -> list[str]:
        """Return where places, (n, 2), are drawn, as SVG has it."""
        return list(map(_numbers, *(axis.tolist() for axis in self.at(np.transpose(places)))))


def _line(points: Iterable[str], style: str, closed: bool = False) -> str:
    return f'<path class="{style}" d="M{"L".join(points)}{"Z" if closed else ""}"/>'


def _group(point: str, style: str, inner: str) -> str:
    return f'<g class="{style}" transform="translate({point})">{inner}</g>'


def _numbers(x: float, y: float) -> str:
    return f"{x:.1f} {y:.1f}"


def replay_map(found: dict[str, Any]) -> str:
    """Return the map of what `clpt replay --json` prints, with one dive at least."""
    rows, legs = found["each_dive"], found["aim"]
    dives, ahead = chart.drawn_dives(rows), chart.layers_ahead(found["next_dive"], legs)
    targets = [layer for layer in ahead if layer.kind == "target"]
    near = [layer for layer in ahead if layer.of is found["next_dive"]]
    layers = [layer for each in dives for layer in each.values()]
    old = [
        layer for each in dives[: -chart.LAST] for layer in each.values() if layer.kind != "ring"
    ]
    last = [layer for each in dives[-chart.LAST :] for layer in each.values()]
    places = [place for layer in (*old, *last, *near) for place in layer.places]
    drawing = Drawing([*places, *_in_reach(places, [layer.places[0] for layer in targets])])
    areas = found["route"]["areas"] if "route" in found else []
    drawn = [_line(drawing.points(area["ring"]), "area", closed=True) for area in areas]
    drawn += [*_grid(drawing), '<g id="dives">']
    points = iter(drawing.points([place for layer in layers for place in layer.places]))
    for k, each in enumerate(dives):
        number, recent = safe(rows[k]["dive"]), k >= len(rows) - chart.LAST
        title = f"<title>dive {number}: {safe(each['fix'].words)}</title>"
        inside = "".join(
            _drawn(layer, [*islice(points, len(layer.places))], recent=recent)
            for layer in each.values()
        )
        drawn.append(f'<g class="dive" data-dive="{number}">{title}{inside}</g>')
    drawn += ["</g>", *_numbered(drawing, rows)]
    for k, leg in enumerate(legs):
        of_leg = [layer for layer in ahead if layer.of is leg]
        drawn += _painted(drawing, of_leg, f"waypoint {k + 1}: ")
        drawn.append(_beyond(drawing, k + 1, of_leg[1].places))
    drawn += [*_painted(drawing, near, "next surfacing: "), _scale(drawing)]
    return (
        f'<svg id="map" viewBox="0 0 {WIDTH:.0f} {drawing.height:.0f}" role="img" '
        f'aria-label="map of the track and of the next surfacing" {_facts(drawing)}>'
        + "\n".join(drawn)
        + "</svg>"
    )


def _painted(drawing: Drawing, layers: list[chart.Layer], name: str) -> list[str]:
    """Return layers, points above lines and with their name."""
    points = sorted(layers, key=lambda layer: layer.shape == "Point")
    return [
        _drawn(layer, drawing.points(layer.places), f"<title>{name}{safe(layer.words)}</title>")
        for layer in points
    ]


def _drawn(layer: chart.Layer, points: list[str], title: str = "", recent: bool = True) -> str:
    if layer.shape != "Point":
        style = layer.kind if recent or layer.kind != "ring" else "ring old"
        return _line(points, style, closed=layer.shape == "Polygon")
    if layer.kind == "fix":
        mark = f'<circle class="{"fix" if layer.of["inside_90"] else "fix out"}" r="3.6"/>'
    else:
        style, shape = MARKS[layer.kind]
        mark = f'<path class="{style}" d="{shape}"/>'
    return _group(points[0], "m", title + mark)


def _in_reach(places: Sequence[Place], targets: Sequence[Place]) -> list[Place]:
    """Return the waypoints that do not make the chart much larger; to others an arrow points."""

    def size(of: Sequence[Place]) -> float:
        of_all = chart.Chart(of)
        return max(of_all.east - of_all.west, of_all.north - of_all.south)

    most = LARGER * size(places)
    return [target for target in targets if size([*places, target]) <= most]


def _beyond(drawing: Drawing, number: int, aim: list[Place]) -> str:
    """Return the arrow at the chart's edge towards a waypoint off it, with how far and where to."""
    (x0, y0), (x1, y1) = map(drawing.at, aim)
    right, low = WIDTH - EDGE, drawing.height - EDGE
    inside = EDGE < x0 < right and EDGE < y0 < low
    if not inside or (EDGE <= x1 <= right and EDGE <= y1 <= low):
        return ""
    shares = [((right if x1 > x0 else EDGE) - x0) / (x1 - x0)] if x1 != x0 else []
    shares += [((low if y1 > y0 else EDGE) - y0) / (y1 - y0)] if y1 != y0 else []
    x, y = (a + min(shares) * (b - a) for a, b in ((x0, x1), (y0, y1)))
    east, north = displacement(*aim[0], *aim[1])
    label = f"waypoint {number}, {hypot(east, north) / 1000:.0f} km to "
    label += compass(degrees(atan2(east, north)))
    angle, left = degrees(atan2(x1 - x0, y0 - y1)), x < WIDTH / 2
    inner = (
        f'<g class="beyond"><path class="star" d="{ARROW}" transform="rotate({angle:.0f})"/>'
        f'<text x="{14 if left else -14}" y="{18 if y < EDGE + 1 else -8}" '
        f'text-anchor="{"start" if left else "end"}">{safe(label)}</text></g>'
    )
    return _group(_numbers(x, y), "m", inner)


def _numbered(drawing: Drawing, rows: list[dict[str, Any]]) -> list[str]:
    """Return the numbers of dives, each with the least zoom at which it has room."""
    points = np.transpose(drawing.at(np.transpose([chart.place_in(row, "end_") for row in rows])))
    free = list(range(len(rows) - 1, -1, -1))  # the last dive first
    drawn: list[str] = []
    placed: list[int] = []
    for level in range(LEVELS + 1):
        room = ROOM if level < LEVELS else (-1.0, -1.0)
        for k in chart.with_room(points * PHONE * 2**level, free, room, placed):
            placed.append(k)
            text = f'<text class="n{level}" x="7" y="-5">{safe(rows[k]["dive"])}</text>'
            drawn.append(_group(_numbers(*points[k]), "m number", text))
        free = sorted(set(free) - set(placed), reverse=True)
    return ['<g id="numbers">', *drawn, "</g>"]


def _grid(drawing: Drawing) -> list[str]:
    """Return parallels and meridians with their names; drawn anew where a script zooms."""
    up, lats, along, lons = drawing.chart.grid(LINES)
    lines = ['<g id="grid">']
    for lat in lats:
        y = drawing.at((lat, drawing.chart.first))[1]
        lines.append(f'<path class="grid" d="M0 {y:.1f}H{WIDTH:.0f}"/>')
        if y < drawing.height - CORNER:
            lines.append(_label(0, y, 4, -4, chart.grid_label(lat, "NS", up)))
    for lon in lons:
        x = (drawing.chart.xy(drawing.chart.middle, lon)[0] - drawing.chart.west) / drawing.metres
        lines.append(f'<path class="grid" d="M{x:.1f} 0V{drawing.height:.0f}"/>')
        lines.append(_label(x, drawing.height, 4, -5, chart.grid_label(lon, "EW", along)))
    return [*lines, "</g>"]


def _label(x: float, y: float, dx: float, dy: float, text: str) -> str:
    inner = f'<text class="degrees" x="{dx}" y="{dy}">{safe(text)}</text>'
    return _group(_numbers(x, y), "m", inner)


def _scale(drawing: Drawing) -> str:
    length, name = chart.bar_of(0.25 * WIDTH * drawing.metres)
    long, y = length / drawing.metres, drawing.height - 60
    x = WIDTH - 30 - long
    return (
        f'<g id="scale"><path class="scale" d="M{x:.1f} {y - 8:.1f}V{y:.1f}h{long:.1f}v-8"/>'
        + _label(x, y, 6, -8, name)
        + "</g>"
    )


def _facts(drawing: Drawing) -> str:
    """Return what a script needs to draw the grid: metres, longitudes, a table of latitudes."""
    edges = drawing.chart
    south, west = edges.place(edges.west, edges.south)
    north, east = edges.place(edges.east, edges.north)
    lats = [south + (north - south) * k / 32 for k in range(33)]
    heights = " ".join(f"{drawing.at((lat, edges.first))[1]:.3f}" for lat in lats)
    return (
        f'data-metres="{drawing.metres!r}" data-west="{west!r}" data-east="{east!r}" '
        f'data-south="{south!r}" data-north="{north!r}" data-heights="{heights}"'
    )
