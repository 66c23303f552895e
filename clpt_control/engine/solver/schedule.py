"""Segments of time of a run.

A run stops exactly where a segment ends: at a breakpoint of a block or at a sample of the diagram's
inputs.  A segment sets in P the `interval` of blocks that jump, whether their states jump at its
beginning, and the straight line of each input.  A run begins after the jumps of that time, but
blocks that sample then sample their inputs.
"""

from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np
from numpy import ndarray

from .evaluation_pass import rounding
from .inputs import NO_INPUTS, Inputs

JUMPS, BEGINS = 1.0, -1.0  # in P: a block jumps, or samples its inputs as a run begins


class Schedule(NamedTuple):
    """The segments of a run."""

    edges: ndarray  # ends of n segments, increasing; the last is the end of the run; then inf
    indices: ndarray  # m indices in P
    values: ndarray  # (n + 1, m): numbers that each segment sets there, and the time of the end
    smooth: ndarray  # (n + 1,): 1 if rates do not jump where a segment begins, but the first
    begins: bool = False  # whether blocks sample where the run begins

    def after(self, t: float) -> "Schedule":
        """Return the segments from a time on."""
        k = int(np.searchsorted(self.edges, t, side="right"))
        return Schedule(self.edges[k:], self.indices, self.values[k:], self.smooth[k:])

    def requesting(self, places: Mapping[int, int], jumping: list[int]) -> "Schedule":
        """Return segments in which these blocks jump; all that may have their `places` in P."""
        values = self.values.copy()
        for k, place in places.items():
            values[:, self.indices == place] = JUMPS if k in jumping else 0.0
        return self._replace(values=values)


def make_schedule(diagram: Any, times: Any, inputs: Inputs = NO_INPUTS) -> Schedule:
    """Return the segments of a run of a diagram.

    Rates bend at kinks of inputs and at rows of tables over time; they jump where blocks do.
    Behind each block's `interval` lies `JUMPS` in a segment that begins with a jump of its states;
    then come the straight lines of the inputs: time, values, slopes.  In discrete time each sample
    begins a segment.
    """
    wiring, layout = diagram.sweep.wiring, diagram.layout
    diagram.sweep.trigger(inputs)
    # 1. times at which segments begin, and at which rates jump
    jumps, bends = _events_of_time(diagram, times, inputs)
    starts = np.asarray(times, dtype=float)
    if not wiring.dt:
        t0, t1 = starts[0], starts[-1]
        inner = bends[(bends > t0) & (bends < t1)]
        starts = np.concatenate([[t0], inner, [t1]])
    # 2. intervals of the blocks, and whether their states jump
    indices = [*layout.intervals.values(), *layout.jumps.values()]
    columns = [_intervals(diagram.sweep, k, starts) for k in layout.intervals]
    samples_at_start = False
    for k in layout.jumps:
        block = diagram.sweep.nodes[k].system
        if block.breakpoints_function is None:  # it jumps at a level
            columns.append(np.zeros(len(starts)))
            continue
        request = 0.0
        if block.first_held is not None and block.samples_at(float(times[0])):
            request = BEGINS
            samples_at_start = True
        changes = np.diff(_intervals(diagram.sweep, k, starts))
        jumping = JUMPS * (changes != 0)
        columns.append(np.append(request, jumping))
    # 3. straight lines of the inputs
    if inputs is not NO_INPUTS and wiring.ninputs:
        sample_times, u = inputs.samples
        # the line from this sample on
        k = np.searchsorted(sample_times[1:], starts, side="right")
        columns.append(sample_times[k])
        columns += [*u[:, k]]
        columns += [*inputs.slopes[:, k]]
        indices += range(len(layout.P), layout.inputs(len(u)))
    # 4. rows of the tables over time
    for table in layout.time_tables.values():
        later = starts + rounding(starts, starts[-1] - starts[0])
        columns.append(np.searchsorted(table.times, later, side="right"))
        indices.append(table.offset)
        if not table.continuous:
            jumps = np.union1d(jumps, table.times)
    # 5. arrays, one row for each segment
    shape = len(columns), len(starts)
    rows = np.reshape(columns, shape).T
    smooth = np.ones(len(starts), dtype=np.int64)
    if len(jumps):
        smooth[:] = np.isin(starts, jumps, invert=True)
    return Schedule(
        edges=np.append(starts[1:], np.inf),
        indices=np.array(indices, dtype=np.int64),
        values=np.array(rows, dtype=float, order="C"),
        smooth=smooth,
        begins=samples_at_start,
    )


def _events_of_time(
    diagram: Any, times: Any, inputs: Inputs
) -> tuple[ndarray, ndarray]:
    """Return the times at which blocks jump, and all times at which rates bend or jump."""
    kinks = np.zeros(0) if diagram.sweep.wiring.dt else inputs.kinks(diagram.slack)
    t0 = float(times[0])
    t1 = float(times[-1])
    run = t1 - t0
    jumps = diagram.sweep.breakpoints(t0, t1 + rounding(t1, run))
    bends = kinks
    if len(jumps):
        jumps = _moved_back(jumps, np.asarray(times), run)
        bends = jumps
        if len(kinks):
            kinks = _moved_to(jumps, kinks, run)
            bends = np.union1d(jumps, kinks)
    if len(kinks) and len(inputs.jumps):
        jumps = np.union1d(jumps, _moved_to(jumps, inputs.jumps, run))
    if tables := diagram.layout.time_tables:
        rows = [table.times for table in tables.values()]
        bends = np.unique(np.concatenate([bends, *rows]))
    return jumps, bends


def _intervals(sweep: Any, k: int, starts: ndarray) -> ndarray:
    """Return the interval of a block in each segment."""
    parameters = sweep.parameters[k]
    if parameters.interval >= 0:
        return np.full(len(starts), parameters.interval)
    later = starts + rounding(starts, starts[-1] - starts[0])
    breakpoints = sweep.block_breakpoints(k, later[0], later[-1])
    passed = np.searchsorted(breakpoints, later, side="right")
    return sweep.interval_of(k, later[0]) + passed


def _moved_to(jumps: ndarray, times: ndarray, run: float) -> ndarray:
    """Return times, of which those before a jump by rounding alone are moved to it."""
    k = np.searchsorted(jumps, times)
    following = np.append(jumps, np.inf)[k]
    is_next = following - times <= rounding(times, run)
    return np.where(is_next, following, times)


def _moved_back(jumps: ndarray, times: ndarray, run: float) -> ndarray:
    """Return jumps, of which those after a sample by rounding alone are moved to it."""
    k = np.searchsorted(times, jumps, side="right")
    before = times[k - 1]
    return np.where(jumps - before <= rounding(jumps, run), before, jumps)
