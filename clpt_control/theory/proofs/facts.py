"""Facts about nonlinear functions in expressions: one table.

A row says of a function, such as tanh(s) or clip(s, a, b), what proofs may use:

- **sector**: an odd rising h has h(s) = q s with q in a range, so tanh(s) = q s, 0 <= q <= 1;
- **pieces**: clip(s, a, b) is s where s - a >= 0 and b - s >= 0, a where a - s >= 0, ...;
- **range**: the interval in which it lies, from those of its arguments;
- **growth**: bounded, or at most as fast as (one of) its arguments;
- **kind**: smooth, a kink, a step (constant but where it jumps), or a choice of branches.

Where pieces meet with one slope, V' is that of each piece (`meets_smoothly`).  A V with a kink
decreases too where each piece says so, if rates are continuous: a motion that stays on the kink has
the slope of both sides.  Where rates jump it may slide along the kink, and V rise.

A state s that V does not contain, with |s'| <= a (1 + |s|), a bounded on bounded times, exists for
all t (Gronwall's lemma); s' = 1 + s^2 escapes at t = pi/2.  `degree` is that power of the states.
"""

from collections.abc import Callable
from functools import lru_cache
from itertools import combinations
from math import inf
from operator import ge, gt, le, lt
from typing import Any, Literal, NamedTuple

import sympy
from sympy.core.function import AppliedUndef

from ...engine.diagram.symbol_names import TIME
from ...engine.record.symbolic import ON_NUMBERS
from .every_n import SUM

# --- functions that SymPy leaves as they are ------------------------------------------------

INSIDE = sympy.Function("inside", real=True)  # 1 where clip(s, a, b) is s, else 0
CLIP = sympy.Function("clip", real=True)
GT = sympy.Function("gt", real=True)
SIGN = sympy.Function("sign", real=True)
WHERE = sympy.Function("where", real=True)
MAXIMUM = sympy.Function("maximum", real=True)
COMPARISONS: dict[str, Callable[..., Any]] = {"gt": gt, "ge": ge, "lt": lt, "le": le}
LOGIC: dict[str, Callable[..., Any]] = {
    "and_": lambda a, b: a * b,
    "or_": lambda a, b: a + b - a * b,
    "not_": lambda a: 1 - a,
}
NUMPY_OF = {**ON_NUMBERS, "inside": lambda s, low, high: (low < s) & (s < high)}

Interval = tuple[Any, Any]
# expressions that are not negative in the piece, and values of functions there
Piece = tuple[list[sympy.Expr], dict[Any, Any]]


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


def _pieces_of_comparison(name: str, a: Any, b: Any) -> list[Piece]:
    margin = a - b if name in ("gt", "ge") else b - a
    call = sympy.Function(name, real=True)(a, b)
    return [([margin], {call: sympy.S.One}), ([-margin], {call: sympy.S.Zero})]


def _pieces_of_extreme(name: str, a: Any, b: Any) -> list[Piece]:
    call = sympy.Function(name, real=True)(a, b)
    margin = a - b if name == "maximum" else b - a
    return [([margin], {call: a}), ([-margin], {call: b})]


def _pieces_of_clip(name: str, s: Any, low: Any, high: Any) -> list[Piece]:
    if not (high - low).is_nonnegative:
        return []
    clip, inside = CLIP(s, low, high), INSIDE(s, low, high)
    return [
        ([s - low, high - s], {clip: s, inside: sympy.S.One}),
        ([low - s], {clip: low, inside: sympy.S.Zero}),
        ([s - high], {clip: high, inside: sympy.S.Zero}),
    ]


def _pieces_of_sign(name: str, s: Any) -> list[Piece]:
    signs = SIGN(s), sympy.sign(s)
    sides = (([s], sympy.S.One), ([-s], -sympy.S.One), ([s, -s], sympy.S.Zero))
    return [
        (conditions, {sympy.Abs(s): side * s} | dict.fromkeys(signs, side))
        for conditions, side in sides
    ]


# --- ranges ---------------------------------------------------------------------------------


def _between(low: Any, high: Any) -> Callable[..., Interval]:
    return lambda *ends: (sympy.sympify(low), sympy.sympify(high))


def _rising(function: Callable[..., Any]) -> Callable[..., Interval]:
    """Return the range of a function that rises with each argument."""
    return lambda *ends: tuple(function(*values) for values in zip(*ends, strict=True))


def _of_branches(*ends: Interval) -> Interval:
    """Return the range of one of some branches; the first argument chooses."""
    lows, highs = zip(*ends[1:], strict=True)
    return sympy.Min(*lows), sympy.Max(*highs)


