"""Integration methods as formulas: Dormand and Prince's of order 8, Rodas5P, Runge and Kutta's.

The formulas compute each stage, accept or reject a step and choose the next.  `time_stepper` calls
them in order; `solver_layout` names the rows of Z and the numbers of a lane.  A formula is an
ordinary function that is traced as those of a diagram are.  It becomes a program of eight states or
eight runs at once, in which t are the numbers of a lane and X the rows of Z.

DOP853: Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, 1993,
sections II.4 to II.6 and II.10; the coefficients and the choice of steps are scipy's.  Rodas5P, for
stiff equations: `rodas5p`.  RK4, the classical method, takes steps of one length.  In discrete
time a step leads from one sample to the next.
"""

from collections.abc import Callable
from functools import partial
from types import SimpleNamespace
from typing import Any

import numpy as np
from numpy import ceil, maximum, minimum, power, sqrt, where
from scipy.integrate._ivp import dop853_coefficients as table

from ..codegen.fused_expressions import Components
from ..codegen.llvm_text import print_program
from ..codegen.machine import Machine, once
from ..codegen.plan import Planner, Program
from ..codegen.switching_conditions import Port
from ..trace.arrays import Tape, operand
from ..trace.elementwise import elementwise
from . import rodas5p as rodas
from .batch import Callee
from .solver_layout import (
    ACCEPTED,
    ACCEPTED_COUNT,
    ADDEND,
    ARGUMENT,
    CALM_STEPS,
    CHECKS_STIFFNESS,
    DIAGONAL,
    DOP853,
    DUE,
    FAILURE,
    FIRST_STEP,
    FRESH,
    INTERPOLANT_ERROR,
    MAX_STEP,
    NEXT_STOP,
    NOT_FINITE,
    RATE,
    RATE_NORM,
    REJECTED,
    REJECTED_COUNT,
    RK4,
    RODAS5P,
    SEGMENT_END,
    SOLVED,
    STAGE_TIME,
    STATE,
    STEP_SIZE,
    STIFF_STEPS,
    STOP_AT,
    TERMS,
    TIME,
    TIME_SLOPE,
    TRIAL_END,
    TRIAL_SIZE,
    TRIES_LEFT,
    Status,
)

# share of the interpolant's last term that is its error in a stiff step
LAST_TERM = 1.23e-3
TRUSTED = 100.0  # tolerances: the largest error of the interpolant
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


def _sum(s: StepTape, weights: Any, row: int = RATE, total: Any = None) -> Any:
    """Return total + a_0 K_0 + a_1 K_1 + ..., with the rows from `row` on; zeros are left out."""
    for a in np.asarray(weights).tolist():
        if a != 0.0:
            rate = s.z(row)
            total = a * rate if total is None else fmuladd(a, rate, total)
        row += 1
    return total


def _mean_square(s: StepTape, value: Any) -> Any:
    return s.total(value * value) / float(s.n)


def _terms(s: StepTape, *terms: Any) -> Rows:
    """Return the terms of an interpolant, as `solver_layout.interpolate` sums them."""
    missing = 7 - len(terms)
    zeros = [0.0 * s.z(STATE)] * missing
    return dict(enumerate([*terms, *zeros], TERMS))


def _stage_time(s: StepTape, c: float) -> Rows:
    t = s.lane(TIME)
    h = s.lane(TRIAL_SIZE)
    return {STAGE_TIME: t + c * h}


# --- DOP853 -----------------------------------------------------------------------------------


def _stage(weights: Any, c: float, s: StepTape) -> New:
    """argument = x + h sum_j a_j K_j, at t + c h."""
    h = s.lane(TRIAL_SIZE)
    last = np.flatnonzero(weights)[-1]
    total = _sum(s, weights[:last])
    argument = s.z(STATE)
    if total is not None:
        argument = fmuladd(h, total, argument)
    weight = h * float(weights[last])
    argument = fmuladd(weight, s.z(RATE + last), argument)
    return {ARGUMENT: argument}, _stage_time(s, c)


def _stage_at_end(s: StepTape) -> New:
    """The new state again, equal to the bit: stages of the interpolant have overwritten it."""
    _, state = _new_state(s)
    return {ARGUMENT: state}, _stage_time(s, 1.0)


def _attempt(s: StepTape, implicit: bool = False) -> New:
    """The step to try: not below the resolution of time, and not beyond the end of the segment.

    An implicit one ends at the next sample, and sets the diagonal of its matrix.
    """
    # 1. its length
    t = s.lane(TIME)
    h = minimum(s.lane(STEP_SIZE), s.lane(MAX_STEP))
    smallest = 2.3e-15 * abs(t) + 1e-300
    enough = h >= smallest
    # 2. its end
    end = minimum(s.lane(SEGMENT_END), s.lane(STOP_AT))
    if implicit:
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
    if implicit:
        numbers[DIAGONAL] = 1.0 / (rodas.GAMMA * (trial_end - t))
    return {}, numbers


