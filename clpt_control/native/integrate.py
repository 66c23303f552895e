"""Integrate a diagram, exactly to every breakpoint.

Dormand and Prince's method of order 8 (scipy's DOP853) is restarted wherever a
block jumps, and each block is told which interval it is in, so that no stage of
a step sees the next waypoint.  Values between steps come from the method's own
interpolant of order 7.
"""

from collections.abc import Callable
from typing import Any

import numpy as np
from scipy.integrate import DOP853
from scipy.optimize import brentq

from ..errors import SimulationError
from .solution import Solution
from .sweep import Sweep

OUTSIDE = 1e-9  # grid steps beyond the edge that count as outside


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

    fence = Fence(sweep, u)
    for edge in edges:
        sweep.enter(t)
        counts["restarts"] += 1
        trouble = sweep.first_trouble(t, x, u(t))
        if trouble is not None:
            raise SimulationError(
                f"the run cannot go on at t = {t:.9g}: {trouble} is not finite; "
                "check the parameters of that block and the initial state"
            )
        if fence.distance(t, x) < -OUTSIDE:
            return _end(fence.verdict(t, x), times[:done], states[:done], counts)
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
            dense = None
            until = fence.crossing(solver)
            reached = solver.t if until is None else until
            ready = done + int(np.searchsorted(times[done:], reached, side="right"))
            if ready > done:
                inner = times[done:ready]
                dense = solver.dense_output()
                states[done:ready] = dense(inner).T
                if inner[-1] == solver.t:
                    states[ready - 1] = solver.y
                done = ready
            if until is not None:
                dense = dense or solver.dense_output()
                verdict = fence.verdict(until, dense(until))
                if times[done - 1] < until:
                    times = np.append(times[:done], until)
                    states = np.vstack([states[:done], dense(until)])
                    done += 1
                return _end(verdict, times[:done], states[:done], counts)
            if progress is not None:
                progress(solver.t)
        t, x = float(edge), solver.y
    sweep.enter(t)
    return Solution(times, states, statistics=counts)


def _nearby(sweep: Sweep, solver: DOP853, u) -> str | None:
    """Look one small step ahead for what made the step fail."""
    for h in np.geomspace(1e-12, 1.0, 13):
        ahead = solver.t + h * (solver.t_bound - solver.t)
        trouble = sweep.first_trouble(ahead, solver.y + h * solver.f, u(ahead))
        if trouble is not None:
            return trouble
    return None


class Fence:
    """The guards of a diagram: where a run may be.

    Parameters
    ----------
    sweep : Sweep
        The diagram.
    u : callable
        Inputs of the diagram as a function of time.
    """

    def __init__(self, sweep: Sweep, u: Callable[[float], Any]):
        self.sweep, self.u = sweep, u
        self.guarded = bool(sweep.guards())

    def distance(self, t: float, x: np.ndarray) -> float:
        """Give the smallest distance to a guard's edge, negative outside."""
        if not self.guarded:
            return 1.0
        return min(distance for distance, *_ in self._looked_at(t, x))

    def _looked_at(self, t: float, x: np.ndarray) -> list[tuple]:
        with np.errstate(all="ignore"):
            self.sweep.evaluate(t, x, self.u(t))
        found = []
        for node, p in self.sweep.guards():
            block_inputs = self.sweep.inputs_of(node)
            found.append((node.system.guard.margin(t, block_inputs, p), node, p, block_inputs))
        return found

    def crossing(self, solver: DOP853) -> float | None:
        """Find the first time in the last step that crosses a guard.

        The step's interpolant is looked at in sixteen places, so that a short
        excursion within a step is found too.
        """
        if not self.guarded:
            return None
        dense = solver.dense_output()
        times = np.linspace(solver.t_old, solver.t, 17)
        inside = times[0]
        for time in times[1:]:
            if self.distance(time, dense(time)) < -OUTSIDE:
                if self.distance(inside, dense(inside)) <= 0:
                    return float(inside)
                edge = brentq(
                    lambda t: self.distance(t, dense(t)), inside, time, xtol=1e-12, rtol=1e-14
                )
                return float(edge)
            inside = time
        return None

    def verdict(self, t: float, x: np.ndarray) -> tuple[str, str]:
        """Give the policy and the sentence of the guard that is nearest."""
        _, node, p, block_inputs = min(self._looked_at(t, x), key=lambda found: found[0])
        guard = node.system.guard
        return guard.policy, guard.sentence(t, block_inputs, p)


def _end(outside: tuple[str, str], times, states, counts) -> Solution:
    policy, sentence = outside
    if policy == "raise":
        raise SimulationError(f'{sentence}; flow.outside = "clip" or "stop" goes on or ends there')
    return Solution(times.copy(), states.copy(), "stopped", f"stopped: {sentence}", counts)
