"""Sliding: the run of a system whose rates lead back to switches from all sides.

On both sides of a switch g = 0 the rates lead back to it, as with dry friction or a relay.  In the
limit a run stays there, with the mean of the rates of both sides that does so (Filippov):

    x' = f_0 + w (f_1 - f_0),    g' = 0,    w = g'_0/(g'_0 - g'_1),    0 < w < 1

f_0 and f_1 are the rates on either side, g'_0 and g'_1 the derivative of g along them.  A run
slides until w leaves 0 ... 1, or to the next time at which rates jump.  Several decisions belong to
one switch if the slopes of their distances are parallel.  `active_switches` finds on which of
several switches a run slides, `sliding_rates` has their rates.

Source: Piiroinen, P. T., Kuznetsov, Y. A. (2008), An event-driven method to simulate Filippov
systems with accurate computing of sliding motions, ACM Trans. Math. Softw. 34(3).
"""

from collections.abc import Callable
from contextlib import suppress
from typing import Any, NamedTuple

import numpy as np
from numpy import ndarray

from ...base.errors import Uncompiled
from ..record.unread import Unread
from .active_switches import (
    SLIDES,
    Crossing,
    Refused,
    Sides,
    active_set,
    crossing_at,
    normals_of,
    sides_of,
)
from .batch import Batch
from .evaluation_pass import rounding
from .level_jumps import MOST_SOON, SHORT, jump_at_level, left_guard
from .schedule import Schedule
from .sliding_rates import NEGLIGIBLE, HeldSwitches
from .solver_layout import DECISION, DISTANCE, EVENT_INDEX, SAMPLE_POINTS, STATE, Status
from .termination import decision_name, stopped_at

MOST_IN_VAIN = 50  # batches of a run in a row, each shorter than SHORT of the run


class Sliding(NamedTuple):
    """A run on switches: a `NativeDiagram` with the mean of the rates, and its parameters."""

    runner: Any
    parameters: ndarray
    held: HeldSwitches
    state: ndarray  # with which it begins


Begin = Callable[[Any, ndarray, ndarray, ndarray, Schedule], Batch]


# --- runs that slide ------------------------------------------------------------------------------


def continued_ends(diagram: Any) -> list[int]:
    """Return the statuses of runs that may go on: on switches, or behind a level."""
    at_level = [Status.GUARD_LEFT] if diagram.resetting else []
    return [Status.CHATTERING, *at_level]


def continue_run(diagram: Any, batch: Batch, begin: Begin) -> None:
    """Continue a batch of one run of a `NativeDiagram` that ended on a switch or at a level.

    ``begin(diagram, parameters, state, times, segments)`` runs a batch up to its end.
    """
    times = batch.times
    run = times[-1] - times[0]
    current = batch
    in_vain = 0
    sliding: Sliding | None = None
    while True:
        last = current.continuations.get(0, current)
        following = _following(diagram, batch, last, sliding, in_vain)
        if following is None:
            break
        sliding, t, x = following
        if batch.level_jumps[-1:] == [t]:  # a sample at a jump is after it
            batch.out[0, (times >= t - rounding(t, run)) & (times <= t)] = x
        if t + rounding(t, run) >= times[-1]:
            batch.out[0, -1] = x
            batch.status[0], batch.reached[0] = Status.FINISHED, len(times)
            return
        short = t - current.times[0] <= SHORT * (times[-1] - times[0])
        in_vain = in_vain + 1 if short else 0
        current = _next_batch(diagram, batch, begin, sliding, t, x)
    if current is not batch:
        batch.continuations[0] = last
        batch.status[0] = last.status[0]
        batch.reached[0] = np.searchsorted(times, last.now, "right")
    at_level = last.status[0] == Status.GUARD_LEFT and _jumps(diagram, last)
    too_small = last.status[0] == Status.STEP_TOO_SMALL and in_vain
    if at_level or (too_small and batch.level_jumps):
        batch.status[0] = Status.ACCUMULATING


def _jumps(diagram: Any, batch: Batch) -> bool:
    """Return whether states jump where a batch stopped."""
    block = left_guard(diagram, batch)
    return block is not None and diagram.wiring.nodes[block].system.jumps_at_level


def _following(
    diagram: Any, batch: Batch, last: Batch, sliding: Sliding | None, in_vain: int
) -> tuple[Sliding | None, float, ndarray] | None:
    """Return how a run goes on: on which switches, when and with which state; None at its end."""
    status = last.status[0]
    t = last.now
    x = last.states[STATE, :, 0].copy()
    if status == Status.CHATTERING and in_vain < MOST_IN_VAIN:
        sliding, batch.refusal = enter(diagram, last, sliding)
        if sliding is None:
            return None
        batch.slides.append(t)
        return sliding, t, sliding.state
    if status == Status.GUARD_LEFT:
        block = left_guard(diagram, last)
        if block is None:
            t, x = stopped_at(last)
            remaining = leave(diagram, last, sliding)
            return remaining, t, x if remaining is None else remaining.state
        if _jumps(diagram, last) and in_vain < MOST_SOON:
            is_again = batch.level_jumps[-1:] == [last.times[0]]
            is_first = t == batch.times[0]
            jumped = jump_at_level(diagram, last, block, is_again, is_first)
            if jumped is None:
                return None
            batch.level_jumps.append(jumped[0])
            return None, *jumped
    if sliding is None:
        return None
    if status == Status.FINISHED and last.now < batch.times[-1]:
        return None, t, last.out[0, -1].copy()
    if status == Status.NOT_FINITE:  # another decision has made both sides the same
        return None, t, x
    return None


