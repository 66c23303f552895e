"""Sums of squares: an expression as a sum of terms that are never negative.

    V = c + sum_k a_k f_k^2 + sum_i g_i(s_i)        a_k > 0,  g_i convex or rising away from 0

Forms f are taken as the user wrote them, or squares are completed, symbol by symbol.  V bounds
every form: where V does not rise, no f leaves a bound, except one such as sin(s/2), of 1 - cos(s).
"""

from collections.abc import Iterator, Mapping, Sequence
from typing import Any, NamedTuple

import sympy
from sympy import (
    Abs,
    Add,
    Dummy,
    Expr,
    Matrix,
    Mul,
    Poly,
    S,
    Symbol,
    cancel,
    diff,
    expand,
    oo,
)
from sympy.core.function import AppliedUndef

from ...engine.diagram.symbol_names import TIME
from .decided import decided
from .exact import factored, groups_of, normal_form, vanishes
from .facts import (
    CLIP,
    WHERE,
    functions_in,
    interval,
    is_input,
    sector_of,
    side_of,
    stays_off_zero,
)
from .gram import sum_of_squares
from .slopes import of_same_sign, slope_in


class Squares(NamedTuple):
    """Terms that are never negative, and forms that are bounded where the terms are."""

    constant: Expr
    terms: list[Expr]
    forms: list[Expr]


class SortedTerms(NamedTuple):
    """Terms of an expression by what is known of them."""

    form_of: dict[Any, Any]  # positive multiple of an even power -> its base
    polynomial: list[Any]
    nonnegative: list[Any]  # without a form of their own
    functions: dict[frozenset, list]  # symbols -> terms with functions of them
    forms: list[Any]  # that bound them


def squares(V: Expr, fixed: set, functions_are_free: bool = True) -> Squares | None:
    """Return an expression as a sum of terms that are never negative; None if none is known.

    Functions with kinks may have any value, or only those of time and not of states.
    """
    V, original = _with_symbols(V, fixed, functions_are_free)
    variables = sorted(V.free_symbols - fixed - {TIME}, key=str)
    sorted_terms = _sorted_terms(V, variables)
    form_of, polynomial, nonnegative, functions, sizes = sorted_terms
    # functions of one symbol: their least value, and a form
    for symbols, terms in functions.items():
        if len(symbols) != 1:
            return None
        (s,) = symbols
        minimum = _minimum(Add(*terms), s)
        if minimum is None:  # with all terms in s alone
            alone = [t for t in polynomial if t.free_symbols & {*variables} == {s}]
            terms = terms + alone
            polynomial = [t for t in polynomial if t not in alone]
            minimum = _minimum(Add(*terms), s)
        if minimum is None:
            return None
        least, form = minimum
        polynomial.append(least)
        form_of[Add(*terms) - least] = form
    # other polynomials: squares are completed, together with the squares that there are
    if any(term.free_symbols & {*variables} for term in polynomial):
        plain = [term for term in form_of if term.is_polynomial(*variables)]
        polynomial += plain
        form_of = {t: form for t, form in form_of.items() if t not in plain}
    rest = expand(Add(*polynomial))
    completed = _completed(rest, variables) or _of_gram(rest, variables)
    if completed is None or _sinks(completed.constant):
        return None
    terms = [*form_of, *nonnegative, *completed.terms]
    forms = [*form_of.values(), *sizes, *completed.forms]
    return Squares(
        completed.constant,
        [term.xreplace(original) for term in terms],
        [form.xreplace(original) for form in forms],
    )


def _sinks(constant: Expr) -> bool:
    """Return whether a constant may fall without end as time goes on."""
    return constant.has(TIME) and not interval(constant)[0].is_finite


def _with_symbols(V: Expr, fixed: set, functions_are_free: bool) -> tuple[Expr, dict]:
    """Replace functions, and sums of variables in functions, by symbols; return the inverse."""
    calls = [f for f in V.atoms(AppliedUndef) if functions_are_free or is_input(f)]
    symbols = {f: Dummy(str(f.func), real=True) for f in calls}
    arguments = [f.args[0] for f in V.atoms(sympy.Function)]
    sums = {
        a: Dummy("sum", real=True)
        for a in arguments
        if a.is_Add and len(a.free_symbols - fixed) > 1
    }
    original = {symbol: e for e, symbol in (symbols | sums).items()}
    return V.xreplace(symbols).xreplace(sums), original


