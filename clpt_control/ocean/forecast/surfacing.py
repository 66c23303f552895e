"""Forecast of the next surfacing: place and time.

It is the forecast of a dive not yet flown,

    z(T) = last fix + drift at the surface + d + forecast of the miss

d is the displacement through the water and T the duration of the dive, as planned, as aimed or as
`DiveStatistics` expects.  The ellipse and the time are for `LEVEL`: of the miss, of the drift, of
the scatter of d and T (d by the learned speed and compass), as wide as their own record asks.

Hours are counted from now: from the clock where it is at most `RECENT` after the end of the
last dive, else from that end, as for a record of years ago.

The last dives of a vehicle, and the plan in their files, tell of the next one.  Its velocity v
through the water is guessed `PLANNED`, along the course that the last file holds at the usual speed
V, or `REPEATED`, that of the last dive at V/2 or more; its duration T as `LAST` or `USUAL`: by
what has scattered less.  V and the usual duration are medians of the last `RECENT_DIVES`.  What
comes is

    z = (way / duration - v) / V, along v and to its left;    z = log(duration / T)

so that a dive of another length, or of no way, is no change of speed.  Of N dives, each counting
0.95 of the one after it, z (d,) has centre m and scatter S of Student's t, nu = `HEAVY`, so that
a single odd dive says little.  A prior 0, S0 counts as much as k dives for m and n for S:

    u = (nu + d) / (nu + (z - m)^T S^-1 (z - m))
    m = sum u z / (k + sum u)
    S = (n S0 + k m m^T + sum u (z - m) (z - m)^T) / (n + N), of the next dive times 1 + 1 / (k + N)

(K. L. Lange, R. J. A. Little, J. M. G. Taylor, "Robust statistical modeling using the t
distribution", J. Am. Stat. Assoc. 84, 881-896, 1989).  No guess is faster than the fastest dive.
Few dives say little: a share p, `LEVEL`, of what comes lies within n' ((1 - p)^(-2/n') - 1) of its
covariance, n' = n + N (normal: -2 ln(1 - p)).

How often a headline holds is counted.  The width of the next one is that of the last one

    exp(0.3 * (p where it did not hold, else p - 1)) times,

for the place and for the time each, so that in the long run a share p holds, whatever the
vehicle does (I. Gibbs, E. Candes, "Adaptive conformal inference under distribution shift",
Advances in Neural Information Processing Systems 34, 2021).  It is at least 2^(10 p - 10), to
which 23 headlines in a row that hold narrow it, whatever p is: luck narrows it no further.

Fixes alone say how a vehicle drifts at the surface,

    drift before a dive = start of the dive - end of the dive before,

where the numbers of the two follow one another; where they do not, or the dive is the first
known, from the first fix of the surfacing (GPS1), if the file has it.  Ways are geodesics.
"""

import time
from collections.abc import Sequence
from dataclasses import dataclass
from math import cos, exp, hypot, isfinite, log, nan, radians, sin
from operator import itemgetter
from statistics import NormalDist, median
from typing import Any, NamedTuple

import numpy as np

from ...base.errors import ScenarioError
from ...base.geodesy import displacement
from ...base.units import DAY, seconds_since_1970
from ..estimation.fix_model import CHI_SQUARED, LEVEL
from ..gliders.dives import FASTEST, Dive, Fix
from .quality_control import squared_distance
from .table_rows import (
    GIVEN,
    PLANNED,
    REPEATED,
    Row,
    clock,
    direction,
    in_minutes,
    placed,
    utc,
    vector,
)

LAST, USUAL = "last", "usual"  # durations
# standard deviations of S0
SPREAD = {PLANNED: (0.25, 0.25), REPEATED: (0.25, 0.3), LAST: (0.2,), USUAL: (0.2,)}
MEANS, SPREADS = 2.0, 3.0  # dives that a prior counts as: k and n
FADING = 0.95  # of what a dive counts, at the next one
RECALLED = 60  # dives; older ones count less than 0.05
RECENT_DIVES = 5  # dives whose medians are usual
HEAVY = 10.0  # nu
ROUNDS = 20  # of the iteration for m and S
OFF_SPEED, OFF_COURSE = 0.1, 0.17  # of a given dive: standard deviations, share and rad
STAY, DRIFT = 600.0, 200.0  # s, m: standard deviations before any dive
LEAST = 1e-3  # m/s of a guess
RATE, WIDEST = 0.3, 5.0  # of the width by its own record
NARROWEST = 0.5 ** (10.0 - 10.0 * LEVEL)  # 0.5 at 90 %
SHORTEST_STAY = 60.0  # s; a fix of 4 m makes more than 0.1 m/s of less
LONGEST_STAY = DAY  # a longer stay is more than waiting for a fix
NORMAL = NormalDist().inv_cdf((1.0 + LEVEL) / 2.0)  # standard deviations
SHORTEST, LONGEST = 1.0, 30 * DAY  # s, of a plan
RECENT = 30 * DAY  # s; a record whose last dive ended earlier is old
CLOCK, LAST_END = "clock", "end of the last dive"
# as `ellipse` has them
ELLIPSE = ("ellipse_long", "ellipse_short", "ellipse_bearing")


