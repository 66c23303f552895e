"""The picture of a team's run: who swam where, and what they learned together."""

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from ..base.arguments import public
from ..base.figures import COLOURS, GREY, TITLE, axes_for, figure_of
from ..paper.scenario.file import TEAM
from ..paper.scenario.recorded_run import check_run
from ..paper.scenario.team import team_of_run
from .comparison import response_plot
from .run_plots import clpe_plot, learning_plot
from .track_chart import (
    draw_first_flow,
    draw_track,
    positive,
    square_chart,
    told_apart,
    track_plot,
)

if TYPE_CHECKING:
    import xarray


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
    units, time = team.first.units, run.time.values
    points = [one.waypoints for one in team.members.values()]
    places = np.concatenate([*points, run.position.values.reshape(-1, 2)])
    draw_first_flow(chart, run, team.first, square_chart(chart, team.first, places, 18))
    known = "flow_parameters" in run
    wrong = run.flow_parameters_estimate - (run.flow_parameters if known else 0.0)
    errors = abs(wrong).max(("axis", "basis"))
    apart = (
        (run.alpha.max("vehicle") - run.alpha.min("vehicle"))
        .max(("axis", "basis"))
        .values
    )
    bottom.semilogy(time, positive(apart), ":", color=GREY, label="disagreement")
    for k, name in enumerate(team.members):
        own = run.sel(vehicle=name)
        with told_apart(axes, name, COLOURS[k % len(COLOURS)]):
            draw_track(chart, own, points[k])
            top.semilogy(
                time, positive(np.hypot(*own.clpe.values.T)), label="|e|", linewidth=0.7
            )
            bottom.semilogy(
                time,
                positive(errors.sel(vehicle=name).values),
                label="error" if known else "parameter",
            )
    chart.set_title("Waypoints, tracks, flow at t = 0", **TITLE)
    top.set(ylabel=f"|CLPE| ({units.length})")
    top.set_title("Prediction errors", **TITLE)
    bottom.set(
        xlabel=f"time ({units.time})", ylabel=f"size ({units.length}/{units.time})"
    )
    learned = "error of a flow parameter" if known else "flow parameter"
    bottom.set_title(f"Largest {learned} of each vehicle", **TITLE)
    for ax in (top, bottom):
        ax.set_xlim(time[0], time[-1])
    return axes


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
        plots = (
            {"team": (team_plot,)}
            if TEAM in run.attrs
            else {"response": (response_plot,)}
        )
    results: dict[Path, Any] = {}
    for name, (plot, *axis) in plots.items():
        figure = figure_of(plot, run, *axis)
        results |= {folder / f"{name}.{kind}": figure for kind in kinds}
    return results
