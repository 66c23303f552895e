"""Forms that V' loses: q of V' <= -q^2, by squares, sectors, groups of terms and roots of states.

A loss is least at a bound of an input, or without functions such as e^(-t), if it is so for all
states.
"""

from collections.abc import Sequence
from itertools import islice, product
from typing import Any

import sympy
from sympy import Add, Dummy, Expr, Mul, S, Symbol, expand

from ...engine.diagram.symbol_names import TIME
from ..algebra.decided import decided
from ..algebra.exact import (
    as_factors,
    factored,
    groups_of,
    normal_form,
    vanishes,
    whole_coefficients,
)
from ..algebra.facts import SIGN, functions_in, has_time, inputs_in, sector_of
from ..algebra.slopes import in_known_pieces, slope_in
from ..algebra.sums_of_squares import alone_in_groups, lost_forms
from ..algebra.texts import outward
from .outside import ANGLES
from .relations import in_errors
from .where import MOST_CORNERS

LEAST = 1e-6  # share of an exponent near 1, which rounding of numbers changes


def forms_lost(case: Any, bound: Expr, bounded: set) -> Sequence[Expr]:
    """Return forms of whose squares V', at most a bound, loses multiples; or the loss itself.

    Of a loss under an input, and in discrete time, the integral or the sum is finite, though no
    form is known.
    """
    loss = -whole_coefficients(normal_form(bound), (*case.states, *case.inputs))
    ends = {d: [e for e in case.where.box[d] if e.is_finite] for d in case.where.box}
    fading = (e for e in expand(loss).atoms(sympy.exp) if e.free_symbols == {TIME})
    ends |= {e: [S.Zero] for e in fading}
    for corner in islice(product(*ends.values()), MOST_CORNERS):
        least = decided(expand(loss).xreplace(dict(zip(ends, corner, strict=True))))
        if case.never_positive(least - loss):
            loss = least
            break
    losses: Sequence[Expr] = lost_forms(loss, case.fixed, bounded)
    # squares as they are written
    if not losses and (case.claim is not None or not bound.has(TIME)):
        losses = lost_forms(-bound, case.fixed, bounded)
    losses = losses or _lost_by_groups(case, loss, bounded) or _rising(case, loss)
    losses = losses or _lost_by_states(case, bound)
    if case.where.kept and not losses:
        roots = case.where.roots.items()
        bounded = bounded | {root for root, e in roots if e.free_symbols & bounded}
        of_roots = lost_forms(loss.xreplace(case.where.squared), case.fixed, bounded)
        losses = case.where.in_states(of_roots)
    is_summed = inputs_in(loss) or (case.eq.discrete and loss != 0)
    return losses or [factored(loss)] * bool(is_summed and not has_time(loss))


def lost_slowly(case: Any, bound: Expr) -> Sequence[Expr]:
    """Return forms of W in V' <= -f(t) W, where f, never negative, has no finite integral.

    Then V - V(0) is below -W int f dt, so no run stays where W is above a positive number.
    """
    factors = Mul.make_args(factored(normal_form(-bound)))
    f = Mul(*(e for e in factors if e.free_symbols <= {TIME} and not inputs_in(e)))
    is_slow = not case.eq.discrete and _has_no_integral(f)
    return lost_forms(Mul(*factors) / f, case.fixed, set()) if is_slow else []


def excess_over(rate: Expr, claim: Expr) -> Expr:
    """Return what V' has above a claim."""
    excess = normal_form(rate - claim)
    powers = excess.atoms(sympy.Pow)
    divisors = [p.base for p in powers if p.exp.is_negative]
    if sympy.Tuple(*divisors).has(TIME):  # gains of time, which may cancel
        excess = as_factors(excess)
    signed = {a: a.args[0] * SIGN(*a.args) for a in excess.atoms(sympy.Abs)}
    is_zero = powers and vanishes(excess.xreplace(signed))
    return S.Zero if is_zero else excess


def decay_and_end(case: Any, bound: Expr) -> tuple[Expr | None, Expr | None]:
    """Return V(0) e^(-k t) of V' <= -k V, and the time after which V is 0; None for neither."""
    powers = {} if case.eq.discrete else powers_lost(case, bound)
    k, start = powers.pop(S.One, None), Symbol("V(0)", positive=True)
    decay = end = None
    if k is not None:
        shares = map(case.in_signals, sympy.Min.make_args(k))
        k = sympy.Min(*map(factored, shares))
        k = outward(k, up=False, keeps_short=True) if k.is_number else k
        decay = start * sympy.exp(-k * TIME)
    if powers and not case.eq.jumps:
        ((q, k), *_) = powers.items()
        end = case.in_signals(start ** (1 - q) / (k * (1 - q)))
        end = outward(end, keeps_short=True)
    return decay, end


