"""Positions of a log that were computed from other rows: they carry no measurement.

If fixes have noise s on each axis, no predictor made of other rows comes nearer to a fix than s; a
computed position is predicted to 0.02 m and the resolution q of the positions.  The residual of m
rows is a divided difference of their positions, or of positions less the way through the water,
divided by the norm of its weights: white noise s leaves s.

    m   of positions                           of positions less own way
    2   held                                   reckoned
    3   on straight lines                      with a constant current, or moved to meet the fixes
    5   on cubic polynomials                   the same
    4                                          of a filter: changes of the drift by a factor a

More residuals must be small than noise of 1 m allows.  Fixes break the agreement for less than m
residuals, two at least: what agrees throughout is a simulation without noise, but rows that are
reckoned throughout, or with one fix, are a question.

Rows that are held, reckoned or straight to the last digit are left out (`unmeasured`).  All others
are a question (`question`), since the numbers do not show which of them are fixes; so are rows with
jitter of metres, if legs between those that stay have a drift that is more alike, in m, than
neighbouring rows: the drift of measured positions never is.
"""

from collections import Counter
from collections.abc import Iterator
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view

from ...base.geodesy import RADIUS, displacement

NO_FIX = "the position carries no measurement and is no fix"
Array = np.ndarray
EXACT = 0.02  # m, of a computed position
ROUNDED = 0.7  # of the resolution, 95 % of residuals
SLOWER = 1e-3  # of the vehicle's own motion, by rounding and other axes
JITTER = 3.0  # m, of positions that are asked about
FAR = 3.0  # tolerances that the residual at a fix is at least
QUIETEST = 1.0  # m, noise of a fix on each axis, the smallest
MANY = 5.2  # standard deviations, a chance of 1e-7
AGREE = 0.4  # of residuals that are small, at least
LEAST_SHARE = 0.3  # of the gap to a fix that a filter leaves in a row
ALIKE = 0.25  # of the mean square of drifts
RARE, SELDOM = 1e-7, 1e-3  # chances of a repeated position, in a record and live
MOVED = 0.1  # m that a vehicle moves at least
MINUTE = 60.0  # s, for which a receiver may smooth
SCALES = MINUTE * 2.0 ** np.arange(0.0, 6.5, 0.5)
PER_DEGREE = 111e3  # m


class Rows(NamedTuple):
    """Rows of a log: times, steps between rows (east + i north, m), resolution (m), tan/R (1/m).

    The drift is what remains of steps over ground without those through the water.
    """

    time: Array
    ground: Array
    degrees: Array
    water: Array
    drift: Array
    q: float
    curvature: float

    def only(self, rows: Array) -> "Rows":
        """Return some rows."""
        ground, degrees, water, drift = (
            np.add.reduceat(np.append(steps, 0.0), rows)[:-1]
            for steps in (self.ground, self.degrees, self.water, self.drift)
        )
        shape = self.q, self.curvature
        return Rows(self.time[rows], ground, degrees, water, drift, *shape)


class Rule(NamedTuple):
    """A way to compute positions: steps that follow it, rows of a residual, jitter (m)."""

    kind: str
    steps: str
    size: int
    jitter: float = 0.0


RECKONED = Rule("reckoned", "drift", 2)
LINES = Rule("interpolated", "degrees", 3)
FILTER = Rule(
    "filtered, as by a filter that comes to each fix by a share of the gap", "drift", 4
)
ASKED = (
    RECKONED,
    LINES,
    Rule("reckoned with a current, or moved to meet the next fix", "drift", 3),
    FILTER,
    Rule("interpolated, as by a spline through the fixes", "ground", 5),
    Rule("moved smoothly from fix to fix", "drift", 5),
    Rule("held, with jitter", "ground", 2, JITTER),
    Rule("reckoned, with jitter", "drift", 2, JITTER),
    Rule("interpolated, with jitter", "degrees", 3, 0.2),
)


