"""Which lane and which track each net turns in.

Between two columns of boxes lies a channel with one vertical track for each
net that turns there; feedback runs in lanes above and below all boxes.
"""

from dataclasses import dataclass

from .heights import Box
from .layers import Layered

LANE, APART = 10.0, 7.0  # points between lanes, and between turns of one track


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


def lanes_of(layered: Layered, boxes: dict[str, Box], above: dict[int, bool]) -> dict[int, float]:
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


def channels_of(
    layered: Layered, boxes: dict[str, Box], lanes: dict[int, float]
) -> dict[int, list[Turn]]:
    """Return what each net does in each channel; channel c lies behind layer c."""
    channels: dict[int, list[Turn]] = {c: [] for c in range(-1, len(layered.layers))}
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
