"""How arrows run around the boxes, in points, y downwards.

Boxes of a layer share a column.  Between columns lies a channel: at its sides
the texts of the ports, in its middle one vertical track for each net that
turns there.  Feedback runs in lanes above and below all boxes.  So no arrow
runs through a box or a text.
"""

from collections.abc import Callable
from dataclasses import dataclass

from .layers import Layered
from .places import GRID, Box, place
from .strokes import Point, branchings
from .tracks import Turn, channels_of, lanes_of, overlap, sort_tracks

TRACK, ARROW = 7.0, 9.0


@dataclass
class Routed:
    """A finished layout."""

    boxes: dict[str, Box]  # with passages among them
    paths: dict[tuple[int, str], list[Point]]  # net and target, or "" -> corners of the arrow
    dots: list[Point]  # where a net branches
    width: float  # size of the picture
    height: float  # size of the picture


def route(
    layered: Layered, sizes: dict[str, tuple[float, float]], text_width: Callable[[str], float]
) -> Routed:
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


def _columns(
    layered: Layered,
    boxes: dict[str, Box],
    channels: dict[int, list[Turn]],
    text_width: Callable[[str], float],
) -> None:
    """Return boxes their x and nets their tracks, from left to right."""
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
            beside = [t.x + TRACK for t in turning[:k] if overlap(t, turn)]
            turn.x = max(beside, default=x)
        x = max((turn.x + TRACK for turn in turning), default=x)
        x += max(into, default=0.0) + (ARROW if into else 0.0)


def _paths(
    layered: Layered,
    boxes: dict[str, Box],
    channels: dict[int, list[Turn]],
    text_width: Callable[[str], float],
) -> dict[tuple[int, str], list[Point]]:
    paths: dict[tuple[int, str], list[Point]] = {}
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
            for c in range(rank, layered.rank[target]):
                if target in net.back:
                    break
                turn = next(t for t in channels[c] if t.net == k and t.lane is None)
                last = c + 1 == layered.rank[target]
                y = end[1] if last else boxes[f"pass:{k}:{c + 1}"].y
                if y != path[-1][1]:
                    path += [(turn.x, path[-1][1]), (turn.x, y)]
            paths[k, target] = [*path, end]
    return paths


def _extent(
    boxes: dict[str, Box], paths: dict[tuple[int, str], list[Point]]
) -> tuple[float, float, float, float]:
    drawn = [box for name, box in boxes.items() if not name.startswith("pass:")]
    corners = [point for path in paths.values() for point in path]
    corners += [(box.x, box.y - box.height / 2) for box in drawn]
    corners += [(box.x + box.width, box.y + box.height / 2) for box in drawn]
    xs, ys = zip(*corners, strict=True)
    return min(xs), min(ys), max(xs), max(ys)
