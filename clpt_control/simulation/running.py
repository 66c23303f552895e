"""Any system, ready to run: a scenario, a team of vehicles, a diagram of any blocks.

`ready` caches the last runs, so that a second call of the same does not wire, read and lay out
again.
"""

import os
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from functools import cached_property
from typing import TYPE_CHECKING, Any
from warnings import catch_warnings, simplefilter

import control
import numpy as np

from ..base.errors import SimulationError
from ..engine.codegen.machine import ENGINE
from ..engine.diagram.interconnection import wiring_of_blocks, with_stop
from ..engine.diagram.wiring import (
    Params,
    Part,
    Sizes,
    Wiring,
    read_anew,
    units_of,
    wiring_of,
)
from ..engine.model.ports import ports_of, split, whole_labels
from ..engine.solver.engine_choice import make_runner, run_checked
from ..engine.solver.native_diagram import NativeDiagram
from ..engine.solver.schedule import read_inputs
from ..engine.solver.termination import Solution
from ..paper.blocks.localization import TRUE
from ..paper.scenario.experiment import MOST_BYTES, Scenario
from ..paper.scenario.file import EQUATIONS, OWN_PARTS, REFERENCE, TEAM
from ..paper.scenario.team import Team, team_to_text
from .dataset import Signals, beyond_scenario_of, diagram_frame, run_frame
from .flows import faster_flow, speeds_of
from .frame import STATE, STATES, Frame
from .loops import LoopOf, paper_blocks
from .run_file import CONDITIONS, RunRecord
from .starts import stacked_state, state_columns, state_of
from .team_loops import team_blocks

if TYPE_CHECKING:
    import xarray

MOST = 16  # cached runs
COPIES = 4  # of each number of a run, at most: measured
_CACHE: dict[Any, Any] = {}


class SystemRun:
    """A system as it was read: integrate it, compute its signals, return a Dataset."""

    start: np.ndarray  # its own, for a call that gives none
    frame: Any  # the Dataset of its runs
    scenario: Any = None  # of one vehicle

    def __init__(self, name: str, wiring: Wiring, params: Any, engine: str | None):
        self.name, self.wiring, self.params = name, wiring, params
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
        """Return its signals, called by these labels."""
        return Signals({label: k for k, label in enumerate(labels)}, self.parameters)

    @cached_property
    def max_speed(self) -> float | None:
        """The largest speed of its one vehicle, units.length per units.time, if it has one."""
        return getattr(self.parameters.get("speed_limit"), "max_speed", None)

    def check_memory(self, samples: int) -> None:
        """Refuse more samples than memory should hold."""
        numbers = self.runner.nstates + self.runner.nsignals
        size = 8 * COPIES * numbers * samples
        if size > MOST_BYTES:
            raise SimulationError(
                f"timepts: {samples} samples of {numbers} states and signals would take "
                f"{size / 1e9:.3g} GB of memory; at most {MOST_BYTES / 1e9:g} are allowed: give "
                "fewer times"
            )

    def run(self, times: np.ndarray, **options: Any) -> "xarray.Dataset":
        """Run from the start; return a Dataset."""
        self.check_memory(len(times))
        solution = self.runner.run(self.start, times, **options)
        return self.dataset(solution, self.runner.signals(solution))

    def dataset(self, solution: Solution, signals: np.ndarray) -> "xarray.Dataset":
        """Return a solution and its signals with names, units and attributes."""
        return self.frame.filled(solution, signals)


class ScenarioRun(SystemRun):
    """A scenario's closed loop."""

    def __init__(self, scenario: Scenario, engine: str | None = None):
        self.scenario, parts = scenario, paper_blocks(scenario)
        super().__init__("the closed loop", wiring_of_blocks(parts), None, engine)
        self.start = state_of(scenario, parts)

    @cached_property
    def frame(self) -> Frame:
        """The Dataset of its runs."""
        signals, states = self.signals(self.labels), state_labels(self.wiring)
        return run_frame(self.scenario, signals, states=states)


