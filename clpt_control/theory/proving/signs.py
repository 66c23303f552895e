"""What is known of an expression: whether it is zero, or never positive.

An expression is zero if as one fraction p/q, of polynomials over the rationals in its symbols and
words, p = 0 and q is not.  Roots and rounded numbers are left to SymPy's own rules.  An expression
is never positive where it factors into squares with a minus, or is -s^T M s with M >= 0.

With words in it an expression is examined in the words' sectors, else piece by piece (`words`): of
each it is asked everywhere.
"""

from functools import lru_cache
from itertools import combinations
from math import comb, prod
from typing import Any

import sympy
from sympy.core.function import AppliedUndef
from sympy.polys.polyconfig import using
from sympy.polys.rings import PolyElement, PolyRing

from ...errors import DiagramError
from .facts import CLIP, INSIDE, decided, functions_in, interval, pieces_of, sector_of
from .proof import short


@lru_cache(maxsize=1000)  # much is the same for each N
def vanishes(expression: Any) -> bool:
    """Return whether an expression is zero; one that divides by zero is not."""
    expression = sympy.sympify(expression)
    p, q = _fraction(expression)
    parts = p.ring.symbols
    if (
        p == 0
        or q == 0
        or all(isinstance(part, sympy.Symbol | AppliedUndef) for part in parts)
    ):
        return p == 0 and q != 0
    p, q = map(sympy.expand, sympy.fraction(sympy.together(expression)))
    return p == 0 and q != 0


MOST_PLACES = 20  # of three, one in five polynomials of nine words had bad ones alone


@lru_cache(maxsize=1000)
def as_factors(expression: sympy.Expr) -> sympy.Expr:
    """Return an expression as one fraction of factors."""
    p, q = _fraction(expression)
    return _product(p.as_expr()) / _product(q.as_expr())


def _product(expression: sympy.Expr) -> sympy.Expr:
    """Return an expression factored.

    SymPy lifts factors from random places; from a bad one of a few it does not come back.
    """
    with using(EEZ_NUMBER_OF_CONFIGS=MOST_PLACES):
        return sympy.factor(expression)


def left_over(residual: Any) -> str:
    """Return a residual that should be zero, in words; "" where it is."""
    return "" if vanishes(residual) else f"left over: {short(sympy.expand(residual))}"


def _parts(expression: sympy.Expr) -> set[sympy.Expr]:
    """Return what an expression is a fraction of polynomials in."""
    if expression.is_Add or expression.is_Mul:
        return set().union(*map(_parts, expression.args))
    if expression.is_Pow and expression.exp.is_Integer:
        return _parts(expression.base)
    return set() if expression.is_Rational else {expression}


def _fraction(expression: sympy.Expr) -> tuple[PolyElement, PolyElement]:
    """Return p and q of an expression p/q; SymPy's own field takes much longer, with divisors."""
    ring = PolyRing([*_parts(expression)], sympy.ZZ)
    known = {
        part: (own, ring.one) for part, own in zip(ring.symbols, ring.gens, strict=True)
    }

    def fraction(e: sympy.Expr) -> tuple[PolyElement, PolyElement]:
        if e not in known:
            known[e] = multiplied(e)
        return known[e]

    def multiplied(e: sympy.Expr) -> tuple[PolyElement, PolyElement]:
        if e.is_Rational:
            return ring.ground_new(e.p), ring.ground_new(e.q)
        if e.is_Pow:
            p, q = fraction(e.base)[:: 1 if e.exp > 0 else -1]
            return p ** abs(int(e.exp)), q ** abs(int(e.exp))
        parts = [fraction(one) for one in e.args]
        if e.is_Mul:
            return ring.mul(*(p for p, _ in parts)), ring.mul(*(q for _, q in parts))
        numerators: dict[PolyElement, list[PolyElement]] = {}  # by their denominator
        for p, q in parts:
            numerators.setdefault(q, []).append(p)
        p, q = ring.zero, ring.one
        for other, shares in numerators.items():
            p, q = p * other + ring.add(*shares) * q, q * other
        return p, q

    return fraction(expression)


MOST_TERMS = 20_000  # more are not multiplied out
MOST_EXAMINED = 400  # of more no sign is known
HIGHEST = 4  # higher powers are not factored
FEW = 12  # terms; more with words in them are not factored
MOST_FACTORED, LARGEST = 40, 10  # terms; numbers in an exponent of e
WHOLE = 100  # higher powers stay as they are
MOST_WORDS = 8  # that are examined together

