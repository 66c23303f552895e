"""Nets of a diagram, and the layers of its blocks, by Sugiyama's method.

1. Arrows that would close a loop are feedback and left out at first.
2. The layer of a block is the length of its longest path.
3. A net that skips layers has a passage in each.
4. Sweeps over the barycentres order every layer so that few nets cross.
5. Feedback has passages above or below all blocks of the layers, the longest outermost.
"""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from itertools import chain
from statistics import mean

from ...engine.diagram.wiring import Part, Wiring, units_of
from ...engine.model.ports import port_of

SWEEPS = 5  # over the layers; the last one from the left


@dataclass
class Net:
    """Signals of one block, or an input of the diagram, that feed the same blocks."""

    source: str  # block name, or ``"in:port"`` for an input of the diagram
    text: str  # the ports carried, such as ``"K, Gamma"``
    # block that is fed -> the text at its arrow, gains included
    targets: dict[str, str]
    back: set[str] = field(default_factory=set)  # targets reached by feedback

    @property
    def onward(self) -> list[str]:
        """Return the targets that are not reached by feedback."""
        return [target for target in self.targets if target not in self.back]


@dataclass
class Turn:
    """A net in the channel behind a layer: from a box or a passage to others, on one vertical."""

    net: int
    back: bool  # feedback
    start: str
    ends: list[str]
    lefts: list[float] = field(default_factory=list)  # heights at its left side
    rights: list[float] = field(default_factory=list)
    x: float = 0.0

    @property
    def low(self) -> float:
        """Return the least height."""
        return min(self.lefts + self.rights)

    @property
    def high(self) -> float:
        """Return the largest height."""
        return max(self.lefts + self.rights)


@dataclass
class Layered:
    """Blocks, inputs and passages in ordered layers."""

    nets: list[Net]
    rank: dict[str, int]  # block, input or passage -> number of its layer
    # left to right, top to bottom; a passage is "pass:NET:LAYER"
    layers: list[list[str]]
    # layer, or -1 before all -> turns of nets behind it
    channels: dict[int, list[Turn]]

    def lead(
        self, k: int, targets: Iterable[str], channels: Sequence[int], step: int
    ) -> Iterator[str]:
        """Lead a net through channels to targets; yield its passages, in layer c + `step` each.

        `step` is 1 onward and 0 for feedback.
        """
        start = self.nets[k].source
        for c in channels:
            turn = Turn(
                k, not step, start, [t for t in targets if self.rank[t] == c + 1]
            )
            self.channels[c].append(turn)
            if c != channels[-1]:
                start = f"pass:{k}:{c + step}"
                self.rank[start] = c + step
                turn.ends.append(start)
                yield start


def ports(labels: Iterable[str]) -> list[str]:
    """Return the ports of signal labels, each once, in order."""
    return list(dict.fromkeys(map(port_of, labels)))


def gather(diagram: Part, wiring: Wiring) -> list[Net]:
    """Return nets: ports of one block that feed the same blocks, or nothing.

    If a net has only some signals of a port, its text has their names.
    """
    outputs = [
        (node.name, label)
        for node in wiring.nodes
        for label in node.system.output_labels
    ]
    inputs = [(f"in:{port_of(label)}", label) for label in diagram.input_labels]
    units: dict[tuple[str, str], str] = {}
    port_labels: dict[tuple[str, str], list[str]] = {}
    for (source, label), unit in zip(
        outputs + inputs, chain(*units_of(wiring)), strict=True
    ):
        units.setdefault((source, port_of(label)), f" ({unit})" if unit else "")
        port_labels.setdefault((source, port_of(label)), []).append(label)

    fed: dict[
        tuple[str, str, str], dict[str, str]
    ] = {}  # source, port, name -> target -> gains
    for node in wiring.nodes:
        used: dict[tuple[str, str, float], list[str]] = {}
        for external, signals in ((False, outputs), (True, inputs)):
            for _, k, gain in node.fed(external):
                source, label = signals[k]
                used.setdefault((source, port_of(label), gain), []).append(label)
        for (source, port, gain), labels in used.items():
            is_complete = set(labels) == set(port_labels[source, port])
            for name in [port] if is_complete else dict.fromkeys(labels):
                targets = fed.setdefault((source, port, name), {})
                before = f"{targets[node.name]}, " if node.name in targets else ""
                targets[node.name] = before + ("" if gain == 1 else f"{gain:g} ")

    used_ports = {(source, port) for source, port, _ in fed}
    for source, port in port_labels:
        if (source, port) not in used_ports and not source.startswith("in:"):
            fed[source, port, port] = {}
    nets: dict[tuple[str, tuple[tuple[str, str], ...]], list[str]] = {}
    for (source, port, name), targets in fed.items():
        key = source, tuple(targets.items())
        nets.setdefault(key, []).append(name + units[source, port])
    return [
        Net(
            source,
            ", ".join(names),
            {t: ", ".join(gain + n for n in names) for t, gain in ends},
        )
        for (source, ends), names in nets.items()
    ]


