"""Pictures of a run: of data, a `matplotlib.figure.Figure`; nothing here integrates."""

from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from ..errors import ClptError
from ..figures import BLUE, COLOURS, GREY, RED, STYLES, new_figure
from ..files import write_figure
from ..scenario.experiment import Scenario

TITLE: dict[str, Any] = {"loc": "left", "fontsize": 10}
MANY = 100  # samples an interval, for its mean square

if TYPE_CHECKING:
    import xarray
    from matplotlib.figure import Figure


def track_plot(run: "xarray.Dataset", scenario: Scenario) -> "Figure":
    """Draw waypoints, track and the flow at the start (figure 1).

    Parameters
    ----------
    run : xarray.Dataset
        As `simulate` gives it.
    scenario : Scenario
        Its scenario.

    Returns
    -------
    Figure
        Axes in the scenario's unit of length.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> scenario = clpt.paper_scenario().with_values({"run.duration": 20})
    >>> figure = track_plot(clpt.simulate(scenario), scenario)
    """
    from .flows import flow_velocity

    figure, ax = new_figure(5.6, 5.2)
    points, path, unit = scenario.waypoints, run.position.values, scenario.units.length
    low = np.minimum(points.min(0), path.min(0))
    high = np.maximum(points.max(0), path.max(0))
    middle, half = (low + high) / 2, 0.62 * max(high - low)
    grid = np.stack(np.meshgrid(*(np.linspace(m - half, m + half, 13) for m in middle)), -1)
    flow = flow_velocity(scenario, grid.reshape(-1, 2), 0.0)
    arrows = ax.quiver(*grid.reshape(-1, 2).T, *flow.T, color=GREY, alpha=0.6, width=0.0035)
    size = float(f"{np.hypot(*flow.T).max():.1g}")
    ax.quiverkey(arrows, 0.88, 1.02, size, f"{size:g} {unit}/{scenario.units.time}", labelpos="E")
    first = run.time.values <= scenario.cycle
    ax.plot(*path[first].T, color=BLUE, linewidth=1.4, label="track, first cycle")
    if (~first).any():
        ax.plot(*path[~first].T, color=BLUE, linewidth=0.5, alpha=0.4, label="later cycles")
    ax.plot(*points.T, "o", color=RED, markersize=6, label="waypoints")
    if len(points) <= 40:
        for k, point in enumerate(points, 1):
            ax.annotate(str(k), point, xytext=(5, 5), textcoords="offset points", fontsize=8)
    ax.plot(*path[0], "s", color="black", markersize=5, label="start")
    ax.set(xlabel=f"$x_1$ ({unit})", ylabel=f"$x_2$ ({unit})", aspect="equal")
    ax.set(xlim=(middle[0] - half, middle[0] + half), ylim=(middle[1] - half, middle[1] + half))
    ax.set_title("Waypoints, track, and flow at t = 0", **TITLE)
    ax.legend(loc="upper center", bbox_to_anchor=(0.5, -0.12), ncols=4, fontsize=8, frameon=False)
    return figure


