"""Exact algebra: zero tests, normal forms and factors of expressions.

An expression is zero if as one fraction p/q, of polynomials over the rationals in its symbols and
functions, p = 0 and q is not.  Roots and rounded numbers are left to SymPy's own rules.
"""

from collections import defaultdict
from collections.abc import Iterable, Mapping
from functools import cache, lru_cache
from math import comb, prod
from types import MappingProxyType
from typing import Any

import sympy
from sympy import (
    Add,
    Dummy,
    Expr,
    Function,
    Mul,
    Pow,
    Rational,
    S,
    Symbol,
    cosh,
    exp,
    expand,
    sinh,
)
from sympy.core.function import AppliedUndef
from sympy.polys.polyconfig import using
from sympy.polys.rings import PolyElement, PolyRing

from ...base.errors import DiagramError
from ...engine.record.symbolic import rational
from .decided import decided
from .facts import CLIP, INSIDE, fact_of
from .texts import LARGEST, short

MOST_TERMS = 20_000  # longer expressions are not multiplied out
HIGHEST = 4  # higher powers are not factored
MOST_FACTORED = 40  # terms
LARGEST_IN_EXP = 10  # numbers in an exponent of e
ROUNDED = 2.0**-46  # share of the terms of a sum of rounded numbers that is no sum
HIGHEST_REWRITTEN = 100  # higher powers stay as they are
# of 3 configurations, one in five polynomials with nine functions had bad ones alone
FACTOR_CONFIGURATIONS = 20
NO_VALUES = MappingProxyType[Any, Any]({})
# even function -> the odd function and the sign in 1 - sin^2, 1 + sinh^2
PYTHAGOREAN = {sympy.cos: (sympy.sin, -1), cosh: (sinh, 1)}


@lru_cache(maxsize=1000)  # much is the same for each N
def vanishes(expression: Any) -> bool:
    """Return whether an expression is zero; one that divides by zero is not."""
    expression = sympy.sympify(expression)
    p, q = _fraction(expression)
    generators = p.ring.symbols
    is_decided = p == 0 or q == 0
    if not is_decided and any(
        not isinstance(g, Symbol | AppliedUndef) for g in generators
    ):
        p, q = map(expand, sympy.fraction(sympy.together(expression)))
    return p == 0 and q != 0


@lru_cache(maxsize=1000)
def as_factors(expression: Expr) -> Expr:
    """Return an expression as one fraction of factors."""
    p, q = _fraction(expression)
    return _factor(p.as_expr()) / _factor(q.as_expr())


def divides_by_sum(expression: Expr) -> bool:
    """Return whether a fraction has a divisor of several terms."""
    return len(_fraction(expression)[1]) > 1


def _factor(expression: Expr) -> Expr:
    """Factor an expression; from a few bad random configurations SymPy does not return."""
    with using(EEZ_NUMBER_OF_CONFIGS=FACTOR_CONFIGURATIONS):
        return sympy.factor(expression)


def nonzero_residual(residual: Any) -> str:
    """Return "" if a residual is zero, otherwise a sentence with the residual."""
    return "" if vanishes(residual) else f"left over: {short(expand(residual))}"


# --- fractions of polynomials ---------------------------------------------------------------


def _generators(expression: Expr) -> set[Expr]:
    """Return the symbols and functions of which an expression is a rational function."""
    if expression.is_Add or expression.is_Mul:
        return set().union(*map(_generators, expression.args))
    if expression.is_Pow and expression.exp.is_Integer:
        return _generators(expression.base)
    return set() if expression.is_Rational else {expression}


def _fraction(expression: Expr) -> tuple[PolyElement, PolyElement]:
    """Return p and q of an expression p/q; SymPy's own field is slower, with divisors."""
    ring = PolyRing([*_generators(expression)], sympy.ZZ)
    generators = zip(ring.symbols, ring.gens, strict=True)
    fractions = {symbol: (generator, ring.one) for symbol, generator in generators}

    @cache
    def fraction(e: Expr) -> tuple[PolyElement, PolyElement]:
        if e in fractions:
            return fractions[e]
        if e.is_Rational:
            return ring.ground_new(e.p), ring.ground_new(e.q)
        if e.is_Pow:
            p, q = fraction(e.base)
            exponent = abs(int(e.exp))
            power = p**exponent, q**exponent
            return power if e.exp > 0 else power[::-1]
        arguments = [fraction(a) for a in e.args]
        if e.is_Mul:
            numerators, denominators = zip(*arguments, strict=True)
            return ring.mul(*numerators), ring.mul(*denominators)
        return added(arguments)

    def added(summands: list) -> tuple[PolyElement, PolyElement]:
        """Add fractions, those with the same denominator first."""
        numerators = defaultdict[PolyElement, list[PolyElement]](list)
        for p, q in summands:
            numerators[q].append(p)
        p, q = ring.zero, ring.one
        for denominator, terms in numerators.items():
            p = p * denominator + ring.add(*terms) * q
            q = q * denominator
        return p, q

    return fraction(expression)


# --- normal form ----------------------------------------------------------------------------


