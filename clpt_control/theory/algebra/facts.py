"""Table of facts about nonlinear functions in expressions, such as tanh(s) or clip(s, a, b).

- **sector**: an odd rising h has h(s) = q s with q in a range, so tanh(s) = q s, 0 <= q <= 1;
- **pieces**: clip(s, a, b) is s where s - a >= 0 and b - s >= 0, a where a - s >= 0, ...;
- **range**: the interval of its values, from those of its arguments;
- **growth**: bounded, or at most as fast as (one of) its arguments;
- **kind**: smooth, a kink, a step (constant except where it jumps), or a choice of branches.
"""

from collections.abc import Callable, Iterable
from functools import lru_cache
from itertools import combinations
from math import inf
from operator import ge, gt, le, lt
from typing import Any, Literal, NamedTuple

import sympy
from sympy import Abs, Add, Dummy, Expr, Function, Max, Min, S, exp, log, oo, sympify
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


def _pieces_of_two(call: Any, a: Any, b: Any) -> list[Piece]:
    """Return the pieces of a comparison, or of the larger or the smaller of two."""
    name = call.func.__name__
    margin = a - b if name in ("gt", "ge", "maximum") else b - a
    values = (S.One, S.Zero) if name in COMPARISONS else (a, b)
    return [([margin], {call: values[0]}), ([-margin], {call: values[1]})]


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
        return {SIGN(s): sign, sympy.sign(s): sign, Abs(s): sign * s}

    return [([s], values(S.One)), ([-s], values(-S.One)), ([s, -s], values(S.Zero))]


# --- ranges ---------------------------------------------------------------------------------


def _constant(low: Any, high: Any) -> Callable[..., Interval]:
    """Return a range that does not depend on the arguments."""
    return lambda *ends: (sympify(low), sympify(high))


def _monotone(function: Callable[..., Any]) -> Callable[..., Interval]:
    """Return the range of a function that rises with each argument."""
    return lambda *ends: tuple(function(*values) for values in zip(*ends, strict=True))


def _range_of_choice(*ends: Interval) -> Interval:
    """Return the range of a choice: the first argument selects one of the others."""
    lows, highs = zip(*ends[1:], strict=True)
    return Min(*lows), Max(*highs)


def _range_of_log(ends: Interval) -> Interval:
    low, high = ends
    low = log(low) if low.is_positive else -oo
    return low, log(high) if high.is_positive else oo


def _clip_number(s: Any, low: Any, high: Any) -> Any:
    return Min(Max(s, low), high)


def _extreme(function: Any) -> Fact:
    return Fact(
        "kink",
        "as all",
        pieces=_pieces_of_two,
        range=_monotone(function),
        number=function,
    )


# --- the table ------------------------------------------------------------------------------

