"""Sign of an expression: proofs that it is never positive, and expressions that bound it.

`never_positive` is the entry.  It first looks for a random point at which the expression is
positive.  Then groups of terms that share no variable are tested one by one (`GROUP_TESTS`):
factors, forms -s^T M s with M >= 0, roots, sectors and pieces of functions.  At last it tries
completed squares, common factors and intervals of the whole expression.  `without_choices` and
`without_fading` return simpler upper bounds of a loss.
"""

from collections.abc import Iterable
from functools import lru_cache
from itertools import combinations, islice, pairwise, product

import numpy as np
import sympy
from sympy import Add, Derivative, Dummy, Expr, Mul, Pow, S, Tuple, expand

from ...base.errors import DiagramError
from ...engine.diagram.symbol_names import TIME
from .decided import decided
from .exact import HIGHEST, MOST_TERMS, factored, groups_of, terms_of, vanishes
from .facts import (
    WHERE,
    corners,
    facts_of,
    functions_in,
    inputs_in,
    interval,
    pieces_of,
    sectors_of,
)
from .gram import sum_of_squares
from .numeric_values import NO_VALUE, NumericValues
from .slopes import of_same_sign
from .sums_of_squares import squares

MOST_IN_GROUP = 400  # terms of a group; larger groups are not tested
MOST_WITH_FUNCTIONS = 12  # terms of a group with functions that is factored
MOST_FUNCTIONS = 8  # in a group
MOST_WAYS = 16  # to take a sector, a range or a slope of each function
SAMPLES = 500  # random points at which the sign is computed first
ROUNDING = 1e-6  # of the largest value; smaller values may be rounding errors


def never_positive(expression: Expr, parameters: set) -> bool:
    """Return whether an expression is known never to be positive for t >= 0.

    Symbols that are neither `parameters` nor time are variables.
    """
    if terms_of(expression) > MOST_TERMS or expression.has(*NO_VALUE):
        return False
    if positive_somewhere(expression):
        return False
    variables = expression.free_symbols - {TIME, *parameters}
    expression = expression.xreplace({TIME: sympy.Symbol("t", nonnegative=True)})
    return (
        vanishes(expression)
        or groups_never_positive(expression, variables)
        or without_fading(expression, variables) is not None
        or interval(factored(expression))[1].is_nonpositive
        or by_gram(expression)
        or without_choices(expression, variables) is not None
        or _by_pieces(expression, variables)
    )


def positive_somewhere(expression: Expr) -> bool:
    """Return whether an expression is positive at a random point.

    Derivatives of inputs may have any value.
    """
    slopes = {d: Dummy(real=True) for d in expression.atoms(Derivative)}
    try:
        numbers = NumericValues(expression.xreplace(slopes))
    except DiagramError:
        return False
    samples = random_points(numbers.symbols, SAMPLES, 1)
    points = dict(zip(numbers.symbols, samples, strict=True))
    (values,) = numbers.at(points, SAMPLES)
    values = values[np.isfinite(values)]
    return bool(values.size and values.max() > ROUNDING * np.abs(values).max())


def random_points(symbols: list, count: int, decades: float) -> np.ndarray:
    """Return random numbers (symbols, count) with the signs of symbols, of all sizes."""
    random = np.random.default_rng(0)
    points = random.standard_normal((len(symbols), count))
    points *= 10.0 ** random.uniform(-decades, decades, count)
    for row, symbol in zip(points, symbols, strict=True):
        if symbol.is_nonpositive:
            row[:] = -np.abs(row)
        elif symbol.is_nonnegative or symbol == TIME:
            row[:] = np.abs(row)
    return points


# --- tests of a whole expression ------------------------------------------------------------