def _of_exp(ends: Interval) -> Interval:
    high = sympy.oo if ends[1] == sympy.oo else sympy.exp(ends[1])
    return sympy.S.Zero, high


def _clip_number(s: Any, low: Any, high: Any) -> Any:
    return sympy.Min(sympy.Max(s, low), high)


# --- the table ------------------------------------------------------------------------------

ZERO_ONE = _between(0, 1)
ONE_EACH = _between(-1, 1)
FACTS: dict[str, Fact] = {
    "sin": Fact("smooth", "bounded", range=ONE_EACH),
    "cos": Fact("smooth", "bounded", range=ONE_EACH),
    "tanh": Fact("smooth", "bounded", (0, 1), range=ONE_EACH),
    "atan": Fact("smooth", "bounded", (0, 1)),
    "atan2": Fact("choice", "bounded"),
    "erf": Fact("smooth", "bounded", (0, 2)),
    "erfc": Fact("smooth"),
    "asinh": Fact("smooth", "as all", (0, 1)),
    "sinh": Fact("smooth", sector=(1, sympy.oo)),
    "cosh": Fact("smooth"),
    "acosh": Fact("smooth"),
    "atanh": Fact("smooth"),
    "asin": Fact("smooth"),
    "acos": Fact("smooth"),
    "tan": Fact("smooth"),
    "exp": Fact("smooth", range=_of_exp),
    "log": Fact("smooth"),
    "Abs": Fact("kink", "as all", pieces=_pieces_of_sign),
    "clip": Fact(
        "kink",
        "as branches",
        pieces=_pieces_of_clip,
        range=_rising(_clip_number),
        number=_clip_number,
    ),
    "maximum": Fact(
        "kink",
        "as all",
        pieces=_pieces_of_extreme,
        range=_rising(sympy.Max),
        number=sympy.Max,
    ),
    "minimum": Fact(
        "kink",
        "as all",
        pieces=_pieces_of_extreme,
        range=_rising(sympy.Min),
        number=sympy.Min,
    ),
    "sign": Fact(
        "step", "bounded", pieces=_pieces_of_sign, range=ONE_EACH, number=sympy.sign
    ),
    "inside": Fact(
        "step",
        "bounded",
        pieces=_pieces_of_clip,
        range=ZERO_ONE,
        number=lambda s, low, high: sympy.Integer(bool(low < s) and bool(s < high)),
    ),
    "floor": Fact("step", "as all"),
    "trunc": Fact("step", "as all"),
    "ceil": Fact("step", "as all"),
    "mod": Fact("choice", "as branches", number=lambda a, b: a % b),
    "where": Fact("choice", "as branches", range=_of_branches),
    "pick": Fact("choice", "as branches", range=_of_branches),
    **{
        name: Fact("step", "bounded", pieces=_pieces_of_comparison, range=ZERO_ONE)
        for name in COMPARISONS
    },
    **{name: Fact("step", "bounded", range=ZERO_ONE) for name in LOGIC},
}
UNKNOWN = Fact("choice")
# functions of SymPy that are odd and rise
ODD = tuple(getattr(sympy, name) for name, fact in FACTS.items() if fact.sector)


def fact_of(call: sympy.Expr) -> Fact:
    """Return what is known of a function in an expression."""
    return FACTS.get(call.func.__name__, UNKNOWN)


# --- functions in expressions ---------------------------------------------------------------


def functions_in(expression: sympy.Expr) -> set[Any]:
    """Return the functions in an expression, but for numbers, sums and functions of time alone."""
    calls = expression.atoms(sympy.Function)
    return {f for f in calls if not (is_input(f) or f.func == SUM or f.is_number)}


def is_input(call: Any) -> bool:
    """Return whether a function is an unknown function of time alone, as the inputs are."""
    is_of_time = isinstance(call, AppliedUndef) and [str(a) for a in call.args] == ["t"]
    return is_of_time and call.func.__name__ not in NUMPY_OF


def decided(expression: sympy.Expr) -> sympy.Expr:
    """Return an expression where comparisons and choices of numbers are carried out."""

    def outcome(call: Any) -> Any:
        name, arguments = call.func.__name__, call.args
        if name == "where" and arguments[0].is_number:
            return arguments[1] if arguments[0] != 0 else arguments[2]
        if name in COMPARISONS:
            truth = COMPARISONS[name](*arguments)
            return sympy.Integer(bool(truth)) if truth in (True, False) else call
        if name in LOGIC:
            is_known = any(a.is_number for a in arguments)
            return (
                LOGIC[name](*arguments) if is_known and _are_truths(arguments) else call
            )
        number = fact_of(call).number
        if number is not None and all(a.is_number for a in arguments):
            return number(*arguments)
        return call

    return expression.replace(lambda e: isinstance(e, AppliedUndef), outcome)


