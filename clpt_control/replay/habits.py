"""How a vehicle dives, and how far its headlines can be trusted.

Its last dives, and the plan in its files, tell of the next one.  The next dive is guessed in three
ways: `PLANNED`, along the course that the last file holds, `REPEATED`, as the last dive went, and
`ANYWHERE`, within the reach of the last dives.  A guess has a direction, a length L and a duration
T.  What comes is, in its measure,

    z = (along / L, to its left / L, log(duration / T)).

Of N dives, each counting 0.95 of the one after it, z has mean m and covariance S, behind a prior
c, S0 that counts as much as k dives for the one and n for the other:

    m = (k c + sum z) / (k + N)
    S = (n S0 + k c c^T + sum z z^T - (k + N) m m^T) / (n + N) (1 + 1 / (k + N))

The guesses are mixed by how well each has forecast the dives before, as the filters of
`estimators` are, by Student's density; the place is that of the likelier one of the first
two, about which all scatter.  So few dives say little, and 90 % of what comes
lies within  n' (0.1^(-2/n') - 1)  of its covariance, n' = n + N (normal: 2 ln 10).

How often a headline holds is counted.  The width of the next one is that of the last one

    exp(0.3 * (0.9 where it did not hold, else -0.1)) times,

for the place and for the time each, so that in the long run a tenth does not hold, whatever the
vehicle does (I. Gibbs, E. Candes, "Adaptive conformal inference under distribution shift",
Advances in Neural Information Processing Systems 34, 2021).

Fixes alone say how a vehicle drifts at the surface,

    drift before a dive = start of the dive - end of the dive before,

where the numbers of the two follow one another; where they do not, or the dive is the first
known, from the first fix of the surfacing (GPS1), if the file has it.  Ways are geodesics.
"""

from collections.abc import Sequence
from math import exp, hypot, isfinite, log, radians
from statistics import median
from typing import Any, NamedTuple

import numpy as np

from ..estimation.estimators import mixed
from ..geodesy import displacement
from ..gliders.dives import Dive
from .places import direction

PLANNED, REPEATED, ANYWHERE, GIVEN = "planned", "repeated", "anywhere", "given"
PRIORS = {  # c, and standard deviations of S0
    PLANNED: ((1.0, 0.0, 0.0), (0.25, 0.25, 0.2)),
    REPEATED: ((1.0, 0.0, 0.0), (0.25, 0.3, 0.2)),
    ANYWHERE: ((0.0, 0.0, 0.0), (0.7, 0.7, 0.2)),
}
MEANS, SPREADS = 2.0, 3.0  # dives that a prior counts as: k and n
FADING = 0.95  # of what a dive counts, at the next one
TAILS = 4.0  # degrees of freedom of the density by which guesses are weighed
OFF_SPEED, OFF_COURSE = 0.1, 0.17  # of a given dive: standard deviations, share and rad
STAY, DRIFT = 600.0, 200.0  # s, m: standard deviations before any dive
LEAST = 1.0  # m of a guess
RATE, NARROWEST, WIDEST = 0.3, 0.5, 5.0  # of the width by its own record
CHI_SQUARED = 4.605170185988092  # of two components, 90 %: 2 ln 10
SHORTEST_STAY = 60.0  # s; a fix of 4 m makes more than 0.1 m/s of less
LONGEST_STAY = 86400.0  # s; a longer stay is more than waiting for a fix


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
        fix = before.t_gpse, before.lat_gpse, before.lon_gpse
    if any(value is None or not isfinite(value) for value in fix):
        return None
    seconds = dive.t_gps2 - fix[0]
    way = displacement(*fix[1:], dive.lat_gps2, dive.lon_gps2)
    known = 0.0 <= seconds <= LONGEST_STAY and isfinite(way[0])
    return Way(*way, seconds) if known else None


