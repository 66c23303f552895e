"""A diagram as machine code, which is compiled once a process for all diagrams of one structure."""

from collections.abc import Callable, Mapping, Sequence
from copy import copy
from dataclasses import dataclass, field, replace
from functools import cache
from typing import Any, Self

import control
import numpy as np

from ...base.errors import DiagramError, Uncompiled
from ..codegen.diagram_record import FORMS, DiagramRecord, Layout, lay_out
from ..codegen.directional_derivatives import Directions, add_derivatives
from ..codegen.llvm_text import print_program
from ..codegen.machine import LANES, Machine, fuses, once, one_at_a_time
from ..codegen.plan import NO_TABLES, Program, program_of
from ..codegen.series_loop import print_series
from ..diagram.wiring import Wiring
from ..methods.method import Method
from ..methods.table import DISCRETE, EXPLICIT, IMPLICIT, METHODS, TAYLOR
from ..record.operations import ELEMENTWISE
from ..record.unread import Unread
from .callee import MOST_KEPT, Callee, keep
from .jacobian_pattern import Jacobian, jacobian, reach_of
from .kernels import with_formulas
from .kinks import MANY_DECISIONS, ManyKinks, PassedKinks
from .native_runs import NativeRun
from .runner import Runner, RunOptions
from .schedule import Inputs, Schedule
from .series_runs import series_solution
from .sliding_rates import HeldSwitches, slide
from .solver_layout import SIGNALS
from .termination import Solution, without_states

ABREAST = 256  # states of runs in lanes; more do not fit the first cache
# components of a long program, and how much shorter one of loops is
MANY, SHORTER = (1500, 3)
# components of a program that LLVM does not optimise: its time grows as their square, and the
# machine code is a third slower at most
UNOPTIMISED = 2000
Form = str | HeldSwitches | PassedKinks | Directions | None
FUNCTIONS = ("derivative", "prepare", "signals", "jump", "decide")


@dataclass(frozen=True)
class Structure:
    """All that machine code depends on, without parameters, and a diagram of that structure.

    `key` holds records, shapes and sizes of the blocks; what feeds each; the order of evaluation,
    the kind of time, which blocks pass inputs on at once and which sample; where parameters lie;
    how many inputs the diagram has.
    """

    key: tuple
    wiring: Wiring = field(compare=False)
    layout: Layout = field(compare=False)


class Code:
    """The program of a structure, and its machine code once it was requested.

    `sparsity` is the pattern of df/dx, for an implicit method; `decided_operations` the first
    decision of each operation that decides.
    """

    def __init__(
        self,
        program: Program,
        sparsity: Callable[[], Jacobian],
        decided_operations: tuple[int, ...],
    ):
        self.program, self.sparsity = program, cache(sparsity)
        self.decided_operations = decided_operations
        self._machines: dict[tuple[str, int], Machine] = {}

    @one_at_a_time
    def addresses(self, names: Sequence[str], lanes: int) -> list[int]:
        """Return where functions lie, compiled together when first asked for."""
        new = (name for name in names if (name, lanes) not in self._machines)
        missing = tuple(dict.fromkeys(new))
        if missing:
            program = self.program
            text = repr((program._replace(tables=NO_TABLES), missing, lanes))
            large = len(program.components) > UNOPTIMISED
            machine = Machine(
                missing,
                text,
                lambda: print_program(program, missing, lanes),
                large,
                0 if large else 3,
            )
            for name in missing:
                self._machines[name, lanes] = machine
        return [self._machines[name, lanes].addresses[name] for name in names]

    @one_at_a_time
    def series(self, lanes: int, order: int) -> Machine:
        """Return the Taylor series of the rates, up to an order, as machine code."""
        key = f"series {order}", lanes
        if key not in self._machines:
            program = self.program
            text = repr((program._replace(tables=NO_TABLES), key))
            self._machines[key] = Machine(
                ["series"], text, lambda: print_series(program, lanes, order)
            )
        return self._machines[key]


