"""The chart of a run: waypoints, track and flow on the plane; what all its pictures share.

Nothing here integrates.
"""

from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

import numpy as np

from ..base.arguments import public
from ..base.errors import ClptError
from ..base.figures import BLUE, COLOURS, GREY, RED, TITLE, axes_for, legend_below
from ..paper.scenario.experiment import Scenario
from ..paper.scenario.file import scenario_of_run
from ..paper.scenario.recorded_run import check_run, waypoints_of

if TYPE_CHECKING:
    import xarray
    from matplotlib.axes import Axes

LEAST = 1e-16  # shown of what falls to zero, on a logarithmic axis


def scenario_with(run: "xarray.Dataset", *names: str) -> Scenario:
    """Return the scenario of a run that has some variables along its time."""
    scenario = scenario_of_run(run)
    check_run(run, scenario, "time", *names)
    return scenario


@public
def track_plot(
    run: "xarray.Dataset",
    *,
    ax: "Axes | None" = None,
    label: str | None = None,
    color: str | None = None,
) -> "Axes":
    """Draw waypoints, track and the flow at the start (figure 1).

    Parameters
    ----------
    run : xarray.Dataset
        As `simulate` gives it, or `load_run`.
    ax : Axes, optional
        Where to draw; by default a new figure of pyplot's.
    label, color : optional
        Of a run among several on the same Axes: its name in the legend and one colour for all of
        its lines, whose styles tell its signals apart; `compare` gives them.

    Returns
    -------
    Axes
        In the scenario's unit of length; the figure is ``ax.figure``.

    Raises
    ------
    DataError
        If the dataset is no run of one vehicle.
    ClptError
        If `ax` is not one Axes.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> scenario = clpt.paper_scenario().with_values({"run.duration": 20})
    >>> ax = track_plot(clpt.simulate(scenario))
    """
    scenario = scenario_with(run, "position")
    points, path = waypoints_of(run, scenario), run.position.values
    ax = axes_for(ax, 5.6, 5.2)
    with told_apart(ax, label, color):
        grid = square_chart(ax, scenario, np.concatenate([points, path]), 13)
        draw_track(ax, run, points, scenario.cycle if len(points) else np.inf)
        named = ["Waypoints", "track"] if len(points) else ["Track"]
        if label is None:
            for k, point in enumerate(points if len(points) <= 40 else (), 1):
                ax.annotate(
                    str(k), point, xytext=(5, 5), textcoords="offset points", fontsize=8
                )
            ax.plot(*path[0], "s", color="black", markersize=5, label="start")
            named += ["flow at t = 0"] * draw_first_flow(ax, run, scenario, grid)
        ax.set_title(", ".join(named), **TITLE)
        legend_below(ax, 4)
    return ax


def draw_track(
    ax: Any, run: "xarray.Dataset", points: np.ndarray, cycle: float = np.inf
) -> None:
    """Draw a track, pale after its first cycle, and waypoints or what the vehicle followed."""
    path, first = run.position.values, run.time.values <= cycle
    ax.plot(*path[first].T, color=BLUE, linewidth=1.2, label="track")
    if not first.all():
        ax.plot(
            *path[~first].T, color=BLUE, linewidth=0.5, alpha=0.4, label="later cycles"
        )
    if "predicted_position" in run:
        predicted: dict[str, Any] = {"color": BLUE, "linewidth": 0.8, "linestyle": "--"}
        ax.plot(
            *run.predicted_position.values[first].T, label="prediction", **predicted
        )
    if len(points):
        rings: dict[str, Any] = {
            "markersize": 6,
            "mfc": "none",
            "mew": 1.5,
            "zorder": 3,
        }
        ax.plot(*points.T, "o", color=RED, label="waypoints", **rings)
    elif "reference" in run:
        desired: dict[str, Any] = {"color": RED, "linewidth": 0.9, "linestyle": "--"}
        ax.plot(*run.reference.values.T, label="desired position", **desired)


