"""Lines as a pen draws them: dots where a net branches, no piece twice."""

from itertools import pairwise

from .layers import Net

Point = tuple[float, float]


def branchings(paths: dict[tuple[int, str], list[Point]]) -> list[Point]:
    """Find where three or more ends of one net meet."""
    dots: dict[Point, None] = {}
    for net in dict.fromkeys(k for k, _ in paths):
        pieces = [(a, b) for (k, _), path in paths.items() if k == net for a, b in pairwise(path)]
        for point in dict.fromkeys(p for piece in pieces for p in piece):
            ways = {way for piece in pieces for way in _ways(point, *piece)}
            if len(ways) > 2:
                dots[point] = None
    return list(dots)


def strokes(
    paths: dict[tuple[int, str], list[Point]], nets: list[Net]
) -> dict[tuple[int, str], list[Point]]:
    """Shorten paths to what earlier paths of the net leave out."""
    inked: dict[tuple[int, Point, tuple[int, int]], float] = {}
    drawn = {}
    for (k, target), path in sorted(
        paths.items(), key=lambda item: item[0][1] in nets[item[0][0]].back
    ):
        rest = list(path)
        while len(rest) > 2:
            (a, b), way = rest[:2], _ways(rest[0], *rest[:2])[0]
            length = abs(b[0] - a[0]) + abs(b[1] - a[1])
            done = min(inked.get((k, a, way), 0.0), length)
            rest[0] = (a[0] + way[0] * done, a[1] + way[1] * done)
            if done < length:
                break
            rest.pop(0)
        drawn[k, target] = rest
        for a, b in pairwise(path):
            key = (k, a, _ways(a, a, b)[0])
            inked[key] = max(inked.get(key, 0.0), abs(b[0] - a[0]) + abs(b[1] - a[1]))
    return drawn


def _ways(point: Point, a: Point, b: Point) -> list[tuple[int, int]]:
    """Return the directions in which a straight piece leaves a point on it."""
    x, y = point
    inside = min(a[0], b[0]) <= x <= max(a[0], b[0]) and min(a[1], b[1]) <= y <= max(a[1], b[1])
    if not inside:
        return []
    signs = [((end[0] > x) - (end[0] < x), (end[1] > y) - (end[1] < y)) for end in (a, b)]
    return [sign for sign in signs if sign != (0, 0)]
