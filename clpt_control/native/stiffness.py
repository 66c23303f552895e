"""Whether a run is stiff, so that an implicit method goes on.

DOP853 stops where its own steps look stiff (`method`, Hairer's test) and many are ahead.  They look
so as well where rates jump; so it is asked how large the eigenvalues of df/dx are, which know of
no jumps.
"""

from collections.abc import Callable

import numpy as np

from ..errors import SimulationError
from . import solver
from .batch import MEMBER_STEPS, Batch, Callee

METHODS = ("auto", "dop853", "rodas5p")
LARGE = 3.0  # of step times eigenvalue: DOP853 is stable up to 6
ROUNDS = 60  # of the power method
Implicit = Callable[[], tuple[Callee, int]]  # what an implicit method calls, and the length of P


def checked_method(method: str | None, step: float | None = None) -> str:
    """Return the name of a method; refuse what is none, and one beside `step`."""
    if method is not None and method not in METHODS:
        raise SimulationError(f"method = {method!r}: must be one of {', '.join(METHODS)}")
    if method is not None and step is not None:
        raise SimulationError("step and method: a fixed step has a method; leave one out")
    return method or METHODS[0]


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
        one = rest[int(batch.lane[1][solver.MEMBER, k])] = _rest(batch, k, *implicit())
        one.advance(*tolerances, 1)
        h = float(batch.numbers[solver.STEP, k])
        return h * radius(one.callee.linear.slopes) > LARGE

    batch.adaptive(*tolerances, watch, most, None, None if implicit is None else stiff)
    found = {int(m): rest[int(m)] for m in np.flatnonzero(batch.status == solver.STIFF)}
    for m, one in found.items():
        one.adaptive(*tolerances, watch, most)
        done = len(batch.times) - len(one.times) + 1
        batch.out[m, done:] = one.out[0, 1:]
        batch.status[m], batch.reached[m] = one.status[0], done + one.reached[0] - 1
        batch.counts[m] += one.counts[0]
    return found


def _rest(batch: Batch, k: int, callee: Callee, size: int) -> Batch:
    """Return the run of a lane from where it is; P is then so long."""
    lanes, n, given = batch.shape
    member, _, done, *_ = batch.lane[1][:, k].tolist()
    t, P = float(batch.numbers[solver.TIME, k]), np.zeros((1, size))
    P[0, : min(given, size)] = batch.runs[1][member, : min(given, size)]
    state = batch.Z[: n * lanes].reshape(n, lanes)[:, k].copy()
    times = np.append(t, batch.times[done:])
    pieces = [batch.pieces[batch.runs[2][member]].after(t)]
    return Batch(
        callee, state[None], P, times, pieces, None, float(batch.numbers[solver.LONGEST, k])
    )


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
