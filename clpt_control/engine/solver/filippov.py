"""How a run goes on where it crosses switches to and fro: on the switch, or out of it.

What turns at the same time need not be one switch.  Decisions belong to one where the slopes of
their distances are parallel; each switch is tried by itself, and where several were met in one
place to which rates lead in turn, all of them are tried at once: all that are near, where a run
winds into a corner.  Cells that meet, as of the longest of queues, are tried first (`sliding`).
Where a decision besides is met wherever the switches are, as x + y = 0 where x = 0 and y = 0, it
stays undecided: if its sides give other rates the motion is not known, and the run ends.
"""

from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

import numpy as np

from ...errors import Uncompiled
from ..trace.arrays import Unread
from . import solver_layout as numbering
from .batch import Batch
from .schedule import Schedule
from .sliding import FLAT, MOST_APART, STAYS, Held, cells_that_meet
from .termination import edge, state_within

MOST = 4  # switches at once that do other things together
MOST_IN_VAIN, GOING = 50, 1e-7  # parts one after the other that go on by less than a share of a run
NEAR = 1e3  # least distances that count, at which a decision is about to turn


class Turned(NamedTuple):
    """Decisions that turn on one switch, as they are on both of its sides."""

    places: list[int]
    before: np.ndarray
    behind: np.ndarray


class Sliding(NamedTuple):
    """A run on switches: a `NativeDiagram`, the switches, decisions on their sides, P."""

    runner: Any
    held: Held
    sides: np.ndarray  # (k + 1, d): one side of all, and the other side of each
    P: np.ndarray


Begin = Callable[[Any, np.ndarray, np.ndarray, np.ndarray, Schedule], Batch]


def go_on(diagram: Any, batch: Batch, begin: Begin) -> None:
    """Go on with a batch of one run of a `NativeDiagram` that ended on a switch.

    ``begin(diagram, P, state, times, pieces)`` runs a part.
    """
    times, part, now, in_vain, corners = batch.times, batch, None, 0, 0
    here = dict[int, Turned]()  # switches that were met in vain
    while True:
        last = part.rests.get(0, part)
        t, x = last.now, last.Z[: batch.callee.nstates].copy()
        if last.status[0] == numbering.CHATTERS and in_vain < MOST_IN_VAIN:
            met = len(here)
            if (now := _crossed(diagram, last, now, here)) is not None:
                batch.slides.append(t)
            elif len(here) == met or (corners := corners + 1) > MOST_IN_VAIN:
                break  # else it goes on to the next switch of a corner
        elif now is not None and last.status[0] == numbering.LEFT:
            now, (t, x) = None, _left(last)
        elif now is not None and last.status[0] == numbering.FINISHED and last.now < times[-1]:
            now, x = None, last.out[0, -1].copy()
        elif now is not None and last.status[0] == numbering.NOT_FINITE:
            now = None  # another decision has made both sides alike
        else:
            break
        for k in np.flatnonzero((times > last.now) & (times <= t)):
            share = (times[k] - last.now) / last.numbers[numbering.TAKEN, 0]
            batch.out[0, k] = state_within(last, share) if now is None else x
        in_vain += 1
        if t - part.times[0] > GOING * (times[-1] - times[0]):
            in_vain = 0
            here.clear()
        ahead, pieces = times[times > t], batch.pieces[0].after(t)
        if now is not None:
            pieces = _until_a_jump(pieces)
            ahead = np.union1d(ahead[ahead < pieces.edges[-2]], pieces.edges[-2:-1])
        P = batch.runs[1][0] if now is None else now.P
        part = begin(diagram if now is None else now.runner, P, x, np.append(t, ahead), pieces)
        _, wanted, own = np.intersect1d(times, ahead[: part.reached[0] - 1], return_indices=True)
        batch.out[0, wanted] = part.out[0, 1 + own]
        batch.counts += part.counts
    if part is not batch:
        batch.rests[0], batch.status[0] = last, last.status[0]
        batch.reached[0] = np.searchsorted(times, last.now, "right")


def _until_a_jump(pieces: Schedule) -> Schedule:
    """Return pieces of time up to the first at whose beginning rates jump.

    Where inputs bend the rates on a switch jump too: each piece begins anew.
    """
    jumps = np.flatnonzero(pieces.smooth[1:-1] == 0)
    k = int(jumps[0]) if len(jumps) else len(pieces.edges) - 2
    edges = np.append(pieces.edges[: k + 1], np.inf)
    return Schedule(edges, pieces.places, pieces.values[: k + 2], 0 * pieces.smooth[: k + 2])


def _left(batch: Batch) -> tuple[float, np.ndarray]:
    """Return when and where a w leaves 0 ... 1, or a guard is met, in the step not taken."""
    t, h = batch.now, float(batch.numbers[numbering.TAKEN, 0])

    def margin(share: float) -> float:
        x, own = state_within(batch, share)[None], (batch.pieces[0], batch.arrays[1])
        found = batch.callee.evaluate(numbering.MARGIN, [t + share * h], x, *own, 1)[0, 0]
        return -1.0 if np.isnan(found) else float(found)

    share = edge(batch, margin)
    return t + share * h, state_within(batch, share)


