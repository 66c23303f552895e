"""V' of the blocks that run, at many points.

A proof is about expressions; this evaluates the equations themselves, with V's slopes from V on
symbols:

    V' = dV/dt + sum_i (dV/dx_i) x_i',    x_i' and V of the blocks that run

The blocks' records, which machine code runs, are evaluated at all points at once; their functions
at some points, through python-control.
"""

from collections.abc import Callable, Iterable, Mapping
from typing import Any

import control
import numpy as np
import sympy

from ...diagrams.interconnection import changed_parameters
from ...diagrams.symbol_names import TIME
from ...diagrams.wiring import wiring_of
from ...equations.at_many import on_arrays
from ...errors import DiagramError
from ...native.sweep import Sweep
from ...progress.interrupt import check
from .proof import Step, checked
from .symbolic_loop import Draw, Numbers, Point, equate_x_and_z
from .words import along

Found = tuple[np.ndarray, np.ndarray]  # rates (n, nx) and V (n,); NaN where there are none


class Running:
    """A diagram as it runs, with an output V, "" for none, and parameters of one's choice.

    Each way to evaluate it takes times (n,), states (n, nx) and inputs (n, nu).
    """

    def __init__(self, system: control.NonlinearIOSystem, V: str = "V[0]"):
        self.system, self.wiring = system, wiring_of(system)
        self.V = [system.output_labels.index(V)] if V else []
        self.jumps = any(node.system.jump_function is not None for node in self.wiring.nodes)
        self.set({})

    def set(self, params: Mapping[str, Any]) -> None:
        """Set call-time parameters with which it runs."""
        self.params = dict(params)
        self.sweep = Sweep(self.wiring, changed_parameters(self.wiring.blocks, params))

    def by_control(self, t: np.ndarray, x: np.ndarray, u: np.ndarray) -> Found:
        """Evaluate it as python-control does; the system's parameters are its own at the end."""
        system, params = self.system, self.params or None

        def one(*point: Any) -> tuple:
            if self.jumps:  # its states may jump between one point and the next
                system._update_params(params)
            try:
                return system._rhs(*point), *(system._out(*point)[self.V] if self.V else [0.0])
            except RuntimeError:  # python-control's word for a NaN on its way
                return np.full(system.nstates, np.nan), np.nan

        try:
            system._update_params(params)  # once: it takes as long as the equations
            with np.errstate(all="ignore"):
                rates, V = zip(*map(one, t, x, u), strict=True)
        finally:
            system._update_params({})
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

    def _made(self, k: int, role: str, signals: np.ndarray, t: Any, x: Any, u: Any) -> np.ndarray:
        """Return what block k makes in a role of signals that are known."""
        node, p = self.wiring.nodes[k], self.sweep.parameters[k]
        block = node.system
        if block.breakpoints_function is not None and p.interval < 0:
            p = p._replace(interval=np.array([block.interval_at(one, p) for one in t]))
        fed = np.zeros((block.ninputs, len(t)))
        for wire in node.wires:
            source = (u.T if wire.external else signals)[wire.source : wire.source + wire.size]
            fed[wire.to : wire.to + wire.size] += wire.gain * source
        return on_arrays(block, role, t, x.T[node.states], fed, p)


PER_DRAW = 100  # points for each draw of the parameters
THROUGH_CONTROL, CALLED = 20, 2  # points of the first draw, and of others, that it calls
CLOSE = 1e-9
ROUNDING = 16 * 2.0**-52 / CLOSE  # of states, below which a rate may be what is left of its terms
HUGE, TINY = 1e100, 1e-300  # beyond, numbers say nothing
UNEVEN = 1e13  # a ratio of V's weights beyond which the greater hides the lesser


def slopes_of(V: sympy.Expr, states: list) -> list[sympy.Expr]:
    """Return dV/dt and dV/dx_i, words with kinks as well."""
    return [along(V, {s: sympy.S.One}) for s in (TIME, *states)]