class Way(NamedTuple):
    """A way over ground: m east and north, and the time it took, s."""

    east: float
    north: float
    seconds: float

    def as_dict(self) -> dict[str, float | None]:
        """Return length (m), speed (m/s), direction (degrees) and time (s), None if unknown."""
        length = hypot(self.east, self.north)
        return {
            "distance": length,
            "duration": self.seconds,
            "speed": length / self.seconds if self.seconds >= SHORTEST_STAY else None,
            "direction": direction(self.east, self.north),
        }


def drift(dive: Dive, before: Dive | None) -> Way | None:
    """Return the drift at the surface before a dive; None where it is not known."""
    fix: tuple[Any, Any, Any] = dive.t_gps1, dive.lat_gps1, dive.lon_gps1
    if before is not None and dive.number == before.number + 1:
        fix = before.t_gpse, *before.end
    if any(value is None or not isfinite(value) for value in fix):
        return None
    seconds = dive.t_gps2 - fix[0]
    displaced = displacement(*fix[1:], *dive.start)
    is_known = 0.0 <= seconds <= LONGEST_STAY and isfinite(displaced[0])
    return Way(*displaced, seconds) if is_known else None


def has_course(dive: Dive) -> bool:
    """Return whether the file of a dive has a course for the next one."""
    return dive.next_course is not None and isfinite(dive.next_course)


class Guess(NamedTuple):
    """A dive to come: way through the water (2,), m, duration, s, and what both scatter by.

    `scatter` (3, 3) is the covariance of east, north (m) and the logarithm of the duration,
    `freedom` how many dives it stands on, `basis` which guess it is.
    """

    way: np.ndarray
    duration: float
    scatter: np.ndarray
    freedom: float
    basis: str

    @property
    def tails(self) -> float:
        """Return how many times `LEVEL` of what comes is wider than of a normal pair, squared."""
        return (
            self.freedom * ((1.0 - LEVEL) ** (-2.0 / self.freedom) - 1.0) / CHI_SQUARED
        )


def moments(rows: np.ndarray, name: str) -> tuple[np.ndarray, np.ndarray, float]:
    """Return m (d,), S (d, d) and n + N of a guess by the z of the dives, (N, d), in order."""
    counts = FADING ** np.arange(len(rows))[::-1]
    dives = float(counts.sum())
    prior = np.diag(SPREAD[name]) ** 2
    m = np.zeros(len(prior))
    S = prior
    for _ in range(ROUNDS):
        away = np.sum((rows - m) * np.linalg.solve(S, (rows - m).T).T, axis=1)
        weights = counts * (HEAVY + m.size) / (HEAVY + away)
        m = weights @ rows / (MEANS + weights.sum())
        off = rows - m
        scatter = SPREADS * prior + MEANS * np.outer(m, m) + (weights * off.T) @ off
        S = scatter / (SPREADS + dives)
    return m, S * (1.0 + 1.0 / (MEANS + dives)), SPREADS + dives


