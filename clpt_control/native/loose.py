"""Runs in Python at loose tolerances: Dormand and Prince's method of order 5, as python-control's.

There a step of order 8 costs more evaluations than it saves.  A run stops where a block jumps in
time and where a sampled input turns sharply; smaller bends, as of a sampled sine, are smooth to the
tolerance.
"""

from bisect import bisect_right
from collections.abc import Callable

import numpy as np

from ..progress.interrupt import check
from .inputs import Inputs
from .sweep import Sweep

LOOSE = 1e-7  # rtol from which on it pays
SHARP = 10.0  # a turn is sharp that is so many times as sharp as most
FELT = 200.0  # and one that is so many tolerances of the input, off the line before it
MOST = 100_000  # steps
PAUSE = 50  # steps
LATE, SHARE = 2_000, 0.05  # after so many steps a run that has come no further is left to others


def loosely(
    sweep: Sweep,
    start: np.ndarray,
    times: np.ndarray,
    tolerances: tuple[float, float],
    inputs: Inputs | None,
    progress: Callable[[float], None] | None,
) -> tuple[np.ndarray, dict[str, int]] | None:
    """Return states at times, and the numbers of steps, evaluations and restarts.

    None where it cannot go on: whoever finds out why begins again.
    """
    from scipy.integrate import RK45

    out, done, wanted = np.empty((len(times), len(start))), 1, times.tolist()
    counts = dict.fromkeys(("steps", "evaluations", "restarts"), 0)
    t, x, at = wanted[0], start, None if inputs is None else inputs.at
    out[0], step = start, None  # the first is found by trial

    def rates(t: float, x: np.ndarray) -> np.ndarray:
        return sweep.rates(t, x, None if at is None else at(t))

    with np.errstate(all="ignore"):
        for end in stops(sweep, wanted[0], wanted[-1], inputs, tolerances[0]):
            sweep.enter(t)
            first = None if step is None else min(step, end - t)
            run = RK45(rates, t, x, end, first_step=first, rtol=tolerances[0], atol=tolerances[1])
            while run.status == "running":
                run.step()
                counts["steps"] += 1
                if counts["steps"] % PAUSE == 0:
                    check()
                    if counts["steps"] == LATE and run.t - wanted[0] < SHARE * (
                        wanted[-1] - wanted[0]
                    ):
                        return None
                    if progress is not None:
                        progress(run.t)
                reached = bisect_right(wanted, run.t)
                if run.status == "failed" or counts["steps"] > MOST:
                    return None
                if reached > done:
                    out[done:reached] = run.dense_output()(times[done:reached]).T
                    done = reached
            counts["evaluations"] += run.nfev
            counts["restarts"] += 1
            t, x, step = run.t, run.y, run.h_abs
            if done and wanted[done - 1] == t:
                out[done - 1] = x
    return (out, counts) if np.all(np.isfinite(out)) else None


def stops(sweep: Sweep, t0: float, t1: float, inputs: Inputs | None, rtol: float) -> list[float]:
    """Return where a run stops, up to its end."""
    found = set(sweep.breakpoints(t0, t1).tolist())
    if inputs is not None and inputs.samples is not None:
        found.update(sharp(*inputs.samples, rtol).tolist())
    return [*sorted(t for t in found if t0 < t < t1), t1]


def sharp(times: np.ndarray, values: np.ndarray, rtol: float) -> np.ndarray:
    """Return the times at which samples, joined by straight lines, turn sharply."""
    if len(times) < 3:
        return times[:0]
    spans, size = times[1:] - times[:-1], np.max(np.abs(values), axis=1, keepdims=True)
    slopes = (values[:, 1:] - values[:, :-1]) / spans
    turns = np.abs(slopes[:, 1:] - slopes[:, :-1])
    rounding = 1e-12 * np.max(np.abs(slopes), axis=1, keepdims=True)
    sharper = turns > SHARP * np.median(turns, axis=1, keepdims=True) + rounding
    felt = turns * np.minimum(spans[1:], spans[:-1]) > FELT * rtol * size + 1e-12 * size
    return times[1:-1][np.any(sharper | felt, axis=0)]