def code_of(wiring: Wiring, layout: Layout, form: Form = None) -> Code:
    """Return the code of a diagram, the same for diagrams of one structure.

    `form` says whether all axes are ``"unrolled"`` or ``"looped"``, or decisions ``"free"``,
    held on switches, or free where kinks are passed.  An `Uncompiled` error says what cannot be
    compiled.
    """
    if form not in FORMS and not isinstance(
        form, HeldSwitches | PassedKinks | Directions
    ):
        raise DiagramError(
            f"form = {form!r}: must be 'unrolled', 'looped' or 'free', or left out"
        )
    blocks: list[Any] = [node.system for node in wiring.nodes]
    try:
        records = tuple(tuple(block.records.items()) for block in blocks)
    except Unread as error:
        raise Uncompiled(str(error)) from None
    shapes = tuple(
        tuple(tuple(sizes.items()) for sizes in (*block.declared.values(), block.sizes))
        for block in blocks
    )
    wires = tuple(
        (node.states.start, node.outputs.start, node.wires) for node in wiring.nodes
    )
    key = (
        records,
        shapes,
        wires,
        wiring.order,
        tuple((block.feedthrough, block.first_held) for block in blocks),
        bool(wiring.dt),
        layout.pattern,
        wiring.ninputs,
    )
    return _code(Structure(key, wiring, layout), form)


@once(64)
def _code(structure: Structure, form: Form) -> Code:
    """Return the code; that with short axes looped where it is far shorter, as of matrices."""
    try:
        code = _planned(structure, form)
    except Uncompiled:
        if form is not None:
            raise
        return _planned(structure, "looped")
    size = len(code.program.components)
    if (
        form is not None
        or size <= MANY
        or SHORTER * _array_operations(structure) >= size
    ):
        return code
    looped = _planned(structure, "looped")
    looped_size = len(looped.program.components)
    return looped if SHORTER * looped_size < size else code


def _array_operations(structure: Structure) -> int:
    """Return how many operations the records have, each of which is a loop's component at least."""
    blocks: list[Any] = [node.system for node in structure.wiring.nodes]
    records = [record for block in blocks for record in block.records.values()]
    return sum(
        line.kind in ELEMENTWISE for record in records for line in record.operations
    )


def _planned(structure: Structure, form: Form) -> Code:
    wiring = structure.wiring
    layout = structure.layout
    plain_form: Any = form.form if isinstance(form, Directions) else form
    if isinstance(plain_form, HeldSwitches):
        record = DiagramRecord(wiring, layout, passed=None)
        slide(record, plain_form)
    elif isinstance(plain_form, PassedKinks):
        record = DiagramRecord(wiring, layout, None, plain_form.operations)
    else:
        record = DiagramRecord(wiring, layout, plain_form)
    if isinstance(form, Directions):
        add_derivatives(record, form)
    last = wiring.nodes[-1]
    copies = copies_of(form)
    signals = copies * last.outputs.stop
    states = copies * last.states.stop
    program = program_of(record, signals, layout.inputs(wiring.ninputs))
    operations = tuple(record.decisions.operations)
    return Code(program, lambda: jacobian(reach_of(record, states)), operations)


def copies_of(form: Form) -> int:
    """Return the number of vectors as long as the state: 1, or more with derivatives."""
    return form.copies if isinstance(form, Directions) else 1


# --- ready to run ----------------------------------------------------------------------------


