"""The search: differential evolution over all tracks, then climbs on both axes at once.

    maximise kappa_1(w_1 ... w_n),    unknowns in [0, 1]: places in the area's box

Differential evolution (Storn and Price 1997) takes its whole population to the tracks' lanes
at once.  A track beyond a limit costs more than any that keeps to it, the more the farther it is
beyond.  kappa_1 has a ridge where both axes have the same smallest eigenvalue, so a climb asks
SLSQP (Kraft 1988) for the largest s with log kappa of each axis >= s and each slack >= 0;
derivatives are differences, again in lanes.

The search goes in rounds: evolve once, climb, look closely, climb again where a limit is not kept.
The first round watches speed and area up to the window's end, the others over the whole run and
under limits that are tighter by what the last climb was beyond.  The track to begin with competes.
"""

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

from ...errors import ScenarioError
from ...progress.interrupt import check
from ...scenario.experiment import Scenario
from .track_limits import MARGIN, Limits, shortened
from .waypoint_tracks import Tracks

BEYOND = 1e4  # cost of a limit that is not kept, more than -log of any eigenvalue
LEAST = 1e-300
NEAR = 0.15  # spread of the half of the population that begins near the first track
STEP = 1e-6  # of the differences, share of the area's box
STARTS = 4  # of climbs: evolution may not have found the highest hill
CLIMBS = 60  # iterations of SLSQP
INSIDE = 1e-5  # of each limit, that a climb leaves free
WAY = 33  # places looked at between the start and the end of a climb


