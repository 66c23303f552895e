"""V and rates of the blocks that run, at many points, and points at which a V fails.

A proof is about expressions; this evaluates the equations themselves:

    V' = dV/dt + sum_i (dV/dx_i) x_i',    x_i' and V of the blocks that run

What is proved of V' on symbols is so of the running blocks where V, and the rates of the states
that it holds, are the same: these are compared, each by itself.  The blocks' records, which machine
code runs, are evaluated at all points at once; their functions at some points, through
python-control.

A point at which V fails is drawn about a rest, or the truth, and drawn again beside the best of
them.  Whatever an expression says, V' there is that along the rates of the running blocks.
"""

from collections.abc import Callable, Iterator, Mapping
from functools import cached_property
from typing import Any

import control
import numpy as np
import sympy

from ...engine.diagram.symbol_names import TIME
from ...engine.diagram.symbolic_equations import Equations
from ...engine.diagram.wiring import wiring_of
from ...engine.solver.evaluation_pass import Sweep
from ...engine.trace.traced_block import on_arrays
from ...errors import DiagramError
from ...progress.interrupt import check
from .facts import along
from .proof import Step, checked
from .symbolic_loop import Numbers, Point, SymbolicLoop

# rates (n, nx) and V (n,); NaN where there are none
Found = tuple[np.ndarray, np.ndarray]


class Running:
    """A diagram as it runs, with an output V, "" for none.

    Each way to evaluate it takes times (n,), states (n, nx) and inputs (n, nu).
    """

    def __init__(self, system: control.NonlinearIOSystem, V: str = "V[0]"):
        self.system, self.wiring = system, wiring_of(system)
        self.V = [system.output_labels.index(V)] if V else []
        self.sweep = Sweep(
            self.wiring, [node.system.parameters for node in self.wiring.nodes]
        )

    def by_control(self, t: np.ndarray, x: np.ndarray, u: np.ndarray) -> Found:
        """Evaluate it as python-control does."""
        system = self.system
        system._update_params({})  # once: it takes as long as the equations

        def one(*point: Any) -> tuple:
            if self.sweep.jumping:  # its states may jump between one point and the next
                system._update_params({})
            try:
                return system._rhs(*point), *(
                    system._out(*point)[self.V] if self.V else [0.0]
                )
            except RuntimeError:  # python-control's word for a NaN on its way
                return np.full(system.nstates, np.nan), np.nan

        with np.errstate(all="ignore"):
            rates, V = zip(*map(one, t, x, u), strict=True)
        return np.array(rates), np.array(V, dtype=float)

    def by_records(self, t: np.ndarray, x: np.ndarray, u: np.ndarray) -> Found:
        """Evaluate the blocks' records at all points at once."""
        signals, rates = self.signals(t, x, u), np.empty(x.shape)
        for k, node in enumerate(self.wiring.nodes):
            if node.system.nstates:
                rates.T[node.states] = self._made(k, "update", signals, t, x, u)
        V = np.zeros(len(t))
        for place in self.V:
            for k, gain in self.wiring.outputs[place].items():
                V += gain * (signals[k] if k >= 0 else u.T[~k])
        return rates, V

    def signals(self, t: np.ndarray, x: np.ndarray, u: np.ndarray) -> np.ndarray:
        """Return the outputs of all blocks, block by block, shape (outputs, n)."""
        nodes = self.wiring.nodes
        signals = np.zeros((nodes[-1].outputs.stop, len(t)))
        for k in self.wiring.order:
            signals[nodes[k].outputs] = self._made(k, "output", signals, t, x, u)
        return signals

    def _made(
        self, k: int, role: str, signals: np.ndarray, t: Any, x: Any, u: Any
    ) -> np.ndarray:
        """Return what block k makes in a role of signals that are known."""
        node, p = self.wiring.nodes[k], self.sweep.parameters[k]
        block = node.system
        if block.breakpoints_function is not None and p.interval < 0:
            p = p._replace(interval=np.array([block.interval_at(one, p) for one in t]))
        fed = np.zeros((block.ninputs, len(t)))
        for wire in node.wires:
            source = (u.T if wire.external else signals)[
                wire.source : wire.source + wire.size
            ]
            fed[wire.to : wire.to + wire.size] += wire.gain * source
        return on_arrays(block, role, t, x.T[node.states], fed, p)


