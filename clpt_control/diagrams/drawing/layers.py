"""Where a block stands: its column, its order there, and how high; Sugiyama's method.

Arrows that would close a circle are feedback and set aside; the rest give each
block a layer by its longest path; a net that skips layers leaves a passage in
each; sweeps over the barycentres order every layer so that few nets cross.

Then arrows climb and fall as little as that order allows, a linear program: those of passages count
more, as a long line that is straight is read at a glance.  All heights lie on one grid, so that
arrows are either straight or visibly bent.
"""

import math
from dataclasses import dataclass, field
from itertools import pairwise
from statistics import mean
from typing import NamedTuple

from ...equations.ports import port_of
from ..wiring import Node, Part, Wiring, units_of

GRID, PITCH, GAP = 7.0, 14.0, 14.0  # points; of heights, of ports, between boxes
WEIGHTS = 1.0, 2.0, 8.0  # of an arrow with so many passages at its ends
NEAR = 0.01  # of the distance from the middle


# --- an arrow joins the block, or the outside, that makes a port to a block that takes it.  Where
# only some signals of a port are taken, they are named ------------------------------------------


class Arrow(NamedTuple):
    """What one block takes of one port."""

    source: str  # name of the block that makes the port; of the port if external
    target: str  # name of the block that takes it
    port: str  # the port, such as ``"phi_x"``, or some of its signals, ``"y[1]"``
    gain: float  # factor on each signal
    external: bool  # true where the port is an input of the diagram

    @property
    def factor(self) -> str:
        """Return the gain as it stands before the port, nothing where it is 1."""
        return "" if self.gain == 1 else f"{self.gain:g} "


def ports(labels: list[str]) -> list[str]:
    """Return the ports of signal labels, each once, in order."""
    return list(dict.fromkeys(map(port_of, labels)))


def arrows(diagram: Part, wiring: Wiring) -> list[Arrow]:
    """Return one arrow for each source, target, port and gain, nested diagrams included."""
    made = [(n.name, label) for n in wiring.nodes for label in n.system.output_labels]
    given = [(port_of(label), label) for label in diagram.input_labels]
    return [arrow for node in wiring.nodes for arrow in _into(node, made, given)]


def _into(node: Node, made: list[tuple[str, str]], given: list[tuple[str, str]]) -> list[Arrow]:
    """Return the arrows into a node; where a port is not taken whole, its signals are named."""
    taken: dict[tuple[bool, str, str, float], list[str]] = {}
    for wire in sorted(node.wires):
        origins = given if wire.external else made
        for source, label in origins[wire.source : wire.source + wire.size]:
            key = (wire.external, source, port_of(label), wire.gain)
            taken.setdefault(key, []).append(label)
    result = []
    for (external, source, port, gain), signals in taken.items():
        origins = given if external else made
        whole = {label for owner, label in origins if owner == source and port_of(label) == port}
        names = [port] if whole == set(signals) else dict.fromkeys(signals)
        result += [Arrow(source, node.name, name, gain, external) for name in names]
    return result


# --- nets, and the layers of blocks -------------------------------------------------------------


@dataclass
class Net:
    """Signals of one block that feed the same blocks."""

    source: str  # block name, or ``"in:port"`` for an input of the diagram
    text: str  # the ports carried, such as ``"K, Gamma"``
    targets: dict[str, str]  # block that is fed -> the text at its arrow, gains included
    back: set[str] = field(default_factory=set)  # targets reached by feedback

    @property
    def onward(self) -> list[str]:
        """Return the targets that are not reached by feedback."""
        return [target for target in self.targets if target not in self.back]

    @property
    def named_at_source(self) -> bool:
        """Return whether the text stands at the source too, not only at the arrow's end."""
        return not self.source.startswith("in:") and (len(self.targets) != 1 or bool(self.back))


class Hop(NamedTuple):
    """A net on its way behind one layer: from a box or a passage to some in the next layer."""

    start: str
    ends: list[str]


@dataclass
class Layered:
    """Blocks, inputs and passages in ordered layers."""

    nets: list[Net]  # what is connected
    rank: dict[str, int]  # block or input -> number of its layer
    layers: list[list[str]]  # left to right, top to bottom; a passage is "pass:NET:LAYER"
    hops: dict[tuple[int, int], Hop]  # layer and number of the net -> its way behind that layer

    def links(self, layer: int) -> list[tuple[str, str]]:
        """Return which boxes are joined behind a layer."""
        hops = [hop for (at, _), hop in self.hops.items() if at == layer]
        return [(hop.start, end) for hop in hops for end in hop.ends]


