"""The end of a run: by which method it is reached, and with which states, or which sentence.

When a run meets a guard, or a number that is not finite, the blocks are evaluated in Python to find
the signal: the sentence names block, signal and time.

`run_to_end` goes on with an implicit method if a run is stiff.  DOP853 stops if its own steps look
stiff (`method`, Hairer's test) and many are ahead.  Steps look stiff as well if rates jump, but
then the eigenvalues of df/dx are small.

In discrete time x[k+1] = derivative(t_k, x[k], u_k), and the signals of sample k are those of x[k].
The times are those that python-control takes: `dt` apart, or evenly spaced if dt is True.
"""

from collections.abc import Callable
from dataclasses import dataclass, field
from enum import IntEnum
from typing import Any

import numpy as np

from ..errors import SimulationError
from . import solver
from .batch import MEMBER_STEPS, Batch, Callee
from .schedule import Inputs, Schedule
from .sweep import Sweep


class Status(IntEnum):
    """How a run ended; `sentence` says what it means, and what to try."""

    RUNNING, FINISHED, TOO_SMALL, NOT_FINITE, LEFT, TOO_MANY, CHATTERS, STIFF = range(8)

    @property
    def sentence(self) -> str:
        """What it means."""
        return SENTENCES[self]


STUCK = (Status.NOT_FINITE, Status.TOO_SMALL)  # ends that a locked decision may cause
SENTENCES = (  # of each status
    "under way",
    "finished: the end of the span was reached",
    "the step became too small; loosen rtol and atol, or look for a singularity",
    "a number is not finite; check parameters and the initial state",
    "a guard was left",
    "too many steps: rates change much faster than the run is long; lower the gains, or loosen "
    "rtol and atol",
    "switches to and fro without going on; give the switch a hysteresis, a boundary layer (np.clip "
    "in place of np.sign), or sample it",
    "left to an implicit method",
)
ADVICE = "check the parameters of that block"  # where a signal is not finite


@dataclass
class Solution:
    """States x (n, nstates) at the times t (n,) that were reached.

    `status` is ``"finished"``, or ``"stopped"`` if a guard ended the run; `message` is a sentence
    on it.  `statistics` are the numbers of steps, evaluations and restarts.  `engine` is
    ``"native"`` or ``"python"``, `method` the method, and from which time on another one.  `pieces`
    are the diagram that ran, its inputs, and the pieces of time.
    """

    t: np.ndarray
    x: np.ndarray
    status: str = "finished"
    message: str = Status.FINISHED.sentence
    statistics: dict[str, int] = field(default_factory=dict)
    engine: str = "python"
    method: str = "none"
    pieces: tuple[Any, ...] = field(default=(None, None, None), repr=False, compare=False)


def ended(sweep: Sweep, batch: Batch, inputs: Inputs | None, rest: Batch | None) -> Solution:
    """Return the solution of a batch of one run, or raise an error on what stopped it.

    `rest` is the rest of the run by another method; `sweep` evaluates the diagram in Python, with
    the parameters of the run.
    """
    last, status = rest or batch, Status(batch.status[0])
    solution = Solution(batch.times, batch.out[0], method=batch.method)
    if rest is not None:
        solution.method += f", from t = {rest.times[0]:.9g} {rest.method}"
    counts = map(int, batch.counts[0])
    solution.statistics = dict(zip(("steps", "evaluations", "restarts"), counts, strict=False))
    solution.engine = batch.callee.engine
    if status is Status.FINISHED:
        return solution
    if status is Status.LEFT:
        t, x, policy, sentence = _crossing(sweep, last, inputs)
        if policy == "raise":
            raise SimulationError(sentence)
        solution.status, solution.message = "stopped", f"stopped: {sentence}"
        solution.t, solution.x = _until(last, solution, t, x, int(batch.reached[0]))
        return solution
    reason = status.sentence
    if status is Status.CHATTERS:
        reason = f"{_switch(sweep, last)} {reason}"
    reason = _trouble(sweep, last, inputs) or reason
    what = "run" if batch.callee.method == solver.MAP else "integration"
    raise SimulationError(f"the {what} stopped at t = {last.now:.9g}: {reason}")