def arrange(nets: list[Net], wiring: Wiring) -> Layered:
    """Return blocks in ordered layers, sources at the left; feedback is marked in the nets."""
    names = [net.source for net in nets if net.source.startswith("in:")]
    names = list(dict.fromkeys(names)) + [node.name for node in wiring.nodes]
    _mark_feedback(
        nets, {node.name for node in wiring.nodes if node.system.nstates}, names
    )
    rank = _ranks(nets, names)
    layers = [
        [name for name in names if rank[name] == k]
        for k in range(max(rank.values()) + 1)
    ]
    layered = Layered(nets, rank, layers, {c: [] for c in range(-1, len(layers))})

    # passages of nets onward, and the order of each layer
    for k, net in enumerate(nets):
        begin = rank[net.source]
        end = max((rank[target] for target in net.onward), default=begin)
        for passage in layered.lead(k, net.onward, range(begin, end), 1):
            layers[rank[passage]].append(passage)
    links = {
        c: [(turn.start, end) for turn in turns for end in turn.ends]
        for c, turns in layered.channels.items()
    }
    _order_layers(layers, links)

    # passages of feedback, the shortest first
    lengths = {
        k: rank[net.source] - min(map(rank.__getitem__, net.back))
        for k, net in enumerate(nets)
        if net.back
    }
    heights = {
        name: (k + 0.5) / len(layer) for layer in layers for k, name in enumerate(layer)
    }
    for k in sorted(lengths, key=lengths.__getitem__):
        net, begin = nets[k], rank[nets[k].source]
        is_above = mean([heights[name] for name in (net.source, *net.back)]) < 0.5
        channels = range(begin, begin - lengths[k] - 2, -1)
        for passage in layered.lead(k, net.back, channels, 0):
            layer = layers[rank[passage]]
            layer.insert(0 if is_above else len(layer), passage)
    return layered


def _mark_feedback(nets: list[Net], with_states: set[str], names: list[str]) -> None:
    """Mark arrows that close a loop, arrows from blocks with states last."""
    reached = {name: {name} for name in names}  # from each
    walk = _depth_first(nets, names)
    for net in sorted(
        nets, key=lambda net: (net.source in with_states, walk.index(net.source))
    ):
        for target in net.targets:
            if net.source in reached[target]:
                net.back.add(target)
                continue
            for reachable in reached.values():
                if net.source in reachable:
                    reachable |= reached[target]


def _depth_first(nets: list[Net], names: list[str]) -> list[str]:
    """Return the names in the order of a walk that begins at the sources."""
    fed = {target for net in nets for target in net.targets}
    walk: dict[str, None] = {}
    waiting = sorted(names, key=lambda name: name in fed)[::-1]
    while waiting:
        name = waiting.pop()
        if name not in walk:
            walk[name] = None
            ends = dict.fromkeys(
                t for net in nets if net.source == name for t in net.targets
            )
            waiting += list(ends)[::-1]
    return list(walk)


def _ranks(nets: list[Net], names: list[str]) -> dict[str, int]:
    """Return longest paths."""
    rank = dict.fromkeys(names, 0)
    for _ in names:
        for net in nets:
            for target in net.onward:
                rank[target] = max(rank[target], rank[net.source] + 1)
    return rank


def _order_layers(
    layers: list[list[str]], links: dict[int, list[tuple[str, str]]]
) -> None:
    """Sweep over the layers in both directions: each name near the mean of its neighbours."""
    for sweep in range(SWEEPS):
        down = sweep % 2 == 0
        steps = range(1, len(layers)) if down else range(len(layers) - 2, -1, -1)
        for k in steps:
            position = {name: i for layer in layers for i, name in enumerate(layer)}
            neighbours: dict[str, list[int]] = {name: [] for name in layers[k]}
            for start, end in links[k - 1 if down else k]:
                name, neighbour = (end, start) if down else (start, end)
                neighbours[name].append(position[neighbour])
            means = {
                name: mean(indices or [position[name]])
                for name, indices in neighbours.items()
            }
            layers[k].sort(key=means.__getitem__)
