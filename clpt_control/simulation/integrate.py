"""Run a scenario or any diagram, exactly to every breakpoint.

A scenario gives an `xarray.Dataset` with CF attributes, from which the run can
be repeated; a diagram gives python-control's own `TimeResponseData`.
"""

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, overload

import control
import numpy as np

from ..blocks import Block
from ..blocks.localization import TRUE
from ..diagrams.interconnection import Diagram, wiring_of_blocks
from ..diagrams.wiring import wiring_of
from ..errors import BlockError, ScenarioError, SimulationError
from ..native.ending import Solution
from ..native.engines import chosen
from ..native.inputs import checked_state, checked_times, read_inputs
from ..scenario.experiment import Scenario
from ..scenario.keys import STARTS, keys_alone, keys_of
from ..scenario.team import Team
from .dataset import all_columns, run_dataset
from .loops import paper_blocks, starting_values, state_columns, state_of
from .speeds import note_speeds, speeds_of
from .teams import TeamRun

if TYPE_CHECKING:
    import xarray

Times = Sequence[float] | np.ndarray
Progress = Callable[[float], None]


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


class ScenarioRun:
    """A scenario's closed loop, ready to run: integrate, ask its signals, make a Dataset."""

    def __init__(
        self, scenario, params=None, initial_state=None, rtol=None, atol=None, engine=None, law=None
    ):
        scenario, self.left = _into_keys(scenario, params, initial_state, law)
        self.law: Block | None = law
        tolerances = {"run.rtol": rtol, "run.atol": atol}
        given = {key: value for key, value in tolerances.items() if value is not None}
        self.scenario: Scenario = scenario.with_values(given) if given else scenario
        blocks = paper_blocks(self.scenario, law)
        self.wiring, self.start = wiring_of_blocks(blocks), state_of(self.scenario, blocks, law)
        self.runner = chosen(self.wiring, self.left, None, engine, "the closed loop")

    @property
    def max_speed(self) -> float | None:
        """The vehicle's largest speed in this run, units.length per units.time, if it has one."""
        nodes = zip(self.wiring.nodes, self.runner.sweep.given, strict=True)
        return next((p.max_speed for node, p in nodes if node.name == "speed_limit"), None)

    def integrate(
        self, state: np.ndarray, times: np.ndarray, progress: Progress | None = None
    ) -> Solution:
        """Integrate from a state at the first time to the last."""
        run = self.scenario.run
        return self.runner.run(state, times, rtol=run.rtol, atol=run.atol, progress=progress)

    def signals(self, solution: Solution) -> np.ndarray:
        """Return all block outputs, shape (ntimes, nsignals), right limits at jumps."""
        return self.runner.signals(solution)

    def columns(self, port: str) -> list[int]:
        """Return the columns of a port in `signals`."""
        labels = [label for node in self.wiring.nodes for label in node.system.output_labels]
        return [k for k, label in enumerate(labels) if label.partition("[")[0] == port]

    def true_position(self, signals: np.ndarray) -> np.ndarray:
        """Return x of `signals`, shape (ntimes, 2), also where the vehicle reads it with noise."""
        return signals[:, self.columns(TRUE) or self.columns("x")]

    def dataset(self, solution: Solution, signals: np.ndarray) -> "xarray.Dataset":
        """Return a solution and its signals with names, units and attributes."""
        return run_dataset(
            self.scenario,
            all_columns(self.wiring, self.runner.sweep.given),
            signals,
            solution,
            self.left,
            self.law,
        )


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


def _checked(scenario: Scenario, name: str, value: Any) -> Scenario:
    """Return a scenario with a call-time value in its key; refuse what no scenario may have."""
    if value is None:
        raise BlockError(f"params: {name} = None: must be a number or an array")
    held = name.endswith((".gain_K", ".gain_Gamma")) and np.array_equal(value, 0.0)
    changed = scenario
    for key in () if held else keys_of(scenario, name):
        try:
            changed = scenario.with_values({key: value})
        except ScenarioError as error:
            raise BlockError(
                f"params: {name}, the scenario's {str(error).partition(': ')[2]}; simulate the "
                "diagram, closed_loop(scenario), to try what no scenario may have"
            ) from None
    return changed


def _into_keys(
    scenario: Scenario, params: Mapping[str, Any] | None, x0: Any, law: Block | None
) -> tuple[Scenario, dict[str, Any]]:
    """Put call-time values into the scenario where keys hold them; return it and what is left."""
    if params is not None and not isinstance(params, Mapping):
        raise BlockError(f"params = {params!r}: must be a dict, such as {{'adaptation.gain': 2.0}}")
    left = dict(params or {})
    if x0 is None and not left:
        return scenario, left
    blocks = paper_blocks(scenario, law)
    known = {f"{block.name}.{field}" for block in blocks for field in block.parameters._fields}
    if law is not None:  # no key holds what is in it
        known = {name for name in known if name.partition(".")[0] != law.name}
    alone = keys_alone(scenario, known)
    for name in [name for name in left if name in known]:
        changed = _checked(scenario, name, left[name])
        if name in alone:
            scenario = changed
            del left[name]
    if x0 is not None:
        columns = state_columns(blocks)
        held = {STARTS[key]: (key, v.shape) for key, v in starting_values(scenario).items()}
        state = checked_state("initial_state", x0, (max(c.stop for c in columns.values()),))
        given = columns.keys() & held.keys()
        scenario = scenario.with_values(
            {held[port][0]: state[columns[port]].reshape(held[port][1]) for port in given}
        )
        usual = state_of(scenario, paper_blocks(scenario, law), law)
        for port in columns.keys() - held.keys():
            if not np.array_equal(state[columns[port]], usual[columns[port]]):
                raise SimulationError(
                    f"initial_state: no key of a scenario holds {port}, which starts at "
                    f"{usual[columns[port]].tolist()}; simulate closed_loop(scenario) to start it "
                    "elsewhere"
                )
    return scenario, left