class Guess(NamedTuple):
    """A dive to come: way through the water (2,), m, duration, s, and what both scatter by.

    `scatter` (3, 3) is the covariance of east, north (m) and the logarithm of the duration,
    `freedom` how many dives it stands on, `basis` which of the guesses is the likeliest.
    """

    way: np.ndarray
    duration: float
    scatter: np.ndarray
    freedom: float
    basis: str

    @property
    def tails(self) -> float:
        """Return how many times 90 % of what comes is wider than of a normal pair, squared."""
        return self.freedom * (0.1 ** (-2.0 / self.freedom) - 1.0) / CHI_SQUARED


class Evidence(NamedTuple):
    """What the dives so far say of one guess: N, sum z, sum z z^T, and the log of its odds."""

    dives: float
    total: np.ndarray
    square: np.ndarray
    odds: float

    def moments(self, name: str) -> tuple[np.ndarray, np.ndarray]:
        """Return m (3,) and S (3, 3)."""
        c, sd = np.array(PRIORS[name])
        k = MEANS + self.dives
        m = (MEANS * c + self.total) / k
        scatter = SPREADS * np.diag(sd**2) + self.square + MEANS * np.outer(c, c)
        return m, (scatter - k * np.outer(m, m)) / (SPREADS + self.dives) * (1.0 + 1.0 / k)