THROUGH_CONTROL = 40  # points at which python-control calls the blocks
CLOSE = 1e-9
# of states, below which a sum may be what is left of its terms
ROUNDING = 16 * 2.0**-52 / CLOSE
LOST = sympy.Dummy("lost", positive=True)  # that share of the largest state
HUGE, TINY = 1e100, 1e-300  # beyond, numbers say nothing
SEARCHES, PER_SEARCH, ROUNDS, BEST = 20, 500, 15, 5
FARTHER = (1.0, 10.0, 100.0)  # times as far from the rest
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
        # dV/dt and dV/dx, words with kinks as well
        self.gradient = [along(V, {s: sympy.S.One}) for s in (TIME, *self.states)]
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
        """The slopes of V as numbers at points."""
        return self.numbers(*self.gradient)

    @cached_property
    def level(self) -> Numbers:
        """V as numbers at points."""
        return self.numbers(self.V)

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
            block, p = (
                self.blocks.wiring.nodes[k].system,
                self.blocks.sweep.parameters[k],
            )
            known[symbol] = np.array([block.interval_at(one, p) for one in t])
        if self.sources:
            signals = self.blocks.signals(t, x.T, u.T)
            known |= {symbol: signals[k] for symbol, k in self.sources.items()}
        return known

    def draw(self, count: int, still: bool, widest: float = 2.0) -> tuple:
        """Return times, states and inputs of wide ranges, some of them zero."""
        n, m, random = len(self.states), len(self.inputs), self.random
        wide = 10.0 ** random.uniform(-2.5, widest, (2, count))
        x = (
            random.standard_normal((n, count))
            * wide[0]
            * (random.random((n, count)) > 0.15)
        )
        u = random.standard_normal((m, count)) * wide[1] * (not still)
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
                    yield Point(float(t), np.array(x), np.array(u))
                    break
                keep, near = np.resize(best, PER_SEARCH), 0.7 * near
                at = tuple(self.beside(one[..., keep], near) for one in at)
                at = np.abs(at[0]), at[1], at[2] * (not still)

    def beside(self, values: np.ndarray, near: float) -> np.ndarray:
        """Return numbers beside these, the first as they are."""
        size = near * (
            np.abs(values) + 0.1 * np.max(np.abs(values), axis=0, initial=0.0) + 1e-3
        )
        step = size * self.random.standard_normal(values.shape)
        return values + step * (np.arange(values.shape[-1]) >= BEST)

    def rates_at(
        self, point: Point, x: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Return V' along the rates that python-control gives, the size of its terms, and V.

        They are at a point with states (n, states) in the place of its own.
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

    def rises_far_off(self, rate: sympy.Expr, held: np.ndarray) -> Iterator[tuple]:
        """Yield points, with V' there, at which V' > 0 also ten and a hundred times as far off.

        Inputs stay as they are, and V' grows with V.  A disturbance that V' < 0 outgrows is passed
        over: it raises V near the rest alone.  `held` are states that are not moved.
        """
        for point in self.highest(rate, still=False):
            rest = np.where(held, point.x, self.rest_at(point.x[:, None])[:, 0])
            farther = rest + np.outer(FARTHER, point.x - rest)
            rises, size, V = self.rates_at(point, farther)
            positive = np.all((rises > SURE * size) & (V > 0))
            if positive and rises[-1] / V[-1] >= 0.5 * rises[0] / V[0]:
                yield point, float(rises[0])

    # --- compared with symbols ------------------------------------------------------------------

    def compare(self, points: tuple, some: int) -> tuple[bool, str]:
        """Compare V and the rates of all states with those of the running blocks.

        At `some` of the points, times (n,), states (nx, n) and inputs (nu, n), python-control calls
        the blocks.
        """
        wanted = [self.V, *self.eq.motion.values()]
        wanted = [e.xreplace(self.eq.values) for e in wanted]
        numbers, known = Numbers(*wanted, *map(size_of, wanted)), self.known(*points)
        known[LOST] = ROUNDING * (1 + np.abs(points[1]).max(axis=0, initial=0.0))
        count, worst = len(points[0]), 0.0
        right, size = np.split(numbers.at(known, count), 2)
        for evaluate, most in (
            (self.blocks.by_control, some),
            (self.blocks.by_records, count),
        ):
            check()
            t, x, _ = here = [one.T[:most] for one in points]
            rates, level = evaluate(*here)
            found = np.vstack([level if self.blocks.V else right[0, :most], rates.T])
            off = _apart(right[:, :most], found, size[:, :most])
            lost = _digits_lost(right[:, :most], found)
            for row, k in np.argwhere(np.isnan(off)):
                # large of inf - inf, not of inf/inf
                at = {s: np.broadcast_to(v, count)[k] for s, v in known.items()}
                exact = wanted[row].evalf(subs=at)
                if exact.is_number and abs(exact) > HUGE:
                    off[row, k] = 0.0
            for row, k in np.argwhere(~((off <= CLOSE) & (lost <= MOST_LOST)))[:1]:
                problem = f"differs by {off[row, k]:.1e} of its terms"
                if off[row, k] <= CLOSE:
                    problem = f"loses {lost[row, k]:.0f} of 16 digits in rounding"
                if np.isnan(off[row, k]):
                    problem = "is no number"
                where = f"t = {t[k]:.4g}, states {_few_numbers(x[k])}"
                return False, f"{self.name_of(row)} {problem} at {where}"
            worst = max(worst, float(off.max(initial=0.0)))
        compared = np.sum(np.all(np.abs(right) < HUGE, axis=0))
        if compared <= count / 10:
            what = f"V or a rate is above {HUGE:.0e} at {count - compared} of {count} points"
            return False, f"{what}, where it is not compared; scale states and gains"
        return True, f"{count} points, largest difference {worst:.0e}"

    def name_of(self, row: int) -> str:
        """Name a row of a comparison: V, or the rate of a state and the block that has it."""
        if row == 0:
            return "V"
        nodes = self.blocks.wiring.nodes
        block = next(n.name for n in nodes if n.states.start < row <= n.states.stop)
        return f"{block}.update: {self.states[row - 1]}'"


def size_of(e: sympy.Expr) -> sympy.Expr:
    """Return an expression with the sizes of all that is added in it, and what rounding may add."""
    if e.is_Add:
        return sympy.Add(LOST, *map(size_of, e.args))
    if e.is_Mul or (e.is_Pow and e.exp.is_Integer and e.exp.is_positive):
        return e.func(*map(size_of, e.args))
    return sympy.Abs(e, evaluate=False)


def _apart(wanted: np.ndarray, found: np.ndarray, size: np.ndarray) -> np.ndarray:
    """Return differences as shares of sizes, by row; 0 of what is too large, as where V is."""
    with np.errstate(all="ignore"):
        off = np.abs(found - wanted) / np.maximum(size, TINY)
    large = ~(np.abs(wanted) < HUGE) & ~(np.abs(found) < HUGE)
    return np.where(large & ~np.isnan(found) | large[0], 0.0, off)


def _few_numbers(values: np.ndarray) -> str:
    """Return numbers as text, of many the first and the last ones."""
    return np.array2string(values, precision=4, threshold=8, max_line_width=200)


DIGITS = 16  # of a double
MOST_LOST = 10  # digits that rounding may take from a rate where its terms cancel


def _digits_lost(wanted: np.ndarray, computed: np.ndarray) -> np.ndarray:
    """Return how many of 16 digits of each rate are wrong, by row.

    A rate that is tiny beside the largest of its row, 1e-6 of it, is measured by that size.
    """
    size = np.where(np.abs(wanted) < HUGE, np.abs(wanted), 0.0)
    largest = size.max(axis=1, keepdims=True, initial=0.0)
    scale = np.maximum(size + 1e-6 * largest, TINY)
    with np.errstate(all="ignore"):
        share = np.abs(computed - wanted) / scale
        digits = np.clip(DIGITS + np.log10(share), 0.0, DIGITS)
    return np.where((np.abs(wanted) < HUGE) & np.isfinite(computed), digits, 0.0)


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
    """Check that the running blocks of a loop that is read have the same V and rates.

    They have their own parameters.
    """

    def same() -> tuple[bool, str]:
        search = search_of(read(), {}, seed)
        holds, detail = search.compare(search.wide(points), THROUGH_CONTROL)
        return holds, of + detail

    return checked(
        f"the running blocks give the same V'{which}", same, "sampled", False
    )
