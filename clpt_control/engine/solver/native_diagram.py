"""A diagram as machine code: its runs, and what the solver calls."""

from collections.abc import Mapping, Sequence
from copy import copy
from dataclasses import replace
from typing import Any, Self

import control
import numpy as np

from ..codegen.diagram_record import PLAIN, Form, lay_out
from ..codegen.machine import LANES, fuses
from ..diagram.wiring import Wiring
from ..methods import DISCRETE, EXPLICIT, IMPLICIT, METHODS, Method
from .callee import MOST_KEPT, Callee, keep
from .diagram_code import code_of
from .inputs import NO_INPUTS, Inputs
from .legs import NativeRun
from .runner import Runner, RunOptions
from .schedule import Schedule
from .solver_layout import DECISION, DERIVATIVE, JUMP, SIGNALS
from .termination import Solution, without_states

ABREAST = 256  # states of runs in lanes; more do not fit the first cache


class NativeDiagram(Runner):
    """A diagram compiled to machine code.

    `apart` has blocks' fields that differ from run to run.

    Attributes
    ----------
    code : Code
        Its program and machine code.
    layout : Layout
        Where parameters lie.

    >>> import clpt_control as clpt
    >>> scenario = clpt.paper_scenario()
    >>> native = NativeDiagram(clpt.closed_loop(scenario))
    >>> native.run(clpt.initial_state(scenario), [0.0, 20.0]).x.shape
    (2, 14)
    """

    engine = "native"
    ramps = True
    most = 500_000_000

    def __init__(
        self,
        diagram: control.NonlinearIOSystem | Wiring,
        form: Form = PLAIN,
        apart: Mapping[tuple[int, str], Any] = {},
    ):
        super().__init__(diagram)
        self.layout = lay_out(self.wiring, self.sweep.parameters, apart)
        self.form = form
        self.code = code_of(self.wiring, self.layout, form)
        self.nstates *= form.copies
        self.nsignals *= form.copies
        # offset in P of the decisions, behind the tolerances
        self.decided_at = self.layout.inputs(self.wiring.ninputs) + 2
        # of the last runs by times and inputs, the same for any parameters
        self._schedules: dict[Any, Schedule] = {}
        # callees by lanes and method, with arrays of earlier runs; series by order and lanes
        self.callees: dict[Any, Any] = {}

    def parameters(self, of_run: np.ndarray | None = None) -> np.ndarray:
        """Return P, or that of a run in another form, with room for inputs and prepared numbers."""
        own = self.layout.P
        P = np.zeros(self.code.program.parameters)
        P[: len(own)] = own if of_run is None else of_run[: len(own)]
        return P

    def with_parameters(self, parameters: Sequence[Any]) -> Self:
        """Return the same code with other parameters of its blocks."""
        diagram = super().with_parameters(parameters)
        diagram.layout = replace(self.layout, P=self.layout.packed(parameters))
        return diagram

    def in_form(self, **changed: Any) -> Self:
        """Return the diagram in another form, of which some fields change."""
        diagram = copy(self)
        diagram.form = self.form._replace(**changed)
        diagram.code = code_of(self.wiring, self.layout, diagram.form)
        diagram.callees = {}
        return diagram

    # --- runs -----------------------------------------------------------------------------

    def schedule(
        self, times: Any, inputs: Inputs = NO_INPUTS, least: float = 0.0
    ) -> Schedule:
        """Return the segments of a run, the same for the same times and inputs.

        Breakpoints of blocks are looked up each time.
        """
        arrays = [np.asarray(times), *inputs.samples]
        if self.breaking or sum(array.size for array in arrays) > MOST_KEPT:
            return super().schedule(times, inputs)
        key = tuple((array.shape, array.tobytes()) for array in arrays)
        schedule = self._schedules.get(key)
        if schedule is None:
            schedule = super().schedule(times, inputs)
            keep(self._schedules, key, schedule)
        return schedule

    def solve(
        self, start: np.ndarray, times: np.ndarray, inputs: Inputs, options: RunOptions
    ) -> Solution:
        """Integrate from the first to the last of the times in machine code."""
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

    def results(
        self,
        times: np.ndarray,
        x: np.ndarray,
        segments: Schedule,
        signals: np.ndarray | None = None,
    ) -> list[np.ndarray]:
        """Return what `Sweep.results` does, a row for each time; signals may be known."""
        sweep, callee, P = self.sweep, self.callee(), self.parameters()
        at = times, x, segments
        if signals is None:
            signals = callee.evaluate(SIGNALS, *at, P)
        results = [signals]
        if self.nstates:
            results.append(callee.evaluate(DERIVATIVE, *at, P))
        if sweep.jumping:
            all_jump = segments.requesting(self.layout.jumps, sweep.jumping)
            results.append(callee.evaluate(JUMP, times, x, all_jump, P))
        if sweep.guarded:
            events = callee.events_at(*at, P)
            results.append(events[:, DECISION, callee.decided :])
        return results

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
            callee = self.callees[lanes, method] = Callee(self, lanes, method)
        return callee

    def lanes(self, count: int) -> int:
        """Return how many runs are taken at once: eight where it pays."""
        return LANES if count > 1 and fuses() and self.nstates <= ABREAST else 1


def compile(diagram: control.NonlinearIOSystem) -> NativeDiagram:
    """Compile an interconnected diagram to machine code.

    >>> import clpt_control as clpt
    >>> scenario = clpt.paper_scenario()
    >>> native = compile(clpt.closed_loop(scenario))
    >>> native.run(clpt.initial_state(scenario), [0.0, 20.0]).status
    'finished'
    """
    return NativeDiagram(diagram)
