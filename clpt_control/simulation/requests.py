"""The arguments of a diagram's run, read and checked once: arrays and options of the solver.

`request_of` reads the arguments of `simulate`, `prepare`, `sensitivity` and `run_ensemble`, and
each end of the pairs of `enclose`.  Inputs and initial states may have labels (`labelled`).  Two
samples at one time are a jump of the inputs, as in tables of Modelica.
"""

from contextlib import AbstractContextManager
from copy import copy
from typing import TYPE_CHECKING, Any, NamedTuple

import control
import numpy as np

from ..base.arguments import finite, is_plain, numbers, public, vector_of
from ..base.errors import ArgumentError, SimulationError
from ..base.labelled import Clock, Labelled, is_within, labelled, own_times, rounding
from ..base.progress import warn
from ..engine.conformance.confirmation import drawn_around
from ..engine.diagram.wiring import (
    Sizes,
    check_positions,
    check_rows,
    signals_by_name,
    vector_by_name,
)
from ..engine.model.system import linear
from ..engine.solver.inputs import Inputs, checked_times, read_inputs
from ..engine.solver.runner import RunOptions, steps_between

if TYPE_CHECKING:
    from ..paper.scenario.experiment import Scenario
    from ..paper.scenario.team import Team


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
    at: np.ndarray  # times of inputs without labels, which may jump at repeated ones
    clock: Clock | None  # of inputs with labels, if there was one

    @property
    def sizes(self) -> Sizes:
        """Numbers of states and inputs, which a diagram may leave open."""
        return len(self.start), len(self.inputs.samples[1])

    def drawn_around(self) -> AbstractContextManager[None]:
        """Confirm new records of functions around the numbers of this run."""
        return drawn_around(self.times, self.start, self.inputs.samples[1])

    def with_state(self, state: Any) -> "Request":
        """Return the run from another initial state; a mapping changes the states it names."""
        count = len(self.start)
        return self._replace(start=start_of(self.diagram, state, self.start, count))

    def with_inputs(self, inputs: Any) -> "Request":
        """Return the run with other inputs, whose dates count from the same one."""
        clock = copy(self.clock)
        _, signals, _ = signals_of(self.diagram, self.at, inputs, clock)
        read = inputs_at(self.diagram, inputs, signals, self.at, self.times)
        return self._replace(inputs=read)


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
    clock: Clock | None = None,
    **options: Any,
) -> Request:
    """Read the arguments of a run: the caller's, or the diagram's own where these are None.

    A closed loop without inputs and initial state runs from t = 0.  Times in discrete time are one
    `dt` apart, or `multiples` of it.  A `clock` has the times of inputs, by default `timepts`.
    """
    # 1. the diagram's own arguments
    diagram, own_arguments = as_diagram(system)
    loop = getattr(diagram, "origin", None)
    default_state = own_arguments.pop("initial_state", None)
    # 2. times
    times, skipped, steps = timepts, 0, None
    has_clock = clock is not None
    at, signals, clock = signals_of(diagram, timepts, inputs, clock)
    if timepts is not None and not has_clock:
        times = distinct_times(at)
    if loop is not None and (timepts is None or inputs is initial_state is None):
        times, skipped = times_from_zero(loop.scenario, times)
    if times is None:
        times = own_times(signals) if isinstance(signals, dict) else at
        if not len(times):
            raise SimulationError("timepts: is required to simulate a diagram")
    if timepts is None:
        at = times
        if clock is not None:
            clock.at = times
    # 3. arrays
    read = inputs_at(diagram, inputs, signals, at, times)
    start = start_of(diagram, initial_state, default_state, diagram.nstates)
    if multiples and diagram.dt:
        steps = steps_between(times, diagram.dt)
    if steps is not None:
        times = np.interp(np.arange(steps[-1] + 1), steps, times)
    for name, value in own_arguments.items():
        if options.get(name) is None:
            options[name] = value
    checked = RunOptions.checked(diagram.dt, times, **options)
    return Request(diagram, times, skipped, steps, read, start, checked, at, clock)


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


def clock_of(diagram: Any, timepts: Any) -> Clock:
    """Return the clock of a diagram's runs at times as they were given."""
    loop = getattr(diagram, "origin", None)
    return Clock(timepts, loop and loop.scenario.units.time)


def signals_of(
    diagram: Any, timepts: Any, inputs: Any, clock: Clock | None = None
) -> tuple[np.ndarray, Any, Clock | None]:
    """Return times and inputs as a clock reads them, and the clock; arrays need none."""
    is_array = inputs is None or is_plain(inputs)
    if clock is None and is_array and is_plain(timepts):
        values = None if inputs is None else numbers("inputs", inputs)
        return np.atleast_1d(finite("timepts", timepts)), values, None
    clock = clock or clock_of(diagram, timepts)
    signals = labelled("inputs", inputs, clock)
    check_positions("inputs", inputs, diagram.input_labels)
    return clock.at, signals, clock


def distinct_times(times: np.ndarray) -> np.ndarray:
    """Return times without repetition, checked."""
    if times.ndim == 1 and len(times) > 1:
        least = (times[1:] - times[:-1]).min()
        if least > 0.0:
            return times
        times = np.unique(times) if least == 0.0 else times
    return checked_times("timepts", times)


