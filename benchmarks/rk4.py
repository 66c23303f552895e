"""Runge and Kutta's classical method of order 4, in steps of one length.

    K_1 = f(t, x),  K_2 = f(t + h/2, x + h/2 K_1),  K_3 = f(t + h/2, x + h/2 K_2),
    K_4 = f(t + h, x + h K_3),  x + h/6 (K_1 + 2 K_2 + 2 K_3 + K_4)

The C program and Parcels advect particles by this method.  It estimates no error: each step is as
long as a step may be.
"""

from functools import partial
from typing import Any

from numpy import minimum

from clpt_control.engine.methods import Method
from clpt_control.engine.methods.formulas import (
    New,
    StepTape,
    accept_or_reject,
    dense_cubic,
    fmuladd,
    in_order,
    stage,
    weighted_sum,
)
from clpt_control.engine.solver.solver_layout import (
    ARGUMENT,
    FAILURE,
    INTERPOLANT_ERROR,
    MAX_STEP,
    SEGMENT_END,
    STATE,
    TIME,
    TRIAL_END,
    TRIAL_SIZE,
)

WEIGHTS = (1 / 6, 1 / 3, 1 / 3, 1 / 6)
STAGES = (0.5, 0.5, 1.0)  # times of K_2, K_3 and K_4


def _attempt(s: StepTape) -> New:
    """The longest step, but not beyond the end of the segment."""
    t = s.lane(TIME)
    end = minimum(t + s.lane(MAX_STEP), s.lane(SEGMENT_END))
    return {}, {TRIAL_END: end, TRIAL_SIZE: end - t, FAILURE: 0.0 * t}


def _control(s: StepTape) -> New:
    """Accept each step whose state is finite."""
    state = fmuladd(s.lane(TRIAL_SIZE), weighted_sum(s, WEIGHTS), s.z(STATE))
    error = s.total(0.0 * state)
    return {ARGUMENT: state}, accept_or_reject(s, error, 1.0, 1.0)


def _dense(s: StepTape) -> New:
    """The cubic through both ends."""
    return dense_cubic(s)[0], {INTERPOLANT_ERROR: 0.0 * s.lane(TIME)}


def formulas() -> list[Any]:
    """Return the formulas in the solver's order."""
    stages = [partial(stage, [0.0] * k + [c], c) for k, c in enumerate(STAGES)]
    return in_order(_control, _dense, stages, attempt=_attempt)


RK4 = Method("RK4", stages=4, order=4, module=__name__)
