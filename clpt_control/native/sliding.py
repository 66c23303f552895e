"""Sliding: how a run goes on where it crosses a switch to and fro without end.

On both sides of a switch g = 0 the rates lead back to it.  In the limit a run stays there, with
the mean of the rates of both sides that does so (Filippov):

    x' = f_0 + w (f_1 - f_0),    g' = 0,    w = g'_0/(g'_0 - g'_1),    0 < w < 1

f_0 and f_1 are the rates with the switch as it is on either side, g'_0 and g'_1 the derivative of g
along them.  On several switches, each of which adds to the rates what it adds alone, no g changes:

    x' = f_0 + sum_i w_i (f_i - f_0),    g_j' = 0 for every j,    all pivots of the solution > 0

as for six joints with dry friction; a pivot below 0 would be a switch from which rates lead away.
Where switches do other things together, f_0 and f_1 of the last one are rates that slide on those
before it.  A run slides until a w leaves 0 ... 1, or to the next time at which rates jump.

What turns at the same time need not be one switch: what is decided and is no switch of its own must
stay where it is along x', else each is tried by itself.  Where more switches meet than the state
has dimensions, several motions may be right, and one of them is shown.

Source: Filippov, A. F. (1988), Differential Equations with Discontinuous Righthand Sides, Kluwer,
section 4; Piiroinen, P. T., Kuznetsov, Y. A. (2008), An event-driven method to simulate Filippov
systems with accurate computing of sliding motions, ACM Trans. Math. Softw. 34(3).
"""

from collections.abc import Callable, Sequence
from itertools import groupby
from math import prod
from typing import Any, NamedTuple

import numpy as np

from ..equations.arrays import Unread, operand
from ..equations.derivative import Direction
from ..equations.elementwise import spread
from ..equations.record import reached
from ..errors import Uncompiled
from . import numbering
from .batch import Batch
from .decisions import Port
from .ending import edge, state_within
from .schedule import Schedule

MOST, MOST_APART = 4, 16  # switches at once; those that each do what they do alone
STAYS, TINY = 1e-6, 1e-30  # the share of rates that counts as nothing
MOST_IN_VAIN, GOING = 50, 1e-7  # parts one after the other that go on by less than a share of a run
HERE = 1e-9  # the share of a run in which switches are met in one place


class Held(NamedTuple):
    """Numbers of decisions that stay as they are: all of them, and one for each switch.

    Switches `apart` each add to the rates what they add alone.
    """

    places: tuple[int, ...]
    switches: tuple[int, ...]
    apart: bool = False

    def turned(self) -> np.ndarray:
        """Return whether each switch is turned on each of the sides: (sides, switches)."""
        k = len(self.switches)
        if self.apart:
            return np.vstack([np.zeros(k), np.eye(k), np.ones(k)]).astype(int)
        return np.arange(2**k)[:, None] >> np.arange(k) & 1


def slide(record: Any, held: Held) -> None:
    """Make the rates of a `DiagramRecord` those on switches.

    Each w and 1 - w is a margin, and so is that the other held decisions stay where they are.
    """
    value, decisions = record.tape.value, record.decisions

    def slope(distance: int, rates: list[Port]) -> Any:
        """Return g' along rates."""
        along: dict[int, Any] = {}
        for k in reached(record.entries, [distance]):
            kind, _, shape, at = record.entries[k]
            if kind == "load" and at[0] == "t":
                along[k] = 1.0
            for port in rates if kind == "load" and at[0] == "X" else ():
                if port.first <= at[1] and at[1] + prod(shape) <= port.first + prod(port.shape):
                    along[k] = value(record.part(port.ref, at[1] - port.first, shape))
        return Direction(record.tape, along).of(value(distance))

    def mean(weights: list[Any], rates: list[Port], others: list[list[Port]]) -> list[Port]:
        """Return rates + sum_i w_i (others_i - rates)."""
        record.margins += [operand(m) for w in weights for m in (w, 1.0 - w)]
        means = list[Port]()
        for port, *turned in zip(rates, *others, strict=True):
            a, *b = (spread(record.tape, value(one.ref), port.shape) for one in (port, *turned))
            changes = zip(weights, b, turned, strict=True)
            parts = [w * (c - a) for w, c, one in changes if one.ref != port.ref]
            means.append(port._replace(ref=operand(sum(parts, a))))
        return means

    def weights_of(distances: list[int], rates: list[Port], others: list[list[Port]]) -> list[Any]:
        """Return the weights with which no distance changes; pivots are margins, if of several."""
        rows = list[list[Any]]()
        for g in distances:
            along = slope(g, rates)
            rows.append([slope(g, other) - along for other in others] + [-along])
        for i, row in enumerate(rows):
            if type(pivot := row[i]) is float and pivot == 0.0:
                raise Unread("a switch that its rates do not move")
            if len(rows) > 1:
                record.margins.append(operand(pivot))
            rows[i] = [one / pivot for one in row]
            for j in (j for j in range(len(rows)) if j != i):
                rows[j] = [a - rows[j][i] * b for a, b in zip(rows[j], rows[i], strict=True)]
        return [row[-1] for row in rows]

    def size(one: Any, long: Sequence[bool] = ()) -> Any:
        """Return the sum of magnitudes."""
        ref = operand(np.fabs(one))
        for loops in long:
            count, *rest = record.shape_of(ref)
            ref = record.add("sum", (ref,), tuple(rest), (0, count, loops))
        return value(ref)

    def nothing(small: Any, beside: Any) -> None:
        """Make it a margin that a size is nothing beside another."""
        record.margins.append(operand(1.0 - small / (STAYS * beside + TINY)))

    sides = [decisions.lock(record.rates, held.places) for _ in held.turned()]
    first, distances = sides[0], [decisions.distance_of(place) for place in held.switches]
    if held.apart:
        *others, last = sides[1:]
        for port, *ports in zip(first, *others, last, strict=True):
            a, *b = (spread(record.tape, value(one.ref), port.shape) for one in (port, *ports))
            *changes, together = (one - a for one in b)
            sizes = [size(one, port.long) for one in changes]
            nothing(size(together - sum(changes), port.long), sum(sizes))
        sides = [mean(weights_of(distances, first, others), first, others)]
    for g in () if held.apart else distances:
        pairs = zip(sides[::2], sides[1::2], strict=True)
        sides = [mean(weights_of([g], one, [other]), one, [other]) for one, other in pairs]
    for place in set(held.places).difference(held.switches):
        g = decisions.distance_of(place)
        nothing(size(slope(g, sides[0])), size(slope(g, first)))
    (record.rates,) = sides


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
    here = dict[Any, Turned]()  # switches that were met in vain
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
        went_on = (t - part.times[0]) / (times[-1] - times[0])
        in_vain = in_vain + 1 if went_on < GOING else 0
        if went_on > HERE:
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
        return float(batch.callee.evaluate(numbering.MARGIN, [t + share * h], x, *own, 1)[0, 0])

    share = edge(batch, margin)
    return t + share * h, state_within(batch, share)


