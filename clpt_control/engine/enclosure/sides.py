"""Decisions on sets: which sides of a switch or kink members are on, and a line for all of them.

    value = sum of factors * operands + rest,   the rest within an interval for every member

The line of a kink is the chord of its graph (affine arithmetic: de Figueiredo and Stolfi 2004,
Numerical Algorithms 37); that of a switch is the mean of both sides.  What is left is a noise.
"""

from collections.abc import Callable, Iterable
from fractions import Fraction
from itertools import product
from math import ceil, floor, inf, nextafter
from typing import Any, NamedTuple

import numpy as np

from ..record.operations import LOGICAL, TABLE
from .balls import Interval, Undecided
from .set_program import CHOICES, DECIDED, Step

GRID = 2.0**20  # factors are whole multiples of 1 / GRID, so that 1 - factor is exact
KINKS: dict[str, Callable[[Any], Any]] = {  # b + f(a - b), and f(a) of one number
    "minimum": lambda s: min(s, 0),
    "maximum": lambda s: max(s, 0),
    "fabs": abs,
}


class Line(NamedTuple):
    """Places of operands with their factors, and the rest."""

    terms: tuple[tuple[int, float], ...]
    rest: Interval = (0.0, 0.0)


def decided(
    step: Step, ends: list[Interval], is_whole: bool
) -> tuple[list[int], Interval]:
    """Return the operands that members of a set choose, and bounds of the results."""
    kind, first = step.kind, ends[0]
    choices: list[int] = []
    if kind == "mod":
        return remainder(first, ends[1])
    if kind == "search":
        row = [low for low, high in ends[1:] if low == high]
        if len(row) < len(ends) - 1:
            raise Undecided("a table changes")
        low, high = (float(np.searchsorted(row, end, step.at[0])) for end in first)
        return choices, (low, high)
    if kind == "fabs":
        low, high = first
        choices = [0] if low >= 0.0 or high <= 0.0 else []
        return choices, (max(low, -high, 0.0), max(high, -low))
    if kind == "pick":
        count = len(ends) - 1
        start, stop = (ceil(first[0]), floor(first[1])) if is_whole else map(int, first)
        if not -count <= start <= stop < count:
            raise Undecided("a place may be outside of its table")
        choices = [1 + place % count for place in range(start, stop + 1)]
    elif kind == "where":
        low, high = truth(first)
        choices = [1] * (high > 0.0) + [2] * (low < 1.0)
    else:
        if kind in CHOICES:
            low, high = corners(TABLE[kind].chosen, ends)
            choices = [0] * (high > 0.0) + [1] * (low < 1.0)
        if kind in LOGICAL:
            ends = [truth(end) for end in ends]
        return choices, corners(TABLE[kind].numpy, ends)
    lows, highs = zip(*(ends[k] for k in choices), strict=True)
    return choices, (min(lows), max(highs))


def line_of(
    step: Step, ends: list[Interval], choices: list[int], value: Interval
) -> Line:
    """Return the line of a decision that holds for all members."""
    kind = step.kind
    if kind in DECIDED:
        return Line((), value)
    if kind == "mod":
        (low, high), b = ends[0], ends[1][0]
        turns = sorted(-b * (Fraction(end) // Fraction(b)) for end in (low, high))
        return Line(((0, 1.0),), rounded(turns))
    if len(choices) == 1:
        return chosen(step, ends, choices)
    if kind == "pick":
        return Line((), value)
    if kind == "fabs":
        factor, rest = chord((s, KINKS[kind](s)) for s in (*ends[0], 0.0))
        return Line(((0, factor),), rest)
    a, b = choices
    least, most = (Fraction(ends[a][k]) - Fraction(ends[b][1 - k]) for k in (0, 1))
    if kind == "where":
        half = max(abs(least), abs(most)) / 2
        return Line(((a, 0.5), (b, 0.5)), rounded((-half, half)))
    factor, rest = chord((s, KINKS[kind](s)) for s in (least, most, Fraction(0)))
    return Line(((a, factor), (b, 1.0 - factor)), rest)


def chosen(step: Step, ends: list[Interval], choices: list[int]) -> Line:
    """Return the line of a decision that is the same for all members."""
    is_negated = step.kind == "fabs" and ends[0][0] < 0.0
    return Line(((choices[0], -1.0 if is_negated else 1.0),))


def chord(points: Iterable[tuple[Any, Any]]) -> tuple[float, Interval]:
    """Return the slope between the first two of points joined by lines, and bounds of the rest."""
    exact = [(Fraction(s), Fraction(value)) for s, value in points]
    (low, first), (high, last) = exact[:2]
    factor = round(GRID * float((last - first) / (high - low))) / GRID
    left = [value - Fraction(factor) * s for s, value in exact]
    return factor, rounded((min(left), max(left)))


def below_root(of: Interval, root: Interval) -> Line:
    """Return the line of a square root, at most 1 / (4 slope) below it; `root` has its bounds."""
    if not root[0] < root[1]:
        return Line((), root)
    factor = (root[1] - root[0]) / (of[1] - of[0])
    slope, (low, high) = Fraction(factor), map(Fraction, of)
    # the greater root is rounded up by less than the last factor
    least = Fraction(root[1]) * (1 - Fraction(1, 2**48)) - slope * high
    ends = min(Fraction(root[0]) - slope * low, least), 1 / (4 * slope)
    return Line(((0, factor),), rounded(ends))


def rounded(ends: Iterable[Any]) -> Interval:
    """Return doubles around an interval; 0 is exact."""
    low, high = ends
    return (
        nextafter(float(low), -inf) if low else 0.0,
        nextafter(float(high), inf) if high else 0.0,
    )


def truth(of: Interval) -> Interval:
    """Return bounds, 0 or 1, of the truth of numbers; those of 0 or 1 may be rounded."""
    return float(not of[0] <= 0.0 <= of[1]), float(of != (0.0, 0.0))


def corners(function: Any, ends: list[Interval]) -> Interval:
    """Return bounds of a function that rises or falls along each argument, without rounding."""
    values = [float(function(*corner)) for corner in product(*ends)]
    return min(values), max(values)


def remainder(a: Interval, divisor: Interval) -> tuple[list[int], Interval]:
    """Return bounds of a remainder, whose slope is that of a between its jumps."""
    b = divisor[0]
    if b != divisor[1] or b == 0.0:
        raise Undecided("the divisor of a remainder may be 0 or change")
    low, high = (Fraction(end) % Fraction(b) for end in a)
    if high - low != Fraction(a[1]) - Fraction(a[0]):
        return [], (min(b, 0.0), max(b, 0.0))
    point = float(low)
    if low == high == point:
        return [0], (point, point)
    return [0], (nextafter(point, -inf), nextafter(float(high), inf))
