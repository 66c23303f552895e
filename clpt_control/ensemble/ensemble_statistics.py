"""Ensemble statistics and their plot: percentiles over the members."""

from typing import TYPE_CHECKING, Any

import numpy as np

from ..base.arguments import check_holds, public
from ..base.errors import ArgumentError, DataError
from ..base.figures import BLUE, GREY, RED, TITLE, axes_for
from .store import ARGUMENTS
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
    refuse_diagram("ensemble_summary", data)
    check_holds(
        "ensemble_summary: data",
        data,
        ["status", "clpe_rms", "clpe_rms_whole"],
        ENSEMBLE,
    )
    status = data["status"].values
    failed = np.flatnonzero(status != 1)
    summary = {
        "title": data.attrs["title"],
        "units": {
            "length": data["clpe_rms"].attrs["units"],
            "time": data["mark"].attrs["units"],
        },
        "members": len(status),
        "ended": {STATUS[k]: int(np.sum(status == k)) for k in np.unique(status)},
        "first_failed": int(failed[0]) if len(failed) else None,
        "percents": list(PERCENTS),
        "clpe_rms_per_cycle": [
            _listed(column) for column in percentiles(data, "clpe_rms").T
        ],
    }
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


def refuse_diagram(function: str, data: "xarray.Dataset") -> None:
    """Refuse an ensemble of a diagram, which has no summaries of the paper's loop."""
    if ARGUMENTS in data.attrs and "scenario" not in data.attrs:
        raise DataError(
            f"{function}: data is an ensemble of a diagram, which xarray draws: of a grid of two "
            "names data.unstack()['y_rms'].plot.contourf(), of drawn values "
            "data.plot.scatter(x='NAME', y='y_rms')"
        )


def unit_of(values: "xarray.DataArray") -> str:
    """Return CF units in the form m/s, instead of m s-1."""
    length, _, per = values.attrs.get("units", "").rpartition(" ")
    return f"{length or '1'}/{per.removesuffix('-1')}" if per.endswith("-1") else per


def _listed(column: np.ndarray) -> list[float] | None:
    return column.tolist() if np.isfinite(column).all() else None


@public
def ensemble_plot(data: "xarray.Dataset", *, ax: Any = None) -> np.ndarray:
    """Draw percentiles of CLPE and of the parameter error.

    >>> import clpt_control as clpt
    >>> scenario = clpt.paper_scenario().with_values({"run.duration": 20})
    >>> data = clpt.run_ensemble(scenario, "learning.gain=0.2:2.0", 3)
    >>> clpe, error = ensemble_plot(data)
    """
    refuse_diagram("ensemble_plot", data)
    check_holds("ensemble_plot: data", data, ["clpe_rms"], ENSEMBLE)
    axes = axes_for(ax, 6.4, 6.0, nrows=2)
    length, time = data["clpe_rms"].attrs["units"], data["mark"].attrs["units"]
    # 1. CLPE
    cycles = np.arange(1, data.sizes["cycle"] + 1)
    count = f"{data.sizes['member']:,}".replace(",", " ")
    title = f"CLPE of {count} members"
    labels = {"xlabel": "cycle of the waypoints", "ylabel": f"CLPE rms ({length})"}
    _draw_bands(axes[0], cycles, percentiles(data, "clpe_rms"), BLUE, title, labels)
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
    _draw_bands(axes[1], marks, percentiles(data, name), RED, title, labels)
    return axes


def _draw_message(ax: Any, message: str) -> None:
    ax.text(0.5, 0.5, message, ha="center", color=GREY, transform=ax.transAxes)
    ax.set_axis_off()


def _draw_bands(
    ax: Any,
    x: np.ndarray,
    bands: np.ndarray,
    color: str,
    title: str,
    labels: dict[str, str],
) -> None:
    """Draw percentiles over x, on a logarithmic axis if they are positive."""
    ax.set_title(title, **TITLE)
    if not np.isfinite(bands).any():
        _draw_message(ax, "no run has come so far")
        return
    low, quarter, median, three_quarters, high = bands
    area = {"color": color, "linewidth": 0}
    ax.fill_between(x, low, high, alpha=0.18, label="5 to 95 %", **area)
    ax.fill_between(x, quarter, three_quarters, alpha=0.35, label="25 to 75 %", **area)
    line = {"color": color, "marker": "o" if len(x) < 12 else None}
    ax.plot(x, median, linewidth=1.5, markersize=4, label="median", **line)
    for edge in (low, high):
        ax.plot(x, edge, linewidth=0.6, linestyle="--", markersize=2, **line)
    ax.set(**labels)
    if np.nanmin(bands) > 0:
        ax.set_yscale("log")
    ax.legend(frameon=False, fontsize=8)
