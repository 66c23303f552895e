"""Two tracks side by side, and what is learned on each."""

from itertools import groupby
from typing import TYPE_CHECKING, Any

import numpy as np

from ...arguments import public
from ...figures import BLUE, GREY, ORANGE, RED, TITLE, axes_for, legend_below
from .design import Design

if TYPE_CHECKING:
    from matplotlib.axes import Axes

SAME = 0.02  # of the picture: waypoints nearer than that share a label
LOWEST = 1e-16  # errors below are drawn there


@public
def design_plot(design: Design, *, ax: Any = None) -> np.ndarray:
    """Draw the old and the new track, and what is learned on both.

    Parameters
    ----------
    design : Design
        As `design_track` gives it.
    ax : array of 3 Axes, optional
        Where to draw, two where no theta is known; by default a new figure of pyplot's.

    Returns
    -------
    ndarray of Axes, shape (3,) or (2,)
        Both tracks over the window; the largest error of a flow parameter on both.

    Raises
    ------
    ClptError
        If `ax` are fewer or more Axes.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> scenario = clpt.paper_scenario().with_values({"run.duration": 80})
    >>> given = {"goal": "kappa", "count": 2, "window": 20, "generations": 1}  # soon found
    >>> found = clpt.theory.design_track(scenario, **given)
    >>> old, new, error = clpt.theory.design_plot(found)
    """
    error = design.tracks[0].error
    panels = 2 if error is None else 3
    axes = axes_for(ax, 3.6 * panels + 1, 4.9, ncols=panels)
    low, high = _frame(design)
    for k, one in enumerate(axes[:2]):
        _track(one, design, k, float(max(high - low)))
        one.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), aspect="equal")
    legend_below(axes[1], 3)
    if error is not None:
        _error(axes[2], design)
    return axes


def _frame(design: Design) -> tuple[np.ndarray, np.ndarray]:
    shown_places = [one.run.position.values for one in design.tracks]
    shown_places += [one.scenario.waypoints for one in design.tracks]
    places = np.vstack(shown_places)
    low, high = places.min(axis=0), places.max(axis=0)
    area = np.array(design.report["limits"]["area"])
    wide = 3 * max(high - low)  # a far larger area is not drawn whole
    low = np.maximum(np.minimum(low, area[::2]), low - wide)
    high = np.minimum(np.maximum(high, area[1::2]), high + wide)
    more = 0.06 * max(high - low)
    return low - more, high + more


def _track(ax: "Axes", design: Design, k: int, size: float) -> None:
    one, report = design.tracks[k], design.report
    found = report["before" if k == 0 else "after"]
    unit, (x1, x1_end, x2, x2_end) = one.scenario.units.length, report["limits"]["area"]
    corners = np.array([[x1, x2], [x1_end, x2], [x1_end, x2_end], [x1, x2_end], [x1, x2]])
    ax.plot(*corners.T, color=GREY, linewidth=1.0, linestyle=":", label="area")
    points = one.scenario.waypoints
    closed = np.vstack([points, points[:1]])
    ax.plot(*closed.T, "--", color=ORANGE, linewidth=1.0, label="closed polygon")
    t = one.run.time.values
    inside = (t >= report["start"]) & (t <= report["start"] + report["window"])
    path = one.run.position.values[inside]
    ax.plot(*path.T, color=BLUE, linewidth=1.0, label="vehicle, in the window")
    ax.plot(*points.T, "o", color=RED, markersize=6, label="waypoints, numbered")
    ax.plot(*one.run.position.values[0], "s", color="black", markersize=5, label="start")
    for place, numbers in _groups(points, SAME * size):
        ax.annotate(
            numbers,
            (float(place[0]), float(place[1])),
            xytext=(6, 6),
            textcoords="offset points",
            fontsize=8,
            bbox={"facecolor": "white", "alpha": 0.7, "edgecolor": "none", "pad": 0.5},
        )
    name = "old" if k == 0 else "new"
    ax.set_title(
        rf"{name}: $\kappa_1$ = {found['smallest_eigenvalue']:.3g}, "
        f"length {found['closed_length']:.4g} {unit}",
        **TITLE,
    )
    ax.set(xlabel=f"$x_1$ ({unit})", ylabel=f"$x_2$ ({unit})")


def _groups(points: np.ndarray, near: float) -> list[tuple[np.ndarray, str]]:
    """Return places and the numbers of the waypoints there, 3 to 5 as 3-5."""
    groups: list[list[int]] = []
    for k, point in enumerate(points):
        for group in groups:
            if np.hypot(*(points[group[0]] - point)) <= near:
                group.append(k)
                break
        else:
            groups.append([k])
    return [(points[group[0]], _runs(group)) for group in groups]


def _runs(group: list[int]) -> str:
    """Return numbers from 1, those that follow one another as 3-5."""
    runs = ([*run] for _, run in groupby(enumerate(group, 1), lambda at: at[1] - at[0]))
    ends = ((run[0][1] + 1, run[-1][1] + 1) for run in runs)
    return ", ".join(f"{a}" if a == b else f"{a}-{b}" for a, b in ends)


def _error(ax: "Axes", design: Design) -> None:
    units = design.report["units"]
    for one, colour, style, name in zip(
        design.tracks, (ORANGE, BLUE), ("--", "-"), ("old track", "new track"), strict=True
    ):
        assert one.error is not None
        error = np.maximum(one.error, LOWEST)
        ax.semilogy(one.run.time, error, style, color=colour, linewidth=1.6, label=name)
    speed, level = f"{units['length']}/{units['time']}", design.report["after"]["level"]
    ax.axhline(level, color=GREY, linewidth=1.0, linestyle=":", label=f"level {level:.3g} {speed}")
    ax.set(xlabel=f"time ({units['time']})", ylabel=f"largest flow-parameter error ({speed})")
    ax.set_title(f"what {design.report['law']} learns", **TITLE)
    ax.legend(fontsize=8, frameon=False)
