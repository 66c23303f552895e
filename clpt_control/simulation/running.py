"""Any system, ready to run: a scenario, a team of vehicles, a diagram of any blocks.

A second call of the same need not wire, read and lay out again: runs are kept `ready`.
"""

import os
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from functools import cached_property
from typing import TYPE_CHECKING, Any
from warnings import catch_warnings, simplefilter

import control
import numpy as np

from ..blocks.localization import TRUE
from ..diagrams.interconnection import wiring_of_blocks, with_stop
from ..diagrams.wiring import Wiring, read_anew, units_of, wiring_of
from ..equations.declaration import ports_of, split, whole_labels
from ..native.ending import Solution
from ..native.engines import VARIABLE, make_runner, run_checked
from ..native.native_diagram import NativeDiagram
from ..native.schedule import read_inputs, stacked_state
from ..scenario.experiment import Scenario
from ..scenario.file import EQUATIONS, OWN_PARTS, REFERENCE, TEAM
from ..scenario.team import Team, team_to_text
from .dataset import (
    Columns,
    Frame,
    columns_of,
    diagram_frame,
    not_held,
    run_frame,
    with_states,
)
from .flows import faster_flow, speeds_of
from .loops import LoopOf, paper_blocks, team_blocks
from .run_file import CONDITIONS, Ran
from .starts import into_keys, state_labels, state_of

if TYPE_CHECKING:
    import xarray

MOST = 16  # runs that are ready
_READY: dict[Any, Any] = {}


class SystemRun:
    """A system as it was read: integrate it, ask its signals, make a Dataset."""

    start: np.ndarray  # where no other is given
    scenario: Any = None  # of one vehicle

    def __init__(
        self, name: str, wiring: Wiring, params: Any, engine: str | None, by_function: bool = False
    ):
        self.name, self.wiring, self.params = name, wiring, params
        self.runner = make_runner(wiring, params, by_function, engine, name)

    @property
    def labels(self) -> list[str]:
        """The labels of all signals."""
        blocks = [node.system for node in self.wiring.nodes]
        return [label for block in blocks for label in whole_labels(block.output_labels)]

    def columns(self, port: str) -> list[int]:
        """Return the columns of a port in all signals."""
        return [k for k, label in enumerate(self.labels) if label.partition("[")[0] == port]

    @property
    def max_speed(self) -> float | None:
        """The largest speed of its one vehicle, units.length per units.time, if it has one."""
        blocks = zip(self.wiring.nodes, self.runner.sweep.parameters, strict=True)
        return next((p.max_speed for node, p in blocks if node.name == "speed_limit"), None)

    def run(self, times: np.ndarray, **given: Any) -> "xarray.Dataset":
        """Run from the start; return a Dataset."""
        solution = self.runner.run(self.start, times, **given)
        return self.dataset(solution, self.runner.signals(solution))

    def dataset(self, solution: Solution, signals: np.ndarray) -> "xarray.Dataset":
        """Return a solution and its signals with names, units and attributes."""
        return self.frame.filled(solution, signals)

    @property
    def frame(self) -> Frame:
        """The Dataset of its runs."""
        raise NotImplementedError


class ScenarioRun(SystemRun):
    """A scenario's closed loop; call-time values go into the keys that hold them."""

    def __init__(
        self,
        scenario: Scenario,
        engine: str | None = None,
        params: Mapping[str, Any] | None = None,
        initial_state: Any = None,
    ):
        self.scenario, left = into_keys(scenario, params, initial_state)
        self.parts = paper_blocks(self.scenario)
        super().__init__("the closed loop", wiring_of_blocks(self.parts), left, engine)
        self.start = state_of(self.scenario, self.parts)

    @cached_property
    def frame(self) -> Frame:
        """The Dataset of its runs."""
        found = columns_of(self.labels, self.wiring, self.runner.sweep.parameters)
        states = state_labels(self.parts)
        return run_frame(self.scenario, found, not_held(self.params), states=states)


