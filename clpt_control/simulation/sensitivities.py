"""Sensitivities of a run: derivatives of its outputs by parameters and initial states.

    S' = A S + B,  A = df/dx, B = df/dp along the run;   dy/dp = C S + D

S is integrated together with the run (`codegen.directional_derivatives`), from the exact derivative
of the record.  If the run crosses a jump of a function and the jump moves with p, dy/dp has a term
for the time of crossing, which S does not have.  Therefore central differences of runs confirm S if
a function may jump; otherwise an error is raised.
"""

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any, NamedTuple

import control
import numpy as np

from ..base.arguments import public
from ..base.errors import SimulationError, Uncompiled
from ..engine.codegen.directional_derivatives import Directions, may_jump, put, value_at
from ..engine.record.unread import Unread
from ..engine.solver.engine_choice import run_compared
from ..engine.solver.native_diagram import NativeDiagram
from ..engine.solver.runner import RunOptions
from ..engine.solver.termination import Solution
from ..paper.scenario.experiment import Scenario
from .dataset_template import diagram_template
from .diagram_runs import compiled, signal_units
from .requests import request_of
from .sensitivity_names import START, varied_numbers

if TYPE_CHECKING:
    import xarray

STEPS = (1e-3, 1e-4, 1e-5)  # of central differences, relative
TOLERANCE = 1e-3  # of derivatives, relative to the largest
TIGHT = {"rtol": 1e-10, "atol": 1e-13}  # solver options of central differences


class RunWithDerivatives(NamedTuple):
    """Outputs and states of a run with their derivatives, of shape (nt, count, 1 + nparameters)."""

    solution: Solution
    outputs: np.ndarray
    states: np.ndarray

    @property
    def signals(self) -> np.ndarray:
        """Outputs, then states."""
        return np.concatenate([self.outputs, self.states], axis=1)


