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
residuals, two at least: what agrees throughout is a simulation without noise.

Held, reckoned and straight rows are left out (`unmeasured`).  With jitter of metres such rows are
left out only if legs between the rows that stay have a drift that is more alike, in m, than
neighbouring rows: the drift of measured positions never is.  Other rows are a question
(`question`), since the numbers do not show which of them are fixes.
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
SLOWER = 2.5e-3  # of the vehicle's own motion, by rounding and other axes
JITTER, OF_STEP, LARGEST = 2.0, 0.035, 10.0  # m, of a step, and m, of jitter
FAR = 3.0  # tolerances that the residual at a fix is at least
QUIETEST = 1.0  # m, noise of a fix on each axis, the smallest
MANY = 5.2  # standard deviations, a chance of 1e-7
AGREE = 0.4  # of residuals that are small, at least
ALIKE = 0.25  # of the mean square of drifts
RARE, SELDOM = 1e-7, 1e-3  # chances of a repeated position, in a record and live
MOVED = 0.1  # m that a vehicle moves at least
LONG = 900.0  # s, in which a pilot may come to crab
MINUTE = 60.0  # s, for which a receiver may smooth
SCALES = MINUTE * 2.0 ** np.arange(0.0, 6.5, 0.5)
PER_DEGREE = 111e3  # m


class Rows(NamedTuple):
    """Rows of a log: times, steps between rows (east + i north, m), resolution (m), tan/R (1/m)."""

    time: Array
    ground: Array
    degrees: Array
    water: Array
    q: float
    curvature: float

    @property
    def drift(self) -> Array:
        """Steps over ground less those through the water."""
        return self.ground - self.water

    def only(self, rows: Array) -> "Rows":
        """Return some rows."""
        ground, degrees, water = (
            np.add.reduceat(np.append(steps, 0.0), rows)[:-1]
            for steps in (self.ground, self.degrees, self.water)
        )
        return self._replace(
            time=self.time[rows], ground=ground, degrees=degrees, water=water
        )


class Rule(NamedTuple):
    """A way to compute positions: steps that follow it, rows of a residual, jitter or none."""

    kind: str
    steps: str
    size: int
    jitter: float = 0.0


