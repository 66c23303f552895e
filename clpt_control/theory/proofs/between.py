"""Conditions between parameters, such as b > a, r < 1 and b^2 < 4 a, on which a sign depends.

A margin m > 0 of the parameters is used by writing one of them in a positive symbol d:

    b = a + d of b > a,    r = 1/(1 + d) of r < 1, r > 0,    a = b^2/4 + d of b^2 < 4 a

so that every other question reads the condition as the sign of d.  Margins are factors of V', and
of the leading minors of the second derivatives of V and V', that are positive with the parameters'
values.
"""

from collections.abc import Iterator
from typing import Any

import sympy
from sympy import Add, Expr, Mul, expand

from ..algebra.exact import factored
from ..algebra.facts import is_smooth
from .statements import Statement, said

MOST_STATES = 4  # of leading minors


def _deciding(case: Any) -> Iterator[Expr]:
    """Yield V', and leading minors of V and V', on whose factors their signs may depend."""
    yield case.rate
    for e in filter(is_smooth, (case.V, (case.claim or 0) - case.rate)):
        states = [s for s in case.states if e.has(s)] or case.states
        H = sympy.hessian(e, states).xreplace(dict.fromkeys(states, sympy.S.Zero))
        if all(n.is_rational_function() for n in H):  # minors of others take minutes
            minors = range(1, 1 + len(states[:MOST_STATES]))
            yield from (H[:k, :k].det() for k in minors)


def margins_of(case: Any) -> Iterator[Expr]:
    """Yield factors whose sign is not known, positive with the values of parameters."""
    for decisive in _deciding(case):
        for factor in Mul.make_args(factored(decisive)):
            base = factor.as_base_exp()[0]
            is_known = base.is_nonnegative or base.is_nonpositive
            moves = base.free_symbols - case.fixed or base.has(*case.intervals)
            value = base.xreplace(case.given).xreplace(case.eq.values)
            if value.is_number and value != 0 and not (is_known or moves):
                yield base * sympy.sign(value)


def written_in(d: Any, margin: Expr, parameters: set) -> tuple[Any, Expr, Expr] | None:
    """Return a parameter, what it is of d > 0 where a margin is positive, and d of it."""
    for sign in 1, -1:
        for q in sorted(margin.free_symbols & parameters, key=str):
            slope = sympy.diff(margin, q)
            if slope.has(q) or not (sign * slope).is_positive:
                continue
            end = expand(q - margin / slope)
            keeps_sign = sign < 0 and q.is_positive and end.is_positive
            value = end / (1 + d) if keeps_sign else end + sign * d
            return q, value, sympy.solve(value - q, d)[0]
    return None


def assume(case: Any, margin: Expr) -> None:
    """Write a parameter of a candidate in a positive symbol, such that a margin is positive."""
    names = {str(s): s for s in case.fixed}
    margin = margin.xreplace({s: names[str(s)] for s in margin.free_symbols})
    case.margins.append(margin.xreplace(case.given))
    d = sympy.Symbol(f"margin_{len(case.margins)}", positive=True)
    if way := written_in(d, margin, {*case.eq.values}):
        s, value, meaning = way
        case.given[d] = meaning.xreplace(case.given)
        case.fixed.add(d)
        case.write(lambda e: e.xreplace({s: value}))


def as_relation(margin: Expr) -> Statement:
    """Return margin > 0 in words, each term on the side where it is positive: b > a, r < 1."""
    terms = Add.make_args(expand(margin))
    below = Add(*(t for t in terms if t.could_extract_minus_sign()))
    above, less = Add(*terms) - below, -below
    return (
        said("{} < {}", less, above)
        if f"{above}".isdigit()
        else said("{} > {}", above, less)
    )
