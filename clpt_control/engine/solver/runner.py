"""A diagram that is ready to run, and the options of a run.

One solver runs two engines: functions of a `native_diagram.NativeDiagram` are machine code, those
of a `python_diagram.PythonDiagram` callbacks into Python.  `run` reads its arguments; `solve` and
`evaluate` take arrays that were read.

In discrete time x[k+1] = derivative(t_k, x[k], u_k), and the signals of sample k are those of x[k].
The times are those that python-control takes: `dt` apart, or evenly spaced if dt is True.
"""

from collections.abc import Callable, Sequence
from copy import copy
from dataclasses import dataclass
from functools import cached_property
from typing import Any, Self

import control
import numpy as np

from ...base.arguments import numbers, vector_of
from ...base.errors import SimulationError
from ..codegen.diagram_record import Layout
from ..diagram.wiring import Wiring, read_anew, wiring_of
from ..methods import DISCRETE, EXPLICIT, IMPLICIT, METHODS, Method
from .callee import Callee
from .evaluation_pass import Sweep
from .inputs import NO_INPUTS, Inputs, checked_times, read_inputs
from .legs import NativeRun
from .schedule import Schedule, make_schedule
from .solver_layout import JUMP, SIGNALS
from .termination import ADVICE, Solution, without_states


class Runner:
    """A diagram ready to run.

    Attributes
    ----------
    wiring : Wiring
        Its blocks.
    nstates, nsignals : int
        Numbers of states and signals.
    layout : Layout
        Places of parameters in P.
    code : Code or PythonCode
        Its functions.
    decided_at : int
        Offset in P of the decisions, behind the tolerances.
    callees : dict
        Callees by lanes and method, with arrays of earlier runs.
    """

    engine: str
    most: int  # tries of a run
    callee_type = Callee
    slack = 0.0  # of samples of inputs that are one straight line, relative
    comparisons = 0  # runs of machine code that were compared with Python
    hidden_state = ""  # a sentence on a function that has one
    layout: Layout
    code: Any
    callees: dict[Any, Any]

    def __init__(self, diagram: control.NonlinearIOSystem | Wiring):
        if isinstance(diagram, Wiring):
            self.wiring = diagram
        else:
            read_anew(diagram)
            self.wiring = wiring_of(diagram)
        self.block_parameters: Sequence[Any] = self.wiring.parameters()
        self.nstates = self.sweep.nstates
        self.nsignals = len(self.sweep.signals)
        self.breaking = self.sweep.breaking
        self.resetting = self.sweep.resetting

    def __repr__(self) -> str:
        count = f"{len(self.wiring.nodes)} blocks, {self.nstates} states"
        return f"<{type(self).__name__}: {count}, {self.nsignals} signals>"

    def with_parameters(self, parameters: Sequence[Any]) -> Self:
        """Return the diagram with other parameters of its blocks."""
        diagram = copy(self)
        diagram.block_parameters = parameters
        vars(diagram).pop("sweep", None)
        return diagram

    @cached_property
    def sweep(self) -> Sweep:
        """The pass over the diagram in Python; machine code alone does without."""
        return Sweep(self.wiring, self.block_parameters)

    @property
    def decided_at(self) -> int:
        """Offset in P of the decisions, behind the tolerances."""
        return self.layout.inputs(self.wiring.ninputs) + 2

    def parameters(self, of_run: np.ndarray | None = None) -> np.ndarray:
        """Return P, or that of a run in another form, with room for inputs and prepared numbers."""
        own = self.layout.P
        P = np.zeros(self.code.program.parameters)
        P[: len(own)] = own if of_run is None else of_run[: len(own)]
        return P

    # --- calls of the solver --------------------------------------------------------------

    schedule = make_schedule  # the segments of a run

    def solve(
        self,
        start: np.ndarray,
        times: np.ndarray,
        inputs: Inputs,
        options: "RunOptions",
    ) -> Solution:
        """Integrate from the first to the last of the times, as `run` does, without reading."""
        if not self.nstates:
            return without_states(self.sweep, times, inputs, self.engine)
        segments, P = self.schedule(times, inputs), self.parameters()
        if segments.begins:
            (start,) = self.callee().evaluate(JUMP, times[:1], start, segments, P)
        return NativeRun(self, start, P, times, segments, options).solution(inputs)

    def evaluate(self, solution: Solution, inputs: Inputs) -> np.ndarray:
        """Return all block outputs at a solution's times, finite or not."""
        points = solution.t, solution.x, self.segments_of(solution, inputs)
        return self.callee().evaluate(SIGNALS, *points, self.parameters())

    def segments_of(self, solution: Solution, inputs: Inputs) -> Schedule:
        """Return the segments of time of a run."""
        return solution.pieces or self.schedule(solution.t, inputs)

    def method_of(self, method: str) -> Method:
        """Return the method of a run."""
        return DISCRETE if self.wiring.dt else METHODS[method]

    def implicit(self) -> Callee:
        """Return what the solver calls for its implicit method."""
        return self.callee(1, IMPLICIT)

    def callee(self, lanes: int = 1, method: Method = EXPLICIT) -> Callee:
        """Return what the solver calls, for one of its methods.

        A diagram with events takes one run at a time: eight lanes are slower than one there.
        """
        if lanes > 1 and (self.sweep.guarded or self.code.program.decided):
            lanes = 1
        callee = self.callees.get((lanes, method))
        if callee is None:
            callee = self.callees[lanes, method] = self.callee_type(self, lanes, method)
        return callee

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
        method: str | None = None,
        max_step: float = np.inf,
        first_step: float | None = None,
    ) -> Solution:
        """Integrate from the first to the last of the times.

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
        method : str, optional
            As `simulate` takes it; ``"auto"`` without.
        max_step, first_step : float, optional
            The longest step, and the first that is tried.

        Solution
            States ``x`` at the times ``t``, with status, message and statistics.

        SimulationError
            If a signal is not finite (block, signal and time are named), the
            step becomes too small, the end is out of reach, or a guard with
            the policy ``"raise"`` is crossed.
        """
        times = checked_times("times", times)
        start = vector_of("x0", x0, self.nstates)
        options = RunOptions.checked(
            self.wiring.dt,
            times,
            rtol=rtol,
            atol=atol,
            max_step=max_step,
            first_step=first_step,
            method=method,
            progress=progress,
        )
        inputs = read_inputs(inputs, times, self.wiring.ninputs)
        return self.solve(start, times, inputs, options)

    def signals(self, solution: Solution, inputs: Inputs = NO_INPUTS) -> np.ndarray:
        """Return all block outputs (nt, nsignals) at a solution's times, in the wiring's order.

        Values at a jump are right limits; one that is not finite is an error.
        """
        times = solution.t
        if not len(times):  # stopped before the first
            return np.zeros((0, self.nsignals))
        signals = solution.signals
        if signals is None:
            signals = self.evaluate(solution, inputs)
        finite = np.isfinite(signals)
        if not finite.all():
            k = int(np.argmin(finite.all(axis=1)))
            x, t = solution.x[k, : self.sweep.nstates], float(times[k])
            self.sweep.enter(t)
            advice = f"{ADVICE}, or keep its arguments in range"
            trouble = self.sweep.first_trouble(t, x, inputs.at(t), advice)
            trouble = trouble or f"a signal is not finite; {advice}"
            raise SimulationError(f"at t = {t:.9g}: {trouble}")
        return signals


