"""How a run ended: its states, or a sentence that names block, signal and time.

Where a run meets a guard, or a number that is not finite, the blocks are asked in Python
which signal it is.
"""

from dataclasses import dataclass, field
from enum import IntEnum
from typing import Any

import numpy as np

from ..errors import SimulationError
from . import solver
from .batch import Batch
from .schedule import Inputs
from .sweep import Sweep


class Status(IntEnum):
    """How a run ended; `sentence` says what it means, and what to try."""

    RUNNING, FINISHED, TOO_SMALL, NOT_FINITE, LEFT, TOO_MANY, CHATTERS, STIFF = range(8)

    @property
    def sentence(self) -> str:
        """What it means."""
        return SENTENCES[self]


STUCK = (Status.NOT_FINITE, Status.TOO_SMALL)  # as a run may be that holds a decision for a step
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
ADVICE = "check the parameters of that block, or loosen rtol and atol"  # of what is not finite


@dataclass
class Solution:
    """States x (n, nstates) at the times t (n,) that were reached.

    `status` is ``"finished"``, or ``"stopped"`` where a guard ended the run; `message` is a
    sentence on it, `statistics` the numbers of steps, evaluations and restarts, `engine` what ran:
    ``"native"`` or ``"python"``; `method` is how, and from when by another one; `pieces` are who
    ran, on which inputs, and the pieces of time.
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
    """Return the solution of a batch of one run, or raise what stopped it.

    `rest` is its rest by another method, and `sweep` evaluates the diagram in Python, with the
    parameters that ran.
    """
    last, status = rest or batch, Status(batch.status[0])
    found = Solution(batch.times, batch.out[0], method=batch.method)
    if rest is not None:
        found.method += f", from t = {rest.times[0]:.9g} {rest.method}"
    counts = map(int, batch.counts[0])
    found.statistics = dict(zip(("steps", "evaluations", "restarts"), counts, strict=False))
    found.engine = batch.callee.engine
    if status is Status.FINISHED:
        return found
    if status is Status.LEFT:
        t, x, policy, sentence = _crossing(sweep, last, inputs)
        if policy == "raise":
            raise SimulationError(sentence)
        found.status, found.message = "stopped", f"stopped: {sentence}"
        found.t, found.x = _until(last, found, t, x, int(batch.reached[0]))
        return found
    reason = status.sentence
    if status is Status.CHATTERS:
        reason = f"{_switch(sweep, last)} {reason}"
    reason = _trouble(sweep, last, inputs) or reason
    raise SimulationError(f"the integration stopped at t = {last.now:.9g}: {reason}")


def _switch(sweep: Sweep, batch: Batch) -> str:
    """Name the decision of a run that chatters: block, function and operation."""
    deciding, which = batch.callee.code[0].program.deciding, batch.lane[1][solver.WHICH, 0]
    k, role, kind = [of for first, of in deciding if first <= which][-1]
    word = {"lt": "<", "le": "<=", "gt": ">", "ge": ">="}.get(kind, kind)
    return f"`{word}` in {sweep.nodes[k].name}.{role}"


def _trouble(sweep: Sweep, batch: Batch, inputs: Inputs | None) -> str | None:
    """Return what is not finite at the state reached, or a small step ahead, and why."""
    n, t = sweep.nstates, batch.now
    x, rate = (batch.Z[r * n : (r + 1) * n] for r in (solver.STATE, solver.RATE))
    ahead = float(batch.numbers[solver.END, 0]) - t
    sweep.enter(t)
    for k in sweep.leaping:
        sweep.nodes[k].system.raised.pop("jump", None)
    known = batch.out[0][np.isfinite(batch.out[0]).all(axis=1)]
    if sweep.leaping and len(known) and not np.isfinite(x).all():  # a jump made it so: ask it again
        sweep.leap(t, known[-1], None if inputs is None else inputs.at(t), sweep.leaping)
    for h in (0.0, *(ahead * np.geomspace(1e-12, 1.0, 13))):
        near = x + h * rate if h else x  # the rate itself may be what is not finite
        u = None if inputs is None else inputs.at(t + h)
        found = sweep.first_trouble(t + h, near, u, ADVICE)
        if found is not None:
            return found
    return None


def _state(batch: Batch, share: float) -> np.ndarray:
    """Return the state at a share of the step that was not taken."""
    n = batch.callee.nstates
    return np.array([solver.between(batch.Z, n, 1, 0, i, share) for i in range(n)])


def _crossing(
    sweep: Sweep, batch: Batch, inputs: Inputs | None
) -> tuple[float, np.ndarray, str, str]:
    """Return time, state, policy and sentence where that step crosses a guard's edge."""
    from scipy.optimize import brentq

    t, h = batch.now, float(batch.numbers[solver.TAKEN, 0])
    sweep.enter(t)

    def seen(share: float) -> tuple[float, str, str]:
        u = None if inputs is None else inputs.at(t + share * h)
        return sweep.margin(t + share * h, _state(batch, share), u)

    def margin(share: float) -> float:
        return seen(share)[0]

    share, beyond = (float(batch.numbers[row, 0]) for row in (solver.LOW, solver.HIGH))
    if margin(0.0) <= 0.0:
        share = 0.0
    elif margin(share) > 0.0 > margin(beyond):  # else the edge itself was looked at
        share = brentq(margin, share, beyond, xtol=1e-15, rtol=1e-14)
    return (t + share * h, _state(batch, share), *seen(share)[1:])


def _until(
    batch: Batch, found: Solution, t: float, x: np.ndarray, done: int
) -> tuple[np.ndarray, np.ndarray]:
    """Return the samples up to the end of a run that a guard stopped, and that end."""
    start, h = batch.now, float(batch.numbers[solver.TAKEN, 0])
    within = found.t[done:][found.t[done:] <= t]
    times = np.concatenate([found.t[:done], within])
    states = [*found.x[:done], *(_state(batch, (time - start) / h) for time in within)]
    if times[-1] < t:
        times, states = np.append(times, t), [*states, x]
    return times, np.array(states)
