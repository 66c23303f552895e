"""The end of a run: a solution, or an error with a sentence.

When a run meets a guard, or a number that is not finite, the blocks are evaluated in Python to find
the signal: the sentence names block, signal and time.
"""

from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np
from numpy import ndarray

from ...base.errors import SimulationError
from .batch import Batch
from .evaluation_pass import Sweep, rounding
from .inputs import Inputs
from .schedule import Schedule
from .solver_layout import (
    EVENT_INDEX,
    HIGH,
    RATE,
    SEGMENT_END,
    STATE,
    TRIAL_SIZE,
    Status,
    interpolate,
)

# ends that a locked decision may cause: sqrt(max(x, 0)) has no value beyond its switch
STUCK = (Status.NOT_FINITE, Status.STEP_TOO_SMALL, Status.TOO_MANY_STEPS)
ADVICE = "check the parameters of that block"  # where a signal is not finite
LOOSEN = ", or loosen rtol and atol"
GROWN = 1e6  # times the first states


@dataclass
class Solution:
    """States x (n, nstates) at the times t (n,) that were reached.

    `status` is ``"finished"``, or ``"stopped"`` if a guard ended the run; `message` is a sentence
    on it.  `statistics` are the numbers of steps, evaluations and restarts.  `engine` is
    ``"native"`` or ``"python"``, `method` the method, and from which time on another one.  `pieces`
    are the segments of time of machine code; `signals` those that were computed on the way.
    """

    t: ndarray
    x: ndarray
    status: str = "finished"
    message: str = Status.FINISHED.sentence
    statistics: dict[str, int] = field(default_factory=dict)
    engine: str = "python"
    method: str = "none"
    pieces: Schedule | None = field(default=None, repr=False, compare=False)
    signals: ndarray | None = field(default=None, repr=False, compare=False)


def ended(run: Any, solution: Solution, inputs: Inputs) -> Solution:
    """Return the solution of a `NativeRun` that a guard stopped, or raise an error on its end.

    The sweep of the diagram finds the reason, with the parameters of the run.
    """
    status, last = run.status, run.last
    sweep = run.diagram.sweep
    if status == Status.GUARD_LEFT:
        t, x = stopped_at(last)
        sweep.enter(last.now)
        _, policy, sentence = sweep.margin(t, x[: sweep.nstates], inputs.at(t))
        near = rounding(t, solution.t[-1] - solution.t[0])
        times = solution.t[solution.t < t - near]
        at_end = solution.t[abs(solution.t - t) <= near]  # a sample that is the end
        end = at_end[0] if len(at_end) else t
        states = np.array([*solution.x[: len(times)], x])
        return stopped(solution, policy, sentence, np.append(times, end), states)
    reason = Status(status).sentence
    if status == Status.ACCUMULATING:
        reason = f"{', '.join(sweep.resetting)} {reason}"
    elif status in (Status.CHATTERING, Status.UNDECIDED):
        reason = run.refusal or f"{_switch(sweep, last)} {reason}"
    elif status == Status.STEP_TOO_SMALL:
        reason = _growth(sweep, last, solution.x[0]) or reason
    reason = _trouble(sweep, last, inputs) or reason
    work = "run" if last.callee.method.discrete else "integration"
    error = SimulationError(f"the {work} stopped at t = {last.now:.9g}: {reason}")
    error.points = _points_of(last)
    error.status, error.states = status, solution.x[: run.results.reached[0]]
    raise error


@np.errstate(all="ignore")  # times and rates may be as large as numbers go
def _points_of(batch: Batch) -> list[tuple[float, ndarray]]:
    """Return time and state where a run stopped, and points of the next span along the rates."""
    t, (x, rate) = batch.now, batch.states[[STATE, RATE], :, 0]
    span = 0.0 if batch.callee.method.discrete else batch.lane[SEGMENT_END, 0] - t
    steps = span * np.geomspace(1e-12, 1.0, 13) if span else ()
    return [(t, x), *((t + h, x + h * rate) for h in steps)]


