"""V' of the blocks that run, asked at random points.

A proof is about expressions; this asks the equations themselves (`running_blocks`).  Along the
rates r that they give at (t, x, u), at the first points those that python-control gives,

    V' = D(h) = (V(x + h r) - V(x - h r))/(2 h)            V of degree two and less
    V' = (4 D(h/2) - D(h))/3                               any other V

which is exact for a V of degree four and less, whatever h.
"""

from collections.abc import Callable, Mapping
from functools import cache, partial
from math import prod
from typing import Any, NamedTuple

import control
import numpy as np
import sympy

from ...equations.symbolic import NUMBERS
from ...errors import DiagramError
from ...progress.interrupt import check
from .array_loop import TIME
from .proof import Step, checked
from .random_points import Draw, Point, equate_x_and_z
from .running_blocks import THROUGH_CONTROL, Reading, RunningBlocks
from .symbolic_loop import SymbolicLoop

PER_DRAW = 100  # points for each draw of the parameters
# what a reading gives at points (t, x, u), n or (m, n) numbers, and the size of what is compared
Gauge = Callable[..., tuple[np.ndarray, np.ndarray]]
CALLED = 2  # of which the blocks' functions are called as well; of the first more
CLOSE = 1e-9
HUGE = 1e100  # beyond, numbers say nothing
UNEVEN = 1e13  # a ratio of V's weights beyond which the greater hides the lesser


def near_least(
    records: Reading, x: np.ndarray, u: np.ndarray, random: np.random.Generator
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
    asked: Reading, t: np.ndarray, x: np.ndarray, u: np.ndarray, degree: float
) -> tuple[np.ndarray, np.ndarray]:
    """Return V' at points, and V over the time between which it is taken."""
    rates = asked.rates(t, x, u)
    fastest = np.max(np.abs(rates), axis=1, keepdims=True)
    largest = np.maximum(np.max(np.abs(x), axis=1, keepdims=True), 1e-3)
    h = (0.1 if degree <= 4 else 2e-3) * largest / fastest
    step, h = h * rates, h[:, 0]
    ahead, behind = asked.values(t, x + step, u), asked.values(t, x - step, u)
    rate, scale = (ahead - behind) / (2 * h), np.maximum(np.abs(ahead), np.abs(behind)) / h
    if degree > 2:
        step *= 0.5
        near = (asked.values(t, x + step, u) - asked.values(t, x - step, u)) / h
        rate = (4 * near - rate) / 3
    still, moving = fastest[:, 0] == 0.0, np.isfinite(fastest[:, 0])
    unknown = np.where(still, 1.0, np.nan)
    return (
        np.where(moving & ~still, rate, 0.0 * unknown),
        np.where(moving & ~still, scale, unknown),
    )


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
    wanted: sympy.Expr | list[sympy.Expr],
    count: int,
    seed: int = 0,
    tied: Mapping[Any, sympy.Expr] | None = None,
    kept: tuple[str, ...] = (),
    gauge: Gauge | None = None,
) -> Comparison:
    """Compare V' of the running blocks, or what a gauge reads, with `wanted` at random points.

    The first 100 points have the blocks' own parameters, half of them near the least V, then every
    100 others; blocks in `kept` keep theirs, and a symbol in `tied` follows from the others by its
    expression.  All are asked of the blocks' records, and some of their functions.
    """
    running = RunningBlocks(diagram)
    draw = Draw(running.blocks, loop, seed)
    known_as = [numeric(one) for one in (wanted if isinstance(wanted, list) else [wanted])]
    degree = degree_of(loop)
    gauge = gauge or partial(rate_along, degree=degree)
    worst, done = 0.0, 0
    try:
        while done < count:
            check()
            values = draw.parameters(kept if done else [block.name for block in running.blocks])
            values |= {s: float(e.subs(values)) for s, e in (tied or {}).items()}
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
            called = slice(CALLED if done else THROUGH_CONTROL)
            for asked, rows in ((running.functions, called), (running.records, slice(None))):
                off = _apart(right[:, rows], *gauge(asked, times[rows], x[rows], u[rows]))
                for k in np.flatnonzero(~(off <= CLOSE))[:1]:
                    where = Point(times[k], x[k], u[k], params)
                    return Comparison(int(done + k + 1), float(off[k]), where)
                worst = max(worst, float(off.max()))
            done += size
    finally:
        diagram._update_params({})
    return Comparison(done, worst, None)


def _apart(right: np.ndarray, found: np.ndarray, scale: np.ndarray) -> np.ndarray:
    """Return by how much of their size numbers (m, n) differ; 0 where they say nothing."""
    found = np.atleast_2d(found)
    with np.errstate(all="ignore"):
        silent = np.all([~(np.max(np.abs(one), axis=0) < HUGE) for one in (right, found)], axis=0)
        off = np.abs(found - right) / np.maximum(scale, np.abs(right))
        return np.where(silent, 0.0, np.max(off, axis=0))


def running_step(read: Callable[[], tuple], points: int, which: str = "", **known: Any) -> Step:
    """Check that running blocks give the V' wanted; `read` returns diagram, loop and that V'."""

    def same() -> tuple[bool, str]:
        diagram, loop, wanted = read()
        return compared(diagram, loop, wanted, points, **known).outcome

    return checked(f"the running blocks give the same V'{which}", "sampled", same, False)


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

    def function(*numbers: Any) -> Any:
        known: dict[sympy.Expr, Any] = dict(zip(symbols, numbers, strict=True))

        def value(e: sympy.Expr) -> Any:
            if e not in known:
                known[e] = _applied(e, [value(a) for a in e.args])
            return known[e]

        return value(expression)

    return function, symbols


def _applied(e: sympy.Expr, numbers: list[Any]) -> Any:
    """Return the number of an expression whose arguments have these."""
    if e.is_Atom:
        return np.float64(e)
    if e.is_Add:
        return sum(numbers)
    if e.is_Mul:
        return prod(numbers)
    return numbers[0] ** numbers[1] if e.is_Pow else _function(e.func, len(numbers))(*numbers)


@cache
def _function(word: Any, count: int) -> Callable[..., Any]:
    """Return a word of SymPy's, or of the records', as a function of arrays."""
    own = sympy.symbols(f"a_:{count}", real=True)
    return sympy.lambdify(own, word(*own), [NUMBERS, "scipy", "numpy"])


def degree_of(loop: SymbolicLoop) -> float:
    """Return the degree of V in the states; inf for no polynomial."""
    V = loop.signals["V"][0]
    return sympy.Poly(V, *loop.motion).total_degree() if V.is_polynomial(*loop.motion) else np.inf
