"""The arguments of a diagram's run, read once: arrays, inputs and options of the solver.

`request_of` reads the arguments of `simulate`, `prepare`, `sensitivity` and `run_ensemble`.
"""

from collections.abc import Sequence
from contextlib import AbstractContextManager
from typing import TYPE_CHECKING, Any, NamedTuple

import control
import numpy as np

from ..base.arguments import public
from ..base.errors import SimulationError
from ..engine.conformance.confirmation import drawn_around
from ..engine.diagram.named_values import vector_by_name
from ..engine.diagram.wiring import Sizes
from ..engine.model.system import linear
from ..engine.solver.runner import RunOptions, steps_between
from ..engine.solver.schedule import Inputs, checked_times, read_inputs
from .run_arguments import (
    inputs_by_name,
    inputs_count,
    stacked_state,
    states_count,
    with_jumps,
)

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
    given: tuple[Any, Any]  # initial state and inputs

    def drawn_around(self) -> AbstractContextManager[None]:
        """Confirm new records of functions around the numbers of this run."""
        return drawn_around(self.times, *self.given)


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
    if timepts is None and isinstance(inputs, control.TimeResponseData):
        timepts = inputs.time
    inputs = inputs_by_name(diagram, inputs, timepts)
    own_state = own_arguments.pop("initial_state", None)
    state = vector_by_name("initial_state", diagram, "state", initial_state, own_state)
    # 2. times
    skipped, steps = 0, None
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
    given = state, inputs
    return Request(diagram, times, skipped, steps, read, start, checked, sizes, given)


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