def rate_of(slopes: Any, rates: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return V' of slopes (1 + nx, n) along rates (n, nx), and the size of its terms."""
    with np.errstate(all="ignore"):
        terms = slopes * np.vstack([np.ones(len(rates)), rates.T])
        terms = np.where(np.equal(slopes, 0.0), 0.0, terms)
        return terms.sum(axis=0), np.abs(terms).sum(axis=0)


def near_least(slopes: np.ndarray, x: np.ndarray, random: np.random.Generator) -> np.ndarray:
    """Return points (n, states) at which each error adds alike to V.

    Slopes of V (1 + states, states) are those at 0, and at 1 of each state.  Elsewhere an error of
    small weight is lost in one of great weight.
    """
    H = slopes[1:] - slopes[0]
    bent = np.diagonal(H)
    weights = bent[bent > 0]
    if not len(weights) or not np.all(np.isfinite(H)):
        return x
    if weights.max() > UNEVEN * weights.min():
        raise DiagramError(
            f"V has weights from {weights.min():.1e} to {weights.max():.1e}, and what is wrong "
            "in the lesser cannot be seen; give gains that differ less"
        )
    sizes = np.where(bent > 0, 1.0 / np.sqrt(np.where(bent > 0, bent, 1.0)), 0.0)
    scaled = sizes[:, None] * H * sizes
    least = sizes * np.linalg.lstsq(scaled, -sizes * slopes[0], rcond=1e-9)[0]
    wide = 10.0 ** random.uniform(-1, 1, (len(x), 1))
    return least + wide * sizes * random.standard_normal(x.shape)


# points at which blocks are called: call-time parameters, ``{"block.field": value}``, symbol -> its
# numbers, t (n,), x (n, states) and u (n, inputs)
Drawn = tuple[dict[str, Any], dict[Any, Any], np.ndarray, np.ndarray, np.ndarray]


def compared(
    running: Running,
    states: list[Any],
    V: sympy.Expr,
    wanted: sympy.Expr,
    draws: Iterable[Drawn],
    first: int,
) -> tuple[bool, str]:
    """Compare V and V' of the running blocks with V and what V' is to be, at points drawn.

    V is compared where it is an output.  At `first` points of the first draw python-control calls
    the blocks.
    """
    worst, points, told, parts = 0.0, 0, 0, sympy.Add.make_args(wanted)
    numbers = Numbers(*parts, V, *slopes_of(V, states))
    for params, known, *at in draws:
        check()
        running.set(params)
        symbols = numbers.at(known, len(at[0]))
        some = CALLED if points else first
        for evaluate, most in ((running.by_control, some), (running.by_records, len(at[0]))):
            here = [one[:most] for one in at]
            rates, level = evaluate(*here)
            terms, (of_V, *slopes) = np.split(symbols[:, :most], [len(parts)])
            rate, size = rate_of(slopes, rates)
            with np.errstate(all="ignore"):  # inf - inf
                right, size = terms.sum(axis=0), np.maximum(size, np.abs(terms).sum(axis=0))
                states_size = 1 + np.abs(here[1]).max(axis=1, initial=0.0)
                size = np.maximum(size, ROUNDING * np.abs(slopes[1:]).sum(axis=0) * states_size)
            level = level if running.V else of_V
            off = np.maximum(_apart(right, rate, size), _apart(of_V, level, np.abs(of_V)))
            beyond = _too_large(of_V, level)
            for k in np.flatnonzero(np.isnan(rates).any(axis=1) & ~beyond):
                there = {s: np.broadcast_to(v, len(at[0]))[k] for s, v in known.items()}
                exact = wanted.evalf(subs=there)  # large of inf - inf, not of inf/inf
                beyond[k] = bool(exact.is_number and abs(exact) > HUGE)
                off[k] = np.nan
            off = np.where(beyond, 0.0, off)
            for k in np.flatnonzero(~(off <= CLOSE))[:1]:
                t, x, u = (one[k] for one in here)
                apart = f"differs by {off[k]:.1e} of V" if off[k] >= 0 else "is no number"
                return False, f"{apart} at {Point(t, x, u, params)}"
            worst = max(worst, float(off.max()))
        points += len(at[0])
        told += int(np.sum(np.abs(symbols[: len(parts) + 1]).max(axis=0) < HUGE))
    return told > points / 10, f"{points} points, largest difference {worst:.0e} of V"


def _apart(wanted: np.ndarray, found: np.ndarray, size: np.ndarray) -> np.ndarray:
    """Return the relative difference of numbers; 0 where both are too large to compare."""
    with np.errstate(all="ignore"):
        off = np.abs(found - wanted) / np.maximum(np.maximum(size, np.abs(wanted)), TINY)
    return np.where(_too_large(wanted, found), 0.0, off)


def _too_large(wanted: np.ndarray, found: np.ndarray) -> np.ndarray:
    return ~(np.abs(wanted) < HUGE) & ~(np.abs(found) < HUGE)


def running_step(
    read: Callable[[], tuple],
    points: int,
    which: str = "",
    of: str = "",
    seed: int = 0,
    tied: Mapping[Any, sympy.Expr] | None = None,
    fixed: tuple[str, ...] = (),
) -> Step:
    """Check that running blocks give the V' wanted; `read` returns diagram, loop and that V'.

    The first 100 points have the blocks' own parameters, half of them near the least V; every later
    100 have others.  Blocks in `fixed` keep theirs, and a symbol in `tied` follows from the others
    by its expression.
    """

    def same() -> tuple[bool, str]:
        diagram, loop, wanted = read()
        V, states, running = loop.signals["V"][0], [*loop.motion], Running(diagram)
        draw = Draw(running.wiring, loop, seed)

        def drawn(done: int) -> Drawn:
            values = draw.parameters(fixed if done else draw.names)
            ties, size = (tied or {}).items(), min(PER_DRAW, points - done)
            values |= {s: values[e] if e in values else float(e.subs(values)) for s, e in ties}
            x, u = draw.points(size, diagram.nstates), draw.points(size, diagram.ninputs)
            if not done and V.is_polynomial(*states):
                n, half = len(states), size // 2
                axes = np.vstack([np.zeros(n), np.eye(n)])
                known = draw.at(values, 0.0, axes, np.zeros((n + 1, diagram.ninputs)))
                slopes = Numbers(*slopes_of(V, states)[1:]).at(known, n + 1)
                x[half:] = near_least(slopes.T, x[half:], draw.random)
            equate_x_and_z(loop, x, draw.random)
            t = draw.random.uniform(0.0, 100.0, size)
            return draw.params(values), draw.at(values, t, x, u), t, x, u

        draws = map(drawn, range(0, points, PER_DRAW))
        holds, detail = compared(running, states, V, wanted, draws, THROUGH_CONTROL)
        return holds, of + detail

    return checked(f"the running blocks give the same V'{which}", same, "sampled", False)
