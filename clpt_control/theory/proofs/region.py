"""A region from which every run comes to rest, by a V whose V' < 0 there, part by part.

    x in the box, x not the rest, V(x) <= c  =>  V'(x) < 0,        c < V on the edge of the box

Then no run leaves {V <= c}, V is least at the rest alone, and what begins there comes to rest
(Khalil 2002, Theorem 4.1).  V' is enclosed in parts of the box, rounded outward (`enclosed`).
Near the rest, where V' and its slopes are zero, V' = z^T H z / 2 with H its second derivatives at a
point between: V' < 0 where all that H may be is negative definite.  Where pieces meet with one
slope, as of v |v|, H lies between those of the pieces (Hiriart-Urruty et al. 1984).  The parts of
the lowest V come first, and what is not decided is halved: c rises until V' >= 0 stands at it.

Sources: Khalil, H. K. (2002), Nonlinear Systems, 3rd ed.; Rohn, J. (1994), Positive definiteness
and stability of interval matrices, SIAM Journal on Matrix Analysis 15(1), 175-184; Hiriart-Urruty,
J.-B., Strodiot, J.-J., Nguyen, V. H. (1984), Generalized Hessian matrix and second-order optimality
conditions for problems with C1,1 data, Applied Mathematics and Optimization 11, 43-56.

Enclosures: between which numbers an expression lies in boxes of its symbols.

    low <= f(x) <= high    for all x in the box

Each operation is rounded outward: sums and products by one unit in the last place, functions by
16, more than NumPy's are off.  What has no value somewhere in a box lies between -inf and inf.

Source: Moore, R. E., Kearfott, R. B., Cloud, M. J. (2009), Introduction to Interval Analysis, SIAM.
"""

from collections.abc import Iterable, Mapping
from functools import reduce
from typing import Any

import numpy as np
import sympy
from sympy import Expr, S, sin

from ...base.arguments import check_holds, check_known, numbers
from ...base.errors import DiagramError
from ...base.units import at_least
from ...engine.diagram.symbol_names import TIME
from ..algebra.decided import decided
from ..algebra.exact import normal_form, vanishes
from ..algebra.facts import COMPARISONS, GT, fact_of, is_continuous, is_smooth
from ..algebra.numeric_values import numpy_function
from ..algebra.slopes import in_known_pieces, meets_smoothly, slope_in
from ..algebra.texts import short
from .system_candidate import SystemCandidate

Interval = tuple[np.ndarray, np.ndarray]  # low and high, of shape (boxes,)
UNITS = 16.0 * 2.0**-52  # as a share: of a function of NumPy, in the last place
LARGEST = 1e5  # angle whose turns are counted
TURN = 1e-9  # share of a turn: where a sine is at its top is not known better
EXTREME = {"or_": np.maximum, "and_": np.minimum}  # of truth values


@np.errstate(all="ignore")
def enclosed(expression: Expr, boxes: dict[Any, Interval]) -> Interval:
    """Return between which numbers an expression lies in each box."""
    return _enclosed(expression, dict(boxes))


def _enclosed(e: Expr, ranges: dict[Any, Interval]) -> Interval:
    if e not in ranges:
        low, high = _operation(e, ranges)
        lost = np.isnan(low) | np.isnan(high)
        ranges[e] = np.where(lost, -np.inf, low), np.where(lost, np.inf, high)
    return ranges[e]


def _operation(e: Expr, ranges: dict[Any, Interval]) -> Interval:
    if e.is_number:
        value = np.array([float(e)])
        return (
            (value, value)
            if e.is_Integer and abs(e) < 2**53
            else _outward(value, value)
        )
    of, name = [_enclosed(argument, ranges) for argument in e.args], e.func.__name__
    if e.is_Add:
        return reduce(plus, of)
    if e.is_Mul:
        return reduce(times, of)
    if e.is_Pow and e.exp.is_number:
        return _power(*of[0], e.exp)
    if (fact := fact_of(e)).rises:
        low, high = map(numpy_function(e.func, len(of)), *of)
        return _outward(low, high) if fact.kind == "smooth" else (low, high)
    if isinstance(e, sympy.cosh):
        low, high = _size(*of[0])
        return _outward(np.cosh(low), np.cosh(high))
    if isinstance(e, sin | sympy.cos):
        return _sine(e.func, *of[0])
    if name == "Abs":
        return _size(*of[0])
    if name in EXTREME:
        low, high = map(EXTREME[name], *of)
        return low, high
    if name in COMPARISONS:
        (a, b), compare = (
            of if name in ("gt", "ge") else of[::-1],
            COMPARISONS["g" + name[1]],
        )
        return 1.0 * compare(a[0], b[1]), 1.0 * compare(a[1], b[0])
    if name == "inside":
        u, a, b = e.args
        return _enclosed(sympy.Function("and_")(GT(u, a), GT(b, u)), ranges)
    if name == "not_":
        return 1.0 - of[0][1], 1.0 - of[0][0]
    if name == "where":
        return _chosen(*of)
    raise DiagramError(
        f"within: {short(e, 60)} is not a function whose range in a box is known"
    )