class TeamRun(SystemRun):
    """A team's closed loop; its Dataset has a dimension `vehicle`, and V is the team's."""

    def __init__(self, team: Team, engine: str | None = None):
        self.team = team
        super().__init__("the team", wiring_of_blocks(team_blocks(team)), None, engine)
        members = team.members.values()
        self.start = np.concatenate(
            [state_of(one, paper_blocks(one)) for one in members]
        )

    def _vehicles(self) -> dict[str, Signals]:
        """Return each vehicle's signals; where any has a port, all have it.

        The position that a vehicle without noise reads is the true one; without a speed limit the
        velocity that is commanded is flown.
        """
        vehicles: dict[str, Signals] = {
            name: Signals({}, {}) for name in self.team.members
        }
        for kind, every in enumerate(self.signals(self.labels)):
            for name, value in every.items():
                vehicle, own = split(name)
                vehicles[vehicle][kind][own] = value
        for port, other in (("v_c", "v_x"), (TRUE, "x")):
            if any(f"{port}[0]" in one.column for one in vehicles.values()):
                for one in vehicles.values():
                    for k in range(2):
                        one.column.setdefault(
                            f"{port}[{k}]", one.column[f"{other}[{k}]"]
                        )
        return vehicles

    def dataset(self, solution: Solution, signals: np.ndarray) -> "xarray.Dataset":
        """Return a solution with a dimension `vehicle`."""
        import xarray

        team, vehicles = self.team, self._vehicles()
        runs = [
            run_frame(scenario, vehicles[name]).filled(solution, signals)
            for name, scenario in team.members.items()
        ]
        names = xarray.Variable(
            "vehicle", [*team.members], {"long_name": "vehicle of the team"}
        )
        whole = xarray.concat(runs, names, data_vars=None, coords="minimal")
        if "flow_parameters" in whole:  # one flow
            whole["flow_parameters"] = runs[0].flow_parameters
        if "lyapunov" in whole:
            total = whole.lyapunov.sum("vehicle", keep_attrs=True)
            whole["lyapunov"] = total.assign_attrs(
                long_name="V of the team, the sum over vehicles"
            )
        attributes = dict(runs[0].attrs)
        del attributes["scenario"]
        whole.attrs = {**attributes, TEAM: team_to_text(team)}
        for name, scenario in team.members.items():
            if (limit := scenario.vehicle.max_speed) is not None:
                speeds = speeds_of(whole.sel(vehicle=name), limit)
                if sentence := faster_flow(speeds, scenario.units):
                    whole.attrs["message"] += f"; {name}: {sentence}"
        whole.encoding["folder"] = str(team.first._folder)
        whole = whole.assign_coords(state=("state", state_labels(self.wiring), STATE))
        return whole.assign(states=(("time", "state"), solution.x, STATES))


class DiagramRun(SystemRun):
    """A diagram of any blocks: python-control's systems as they stand."""

    def __init__(
        self,
        diagram: control.NonlinearIOSystem,
        params: Mapping[str, Any] | None,
        sizes: tuple[int | None, int | None] = (None, None),
        engine: str | None = None,
        stop: Callable | None = None,
    ):
        read_anew(diagram)
        self.loop: LoopOf | None = getattr(diagram, "origin", None)
        self.experiment = self.loop or (getattr(diagram, "recorded", None) or {}).get(
            "experiment"
        )
        self.scenario = self.experiment and self.experiment.scenario
        wiring = wiring_of(diagram, params, sizes)
        wiring = wiring if stop is None else with_stop(wiring, stop)
        super().__init__(diagram.name, wiring, params and dict(params), engine)
        outputs, inputs, self.states = labels_of(diagram, self.wiring)
        ports = {"inputs": inputs, "outputs": outputs, "states": self.states}
        self.names = {"name": self.name, **ports}
        outputs, inputs = map(whole_labels, (outputs, inputs))
        # an input with the name of an output gets another one
        taken = ports_of(outputs)
        parts = [label.rpartition("[") for label in inputs]
        self.signal_labels = outputs + [
            "".join((f"{port}_input" if port in taken else port, *rest))
            for port, *rest in parts
        ]

    def run(
        self, times: np.ndarray, inputs: Any = None, x0: Any = None, **options: Any
    ) -> Any:
        """Run from a state at the first time to the last; the Dataset carries what repeats it."""
        self.check_memory(len(times))
        u = read_inputs(inputs, times, self.wiring.ninputs)
        state = stacked_state(
            "initial_state", 0.0 if x0 is None else x0, self.runner.nstates
        )
        if self.experiment is not None:
            self._check_first_alpha(state)
        options["inputs"] = u
        solution, blocks = run_checked(
            self.runner, self.name, state, times, self.params, **options
        )
        signals = self._signal_map @ np.vstack([blocks.T, u.along(solution.t)])
        run = self.dataset(solution, signals.T)
        conditions = {
            name: value for name, value in options.items() if name in CONDITIONS
        }
        conditions |= {"timepts": times.copy(), "initial_state": state}
        run.encoding[EQUATIONS] = RunRecord(self, solution.engine, u, conditions)
        return run

    def _check_first_alpha(self, state: np.ndarray) -> None:
        """Refuse a first alpha that is not the alpha_0 of which a law makes its readout."""
        at = state_columns(node.system for node in self.wiring.nodes)
        left = at.get(self.scenario.learning.row.error_left)
        for p in (
            self.runner.sweep.parameters if left and np.all(state[left] == 1) else ()
        ):
            if "alpha_0" in p._fields and np.any(
                state[at["alpha"]] != np.ravel(p.alpha_0)
            ):
                raise SimulationError(
                    "initial_state: alpha is not adaptation.alpha_0, of which the readout is made; "
                    "give both, or learning.parameters of the scenario"
                )

    @cached_property
    def is_unchanged(self) -> bool:
        """Whether it is no closed loop, or one that is as `closed_loop` made it."""
        loop = self.loop
        return loop is None or (not loop.external and loop.is_unchanged(self.wiring))

    @property
    def beyond_scenario(self) -> dict[str, str]:
        """Attributes of a closed loop's run: what its scenario alone does not repeat."""
        if self.loop is None:
            return {}
        outside = f"{REFERENCE}: from outside" if "zc" in self.loop.external else ""
        parts = [
            self.loop.changes.description,
            outside,
            f"{self.name}: run as a diagram",
        ]
        return {OWN_PARTS: ", ".join(filter(None, parts))}

    @cached_property
    def _signal_map(self) -> Any:
        """The matrix from all block outputs and inputs to outputs, then inputs."""
        outer = tuple({~k: 1.0} for k in range(self.wiring.ninputs))
        return self.wiring.matrix_of(self.wiring.outputs + outer)

    @cached_property
    def frame(self) -> Frame:
        """The Dataset of its runs; for a `closed_loop` it is its scenario's."""
        units, signals = signal_units(self.wiring), self.signals(self.signal_labels)
        if self.experiment is None:
            return diagram_frame(
                self.name, *map(tuple, (self.signal_labels, units, self.states))
            )
        beyond = beyond_scenario_of(self.params, self.experiment.beyond_scenario)
        ports = {
            port: units[at[0]] for port, at in ports_of(self.signal_labels).items()
        }
        return run_frame(self.experiment.scenario, signals, beyond, ports, self.states)


