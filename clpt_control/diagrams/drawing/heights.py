"""How high each box stands, and in which order its ports lie.

Every box moves towards the boxes that it is connected with, as far as the
order of its layer allows; all heights lie on one grid, so that arrows are
either straight or visibly bent.
"""

import math
from dataclasses import dataclass, field
from itertools import pairwise
from statistics import mean, median

import numpy as np

from .layers import Layered

GRID, PITCH, GAP = 7.0, 14.0, 14.0  # points; of heights, of ports, between boxes
Links = dict[str, list[tuple[str, int, bool]]]  # box -> (other box, net, whether it goes out)


@dataclass
class Box:
    """A block, an input of the diagram, or a passage for a net."""

    width: float  # a passage has no size
    height: float
    x: float = 0.0  # left edge
    y: float = 0.0  # centre
    ins: list[int] = field(default_factory=list)  # nets at its left side, from top to bottom
    outs: list[int] = field(default_factory=list)  # nets at its right side

    def port(self, net: int, out: bool) -> float:
        """Return the height at which a net meets the box."""
        side = self.outs if out else self.ins
        if net not in side:
            return self.y
        return self.y + (side.index(net) - (len(side) - 1) / 2) * PITCH


def place(
    layered: Layered, sizes: dict[str, tuple[float, float]]
) -> tuple[dict[str, Box], dict[int, bool]]:
    """Return boxes at their heights, ports in order, and which feedback returns above them."""
    boxes = _boxes(layered, sizes)
    links = _links(layered, boxes)
    above: dict[int, bool] = {}
    for _ in range(3):
        _settle_layers(layered, boxes, links)
        above = _returns_above(layered, boxes)
        _sort_ports(layered, boxes, above)
    _settle_layers(layered, boxes, links)
    for _ in range(3):
        _straighten(layered, boxes)
        _align(layered, boxes, links)
    return boxes, above


def _boxes(layered: Layered, sizes: dict[str, tuple[float, float]]) -> dict[str, Box]:
    """Return boxes with all their ports, of the size of their text or more."""
    boxes = {name: Box(*sizes.get(name, (0.0, 0.0))) for layer in layered.layers for name in layer}
    for k, net in enumerate(layered.nets):
        boxes[net.source].outs.append(k)
        for target in net.targets:
            boxes[target].ins.append(k)
    for name, box in boxes.items():
        if not name.startswith(("in:", "pass:")):
            rows = max(len(box.ins), len(box.outs))
            box.height = max(box.height, rows * PITCH)
    return boxes


def _links(layered: Layered, boxes: dict[str, Box]) -> Links:
    links: Links = {name: [] for name in boxes}
    for (_, k), (start, ends) in layered.hops.items():
        for end in ends:
            links[start].append((end, k, True))
            links[end].append((start, k, False))
    return links


def _settle_layers(layered: Layered, boxes: dict[str, Box], links: Links) -> None:
    """Move each box to the median of what it is linked with, as far as its layer allows."""
    for names in [*layered.layers, *layered.layers[::-1]] * 6:
        wanted = []
        for name in names:
            box = boxes[name]
            pulls = [boxes[to].port(k, not out) - box.port(k, out) for to, k, out in links[name]]
            wanted.append(box.y + (median(pulls) if pulls else 0.0))
        for name, y in zip(names, settle(wanted, _spacing(boxes, names)), strict=True):
            boxes[name].y = y


def _spacing(boxes: dict[str, Box], names: list[str]) -> list[float]:
    """Return the least distances between the centres of neighbours."""
    spaces = []
    for a, b in pairwise(names):
        room = (boxes[a].height + boxes[b].height) / 2 + GAP
        spaces.append(math.ceil(room / GRID) * GRID)
    return spaces


def settle(wanted: list[float], spaces: list[float]) -> list[float]:
    """Return heights on the grid near those wanted, in order and at least `spaces` apart."""
    from scipy.optimize import isotonic_regression

    offsets = np.cumsum([0.0, *spaces])
    levels = isotonic_regression(wanted - offsets).x
    heights: list[float] = (np.round(levels / GRID) * GRID + offsets).tolist()
    return heights


def _straighten(layered: Layered, boxes: dict[str, Box]) -> None:
    """Bring the passages of a net to one height where their neighbours leave room."""
    for k, net in enumerate(layered.nets):
        chain = [
            (layer, f"pass:{k}:{layer}")
            for layer in range(len(layered.layers))
            if f"pass:{k}:{layer}" in boxes
        ]
        before = boxes[net.source].port(k, True)
        while chain:
            low, high, size = -math.inf, math.inf, 0
            for layer, name in chain:
                least, most = _room(boxes, layered.layers[layer], name)
                if max(low, least) > min(high, most):
                    break
                low, high, size = max(low, least), min(high, most), size + 1
            ends = {t for layer, _ in chain[:size] for t in layered.hops[layer, k].ends}
            levels = [before, *(boxes[t].port(k, False) for t in ends if not t.startswith("pass:"))]
            tries = sorted(min(max(level, low), high) for level in levels)
            y = min(tries, key=lambda y: (-levels.count(y), sum(abs(y - z) for z in levels)))
            for _, name in chain[:size]:
                boxes[name].y = y
            before, chain = y, chain[size:]


def _room(boxes: dict[str, Box], names: list[str], name: str) -> tuple[float, float]:
    """Return the heights between the neighbours of a passage."""
    here = names.index(name)
    spaces = _spacing(boxes, names)
    low = boxes[names[here - 1]].y + spaces[here - 1] if here else -math.inf
    last = here == len(names) - 1
    return low, math.inf if last else boxes[names[here + 1]].y - spaces[here]


def _align(layered: Layered, boxes: dict[str, Box], links: Links) -> None:
    """Shift each box to where most of its arrows are straight."""
    for names in layered.layers:
        for name in names:
            low, high = _room(boxes, names, name)
            box = boxes[name]
            fits: list[float] = []
            for passages in (False, True):
                steps = [
                    boxes[to].port(k, not out) - box.port(k, out)
                    for to, k, out in links[name]
                    if to.startswith("pass:") == passages
                ]
                fits = fits or [step for step in steps if low <= box.y + step <= high]
            box.y += min(fits, key=lambda step: (-fits.count(step), abs(step)), default=0.0)


def _returns_above(layered: Layered, boxes: dict[str, Box]) -> dict[int, bool]:
    """Return for each net with feedback whether its lane is above the boxes."""
    middle = mean([box.y for name, box in boxes.items() if not name.startswith("pass:")])
    return {
        k: mean([boxes[name].y for name in (net.source, *net.back)]) < middle
        for k, net in enumerate(layered.nets)
        if net.back
    }


def _sort_ports(layered: Layered, boxes: dict[str, Box], above: dict[int, bool]) -> None:
    """Sort ports by where their nets come from and go; feedback to its lane's side."""
    came: dict[tuple[str, int], float] = {}
    went: dict[int, float] = {}
    for (_, k), (start, ends) in layered.hops.items():
        came |= {(end, k): boxes[start].port(k, True) for end in ends}
        if start == layered.nets[k].source:
            went[k] = mean([boxes[end].port(k, False) for end in ends])
    for name, box in boxes.items():
        far = {k: -math.inf if above.get(k) else math.inf for k in (*box.ins, *box.outs)}
        box.ins.sort(key=lambda k: (came.get((name, k), far[k]), k))
        box.outs.sort(key=lambda k: (went.get(k, far[k]), k))
