"""The map of a replay with one dive at least, as a figure and on the page.

It has longitude and latitude as axes, in degrees and minutes, drawn so long that its middle is
true to scale and angle.  Longitudes are counted from that of the first place, so that no chart is
cut at 180 degrees.  A waypoint that would make it much larger is outside: the line to it ends at
the edge.  On the page a script zooms it; each fix is a link to its row of the table.
"""

from collections.abc import Sequence
from functools import partial
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.ticker import FuncFormatter, MultipleLocator

from ...base.arguments import public
from ...base.figures import (
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
from ...base.figures.degree_axes import scale_bar
from ...base.geodesy import angle_near, distance, east_of
from ...base.html import plain
from ..estimation.fix_model import PERCENT
from .map_layers import layers_of
from .netcdf_export import Source, report_of
from .table_rows import Place, Report, clock, degrees_minutes, is_outside

FEW = 20  # dives, whose marks are large
SIZE, LEAST = 5.6, 4.6  # inches of the longer side; least width
ROOM = (0.4, 0.2)  # inches of a number on a telephone
LARGER = 1.6  # times, that a waypoint may make the chart
SHORTEST = 500.0  # m, of the longer side
NARROWEST, MARGIN = 0.6, 0.06  # of the longer side: the other one, and on each side
MOST = 89.5  # degrees of the middle; at a pole there is no east
# minutes
STEPS = (0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 15, 30, 60, 120, 300, 600, 1800)
POINTS = 72  # units of SVG in an inch
LABEL = 8  # points of the degrees
PHONE_LABEL = 11  # on a telephone, as `page.css` has them
FAR = ("track", "miss", "ring", "ring next")  # layers that lie within the chart
AIM = {"color": "black", "label": "to the waypoint"}
DRAWN: tuple[tuple[str, str, float, float, dict[str, Any]], ...] = (
    # kind of a layer, mark or line, its size, that of a mark for many dives, style
    ("track", "-", 1.3, 0, {"color": BLUE, "label": "fix to fix"}),
    ("drift", ":", 0.8, 0, {"color": BLUE, "label": "drift at the surface"}),
    (
        "ring",
        "-",
        0.6,
        0,
        {"color": GREEN, "alpha": 0.6, "label": f"{PERCENT} ellipse, last dives"},
    ),
    ("miss", "--", 0.6, 0, {"color": RED, "label": "position error"}),
    ("reckoned", "x", 6, 2.5, {"color": RED, "label": "dead-reckoned end"}),
    ("forecast", "+", 8, 3.5, {"color": GREEN, "label": "forecast", "mew": 1.2}),
    ("aim", "-.", 0.6, 0, AIM),
    ("target", "o", 9, 9, {"color": "black", "mfc": "none", "label": "waypoint"}),
    ("way", ":", 1.2, 0, {"color": PURPLE}),
    ("ring next", "--", 1.2, 0, {"color": PURPLE}),
    ("ring aimed", "-.", 1.2, 0, {"color": ORANGE}),
    ("made", "-", 1.8, 0, {"color": ORANGE, "label": "aimed: distance made good"}),
    ("next", "*", 11, 11, {"color": PURPLE, "label": "next surfacing", "zorder": 5}),
)


@public
def map_plot(replay: Source, *, ax: Axes | None = None) -> Axes:
    """Draw a replay's fixes, forecasts and where it aims.

    >>> import clpt_control as clpt
    >>> replay = clpt.replay.replay_dives(clpt.gliders.sample_dives())
    >>> ax = map_plot(replay)
    """
    report = report_of(replay)
    ax = _drawn(report, ax, (0.9, 1.7))
    last = report["each_dive"][-1]
    dive = literal(plain(f"{report['vehicle']}: dive {last['dive']}"))
    when = clock(last["end"])
    ax.set_title(f"{dive} surfaced {when}", **TITLE)
    ax.set(xlabel="longitude", ylabel="latitude")
    legend_below(ax, 3)
    return ax


def degree_at(lat: float, lon: float) -> np.ndarray:
    """Return how long a degree of longitude and one of latitude are at a place, m, (2,)."""
    lat = min(max(lat, -MOST), MOST)
    ends = (0.0, 0.5), (0.5, 0.0)
    return np.array([distance(lat - a, lon - b, lat + a, lon + b) for a, b in ends])


def edges_of(points: np.ndarray, degree: np.ndarray) -> np.ndarray:
    """Return west, south and east, north of a chart around points, (2, n), degrees.

    It is neither very wide nor very high.
    """
    low = points.min(axis=1)
    high = points.max(axis=1)
    spans = (high - low) * degree
    size = max(*spans, SHORTEST)
    half_size = (np.maximum(spans, NARROWEST * size) / 2 + MARGIN * size) / degree
    return np.array([(low + high) / 2 - half_size, (low + high) / 2 + half_size])


def _drawn(report: Report, ax: Axes | None, margins: tuple[float, float]) -> Axes:
    """Draw what `clpt replay --json` prints, inches around it."""
    rows = report["each_dive"]
    of = {
        kind: [layer.places for layer in layers]
        for kind, layers in layers_of(report).items()
    }
    reference = east_of(of["track"][0][0][1])

    def lines_of(several: Sequence[Sequence[Place]]) -> np.ndarray:
        """Return lines as one, broken by NaN: longitudes and latitudes, (2, n)."""
        ends = [
            point for points_of in several for point in (*points_of, (np.nan, np.nan))
        ]
        lat, lon = np.transpose(ends)
        return np.array([angle_near(lon, reference), lat])

    outline = [point for kind in FAR for points_of in of[kind] for point in points_of]
    points = lines_of([outline])[:, :-1]
    if not (np.abs(points[1]) <= 90.0).all():
        raise ValueError("a latitude is beyond the poles")
    degree = degree_at((points[1].min() + points[1].max()).item() / 2, reference)
    size = max(*np.ptp(points, axis=1) * degree, SHORTEST)
    for target in of["target"]:
        with_it = np.hstack([points, lines_of([target])[:, :1]])
        if max(*np.ptp(with_it, axis=1) * degree) <= LARGER * size:
            points = with_it
    (west, south), (east, north) = edges_of(points, degree)
    wide = (east - west) * degree[0]
    high = (north - south) * degree[1]
    inch = SIZE / max(wide, high)
    ax = axes_for(ax, max(wide * inch, LEAST) + margins[0], high * inch + margins[1])
    ax.set(xlim=(west, east), ylim=(south, north))
    ax.set_aspect(degree[1] / degree[0], adjustable="box")
    few = len(rows) <= FEW
    for kind, mark_or_line, size, small, style in DRAWN:
        if of[kind]:
            look: dict[str, Any] = {"ls": mark_or_line, "lw": size}
            if small:
                look = {"ls": "", "marker": mark_or_line, "ms": size if few else small}
            ax.plot(*lines_of(of[kind]), **look, **style)
    fixes = lines_of(of["fix"])[:, ::2]
    urls = np.array([f"#dive{k}" for k in range(len(rows))])
    inside = ~np.array([*map(is_outside, rows)])
    for mask, colour, label in (
        (inside, "black", "fix"),
        (~inside, RED, f"fix outside {PERCENT}"),
    ):
        if mask.any():
            x, y = fixes[:, mask]
            links = urls[mask].tolist()
            ax.scatter(
                x, y, s=16 if few else 5, c=colour, zorder=4, label=label, urls=links
            )
    for k in with_room(fixes.T * degree * inch):
        ax.annotate(
            literal(plain(rows[k]["dive"])),
            tuple(fixes[:, k]),
            (5, 4),
            textcoords="offset points",
            fontsize=7,
            zorder=6,
        )
    draw_grid_and_scale_bar(ax, degree)
    return ax


def draw_grid_and_scale_bar(ax: Axes, degree: np.ndarray) -> None:
    """Mark parallels and meridians by degrees and minutes, and a length at the lower right."""
    west, east = ax.get_xlim()
    south, north = ax.get_ylim()
    for axis, names, span in (
        (ax.xaxis, "EW", east - west),
        (ax.yaxis, "NS", north - south),
    ):
        # five lines
        step = next((step for step in STEPS if step >= 12 * span), STEPS[-1])
        axis.set_major_locator(MultipleLocator(step / 60))
        axis.set_major_formatter(
            FuncFormatter(partial(grid_label, names=names, step=step))
        )
        axis.set_tick_params(labelsize=LABEL)
    scale_bar(ax, "km", 1000 / degree[0])


def map_svg(report: Report) -> str:
    """Return the map as an element of a page, with what its script needs.

    That is where the chart lies in it, its edges in degrees, and how long a unit is, m.
    """
    figure = figure_of(_drawn, report, None, (0.5, 0.4))
    (ax,) = figure.axes
    units = POINTS * figure.get_size_inches()
    # room for the labels of a telephone, which are larger
    ax.tick_params(labelsize=PHONE_LABEL)
    figure.draw_without_rendering()
    figure.set_layout_engine("none")
    ax.tick_params(labelsize=LABEL)
    text = inline_svg(figure, "map", "map of the track and of the next surfacing")
    (x0, y0), (x1, y1) = ax.get_position().get_points() * units
    west, east = ax.get_xlim()
    south, north = ax.get_ylim()
    wide = (east - west) * degree_at((south + north) / 2, east_of(west))[0]
    box = x0, units[1] - y1, x1 - x0, y1 - y0
    numbers = (*box, south, north, west, east, wide / (x1 - x0))
    words = " ".join(f"{number:.9g}" for number in numbers)
    text = text.replace("<svg ", f'<svg id="map" data-chart="{words}" ', 1)
    return text.replace(' target="_blank"', "")


def with_room(points: np.ndarray) -> list[int]:
    """Return which of points, (n, 2), inches, have room for a number, the last ones first."""
    chosen: list[int] = []
    for k in range(len(points) - 1, -1, -1):
        if (np.abs(points[chosen] - points[k]) >= ROOM).any(1).all():
            chosen.append(k)
    return chosen


def grid_label(
    angle: float, position: int | None = None, *, names: str, step: float
) -> str:
    """Return degrees and minutes of a parallel ("NS") or meridian ("EW") of a grid.

    >>> grid_label(-42.9, names="NS", step=2), grid_label(190.505, names="EW", step=0.1)
    ("42°54'S", "169°29.70'W")
    >>> grid_label(-0.999999, names="NS", step=0.1)
    "1°00.00'S"
    """
    angle = east_of(angle) if names == "EW" else angle
    degrees, minutes = degrees_minutes(angle, 0 if step >= 1 else 2)
    return f"{degrees}°{minutes}'{names[int(angle < 0)]}"