def plus(a: Interval, b: Interval) -> Interval:
    """Return the range of a sum."""
    return _outward(a[0] + b[0], a[1] + b[1], 0.0)


def times(a: Interval, b: Interval) -> Interval:
    """Return the range of a product."""
    corners = np.array(np.broadcast_arrays(*(x * y for x in a for y in b)))
    return _outward(corners.min(axis=0), corners.max(axis=0), 0.0)


def _outward(low: np.ndarray, high: np.ndarray, share: float = UNITS) -> Interval:
    """Return an interval with its ends moved apart by a share of them, and by a unit more."""
    low, high = low - share * np.abs(low), high + share * np.abs(high)
    return np.nextafter(low, -np.inf), np.nextafter(high, np.inf)


def _size(low: np.ndarray, high: np.ndarray) -> Interval:
    """Return the range of |u|."""
    least, most = np.sort(np.abs([low, high]), axis=0)
    return np.where((low <= 0.0) & (high >= 0.0), 0.0, least), most


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
    top, of = (0.25, np.sin) if function is sin else (0.0, np.cos)
    turns = low / (2 * np.pi) - top - TURN, high / (2 * np.pi) - top + TURN
    ends = of(low), of(high)
    bottom, peak = _outward(np.minimum(*ends), np.maximum(*ends))
    is_far = ~(_size(low, high)[1] < LARGEST)
    peak = np.where(is_far | (np.floor(turns[0]) < np.floor(turns[1])), 1.0, peak)
    lowest = np.floor(turns[0] + 0.5) < np.floor(turns[1] + 0.5)
    return np.where(is_far | lowest, -1.0, bottom), peak


def _chosen(condition: Interval, yes: Interval, no: Interval) -> Interval:
    """Return the range of a choice: that of one side where it is known, else of both."""
    surely, never = condition[0] > 0.0, condition[1] <= 0.0
    low = np.where(surely, yes[0], np.where(never, no[0], np.minimum(yes[0], no[0])))
    high = np.where(surely, yes[1], np.where(never, no[1], np.maximum(yes[1], no[1])))
    return low, high


MOST = 200_000  # parts that are looked at
BATCH = 512  # at once
ENOUGH = 1e-3  # of the level: it is not known better
ROUNDING = 1e-10  # as a share: more than a matrix's eigenvalues are off
NEAREST = 2.0**-24  # of the box: the smallest part about the rest that is tried
Ends = tuple[np.ndarray, np.ndarray]  # of boxes, low and high: (boxes, n), or (n,)


