"""The methods as formulas: Dormand and Prince's of order 8 and 5, Rodas5P, Runge and Kutta's.

The formulas compute each stage, judge a step and choose the next; `solver` decides nothing
but what comes after what.  It names the rows of Z and of what a lane is doing.  A formula is an
ordinary function of numbers, read as a diagram's are: a program of eight states or eight runs at
once, to which numbers of a lane are t, and rows of Z are X.

DOP853 and DOPRI5: Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, 1993,
sections II.4 to II.6 and II.10; the coefficients and the choice of steps are scipy's.  Rodas5P, for
stiff equations: `rosenbrock`.  RK4, the classical method, takes steps of one length.
"""

from collections.abc import Callable
from functools import partial
from types import SimpleNamespace
from typing import Any

import numpy as np
from numpy import ceil, maximum, minimum, power, sqrt, where

from ..equations.arrays import Tape, elementwise, operand
from . import rosenbrock as rodas
from . import solver as row
from .components import Components
from .decisions import Port
from .machine import Machine, once
from .plan import Planner, Program

LAST_TERM = 1.23e-3  # of the interpolant: what is wrong within a step that stability keeps short
TRUSTED = 100.0  # tolerances that a state between a step's ends may be wrong by
BEGUN = range(9, 12)  # stages whose sums stage 8 begins, as its own reads what they read
Rows = dict[int, Any]
joined = partial(elementwise, "fmuladd")  # a b + c, rounded once where the processor can


class Step:
    """What formulas are made of: rows of Z, for each of n states, and numbers of the lane."""

    def __init__(self, n: int):
        self.n, self.tape = n, Tape()

    def z(self, row: int) -> Any:
        """Return a row of Z."""
        return self.tape.add("load", (), (self.n,), ("X", row * self.n))

    def lane(self, row: int) -> Any:
        """Return a number of the lane."""
        return self.tape.add("load", (), (), ("t", row))

    def tolerance(self, size: Any) -> Any:
        """Return by how much states of that size may be wrong."""
        relative, absolute = (self.tape.add("load", (), (), ("T", k)) for k in range(2))
        return joined(relative, size, absolute)

    def total(self, value: Any) -> Any:
        """Return the sum over the states."""
        return self.tape.add("sum", (operand(value),), (), (0, self.n, True))


Made = tuple[Rows, Rows]  # what becomes of rows of Z, and of numbers
Formula = Callable[[Step], Made]


def _table() -> Any:
    from scipy.integrate._ivp import dop853_coefficients

    return dop853_coefficients


def _table_of_dopri5() -> Any:
    from scipy.integrate import RK45

    return RK45


def _sum(s: Step, weights: Any, first: int = row.RATE, total: Any = None) -> Any:
    """What is begun, + a_0 K_0 + a_1 K_1 + ..., from a row on, zeros left out."""
    for j, a in enumerate(np.asarray(weights).tolist(), first):
        if a != 0.0:
            total = a * s.z(j) if total is None else joined(a, s.z(j), total)
    return total


def _terms(s: Step, *terms: Any) -> Rows:
    """The terms of what is within the step, in the form in which `solver.between` sums them."""
    given = [*terms, *[0.0 * s.z(row.STATE)] * (7 - len(terms))]
    return dict(enumerate(given, row.TERMS))


def _at(s: Step, c: float) -> Rows:
    return {row.AT: s.lane(row.TIME) + c * s.lane(row.TAKEN)}


def _stage(weights: Any, c: float, s: Step, begun: int | None = None, begins: Any = ()) -> Made:
    """argument = x + h sum_j a_j K_j, at t + c h; some sums are `begun` in the rows of terms."""
    total = _sum(s, weights, total=None if begun is None else s.z(begun))
    rows = {row.ARGUMENT: joined(s.lane(row.TAKEN), total, s.z(row.STATE))}
    return rows | {row.TERMS + k: _sum(s, other) for k, other in enumerate(begins)}, _at(s, c)


