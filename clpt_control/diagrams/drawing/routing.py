"""How arrows run around the boxes, in points, y downwards.

Boxes of a layer share a column.  Between columns lies a channel: at its sides
the texts of the ports, in its middle one vertical track for each net that
turns there.  Feedback runs in lanes above and below all boxes.  So no arrow
runs through a box or a text.  `strokes` leaves no piece of a net to be drawn twice.
Which track and which lane a net turns in is chosen before its corners are laid.
"""

from collections.abc import Callable
from dataclasses import dataclass
from itertools import pairwise
from math import dist

from .layers import GRID, Boxes, Layered, Net, Sizes, place

TRACK, ARROW = 7.0, 9.0  # points between tracks, and of an arrow's head
LANE, APART = 10.0, 7.0  # points between lanes, and between turns of one track
Point = tuple[float, float]
Width = Callable[[str], float]  # of a text
Paths = dict[tuple[int, str], list[Point]]  # net and target, or "" without one -> corners


@dataclass
class Turn:
    """What one net does in one channel."""

    net: int
    lefts: list[float]  # heights at which it comes in
    rights: list[float]  # heights at which it goes out
    lane: float | None = None  # height of the feedback lane it comes from or goes to
    x: float = 0.0  # its track

    @property
    def ends(self) -> list[float]:
        """Return all heights that it joins."""
        return self.lefts + self.rights + ([] if self.lane is None else [self.lane])


Channels = dict[int, list[Turn]]  # channel c, behind layer c -> what nets do in it


def lanes_of(layered: Layered, boxes: Boxes, above: dict[int, bool]) -> dict[int, float]:
    """Return the height of each feedback net's lane; short ones run inside."""
    top = min(box.y - box.height / 2 for box in boxes.values()) - LANE
    bottom = max(box.y + box.height / 2 for box in boxes.values()) + LANE
    spans = {}
    for k in above:
        net = layered.nets[k]
        spans[k] = (min(layered.rank[t] for t in net.back) - 1, layered.rank[net.source])
    lanes: dict[int, float] = {}
    for side in (True, False):
        taken: list[list[tuple[int, int]]] = []
        nets = [k for k in above if above[k] == side]
        for k in sorted(nets, key=lambda k: spans[k][1] - spans[k][0]):
            start, end = spans[k]
            taken.append([])
            row = next(
                r for r, used in enumerate(taken) if all(end < a or b < start for a, b in used)
            )
            taken[row].append(spans[k])
            lanes[k] = top - row * LANE if side else bottom + row * LANE
    return lanes


def channels_of(layered: Layered, boxes: Boxes, lanes: dict[int, float]) -> Channels:
    """Return what each net does in each channel; channel c lies behind layer c."""
    channels: Channels = {c: [] for c in range(-1, len(layered.layers))}
    for k, net in enumerate(layered.nets):
        out = boxes[net.source].port(k, True)
        for c, turns in channels.items():
            if hop := layered.hops.get((c, k)):
                rights = [boxes[end].port(k, False) for end in hop.ends]
                turns.append(Turn(k, [boxes[hop.start].port(k, True)], rights))
            ends = [t for t in net.targets if t in net.back and layered.rank[t] == c + 1]
            starts = [net.source] if net.back and layered.rank[net.source] == c else []
            if starts or ends:
                rights = [boxes[end].port(k, False) for end in ends]
                turns.append(Turn(k, [out] * len(starts), rights, lanes[k]))
    return channels


def sort_tracks(turns: list[Turn]) -> None:
    """Order tracks so that few cross and none run on top of another."""

    def cost(a: Turn, b: Turn) -> float:
        if a.net == b.net:
            return 0.0
        crossed = sum(min(b.ends) <= y <= max(b.ends) for y in a.rights)
        crossed += sum(min(a.ends) <= y <= max(a.ends) for y in b.lefts)
        return crossed + 1000 * sum(abs(y - z) < 1 for y in a.rights for z in b.lefts)

    better = True
    while better:
        better = False
        for turn in list(turns):
            here = turns.index(turn)
            rest = turns[:here] + turns[here + 1 :]
            costs = [
                sum(cost(a, turn) for a in rest[:k]) + sum(cost(turn, b) for b in rest[k:])
                for k in range(len(turns))
            ]
            best = costs.index(min(costs))
            if costs[best] < costs[here]:
                turns[:] = [*rest[:best], turn, *rest[best:]]
                better = True


def overlap(a: Turn, b: Turn) -> bool:
    """Return whether two turns are too close to share a track."""
    return min(a.ends) < max(b.ends) + APART and min(b.ends) < max(a.ends) + APART


@dataclass
class Routed:
    """A finished layout."""

    boxes: Boxes  # with passages among them
    paths: Paths
    dots: list[Point]  # where a net branches
    width: float
    height: float


def route(layered: Layered, sizes: Sizes, text_width: Width) -> Routed:
    """Place the boxes and lead the arrows around them."""
    boxes, above = place(layered, sizes)
    lanes = lanes_of(layered, boxes, above)
    channels = channels_of(layered, boxes, lanes)
    for turns in channels.values():
        sort_tracks(turns)
    _columns(layered, boxes, channels, text_width)
    paths = _paths(layered, boxes, channels, text_width)
    left, top, right, bottom = _extent(boxes, paths)
    for box in boxes.values():
        box.x, box.y = box.x - left, box.y - top
    paths = {key: [(x - left, y - top) for x, y in path] for key, path in paths.items()}
    return Routed(boxes, paths, branchings(paths), right - left, bottom - top)


