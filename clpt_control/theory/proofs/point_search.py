"""Search for points at which V of a candidate rises, or is below its value at rest.

Points are drawn from wide ranges about a rest, or the truth, and again near the best of them; each
is confirmed by the blocks that run.
"""

from collections.abc import Iterator

import numpy as np
import sympy
from sympy import Expr

from ...base.errors import DiagramError
from ...base.progress.interrupt import check
from ..algebra.numeric_values import NumericValues
from .random_points import RandomPoints
from .symbolic_loop import Point

SEARCHES = 20  # each from new random points
ROUNDS = 15  # of a search
PER_ROUND = 500  # points
BEST = 5  # points of a round that the next one starts from
DISTANCES = (1.0, 10.0, 100.0)  # factors of the distance from the rest
ENLARGED = (1e4, 1e3, 100.0, 10.0, 1.0)  # so that a point is not near the rest
LARGE_STATE = 10.0  # to which points are enlarged
SIGNIFICANT = 1e-7  # of the size of its terms; smaller values may be rounding errors
PER_JUMP = 300  # points
LATEST_JUMP = 1000.0  # time until which jumps are searched
Failure = tuple[Point, float]  # a point, and V', or the rise of V, at the point


class PointSearch(RandomPoints):
    """Searches among random points for those at which a candidate fails."""

    def highest(self, expression: Expr, still: bool) -> Iterator[Point]:
        """Yield points at which an expression is positive, relative to the size of its terms."""
        terms = sympy.Add.make_args(sympy.expand(expression))
        try:
            numbers = self.numbers(expression, *terms)
        except DiagramError:  # no numbers, as of a source of time
            return
        for _ in range(SEARCHES):
            check()
            point = self._search(numbers, still)
            if point is not None:
                yield point

    def _search(self, numbers: NumericValues, still: bool) -> Point | None:
        """Return a point at which the first of the numbers is positive, or None."""
        points = self.draw(PER_ROUND, still)
        radius = 1.0
        for _ in range(ROUNDS):
            value, *terms = numbers.at(self.values(*points), PER_ROUND)
            with np.errstate(all="ignore"):
                share = value / np.abs(terms).sum(axis=0)
            share = np.where(np.isfinite(share), share, -np.inf)
            best = np.argsort(-share)[:BEST]
            if share[best[0]] > SIGNIFICANT:
                t, x, u = (values[..., best[0]] for values in points)
                return Point(float(t), np.array(x), np.array(u))
            centers = np.resize(best, PER_ROUND)
            radius = 0.7 * radius
            t, x, u = (self.near(values[..., centers], radius) for values in points)
            points = np.abs(t), x, u * (not still)
        return None

    def near(self, values: np.ndarray, radius: float) -> np.ndarray:
        """Return random numbers near values; the first `BEST` are unchanged."""
        largest = np.max(np.abs(values), axis=0, initial=0.0)
        size = radius * (np.abs(values) + 0.1 * largest + 1e-3)
        step = size * self.random.standard_normal(values.shape)
        is_moved = np.arange(values.shape[-1]) >= BEST
        return values + step * is_moved

    def sign_at(self, expression: Expr, sign: int) -> Failure | None:
        """Return a point at which an expression has a sign, and its value."""
        point = next(self.highest(sign * expression, True), None)
        return None if point is None else (point, self.value_at(expression, point))

    def rate_above(
        self, rate: Expr, claim: Expr, still: bool, sign: int = 1
    ) -> Failure | None:
        """Return a point at which V' of the running blocks is above a claim, and V'.

        With `sign` -1, V' is below the claim.
        """
        for found in self.highest(sign * (rate - claim), still):
            rest = self.rest_at(found.x[:, None])[:, 0]
            states = rest + np.outer(ENLARGED, found.x - rest)
            is_small = np.abs(states).max(axis=1, initial=0.0) <= LARGE_STATE
            is_small[-1] = True  # the point itself
            points = [found._replace(x=x) for x in states[is_small]]
            values, sizes, _ = self.rates_at(found, states[is_small])
            for point, value, size in zip(points, values, sizes, strict=True):
                claimed = self.value_at(claim, point)
                excess = sign * (value - claimed)
                if excess > SIGNIFICANT * max(size, abs(claimed)):
                    return point, float(value)
        return None

    def rises_far_off(self, rate: Expr, fixed: set) -> Failure | None:
        """Return a point, and V', at which V' > 0 also at 10 and 100 times the distance.

        Inputs are unchanged, and V' grows with V.  A disturbance that V' < 0 outgrows is skipped:
        it raises V near the rest alone.  States that are `fixed` are not moved.
        """
        is_fixed = np.array([s in fixed for s in self.states])
        for point in self.highest(rate, still=False):
            rest = np.where(is_fixed, point.x, self.rest_at(point.x[:, None])[:, 0])
            states = rest + np.outer(DISTANCES, point.x - rest)
            rises, size, V = self.rates_at(point, states)
            is_positive = np.all((rises > SIGNIFICANT * size) & (V > 0))
            if is_positive and rises[-1] / V[-1] >= 0.5 * rises[0] / V[0]:
                return point, float(rises[0])
        return None

    def below_rest(self, rise: Expr) -> Failure | None:
        """Return a point at which V of the blocks is below V at rest, and the difference."""
        for point in self.highest(-rise, still=True):
            _, _, (V, V_rest) = self.rates_at(point, self.farther(point.x, (1.0, 0.0)))
            if V_rest - V > SIGNIFICANT * max(abs(V), abs(V_rest)):
                return point, float(V - V_rest)
        return None

    def rising_jump(self) -> tuple[Point, Point, float] | None:
        """Return points before and after a jump at which V of the blocks rises, and the rise.

        V rises at all distances, and more at larger ones.  At a jump that forgets a share of all
        states V does not: errors stay bounded by that share.
        """
        sweep = self.blocks.sweep
        count = len(DISTANCES)
        for t in sweep.breakpoints(0.0, LATEST_JUMP)[:count].tolist():
            sweep.enter(t)
            _, states, inputs = self.draw(PER_JUMP, still=False)
            before = np.concatenate([self.farther(x, DISTANCES) for x in states.T])
            u = np.repeat(inputs.T, count, axis=0)
            times = np.full(len(before), t)
            pairs = zip(before, u, strict=True)
            after = np.array([sweep.jump(t, x, v, sweep.jumping) for x, v in pairs])
            _, V_before = self.blocks.by_records(times, before, u)
            _, V_after = self.blocks.by_records(times, after, u)
            rises = np.reshape(V_after - V_before, (PER_JUMP, count))
            size = np.reshape(np.abs(V_before), (PER_JUMP, count))
            is_rising = np.all(rises > SIGNIFICANT * size, axis=1)
            is_growing = rises[:, -1] >= 10 * rises[:, 0]
            for k in np.flatnonzero(is_rising & is_growing)[:1]:
                row = k * count
                start = Point(t, before[row], inputs.T[k])
                end = Point(t, after[row], inputs.T[k])
                return start, end, float(rises[k, 0])
        return None
