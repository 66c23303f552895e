"""Words: their sectors, pieces, slopes and growth.

A word is a function in an expression that is no polynomial: tanh(s), clip(s, -a, a), ...

- **Sector.**  An odd rising h has s h(s) >= 0: h(s) = q s, q in a range, so tanh(s) = q s with
  0 <= q <= 1.  sin(s) is q in -1 ... 1, and q s too; |s| is q >= 0; exp(s) is q, and 1 + q s.
  An expression convex in q is never positive where it is not at the ends of q's range.
- **Pieces.**  clip(s, a, b) is s where s - a >= 0 and b - s >= 0, a where a - s >= 0, b where
  s - b >= 0; a comparison is 1 or 0.  What holds in each piece holds.
- **Slopes.**  Where pieces meet with one slope, V' is that of each piece (`meets_smoothly`).  A V
  with a kink falls too where its own pieces say so, if rates are continuous: a motion that stays on
  the kink has the slope of both sides.  Where rates jump it may slide along the kink, and V rise.

A state s that V does not hold, with |s'| <= a (1 + |s|) where a is bounded on bounded times, exists
for all t (Gronwall's lemma); s' = 1 + s^2 ends at t = pi/2, and with it the run.  How fast an
expression grows with such states is its degree: 0 is bounded, 1 is linear.
"""

from collections.abc import Callable
from functools import lru_cache
from math import inf
from operator import ge, gt, le, lt
from typing import Any, NamedTuple

import sympy
from sympy.core.function import AppliedUndef

from ...engine.diagram.symbol_names import TIME
from ...engine.record.symbolic import ON_NUMBERS
from .every_n import SUM

INSIDE = sympy.Function("inside", real=True)  # 1 where clip(s, a, b) is s, else 0
CLIP = sympy.Function("clip", real=True)
GT = sympy.Function("gt", real=True)
SIGN = sympy.Function("sign", real=True)
WHERE = sympy.Function("where", real=True)
MAXIMUM = sympy.Function("maximum", real=True)
COMPARED: dict[str, Callable[..., Any]] = {"gt": gt, "ge": ge, "lt": lt, "le": le}
DECIDED: dict[
    str, Callable[..., Any]
] = {  # carried out where their arguments are numbers
    "mod": lambda a, b: a % b,
    "clip": lambda a, low, high: sympy.Min(sympy.Max(a, low), high),
    "inside": lambda a, low, high: sympy.Integer(bool(low < a) and bool(a < high)),
    **{"maximum": sympy.Max, "minimum": sympy.Min, "sign": sympy.sign},
}
YES_OR_NO: dict[str, Callable[..., Any]] = {
    "and_": lambda a, b: a * b,
    "or_": lambda a, b: a + b - a * b,
    "not_": lambda a: 1 - a,
}
ODD: dict[Any, tuple[Any, Any]] = {  # odd and rising: h -> the range of h(s)/s
    **dict.fromkeys((sympy.tanh, sympy.atan, sympy.asinh), (0, 1)),
    sympy.erf: (0, 2),
    sympy.sinh: (1, sympy.oo),
}

SMOOTH = (  # where they have a value
    *(
        sympy.sin,
        sympy.cos,
        sympy.tan,
        sympy.asin,
        sympy.acos,
        sympy.exp,
        sympy.log,
        sympy.erfc,
    ),
    *(sympy.cosh, sympy.acosh, sympy.atanh, *ODD),
)
CONTINUOUS = ("Abs", "clip", "minimum", "maximum")
STEPS = ("sign", "inside", "floor", "trunc", "ceil")  # constant but where they jump

NUMBERS_OF = {**ON_NUMBERS, "inside": lambda u, low, high: (low < u) & (u < high)}


def decided(expression: sympy.Expr) -> sympy.Expr:
    """Return an expression where comparisons and choices of what is known are carried out."""

    def done(e: Any) -> Any:
        name = e.func.__name__
        if name == "where" and e.args[0].is_number:
            return e.args[1] if e.args[0] != 0 else e.args[2]
        if name in COMPARED and COMPARED[name](*e.args) in (True, False):
            return sympy.Integer(bool(COMPARED[name](*e.args)))
        if name in DECIDED and all(a.is_number for a in e.args):
            return DECIDED[name](*e.args)
        if (
            name in YES_OR_NO
            and any(a.is_number for a in e.args)
            and all(map(_is_0_or_1, e.args))
        ):
            return YES_OR_NO[name](*e.args)
        return e

    return expression.replace(lambda e: isinstance(e, AppliedUndef), done)


def _is_0_or_1(e: sympy.Expr) -> bool:
    return e in (0, 1) or e.func.__name__ in (*COMPARED, *YES_OR_NO)


def words_of(expression: sympy.Expr) -> set[Any]:
    """Return the words of an expression; functions of time alone, and numbers, are none."""
    words = expression.atoms(sympy.Function)
    return {w for w in words if not (is_input(w) or w.func == SUM or w.is_number)}


def is_input(word: Any) -> bool:
    """Return whether a word is an unknown function of time alone, as the inputs are."""
    of_time = isinstance(word, AppliedUndef) and [str(a) for a in word.args] == ["t"]
    return of_time and word.func.__name__ not in NUMBERS_OF


