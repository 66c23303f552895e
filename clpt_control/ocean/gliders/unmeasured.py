"""Positions of a log that carry no measurement, and so are no fixes.

With d the displacement over ground between two rows of a log, w that through the water and q the
resolution of the positions, a position is

    held          if it stays within 3 m of the last fix while the vehicle moves, and then jumps
    reckoned      if d = w to (0.02 m + 1e-3 |w| + q): the vehicle's own motion
    interpolated  if it lies within (0.02 m + q) of a straight line at one velocity

Straight lines that end in jumps are reckoned, too, of a log without the motion of the vehicle.
With jitter of up to 15 m, and 5 % of a step, positions are held or reckoned where jumps stand
alone, and with jitter of 3 m interpolated where lines follow no turn of the vehicle.  Those of a
drifter are held between three such jumps or more that lead away.

The receiver of a vehicle that keeps its place, drifts in a uniform current or is moored has noise
of metres, so that positions agree that well by chance only.  A rule asks for so many that noise of
2 m shows them less often than once in 1e7, or for jumps that no current makes.  Without noise, as
in a simulation, the vehicle's own motion explains the bends of the lines.

A vehicle that keeps its place leaves it as its motion through the water says; a held position
jumps.  Before that a position is in doubt: a live estimator learns it, and takes it back later
(`FlowEstimator.fix`).
"""

from collections import Counter
from itertools import pairwise
from math import log

import numpy as np

from ...base.geodesy import RADIUS, displacement

NO_FIX = "the position carries no measurement and is no fix"
DOUBT = (
    "the last positions repeat, or follow the vehicle's own motion: learned as fixes until "
    "later positions show a jump"
)
Array = np.ndarray
JITTER = 3.0  # m, of a position that is held
OF_STEP, LARGEST = 0.05, 15.0  # of a step, and m, of jitter that jumps show
MOVED = 0.1  # m that a vehicle moves at least
STAYS = 10.0  # times the jitter that one that keeps its place may seem to move
BENDS = 30.0  # m that a line is off, where it jumps or should turn
WANDERS = 100.0  # m that it moves at most, by noise and control
EXACT = 0.02  # m, in sums of stretches and in a straight line
SLOWER = 1e-3  # of the vehicle's own motion, by rounding
TURNED = 3e-3  # rad, of axes at the last fix 10 km away
QUIETEST = 2.0  # m, noise of a fix on each axis, the smallest
RARE, SELDOM = 1e-7, 1e-3  # chances that fixes with that noise agree
PER_DEGREE = 111e3  # m


def unmeasured(
    time: Array, positions: Array, steps: Array, is_live: bool = False
) -> tuple[Array, Array]:
    """Return the kind of each position (n,), "" for a fix, and whether a fix is in doubt.

    `positions` (n, 2) are degrees north and east, `steps` (n - 1,) the displacements through the
    water between them, east + i north in m, NaN where not known.  No position is interpolated that
    comes live, before the next fix.
    """
    kinds = np.full(len(time), "", dtype=object)
    doubted = np.zeros(len(time), bool)
    q = _resolution(positions)
    for rule in (_repeated, _reckoned, _interpolated) if len(time) else ():
        rows = np.flatnonzero(kinds == "")
        sums = np.array([*map(np.sum, np.split(steps, rows[1:])[:-1])], complex)
        kind, members, candidates = rule(time[rows], positions[rows], sums, q)
        if is_live and kind == "interpolated":
            continue
        kinds[rows[members]] = kind
        doubted[rows] |= candidates
    return kinds, doubted & (kinds == "")


def counted(kinds: list[str]) -> str:
    """Return how many positions of which kind are left out, empty if none is.

    >>> counted(["", "held", "held", "reckoned"])
    'positions of 3 rows are no fixes and are left out: 2 held, 1 reckoned'
    """
    counts = Counter(filter(None, kinds))
    listing = ", ".join(f"{count} {kind}" for kind, count in sorted(counts.items()))
    text = (
        f"positions of {counts.total()} rows are no fixes and are left out: {listing}"
    )
    return text * bool(counts)


def _resolution(positions: Array) -> float:
    """Return the resolution of positions (m): that of decimals of degrees or of minutes."""
    for scale in (10.0**digits * parts for digits in range(8) for parts in (1, 6)):
        scaled = positions * scale
        if np.all(np.abs(scaled - np.round(scaled)) < 6e-9 * scale):
            return PER_DEGREE / scale
    return 0.0


def _is_shown(agrees: Array, tolerance: Array, variance: float) -> bool:
    """Return whether deviations of two normal axes are within a distance too often for chance."""
    chance = -np.expm1(-(tolerance**2) / (2 * variance))
    counts = chance < 0.5
    fewest = log(RARE) / log(np.max(chance[counts], initial=1e-9))
    return np.sum(agrees[counts]) > 2 * np.sum(chance[counts]) + fewest


def _moved(positions: Array) -> Array:
    """Return the displacements over ground between rows, (n - 1,), m."""
    return np.array(
        [complex(*displacement(*a, *b)) for a, b in pairwise(positions)], complex
    )


