"""Plots of a run over time: CLPE, flow parameters and gains of a vehicle, and a team's errors.

`run_plot` has the track and all plots of a vehicle in one figure, `team_plot` the tracks and errors
of a team.  Every plot returns the Axes on which it drew.
"""

from typing import TYPE_CHECKING, Any

import numpy as np

from ..base.arguments import public
from ..base.errors import ClptError
from ..base.figures import (
    BLUE,
    COLOURS,
    GREY,
    TITLE,
    axes_for,
    legend_above_data,
    line_style,
)
from ..paper.scenario.experiment import Scenario
from ..paper.scenario.recorded_run import (
    check_run,
    scenario_with,
    unknown_parts,
    waypoints_of,
)
from ..paper.scenario.team import team_of_run
from .track_chart import (
    TRUTH,
    draw_first_flow,
    draw_track,
    positive,
    run_style,
    square_chart,
    track_plot,
)

if TYPE_CHECKING:
    import xarray

DIRECTIONS = "east", "north"  # of x1 and x2
GAINS = {"feedback": "K", "feedforward": r"\Gamma"}
MANY = 100  # samples of an interval, for its mean square
MAX_FUNCTIONS = (
    6  # basis functions in a legend; more are numbered where their lines end
)
MAX_NUMBERED = 60
END_GAP = 0.024  # of the height of the axes, between these numbers
OVERVIEW = [
    ["track", "clpe"],
    ["track", "size"],
    ["east", "north"],
    ["gains 1", "gains 2"],
]


@public
def clpe_plot(
    run: "xarray.Dataset",
    *,
    ax: Any = None,
    label: str | None = None,
    color: str | None = None,
) -> Any:
    """Draw CLPE over time, with cycles above (figure 2).

    >>> import clpt_control as clpt
    >>> scenario = clpt.paper_scenario().with_values({"run.duration": 20})
    >>> top, bottom = clpe_plot(clpt.simulate(scenario))
    """
    scenario = scenario_with(run, "clpe")
    axes = axes_for(ax, 6.4, 5.4, nrows=2)
    top, bottom = axes
    units = scenario.units
    cycle = scenario.cycle
    has_waypoints = len(waypoints_of(run, scenario)) > 0
    time = run.time.values
    e = run.clpe.values
    early = time <= (2 * cycle if has_waypoints else np.inf)
    with run_style(axes, label, color):
        # components over the first cycles
        for i in range(2):
            name = f"$e_{i + 1}$"
            top.plot(time[early], e[early, i], label=name, lw=1.1, **line_style(i))
        top.set_ylabel(f"CLPE ({units.length})")
        top.set_xlim(0, max(time[early], default=2 * cycle))
        is_noisy = scenario.localization is not None and scenario.localization.noise > 0
        top.set_title("CLPE" + " of measured positions" * is_noisy, **TITLE)

        # size over the whole run
        size = np.hypot(*e.T)
        alpha = 0.5 if has_waypoints else 1
        bottom.semilogy(
            time, positive(size), color=BLUE, linewidth=0.5, alpha=alpha, label="|e|"
        )
        if has_waypoints:
            _draw_rms(bottom, time, size, scenario)
        bottom.set(xlabel=f"time ({units.time})", ylabel=f"|CLPE| ({units.length})")
        bottom.set_xlim(0, time[-1])
        if label is None:
            for panel in axes:
                legend_above_data(panel)
    if has_waypoints and not (top.child_axes or bottom.child_axes):
        _draw_cycles(axes, cycle)
    return axes


def _draw_rms(ax: Any, time: np.ndarray, size: np.ndarray, scenario: Scenario) -> None:
    """Draw the rms of |e| over the time at each waypoint."""
    dwell = scenario.reference.dwell
    interval = np.floor(time / dwell + 1e-9).astype(int)
    counts = np.bincount(interval)
    sums = np.bincount(interval, size**2)
    rms = np.sqrt(sums / np.where(counts > 0, counts, np.nan))
    label = f"rms of each {dwell:g} {scenario.units.time}"
    if len(size) < MANY * len(counts):  # a figure of a long run has fewer samples
        label += ", of the samples shown"
    starts = dwell * np.arange(len(counts))
    ax.step(starts, positive(rms), "black", where="post", linewidth=1.2, label=label)


