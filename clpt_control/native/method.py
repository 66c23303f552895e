"""Dormand and Prince's method of order 8, and Runge and Kutta's of order 4, as formulas.

The formulas compute each stage, judge a step and choose the next; `solver` decides nothing
but what comes after what.  It names the rows of Z and of what a lane is doing.

Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, 1993, sections
II.4, II.5 and II.10; the coefficients and the choice of steps are scipy's.
"""

from collections.abc import Sequence
from typing import Any

import numpy as np

from .formula import Formula, Row, Rows, joined, maximum, minimum, sqrt, where
from .solver import (  # rows of Z
    ARGUMENT,
    ASKED,
    AT,
    BAD_ONES,
    END,
    FAILING,
    FRESH,
    GOOD,
    GOOD_ONES,
    LONGEST,
    LOOK,
    NEW,
    NEXT,
    OPENING,
    OTHER_STEPS,
    RATE,
    REJECTED,
    SIZE,
    SPARE,
    STAGES,
    STATE,
    STEP,
    STIFF_STEPS,
    TAKEN,
    TERMS,
    TIME,
    TROUBLE,
    WANTED,
    WITHIN,
)

LAST_TERM = 1.23e-3  # of the interpolant: what is wrong within a step that stability keeps short
TRUSTED = 100.0  # tolerances that a state between a step's ends may be wrong by
BEGUN = range(9, 12)  # stages whose sums are begun before, in the rows of terms


def _table() -> Any:
    from scipy.integrate._ivp import dop853_coefficients

    return dop853_coefficients


def _weighted(weights: Any, z: Row, begun: Any = None) -> Any:
    """What is `begun`, + a_0 K_0 + a_1 K_1 + ..., zeros left out."""
    used = weights.nonzero()[0]
    first = z(RATE + int(used[0]))
    if not hasattr(first, "kind"):
        total = np.add.reduce(weights[used, None] * z(RATE + used))  # in the order of the rows
        return total if begun is None else begun + total
    for j in used.tolist():
        a, rate = float(weights[j]), z(RATE + j)
        begun = a * rate if begun is None else joined(a, rate, begun)
    return begun


def _stage(s: int) -> Formula:
    """argument = x + h sum_j a_sj K_j, at t + c_s h; stage 12 is the new state.

    Stage 8 begins the sums of those behind it, as its own reads what they read.
    """
    table = _table()
    weights = table.B if s == STAGES else table.A[s, :s]
    c = 1.0 if s == STAGES else float(table.C[s])
    begun = {r: TERMS + r - BEGUN[0] for r in BEGUN}

    def ahead(z: Row, lane: Row, tolerance: Row) -> tuple[Rows, Sequence[Any]]:
        rows: Rows = {}
        if s == BEGUN[0] - 1:
            rows = {place: _weighted(table.A[r, :s], z) for r, place in begun.items()}
        if s in BEGUN:
            late = np.where(np.arange(s) < BEGUN[0] - 1, 0.0, weights)
            total = _weighted(late, z, z(begun[s]))
        else:
            total = _weighted(weights, z)
        return {ARGUMENT: joined(lane(TAKEN), total, z(STATE)), **rows}, ()

    return Formula(ahead, lambda lane, sums: {AT: lane(TIME) + c * lane(TAKEN)})


def attempt() -> Formula:
    """The step to try, not below what time can tell: up to the end of the piece, or a sample."""

    def after(lane: Row, sums: Sequence[Any]) -> Rows:
        t, h = lane(TIME), minimum(lane(STEP), lane(LONGEST))
        smallest = 2.3e-15 * abs(t) + 1e-300
        enough = h >= smallest
        new = minimum(t + where(enough, h, smallest), minimum(lane(END), lane(WANTED)))
        failing = where(enough, 0.0, where(h < smallest, lane(REJECTED), 1.0))
        return {NEW: new, TAKEN: new - t, FAILING: failing}

    return Formula(None, after)


