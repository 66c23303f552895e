"""Table of facts about nonlinear functions in expressions, such as tanh(s) or clip(s, a, b).

- **sector**: an odd rising h has h(s) = q s with q in a range, so tanh(s) = q s, 0 <= q <= 1;
- **pieces**: clip(s, a, b) is s where s - a >= 0 and b - s >= 0, a where a - s >= 0, ...;
- **range**: the interval of its values, from those of its arguments;
- **growth**: bounded, or at most as fast as (one of) its arguments;
- **kind**: smooth, a kink, a step (constant except where it jumps), or a choice of branches.

Where pieces meet with equal slopes, V' is that of each piece (`meets_smoothly`).  A V with a kink
decreases too if it does in each piece and rates are continuous.  Where rates jump, a motion may
slide along the kink, and V rise.
"""

from collections.abc import Callable, Iterable
from functools import lru_cache, reduce
from itertools import combinations
from math import inf
from operator import ge, gt, le, lt
from typing import Any, Literal, NamedTuple

import sympy
from sympy import Add, Expr, Function, Max, Min, S, expand, oo
from sympy.core.function import AppliedUndef

from ...engine.diagram.symbol_names import TIME
from ...engine.record.symbolic import ON_NUMBERS
from .every_n import SUM

# --- functions that SymPy leaves as they are ------------------------------------------------

INSIDE = Function("inside", real=True)  # 1 where clip(s, a, b) is s, else 0
CLIP = Function("clip", real=True)
GT = Function("gt", real=True)
SIGN = Function("sign", real=True)
WHERE = Function("where", real=True)
MAXIMUM = Function("maximum", real=True)
COMPARISONS: dict[str, Callable[..., Any]] = {"gt": gt, "ge": ge, "lt": lt, "le": le}
LOGIC: dict[str, Callable[..., Any]] = {
    "and_": lambda a, b: a * b,
    "or_": lambda a, b: a + b - a * b,
    "not_": lambda a: 1 - a,
}
CONNECTIVES = {"and_": sympy.And, "or_": sympy.Or, "not_": sympy.Not}
MOST_ATOMS = 6  # comparisons in a condition that is simplified
NUMPY_OF = {**ON_NUMBERS, "inside": lambda s, low, high: (low < s) & (s < high)}

Interval = tuple[Any, Any]
# expressions that are not negative in the piece, and values of functions there
Piece = tuple[list[Expr], dict[Any, Any]]


class Fact(NamedTuple):
    """A row of the table."""

    kind: Literal["smooth", "kink", "step", "choice"]
    growth: Literal["bounded", "as all", "as branches", "unknown"] = "unknown"
    # range of h(s)/s of an odd function that rises with s
    sector: Interval | None = None
    pieces: Callable[..., list[Piece]] | None = None
    # ends of the arguments -> ends
    range: Callable[..., Interval] | None = None
    # carried out where all arguments are numbers
    number: Callable[..., Any] | None = None


# --- pieces ---------------------------------------------------------------------------------


def _pieces_of_comparison(call: Any, a: Any, b: Any) -> list[Piece]:
    is_greater = call.func.__name__ in ("gt", "ge")
    margin = a - b if is_greater else b - a
    return [([margin], {call: S.One}), ([-margin], {call: S.Zero})]


def _pieces_of_extreme(call: Any, a: Any, b: Any) -> list[Piece]:
    is_maximum = call.func.__name__ == "maximum"
    margin = a - b if is_maximum else b - a
    return [([margin], {call: a}), ([-margin], {call: b})]


def _pieces_of_clip(call: Any, s: Any, low: Any, high: Any) -> list[Piece]:
    if not (high - low).is_nonnegative:
        return []
    clip = CLIP(s, low, high)
    inside = INSIDE(s, low, high)
    return [
        ([s - low, high - s], {clip: s, inside: S.One}),
        ([low - s], {clip: low, inside: S.Zero}),
        ([s - high], {clip: high, inside: S.Zero}),
    ]


