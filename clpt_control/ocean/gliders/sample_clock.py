"""A clock of samples that was set back under water.

The receiver times the fixes, a clock of the vehicle the samples.  If that clock is set back, the
samples after it have times that were there before: sorted by time, two parts of a dive, or two
dives, are mixed.  The order of the rows still tells which came first.

A clock was set back where, from one row under water to the next, time falls by more than `LEAST`,
the depth goes on, and times rise on both sides.  From there on the fall and one usual step are
added to the times, until a fix whose own time agrees with the clock again.
"""

from math import nan

import numpy as np
import pandas

from ...base.errors import DataError
from .dives import LEAST_DEPTH

LEAST = 60.0  # s: rows of two instruments may be exchanged by less
DEEPER = 10.0  # m from one sample to the next, more than they usually differ
USUAL = 5.0  # times the usual step that a step beside the fall may have
MOST = 5  # falls; a file with more of them is not in order of time


def set_back(time: np.ndarray, depth: np.ndarray, fix: np.ndarray) -> list[int]:
    """Return the rows at which a clock was set back; `fix` are times of fixes, NaN elsewhere.

    >>> time = np.array([9000.0, 9060, 9120, 9180, 5640, 5700, 5760])
    >>> set_back(time, np.array([0.0, 10, 20, 30, 40, 30, 20]), np.full(7, nan))
    [4]
    """
    rows = np.flatnonzero(np.isfinite(time) & (depth > LEAST_DEPTH))
    if rows.size < 4:
        return []
    step, sink = np.diff(time[rows]), np.abs(np.diff(depth[rows]))
    if not (step > 0).any():
        return []
    usual = USUAL * np.median(step[step > 0])
    is_usual = (step > 0) & (step <= usual)
    fixes_before = np.cumsum(np.isfinite(fix))[rows]
    falls = np.flatnonzero(step < -max(LEAST, usual))
    set_back_rows = [
        int(rows[k + 1])
        for k in falls
        if 0 < k < step.size - 1
        and is_usual[k - 1]
        and is_usual[k + 1]
        and sink[k] <= DEEPER + 2 * np.median(sink)
        and fixes_before[k] == fixes_before[k + 1]
    ]
    return set_back_rows if len(falls) <= MOST else []


def with_steady_clock(of: pandas.DataFrame, fix_clock: str) -> pandas.DataFrame:
    """Return columns of an OG1 file with a steady `time`, and in `behind` what was added, s.

    `fix_clock` is the name of the times of the fixes, which must not be those of the samples.
    """
    time, depth, fix = (of[name].to_numpy(float) for name in ("time", "depth", "t_fix"))
    afloat = of.lat.notna().to_numpy() & ~(depth > LEAST_DEPTH)
    fix = np.where(afloat, fix, nan)
    behind = np.zeros(time.size)
    for row in set_back(time, depth, fix):
        before = time[:row][np.isfinite(time[:row])]
        late = float(before[-1] - time[row] + np.median(np.abs(np.diff(before))))
        if fix_clock.upper() == "TIME":
            raise DataError(
                f"TIME falls by {late:.0f} s in row {row} (from 0), under water, and has the fixes "
                "too. Correct it there, or give the receiver's times of the fixes in TIME_GPS"
            )
        until = time.size
        for k in row + np.flatnonzero(np.isfinite(fix[row:]) & np.isfinite(time[row:])):
            if abs(time[k] - fix[k]) < abs(time[k] + behind[k] + late - fix[k]):
                until = int(k)
                break
        behind[row:until] += late
    return of.assign(time=time + behind, behind=behind)