# 1 - sin^2, 1 + sinh^2
EVEN = {sympy.cos: (sympy.sin, -1), sympy.cosh: (sympy.sinh, 1)}


@lru_cache(maxsize=1000)
def tidied(expression: sympy.Expr) -> sympy.Expr:
    """Return an expression multiplied out, cos^2 as 1 - sin^2, cosh^2 as 1 + sinh^2.

    An angle's sums and multiples are written out only where others share its symbols: of sin(3 t)
    alone more is known than of 3 sin(t) - 4 sin(t)^3.
    """
    if terms_of(expression) > MOST_TERMS:
        raise DiagramError(
            f"V' has more than {MOST_TERMS} terms; make the law or its N smaller"
        )
    masked = {
        e: sympy.Dummy(str(e), positive=True) for e in expression.atoms(sympy.exp)
    }
    if masked and not any(e.args[0].atoms(sympy.exp) for e in masked):
        # else in its denominators
        plain = tidied(expression.xreplace(masked)).xreplace(
            {d: e for e, d in masked.items()}
        )
        return sympy.expand(plain, deep=False, power_exp=False)
    angles = {
        p.base.args[0]
        for p in expression.atoms(sympy.Pow)
        if isinstance(p.base, sympy.cosh)
    }
    if angles:  # sinh/cosh, as of log(cosh)
        tanh = {sympy.sinh(a): sympy.tanh(a) * sympy.cosh(a) for a in angles}
        expression = sympy.expand(expression.xreplace(tanh))
    known = dict[sympy.Expr, sympy.Expr]()
    high = {p.base for p in high_powers(expression)}
    for even, (odd, _) in EVEN.items():
        turns = expression.atoms(even, odd) - high
        angles = {one.args[0] for one in turns}
        known |= {
            one: sympy.expand_trig(one) for one in turns if _meets(one.args[0], angles)
        }
    expression = sympy.expand(expression.xreplace(known))
    for within in expression.atoms(INSIDE):  # where clip(s, a, b) is s
        ends = {at: expression.xreplace({within: sympy.Integer(at)}) for at in (0, 1)}
        inside = (ends[1] - ends[0]).xreplace({CLIP(*within.args): within.args[0]})
        expression = sympy.expand(ends[0] + within * inside)
    for p in expression.atoms(sympy.Pow):
        if (
            p.base.func in EVEN
            and p.exp.is_Integer
            and p.exp != -1
            and p.base not in high
        ):
            odd, sign = EVEN[p.base.func]
            square = 1 + sign * odd(*p.base.args) ** 2
            known[p] = square ** (p.exp // 2) * p.base ** (p.exp % 2)
    return sympy.expand(expression.xreplace(known))


def high_powers(expression: sympy.Expr) -> set[sympy.Expr]:
    """Return the powers that stay as they are, and exp(1000 x): SymPy has it as exp(x)**1000."""
    powers = {
        p
        for p in expression.atoms(sympy.Pow)
        if p.exp.is_Integer and abs(p.exp) > WHOLE
    }
    for e in expression.atoms(sympy.exp):
        if any(max(abs(n.p), n.q) > LARGEST for n in e.args[0].atoms(sympy.Rational)):
            powers.add(e)
    return powers


def _meets(angle: sympy.Expr, others: set[sympy.Expr]) -> bool:
    """Return whether sums and low multiples in an angle may cancel what others of them make."""
    low = all(abs(n) <= HIGHEST for n in angle.atoms(sympy.Integer))
    apart = others - {angle, -angle}
    return low and any(angle.free_symbols & other.free_symbols for other in apart)


def factored(expression: sympy.Expr, most: int = MOST_FACTORED) -> sympy.Expr:
    """Return an expression factored, or as it is where it has many terms or operations."""
    if len(sympy.Add.make_args(expression)) > most or expression.count_ops() > 5 * most:
        return expression
    whole = {
        e: sympy.Dummy(
            str(e), positive=e.is_positive or None, nonnegative=e.is_nonnegative or None
        )
        for e in high_powers(expression)
    }
    return _product(expression.xreplace(whole)).xreplace(
        {dummy: e for e, dummy in whole.items()}
    )


def terms_of(expression: sympy.Expr) -> int:
    """Return how many terms there are at most, multiplied out."""
    if expression.is_Add:
        return sum(map(terms_of, expression.args))
    if expression.is_Mul:
        return prod(map(terms_of, expression.args))
    if expression.is_Pow and expression.exp.is_Integer and expression.base.is_Add:
        n, m = terms_of(expression.base), abs(int(expression.exp))
        return comb(n + m - 1, m)
    return 1


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


def nonpositive(expression: sympy.Expr, apart: set, by: set | None = None) -> bool:
    """Return whether an expression is known never to be positive.

    Terms that share no symbol of `apart`, the states and truths, or of `by`, are examined apart.
    """
    groups = groups_of(expression, apart if by is None else by)
    return all(_negative(group, apart) for group in groups)


def groups_of(expression: sympy.Expr, apart: set) -> list[sympy.Expr]:
    """Return an expression as a sum of expressions that share no symbol of `apart`."""
    groups: list[tuple[set, list]] = []
    for term in sympy.Add.make_args(sympy.expand(expression, power_exp=False)):
        symbols, terms = term.free_symbols & apart, [term]
        touching = [group for group in groups if group[0] & symbols]
        groups = [group for group in groups if not group[0] & symbols]
        for others, more in touching:
            symbols, terms = symbols | others, terms + more
        groups.append((symbols, terms))
    return [sympy.Add(*terms) for _, terms in groups]


@lru_cache(maxsize=10_000)
def _without_squares(group: sympy.Expr) -> sympy.Expr:
    """Return an expression without its factors that are not negative where they have a value."""
    factors = sympy.Mul.make_args(factored(group, MOST_EXAMINED))
    rest = (f for f in factors if not (f.is_nonnegative or f.as_base_exp()[1].is_even))
    return sympy.expand(sympy.Mul(*rest))


def _negative(group: sympy.Expr, apart: set) -> bool:
    if group == 0 or len(sympy.Add.make_args(group)) > MOST_EXAMINED:
        return bool(group == 0)
    group = sympy.Mul(*(f for f in sympy.Mul.make_args(group) if not f.is_nonnegative))
    powers = [power.exp for power in group.atoms(sympy.Pow)]
    low = all(exponent.is_Integer and exponent <= HIGHEST for exponent in powers)
    words = functions_in(group)
    simple = not words or len(sympy.Add.make_args(group)) <= FEW
    if low and simple:
        left = _without_squares(group)
        if left.is_nonpositive or (left != group and nonpositive(left, apart)):
            return True
    if not words:
        return _in_forms(group, apart) or _in_one_symbol(group)
    return _in_sectors(group, words, apart) or _in_pieces(group, words, apart)


def _in_forms(group: sympy.Expr, apart: set) -> bool:
    """Return whether no part of a degree is positive; of degree 2 it is -s^T M s with M >= 0."""
    symbols = sorted(group.free_symbols & apart, key=str)
    if not symbols or not group.is_polynomial(*symbols):
        return False
    degrees: dict[int, sympy.Expr] = {}
    whole = sympy.Poly(group, *symbols)
    for monomial, share in whole.terms():
        term = share * sympy.prod(s**n for s, n in zip(symbols, monomial, strict=True))
        degrees[sum(monomial)] = degrees.get(sum(monomial), sympy.S.Zero) + term
    if len(degrees) > 1:
        return all(_negative(d, apart) for d in degrees.values())
    H = sympy.Matrix([[whole.diff(a, b).as_expr() for a in symbols] for b in symbols])
    known = not H.free_symbols and not H.atoms(sympy.Function)
    return 2 in degrees and known and bool((-H).is_positive_semidefinite)


def _in_one_symbol(group: sympy.Expr) -> bool:
    """Return whether a polynomial of one symbol falls far away, and changes its sign nowhere."""
    if len(group.free_symbols) != 1 or not group.is_polynomial():
        return False
    whole = sympy.Poly(group, *group.free_symbols)
    falls = (whole.domain.is_ZZ or whole.domain.is_QQ) and whole.LC() < 0
    return bool(falls) and not any(
        f.count_roots() for f, n in whole.sqf_list()[1] if n % 2
    )


def _in_sectors(group: sympy.Expr, words: set, apart: set) -> bool:
    """Return whether an expression is not positive wherever its words lie in their sectors."""
    inner = {one for word in words for a in word.args for one in functions_in(a)}
    outer = sorted(words - inner, key=str)
    if len(outer) > MOST_WORDS:
        return False
    q = sympy.symbols(f"q_:{len(outer)}", real=True, cls=sympy.Dummy)
    plain = group.xreplace(dict(zip(outer, q, strict=True)))
    if not plain.is_polynomial(*q):
        return False
    return any(
        _at_the_ends(plain, q, [sector_of(word, slope) for word in outer], apart)
        for slope in (False, True)[: 1 + group.has(sympy.sin, sympy.exp)]
    )


def _at_the_ends(plain: sympy.Expr, q: tuple, found: list, apart: set) -> bool:
    """Return whether an expression, convex in each q, is not positive where q is at its ends."""
    if None in found:
        return False
    sectors = dict(zip(q, found, strict=True))
    bends = ((sympy.diff(plain, one, 2), at.high) for one, at in sectors.items())
    if any(b != 0 and not (b.is_nonnegative and high < sympy.oo) for b, high in bends):
        return False
    q_times = plain.xreplace(
        {one: at.factor * one + at.offset for one, at in sectors.items()}
    )
    if terms_of(q_times) > MOST_TERMS:
        return False
    ends = [sympy.expand(q_times)]
    for one, sector in sectors.items():
        last = [sympy.diff(f, one) for f in ends] if sector.high == sympy.oo else None
        more = last or [f.xreplace({one: sector.high}) for f in ends]
        ends = [f.xreplace({one: sector.low}) for f in ends] + more
    return all(nonpositive(sympy.expand(f), apart) for f in set(ends))


def _in_pieces(
    group: sympy.Expr, words: set, apart: set, facts: tuple[sympy.Expr, ...] = ()
) -> bool:
    """Return whether an expression is not positive in any piece of its words.

    `facts` are expressions that are not negative in the piece at hand.
    """
    for word in sorted(words, key=str) if len(words) <= MOST_WORDS else ():
        pieces = [] if any(map(functions_in, word.args)) else pieces_of(word)
        if pieces:
            return all(
                _in_piece(decided(group.xreplace(values)), apart, (*facts, *conditions))
                for conditions, values in pieces
            )
    return False


def _in_piece(e: sympy.Expr, apart: set, facts: tuple[sympy.Expr, ...]) -> bool:
    """Return whether an expression is not positive where facts are not negative."""
    if nonpositive(e, apart) or any(_is_negative(fact) for fact in facts):
        return True
    words = functions_in(e)
    if any(map(pieces_of, words)):
        return _in_pieces(e, words, apart, facts)
    return _by_facts(e, apart, facts)


def _is_negative(fact: sympy.Expr) -> bool:
    """Return whether a fact holds nowhere: an expression that is below zero everywhere."""
    expanded = sympy.expand(fact)
    return bool(expanded.is_negative or interval(expanded)[1].is_negative)


MOST_FACTS = 4  # conditions of a piece whose products are tried


def _by_facts(e: sympy.Expr, apart: set, facts: tuple[sympy.Expr, ...]) -> bool:
    """Return whether -e is a sum of facts, and products of two, times what is not negative.

    -e = r + sum_i q_i c_i + sum_ij q_ij c_i c_j,    c_i >= 0 known, q and r never negative
    """
    functions = sympy.Tuple(e, *facts).atoms(sympy.Function)  # each may be any number
    names = {f: sympy.Dummy(real=True) for f in functions}
    e = e.xreplace(names)
    known = [sympy.expand(fact.xreplace(names)) for fact in dict.fromkeys(facts)]
    known = known[:MOST_FACTS]
    known = [fact for fact in known if fact.free_symbols]
    products = [sympy.expand(a * b) for a, b in combinations(known, 2)]
    gens = sorted(e.free_symbols.union(*(c.free_symbols for c in known)), key=str)
    whole = sympy.Tuple(e, *known)
    if not known or not all(f.is_polynomial(*gens) for f in whole):
        return False
    shares, rest = sympy.reduced(sympy.expand(-e), [*products, *known], *gens)
    return all(nonpositive(sympy.expand(-q), apart) for q in (*shares, rest))


def positive_maximum(f: sympy.Expr) -> bool:
    """Return whether an expression is maximum(a, b) with a positive one."""
    is_maximum = isinstance(f, AppliedUndef) and str(f.func) == "maximum"
    return is_maximum and any(bool(a.is_positive) for a in f.args)
