"""A formula of the method: an ordinary function of numbers, read as a diagram's are.

It is a program as a diagram's is, of eight states or eight runs at once: numbers of a lane are t,
the rows of Z are X.
"""

from collections.abc import Callable, Mapping
from functools import partial
from types import SimpleNamespace
from typing import Any

from ..equations.arrays import Tape, elementwise, operand
from .components import Components
from .decisions import Port
from .plan import Planner, Program

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


Formula = Callable[[Step], tuple[Rows, Rows]]  # what becomes of rows of Z, and of numbers


class AsWritten(Components):
    """What a formula computes, in which nothing stands for a whole run."""

    def is_steady(self, value: Any) -> bool:
        """Whether a value is prepared once: none is."""
        return False


def program_of_formulas(formulas: Mapping[str, Formula], n: int) -> Program:
    """Return the program of formulas for n states."""
    step = Step(n)
    made = AsWritten(SimpleNamespace(entries=step.tape.operations), 0, 0)
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
