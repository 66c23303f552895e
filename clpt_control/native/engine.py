"""Run a diagram as machine code.

`NativeDiagram` holds a fused diagram with its parameters; `run` integrates it
like `integrate` does, exactly to every breakpoint, some thousands of steps at a
call so that it can be watched and interrupted.  Where the compiled run meets
trouble, a guard or a number that is not finite, the plain engine goes on from
the last good state and says what it is.
"""

from collections.abc import Callable, Mapping
from typing import Any

import control
import numpy as np

from ..errors import SimulationError
from .compiled import compiled_module, lane_module_or_none
from .fuse import fuse
from .solution import Solution
from .sweep import Sweep

BUDGET = 20_000  # steps a call
MOST_STEPS = 500_000_000  # tries; a run that needs more is stiff
RUNNING, FINISHED, LEFT = 0, 1, 4
METHODS = ("dop853", "vern7")


class NativeDiagram:
    """A diagram compiled to machine code.

    Parameters
    ----------
    diagram : control.NonlinearIOSystem
        Blocks, wired.
    params : mapping, optional
        Call-time parameters by qualified name.

    Attributes
    ----------
    sweep : Sweep
        The plain evaluator of the same diagram and parameters.
    fused : Fused
        Code and places.
    module : module
        The compiled functions.

    Raises
    ------
    DiagramError
        If a system is no block.
    Unreadable
        If a block's equations cannot be flattened.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> scenario = clpt.paper_scenario()
    >>> native = NativeDiagram(clpt.closed_loop(scenario))
    >>> native.run(clpt.initial_state(scenario), [0.0, 20.0]).x.shape
    (2, 14)
    """

    def __init__(self, diagram: control.NonlinearIOSystem, params: Mapping[str, Any] | None = None):
        self.sweep = Sweep(diagram, params)
        self.fused = fuse(diagram, self.sweep.given)
        self.module = compiled_module(self.fused)

    def pieces(self, t0: float, t1: float, stops: np.ndarray | None) -> tuple[np.ndarray, ...]:
        """Give edges, places of intervals in P, their values per piece."""
        edges = self.sweep.breakpoints(t0, t1)
        if stops is not None:
            edges = np.union1d(edges, stops[(stops > t0) & (stops < t1)])
        edges = np.append(edges[edges < t1], t1)
        starts = np.append(t0, edges)
        intervals = self.fused.layout.intervals
        places = np.array(list(intervals.values()), dtype=np.int64)
        values = np.empty((len(starts), len(places)))
        for j, k in enumerate(intervals):
            block, given = self.sweep.nodes[k].system, self.sweep.given[k]
            if given.interval >= 0:
                values[:, j] = given.interval
            else:
                jumps = block.breakpoints(0.0, t1, given)
                values[:, j] = np.searchsorted(jumps, starts, side="right")
        return edges, places, values

    def parameters(self) -> np.ndarray:
        """Give P with room for inputs and what is prepared."""
        P = self.fused.layout.P
        return np.append(P, np.zeros(self.fused.size - len(P)))

    def run(
        self,
        x0: np.ndarray,
        times: np.ndarray,
        *,
        rtol: float = 1e-8,
        atol: float = 1e-10,
        samples: tuple[np.ndarray, np.ndarray] | None = None,
        progress: Callable[[float], None] | None = None,
        step: float | None = None,
        method: str = "dop853",
    ) -> Solution:
        """Integrate from the first to the last of the times.

        Parameters
        ----------
        x0 : array_like, shape (nstates,)
            State at ``times[0]``.
        times : array_like, shape (n,)
            Increasing times at which states are wanted.
        rtol, atol : float, optional
            Tolerances on the local error of each state.
        samples : tuple of ndarray, optional
            Times and values, shape (ninputs, nt), of the diagram's inputs,
            joined by straight lines.
        progress : callable, optional
            Called with the time reached.
        step : float, optional
            A fixed step: Runge and Kutta's classical method of order 4 in
            place of DOP853; steps end at every breakpoint and sample.
        method : str, optional
            ``"dop853"``, or ``"vern7"``, cheaper for few samples and errors
            above 1e-9; its steps end at every sample.

        Returns
        -------
        Solution
            As `integrate` gives it.

        Raises
        ------
        SimulationError
            If the run cannot go on.
        """
        times = np.asarray(times, dtype=float)
        start = np.array(x0, dtype=float)
        stops = None if samples is None else samples[0]
        edges, places, values = self.pieces(times[0], times[-1], stops)
        P, T = self.parameters(), self.fused.layout.T
        if samples is not None:
            places, values = self._ramps(samples, edges, times[0], places, values)
        nx = self.fused.nstates
        Z, F, W = np.zeros(18 * nx), np.zeros(7 * nx), np.zeros(self.fused.nsignals)
        Z[:nx] = start
        if step is not None:
            return self._fixed(start, times, step, P, edges, places, values)
        S = np.array([times[0], 0.0, 0.0, 1.0, 1.0])
        states = np.full((len(times), nx), np.nan)
        states[0] = start
        counts = np.zeros(4, dtype=np.int64)
        status, advance = RUNNING, self._advance(method)
        while status == RUNNING:
            status = advance(
                S, Z, P, T, W, F, edges, places, values, times, states,
                max(rtol, 2.3e-14), atol, BUDGET, counts,
            )  # fmt: skip
            if progress is not None:
                progress(S[0])
            if counts[0] + counts[3] > MOST_STEPS:
                raise SimulationError(
                    f"too many steps: {counts[0] + counts[3]:,} by t = {S[0]:.9g}; the equations "
                    "are stiff there: lower the gains, or loosen rtol and atol"
                )
        statistics = {"steps": int(counts[0]), "evaluations": int(counts[1]),
                      "restarts": int(counts[2])}  # fmt: skip
        if status != FINISHED:
            return self._explained(S, Z[:nx], times, states, rtol, atol, samples, statistics)
        return Solution(times, states, statistics=statistics)

    def run_many(
        self,
        starts: np.ndarray,
        times: np.ndarray,
        *,
        rtol: float = 1e-8,
        atol: float = 1e-10,
        step: float | None = None,
    ) -> np.ndarray:
        """Integrate from many initial states, such as passive particles.

        Parameters
        ----------
        starts : array_like, shape (m, nstates)
            Initial states at ``times[0]``.
        times : array_like, shape (n,)
            Increasing times at which states are wanted.
        rtol, atol : float, optional
            Tolerances of DOP853.
        step : float, optional
            A fixed step: Runge and Kutta's classical method of order 4.

        Returns
        -------
        ndarray, shape (m, n, nstates)
            NaN from where a run could not go on.

        Examples
        --------
        >>> import clpt_control as clpt
        >>> scenario = clpt.paper_scenario()
        >>> native = NativeDiagram(clpt.closed_loop(scenario))
        >>> native.run_many([clpt.initial_state(scenario)] * 3, [0.0, 5.0]).shape
        (3, 2, 14)
        """
        starts, times = np.array(starts, dtype=float), np.asarray(times, dtype=float)
        edges, places, values = self.pieces(times[0], times[-1], None)
        out = np.full((len(starts), len(times), starts.shape[1]), np.nan)
        status, reached = (np.zeros(len(starts), np.int64) for _ in range(2))
        counts = np.zeros((len(starts), 4), np.int64)
        P = np.tile(self.parameters(), (len(starts), 1))
        T, common = self.fused.layout.T, (times, out, status, reached, counts)
        lanes = lane_module_or_none(self.fused) if step is not None and len(starts) > 1 else None
        if lanes is not None:
            sizes = (4 * self.fused.nstates, self.fused.size, max(self.fused.nsignals, 1))
            lanes.many_rk4(
                0, len(starts), starts, P, T, edges, places, values, *common, float(step or 0.0),
                *(np.zeros((size, 8)) for size in sizes),
            )  # fmt: skip
            return out
        schedule = (np.zeros(len(starts), np.int64), edges[None], np.array([len(edges)]))
        arguments = (0, len(starts), starts, P, T, *schedule, places, values[None], *common)
        if step is None:
            self.module.many(*arguments, rtol, atol)
        else:
            self.module.many_rk4(*arguments, float(step))
        return out

    def _advance(self, method: str) -> Callable:
        """Give the compiled stepping function of a method."""
        if method not in METHODS:
            raise SimulationError(f"method = '{method}': must be one of {', '.join(METHODS)}")
        if method == "vern7" and not self.fused.guarded:
            return compiled_module(self.fused, "vern7").advance
        return self.module.advance

    def _fixed(self, x, times, step, P, edges, places, values) -> Solution:
        """Integrate with a fixed step."""
        if not step > 0:
            raise SimulationError(f"step = {step}: must be positive")
        out, status = np.full((1, len(times), len(x)), np.nan), np.zeros(1, np.int64)
        reached, counts = np.zeros(1, np.int64), np.zeros((1, 4), np.int64)
        self.module.many_rk4(
            0, 1, x[None], P[None], self.fused.layout.T, np.zeros(1, np.int64), edges[None],
            np.array([len(edges)]), places, values[None], times, out, status, reached, counts,
            float(step),
        )  # fmt: skip
        statistics = dict(zip(("steps", "evaluations", "restarts"), map(int, counts[0]),
                              strict=False))  # fmt: skip
        if status[0] != FINISHED:
            last = times[max(int(reached[0]) - 1, 0)]
            why = "a guard was crossed" if status[0] == LEFT else "a state is not finite"
            raise SimulationError(f"the fixed-step run ended after t = {last:.9g}: {why}")
        return Solution(times, out[0], statistics=statistics)

    def _ramps(self, samples, edges, t0, places, values) -> tuple[np.ndarray, np.ndarray]:
        """Add the diagram's inputs, straight within a piece, to what a piece sets."""
        at, u = samples
        ramp, n = self.fused.ramp, self.fused.ninputs
        starts = np.append(t0, edges)
        k = np.clip(np.searchsorted(at, starts, side="right") - 1, 0, max(len(at) - 2, 0))
        slopes = np.diff(u, axis=1) / np.diff(at) if len(at) > 1 else np.zeros((n, 1))
        rows = np.column_stack([at[k], u[:, k].T, slopes[:, k].T])
        return (
            np.append(places, np.arange(ramp, ramp + 1 + 2 * n)),
            np.hstack([values, rows]),
        )

    def _explained(self, S, x, times, states, rtol, atol, samples, statistics) -> Solution:
        """Go on with the plain engine, which names block, signal and time."""
        t, done = float(S[0]), int(S[3])
        rest = times[times > t]
        u = None
        if samples is not None:

            def u(t, at=samples[0], values=samples[1]):
                return np.array([np.interp(t, at, row) for row in values])

        from .integrate import integrate

        tail = integrate(
            self.sweep, x, np.append(t, rest), rtol=rtol, atol=atol, inputs=u,
            stops=None if samples is None else samples[0],
        )  # fmt: skip
        for name, value in tail.statistics.items():
            statistics[name] += value
        keep = tail.t[1:] if len(tail.t) > 1 else tail.t[:0]
        return Solution(
            np.append(times[:done], keep),
            np.vstack([states[:done], tail.x[1:]]) if len(keep) else states[:done],
            tail.status,
            tail.message,
            statistics,
        )

    def signals(
        self, solution: Solution, samples: tuple[np.ndarray, np.ndarray] | None = None
    ) -> np.ndarray:
        """Give all block outputs at a solution's times.

        Parameters
        ----------
        solution : Solution
            Times and states.
        samples : tuple of ndarray, optional
            As for `run`.

        Returns
        -------
        ndarray, shape (ntimes, nsignals)
            In the order of `Sweep.signals`.
        """
        times = solution.t
        edges, places, values = self.pieces(
            times[0], times[-1], None if samples is None else samples[0]
        )
        P = self.parameters()
        if samples is not None:
            places, values = self._ramps(samples, edges, times[0], places, values)
        pieces = np.searchsorted(edges, times, side="right").astype(np.int64)
        out = np.empty((len(times), self.fused.nsignals))
        self.module.record(
            times, solution.x, pieces, P, self.fused.layout.T, np.zeros(self.fused.nsignals),
            places, values, out,
        )  # fmt: skip
        return out


__all__ = ["NativeDiagram"]