class TrackSearch:
    """Tracks of `count` waypoints within limits, as points of a unit cube."""

    def __init__(self, tracks: Tracks, limits: Limits, count: int):
        self.tracks, self.limits, self.count = tracks, limits, count
        area = np.array(limits.area)
        self.low, self.size = area[::2], area[1::2] - area[::2]

    def points(self, u: np.ndarray) -> np.ndarray:
        """Return the waypoints (m, n, 2) of unknowns (m, 2 n)."""
        places = self.low + self.size * np.clip(u, 0.0, 1.0).reshape(len(u), self.count, 2)
        return shortened(places, self.limits.length)

    def unknowns(self, points: np.ndarray) -> np.ndarray:
        """Return the unknowns (2 n,) of waypoints (n, 2), moved into the area."""
        return np.clip((points - self.low) / self.size, 0.0, 1.0).ravel()

    def evolve(
        self, first: np.ndarray, generations: int, seed: int, report: Callable[[float], None]
    ) -> np.ndarray:
        """Return `STARTS` unknowns (k, 2 n) of differential evolution from a first track on.

        The best of the last generation first, then others down to the middle of it.
        """
        from scipy.optimize import differential_evolution

        rng = np.random.default_rng(seed)
        m = 8 * -(-max(32, 8 * self.count) // 8)
        near = first + NEAR * rng.standard_normal((m // 2, len(first)))
        population = np.vstack([near, rng.random((m - len(near), len(first)))])
        population[0] = first
        done = 0

        def cost(u: np.ndarray) -> np.ndarray:
            nonlocal done
            check()
            found = self.cost(u.T)
            report(done)
            done += 1
            return found

        ended = differential_evolution(
            cost,
            [(0.0, 1.0)] * len(first),
            init=np.clip(population, 0.0, 1.0),
            maxiter=generations,
            tol=0.0,
            polish=False,
            vectorized=True,
            updating="deferred",
            seed=rng,
        )
        rest = ended.population[np.argsort(ended.population_energies, kind="stable")]
        places = np.linspace(0, len(rest) // 2, STARTS).astype(int)[1:]
        return np.vstack([ended.x, rest[places]])

    def cost(self, u: np.ndarray) -> np.ndarray:
        """Return -log kappa_1 of unknowns (m, 2 n), or how far they go beyond a limit."""
        least, extremes = self.tracks(self.points(u))
        beyond = self.limits.excess(extremes)
        found = -np.log(np.maximum(least.min(axis=0), LEAST))
        return np.where(beyond > 0, BEYOND * (1 + beyond), found)

    def climb(self, u: np.ndarray) -> np.ndarray:
        """Return unknowns uphill of u: the best on the way that keep to the limits."""
        from scipy.optimize import minimize

        cached: dict[bytes, tuple[np.ndarray, np.ndarray]] = {}

        def values(y: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
            key = y[:-1].tobytes()
            if key not in cached:
                check()
                cached.clear()
                steps = STEP * np.eye(len(u))
                least, extremes = self.tracks(self.points(np.vstack([y[:-1], y[:-1] + steps])))
                rows = np.vstack([np.log(np.maximum(least, LEAST)), self.limits.slack(extremes)])
                cached[key] = rows[:, 0], (rows[:, 1:] - rows[:, :1]) / STEP
            return cached[key]

        def above(y: np.ndarray) -> np.ndarray:
            found = values(y)[0].copy()
            found[:2] -= y[-1]
            found[2:] -= INSIDE
            return found

        def slopes(y: np.ndarray) -> np.ndarray:
            found = values(y)[1]
            return np.column_stack([found, np.where(np.arange(len(found)) < 2, -1.0, 0.0)])

        start = np.append(u, 0.0)
        start[-1] = values(start)[0][:2].min()
        if not np.isfinite(values(start)[0]).all():
            return u
        towards: Any = np.append(np.zeros(len(u)), -1.0)
        ended = minimize(
            lambda y: -y[-1],
            start,
            jac=lambda y: towards,
            method="SLSQP",
            bounds=[(0.0, 1.0)] * len(u) + [(None, None)],
            constraints={"type": "ineq", "fun": above, "jac": slopes},
            options={"maxiter": CLIMBS},
        )
        way = u + np.linspace(0.0, 1.0, WAY)[:, None] * (np.clip(ended.x[:-1], 0.0, 1.0) - u)
        return np.asarray(way[np.argmin(self.cost(way))])


COARSE = (9, 1e-6)  # looks in a piece, relative tolerance
CLOSE = (129, 1e-9)
ROUNDS = 6


def best_waypoints(
    scenario: Scenario,
    limits: Limits,
    span: tuple[float, float],
    seed: int,
    generations: int,
    report: Callable[[float], None],
    gains: np.ndarray | None = None,
) -> tuple[list[np.ndarray], int]:
    """Return waypoints that keep to the limits, the best first, and how many tracks were tried.

    The best have the largest kappa_1, or drop of V where the `gains` of a linear law are given.
    """
    speeds, runs, free = limits.max_speed is not None, 0, MARGIN
    end, whole = span[0] + span[1], scenario.run.duration
    close = Tracks(scenario, span, whole, *CLOSE, speeds, gains)
    points = shortened(scenario.waypoints, limits.length)
    candidates = [_looked_at(close, limits, points)]  # the track to begin with competes
    for iteration in range(ROUNDS):
        tracks = Tracks(scenario, span, whole if iteration else end, *COARSE, speeds, gains)
        search = TrackSearch(tracks, limits.tighter(free), len(points))
        again = iteration == ROUNDS - 1 and not any(one.least >= 0 for one in candidates)
        if iteration == 0 or again:
            first = search.unknowns(shortened(scenario.waypoints, limits.length))

            def share(done: float, base: float = 0.5 * (iteration > 0)) -> None:
                report(base + 0.4 * done / (generations + 1))

            starts = search.evolve(first, generations, seed, share)
            candidates += [_looked_at(close, limits, one) for one in search.points(starts)]
        else:
            starts = search.unknowns(points)[None]
        ends = np.array([search.climb(u) for u in starts])
        order = np.argsort(search.cost(ends), kind="stable")
        points = search.points(ends)[order[0]]
        candidates += [_looked_at(close, limits, one) for one in search.points(ends)[order[::-1]]]
        last = candidates[-1]
        runs += tracks.runs
        report(0.4 + 0.5 * (iteration + 1) / ROUNDS)
        if last.least >= 0 and (iteration or end == whole or last.least >= candidates[0].least):
            break
        if iteration:
            free = min(0.3, free + max(MARGIN, 1.1 * last.beyond))
    candidates.sort(key=lambda one: -one.least)
    if candidates[0].least < 0:
        raise ScenarioError(_none(scenario, limits, min(one.beyond for one in candidates)))
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
    low, high = np.array(limits.area[::2]), np.array(limits.area[1::2])
    out = bool(np.any((points < low) | (points > high)))
    return _Candidate(points, -1.0 if beyond > 0 or out else float(least.min()), beyond)


def _none(scenario: Scenario, limits: Limits, nearest: float) -> str:
    """Return in a sentence that no track keeps to the limits."""
    unit, time = scenario.units.length, scenario.units.time
    speed = f"max_speed = {limits.max_speed:g} {unit}/{time} and " if limits.max_speed else ""
    return (
        f"{speed}area = {', '.join(f'{edge:g}' for edge in limits.area)} {unit}: no track was "
        f"found that keeps to them in this flow all the time; the nearest is {100 * nearest:.2g} % "
        "beyond; allow more speed or a larger area, or give more generations"
    )