def _columns(layered: Layered, boxes: Boxes, channels: Channels, text_width: Width) -> None:
    """Set x of the boxes and of the tracks, from left to right."""
    x = 0.0
    for c, turns in channels.items():
        if c >= 0:
            width = max(boxes[name].width for name in layered.layers[c])
            for name in layered.layers[c]:
                boxes[name].x, boxes[name].width = x, width
            x += width
        out = [
            text_width(net.text) + (0.0 if net.targets else ARROW)
            for net in layered.nets
            if layered.rank[net.source] == c and net.named_at_source
        ]
        into = [
            text_width(text)
            for net in layered.nets
            for target, text in net.targets.items()
            if layered.rank[target] == c + 1
        ]
        x += max(out, default=0.0) + GRID
        turning = [turn for turn in turns if max(turn.ends) - min(turn.ends) > 1]
        for k, turn in enumerate(turning):
            others = [t.x + TRACK for t in turning[:k] if overlap(t, turn)]
            turn.x = max(others, default=x)
        x = max((turn.x + TRACK for turn in turning), default=x)
        x += max(into, default=0.0) + (ARROW if into else 0.0)


def _paths(layered: Layered, boxes: Boxes, channels: Channels, text_width: Width) -> Paths:
    paths: Paths = {}
    for k, net in enumerate(layered.nets):
        source, rank = boxes[net.source], layered.rank[net.source]
        start = (source.x + source.width, source.port(k, True))
        if not net.targets:
            paths[k, ""] = [start, (start[0] + text_width(net.text) + ARROW, start[1])]
        for target in net.targets:
            box = boxes[target]
            path, end = [start], (box.x, box.port(k, False))
            if target in net.back:
                away, home = (
                    next(t for t in channels[c] if t.net == k and t.lane is not None)
                    for c in (rank, layered.rank[target] - 1)
                )
                lane = away.lane or 0.0
                path += [(away.x, start[1]), (away.x, lane), (home.x, lane), (home.x, end[1])]
            for c in range(rank, layered.rank[target]):  # none of feedback
                turn = next(t for t in channels[c] if t.net == k and t.lane is None)
                last = c + 1 == layered.rank[target]
                y = end[1] if last else boxes[f"pass:{k}:{c + 1}"].y
                if y != path[-1][1]:
                    path += [(turn.x, path[-1][1]), (turn.x, y)]
            paths[k, target] = [*path, end]
    return paths


def _extent(boxes: Boxes, paths: Paths) -> tuple[float, float, float, float]:
    drawn = [box for name, box in boxes.items() if not name.startswith("pass:")]
    corners = [point for path in paths.values() for point in path]
    corners += [(box.x, box.y - box.height / 2) for box in drawn]
    corners += [(box.x + box.width, box.y + box.height / 2) for box in drawn]
    xs, ys = zip(*corners, strict=True)
    return min(xs), min(ys), max(xs), max(ys)


def branchings(paths: Paths) -> list[Point]:
    """Return the points where three or more pieces of one net meet."""
    dots: dict[Point, None] = {}
    for net in dict.fromkeys(k for k, _ in paths):
        pieces = [(a, b) for (k, _), path in paths.items() if k == net for a, b in pairwise(path)]
        for point in dict.fromkeys(p for piece in pieces for p in piece):
            leaving = {direction for piece in pieces for direction in _directions(point, *piece)}
            if len(leaving) > 2:
                dots[point] = None
    return list(dots)


def strokes(paths: Paths, nets: list[Net]) -> Paths:
    """Shorten paths to what earlier paths of the net leave out, feedback last."""
    inked: dict[tuple[int, Point, tuple[int, int]], float] = {}
    drawn = {}
    for (k, target), path in sorted(
        paths.items(), key=lambda item: item[0][1] in nets[item[0][0]].back
    ):
        rest = list(path)
        while len(rest) > 2:
            (a, b), direction = rest[:2], _directions(rest[0], *rest[:2])[0]
            length = dist(a, b)
            done = min(inked.get((k, a, direction), 0.0), length)
            rest[0] = (a[0] + direction[0] * done, a[1] + direction[1] * done)
            if done < length:
                break
            rest.pop(0)
        drawn[k, target] = rest
        for a, b in pairwise(path):
            key = (k, a, _directions(a, a, b)[0])
            inked[key] = max(inked.get(key, 0.0), dist(a, b))
    return drawn


def _directions(point: Point, a: Point, b: Point) -> list[tuple[int, int]]:
    """Return the directions in which a straight piece leaves a point on it."""
    x, y = point
    inside = min(a[0], b[0]) <= x <= max(a[0], b[0]) and min(a[1], b[1]) <= y <= max(a[1], b[1])
    if not inside:
        return []
    signs = [((end[0] > x) - (end[0] < x), (end[1] > y) - (end[1] < y)) for end in (a, b)]
    return [sign for sign in signs if sign != (0, 0)]
