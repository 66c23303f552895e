"""Run a scenario or any diagram, exactly to every breakpoint.

A run is an `xarray.Dataset`; that of a scenario has CF attributes, from which it repeats.
"""

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import control
import numpy as np

from ..arguments import public
from ..diagrams.changes import UNCHANGED, Part, changes_of
from ..diagrams.wiring import read_anew, wiring_of
from ..equations.block import Block
from ..equations.declaration import ports_of, whole_labels
from ..equations.linear import linear
from ..errors import SimulationError
from ..native.engines import chosen, run_as_read
from ..native.inputs import checked_times, open_sizes, read_inputs, stacked_state
from ..scenario.experiment import Scenario
from ..scenario.file import OWN_PARTS
from ..scenario.team import Team
from .dataset import columns_of, diagram_dataset, run_dataset, with_states
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
    if not isinstance(system, Scenario | Team):
        if law is not None:
            raise SimulationError("law: is for a scenario; a diagram has its law among its blocks")
        if replace is not None or insert is not None:
            raise SimulationError(
                "replace and insert: are for a scenario; give them to closed_loop, which wires the "
                "diagram"
            )
        return _simulate_diagram(
            system, timepts, inputs, initial_state, params, rtol, atol, progress, engine
        )
    if inputs is not None:
        raise SimulationError("a scenario has no inputs; simulate closed_loop(..., external=)")
    run: ScenarioRun | TeamRun
    if isinstance(system, Team):
        own = {"initial_state": initial_state, "params": params, "law": law}
        for name, given in {**own, "replace": replace, "insert": insert}.items():
            if given is not None:
                raise SimulationError(
                    f"{name}: a team has its own; change its scenarios, or simulate team_loop(team)"
                )
        run = TeamRun(system, rtol, atol, engine)
    else:
        changes = changes_of(law, replace, insert)
        run = ScenarioRun(system, params, initial_state, rtol, atol, engine, changes)
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


def _simulate_diagram(
    diagram, timepts, inputs, x0, params, rtol, atol, progress, engine
) -> "xarray.Dataset":
    if isinstance(diagram, control.TransferFunction):
        diagram = linear(diagram)
    if timepts is None:
        raise SimulationError("timepts: is required to simulate a diagram")
    times = checked_times("timepts", timepts)
    read_anew(diagram)
    wiring = wiring_of(diagram, params, open_sizes(diagram, inputs, x0, times))
    given = read_inputs(inputs, times, wiring.ninputs)
    runner = chosen(wiring, params, given, engine, diagram.name)
    state = stacked_state("initial_state", 0.0 if x0 is None else x0, runner.nstates)
    solution, runner = run_as_read(
        runner,
        diagram.name,
        state,
        times,
        params,
        rtol=rtol,
        atol=atol,
        inputs=given,
        progress=progress,
    )
    signals = np.vstack([runner.signals(solution, given).T, given.along(solution.t)])
    outside = np.arange(len(signals) - wiring.ninputs, len(signals))
    values = np.hstack([(wiring.output_map @ signals).T, signals[outside].T])
    named = wiring.nodes[0].system if None in (diagram.ninputs, diagram.noutputs) else diagram
    made, given_labels = map(whole_labels, (named.output_labels, named.input_labels))
    taken = ports_of(made)  # an input of the name of an output is told apart, all of its signals
    parts = [one.partition("[") for one in given_labels]
    labels = made + ["".join((f"{p}_input" if p in taken else p, *rest)) for p, *rest in parts]
    states = (wiring.nodes[0].system if diagram.nstates is None else diagram).state_labels
    scenario, changes = getattr(diagram, "made_of", None) or (None, UNCHANGED)
    if scenario is None:
        return diagram_dataset(diagram.name, labels, values, solution, states)
    columns, every = columns_of(labels, wiring, runner.sweep.given), ports_of(labels)
    run = run_dataset(scenario, columns, values, solution, params or {}, changes, every)
    own = [changes.in_words, f"{diagram.name}: run as a diagram"]
    run.attrs[OWN_PARTS] = ", ".join(filter(None, own))
    return with_states(run, states, solution)