class Sector(NamedTuple):
    """A word is q times `factor`, q between `low` and `high`, and more."""

    factor: sympy.Expr
    low: Any
    high: Any  # oo where there is no end
    rises: bool = False  # whether q > 0 but at s = 0, and s h(s) never falls with |s|
    more: Any = 0


def sector_of(word: Any, slope: bool = False) -> Sector | None:
    """Return the sector that a word lies in, if that is known; of a sine or exp by its slope."""
    name, s = word.func.__name__, word.args[0]
    if slope and isinstance(word, sympy.sin):
        return Sector(s, -1, 1)
    if slope and isinstance(word, sympy.exp):
        return Sector(s, 0, sympy.oo, more=1)
    if word.func in ODD:
        return Sector(s, *ODD[word.func], True)
    if name in ("sign", "floor", "trunc", "ceil"):
        return Sector(s, 0, sympy.oo, name == "sign")
    if name == "clip" and word.args[1].is_nonpositive and word.args[2].is_nonnegative:
        return Sector(
            s, 0, 1, bool(word.args[1].is_negative and word.args[2].is_positive)
        )
    if name in ("maximum", "minimum") and 0 in word.args:
        return Sector(sympy.Add(*word.args), 0, 1)
    low, high = interval(word)
    return None if low == -inf else Sector(sympy.Integer(1), low, high)


def _falls(exponent: sympy.Expr, low: Any, high: Any) -> bool:
    """Return whether a power with an exponent below zero falls from `low` to `high`."""
    return bool(low.is_positive or (exponent.is_odd and high.is_negative))


@lru_cache(maxsize=10_000)
def interval(e: sympy.Expr) -> tuple[Any, Any]:
    """Return the numbers between which an expression lies, whatever its symbols are."""
    if e.is_number and e.is_real:
        return e, e
    name = e.func.__name__
    if name in ("inside", *COMPARED, *YES_OR_NO):
        return sympy.S.Zero, sympy.S.One
    of = [interval(a) for a in (e.args[1:] if name in ("where", "pick") else e.args)]
    # runs begin at 0
    low: Any = sympy.S.Zero if e.is_nonnegative or e == TIME else -sympy.oo
    high: Any = sympy.S.Zero if e.is_nonpositive else sympy.oo
    if isinstance(e, sympy.sin | sympy.cos | sympy.tanh) or name == "sign":
        low, high = sympy.S.NegativeOne, sympy.S.One
    elif name in ("clip", "maximum", "minimum"):  # which rise in each argument
        low, high = (DECIDED[name](*ends) for ends in zip(*of, strict=True))
    elif name in ("where", "pick"):
        lows, highs = zip(*of, strict=True)
        low, high = sympy.Min(*lows), sympy.Max(*highs)
    elif isinstance(e, sympy.exp) and of[0][1] != sympy.oo:
        high = sympy.exp(of[0][1])
    elif e.is_Add:
        low = sympy.Max(low, sympy.Add(*(a for a, _ in of)))
        high = sympy.Min(high, sympy.Add(*(b for _, b in of)))
    elif e.is_Mul or (e.is_Pow and e.exp == 2):
        ends = of if e.is_Mul else [of[0]] * 2
        product = ends[0]
        for other in ends[1:]:
            corners = [a * b for a in product for b in other]
            corners = [sympy.S.Zero if c is sympy.nan else c for c in corners]
            product = sympy.Min(*corners), sympy.Max(*corners)
        low, high = sympy.Max(low, product[0]), sympy.Min(high, product[1])
    elif e.is_Pow and e.exp.is_negative and _falls(e.exp, *of[0]):
        low, high = of[0][1] ** e.exp, of[0][0] ** e.exp
    return low, high


# what is not negative there -> what words are
Piece = tuple[list[sympy.Expr], dict[Any, Any]]


def pieces_of(word: Any) -> list[Piece]:
    """Return the pieces of a word; none where it is not known to be made of any."""
    name, args = word.func.__name__, word.args
    if name in COMPARED:
        more = args[0] - args[1] if name in ("gt", "ge") else args[1] - args[0]
        return [([more], {word: sympy.S.One}), ([-more], {word: sympy.S.Zero})]
    if name in ("maximum", "minimum"):
        a, b = args if name == "maximum" else args[::-1]
        return [([a - b], {word: args[0]}), ([b - a], {word: args[1]})]
    if name in ("clip", "inside"):
        u, low, high = args
        if not (high - low).is_nonnegative:
            return []
        whole, within = CLIP(*args), INSIDE(*args)
        return [
            ([u - low, high - u], {whole: u, within: sympy.S.One}),
            ([low - u], {whole: low, within: sympy.S.Zero}),
            ([u - high], {whole: high, within: sympy.S.Zero}),
        ]
    if name in ("Abs", "sign"):
        (u,) = args
        signs = SIGN(u), sympy.sign(u)
        return [
            (facts, {sympy.Abs(u): side * u} | dict.fromkeys(signs, side))
            for facts, side in (
                ([u], sympy.S.One),
                ([-u], -sympy.S.One),
                ([u, -u], sympy.S.Zero),
            )
        ]
    return []


