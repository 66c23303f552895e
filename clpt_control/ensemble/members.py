"""Many runs of one diagram that differ in numbers, not in shape: a scenario's, or any other.

A member is the diagram with some values changed.  Where a value lies in P and in the
initial state is known, so members are filled in whole columns; what is computed from values, such
as frequencies from periods, what moves breakpoints, and inputs, is made member by member.  What
cannot be compiled runs in Python, one member after the other; so does a diagram of discrete time.

Members are run and summarised in the same way by a thread and by a far machine, to which what
varies travels pickled.
"""

import hashlib
import pickle
import threading
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property, lru_cache, partial
from importlib.metadata import version
from typing import Any, Protocol

import numpy as np

from ..diagrams.varied import Place, read_as_number
from ..diagrams.wiring import Wiring
from ..errors import DiagramError, SimulationError
from ..native import solver
from ..native.batch import Batch, Callee
from ..native.ending import METHODS, STUCK, run_to_end, sampled_start, steps
from ..native.engines import make_runner, run_compared, warn_python
from ..native.machine import LANES, processor
from ..native.python_diagram import PythonDiagram
from ..native.schedule import Inputs, Schedule

BATCH_BYTES = 64_000_000  # states in flight, a thread
MOST_MEMBERS = 512  # a batch
TRIED = 5  # members whose records are run_compared with Python, before any runs
Values = Mapping[str, np.ndarray]  # what varies, each with a row for each member
Made = tuple[Sequence[Any], np.ndarray, Any]  # parameters of all blocks, start, inputs


class Varied(Protocol):
    """What is run many times: what may vary in it, how it runs, and what is kept of it."""

    name: str
    title: str
    values: dict[str, np.ndarray]  # what may vary, as it is
    params: Mapping[str, Any]
    inputs: Inputs | None
    every: np.ndarray  # the times of members' states
    how: Mapping[str, Any]  # tolerances and method
    asks: bool  # whether members are asked for signals too, one by one
    encoding: Mapping[str, Any]  # of the dataset

    @property
    def wiring(self) -> Wiring:
        """The diagram."""

    @property
    def start(self) -> np.ndarray:
        """The initial state."""

    def why_not(self, key: str) -> str:
        """Return why a key cannot vary."""

    def check(self, key: str, value: np.ndarray) -> None:
        """Refuse a value that is not allowed."""

    def place(self, key: str) -> Place:
        """Return where the value of a key that varies lies."""

    def computed(self, key: str) -> bool:
        """Return whether members are made one by one of a key's values."""

    def made(self, own: Values) -> Made:
        """Return one member with some values of its own."""

    def asked(self, path: Any) -> dict[str, Any]:
        """Return what it is, for a store that lies there."""

    def arrays(self, values: Values) -> Any:
        """Return all arrays of the store, for the values of all members."""

    def kept(
        self, ensemble: "Ensemble", members: "Members", values: Values, run: "States"
    ) -> dict[str, np.ndarray]:
        """Return what is kept of members, whatever a member that failed holds."""


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

    states: np.ndarray  # (m, ntimes, nstates), NaN after the last sample reached
    status: np.ndarray  # (m,), as `Status` numbers it
    reached: np.ndarray  # (m,), samples reached
    counts: np.ndarray  # (m, 4): steps, evaluations, restarts, rejected steps


