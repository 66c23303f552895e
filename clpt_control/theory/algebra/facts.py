"""Table of facts about nonlinear functions in expressions, such as tanh(s) or clip(s, a, b).

- **sector**: an odd rising h has h(s) = q s with q in a range, so tanh(s) = q s, 0 <= q <= 1;
- **pieces**: clip(s, a, b) is s where s - a >= 0 and b - s >= 0, a where a - s >= 0, ...;
- **range**: the interval of its values, from those of its arguments: of one that rises its
  values at their ends, of exact numbers here and of floats in boxes (`proofs/region.py`);
- **slope**: the interval of its slope, and **Coq**: its name where lemmas know it;
- **growth**: bounded, or at most as fast as (one of) its arguments;
- **kind**: smooth, a kink, a step (constant except where it jumps), or a choice of branches.
"""

from collections.abc import Callable, Iterable, Mapping
from functools import lru_cache
from itertools import combinations
from math import inf
from operator import ge, gt, le, lt
from typing import Any, Literal, NamedTuple

import sympy
from sympy import Abs, Add, Dummy, Expr, Function, Max, Min, S, expand, log, oo, sympify
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
    # whether it never falls with an argument; one with a sector does not
    grows: bool = False
    # ends of the arguments -> ends, if it does not rise
    range: Callable[..., Interval] | None = None
    # carried out where all arguments are numbers
    number: Callable[..., Any] | None = None
    slope: Interval | None = None
    coq: str = ""

    @property
    def rises(self) -> bool:
        """True if no argument makes it fall."""
        return self.grows or self.sector is not None


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


def _range_of_choice(*ends: Interval) -> Interval:
    """Return the range of a choice: the first argument selects one of the others."""
    lows, highs = zip(*ends[1:], strict=True)
    return Min(*lows), Max(*highs)


def _range_of_log(ends: Interval) -> Interval:
    low, high = ends
    low = log(low) if low.is_positive else -oo
    return low, log(high) if high.is_positive else oo


def _truncated(s: Any) -> Any:
    return sympy.sign(s) * sympy.floor(Abs(s))


def _clip_number(s: Any, low: Any, high: Any) -> Any:
    return Min(Max(s, low), high)


# --- the table ------------------------------------------------------------------------------


def _extreme(function: Any, coq: str) -> Fact:
    pieces = _pieces_of_two
    return Fact("kink", "as all", None, pieces, True, number=function, coq=coq)


TRUTH = _constant(0, 1)
UNIT = _constant(-1, 1)
FACTS: dict[str, Fact] = {
    "sin": Fact("smooth", "bounded", range=UNIT, slope=(-1, 1), coq="sin"),
    "cos": Fact("smooth", "bounded", range=UNIT, coq="cos"),
    "tanh": Fact("smooth", "bounded", (0, 1), coq="tanh"),
    "atan": Fact("smooth", "bounded", (0, 1), coq="atan"),
    "atan2": Fact("choice", "bounded"),
    "erf": Fact("smooth", "bounded", (0, 2)),
    "asinh": Fact("smooth", "as all", (0, 1)),
    "sinh": Fact("smooth", sector=(1, oo), coq="sinh"),
    "cosh": Fact("smooth", range=_constant(1, oo), coq="cosh"),
    "exp": Fact("smooth", grows=True, slope=(0, oo), coq="exp"),
    "log": Fact("smooth", grows=True, range=_range_of_log, coq="ln"),
    **dict.fromkeys(("erfc", "acosh", "atanh", "asin", "acos", "tan"), Fact("smooth")),
    "Abs": Fact("kink", "as all", pieces=_pieces_of_sign, coq="Rabs"),
    "clip": Fact(
        "kink",
        "as branches",
        pieces=_pieces_of_clip,
        grows=True,
        number=_clip_number,
        coq="clip",
    ),
    "maximum": _extreme(Max, "Rmax"),
    "minimum": _extreme(Min, "Rmin"),
    "sign": Fact("step", "bounded", (0, oo), _pieces_of_sign, number=sympy.sign),
    "inside": Fact(
        "step",
        "bounded",
        pieces=_pieces_of_clip,
        range=TRUTH,
        number=lambda s, low, high: sympy.Integer(bool(low < s < high)),
    ),
    "floor": Fact("step", "as all", (0, oo), number=sympy.floor),
    "ceil": Fact("step", "as all", (0, oo), number=sympy.ceiling),
    "trunc": Fact("step", "as all", (0, oo), number=_truncated),
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
SMOOTH = {
    getattr(sympy, name): fact for name, fact in FACTS.items() if fact.kind == "smooth"
}
ODD = tuple(f for f, fact in SMOOTH.items() if fact.sector)
RISING = tuple(f for f, fact in SMOOTH.items() if fact.rises)
BOUNDED = tuple(f for f, fact in SMOOTH.items() if fact.growth == "bounded")
# with lemmas in Runs.v
IN_COQ = Abs, *(f for f, fact in SMOOTH.items() if fact.coq)


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


def corners(e: Expr, sectors: Mapping[Any, Sector]) -> dict[tuple, Expr]:
    """Return the ends of symbols -> an expression there; nothing unless it is convex in each.

    It is at most the largest of the values.  Of a ratio without an upper end the slope counts.
    """
    found: dict[tuple, Expr] = {(): e}
    for s, (factor, low, high, _, offset) in sectors.items():
        bends = [at.diff(s, 2) for at in found.values()]
        if not all(b == 0 or (b.is_nonnegative and high < oo) for b in bends):
            return {}
        found = {
            (*ends, end): expand(
                factor * at.diff(s)
                if end == oo
                else at.xreplace({s: end * factor + offset})
            )
            for ends, at in found.items()
            for end in (low, high)
        }
    return found


def sectors_of(call: Any) -> list[Sector]:
    """Return what is known of a function: its sector, its range, its slope."""
    known, (low, high) = [sector_of(call)], interval(call)
    if low != -inf:
        known.append(Sector(S.One, low, high))
    if slope := fact_of(call).slope:
        known.append(Sector(call.args[0], *slope, offset=call.func(0)))
    return [*filter(None, known)]


def sector_of(call: Any) -> Sector | None:
    """Return the sector of a function, if it is known."""
    name, s, (kind, _, sector, *_) = call.func.__name__, call.args[0], fact_of(call)
    if sector is not None:
        return Sector(s, *sector, rises=kind == "smooth" or name == "sign")
    if name == "clip":
        _, low, high = call.args
        if low.is_nonpositive and high.is_nonnegative:
            return Sector(s, 0, 1, bool(low.is_negative and high.is_positive))
    return None


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
    fact = fact_of(e)
    if fact.range is not None:
        bounds = fact.range(*ends)
    elif fact.rises:
        bounds = tuple(map(fact.number or e.func, *ends))
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


# from -1 to 1
RANGED = tuple(f for f in BOUNDED if interval(f(Dummy(real=True)))[1] == 1)


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
        if u.func == v.func and fact_of(u).rises and not v.args[1:]:
            rise, run = u - v, u.args[0] - v.args[0]
            is_flat = fact_of(u).sector == (0, 1)
            facts.append(rise * (run - rise) if is_flat else rise * run)
    return [fact for fact in facts if fact != 1]
