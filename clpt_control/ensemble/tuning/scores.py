"""How well a candidate learns flows that it was not told: medians over an ensemble.

missed   median of the largest flow-parameter error at the end, over the prior
astray   median CLPE rms over the last cycle, over prior/k, how far a flow of that size drives
score    missed + astray;  time: median until the error stays below a tenth of the prior
"""

from typing import NamedTuple

import numpy as np

from ..run import run_ensemble
from .candidates import Candidate
from .unknown import Unknown

ENOUGH = 1e-3  # less needs not be
TENTH = 0.1  # of the first error: it ends the learning time
MARKS = 200  # times at which errors are looked at
SAMPLES = 200  # a cycle


class Score(NamedTuple):
    """What one candidate reached over the members."""

    candidate: Candidate
    error: float  # median of the largest flow-parameter error at the end, length per time
    error_95: float  # 95 % of the members are below
    clpe: float  # median CLPE rms over the last cycle, length
    time: float  # median learning time; inf: not within the run
    score: float
    failed: int  # members that did not reach the end


def score_of(unknown: Unknown, candidate: Candidate, members: int, seed: int) -> Score:
    """Run a candidate on flows that are drawn, the same for every candidate."""
    scenario = unknown.scenario.with_values(candidate.values)
    marks = np.linspace(0.0, scenario.run.duration, MARKS + 1)
    data = run_ensemble(
        scenario, unknown.varies, members, seed=seed, samples=SAMPLES, times=marks.tolist()
    )
    failed = int(np.sum(data["status"].values != 1))
    error = data["flow_parameter_error"].values
    cycles = data["clpe_rms"].values
    clpe = cycles[:, -1] if cycles.shape[1] else data["clpe_rms_whole"].values
    last = np.where(np.isfinite(error[:, -1]), error[:, -1], np.inf)
    astray = np.where(np.isfinite(clpe), clpe, np.inf)
    times = [_below(data["mark"].values, row, TENTH * row[0]) for row in error]
    k = float(np.mean(scenario.vehicle.feedback))
    middle, rms = _middle(last), _middle(astray)
    shares = (middle / max(_middle(error[:, 0]), 1e-300), rms * k / unknown.prior)
    return Score(
        candidate,
        middle,
        _middle(last, 0.95),
        rms,
        _middle(np.array(times)),
        float(np.sqrt(np.prod(np.maximum(shares, ENOUGH)))),
        failed,
    )


def _middle(values: np.ndarray, share: float = 0.5) -> float:
    """Return a quantile of values that may be infinite."""
    return float(np.sort(values)[min(len(values) - 1, int(np.ceil(share * len(values)) - 1))])


def _below(times: np.ndarray, values: np.ndarray, level: float) -> float:
    """Return the first mark from which on all values are at most a level, or inf."""
    above = np.flatnonzero(~(values <= level))
    if not len(above):
        return float(times[0])
    return float(times[above[-1] + 1]) if above[-1] < len(times) - 1 else np.inf
