"""Multistart search for waypoints with the largest kappa_1 or drop of V.

    maximise kappa_1(w_1 ... w_n),    unknowns in [0, 1]: positions in the box of the area

Random tracks are sampled, half of them near the initial track.  Short SLSQP climbs (Kraft 1988)
start from the best tracks that differ, and the best of their ends are climbed further.  kappa_1
has a ridge where both axes have the same smallest eigenvalue; therefore a climb maximises s
subject to log kappa of each axis >= s and each slack >= 0.  Derivatives are finite differences,
whose tracks run side by side in one compiled batch.

The first round checks speed and area up to the end of the window, later rounds over the whole
run.  A round whose result exceeds a limit is repeated with tighter limits.
"""

from collections.abc import Callable
from functools import lru_cache

import numpy as np

from ...base.errors import ScenarioError
from ...base.progress.interrupt import check
from ...paper.scenario.experiment import Scenario
from .waypoint_tracks import MARGIN, Limits, Tracks, shortened

EXCEEDED = 1e4  # cost of an exceeded limit, above -log of any eigenvalue
SMALLEST = 1e-300
SAMPLES = 800  # random tracks
SPREAD = 0.3  # of the samples near the initial track, share of the area's box
STEP = 1e-6  # of the finite differences, share of the area's box
STARTS = 12  # short climbs
FINALISTS = 2  # climbs that continue
SEPARATION = 0.1  # rms distance between starts, share of the area's box
SHORT_CLIMB = 8  # iterations of SLSQP
LONG_CLIMB = 60
SLACK = 1e-5  # of each limit, which a climb leaves free
LINE = 33  # points checked between the start and the end of a climb


class TrackSearch:
    """Tracks with the scenario's number of waypoints, as points of a unit cube."""

    def __init__(self, tracks: Tracks, limits: Limits):
        self.tracks = tracks
        self.limits = limits
        self.low = limits.low
        self.size = limits.high - limits.low

    def waypoints(self, unknowns: np.ndarray) -> np.ndarray:
        """Return the waypoints (m, n, 2) of unknowns (m, 2 n)."""
        shares = np.clip(unknowns, 0.0, 1.0).reshape(len(unknowns), -1, 2)
        return shortened(self.low + self.size * shares, self.limits.length)

    def unknowns(self, waypoints: np.ndarray) -> np.ndarray:
        """Return the unknowns (2 n,) of waypoints (n, 2), moved into the area."""
        return np.clip((waypoints - self.low) / self.size, 0.0, 1.0).ravel()

    def cost(self, unknowns: np.ndarray) -> np.ndarray:
        """Return -log kappa_1 of unknowns (m, 2 n), larger beyond a limit."""
        kappa, extremes = self.tracks(self.waypoints(unknowns))
        excess = self.limits.excess(extremes)
        cost = -np.log(np.maximum(kappa.min(axis=0), SMALLEST))
        return np.where(excess > 0, EXCEEDED * (1 + excess), cost)

    def sorted(self, unknowns: np.ndarray) -> np.ndarray:
        """Return unknowns (m, 2 n) by rising cost."""
        return unknowns[np.argsort(self.cost(unknowns), kind="stable")]

    def distinct(self, unknowns: np.ndarray, count: int) -> np.ndarray:
        """Return the unknowns of least cost that are SEPARATION apart."""
        chosen: list[np.ndarray] = []
        for candidate in self.sorted(unknowns):
            distances = [np.linalg.norm(candidate - start) for start in chosen]
            if min(distances, default=np.inf) > SEPARATION * np.sqrt(len(candidate)):
                chosen.append(candidate)
        return np.array(chosen[:count])

    def multistart(self, initial: np.ndarray, seed: int) -> np.ndarray:
        """Return the ends of all climbs, those of the long ones first, by cost."""
        rng = np.random.default_rng(seed)
        shape = SAMPLES // 2, len(initial)
        nearby = initial + SPREAD * rng.standard_normal(shape)
        nearby = np.clip(nearby, 0.0, 1.0)
        uniform = rng.random(shape)
        samples = np.vstack([initial, nearby, uniform])
        starts = self.distinct(samples, STARTS)
        ends = np.array([self.climb(start, SHORT_CLIMB) for start in starts])
        finalists = self.distinct(ends, FINALISTS)
        final = np.array([self.climb(start, LONG_CLIMB) for start in finalists])
        return np.vstack([self.sorted(final), ends])

    def climb(self, start: np.ndarray, iterations: int) -> np.ndarray:
        """Return the unknowns of least cost between a start and the end of SLSQP."""
        from scipy.optimize import minimize

        steps = STEP * np.eye(len(start))

        @lru_cache(maxsize=1)  # SLSQP requests values and derivatives separately
        def margins(buffer: bytes) -> tuple[np.ndarray, np.ndarray]:
            """Return log kappa of both axes and the slacks, and their derivatives."""
            check()
            unknowns = np.frombuffer(buffer)
            batch = self.waypoints(np.vstack([unknowns, unknowns + steps]))
            kappa, extremes = self.tracks(batch)
            log_kappa = np.log(np.maximum(kappa, SMALLEST))
            rows = np.vstack([log_kappa, self.limits.slack(extremes) - SLACK])
            return rows[:, 0], (rows[:, 1:] - rows[:, :1]) / STEP

        values, _ = margins(start.tobytes())
        if not np.isfinite(values).all():
            return start
        # the last unknown is s, which only the two rows of log kappa contain
        of_s = np.where(np.arange(len(values)) < 2, -1.0, 0.0)
        gradient = np.append(np.zeros(len(start)), -1.0)
        solution = minimize(
            lambda y: -y[-1],
            np.append(start, values[:2].min()),
            jac=lambda y: gradient,
            method="SLSQP",
            bounds=[(0.0, 1.0)] * len(start) + [(None, None)],
            constraints={
                "type": "ineq",
                "fun": lambda y: margins(y[:-1].tobytes())[0] + of_s * y[-1],
                "jac": lambda y: np.column_stack([margins(y[:-1].tobytes())[1], of_s]),
            },
            options={"maxiter": iterations},
        )
        shares = np.linspace(0.0, 1.0, LINE)[:, None]
        end = np.clip(solution.x[:-1], 0.0, 1.0)
        return self.sorted(start + shares * (end - start))[0]


