"""Legs of a run: what follows where machine code has stopped.

A leg is a batch of one run: a form of the diagram with its parameters, from a time and a state on.
It ends with a status.  `FOLLOWING` has a function for each status after which a run may go on: on
switches and off them (`filippov`), or behind the jumps at a level (`level_jumps`).
"""

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy import ndarray

from .batch import Batch
from .evaluation_pass import rounding
from .filippov import Sliding, enter, leave
from .level_jumps import MOST_SOON, SHORT, jump_at_level, left_guard
from .schedule import Schedule
from .solver_layout import STATE, Status
from .termination import STUCK, stopped_at

MOST_IN_VAIN = 50  # legs of a run in a row, each shorter than SHORT of the run

Begin = Callable[[Any, ndarray, ndarray, ndarray, Schedule], Batch]
Start = tuple[Sliding | None, float, ndarray]  # of a leg: its switches, time and state


def may_go_on(diagram: Any) -> list[Status]:
    """Return the statuses of first legs that others may follow."""
    at_level = [Status.GUARD_LEFT] if diagram.resetting else []
    switching = [Status.CHATTERING, *STUCK] if diagram.code.program.decided else []
    return at_level + switching


class Legs:
    """The legs of a run of a `NativeDiagram`; results are written into the first one.

    ``begin(diagram, parameters, state, times, segments)`` runs a batch up to its end.
    """

    def __init__(self, diagram: Any, first: Batch, begin: Begin):
        self.diagram, self.first, self.begin = diagram, first, begin
        self.last = first
        self.sliding: Sliding | None = None  # of the last leg
        self.in_vain = 0  # legs in a row that were too short

    def go_on(self) -> None:
        """Append legs until the run has ended."""
        first, leg = self.first, self.first
        times = first.times
        run = times[-1] - times[0]
        while True:
            self.last = last = leg.continuations.get(0, leg)
            following = FOLLOWING.get(int(last.status[0]))
            start = following and following(self)
            if start is None:
                break
            self.sliding, t, x = start
            if first.level_jumps[-1:] == [t]:  # a sample at a jump is after it
                first.out[0, (times >= t - rounding(t, run)) & (times <= t)] = x
            if t + rounding(t, run) >= times[-1]:
                first.out[0, -1] = x
                first.status[0], first.reached[0] = Status.FINISHED, len(times)
                return
            is_short = t - leg.times[0] <= SHORT * run
            self.in_vain = self.in_vain + 1 if is_short else 0
            leg = self._next_leg(t, x)
        if leg is not first:
            first.continuations[0] = last
        at_level = last.status[0] == Status.GUARD_LEFT and self._jumps()
        too_small = last.status[0] == Status.STEP_TOO_SMALL and self.in_vain
        if at_level or (too_small and first.level_jumps):
            first.status[0] = Status.ACCUMULATING

    def _jumps(self) -> bool:
        """Return whether states jump where the last leg stopped."""
        block = left_guard(self.diagram, self.last)
        nodes = self.diagram.wiring.nodes
        return block is not None and nodes[block].system.jumps_at_level

    def _next_leg(self, t: float, x: ndarray) -> Batch:
        """Run the next leg, with or without sliding, and copy its samples into the first."""
        first, sliding = self.first, self.sliding
        times = first.times
        segments = first.schedules[0].after(t)
        ahead = times[times > t]
        runner, parameters = self.diagram, first.runs.parameters[0]
        if sliding is not None:
            runner, parameters = sliding.runner, sliding.parameters
            segments = _until_a_jump(segments)
            end = segments.edges[-2:-1]
            ahead = np.union1d(ahead[ahead < end], end)
        leg = self.begin(runner, parameters, x, np.append(t, ahead), segments)
        leg.write_into(first.results, times)
        return leg

    # --- what follows a status ------------------------------------------------------------

    def onto_switches(self) -> Start | None:
        """Begin on the switches that a leg crossed to and fro."""
        if self.in_vain >= MOST_IN_VAIN:
            return None
        sliding, self.first.refusal = enter(self.diagram, self.last, self.sliding)
        if sliding is None:
            return None
        self.first.slides.append(self.last.now)
        return sliding, self.last.now, sliding.state

    def behind_a_guard(self) -> Start | None:
        """Begin off one of the switches, or after the jumps at a level."""
        first, last = self.first, self.last
        block = left_guard(self.diagram, last)
        if block is None:
            t, x = stopped_at(last)
            remaining = leave(self.diagram, last, self.sliding)
            return remaining, t, x if remaining is None else remaining.state
        if not self._jumps() or self.in_vain >= MOST_SOON:
            return None
        is_again = first.level_jumps[-1:] == [last.times[0]]
        is_first = last.now == first.times[0]
        jumped = jump_at_level(self.diagram, last, block, is_again, is_first)
        if jumped is None:
            return None
        first.level_jumps.append(jumped[0])
        return None, *jumped

    def at_a_known_stop(self) -> Start | None:
        """Begin without sliding where rates jump."""
        last = self.last
        if self.sliding is None or last.now >= self.first.times[-1]:
            return None
        return None, last.now, last.out[0, -1].copy()

    def off_equal_sides(self) -> Start | None:
        """Begin without sliding where another decision has made both sides the same."""
        if self.sliding is None:
            return None
        return None, self.last.now, self.last.states[STATE, :, 0].copy()


FOLLOWING: dict[int, Callable[[Legs], Start | None]] = {
    Status.CHATTERING: Legs.onto_switches,
    Status.GUARD_LEFT: Legs.behind_a_guard,
    Status.FINISHED: Legs.at_a_known_stop,
    Status.NOT_FINITE: Legs.off_equal_sides,
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
