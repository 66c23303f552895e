"""V' of verdicts and theorems as sums, for certificates.

    V' = -e^T KD e - losses                                          a law that falls
    V' = -k e^2 + e d = -(k/2) e^2 - (k/2)(e - d/k)^2 + d^2/(2 k)    a law that is pushed
    V' = -sum of a s^2 - b s over errors s of V                      a law or a diagram with leaks
    V' = -(sum of squares)                                           any other diagram

Relations of a law's states, such as b = theta Q, are put in before.  `invariants` proves that they
are kept; they are conditions of a certificate.
"""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import replace
from typing import Any

import sympy
from sympy import Add, Expr, Mul, Poly, Pow, S

from ...engine.diagram.interconnection import Diagram
from ..algebra.slopes import along
from ..algebra.sums_of_squares import squares
from ..algebra.texts import short
from .answers import Definite, Fall
from .certified import NOTHING_PROVED, Case, NoCertificate, Term, written
from .proof import Proof
from .symbolic_loop import SymbolicLoop, symbolic_loop
from .ultimate_bounds import in_forms, pulled_at_once

Ways = list[Callable[[], Case]]


# --- sums of squares -----------------------------------------------------------------------------


def terms_of(expression: Expr, fixed: set) -> list[Term]:
    """Return an expression as a sum of terms that are not negative."""
    total = squares(expression, fixed)
    if total is None or not total.constant.is_nonnegative:
        raise NoCertificate(f"{short(expression)} is not known as a sum of squares")
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
            raise NoCertificate(f"{short(factor)} is no square")
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
        raise NoCertificate("V' does not pull all errors of V back")
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
            raise NoCertificate("certificates are of continuous time")
        motion = {s: rate.xreplace(fall.zeroed) for s, rate in case.motion.items()}
        functions = still(case.eq.jumps, case.V)
        V, sizes = terms_of(case.V, case.fixed), [case.sizes] * bool(case.sizes)
        return Case(motion, case.fixed, V, [], functions=functions, conditions=sizes)

    def falls() -> Case:
        return lost(system(), case.rate.xreplace(fall.zeroed))

    def pulls() -> Case:
        terms = in_forms(case, definite)
        if fall.level is None or terms is None:
            raise NoCertificate("V' does not pull V back")
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
        raise NoCertificate(f"{min(in_V, key=str)} is in V and jumps")
    return dict.fromkeys(moved, "signals")


# --- any diagram ------------------------------------------------------------------------------


def of_loop(
    diagram: Diagram, V: Callable[[SymbolicLoop], Expr], *conditions: str
) -> Ways:
    """Return the way to write V' of a diagram as minus a sum of squares."""

    def falls() -> Case:
        loop = symbolic_loop(diagram)
        level, fixed = V(loop), {*loop.values}
        case = Case(
            loop.motion, fixed, terms_of(level, fixed), [], conditions=[*conditions]
        )
        return lost(case, sympy.expand(along(level, loop.motion)))

    return [falls]


def without(reason: str) -> Ways:
    """Return no way to write V', for a reason."""

    def none() -> Case:
        raise NoCertificate(reason)

    return [none]


def with_certificates(
    prove: Callable[[], Proof], cases: Callable[[], Iterable[Ways]]
) -> Proof:
    """Return a proof with the certificates of its cases, such as N = 1, 2, 3, in a list."""
    proof = prove()
    if proof.status == "open":
        return replace(proof, why_no_certificate=NOTHING_PROVED)
    certified = [written(ways, []) for ways in cases()]
    reason = next((why for _, why in certified if why), "")
    certificates = None if reason else [data for data, _ in certified]
    return replace(proof, certificate=certificates, why_no_certificate=reason)
