"""The arguments of a diagram's run, read and checked once: arrays and options of the solver.

`request_of` reads the arguments of `simulate`, `prepare`, `sensitivity` and `run_ensemble`.  Inputs
and initial states may have labels (`labelled`).  Two samples at one time are a jump of the inputs,
as in tables of Modelica.
"""

from collections.abc import Sequence
from contextlib import AbstractContextManager
from typing import TYPE_CHECKING, Any, NamedTuple

import control
import numpy as np

from ..base.arguments import numbers, public
from ..base.errors import ArgumentError, SimulationError
from ..base.labelled import Labelled, labelled
from ..base.progress import warn
from ..engine.conformance.confirmation import drawn_around
from ..engine.diagram.wiring import Sizes
from ..engine.model.ports import check_rows, signals_by_name, vector_by_name
from ..engine.model.system import linear
from ..engine.solver.inputs import (
    Inputs,
    checked_state,
    checked_times,
    read_inputs,
    stacked,
)
from ..engine.solver.runner import RunOptions, steps_between

if TYPE_CHECKING:
    from ..paper.scenario.experiment import Scenario
    from ..paper.scenario.team import Team

Times = Sequence[float] | np.ndarray


def times_from_zero(
    experiment: "Scenario | Team", timepts: Any
) -> tuple[np.ndarray, int]:
    """Return the times of a run from t = 0, and the number of times before `timepts`."""
    run = experiment.run
    times = sample_times(run.duration, run.output_step) if timepts is None else timepts
    times = checked_times("timepts", times)
    return (times, 0) if times[0] == 0 else (np.concatenate([[0.0], times]), 1)


class Request(NamedTuple):
    """Arguments of a diagram's run as they were read; the first `skipped` times are not given.

    Of a run in discrete time, `steps` are the times asked for among `times`, None if all are.
    """

    diagram: Any
    times: np.ndarray
    skipped: int
    steps: np.ndarray | None
    inputs: Inputs
    start: np.ndarray
    options: RunOptions
    sizes: Sizes  # numbers of states and inputs that the diagram leaves open, or None
    # as they were given: times, where inputs may jump at repeated ones, initial state and inputs
    timepts: Any
    given: tuple[Any, Any]

    def drawn_around(self) -> AbstractContextManager[None]:
        """Confirm new records of functions around the numbers of this run."""
        return drawn_around(self.times, *self.given)

    def with_state(self, state: Any) -> "Request":
        """Return the run from another initial state; a mapping changes the states it names."""
        own = self.start
        state = vector_by_name("initial_state", self.diagram, "state", state, own)
        start = stacked_state("initial_state", state, len(own))
        if not np.isfinite(start).all():
            raise SimulationError(f"initial_state = {start}: must be finite")
        return self._replace(start=start)

    def with_inputs(self, inputs: Any) -> "Request":
        """Return the run with other inputs."""
        inputs = inputs_by_name(self.diagram, inputs, self.timepts)
        _, inputs = with_jumps(self.diagram, self.timepts, inputs)
        count = len(self.inputs.samples[1])
        return self._replace(inputs=read_inputs(inputs, self.times, count))


def as_diagram(system: Any) -> tuple[Any, dict[str, Any]]:
    """Return a system as a diagram, and the arguments of its run that it has itself."""
    if not isinstance(system, control.InputOutputSystem):
        from .loops import closed_loop

        system = closed_loop(system)
    if isinstance(system, control.TransferFunction):
        system = linear(system)
    loop = getattr(system, "origin", None)
    if loop is None:
        return system, {}
    from .initial_states import initial_state

    start = initial_state(system)
    return system, {**loop.scenario.run.solver, "initial_state": start}


