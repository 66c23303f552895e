"""Whether a law's other states exist for all times: V bounds only what stands in it.

A state s of the law that V does not hold, with |s'| <= a (1 + |s|) where a is bounded on bounded
times, exists for all t (Gronwall's lemma); s' = 1 + s^2 ends at t = pi/2, and with it the run.
How fast an expression grows with such states is its degree: 0 is bounded, 1 is linear.
"""

from collections.abc import Callable, Mapping
from math import inf
from typing import Any

import numpy as np
import sympy

from ...equations.every_n import SUM
from .proof import short

BOUNDED = (sympy.sin, sympy.cos, sympy.tanh, sympy.atan, sympy.atan2, sympy.erf)
YES_OR_NO = ("sign", "lt", "le", "gt", "ge", "and_", "or_", "not_")
AS_ITS_PARTS = ("Abs", "minimum", "maximum", "floor", "trunc", "ceil", "asinh")
AS_ITS_OTHERS = ("where", "pick", "clip", "mod")  # whatever the first argument is


def faster_than_linear(moves: Mapping[str, Any], states: Mapping[str, Any]) -> str:
    """Return which state may move faster than linearly in the states, and how; or ""."""
    names = {str(s).split("[")[0] for own in states.values() for s in np.ravel(own)}

    def own(symbol: sympy.Symbol) -> bool:
        return str(symbol).split("[")[0] in names  # m[k] is one of m[j]

    for what, move in moves.items():
        for one in np.ravel(move):
            if degree(sympy.sympify(one), own) > 1:
                return f"{what} = {short(one)} may grow faster than linearly"
    return ""


def degree(expression: sympy.Expr, own: Callable[[sympy.Symbol], bool]) -> float:
    """Return at most which power of its own states an expression grows with; inf if not known."""
    if not any(map(own, expression.free_symbols)):
        return 0.0
    if expression.is_Symbol:
        return 1.0
    of, name = [degree(one, own) for one in expression.args], str(expression.func)
    if isinstance(expression, BOUNDED) or name in YES_OR_NO:
        return 0.0
    if expression.is_Mul:
        return sum(of)
    if expression.is_Add or name in AS_ITS_PARTS:
        return max(of)
    if name in AS_ITS_OTHERS:
        return max(of[1:])
    if isinstance(expression, SUM):
        return of[0]
    if isinstance(expression, sympy.exp):
        return 0.0 if expression.args[0].is_nonpositive else inf
    if expression.is_Pow and expression.exp.is_number:
        if expression.exp.is_positive:
            return float(expression.exp) * of[0]
        return 0.0 if _above_zero(expression.base) else inf
    return inf


def _above_zero(expression: sympy.Expr) -> bool:
    """Return whether an expression stays away from zero: a positive number and squares."""
    parts = sympy.Add.make_args(expression)
    if str(expression.func) == "maximum":
        return any(one.is_number and one.is_positive for one in expression.args)
    squares = all(one.is_nonnegative for one in parts)
    return squares and any(one.is_number and one.is_positive for one in parts)
