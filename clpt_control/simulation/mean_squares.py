"""Mean squares of a run's prediction error: at which samples, and over which rounds.

They are over 2000 samples a cycle, each 0.1 of the paper's cycle of 200, or a run that is shorter;
over more where there are many waypoints, or the time at each is long: CLPE peaks there for a time
of 1/KD.  Of a run that would have more than 200,000 they are over fewer, by a step that divides no
time at a waypoint: samples lie at all times after a switch, so that the mean stays right.
"""

from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np

from ..paper.scenario.experiment import Scenario

if TYPE_CHECKING:
    import xarray

PER_CYCLE = 2000  # samples, at least
AT_WAYPOINT = 100, 10_000  # samples, at least and at most
PER_TIME = 10  # samples in a time of 1/KD, as the paper's run has
MOST = 200_000  # samples of a run
# its multiples are spread evenly over any time at a waypoint
APART = np.sqrt(5.0) - 1.0


def samples_for_means(scenario: Scenario) -> int:
    """Return the number of samples a cycle, or a run that is shorter, for mean squares."""
    end, dwell = min(scenario.cycle, scenario.run.duration), scenario.reference.dwell
    wanted = PER_TIME * max(scenario.vehicle.feedback) * min(dwell, end) * (1 - 1e-9)
    each, visited = np.ceil(np.clip(wanted, *AT_WAYPOINT)), np.ceil(end / dwell - 1e-9)
    return max(PER_CYCLE, int(each * visited))


def step_of_means(scenario: Scenario, most: int = MOST) -> float:
    """Return the time from one sample to the next for mean squares, in a run of `most` samples."""
    end = scenario.run.duration
    step = min(scenario.cycle, end) / samples_for_means(scenario)
    return step if end <= step * most * (1 + 1e-9) else APART * end / most


def union(*several: np.ndarray) -> np.ndarray:
    """Return the sorted times of all; of those that differ by rounding the first."""
    every = np.sort(np.concatenate(several))
    return every[np.append(True, np.diff(every) > 1e-9 * max(1.0, float(every[-1])))]


def nearest(times: np.ndarray, wanted: np.ndarray) -> np.ndarray:
    """Return where increasing times are nearest to those wanted, up to the last."""
    wanted = wanted[wanted <= times[-1] * (1 + 1e-12)]
    after = np.clip(np.searchsorted(times, wanted), 1, len(times) - 1)
    return np.where(wanted - times[after - 1] < times[after] - wanted, after - 1, after)


def starts_of_rounds(times: np.ndarray, cycle: float) -> np.ndarray:
    """Return where rounds of the waypoints start; the last one has just begun."""
    slack = 1e-9 * max(1.0, float(times[-1]))
    return np.flatnonzero(np.diff(np.floor((times + slack) / cycle), prepend=-1.0))


def clpe_of_samples(scenario: Scenario, run: "xarray.Dataset") -> dict[str, Any]:
    """Return rms of CLPE over samples: of each round from t = 0 on, of all, of the last quarter."""
    times = run.time.values
    squares = ((run.position - run.predicted_position).values ** 2).sum(-1)
    first, end = float(times[0]), float(times[-1])
    slack = 1e-9 * max(1.0, end)
    rounds = pairwise(starts_of_rounds(times, scenario.cycle) if first <= slack else [])
    late = int(np.searchsorted(times, first + 0.75 * (end - first) - slack))
    return {
        "clpe_rms_per_cycle": [_rms(squares[a:b]) for a, b in rounds],
        "clpe_rms": _rms(squares),
        "clpe_rms_last_quarter": _rms(squares[late:]),
    }


def _rms(squares: np.ndarray) -> float:
    return float(np.sqrt(squares.mean()))
