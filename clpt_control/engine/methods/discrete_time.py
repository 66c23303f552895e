"""Discrete time.

A step leads from one sample to the next: the rate is the state there.
"""

from numpy import where

from ..solver.solver_layout import (
    ACCEPTED,
    ACCEPTED_COUNT,
    ARGUMENT,
    DUE,
    FAILURE,
    NEXT_STOP,
    RATE,
    STAGE_TIME,
    STATE,
    TERMS,
    TIME,
    TRIAL_END,
    TRIAL_SIZE,
    TRIES_LEFT,
    Status,
)
from .formulas import Formula, New, StepTape, in_order


def _to_next_sample(s: StepTape) -> New:
    """One step to the next sample, or to the end of the segment."""
    stop = s.lane(NEXT_STOP)
    return {}, {TRIAL_END: stop, TRIAL_SIZE: stop - s.lane(TIME)}


def _control(s: StepTape) -> New:
    """The new state, which must be finite; otherwise the run has ended."""
    state = s.z(RATE)
    end = s.lane(TRIAL_END)
    tries = s.lane(ACCEPTED_COUNT) + 1.0
    good = s.total(0.0 * state) <= 0.0
    failing = where(good, 0.0, float(Status.NOT_FINITE))
    at_stop = end >= s.lane(NEXT_STOP)
    used_up = tries >= s.lane(TRIES_LEFT)
    numbers = {
        ACCEPTED: where(good, 1.0, 0.0),
        DUE: where(at_stop | used_up, 1.0, failing),
        STAGE_TIME: end,
        ACCEPTED_COUNT: tries,
        FAILURE: failing,
    }
    return {ARGUMENT: state}, numbers


def _accept(s: StepTape) -> New:
    """The new state."""
    state = s.z(ARGUMENT)
    time = s.lane(TRIAL_END)
    return {STATE: state}, {TIME: time}


def _dense(s: StepTape) -> New:
    """The straight line over the step."""
    return {TERMS: s.z(ARGUMENT) - s.z(STATE)}, {}


def formulas() -> list[Formula]:
    """Return the formulas in the solver's order."""
    return in_order(_control, _dense, [], attempt=_to_next_sample, accept=_accept)
