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
from .callee import MOST_KEPT, keep
from .diagram_code import code_of
from .inputs import NO_INPUTS, Inputs
from .runner import Runner
from .schedule import Schedule
from .solver_layout import DECISION, DERIVATIVE, JUMP, SIGNALS

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
        # of the last runs by times and inputs, the same for any parameters
        self._schedules: dict[Any, Schedule] = {}
        # callees by lanes and method, with arrays of earlier runs; series by order and lanes
        self.callees: dict[Any, Any] = {}

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

    def schedule(self, times: Any, inputs: Inputs = NO_INPUTS) -> Schedule:
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
