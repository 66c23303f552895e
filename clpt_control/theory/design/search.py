"""The search: many tracks drawn at random, then climbs from the best on both axes at once.

    maximise kappa_1(w_1 ... w_n),    unknowns in [0, 1]: places in the area's box

Half of the tracks are drawn near the first one; all go to the tracks' lanes at once.  A track
beyond a limit costs more than any that keeps to it, the more the farther it is
beyond.  kappa_1 has a ridge where both axes have the same smallest eigenvalue, so a climb asks
SLSQP (Kraft 1988) for the largest s with log kappa of each axis >= s and each slack >= 0;
derivatives are differences, again in lanes.

The search goes in rounds: climb, look closely, climb again where a limit is not kept.  The first
round draws before, and watches speed and area up to the window's end, the others over the whole
run and under limits that are tighter by what the last climb was beyond.  The track to begin with
competes.
"""

from collections.abc import Callable
from functools import lru_cache
from typing import Any, NamedTuple

import numpy as np

from ...errors import ScenarioError
from ...progress.interrupt import check
from ...scenario.experiment import Scenario
from .waypoint_tracks import MARGIN, Limits, Tracks, shortened

BEYOND = 1e4  # cost of a limit that is not kept, more than -log of any eigenvalue
LEAST = 1e-300
DRAWN = 400  # tracks
NEAR = 0.3  # spread of the half of them that is near the first track, share of the area's box
STEP = 1e-6  # of the differences, share of the area's box
STARTS = 4  # of climbs: the best track drawn may not lie on the highest hill
CLIMBS = 60  # iterations of SLSQP
INSIDE = 1e-5  # of each limit, that a climb leaves free
WAY = 33  # places looked at between the start and the end of a climb