def gather(diagram: Part, wiring: Wiring) -> list[Net]:
    """Return nets: ports of one block that feed the same blocks, or nothing."""
    reached: dict[tuple[str, str], dict[str, str]] = {
        (node.name, port): {} for node in wiring.nodes for port in ports(node.system.output_labels)
    }
    for arrow in arrows(diagram, wiring):
        source = f"in:{arrow.source}" if arrow.external else arrow.source
        targets = reached.setdefault((source, arrow.port), {})
        before = f"{targets[arrow.target]}, " if arrow.target in targets else ""
        targets[arrow.target] = before + arrow.factor
    made, given = (iter(one) for one in units_of(wiring))
    units = {
        (n.name, p): next(made) for n in wiring.nodes for p in map(port_of, n.system.output_labels)
    }
    units |= {(f"in:{p}", p): next(given) for p in map(port_of, diagram.input_labels)}
    partly = {(source, port_of(port)) for source, port in reached if "[" in port}
    together: dict[tuple[str, tuple[tuple[str, str], ...]], list[str]] = {}
    for (source, port), targets in reached.items():
        if targets or (source, port) not in partly:
            unit = units.get((source, port_of(port)))
            name = f"{port} ({unit})" if unit else port
            together.setdefault((source, tuple(targets.items())), []).append(name)
    return [
        Net(source, ", ".join(names), {t: ", ".join(gain + n for n in names) for t, gain in ends})
        for (source, ends), names in together.items()
    ]


def arrange(nets: list[Net], wiring: Wiring) -> Layered:
    """Return blocks in ordered layers, sources at the left; feedback is marked in the nets."""
    names = [net.source for net in nets if net.source.startswith("in:")]
    names = list(dict.fromkeys(names)) + [node.name for node in wiring.nodes]
    _mark_feedback(nets, wiring, names)
    rank = _ranks(nets, names)
    layers: list[list[str]] = [[] for _ in range(max(rank.values()) + 1)]
    for name in names:
        layers[rank[name]].append(name)
    hops = {}
    for layer in range(len(layers)):
        for k, net in enumerate(nets):
            start, last = rank[net.source], max((rank[t] for t in net.onward), default=-1)
            if start <= layer < last:
                ends = [t for t in net.onward if rank[t] == layer + 1]
                passes = [f"pass:{k}:{layer + 1}"] if last > layer + 1 else []
                layers[layer + 1] += passes
                here = net.source if start == layer else f"pass:{k}:{layer}"
                hops[layer, k] = Hop(here, ends + passes)
    layered = Layered(nets, rank, layers, hops)
    _order_layers(layered)
    return layered


def _mark_feedback(nets: list[Net], wiring: Wiring, names: list[str]) -> None:
    """Mark arrows that close a circle, those out of states last."""
    reached = {name: {name} for name in names}  # from each
    with_states = {node.name for node in wiring.nodes if node.system.nstates}
    met = _depth_first(nets, names)
    for net in sorted(nets, key=lambda net: (net.source in with_states, met.index(net.source))):
        for target in net.targets:
            if net.source in reached[target]:
                net.back.add(target)
                continue
            for found in reached.values():
                if net.source in found:
                    found |= reached[target]


def _depth_first(nets: list[Net], names: list[str]) -> list[str]:
    """Return the names in the order of a walk from where signals come in."""
    fed = {target for net in nets for target in net.targets}
    found: dict[str, None] = {}
    waiting = sorted(names, key=lambda name: name in fed)[::-1]
    while waiting:
        name = waiting.pop()
        if name not in found:
            found[name] = None
            ends = dict.fromkeys(t for net in nets if net.source == name for t in net.targets)
            waiting += list(ends)[::-1]
    return list(found)


def _ranks(nets: list[Net], names: list[str]) -> dict[str, int]:
    """Return longest paths; a name with more nets out than in moves to what it feeds."""
    rank = dict.fromkeys(names, 0)
    onward = [(net.source, target) for net in nets for target in net.onward]
    for _ in names:
        for name, target in onward:
            rank[target] = max(rank[target], rank[name] + 1)
    for name in sorted(names, key=lambda name: -rank[name]):
        right = min((rank[target] for source, target in onward if source == name), default=0) - 1
        comes = sum(name in net.onward for net in nets)
        goes = sum(bool(net.onward) for net in nets if net.source == name)
        if right > rank[name] and goes > comes and not name.startswith("in:"):
            rank[name] = right
    return rank


