"""Sensitivities of a run: derivatives of its outputs by parameters and initial states.

    S' = A S + B,  A = df/dx, B = df/dp along the run;   dy/dp = C S + D

S is integrated together with the run (`codegen.directional_derivatives`), from the exact derivative
of the record.  If the run crosses a jump of a function and the jump moves with p, dy/dp has a term
for the time of crossing, which S does not have.  Therefore central differences of runs confirm S if
a function may jump; otherwise an error is raised.
"""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any, NamedTuple

import control
import numpy as np

from ..base.arguments import check_known, public
from ..base.errors import SimulationError, Uncompiled
from ..engine.codegen.diagram_record import Form
from ..engine.codegen.directional_derivatives import may_jump, value_at, with_values
from ..engine.diagram.wiring import Params
from ..engine.record.unread import Unread
from ..engine.solver.native_diagram import NativeDiagram
from ..engine.solver.runner import RunOptions
from ..engine.solver.termination import Solution
from ..paper.scenario.experiment import Scenario
from .dataset_template import diagram_template
from .diagram_runs import DiagramRun, signal_units
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


class SensitivityRun(DiagramRun):
    """A diagram with derivatives by named parameters and initial states, ready to run.

    `locations` has the location of each varied number by name, `jumping` the names of blocks that
    may jump.
    """

    complete = False  # before the values of varied numbers

    def __init__(
        self,
        system: Any,
        timepts: Any,
        to: str | Iterable[str],
        inputs: Any,
        initial_state: Any,
        params: Params,
        **solver: Any,
    ):
        request = request_of(system, timepts, inputs, initial_state, **solver)
        self.request = request
        names = [to] if isinstance(to, str) else [*to]
        try:
            with request.drawn_around():
                super().__init__(request.diagram, params, request.sizes, varied=names)
        except (Uncompiled, Unread) as error:
            raise SimulationError(
                f"{request.diagram.name}: has no known derivative: {error}"
            ) from None
        self.atol = 0.0 if self.wiring.dt else request.options.atol or RunOptions.atol

    def made_runner(self, engine: str | None, varied: Sequence[str]) -> NativeDiagram:
        """Return the diagram with derivatives by each varied number, in machine code."""
        self.locations = varied_numbers(varied, self.wiring, self.states)
        for node in self.wiring.nodes:
            if node.system.jumps_at_level:
                raise SimulationError(
                    f"{node.name}: jumps at a level, whose time varies. Compare runs of slightly "
                    "different numbers instead of `sensitivity`"
                )
        locations = self.locations.values()
        parameters = self.wiring.parameters()
        directions = tuple(location.elements(parameters) for location in locations)
        varied_blocks = {k for direction in directions for k, _, _ in direction}
        self.jumping = [
            node.name
            for k, node in enumerate(self.wiring.nodes)
            if may_jump(node.system)
            or (k in varied_blocks and node.system.breakpoints_function is not None)
        ]
        fields = {field: field for location in locations for field in location.fields}
        form = Form(directions=directions)
        return NativeDiagram(self.wiring, form=form, apart=fields)

    def leave_machine_code(self, why: str) -> None:
        """Refuse to run in Python, which has no derivatives."""
        raise SimulationError(f"{self.name}: its derivative is not known: {why}")

    @property
    def values(self) -> np.ndarray:
        """The values of the varied numbers in the system."""
        parameters = self.runner.block_parameters
        start = self.request.start
        locations = self.locations.values()
        return np.array(
            [value_at(location, parameters, start) for location in locations]
        )

    def check_alike(self) -> None:
        """Refuse a name of several numbers that differ: the run has no one value of it."""
        parameters = self.runner.block_parameters
        for name, location in self.locations.items():
            places = [location._replace(fields=(field,)) for field in location.fields]
            start = self.request.start
            numbers = {float(value_at(place, parameters, start)) for place in places}
            if len(numbers) > 1:
                raise SimulationError(
                    f"to: {name} has several values in the run, {min(numbers):.6g} to "
                    f"{max(numbers):.6g}. Name one of them by its block, as in 'BLOCK.{name}'"
                )

    def with_values(self, values: np.ndarray) -> tuple[list[Any], np.ndarray]:
        """Return the parameters of blocks and the initial state with values of varied numbers."""
        at = zip(self.locations.values(), values, strict=True)
        own = self.runner.block_parameters
        return with_values(self.wiring, own, self.request.start, at)

    def at(self, values: np.ndarray, **solver: Any) -> RunWithDerivatives:
        """Run with values of the varied numbers."""
        request = self.request
        skipped = request.skipped
        parameters, start = self.with_values(values)
        # the state, then its derivative by each number
        x = np.zeros((1 + len(self.locations), len(start)))
        x[0] = start
        for row, location in zip(x[1:], self.locations.values(), strict=True):
            row[list(location.states)] = 1.0
        options = replace(request.options, **solver)
        arguments = x.ravel(), request.times, request.inputs, options
        solution, blocks = self.run(*arguments, self.runner.with_parameters(parameters))

        # arrays of shape (nt, count, 1 + nparameters)
        blocks = blocks.reshape(len(blocks), len(x), -1)
        inputs = np.zeros((len(blocks), len(x), self.wiring.ninputs))
        inputs[:, 0] = request.inputs.along(solution.t).T
        outputs = self.wiring.outputs_of(blocks, inputs).transpose(0, 2, 1)
        states = solution.x.reshape(len(blocks), *x.shape).transpose(0, 2, 1)[skipped:]
        solution = replace(solution, t=solution.t[skipped:], x=states[..., 0])
        return RunWithDerivatives(solution, outputs[skipped:], states)

    def confirm(self, values: np.ndarray, run: RunWithDerivatives) -> None:
        """Raise `SimulationError` for derivatives that differ from differences of runs."""
        if not self.jumping:
            return
        for j, (name, value) in enumerate(zip(self.locations, values, strict=True)):
            size = abs(value) or 1.0
            if np.isinf(size):
                continue
            change = np.zeros(len(values))
            change[j] = size
            derivatives = run.signals[..., 1 + j]
            wrong, largest = self._wrong_signals(values, change, derivatives * size)
            if wrong.any():
                k = int(np.argmax(wrong))
                label = (self.output_labels + self.states)[k]
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
            above = self.at(values + h * change, **solver).signals[..., 0]
            below = self.at(values - h * change, **solver).signals[..., 0]
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
    timepts: Any,
    of: str | Sequence[str] | None = None,
    to: str | Sequence[str] = START,
    inputs: Any = None,
    initial_state: Any = None,
    params: Params = None,
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
    system_run.check_alike()
    run = system_run.at(system_run.values)
    system_run.confirm(system_run.values, run)
    data = _dataset(system_run, run)
    if of is None:
        return data
    names = [of] if isinstance(of, str) else [*of]
    check_known("of", names, [*map(str, data.data_vars)])
    return data[names]


def _dataset(system_run: SensitivityRun, run: RunWithDerivatives) -> "xarray.Dataset":
    """Return the derivatives of ports and states as a Dataset."""
    import xarray

    units = signal_units(system_run.wiring)[: len(system_run.output_labels)]
    labels = system_run.output_labels, units, system_run.states
    template = diagram_template(system_run.name, *map(tuple, labels))
    datasets = [
        template.filled(
            replace(run.solution, x=run.states[..., j]), run.outputs[..., j]
        )
        for j in range(1, 1 + len(system_run.locations))
    ]
    if "parameter" in datasets[0].variables:
        raise SimulationError(
            "parameter: is a dimension of the result. Rename it in the system"
        )
    names = xarray.Variable("parameter", [*system_run.locations])
    data = xarray.concat(datasets, names, combine_attrs="override")
    data = data.transpose(..., "parameter")
    data.attrs["title"] = f"Sensitivities of {system_run.name}"
    for name, variable in data.data_vars.items():
        variable.attrs["long_name"] = f"derivative of {name} by each parameter"
        if unit := variable.attrs.get("units"):
            variable.attrs["units"] = f"{unit} per unit of the parameter"
    return data