def _stage_of_dop853(number: int, s: Step) -> Made:
    """Stage 1 to 15, counted from 0; stage 12 is the new state."""
    table, last = _table(), BEGUN[0] - 1
    weights, c = table.A[number, :number], float(table.C[number])
    if number in BEGUN:
        rest = np.where(np.arange(number) < last, 0.0, weights)
        return _stage(rest, c, s, row.TERMS + number - BEGUN[0])
    return _stage(weights, c, s, begins=table.A[BEGUN, :last] if number == last else ())


def _attempt(s: Step, implicit: bool = False) -> Made:
    """The step to try, not below what time can tell: up to the end of the piece, or a sample.

    An implicit one does not go beyond a sample, and has what stands on its matrix's diagonal.
    """
    t, h = s.lane(row.TIME), minimum(s.lane(row.STEP), s.lane(row.LONGEST))
    smallest = 2.3e-15 * abs(t) + 1e-300
    enough = h >= smallest
    end = minimum(s.lane(row.END), s.lane(row.WANTED))
    end = minimum(end, s.lane(row.NEXT)) if implicit else end
    new = minimum(t + where(enough, h, smallest), end)
    failing = where(enough, 0.0, where(h < smallest, s.lane(row.REJECTED), 1.0))
    numbers = {row.NEW: new, row.TAKEN: new - t, row.FAILING: float(row.TOO_SMALL) * failing}
    return {}, numbers | ({row.DIAGONAL: 1.0 / (rodas.GAMMA * (new - t))} if implicit else {})


def _judged(s: Step, error: Any, factor: Any, largest: float, least: Any = None) -> Rows:
    """Whether a step is good, the next one, and whether the lane is looked at."""
    good, most = error < 1.0, where(s.lane(row.REJECTED) > 0.5, 1.0, largest)
    bad = where(error >= 1.0, maximum(0.2, factor), 0.2)  # not a number: 0.2
    longer = s.lane(row.TAKEN) * minimum(most, factor)
    longer = longer if least is None else maximum(longer, least)
    tried = s.lane(row.GOOD_ONES) + s.lane(row.BAD_ONES) + 1.0
    look = where(s.lane(row.NEW) >= s.lane(row.NEXT), 1.0, s.lane(row.FAILING))
    return {
        row.STEP: where(good, longer, s.lane(row.TAKEN) * bad),
        row.GOOD: where(good, 1.0, 0.0),
        row.REJECTED: where(good, 0.0, 1.0),
        row.AT: s.lane(row.TIME) + s.lane(row.TAKEN),
        row.LOOK: where(tried >= s.lane(row.SPARE), 1.0, look),
        row.GOOD_ONES: s.lane(row.GOOD_ONES) + where(good, 1.0, 0.0),
        row.BAD_ONES: s.lane(row.BAD_ONES) + where(good, 0.0, 1.0),
    }


def _judge(s: Step) -> Made:
    """The new state, the estimate of its error, whether the step is good, and the next one."""
    table = _table()
    beyond = table.E3[: row.DOP853] - table.B  # most of E3 is B
    rate = _sum(s, table.B)
    state = joined(s.lane(row.TAKEN), rate, s.z(row.STATE))
    part = 1.0 / s.tolerance(maximum(abs(s.z(row.STATE)), abs(state)))
    fifth, third = _sum(s, table.E5) * part, _sum(s, beyond, total=rate) * part
    fifth, third = s.total(fifth * fifth), s.total(third * third)
    none = fifth + third <= 0.0
    whole = sqrt(where(none, 1.0, (fifth + 0.01 * third) * float(s.n)))
    error = where(none, 1e-30, s.lane(row.TAKEN) * fifth / whole)
    factor = 0.9 / _eighth(maximum(error, 1e-30))
    return {row.ARGUMENT: state}, _judged(s, error, factor, 10.0)


def _sizes(s: Step) -> Made:
    """The length of a trial step, from the sizes of state and rate (row 2)."""
    part = 1.0 / s.tolerance(abs(s.z(row.STATE)))
    x, f = s.z(row.STATE) * part, s.z(row.RATE + 1) * part
    d0, d1 = sqrt(s.total(x * x) / float(s.n)), sqrt(s.total(f * f) / float(s.n))
    h = where(minimum(d0, d1) < 1e-5, 1e-6, 0.01 * d0 / d1)
    h = minimum(h, s.lane(row.END) - s.lane(row.TIME))
    trouble = s.total(0.0 * s.z(row.STATE) + 0.0 * s.z(row.RATE + 1))
    return {}, {row.TAKEN: h, row.SIZE: d1, row.TROUBLE: trouble}


