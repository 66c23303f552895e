"""Formulas that integration methods share: stages, choice of steps, the cubic through both ends.

The formulas compute each stage, accept or reject a step and choose the next.  `time_stepper` calls
them in order; `solver_layout` names the rows of Z and the numbers of a lane.  A formula is an
ordinary function that is traced as those of a diagram are.  It becomes a program of eight states or
eight runs at once, in which t are the numbers of a lane and X the rows of Z.

The choice of steps is that of Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I,
1993, section II.4.
"""

from collections.abc import Callable
from functools import partial
from types import SimpleNamespace
from typing import Any

import numpy as np
from numpy import maximum, minimum, power, sqrt, where

from ..codegen.fused_expressions import Components
from ..codegen.plan import Planner, Program
from ..codegen.switching_conditions import Port
from ..solver.solver_layout import (
    ACCEPTED,
    ACCEPTED_COUNT,
    ARGUMENT,
    DIAGONAL,
    DUE,
    END_RATE,
    FAILURE,
    FIRST_STEP,
    FRESH,
    MAX_STEP,
    NEXT_STOP,
    NOT_FINITE,
    RATE,
    RATE_NORM,
    REJECTED,
    REJECTED_COUNT,
    SEGMENT_END,
    SHARE,
    STAGE_TIME,
    STATE,
    STEP_SIZE,
    STOP_AT,
    TERMS,
    TIME,
    TRIAL_END,
    TRIAL_SIZE,
    TRIES_LEFT,
    WITHIN,
    Status,
)
from ..trace.arrays import Tape, operand
from ..trace.elementwise import elementwise

Rows = dict[int, Any]
# a b + c, rounded once where the processor can
fmuladd = partial(elementwise, "fmuladd")


class StepTape:
    """The tape of formulas: rows of Z, for each of n states, and numbers of the lane."""

    def __init__(self, n: int):
        self.n = n
        self.tape = Tape()

    def z(self, row: int) -> Any:
        """Return a row of Z."""
        return self._load("X", row * self.n, (self.n,))

    def lane(self, row: int) -> Any:
        """Return a number of the lane."""
        return self._load("t", row)

    def tolerance(self, size):
        """Return the tolerance of states of a size."""
        relative = self._load("T", 0)
        absolute = self._load("T", 1)
        return fmuladd(relative, size, absolute)

    def total(self, value):
        """Return the sum over the states."""
        axis = (0, self.n, True)
        return self.tape.add("sum", (operand(value),), (), axis)

    def _load(self, array: str, offset: int, shape: tuple[int, ...] = ()) -> Any:
        return self.tape.add("load", (), shape, (array, offset))


New = tuple[Rows, Rows]  # the new rows of Z, and the new numbers of the lane
Formula = Callable[[StepTape], New]


def weighted_sum(s: StepTape, weights: Any, row: int = RATE, total: Any = None) -> Any:
    """Return total + a_0 K_0 + a_1 K_1 + ..., with the rows from `row` on; zeros are left out."""
    for a in np.asarray(weights).tolist():
        if a != 0.0:
            rate = s.z(row)
            total = a * rate if total is None else fmuladd(a, rate, total)
        row += 1
    return total


def mean_square(s: StepTape, value: Any) -> Any:
    """Return the mean of squares over the states."""
    return s.total(value * value) / float(s.n)


def interpolant_terms(s: StepTape, *terms: Any) -> Rows:
    """Return the terms of an interpolant, as `solver_layout.interpolate` sums them."""
    missing = 7 - len(terms)
    zeros = [0.0 * s.z(STATE)] * missing
    return dict(enumerate([*terms, *zeros], TERMS))


def stage_time(s: StepTape, c: Any) -> Rows:
    """Return the time of a stage, t + c h."""
    t = s.lane(TIME)
    h = s.lane(TRIAL_SIZE)
    return {STAGE_TIME: t + c * h}


# --- a step ----------------------------------------------------------------------------------


