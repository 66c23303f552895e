"""Functions of a compiled diagram as the solver calls them, and their evaluation at points.

The solver takes arrays by their addresses.  The arrays of a call are kept for the next one of the
same shape: making them takes longer than a small evaluation.
"""

from ctypes import addressof, c_char
from typing import Any

import numpy as np

from ..codegen.machine import LANES, compiled_solver, numbers_of
from ..methods import Method
from .diagram_code import kernels
from .schedule import Schedule
from .solver_layout import DECIDE, Linear, Shape

FUNCTIONS = ("derivative", "prepare", "signals", "jump", "decide")
NONE = (np.zeros(0),)
NO_LINEAR = Linear(*5 * NONE, (0, 0), *6 * NONE)  # of explicit methods
MOST_KEPT = 50_000  # numbers in the arrays of a call that are kept
MOST_SHAPES = 6  # of the arrays that are kept of a diagram


class Callee:
    """Functions of a `NativeDiagram` that the solver calls, and sizes of its arrays.

    Attributes
    ----------
    functions : ndarray
        Addresses of the diagram's functions, then of the formulas of the method.
    counts : tuple of int
        Results of each function of the diagram.
    decided_at, decided : int
        Offset of the decisions in P, and their number.
    events : int
        Number of events in state: decisions and guards.
    levels : ndarray
        1 for each guard at which states jump.
    tries : int
        Tries of a call of the solver at most.
    tables : ndarray
        T, which is not empty.
    linear : Linear
        Sparsity of the matrix of an implicit method.
    slopes : sequence of int
        Places in P of the slopes of inputs that rates read: steps are short
        where one is not zero.
    kept : dict
        Arrays of calls by shape, while no thread uses them.
    """

    tries = 2**62

    def __init__(self, diagram: Any, lanes: int, method: Method):
        code, layout, n = diagram.code, diagram.layout, diagram.nstates
        self.code = code
        program = code.program
        self.program, self.nstates = program, n
        self.lanes, self.method = lanes, method
        self.decided_at, self.decided = diagram.decided_at, program.decided
        self.events = program.decided + program.guarded
        self.counts = n, 0, diagram.nsignals, n, 3 * self.events
        # 1. addresses, 0 of functions that are not called; in discrete time no state jumps
        jumping = int(not method.discrete and bool(layout.jumps))
        called = {"jump": jumping, "decide": self.events}
        names = [name for name in FUNCTIONS if called.get(name, True)]
        addresses = dict(zip(names, code.addresses(names, lanes), strict=True))
        functions = [addresses.get(name, 0) for name in FUNCTIONS]
        machine = kernels(n, lanes, method) if n else None
        if machine is not None:
            functions += machine.addresses.values()
        self.functions = np.array(functions, dtype=np.int64)
        self.machine = machine  # for as long as addresses are used
        # 2. sizes, and facts about events, rates and the method
        self.shape = Shape(
            lanes,
            n,
            method.stages,
            method.dense_stages,
            int(method.implicit),
            int(method.discrete),
            program.guarded,
            jumping,
            self.decided_at,
            self.decided,
        )
        self.levels = np.zeros(program.guarded)
        for guard, k in enumerate(diagram.sweep.guarded):
            self.levels[guard] = diagram.wiring.nodes[k].system.jumps_at_level
        self.tables = np.concatenate([layout.T, program.tables])
        self.linear = code.sparsity() if method.implicit else NO_LINEAR
        inputs = diagram.wiring.ninputs if program.ramped else 0
        self.slopes = range(self.decided_at - 2 - inputs, self.decided_at - 2)
        self.kept: dict[Any, Any] = {}

    def call(self, name: str, numbers: np.ndarray) -> int:
        """Call a function of the solver on numbers."""
        function = getattr(compiled_solver(), name)
        return int(function(addressof(c_char.from_buffer(numbers.data))))

    def evaluate(
        self, role: int, times: Any, x: Any, segments: Schedule, parameters: Any
    ) -> np.ndarray:
        """Return the results of a function at times and states x (nt, n), a row each.

        `parameters` are P, or its beginning.
        """
        shape = role, len(times), len(parameters), segments.values.shape
        evaluation = self.kept.pop(shape, None) or Evaluation(self, *shape)
        evaluation.fill(times, x, segments, parameters)
        self.call("evaluate", evaluation.numbers)
        if not evaluation.is_small:
            return evaluation.out
        out = evaluation.out.copy()
        keep(self.kept, shape, evaluation)
        return out

    def evaluate_runs(
        self,
        role: int,
        times: np.ndarray,
        x: np.ndarray,
        segments: Schedule,
        parameters: np.ndarray,
    ) -> np.ndarray:
        """Return results (m, nt, count) at states (m, nt, n) of runs with parameters (m, nP).

        The segments of all runs, one behind the other, set the parameters of each.
        """
        m, size = parameters.shape
        each = len(segments.values)
        rows = np.repeat(parameters, each, axis=0), np.tile(segments.values, (m, 1))
        indices = np.append(np.arange(size), segments.indices)
        every = segments._replace(indices=indices, values=np.hstack(rows))
        evaluation = Evaluation(self, role, m * len(times), size, every.values.shape)
        evaluation.fill(np.tile(times, m), x, every, parameters[0])
        which = np.searchsorted(segments.edges, times, "right")
        evaluation.which_segment[:] = np.add.outer(each * np.arange(m), which).ravel()
        self.call("evaluate", evaluation.numbers)
        return evaluation.out.reshape(m, len(times), -1)

    def events_at(
        self, times: Any, x: Any, segments: Schedule, parameters: Any
    ) -> np.ndarray:
        """Return decisions, distances and rounding errors of all events, (nt, 3, events)."""
        numbers = self.evaluate(DECIDE, times, x, segments, parameters)
        return numbers.reshape(-1, 3, self.events)


