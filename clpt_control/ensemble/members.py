"""Many runs of one diagram that differ in numbers, not in shape.

A member is the diagram with some values changed.  Where a key's value lies in P and in the
initial state is known, so members are filled in whole columns; what is computed from values, such
as frequencies from periods, what moves breakpoints, and inputs, is made member by member.  What
cannot be compiled runs in Python, one member after the other; so does a diagram of discrete time.
"""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property, partial
from typing import Any

import numpy as np

from ..diagrams.changes import UNCHANGED, Changes
from ..diagrams.interconnection import wiring_of_blocks
from ..errors import ScenarioError
from ..native import solver
from ..native.batch import Batch, Callee
from ..native.ending import STUCK
from ..native.machine import LANES
from ..native.native_diagram import NativeDiagram
from ..native.python_diagram import PythonDiagram
from ..native.schedule import Schedule
from ..native.ways import METHODS, begun, finish, steps
from ..scenario.experiment import Scenario
from ..scenario.quantities import QUANTITIES, made_of, names_held
from ..simulation.loops import changed_blocks
from ..simulation.starts import state_columns, state_of

Made = tuple[Sequence[Any], np.ndarray, Any]  # parameters of all blocks, start, inputs


@dataclass
class Members:
    """Parameters and initial states of m runs."""

    P: np.ndarray  # (m, nP)
    x0: np.ndarray  # (m, nstates)
    group: np.ndarray  # (m,), which of the schedules a member follows
    schedules: list[Schedule]
    own: list[tuple[PythonDiagram, Any]] = field(default_factory=list)  # with the inputs

    def schedule(self, m: int) -> Schedule:
        """Return the pieces of time of a member."""
        return self.schedules[self.group[m]]


@dataclass(frozen=True)
class States:
    """States of m runs, and how each ended."""

    columns: Mapping[str, slice]  # where each state lies
    states: np.ndarray  # (m, ntimes, nstates), NaN after the last sample reached
    status: np.ndarray  # (m,), as `Status` numbers it
    reached: np.ndarray  # (m,), samples reached
    counts: np.ndarray  # (m, 4): steps, evaluations, restarts, rejected steps


