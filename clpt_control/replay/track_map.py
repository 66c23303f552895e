"""The map of a replay with one dive at least, as a figure and on the page.

It is Mercator, in degrees and minutes.  A waypoint that would make the chart much larger is an
arrow at its edge.  On the page a script zooms it; each fix is a link to its row of the table.
"""

from collections import defaultdict
from collections.abc import Sequence
from itertools import chain
from typing import Any

import numpy as np
from matplotlib.axes import Axes

from ..arguments import public
from ..figures import (
    BLUE,
    GREEN,
    ORANGE,
    PURPLE,
    RED,
    TITLE,
    axes_for,
    figure_of,
    inline_svg,
    legend_below,
    literal,
)
from ..geodesy import displacement
from ..html import plain
from .chart import LAST, Chart, Layer, bar_of, drawn_dives, grid_label, layers_ahead, with_room
from .facts import Source, found_of
from .places import Place, clock, compass, direction
from .surfacing import NextDive

FEW = 20  # dives, whose marks are large
SIZE, LEAST = 5.6, 4.6  # inches of the longer side; least width
ROOM = (0.3, 0.14)  # inches of a number
LARGER = 1.6  # times, that a waypoint may make the chart
EDGE = 0.06  # of the chart's width, of an arrow from the edge
POINTS = 72  # units of SVG in an inch
AIM = {"color": "black", "label": "to the waypoint"}
DRAWN: tuple[tuple[str, str, float, float, dict[str, Any]], ...] = (
    # kind of a layer, mark or line, its size, that of a mark for many dives, style
    ("track", "-", 1.3, 0, {"color": BLUE, "label": "fix to fix"}),
    ("drift", ":", 0.8, 0, {"color": BLUE, "label": "drift at the surface"}),
    ("miss", "--", 0.6, 0, {"color": RED, "label": "miss"}),
    ("reckoned", "x", 6, 2.5, {"color": RED, "label": "dead-reckoned end"}),
    ("forecast", "+", 8, 3.5, {"color": GREEN, "label": "forecast", "mew": 1.2}),
    ("aim", "-.", 0.6, 0, AIM),
    ("target", "o", 9, 9, {"color": "black", "mfc": "none", "label": "waypoint"}),
    ("way", ":", 1.2, 0, {"color": PURPLE}),
    ("ring next", "--", 1.2, 0, {"color": PURPLE}),
    ("ring aimed", "-.", 1.2, 0, {"color": ORANGE}),
    ("made", "-", 1.8, 0, {"color": ORANGE, "label": "aimed: way made good"}),
    ("next", "*", 11, 11, {"color": PURPLE, "label": "next surfacing", "zorder": 5}),
)


@public
def map_plot(replay: Source, ahead: NextDive | None = None, *, ax: Axes | None = None) -> Axes:
    """Draw a replay's fixes, forecasts and where it aims.

    Parameters
    ----------
    replay : Replay or xarray.Dataset
        With one dive at least; the dataset as `replay_dataset` gives it.
    ahead : NextDive, optional
        The next surfacing, a star; by default as the replay expects it.
    ax : Axes, optional
        Where to draw; by default a new figure of pyplot's.

    Returns
    -------
    Axes
        A Mercator chart, marked by degrees and minutes.

    Raises
    ------
    DataError
        If it is no replay, or has no dive.
    ClptError
        If `ax` is not one Axes.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> replay = clpt.replay.replay_dives(clpt.gliders.usable(clpt.gliders.sample_dives())[0])
    >>> ax = clpt.replay.map_plot(replay, clpt.replay.next_dive(replay))
    """
    found = found_of(replay, ahead)
    ax, _ = _drawn(found, ax, (0.9, 1.7))
    last = found["each_dive"][-1]
    dive, when = literal(plain(f"{found['vehicle']}: dive {last['dive']}")), clock(last["end"])
    ax.set_title(f"{dive} surfaced {when}", **TITLE)
    ax.set(xlabel="longitude", ylabel="latitude")
    legend_below(ax, 3)
    return ax


