"""The search in rounds: evolve once, climb, look closely, climb again where a limit is not kept.

The first round watches speed and area up to the window's end, the others over the whole run and
under limits that are tighter by what the last climb was beyond.  The track to begin with competes.
"""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from ...errors import ScenarioError
from ...scenario.experiment import Scenario
from .limits import MARGIN, Limits, shortened
from .search import Search
from .tracks import Tracks

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
) -> tuple[np.ndarray, int]:
    """Return the best waypoints that keep to the limits, and how many tracks were tried."""
    speeds, runs, free = limits.max_speed is not None, 0, MARGIN
    end, whole = span[0] + span[1], scenario.run.duration
    close = Tracks(scenario, span, whole, *CLOSE, speeds=speeds)
    points = shortened(scenario.waypoints, limits.length)
    kept = [_judged(close, limits, points)]  # the track to begin with competes
    for turn in range(ROUNDS):
        tracks = Tracks(scenario, span, whole if turn else end, *COARSE, speeds=speeds)
        search = Search(tracks, limits.tighter(free), len(points))
        again = turn == ROUNDS - 1 and not any(one.least >= 0 for one in kept)
        if turn == 0 or again:
            first = search.unknowns(shortened(scenario.waypoints, limits.length))

            def shown(done: float, base: float = 0.5 * (turn > 0)) -> None:
                report(base + 0.4 * done / (generations + 1))

            starts = search.evolve(first, generations, seed, shown)
            kept.append(_judged(close, limits, search.points(starts[:1])[0]))
        else:
            starts = search.unknowns(points)[None]
        ends = np.array([search.climb(u) for u in starts])
        points = search.points(ends)[np.argmin(search.cost(ends))]
        kept.append(_judged(close, limits, points))
        runs += tracks.runs
        report(0.4 + 0.5 * (turn + 1) / ROUNDS)
        if kept[-1].least >= 0 and (turn or end == whole or kept[-1].least >= kept[0].least):
            break
        if turn:
            free = min(0.3, free + max(MARGIN, 1.1 * kept[-1].beyond))
    best = max(kept, key=lambda one: one.least)
    if best.least < 0:
        raise ScenarioError(_none(scenario, limits, min(one.beyond for one in kept)))
    return best.points, runs


class _Judged(NamedTuple):
    """Waypoints, their kappa_1, -1 beyond a limit, and how far they are beyond."""

    points: np.ndarray
    least: float
    beyond: float


def _judged(close: Tracks, limits: Limits, points: np.ndarray) -> _Judged:
    least, extremes = close(points[None])
    beyond = float(limits.excess(extremes)[0])
    low, high = np.array(limits.area[::2]), np.array(limits.area[1::2])
    out = bool(np.any((points < low) | (points > high)))
    return _Judged(points, -1.0 if beyond > 0 or out else float(least.min()), beyond)


def _none(scenario: Scenario, limits: Limits, nearest: float) -> str:
    """Return in a sentence that no track keeps to the limits."""
    unit, time = scenario.units.length, scenario.units.time
    speed = f"max_speed = {limits.max_speed:g} {unit}/{time} and " if limits.max_speed else ""
    return (
        f"{speed}area = {', '.join(f'{edge:g}' for edge in limits.area)} {unit}: no track was "
        f"found that keeps to them in this flow all the time; the nearest is {100 * nearest:.2g} % "
        "beyond; allow more speed or a larger area, or give more generations"
    )
