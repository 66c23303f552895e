"""Pieces of time: where a run stops exactly, and what every piece sets in P.

A piece ends at a breakpoint of a block or at a sample of the diagram's inputs.  It
sets the `interval` of blocks that jump, whether their states jump where it begins, and
the straight line of each input.  States do not jump where a run begins: it begins after; but
blocks that sample at that time hold what feeds them then.
"""

from typing import Any, NamedTuple

import numpy as np

from .inputs import Inputs
from .sweep import Sweep

JUMPS, BEGINS = 1.0, -1.0  # in P: a block jumps, or holds what feeds it where a run begins


class Schedule(NamedTuple):
    """The pieces of a run."""

    edges: np.ndarray  # ends of n pieces, increasing; the last is the end of the run
    places: np.ndarray  # m places in P
    values: np.ndarray  # (n + 1, m): what each piece sets there, and the time of the end
    smooth: np.ndarray  # (n + 1,): whether rates do not jump where a piece begins
    begins: bool = False  # whether blocks sample where the run begins

    def after(self, t: float) -> "Schedule":
        """Return the pieces from a time on."""
        k = int(np.searchsorted(self.edges, t, side="right"))
        smooth = self.smooth[k:].copy()
        smooth[:1] = False
        return Schedule(self.edges[k:], self.places, self.values[k:], smooth)


def make_schedule(
    sweep: Sweep,
    intervals: dict[int, int],
    jumps: dict[int, int],
    t0: float,
    t1: float,
    kinks: np.ndarray | None = None,
    breaks: np.ndarray | tuple[()] = (),
) -> Schedule:
    """Return the pieces of a run from t0 to t1, which also stop at `kinks` and at `breaks`.

    Rates bend at kinks and jump at breaks.

    `intervals` holds the place in P of each block's `interval`, `jumps` the place that is `JUMPS`
    where a piece begins with a jump of the block's states.
    """
    jumping = edges = _united(sweep.breakpoints(t0, t1), breaks)
    edges = _united(edges, () if kinks is None else kinks)
    edges = np.concatenate([edges[(edges > t0) & (edges < t1)], [t1]])
    starts = np.concatenate([[t0], edges])
    smooth = np.ones(len(starts), dtype=bool)
    if len(jumping):
        smooth = ~np.isin(starts, jumping)
    smooth[0] = False
    places = np.array([*intervals.values(), *jumps.values()], dtype=np.int64)
    values = np.zeros((len(starts), len(places)))

    def numbers(k: int) -> np.ndarray:
        block, given = sweep.nodes[k].system, sweep.given[k]
        if given.interval >= 0:
            return np.full(len(starts), given.interval)
        return np.searchsorted(block.breakpoints(0.0, t1, given), starts, side="right")

    for j, k in enumerate(intervals):
        values[:, j] = numbers(k)
    for j, k in enumerate(jumps, len(intervals)):
        values[1:, j] = JUMPS * (np.diff(numbers(k)) != 0)
        block = sweep.nodes[k].system
        if block.kept is not None and block.samples_at(t0):
            values[0, j] = BEGINS
    return Schedule(edges, places, values, smooth, bool(np.any(values[0, len(intervals) :])))


def _united(times: np.ndarray, more: Any) -> np.ndarray:
    """Return increasing times of both."""
    if len(times) and len(more):
        return np.union1d(times, more)
    return np.asarray(more if len(more) else times, dtype=float)


def with_inputs(pieces: Schedule, t0: float, inputs: Inputs, ramp: int) -> Schedule:
    """Add the diagram's inputs, straight within pieces that stop at every sample.

    `ramp` is their place in P: time, values, slopes.
    """
    assert inputs.samples is not None
    (at, u), slopes = inputs.samples, inputs.slopes
    starts = np.concatenate([[t0], pieces.edges])
    k = np.searchsorted(at, starts, side="right") - 1
    k = np.minimum(np.maximum(k, 0), slopes.shape[1] - 1)
    rows = [pieces.values, at[k, None], u[:, k].T, slopes[:, k].T]
    places = np.concatenate([pieces.places, np.arange(ramp, ramp + 1 + 2 * len(u))])
    return pieces._replace(places=places, values=np.concatenate(rows, axis=1))