def _are_truths(arguments: tuple) -> bool:
    """Return whether each argument is 0 or 1."""
    return all(
        a in (0, 1) or a.func.__name__ in (*COMPARISONS, *LOGIC) for a in arguments
    )


def pieces_of(call: Any) -> list[Piece]:
    """Return the pieces of a function; none where it is not known to be made of any."""
    pieces = fact_of(call).pieces
    return [] if pieces is None else pieces(call.func.__name__, *call.args)


def is_smooth(expression: sympy.Expr) -> bool:
    """Return whether an expression has no functions with pieces or jumps."""
    return all(fact_of(call).kind == "smooth" for call in functions_in(expression))


def is_continuous(expression: sympy.Expr) -> bool:
    """Return whether an expression is known to jump nowhere where it has a value."""
    kinds = {fact_of(call).kind for call in functions_in(expression)}
    return kinds <= {"smooth", "kink"}


# --- sectors and ranges ---------------------------------------------------------------------


class Sector(NamedTuple):
    """A function is q times `factor`, q between `low` and `high`, plus `offset`."""

    factor: sympy.Expr
    low: Any
    high: Any  # oo where there is no end
    rises: bool = False  # whether q > 0 but at s = 0, and s h(s) never falls with |s|
    offset: Any = 0


def sector_of(call: Any, by_slope: bool = False) -> Sector | None:
    """Return the sector of a function, if it is known; of a sine or exp by its slope."""
    name, s = call.func.__name__, call.args[0]
    if by_slope and name == "sin":
        return Sector(s, -1, 1)
    if by_slope and name == "exp":
        return Sector(s, 0, sympy.oo, offset=1)
    if (ends := fact_of(call).sector) is not None:
        return Sector(s, ends[0], ends[1], True)
    if name in ("sign", "floor", "trunc", "ceil"):
        return Sector(s, 0, sympy.oo, name == "sign")
    if name == "clip" and call.args[1].is_nonpositive and call.args[2].is_nonnegative:
        rises = bool(call.args[1].is_negative and call.args[2].is_positive)
        return Sector(s, 0, 1, rises)
    if name in ("maximum", "minimum") and 0 in call.args:
        return Sector(sympy.Add(*call.args), 0, 1)
    low, high = interval(call)
    return None if low == -inf else Sector(sympy.Integer(1), low, high)


@lru_cache(maxsize=10_000)
def interval(e: sympy.Expr) -> Interval:
    """Return the numbers between which an expression lies, whatever its symbols are."""
    if e.is_number and e.is_real:
        return e, e
    # runs begin at t = 0
    low: Any = sympy.S.Zero if e.is_nonnegative or e == TIME else -sympy.oo
    high: Any = sympy.S.Zero if e.is_nonpositive else sympy.oo
    ends = [interval(a) for a in e.args]
    fact = fact_of(e)
    if fact.range is not None:
        return fact.range(*ends)
    if e.is_Add:
        low = sympy.Max(low, sympy.Add(*(a for a, _ in ends)))
        high = sympy.Min(high, sympy.Add(*(b for _, b in ends)))
    elif e.is_Mul or (e.is_Pow and e.exp == 2):
        product = _product_range(ends if e.is_Mul else [ends[0], ends[0]])
        low, high = sympy.Max(low, product[0]), sympy.Min(high, product[1])
    elif e.is_Pow and e.exp.is_negative and _power_falls(e.exp, *ends[0]):
        low, high = ends[0][1] ** e.exp, ends[0][0] ** e.exp
    return low, high


def _product_range(ends: list[Interval]) -> Interval:
    """Return the range of a product."""
    product = ends[0]
    for factor in ends[1:]:
        corners = [a * b for a in product for b in factor]
        corners = [sympy.S.Zero if c is sympy.nan else c for c in corners]
        product = sympy.Min(*corners), sympy.Max(*corners)
    return product


def _power_falls(exponent: sympy.Expr, low: Any, high: Any) -> bool:
    """Return whether a power with an exponent below zero falls from `low` to `high`."""
    return bool(low.is_positive or (exponent.is_odd and high.is_negative))


