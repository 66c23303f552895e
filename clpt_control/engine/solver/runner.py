"""A diagram that runs block by block in Python.

The solver is machine code, as for any diagram; it calls functions of Python.

In discrete time x[k+1] = derivative(t_k, x[k], u_k), and the signals of sample k are those of x[k].
The times are those that python-control takes: `dt` apart, or evenly spaced if dt is True.
"""

from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from copy import copy
from ctypes import c_void_p, cast
from dataclasses import replace
from functools import partial
from typing import Any, Self

import control
import numpy as np

from ...arguments import numbers
from ...errors import SimulationError
from ..codegen.machine import callback
from ..diagram.interconnection import changed_parameters
from ..diagram.wiring import Wiring, read_anew, wiring_of
from .batch import ANY, Batch, Callee, pace
from .evaluation_pass import Sweep, rounding
from .filippov import continue_on_switch
from .integrators import with_formulas
from .jacobian import Jacobian, jacobian
from .schedule import (
    BEGINS,
    JUMPS,
    Inputs,
    Schedule,
    TimeTable,
    checked_state,
    checked_times,
    make_schedule,
    read_inputs,
)
from .solver_layout import DOP853, MAP, RK4, RODAS5P, SIGNALS, Status
from .termination import (
    NAMES,
    STUCK,
    Solution,
    ended,
    in_discrete_time,
    sampled_start,
    without_states,
)

FELT = 200.0  # tolerances of an input: a run stops where it bends off its line by more


