"""A diagram that runs block by block in Python.

The solver is machine code, as for any diagram; it calls functions of Python.
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

from ..diagrams.interconnection import changed_parameters
from ..diagrams.wiring import Wiring, read_anew, wiring_of
from ..errors import SimulationError
from . import solver
from .batch import ANY, Batch, Callee, pace
from .ending import (
    METHODS,
    STUCK,
    Solution,
    check_spacing,
    checked_method,
    ended,
    run_to_end,
    sampled_start,
    without_states,
)
from .jacobian import Jacobian, jacobian
from .machine import callback
from .method import kernels
from .schedule import (
    BEGINS,
    FELT,
    FELT_BY_ORDER_5,
    JUMPS,
    Inputs,
    Schedule,
    checked_state,
    checked_times,
    make_schedule,
    numbers,
    read_inputs,
    sharp_bends,
    with_inputs,
)
from .sweep import Sweep


class PythonDiagram:
    """A diagram ready to run, block by block in Python.

    `sweep` evaluates it, `wiring` holds its blocks; states and signals are counted in
    `nstates` and `nsignals`.
    """

    engine = "python"
    most = 10_000_000  # tries of a run
    loose = 1e-6  # from that rtol on order 5 takes fewer evaluations, which are what a run costs
    ramp = -1  # place in P of the diagram's inputs, where they are read from there

    def __init__(
        self, diagram: control.NonlinearIOSystem | Wiring, params: Mapping[str, Any] | None = None
    ):
        if not isinstance(diagram, Wiring):
            read_anew(diagram)
        self.wiring = diagram if isinstance(diagram, Wiring) else wiring_of(diagram, params)
        self.sweep = Sweep(self.wiring, changed_parameters(self.wiring, params))
        self.nstates, self.nsignals = self.sweep.nstates, len(self.sweep.signals)
        self.intervals: dict[int, int] = {}  # places in P of each block's `interval`
        self.jumps = {k: place for place, k in enumerate(self.sweep.jumping)}  # 1 where it jumps

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

    def schedule(
        self,
        t0: float,
        t1: float,
        inputs: Inputs | None = None,
        breaks: Any = (),
        felt: float = 0.0,
    ) -> Schedule:
        """Return the pieces of a run; they end at `breaks` and at bends of inputs that are felt."""
        kinks = np.zeros(0)
        if inputs is not None and inputs.samples is not None:
            kinks = sharp_bends(*inputs.samples, felt) if self.ramp < 0 else inputs.kinks
        pieces = make_schedule(self.sweep, self.intervals, self.jumps, t0, t1, kinks, breaks)
        if self.ramp < 0 or inputs is None or not self.wiring.ninputs:
            return pieces
        return with_inputs(pieces, t0, inputs, self.ramp)

    def callee(
        self, lanes: int = 1, inputs: Inputs | None = None, method: int = solver.DOP853
    ) -> Callee:
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
            (lambda t, x, P: sweep.enter(t), "D", 0),
            (lambda t, x, P: sweep.margin(t, x, u(t))[0], "D", 1),
            (lambda t, x, P: sweep.evaluate(t, x, u(t)), "W", self.nsignals),
            (jump, "D", n),
        ]
        places = max(self.jumps.values(), default=-1) + 1
        own = [callback(one, n, places, array, count, raised) for one, array, count in functions]
        formulas = kernels(n, 1, method) if n else None
        more = formulas.addresses.values() if formulas else ()
        addresses = [*(cast(one, c_void_p).value for one in own), 0, 0, *more]
        watched = method != solver.MAP
        flags = int(watched and sweep.guarded), int(watched and bool(self.jumps))
        shape = 1, n, method, *flags, 0, 0
        sizes, linear = (len(self.jumps), self.nsignals, np.zeros(1)), Jacobian()
        if method == solver.RODAS5P:
            linear = jacobian(np.ones((n, n + 1), dtype=bool), False)
        code, alive = np.array(addresses, dtype=np.int64), (own, formulas)
        return Callee("python", code, *shape, *sizes, linear, alive, raised)

    def implicit(self, inputs: Inputs | None = None) -> Callee:
        """Return what the solver calls for its implicit method."""
        return self.callee(1, inputs, solver.RODAS5P)

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
            ``"dop853"``, explicit, of order 8; ``"dopri5"``, of order 5; ``"rodas5p"``, for stiff
            equations, of order 5; or ``"auto"``, as without: DOP853 (DOPRI5 in Python where rtol is
            1e-6 or more), and Rodas5P from where the equations are stiff.
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
        relative, absolute, longest, opening = checked_steps(
            step, rtol=rtol, atol=atol, max_step=None if max_step == np.inf else max_step,
            first_step=first_step, method=method, progress=progress,
        )  # fmt: skip
        method = checked_method(method)
        times, start = checked_times("times", times), checked_state("x0", x0, (self.nstates,))
        times = self.sweep.at_jumps(times)
        t0, t1 = float(times[0]), float(times[-1])
        inputs = self._inputs(inputs, times)
        if self.wiring.dt:
            limits = longest, opening, method
            if (step, rtol, atol) != (None, None, None) or limits != (np.inf, 0.0, "auto"):
                raise SimulationError(
                    "step, max_step, first_step, method, rtol and atol: a diagram of discrete time "
                    "has none; leave them out"
                )
            check_spacing(times, self.wiring.dt)
        if not self.nstates:
            return without_states(self.sweep, times, inputs, self.engine)
        by, auto = self.method_number(method, step), method == "auto" and step is None
        if by == solver.DOP853 and auto and relative >= self.loose:
            by = solver.DOPRI5
        felt = relative * (FELT_BY_ORDER_5 if by == solver.DOPRI5 else FELT)
        pieces = self.schedule(t0, t1, inputs, self.breaks(t0, t1), felt)
        callee, P = self.callee(1, inputs, by), self.parameters()
        start = sampled_start(callee, start, t0, pieces, P)
        batch = Batch(callee, start[None], P[None], times, [pieces], None, longest, opening)
        most = self.most if by > solver.RK4 else ANY
        implicit = partial(self.implicit, inputs) if auto else None
        rest = run_to_end(batch, relative, absolute, implicit, pace(most, t0, t1, progress), most)
        if batch.status[0] in STUCK and callee.decided:
            with suppress(SimulationError):  # then the error is that of the first run
                across = self.unlocked().run(
                    x0, times, rtol=rtol, atol=atol, method=method, inputs=inputs,
                    max_step=max_step, first_step=first_step, progress=progress,
                )  # fmt: skip
                return replace(across, method=f"{across.method}, switches not located")
        solution = ended(self.sweep, batch, inputs, rest.get(0))
        solution.pieces = self, inputs, pieces
        return solution

    def method_number(self, method: str = "auto", step: float | None = None) -> int:
        """Return the solver's number of a method."""
        if self.wiring.dt:
            return solver.MAP
        return METHODS[method] if step is None else solver.RK4

    def unlocked(self) -> Self:
        """Return the diagram with decisions that change within a step.

        A root of a state that comes to rest at zero, -sqrt(max(x, 0)), has no value beyond the
        switch, so steps with a locked decision cannot cross it.
        """
        return self

    def pieces_of(self, solution: Solution, inputs: Inputs | None) -> Schedule:
        """Return the pieces of time of a solution; they are made again for another diagram."""
        diagram, its_inputs, pieces = solution.pieces
        if diagram is self and its_inputs is inputs:
            return pieces
        return self.schedule(float(solution.t[0]), float(solution.t[-1]), inputs)

    def breaks(self, t0: float, t1: float) -> Any:
        """Return the times of decisions that depend on time alone; none in Python."""
        return ()

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
        rtol, atol, longest, _ = checked_steps(step, rtol=rtol, atol=atol)
        times = checked_times("times", times)
        starts = checked_state("starts", starts, (len(starts), self.nstates))
        if self.wiring.dt:
            check_spacing(times, self.wiring.dt)
        P, by = self.parameters(), self.method_number(step=step)
        pieces = self.schedule(float(times[0]), float(times[-1]))
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

    def signals(self, solution: Solution, inputs: Any = None, check: bool = True) -> np.ndarray:
        """Return all block outputs (nt, nsignals) at a solution's times, in the wiring's order.

        Values at a jump are right limits; with `check` one that is not finite is an error.
        """
        times = solution.t
        if not len(times):  # stopped before the first
            return np.zeros((0, self.nsignals))
        inputs = self._inputs(inputs, times)
        callee, pieces = self.callee(1, inputs), self.pieces_of(solution, inputs)
        P, out = self.parameters(), np.empty((len(times), self.nsignals))
        callee.evaluate(solver.SIGNALS, times, solution.x, pieces, P, out)
        return self.finite(solution, out, inputs) if check else out

    def finite(
        self, solution: Solution, signals: np.ndarray, inputs: Inputs | None = None
    ) -> np.ndarray:
        """Return a solution's signals; refuse one that is not finite."""
        bad = np.flatnonzero(~np.all(np.isfinite(signals), axis=1))
        if len(bad):
            t, x = float(solution.t[bad[0]]), solution.x[bad[0]]
            self.sweep.enter(t)
            advice = "check the parameters of that block, or keep its arguments in range"
            u = None if inputs is None else inputs.at(t)
            trouble = self.sweep.first_trouble(t, x, u, advice)
            trouble = trouble or f"a signal is not finite; {advice}"
            raise SimulationError(f"at t = {t:.9g}: {trouble}")
        return signals


