"""Simulation of scenarios, teams and diagrams; the solver stops exactly at every breakpoint.

A run is an `xarray.Dataset`.  The Dataset of a scenario has CF attributes, from which the run can
be repeated.
"""

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any

import control
import numpy as np

from ..base.arguments import attribute_of, public
from ..base.progress import warn
from ..base.run_attributes import ARGUMENTS, BEYOND, DIAGRAM, TEAM, RunDiagram
from ..engine.solver.runner import checked_method
from ..engine.solver.solver_layout import Status
from .diagram_runs import DiagramRun
from .requests import request_of, times_from_zero
from .run_cache import cached_run, diagram_key, keep_run

if TYPE_CHECKING:
    import xarray

    from ..paper.scenario.experiment import Scenario
    from ..paper.scenario.team import Team


@public
def simulate(
    system: "Scenario | Team | control.InputOutputSystem",
    timepts: Any = None,
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
        Times of the samples, increasing, or a response with these times; a scenario and a team
        have their own (multiples of ``run.output_step``, and the end). A repeated time is a jump
        of `inputs`: ``[0, 1, 1, 2]`` takes four values of each input, before and after the jump
        at 1, and the run has three samples, that at 1 after the jump. Times of a diagram of
        discrete time are multiples of its ``dt`` apart.
    inputs : array_like, optional
        For a diagram: shape (ninputs, ntimes), joined by straight lines
        between `timepts`; a number or one number per input is held; a list
        of both, ``[u1, 0]``; by name, ``{"torque": 1.0}``, others being 0, also of xarray and
        pandas; or a `control.TimeResponseData` with signals of these names. What has times of its
        own is read at these. A function of time is a block, wired to the input.
    initial_state : array_like, optional
        State of a diagram at ``timepts[0]``, of a scenario at t = 0; without, the scenario's own at
        t = 0, and zero for a diagram that knows none. A list holds numbers and arrays that follow
        each other; one that ends with 0, ``[x0, 0]``, is filled with zeros. A mapping,
        ``{"angle": 1.0}``, has labels or ports of states. A scenario with this
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
        For a diagram: ``stop(t, y, u)`` of its outputs y and inputs u, by index or name,
        ``y[0]``, ``y.angle`` or ``y["angle"]``. If it returns a number, the run ends where the
        number falls below 0; if it returns a truth value, such as ``y.angle < 1``, where the
        value becomes false.
    method : str, optional
        ``"taylor"``, Taylor series, for small models without conditions, kinks and jumps;
        ``"auto"``: DOP853, and Rodas5P from where the equations are stiff; or another one of
        ``run.method`` in the file of `clpt init`, as ``"rodas5p"``. The scenario's own, or
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
        holds the diagram's state, for `run.clpt.state(t)`. Where the flow is faster than a vehicle
        with ``vehicle.max_speed``, the attribute ``message`` of a scenario's run says so.

    Raises
    ------
    SimulationError
        If the run cannot go on (block, signal and time are named).
    ArgumentError
        If an argument is not allowed, such as an `initial_state` of another length.
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
    timepts = attribute_of(timepts, "t", timepts)  # of a response
    solver: dict[str, Any] = {
        "rtol": rtol,
        "atol": atol,
        "method": method and checked_method(method),
    }
    unrecorded: dict[str, Any] = {
        "first_step": first_step,
        "max_step": None if max_step == np.inf else max_step,
    }
    steps = {**unrecorded, "progress": progress}
    unrecorded |= {"timepts": timepts, "engine": engine}
    skipped = 0  # samples before the caller's
    if not isinstance(system, control.InputOutputSystem):
        from .loops import closed_loop
        from .scenario_runs import refuse_arguments, simulated

        refuse_arguments(system, stop, inputs, initial_state, params)
        times, skipped = times_from_zero(system, timepts)
        if initial_state is not None or params:
            system, timepts = closed_loop(system), times

    if not isinstance(system, control.InputOutputSystem):
        run, data = simulated(system, times, engine, solver, steps)
        samples = np.size(timepts)
    else:
        request = request_of(
            system, timepts, inputs, initial_state, multiples=True, **solver, **steps
        )
        skipped += request.skipped
        arguments = request.diagram, params, request.sizes, engine
        key = diagram_key(*arguments) if stop is None else None

        def new_run() -> DiagramRun:
            with request.drawn_around():
                return DiagramRun(*arguments, stop)

        run = cached_run(key, new_run)
        data = run.dataset(*run.solve(request))
        noted = request.diagram, params, request, run.runner.block_parameters
        data.encoding[DIAGRAM] = RunDiagram(*noted)
        if run.loop is not None:
            overrides = inputs, initial_state, stop, *solver.values()
            if not run.is_unchanged or any(value is not None for value in overrides):
                data.attrs |= run.beyond_scenario
        keep_run(key, run)
        samples = len(request.at)
        if data.attrs["status"] == Status.STOPPED.label and data.sizes["time"] == 1:
            warn(
                "the run ends at its start, where `stop`, or a guard with the policy 'stop', is "
                "false or below 0: a run goes on while it is not"
            )

    if skipped:
        data = data.isel(time=slice(skipped, None))
    if samples == 2:
        data.attrs["message"] += "; two samples, for more see np.linspace"
    elif timepts is None and data.sizes["time"] == 2:
        data.attrs["message"] += "; two samples, for more set run.output_step"
    _note_arguments(data, unrecorded, {**solver, "params": params or None})
    if run.max_speed is not None and {
        "commanded_velocity",
        "true_flow",
        "reference",
    } <= set(data):
        from .flows import note_speeds, speeds_of

        note_speeds(data, speeds_of(data, run.max_speed), run.scenario.units)
    scenario = run.scenario
    if scenario is not None and scenario.learning.row.at_fixes:
        from .flows import long_interval

        if sentence := long_interval(data, scenario):
            data.attrs["message"] += f"; {sentence}"
    return data


def _note_arguments(
    run: "xarray.Dataset", repeating: Mapping[str, Any], of_scenario: Mapping[str, Any]
) -> None:
    """Note the arguments of `simulate` that the scenario and variables of a run do not have."""
    arguments = dict(repeating)
    names = run.attrs.keys()
    if names.isdisjoint({"scenario", TEAM}) or not names.isdisjoint(BEYOND):
        arguments |= {**of_scenario, "timepts": None}
    arguments = {key: value for key, value in arguments.items() if value is not None}
    if arguments:
        run.encoding[ARGUMENTS] = arguments