def _drawn(
    whole: dict[str, Any], ax: Axes | None, around: tuple[float, float]
) -> tuple[Axes, Chart]:
    """Draw what `clpt replay --json` prints, inches around it; return where, and the chart."""
    found, rest = whole["each_dive"], layers_ahead(whole["next_dive"], whole["aim"])
    areas = whole["route"]["areas"] if "route" in whole else []
    of: dict[str, list[list[Place]]] = defaultdict(list)
    for layer in (*chain(*(each.values() for each in drawn_dives(found))), *rest):
        of[layer.kind].append(layer.places)
    rings = of.pop("ring", [])[-LAST:]
    far = [*of["track"], *of["miss"], *rings, *of["ring next"]]
    places = [place for line in far for place in line]
    chart = Chart([*places, *_in_reach(places, [line[0] for line in of["target"]])])
    wide, high = chart.east - chart.west, chart.north - chart.south
    inch = SIZE / max(wide, high)
    ax = axes_for(ax, max(wide * inch, LEAST) + around[0], high * inch + around[1])

    def at(several: Sequence[Sequence[Place]]) -> np.ndarray:
        """Return lines as one, broken by NaN, m, shape (2, n)."""
        ends = [place for places in several for place in (*places, (np.nan, np.nan))]
        return np.array(chart.xy(*np.transpose(ends)))

    for area in areas:
        ax.fill(*at([area["ring"]])[:, :-1], fc=RED, ec=RED, alpha=0.2)
    for k, ring in enumerate(rings):
        label = None if k else f"90 % ellipse{' (last dives)' if len(found) > LAST + 1 else ''}"
        ax.plot(*at([ring]), color=GREEN, lw=0.6, alpha=0.6, label=label)
    few = len(found) <= FEW
    for kind, mark_or_line, size, small, style in DRAWN:
        if of[kind]:
            look: dict[str, Any] = {"ls": mark_or_line, "lw": size}
            if small:
                look = {"ls": "", "marker": mark_or_line, "ms": size if few else small}
            ax.plot(*at(of[kind]), **look, **style)
    fixes = at(of["fix"])[:, ::2]
    urls = [f"#dive{k}" for k in range(len(found))]
    inside = np.array([row["inside_90"] for row in found])
    for some, colour, label in ((inside, "black", "fix"), (~inside, RED, "fix outside 90 %")):
        if some.any():
            here = [url for url, one in zip(urls, some, strict=True) if one]
            size = 16 if few else 5
            x, y = fixes[:, some]
            ax.scatter(x, y, s=size, c=colour, zorder=4, label=label, urls=here)
    _number(ax, fixes, [literal(plain(row["dive"])) for row in found], inch)
    for k, leg in enumerate(whole["aim"]):
        _beyond(ax, chart, k + 1, next(one for one in rest if one.kind == "aim" and one.of is leg))
    _degrees(ax, chart)
    _scale_bar(ax, chart)
    return ax, chart


def map_svg(found: dict[str, Any]) -> str:
    """Return the map as an element of a page, with what its script needs.

    That is where the chart lies in it, its edges in degrees, and how long a unit is, m.
    """
    charts: list[Chart] = []

    def plot() -> Axes:
        ax, chart = _drawn(found, None, (0.5, 0.4))
        charts.append(chart)
        return ax

    figure = figure_of(plot)
    text = inline_svg(figure, "map", "map of the track and of the next surfacing")
    (ax,), (chart,), units = figure.axes, charts, POINTS * figure.get_size_inches()
    (x0, y0), (x1, y1) = ax.get_position().get_points() * units
    (south, west), (north, east) = (
        chart.place(*corner) for corner in ((chart.west, chart.south), (chart.east, chart.north))
    )
    for name, numbers in (
        ("box", (x0, units[1] - y1, x1 - x0, y1 - y0)),
        ("edges", (south, north, west, east)),
        ("metres", ((chart.east - chart.west) / (x1 - x0),)),
    ):
        words = " ".join(f"{one:.9g}" for one in numbers)
        text = text.replace("<svg ", f'<svg data-{name}="{words}" ', 1)
    return text.replace("<svg ", '<svg id="map" ', 1).replace(' target="_blank"', "")