def _crossed(
    diagram: Any, batch: Batch, now: Sliding | None, here: dict[Any, Turned]
) -> Sliding | None:
    """Return a run on the switch that a run has just crossed, which it does to and fro.

    What has turned at once is one switch, or several of which one is slid on, or all that were met
    `here`: in a corner to which rates lead in turn.
    """
    d, place = diagram.code.program.decided, diagram.decided_at
    deciding = diagram.code.program.deciding
    _, P, _, _, D = batch.arrays
    last = 3 * numbering.GLANCES * batch.callee.decided  # the look behind the switch
    before, behind = P[place : place + d], D[last : last + d]
    sides, known, switches = (now.sides, *now.held[:2]) if now else (before[None], (), ())
    free = np.setdiff1d(np.arange(d), known)
    turned = free[before[free] != behind[free]].tolist()

    def about(k: int) -> tuple:
        first, _, compared = next(one for one in deciding[::-1] if one[0] <= k)
        return compared, k - first

    def both(places: list[int]) -> Turned:
        return Turned(places, before[places], behind[places])

    alike = {key: both([*own]) for key, own in groupby(sorted(turned, key=about), about)}
    here |= alike
    corner = [one for key, one in here.items() if not {*one.places}.intersection(known)]
    ways = [corner, [both(turned)], *([one] for one in alike.values())]
    for way in ways[len(corner) < 2 :] if turned else ():
        held = Held((*known, *(k for one in way for k in one.places)), switches)
        held = held._replace(switches=(*switches, *(one.places[0] for one in way)))
        rows = np.vstack([sides, *[sides[:1]] * len(way)])
        for one in way:
            rows[:, one.places] = one.before
        for row, one in zip(rows[len(sides) :], way, strict=True):
            row[one.places] = one.behind
        kinds = [held._replace(apart=True)] * (1 < len(held.switches) <= MOST_APART)
        for kind in [*kinds, held] if way is not corner and len(held.switches) <= MOST else kinds:
            if (found := _on(diagram, batch, kind, rows)) is not None:
                return found
    return None


def _on(diagram: Any, batch: Batch, held: Held, sides: np.ndarray) -> Sliding | None:
    """Return a run on switches from where a batch is; None where rates lead away from them."""
    try:
        runner = diagram.in_form(held)
    except (Unread, Uncompiled):
        return None
    place, P, pieces = diagram.decided_at, batch.arrays[1], batch.pieces[0]
    every = sides[0] + held.turned() @ (sides[1:] - sides[0])
    own, new = len(diagram.layout.P), runner.parameters()
    new[:own], new[place - 1 : place] = batch.runs[1][0][:own], P[place - 1]
    new[place : place + every.size] = every.ravel()
    at = [batch.now], batch.Z[None, : diagram.nstates], pieces, new
    inside = runner.callee().evaluate(numbering.MARGIN, *at, 1)[0, 0] > 0.0
    return Sliding(runner, held, sides, new) if inside else None
