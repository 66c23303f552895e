"""At which times an ensemble looks at its members."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from ..errors import ScenarioError
from ..scenario.experiment import Scenario
from ..simulation.integrate import sample_times
from ..simulation.report import SAMPLES_PER_CYCLE, nearest

FEWEST = 20  # samples a cycle that may be asked for
MOST_TIMES = 10**8  # samples of a run
MOST_SAMPLES = 20_000  # a member, unless asked for; at least 200 a cycle
MARKS = 41  # times at which errors are kept, unless asked for


class Sampling(NamedTuple):
    """Times of the states, and which of them serve what.

    Attributes
    ----------
    times : ndarray
        All times, increasing from 0 to the end.
    fine : ndarray of int
        Evenly spaced ones, for mean squares.
    starts : ndarray of int
        Where in `fine` each full cycle starts, and where the last one ends.
    marks : ndarray of int
        Those at which errors are kept.
    own : ndarray of int
        The scenario's own, for trajectories; empty without them.
    """

    times: np.ndarray
    fine: np.ndarray
    starts: np.ndarray
    marks: np.ndarray
    own: np.ndarray


def samples_per_cycle(scenario: Scenario, samples: int | None = None) -> int:
    """Return how many samples a cycle mean squares are taken over.

    Without a wish 2000, as in `clpt run`, up to ten cycles; fewer in longer
    runs, but at least 200.

    Parameters
    ----------
    scenario : Scenario
        The base.
    samples : int, optional
        A wish.

    Returns
    -------
    int
        Samples a cycle.

    Raises
    ------
    ScenarioError
        If the wish is not a whole number of at least 20, or too many for a run.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> samples_per_cycle(clpt.paper_scenario())
    2000
    """
    if samples is None:
        cycles = scenario.run.duration / scenario.cycle
        return min(SAMPLES_PER_CYCLE, max(200, int(MOST_SAMPLES / max(cycles, 1))))
    if not isinstance(samples, int) or isinstance(samples, bool) or samples < FEWEST:
        raise ScenarioError(f"samples = {samples}: must be a whole number, at least {FEWEST}")
    if samples * max(1.0, scenario.run.duration / scenario.cycle) > MOST_TIMES:
        raise ScenarioError(f"samples = {samples}: more than {MOST_TIMES:.0e} in a run; take fewer")
    return samples


def marks_of(scenario: Scenario, times: Sequence[float] | None = None) -> tuple[float, ...]:
    """Return the times at which errors are kept; the end is one.

    Parameters
    ----------
    scenario : Scenario
        The base.
    times : sequence of float, optional
        A wish; 41 evenly spaced ones without.

    Returns
    -------
    tuple of float
        Increasing.

    Raises
    ------
    ScenarioError
        If a time lies outside the run.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> marks_of(clpt.paper_scenario(), [100.0, 200.0])
    (100.0, 200.0, 2000.0)
    """
    end = scenario.run.duration
    if times is None:
        return tuple(np.linspace(0.0, end, MARKS).tolist())
    for time in times:
        if not 0 <= time <= end:
            raise ScenarioError(f"times: {time} must lie between 0 and run.duration = {end}")
    return tuple(sorted({float(time) for time in times} | {end}))


def sampling(
    scenario: Scenario, samples: int, marks: Sequence[float], trajectories: bool
) -> Sampling:
    """Join the times that are wanted.

    Parameters
    ----------
    scenario : Scenario
        The base.
    samples : int
        A cycle.
    marks : sequence of float
        As `marks_of` gives them.
    trajectories : bool
        Whether the scenario's own samples are kept too.

    Returns
    -------
    Sampling
        Times that differ by rounding are one time.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> scenario = clpt.paper_scenario().with_values({"run.duration": 400})
    >>> sampling(scenario, 200, (0.0, 400.0), False).starts
    array([  0, 200, 400])
    """
    end, cycle = scenario.run.duration, scenario.cycle
    fine = sample_times(end, cycle / samples)
    own = sample_times(end, scenario.run.output_step) if trajectories else np.zeros(0)
    every = np.sort(np.concatenate([fine, np.array(marks, dtype=float), own]))
    slack = 1e-9 * max(1.0, end)
    times = every[np.append(True, np.diff(every) > slack)]
    times[-1] = end
    number = np.floor((fine + slack) / cycle).astype(int)
    full = int(np.floor((end + slack) / cycle))
    starts = np.searchsorted(number, np.arange(full + 1))
    return Sampling(
        times, nearest(times, fine), starts, nearest(times, np.array(marks)), nearest(times, own)
    )