@lru_cache(maxsize=1000)
def normal_form(expression: Expr) -> Expr:
    """Return an expression multiplied out, cos^2 as 1 - sin^2, cosh^2 as 1 + sinh^2.

    Sums and multiples of angles are expanded only where other angles share their symbols: of
    sin(3 t) alone more is known than of 3 sin(t) - 4 sin(t)^3.
    """
    if terms_of(expression) > MOST_TERMS:
        raise DiagramError(
            f"V' has more than {MOST_TERMS} terms. Make the law or its N smaller"
        )
    exponentials = expression.atoms(exp)
    is_nested = any(e.args[0].atoms(exp) for e in exponentials)
    if exponentials and not is_nested:
        # as symbols: SymPy would multiply them into denominators
        symbols = {e: Dummy(str(e), positive=True) for e in exponentials}
        original = {symbol: e for e, symbol in symbols.items()}
        plain = normal_form(expression.xreplace(symbols)).xreplace(original)
        return expand(plain, deep=False, power_exp=False)
    expression = with_tanh(expression)
    unchanged = {power.base for power in high_powers(expression)}
    expression = _with_expanded_angles(expression, unchanged)
    for inside in expression.atoms(INSIDE):
        expression = _with_clip_inside(expression, inside)
    return _with_odd_functions(expression, unchanged)


def with_tanh(expression: Expr) -> Expr:
    """Write sinh as tanh cosh where cosh has a power, as in derivatives of log(cosh)."""
    bases = {power.base for power in expression.atoms(Pow)}
    angles = [base.args[0] for base in bases if isinstance(base, cosh)]
    products = {sinh(a): sympy.tanh(a) * cosh(a) for a in angles}
    return expand(expression.xreplace(products)) if products else expression


def _with_expanded_angles(expression: Expr, unchanged: set) -> Expr:
    """Expand functions of sums of angles that share symbols with other angles."""
    expanded = {}
    for even, (odd, _) in PYTHAGOREAN.items():
        calls = expression.atoms(even, odd) - unchanged
        angles = {call.args[0] for call in calls}
        for call in calls:
            if _may_cancel(call.args[0], angles):
                expanded[call] = sympy.expand_trig(call)
    return expand(expression.xreplace(expanded))


def _may_cancel(angle: Expr, angles: set[Expr]) -> bool:
    """Return whether terms of an expanded angle may cancel those of other angles."""
    has_low_multiples = all(abs(n) <= HIGHEST for n in angle.atoms(sympy.Integer))
    different = angles - {angle, -angle}
    shares_symbols = any(angle.free_symbols & a.free_symbols for a in different)
    return has_low_multiples and shares_symbols


def _with_clip_inside(expression: Expr, inside: Expr) -> Expr:
    """Write clip(s, a, b) as s in the factor of inside(s, a, b)."""
    outside = expression.xreplace({inside: S.Zero})
    factor = expression.xreplace({inside: S.One}) - outside
    clip = CLIP(*inside.args)
    return expand(outside + inside * factor.xreplace({clip: inside.args[0]}))


