"""Run a diagram block by block in Python.

The solver is the one that machine code runs with.
"""

from collections.abc import Callable, Mapping, Sequence
from typing import Any

import control
import numpy as np

from ..diagrams.interconnection import changed_parameters
from ..diagrams.wiring import Wiring, read
from ..errors import SimulationError
from . import method, solver
from .ending import ended
from .inputs import Inputs
from .runs import MEMBER_STEPS, Callee, Runs, pace
from .schedule import Schedule, schedule
from .solution import Solution
from .sweep import Sweep, first_not_finite

Watch = Callable[[Runs], None]


class PlainDiagram:
    """A diagram ready to run, block by block in Python.

    Parameters
    ----------
    diagram : control.NonlinearIOSystem or Wiring
        Blocks, wired, and any python-control systems.
    params : mapping, optional
        Call-time parameters by qualified name.

    Attributes
    ----------
    sweep : Sweep
        Evaluates it in Python.
    wiring : Wiring
        Its blocks.
    nstates : int
        Number of states.

    Raises
    ------
    DiagramError
        If blocks feed each other in a circle.
    BlockError
        If a parameter is unknown.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> scenario = clpt.paper_scenario()
    >>> plain = PlainDiagram(clpt.closed_loop(scenario))
    >>> plain.run(clpt.initial_state(scenario), [0.0, 2.0]).x.shape
    (2, 14)
    """

    most = 10_000_000  # tries of a run

    def __init__(
        self, diagram: control.NonlinearIOSystem | Wiring, params: Mapping[str, Any] | None = None
    ):
        self.wiring = diagram if isinstance(diagram, Wiring) else read(diagram)
        self.sweep = Sweep(self.wiring, changed_parameters(self.wiring, params))
        self.nstates, self.nsignals = self.sweep.nstates, len(self.sweep.signals)

    # --- what machine code does otherwise -------------------------------------------------

    def parameters(self) -> np.ndarray:
        """Return P, which the solver carries; empty in Python."""
        return np.zeros(0)

    def schedule(self, t0: float, t1: float, inputs: Inputs | None = None) -> Schedule:
        """Return the pieces of a run."""
        kinks = None if inputs is None else inputs.kinks
        return schedule(self.sweep, {}, t0, t1, kinks)

    def callee(self, lanes: int = 1, inputs: Inputs | None = None) -> Callee:
        """Return what the solver calls."""
        n, sweep = self.nstates, self.sweep

        def u(t: np.ndarray) -> np.ndarray | None:
            return None if inputs is None else inputs.at(float(t[0]))

        def derivative(t, X, first, P, T, W, D, to):
            D[to : to + n] = sweep.derivative(t[0], X[first : first + n], u(t))

        def prepare(t, X, first, P, T, W, D, to):
            sweep.enter(t[0])

        def margin(t, X, first, P, T, W, D, to):
            D[to] = sweep.margin(t[0], X[first : first + n], u(t))[0]

        def signals(t, X, first, P, T, W, D, to):
            W[: self.nsignals] = sweep.evaluate(t[0], X[first : first + n], u(t))

        formulas = [method.on_rows(f, n) for f in method.formulas(n).values()] if n else []
        functions = [derivative, prepare, margin, signals, *formulas]
        guarded = sweep.guarded
        return Callee(solver, functions, 1, n, self.nsignals, np.zeros(0), guarded, self.most)

    # --- runs -----------------------------------------------------------------------------

    def run(
        self,
        x0: Sequence[float] | np.ndarray,
        times: Sequence[float] | np.ndarray,
        *,
        rtol: float = 1e-8,
        atol: float = 1e-10,
        inputs: Inputs | None = None,
        progress: Callable[[float], None] | None = None,
        step: float | None = None,
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
        inputs : Inputs, optional
            Inputs of the diagram.
        progress : callable, optional
            Called with the time reached, some times a second.
        step : float, optional
            A fixed step: Runge and Kutta's classical method of order 4 in
            place of DOP853; steps end at every breakpoint and sample.

        Returns
        -------
        Solution
            With status, sentence and statistics.

        Raises
        ------
        SimulationError
            If a signal is not finite (block, signal and time are named), the
            step becomes too small, the end is out of reach, or a guard with
            the policy ``"raise"`` is crossed.
        """
        times, start = np.asarray(times, dtype=float), np.array(x0, dtype=float)
        t0, t1 = float(times[0]), float(times[-1])
        if not self.nstates:
            return Solution(times, np.zeros((len(times), 0)))
        runs = Runs(
            self.callee(1, inputs),
            start[None],
            self.parameters()[None],
            times,
            [self.schedule(t0, t1, inputs)],
        )
        if step is not None:
            runs.fixed(step)
        else:
            keeps_pace = pace(self.most, t1 - t0, t0)

            def watch(runs: Runs) -> None:
                if progress is not None:
                    progress(runs.now)
                keeps_pace(runs)

            runs.adaptive(rtol, atol, watch, self.most)
        return ended(self.sweep, runs, inputs)

    def run_many(
        self,
        starts: Sequence[Any] | np.ndarray,
        times: Sequence[float] | np.ndarray,
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
        """
        starts, times = np.array(starts, dtype=float), np.asarray(times, dtype=float)
        P = np.tile(self.parameters(), (len(starts), 1))
        pieces = [self.schedule(float(times[0]), float(times[-1]))]
        runs = Runs(self.callee(self.lanes(len(starts))), starts, P, times, pieces)
        if step is None:
            runs.adaptive(rtol, atol, most=MEMBER_STEPS)
        else:
            runs.fixed(step)
        return runs.out

    def lanes(self, count: int) -> int:
        """Return how many of so many runs are taken at once."""
        return 1

    def signals(self, solution: Solution, inputs: Inputs | None = None) -> np.ndarray:
        """Return all block outputs at a solution's times.

        Values at a jump are right limits.

        Parameters
        ----------
        solution : Solution
            Times and states.
        inputs : Inputs, optional
            As for `run`.

        Returns
        -------
        ndarray, shape (ntimes, nsignals)
            In the order of the wiring.

        Raises
        ------
        SimulationError
            If a signal is not finite.
        """
        times = solution.t
        if not len(times):  # stopped before the first
            return np.zeros((0, self.nsignals))
        pieces = self.schedule(float(times[0]), float(times[-1]), inputs)
        number = np.searchsorted(pieces.edges, times, side="right")
        callee = self.callee(1, inputs)
        own = self.parameters()
        P, W = np.append(own, 0.0), np.zeros(max(callee.room, 1))
        out = np.empty((len(times), self.nsignals))
        states = np.append(solution.x.ravel(), 0.0)
        callee.solver.record(
            callee.functions,
            times,
            states,
            self.nstates,
            number,
            pieces.places,
            pieces.values,
            P,
            np.append(callee.tables, 0.0),
            W,
            out,
        )
        bad = np.flatnonzero(~np.all(np.isfinite(out), axis=1))
        if len(bad):
            raise SimulationError(
                f"{first_not_finite(self.wiring, out[bad[0]])} is not finite at "
                f"t = {times[bad[0]]:.9g}; check the parameters of that block, or keep its "
                "arguments in range"
            )
        return out