class Ensemble:
    """A diagram, ready to run, from which members are made.

    `keys` are the names of what varies.  With `lanes` eight members run at once where that is
    quicker.  `base` are P and the initial state of the diagram itself.
    """

    begin = 0.0  # time at which members begin
    inputs: Any = None  # of the diagram itself, if it has any
    native: Any  # the diagram itself, ready to run: machine code, or Python
    columns: Mapping[str, slice] = {}  # where each state lies

    def __init__(
        self, runner: PythonDiagram, keys: Iterable[str], start: np.ndarray, lanes: bool = True
    ):
        self.native, self.keys = runner, list(keys)
        self.compiled = isinstance(runner, NativeDiagram)
        self.lanes = runner.lanes(LANES) if lanes else 1
        copied = {key: self.places(key) if self.compiled else None for key in self.keys}
        self.copied = {key: places for key, places in copied.items() if places is not None}
        self.computed = [key for key, places in copied.items() if places is None]
        self.base = runner.parameters(), start

    def places(self, key: str) -> tuple[list[int], list[int]] | None:
        """Return where in P and in the initial state a value begins; None if it is computed."""
        raise NotImplementedError

    def made(self, own: Mapping[str, np.ndarray]) -> Made:
        """Return one member with some values of its own."""
        raise NotImplementedError

    def _schedule(self, runner: PythonDiagram, inputs: Any, end: float) -> Schedule:
        breaks = runner.breaks(self.begin, end)
        return runner.schedule(self.begin, end, inputs, breaks)

    def members(self, values: Mapping[str, np.ndarray], end: float) -> Members:
        """Make members of values, key -> array of shape (m,) + the key's shape."""
        count = len(next(iter(values.values())))
        P, x0 = np.tile(self.base[0], (count, 1)), np.tile(self.base[1], (count, 1))
        made = Members(P, x0, np.zeros(count, dtype=np.int64), [])
        made.schedules.append(self._schedule(self.native, self.inputs, end))
        known = dict[tuple, int]()
        for m in range(count if self.computed else 0):
            own = {key: values[key][m] for key in self.computed}
            parameters, x0[m], inputs = self.made(own)
            one = self.native.with_parameters(parameters)
            P[m] = one.parameters()
            pieces = self._schedule(one, inputs, end)
            name = (pieces.edges.tobytes(), pieces.values.tobytes())
            if name not in known:
                known[name] = len(made.schedules)
                made.schedules.append(pieces)
            made.group[m] = known[name]
            made.own.append((self.native if self.compiled else one, inputs))
        for key, (in_P, in_x) in self.copied.items():
            flat = np.reshape(values[key], (count, -1))
            for columns, places in ((P, in_P), (x0, in_x)):
                for place in places:
                    columns[:, place : place + flat.shape[1]] = flat
        if made.schedules[0].begins:
            for m in range(count):
                callee = self._asked(made, m)
                x0[m] = begun(callee, x0[m], self.begin, made.schedule(m), P[m])
        return made

    def alone(self, members: Members, m: int) -> tuple[PythonDiagram, Any]:
        """Return what runs one member by itself, and its inputs."""
        return members.own[m] if members.own else (self.native, self.inputs)

    def _asked(self, members: Members, m: int, method: int = solver.DOP853) -> Callee:
        """Return what one member by itself calls."""
        runner, inputs = self.alone(members, m)
        return runner.callee(1, inputs, method)

    def run(
        self,
        members: Members,
        times: np.ndarray,
        rtol: float = 1e-8,
        atol: float = 1e-10,
        step: float | None = None,
        method: str = "auto",
    ) -> "States":
        """Run members, each by itself, in the calling thread; with `step` by RK4 of that step.

        `times` increase from `begin`; the last is the end that the members were made for.
        """
        times, by = np.asarray(times, dtype=float), METHODS[method]
        if self.native.wiring.dt or not self.native.nstates:
            return self._iterated(members, times)
        longest = np.inf
        if step is not None:
            by, longest = solver.RK4, step
        if self.compiled:
            alone = by == solver.RODAS5P or (step is not None and len(members.schedules) > 1)
            callee = self.native.callee(1 if alone else self.lanes, None, by)
            parts = [(slice(None), callee, self.native.implicit)]
        else:
            parts = [
                (slice(m, m + 1), self._asked(members, m, by), partial(runner.implicit, inputs))
                for m, (runner, inputs) in enumerate(members.own)
            ]
        auto, found = method == "auto" and step is None, []

        def ran(some: Any, callee: Callee, implicit: Any) -> tuple[np.ndarray, ...]:
            own = members.x0[some], members.P[some]
            batch = Batch(callee, *own, times, members.schedules, members.group[some], longest)
            finish(batch, (rtol, atol), implicit if auto else None)
            return batch.results

        for part, callee, implicit in parts:
            results = ran(part, callee, implicit)
            if callee.decided and (stuck := np.flatnonzero(np.isin(results[1], STUCK))).size:
                across = self.native.unlocked()
                some = np.arange(len(members.x0))[part][stuck]
                again = ran(some, across.callee(1, None, by), across.implicit)
                for whole, own in zip(results, again, strict=True):
                    whole[stuck] = own
            found.append(results)
        return States(self.columns, *map(np.concatenate, zip(*found, strict=True)))

    def _iterated(self, members: Members, times: np.ndarray) -> "States":
        """Run members of discrete time, or without states."""
        (count, n), nt = members.x0.shape, len(times)
        x, reached = np.full((count, nt, n), np.nan), np.full(count, nt)
        x[:, 0] = members.x0
        for m in range(count if n else 0):
            callee, P = self._asked(members, m), members.P[m]
            for k, bad in steps(callee, x[m], times, members.schedule(m), P):
                if bad:
                    reached[m], x[m, k + 1 :] = k + 1, np.nan
        status = np.where(reached == nt, solver.FINISHED, solver.NOT_FINITE)
        return States(self.columns, x, status, reached, np.zeros((count, 4), dtype=np.int64))

    def signals(self, members: Members, run: "States", m: int, times: np.ndarray) -> np.ndarray:
        """Return all signals of one member, at the times of its states that it reached."""
        reached = int(run.reached[m])
        x, found = run.states[m, :reached], np.empty((reached, self.native.nsignals))
        pieces, own = members.schedule(m), members.P[m]
        self._asked(members, m).ask(solver.SIGNALS, times[:reached], x, pieces, own, found)
        return found


