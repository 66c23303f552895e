"""Routes: times of arrival at waypoints days away, and the share of draws in forbidden areas.

The coming dives are drawn `DRAWS` times; `NOWHERE` times if none arrives.  Each dive is aimed at
the next waypoint (`aim`), by what is known when it begins; its way through the water, its duration
and the drift before it are drawn from their spread (`surfacing`), its position error from
the forecast's mean and covariance.  A drawn dive is learned before the next one is aimed: drawn one
after the other, each given those before it, position errors have their joint distribution.
A waypoint is made by the dive that is to end there, or ends within `ARRIVED` of it.

The times of arrival are the quantiles 1 - `LEVEL`, 1/2 and `LEVEL` of the draws; a draw that does
not arrive within `DIVES` dives counts as later than all.  An area is entered where the straight way
of a dive meets its outer ring, on the plane of longitude and latitude.

A file of a route is GeoJSON (RFC 7946): points and lines are waypoints in their order, polygons
areas to stay out of, with their property `name`; or a text with a latitude and a longitude a line.
"""

import json
from collections.abc import Callable, Iterator
from dataclasses import replace
from math import exp, inf, isfinite
from pathlib import Path as File
from typing import Any

import numpy as np

from ...base.errors import DataError, naming
from ...base.files.reading import read_text
from ...base.geodesy import angle_near, distance, is_place, place_from
from ...base.progress.interrupt import check
from ..estimation.fix_model import LEVEL
from ..gliders.dives import Fix, make_dive
from .aim import ARRIVED, aim, usual
from .replay import Replay
from .table_rows import REACHED, Place, in_minutes, placed, utc

DRAWS, DIVES, SEED = 100, 100, 1
NOWHERE = 40  # draws of a vehicle that arrives nowhere
MOST_PLACES = 20_000  # of all areas
LARGEST = 10**7  # bytes of a file
SHARES = {"not_before": round(1.0 - LEVEL, 9), "time": 0.5, "by": LEVEL}
# places of an area, by its name, or of waypoints
Shape = tuple[str | None, list[Place]]
Area = tuple[str, list[Place]]  # a name and a ring


def read_route(path: File) -> tuple[list[Place], list[Area]]:
    """Return the waypoints in a file in their order, and the areas to stay out of."""
    text = read_text(path, "is not text; must be GeoJSON or lines of places", LARGEST)
    with naming(path):
        return _route(text)


def _route(text: str) -> tuple[list[Place], list[Area]]:
    try:
        is_json = text.lstrip().startswith("{")
        shapes = list(_shapes(json.loads(text)) if is_json else _lines(text))
    except Exception as error:  # what is neither can raise anything
        why = f"is neither GeoJSON nor a latitude and a longitude a line: {error}"
        raise DataError(why) from None
    for lat, lon in (point for _, points in shapes for point in points):
        if not is_place(lat, lon):
            raise DataError(f"latitude {lat:g}, longitude {lon:g} is not a position")
    targets = [point for name, points in shapes if name is None for point in points]
    if not targets:
        raise DataError("has no waypoint. Give points, or a line of them")
    areas = [(name, points) for name, points in shapes if name is not None]
    count = sum(len(ring) for _, ring in areas)
    if len(targets) > DIVES or count > MOST_PLACES:
        raise DataError(
            f"has {len(targets)} waypoints, and areas of {count} points; at most {DIVES}, as so "
            f"many dives are drawn, and {MOST_PLACES}"
        )
    return targets, areas


def _lines(text: str) -> Iterator[Shape]:
    for line in text.splitlines():
        if words := line.partition("#")[0].replace(",", " ").split():
            lat, lon = map(float, words)
            yield None, [(lat, lon)]


def _shapes(data: dict[str, Any], name: str = "area") -> Iterator[Shape]:
    name = str((data.get("properties") or {}).get("name") or name)
    inner = *data.get("features", ()), *data.get("geometries", ()), data.get("geometry")
    for part in filter(None, inner):
        yield from _shapes(part, name)
    if "coordinates" not in data:
        return
    several = data["type"] in ("MultiPolygon", "MultiLineString")
    for part in data["coordinates"] if several else [data["coordinates"]]:
        if not data["type"].endswith("Polygon"):
            yield None, _points(part)
            continue
        ring = _points(part[0])
        if len(set(ring)) < 3:
            raise ValueError("an area has at least three corners")
        yield name, ring


