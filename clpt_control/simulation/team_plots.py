"""Plot of a team's run: tracks, prediction errors and errors of the flow parameters."""

from typing import TYPE_CHECKING, Any

import numpy as np

from ..base.arguments import public
from ..base.figures import COLOURS, GREY, TITLE, axes_for
from ..paper.scenario.recorded_run import check_run
from ..paper.scenario.team import team_of_run
from .track_chart import draw_first_flow, draw_track, positive, run_style, square_chart

if TYPE_CHECKING:
    import xarray


@public
def team_plot(run: "xarray.Dataset", *, ax: Any = None) -> Any:
    """Draw a team's tracks, CLPE and errors.

    >>> import clpt_control as clpt
    >>> paper = clpt.paper_scenario().with_values({"run.duration": 20})
    >>> team = clpt.Team(members={"a": paper, "b": paper}, coupling=0.5)
    >>> tracks, clpe, errors = team_plot(clpt.simulate(team))
    """
    team = team_of_run(run)
    check_run(run, team, "time", "position", "clpe")
    axes = axes_for(ax, 6.4, 8.4, nrows=3, height_ratios=[1.3, 1, 1.2])
    chart, top, bottom = axes
    units = team.first.units
    time = run.time.values
    waypoints = [scenario.waypoints for scenario in team.members.values()]
    points = np.concatenate([*waypoints, run.position.values.reshape(-1, 2)])
    draw_first_flow(chart, run, team.first, square_chart(chart, team.first, points, 18))
    has_truth = "flow_parameters" in run
    errors = run.flow_parameters_estimate
    if has_truth:
        errors = errors - run.flow_parameters
    errors = abs(errors).max(("axis", "basis"))
    disagreement = run.alpha.max("vehicle") - run.alpha.min("vehicle")
    disagreement = disagreement.max(("axis", "basis")).values
    bottom.semilogy(time, positive(disagreement), ":", color=GREY, label="disagreement")
    for k, name in enumerate(team.members):
        vehicle_run = run.sel(vehicle=name)
        e = np.hypot(*vehicle_run.clpe.values.T)
        error = errors.sel(vehicle=name).values
        with run_style(axes, name, COLOURS[k % len(COLOURS)]):
            draw_track(chart, vehicle_run, waypoints[k])
            top.semilogy(time, positive(e), label="|e|", linewidth=0.7)
            label = "error" if has_truth else "parameter"
            bottom.semilogy(time, positive(error), label=label)
    chart.set_title("Waypoints, tracks, flow at t = 0", **TITLE)
    top.set_ylabel(f"|CLPE| ({units.length})")
    top.set_title("Prediction errors", **TITLE)
    bottom.set_xlabel(f"time ({units.time})")
    bottom.set_ylabel(f"size ({units.length}/{units.time})")
    quantity = "error of a flow parameter" if has_truth else "flow parameter"
    bottom.set_title(f"Largest {quantity} of each vehicle", **TITLE)
    for panel in (top, bottom):
        panel.set_xlim(time[0], time[-1])
    return axes