def stage(weights: Any, c: float, s: StepTape) -> New:
    """argument = x + h sum_j a_j K_j, at t + c h."""
    h = s.lane(TRIAL_SIZE)
    last = np.flatnonzero(weights)[-1]
    total = weighted_sum(s, weights[:last])
    argument = s.z(STATE)
    if total is not None:
        argument = fmuladd(h, total, argument)
    weight = h * float(weights[last])
    argument = fmuladd(weight, s.z(RATE + last), argument)
    return {ARGUMENT: argument}, stage_time(s, c)


def attempt(s: StepTape, diagonal: float | None = None) -> New:
    """The step to try: not below the resolution of time, and not beyond the end of the segment.

    An implicit one, with a `diagonal`, ends at the next sample, and sets that of its matrix.
    """
    # 1. its length
    t = s.lane(TIME)
    h = minimum(s.lane(STEP_SIZE), s.lane(MAX_STEP))
    smallest = 2.3e-15 * abs(t) + 1e-300
    enough = h >= smallest
    # 2. its end
    end = minimum(s.lane(SEGMENT_END), s.lane(STOP_AT))
    if diagonal is not None:
        end = minimum(end, s.lane(NEXT_STOP))
    trial_end = minimum(t + where(enough, h, smallest), end)
    # 3. fail if a step that was rejected, or is not a number, is too small
    too_small = where(h < smallest, s.lane(REJECTED), 1.0)
    failing = where(enough, 0.0, too_small)
    numbers = {
        TRIAL_END: trial_end,
        TRIAL_SIZE: trial_end - t,
        FAILURE: float(Status.STEP_TOO_SMALL) * failing,
    }
    if diagonal is not None:
        numbers[DIAGONAL] = 1.0 / (diagonal * (trial_end - t))
    return {}, numbers


def accept_or_reject(
    s: StepTape, error: Any, factor: Any, largest: float, least: Any = None
) -> Rows:
    """Accept a step whose error is below 1, and choose the length of the next."""
    h = s.lane(TRIAL_SIZE)
    good = error < 1.0
    accepted = where(good, 1.0, 0.0)
    rejected = where(good, 0.0, 1.0)
    # 1. the next length: at most as long as this one behind a rejected step
    most = where(s.lane(REJECTED) > 0.5, 1.0, largest)
    longer = h * minimum(most, factor)
    if least is not None:
        longer = maximum(longer, least)
    shrinking = where(error >= 1.0, maximum(0.2, factor), 0.2)  # not a number: 0.2
    size = where(good, longer, h * shrinking)
    # 2. the lane is due at a sample, at a failure, and when its tries are used up
    accepted_count = s.lane(ACCEPTED_COUNT)
    rejected_count = s.lane(REJECTED_COUNT)
    tries = accepted_count + rejected_count + 1.0
    at_stop = s.lane(TRIAL_END) >= s.lane(NEXT_STOP)
    due = where(at_stop, 1.0, s.lane(FAILURE))
    due = where(tries >= s.lane(TRIES_LEFT), 1.0, due)
    return {
        STEP_SIZE: size,
        ACCEPTED: accepted,
        REJECTED: rejected,
        STAGE_TIME: s.lane(TIME) + h,
        DUE: due,
        ACCEPTED_COUNT: accepted_count + accepted,
        REJECTED_COUNT: rejected_count + rejected,
    }


def trial_size(s: StepTape) -> New:
    """The length of a trial step, from the sizes of state and rate (row 2)."""
    state = s.z(STATE)
    rate = s.z(RATE + 1)
    scale = 1.0 / s.tolerance(abs(state))
    d0 = sqrt(mean_square(s, state * scale))
    d1 = sqrt(mean_square(s, rate * scale))
    h = where(minimum(d0, d1) < 1e-5, 1e-6, 0.01 * d0 / d1)
    h = minimum(h, s.lane(SEGMENT_END) - s.lane(TIME))
    not_finite = s.total(0.0 * state + 0.0 * rate)
    return {}, {TRIAL_SIZE: h, RATE_NORM: d1, NOT_FINITE: not_finite}


