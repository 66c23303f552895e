"""Enclosures: between which numbers an expression lies in boxes of its symbols.

    low <= f(x) <= high    for all x in the box

Each operation is rounded outward: sums and products by one unit in the last place, functions by
16, more than NumPy's are off.  What has no value somewhere in a box lies between -inf and inf.

Source: Moore, R. E., Kearfott, R. B., Cloud, M. J. (2009), Introduction to Interval Analysis, SIAM.
"""

from collections.abc import Callable
from functools import reduce
from typing import Any

import numpy as np
import sympy

from ..equations.symbolic import ON_NUMBERS
from ..errors import DiagramError
from .proving.proof import short
from .proving.words import COMPARED

Interval = tuple[np.ndarray, np.ndarray]  # low and high, of shape (boxes,)
UNITS = 16.0 * 2.0**-52  # as a share: of a function of NumPy, in the last place
LARGEST = 1e5  # angle whose turns are counted
TURN = 1e-9  # share of a turn: where a sine is at its top is not known better

RISING: dict[Any, Callable[..., Any]] = {
    **{sympy.exp: np.exp, sympy.sinh: np.sinh, sympy.tanh: np.tanh},
    **{sympy.atan: np.arctan, sympy.asinh: np.arcsinh, sympy.log: np.log},
}
EXACT = ("sign", "floor", "ceil", "trunc", "maximum", "minimum", "clip")
STEPS = {name: ON_NUMBERS[name] for name in EXACT} | {"or_": np.maximum, "and_": np.minimum}


def enclosed(expression: sympy.Expr, boxes: dict[Any, Interval]) -> Interval:
    """Return between which numbers an expression lies in each box."""
    with np.errstate(all="ignore"):
        return _enclosed(expression, dict(boxes))


def _enclosed(e: sympy.Expr, known: dict[Any, Interval]) -> Interval:
    if e not in known:
        low, high = _operation(e, known)
        lost = np.isnan(low) | np.isnan(high)
        known[e] = np.where(lost, -np.inf, low), np.where(lost, np.inf, high)
    return known[e]


def _operation(e: sympy.Expr, known: dict[Any, Interval]) -> Interval:
    if e.is_number:
        value = np.array([float(e)])
        return (value, value) if e.is_Integer and abs(e) < 2**53 else _outward(value, value)
    of, name = [_enclosed(one, known) for one in e.args], e.func.__name__
    if e.is_Add:
        return reduce(plus, of)
    if e.is_Mul:
        return reduce(times, of)
    if e.is_Pow and e.exp.is_number:
        return _power(*of[0], e.exp)
    if e.func in RISING:
        low, high = of[0]
        return _outward(RISING[e.func](low), RISING[e.func](high))
    if isinstance(e, sympy.cosh):
        low, high = _size(*of[0])
        return _outward(np.cosh(low), np.cosh(high))
    if isinstance(e, sympy.sin | sympy.cos):
        return _sine(e.func, *of[0])
    if name == "Abs":
        return _size(*of[0])
    if name in STEPS:
        lows, highs = zip(*of, strict=True)
        return STEPS[name](*lows), STEPS[name](*highs)
    if name in COMPARED:
        (a, b), compare = of if name in ("gt", "ge") else of[::-1], COMPARED["g" + name[1]]
        return 1.0 * compare(a[0], b[1]), 1.0 * compare(a[1], b[0])
    if name == "inside":
        u, a, b = of
        return 1.0 * ((a[1] < u[0]) & (u[1] < b[0])), 1.0 * ((a[0] < u[1]) & (u[0] < b[1]))
    if name == "not_":
        return 1.0 - of[0][1], 1.0 - of[0][0]
    if name == "where":
        return _chosen(*of)
    raise DiagramError(f"within: {short(e, 60)} is no function whose range in a box is known")


def plus(a: Interval, b: Interval) -> Interval:
    """Return the range of a sum."""
    with np.errstate(all="ignore"):  # inf - inf
        return _outward(a[0] + b[0], a[1] + b[1], 0.0)


def times(a: Interval, b: Interval) -> Interval:
    """Return the range of a product."""
    with np.errstate(all="ignore"):
        corners = np.array(np.broadcast_arrays(*(x * y for x in a for y in b)))
        return _outward(corners.min(axis=0), corners.max(axis=0), 0.0)


def _outward(low: np.ndarray, high: np.ndarray, share: float = UNITS) -> Interval:
    """Return an interval with its ends moved apart by a share of them, and by a unit more."""
    low, high = low - share * np.abs(low), high + share * np.abs(high)
    return np.nextafter(low, -np.inf), np.nextafter(high, np.inf)


def _size(low: np.ndarray, high: np.ndarray) -> Interval:
    """Return the range of |u|."""
    ends = np.minimum(np.abs(low), np.abs(high)), np.maximum(np.abs(low), np.abs(high))
    return np.where((low <= 0.0) & (high >= 0.0), 0.0, ends[0]), ends[1]


def _power(low: np.ndarray, high: np.ndarray, exponent: Any) -> Interval:
    """Return the range of u^n, n a number; an exponent that is no integer takes u >= 0."""
    n = abs(float(exponent))
    if exponent.is_even:
        low, high = _size(low, high)
    elif not exponent.is_Integer:
        low = np.where(low < 0.0, np.nan, low)
    low, high = _outward(low**n, high**n)
    if exponent.is_even or not exponent.is_Integer:
        low = np.maximum(low, 0.0)
    if exponent.is_negative:
        through = (low <= 0.0) & (high >= 0.0)
        low, high = _outward(np.where(through, np.nan, 1.0 / high), 1.0 / low, 0.0)
    return low, high


def _sine(function: Any, low: np.ndarray, high: np.ndarray) -> Interval:
    """Return the range of a sine or cosine, whose tops are a turn apart."""
    top, of = (0.25, np.sin) if function is sympy.sin else (0.0, np.cos)
    turns = low / (2 * np.pi) - top - TURN, high / (2 * np.pi) - top + TURN
    ends = of(low), of(high)
    bottom, peak = _outward(np.minimum(*ends), np.maximum(*ends))
    far = ~(np.maximum(np.abs(low), np.abs(high)) < LARGEST)
    peak = np.where(far | (np.floor(turns[0]) < np.floor(turns[1])), 1.0, peak)
    lowest = np.floor(turns[0] + 0.5) < np.floor(turns[1] + 0.5)
    return np.where(far | lowest, -1.0, bottom), peak


def _chosen(condition: Interval, yes: Interval, no: Interval) -> Interval:
    """Return the range of a choice: that of one side where it is known, else of both."""
    surely, never = condition[0] > 0.0, condition[1] <= 0.0
    low = np.where(surely, yes[0], np.where(never, no[0], np.minimum(yes[0], no[0])))
    high = np.where(surely, yes[1], np.where(never, no[1], np.maximum(yes[1], no[1])))
    return low, high
