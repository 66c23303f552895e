"""Integrate a diagram, exactly to every breakpoint.

Dormand and Prince's method of order 8 (scipy's DOP853) is restarted wherever a
block jumps, and each block is told which interval it is in, so that no stage of
a step sees the next waypoint.  Values between steps come from the method's own
interpolant of order 7.
"""

from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np
from scipy.integrate import DOP853
from scipy.optimize import brentq

from ..errors import SimulationError
from .sweep import Sweep

FINISHED = "finished: the end of the span was reached"


@dataclass
class Solution:
    """States at the requested times, and how they were reached.

    Attributes
    ----------
    t : ndarray, shape (n,)
        Requested times that were reached.
    x : ndarray, shape (n, nstates)
        States at these times.
    status : str
        ``"finished"`` or ``"stopped"`` (a guard ended the run).
    message : str
        One sentence on how the run ended.
    statistics : dict
        Numbers of steps, evaluations and restarts.
    """

    t: np.ndarray
    x: np.ndarray
    status: str = "finished"
    message: str = FINISHED
    statistics: dict[str, int] = field(default_factory=dict)


def integrate(
    sweep: Sweep,
    x0: np.ndarray,
    times: np.ndarray,
    *,
    rtol: float = 1e-8,
    atol: float = 1e-10,
    inputs: Callable[[float], np.ndarray] | None = None,
    stops: np.ndarray | None = None,
    progress: Callable[[float], None] | None = None,
) -> Solution:
    """Integrate a diagram from the first to the last of the times.

    Parameters
    ----------
    sweep : Sweep
        The diagram's right-hand side.
    x0 : array_like, shape (nstates,)
        State at ``times[0]``.
    times : array_like, shape (n,)
        Increasing times at which states are wanted.
    rtol, atol : float, optional
        Tolerances on the local error of each state.
    inputs : callable, optional
        ``inputs(t)`` gives the diagram's inputs.
    stops : array_like, optional
        More times to stop at exactly, such as kinks of the inputs.
    progress : callable, optional
        Called with the time reached, after each step.

    Returns
    -------
    Solution
        With status, sentence and statistics.

    Raises
    ------
    SimulationError
        If a signal is not finite (block, signal and time are named), the step
        becomes too small, or a guard with the policy ``"raise"`` is crossed.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> scenario = clpt.paper_scenario()
    >>> sweep = Sweep(clpt.closed_loop(scenario))
    >>> solution = integrate(sweep, clpt.initial_state(scenario), [0.0, 10.0])
    >>> solution.x.shape
    (2, 14)
    """
    times = np.asarray(times, dtype=float)
    x = np.array(x0, dtype=float)
    t, end = float(times[0]), float(times[-1])
    states = np.full((len(times), len(x)), np.nan)
    counts = {"steps": 0, "evaluations": 0, "restarts": 0}
    edges = sweep.breakpoints(t, end)
    if stops is not None:
        more = np.asarray(stops, dtype=float)
        edges = np.union1d(edges, more[(more > t) & (more < end)])
    edges = np.append(edges[edges < end], end)
    u = inputs if inputs is not None else lambda t: None
    done = 1
    states[0] = x

    def rate(t: float, x: np.ndarray) -> np.ndarray:
        counts["evaluations"] += 1
        return sweep.derivative(t, x, u(t))

    for edge in edges:
        sweep.enter(t)
        counts["restarts"] += 1
        _check_finite(sweep, t, x, u)
        outside = _left(sweep, t, x, u)
        if outside is not None:
            return _end(outside, times[:1], states[:1], counts)
        if not sweep.nstates:
            states[done:] = x
            done, t = len(times), edge
            continue
        with np.errstate(all="ignore"):
            solver = DOP853(rate, t, x, edge, rtol=max(rtol, 2.3e-14), atol=atol)
        while solver.status == "running":
            with np.errstate(all="ignore"):
                failure = solver.step()
            if solver.status == "failed" or not np.all(np.isfinite(solver.y)):
                trouble = sweep.first_trouble(solver.t, solver.y, u(solver.t)) or _nearby(
                    sweep, solver, u
                )
                reason = f"{trouble} is not finite" if trouble else f"{failure}"
                raise SimulationError(
                    f"the integration stopped at t = {solver.t:.9g}: {reason}; "
                    "check the parameters of that block, or loosen rtol and atol"
                )
            counts["steps"] += 1
            until = solver.t
            outside = _left(sweep, solver.t, solver.y, u)
            dense = None
            if outside is not None:
                dense = solver.dense_output()
                until = _crossing(sweep, dense, solver.t_old, solver.t, u)
                outside = _left(sweep, until, dense(until), u) or outside
            ready = done + np.searchsorted(times[done:], until, side="right")
            if ready > done:
                inner = times[done:ready]
                dense = dense if dense is not None else solver.dense_output()
                states[done:ready] = dense(inner).T
                if inner[-1] == solver.t:
                    states[ready - 1] = solver.y
                done = ready
            if outside is not None and dense is not None:
                if times[done - 1] < until:
                    times = np.append(times[:done], until)
                    states = np.vstack([states[:done], dense(until)])
                    done += 1
                return _end(outside, times[:done], states[:done], counts)
            if progress is not None:
                progress(solver.t)
        t, x = float(edge), solver.y
    sweep.enter(t)
    return Solution(times, states, statistics=counts)


def _check_finite(sweep: Sweep, t: float, x: np.ndarray, u) -> None:
    trouble = sweep.first_trouble(t, x, u(t))
    if trouble is not None:
        raise SimulationError(
            f"the run cannot go on at t = {t:.9g}: {trouble} is not finite; "
            "check the parameters of that block and the initial state"
        )


def _nearby(sweep: Sweep, solver: DOP853, u) -> str | None:
    """Look one small step ahead for what made the step fail."""
    for h in np.geomspace(1e-12, 1.0, 13):
        ahead = solver.t + h * (solver.t_bound - solver.t)
        with np.errstate(all="ignore"):
            trouble = sweep.first_trouble(ahead, solver.y + h * solver.f, u(ahead))
        if trouble is not None:
            return trouble
    return None


def _left(sweep: Sweep, t: float, x: np.ndarray, u) -> tuple[str, str] | None:
    """Give (policy, sentence) of the first guard that is crossed."""
    guarded = sweep.guards()
    if not guarded:
        return None
    sweep.evaluate(t, x, u(t))
    for node, p in guarded:
        guard, block_inputs = node.system.guard, sweep.inputs_of(node)
        if guard.distance(t, block_inputs, p) < -1e-9:
            return guard.policy, guard.sentence(t, block_inputs, p)
    return None


def _crossing(sweep: Sweep, dense, t0: float, t1: float, u) -> float:
    """Find the first time in a step at which a guard is crossed."""

    def distance(t: float) -> float:
        sweep.evaluate(t, dense(t), u(t))
        return min(
            node.system.guard.distance(t, sweep.inputs_of(node), p) for node, p in sweep.guards()
        )

    if distance(t0) <= 0:
        return t0
    return float(brentq(distance, t0, t1, xtol=1e-12 * max(1.0, abs(t1))))


def _end(outside: tuple[str, str], times, states, counts) -> Solution:
    policy, sentence = outside
    if policy == "raise":
        raise SimulationError(f'{sentence}; flow.outside = "clip" or "stop" goes on or ends there')
    return Solution(times.copy(), states.copy(), "stopped", f"stopped: {sentence}", counts)
