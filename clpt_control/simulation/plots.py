"""Pictures of a run: each returns the Axes that it drew on.

Nothing here integrates.
"""

from typing import TYPE_CHECKING, Any

import numpy as np

from ..arguments import public
from ..errors import ClptError, DataError
from ..figures import BLUE, GREY, RED, axes_for, legend_below, line_style
from ..scenario.experiment import Scenario
from ..scenario.file import scenario_of_run
from ..scenario.recorded_run import check_run

TITLE: dict[str, Any] = {"loc": "left", "fontsize": 10}
MANY = 100  # samples an interval, for its mean square
PORTS = 16  # of a picture of any diagram
STATES = "states"

if TYPE_CHECKING:
    import xarray
    from matplotlib.axes import Axes

OVERVIEW = [
    ["track", "clpe"],
    ["track", "size"],
    ["horizontal", "vertical"],
    ["gains 1", "gains 2"],
]


def scenario_with(run: "xarray.Dataset", *names: str) -> Scenario:
    """Return the scenario of a run that has some variables along its time."""
    scenario = scenario_of_run(run)
    check_run(run, scenario, "time", *names)
    return scenario


@public
def track_plot(run: "xarray.Dataset", *, ax: "Axes | None" = None) -> "Axes":
    """Draw waypoints, track and the flow at the start (figure 1).

    Parameters
    ----------
    run : xarray.Dataset
        As `simulate` gives it, or `load_run`.
    ax : Axes, optional
        Where to draw; by default a new figure of pyplot's.

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
    from .flows import flow_velocity

    scenario = scenario_with(run, "position")
    ax = axes_for(ax, 5.6, 5.2)
    points, path, unit = scenario.waypoints, run.position.values, scenario.units.length
    grid, _ = square_chart(ax, scenario, path, 13)
    flow = flow_velocity(scenario, grid, 0.0)
    size = float(f"{np.hypot(*flow.T).max():.1g}")
    if size > 0:  # where all is at rest there are no arrows
        arrows = ax.quiver(*grid.T, *flow.T, color=GREY, alpha=0.6, width=0.0035)
        key = f"{size:g} {unit}/{scenario.units.time}"
        ax.quiverkey(arrows, 0.88, 1.02, size, key, labelpos="E")
    first = run.time.values <= scenario.cycle
    ax.plot(*path[first].T, color=BLUE, linewidth=1.4, label="track, first cycle")
    if (~first).any():
        ax.plot(*path[~first].T, color=BLUE, linewidth=0.5, alpha=0.4, label="later cycles")
    ax.plot(*points.T, "o", color=RED, markersize=6, label="waypoints")
    if len(points) <= 40:
        for k, point in enumerate(points, 1):
            ax.annotate(str(k), point, xytext=(5, 5), textcoords="offset points", fontsize=8)
    ax.plot(*path[0], "s", color="black", markersize=5, label="start")
    ax.set_title("Waypoints, track, and flow at t = 0", **TITLE)
    legend_below(ax, 4)
    return ax


def square_chart(
    ax: Any, scenario: Scenario, path: np.ndarray, count: int
) -> tuple[np.ndarray, float]:
    """Make axes a square about waypoints and track; return places on it, and half its side."""
    seen, unit = np.concatenate([scenario.waypoints, path]), scenario.units.length
    low, high = seen.min(0), seen.max(0)
    middle, half = (low + high) / 2, 0.62 * (max(high - low) or 1.0)
    ax.set(xlabel=f"$x_1$ ({unit})", ylabel=f"$x_2$ ({unit})", aspect="equal")
    ax.set(xlim=(middle[0] - half, middle[0] + half), ylim=(middle[1] - half, middle[1] + half))
    grid = np.stack(np.meshgrid(*(np.linspace(m - half, m + half, count) for m in middle)), -1)
    return grid.reshape(-1, 2), half


@public
def clpe_plot(run: "xarray.Dataset", *, ax: Any = None) -> Any:
    """Draw CLPE against waypoint intervals (figure 2).

    Parameters
    ----------
    run : xarray.Dataset
        As `simulate` gives it, or `load_run`.
    ax : array of 2 Axes, optional
        Where to draw; by default a new figure of pyplot's.

    Returns
    -------
    ndarray of Axes, shape (2,)
        Components over the first cycles; size over the whole run, logarithmic.

    Raises
    ------
    DataError
        If the dataset is no run of one vehicle.
    ClptError
        If `ax` are not two Axes.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> scenario = clpt.paper_scenario().with_values({"run.duration": 20})
    >>> top, bottom = clpe_plot(clpt.simulate(scenario))
    """
    scenario = scenario_with(run, "clpe")
    axes = axes_for(ax, 6.4, 5.4, nrows=2)
    top, bottom = axes
    dwell, unit = scenario.reference.dwell, scenario.units.length
    count = len(scenario.waypoints)
    interval, e = run.time.values / dwell, run.clpe.values
    early = interval <= 2 * count
    for i in range(2):
        top.plot(interval[early], e[early, i], label=f"$e_{i + 1}$", linewidth=1.1, **line_style(i))
    top.axvline(count, color=GREY, linewidth=0.8, linestyle=":")
    place = {"xytext": (3, -9), "textcoords": "offset points"}
    top.annotate("one cycle", (count, top.get_ylim()[1]), fontsize=8, color=GREY, **place)
    top.set(ylabel=f"CLPE ({unit})", xlim=(0, max(interval[early], default=2 * count)))
    top.legend(frameon=False, fontsize=8)
    top.set_title(f"CLPE; each interval is one waypoint, {dwell:g} {scenario.units.time}", **TITLE)
    size = np.hypot(*e.T)
    drawn = np.maximum(size, 1e-12)
    bottom.semilogy(interval, drawn, color=BLUE, linewidth=0.5, alpha=0.5, label="|e|")
    number = np.floor(interval + 1e-9).astype(int)
    counts = np.bincount(number)
    rms = np.sqrt(np.bincount(number, size**2) / np.where(counts > 0, counts, np.nan))
    few = len(size) < MANY * len(counts)  # the pictures of a long run have fewer samples
    label = "rms per interval" + (", of the samples shown" if few else "")
    line: dict[str, Any] = {"color": "black", "linewidth": 1.2, "label": label}
    bottom.step(np.arange(len(counts)), np.maximum(rms, 1e-12), where="post", **line)
    bottom.set(xlabel="interval", ylabel=f"|CLPE| ({unit})", xlim=(0, interval[-1]))
    if size.max() > 0:
        bottom.set_ylim(bottom=max(1e-12, np.nanmin(np.where(size > 0, size, np.nan)) / 2))
    bottom.legend(frameon=False, fontsize=8)
    return axes


@public
def learning_plot(run: "xarray.Dataset", axis: int = 1, *, ax: Any = None) -> Any:
    """Draw flow parameters and gains of one axis (figures 3, 4).

    Parameters
    ----------
    run : xarray.Dataset
        As `simulate` gives it, or `load_run`.
    axis : int, optional
        1, horizontal, or 2, vertical.
    ax : array of 2 Axes, optional
        Where to draw; by default a new figure of pyplot's.

    Returns
    -------
    ndarray of Axes, shape (2,)
        Estimates as lines, true values as thin horizontal lines: flow parameters, gains.

    Raises
    ------
    ClptError
        If there is no such axis, or `ax` are not two Axes.
    DataError
        If the dataset is no run of one vehicle.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> scenario = clpt.paper_scenario().with_values({"run.duration": 20})
    >>> parameters, gains = learning_plot(clpt.simulate(scenario), 2)
    """
    if axis not in (1, 2):
        raise ClptError(f"axis = {axis!r:.60}: must be 1, horizontal, or 2, vertical")
    names = "flow_parameters_estimate", "feedback_gain", "feedforward_gain"
    scenario = scenario_with(run, *names)
    axes = axes_for(ax, 6.4, 5.4, nrows=2, sharex=True)
    top, bottom = axes
    time, i, units = run.time.values, axis - 1, scenario.units
    estimate = run.flow_parameters_estimate.values[:, i]
    N = estimate.shape[1]
    for k in range(N):
        line = line_style(k)
        name = rf"$\hat\theta_{axis}^{{{k + 1}}}$" if N <= 6 else None
        width = 1.2 if N <= 6 else 0.6
        top.plot(time, estimate[:, k], linewidth=width, label=name, **line)
        if scenario.flow.parameters is not None:
            true = scenario.flow.parameters[i][k]
            top.axhline(true, color=line["color"], linewidth=0.7, alpha=0.7)
    direction = "horizontal" if axis == 1 else "vertical"
    truth = ", true values thin" if scenario.flow.parameters is not None else ""
    row, estimated = scenario.learning.row, "estimate = $-\\alpha$"
    if row.keeps_alpha:
        estimated = "given estimate" if row.given_estimate else "estimate of the filter"
    top.set_title(f"Parameters of the {direction} flow, {estimated}{truth}", **TITLE)
    top.set_ylabel(f"flow parameter ({units.length}/{units.time})")
    gains = (
        ("feedback_gain", "K", scenario.vehicle.feedback),
        ("feedforward_gain", r"\Gamma", scenario.vehicle.feedforward),
    )
    for k, (gain, symbol, known) in enumerate(gains):
        line = line_style(k)
        values = run[gain].values[:, i]
        bottom.plot(time, values, label=f"${symbol}_{axis}$", linewidth=1.2, **line)
        bottom.axhline(known[i], color=line["color"], linewidth=0.7, alpha=0.7)
    bottom.set_title("Gains, true values thin", **TITLE)
    bottom.set(xlabel=f"time ({units.time})", ylabel=f"gain (1/{units.time})")
    for one in axes:
        one.set_xlim(time[0], time[-1])
    if N <= 6:
        top.legend(frameon=False, fontsize=9, ncols=3)
    bottom.legend(frameon=False, fontsize=9, ncols=2)
    return axes


@public
def run_plot(run: "xarray.Dataset", *, ax: Any = None) -> Any:
    """Draw track, CLPE and learning of both axes in one figure.

    Parameters
    ----------
    run : xarray.Dataset
        As `simulate` gives it, or `load_run`.
    ax : array of 7 Axes, optional
        Where to draw; by default a new figure of pyplot's.

    Returns
    -------
    ndarray of Axes, shape (7,)
        Track, the two of `clpe_plot`, flow parameters of both axes, gains of both.

    Raises
    ------
    DataError
        If the dataset is no run of one vehicle.
    ClptError
        If `ax` are not seven Axes.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> scenario = clpt.paper_scenario().with_values({"run.duration": 20})
    >>> axes = run_plot(clpt.simulate(scenario))
    """
    scenario_with(run, "position", "clpe", "flow_parameters_estimate")
    axes = axes_for(ax, 11.0, 10.0, mosaic=OVERVIEW)
    track_plot(run, ax=axes[0])
    clpe_plot(run, ax=axes[1:3])
    for axis in (1, 2):
        learning_plot(run, axis, ax=axes[[2 + axis, 4 + axis]])
    return axes


@public
def response_plot(run: "xarray.Dataset", *, ax: Any = None) -> Any:
    """Draw each port of a diagram's run over time.

    Parameters
    ----------
    run : xarray.Dataset
        As `simulate` gives it for a diagram.
    ax : array of Axes, optional
        Where to draw, one for each port; by default a new figure of pyplot's.

    Returns
    -------
    Axes or ndarray of Axes, shape (n,)
        One for each of the n ports, in the order of the run's variables.

    Raises
    ------
    DataError
        If the dataset has no signal along time, or more than 16: choose some, ``run[["x", "e"]]``.
    ClptError
        If `ax` are fewer or more Axes.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> loop = clpt.closed_loop(clpt.paper_scenario())
    >>> run = clpt.simulate(loop, [0.0, 1.0, 2.0])
    >>> x, e = clpt.simulation.response_plot(run[["position", "clpe"]])
    """
    ports = [str(n) for n, one in run.data_vars.items() if "time" in one.dims and n != STATES]
    if not 0 < len(ports) <= PORTS:
        raise DataError(
            f"the run has {len(ports)} signals along time; one picture shows 1 to {PORTS}: choose "
            "some, as run[['x', 'e']]"
        )
    axes = axes_for(ax, 6.4, 1.2 + 1.3 * len(ports), nrows=len(ports), sharex=True)
    for one, port in zip(np.ravel(axes), ports, strict=True):
        values = run[port].values.reshape(run.sizes["time"], -1)
        for k, column in enumerate(values.T):
            one.plot(run.time.values, column, label=f"{k + 1}", linewidth=1.1, **line_style(k))
        one.set_ylabel(_named(port, run[port].attrs.get("units")))
        if 1 < values.shape[1] <= 6:
            one.legend(frameon=False, fontsize=8, ncols=6, loc="upper right")
    one.set_xlabel(_named("time", run.time.attrs.get("units")))
    return axes


def _named(name: str, units: str | None) -> str:
    return f"{name} ({units})" if units else name
