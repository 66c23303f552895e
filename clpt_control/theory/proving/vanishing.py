"""Whether an expression is zero, exactly.

It is multiplied out as a polynomial over the rationals in all that it is made of: symbols, words
and 1/b for each b that it divides by.  With d the highest power of 1/b,

    sum_k p_k (1/b)^k = 0    where    sum_k p_k b^(d-k) = 0

Roots and numbers with a rounding are left to SymPy's own rules.
"""

from typing import Any

import sympy
from sympy.core.function import AppliedUndef
from sympy.polys.rings import PolyElement, ring

from .proof import short


def vanishes(expression: Any) -> bool:
    """Return whether an expression is zero; one that divides by zero is not."""
    expression = sympy.sympify(expression)
    inverses: dict[sympy.Expr, sympy.Dummy] = {}  # inner before outer
    expression = _without_division(expression, inverses)
    back = {inverse: 1 / b for b, inverse in inverses.items()}

    def as_given(found: sympy.Expr) -> sympy.Expr:
        for inverse in reversed(back):
            found = found.xreplace({inverse: back[inverse]})
        return found

    if any(not b.is_Symbol and vanishes(as_given(b)) for b in inverses):
        return False
    parts = set(inverses.values()).union(*map(_parts, (expression, *inverses)))
    if not parts:
        return expression == 0
    own, *_ = ring(sorted(parts, key=str), sympy.QQ)
    left = own.from_expr(expression)
    for b, inverse in reversed(inverses.items()):
        left = _times(left, own.from_expr(b), own.index(own.from_expr(inverse)))
    if left == 0:
        return True
    if all(isinstance(part, sympy.Symbol | AppliedUndef) for part in parts):
        return False
    numerator, _ = sympy.fraction(sympy.together(as_given(expression)))
    return sympy.expand(numerator) == 0


def left_over(rest: Any) -> str:
    """Return what is left where nothing should be, or nothing."""
    return "" if vanishes(rest) else f"left over: {short(sympy.expand(rest))}"


def _without_division(expression: sympy.Expr, inverses: dict) -> sympy.Expr:
    """Return an expression with a symbol for 1/b; `inverses` gets b -> symbol."""
    if expression.is_Add or expression.is_Mul:
        return expression.func(*(_without_division(one, inverses) for one in expression.args))
    if not expression.is_Pow or not expression.exp.is_Integer:
        return expression
    b, power = _without_division(expression.base, inverses), int(expression.exp)
    if power < 0:
        b = inverses.setdefault(b, sympy.Dummy("inverse"))
    return b ** abs(power)


def _parts(expression: sympy.Expr) -> set[sympy.Expr]:
    """Return what an expression without division is a polynomial in."""
    if expression.is_Add or expression.is_Mul:
        return set().union(*map(_parts, expression.args))
    if expression.is_Pow and expression.exp.is_Integer:
        return _parts(expression.base)
    return set() if expression.is_Rational else {expression}


def _times(left: PolyElement, b: PolyElement, place: int) -> PolyElement:
    """Return a polynomial times b^d, where the generator at a place is 1/b, to the d at most."""
    powers: dict[int, dict] = {}
    for monomial, coefficient in left.terms():
        rest = (*monomial[:place], 0, *monomial[place + 1 :])
        powers.setdefault(monomial[place], {})[rest] = coefficient
    highest = max(powers, default=0)
    found = left.ring.zero
    for power, terms in powers.items():
        found += left.ring.from_dict(terms) * b ** (highest - power)
    return found
