"""Exact algebra: zero tests, expansion and factors of expressions.

An expression is zero if as one fraction p/q, of polynomials over the rationals in its symbols and
functions, p = 0 and q is not.  Roots and rounded numbers are left to SymPy's own rules.
"""

from functools import lru_cache
from math import comb, prod
from typing import Any

import sympy
from sympy.core.function import AppliedUndef
from sympy.polys.polyconfig import using
from sympy.polys.rings import PolyElement, PolyRing

from ...base.errors import DiagramError
from .facts import CLIP, INSIDE
from .steps import short

MOST_TERMS = 20_000  # more are not multiplied out
HIGHEST = 4  # higher powers are not factored
MOST_FACTORED, LARGEST = 40, 10  # terms; numbers in an exponent of e
WHOLE = 100  # higher powers stay as they are
MOST_PLACES = 20  # of three, one in five polynomials of nine words had bad ones alone
# 1 - sin^2, 1 + sinh^2
EVEN = {sympy.cos: (sympy.sin, -1), sympy.cosh: (sympy.sinh, 1)}


@lru_cache(maxsize=1000)  # much is the same for each N
def vanishes(expression: Any) -> bool:
    """Return whether an expression is zero; one that divides by zero is not."""
    expression = sympy.sympify(expression)
    p, q = _fraction(expression)
    parts = p.ring.symbols
    if (
        p == 0
        or q == 0
        or all(isinstance(part, sympy.Symbol | AppliedUndef) for part in parts)
    ):
        return p == 0 and q != 0
    p, q = map(sympy.expand, sympy.fraction(sympy.together(expression)))
    return p == 0 and q != 0


@lru_cache(maxsize=1000)
def as_factors(expression: sympy.Expr) -> sympy.Expr:
    """Return an expression as one fraction of factors."""
    p, q = _fraction(expression)
    return _product(p.as_expr()) / _product(q.as_expr())


def _product(expression: sympy.Expr) -> sympy.Expr:
    """Return an expression factored.

    SymPy lifts factors from random places; from a bad one of a few it does not come back.
    """
    with using(EEZ_NUMBER_OF_CONFIGS=MOST_PLACES):
        return sympy.factor(expression)


def left_over(residual: Any) -> str:
    """Return a residual that should be zero, in words; "" where it is."""
    return "" if vanishes(residual) else f"left over: {short(sympy.expand(residual))}"


def _parts(expression: sympy.Expr) -> set[sympy.Expr]:
    """Return what an expression is a fraction of polynomials in."""
    if expression.is_Add or expression.is_Mul:
        return set().union(*map(_parts, expression.args))
    if expression.is_Pow and expression.exp.is_Integer:
        return _parts(expression.base)
    return set() if expression.is_Rational else {expression}


def _fraction(expression: sympy.Expr) -> tuple[PolyElement, PolyElement]:
    """Return p and q of an expression p/q; SymPy's own field takes much longer, with divisors."""
    ring = PolyRing([*_parts(expression)], sympy.ZZ)
    known = {
        part: (own, ring.one) for part, own in zip(ring.symbols, ring.gens, strict=True)
    }

    def fraction(e: sympy.Expr) -> tuple[PolyElement, PolyElement]:
        if e not in known:
            known[e] = multiplied(e)
        return known[e]

    def multiplied(e: sympy.Expr) -> tuple[PolyElement, PolyElement]:
        if e.is_Rational:
            return ring.ground_new(e.p), ring.ground_new(e.q)
        if e.is_Pow:
            p, q = fraction(e.base)[:: 1 if e.exp > 0 else -1]
            return p ** abs(int(e.exp)), q ** abs(int(e.exp))
        parts = [fraction(one) for one in e.args]
        if e.is_Mul:
            return ring.mul(*(p for p, _ in parts)), ring.mul(*(q for _, q in parts))
        numerators: dict[PolyElement, list[PolyElement]] = {}  # by their denominator
        for p, q in parts:
            numerators.setdefault(q, []).append(p)
        p, q = ring.zero, ring.one
        for other, shares in numerators.items():
            p, q = p * other + ring.add(*shares) * q, q * other
        return p, q

    return fraction(expression)


