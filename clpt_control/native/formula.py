"""A formula of the method: an ordinary function of numbers, read in two ways.

For machine code it is a program as a diagram's is, of eight states or eight runs at once: numbers
of a lane are t, the rows of Z are X; in Python it is run on NumPy's rows (`on_rows`).
"""

from collections.abc import Callable, Mapping, Sequence
from types import SimpleNamespace
from typing import Any, NamedTuple

import numpy as np

from ..equations.arrays import Array, Tape, elementwise, operand
from .components import Components, Value
from .decisions import Port
from .plan import Planner, Program

Row = Callable[[int], Any]
Rows = dict[int, Any]


class Formula(NamedTuple):
    """What is computed for each state, and then for each lane.

    ``each(z, lane, tolerance)`` returns rows of Z, and numbers to sum over the states;
    ``after(lane, sums)`` returns rows of numbers.
    """

    each: Callable[[Row, Row, Row], tuple[Rows, Sequence[Any]]] = lambda z, lane, tolerance: (
        {},
        (),
    )
    after: Callable[[Row, Sequence[Any]], Rows] = lambda lane, sums: {}


def joined(a: Any, b: Any, c: Any) -> Any:
    """Return a b + c, in machine code rounded once where the processor can."""
    if any(isinstance(one, Array) for one in (a, b, c)):
        return elementwise("fmuladd", a, b, c)
    return a * b + c


class AsWritten(Components):
    """What a formula computes, in which nothing stands for a whole run."""

    def is_steady(self, value: Value) -> bool:
        """Whether a value is prepared once: none is."""
        return False


def program_of_formulas(formulas: Mapping[str, Formula], n: int) -> Program:
    """Return the program of formulas for n states."""
    tape, ports = Tape(), {}

    def row(r: int) -> Array:
        return tape.add("load", (), (n,), ("X", r * n))

    def number(r: int, array: str = "t") -> Array:
        return tape.add("load", (), (), (array, r))

    for name, (each, after) in formulas.items():
        rows, summed = each(row, number, lambda r: number(r, "T"))
        sums = [tape.add("sum", (operand(one),), (), (0, n, True)) for one in summed]
        numbers = after(number, sums)
        ports[name] = (
            [Port(r * n, (n,), (True,), operand(value)) for r, value in rows.items()],
            [Port(r, (), (), operand(value)) for r, value in numbers.items()],
        )
    made = AsWritten(SimpleNamespace(entries=tape.operations), 0, 0)
    writes = {name: made.writes(x, "X") + made.writes(t, "t") for name, (x, t) in ports.items()}
    plan = Planner(made)
    # loops come first: numbers of the lane are read in them, and written behind them
    functions = {
        name: tuple(sorted(plan.nests(own), key=lambda nest: not nest.lengths))
        for name, own in writes.items()
    }
    return Program(tuple(made.all), functions, {}, (), 0, 0, 0, ())


def on_rows(formula: Formula, n: int) -> Callable:
    """Return what applies a formula in NumPy, called like a kernel."""

    def apply(
        numbers: Any, Z: np.ndarray, at: int, P: Any, T: Any, W: Any, D: Any, to: int
    ) -> None:
        own, rows_of_Z = numbers.reshape(-1), Z.reshape(-1, n)
        with np.errstate(all="ignore"):
            rows, summed = formula.each(rows_of_Z.__getitem__, own.__getitem__, T.__getitem__)
            for r, value in rows.items():
                rows_of_Z[r] = value
            found = formula.after(own.__getitem__, [np.sum(s) for s in summed])
            for r, value in found.items():
                own[r] = value

    return apply
