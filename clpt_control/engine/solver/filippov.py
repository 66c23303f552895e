"""Sliding on a switch: the run of a system whose rates lead back to a switch from both sides.

On both sides of a switch g = 0 the rates lead back to it, as with dry friction or a relay.  In the
limit a run stays there, with the mean of the rates of both sides that does so (Filippov):

    x' = f_0 + w (f_1 - f_0),    g' = 0,    w = g'_0/(g'_0 - g'_1),    0 < w < 1

f_0 and f_1 are the rates on either side, g'_0 and g'_1 the derivative of g along them.  A run
slides until w leaves 0 ... 1, or to the next time at which rates jump.  Several decisions belong to
one switch if the slopes of their distances are parallel.  On two switches at once the motion is
not known: the run ends with a sentence.

Source: Filippov, A. F. (1988), Differential Equations with Discontinuous Righthand Sides, Kluwer,
section 4; Piiroinen, P. T., Kuznetsov, Y. A. (2008), An event-driven method to simulate Filippov
systems with accurate computing of sliding motions, ACM Trans. Math. Softw. 34(3).
"""

from collections.abc import Callable, Iterable
from math import prod
from typing import Any, NamedTuple

import numpy as np
from numpy import ndarray

from ...base.errors import Uncompiled
from ..codegen.switching_conditions import Port
from ..record.derivative import Direction
from ..record.graph import reached
from ..trace.arrays import Unread, operand
from ..trace.elementwise import spread
from .batch import Batch
from .schedule import Schedule
from .solver_layout import (
    DECISION,
    DERIVATIVE,
    DISTANCE,
    ROUNDING,
    SAMPLE_POINTS,
    STATE,
    TRIAL_SIZE,
    Status,
)
from .termination import state_within, stopped_at

NEGLIGIBLE = 1e-6  # share of rates that counts as nothing
TINY = 1e-30
PARALLEL = 1e-4  # share of a slope that may stand out of the others
NEAR = 1e3  # rounding errors of a distance within which a decision is about to change
MOST_IN_VAIN = 50  # batches of a run in a row, each shorter than SHORT of the run
SHORT = 1e-7
STATE_CHANGE = 1e-6  # relative, for the slopes of distances


class HeldSwitch(NamedTuple):
    """Decisions that change on one switch, and the one whose distance is its g."""

    decisions: tuple[int, ...]
    switch: int


class Sliding(NamedTuple):
    """A run on a switch: a `NativeDiagram` with the mean of the rates, and its parameters."""

    runner: Any
    parameters: ndarray


Begin = Callable[[Any, ndarray, ndarray, ndarray, Schedule], Batch]


# --- runs that slide ------------------------------------------------------------------------------


def continue_on_switch(diagram: Any, batch: Batch, begin: Begin) -> None:
    """Continue a batch of one run of a `NativeDiagram` that ended on a switch.

    ``begin(diagram, parameters, state, times, segments)`` runs a batch up to its end.
    """
    times = batch.times
    current = batch
    in_vain = 0
    sliding: Sliding | None = None
    while True:
        last = current.continuations.get(0, current)
        status = last.status[0]
        t = last.now
        x = last.states[STATE, :, 0].copy()
        # 1. enter or leave the switch, or end
        if status == Status.CHATTERING and sliding is None and in_vain < MOST_IN_VAIN:
            sliding = enter(diagram, last)
            if sliding is None:
                break
            batch.slides.append(t)
        elif sliding is not None and status == Status.GUARD_LEFT:
            sliding = None
            t, x = stopped_at(last)
        elif sliding is not None and status == Status.FINISHED and last.now < times[-1]:
            sliding = None
            x = last.out[0, -1].copy()
        elif sliding is not None and status == Status.NOT_FINITE:
            sliding = None  # another decision has made both sides the same
        else:
            break
        # 2. samples within the step that was not taken
        for k in np.flatnonzero((times > last.now) & (times <= t)):
            share = (times[k] - last.now) / last.lane[TRIAL_SIZE, 0]
            batch.out[0, k] = state_within(last, share) if sliding is None else x
        span = times[-1] - times[0]
        short = t - current.times[0] <= SHORT * span
        in_vain = in_vain + 1 if short else 0
        # 3. the next batch, and its samples
        current = _next_batch(diagram, batch, begin, sliding, t, x)
    if current is not batch:
        batch.continuations[0] = last
        batch.status[0] = last.status[0]
        batch.reached[0] = np.searchsorted(times, last.now, "right")


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
    count = len(segments.edges) - 1
    if len(jumps):
        count = 1 + int(jumps[0])
    return Schedule(
        edges=np.append(segments.edges[:count], np.inf),
        indices=segments.indices,
        values=segments.values[: count + 1],
        smooth=np.zeros_like(segments.smooth[: count + 1]),
    )