def draw_first_flow(
    ax: Any, run: "xarray.Dataset", scenario: Scenario, grid: Any
) -> bool:
    """Draw the flow at the start; return whether there is any."""
    from .flows import flow_to_draw

    flow = flow_to_draw(run, scenario, grid, 0.0)
    size = float(f"{np.hypot(*flow.T).max():.1g}")
    if size > 0:  # where all is at rest there are no arrows
        arrows = ax.quiver(*grid.T, *flow.T, color=GREY, alpha=0.6, width=0.0035)
        key = f"{size:g} {scenario.units.length}/{scenario.units.time}"
        ax.quiverkey(arrows, 0.88, 1.02, size, key, labelpos="E")
    return size > 0


def square_chart(
    ax: Any, scenario: Scenario, places: np.ndarray, count: int
) -> np.ndarray:
    """Make axes a square about places; return where arrows of the flow begin, `count` a side.

    They lie within the field of a measured current.
    """
    unit = scenario.units.length
    low, high = places.min(0), places.max(0)
    middle, half = (low + high) / 2, 0.62 * (max(high - low) or 1.0)
    low, high = middle - half, middle + half
    ax.set(
        xlabel=f"$x_1$, east ({unit})", ylabel=f"$x_2$, north ({unit})", aspect="equal"
    )
    ax.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]))
    if scenario.field_path is not None:
        from ..ocean.currents.plane import read_field

        field = read_field(scenario.field_path, scenario.units)
        first, last = ([x[k] for x in (field.x1, field.x2)] for k in (0, -1))
        within = np.clip([low, high], first, last)
        if np.all(within[0] < within[1]):  # a clipped run may be beyond it all the time
            low, high = within
    step = max(high - low) / count
    sides = [np.arange(a + step / 2, b, step) for a, b in zip(low, high, strict=True)]
    return np.stack(np.meshgrid(*sides), -1).reshape(-1, 2)


def positive(values: np.ndarray) -> np.ndarray:
    """Return what a logarithmic axis can show."""
    return np.where(values > LEAST, values, np.nan)


@contextmanager
def told_apart(axes: Any, label: str | None, color: str | None) -> Iterator[None]:
    """Draw a run on axes: in its colour and marks, if it has one, its label before those of lines.

    Axes on which there are several runs reach over all of them, and have their legend beside them,
    where it hides no line.
    """
    from matplotlib.colors import is_color_like

    if color is not None and not is_color_like(color):
        raise ClptError(
            f"color = {color!r:.60}: must be a colour of matplotlib, 'C1' or '#0072b2'"
        )
    # tell runs apart in black and white
    marks = dict(zip(COLOURS, ("", *"osD^v"), strict=True))
    several = np.ravel(np.asarray(axes, dtype=object))
    before = [(len(ax.lines), ax.get_xlim(), ax.get_ylim()) for ax in several]
    yield
    for ax, (count, x, y) in zip(several, before, strict=True):
        for line in ax.lines[count:]:
            named = line.get_label()[0] != "_"
            if color is not None:
                line.set_color(color)
            if color in marks and named and line.get_marker() in ("", "None"):
                line.set(marker=marks[color], markersize=3.5, markevery=0.3)
            if label is not None and named:
                line.set_label(f"{label}: {line.get_label()}")
        if label is not None and count and not ax.get_autoscalex_on():
            ax.set_xlim(min(x[0], ax.get_xlim()[0]), max(x[1], ax.get_xlim()[1]))
        if label is not None and count and not ax.get_autoscaley_on():
            ax.set_ylim(min(y[0], ax.get_ylim()[0]), max(y[1], ax.get_ylim()[1]))
        if label is not None and (lines := len(ax.get_legend_handles_labels()[0])):
            place = {"loc": "upper left", "bbox_to_anchor": (1, 1.05), "frameon": False}
            ax.legend(fontsize=7, ncols=1 + (lines - 1) // 6, **place)
