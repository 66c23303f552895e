"""Runs of a compiled diagram, which the solver integrates in machine code."""

from dataclasses import replace
from functools import partial
from typing import Any

import numpy as np

from ...base.errors import SimulationError
from ..methods.method import Method
from ..methods.table import DISCRETE, IMPLICIT, METHODS, TAYLOR
from .batch import ANY, Batch
from .callee import MOST_KEPT, Callee, keep
from .filippov import continue_run, continued_ends
from .runner import PythonDiagram, RunOptions
from .schedule import Inputs, Schedule
from .series_runs import SeriesCode, series_solution
from .solver_layout import SIGNALS, Status
from .termination import STUCK, Solution, ended, sampled_start

FINISHED, CHATTERING = Status.FINISHED, Status.CHATTERING


class NativeRuns(PythonDiagram):
    """A compiled diagram whose runs the solver integrates.

    `callee` returns the functions that the solver calls, `over_kinks` what continues a run over
    many kinks, or None, and `unlocked` the diagram with decisions that change within a step.
    """

    callee: Any
    over_kinks: Any
    unlocked: Any
    kept: dict[Any, Batch]  # by shape, while no thread runs them
    kept_series: dict[Any, SeriesCode]
    _last_schedule: tuple = None, None  # times and inputs, and their schedule

    def implicit(self, inputs: Inputs | None = None) -> Callee:
        """Return the functions that the solver calls for its implicit method."""
        return self.callee(1, inputs, IMPLICIT)

    def _schedule(self, times: np.ndarray, inputs: Inputs | None) -> Schedule:
        """Return the segments of a run, the same for the same times and inputs.

        Breakpoints of blocks are looked up each time.
        """
        if self.breaking:
            return self.schedule(times, inputs)
        samples = () if inputs is None else inputs.samples
        arrays = times, *samples
        if sum(array.size for array in arrays) > MOST_KEPT:
            return self.schedule(times, inputs)
        key = [(array.shape, array.tobytes()) for array in arrays]
        last_key, schedule = self._last_schedule
        if key != last_key:
            schedule = self.schedule(times, inputs)
            self._last_schedule = key, schedule
        return schedule

    def _solution(
        self,
        start: np.ndarray,
        times: np.ndarray,
        inputs: Inputs | None,
        options: RunOptions,
    ) -> Solution:
        """Integrate, and once more without located switches if the first run is stuck on one."""
        if options.method == TAYLOR:
            return series_solution(self, start, times, inputs, options)
        batch = self._prepare(start, times, inputs, options)
        kinks = self.over_kinks(options.rtol, options.atol)
        self._integrate(batch, inputs, options, kinks)
        if batch.status[0] == CHATTERING and batch.continuations:
            # it slides among kinks that were passed: once more, with all located
            batch = self._prepare(start, times, inputs, options)
            self._integrate(batch, inputs, options)
        if batch.status[0] != FINISHED:
            self._continue_run(batch, inputs, options)
        if batch.callee.decided and batch.status[0] in STUCK:
            try:
                solution = self.unlocked()._solution(start, times, inputs, options)
            except SimulationError:
                pass  # the error is that of the first run
            else:
                return replace(
                    solution, method=f"{solution.method}, switches not located"
                )
        solution = ended(self, batch, inputs)
        solution.pieces = batch.schedules[0]
        if batch.is_small:
            solution.t = solution.t.copy()
            solution.x = solution.x.copy()
            of_run = batch.runs.parameters[0], batch.times, solution.pieces
            keep(self.kept, _shape_of(batch.callee, *of_run), batch)
        return solution

    def _prepare(
        self,
        start: np.ndarray,
        times: np.ndarray,
        inputs: Inputs | None,
        options: RunOptions,
    ) -> Batch:
        """Return the batch of a run at the first time, after blocks have sampled."""
        segments = self._schedule(times, inputs)
        callee = self.callee(1, inputs, self.method_of(options.method))
        P = self.parameters()
        start = sampled_start(callee, start, float(times[0]), segments, P)
        return self._batch(inputs, options, P, start, times, segments)

    def _batch(
        self,
        inputs: Inputs | None,
        options: RunOptions,
        P: np.ndarray,
        start: np.ndarray,
        times: np.ndarray,
        segments: Schedule,
    ) -> Batch:
        """Return a batch of one run at its first time."""
        callee = self.callee(1, inputs, self.method_of(options.method))
        steps = options.max_step, options.first_step
        batch = self.kept.pop(_shape_of(callee, P, times, segments), None)
        if batch is None:
            runs = start[None], P[None], times, [segments], None
            return Batch(callee, *runs, *steps)
        batch.begin_again(start, P, times, segments, *steps)
        return batch

    def _integrate(
        self,
        batch: Batch,
        inputs: Inputs | None,
        options: RunOptions,
        over_kinks: Any = None,
    ) -> None:
        """Integrate a batch of one run until it stops."""
        most = ANY if batch.callee.method.discrete else self.most
        implicit = None
        if options.method == "auto":
            implicit = partial(self.implicit, inputs)
        tolerances = options.rtol, options.atol
        batch.adaptive(*tolerances, options.progress, most, implicit, over_kinks)

    def _continue_run(
        self, batch: Batch, inputs: Inputs | None, options: RunOptions
    ) -> None:
        """Continue a run that slides on switches, or that jumps at a level."""

        def begin(
            diagram: NativeRuns,
            P: np.ndarray,
            start: np.ndarray,
            times: np.ndarray,
            segments: Schedule,
        ) -> Batch:
            following = diagram._batch(inputs, options, P, start, times, segments)
            diagram._integrate(following, inputs, options)
            return following

        if batch.status[0] in continued_ends(self):
            continue_run(self, batch, begin)

    def method_of(self, method: str = "auto") -> Method:
        """Return the method of a run."""
        return DISCRETE if self.wiring.dt else METHODS[method]

    def evaluated_signals(
        self, solution: Solution, inputs: Inputs | None
    ) -> np.ndarray:
        """Return all block outputs at a solution's times, finite or not."""
        if solution.signals is not None:
            return solution.signals
        segments = self.segments_of(solution, inputs)
        return self.callee(1, inputs).evaluate(
            SIGNALS, solution.t, solution.x, segments, self.parameters(), self.nsignals
        )


def _shape_of(
    callee: Callee, P: np.ndarray, times: np.ndarray, segments: Schedule
) -> tuple:
    """Return all that arrays of a run depend on."""
    return callee.method, P.shape, times.shape, segments.values.shape
