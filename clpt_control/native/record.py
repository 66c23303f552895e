"""The signals of a diagram at the times of a solution."""

from collections.abc import Callable

import numpy as np

from .solution import Solution
from .sweep import Sweep


def sample_signals(sweep: Sweep, solution: Solution, u: Callable | None = None) -> np.ndarray:
    """Give all block outputs at a solution's times.

    Values at a jump are right limits.

    Parameters
    ----------
    sweep : Sweep
        The diagram.
    solution : Solution
        Times and states.
    u : callable, optional
        Inputs of the diagram as a function of time.

    Returns
    -------
    ndarray, shape (ntimes, nsignals)
        In the order of `Sweep.signals`.
    """
    times = solution.t
    signals = np.empty((len(times), len(sweep.signals)))
    jumps = sweep.breakpoints(times[0], times[-1])
    interval = np.searchsorted(jumps, times, side="right")
    for k, t in enumerate(times):
        if k == 0 or interval[k] != interval[k - 1]:
            sweep.enter(t)
        with np.errstate(all="ignore"):
            signals[k] = sweep.evaluate(t, solution.x[k], None if u is None else u(t))
    return signals