class TeamRun(SystemRun):
    """A team's closed loop; its Dataset has a dimension `vehicle`, and V is the team's."""

    def __init__(self, team: Team, engine: str | None = None):
        self.team, self.parts = team, team_blocks(team)
        super().__init__("the team", wiring_of_blocks(self.parts), None, engine)
        members = team.members.values()
        self.start = np.concatenate([state_of(one, paper_blocks(one)) for one in members])

    def _vehicles(self) -> dict[str, Columns]:
        """Return where each vehicle's signals stand; what one alone lacks is as in calm.

        Without noise the true position is what is read, without a limit what is commanded flown.
        """
        found: dict[str, Columns] = {name: Columns({}, {}) for name in self.team.members}
        every_signal = columns_of(self.labels, self.wiring, self.runner.sweep.parameters)
        for kind, every in enumerate(every_signal):
            for name, value in every.items():
                vehicle, own = split(name)
                found[vehicle][kind][own] = value
        for port, other in (("v_c", "v_x"), (TRUE, "x")):
            if any(f"{port}[0]" in one.column for one in found.values()):
                for one in found.values():
                    for k in range(2):
                        one.column.setdefault(f"{port}[{k}]", one.column[f"{other}[{k}]"])
        return found

    def dataset(self, solution: Solution, signals: np.ndarray) -> "xarray.Dataset":
        """Return a solution with a dimension `vehicle`."""
        import xarray

        team, columns = self.team, self._vehicles()
        runs = [
            run_frame(scenario, columns[name]).filled(solution, signals)
            for name, scenario in team.members.items()
        ]
        names = xarray.DataArray(
            list(team.members), dims="vehicle", attrs={"long_name": "vehicle of the team"}
        )
        whole = xarray.concat(runs, names.rename("vehicle"), data_vars=None, coords="minimal")
        if "flow_parameters" in whole:  # one flow
            whole["flow_parameters"] = runs[0].flow_parameters
        if "lyapunov" in whole:
            total = whole.lyapunov.sum("vehicle", keep_attrs=True)
            whole["lyapunov"] = total.assign_attrs(long_name="V of the team, the sum over vehicles")
        attributes = dict(runs[0].attrs)
        del attributes["scenario"]
        whole.attrs = {**attributes, TEAM: team_to_text(team)}
        for name, scenario in team.members.items():
            if (limit := scenario.vehicle.max_speed) is not None:
                found = speeds_of(whole.sel(vehicle=name), limit)
                if sentence := faster_flow(found, scenario.units):
                    whole.attrs["message"] += f"; {name}: {sentence}"
        whole.encoding["folder"] = str(team.first._folder)
        return with_states(whole, state_labels(self.parts), solution)


