"""Random points of a diagram's equations, and V' of the blocks that run at them.

Points are drawn from wide ranges about a rest, or the truth.  V' at a point is computed along the
rates of the running blocks,

    V' = dV/dt + sum_i (dV/dx_i) x_i'

and in discrete time V(x+) - V(x).
"""

from collections.abc import Mapping
from functools import cached_property
from typing import Any

import control
import numpy as np
from sympy import Expr, S

from ...base.errors import DiagramError
from ...engine.diagram.symbol_names import TIME
from ...engine.diagram.symbolic_equations import Equations
from ..algebra.numeric_values import NumericValues
from ..algebra.slopes import along
from .running_blocks import RunningBlocks
from .symbolic_loop import Point

EARLIEST = 1e-6  # s: at t = 0 itself a function of time may have a kink


class RandomPoints:
    """Random points of a diagram's equations, about the rest of its states, or about 0.

    `V` is an expression, `name` its output, or ""; `rest` maps states to numbers or other states.
    """

    def __init__(
        self,
        system: control.NonlinearIOSystem,
        eq: Equations,
        V: Expr,
        name: str,
        rest: Mapping[Any, Expr],
        seed: int,
    ):
        self.eq = eq
        self.V = V
        self.rest = rest
        self.states = [*eq.motion]
        self.inputs = [s for port in eq.inputs.values() for s in port.flat]
        # dV/dt and dV/dx, also of functions with kinks
        self.gradient = [along(V, {s: S.One}) for s in (TIME, *self.states)]
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
        return times, x + self.rest_at(x), u

    def wide(self, count: int, still: bool = False) -> tuple:
        """Return times, states and inputs of wider ranges, in some of which powers overflow."""
        t, x, u = self.draw(count, still, widest=4.0)  # exp overflows
        x[:, ::10] *= 1000
        return t, x, u

    def rest_at(self, x: np.ndarray) -> np.ndarray:
        """Return the rest of states (n, ...), which may depend on other states."""
        values = dict(zip(self.states, x, strict=True))
        rest = self.numbers(*(self.rest.get(s, S.Zero) for s in self.states))
        return rest.at(values, x.shape[1])

    def farther(self, x: np.ndarray, factors: tuple[float, ...]) -> np.ndarray:
        """Return states (len(factors), n) with the distance from the rest times factors."""
        rest = self.rest_at(x[:, None])[:, 0]
        rest = np.where([s in self.rest for s in self.states], rest, x)
        return rest + np.outer(factors, x - rest)

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
