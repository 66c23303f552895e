"""The end of a run: with which states, or which sentence.

When a run meets a guard, or a number that is not finite, the blocks are evaluated in Python to find
the signal: the sentence names block, signal and time.
"""

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np
from scipy.optimize import brentq

from ...errors import SimulationError
from .batch import Batch, Callee
from .evaluation_pass import Sweep, rounding
from .schedule import Inputs, Schedule
from .solver_layout import (
    DOP853,
    EVENT_INDEX,
    HIGH,
    JUMP,
    LOW,
    MAP,
    RATE,
    RK4,
    RODAS5P,
    SEGMENT_END,
    STATE,
    TRIAL_SIZE,
    Status,
    interpolate,
)

# ends that a locked decision may cause
STUCK = (Status.NOT_FINITE, Status.STEP_TOO_SMALL, Status.TOO_MANY_STEPS)
NAMES = {DOP853: "DOP853", RODAS5P: "Rodas5P", RK4: "RK4", MAP: "none"}  # of the methods
ADVICE = "check the parameters of that block"  # where a signal is not finite


@dataclass
class Solution:
    """States x (n, nstates) at the times t (n,) that were reached.

    `status` is ``"finished"``, or ``"stopped"`` if a guard ended the run; `message` is a sentence
    on it.  `statistics` are the numbers of steps, evaluations and restarts.  `engine` is
    ``"native"`` or ``"python"``, `method` the method, and from which time on another one.  `pieces`
    are those of time, as the engine has them; `signals` those that were computed on the way.
    """

    t: np.ndarray
    x: np.ndarray
    status: str = "finished"
    message: str = Status.FINISHED.sentence
    statistics: dict[str, int] = field(default_factory=dict)
    engine: str = "python"
    method: str = "none"
    pieces: Schedule | None = field(default=None, repr=False, compare=False)
    signals: np.ndarray | None = field(default=None, repr=False, compare=False)


def ended(sweep: Sweep, batch: Batch, inputs: Inputs | None) -> Solution:
    """Return the solution of a batch of one run, or raise an error on what stopped it.

    `sweep` evaluates the diagram in Python, with the parameters of the run.
    """
    rest, status = batch.rests.get(0), int(batch.status[0])
    last = rest or batch
    solution = Solution(batch.times, batch.out[0], method=NAMES[batch.callee.method])
    if batch.slides:
        solution.method += f", sliding on a switch from t = {batch.slides[0]:.9g}"
    elif rest is not None:
        solution.method += f", from t = {rest.times[0]:.9g} {NAMES[rest.callee.method]}"
    counts = map(int, batch.counts[0])
    solution.statistics = dict(zip(("steps", "evaluations", "restarts"), counts, strict=False))
    solution.engine = batch.callee.engine
    if status == Status.FINISHED:
        return solution
    if status == Status.GUARD_LEFT:
        t, x, policy, sentence = _crossing(sweep, last, inputs)
        reached = _until(last, solution, t, x, int(batch.reached[0]))
        return _stopped(solution, policy, sentence, *reached)
    reason = Status(status).sentence
    if status == Status.CHATTERING:
        reason = f"{_switch(sweep, last)} {reason}"
    reason = _trouble(sweep, last, inputs) or reason
    what = "run" if batch.callee.method == MAP else "integration"
    error = SimulationError(f"the {what} stopped at t = {last.now:.9g}: {reason}")
    error.points = _points_ahead(last)  # type: ignore[attr-defined]
    raise error


def _points_ahead(batch: Batch) -> list[tuple[float, np.ndarray]]:
    """Return time and state where a run stopped, and points ahead along the rates."""
    t, ahead, n = batch.now, [0.0], batch.callee.nstates
    x, rate = (batch.Z[r * n : (r + 1) * n].copy() for r in (STATE, RATE))
    if batch.callee.method != MAP:
        ahead += [*((batch.lane[SEGMENT_END, 0] - t) * np.geomspace(1e-12, 1.0, 13))]
    # the rate itself may be what is not finite
    return [(t + h, x + h * rate if h else x) for h in ahead]


def without_states(sweep: Sweep, times: np.ndarray, inputs: Inputs | None, engine: str) -> Solution:
    """Return the solution of a diagram without states, up to where it leaves a guard."""
    solution = Solution(times, np.zeros((len(times), 0)), engine=engine)

    def guard(t: float) -> tuple[float, str, str]:
        sweep.enter(t)
        return sweep.margin(t, solution.x[0], None if inputs is None else inputs.at(t))

    for k, t in enumerate(times if sweep.guarded else ()):
        if guard(t)[0] < 0.0:
            low, high = times[max(k - 1, 0)], t
            while low < (middle := 0.5 * (low + high)) < high:
                low, high = (low, middle) if guard(middle)[0] < 0.0 else (middle, high)
            end = np.append(times[:k], high), np.zeros((k + 1, 0))
            return _stopped(solution, *guard(high)[1:], *end)
    return solution