def _in_reach(places: Sequence[Place], targets: Sequence[Place]) -> list[Place]:
    """Return the waypoints that do not make the chart much larger; to others an arrow points."""

    def size(of: Sequence[Place]) -> float:
        of_all = Chart(of)
        return max(of_all.east - of_all.west, of_all.north - of_all.south)

    most = LARGER * size(places)
    return [target for target in targets if size([*places, target]) <= most]


def _beyond(ax: Axes, chart: Chart, number: int, aim: Layer) -> None:
    """Draw the arrow at the chart's edge towards a waypoint off it, with how far and where to."""
    start, end = (np.array(chart.xy(*place)) for place in aim.places)
    margin = EDGE * (chart.east - chart.west)
    low = np.array([chart.west, chart.south]) + margin
    high = np.array([chart.east, chart.north]) - margin
    if not ((start > low) & (start < high)).all() or ((end >= low) & (end <= high)).all():
        return
    way = end - start
    shares = [
        (b - a) / w for a, w, b in zip(start, way, np.where(way > 0, high, low), strict=True) if w
    ]
    x, y = start + min(shares) * way
    east, north = displacement(*aim.places[0], *aim.places[1])
    label = f"waypoint {number}, {np.hypot(east, north) / 1000:.0f} km to "
    label += compass(direction(east, north) or 0.0)
    angle = -np.degrees(np.arctan2(way[0], way[1]))
    ax.plot([x], [y], marker=(3, 0, angle), ms=9, color=PURPLE, ls="")
    left, top = x < (chart.west + chart.east) / 2, y >= high[1]
    place = (9 if left else -9, -10 if top else 6)
    side = "left" if left else "right"
    ax.annotate(label, (x, y), xytext=place, textcoords="offset points", ha=side, fontsize=8)


def _number(ax: Axes, points: np.ndarray, names: list[str], inch: float) -> None:
    """Write numbers beside points, m, shape (2, n), where they have room, the last dive first."""
    for k in with_room(points.T * inch, range(len(names) - 1, -1, -1), ROOM):
        beside: dict[str, Any] = {
            "xytext": (5, 4),
            "textcoords": "offset points",
            "fontsize": 7,
            "zorder": 6,
        }
        ax.annotate(names[k], tuple(points[:, k]), **beside)


def _degrees(ax: Axes, chart: Chart) -> None:
    """Mark parallels and meridians by degrees and minutes."""
    up, lats, along, lons = chart.grid(5)
    ax.set_xticks([chart.xy(chart.middle, lon)[0] for lon in lons])
    ax.set_xticklabels([grid_label(lon, "EW", along) for lon in lons], fontsize=8)
    ax.set_yticks([chart.xy(lat, chart.first)[1] for lat in lats])
    ax.set_yticklabels([grid_label(lat, "NS", up) for lat in lats], fontsize=8)
    ax.set(xlim=(chart.west, chart.east), ylim=(chart.south, chart.north))
    ax.set_aspect("equal", adjustable="box")


def _scale_bar(ax: Axes, chart: Chart) -> None:
    """Draw a length at the lower right."""
    wide = chart.east - chart.west
    length, name = bar_of(0.25 * wide)
    x, y = chart.east - 0.04 * wide - length, chart.south + 0.03 * wide
    ax.plot([x, x + length], [y, y], color="black", lw=2, solid_capstyle="butt")
    ax.annotate(name, (x + length / 2, y), xytext=(0, 3), textcoords="offset points", ha="center")
