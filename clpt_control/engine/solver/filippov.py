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

from ...errors import Uncompiled
from ..codegen.switching_conditions import Port
from ..record.derivative import Direction
from ..record.graph import reached
from ..trace.arrays import Unread, operand
from ..trace.elementwise import spread
from .batch import Batch
from .schedule import Schedule
from .solver_layout import (
    DECIDE,
    DECISION,
    DERIVATIVE,
    MARGIN,
    SAMPLE_POINTS,
    STATE,
    TRIAL_SIZE,
    Status,
)
from .termination import edge, state_within

NEGLIGIBLE = 1e-6  # share of rates that counts as nothing
TINY = 1e-30
PARALLEL = 1e-4  # share of a slope that may stand out of the others
NEAR = 1e3  # least distances, at which a decision is about to change
MOST_IN_VAIN = 50  # parts of a run in a row, each shorter than SHORT of the run
SHORT = 1e-7
STATE_CHANGE = 1e-6  # relative, for the slopes of distances


class HeldSwitch(NamedTuple):
    """Decisions that change on one switch, and the one whose distance is its g."""

    decisions: tuple[int, ...]
    switch: int


class Sliding(NamedTuple):
    """A run on a switch: a `NativeDiagram` with the mean of the rates, and its parameters."""

    runner: Any
    parameters: np.ndarray


Begin = Callable[[Any, np.ndarray, np.ndarray, np.ndarray, Schedule], Batch]


# --- runs that slide ------------------------------------------------------------------------------


def continue_on_switch(diagram: Any, batch: Batch, begin: Begin) -> None:
    """Continue a batch of one run of a `NativeDiagram` that ended on a switch.

    ``begin(diagram, parameters, state, times, segments)`` runs a part.
    """
    times, part, in_vain = batch.times, batch, 0
    sliding: Sliding | None = None
    while True:
        last = part.rests.get(0, part)
        status, t, x = last.status[0], last.now, last.states[STATE, :, 0].copy()
        # 1. enter or leave the switch, or end
        if status == Status.CHATTERING and sliding is None and in_vain < MOST_IN_VAIN:
            if (sliding := enter(diagram, last)) is None:
                break
            batch.slides.append(t)
        elif sliding is not None and status == Status.GUARD_LEFT:
            sliding = None
            t, x = leave(last)
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
        in_vain = 0 if t - part.times[0] > SHORT * (times[-1] - times[0]) else in_vain + 1
        # 3. the next part, and its samples
        part = _next_part(diagram, batch, begin, sliding, t, x)
    if part is not batch:
        batch.rests[0], batch.status[0] = last, last.status[0]
        batch.reached[0] = np.searchsorted(times, last.now, "right")


def _next_part(
    diagram: Any, batch: Batch, begin: Begin, sliding: Sliding | None, t: float, x: np.ndarray
) -> Batch:
    """Run the next part, with or without sliding, and copy its samples into the batch."""
    times, segments = batch.times, batch.pieces[0].after(t)
    ahead = times[times > t]
    runner, parameters = diagram, batch.runs.parameters[0]
    if sliding is not None:
        runner, parameters = sliding
        segments = _until_a_jump(segments)
        ahead = np.union1d(ahead[ahead < segments.edges[-2]], segments.edges[-2:-1])
    part = begin(runner, parameters, x, np.append(t, ahead), segments)
    reached_times = ahead[: part.reached[0] - 1]
    _, samples, indices = np.intersect1d(times, reached_times, return_indices=True)
    batch.out[0, samples] = part.out[0, 1 + indices]
    batch.counts += part.counts
    return part


def _until_a_jump(segments: Schedule) -> Schedule:
    """Return segments up to the first at whose beginning rates jump.

    Where inputs bend, the rates on a switch jump too: each segment begins anew.
    """
    jumps = np.flatnonzero(segments.smooth[1:-1] == 0)
    k = int(jumps[0]) if len(jumps) else len(segments.edges) - 2
    edges = np.append(segments.edges[: k + 1], np.inf)
    smooth = np.zeros_like(segments.smooth[: k + 2])
    return Schedule(edges, segments.places, segments.values[: k + 2], smooth)


