"""Plots of any diagram's run, port by port or by name, and of several runs in one figure.

`compare` draws runs of scenarios or of diagrams on the same Axes, each in a colour and marker.
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import partial
from textwrap import fill
from typing import TYPE_CHECKING, Any

import control
import numpy as np

from ..base.arguments import known, public
from ..base.errors import ArgumentError, DataError
from ..base.figures import (
    COLOURS,
    axes_for,
    legend_above_data,
    line_style,
    literal,
    with_formulas,
)
from ..base.labelled import unit_of
from ..base.run_attributes import LABELS
from ..base.units import printed_unit
from ..engine.model.ports import ports_of
from .dataset_template import HELD, INDEX
from .run_plots import clpe_plot, learning_plot, run_plot
from .track_chart import legend_beside, run_style, style_line, track_plot

if TYPE_CHECKING:
    import xarray

MAX_PORTS = 16  # of a figure
LONGEST_LINE = 22  # letters beside a panel
MAX_LABELS = 6  # signals of a port in a legend
STATES = "states"


@public
def response_plot(
    run: "xarray.Dataset",
    *,
    ax: Any = None,
    label: str | None = None,
    color: str | None = None,
) -> Any:
    """Draw each port of a diagram's run over time, but inputs of 0.

    >>> import clpt_control as clpt
    >>> loop = clpt.closed_loop(clpt.paper_scenario())
    >>> run = clpt.simulate(loop, [0.0, 1.0, 2.0])
    >>> x, e = response_plot(run[["position", "clpe"]])
    """
    check_samples(run)
    ports = shown_ports(run)
    axes = panels_for(ax, len(ports), f"run[{ports[:2]}]")
    panels = np.ravel(axes)
    with run_style(axes, label, color):
        for panel, port in zip(panels, ports, strict=True):
            _draw_port(panel, run, port)
    panels[-1].set_xlabel(literal(label_of("time", run.time)))
    return axes


def check_samples(run: "xarray.Dataset") -> None:
    """Raise `DataError` if a run has no time."""
    if "time" not in run.dims:
        raise DataError(
            "the run has one sample, so it has no plot. Give a slice of samples"
        )


@public
def signals_plot(
    run: "xarray.Dataset",
    names: str | Sequence[str],
    *,
    ax: Any = None,
    label: str | None = None,
    color: str | None = None,
    plots: Sequence[str] = (),
) -> Any:
    """Draw signals and states of a run by name, on an Axes for each unit.

    A name is that of a port, a signal or a state: ``"e"``, ``"e[0]"``, ``"tank_h[0]"``. On several
    Axes, as many as names, each has one; one given Axes has all. A refused name may be meant for
    one of `plots`.

    >>> import clpt_control as clpt
    >>> run = clpt.simulate(clpt.parts.lag(2.0), [0.0, 1.0, 2.0], 1.0)
    >>> signals_plot(run, ["y", "u"]).get_legend_handles_labels()[1]
    ['y', 'u']
    """
    check_samples(run)
    names = [names] if isinstance(names, str) else [*names]
    is_list = isinstance(ax, list | tuple | np.ndarray)
    groups = [[name] for name in names]
    if ax is None or (is_list and np.size(ax) != len(names)):
        groups = _by_unit(run, names)
    if len(groups) > 1 and (ax is None or np.size(ax) == len(groups)):
        ax = panels_for(ax, len(groups), f"run.clpt.plot({names[:1]})")
        for group, panel in zip(groups, np.ravel(ax), strict=True):
            signals_plot(run, group, ax=panel, label=label, color=color, plots=plots)
            panel.label_outer()
        return ax
    ax = axes_for(ax, 6.4, 3.2)
    signals: dict[str, np.ndarray] = {}  # by name with unit
    steps: dict[str, dict[str, str]] = {}
    for name in names:
        found = _signals_by_name(run, name, plots)
        signals |= found
        steps |= dict.fromkeys(found, _steps(run, name))
    before = len(ax.lines)
    for k, (name, values) in enumerate(signals.items()):
        text = literal(name)
        if label is not None:
            run_name = with_formulas(label)
            text = run_name if len(signals) == 1 else f"{run_name}: {text}"
        style = line_style(k + before * (color is None)) | steps[name]
        [line] = ax.plot(run.time.values, values, label=text, linewidth=1.1, **style)
        style_line(line, None, color)
    is_one = len(names) == 1 and ax.get_ylabel() in ("", literal(_title(run, names[0])))
    ax.set_ylabel(literal(_title(run, names[0])) if is_one else "")
    ax.set_xlabel(literal(label_of("time", run.time)))
    if label is not None or len(ax.lines) > 1:
        legend_above_data(ax)
    return ax


def _by_unit(run: "xarray.Dataset", names: Sequence[str]) -> list[list[str]]:
    """Return names in groups of one unit, in the order of their first ones."""
    groups: dict[str, list[str]] = {}
    for name in names:
        groups.setdefault(unit_of(_port(run, name)), []).append(name)
    return [*groups.values()]


def _port(run: "xarray.Dataset", name: str) -> Any:
    """Return the port of a name, or None of a state."""
    return run.get(name, run.get(name.partition("[")[0]))


def _title(run: "xarray.Dataset", name: str) -> str:
    """Return a name with the unit of its port."""
    return label_of(name, _port(run, name))


def _steps(run: "xarray.Dataset", name: str) -> dict[str, str]:
    """Return the style of a line in steps, of a signal that is held between samples."""
    is_held = getattr(_port(run, name), "attrs", {}).get("comment") == HELD
    return {"drawstyle": "steps-post"} if is_held else {}


def _signals_by_name(
    run: "xarray.Dataset", name: str, plots: Sequence[str]
) -> dict[str, np.ndarray]:
    """Return the signals of a port, or a signal or state, by name with unit."""
    ports = ports_along(run)
    if name in ports:
        signals = signals_of(run[name])
        return {_title(run, signal): values for signal, values in signals.items()}
    by_name: dict[str, np.ndarray] = {}
    if STATES in run.variables:
        labels = run[STATES]["state"].values.tolist()
        by_name = dict(zip(labels, run[STATES].values.T, strict=True))
    advice = known(name, dict.fromkeys([*plots, *ports, *by_name]))
    for port in ports:
        by_name |= signals_of(run[port])
    for spelling in (name, name.replace(".", "_"), name.removesuffix("[0]")):
        if spelling in by_name:
            return {_title(run, spelling): by_name[spelling]}
    if name in plots:
        advice = f"Give '{name}' alone, not in a list"
    raise ArgumentError(f"plot '{name}': the run has no such signal or state. {advice}")


def panels_for(ax: Any, count: int, example: str) -> Any:
    """Return the axes of a figure with a panel for each signal; refuse too many."""
    if not 0 < count <= MAX_PORTS:
        raise DataError(
            f"{count} signals along time: one figure shows 1 to {MAX_PORTS}. Choose some, as "
            f"{example}"
        )
    return axes_for(ax, 6.4, 1.2 + 1.3 * count, nrows=count, sharex=True)


def _draw_port(ax: Any, run: "xarray.Dataset", port: str) -> None:
    """Draw the signals of a port over time."""
    time = run.time.values
    signals = signals_of(run[port])
    is_labelled = len(signals) <= MAX_LABELS
    for k, (name, values) in enumerate(signals.items()):
        label = literal(name) if is_labelled else None
        style = line_style(k) | _steps(run, port)
        ax.plot(time, values, label=label, linewidth=1.1, **style)
    label = fill(label_of(port, run[port]), LONGEST_LINE)
    ax.set_ylabel(literal(label))
    if len(signals) > 1 and is_labelled:
        legend_above_data(ax)


@public
def compare(
    runs: Mapping[str, "xarray.Dataset"] | Sequence["xarray.Dataset"],
    plot: str | Sequence[str] | None = None,
    *,
    labels: Sequence[str] | None = None,
    ax: Any = None,
    axis: int | None = None,
) -> Any:
    """Draw several runs in one figure, each in colour and marks.

    Parameters
    ----------
    runs : mapping or sequence
        Name -> run, ``{"0.8": a, "2": b}``: of scenarios, or of diagrams. The names stand in the
        legend.
    plot : str or sequence of str, optional
        ``"track"``, ``"clpe"``, ``"learning"`` or ``"run"``, all three, of the runs of scenarios;
        ``"response"``, each port over time, of any; or names of ports, signals and states, as
        ``"pos"``. By default ``"run"``, or ``"response"``.
    labels : sequence of str, optional
        Names for the legend, in the order of the runs; formulas such as ``"$k_p$ = 2"`` too.
    ax : Axes or array of Axes, optional
        Where to draw, as that plot takes them; by default a new figure of pyplot's.
    axis : int, optional
        Of ``"learning"``: 1 or 2.

    Returns
    -------
    Axes or ndarray of Axes
        As that plot returns them.

    Raises
    ------
    DataError
        If there are no runs or more than 6, or they have not the same signals and units.
    ArgumentError
        If there is no such plot or signal, or another number of labels than runs.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> scenario = clpt.paper_scenario().with_values({"run.duration": 20})
    >>> slow = clpt.simulate(scenario.with_values({"learning.gain": 0.2}))
    >>> top, bottom = clpt.compare({"0.8": clpt.simulate(scenario), "0.2": slow}, "clpe")
    >>> [line.get_label() for line in top.lines if line.get_label()[0] != "_"]
    ['0.8: $e_1$', '0.8: $e_2$', '0.2: $e_1$', '0.2: $e_2$']
    """
    if not isinstance(runs, Mapping):
        runs = {str(number): run for number, run in enumerate(runs, 1)}
    every = [*runs.values()]
    if labels is not None and len(labels) != len(every):
        raise ArgumentError(f"labels: has {len(labels)}; must be {len(every)}, as runs")
    check_runs(every)
    is_new_figure = ax is None
    of_scenarios = all("scenario" in run.attrs for run in every)
    plots = COMPARED if of_scenarios else {"response": response_plot}
    if plot is None:
        plot = next(iter(plots))
    draw: Any = plots.get(plot) if isinstance(plot, str) else None
    if draw is None:
        draw = partial(signals_plot, names=plot, plots=[*plots])
        is_new_figure = False
    if axis is not None:
        if plot != "learning":
            raise ArgumentError("axis: is of the plot 'learning'. Leave it out")
        draw = partial(draw, axis=axis)
    names = [*map(str, labels or runs)]
    signals = [shown_ports(run) for run in every]
    if plot == "response" and any(ports != signals[0] for ports in signals):
        shared = sorted({*signals[0]}.intersection(*signals))
        remedy = f"give plot={shared[:1]}" if shared else "draw each, run.clpt.plot()"
        raise DataError(f"runs: not all have the same signals; {remedy}")
    for colour, name, run in zip(COLOURS, names, every, strict=False):
        ax = draw(run, ax=ax, label=name, color=colour)
    panels = np.ravel(ax)
    if draw is response_plot and all(len(one.lines) == len(every) for one in panels):
        for line, name in zip(panels[0].lines, names, strict=True):
            line.set_label(with_formulas(name))
        legend_beside(panels[0])
        for panel in panels[1:]:
            panel.get_legend().remove()
    if is_new_figure:  # room for the legends
        figure = panels[0].figure
        figure.set_figwidth(1.5 * figure.get_figwidth())
    return ax


def check_runs(runs: "Sequence[xarray.Dataset]") -> None:
    """Raise `DataError` for more runs than colours, and for runs in several units."""
    if not 0 < len(runs) <= len(COLOURS):
        raise DataError(
            f"compare: {len(runs)} runs; must be 1 to {len(COLOURS)} runs by name, "
            "{'0.8': a, '2': b}"
        )
    units: dict[Any, str] = {}  # of each variable that has a unit
    for run in runs:
        for name, variable in run.variables.items():
            unit = unit_of(variable)
            if unit and units.setdefault(name, unit) != unit:
                raise DataError(
                    f"not all runs have {name} in one unit: {units[name]}, {unit}"
                )


COMPARED: dict[str, Callable[..., Any]] = {
    "run": run_plot,
    "track": track_plot,
    "clpe": clpe_plot,
    "learning": learning_plot,
    "response": response_plot,
}


def ports_along(run: "xarray.Dataset") -> list[str]:
    """Return the names of the ports along time, without the states."""
    return [
        str(name)
        for name, variable in run.data_vars.items()
        if "time" in variable.dims and name != STATES
    ]


def shown_ports(run: "xarray.Dataset") -> list[str]:
    """Return the names of the ports along time but inputs that are 0, unless all are."""
    ports = ports_along(run)
    changing = [
        port
        for port in ports
        if noted_labels(run, port)[0] == "outputs" or (run[port] != 0).any()
    ]
    return changing or ports


def noted_labels(run: "xarray.Dataset", port: str) -> tuple[str, list[str]]:
    """Return "inputs" or "outputs", and the labels that a port's signals have in the diagram."""
    noted = run.encoding.get(LABELS, {})
    for kind, name in (("outputs", port), ("inputs", port.removesuffix("_input"))):
        labels = noted.get(kind, [])
        if indices := ports_of(labels).get(name):
            return kind, [labels[k] for k in indices]
    return "outputs", []


