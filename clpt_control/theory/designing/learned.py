"""What the scenario's own law learns on a track: how soon, or how much of a measured current.

learning time   the first time from which on every flow parameter is within a level of theta
"""

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from ...scenario.experiment import Scenario
from ...simulation.flows import explained_variance
from ...simulation.integrate import sample_times, simulate

if TYPE_CHECKING:
    import xarray

LOOKS, MOST = 50, 20_000  # samples a waypoint for a smooth picture, and in all
TENTH = 0.1  # of the first error: the level without another


class Learned(NamedTuple):
    """A run, its largest flow-parameter error in time (None with a field), and a summary."""

    scenario: Scenario
    run: "xarray.Dataset"
    error: np.ndarray | None
    summary: dict[str, Any]


def learned(scenario: Scenario, level: float | None) -> Learned:
    """Run a scenario with its own law and say what it learned."""
    step = max(scenario.reference.dwell / LOOKS, scenario.run.duration / MOST)
    own = min(scenario.run.output_step, step)
    run = simulate(scenario, sample_times(scenario.run.duration, own))
    size = np.sum(run.clpe.values**2, axis=1)
    late = run.time.values >= 0.75 * scenario.run.duration
    summary: dict[str, Any] = {"clpe_rms_last_quarter": float(np.sqrt(size[late].mean()))}
    if scenario.flow.parameters is None:
        shares = explained_variance(scenario, run)
        summary["explained_variance"] = {key: shares[key] for key in ("track", "box")}
        return Learned(scenario, run, None, summary)
    theta = np.array(scenario.flow.parameters)
    error = np.abs(run.flow_parameters_estimate.values - theta).max(axis=(1, 2))
    level = TENTH * float(error[0]) if level is None else float(level)
    summary |= {
        "level": level,
        "learning_time": time_below(run.time.values, error, level),
        "error_at_end": float(error[-1]),
    }
    return Learned(scenario, run, error, summary)


def time_below(times: np.ndarray, values: np.ndarray, level: float) -> float | None:
    """Return the first sample from which on all values are at most a level; None: there is none."""
    above = np.flatnonzero(~(values <= level))
    if len(above) and above[-1] == len(values) - 1:
        return None
    return float(times[above[-1] + 1 if len(above) else 0])
