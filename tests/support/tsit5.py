"""Tsit5, an explicit method of order 5 with an interpolant of order 4: one file, one entry.

Tsitouras, Runge-Kutta pairs of order 5(4) satisfying only the first column simplifying assumption,
Computers and Mathematics with Applications 62, 2011, 770-775.  The interpolant has the states and
rates of both ends, so it is their cubic and one more term.
"""

from functools import partial

import numpy as np
from numpy import maximum, power

from clpt_control.engine.methods.formulas import (
    accept_or_reject,
    cubic,
    fmuladd,
    in_order,
    interpolant_terms,
    mean_square,
    stage,
    weighted_sum,
)
from clpt_control.engine.solver.solver_layout import (
    ARGUMENT,
    INTERPOLANT_ERROR,
    STATE,
    TIME,
    TRIAL_SIZE,
)

TIMES = (0.0, 0.161, 0.327, 0.9, 0.9800255409045097, 1.0, 1.0)
A = (
    (),
    (0.161,),
    (-0.008480655492356989, 0.335480655492357),
    (2.8971530571054935, -6.359448489975075, 4.3622954328695815),
    (5.325864828439257, -11.748883564062828, 7.4955393428898365, -0.09249506636175525),
    (
        *(5.86145544294642, -12.92096931784711, 8.159367898576159),
        *(-0.071584973281401, -0.028269050394068383),
    ),
    (
        *(0.09646076681806523, 0.01, 0.4798896504144996),
        *(1.379008574103742, -3.290069515436081, 2.324710524099774),
    ),
)
ERROR = (
    *(-0.00178001105222577714, -0.0008164344596567469, 0.007880878010261995),
    *(-0.1447110071732629, 0.5823571654525552, -0.45808210592918697),
    0.015151515151515152,
)
LAST = (  # the interpolant's coefficients of the fourth power of the share
    *(-1.0530884977290216, 0.1017, 2.490627285651253, -16.548102889244902),
    *(47.37952196281928, -34.87065786149661, 2.5),
)


def control(s):
    """Take the last argument as the new state; its rate is part of the error."""
    state = fmuladd(s.lane(TRIAL_SIZE), weighted_sum(s, A[6]), s.z(STATE))
    size = maximum(abs(s.z(STATE)), abs(state))
    error = s.lane(TRIAL_SIZE) * weighted_sum(s, ERROR) / s.tolerance(size)
    square = mean_square(s, error)
    factor = 0.9 * power(maximum(square, 1e-30), -0.1)  # error^(-1/5)
    return {ARGUMENT: state}, accept_or_reject(s, square, factor, 10.0)


def dense(s):
    """Add a term to the cubic."""
    last = s.lane(TRIAL_SIZE) * weighted_sum(s, LAST)
    return interpolant_terms(s, *cubic(s), last), {
        INTERPOLANT_ERROR: 0.0 * s.lane(TIME)
    }


def formulas():
    """Return the formulas in the solver's order."""
    stages = [partial(stage, np.array(A[k]), TIMES[k]) for k in range(1, 7)]
    return in_order(control, dense, stages, first_step_order=5)
