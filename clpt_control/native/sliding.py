"""Sliding: how a run goes on where it crosses a switch to and fro without end.

On both sides of a switch g = 0 the rates lead back to it.  In the limit a run stays there, with
the mean of the rates of both sides that does so (Filippov):

    x' = f_0 + w (f_1 - f_0),    g' = 0,    w = g'_0/(g'_0 - g'_1),    0 < w < 1

f_0 and f_1 are the rates with the switch as it is on either side, g'_0 and g'_1 the derivative of g
along them.  Where a run that slides meets another switch, f_0 and f_1 there are rates that slide on
the one before.  A run slides until a w leaves 0 ... 1, or to the next time at which rates jump.

Source: Filippov, A. F. (1988), Differential Equations with Discontinuous Righthand Sides, Kluwer,
section 4; Piiroinen, P. T., Kuznetsov, Y. A. (2008), An event-driven method to simulate Filippov
systems with accurate computing of sliding motions, ACM Trans. Math. Softw. 34(3).
"""

from collections.abc import Callable
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

MOST = 4  # switches at once
MOST_IN_VAIN, GOING = 50, 1e-9  # parts one after the other that go on by less than a share of a run


class Held(NamedTuple):
    """Numbers of decisions that stay as they are: all of them, and one for each switch."""

    places: tuple[int, ...]
    switches: tuple[int, ...]


def slide(record: Any, held: Held) -> None:
    """Make the rates of a `DiagramRecord` those on switches; each w and 1 - w is a margin."""
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

    def mean(g: int, rates: list[Port], others: list[Port]) -> list[Port]:
        """Return the mean of the rates of two sides that stays on the switch."""
        first = slope(g, rates)
        apart = first - slope(g, others)
        if type(apart) is float and apart == 0.0:
            raise Unread("a switch that its rates do not move")
        w, means = first / apart, list[Port]()
        record.margins += [operand(w), operand(1.0 - w)]
        for port, other in zip(rates, others, strict=True):
            a, b = (spread(record.tape, value(one.ref), port.shape) for one in (port, other))
            ref = port.ref if port.ref == other.ref else operand(a + w * (b - a))
            means.append(port._replace(ref=ref))
        return means

    sides = [decisions.lock(record.rates, held.places) for _ in range(2 ** len(held.switches))]
    for place in held.switches:
        g = decisions.distance_of(place)
        sides = [mean(g, *both) for both in zip(sides[::2], sides[1::2], strict=True)]
    (record.rates,) = sides


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
    times, part, now, in_vain = batch.times, batch, None, 0
    while True:
        last = part.rests.get(0, part)
        t, x = last.now, last.Z[: batch.callee.nstates].copy()
        if last.status[0] == numbering.CHATTERS and in_vain < MOST_IN_VAIN:
            if (now := _crossed(diagram, last, now)) is None:
                break
            batch.slides.append(t)
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
        in_vain = in_vain + 1 if t - part.times[0] < GOING * (times[-1] - times[0]) else 0
        ahead, pieces = times[times > t], batch.pieces[0].after(t)
        if now is not None:
            pieces = _until_a_jump(pieces)
            ahead = np.union1d(ahead[ahead < pieces.edges[-2]], pieces.edges[-2:-1])
        P = batch.runs[1][0] if now is None else now.P
        part = begin(diagram if now is None else now.runner, P, x, np.append(t, ahead), pieces)
        _, wanted, own = np.intersect1d(times, ahead[: part.reached[0] - 1], return_indices=True)
        batch.out[0, wanted] = part.out[0, 1 + own]
        batch.counts += part.counts
    if batch.slides:
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


def _crossed(diagram: Any, batch: Batch, now: Sliding | None) -> Sliding | None:
    """Return a run on the switch that a run has just crossed, which it does to and fro."""
    d, place, pieces = diagram.code.program.decided, diagram.decided_at, batch.pieces[0]
    _, P, _, _, D = batch.arrays
    last = 3 * numbering.GLANCES * batch.callee.decided  # the look behind the switch
    before, behind = P[place : place + d], D[last : last + d]
    sides, known, switches = (now.sides.copy(), *now.held) if now else (before[None].copy(), (), ())
    free = np.setdiff1d(np.arange(d), known)
    turned = free[before[free] != behind[free]]
    if not len(turned) or len(switches) == MOST:
        return None
    sides[:, free] = before[free]
    sides = np.vstack([sides, sides[0]])
    sides[-1, turned] = behind[turned]
    held = Held(tuple(sorted([*known, *turned.tolist()])), (*switches, int(turned[0])))
    try:
        runner = diagram.in_form(held)
    except (Unread, Uncompiled):
        return None
    chosen = np.arange(2 ** len(held.switches))[:, None] >> np.arange(len(held.switches)) & 1
    every = sides[0] + chosen @ (sides[1:] - sides[0])
    own, new = len(diagram.layout.P), runner.parameters()
    new[:own], new[place - 1 : place] = batch.runs[1][0][:own], P[place - 1]
    new[place : place + every.size] = every.ravel()
    at = [batch.now], batch.Z[None, : diagram.nstates], pieces, new
    inside = runner.callee().evaluate(numbering.MARGIN, *at, 1)[0, 0] > 0.0
    return Sliding(runner, held, sides, new) if inside else None
