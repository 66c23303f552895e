"""Points at which a V fails.

Points of wide ranges are drawn about a rest, or the truth, and drawn again beside the best of
them.  Whatever an expression says, V' there is that along the rates of the running blocks.
"""

from collections.abc import Iterator, Mapping
from functools import cached_property
from typing import Any

import control
import numpy as np
import sympy

from ...diagrams.on_symbols import Equations
from ...diagrams.symbol_names import TIME
from ...errors import DiagramError
from ...progress.interrupt import check
from .running_rate import Running, rate_of, slopes_of
from .symbolic_loop import Numbers, Point

SEARCHES, PER_SEARCH, ROUNDS, BEST = 20, 500, 15, 5
SURE = 1e-7  # of the size of its terms: a sign that is no rounding


class PointSearch:
    """A search along a diagram's equations, about where its states rest, else 0.

    `V` is on symbols, `name` that of the output which it is, "" of none; `rest` has numbers, or
    other states, for states.
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
        self.inputs = [s for port in eq.inputs.values() for s in port.flat]
        self.random, self.blocks = np.random.default_rng(seed), Running(system, name)
        own = zip(self.blocks.wiring.nodes, eq.parameters.values(), strict=True)
        self.jumping = {  # the symbol that says between which breakpoints a block is -> its place
            p.interval: k
            for k, (node, p) in enumerate(own)
            if node.system.breakpoints_function is not None and "interval" in p._fields
        }
        made = [s for port in eq.signals.values() for s in port.flat]
        self.sources = {  # the symbol of what an opaque block makes -> its place among signals
            made[k]: k
            for node in self.blocks.wiring.nodes
            if node.system.opaque
            for k in range(node.outputs.start, node.outputs.stop)
        }

    @cached_property
    def slopes(self) -> Numbers:
        """dV/dt and dV/dx."""
        return self.numbers(*slopes_of(self.V, self.states))

    def numbers(self, *expressions: sympy.Expr) -> Numbers:
        """Return expressions as numbers at points, with the parameters as they are."""
        found = Numbers(*(one.xreplace(self.eq.values) for one in expressions))
        own = {TIME, *self.states, *self.inputs, *self.jumping, *self.sources}
        if unknown := set(found.symbols) - own:
            raise DiagramError(f"{unknown.pop()} has no number")
        return found

    def known(self, t: np.ndarray, x: np.ndarray, u: np.ndarray) -> dict:
        """Return symbol -> its numbers at points."""
        known = dict(zip([TIME, *self.states, *self.inputs], [t, *x, *u], strict=True))
        for symbol, k in self.jumping.items():
            block, p = self.blocks.wiring.nodes[k].system, self.blocks.sweep.parameters[k]
            known[symbol] = np.array([block.interval_at(one, p) for one in t])
        if self.sources:
            signals = self.blocks.signals(t, x.T, u.T)
            known |= {symbol: signals[k] for symbol, k in self.sources.items()}
        return known

    def value_at(self, expression: sympy.Expr, point: Point) -> float:
        """Return an expression at a point."""
        at = self.known(np.array([point.t]), point.x[:, None], point.u[:, None])
        return float(self.numbers(expression).at(at, 1)[0, 0])

    def draw(self, count: int, still: bool, widest: float = 2.0) -> tuple:
        """Return times, states and inputs of wide ranges, some of them zero."""
        n, m, random = len(self.states), len(self.inputs), self.random
        wide = 10.0 ** random.uniform(-2.5, widest, (2, count))
        x = random.standard_normal((n, count)) * wide[0] * (random.random((n, count)) > 0.15)
        u = random.standard_normal((m, count)) * wide[1] * (not still)
        late = 10.0 ** (3 * random.random(count) * (random.random(count) < 0.3))
        times = random.uniform(0, 20, count) * late * (random.random(count) > 0.1)
        return times, x + self.rest_at(x), u

    def rest_at(self, x: np.ndarray) -> np.ndarray:
        """Return where states (n, ...) rest, those that others rest at as they are."""
        known = dict(zip(self.states, x, strict=True))
        at = self.numbers(*(self.rest.get(s, sympy.S.Zero) for s in self.states))
        return at.at(known, x.shape[1])

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
            at, near = self.draw(PER_SEARCH, still), 1.0
            for _ in range(ROUNDS):
                value, *terms = numbers.at(self.known(*at), PER_SEARCH)
                with np.errstate(all="ignore"):
                    share = value / np.abs(terms).sum(axis=0)
                share = np.where(np.isfinite(share), share, -np.inf)
                best = np.argsort(-share)[:BEST]
                if share[best[0]] > SURE:
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

    def rates_at(self, point: Point, x: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Return V' along the rates that python-control gives, the size of its terms, and V.

        They are at a point with states (n, states) in the place of its own.
        """
        t, u = np.full(len(x), point.t), np.tile(point.u, (len(x), 1))
        rates, V = self.blocks.by_control(t, x, u)
        return *rate_of(self.slopes.at(self.known(t, x.T, u.T), len(x)), rates), V