def _order_layers(layered: Layered) -> None:
    """Sweep over the layers to and fro, and keep the order with the fewest crossings."""
    layers, best = layered.layers, [list(names) for names in layered.layers]
    fewest = _crossings(layered)
    for sweep in range(24):
        down = sweep % 2 == 0
        steps = range(1, len(layers)) if down else range(len(layers) - 2, -1, -1)
        for layer in steps:
            near: dict[str, list[int]] = {name: [] for name in layers[layer]}
            place = {name: k for one in layers for k, name in enumerate(one)}
            for start, end in layered.links(layer - 1 if down else layer):
                name, other = (end, start) if down else (start, end)
                near[name].append(place[other])
            middle = {name: mean(at or [place[name]]) for name, at in near.items()}
            layers[layer].sort(key=middle.__getitem__)
        if (crossings := _crossings(layered)) < fewest:
            fewest, best = crossings, [list(names) for names in layers]
    layered.layers = best


def _crossings(layered: Layered) -> int:
    place = {name: k for one in layered.layers for k, name in enumerate(one)}
    total = 0
    for layer in range(len(layered.layers) - 1):
        pairs = [(place[a], place[b]) for a, b in layered.links(layer)]
        total += sum(a < c and b > d for a, b in pairs for c, d in pairs)
    return total


# --- how high ------------------------------------------------------------------------------------


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


Sizes = dict[str, tuple[float, float]]  # of boxes by name, points
Boxes = dict[str, Box]


def place(layered: Layered, sizes: Sizes) -> tuple[Boxes, dict[int, bool]]:
    """Return boxes at their heights, ports in order, and which feedback returns above them."""
    boxes = _boxes(layered, sizes)
    above: dict[int, bool] = {}
    for _ in range(3):
        _level(layered, boxes)
        above = _returns_above(layered, boxes)
        _sort_ports(layered, boxes, above)
    _level(layered, boxes)
    return boxes, above


def _boxes(layered: Layered, sizes: Sizes) -> Boxes:
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


def _level(layered: Layered, boxes: Boxes) -> None:
    """Move the boxes to heights at which arrows climb and fall least, and else near the middle."""
    from scipy.optimize import linprog
    from scipy.sparse import coo_array

    number = {name: k for k, name in enumerate(boxes)}
    middle = len(number)  # a height of its own
    climbs = [(k, middle, 0.0, NEAR) for k in number.values()]  # from, to, at which ports, weight
    for (_, k), (start, ends) in layered.hops.items():
        out = boxes[start].port(k, True) - boxes[start].y
        for end in ends:
            at = boxes[end].port(k, False) - boxes[end].y - out
            weight = WEIGHTS[start.startswith("pass:") + end.startswith("pass:")]
            climbs.append((number[start], number[end], at / GRID, weight))
    rows: list[tuple[dict[int, int], float]] = []  # coefficients, and what they are at most
    for names in layered.layers:
        for upper, lower in pairwise(names):
            room = (boxes[upper].height + boxes[lower].height) / 2 + GAP
            rows.append(({number[upper]: 1, number[lower]: -1}, -math.ceil(room / GRID)))
    for own, (a, b, at, _) in enumerate(climbs, middle + 1):
        rows += [({b: 1, a: -1, own: -1}, -at), ({b: -1, a: 1, own: -1}, at)]
    left = [(row, k, one) for row, (own, _) in enumerate(rows) for k, one in own.items()]
    where, which, values = zip(*left, strict=True)
    matrix = coo_array((values, (where, which))).tocsr()
    costs = [0.0] * (middle + 1) + [weight for *_, weight in climbs]
    heights = linprog(costs, matrix, [most for _, most in rows]).x
    for box, y in zip(boxes.values(), heights, strict=False):
        box.y = GRID * round(y)


def _returns_above(layered: Layered, boxes: Boxes) -> dict[int, bool]:
    """Return for each net with feedback whether its lane is above the boxes."""
    middle = mean([box.y for name, box in boxes.items() if not name.startswith("pass:")])
    return {
        k: mean([boxes[name].y for name in (net.source, *net.back)]) < middle
        for k, net in enumerate(layered.nets)
        if net.back
    }


def _sort_ports(layered: Layered, boxes: Boxes, above: dict[int, bool]) -> None:
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
