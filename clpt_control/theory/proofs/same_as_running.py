"""Comparison of symbolic equations with the blocks that run, at many random points.

A proof is about expressions.  It holds for a run if V and the rates of all states are those of the
running blocks, each up to rounding: as a share of the sizes of its terms, and as a share of the
rate itself, of which rounding may leave nothing where terms cancel.

The records of the blocks, which machine code runs, are evaluated at all points; the functions, by
python-control, at some.
"""

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
import sympy

from ...base.progress.interrupt import check
from .point_search import PointSearch
from .steps import Step, checked
from .symbolic_loop import Numbers, SymbolicLoop

THROUGH_CONTROL = 40  # points at which python-control calls the blocks
CLOSE = 1e-9  # share of the sizes of all terms
# of states, below which a sum may be what rounding leaves of its terms
ROUNDING = 16 * 2.0**-52 / CLOSE
LOST = sympy.Dummy("lost", positive=True)  # that share of the largest state
HUGE, TINY = 1e100, 1e-300  # beyond, numbers say nothing
DIGITS = 16  # of a double
MOST_LOST = 10  # digits that rounding may take from a rate where its terms cancel


def compare(search: PointSearch, points: tuple, some: int) -> tuple[bool, str]:
    """Compare V and the rates of all states with those of the running blocks.

    At `some` of the points, times (n,), states (nx, n) and inputs (nu, n), python-control calls
    the blocks.
    """
    expressions = [search.V, *search.eq.motion.values()]
    expressions = [e.xreplace(search.eq.values) for e in expressions]
    numbers = Numbers(*expressions, *map(size_of, expressions))
    known = search.known(*points)
    known[LOST] = ROUNDING * (1 + np.abs(points[1]).max(axis=0, initial=0.0))
    count, largest = len(points[0]), 0.0
    values, size = np.split(numbers.at(known, count), 2)
    for evaluate, most in (
        (search.blocks.by_control, some),
        (search.blocks.by_records, count),
    ):
        check()
        t, x, _ = here = [part.T[:most] for part in points]
        rates, V = evaluate(*here)
        computed = np.vstack([V if search.blocks.V else values[0, :most], rates.T])
        off = _differences(values[:, :most], computed, size[:, :most])
        lost = _digits_lost(values[:, :most], computed)
        for row, k in np.argwhere(np.isnan(off)):
            # large of inf - inf, not of inf/inf
            place = {s: np.broadcast_to(v, count)[k] for s, v in known.items()}
            exact = expressions[row].evalf(subs=place)
            if exact.is_number and abs(exact) > HUGE:
                off[row, k] = 0.0
        for row, k in np.argwhere(~((off <= CLOSE) & (lost <= MOST_LOST)))[:1]:
            problem = f"differs by {off[row, k]:.1e} of its terms"
            if off[row, k] <= CLOSE:
                problem = f"loses {lost[row, k]:.0f} of 16 digits in rounding"
            if np.isnan(off[row, k]):
                problem = "is no number"
            where = f"t = {t[k]:.4g}, states {_few_numbers(x[k])}"
            return False, f"{_name_of(search, row)} {problem} at {where}"
        largest = max(largest, float(off.max(initial=0.0)))
    compared = np.sum(np.all(np.abs(values) < HUGE, axis=0))
    if compared <= count / 10:
        what = (
            f"V or a rate is above {HUGE:.0e} at {count - compared} of {count} points"
        )
        return False, f"{what}, where it is not compared; scale states and gains"
    return True, f"{count} points, largest difference {largest:.0e}"


def _name_of(search: PointSearch, row: int) -> str:
    """Name a row of a comparison: V, or the rate of a state and the block that has it."""
    if row == 0:
        return "V"
    nodes = search.blocks.wiring.nodes
    block = next(n.name for n in nodes if n.states.start < row <= n.states.stop)
    return f"{block}.update: {search.states[row - 1]}'"


def size_of(e: sympy.Expr) -> sympy.Expr:
    """Return an expression with the sizes of all that is added in it, and what rounding may add."""
    if e.is_Add:
        return sympy.Add(LOST, *map(size_of, e.args))
    if e.is_Mul or (e.is_Pow and e.exp.is_Integer and e.exp.is_positive):
        return e.func(*map(size_of, e.args))
    return sympy.Abs(e, evaluate=False)


def _differences(
    values: np.ndarray, computed: np.ndarray, size: np.ndarray
) -> np.ndarray:
    """Return differences as shares of sizes, by row; 0 of what is too large, as where V is."""
    with np.errstate(all="ignore"):
        off = np.abs(computed - values) / np.maximum(size, TINY)
    large = ~(np.abs(values) < HUGE) & ~(np.abs(computed) < HUGE)
    return np.where(large & ~np.isnan(computed) | large[0], 0.0, off)


def _few_numbers(values: np.ndarray) -> str:
    """Return numbers as text, of many the first and the last ones."""
    return np.array2string(values, precision=4, threshold=8, max_line_width=200)


def _digits_lost(values: np.ndarray, computed: np.ndarray) -> np.ndarray:
    """Return how many of 16 digits of each rate are wrong, by row.

    A rate that is tiny beside the largest of its row, 1e-6 of it, is measured by that size.
    """
    size = np.where(np.abs(values) < HUGE, np.abs(values), 0.0)
    largest = size.max(axis=1, keepdims=True, initial=0.0)
    scale = np.maximum(size + 1e-6 * largest, TINY)
    with np.errstate(all="ignore"):
        share = np.abs(computed - values) / scale
        digits = np.clip(DIGITS + np.log10(share), 0.0, DIGITS)
    return np.where((np.abs(values) < HUGE) & np.isfinite(computed), digits, 0.0)


def search_of(
    loop: SymbolicLoop, rest: Mapping[Any, sympy.Expr], seed: int
) -> PointSearch:
    """Return the search along a closed loop with its V, about where its states rest."""
    return PointSearch(loop.diagram, loop, loop.signals["V"][0], "V[0]", rest, seed)


def running_step(
    read: Callable[[], SymbolicLoop],
    points: int,
    which: str = "",
    of: str = "",
    seed: int = 0,
) -> Step:
    """Check that the running blocks of a loop have the same V and rates, at their parameters."""

    def same() -> tuple[bool, str]:
        search = search_of(read(), {}, seed)
        holds, detail = compare(search, search.wide(points), THROUGH_CONTROL)
        return holds, of + detail

    return checked(
        f"the running blocks give the same V'{which}", same, "sampled", False
    )