def _sorted_terms(V: Expr, variables: list) -> SortedTerms:
    """Sort the terms of an expression."""
    terms = SortedTerms({}, [], [], {}, [])
    summands = Add.make_args(V)
    expanded = [sympy.expand_mul(summand, deep=False) for summand in summands]
    for term in Add.make_args(Add(*expanded)):
        coefficient, varying = term.as_independent(*variables, as_Add=False)
        base, power = varying.as_base_exp()
        symbols = frozenset(varying.free_symbols & {*variables})
        is_square = power.is_Integer and power.is_even and power.is_positive
        if is_square and _is_positive(coefficient):
            terms.form_of[term] = base
        elif varying.is_polynomial(*variables):
            terms.polynomial.append(term)
        elif (
            len(symbols) > 1
            and (sizes := _sizes(varying))
            and _is_positive(coefficient)
        ):
            terms.nonnegative.append(term)
            terms.forms.extend(sizes)
        elif term.is_nonnegative and len(symbols) > 1:
            terms.nonnegative.append(term)
        else:
            terms.functions.setdefault(symbols, []).append(term)
    return terms


def _completed(p: Expr, variables: list) -> Squares | None:
    """Complete the squares of a polynomial, in the order of its symbols."""
    symbols = [s for s in variables if p.has(s)]
    if not symbols:
        return Squares(p, [], [])
    polynomial = Poly(p, *symbols)
    if any(polynomial.degree(s) % 2 for s in symbols):  # no least value
        return None
    for s in symbols:
        n = polynomial.degree(s) // 2  # 2: a s^4 + b s^2 + c, b < 0
        a, b, c = (p.coeff(s, power) for power in (2 * n, n, 0))
        has_others = n == 2 and (
            not b.is_negative or expand(p - a * s**4 - b * s**2 - c) != 0
        )
        if n not in (1, 2) or has_others or a.has(*symbols) or not _is_positive(a):
            continue
        form = s**n + expand(b / (2 * a))
        remainder = c - b**2 / (4 * a)
        remainder = remainder if a.is_number else cancel(remainder)
        square = Squares(S.Zero, [a * form**2], [form])
        completed = _added(square, expand(remainder), variables)
        if completed is not None:
            return completed
        break
    powers = _even_powers(polynomial)
    remainder = expand(p - Add(*powers.terms))
    return _added(powers, remainder, variables) if powers.terms else None


def _sizes(e: Expr) -> list[Expr]:
    """Return forms that are bounded where max(|a|, |b|), |a|^p or a sum of such is; or none."""
    if isinstance(e, Abs):
        return [e.args[0]]
    if e.is_Pow and e.exp.is_positive:
        return [e.base] if e.exp.is_even else _sizes(e.base)
    if e.is_Add or e.func.__name__ == "maximum":
        inner = [_sizes(a) for a in e.args]
        return [form for forms in inner for form in forms] if all(inner) else []
    return []


def _of_gram(p: Expr, variables: list) -> Squares | None:
    """Write a polynomial without symbols of parameters as a sum of squares by a Gram matrix."""
    constant = p.xreplace(dict.fromkeys(variables, S.Zero))
    for low in dict.fromkeys((constant, S.Zero)) if constant.is_number else ():
        if (total := sum_of_squares(p - low)) and (total.forms or low != constant):
            terms = [w * form**2 for w, _, form in total.terms]
            return Squares(
                low, terms, total.forms or [form for *_, form in total.terms]
            )
    return None


def _added(total: Squares, remainder: Expr, variables: list) -> Squares | None:
    """Add the completed squares of a remainder to squares."""
    completed = _completed(remainder, variables)
    if completed is None:
        return None
    return Squares(
        completed.constant, total.terms + completed.terms, total.forms + completed.forms
    )