class SensitivityRun:
    """A diagram with derivatives by named parameters and initial states, ready to run.

    `varied` has the location of each varied number by name.
    """

    def __init__(
        self,
        system: Any,
        timepts: Any,
        to: str | Iterable[str],
        inputs: Any,
        initial_state: Any,
        params: Mapping[str, Any] | None,
        **solver: Any,
    ):
        request = request_of(system, timepts, inputs, initial_state, **solver)
        self.name = request.diagram.name
        self.times = request.times
        self.skipped = request.skipped
        self.options = request.options
        try:
            with request.drawn_around():
                run = compiled(request.diagram, params, request.sizes)
            self.wiring = run.wiring
            self.atol = (
                0.0 if self.wiring.dt else request.options.atol or RunOptions.atol
            )
            self.states = run.states
            self.parameters = run.runner.sweep.parameters
            self.varied = varied_numbers(to, self.wiring, self.states)
            self.runner = self._compile(params)
        except (Uncompiled, Unread) as error:
            raise SimulationError(
                f"{self.name}: has no known derivative: {error}"
            ) from None
        noutputs = len(self.wiring.outputs)
        self.labels = run.signal_labels[:noutputs]
        self.input_labels = run.signal_labels[noutputs:]
        self.units = signal_units(run.wiring)[:noutputs]
        self.inputs, self.start = request.inputs, request.start

    def _compile(self, params: Mapping[str, Any] | None) -> NativeDiagram:
        """Return the diagram with derivatives by each varied number, ready to run."""
        for node in self.wiring.nodes:
            if node.system.jumps_at_level:
                raise SimulationError(
                    f"{node.name}: jumps at a level, whose time varies. Compare runs of slightly "
                    "different numbers instead of `sensitivity`"
                )
        locations = self.varied.values()
        directions = tuple(location.elements(self.parameters) for location in locations)
        varied_blocks = {k for direction in directions for k, _, _ in direction}
        self.jumping = [  # names of blocks that may jump
            node.name
            for k, node in enumerate(self.wiring.nodes)
            if may_jump(node.system)
            or (k in varied_blocks and node.system.breakpoints_function is not None)
        ]
        fields = {field: field for location in locations for field in location.fields}
        return NativeDiagram(self.wiring, params, Directions(directions), fields)

    @property
    def values(self) -> np.ndarray:
        """The values of the varied numbers in the system."""
        locations = self.varied.values()
        return np.array([value_at(p, self.parameters, self.start) for p in locations])

    def with_values(self, values: np.ndarray) -> tuple[np.ndarray, list[Any]]:
        """Return the initial state and the parameters of blocks with values of varied numbers."""
        start = self.start.copy()
        parameters = list(self.parameters)
        for location, value in zip(self.varied.values(), values, strict=True):
            put(location, value, parameters, start)
        return start, parameters

    def run(self, values: np.ndarray, **solver: Any) -> RunWithDerivatives:
        """Run with values of the varied numbers."""
        start, parameters = self.with_values(values)
        # the state, then its derivative by each number
        x = np.zeros((1 + len(self.varied), len(start)))
        x[0] = start
        for row, location in zip(x[1:], self.varied.values(), strict=True):
            row[list(location.states)] = 1.0
        runner = self.runner.with_parameters(parameters)
        options = replace(self.options, **solver)
        given = x.ravel(), self.times, self.inputs, options
        solution, reason = run_compared(runner, *given)
        if reason:
            raise SimulationError(f"{self.name}: its derivative is not known: {reason}")

        # arrays of shape (nt, count, 1 + nparameters)
        blocks = runner.signals(solution, self.inputs)
        blocks = blocks.reshape(len(blocks), len(x), -1)
        inputs = np.zeros((len(blocks), len(x), self.wiring.ninputs))
        inputs[:, 0] = self.inputs.along(solution.t).T
        outputs = self.wiring.outputs_of(blocks, inputs).transpose(0, 2, 1)
        outputs = outputs[self.skipped :]
        states = solution.x.reshape(len(blocks), *x.shape).transpose(0, 2, 1)[
            self.skipped :
        ]
        solution = replace(solution, t=solution.t[self.skipped :], x=states[..., 0])
        return RunWithDerivatives(solution, outputs, states)

    def confirm(self, values: np.ndarray, run: RunWithDerivatives) -> None:
        """Raise `SimulationError` for derivatives that differ from differences of runs."""
        if not self.jumping:
            return
        for j, (name, value) in enumerate(zip(self.varied, values, strict=True)):
            size = abs(value) or 1.0
            if np.isinf(size):
                continue
            change = np.zeros(len(values))
            change[j] = size
            derivatives = run.signals[..., 1 + j]
            wrong, largest = self._wrong_signals(values, change, derivatives * size)
            if wrong.any():
                k = int(np.argmax(wrong))
                label = [*self.labels, *self.states][k]
                reason = (
                    f"a function jumps where the run crosses something that moves with it (look in "
                    f"{', '.join(self.jumping)}). Make the jump steep but smooth, such as "
                    "np.tanh, or fit runs of clpt.prepare by scipy.optimize.least_squares, which "
                    "needs no derivative"
                )
                if largest[k] < self.atol:
                    reason = (
                        f"runs differ by less than their errors, atol = {self.atol:g}. Give an "
                        "atol far below the sizes of the states"
                    )
                raise SimulationError(
                    f"{label}: differences of runs do not confirm its derivative by {name}, for "
                    f"{reason}"
                )

    def _wrong_signals(
        self, values: np.ndarray, change: np.ndarray, derivative: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray]:
        """Return which signals differ from central differences at every step size.

        Also return the largest difference of runs of each signal.
        """
        solver = {}
        if not self.wiring.dt:
            solver = TIGHT | {"atol": min(TIGHT["atol"], self.atol)}
        wrong = np.ones(derivative.shape, dtype=bool)
        previous_error = np.full(derivative.shape, np.inf)
        tolerance = TOLERANCE * np.abs(derivative).max(axis=0)
        largest = np.zeros(derivative.shape[1:])
        for h in STEPS:
            above = self.run(values + h * change, **solver).signals[..., 0]
            below = self.run(values - h * change, **solver).signals[..., 0]
            n = min(len(above), len(below), len(wrong))
            difference = above[:n] - below[:n]
            largest = np.maximum(largest, np.abs(difference).max(axis=0))
            error = np.abs(difference / (2.0 * h) - derivative[:n])
            # an error that decreases with the step may be that of rounding
            rounding = 10 * TIGHT["rtol"] / h * np.abs(above).max(axis=0)
            decreases = error <= 0.2 * previous_error[:n]
            wrong = wrong[:n] & (error > tolerance + rounding * decreases)
            previous_error = error
            if not wrong.any():
                break
        return np.any(wrong, axis=0), largest


