"""Fit parameters of a diagram to measured outputs: least squares with exact sensitivities.

    minimize  sum over samples of ((y(t; p) - measured) / noise)^2

The noise of each output is estimated from what the fit leaves, over its numbers less those that
the unknowns have spent: the trace of its part of the projection on J.

SciPy's `least_squares` takes the steps, `sensitivity` is its Jacobian J.  The covariance of what is
found is s^2 (J' J)^-1; a direction of parameters that J does not feel has none, and is told.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import control
import numpy as np

from ..base.arguments import brief, numbers, public
from ..base.errors import ArgumentError, SimulationError
from ..engine.model.ports import ports_of
from ..engine.solver.schedule import checked_times
from ..paper.scenario.experiment import Scenario
from .tangents import RunWithDerivatives, Sensitive, varied_places

UNFELT = 1e-6  # of the strongest direction of relative changes: a weaker one is not identified
TAKES_PART = 1e-2  # share of a direction from which on a parameter is named
# in which the noise of several outputs is estimated, until it moves less
ROUNDS, SETTLED = (6, 1e-3)
CLOSE = 1e-10  # of steps and sums, where least squares ends


@dataclass
class Fit:
    """What `fit_parameters` found.

    Attributes
    ----------
    values, errors : dict
        By name: the estimate, and its standard error; inf where the data do not tell it, NaN where
        it lies on a bound.
    intervals : dict
        By name: from where to where it lies with 95 %, if noise is normal and the model right.
    covariance : ndarray
        Of the estimates, in the order of `values`.
    noise : dict
        Standard deviation of each output's noise, as estimated.
    unidentified : tuple of str
        A sentence for each direction of parameters that the data do not tell, and for each bound
        that is met.
    params, initial_state
        To hand to `simulate`.

    Examples
    --------
    >>> found = Fit({"k": 2.0}, {"k": 0.1}, {"k": (1.8, 2.2)}, np.array([[0.01]]), {"y": 0.05})
    >>> found
    k = 2 +- 0.1    (1.8 to 2.2)
    noise of y: 0.05
    """

    values: dict[str, float]
    errors: dict[str, float]
    intervals: dict[str, tuple[float, float]]
    covariance: np.ndarray
    noise: dict[str, float]
    unidentified: tuple[str, ...] = ()
    params: dict[str, Any] = field(default_factory=dict)
    initial_state: Any = None

    def __repr__(self) -> str:
        lines = [
            f"{name} = {value:.6g} +- {self.errors[name]:.2g}    "
            f"({self.intervals[name][0]:.6g} to {self.intervals[name][1]:.6g})"
            for name, value in self.values.items()
        ]
        noises = ", ".join(f"{name}: {size:.3g}" for name, size in self.noise.items())
        return "\n".join([*lines, f"noise of {noises}", *self.unidentified])


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
    >>> found = clpt.fit_parameters(decay, {"y": measured}, {"k": 1.0, "x0.y": 2.0}, times)
    >>> {name: round(value, 2) for name, value in found.values.items()}
    {'k': 1.7, 'x0.y': 3.0}
    """
    times, measured = _read(data, timepts)
    solver = {"rtol": rtol, "atol": atol, "method": method}
    ready = Sensitive(
        system, times, list(parameters), inputs, initial_state, params, **solver
    )
    fitting = _Fitting(ready, measured, parameters)
    strange = measured.keys() - fitting.known if isinstance(data, dict) else set()
    if inputs is None:
        strange |= measured.keys() & fitting.inputs
    if strange:
        raise ArgumentError(
            f"data: {min(strange)} is no output; they are {', '.join(ports_of(ready.labels))}; "
            "inputs= takes inputs"
        )
    return fitting.fit()


def _read(data: Any, times: Any) -> tuple[np.ndarray, dict[str, np.ndarray]]:
    """Return times, and measured arrays by name, samples first."""
    if hasattr(data, "data_vars") and "time" in data.dims:
        variables = {
            str(name): one for name, one in data.data_vars.items() if "time" in one.dims
        }
        arrays = {
            name: one.transpose("time", ...).values for name, one in variables.items()
        }
        return checked_times("data.time", data.time.values), arrays
    if not isinstance(data, Mapping) or hasattr(data, "data_vars"):
        raise ArgumentError(
            "data: must be an xarray.Dataset with the dimension `time`, or arrays by name"
        )
    if times is None:
        raise ArgumentError("timepts: is required with arrays")
    arrays = {name: numbers(f"data: {name}", values) for name, values in data.items()}
    return checked_times("timepts", times), arrays


