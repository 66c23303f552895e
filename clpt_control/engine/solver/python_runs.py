"""A diagram that runs block by block in Python: SciPy integrates from one known stop to the next.

Known stops are breakpoints and samples of blocks and sharp bends of inputs; guards end a run.
Jumps of rates elsewhere are left to the step control.  LSODA, which is implicit where equations are
stiff, integrates with `SHARE` of the tolerances: its error and its evaluations are then at most
those of RK45 (python-control's method) at the tolerances (`benchmarks/python_models.py`).  DOP853
takes its place in many short segments, and if LSODA fails, meets a rate that is not finite, or is
running in the model itself.
"""

import threading
import time
import warnings
from typing import Any

import numpy as np
from numpy import ndarray
from scipy.integrate import DOP853, LSODA

from ...base.errors import SimulationError
from ...base.progress.interrupt import check
from ..methods import METHODS
from .batch import PARTS, PAUSE
from .evaluation_pass import rounding
from .event_checks import SHARES, may_hide
from .inputs import Inputs
from .runner import Runner, RunOptions
from .schedule import BEGINS, JUMPS
from .solver_layout import DISTANCE, ROUNDING, Status
from .termination import (
    ADVICE,
    LOOSEN,
    Solution,
    edge,
    in_discrete_time,
    points_ahead,
    stopped_between,
    trouble_at,
    without_states,
)

BEND = 200.0  # tolerances of an input: a run stops where it bends off its line by more
SHARE = 1 / 30  # of the tolerances, for LSODA
MOST_SEGMENTS = (
    20  # of LSODA, which begins each in small steps; DOP853 takes shorter ones
)
MOST_EVALUATIONS = 200  # of DOP853 in such a segment; LSODA integrates longer ones
LEAST_RTOL = 2.3e-14  # SciPy allows no smaller one
FIRST_LOOK = 20_000  # steps before the pace of a run is measured
OUT_OF_REACH = 1e9  # steps, a day of computing
SMALLEST = 2.0**-12  # part of a step that is searched for the edge of a guard
MARGIN_ROUNDING = 1e-12
_lsoda = threading.RLock()  # not every SciPy runs two of them at once
_inside = threading.local()  # `lsoda` is True while this thread runs one


class NotIntegrated(Exception):
    """A run that a method cannot continue; the arguments are time, state and `Status`."""


class PythonDiagram(Runner):
    """A diagram that runs block by block in Python."""

    engine = "python"
    most = 10_000_000

    def parameters(self) -> ndarray:
        """Return P, which says which blocks jump."""
        return np.zeros(len(self.layout.jumps))

    def solve(
        self, start: ndarray, times: ndarray, inputs: Inputs, options: RunOptions
    ) -> Solution:
        """Integrate by SciPy, or step a diagram of discrete time."""
        if self.resetting:
            raise SimulationError(
                f"{', '.join(self.resetting)}: jumps at a level run as machine code alone, "
                "and this diagram runs in Python. Write its functions in NumPy"
            )
        if not self.nstates:
            return without_states(self.sweep, times, inputs, self.engine)
        if self.wiring.dt:
            return in_discrete_time(self.sweep, start, times, inputs, options.progress)
        may_be_stiff = options.method == "auto" or METHODS[options.method].implicit
        if may_be_stiff and not getattr(_inside, "lsoda", False):
            try:
                with _lsoda, warnings.catch_warnings():
                    warnings.filterwarnings("ignore", "lsoda")
                    _inside.lsoda = True
                    run = PythonRun(self, times, inputs, options, LSODA)
                    return run.solution(start)
            except NotIntegrated:
                pass  # DOP853 rejects steps with such rates
            finally:
                _inside.lsoda = False
        run = PythonRun(self, times, inputs, options, DOP853)
        try:
            return run.solution(start)
        except NotIntegrated as error:
            raise run.error(*error.args) from None

    def evaluate(self, solution: Solution, inputs: Inputs) -> ndarray:
        """Return all block outputs at a solution's times, finite or not."""
        rows = np.empty((len(solution.t), self.nsignals))
        run = solution.t[-1] - solution.t[0]
        for k, (t, x) in enumerate(zip(solution.t, solution.x, strict=True)):
            self.sweep.enter(t + rounding(t, run))
            self.sweep.evaluate(t, x, inputs.at(t))
            rows[k] = self.sweep.signals
        return rows