class DiagramRun(SystemRun):
    """A diagram of any blocks: python-control's systems as they stand."""

    def __init__(
        self,
        diagram: control.NonlinearIOSystem,
        params: Mapping[str, Any] | None,
        sizes: tuple[int | None, int | None] = (None, None),
        by_function: bool = False,
        engine: str | None = None,
        stop: Callable | None = None,
    ):
        read_anew(diagram)
        self.loop: LoopOf | None = getattr(diagram, "made_of", None)
        self.of = self.loop or (getattr(diagram, "recorded", None) or {}).get("of")
        self.scenario = self.of and self.of.scenario
        wiring = wiring_of(diagram, params, sizes)
        wiring = wiring if stop is None else with_stop(wiring, stop)
        super().__init__(diagram.name, wiring, params and dict(params), engine, by_function)
        made, given, self.states = labels_of(diagram, self.wiring)
        self.called = {"name": self.name, "inputs": given, "outputs": made, "states": self.states}
        made, given = map(whole_labels, (made, given))
        taken = ports_of(made)  # an input of the name of an output is told apart, all its signals
        parts = [one.partition("[") for one in given]
        self.shown = made + [
            "".join((f"{port}_input" if port in taken else port, *rest)) for port, *rest in parts
        ]

    def run(self, times: np.ndarray, inputs: Any = None, x0: Any = None, **given: Any) -> Any:
        """Run from a state at the first time to the last; what repeats it comes with it."""
        u = read_inputs(inputs, times, self.wiring.ninputs)
        state = stacked_state("initial_state", 0.0 if x0 is None else x0, self.runner.nstates)
        given["inputs"] = u
        found, signals = run_checked(self.runner, self.name, state, times, self.params, **given)
        made = self.dataset(found, (self._shown @ np.vstack([signals.T, u.along(found.t)])).T)
        own = {"timepts": times.copy(), "initial_state": state}
        conditions = {name: value for name, value in given.items() if name in CONDITIONS}
        made.encoding[EQUATIONS] = Ran(self, found.engine, u, {**conditions, **own})
        return made

    @cached_property
    def as_made(self) -> bool:
        """Whether no scenario has to say more: of a closed loop that is as it was made."""
        loop = self.loop
        return loop is None or (not loop.external and loop.is_still(self.wiring))

    @property
    def as_diagram(self) -> dict[str, str]:
        """What the run of a closed loop says that its scenario alone does not repeat."""
        if self.loop is None:
            return {}
        outside = f"{REFERENCE}: from outside" if "zc" in self.loop.external else ""
        said = [self.loop.changes.in_words, outside, f"{self.name}: run as a diagram"]
        return {OWN_PARTS: ", ".join(filter(None, said))}

    @cached_property
    def _shown(self) -> Any:
        """What a run shows, outputs and then inputs, of all block outputs and inputs."""
        outer = tuple({~k: 1.0} for k in range(self.wiring.ninputs))
        return self.wiring.matrix_of(self.wiring.outputs + outer)

    @cached_property
    def frame(self) -> Frame:
        """The Dataset of its runs; of `closed_loop` it is its scenario's."""
        if self.of is None:
            units = units_shown(self.wiring)
            return diagram_frame(self.name, *map(tuple, (self.shown, units, self.states)))
        found = columns_of(self.shown, self.wiring, self.runner.sweep.parameters)
        said = not_held(self.params, self.of.said)
        return run_frame(self.of.scenario, found, said, ports_of(self.shown), self.states)


def labels_of(diagram: Any, wiring: Wiring) -> tuple[list[str], list[str], list[str]]:
    """Return the labels of outputs, inputs and states, also where the system leaves them open."""
    first = wiring.nodes[0].system
    named = first if None in (diagram.ninputs, diagram.noutputs) else diagram
    states = (first if diagram.nstates is None else diagram).state_labels
    if len(states) != wiring.nodes[-1].states.stop:  # python-control keeps one of equal labels
        states = [
            f"{node.name.replace('.', '_')}_{label}"
            for node in wiring.nodes
            for label in node.system.state_labels
        ]
    return named.output_labels, named.input_labels, states


def units_shown(wiring: Wiring) -> list[str]:
    """Return the units of outputs, then of inputs; of a sum of several none is known."""
    made, given = units_of(wiring)
    alone = [next(iter(row)) if [*row.values()] == [1.0] else None for row in wiring.outputs]
    own = ["" if k is None else made[k] if k >= 0 else given[~k] for k in alone]
    return own + given


def compiled(
    diagram: control.NonlinearIOSystem,
    params: Mapping[str, Any] | None,
    sizes: tuple[int | None, int | None] = (None, None),
) -> DiagramRun:
    """Return a diagram that runs as machine code; what cannot be that is `Uncompiled`."""
    with catch_warnings():
        simplefilter("ignore")  # that it runs in Python
        run = DiagramRun(diagram, params, sizes, engine="native")
    if run.runner.engine != "native":
        NativeDiagram(run.wiring, params)
    return run


@contextmanager
def ready(found: tuple[Any, Any] | None, make: Callable[[], Any]) -> Iterator[Any]:
    """Yield the run of a key, made where there is none; until it is given back it is one's own.

    `found` is a key, with the objects whose places are in it.  Without one a run is made each time,
    and so is what runs in Python, of which a warning tells each time.
    """
    key = found and (found[0], os.environ.get(VARIABLE))
    held, run = _READY.pop(key, (None, None))
    if run is None:
        held, run = found, make()
    yield run
    if found and run.runner.engine == "native":
        _READY[key] = held, run
        for oldest in list(_READY)[:-MOST]:
            _READY.pop(oldest, None)