# --- of a scenario -------------------------------------------------------------------------------


def check_method(scenario: Scenario) -> None:
    """Refuse a scenario that names the method of its runs."""
    if scenario.run.method != "auto":
        raise ScenarioError(
            f'run.method = "{scenario.run.method}": members begin with DOP853 and go on with '
            "Rodas5P where they are stiff; remove the key"
        )


class ScenarioEnsemble(Ensemble):
    """The members of a scenario.

    `keys` are its dotted keys; `changes` are blocks of the user's own.
    """

    def __init__(
        self,
        scenario: Scenario,
        keys: Iterable[str],
        lanes: bool = True,
        changes: Changes = UNCHANGED,
    ):
        self.scenario, self.changes, keys = scenario, changes, list(keys)
        own = ("learning.gain", f"learning.{scenario.learning.row.table}.")
        for key in keys:
            if changes.law is not None and key.startswith(own):
                raise ScenarioError(
                    f"vary: {key} cannot vary: it is of the scenario's law, in whose place "
                    f"{changes.law.name} is given in Python"
                )
        self.blocks = changed_blocks(scenario, changes)
        check_method(scenario)
        self.columns = state_columns(self.blocks)
        start = state_of(scenario, self.blocks, changes.law)
        super().__init__(NativeDiagram(wiring_of_blocks(self.blocks)), keys, start, lanes)

    def places(self, key: str) -> tuple[list[int], list[int]] | None:
        """Return where in P and in the initial state a value begins; None if it is computed."""
        made = made_of(self.scenario) if self.changes.law is None else ()
        own = self.changes.names
        if key not in QUANTITIES or key in made or QUANTITIES[key].jumps:
            return None
        places = {
            f"{self.blocks[k].name}.{field}": place
            for (k, field), place in self.native.layout.slots.items()
            if self.blocks[k].name not in own
        }
        in_P = []
        for name in names_held(self.scenario, [key], places)[key]:
            if places[name].array != "P":
                raise ScenarioError(f"{key}: has too many numbers to vary")
            if places[name].offset not in in_P:
                in_P.append(places[name].offset)
        column = self.columns.get(QUANTITIES[key].state)
        in_x = [] if column is None else [column.start]
        return (in_P, in_x) if in_P or in_x else None

    def made(self, own: Mapping[str, np.ndarray]) -> Made:
        """Return one member with some values of its own."""
        scenario = self.scenario.with_values(dict(own))
        blocks = changed_blocks(scenario, self.changes)
        start = state_of(scenario, blocks, self.changes.law)
        return [block.parameters for block in blocks], start, None

    def ports(
        self, members: Members, run: "States", m: int, times: np.ndarray, ports: Sequence[str]
    ) -> list[np.ndarray]:
        """Return some ports of one member at the times of its states that it reached."""
        found = self.signals(members, run, m, times)
        made = [(label, k) for k, label in enumerate(self._labels)]
        columns = [[k for label, k in made if label.partition("[")[0] == port] for port in ports]
        return [found[:, own] for own in columns]

    @cached_property
    def _labels(self) -> list[str]:
        nodes = self.native.wiring.nodes
        return [label for node in nodes for label in node.system.output_labels]
