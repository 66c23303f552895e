"""States of a run as functions of time, in a window.

A regressor W that is computed from samples alone may be aliased.  So the diagram that ran is run
again, from its own start and with its own inputs and parameters, to times between the samples.  It
must meet them: then the run is one of this diagram in the window.  Cubics join the states, with
the rates at their ends from within, since rates may jump there; they are made shorter until W along
them is W at the states.
"""

from collections.abc import Callable
from itertools import chain
from typing import Any

import numpy as np
from scipy.interpolate import PPoly

from ...base.errors import DataError
from ...base.run_attributes import ARGUMENTS, DIAGRAM
from ...simulation.comparison import STATES
from ...simulation.diagram_runs import DiagramRun
from .transitions import OfTime

SAME = 1e-4  # share of a value by which a run may miss its diagram's
TINY = 1e-8  # of a state, which may be an error that has died out
SETTLED = 1e-5  # share of the largest W by which curves change it, on average
EDGE = 1e-9  # of a step, by which rates are evaluated within it
LEAST_STEPS, MOST_STEPS = 1000, 200_000  # in a window
# times (n,), states (n, nx), inputs (nu, n) -> values (n, ...)
Along = Callable[[np.ndarray, np.ndarray, np.ndarray], np.ndarray]


def samples_around(run: Any, start: float, end: float) -> Any:
    """Return the samples of a run in a window, with those next to its ends."""
    first = np.searchsorted(run.time, start, "right") - 1
    return run.isel(time=slice(max(0, first), np.searchsorted(run.time, end) + 1))


def states_along(
    run: Any, rate: Along, regressor: Along, start: float, end: float
) -> tuple[OfTime, float]:
    """Return states as a function of time in a window, and the integral of errors of W by it."""
    repeated, signal = _repeated(run), run.encoding[DIAGRAM].request.inputs.along
    run = samples_around(run, start, end)
    times, x = run.time.values, run[STATES].values
    W = regressor(times, x, signal(times))
    count = 2 * -(-LEAST_STEPS // (len(times) - 1))
    while True:
        shares = np.arange(count) / count
        t = np.append(times[:-1, None] + shares * np.diff(times)[:, None], times[-1])
        states = repeated(t)
        exact, middle, u = regressor(t, states, signal(t)), t[1::2], signal(t[1::2])
        largest = np.abs(exact).max()
        missed = np.abs(states[::count] - x).max(axis=0)
        follows = np.all(missed <= SAME * np.abs(x).max(axis=0) + TINY)
        if not (follows and np.abs(exact[::count] - W).max() <= SAME * largest):
            raise DataError(
                "of: the run does not follow the equations of its diagram in the window. Give the "
                "run as it was simulated, of the diagram as it was"
            )
        curves = _cubics(rate, signal, t[::2], states[::2])
        off = np.abs(regressor(middle, curves(middle), u) - exact[1::2])
        change = off.max(axis=(1, 2)).mean()
        if change <= SETTLED * largest:
            return curves, float(change * (end - start))
        if 4 * len(t) > MOST_STEPS:
            raise DataError(
                "of: W changes too fast along the run to be computed. Give a shorter window"
            )
        count *= 4


def _repeated(run: Any) -> OfTime:
    """Return states of the diagram of a run, which is run again, at times."""
    noted = run.encoding[DIAGRAM]
    request, engine = noted.request, run.encoding.get(ARGUMENTS, {}).get("engine")
    again = DiagramRun(request.diagram, noted.params, request.sizes, engine)
    numbers = chain(*again.runner.block_parameters)
    if not all(map(np.array_equal, numbers, chain(*noted.numbers))):
        raise DataError(
            "of: parameters of the diagram have changed since the run. Run it again"
        )

    def states(t: np.ndarray) -> np.ndarray:
        asked = np.union1d(request.times[0], t)
        solution, _ = again.solve(request._replace(times=asked), is_compared=False)
        return solution.x[-len(t) :]

    return states


def _cubics(rate: Along, signal: OfTime, t: np.ndarray, x: np.ndarray) -> PPoly:
    """Return the cubics that join states (n, nx) at times."""
    h = np.diff(t)[:, None]
    first, last = (
        rate(at, states, signal(at))
        for at, states in (
            (t[:-1] + EDGE * h[:, 0], x[:-1]),
            (t[1:] - EDGE * h[:, 0], x[1:]),
        )
    )
    mean = np.diff(x, axis=0) / h
    third = (first + last - 2 * mean) / h**2
    return PPoly([third, (3 * mean - 2 * first - last) / h, first, x[:-1]], t)
