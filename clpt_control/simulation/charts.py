"""The chart of a run: waypoints, track and flow on the plane; what all its pictures share.

Nothing here integrates.
"""

from typing import TYPE_CHECKING, Any

import numpy as np

from ..arguments import public
from ..errors import ClptError
from ..figures import BLUE, COLOURS, GREY, RED, TITLE, axes_for, legend_below
from ..scenario.experiment import Scenario
from ..scenario.file import scenario_of_run
from ..scenario.recorded_run import check_run, waypoints_of

if TYPE_CHECKING:
    import xarray
    from matplotlib.axes import Axes


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
    known = {"color": BLUE, **coloured(color)}
    ax = axes_for(ax, 5.6, 5.2)
    if label:
        return _track_among(ax, scenario, points, run, label, color)
    from .flows import flow_to_draw

    unit = scenario.units.length
    grid = square_chart(ax, scenario, np.concatenate([points, path]), 13)
    flow = flow_to_draw(run, scenario, grid, 0.0)
    size = float(f"{np.hypot(*flow.T).max():.1g}")
    if size > 0:  # where all is at rest there are no arrows
        arrows = ax.quiver(*grid.T, *flow.T, color=GREY, alpha=0.6, width=0.0035)
        key = f"{size:g} {unit}/{scenario.units.time}"
        ax.quiverkey(arrows, 0.88, 1.02, size, key, labelpos="E")
    first = run.time.values <= (scenario.cycle if len(points) else np.inf)
    said = "track, first cycle" if len(points) else "track"
    ax.plot(*path[first].T, linewidth=1.4, label=said, **known)
    if (~first).any():
        ax.plot(*path[~first].T, linewidth=0.5, alpha=0.4, label="later cycles", **known)
    if len(points):
        ax.plot(*points.T, "o", color=RED, markersize=6, label="waypoints")
    elif "reference" in run:
        desired: dict[str, Any] = {"color": RED, "linewidth": 0.9, "linestyle": "--"}
        ax.plot(*run.reference.values.T, label="desired position", **desired)
    if len(points) <= 40:
        for k, point in enumerate(points, 1):
            ax.annotate(str(k), point, xytext=(5, 5), textcoords="offset points", fontsize=8)
    ax.plot(*path[0], "s", color="black", markersize=5, label="start")
    named = "Waypoints, track" if len(points) else "Track"
    ax.set_title(named + ", and flow at t = 0" * (size > 0), **TITLE)
    legend_below(ax, 4)
    return ax


def _track_among(
    ax: Any, scenario: Scenario, points: np.ndarray, run: Any, label: str, color: Any
) -> Any:
    """Draw a track, the predicted one and waypoints beside those of other runs."""
    path, earlier = run.position.values, ax.lines
    predicted = run.predicted_position.values if "predicted_position" in run else path[:0]
    places = [points, path, predicted, *(line.get_xydata() for line in earlier)]
    square_chart(ax, scenario, np.concatenate(places), 2)
    line = {**coloured(color), "linewidth": 1.1, "markevery": max(1, len(path) // 8)}
    line["color"] = ax.plot(*path.T, label=label, **line)[0].get_color()
    ax.plot(*predicted.T, linestyle="--", **line | {"linewidth": 0.8, "marker": ""})
    rings = {"color": line["color"], "markersize": 6 + 3 * (len(ax.lines) // 3)}
    ax.plot(*points.T, "o", markerfacecolor="none", **rings)
    named = "Tracks, predicted ones dashed" if len(predicted) else "Tracks"
    ax.set_title(f"{named}, waypoints as rings" if len(points) else named, **TITLE)
    legend_below(ax, 4)
    return ax


def square_chart(ax: Any, scenario: Scenario, places: np.ndarray, count: int) -> np.ndarray:
    """Make axes a square about places; return where arrows of the flow begin, `count` a side."""
    unit = scenario.units.length
    low, high = places.min(0), places.max(0)
    middle, half = (low + high) / 2, 0.62 * (max(high - low) or 1.0)
    low, high = middle - half, middle + half
    ax.set(xlabel=f"$x_1$, east ({unit})", ylabel=f"$x_2$, north ({unit})", aspect="equal")
    ax.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]))
    return arrow_grid(scenario, low, high, count)


def arrow_grid(scenario: Scenario, low: np.ndarray, high: np.ndarray, count: int) -> np.ndarray:
    """Return places (n, 2) in a box, `count` along its longer side, within the flow's field."""
    if scenario.field_path is not None:
        from ..currents.plane import read_field

        field = read_field(scenario.field_path, scenario.units)
        first, last = ([x[k] for x in (field.x1, field.x2)] for k in (0, -1))
        within = np.clip([low, high], first, last)
        if np.all(within[0] < within[1]):  # a clipped run may be beyond it all the time
            low, high = within
    step = max(high - low) / count
    sides = [np.arange(a + step / 2, b, step) for a, b in zip(low, high, strict=True)]
    return np.stack(np.meshgrid(*sides), -1).reshape(-1, 2)


def coloured(color: str | None) -> dict[str, Any]:
    """Return the colour of a run's lines, where it has one of its own, and the mark beside it."""
    from matplotlib.colors import is_color_like

    if color is not None and not is_color_like(color):
        raise ClptError(f"color = {color!r:.60}: must be a colour of matplotlib, 'C1' or '#0072b2'")
    marks = dict(zip(COLOURS, ("", *"osD^v"), strict=True))  # tell runs apart in black and white
    marked = {"marker": marks.get(str(color), ""), "markersize": 3.5, "markevery": 0.3}
    return {} if color is None else {"color": color, **marked}
