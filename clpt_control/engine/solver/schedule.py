"""The arguments of a run: times, states, inputs as python-control takes them, and pieces of time.

A run stops exactly where a piece ends: at a breakpoint of a block or at a sample of the diagram's
inputs.  A piece sets in P the `interval` of blocks that jump, whether their states jump at its
beginning, and the straight line of each input.  A run begins after the jumps of that time, but
blocks that sample then sample their inputs.  In Python a run stops at sharp bends of a sampled
input; smaller bends, as of a sampled sine, are smooth to the tolerance.
"""

from bisect import bisect_right
from dataclasses import dataclass
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np

from ...arguments import numbers
from ...errors import SimulationError
from .evaluation_pass import moved_back, moved_to, rounding

SHARP = 10.0  # a bend is sharp if it is so many times as large as most


@dataclass(frozen=True)
class Inputs:
    """The inputs of a diagram: ``at(t)`` of shape (ninputs,).

    `samples` holds times and values (ninputs, nt), joined by straight lines.
    """

    samples: tuple[np.ndarray, np.ndarray]

    def at(self, t: float) -> np.ndarray:
        """Return the inputs at a time."""
        begins, rows, slopes = self._straight
        k = max(bisect_right(begins, t) - 1, 0)
        return rows[k] + (t - begins[k]) * slopes[k]

    @cached_property
    def _straight(self) -> tuple[list[float], np.ndarray, np.ndarray]:
        at, u = self.samples
        return at.tolist(), np.ascontiguousarray(u.T), np.ascontiguousarray(self.slopes.T)

    @cached_property
    def slopes(self) -> np.ndarray:
        """The slopes from each sample on, shape (ninputs, nt); 0 from the last one."""
        (at, u), slopes = self.samples, np.zeros(self.samples[1].shape)
        slopes[:, :-1] = (u[:, 1:] - u[:, :-1]) / (at[1:] - at[:-1])
        return slopes

    @property
    def kinks(self) -> np.ndarray:
        """Times at which the inputs bend; samples on one straight line, to the bit, are a piece."""
        (at, u), slopes = self.samples, self.slopes
        if len(at) < 3:
            return at
        bend = (slopes[:, 1:-1] != slopes[:, :-2]).any(axis=0)
        bends = np.flatnonzero(np.concatenate([[True], bend, [True]]))
        begins = np.repeat(bends[:-1], np.diff(bends))  # of each sample's piece
        line = u[:, begins] + slopes[:, begins] * (at[:-1] - at[begins])
        return at[bends] if np.array_equal(line, u[:, :-1]) else at

    def sharp_bends(self, least: float) -> np.ndarray:
        """Return the times at which the inputs bend sharply.

        A bend that leaves the line before it by `least` of the largest value is sharp, too.
        """
        sharp, felt = self._bends(least)
        return self.samples[0][1:-1][sharp | felt]

    @property
    def bends_sharply_only(self) -> bool:
        """Whether inputs are straight but for bends so sharp that integration begins anew there."""
        sharp, felt = self._bends(0.0)
        return bool(np.all(sharp | ~felt))

    def _bends(self, least: float) -> tuple[np.ndarray, np.ndarray]:
        """Return of each inner sample if inputs bend more than elsewhere, and if that is felt."""
        (at, u), slopes = self.samples, self.slopes[:, :-1]
        if len(at) < 3:
            none = np.zeros(len(at[1:-1]), dtype=bool)
            return none, none
        spans, size = at[1:] - at[:-1], np.max(np.abs(u), axis=1, keepdims=True)
        bends = np.abs(slopes[:, 1:] - slopes[:, :-1])
        rounding = 1e-12 * np.max(np.abs(slopes), axis=1, keepdims=True)
        sharp = bends > SHARP * np.median(bends, axis=1, keepdims=True) + rounding
        felt = bends * np.minimum(spans[1:], spans[:-1]) > (least + 1e-12) * size
        return np.any(sharp, axis=0), np.any(felt, axis=0)

    def along(self, times: np.ndarray) -> np.ndarray:
        """Return the inputs at times, shape (ninputs, nt)."""
        at, u = self.samples
        return np.array([np.interp(times, at, row) for row in u]).reshape(len(u), len(times))


def checked_times(name: str, timepts: Any) -> np.ndarray:
    """Return times as an array: at least two, increasing and finite."""
    times = np.atleast_1d(numbers(name, timepts))
    if times.ndim != 1 or len(times) < 2 or not (times[1:] > times[:-1]).all():
        raise SimulationError(f"{name}: must be at least two increasing times")
    if not np.isfinite(times[[0, -1]]).all():
        raise SimulationError(f"{name}: must be finite")
    return times


def checked_state(name: str, state: Any, shape: tuple[int, ...]) -> np.ndarray:
    """Return states as an array of a shape; a single number is the value of all."""
    values = numbers(name, state)
    if values.ndim == 0:
        values = np.full(shape, float(values))
    if values.shape != shape:
        raise SimulationError(
            f"{name}: must have {shape[-1]} numbers, one per state; it has shape {values.shape}"
        )
    return values.copy()


def stacked(inputs: Any, times: np.ndarray) -> Any:
    """Return inputs, a list as rows if it holds any: samples at the times, or constant numbers."""
    listed = isinstance(inputs, list | tuple) and any(hasattr(one, "__len__") for one in inputs)
    if not listed:
        return inputs
    rows, count = [], len(times)
    for one in inputs:
        values = numbers("inputs", one)
        sampled = values.shape[-1:] == (count,) and values.ndim <= 2
        rows.append(values if sampled else np.outer(values, np.ones(count)))
    return np.vstack(rows)


