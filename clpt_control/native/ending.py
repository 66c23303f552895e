"""How a run ended: its states, or a sentence that names block, signal and time.

Where a run meets trouble, a guard or a number that is not finite, the blocks are asked
in Python which signal it is.
"""

import numpy as np

from ..errors import SimulationError
from . import method, solver
from .inputs import Inputs
from .runs import Runs
from .solution import Solution
from .status import Status
from .sweep import Sweep


def ended(sweep: Sweep, runs: Runs, inputs: Inputs | None) -> Solution:
    """Return the solution of a single run.

    Parameters
    ----------
    sweep : Sweep
        The diagram in Python, with the parameters that ran.
    runs : Runs
        One run, at its end.
    inputs : Inputs or None
        Inputs of the diagram.

    Returns
    -------
    Solution
        Finished, or stopped by a guard whose policy says so.

    Raises
    ------
    SimulationError
        If it could not go on: block, signal and time are named.
    """
    status = Status(runs.status[0])  # type: ignore[call-arg]
    done = int(runs.reached[0])
    names = ("steps", "evaluations", "restarts")
    statistics = dict(zip(names, map(int, runs.counts[0]), strict=False))
    times, states = runs.times, runs.out[0]
    if status is Status.FINISHED:
        return Solution(times, states, statistics=statistics)
    if status is Status.LEFT:
        t, x, policy, sentence = _crossing(sweep, runs, inputs)
        if policy == "raise":
            raise SimulationError(
                f'{sentence}; flow.outside = "clip" or "stop" goes on or ends there'
            )
        times, states = _until(runs, t, x, done)
        return Solution(times, states, "stopped", f"stopped: {sentence}", statistics)
    reason = _trouble(sweep, runs, inputs) or status.sentence
    raise SimulationError(
        f"the integration stopped at t = {runs.now:.9g}: {reason}; "
        "check the parameters of that block, or loosen rtol and atol"
    )


def _trouble(sweep: Sweep, runs: Runs, inputs: Inputs | None) -> str | None:
    """Name what is not finite at the state reached, or a small step ahead of it."""
    n, t = sweep.nstates, runs.now
    x, rate = (runs.Z[r * n : (r + 1) * n] for r in (0, method.RATE))
    ahead = float(runs.numbers[method.END, 0]) - t
    sweep.enter(t)
    for h in (0.0, *(ahead * np.geomspace(1e-12, 1.0, 13))):
        near = x + h * rate if h else x  # the rate itself may be what is not finite
        found = sweep.first_trouble(t + h, near, _at(inputs, t + h))
        if found is not None:
            return f"{found} is not finite"
    return None


def _crossing(
    sweep: Sweep, runs: Runs, inputs: Inputs | None
) -> tuple[float, np.ndarray, str, str]:
    """Find where the step that was not taken crosses a guard's edge."""
    from scipy.optimize import brentq

    n, t, h = sweep.nstates, runs.now, float(runs.numbers[method.TAKEN, 0])
    sweep.enter(t)

    def state(share: float) -> np.ndarray:
        return np.array([solver.between(runs.Z, n, 1, 0, i, share) for i in range(n)])

    def margin(share: float) -> float:
        return sweep.margin(t + share * h, state(share), _at(inputs, t + share * h))[0]

    here, inside = runs.Z[:n].copy(), 0.0
    if margin(0.0) <= 0.0:
        return (t, here, *sweep.margin(t, here, _at(inputs, t))[1:])
    for look in range(1, solver.LOOKS + 1):
        share = look / solver.LOOKS
        if margin(share) < -solver.OUTSIDE:
            share = brentq(margin, inside, share, xtol=1e-15, rtol=1e-14)
            break
        inside = share
    x = state(share)
    return (t + share * h, x, *sweep.margin(t + share * h, x, _at(inputs, t + share * h))[1:])


def _until(runs: Runs, t: float, x: np.ndarray, done: int) -> tuple[np.ndarray, np.ndarray]:
    """Return the samples up to the end of a run that a guard stopped, and that end."""
    times, states = runs.times[:done], runs.out[0][:done]
    n, start, h = runs.callee.nstates, runs.now, float(runs.numbers[method.TAKEN, 0])
    for time in runs.times[done:]:
        if time > t:
            break
        share = (time - start) / h
        inner = [solver.between(runs.Z, n, 1, 0, i, share) for i in range(n)]
        times, states = np.append(times, time), np.vstack([states, inner])
    if times[-1] < t:
        times, states = np.append(times, t), np.vstack([states, x])
    return times.copy(), states.copy()


def _at(inputs: Inputs | None, t: float) -> np.ndarray | None:
    return None if inputs is None else inputs.at(t)