TRUTH = _constant(0, 1)
UNIT = _constant(-1, 1)
SMOOTH = "erfc cosh acosh atanh asin acos tan"
FACTS: dict[str, Fact] = {
    "sin": Fact("smooth", "bounded", range=UNIT),
    "cos": Fact("smooth", "bounded", range=UNIT),
    "tanh": Fact("smooth", "bounded", sector=(0, 1), range=_monotone(sympy.tanh)),
    "atan": Fact("smooth", "bounded", sector=(0, 1), range=_monotone(sympy.atan)),
    "atan2": Fact("choice", "bounded"),
    "erf": Fact("smooth", "bounded", sector=(0, 2)),
    "asinh": Fact("smooth", "as all", sector=(0, 1)),
    "sinh": Fact("smooth", sector=(1, oo)),
    "exp": Fact("smooth", range=_monotone(exp)),
    "log": Fact("smooth", range=_range_of_log),
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
        "step",
        "bounded",
        pieces=_pieces_of_clip,
        range=TRUTH,
        number=lambda s, low, high: sympy.Integer(bool(low < s < high)),
    ),
    "floor": Fact("step", "as all", number=sympy.floor),
    "ceil": Fact("step", "as all", number=sympy.ceiling),
    "trunc": Fact(
        "step", "as all", number=lambda s: sympy.sign(s) * sympy.floor(Abs(s))
    ),
    "mod": Fact("choice", "as branches", number=lambda a, b: a % b),
    **dict.fromkeys(
        ("where", "pick"), Fact("choice", "as branches", range=_range_of_choice)
    ),
    **dict.fromkeys(
        COMPARISONS, Fact("step", "bounded", pieces=_pieces_of_two, range=TRUTH)
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


def inputs_in(expression: Expr) -> set[Any]:
    """Return the unknown functions of time alone in an expression."""
    return {*filter(is_input, expression.atoms(AppliedUndef))}


def roots_in(expression: Expr) -> list[Expr]:
    """Return the bases of the powers in an expression that are no whole ones."""
    return [p.base for p in expression.atoms(sympy.Pow) if not p.exp.is_Integer]


def has_time(*expressions: Expr) -> bool:
    """Return whether expressions depend on time by themselves, not by an input alone."""
    total = sympy.Tuple(*expressions)
    slopes = dict.fromkeys(total.atoms(sympy.Derivative), Dummy())
    inputs = dict.fromkeys(inputs_in(total), Dummy())
    return bool(total.xreplace(slopes).xreplace(inputs).has(TIME))


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


def sectors_of(call: Any) -> list[Sector]:
    """Return what is known of a function: its sector, its range, its slope."""
    s, slopes = call.args[0], {"sin": (-1, 1, False, 0), "exp": (0, oo, False, 1)}
    known = [sector_of(call), _range_of(call)]
    if of_slope := slopes.get(call.func.__name__):
        known.append(Sector(s, *of_slope))
    return [*filter(None, dict.fromkeys(known))]


def _range_of(call: Any) -> Sector | None:
    """Return the numbers between which a function is, if there is a lower one."""
    low, high = interval(call)
    return None if low == -inf else Sector(S.One, low, high)


def sector_of(call: Any) -> Sector | None:
    """Return the sector of a function, if it is known, or else its range."""
    name, s = call.func.__name__, call.args[0]
    sector = fact_of(call).sector
    if sector is not None:
        return Sector(s, *sector, rises=True)
    if name in ("sign", "floor", "trunc", "ceil"):
        return Sector(s, 0, oo, rises=name == "sign")
    if name == "clip":
        _, low, high = call.args
        if low.is_nonpositive and high.is_nonnegative:
            return Sector(s, 0, 1, bool(low.is_negative and high.is_positive))
    return _range_of(call)


@lru_cache(maxsize=10_000)
def interval(e: Expr) -> Interval:
    """Return the numbers between which an expression is, for all values of its symbols."""
    if e.is_number and e.is_real:
        return e, e
    ends = [interval(a) for a in e.args]
    # runs begin at t = 0
    low = S.Zero if e.is_nonnegative or e == TIME else -oo
    high = S.Zero if e.is_nonpositive else oo
    bounds = low, high
    if (range_of := fact_of(e).range) is not None:
        bounds = range_of(*ends)
    elif e.is_Add:
        lows, highs = zip(*ends, strict=True)
        bounds = Add(*lows), Add(*highs)
    elif e.is_Mul:
        bounds = _product_range(ends)
    elif e.is_Pow and e.exp.is_negative and _power_falls(e.exp, *ends[0]):
        return ends[0][1] ** e.exp, ends[0][0] ** e.exp
    elif e.is_Pow and e.exp.is_positive and ends[0][0].is_nonnegative:
        bounds = ends[0][0] ** e.exp, ends[0][1] ** e.exp
    elif e.is_Pow and e.exp.is_positive and e.exp.is_even:
        bounds = S.Zero, Max(-ends[0][0], ends[0][1]) ** e.exp
    return Max(low, bounds[0]), Min(high, bounds[1])


def stays_off_zero(e: Expr) -> bool:
    """Return whether an expression stays above a positive number, or below a negative one."""
    low, high = interval(e)
    return bool(low.is_positive or high.is_negative)


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
    return e.func == MAXIMUM and any(bool(a.is_positive) for a in e.args)


def side_of(call: Any) -> Expr | None:
    """Return s of maximum(s, 0) and minimum(s, 0)."""
    is_side = call.func.__name__ in ("maximum", "minimum") and S.Zero in call.args
    return Add(*call.args) if is_side else None


def facts_of(calls: Iterable[Any]) -> list[Expr]:
    """Return expressions that are not negative, of functions as symbols of their own.

    (h - q s)(p s - h) >= 0 of a sector, (h - a)(b - h) >= 0 of a range, and of two calls of a
    function that rises (u - v)(h(u) - h(v)) >= 0.
    """
    facts, calls = [], sorted(calls, key=str)
    for h in calls:
        low, high = interval(h)
        ends = [
            h - low if low.is_Rational else S.One,
            high - h if high.is_Rational else S.One,
        ]
        facts.append(ends[0] * ends[1])
        sector = fact_of(h).sector
        if sector is not None:
            (s,), (q, p) = h.args, sector
            facts.append((h - q * s) * (p * s - h if p != oo else s))
    for u, v in combinations(calls, 2):
        if u.func == v.func and (fact_of(u).sector or isinstance(u, exp)):
            rise, run = u - v, u.args[0] - v.args[0]
            is_flat = fact_of(u).sector == (0, 1)
            facts.append(rise * (run - rise) if is_flat else rise * run)
    return [fact for fact in facts if fact != 1]
