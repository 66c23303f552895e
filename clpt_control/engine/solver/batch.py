"""A batch of runs of one diagram: the solver's arrays, and how a run is watched.

The solver takes steps for about `PAUSE` seconds a call.  Between calls Python watches the time
reached, and whether the end can be reached at all.

Stiff runs go on with an implicit method.  An explicit one stops if its own steps look stiff
(`method`, Hairer's test) and many are ahead.  Steps look stiff as well if rates jump, but then the
eigenvalues of df/dx are small.
"""

import time
from collections.abc import Callable
from itertools import accumulate
from typing import Any, NamedTuple

import numpy as np

from ...errors import SimulationError
from ...progress.interrupt import check
from ..codegen.machine import LANES, compiled_solver, numbers_of
from .jacobian import Jacobian
from .schedule import Schedule
from .solver_layout import (
    FIRST_STEP,
    MAP,
    MAX_STEP,
    POINTS,
    REALS,
    RK4,
    ROWS,
    RUN_INDEX,
    STATE,
    STEP_SIZE,
    STIFF_AFTER,
    STIFF_STEPS,
    TIME,
    Memory,
    Results,
    Runs,
    Segments,
    Shape,
    Solver,
    Status,
)

PAUSE = 0.05  # seconds of a call
BEGIN = 60_000  # numbers, times tries, of the first call of machine code
GRAIN = 0.01  # of atol: a smaller difference passes no decision
LATER = 64  # looks for stiffness that do not count, after a run was found not to be stiff
# of step times eigenvalue: half of what is stable
LARGE = 3.0
EMPTY = np.zeros((0, 3, 0))
PARTS = 256  # of a run in which time alone decides: no step is longer
ROUNDS = 60  # of the power method
ANY = 2**62
MEMBER_STEPS = 5_000_000  # tries of a run among many


class Callee(NamedTuple):
    """What the solver calls, and how much room its arrays need; `shape` is the solver's."""

    engine: str  # whose functions they are: "native" or "python"
    functions: Any  # in the solver's order: their addresses, an array
    lanes: int  # runs that are taken at once
    nstates: int
    method: int  # as the solver numbers it
    guarded: int  # 1 if guards are watched
    jumping: int  # 1 if states jump
    decided_at: int  # first place of decisions in P
    decided: int  # how many numbers they are
    unannounced: int  # 1 if rates may jump where no decision says so, 2 if at samples too
    size: int  # length of P
    room: int  # length of W
    tables: np.ndarray  # T, which is not empty
    linear: Jacobian = Jacobian()  # of Rodas5P
    timed: bool = False  # whether time alone decides
    code: tuple = ()  # objects that must live for as long as addresses are used
    raised: Any = ()  # errors that functions of Python raised, a list

    @property
    def shape(self) -> Shape:
        """Sizes of the problem, as the solver takes them."""
        return Shape(*self[2:10])

    def call(self, name: str, numbers: np.ndarray) -> int:
        """Call a function of the solver on numbers; raise the error that Python raised within."""
        with np.errstate(all="ignore"):
            result = getattr(compiled_solver(), name)(numbers)
        if self.raised:
            raise self.raised.pop()
        return result

    def evaluate(
        self, role: int, times: Any, x: Any, pieces: Schedule, parameters: Any, count: int
    ) -> np.ndarray:
        """Return the first `count` results of a function at times and states x (nt, n), a row each.

        `parameters` are P, or its beginning.
        """
        sizes = max(self.size, len(parameters)), self.room, max(count, 3 * self.decided)
        P, W, D = (np.zeros(size + 1) for size in sizes)
        P[: len(parameters)], times = parameters, np.ascontiguousarray(times)
        out, which = np.empty((len(times), count)), np.searchsorted(pieces.edges, times, "right")
        points, each = (times, which, np.zeros(1), x.ravel()), (pieces.places, pieces.values)
        decisions, arrays = (self.decided_at, self.decided), (P, self.tables, W, D)
        how = self.functions, role, self.nstates, *decisions
        self.call("evaluate", numbers_of(*how, points, each, arrays, out))
        return out