class Region:
    """V - V(rest) and V' in a box of states, with parameters as they are and inputs of 0."""

    def __init__(self, case: SystemCandidate, within: Any):
        self.states, self.discrete = case.states, case.eq.discrete
        self.rest = case.origin
        self.low, self.high = _box(self.rest, within)
        zero = dict.fromkeys(case.inputs, S.Zero)
        zero |= {sympy.Derivative(f, TIME): S.Zero for f in zero}
        symbols = {d: sympy.Dummy(f"{d.func}", real=True) for d in case.where.box}
        zero |= symbols | case.where.values
        # inputs between bounds, which may have any values there
        self.held: dict[Any, Interval] = {
            symbols[d]: (np.array([float(low)]), np.array([float(high)]))
            for d, (low, high) in case.where.box.items()
        }
        V, rate, *self.motion = (
            decided(e.xreplace(zero))
            for e in (case.V, case.rate, *case.eq.motion.values())
        )
        of_what = sympy.Tuple(V, *self.motion).free_symbols
        moving = of_what - {*self.states, *self.held}
        if moving or case.eq.jumps:
            moves = f"moves with {', '.join(map(str, moving))}"
            why = f"it {'jumps' if case.eq.jumps else moves}"
            raise DiagramError(
                f"within: {case.system.name} has no region that lasts, because {why}"
            )
        if not is_smooth(V):
            raise DiagramError(
                f"within: V = {short(V, 60)} bends. Give one that is smooth"
            )
        self.V_at_rest = V.xreplace(self.rest)
        both = ((e, normal_form(e)) for e in (V - self.V_at_rest, rate))
        self.V, self.rate = (min(ways, key=sympy.count_ops) for ways in both)
        self.slopes = {
            e: self.slopes_of(e) for e in (self.V, self.rate) if is_continuous(e)
        }

    def slopes_of(self, e: Expr) -> list[Expr]:
        """Return the derivatives of an expression by each state; at a kink, of one side."""
        return [slope_in(e, s) for s in self.states]

    def boxes(self, low: np.ndarray, high: np.ndarray) -> dict[Any, Interval]:
        """Return what is known of each state in boxes."""
        of_states = zip(self.states, zip(low.T, high.T, strict=True), strict=True)
        return self.held | dict(of_states)

    @np.errstate(all="ignore")  # inf - inf
    def range(self, e: Expr, low: np.ndarray, high: np.ndarray) -> Interval:
        """Return the range of V or V' as it stands, or of e(m) + slopes (x - m), if narrower."""
        boxes, middle = self.boxes(low, high), 0.5 * low + 0.5 * high
        least, most = enclosed(e, boxes)
        if e in self.slopes:
            about = enclosed(e, self.boxes(middle, middle))
            for s, slope, m in zip(self.states, self.slopes[e], middle.T, strict=True):
                change = times(enclosed(slope, boxes), plus(boxes[s], (-m, -m)))
                about = plus(about, change)
            least, most = np.fmax(least, about[0]), np.fmin(most, about[1])
        return np.broadcast_to(least, len(low)), np.broadcast_to(most, len(low))

    def stay(self, low: np.ndarray, high: np.ndarray) -> np.ndarray:
        """Return whether the next states are in the box as well; always in continuous time."""
        if not self.discrete:
            return np.ones(len(low), dtype=bool)
        ends = zip(self.motion, self.low, self.high, strict=True)
        nexts = ((self.range(e, low, high), a, b) for e, a, b in ends)
        return np.all([(a <= of[0]) & (of[1] <= b) for of, a, b in nexts], axis=0)

    def near_the_rest(self) -> Ends | None:
        """Return a box about the rest in which V' < 0 but there, by its second derivatives."""
        center, share = np.array([float(value) for value in self.rest.values()]), 1.0
        while share > NEAREST:
            low, high = (
                center + share * (end - center) for end in (self.low, self.high)
            )
            boxes, share = self.boxes(low[None], high[None]), share / 2

            def is_above(margin: Expr, boxes: Any = boxes) -> bool:
                return bool((enclosed(margin, boxes)[0] > 0.0).all())

            rate, *motion = (
                in_known_pieces(e, is_above) for e in (self.rate, *self.motion)
            )
            if not (is_smooth(rate) or (is_continuous(rate) and meets_smoothly(rate))):
                continue
            slopes = self.slopes_of(rate)
            if self.discrete:
                motion = [e - s for s, e in zip(self.states, motion, strict=True)]
            if not all(
                vanishes(decided(e.xreplace(self.rest)))
                for e in (rate, *motion, *slopes)
            ):
                return None
            hessian = [
                [enclosed(e, boxes) for e in self.slopes_of(slope)] for slope in slopes
            ]
            if _is_negative(np.array(hessian)[..., 0]):
                return low, high
        return None

    def level(self, rests: Iterable[Mapping[Any, Any]] | None = None) -> float:
        """Return c, below which V' < 0 but at the rest, and V stays off the edge; 0 for none.

        It has four digits, rounded down.  If `rests` are given, V falls to them from everywhere,
        and c stays below V at those that are not the rest.
        """
        falls_everywhere = rests is not None
        rest_box = (self.low, self.high) if falls_everywhere else self.near_the_rest()
        if rest_box is None:
            return 0.0
        edges = [(k, end[k]) for end in (self.low, self.high) for k in range(len(end))]
        low, high = (
            np.array([end] * (1 + len(edges))) for end in (self.low, self.high)
        )
        for row, (k, value) in enumerate(edges, 1):
            low[row, k] = high[row, k] = value
        floor, cap, looked = self.range(self.V, low, high)[0], self._least(rests), 0
        while (
            looked < MOST
            and len(floor)
            and cap > 0
            and floor.min() < (1 - ENOUGH) * cap
        ):
            order = np.argsort(floor, kind="stable")
            tried, later = order[:BATCH], order[BATCH:]
            a, b = low[tried], high[tried]
            edge = (a == b).any(axis=1)
            falls = ((rest_box[0] <= a) & (b <= rest_box[1])).all(axis=1)
            falls |= self.range(self.rate, a, b)[1] < 0.0
            falls &= self.stay(a, b)
            undecided = edge | ~falls
            parts = a, b, edge, floor[tried]
            a, b, edge, floors = (part[undecided] for part in parts)
            middle = 0.5 * a + 0.5 * b
            above = self.range(self.rate, middle, middle)[0] >= 0.0
            above = edge | (above & (not falls_everywhere))
            cap = min([cap, *self.range(self.V, middle, middle)[1][above]])
            halves = _halved(a, b, self.high - self.low)
            floors = np.maximum(self.range(self.V, *halves)[0], np.tile(floors, 2))
            low, high = (
                np.vstack([ends_k[later], new_half])
                for ends_k, new_half in zip((low, high), halves, strict=True)
            )
            floor = np.append(floor[later], floors)
            low, high, floor = (array_k[floor <= cap] for array_k in (low, high, floor))
            looked += len(tried)
        most = min([cap, *floor])
        return max(0.0, float(at_least(most)))

    def _least(self, rests: Iterable[Mapping[Any, Any]] | None) -> float:
        """Return V at the lowest of the rests in the box but for the rest itself, or inf."""
        lowest = np.inf
        for point_of_rest in rests or ():
            point = np.array([[float(point_of_rest[s]) for s in self.states]])
            inside = ((self.low <= point) & (point <= self.high)).all()
            if inside and any(point_of_rest[s] != self.rest[s] for s in self.states):
                lowest = min(lowest, float(self.range(self.V, point, point)[0][0]))
        return lowest


