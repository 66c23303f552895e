"""The map of a replay with one dive at least.

It is Mercator, in degrees and minutes, with the same places as that of the page.
"""

from collections import defaultdict
from collections.abc import Sequence
from itertools import chain
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patheffects import withStroke

from ..arguments import public
from ..figures import BLUE, GREEN, ORANGE, PURPLE, RED, TITLE, axes_for, legend_below, literal
from .chart import LAST, Chart, bar_of, drawn_dives, grid_label, layers_ahead, with_room
from .facts import Source, found_of
from .places import Place, clock
from .surfacing import NextDive

FEW = 20  # dives, whose marks are large
SIZE = 6.5  # inches of the longer side
ROOM = (0.34, 0.14)  # inches of a number
DRAWN: tuple[tuple[str, str, float, float, dict[str, Any]], ...] = (
    # kind of a layer, mark or line, its size, that of a mark for many dives, style
    ("track", "-", 1.3, 0, {"color": BLUE, "label": "fix to fix"}),
    ("drift", ":", 0.8, 0, {"color": BLUE, "label": "drift at the surface"}),
    ("miss", "--", 0.6, 0, {"color": RED, "label": "miss"}),
    ("reckoned", "x", 6, 2.5, {"color": RED, "label": "dead-reckoned end"}),
    ("forecast", "+", 8, 3.5, {"color": GREEN, "label": "forecast", "mew": 1.2}),
    ("fix", "o", 4.5, 2, {"color": "black", "label": "fix", "zorder": 4}),
    ("ring next", "--", 1.2, 0, {"color": PURPLE}),
    ("next", "*", 11, 11, {"color": PURPLE, "label": "next surfacing", "zorder": 5}),
    ("ring aimed", "-.", 1.2, 0, {"color": ORANGE}),
    ("made", "-", 1.8, 0, {"color": ORANGE, "label": "aimed at the waypoint"}),
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
    whole = found_of(replay, ahead)
    found, rest = whole["each_dive"], layers_ahead(whole["next_dive"], whole["aim"][:1])
    of: dict[str, list[list[Place]]] = defaultdict(list)
    for layer in (*chain(*(each.values() for each in drawn_dives(found))), *rest):
        of[layer.kind].append(layer.places)
    rings = of.pop("ring", [])[-LAST:]
    far = [*of["track"], *of["miss"], *rings, *of["ring next"], *of["ring aimed"]]
    chart = Chart([place for places in far for place in places])
    wide, high = chart.east - chart.west, chart.north - chart.south
    inch = SIZE / max(wide, high)
    ax = axes_for(ax, max(wide * inch, 4.6) + 0.9, high * inch + 1.7)

    def at(several: Sequence[Sequence[Place]]) -> np.ndarray:
        """Return lines as one, broken by NaN, m, shape (2, n)."""
        ends = [place for places in several for place in (*places, (np.nan, np.nan))]
        return np.array(chart.xy(*np.transpose(ends)))

    for k, ring in enumerate(rings):
        label = None if k else f"90 % ellipse{' (last dives)' if len(found) > LAST + 1 else ''}"
        ax.plot(*at([ring]), color=GREEN, lw=0.6, alpha=0.6, label=label)
    for kind, mark_or_line, size, small, style in DRAWN:
        if of[kind]:
            mark_size = small if len(found) > FEW else size
            width: dict[str, Any] = {"ms": mark_size} if small else {"lw": size}
            ax.plot(*at(of[kind]), mark_or_line, **width, **style)
    _number(ax, at(of["fix"])[:, ::2], [str(row["dive"]) for row in found], inch)
    _degrees(ax, chart)
    _scale_bar(ax, chart)
    last_row = found[-1]
    when = clock(last_row["end"])
    title = f"{literal(whole['vehicle'])}: dive {last_row['dive']} surfaced {when}"
    ax.set_title(title, **TITLE)
    legend_below(ax, 3)
    return ax


def _number(ax: Axes, points: np.ndarray, names: list[str], inch: float) -> None:
    """Write numbers beside points, m, shape (2, n): away from the track, where they have room."""
    count = len(names)
    for k in with_room(points.T * inch, range(count - 1, -1, -1), ROOM):  # the last dive first
        before, here, after = points[:, [max(k - 1, 0), k, min(k + 1, count - 1)]].T
        way = after - before
        side = np.array([-way[1], way[0]])
        side *= -1 if side @ (2 * here - before - after) < 0 else 1  # out of the bend
        away = np.array([12, 9]) * side / max(np.hypot(*side), 1e-9)
        text = ax.annotate(
            names[k],
            tuple(here),
            xytext=tuple(away) if np.any(away) else (8, 8),
            fontsize=7,
            textcoords="offset points",
            ha="center",
            va="center",
            zorder=6,
        )
        text.set_path_effects([withStroke(linewidth=2, foreground="white")])


def _degrees(ax: Axes, chart: Chart) -> None:
    """Mark parallels and meridians by degrees and minutes."""
    up, lats, along, lons = chart.grid(5)
    ax.set_xticks([chart.xy(chart.middle, lon)[0] for lon in lons])
    ax.set_xticklabels([grid_label(lon, "EW", along) for lon in lons], fontsize=8)
    ax.set_yticks([chart.xy(lat, chart.first)[1] for lat in lats])
    ax.set_yticklabels([grid_label(lat, "NS", up) for lat in lats], fontsize=8)
    ax.set(xlim=(chart.west, chart.east), ylim=(chart.south, chart.north))
    ax.set(xlabel="longitude", ylabel="latitude")
    ax.set_aspect("equal", adjustable="box")


def _scale_bar(ax: Axes, chart: Chart) -> None:
    """Draw a length at the lower right."""
    wide = chart.east - chart.west
    length, name = bar_of(0.25 * wide)
    x, y = chart.east - 0.04 * wide - length, chart.south + 0.03 * wide
    ax.plot([x, x + length], [y, y], color="black", lw=2, solid_capstyle="butt")
    ax.annotate(name, (x + length / 2, y), xytext=(0, 3), textcoords="offset points", ha="center")
