"""Search for points at which V of a candidate rises, or is below its value at rest.

Points are drawn from wide ranges about a rest, or the truth, and again near the best of them.  Each
is confirmed by the blocks that run: V' at a point is computed along their rates,

    V' = dV/dt + sum_i (dV/dx_i) x_i'

and in discrete time V(x+) - V(x).
"""

from collections.abc import Iterator, Mapping
from functools import cached_property
from types import MappingProxyType
from typing import Any

import control
import numpy as np
import sympy
from sympy import Expr, S, Symbol

from ...base.errors import DiagramError
from ...base.progress.interrupt import check
from ...engine.diagram.symbol_names import TIME
from ...engine.diagram.symbolic_equations import Equations
from ...engine.diagram.wiring import wiring_of
from ...engine.solver.evaluation_pass import Sweep
from ..algebra.numeric_values import NumericValues
from ..algebra.slopes import slope_in
from .statements import Statement, joined, said
from .symbolic_loop import Point

EARLIEST = 1e-6  # s: at t = 0 itself a function of time may have a kink
SEARCHES = 20  # each from new random points
ROUNDS = 15  # of a search
PER_ROUND = 500  # points
BEST = 5  # points of a round that the next one starts from
DISTANCES = (1.0, 10.0, 100.0)  # factors of the distance from the rest
FAR_OFF = 1e8  # the same, of what may outgrow a large input
ENLARGED = (1e4, 1e3, 100.0, 10.0, 1.0)  # so that a point is not near the rest
LARGE_STATE = 10.0  # to which points are enlarged
SIGNIFICANT = 1e-7  # of the size of its terms; smaller values may be rounding errors
PER_JUMP = 300  # points
LATEST_JUMP = 1000.0  # time until which jumps are searched
NO_SETS = MappingProxyType[Any, tuple]({})
Failure = tuple[Point, float]  # a point, and V', or the rise of V, at the point
# rates (n, nx) and V (n,); NaN where there are none
Values = tuple[np.ndarray, np.ndarray]


class RunningBlocks:
    """The blocks of a diagram as they run, with an output V, "" for none.

    Times are (n,), states (n, nx) and inputs (n, nu).
    """

    def __init__(self, system: control.NonlinearIOSystem, V: str = "V[0]"):
        self.system, self.wiring = system, wiring_of(system)
        self.V = [system.output_labels.index(V)] if V else []
        self.sweep = Sweep(self.wiring, self.wiring.parameters())

    def by_control(self, t: np.ndarray, x: np.ndarray, u: np.ndarray) -> Values:
        """Return rates and V as python-control computes them."""
        system = self.system
        system._update_params({})  # once: it takes as long as the equations

        def at_point(*point: Any) -> tuple:
            if self.sweep.jumping:  # its states may jump between one point and the next
                system._update_params({})
            try:
                return system._rhs(*point), *(
                    system._out(*point)[self.V] if self.V else [0.0]
                )
            except RuntimeError:  # python-control's word for a NaN on its way
                return np.full(system.nstates, np.nan), np.nan

        with np.errstate(all="ignore"):
            rates, V = zip(*map(at_point, t, x, u), strict=True)
        return np.array(rates), np.array(V, dtype=float)

    def by_records(self, t: np.ndarray, x: np.ndarray, u: np.ndarray) -> Values:
        """Return rates and V of the blocks' records at all points at once."""
        signals, rates = self.signals(t, x, u), np.empty(x.shape)
        for k, node in enumerate(self.wiring.nodes):
            if node.system.nstates:
                rates.T[node.states] = self._values_of(k, "update", signals, t, x, u)
        V = np.zeros(len(t))
        for argument in self.V:
            for k, gain in self.wiring.outputs[argument].items():
                V += gain * (signals[k] if k >= 0 else u.T[~k])
        return rates, V

    def signals(self, t: np.ndarray, x: np.ndarray, u: np.ndarray) -> np.ndarray:
        """Return the outputs of all blocks, block by block, shape (outputs, n)."""
        nodes = self.wiring.nodes
        signals = np.zeros((nodes[-1].outputs.stop, len(t)))
        for k in self.wiring.order:
            signals[nodes[k].outputs] = self._values_of(k, "output", signals, t, x, u)
        return signals

    def _values_of(
        self, k: int, role: str, signals: np.ndarray, t: Any, x: Any, u: Any
    ) -> np.ndarray:
        """Return the outputs or the rates of block k, of signals that are known."""
        node, p = self.wiring.nodes[k], self.sweep.parameters[k]
        block = node.system
        fed = np.zeros((block.ninputs, len(t)))
        for wire in node.wires:
            source = (u.T if wire.external else signals)[
                wire.source : wire.source + wire.size
            ]
            fed[wire.to : wire.to + wire.size] += wire.gain * source
        return block.on_arrays(role, t, x.T[node.states], fed, p)


