"""Pictures of any diagram's run, port by port, and of several runs in one figure."""

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from ..base.arguments import public
from ..base.errors import ClptError, DataError
from ..base.figures import COLOURS, axes_for, line_style, literal
from .dataset_template import INDEX
from .run_plots import clpe_plot, learning_plot, run_plot
from .track_chart import told_apart, track_plot

if TYPE_CHECKING:
    import xarray

PORTS = 16  # of a picture of any diagram
MOST_NAMED = 6  # signals of a port in a legend
STATES = "states"


@public
def response_plot(
    run: "xarray.Dataset",
    *,
    ax: Any = None,
    label: str | None = None,
    color: str | None = None,
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
        raise DataError(
            "the run is of one time, over which nothing is drawn; cut it by a slice"
        )
    if not 0 < len(ports) <= PORTS:
        raise DataError(
            f"the run has {len(ports)} signals along time; one picture shows 1 to {PORTS}: choose "
            f"some, as run[{ports[:2]}]"
        )
    axes = axes_for(ax, 6.4, 1.2 + 1.3 * len(ports), nrows=len(ports), sharex=True)
    with told_apart(axes, None if label is None else literal(label), color):
        for one, port in zip(np.ravel(axes), ports, strict=True):
            signals = signals_of(run[port])
            for k, (name, column) in enumerate(signals.items()):
                said = literal(name) if len(signals) <= MOST_NAMED else None
                one.plot(
                    run.time.values, column, label=said, linewidth=1.1, **line_style(k)
                )
            one.set_ylabel(literal(named(port, run[port].attrs.get("units"))))
            if 1 < len(signals) <= MOST_NAMED:
                one.legend(frameon=False, fontsize=8, loc="upper right", ncols=6)
    one.set_xlabel(literal(named("time", run.time.attrs.get("units"))))
    return axes


@public
def compare(
    runs: Mapping[str, "xarray.Dataset"],
    plot: str | None = None,
    *,
    ax: Any = None,
    **options: Any,
) -> Any:
    """Draw several runs in one figure, each in colour and marks.

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
    own_figure = ax is None
    if plot is None:
        of_scenarios = all("scenario" in run.attrs for run in runs.values())
        plot = "run" if of_scenarios else "response"
    if plot not in COMPARED:
        raise ClptError(f"plot = {plot!r:.40}: must be one of {', '.join(COMPARED)}")
    if (
        plot == "response"
        and len({tuple(ports_along(run)) for run in runs.values()}) > 1
    ):
        some = next(map(ports_along, runs.values()))[:1]
        raise DataError(
            f"not all runs have the same signals: choose some, as run[{some}]"
        )
    for colour, (name, run) in zip(COLOURS, runs.items(), strict=False):
        ax = COMPARED[plot](run, ax=ax, label=str(name), color=colour, **options)
    if own_figure:  # the legends stand beside
        figure = np.ravel(ax)[0].figure
        figure.set_figwidth(1.5 * figure.get_figwidth())
    return ax


def check_runs(runs: "Mapping[str, xarray.Dataset]") -> None:
    """Refuse more runs than colours tell, and runs in several units."""
    if not 0 < len(runs) <= len(COLOURS):
        raise DataError(
            f"compare: {len(runs)} runs; must be 1 to {len(COLOURS)} runs by name, "
            "{'0.8': a, '2': b}"
        )
    units: dict[str, str] = {}  # of each variable, where a run says it
    for run in runs.values():
        for key, one in run.variables.items():
            unit = str(one.attrs.get("units", ""))
            if unit and units.setdefault(str(key), unit) != unit:
                raise DataError(
                    f"not all runs have {key} in one unit: {units[str(key)]}, {unit}"
                )


COMPARED: dict[str, Callable[..., Any]] = {
    "run": run_plot,
    "track": track_plot,
    "clpe": clpe_plot,
    "learning": learning_plot,
    "response": response_plot,
}


def ports_along(run: "xarray.Dataset") -> list[str]:
    """Return the names of the ports along time; states are none."""
    return [
        str(n) for n, one in run.data_vars.items() if "time" in one.dims and n != STATES
    ]


def signals_of(port: "xarray.DataArray") -> dict[str, np.ndarray]:
    """Return the signals of a port along time, by name: ``e``, ``e[0]``, ``position axis 1``."""
    name = str(port.name)
    index = f"{name.rstrip('_')}_{INDEX}"
    dims = sorted(
        (str(d) for d in port.dims if d != "time"), key=lambda d: d.rstrip("_") != index
    )
    whole = port.transpose("time", *dims).values.reshape(port.sizes["time"], -1)
    signals = {}
    for k, at in enumerate(np.ndindex(*(port.sizes[dim] for dim in dims))):
        words = []
        for dim, i in zip(dims, at, strict=True):
            value = port[dim].values[i]
            if dim.rstrip("_") == index:
                words.append(f"[{value}]")
            elif isinstance(value, tuple):
                # of a member, of which each varied name has one
                names = port.indexes[dim].names
                words += [
                    f" {name} {one}" for name, one in zip(names, value, strict=True)
                ]
            else:
                words.append(f" {dim} {value}")
        signals[name + "".join(words)] = whole[:, k]
    return signals


def named(name: str, units: str | None) -> str:
    """Return a name with its unit, where there is one."""
    return f"{name} ({units})" if units else name