def without_states(sweep: Sweep, times: np.ndarray, inputs: Inputs | None, engine: str) -> Solution:
    """Return the solution of a diagram without states, up to where it leaves a guard."""
    solution = Solution(times, np.zeros((len(times), 0)), engine=engine)

    def guard(t: float) -> tuple[float, str, str]:
        sweep.enter(t)
        return sweep.margin(t, solution.x[0], None if inputs is None else inputs.at(t))

    k = next((k for k, t in enumerate(times) if sweep.guarded and guard(t)[0] < 0.0), None)
    if k is None:
        return solution
    low, high = times[max(k - 1, 0)], times[k]
    while low < (middle := 0.5 * (low + high)) < high:
        low, high = (low, middle) if guard(middle)[0] < 0.0 else (middle, high)
    _, policy, sentence = guard(high)
    if policy == "raise":
        raise SimulationError(sentence)
    solution.t = np.append(times[:k], high)
    solution.x = np.zeros((k + 1, 0))
    solution.status, solution.message = "stopped", f"stopped: {sentence}"
    return solution


def _switch(sweep: Sweep, batch: Batch) -> str:
    """Name the decision of a run that chatters: block, function and operation."""
    deciding, which = batch.callee.code[0].program.deciding, batch.lane[1][solver.WHICH, 0]
    k, role, kind = [of for first, of in deciding if first <= which][-1]
    word = {"lt": "<", "le": "<=", "gt": ">", "ge": ">="}.get(kind, kind)
    return f"`{word}` in {sweep.nodes[k].name}.{role}"


def _trouble(sweep: Sweep, batch: Batch, inputs: Inputs | None) -> str | None:
    """Return what is not finite at the state reached, or a small step ahead, and why."""
    n, t, advice, ahead = sweep.nstates, batch.now, ADVICE, [0.0]
    x, rate = (batch.Z[r * n : (r + 1) * n] for r in (solver.STATE, solver.RATE))
    if batch.callee.method != solver.MAP:
        advice = f"{ADVICE}, or loosen rtol and atol"
        ahead += [*((batch.numbers[solver.END, 0] - t) * np.geomspace(1e-12, 1.0, 13))]
    sweep.enter(t)
    for k in sweep.jumping:
        sweep.nodes[k].system.raised.pop("jump", None)
    known = batch.out[0][np.isfinite(batch.out[0]).all(axis=1)]
    if sweep.jumping and len(known) and not np.isfinite(x).all():  # by a jump, which is tried again
        sweep.jump(t, known[-1], None if inputs is None else inputs.at(t), sweep.jumping)
    for h in ahead:
        near = x + h * rate if h else x  # the rate itself may be what is not finite
        u = None if inputs is None else inputs.at(t + h)
        trouble = sweep.first_trouble(t + h, near, u, advice)
        if trouble is not None:
            return trouble
    return None


def _state(batch: Batch, share: float) -> np.ndarray:
    """Return the state at a share of the step that was not taken."""
    n = batch.callee.nstates
    return np.array([solver.interpolate(batch.Z, n, 1, 0, i, share) for i in range(n)])


def _crossing(
    sweep: Sweep, batch: Batch, inputs: Inputs | None
) -> tuple[float, np.ndarray, str, str]:
    """Return time, state, policy and sentence where that step crosses a guard's edge."""
    from scipy.optimize import brentq

    t, h = batch.now, float(batch.numbers[solver.TAKEN, 0])
    sweep.enter(t)

    def guard(share: float) -> tuple[float, str, str]:
        u = None if inputs is None else inputs.at(t + share * h)
        return sweep.margin(t + share * h, _state(batch, share), u)

    def margin(share: float) -> float:
        return guard(share)[0]

    share, beyond = (float(batch.numbers[row, 0]) for row in (solver.LOW, solver.HIGH))
    if margin(0.0) <= 0.0:
        share = 0.0
    elif margin(share) > 0.0 > margin(beyond):  # else the edge itself was looked at
        share = brentq(margin, share, beyond, xtol=1e-15, rtol=1e-14)
    return (t + share * h, _state(batch, share), *guard(share)[1:])


