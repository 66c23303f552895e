"""The methods as formulas: Dormand and Prince's of order 8, Rodas5P, Runge and Kutta's of order 4.

The formulas compute each stage, judge a step and choose the next; `solver` decides nothing
but what comes after what.  It names the rows of Z and of what a lane is doing.

DOP853: Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, 1993, sections
II.4, II.5 and II.10; the coefficients and the choice of steps are scipy's.  Rodas5P, for stiff
equations: `rosenbrock`.  RK4 takes steps of one length.
"""

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy import ceil, maximum, minimum, power, sqrt, where

from . import rosenbrock as rodas
from . import solver as row
from .formula import Formula, Row, Rows, joined

LAST_TERM = 1.23e-3  # of the interpolant: what is wrong within a step that stability keeps short
TRUSTED = 100.0  # tolerances that a state between a step's ends may be wrong by
BEGUN = range(9, 12)  # stages whose sums stage 8 begins, as its own reads what they read


def _table() -> Any:
    from scipy.integrate._ivp import dop853_coefficients

    return dop853_coefficients


def _sum(weights: Any, z: Row, first: int = row.RATE, total: Any = None) -> Any:
    """What is begun, + a_0 K_0 + a_1 K_1 + ..., from a row on, zeros left out."""
    for j, a in enumerate(np.asarray(weights).tolist(), first):
        if a != 0.0:
            total = a * z(j) if total is None else joined(a, z(j), total)
    return total


def _stage(weights: Any, c: float, begun: int | None = None, begins: Any = ()) -> Formula:
    """argument = x + h sum_j a_j K_j, at t + c h; some sums are `begun` in the rows of terms."""

    def ahead(z: Row, lane: Row, tolerance: Row) -> tuple[Rows, Sequence[Any]]:
        total = _sum(weights, z, total=None if begun is None else z(begun))
        sums = {row.TERMS + k: _sum(other, z) for k, other in enumerate(begins)}
        return {row.ARGUMENT: joined(lane(row.TAKEN), total, z(row.STATE)), **sums}, ()

    return Formula(ahead, _at(c))


def _stage_of_dop853(s: int) -> Formula:
    """Stage 1 to 15, counted from 0; stage 12 is the new state."""
    table, last = _table(), BEGUN[0] - 1
    weights, c = table.A[s, :s], float(table.C[s])
    if s in BEGUN:
        return _stage(np.where(np.arange(s) < last, 0.0, weights), c, row.TERMS + s - BEGUN[0])
    return _stage(weights, c, begins=table.A[BEGUN, :last] if s == last else ())


def _at(c: float) -> Any:
    return lambda lane, sums: {row.AT: lane(row.TIME) + c * lane(row.TAKEN)}


def _attempt(implicit: bool = False) -> Formula:
    """The step to try, not below what time can tell: up to the end of the piece, or a sample.

    An implicit one does not go beyond a sample, and has what stands on its matrix's diagonal.
    """

    def after(lane: Row, sums: Sequence[Any]) -> Rows:
        t, h = lane(row.TIME), minimum(lane(row.STEP), lane(row.LONGEST))
        smallest = 2.3e-15 * abs(t) + 1e-300
        enough = h >= smallest
        end = minimum(lane(row.END), lane(row.WANTED))
        end = minimum(end, lane(row.NEXT)) if implicit else end
        new = minimum(t + where(enough, h, smallest), end)
        failing = where(enough, 0.0, where(h < smallest, lane(row.REJECTED), 1.0))
        failing = float(row.TOO_SMALL) * failing
        rows = {row.NEW: new, row.TAKEN: new - t, row.FAILING: failing}
        return rows | ({row.DIAGONAL: 1.0 / (rodas.GAMMA * (new - t))} if implicit else {})

    return Formula(after=after)


def _judged(lane: Row, error: Any, factor: Any, largest: float, least: Any = None) -> Rows:
    """Whether a step is good, the next one, and whether the lane is looked at."""
    good, most = error < 1.0, where(lane(row.REJECTED) > 0.5, 1.0, largest)
    bad = where(error >= 1.0, maximum(0.2, factor), 0.2)  # not a number: 0.2
    longer = lane(row.TAKEN) * minimum(most, factor)
    longer = longer if least is None else maximum(longer, least)
    tried = lane(row.GOOD_ONES) + lane(row.BAD_ONES) + 1.0
    look = where(lane(row.NEW) >= lane(row.NEXT), 1.0, lane(row.FAILING))
    return {
        row.STEP: where(good, longer, lane(row.TAKEN) * bad),
        row.GOOD: where(good, 1.0, 0.0),
        row.REJECTED: where(good, 0.0, 1.0),
        row.AT: lane(row.TIME) + lane(row.TAKEN),
        row.LOOK: where(tried >= lane(row.SPARE), 1.0, look),
        row.GOOD_ONES: lane(row.GOOD_ONES) + where(good, 1.0, 0.0),
        row.BAD_ONES: lane(row.BAD_ONES) + where(good, 0.0, 1.0),
    }


