"""Conditions between parameters, such as b > a, r < 1 and b^2 < 4 a, on which a sign depends.

A margin m > 0 of the parameters is used by writing one of them in a positive symbol d:

    b = a + d of b > a,    r = 1/(1 + d) of r < 1, r > 0,    a = b^2/4 + d of b^2 < 4 a

so that every other question reads the condition as the sign of d.  Margins are factors of the
coefficients of V and V', and of the leading minors of their second derivatives, that are positive
with the parameters' values.
"""

from collections import Counter
from collections.abc import Iterator
from typing import Any

import sympy
from sympy import Add, Expr, Mul

from ...engine.diagram.symbol_names import TIME
from ..algebra.exact import factored
from ..algebra.texts import short
from .rate_as_sum import is_nonnegative

MOST_STATES = 4  # of leading minors


def _deciding(case: Any) -> Iterator[Expr]:
    """Yield expressions of parameters on which the signs of V and V' may depend."""
    for e in case.V, (case.claim or 0) - case.rate:
        e, weights = sympy.expand(e.xreplace(case.where.inside)), Counter[Expr]()
        for term in Add.make_args(e):
            moving = term.free_symbols - case.fixed
            weight, varying = term.as_independent(*moving, as_Add=False)
            weights[varying] += weight
        yield from (weight for e, weight in weights.items() if is_nonnegative(e))
        used = [s for s in case.states if e.has(s)][:MOST_STATES]
        H = sympy.hessian(e, used or [TIME]).xreplace(dict.fromkeys(used, sympy.S.Zero))
        yield from (H[:k, :k].det() for k in range(2, len(used) + 1))


def margins_of(case: Any) -> Iterator[Expr]:
    """Yield factors whose sign is not known, positive with the values of parameters."""
    for decisive in _deciding(case):
        for factor in Mul.make_args(factored(decisive)):
            base = factor.as_base_exp()[0]
            is_known = base.is_nonnegative or base.is_nonpositive
            value = base.xreplace(case.given).xreplace(case.eq.values)
            if value.is_number and value != 0 and not is_known:
                yield base * sympy.sign(value)


def written_in(d: Any, margin: Expr, parameters: set) -> tuple[Any, Expr, Expr] | None:
    """Return a parameter, what it is of d > 0 where a margin is positive, and d of it."""
    for sign in 1, -1:
        for q in sorted(margin.free_symbols & parameters, key=str):
            slope = sympy.diff(margin, q)
            if slope.has(q) or not (sign * slope).is_positive:
                continue
            end = sympy.expand(q - margin / slope)
            keeps_sign = sign < 0 and q.is_positive and end.is_positive
            value = end / (1 + d) if keeps_sign else end + sign * d
            return q, value, sympy.solve(value - q, d)[0]
    return None


def as_relation(margin: Expr) -> str:
    """Return margin > 0 as text, each term on the side where it is positive: b > a."""
    terms = Add.make_args(sympy.expand(margin))
    below = Add(*(t for t in terms if t.could_extract_minus_sign()))
    return f"{short(Add(*terms) - below)} > {short(-below)}"
