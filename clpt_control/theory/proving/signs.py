"""What is known of an expression: whether it is zero, negative, and how fast it grows.

An expression is zero if, multiplied out as a polynomial over the rationals in all that it is made
of (symbols, words and 1/b for each b that it divides by, d the highest power of 1/b),

    sum_k p_k (1/b)^k = 0    where    sum_k p_k b^(d-k) = 0

Roots and numbers with a rounding are left to SymPy's own rules.  A residual is never positive where
it factors into squares with a minus, or is -s^T M s with M >= 0.  A term that pulls back bounds one
that does not:

    -a s^2 + b s <= -(a/2) s^2 + b^2/(2 a)

A state s that V does not hold, with |s'| <= a (1 + |s|) where a is bounded on bounded times, exists
for all t (Gronwall's lemma); s' = 1 + s^2 ends at t = pi/2, and with it the run.  How fast an
expression grows with such states is its degree: 0 is bounded, 1 is linear.
"""

from collections.abc import Callable, Mapping, Sequence
from functools import lru_cache
from math import comb, inf, prod
from typing import Any, NamedTuple

import numpy as np
import sympy
from sympy.core.function import AppliedUndef
from sympy.polys.rings import PolyElement, ring

from ...equations.every_n import SUM
from ...errors import DiagramError
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