def leave(batch: Batch) -> tuple[float, np.ndarray]:
    """Return time and state where w leaves 0 ... 1, or a guard is met, in the step not taken."""
    t, size = batch.now, float(batch.lane[TRIAL_SIZE, 0])

    def margin(share: float) -> float:
        state = state_within(batch, share)[None]
        point = [t + share * size], state, batch.pieces[0], batch.memory.P
        distance = batch.callee.evaluate(MARGIN, *point, 1)[0, 0]
        return -1.0 if np.isnan(distance) else float(distance)

    share = edge(batch, margin)
    return t + share * size, state_within(batch, share)


# --- entering a switch ----------------------------------------------------------------------------


class Crossing(NamedTuple):
    """Where a run crosses a switch to and fro."""

    time: float
    state: np.ndarray
    near: np.ndarray  # decisions that are about to change
    slopes: np.ndarray  # of the distances of all decisions, (states, decisions)
    rates: np.ndarray

    def parallel_to(self, decision: int, candidates: Iterable[int]) -> list[int]:
        """Return the candidates that change where a decision does: their slopes are parallel."""
        candidates = [*candidates]
        slope, slopes = self.slopes[:, [decision]], self.slopes[:, candidates]
        beside = slopes - slope @ np.linalg.lstsq(slope, slopes, rcond=None)[0]
        flat = np.linalg.norm(beside, axis=0) <= PARALLEL * np.linalg.norm(slopes, axis=0)
        return [*np.compress(flat, candidates)]

    def both_sides(self, decision: int) -> np.ndarray:
        """Return states on both sides of where a decision changes."""
        normal = self.slopes[:, decision] / np.sum(self.slopes[:, decision] ** 2)
        return self.state + 1e-8 * np.outer([1.0, -1.0], normal)


def enter(diagram: Any, batch: Batch) -> Sliding | None:
    """Return a run on the switch that a batch of one run crosses to and fro, or None."""
    crossing = _crossing(diagram, batch)
    count, first = diagram.code.program.decided, diagram.decided_at
    before = batch.memory.P[first : first + count]
    behind = batch.points[SAMPLE_POINTS, DECISION]
    changed = before != behind
    near = [k for k in range(count) if changed[k] or (k in crossing.near and abs(before[k]) == 1.0)]
    steepness = np.linalg.norm(crossing.slopes, axis=0)
    remaining = sorted(near, key=lambda k: (not changed[k], -steepness[k]))
    while remaining and changed[remaining[0]]:
        switch = remaining[0]
        parallel = [k for k in crossing.parallel_to(switch, near) if k != switch]
        decisions = [switch, *parallel]
        sides = np.vstack([before, before])
        sides[1, decisions] = np.where(changed[decisions], behind[decisions], -before[decisions])
        held = HeldSwitch(tuple(sorted(decisions)), switch)
        if (sliding := _sliding_on(diagram, batch, crossing, held, sides)) is not None:
            return sliding
        remaining = [k for k in remaining if k not in decisions]
    return None


def _crossing(diagram: Any, batch: Batch) -> Crossing:
    """Return where a batch of one run ended."""
    state, count = batch.states[STATE, :, 0].copy(), diagram.code.program.decided
    changes = STATE_CHANGE * (1.0 + np.abs(state))
    states = np.vstack([state, state + np.diag(changes)])
    times, rest = np.full(len(states), batch.now), (batch.pieces[0], batch.memory.P)
    callee = diagram.callee()
    conditions = callee.evaluate(DECIDE, times, states, *rest, 3 * count).reshape(-1, 3, count)
    distance, rounding = conditions[:, 1], conditions[0, 2]
    near = np.flatnonzero(np.abs(distance[0]) < NEAR * rounding)
    slopes = (distance[1:] - distance[0]) / changes[:, None]
    rates = callee.evaluate(DERIVATIVE, times[:1], states[:1], *rest, len(state))
    return Crossing(batch.now, state, near, slopes, rates)