class NativeDiagram(Runner):
    """A diagram compiled to machine code.

    `params` are call-time parameters by qualified name.  `form` is "unrolled" or "looped" (all
    axes; by default short ones are unrolled), "free" (decisions are not locked for a step) or a
    `HeldSwitches`.  `apart` has blocks' fields that differ from run to run.

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
        params: Mapping[str, Any] | None = None,
        form: Form = None,
        apart: Mapping[tuple[int, str], Any] = {},
    ):
        super().__init__(diagram, params)
        self.layout = lay_out(self.wiring, self.sweep.parameters, apart)
        self.form = form
        self.code = code_of(self.wiring, self.layout, form)
        copies = copies_of(form)
        self.nstates *= copies
        self.nsignals *= copies
        self.intervals = self.layout.intervals
        self.jumps = self.layout.jumps
        self.time_tables = tuple(self.layout.time_tables.values())
        self.ramp = len(self.layout.P)  # offset in P of the diagram's inputs
        # and of the decisions, behind the tolerances
        self.decided_at = self.layout.inputs(self.wiring.ninputs) + 2
        # of the last runs by times and inputs, the same for any parameters
        self._schedules: dict[Any, Schedule] = {}
        self._forget()

    def _forget(self) -> None:
        """Begin without callees, and without arrays of earlier runs."""
        self._callees: dict[tuple[int, Method], Callee] = {}
        # by shape, while no thread runs them
        self.kept: dict[Any, Any] = {}
        self.kept_series: dict[Any, Any] = {}

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

    def over_kinks(self, rtol: float, atol: float) -> ManyKinks | None:
        """Return what continues a run over many kinks, or None."""
        if self.resetting or self.code.program.decided < MANY_DECISIONS:
            return None
        return ManyKinks(self, rtol, atol)

    def unlocked(self) -> Self:
        """Return the diagram with decisions that change within a step.

        A root of a state that comes to rest at zero, -sqrt(max(x, 0)), or that begins there,
        sqrt(|x|), has no value beyond the switch, so steps with a locked decision cannot cross it.
        """
        return self.in_form("free")

    def in_form(self, form: Form) -> Self:
        """Return the diagram in another form; derivatives stay."""
        diagram = copy(self)
        diagram.form = form
        if isinstance(self.form, Directions):
            diagram.form = self.form._replace(form=form)
        diagram.code = code_of(self.wiring, self.layout, diagram.form)
        diagram._forget()
        return diagram

    # --- runs -----------------------------------------------------------------------------

    def schedule(
        self, times: Any, inputs: Inputs | None = None, least: float = 0.0
    ) -> Schedule:
        """Return the segments of a run, the same for the same times and inputs.

        Breakpoints of blocks are looked up each time.
        """
        arrays = [np.asarray(times), *(() if inputs is None else inputs.samples)]
        if self.breaking or sum(array.size for array in arrays) > MOST_KEPT:
            return super().schedule(times, inputs)
        key = tuple((array.shape, array.tobytes()) for array in arrays)
        schedule = self._schedules.get(key)
        if schedule is None:
            schedule = super().schedule(times, inputs)
            keep(self._schedules, key, schedule)
        return schedule

    def solve(
        self,
        start: np.ndarray,
        times: np.ndarray,
        inputs: Inputs | None,
        options: RunOptions,
    ) -> Solution:
        """Integrate from the first to the last of the times in machine code."""
        if not self.nstates:
            return without_states(self.sweep, times, inputs, self.engine)
        if options.method == TAYLOR:
            return series_solution(self, start, times, inputs, options)
        return NativeRun(self, times, inputs, options).solution(start)

    def evaluate(self, solution: Solution, inputs: Inputs | None) -> np.ndarray:
        """Return all block outputs at a solution's times, finite or not."""
        points = solution.t, solution.x, self.segments_of(solution, inputs)
        return self.callee().evaluate(
            SIGNALS, *points, self.parameters(), self.nsignals
        )

    def method_of(self, method: str = "auto") -> Method:
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
        if (lanes, method) not in self._callees:
            self._callees[lanes, method] = self._callee(lanes, method)
        return self._callees[lanes, method]

    def _callee(self, lanes: int, method: Method) -> Callee:
        code = self.code
        program = code.program
        # in discrete time no state jumps
        jumping = int(not method.discrete and bool(self.jumps))
        # 1. addresses of the functions, 0 of those that are not called
        called = {"jump": jumping, "decide": program.decided + program.guarded}
        names = [name for name in FUNCTIONS if called.get(name, True)]
        addresses = dict(zip(names, code.addresses(names, lanes), strict=True))
        # 2. sizes, and the formulas of the method
        systems = [node.system for node in self.wiring.nodes]
        at_level = [s.jumps_at_level for s in systems if s.guard is not None]
        levels = np.zeros(program.guarded)
        levels[: len(at_level)] = at_level
        slopes = self.decided_at - 2 - self.wiring.ninputs, self.decided_at - 2
        callee = Callee(
            functions=[addresses.get(name, 0) for name in FUNCTIONS],
            lanes=lanes,
            nstates=self.nstates,
            method=method,
            guarded=program.guarded,
            levels=levels,
            jumping=jumping,
            decided_at=self.decided_at,
            decided=program.decided,
            size=program.parameters,
            room=program.room,
            tables=np.concatenate([self.layout.T, program.tables]),
            kept={},
            linear=code.sparsity() if method.implicit else Jacobian(),
            timed=program.timed,
            slopes=slopes if program.ramped else (0, 0),
            code=(code,),
        )
        return with_formulas(callee)

    def lanes(self, count: int) -> int:
        """Return how many runs are taken at once: eight where it pays."""
        return LANES if count > 1 and fuses() and self.nstates <= ABREAST else 1


def compile(
    diagram: control.NonlinearIOSystem, params: Mapping[str, Any] | None = None
) -> NativeDiagram:
    """Compile an interconnected diagram to machine code.

    >>> import clpt_control as clpt
    >>> scenario = clpt.paper_scenario()
    >>> native = compile(clpt.closed_loop(scenario))
    >>> native.run(clpt.initial_state(scenario), [0.0, 20.0]).status
    'finished'
    """
    return NativeDiagram(diagram, params)