class PythonDiagram:
    """A diagram ready to run, block by block in Python.

    `sweep` evaluates it, `wiring` holds its blocks; states and signals are counted in
    `nstates` and `nsignals`.
    """

    engine = "python"
    most = 10_000_000  # tries of a run
    ramp = -1  # place in P of the diagram's inputs, where they are read from there

    def __init__(
        self, diagram: control.NonlinearIOSystem | Wiring, params: Mapping[str, Any] | None = None
    ):
        if not isinstance(diagram, Wiring):
            read_anew(diagram)
        self.wiring = diagram if isinstance(diagram, Wiring) else wiring_of(diagram, params)
        self.sweep = Sweep(self.wiring, changed_parameters(self.wiring.blocks, params))
        self.nstates, self.nsignals = self.sweep.nstates, len(self.sweep.signals)
        self.intervals: dict[int, int] = {}  # places in P of each block's `interval`
        self.jumps = {k: place for place, k in enumerate(self.sweep.jumping)}  # 1 where it jumps
        self.time_tables: list[TimeTable] = []  # of machine code

    def __repr__(self) -> str:
        count = f"{len(self.wiring.nodes)} blocks, {self.nstates} states"
        return f"<{type(self).__name__}: {count}, {self.nsignals} signals>"

    def with_parameters(self, parameters: Sequence[Any]) -> Self:
        """Return the diagram with other parameters of its blocks."""
        other = copy(self)
        other.sweep = Sweep(self.wiring, parameters)
        return other

    # --- what machine code overrides ------------------------------------------------------

    def parameters(self) -> np.ndarray:
        """Return P; in Python it says which blocks jump."""
        return np.zeros(len(self.jumps))

    schedule = make_schedule

    def callee(self, lanes: int = 1, inputs: Inputs | None = None, method: int = DOP853) -> Callee:
        """Return what the solver calls, for one of its methods."""
        n, sweep, raised = self.nstates, self.sweep, list[BaseException]()
        u: Any = (lambda t: None) if inputs is None else inputs.at

        def jump(t: float, x: np.ndarray, P: np.ndarray) -> np.ndarray:
            jumping, beginning = (
                [k for k, place in self.jumps.items() if P[place] == how] for how in (JUMPS, BEGINS)
            )
            return sweep.jump(t, x, u(t), jumping, beginning)

        functions: list[tuple[Any, str, int]] = [  # in the solver's order, and what they write
            (lambda t, x, P: sweep.rates(t, x, u(t)), "D", n),
            (lambda t, x, P: sweep.enter(t + rounding(t)), "D", 0),
            (lambda t, x, P: sweep.margin(t, x, u(t))[0], "D", 1),
            (lambda t, x, P: sweep.evaluate(t, x, u(t)), "W", self.nsignals),
            (jump, "D", n),
        ]
        places = len(self.jumps)
        own = [callback(one, n, places, array, count, raised) for one, array, count in functions]
        addresses = [*(cast(one, c_void_p).value for one in own), 0]
        full = np.ones((n, n + 1), dtype=bool)
        linear = jacobian(full) if method == RODAS5P else Jacobian()
        sizes = places, self.nsignals, np.zeros(1)
        straight = inputs is None or inputs.bends_sharply_only
        shape = 1, n, method, *self.watched(method), 0, 0, 1 if straight else 2
        return with_formulas(
            Callee("python", addresses, *shape, *sizes, linear, code=(own,), raised=raised)
        )

    def watched(self, method: int) -> tuple[int, int]:
        """Return 1 if guards are watched, and 1 if states jump; neither in discrete time."""
        if method == MAP:
            return 0, 0
        return int(self.sweep.guarded), int(bool(self.jumps))

    def implicit(self, inputs: Inputs | None = None) -> Callee:
        """Return what the solver calls for its implicit method."""
        return self.callee(1, inputs, RODAS5P)

    # --- runs -----------------------------------------------------------------------------

    def run(
        self,
        x0: Sequence[float] | np.ndarray,
        times: Sequence[float] | np.ndarray,
        *,
        rtol: float | None = None,
        atol: float | None = None,
        inputs: Any = None,
        progress: Callable[[float], None] | None = None,
        step: float | None = None,
        method: str | None = None,
        max_step: float = np.inf,
        first_step: float | None = None,
    ) -> Solution:
        """Integrate from the first to the last of the times.

        Parameters
        ----------
        x0 : array_like, shape (nstates,)
            State at ``times[0]``.
        times : array_like, shape (n,)
            Increasing times at which states are returned.
        rtol, atol : float, optional
            Tolerances on the local error of each state; 1e-8 and 1e-10.
        inputs : optional
            Inputs of the diagram, as `simulate` takes them; zero without.
        progress : callable, optional
            Called with the time reached, several times a second.
        step : float, optional
            A fixed step: Runge and Kutta's classical method of order 4 in
            place of DOP853, without tolerances and progress; steps end at
            every breakpoint and sample.
        method : str, optional
            ``"dop853"``, explicit, of order 8; ``"rodas5p"``, for stiff equations, of order 5; or
            ``"auto"``, as without: DOP853, and Rodas5P from where the equations are stiff.
        max_step, first_step : float, optional
            The longest step, and the first that is tried.

        Returns
        -------
        Solution
            States ``x`` at the times ``t``, with status, message and statistics.

        Raises
        ------
        SimulationError
            If a signal is not finite (block, signal and time are named), the
            step becomes too small, the end is out of reach, or a guard with
            the policy ``"raise"`` is crossed.
        """
        options: dict[str, Any] = {
            **{"step": step, "max_step": None if max_step == np.inf else max_step},
            **{"first_step": first_step, "method": method, "rtol": rtol, "atol": atol},
            "progress": progress,
        }
        times, start = checked_times("times", times), checked_state("x0", x0, (self.nstates,))
        rtol, atol, *limits, method = checked_steps(self.wiring.dt, times, **options)
        t0, t1 = float(times[0]), float(times[-1])
        inputs = self._inputs(inputs, times)
        if not self.nstates:
            return without_states(self.sweep, times, inputs, self.engine)
        if self.wiring.dt and self.engine == "python":
            return in_discrete_time(self.sweep, start, times, inputs, progress)
        by, auto = self.method_number(method, step), method == "auto" and step is None
        pieces = self.schedule(times, inputs, FELT * rtol)
        callee, P = self.callee(1, inputs, by), self.parameters()
        start = sampled_start(callee, start, t0, pieces, P)
        most = self.most if by > RK4 else ANY

        def begun(of: Any, P: Any, start: Any, times: np.ndarray, pieces: Schedule) -> Batch:
            callee, rows = of.callee(1, inputs, by), (start[None], P[None], times, [pieces], None)
            return Batch(callee, *rows, *limits)

        def run(batch: Batch, of: Any) -> Batch:
            implicit = partial(of.implicit, inputs) if auto else None
            watch = pace(most, batch.times[0], t1, progress)
            batch.adaptive(rtol, atol, watch, most, implicit)
            return batch

        batch, slow = begun(self, P, start, times, pieces), None
        try:
            run(batch, self)
            if batch.status[0] == Status.CHATTERING:
                continue_on_switch(self, batch, lambda of, *part: run(begun(of, *part), of))
        except SimulationError as error:
            slow = error
        if callee.decided and (slow or batch.status[0] in STUCK):
            with suppress(SimulationError):  # then the error is that of the first run
                across = self.unlocked().run(x0, times, inputs=inputs, **options)
                return replace(across, method=f"{across.method}, switches not located")
        if slow:
            raise slow
        solution = ended(self.sweep, batch, inputs)
        solution.pieces = pieces
        return solution

    def method_number(self, method: str = "auto", step: float | None = None) -> int:
        """Return the solver's number of a method."""
        if self.wiring.dt:
            return MAP
        return METHODS[method] if step is None else RK4

    def unlocked(self) -> Self:
        """Return the diagram with decisions that change within a step.

        A root of a state that comes to rest at zero, -sqrt(max(x, 0)), or that begins there,
        sqrt(|x|), has no value beyond the switch, so steps with a locked decision cannot cross it.
        """
        return self

    def run_many(
        self,
        starts: Sequence[Any] | np.ndarray,
        times: Sequence[float] | np.ndarray,
        *,
        rtol: float | None = None,
        atol: float | None = None,
        step: float | None = None,
    ) -> np.ndarray:
        """Integrate from many initial states, such as passive particles.

        Parameters
        ----------
        starts : array_like, shape (m, nstates)
            Initial states at ``times[0]``.
        times, rtol, atol, step
            As for `run`.

        Returns
        -------
        ndarray, shape (m, n, nstates)
            NaN from where a run could not go on.
        """
        times = checked_times("times", times)
        options = {"step": step, "rtol": rtol, "atol": atol}
        rtol, atol, longest, *_ = checked_steps(self.wiring.dt, times, **options)
        starts = checked_state("starts", starts, (len(starts), self.nstates))
        P, by = self.parameters(), self.method_number(step=step)
        pieces = self.schedule(times)
        starts = [sampled_start(self.callee(), one, float(times[0]), pieces, P) for one in starts]
        callee, every = self.callee(self.lanes(len(starts)), None, by), np.tile(P, (len(starts), 1))
        batch = Batch(callee, np.array(starts), every, times, [pieces], None, longest)
        batch.adaptive(rtol, atol)
        return batch.out

    def lanes(self, count: int) -> int:
        """Return how many of `count` runs are taken at once."""
        return 1

    def _inputs(self, inputs: Any, times: np.ndarray) -> Inputs | None:
        return None if inputs is None else read_inputs(inputs, times, self.wiring.ninputs)

    def signals(self, solution: Solution, inputs: Any = None) -> np.ndarray:
        """Return all block outputs (nt, nsignals) at a solution's times, in the wiring's order.

        Values at a jump are right limits; one that is not finite is an error.
        """
        times = solution.t
        if not len(times):  # stopped before the first
            return np.zeros((0, self.nsignals))
        inputs = self._inputs(inputs, times)
        out = self.evaluated_signals(solution, inputs)
        if not np.isfinite(out).all():
            bad = np.flatnonzero(~np.isfinite(out).all(axis=1))
            t, x = float(times[bad[0]]), solution.x[bad[0], : self.sweep.nstates]
            self.sweep.enter(t)
            advice = "check the parameters of that block, or keep its arguments in range"
            u = None if inputs is None else inputs.at(t)
            trouble = self.sweep.first_trouble(t, x, u, advice)
            trouble = trouble or f"a signal is not finite; {advice}"
            raise SimulationError(f"at t = {t:.9g}: {trouble}")
        return out

    def evaluated_signals(self, solution: Solution, inputs: Inputs | None) -> np.ndarray:
        """Return all block outputs at a solution's times, finite or not."""
        if solution.signals is not None:
            return solution.signals
        at = solution.t, solution.x, self.pieces(solution, inputs), self.parameters()
        return self.callee(1, inputs).evaluate(SIGNALS, *at, self.nsignals)

    def pieces(self, solution: Solution, inputs: Inputs | None) -> Schedule:
        """Return the pieces of time of a run."""
        if solution.pieces is None or solution.engine != self.engine:
            return self.schedule(solution.t, inputs)
        return solution.pieces


