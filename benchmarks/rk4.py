"""Runge and Kutta's classical method of order 4, in steps of one length.

    K_1 = f(t, x),  K_2 = f(t + h/2, x + h/2 K_1),  K_3 = f(t + h/2, x + h/2 K_2),
    K_4 = f(t + h, x + h K_3),  x + h/6 (K_1 + 2 K_2 + 2 K_3 + K_4)

The C program and Parcels advect particles by this method.  It estimates no error, so a run gives
the length of its steps as the first and the longest step.
"""

from functools import partial
from typing import Any

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
from clpt_control.engine.methods.method import Method
from clpt_control.engine.solver.solver_layout import (
    ARGUMENT,
    INTERPOLANT_ERROR,
    STATE,
    TIME,
    TRIAL_SIZE,
)

WEIGHTS = (1 / 6, 1 / 3, 1 / 3, 1 / 6)
STAGES = (0.5, 0.5, 1.0)  # times of K_2, K_3 and K_4


def _control(s: StepTape) -> New:
    """Accept each step whose state is finite."""
    state = fmuladd(s.lane(TRIAL_SIZE), weighted_sum(s, WEIGHTS), s.z(STATE))
    error = s.total(0.0 * state)
    return {ARGUMENT: state}, accept_or_reject(s, error, 1.0, 1.0)


def _dense(s: StepTape) -> New:
    """The cubic through both ends."""
    return dense_cubic(s)[0], {INTERPOLANT_ERROR: 0.0 * s.lane(TIME)}


def _formulas() -> dict[str, Any]:
    stages = [partial(stage, [0.0] * k + [c], c) for k, c in enumerate(STAGES)]
    return in_order(_control, _dense, stages)


RK4 = Method("RK4", stages=4, order=4, formulas=_formulas)