def request_of(
    system: Any,
    timepts: Any,
    inputs: Any,
    initial_state: Any,
    multiples: bool = False,
    **options: Any,
) -> Request:
    """Read the arguments of a run: the caller's, or the diagram's own where these are None.

    A closed loop without inputs and initial state runs from t = 0.  Times in discrete time are one
    `dt` apart, or `multiples` of it.
    """
    # 1. inputs and initial state by name, and the diagram's own arguments
    diagram, own_arguments = as_diagram(system)
    loop = getattr(diagram, "origin", None)
    inputs = inputs_by_name(diagram, inputs, timepts)
    if timepts is None and isinstance(inputs, Inputs):
        timepts = np.unique(inputs.samples[0])
    own_state = own_arguments.pop("initial_state", None)
    state = vector_by_name("initial_state", diagram, "state", initial_state, own_state)
    # 2. times
    skipped, steps = 0, None
    as_given = timepts
    if timepts is not None:
        timepts, inputs = with_jumps(diagram, timepts, inputs)
    if loop is not None and (timepts is None or inputs is state is None):
        times, skipped = times_from_zero(loop.scenario, timepts)
    elif timepts is None:
        raise SimulationError("timepts: is required to simulate a diagram")
    else:
        times = timepts
    if state is None:
        state = own_state
    # 3. numbers of states and inputs
    nstates, ninputs = diagram.nstates, diagram.ninputs
    sizes: Sizes = None, None
    if nstates is None or ninputs is None:
        nstates = states_count(diagram, state)
        ninputs = inputs_count(diagram, inputs, times)
        sizes = nstates, ninputs
    # 4. arrays
    read = read_inputs(inputs, times, ninputs)
    if multiples and diagram.dt:
        steps = steps_between(times, diagram.dt)
    if steps is not None:
        times = np.interp(np.arange(steps[-1] + 1), steps, times)
    start = stacked_state("initial_state", state, nstates)
    for name, value in own_arguments.items():
        if options.get(name) is None:
            options[name] = value
    checked = RunOptions.checked(diagram.dt, times, **options)
    return Request(
        diagram,
        times,
        skipped,
        steps,
        read,
        start,
        checked,
        sizes,
        times if as_given is None else as_given,
        (state, inputs),
    )


@public
def sample_times(duration: float, step: float) -> np.ndarray:
    """Return the multiples of `step` up to `duration`, and the end.

    >>> sample_times(1.0, 0.4)
    array([0. , 0.4, 0.8, 1. ])
    """
    count = int(np.floor(duration / step * (1 + 1e-12))) + 1
    times = step * np.arange(count)
    times = times[times < duration * (1 - 1e-12)]
    return np.append(times, duration)


# --- in the forms of python-control ------------------------------------------------


def inputs_count(diagram: Any, inputs: Any, times: np.ndarray) -> int:
    """Return the number of a diagram's inputs; an open number is that of the inputs given."""
    if diagram.ninputs is not None:
        return diagram.ninputs
    if isinstance(inputs, Inputs):
        return len(inputs.samples[1])
    shape = np.shape(stacked(inputs, times))
    return shape[0] if shape and shape != times.shape else 1


def states_count(diagram: Any, state: Any) -> int:
    """Return the number of a diagram's states; an open number is that of the states given."""
    if diagram.nstates is not None:
        return diagram.nstates
    if not isinstance(state, list | tuple):
        state = [0.0 if state is None else state]
    return sum(map(np.size, state))


def with_jumps(diagram: Any, timepts: Any, inputs: Any) -> tuple[Any, Any]:
    """Return times without repetition, checked, and inputs that jump at repeated times."""
    try:
        return checked_times("timepts", timepts), inputs
    except SimulationError:
        times = np.atleast_1d(numbers("timepts", timepts))
        if times.ndim != 1 or not np.all(np.diff(times) >= 0):
            raise
    if inputs is not None:
        inputs = read_inputs(inputs, times, inputs_count(diagram, inputs, times))
    return checked_times("timepts", np.unique(times)), inputs


def stacked_state(name: str, state: Any, count: int) -> np.ndarray:
    """Return `count` states in the forms of python-control; None is zero.

    A list, ``[x0, 0]``, is a sequence of numbers and arrays; a last zero is repeated.
    """
    if state is None:
        return np.zeros(count)
    if isinstance(state, list | tuple) and not all(map(np.isscalar, state)):
        state = np.concatenate([numbers(name, value).ravel() for value in state])
    else:
        state = numbers(name, state)
        if state.shape == (count,):
            return state.copy()
        state = state.ravel() if state.ndim else state
    if 0 < np.size(state) < count and np.ndim(state) == 1:
        if state[-1] != 0:
            warn(f"{name} is too short: filled with zeros")
        state = np.pad(state, (0, count - len(state)))
    return checked_state(name, state, (count,))