def _points(pairs: list[Any]) -> list[Place]:
    """Return places of a pair longitude, latitude, or of a list of them; heights are left out."""
    points = np.atleast_2d(np.array(pairs, float))
    if points.ndim > 2:
        raise ValueError("places are pairs of longitude and latitude")
    return [(lat, lon) for lon, lat in points[:, :2].tolist()]


def arrivals(
    replay: Replay,
    targets: list[Place],
    areas: list[Area],
    speed: float | None,
    duration: float | None,
    report: Callable[[float], None] = lambda share: None,
    draws: int = DRAWS,
    dives: int = DIVES,
) -> dict[str, Any]:
    """Return when a replay's vehicle is at each waypoint, and how often areas are entered."""
    V, T = usual(replay, speed, duration)
    rng = np.random.default_rng(SEED)
    times, entered, drawn = list[list[float]](), list[list[bool]](), 0
    rings = [np.array([*ring, ring[0]]) for _, ring in areas]
    most = NOWHERE * dives
    while len(times) < draws and drawn < most:
        check()
        arrived, legs = _draw(replay, targets, V, T, dives, rng)
        times.append(arrived + [inf] * (len(targets) - len(arrived)))
        entered.append([any(_meets(*leg, ring) for leg in legs) for ring in rings])
        drawn += len(legs)
        report(max(len(times), draws * min(drawn / most, 1.0)))
    waypoints = []
    for point, times_of_point in zip(targets, np.transpose(times), strict=True):
        quantiles = np.quantile(
            times_of_point, list(SHARES.values()), method="inverted_cdf"
        ).tolist()
        dates = [utc(time) if isfinite(time) else None for time in quantiles]
        waypoints.append(
            {**placed("", *point), "place": in_minutes(*point)}
            | {
                "made": float(np.isfinite(times_of_point).mean()),
                **dict(zip(SHARES, dates, strict=True)),
            }
        )
    shares = [
        {"name": name, "entered": share, "ring": ring}
        for (name, ring), share in zip(
            areas, np.mean(entered, axis=0).tolist(), strict=True
        )
    ]
    return {
        "draws": len(times),
        "dives": dives,
        "waypoints": waypoints,
        "areas": shares,
    }


def _draw(
    replay: Replay,
    targets: list[Place],
    V: float,
    T: float,
    dives: int,
    rng: np.random.Generator,
) -> tuple[list[float], list[tuple[Place, Place]]]:
    """Draw the dives to come once: times of arrival, s since 1970, and the ends of each way."""
    learned = replay.imagined()
    start = learned.start(rng)
    arrived: list[float] = []
    legs: list[tuple[Place, Place]] = []
    for _ in range(dives):
        target = targets[len(arrived)]
        leg = aim(learned, start, target, V, T)
        plan = leg.ahead.plan
        guess = learned.dive_statistics.guess_of(plan.through_water, plan.duration)
        east, north, late = rng.multivariate_normal(
            np.zeros(3), guess.scatter, check_valid="ignore"
        )
        flown = replace(
            plan,
            t_gpse=start[0] + plan.duration * exp(late),
            dr_east=plan.dr_east + east,
            dr_north=plan.dr_north + north,
        )
        miss = rng.multivariate_normal(*learned.ahead(flown), check_valid="ignore")
        through = flown.through_water
        end: Fix = (flown.t_gpse, *place_from(*start[1:], *(through + miss)))
        legs.append((start[1:], end[1:]))
        if leg.state == REACHED or distance(*end[1:], *target) < ARRIVED:
            arrived.append(end[0])
            if len(arrived) == len(targets):
                break
        learned.imagine(make_dive(plan.number, start, end, through))
        start = learned.start(rng)
    return arrived, legs


def _meets(start: Place, end: Place, ring: np.ndarray) -> bool:
    """Return whether a straight way meets an area, of a closed ring.

    >>> corners = (0.0, 179.0), (1.0, 179.0), (1.0, -179.0), (0.0, -179.0), (0.0, 179.0)
    >>> square = np.array(corners)
    >>> [_meets((-1.0, x), (2.0, x), square) for x in (179.5, -179.5, 178.0)]
    [True, True, False]
    >>> _meets((0.4, 180.0), (0.5, -180.0), square)  # within
    True
    """
    from matplotlib.path import Path

    area, line = (
        Path(np.column_stack([points[:, 0], angle_near(points[:, 1], start[1])]))
        for points in (ring, np.array([start, end]))
    )
    return bool(area.intersects_path(line, filled=True))
