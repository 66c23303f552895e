"""Run a scenario or any diagram, exactly to every breakpoint.

A scenario gives an `xarray.Dataset` with CF attributes, from which the run can
be repeated; a diagram gives python-control's own `TimeResponseData`.
"""

from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from typing import TYPE_CHECKING, Any

import control
import numpy as np

from ..diagrams.interconnection import wire
from ..diagrams.wiring import read
from ..errors import ScenarioError, SimulationError
from ..native.choice import chosen
from ..native.inputs import numbers, read_inputs
from ..scenario.experiment import Scenario
from ..scenario.keys import CALL_TIME_NAMES
from .dataset import run_dataset
from .loops import initial_state as scenario_state
from .loops import paper_blocks, started

if TYPE_CHECKING:
    import xarray


def simulate(
    system: "Scenario | control.NonlinearIOSystem",
    timepts: Sequence[float] | np.ndarray | None = None,
    inputs: Any = None,
    initial_state: Sequence[float] | np.ndarray | None = None,
    params: Mapping[str, Any] | None = None,
    *,
    rtol: float | None = None,
    atol: float | None = None,
    progress: Callable[[float], None] | None = None,
    engine: str | None = None,
) -> Any:
    """Run a scenario, or any diagram of blocks.

    Parameters
    ----------
    system : Scenario or control.NonlinearIOSystem
        A scenario gives a Dataset, a diagram a TimeResponseData.
    timepts : array_like, optional
        Times of the samples, increasing; a scenario has its own
        (multiples of ``run.output_step``, and the end).
    inputs : array_like or callable, optional
        For a diagram: shape (ninputs, ntimes), joined by straight lines
        between `timepts`; a number or one number per input is held; a
        callable gives the inputs at any time.
    initial_state : array_like, optional
        State at ``timepts[0]``; zero for a diagram, the scenario's own else.
    params : mapping, optional
        Call-time parameters, ``{"adaptation.gain": 2.0}``.
    rtol, atol : float, optional
        Tolerances; the scenario's own, or 1e-8 and 1e-10.
    progress : callable, optional
        Called with the time reached.
    engine : str, optional
        ``"native"``, machine code, which gives way to ``"python"`` for what
        cannot be compiled.

    Returns
    -------
    xarray.Dataset or control.TimeResponseData
        Samples at the times asked for; values at a jump are right limits.

    Raises
    ------
    SimulationError
        If the run cannot go on; block, signal and time are named.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> scenario = clpt.paper_scenario().with_values({"run.duration": 20})
    >>> run = clpt.simulate(scenario)
    >>> float(run.clpe[-1, 0].round(3)), run.attrs["status"]
    (0.027, 'finished')
    """
    if isinstance(system, Scenario):
        if inputs is not None:
            raise SimulationError("a scenario has no inputs; simulate closed_loop(..., external=)")
        return _simulate_scenario(
            system, timepts, initial_state, params, rtol, atol, progress, engine
        )
    return _simulate_diagram(
        system,
        timepts,
        inputs,
        initial_state,
        params,
        rtol or 1e-8,
        atol or 1e-10,
        progress,
        engine,
    )


def sample_times(duration: float, step: float) -> np.ndarray:
    """Return the multiples of `step` up to `duration`, and `duration`.

    Examples
    --------
    >>> sample_times(1.0, 0.4)
    array([0. , 0.4, 0.8, 1. ])
    """
    times = step * np.arange(int(np.floor(duration / step * (1 + 1e-12))) + 1)
    times = times[times < duration * (1 - 1e-12)]
    return np.append(times, duration)


def _checked_times(timepts: Any) -> np.ndarray:
    times = np.atleast_1d(numbers("timepts", timepts))
    if times.ndim != 1 or len(times) < 2 or not np.all(np.diff(times) > 0):
        raise SimulationError("timepts: must be at least two increasing times")
    if not np.all(np.isfinite(times)):
        raise SimulationError("timepts: must be finite")
    return times