def unmeasured(time: Array, positions: Array, steps: Array) -> Array:
    """Return the kind of each position (n,), "" for a fix.

    `positions` (n, 2) are degrees north and east, `steps` (n - 1,) the displacements through the
    water between them, east + i north in m, NaN where not known.
    """
    kinds = np.full(len(time), "", dtype=object)
    if not len(time):
        return kinds
    rows = _rows(time, positions, steps)
    repeated = rows.ground == 0.0
    for begin, end in _runs(repeated):
        run = rows.only(np.arange(begin, end + 1))
        repeated[begin:end] = _is_held(run, 5.0 * MINUTE, RARE)
    kinds[_followers(rows, repeated)] = "held"
    for rule in (RECKONED, LINES):
        fixes = np.flatnonzero(kinds == "")
        left = rows.only(fixes)
        near, share = _agreement(left, rule)
        if not share or np.sum(~near) < 2:  # of one fix or none: a question
            continue
        if _agreement(_thinned(left, MINUTE), rule)[1]:
            kind, members = rule.kind, 1 + np.flatnonzero(near)
            if rule is LINES:
                # a jump is in two residuals, in one at the end; the row before it is computed
                breaks = [*_runs(~near)]
                jumps = [a + 1 for a, b in breaks if b - a == 2 - (b == len(near))]
                if 2 * len(jumps) > len(breaks):
                    kind = "reckoned" if np.median(np.abs(left.ground)) else "held"
                members = np.append(members, np.array(jumps, int))
            kinds[fixes[members]] = kind
    return kinds


def question(time: Array, positions: Array, steps: Array) -> str:
    """Return that positions look computed and how, empty if they look measured."""
    rows = _rows(time, positions, steps)
    for scale in SCALES:
        thinned = _thinned(rows, scale)
        for rule in ASKED:
            _, share = _agreement(thinned, rule)
            if share:
                return (
                    f"{round(share * len(time))} of {len(time)} positions follow from the rows "
                    f"around them more closely than a receiver measures: they look {rule.kind}"
                )
    return ""


def is_held(time: Array, positions: Array, steps: Array) -> bool:
    """Return whether the last position is one that the receiver held."""
    moves = np.any(positions != positions[-1], axis=1)
    run = np.arange(np.max(np.flatnonzero(moves), initial=-1) + 1, len(time))
    return _is_held(_rows(time, positions, steps).only(run), MINUTE, SELDOM)


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


def _rows(time: Array, positions: Array, steps: Array) -> Rows:
    """Return rows; without any motion through the water that is known, they drift."""
    latitude = np.radians(positions[:, 0].mean())
    scales = [1j * PER_DEGREE, PER_DEGREE * np.cos(latitude)]
    degrees = np.diff(np.unwrap(positions, axis=0, period=360.0) @ scales)
    moved = [complex(*displacement(*a, *b)) for a, b in pairwise(positions)]
    ground = np.array(moved, complex)
    water = steps if np.any(np.isfinite(steps)) else 0.0 * ground
    shape = _resolution(positions), abs(np.tan(latitude)) / RADIUS
    return Rows(time, ground, degrees, water, ground - water, *shape)


def _resolution(positions: Array) -> float:
    """Return the resolution of positions (m): that of decimals of degrees or of minutes."""
    for scale in (10.0**digits * parts for digits in range(8) for parts in (1, 6)):
        scaled = positions * scale
        if np.all(np.abs(scaled - np.round(scaled)) < 6e-9 * scale):
            return PER_DEGREE / scale
    return 0.0


def _runs(mask: Array) -> Iterator[tuple[int, int]]:
    """Yield the first index of each run of True, and the index behind its last."""
    edges = np.flatnonzero(np.diff(np.pad(mask.astype(int), 1)))
    yield from zip(edges[::2].tolist(), edges[1::2].tolist(), strict=True)


def _thinned(rows: Rows, scale: float) -> Rows:
    """Return rows at least some time apart."""
    kept = [0]
    for row, time in enumerate(rows.time):
        if time >= rows.time[kept[-1]] + scale:
            kept.append(row)
    return rows.only(np.array(kept))


def _is_held(run: Rows, apart: float, chance: float) -> bool:
    """Return whether a position repeats too often for measurements that are some time apart."""
    repeats = min(len(run.time) - 1, (run.time[-1] - run.time[0]) / apart)
    repeats_by = min(run.q**2 / (4 * np.pi * QUIETEST**2), 1.0)
    farthest = np.max(np.abs(np.cumsum(run.water)), initial=0.0)  # NaN if not known
    return bool(farthest > MOVED + 1.5 * run.q and repeats_by**repeats < chance)


