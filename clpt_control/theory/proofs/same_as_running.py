"""Comparison of symbolic equations with the running blocks at many random points.

A proof is about expressions.  It holds for a run if V and the rates of all states are those of the
running blocks up to rounding: relative to the sizes of its terms, and relative to the rate itself,
which may lose all digits where terms cancel.

The records of the blocks, which machine code runs, are evaluated at all points; the functions, by
python-control, at some.
"""

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
import sympy
from sympy import Expr

from ...base.progress.interrupt import check
from ..algebra.numeric_values import NumericValues
from .point_search import PointSearch
from .statements import said
from .steps import Step, checked
from .symbolic_loop import SymbolicLoop

THROUGH_CONTROL = 40  # points at which python-control calls the blocks
TOLERANCE = 1e-9  # relative to the sizes of all terms
# rounding error of a sum of states, relative to the largest state
ROUNDING = 16 * 2.0**-52 / TOLERANCE
LOST = sympy.Dummy("lost", positive=True)  # ROUNDING times the largest state
HUGE, TINY = 1e100, 1e-300  # numbers beyond are not compared
DIGITS = 16  # of a double
MOST_LOST = 10  # digits that a rate may lose where its terms cancel


def compare(search: PointSearch, points: tuple, count: int) -> tuple[bool, str]:
    """Compare V and the rates of all states with those of the running blocks.

    Points are times (n,), states (nx, n) and inputs (nu, n); python-control calls the blocks at
    `count` of them.
    """
    expressions = [search.V, *search.eq.motion.values()]
    expressions = [e.xreplace(search.eq.values) for e in expressions]
    symbols = search.values(*points)
    symbols[LOST] = ROUNDING * (1 + np.abs(points[1]).max(axis=0, initial=0.0))
    total = len(points[0])
    numbers = NumericValues(*expressions, *map(size_of, expressions)).at(symbols, total)
    values, size = np.split(numbers, 2)
    largest = 0.0
    for evaluate, n in (
        (search.blocks.by_control, count),
        (search.blocks.by_records, total),
    ):
        check()
        t, x, u = (array.T[:n] for array in points)
        rates, V = evaluate(t, x, u)
        first_row = V if search.blocks.V else values[0, :n]
        computed = np.vstack([first_row, rates.T])
        difference = _differences(values[:, :n], computed, size[:, :n])
        lost = _digits_lost(values[:, :n], computed)
        # NaN of inf - inf, but not of inf/inf, is a huge number
        for row, k in np.argwhere(np.isnan(difference)):
            point = {s: np.broadcast_to(v, total)[k] for s, v in symbols.items()}
            exact = expressions[row].evalf(subs=point)
            if exact.is_number and abs(exact) > HUGE:
                difference[row, k] = 0.0
        is_equal = (difference <= TOLERANCE) & (lost <= MOST_LOST)
        for row, k in np.argwhere(~is_equal)[:1]:
            name = _name_of(search, row)
            problem = _problem(difference[row, k], lost[row, k])
            states = np.array2string(x[k], precision=4, threshold=8, max_line_width=200)
            point_text = f"t = {t[k]:.4g}, states {states}"
            return False, f"{name} {problem} at {point_text}"
        largest = max(largest, float(difference.max(initial=0.0)))
    compared = np.sum(np.all(np.abs(values) < HUGE, axis=0))
    if compared <= total / 10:
        return False, (
            f"V or a rate is above {HUGE:.0e} at {total - compared} of {total} points, "
            "where it is not compared; scale states and gains"
        )
    return True, f"{total} points, largest difference {largest:.0e}"


def _problem(difference: float, lost: float) -> str:
    """Describe a difference between an expression and the running blocks."""
    if np.isnan(difference):
        return "is not a number"
    if difference <= TOLERANCE:
        return f"loses {lost:.0f} of {DIGITS} digits in rounding"
    return f"differs by {difference:.1e} of its terms"


def _name_of(search: PointSearch, row: int) -> str:
    """Name a row of a comparison: V, or the rate of a state and the block that has it."""
    if row == 0:
        return "V"
    k = row - 1
    nodes = search.blocks.wiring.nodes
    block = next(n.name for n in nodes if n.states.start <= k < n.states.stop)
    return f"{block}.update: {search.states[k]}'"


def size_of(e: Expr) -> Expr:
    """Return the sum of the sizes of all terms of an expression, and of rounding errors."""
    if e.is_Add:
        return sympy.Add(LOST, *map(size_of, e.args))
    if e.is_Mul or (e.is_Pow and e.exp.is_Integer and e.exp.is_positive):
        return e.func(*map(size_of, e.args))
    return sympy.Abs(e, evaluate=False)


def _differences(
    values: np.ndarray, computed: np.ndarray, size: np.ndarray
) -> np.ndarray:
    """Return differences relative to sizes, by row; 0 of huge numbers, and where V is huge."""
    with np.errstate(all="ignore"):
        difference = np.abs(computed - values) / np.maximum(size, TINY)
    is_huge = ~(np.abs(values) < HUGE) & ~(np.abs(computed) < HUGE)
    is_skipped = is_huge & ~np.isnan(computed) | is_huge[0]
    return np.where(is_skipped, 0.0, difference)


def _digits_lost(values: np.ndarray, computed: np.ndarray) -> np.ndarray:
    """Return the number of wrong digits, of 16, of each rate, by row.

    A rate below 1e-6 of the largest of its row is compared with that size.
    """
    is_finite = np.abs(values) < HUGE
    size = np.where(is_finite, np.abs(values), 0.0)
    largest = size.max(axis=1, keepdims=True, initial=0.0)
    scale = np.maximum(size + 1e-6 * largest, TINY)
    with np.errstate(all="ignore"):
        share = np.abs(computed - values) / scale
        digits = np.clip(DIGITS + np.log10(share), 0.0, DIGITS)
    return np.where(is_finite & np.isfinite(computed), digits, 0.0)


def search_of(loop: SymbolicLoop, rest: Mapping[Any, Expr], seed: int) -> PointSearch:
    """Return the search in a closed loop with its V, about the rest of its states."""
    return PointSearch(loop.diagram, loop, loop.signals["V"][0], "V[0]", rest, seed)


def running_step(
    read: Callable[[], SymbolicLoop],
    points: int,
    suffix: str = "",
    prefix: str = "",
    seed: int = 0,
) -> Step:
    """Check that the running blocks of a loop have the same V and rates.

    `suffix` is added to the claim, `prefix` to the detail.
    """

    def comparison() -> tuple[bool, str]:
        search = search_of(read(), {}, seed)
        holds, detail = compare(search, search.wide(points), THROUGH_CONTROL)
        return holds, prefix + detail

    claim = said("the running blocks give the same V'{}", suffix)
    return checked(claim, comparison, "sampled", False, "running")
