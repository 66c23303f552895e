"""Derivatives of expressions along a motion, where pieces meet, and growth with the states.

Where pieces meet with equal slopes, V' is that of each piece (`meets_smoothly`).  A V with a kink
decreases too if it does in each piece and rates are continuous.  Where rates jump, a motion may
slide along the kink, and V rise.
"""

from collections.abc import Callable
from functools import cache
from itertools import combinations
from math import inf
from typing import Any

import sympy
from sympy import Abs, Add, Dummy, Expr, Function, S, diff, expand
from sympy.core.function import AppliedUndef
from sympy.simplify.fu import TR8

from .decided import decided, is_truth
from .every_n import SUM
from .facts import (
    GT,
    INSIDE,
    LOGIC,
    SIGN,
    WHERE,
    fact_of,
    functions_in,
    inputs_in,
    interval,
    is_continuous,
    is_smooth,
    pieces_of,
    roots_in,
    sector_of,
)


def slope_of(call: Any, along: Callable[[Expr], Expr]) -> Expr | None:
    """Return the derivative of a function with pieces, by those of its arguments; or None."""
    name, arguments = call.func.__name__, call.args
    rates = [along(a) for a in arguments]
    if name == "clip" and rates[1:] == [0, 0]:
        return INSIDE(*arguments) * rates[0]
    if name == "Abs":
        return SIGN(arguments[0]) * rates[0]
    if name in ("where", "pick"):
        return call.func(arguments[0], *rates[1:])
    if name == "maximum":
        return WHERE(GT(*arguments), *rates)
    if name == "minimum":
        return WHERE(GT(*arguments[::-1]), *rates)
    return S.Zero if fact_of(call).kind == "step" else None


def _without_steps(terms: list[Expr]) -> Expr:
    """Return the sum of rates, a/(1 + |a|) for |a| - log(1 + |a|), in which no sign is left."""
    for sign in sorted(Add(*terms).atoms(SIGN), key=str):
        (a,) = sign.args
        stepping = [term for term in terms if term.has(sign)]
        smooth = sympy.factor(Add(*stepping)).subs(sign * Abs(a), a)
        if not smooth.has(SIGN):
            terms = [smooth, *(term for term in terms if not term.has(sign))]
    return Add(*terms)


def along(expression: Expr, rates: dict[Any, Expr]) -> Expr:
    """Return the derivative of an expression along a motion: symbols -> their rates, or 0."""

    @cache
    def rate(e: Expr) -> Expr:
        if e in rates:
            return rates[e]
        if e.is_Atom:
            return S.Zero
        if e.is_Add:
            terms = [rate(term) for term in e.args]
            return _without_steps(terms) if e.has(sympy.log) else Add(*terms)
        if e.is_Mul:
            moving = [k for k, a in enumerate(e.args) if rate(a) != 0]
            terms = []
            for k in moving:
                constant = sympy.Mul(*e.args[:k], *e.args[k + 1 :])
                terms.append(rate(e.args[k]) * constant)
            return Add(*terms)
        if e.is_Pow and e.exp.is_Number:
            return e.exp * e.base ** (e.exp - 1) * rate(e.base)
        if (derivative := slope_of(e, rate)) is not None:
            return derivative
        is_of_sympy = isinstance(e, Function) and not isinstance(e, AppliedUndef)
        if is_of_sympy and len(e.args) == 1:
            return e.fdiff() * rate(e.args[0])
        symbols = [s for s in e.free_symbols if rate(s) != 0]
        return Add(*(diff(e, s) * rate(s) for s in symbols))

    return rate(expression)


def slope_in(expression: Expr, s: Any) -> Expr:
    """Return the derivative of an expression by a symbol, of functions with kinks as well."""
    return along(expression, {s: S.One})


def jumps_nowhere(e: Expr) -> bool:
    """Return whether an expression is known to be continuous where it has a value."""
    inputs = {f: Dummy(real=True) for f in inputs_in(e)}
    return is_continuous(e) or meets_smoothly(e.xreplace(inputs), 1)


def meets_smoothly(V: Expr, order: int = 2) -> bool:
    """Return whether V and its slopes agree where pieces meet; V alone if the order is 1."""
    for power in V.atoms(sympy.Pow):
        (s, *_), p = power.base.args or (0,), power.exp
        is_size = isinstance(power.base, Abs) and not functions_in(s)
        if is_size and (p - order + 1).is_positive:  # at 0 as level as s^order
            V = V.xreplace({power: Dummy() * s**order})
    if not all(base.is_positive for base in roots_in(V)):
        return False
    return all(_call_meets_smoothly(V, call, order) for call in functions_in(V))


