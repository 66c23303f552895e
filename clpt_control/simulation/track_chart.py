"""Chart of a run on the plane: waypoints, track and the flow at the start.

The other plots of runs share `run_style`, the colours, markers and labels of several runs on the
same Axes, and `positive`, the values of a logarithmic axis.
"""

from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

import numpy as np

from ..base.arguments import public
from ..base.errors import ClptError
from ..base.figures import (
    BLUE,
    COLOURS,
    GREY,
    RED,
    TITLE,
    axes_for,
    legend_below,
    with_formulas,
)
from ..paper.scenario.experiment import Scenario
from ..paper.scenario.recorded_run import scenario_with, waypoints_of

if TYPE_CHECKING:
    import xarray
    from matplotlib.axes import Axes

TRUTH = "true value"  # gid of lines
LEAST = 1e-16  # smallest value on a logarithmic axis
MAX_NUMBERED = 40  # waypoints with a number
NUMBER_DISTANCE = 0.035  # of the chart's width
MARKERS = dict(zip(COLOURS, ("", *"osD^v"), strict=True))


@public
def track_plot(
    run: "xarray.Dataset",
    *,
    ax: "Axes | None" = None,
    label: str | None = None,
    color: str | None = None,
) -> "Axes":
    """Draw waypoints, track and the flow at the start (figure 1).

    >>> import clpt_control as clpt
    >>> scenario = clpt.paper_scenario().with_values({"run.duration": 20})
    >>> ax = track_plot(clpt.simulate(scenario))
    """
    scenario = scenario_with(run, "position")
    waypoints = waypoints_of(run, scenario)
    track = run.position.values
    ax = axes_for(ax, 5.6, 5.2)
    with run_style(ax, label, color):
        grid = square_chart(ax, scenario, np.concatenate([waypoints, track]), 13)
        draw_track(ax, run, waypoints, scenario.cycle if len(waypoints) else np.inf)
        title = ["Waypoints", "track"] if len(waypoints) else ["Track"]
        if label is None:
            if len(waypoints) <= MAX_NUMBERED:
                _number(ax, waypoints, track)
            ax.plot(*track[0], "s", color="black", markersize=5, label="start")
            if draw_first_flow(ax, run, scenario, grid):
                title.append("flow at t = 0")
        ax.set_title(", ".join(title), **TITLE)
        legend_below(ax, 4)
    return ax


