"""Run a scenario or any diagram, exactly to every breakpoint.

A run is an `xarray.Dataset`; that of a scenario has CF attributes, from which it repeats.
"""

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import control
import numpy as np

from ..base.arguments import public
from ..base.errors import SimulationError
from ..engine.diagram.wiring import Sizes
from ..engine.model.system import linear
from ..engine.solver.runner import checked_method
from ..engine.solver.schedule import checked_times, stacked
from ..paper.scenario.experiment import Scenario
from ..paper.scenario.team import Team
from .flows import note_speeds, speeds_of
from .loops import closed_loop
from .plain_data import diagram_key
from .running import DiagramRun, ScenarioRun, TeamRun, ready
from .starts import initial_state as start_of
from .starts import with_solver

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
    progress: Callable[[float], None] | None = None,
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
    inputs : array_like, optional
        For a diagram: shape (ninputs, ntimes), joined by straight lines
        between `timepts`; a number or one number per input is held; a list
        of both, ``[u1, 0]``. A function of time is a block, wired to the input.
    initial_state : array_like, optional
        State of a diagram at ``timepts[0]``, of a scenario at t = 0; without, the scenario's own at
        t = 0, and zero for a diagram that knows none. A list holds numbers and arrays that follow
        each other; one that ends with 0, ``[x0, 0]``, is filled with zeros. A scenario with this
        or `params` runs as its `closed_loop`; a team takes neither.
    params : mapping, optional
        Call-time parameters, ``{"adaptation.gain": 2.0}``.
    rtol, atol : float, optional
        Tolerances; the scenario's own, or 1e-8 and 1e-10 for a diagram.
    progress : callable, optional
        Called with the time reached.
    engine : str, optional
        ``"native"``, machine code, which gives way to ``"python"`` for what cannot be compiled; the
        attribute ``engine`` says what ran.
    stop : callable, optional
        For a diagram: ``stop(t, y, u)``, a number of its outputs y and inputs u; the run ends where
        it falls to 0. Of a truth value it ends where that is no longer true.
    method : str, optional
        ``"dop853"``, explicit, of order 8; ``"rodas5p"``, for stiff equations, of order 5; or
        ``"auto"``: DOP853, and Rodas5P from where the equations are stiff. The scenario's own, or
        ``"auto"`` for a diagram. The attribute ``method`` says what ran, and from when.
    max_step, first_step : float, optional
        The longest step, and the first that is tried. What happens for a short time and is not
        announced may lie within a step.

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
        If a call-time parameter is unknown, or has a value that its block refuses.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> scenario = clpt.paper_scenario().with_values({"run.duration": 20})
    >>> run = clpt.simulate(scenario)
    >>> float(run.clpe[-1, 0].round(3)), run.attrs["status"]
    (0.027, 'finished')
    """
    how: dict[str, Any] = {
        "rtol": rtol,
        "atol": atol,
        "method": method and checked_method(method),
    }
    limits: dict[str, Any] = {
        "max_step": max_step,
        "first_step": first_step,
        "progress": progress,
    }
    before = 0  # samples before those asked for
    if isinstance(system, Scenario | Team):
        if stop is not None:
            raise SimulationError(
                "stop: is for a diagram; simulate closed_loop(scenario) with it"
            )
        if inputs is not None:
            raise SimulationError(
                "a scenario has no inputs; simulate closed_loop(..., external=)"
            )
        timepts, before = _from_zero(system, timepts)
        if initial_state is not None or params:
            if isinstance(system, Team):
                raise SimulationError(
                    "initial_state, params: a team has its own; change its scenarios, or simulate "
                    "team_loop(team)"
                )
            system = closed_loop(system)
    if isinstance(system, Scenario | Team):
        key = _key(system, *how.values(), engine)
        system = with_solver(system, how)
        run_type: Any = TeamRun if isinstance(system, Team) else ScenarioRun
        with ready(key, lambda: run_type(system, engine)) as run:
            result = run.run(timepts, **system.run.solver, **limits)
    else:
        overrides = any(
            one is not None for one in (inputs, initial_state, stop, *how.values())
        )
        diagram, times, skipped, inputs, start, options = request_of(
            system, timepts, inputs, initial_state, **how, **limits
        )
        before += skipped
        asked = sizes_of_run(diagram, inputs, start, times), engine
        key = diagram_key(diagram, params, *asked) if stop is None else None
        with ready(key, lambda: DiagramRun(diagram, params, *asked, stop)) as run:
            result = run.run(times, inputs, start, **options)
            result.attrs |= (
                run.beyond_scenario if overrides or not run.is_unchanged else {}
            )
    result = result.isel(time=slice(before, None)) if before else result
    if run.max_speed is not None and {"commanded_velocity", "true_flow"} <= set(result):
        note_speeds(result, speeds_of(result, run.max_speed), run.scenario.units)
    return result


def _from_zero(experiment: Scenario | Team, timepts: Any) -> tuple[np.ndarray, int]:
    """Return the times of a run from t = 0, and how many of them come before `timepts`."""
    run = experiment.run
    times = sample_times(run.duration, run.output_step) if timepts is None else timepts
    times = checked_times("timepts", times)
    return (times, 0) if times[0] == 0 else (np.concatenate([[0.0], times]), 1)


def sizes_of_run(diagram: Any, inputs: Any, x0: Any, times: np.ndarray) -> Sizes:
    """Return the numbers of states and inputs of a run, where its system leaves them open."""
    states = inputs_ = None
    if diagram.nstates is None:
        parts = x0 if isinstance(x0, list | tuple) else [0.0 if x0 is None else x0]
        states = sum(np.size(part) for part in parts)
    if diagram.ninputs is None:
        shape = np.shape(np.asarray(stacked(inputs, times)))
        inputs_ = shape[0] if shape and shape != times.shape else 1
    return states, inputs_


def as_diagram(system: Any) -> tuple[Any, dict[str, Any]]:
    """Return a system as a diagram, and what it knows itself of how it is to run."""
    if isinstance(system, Scenario):
        system = closed_loop(system)
    if isinstance(system, control.TransferFunction):
        system = linear(system)
    if (loop := getattr(system, "origin", None)) is not None:
        return system, {**loop.scenario.run.solver, "initial_state": start_of(system)}
    return system, getattr(system, "recorded", None) or {}


def request_of(
    system: Any, timepts: Any, inputs: Any, initial_state: Any, **how: Any
) -> tuple[Any, np.ndarray, int, Any, Any, dict[str, Any]]:
    """Return how a system is to run: as the caller says, else as the diagram itself knows.

    These are the diagram, the times, how many of them come before the caller's own, inputs, start,
    and options of solver and steps.  A closed loop without inputs and start runs from t = 0.
    """
    diagram, known = as_diagram(system)
    loop = getattr(diagram, "origin", None)
    timepts, skipped = known.get("timepts") if timepts is None else timepts, 0
    if loop is not None and (timepts is None or inputs is initial_state is None):
        times, skipped = _from_zero(loop.scenario, timepts)
    elif timepts is None:
        raise SimulationError("timepts: is required to simulate a diagram")
    else:
        times = checked_times("timepts", timepts)
    inputs = known.get("inputs") if inputs is None else inputs
    start = known.get("initial_state") if initial_state is None else initial_state
    how = {
        k: known.get(k, one) if one is None or one is np.inf else one
        for k, one in how.items()
    }
    return diagram, times, skipped, inputs, start, how


def _key(system: Scenario | Team, *more: Any) -> tuple[Any, Any] | None:
    """Return the key of a run of the package's own blocks; None where it reads a file too."""
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
