"""An expression as a sum of terms that are not negative: the forms that a V contains.

    V = c + sum_k a_k f_k^2 + sum_i g_i(s_i)        a_k > 0,  g_i convex or rising away from 0

Forms f are taken as the user wrote them, or squares are completed, symbol by symbol.  V bounds
every form: where V does not rise, no f leaves a bound, but one of the kind sin(s/2), of 1 - cos(s).
"""

from typing import Any, NamedTuple

import sympy
from sympy.core.function import AppliedUndef

from ...engine.diagram.symbol_names import TIME
from .exact import factored, tidied, vanishes
from .facts import (
    CLIP,
    along,
    decided,
    functions_in,
    interval,
    is_input,
    meets_smoothly,
    sector_of,
)


class Squares(NamedTuple):
    """Terms that are not negative, and forms that are bounded where they are."""

    constant: sympy.Expr
    terms: list[sympy.Expr]
    forms: list[sympy.Expr]


def squares(V: sympy.Expr, fixed: set, words_are_free: bool = True) -> Squares | None:
    """Return an expression as a sum of terms that are not negative; None where none is known.

    Words with kinks stand for any number, or only those of time and not of states.
    """
    free = (f for f in V.atoms(AppliedUndef) if words_are_free or is_input(f))
    words = {f: sympy.Dummy(str(f.func), real=True) for f in free}
    back = {dummy: f for f, dummy in words.items()}
    inner = [f.args[0] for f in V.atoms(sympy.Function) if f.args[0].is_Add]
    sums = {
        a: sympy.Dummy("sum", real=True)
        for a in inner
        if len(a.free_symbols - fixed) > 1
    }
    back |= {dummy: a for a, dummy in sums.items()}
    V = V.xreplace(words).xreplace(sums)
    moving = sorted(V.free_symbols - fixed, key=str)
    form_of = dict[Any, Any]()  # term -> the form that it holds
    low, more = list[Any](), list[Any]()
    others = dict[frozenset, list]()
    parts = [sympy.expand_mul(one, deep=False) for one in sympy.Add.make_args(V)]
    for term in sympy.Add.make_args(sympy.Add(*parts)):
        factor, rest = term.as_independent(*moving, as_Add=False)
        base, power = rest.as_base_exp()
        if (
            _positive(factor)
            and power.is_Integer
            and power.is_even
            and power.is_positive
        ):
            form_of[term] = base
        elif rest.is_polynomial(*moving):
            low.append(term)
        elif term.is_nonnegative and len(rest.free_symbols & set(moving)) > 1:
            # it holds no form
            more.append(term)
        else:
            others.setdefault(frozenset(rest.free_symbols & set(moving)), []).append(
                term
            )
    for symbols, terms in others.items():
        if len(symbols) != 1:
            return None
        (s,) = symbols
        rising = _rising(sympy.Add(*terms), s)
        if rising is None:  # with all that s is in alone
            same = [term for term in low if term.free_symbols & set(moving) == {s}]
            terms, low = terms + same, [term for term in low if term not in same]
            rising = _rising(sympy.Add(*terms), s)
        if rising is None:
            return None
        low.append(rising[0])
        form_of[sympy.Add(*terms) - rising[0]] = rising[1]
    if any(term.free_symbols & set(moving) for term in low):
        # squares are completed with them
        plain = [term for term in form_of if term.is_polynomial(*moving)]
        low += plain
        form_of = {term: form for term, form in form_of.items() if term not in plain}
    whole = _completed(sympy.expand(sympy.Add(*low)), moving)
    if whole is None:
        return None
    both = [*form_of, *more, *whole.terms], [*form_of.values(), *whole.forms]
    return Squares(
        whole.constant, *([one.xreplace(back) for one in terms] for terms in both)
    )


