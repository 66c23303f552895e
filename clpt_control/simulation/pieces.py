"""A scenario's run in pieces, with the mean squares of its prediction error.

Mean squares are over 2000 samples a cycle, each 0.1 of the paper's cycle of 200, or a run that is
shorter; over more where there are many waypoints, or the time at each is long: CLPE peaks there for
a time of 1/KD.  A run of more than 200,000 samples goes on in pieces, so that memory does not grow
with samples that are used for mean squares alone.
"""

from collections.abc import Callable
from itertools import pairwise
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from ..blocks.localization import TRUE
from ..native.ending import Solution
from ..scenario.experiment import Scenario
from .flows import SpeedTimer
from .running import ScenarioRun

if TYPE_CHECKING:
    import xarray


PER_CYCLE = 2000  # samples, at least
AT_WAYPOINT = 100, 200, 500, 1000, 2000, 5000, 10_000  # samples, at least; each divides a piece
PER_TIME = 10  # samples in a time of 1/KD, as the paper's run has
PIECE = 100 * PER_CYCLE  # samples; a piece ends where a cycle does, or the time at a waypoint
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
        """Return how many times there are for each one in pictures, which show a piece at most."""
        return -(-self.last // PIECE)


def samples_for_means(scenario: Scenario) -> int:
    """Return the number of samples a cycle, or a run that is shorter, for mean squares."""
    end, dwell = min(scenario.cycle, scenario.run.duration), scenario.reference.dwell
    visited = int(np.ceil(end / dwell - 1e-9))
    wanted = PER_TIME * max(scenario.vehicle.feedback) * min(dwell, end) * (1 - 1e-9)
    each = next((count for count in AT_WAYPOINT if count >= wanted), AT_WAYPOINT[-1])
    return max(PER_CYCLE, each * visited)


def step_of_means(scenario: Scenario) -> float:
    """Return the time from one sample to the next for mean squares."""
    return min(scenario.cycle, scenario.run.duration) / samples_for_means(scenario)


def run_in_pieces(
    scenario: Scenario, required: np.ndarray, grid: Grid, progress: Callable[[float], None] | None
) -> "tuple[xarray.Dataset, dict[str, Any], SpeedTimer | None]":
    """Run a scenario; return it at times that are required or drawn, its CLPE and speeds."""
    run, pieces = ScenarioRun(scenario), list(pairwise([*range(0, grid.last, PIECE), grid.last]))
    group = 1 if len(pieces) == 1 else GROUP
    squares, parts = [], []
    x_z = [run.columns(TRUE) or run.columns("x"), run.columns("z")]
    timer = None if run.max_speed is None else SpeedTimer(run.max_speed)
    state, statistics = run.start, dict[str, int]()
    engines, methods = dict[str, None](), dict[str, None]()
    for first, last in pieces:
        numbers = np.arange(first, last + 1)
        even = grid.times(numbers)
        inside = required[(required >= even[0]) & (required <= even[-1])]
        times = union(inside, even)
        times[0], times[-1] = even[0], even[-1]
        solution = run.runner.run(state, times, progress=progress, **scenario.run.solver)
        state, signals = solution.x[-1], run.runner.signals(solution)
        for name, count in solution.statistics.items():
            statistics[name] = statistics.get(name, 0) + count
        final = last == grid.last or solution.status == "stopped"
        at = nearest(solution.t, even)
        pictured = at[numbers[: len(at)] % grid.every == 0]
        end = [len(solution.t) - 1]
        stored = np.unique(np.concatenate([nearest(solution.t, inside), pictured, end]))
        if not final:  # the next piece begins there
            at, stored = at[:-1], stored[:-1]
        x, z = (signals[at[:, None], places] for places in x_z)
        size = np.sum((x - z) ** 2, axis=1)
        if timer is not None:
            speeds = (signals[at[:, None], run.columns(port)] for port in ("v_c", "flow_x"))
            timer.add(solution.t[at], *speeds)
        starts = np.arange(0, len(at), group)
        counts = np.diff(np.append(starts, len(at)))
        squares.append((solution.t[at][starts], np.add.reduceat(size, starts), counts))
        parts.append((solution.t[stored], solution.x[stored], signals[stored]))
        engines[solution.engine] = methods[solution.method] = None
        if final:
            break
    t, states, signals = (np.concatenate(one) for one in zip(*parts, strict=True))
    ran = ", ".join(engines), ", ".join(methods)  # a long run may begin in Python
    whole = Solution(t, states, solution.status, solution.message, statistics, *ran)
    times, sums, counts = (np.concatenate(one) for one in zip(*squares, strict=True))
    return run.dataset(whole, signals), clpe_rms(scenario, times, sums, counts), timer


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


def starts_of_rounds(times: np.ndarray, cycle: float) -> np.ndarray:
    """Return where rounds of the waypoints start; the last one has just begun."""
    slack = 1e-9 * max(1.0, float(times[-1]))
    return np.flatnonzero(np.diff(np.floor((times + slack) / cycle), prepend=-1.0))


def clpe_rms(
    scenario: Scenario, times: np.ndarray, squares: np.ndarray, counts: np.ndarray
) -> dict[str, Any]:
    """Return roots of mean squares: of each round from t = 0 on, of all, of the last quarter.

    `squares` are sums of so many |e|^2, `counts`, from each time on.
    """
    first, end = float(times[0]), float(times[-1])
    slack = 1e-9 * max(1.0, end)
    starts = starts_of_rounds(times, scenario.cycle)
    rounds = pairwise(starts if first <= slack else [])
    late = int(np.searchsorted(times, first + 0.75 * (end - first) - slack))
    spans = {"clpe_rms": slice(None), "clpe_rms_last_quarter": slice(late, None)}

    def rms(of: slice) -> float:
        return float(np.sqrt(squares[of].sum() / counts[of].sum()))

    return {
        "clpe_rms_per_cycle": [rms(slice(*one)) for one in rounds],
        **{name: rms(of) for name, of in spans.items()},
    }


def clpe_of_samples(scenario: Scenario, run: "xarray.Dataset") -> dict[str, Any]:
    """Return roots of mean squares over the samples of a vehicle's run."""
    squares = ((run.position - run.predicted_position).values ** 2).sum(-1)
    return clpe_rms(scenario, run.time.values, squares, np.ones(len(squares)))