def clpe_plot(run: "xarray.Dataset", scenario: Scenario) -> "Figure":
    """Draw CLPE against waypoint intervals (figure 2).

    Parameters
    ----------
    run : xarray.Dataset
        As `simulate` gives it.
    scenario : Scenario
        Its scenario.

    Returns
    -------
    Figure
        Components over the first cycles; size over the whole run, logarithmic.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> scenario = clpt.paper_scenario().with_values({"run.duration": 20})
    >>> figure = clpe_plot(clpt.simulate(scenario), scenario)
    """
    figure, (top, bottom) = new_figure(6.4, 5.4, nrows=2)
    dwell, unit = scenario.reference.dwell, scenario.units.length
    count = len(scenario.waypoints)
    interval, e = run.time.values / dwell, run.clpe.values
    early = interval <= 2 * count
    for i in range(2):
        line: dict[str, Any] = {
            "color": COLOURS[i],
            "linestyle": STYLES[i],
            "label": f"$e_{i + 1}$",
        }
        top.plot(interval[early], e[early, i], linewidth=1.1, **line)
    top.axvline(count, color=GREY, linewidth=0.8, linestyle=":")
    place = {"xytext": (3, -9), "textcoords": "offset points"}
    top.annotate("one cycle", (count, top.get_ylim()[1]), fontsize=8, color=GREY, **place)
    top.set(ylabel=f"CLPE ({unit})", xlim=(0, max(interval[early])))
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
    line = {"color": "black", "linewidth": 1.2, "label": label}
    bottom.step(np.arange(len(counts)), np.maximum(rms, 1e-12), where="post", **line)
    bottom.set(xlabel="interval", ylabel=f"|CLPE| ({unit})", xlim=(0, interval[-1]))
    if size.max() > 0:
        bottom.set_ylim(bottom=max(1e-12, np.nanmin(np.where(size > 0, size, np.nan)) / 2))
    bottom.legend(frameon=False, fontsize=8)
    return figure


def learning_plot(run: "xarray.Dataset", scenario: Scenario, axis: int) -> "Figure":
    """Draw flow parameters and gains of one axis (figures 3, 4).

    Parameters
    ----------
    run : xarray.Dataset
        As `simulate` gives it.
    scenario : Scenario
        Its scenario.
    axis : int
        1, horizontal, or 2, vertical.

    Returns
    -------
    Figure
        Estimates as lines, true values as thin horizontal lines.

    Raises
    ------
    ClptError
        If there is no such axis.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> scenario = clpt.paper_scenario().with_values({"run.duration": 20})
    >>> figure = learning_plot(clpt.simulate(scenario), scenario, 1)
    """
    if axis not in (1, 2):
        raise ClptError(f"axis = {axis}: must be 1, horizontal, or 2, vertical")
    figure, (top, bottom) = new_figure(6.4, 5.4, nrows=2, sharex=True)
    time, i, units = run.time.values, axis - 1, scenario.units
    estimate = run.flow_parameters_estimate.values[:, i]
    N = estimate.shape[1]
    for k in range(N):
        colour, style = COLOURS[k % 6], STYLES[k % 6]
        name = rf"$\hat\theta_{axis}^{{{k + 1}}}$" if N <= 6 else None
        width = 1.2 if N <= 6 else 0.6
        top.plot(time, estimate[:, k], color=colour, linestyle=style, linewidth=width, label=name)
        if scenario.flow.parameters is not None:
            top.axhline(scenario.flow.parameters[i][k], color=colour, linewidth=0.7, alpha=0.7)
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
    for k, (name, symbol, true) in enumerate(gains):
        line = {"color": COLOURS[k], "linestyle": STYLES[k], "label": f"${symbol}_{axis}$"}
        bottom.plot(time, run[name].values[:, i], linewidth=1.2, **line)
        bottom.axhline(true[i], color=COLOURS[k], linewidth=0.7, alpha=0.7)
    bottom.set_title("Gains, true values thin", **TITLE)
    bottom.set(xlabel=f"time ({units.time})", ylabel=f"gain (1/{units.time})")
    bottom.set_xlim(time[0], time[-1])
    if N <= 6:
        top.legend(frameon=False, fontsize=9, ncols=3)
    bottom.legend(frameon=False, fontsize=9, ncols=2)
    return figure


def save_figures(run: "xarray.Dataset", scenario: Scenario, folder: Path) -> list[Path]:
    """Write figure1.png to figure4.png: track, CLPE, horizontal and vertical learning."""
    learning = (learning_plot(run, scenario, axis) for axis in (1, 2))
    figures = (track_plot(run, scenario), clpe_plot(run, scenario), *learning)
    paths = [Path(folder) / f"figure{number}.png" for number in (1, 2, 3, 4)]
    for figure, path in zip(figures, paths, strict=True):
        write_figure(figure, path)
    return paths
