"""V and the rates of all states of the blocks that run, at many points, and V' of them.

A proof is about expressions; this evaluates the equations themselves: the blocks' own functions
point by point, at first through python-control; and their records, which machine code runs, at all
points at once.  Along the rates r that they give at (t, x, u),

    V' = D(h) = (V(x + h r) - V(x - h r))/(2 h)            V of degree two and less
    V' = (4 D(h/2) - D(h))/3                               any other V

which is exact for a V of degree four and less, whatever h.
"""

from collections.abc import Callable, Mapping
from functools import partial
from typing import Any

import control
import numpy as np
import sympy

from ...diagrams.interconnection import changed_parameters
from ...diagrams.wiring import Node, Wiring, wiring_of
from ...equations.at_many import on_arrays
from ...equations.block import Block
from ...errors import DiagramError
from ...progress.interrupt import check
from .array_loop import blocks_of
from .proof import Step, checked
from .symbolic_loop import Draw, Point, SymbolicLoop, degree_of, equate_x_and_z, numeric

THROUGH_CONTROL = 20  # points at which python-control gives the rates


class RunningBlocks:
    """A diagram one block of which makes V[1], and three ways to evaluate it.

    Each takes times (n,), states (n, nx) and inputs (n, nu).
    """

    def __init__(self, diagram: control.NonlinearIOSystem):
        self.wiring = wiring_of(diagram)
        self.blocks = blocks_of(self.wiring)
        makers = [k for k, block in enumerate(self.blocks) if block.output_ports == {"V": 1}]
        if not makers:
            raise DiagramError("no block makes V[1]; wire a candidate such as blocks.lyapunov")
        V = self.wiring.nodes[makers[0]].outputs.start
        self.control = ByControl(self.wiring, V, by_functions, diagram)
        self.functions = Evaluator(self.wiring, V, by_functions)
        self.records = Evaluator(self.wiring, V, by_records)

    def set(self, params: Mapping[str, Any]) -> None:
        """Set the parameters with which the blocks run."""
        parameters = changed_parameters(self.wiring, params)
        self.control.params = dict(params)
        for one in (self.control, self.functions, self.records):
            one.parameters = parameters


class Evaluator:
    """One way to call the blocks, in the order of the wiring."""

    def __init__(self, wiring: Wiring, V: int, call: Callable[..., np.ndarray]):
        self.wiring, self.V, self.call = wiring, V, call
        self.parameters: list[Any] = []  # of each block

    def rates(self, t: np.ndarray, x: np.ndarray, u: np.ndarray) -> np.ndarray:
        """Return the rates of all states, (n, nx); NaN where there are none."""
        signals, rates = self._signals(t, x, u), np.empty(x.shape)
        for node, p in zip(self.wiring.nodes, self.parameters, strict=True):
            if node.system.nstates:
                at = t, x.T[node.states], _inputs_of(node, signals, u), p
                rates.T[node.states] = self.call(node.system, "update", *at)
        return rates

    def values(self, t: np.ndarray, x: np.ndarray, u: np.ndarray) -> np.ndarray:
        """Return V, (n,)."""
        return self._signals(t, x, u)[self.V]

    def _signals(self, t: np.ndarray, x: np.ndarray, u: np.ndarray) -> np.ndarray:
        """Return the outputs of all blocks, (signals, n)."""
        signals = np.zeros((self.wiring.nodes[-1].outputs.stop, len(t)))
        for k in self.wiring.order:
            node, p = self.wiring.nodes[k], self.parameters[k]
            outputs = x.T[node.states]
            if not node.system.states_are_outputs:
                fed = _inputs_of(node, signals, u)
                outputs = self.call(node.system, "output", t, outputs, fed, p)
            signals[node.outputs] = outputs
        return signals


class ByControl(Evaluator):
    """The same, with the rates that python-control gives, point by point."""

    def __init__(self, wiring: Wiring, V: int, call: Callable[..., np.ndarray], diagram: Any):
        super().__init__(wiring, V, call)
        self.diagram, self.params = diagram, dict[str, Any]()

    def rates(self, t: np.ndarray, x: np.ndarray, u: np.ndarray) -> np.ndarray:
        """Return the rates of all states; the diagram's parameters are its own again at the end."""
        try:
            return np.array([self._rates(*point) for point in zip(t, x, u, strict=True)])
        finally:
            self.diagram._update_params({})

    def _rates(self, t: float, x: np.ndarray, u: np.ndarray) -> np.ndarray:
        self.diagram._update_params(self.params)  # anew, for the interval
        try:
            with np.errstate(all="ignore"):
                return self.diagram._rhs(t, x, u)
        except RuntimeError:  # python-control's word for a NaN on its way
            return np.full(len(x), np.nan)