ALONE = {  # why an option does not go with a fixed step
    **dict.fromkeys(("rtol", "atol"), "has no tolerance"),
    **dict.fromkeys(("max_step", "first_step"), "is what it is"),
    **{"method": "has a method", "progress": "reports none"},
}


def checked_steps(step: float | None, **options: Any) -> tuple[float, ...]:
    """Return rtol and atol, the longest step, and the first or 0.

    Refuse values out of range, and options that do not go with a fixed step.
    """
    for name, value in options.items():
        if step is not None and value is not None:
            raise SimulationError(f"step and {name}: a fixed step {ALONE[name]}; leave one out")
        if value is None or name in ("method", "progress"):
            continue
        size = np.float64(value) if type(value) is float else numbers(name, value)
        if name in ("rtol", "atol") and (size.ndim or not size >= 0.0):
            raise SimulationError(f"{name} = {value}: must be a number, 0 or more")
        if name in ("max_step", "first_step") and (size.ndim or not size > 0.0):
            raise SimulationError(f"{name} = {value}: must be a number above 0")
    chosen = {"rtol": 1e-8, "atol": 1e-10, "max_step": np.inf if step is None else step}
    chosen |= {"first_step": 0.0} | {name: v for name, v in options.items() if v is not None}
    if chosen["rtol"] == chosen["atol"] == 0.0:
        raise SimulationError("rtol = atol = 0: one of them must be above 0")
    return tuple(float(chosen[name]) for name in ("rtol", "atol", "max_step", "first_step"))