def _judge(n: int) -> Formula:
    """The new state, the estimate of its error, whether the step is good, and the next one."""
    table = _table()
    beyond = table.E3[: row.DOP853] - table.B  # most of E3 is B

    def each(z: Row, lane: Row, tolerance: Row) -> tuple[Rows, Sequence[Any]]:
        rate = _sum(table.B, z)
        state = joined(lane(row.TAKEN), rate, z(row.STATE))
        largest = maximum(abs(z(row.STATE)), abs(state))
        part = 1.0 / joined(tolerance(0), largest, tolerance(1))
        fifth, third = _sum(table.E5, z) * part, _sum(beyond, z, total=rate) * part
        return {row.ARGUMENT: state}, (fifth * fifth, third * third)

    def after(lane: Row, sums: Sequence[Any]) -> Rows:
        fifth, third = sums
        none = fifth + third <= 0.0
        whole = sqrt(where(none, 1.0, (fifth + 0.01 * third) * float(n)))
        error = where(none, 1e-30, lane(row.TAKEN) * fifth / whole)
        factor = 0.9 / sqrt(sqrt(sqrt(maximum(error, 1e-30))))  # error^(-1/8)
        return _judged(lane, error, factor, 10.0)

    return Formula(each, after)


def _sizes(n: int) -> Formula:
    """The length of a trial step, from the sizes of state and rate (row 2)."""

    def each(z: Row, lane: Row, tolerance: Row) -> tuple[Rows, Sequence[Any]]:
        part = 1.0 / joined(tolerance(0), abs(z(row.STATE)), tolerance(1))
        x, f = z(row.STATE) * part, z(row.RATE + 1) * part
        return {}, (x * x, f * f, 0.0 * z(row.STATE) + 0.0 * z(row.RATE + 1))

    def after(lane: Row, sums: Sequence[Any]) -> Rows:
        d0, d1 = sqrt(sums[0] / float(n)), sqrt(sums[1] / float(n))
        h = where(minimum(d0, d1) < 1e-5, 1e-6, 0.01 * d0 / d1)
        h = minimum(h, lane(row.END) - lane(row.TIME))
        return {row.TAKEN: h, row.SIZE: d1, row.TROUBLE: sums[2]}

    return Formula(each, after)


def _first(n: int) -> Formula:
    """The first step, from how the rate bends over the trial step (row 3)."""

    def each(z: Row, lane: Row, tolerance: Row) -> tuple[Rows, Sequence[Any]]:
        part = 1.0 / joined(tolerance(0), abs(z(row.STATE)), tolerance(1))
        change = (z(row.RATE + 2) - z(row.RATE + 1)) * part
        rate = where(lane(row.FRESH) > 0.5, z(row.RATE + 1), z(row.RATE))
        return {row.RATE: rate}, (change * change,)

    def after(lane: Row, sums: Sequence[Any]) -> Rows:
        h = lane(row.TAKEN)
        d1, d2 = lane(row.SIZE), sqrt(sums[0] / float(n)) / h
        most = maximum(maximum(d1, d2), 1e-30)
        step = where(most <= 1e-15, maximum(1e-6, h * 1e-3), sqrt(sqrt(sqrt(0.01 / most))))
        step = minimum(minimum(100.0 * h, step), lane(row.END) - lane(row.TIME))
        step = where(lane(row.OPENING) > 0.0, lane(row.OPENING), step)
        return {row.STEP: where(lane(row.FRESH) > 0.5, step, lane(row.STEP))}

    return Formula(each, after)


def _accept() -> Formula:
    """The new state and its rate, taken where the step is good."""

    def each(z: Row, lane: Row, tolerance: Row) -> tuple[Rows, Sequence[Any]]:
        good = lane(row.GOOD) > 0.5
        state = where(good, z(row.ARGUMENT), z(row.STATE))
        return {row.STATE: state, row.RATE: where(good, z(row.RATE + row.DOP853), z(row.RATE))}, ()

    def after(lane: Row, sums: Sequence[Any]) -> Rows:
        return {row.TIME: where(lane(row.GOOD) > 0.5, lane(row.NEW), lane(row.TIME))}

    return Formula(each, after)


