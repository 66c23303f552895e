"""V' of the blocks that run, called at random points.

A proof is about expressions; this asks the equations themselves.  Along the rates r that they
give at (t, x, u), at the first points those that python-control gives,

    V' = D(h) = (V(x + h r) - V(x - h r))/(2 h)            V of degree two and less
    V' = (4 D(h/2) - D(h))/3                               any other V

which is exact for a V of degree four and less, whatever h.
"""

from collections.abc import Mapping
from typing import Any, NamedTuple

import control
import numpy as np
import sympy

from ...diagrams.interconnection import changed_parameters
from ...diagrams.wiring import Wiring, wiring_of
from ...equations.block import Block
from ...equations.symbolic import NUMBERS
from ...errors import DiagramError
from ...native.sweep import Sweep
from ...progress.interrupt import check
from .array_loop import TIME, blocks_of
from .proof import Step, checked
from .random_points import Draw, Point, equate_x_and_z, symbol_values
from .symbolic_loop import SymbolicLoop

PER_DRAW = 100  # points for each draw of the parameters
THROUGH_CONTROL = 20  # points at which python-control gives the rates
CLOSE = 1e-9
HUGE = 1e100  # beyond, numbers say nothing
UNEVEN = 1e13  # a ratio of V's weights beyond which the greater hides the lesser


class RunningRate:
    """V and V' of a diagram, from its running blocks, one of which makes V[1]."""

    def __init__(self, diagram: control.NonlinearIOSystem):
        self.diagram, self.wiring = diagram, wiring_of(diagram)
        self.blocks = blocks_of(self.wiring)
        made = [k for k, block in enumerate(self.blocks) if block.output_ports == {"V": 1}]
        if not made:
            raise DiagramError("no block makes V[1]; wire a candidate such as blocks.lyapunov")
        moving = [k for k, block in enumerate(self.blocks) if block.nstates]
        self._needed = [_ancestors(self.wiring, self.blocks, own) for own in (moving, made)]
        self._left = THROUGH_CONTROL
        self._counted = any("interval" in block.parameters._fields for block in self.blocks)
        self._place = self.wiring.nodes[made[0]].outputs.start

    def set(self, params: Mapping[str, Any]) -> None:
        """Set the parameters with which the blocks run."""
        self._params = dict(params)
        if self._left > 0:
            self.diagram._update_params(self._params)
        found = changed_parameters(self.wiring, params)
        self._motion, self._level = (Sweep(self.wiring, found, only) for only in self._needed)

    def value(self, t: float, x: np.ndarray, u: np.ndarray) -> float:
        """Return V."""
        return float(self._level.evaluate(t, x, u)[self._place])

    def rates(self, t: float, x: np.ndarray, u: np.ndarray) -> np.ndarray:
        """Return the rates of all states; NaN where there are none."""
        self._left -= 1
        try:
            if self._left >= 0:
                if self._counted:
                    self.diagram._update_params(self._params)  # which interval it is
                return self.diagram._rhs(t, x, u)
            for sweep in (self._motion, self._level) if self._counted else ():
                sweep.enter(t)
            return self._motion.derivative(t, x, u)
        except RuntimeError:  # python-control's word for a NaN on its way
            return np.full(len(x), np.nan)

    def near_least(self, x: np.ndarray, u: np.ndarray, random: np.random.Generator) -> np.ndarray:
        """Return points (n, states) at which each error adds alike to V, which is a polynomial.

        Elsewhere an error of small weight is lost in one of great weight.
        """
        n, zero, none = x.shape[1], np.zeros(x.shape[1]), u[0] * 0.0
        one = np.eye(n)

        def value(at: np.ndarray) -> float:
            return self.value(0.0, at, none)

        V0, ahead, behind = value(zero), [value(e) for e in one], [value(-e) for e in one]
        slope = 0.5 * np.subtract(ahead, behind)
        bent = np.add(ahead, behind) - 2 * V0
        weights = bent[bent > 0]
        if not len(weights) or not np.all(np.isfinite(bent)):
            return x
        if weights.max() > UNEVEN * weights.min():
            raise DiagramError(
                f"V has weights from {weights.min():.1e} to {weights.max():.1e}, and what is wrong "
                "in the lesser cannot be seen; give gains that differ less"
            )
        sizes = np.where(bent > 0, 1.0 / np.sqrt(np.where(bent > 0, bent, 1.0)), 0.0)
        H = np.array([[value(a + b) for b in one] for a in one])
        H += V0 - np.array(ahead)[:, None] - np.array(ahead)[None, :]
        H[np.diag_indices(n)] = bent
        scaled = sizes[:, None] * H * sizes
        least = sizes * np.linalg.lstsq(scaled, -sizes * slope, rcond=1e-9)[0]
        wide = 10.0 ** random.uniform(-1, 1, (len(x), 1))
        return least + wide * sizes * random.standard_normal(x.shape)

    def rate(self, t: float, x: np.ndarray, u: np.ndarray, degree: float) -> tuple[float, float]:
        """Return V', and V over the time between which it is taken."""
        rates = self.rates(t, x, u)
        fastest = np.max(np.abs(rates))
        if not 0.0 < fastest < np.inf:
            return (0.0, 1.0) if fastest == 0.0 else (np.nan, np.nan)
        h = (0.1 if degree <= 4 else 2e-3) * max(np.max(np.abs(x)), 1e-3) / fastest
        ahead, behind = self.value(t, x + h * rates, u), self.value(t, x - h * rates, u)
        wide, scale = (ahead - behind) / (2 * h), max(abs(ahead), abs(behind)) / h
        if degree <= 2:
            return wide, scale
        half = 0.5 * h * rates
        near = (self.value(t, x + half, u) - self.value(t, x - half, u)) / h
        return (4 * near - wide) / 3, scale


