"""The picture of a team's run: who swam where, and what they learned together."""

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from ..arguments import public
from ..figures import GREY, TITLE, axes_for, figure_of, legend_below, line_style
from ..scenario.file import TEAM
from ..scenario.recorded_run import check_run
from ..scenario.team import Team, team_of_run
from .charts import arrow_grid, track_plot
from .comparing import response_plot
from .flows import flow_velocity
from .plots import clpe_plot, learning_plot

if TYPE_CHECKING:
    import xarray

MARKS = "os^vD*"
LEAST = 1e-16  # shown of what falls to zero


@public
def team_plot(run: "xarray.Dataset", *, ax: Any = None) -> Any:
    """Draw a team's tracks, CLPE and errors.

    Parameters
    ----------
    run : xarray.Dataset
        As `simulate` gives it for a team, or `load_run`.
    ax : array of 3 Axes, optional
        Where to draw; by default a new figure of pyplot's.

    Returns
    -------
    ndarray of Axes, shape (3,)
        Tracks, waypoints and the flow at the start; ``|e|`` of each vehicle; the largest error of a
        flow parameter of each, or without theta the estimates, and the largest disagreement.

    Raises
    ------
    DataError
        If the dataset is no run of a team.
    ClptError
        If `ax` are not three Axes.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> one = clpt.paper_scenario().with_values({"run.duration": 20})
    >>> team = clpt.Team(members={"a": one, "b": one}, coupling=0.5)
    >>> tracks, clpe, errors = team_plot(clpt.simulate(team))
    """
    team = team_of_run(run)
    check_run(run, team, "time", "position", "clpe")
    axes = axes_for(ax, 6.4, 8.4, nrows=3, height_ratios=[1.3, 1, 1.2])
    chart, top, bottom = axes
    lines = {name: {**line_style(k), "linewidth": 1.1} for k, name in enumerate(team.members)}
    _tracks(chart, run, team, lines)
    units, time = team.first.units, run.time.values
    apart = (run.alpha.max("vehicle") - run.alpha.min("vehicle")).max(("axis", "basis")).values
    known = "flow_parameters" in run
    wrong = run.flow_parameters_estimate - (run.flow_parameters if known else 0.0)
    errors = abs(wrong).max(("axis", "basis"))
    for name, line in lines.items():
        size = np.hypot(*run.clpe.sel(vehicle=name).values.T)
        top.semilogy(time, _positive(size), label=name, **{**line, "linewidth": 0.7})
        bottom.semilogy(time, _positive(errors.sel(vehicle=name).values), label=name, **line)
    most = {"color": GREY, "linewidth": 1.0, "linestyle": ":", "label": "largest disagreement"}
    bottom.semilogy(time, _positive(apart), **most)
    top.set(ylabel=f"|CLPE| ({units.length})")
    top.set_title("Prediction errors", **TITLE)
    bottom.set(xlabel=f"time ({units.time})", ylabel=f"size ({units.length}/{units.time})")
    learned = "error of a flow parameter" if known else "flow parameter"
    bottom.set_title(f"Largest {learned} of each vehicle", **TITLE)
    for ax in (top, bottom):
        ax.set_xlim(time[0], time[-1])
        ax.legend(frameon=False, fontsize=8, ncols=4)
    return axes


def _positive(values: np.ndarray) -> np.ndarray:
    """Return what a logarithmic axis can show."""
    return np.where(values > LEAST, values, np.nan)


def _tracks(ax: Any, run: "xarray.Dataset", team: Team, lines: dict[str, dict[str, Any]]) -> None:
    """Draw tracks and waypoints over the flow at the start."""
    unit, first = team.first.units, team.first
    points = np.concatenate([one.waypoints for one in team.members.values()])
    paths = np.concatenate([points, run.position.values.reshape(-1, 2)])
    low, high = paths.min(0), paths.max(0)
    rim = 0.08 * max(high - low)
    grid = arrow_grid(first, low - rim, high + rim, 18)
    flow = flow_velocity(first, grid, 0.0)
    if flow.any():
        ax.quiver(*grid.T, *flow.T, color=GREY, alpha=0.6, width=0.003)
    longest = f"{np.hypot(*flow.T).max():.2g} {unit.length}/{unit.time}"
    for k, (name, scenario) in enumerate(team.members.items()):
        path = run.position.sel(vehicle=name).values
        ax.plot(*path.T, **{**lines[name], "linewidth": 0.6}, alpha=0.7)
        mark = {"marker": MARKS[k % 6], "linestyle": "none", "markerfacecolor": "none"}
        size, colour = 4.5 + 1.5 * (k % 6), lines[name]["color"]  # waypoints of several may agree
        ax.plot(*scenario.waypoints.T, color=colour, label=name, markersize=size, **mark)
    ax.set(xlabel=f"$x_1$ ({unit.length})", ylabel=f"$x_2$ ({unit.length})", aspect="equal")
    ax.set_title(f"Waypoints, tracks, and flow at t = 0, at most {longest}", fontsize=10)
    legend_below(ax, 4)


def run_figures(
    run: "xarray.Dataset", folder: Path, kinds: Sequence[str] = ("png",)
) -> dict[Path, Any]:
    """Return the figures of a run by file: figure1.png to figure4.png, or team.png, response.png.

    They are track, CLPE and learning of both axes; of a diagram each port over time.
    """
    plots: dict[str, Any] = {
        "figure1": (track_plot,),
        "figure2": (clpe_plot,),
        "figure3": (learning_plot, 1),
        "figure4": (learning_plot, 2),
    }
    if "scenario" not in run.attrs:
        plots = {"team": (team_plot,)} if TEAM in run.attrs else {"response": (response_plot,)}
    results: dict[Path, Any] = {}
    for name, (plot, *axis) in plots.items():
        figure = figure_of(plot, run, *axis)
        results |= {folder / f"{name}.{kind}": figure for kind in kinds}
    return results