def _accept_or_reject(
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


def _new_state(s: StepTape) -> tuple[Any, Any]:
    """Return the rate over the step, and the state at its end."""
    rate = _sum(s, table.B)
    return rate, fmuladd(s.lane(TRIAL_SIZE), rate, s.z(STATE))


def _control(s: StepTape) -> New:
    """The new state, the estimate of its error, and the length of the next step.

    err = h |e_5|^2 / sqrt((|e_5|^2 + 0.01 |e_3|^2) n) of the errors of orders 5 and 3.
    """
    rate, state = _new_state(s)
    largest = maximum(abs(s.z(STATE)), abs(state))
    scale = 1.0 / s.tolerance(largest)
    fifth = _sum(s, table.E5) * scale
    third_from_rate = table.E3[:DOP853] - table.B  # most of E3 is B
    third = _sum(s, third_from_rate, total=rate) * scale
    fifth = s.total(fifth * fifth)
    third = s.total(third * third)
    # no error at all counts as tiny
    exact = fifth + third <= 0.0
    square = (fifth + 0.01 * third) * float(s.n)
    size = sqrt(where(exact, 1.0, square))
    error = where(exact, 1e-30, s.lane(TRIAL_SIZE) * fifth / size)
    eighth_root = sqrt(sqrt(sqrt(maximum(error, 1e-30))))
    factor = 0.9 / eighth_root
    return {ARGUMENT: state}, _accept_or_reject(s, error, factor, 10.0)


def _trial_size(s: StepTape) -> New:
    """The length of a trial step, from the sizes of state and rate (row 2)."""
    state = s.z(STATE)
    rate = s.z(RATE + 1)
    scale = 1.0 / s.tolerance(abs(state))
    d0 = sqrt(_mean_square(s, state * scale))
    d1 = sqrt(_mean_square(s, rate * scale))
    h = where(minimum(d0, d1) < 1e-5, 1e-6, 0.01 * d0 / d1)
    h = minimum(h, s.lane(SEGMENT_END) - s.lane(TIME))
    not_finite = s.total(0.0 * state + 0.0 * rate)
    return {}, {TRIAL_SIZE: h, RATE_NORM: d1, NOT_FINITE: not_finite}


def _first_step(order: int, s: StepTape) -> New:
    """The first step, from the change of the rate over the trial step (row 3)."""
    scale = 1.0 / s.tolerance(abs(s.z(STATE)))
    h = s.lane(TRIAL_SIZE)
    rate = s.z(RATE + 1)
    change = (s.z(RATE + 2) - rate) * scale
    d1 = s.lane(RATE_NORM)
    d2 = sqrt(_mean_square(s, change)) / h
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


def _accept(s: StepTape) -> New:
    """The new state and its rate where the step is good, otherwise those of before."""
    good = s.lane(ACCEPTED) > 0.5
    state = where(good, s.z(ARGUMENT), s.z(STATE))
    rate = where(good, s.z(RATE + DOP853), s.z(RATE))
    time = where(good, s.lane(TRIAL_END), s.lane(TIME))
    return {STATE: state, RATE: rate}, {TIME: time}


def _cubic(s: StepTape) -> tuple[Any, Any, Any]:
    """Return the terms of the cubic with the states and rates of both ends."""
    h = s.lane(TRIAL_SIZE)
    delta = s.z(ARGUMENT) - s.z(STATE)
    rate = s.z(RATE)
    sum_of_rates = s.z(RATE + DOP853) + rate
    quadratic = h * rate - delta
    cubic = 2.0 * delta - h * sum_of_rates
    return delta, quadratic, cubic


def _dense_cubic(s: StepTape) -> New:
    """The terms of the cubic as an interpolant."""
    return _terms(s, *_cubic(s)), {}


def _dense(s: StepTape) -> New:
    """The terms of the interpolant of order 7, and its error.

    It is as exact as the ends of the step, if the step resolves all states.  If the fastest state
    keeps the step short by stability alone, it is up to 10,000 times less exact; its last term
    estimates that.
    """
    h = s.lane(TRIAL_SIZE)
    terms = [*_cubic(s)]
    terms += [h * _sum(s, weights) for weights in table.D]
    before = abs(s.z(STATE))
    after = abs(s.z(ARGUMENT))
    largest = maximum(before, after)
    share = LAST_TERM / TRUSTED
    scaled = share * terms[-1] / s.tolerance(largest)
    error = sqrt(s.total(scaled * scaled))
    return _terms(s, *terms), {INTERPOLANT_ERROR: error}


def _stiffness(last: Any, limit: float, s: StepTape) -> New:
    """Count stiff steps: rates change `limit` times as fast as the states do.

    Hairer's test compares the new state and the argument of the `last` stage.  Six steps that are
    not stiff cancel those that are.
    """
    # 1. changes of rates and states between the two
    h = s.lane(TRIAL_SIZE)
    rates = s.z(RATE + DOP853) - s.z(RATE + DOP853 - 1)
    argument = fmuladd(h, _sum(s, last), s.z(STATE))
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


# --- Runge and Kutta's method of order 4, and discrete time -----------------------------------


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


# --- Rodas5P ----------------------------------------------------------------------------------


def _stage_implicit(number: int, s: StepTape) -> New:
    """The argument of a stage, counted from 0, and the term added to its rate on the right."""
    h = s.lane(TRIAL_SIZE)
    addend = (rodas.OF_TIME[number] * h) * s.z(TIME_SLOPE)
    argument = s.z(STATE)
    if number:
        total = _sum(s, rodas.C[number], SOLVED)
        addend = fmuladd(1.0 / h, total, addend)
        argument = argument + _sum(s, rodas.weights(number), SOLVED)
    rows = {ARGUMENT: argument, ADDEND: addend}
    return rows, _stage_time(s, rodas.TIMES[number])


def _control_implicit(s: StepTape) -> New:
    """The new state, the estimate of its error, of order 5, and the length of the next step."""
    stages = len(rodas.C)
    change = _sum(s, rodas.weights(stages), SOLVED)
    state = s.z(STATE) + change
    largest = maximum(abs(s.z(STATE)), abs(state))
    error = s.z(SOLVED + stages - 1)
    error = error / s.tolerance(largest)
    square = _mean_square(s, error)
    factor = 0.9 * power(maximum(square, 1e-30), -0.1)  # error^(-1/5)
    # the step before may be short because of a sample, or the end of a segment
    least = minimum(s.lane(TRIAL_SIZE) * factor, s.lane(STEP_SIZE))
    return {ARGUMENT: state}, _accept_or_reject(s, square, factor, 6.0, least)


def _dense_implicit(s: StepTape) -> New:
    """The terms of the interpolant."""
    k1, k2, k3 = [_sum(s, weights, SOLVED) for weights in rodas.BETWEEN]
    delta = s.z(ARGUMENT) - s.z(STATE)
    return _terms(s, delta, k1, k2 + k3, -k3), {}


# --- the formulas of each method --------------------------------------------------------------


def formulas(method: int) -> dict[str, Formula]:
    """Return the formulas of a method, by its number in the solver, in the solver's order."""
    named: dict[str, Formula] = {
        "attempt": _attempt,
        "control": _control,
        "sizes": _trial_size,
        "trial": partial(_stage, [0.0, 1.0], 1.0),
        "first": partial(_first_step, 8),
        "accept": _accept,
        "dense": _dense,
        "cubic": _dense_cubic,
        "stiffness": partial(_stiffness, table.A[11, :11], 6.1),
    }
    stages: list[Formula] = []
    if method == DOP853:
        times = table.C.tolist()
        rows = range(1, DOP853 + 4)
        stages = [partial(_stage, table.A[k, :k], times[k]) for k in rows]
        stages[DOP853 - 1] = _stage_at_end
    elif method == RODAS5P:
        named["attempt"] = partial(_attempt, implicit=True)
        named["control"] = _control_implicit
        named["dense"] = _dense_implicit
        stages = [partial(_stage_implicit, k) for k in range(RODAS5P - 1)]
    else:  # RK4 and MAP
        named["attempt"] = _attempt_fixed
        named["control"] = partial(
            _control_fixed, _runge_kutta if method == RK4 else _next_sample
        )
        named["accept"] = _accept_fixed
        named["dense"] = _dense_fixed
        times = [0.5, 0.5, 1.0] if method == RK4 else []
        for k, c in enumerate(times):  # each stage has one weight
            weights = [0.0] * k + [c]
            stages.append(partial(_stage, weights, c))
    for k, stage in enumerate(stages, 1):
        named[f"stage_{k}"] = stage
    return named


def program_of_formulas(formulas: dict[str, Formula], n: int) -> Program:
    """Return the program of formulas for n states."""
    step = StepTape(n)
    components = Components(SimpleNamespace(entries=step.tape.operations), 0)
    writes = {}
    for name, formula in formulas.items():
        rows, numbers = formula(step)
        in_rows = []
        for row, value in rows.items():
            in_rows.append(Port(row * n, (n,), (True,), operand(value)))
        in_lane = []
        for row, value in numbers.items():
            in_lane.append(Port(row, (), (), operand(value)))
        writes[name] = components.writes(in_rows, "X")
        writes[name] += components.writes(in_lane, "t")
    planner = Planner(components)
    functions = {}
    for name, written in writes.items():
        # loops come first: they read numbers of the lane, which are written behind them
        nests = planner.nests(written)
        ordered = sorted(nests, key=lambda nest: not nest.lengths)
        functions[name] = tuple(ordered)
    return Program(tuple(components.all), functions, {}, (), 0, 0, 0, ())


@once(16)
def kernels(n: int, lanes: int, method: int) -> Machine:
    """Return the formulas of a method for n states as machine code."""
    named = formulas(method)
    return Machine(
        named,
        f"formulas {n} {lanes} {method}",
        lambda: print_program(program_of_formulas(named, n), tuple(named), lanes),
        plain=True,
    )


def with_formulas(callee: Callee) -> Callee:
    """Return a callee with the formulas of its method behind the diagram's functions."""
    addresses: list[int] = [*callee.functions]
    machine = None
    if callee.nstates:
        machine = kernels(callee.nstates, callee.lanes, callee.method)
        addresses += machine.addresses.values()
    functions = np.array(addresses, dtype=np.int64)
    return callee._replace(functions=functions, code=(*callee.code, machine))
