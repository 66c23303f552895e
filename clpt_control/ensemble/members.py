"""Many runs of one diagram that differ in numbers, not in shape: a scenario's, or any other.

A member is the diagram with some values changed.  Most values have known places in P and in the
initial state, and fill whole columns for all members.  Members are made one by one of values from
which others are computed (frequencies from periods), of those that move breakpoints, and of inputs.
What cannot be compiled runs in Python, one member after the other; so does discrete time.

What is varied, a `VariedScenario` or a `VariedDiagram`, says of each key whether it may vary, where
its value lies and whether members are made one by one of it (`why_not`, `check`, `place`,
`one_by_one`); makes one `member` of values; and knows the `arrays` of its summaries and how it is
summarised (`summarise`).  It travels pickled: a thread and a far machine run and summarise members
in the same way.
"""

import hashlib
import pickle
import threading
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache, partial
from importlib.metadata import version
from typing import Any

import numpy as np

from ..base.errors import DiagramError, SimulationError
from ..engine.codegen.directional_derivatives import read_as_number
from ..engine.codegen.machine import LANES, processor
from ..engine.diagram.wiring import Wiring
from ..engine.solver import solver_layout as layout
from ..engine.solver.batch import Batch, Callee
from ..engine.solver.engine_choice import make_runner, run_compared, warn_python
from ..engine.solver.filippov import continue_on_switch
from ..engine.solver.runner import PythonDiagram
from ..engine.solver.schedule import Schedule
from ..engine.solver.solver_layout import Status
from ..engine.solver.termination import STUCK, sampled_start

BATCH_BYTES = 64_000_000  # states in flight, a thread
MOST_MEMBERS = 512  # a batch
TRIED = 5  # members whose records are compared with Python, before any runs
# what varies, or summaries, each with a row for each member
Values = dict[str, np.ndarray]
# parameters of all blocks, start, inputs
Member = tuple[Sequence[Any], np.ndarray, Any]
Varied = Any  # a `VariedScenario` or a `VariedDiagram`


@dataclass
class Members:
    """Parameters and initial states of m members."""

    P: np.ndarray  # (m, nP)
    x0: np.ndarray  # (m, nstates)
    group: np.ndarray  # (m,), the number of a member's schedule
    schedules: list[Schedule]
    runners: list[tuple[PythonDiagram, Any]]  # what runs each by itself, and its inputs

    def schedule(self, m: int) -> Schedule:
        """Return the pieces of time of a member."""
        return self.schedules[self.group[m]]


@dataclass(frozen=True)
class States:
    """States of m runs, and how each ended."""

    states: np.ndarray  # (m, ntimes, nstates), NaN after the last sample reached
    status: np.ndarray  # (m,), as the solver numbers it
    reached: np.ndarray  # (m,), samples reached
    counts: np.ndarray  # (m, 4): steps, evaluations, restarts, rejected steps


