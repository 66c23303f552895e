"""States of a run between its samples, by the steps of its own equations.

A run has samples, and a regressor W that is computed from them alone may be aliased.  So the
classical Runge-Kutta method goes from each sample to the next, in steps that are halved until
their ends settle.  The ends must be the next samples: then the run follows the equations there.
A cubic of each step has its states and rates at both ends.  Rates are evaluated within a step, so
they may jump at samples.
"""

from collections.abc import Callable
from typing import Any

import numpy as np
from scipy.interpolate import PPoly, interp1d

from ...base.errors import DataError

SAME = 1e-4  # share of a value by which a run may miss the equations in a window
TINY = 1e-8  # of a state: absolute tolerance of the steps of a run
EDGE = 1e-9  # of a step, by which rates are evaluated within it
LEAST_STEPS = 1000  # in a window
MOST_STEPS = 200_000
# times (n,), states (n, nx), inputs (nu, n) -> values (n, any)
Along = Callable[[np.ndarray, np.ndarray, np.ndarray], np.ndarray]


def states_between(
    rate: Along, regressor: Along, times: np.ndarray, x: np.ndarray, u: np.ndarray
) -> PPoly:
    """Return states as a function of time that samples x (n, nx), with inputs u (nu, n), follow.

    What `regressor` returns settles and is followed too, in shares of its largest value.
    """
    largest = np.abs(regressor(times, x, u)).max(initial=0.0)
    allowed = SAME * np.append(np.abs(x).max(axis=0) + TINY / SAME, largest)

    def off(x: np.ndarray, other: np.ndarray) -> np.ndarray:
        """Differences of states, and of W, at the samples but the first, summed."""
        ends = times[1:], u[:, 1:]
        W, other_W = (regressor(ends[0], at, ends[1]) for at in (x, other))
        of_W = np.abs(W - other_W).max(axis=(1, 2))
        return np.append(np.abs(x - other).sum(axis=0), of_W.sum())

    count = -(-LEAST_STEPS // (len(times) - 1))
    ends, _ = _steps(rate, times, x, u, count)
    while True:
        count *= 2
        before = ends
        ends, cubics = _steps(rate, times, x, u, count)
        change = off(ends, before)
        if np.all(change < allowed / 10) or 2 * count * len(times) > MOST_STEPS:
            break
    if not np.all(off(ends, x[1:]) <= 2 * change + allowed):
        raise DataError(
            "of: the run does not follow the equations of its diagram in the window, or its "
            "samples are too far apart. Give the run as it was simulated, with more times"
        )
    shares = np.arange(count) / count
    begins = times[:-1, None] + shares * np.diff(times)[:, None]
    return PPoly(cubics, np.append(begins, times[-1]))


def _steps(
    rate: Along, times: np.ndarray, x: np.ndarray, u: np.ndarray, count: int
) -> tuple[np.ndarray, Any]:
    """Return states at the end of `count` steps from each sample, and the steps' cubics."""
    h, signal = np.diff(times)[:, None] / count, interp1d(times, u)
    x, cubics = x[:-1], []
    for j in range(count):

        def at(share: float, x: np.ndarray, j: int = j) -> np.ndarray:
            t = times[:-1] + (j + np.clip(share, EDGE, 1 - EDGE)) * h[:, 0]
            return rate(t, x, signal(t))

        one = at(0.0, x)
        two = at(0.5, x + h / 2 * one)
        three = at(0.5, x + h / 2 * two)
        four = at(1.0, x + h * three)
        end = x + h / 6 * (one + 2 * two + 2 * three + four)
        last, mean = at(1.0, end), (end - x) / h
        cubics.append(
            [(one + last - 2 * mean) / h**2, (3 * mean - 2 * one - last) / h, one, x]
        )
        x = end
    return x, np.stack(cubics, axis=2).reshape(4, -1, x.shape[1])