def _sketch() -> Formula:
    """The terms of the cubic that has states and rates of both ends."""

    def each(z: Row, lane: Row, tolerance: Row) -> tuple[Rows, Sequence[Any]]:
        h, delta = lane(row.TAKEN), z(row.ARGUMENT) - z(row.STATE)
        ends = z(row.RATE + row.DOP853) + z(row.RATE)
        terms = [delta, h * z(row.RATE) - delta, 2.0 * delta - h * ends]
        none = 0.0 * z(row.STATE)
        return {row.TERMS + k: (terms[k] if k < len(terms) else none) for k in range(7)}, ()

    return Formula(each)


def _dense() -> Formula:
    """The terms of the interpolant of order 7, and how wrong it may be.

    It is as exact as the ends where the step resolves all states.  Where the fastest of them keeps
    the step short by stability alone it is up to 10,000 times less so, and the last term tells.
    """
    table = _table()

    def each(z: Row, lane: Row, tolerance: Row) -> tuple[Rows, Sequence[Any]]:
        h, delta = lane(row.TAKEN), z(row.ARGUMENT) - z(row.STATE)
        ends = z(row.RATE + row.DOP853) + z(row.RATE)
        terms = [delta, h * z(row.RATE) - delta, 2.0 * delta - h * ends]
        terms += [h * _sum(weights, z) for weights in table.D]
        largest = maximum(abs(z(row.STATE)), abs(z(row.ARGUMENT)))
        part = (LAST_TERM / TRUSTED) * terms[-1] / joined(tolerance(0), largest, tolerance(1))
        return {row.TERMS + k: term for k, term in enumerate(terms)}, (part * part,)

    return Formula(each, lambda lane, sums: {row.WITHIN: sqrt(sums[0])})


def _stiffness() -> Formula:
    """Whether the step is stiff: rates change more than 6.1 times as fast as the states do.

    Both are at its end, the new state and the argument of the last stage (Hairer's test); it
    is forgotten after six steps that are not.
    """
    last = _table().A[row.DOP853 - 1, : row.DOP853 - 1]

    def each(z: Row, lane: Row, tolerance: Row) -> tuple[Rows, Sequence[Any]]:
        rates = z(row.RATE + row.DOP853) - z(row.RATE + row.DOP853 - 1)
        states = z(row.ARGUMENT) - joined(lane(row.TAKEN), _sum(last, z), z(row.STATE))
        return {}, (rates * rates, states * states)

    def after(lane: Row, sums: Sequence[Any]) -> Rows:
        h, before, calm = lane(row.TAKEN), lane(row.STIFF_STEPS), lane(row.OTHER_STEPS) + 1.0
        asked = lane(row.ASKED) > 0.5  # a run is what it is beside any others
        stiff = h * h * sums[0] > 6.1 * 6.1 * sums[1]
        others = where(calm > 5.5, minimum(before, 0.0), before)
        found = where(before < 0.0, before + 1.0, where(stiff, before + 1.0, others))
        return {
            row.STIFF_STEPS: where(asked, found, before),
            row.OTHER_STEPS: where(asked, where(stiff, 0.0, calm), lane(row.OTHER_STEPS)),
        }

    return Formula(each, after)


# --- Runge and Kutta's method of order 4 ----------------------------------------------------


def _attempt_fixed() -> Formula:
    """Equal steps, so many as end at a sample, or the end of the piece."""

    def after(lane: Row, sums: Sequence[Any]) -> Rows:
        ahead = lane(row.NEXT) - lane(row.TIME)
        rounded = ahead * (1.0 - 1e-12) - 1e-15 * abs(lane(row.NEXT))  # times are, too
        turns = maximum(1.0, ceil(rounded / lane(row.LONGEST)))
        new = where(turns > 1.0, lane(row.TIME) + ahead / turns, lane(row.NEXT))
        return {row.NEW: new, row.TAKEN: ahead / turns}

    return Formula(after=after)


def _judge_fixed() -> Formula:
    """The new state, and whether it is finite."""

    def each(z: Row, lane: Row, tolerance: Row) -> tuple[Rows, Sequence[Any]]:
        outer, inner = z(row.RATE) + z(row.RATE + 3), z(row.RATE + 1) + z(row.RATE + 2)
        new = joined(lane(row.TAKEN) / 6.0, joined(2.0, inner, outer), z(row.STATE))
        return {row.ARGUMENT: new}, (0.0 * new,)

    def after(lane: Row, sums: Sequence[Any]) -> Rows:
        good = sums[0] <= 0.0
        failing = where(good, 0.0, float(row.NOT_FINITE))
        new, tried = lane(row.NEW), lane(row.GOOD_ONES) + 1.0
        look = where((new >= lane(row.NEXT)) | (tried >= lane(row.SPARE)), 1.0, failing)
        rows = {row.GOOD: where(good, 1.0, 0.0), row.LOOK: look, row.AT: new}
        return rows | {row.GOOD_ONES: tried, row.FAILING: failing}

    return Formula(each, after)