class PythonRun:
    """One run of a diagram by one method of SciPy."""

    def __init__(
        self, diagram: Any, times: ndarray, inputs: Inputs, options: Any, method: Any
    ):
        self.sweep, self.times, self.inputs = diagram.sweep, times, inputs
        self.schedule = diagram.schedule(times, inputs, BEND * options.rtol)
        self.method, self.options = method, options
        self.run = times[-1] - times[0]
        self.remembers = bool(diagram.hidden_state)
        self.short = method is LSODA and len(self.schedule.edges) > MOST_SEGMENTS
        self.most = diagram.most
        self.next_look, self.look_time = FIRST_LOOK, times[0]
        self.watched = time.perf_counter()
        self.states = np.full((len(times), diagram.nstates), np.nan)
        self.written = 0  # samples
        self.end: tuple[float, ndarray] | None = None  # where a guard is left
        self.strict = True  # a rate that is not finite ends the run
        for k in self.sweep.jumping:  # errors of earlier runs
            self.sweep.nodes[k].system.raised.pop("jump", None)
        self.steps = self.evaluations = self.restarts = 0

    def solution(self, start: ndarray) -> Solution:
        """Integrate all segments; return the solution up to the end or a guard."""
        edges = self.schedule.edges
        begins = [self.times[0], *edges[:-1]]
        x = start.copy()
        for k, t in enumerate(begins):
            self.sweep.enter(t + rounding(t, self.run))
            x = self._jumped(k, t, x)
            self._write(t, x)
            if self.sweep.guarded and not self._margin(t, x) >= 0.0:
                self.end = t, x
            elif k < len(begins) - 1:
                x = self._segment(t, x, edges[k])
            if self.end is not None:
                break
        solution = Solution(
            self.times,
            self.states,
            statistics={
                "steps": self.steps,
                "evaluations": self.evaluations,
                "restarts": self.restarts,
            },
            method=(DOP853 if self.short else self.method).__name__,
        )
        if self.end is None:
            return solution
        return stopped_between(self.sweep, solution, *self.end, self.inputs)

    def _rates(self, t: float, x: ndarray) -> ndarray:
        self.evaluations += 1
        rates = self.sweep.derivative(t, x, self.inputs.at(t))
        if self.strict and not np.isfinite(rates).all():
            raise NotIntegrated(t, x.copy(), Status.NOT_FINITE)
        self.strict = self.method is not DOP853
        return rates

    def _jumped(self, k: int, t: float, x: ndarray) -> ndarray:
        """Return the state after the jumps with which a segment begins."""
        requests = self.schedule.values[k]
        blocks = np.array(self.sweep.jumping)
        jumping, sampling = (
            blocks[requests == kind].tolist() for kind in (JUMPS, BEGINS)
        )
        if not jumping and not sampling:
            return x
        x = self.sweep.jump(t, x, self.inputs.at(t), jumping, sampling)
        if not np.isfinite(x).all():
            raise self.error(t, x, Status.NOT_FINITE)
        return x

    def _segment(self, t: float, x: ndarray, end: float) -> ndarray:
        """Return the state at the end of a segment that begins at t."""
        if not np.isfinite(x).all():
            raise NotIntegrated(t, x, Status.NOT_FINITE)
        begun = self.evaluations
        self.strict = True
        solver = self._solver(DOP853 if self.short else self.method, t, x, end)
        self.restarts += 1
        while solver.status == "running" and self.end is None:
            before = solver.t
            solver.step()
            self.steps += 1
            if solver.status == "failed":
                raise NotIntegrated(solver.t, solver.y.copy(), Status.STEP_TOO_SMALL)
            if self.steps >= self.next_look and self._is_out_of_reach(solver.t, end):
                raise self.error(solver.t, solver.y, Status.TOO_MANY_STEPS)
            if self.sweep.guarded:
                self._stop_at_guard(before, solver)
            reached = solver.t if self.end is None else self.end[0]
            self._write(reached, solver.y, solver)
            if time.perf_counter() - self.watched > PAUSE:
                check()
                if self.options.progress is not None:
                    self.options.progress(solver.t)
                self.watched = time.perf_counter()
            is_long = self.short and self.evaluations - begun > MOST_EVALUATIONS
            if is_long and solver.status == "running":
                self.short = False
                solver = self._solver(LSODA, solver.t, solver.y, end)
        return solver.y.copy()

    def _is_out_of_reach(self, t: float, end: float) -> bool:
        """Return whether the end of a segment needs a day of steps; measured as steps double."""
        advance = t - self.look_time
        self.look_time, self.next_look = t, min(2 * self.steps, self.most)
        needed = 0.5 * self.steps * (end - t)
        return self.steps >= self.most or needed > OUT_OF_REACH * advance

    def _solver(self, method: Any, t: float, x: ndarray, end: float) -> Any:
        """Return a solver of SciPy from one time to another."""
        options = self.options
        share = 1.0 if self.method is DOP853 or self.remembers else SHARE
        first = 0.0 if self.restarts else options.first_step
        return method(
            self._rates,
            t,
            x,
            end,
            rtol=max(share * options.rtol, LEAST_RTOL),
            atol=share * options.atol,
            max_step=min(options.max_step, self.run / PARTS),
            first_step=min(first, end - t) or None,
        )

    def _write(self, reached: float, x: ndarray, solver: Any = None) -> None:
        """Write the states at samples up to a time; a sample at a jump is after the jump."""
        k = self.written
        if solver is None and k and self.times[k - 1] == reached:
            k -= 1
        last = int(np.searchsorted(self.times, reached, side="right"))
        if last == k:
            return
        times = self.times[k:last]
        self.states[k:last] = x
        if solver is not None and times[0] < solver.t:
            inner = times < solver.t
            self.states[k:last][inner] = solver.dense_output()(times[inner]).T
        self.written = last

    # --- guards -----------------------------------------------------------------------------

    def _margin(self, t: float, x: ndarray) -> float:
        return np.min(self.sweep.distances(t, x, self.inputs.at(t)))

    @np.errstate(all="ignore")
    def _stop_at_guard(self, before: float, solver: Any) -> None:
        """Set the end of the run to the first time of a step at which a guard is left."""
        within = solver.dense_output()
        least = SMALLEST * (solver.t - before)
        parts = [(before, solver.t)]  # the next one last
        while parts:
            low, high = parts.pop()
            times = low + (high - low) * np.array(SHARES)
            margins = np.array([self._margin(t, within(t)) for t in times])
            outside = int(np.argmin(margins >= 0.0))
            points = np.zeros((len(SHARES), 3, 1))
            points[:, DISTANCE, 0] = margins
            points[:, ROUNDING] = MARGIN_ROUNDING * np.abs(margins).max()
            hides = may_hide(points, 1, (outside or len(SHARES)) - 1, high, high - low)
            if hides and high - low > least:
                middle = 0.5 * (low + high)
                parts += [(middle, high), (low, middle)]
            elif outside:
                low, high = times[outside - 1 : outside + 1]
                end = edge(lambda t: self._margin(t, within(t)), low, high)
                self.end = end, within(end)
                return

    # --- errors -----------------------------------------------------------------------------

    def error(self, t: float, x: ndarray, status: Status) -> SimulationError:
        """Return an error that names block and signal, if a value is not finite."""
        rates = self.sweep.derivative(t, x, self.inputs.at(t))
        points = points_ahead(t, x, rates, self.times[-1] - t)
        trouble = trouble_at(self.sweep, points, self.inputs, f"{ADVICE}{LOOSEN}")
        reason = trouble or status.sentence
        error = SimulationError(f"the integration stopped at t = {t:.9g}: {reason}")
        error.status, error.states = status, self.states[: self.written]
        return error