def signals_of(port: "xarray.DataArray", along: str = "time") -> dict[str, np.ndarray]:
    """Return the signals of a port along time, by name: ``e``, ``e[0]``, ``position axis 1``."""
    return {
        label: port.isel(index).values
        for label, index in labelled_elements(port, along)
    }


def labelled_elements(
    port: "xarray.DataArray", *along: str
) -> Iterator[tuple[str, dict[str, int]]]:
    """Yield the label and the index of each element of a port, an array along dimensions."""

    def is_index(dim: str) -> bool:
        return dim.rstrip("_").endswith(f"_{INDEX}")

    dims = [str(dim) for dim in port.dims if dim not in along]
    dims.sort(key=lambda dim: not is_index(dim))  # the index first
    coordinates = {dim: port[dim].values for dim in dims}
    for index in np.ndindex(*map(len, coordinates.values())):
        at = dict(zip(dims, index, strict=True))
        label = str(port.name)
        for dim, k in at.items():
            value = coordinates[dim][k]
            if is_index(dim):
                label += f"[{value}]"
                continue
            pairs = [(dim, value)]
            if isinstance(value, tuple):  # a member, with a value of each varied name
                pairs = [*zip(port.indexes[dim].names, value, strict=True)]
            for key, number in pairs:
                text = f"{number:.15g}" if isinstance(number, float) else number
                label += f" {key} {text}"
        yield label, at