def _next_batch(
    diagram: Any,
    batch: Batch,
    begin: Begin,
    sliding: Sliding | None,
    t: float,
    x: ndarray,
) -> Batch:
    """Run the next batch, with or without sliding, and copy its samples into the first."""
    times = batch.times
    segments = batch.schedules[0].after(t)
    ahead = times[times > t]
    runner = diagram
    parameters = batch.runs.parameters[0]
    if sliding is not None:
        runner = sliding.runner
        parameters = sliding.parameters
        segments = _until_a_jump(segments)
        end = segments.edges[-2:-1]
        ahead = np.union1d(ahead[ahead < end], end)
    following = begin(runner, parameters, x, np.append(t, ahead), segments)
    reached_times = ahead[: following.reached[0] - 1]
    _, samples, indices = np.intersect1d(times, reached_times, return_indices=True)
    batch.out[0, samples] = following.out[0, 1 + indices]
    batch.counts += following.counts
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


# --- entering and leaving switches ----------------------------------------------------------------


def enter(
    diagram: Any, batch: Batch, sliding: Sliding | None
) -> tuple[Sliding | None, str]:
    """Return a run on the switches that a batch of one run crosses to and fro.

    Return None where its motion is not known, and a sentence on that if there is one.
    """
    state = batch.states[STATE, :, 0].copy()
    crossing = _crossing(diagram, batch, batch.now, state)
    count = diagram.code.program.decided
    before = batch.memory.P[diagram.decided_at :][:count]
    behind = batch.points[SAMPLE_POINTS, DECISION, :count]
    changed = before != behind
    chosen = changed | crossing.undecided & (np.abs(before) == 1.0)
    if sliding is not None:
        chosen[[*sliding.held.decisions]] = True
    try:
        sides = sides_of(crossing, crossing.switches(chosen, changed))
        state_of = active_set(sides)
    except Refused as refused:
        return None, _sentence(diagram, crossing, refused)
    return _sliding_on(diagram, batch, crossing, sides, state_of), ""


def leave(diagram: Any, batch: Batch, sliding: Sliding | None) -> Sliding | None:
    """Return the run on the switches that a batch, which left one of several, stays on.

    The guards of a share w are behind those of the diagram: w itself, then 1 - w.
    """
    k = int(batch.integers[EVENT_INDEX, 0]) - batch.callee.decided
    k -= diagram.code.program.guarded
    if sliding is None or not k < 2 * len(sliding.held.switches) > 2:
        return None
    t, state = stopped_at(batch)
    crossing = _crossing(diagram, batch, t, state)
    with suppress(Refused):
        sides = sides_of(crossing, [*sliding.held.switches])
        state_of = active_set(sides, {k // 2: k % 2})
        return _sliding_on(diagram, batch, crossing, sides, state_of)
    return None


def _crossing(diagram: Any, batch: Batch, t: float, state: ndarray) -> Crossing:
    """Return a point of a batch of one run, with the decisions that it holds."""
    P = batch.memory.P[: diagram.decided_at + diagram.code.program.decided]
    return crossing_at(diagram.callee(), batch.schedules[0], P, t, state)


def _sliding_on(
    diagram: Any, batch: Batch, crossing: Crossing, sides: Sides, state_of: ndarray
) -> Sliding | None:
    """Return a run on those of the switches that slide; None if no run slides."""
    # 1. one side of all switches is where the others are
    sliding = np.flatnonzero(state_of == SLIDES)
    if not len(sliding):
        return None
    held = HeldSwitches(tuple(sides.switches[k] for k in sliding))
    one_side = sides.decisions[0].copy()
    for k in np.flatnonzero(state_of == 1):
        decisions = [*sides.switches[k].decisions]
        one_side[decisions] = sides.decisions[1 + k, decisions]
    on_sides = np.tile(one_side, (1 + len(sliding) + (len(sliding) > 1), 1))
    for row, k in enumerate(sliding, 1):
        for flipped in {row, len(on_sides) - 1}:
            decisions = [*sides.switches[k].decisions]
            on_sides[flipped, decisions] = sides.decisions[1 + k, decisions]
    # 2. parameters with the decisions on the sides
    try:
        runner = diagram.in_form(held)
    except (Unread, Uncompiled):
        return None
    parameters = runner.parameters(batch.runs.parameters[0])
    offset = diagram.decided_at
    parameters[offset - 2 : offset] = batch.memory.P[offset - 2 : offset]
    parameters[offset : offset + on_sides.size] = on_sides.ravel()
    # 3. on the switches the shares are within bounds
    numbers = [switch.switch for switch in held.switches]
    moves = crossing.distance[numbers] @ normals_of(crossing, held.switches).T
    state = crossing.state - moves
    events = runner.callee().events_at(
        [crossing.time], state[None], crossing.segments, parameters
    )
    if not events[0, DISTANCE, diagram.code.program.decided :].min() > -NEGLIGIBLE:
        return None
    return Sliding(runner, parameters, held, state)


def _sentence(diagram: Any, crossing: Crossing, refused: Refused) -> str:
    """Return why the motion is not known, with each switch and the states that turn it."""
    nodes = diagram.sweep.nodes
    labels = [label for node in nodes for label in node.system.state_labels]
    names = []
    for held in refused.switches:
        turning = np.flatnonzero(crossing.slopes[: len(labels), held.switch])
        states = ", ".join(labels[k] for k in turning)
        program = diagram.code.program
        names.append(f"{decision_name(diagram.sweep, program, held.switch)} ({states})")
    remedies = Status.CHATTERING.sentence.partition(". ")[2]
    if len(names) == 1:
        return f"{names[0]} {Status.CHATTERING.sentence}"
    return (
        f"the run meets {len(names)} switches at once, which {refused}: "
        f"{', '.join(names)}. {remedies}"
    )