def _eighth(value: Any) -> Any:
    return sqrt(sqrt(sqrt(value)))


def _fifth(value: Any) -> Any:
    return power(value, 0.2)


def _first(root: Callable, s: Step) -> Made:
    """The first step, from how the rate bends over the trial step (row 3)."""
    part, fresh = 1.0 / s.tolerance(abs(s.z(row.STATE))), s.lane(row.FRESH) > 0.5
    change = (s.z(row.RATE + 2) - s.z(row.RATE + 1)) * part
    h = s.lane(row.TAKEN)
    d1, d2 = s.lane(row.SIZE), sqrt(s.total(change * change) / float(s.n)) / h
    most = maximum(maximum(d1, d2), 1e-30)
    step = where(most <= 1e-15, maximum(1e-6, h * 1e-3), root(0.01 / most))
    step = minimum(minimum(100.0 * h, step), s.lane(row.END) - s.lane(row.TIME))
    step = where(s.lane(row.OPENING) > 0.0, s.lane(row.OPENING), step)
    rate = where(fresh, s.z(row.RATE + 1), s.z(row.RATE))
    return {row.RATE: rate}, {row.STEP: where(fresh, step, s.lane(row.STEP))}


def _accept(s: Step) -> Made:
    """The new state and its rate, taken where the step is good."""
    good = s.lane(row.GOOD) > 0.5
    state = where(good, s.z(row.ARGUMENT), s.z(row.STATE))
    rate = where(good, s.z(row.RATE + row.DOP853), s.z(row.RATE))
    return {row.STATE: state, row.RATE: rate}, {
        row.TIME: where(good, s.lane(row.NEW), s.lane(row.TIME))
    }


def _cubic(s: Step) -> tuple[Any, Any, Any]:
    """The terms of the cubic that has states and rates of both ends."""
    h, delta = s.lane(row.TAKEN), s.z(row.ARGUMENT) - s.z(row.STATE)
    ends = s.z(row.RATE + row.DOP853) + s.z(row.RATE)
    return delta, h * s.z(row.RATE) - delta, 2.0 * delta - h * ends


def _sketch(s: Step) -> Made:
    """The terms of the cubic alone."""
    return _terms(s, *_cubic(s)), {}


def _dense(s: Step) -> Made:
    """The terms of the interpolant of order 7, and how wrong it may be.

    It is as exact as the ends where the step resolves all states.  Where the fastest of them keeps
    the step short by stability alone it is up to 10,000 times less so, and the last term tells.
    """
    terms = [*_cubic(s), *(s.lane(row.TAKEN) * _sum(s, own) for own in _table().D)]
    largest = maximum(abs(s.z(row.STATE)), abs(s.z(row.ARGUMENT)))
    part = (LAST_TERM / TRUSTED) * terms[-1] / s.tolerance(largest)
    return _terms(s, *terms), {row.WITHIN: sqrt(s.total(part * part))}


def _stiffness(last: Any, limit: float, s: Step) -> Made:
    """Whether the step is stiff: rates change `limit` times as fast as the states do.

    Both are at its end, the new state and the argument of the `last` stage (Hairer's test); it
    is forgotten after six steps that are not.
    """
    h = s.lane(row.TAKEN)
    rates = s.z(row.RATE + row.DOP853) - s.z(row.RATE + row.DOP853 - 1)
    states = s.z(row.ARGUMENT) - joined(h, _sum(s, last), s.z(row.STATE))
    before, calm = s.lane(row.STIFF_STEPS), s.lane(row.OTHER_STEPS) + 1.0
    asked = s.lane(row.ASKED) > 0.5  # a run is what it is beside any others
    stiff = h * h * s.total(rates * rates) > limit * limit * s.total(states * states)
    others = where(calm > 5.5, minimum(before, 0.0), before)
    found = where(before < 0.0, before + 1.0, where(stiff, before + 1.0, others))
    return {}, {
        row.STIFF_STEPS: where(asked, found, before),
        row.OTHER_STEPS: where(asked, where(stiff, 0.0, calm), s.lane(row.OTHER_STEPS)),
    }


