"""Functions of a compiled diagram as the solver calls them, and their evaluation at points.

The solver takes arrays by their addresses.  The arrays of a call are kept for the next one of the
same shape: making them takes longer than a small evaluation.
"""

from typing import Any, NamedTuple

import numpy as np

from ..codegen.machine import LANES, compiled_solver, numbers_of
from ..methods.method import Method
from .jacobian_pattern import Jacobian
from .schedule import Schedule
from .solver_layout import DECIDE, Shape

MOST_KEPT = 50_000  # numbers in the arrays of a call that are kept
MOST_SHAPES = 6  # of the arrays that are kept of a diagram


class Callee(NamedTuple):
    """Functions that the solver calls, and sizes of its arrays; `shape` is the solver's."""

    functions: Any  # in the solver's order: their addresses, an array
    lanes: int  # runs that are taken at once
    nstates: int
    method: Method
    guarded: int  # number of guards
    levels: tuple  # of each guard: `LEVEL` if states jump there, else 0
    jumping: int  # 1 if states jump
    decided_at: int  # offset of the decisions in P
    decided: int  # their number
    size: int  # length of P
    room: int  # length of W
    tables: np.ndarray  # T, which is not empty
    kept: dict[Any, "Evaluation"]  # by shape, while no thread uses them
    linear: Jacobian = Jacobian()  # of Rodas5P
    timed: bool = False  # whether steps are short, as time may do much in little of it
    code: tuple = ()  # objects that must live for as long as addresses are used

    @property
    def shape(self) -> Shape:
        """Sizes of the problem, as the solver takes them."""
        return Shape(
            self.lanes,
            self.nstates,
            self.method.stages,
            self.method.dense_stages,
            int(self.method.adaptive),
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
        with np.errstate(all="ignore"):
            return int(getattr(compiled_solver(), name)(numbers))

    def evaluate(
        self,
        role: int,
        times: Any,
        x: Any,
        segments: Schedule,
        parameters: Any,
        count: int,
    ) -> np.ndarray:
        """Return the first `count` results of a function at times and states x (nt, n), a row each.

        `parameters` are P, or its beginning.
        """
        size = max(self.size, len(parameters))
        shape = role, len(times), count, size, segments.values.shape
        evaluation = self.kept.pop(shape, None) or Evaluation(self, *shape)
        evaluation.fill(times, x, segments, parameters)
        self.call("evaluate", evaluation.numbers)
        is_small = evaluation.memory.size <= MOST_KEPT
        out = evaluation.out.copy() if is_small else evaluation.out
        if is_small:
            keep(self.kept, shape, evaluation)
        return out

    def events_at(
        self, times: Any, x: Any, segments: Schedule, parameters: Any
    ) -> np.ndarray:
        """Return decisions, distances and rounding errors of all events, (nt, 3, events)."""
        count = 3 * self.events
        numbers = self.evaluate(DECIDE, times, x, segments, parameters, count)
        return numbers.reshape(-1, 3, self.events)


class Evaluation:
    """Arrays of an evaluation, which live as long as the `numbers` with their addresses."""

    def __init__(
        self,
        callee: Callee,
        role: int,
        points: int,
        count: int,
        size: int,
        shape: tuple[int, int],
    ):
        rows, columns = shape
        of_points = points, points * callee.nstates, points * count
        most = max(count, 3 * callee.events)
        of_functions = 1, size + 1, callee.room + 1, most + 1
        self.memory, arrays = aligned(*of_points, rows * columns, *of_functions)
        self.times, self.states, out, values, time, self.P, W, D = arrays
        self.values = values.reshape(shape)
        self.out = out.reshape(points, count)
        self.which_segment = np.zeros(points, dtype=np.int64)
        self.indices = np.zeros(columns, dtype=np.int64)
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

    def fill(self, times: Any, x: Any, segments: Schedule, parameters: Any) -> None:
        """Write the points, their segments and P into the arrays."""
        self.memory.fill(0.0)
        self.times[:] = times
        self.states[:] = x.ravel()
        self.which_segment[:] = np.searchsorted(segments.edges, times, "right")
        self.indices[:] = segments.indices
        self.values[:] = segments.values
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