def _call_meets_smoothly(V: Expr, call: Any, order: int) -> bool:
    """Return whether V and its slopes agree where the pieces of one function meet."""
    name, arguments = call.func.__name__, call.args
    if name in ("where", *LOGIC):  # judged by the comparisons in it
        return all(map(is_truth, arguments[:1] if name == "where" else arguments))
    if fact_of(call).kind == "smooth":
        return True
    branches = pieces_of(call)
    is_nested = bool(functions_in(Add(*arguments)))
    if not branches or is_nested:
        return False
    values = [decided(V.xreplace(replaced)) for _, replaced in branches]
    for j, k in combinations(range(len(branches)), 2):
        opposite = [expand(-margin) for margin in branches[k][0]]
        borders = [margin for margin in branches[j][0] if expand(margin) in opposite]
        if not all(_agrees(values[j] - values[k], b, order) for b in borders):
            return False
    return True


def in_known_pieces(e: Expr, is_positive: Callable[[Expr], Any]) -> Expr:
    """Return an expression without the functions of which one piece is known to hold."""
    for call in sorted(functions_in(e), key=str):
        for margins, values in pieces_of(call):
            if all(map(is_positive, margins)):
                return in_known_pieces(decided(e.xreplace(values)), is_positive)
    return e


def of_same_sign(h: Expr) -> Expr:
    """Return s or -s of a function that rises or falls from 0 with s; others as is.

    It is odd, as tanh(s); or smooth, and of one symbol.  Its slope is then bounded, so it has no
    pole, and keeps its sign, as 1 - sin(2 s) of s - sin(s)^2; h is not 0 at 1, so at no other s.
    """
    if isinstance(h, Function) and (sector := sector_of(h)) and sector.rises:
        return sector.factor
    states = h.free_symbols
    if h.is_Add and len(states) == 1 and functions_in(h) and is_smooth(h):
        (s,) = states
        for sign in (1, -1):
            at_0, at_1 = (sign * h.subs(s, end) for end in (0, 1))
            low, high = interval(TR8(diff(sign * h, s)))
            is_rising = low.is_nonnegative and high.is_finite
            if is_rising and at_0 == 0 and at_1.is_positive:
                return sign * s
    return h


def _agrees(difference: Expr, border: Expr, order: int) -> bool:
    """Return whether a difference vanishes, to an order, where a border is zero."""
    border = expand(border)
    symbols = sorted(border.free_symbols, key=str)
    for s in symbols:
        slope = diff(border, s)
        if slope.is_number and slope != 0:
            line = {s: expand(s - border / slope)}

            def is_above(margin: Expr, line: dict[Any, Expr] = line) -> Any:
                return expand(margin.xreplace(line)).is_positive

            difference = in_known_pieces(difference, is_above)
    numerator, _ = sympy.fraction(sympy.together(difference))
    try:
        remainder = sympy.rem(expand(numerator), expand(border**order), *symbols)
    except (sympy.BasePolynomialError, ZeroDivisionError):
        return False
    return bool(remainder == 0)


def degree(expression: Expr, is_state: Callable[[sympy.Symbol], bool]) -> float:
    """Return the power of the states with which an expression grows; inf if not known.

    A state that V does not contain exists for all t if |s'| <= a (1 + |s|), a bounded on bounded
    times (Gronwall's lemma); s' = 1 + s^2 escapes at t = pi/2.
    """
    ends = interval(expression)
    if not any(map(is_state, expression.free_symbols)) or all(
        e.is_finite for e in ends
    ):
        return 0.0
    if expression.is_Symbol:
        return 1.0
    degrees = [degree(argument, is_state) for argument in expression.args]
    if expression.is_Mul:
        return sum(degrees)
    if expression.is_Add:
        return max(degrees)
    if isinstance(expression, SUM):
        return degrees[0]
    if isinstance(expression, sympy.exp):
        return 0.0 if expression.args[0].is_nonpositive else inf
    if expression.is_Pow and expression.exp.is_number:
        if expression.exp.is_positive:
            return float(expression.exp) * degrees[0]
        is_away_from_zero = interval(expression.base)[0].is_positive
        return 0.0 if is_away_from_zero else inf
    growth = fact_of(expression).growth
    if growth == "as all":
        return max(degrees)
    if growth == "as branches":  # for any value of the first argument
        return max(degrees[1:])
    return 0.0 if growth == "bounded" else inf
