"""V' of verdicts as sums of terms that are not negative, for their files of Coq.

    V' = -e^T KD e - losses                                          a law that falls
    V' = -k e^2 + e d = -(k/2) e^2 - (k/2)(e - d/k)^2 + d^2/(2 k)    a law that is pushed
    V' = -sum of a s^2 - b s over errors s of V                      a law or a diagram with leaks
    V' = -(sum of squares)                                           any other diagram

Relations of a law's states, such as b = theta Q, are put in before.  `invariants` proves that they
are kept.
"""

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any, NamedTuple

import sympy
from sympy import Add, Expr, Mul, Poly, Pow, S

from ..algebra.sums_of_squares import squares
from ..algebra.texts import short
from .answers import Definite, Fall
from .ultimate_bounds import in_forms, pulled_at_once


class NotASum(Exception):
    """V' is not written as a sum; the message is the reason."""


class Term(NamedTuple):
    """A term weight factor b^T M b."""

    weight: Expr  # positive
    basis: Sequence[Expr]
    matrix: Any = ((1,),)  # M >= 0: numbers, or a name of `Case.semidefinite`
    factor: Expr = S.One  # not negative, by assumption

    def times(self, other: "Term") -> "Term":
        """Return the product of two terms, one of them with a basis of one element."""
        longer = max(self, other, key=lambda term: len(term.basis))
        basis = [a * b for a in self.basis for b in other.basis]
        return Term(
            self.weight * other.weight, basis, longer.matrix, self.factor * other.factor
        )


@dataclass
class Case:
    """Equations with V, and V' as a sum: V' + decay V + losses - push = 0."""

    motion: dict[Any, Expr]
    fixed: set  # symbols of parameters
    V: list[Term]
    losses: list[Term]
    push: Expr = S.Zero
    decay: Expr = S.Zero
    semidefinite: Mapping[str, Any] = field(default_factory=dict)  # matrices of symbols
    functions: dict[Any, str] = field(default_factory=dict)  # of time -> kind


Ways = list[Callable[[], Case]]


# --- sums of squares -----------------------------------------------------------------------------


def terms_of(expression: Expr, fixed: set) -> list[Term]:
    """Return an expression as a sum of terms that are not negative."""
    total = squares(expression, fixed)
    if total is None or not total.constant.is_nonnegative:
        raise NotASum(f"{short(expression)} is not known as a sum of squares")
    summands = [summand for term in total.terms for summand in apart(term, fixed)]
    terms = [square(summand, fixed) for summand in summands]
    constant = [Term(total.constant, [S.One])] * bool(total.constant)
    return of_gram(terms) + constant


def apart(term: Expr, fixed: set) -> Iterable[Expr]:
    """Return the parts of a term whose weight is a sum with even powers: (1 + b^2) x^2."""
    weight, form = term.as_independent(*(term.free_symbols - fixed))
    has_signs = all(s.is_positive or s.is_negative for s in weight.free_symbols)
    return (term,) if has_signs else (w * form for w in Add.make_args(weight.expand()))


def square(term: Expr, fixed: set) -> Term:
    """Return a term as weight form^2; divisors are part of the weight."""
    weight, form = S.One, S.One
    for factor in Mul.make_args(term):
        base, power = factor.as_base_exp()
        is_even = power.is_Integer and power.is_even
        has_sign = base.is_positive or base.is_negative
        is_form = is_even and base.is_Symbol and not has_sign
        if power.is_negative or (factor.free_symbols <= fixed and not is_form):
            weight *= factor
        elif is_even:
            form *= base ** (power / 2)
        else:
            raise NotASum(f"{short(factor)} is no square")
    return Term(weight, [form])