def _pieces_of_sign(call: Any, s: Any) -> list[Piece]:
    def values(sign: Any) -> dict[Any, Any]:
        return {SIGN(s): sign, sympy.sign(s): sign, sympy.Abs(s): sign * s}

    return [([s], values(S.One)), ([-s], values(-S.One)), ([s, -s], values(S.Zero))]


# --- ranges ---------------------------------------------------------------------------------


def _constant(low: Any, high: Any) -> Callable[..., Interval]:
    """Return a range that does not depend on the arguments."""
    return lambda *ends: (sympy.sympify(low), sympy.sympify(high))


def _monotone(function: Callable[..., Any]) -> Callable[..., Interval]:
    """Return the range of a function that rises with each argument."""
    return lambda *ends: tuple(function(*values) for values in zip(*ends, strict=True))


def _range_of_choice(*ends: Interval) -> Interval:
    """Return the range of a choice: the first argument selects one of the others."""
    lows, highs = zip(*ends[1:], strict=True)
    return Min(*lows), Max(*highs)


def _range_of_exp(ends: Interval) -> Interval:
    high = oo if ends[1] == oo else sympy.exp(ends[1])
    return S.Zero, high


def _clip_number(s: Any, low: Any, high: Any) -> Any:
    return Min(Max(s, low), high)


def _inside_number(s: Any, low: Any, high: Any) -> Any:
    return sympy.Integer(bool(low < s) and bool(s < high))


def _extreme(function: Any) -> Fact:
    return Fact(
        "kink",
        "as all",
        pieces=_pieces_of_extreme,
        range=_monotone(function),
        number=function,
    )


# --- the table ------------------------------------------------------------------------------

TRUTH = _constant(0, 1)
UNIT = _constant(-1, 1)
SMOOTH = "erfc cosh acosh atanh asin acos tan log"
FACTS: dict[str, Fact] = {
    "sin": Fact("smooth", "bounded", range=UNIT),
    "cos": Fact("smooth", "bounded", range=UNIT),
    "tanh": Fact("smooth", "bounded", sector=(0, 1), range=UNIT),
    "atan": Fact("smooth", "bounded", sector=(0, 1)),
    "atan2": Fact("choice", "bounded"),
    "erf": Fact("smooth", "bounded", sector=(0, 2)),
    "asinh": Fact("smooth", "as all", sector=(0, 1)),
    "sinh": Fact("smooth", sector=(1, oo)),
    "exp": Fact("smooth", range=_range_of_exp),
    **dict.fromkeys(SMOOTH.split(), Fact("smooth")),
    "Abs": Fact("kink", "as all", pieces=_pieces_of_sign),
    "clip": Fact(
        "kink",
        "as branches",
        pieces=_pieces_of_clip,
        range=_monotone(_clip_number),
        number=_clip_number,
    ),
    "maximum": _extreme(Max),
    "minimum": _extreme(Min),
    "sign": Fact(
        "step", "bounded", pieces=_pieces_of_sign, range=UNIT, number=sympy.sign
    ),
    "inside": Fact(
        "step", "bounded", pieces=_pieces_of_clip, range=TRUTH, number=_inside_number
    ),
    **dict.fromkeys(("floor", "trunc", "ceil"), Fact("step", "as all")),
    "mod": Fact("choice", "as branches", number=lambda a, b: a % b),
    **dict.fromkeys(
        ("where", "pick"), Fact("choice", "as branches", range=_range_of_choice)
    ),
    **dict.fromkeys(
        COMPARISONS, Fact("step", "bounded", pieces=_pieces_of_comparison, range=TRUTH)
    ),
    **dict.fromkeys(LOGIC, Fact("step", "bounded", range=TRUTH)),
}
UNKNOWN = Fact("choice")
# functions of SymPy that are odd and rise
ODD = tuple(getattr(sympy, name) for name, fact in FACTS.items() if fact.sector)


def fact_of(call: Expr) -> Fact:
    """Return the row of the table for a function in an expression."""
    return FACTS.get(call.func.__name__, UNKNOWN)


# --- functions in expressions ---------------------------------------------------------------


def functions_in(expression: Expr) -> set[Any]:
    """Return the functions in an expression, except numbers, sums and functions of time alone."""
    calls = expression.atoms(Function)
    return {f for f in calls if not (is_input(f) or f.func == SUM or f.is_number)}