class Evaluation:
    """Arrays of an evaluation, which live as long as the `numbers` with their addresses."""

    def __init__(
        self, callee: Callee, role: int, points: int, size: int, segments: tuple
    ):
        self.times = np.empty(points)
        self.which_segment = np.empty(points, dtype=np.int64)
        self.states = np.empty(points * callee.nstates)
        self.indices = np.empty(segments[1], dtype=np.int64)
        self.values = np.empty(segments)
        self.out = np.empty((points, callee.counts[role]))
        size = max(callee.program.parameters, size) + 1
        results = max(self.out.shape[1], 3 * callee.events) + 1
        self.memory, arrays = aligned(1, size, callee.program.room + 1, results)
        time, self.P, W, D = arrays
        sizes = self.states.size, self.out.size, self.values.size, self.memory.size
        self.is_small = sum(sizes) <= MOST_KEPT
        self.numbers = numbers_of(
            callee.functions,
            role,
            callee.nstates,
            callee.decided_at,
            callee.decided,
            (self.times, self.which_segment, time, self.states),
            (self.indices, self.values),
            (self.P, callee.tables, W, D),
            self.out,
        )

    def fill(
        self, times: Any, x: np.ndarray, segments: Schedule, parameters: np.ndarray
    ) -> None:
        """Write points, their segments and P into the arrays."""
        self.times[:] = times
        self.which_segment[:] = segments.edges.searchsorted(times, "right")
        self.states[:] = x.ravel()
        self.indices[:] = segments.indices
        self.values[:] = segments.values
        self.memory.fill(0.0)
        self.P[: len(parameters)] = parameters


def keep(kept: dict[Any, Any], shape: Any, arrays: Any) -> None:
    """Keep the arrays of a call for the next call of their shape."""
    if len(kept) >= MOST_SHAPES:
        kept.clear()
    kept[shape] = arrays


def aligned(*sizes: int) -> tuple[np.ndarray, list[np.ndarray]]:
    """Return zeros, and arrays in them, aligned with lines of the cache: each holds eight runs."""
    lines = [-(-size // LANES) * LANES for size in sizes]
    memory = np.zeros(sum(lines) + LANES)
    offset = -(memory.ctypes.data // memory.itemsize) % LANES
    arrays = []
    for size, line in zip(sizes, lines, strict=True):
        arrays.append(memory[offset : offset + size])
        offset += line
    return memory, arrays