ADAPTIVE = {name.lower(): k for k, name in NAMES.items() if k > RK4}
METHODS = {"auto": DOP853, **ADAPTIVE}
# the least that an option may be
LEAST = {"rtol": 0.0, "atol": 0.0, **dict.fromkeys(("step", "max_step", "first_step"), 5e-324)}


def checked_method(method: str | None) -> str:
    """Return the name of a method; refuse an unknown one."""
    if method is not None and method not in METHODS:
        raise SimulationError(f"method = {method!r}: must be one of {', '.join(METHODS)}")
    return method or "auto"


def check_spacing(times: np.ndarray, dt: Any) -> None:
    """Refuse times that are not spaced by the step of a diagram of discrete time."""
    apart = times[1:] - times[:-1]
    step = apart[0] if dt is True else dt
    if (np.abs(apart - step) > 1e-8 + 1e-5 * step).any():
        every = "evenly spaced" if dt is True else f"{dt:.9g} apart"
        raise SimulationError(
            f"timepts: a diagram of discrete time (dt = {dt}) takes times that are {every}; these "
            f"are {apart.min():.9g} to {apart.max():.9g} apart"
        )


def checked_steps(dt: Any, times: np.ndarray, **options: Any) -> tuple:
    """Return rtol and atol, the longest step, the first or 0, and the method of a run.

    Refuse values out of range, and options that do not go with a fixed step or discrete time.
    """
    given = {name: value for name, value in options.items() if value is not None}
    method, fixed = checked_method(given.get("method")), given.keys() & {"step"}
    if dt:
        check_spacing(times, dt)
    if dt or fixed:
        what = "a diagram of discrete time" if dt else "a fixed step"
        others = given.keys() - ({"progress", "method"} if dt and method == "auto" else fixed)
        if others:
            raise SimulationError(f"{', '.join(sorted(others))}: {what} has none; leave it out")
    for name, least in ((name, least) for name, least in LEAST.items() if name in given):
        size = numbers(name, given[name])
        if size.ndim or not size >= least:
            allowed = "above 0" if least else "0 or more"
            raise SimulationError(f"{name} = {given[name]}: must be a number, {allowed}")
    chosen = {"rtol": 1e-8, "atol": 1e-10, "first_step": 0.0, "max_step": given.get("step", np.inf)}
    chosen |= given
    if chosen["rtol"] == chosen["atol"] == 0.0:
        raise SimulationError("rtol = atol = 0: one of them must be above 0")
    return *(float(chosen[name]) for name in ("rtol", "atol", "max_step", "first_step")), method
