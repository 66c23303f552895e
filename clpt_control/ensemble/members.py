"""Members of an ensemble: many runs of one diagram that differ in numbers, not in shapes.

A member is the diagram with some values changed.  Most values have a location in P and in the
initial state, and are written as columns for all members.  Members are made one by one if a value
changes others (frequencies follow from periods), moves breakpoints or is an input.  Diagrams that
cannot be compiled, and those in discrete time, run in Python, one member after the other.

The varied system is a `VariedScenario` or a `VariedDiagram`.  Its methods per key: `why_not`,
`check`, `location`, `one_by_one`, `key_layout`; of several, `remade`: values of these make blocks
anew (`made_with`), as functions read them as numbers.  Its method `member` makes one member.  Its
`summaries` are names and series, functions of its `batch`, and `axes` are their dimensions.  It is
pickled for workers: threads and other machines run and summarise members in the same way.
"""

import hashlib
import pickle
import threading
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from dataclasses import field as made_by
from functools import cached_property, lru_cache
from typing import Any

import numpy as np

from ..base.errors import DiagramError, SimulationError
from ..base.run_attributes import versions
from ..engine.codegen.machine import LANES, processor
from ..engine.diagram.wiring import Wiring
from ..engine.methods import TAYLOR
from ..engine.solver.batch import MEMBER_STEPS, Batch, finished
from ..engine.solver.engine_choice import make_runner, run_compared, warn_python
from ..engine.solver.legs import NativeRun, may_go_on
from ..engine.solver.runner import RunOptions
from ..engine.solver.schedule import Schedule
from ..engine.solver.series_runs import SeriesRuns
from ..engine.solver.solver_layout import JUMP, SIGNALS, Results, Status
from ..engine.solver.termination import Solution

BATCH_BYTES = 64_000_000  # states of a batch, for each thread
MOST_MEMBERS = 512  # of a batch
SIGNAL_NUMBERS = 500_000  # evaluated at once
KERNEL = "basis.kernel"  # the key of a scenario that changes the record of its loop
SOFTWARE = ("clpt-control", "llvmlite", "numpy", "scipy")
MOST_GROUPS = 64  # with code of their own, in memory
TRIED = 5  # members whose records are compared with Python before the run
# sampled parameters or summaries by name; a row for each member
Values = dict[str, np.ndarray]
# parameters of all blocks, initial state, inputs
Member = tuple[Sequence[Any], np.ndarray, Any]
Varied = Any  # a `VariedScenario` or a `VariedDiagram`


@dataclass
class Members:
    """Parameters and initial states of m members."""

    P: np.ndarray  # (m, nP)
    x0: np.ndarray  # (m, nstates)
    group: np.ndarray  # (m,), the number of a member's schedule
    schedules: list[Schedule]
    runners: list[tuple[Any, Any]]  # runner and inputs of each member

    def inputs_along(self, times: np.ndarray, rows: np.ndarray) -> np.ndarray:
        """Return the inputs of members at times, (m or 1, ntimes, ninputs)."""
        inputs = [self.runners[m][1] for m in rows.tolist()]
        if all(item is inputs[0] for item in inputs):
            inputs = inputs[:1]
        return np.array([item.along(times).T for item in inputs])


