"""A scenario's closed loop, ready to run; call-time values go into the keys that hold them."""

from collections.abc import Callable, Mapping
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from ..blocks.localization import TRUE
from ..diagrams.interconnection import wiring_of_blocks
from ..diagrams.parts import output_ports
from ..equations.declaration import labels
from ..errors import BlockError, ScenarioError, SimulationError
from ..native.ending import Solution
from ..native.engines import chosen
from ..native.inputs import stacked_state
from ..scenario.experiment import Scenario
from ..scenario.quantities import STARTS, keys_alone, keys_of
from .dataset import columns_of, run_frame
from .frame import Frame
from .loops import paper_blocks
from .speeds import limit_of
from .starts import starting_values, state_columns, state_labels, state_of

if TYPE_CHECKING:
    import xarray

Progress = Callable[[float], None]


class ScenarioRun:
    """A scenario's closed loop, ready to run: integrate, ask its signals, make a Dataset."""

    def __init__(
        self,
        scenario: Scenario,
        params: Any = None,
        initial_state: Any = None,
        solver: Mapping[str, Any] = {},
        engine: str | None = None,
    ):
        scenario, self.left = _into_keys(scenario, params, initial_state)
        self.scenario = with_solver(scenario, solver)
        self.parts = paper_blocks(self.scenario)
        self.wiring = wiring_of_blocks(self.parts)
        self.start = state_of(self.scenario, self.parts)
        self.runner = chosen(self.wiring, self.left, engine=engine, name="the closed loop")

    @property
    def max_speed(self) -> float | None:
        """The vehicle's largest speed in this run, units.length per units.time, if it has one."""
        return limit_of(self.wiring, self.runner.sweep.given)

    def integrate(
        self, state: np.ndarray, times: np.ndarray, progress: Progress | None = None, **how: Any
    ) -> Solution:
        """Integrate from a state at the first time to the last."""
        own = self.scenario.run.solver
        return self.runner.run(state, times, **own, progress=progress, **how)

    def signals(self, solution: Solution) -> np.ndarray:
        """Return all signals, shape (ntimes, nsignals), right limits at jumps."""
        return self.runner.signals(solution)

    @property
    def labels(self) -> list[str]:
        """The labels of `signals`."""
        ports = {port: len(at) for part in self.parts for port, at in output_ports(part).items()}
        return labels(ports)

    def columns(self, port: str) -> list[int]:
        """Return the columns of a port in `signals`."""
        return [k for k, label in enumerate(self.labels) if label.partition("[")[0] == port]

    def true_position(self, signals: np.ndarray) -> np.ndarray:
        """Return x of `signals`, shape (ntimes, 2), also where the vehicle reads it with noise."""
        return signals[:, self.columns(TRUE) or self.columns("x")]

    @cached_property
    def frame(self) -> Frame:
        """The Dataset of its runs."""
        found = columns_of(self.labels, self.wiring, self.runner.sweep.given)
        return run_frame(self.scenario, found, self.left, states=state_labels(self.parts))

    def dataset(self, solution: Solution, signals: np.ndarray) -> "xarray.Dataset":
        """Return a solution and its signals with names, units and attributes."""
        return self.frame.filled(solution, signals)


def with_solver(scenario: Scenario, solver: Mapping[str, Any]) -> Scenario:
    """Return a scenario with the tolerances and the method that were asked for."""
    given = {f"run.{key}": value for key, value in solver.items() if value is not None}
    return scenario.with_values(given) if given else scenario


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
    scenario: Scenario, params: Mapping[str, Any] | None, x0: Any
) -> tuple[Scenario, dict[str, Any]]:
    """Put call-time values into the scenario where keys hold them; return it and what is left."""
    if params is not None and not isinstance(params, Mapping):
        raise BlockError(f"params = {params!r}: must be a dict, such as {{'adaptation.gain': 2.0}}")
    left = dict(params or {})
    if x0 is None and not left:
        return scenario, left
    parts = paper_blocks(scenario)
    known = {f"{block.name}.{field}" for block in parts for field in block.parameters._fields}
    alone = keys_alone(scenario, known)
    for name in [name for name in left if name in known]:
        changed = _checked(scenario, name, left[name])
        if name in alone:
            scenario = changed
            del left[name]
    if x0 is not None:
        columns = state_columns(parts)
        held = {STARTS[key]: (key, v.shape) for key, v in starting_values(scenario).items()}
        count = sum(part.nstates or 0 for part in parts)
        state = stacked_state("initial_state", x0, count, padded=False)
        given = columns.keys() & held.keys()
        scenario = scenario.with_values(
            {held[port][0]: state[columns[port]].reshape(held[port][1]) for port in given}
        )
        usual = state_of(scenario, paper_blocks(scenario))
        wrong = np.flatnonzero(state != usual)
        if len(wrong):
            raise SimulationError(
                f"initial_state: no key of a scenario holds {state_labels(parts)[wrong[0]]}, which "
                f"starts at {usual[wrong[0]]:g}; simulate closed_loop(scenario) to start it "
                "elsewhere"
            )
    return scenario, left
