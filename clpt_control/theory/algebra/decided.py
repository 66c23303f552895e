"""Comparisons, choices and functions of numbers in expressions, evaluated or made shorter.

gt(2, 1)  ->  1        where(1, a, b)  ->  a        lt(|s|, c)  ->  and_(lt(s, c), gt(s, -c))
"""

from typing import Any

import sympy
from sympy import Abs, Expr, Function, Integer
from sympy.core.function import AppliedUndef

from .facts import COMPARISONS, LOGIC, fact_of, functions_in

CONNECTIVES = {"and_": sympy.And, "or_": sympy.Or, "not_": sympy.Not}
MOST_ATOMS = 6  # comparisons in a condition that is simplified


def decided(expression: Expr) -> Expr:
    """Return an expression in which comparisons and choices of numbers are evaluated."""
    return expression.replace(lambda e: isinstance(e, AppliedUndef), _outcome)


def _outcome(call: Any) -> Any:
    """Return the value of a comparison, a choice or a function of numbers, or the call."""
    name, arguments = call.func.__name__, call.args
    are_numbers = [a.is_number for a in arguments]
    if name == "where" and are_numbers[0]:
        condition, *branches = arguments
        return branches[0] if condition != 0 else branches[1]
    if name in COMPARISONS:
        truth = COMPARISONS[name](*arguments)
        if truth in (True, False):
            return Integer(bool(truth))
        return _without_size(call)
    if name in LOGIC:
        is_known = any(are_numbers) and all(map(is_truth, arguments))
        return LOGIC[name](*arguments) if is_known else _truth_of(call)
    number = fact_of(call).number
    if number is not None and all(are_numbers):
        return number(*arguments)
    return call


def _truth_of(call: Any) -> Any:
    """Return 1 or 0 for a condition that always holds, or never; otherwise the call."""
    atoms: dict[tuple, sympy.Symbol] = {}

    def proposition(e: Any) -> Any:
        name, arguments = e.func.__name__, e.args
        if name in CONNECTIVES:
            return CONNECTIVES[name](*map(proposition, arguments))
        if name in ("gt", "le"):  # a > b unless b >= a
            arguments = arguments[::-1]
        key = arguments if name in COMPARISONS else (e,)
        atom = atoms.setdefault(key, sympy.Dummy())
        return ~atom if name in ("lt", "gt") else atom

    statement = proposition(call)
    if len(atoms) <= MOST_ATOMS:
        statement = sympy.simplify_logic(statement, force=True)
    is_decided = statement in (sympy.true, sympy.false)
    return Integer(bool(statement)) if is_decided else call


def _without_size(call: Any) -> Any:
    """Return a comparison of |s| with a number or a parameter as two of s."""
    (size, c), name = call.args, call.func.__name__
    other = {"lt": "gt", "gt": "lt", "le": "ge", "ge": "le"}
    if isinstance(c, Abs):
        size, c, name = c, size, other[name]
    if not isinstance(size, Abs) or functions_in(c):
        return call
    is_small = name in ("lt", "le")
    (s,), word = size.args, Function("and_" if is_small else "or_", real=True)
    two = (Function(f, real=True) for f in (name, other[name]))
    return word(*(f(s, end) for f, end in zip(two, (c, -c), strict=True)))


def is_truth(e: Expr) -> bool:
    """Return whether an expression is 0, 1 or a truth value."""
    return e in (0, 1) or e.func.__name__ in (*COMPARISONS, *LOGIC)