class DiveStatistics:
    """Statistics of a vehicle's dives, updated dive by dive; `last` is the last dive.

    `recent` are speed (m/s), log duration and velocity of the last dives, `fastest` is the
    greatest speed through the water, `drifts` sums of 1, east, north and their square, `evidence`
    the z of each guess.  `width` is how many times wider the next headline's place and time are
    by its record.
    """

    def __init__(self) -> None:
        self.last: Dive | None = None
        self.evidence = {name: np.zeros((0, len(SPREAD[name]))) for name in SPREAD}
        self.recent = np.zeros((0, 4))
        self.fastest = 0.0
        self.drifts = np.zeros(4)
        self.stays: list[float] = []
        self.width: tuple[float, ...] = (1.0, 1.0)

    def _velocities(self, last: Dive) -> dict[str, np.ndarray]:
        """Return the velocity through the water of each guess, (2,), m/s."""
        speed = np.median(self.recent[:, 0])
        # a dive of hardly any way is no velocity to repeat
        flown = self.recent[self.recent[:, 0] >= 0.5 * speed]
        velocities = {REPEATED: flown[-1, 2:]}
        if last.next_course is not None and has_course(last):
            course = radians(last.next_course)
            velocities[PLANNED] = speed * np.array([sin(course), cos(course)])
        return velocities

    def _lengths(self) -> dict[str, float]:
        """Return the logarithm of the duration of each guess."""
        return {USUAL: np.median(self.recent[:, 1]), LAST: self.recent[-1, 1]}

    def _frame(self, velocity: np.ndarray) -> np.ndarray:
        """Return the matrix from z to velocity, (2, 2), m/s."""
        B = _frame(*velocity)
        return B * max(np.median(self.recent[:, 0]), LEAST) / hypot(*B[:, 0])

    def _duration(self) -> tuple[float, float]:
        """Return the less scattered guess of a duration, s, behind the variance of its log."""
        found = []
        for name, length in self._lengths().items():
            m, S, _ = moments(self.evidence[name], name)
            found.append((S.item(), exp(length + m.item())))
        return min(found, key=itemgetter(0))

    def guess(self) -> Guess:
        """Return the next dive, of one dive at least."""
        assert self.last is not None
        candidates = []
        late, T = self._duration()
        for name, velocity in self._velocities(self.last).items():
            m, S, freedom = moments(self.evidence[name], name)
            B = T * self._frame(velocity)
            way = T * velocity + B @ m
            way *= min(1.0, T * self.fastest / max(hypot(*way), LEAST))
            scatter = _with_time(B @ S @ B.T, way, late)
            guess = Guess(way, T, scatter, freedom, name)
            candidates.append((float(np.trace(scatter[:2, :2])), guess))
        return min(candidates, key=itemgetter(0))[1]

    def guess_of(self, displacement: tuple[float, float], duration: float) -> Guess:
        """Return a dive of a given displacement (m) and duration (s) with its scatter."""
        *_, freedom = moments(self.evidence[REPEATED], REPEATED)
        B = _frame(*displacement)
        way = np.array(displacement)
        S = B @ np.diag([OFF_SPEED, OFF_COURSE]) ** 2 @ B.T
        scatter = _with_time(S, way, self._duration()[0])
        return Guess(way, duration, scatter, freedom, GIVEN)

    def stay(self) -> tuple[float, float]:
        """Return how long the vehicle stays up, s: median and standard deviation about it."""
        usual = float(median(self.stays or [0.0]))
        away = sum((seconds - usual) ** 2 for seconds in self.stays)
        return usual, ((MEANS * STAY**2 + away) / (MEANS + len(self.stays))) ** 0.5

    def drift(self) -> tuple[np.ndarray, np.ndarray]:
        """Return the drift at the surface to come: mean (2,), m, covariance (2, 2), m^2."""
        n = self.drifts[0]
        total = self.drifts[1:3]
        square = self.drifts[3]
        mean = total / (MEANS + n)
        away = max(square - 2 * mean @ total + n * mean @ mean, 0.0) / 2
        return mean, (MEANS * DRIFT**2 + away) / (MEANS + n) * np.eye(2)

    def learn(
        self, dive: Dive, surface_drift: Way | None, was_inside: Sequence[bool] = ()
    ) -> None:
        """Learn from a dive, the drift before it, and whether place and time of its headline held.

        Nothing that could be changed in place is: a copy of this needs no depth.
        """
        velocity = np.array(dive.through_water) / dive.duration
        if self.last is not None:
            came = {
                name: np.linalg.solve(self._frame(guessed), velocity - guessed)
                for name, guessed in self._velocities(self.last).items()
            }
            for name, length in self._lengths().items():
                came[name] = np.array([log(dive.duration) - length])
            for name, z in came.items():
                self.evidence[name] = np.vstack([self.evidence[name], z])[-RECALLED:]
        if surface_drift is not None:
            size = surface_drift.east**2 + surface_drift.north**2
            self.drifts = FADING * self.drifts + (
                1.0,
                surface_drift.east,
                surface_drift.north,
                size,
            )
            self.stays = [*self.stays, surface_drift.seconds]
        if was_inside:
            wider = (
                w * exp(RATE * (LEVEL - inside))
                for w, inside in zip(self.width, was_inside, strict=True)
            )
            self.width = tuple(min(max(width, NARROWEST), WIDEST) for width in wider)
        row = hypot(*velocity), log(dive.duration), *velocity
        self.recent = np.vstack([self.recent, row])[-RECENT_DIVES:]
        self.fastest = max(self.fastest, row[0])
        self.last = dive


def _frame(east: float, north: float) -> np.ndarray:
    """Return the matrix from (along, to the left) to (east, north).

    Along a way or a velocity, which is taken as `LEAST` to the north where it is shorter.
    """
    if hypot(east, north) <= LEAST:
        east = 0.0
        north = LEAST
    return np.array([[east, -north], [north, east]])


