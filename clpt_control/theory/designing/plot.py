"""Two tracks side by side, and what is learned on each."""

from typing import TYPE_CHECKING, Any

import numpy as np

from ...arguments import public
from ...figures import BLUE, GREY, ORANGE, TITLE, axes_for, legend_below
from .design import Design

if TYPE_CHECKING:
    from matplotlib.axes import Axes

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
    >>> scenario = clpt.paper_scenario().with_values({"run.duration": 80, "reference.count": 2})
    >>> given = {"goal": "kappa", "window": 20}
    >>> found = clpt.theory.design_track(scenario, **given)
    >>> old, new, error = clpt.theory.design_plot(found)
    """
    error = design.tracks[0].error
    panels = 2 if error is None else 3
    axes = axes_for(ax, 3.6 * panels + 1, 4.9, ncols=panels)
    for k, one in enumerate(axes[:2]):
        _track(one, design, k)
        one.set_aspect("equal")
        one.margins(0.06)
    axes[0].sharex(axes[1])
    axes[0].sharey(axes[1])
    legend_below(axes[1], 3)
    if error is not None:
        _error(axes[2], design)
    return axes


def _track(ax: "Axes", design: Design, k: int) -> None:
    from matplotlib.patches import Rectangle

    one, report = design.tracks[k], design.report
    found = report["before" if k == 0 else "after"]
    unit, (x1, x1_end, x2, x2_end) = one.scenario.units.length, report["limits"]["area"]
    dotted: dict[str, Any] = {"fill": False, "edgecolor": GREY, "linestyle": ":"}
    ax.add_patch(Rectangle((x1, x2), x1_end - x1, x2_end - x2, label="area", **dotted))
    points = one.scenario.waypoints
    closed = np.vstack([points, points[:1]])
    ax.plot(*closed.T, "--", color=ORANGE, linewidth=1.0, label="closed polygon")
    t = one.run.time.values
    inside = (t >= report["start"]) & (t <= report["start"] + report["window"])
    path = one.run.position.values[inside]
    ax.plot(*path.T, color=BLUE, linewidth=1.0, label="vehicle, in the window")
    ranks: dict[str, Any] = {"c": np.arange(len(points)), "cmap": "viridis", "zorder": 3}
    ax.scatter(points[:, 0], points[:, 1], label="waypoints, the first dark", **ranks)
    ax.plot(*one.run.position.values[0], "s", color="black", markersize=5, label="start")
    name = "old" if k == 0 else "new"
    ax.set_title(
        rf"{name}: $\kappa_1$ = {found['smallest_eigenvalue']:.3g}, "
        f"length {found['closed_length']:.4g} {unit}",
        **TITLE,
    )
    ax.set(xlabel=f"$x_1$ ({unit})", ylabel=f"$x_2$ ({unit})")


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
