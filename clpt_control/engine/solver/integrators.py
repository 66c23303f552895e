"""The methods as formulas: Dormand and Prince's of order 8, Rodas5P, Runge and Kutta's.

The formulas compute each stage, accept or reject a step and choose the next; `solver` decides their
order and names the rows of Z and the numbers of a lane.  A formula is an ordinary function, read as
those of a diagram are.  It becomes a program of eight states or eight runs at once, in which t are
the numbers of a lane and X the rows of Z.

DOP853: Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, 1993,
sections II.4 to II.6 and II.10; the coefficients and the choice of steps are scipy's.  Rodas5P, for
stiff equations: `rosenbrock`.  RK4, the classical method, takes steps of one length.  In discrete
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
from . import rosenbrock as rodas
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
    MAP,
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

LAST_TERM = 1.23e-3  # share of the interpolant's last term that is its error in a stiff step
TRUSTED = 100.0  # tolerances: the largest error of the interpolant
Rows = dict[int, Any]
fmuladd = partial(elementwise, "fmuladd")  # a b + c, rounded once where the processor can


class StepTape:
    """The tape of formulas: rows of Z, for each of n states, and numbers of the lane."""

    def __init__(self, n: int):
        self.n, self.tape = n, Tape()

    def z(self, row: int) -> Any:
        """Return a row of Z."""
        return self.tape.add("load", (), (self.n,), ("X", row * self.n))

    def lane(self, row: int) -> Any:
        """Return a number of the lane."""
        return self.tape.add("load", (), (), ("t", row))

    def tolerance(self, size: Any) -> Any:
        """Return the tolerance of states of a size."""
        relative, absolute = (self.tape.add("load", (), (), ("T", k)) for k in range(2))
        return fmuladd(relative, size, absolute)

    def total(self, value: Any) -> Any:
        """Return the sum over the states."""
        return self.tape.add("sum", (operand(value),), (), (0, self.n, True))


New = tuple[Rows, Rows]  # the new rows of Z, and the new numbers of the lane
Formula = Callable[[StepTape], New]


def _sum(s: StepTape, weights: Any, first: int = RATE, total: Any = None) -> Any:
    """Return total + a_0 K_0 + a_1 K_1 + ..., with the rows from `first` on; zeros are left out."""
    for j, a in enumerate(np.asarray(weights).tolist(), first):
        if a != 0.0:
            total = a * s.z(j) if total is None else fmuladd(a, s.z(j), total)
    return total


def _terms(s: StepTape, *terms: Any) -> Rows:
    """Return the terms of an interpolant, as `layout.interpolate` sums them."""
    every = [*terms, *[0.0 * s.z(STATE)] * (7 - len(terms))]
    return dict(enumerate(every, TERMS))


def _at(s: StepTape, c: float) -> Rows:
    return {STAGE_TIME: s.lane(TIME) + c * s.lane(TRIAL_SIZE)}


def _stage(weights: Any, c: float, s: StepTape) -> New:
    """argument = x + h sum_j a_j K_j, at t + c h."""
    h, last = s.lane(TRIAL_SIZE), np.flatnonzero(weights)[-1]
    total = _sum(s, weights[:last])
    argument = s.z(STATE) if total is None else fmuladd(h, total, s.z(STATE))
    argument = fmuladd(h * float(weights[last]), s.z(RATE + last), argument)
    return {ARGUMENT: argument}, _at(s, c)


def _new_again(s: StepTape) -> New:
    """The new state once more, to the bit: stages of the interpolant have been in its place."""
    return {ARGUMENT: _new_state(s)[1]}, _at(s, 1.0)


def _attempt(s: StepTape, implicit: bool = False) -> New:
    """The step to try: not below the resolution of time, and not beyond the end of the piece.

    An implicit one ends at the next sample, and sets the diagonal of its matrix.
    """
    t, h = s.lane(TIME), minimum(s.lane(STEP_SIZE), s.lane(MAX_STEP))
    smallest = 2.3e-15 * abs(t) + 1e-300
    enough = h >= smallest
    end = minimum(s.lane(SEGMENT_END), s.lane(STOP_AT))
    end = minimum(end, s.lane(NEXT_STOP)) if implicit else end
    new = minimum(t + where(enough, h, smallest), end)
    failing = where(enough, 0.0, where(h < smallest, s.lane(REJECTED), 1.0))
    numbers = {TRIAL_END: new, TRIAL_SIZE: new - t, FAILURE: float(Status.STEP_TOO_SMALL) * failing}
    return {}, numbers | ({DIAGONAL: 1.0 / (rodas.GAMMA * (new - t))} if implicit else {})


def _accept_or_reject(
    s: StepTape, error: Any, factor: Any, largest: float, least: Any = None
) -> Rows:
    """Whether a step is good, the length of the next, and whether the lane is looked at."""
    good, most = error < 1.0, where(s.lane(REJECTED) > 0.5, 1.0, largest)
    bad = where(error >= 1.0, maximum(0.2, factor), 0.2)  # not a number: 0.2
    longer = s.lane(TRIAL_SIZE) * minimum(most, factor)
    longer = longer if least is None else maximum(longer, least)
    tried = s.lane(ACCEPTED_COUNT) + s.lane(REJECTED_COUNT) + 1.0
    look = where(s.lane(TRIAL_END) >= s.lane(NEXT_STOP), 1.0, s.lane(FAILURE))
    return {
        STEP_SIZE: where(good, longer, s.lane(TRIAL_SIZE) * bad),
        ACCEPTED: where(good, 1.0, 0.0),
        REJECTED: where(good, 0.0, 1.0),
        STAGE_TIME: s.lane(TIME) + s.lane(TRIAL_SIZE),
        DUE: where(tried >= s.lane(TRIES_LEFT), 1.0, look),
        ACCEPTED_COUNT: s.lane(ACCEPTED_COUNT) + where(good, 1.0, 0.0),
        REJECTED_COUNT: s.lane(REJECTED_COUNT) + where(good, 0.0, 1.0),
    }


def _new_state(s: StepTape) -> tuple[Any, Any]:
    """Return the rate over the step, and the state at its end."""
    rate = _sum(s, table.B)
    return rate, fmuladd(s.lane(TRIAL_SIZE), rate, s.z(STATE))


def _control(s: StepTape) -> New:
    """The new state, the estimate of its error, whether the step is good, and the next length."""
    beyond = table.E3[:DOP853] - table.B  # most of E3 is B
    rate, state = _new_state(s)
    part = 1.0 / s.tolerance(maximum(abs(s.z(STATE)), abs(state)))
    fifth, third = _sum(s, table.E5) * part, _sum(s, beyond, total=rate) * part
    fifth, third = s.total(fifth * fifth), s.total(third * third)
    none = fifth + third <= 0.0
    whole = sqrt(where(none, 1.0, (fifth + 0.01 * third) * float(s.n)))
    error = where(none, 1e-30, s.lane(TRIAL_SIZE) * fifth / whole)
    factor = 0.9 / sqrt(sqrt(sqrt(maximum(error, 1e-30))))
    return {ARGUMENT: state}, _accept_or_reject(s, error, factor, 10.0)


def _sizes(s: StepTape) -> New:
    """The length of a trial step, from the sizes of state and rate (row 2)."""
    part = 1.0 / s.tolerance(abs(s.z(STATE)))
    x, f = s.z(STATE) * part, s.z(RATE + 1) * part
    d0, d1 = sqrt(s.total(x * x) / float(s.n)), sqrt(s.total(f * f) / float(s.n))
    h = where(minimum(d0, d1) < 1e-5, 1e-6, 0.01 * d0 / d1)
    h = minimum(h, s.lane(SEGMENT_END) - s.lane(TIME))
    trouble = s.total(0.0 * s.z(STATE) + 0.0 * s.z(RATE + 1))
    return {}, {TRIAL_SIZE: h, RATE_NORM: d1, NOT_FINITE: trouble}


def _first(order: int, s: StepTape) -> New:
    """The first step, from the change of the rate over the trial step (row 3)."""
    part, fresh = 1.0 / s.tolerance(abs(s.z(STATE))), s.lane(FRESH) > 0.5
    change = (s.z(RATE + 2) - s.z(RATE + 1)) * part
    h = s.lane(TRIAL_SIZE)
    d1, d2 = s.lane(RATE_NORM), sqrt(s.total(change * change) / float(s.n)) / h
    most = maximum(maximum(d1, d2), 1e-30)
    step = where(most <= 1e-15, maximum(1e-6, h * 1e-3), power(0.01 / most, 1.0 / order))
    step = minimum(minimum(100.0 * h, step), s.lane(SEGMENT_END) - s.lane(TIME))
    step = where(s.lane(FIRST_STEP) > 0.0, s.lane(FIRST_STEP), step)
    rate = where(fresh, s.z(RATE + 1), s.z(RATE))
    return {RATE: rate}, {STEP_SIZE: where(fresh, step, s.lane(STEP_SIZE))}


def _accept(s: StepTape) -> New:
    """The new state and its rate where the step is good, else those of before."""
    good = s.lane(ACCEPTED) > 0.5
    state = where(good, s.z(ARGUMENT), s.z(STATE))
    rate = where(good, s.z(RATE + DOP853), s.z(RATE))
    time = where(good, s.lane(TRIAL_END), s.lane(TIME))
    return {STATE: state, RATE: rate}, {TIME: time}


def _cubic(s: StepTape) -> tuple[Any, Any, Any]:
    """Return the terms of the cubic with the states and rates of both ends."""
    h, delta = s.lane(TRIAL_SIZE), s.z(ARGUMENT) - s.z(STATE)
    ends = s.z(RATE + DOP853) + s.z(RATE)
    return delta, h * s.z(RATE) - delta, 2.0 * delta - h * ends


def _dense(s: StepTape) -> New:
    """The terms of the interpolant of order 7, and its error.

    It is as exact as the ends of the step, if the step resolves all states.  If the fastest state
    keeps the step short by stability alone, it is up to 10,000 times less exact; its last term
    estimates that.
    """
    terms = [*_cubic(s), *(s.lane(TRIAL_SIZE) * _sum(s, own) for own in table.D)]
    largest = maximum(abs(s.z(STATE)), abs(s.z(ARGUMENT)))
    part = (LAST_TERM / TRUSTED) * terms[-1] / s.tolerance(largest)
    return _terms(s, *terms), {INTERPOLANT_ERROR: sqrt(s.total(part * part))}


def _stiffness(last: Any, limit: float, s: StepTape) -> New:
    """Whether the step is stiff: rates change `limit` times as fast as the states do.

    Hairer's test compares the new state and the argument of the `last` stage.  Six steps that are
    not stiff cancel those that are.
    """
    h = s.lane(TRIAL_SIZE)
    rates = s.z(RATE + DOP853) - s.z(RATE + DOP853 - 1)
    states = s.z(ARGUMENT) - fmuladd(h, _sum(s, last), s.z(STATE))
    before, calm = s.lane(STIFF_STEPS), s.lane(CALM_STEPS) + 1.0
    checked = s.lane(CHECKS_STIFFNESS) > 0.5  # so that a run is the same beside any others
    stiff = h * h * s.total(rates * rates) > limit * limit * s.total(states * states)
    others = where(calm > 5.5, minimum(before, 0.0), before)
    steps = where(before < 0.0, before + 1.0, where(stiff, before + 1.0, others))
    return {}, {
        STIFF_STEPS: where(checked, steps, before),
        CALM_STEPS: where(checked, where(stiff, 0.0, calm), s.lane(CALM_STEPS)),
    }


# --- Runge and Kutta's method of order 4, and discrete time -----------------------------------


def _attempt_fixed(s: StepTape) -> New:
    """One of equal steps up to the next sample, or the end of the piece."""
    ahead = s.lane(NEXT_STOP) - s.lane(TIME)
    rounded = ahead * (1.0 - 1e-12) - 1e-15 * abs(s.lane(NEXT_STOP))  # as times are rounded
    steps = maximum(1.0, ceil(rounded / s.lane(MAX_STEP)))
    new = where(steps > 1.0, s.lane(TIME) + ahead / steps, s.lane(NEXT_STOP))
    return {}, {TRIAL_END: new, TRIAL_SIZE: ahead / steps}


def _runge_kutta(s: StepTape) -> Any:
    """Return the state at the end of a step of RK4."""
    outer = s.z(RATE) + s.z(RATE + 3)
    inner = s.z(RATE + 1) + s.z(RATE + 2)
    return fmuladd(s.lane(TRIAL_SIZE) / 6.0, fmuladd(2.0, inner, outer), s.z(STATE))


def _control_fixed(ahead: Callable[[StepTape], Any], s: StepTape) -> New:
    """The new state, which is `ahead`, and whether it is finite; else the run has ended."""
    state, new, tried = ahead(s), s.lane(TRIAL_END), s.lane(ACCEPTED_COUNT) + 1.0
    good = s.total(0.0 * state) <= 0.0
    failing = where(good, 0.0, float(Status.NOT_FINITE))
    look = where((new >= s.lane(NEXT_STOP)) | (tried >= s.lane(TRIES_LEFT)), 1.0, failing)
    numbers = {ACCEPTED: where(good, 1.0, 0.0), DUE: look, STAGE_TIME: new}
    return {ARGUMENT: state}, numbers | {ACCEPTED_COUNT: tried, FAILURE: failing}


# --- Rodas5P --------------------------------------------------------------------------------


def _stage_implicit(number: int, s: StepTape) -> New:
    """The argument of a stage, counted from 0, and the term beside its rate on the right."""
    addend = (rodas.OF_TIME[number] * s.lane(TRIAL_SIZE)) * s.z(TIME_SLOPE)
    ahead = s.z(STATE)
    if number:
        addend = fmuladd(1.0 / s.lane(TRIAL_SIZE), _sum(s, rodas.C[number], SOLVED), addend)
        ahead = ahead + _sum(s, rodas.weights(number), SOLVED)
    return {ARGUMENT: ahead, ADDEND: addend}, _at(s, rodas.TIMES[number])


def _control_order_5(s: StepTape, error: Any, new: Any, largest: float) -> Rows:
    """Whether a step is good by its error, of order 5, and the length of the next."""
    part = error / s.tolerance(maximum(abs(s.z(STATE)), abs(new)))
    square = s.total(part * part) / float(s.n)
    factor = 0.9 * power(maximum(square, 1e-30), -0.1)  # error^(-1/5)
    # the step before may be short because of a sample, or the end of a piece
    least = minimum(s.lane(TRIAL_SIZE) * factor, s.lane(STEP_SIZE))
    return _accept_or_reject(s, square, factor, largest, least)


def _control_implicit(s: StepTape) -> New:
    """The new state, the estimate of its error, whether the step is good, and the next length."""
    new = s.z(STATE) + _sum(s, rodas.weights(len(rodas.C)), SOLVED)
    error = s.z(SOLVED + len(rodas.C) - 1)
    return {ARGUMENT: new}, _control_order_5(s, error, new, 6.0)


def _dense_implicit(s: StepTape) -> New:
    """The terms of the interpolant."""
    k1, k2, k3 = (_sum(s, own, SOLVED) for own in rodas.BETWEEN)
    return _terms(s, s.z(ARGUMENT) - s.z(STATE), k1, k2 + k3, -k3), {}


# --- each a table ---------------------------------------------------------------------------


def formulas(method: int) -> dict[str, Formula]:
    """Return the formulas of a method, by its number in the solver, in the solver's order."""
    own: dict[str, Formula] = {
        **{"attempt": _attempt, "control": _control, "sizes": _sizes},
        **{"trial": partial(_stage, [0.0, 1.0], 1.0), "first": partial(_first, 8)},
        **{"accept": _accept, "dense": _dense, "cubic": lambda s: (_terms(s, *_cubic(s)), {})},
        "stiffness": partial(_stiffness, table.A[11, :11], 6.1),
    }
    stages: list[Formula] = [
        partial(_stage, table.A[k, :k], float(table.C[k])) for k in range(1, DOP853 + 4)
    ]
    stages[DOP853 - 1] = _new_again
    if method == RODAS5P:
        own |= {"attempt": partial(_attempt, implicit=True), "dense": _dense_implicit}
        own |= {"control": _control_implicit}
        stages = [partial(_stage_implicit, k) for k in range(RODAS5P - 1)]
    elif method in (RK4, MAP):
        new = _runge_kutta if method == RK4 else lambda s: s.z(RATE)
        own |= {"attempt": _attempt_fixed, "control": partial(_control_fixed, new)}
        own |= {"accept": lambda s: ({STATE: s.z(ARGUMENT)}, {TIME: s.lane(TRIAL_END)})}
        own |= {"dense": lambda s: ({TERMS: s.z(ARGUMENT) - s.z(STATE)}, {})}
        shares = enumerate([0.5, 0.5, 1.0][: method - 1])  # of the step: each stage has one weight
        stages = [partial(_stage, [*[0.0] * k, c], c) for k, c in shares]
    return own | {f"stage_{k}": one for k, one in enumerate(stages, 1)}


def program_of_formulas(formulas: dict[str, Formula], n: int) -> Program:
    """Return the program of formulas for n states."""
    step = StepTape(n)
    components = Components(SimpleNamespace(entries=step.tape.operations), 0)
    writes = {}
    for name, formula in formulas.items():
        rows, numbers = formula(step)
        states = [Port(r * n, (n,), (True,), operand(value)) for r, value in rows.items()]
        others = [Port(r, (), (), operand(value)) for r, value in numbers.items()]
        writes[name] = components.writes(states, "X") + components.writes(others, "t")
    plan = Planner(components)
    # loops come first: they read numbers of the lane, which are written behind them
    functions = {
        name: tuple(sorted(plan.nests(own), key=lambda nest: not nest.lengths))
        for name, own in writes.items()
    }
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
    """Return what the solver calls, the formulas of its method behind the diagram's functions."""
    n = callee.nstates
    formulas = kernels(n, callee.lanes, callee.method) if n else None
    more = formulas.addresses.values() if formulas else ()
    functions = np.array([*callee.functions, *more], dtype=np.int64)
    return callee._replace(functions=functions, code=(*callee.code, formulas))
