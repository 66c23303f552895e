"""A formula of the method: an ordinary function of numbers, read in two ways.

It is run once on tracers, like a block's equations, and becomes machine code for all
states and all lanes (`kernel`); for equations in Python it is run on NumPy's rows
(`on_rows`).
"""

from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

import numpy as np

from ..blocks.tracers import Condition, Number, Tape
from .program import Item, Load, Loop, Step, Store, Sum

Row = Callable[[int], Any]
Rows = dict[int, Any]


class Formula(NamedTuple):
    """What is computed for each state, and then for each lane.

    ``each(z, lane, tolerance)`` returns rows of Z, and what is summed over the states;
    ``after(lane, sums)`` returns rows of numbers.
    """

    each: Callable[[Row, Row, Row], tuple[Rows, Sequence[Any]]] | None = None
    after: Callable[[Row, Sequence[Any]], Rows] | None = None


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
        numbers, rows_of_Z = numbers.reshape(-1), Z.reshape(-1, n)
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
