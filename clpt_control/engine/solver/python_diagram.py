"""A diagram that runs in Python: its functions as callbacks, which the solver calls by address.

The solver passes the addresses of time, states X, parameters P, tables T, signals W and results D.
P has the `interval` and the requests of jumps of each block, and the straight lines of the inputs.
The first exception of a function is kept, and raised when the solver has returned.
"""

import sys
import threading
from collections.abc import Callable, Sequence
from copy import copy
from ctypes import CFUNCTYPE, c_double, c_void_p, cast
from dataclasses import replace
from functools import partial
from typing import Any, Self

import control
import numpy as np
from numpy import ndarray

from ..codegen.diagram_record import Layout
from ..codegen.plan import Program
from ..diagram.wiring import Wiring
from .batch import PARTS
from .callee import FUNCTIONS, Callee
from .evaluation_pass import Sweep
from .inputs import Inputs
from .jacobian_pattern import linear_of
from .lsoda import TIMES
from .runner import Runner, RunOptions
from .schedule import BEGINS, JUMPS, Schedule
from .solver_layout import DERIVATIVE, Linear
from .termination import Solution

FUNCTION = CFUNCTYPE(None, *[c_void_p] * 6)
ROUNDING = 1e-12  # of the operands of a distance, and of samples of inputs
CHANGE = 1e-6  # of states, relative, by which the size of operands is found


class PythonCode:
    """Functions of a diagram as callbacks.

    Attributes
    ----------
    program : Program
        Sizes of arrays, and facts that the solver reads.
    error : BaseException or None
        The first exception of a function; no function is called after it.
    rounding : ndarray
        Rounding errors of the distances of guards.
    rows : list of ndarray
        Signals at each evaluation of the rates, if time is discrete.
    """

    def __init__(self, sweep: Sweep, layout: Layout):
        self.sweep, self.layout = sweep, layout
        sizes = layout.inputs(sweep.wiring.ninputs) + 2, len(sweep.signals), 0
        self.program = Program((), {}, {}, (), *sizes, (), guarded=len(sweep.guarded))
        self.error: BaseException | None = None
        self.rows: list[ndarray] = []
        self._callbacks = {
            name: FUNCTION(partial(self._call, getattr(self, name)))
            for name in FUNCTIONS
        }

    def addresses(self, names: Sequence[str], lanes: int) -> list[Any]:
        """Return the addresses of functions."""
        return [cast(self._callbacks[name], c_void_p).value for name in names]

    def sparsity(self) -> Linear:
        """Return the sparsity of df/dx: a full matrix."""
        return linear_of(np.ones((self.sweep.nstates, self.sweep.nstates + 1), bool))

    def at(self, t: float, x: ndarray, P: ndarray) -> Any:
        """Return time, states and inputs; enter the intervals that P has."""
        for k, place in self.layout.intervals.items():
            self.sweep.enter_interval(k, P[place])
        begin, *lines = P[len(self.layout.P) : -2]
        values, slopes = np.reshape(lines, (2, -1))
        return t, x, values + (t - begin) * slopes

    def _call(self, function: Callable, t: int, X: int, P: int, T: int, W: int, D: int):
        """Call a function, and write its results into D, signals into W."""
        if self.error is not None:
            return
        try:
            numbers = numbers_at(P, self.program.parameters)
            time, x = c_double.from_address(t).value, numbers_at(X, self.sweep.nstates)
            results = function(self.at(time, x, numbers), numbers)
            to = W if results is self.sweep.signals else D
            numbers_at(to, len(results))[:] = results
        except BaseException as error:
            self.error = error

    # --- functions of time, states and inputs, and of P -----------------------------------

    def derivative(self, at: Any, P: ndarray) -> ndarray:
        """Return dx/dt, in discrete time the next states."""
        rates = self.sweep.derivative(*at)
        if self.sweep.wiring.dt:
            self.rows.append(self.sweep.signals.copy())
        return rates

    @np.errstate(all="ignore")
    def prepare(self, at: Any, P: ndarray) -> tuple[()]:
        """Find the rounding errors of distances: a change of the states shows their operands."""
        if self.sweep.guarded:
            t, x, u = at
            changed = x + CHANGE * np.linspace(0.7, 1.0, len(x)) * x
            now = np.array(self.sweep.distances(*at))
            changes = now - self.sweep.distances(t, changed, u)
            self.rounding = ROUNDING * (np.abs(now) + np.abs(changes) / CHANGE)
        return ()

    def signals(self, at: Any, P: ndarray) -> ndarray:
        """Return all block outputs."""
        return self.sweep.evaluate(*at)

    def jump(self, at: Any, P: ndarray) -> ndarray:
        """Return the states after the jumps that P requests."""
        (t, x, u), places = at, self.layout.jumps.items()
        jumping = [k for k, place in places if P[place] == JUMPS]
        beginning = [k for k, place in places if P[place] == BEGINS]
        return self.sweep.jump(t, x, u, jumping, beginning)

    def decide(self, at: Any, P: ndarray) -> ndarray:
        """Return the distances of guards in place of decisions, again, and their rounding."""
        distances = self.sweep.distances(*at)
        return np.concatenate([distances, distances, self.rounding])

    def keep(self, problem: Any) -> None:
        """Keep an exception that ctypes drops, before the first line of a callback: Ctrl-C."""
        if "ctypes" in (problem.err_msg or ""):
            self.error = self.error or problem.exc_value
        else:
            sys.__unraisablehook__(problem)