def _accept_fixed() -> Formula:
    """The new state; a run whose step is not good has ended."""
    return Formula(
        lambda z, lane, tolerance: ({row.STATE: z(row.ARGUMENT)}, ()),
        lambda lane, sums: {row.TIME: lane(row.NEW)},
    )


def _straight() -> Formula:
    """The terms of a straight line within the step."""
    return Formula(lambda z, lane, tolerance: ({row.TERMS: z(row.ARGUMENT) - z(row.STATE)}, ()))


# --- Rodas5P --------------------------------------------------------------------------------


def _stage_implicit(s: int) -> Formula:
    """The argument of a stage, counted from 0, and what the right-hand side has beside its rate."""

    def each(z: Row, lane: Row, tolerance: Row) -> tuple[Rows, Sequence[Any]]:
        known = (rodas.OF_TIME[s] * lane(row.TAKEN)) * z(row.OVER_TIME)
        if not s:
            return {row.ARGUMENT: z(row.STATE), row.KNOWN: known}, ()
        known = joined(1.0 / lane(row.TAKEN), _sum(rodas.C[s], z, row.SOLVED), known)
        ahead = z(row.STATE) + _sum(rodas.weights(s), z, row.SOLVED)
        return {row.ARGUMENT: ahead, row.KNOWN: known}, ()

    return Formula(each, _at(rodas.TIMES[s]))


def _judge_implicit(n: int) -> Formula:
    """The new state, the estimate of its error, whether the step is good, and the next one."""

    def each(z: Row, lane: Row, tolerance: Row) -> tuple[Rows, Sequence[Any]]:
        new = z(row.STATE) + _sum(rodas.weights(len(rodas.C)), z, row.SOLVED)
        largest = maximum(abs(z(row.STATE)), abs(new))
        part = z(row.SOLVED + len(rodas.C) - 1) / joined(tolerance(0), largest, tolerance(1))
        return {row.ARGUMENT: new}, (part * part,)

    def after(lane: Row, sums: Sequence[Any]) -> Rows:
        square = sums[0] / float(n)
        factor = 0.9 * power(maximum(square, 1e-30), -0.1)  # error^(-1/5)
        # the step before may be short because of a sample, or the end of a piece
        cut = minimum(lane(row.TAKEN) * factor, lane(row.STEP))
        return _judged(lane, square, factor, 6.0, cut)

    return Formula(each, after)


def _dense_implicit() -> Formula:
    """The terms of the interpolant, in the form in which `solver.between` sums them."""

    def each(z: Row, lane: Row, tolerance: Row) -> tuple[Rows, Sequence[Any]]:
        k1, k2, k3 = (_sum(own, z, row.SOLVED) for own in rodas.BETWEEN)
        terms = [z(row.ARGUMENT) - z(row.STATE), k1, k2 + k3, -k3]
        none = 0.0 * z(row.STATE)
        return {row.TERMS + k: (terms[k] if k < len(terms) else none) for k in range(7)}, ()

    return Formula(each)


# --- each a table ---------------------------------------------------------------------------


def formulas(method: int, n: int) -> dict[str, Formula]:
    """Return the formulas of a method, by the solver's number, for n states, in its order."""
    accept, begun = _accept(), (_sizes(n), _stage(np.array([0.0, 1.0]), 1.0), _first(n))
    if method == row.RODAS5P:
        attempt, judge, dense = _attempt(True), _judge_implicit(n), _dense_implicit()
        stages = [_stage_implicit(s) for s in range(row.RODAS5P - 1)]
    elif method == row.RK4:
        attempt, judge = _attempt_fixed(), _judge_fixed()
        dense, accept = _straight(), _accept_fixed()
        halves = np.diag([0.5, 0.5, 1.0])
        stages = [_stage(halves[s, : s + 1], halves[s, s]) for s in range(3)]
    else:
        attempt, judge, dense = _attempt(), _judge(n), _dense()
        stages = [_stage_of_dop853(s) for s in range(1, row.DOP853 + 4)]
    names = ("attempt", "judge", "sizes", "trial", "first", "accept", "dense", "sketch")
    named = dict(zip(names, (attempt, judge, *begun, accept, dense, _sketch()), strict=True))
    named |= {f"stage_{s}": one for s, one in enumerate(stages, 1)}
    return named | {"stiffness": _stiffness()} if method == row.DOP853 else named