def in_discrete_time(
    sweep: Sweep, x: np.ndarray, times: np.ndarray, inputs: Inputs | None, progress: Any
) -> Solution:
    """Return the solution of a diagram of discrete time in Python.

    Outputs are computed beside each update, as python-control does: a function may read what
    another one wrote.
    """
    states, signals = (np.empty((len(times), n)) for n in (sweep.nstates, len(sweep.signals)))
    rows: Any = [None] * len(times) if inputs is None else inputs.along(times).T
    for k, (t, u) in enumerate(zip(times, rows, strict=True)):
        sweep.enter(t)
        states[k], x, signals[k] = x, sweep.derivative(t, x, u), sweep.signals
        if progress is not None:
            progress(t)
        if k + 1 < len(times) and not np.isfinite(x).all():
            reason = sweep.first_trouble(t, states[k], u, ADVICE) or Status.NOT_FINITE.sentence
            raise SimulationError(f"the run stopped at t = {t:.9g}: {reason}")
    steps = dict.fromkeys(("steps", "evaluations"), len(times) - 1)
    return Solution(times, states, statistics=steps | {"restarts": 0}, signals=signals)


def _stopped(solution: Solution, policy: str, sentence: str, t: Any, x: Any) -> Solution:
    """Return a solution up to where a guard was left, or raise its error."""
    if policy == "raise":
        raise SimulationError(sentence)
    return replace(solution, t=t, x=x, status="stopped", message=f"stopped: {sentence}")


def _switch(sweep: Sweep, batch: Batch) -> str:
    """Return the decision of a run that chatters: block, function and operation."""
    deciding, which = batch.callee.code[0].program.deciding, batch.integers[EVENT_INDEX, 0]
    if which < 0:
        return "a decision"
    k, role, kind = [of for first, of in deciding if first <= which][-1]
    word = {"lt": "<", "le": "<=", "gt": ">", "ge": ">="}.get(kind, kind)
    return f"`{word}` in {sweep.nodes[k].name}.{role}"


def _trouble(sweep: Sweep, batch: Batch, inputs: Inputs | None) -> str | None:
    """Return what is not finite at the state reached, or a small step ahead, and why."""
    t, advice = batch.now, ADVICE
    points = [(time, state[: sweep.nstates]) for time, state in _points_ahead(batch)]
    if batch.callee.method != MAP:
        advice = f"{ADVICE}, or loosen rtol and atol"
    sweep.enter(t)
    for k in sweep.jumping:
        sweep.nodes[k].system.raised.pop("jump", None)
    known = batch.out[0][np.isfinite(batch.out[0]).all(axis=1)]
    if sweep.jumping and len(known) and not np.isfinite(points[0][1]).all():
        # by a jump, which is tried again
        sweep.jump(
            t, known[-1, : sweep.nstates], None if inputs is None else inputs.at(t), sweep.jumping
        )
    for time, state in points:
        u = None if inputs is None else inputs.at(time)
        if (trouble := sweep.first_trouble(time, state, u, advice)) is not None:
            return trouble
    return _derivative_trouble(sweep, batch, advice)


def _derivative_trouble(sweep: Sweep, batch: Batch, advice: str) -> str | None:
    """Return a sentence on a derivative along a direction that is not finite, or None."""
    n = batch.callee.nstates
    rates = batch.Z[RATE * n :][sweep.nstates : n]
    for k in np.flatnonzero(~np.isfinite(rates)) % max(sweep.nstates, 1):
        node = next(node for node in sweep.nodes if k < node.states.stop)
        label = node.system.state_labels[k - node.states.start]
        return f"derivative of d_{label} of block {node.name} is not finite; {advice}"
    return None


def state_within(batch: Batch, share: float) -> np.ndarray:
    """Return the state at a share of the step that was not taken."""
    n = batch.callee.nstates
    return np.array([interpolate(batch.states, i, 0, share) for i in range(n)])


def edge(batch: Batch, margin: Callable[[float], float]) -> float:
    """Return the share of that step at which a margin falls to zero."""
    low, high = (float(batch.lane[row, 0]) for row in (LOW, HIGH))
    if margin(0.0) <= 0.0:
        return 0.0
    if margin(low) <= 0.0 or margin(high) >= 0.0:  # the edge itself was looked at
        return low if margin(low) <= 0.0 else high
    return float(brentq(margin, low, high, xtol=1e-15, rtol=1e-14))


def _crossing(
    sweep: Sweep, batch: Batch, inputs: Inputs | None
) -> tuple[float, np.ndarray, str, str]:
    """Return time, state, policy and sentence where that step crosses a guard's edge."""
    t, h = batch.now, float(batch.lane[TRIAL_SIZE, 0])
    sweep.enter(t)

    def guard(share: float) -> tuple[float, str, str]:
        u = None if inputs is None else inputs.at(t + share * h)
        return sweep.margin(t + share * h, state_within(batch, share)[: sweep.nstates], u)

    share = edge(batch, lambda share: guard(share)[0])
    return (t + share * h, state_within(batch, share), *guard(share)[1:])


def _until(
    batch: Batch, solution: Solution, t: float, x: np.ndarray, done: int
) -> tuple[np.ndarray, np.ndarray]:
    """Return the samples up to the end of a run that a guard stopped, and that end."""
    start, h = batch.now, float(batch.lane[TRIAL_SIZE, 0])
    times = solution.t[solution.t < t - rounding(t)]
    at_end = solution.t[abs(solution.t - t) <= rounding(t)]  # a sample that is the end
    known = solution.x[: min(done, len(times))]
    within = [state_within(batch, (time - start) / h) for time in times[done:]]
    return np.append(times, [*at_end, t][0]), np.array([*known, *within, x])


def sampled_start(callee: Callee, start: Any, t: float, pieces: Schedule, P: Any) -> np.ndarray:
    """Return the state with which a run begins; blocks that sample then have sampled inputs."""
    if not pieces.begins:
        return start
    return callee.evaluate(JUMP, [t], start, pieces, P, len(start))[0]
