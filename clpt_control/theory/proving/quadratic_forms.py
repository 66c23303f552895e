"""Signs of quadratic forms: what is negative for all states, and what is bounded.

A residual r is never positive where it factors into squares with a minus, or is
-s^T M s with M >= 0.  A term that pulls back bounds one that does not:

    -a s^2 + b s <= -(a/2) s^2 + b^2/(2 a)
"""

from collections.abc import Sequence
from functools import lru_cache
from math import comb, prod
from typing import NamedTuple

import sympy
from sympy.core.function import AppliedUndef

from ...errors import DiagramError

MOST_TERMS = 20_000  # more are not multiplied out
MOST_JUDGED = 400  # of more no sign is known
HIGHEST = 4  # higher powers are not factored
FEW = 12  # terms; more with words in them are not factored


class Pull(NamedTuple):
    """V' <= -rate V + push, or -e^T KD e/2 + push where rate is zero."""

    rate: sympy.Expr  # in what the law does not know: theta, KD and GammaD
    push: sympy.Expr


def tidied(expression: sympy.Expr) -> sympy.Expr:
    """Return an expression multiplied out, cos^2 as 1 - sin^2."""
    if _terms(expression) > MOST_TERMS:
        raise DiagramError(f"V' has more than {MOST_TERMS} terms; make the law or its N smaller")
    pairs = ((sympy.cos, sympy.sin, -1), (sympy.cosh, sympy.sinh, 1))
    known = {
        f(a): sympy.expand_trig(f(a))
        for pair in pairs
        for f in pair[:2]
        for a in {one.args[0] for one in expression.atoms(f)}
    }
    expression = sympy.expand(expression.xreplace(known))
    for even, odd, sign in pairs:
        for one in expression.atoms(even):
            square = 1 + sign * odd(one.args[0]) ** 2
            for n in range(4, 1, -1):  # higher powers stay
                expression = expression.subs(one**n, square ** (n // 2) * one ** (n % 2))
    return sympy.expand(expression)


def _terms(expression: sympy.Expr) -> int:
    """Return how many terms there are at most, multiplied out."""
    if expression.is_Add:
        return sum(map(_terms, expression.args))
    if expression.is_Mul:
        return prod(map(_terms, expression.args))
    if expression.is_Pow and expression.exp.is_Integer and expression.base.is_Add:
        n, m = _terms(expression.base), abs(int(expression.exp))
        return comb(n + m - 1, m)
    return 1


def positive_definite(
    V: sympy.Expr, states: Sequence[sympy.Symbol], truth: dict, values: dict
) -> bool:
    """Return whether V is known to be positive definite in the errors of the states.

    Its Hessian at the parameters' values must be constant and positive definite, V and its
    slopes zero at the truth (state -> where its error is zero).
    """
    H = sympy.hessian(V, list(states)).xreplace(values)
    if H.free_symbols or H.atoms(AppliedUndef):
        return False
    at_truth = [V, *(sympy.diff(V, s) for s in states)]
    zero = all(tidied(v.xreplace(truth)) == 0 for v in at_truth)
    return zero and bool(H.is_positive_definite)


def nonpositive(expression: sympy.Expr, apart: set, values: dict) -> bool:
    """Return whether an expression is known never to be positive.

    Terms that share no symbol of `apart`, the states and truths, are judged apart.
    """
    return all(_negative(group, apart, values) for group in _groups(expression, apart))


def _groups(expression: sympy.Expr, apart: set) -> list[sympy.Expr]:
    groups: list[tuple[set, list]] = []
    for term in sympy.Add.make_args(sympy.expand(expression)):
        own = term.free_symbols & apart
        joined = [g for g in groups if g[0] & own]
        groups = [g for g in groups if not g[0] & own]
        first = joined[0] if joined else (set(), [])
        for symbols, terms in joined[1:]:
            first[0].update(symbols)
            first[1].extend(terms)
        first[0].update(own)
        first[1].append(term)
        groups.append(first)
    return [sympy.Add(*terms) for _, terms in groups]


@lru_cache(maxsize=10_000)
def _factors_below_zero(group: sympy.Expr) -> bool:
    return bool(sympy.factor(group).is_nonpositive)


def _negative(group: sympy.Expr, apart: set, values: dict) -> bool:
    if len(sympy.Add.make_args(group)) > MOST_JUDGED:
        return False
    powers = [power.exp for power in group.atoms(sympy.Pow)]
    low = all(exponent.is_Integer and exponent <= HIGHEST for exponent in powers)
    simple = not group.atoms(AppliedUndef) or len(sympy.Add.make_args(group)) <= FEW
    if low and simple and _factors_below_zero(group):
        return True
    own = sorted(group.free_symbols & apart, key=str)
    if not own or not group.is_polynomial(*own):
        return False
    H = sympy.hessian(group, own)
    at_zero = dict.fromkeys(own, sympy.Integer(0))
    rest = [group.xreplace(at_zero), *(sympy.diff(group, s).xreplace(at_zero) for s in own)]
    if any(sympy.expand(value) != 0 for value in rest):
        return False
    H = H.xreplace(values)
    return (
        not H.free_symbols and not H.atoms(sympy.Function) and bool((-H).is_positive_semidefinite)
    )


def positive_maximum(f: sympy.Expr) -> bool:
    """Return whether an expression is maximum(a, b) with a positive one."""
    own = isinstance(f, AppliedUndef) and str(f.func) == "maximum"
    return own and any(bool(a.is_positive) for a in f.args)


def pulled(
    rate: sympy.Expr, V: sympy.Expr, truth: dict, values: dict, moving: set | None = None
) -> Pull | None:
    """Bound V' by what pulls back and a constant, state by state.

    None where V' is not a sum of a term -a s^2 + b s for each error s; what depends on `moving`,
    all states and time, is no constant.
    """
    states, moves = list(truth), {*truth, *(moving or ())}
    shifted = {s: s + truth[s] for s in states}
    if not rate.is_polynomial(*states) or sympy.Poly(rate, *states).total_degree() > 2:
        return None
    rate, V = (sympy.expand(one.xreplace(shifted)) for one in (rate, V))
    H, slopes = sympy.hessian(rate, states), {s: sympy.diff(rate, s) for s in states}
    weights = sympy.hessian(V, states)
    zero = dict.fromkeys(states, sympy.Integer(0))
    if not H.is_diagonal() or not weights.is_diagonal() or rate.xreplace(zero) != 0:
        return None
    push, rates = sympy.Integer(0), []
    for k, s in enumerate(states):
        a, b = (-H[k, k] / 2).xreplace(values), slopes[s].xreplace(zero).xreplace(values)
        if not a.is_nonnegative or _moves(a, moves) or _moves(b, moves) or (a == 0 and b != 0):
            return None
        push += b**2 / (2 * a) if b != 0 else 0
        rates.append(a / weights[k, k].xreplace(values))
    return None if push == 0 else Pull(sympy.Min(*rates), push)


def _moves(expression: sympy.Expr, moving: set) -> bool:
    return bool(expression.free_symbols & moving or expression.atoms(sympy.Function))
