"""Positions of a log that carry no measurement, and so are no fixes.

With d the displacement over ground between two rows of a log, w that through the water and q the
resolution of the positions, a position is

    held          where it stays within 3 m of the last fix while the vehicle moves, and then jumps
    reckoned      where d = w to (0.02 m + |w|/1000 + q): the vehicle's own motion, with jumps at fixes
    interpolated  where it lies within (0.02 m + q) of a straight line at one velocity; without the
                  vehicle's own motion such lines are reckoned if they end in jumps

The receiver of a vehicle that keeps its place, drifts in a uniform current or is moored has noise of
some metres, so that positions agree that well by chance only.  So many are asked for that even a
noise of 2 m shows them less often than once in 1e7.  Without noise, as in a simulation, the
vehicle's own motion explains the bends of the lines.

A vehicle that keeps its place goes on from it as its motion through the water says; one whose
position is held appears elsewhere.  Before that a position may be either: it is in doubt, and a
live estimator decides when it knows (`FlowEstimator.fix`).
"""

from itertools import pairwise
from math import ceil, log

import numpy as np

from ...base.geodesy import displacement

KINDS = ("held", "reckoned", "interpolated")
NO_FIX = "the position carries no measurement and is no fix"
DOUBT = (
    "the last positions repeat, or follow the vehicle's own motion: learned as fixes, unless later "
    "ones show that they are none"
)
JITTER = 3.0  # m, of a position that is held
MOVED = 0.1  # m that a vehicle moves at least
STAYS = 30.0  # m that one that keeps its place may seem to move
WANDERS = 100.0  # m that it moves at most, by noise and control
EXACT = 0.02  # m, in sums of stretches and in a straight line
QUIETEST = 2.0  # m, noise of a fix on each axis, the smallest
RARE, SELDOM = 1e-7, 1e-3  # chances that fixes with that noise agree
PER_DEGREE = 111e3  # m


