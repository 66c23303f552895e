"""Ensemble statistics and their plot: percentiles over the members.

Of a scenario: CLPE in each cycle, errors of what was learned.  Of any diagram: its summaries, and
each output over time with ``trajectories=True``; without them the plot shows the rms of each output
over the first varied number.
"""

import json
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np

from ..base.arguments import check_holds, public
from ..base.errors import ArgumentError
from ..base.figures import BLUE, GREY, RED, TITLE, axes_for, legend_above_data, literal
from ..simulation.comparison import named, panels_for
from .summaries import STATUS

if TYPE_CHECKING:
    import xarray

PERCENTS = (5, 25, 50, 75, 95)
ENSEMBLE = "clpt.run_ensemble(scenario, vary, members) makes an ensemble"
READ_BYTES = 8_000_000  # read at once, so that memory does not grow with the members


@public
def percentiles(data: "xarray.Dataset", name: str) -> np.ndarray:
    """Return percentiles over the members, column by column.

    >>> import xarray
    >>> data = xarray.Dataset({"e": (("member", "mark"), np.arange(5.0)[:, None])})
    >>> percentiles(data, "e")[:, 0]
    array([0.2, 1. , 2. , 3. , 3.8])
    """
    check_holds(
        "percentiles: data",
        data,
        [name],
        f"it has {', '.join(map(str, data.data_vars))}",
    )
    if data[name].dims[:1] != ("member",) or data[name].ndim != 2:
        raise ArgumentError(
            f"percentiles: name = '{name}': must have the dimensions member and another"
        )
    members, columns = data[name].shape
    wide = max(1, READ_BYTES // (8 * members))
    result = np.full((len(PERCENTS), columns), np.nan)
    for begin in range(0, columns, wide):
        block = data[name][:, begin : begin + wide].values
        for k, column in enumerate(block.T, begin):
            column = column[np.isfinite(column)]
            if len(column):
                result[:, k] = np.percentile(column, PERCENTS)
    return result


@public
def ensemble_summary(data: "xarray.Dataset") -> dict[str, Any]:
    """Return an ensemble's figures, ready for JSON.

    >>> import clpt_control as clpt
    >>> scenario = clpt.paper_scenario().with_values({"run.duration": 20})
    >>> data = clpt.run_ensemble(scenario, "learning.gain=0.2:2.0", 3)
    >>> ensemble_summary(data)["ended"]
    {'finished': 3}
    """
    check_holds("ensemble_summary: data", data, ["status"], ENSEMBLE)
    of_diagram = is_of_diagram(data)
    data = by_member(data) if of_diagram else data
    status = data["status"].values
    failed = np.flatnonzero(status != 1)
    summary: dict[str, Any] = {
        "title": data.attrs["title"],
        "members": len(status),
        "ended": {STATUS[k]: int(np.sum(status == k)) for k in np.unique(status)},
        "first_failed": int(failed[0]) if len(failed) else None,
        "percents": list(PERCENTS),
    }
    if of_diagram:
        summary["summaries"] = {
            named(label, one.attrs.get("units")): _listed(_percentiles_of(one)[:, 0])
            for label, one in summaries_of(data).items()
        }
        return summary
    required = ["clpe_rms", "clpe_rms_whole"]
    check_holds("ensemble_summary: data", data, required, ENSEMBLE)
    summary["units"] = {
        "length": data["clpe_rms"].attrs["units"],
        "time": data["mark"].attrs["units"],
    }
    summary["clpe_rms_per_cycle"] = [
        _listed(column) for column in percentiles(data, "clpe_rms").T
    ]
    at_end = data.isel(mark=[-1])
    whole_run = data[["clpe_rms_whole"]].expand_dims("one", axis=1)
    summary["clpe_rms"] = _listed(percentiles(whole_run, "clpe_rms_whole")[:, 0])
    if "flow_error" in data:
        errors = data[["flow_error"]].expand_dims("one", axis=1)
        summary["flow_error"] = _listed(percentiles(errors, "flow_error")[:, 0])
    for name in ("flow_parameter_error", "gain_error"):
        if name in data:
            summary[f"{name}_at_end"] = _listed(percentiles(at_end, name)[:, 0])
    if "share_in_faster_flow" in data:
        share = data["share_in_faster_flow"].values
        largest = float(np.nanmax(share, initial=0.0))
        summary["faster_flow"] = {
            "members": int(np.sum(share > 0)),
            "largest_share": largest,
        }
    return summary


def is_of_diagram(data: "xarray.Dataset") -> bool:
    """Return whether an ensemble is of a diagram, without the summaries of the paper's loop."""
    return "ensemble" in data.attrs and "scenario" not in data.attrs


def by_member(data: "xarray.Dataset") -> "xarray.Dataset":
    """Return an ensemble with members along the first dimension, also of an unstacked grid."""
    if "member" not in data.dims:
        keys = json.loads(data.attrs["ensemble"])["keys"]
        data = data.stack(member=[key for key in keys if key in data.dims])
    return data.transpose("member", ...)


def signals_over_time(data: "xarray.Dataset") -> "dict[str, xarray.DataArray]":
    """Return each output over time, shape (member, time), by its label."""
    ports = [port for port in data.data_vars.values() if "time" in port.dims]
    return {label: signal for port in ports for label, signal in _elements(port)}


def summaries_of(data: "xarray.Dataset") -> "dict[str, xarray.DataArray]":
    """Return each summary, shape (member,), by its label."""
    names = [name for name in data.data_vars if name not in ("status", "end")]
    summaries = [data[name] for name in names if "time" not in data[name].dims]
    return {label: one for array in summaries for label, one in _elements(array)}


def rms_of(data: "xarray.Dataset") -> "dict[str, xarray.DataArray]":
    """Return the rms of each output, shape (member,), by its label."""
    return {
        label: one
        for label, one in summaries_of(data).items()
        if str(one.name).endswith("_rms")
    }


def _elements(array: "xarray.DataArray") -> "Iterator[tuple[str, xarray.DataArray]]":
    """Yield the label and the values of each signal of a port: ``e``, or ``e[0]``, ``e[1]``."""
    dims = [dim for dim in array.dims if dim not in ("member", "time")]
    for index in np.ndindex(*(array.sizes[dim] for dim in dims)):
        numbers = "".join(f"[{k}]" for k in index)
        yield f"{array.name}{numbers}", array.isel(dict(zip(dims, index, strict=True)))


def _percentiles_of(signal: "xarray.DataArray") -> np.ndarray:
    """Return percentiles over the members, shape (5, n); n is 1 for numbers by member."""
    columns = signal if signal.ndim == 2 else signal.expand_dims("one", axis=1)
    return percentiles(columns.reset_coords(drop=True).to_dataset(name="one"), "one")


def unit_of(values: "xarray.DataArray") -> str:
    """Return CF units in the form m/s, instead of m s-1."""
    length, _, per = values.attrs.get("units", "").rpartition(" ")
    return f"{length or '1'}/{per.removesuffix('-1')}" if per.endswith("-1") else per


def _listed(column: np.ndarray) -> list[float] | None:
    return column.tolist() if np.isfinite(column).all() else None


@public
def ensemble_plot(data: "xarray.Dataset", *, ax: Any = None) -> np.ndarray:
    """Draw percentiles of CLPE and of the parameter error, or of a diagram's outputs.

    >>> import clpt_control as clpt
    >>> scenario = clpt.paper_scenario().with_values({"run.duration": 20})
    >>> data = clpt.run_ensemble(scenario, "learning.gain=0.2:2.0", 3)
    >>> clpe, error = ensemble_plot(data)
    """
    if is_of_diagram(data):
        return _diagram_plot(by_member(data), ax)
    check_holds("ensemble_plot: data", data, ["clpe_rms"], ENSEMBLE)
    axes = axes_for(ax, 6.4, 6.0, nrows=2)
    length, time = data["clpe_rms"].attrs["units"], data["mark"].attrs["units"]
    # 1. CLPE
    cycles = np.arange(1, data.sizes["cycle"] + 1)
    count = f"{data.sizes['member']:,}".replace(",", " ")
    title = f"CLPE of {count} members"
    labels = {"xlabel": "cycle of the waypoints", "ylabel": f"CLPE rms ({length})"}
    _draw_panel(axes[0], cycles, percentiles(data, "clpe_rms"), BLUE, title, labels)
    axes[0].xaxis.get_major_locator().set_params(integer=True)
    # 2. the error of the flow parameters, or of the gains
    errors = [name for name in ("flow_parameter_error", "gain_error") if name in data]
    if not errors:
        _draw_message(axes[1], "neither flow parameters nor gains have a known truth")
        return axes
    name = errors[0]
    title = f"Largest error of a {name.removesuffix('_error').replace('_', ' ')}"
    labels = {"xlabel": f"time ({time})", "ylabel": f"error ({unit_of(data[name])})"}
    marks = data["mark"].values
    _draw_panel(axes[1], marks, percentiles(data, name), RED, title, labels)
    return axes


def _draw_message(ax: Any, message: str) -> None:
    ax.text(0.5, 0.5, message, ha="center", color=GREY, transform=ax.transAxes)
    ax.set_axis_off()


def _draw_panel(
    ax: Any,
    x: np.ndarray,
    bands: np.ndarray,
    color: str,
    title: str,
    labels: dict[str, str],
) -> None:
    """Draw percentiles over x, on a logarithmic axis if they are positive."""
    ax.set_title(title, **TITLE)
    if not _draw_bands(ax, x, bands, color):
        return
    ax.set(**labels)
    if np.nanmin(bands) > 0:
        ax.set_yscale("log")
    legend_above_data(ax)


def _draw_bands(ax: Any, x: np.ndarray, bands: np.ndarray, color: str) -> bool:
    """Draw percentiles over x; return whether there are any."""
    if not np.isfinite(bands).any():
        _draw_message(ax, "no run has come so far")
        return False
    low, quarter, median, three_quarters, high = bands
    area = {"color": color, "linewidth": 0}
    ax.fill_between(x, low, high, alpha=0.18, label="5 to 95 %", **area)
    ax.fill_between(x, quarter, three_quarters, alpha=0.35, label="25 to 75 %", **area)
    line = {"color": color, "marker": "o" if len(x) < 12 else None}
    ax.plot(x, median, linewidth=1.5, markersize=4, label="median", **line)
    for edge in (low, high):
        ax.plot(x, edge, linewidth=0.6, linestyle="--", markersize=2, **line)
    return True


def _diagram_plot(data: "xarray.Dataset", ax: Any) -> Any:
    """Draw percentiles over time of each output; without trajectories, rms over a varied number."""
    signals = signals_over_time(data)
    stored = bool(signals)
    signals = signals or rms_of(data)
    axes = panels_for(ax, len(signals), f"data[{[*data.data_vars][-1:]}]")
    panels = np.ravel(axes)
    x = data["time"] if stored else _first_varied(data)
    for panel, (label, signal) in zip(panels, signals.items(), strict=True):
        if stored:
            _draw_bands(panel, x.values, _percentiles_of(signal), BLUE)
        else:
            panel.plot(x.values, signal.values, ".", color=BLUE)
        panel.set_ylabel(literal(named(label, signal.attrs.get("units"))))
    count = f"{data.sizes['member']:,}".replace(",", " ")
    panels[0].set_title(f"{count} members", **TITLE)
    if stored and panels[0].lines:
        legend_above_data(panels[0])
    panels[-1].set_xlabel(literal(named(str(x.name), x.attrs.get("units"))))
    return axes


def _first_varied(data: "xarray.Dataset") -> "xarray.DataArray":
    """Return the first number that varies, or the number of the member."""
    keys = json.loads(data.attrs["ensemble"])["keys"]
    single = [data[key] for key in keys if key in data and data[key].ndim == 1]
    return single[0] if single else data["member"]
