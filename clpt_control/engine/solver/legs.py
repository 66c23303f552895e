"""Legs of a run: what follows where machine code has stopped.

A leg is a batch of one run: a form of the diagram with its parameters, from a time and a state on.
It ends with a status.  `FOLLOWING` has a function for each status after which a run may go on: on
switches and off them (`filippov`), or behind the jumps at a level (`level_jumps`).
"""

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
from numpy import ndarray

from .batch import Batch
from .evaluation_pass import rounding
from .filippov import Sliding, enter, leave
from .level_jumps import MOST_SOON, SHORT, jump_at_level, left_guard
from .schedule import Schedule
from .solver_layout import STATE, Status
from .termination import stopped_at

MOST_IN_VAIN = 50  # legs of a run in a row, each shorter than SHORT of the run

Begin = Callable[[Any, ndarray, ndarray, ndarray, Schedule], Batch]


class Stop(NamedTuple):
    """Where a leg of a run has ended."""

    diagram: Any  # a `NativeDiagram`
    first: Batch  # the first leg, with the results of the whole run
    last: Batch
    sliding: Sliding | None  # of the last leg
    in_vain: int  # legs in a row that were too short
    time: float
    state: ndarray


class Start(NamedTuple):
    """Where the next leg begins: on switches if it is sliding."""

    sliding: Sliding | None
    time: float
    state: ndarray


def may_go_on(diagram: Any) -> list[int]:
    """Return the statuses of first legs that others may follow."""
    at_level = [Status.GUARD_LEFT] if diagram.resetting else []
    return [Status.CHATTERING, *at_level]


def go_on(diagram: Any, first: Batch, begin: Begin) -> None:
    """Append legs to the first one, which ended on a switch or at a level.

    ``begin(diagram, parameters, state, times, segments)`` runs a batch up to its end.
    """
    times = first.times
    run = times[-1] - times[0]
    leg = first
    in_vain = 0
    sliding: Sliding | None = None
    while True:
        last = leg.continuations.get(0, leg)
        state = last.states[STATE, :, 0].copy()
        stop = Stop(diagram, first, last, sliding, in_vain, last.now, state)
        following = FOLLOWING.get(int(last.status[0]))
        start = following and following(stop)
        if start is None:
            break
        sliding, t, x = start
        if first.level_jumps[-1:] == [t]:  # a sample at a jump is after it
            first.out[0, (times >= t - rounding(t, run)) & (times <= t)] = x
        if t + rounding(t, run) >= times[-1]:
            first.out[0, -1] = x
            first.status[0], first.reached[0] = Status.FINISHED, len(times)
            return
        is_short = t - leg.times[0] <= SHORT * run
        in_vain = in_vain + 1 if is_short else 0
        leg = _next_leg(diagram, first, begin, start)
    if leg is not first:
        first.continuations[0] = last
        first.status[0] = last.status[0]
        first.reached[0] = np.searchsorted(times, last.now, "right")
    at_level = last.status[0] == Status.GUARD_LEFT and _jumps(diagram, last)
    too_small = last.status[0] == Status.STEP_TOO_SMALL and in_vain
    if at_level or (too_small and first.level_jumps):
        first.status[0] = Status.ACCUMULATING


def _onto_switches(stop: Stop) -> Start | None:
    """Begin on the switches that a leg crossed to and fro."""
    if stop.in_vain >= MOST_IN_VAIN:
        return None
    sliding, stop.first.refusal = enter(stop.diagram, stop.last, stop.sliding)
    if sliding is None:
        return None
    stop.first.slides.append(stop.time)
    return Start(sliding, stop.time, sliding.state)


def _behind_a_guard(stop: Stop) -> Start | None:
    """Begin off one of the switches, or after the jumps at a level."""
    block = left_guard(stop.diagram, stop.last)
    if block is None:
        t, x = stopped_at(stop.last)
        remaining = leave(stop.diagram, stop.last, stop.sliding)
        return Start(remaining, t, x if remaining is None else remaining.state)
    if not _jumps(stop.diagram, stop.last) or stop.in_vain >= MOST_SOON:
        return None
    is_again = stop.first.level_jumps[-1:] == [stop.last.times[0]]
    is_first = stop.time == stop.first.times[0]
    jumped = jump_at_level(stop.diagram, stop.last, block, is_again, is_first)
    if jumped is None:
        return None
    stop.first.level_jumps.append(jumped[0])
    return Start(None, *jumped)


def _off_all_switches(stop: Stop) -> Start | None:
    """Begin without sliding where rates jump, or where both sides have become the same."""
    if stop.sliding is None:
        return None
    if stop.last.status[0] == Status.NOT_FINITE:
        return Start(None, stop.time, stop.state)
    if stop.time < stop.first.times[-1]:
        return Start(None, stop.time, stop.last.out[0, -1].copy())
    return None


FOLLOWING: dict[int, Callable[[Stop], Start | None]] = {
    Status.CHATTERING: _onto_switches,
    Status.GUARD_LEFT: _behind_a_guard,
    Status.FINISHED: _off_all_switches,
    Status.NOT_FINITE: _off_all_switches,
}


def _jumps(diagram: Any, batch: Batch) -> bool:
    """Return whether states jump where a batch stopped."""
    block = left_guard(diagram, batch)
    return block is not None and diagram.wiring.nodes[block].system.jumps_at_level


def _next_leg(diagram: Any, first: Batch, begin: Begin, start: Start) -> Batch:
    """Run the next leg, with or without sliding, and copy its samples into the first."""
    sliding, t, x = start
    times = first.times
    segments = first.schedules[0].after(t)
    ahead = times[times > t]
    runner = diagram
    parameters = first.runs.parameters[0]
    if sliding is not None:
        runner = sliding.runner
        parameters = sliding.parameters
        segments = _until_a_jump(segments)
        end = segments.edges[-2:-1]
        ahead = np.union1d(ahead[ahead < end], end)
    following = begin(runner, parameters, x, np.append(t, ahead), segments)
    reached_times = ahead[: following.reached[0] - 1]
    _, samples, indices = np.intersect1d(times, reached_times, return_indices=True)
    first.out[0, samples] = following.out[0, 1 + indices]
    first.counts += following.counts
    return following


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
