"""Jumps of states at a level: the run continues behind the edge of a guard with policy "jump".

Machine code stops a run at the edge of a guard, where its distance is not below 0 yet.  Blocks
whose guards are left at one instant jump together and see the values before the jump, as blocks do
that jump at one time.  Guards that are left by these jumps jump next, in a second round.
"""

from typing import Any

import numpy as np
from numpy import ndarray

from ...base.errors import SimulationError
from .batch import Batch
from .solver_layout import (
    DECISION,
    DERIVATIVE,
    DISTANCE,
    EVENT_INDEX,
    HIGH,
    JUMP,
    LOW,
    ROUNDING,
    STATE,
)
from .termination import stopped_at

RESOLVED = 1e-13  # times that differ by so much of the run are one instant


def left_guard(diagram: Any, batch: Batch) -> int | None:
    """Return the block whose guard a stopped run left; None if it left a switch."""
    guarded = diagram.sweep.guarded
    k = int(batch.integers[EVENT_INDEX, 0]) - batch.callee.decided
    return guarded[k] if k < len(guarded) else None


def jump_at_level(
    diagram: Any, batch: Batch, block: int, is_again: bool, is_first: bool
) -> tuple[float, ndarray] | None:
    """Return time and state after the jumps of a run that left the guard of a block.

    Return None if a run that begins at this level (`is_again`) did not rise above it by more than
    rounding.  Refuse a run that begins (`is_first`) outside.
    """
    guarded = diagram.sweep.guarded
    nodes = diagram.wiring.nodes
    segments = batch.schedules[0]
    callee = diagram.callee()
    # with the decisions of the step
    P = batch.memory.P[: callee.decided_at + callee.decided].copy()

    def distances(t: float, x: ndarray) -> tuple[ndarray, ndarray, ndarray]:
        """Return distances, those at the end of this instant, and the edges (`set_edges`)."""
        rates = callee.evaluate(DERIVATIVE, [t], x[None], segments, P)
        soon = RESOLVED * max(abs(t), batch.times[-1] - batch.times[0])
        states = np.vstack([x, x + soon * rates])
        events = callee.events_at([t, t + soon], states, segments, P)
        now, later = events[:, :, callee.decided :]
        edges = now[ROUNDING] + np.abs(later[DISTANCE] - now[DISTANCE])
        return now[DECISION], later[DECISION], np.where(np.isfinite(edges), edges, 0.0)

    # 1. the edge, or the point behind it where the distance itself jumps there
    points = _bracket(batch)
    t, x = points[-1]
    now, later, edges = distances(t, x)
    if not (now < -edges).any():
        t, x = points[0]
        now, later, edges = distances(t, x)
    # 2. guards that are left at this instant, by rounding: the distance falls to 0
    own = guarded.index(block)
    distance = now[own]
    if is_again and batch.lane[HIGH, 0] == 0.0 and -edges[own] <= distance < 0.0:
        return None
    if is_first and batch.lane[HIGH, 0] == 0.0 and distance < -edges[own]:
        raise SimulationError(
            f"at t = {t:.9g}: the run begins outside of the guard of {nodes[block].name}, whose "
            "states jump where its distance falls to 0. Begin with a distance of 0 or more"
        )
    left = (now < -edges) | (later <= 0.0) & (later < now)
    left[own] |= distance >= 0.0
    # 3. their blocks jump, then those whose guards these jumps leave
    jumped: list[int] = []
    while left.any():
        blocks = [k for k, is_left in zip(guarded, left, strict=True) if is_left]
        jumping = [k for k in blocks if nodes[k].system.jumps_at_level]
        for k in sorted({*jumped} & {*jumping}):
            raise SimulationError(
                f"at t = {t:.9g}: the states after the jump of {nodes[k].name} are "
                "outside of its guard. Return states with a distance of 0 or more"
            )
        if not jumping:
            break
        requests = segments.requesting(diagram.layout.jumps, jumping)
        (x,) = callee.evaluate(JUMP, [t], x[None], requests, P)
        jumped += jumping
        now, _, edges_behind = distances(t, x)
        left = now < -np.maximum(edges, edges_behind)
    if not jumped:
        raise SimulationError(
            f"at t = {t:.9g}: the level of {nodes[block].name} could not be located. Lower max_step"
        )
    return t, x


def _bracket(batch: Batch) -> list[tuple[float, ndarray]]:
    """Return time and state right before and behind an edge, or where a segment begins."""
    if batch.lane[HIGH, 0] == 0.0:
        return [(batch.now, batch.states[STATE, :, 0].copy())]
    return [stopped_at(batch, edge) for edge in (LOW, HIGH)]
