"""Sliding: the run of a system whose rates lead back to switches from all sides.

On both sides of a switch g = 0 the rates lead back to it, as with dry friction or a relay.  In the
limit a run stays there, with the mean of the rates of both sides that does so (Filippov):

    x' = f_0 + w (f_1 - f_0),    g' = 0,    w = g'_0/(g'_0 - g'_1),    0 < w < 1

f_0 and f_1 are the rates on either side, g'_0 and g'_1 the derivative of g along them.  A run
slides until w leaves 0 ... 1, or to the next time at which rates jump.  Several decisions belong to
one switch if the slopes of their distances are parallel.  `active_switches` finds on which of
several switches a run slides, `sliding_rates` has their rates.

Source: Piiroinen, P. T., Kuznetsov, Y. A. (2008), An event-driven method to simulate Filippov
systems with accurate computing of sliding motions, ACM Trans. Math. Softw. 34(3).
"""

from contextlib import suppress
from typing import Any, NamedTuple

import numpy as np
from numpy import ndarray

from ...base.errors import Uncompiled
from ..record.unread import Unread
from .active_switches import (
    SLIDES,
    Crossing,
    Refused,
    Sides,
    active_set,
    crossing_at,
    normals_of,
    sides_of,
)
from .batch import Batch
from .sliding_rates import NEGLIGIBLE, HeldSwitch, decisions_of
from .solver_layout import DECISION, DISTANCE, EVENT_INDEX, SAMPLE_POINTS, STATE, Status
from .termination import decision_name, stopped_at


class Sliding(NamedTuple):
    """A run on switches: a `NativeDiagram` with the mean of the rates, and its parameters."""

    runner: Any
    parameters: ndarray
    held: tuple[HeldSwitch, ...]
    state: ndarray  # with which it begins


def enter(
    diagram: Any, batch: Batch, sliding: Sliding | None
) -> tuple[Sliding | None, str]:
    """Return a run on the switches that a batch of one run crosses to and fro.

    Return None where its motion is not known, and a sentence on that if there is one.
    """
    state = batch.states[STATE, :, 0].copy()
    crossing = _crossing(diagram, batch, batch.now, state)
    count = diagram.code.program.decided
    before = batch.memory.P[diagram.decided_at :][:count]
    behind = batch.points[SAMPLE_POINTS, DECISION, :count]
    changed = before != behind
    chosen = changed | crossing.undecided & (np.abs(before) == 1.0)
    if sliding is not None:
        chosen[[*decisions_of(sliding.held)]] = True
    try:
        sides = sides_of(crossing, crossing.switches(chosen, changed))
        state_of = active_set(sides)
    except Refused as refused:
        return None, _sentence(diagram, crossing, refused)
    return _sliding_on(diagram, batch, crossing, sides, state_of), ""


def leave(diagram: Any, batch: Batch, sliding: Sliding | None) -> Sliding | None:
    """Return the run on the switches that a batch, which left one of several, stays on.

    The guards of a share w are behind those of the diagram: w itself, then 1 - w.
    """
    k = int(batch.integers[EVENT_INDEX, 0]) - batch.callee.decided
    k -= diagram.code.program.guarded
    if sliding is None or not k < 2 * len(sliding.held) > 2:
        return None
    t, state = stopped_at(batch)
    crossing = _crossing(diagram, batch, t, state)
    with suppress(Refused):
        sides = sides_of(crossing, [*sliding.held])
        state_of = active_set(sides, {k // 2: k % 2})
        return _sliding_on(diagram, batch, crossing, sides, state_of)
    return None


def _crossing(diagram: Any, batch: Batch, t: float, state: ndarray) -> Crossing:
    """Return a point of a batch of one run, with the decisions that it holds."""
    P = batch.memory.P[: diagram.decided_at + diagram.code.program.decided]
    return crossing_at(diagram.callee(), batch.schedules[0], P, t, state)


def _sliding_on(
    diagram: Any, batch: Batch, crossing: Crossing, sides: Sides, state_of: ndarray
) -> Sliding | None:
    """Return a run on those of the switches that slide; None if no run slides."""
    # 1. one side of all switches is where the others are
    sliding = np.flatnonzero(state_of == SLIDES)
    if not len(sliding):
        return None
    held = tuple(sides.switches[k] for k in sliding)
    one_side = sides.decisions[0].copy()
    for k in np.flatnonzero(state_of == 1):
        decisions = [*sides.switches[k].decisions]
        one_side[decisions] = sides.decisions[1 + k, decisions]
    on_sides = np.tile(one_side, (1 + len(sliding) + (len(sliding) > 1), 1))
    for row, k in enumerate(sliding, 1):
        for flipped in {row, len(on_sides) - 1}:
            decisions = [*sides.switches[k].decisions]
            on_sides[flipped, decisions] = sides.decisions[1 + k, decisions]
    # 2. parameters with the decisions on the sides
    try:
        runner = diagram.in_form(held=held)
    except (Unread, Uncompiled):
        return None
    parameters = runner.parameters(batch.runs.parameters[0])
    offset = diagram.decided_at
    parameters[offset - 2 : offset] = batch.memory.P[offset - 2 : offset]
    parameters[offset : offset + on_sides.size] = on_sides.ravel()
    # 3. on the switches the shares are within bounds
    numbers = [switch.switch for switch in held]
    moves = crossing.distance[numbers] @ normals_of(crossing, held).T
    state = crossing.state - moves
    events = runner.callee().events_at(
        [crossing.time], state[None], crossing.segments, parameters
    )
    if not events[0, DISTANCE, diagram.code.program.decided :].min() > -NEGLIGIBLE:
        return None
    return Sliding(runner, parameters, held, state)


def _sentence(diagram: Any, crossing: Crossing, refused: Refused) -> str:
    """Return why the motion is not known, with each switch and the states that turn it."""
    nodes = diagram.sweep.nodes
    labels = [label for node in nodes for label in node.system.state_labels]
    names = []
    for locked in refused.switches:
        turning = np.flatnonzero(crossing.slopes[: len(labels), locked.switch])
        states = ", ".join(labels[k] for k in turning)
        program = diagram.code.program
        names.append(
            f"{decision_name(diagram.sweep, program, locked.switch)} ({states})"
        )
    remedies = Status.CHATTERING.sentence.partition(". ")[2]
    if len(names) == 1:
        return f"{names[0]} {Status.CHATTERING.sentence}"
    return (
        f"the run meets {len(names)} switches at once, which {refused}: "
        f"{', '.join(names)}. {remedies}"
    )