HELD = Rule("held", "ground", 2, JITTER)
LEFT_OUT = (
    Rule("reckoned", "drift", 2),
    Rule("interpolated", "degrees", 3),
    Rule("interpolated", "ground", 3),
    HELD,
    Rule("reckoned", "drift", 2, JITTER),
    Rule("interpolated", "degrees", 3, JITTER),
)
ASKED = (
    Rule("reckoned with a current, or moved to meet the next fix", "drift", 3),
    Rule(
        "filtered, as by a filter that comes to each fix by a share of the gap",
        "drift",
        4,
    ),
    Rule("interpolated, as by a spline through the fixes", "ground", 5),
    Rule("moved smoothly from fix to fix", "drift", 5),
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
    repeated = np.all(np.diff(positions, axis=0) == 0.0, axis=1)
    for begin, end in _runs(repeated):
        run = rows.only(np.arange(begin, end + 1))
        repeated[begin:end] = _is_held(run, 5.0 * MINUTE, RARE)
    _, held = _followers(rows, HELD, Agreement(repeated, repeated))
    kinds[held] = "held"
    is_known = np.any(np.isfinite(steps))
    for rule in LEFT_OUT if is_known else LEFT_OUT[:3]:
        fixes = np.flatnonzero(kinds == "")
        left = rows.only(fixes)
        count = max(_count_of_fixes(_thinned(left, scale), rule) for scale in SCALES)
        kind, members = _followers(left, rule, _agreement(left, rule))
        stay = len(left.time) - len(members)
        if count and (stay <= 1.5 * count or _ratio(left, members) < 1.0):
            kinds[fixes[members]] = kind
    return kinds


def question(time: Array, positions: Array, steps: Array) -> str:
    """Return that positions look computed and how, empty if they look measured."""
    rows = _rows(time, positions, steps)
    for scale in SCALES:
        thinned = _thinned(rows, scale)
        for rule in ASKED:
            agreement = _agreement(thinned, rule)
            if agreement.is_shown:
                share = np.mean(np.convolve(agreement.inside, np.ones(rule.size)) > 0)
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
    curvature = abs(np.tan(latitude)) / RADIUS
    return Rows(time, ground, degrees, water, _resolution(positions), curvature)


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
    if rule.size == 4:
        change = np.diff(rows.drift / np.diff(rows.time))
        before, after = change[:-1], change[1:]
        far = 10 * (EXACT + rows.q) / np.diff(rows.time)[1:-1]
        is_large = (np.abs(before) > far) & np.isfinite(after)
        ratios = (after[is_large] / before[is_large]).real
        share = np.median(ratios) if len(ratios) else 0.0
        spans = sliding_window_view(np.diff(rows.time), 3)
        weights = np.array([share, -1.0 - share, 1.0]) / spans
    else:
        times = sliding_window_view(rows.time, rule.size)
        apart = times[:, :, None] - times[:, None] + np.eye(rule.size)
        weights = np.cumsum(1.0 / np.prod(apart, axis=2), axis=1)[:, :-1]
    gain = np.linalg.norm(np.diff(np.pad(weights, ((0, 0), (1, 1)))), axis=1)
    return weights / gain[:, None]


class Agreement(NamedTuple):
    """Residuals that are small, and those that are not large.

    It is shown if noise makes fewer residuals small.
    """

    inside: Array
    near: Array
    is_shown: bool = False


def _tolerance(rows: Rows, rule: Rule, own: Array, way: Array) -> Array:
    """Return the largest residual of computed rows: of their digits, their own way, their axes."""
    exact = EXACT + ROUNDED * rows.q
    if rule.steps == "drift":
        return exact + SLOWER * own
    return exact + 0.4 * rows.curvature * way**2 * (rule.steps == "ground")


def _agreement(rows: Rows, rule: Rule) -> Agreement:
    """Return how rows agree with a rule."""
    spans, drifts = np.diff(rows.time), not np.any(np.abs(rows.water) > MOVED)
    velocity = (rows.drift / spans)[np.isfinite(rows.drift)]
    if len(velocity) <= rule.size or (drifts and rule.jitter and rule.size > 2):
        nothing = np.zeros(max(len(spans) + 2 - rule.size, 0), bool)
        return Agreement(nothing, nothing)
    usual = np.median(velocity.real) + 1j * np.median(velocity.imag)
    weights = _weights(rows, rule)
    off, own, unusual = (
        np.abs(np.sum(weights * sliding_window_view(steps, rule.size - 1), axis=1))
        for steps in (getattr(rows, rule.steps), rows.water, rows.drift - usual * spans)
    )
    way = np.abs(rows.ground[rule.size - 2 :])
    tolerance = _tolerance(rows, rule, own, way)
    if rule.jitter:
        step = LARGEST if drifts else OF_STEP * np.abs(rows.water[rule.size - 2 :])
        tolerance = tolerance + np.clip(step, rule.jitter, LARGEST)
    moves = (own > tolerance) | (rule.size > 2) | (drifts and rule.jitter > 0.0)
    inside = moves & (off <= tolerance)
    # a fix is in less residuals than a wild one
    far = np.minimum(off, unusual) > FAR * tolerance
    near = moves & (off <= FAR * tolerance)
    breaks = [(a, b) for a, b in _runs(~near) if np.any(far[a:b])]
    if rule.size > 2:  # of rows that are alike on both sides
        at_fix = [
            (a, b) for a, b in breaks if a > 0 and b < len(near) and b - a < rule.size
        ]
        breaks = at_fix * (2 * len(at_fix) > len(breaks))
    chance = -np.expm1(-(tolerance**2) / (2 * QUIETEST**2))
    spread = np.sqrt(rule.size / 2 * np.nansum(chance * (1.0 - chance)))
    by_noise = np.nansum(chance) + MANY * spread + rule.size
    shown = len(breaks) > 1 and np.mean(inside) > AGREE
    shown &= rule.jitter > 0.0 or np.sum(inside) > by_noise
    if rule.jitter and rule.size == 3:  # turns that no line follows
        turns = (np.minimum(own, way) > FAR * tolerance) & (spans[1:] < LONG)
        shown &= 4 * np.sum(turns & inside) > np.sum(turns) + 3
    return Agreement(inside, near, bool(shown))


def _followers(rows: Rows, rule: Rule, agreement: Agreement) -> tuple[str, Array]:
    """Return the kind and the numbers of rows that follow a rule; the others are fixes."""
    if rule.size == 3:
        # a jump is in two residuals, in one at the end; the row before it is computed
        breaks = [*_runs(~agreement.near)]
        count = len(agreement.near)
        jumps = [
            begin + 1 for begin, end in breaks if end - begin == 2 - (end == count)
        ]
        kind = "reckoned" if 2 * len(jumps) > len(breaks) else rule.kind
        return kind, np.union1d(np.flatnonzero(agreement.near) + 1, jumps).astype(int)
    near = np.append(agreement.near, False)
    firsts, lasts = np.array([*_runs(agreement.near)], int).reshape(-1, 2).T
    middles = (firsts + lasts) // 2
    middles[:1], middles[-1:] = firsts[:1], lasts[-1:]  # of halves at the ends of a log
    follow = np.flatnonzero(near | np.roll(near, 1))
    of_runs = (firsts, middles, lasts) if rule.kind == "held" else (firsts,)
    choices = [np.setdiff1d(follow, fixes) for fixes in of_runs]
    return rule.kind, min(choices, key=lambda members: _scatter(rows, members))


def _count_of_fixes(rows: Rows, rule: Rule) -> int:
    """Return how many of the rows do not follow a rule, 0 if all are measured."""
    agreement = _agreement(rows, rule)
    if not agreement.is_shown:
        return 0
    _, members = _followers(rows, rule, agreement)
    is_alike = rule.size > 2 or _ratio(rows, members) < ALIKE
    return (len(rows.time) - len(members)) * is_alike


def _ratio(rows: Rows, members: Array) -> float:
    """Return the scatter of the drift between the other rows, divided by that of all."""
    return _scatter(rows, members) / max(_scatter(rows, members[:0]), 1e-9)


def _scatter(rows: Rows, members: Array) -> float:
    """Return the variance (m2) of the drift between rows that are no members."""
    kept = rows.only(np.delete(np.arange(len(rows.time)), members))
    known = np.isfinite(kept.drift)
    drift, spans = kept.drift[known], np.diff(kept.time)[known]
    off = drift - np.sum(drift) / max(np.sum(spans), MINUTE) * spans
    return float(np.sum(np.abs(off) ** 2) / max(len(off) - 3, 1e-9))