def without_fading(expression: Expr, variables: set) -> Expr | None:
    """Return an upper bound that is never positive, or None: terms that fade are left out.

    The expression is sum_k f_k p_k, p_k polynomials.  Each f_k is never negative, and p_k is never
    positive where f_k is not zero: clip(s, 0, 1) is not where s >= 0.
    """
    polynomials: dict[Expr, Expr] = {}
    for term in Add.make_args(expand(expression)):
        factors = Mul.make_args(term)
        common = Mul(*(f for f in factors if not f.is_polynomial(*variables)))
        polynomials.setdefault(common, S.Zero)
        polynomials[common] += term / common
    if [*polynomials] == [S.One]:
        return None
    total = S.Zero
    for common, polynomial in polynomials.items():
        factors, polynomial = Mul.make_args(common), expand(polynomial)
        if not all(map(_is_nonnegative, factors)):
            return None
        if groups_never_positive(polynomial, variables):
            total += common * polynomial
            continue
        cases = _where_not_zero(factors)
        if not all(_in_piece(polynomial, variables, margins) for margins in cases):
            return None
    return total


def _where_not_zero(factors: Iterable[Expr]) -> list[tuple[Expr, ...]]:
    """Return sets of expressions; where no factor is zero, those of one set are not negative."""
    cases = [()]
    for call in factors:
        branches = pieces_of(call)
        margins = [margins for margins, values in branches if values.get(call) != 0]
        if len(margins) < len(branches):
            cases = [(*case, *margin) for case in cases for margin in margins]
    return cases


def _is_nonnegative(factor: Expr) -> bool:
    """Return whether a factor is never negative; of a power also by the squares in its base."""
    if interval(factor)[0].is_nonnegative:
        return True
    base, _ = factor.as_base_exp()
    return bool(base.is_Add) and _is_sum_of_squares(base, set())


def _inputs_in(expression: Expr) -> set:
    """Return the inputs in an expression, and their derivatives."""
    return {*inputs_in(expression), *expression.atoms(Derivative)}


@lru_cache(maxsize=10_000)
def by_gram(expression: Expr, conditions: tuple[Expr, ...] = ()) -> bool:
    """Write it as -sum g form^2, each function a symbol with what is known of it (`gram`)."""
    problem = Tuple(expression, *conditions)
    functions = functions_in(problem)
    if len(functions) > MOST_FUNCTIONS:
        return False
    symbols = {
        call: Dummy(f"f_{k}", real=True)
        for k, call in enumerate(sorted({*functions, *_inputs_in(problem)}, key=str))
    }
    facts = *conditions, *facts_of(functions)
    expressions = [e.xreplace(symbols) for e in (expression, *facts)]
    variables = expressions[0].free_symbols
    expressions += [s for s in variables if s.is_nonnegative]
    expressions += [-s for s in variables if s.is_nonpositive and not s.is_nonnegative]
    numerator, divisor = sympy.fraction(sympy.together(expressions[0]))
    if not all(map(_is_nonnegative, Mul.make_args(divisor))):
        return False
    polynomials, total = [*map(expand, expressions[1:])], expand(-numerator)
    lifted = 1 + Add(*(s**2 for s in total.free_symbols))
    return bool(
        sum_of_squares(total, polynomials)
        or (not polynomials and sum_of_squares(expand(total * lifted)))
    )


# --- tests of groups of terms ---------------------------------------------------------------


def groups_never_positive(expression: Expr, variables: set) -> bool:
    """Return whether each group of terms that share variables is never positive."""
    groups = groups_of(expression, variables)
    return all(_group_never_positive(group, variables) for group in groups)


def _group_never_positive(group: Expr, variables: set) -> bool:
    """Return whether one of the tests shows that a group is never positive."""
    if group == 0:
        return True
    if len(Add.make_args(group)) > MOST_IN_GROUP:
        return False
    signed = _signed(group)
    return any(test(signed, variables) for test in GROUP_TESTS)


