"""Runs over many kinks: where they restart the integration too often, they are no longer located.

A kink (max, abs, a slope limiter) changes no rate where it is passed, so the estimate of the error
sees it.  It is located as long as kinks are few.  In a large model they are many: then the run goes
on with smaller tolerances and with kinks evaluated at every stage.

An operation counts as a kink if it was passed in some of the last events, and the rates were the
same on both sides each time.  Other operations are located as before.  What was a kink and jumps
later is left to the estimate of the error, at the smaller tolerances.
"""

from typing import Any

import numpy as np

from .batch import Batch
from .solver_layout import (
    BEGINNING,
    DECISION,
    DERIVATIVE,
    RATE,
    REJECTIONS,
    RESTARTS,
    RUN_INDEX,
    STATE,
    STEPS,
    TIME,
)

SHARE = 1.0 / 3.0  # of restarts in the steps: more are too many
FEWEST = 64  # tries after which they are counted
NONE = frozenset[int]()
LOOKS = 400  # tries in which the kinks are found


class ManyKinks:
    """The kinks of a run that restart it too often.

    `diagram` is a `NativeDiagram`.  The run is looked at after `FEWEST` tries, and whenever they
    have doubled: the pace of the machine has no part in it.
    """

    def __init__(self, diagram: Any):
        self.diagram = diagram
        self.next_look = FEWEST  # tries

    def tries_left(self, batch: Batch) -> int:
        """Return the tries until the next look."""
        tries = batch.counts[0, STEPS] + batch.counts[0, REJECTIONS]
        return max(int(self.next_look - tries), 1)

    def found(self, batch: Batch, rtol: float, atol: float) -> frozenset[int]:
        """Return the kinks that a run goes on without locating, most often none.

        They are operations, counted as they are locked.
        """
        counts = batch.counts[0]
        tries = counts[STEPS] + counts[REJECTIONS]
        if tries < self.next_look:
            return NONE
        self.next_look = 2 * int(tries)
        if counts[RESTARTS] <= SHARE * counts[STEPS]:
            return NONE
        kinks = _kinks(self.diagram, batch, rtol, atol)
        return NONE if batch.integers[RUN_INDEX, 0] < 0 else frozenset(kinks)


def _kinks(diagram: Any, batch: Batch, rtol: float, atol: float) -> set[int]:
    """Return the operations that are kinks in the next events of a run."""
    # a page of the solver, which other runs have as machine code alone
    from .event_location import NEGLIGIBLE

    firsts = np.array(diagram.code.decided_operations)
    kinks: set[int] = set()
    jumps: set[int] = set()
    for _ in range(LOOKS):
        active = batch.advance(rtol, atol, 1)
        if not active:
            break
        if not batch.solver.queue[BEGINNING]:
            continue
        changed, effect = _effect_of_event(diagram, batch, rtol, atol)
        operations = np.searchsorted(firsts, changed, "right") - 1
        (kinks if effect <= NEGLIGIBLE else jumps).update(operations.tolist())
    return kinks - jumps


def _effect_of_event(
    diagram: Any, batch: Batch, rtol: float, atol: float
) -> tuple[np.ndarray, float]:
    """Return the decisions that change where a step has ended, and the effect on a mean step.

    The effect is that of `event_location`: step times difference of the rates, in tolerances.
    """
    callee = batch.callee
    times = batch.lane[TIME, :1]
    state = batch.states[STATE, :, 0][None]
    at = times, state, batch.schedules[0], batch.memory.P
    now = callee.events_at(*at)[0, DECISION, : callee.decided]
    held = batch.memory.P[callee.decided_at :][: callee.decided]
    changed = np.flatnonzero(now != held)
    rates = callee.evaluate(DERIVATIVE, *at)[0]
    difference = np.abs(rates - batch.states[RATE, :, 0])
    mean_step = (batch.now - batch.times[0]) / batch.counts[0, STEPS]
    tolerances = atol + rtol * np.abs(state[0])
    return changed, float(np.max(mean_step * difference / tolerances))