def _even_powers(polynomial: Poly) -> Squares:
    """Return the terms with even powers, except positive multiples of squares."""
    powers = Squares(S.Zero, [], [])
    for exponents, coefficient in polynomial.terms():
        is_even = any(exponents) and not any(n % 2 for n in exponents)
        is_positive = _is_positive(coefficient)
        if not is_even or not (is_positive or coefficient.is_nonnegative):
            continue
        if is_positive and sum(exponents) <= 2:
            continue
        pairs = zip(polynomial.gens, exponents, strict=True)
        root = Mul(*(s ** (n // 2) for s, n in pairs))
        powers.terms.append(coefficient * root**2)
        if is_positive:
            powers.forms.append(root.as_base_exp()[0])
    return powers


def _is_positive(a: Expr) -> bool:
    """Return whether a factor stays above a positive number, as exp(-t) does not."""
    is_constant = not a.has(TIME)
    if is_constant and (a.is_positive or factored(a).is_positive):
        return True
    return bool(interval(a)[0].is_positive)


def _minimum(g: Expr, s: Symbol) -> tuple[Expr, Expr] | None:
    """Return g(0), and a form that is zero where g - g(0) >= 0 is, of a function of one symbol."""
    least = decided(g.subs(s, 0))
    k, m = sympy.Wild("k", exclude=[s, 0]), sympy.Wild("m", exclude=[s, 0])
    cosine = g.match(-k * sympy.cos(m * s))
    if cosine is not None and cosine[k].is_positive:
        return least, sympy.sin(cosine[m] * s / 2)
    if not least.is_finite:
        return None
    slope = slope_in(g, s)
    if any(rising_in(form(s * slope), s) for form in (normal_form, factored)):
        return least, s
    if g.atoms(AppliedUndef) or g.has(TIME):
        return None
    curvature = factored(diff(slope, s))
    is_convex = curvature != 0 and curvature.is_nonnegative
    # convex and level at 0, g rises without bound
    return (least, s) if is_convex and vanishes(slope.subs(s, 0)) else None


def rising_in(E: Expr, s: Symbol) -> bool:
    """Return whether E = s dV/ds is positive except at s = 0, and V is unbounded.

    Each term is an even power of s, or s h(s), times a factor that is not negative.  One term
    rises, or is positive with a positive limit far away: s dV/ds >= c > 0 and V >= c log|s|.
    """
    rises = False
    choices = [f for f in functions_in(E) if f.func == WHERE and f.has(s)]
    if choices:  # in each of its branches
        branches = (expand(E.xreplace({choices[0]: b})) for b in choices[0].args[1:])
        return all(rising_in(branch, s) for branch in branches)
    for term in Add.make_args(expand(E)):
        power, factor, is_strict = _power_in(term, s)
        low = interval(factor)[0]
        if not low.is_extended_nonnegative or power % 2:
            return False
        if power and is_strict:
            is_positive = low.is_positive or (
                _is_positive(factor) and not factor.has(s)
            )
            rises |= is_positive or _has_positive_limits(term, factor, s)
    return rises


def _power_in(term: Expr, s: Symbol) -> tuple[int, Expr, bool]:
    """Return n, f and whether h rises, of a term s^n f, where odd functions h count as s."""
    power, factor, is_strict = 0, S.One, True
    for part in Mul.make_args(term):
        base, exponent = part.as_base_exp()
        is_function = functions_in(part) and exponent == 1
        sector = sector_of(part) if is_function else None
        if base == s and exponent.is_Integer and exponent > 0:
            power += int(exponent)
        elif base == Abs(s) and exponent.is_positive:
            power += 2
        elif sector is not None and sector.factor == s and sector.low >= 0:
            power += 1
            is_strict &= sector.rises
        else:
            factor *= part
    return power, factor, is_strict


def _has_positive_limits(term: Expr, factor: Expr, s: Symbol) -> bool:
    """Return whether a term is positive far away, as s^2/(1 + s^2) is."""
    functions = functions_in(factor) - {Abs(s)}
    if factor.free_symbols != {s} or functions or not factor.is_positive:
        return False
    limits = (sympy.limit(term, s, end) for end in (-oo, oo))
    return all(limit.is_extended_positive for limit in limits)


def lost_forms(loss: Expr, fixed: set, bounded: set) -> list[Expr]:
    """Return forms that are zero where an expression that is never negative is.

    It is a sum of squares of them, each with a weight that stays above a positive number, or a sum
    of products such as s tanh(s)/(1 + r^2), r `bounded`; none where neither is known.
    """
    for call in functions_in(loss):
        if (s := side_of(call)) is not None:
            loss = expand(loss).subs(s * call, call**2)
    p, q = sympy.fraction(sympy.together(loss))
    if q.has(*bounded) and _has_ends(q, fixed | bounded):
        loss = expand(p)
    total, product = squares(loss, fixed), factored(loss)
    found = [total.forms if total and total.constant.is_nonnegative else []]
    for e in (product, loss, sympy.expand_mul(product)):
        forms = [_lost_form(term, fixed, bounded) for term in Add.make_args(e)]
        found.append([] if None in forms else [form for form in forms if form != 0])
    most = max(found, key=len)
    return [*dict.fromkeys(map(_without_weights, most))]


def alone_in_groups(loss: Expr, rest: Mapping[Any, Expr]) -> Iterator[Expr]:
    """Yield the groups of terms that share no state.

    If the loss is 0 at the rest, each group is the loss with the other states at the rest, and so
    never negative.
    """
    if vanishes(decided(loss.xreplace(rest))):
        for group in groups_of(loss, {*rest}):
            others = {s: value for s, value in rest.items() if not group.has(s)}
            yield decided(loss.xreplace(others))


def _without_weights(form: Expr) -> Expr:
    """Return a form without the factors that stay away from zero."""
    kept = [f for f in Mul.make_args(form) if not stays_off_zero(f)]
    return Mul(*kept) if kept else form


def _lost_form(term: Expr, fixed: set, bounded: set) -> Expr | None:
    """Return a form of a term that is never negative, 0 for none; None if it may be negative."""
    form, weight = S.One, S.One
    for factor in Mul.make_args(Mul(*map(of_same_sign, Mul.make_args(term)))):
        base, power = factor.as_base_exp()
        is_size = isinstance(base, Abs)
        if power.is_positive and (is_size or power.is_even):
            form *= base.args[0] if is_size else base
        else:
            weight *= factor
    low = interval(weight)[0]
    if low.is_positive or _has_ends(weight, fixed | bounded):
        return form
    return S.Zero if low.is_extended_nonnegative else None


def _has_ends(weight: Expr, bounded: set) -> bool:
    """Return whether a weight of what is bounded, and of nothing else, is positive."""
    is_known = weight.free_symbols <= bounded and not weight.atoms(AppliedUndef)
    return bool(is_known and weight.is_positive)


def split_dead_zone(V: Expr, e: Symbol) -> tuple[Expr, Expr]:
    """Return d if V contains e only as e - clip(e, -d, d), and V of that; otherwise 0 and V."""
    calls = functions_in(V)
    clips = [call for call in calls if call.func == CLIP and call.args[0] == e]
    if len(clips) != 1:
        return S.Zero, V
    (clip,) = clips
    _, low, high = clip.args
    if low != -high or not high.is_positive:
        return S.Zero, V
    excess = Dummy(real=True)
    shifted = V.xreplace({e: excess + clip})
    shifted = shifted.xreplace({CLIP(excess + clip, low, high): clip})
    shifted = expand(shifted)
    if shifted.has(clip):
        return S.Zero, V
    return high, shifted.xreplace({excess: e})


def written_forms(e: Expr, fixed: set) -> list[Expr]:
    """Return an expression as it is, factored, and as minus a sum of squares if it is one."""
    total = squares(-e, fixed)
    forms = [e, factored(e)]
    if total and not total.constant.free_symbols - fixed:
        terms = (-sympy.factor_terms(term) for term in total.terms)
        forms.append(Add(*terms) - total.constant)
    return forms


def zero_of(total: Squares, states: list) -> dict[Any, Expr] | None:
    """Return the one point at which all forms are zero; None if there is none, or are more.

    Forms linear in the states that are left give some of them, which make others linear.
    """
    zero = dict[Any, Expr]()
    while left := [s for s in states if s not in zero]:
        forms = [expand(decided(form.xreplace(zero))) for form in total.forms]
        linear = [form for form in forms if _is_linear(form, left)]
        for solution in sympy.linsolve(linear, *left):
            pairs = zip(left, solution, strict=True)
            zero |= {s: v for s, v in pairs if not v.free_symbols & {*left}}
        if left == [s for s in states if s not in zero]:
            return None
    return zero if all(vanishes(form.xreplace(zero)) for form in total.forms) else None


def simplest(forms: Sequence[Expr], fixed: set) -> list[Expr]:
    """Return forms that span the same, the linear ones by elimination, if these are shorter.

    Each pivot is a number, or an expression of parameters, that is not zero.
    """
    inputs = {f: Dummy(f"{f.func}") for e in forms for f in e.atoms(AppliedUndef)}
    written = {e: e.xreplace(inputs) for e in forms}
    signals = sorted(sympy.Tuple(*written.values()).free_symbols - fixed, key=str)
    linear = [e for e in forms if _is_affine(written[e], signals)]
    rows = [Poly(written[e], *signals) for e in linear]
    weights = [row.coeff_monomial(s) for row in rows for s in (*signals, 1)]
    M = Matrix(len(rows), len(signals) + 1, weights)
    reduced, pivots = M.rref(simplify=cancel)
    kept = M.extract([*range(M.rows)], pivots)
    is_known = len(signals) not in pivots and (kept.T * kept).det().is_nonzero
    back = {s: f for f, s in inputs.items()}
    shorter = [e.xreplace(back) for e in reduced * Matrix([*signals, 1]) if e != 0]
    sizes = [sum(map(sympy.count_ops, of)) for of in (shorter, linear)]
    if not (is_known and rows[1:]) or sizes[0] >= sizes[1]:
        return [*forms]
    return shorter + [e for e in forms if e not in linear]


def _is_affine(form: Expr, signals: list) -> bool:
    """Return whether a form is linear in signals but for a number, with constant weights."""
    is_known = TIME not in signals or not form.has(TIME)
    return is_known and form.is_polynomial(*signals) and Poly(form, *signals).is_linear


def _is_linear(form: Expr, states: list) -> bool:
    """Return whether a form is linear in states, with numbers, or in one, and not zero."""
    if not form.is_polynomial(*states) or not Poly(form, *states).is_linear:
        return False
    slopes = [slope for s in states if (slope := diff(form, s)) != 0]
    alone = len(slopes) == 1 and slopes[0].is_nonzero
    return bool(alone or all(slope.is_Rational for slope in slopes))
