"""Many runs of one scenario that differ in numbers, not in shape.

A member is the scenario with some values changed.  Where a key's value lies in P and in the
initial state is declared (`scenario.quantities`), so members are filled in whole columns; what is
computed from values, such as frequencies from periods, is made member by member.
"""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ..diagrams.changes import UNCHANGED, Changes
from ..diagrams.interconnection import wiring_of_blocks
from ..errors import ScenarioError
from ..native import solver
from ..native.batch import Batch
from ..native.machine import LANES
from ..native.native_diagram import NativeDiagram
from ..native.schedule import Schedule, make_schedule
from ..native.sweep import Sweep
from ..native.ways import begun, finish
from ..scenario.experiment import Scenario
from ..scenario.quantities import QUANTITIES, made_of, names_held
from ..simulation.loops import changed_blocks
from ..simulation.starts import state_columns, state_of


@dataclass
class Members:
    """Parameters and initial states of m runs."""

    P: np.ndarray  # (m, nP)
    x0: np.ndarray  # (m, nstates)
    group: np.ndarray  # (m,), which of the schedules a member follows
    schedules: list[Schedule]


def check_method(scenario: Scenario) -> None:
    """Refuse a scenario that names the method of its runs."""
    if scenario.run.method != "auto":
        raise ScenarioError(
            f'run.method = "{scenario.run.method}": members begin with DOP853 and go on with '
            "Rodas5P where they are stiff; remove the key"
        )


class Ensemble:
    """One scenario, compiled, from which members are made.

    `keys` are the dotted keys of what varies.  With `lanes` eight members run at once where that
    is quicker.  `changes` are blocks of the user's own.
    """

    def __init__(
        self,
        scenario: Scenario,
        keys: Iterable[str],
        lanes: bool = True,
        changes: Changes = UNCHANGED,
    ):
        self.scenario, self.keys, self.changes = scenario, list(keys), changes
        own = ("learning.gain", f"learning.{scenario.learning.row.table}.")
        for key in self.keys:
            if changes.law is not None and key.startswith(own):
                raise ScenarioError(
                    f"vary: {key} cannot vary: it is of the scenario's law, in whose place "
                    f"{changes.law.name} is given in Python"
                )
        self.blocks = changed_blocks(scenario, changes)
        check_method(scenario)
        self.columns = state_columns(self.blocks)
        self.native = NativeDiagram(wiring_of_blocks(self.blocks))
        self.lanes = self.native.lanes(LANES) if lanes else 1
        copied = {key: self._places(key) for key in self.keys}
        self.copied = {key: places for key, places in copied.items() if places is not None}
        self.computed = [key for key, places in copied.items() if places is None]
        self.base = self.native.parameters(), state_of(scenario, self.blocks, changes.law)

    def _places(self, key: str) -> tuple[list[int], list[int]] | None:
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

    def members(self, values: Mapping[str, np.ndarray], duration: float) -> Members:
        """Make members of values, key -> array of shape (m,) + the key's shape."""
        count = len(next(iter(values.values())))
        P, x0 = np.tile(self.base[0], (count, 1)), np.tile(self.base[1], (count, 1))
        group = np.zeros(count, dtype=np.int64)
        schedules = [self.native.schedule(0.0, duration)]
        if self.computed:
            layout, known = self.native.layout, dict[tuple, int]()
            for m in range(count):
                own = {key: values[key][m] for key in self.computed}
                made = self.scenario.with_values(own)
                blocks = changed_blocks(made, self.changes)
                parameters = [block.parameters for block in blocks]
                packed = layout.packed(parameters)
                P[m, : len(packed)], x0[m] = packed, state_of(made, blocks, self.changes.law)
                sweep = Sweep(self.native.wiring, parameters)
                one = make_schedule(sweep, layout.intervals, layout.jumps, 0.0, duration)
                name = (one.edges.tobytes(), one.values.tobytes())
                if name not in known:
                    known[name] = len(schedules)
                    schedules.append(one)
                group[m] = known[name]
        for key, (in_P, in_x) in self.copied.items():
            flat = np.reshape(values[key], (count, -1))
            for columns, places in ((P, in_P), (x0, in_x)):
                for place in places:
                    columns[:, place : place + flat.shape[1]] = flat
        if schedules[0].begins:
            callee = self.native.callee()
            for m, g in enumerate(group):
                x0[m] = begun(callee, x0[m], 0.0, schedules[g], P[m])
        return Members(P, x0, group, schedules)

    def run(
        self,
        members: Members,
        times: np.ndarray,
        rtol: float = 1e-8,
        atol: float = 1e-10,
        step: float | None = None,
    ) -> "States":
        """Run members, each by itself, in the calling thread; with `step` by RK4 of that step.

        `times` increase from 0; the last is the duration that the members were made for.
        """
        lanes = self.lanes if step is None or len(members.schedules) == 1 else 1
        batch = Batch(
            self.native.callee(lanes, None, solver.DOP853 if step is None else solver.RK4),
            members.x0,
            members.P,
            np.asarray(times, dtype=float),
            members.schedules,
            members.group,
            np.inf if step is None else step,
        )
        finish(batch, (rtol, atol), self.native.implicit if step is None else None)
        return States(self.columns, batch.out, batch.status, batch.reached, batch.counts)

    def signals(
        self, members: Members, run: "States", m: int, times: np.ndarray, ports: Sequence[str]
    ) -> list[np.ndarray]:
        """Return some ports of one member at the times of its states that it reached."""
        reached, pieces = int(run.reached[m]), members.schedules[members.group[m]]
        x, found = run.states[m, :reached], np.empty((reached, self.native.nsignals))
        self.native.callee().ask(solver.SIGNALS, times[:reached], x, pieces, members.P[m], found)
        made = [(label, k) for k, label in enumerate(self._labels)]
        columns = [[k for label, k in made if label.partition("[")[0] == port] for port in ports]
        return [found[:, own] for own in columns]

    @cached_property
    def _labels(self) -> list[str]:
        nodes = self.native.wiring.nodes
        return [label for node in nodes for label in node.system.output_labels]


@dataclass(frozen=True)
class States:
    """States of m runs, and how each ended."""

    columns: dict[str, slice]  # where each state lies
    states: np.ndarray  # (m, ntimes, nstates), NaN after the last sample reached
    status: np.ndarray  # (m,), as `Status` numbers it
    reached: np.ndarray  # (m,), samples reached
    counts: np.ndarray  # (m, 4): steps, evaluations, restarts, rejected steps
