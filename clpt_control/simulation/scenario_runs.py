"""Prepared runs of a scenario and of a team."""

from collections.abc import Mapping
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from ..base.errors import SimulationError
from ..base.run_attributes import TEAM
from ..engine.diagram.interconnection import wiring_of_blocks
from ..engine.model.ports import bare_labels, split
from ..engine.solver.inputs import NO_INPUTS
from ..engine.solver.runner import RunOptions
from ..engine.solver.termination import Solution
from ..paper.blocks.localization import TRUE
from ..paper.scenario.experiment import Scenario
from ..paper.scenario.team import Team, team_to_text
from .dataset import scenario_template
from .dataset_template import STATE, STATES, DatasetTemplate, Signals
from .diagram_runs import SystemRun, state_labels
from .flows import faster_flow, speeds_of
from .initial_states import state_of
from .loop_blocks import paper_blocks
from .loops import team_blocks
from .run_cache import Key, cached_run, keep_run

if TYPE_CHECKING:
    import xarray

# signals of a vehicle with noise or a speed limit, and their equals in a vehicle without
EQUAL_PORTS = {"v_c": "v_x", TRUE: "x"}


class ScenarioRun(SystemRun):
    """The closed loop of a scenario, ready to run."""

    def __init__(self, scenario: Scenario, engine: str | None = None):
        self.scenario = scenario
        blocks = paper_blocks(scenario)
        super().__init__("the closed loop", wiring_of_blocks(blocks), None, engine)
        self.initial_state = state_of(scenario, blocks)

    @cached_property
    def template(self) -> DatasetTemplate:
        """The template of the Dataset."""
        signals = self.signals(self.labels)
        return scenario_template(
            self.scenario, signals, states=state_labels(self.wiring)
        )


class TeamRun(SystemRun):
    """The closed loop of a team; the Dataset has a dimension `vehicle`, and V is the team's."""

    def __init__(self, team: Team, engine: str | None = None):
        self.team = team
        super().__init__("the team", wiring_of_blocks(team_blocks(team)), None, engine)
        scenarios = team.members.values()
        self.initial_state = np.concatenate(
            [state_of(scenario, paper_blocks(scenario)) for scenario in scenarios]
        )

    def _signals_by_vehicle(self) -> dict[str, Signals]:
        """Return the signals of each vehicle; all vehicles have the same ports."""
        vehicles = {name: Signals({}, {}) for name in self.team.members}
        signals = self.signals(self.labels)
        for name, column in signals.column.items():
            vehicle, label = split(name)
            vehicles[vehicle].column[label] = column
        for name, parameters in signals.parameters.items():
            vehicle, block = split(name)
            vehicles[vehicle].parameters[block] = parameters
        for port, equal_port in EQUAL_PORTS.items():
            tables = [signals.column for signals in vehicles.values()]
            if not any(f"{port}[0]" in table for table in tables):
                continue
            for table in tables:
                for k in range(2):
                    table.setdefault(f"{port}[{k}]", table[f"{equal_port}[{k}]"])
        return vehicles

    def dataset(self, solution: Solution, signals: np.ndarray) -> "xarray.Dataset":
        """Return a solution as a Dataset with a dimension `vehicle`."""
        import xarray

        team = self.team
        vehicles = self._signals_by_vehicle()
        runs = [
            scenario_template(scenario, vehicles[name]).filled(solution, signals)
            for name, scenario in team.members.items()
        ]
        names = xarray.Variable(
            "vehicle", [*team.members], {"long_name": "vehicle of the team"}
        )
        data = xarray.concat(runs, names, data_vars=None, coords="minimal")
        if "flow_parameters" in data:  # all vehicles are in the same flow
            data["flow_parameters"] = runs[0].flow_parameters
        if "lyapunov" in data:
            total = data.lyapunov.sum("vehicle", keep_attrs=True)
            data["lyapunov"] = total.assign_attrs(
                long_name="V of the team, the sum over vehicles"
            )
        data.attrs = {**runs[0].attrs, TEAM: team_to_text(team)}
        del data.attrs["scenario"]
        data.attrs["message"] += self._notes_on_fast_flow(data)
        data.encoding["folder"] = str(team.first._folder)
        labels = bare_labels(state_labels(self.wiring))
        data = data.assign_coords(state=("state", labels, STATE))
        return data.assign(states=(("time", "state"), solution.x, STATES))

    def _notes_on_fast_flow(self, data: "xarray.Dataset") -> str:
        notes = ""
        for name, scenario in self.team.members.items():
            if (limit := scenario.vehicle.max_speed) is not None:
                speeds = speeds_of(data.sel(vehicle=name), limit)
                if sentence := faster_flow(speeds, scenario.units):
                    notes += f"; {name}: {sentence}"
        return notes


# --- calls of `simulate` ------------------------------------------------------------------------


def refuse_arguments(
    system: Scenario | Team, stop: Any, inputs: Any, initial_state: Any, params: Any
) -> None:
    """Raise an error for arguments of `simulate` that a scenario or a team does not have."""
    if stop is not None:
        raise SimulationError(
            "stop: is for a diagram. Simulate closed_loop(scenario) with it"
        )
    if inputs is not None:
        raise SimulationError(
            "inputs: a scenario has none. Simulate closed_loop(..., external=)"
        )
    if isinstance(system, Team) and (initial_state is not None or params):
        raise SimulationError(
            "initial_state, params: a team has its own. Change its scenarios, or simulate "
            "closed_loop(team)"
        )


def simulated(
    system: Scenario | Team,
    times: np.ndarray,
    engine: str | None,
    solver: Mapping[str, Any],
    steps: Mapping[str, Any],
) -> tuple[SystemRun, "xarray.Dataset"]:
    """Return the prepared run of a scenario or a team, and its Dataset."""
    key = _scenario_key(system, *solver.values(), engine)
    system = _with_solver(system, solver)
    run_type: Any = TeamRun if isinstance(system, Team) else ScenarioRun
    run = cached_run(key, lambda: run_type(system, engine))
    options = RunOptions.checked(0, times, **system.run.solver, **steps)
    data = run.dataset(*run.run(run.initial_state, times, NO_INPUTS, options))
    keep_run(key, run)
    return run, data


def _scenario_key(system: Scenario | Team, *options: Any) -> Key | None:
    """Return the key of a run of the package's own blocks; None if a file is read."""
    scenarios = system.members.values() if isinstance(system, Team) else [system]
    if any(scenario.field_path is not None for scenario in scenarios):
        return None
    return (id(system), *options), system


def _with_solver(system: Any, solver: Mapping[str, Any]) -> Any:
    """Return a scenario or a team with tolerances and method that are not None."""
    values = {f"run.{key}": value for key, value in solver.items() if value is not None}
    if not values:
        return system
    if isinstance(system, Scenario):
        return system.with_values(values)
    members = {
        name: scenario.with_values(values) for name, scenario in system.members.items()
    }
    return Team(members=members, edges=system.edges, coupling=system.coupling)