class Ensemble:
    """A varied system, ready to make and run members.

    `keys` are the names of what varies; `lanes` members run at once, eight where that is quicker.
    """

    def __init__(self, varied: Varied, keys: Iterable[str], engine: str | None = None):
        self.varied, self.places = varied, {key: varied.place(key) for key in keys}
        self.native = self._runner(engine)  # machine code, or Python
        self.compiled = self.native.engine == "native"
        self.lanes = self.native.lanes(LANES)
        one_by_one = varied.one_by_one if self.compiled else lambda key: True
        self.one_by_one = [key for key in self.places if one_by_one(key)]
        self._lock = threading.Lock()

    def _runner(self, engine: str | None) -> Any:
        """Return what runs it; fields that a key varies have places of their own."""
        varied, apart = self.varied, dict[tuple[int, str], tuple[str, ...]]()
        for key, place in self.places.items():
            for one in place.fields:
                apart[one] = (*apart.get(one, ()), key)
        system = varied.wiring, varied.params
        runner = make_runner(*system, engine, varied.name, apart)
        for (k, name), keys in apart.items() if runner.engine == "native" else ():
            node = varied.wiring.nodes[k]
            if role := read_as_number(node.system, name):
                warn_python(
                    varied.name,
                    f"{node.name}.{role} is read for one value of {keys[-1]}",
                )
                return make_runner(*system, "python")
        return runner

    @cached_property
    def recipe(self) -> bytes:
        """Bytes of which another process makes the same; they hold a script's own equations."""
        from distributed.protocol.pickle import dumps

        try:
            return bytes(dumps((self.varied, [*self.places], self.native.engine)))
        except (pickle.PicklingError, AttributeError, TypeError):
            raise DiagramError(
                f"{self.varied.name}: cannot be sent to workers; define equations and parameters "
                "at the top of a module"
            ) from None

    @cached_property
    def code(self) -> str:
        """A hash of the code and the versions that make the numbers."""
        code = getattr(self.native, "code", None)
        parts = [version(name) for name in ("clpt-control", "llvmlite", "numpy")]
        parts += [repr(code and code.program), repr(processor())]
        return hashlib.sha256("\n".join(parts).encode()).hexdigest()[:16]

    # --- members made of values -----------------------------------------------------------

    def members(self, values: Values) -> Members:
        """Make members of values."""
        varied, count = self.varied, len(next(iter(values.values())))
        P, x0 = (
            np.tile(self.native.parameters(), (count, 1)),
            np.tile(varied.start, (count, 1)),
        )
        pieces = self.native.schedule(varied.state_times, varied.inputs)
        runners = [(self.native, varied.inputs)] * count
        members = Members(P, x0, np.zeros(count, dtype=np.int64), [pieces], runners)
        known = dict[tuple, int]()
        for m in range(count if self.one_by_one else 0):
            own = {key: values[key][m] for key in self.one_by_one}
            parameters, x0[m], inputs = varied.member(own)
            one = self.native.with_parameters(parameters)
            P[m] = one.parameters()
            pieces = one.schedule(varied.state_times, inputs)
            name = (pieces.edges.tobytes(), pieces.values.tobytes())
            if name not in known:
                known[name] = len(members.schedules)
                members.schedules.append(pieces)
            members.group[m] = known[name]
            members.runners[m] = self.native if self.compiled else one, inputs
        for key in self.places.keys() - set(self.one_by_one):
            flat, place = np.reshape(values[key], (count, -1)), self.places[key]
            for first in {self._column(one, place.element) for one in place.fields}:
                P[:, first : first + flat.shape[1]] = flat
            x0[:, list(place.states)] = flat[:, : len(place.states)]
        if members.schedules[0].begins:
            for m in range(count):
                callee, begin = self._callee(members, m), float(varied.state_times[0])
                x0[m] = sampled_start(callee, x0[m], begin, members.schedule(m), P[m])
        return members

    def _column(self, place: tuple[int, str], element: Any) -> int:
        """Return the column of P at which a value begins."""
        shape = np.shape(getattr(self.native.sweep.parameters[place[0]], place[1]))
        within = (
            0
            if element is ... or not shape
            else int(np.ravel_multi_index(element, shape))
        )
        return int(self.native.layout.slots[place].offset) + within

    def _callee(self, members: Members, m: int) -> Callee:
        """Return the callee of one member by itself."""
        runner, inputs = members.runners[m]
        return runner.callee(1, inputs)

    # --- run and summarised ---------------------------------------------------------------

    def run(self, members: Members, times: np.ndarray) -> States:
        """Run members, each by itself, in the calling thread, at times up to their end."""
        rtol, atol, method = (
            self.varied.options[name] for name in ("rtol", "atol", "method")
        )
        by = self.native.method_number(method)
        count, nt = len(members.x0), len(times)
        if not self.native.nstates:
            nothing, counts = (
                np.zeros((count, nt, 0)),
                np.zeros((count, 4), dtype=np.int64),
            )
            return States(
                nothing, np.full(count, Status.FINISHED), np.full(count, nt), counts
            )

        def run(
            runner: PythonDiagram, runs: tuple, lanes: int = 1, inputs: Any = None
        ) -> Batch:
            batch = Batch(runner.callee(lanes, inputs, by), *runs)
            implicit = partial(runner.implicit, inputs) if method == "auto" else None
            batch.adaptive(rtol, atol, implicit=implicit)
            return batch

        def rows(m: Any) -> tuple:
            return (
                members.x0[m],
                members.P[m],
                times,
                members.schedules,
                members.group[m],
            )

        def alone(
            of: PythonDiagram, P: Any, start: Any, at: Any, pieces: Schedule
        ) -> Batch:
            return run(of, (start[None], P[None], at, [pieces]))

        if not self.compiled:
            each = enumerate(members.runners)
            results = [
                run(of, rows([m]), inputs=inputs).results for m, (of, inputs) in each
            ]
            return States(*map(np.concatenate, zip(*results, strict=True)))
        lanes = 1 if by == layout.RODAS5P else self.lanes
        result = run(self.native, rows(slice(None)), lanes).results

        def put(m: Any, batch: Batch) -> None:
            for array, found in zip(result, batch.results, strict=True):
                array[m] = found

        stuck = np.flatnonzero(np.isin(result[1], STUCK))
        if self.native.code.program.decided and len(stuck):
            put(stuck, run(self.native.unlocked(), rows(stuck)))
        for m in np.flatnonzero(result[1] == Status.CHATTERING).tolist():
            one = members.P[m], members.x0[m], times, members.schedule(m)
            continue_on_switch(self.native, batch := alone(self.native, *one), alone)
            put([m], batch)
        return States(*result)

    def signals(self, members: Members, run: States, m: int) -> np.ndarray:
        """Return all signals of one member, at the times of its states that it reached."""
        reached = slice(run.reached[m])
        at = self.varied.state_times[reached], run.states[m, reached]
        points = *at, members.schedule(m), members.P[m]
        return self._callee(members, m).evaluate(
            layout.SIGNALS, *points, self.native.nsignals
        )

    @property
    def batch(self) -> int:
        """Number of members whose states fit into a thread's memory; one in Python.

        An interrupt waits for the batches that run.
        """
        if not self.compiled:
            return 1
        states = max(self.native.nstates, 1)
        fit = BATCH_BYTES // (8 * states * len(self.varied.state_times))
        return max(8, min(MOST_MEMBERS, fit // 8 * 8))

    def summaries(self, values: Values) -> Values:
        """Run members together, at most a batch, and return their summaries."""
        varied = self.varied
        with self._lock:  # one evaluator makes all members; compile once
            members = self.members(values)
            for lanes in {self.lanes, 1 if varied.needs_signals else self.lanes}:
                self.native.callee(lanes)
        states = self.run(members, varied.state_times)
        with np.errstate(all="ignore"):  # a member that failed may hold anything
            return varied.summarise(self, members, values, states)

    def single(self, values: Values, m: int) -> tuple[Any, tuple, dict[str, Any]]:
        """Return what runs a member by itself, and what its `run` takes."""
        given, start, inputs = self.varied.member(
            {key: own[m] for key, own in values.items()}
        )
        options = {} if self.native.wiring.dt else self.varied.options
        runner = self.native.with_parameters(given)
        return runner, (start, self.varied.state_times), {"inputs": inputs, **options}


def checked_ensemble(varied: Varied, values: Values) -> Ensemble:
    """Return an ensemble; in Python where machine code runs some of its members otherwise."""
    ensemble, count = Ensemble(varied, values), len(next(iter(values.values())))
    known = all(node.system.of_package for node in varied.wiring.nodes)
    for m in sorted(
        {k * (count - 1) // (TRIED - 1) for k in range(0 if known else TRIED)}
    ):
        if not ensemble.compiled:
            break
        runner, at, options = ensemble.single(values, m)
        try:
            _, why = run_compared(runner, *at, **options)
        except SimulationError:  # the member fails; its status will say so
            continue
        if why:
            warn_python(varied.name, why)
            return Ensemble(varied, values, "python")
    return ensemble


def hash_of(wiring: Wiring, given: Iterable[Any], *more: Any) -> str:
    """Return a hash of a diagram, of its parameters and of more that makes the numbers."""
    parts: list[Any] = [(n.name, n.wires, n.system.records) for n in wiring.nodes]
    parts += [wiring.outputs, wiring.dt]
    for one in (*(number for own in given for number in own), *more):
        parts.append(one.tolist() if isinstance(one, np.ndarray) else one)
    return hashlib.sha256(repr(parts).encode()).hexdigest()[:16]


def cut(values: Values, size: int) -> Iterator[Values]:
    """Yield the values of so many members at a time."""
    for first in range(0, len(next(iter(values.values()))), size):
        yield {name: array[first : first + size] for name, array in values.items()}


def concatenated(parts: list[Values]) -> Values:
    """Return the summaries of batches one after the other."""
    return {name: np.concatenate([part[name] for part in parts]) for name in parts[0]}


@lru_cache(maxsize=4)
def ensemble_of(recipe: bytes) -> Ensemble:
    """Return the ensemble of a recipe; a process makes it once."""
    return Ensemble(*pickle.loads(recipe))
