"""A batch of runs of one diagram: the solver's arrays, and the calls that advance them.

The solver takes steps for about `PAUSE` seconds a call.  Between calls Python reports the time
reached.  The solver alone ends a run, by counts of its tries: no result depends on the clock.

Stiff runs go on with an implicit method.  An explicit one stops if its own steps look stiff
(Hairer's test) and many are ahead.  Steps look stiff as well if rates jump, but then the
eigenvalues of df/dx are small.
"""

import time
from collections.abc import Callable
from itertools import accumulate
from typing import Any, NamedTuple

import numpy as np

from ...base.progress.interrupt import check
from ..codegen.machine import numbers_of
from ..methods import TAYLOR, Method
from .callee import MOST_KEPT, Callee, aligned, keep
from .schedule import Schedule
from .solver_layout import (
    FALLS,
    FIRST_STEP,
    LOOK_ADVANCE,
    MAX_STEP,
    NEXT_LOOK,
    POINTS,
    REALS,
    ROWS,
    RUN_INDEX,
    SAMPLES_DONE,
    STATE,
    STEP_SIZE,
    STIFF_AFTER,
    STIFF_STEPS,
    TIME,
    TRIES_LEFT,
    Linear,
    Memory,
    Results,
    Runs,
    Segments,
    Solver,
    Status,
)

PAUSE = 0.05  # seconds of a call
BEGIN = 60_000  # numbers, times tries, of the first call of machine code
# looks for stiffness that do not count, after a run was found not to be stiff
LATER = 64
# explicit steps that a change of the method is worth
MANY_STEPS, FEW_STATES = (5_000, 20)
# for each state, so that a factorization is counted in evaluations
OPERATIONS_OF_A_RATE = 10
# of step times eigenvalue: half of what is stable
LARGE = 3.0
# of a model in Python: tries before its pace may end a run, and tries that are out of reach
LATE_LOOK, OUT_OF_REACH = (10_000, 4e8)
PARTS = 256  # of a run in which time alone decides: no step is longer
ROUNDS = 60  # of the power method
ANY = 2**62
MEMBER_STEPS = 5_000_000  # tries of a run among many


class End(NamedTuple):
    """The end of a run that goes on in another leg, which has a first step."""

    time: float
    state: np.ndarray
    opening: float = 0.0


