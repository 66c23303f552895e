"""Positions of a log that carry no measurement, and so are no fixes.

With d the displacement over ground between two rows of a log, w that through the water and q the
resolution of the places, a position is

    held          where it stays within 3 m of the last fix while the vehicle moves, and then jumps
    reckoned      where d = w to (0.02 m + |w|/1000 + q): the vehicle's own motion, with jumps at fixes
    interpolated  where it lies within (0.02 m + q) of a straight line at one velocity

The receiver of a vehicle that keeps its place, drifts in a uniform current or is moored has noise of
some metres, so that two positions agree that well by chance only.  So many in a row are asked for
that even a noise of 2 m shows them less often than once in 1e7.  Without noise, as in a simulation,
the vehicle's own motion explains the bends of the lines, and no jump follows.
"""

from itertools import pairwise
from math import ceil, inf, log

import numpy as np

from ...base.geodesy import displacement
from .dives import STALE

KINDS = ("held", "reckoned", "interpolated")
JITTER = 3.0  # m, of a place that is held
EXACT = 0.02  # m, in sums of stretches and in a straight line
QUIETEST = 2.0  # m, noise of a fix on each axis, the smallest
RARE = 1e-7  # chance that fixes with that noise agree
PER_DEGREE = 111e3  # m


def unmeasured(time: np.ndarray, places: np.ndarray, ways: np.ndarray) -> np.ndarray:
    """Return the kind of each position (n,), "" for a fix.

    `places` (n, 2) are degrees north and east, `ways` (n, 2) the sum of the displacements through
    the water until each, m, whose differences are NaN where they are not known.
    """
    kinds = np.full(len(time), "", dtype=object)
    if len(time) < 3:
        return kinds
    q = _resolution(places)
    held = _held(time, places, ways, q)
    kinds[held] = KINDS[0]
    left = np.flatnonzero(~held)
    reckoned = _reckoned(places[left], ways[left], q)
    kinds[left[reckoned]] = KINDS[1]
    left = left[~reckoned]
    kinds[left[_interpolated(time[left], places[left], ways[left], q)]] = KINDS[2]
    return kinds


def told(kinds: np.ndarray) -> str:
    """Return how many positions of which kind are left out, empty if none is.

    >>> told(np.array(["", "held", "held", "reckoned"]))
    'positions of 3 rows are no fixes and are left out: 2 held, 1 reckoned'
    """
    counts = {kind: int(np.sum(kinds == kind)) for kind in KINDS}
    listing = ", ".join(f"{count} {kind}" for kind, count in counts.items() if count)
    return (
        f"positions of {sum(counts.values())} rows are no fixes and are left out: {listing}"
        if listing
        else ""
    )


def _resolution(places: np.ndarray) -> float:
    """Return the resolution of places (m): that of decimals of degrees or of minutes."""
    for scale in sorted(
        10.0**digits * parts for digits in range(8) for parts in (1, 60)
    ):
        scaled = places * scale
        if np.all(np.abs(scaled - np.round(scaled)) < 1e-3):
            return PER_DEGREE / scale
    return 0.0


def _least(within: float, variance: float) -> float:
    """Return how many deviations in a row, of two normal axes, are not within a distance."""
    chance = -np.expm1(-(within**2) / (2 * variance))
    return max(2, ceil(log(RARE) / log(chance))) if chance < 1.0 else inf


def _moved(places: np.ndarray) -> np.ndarray:
    """Return the displacements over ground between rows, (n - 1, 2), m."""
    return np.array([displacement(*a, *b) for a, b in pairwise(places)])


def _runs(true: np.ndarray) -> list[tuple[int, int]]:
    """Return begin and end of each run of true values."""
    edges = np.flatnonzero(np.diff(np.r_[False, true, False].astype(int)))
    return [*zip(edges[::2].tolist(), edges[1::2].tolist(), strict=True)]


def _held(
    time: np.ndarray, places: np.ndarray, ways: np.ndarray, q: float
) -> np.ndarray:
    """Return whether each position is the last fix held, though the vehicle moved.

    One that keeps its place shows one flow while it does and after it; the jump after a place that
    is held shows another.
    """
    held = np.zeros(len(time), bool)
    begin = 0
    for k in range(1, len(time) + 1):
        if k < len(time) and np.hypot(*displacement(*places[begin], *places[k])) <= (
            JITTER
        ):
            continue
        moved = ways[k - 1] - ways[begin]
        span = time[k - 1] - time[begin]
        repeats = q < JITTER and bool(np.all(places[begin:k] == places[begin]))
        least, slack = (STALE, q) if repeats else (10 * JITTER, 10 * JITTER + 3 * q)
        if k - 1 > begin and span > 0 and np.isfinite(moved).all():
            jump = np.full(2, inf if repeats else 0.0)  # at the end of the log
            if k < len(time):
                jump = np.array(displacement(*places[begin], *places[k]))
                jump -= ways[k] - ways[k - 1] - moved * (time[k] - time[k - 1]) / span
            farthest = np.hypot(*(ways[begin:k] - ways[begin]).T).max()
            if farthest > least and not np.hypot(*jump) <= 0.5 * farthest + slack:
                held[begin + 1 : k] = True
        begin = k
    return held


def _reckoned(places: np.ndarray, ways: np.ndarray, q: float) -> np.ndarray:
    """Return whether each position follows the motion through the water from the row before."""
    steps, moved = np.diff(ways, axis=0), _moved(places)
    size = np.hypot(*steps.T)
    off = np.hypot(*(moved - steps).T)
    within = np.minimum(EXACT + 1e-3 * size, 0.3) + 0.75 * q
    agrees = (off <= within) & (size > STALE)
    known = within[np.isfinite(within)]
    least = _least(float(np.median(known)) if known.size else inf, 2 * QUIETEST**2)
    reckoned = np.zeros(len(places), bool)
    jumps = 0
    for begin, end in _runs(agrees):
        if end - begin >= least:
            reckoned[begin + 1 : end + 1] = True
            jumps += end < len(off) and off[end] > 10 * within[end]
    return reckoned if jumps > 1 else np.zeros(len(places), bool)


def _interpolated(
    time: np.ndarray, places: np.ndarray, ways: np.ndarray, q: float
) -> np.ndarray:
    """Return whether each position is on a straight line at one velocity between others."""
    none = np.zeros(len(time), bool)
    if len(time) < 4:
        return none
    spans = np.diff(time)[:, None]
    size = PER_DEGREE * np.array([1.0, np.cos(np.radians(places[:, 0].mean()))])
    ground = np.diff(np.unwrap(places, axis=0, period=360.0), axis=0) * size
    steps = np.nan_to_num(np.diff(ways, axis=0))

    def bends(moved: np.ndarray) -> np.ndarray:
        velocity = moved / spans
        weight = spans[1:] * spans[:-1] / (spans[1:] + spans[:-1])
        return np.hypot(*((velocity[1:] - velocity[:-1]) * weight).T)

    within = EXACT + q
    straight = bends(ground) <= within
    unexplained = bends(ground - steps) > 5 * within
    least = _least(within, 1.5 * QUIETEST**2)
    inner, ends = none.copy(), []
    for begin, end in _runs(straight):
        if end - begin >= least:
            inner[begin + 1 : end + 1] = True
            ends += [k for k in (begin - 1, end) if 0 <= k < len(straight)]
    is_shown = len(ends) > 1 and np.mean(unexplained[ends]) > 0.5
    return inner if is_shown else none