def _judge(n: int) -> Formula:
    """The new state, the estimate of its error, whether the step is good, and the next one."""
    table = _table()
    beyond = table.E3[:STAGES] - table.B  # most of E3 is B

    def each(z: Row, lane: Row, tolerance: Row) -> tuple[Rows, Sequence[Any]]:
        rate = _weighted(table.B, z)
        state = joined(lane(TAKEN), rate, z(STATE))
        largest = maximum(abs(z(STATE)), abs(state))
        part = 1.0 / joined(tolerance(0), largest, tolerance(1))
        fifth, third = _weighted(table.E5, z) * part, _weighted(beyond, z, rate) * part
        return {ARGUMENT: state}, (fifth * fifth, third * third)

    def after(lane: Row, sums: Sequence[Any]) -> Rows:
        fifth, third = sums
        none = fifth + third <= 0.0
        whole = sqrt(where(none, 1.0, (fifth + 0.01 * third) * float(n)))
        error = where(none, 1e-30, lane(TAKEN) * fifth / whole)
        factor = 0.9 / sqrt(sqrt(sqrt(maximum(error, 1e-30))))  # error^(-1/8)
        most = where(lane(REJECTED) > 0.5, 1.0, 10.0)
        good = error < 1.0
        tried = lane(GOOD_ONES) + lane(BAD_ONES) + 1.0
        look = where(lane(NEW) >= lane(NEXT), 1.0, lane(FAILING))
        bad = where(error >= 1.0, maximum(0.2, factor), 0.2)  # not a number: 0.2
        return {
            STEP: lane(TAKEN) * where(good, minimum(most, factor), bad),
            GOOD: where(good, 1.0, 0.0),
            REJECTED: where(good, 0.0, 1.0),
            AT: lane(TIME) + lane(TAKEN),
            LOOK: where(tried >= lane(SPARE), 1.0, look),
            GOOD_ONES: lane(GOOD_ONES) + where(good, 1.0, 0.0),
            BAD_ONES: lane(BAD_ONES) + where(good, 0.0, 1.0),
        }

    return Formula(each, after, 2)


def sizes(n: int) -> Formula:
    """The length of a trial step, from the sizes of state and rate (row 2)."""

    def each(z: Row, lane: Row, tolerance: Row) -> tuple[Rows, Sequence[Any]]:
        part = 1.0 / joined(tolerance(0), abs(z(STATE)), tolerance(1))
        x, f = z(STATE) * part, z(RATE + 1) * part
        return {}, (x * x, f * f, 0.0 * z(STATE) + 0.0 * z(RATE + 1))

    def after(lane: Row, sums: Sequence[Any]) -> Rows:
        d0, d1 = sqrt(sums[0] / float(n)), sqrt(sums[1] / float(n))
        h = where(minimum(d0, d1) < 1e-5, 1e-6, 0.01 * d0 / d1)
        h = minimum(h, lane(END) - lane(TIME))
        return {TAKEN: h, AT: lane(TIME) + h, SIZE: d1, TROUBLE: sums[2]}

    return Formula(each, after, 3)


def trial() -> Formula:
    """argument = x + h f, f in row 2."""

    def each(z: Row, lane: Row, tolerance: Row) -> tuple[Rows, Sequence[Any]]:
        return {ARGUMENT: joined(lane(TAKEN), z(RATE + 1), z(STATE))}, ()

    return Formula(each)


def first(n: int) -> Formula:
    """The first step, from how the rate bends over the trial step (row 3)."""

    def each(z: Row, lane: Row, tolerance: Row) -> tuple[Rows, Sequence[Any]]:
        part = 1.0 / joined(tolerance(0), abs(z(STATE)), tolerance(1))
        change = (z(RATE + 2) - z(RATE + 1)) * part
        rate = where(lane(FRESH) > 0.5, z(RATE + 1), z(RATE))
        return {RATE: rate}, (change * change,)

    def after(lane: Row, sums: Sequence[Any]) -> Rows:
        h = lane(TAKEN)
        d1, d2 = lane(SIZE), sqrt(sums[0] / float(n)) / h
        most = maximum(maximum(d1, d2), 1e-30)
        step = where(most <= 1e-15, maximum(1e-6, h * 1e-3), sqrt(sqrt(sqrt(0.01 / most))))
        step = minimum(minimum(100.0 * h, step), lane(END) - lane(TIME))
        step = where(lane(OPENING) > 0.0, lane(OPENING), step)
        return {STEP: where(lane(FRESH) > 0.5, step, lane(STEP))}

    return Formula(each, after, 1)


