"""A long run piece by piece: sums of squares, and the samples that are asked for.

Mean squares are over 2000 samples a cycle, each 0.1 of the paper's cycle of 200.  A run of
more than 100 cycles goes on in pieces of 100 cycles, of which nothing else is kept, so
that memory does not grow with samples that nobody sees.
"""

from collections.abc import Callable
from itertools import pairwise
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from ..native.ending import Solution
from ..scenario.experiment import Scenario
from .scenario_run import ScenarioRun, SpeedWatch

if TYPE_CHECKING:
    import xarray

SAMPLES_PER_CYCLE = 2000
PIECE = 100 * SAMPLES_PER_CYCLE  # samples; a piece ends where a cycle does, at a breakpoint
GROUP = 100  # samples summed together where there are several pieces


class Grid(NamedTuple):
    """Evenly spaced times from 0 to the end, by number, without holding them all."""

    step: float
    end: float
    last: int  # the number of the end

    @classmethod
    def to(cls, end: float, step: float) -> "Grid":
        """Return the grid whose times are those of `sample_times`."""
        last = int(np.floor(end / step * (1 + 1e-12)))
        return cls(step, end, last if last * step >= end * (1 - 1e-12) else last + 1)

    def times(self, numbers: np.ndarray) -> np.ndarray:
        """Return the times of some numbers."""
        return np.where(numbers < self.last, self.step * numbers, self.end)

    @property
    def every(self) -> int:
        """Return which of the times pictures show: one of so many, at most a piece's number."""
        return -(-self.last // PIECE)


class Squares(NamedTuple):
    """Sums of |e|^2 over groups of evenly spaced samples."""

    sums: np.ndarray
    counts: np.ndarray
    group: int  # samples

    def rms(self, first: int = 0, last: int | None = None) -> float:
        """Return the rms of |e| from sample `first` up to `last`, to the group."""
        span = slice(first // self.group, None if last is None else last // self.group)
        return float(np.sqrt(self.sums[span].sum() / self.counts[span].sum()))


def run_in_pieces(
    scenario: Scenario, kept: np.ndarray, grid: Grid, progress: Callable[[float], None] | None
) -> "tuple[xarray.Dataset, Squares, SpeedWatch | None]":
    """Run a scenario; return it at the times that are kept or shown, its squares and speeds."""
    run, pieces = ScenarioRun(scenario), list(pairwise([*range(0, grid.last, PIECE), grid.last]))
    group = 1 if len(pieces) == 1 else GROUP
    sums, counts, parts, z = [], [], [], run.columns("z")
    watch = None if run.max_speed is None else SpeedWatch(run.max_speed)
    state, statistics = run.start, dict[str, int]()
    engines, methods = dict[str, None](), dict[str, None]()
    for first, last in pieces:
        numbers = np.arange(first, last + 1)
        even = grid.times(numbers)
        inside = kept[(kept >= even[0]) & (kept <= even[-1])]
        times = union(inside, even)
        times[0], times[-1] = even[0], even[-1]
        solution = run.integrate(state, times, progress)
        state, signals = solution.x[-1], run.signals(solution)
        for name, count in solution.statistics.items():
            statistics[name] = statistics.get(name, 0) + count
        final = last == grid.last or solution.status == "stopped"
        at = nearest(solution.t, even)
        shown = at[numbers[: len(at)] % grid.every == 0]
        end = [len(solution.t) - 1]
        held = np.unique(np.concatenate([nearest(solution.t, inside), shown, end]))
        if not final:  # the next piece begins there
            at, held = at[:-1], held[:-1]
        squares = np.sum((run.true_position(signals[at]) - signals[at][:, z]) ** 2, axis=1)
        if watch is not None:
            speeds = (signals[at][:, run.columns(port)] for port in ("v_c", "flow_x"))
            watch.add(solution.t[at], *speeds)
        starts = np.arange(0, len(at), group)
        sums.append(np.add.reduceat(squares, starts))
        counts.append(np.diff(np.append(starts, len(at))))
        parts.append((solution.t[held], solution.x[held], signals[held]))
        engines[solution.engine] = methods[solution.method] = None
        if final:
            break
    t, x, signals = (np.concatenate(one) for one in zip(*parts, strict=True))
    ran = ", ".join(engines), ", ".join(methods)  # a long run may begin in Python
    joined = Solution(t, x, solution.status, solution.message, statistics, *ran)
    squared = Squares(np.concatenate(sums), np.concatenate(counts), group)
    return run.dataset(joined, signals), squared, watch


def union(first: np.ndarray, more: np.ndarray) -> np.ndarray:
    """Return sorted times of both; where two differ by rounding, the one of `first`."""
    if not len(first):
        return more
    after = np.searchsorted(first, more)
    sides = [first[np.clip(after - k, 0, len(first) - 1)] for k in (0, 1)]
    distance = np.abs(np.array(sides) - more).min(axis=0)
    return np.union1d(first, more[distance > 1e-9 * max(1.0, float(first[-1]))])


def nearest(times: np.ndarray, wanted: np.ndarray) -> np.ndarray:
    """Return where increasing times are nearest to those wanted, up to the last."""
    wanted = wanted[wanted <= times[-1] * (1 + 1e-12)]
    after = np.clip(np.searchsorted(times, wanted), 1, len(times) - 1)
    return np.where(wanted - times[after - 1] < times[after] - wanted, after - 1, after)