def state_labels(wiring: Wiring) -> list[str]:
    """Return the names of all states, as python-control calls them."""
    nodes = [(node.name.replace(".", "_"), node.system) for node in wiring.nodes]
    return [
        f"{name}_{label}" for name, system in nodes for label in system.state_labels
    ]


def labels_of(diagram: Any, wiring: Wiring) -> tuple[list[str], list[str], list[str]]:
    """Return the labels of outputs, inputs and states; its block has those that are open."""
    first = wiring.nodes[0].system
    named = first if None in (diagram.ninputs, diagram.noutputs) else diagram
    states = (first if diagram.nstates is None else diagram).state_labels
    if len(states) != wiring.nodes[-1].states.stop:
        # python-control keeps one of equal labels
        states = state_labels(wiring)
    return named.output_labels, named.input_labels, states


def signal_units(wiring: Wiring) -> list[str]:
    """Return the units of outputs, then of inputs; "" for a sum of several."""
    blocks, inputs = units_of(wiring)
    single = [
        next(iter(row)) if [*row.values()] == [1.0] else None for row in wiring.outputs
    ]
    outputs = ["" if k is None else blocks[k] if k >= 0 else inputs[~k] for k in single]
    return outputs + inputs


def compiled(diagram: Part, params: Params, sizes: Sizes = (None, None)) -> DiagramRun:
    """Return a diagram that runs as machine code; raise `Uncompiled` where it cannot."""
    with catch_warnings():
        simplefilter("ignore")  # that it runs in Python
        run = DiagramRun(diagram, params, sizes, engine="native")
    if run.runner.engine != "native":
        NativeDiagram(run.wiring, params)
    return run


@contextmanager
def ready(key: tuple[Any, Any] | None, make: Callable[[], Any]) -> Iterator[Any]:
    """Yield the cached run of a key, or a new one; meanwhile no other caller gets it.

    A `key` comes with the objects whose identities are in it, which the cache keeps alive.  Without
    a key a run is made each time, and so is one in Python, whose warning is given each time.
    """
    place = key and (key[0], os.environ.get(ENGINE))
    objects, run = _CACHE.pop(place, (None, None))
    if run is None:
        objects, run = key, make()
    yield run
    if key and run.runner.engine == "native":
        _CACHE[place] = objects, run
        for oldest in list(_CACHE)[:-MOST]:
            _CACHE.pop(oldest, None)