def _checked_state(state: Any, count: int) -> np.ndarray:
    values = numbers("initial_state", state)
    if values.ndim == 0:
        values = np.full(count, float(values))
    if values.shape != (count,):
        raise SimulationError(
            f"initial_state: must have {count} numbers, one per state; it has shape {values.shape}"
        )
    return values


def _simulate_diagram(
    diagram, timepts, inputs, x0, params, rtol, atol, progress, engine
) -> control.TimeResponseData:
    if timepts is None:
        raise SimulationError("timepts: is required to simulate a diagram")
    times = _checked_times(timepts)
    for name, value in (("rtol", rtol), ("atol", atol)):
        if not numbers(name, value) >= 0.0:
            raise SimulationError(f"{name} = {value}: must be a number, 0 or more")
    wiring = read(diagram)
    given = read_inputs(inputs, times, wiring.ninputs)
    runner = chosen(wiring, params, given, engine, diagram.name)
    state = _checked_state(np.zeros(runner.nstates) if x0 is None else x0, runner.nstates)
    solution = runner.run(state, times, rtol=rtol, atol=atol, inputs=given, progress=progress)
    u = given.along(solution.t)
    outputs = wiring.output_map @ np.vstack([runner.signals(solution, given).T, u])
    return control.TimeResponseData(
        solution.t,
        outputs,
        solution.x.T,
        u,
        output_labels=diagram.output_labels,
        state_labels=diagram.state_labels,
        input_labels=diagram.input_labels,
        title=f"Response of {diagram.name}",
        sysname=diagram.name,
        issiso=False,
        success=True,
        message=solution.message,
    )


def _simulate_scenario(
    scenario, timepts, x0, params, rtol, atol, progress, engine
) -> "xarray.Dataset":
    scenario, left = said_by_keys(scenario, params, x0)
    tolerances = {"run.rtol": rtol, "run.atol": atol}
    given = {key: value for key, value in tolerances.items() if value is not None}
    scenario = scenario.with_values(given) if given else scenario
    run = scenario.run
    if timepts is None:
        times = sample_times(run.duration, run.output_step)
    else:
        times = _checked_times(timepts)
    wiring = wire(paper_blocks(scenario))
    runner = chosen(wiring, left, None, engine, "the closed loop")
    from_zero = times if times[0] == 0 else np.concatenate([[0.0], times])
    solution = runner.run(
        scenario_state(scenario), from_zero, rtol=run.rtol, atol=run.atol, progress=progress
    )
    if times[0] != 0:
        solution.t, solution.x = solution.t[1:], solution.x[1:]
    signals = runner.signals(solution)
    return run_dataset(scenario, wiring, runner.sweep.given, signals, solution, left)


def said_by_keys(
    scenario: Scenario, params: Mapping[str, Any] | None, x0: Any
) -> tuple[Scenario, dict[str, Any]]:
    """Put call-time values into the scenario, where keys hold them.

    Parameters
    ----------
    scenario : Scenario
        The experiment.
    params : mapping, optional
        Call-time parameters by qualified name.
    x0 : array_like, optional
        State at t = 0.

    Returns
    -------
    scenario : Scenario
        The experiment that is run.
    left : dict
        Parameters that no key holds.
    """
    left = dict(params or {})
    if x0 is not None:
        starts = started(scenario)
        state = _checked_state(x0, sum(start.size for start in starts.values()))
        ends = np.cumsum([start.size for start in starts.values()])
        parts = zip(starts.items(), np.split(state, ends[:-1]), strict=True)
        scenario = scenario.with_values(
            {key: part.reshape(start.shape) for (key, start), part in parts}
        )
    alone = {names[0]: key for key, names in CALL_TIME_NAMES.items() if len(names) == 1}
    for name in [name for name in left if name in alone]:
        with suppress(ScenarioError):  # a value that a scenario may not have is run all the same
            scenario = scenario.with_values({alone[name]: left[name]})
            del left[name]
    return scenario, left