def powers_lost(case: Any, bound: Expr) -> dict[Expr, Expr]:
    """Return q -> k of V' <= -k V^q, 0 < q <= 1, as V = sum a |s|^p loses b |s|^(p q).

    V^q is at most the sum of the powers q of its terms.  q = 1 only if all terms have one power p,
    so that V is between powers of the distance.
    """
    corners = (-rate for _, rate in case.where.corners(bound))
    in_errors = case.errors[0] or {s: s + rest for s, rest in case.origin.items()}
    V, *losses = (normal_form(e.xreplace(in_errors)) for e in (case.V, *corners))
    states, size = V.free_symbols - case.fixed, Dummy(positive=True)
    if V.has(TIME) or decided(V.xreplace(dict.fromkeys(states, S.Zero))) != 0:
        return {}

    def is_of_one(term: Expr) -> bool:
        """Return whether a term of a loss has one state, or may be negative."""
        return len(term.free_symbols & states) < 2 or not term.is_nonnegative

    losses = [Add(*filter(is_of_one, Add.make_args(loss))) for loss in losses]
    sizes = set[Expr]()  # p
    shares = list[dict[Expr, Expr]]()  # q -> k
    for s, loss, side in product(states, losses, (size, -size)):
        of_s = [g for e in (V, loss) for g in groups_of(e, states) if g.has(s)]
        sized = (e.xreplace({s: side}) for e in of_s)
        known = (in_known_pieces(e, lambda margin: margin.is_positive) for e in sized)
        found = [sympy.collect(expand(e), size, evaluate=False) for e in known]
        parts = [
            (n.as_coeff_exponent(size)[1], b) for of in found for n, b in of.items()
        ]
        is_known = all(
            b.is_nonnegative and not b.free_symbols - case.fixed for _, b in parts
        )
        if len(found[0]) != 1 or not is_known:
            return {}
        (p, a), *lost = parts
        sizes.add(p)
        shares.append({n / p: b / a ** (n / p) for n, b in lost})
    powers = set[Expr].intersection(*map(set, shares)) if shares else ()
    slowest = {q: sympy.Min(*(share[q] for share in shares)) for q in powers}
    if len(sizes) > 1:
        slowest.pop(S.One, None)
    return {q: k for q, k in slowest.items() if q == 1 or (q > 0 and 1 - q > LEAST)}


def _has_no_integral(f: Expr) -> bool:
    """Return whether f >= 0 is a polynomial in waves, or a fraction that falls at most as 1/t."""
    waves = {w: Dummy() for w in f.atoms(*ANGLES) if w.args[0].diff(TIME).is_number}
    of_waves = f.xreplace(waves)
    if waves:  # almost periodic: its mean is positive
        return bool(of_waves.is_polynomial(*waves.values()) and not of_waves.has(TIME))
    is_fraction = bool(f.is_rational_function(TIME))
    return is_fraction and sympy.limit(TIME * f, TIME, sympy.oo) != 0


def _rising(case: Any, loss: Expr) -> list[Expr]:
    """Return s of odd rising functions h, V' <= -s h(s)/2: of 2 s clip(s) - clip(s)^2."""
    return [
        sector.factor
        for call in sorted(functions_in(loss), key=str)
        if (sector := sector_of(call))
        and sector.rises
        and sector.low >= 0
        and case.never_positive(sector.factor * call / 2 - loss)
    ]


def _lost_by_states(case: Any, bound: Expr) -> list[Expr]:
    """Return the forms of -dV/dx_i x_i', each never negative: of a gradient flow dV/dx_i."""
    if bound != case.rate or case.eq.discrete or case.V.has(TIME):
        return []
    terms = [
        factored(normal_form(-rate * slope_in(case.V, s)))
        for s, rate in case.motion.items()
    ]
    forms = [lost_forms(term, case.fixed, set()) for term in terms if term != 0]
    is_known = [] not in forms and all(case.never_positive(-term) for term in terms)
    return [q for of_term in forms for q in of_term] if is_known else []


def _lost_by_groups(case: Any, loss: Expr, bounded: set) -> list[Expr]:
    """Return the forms that groups of terms lose, of a loss as it is or in errors."""
    found = list[Expr]()
    for e, forms in in_errors(case, loss):
        zero = case.origin | dict.fromkeys(forms, S.Zero)
        if not (found or e.has(*case.where.kept)):
            groups, known = alone_in_groups(e, zero), {*bounded, *forms}
            lost = (
                lost_forms(group, case.fixed, known) or _rising(case, group)
                for group in groups
            )
            found = [q.xreplace(forms) for of_group in lost for q in of_group]
    return found
