"""Pictures of a run: each returns the Axes that it drew on.

Nothing here integrates.
"""

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from ..arguments import public
from ..errors import ClptError, DataError
from ..figures import BLUE, COLOURS, GREY, RED, axes_for, legend_below, line_style, literal
from ..scenario.experiment import Scenario
from ..scenario.file import scenario_of_run
from ..scenario.recorded_run import check_run, waypoints_of
from .dataset import INDEX

DIRECTIONS = "east", "north"  # of x1 and x2
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
    ["east", "north"],
    ["gains 1", "gains 2"],
]


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
    known = {"color": BLUE, **_coloured(color)}
    if label:
        return _track_among(axes_for(ax, 5.6, 5.2), scenario, points, run, label, color)
    from .flows import flow_velocity

    ax = axes_for(ax, 5.6, 5.2)
    unit = scenario.units.length
    grid = square_chart(ax, scenario, np.concatenate([points, path]), 13)
    flow = flow_velocity(scenario, grid, 0.0)
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
    named = "Waypoints, track, and flow" if len(points) else "Track, and flow"
    ax.set_title(f"{named} at t = 0", **TITLE)
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
    line = {"color": color, "linewidth": 1.1}
    line["color"] = ax.plot(*path.T, label=label, **line)[0].get_color()
    ax.plot(*predicted.T, linestyle="--", **line | {"linewidth": 0.8})
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