def unmeasured(
    time: np.ndarray, positions: np.ndarray, steps: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Return the kind of each position (n,), "" for a fix, and whether a fix is in doubt.

    `positions` (n, 2) are degrees north and east, `steps` (n - 1,) the displacements through the
    water between them, east + i north in m, NaN where not known.
    """
    kinds = np.full(len(time), "", dtype=object)
    q = _resolution(positions)
    held, doubted = _repeats(time, positions, steps, q)
    kinds[held] = KINDS[0]

    def rest() -> tuple[np.ndarray, np.ndarray]:
        """Return the rows that are left, and the displacements between them."""
        kept = np.flatnonzero(kinds == "")
        return kept, np.add.reduceat(steps[: kept[-1]], kept[:-1]) if kept[
            1:
        ].size else steps[:0]

    kept, between = rest()
    follows, is_reckoned = _follows(positions[kept], between, q)
    if is_reckoned:
        kinds[kept[follows]] = KINDS[1]
    doubted[kept] |= follows
    kept, between = rest()
    inner, ends = _lines(time[kept], positions[kept], between, q)
    kinds[kept[inner]] = KINDS[2]
    kinds[kept[ends]] = KINDS[1]
    return kinds, doubted & (kinds == "")


def counted(kinds: np.ndarray) -> str:
    """Return how many positions of which kind are left out, empty if none is.

    >>> counted(np.array(["", "held", "held", "reckoned"]))
    'positions of 3 rows are no fixes and are left out: 2 held, 1 reckoned'
    """
    counts = {kind: int(np.sum(kinds == kind)) for kind in KINDS}
    listing = ", ".join(f"{count} {kind}" for kind, count in counts.items() if count)
    rows = sum(counts.values())
    text = f"positions of {rows} rows are no fixes and are left out: {listing}"
    return text if rows else ""


def _resolution(positions: np.ndarray) -> float:
    """Return the resolution of positions (m): that of decimals of degrees or of minutes."""
    for scale in sorted(
        10.0**digits * parts for digits in range(8) for parts in (1, 60)
    ):
        scaled = positions * scale
        if np.all(np.abs(scaled - np.round(scaled)) < 6e-9 * scale):
            return PER_DEGREE / scale
    return 0.0


def _is_shown(agrees: np.ndarray, within: float, variance: float) -> bool:
    """Return whether deviations of two normal axes are within a distance too often for chance."""
    chance = -np.expm1(-(within**2) / (2 * variance)) + 1e-300
    fewest = max(2, ceil(log(RARE) / log(chance))) if chance < 0.5 else len(agrees)
    return bool(np.sum(agrees) >= fewest + 2 * chance * len(agrees))


def _moved(positions: np.ndarray) -> np.ndarray:
    """Return the displacements over ground between rows, (n - 1,), m."""
    moved = [complex(*displacement(*a, *b)) for a, b in pairwise(positions)]
    return np.array(moved, dtype=complex)


def _repeats(
    time: np.ndarray, positions: np.ndarray, steps: np.ndarray, q: float
) -> tuple[np.ndarray, np.ndarray]:
    """Return whether each position is the last fix held, and whether it may be."""
    held, doubted = np.zeros((2, len(time)), bool)
    jumps: list[bool] = []
    begin = 0
    for k in range(1, len(time) + 1):
        is_last = k == len(time)
        jump = 0j if is_last else _moved(positions[[begin, k]])[0]
        if not is_last and abs(jump) <= JITTER:
            continue
        if k == begin + 1:
            begin = k
            continue
        # a run of positions near that of `begin`
        water = np.cumsum(steps[begin : k - 1])
        farthest = np.max(np.abs(water), initial=0.0)  # NaN if not known
        chance = q * q / (4 * np.pi * QUIETEST**2)
        is_exact = np.all(positions[begin:k] == positions[begin])
        is_held = bool(is_exact and chance < 1 and chance ** len(water) < SELDOM)
        doubted[begin + 1 : k] = farthest > MOVED
        if farthest > (MOVED + 1.5 * q if is_held else STAYS + 3 * q):
            if not is_last:
                share = (time[k] - time[k - 1]) / (time[k - 1] - time[begin])
                off = abs(jump - steps[k - 1] + water[-1] * share)
                is_held |= bool(off > min(0.5 * farthest, WANDERS) + STAYS + 3 * q)
                jumps.append(is_held)
            elif jumps:
                is_held |= bool(np.mean(jumps) > 0.5)
            held[begin + 1 : k] = is_held
        begin = k
    return held, doubted


def _follows(
    positions: np.ndarray, steps: np.ndarray, q: float
) -> tuple[np.ndarray, bool]:
    """Return whether each position is the one before plus the vehicle's own motion.

    They are reckoned if that is no chance, or if jumps stand alone between them.
    """
    size = np.abs(steps)
    off = np.abs(_moved(positions) - steps)
    within = np.minimum(EXACT + 1e-3 * size, 0.3) + 0.75 * q
    agrees = (off <= within) & (size > MOVED)
    alone = agrees[:-2] & agrees[2:] & (off > 10 * within)[1:-1]
    widest = np.nanmax(within, initial=0.0)
    is_reckoned = np.sum(alone) > 1 or _is_shown(agrees, widest, 2 * QUIETEST**2)
    return np.append(False, agrees), bool(is_reckoned)


def _lines(
    time: np.ndarray, positions: np.ndarray, steps: np.ndarray, q: float
) -> tuple[np.ndarray, np.ndarray]:
    """Return whether each position is inside a straight line at one velocity, or reckoned.

    At the end of a reckoned line the position jumps.
    """
    none = np.zeros(len(time), bool)
    if len(time) < 4:
        return none, none
    spans = np.diff(time)
    size = PER_DEGREE * np.array([1j, np.cos(np.radians(positions[:, 0].mean()))])
    ground = np.diff(np.unwrap(positions, axis=0, period=360.0), axis=0) @ size

    def bends(moved: np.ndarray) -> np.ndarray:
        weights = spans[1:] * spans[:-1] / (spans[1:] + spans[:-1])
        return np.abs(np.diff(moved / spans)) * weights

    within = EXACT + q
    inner = np.pad(bends(ground) <= within, 1)
    ends = (inner[:-2] | inner[2:]) & ~inner[1:-1]
    unexplained = bends(ground - np.nan_to_num(steps)) > 5 * within
    is_bent = np.sum(ends) > 1 and np.mean(unexplained[ends]) > 0.5
    if not (is_bent and _is_shown(inner[1:-1], within, 1.5 * QUIETEST**2)):
        return none, none
    # steps between two lines that no turn from one to the other makes
    velocity = ground / spans
    change = np.abs(np.diff(velocity))
    detour = change[:-1] + change[1:] - np.abs(velocity[2:] - velocity[:-2])
    is_jump = inner[:-3] & ~inner[1:-2] & ~inner[2:-1] & inner[3:]
    is_jump &= detour * spans[1:-1] > 20 * within
    if np.sum(is_jump) > 1:
        return none, inner | np.append(False, inner[:-1])
    return inner, none
