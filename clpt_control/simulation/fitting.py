"""Fit of a diagram's parameters to measured outputs: least squares with exact sensitivities.

    minimize  sum over samples of ((y(t; p) - measured) / noise)^2

SciPy's `least_squares` takes the steps, and the sensitivities of the run are its Jacobian J.  The
noise of each output is estimated from its residuals, with as many degrees of freedom as it has
measurements less its part of the trace of the projection on J.  The covariance of the estimates is
s^2 (J' J)^-1; directions of parameters that are not identifiable are reported.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from itertools import compress
from typing import Any, NamedTuple

import control
import numpy as np

from ..base.arguments import brief, known, public
from ..base.errors import ArgumentError, BlockError, SimulationError
from ..base.figures import BLUE, GREY, RED, TITLE, axes_for, literal
from ..base.labelled import (
    Clock,
    Labelled,
    axes_of,
    is_within,
    labelled,
    own_times,
    rounding,
    unlabelled,
)
from ..engine.diagram.wiring import Params, check_unit
from ..engine.model.ports import indices_by_name, ports_of
from ..engine.solver.inputs import checked_times
from ..paper.scenario.experiment import Scenario
from .comparison import named
from .diagram_runs import signal_units
from .requests import as_diagram, clock_of, distinct_times
from .sensitivities import RunWithDerivatives, SensitivityRun
from .sensitivity_names import varied_numbers

IDENTIFIABLE = 1e-6  # least singular value of an identifiable direction, relative
NAMED = 1e-2  # least component of a parameter that is named in a direction
ROUNDS = 6  # of the estimate of the noise, at most
NOISE_TOLERANCE = 1e-3  # change of the noise at which the rounds end, relative
TOLERANCE = 1e-10  # of least squares
EXACT = 1e-6  # residuals that errors of integration may make, relative to the data
CONSTANT = 1e-12  # spread of data that do not change, relative to them
SMALLEST = 1e-300  # sum of squares
GAP = 5.0  # median steps between measurements over which a chart draws no line
WHITE = 3.0  # largest lag-one correlation of noise, in standard deviations


class FittedOutput(NamedTuple):
    """A measured output and that of the fitted model over time; NaN is no measurement."""

    times: np.ndarray
    measured: np.ndarray
    modelled: np.ndarray
    units: str = ""

    @property
    def residuals(self) -> np.ndarray:
        """Differences of data and model."""
        return self.measured - self.modelled

    @property
    def explained(self) -> float:
        """Share of the variance of the data that the model explains; -inf of constant data."""
        variance = np.nanvar(self.measured)
        if variance <= (CONSTANT * np.nanmax(np.abs(self.measured))) ** 2:
            return -np.inf
        return 1.0 - np.nanmean(self.residuals**2) / variance

    @property
    def correlation(self) -> float:
        """Lag-one correlation of the residuals, near 0 if they are noise."""
        finite = self.residuals[np.isfinite(self.residuals)]
        return finite[1:] @ finite[:-1] / max(finite @ finite, SMALLEST)

    def __str__(self) -> str:
        share = f"{100.0 * self.explained:.2f} % of the variance explained"
        if self.explained == -np.inf:
            share = "no variance to explain"
        quality = f"{share}, lag-one correlation of residuals {self.correlation:.2f}"
        size = max(np.nansum(self.measured**2), SMALLEST)
        if np.nansum(self.residuals**2) < EXACT**2 * size:
            return quality
        count = np.isfinite(self.residuals).sum()
        # noise alone explains 1/count less than its mean does
        is_far = self.explained < -(WHITE**2) / count
        is_white = abs(self.correlation) < WHITE / np.sqrt(count)
        if is_far and (is_white or self.explained > -np.inf):
            poor = "the model is farther from the data than their mean"
            return f"{quality}; {poor}: the errors are too small, begin elsewhere"
        if not is_white:
            errors = "are too small" if self.correlation > 0.0 else "may be wrong"
            return f"{quality}; residuals are not noise: the errors {errors}"
        return quality


@dataclass
class Fit:
    """Result of `fit_parameters`.

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
    outputs : dict
        By name: `times`, `measured` and `modelled`; `explained`, a share of the variance of the
        data; `correlation`, of the residuals at lag one.

    Examples
    --------
    >>> fit = Fit({"k": 2.0}, {"k": 0.1}, {"k": (1.8, 2.2)}, np.array([[0.01]]), {"y": 0.05})
    >>> fit
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
    outputs: dict[str, FittedOutput] = field(default_factory=dict)

    def __repr__(self) -> str:
        lines = [
            f"{name} = {value:.6g} +- {self.errors[name]:.2g}    "
            f"({self.intervals[name][0]:.6g} to {self.intervals[name][1]:.6g})"
            for name, value in self.values.items()
        ]
        noises = ", ".join(f"{name}: {size:.3g}" for name, size in self.noise.items())
        quality = [f"{name}: {output}" for name, output in self.outputs.items()]
        return "\n".join([*lines, f"noise of {noises}", *quality, *self.unidentified])

    def plot(self, *, ax: Any = None) -> Any:
        """Draw data and model of each output over time, and the residuals below."""
        count = len(self.outputs)
        axes = axes_for(ax, 6.4 * count, 4.8, nrows=2, ncols=count, sharex="col")
        panels = np.reshape(axes, (2, count)).T
        for (above, below), (name, output) in zip(
            panels, self.outputs.items(), strict=True
        ):
            above.plot(output.times, output.measured, ".", color=GREY, label="data")
            steps = np.diff(output.times)
            gaps = (
                np.flatnonzero(steps > GAP * np.median(steps)) + 1
            )  # no line over them
            times, modelled, residuals = (
                np.insert(np.asarray(of, float), gaps, np.nan)
                for of in (output.times, output.modelled, output.residuals)
            )
            above.plot(times, modelled, color=BLUE, label="model")
            above.set_title(literal(named(name, output.units)), **TITLE)
            above.legend(frameon=False, fontsize=8)
            below.plot(times, residuals, ".-", color=RED, linewidth=0.5)
            below.set(xlabel="time", ylabel="data - model")
        return axes


