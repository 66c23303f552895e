"""Mean squares of a run's prediction error: sample times, rounds of waypoints, and rms values.

Samples are even in time: 2000 in each cycle, or in a run that is shorter, as each 0.1 of the
paper's cycle of 200.  There are more for many waypoints or long times at them, since CLPE peaks
there for a time of 1/KD, and at most 200,000 in a run.  The step of such a long run divides no time
at a waypoint, so that samples are at all phases after a switch and the mean is unbiased.
"""

from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np

from ..paper.scenario.experiment import Scenario

if TYPE_CHECKING:
    import xarray

SAMPLES_PER_CYCLE = 2000  # at least
SAMPLES_PER_WAYPOINT = 100, 10_000  # at least, at most
SAMPLES_PER_DECAY = 10  # in a time of 1/KD, as in the paper's run
MAX_SAMPLES = 200_000  # of a run
# of the longest step: irrational, so that its multiples are spread over a time at a waypoint
STEP_FACTOR = np.sqrt(5.0) - 1.0


def samples_for_means(scenario: Scenario) -> int:
    """Return the number of samples of a cycle, or of a run that is shorter."""
    end = min(scenario.cycle, scenario.run.duration)
    dwell = scenario.reference.dwell
    decays = max(scenario.vehicle.feedback) * min(dwell, end) * (1 - 1e-9)
    samples = np.ceil(np.clip(SAMPLES_PER_DECAY * decays, *SAMPLES_PER_WAYPOINT))
    waypoints = np.ceil(end / dwell - 1e-9)
    return max(SAMPLES_PER_CYCLE, int(samples * waypoints))


def step_of_means(scenario: Scenario, max_samples: int = MAX_SAMPLES) -> float:
    """Return the time between samples for mean squares."""
    end = scenario.run.duration
    step = min(scenario.cycle, end) / samples_for_means(scenario)
    if end <= step * max_samples * (1 + 1e-9):
        return step
    return STEP_FACTOR * end / max_samples


def tolerance_of(times: np.ndarray) -> float:
    """Return a difference of times by rounding."""
    return 1e-9 * max(1.0, float(times[-1]))


def union(*series: np.ndarray) -> np.ndarray:
    """Return the sorted times of all series; times that differ by rounding are merged."""
    times = np.sort(np.concatenate(series))
    return times[np.append(True, np.diff(times) > tolerance_of(times))]


def nearest(times: np.ndarray, targets: np.ndarray) -> np.ndarray:
    """Return the indices of increasing times that are nearest to targets up to the last time."""
    from pandas import Index

    targets = targets[targets <= times[-1] * (1 + 1e-12)]
    return Index(times).get_indexer(targets, method="nearest")


def starts_of_rounds(times: np.ndarray, cycle: float) -> np.ndarray:
    """Return the indices at which rounds of the waypoints start, also the unfinished round."""
    rounds = np.floor((times + tolerance_of(times)) / cycle)
    return np.flatnonzero(np.diff(rounds, prepend=-1.0))


def clpe_of_samples(scenario: Scenario, run: "xarray.Dataset") -> dict[str, Any]:
    """Return the rms of CLPE over each round from t = 0 on, the run, and its last quarter."""
    times = run.time.values
    squares = ((run.position - run.predicted_position).values ** 2).sum(-1)
    tolerance = tolerance_of(times)
    starts: Any = []
    if times[0] <= tolerance:
        starts = starts_of_rounds(times, scenario.cycle)
    late = np.searchsorted(times, last_quarter(times) - tolerance)
    return {
        "clpe_rms_per_cycle": [*map(float, rms_of_rounds(squares, times, starts))],
        "clpe_rms": float(rms(squares, times)),
        "clpe_rms_last_quarter": float(rms(squares[late:], times[late:])),
    }


def last_quarter(times: np.ndarray) -> float:
    """Return the time at which the last quarter of a run begins."""
    return float(times[-1] - 0.25 * (times[-1] - times[0]))


def rms_of_rounds(
    squares: np.ndarray, times: np.ndarray, starts: np.ndarray
) -> list[Any]:
    """Return the rms over each round of the waypoints, along the last axis."""
    rounds = [slice(begin, end + 1) for begin, end in pairwise(starts)]
    return [rms(squares[..., samples], times[samples]) for samples in rounds]


def rms(squares: np.ndarray, times: np.ndarray) -> Any:
    """Return the root of the mean over time, by trapezoids, of squares along the last axis."""
    if len(times) == 1:
        return np.sqrt(squares[..., 0])
    return np.sqrt(np.trapezoid(squares, times) / (times[-1] - times[0]))