# --- entering a switch ----------------------------------------------------------------------------


class Crossing(NamedTuple):
    """The point at which a run crosses a switch to and fro."""

    time: float
    state: ndarray
    undecided: ndarray  # decisions that are about to change
    slopes: ndarray  # of the distances of all decisions, (states, decisions)
    rates: ndarray

    def parallel_to(self, decision: int, candidates: Iterable[int]) -> list[int]:
        """Return the candidates that change where a decision does: their slopes are parallel."""
        candidates = [*candidates]
        slope = self.slopes[:, [decision]]
        slopes = self.slopes[:, candidates]
        shares, *_ = np.linalg.lstsq(slope, slopes, rcond=None)
        perpendicular = np.linalg.norm(slopes - slope @ shares, axis=0)
        steepness = np.linalg.norm(slopes, axis=0)
        parallel = perpendicular <= PARALLEL * steepness
        return [*np.compress(parallel, candidates)]

    def both_sides(self, decision: int) -> ndarray:
        """Return states on both sides of where a decision changes."""
        slope = self.slopes[:, decision]
        normal = slope / np.sum(slope**2)
        return self.state + 1e-8 * np.outer([1.0, -1.0], normal)


def enter(diagram: Any, batch: Batch) -> Sliding | None:
    """Return a run on the switch that a batch of one run crosses to and fro, or None."""
    crossing = _crossing(diagram, batch)
    # 1. decisions before and behind the crossing
    count = diagram.code.program.decided
    before = batch.memory.P[diagram.decided_at :][:count]
    behind = batch.points[SAMPLE_POINTS, DECISION, :count]
    changed = before != behind
    undecided = np.isin(np.arange(count), crossing.undecided)
    changing = undecided & (np.abs(before) == 1.0)
    candidates = np.flatnonzero(changed | changing).tolist()
    # 2. a switch of those that changed, the steepest first
    steepness = np.linalg.norm(crossing.slopes, axis=0)
    remaining = sorted(candidates, key=lambda k: (not changed[k], -steepness[k]))
    while remaining and changed[remaining[0]]:
        switch = remaining[0]
        parallel = crossing.parallel_to(switch, candidates)
        decisions = [switch]
        decisions += [k for k in parallel if k != switch]
        # 3. decisions on both of its sides
        on_sides = np.vstack([before, before])
        opposite = np.where(changed[decisions], behind[decisions], -before[decisions])
        on_sides[1, decisions] = opposite
        fixed = HeldSwitch(tuple(sorted(decisions)), switch)
        sliding = _sliding_on(diagram, batch, crossing, fixed, on_sides)
        if sliding is not None:
            return sliding
        remaining = [k for k in remaining if k not in decisions]
    return None


def _crossing(diagram: Any, batch: Batch) -> Crossing:
    """Return the point at which a batch of one run ended."""
    state = batch.states[STATE, :, 0].copy()
    changes = STATE_CHANGE * (1.0 + np.abs(state))
    states = np.vstack([state, state + np.diag(changes)])
    times = np.full(len(states), batch.now)
    callee = diagram.callee()
    segments = batch.schedules[0]
    P = batch.memory.P
    # distances of the decisions, and their slopes by differences
    count = diagram.code.program.decided
    events = callee.events_at(times, states, segments, P)[:, :, :count]
    distance = events[:, DISTANCE]
    rounding_error = events[0, ROUNDING]
    slopes = (distance[1:] - distance[0]) / changes[:, None]
    undecided = np.flatnonzero(np.abs(distance[0]) < NEAR * rounding_error)
    n = len(state)
    rates = callee.evaluate(DERIVATIVE, times[:1], states[:1], segments, P, n)
    return Crossing(batch.now, state, undecided, slopes, rates)