def _repeated(
    time: Array, positions: Array, steps: Array, q: float
) -> tuple[str, Array, Array]:
    """Return which positions are the last fix held, and which may be."""
    repeated, candidates = np.zeros((2, len(time)), bool)
    jumps = []
    begin = 0
    jitter = np.clip(OF_STEP * np.abs(np.nan_to_num(steps)), JITTER, LARGEST)
    for k in range(1, len(time) + 1):
        jump = _moved(positions[[begin, k]])[0] if k < len(time) else 0j
        if k < len(time) and abs(jump) <= jitter[k - 1]:
            continue
        run, begin = slice(begin, k), k
        water = np.cumsum(steps[run][: k - run.start - 1])
        farthest = np.max(np.abs(water), initial=0.0)  # NaN if not known
        candidates[run][1:] = farthest > MOVED
        chance = min(q * q / (4 * np.pi * QUIETEST**2), 1.0)
        is_held = bool(chance ** len(water) < SELDOM)
        is_held &= bool(np.all(positions[run] == positions[run.start]))
        stays = STAYS * np.max(jitter[run], initial=JITTER) + 3 * q
        if not farthest > (MOVED + 1.5 * q if is_held else stays):
            continue
        if k < len(time):
            share = (time[k] - time[k - 1]) / (time[k - 1] - time[run.start])
            off = abs(jump - steps[k - 1] + water[-1] * share)
            is_held |= bool(off > min(0.5 * farthest, WANDERS) + stays)
            jumps.append(is_held)
        repeated[run][1:] = is_held or (k == len(time) and 2 * sum(jumps) > len(jumps))
    return "held", repeated, candidates


def _reckoned(
    time: Array, positions: Array, steps: Array, q: float
) -> tuple[str, Array, Array]:
    """Return which positions are the one before plus the vehicle's own motion.

    They are reckoned if that is no chance, or if jumps stand alone between them.  Those of a
    drifter, which has no motion of its own, are held if the jumps lead away, three at least: a buoy
    that swings comes back.
    """
    steps = np.nan_to_num(steps)
    size = np.abs(steps)
    is_under_way = size > MOVED
    drifts = not np.any(is_under_way)
    error = _moved(positions) * np.exp(-1j * np.angle(steps)) - size
    lengthwise, across = (EXACT + share * size + 1.25 * q for share in (SLOWER, TURNED))
    agrees = (np.abs(error.real) <= lengthwise) & (np.abs(error.imag) <= across)
    agrees &= is_under_way
    # area of a rectangle as that of a circle
    tolerance = np.sqrt(4 * lengthwise * across / np.pi)
    agrees &= _is_shown(agrees, tolerance, 2 * QUIETEST**2)
    # with jitter, between jumps that stand alone at rows like the others and, of a drifter, lead on
    off = np.abs(error)
    across += LARGEST if drifts else np.minimum(OF_STEP * size, LARGEST)
    is_close = (off <= across) & (is_under_way | drifts)
    jumps = off > 6 * across + BENDS
    spans = np.diff(time)
    alone = is_close[:-2] & jumps[1:-1] & is_close[2:] & (spans[1:-1] < 4 * spans[:-2])
    if (
        2 * np.sum(alone) > 1 + np.sum(jumps)
        and np.mean(is_close) > 0.4
        and (
            not drifts or np.max(np.abs(np.cumsum(error))) > 2.5 * np.median(off[jumps])
        )
    ):
        agrees = is_close
    kind = "held" if drifts else "reckoned"
    return kind, np.append(False, agrees), np.append(False, is_close)


def _interpolated(
    time: Array, positions: Array, steps: Array, q: float
) -> tuple[str, Array, Array]:
    """Return which positions are inside straight lines at one velocity, or reckoned.

    At the ends of reckoned lines the position jumps.
    """
    empty = np.zeros(len(time), bool)
    latitudes = np.radians(positions[:, 0])
    unwrapped = np.unwrap(positions, axis=0, period=360.0)
    in_degrees = unwrapped @ [1j * PER_DEGREE, PER_DEGREE * np.cos(latitudes.mean())]
    moved = _moved(positions)
    curved = np.abs(moved[1:] * moved[:-1] * np.tan(latitudes[1:-1])) / RADIUS
    spans = np.diff(time)
    weights = spans[1:] * spans[:-1] / (spans[1:] + spans[:-1])
    through_water = steps / spans
    turned = np.abs(np.diff(through_water))
    unexplained = (
        np.abs(np.diff(moved / spans - np.nan_to_num(through_water))) * weights
    )
    # lines with jitter; of constant course, shortest ones and, closer, those in degrees
    for least, ground, curvature in (
        (JITTER, moved, curved),
        (EXACT, moved, curved),
        (EXACT, np.diff(in_degrees), 0 * curved),
    ):
        tolerance = curvature + least + q
        velocity = ground / spans
        change = np.abs(np.diff(velocity))
        inner = np.pad(change * weights <= tolerance, 1)
        ends = (inner[:-2] | inner[2:]) & ~inner[1:-1]
        if np.sum(ends) < 2 or np.mean((unexplained > 2 * tolerance)[ends]) < 0.5:
            continue
        # turns of the vehicle that no line follows
        turns = turned * weights > tolerance + BENDS
        turns &= turned > 0.5 * np.abs(through_water[1:])
        missed = np.sum(turns & inner[1:-1])
        if 4 * missed > np.sum(turns) + 3 and np.mean(inner) > 0.5:
            return "interpolated", inner, ~inner & inner
        if least > EXACT:
            continue
        # steps between two lines that no turn from one to the other makes
        detour = change[:-1] + change[1:] - np.abs(velocity[2:] - velocity[:-2])
        is_jump = inner[:-3] & ~inner[1:-2] & ~inner[2:-1] & inner[3:]
        is_jump &= spans[1:-1] < 4 * spans[:-2]
        is_jump &= detour * spans[1:-1] > 20 * tolerance[1:] + BENDS
        if np.sum(is_jump) > 1:
            last = np.append(False, inner[:-1]) & ~np.append(inner[1:], False)
            return "reckoned", inner | last, empty
        if _is_shown(inner[1:-1], tolerance, 1.5 * QUIETEST**2):
            return "interpolated", inner, empty
    return "", empty, empty
