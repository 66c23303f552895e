"""A run: its legs, and what follows where one has stopped.

A leg is a program, a method and parameters, from a time and a state on.  It ends with a status.
`FOLLOWING` has a function for each status after which a run may go on: by another method
(equations are stiff, a series has ended), on switches and off them (`filippov`),
or behind the jumps at a level (`level_jumps`).
"""

from collections.abc import Callable
from contextlib import suppress
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy import ndarray

from ...base.errors import SimulationError
from ..methods import IMPLICIT, TAYLOR, Method
from .batch import Batch, batch_of
from .evaluation_pass import rounding
from .inputs import Inputs
from .lsoda import LSODA, LsodaBatch
from .schedule import Schedule
from .solver_layout import STATE, Results, Status
from .termination import STUCK, Solution, ended, stopped_at

if TYPE_CHECKING:
    from .filippov import Sliding

MOST_SOON = 30  # jumps in a row, each sooner after the other than `SHORT` of the run
MOST_IN_VAIN = 50  # legs of a run in a row, each shorter than SHORT of the run
SHORT = 1e-7


class Leg(NamedTuple):
    """The beginning of a leg, and what runs from there on."""

    program: Any  # a `Runner`
    method: Method
    parameters: ndarray
    time: float
    state: ndarray
    sliding: "Sliding | None" = None  # the switches that it slides on
    opening: float = 0.0  # the first step, or 0

    @property
    def label(self) -> str:
        """The name of what integrates."""
        return self.method.name


def may_go_on(diagram: Any) -> list[Status]:
    """Return the statuses of first legs that others may follow."""
    at_level = [Status.GUARD_LEFT] if diagram.resetting else []
    switching = [Status.CHATTERING, *STUCK] if diagram.code.program.decided else []
    return [Status.STIFF, Status.SERIES_ENDED, *at_level, *switching]


