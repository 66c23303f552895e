"""Steps of one length: Runge and Kutta's classical method of order 4; and discrete time.

In discrete time a step leads from one sample to the next: the rate is the state there.
"""

from collections.abc import Callable
from functools import partial
from typing import Any

from numpy import ceil, maximum, where

from ..solver.solver_layout import (
    ACCEPTED,
    ACCEPTED_COUNT,
    ARGUMENT,
    DUE,
    FAILURE,
    MAX_STEP,
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
from .formulas import Formula, New, StepTape, fmuladd, in_order, stage
from .method import Method


def _attempt_fixed(s: StepTape) -> New:
    """Equal steps up to the next sample, or the end of the segment."""
    t = s.lane(TIME)
    stop = s.lane(NEXT_STOP)
    ahead = stop - t
    tolerance = 1e-15 * abs(stop)
    rounded = ahead * (1.0 - 1e-12) - tolerance  # as times are rounded
    steps = maximum(1.0, ceil(rounded / s.lane(MAX_STEP)))
    size = ahead / steps
    end = where(steps > 1.0, t + size, stop)
    return {}, {TRIAL_END: end, TRIAL_SIZE: size}


def _runge_kutta(s: StepTape) -> Any:
    """Return the state at the end of a step of RK4."""
    outer = s.z(RATE) + s.z(RATE + 3)
    inner = s.z(RATE + 1) + s.z(RATE + 2)
    total = fmuladd(2.0, inner, outer)
    return fmuladd(s.lane(TRIAL_SIZE) / 6.0, total, s.z(STATE))


def _next_sample(s: StepTape) -> Any:
    """Return the next state in discrete time."""
    return s.z(RATE)


def _control_fixed(new_state: Callable[[StepTape], Any], s: StepTape) -> New:
    """The new state, which must be finite; otherwise the run has ended."""
    state = new_state(s)
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


def _accept_fixed(s: StepTape) -> New:
    """The new state."""
    state = s.z(ARGUMENT)
    time = s.lane(TRIAL_END)
    return {STATE: state}, {TIME: time}


def _dense_fixed(s: StepTape) -> New:
    """The straight line over the step."""
    return {TERMS: s.z(ARGUMENT) - s.z(STATE)}, {}


def _formulas(
    new_state: Callable[[StepTape], Any], times: list[float]
) -> dict[str, Formula]:
    stages: list[Formula] = []
    for k, c in enumerate(times):  # each stage has one weight
        stages.append(partial(stage, [0.0] * k + [c], c))
    return in_order(
        partial(_control_fixed, new_state),
        _dense_fixed,
        stages,
        attempt=_attempt_fixed,
        accept=_accept_fixed,
    )


RK4 = Method(
    "RK4",
    stages=4,
    order=4,
    formulas=partial(_formulas, _runge_kutta, [0.5, 0.5, 1.0]),
    adaptive=False,
)
DISCRETE = Method(
    "none",
    stages=1,
    order=0,
    formulas=partial(_formulas, _next_sample, []),
    adaptive=False,
    discrete=True,
)
