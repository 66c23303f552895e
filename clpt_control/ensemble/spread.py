"""An ensemble in a few numbers: percentiles over its members."""

from typing import TYPE_CHECKING, Any

import numpy as np

from .summary import STATUS

if TYPE_CHECKING:
    import xarray

PERCENTS = (5, 25, 50, 75, 95)
READ_BYTES = 8_000_000  # at once, so that memory does not grow with the members


def percentiles(data: "xarray.Dataset", name: str) -> np.ndarray:
    """Return percentiles over the members, column by column.

    Parameters
    ----------
    data : xarray.Dataset
        As `run_ensemble` gives it.
    name : str
        A variable with the dimensions member and another.

    Returns
    -------
    ndarray, shape (5, n)
        5, 25, 50, 75 and 95 percent; members that did not come so far are
        left out, NaN where none came.

    Examples
    --------
    >>> import xarray
    >>> data = xarray.Dataset({"e": (("member", "mark"), np.arange(5.0)[:, None])})
    >>> percentiles(data, "e")[:, 0]
    array([0.2, 1. , 2. , 3. , 3.8])
    """
    members, columns = data[name].shape
    wide = max(1, READ_BYTES // (8 * members))
    found = np.full((len(PERCENTS), columns), np.nan)
    for first in range(0, columns, wide):
        block = data[name][:, first : first + wide].values
        for k, column in enumerate(block.T, first):
            column = column[np.isfinite(column)]
            if len(column):
                found[:, k] = np.percentile(column, PERCENTS)
    return found


def ensemble_summary(data: "xarray.Dataset") -> dict[str, Any]:
    """Return an ensemble's figures, ready for JSON.

    Parameters
    ----------
    data : xarray.Dataset
        As `run_ensemble` gives it.

    Returns
    -------
    dict
        ``members``, how they ended and the first that failed, and percentiles
        of the CLPE rms per cycle and over the run, and of the errors at the
        last mark; None where no member came.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> from clpt_control.ensemble.run import run_ensemble
    >>> scenario = clpt.paper_scenario().with_values({"run.duration": 20})
    >>> data = run_ensemble(scenario, "learning.gain=0.2:2.0", 3, seed=1)
    >>> ensemble_summary(data)["ended"]
    {'finished': 3}
    """
    status = data["status"].values
    failed = np.flatnonzero(status != 1)
    summary: dict[str, Any] = {
        "title": data.attrs["title"],
        "members": len(status),
        "ended": {_status(k): int(np.sum(status == k)) for k in np.unique(status)},
        "first_failed": int(failed[0]) if len(failed) else None,
        "percents": list(PERCENTS),
        "clpe_rms_per_cycle": [_listed(column) for column in percentiles(data, "clpe_rms").T],
    }
    last = data.isel(mark=[-1])
    whole = data[["clpe_rms_whole"]].expand_dims("one", axis=1)
    summary["clpe_rms"] = _listed(percentiles(whole, "clpe_rms_whole")[:, 0])
    for name in ("flow_parameter_error", "gain_error"):
        if name in data:
            summary[f"{name}_at_end"] = _listed(percentiles(last, name)[:, 0])
    return summary


def _listed(column: np.ndarray) -> list[float] | None:
    return column.tolist() if np.isfinite(column).all() else None


def _status(number: int) -> str:
    return STATUS[number] if number < len(STATUS) else f"status_{number}"