def _with_time(S: np.ndarray, way: np.ndarray, late: float) -> np.ndarray:
    """Return the covariance (3, 3) of a way (2,) and log duration by that at one duration (2, 2).

    A dive that is longer by a share goes farther by that share, of the variance `late`.
    """
    both = np.append(way, 1.0)
    return np.pad(S, (0, 1)) + late * np.outer(both, both)


def ellipse(covariance: np.ndarray) -> dict[str, float]:
    """Return half axes of the ellipse of `LEVEL` (m) and the bearing of the long one (degrees).

    The covariance (2, 2) is east and north, m^2; the bearing clockwise from north, 0 to 180.
    """
    size, axes = np.linalg.eigh(covariance)
    short, long = np.sqrt(CHI_SQUARED * size)
    bearing = np.degrees(np.arctan2(axes[0, 1], axes[1, 1])) % 180.0
    return dict(zip(ELLIPSE, map(float, (long, short, bearing)), strict=True))


@dataclass(frozen=True)
class NextDive:
    """A forecast surfacing: latitude and longitude in degrees.

    `plan` is a dive from where it should begin, without an end; `forecast` (2,), m, is of its fix
    less dead reckoning; `covariance` (2, 2), m^2, of the place, whose ellipse is as wide as the
    record asks; the time is within `time_half_width`, s, as probably; `fix` is where and when the
    vehicle surfaced last; `basis` is what the dive is guessed by; `plan_in_files` says that the
    last file has a course for the dive.
    """

    plan: Dive
    forecast: np.ndarray
    covariance: np.ndarray
    latitude: float
    longitude: float
    fix: Fix = (nan, nan, nan)
    time_half_width: float = nan
    basis: str = REPEATED
    plan_in_files: bool = False

    def __repr__(self) -> str:
        when = f"{clock(utc(self.plan.t_gpse))} +- {self.time_half_width / 60:.0f} min"
        return f"<NextDive: up {when} at {in_minutes(self.latitude, self.longitude)}>"

    def now(self) -> tuple[float, str]:
        """Return now, s since 1970, and which: the clock, or the end of a dive not just ended."""
        now = time.time()
        end = self.fix[0]
        return (now, CLOCK) if 0.0 <= now - end <= RECENT else (end, LAST_END)

    def holds(self, dive: Dive) -> tuple[bool, bool]:
        """Return whether the end of the dive is inside the ellipse, and within the time."""
        away = np.array(displacement(self.latitude, self.longitude, *dive.end))
        inside = squared_distance(away, np.zeros(2), self.covariance) <= CHI_SQUARED
        return inside, abs(dive.t_gpse - self.plan.t_gpse) <= self.time_half_width

    def as_dict(self) -> Row:
        """Return the forecast by name, for JSON: degrees, m and s."""
        now, clock_name = self.now()
        return {
            "time": utc(self.plan.t_gpse),
            "time_half_width": self.time_half_width,
            "now": utc(now),
            "now_is": clock_name,
            "hours_from_now": (self.plan.t_gpse - now) / 3600,
            "surface_time": self.plan.t_gps2 - self.fix[0],
            **placed("from_", *self.fix[1:]),
            **placed("start_", *self.plan.start),
            "basis": self.basis,
            "plan_in_files": self.plan_in_files,
            "duration": self.plan.duration,
            **vector("dr_", *self.plan.through_water),
            **placed("", self.latitude, self.longitude),
            "place": in_minutes(self.latitude, self.longitude),
            **ellipse(self.covariance),
            "why_uncovered": self.plan.uncovered,
        }


def unflown(last: Dive, start: Fix, guess: Guess) -> Dive:
    """Return a dive without an end, straight and at constant speed."""
    east, north = map(float, guess.way)
    end = start[0] + guess.duration
    no = nan, nan, nan, nan
    return Dive(
        last.number + 1, *start, end, *no, east, north, depth_max=last.depth_max
    )


def overdue_times(ahead: Row, end: str) -> tuple[float, float]:
    """Return from when until when a vehicle is overdue, s since 1970.

    `ahead` is `NextDive.as_dict`, `end` the end of the last dive.
    """
    late = seconds_since_1970(ahead["time"]) + ahead["time_half_width"]
    return late, seconds_since_1970(end) + RECENT


def check_flown(speed: float, duration: float) -> None:
    """Refuse a speed through the water (m/s) or a duration (s) that no dive can have."""
    if not (SHORTEST <= duration <= LONGEST and 0 <= speed <= FASTEST):
        raise ScenarioError(
            f"a dive of {duration / 3600:g} hours at {speed:.4g} m/s through the water: give "
            f"{SHORTEST:g} s to {LONGEST / 3600:g} hours and at most {FASTEST:g} m/s"
        )