def without_states(
    sweep: Sweep, times: ndarray, inputs: Inputs, engine: str
) -> Solution:
    """Return the solution of a diagram without states, up to where it leaves a guard."""
    solution = Solution(times, np.zeros((len(times), 0)), engine=engine)

    def guard(t: float) -> tuple[float, str, str]:
        sweep.enter(t)
        return sweep.margin(t, solution.x[0], inputs.at(t))

    for k, t in enumerate(times if sweep.guarded else ()):
        if guard(t)[0] >= 0.0:
            continue
        low, high = times[max(k - 1, 0)], t
        while low < (middle := 0.5 * (low + high)) < high:
            is_inside = guard(middle)[0] >= 0.0
            low, high = (middle, high) if is_inside else (low, middle)
        _, policy, sentence = guard(high)
        reached = np.append(times[:k], high)
        return stopped(solution, policy, sentence, reached, np.zeros((k + 1, 0)))
    return solution


def stopped(solution: Solution, policy: str, sentence: str, t: Any, x: Any) -> Solution:
    """Return a solution up to where a guard was left, or raise its error."""
    if policy == "raise":
        error = SimulationError(sentence)
        error.status, error.states = Status.GUARD_LEFT, x[:-1]
        raise error
    return replace(solution, t=t, x=x, status="stopped", message=f"stopped: {sentence}")


def decision_name(sweep: Sweep, program: Any, number: int) -> str:
    """Return where a decision is made: operation, block and function."""
    k, role, kind = [at for first, at in program.deciding if first <= number][-1]
    symbols = {"lt": "<", "le": "<=", "gt": ">", "ge": ">="}
    return f"`{symbols.get(kind, kind)}` in {sweep.nodes[k].name}.{role}"


def _switch(sweep: Sweep, batch: Batch) -> str:
    """Return the decision of a run that chatters."""
    event = int(batch.integers[EVENT_INDEX, 0])
    if event < 0:
        return "a decision"
    return decision_name(sweep, batch.callee.program, event)


def _trouble(sweep: Sweep, batch: Batch, inputs: Inputs) -> str | None:
    """Return a sentence on the value that is not finite at the state reached, or ahead of it."""
    t = batch.now
    advice = ADVICE
    if not batch.callee.method.discrete:
        advice = f"{ADVICE}{LOOSEN}"
    points = _points_of(batch)
    # 1. repeat a jump that gave a state that is not finite
    sweep.enter(t)
    for k in sweep.jumping:
        sweep.nodes[k].system.raised.pop("jump", None)
    samples = batch.out[0]
    finite = samples[np.isfinite(samples).all(axis=1)]
    state = points[0][1][: sweep.nstates]
    now_finite = np.isfinite(state).all()
    if sweep.jumping and len(finite) and not now_finite:
        u = inputs.at(t)
        sweep.jump(t, finite[-1, : sweep.nstates], u, sweep.jumping)
    # 2. evaluate all blocks
    for time, state in points:
        at = time, state[: sweep.nstates], inputs.at(time)
        trouble = sweep.first_trouble(*at, advice)
        if trouble is not None:
            return trouble
    return _derivative_trouble(sweep, batch, advice)


def _derivative_trouble(sweep: Sweep, batch: Batch, advice: str) -> str | None:
    """Return a sentence on a derivative along a direction that is not finite, or None."""
    rates = batch.states[RATE, sweep.nstates :, 0]
    for index in np.flatnonzero(~np.isfinite(rates)):
        state = _name_of(sweep, index % sweep.nstates)
        return f"derivative of d_{state} is not finite; {advice}"
    return None


def _growth(sweep: Sweep, batch: Batch, first: ndarray) -> str:
    """Return a sentence on a state that is far larger than the first ones, or ""."""
    state = np.abs(batch.states[STATE, : sweep.nstates, 0])
    k = int(np.argmax(state))
    if not state[k] > GROWN * (1.0 + np.abs(first[: sweep.nstates]).max()):
        return ""
    grown = f"{_name_of(sweep, k)} has grown to {state[k]:.1g}"
    return f"{grown}, and may have no value soon; end the run before"


def _name_of(sweep: Sweep, k: int) -> str:
    """Return the label of a state and its block."""
    node = next(node for node in sweep.nodes if k < node.states.stop)
    return f"{node.system.state_labels[k - node.states.start]} of block {node.name}"


def stopped_at(batch: Batch, edge: int = HIGH) -> tuple[float, ndarray]:
    """Return time and state where the step that was not taken leaves a guard, or before it."""
    share = float(batch.lane[edge, 0])
    t = batch.now + share * float(batch.lane[TRIAL_SIZE, 0])
    n = batch.callee.nstates
    return t, np.array([interpolate(batch.states, i, 0, share) for i in range(n)])
