"""Numeric values of expressions at points, by NumPy.

Functions of records, such as clip, have the values that the records have.
"""

from collections.abc import Callable, Mapping
from functools import cache, partial
from math import prod
from typing import Any

import numpy as np
import sympy
from sympy import Expr, oo
from sympy.core.function import AppliedUndef

from ...base.errors import DiagramError
from ...engine.diagram.symbol_names import TIME
from .facts import NUMPY_OF, is_input

NO_VALUE = (sympy.zoo, sympy.nan, oo, -oo, sympy.I)


class NumericValues:
    """Numeric values of expressions at points."""

    def __init__(self, *expressions: Expr):
        self.expressions = expressions
        terms = sympy.Tuple(*expressions)
        calls = terms.atoms(AppliedUndef)
        inputs = set(filter(is_input, calls))
        unknown = {str(call.func) for call in calls - inputs} - NUMPY_OF.keys()
        if unknown or terms.has(sympy.Derivative):
            names = ", ".join(sorted(unknown)) or "a derivative of an input"
            raise DiagramError(f"{names} has no values, so V' cannot be compared")
        self.symbols = sorted(terms.free_symbols - {TIME}, key=str)
        self.symbols += sorted(inputs, key=str)
        self.symbols += [TIME] if terms.has(TIME) else []

    def at(self, points: Mapping[Any, Any], count: int) -> np.ndarray:
        """Return values, shape (expressions, count), from those of the symbols."""
        values = {symbol: points[symbol] for symbol in self.symbols}

        def value(e: Expr) -> Any:
            if e not in values:
                values[e] = _value(e, [value(a) for a in e.args])
            return values[e]

        with np.errstate(all="ignore"):
            rows = [np.broadcast_to(value(e), count) for e in self.expressions]
            return np.array(rows).astype(float)


def _value(e: Expr, arguments: list[Any]) -> Any:
    """Return the value of an expression from those of its arguments."""
    if e.is_Add:
        return sum(arguments)
    if e.is_Mul:
        return prod(arguments)
    return numpy_function(e if e.is_Atom else e.func, len(arguments))(*arguments)


@cache
def numpy_function(function: Any, count: int) -> Callable[..., Any]:
    """Return a function of SymPy or of a record as a NumPy function, or a number."""
    if not count:
        return partial(np.float64, float(function))
    arguments = sympy.symbols(f"a_:{count}", real=True)
    modules = [NUMPY_OF, "scipy", "numpy"]
    return sympy.lambdify(arguments, function(*arguments), modules)