def named(name: str, units: str) -> str:
    """Return a name with its unit, if it has one."""
    return f"{name} ({units})" if units else name


def with_unit(name: str, signal: Any) -> str:
    """Return a name with the unit of a signal, if there is one."""
    return named(name, unit_of(signal))


def label_of(name: str, signal: Any) -> str:
    """Return a name with the unit of a signal as figures print it."""
    return named(name, printed_unit(unit_of(signal)))


def response_of(run: "xarray.Dataset") -> control.TimeResponseData:
    """Return a run as a response of python-control, with the labels of its diagram."""
    if "time" not in run.dims or not ports_along(run):
        raise DataError("the dataset has no signal along time. Give a run")
    names = run.encoding.get(LABELS, {})
    signals: dict[str, dict[str, np.ndarray]] = {"inputs": {}, "outputs": {}}
    for port in ports_along(run):
        key, labels = noted_labels(run, port)
        rows = signals_of(run[port])
        if len(labels) != len(rows):
            labels = [*rows]
        signals[key] |= zip(labels, rows.values(), strict=True)
    inputs, outputs = signals.values()
    states = run.get(STATES)
    return control.TimeResponseData(
        run.time.values,
        np.reshape([*outputs.values()], (-1, run.sizes["time"])),
        None if states is None else states.values.T,
        np.array([*inputs.values()]) if inputs else None,
        issiso=len(outputs) == len(inputs) == 1,
        output_labels=[*outputs],
        input_labels=[*inputs] if inputs else None,
        state_labels=None if states is None else [*states["state"].values],
        title=str(run.attrs.get("title", "")) or None,
        plot_inputs=bool(inputs),
        sysname=names.get("name"),
    )