def is_input(call: Any) -> bool:
    """Return whether a function is an unknown function of time alone, as the inputs are."""
    if not isinstance(call, AppliedUndef) or call.func.__name__ in NUMPY_OF:
        return False
    return [str(a) for a in call.args] == ["t"]


def has_time(*expressions: Expr) -> bool:
    """Return whether expressions depend on time by themselves, not by an input alone."""
    total = sympy.Tuple(*expressions)
    slopes = dict.fromkeys(total.atoms(sympy.Derivative), S.Zero)
    inputs = {f: S.Zero for f in total.atoms(AppliedUndef) if is_input(f)}
    return bool(total.xreplace(slopes).xreplace(inputs).has(TIME))


def decided(expression: Expr) -> Expr:
    """Return an expression in which comparisons and choices of numbers are evaluated."""
    return expression.replace(lambda e: isinstance(e, AppliedUndef), _outcome)


def _outcome(call: Any) -> Any:
    """Return the value of a comparison, a choice or a function of numbers, or the call."""
    name, arguments = call.func.__name__, call.args
    are_numbers = [a.is_number for a in arguments]
    if name == "where" and are_numbers[0]:
        condition, *branches = arguments
        return branches[0] if condition != 0 else branches[1]
    if name in COMPARISONS:
        truth = COMPARISONS[name](*arguments)
        if truth in (True, False):
            return sympy.Integer(bool(truth))
        return _without_size(call)
    if name in LOGIC:
        is_known = any(are_numbers) and all(map(_is_truth, arguments))
        return LOGIC[name](*arguments) if is_known else _simplified(call)
    number = fact_of(call).number
    if number is not None and all(are_numbers):
        return number(*arguments)
    return call


def _simplified(call: Any) -> Any:
    """Return and_, or_ and not_ of comparisons with as few of them as can be."""
    atoms: dict[tuple, sympy.Symbol] = {}

    def proposition(e: Any) -> Any:
        name, arguments = e.func.__name__, e.args
        if name in CONNECTIVES:
            return CONNECTIVES[name](*map(proposition, arguments))
        if name in ("gt", "le"):  # a > b unless b >= a
            arguments = arguments[::-1]
        key = arguments if name in COMPARISONS else (e,)
        atom = atoms.setdefault(key, sympy.Dummy())
        return ~atom if name in ("lt", "gt") else atom

    def word(e: Any) -> Any:
        if e in (sympy.true, sympy.false):
            return sympy.Integer(bool(e))
        negated = e.func == sympy.Not
        if e.func in (sympy.And, sympy.Or):
            name = "and_" if e.func == sympy.And else "or_"
            return reduce(Function(name, real=True), map(word, e.args))
        key = keys[e.args[0] if negated else e]
        name = ("lt" if negated else "ge") if len(key) == 2 else "not_"
        return (
            key[0]
            if name == "not_" and not negated
            else Function(name, real=True)(*key)
        )

    statement = proposition(call)
    if len(atoms) > MOST_ATOMS:
        return call
    keys = {atom: key for key, atom in atoms.items()}
    simplified = word(sympy.simplify_logic(statement, force=True))
    return min(call, simplified, key=sympy.count_ops)


def _without_size(call: Any) -> Any:
    """Return a comparison of |s| with a number or a parameter as two of s."""
    (size, c), name = call.args, call.func.__name__
    is_small = name in ("lt", "le")
    if isinstance(c, sympy.Abs):
        size, c, is_small = c, size, not is_small
        name = {"lt": "gt", "gt": "lt", "le": "ge", "ge": "le"}[name]
    if not isinstance(size, sympy.Abs) or functions_in(c):
        return call
    other = {"lt": "gt", "gt": "lt", "le": "ge", "ge": "le"}[name]
    (s,), word = size.args, sympy.Function("and_" if is_small else "or_", real=True)
    two = (sympy.Function(f, real=True) for f in (name, other))
    return word(*(f(s, end) for f, end in zip(two, (c, -c), strict=True)))


def _is_truth(e: Expr) -> bool:
    """Return whether an expression is 0, 1 or a truth value."""
    return e in (0, 1) or e.func.__name__ in (*COMPARISONS, *LOGIC)