def _with_odd_functions(expression: Expr, unchanged: set) -> Expr:
    """Write powers of cos and cosh by those of sin and sinh."""
    powers = {}
    for power in expression.atoms(Pow):
        base, n = power.base, power.exp
        if base.func not in PYTHAGOREAN or base in unchanged:
            continue
        if n.is_Integer and n != -1:
            odd, sign = PYTHAGOREAN[base.func]
            square = 1 + sign * odd(*base.args) ** 2
            powers[power] = square ** (n // 2) * base ** (n % 2)
    return expand(expression.xreplace(powers))


def without_rounding(e: Expr, values: Mapping[Any, Expr] = NO_VALUES) -> Expr:
    """Return a sum without the terms that are rounding errors of the products they are made of.

    A coefficient is compared with the sum of the sizes of all that cancels in it, but for products
    of numbers that doubles hold exactly, as 1/2 and 1e16; cos(3) and other values of functions at
    numbers are as machines round them, and their arguments.  Parameters with `values` are these
    numbers.
    """
    numbers = _numbers_in(e, values)
    if not numbers and all(n.q <= LARGEST for n in e.atoms(Rational)):
        return e
    numbers |= values
    inexact = Dummy(positive=True)

    def size(e: Expr) -> Expr:
        if e.is_Rational:
            return abs(e) if e.q.bit_count() == 1 else inexact * abs(e)
        if e in numbers:
            return size(numbers[e]) + size_of_change(e)
        if e.is_Add or e.is_Mul:
            return e.func(*map(size, e.args))
        return size(e.base) ** e.exp if _is_product(e) else e.xreplace(numbers)

    def size_of_change(call: Expr) -> Expr:
        """Return by how much a function changes with the sizes of its arguments."""
        if call.is_Pow:
            of_base = size(call.base) / abs(call.base.xreplace(numbers))
            return abs(numbers[call] * call.exp.xreplace(numbers)) * of_base
        kind = fact_of(call).kind if call.args else "step"
        if kind == "kink":
            return Add(*map(size, call.args))
        if kind != "smooth" or len(call.args) != 1:
            return S.Zero
        slope = Rational(float(call.fdiff().xreplace(values)))
        return abs(slope) * size(call.args[0])

    symbols = {call: Dummy(real=True) for call in numbers}
    value = e.xreplace(numbers)
    if value.has(sympy.zoo, sympy.nan):
        return value
    of_inexact = size(e).diff(inexact).xreplace({inexact: S.One})
    terms, sizes, exact = (
        expand(f).as_coefficients_dict()
        for f in (value, of_inexact, e.xreplace(symbols))
    )
    kept = {
        term: c
        for term, c in terms.items()
        if abs(c) > ROUNDED * sizes[term] and float(c) != 0.0
    }
    back = {symbol: numbers[call] for call, symbol in symbols.items()}
    factors = ([*Mul.make_args(term)] for term in exact)
    every = {
        Mul(*(f.xreplace(back) for f in of if not f.free_symbols <= back.keys()))
        for of in factors
    }
    return e if every <= kept.keys() else Add(*(c * t for t, c in kept.items()))


def _numbers_in(e: Expr, values: Mapping[Any, Expr] = NO_VALUES) -> dict[Expr, Expr]:
    """Return functions of numbers, and of parameters with values, as machines round them."""
    kinds = Symbol, Function, Pow, sympy.NumberSymbol
    return {
        call: rational(float(decided(call.xreplace(values))))
        for call in e.atoms(*kinds)
        if call.free_symbols <= values.keys() and call.is_real and not _is_product(call)
    }


def _is_product(e: Expr) -> bool:
    """Return whether an expression is a positive power, of which the base is judged."""
    return bool(e.is_Pow and e.exp.is_Integer and e.exp.is_positive)


def too_small(e: Expr, values: Mapping[Any, Expr]) -> dict[Expr, Expr]:
    """Return the functions of parameters that are not zero, but run as 0, exp(-1000), and 0."""
    return {
        call: S.Zero
        for call in e.atoms(Function, Pow)
        if call.free_symbols
        and call.free_symbols <= values.keys()
        and call.is_nonzero
        and float(call.xreplace(values)) == 0.0
    }


def coarse(e: Expr) -> Expr:
    """Return an expression with 13 digits of numbers, so that those of some roundings agree."""
    numbers = {n: n for n in e.atoms(Rational)} | _numbers_in(e)
    return e.xreplace({n: Rational(f"{float(v):.12e}") for n, v in numbers.items()})


def whole_coefficients(e: Expr, variables: Iterable[Any]) -> Expr:
    """Return a polynomial in variables with each coefficient reduced; others as they are."""
    used = [v for v in variables if e.has(v)]
    is_polynomial = used and e.is_polynomial(*used)
    return sympy.collect(expand(e), used, sympy.cancel) if is_polynomial else e


# --- factors and sizes ----------------------------------------------------------------------


def high_powers(expression: Expr) -> set[Expr]:
    """Return the powers that stay as they are, and exp(1000 x): SymPy has exp(x)**1000."""
    powers = {
        power
        for power in expression.atoms(Pow)
        if power.exp.is_Integer and abs(power.exp) > HIGHEST_REWRITTEN
    }
    for call in expression.atoms(exp):
        numbers = call.args[0].atoms(Rational)
        if any(max(abs(n.p), n.q) > LARGEST_IN_EXP for n in numbers):
            powers.add(call)
    return powers


def factored(expression: Expr, most: int = MOST_FACTORED) -> Expr:
    """Return an expression factored; unchanged if it has many terms or operations."""
    terms = Add.make_args(expression)
    if len(terms) > most or expression.count_ops() > 5 * most:
        return expression
    symbols = {
        power: Dummy(
            str(power),
            positive=power.is_positive or None,
            nonnegative=power.is_nonnegative or None,
        )
        for power in high_powers(expression)
    }
    original = {symbol: power for power, symbol in symbols.items()}
    return _factor(expression.xreplace(symbols)).xreplace(original)


def groups_of(expression: Expr, variables: set) -> list[Expr]:
    """Return an expression as a sum of expressions that share no variable."""
    groups: list[tuple[set, list]] = []
    for term in Add.make_args(expand(expression, power_exp=False)):
        symbols = term.free_symbols & variables
        terms = [term]
        touching = [group for group in groups if group[0] & symbols]
        groups = [group for group in groups if not group[0] & symbols]
        for group_symbols, group_terms in touching:
            symbols = symbols | group_symbols
            terms = terms + group_terms
        groups.append((symbols, terms))
    return [Add(*terms) for _, terms in groups]


def terms_of(expression: Expr) -> int:
    """Return the largest number of terms of an expression that is multiplied out."""
    if expression.is_Add:
        return sum(map(terms_of, expression.args))
    if expression.is_Mul:
        return prod(map(terms_of, expression.args))
    if expression.is_Pow and expression.exp.is_Integer and expression.base.is_Add:
        n, m = terms_of(expression.base), abs(int(expression.exp))
        return comb(n + m - 1, m)
    return 1