class TrackSearch:
    """Tracks of as many waypoints as a scenario has, within limits, as points of a unit cube."""

    def __init__(self, tracks: Tracks, limits: Limits):
        self.tracks, self.limits = tracks, limits
        self.low, self.size = limits.low, limits.high - limits.low

    def points(self, u: np.ndarray) -> np.ndarray:
        """Return the waypoints (m, n, 2) of unknowns (m, 2 n)."""
        places = self.low + self.size * np.clip(u, 0.0, 1.0).reshape(len(u), -1, 2)
        return shortened(places, self.limits.length)

    def unknowns(self, points: np.ndarray) -> np.ndarray:
        """Return the unknowns (2 n,) of waypoints (n, 2), moved into the area."""
        return np.clip((points - self.low) / self.size, 0.0, 1.0).ravel()

    def drawn(self, first: np.ndarray, seed: int) -> np.ndarray:
        """Return the best unknowns (STARTS, 2 n) of a first track and others drawn at random."""
        rng = np.random.default_rng(seed)
        near = np.clip(
            first + NEAR * rng.standard_normal((DRAWN // 2, len(first))), 0.0, 1.0
        )
        u = np.vstack([first, near, rng.random((DRAWN // 2, len(first)))])
        return u[np.argsort(self.cost(u), kind="stable")[:STARTS]]

    def cost(self, u: np.ndarray) -> np.ndarray:
        """Return -log kappa_1 of unknowns (m, 2 n), or how far they go beyond a limit."""
        least, extremes = self.tracks(self.points(u))
        beyond = self.limits.excess(extremes)
        found = -np.log(np.maximum(least.min(axis=0), LEAST))
        return np.where(beyond > 0, BEYOND * (1 + beyond), found)

    def climb(self, u: np.ndarray) -> np.ndarray:
        """Return unknowns uphill of u: the best on the way that keep to the limits."""
        from scipy.optimize import minimize

        @lru_cache(maxsize=1)  # SLSQP asks for values and slopes one after the other
        def values(of: bytes) -> tuple[np.ndarray, np.ndarray]:
            check()
            y, steps = np.frombuffer(of), STEP * np.eye(len(u))
            least, extremes = self.tracks(self.points(np.vstack([y, y + steps])))
            rows = np.vstack(
                [np.log(np.maximum(least, LEAST)), self.limits.slack(extremes)]
            )
            return rows[:, 0], (rows[:, 1:] - rows[:, :1]) / STEP

        def above(y: np.ndarray) -> np.ndarray:
            found = values(y[:-1].tobytes())[0].copy()
            found[:2] -= y[-1]
            found[2:] -= INSIDE
            return found

        def slopes(y: np.ndarray) -> np.ndarray:
            found = values(y[:-1].tobytes())[1]
            return np.column_stack(
                [found, np.where(np.arange(len(found)) < 2, -1.0, 0.0)]
            )

        start = values(u.tobytes())[0]
        if not np.isfinite(start).all():
            return u
        towards: Any = np.append(np.zeros(len(u)), -1.0)
        ended = minimize(
            lambda y: -y[-1],
            np.append(u, start[:2].min()),
            jac=lambda y: towards,
            method="SLSQP",
            bounds=[(0.0, 1.0)] * len(u) + [(None, None)],
            constraints={"type": "ineq", "fun": above, "jac": slopes},
            options={"maxiter": CLIMBS},
        )
        way = u + np.linspace(0.0, 1.0, WAY)[:, None] * (
            np.clip(ended.x[:-1], 0.0, 1.0) - u
        )
        return np.asarray(way[np.argmin(self.cost(way))])


COARSE = (9, 1e-6)  # looks in a piece, relative tolerance
CLOSE = (129, 1e-9)
ROUNDS = 6


def best_waypoints(
    scenario: Scenario,
    limits: Limits,
    span: tuple[float, float],
    seed: int,
    report: Callable[[float], None],
    gains: np.ndarray | None = None,
) -> tuple[list[np.ndarray], int]:
    """Return waypoints that keep to the limits, the best first, and how many tracks were tried.

    The best have the largest kappa_1, or drop of V where the `gains` of a linear law are given.
    """
    speeds, end, whole = limits.max_speed is not None, sum(span), scenario.run.duration
    close = Tracks(scenario, span, whole, *CLOSE, speeds, gains)
    points, runs, free = shortened(scenario.waypoints, limits.length), 0, MARGIN
    candidates = [_looked_at(close, limits, points)]  # the track to begin with competes
    for iteration in range(ROUNDS):
        tracks = Tracks(
            scenario, span, whole if iteration else end, *COARSE, speeds, gains
        )
        search = TrackSearch(tracks, limits.tighter(free))
        starts = search.unknowns(points)[None]
        if iteration == 0:
            starts = search.drawn(starts[0], seed)
        ends = np.array([search.climb(u) for u in starts])
        order = np.argsort(search.cost(ends), kind="stable")
        points = search.points(ends)[order[0]]
        candidates += [
            _looked_at(close, limits, one) for one in search.points(ends)[order[::-1]]
        ]
        last = candidates[-1]
        runs += tracks.runs
        report(0.9 * (iteration + 1) / ROUNDS)
        if last.least >= 0 and (
            iteration or end == whole or last.least >= candidates[0].least
        ):
            break
        if iteration:
            free = min(0.3, free + max(MARGIN, 1.1 * last.beyond))
    candidates.sort(key=lambda one: -one.least)
    if candidates[0].least < 0:
        nearest = 100 * min(one.beyond for one in candidates)
        raise ScenarioError(
            "no track was found that keeps to the limits in this flow all the time; the nearest "
            f"is {nearest:.2g} % beyond; allow more speed or a larger area, or give another seed"
        )
    return [one.points for one in candidates if one.least >= 0], runs


class _Candidate(NamedTuple):
    """Waypoints, their kappa_1, -1 beyond a limit, and how far they are beyond."""

    points: np.ndarray
    least: float
    beyond: float


def _looked_at(close: Tracks, limits: Limits, points: np.ndarray) -> _Candidate:
    """Return waypoints with their kappa_1 and their excess, closely watched."""
    least, extremes = close(points[None])
    beyond = float(limits.excess(extremes)[0])
    out = bool(np.any((points < limits.low) | (points > limits.high)))
    return _Candidate(points, -1.0 if beyond > 0 or out else float(least.min()), beyond)