def pieces_of(call: Any) -> list[Piece]:
    """Return the pieces of a function; none if no pieces are known."""
    pieces = fact_of(call).pieces
    return [] if pieces is None else pieces(call, *call.args)


def is_smooth(expression: Expr) -> bool:
    """Return whether an expression has no functions with pieces or jumps."""
    return all(fact_of(call).kind == "smooth" for call in functions_in(expression))


def is_continuous(expression: Expr) -> bool:
    """Return whether an expression is known to jump nowhere where it has a value."""
    kinds = {fact_of(call).kind for call in functions_in(expression)}
    return kinds <= {"smooth", "kink"}


# --- sectors and ranges ---------------------------------------------------------------------


class Sector(NamedTuple):
    """A function is q times `factor`, q between `low` and `high`, plus `offset`."""

    factor: Expr
    low: Any
    high: Any  # oo if q is unbounded
    # whether q > 0 except at s = 0, and s h(s) never falls with |s|
    rises: bool = False
    offset: Any = 0


def sector_of(call: Any, by_slope: bool = False) -> Sector | None:
    """Return the sector of a function, if it is known; of a sine or exp by its slope."""
    name, s = call.func.__name__, call.args[0]
    if by_slope and name == "sin":
        return Sector(s, -1, 1)
    if by_slope and name == "exp":
        return Sector(s, 0, oo, offset=1)
    sector = fact_of(call).sector
    if sector is not None:
        return Sector(s, *sector, rises=True)
    if name in ("sign", "floor", "trunc", "ceil"):
        return Sector(s, 0, oo, rises=name == "sign")
    if name == "clip":
        _, low, high = call.args
        if low.is_nonpositive and high.is_nonnegative:
            return Sector(s, 0, 1, bool(low.is_negative and high.is_positive))
    low, high = interval(call)
    return None if low == -inf else Sector(S.One, low, high)


@lru_cache(maxsize=10_000)
def interval(e: Expr) -> Interval:
    """Return the numbers between which an expression is, for all values of its symbols."""
    if e.is_number and e.is_real:
        return e, e
    ends = [interval(a) for a in e.args]
    fact = fact_of(e)
    if fact.range is not None:
        return fact.range(*ends)
    # runs begin at t = 0
    low: Any = S.Zero if e.is_nonnegative or e == TIME else -oo
    high: Any = S.Zero if e.is_nonpositive else oo
    bounds = low, high
    if e.is_Add:
        lows, highs = zip(*ends, strict=True)
        bounds = Add(*lows), Add(*highs)
    elif e.is_Mul:
        bounds = _product_range(ends)
    elif e.is_Pow and e.exp.is_negative and _power_falls(e.exp, *ends[0]):
        return ends[0][1] ** e.exp, ends[0][0] ** e.exp
    return Max(low, bounds[0]), Min(high, bounds[1])


def _product_range(ends: list[Interval]) -> Interval:
    """Return the range of a product."""
    product = ends[0]
    for factor in ends[1:]:
        corners = [a * b for a in product for b in factor]
        corners = [S.Zero if c is sympy.nan else c for c in corners]
        product = Min(*corners), Max(*corners)
    return product


def _power_falls(exponent: Expr, low: Any, high: Any) -> bool:
    """Return whether a power with an exponent below zero falls from `low` to `high`."""
    return bool(low.is_positive or (exponent.is_odd and high.is_negative))


def is_positive_maximum(e: Expr) -> bool:
    """Return whether an expression is maximum(a, b) with a > 0 or b > 0."""
    is_maximum = isinstance(e, AppliedUndef) and str(e.func) == "maximum"
    return is_maximum and any(bool(a.is_positive) for a in e.args)