class Ensemble:
    """A varied system that makes and runs members.

    `keys` are the names of the sampled parameters; `lanes` members run at once, eight if faster.
    """

    def __init__(self, varied: Varied, keys: Iterable[str], engine: str | None = None):
        self.varied, self.keys = varied, [*keys]
        self.options = RunOptions(**varied.options)
        # members that share the values of these keys are a group with blocks of its own
        self.remade = varied.remade(self.keys)
        self.groups: dict[str, Ensemble] = {}  # by these values
        self.locations = {
            key: varied.location(key) for key in self.keys if key not in self.remade
        }
        self.native = self._runner(engine)  # machine code, or Python
        self.compiled = self.native.engine == "native"
        self.lanes = self.native.lanes(LANES) if self.compiled else 1
        one_by_one = varied.one_by_one if self.compiled else lambda key: True
        self.one_by_one = [key for key in self.locations if one_by_one(key)]
        self._lock = threading.Lock()

    def _runner(self, engine: str | None) -> Any:
        """Return the runner; each field that a key varies has a separate column of P."""
        varied = self.varied
        keys_of_field: dict[tuple[int, str], tuple[str, ...]] = {}
        for key, location in self.locations.items():
            for field in location.fields:
                keys_of_field[field] = (*keys_of_field.get(field, ()), key)
        runner = make_runner(varied.wiring, engine, varied.name, keys_of_field)
        if runner.hidden_state:
            raise DiagramError(
                f"{varied.name}: members of an ensemble would share hidden state: "
                f"{runner.hidden_state}"
            )
        if runner.engine != "native":
            return runner
        runner.most = MEMBER_STEPS
        if runner.sweep.guarded and not runner.nstates:
            return make_runner(varied.wiring, "python")
        return runner

    @cached_property
    def recipe(self) -> bytes:
        """Pickled arguments, with the equations of a script, for `ensemble_of` in a worker."""
        from distributed.protocol.pickle import dumps

        try:
            return bytes(dumps((self.varied, self.keys, self.native.engine)))
        except (pickle.PicklingError, AttributeError, TypeError):
            raise DiagramError(
                f"{self.varied.name}: cannot be sent to workers. Define equations and parameters "
                "at the top of a module"
            ) from None

    @cached_property
    def code(self) -> str:
        """A hash of the code and the versions that compute the numbers."""
        code = getattr(self.native, "code", None)
        facts = versions(*SOFTWARE), repr(code and code.program), repr(processor())
        return hashlib.sha256("\n".join(facts).encode()).hexdigest()[:16]

    # --- members from values --------------------------------------------------------------

    def members(self, values: Values) -> Members:
        """Return the members with these values of the sampled parameters."""
        varied, count = self.varied, member_count(values)
        members = Members(
            P=np.tile(self.native.parameters(), (count, 1)),
            x0=np.tile(varied.start, (count, 1)),
            group=np.zeros(count, dtype=np.int64),
            schedules=[self.native.schedule(varied.state_times, varied.inputs)],
            runners=[(self.native, varied.inputs)] * count,
        )
        if self.one_by_one:
            self._make_one_by_one(members, values)
        for key in self.locations.keys() - set(self.one_by_one):
            location, slots = self.locations[key], self.native.layout.slots
            flat = np.reshape(values[key], (count, -1))
            elements = location.elements(self.native.sweep.parameters)
            columns = [slots[k, field].offset + index for k, field, index in elements]
            members.P[:, columns] = np.tile(flat, len(location.fields))
            members.x0[:, list(location.states)] = flat[:, : len(location.states)]
        if self.compiled and members.schedules[0].begins:
            begin = float(varied.state_times[0])
            callee = self.native.callee()
            for m, x0 in enumerate(members.x0):
                schedule = members.schedules[members.group[m]]
                x0[:] = callee.evaluate(JUMP, [begin], x0, schedule, members.P[m])
        return members

    def _make_one_by_one(self, members: Members, values: Values) -> None:
        """Fill in each member from the values that have no location of their own."""
        times = self.varied.state_times
        numbers = {}
        for m in range(len(members.x0)):
            member_values = {key: values[key][m] for key in self.one_by_one}
            parameters, members.x0[m], inputs = self.varied.member(member_values)
            runner = self.native.with_parameters(parameters)
            members.P[m] = runner.parameters()
            members.runners[m] = self.native if self.compiled else runner, inputs
            # members with equal breakpoints share a schedule
            schedule = runner.schedule(times, inputs)
            name = schedule.edges.tobytes(), schedule.values.tobytes()
            if name not in numbers:
                numbers[name] = len(members.schedules)
                members.schedules.append(schedule)
            members.group[m] = numbers[name]

    # --- runs and summaries ---------------------------------------------------------------

    def run(self, members: Members, times: np.ndarray) -> Results:
        """Run members in the calling thread; their states are NaN after their end."""
        count = len(members.x0)
        if not (self.native.nstates or self.native.sweep.guarded):
            return finished(count, len(times), 0)
        if not self.compiled:
            return self._run_in_python(members, times)
        first = self._first_legs(members, times)
        result = first.results
        may_follow = np.isin(result.status, may_go_on(self.native))
        for m in np.flatnonzero(may_follow).tolist():
            start = (
                members.x0[m],
                members.P[m],
                times,
                members.schedules[members.group[m]],
            )
            run = NativeRun(self.native, *start, self.options)
            try:
                is_left = m in first.ends
                run = run.go_on(first, m) if is_left else run.go_on(run.first_leg())
            except SimulationError:  # it begins where its jump is not defined
                result.status[m] = Status.GUARD_LEFT
                continue
            for array, rows in zip(result, run.results, strict=True):
                array[m] = rows[0]
        return result

    def _first_legs(self, members: Members, times: np.ndarray) -> Any:
        """Run first legs side by side."""
        native, options = self.native, self.options
        runs = members.x0, members.P, times, members.schedules, members.group
        if options.method == TAYLOR:
            return SeriesRuns(native, *runs, options, self.lanes)
        method = native.method_of(options.method)
        lanes = 1 if method.implicit else self.lanes
        batch = Batch(native.callee(lanes, method), *runs)
        batch.finish(options, native.most, native.implicit)
        return batch

    def _run_in_python(self, members: Members, times: np.ndarray) -> Results:
        """Run members one after the other; return their states."""
        shape = len(members.x0), len(times), self.native.nstates
        states, status, reached, counts = results = finished(*shape)
        for m, (runner, inputs) in enumerate(members.runners):
            try:
                run = runner.solve(members.x0[m], times, inputs, self.options)
                rows, end = run.x, run.t[-1]
                if run.status == "stopped":
                    status[m] = Status.GUARD_LEFT
                counts[m, : len(run.statistics)] = [*run.statistics.values()]
            except SimulationError as error:
                status[m] = error.status or Status.NOT_FINITE
                rows = error.states
                end = times[len(rows) - 1] if len(rows) else -np.inf
            reached[m] = np.searchsorted(times, end, side="right")
            states[m, : reached[m]] = rows[: reached[m]]
        return results

    def signals(
        self, members: Members, run: Results
    ) -> Iterator[tuple[np.ndarray, np.ndarray]]:
        """Yield some members, and all their signals (m, times, signals), NaN after their end."""
        times = self.varied.state_times
        if not self.compiled:
            for m, (runner, inputs) in enumerate(members.runners):
                reached = slice(run.reached[m])
                signals = np.full((1, len(times), self.native.nsignals), np.nan)
                solution = Solution(times[reached], run.states[m, reached])
                signals[0, reached] = runner.evaluate(solution, inputs)
                yield np.array([m]), signals
            return
        numbers = max(self.native.nsignals, 1) * len(times)
        for g in np.unique(members.group).tolist():
            schedule = members.schedules[g]
            width = len(schedule.values) * members.P.shape[1] + numbers
            count = max(1, SIGNAL_NUMBERS // width)
            of_group = np.flatnonzero(members.group == g)
            for begin in range(0, len(of_group), count):
                rows = of_group[begin : begin + count]
                signals = self.native.callee().evaluate_runs(
                    SIGNALS, times, run.states[rows], schedule, members.P[rows]
                )
                signals[np.arange(len(times)) >= run.reached[rows, None]] = np.nan
                yield rows, signals

    @property
    def batch(self) -> int:
        """Number of members whose states fit into a thread's memory; one in Python.

        An interrupt waits for the running batches.
        """
        if not self.compiled:
            return 1
        states = max(self.native.nstates, 1)
        fit = BATCH_BYTES // (8 * states * len(self.varied.state_times))
        return max(8, min(MOST_MEMBERS, fit // 8 * 8))

    def summaries(self, values: Values) -> Values:
        """Run the members of a batch, those of each group together; return their summaries."""
        if not self.remade:
            return self._summaries(values)
        groups: dict[Ensemble, list[int]] = {}
        for m in range(member_count(values)):
            groups.setdefault(self.group(values, m), []).append(m)
        order = np.argsort(np.concatenate([*groups.values()]))
        parts = [
            group._summaries({key: column[rows] for key, column in values.items()})
            for group, rows in groups.items()
        ]
        return {name: column[order] for name, column in concatenated(parts).items()}

    def group(self, values: Values, m: int) -> "Ensemble":
        """Return the ensemble of a member's group, compiled once."""
        shared = {key: values[key][m] for key in self.remade}
        if not shared:
            return self
        name = repr([np.asarray(value).tolist() for value in shared.values()])
        with self._lock:
            if name not in self.groups:
                others, engine = [*self.locations], self.native.engine
                for oldest in list(self.groups)[: 1 - MOST_GROUPS]:
                    del self.groups[oldest]
                made = self.varied.made_with(shared)
                self.groups[name] = Ensemble(made, others, engine)
            return self.groups[name]

    def _summaries(self, values: Values) -> Values:
        """Run members of one record and return their summaries."""
        varied = self.varied
        with self._lock:  # members use one evaluator; compile it once
            members = self.members(values)
            if self.compiled:
                for lanes in {self.lanes, 1 if varied.needs_signals else self.lanes}:
                    self.native.callee(lanes)
        states = self.run(members, varied.state_times)
        with np.errstate(all="ignore"):  # failed members may have any values
            batch = varied.batch(varied, self, members, values, states)
            result = {name: series.of(batch) for name, series in varied.summaries}
        end = varied.state_times[np.clip(states.reached - 1, 0, None)]
        for m, (times, _) in batch.stops.items():
            end[m] = times[-1]
        return {**result, "status": batch.run.status.astype("int8"), "end": end}

    def single(self, values: Values, m: int) -> tuple[Any, tuple]:
        """Return the runner of one member, and the arguments of its `solve`."""
        group = self.group(values, m)
        member_values = {key: column[m] for key, column in values.items()}
        parameters, start, inputs = group.varied.member(member_values)
        runner = group.native.with_parameters(parameters)
        return runner, (start, self.varied.state_times, inputs, self.options)


@dataclass
class MemberBatch:
    """Members that ran; its subclasses summarise them."""

    varied: Varied
    ensemble: Ensemble
    members: Members
    values: Values
    run: Results
    # times and outputs of members that a guard stopped
    stops: dict[int, tuple[np.ndarray, np.ndarray]] = made_by(default_factory=dict)


def verified_ensemble(varied: Varied, values: Values) -> Ensemble:
    """Return an ensemble; in Python if machine code runs a sample of its members differently."""
    ensemble = Ensemble(varied, values)
    if all(node.system.of_package for node in varied.wiring.nodes):
        return ensemble
    count = member_count(values)
    for m in sorted({k * (count - 1) // (TRIED - 1) for k in range(TRIED)}):
        if not ensemble.compiled:
            break
        runner, arguments = ensemble.single(values, m)
        try:
            _, reason = run_compared(runner, *arguments)
        except SimulationError:  # the member fails, as its status will tell
            continue
        if reason:
            warn_python(varied.name, reason)
            return Ensemble(varied, values, "python")
    return ensemble


def hash_of(wiring: Wiring, parameters: Iterable[Any], *extras: Any) -> str:
    """Return a hash of a diagram, its parameters and others that determine the numbers."""
    facts: list[Any] = [(n.name, n.wires, n.system.records) for n in wiring.nodes]
    facts += [wiring.outputs, wiring.dt]
    for value in (*(number for numbers in parameters for number in numbers), *extras):
        facts.append(value.tolist() if isinstance(value, np.ndarray) else value)
    return hashlib.sha256(repr(facts).encode()).hexdigest()[:16]


def member_count(values: Values) -> int:
    """Return the number of members with these values."""
    return len(next(iter(values.values())))


def cut(values: Values, size: int) -> Iterator[Values]:
    """Yield values in batches of at most `size` members."""
    for begin in range(0, member_count(values), size):
        yield {name: array[begin : begin + size] for name, array in values.items()}


def concatenated(batches: list[Values]) -> Values:
    """Return the summaries of batches, concatenated."""
    return {
        name: np.concatenate([batch[name] for batch in batches]) for name in batches[0]
    }


@lru_cache(maxsize=4)
def ensemble_of(recipe: bytes) -> Ensemble:
    """Return the ensemble of a recipe, cached in each process."""
    return Ensemble(*pickle.loads(recipe))