@lru_cache(maxsize=1000)
def tidied(expression: sympy.Expr) -> sympy.Expr:
    """Return an expression multiplied out, cos^2 as 1 - sin^2, cosh^2 as 1 + sinh^2.

    An angle's sums and multiples are written out only where others share its symbols: of sin(3 t)
    alone more is known than of 3 sin(t) - 4 sin(t)^3.
    """
    if terms_of(expression) > MOST_TERMS:
        raise DiagramError(
            f"V' has more than {MOST_TERMS} terms; make the law or its N smaller"
        )
    masked = {
        e: sympy.Dummy(str(e), positive=True) for e in expression.atoms(sympy.exp)
    }
    if masked and not any(e.args[0].atoms(sympy.exp) for e in masked):
        # else in its denominators
        plain = tidied(expression.xreplace(masked)).xreplace(
            {d: e for e, d in masked.items()}
        )
        return sympy.expand(plain, deep=False, power_exp=False)
    angles = {
        p.base.args[0]
        for p in expression.atoms(sympy.Pow)
        if isinstance(p.base, sympy.cosh)
    }
    if angles:  # sinh/cosh, as of log(cosh)
        tanh = {sympy.sinh(a): sympy.tanh(a) * sympy.cosh(a) for a in angles}
        expression = sympy.expand(expression.xreplace(tanh))
    known = dict[sympy.Expr, sympy.Expr]()
    high = {p.base for p in high_powers(expression)}
    for even, (odd, _) in EVEN.items():
        turns = expression.atoms(even, odd) - high
        angles = {one.args[0] for one in turns}
        known |= {
            one: sympy.expand_trig(one) for one in turns if _meets(one.args[0], angles)
        }
    expression = sympy.expand(expression.xreplace(known))
    for within in expression.atoms(INSIDE):  # where clip(s, a, b) is s
        ends = {at: expression.xreplace({within: sympy.Integer(at)}) for at in (0, 1)}
        inside = (ends[1] - ends[0]).xreplace({CLIP(*within.args): within.args[0]})
        expression = sympy.expand(ends[0] + within * inside)
    for p in expression.atoms(sympy.Pow):
        if (
            p.base.func in EVEN
            and p.exp.is_Integer
            and p.exp != -1
            and p.base not in high
        ):
            odd, sign = EVEN[p.base.func]
            square = 1 + sign * odd(*p.base.args) ** 2
            known[p] = square ** (p.exp // 2) * p.base ** (p.exp % 2)
    return sympy.expand(expression.xreplace(known))


def high_powers(expression: sympy.Expr) -> set[sympy.Expr]:
    """Return the powers that stay as they are, and exp(1000 x): SymPy has it as exp(x)**1000."""
    powers = {
        p
        for p in expression.atoms(sympy.Pow)
        if p.exp.is_Integer and abs(p.exp) > WHOLE
    }
    for e in expression.atoms(sympy.exp):
        if any(max(abs(n.p), n.q) > LARGEST for n in e.args[0].atoms(sympy.Rational)):
            powers.add(e)
    return powers


def _meets(angle: sympy.Expr, others: set[sympy.Expr]) -> bool:
    """Return whether sums and low multiples in an angle may cancel what others of them make."""
    low = all(abs(n) <= HIGHEST for n in angle.atoms(sympy.Integer))
    apart = others - {angle, -angle}
    return low and any(angle.free_symbols & other.free_symbols for other in apart)


def factored(expression: sympy.Expr, most: int = MOST_FACTORED) -> sympy.Expr:
    """Return an expression factored, or as it is where it has many terms or operations."""
    if len(sympy.Add.make_args(expression)) > most or expression.count_ops() > 5 * most:
        return expression
    whole = {
        e: sympy.Dummy(
            str(e), positive=e.is_positive or None, nonnegative=e.is_nonnegative or None
        )
        for e in high_powers(expression)
    }
    return _product(expression.xreplace(whole)).xreplace(
        {dummy: e for e, dummy in whole.items()}
    )


def terms_of(expression: sympy.Expr) -> int:
    """Return how many terms there are at most, multiplied out."""
    if expression.is_Add:
        return sum(map(terms_of, expression.args))
    if expression.is_Mul:
        return prod(map(terms_of, expression.args))
    if expression.is_Pow and expression.exp.is_Integer and expression.base.is_Add:
        n, m = terms_of(expression.base), abs(int(expression.exp))
        return comb(n + m - 1, m)
    return 1
