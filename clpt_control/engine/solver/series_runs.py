"""Runs by Taylor series: machine code takes all steps of a run (`codegen.series_loop`).

Where a series ends, as at a pole, at the root of 0 or after too many steps, the run goes on with
DOP853 and Rodas5P.
"""

from collections.abc import Callable
from ctypes import CFUNCTYPE, c_void_p
from math import ceil, log
from typing import Any

import numpy as np

from ...base.errors import SimulationError, Uncompiled
from ...base.progress.interrupt import check
from ..codegen import series_loop as series
from ..codegen.machine import LANES, address_of
from .batch import PARTS, End, finished
from .callee import MOST_KEPT, aligned, keep
from .schedule import Schedule
from .solver_layout import Status

MOST_ORDER = 20
CALL_STEPS = 20_000  # of a call of machine code
MOST_STEPS = 2_000_000  # of a run
FIRST_SHARE = 2.0**-6  # of the run or the longest step: the first scale
LEAST_SHARE = 1e-9  # of what is left: the first step of the method that goes on
LEAST_RTOL = 2.3e-14
NUMBERS, INTEGERS = series.SCALE + LANES, series.STEPS + LANES
ENTRY = CFUNCTYPE(None, *[c_void_p] * len(series.ARRAYS))


def order_of(rtol: float) -> int:
    """Return the order of the series for a tolerance."""
    return min(ceil(1 - log(max(rtol, LEAST_RTOL)) / 2) + 2, MOST_ORDER)


def refused(why: str) -> SimulationError:
    """Return the error of a diagram that has no series."""
    return SimulationError(
        f"method = 'taylor' does not take this model, which {why}. Use method = 'dop853'"
    )


class SeriesCode:
    """The compiled series of a diagram, and the arrays of its last runs by shape."""

    def __init__(self, diagram: Any, order: int, lanes: int):
        program = diagram.code.program
        if diagram.engine == "python":
            raise refused("runs in Python")
        if diagram.wiring.dt:
            raise refused("is in discrete time")
        if program.decided or program.guarded:
            raise refused("has conditions or kinks of its signals, or a guard")
        if diagram.layout.jumps:
            raise refused("has states that jump, or blocks that sample")
        self.code = diagram.code  # must live as long as the entry is used
        try:
            if any(nest.lengths for nest in program.functions["derivative"]):
                self.code = diagram.in_form(axes="unrolled").code
            (address,) = self.code.addresses(["series"], lanes, order)
        except Uncompiled as error:
            raise refused(str(error)) from None
        self.program, self.order, self.lanes = self.code.program, order, lanes
        self.entry = ENTRY(address)
        self.tables = np.concatenate([diagram.layout.T, self.program.tables])
        self.kept: dict[Any, SeriesArrays] = {}


def series_of(diagram: Any, rtol: float, lanes: int = 1) -> SeriesCode:
    """Return the compiled series of a diagram; refuse one that is not smooth."""
    kept, key = diagram.callees, (order_of(rtol), lanes)
    if key not in kept:
        kept[key] = SeriesCode(diagram, *key)
    return kept[key]


