"""Run a scenario or any diagram, exactly to every breakpoint.

A run is an `xarray.Dataset`; that of a scenario has CF attributes, from which it repeats.
"""

from collections.abc import Callable, Mapping, Sequence
from functools import partial
from typing import TYPE_CHECKING, Any

import control
import numpy as np

from ..arguments import public
from ..diagrams.changes import UNCHANGED, Part, changes_of
from ..equations.block import Block
from ..errors import SimulationError
from ..native.inputs import checked_times
from ..scenario.experiment import Scenario
from ..scenario.team import Team
from .diagram_run import simulate_diagram
from .ready import ready
from .scenario_run import Progress, ScenarioRun
from .speeds import note_speeds, speeds_of
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
    law: Block | Part | None = None,
    replace: Mapping[str, Any] | None = None,
    insert: Mapping[Any, Any] | None = None,
) -> "xarray.Dataset":
    """Run a scenario, a team, or any diagram of blocks.

    Parameters
    ----------
    system : Scenario, Team or control.InputOutputSystem
        A team gives a dimension ``vehicle``.
    timepts : array_like, optional
        Times of the samples, increasing; a scenario and a team have their own
        (multiples of ``run.output_step``, and the end).
    inputs : array_like or callable, optional
        For a diagram: shape (ninputs, ntimes), joined by straight lines
        between `timepts`; a number or one number per input is held; a list
        of both, ``[u1, 0]``; a callable gives the inputs at any time.
    initial_state : array_like, optional
        State at ``timepts[0]``; zero for a diagram, the scenario's own else. A list holds numbers
        and arrays that follow each other; one that ends with 0, ``[x0, 0]``, is filled with zeros.
        A team takes neither this nor `params`.
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
        ``"auto"``, as without: DOP853, and Rodas5P from where the equations are stiff. The
        attribute ``method`` says what ran, and from when.
    max_step, first_step : float, optional
        The longest step, and the first that is tried. What happens for a short time and is not
        announced, such as a pulse of an input by a function, may lie within a step.
    law, replace, insert : optional
        For a scenario: parts of your own in its diagram, as in `closed_loop`.

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
    how = {"method": method, "max_step": max_step, "first_step": first_step}
    if not isinstance(system, Scenario | Team):
        if law is not None:
            raise SimulationError("law: is for a scenario; a diagram has its law among its blocks")
        if replace is not None or insert is not None:
            raise SimulationError(
                "replace and insert: are for a scenario; give them to closed_loop, which wires the "
                "diagram"
            )
        given: dict[str, Any] = {"rtol": rtol, "atol": atol, "progress": progress, **how}
        return simulate_diagram(
            system, timepts, inputs, initial_state, params, engine, stop, **given
        )
    if stop is not None:
        raise SimulationError("stop: is for a diagram; simulate closed_loop(scenario) with it")
    if inputs is not None:
        raise SimulationError("a scenario has no inputs; simulate closed_loop(..., external=)")
    changes = UNCHANGED
    if isinstance(system, Team):
        own = {"initial_state": initial_state, "params": params, "law": law}
        for name, one in {**own, "replace": replace, "insert": insert}.items():
            if one is not None:
                raise SimulationError(
                    f"{name}: a team has its own; change its scenarios, or simulate team_loop(team)"
                )
        made: Any = partial(TeamRun, system, rtol, atol, engine)
    else:
        changes = changes_of(law, replace, insert)
        made = partial(ScenarioRun, system, params, initial_state, rtol, atol, engine, changes)
    wanted = system.run
    if timepts is None:
        times = sample_times(wanted.duration, wanted.output_step)
    else:
        times = checked_times("timepts", timepts)
    from_zero = times if times[0] == 0 else np.concatenate([[0.0], times])
    alone = params is None and initial_state is None and changes == UNCHANGED
    with ready(_key(system, rtol, atol, engine) if alone else None, made) as run:
        solution = run.integrate(run.start, from_zero, progress, **how)
        if times[0] != 0:
            solution.t, solution.x = solution.t[1:], solution.x[1:]
        found = run.dataset(solution, run.signals(solution))
    if isinstance(run, ScenarioRun) and run.max_speed is not None:
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
