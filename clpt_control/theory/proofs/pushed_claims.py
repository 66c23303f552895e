"""Means of what a claim pulls back: errors e of V under a push p.

    V' <= -k e^2 + e p <= -k e^2/2 + p^2/(2 k)     so  int k e^2 dt <= int p^2/k dt + 2 V(0)

V is finite at all times if it is a polynomial in linear forms, p is linear in its states, and other
states move by themselves: then V' <= c (1 + V).
"""

from typing import Any

from sympy import Expr, Poly, S, Tuple, diff, expand

from ..algebra.slopes import degree
from .answers import Definite, Fall
from .statements import said
from .ultimate_bounds import bounded


def mean_of(case: Any, definite: Definite) -> Fall | None:
    """Return the bound of the mean of k e^2 by that of p^2/k, if the claim has this form.

    A push by inputs alone says less than V' where they are 0.
    """
    states, forms = case.errors
    claim = expand((case.claim or S.Zero).xreplace(states))
    errors = [e for e in (*forms, *case.motion) if diff(claim, e, 2) != 0]
    if not (errors and claim.is_polynomial(*errors)):
        return None
    of_e, lost, push = Poly(claim, *errors), S.Zero, S.Zero
    for e in errors:
        k, p = -of_e.coeff_monomial(e**2), of_e.coeff_monomial(e)
        if not k.is_positive or k.free_symbols - case.fixed:
            return None
        claim, lost, push = claim + k * e**2 - e * p, lost + k * e**2, push + p**2 / k
    is_by_inputs = case.is_pushed and not push.has(*forms, *case.motion)
    if expand(claim) != 0 or is_by_inputs or _may_escape(case, definite, push):
        return None
    lost, push = (case.text(e.xreplace(forms)) for e in (lost, push))
    claim = said("V' <= -({})/2 + ({})/2", lost, push)
    return bounded(claim, "mean", bound=said("{} is at most {}", lost, push))


def _may_escape(case: Any, definite: Definite, push: Expr) -> bool:
    """Return whether V may grow faster than c (1 + V)."""
    V, forms = case.V, definite.forms
    slopes = Tuple(*(diff(f, s) for f in forms for s in case.motion))
    if not V.is_polynomial(*case.motion) or slopes.free_symbols - case.fixed:
        return True
    in_V = {s for s in case.motion if any(form.has(s) for form in forms)}
    own = {*case.errors[1], *in_V.intersection(forms)}
    others = push.free_symbols & case.motion.keys() - own
    outside = Tuple(*(r for s, r in case.motion.items() if s not in in_V))
    is_driven = outside.has(*in_V) or not in_V.isdisjoint(others)
    return degree(push, own.__contains__) > 2 or (bool(others) and is_driven)