def slope_of(word: Any, along: Callable[[sympy.Expr], sympy.Expr]) -> sympy.Expr | None:
    """Return the derivative of a word whose pieces meet smoothly, by those of its arguments."""
    name, args = word.func.__name__, word.args
    rates = [along(a) for a in args]
    if name == "clip" and rates[1:] == [0, 0]:
        return INSIDE(*args) * rates[0]
    if name == "Abs":
        return SIGN(args[0]) * rates[0]
    if name in ("where", "pick"):
        return word.func(args[0], *rates[1:])
    if name in ("maximum", "minimum"):
        a, b = args if name == "maximum" else args[::-1]
        return WHERE(GT(a, b), rates[0], rates[1])
    return sympy.S.Zero if name in (*STEPS, *COMPARED, *YES_OR_NO) else None


def along(expression: sympy.Expr, known: dict[Any, sympy.Expr]) -> sympy.Expr:
    """Return the derivative of an expression along a motion: symbols -> their rates, or 0."""

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
            return sympy.Add(
                *(rate(e.args[k]) * b for k, b in zip(moving, rest, strict=True))
            )
        if e.is_Pow and e.exp.is_Number:
            return e.exp * e.base ** (e.exp - 1) * rate(e.base)
        if (derivative := slope_of(e, rate)) is not None:
            return derivative
        if (
            isinstance(e, sympy.Function)
            and not isinstance(e, AppliedUndef)
            and len(e.args) == 1
        ):
            return e.fdiff() * rate(e.args[0])
        return sympy.Add(
            *(sympy.diff(e, s) * rate(s) for s in e.free_symbols if rate(s) != 0)
        )

    return rate(expression)


def meets_smoothly(V: sympy.Expr) -> bool:
    """Return whether V and its slopes agree where the pieces of its words meet."""
    if any(not p.exp.is_Integer and not p.base.is_positive for p in V.atoms(sympy.Pow)):
        return False
    for word in (w for w in words_of(V) if not isinstance(w, SMOOTH)):
        if word.func.__name__ in ("where", *YES_OR_NO):
            continue  # by the comparisons in it
        pieces = pieces_of(word)
        if not pieces or words_of(sympy.Add(*word.args)):
            return False
        values = [decided(V.xreplace(known)) for _, known in pieces]
        for k, (here, _) in enumerate(pieces):
            for j, (there, _) in enumerate(pieces):
                meet = [u for u in here if any(sympy.expand(u + v) == 0 for v in there)]
                if j > k and any(not _smooth(values[k] - values[j], u) for u in meet):
                    return False
    return True


def is_smooth(expression: sympy.Expr) -> bool:
    """Return whether an expression has no words with pieces or jumps."""
    return all(isinstance(word, SMOOTH) for word in words_of(expression))


def is_continuous(expression: sympy.Expr) -> bool:
    """Return whether an expression is known to jump nowhere where it has a value."""
    return all(
        isinstance(w, SMOOTH) or w.func.__name__ in CONTINUOUS
        for w in words_of(expression)
    )


def _smooth(apart: sympy.Expr, u: sympy.Expr) -> bool:
    """Return whether a difference vanishes with its slopes where u = 0."""
    u, gens = sympy.expand(u), sorted(u.free_symbols, key=str)
    apart, _ = sympy.fraction(sympy.together(apart))
    try:
        return sympy.rem(sympy.expand(apart), sympy.expand(u**2), *gens) == 0
    except sympy.PolynomialError:
        return False


BOUNDED = (sympy.sin, sympy.cos, sympy.tanh, sympy.atan, sympy.atan2, sympy.erf)
AS_ITS_PARTS = ("Abs", "minimum", "maximum", "floor", "trunc", "ceil", "asinh")
AS_ITS_OTHERS = ("where", "pick", "clip", "mod")  # whatever the first argument is


def degree(expression: sympy.Expr, is_state: Callable[[sympy.Symbol], bool]) -> float:
    """Return the highest power of the states that an expression grows with; inf if not known."""
    if not any(map(is_state, expression.free_symbols)):
        return 0.0
    if expression.is_Symbol:
        return 1.0
    of, name = [degree(one, is_state) for one in expression.args], str(expression.func)
    if isinstance(expression, BOUNDED) or name in (
        "sign",
        "inside",
        *COMPARED,
        *YES_OR_NO,
    ):
        return 0.0
    if expression.is_Mul:
        return sum(of)
    if expression.is_Add or name in AS_ITS_PARTS:
        return max(of)
    if name in AS_ITS_OTHERS:
        return max(of[1:])
    if isinstance(expression, SUM):
        return of[0]
    if isinstance(expression, sympy.exp):
        return 0.0 if expression.args[0].is_nonpositive else inf
    if expression.is_Pow and expression.exp.is_number:
        if expression.exp.is_positive:
            return float(expression.exp) * of[0]
        # it stays away from zero
        return 0.0 if interval(expression.base)[0].is_positive else inf
    return inf