class NativeRun:
    """One run of a diagram, from a state with parameters P.

    Attributes
    ----------
    results : Results
        States, status and counts of the run, a row of those of its first leg.
    leg, last : Leg, Batch
        The last leg, and its arrays.
    end : End or None
        Where that was left to another method or program.
    begun : float
        The time at which it began with its first method.
    """

    def __init__(
        self,
        diagram: Any,
        start: ndarray,
        P: ndarray,
        times: ndarray,
        segments: Schedule,
        options: Any,
    ):
        self.diagram, self.start, self.parameters = diagram, start, P
        self.times, self.segments, self.options = times, segments, options
        self.method = diagram.method_of(options.method)
        self.locates = True  # switches
        self.labels: list[tuple[float, str]] = []  # what integrated, and since when
        self.slides: list[float] = []  # times at which it began to slide
        self.level_jumps: list[float] = []  # their times
        self.refusal = ""  # why it does not slide
        self.in_vain = 0  # legs in a row that were too short

    def solution(self, inputs: Inputs) -> Solution:
        """Integrate, and keep the arrays of the first leg for another run."""
        first = self.first_leg()
        run = self.go_on(first)
        results = run.results
        steps, evaluations, restarts, _ = results.counts[0].tolist()
        counts = {"steps": steps, "evaluations": evaluations, "restarts": restarts}
        solution = Solution(self.times, results.states[0], statistics=counts)
        solution.engine, solution.method = self.diagram.engine, run.description
        if run.status != Status.FINISHED:
            solution = ended(run, solution, inputs)
        solution.pieces = self.segments
        if isinstance(first, Batch):
            solution.t = solution.t.copy()
            solution.x = solution.x.copy()
            first.release()
        return solution

    @property
    def status(self) -> int:
        """The number of a `Status`."""
        return int(self.results.status[0])

    @property
    def description(self) -> str:
        """The methods that integrated, and since when."""
        (_, words), *others = self.labels
        if self.slides:
            words += f", sliding on a switch from t = {self.slides[0]:.9g}"
        else:
            words += "".join(f", from t = {t:.9g} {other}" for t, other in others)
        if not self.locates:
            words += ", switches not located"
        if self.level_jumps:
            words += f", {len(self.level_jumps)} jumps at levels"
        return words

    def first_leg(self) -> Any:
        """Run the first leg, a `Batch` or `SeriesRuns`."""
        if self.options.method == TAYLOR:
            from .series_runs import SeriesRuns

            run = self.start[None], self.parameters[None], self.times, [self.segments]
            return SeriesRuns(self.diagram, *run, None, self.options)
        leg = self._leg(float(self.times[0]), self.start)
        return self._batch(leg, self.times, self.segments)

    def go_on(self, first: Any, m: int = 0) -> "NativeRun":
        """Go on where run `m` of a first leg has stopped; return the run with all results."""
        self.results = Results(*[array[m : m + 1] for array in first.results])
        self.labels.append((float(self.times[0]), first.label))
        if self.status == Status.FINISHED:
            return self
        self.last, self.end = first, first.ends.get(m)
        self.leg = self._leg(float(self.times[0]), self.start)
        self.begun = self.leg.time
        self._append_legs()
        if self.status == Status.FINISHED and self.last is not first:
            self.last.release()
        if self.diagram.code.program.decided and self.status in STUCK:
            # it is stuck: once more, without located switches
            with suppress(SimulationError):  # the error is that of the first run
                program = self.diagram.in_form(locking=False)
                P = program.parameters(self.parameters)
                whole = self.start, P, self.times, self.segments, self.options
                free = NativeRun(program, *whole)
                free.locates = False
                free = free.go_on(free.first_leg())
                if free.status in (Status.FINISHED, Status.GUARD_LEFT):
                    return free
        return self

    def _append_legs(self) -> None:
        """Append legs until the run has ended."""
        times, results = self.times, self.results
        run = times[-1] - times[0]
        while True:
            following = FOLLOWING.get(self.status)
            leg = following and following(self)
            if leg is None:
                break
            t, x = leg.time, leg.state
            if self.level_jumps[-1:] == [t]:  # a sample at a jump is after it
                at_jump = (times >= t - rounding(t, run)) & (times <= t)
                results.states[0, at_jump] = x
            if t + rounding(t, run) >= times[-1]:
                results.states[0, -1] = x
                results.status[0], results.reached[0] = Status.FINISHED, len(times)
                return
            if self.end is None:
                is_short = t - self.begun <= SHORT * run
                self.in_vain = self.in_vain + 1 if is_short else 0
                self.begun = t
            self._run(leg)
        at_level = self.status == Status.GUARD_LEFT and self._jumps()
        too_small = self.status == Status.STEP_TOO_SMALL and self.in_vain
        if at_level or (too_small and self.level_jumps):
            results.status[0] = Status.ACCUMULATING

    def _jumps(self) -> bool:
        """Return whether states jump where the last leg stopped."""
        from .level_jumps import left_guard

        block = left_guard(self.diagram, self.last)
        nodes = self.diagram.wiring.nodes
        return block is not None and nodes[block].system.jumps_at_level

    def _run(self, leg: Leg) -> None:
        """Run a leg, up to a jump if it slides, and write its samples into the results."""
        segments = self.segments.after(leg.time)
        ahead = self.times[self.times > leg.time]
        if leg.sliding is not None:
            segments = _until_a_jump(segments)
            end = segments.edges[-2:-1]
            ahead = np.union1d(ahead[ahead < end], end)
        self.leg = leg
        self.last = self._batch(leg, np.append(leg.time, ahead), segments)
        self.end = self.last.ends.get(0)
        self.last.write_into(self.results, self.times)
        if leg.label not in [label for _, label in self.labels]:
            self.labels.append((leg.time, leg.label))

    def _batch(self, leg: Leg, times: ndarray, segments: Schedule) -> Batch:
        """Return a batch of a leg, which went on until it stopped."""
        options, P = self.options, leg.parameters
        if leg.method is LSODA:
            runs = leg.program.implicit(), leg.state[None], P[None], times, [segments]
            batch: Batch = LsodaBatch(*runs, None, options.max_step)
        else:
            callee = leg.program.callee(1, leg.method)
            at = leg.state, P, times, segments
            batch = batch_of(callee, *at, options.max_step, leg.opening)
        batch.finish(options, leg.program.most, leg.program.implicit)
        return batch

    # --- what follows a status ------------------------------------------------------------

    def _leg(self, t: float, x: ndarray, sliding: "Sliding | None" = None) -> Leg:
        """Return a leg with the method of the run."""
        program, P = self.diagram, self.parameters
        if sliding is not None:
            program, P = sliding.runner, sliding.parameters
        opening = self.options.first_step
        return Leg(program, self.method, P, t, x, sliding, opening)

    def _from_end(self, **changed: Any) -> Leg:
        """Return a leg from where the last one was left, with something else changed."""
        time, state, opening = self.end
        return self.leg._replace(time=time, state=state, opening=opening, **changed)

    def by_implicit_method(self) -> Leg:
        """Go on by Rodas5P: the equations are stiff; in Python by LSODA if nothing happens."""
        diagram, is_again = self.diagram, self.leg.method is LSODA
        happens = diagram.sweep.guarded or diagram.layout.jumps or is_again
        is_plain = len(self.segments.edges) == 2 and not happens
        in_python = diagram.engine == "python"
        return self._from_end(method=LSODA if in_python and is_plain else IMPLICIT)

    def onto_switches(self) -> Leg | None:
        """Go on on the switches that a leg crossed to and fro."""
        from .filippov import enter

        if self.in_vain >= MOST_IN_VAIN:
            return None
        sliding, self.refusal = enter(self.diagram, self.last, self.leg.sliding)
        if sliding is None:
            return None
        self.slides.append(self.last.now)
        return self._leg(self.last.now, sliding.state, sliding)

    def behind_a_guard(self) -> Leg | None:
        """Go on off one of the switches, or after the jumps at a level."""
        from .filippov import leave
        from .level_jumps import jump_at_level, left_guard

        last = self.last
        block = left_guard(self.diagram, last)
        if block is None:
            t, x = stopped_at(last)
            remaining = leave(self.diagram, last, self.leg.sliding)
            return self._leg(t, x if remaining is None else remaining.state, remaining)
        if not self._jumps() or self.in_vain >= MOST_SOON:
            return None
        is_again = self.level_jumps[-1:] == [last.times[0]]
        is_first = last.now == self.times[0]
        jumped = jump_at_level(self.diagram, last, block, is_again, is_first)
        if jumped is None:
            return None
        self.level_jumps.append(jumped[0])
        return self._leg(*jumped)

    def at_a_known_stop(self) -> Leg | None:
        """Go on without sliding where rates jump."""
        last = self.last
        if self.leg.sliding is None or last.now >= self.times[-1]:
            return None
        return self._leg(last.now, last.out[0, -1].copy())

    def off_equal_sides(self) -> Leg | None:
        """Go on without sliding where another decision has made both sides the same."""
        if self.leg.sliding is None:
            return None
        return self._leg(self.last.now, self.last.states[STATE, :, 0].copy())


FOLLOWING: dict[int, Callable[[NativeRun], Leg | None]] = {
    Status.STIFF: NativeRun.by_implicit_method,
    Status.SERIES_ENDED: NativeRun._from_end,  # by steps of DOP853
    Status.CHATTERING: NativeRun.onto_switches,
    Status.GUARD_LEFT: NativeRun.behind_a_guard,
    Status.FINISHED: NativeRun.at_a_known_stop,
    Status.NOT_FINITE: NativeRun.off_equal_sides,
}


def _until_a_jump(segments: Schedule) -> Schedule:
    """Return segments up to the first at whose beginning rates jump.

    Where inputs bend, the rates on a switch jump too: each segment begins anew.
    """
    jumps = np.flatnonzero(segments.smooth[1:-1] == 0)
    count = 1 + int(jumps[0]) if len(jumps) else len(segments.edges) - 1
    return segments._replace(
        edges=np.append(segments.edges[:count], np.inf),
        values=segments.values[: count + 1],
        smooth=np.zeros_like(segments.smooth[: count + 1]),
    )
