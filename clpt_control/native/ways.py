"""Ways of a run other than by DOP853 from one end to the other: stiff, of discrete time.

`finish` goes on by an implicit method where a run is stiff: DOP853 stops where its own steps look
stiff (`method`, Hairer's test) and many are ahead.  They look so as well where rates jump; so it is
asked how large the eigenvalues of df/dx are, which know of no jumps.

`iterated` is of diagrams of discrete time, x[k+1] = derivative(t_k, x[k], u_k), signals of sample k
from x[k].  The times are those that python-control takes: `dt` apart, or evenly spaced where dt is
True.  What sampled parts hold where a run begins says `begun`.
"""

from collections.abc import Callable, Iterator
from typing import Any

import numpy as np

from ..errors import SimulationError
from ..progress.interrupt import check
from . import solver
from .batch import MEMBER_STEPS, Batch, Callee
from .ending import Solution
from .schedule import Inputs, Schedule

# --- stiff ------------------------------------------------------------------------------------

METHODS = {"auto": solver.DOP853, "dop853": solver.DOP853, "rodas5p": solver.RODAS5P}
LARGE = 3.0  # of step times eigenvalue: DOP853 is stable up to 6
ROUNDS = 60  # of the power method
Implicit = Callable[[], Callee]  # what an implicit method calls


def checked_method(method: str | None) -> str:
    """Return the name of a method; refuse what is none."""
    if method is not None and method not in METHODS:
        raise SimulationError(f"method = {method!r}: must be one of {', '.join(METHODS)}")
    return method or "auto"


def finish(
    batch: Batch,
    tolerances: tuple[float, float],
    implicit: Implicit | None,
    watch: Callable[[Batch], None] = lambda batch: None,
    most: int = MEMBER_STEPS,
) -> dict[int, Batch]:
    """Run a batch to the end: what is stiff by an implicit method, one after the other.

    Returns the rests of those runs, which `batch` holds as well.
    """
    rest: dict[int, Batch] = {}

    def stiff(batch: Batch, k: int) -> bool:
        assert implicit is not None
        one = rest[int(batch.lane[1][solver.MEMBER, k])] = _rest(batch, k, implicit())
        one.advance(*tolerances, 1)
        h = float(batch.numbers[solver.STEP, k])
        n = one.callee.nstates
        return h * radius(one.linear[0].reshape(n, n)) > LARGE

    batch.adaptive(*tolerances, watch, most, None if implicit is None else stiff)
    found = {int(m): rest[int(m)] for m in np.flatnonzero(batch.status == solver.STIFF)}
    for m, one in found.items():
        one.adaptive(*tolerances, watch, most)
        done = len(batch.times) - len(one.times) + 1
        batch.out[m, done:] = one.out[0, 1:]
        batch.status[m], batch.reached[m] = one.status[0], done + one.reached[0] - 1
        batch.counts[m] += one.counts[0]
    return found


def _rest(batch: Batch, k: int, callee: Callee) -> Batch:
    """Return the run of a lane from where it is."""
    lanes, n = batch.callee.lanes, batch.callee.nstates
    member, _, done, *_ = batch.lane[1][:, k].tolist()
    t, given = float(batch.numbers[solver.TIME, k]), batch.runs[1][member, : callee.size].copy()
    state = batch.Z[: n * lanes].reshape(n, lanes)[:, k].copy()
    times = np.append(t, batch.times[done:])
    pieces = [batch.pieces[batch.runs[2][member]].after(t)]
    longest = float(batch.numbers[solver.LONGEST, k])
    return Batch(callee, state[None], given[None], times, pieces, None, longest)


def radius(matrix: np.ndarray) -> float:
    """Return the size of a matrix's largest eigenvalue, nearly; 0.0 where it has none."""
    v = np.random.default_rng(0).standard_normal(len(matrix))
    growth = []
    for _ in range(ROUNDS):
        v = matrix @ v
        size = float(np.linalg.norm(v))
        if not 0.0 < size < np.inf:
            return 0.0
        growth.append(np.log(size))
        v /= size
    return float(np.exp(np.mean(growth[ROUNDS // 2 :])))


# --- of discrete time -------------------------------------------------------------------------

TOGETHER = 4096  # steps of a call


def check_spacing(times: np.ndarray, dt: Any) -> None:
    """Refuse times that are not one step of a diagram of discrete time apart."""
    apart = np.diff(times)
    if not np.allclose(apart, apart[0] if dt is True else dt):
        every = "evenly spaced" if dt is True else f"{dt:.9g} apart"
        raise SimulationError(
            f"timepts: a diagram of discrete time (dt = {dt}) takes times that are {every}; these "
            f"are {apart.min():.9g} to {apart.max():.9g} apart"
        )


def steps(
    callee: Callee, x: np.ndarray, times: np.ndarray, pieces: Schedule, P: Any
) -> Iterator[tuple[int, bool]]:
    """Fill the rows of x behind the first.

    Yield the number of the last row that is done, and whether the next is not finite.
    """
    for first in range(0, len(times) - 1, TOGETHER):
        check()
        last = min(first + TOGETHER, len(times) - 1)
        after = x[first + 1 : last + 1]
        callee.ask(solver.DERIVATIVE, times[first:last], x[first:last], pieces, P, after)
        bad = np.flatnonzero(~np.all(np.isfinite(after), axis=1))
        if len(bad):
            yield first + int(bad[0]), True
            return
        yield last, False


def iterated(
    runner: Any,
    start: np.ndarray,
    times: np.ndarray,
    inputs: Inputs | None,
    progress: Callable[[float], None] | None,
) -> Solution:
    """Return the states of a diagram of discrete time, ready to run, at its times."""
    pieces = runner.schedule(float(times[0]), float(times[-1]), inputs)
    callee, P = runner.callee(1, inputs), runner.parameters()
    x = np.zeros((len(times), len(start)))
    x[0] = start
    for k, bad in steps(callee, x, times, pieces, P):
        if bad:
            t, u = float(times[k]), None if inputs is None else inputs.at(float(times[k]))
            advice = "check the parameters of that block"
            found = runner.sweep.first_trouble(t, x[k], u, advice)
            found = found or f"a state is not finite; {advice}"
            raise SimulationError(f"the run stopped at t = {t:.9g}: {found}")
        if progress is not None:
            progress(float(times[k]))
    statistics = {"steps": len(times) - 1, "evaluations": len(times) - 1, "restarts": 0}
    made = Solution(times, x, statistics=statistics, engine=runner.engine)
    made.pieces = runner, inputs, pieces
    return made


def begun(callee: Callee, start: np.ndarray, t: float, pieces: Schedule, P: Any) -> np.ndarray:
    """Return the state with which a run begins: blocks that sample there hold what feeds them."""
    if not pieces.begins:
        return start
    return callee.ask(solver.JUMP, [t], start, pieces, P, np.empty((1, len(start))))[0]