def _signed(product: Expr) -> Expr:
    """Return the product of the factors that may be negative, even powers left out.

    A function that rises from 0 with its symbol has the sign of that.
    """
    signs = Mul(*map(of_same_sign, Mul.make_args(product)))
    factors = Mul.make_args(signs)
    return Mul(
        *(f for f in factors if not (f.is_nonnegative or f.as_base_exp()[1].is_even))
    )


def _by_factors(group: Expr, variables: set) -> bool:
    """Factor a group and test the product of the factors that may be negative."""
    exponents = [power.exp for power in group.atoms(Pow)]
    if not all(n.is_Integer and n <= HIGHEST for n in exponents):
        return False
    if functions_in(group) and len(Add.make_args(group)) > MOST_WITH_FUNCTIONS:
        return False
    product = _without_nonnegative_factors(group)
    if interval(product)[1].is_nonpositive:
        return True
    return product != group and groups_never_positive(product, variables)


@lru_cache(maxsize=10_000)
def _without_nonnegative_factors(group: Expr) -> Expr:
    """Return the product of the factors that may be negative, multiplied out."""
    return expand(_signed(factored(group, MOST_IN_GROUP)))


def _by_squares(group: Expr, variables: set) -> bool:
    """Complete the squares of what is to be negative."""
    is_smooth = not functions_in(group)
    return is_smooth and _is_sum_of_squares(-group, group.free_symbols - variables)


def _is_sum_of_squares(e: Expr, parameters: set) -> bool:
    """Return whether squares are completed, and what is left is not negative."""
    completed = squares(e, parameters)
    return completed is not None and bool(completed.constant.is_nonnegative)


# --- functions at the ends of their sectors -------------------------------------------------


def _by_sectors(group: Expr, variables: set) -> bool:
    """Test a group at the ends of the sectors of its outermost functions."""
    functions = functions_in(group)
    inner = {f for call in functions for a in call.args for f in functions_in(a)}
    outer = sorted(functions - inner, key=str)
    if not outer or len(outer) > MOST_FUNCTIONS:
        return False
    symbols = sympy.symbols(f"h_:{len(outer)}", real=True, cls=Dummy)
    polynomial = group.xreplace(dict(zip(outer, symbols, strict=True)))
    if not polynomial.is_polynomial(*symbols) or terms_of(polynomial) > MOST_TERMS:
        return False
    ways = islice(product(*map(sectors_of, outer)), MOST_WAYS)
    return any(
        all(groups_never_positive(e, variables) for e in {*of_way.values()})
        for way in ways
        if (of_way := corners(polynomial, dict(zip(symbols, way, strict=True))))
    )


# --- functions piece by piece ---------------------------------------------------------------


def _split(expression: Expr) -> list[tuple[list[Expr], Expr]]:
    """Return the margins and the values of an expression in the pieces of one of its functions."""
    functions = [f for f in functions_in(expression) if pieces_of(f)]
    if len(functions) > MOST_FUNCTIONS:
        return []
    for call in sorted(functions, key=str):
        if not any(map(functions_in, call.args)):
            return [
                (margins, decided(expression.xreplace(values)))
                for margins, values in pieces_of(call)
            ]
    return []


def _by_pieces(group: Expr, variables: set, conditions: tuple[Expr, ...] = ()) -> bool:
    """Test a group in each piece of one of its functions.

    `conditions` are expressions that are not negative in the piece that is tested.
    """
    branches = _split(group)
    return bool(branches) and all(
        _in_piece(value, variables, (*conditions, *margins))
        for margins, value in branches
    )


def _in_piece(expression: Expr, variables: set, conditions: tuple[Expr, ...]) -> bool:
    """Return whether an expression is not positive where conditions are not negative."""
    conditions = tuple(dict.fromkeys(_without_root(expand(c)) for c in conditions))
    zero = {c: S.Zero for c in conditions if c.is_Symbol and -c in conditions}
    expression = decided(expression.xreplace(zero))
    if groups_never_positive(expression, variables) or _is_empty(conditions):
        return True
    expression = _without_conditions(expression, conditions)
    if _is_negative(expression) or groups_never_positive(expression, variables):
        return True
    if any(map(pieces_of, functions_in(expression))):
        return _by_pieces(expression, variables, conditions)
    return by_gram(expression, conditions)