def _box(rest_state: Mapping[Any, Any], ends_by_state: Any) -> Ends:
    """Return the ends of a box of states, about the rest."""
    labels = [str(s) for s in rest_state]
    check_known("within", ends_by_state, labels)
    check_holds("within", ends_by_state, labels, "give each state its two ends")
    ends = np.array([numbers("within", ends_by_state[name], 2) for name in labels])
    for name, (low, high), value in zip(labels, ends, rest_state.values(), strict=True):
        if not (np.isfinite([low, high]).all() and low < value < high):
            raise DiagramError(
                f"within: {name} from {low:g} to {high:g}; must be finite, with the rest, "
                f"{float(value):g}, between"
            )
    return ends[:, 0], ends[:, 1]


def _halved(low: np.ndarray, high: np.ndarray, box: np.ndarray) -> Ends:
    """Return both halves of boxes, each cut across its side that is the largest of the whole."""
    axis, rows = np.argmax((high - low) / box, axis=1), np.arange(len(low))
    lows, highs = np.vstack([low, low]), np.vstack([high, high])
    highs[rows, axis] = lows[rows + len(low), axis] = (0.5 * low + 0.5 * high)[
        rows, axis
    ]
    return lows, highs


def _is_negative(hessian: np.ndarray) -> bool:
    """Return whether all symmetric matrices between two, (n, n, 2), are negative definite."""
    if not np.isfinite(hessian).all():
        return False
    middle = 0.25 * (hessian + hessian.transpose(1, 0, 2)).sum(axis=-1)
    spread = np.maximum(hessian[..., 1] - middle, middle - hessian[..., 0])
    radius = np.linalg.norm(spread) + ROUNDING * np.linalg.norm(hessian)
    return bool(np.linalg.eigvalsh(middle).max() + radius < 0.0)