class SeriesArrays:
    """Arrays of machine code for groups of runs side by side, and their addresses."""

    def __init__(
        self, code: SeriesCode, count: int, n: int, samples: int, segments: Schedule
    ):
        lanes = code.lanes
        groups = -(-count // lanes)
        program = code.program
        size, room = program.parameters + 1, program.room + 1
        self.memory, arrays = aligned(
            *(groups * lanes * rows for rows in (n, size)),
            lanes * room,
            groups * NUMBERS,
        )
        self.states = arrays[0].reshape(groups, n, lanes)
        parameters = arrays[1].reshape(groups, size, lanes)
        self.numbers = arrays[3].reshape(groups, NUMBERS)
        self.integers = np.zeros((groups, INTEGERS), dtype=np.int64)
        # behind the samples of a group is a row that is not read
        self.out = np.empty((groups, lanes * samples + 1, n))
        self.samples = self.out[:, :-1].reshape(groups, lanes, samples, n)
        # views of each run
        own = program.parameters
        self._starts = self.states.transpose(0, 2, 1)
        self._parameters = parameters[:, :own].transpose(0, 2, 1)
        self._first = self.samples[:, :, 0]
        self.time = self.numbers[:, series.TIME : series.TIME + lanes]
        self.status = self.integers[:, series.STATUS : series.STATUS + lanes]
        self.steps = self.integers[:, series.STEPS : series.STEPS + lanes]
        self.times = np.empty(samples)
        self.edges = np.empty(len(segments.edges))
        self.indices = np.zeros(max(1, len(segments.indices)), dtype=np.int64)
        self.values = np.empty(max(1, segments.values.size))
        of_all = (
            code.tables,
            arrays[2],
            self.times,
            self.edges,
            self.values,
            self.indices,
        )
        T, W, times, edges, values, indices = map(address_of, of_all)
        of_groups = self.states, parameters, self.out, self.numbers, self.integers
        begins = [address_of(array) for array in of_groups]
        self._calls = []
        for g in range(groups):
            steps = [g * array.strides[0] for array in of_groups]
            X, P, out, numbers, integers = map(sum, zip(begins, steps, strict=True))
            call = X, P, T, W, times, edges, values, out, numbers, indices, integers
            self._calls.append(call)
        self._entry = code.entry
        self._timed = program.timed
        self._shared: tuple[Any, Any] = None, None
        self.is_small = self.memory.size + self.out.size + self.values.size < MOST_KEPT

    def begin(
        self,
        starts: np.ndarray,
        parameters: np.ndarray,
        times: np.ndarray,
        segments: Schedule,
        options: Any,
    ) -> None:
        """Begin runs from states (m, n) with parameters (m, nP), the last repeated in a group."""
        if segments is not self._shared[0] or options is not self._shared[1]:
            self._shared = segments, options
            self._share(times, segments, options)
        numbers, integers = self._begun
        self.numbers[:] = numbers
        self.integers[:] = integers
        groups, lanes, n = self._starts.shape
        if groups * lanes > len(starts):
            members = np.minimum(np.arange(groups * lanes), len(starts) - 1)
            starts = starts[members]
            parameters = parameters[members]
        starts = starts.reshape(groups, lanes, n)
        self._first[:] = self._starts[:] = starts
        if own := parameters.shape[1]:
            self._parameters[:, :, :own] = parameters.reshape(groups, lanes, own)

    def _share(self, times: np.ndarray, segments: Schedule, options: Any) -> None:
        """Write what all runs share, and with which numbers they begin."""
        self.times[:] = times
        self.edges[:] = segments.edges
        self.indices[: len(segments.indices)] = segments.indices
        self.values[: segments.values.size] = segments.values.ravel()
        run = float(times[-1] - times[0])
        longest = min(options.max_step, run / PARTS if self._timed else run)
        numbers = np.zeros(NUMBERS)
        numbers[:3] = max(options.rtol, LEAST_RTOL), options.atol, longest
        numbers[series.TIME : series.SCALE] = times[0]
        first = options.first_step / series.GROWTH or FIRST_SHARE * min(run, longest)
        numbers[series.SCALE :] = first
        counts = len(times), len(segments.edges) - 1, len(segments.indices), CALL_STEPS
        integers = np.zeros(INTEGERS, dtype=np.int64)
        integers[:4] = counts
        integers[series.NEXT : series.STATUS] = 1
        self._begun = numbers, integers

    def go(self, progress: Callable[[float], None] | None = None) -> None:
        """Take the steps of all runs."""
        for call, status, time in zip(self._calls, self.status, self.time, strict=True):
            self._entry(*call)
            tries = 0
            while series.RUNNING in status.tolist():
                check()
                tries += CALL_STEPS
                if progress is not None:
                    progress(float(time.min()))
                if tries >= MOST_STEPS:
                    status[:] = series.FAILED
                    break
                self._entry(*call)

    def end(self, m: int) -> End:
        """Return where the series of a run has ended."""
        g, lane = divmod(m, self.time.shape[1])
        now = float(self.time[g, lane])
        # rates that vanish here must not choose the first step
        scale = float(self.numbers[g, series.SCALE + lane])
        opening = max(scale, LEAST_SHARE * (float(self.times[-1]) - now))
        return End(now, self.states[g, :, lane].copy(), opening)


class SeriesRuns:
    """Runs by series from states (m, n), side by side, as first legs of `NativeRun`s.

    `schedules` and `group` are as a `Batch` takes them.
    """

    def __init__(
        self,
        diagram: Any,
        starts: np.ndarray,
        parameters: np.ndarray,
        times: np.ndarray,
        schedules: list[Schedule],
        group: np.ndarray | None,
        options: Any,
        lanes: int = 1,
    ):
        self.ends: dict[int, End] = {}
        count, n = starts.shape
        self.results = finished(count, len(times), n)
        for k, segments in enumerate(schedules):
            members: Any = slice(None)
            if len(schedules) > 1:
                members = np.flatnonzero(group == k)
            own = starts[members]
            if not len(own):
                continue
            code = series_of(diagram, options.rtol, lanes if len(own) >= lanes else 1)
            self.label = f"Taylor {code.order}"
            shape = len(own), len(times), segments.values.shape
            arrays = code.kept.pop(shape, None)
            if arrays is None:
                arrays = SeriesArrays(code, len(own), n, len(times), segments)
            P = parameters[members, : len(diagram.layout.P)]
            arrays.begin(own, P, times, segments, options)
            arrays.go(options.progress)
            self._write(members, arrays)
            if arrays.is_small:
                keep(code.kept, shape, arrays)

    def _write(self, members: Any, arrays: SeriesArrays) -> None:
        """Write the samples and counts of arrays, and the ends of those that have not arrived."""
        states, status, _, counts = self.results
        m = len(status[members])
        states[members] = arrays.samples.reshape(-1, *states.shape[1:])[:m]
        counts[members, :2] = arrays.steps.reshape(-1, 1)[:m]
        counts[members, 2] = len(arrays.edges) - 1
        ended = np.flatnonzero(arrays.status.ravel()[:m] != series.ARRIVED)
        if len(ended):
            runs = np.arange(len(status))[members][ended].tolist()
            status[runs] = Status.SERIES_ENDED
            self.ends |= zip(runs, map(arrays.end, ended.tolist()), strict=True)