def _weights(rows: Rows, rule: Rule) -> Array:
    """Return the weights of steps in a residual of rows, divided by their gain of noise."""
    spans = np.diff(rows.time)
    if rule is FILTER:
        change = np.diff(rows.drift / spans)
        before, after = change[:-1], change[1:]
        is_large = np.abs(before) > 10 * (EXACT + rows.q) / spans[1:-1]
        ratios = (after[is_large] / before[is_large]).real
        # noise has ratios below 0
        share = max(np.nanmedian(np.append(ratios, 0.0)), LEAST_SHARE)
        weights = np.array([share, -1.0 - share, 1.0]) / sliding_window_view(spans, 3)
    else:
        times = sliding_window_view(rows.time, rule.size)
        apart = times[:, :, None] - times[:, None] + np.eye(rule.size)
        weights = np.cumsum(1.0 / np.prod(apart, axis=2), axis=1)[:, :-1]
    gain = np.linalg.norm(np.diff(np.pad(weights, ((0, 0), (1, 1)))), axis=1)
    return weights / gain[:, None]


def _agreement(rows: Rows, rule: Rule) -> tuple[Array, float]:
    """Return the residuals that are not large, and the share of rows that follow a rule.

    It is 0 if noise makes as many residuals small.
    """
    size, spans = rule.size, np.diff(rows.time)
    velocity = (rows.drift / spans)[np.isfinite(rows.drift)]
    if len(velocity) <= size:
        return np.zeros(0, bool), 0.0
    usual = np.median(velocity.real) + 1j * np.median(velocity.imag)
    weights = _weights(rows, rule)
    off, own, unusual = (
        np.abs(np.sum(weights * sliding_window_view(steps, size - 1), axis=1))
        for steps in (getattr(rows, rule.steps), rows.water, rows.drift - usual * spans)
    )
    bent = 0.4 * rows.curvature * np.abs(rows.ground[size - 2 :]) ** 2
    slack = {"drift": SLOWER * own, "ground": bent, "degrees": 0.0 * own}[rule.steps]
    tolerance = rule.jitter + EXACT + ROUNDED * rows.q + slack
    drifts = not np.any(np.abs(rows.water) > MOVED)
    moves = (own > tolerance) | (size > 2) | bool(drifts and rule.jitter)
    inside = moves & (off <= tolerance)
    near = moves & (off <= FAR * tolerance)
    # a fix is in less residuals than a wild one
    far = np.minimum(off, unusual) > FAR * tolerance
    breaks = [(a, b) for a, b in _runs(~near) if np.any(far[a:b])]
    # at a fix, of rows that are alike on both sides
    at_fix = [a > 0 and b < len(near) and b - a < max(size, 3) for a, b in breaks]
    throughout = rule is RECKONED and np.sum(off > 1.5 * tolerance) < 2
    is_shown = throughout or sum(at_fix) > max(1, len(breaks) / 2)
    if rule.jitter > QUIETEST:
        members = _followers(rows, near)
        is_shown &= _scatter(rows, members) < ALIKE * _scatter(rows, members[:0])
    else:
        chance = -np.expm1(-(tolerance**2) / (2 * QUIETEST**2))
        spread = np.sqrt(size / 2 * np.nansum(chance * (1.0 - chance)))
        is_shown &= np.sum(inside) > np.nansum(chance) + MANY * spread + size
    is_shown &= np.mean(inside) > AGREE
    follow = np.convolve(inside, np.ones(size)) > 0.0
    return near, float(np.mean(follow) * is_shown)


def _followers(rows: Rows, near: Array) -> Array:
    """Return the rows of runs of steps but one each: that by which drifts are most alike."""
    firsts, lasts = np.array([*_runs(near)], int).reshape(-1, 2).T
    middles = (firsts + lasts) // 2
    middles[:1], middles[-1:] = firsts[:1], lasts[-1:]  # of halves at the ends of a log
    follow = np.union1d(np.flatnonzero(near), 1 + np.flatnonzero(near))
    choices = [np.setdiff1d(follow, fixes) for fixes in (firsts, middles, lasts)]
    return min(choices, key=lambda members: _scatter(rows, members))


def _scatter(rows: Rows, members: Array) -> float:
    """Return the variance (m2) of the drift between rows that are no members."""
    kept = rows.only(np.delete(np.arange(len(rows.time)), members))
    known = np.isfinite(kept.drift)
    drift, spans = kept.drift[known], np.diff(kept.time)[known]
    off = drift - np.sum(drift) / max(np.sum(spans), MINUTE) * spans
    return float(np.sum(np.abs(off) ** 2) / max(len(off) - 3, 1e-9))