class _Fitting:
    """A diagram, what was measured of it, and where a fit begins."""

    def __init__(self, ready: Sensitive, measured: Mapping[str, Any], begin: Any):
        self.ready, self.names = ready, [*ready.places]
        ports = {one: [k] for k, one in enumerate(ready.labels)} | ports_of(
            ready.labels
        )
        self.known, self.inputs = ports.keys(), ports_of(ready.input_labels).keys()
        n, places, columns = (
            len(ready.times) - ready.skipped,
            list[int](),
            list[np.ndarray](),
        )
        self.outputs: list[str] = []
        for name, values in measured.items():
            if name not in ports or not np.isfinite(values).any():
                continue
            if set(ports[name]) & set(places):
                raise ArgumentError(f"data: {name} is given twice")
            if values.size != n * len(ports[name]) or values.shape[0] != n:
                raise ArgumentError(
                    f"data: {name} has the shape {values.shape}; must be {n} samples of "
                    f"{len(ports[name])} signals"
                )
            places += ports[name]
            columns += list(values.reshape(n, -1).T)
            self.outputs += [
                ready.labels[k] if len(ports[name]) > 1 else name for k in ports[name]
            ]
        if not places:
            raise ArgumentError(
                f"data: has no finite numbers of the outputs {', '.join(ports_of(ready.labels))}"
            )
        self.places, self.measured = places, np.array(columns).T
        self.there = np.isfinite(self.measured)
        if self.there.sum() <= len(self.names):
            raise ArgumentError(
                f"data: {self.there.sum()} numbers for {len(self.names)} unknowns"
            )
        self.begin, self.low, self.high = self._bounds(begin)
        self.last: tuple[np.ndarray, RunWithDerivatives] | None = None

    def _bounds(self, parameters: Mapping[str, Any]) -> list[np.ndarray]:
        """Return where each number begins, and its bounds."""
        rows = []
        for name, one in parameters.items():
            begin, *bounds = one if isinstance(one, tuple) else (one,)
            count = len(varied_places(name, self.ready.wiring, self.ready.states))
            given = [
                np.ravel(numbers(name, v))
                for v in (begin, *(bounds or (-np.inf, np.inf)))
            ]
            if len(given) == 3 and all(len(v) in (1, count) for v in given):
                start, low, high = row = np.array(
                    [np.broadcast_to(v, count) for v in given]
                )
                if np.all(
                    np.isfinite(start) & (low <= start) & (start <= high) & (low < high)
                ):
                    rows.append(row)
                    continue
            what = "a number" if count == 1 else f"{count} numbers"
            raise ArgumentError(
                f"parameters: {name} = {brief(one)}: must be {what} to begin at, or (start, low, "
                "high) with low <= start <= high"
            )
        return list(np.hstack(rows))

    def run(self, values: np.ndarray) -> RunWithDerivatives:
        """Return the run at these values, of the last ones again."""
        if self.last is None or not np.array_equal(values, self.last[0]):
            try:
                result = self.ready.run(values)
            except SimulationError as error:
                said = ", ".join(
                    f"{n} = {v:.6g}" for n, v in zip(self.names, values, strict=True)
                )
                raise SimulationError(
                    f"at {said}: {error}; begin closer, or give bounds"
                ) from None
            if len(result.outputs) < len(self.measured):
                raise SimulationError(
                    f"the run ends before the data: {result.solution.message}"
                )
            self.last = values.copy(), result
        return self.last[1]

    def residuals(self, values: np.ndarray, noise: np.ndarray) -> np.ndarray:
        """Return what is left, in units of the noise; infinite where a try cannot run."""
        try:
            residuals = self.run(values).outputs[:, self.places, 0] - self.measured
        except SimulationError:
            if self.last is None:  # where the fit begins
                raise
            return np.full(self.there.sum(), np.inf)
        return (residuals / noise)[self.there]

    def jacobian(self, values: np.ndarray, noise: np.ndarray) -> np.ndarray:
        """Return the derivatives of what is left."""
        return (self.run(values).outputs[:, self.places, 1:] / noise[:, None])[
            self.there
        ]

    def fit(self) -> Fit:
        """Take steps until nothing gets better, and the noise of several outputs settles."""
        from scipy.optimize import least_squares

        count = self.there.sum(axis=0)
        size = np.nanstd(np.where(self.there, self.measured, np.nan), axis=0)
        values, noise = self.begin, np.where(size > 0, size, 1.0)
        least = 1e-9 * noise
        for _ in range(ROUNDS):
            result = least_squares(
                self.residuals, values, self.jacobian, (self.low, self.high), x_scale="jac",
                ftol=CLOSE, xtol=CLOSE, gtol=CLOSE, args=(noise,),
            )  # fmt: skip
            values = result.x
            self.ready.confirm(values, self.run(values))
            residuals = np.zeros(self.there.shape)
            residuals[self.there] = self.residuals(values, np.ones(len(noise)))
            # by each number, of as many as there are unknowns
            spent = np.zeros(self.there.shape)
            J = result.jac[:, result.active_mask == 0]
            spent[self.there] = (np.linalg.qr(J)[0] ** 2).sum(axis=1)
            freedom = np.maximum(count - spent.sum(axis=0), 1e-9)
            before, noise = (
                noise,
                np.maximum(np.sqrt((residuals**2).sum(axis=0) / freedom), least),
            )
            if len(noise) == 1 or np.all(np.abs(noise / before - 1.0) < SETTLED):
                break
        return self._found(values, noise, result.active_mask == 0)

    def _found(self, values: np.ndarray, noise: np.ndarray, free: np.ndarray) -> Fit:
        """Return the estimates with what the Jacobian says of them."""
        from scipy.stats import t

        residuals, J = self.residuals(values, noise), self.jacobian(values, noise)
        freedom = len(residuals) - int(free.sum())
        variance = float(residuals @ residuals) / freedom
        value, begun = np.abs(values)[free], np.abs(self.begin)[free]
        # of a zero, that of its start
        scale = np.where(value > UNFELT * begun, value, begun)
        scale[scale == 0.0] = 1.0
        _, strength, directions = np.linalg.svd(J[:, free] * scale, full_matrices=False)
        identified = strength > UNFELT * strength.max(initial=0.0)
        half = directions[identified].T / strength[identified] * scale[:, None]
        inner = variance * half @ half.T
        lost = np.any(np.abs(directions[~identified]) > TAKES_PART, axis=0)
        inner[lost, :] = inner[:, lost] = np.nan
        covariance = np.full((len(values), len(values)), np.nan)
        covariance[np.ix_(free, free)] = inner
        errors = np.sqrt(np.diag(covariance))
        errors[np.flatnonzero(free)[lost]] = np.inf
        times = t.ppf(0.975, freedom)
        free_names = [name for name, one in zip(self.names, free, strict=True) if one]
        start, blocks = self.ready.with_values(values)
        params = {
            name.partition("[")[0]: getattr(blocks[k], field)
            for name, place in self.ready.places.items()
            for k, field in place.fields[:1]
        }
        return Fit(
            dict(zip(self.names, map(float, values), strict=True)),
            dict(zip(self.names, map(float, errors), strict=True)),
            {name: (float(v - times * e), float(v + times * e))
             for name, v, e in zip(self.names, values, errors, strict=True)},
            covariance,
            dict(zip(self.outputs, map(float, noise), strict=True)),
            (*(_sentence(free_names, one) for one in directions[~identified]),
             *(f"{name} lies on a bound" for name in self.names if name not in free_names)),
            {name: one if one.ndim else float(one) for name, one in params.items()},
            start,
        )  # fmt: skip


def _sentence(names: Sequence[str], direction: np.ndarray) -> str:
    """Return of which change together the data know nothing."""
    parts = [
        (name, v)
        for name, v in zip(names, direction, strict=True)
        if abs(v) > TAKES_PART
    ]
    if len(parts) == 1:
        return f"the data do not tell {parts[0][0]}"
    largest = max(abs(v) for _, v in parts)
    moves = ", ".join(f"{name} by {v / largest:+z.2g} %" for name, v in parts)
    return f"the data do not tell {' and '.join(n for n, _ in parts)} apart: {moves} is not felt"