def _sliding_on(
    diagram: Any, batch: Batch, crossing: Crossing, held: HeldSwitch, sides: np.ndarray
) -> Sliding | None:
    """Return a run on a switch, whose decisions are those of a row of `sides` on each side.

    None where rates lead away from it, or depend on another decision that stays undecided there.
    """
    try:
        runner = diagram.in_form(held)
    except (Unread, Uncompiled):
        return None
    first, known = diagram.decided_at, len(diagram.layout.P)
    parameters = runner.parameters()
    parameters[:known] = batch.runs.parameters[0][:known]
    parameters[first - 1] = batch.memory.P[first - 1]
    parameters[first : first + sides.size] = sides.ravel()
    callee, segments = runner.callee(), batch.pieces[0]
    point = [crossing.time], crossing.state[None], segments, parameters
    if not callee.evaluate(MARGIN, *point, 1)[0, 0] > 0.0:
        return None
    moving = [k for k in crossing.near if crossing.slopes[:, k].any() and k not in held.decisions]
    undecided = crossing.parallel_to(held.switch, moving)
    states = np.reshape(
        [state for k in undecided for state in crossing.both_sides(k)], (-1, len(crossing.state))
    )
    times = np.full(len(states), crossing.time)
    rates = callee.evaluate(DERIVATIVE, times, states, segments, parameters, states.shape[1])
    if np.any(np.abs(rates[::2] - rates[1::2]) > NEGLIGIBLE * np.abs(crossing.rates).max()):
        return None
    return Sliding(runner, parameters)


# --- rates on a switch ----------------------------------------------------------------------------


def slide(record: Any, held: HeldSwitch) -> None:
    """Replace the rates of a `DiagramRecord` by those on a switch.

    w and 1 - w become margins, and so does that the other held decisions stay where they are.
    """
    value, conditions = record.tape.value, record.decisions
    side, other_side = (conditions.lock(record.rates, held.decisions) for _ in range(2))
    distance = conditions.distance_of(held.switch)
    along = _slope(record, distance, side)
    pivot = _slope(record, distance, other_side) - along
    if type(pivot) is float and pivot == 0.0:
        raise Unread("a switch that its rates do not move")
    weight = -along / pivot
    record.margins += [operand(weight), operand(1.0 - weight)]
    record.rates = []
    for port, other in zip(side, other_side, strict=True):
        a, b = (spread(record.tape, value(rate.ref), port.shape) for rate in (port, other))
        mean = a if other.ref == port.ref else a + weight * (b - a)
        record.rates.append(port._replace(ref=operand(mean)))
    for decision in set(held.decisions) - {held.switch}:
        distance = conditions.distance_of(decision)
        moved = np.fabs(_slope(record, distance, record.rates))
        scale = np.fabs(_slope(record, distance, side))
        record.margins.append(operand(1.0 - moved / (NEGLIGIBLE * scale + TINY)))


def _slope(record: Any, distance: int, rates: list[Port]) -> Any:
    """Return g' along rates."""
    along: dict[int, Any] = {}
    for k in reached(record.entries, [distance]):
        kind, _, shape, at = record.entries[k]
        if kind == "load" and at[0] == "t":
            along[k] = 1.0
        for port in rates if kind == "load" and at[0] == "X" else ():
            first, end = at[1], at[1] + prod(shape)
            if port.first <= first and end <= port.first + prod(port.shape):
                part = record.part(port.ref, first - port.first, shape)
                along[k] = record.tape.value(part)
    return Direction(record.tape, along).of(record.tape.value(distance))
