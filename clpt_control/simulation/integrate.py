"""Run a scenario or any diagram, exactly to every breakpoint.

A scenario gives an `xarray.Dataset` with CF attributes, from which the run can
be repeated; a diagram gives python-control's own `TimeResponseData`.
"""

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, overload

import control
import numpy as np

from ..blocks import Block
from ..diagrams.interconnection import Diagram
from ..diagrams.wiring import wiring_of
from ..errors import SimulationError
from ..native.engines import chosen
from ..native.inputs import checked_state, checked_times, read_inputs
from ..scenario.experiment import Scenario
from ..scenario.team import Team
from .scenario_run import Progress, ScenarioRun
from .speeds import note_speeds, speeds_of
from .teams import TeamRun

if TYPE_CHECKING:
    import xarray

Times = Sequence[float] | np.ndarray


@overload
def simulate(
    system: Diagram,
    timepts: Times,
    inputs: Any = None,
    initial_state: Times | float | None = None,
    params: Mapping[str, Any] | None = None,
    *,
    rtol: float | None = None,
    atol: float | None = None,
    progress: Progress | None = None,
    engine: str | None = None,
) -> control.TimeResponseData: ...
@overload
def simulate(
    system: Scenario,
    timepts: Times | None = None,
    inputs: None = None,
    initial_state: Times | None = None,
    params: Mapping[str, Any] | None = None,
    *,
    rtol: float | None = None,
    atol: float | None = None,
    progress: Progress | None = None,
    engine: str | None = None,
    law: Block | None = None,
) -> "xarray.Dataset": ...
@overload
def simulate(
    system: Team,
    timepts: Times | None = None,
    inputs: None = None,
    initial_state: None = None,
    params: None = None,
    *,
    rtol: float | None = None,
    atol: float | None = None,
    progress: Progress | None = None,
    engine: str | None = None,
) -> "xarray.Dataset": ...
@overload
def simulate(
    system: control.NonlinearIOSystem,
    timepts: Times,
    inputs: Any = None,
    initial_state: Times | float | None = None,
    params: Mapping[str, Any] | None = None,
    *,
    rtol: float | None = None,
    atol: float | None = None,
    progress: Progress | None = None,
    engine: str | None = None,
) -> control.TimeResponseData: ...
def simulate(
    system: Any,
    timepts: Times | None = None,
    inputs: Any = None,
    initial_state: Times | float | None = None,
    params: Mapping[str, Any] | None = None,
    *,
    rtol: float | None = None,
    atol: float | None = None,
    progress: Progress | None = None,
    engine: str | None = None,
    law: Block | None = None,
) -> Any:
    """Run a scenario, a team, or any diagram of blocks.

    Parameters
    ----------
    system : Scenario, Team or control.NonlinearIOSystem
        A scenario gives a Dataset, a team one with a dimension ``vehicle``, a diagram a
        TimeResponseData.
    timepts : array_like, optional
        Times of the samples, increasing; a scenario and a team have their own
        (multiples of ``run.output_step``, and the end).
    inputs : array_like or callable, optional
        For a diagram: shape (ninputs, ntimes), joined by straight lines
        between `timepts`; a number or one number per input is held; a
        callable gives the inputs at any time.
    initial_state : array_like, optional
        State at ``timepts[0]``; zero for a diagram, the scenario's own else. A team takes neither
        this nor `params`.
    params : mapping, optional
        Call-time parameters, ``{"adaptation.gain": 2.0}``.
    rtol, atol : float, optional
        Tolerances; the scenario's own, or 1e-8 and 1e-10 for a diagram.
    progress : callable, optional
        Called with the time reached.
    engine : str, optional
        ``"native"``, machine code, which gives way to ``"python"`` for what
        cannot be compiled and, unless asked for, for inputs by a function.
    law : Block, optional
        For a scenario: a law of your own in place of the scenario's.

    Returns
    -------
    xarray.Dataset or control.TimeResponseData
        Samples at the times asked for; values at a jump are right limits. Where the flow is
        faster than a vehicle with ``vehicle.max_speed``, the attribute ``message`` says so.

    Raises
    ------
    SimulationError
        If the run cannot go on (block, signal and time are named), or an
        argument is not allowed.
    BlockError
        If a call-time parameter is unknown, or has a value that no scenario may have.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> scenario = clpt.paper_scenario().with_values({"run.duration": 20})
    >>> run = clpt.simulate(scenario)
    >>> float(run.clpe[-1, 0].round(3)), run.attrs["status"]
    (0.027, 'finished')
    """
    if not isinstance(system, Scenario | Team):
        if law is not None:
            raise SimulationError("law: is for a scenario; a diagram has its law among its blocks")
        return _simulate_diagram(
            system, timepts, inputs, initial_state, params, rtol, atol, progress, engine
        )
    if inputs is not None:
        raise SimulationError("a scenario has no inputs; simulate closed_loop(..., external=)")
    run: ScenarioRun | TeamRun
    if isinstance(system, Team):
        for name, given in (("initial_state", initial_state), ("params", params), ("law", law)):
            if given is not None:
                raise SimulationError(
                    f"{name}: a team has its own; change its scenarios, or simulate team_loop(team)"
                )
        run = TeamRun(system, rtol, atol, engine)
    else:
        run = ScenarioRun(system, params, initial_state, rtol, atol, engine, law)
    wanted = run.scenario.run
    if timepts is None:
        times = sample_times(wanted.duration, wanted.output_step)
    else:
        times = checked_times("timepts", timepts)
    from_zero = times if times[0] == 0 else np.concatenate([[0.0], times])
    solution = run.integrate(run.start, from_zero, progress)
    if times[0] != 0:
        solution.t, solution.x = solution.t[1:], solution.x[1:]
    found = run.dataset(solution, run.signals(solution))
    if isinstance(run, ScenarioRun) and run.max_speed is not None:
        note_speeds(found, speeds_of(found, run.max_speed), run.scenario.units)
    return found


def sample_times(duration: float, step: float) -> np.ndarray:
    """Return the multiples of `step` up to `duration`, and the end.

    Parameters
    ----------
    duration, step : float
        In any unit of time.

    Returns
    -------
    ndarray
        Increasing from 0.

    Examples
    --------
    >>> sample_times(1.0, 0.4)
    array([0. , 0.4, 0.8, 1. ])
    """
    times = step * np.arange(int(np.floor(duration / step * (1 + 1e-12))) + 1)
    times = times[times < duration * (1 - 1e-12)]
    return np.append(times, duration)


def _simulate_diagram(
    diagram, timepts, inputs, x0, params, rtol, atol, progress, engine
) -> control.TimeResponseData:
    if not isinstance(diagram, control.InputOutputSystem):
        raise SimulationError(
            f"{diagram!r:.60}: must be a Scenario or a diagram; clpt.load_scenario('mine.toml') "
            "reads a scenario, clpt.connect(blocks) wires a diagram"
        )
    if timepts is None:
        raise SimulationError("timepts: is required to simulate a diagram")
    times = checked_times("timepts", timepts)
    wiring = wiring_of(diagram)
    given = read_inputs(inputs, times, wiring.ninputs)
    runner = chosen(wiring, params, given, engine, diagram.name)
    state = checked_state("initial_state", 0.0 if x0 is None else x0, (runner.nstates,))
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