def _until(
    batch: Batch, solution: Solution, t: float, x: np.ndarray, done: int
) -> tuple[np.ndarray, np.ndarray]:
    """Return the samples up to the end of a run that a guard stopped, and that end."""
    start, h = batch.now, float(batch.numbers[solver.TAKEN, 0])
    within = solution.t[done:][solution.t[done:] <= t]
    times = np.concatenate([solution.t[:done], within])
    states = [*solution.x[:done], *(_state(batch, (time - start) / h) for time in within)]
    if times[-1] < t:
        times, states = np.append(times, t), [*states, x]
    return times, np.array(states)


# --- stiff ------------------------------------------------------------------------------------

METHODS = {
    **{"auto": solver.DOP853, "dop853": solver.DOP853},
    **{"dopri5": solver.DOPRI5, "rodas5p": solver.RODAS5P},
}
LARGE = {solver.DOP853: 3.0, solver.DOPRI5: 1.6}  # of step times eigenvalue: half of what is stable
ROUNDS = 60  # of the power method
Implicit = Callable[[], Callee]  # what an implicit method calls


def checked_method(method: str | None) -> str:
    """Return the name of a method; refuse an unknown one."""
    if method is not None and method not in METHODS:
        raise SimulationError(f"method = {method!r}: must be one of {', '.join(METHODS)}")
    return method or "auto"


def run_to_end(
    batch: Batch,
    rtol: float,
    atol: float,
    implicit: Implicit | None,
    watch: Callable[[Batch], None] = lambda batch: None,
    most: int = MEMBER_STEPS,
) -> dict[int, Batch]:
    """Run a batch to the end, stiff runs by an implicit method, one after the other.

    Return the rests of the stiff runs, by run; `batch` has their results too.
    """
    rest: dict[int, Batch] = {}

    def stiff(batch: Batch, k: int) -> bool:
        assert implicit is not None
        one = rest[int(batch.lane[1][solver.MEMBER, k])] = _rest(batch, k, implicit())
        one.advance(rtol, atol, 1)
        h = float(batch.numbers[solver.STEP, k])
        n = one.callee.nstates
        return h * radius(one.linear[0].reshape(n, n)) > LARGE[batch.callee.method]

    batch.adaptive(rtol, atol, watch, most, None if implicit is None else stiff)
    stiff_runs = {int(m): rest[int(m)] for m in np.flatnonzero(batch.status == solver.STIFF)}
    for m, one in stiff_runs.items():
        one.adaptive(rtol, atol, watch, most)
        done = len(batch.times) - len(one.times) + 1
        batch.out[m, done:] = one.out[0, 1:]
        batch.status[m], batch.reached[m] = one.status[0], done + one.reached[0] - 1
        batch.counts[m] += one.counts[0]
    return stiff_runs


def _rest(batch: Batch, k: int, callee: Callee) -> Batch:
    """Return the run of a lane from where it is."""
    lanes, n = batch.callee.lanes, batch.callee.nstates
    member, _, done, *_ = batch.lane[1][:, k].tolist()
    t, P = float(batch.numbers[solver.TIME, k]), batch.runs[1][member, : callee.size].copy()
    state = batch.Z[: n * lanes].reshape(n, lanes)[:, k].copy()
    times = np.append(t, batch.times[done:])
    pieces = [batch.pieces[batch.runs[2][member]].after(t)]
    longest = float(batch.numbers[solver.LONGEST, k])
    return Batch(callee, state[None], P[None], times, pieces, None, longest)


def radius(matrix: np.ndarray) -> float:
    """Return nearly the size of a matrix's largest eigenvalue; 0.0 if the iteration finds none."""
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


# --- discrete time ----------------------------------------------------------------------------


def check_spacing(times: np.ndarray, dt: Any) -> None:
    """Refuse times that are not spaced by the step of a diagram of discrete time."""
    apart = np.diff(times)
    if not np.allclose(apart, apart[0] if dt is True else dt):
        every = "evenly spaced" if dt is True else f"{dt:.9g} apart"
        raise SimulationError(
            f"timepts: a diagram of discrete time (dt = {dt}) takes times that are {every}; these "
            f"are {apart.min():.9g} to {apart.max():.9g} apart"
        )


def sampled_start(callee: Callee, start: Any, t: float, pieces: Schedule, P: Any) -> np.ndarray:
    """Return the state with which a run begins; blocks that sample then have sampled inputs."""
    if not pieces.begins:
        return start
    return callee.evaluate(solver.JUMP, [t], start, pieces, P, np.empty((1, len(start))))[0]