def _completed(p: sympy.Expr, moving: list) -> Squares | None:
    """Complete the squares of a polynomial, in one order of its symbols or another."""
    symbols = [s for s in moving if p.has(s)]
    if not symbols:
        return Squares(p, [], [])
    poly = sympy.Poly(p, *symbols)
    if any(poly.degree(s) % 2 for s in symbols):  # which has no least value
        return None
    high = Squares(sympy.S.Zero, [], [])
    for powers, c in poly.terms():
        even, holds = any(powers) and not any(n % 2 for n in powers), _positive(c)
        if even and (holds or c.is_nonnegative) and (sum(powers) > 2 or not holds):
            root = sympy.Mul(
                *(s ** (n // 2) for s, n in zip(symbols, powers, strict=True))
            )
            high.terms.append(c * root**2)
            high.forms.extend([root.as_base_exp()[0]] * holds)
    for s in symbols:
        a, b, c = (p.coeff(s, n) for n in (2, 1, 0))
        if poly.degree(s) != 2 or a.has(*symbols) or not _positive(a):
            continue
        form = s + sympy.expand(b / (2 * a))
        below = c - b**2 / (4 * a)
        below = sympy.expand(below if a.is_number else sympy.cancel(below))
        rest = _completed(below, moving)
        if rest is not None:
            return Squares(
                rest.constant, [a * form**2, *rest.terms], [form, *rest.forms]
            )
        break
    if not high.terms:
        return None
    rest = _completed(sympy.expand(p - sympy.Add(*high.terms)), moving)
    if rest is None:
        return None
    return Squares(rest.constant, high.terms + rest.terms, high.forms + rest.forms)


def _positive(a: sympy.Expr) -> bool:
    """Return whether a factor is positive, and stays away from zero, which exp(-t) does not."""
    alone = not a.has(TIME) and (a.is_positive or factored(a).is_positive)
    return bool(alone or interval(a)[0].is_positive)


def _rising(g: sympy.Expr, s: sympy.Symbol) -> tuple[sympy.Expr, sympy.Expr] | None:
    """Return g(0), and a form that is zero where g - g(0) >= 0 is, of a function of one symbol."""
    least = decided(g.subs(s, 0))
    k, m = sympy.Wild("k", exclude=[s, 0]), sympy.Wild("m", exclude=[s, 0])
    cosine = g.match(-k * sympy.cos(m * s))
    if cosine is not None and cosine[k].is_positive:
        return least, sympy.sin(cosine[m] * s / 2)
    slope = along(g, {s: sympy.S.One})
    if least.is_finite and any(
        rising_in(one(s * slope), s) for one in (tidied, factored)
    ):
        return least, s
    if g.atoms(AppliedUndef) or g.has(TIME):
        return None
    bend = factored(sympy.diff(slope, s))
    bends = (
        least.is_finite
        and vanishes(slope.subs(s, 0))
        and bend != 0
        and bend.is_nonnegative
    )
    return (least, s) if bends else None  # so that g rises without bound


def rising_in(E: sympy.Expr, s: sympy.Symbol) -> bool:
    """Return whether s dV/ds is positive but at s = 0, and V has no end.

    Each term is an even power of s, or s h(s), times what is not negative; one of them rises, or
    is positive and has a limit far away that is: s dV/ds >= c > 0 there, and V >= c log|s|.
    """
    rises = False
    for term in sympy.Add.make_args(sympy.expand(E)):
        rest, strict, n = sympy.S.One, True, 0
        for factor in sympy.Mul.make_args(term):
            base, power = factor.as_base_exp()
            sector = sector_of(factor) if functions_in(factor) and power == 1 else None
            if base == s and power.is_Integer and power > 0:
                n += int(power)
            elif sector is not None and sector.factor == s and sector.low >= 0:
                n += 1
                strict &= sector.rises
            else:
                rest *= factor
        low = interval(rest)[0]
        if not low.is_extended_nonnegative or n % 2:
            return False
        sure = low.is_positive
        if rest.free_symbols == {s} and rest.is_positive and not functions_in(rest):
            # 1/(1 + s^2)
            far = (sympy.limit(term, s, end) for end in (-sympy.oo, sympy.oo))
            sure = sure or all(limit.is_extended_positive for limit in far)
        rises |= bool(n and strict and sure)
    return rises


def dead_zone(V: sympy.Expr, e: sympy.Symbol) -> tuple[sympy.Expr, sympy.Expr]:
    """Return d where V holds e as e - clip(e, -d, d) alone, and V with e in its place; else 0."""
    clips = [w for w in functions_in(V) if w.func == CLIP and w.args[0] == e]
    if len(clips) == 1 and clips[0].args[1] == -clips[0].args[2]:
        clip, D = clips[0], sympy.Dummy(real=True)
        inner = V.xreplace({e: D + clip}).xreplace(
            {CLIP(D + clip, *clip.args[1:]): clip}
        )
        inner = sympy.expand(inner)
        if not inner.has(clip) and clip.args[2].is_positive:
            return clip.args[2], inner.xreplace({D: e})
    return sympy.S.Zero, V


def least_place(V: sympy.Expr, states: list) -> dict[Any, sympy.Expr] | None:
    """Return where V is zero, if it is positive elsewhere and holds each state; else None."""
    if not meets_smoothly(V):
        return None
    total = squares(V, V.free_symbols - set(states), words_are_free=False)
    if total is None or not vanishes(total.constant) or not holds_all(total, states):
        return None
    linear = [f for f in total.forms if f.is_polynomial(*states)]
    linear = [f for f in linear if sympy.Poly(f, *states).is_linear]
    places = [*sympy.linsolve(linear, *states)]
    if not places:
        return None
    least = dict(zip(states, places[0], strict=True))
    return least if all(vanishes(f.xreplace(least)) for f in total.forms) else None


def holds_all(total: Squares, states: list) -> bool:
    """Return whether the linear forms of a sum of squares hold each state."""
    J = sympy.Matrix(total.forms).jacobian(states) if total.forms else sympy.Matrix()
    linear = [row for row in J.tolist() if all(slope.is_Rational for slope in row)]
    return sympy.Matrix(linear).rank() == len(states)
