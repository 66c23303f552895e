"""DOP853: Dormand and Prince's explicit method of order 8, with an interpolant of order 7.

Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, 1993, sections II.5, II.6 and
II.10; the coefficients are scipy's.
"""

from functools import partial
from typing import Any

from numpy import maximum, minimum, sqrt, where
from scipy.integrate._ivp import dop853_coefficients as table

from ..solver.solver_layout import (
    ARGUMENT,
    CALM_STEPS,
    CHECKS_STIFFNESS,
    END_RATE,
    INTERPOLANT_ERROR,
    STATE,
    STIFF_STEPS,
    TRIAL_SIZE,
)
from .formulas import (
    Formula,
    New,
    StepTape,
    accept_or_reject,
    cubic,
    fmuladd,
    in_order,
    interpolant_terms,
    stage,
    stage_time,
    weighted_sum,
)

# share of the interpolant's last term that is its error in a stiff step
LAST_TERM = 1.23e-3
TRUSTED = 100.0  # tolerances: the largest error of the interpolant
STAGES = 12


def _stage_at_end(s: StepTape) -> New:
    """The new state again, equal to the bit: stages of the interpolant have overwritten it."""
    _, state = _new_state(s)
    return {ARGUMENT: state}, stage_time(s, 1.0)


def _new_state(s: StepTape) -> tuple[Any, Any]:
    """Return the rate over the step, and the state at its end."""
    rate = weighted_sum(s, table.B)
    return rate, fmuladd(s.lane(TRIAL_SIZE), rate, s.z(STATE))


def _control(s: StepTape) -> New:
    """The new state, the estimate of its error, and the length of the next step.

    err = h |e_5|^2 / sqrt((|e_5|^2 + 0.01 |e_3|^2) n) of the errors of orders 5 and 3.
    """
    rate, state = _new_state(s)
    largest = maximum(abs(s.z(STATE)), abs(state))
    scale = 1.0 / s.tolerance(largest)
    fifth = weighted_sum(s, table.E5) * scale
    third_from_rate = table.E3[:STAGES] - table.B  # most of E3 is B
    third = weighted_sum(s, third_from_rate, total=rate) * scale
    fifth = s.total(fifth * fifth)
    third = s.total(third * third)
    # no error at all counts as tiny
    exact = fifth + third <= 0.0
    square = (fifth + 0.01 * third) * float(s.n)
    size = sqrt(where(exact, 1.0, square))
    error = where(exact, 1e-30, s.lane(TRIAL_SIZE) * fifth / size)
    eighth_root = sqrt(sqrt(sqrt(maximum(error, 1e-30))))
    factor = 0.9 / eighth_root
    return {ARGUMENT: state}, accept_or_reject(s, error, factor, 10.0)


def _dense(s: StepTape) -> New:
    """The terms of the interpolant of order 7, and its error.

    It is as exact as the ends of the step, if the step resolves all states.  If the fastest state
    keeps the step short by stability alone, it is up to 10,000 times less exact; its last term
    estimates that.
    """
    h = s.lane(TRIAL_SIZE)
    terms = [*cubic(s)]
    terms += [h * weighted_sum(s, weights) for weights in table.D]
    before = abs(s.z(STATE))
    after = abs(s.z(ARGUMENT))
    largest = maximum(before, after)
    share = LAST_TERM / TRUSTED
    scaled = share * terms[-1] / s.tolerance(largest)
    error = sqrt(s.total(scaled * scaled))
    return interpolant_terms(s, *terms), {INTERPOLANT_ERROR: error}


def _stiffness(last: Any, limit: float, s: StepTape) -> New:
    """Count stiff steps: rates change `limit` times as fast as the states do.

    Hairer's test compares the new state and the argument of the `last` stage.  Six steps that are
    not stiff cancel those that are.
    """
    # 1. changes of rates and states between the two
    h = s.lane(TRIAL_SIZE)
    rates = s.z(END_RATE) - s.z(END_RATE - 1)
    argument = fmuladd(h, weighted_sum(s, last), s.z(STATE))
    states = s.z(ARGUMENT) - argument
    rates = h * h * s.total(rates * rates)
    states = limit * limit * s.total(states * states)
    stiff = rates > states
    # 2. steps that are stiff, and those since then that are not
    stiff_steps = s.lane(STIFF_STEPS)
    calm_steps = s.lane(CALM_STEPS)
    calm = calm_steps + 1.0
    cancelled = where(calm > 5.5, minimum(stiff_steps, 0.0), stiff_steps)
    counted = where(stiff, stiff_steps + 1.0, cancelled)
    steps = where(stiff_steps < 0.0, stiff_steps + 1.0, counted)
    calm = where(stiff, 0.0, calm)
    # 3. only lanes that are checked: a run is the same next to any other run
    checked = s.lane(CHECKS_STIFFNESS) > 0.5
    steps = where(checked, steps, stiff_steps)
    calm = where(checked, calm, calm_steps)
    return {}, {STIFF_STEPS: steps, CALM_STEPS: calm}


def formulas() -> list[Formula]:
    """Return the formulas in the solver's order."""
    times = table.C.tolist()
    stages: list[Formula] = [
        partial(stage, table.A[k, :k], times[k]) for k in range(1, STAGES + 4)
    ]
    stages[STAGES - 1] = _stage_at_end
    stiffness = partial(_stiffness, table.A[11, :11], 6.1)
    return in_order(_control, _dense, stages, stiffness=stiffness)
