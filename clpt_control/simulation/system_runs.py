"""Prepared runs of a scenario and of a team: wired blocks, their engine and their Dataset.

A prepared run integrates its system, computes all signals, and returns them as an
`xarray.Dataset` with names, units and attributes.  Diagrams of any blocks: `diagram_runs`.
"""

from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from ..base.errors import SimulationError
from ..engine.diagram.interconnection import wiring_of_blocks
from ..engine.diagram.wiring import Wiring
from ..engine.model.ports import split, whole_labels
from ..engine.solver.engine_choice import make_runner
from ..engine.solver.termination import Solution
from ..paper.blocks.localization import TRUE
from ..paper.scenario.experiment import MOST_BYTES, Scenario
from ..paper.scenario.file import TEAM
from ..paper.scenario.team import Team, team_to_text
from .dataset import Signals, scenario_template
from .dataset_template import STATE, STATES, DatasetTemplate
from .flows import faster_flow, speeds_of
from .initial_states import state_of
from .loop_blocks import paper_blocks
from .loops import team_blocks

if TYPE_CHECKING:
    import xarray

COPIES = 4  # copies of each number in memory during a run, measured
# signals of a vehicle with noise or a speed limit, and their equals in a vehicle without
EQUAL_PORTS = {"v_c": "v_x", TRUE: "x"}


class SystemRun:
    """A wired system that is ready to run."""

    initial_state: np.ndarray  # default of a run
    template: Any  # a `DatasetTemplate`
    scenario: Any = None  # of a single vehicle

    def __init__(self, name: str, wiring: Wiring, params: Any, engine: str | None):
        self.name = name
        self.wiring = wiring
        self.params = params
        self.runner = make_runner(wiring, params, engine, name)

    @property
    def labels(self) -> list[str]:
        """The labels of all signals."""
        blocks = [node.system for node in self.wiring.nodes]
        return [
            label for block in blocks for label in whole_labels(block.output_labels)
        ]

    @property
    def parameters(self) -> dict[str, Any]:
        """The parameters of each block, by name."""
        names = [node.name for node in self.wiring.nodes]
        return dict(zip(names, self.runner.sweep.parameters, strict=True))

    def signals(self, labels: list[str]) -> Signals:
        """Return the columns of labelled signals, and the parameters of the blocks."""
        return Signals({label: k for k, label in enumerate(labels)}, self.parameters)

    @cached_property
    def max_speed(self) -> float | None:
        """The largest speed of a single vehicle, units.length per units.time, or None."""
        return getattr(self.parameters.get("speed_limit"), "max_speed", None)

    def check_memory(self, samples: int) -> None:
        """Raise `SimulationError` if the samples would not fit into memory."""
        numbers = self.runner.nstates + self.runner.nsignals
        size = 8 * COPIES * numbers * samples
        if size > MOST_BYTES:
            raise SimulationError(
                f"timepts: {samples} samples of {numbers} states and signals would take "
                f"{size / 1e9:.3g} GB of memory; at most {MOST_BYTES / 1e9:g} are allowed: give "
                "fewer times"
            )

    def run(self, times: np.ndarray, **options: Any) -> "xarray.Dataset":
        """Integrate from the default initial state; return a Dataset."""
        self.check_memory(len(times))
        solution = self.runner.run(self.initial_state, times, **options)
        return self.dataset(solution, self.runner.signals(solution))

    def dataset(self, solution: Solution, signals: np.ndarray) -> "xarray.Dataset":
        """Return a solution and its signals with names, units and attributes."""
        return self.template.filled(solution, signals)


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
        data = data.assign_coords(state=("state", state_labels(self.wiring), STATE))
        return data.assign(states=(("time", "state"), solution.x, STATES))

    def _notes_on_fast_flow(self, data: "xarray.Dataset") -> str:
        notes = ""
        for name, scenario in self.team.members.items():
            if (limit := scenario.vehicle.max_speed) is not None:
                speeds = speeds_of(data.sel(vehicle=name), limit)
                if sentence := faster_flow(speeds, scenario.units):
                    notes += f"; {name}: {sentence}"
        return notes


def state_labels(wiring: Wiring) -> list[str]:
    """Return the names of all states in python-control's form, block_state."""
    nodes = [(node.name.replace(".", "_"), node.system) for node in wiring.nodes]
    return [
        f"{name}_{label}" for name, system in nodes for label in system.state_labels
    ]