class PointSearch:
    """Random points about the rest of states, or 0, and searches for those at which V fails.

    `V` is an expression, `name` its output, or ""; `rest` maps states to numbers or other states,
    `kept` states and inputs to the two ends between which they stay, None for no end; `solved`
    states to what the others make them.
    """

    def __init__(
        self,
        system: control.NonlinearIOSystem,
        eq: Equations,
        V: Expr,
        name: str,
        rest: Mapping[Any, Expr],
        seed: int,
        kept: Mapping[Any, tuple] = NO_SETS,
        solved: Mapping[Any, Expr] = NO_SETS,
    ):
        self.eq = eq
        self.V = V
        self.rest = rest
        self.states = [*eq.motion]
        self.solved = solved
        self.inputs = [s for port in eq.inputs.values() for s in port.flat]
        ends = [kept.get(s, (None, None)) for s in (*self.states, *self.inputs)]
        self.ends = np.array(ends, dtype=float).reshape(-1, 2)  # NaN: none
        # dV/dt and dV/dx, also of functions with kinks
        self.gradient = [slope_in(V, s) for s in (TIME, *self.states)]
        self.random = np.random.default_rng(seed)
        self.blocks = RunningBlocks(system, name)
        # the symbol of a block's interval between breakpoints -> the index of the block
        self.jumping: dict[Any, int] = {}
        # the symbol of an output of an opaque block -> its index among signals
        self.sources: dict[Any, int] = {}
        outputs = [s for port in eq.signals.values() for s in port.flat]
        nodes = self.blocks.wiring.nodes
        for k, (node, p) in enumerate(zip(nodes, eq.parameters.values(), strict=True)):
            has_breakpoints = node.system.breakpoints_function is not None
            if has_breakpoints and "interval" in p._fields:
                self.jumping[p.interval] = k
            if node.system.opaque:
                indices = range(node.outputs.start, node.outputs.stop)
                self.sources |= {outputs[index]: index for index in indices}

    @cached_property
    def slopes(self) -> NumericValues:
        """The slopes of V as numbers at points."""
        return self.numbers(*self.gradient)

    @cached_property
    def level(self) -> NumericValues:
        """V as numbers at points."""
        return self.numbers(self.V)

    def numbers(self, *expressions: Expr) -> NumericValues:
        """Return expressions as numbers at points, with the values of parameters."""
        numbers = NumericValues(*(e.xreplace(self.eq.values) for e in expressions))
        symbols = {TIME, *self.states, *self.inputs, *self.jumping, *self.sources}
        if unknown := {*numbers.symbols} - symbols:
            raise DiagramError(f"{unknown.pop()} has no value")
        return numbers

    def values(self, t: np.ndarray, x: np.ndarray, u: np.ndarray) -> dict:
        """Return symbol -> its numbers at points."""
        values = dict(zip([TIME, *self.states, *self.inputs], [t, *x, *u], strict=True))
        for symbol, k in self.jumping.items():
            block = self.blocks.wiring.nodes[k].system
            p = self.blocks.sweep.parameters[k]
            values[symbol] = np.array([block.interval_at(time, p) for time in t])
        if self.sources:
            signals = self.blocks.signals(t, x.T, u.T)
            values |= {symbol: signals[k] for symbol, k in self.sources.items()}
        return values

    def text_of(self, point: Point) -> Statement:
        """Return a point and the parameters' values: x = 2, u = 0, a = 1."""
        inputs = (getattr(f, "func", f) for f in self.inputs)
        names = [TIME, *self.states, *(Symbol(f"{f}") for f in inputs), *self.eq.values]
        numbers = [point.t, *point.x, *np.ravel(point.u), *self.eq.values.values()]
        pairs = zip(names, map(float, numbers), strict=True)
        return joined(
            ", ", (said("{} = {}", s, f"{number:.6g}") for s, number in pairs)
        )

    def draw(self, count: int, still: bool, widest: float = 2.0) -> tuple:
        """Return times, states and inputs of wide ranges, some of them zero.

        Inputs are zero if `still`; `widest` is the logarithm of the largest size.
        """
        random = self.random
        sizes = 10.0 ** random.uniform(-2.5, widest, (2, count))
        x = random.standard_normal((len(self.states), count)) * sizes[0]
        x *= random.random(x.shape) > 0.15
        u = random.standard_normal((len(self.inputs), count)) * sizes[1] * (not still)
        exponents = 3 * random.random(count) * (random.random(count) < 0.3)
        times = random.uniform(0, 20, count) * 10.0**exponents
        times *= random.random(count) > 0.1
        times = np.maximum(times, EARLIEST)
        return times, *self.both_inside(x + self.rest_at(x), u)

    def inside(self, x: np.ndarray) -> np.ndarray:
        """Return states (n, states) in the sets that the diagram keeps."""
        low, high = self.ends[: x.shape[1]].T
        x = np.fmax(np.fmin(x, high), low)
        if self.solved:
            values = dict(zip(self.states, x.T, strict=False))
            given = self.numbers(*self.solved.values()).at(values, len(x))
            x[:, [self.states.index(s) for s in self.solved]] = given.T
        return x

    def both_inside(self, x: np.ndarray, u: np.ndarray) -> list[np.ndarray]:
        """Return states and inputs in their sets and between their bounds, as columns."""
        points = self.inside(np.vstack([x, u]).T).T
        return np.split(points, [len(x)])

    def wide(self, count: int) -> tuple:
        """Return times, states and inputs of wider ranges, in some of which powers overflow."""
        t, x, u = self.draw(count, False, widest=4.0)  # exp overflows
        x[:, ::10] *= 1000
        return t, *self.both_inside(x, u)

    def rest_at(self, x: np.ndarray) -> np.ndarray:
        """Return the rest of states (n, ...), which may depend on other states."""
        values = dict(zip(self.states, x, strict=True))
        equilibrium = self.numbers(*(self.rest.get(s, S.Zero) for s in self.states))
        return equilibrium.at(values, x.shape[1])

    def scaled(
        self, x: np.ndarray, factors: tuple[float, ...], fixed: Any = ()
    ) -> np.ndarray:
        """Return states (len(factors), n) with the distance from the rest times factors.

        States that are `fixed` are not moved.
        """
        is_fixed = [s in fixed for s in self.states]
        equilibrium = np.where(is_fixed, x, self.rest_at(x[:, None])[:, 0])
        return self.inside(equilibrium + np.outer(factors, x - equilibrium))

    def farther(self, x: np.ndarray, factors: tuple[float, ...]) -> np.ndarray:
        """Return scaled states; those without a rest are not moved."""
        return self.scaled(x, factors, {*self.states} - self.rest.keys())

    def value_at(self, expression: Expr, point: Point) -> float:
        """Return an expression at a point."""
        t, x, u = np.array([point.t]), point.x[:, None], point.u[:, None]
        return float(self.numbers(expression).at(self.values(t, x, u), 1)[0, 0])

    def rates_at(
        self, point: Point, x: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Return V' along the rates of python-control, the size of its terms, and V.

        The time and the inputs are those of a point; x are the states, (n, states).
        """
        t = np.full(len(x), point.t)
        u = np.tile(point.u, (len(x), 1))
        rates, V = self.blocks.by_control(t, x, u)
        values = self.values(t, x.T, u.T)
        slopes = self.slopes.at(values, len(x))
        if not self.blocks.V:  # V is no output of the diagram
            (V,) = self.level.at(values, len(x))
        if self.eq.discrete:
            (after,) = self.level.at(self.values(t, rates.T, u.T), len(x))
            return after - V, np.abs(after) + np.abs(V), V
        with np.errstate(all="ignore"):
            terms = slopes * np.vstack([np.ones(len(rates)), rates.T])
            terms = np.where(np.equal(slopes, 0.0), 0.0, terms)
            return terms.sum(axis=0), np.abs(terms).sum(axis=0), V

    # --- searches ------------------------------------------------------------------------------

    def highest(self, expression: Expr, still: bool) -> Iterator[Point]:
        """Yield points at which an expression is positive, relative to the size of its terms."""
        terms = sympy.Add.make_args(sympy.expand(expression))
        self.random = np.random.default_rng(0)  # a status does not depend on `seed`
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
            points = np.abs(t), *self.both_inside(x, u * (not still))
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

    def below_rest(
        self, V: Expr, states: Any, rest: Mapping[Any, Expr] | None
    ) -> Failure | None:
        """Return a point at which V is below its value at a rest, and by how much.

        If no rest is given it is one whose multiples have a V that falls without end: there the
        part of V of highest degree is negative.
        """
        if rest is not None:
            return self.sign_at(V - V.xreplace(rest), -1)
        if not (V.is_polynomial(*states) and V.has(*states)):
            return None
        scale = sympy.Dummy()
        scaled = sympy.Poly(V.xreplace({s: scale * s for s in states}), scale)
        return self.sign_at(scaled.LC(), -1)

    def rate_above(self, rate: Expr, claim: Expr, still: bool) -> Failure | None:
        """Return a point at which V' of the running blocks is above a claim, and V'.

        V has a value there: the logarithm of 1 - x**2 may have a slope where it has none.
        """
        for highest in self.highest(rate - claim, still):
            states = self.scaled(highest.x, ENLARGED)
            is_small = np.abs(states).max(axis=1, initial=0.0) <= LARGE_STATE
            is_small[-1] = True  # the point itself
            points = [highest._replace(x=x) for x in states[is_small]]
            found = np.array(self.rates_at(highest, states[is_small]))
            for point, (value, size, V) in zip(points, found.T, strict=True):
                claimed = self.value_at(claim, point)
                excess = value - claimed if np.isfinite(V) else -np.inf
                if excess > SIGNIFICANT * max(size, abs(claimed)):
                    return point, float(value)
        return None

    def rises_far_off(self, rate: Expr, fixed: Any = ()) -> Failure | None:
        """Return a point, and V', at which V' > 0 also at 10 and 100 times the distance.

        Inputs are unchanged, and V' grows with V.  A disturbance that V' < 0 outgrows is skipped:
        it raises V near the rest alone.  States that are `fixed` are not moved.
        """
        for point in self.highest(rate, still=False):
            states = self.scaled(point.x, (*DISTANCES, FAR_OFF), fixed)
            rates = np.array(self.rates_at(point, states))
            if rates[0, -1] < 0:  # outgrown
                continue
            rises, size, V = rates[:, :-1]
            is_positive = np.all((rises > SIGNIFICANT * size) & (V > 0))
            if is_positive and rises[-1] / V[-1] >= 0.5 * rises[0] / V[0]:
                return point, float(rises[0])
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
