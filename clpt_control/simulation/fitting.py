"""Fit of a diagram's parameters to measured outputs: least squares with exact sensitivities.

    minimize  sum over samples of ((y(t; p) - measured) / noise)^2

`fit_problem` has the residuals, the estimate of the noise and the covariance of the estimates.
"""

from collections.abc import Mapping, Sequence
from typing import Any

import control
import numpy as np

from ..base.arguments import numbers, public
from ..base.errors import ArgumentError
from ..engine.model.ports import ports_of
from ..engine.solver.schedule import checked_times
from ..paper.scenario.experiment import Scenario
from .fit_problem import Fit, FitProblem
from .sensitivities import SensitivityRun


@public
def fit_parameters(
    system: Scenario | control.InputOutputSystem,
    data: Any,
    parameters: Mapping[str, Any],
    timepts: Sequence[float] | np.ndarray | None = None,
    inputs: Any = None,
    initial_state: Any = None,
    params: Mapping[str, Any] | None = None,
    *,
    rtol: float | None = None,
    atol: float | None = None,
    method: str | None = None,
) -> Fit:
    """Fit parameters and states of the start to measured outputs.

    Parameters
    ----------
    system : Scenario or control.InputOutputSystem
        As `sensitivity` takes it.
    data : xarray.Dataset or mapping
        Measured outputs: variables over ``time``, or arrays by port or signal, samples first, at
        `timepts`. NaN is no measurement.
    parameters : mapping
        By name, as `sensitivity` takes them in `to`: where to begin, ``{"m": 1.0}``, or that and
        bounds, ``{"m": (1.0, 0.1, 10.0)}``.
    timepts : array_like, optional
        Times of arrays.
    inputs, initial_state, params, rtol, atol, method
        As `simulate` takes them, at the times of the data.

    Returns
    -------
    Fit
        Estimates with standard errors and intervals, and what the data do not tell.

    Raises
    ------
    SimulationError
        If a name is unknown, a derivative is not known, or a run cannot go on.

    Examples
    --------
    >>> import control
    >>> import clpt_control as clpt
    >>> decay = control.nlsys(lambda t, x, u, p: [-p["k"] * x[0]], name="decay",
    ...                       inputs=0, states=["y"], outputs=["y"], params={"k": 1.0})
    >>> times = np.linspace(0.0, 2.0, 21)
    >>> measured = 3.0 * np.exp(-1.7 * times) + 0.01 * np.cos(40.0 * times)
    >>> fit = clpt.fit_parameters(decay, {"y": measured}, {"k": 1.0, "x0.y": 2.0}, times)
    >>> {name: round(value, 2) for name, value in fit.values.items()}
    {'k': 1.7, 'x0.y': 3.0}
    """
    times, measured = _measurements(data, timepts)
    run = SensitivityRun(
        system,
        times,
        list(parameters),
        inputs,
        initial_state,
        params,
        rtol=rtol,
        atol=atol,
        method=method,
    )
    problem = FitProblem(run, measured, parameters)
    unknown = set()
    if isinstance(data, dict):
        unknown |= measured.keys() - problem.ports.keys()
    if inputs is None:
        unknown |= measured.keys() & ports_of(run.input_labels).keys()
    if unknown:
        raise ArgumentError(
            f"data: {min(unknown)} is not an output; they are {', '.join(ports_of(run.labels))}; "
            "inputs= takes inputs"
        )
    return problem.fit()


def _measurements(data: Any, times: Any) -> tuple[np.ndarray, dict[str, np.ndarray]]:
    """Return times, and measured arrays by name, samples first."""
    is_dataset = hasattr(data, "data_vars")
    if is_dataset and "time" in data.dims:
        arrays = {
            str(name): variable.transpose("time", ...).values
            for name, variable in data.data_vars.items()
            if "time" in variable.dims
        }
        return checked_times("data.time", data.time.values), arrays
    if is_dataset or not isinstance(data, Mapping):
        raise ArgumentError(
            "data: must be an xarray.Dataset with the dimension `time`, or arrays by name"
        )
    if times is None:
        raise ArgumentError("timepts: is required with arrays")
    arrays = {name: numbers(f"data: {name}", values) for name, values in data.items()}
    return checked_times("timepts", times), arrays