def _draw_cycles(axes: Any, cycle: float) -> None:
    """Draw an axis of cycles above each of some Axes."""
    functions = (lambda t: t / cycle, lambda n: n * cycle)
    for ax in axes:
        above = ax.secondary_xaxis("top", functions=functions)
        above.locator_params(axis="x", integer=True)
        above.tick_params(labelsize=7, colors=GREY)
        above.set_xlabel("cycles", fontsize=7, color=GREY, loc="right")


@public
def learning_plot(
    run: "xarray.Dataset",
    axis: int = 1,
    *,
    ax: Any = None,
    label: str | None = None,
    color: str | None = None,
) -> Any:
    """Draw flow parameters and gains of one axis (figures 3, 4).

    >>> import clpt_control as clpt
    >>> scenario = clpt.paper_scenario().with_values({"run.duration": 20})
    >>> parameters, gains = learning_plot(clpt.simulate(scenario), 2)
    """
    if axis not in (1, 2):
        raise ClptError(f"axis = {axis!r:.60}: must be 1, east, or 2, north")
    names = "flow_parameters_estimate", "feedback_gain", "feedforward_gain"
    scenario = scenario_with(run, *names)
    axes = axes_for(ax, 6.4, 5.4, nrows=2, sharex=True)
    with run_style(axes, label, color):
        _draw_estimates(axes[0], run, scenario, axis, is_single=label is None)
        _draw_gains(axes[1], run, scenario, axis)
        if label is None:  # the legend of one of several runs stands beside the axes
            for panel in axes:
                legend_above_data(panel)
        _set_learning_time(axes, run, scenario)
    return axes


def _draw_estimates(
    ax: Any, run: "xarray.Dataset", scenario: Scenario, axis: int, is_single: bool
) -> None:
    """Draw the estimates of one axis' flow parameters, and the true values."""
    i = axis - 1
    estimates = run.flow_parameters_estimate.values[:, i].T
    is_few = len(estimates) <= MAX_FUNCTIONS
    is_numbered = is_single and not is_few and len(estimates) <= MAX_NUMBERED
    for k, estimate in enumerate(estimates):
        label = rf"$\hat\theta_{axis}^{{{k + 1}}}$"
        if not is_few:
            label = "_" if k or is_numbered else "estimates"
        linewidth = 1.2 if is_few else 0.6
        style = line_style(k)
        ax.plot(run.time.values, estimate, linewidth=linewidth, label=label, **style)
        if "flow_parameters" in run:
            _draw_truth(ax, run.flow_parameters.values[i][k], style)
    row = scenario.learning.row
    if is_numbered:
        _number_ends(ax, np.nan_to_num(estimates[:, -1]))
    source = "estimate = $-\\alpha$"
    if row.alpha_is_constant:
        source = "given estimate" if row.given_estimate else "estimate of the filter"
    truth = ", true values thin" if "flow_parameters" in run else ""
    count = "" if is_few else f" of {len(estimates)} functions"
    count += ", numbered" if is_numbered else ""
    ax.set_title(f"Flow to the {DIRECTIONS[i]}, {source}{count}{truth}", **TITLE)
    units = scenario.units
    ax.set_ylabel(f"flow parameter ({units.length}/{units.time})")


def _number_ends(ax: Any, ends: np.ndarray) -> None:
    """Write the number of each line right of its end, in two columns.

    Places are the nearest to the ends, by least squares, that are a gap apart.
    """
    from scipy.optimize import isotonic_regression

    ax.autoscale(axis="y")
    low, high = ax.get_ylim()
    order = np.argsort(ends)
    heights = (ends[order] - low) / (high - low)
    steps = min(END_GAP, 1 / len(ends)) * np.arange(len(ends))
    positions = isotonic_regression(heights - steps).x + steps
    for k, (number, height, position) in enumerate(
        zip(order, heights, positions, strict=True)
    ):
        color = line_style(number)["color"]
        ax.annotate(
            str(number + 1),
            (1, height),
            (1.02 + 0.03 * (k % 2), position),
            "axes fraction",
            "axes fraction",
            {"arrowstyle": "-", "linewidth": 0.3, "color": color, "shrinkA": 0},
            fontsize=6,
            va="center",
            color=color,
            annotation_clip=False,
        )
    ax.set_ylim(low, high)


