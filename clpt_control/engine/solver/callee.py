"""Functions of a compiled diagram as the solver calls them, and their evaluation at points.

The solver takes arrays by their addresses.  The arrays of a call are kept for the next one of the
same shape: making them takes longer than a small evaluation.
"""

from collections.abc import Sequence
from ctypes import addressof, c_char
from typing import Any, NamedTuple

import numpy as np

from ..codegen.machine import LANES, compiled_solver, numbers_of
from ..methods.table import Method
from .schedule import Schedule
from .solver_layout import DECIDE, Linear, Shape

MOST_KEPT = 50_000  # numbers in the arrays of a call that are kept
MOST_SHAPES = 6  # of the arrays that are kept of a diagram


class Callee(NamedTuple):
    """Functions that the solver calls, and sizes of its arrays; `shape` is the solver's."""

    functions: np.ndarray  # their addresses, in the solver's order
    lanes: int  # runs that are taken at once
    nstates: int
    counts: tuple[int, ...]  # of the results of each function of the diagram
    method: Method
    guarded: int  # number of guards
    levels: np.ndarray  # of each guard: 1 if states jump there
    jumping: int  # 1 if states jump
    decided_at: int  # offset of the decisions in P
    decided: int  # their number
    size: int  # length of P
    room: int  # length of W
    tables: np.ndarray  # T, which is not empty
    kept: dict[Any, Any]  # arrays of calls by shape, while no thread uses them
    linear: Linear  # sparsity of the matrix of an implicit method
    timed: bool = False  # whether steps are short, as time may do much in little of it
    # places in P of the slopes of inputs that rates read: steps are short where one is not zero
    slopes: Sequence[int] = ()
    code: tuple = ()  # objects that must live for as long as addresses are used

    @property
    def shape(self) -> Shape:
        """Sizes of the problem, as the solver takes them."""
        return Shape(
            self.lanes,
            self.nstates,
            self.method.stages,
            self.method.dense_stages,
            int(self.method.implicit),
            int(self.method.discrete),
            self.guarded,
            self.jumping,
            self.decided_at,
            self.decided,
        )

    @property
    def events(self) -> int:
        """Number of events in state."""
        return self.decided + self.guarded

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
        size = max(callee.size, size) + 1
        results = max(self.out.shape[1], 3 * callee.events) + 1
        self.memory, arrays = aligned(1, size, callee.room + 1, results)
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