def _number(ax: Any, points: np.ndarray, track: np.ndarray) -> None:
    """Write the numbers of waypoints, each on the side that is furthest from the track."""
    angles = np.linspace(0, 2 * np.pi, 16, endpoint=False)
    sides = np.column_stack([np.cos(angles), np.sin(angles)])
    reach = NUMBER_DISTANCE * np.ptp(ax.get_xlim())
    drawn = np.concatenate([track[:: max(1, len(track) // 2000)], points])
    for k, point in enumerate(points, 1):
        drawn_nearby = drawn[np.hypot(*(drawn - point).T) < 3 * reach]
        away = np.hypot(
            *np.moveaxis(point + reach * sides[:, None] - drawn_nearby, -1, 0)
        )
        x, y = point + reach * sides[away.min(axis=1).argmax()]
        ax.text(x, y, str(k), fontsize=8, ha="center", va="center")


def draw_track(
    ax: Any, run: "xarray.Dataset", waypoints: np.ndarray, cycle: float = np.inf
) -> None:
    """Draw a track, pale after its first cycle, and waypoints or the desired positions."""
    track = run.position.values
    early = run.time.values <= cycle
    late = ~early
    ax.plot(*track[early].T, color=BLUE, linewidth=1.2, label="track")
    if late.any():
        ax.plot(*track[late].T, color=BLUE, lw=0.5, alpha=0.4, label="later cycles")
    if "predicted_position" in run:
        predicted = run.predicted_position.values[early]
        ax.plot(*predicted.T, "--", color=BLUE, linewidth=0.8, label="prediction")
    if len(waypoints):
        rings = ax.plot(*waypoints.T, "o", color=RED, label="waypoints", zorder=3)
        rings[0].set(markersize=6, mfc="none", mew=1.5)
    elif "reference" in run:
        desired = run.reference.values
        ax.plot(*desired.T, "--", color=RED, linewidth=0.9, label="desired position")


def draw_first_flow(
    ax: Any, run: "xarray.Dataset", scenario: Scenario, grid: np.ndarray
) -> bool:
    """Draw the flow at the start, and return True, unless the flow is zero."""
    from .flows import flow_to_draw

    flow = flow_to_draw(run, scenario, grid, 0.0)
    speed = float(f"{np.hypot(*flow.T).max():.1g}")
    if speed > 0:
        arrows = ax.quiver(*grid.T, *flow.T, color=GREY, alpha=0.6, width=0.0035)
        key = f"{speed:g} {scenario.units.length}/{scenario.units.time}"
        ax.quiverkey(arrows, 0.94, 1.03, speed, key, labelpos="W")
    return speed > 0


def square_chart(
    ax: Any, scenario: Scenario, points: np.ndarray, count: int, edge: float = 0.5
) -> np.ndarray:
    """Make axes a square around points; return a grid of `count` flow arrows on a side.

    The grid is inside the field of a measured current, `edge` steps away from the border.
    """
    unit = scenario.units.length
    low = points.min(0)
    high = points.max(0)
    centre = (low + high) / 2
    margin = 0.62 * (max(high - low) or 1.0)
    low = centre - margin
    high = centre + margin
    ax.set(xlabel=f"$x_1$, east ({unit})", ylabel=f"$x_2$, north ({unit})")
    ax.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), aspect="equal")
    if scenario.origin is not None:
        from ..base.figures.degree_axes import degree_axes

        degree_axes(ax, scenario.plane, unit)
    if scenario.field_path is not None:
        from ..paper.currents.plane import read_field

        field = read_field(scenario.field_path, scenario.units)
        field_low = [field.x1[0], field.x2[0]]
        field_high = [field.x1[-1], field.x2[-1]]
        inner = np.clip([low, high], field_low, field_high)
        if np.all(inner[0] < inner[1]):  # the chart may be outside of the field
            low, high = inner
    step = max(high - low) / (count - 1 + 2 * edge)
    ends = zip(low + edge * step, high - (edge - 0.5) * step, strict=True)
    axes = [np.arange(first, end, step) for first, end in ends]
    return np.stack(np.meshgrid(*axes), -1).reshape(-1, 2)


def positive(values: np.ndarray) -> np.ndarray:
    """Return values for a logarithmic axis: NaN if not positive."""
    return np.where(values > LEAST, values, np.nan)


@contextmanager
def run_style(axes: Any, label: str | None, color: str | None) -> Iterator[None]:
    """Style the lines of one of several runs: its colour and marker, its label in the legend.

    Axes of several runs have limits that contain all runs, and a legend next to them.
    """
    from matplotlib.colors import is_color_like

    if color is not None and not is_color_like(color):
        raise ClptError(
            f"color = {color!r:.60}: must be a colour of matplotlib, 'C1' or '#0072b2'"
        )
    axes = np.ravel(np.asarray(axes, dtype=object))
    states = [(len(ax.lines), ax.get_xlim(), ax.get_ylim()) for ax in axes]
    yield
    for ax, (count, xlim, ylim) in zip(axes, states, strict=True):
        for line in [*ax.lines[count:]]:
            style_line(line, label, color)
            if color is not None and line.get_gid() == TRUTH:
                _merge_truth(line, ax.lines[:count])
        if label is None:
            continue
        if count and not ax.get_autoscalex_on():
            ax.set_xlim(_hull(xlim, ax.get_xlim()))
        if count and not ax.get_autoscaley_on():
            ax.set_ylim(_hull(ylim, ax.get_ylim()))
        legend_beside(ax)


def legend_beside(ax: Any) -> None:
    """Draw a legend right of axes, if lines have labels."""
    if lines := len(ax.get_legend_handles_labels()[0]):
        ax.legend(
            fontsize=7,
            ncols=1 + (lines - 1) // 14,
            loc="upper left",
            bbox_to_anchor=(1, 1.05),
            frameon=False,
        )


def _merge_truth(line: Any, others: Iterable[Any]) -> None:
    """Remove a line of a true value that several runs have, and draw the first in grey."""
    for line_of_run in others:
        if (
            line_of_run.get_gid() == TRUTH
            and line_of_run.get_ydata()[0] == line.get_ydata()[0]
        ):
            line_of_run.set_color(GREY)
            line.remove()
            return


def style_line(line: Any, label: str | None, color: str | None) -> None:
    """Style a line of one of several runs: colour, marker and label."""
    has_label = line.get_label()[0] != "_"
    if color is not None:
        line.set_color(color)
        # markers distinguish runs in black and white
        marker = MARKERS.get(color)
        if marker is not None and has_label and line.get_marker() in ("", "None"):
            line.set(marker=marker, markersize=3.5, markevery=0.3)
    if label is not None and has_label:
        line.set_label(f"{with_formulas(label)}: {line.get_label()}")


def _hull(a: tuple[float, float], b: tuple[float, float]) -> tuple[float, float]:
    """Return the smallest interval that contains two intervals."""
    return min(a[0], b[0]), max(a[1], b[1])