def first_step(order: int, s: StepTape) -> New:
    """The first step, from the change of the rate over the trial step (row 3)."""
    scale = 1.0 / s.tolerance(abs(s.z(STATE)))
    h = s.lane(TRIAL_SIZE)
    rate = s.z(RATE + 1)
    change = (s.z(RATE + 2) - rate) * scale
    d1 = s.lane(RATE_NORM)
    d2 = sqrt(mean_square(s, change)) / h
    most = maximum(maximum(d1, d2), 1e-30)
    cautious = maximum(1e-6, h * 1e-3)
    usual = power(0.01 / most, 1.0 / order)
    step = where(most <= 1e-15, cautious, usual)
    step = minimum(100.0 * h, step)
    step = minimum(step, s.lane(SEGMENT_END) - s.lane(TIME))
    # the user's first step, if there is one
    requested = s.lane(FIRST_STEP)
    step = where(requested > 0.0, requested, step)
    # a segment that begins without a jump of the rates goes on with rate and step
    fresh = s.lane(FRESH) > 0.5
    rate = where(fresh, rate, s.z(RATE))
    step = where(fresh, step, s.lane(STEP_SIZE))
    return {RATE: rate}, {STEP_SIZE: step}


def accept(s: StepTape) -> New:
    """The new state and its rate where the step is good, otherwise those of before."""
    good = s.lane(ACCEPTED) > 0.5
    state = where(good, s.z(ARGUMENT), s.z(STATE))
    rate = where(good, s.z(END_RATE), s.z(RATE))
    time = where(good, s.lane(TRIAL_END), s.lane(TIME))
    return {STATE: state, RATE: rate}, {TIME: time}


def cubic(s: StepTape) -> tuple[Any, Any, Any]:
    """Return the terms of the cubic with the states and rates of both ends."""
    h = s.lane(TRIAL_SIZE)
    delta = s.z(ARGUMENT) - s.z(STATE)
    rate = s.z(RATE)
    sum_of_rates = s.z(END_RATE) + rate
    quadratic = h * rate - delta
    cubic = 2.0 * delta - h * sum_of_rates
    return delta, quadratic, cubic


def dense_cubic(s: StepTape) -> New:
    """The terms of the cubic as an interpolant."""
    return interpolant_terms(s, *cubic(s)), {}


def within(s: StepTape) -> New:
    """The state of the interpolant at a share of the step, as `interpolate` has it."""
    share = s.lane(SHARE)
    factors = [share, 1.0 - share]
    state = s.z(TERMS + 6)
    for r in range(6):
        state = fmuladd(factors[r % 2], state, s.z(TERMS + 5 - r))
    state = fmuladd(share, state, s.z(STATE))
    return {WITHIN: state}, stage_time(s, share)


# --- all formulas of a method ----------------------------------------------------------------


def never_stiff(s: StepTape) -> New:
    """Count no stiff steps: of a method whose steps are not checked."""
    return {}, {}


def in_order(
    control: Formula,
    dense: Formula,
    stages: list[Formula],
    *,
    first_step_order: int = 8,
    attempt: Formula = attempt,
    accept: Formula = accept,
    stiffness: Formula = never_stiff,
) -> list[Formula]:
    """Return the formulas of a method in the solver's order; those it does not give are shared.

    The first step is that of a method of `first_step_order`; Rodas5P has that of DOP853.
    """
    return [
        attempt,
        control,
        trial_size,
        partial(stage, [0.0, 1.0], 1.0),
        partial(first_step, first_step_order),
        accept,
        dense,
        dense_cubic,
        within,
        stiffness,
        *stages,
    ]


def program_of_formulas(formulas: dict[str, Formula], n: int) -> Program:
    """Return the program of formulas for n states."""
    step = StepTape(n)
    components = Components(SimpleNamespace(entries=step.tape.operations), 0)
    writes = {}
    for name, formula in formulas.items():
        rows, numbers = formula(step)
        in_rows = [
            Port(row * n, (n,), (True,), operand(value)) for row, value in rows.items()
        ]
        in_lane = [Port(row, (), (), operand(value)) for row, value in numbers.items()]
        writes[name] = components.writes(in_rows, "X")
        writes[name] += components.writes(in_lane, "t")
    planner = Planner(components)
    # loops come first: they read numbers of the lane, which are written behind them
    functions = {
        name: tuple(sorted(planner.nests(written), key=lambda nest: not nest.lengths))
        for name, written in writes.items()
    }
    return Program(tuple(components.all), functions, {}, (), 0, 0, 0, ())