class Batch:
    """Some runs of one diagram, from initial states (m, n) with parameters P (m, nP).

    States are wanted at `times`; a run starts at the first and follows its schedule,
    ``schedules[group[k]]`` or the first.  In the end `out` (m, nt, n) holds states, NaN behind the
    end of a run, `status` how runs ended, `reached` how many samples are done, and
    `counts` (m, 4) steps, evaluations, restarts and rejected steps.  No step is longer than
    `longest`; the first step tried is `opening`, unless that is 0.  `ends` has the runs that were
    left to other legs.
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
        self.callee = callee
        self.label = callee.method.name
        # 1. runs and their segments
        m, n = starts.shape
        if group is None:
            group = np.zeros(m, dtype=np.int64)
        self.runs = Runs(np.empty((m, n)), np.empty(parameters.shape), np.array(group))
        self.schedules = schedules
        self.segments = _stacked(schedules)
        self.times = np.empty(len(times))
        # 2. results
        self.results = finished(m, len(times), n)
        self.out, self.status, self.reached, self.counts = self.results
        # 3. memory of the lanes
        lanes = callee.lanes
        size = max(callee.program.parameters, parameters.shape[1], 1)
        at_points = 3 * POINTS * callee.events
        results = max(n, at_points)
        rooms = (REALS, ROWS * n, size, max(callee.program.room, 1), results)
        self._reals, arrays = aligned(*(lanes * room for room in rooms))
        numbers, self.Z, P, W, D = arrays
        self.lane = numbers.reshape(-1, lanes)
        self.integers = np.empty((5, lanes), dtype=np.int64)
        self.states = self.Z.reshape(-1, n, lanes)
        self.memory = Memory(self.Z, P, callee.tables, W, D)
        # 4. events at the sample points of a step
        self.points = D[:at_points].reshape(POINTS, 3, callee.events)
        # 5. the solver's argument
        self._tolerances = np.zeros(2)
        self.linear = with_room(callee.linear)
        self.solver = Solver(
            code=callee.functions,
            shape=callee.shape,
            tolerances=self._tolerances,
            runs=self.runs,
            segments=self.segments,
            times=self.times,
            results=self.results,
            lane=self.lane,
            integers=self.integers,
            queue=np.empty(3, dtype=np.int64),
            memory=self.memory,
            states=self.states,
            points=self.points,
            levels=callee.levels,
            linear=self.linear,
        )
        self._call = numbers_of(self.solver, 0, 0)
        sizes = self._reals.size, self.out.size, self.segments.values.size
        self.is_small = sum(sizes) < MOST_KEPT
        self.begin(starts, parameters, times, schedules, longest, opening)

    def release(self) -> None:
        """Keep the arrays of a run that is over for another one, if they are small."""
        if self.is_small:
            P, values = self.runs.parameters[0], self.segments.values
            keep(self.callee.kept, (P.shape, self.times.shape, values.shape), self)

    def begin(
        self,
        starts: np.ndarray,
        parameters: np.ndarray,
        times: np.ndarray,
        schedules: list[Schedule],
        longest: float,
        opening: float,
    ) -> None:
        """Begin runs in the arrays of this batch, whose shapes theirs have."""
        callee = self.callee
        self._reals.fill(0.0)
        self.runs.states[:] = starts
        self.runs.parameters[:] = parameters
        self.times[:] = times
        if schedules[0] is not self.schedules[0]:
            self.schedules = schedules
            for array, values in zip(self.segments, _stacked(schedules), strict=True):
                array[:] = values
        for matrix in self.linear[:3]:
            matrix.fill(0)
        # 1. results
        self.out.fill(np.nan)
        self.out[:, 0] = self.runs.states
        for array in self.results[1:]:
            array.fill(0)
        self.ends: dict[int, End] = {}
        # 2. a lane without a run has the state and parameters with which the first begins
        self.integers.fill(-1)
        self.solver.queue[:] = 0, len(self.status), 0
        self.states[STATE] = self.runs.states[:1].T
        in_lanes = self.memory.P.reshape(-1, callee.lanes)
        in_lanes[: parameters.shape[1]] = parameters[:1].T
        in_lanes[self.segments.indices] = self.segments.values[:1].T
        timed = callee.program.timed
        if callee.slopes:
            in_segments = np.isin(self.segments.indices, callee.slopes)
            timed |= self.segments.values[:, in_segments].any()
        if timed:
            longest = min(longest, (self.times[-1] - self.times[0]) / PARTS)
        self.lane[MAX_STEP] = longest
        # rates that read time, or have events, may slow down after any burst
        self.lane[FALLS] = -np.inf if timed or callee.events else 0.0
        self.lane[FIRST_STEP] = opening

    @property
    def now(self) -> float:
        """Time reached by the first lane."""
        return float(self.lane[TIME, 0])

    def finish(
        self,
        options: Any,
        most: int = MEMBER_STEPS,
        implicit: Callable[[], Callee] | None = None,
    ) -> None:
        """Run to the end with steps chosen by tolerance, each run for at most `most` tries.

        Tries of steps of discrete time are not limited.  `options.progress` is called with the time
        reached by the first lane, about every `PAUSE`.  Where the options choose no method, stiff
        runs are left to that which calls the functions of `implicit`.
        """
        rtol, atol, progress = options.rtol, options.atol, options.progress
        method = self.callee.method
        is_chosen = options.method in ("auto", TAYLOR) and implicit is not None
        may_change = is_chosen and not method.implicit
        self.lane[STIFF_STEPS] = 0.0 if may_change else -np.inf
        if method.discrete:
            most = ANY
        if self.callee.decided:
            first = self.callee.decided_at
            self.runs.parameters[:, first - 2 : first] = rtol, atol
        is_short = self.callee.tries < LATER
        budget = min(max(64, BEGIN // self.callee.nstates), self.callee.tries)
        while True:
            check()
            if is_short and may_change:  # look for stiffness in each call
                self.lane[STIFF_STEPS] = np.maximum(self.lane[STIFF_STEPS], 1.0)
                self.lane[TRIES_LEFT] = 0.0
            look, advance = self.lane[[NEXT_LOOK, LOOK_ADVANCE], 0]
            ahead = self.times[-1] - self.now
            if is_short and look > LATE_LOOK and look * ahead > OUT_OF_REACH * advance:
                most = 1
            begin = time.perf_counter()
            active = self.advance(rtol, atol, budget, most)
            if progress is not None:
                progress(self.now)
            if not active:
                break
            # end stiff runs
            doubtful = np.flatnonzero(self.lane[STIFF_STEPS] >= STIFF_AFTER)
            for k in doubtful:
                self._end_if_stiff(int(k), options, implicit)
            if is_short:  # where a run is looked at must not depend on the clock
                continue
            # adapt the tries of a call to its duration
            if len(doubtful):  # they were not used up
                budget = max(budget // 4, 1)
            share = PAUSE / max(time.perf_counter() - begin, 1e-6)
            wished = max(budget * share, budget / 2 + 1)
            budget = int(min(wished, 4 * budget))

    def advance(
        self, rtol: float, atol: float, budget: int, most: int = MEMBER_STEPS
    ) -> int:
        """Take some steps in each lane; return how many lanes are at work."""
        self._tolerances[:] = max(rtol, 2.3e-14), atol
        self._call[-2:] = budget, most
        return self.callee.call("advance", self._call)

    def _end_if_stiff(self, k: int, options: Any, implicit: Any) -> None:
        """End the run of a lane if it is stiff."""
        n = self.callee.nstates
        self.lane[STIFF_STEPS, k] = -LATER
        m = int(self.integers[RUN_INDEX, k])
        if m < 0:
            return
        # many steps must be ahead
        t, h = self.lane[[TIME, STEP_SIZE], k].tolist()
        callee = implicit()
        worth = steps_worth(callee, self.callee.method)
        if self.times[-1] - t < h * worth and self.callee.tries > LATER:
            return
        # the first implicit step computes the Jacobian
        schedule = self.schedules[self.runs.schedule[m]].after(t)
        P = self.runs.parameters[m, : callee.program.parameters]
        start = self.states[STATE, :, k], P, np.array([t, self.times[-1]])
        batch = batch_of(callee, *start, schedule, self.lane[MAX_STEP, k])
        batch.advance(options.rtol, options.atol, 1)
        if h * radius(batch.linear.jacobian.reshape(n, n)) > LARGE:
            # the run is left to another leg
            self.ends[m] = End(t, self.states[STATE, :, k].copy())
            self.status[m] = Status.STIFF
            self.reached[m] = self.integers[SAMPLES_DONE, k]
            self.integers[RUN_INDEX, k] = -1
        batch.release()

    def write_into(self, results: Results, times: np.ndarray) -> None:
        """Write the only run of this batch into results at times: it continues their run."""
        ahead = self.times[1 : self.reached[0]]
        _, samples, indices = np.intersect1d(times, ahead, return_indices=True)
        results.states[0, times > self.times[0]] = np.nan
        results.states[0, samples] = self.out[0, 1 + indices]
        results.status[0] = self.status[0]
        reached = self.times[self.reached[0] - 1]
        results.reached[0] = np.searchsorted(times, reached, "right")
        results.counts[0] += self.counts[0]


def batch_of(
    callee: Callee,
    start: np.ndarray,
    P: np.ndarray,
    times: np.ndarray,
    segments: Schedule,
    longest: float,
    opening: float = 0.0,
) -> Batch:
    """Return a batch of one run, in arrays of an earlier one if there are some of its shape."""
    shape = P.shape, times.shape, segments.values.shape
    batch = callee.kept.pop(shape, None)
    runs = start[None], P[None], times, [segments]
    if batch is None:
        return Batch(callee, *runs, None, longest, opening)
    batch.begin(*runs, longest, opening)
    return batch


def finished(runs: int, samples: int, n: int) -> Results:
    """Return results of runs that finish; their states are to be written."""
    return Results(
        np.full((runs, samples, n), np.nan),
        np.full(runs, int(Status.FINISHED)),
        np.full(runs, samples),
        np.zeros((runs, 4), dtype=np.int64),
    )


def with_room(linear: Linear) -> Linear:
    """Return the sparsity of a Jacobian matrix with room for matrices and pivots."""
    n = len(linear.order)
    matrix, factors = np.zeros((2, n * n))
    pivots, nonzero, queue = np.zeros((3, n), np.int64)
    return Linear(matrix, factors, pivots, nonzero, queue, *linear[5:])


def steps_worth(implicit: Callee, method: Method) -> float:
    """Return the steps of a method ahead for which changing to an implicit one pays.

    Fewer of them for many states, whose explicit steps take longer than preparing the method,
    unless the matrix is full: an implicit step then takes many evaluations.
    """
    linear, n = implicit.linear, implicit.nstates
    evaluations = 2 * (len(linear.begins) - 1) + implicit.method.stages
    operations = sum(linear.band) * (1 + linear.band[0])
    work = evaluations + operations / OPERATIONS_OF_A_RATE
    ratio = work / method.stages  # of the work of an implicit step and an explicit one
    return MANY_STEPS * min(1.0, ratio / (1 + n / FEW_STATES))


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


def _stacked(schedules: list[Schedule]) -> Segments:
    """Return the segments of all schedules, one behind the other."""
    counts = [len(schedule.edges) for schedule in schedules]
    return Segments(
        np.array([*accumulate(counts, initial=0)]),
        np.array(schedules[0].indices),
        np.concatenate([schedule.edges for schedule in schedules]),
        np.concatenate([schedule.values for schedule in schedules]),
        np.concatenate([schedule.smooth for schedule in schedules]),
    )