class Habits:
    """What is known of how a vehicle dives, dive by dive; `last` is the last dive.

    `means` are sums of 1, length and log duration, `drifts` of 1, east, north and their square.
    `width` is how many times wider the next headline's place and time are by its record.
    """

    def __init__(self) -> None:
        self.last: Dive | None = None
        self.evidence = dict.fromkeys(PRIORS, Evidence(0.0, np.zeros(3), np.zeros((3, 3)), 0.0))
        self.means, self.drifts = np.zeros(3), np.zeros(4)
        self.stays: list[float] = []
        self.width: tuple[float, ...] = (1.0, 1.0)

    def _frames(self, last: Dive) -> dict[str, tuple[np.ndarray, float]]:
        """Return, for each guess, the matrix from z to m, (3, 3), and the log of its duration."""
        ahead, length = _direction((last.dr_east, last.dr_north))
        usual, usually = self.means[1:] / self.means[0]  # length, log duration
        usual = max(usual, LEAST)
        found = {
            REPEATED: (_frame(ahead, length), log(last.duration)),
            ANYWHERE: (_frame(ahead, usual), usually),
        }
        if last.next_course is not None and isfinite(last.next_course):
            course = radians(last.next_course)
            found[PLANNED] = _frame(np.array([np.sin(course), np.cos(course)]), usual), usually
        return found

    def _guesses(self, last: Dive) -> tuple[np.ndarray, ...]:
        """Return names, means (m, 3), covariances (m, 3, 3) and log weights (m,)."""
        frames = self._frames(last)
        means, scatters = [], []
        for name, (B, log_time) in frames.items():
            m, S = self.evidence[name].moments(name)
            means.append(B @ m + (0.0, 0.0, log_time))
            scatters.append(B @ S @ B.T)
        odds = np.array([self.evidence[name].odds for name in frames])
        weights = odds - np.logaddexp.reduce(odds)
        return np.array(list(frames)), np.array(means), np.array(scatters), weights

    def guess(self) -> Guess:
        """Return the next dive, of one dive at least."""
        assert self.last is not None
        names, means, scatters, weights = self._guesses(self.last)
        weights = np.exp(weights)
        basis = max((PLANNED, REPEATED), key=lambda name: weights[names == name].sum())
        way = means[names == basis][0, :2]
        mean, scatter = mixed(means, scatters, weights)
        away = np.array([*(mean[:2] - way), 0.0])
        freedom = SPREADS + weights @ [self.evidence[name].dives for name in names]
        scatter = scatter + np.outer(away, away)
        return Guess(way, exp(mean[2]), scatter, float(freedom), basis)

    def guess_of(self, way: tuple[float, float], duration: float) -> Guess:
        """Return a dive of a given way (m) and duration (s), with what both scatter by."""
        late = min(self.evidence[name].moments(name)[1][2, 2] for name in (REPEATED, ANYWHERE))
        B = _frame(*_direction(way))
        S = np.diag([OFF_SPEED**2 + late, OFF_COURSE**2, late])
        S[0, 2] = S[2, 0] = late
        return Guess(
            np.array(way), duration, B @ S @ B.T, SPREADS + self.evidence[REPEATED].dives, GIVEN
        )

    def stay(self) -> tuple[float, float]:
        """Return how long the vehicle stays up, s: median and standard deviation about it."""
        usual = float(median(self.stays or [0.0]))
        away = sum((one - usual) ** 2 for one in self.stays)
        return usual, ((MEANS * STAY**2 + away) / (MEANS + len(self.stays))) ** 0.5

    def drift(self) -> tuple[np.ndarray, np.ndarray]:
        """Return the drift at the surface to come: mean (2,), m, covariance (2, 2), m^2."""
        n, total, square = self.drifts[0], self.drifts[1:3], self.drifts[3]
        mean = total / (MEANS + n)
        away = max(square - 2 * mean @ total + n * mean @ mean, 0.0) / 2
        return mean, (MEANS * DRIFT**2 + away) / (MEANS + n) * np.eye(2)

    def learn(self, dive: Dive, way: Way | None, held: Sequence[bool] = ()) -> None:
        """Learn from a dive, the drift before it, and whether place and time of its headline held.

        Nothing that could be changed in place is: a copy of this needs no depth.
        """
        came = np.array([dive.dr_east, dive.dr_north, log(dive.duration)])
        if self.last is not None:
            self.evidence = self._evidence(self.last, came)
        if way is not None:
            size = way.east**2 + way.north**2
            self.drifts = FADING * self.drifts + (1.0, way.east, way.north, size)
            self.stays = [*self.stays, way.seconds]
        if held:
            wider = (w * exp(RATE * (0.9 - one)) for w, one in zip(self.width, held, strict=True))
            self.width = tuple(min(max(width, NARROWEST), WIDEST) for width in wider)
        self.means = FADING * self.means + (1.0, hypot(*came[:2]), came[2])
        self.last = dive

    def _evidence(self, last: Dive, came: np.ndarray) -> dict[str, Evidence]:
        """Return the evidence with a dive that came: east, north, log duration."""
        names, means, scatters, weights = self._guesses(last)
        frames, found, densities = self._frames(last), dict(self.evidence), []
        for name, mean, scatter in zip(names, means, scatters, strict=True):
            B, log_time = frames[name]
            z = np.linalg.solve(B, came - (0.0, 0.0, log_time))
            was = found[name]
            square = FADING * was.square + np.outer(z, z)
            dives, total = FADING * was.dives + 1.0, FADING * was.total + z
            found[name] = Evidence(dives, total, square, was.odds)
            far = (came - mean) @ np.linalg.solve(scatter, came - mean)
            spread = np.linalg.slogdet(scatter)[1]
            densities.append(-0.5 * (spread + (TAILS + 3.0) * np.log1p(far / (TAILS - 2.0))))
        usual = np.logaddexp.reduce(weights + densities)  # of the guesses that were made
        for name, density in zip(names, densities, strict=True):
            odds = found[name].odds + float(density - usual)
            found[name] = found[name]._replace(odds=odds)
        return {name: one._replace(odds=FADING * one.odds) for name, one in found.items()}


def _direction(way: Sequence[float]) -> tuple[np.ndarray, float]:
    """Return the direction (2,) and the length of a way, at least `LEAST`."""
    length = hypot(*way)
    return (np.array(way) / length, length) if length > LEAST else (np.array([0.0, 1.0]), LEAST)


def _frame(ahead: np.ndarray, length: float) -> np.ndarray:
    """Return the matrix from (along, to the left, log duration) to (m east, m north, the same)."""
    B = np.eye(3)
    B[:2, :2] = length * np.array([[ahead[0], -ahead[1]], [ahead[1], ahead[0]]])
    return B