def read_inputs(inputs: Any, times: np.ndarray, count: int) -> Inputs:
    """Read `count` inputs in python-control's forms.

    Straight lines join values of shape (count, nt) at `times`.  A number, or one for each input, is
    constant.  A list may hold both, ``[u1, 0]``.
    """
    if isinstance(inputs, Inputs):  # as read before
        return inputs
    if callable(inputs):
        raise SimulationError("inputs: a function is none; connect a block whose output it is")
    inputs = stacked(inputs, times)
    values = np.zeros(count) if inputs is None else numbers("inputs", inputs)
    if not np.isfinite(values).all():
        raise SimulationError("inputs: must be finite; fill the gaps before the run")
    samples = (count, len(times))
    if values.shape == samples or (count == 1 and values.shape == times.shape):
        return Inputs((times, values.reshape(samples)))
    if values.shape not in {(), (1,), (count,)}:
        raise SimulationError(
            f"inputs: shape {values.shape} does not fit {count} inputs at {len(times)} times"
            + ("" if count else "; initial_state= is the start")
        )
    return Inputs((times[:1], np.broadcast_to(values, count).astype(float)[:, None]))


# --- pieces of time ---------------------------------------------------------------------------

JUMPS, BEGINS = 1.0, -1.0  # in P: a block jumps, or samples its inputs as a run begins


class TimeTable(NamedTuple):
    """A table over time plus a constant, whose rows are breakpoints."""

    times: np.ndarray  # of the rows
    place: int  # in P, of the number of rows before now
    continuous: bool  # what is read there does not jump at a row


class Schedule(NamedTuple):
    """The pieces of a run."""

    edges: np.ndarray  # ends of n pieces, increasing; the last is the end of the run; then inf
    places: np.ndarray  # m places in P
    values: np.ndarray  # (n + 1, m): what each piece sets there, and the time of the end
    smooth: np.ndarray  # (n + 1,): 1 if rates do not jump where a piece begins, but the first
    begins: bool = False  # whether blocks sample where the run begins

    def after(self, t: float) -> "Schedule":
        """Return the pieces from a time on."""
        k = int(np.searchsorted(self.edges, t, side="right"))
        return Schedule(self.edges[k:], self.places, self.values[k:], self.smooth[k:])


def make_schedule(
    diagram: Any, times: Any, inputs: Inputs | None = None, felt: float = 0.0
) -> Schedule:
    """Return the pieces of a run of a diagram; it is `PythonDiagram.schedule`.

    Rates bend at kinks of inputs, in Python at bends that are felt, and at rows of tables over
    time; they jump where blocks do.  Behind each block's `interval` lies what is `JUMPS` in a piece
    that begins with a jump of its states; then come the straight lines of the inputs: time, values,
    slopes.  In discrete time each sample begins a piece.
    """
    t0, t1 = float(times[0]), float(times[-1])
    sweep, compiled, kinks = diagram.sweep, diagram.ramp >= 0, np.zeros(0)
    if inputs is not None and not sweep.wiring.dt:
        kinks = inputs.kinks if compiled else inputs.sharp_bends(felt)
    jumps, edges = sweep.breakpoints(t0, t1 + rounding(t1)), kinks
    if len(jumps):
        jumps = moved_back(jumps, np.asarray(times))
        edges = np.union1d(jumps, moved_to(jumps, kinks)) if len(kinks) else jumps
    tables = diagram.time_tables
    if tables:
        edges = np.unique(np.concatenate([edges, *(one.times for one in tables)]))
    starts = np.concatenate([[t0], edges[(edges > t0) & (edges < t1)], [t1]])
    if sweep.wiring.dt:
        starts = np.asarray(times, dtype=float)

    def intervals_of(k: int) -> np.ndarray:
        block, p = sweep.nodes[k].system, sweep.parameters[k]
        if p.interval >= 0:
            return np.full(len(starts), p.interval)
        late = starts + rounding(starts)
        later = block.breakpoints(late[0], late[-1], p)
        return block.interval_at(late[0], p) + np.searchsorted(later, late, side="right")

    columns, begins = [intervals_of(k) for k in diagram.intervals], False
    for k in diagram.jumps:
        block = sweep.nodes[k].system
        samples = block.first_held is not None and block.samples_at(t0)
        jumping = JUMPS * (np.diff(intervals_of(k)) != 0)
        columns.append(np.append(BEGINS if samples else 0.0, jumping))
        begins = begins or samples
    places = [*diagram.intervals.values(), *diagram.jumps.values()]
    if compiled and inputs is not None and sweep.wiring.ninputs:
        (at, u), slopes = inputs.samples, inputs.slopes
        k = np.searchsorted(at[1:], starts, side="right")  # the line from at[k] on
        columns += [at[k], *u[:, k], *slopes[:, k]]
        places += range(diagram.ramp, diagram.ramp + 1 + 2 * len(u))
    for one in tables:
        columns.append(np.searchsorted(one.times, starts + rounding(starts), side="right"))
        places.append(one.place)
        jumps = jumps if one.continuous else np.union1d(jumps, one.times)
    values = np.array(columns, dtype=float).reshape(len(columns), len(starts)).T.copy()
    smooth = np.isin(starts, jumps, invert=True) if len(jumps) else np.ones(len(starts))
    edges, at_places = np.append(starts[1:], np.inf), np.array(places, dtype=np.int64)
    return Schedule(edges, at_places, values, smooth.astype(np.int64), begins)