class Batch:
    """Some runs of one diagram, from initial states (m, n) with parameters P (m, nP).

    States are wanted at `times`; a run starts at the first and follows its schedule,
    ``schedules[group[k]]`` or the first.  In the end `out` (m, nt, n) holds states, NaN behind the
    end of a run, `status` how runs ended, `reached` how many samples are done, and
    `counts` (m, 4) steps, evaluations, restarts and rejected steps.  No step is longer than
    `longest`, which is the step of RK4; the first step tried is `opening`, unless that is 0.
    """

    def __init__(
        self,
        callee: Callee,
        starts: np.ndarray,
        parameters: np.ndarray,
        times: np.ndarray,
        schedules: list[Schedule],
        group: np.ndarray | None = None,
        longest: float = np.inf,
        opening: float = 0.0,
    ):
        self.callee, self.times = callee, np.ascontiguousarray(times)
        (m, n), lanes = starts.shape, callee.lanes
        if callee.timed:
            longest = min(longest, (times[-1] - times[0]) / PARTS)
        group = np.zeros(m, dtype=np.int64) if group is None else group
        self.runs = Runs(*map(np.ascontiguousarray, (starts, parameters, group)))
        self.pieces, self.segments = schedules, _stacked(schedules)
        if callee.method == RK4:
            self.segments.smooth[:] = 0  # every segment begins anew
        self.out = np.full((m, len(times), n), np.nan)
        self.out[:, 0] = starts
        self.rests: dict[int, Batch] = {}  # of stiff runs, and of one that slides
        self.slides: list[float] = []  # when it began to
        self.status, self.reached = (np.zeros(m, dtype=np.int64) for _ in range(2))
        self.counts = np.zeros((m, 4), dtype=np.int64)
        size = max(callee.size, parameters.shape[1], 1)
        sample_points = 3 * POINTS
        conditions = (sample_points + 1) * callee.decided + sample_points * callee.guarded
        rooms = REALS, ROWS * n, size, max(callee.room, 1), max(n, conditions)
        numbers, self.Z, P, W, D = aligned(*(lanes * room for room in rooms))
        self.lane = numbers.reshape(-1, lanes)
        self.integers = np.full((5, lanes), -1, dtype=np.int64)
        self.states = self.Z.reshape(-1, n, lanes)
        # a lane without a run holds the state and parameters with which the first begins
        self.states[STATE] = starts[:1].T
        in_lanes = P.reshape(-1, lanes)
        in_lanes[: parameters.shape[1]] = parameters[:1].T
        in_lanes[self.segments.indices] = self.segments.values[:1].T
        self.lane[MAX_STEP], self.lane[FIRST_STEP] = longest, opening
        self.memory = Memory(self.Z, P, callee.tables, W, D)
        count = callee.decided
        points = D[: sample_points * count].reshape(-1, 3, count) if count else EMPTY
        guard = EMPTY
        if callee.guarded:
            guard = D[(sample_points + 1) * count :][:sample_points].reshape(-1, 3, 1)
        self.signs = D[sample_points * count : (sample_points + 1) * count]
        self.points = points
        self._tolerances = np.zeros(2)
        self.linear = callee.linear.for_solver
        self.solver = Solver(
            code=callee.functions,
            shape=callee.shape,
            tolerances=self._tolerances,
            runs=self.runs,
            segments=self.segments,
            times=self.times,
            results=Results(self.out, self.status, self.reached, self.counts),
            lane=self.lane,
            integers=self.integers,
            queue=np.array([0, m, 0], dtype=np.int64),
            memory=self.memory,
            states=self.states,
            points=points,
            guard_points=guard,
            signs=self.signs,
            linear=self.linear,
        )
        self.results = self.solver.results
        self._call = numbers_of(self.solver, 0, 0)

    @property
    def now(self) -> float:
        """Time reached by the first lane."""
        return float(self.lane[TIME, 0])

    def adaptive(
        self,
        rtol: float,
        atol: float,
        watch: Callable[["Batch"], None] = lambda batch: None,
        most: int = MEMBER_STEPS,
        implicit: Callable[[], Callee] | None = None,
    ) -> None:
        """Run to the end with steps chosen by tolerance, each run for at most `most` tries.

        Tries of RK4 and in discrete time are not limited.  `watch` is called between the solver's
        calls, each of about `PAUSE`.  `implicit` returns what an implicit method calls, if stiff
        runs are to go on with it, one after the other; `rests` are then these rests, by run.
        """
        self.lane[STIFF_STEPS] = -np.inf if implicit is None else 0.0
        first = 0 if self.callee.engine == "python" else BEGIN // self.callee.nstates
        active, budget = 1, max(64, first)
        most = ANY if self.callee.method in (RK4, MAP) else most
        if self.callee.decided:
            self.runs.parameters[:, self.callee.decided_at - 1] = GRAIN * atol
        while active:
            check()
            begin = time.perf_counter()
            active = self.advance(rtol, atol, budget, most)
            doubtful = np.flatnonzero(self.lane[STIFF_STEPS] >= STIFF_AFTER)
            for k in doubtful:
                self._end_if_stiff(int(k), rtol, atol, implicit)
            budget = max(budget // 4, 1) if len(doubtful) else budget  # it was not used up
            share = PAUSE / max(time.perf_counter() - begin, 1e-6)
            budget = int(min(max(budget * share, budget / 2 + 1), 4 * budget))
            watch(self)
        for m, rest in self.rests.items():
            rest.adaptive(rtol, atol, watch, most)
            done = len(self.times) - len(rest.times) + 1
            self.out[m, done:] = rest.out[0, 1:]
            self.status[m], self.reached[m] = rest.status[0], done + rest.reached[0] - 1
            self.counts[m] += rest.counts[0]

    def advance(self, rtol: float, atol: float, budget: int, most: int = MEMBER_STEPS) -> int:
        """Take some steps in each lane; return how many lanes are at work."""
        self._tolerances[:], self._call[-2:] = (max(rtol, 2.3e-14), atol), (budget, most)
        return self.callee.call("advance", self._call)

    def _end_if_stiff(self, k: int, rtol: float, atol: float, implicit: Any) -> None:
        """End the run of a lane if it is stiff; its rest begins where it is."""
        n = self.callee.nstates
        self.lane[STIFF_STEPS, k] = -LATER
        m, _, done, *_ = self.integers[:, k].tolist()
        if m < 0:
            return
        t, h, longest = self.lane[[TIME, STEP_SIZE, MAX_STEP], k].tolist()
        callee, state = implicit(), self.states[STATE, :, k].copy()
        if self.times[-1] - t < h * callee.linear.steps_worth:
            return
        P, pieces = (
            self.runs.parameters[m, : callee.size],
            self.pieces[self.runs.schedule[m]].after(t),
        )
        times = np.append(t, self.times[done:])
        rest = Batch(callee, state[None], P[None], times, [pieces], None, longest)
        rest.advance(rtol, atol, 1)
        if h * radius(rest.linear.jacobian.reshape(n, n)) > LARGE:
            self.rests[m] = rest
            self.status[m], self.reached[m] = Status.STIFF, done
            self.integers[RUN_INDEX, k] = -1


def radius(matrix: np.ndarray) -> float:
    """Return nearly the size of a matrix's largest eigenvalue; 0.0 if the iteration finds none."""
    v = np.random.default_rng(0).standard_normal(len(matrix))
    growth = []
    for _ in range(ROUNDS):
        v = matrix @ v
        size = float(np.linalg.norm(v))
        if not 0.0 < size < np.inf:
            return 0.0
        growth.append(np.log(size))
        v /= size
    return float(np.exp(np.mean(growth[ROUNDS // 2 :])))


def aligned(*sizes: int) -> list[np.ndarray]:
    """Return arrays of zeros, each aligned with the cache: a line of it holds eight runs."""
    places = list(accumulate((-(-size // LANES) * LANES for size in sizes), initial=0))
    room = np.zeros(places[-1] + LANES)
    first = -(room.ctypes.data // room.itemsize) % LANES
    return [room[first + k : first + k + size] for k, size in zip(places, sizes, strict=False)]


def _stacked(schedules: list[Schedule]) -> Segments:
    """Return the segments of all schedules, one behind the other."""
    rows = [(one.edges, one.values, one.smooth) for one in schedules]
    first = np.array([*accumulate((len(one.edges) for one in schedules), initial=0)])
    return Segments(first, schedules[0].places, *map(np.concatenate, zip(*rows, strict=True)))


def pace(
    most: int, begin: float, end: float, progress: Callable[[float], None] | None
) -> Callable[[Batch], None]:
    """Return a watch that reports progress, and refuses a run that cannot reach its end."""
    last, span = [0, begin], end - begin  # tries and time when the pace was last measured

    def watch(batch: Batch) -> None:
        tries, now = int(batch.counts[0, 0] + batch.counts[0, 3]), batch.now
        if progress is not None:
            progress(now)
        if tries < last[0]:  # the rest of a run, by another method
            last[:] = [0, now]
        if tries - last[0] < most // 500:
            return
        ahead = (now - last[1]) / (tries - last[0])
        if batch.status[0] == Status.RUNNING and ahead * most < span:
            needed = span / ahead if ahead > 0 else np.inf
            raise SimulationError(
                f"too many steps: {tries:,} by t = {now:.9g}, at which pace the run would take "
                f"{needed:.0e}; rates change too fast there, or a switch goes to and fro: lower "
                "the gains, give a switch a hysteresis, or loosen rtol and atol"
            )
        last[:] = [tries, now]

    return watch
