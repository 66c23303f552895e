"""Decide whether an expression is never positive.

An expression is never positive where it factors into squares with a minus, where it is -s^T M s
with M >= 0, where completed squares leave nothing else, or where its functions lie in sectors at
whose ends it is not positive.  A function with pieces is examined piece by piece, each with the
conditions under which it holds.  Nothing is tried where it is positive at a random point.
"""

from functools import lru_cache
from itertools import combinations

import numpy as np
import sympy
from sympy.core.function import AppliedUndef

from ...base.errors import DiagramError
from ...engine.diagram.symbol_names import TIME
from .exact import HIGHEST, MOST_TERMS, factored, terms_of, vanishes
from .facts import decided, functions_in, interval, is_input, pieces_of, sector_of
from .sums_of_squares import squares
from .symbolic_loop import Numbers

MOST_EXAMINED = 400  # of more no sign is known
FEW = 12  # terms; more with words in them are not factored
MOST_WORDS = 8  # that are examined together
MOST_FACTS = 4  # conditions of a piece whose products are tried
TRIED = 500  # points at which a sign is looked at before it is proved
SMALL = 1e-6  # of the largest value there; less may be rounding


def never_positive(e: sympy.Expr, fixed: set, ways: tuple = (None,)) -> bool:
    """Return whether an expression is known never to be positive, t >= 0.

    Symbols that are `fixed` are parameters; `ways` are symbols by which terms are examined apart.
    Nothing is tried where it is positive at a random point.
    """
    if terms_of(e) > MOST_TERMS or positive_somewhere(e):
        return False
    free = e.free_symbols - {TIME, *fixed}
    e = e.xreplace({TIME: sympy.Symbol("t", nonnegative=True)})
    if vanishes(e) or any(nonpositive(e, free, by=by) for by in ways):
        return True
    terms = sympy.Add.make_args(e)
    left = (f for f in terms if f.is_polynomial(*free) or not f.is_nonpositive)
    signals = {f: sympy.Dummy(real=True) for f in e.atoms(AppliedUndef) if is_input(f)}
    for rest in dict.fromkeys((e, sympy.Add(*left))):
        totals = [squares(-rest, fixed)]
        if signals:
            # a quadratic form whose coefficients are made of inputs
            coefficients = fixed | {*signals.values()}
            totals.append(squares(-rest.xreplace(signals), coefficients))
        if any(total and total.constant.is_nonnegative for total in totals):
            return True
    if _by_common_factor(e, free):
        return True
    return any(
        interval(one)[1].is_nonpositive for one in (factored(e), sympy.factor_terms(e))
    )


def positive_somewhere(expression: sympy.Expr) -> bool:
    """Return whether an expression is positive at a random point: no proof is tried then.

    Slopes of inputs may be anything.
    """
    slopes = {d: sympy.Dummy(real=True) for d in expression.atoms(sympy.Derivative)}
    try:
        numbers = Numbers(expression.xreplace(slopes))
    except DiagramError:
        return False
    random = np.random.default_rng(0)
    drawn = random.standard_normal((len(numbers.symbols), TRIED))
    drawn *= 10.0 ** random.uniform(-1, 1, (1, TRIED))
    for row, s in zip(drawn, numbers.symbols, strict=True):
        if s.is_nonnegative or s.is_nonpositive or s == TIME:
            row[:] = np.abs(row) * (-1 if s.is_nonpositive else 1)
    (values,) = numbers.at(dict(zip(numbers.symbols, drawn, strict=True)), TRIED)
    values = values[np.isfinite(values)]
    return bool(values.size and values.max() > SMALL * np.abs(values).max())


def _by_common_factor(e: sympy.Expr, free: set) -> bool:
    """Return whether e = sum_k f_k p_k, f_k > 0 no polynomial and each p_k never positive."""
    polynomials: dict[sympy.Expr, sympy.Expr] = {}
    for term in sympy.Add.make_args(sympy.expand(e)):
        factors = sympy.Mul.make_args(term)
        common = sympy.Mul(*(f for f in factors if not f.is_polynomial(*free)))
        polynomials[common] = polynomials.get(common, sympy.S.Zero) + term / common
    if len(polynomials) < 2 and sympy.S.One in polynomials:
        return False
    return all(
        all(map(_is_above_zero, sympy.Mul.make_args(common)))
        and nonpositive(sympy.expand(p), free)
        for common, p in polynomials.items()
    )


def _is_above_zero(factor: sympy.Expr) -> bool:
    """Return whether a factor is never negative; of a power also by the squares in its base."""
    if factor.is_nonnegative:
        return True
    base, _ = factor.as_base_exp()
    total = squares(base, set()) if base.is_Add else None
    return total is not None and bool(total.constant.is_positive)


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
