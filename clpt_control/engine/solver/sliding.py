"""Sliding: the rates of a run that stays on a switch, which it would cross to and fro without end.

On both sides of a switch g = 0 the rates lead back to it.  In the limit a run stays there, with
the mean of the rates of both sides that does so (Filippov):

    x' = f_0 + w (f_1 - f_0),    g' = 0,    w = g'_0/(g'_0 - g'_1),    0 < w < 1

f_0 and f_1 are the rates with the switch as it is on either side, g'_0 and g'_1 the derivative of g
along them.  On several switches, each of which adds to the rates what it adds alone, no g changes:

    x' = f_0 + sum_i w_i (f_i - f_0),    g_j' = 0 for every j,    all pivots of the solution > 0

as for six joints with dry friction; a pivot below 0 would be a switch from which rates lead away.
So it is where k + 1 cells meet in k switches, as of the longest of k + 1 queues, with f_i the rates
of a cell and sum_i w_i < 1.  Where switches do other things together, f_0 and f_1 of the last one
are rates that slide on those before it.  A run slides until a w leaves 0 ... 1, or to the next time
at which rates jump.

Source: Filippov, A. F. (1988), Differential Equations with Discontinuous Righthand Sides, Kluwer,
section 4; Piiroinen, P. T., Kuznetsov, Y. A. (2008), An event-driven method to simulate Filippov
systems with accurate computing of sliding motions, ACM Trans. Math. Softw. 34(3).
"""

from collections.abc import Sequence
from math import prod
from typing import Any, NamedTuple

import numpy as np
import scipy.linalg

from ..codegen.switching_conditions import Port
from ..record.derivative import Direction
from ..record.graph import reached
from ..trace.arrays import Unread, operand
from ..trace.elementwise import spread
from . import solver_layout as numbering

STAYS, TINY = 1e-6, 1e-30  # the share of rates that counts as nothing
FLAT = 1e-4  # the share of a slope, or of a difference of rates beside a switch
MOST_APART = 16  # switches at once that each do what they do alone, or are of cells
POINTS, BESIDE = 64, 1e-6  # about a corner, for each switch, and how far from it


class Held(NamedTuple):
    """Numbers of decisions that stay as they are: all of them, and one for each switch.

    Switches "apart" each add to the rates what they add alone; of "cells" there is one more than
    switches; of others, "nested", each has two sides for both of those before it.
    """

    places: tuple[int, ...]
    switches: tuple[int, ...]
    kind: str = "nested"

    def turned(self) -> np.ndarray:
        """Return whether each switch is turned on each of the sides: (sides, switches)."""
        k = len(self.switches)
        if self.kind != "nested":
            each = np.eye(k + 1, k, -1, dtype=int)
            return each if self.kind == "cells" else np.vstack([each, np.ones_like(each[:1])])
        return np.arange(2**k)[:, None] >> np.arange(k) & 1


def cells_that_meet(
    diagram: Any, batch: Any, place: Any, met: Sequence[int]
) -> tuple[Held, np.ndarray] | None:
    """Return the cells of other rates that meet in a `Place`, held, and their decisions.

    None unless there is one more than switches; `met` are the decisions that turn there.
    """
    d, moving = diagram.code.program.decided, [k for k in met if place.slopes[:, k].any()]
    switches = list[int]()
    for k in moving:
        if not (switches and place.within([k], switches)):
            switches.append(k)
    if not 1 < len(switches) <= MOST_APART:
        return None
    drawn = np.random.default_rng(0).standard_normal((POINTS * len(switches), len(switches)))
    points = place.x + BESIDE * drawn @ np.linalg.pinv(place.slopes[:, switches])
    at = np.full(len(points), place.t), points, batch.pieces[0], batch.arrays[1]
    every = diagram.callee().evaluate(numbering.DERIVATIVE, *at, len(place.x))
    decided = diagram.callee().evaluate(numbering.DECIDE, *at, 3 * d)[:, :d]
    cells, rates = list[np.ndarray](), list[np.ndarray]()
    for cell, rate in zip(decided, every, strict=True):
        if all(np.abs(rate - one).max() > FLAT * np.abs(rate).max() for one in rates):
            cells.append(cell)
            rates.append(rate)
    if len(cells) != len(switches) + 1:
        return None
    change = place.slopes[:, switches].T @ (np.array(rates[1:]) - rates[0]).T
    order, *_ = scipy.linalg.lu(change, p_indices=True)  # in which no pivot is 0
    switches = [switches[k] for k in np.argsort(order)]
    return Held(tuple(map(int, moving)), tuple(map(int, switches)), "cells"), np.array(cells)


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
        """Return the weights with which no distance changes; pivots are margins of those apart."""
        rows = list[list[Any]]()
        for g in distances:
            along = slope(g, rates)
            rows.append([slope(g, other) - along for other in others] + [-along])
        for i, row in enumerate(rows):
            if type(pivot := row[i]) is float and pivot == 0.0:
                raise Unread("a switch that its rates do not move")
            if held.kind == "apart":
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
    if held.kind == "apart":
        *others, last = sides[1:]
        for port, *ports in zip(first, *others, last, strict=True):
            a, *b = (spread(record.tape, value(one.ref), port.shape) for one in (port, *ports))
            *changes, together = (one - a for one in b)
            sizes = [size(one, port.long) for one in changes]
            nothing(size(together - sum(changes), port.long), sum(sizes))
        sides = [first, *others]
    if held.kind != "nested":
        weights = weights_of(distances, first, sides[1:])
        record.margins += [operand(1.0 - sum(weights))] * (held.kind == "cells")
        sides = [mean(weights, first, sides[1:])]
    for g in distances if held.kind == "nested" else ():
        pairs = zip(sides[::2], sides[1::2], strict=True)
        sides = [mean(weights_of([g], one, [other]), one, [other]) for one, other in pairs]
    for place in set(held.places).difference(held.switches):
        g = decisions.distance_of(place)
        nothing(size(slope(g, sides[0])), size(slope(g, first)))
    (record.rates,) = sides