class Ensemble:
    """What varies, ready to run, from which members are made.

    `keys` are the names of what varies.  With `lanes` eight members run at once where that is
    quicker.
    """

    def __init__(
        self, varied: Varied, keys: Iterable[str], engine: str | None = None, lanes: bool = True
    ):
        self.varied, self.places = varied, {key: varied.place(key) for key in keys}
        self.native = self._runner(engine)  # machine code, or Python
        self.compiled = self.native.engine == "native"
        self.lanes = self.native.lanes(LANES) if lanes else 1
        self.computed = [k for k in self.places if not self.compiled or varied.computed(k)]
        self._lock = threading.Lock()

    def _runner(self, engine: str | None) -> Any:
        """Return what runs it; fields that one key varies lie apart from all others."""
        varied, apart = self.varied, dict[tuple[int, str], tuple[str, ...]]()
        for key, place in self.places.items():
            for one in place.fields:
                apart[one] = (*apart.get(one, ()), key)
        by_function = varied.inputs is not None and varied.inputs.samples is None
        given = varied.wiring, varied.params, by_function
        runner = make_runner(*given, engine, varied.name, apart)
        for (k, name), keys in apart.items() if runner.engine == "native" else ():
            node = varied.wiring.nodes[k]
            if role := read_as_number(node.system, name):
                warn_python(varied.name, f"{node.name}.{role} is read for one value of {keys[-1]}")
                return make_runner(*given, "python")
        return runner

    @cached_property
    def recipe(self) -> bytes:
        """What another process makes the same of; equations of a script or a notebook go along."""
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
        """A short name of the code and the versions that make the numbers."""
        program = getattr(self.native, "code", None)
        made_of = [version(name) for name in ("clpt-control", "llvmlite", "numpy")]
        made_of += [repr(program and program.program), repr(processor())]
        return hashlib.sha256("\n".join(made_of).encode()).hexdigest()[:16]

    # --- members made of values -----------------------------------------------------------

    def _schedule(self, runner: PythonDiagram, inputs: Any) -> Schedule:
        begin, end = self.varied.every[[0, -1]].tolist()
        return runner.schedule(begin, end, inputs, runner.breaks(begin, end))

    def members(self, values: Values) -> Members:
        """Make members of values."""
        varied, count = self.varied, len(next(iter(values.values())))
        P, x0 = np.tile(self.native.parameters(), (count, 1)), np.tile(varied.start, (count, 1))
        made = Members(P, x0, np.zeros(count, dtype=np.int64), [])
        made.schedules.append(self._schedule(self.native, varied.inputs))
        known = dict[tuple, int]()
        for m in range(count if self.computed else 0):
            parameters, x0[m], inputs = varied.made({key: values[key][m] for key in self.computed})
            one = self.native.with_parameters(parameters)
            P[m] = one.parameters()
            pieces = self._schedule(one, inputs)
            name = (pieces.edges.tobytes(), pieces.values.tobytes())
            if name not in known:
                known[name] = len(made.schedules)
                made.schedules.append(pieces)
            made.group[m] = known[name]
            made.own.append((self.native if self.compiled else one, inputs))
        for key in self.places.keys() - set(self.computed):
            flat, place = np.reshape(values[key], (count, -1)), self.places[key]
            for first in {self._column(one, place.element) for one in place.fields}:
                P[:, first : first + flat.shape[1]] = flat
            x0[:, list(place.states)] = flat[:, : len(place.states)]
        if made.schedules[0].begins:
            for m in range(count):
                callee, begin = self._asked(made, m), float(varied.every[0])
                x0[m] = sampled_start(callee, x0[m], begin, made.schedule(m), P[m])
        return made

    def _column(self, place: tuple[int, str], element: Any) -> int:
        """Return where a value begins in P."""
        shape = np.shape(getattr(self.native.sweep.parameters[place[0]], place[1]))
        own = 0 if element is ... or not shape else int(np.ravel_multi_index(element, shape))
        return int(self.native.layout.slots[place].offset) + own

    def alone(self, members: Members, m: int) -> tuple[PythonDiagram, Any]:
        """Return what runs one member by itself, and its inputs."""
        return members.own[m] if members.own else (self.native, self.varied.inputs)

    def _asked(self, members: Members, m: int, method: int = solver.DOP853) -> Callee:
        """Return what one member by itself calls."""
        runner, inputs = self.alone(members, m)
        return runner.callee(1, inputs, method)

    # --- run and summarised ---------------------------------------------------------------

    def run(
        self,
        members: Members,
        times: np.ndarray,
        rtol: float = 1e-8,
        atol: float = 1e-10,
        method: str = "auto",
    ) -> States:
        """Run members, each by itself, in the calling thread, at times up to their end."""
        times, by = np.asarray(times, dtype=float), METHODS[method]
        if self.native.wiring.dt or not self.native.nstates:
            return self._iterated(members, times)
        if self.compiled:
            callee = self.native.callee(1 if by == solver.RODAS5P else self.lanes, None, by)
            parts = [(slice(None), callee, self.native.implicit)]
        else:
            parts = [
                (slice(m, m + 1), self._asked(members, m, by), partial(runner.implicit, inputs))
                for m, (runner, inputs) in enumerate(members.own)
            ]
        found = []

        def ran(some: Any, callee: Callee, implicit: Any) -> tuple[np.ndarray, ...]:
            own = members.x0[some], members.P[some]
            batch = Batch(callee, *own, times, members.schedules, members.group[some])
            run_to_end(batch, (rtol, atol), implicit if method == "auto" else None)
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
        return States(*map(np.concatenate, zip(*found, strict=True)))

    def _iterated(self, members: Members, times: np.ndarray) -> States:
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
        return States(x, status, reached, np.zeros((count, 4), dtype=np.int64))

    def signals(self, members: Members, run: States, m: int, times: np.ndarray) -> np.ndarray:
        """Return all signals of one member, at the times of its states that it reached."""
        reached = int(run.reached[m])
        x, found = run.states[m, :reached], np.empty((reached, self.native.nsignals))
        pieces, own = members.schedule(m), members.P[m]
        self._asked(members, m).evaluate(solver.SIGNALS, times[:reached], x, pieces, own, found)
        return found

    @property
    def batch(self) -> int:
        """How many members' states fit into the memory of a thread."""
        states = max(self.native.nstates, 1)
        fit = BATCH_BYTES // (8 * states * len(self.varied.every))
        return max(8, min(MOST_MEMBERS, fit // 8 * 8))

    def summaries(self, values: Values) -> dict[str, np.ndarray]:
        """Run members together, at most a batch, and return what is kept of them."""
        varied = self.varied
        with self._lock:  # one evaluator makes all members; compile once
            members = self.members(values)
            for lanes in {self.lanes, 1 if varied.asks else self.lanes}:
                self.native.callee(lanes)
        states = self.run(members, varied.every, **varied.how)
        with np.errstate(all="ignore"):  # a member that failed may hold anything
            return varied.kept(self, members, values, states)

    def one(self, values: Values, m: int) -> tuple[Any, tuple, dict[str, Any]]:
        """Return what runs a member by itself, and what its `run` takes."""
        given, start, inputs = self.varied.made({key: own[m] for key, own in values.items()})
        how = {} if self.native.wiring.dt else self.varied.how
        one = self.native.with_parameters(given)
        return one, (start, self.varied.every), {"inputs": inputs, **how}


def ready(varied: Varied, values: Values) -> Ensemble:
    """Return an ensemble; in Python where some members would be other runs as machine code."""
    found, count = Ensemble(varied, values), len(next(iter(values.values())))
    own = all(node.system.of_package for node in varied.wiring.nodes)
    for m in sorted({k * (count - 1) // (TRIED - 1) for k in range(0 if own else TRIED)}):
        if not found.compiled:
            break
        one, at, how = found.one(values, m)
        try:
            why = run_compared(one, *at, **how)[2]
        except SimulationError:  # the member fails, which its status tells
            continue
        if why:
            warn_python(varied.name, why)
            return Ensemble(varied, values, "python")
    return found


def cut(values: Values, size: int) -> Iterator[dict[str, np.ndarray]]:
    """Yield the values of so many members at a time."""
    for first in range(0, len(next(iter(values.values()))), size):
        yield {name: array[first : first + size] for name, array in values.items()}


def joined(parts: list[dict[str, np.ndarray]]) -> dict[str, np.ndarray]:
    """Join the summaries of batches that follow each other."""
    return {name: np.concatenate([part[name] for part in parts]) for name in parts[0]}


@lru_cache(maxsize=4)
def ensemble_of(recipe: bytes) -> Ensemble:
    """Return the ensemble of a recipe, made once in a process."""
    return Ensemble(*pickle.loads(recipe))