class FitProblem:
    """Measurements of a diagram's outputs, initial values of the parameters, and bounds."""

    def __init__(
        self,
        run: SensitivityRun,
        measured: Mapping[str, Labelled],
        parameters: Mapping[str, Any],
    ):
        self.run = run
        self.names = [*run.locations]
        by_label = {label: [k] for k, label in enumerate(run.output_labels)}
        self.ports = by_label | ports_of(run.output_labels)
        self._read(measured)
        self.start, self.low, self.high = self._bounds(parameters)
        self.last: tuple[np.ndarray, RunWithDerivatives] | None = None

    def _read(self, measured: Mapping[str, Labelled]) -> None:
        """Read the measurements: columns of outputs, their names, values and finite ones."""
        times = self.times = self.run.request.times[self.run.request.skipped :]
        self.columns: list[int] = []
        self.outputs: dict[str, str] = {}  # name -> unit
        values: list[np.ndarray] = []
        units = signal_units(self.run.wiring)
        for name, signal in measured.items():
            if name not in self.ports:
                advice = known(name, ports_of(self.run.output_labels))
                raise ArgumentError(
                    f"data: {name} is not an output; inputs= takes inputs. {advice}"
                )
            if np.isinf(signal.values).any():
                raise ArgumentError(
                    f"data: {name}: must be finite; NaN is no measurement"
                )
            if np.isnan(signal.values).all():
                continue
            columns = self.ports[name]
            if set(columns) & set(self.columns):
                raise ArgumentError(f"data: {name} is given twice")
            labels = [self.run.output_labels[k] for k in columns]
            own_units = [units[k] for k in columns]
            check_unit(f"data['{name}']", signal.units, own_units)
            array = signal.ordered(f"data['{name}']", labels)
            own_times: Any = signal.times
            count = len(columns)
            n = len(own_times)
            if array.shape[-1:] != (n,) or array.size != n * count:
                raise ArgumentError(
                    f"data: {name} has {array.size} numbers; must be {n} samples of {count} signals"
                )
            samples = np.full((count, len(times)), np.nan)
            samples[:, np.searchsorted(times, own_times)] = array.reshape(count, n)
            values += [*samples]
            self.columns += columns
            names = labels if count > 1 else [name]
            self.outputs |= zip(names, own_units, strict=True)
        if not values:
            ports = ", ".join(ports_of(self.run.output_labels))
            raise ArgumentError(f"data: has no finite numbers of the outputs {ports}")
        self.measured = np.array(values).T
        self.is_measured = np.isfinite(self.measured)
        count = self.is_measured.sum()
        if count <= len(self.names):
            raise ArgumentError(f"data: {count} numbers for {len(self.names)} unknowns")

    def _bounds(self, parameters: Mapping[str, Any]) -> list[np.ndarray]:
        """Return the initial values of all numbers, and their bounds."""
        rows = []
        for name, value in parameters.items():
            start, *bounds = value if isinstance(value, tuple) and value else (value,)
            row = [start, *(bounds or (-np.inf, np.inf))]
            row = [np.ravel(unlabelled(name, bound)) for bound in row]
            count = len(varied_numbers(name, self.run.wiring, self.run.states))
            if not _is_valid(row, count):
                what = "a number" if count == 1 else f"{count} numbers"
                raise ArgumentError(
                    f"parameters: {name} = {brief(value)}: must be {what} to begin at, or (start, "
                    "low, high) with low <= start <= high"
                )
            rows.append(np.array([np.broadcast_to(bound, count) for bound in row]))
        return list(np.hstack(rows))

    def run_at(self, values: np.ndarray) -> RunWithDerivatives:
        """Return the run at values of the parameters; the last run is cached."""
        if self.last is not None and np.array_equal(values, self.last[0]):
            return self.last[1]
        try:
            run = self.run.at(values)
        except SimulationError as error:
            pairs = zip(self.names, values, strict=True)
            point = ", ".join(f"{name} = {value:.6g}" for name, value in pairs)
            raise SimulationError(
                f"at {point}: {error}. Begin closer, or give bounds"
            ) from None
        if len(run.outputs) < len(self.measured):
            raise SimulationError(
                f"the run ends before the data: {run.solution.message}"
            )
        self.last = values.copy(), run
        return run

    def residuals(self, values: np.ndarray, noise: Any) -> np.ndarray:
        """Return residuals in units of the noise; infinite ones if a trial cannot run."""
        try:
            outputs = self.run_at(values).outputs[:, self.columns, 0]
        except (SimulationError, BlockError):
            if self.last is None:  # the initial values cannot run
                raise
            return np.full(self.is_measured.sum(), np.inf)
        return ((outputs - self.measured) / noise)[self.is_measured]

    def jacobian(self, values: np.ndarray, noise: np.ndarray) -> np.ndarray:
        """Return the derivatives of the residuals."""
        derivatives = self.run_at(values).outputs[:, self.columns, 1:]
        return (derivatives / noise[:, None])[self.is_measured]

    def fit(self) -> Fit:
        """Solve least squares; with several outputs, until their noise settles."""
        from scipy.optimize import least_squares

        deviation = np.nanstd(np.where(self.is_measured, self.measured, np.nan), axis=0)
        noise = np.where(deviation > 0, deviation, 1.0)
        least_noise = 1e-9 * noise
        values = self.start
        for _ in range(ROUNDS):
            result = least_squares(
                self.residuals,
                values,
                self.jacobian,
                (self.low, self.high),
                x_scale="jac",
                ftol=TOLERANCE,
                xtol=TOLERANCE,
                gtol=TOLERANCE,
                args=(noise,),
            )
            values = result.x
            free = result.active_mask == 0  # not on a bound
            self.run.confirm(values, self.run_at(values))
            previous_noise = noise
            noise = self._noise(values, result.jac[:, free])
            noise = np.maximum(noise, least_noise)
            change = np.abs(noise / previous_noise - 1.0)
            if len(noise) == 1 or np.all(change < NOISE_TOLERANCE):
                break
        return self._result(values, noise, free)

    def _noise(self, values: np.ndarray, J: np.ndarray) -> np.ndarray:
        """Return the standard deviation of each output's residuals."""
        squares = np.zeros(self.is_measured.shape)
        squares[self.is_measured] = self.residuals(values, 1.0) ** 2
        # diagonal of the projection on J
        leverage = np.zeros(self.is_measured.shape)
        leverage[self.is_measured] = (np.linalg.qr(J)[0] ** 2).sum(axis=1)
        freedom = self.is_measured.sum(axis=0) - leverage.sum(axis=0)
        return np.sqrt(squares.sum(axis=0) / np.maximum(freedom, 1e-9))

    def _result(self, values: np.ndarray, noise: np.ndarray, free: np.ndarray) -> Fit:
        """Return the estimates with their covariance and unidentifiable directions."""
        from scipy.stats import t

        residuals = self.residuals(values, noise)
        freedom = len(residuals) - int(free.sum())
        variance = float(residuals @ residuals) / freedom
        J = self.jacobian(values, noise)[:, free]
        covariance, errors, directions = self._covariance(values, variance, J, free)
        margins = t.ppf(0.975, freedom) * errors
        bounds = zip(
            (values - margins).tolist(), (values + margins).tolist(), strict=True
        )
        free_names = [*compress(self.names, free)]
        sentences = [_sentence(free_names, direction) for direction in directions]
        sentences += [f"{name} lies on a bound" for name in compress(self.names, ~free)]
        modelled = self.run_at(values).outputs[: len(self.times), self.columns, 0]
        columns = zip(self.outputs.items(), self.measured.T, modelled.T, strict=True)
        outputs = {
            name: FittedOutput(self.times, data, model, unit)
            for (name, unit), data, model in columns
        }
        parameters, start = self.run.with_values(values)
        params = {}
        for name, location in self.run.locations.items():
            for k, key in location.fields[:1]:
                value = getattr(parameters[k], key)
                params[name.partition("[")[0]] = value if value.ndim else float(value)
        return Fit(
            dict(zip(self.names, values.tolist(), strict=True)),
            dict(zip(self.names, errors.tolist(), strict=True)),
            dict(zip(self.names, bounds, strict=True)),
            covariance,
            dict(zip(self.outputs, noise.tolist(), strict=True)),
            tuple(sentences),
            params,
            start,
            outputs,
        )

    def _covariance(
        self, values: np.ndarray, variance: float, J: np.ndarray, free: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Return covariance, standard errors and directions that are not identifiable."""
        # relative changes; of a zero, relative to its initial value
        size = np.abs(values)[free]
        initial_size = np.abs(self.start)[free]
        scale = np.where(size > IDENTIFIABLE * initial_size, size, initial_size)
        scale[scale == 0.0] = 1.0
        _, strength, directions = np.linalg.svd(J * scale, full_matrices=False)
        identified = strength > IDENTIFIABLE * strength.max(initial=0.0)
        root = directions[identified].T / strength[identified] * scale[:, None]
        free_covariance = variance * root @ root.T
        unidentified = directions[~identified]
        unknown = np.any(np.abs(unidentified) > NAMED, axis=0)
        free_covariance[unknown, :] = np.nan
        free_covariance[:, unknown] = np.nan
        covariance = np.full((len(values), len(values)), np.nan)
        covariance[np.ix_(free, free)] = free_covariance
        errors = np.sqrt(np.diag(covariance))
        errors[np.flatnonzero(free)[unknown]] = np.inf
        return covariance, errors, unidentified


def _is_valid(row: Sequence[np.ndarray], count: int) -> bool:
    """Return whether a row is a start of `count` finite numbers, and bounds around it."""
    if len(row) != 3 or any(len(values) not in (1, count) for values in row):
        return False
    start, low, high = row
    inside = (low <= start) & (start <= high) & (low < high)
    return bool(np.all(inside & np.isfinite(start)))


def _sentence(names: Sequence[str], direction: np.ndarray) -> str:
    """Return a sentence on a direction of parameters that is not identifiable."""
    largest = np.abs(direction).max()
    changes = {
        name: component / largest
        for name, component in zip(names, direction, strict=True)
        if abs(component) > NAMED
    }
    joined = " and ".join(changes)
    if len(changes) == 1:
        return f"the data do not tell {joined}"
    moves = ", ".join(f"{name} by {change:+z.2g} %" for name, change in changes.items())
    return f"the data do not tell {joined} apart: {moves} is not felt"


@public
def fit_parameters(
    system: Scenario | control.InputOutputSystem,
    data: Any,
    parameters: Mapping[str, Any],
    timepts: Any = None,
    inputs: Any = None,
    initial_state: Any = None,
    params: Params = None,
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
    data : xarray.Dataset, pandas.DataFrame or mapping
        Measured outputs: variables over ``time``, columns beside the column or index ``time``, or
        arrays by port or signal, samples first, at `timepts`. NaN is no measurement.
    parameters : mapping
        By name, as `sensitivity` takes them in `to`: where to begin, ``{"m": 1.0}``, or that and
        bounds, ``{"m": (1.0, 0.1, 10.0)}``.
    timepts : array_like, optional
        Times of arrays. The run begins at the first, where it has `initial_state`; all data must
        be within. Default: the times of the data.
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
    diagram, _ = as_diagram(system)
    clock = clock_of(diagram, timepts)
    if hasattr(data, "data_vars") or hasattr(data, "columns"):
        outputs = indices_by_name(diagram.output_labels)
        not_measured = {"states"}  # of a run
        if inputs is not None:
            not_measured |= {*indices_by_name(diagram.input_labels)}
        data = data[[k for k in data if k in outputs or k not in not_measured]]
    times, measured = _measurements(data, clock)
    run = SensitivityRun(
        system,
        times,
        list(parameters),
        inputs,
        initial_state,
        params,
        clock=clock,
        rtol=rtol,
        atol=atol,
        method=method,
    )
    return FitProblem(run, measured, parameters).fit()


def _measurements(data: Any, clock: Clock) -> tuple[np.ndarray, dict[str, Labelled]]:
    """Return the times of all measurements, and the values of each name."""
    signals = labelled("data", data, clock)
    if not isinstance(signals, dict):
        raise ArgumentError(
            "data: must be an xarray.Dataset or a table with `time`, or arrays by name"
        )
    clock_times = distinct_times(clock.at) if len(clock.at) else clock.at
    for name, signal in signals.items():
        if signal.times is None:
            values = signal.values
            if values.ndim and axes_of(data[name]) is None:
                values = np.moveaxis(values, 0, -1)  # arrays have samples first
            signals[name] = signal._replace(values=values, times=clock_times)
        elif (np.diff(signal.times) <= 0).any():
            raise SimulationError(f"data['{name}']: must be at increasing times")
    times = own_times(signals)
    if not len(times):
        raise ArgumentError(
            "timepts: is required with arrays, or a table without `time`"
        )
    if not len(clock_times):
        clock.at = times
    elif not is_within(times, clock_times):
        raise SimulationError(
            f"timepts: the data are from {times[0]:.15g} to {times[-1]:.15g}. Leave it out, or "
            "give times around these"
        )
    else:  # the run begins at the first of timepts
        before = clock_times[clock_times < times[0] - rounding(clock_times)]
        times = np.concatenate([before, times])
    return checked_times("data.time", times), signals
