"""Ensemble statistics: percentiles over the members.

Of a scenario: CLPE in each cycle, errors of what was learned.  Of any diagram: its summaries, and
each output over time with ``trajectories=True``.
"""

import json
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np

from ..base.arguments import check_holds, public
from ..simulation.comparison import label_of, labelled_elements
from .results import COMPLETED, STATUS

if TYPE_CHECKING:
    import xarray

PERCENTS = (5, 25, 50, 75, 95)
ENSEMBLE = "clpt.run_ensemble(scenario, vary, members) makes an ensemble"
READ_BYTES = 8_000_000  # read at once, so that memory does not grow with the members


def percentiles_of(signal: "xarray.DataArray") -> np.ndarray:
    """Return percentiles over the members, shape (5, n); n is 1 for numbers by member."""
    signal = signal if signal.ndim == 2 else signal.expand_dims("one", axis=1)
    members, columns = signal.shape
    wide = max(1, READ_BYTES // (8 * members))
    result = np.full((len(PERCENTS), columns), np.nan)
    for begin in range(0, columns, wide):
        block = signal[:, begin : begin + wide].values
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
    data = by_member(data)
    status = data["status"].values
    failed = np.flatnonzero(~np.isin(status, COMPLETED))
    return {
        "title": data.attrs["title"],
        "members": len(status),
        "ended": {STATUS[k]: int(np.sum(status == k)) for k in np.unique(status)},
        "first_failed": int(failed[0]) if len(failed) else None,
        "percents": list(PERCENTS),
        "summaries": {
            label_of(label, one): _listed(percentiles_of(one)[:, 0])
            for label, one in summaries_of(data).items()
        },
    }


def is_of_diagram(data: "xarray.Dataset") -> bool:
    """Return whether an ensemble is of a diagram, without the summaries of the paper's loop."""
    return "ensemble" in data.attrs and "scenario" not in data.attrs


def by_member(data: "xarray.Dataset") -> "xarray.Dataset":
    """Return an ensemble with members along the first dimension, also of an unstacked grid."""
    if "member" not in data.dims:
        keys = json.loads(data.attrs["ensemble"])["keys"]
        dims = [key for key in keys if key in data.dims]
        # xarray does not stack arrays without elements, such as the rms over 0 cycles
        empty = [name for name, array in data.data_vars.items() if not array.size]
        stacked = data.drop_vars(empty).stack(member=dims)
        count = {"member": stacked.sizes["member"]}
        first = data[empty].isel(dict.fromkeys(dims, 0), True, "ignore")
        data = stacked.assign(first.expand_dims(count))
    return data.transpose("member", ...)


def curves_of(data: "xarray.Dataset") -> "dict[str, xarray.DataArray]":
    """Return percentile curves, shape (member, times or cycles), by their labels.

    Of a scenario these are the CLPE in each cycle and the error of what was learned, of a diagram
    its outputs over time.
    """
    if is_of_diagram(data):
        ports = [port for port in data.data_vars.values() if "time" in port.dims]
        return {label: signal for port in ports for label, signal in _elements(port)}
    errors = [name for name in ("flow_parameter_error", "gain_error") if name in data]
    return {name: data[name] for name in ("clpe_rms", *errors[:1])}


def summaries_of(data: "xarray.Dataset") -> "dict[str, xarray.DataArray]":
    """Return each summary, shape (member,), by its label; errors at the last mark."""
    if "mark" in data.dims:
        data = data.isel(mark=[-1])
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
    """Yield the label and the values of each number of an array: ``e[0]``, ``e cycle 1``."""
    for label, index in labelled_elements(array, "member", "time"):
        yield label, array.isel(index)


def _listed(column: np.ndarray) -> list[float] | None:
    return column.tolist() if np.isfinite(column).all() else None