def _draw_gains(ax: Any, run: "xarray.Dataset", scenario: Scenario, axis: int) -> None:
    """Draw the gains of one axis, and the true values."""
    i = axis - 1
    has_truth = "vehicle_controller" not in unknown_parts(run)
    for k, (name, symbol) in enumerate(GAINS.items()):
        style = line_style(k)
        gain = run[f"{name}_gain"].values[:, i]
        label = f"${symbol}_{axis}$"
        ax.plot(run.time.values, gain, label=label, linewidth=1.2, **style)
        if has_truth:
            _draw_truth(ax, getattr(scenario.vehicle, name)[i], style)
    ax.set_title(f"Gains{', true values thin' if has_truth else ''}", **TITLE)
    ax.set_ylabel(f"gain (1/{scenario.units.time})")


def _draw_truth(ax: Any, value: float, style: dict[str, Any]) -> None:
    ax.axhline(value, color=style["color"], linewidth=0.7, alpha=0.7, gid=TRUTH)


def _set_learning_time(axes: Any, run: "xarray.Dataset", scenario: Scenario) -> None:
    """Set the time axes, logarithmic after one cycle if the run is longer than two."""
    time = run.time.values
    label = f"time ({scenario.units.time})"
    cycle = scenario.cycle if len(waypoints_of(run, scenario)) else np.inf
    for ax in axes:
        ax.set_xlim(time[0], time[-1])
        if time[-1] > 2 * cycle:
            ax.set_xscale("symlog", linthresh=cycle)
            linear = [cycle * k / 4 for k in range(4)]
            doubled = [cycle * 2**k for k in range(5)]
            ticks = [t for t in linear + doubled if 1.2 * t < time[-1]] + [time[-1]]
            ax.set_xticks(ticks, [f"{t:g}" for t in ticks])
            ax.minorticks_off()
    if time[-1] > 2 * cycle:
        label += ", logarithmic after one cycle"
    axes[-1].set_xlabel(label)


@public
def run_plot(
    run: "xarray.Dataset",
    *,
    ax: Any = None,
    label: str | None = None,
    color: str | None = None,
) -> Any:
    """Draw track, CLPE and learning of both axes in one figure.

    >>> import clpt_control as clpt
    >>> scenario = clpt.paper_scenario().with_values({"run.duration": 20})
    >>> axes = run_plot(clpt.simulate(scenario))
    """
    scenario_with(run, "position", "clpe", "flow_parameters_estimate")
    axes = axes_for(ax, 11.0, 10.0, mosaic=OVERVIEW)
    options = {"label": label, "color": color}
    track_plot(run, ax=axes[0], **options)
    clpe_plot(run, ax=axes[1:3], **options)
    for axis in (1, 2):
        learning_plot(run, axis, ax=axes[[2 + axis, 4 + axis]], **options)
    return axes


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
    disagreement = run.alpha.reduce(np.ptp, "vehicle").max(("axis", "basis")).values
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
    chart.set_title("Tracks, flow at t = 0", **TITLE)
    top.set_ylabel(f"|CLPE| ({units.length})")
    top.set_title("Prediction errors", **TITLE)
    bottom.set_xlabel(f"time ({units.time})")
    bottom.set_ylabel(f"size ({units.length}/{units.time})")
    quantity = "error of a flow parameter" if has_truth else "flow parameter"
    bottom.set_title(f"Largest {quantity} of each vehicle", **TITLE)
    for panel in (top, bottom):
        panel.set_xlim(time[0], time[-1])
    return axes
