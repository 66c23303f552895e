"""A block's equations as SymPy's expressions, to be called with numbers."""

from collections.abc import Callable
from math import copysign, isfinite
from typing import Any

import numpy as np
import sympy

from ..equations import record as numbers
from ..equations.block import Block
from ..equations.elements import Elements, Index
from ..equations.record import Ref, Shape
from ..equations.symbolic import NUMBERS, Symbols
from ..errors import BlockError

LONG = 20  # operations; a longer expression is a symbol of its own
# what loses its digits, or its range, written out: log1p(a) as log(1 + a)
KEPT = {name: sympy.Function(f"{name}_", real=True) for name in ("hypot", "log1p", "expm1")}
NAMES: dict[str, Callable[..., Any]] = {
    **NUMBERS,
    **{f"{name}_": numbers.OPERATIONS[name] for name in KEPT},
    **{name: numbers.OPERATIONS[name] for name in ("sin", "cos", "tan")},  # NaN beyond MOST_ANGLE
    "picked": numbers.picked,
}


class SymbolicFunction(Symbols):
    """A block's equations as SymPy's expressions; what is long is a symbol of its own."""

    def __init__(self, block: Block, role: str):
        record = block.array_record(role)
        super().__init__(record.operations, self._leaf, sizes=block.sizes)
        self.leaves: dict[tuple, sympy.Symbol] = {}
        self.steps: list[tuple[sympy.Symbol, sympy.Expr]] = []
        values = self.outputs(record)
        for value in (*values, *(value for _, value in self.steps)):
            if value.has(sympy.zoo, sympy.nan, sympy.I):
                raise BlockError(f"SymPy finds that the equations divide by zero: {value}")
        self._compiled = sympy.lambdify(
            list(self.leaves.values()),
            values,
            [NAMES, "scipy", "numpy"],
            cse=lambda expressions: (self.steps, expressions),
        )

    def _symbol(self, *key: Any) -> sympy.Symbol:
        return self.leaves.setdefault(key, sympy.Symbol(f"leaf{len(self.leaves)}", real=True))

    def _leaf(self, at: tuple[str, str], shape: Shape, index: Index) -> Any:
        return self._symbol(*at, index)

    def number(self, value: float) -> Any:
        """Return a number; what SymPy would make more of is a symbol, as 0 * x."""
        known = value and isfinite(value)
        return sympy.Float(value) if known else self._symbol("", value, copysign(1.0, value))

    def opaque(self, at: tuple, arguments: tuple, index: Index) -> Any:
        """Return what a helper computes."""
        return Elements.opaque(self, at, arguments, index)

    def picked(self, ref: int, table: Ref, place: Any) -> Any:
        """Return what stands in a row, which is one symbol where it is a parameter."""
        kind, arguments, shape, at = self.operations[table]
        view = None
        if kind == "view":
            view = at, self.sized(shape)
            kind, arguments, shape, at = self.operations[arguments[0]]
        if kind != "leaf" or at[0] != "p":
            return super().picked(ref, table, place)
        row = self._symbol("row", at[1], view)
        return self._step(sympy.Function("picked", real=True)(row, place))

    def apply(self, ref: int, kind: str, arguments: tuple) -> Any:
        """Return what SymPy makes of an operation, as a symbol where it is long."""
        if kind in KEPT:
            return self._step(KEPT[kind](*arguments))
        if kind == "pow" and arguments[1] in (2.0, 3.0, 4.0):
            arguments = arguments[0], sympy.Integer(arguments[1])
        return self._step(super().apply(ref, kind, arguments))

    def _step(self, value: Any) -> Any:
        if not isinstance(value, sympy.Expr) or value.count_ops() < LONG:
            return value
        symbol = sympy.Symbol(f"step{len(self.steps)}", real=True)
        self.steps.append((symbol, value))
        return symbol

    def __call__(self, given: Callable[[str, str], np.ndarray]) -> np.ndarray:
        """Return the value of each output; ``given("x", "alpha")`` is an array."""
        values = []
        for group, name, *more in self.leaves:
            if group == "":
                values.append(name)
            elif group == "row":
                row = given("p", name)
                values.append(row if more[0] is None else numbers.viewed(row, *more[0]))
            else:
                values.append(np.asarray(given(group, name))[more[0]])
        with np.errstate(all="ignore"):
            return np.array(
                self._compiled(*(np.asarray(v, dtype=float)[()] for v in values)), dtype=float
            )