# --- by name -------------------------------------------------------------------------------------


def inputs_by_name(diagram: Any, inputs: Any, timepts: Any) -> Any:
    """Return inputs with labels as rows at `timepts`, or as `Inputs` at times of their own."""
    at = numbers("timepts", getattr(timepts, "time", timepts)).ravel()
    given = labelled("inputs", inputs, at)
    if isinstance(inputs, control.TimeResponseData):
        missing = [label for label in diagram.input_labels if label not in given]
        if missing:
            raise SimulationError(
                f"inputs: the response has no signal '{missing[0]}', but {', '.join(given)}. "
                f"Give inputs by name, {{'{missing[0]}': response.outputs}}"
            )
        given = {label: given[label] for label in diagram.input_labels}
    if isinstance(given, Labelled):
        given = [given]
    if given is inputs or not isinstance(given, dict | list):
        return given
    if isinstance(given, list):
        rows = [row for value in given for row in _rows("inputs", value, at)]
        if diagram.ninputs is None:
            return _joined(rows, at)
        check_rows("inputs", rows, diagram.ninputs)
        given = dict(zip(diagram.input_labels, rows, strict=True))
    rows = [Labelled(np.array(0.0))] * len(diagram.input_labels)
    for argument, columns, value in signals_by_name("inputs", diagram, "input", given):
        signals = _rows(argument, value, at, len(columns))
        for column, row in zip(columns, signals, strict=True):
            rows[column] = row
    return _joined(rows, at)


def _rows(
    argument: str, value: Labelled, at: np.ndarray, count: int | None = None
) -> list[Labelled]:
    """Return a row, a number or samples, for each signal; one number is the value of all."""
    values, times, *_ = value
    if not values.ndim:
        values = np.full(count or 1, values)
    if count == 1 or (
        values.ndim == 1 and (times is not None or values.shape == at.shape != (count,))
    ):
        values = values.reshape(1, -1)
    elif values.ndim == 1:
        values = values[:, None]
    if count is not None:
        check_rows(argument, values, count)
    length = values.shape[-1]
    if times is None and length not in (1, len(at)):
        raise ArgumentError(
            f"{argument}: has {length} values; there are {len(at)} times"
        )
    if times is None and length == 1:
        values = values.ravel()
    return [value._replace(values=row) for row in values]


def _joined(rows: list[Labelled], at: np.ndarray) -> Any:
    """Return rows of inputs; those that have other times than `at` as `Inputs` at all times."""
    own = [row.times for row in rows if row.times is not None]
    if all(np.array_equal(times, at) for times in own):
        return [row.values if row.values.ndim else float(row.values) for row in rows]
    for times in own:
        margin = 1e-9 * max(1.0, abs(times[-1]))
        if len(at) and (at[0] < times[0] - margin or at[-1] > times[-1] + margin):
            raise SimulationError(
                f"inputs: are from {times[0]:.9g} to {times[-1]:.9g}. "
                "Give timepts within these times"
            )
    if any(row.times is None and row.values.ndim for row in rows):
        own.append(at)
    distinct = np.unique(np.concatenate(own))
    least = 1e-12 * np.abs(distinct).max()  # times that differ by rounding are equal
    distinct = distinct[np.append(True, np.diff(distinct) > least)]
    rounded = {
        id(times): distinct[np.searchsorted(distinct, times, "right") - 1]
        for times in own
    }
    jumps = [times[1:][times[1:] == times[:-1]] for times in rounded.values()]
    times = np.sort(np.append(distinct, np.unique(np.concatenate(jumps))))
    begins = np.append(times[1:] == times[:-1], False)  # of jumps
    u = np.empty((len(rows), len(times)))
    for signal, row in zip(u, rows, strict=True):
        if not row.values.ndim:
            signal[:] = row.values
            continue
        x = rounded[id(at if row.times is None else row.times)]
        signal[:] = np.interp(times, x, row.values)
        signal[begins] = np.interp(-times[begins], -x[::-1], row.values[::-1])
    return read_inputs(u, times, len(u))