def without_choices(expression: Expr, variables: set) -> Expr | None:
    """Return one branch of each `where` in V' if it is never positive, and the others are lower.

    So a projection is judged: V' without it, and what V' loses where it acts.
    """
    inputs = {f: Dummy(real=True) for f in _inputs_in(expression)}
    expression = expand(expression.xreplace(inputs))
    choices = {f for f in functions_in(expression) if f.func == WHERE}
    inner = {f for choice in choices for a in choice.args for f in functions_in(a)}
    words = {choice: Dummy(real=True) for choice in choices - inner}
    linear = expression.xreplace(words)
    slopes = Tuple(*(linear.diff(word) for word in words.values()))
    if not words or slopes.has(*words.values()):
        return None
    conditions = {choice.args[0] for choice in words}
    variables = variables | {*inputs.values()}
    for default in (2, 1):
        bounds = [expression]
        for condition in sorted(conditions, key=str):
            chosen = [f for f in words if f.args[0] == condition]
            values = {f: _leaf(f, default) for f in chosen}
            bounds.append(expand(bounds[-1].xreplace(values)))
        losses = (expand(a - b) for a, b in pairwise(bounds))
        if groups_never_positive(bounds[-1], variables) and all(
            _in_piece(loss, variables, ()) for loss in losses
        ):
            return bounds[-1].xreplace({symbol: f for f, symbol in inputs.items()})
    return None


def _leaf(e: Expr, branch: int) -> Expr:
    """Return the first or the last value of a `where`, in which others may stand."""
    return _leaf(e.args[branch], branch) if e.func == WHERE else e


def _without_conditions(e: Expr, conditions: tuple[Expr, ...]) -> Expr:
    """Return an expression without factors that make a condition or are not negative."""
    product = _signed(factored(e))
    for condition in map(factored, conditions):
        powers = product.as_powers_dict()
        factors = condition.as_powers_dict().items()
        excess = [powers[f] - n for f, n in factors if not f.is_number]
        if excess and all(n.is_nonnegative for n in excess):
            product /= condition
    return _signed(product)


def _without_root(condition: Expr) -> Expr:
    """Return a condition of the same sign without its root: s - c^2 of sqrt(s) - c, c >= 0."""
    for root in condition.atoms(Pow):
        slope = condition.coeff(root)
        if root.exp == S.Half and slope.is_number and slope != 0:
            least = expand(root - condition / slope)
            if least.is_nonnegative:
                return expand(slope * (root.base - least**2))
    return condition


def in_one_piece(e: Expr, conditions: tuple[Expr, ...] = ()) -> Expr | None:
    """Return the polynomial that a continuous expression is in all its pieces, or None."""
    branches = _split(e)
    if not branches:
        return None if functions_in(e) and conditions else expand(e)
    values = set()
    for margins, value in branches:
        facts = tuple(map(expand, (*conditions, *margins)))
        has_inside = not any(expand(-c) in facts for c in facts)
        if has_inside and not _is_empty(facts):
            values.add(in_one_piece(value, facts))
    return values.pop() if len(values) == 1 else None


def _is_empty(conditions: tuple[Expr, ...]) -> bool:
    """Return whether conditions, or two of them, are known to contradict each other."""
    sums = (a + b for a, b in combinations(conditions, 2))
    return any(map(_is_negative, (*conditions, *sums)))


def _is_negative(condition: Expr) -> bool:
    """Return whether an expression is known to be negative everywhere."""
    expanded = expand(condition)
    return bool(expanded.is_negative or interval(expanded)[1].is_negative)


GROUP_TESTS = (_by_factors, _by_squares, _by_sectors, _by_pieces)
