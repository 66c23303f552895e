"""What is joined to what, and where each block stands: its layer and its order there.

Sugiyama's method.  Arrows that would close a circle are feedback and set aside; the rest give each
block a layer by its longest path; a net that skips layers leaves a passage in each; sweeps over the
barycentres order every layer so that few nets cross.  Feedback then gets passages too, above or
below all that stands in the layers that it goes back over, the longest outermost.
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
    targets: dict[str, str]  # block that is fed -> the text at its arrow, gains included
    back: set[str] = field(default_factory=set)  # targets reached by feedback

    @property
    def onward(self) -> list[str]:
        """Return the targets that are not reached by feedback."""
        return [target for target in self.targets if target not in self.back]


@dataclass
class Turn:
    """A net in the channel behind a layer: from a box or a passage to others, on one vertical."""

    net: int
    back: bool  # whether it is feedback
    start: str
    ends: list[str]
    lefts: list[float] = field(default_factory=list)  # heights that it joins at its left side
    rights: list[float] = field(default_factory=list)
    x: float = 0.0

    @property
    def low(self) -> float:
        """Return the least height that it joins."""
        return min(self.lefts + self.rights)

    @property
    def high(self) -> float:
        """Return the largest height that it joins."""
        return max(self.lefts + self.rights)


@dataclass
class Layered:
    """Blocks, inputs and passages in ordered layers."""

    nets: list[Net]
    rank: dict[str, int]  # block, input or passage -> number of its layer
    layers: list[list[str]]  # left to right, top to bottom; a passage is "pass:NET:LAYER"
    channels: dict[int, list[Turn]]  # layer, or -1 before all -> what nets do behind it

    def lead(self, k: int, targets: Iterable[str], way: Sequence[int], to: int) -> Iterator[str]:
        """Lead a net through channels to targets; yield its passages, in layer c + `to` each.

        `to` is 1 onward and 0 of feedback.
        """
        start = self.nets[k].source
        for c in way:
            turn = Turn(k, not to, start, [t for t in targets if self.rank[t] == c + 1])
            self.channels[c].append(turn)
            if c != way[-1]:
                start = f"pass:{k}:{c + to}"
                self.rank[start] = c + to
                turn.ends.append(start)
                yield start


def ports(labels: Iterable[str]) -> list[str]:
    """Return the ports of signal labels, each once, in order."""
    return list(dict.fromkeys(map(port_of, labels)))


def gather(diagram: Part, wiring: Wiring) -> list[Net]:
    """Return nets: ports of one block that feed the same blocks, or nothing.

    Where only some signals of a port are taken, they are named.
    """
    made = [(n.name, label) for n in wiring.nodes for label in n.system.output_labels]
    given = [(f"in:{port_of(label)}", label) for label in diagram.input_labels]
    units, whole = dict[tuple[str, str], str](), dict[tuple[str, str], list[str]]()
    for (source, label), unit in zip(made + given, chain(*units_of(wiring)), strict=True):
        units.setdefault((source, port_of(label)), f" ({unit})" if unit else "")
        whole.setdefault((source, port_of(label)), []).append(label)
    fed: dict[tuple[str, str, str], dict[str, str]] = {}  # source, port, name -> target -> gains
    for node in wiring.nodes:
        taken: dict[tuple[str, str, float], list[str]] = {}
        for external, origins in ((False, made), (True, given)):
            for _, k, gain in node.fed(external):
                source, label = origins[k]
                taken.setdefault((source, port_of(label), gain), []).append(label)
        for (source, port, gain), labels in taken.items():
            names = [port] if set(labels) == set(whole[source, port]) else dict.fromkeys(labels)
            for name in names:
                targets = fed.setdefault((source, port, name), {})
                before = f"{targets[node.name]}, " if node.name in targets else ""
                targets[node.name] = before + ("" if gain == 1 else f"{gain:g} ")
    idle = [one for one in whole if not any(key[:2] == one for key in fed)]
    fed |= {(source, port, port): {} for source, port in idle if not source.startswith("in:")}
    together: dict[tuple[str, tuple[tuple[str, str], ...]], list[str]] = {}
    for (source, port, name), targets in fed.items():
        key = source, tuple(targets.items())
        together.setdefault(key, []).append(name + units[source, port])
    return [
        Net(source, ", ".join(names), {t: ", ".join(gain + n for n in names) for t, gain in ends})
        for (source, ends), names in together.items()
    ]


def arrange(nets: list[Net], wiring: Wiring) -> Layered:
    """Return blocks in ordered layers, sources at the left; feedback is marked in the nets."""
    names = [net.source for net in nets if net.source.startswith("in:")]
    names = list(dict.fromkeys(names)) + [node.name for node in wiring.nodes]
    _mark_feedback(nets, {node.name for node in wiring.nodes if node.system.nstates}, names)
    rank = _ranks(nets, names)
    layers = [[name for name in names if rank[name] == k] for k in range(max(rank.values()) + 1)]
    layered = Layered(nets, rank, layers, {c: [] for c in range(-1, len(layers))})
    for k, net in enumerate(nets):
        first = rank[net.source]
        last = max((rank[target] for target in net.onward), default=first)
        for passage in layered.lead(k, net.onward, range(first, last), 1):
            layers[rank[passage]].append(passage)
    joined = layered.channels.items()
    links = {c: [(turn.start, end) for turn in turns for end in turn.ends] for c, turns in joined}
    _order_layers(layers, links)
    lengths = {
        k: rank[net.source] - min(map(rank.__getitem__, net.back))
        for k, net in enumerate(nets)
        if net.back
    }
    share = {name: (k + 0.5) / len(one) for one in layered.layers for k, name in enumerate(one)}
    for k in sorted(lengths, key=lengths.__getitem__):
        net, last = nets[k], rank[nets[k].source]
        above = mean([share[name] for name in (net.source, *net.back)]) < 0.5
        way = range(last, last - lengths[k] - 2, -1)
        for passage in layered.lead(k, net.back, way, 0):
            own = layered.layers[rank[passage]]
            own.insert(0 if above else len(own), passage)
    return layered


def _mark_feedback(nets: list[Net], with_states: set[str], names: list[str]) -> None:
    """Mark arrows that close a circle, those out of states last."""
    reached = {name: {name} for name in names}  # from each
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
    """Return longest paths."""
    rank = dict.fromkeys(names, 0)
    for _ in names:
        for net in nets:
            for target in net.onward:
                rank[target] = max(rank[target], rank[net.source] + 1)
    return rank


def _order_layers(layers: list[list[str]], links: dict[int, list[tuple[str, str]]]) -> None:
    """Sweep over the layers to and fro: each name near the middle of what it is joined to."""
    for sweep in range(SWEEPS):
        down = sweep % 2 == 0
        steps = range(1, len(layers)) if down else range(len(layers) - 2, -1, -1)
        for layer in steps:
            place = {name: k for one in layers for k, name in enumerate(one)}
            near: dict[str, list[int]] = {name: [] for name in layers[layer]}
            for start, end in links[layer - 1 if down else layer]:
                name, other = (end, start) if down else (start, end)
                near[name].append(place[other])
            middle = {name: mean(at or [place[name]]) for name, at in near.items()}
            layers[layer].sort(key=middle.__getitem__)