def _sliding_on(
    diagram: Any, batch: Batch, crossing: Crossing, fixed: HeldSwitch, on_sides: ndarray
) -> Sliding | None:
    """Return a run on a switch, whose decisions on either side are a row of `on_sides`.

    None where rates lead away from it, or depend on another decision that stays undecided there.
    """
    try:
        runner = diagram.in_form(fixed)
    except (Unread, Uncompiled):
        return None
    # 1. parameters with the decisions on both sides
    parameters = runner.parameters()
    count = len(diagram.layout.P)
    parameters[:count] = batch.runs.parameters[0][:count]
    offset = diagram.decided_at
    parameters[offset - 1] = batch.memory.P[offset - 1]
    parameters[offset : offset + on_sides.size] = on_sides.ravel()
    # 2. rates lead back to the switch from both sides
    callee = runner.callee()
    segments = batch.schedules[0]
    state = crossing.state[None]
    events = callee.events_at([crossing.time], state, segments, parameters)
    if not events[0, DISTANCE, -1] > 0.0:
        return None
    # 3. and do not depend on another decision that changes on the same switch
    moving = np.flatnonzero(crossing.slopes.any(axis=0))
    candidates = set(crossing.undecided) & set(moving) - set(fixed.decisions)
    parallel = crossing.parallel_to(fixed.switch, sorted(candidates))
    pairs = [crossing.both_sides(k) for k in parallel]
    states = np.reshape(pairs, (-1, state.size))
    times = np.full(len(states), crossing.time)
    rates = callee.evaluate(DERIVATIVE, times, states, segments, parameters, state.size)
    differences = np.abs(rates[::2] - rates[1::2])
    largest = np.abs(crossing.rates).max()
    if np.any(differences > NEGLIGIBLE * largest):
        return None
    return Sliding(runner, parameters)


# --- rates on a switch ----------------------------------------------------------------------------


def slide(record: Any, fixed: HeldSwitch) -> None:
    """Replace the rates of a `DiagramRecord` by those on a switch.

    w and 1 - w become margins, and so does that the other fixed decisions stay where they are.
    """
    conditions = record.decisions
    tape = record.tape
    # 1. rates on both sides, and w
    rates_0 = conditions.lock(record.rates, fixed.decisions)
    rates_1 = conditions.lock(record.rates, fixed.decisions)
    distance = conditions.distance_of(fixed.switch)
    slope = _slope(record, distance, rates_0)
    slope_1 = _slope(record, distance, rates_1)
    difference = slope_1 - slope
    if type(difference) is float and difference == 0.0:
        raise Unread("a switch that its rates do not move")
    weight = -slope / difference
    record.margins += [operand(weight), operand(1.0 - weight)]
    # 2. the mean of the rates
    record.rates = []
    for port_0, port_1 in zip(rates_0, rates_1, strict=True):
        mean = spread(tape, tape.value(port_0.ref), port_0.shape)
        rate_1 = spread(tape, tape.value(port_1.ref), port_0.shape)
        if port_1.ref != port_0.ref:
            mean = mean + weight * (rate_1 - mean)
        record.rates.append(port_0._replace(ref=operand(mean)))
    # 3. the distances of the other decisions do not change
    for decision in set(fixed.decisions) - {fixed.switch}:
        distance = conditions.distance_of(decision)
        moved = np.fabs(_slope(record, distance, record.rates))
        scale = np.fabs(_slope(record, distance, rates_0))
        allowed = NEGLIGIBLE * scale + TINY
        record.margins.append(operand(1.0 - moved / allowed))


def _slope(record: Any, distance: int, rates: list[Port]) -> Any:
    """Return g' along rates."""
    direction: dict[int, Any] = {}
    for k in reached(record.entries, [distance]):
        kind, _, shape, location = record.entries[k]
        if kind != "load":
            continue
        if location[0] == "t":
            direction[k] = 1.0
        if location[0] != "X":
            continue
        begin = location[1]
        end = begin + prod(shape)
        for port in rates:
            if port.first <= begin and end <= port.first + prod(port.shape):
                rate = record.part(port.ref, begin - port.first, shape)
                direction[k] = record.tape.value(rate)
    derivative = Direction(record.tape, direction)
    return derivative.of(record.tape.value(distance))
