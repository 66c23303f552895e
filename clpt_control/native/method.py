"""Dormand and Prince's method of order 8, and Runge and Kutta's of order 4, as formulas.

A formula is an ordinary function of numbers.  It is run once on tracers, like a
block's equations, and becomes machine code for all states and all lanes (`kernel`);
for equations in Python it is run on NumPy's rows (`on_rows`).  Which step is taken
next stands here too; `solver` decides nothing but what comes after what.

`solver` names the rows of Z and of numbers, what a lane is doing (t in programs).

Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, 1993, sections
II.4, II.5 and II.10; the coefficients and the choice of steps are scipy's.
"""

from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

import numpy as np

from ..blocks.tracers import Condition, Number, Tape
from .program import Item, Load, Loop, Step, Store, Sum
from .solver import (  # rows of Z
    ARGUMENT,
    AT,
    END,
    FAILING,
    FRESH,
    GOOD,
    NEW,
    RATE,
    REJECTED,
    SIZE,
    STAGES,
    STATE,
    STEP,
    TAKEN,
    TERMS,
    TIME,
    TROUBLE,
)

Row = Callable[[int], Any]
Rows = dict[int, Any]


class Formula(NamedTuple):
    """What is computed for each state, and then for each lane.

    ``each(z, lane, tolerance)`` returns rows of Z, and what is summed over the states;
    ``after(lane, sums)`` returns rows of numbers.
    """

    each: Callable[[Row, Row, Row], tuple[Rows, Sequence[Any]]] | None = None
    after: Callable[[Row, Sequence[Any]], Rows] | None = None


# --- words on tracers and on rows -----------------------------------------------------------


def _word(name: str, on_rows: Callable) -> Callable:
    def word(*arguments: Any) -> Any:
        for a in arguments:
            if isinstance(a, Number | Condition):
                return a.tape.add(name, *(getattr(b, "ref", b) for b in arguments))
        return on_rows(*arguments)

    word.__doc__ = f"Return {name} of tracers, or of rows."
    return word


joined = _word("fmuladd", lambda a, b, c: a * b + c)  # rounded once where the processor can
where = _word("where", np.where)
minimum, maximum = _word("minimum", np.minimum), _word("maximum", np.maximum)
sqrt = _word("sqrt", np.sqrt)


def _table() -> Any:
    from scipy.integrate._ivp import dop853_coefficients

    return dop853_coefficients


def _weighted(weights: Any, z: Row) -> Any:
    """a_0 K_0 + a_1 K_1 + ..., zeros left out."""
    used = weights.nonzero()[0]
    first = z(RATE + int(used[0]))
    if not isinstance(first, Number):
        return np.add.reduce(weights[used, None] * z(RATE + used))  # in the order of the rows
    total = float(weights[used[0]]) * first
    for j in used[1:].tolist():
        total = joined(float(weights[j]), z(RATE + j), total)
    return total


# --- the formulas ---------------------------------------------------------------------------


def _stage(s: int) -> Formula:
    """argument = x + h sum_j a_sj K_j, at t + c_s h; stage 12 is the new state."""
    table = _table()
    weights = table.B if s == STAGES else table.A[s, :s]
    c = 1.0 if s == STAGES else float(table.C[s])

    def ahead(z: Row, lane: Row, tolerance: Row) -> tuple[Rows, Sequence[Any]]:
        return {ARGUMENT: joined(lane(TAKEN), _weighted(weights, z), z(STATE))}, ()

    return Formula(ahead, lambda lane, sums: {AT: lane(TIME) + c * lane(TAKEN)})


def _attempt() -> Formula:
    """The step to try: not beyond the end of the piece, not below what time can tell."""

    def after(lane: Row, sums: Sequence[Any]) -> Rows:
        t, h = lane(TIME), lane(STEP)
        smallest = 2.3e-15 * abs(t) + 1e-300
        enough = h >= smallest
        new = minimum(t + where(enough, h, smallest), lane(END))
        failing = where(enough, 0.0, where(h < smallest, lane(REJECTED), 1.0))
        return {NEW: new, TAKEN: new - t, FAILING: failing}

    return Formula(None, after)


def _judge(n: int) -> Formula:
    """Estimate the error, accept or reject, choose the next step."""
    table = _table()

    def each(z: Row, lane: Row, tolerance: Row) -> tuple[Rows, Sequence[Any]]:
        largest = maximum(abs(z(STATE)), abs(z(ARGUMENT)))
        part = 1.0 / joined(tolerance(0), largest, tolerance(1))
        fifth, third = (_weighted(weights, z) * part for weights in (table.E5, table.E3))
        return {}, (fifth * fifth, third * third)

    def after(lane: Row, sums: Sequence[Any]) -> Rows:
        fifth, third = sums
        none = fifth + third <= 0.0
        whole = sqrt(where(none, 1.0, (fifth + 0.01 * third) * float(n)))
        error = where(none, 1e-30, lane(TAKEN) * fifth / whole)
        factor = 0.9 / sqrt(sqrt(sqrt(maximum(error, 1e-30))))  # error^(-1/8)
        most = where(lane(REJECTED) > 0.5, 1.0, 10.0)
        good = error < 1.0
        bad = where(error >= 1.0, maximum(0.2, factor), 0.2)  # not a number: 0.2
        return {
            STEP: lane(TAKEN) * where(good, minimum(most, factor), bad),
            GOOD: where(good, 1.0, 0.0),
            REJECTED: where(good, 0.0, 1.0),
        }

    return Formula(each, after)