def _ancestors(wiring: Wiring, blocks: list[Block], own: list[int]) -> set[int]:
    """Return blocks and all that what they put out, and their rates, are made of."""
    made = {
        j: k
        for k, node in enumerate(wiring.nodes)
        for j in range(node.outputs.start, node.outputs.stop)
    }
    found, stack = set(own), list(own)
    while stack:
        k = stack.pop()
        read = k in own or blocks[k].feedthrough
        for wire in wiring.nodes[k].wires if read else ():
            for j in range(wire.source, wire.source + wire.size):
                if not wire.external and made[j] not in found:
                    found.add(made[j])
                    stack.append(made[j])
    return found


class Comparison(NamedTuple):
    """The outcome of calling the blocks."""

    points: int  # how many were compared
    worst: float  # largest difference, of the size of V over the time between
    where: Point | None  # the first at which they differ

    @property
    def outcome(self) -> tuple[bool, str]:
        """Whether they agree, and what was seen."""
        if self.where is not None:
            return False, f"differs by {self.worst:.1e} of V at {self.where}"
        return True, f"{self.points} points, largest difference {self.worst:.0e} of V"


def compared(
    diagram: control.NonlinearIOSystem,
    loop: SymbolicLoop,
    wanted: sympy.Expr,
    count: int,
    seed: int = 0,
    tied: Mapping[str, Any] | None = None,
    kept: tuple[str, ...] = (),
) -> Comparison:
    """Compare V' of the running blocks with `wanted` at random points, to 1e-9.

    The first 100 points have the blocks' own parameters, half of them near the least V, then every
    100 others; blocks in `kept`
    keep theirs, and a name in `tied` follows from expressions of the other parameters.
    """
    running = RunningRate(diagram)
    draw = Draw(running.blocks, seed)
    function, symbols = numeric(wanted)
    degree = degree_of(loop)
    worst, done = 0.0, 0
    try:
        while done < count:
            check()
            values = draw.parameters(kept if done else [block.name for block in running.blocks])
            for name, expressions in (tied or {}).items():
                known = symbol_values(loop, draw, values)
                numbers = np.array([float(e.subs(known)) for e in expressions])
                shape = np.shape(values[name])  # one number where all of them are one symbol
                values[name] = numbers.reshape(shape) if shape else numbers[0]
            params = draw.params(values)
            running.set(params)
            size = min(PER_DRAW, count - done)
            x, u = draw.points(size, diagram.nstates), draw.points(size, diagram.ninputs)
            if not done and degree <= 4:
                half = size // 2
                x[half:] = running.near_least(x[half:], u, draw.random)
            equate_x_and_z(loop, x, draw.random)
            times = draw.random.uniform(0.0, 100.0, size)
            known = symbol_values(loop, draw, values, times, x, u)
            with np.errstate(all="ignore"):
                right = np.broadcast_to(function(*(known[s] for s in symbols)), size)
            for k in range(size):
                rate, scale = running.rate(times[k], x[k], u[k], degree)
                if not abs(right[k]) < HUGE and not abs(rate) < HUGE:
                    continue
                off = abs(rate - right[k]) / (CLOSE * max(scale, abs(right[k])))
                if not off <= 1.0:
                    return Comparison(
                        done + k + 1, off * CLOSE, Point(times[k], x[k], u[k], params)
                    )
                worst = max(worst, off * CLOSE)
            done += size
    finally:
        diagram._update_params({})
    return Comparison(done, worst, None)


def running_step(
    diagram: control.NonlinearIOSystem, loop: SymbolicLoop, wanted: sympy.Expr, points: int
) -> Step:
    """Check that the running blocks give the V' that is wanted."""

    def same() -> tuple[bool, str]:
        return compared(diagram, loop, wanted, points).outcome

    return checked("the running blocks give the same V'", "sampled", same, False)


def numeric(expression: sympy.Expr) -> tuple[Any, list[Any]]:
    """Return an expression as a function of arrays, and its symbols."""
    inputs = [f for f in expression.atoms(sympy.core.function.AppliedUndef) if f.args == (TIME,)]
    words = {str(f.func) for f in expression.atoms(sympy.core.function.AppliedUndef)} - {
        str(f.func) for f in inputs
    }
    if expression.has(sympy.Derivative) or words - set(NUMBERS):
        unknown = ", ".join(sorted(words - set(NUMBERS))) or "a derivative of an input"
        raise DiagramError(f"{unknown} has no numbers, so V' cannot be compared")
    symbols = sorted(expression.free_symbols - {TIME}, key=str) + sorted(inputs, key=str)
    if expression.has(TIME):
        symbols.append(TIME)
    plain = {s: sympy.Dummy(f"s{k}") for k, s in enumerate(symbols)}
    text = expression.xreplace(plain)
    return sympy.lambdify(
        list(plain.values()), text, [NUMBERS, "scipy", "numpy"], cse=True
    ), symbols


def degree_of(loop: SymbolicLoop) -> float:
    """Return the degree of V in the states; inf for no polynomial."""
    V = loop.signals["V"][0]
    return sympy.Poly(V, *loop.motion).total_degree() if V.is_polynomial(*loop.motion) else np.inf