@public
def sensitivity(
    system: Scenario | control.InputOutputSystem,
    timepts: Sequence[float] | np.ndarray,
    of: str | Sequence[str] | None = None,
    to: str | Sequence[str] = START,
    inputs: Any = None,
    initial_state: Any = None,
    params: Mapping[str, Any] | None = None,
    *,
    rtol: float | None = None,
    atol: float | None = None,
    method: str | None = None,
    progress: Callable[[float], None] | None = None,
) -> "xarray.Dataset":
    """Differentiate a run by parameters and by its start.

    Parameters
    ----------
    system : Scenario or control.InputOutputSystem
        A scenario, a diagram, a block or a system of python-control, of continuous or discrete
        time.
    timepts : array_like
        Times of the samples, increasing.
    of : str or sequence of str, optional
        Output ports, ``"e"``; ``"states"`` are all states. All without.
    to : str or sequence of str, optional
        Parameters by their call-time names, ``"adaptation.gain"``, of an array all elements or
        one, ``"plant.A[0,1]"``; states of the start by their labels, or ``"x0"`` for all.
    inputs, initial_state, params, rtol, atol, method, progress
        As `simulate` takes them; inputs are samples or numbers.

    Returns
    -------
    xarray.Dataset
        A variable for each port, with a last dimension ``parameter``: its derivative by each, in
        the port's unit over the parameter's.

    Raises
    ------
    SimulationError
        If a name is unknown, a derivative is not known, or the run cannot go on. Where a function
        may jump, two to six more runs by each parameter confirm the derivative, or it is refused.

    Examples
    --------
    >>> import control
    >>> import clpt_control as clpt
    >>> decay = control.nlsys(lambda t, x, u, p: [-p["k"] * x[0]], name="decay",
    ...                       inputs=0, states=["y"], outputs=["y"], params={"k": 2.0})
    >>> slopes = clpt.sensitivity(decay, [0.0, 0.5, 1.0], to=["k", "x0"], initial_state=[3.0])
    >>> slopes.y.sel(parameter="k").values[1:].round(6)  # -t x0 exp(-k t)
    array([-0.551819, -0.406006])
    """
    solver = {"rtol": rtol, "atol": atol, "method": method, "progress": progress}
    system_run = SensitivityRun(
        system, timepts, to, inputs, initial_state, params, **solver
    )
    run = system_run.run(system_run.values)
    system_run.confirm(system_run.values, run)
    data = _dataset(system_run, run)
    if of is None:
        return data
    names = [of] if isinstance(of, str) else [*of]
    for name in names:
        if name not in data.data_vars:
            variables = ", ".join(map(str, data.data_vars))
            raise SimulationError(f"of = {name!r}: must be among {variables}")
    return data[names]


def _dataset(system_run: SensitivityRun, run: RunWithDerivatives) -> "xarray.Dataset":
    """Return the derivatives of ports and states as a Dataset."""
    import xarray

    labels = system_run.labels, system_run.units, system_run.states
    template = diagram_template(system_run.name, *map(tuple, labels))
    datasets = [
        template.filled(
            replace(run.solution, x=run.states[..., j]), run.outputs[..., j]
        )
        for j in range(1, 1 + len(system_run.varied))
    ]
    if "parameter" in datasets[0].variables:
        raise SimulationError(
            "parameter: is a dimension of the result. Rename it in the system"
        )
    names = xarray.Variable("parameter", [*system_run.varied])
    data = xarray.concat(datasets, names, combine_attrs="override")
    data = data.transpose(..., "parameter")
    data.attrs["title"] = f"Sensitivities of {system_run.name}"
    for name, variable in data.data_vars.items():
        variable.attrs["long_name"] = f"derivative of {name} by each parameter"
        if unit := variable.attrs.get("units"):
            variable.attrs["units"] = f"{unit} per unit of the parameter"
    return data