class Place(NamedTuple):
    """Where a run crosses a switch: its time and state, and what is decided there."""

    t: float
    x: np.ndarray
    near: np.ndarray  # decisions that are about to turn
    slopes: np.ndarray  # of the distances of all decisions, (n, d)
    rates: np.ndarray

    def within(self, some: Sequence[int], of: Sequence[int]) -> list[int]:
        """Return those that turn where others do, or hang on no state: their slopes say so."""
        slopes, others = self.slopes[:, some], self.slopes[:, of]
        besides = slopes - others @ np.linalg.lstsq(others, slopes, rcond=None)[0]
        flat = np.linalg.norm(besides, axis=0) <= FLAT * np.linalg.norm(slopes, axis=0)
        return [*np.compress(flat, some)]

    def besides(self, held: Held) -> list[int]:
        """Return other decisions that are about to turn wherever the switches are met."""
        moving = [k for k in self.near if self.slopes[:, k].any() and k not in held.places]
        return self.within(moving, held.switches)

    def both_sides(self, k: int) -> np.ndarray:
        """Return states on both sides of where a decision turns."""
        normal = self.slopes[:, k] / np.sum(self.slopes[:, k] ** 2)
        return self.x + 1e-8 * np.outer([1.0, -1.0], normal)


def _place(diagram: Any, batch: Batch) -> Place:
    """Return where a batch of one run ended."""
    x, d = batch.Z[: diagram.nstates], diagram.code.program.decided
    steps = 1e-6 * (1.0 + np.abs(x))
    points = np.vstack([x, x + np.diag(steps)])
    at = np.full(len(points), batch.now), points, batch.pieces[0], batch.arrays[1]
    looks = diagram.callee().evaluate(numbering.DECIDE, *at, 3 * d)
    distance, least = looks[:, d : 2 * d], looks[0, 2 * d :]
    near = np.flatnonzero(np.abs(distance[0]) < NEAR * least)
    rates = diagram.callee().evaluate(
        numbering.DERIVATIVE, *(at[0][:1], points[:1], *at[2:]), len(x)
    )
    return Place(batch.now, x, near, (distance[1:] - distance[0]) / steps[:, None], rates)


def _crossed(
    diagram: Any, batch: Batch, now: Sliding | None, here: dict[int, Turned]
) -> Sliding | None:
    """Return a run on the switch that a run has just crossed, which it does to and fro.

    Where several have turned one of them is slid on, or all that were met `here`: in a corner to
    which rates lead in turn.
    """
    d, first, place = diagram.code.program.decided, diagram.decided_at, _place(diagram, batch)
    _, P, _, _, D = batch.arrays
    last = 3 * numbering.GLANCES * batch.callee.decided  # the look behind the switch
    before, behind = P[first : first + d], D[last : last + d]
    sides, known, switches = (now.sides, *now.held[:2]) if now else (before[None], (), ())
    free = np.setdiff1d(np.arange(d), known)
    turned = before != behind
    close = [k for k in free if turned[k] or k in place.near]
    near = [k for k in close if turned[k] or abs(before[k]) == 1.0]
    steep, every = np.linalg.norm(place.slopes, axis=0), list[Turned]()
    rest = sorted(near, key=lambda k: (not turned[k], -steep[k]))
    while rest:
        own = [rest[0], *(k for k in place.within(near, rest[:1]) if k != rest[0])]
        other = np.where(turned[own], behind[own], -before[own])
        every.append(Turned(own, before[own], other))
        rest = [k for k in rest if k not in own]
    ways = [[one] for one in every if turned[one.places[0]]]
    met = {min(one.places): one for (one,) in ways}
    here |= met if met.keys() - here.keys() else {min(one.places): one for one in every}
    corner = [one for one in here.values() if {*one.places} <= {*close}]
    cells = cells_that_meet(diagram, batch, place, sorted({*close, *known}))
    if cells and (found := _on(diagram, batch, place, *cells)) is not None:
        return found
    for way in [corner, *ways] if len(corner) > 1 else ways:
        places = sorted([*known, *(k for one in way for k in one.places)])
        held = Held(tuple(places), (*switches, *(one.places[0] for one in way)))
        rows = np.vstack([sides, *[sides[:1]] * len(way)])
        for one in way:
            rows[:, one.places] = one.before
        for row, one in zip(rows[len(sides) :], way, strict=True):
            row[one.places] = one.behind
        kinds = [(held, rows)] if way is not corner and len(held.switches) <= MOST else []
        if 1 < len(held.switches) <= MOST_APART:  # in one order, so that fewer are compiled
            order = np.argsort(held.switches)
            alone = Held(held.places, tuple(held.switches[k] for k in order), "apart")
            kinds.insert(0, (alone, np.vstack([rows[:1], rows[1:][order]])))
        for kind in kinds:
            if (found := _on(diagram, batch, place, *kind)) is not None:
                return found
    return None


def _on(diagram: Any, batch: Batch, place: Place, held: Held, sides: np.ndarray) -> Sliding | None:
    """Return a run on switches from a place.

    None where rates lead away from them, or hang on a decision that no switch turns and that stays
    undecided there, whose other side gives another motion.
    """
    try:
        runner = diagram.in_form(held)
    except (Unread, Uncompiled):
        return None
    first, own, P = diagram.decided_at, len(diagram.layout.P), runner.parameters()
    P[:own], P[first - 1] = batch.runs[1][0][:own], batch.arrays[1][first - 1]

    def margin(sides: np.ndarray) -> float:
        every = sides[0] + held.turned() @ (sides[1:] - sides[0])
        P[first : first + every.size] = every.ravel()
        at = [place.t], place.x[None], batch.pieces[0], P
        return float(runner.callee().evaluate(numbering.MARGIN, *at, 1)[0, 0])

    if not margin(sides) > 0.0:
        return None
    states = [x for k in place.besides(held) for x in place.both_sides(k)]
    at = np.full(len(states), place.t), np.reshape(states, (-1, len(place.x))), batch.pieces[0]
    rates = runner.callee().evaluate(numbering.DERIVATIVE, *at, P, len(place.x))
    size = np.abs(place.rates).max()
    if np.any(np.abs(rates[::2] - rates[1::2]) > STAYS * size):
        return None
    return Sliding(runner, held, sides, P)