COARSE = (9, 1e-6)  # samples in a piece, relative tolerance
FINE = (129, 1e-9)
ROUNDS = 6


def best_waypoints(
    scenario: Scenario,
    limits: Limits,
    window: tuple[float, float],
    seed: int,
    report: Callable[[float], None],
    gains: np.ndarray | None,
) -> tuple[list[np.ndarray], int]:
    """Return waypoints within the limits, the best first, and the number of tracks tried.

    The best have the largest kappa_1, or drop of V if the `gains` of a linear law are given.
    """
    duration = scenario.run.duration
    with_speed = limits.max_speed is not None
    fine = Tracks(scenario, window, duration, *FINE, with_speed, gains)
    tracks = shortened(scenario.waypoints, limits.length)[None]
    candidates = [(tracks, *_measure(fine, limits, tracks))]
    initial_kappa = candidates[0][1][0]
    tracks_tried, margin = 0, MARGIN
    for iteration in range(ROUNDS):
        # Step 1: climb, from many samples in the first round
        end = duration if iteration else sum(window)
        coarse = Tracks(scenario, window, end, *COARSE, with_speed, gains)
        search = TrackSearch(coarse, limits.tighter(margin))
        start = search.unknowns(tracks[0])
        if iteration == 0:
            ends = search.multistart(start, seed)
        else:
            ends = search.climb(start, LONG_CLIMB)[None]
        # Step 2: check the limits closely over the whole run
        tracks = search.waypoints(ends)
        kappa, excess = _measure(fine, limits, tracks)
        candidates.append((tracks, kappa, excess))
        tracks_tried += coarse.runs
        report(0.9 * (iteration + 1) / ROUNDS)
        # Step 3: stop, or tighten the limits by what the best track exceeds
        if kappa[0] >= (0 if iteration else max(0, initial_kappa)):
            break
        if iteration:
            margin = min(0.3, margin + max(MARGIN, 1.1 * float(excess[0])))
    tracks, kappa, excess = map(np.concatenate, zip(*candidates, strict=True))
    if kappa.max() < 0:
        raise ScenarioError(
            "no track satisfies the limits in this flow at all times: the best "
            f"track exceeds them by {100 * excess.min():.2g} %. Allow more speed or a "
            "larger area, or give "
            "another seed"
        )
    order = np.argsort(-kappa, kind="stable")
    return list(tracks[order[kappa[order] >= 0]]), tracks_tried


def _measure(
    fine: Tracks, limits: Limits, tracks: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Return kappa_1 of tracks (m, n, 2), -1 beyond a limit, and their excess."""
    kappa, extremes = fine(tracks)
    excess = limits.excess(extremes)
    outside = (tracks < limits.low) | (tracks > limits.high)
    exceeded = (excess > 0) | outside.any(axis=(1, 2))
    return np.where(exceeded, -1.0, kappa.min(axis=0)), excess