def positive_maximum(f: sympy.Expr) -> bool:
    """Return whether an expression is maximum(a, b) with a positive one."""
    is_maximum = isinstance(f, AppliedUndef) and str(f.func) == "maximum"
    return is_maximum and any(bool(a.is_positive) for a in f.args)


# --- slopes ---------------------------------------------------------------------------------


def slope_of(call: Any, along: Callable[[sympy.Expr], sympy.Expr]) -> sympy.Expr | None:
    """Return the derivative of a function with pieces, by those of its arguments; else None."""
    name, arguments = call.func.__name__, call.args
    rates = [along(a) for a in arguments]
    if name == "clip" and rates[1:] == [0, 0]:
        return INSIDE(*arguments) * rates[0]
    if name == "Abs":
        return SIGN(arguments[0]) * rates[0]
    if name in ("where", "pick"):
        return call.func(arguments[0], *rates[1:])
    if name in ("maximum", "minimum"):
        first, second = arguments if name == "maximum" else arguments[::-1]
        return WHERE(GT(first, second), *rates)
    return sympy.S.Zero if fact_of(call).kind == "step" else None


def along(expression: sympy.Expr, rates: dict[Any, sympy.Expr]) -> sympy.Expr:
    """Return the derivative of an expression along a motion: symbols -> their rates, or 0."""
    known = dict(rates)

    def rate(e: sympy.Expr) -> sympy.Expr:
        if e not in known:
            known[e] = slope(e)
        return known[e]

    def slope(e: sympy.Expr) -> sympy.Expr:
        if e.is_Atom:
            return sympy.Integer(0)
        if e.is_Add:
            return sympy.Add(*map(rate, e.args))
        if e.is_Mul:
            moving = [k for k, a in enumerate(e.args) if rate(a) != 0]
            rest = (sympy.Mul(*e.args[:k], *e.args[k + 1 :]) for k in moving)
            terms = (rate(e.args[k]) * b for k, b in zip(moving, rest, strict=True))
            return sympy.Add(*terms)
        if e.is_Pow and e.exp.is_Number:
            return e.exp * e.base ** (e.exp - 1) * rate(e.base)
        if (derivative := slope_of(e, rate)) is not None:
            return derivative
        is_known = isinstance(e, sympy.Function) and not isinstance(e, AppliedUndef)
        if is_known and len(e.args) == 1:
            return e.fdiff() * rate(e.args[0])
        moving = [s for s in e.free_symbols if rate(s) != 0]
        return sympy.Add(*(sympy.diff(e, s) * rate(s) for s in moving))

    return rate(expression)


def meets_smoothly(V: sympy.Expr) -> bool:
    """Return whether V and its slopes agree where the pieces of its functions meet."""
    powers = V.atoms(sympy.Pow)
    if any(not p.exp.is_Integer and not p.base.is_positive for p in powers):
        return False
    for call in functions_in(V):
        if fact_of(call).kind == "smooth" or call.func.__name__ in ("where", *LOGIC):
            continue  # a choice is judged by the comparisons in it
        pieces = pieces_of(call)
        if not pieces or functions_in(sympy.Add(*call.args)):
            return False
        values = [decided(V.xreplace(replaced)) for _, replaced in pieces]
        for j, k in combinations(range(len(pieces)), 2):
            opposite = [sympy.expand(-margin) for margin in pieces[k][0]]
            borders = [u for u in pieces[j][0] if sympy.expand(u) in opposite]
            if not all(_agrees(values[j] - values[k], u) for u in borders):
                return False
    return True


def _agrees(difference: sympy.Expr, border: sympy.Expr) -> bool:
    """Return whether a difference vanishes with its slopes where a border is zero."""
    border = sympy.expand(border)
    gens = sorted(border.free_symbols, key=str)
    numerator, _ = sympy.fraction(sympy.together(difference))
    try:
        rest = sympy.rem(sympy.expand(numerator), sympy.expand(border**2), *gens)
    except sympy.PolynomialError:
        return False
    return bool(rest == 0)


# --- growth ---------------------------------------------------------------------------------


def degree(expression: sympy.Expr, is_state: Callable[[sympy.Symbol], bool]) -> float:
    """Return the power of the states with which an expression grows; inf if it is not known."""
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
        # a base that stays away from zero
        return 0.0 if interval(expression.base)[0].is_positive else inf
    growth = fact_of(expression).growth
    if growth == "as branches":  # whatever the first argument is
        return max(degrees[1:])
    return {"bounded": 0.0, "as all": max(degrees)}.get(growth, inf)