def numbers_at(address: int, count: int) -> ndarray:
    """Return an array of the numbers at an address."""
    buffer: Any = (c_double * count).from_address(address or 0)
    return np.ndarray(count, float, buffer)


class PythonCallee(Callee):
    """Functions of a `PythonDiagram` that the solver calls."""

    tries = 16  # of a call of the solver; then it looks for stiffness

    def call(self, name: str, numbers: ndarray) -> int:
        """Call a function of the solver; raise the first exception of a function."""
        code, hook = self.code, sys.unraisablehook
        code.error = None
        is_main = threading.current_thread() is threading.main_thread()
        try:
            if is_main:
                sys.unraisablehook = code.keep
            return super().call(name, numbers)
        finally:
            if is_main:
                sys.unraisablehook = hook
            if code.error is not None:
                raise code.error


class PythonDiagram(Runner):
    """A diagram that runs block by block in Python."""

    engine = "python"
    most = 1_000_000
    callee_type = PythonCallee
    slack = ROUNDING

    def __init__(self, diagram: control.NonlinearIOSystem | Wiring):
        super().__init__(diagram)
        self._lay_out()

    def _lay_out(self) -> None:
        sweep = self.sweep
        intervals = {k: place for place, k in enumerate(sweep.with_intervals)}
        jumps = {k: place for place, k in enumerate(sweep.jumping, len(intervals))}
        P = np.zeros(len(intervals) + len(jumps))
        self.layout = Layout({}, intervals, jumps, P=P)
        self.code, self.callees = PythonCode(sweep, self.layout), {}

    def with_parameters(self, parameters: Sequence[Any]) -> Self:
        """Return the diagram with other parameters of its blocks."""
        diagram = super().with_parameters(parameters)
        diagram._lay_out()
        return diagram

    def segments_of(self, solution: Solution, inputs: Inputs) -> Schedule:
        """Return the segments of time of a run, with inputs equal to those given to the bit."""
        exact = copy(self)
        exact.slack = 0.0
        return exact.schedule(solution.t, inputs)

    def solve(
        self, start: ndarray, times: ndarray, inputs: Inputs, options: RunOptions
    ) -> Solution:
        """Integrate; in discrete time keep the signals that were computed beside the updates.

        A function may read what another one wrote.  DOP853 evaluates the rates at several times of
        a step: none is longer than `TIMES` / `PARTS` of the run.
        """
        longest = (times[-1] - times[0]) * TIMES / PARTS
        options = replace(options, max_step=min(longest, options.max_step))
        self.code.rows = []
        solution = super().solve(start, times, inputs, options)
        if self.nstates and self.wiring.dt:
            last = solution.t[-1:], solution.x[-1:], self.segments_of(solution, inputs)
            self.callee().evaluate(DERIVATIVE, *last, self.parameters())
            solution.signals = np.array(self.code.rows)
        return solution