# --- Dormand and Prince's of order 5 --------------------------------------------------------


def _apart(weights: Any) -> np.ndarray:
    """Return weights of its stages where their rates stand: the last is that of the new state."""
    return np.insert(weights, 1, np.zeros(row.DOP853 + 1 - row.DOPRI5))


def _judged_by_fifth(s: Step, error: Any, new: Any, largest: float, cut: bool = False) -> Rows:
    """Whether a step is good by its error, of order 5, and the next one."""
    part = error / s.tolerance(maximum(abs(s.z(row.STATE)), abs(new)))
    square = s.total(part * part) / float(s.n)
    factor = 0.9 * power(maximum(square, 1e-30), -0.1)  # error^(-1/5)
    # the step before may be short because of a sample, or the end of a piece
    least = minimum(s.lane(row.TAKEN) * factor, s.lane(row.STEP)) if cut else None
    return _judged(s, square, factor, largest, least)


def _judge_dopri5(s: Step) -> Made:
    """Whether the step is good, and the next one; its last stage is at the new state."""
    error = s.lane(row.TAKEN) * _sum(s, _apart(_table_of_dopri5().E))
    return {}, _judged_by_fifth(s, error, s.z(row.ARGUMENT), 10.0)


def _dense_dopri5(s: Step) -> Made:
    """The terms of the interpolant of order 4."""
    last = _sum(s, _apart(_table_of_dopri5().P[:, 3]))
    return _terms(s, *_cubic(s), s.lane(row.TAKEN) * last), {}


# --- Runge and Kutta's method of order 4 ----------------------------------------------------


def _attempt_fixed(s: Step) -> Made:
    """Equal steps, so many as end at a sample, or the end of the piece."""
    ahead = s.lane(row.NEXT) - s.lane(row.TIME)
    rounded = ahead * (1.0 - 1e-12) - 1e-15 * abs(s.lane(row.NEXT))  # times are, too
    turns = maximum(1.0, ceil(rounded / s.lane(row.LONGEST)))
    new = where(turns > 1.0, s.lane(row.TIME) + ahead / turns, s.lane(row.NEXT))
    return {}, {row.NEW: new, row.TAKEN: ahead / turns}


def _judge_fixed(s: Step) -> Made:
    """The new state, and whether it is finite."""
    outer = s.z(row.RATE) + s.z(row.RATE + 3)
    inner = s.z(row.RATE + 1) + s.z(row.RATE + 2)
    state = joined(s.lane(row.TAKEN) / 6.0, joined(2.0, inner, outer), s.z(row.STATE))
    good = s.total(0.0 * state) <= 0.0
    failing = where(good, 0.0, float(row.NOT_FINITE))
    new, tried = s.lane(row.NEW), s.lane(row.GOOD_ONES) + 1.0
    look = where((new >= s.lane(row.NEXT)) | (tried >= s.lane(row.SPARE)), 1.0, failing)
    numbers = {row.GOOD: where(good, 1.0, 0.0), row.LOOK: look, row.AT: new}
    return {row.ARGUMENT: state}, numbers | {row.GOOD_ONES: tried, row.FAILING: failing}


def _accept_fixed(s: Step) -> Made:
    """The new state; a run whose step is not good has ended."""
    return {row.STATE: s.z(row.ARGUMENT)}, {row.TIME: s.lane(row.NEW)}


def _straight(s: Step) -> Made:
    """The terms of a straight line within the step."""
    return {row.TERMS: s.z(row.ARGUMENT) - s.z(row.STATE)}, {}


# --- Rodas5P --------------------------------------------------------------------------------