@public
def clpe_plot(
    run: "xarray.Dataset", *, ax: Any = None, label: str | None = None, color: str | None = None
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
    of_run = _coloured(color)
    for i in range(2):
        line = {**line_style(i), **of_run}
        top.plot(time[early], e[early, i], label=_among(label, f"$e_{i + 1}$"), lw=1.1, **line)
    last = max(time[early], default=2 * cycle)
    top.set(ylabel=f"CLPE ({units.length})", xlim=(0, _wider(top, last, label)))
    top.legend(**_legend(label), fontsize=8)
    top.set_title("CLPE", **TITLE)
    size, lowest = np.hypot(*e.T), bottom.get_ylim()[0] if bottom.lines else np.inf
    positive = np.maximum(size, 1e-12)
    name = "|e|" if label is None else label if not count else None
    alpha = 0.5 if label is None else 0.25  # behind the steps of the waypoints
    shade: dict[str, Any] = {"color": color or BLUE, "alpha": alpha if count else 1}
    bottom.semilogy(time, positive, label=name, linewidth=0.5, **shade)
    if count:
        number = np.floor(time / dwell + 1e-9).astype(int)
        counts = np.bincount(number)
        rms = np.sqrt(np.bincount(number, size**2) / np.where(counts > 0, counts, np.nan))
        few = len(size) < MANY * len(counts)  # the pictures of a long run have fewer samples
        name = f"rms of each {dwell:g} {units.time}, a waypoint{', of the samples shown' * few}"
        shade = {"color": color or "black", "linewidth": 1.2, "label": _among(label, name)}
        bottom.step(dwell * np.arange(len(counts)), np.maximum(rms, 1e-12), where="post", **shade)
    bottom.set(xlabel=f"time ({units.time})", ylabel=f"|CLPE| ({units.length})")
    bottom.set_xlim(0, _wider(bottom, time[-1], label))
    if size.max() > 0:
        least = max(1e-12, np.nanmin(np.where(size > 0, size, np.nan)) / 2)
        bottom.set_ylim(bottom=least if label is None else min(least, lowest))
    bottom.legend(**_legend(label), fontsize=8)
    if count and not (top.child_axes or bottom.child_axes):
        for one in axes:
            above = one.secondary_xaxis("top", functions=(lambda t: t / cycle, lambda n: n * cycle))
            above.locator_params(axis="x", integer=True)
            above.tick_params(labelsize=7, colors=GREY)
        top.child_axes[0].set_xlabel("cycles", fontsize=7, color=GREY, loc="right")
    return axes


def _coloured(color: str | None) -> dict[str, Any]:
    """Return the colour of a run's lines, where it has one of its own."""
    from matplotlib.colors import is_color_like

    if color is not None and not is_color_like(color):
        raise ClptError(f"color = {color!r:.60}: must be a colour of matplotlib, 'C1' or '#0072b2'")
    return {} if color is None else {"color": color}


def _among(label: str | None, signal: str) -> str:
    """Return what a line is called: its signal, behind the label of its run where there is one."""
    return signal if label is None else f"{label}: {signal}"


def _legend(label: str | None) -> dict[str, Any]:
    """Return how a legend stands: among the lines of several runs on white."""
    return {"frameon": label is not None, "framealpha": 0.85, "edgecolor": "none"}


def _wider(ax: Any, last: float, label: str | None) -> float:
    """Return where axes end: with this run, or with the longest of those on them."""
    lines = [line.get_xdata() for line in ax.lines if line.get_label()[0] != "_"]
    ends = [max(one) for one in lines if label is not None and len(one)]
    return max([float(last), *ends])


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
    N = estimate.shape[1]
    of_run = _coloured(color)
    for k in range(N):
        line = {**line_style(k), **of_run}
        name = _among(label, rf"$\hat\theta_{axis}^{{{k + 1}}}$") if N <= 6 else None
        name = label if k == 0 and N > 6 else name
        width = 1.2 if N <= 6 else 0.6
        top.plot(time, estimate[:, k], linewidth=width, label=name, **line)
        if scenario.flow.parameters is not None:
            true = scenario.flow.parameters[i][k]
            top.axhline(true, color=line["color"], linewidth=0.7, alpha=0.7)
    truth = ", true values thin" if scenario.flow.parameters is not None else ""
    row, estimated = scenario.learning.row, "estimate = $-\\alpha$"
    if row.alpha_is_constant:
        estimated = "given estimate" if row.given_estimate else "estimate of the filter"
    top.set_title(f"Flow to the {DIRECTIONS[i]}, {estimated}{truth}", **TITLE)
    top.set_ylabel(f"flow parameter ({units.length}/{units.time})")
    for k, (gain, symbol) in enumerate((("feedback", "K"), ("feedforward", r"\Gamma"))):
        line, known = {**line_style(k), **of_run}, getattr(scenario.vehicle, gain)
        values, name = run[f"{gain}_gain"].values[:, i], _among(label, f"${symbol}_{axis}$")
        bottom.plot(time, values, label=name, linewidth=1.2, **line)
        bottom.axhline(known[i], color=line["color"], linewidth=0.7, alpha=0.7)
    bottom.set_title("Gains, true values thin", **TITLE)
    bottom.set(xlabel=f"time ({units.time})", ylabel=f"gain (1/{units.time})")
    cycle = scenario.cycle if len(waypoints_of(run, scenario)) else np.inf
    for one in axes:
        one.set_xlim(time[0], end := _wider(one, time[-1], label))
        if end > 2 * cycle:
            one.set_xscale("symlog", linthresh=cycle)
            ticks = [cycle * k / 4 for k in range(4)] + [cycle * 2**k for k in range(5)]
            one.set_xticks([t for t in ticks if t <= end], [f"{t:g}" for t in ticks if t <= end])
            one.minorticks_off()
            bottom.set_xlabel(f"time ({units.time}), logarithmic after one cycle")
    if N <= 6 or label is not None:
        top.legend(**_legend(label), fontsize=9, ncols=3)
    bottom.legend(**_legend(label), fontsize=9, ncols=2)
    return axes


@public
def run_plot(
    run: "xarray.Dataset", *, ax: Any = None, label: str | None = None, color: str | None = None
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


@public
def response_plot(
    run: "xarray.Dataset", *, ax: Any = None, label: str | None = None, color: str | None = None
) -> Any:
    """Draw each port of a diagram's run over time.

    Parameters
    ----------
    run : xarray.Dataset
        As `simulate` gives it for a diagram.
    ax : array of Axes, optional
        Where to draw, one for each port; by default a new figure of pyplot's.
    label, color : optional
        Of a run among several on the same Axes: its name in the legend and one colour for all of
        its lines, whose styles tell its signals apart; `compare` gives them.

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
    ports = ports_along(run)
    if "time" not in run.dims:
        raise DataError("the run is of one time, over which nothing is drawn; cut it by a slice")
    if not 0 < len(ports) <= PORTS:
        raise DataError(
            f"the run has {len(ports)} signals along time; one picture shows 1 to {PORTS}: choose "
            f"some, as run[{ports[:2]}]"
        )
    axes = axes_for(ax, 6.4, 1.2 + 1.3 * len(ports), nrows=len(ports), sharex=True)
    of_run = _coloured(color)
    for one, port in zip(np.ravel(axes), ports, strict=True):
        signals = signals_of(run[port])
        for k, (name, column) in enumerate(signals.items()):
            line = {**line_style(k), **of_run}
            said = literal(_among(label, name))
            one.plot(run.time.values, column, label=said, linewidth=1.1, **line)
        one.set_ylabel(literal(named(port, run[port].attrs.get("units"))))
        if (len(signals) > 1 or label is not None) and len(signals) <= 6:
            beside: dict[str, Any] = {"loc": "upper left", "bbox_to_anchor": (1.0, 1.05)}
            place = {"loc": "upper right", "ncols": 6} if label is None else beside
            one.legend(frameon=False, fontsize=8, **place)
    one.set_xlabel(literal(named("time", run.time.attrs.get("units"))))
    return axes


@public
def compare(
    runs: Mapping[str, "xarray.Dataset"], plot: str | None = None, *, ax: Any = None, **options: Any
) -> Any:
    """Draw several runs in one figure, told apart by colour.

    Parameters
    ----------
    runs : mapping
        Name -> run, ``{"0.8": a, "2": b}``: of scenarios, or of diagrams. The names stand in the
        legend.
    plot : str, optional
        ``"track"``, ``"clpe"``, ``"learning"`` or ``"run"``, all three, of the runs of scenarios;
        ``"response"``, each port over time, of any. By default ``"run"``, or ``"response"``.
    ax : Axes or array of Axes, optional
        Where to draw, as that plot takes them; by default a new figure of pyplot's.
    **options
        Of that plot, as ``axis=2`` of ``"learning"``.

    Returns
    -------
    Axes or ndarray of Axes
        As that plot returns them.

    Raises
    ------
    DataError
        If there are no runs or more than 6, or they have not the same signals and units.
    ClptError
        If there is no such plot.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> scenario = clpt.paper_scenario().with_values({"run.duration": 20})
    >>> slow = clpt.simulate(scenario.with_values({"learning.gain": 0.2}))
    >>> top, bottom = clpt.compare({"0.8": clpt.simulate(scenario), "0.2": slow}, "clpe")
    >>> [line.get_label() for line in top.lines if line.get_label()[0] != "_"]
    ['0.8: $e_1$', '0.8: $e_2$', '0.2: $e_1$', '0.2: $e_2$']
    """
    check_runs(runs)
    if plot is None:
        of_scenarios = all("scenario" in run.attrs for run in runs.values())
        plot = "run" if of_scenarios else "response"
    if plot not in COMPARED:
        raise ClptError(f"plot = {plot!r:.40}: must be one of {', '.join(COMPARED)}")
    if plot == "response":
        ports = [ports_along(run) for run in runs.values()]
        common, every = set(ports[0]).intersection(*ports), set[str]().union(*ports)
        if common != every:
            some = [name for name in ports[0] if name in common][:2]
            cure = f"choose some: run[{some}]" if some else "there is none that all have"
            apart = ", ".join(sorted(every - common))
            raise DataError(f"not all runs have the signals {apart}; {cure}")
    for colour, (name, run) in zip(COLOURS, runs.items(), strict=False):
        ax = COMPARED[plot](run, ax=ax, label=str(name), color=colour, **options)
    return ax


def check_runs(runs: Any) -> None:
    """Refuse what is no mapping of runs by name, and more than colours tell."""
    if not isinstance(runs, Mapping) or not 0 < len(runs) <= len(COLOURS):
        what = f"{len(runs)} runs" if isinstance(runs, Mapping) else f"a {type(runs).__name__}"
        raise DataError(
            f"compare: {what}; must be 1 to {len(COLOURS)} runs by name, {{'0.8': a, '2': b}}"
        )
    for name, run in runs.items():
        if not hasattr(run, "data_vars"):
            raise DataError(f"compare: {name!s:.40} is a {type(run).__name__}; must be a run")
    units: dict[str, str] = {}  # of each variable, where a run says it
    for run in runs.values():
        for key, one in run.variables.items():
            unit = str(one.attrs.get("units", ""))
            if unit and units.setdefault(str(key), unit) != unit:
                raise DataError(f"not all runs have {key} in one unit: {units[str(key)]}, {unit}")


COMPARED: dict[str, Callable[..., Any]] = {
    "run": run_plot,
    "track": track_plot,
    "clpe": clpe_plot,
    "learning": learning_plot,
    "response": response_plot,
}


def ports_along(run: "xarray.Dataset") -> list[str]:
    """Return the names of the ports along time; states are none."""
    return [str(n) for n, one in run.data_vars.items() if "time" in one.dims and n != STATES]


def signals_of(port: "xarray.DataArray") -> dict[str, np.ndarray]:
    """Return the signals of a port along time, by name: ``e``, ``e[0]``, ``position axis 1``."""
    name = str(port.name)
    index = f"{name.rstrip('_')}_{INDEX}"
    dims = sorted((str(d) for d in port.dims if d != "time"), key=lambda d: d.rstrip("_") != index)
    whole = port.transpose("time", *dims).values.reshape(port.sizes["time"], -1)
    signals = {}
    for k, at in enumerate(np.ndindex(*(port.sizes[dim] for dim in dims))):
        words = []
        for dim, i in zip(dims, at, strict=True):
            value = port[dim].values[i]
            if dim.rstrip("_") == index:
                words.append(f"[{value}]")
            elif isinstance(value, tuple):  # of a member, of which each varied name has one
                names = port.indexes[dim].names
                words += [f" {name} {one}" for name, one in zip(names, value, strict=True)]
            else:
                words.append(f" {dim} {value}")
        signals[name + "".join(words)] = whole[:, k]
    return signals


def named(name: str, units: str | None) -> str:
    """Return a name with its unit, where there is one."""
    return f"{name} ({units})" if units else name
