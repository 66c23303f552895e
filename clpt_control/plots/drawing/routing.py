"""Heights of boxes and paths of arrows around them, in points, y downwards.

Arrows climb and fall as little as the order of the layers allows, a linear program.  Arrows of
passages have larger weights, as long lines should be straight.  All heights are on one grid, so
that arrows are either straight or visibly bent.

Boxes of a layer share a column.  Between columns lies a channel: at its sides the texts of the
ports, in its middle one vertical track for each net that turns there.  So no arrow runs through a
box or a text.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass, field
from itertools import combinations, pairwise
from statistics import mean

from .layers import Layered, Turn

GRID, PITCH, GAP = 7.0, 14.0, 14.0  # points; of heights, of ports, between boxes
WEIGHTS = 1.0, 2.0, 8.0  # of an arrow with so many passages at its ends
FEEDBACK = 0.25  # of these weights
NEAR = 0.01  # of the distance from the middle
TRACK, ARROW = 7.0, 9.0  # points between tracks, and of an arrow's head
APART = 7.0  # points between turns of one track
Point = tuple[float, float]
Width = Callable[[str], float]  # of a text
# net and target, or "" without one -> corners
Paths = dict[tuple[int, str], list[Point]]
Sizes = dict[str, tuple[float, float]]  # of boxes by name, points


@dataclass
class Box:
    """A block, an input of the diagram, or a passage for a net."""

    width: float  # a passage has no size
    height: float
    x: float = 0.0  # left edge
    y: float = 0.0  # centre
    # nets at its left side, from top to bottom
    ins: list[int] = field(default_factory=list)
    outs: list[int] = field(default_factory=list)  # nets at its right side

    def port(self, net: int, out: bool) -> float:
        """Return the height at which a net meets the box."""
        nets = self.outs if out else self.ins
        if net not in nets:
            return self.y
        return self.y + (nets.index(net) - (len(nets) - 1) / 2) * PITCH


@dataclass
class Routed:
    """A finished layout."""

    boxes: dict[str, Box]  # with passages among them
    paths: Paths
    dots: list[Point]  # where a net branches
    width: float
    height: float


class _Router:
    """The boxes of a layout, as they are placed and joined."""

    def __init__(self, layered: Layered, sizes: Sizes, text_width: Width):
        self.layered, self.rank, self.text_width = layered, layered.rank, text_width
        self.boxes = {name: Box(*sizes.get(name, (0.0, 0.0))) for name in layered.rank}
        for k, net in enumerate(layered.nets):
            self.boxes[net.source].outs.append(k)
            for target in net.targets:
                self.boxes[target].ins.append(k)
        for name, box in self.boxes.items():
            if not name.startswith(("in:", "pass:")):
                box.height = max(box.height, max(len(box.ins), len(box.outs)) * PITCH)

    def meets(self, c: int, net: int, name: str) -> float:
        """Return the height at which a net in a channel meets a box or a passage."""
        return self.boxes[name].port(net, self.rank[name] == c)

    def turns(self) -> list[tuple[int, Turn]]:
        """Return the channels and turns of all nets."""
        return [
            (c, turn) for c, turns in self.layered.channels.items() for turn in turns
        ]

    # --- how high ---------------------------------------------------------------------------------

    def level(self) -> None:
        """Move the boxes to heights at which arrows climb and fall least, else near the middle."""
        from scipy.optimize import linprog
        from scipy.sparse import coo_array

        # unknowns: heights of the boxes, the middle, and the climb of each arrow
        boxes = self.boxes
        number = {name: k for k, name in enumerate(boxes)}
        middle = len(number)
        # from, to, offset, weight
        climbs = [(k, middle, 0.0, NEAR) for k in number.values()]
        for c, turn in self.turns():
            start = self.meets(c, turn.net, turn.start) - boxes[turn.start].y
            for end in turn.ends:
                offset = self.meets(c, turn.net, end) - boxes[end].y - start
                weight = WEIGHTS[
                    turn.start.startswith("pass:") + end.startswith("pass:")
                ]
                weight *= FEEDBACK if turn.back else 1.0
                climbs.append((number[turn.start], number[end], offset / GRID, weight))

        # rows: coefficients by unknown, and the upper limit of their sum
        rows: list[tuple[dict[int, int], float]] = []
        for names in self.layered.layers:
            for upper, lower in pairwise(names):
                distance = (boxes[upper].height + boxes[lower].height) / 2 + GAP
                rows.append(
                    ({number[upper]: 1, number[lower]: -1}, -math.ceil(distance / GRID))
                )
        for climb, (a, b, offset, _) in enumerate(climbs, middle + 1):
            rows.append(({b: 1, a: -1, climb: -1}, -offset))
            rows.append(({b: -1, a: 1, climb: -1}, offset))
        entries = [
            (row, column, value)
            for row, (coefficients, _) in enumerate(rows)
            for column, value in coefficients.items()
        ]
        row_indices, columns, values = zip(*entries, strict=True)
        matrix = coo_array((values, (row_indices, columns))).tocsr()
        costs = [0.0] * (middle + 1) + [weight for *_, weight in climbs]
        heights = linprog(costs, matrix, [limit for _, limit in rows]).x
        for box, y in zip(boxes.values(), heights, strict=False):
            box.y = GRID * round(y)

    def sort_ports(self) -> None:
        """Sort ports by the heights of the other ends of their nets."""
        starts: dict[tuple[str, int], float] = {}
        ends: dict[int, float] = {}
        for c, turn in self.turns():
            k = turn.net
            starts |= {(end, k): self.meets(c, k, turn.start) for end in turn.ends}
            if turn.start == self.layered.nets[k].source:
                # onward has priority over feedback
                ends.setdefault(k, mean([self.meets(c, k, end) for end in turn.ends]))
        for name, box in self.boxes.items():
            box.ins.sort(key=lambda k: (starts[name, k], k))
            box.outs.sort(key=lambda k: (ends.get(k, math.inf), k))

    # --- from left to right -----------------------------------------------------------------------

    def columns(self) -> None:
        """Set x of the boxes and of the tracks."""
        x, rank, nets = 0.0, self.rank, self.layered.nets
        for c, turns in self.layered.channels.items():
            if c >= 0:
                boxes = [self.boxes[name] for name in self.layered.layers[c]]
                width = max(box.width for box in boxes)
                for box in boxes:
                    box.x, box.width = x, width
                x += width
            idle = [
                net.text for net in nets if rank[net.source] == c and not net.targets
            ]
            texts = [
                text for n in nets for t, text in n.targets.items() if rank[t] == c + 1
            ]
            x += GRID + max(
                (self.text_width(text) + ARROW for text in idle), default=0.0
            )
            turning = [turn for turn in turns if turn.high - turn.low > 1]
            for k, turn in enumerate(turning):
                tracks = [
                    placed.x + TRACK
                    for placed in turning[:k]
                    if placed.low < turn.high + APART and turn.low < placed.high + APART
                ]
                turn.x = max(tracks, default=x)
            x = max((turn.x + TRACK for turn in turning), default=x)
            x += max(map(self.text_width, texts), default=0.0) + (
                ARROW if texts else 0.0
            )

    def paths(self) -> Paths:
        """Return the corners of each arrow."""
        leading = {(t.net, end): (c, t) for c, t in self.turns() for end in t.ends}
        paths = {}
        for k, net in enumerate(self.layered.nets):
            box = self.boxes[net.source]
            start = box.x + box.width, box.port(k, True)
            if not net.targets:
                paths[k, ""] = [
                    start,
                    (start[0] + self.text_width(net.text) + ARROW, start[1]),
                ]
            for target in net.targets:
                # from its end
                path = [(self.boxes[target].x, self.boxes[target].port(k, False))]
                at = ""
                while at != net.source:
                    c, turn = leading[k, at or target]
                    at, y = turn.start, self.meets(c, k, turn.start)
                    if y != path[-1][1]:
                        path += [(turn.x, path[-1][1]), (turn.x, y)]
                paths[k, target] = [start, *path[::-1]]
        return paths


def sort_tracks(turns: list[Turn]) -> None:
    """Order tracks so that few cross and none run on top of another."""

    def cost(a: Turn, b: Turn) -> float:
        if a.net == b.net:
            return 0.0
        crossed = sum(b.low <= y <= b.high for y in a.rights)
        crossed += sum(a.low <= y <= a.high for y in b.lefts)
        return crossed + 1000 * sum(abs(y - z) < 1 for y in a.rights for z in b.lefts)

    for turn in turns * 3:
        fixed = [a for a in turns if a is not turn]
        costs = [
            sum(cost(a, turn) for a in fixed[:k])
            + sum(cost(turn, b) for b in fixed[k:])
            for k in range(len(turns))
        ]
        best = costs.index(min(costs))
        turns[:] = [*fixed[:best], turn, *fixed[best:]]


def route(layered: Layered, sizes: Sizes, text_width: Width) -> Routed:
    """Place the boxes and lead the arrows around them."""
    router = _Router(layered, sizes, text_width)
    for _ in range(3):
        router.level()
        router.sort_ports()
    router.level()
    for c, turns in layered.channels.items():
        for turn in turns:
            for name in (turn.start, *turn.ends):
                heights = turn.lefts if layered.rank[name] == c else turn.rights
                heights.append(router.meets(c, turn.net, name))
        sort_tracks(turns)
    router.columns()
    boxes, paths = router.boxes, router.paths()
    drawn = [box for name, box in boxes.items() if not name.startswith("pass:")]
    corners = [point for path in paths.values() for point in path]
    corners += [(box.x, box.y - box.height / 2) for box in drawn]
    corners += [(box.x + box.width, box.y + box.height / 2) for box in drawn]
    xs, ys = zip(*corners, strict=True)
    x0, y0 = min(xs), min(ys)
    for box in boxes.values():
        box.x, box.y = box.x - x0, box.y - y0
    paths = {key: [(x - x0, y - y0) for x, y in path] for key, path in paths.items()}
    pairs = combinations(paths.items(), 2)
    dots = {common(p, q)[-1]: None for ((k, _), p), ((m, _), q) in pairs if k == m}
    return Routed(boxes, paths, list(dots), max(xs) - x0, max(ys) - y0)


def common(p: list[Point], q: list[Point]) -> list[Point]:
    """Return the corners that two paths from the same start share, and the branching point."""
    shared = [p[0]]
    for (a, b), (_, c) in zip(pairwise(p), pairwise(q), strict=False):
        if b != c:
            product = (b[0] - a[0]) * (c[0] - a[0]) + (b[1] - a[1]) * (c[1] - a[1])
            if product > 0:  # the same direction
                shared.append(min(b, c, key=lambda end: math.dist(a, end)))
            return shared
        shared.append(b)
    return shared