def by_functions(block: Block, role: str, t: Any, x: Any, u: Any, p: Any) -> np.ndarray:
    """Return what a block's function gives, point by point."""
    size = block.nstates if role == "update" else block.noutputs
    points = zip(t, x.T, u.T, strict=True)
    with np.errstate(all="ignore"):
        found = [block.values(role, size, *at, block.parameters_at(at[0], p)) for at in points]
    return np.array(found).T


def by_records(block: Block, role: str, t: Any, x: Any, u: Any, p: Any) -> np.ndarray:
    """Return what a block's record gives at all points at once."""
    if block.breakpoints_function is not None and p.interval < 0:
        p = p._replace(interval=np.array([block.interval_at(one, p) for one in t]))
    return on_arrays(block, role, t, x, u, p)


def _inputs_of(node: Node, signals: np.ndarray, u: np.ndarray) -> np.ndarray:
    """Return the inputs of a block, (inputs, n)."""
    inputs = np.zeros((node.system.ninputs, len(u)))
    for wire in node.wires:
        source = (u.T if wire.external else signals)[wire.source : wire.source + wire.size]
        inputs[wire.to : wire.to + wire.size] += wire.gain * source
    return inputs


def V_and_rates(
    evaluator: Evaluator, t: np.ndarray, x: np.ndarray, u: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Return V and all rates at points, (1 + nx, n), and the square of how far the points lie."""
    far = np.max(np.abs(np.column_stack([x, u])), axis=1)
    values = np.vstack([evaluator.values(t, x, u), evaluator.rates(t, x, u).T])
    return values, np.maximum(far, 1.0) ** 2


PER_DRAW = 100  # points for each draw of the parameters
# an evaluator's numbers at points (t, x, u), n or (m, n), and the size of what is compared
Gauge = Callable[..., tuple[np.ndarray, np.ndarray]]
CALLED = 2  # points at which the blocks' functions are called as well; in the first draw more
CLOSE = 1e-9
HUGE = 1e100  # beyond, numbers say nothing
UNEVEN = 1e13  # a ratio of V's weights beyond which the greater hides the lesser


def near_least(
    records: Evaluator, x: np.ndarray, u: np.ndarray, random: np.random.Generator
) -> np.ndarray:
    """Return points (n, states) at which each error adds alike to V, which is a polynomial.

    Elsewhere an error of small weight is lost in one of great weight.
    """
    n = x.shape[1]
    one = np.eye(n)

    def values(at: np.ndarray) -> np.ndarray:
        return records.values(np.zeros(len(at)), at, np.zeros((len(at), u.shape[1])))

    V0, ahead, behind = values(0 * one[:1])[0], values(one), values(-one)
    slope = 0.5 * (ahead - behind)
    bent = ahead + behind - 2 * V0
    weights = bent[bent > 0]
    if not len(weights) or not np.all(np.isfinite(bent)):
        return x
    if weights.max() > UNEVEN * weights.min():
        raise DiagramError(
            f"V has weights from {weights.min():.1e} to {weights.max():.1e}, and what is wrong "
            "in the lesser cannot be seen; give gains that differ less"
        )
    sizes = np.where(bent > 0, 1.0 / np.sqrt(np.where(bent > 0, bent, 1.0)), 0.0)
    H = values((one[:, None] + one).reshape(-1, n)).reshape(n, n)
    H += V0 - ahead[:, None] - ahead
    H[np.diag_indices(n)] = bent
    scaled = sizes[:, None] * H * sizes
    least = sizes * np.linalg.lstsq(scaled, -sizes * slope, rcond=1e-9)[0]
    wide = 10.0 ** random.uniform(-1, 1, (len(x), 1))
    return least + wide * sizes * random.standard_normal(x.shape)


@np.errstate(all="ignore")
def rate_along(
    evaluator: Evaluator, t: np.ndarray, x: np.ndarray, u: np.ndarray, degree: float
) -> tuple[np.ndarray, np.ndarray]:
    """Return V' at points, and |V| over the step h, below which a difference is rounding."""
    rates = evaluator.rates(t, x, u)
    fastest = np.max(np.abs(rates), axis=1, keepdims=True)
    largest = np.maximum(np.max(np.abs(x), axis=1, keepdims=True), 1e-3)
    h = (0.1 if degree <= 4 else 2e-3) * largest / fastest
    ways = [1.0, -1.0] + [0.5, -0.5] * (degree > 2)
    beside = np.vstack([x + way * h * rates for way in ways])
    V = evaluator.values(np.tile(t, len(ways)), beside, np.tile(u, (len(ways), 1)))
    V, h = V.reshape(len(ways), -1), h[:, 0]
    rate, scale = (V[0] - V[1]) / (2 * h), np.max(np.abs(V[:2]), axis=0) / h
    if degree > 2:
        rate = (4 * (V[2] - V[3]) / h - rate) / 3
    still, moving = fastest[:, 0] == 0.0, np.isfinite(fastest[:, 0])
    unknown = np.where(still, 1.0, np.nan)
    return (
        np.where(moving & ~still, rate, 0.0 * unknown),
        np.where(moving & ~still, scale, unknown),
    )


def compared(
    diagram: control.NonlinearIOSystem,
    loop: SymbolicLoop,
    wanted: sympy.Expr | list[sympy.Expr],
    count: int,
    seed: int = 0,
    tied: Mapping[Any, sympy.Expr] | None = None,
    fixed: tuple[str, ...] = (),
    gauge: Gauge | None = None,
    of: str = "",
) -> tuple[bool, str]:
    """Compare V' of the running blocks, or what a gauge returns, with `wanted` at random points.

    The first 100 points have the blocks' own parameters, half of them near the least V; every later
    100 have others.  Blocks in `fixed` keep theirs, and a symbol in `tied` follows from the others
    by its expression.  The blocks' records are evaluated at all points, their functions at some.
    """
    running = RunningBlocks(diagram)
    draw = Draw(running.blocks, loop, seed)
    known_as = [numeric(one) for one in (wanted if isinstance(wanted, list) else [wanted])]
    degree = degree_of(loop)
    gauge = gauge or partial(rate_along, degree=degree)
    worst, done = 0.0, 0
    while done < count:
        check()
        values = draw.parameters(fixed if done else [block.name for block in running.blocks])
        values |= {
            s: values[e] if e in values else float(e.subs(values)) for s, e in (tied or {}).items()
        }
        params = draw.params(values)
        running.set(params)
        size = min(PER_DRAW, count - done)
        x, u = draw.points(size, diagram.nstates), draw.points(size, diagram.ninputs)
        if not done and degree <= 4:
            half = size // 2
            x[half:] = near_least(running.records, x[half:], u, draw.random)
        equate_x_and_z(loop, x, draw.random)
        times = draw.random.uniform(0.0, 100.0, size)
        known = draw.at(values, times, x, u)
        with np.errstate(all="ignore"):
            parts = [function(*(known[s] for s in symbols)) for function, symbols in known_as]
        right = np.array([np.broadcast_to(part, size) for part in parts])
        some: tuple[Evaluator, slice] = running.functions, slice(CALLED)
        some = some if done else (running.control, slice(THROUGH_CONTROL))
        for evaluator, rows in (some, (running.records, slice(None))):
            off = _apart(right[:, rows], *gauge(evaluator, times[rows], x[rows], u[rows]))
            for k in np.flatnonzero(~(off <= CLOSE))[:1]:
                where = Point(times[k], x[k], u[k], params)
                return False, f"differs by {off[k]:.1e} of V at {where}"
            worst = max(worst, float(off.max()))
        done += size
    return True, f"{done} points, {of}largest difference {worst:.0e} of V"


def _apart(right: np.ndarray, found: np.ndarray, scale: np.ndarray) -> np.ndarray:
    """Return the relative difference of numbers (m, n); 0 where they are too large to compare."""
    found = np.atleast_2d(found)
    with np.errstate(all="ignore"):
        silent = np.all([~(np.max(np.abs(one), axis=0) < HUGE) for one in (right, found)], axis=0)
        off = np.abs(found - right) / np.maximum(scale, np.abs(right))
        return np.where(silent, 0.0, np.max(off, axis=0))


def running_step(read: Callable[[], tuple], points: int, which: str = "", **known: Any) -> Step:
    """Check that running blocks give the V' wanted; `read` returns diagram, loop and that V'."""

    def same() -> tuple[bool, str]:
        diagram, loop, wanted = read()
        return compared(diagram, loop, wanted, points, **known)

    return checked(f"the running blocks give the same V'{which}", "sampled", same, False)
