"""Random points at which V of a candidate rises, or is below its value at the rest.

Points of wide ranges are drawn about a rest, or the truth, and drawn again next to the best of
them.  Whatever an expression says, V' at a point is that along the rates of the running blocks,

    V' = dV/dt + sum_i (dV/dx_i) x_i'
"""

from collections.abc import Iterator, Mapping
from functools import cached_property
from typing import Any

import control
import numpy as np
import sympy

from ...base.errors import DiagramError
from ...base.progress.interrupt import check
from ...engine.diagram.symbol_names import TIME
from ...engine.diagram.symbolic_equations import Equations
from .facts import along
from .running_blocks import RunningBlocks
from .symbolic_loop import Numbers, Point

SEARCHES, PER_SEARCH, ROUNDS, BEST = 20, 500, 15, 5
FARTHER = (1.0, 10.0, 100.0)  # times as far from the rest
SURE = 1e-7  # of the size of its terms: a sign that is no rounding
TRIED, UNTIL = 300, 1000.0  # points for each jump, and until when jumps are looked for
Failure = tuple[Point, float]  # a point, and V', or the rise of V, there


class PointSearch:
    """Random points along a diagram's equations, about where its states rest, or about 0.

    `V` is an expression, `name` the output that it is, "" for none; `rest` gives states as numbers,
    or as other states.
    """

    def __init__(
        self,
        system: control.NonlinearIOSystem,
        eq: Equations,
        V: sympy.Expr,
        name: str,
        rest: Mapping[Any, sympy.Expr],
        seed: int,
    ):
        self.eq, self.V, self.rest = eq, V, rest
        self.states = [*eq.motion]
        # dV/dt and dV/dx, words with kinks as well
        self.gradient = [along(V, {s: sympy.S.One}) for s in (TIME, *self.states)]
        self.inputs = [s for port in eq.inputs.values() for s in port.flat]
        self.random, self.blocks = (
            np.random.default_rng(seed),
            RunningBlocks(system, name),
        )
        nodes = self.blocks.wiring.nodes
        # the symbol of a block's interval between breakpoints -> the index of the block
        self.jumping = {
            p.interval: k
            for k, (node, p) in enumerate(
                zip(nodes, eq.parameters.values(), strict=True)
            )
            if node.system.breakpoints_function is not None and "interval" in p._fields
        }
        outputs = [s for port in eq.signals.values() for s in port.flat]
        # the symbol of an output of an opaque block -> its index among signals
        self.sources = {
            outputs[k]: k
            for node in nodes
            if node.system.opaque
            for k in range(node.outputs.start, node.outputs.stop)
        }

    @cached_property
    def slopes(self) -> Numbers:
        """The slopes of V as numbers at points."""
        return self.numbers(*self.gradient)

    @cached_property
    def level(self) -> Numbers:
        """V as numbers at points."""
        return self.numbers(self.V)

    def numbers(self, *expressions: sympy.Expr) -> Numbers:
        """Return expressions as numbers at points, with the parameters as they are."""
        numbers = Numbers(*(e.xreplace(self.eq.values) for e in expressions))
        known = {TIME, *self.states, *self.inputs, *self.jumping, *self.sources}
        if unknown := set(numbers.symbols) - known:
            raise DiagramError(f"{unknown.pop()} has no number")
        return numbers

    def known(self, t: np.ndarray, x: np.ndarray, u: np.ndarray) -> dict:
        """Return symbol -> its numbers at points."""
        known = dict(zip([TIME, *self.states, *self.inputs], [t, *x, *u], strict=True))
        for symbol, k in self.jumping.items():
            block = self.blocks.wiring.nodes[k].system
            p = self.blocks.sweep.parameters[k]
            known[symbol] = np.array([block.interval_at(time, p) for time in t])
        if self.sources:
            signals = self.blocks.signals(t, x.T, u.T)
            known |= {symbol: signals[k] for symbol, k in self.sources.items()}
        return known

    def draw(self, count: int, still: bool, widest: float = 2.0) -> tuple:
        """Return times, states and inputs of wide ranges, some of them zero."""
        n, m, random = len(self.states), len(self.inputs), self.random
        sizes = 10.0 ** random.uniform(-2.5, widest, (2, count))
        x = random.standard_normal((n, count)) * sizes[0]
        x *= random.random((n, count)) > 0.15
        u = random.standard_normal((m, count)) * sizes[1] * (not still)
        late = 10.0 ** (3 * random.random(count) * (random.random(count) < 0.3))
        times = random.uniform(0, 20, count) * late * (random.random(count) > 0.1)
        return times, x + self.rest_at(x), u

    def wide(self, count: int, still: bool = False) -> tuple:
        """Return times, states and inputs of wider ranges, some of them so wide that powers end."""
        t, x, u = self.draw(count, still, widest=4.0)  # exp is too large
        x[:, ::10] *= 1000
        return t, x, u

    def rest_at(self, x: np.ndarray) -> np.ndarray:
        """Return where states (n, ...) rest, those that others rest at as they are."""
        known = dict(zip(self.states, x, strict=True))
        rest = self.numbers(*(self.rest.get(s, sympy.S.Zero) for s in self.states))
        return rest.at(known, x.shape[1])

    def farther(self, x: np.ndarray, times: tuple[float, ...]) -> np.ndarray:
        """Return states (len(times), n) as many times as far from where they rest."""
        rest = self.rest_at(x[:, None])[:, 0]
        rest = np.where([s in self.rest for s in self.states], rest, x)
        return rest + np.outer(times, x - rest)

    def highest(self, expression: sympy.Expr, still: bool) -> Iterator[Point]:
        """Yield points at which an expression is positive, beside the size of its terms."""
        parts = sympy.Add.make_args(sympy.expand(expression))
        try:
            numbers = self.numbers(expression, *parts)
        except DiagramError:  # what has no numbers, such as a source of time
            return
        for _ in range(SEARCHES):
            check()
            points, radius = self.draw(PER_SEARCH, still), 1.0
            for _ in range(ROUNDS):
                value, *terms = numbers.at(self.known(*points), PER_SEARCH)
                with np.errstate(all="ignore"):
                    share = value / np.abs(terms).sum(axis=0)
                share = np.where(np.isfinite(share), share, -np.inf)
                best = np.argsort(-share)[:BEST]
                if share[best[0]] > SURE:
                    t, x, u = (values[..., best[0]] for values in points)
                    yield Point(float(t), np.array(x), np.array(u))
                    break
                centers, radius = np.resize(best, PER_SEARCH), 0.7 * radius
                t, x, u = (self.near(v[..., centers], radius) for v in points)
                points = np.abs(t), x, u * (not still)

    def near(self, values: np.ndarray, radius: float) -> np.ndarray:
        """Return numbers near these, the first `BEST` as they are."""
        largest = np.max(np.abs(values), axis=0, initial=0.0)
        size = radius * (np.abs(values) + 0.1 * largest + 1e-3)
        step = size * self.random.standard_normal(values.shape)
        return values + step * (np.arange(values.shape[-1]) >= BEST)

    def rates_at(
        self, point: Point, x: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Return V' along the rates of python-control, the size of its terms, and V.

        Time and inputs are those of a point; x are the states, (n, states).
        """
        t, u = np.full(len(x), point.t), np.tile(point.u, (len(x), 1))
        rates, V = self.blocks.by_control(t, x, u)
        known = self.known(t, x.T, u.T)
        slopes = self.slopes.at(known, len(x))
        if not self.blocks.V:  # V is no output of the diagram
            (V,) = self.level.at(known, len(x))
        with np.errstate(all="ignore"):
            terms = slopes * np.vstack([np.ones(len(rates)), rates.T])
            terms = np.where(np.equal(slopes, 0.0), 0.0, terms)
            return terms.sum(axis=0), np.abs(terms).sum(axis=0), V

    def sign_at(self, expression: sympy.Expr, sign: int) -> Failure | None:
        """Return a point at which an expression has a sign, and its value there."""
        point = next(self.highest(sign * expression, True), None)
        return None if point is None else (point, self.value_at(expression, point))

    def value_at(self, expression: sympy.Expr, point: Point) -> float:
        """Return an expression at a point."""
        known = self.known(np.array([point.t]), point.x[:, None], point.u[:, None])
        return float(self.numbers(expression).at(known, 1)[0, 0])

    def rate_above(
        self, rate: sympy.Expr, claim: sympy.Expr, still: bool, sign: int = 1
    ) -> Failure | None:
        """Return a point at which V' of the running blocks is above a claim, and V' there.

        With `sign` -1 it is below the claim.
        """
        for point in self.highest(sign * (rate - claim), still):
            (value,), (size,), _ = self.rates_at(point, point.x[None])
            claimed = self.value_at(claim, point)
            if sign * (value - claimed) > SURE * max(size, abs(claimed)):
                return point, float(value)
        return None

    def rises_far_off(self, rate: sympy.Expr, fixed: set) -> Failure | None:
        """Return a point, with V' there, at which V' > 0 also 10 and 100 times as far off.

        Inputs stay as they are, and V' grows with V.  A disturbance that V' < 0 outgrows is passed
        over: it raises V near the rest alone.  States that are `fixed` are not moved.
        """
        is_fixed = np.array([s in fixed for s in self.states])
        for point in self.highest(rate, still=False):
            rest = np.where(is_fixed, point.x, self.rest_at(point.x[:, None])[:, 0])
            farther = rest + np.outer(FARTHER, point.x - rest)
            rises, size, V = self.rates_at(point, farther)
            positive = np.all((rises > SURE * size) & (V > 0))
            if positive and rises[-1] / V[-1] >= 0.5 * rises[0] / V[0]:
                return point, float(rises[0])
        return None

    def below_rest(self, rise: sympy.Expr) -> Failure | None:
        """Return a point at which V of the blocks is below V at the rest, and by how much."""
        for point in self.highest(-rise, still=True):
            _, _, V = self.rates_at(point, self.farther(point.x, (1.0, 0.0)))
            if V[1] - V[0] > SURE * np.abs(V).max():
                return point, float(V[0] - V[1])
        return None

    def rising_jump(self) -> tuple[Point, Point, float] | None:
        """Return where V of the running blocks rises at a jump, before and after, and by how much.

        V rises there at all distances, the more the farther off.  At a jump that forgets a share of
        everything it does not: errors stay bounded by that.
        """
        sweep = self.blocks.sweep
        for t in sweep.breakpoints(0.0, UNTIL)[: len(FARTHER)].tolist():
            sweep.enter(t)
            _, states, inputs = self.draw(TRIED, still=False)
            before = np.concatenate([self.farther(x, FARTHER) for x in states.T])
            u = np.repeat(inputs.T, len(FARTHER), axis=0)
            times = np.full(len(before), t)
            pairs = zip(before, u, strict=True)
            after = np.array([sweep.jump(t, x, v, sweep.jumping) for x, v in pairs])
            V = [self.blocks.by_records(times, x, u)[1] for x in (before, after)]
            rises = np.reshape(V[1] - V[0], (TRIED, -1))
            sure = np.all(rises > SURE * np.abs(V[0]).reshape(rises.shape), axis=1)
            for k in np.flatnonzero(sure & (rises[:, -1] >= 10 * rises[:, 0]))[:1]:
                row = k * len(FARTHER)
                ends = [Point(t, x[row], inputs.T[k]) for x in (before, after)]
                return ends[0], ends[1], float(rises[k, 0])
        return None