def of_gram(terms: list[Term]) -> list[Term]:
    """Return squares of polynomials of degree 2 or more as one term with a Gram matrix.

    It is positive definite, so that it bounds each monomial; otherwise the squares stay.
    """
    forms = [form for term in terms for form in term.basis]
    symbols = sorted(set().union(*(form.free_symbols for form in forms)), key=str)
    is_number = all(t.weight.is_Rational for t in terms)
    if not is_number or not all(form.is_polynomial(*symbols) for form in forms):
        return terms
    rows = [Poly(form, *symbols).as_dict() for form in forms]
    powers = sorted(set().union(*rows), reverse=True)
    is_linear = max(map(sum, powers), default=0) < 2
    if is_linear or len(powers) > len(terms) or len(terms) == sum(map(len, rows)):
        return terms
    weighted = [*zip((t.weight for t in terms), rows, strict=True)]
    G = [
        [sum(w * row.get(a, 0) * row.get(b, 0) for w, row in weighted) for b in powers]
        for a in powers
    ]
    monomials = [Mul(*map(Pow, symbols, power)) for power in powers]
    return [Term(S.One, monomials, G)]


# --- V' as a sum ---------------------------------------------------------------------------------


def lost(case: Case, rate: Expr) -> Case:
    """Return a case with V' as minus a sum of squares."""
    return replace(case, losses=terms_of(-rate, case.fixed))


def pulled(case: Case, V: Expr, rate: Expr, rest: Mapping, forms: Mapping) -> Case:
    """Complete the squares of V' in the errors of V, whose squares V is a sum of; as `forms`."""
    V_rate = sympy.expand(rate.xreplace({s: s + true for s, true in rest.items()}))
    shares = {s: sympy.diff(V, s, 2) / 2 for s in rest}
    pairs = {s: (-V_rate.coeff(s, 2), V_rate.coeff(s, 1)) for s in rest}
    rates = {s: a / (2 * shares[s]) for s, (a, _) in pairs.items() if a.is_positive}
    if not rates or len(rates) < len(rest):
        raise NotASum("V' does not pull all errors of V back")
    is_number = all(r.is_Rational for r in rates.values())
    decay = min(rates.values()) if is_number else sympy.Symbol("rate", positive=True)
    push = V_rate.xreplace(dict.fromkeys(rest, S.Zero))
    losses = []
    for s, (a, b) in pairs.items():
        spare = rates[s] - decay
        weights = (shares[s] * spare, S.One) if is_number else (shares[s], spare)
        losses += [Term(weights[0], [forms[s]], factor=weights[1])] * (spare != 0)
        losses.append(Term(a / 2, [forms[s] - b / a]))
        push += b**2 / (2 * a)
    fixed = case.fixed | decay.free_symbols
    return replace(case, losses=losses, push=push, decay=decay, fixed=fixed)


def of_system(case: Any, definite: Definite, fall: Fall) -> Ways:
    """Return the ways to write V' of a `SystemCandidate`."""

    def system() -> Case:
        if case.eq.discrete:
            raise NotASum("time is discrete")
        motion = {s: rate.xreplace(fall.zeroed) for s, rate in case.motion.items()}
        functions = still(case.eq.jumps, case.V)
        V = terms_of(case.V, case.fixed)
        return Case(motion, case.fixed, V, [], functions=functions)

    def falls() -> Case:
        return lost(system(), case.rate.xreplace(fall.zeroed))

    def pulls() -> Case:
        terms = in_forms(case, definite)
        if fall.level is None or terms is None:
            raise NotASum("V' does not pull V back")
        numbers = pulled_at_once(*terms[:3])
        if numbers is None:
            return pulled(system(), *terms)
        loss = case.rate + numbers.rate * case.V - numbers.push
        return replace(lost(system(), loss), decay=numbers.rate, push=numbers.push)

    return [falls, pulls]


def still(jumps: Mapping[str, Mapping], V: Expr) -> dict[Any, str]:
    """Return states that jump as functions of time; V does not depend on them."""
    moved = {
        s for change in jumps.values() for s, after in change.items() if s != after
    }
    if in_V := moved & V.free_symbols:
        raise NotASum(f"{min(in_V, key=str)} is in V and jumps")
    return dict.fromkeys(moved, "signals")
