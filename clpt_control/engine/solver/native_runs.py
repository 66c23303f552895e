"""Runs of a compiled diagram, which the solver integrates in machine code."""

from contextlib import suppress
from dataclasses import replace
from typing import Any

import numpy as np

from ...base.errors import SimulationError
from .batch import ANY, Batch
from .callee import Callee, keep
from .filippov import continue_run, continued_ends
from .runner import RunOptions
from .schedule import Inputs, Schedule
from .solver_layout import Status
from .termination import STUCK, Solution, ended, sampled_start


class NativeRun:
    """One run of a `NativeDiagram`.

    A leg of the run is a batch with one form of the diagram, which begins where another leg ended.
    """

    def __init__(
        self,
        diagram: Any,
        times: np.ndarray,
        inputs: Inputs | None,
        options: RunOptions,
    ):
        self.diagram, self.times = diagram, times
        self.inputs, self.options = inputs, options
        self.segments = diagram.schedule(times, inputs)
        self.method = diagram.method_of(options.method)

    def solution(self, start: np.ndarray) -> Solution:
        """Integrate, and once more without located switches if the run is stuck on one."""
        diagram, options = self.diagram, self.options
        # 1. the first leg: all switches are located, but many kinks
        callee = diagram.callee(1, self.method)
        P = diagram.parameters()
        begin = sampled_start(callee, start, float(self.times[0]), self.segments, P)
        whole = diagram, P, begin, self.times, self.segments
        batch = self.leg(*whole, diagram.over_kinks(options.rtol, options.atol))
        if batch.status[0] == Status.CHATTERING and batch.continuations:
            # it slides among kinks that were passed: once more, with all located
            batch = self.leg(*whole)
        # 2. legs on switches, and behind levels
        if batch.status[0] in continued_ends(diagram):
            continue_run(diagram, batch, self.leg)
        # 3. a run that is stuck, without located switches
        if callee.decided and batch.status[0] in STUCK:
            with suppress(SimulationError):  # the error is that of the first run
                free = diagram.unlocked()
                solution = free.solve(start, self.times, self.inputs, options)
                method = f"{solution.method}, switches not located"
                return replace(solution, method=method)
        # 4. the end, and the arrays for another run
        solution = ended(diagram, batch, self.inputs)
        solution.pieces = self.segments
        if batch.is_small:
            solution.t = solution.t.copy()
            solution.x = solution.x.copy()
            shape = _shape_of(batch.callee, P, self.times, self.segments)
            keep(diagram.kept, shape, batch)
        return solution

    def leg(
        self,
        diagram: Any,
        P: np.ndarray,
        start: np.ndarray,
        times: np.ndarray,
        segments: Schedule,
        over_kinks: Any = None,
    ) -> Batch:
        """Return a batch of one run of a form of the diagram, which went on until it stopped."""
        options = self.options
        callee = diagram.callee(1, self.method)
        steps = options.max_step, options.first_step
        batch = diagram.kept.pop(_shape_of(callee, P, times, segments), None)
        if batch is None:
            batch = Batch(callee, start[None], P[None], times, [segments], None, *steps)
        else:
            batch.begin_again(start, P, times, segments, *steps)
        most = ANY if self.method.discrete else diagram.most
        implicit = diagram.implicit if options.method == "auto" else None
        batch.adaptive(options.rtol, options.atol, options.progress, most, implicit, over_kinks)
        return batch


def _shape_of(
    callee: Callee, P: np.ndarray, times: np.ndarray, segments: Schedule
) -> tuple:
    """Return all that arrays of a run depend on."""
    return callee.method, P.shape, times.shape, segments.values.shape