def _stage_implicit(number: int, s: Step) -> Made:
    """The argument of a stage, counted from 0, and what the right-hand side has beside its rate."""
    known = (rodas.OF_TIME[number] * s.lane(row.TAKEN)) * s.z(row.OVER_TIME)
    ahead = s.z(row.STATE)
    if number:
        known = joined(1.0 / s.lane(row.TAKEN), _sum(s, rodas.C[number], row.SOLVED), known)
        ahead = ahead + _sum(s, rodas.weights(number), row.SOLVED)
    return {row.ARGUMENT: ahead, row.KNOWN: known}, _at(s, rodas.TIMES[number])


def _judge_implicit(s: Step) -> Made:
    """The new state, the estimate of its error, whether the step is good, and the next one."""
    new = s.z(row.STATE) + _sum(s, rodas.weights(len(rodas.C)), row.SOLVED)
    error = s.z(row.SOLVED + len(rodas.C) - 1)
    return {row.ARGUMENT: new}, _judged_by_fifth(s, error, new, 6.0, cut=True)


def _dense_implicit(s: Step) -> Made:
    """The terms of the interpolant."""
    k1, k2, k3 = (_sum(s, own, row.SOLVED) for own in rodas.BETWEEN)
    return _terms(s, s.z(row.ARGUMENT) - s.z(row.STATE), k1, k2 + k3, -k3), {}


# --- each a table ---------------------------------------------------------------------------


def formulas(method: int) -> dict[str, Formula]:
    """Return the formulas of a method, by the solver's number, in its order."""
    attempt: Formula = _attempt
    judge, accept, dense, root = _judge, _accept, _dense, _eighth
    last, limit = _table().A[row.DOP853 - 1, : row.DOP853 - 1], 6.1
    stages = [partial(_stage_of_dop853, k) for k in range(1, row.DOP853 + 4)]
    if method == row.DOPRI5:
        table, judge, dense, root = _table_of_dopri5(), _judge_dopri5, _dense_dopri5, _fifth
        last, limit = _apart(table.A[-1]), 3.25
        stages = [partial(_stage, _apart(table.A[k, :k]), table.C[k]) for k in range(1, 6)]
        stages += [partial(_stage, _apart(table.B), 1.0)]
    elif method == row.RODAS5P:
        attempt, judge, dense = partial(_attempt, implicit=True), _judge_implicit, _dense_implicit
        stages = [partial(_stage_implicit, k) for k in range(row.RODAS5P - 1)]
    elif method == row.RK4:
        attempt, judge, accept, dense = _attempt_fixed, _judge_fixed, _accept_fixed, _straight
        halves = np.diag([0.5, 0.5, 1.0])
        stages = [partial(_stage, halves[k, : k + 1], halves[k, k]) for k in range(3)]
    trial, first = partial(_stage, [0.0, 1.0], 1.0), partial(_first, root)
    return {
        **{"attempt": attempt, "judge": judge, "sizes": _sizes, "trial": trial, "first": first},
        **{"accept": accept, "dense": dense, "sketch": _sketch},
        "stiffness": partial(_stiffness, last, limit),
        **{f"stage_{k}": one for k, one in enumerate(stages, 1)},
    }


def program_of_formulas(formulas: dict[str, Formula], n: int) -> Program:
    """Return the program of formulas for n states."""
    step = Step(n)
    made = Components(SimpleNamespace(entries=step.tape.operations), 0)
    writes = {}
    for name, formula in formulas.items():
        rows, numbers = formula(step)
        states = [Port(r * n, (n,), (True,), operand(value)) for r, value in rows.items()]
        others = [Port(r, (), (), operand(value)) for r, value in numbers.items()]
        writes[name] = made.writes(states, "X") + made.writes(others, "t")
    plan = Planner(made)
    # loops come first: numbers of the lane are read in them, and written behind them
    functions = {
        name: tuple(sorted(plan.nests(own), key=lambda nest: not nest.lengths))
        for name, own in writes.items()
    }
    return Program(tuple(made.all), functions, {}, (), 0, 0, 0, ())


@once(16)
def kernels(n: int, lanes: int, method: int) -> Machine:
    """Return the formulas of a method for n states as machine code."""
    own = formulas(method)

    def printed() -> object:
        from .nests import print_program

        return print_program(program_of_formulas(own, n), tuple(own), lanes)

    return Machine(own, f"formulas {n} {lanes} {method}", printed)
