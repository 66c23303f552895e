"""The map of a replay as a figure: Mercator, degrees and minutes, the same places as its page.

The 90 % ellipse is {m + sqrt(2 ln 10) L u, |u| = 1}, L L^T its covariance (`rings`).
"""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from ..arguments import public
from ..figures import BLUE, GREEN, ORANGE, PURPLE, RED, axes_for, legend_below
from .chart import Chart, length_of, mark
from .dataset import Source, plotted
from .rings import AIMED, NEXT, Place, place_in, ring_of
from .surfacing import NextDive

if TYPE_CHECKING:
    from matplotlib.axes import Axes

FEW = 20  # dives, whose marks are large
LAST = 12  # dives whose ellipses are drawn
SIZE = 6.5  # inches of the longer side
ROOM = (0.34, 0.14)  # inches of a number


@public
def map_plot(
    replay: Source,
    ahead: NextDive | None = None,
    legs: Sequence[dict[str, Any]] = (),
    *,
    ax: "Axes | None" = None,
) -> "Axes":
    """Draw a replay's fixes, forecasts and where it aims.

    Parameters
    ----------
    replay : Replay or xarray.Dataset
        With one dive at least; the dataset as `replay_dataset` gives it.
    ahead : NextDive, optional
        The next surfacing, a star.
    legs : sequence of dict, optional
        Where to aim, as `Aim.as_dict` has them; the first is drawn.
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
    vehicle, _, _, found = plotted(replay)
    start, end, reckoned, forecast = (
        [place_in(row, which) for row in found]
        for which in ("start_", "end_", "reckoned_", "forecast_")
    )
    rings = [ring_of(row) for row in found[1:][-LAST:]]  # the first dive has no forecast
    next_row = None if ahead is None else ahead.as_dict()
    star = [] if next_row is None else [ring_of(next_row, NEXT)]
    aimed = [ring_of(leg, AIMED) for leg in legs[:1]]
    far = [place for ring in [*rings, *star, *aimed] for place in ring]
    chart = Chart([*start, *end, *reckoned, *far])
    wide, high = chart.east - chart.west, chart.north - chart.south
    inch = SIZE / max(wide, high)
    ax = axes_for(ax, max(wide * inch, 4.2) + 0.9, high * inch + 1.7)

    def at(places: Sequence[Place]) -> np.ndarray:
        return np.array([chart.xy(*place) for place in places]).T

    for k, ring in enumerate(rings):
        label = None if k else f"90 % ellipse{' (last dives)' if len(found) > LAST + 1 else ''}"
        ax.plot(*at(ring), color=GREEN, lw=0.6, alpha=0.6, label=label)
    for first, last, colour, width, style, name in (
        (start, end, BLUE, 1.3, "-", "fix to fix"),
        (end[:-1], start[1:], BLUE, 0.8, ":", "drift at the surface"),
        (reckoned, end, RED, 0.6, "--", "miss"),
    ):
        if first:
            ax.plot(*_pieces(at(first), at(last)), color=colour, lw=width, ls=style, label=name)
    small = len(found) > FEW
    ax.plot(*at(reckoned), "x", color=RED, ms=2.5 if small else 6, label="dead-reckoned end")
    if forecast[1:]:
        ms = 3.5 if small else 8
        ax.plot(*at(forecast[1:]), "+", color=GREEN, ms=ms, mew=1.2, label="forecast")
    ax.plot(*at(end), "o", color="black", ms=2 if small else 4.5, label="fix", zorder=4)
    if next_row is not None:
        ax.plot(*at(star[0]), color=PURPLE, lw=1.2, ls="--")
        goal = at([place_in(next_row, "")])
        ax.plot(*goal, "*", color=PURPLE, ms=11, label="next surfacing", zorder=5)
    for leg in legs[:1]:
        ax.plot(*at(aimed[0]), color=ORANGE, lw=1.2, ls="-.")
        way = at([place_in(leg, which) for which in AIMED])
        ax.plot(*way, color=ORANGE, lw=1.8, label="aimed at the waypoint")
    _number(ax, at(end), [str(row["dive"]) for row in found], inch)
    _degrees(ax, chart)
    _scale_bar(ax, chart)
    last_row = found[-1]
    when = f"{last_row['end'][:10]} {last_row['end'][11:16]} UTC"
    ax.set_title(f"{vehicle}: dive {last_row['dive']} surfaced {when}", loc="left", fontsize=10)
    legend_below(ax, 3)
    return ax


def _pieces(first: np.ndarray, last: np.ndarray) -> np.ndarray:
    """Return n lines as one, broken by NaN, shape (2, 3 n)."""
    return np.stack([first, last, np.full_like(first, np.nan)], axis=2).reshape(2, -1)


def _number(ax: "Axes", points: np.ndarray, names: list[str], inch: float) -> None:
    """Write numbers beside points, m, shape (2, n): away from the track, where they have room."""
    from matplotlib.patheffects import withStroke

    count, placed = len(names), list[np.ndarray]()
    for k in range(count - 1, -1, -1):  # the last dive first
        here = points[:, k]
        if any(np.all(np.abs(here - other) * inch < ROOM) for other in placed):
            continue
        placed.append(here)
        before, after = points[:, max(k - 1, 0)], points[:, min(k + 1, count - 1)]
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


def _degrees(ax: "Axes", chart: Chart) -> None:
    """Mark parallels and meridians by degrees and minutes."""
    up, lats, along, lons = chart.grid(5)
    ax.set_xticks([chart.xy(chart.middle, lon)[0] for lon in lons])
    ax.set_xticklabels([mark(lon, "EW", along) for lon in lons], fontsize=8)
    ax.set_yticks([chart.xy(lat, chart.first)[1] for lat in lats])
    ax.set_yticklabels([mark(lat, "NS", up) for lat in lats], fontsize=8)
    ax.set(xlim=(chart.west, chart.east), ylim=(chart.south, chart.north))
    ax.set(xlabel="longitude", ylabel="latitude")
    ax.set_aspect("equal", adjustable="box")


def _scale_bar(ax: "Axes", chart: Chart) -> None:
    """Draw a length at the lower right."""
    wide = chart.east - chart.west
    length = length_of(0.25 * wide)
    x, y = chart.east - 0.04 * wide - length, chart.south + 0.03 * wide
    ax.plot([x, x + length], [y, y], color="black", lw=2, solid_capstyle="butt")
    name = f"{length / 1000:g} km" if length >= 1000 else f"{length:g} m"
    ax.annotate(name, (x + length / 2, y), xytext=(0, 3), textcoords="offset points", ha="center")
