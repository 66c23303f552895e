"""Pictures of a scenario's run over time: CLPE, flow parameters and gains, all in one figure.

Each returns the Axes that it drew on; nothing here integrates.
"""

from typing import TYPE_CHECKING, Any

import numpy as np

from ..base.arguments import public
from ..base.errors import ClptError
from ..base.figures import BLUE, GREY, TITLE, axes_for, line_style
from ..paper.scenario.recorded_run import unknown_parts, waypoints_of
from .track_chart import positive, scenario_with, told_apart, track_plot

if TYPE_CHECKING:
    import xarray

DIRECTIONS = "east", "north"  # of x1 and x2
MANY = 100  # samples an interval, for its mean square
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

    Parameters
    ----------
    run : xarray.Dataset
        As `simulate` gives it, or `load_run`.
    ax : array of 2 Axes, optional
        Where to draw; by default a new figure of pyplot's.
    label, color : optional
        Of a run among several on the same Axes: its name in the legend and one colour for all of
        its lines, whose styles tell its signals apart; `compare` gives them.

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
    units, count = scenario.units, len(waypoints_of(run, scenario))
    dwell, cycle = scenario.reference.dwell, scenario.cycle
    time, e = run.time.values, run.clpe.values
    early = time <= (2 * cycle if count else np.inf)
    with told_apart(axes, label, color):
        for i in range(2):
            top.plot(
                time[early], e[early, i], label=f"$e_{i + 1}$", lw=1.1, **line_style(i)
            )
        top.set(
            ylabel=f"CLPE ({units.length})",
            xlim=(0, max(time[early], default=2 * cycle)),
        )
        top.set_title("CLPE", **TITLE)
        size = np.hypot(*e.T)
        shade: dict[str, Any] = {
            "color": BLUE,
            "linewidth": 0.5,
            "alpha": 0.5 if count else 1,
        }
        bottom.semilogy(time, positive(size), label="|e|", **shade)
        if count:
            number = np.floor(time / dwell + 1e-9).astype(int)
            counts = np.bincount(number)
            rms = np.sqrt(
                np.bincount(number, size**2) / np.where(counts > 0, counts, np.nan)
            )
            # the pictures of a long run have fewer samples
            few = len(size) < MANY * len(counts)
            name = f"rms of each {dwell:g} {units.time}{', of the samples shown' * few}"
            steps = dwell * np.arange(len(counts))
            bottom.step(
                steps,
                positive(rms),
                where="post",
                color="black",
                linewidth=1.2,
                label=name,
            )
        bottom.set(xlabel=f"time ({units.time})", ylabel=f"|CLPE| ({units.length})")
        bottom.set_xlim(0, time[-1])
        for one in axes:
            one.legend(frameon=False, fontsize=8)
    if count and not (top.child_axes or bottom.child_axes):
        for one in axes:
            above = one.secondary_xaxis(
                "top", functions=(lambda t: t / cycle, lambda n: n * cycle)
            )
            above.locator_params(axis="x", integer=True)
            above.tick_params(labelsize=7, colors=GREY)
        top.child_axes[0].set_xlabel("cycles", fontsize=7, color=GREY, loc="right")
    return axes


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

    Parameters
    ----------
    run : xarray.Dataset
        As `simulate` gives it, or `load_run`.
    axis : int, optional
        1, east, or 2, north.
    ax : array of 2 Axes, optional
        Where to draw; by default a new figure of pyplot's.
    label, color : optional
        Of a run among several on the same Axes: its name in the legend and one colour for all of
        its lines, whose styles tell its signals apart; `compare` gives them.

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
        raise ClptError(f"axis = {axis!r:.60}: must be 1, east, or 2, north")
    names = "flow_parameters_estimate", "feedback_gain", "feedforward_gain"
    scenario = scenario_with(run, *names)
    axes = axes_for(ax, 6.4, 5.4, nrows=2, sharex=True)
    top, bottom = axes
    time, i, units = run.time.values, axis - 1, scenario.units
    estimate = run.flow_parameters_estimate.values[:, i]
    few = estimate.shape[1] <= 6
    theta = run.flow_parameters.values if "flow_parameters" in run else None
    row, estimated = scenario.learning.row, "estimate = $-\\alpha$"
    if row.alpha_is_constant:
        estimated = "given estimate" if row.given_estimate else "estimate of the filter"
    gains_known = "vehicle_controller" not in unknown_parts(run)
    with told_apart(axes, label, color):
        for k, column in enumerate(estimate.T):
            line, symbol = line_style(k), rf"$\hat\theta_{axis}^{{{k + 1}}}$"
            name = symbol if few else "estimates" if k == 0 else None
            top.plot(time, column, linewidth=1.2 if few else 0.6, label=name, **line)
            if theta is not None:
                top.axhline(theta[i][k], color=line["color"], linewidth=0.7, alpha=0.7)
        truth = ", true values thin" if theta is not None else ""
        top.set_title(f"Flow to the {DIRECTIONS[i]}, {estimated}{truth}", **TITLE)
        top.set_ylabel(f"flow parameter ({units.length}/{units.time})")
        for k, (gain, symbol) in enumerate(
            (("feedback", "K"), ("feedforward", r"\Gamma"))
        ):
            line, known = line_style(k), getattr(scenario.vehicle, gain)
            values = run[f"{gain}_gain"].values[:, i]
            bottom.plot(time, values, label=f"${symbol}_{axis}$", linewidth=1.2, **line)
            if gains_known:
                bottom.axhline(known[i], color=line["color"], linewidth=0.7, alpha=0.7)
        bottom.set_title(f"Gains{', true values thin' if gains_known else ''}", **TITLE)
        bottom.set(xlabel=f"time ({units.time})", ylabel=f"gain (1/{units.time})")
        cycle = scenario.cycle if len(waypoints_of(run, scenario)) else np.inf
        for one in axes:
            one.set_xlim(time[0], end := time[-1])
            one.legend(frameon=False, fontsize=9, ncols=3)
            if end > 2 * cycle:
                one.set_xscale("symlog", linthresh=cycle)
                ticks = [cycle * k / 4 for k in range(4)] + [
                    cycle * 2**k for k in range(5)
                ]
                ticks = [t for t in ticks if t <= end]
                one.set_xticks(ticks, [f"{t:g}" for t in ticks])
                one.minorticks_off()
                bottom.set_xlabel(f"time ({units.time}), logarithmic after one cycle")
    return axes


@public
def run_plot(
    run: "xarray.Dataset",
    *,
    ax: Any = None,
    label: str | None = None,
    color: str | None = None,
) -> Any:
    """Draw track, CLPE and learning of both axes in one figure.

    Parameters
    ----------
    run : xarray.Dataset
        As `simulate` gives it, or `load_run`.
    ax : array of 7 Axes, optional
        Where to draw; by default a new figure of pyplot's.
    label, color : optional
        Of a run among several on the same Axes: its name in the legend and one colour for all of
        its lines, whose styles tell its signals apart; `compare` gives them.

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
    options: dict[str, Any] = {"label": label, "color": color}
    track_plot(run, ax=axes[0], **options)
    clpe_plot(run, ax=axes[1:3], **options)
    for axis in (1, 2):
        learning_plot(run, axis, ax=axes[[2 + axis, 4 + axis]], **options)
    return axes
