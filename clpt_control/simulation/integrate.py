"""Run a scenario or any diagram, exactly to every breakpoint.

A run is an `xarray.Dataset`; that of a scenario has CF attributes, from which it repeats.
"""

from collections.abc import Callable, Mapping, Sequence
from functools import partial
from typing import TYPE_CHECKING, Any

import control
import numpy as np

from ..arguments import public
from ..errors import SimulationError
from ..native.schedule import checked_times
from ..native.ways import checked_method
from ..scenario.experiment import Scenario
from ..scenario.team import Team
from .diagram_run import ready, simulate_diagram
from .scenario_run import Progress, ScenarioRun, note_speeds, speeds_of
from .teams import TeamRun

if TYPE_CHECKING:
    import xarray

Times = Sequence[float] | np.ndarray


@public
def simulate(
    system: Scenario | Team | control.InputOutputSystem,
    timepts: Times | None = None,
    inputs: Any = None,
    initial_state: Any = None,
    params: Mapping[str, Any] | None = None,
    *,
    rtol: float | None = None,
    atol: float | None = None,
    progress: Progress | None = None,
    engine: str | None = None,
    stop: Callable[[float, Any, Any], Any] | None = None,
    method: str | None = None,
    max_step: float = np.inf,
    first_step: float | None = None,
) -> "xarray.Dataset":
    """Run a scenario, a team, or any diagram of blocks.

    Parameters
    ----------
    system : Scenario, Team or control.InputOutputSystem
        A team gives a dimension ``vehicle``. A diagram that `closed_loop` made knows its scenario.
    timepts : array_like, optional
        Times of the samples, increasing; a scenario and a team have their own
        (multiples of ``run.output_step``, and the end).
    inputs : array_like or callable, optional
        For a diagram: shape (ninputs, ntimes), joined by straight lines
        between `timepts`; a number or one number per input is held; a list
        of both, ``[u1, 0]``; a callable gives the inputs at any time.
    initial_state : array_like, optional
        State of a diagram at ``timepts[0]``, of a scenario at t = 0; without, the scenario's own at
        t = 0, and zero for a diagram that knows none. A list holds numbers and arrays that follow
        each other; one that ends with 0, ``[x0, 0]``, is filled with zeros. A team takes neither
        this nor `params`.
    params : mapping, optional
        Call-time parameters, ``{"adaptation.gain": 2.0}``.
    rtol, atol : float, optional
        Tolerances; the scenario's own, or 1e-8 and 1e-10 for a diagram.
    progress : callable, optional
        Called with the time reached.
    engine : str, optional
        ``"native"``, machine code, which gives way to ``"python"`` for what
        cannot be compiled and, unless asked for, for inputs by a function; the attribute
        ``engine`` says what ran.
    stop : callable, optional
        For a diagram: ``stop(t, y, u)``, a number of its outputs y and inputs u; the run ends where
        it falls to 0.
    method : str, optional
        ``"dop853"``, explicit, of order 8; ``"rodas5p"``, for stiff equations, of order 5; or
        ``"auto"``: DOP853, and Rodas5P from where the equations are stiff. The scenario's own, or
        ``"auto"`` for a diagram. The attribute ``method`` says what ran, and from when.
    max_step, first_step : float, optional
        The longest step, and the first that is tried. What happens for a short time and is not
        announced, such as a pulse of an input by a function, may lie within a step.

    Returns
    -------
    xarray.Dataset
        Samples at the times asked for; values at a jump are right limits. A diagram that
        `closed_loop` made has the variables of its scenario's run, and its other signals under
        the names of their ports; any other diagram has the names of its ports alone. ``states``
        holds the diagram's state, for `state_at`. Where the flow is faster than a vehicle with
        ``vehicle.max_speed``, the attribute ``message`` of a scenario's run says so.

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
    if recorded := getattr(system, "recorded", None):  # what is not given is as it was
        timepts = recorded["timepts"] if timepts is None else timepts
        inputs = recorded["inputs"] if inputs is None else inputs
        initial_state = recorded["initial_state"] if initial_state is None else initial_state
        rtol = recorded["rtol"] if rtol is None else rtol
        atol = recorded["atol"] if atol is None else atol
        method = method or recorded["method"]
        max_step = recorded["max_step"] if max_step == np.inf else max_step
        first_step = recorded["first_step"] if first_step is None else first_step
    limits: dict[str, Any] = {"max_step": max_step, "first_step": first_step}
    solver = {"rtol": rtol, "atol": atol, "method": method and checked_method(method)}
    loop = getattr(system, "made_of", None)
    experiment = system if loop is None else loop.scenario
    if timepts is not None:
        times = checked_times("timepts", timepts)
    elif isinstance(experiment, Scenario | Team):
        times = sample_times(experiment.run.duration, experiment.run.output_step)
    else:
        raise SimulationError("timepts: is required to simulate a diagram")
    from_zero = times if times[0] == 0 else np.concatenate([[0.0], times])
    if not isinstance(system, Scenario | Team):
        given: dict[str, Any] = {**solver, **limits, "progress": progress}
        own_start = loop is not None and inputs is initial_state is None
        found = simulate_diagram(
            system,
            from_zero if own_start else times,
            inputs,
            initial_state,
            params,
            engine,
            stop,
            **given,
        )
        return found.isel(time=slice(1, None)) if own_start and times[0] != 0 else found
    if stop is not None:
        raise SimulationError("stop: is for a diagram; simulate closed_loop(scenario) with it")
    if inputs is not None:
        raise SimulationError("a scenario has no inputs; simulate closed_loop(..., external=)")
    if isinstance(system, Team):
        for name, one in {"initial_state": initial_state, "params": params}.items():
            if one is not None:
                raise SimulationError(
                    f"{name}: a team has its own; change its scenarios, or simulate team_loop(team)"
                )
        made: Any = partial(TeamRun, system, solver, engine)
    else:
        made = partial(ScenarioRun, system, params, initial_state, solver, engine)
    alone = params is initial_state is None
    key = _key(system, *solver.values(), engine) if alone else None
    with ready(key, made) as run:
        solution = run.integrate(run.start, from_zero, progress, **limits)
        if times[0] != 0:
            solution.t, solution.x = solution.t[1:], solution.x[1:]
        found = run.dataset(solution, run.signals(solution))
    if run.max_speed is not None:
        note_speeds(found, speeds_of(found, run.max_speed), run.scenario.units)
    return found


def _key(system: Scenario | Team, *more: Any) -> tuple[Any, Any] | None:
    """Return the key of a run of the package's own blocks; None where a file is read, too."""
    scenarios = system.members.values() if isinstance(system, Team) else [system]
    by_file = any(one.field_path is not None for one in scenarios)
    return None if by_file else ((id(system), *more), system)


@public
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