def start_of(diagram: Any, state: Any, default: Any, count: int | None) -> np.ndarray:
    """Return the states given in any form of python-control, `default` for None, else zero.

    The number of states, None, may be open.  A last zero is repeated.
    """
    name = "initial_state"
    if state is None:
        state = 0.0 if default is None else default
    if not is_plain(state):
        state = vector_by_name(name, diagram, "state", state, default)
    state = numbers(name, state)
    if count is None:
        count = state.size
    if state.ndim:
        state = state.ravel()
        if 0 < len(state) < count:
            if state[-1] != 0:
                warn(f"{name} is too short: filled with zeros")
            state = np.pad(state, (0, count - len(state)))
    return vector_of(name, state, count)


# --- inputs by name and time ---------------------------------------------------------------------


def inputs_at(
    diagram: Any,
    inputs: Any,
    named_inputs: Any,
    clock_times: np.ndarray,
    times: np.ndarray,
) -> Inputs:
    """Return inputs, `named_inputs` as `labelled` returns them, for a run at `times`.

    Samples without times are at `clock_times`.
    """
    labels, count = diagram.input_labels, diagram.ninputs
    if isinstance(named_inputs, list):
        rows = [
            row for value in named_inputs for row in _rows("inputs", value, clock_times)
        ]
        if count is not None:
            check_rows("inputs", rows, count)
        if count != len(labels):
            return joined(rows, clock_times, times)
        named_inputs = dict(zip(labels, rows, strict=True))
    if isinstance(named_inputs, dict):
        rows = [Labelled(np.array(0.0))] * len(labels)
        signals = signals_by_name("inputs", diagram, "input", inputs, named_inputs)
        for argument, columns, signal in signals:
            own_rows = _rows(argument, signal, clock_times, len(columns))
            for column, row in zip(columns, own_rows, strict=True):
                rows[column] = row
        return joined(rows, clock_times, times)
    if count is None:
        count = (
            1
            if np.shape(named_inputs) in ((), clock_times.shape)
            else len(named_inputs)
        )
    read = read_inputs(
        named_inputs, times if named_inputs is None else clock_times, count
    )
    if len(read.samples[0]) > 1:
        _check_within(times, clock_times)
    return read


def _rows(
    argument: str, signal: Labelled, clock_times: np.ndarray, count: int | None = None
) -> list[Labelled]:
    """Return a row, a number or samples, for each signal; one number is the value of all."""
    values, times, *_ = signal
    is_number = not values.ndim
    if values.ndim < 2:
        is_row = times is not None or values.shape == clock_times.shape != (count,)
        values = values.reshape((1, -1) if is_row else (-1, 1))
    if times is None and count == 1:
        values = values.reshape(1, -1)
    if is_number:
        values = np.repeat(values, count or 1, axis=0)
    if count is not None:
        check_rows(argument, values, count)
    length = values.shape[-1]
    if values.ndim > 2 or (times is None and length not in (1, len(clock_times))):
        raise ArgumentError(
            f"{argument}: has {length} values; there are {len(clock_times)} times"
        )
    if times is None and length > 1:
        times = clock_times
    return [signal._replace(values=row, times=times) for row in values]


def _check_within(times: np.ndarray, input_times: np.ndarray) -> None:
    """Refuse times of a run outside of the inputs' own."""
    if not is_within(times, input_times):
        raise SimulationError(
            f"inputs: are from {input_times[0]:.15g} to {input_times[-1]:.15g}. "
            "Give timepts within these times"
        )


def joined(rows: list[Labelled], clock_times: np.ndarray, times: np.ndarray) -> Inputs:
    """Return rows of inputs for a run at `times`: at all of their own times, if these differ."""
    times_of_rows = [row.times for row in rows if row.times is not None]
    for row_times in times_of_rows:
        _check_within(times, row_times)
    if all(np.array_equal(row_times, clock_times) for row_times in times_of_rows):
        values = np.array(np.broadcast_arrays(*(row.values for row in rows)))
        values, clock_times = (
            (values, clock_times) if times_of_rows else (values.ravel(), times)
        )
        return read_inputs(values, clock_times, len(rows))
    t = np.unique(np.concatenate(times_of_rows))
    t = t[np.append(True, np.diff(t) > rounding(t))]
    u = np.empty((len(rows), 2, len(t)))  # before and after each time
    for (before, after), row in zip(u, rows, strict=True):
        if row.times is None:
            before[:] = after[:] = row.values
        else:
            x = t[np.searchsorted(t, row.times, "right") - 1]
            after[:] = np.interp(t, x, row.values)
            before_jumps = np.interp(-t, -x[::-1], row.values[::-1])
            before[:] = np.where(np.isin(t, x), before_jumps, after)
    jumps = (u[:, 0] != u[:, 1]).any(axis=0)
    values = np.repeat(u[:, 1], 1 + jumps, axis=1)
    values[:, np.flatnonzero(jumps) + np.arange(jumps.sum())] = u[:, 0, jumps]
    return read_inputs(values, np.repeat(t, 1 + jumps), len(rows))