def _sizes(n: int) -> Formula:
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

    return Formula(each, after)


def _trial() -> Formula:
    """argument = x + h f, f in row 2."""

    def each(z: Row, lane: Row, tolerance: Row) -> tuple[Rows, Sequence[Any]]:
        return {ARGUMENT: joined(lane(TAKEN), z(RATE + 1), z(STATE))}, ()

    return Formula(each)


def _first(n: int) -> Formula:
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
        return {STEP: where(lane(FRESH) > 0.5, step, lane(STEP))}

    return Formula(each, after)


def _accept() -> Formula:
    """Take the new state and its rate where the step is good."""

    def each(z: Row, lane: Row, tolerance: Row) -> tuple[Rows, Sequence[Any]]:
        good = lane(GOOD) > 0.5
        state, rate = where(good, z(ARGUMENT), z(STATE)), where(good, z(RATE + STAGES), z(RATE))
        return {STATE: state, RATE: rate}, ()

    def after(lane: Row, sums: Sequence[Any]) -> Rows:
        return {TIME: where(lane(GOOD) > 0.5, lane(NEW), lane(TIME))}

    return Formula(each, after)


def _dense() -> Formula:
    """The terms of the interpolant of order 7."""
    table = _table()

    def each(z: Row, lane: Row, tolerance: Row) -> tuple[Rows, Sequence[Any]]:
        h, delta = lane(TAKEN), z(ARGUMENT) - z(STATE)
        ends = z(RATE + STAGES) + z(RATE)
        terms = [delta, h * z(RATE) - delta, 2.0 * delta - h * ends]
        terms += [h * _weighted(weights, z) for weights in table.D]
        return {TERMS + k: term for k, term in enumerate(terms)}, ()

    return Formula(each)


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
        "attempt": _attempt(),
        "judge": _judge(n),
        "sizes": _sizes(n),
        "trial": _trial(),
        "first": _first(n),
        "accept": _accept(),
        "dense": _dense(),
        **{f"stage_{s}": _stage(s) for s in range(1, STAGES + 4)},
        **{f"fixed_{s}": _fixed(s) for s in range(1, 5)},
    }


# --- a formula as a program, and on rows ----------------------------------------------------


def kernel(formula: Formula, n: int) -> tuple[Item, ...]:
    """Return the program of a formula; numbers are its t, Z its X."""
    tape, sums = Tape(), []
    items: list[Item] = []
    held: dict[Any, Number] = {}

    def load(array: str, base: int, steps: tuple = ()) -> Number:
        if (array, base) not in held:
            held[array, base] = tape.add("load", (array, base, steps))
        return held[array, base]

    def lane(r: int) -> Number:
        return load("t", r)

    def written(first: int) -> list[Item]:
        return [
            Load(k, *arguments[0]) if name == "load" else Step(k, name, tuple(arguments))
            for k, (name, *arguments) in enumerate(tape.operations[first:], first)
        ]

    if formula.each is not None:
        rows, summed = formula.each(
            lambda r: load("X", r * n, ((0, 1),)), lane, lambda k: load("T", k)
        )
        body: list[Item] = written(0)
        body += [Store("X", r * n, ((0, 1),), value.ref) for r, value in rows.items()]
        for number in summed:
            within, turned, result = (tape.add("number").ref for _ in range(3))
            body.append(Step(turned, "add", (within, number.ref)))
            sums.append(Sum(0.0, within, turned, result))
        items.append(Loop(0, n, tuple(body), tuple(sums)))
    if formula.after is not None:
        held.clear()
        first = len(tape.operations)
        found = formula.after(lane, [Number(tape, s.result) for s in sums])
        items += written(first)
        items += [Store("t", r, (), value.ref) for r, value in found.items()]
    return tuple(items)


def on_rows(formula: Formula, n: int) -> Callable:
    """Return what applies a formula in NumPy, called like a kernel."""

    def apply(
        numbers: Any, Z: np.ndarray, at: int, P: Any, T: Any, W: Any, D: Any, to: int
    ) -> None:
        rows_of_Z = Z.reshape(-1, n)
        summed: Sequence[Any] = ()
        with np.errstate(all="ignore"):
            if formula.each is not None:
                rows, summed = formula.each(
                    rows_of_Z.__getitem__, numbers.__getitem__, T.__getitem__
                )
                for r, value in rows.items():
                    rows_of_Z[r] = value
            if formula.after is not None:
                found = formula.after(numbers.__getitem__, [np.sum(s) for s in summed])
                for r, value in found.items():
                    numbers[r] = value

    return apply