def accept() -> Formula:
    """The new state and its rate, taken where the step is good."""

    def each(z: Row, lane: Row, tolerance: Row) -> tuple[Rows, Sequence[Any]]:
        good = lane(GOOD) > 0.5
        state, rate = where(good, z(ARGUMENT), z(STATE)), where(good, z(RATE + STAGES), z(RATE))
        return {STATE: state, RATE: rate}, ()

    def after(lane: Row, sums: Sequence[Any]) -> Rows:
        return {TIME: where(lane(GOOD) > 0.5, lane(NEW), lane(TIME))}

    return Formula(each, after)


def _dense() -> Formula:
    """The terms of the interpolant of order 7, and how wrong it may be.

    It is as exact as the ends where the step resolves all states.  Where the fastest of them keeps
    the step short by stability alone it is up to 10,000 times less so, and the last term tells.
    """
    table = _table()

    def each(z: Row, lane: Row, tolerance: Row) -> tuple[Rows, Sequence[Any]]:
        h, delta = lane(TAKEN), z(ARGUMENT) - z(STATE)
        ends = z(RATE + STAGES) + z(RATE)
        terms = [delta, h * z(RATE) - delta, 2.0 * delta - h * ends]
        terms += [h * _weighted(weights, z) for weights in table.D]
        largest = maximum(abs(z(STATE)), abs(z(ARGUMENT)))
        part = (LAST_TERM / TRUSTED) * terms[-1] / joined(tolerance(0), largest, tolerance(1))
        return {TERMS + k: term for k, term in enumerate(terms)}, (part * part,)

    return Formula(each, lambda lane, sums: {WITHIN: sqrt(sums[0])}, 1)


def _stiffness() -> Formula:
    """Whether the step is stiff: rates change more than 6.1 times as fast as the states do.

    Both are at its end, the new state and the argument of the last stage (Hairer's test); it
    is forgotten after six steps that are not.
    """
    last = _table().A[STAGES - 1, : STAGES - 1]

    def each(z: Row, lane: Row, tolerance: Row) -> tuple[Rows, Sequence[Any]]:
        rates = z(RATE + STAGES) - z(RATE + STAGES - 1)
        states = z(ARGUMENT) - joined(lane(TAKEN), _weighted(last, z), z(STATE))
        return {}, (rates * rates, states * states)

    def after(lane: Row, sums: Sequence[Any]) -> Rows:
        h, before, calm = lane(TAKEN), lane(STIFF_STEPS), lane(OTHER_STEPS) + 1.0
        asked = lane(ASKED) > 0.5  # a run is what it is beside any others
        stiff = h * h * sums[0] > 6.1 * 6.1 * sums[1]
        others = where(calm > 5.5, minimum(before, 0.0), before)
        found = where(before < 0.0, before + 1.0, where(stiff, before + 1.0, others))
        return {
            STIFF_STEPS: where(asked, found, before),
            OTHER_STEPS: where(asked, where(stiff, 0.0, calm), lane(OTHER_STEPS)),
        }

    return Formula(each, after, 2)


def _fixed(s: int) -> Formula:
    """Runge and Kutta's classical method of order 4: stages 1 to 3, then the new state."""
    if s == 4:

        def last(z: Row, lane: Row, tolerance: Row) -> tuple[Rows, Sequence[Any]]:
            outer, inner = z(RATE) + z(RATE + 3), z(RATE + 1) + z(RATE + 2)
            rate = joined(2.0, inner, outer)
            return {STATE: joined(lane(TAKEN) / 6.0, rate, z(STATE))}, ()

        return Formula(last, lambda lane, sums: {AT: lane(TIME) + lane(TAKEN)})
    part = 1.0 if s == 3 else 0.5

    def ahead(z: Row, lane: Row, tolerance: Row) -> tuple[Rows, Sequence[Any]]:
        return {ARGUMENT: joined(part * lane(TAKEN), z(RATE + s - 1), z(STATE))}, ()

    return Formula(ahead, lambda lane, sums: {AT: lane(TIME) + part * lane(TAKEN)})


def formulas(n: int) -> dict[str, Formula]:
    """Return the formulas for n states, in the solver's order."""
    return {
        "attempt": attempt(),
        "judge": _judge(n),
        "sizes": sizes(n),
        "trial": trial(),
        "first": first(n),
        "accept": accept(),
        "dense": _dense(),
        **{f"stage_{s}": _stage(s) for s in range(1, STAGES + 4)},
        **{f"fixed_{s}": _fixed(s) for s in range(1, 5)},
        "stiffness": _stiffness(),
    }
