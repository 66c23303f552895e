"""Points at which a V fails, and points at which the running blocks are asked.

Points of wide ranges are drawn, and drawn again beside the best of them.  Whatever an expression
says, V' is that along the rates that python-control itself gives.
"""

from collections.abc import Callable, Iterator
from functools import cached_property
from itertools import chain

import numpy as np
import sympy

from ..diagrams.on_symbols import TIME
from ..errors import DiagramError
from ..progress.interrupt import check
from .own_v import OwnV
from .proving.proof import Step, checked
from .proving.signs import tidied
from .proving.symbolic_loop import Point, numeric
from .proving.words import along

SEARCHES, PER_SEARCH, ROUNDS, BEST = 20, 500, 15, 5
SURE = 1e-7  # of the size of its terms: a sign that is no rounding
CLOSE = 1e-9

Found = tuple[Point, float]  # and what V', or what fails, is there


class Points:
    """What is seen of a V at points."""

    def __init__(self, own: OwnV, seed: int):
        self.own, self.random = own, np.random.default_rng(seed)

    def numeric(self, expression: sympy.Expr) -> Callable[..., np.ndarray]:
        """Return an expression as a function of times, states and inputs, a column each."""
        own = [TIME, *self.own.states, *self.own.inputs]
        function, symbols = numeric(expression.xreplace(self.own.eq.values))
        if unknown := set(symbols) - set(own):
            raise DiagramError(f"{unknown.pop()} has no number")

        def at(t: np.ndarray, x: np.ndarray, u: np.ndarray) -> np.ndarray:
            known = dict(zip(own, [t, *x, *u], strict=True))
            with np.errstate(all="ignore"):
                found = np.asarray(function(*(known[s] for s in symbols)), dtype=float)
            return np.broadcast_to(found, t.shape)

        return at

    def draw(self, count: int, still: bool) -> tuple:
        """Return times, states and inputs of wide ranges, some of them zero."""
        n, m, random = len(self.own.states), len(self.own.inputs), self.random
        wide = 10.0 ** random.uniform(-2.5, 2.0, (2, count))
        x = random.standard_normal((n, count)) * wide[0] * (random.random((n, count)) > 0.15)
        u = random.standard_normal((m, count)) * wide[1] * (not still)
        if self.own.rest is not None:
            rest = [float(self.own.rest[s].subs(self.own.eq.values)) for s in self.own.states]
            x += np.array(rest)[:, None]
        late = 10.0 ** (3 * random.random(count) * (random.random(count) < 0.3))
        return random.uniform(0, 20, count) * late * (random.random(count) > 0.1), x, u

    def highest(self, expression: sympy.Expr, still: bool) -> Iterator[Point]:
        """Yield points at which an expression is positive, beside the size of its terms."""
        parts = sympy.Add.make_args(sympy.expand(expression))
        try:
            value, *sizes = map(self.numeric, (expression, *parts))
        except DiagramError:  # what has no numbers, such as a source of time
            return
        for _ in range(SEARCHES):
            check()
            at, near = self.draw(PER_SEARCH, still), 1.0
            for _ in range(ROUNDS):
                with np.errstate(all="ignore"):
                    found = value(*at) / sum(np.abs(size(*at)) for size in sizes)
                found = np.where(np.isfinite(found), found, -np.inf)
                best = np.argsort(-found)[:BEST]
                if found[best[0]] > SURE:
                    t, x, u = (one[..., best[0]] for one in at)
                    yield Point(float(t), np.array(x), np.array(u), {})
                    break
                keep, near = np.resize(best, PER_SEARCH), 0.7 * near
                at = tuple(self.beside(one[..., keep], near) for one in at)
                at = np.abs(at[0]), at[1], at[2] * (not still)

    def beside(self, values: np.ndarray, near: float) -> np.ndarray:
        """Return numbers beside these, the first as they are."""
        size = near * (np.abs(values) + 0.1 * np.max(np.abs(values), axis=0, initial=0.0) + 1e-3)
        step = size * self.random.standard_normal(values.shape)
        return values + step * (np.arange(values.shape[-1]) >= BEST)

    # --- what the running blocks say --------------------------------------------------------

    @cached_property
    def slopes(self) -> list[Callable[..., np.ndarray]]:
        """dV/dt and dV/dx, as functions."""
        return [self.numeric(along(self.own.V, {s: sympy.S.One})) for s in (TIME, *self.own.states)]

    def rate_at(self, point: Point) -> tuple[float, float]:
        """Return V' along the rates that python-control gives, and the size of its terms."""
        rates = np.ravel(self.own.system.dynamics(point.t, point.x, point.u))
        terms = np.array([slope(*columns(point))[0] for slope in self.slopes]) * [1.0, *rates]
        return float(terms.sum()), float(np.abs(terms).sum())

    def running(self, points: int) -> Step:
        """Return the step that the running blocks give the same V', and V."""
        own = self.own

        def same() -> tuple[bool, str]:
            seen, wanted, V = list[float](), self.numeric(own.rate), self.numeric(own.V)
            t, x, u = self.draw(points, False)
            for k, (right, held) in enumerate(zip(wanted(t, x, u), V(t, x, u), strict=True)):
                value, size = self.rate_at(Point(t[k], x[:, k], u[:, k], {}))
                off = [abs(value - right) / max(size, abs(right), 1e-300)]
                if own.name:
                    made = np.ravel(own.system.output(t[k], x[:, k], u[:, k]))
                    given = made[own.system.output_labels.index(own.name)]
                    off.append(abs(given - held) / max(abs(held), abs(given), 1e-300))
                seen += [max(off)] if np.all(np.isfinite(off)) else []
            said = f"{len(seen)} points, largest difference {max(seen, default=np.inf):.0e}"
            return len(seen) > points / 10 and max(seen) <= CLOSE, said

        return checked("the running blocks give the same V'", "sampled", same, False)

    # --- where a V fails ----------------------------------------------------------------------

    def rises_at(self) -> Found | None:
        """Return a point at which the running blocks have V' > 0, and V' there."""
        rate = tidied(self.own.rate)
        for still in (True, False)[: 1 if self.own.depends_on() else 2]:
            for point in self.highest(rate, still):
                value, size = self.rate_at(point)
                if value > SURE * size:
                    return point, value
        return None

    def not_as_claimed(self) -> Found | None:
        """Return a point at which V' of the running blocks is not as claimed, and V' there."""
        rest, claimed = tidied(self.own.rate - self.own.claim), self.numeric(self.own.claim)
        for point in chain(self.highest(rest, False), self.highest(-rest, False)):
            value, size = self.rate_at(point)
            right = claimed(*columns(point))[0]
            if abs(value - right) > SURE * max(size, abs(right)):
                return point, value
        return None

    def no_least(self) -> Found | None:
        """Return a point at which V is below its value at the rest, and by how much.

        Where no rest is given it is one whose multiples have a V that falls without end: there the
        part of V of highest degree is negative.
        """
        V, states = self.own.V, self.own.states
        if self.own.rest is not None:
            rise = V - V.xreplace(self.own.rest)
        elif V.is_polynomial(*states) and V.has(*states):
            poly = sympy.Poly(V, *states)
            rise = sympy.Add(
                *(
                    c * sympy.prod(s**n for s, n in zip(states, powers, strict=True))
                    for powers, c in poly.terms()
                    if sum(powers) == poly.total_degree()
                )
            )
        else:
            return None
        point = next(self.highest(-rise, True), None)
        return None if point is None else (point, float(self.numeric(rise)(*columns(point))[0]))

    def rises_after(self, rise: sympy.Expr) -> Found | None:
        """Return a point from which V rises at a jump, and by how much."""
        if rise.has(TIME):  # it jumps at some times only
            return None
        point = next(self.highest(rise, True), None)
        return None if point is None else (point, float(self.numeric(rise)(*columns(point))[0]))


def columns(point: Point) -> tuple:
    """Return one point as columns of times, states and inputs."""
    return np.array([point.t]), point.x[:, None], point.u[:, None]
