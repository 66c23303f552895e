"""A scenario's closed loop, ready to run; call-time values go into the keys that hold them."""

from collections.abc import Callable, Mapping, Sequence
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from ..blocks.localization import TRUE
from ..diagrams.interconnection import wiring_of_blocks
from ..diagrams.parts import output_ports
from ..diagrams.wiring import Wiring
from ..equations.declaration import labels
from ..errors import BlockError, ScenarioError, SimulationError
from ..native.ending import Solution
from ..native.engines import chosen
from ..native.schedule import stacked_state
from ..scenario.experiment import Scenario
from ..scenario.quantities import STARTS, keys_alone, keys_of
from ..scenario.tables import Units
from .dataset import Frame, columns_of, run_frame
from .loops import paper_blocks
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


# --- how fast: |v_c| > v_max is at the limit; |F_R| > v_max faster than the vehicle, which cannot
# hold its place there.  Each sample counts until the next one. -----------------------------------


class SpeedWatch:
    """Counts time at the limit and in a faster flow, samples given in order, in parts."""

    def __init__(self, max_speed: float):
        self.max_speed = max_speed
        self.start: float | None = None
        self.held = self.faster = self.longest = 0.0  # times
        self.first: float | None = None  # when the flow was first faster
        self._since: float | None = None  # when the stretch that goes on began
        self._last: tuple[float, bool, bool] | None = None

    def add(self, times: np.ndarray, commanded: np.ndarray, flow: np.ndarray) -> None:
        """Take samples that follow those before: (n,), commanded velocity and flow (n, 2)."""
        held, faster = (np.hypot(*one.T) > self.max_speed for one in (commanded, flow))
        if self.start is None:
            self.start = float(times[0])
        if self.first is None and faster.any():
            self.first = float(times[np.argmax(faster)])
        if self._last is not None:
            before = zip(self._last, (times, held, faster), strict=True)
            times, held, faster = (np.concatenate([[one], more]) for one, more in before)
        self._last = float(times[-1]), bool(held[-1]), bool(faster[-1])
        spans, held, faster = np.diff(times), held[:-1], faster[:-1]
        self.held += float(spans[held].sum())
        self.faster += float(spans[faster].sum())
        edges = np.flatnonzero(np.diff(np.concatenate([[False], faster, [False]])))
        for begin, end in edges.reshape(-1, 2).tolist():
            began = times[begin] if begin or self._since is None else self._since
            self.longest = max(self.longest, float(times[end] - began))
            if end == len(faster):
                self._since = began
        if len(faster) and not faster[-1]:
            self._since = None

    def figures(self) -> dict[str, Any]:
        """Return the figures, ready for JSON; times in units.time, shares of the time watched."""
        whole = 0.0 if self._last is None or self.start is None else self._last[0] - self.start
        faster = None
        if self.first is not None:
            share = self.faster / whole if whole else 1.0
            faster = {"first": self.first, "longest": self.longest, "share": share}
        share = self.held / whole if whole else float(self._last is not None and self._last[1])
        return {"max_speed": self.max_speed, "share_at_limit": share, "faster_flow": faster}


def faster_flow(figures: dict[str, Any], units: Units) -> str:
    """Return a sentence where the flow was faster than the vehicle, or nothing."""
    found, time = figures["faster_flow"], units.time
    if found is None:
        return ""
    return (
        f"the flow was faster than the vehicle ({figures['max_speed']:g} {units.length}/{time}), "
        f"which cannot hold its place there: first at t = {found['first']:g} {time}, "
        f"{100 * found['share']:.3g} % of the time, at most {found['longest']:.3g} {time} long"
    )


def limit_of(wiring: Wiring, given: Sequence[Any]) -> float | None:
    """Return the vehicle's largest speed, if it has one; `given` are the blocks' parameters."""
    nodes = zip(wiring.nodes, given, strict=True)
    return next((p.max_speed for node, p in nodes if node.name == "speed_limit"), None)


def speeds_of(run: "xarray.Dataset", max_speed: float) -> dict[str, Any]:
    """Return the figures of a run at its own samples."""
    watch = SpeedWatch(max_speed)
    watch.add(run.time.values, run.commanded_velocity.values, run.true_flow.values)
    return watch.figures()


def note_speeds(run: "xarray.Dataset", figures: dict[str, Any], units: Units) -> None:
    """Put the share at the limit and, where there is one, the sentence into a run's attributes."""
    run.attrs["share_at_speed_limit"] = figures["share_at_limit"]
    sentence = faster_flow(figures, units)
    if sentence:
        run.attrs["message"] = f"{run.attrs['message']}; {sentence}"