# --- options of a run -------------------------------------------------------------------------

# the least that an option may be, and what it must be below where there is no `max_step`
LEAST = {"rtol": 0.0, "atol": 0.0, "max_step": 5e-324, "first_step": 5e-324}
BELOW = {"rtol": (1.0, "below 1, or beside a max_step")}


@dataclass(frozen=True)
class RunOptions:
    """Options of a run.

    A `first_step` of 0 is chosen by the solver.
    """

    rtol: float = 1e-8
    atol: float = 1e-10
    max_step: float = np.inf
    first_step: float = 0.0
    method: str = "auto"
    progress: Callable[[float], None] | None = None

    @classmethod
    def checked(cls, dt: Any, times: np.ndarray, **options: Any) -> "RunOptions":
        """Return the options of a run, of which those that are None have their default.

        Refuse values out of range, and options that do not go with discrete time.
        """
        options = {name: value for name, value in options.items() if value is not None}
        if not options and not dt:
            return DEFAULT
        if options.get("max_step") == np.inf:
            del options["max_step"]
        checked_method(options.get("method"))
        if dt:
            check_spacing(times, dt)
            refused = options.keys() - {"progress"}
            if options.get("method") == "auto":
                refused -= {"method"}
            if refused:
                raise SimulationError(
                    f"{', '.join(sorted(refused))}: a diagram of discrete time has none. Leave it "
                    "out"
                )
        for name in LEAST.keys() & options:
            size = numbers(name, options[name])
            top, finite = BELOW.get(name, (np.inf, "finite"))
            if "max_step" in options:  # steps of one size
                top = np.inf
            if size.ndim or not LEAST[name] <= size < top:
                allowed = "above 0" if LEAST[name] else "0 or more"
                raise SimulationError(
                    f"{name} = {options[name]}: must be a number, {allowed} and {finite}"
                )
            options[name] = float(size)
        checked = cls(**options)
        if checked.rtol == checked.atol == 0.0:
            raise SimulationError("rtol = atol = 0: one of them must be above 0")
        return checked


DEFAULT = RunOptions()


def checked_method(method: str | None) -> str:
    """Return the name of a method; refuse an unknown one."""
    if method is not None and method not in METHODS:
        raise SimulationError(
            f"method = {method!r}: must be one of {', '.join(METHODS)}"
        )
    return method or "auto"


def steps_between(times: np.ndarray, dt: Any) -> np.ndarray | None:
    """Return the step of each time; None if all are one `dt` apart, or do not fit."""
    if not dt or dt is True:
        return None
    spacing = np.diff(times)
    counts = np.rint(spacing / dt)
    fitting = np.abs(spacing - counts * dt) <= 1e-8 + 1e-5 * dt
    if counts.min() < 1 or counts.max() == 1 or not fitting.all():
        return None
    return np.append(0, np.cumsum(counts)).astype(int)


def check_spacing(times: np.ndarray, dt: Any) -> None:
    """Refuse times that are not spaced by the step of a diagram of discrete time."""
    spacing = np.diff(times)
    step = spacing[0] if dt is True else dt
    if (np.abs(spacing - step) > 1e-8 + 1e-5 * step).any():
        required = (
            "evenly spaced"
            if dt is True
            else f"{dt:.9g} apart (simulate: or multiples)"
        )
        raise SimulationError(
            f"timepts: a diagram of discrete time (dt = {dt}) takes times that are {required}; "
            f"these are {spacing.min():.9g} to {spacing.max():.9g} apart"
        )