def facts_of(calls: Iterable[Any]) -> list[Expr]:
    """Return expressions that are not negative, of functions as symbols of their own.

    (h - q s)(p s - h) >= 0 of a sector, (h - a)(b - h) >= 0 of a range, and of two calls of a
    function that rises (u - v)(h(u) - h(v)) >= 0.
    """
    facts, calls = [], sorted(calls, key=str)
    for h in calls:
        low, high = interval(h)
        ends = [
            h - low if low.is_finite else S.One,
            high - h if high.is_finite else S.One,
        ]
        facts.append(ends[0] * ends[1])
        sector = fact_of(h).sector
        if sector is not None:
            (s,), (q, p) = h.args, sector
            facts.append((h - q * s) * (p * s - h if p != oo else s))
    for u, v in combinations(calls, 2):
        if u.func == v.func and (fact_of(u).sector or isinstance(u, sympy.exp)):
            rise, run = u - v, u.args[0] - v.args[0]
            is_flat = fact_of(u).sector == (0, 1)
            facts.append(rise * (run - rise) if is_flat else rise * run)
    return [fact for fact in facts if fact != 1]


# --- slopes ---------------------------------------------------------------------------------


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


def along(expression: Expr, rates: dict[Any, Expr]) -> Expr:
    """Return the derivative of an expression along a motion: symbols -> their rates, or 0."""
    rates = dict(rates)  # of subexpressions as well

    def rate(e: Expr) -> Expr:
        if e not in rates:
            rates[e] = chain_rule(e)
        return rates[e]

    def chain_rule(e: Expr) -> Expr:
        if e.is_Atom:
            return S.Zero
        if e.is_Add:
            return Add(*map(rate, e.args))
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
        return Add(*(sympy.diff(e, s) * rate(s) for s in symbols))

    return rate(expression)


def meets_smoothly(V: Expr) -> bool:
    """Return whether V and its slopes agree where the pieces of its functions meet."""
    powers = V.atoms(sympy.Pow)
    if any(not p.exp.is_Integer and not p.base.is_positive for p in powers):
        return False
    return all(_call_meets_smoothly(V, call) for call in functions_in(V))


def _call_meets_smoothly(V: Expr, call: Any) -> bool:
    """Return whether V and its slopes agree where the pieces of one function meet."""
    is_choice = call.func.__name__ in ("where", *LOGIC)
    if is_choice or fact_of(call).kind == "smooth":
        return True  # a choice is judged by the comparisons in it
    pieces = pieces_of(call)
    is_nested = bool(functions_in(Add(*call.args)))
    if not pieces or is_nested:
        return False
    values = [decided(V.xreplace(replaced)) for _, replaced in pieces]
    for j, k in combinations(range(len(pieces)), 2):
        opposite = [expand(-margin) for margin in pieces[k][0]]
        borders = [margin for margin in pieces[j][0] if expand(margin) in opposite]
        if not all(_agrees(values[j] - values[k], border) for border in borders):
            return False
    return True


def _resolved(e: Expr, border: Expr) -> Expr:
    """Return an expression without the functions that are of one piece where a border is zero."""
    border = expand(border)
    for s in sorted(border.free_symbols, key=str):
        slope = sympy.diff(border, s)
        if not slope.is_number or slope == 0:
            continue
        line = {s: expand(s - border / slope)}
        for call in sorted(functions_in(e), key=str):
            for margins, values in pieces_of(call):
                if all(expand(m.xreplace(line)).is_positive for m in margins):
                    return _resolved(decided(e.xreplace(values)), border)
    return e


def _agrees(difference: Expr, border: Expr) -> bool:
    """Return whether a difference vanishes with its slopes where a border is zero."""
    difference = _resolved(difference, border)
    square = expand(expand(border) ** 2)
    symbols = sorted(expand(border).free_symbols, key=str)
    numerator, _ = sympy.fraction(sympy.together(difference))
    try:
        remainder = sympy.rem(expand(numerator), square, *symbols)
    except sympy.PolynomialError:
        return False
    return bool(remainder == 0)


# --- growth ---------------------------------------------------------------------------------


def degree(expression: Expr, is_state: Callable[[sympy.Symbol], bool]) -> float:
    """Return the power of the states with which an expression grows; inf if not known.

    A state that V does not contain exists for all t if |s'| <= a (1 + |s|), a bounded on bounded
    times (Gronwall's lemma); s' = 1 + s^2 escapes at t = pi/2.
    """
    if not any(map(is_state, expression.free_symbols)):
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
