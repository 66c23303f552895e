"""Sliding: the run of a system whose rates lead back to switches from all sides.

On both sides of a switch g = 0 the rates lead back to it, as with dry friction or a relay.  In the
limit a run stays there, with the mean of the rates of both sides that does so (Filippov):

    x' = f_0 + w (f_1 - f_0),    g' = 0,    w = g'_0/(g'_0 - g'_1),    0 < w < 1

f_0 and f_1 are the rates on either side, g'_0 and g'_1 the derivative of g along them.  A run
slides until w leaves 0 ... 1, or to the next time at which rates jump (`sliding_rates`).  Several
decisions belong to one switch if the slopes of their distances are parallel.

The distances d_i of k switches change along the rates by d' = b + A w: w_i is the share of the
rates on the other side of switch i, where d_i < 0.  Each switch is in one of three states:

    w_i = 0 and d_i' >= 0    the run leaves to this side
    w_i = 1 and d_i' <= 0    the run leaves to the other side
    d_i' = 0                 the run slides, 0 < w_i < 1

This is a linear complementarity problem with bounds.  If all principal minors of A are above 0, it
has one solution, which changes of the active set find.

Source: Piiroinen, P. T., Kuznetsov, Y. A. (2008), An event-driven method to simulate Filippov
systems with accurate computing of sliding motions, ACM Trans. Math. Softw. 34(3); Judice, J. J.,
Pires, F. M. (1992), Basic-set algorithm for a generalized linear complementarity problem, J. Optim.
Theory Appl. 74; Leine, R. I., Nijmeijer, H. (2004), Dynamics and Bifurcations of Non-Smooth
Mechanical Systems, Springer, chapter 6.
"""

from collections.abc import Mapping, Sequence
from contextlib import suppress
from itertools import combinations
from typing import Any, NamedTuple

import numpy as np
from numpy import ndarray
from scipy.sparse.csgraph import connected_components

from ...base.errors import Uncompiled
from ..record.unread import Unread
from .batch import Batch
from .schedule import Schedule
from .sliding_rates import NEGLIGIBLE, HeldSwitch, decisions_of
from .solver_layout import (
    DECISION,
    DERIVATIVE,
    DISTANCE,
    EVENT_INDEX,
    ROUNDING,
    SAMPLE_POINTS,
    STATE,
    Status,
)
from .termination import decision_name, stopped_at

PARALLEL = 1e-4  # share of a slope that may stand out of the others
NEAR = 1e3  # rounding errors of a distance within which a decision is about to change
CHANGE = 1e-6  # of states and time, relative, for the slopes of distances
GRAIN = 1e-10  # of states, relative, that decides nothing
ASIDE = 1e-8  # of states, relative, or
GRAINS = 1e4  # rounding errors of the numbers compared: there sides are evaluated
MOST_COUPLED = 12  # switches that move each other
MOST_CHANGES = 1000  # of the active set
SLIDES = 2  # beside the sides 0 and 1


class Refused(Exception):
    """The motion on the switches of a point is not known."""

    def __init__(self, reason: str, switches: Sequence[HeldSwitch]):
        super().__init__(reason)
        self.switches = switches


class Crossing:
    """A point at which a run crosses switches to and fro, with the decisions that its batch holds.

    Attributes
    ----------
    distance, rounding : ndarray
        Distance of each decision, and its rounding error.
    slopes : ndarray
        Derivatives of distances with states, by differences, (states, decisions).
    drift : ndarray
        Derivatives of distances with time.
    change : ndarray
        Change of distances with states that change by their size.
    """

    def __init__(self, diagram: Any, batch: Batch, t: float, state: ndarray):
        self.callee, self.segments = diagram.callee(), batch.schedules[0]
        self.time, self.state = t, state
        offset, count = self.callee.decided_at, self.callee.decided
        self.parameters = batch.memory.P[: offset + count]
        rtol, atol = self.parameters[offset - 2 : offset]
        sizes = np.abs(state) + atol / rtol
        changes = CHANGE * sizes
        end = self.segments.edges[np.searchsorted(self.segments.edges, t, "right")]
        later = min(CHANGE * (1.0 + abs(t)), 1e-3 * (end - t))
        if later <= 1e-3 * CHANGE * (1.0 + abs(t)):
            later = -CHANGE * (1.0 + abs(t))
        times, *at = self.at(np.vstack([state, state + np.diag(changes), state]))
        times[-1] += later
        events = self.callee.events_at(times, *at)
        distances = events[:, DISTANCE, :count]
        self.distance = distances[0]
        self.rounding = events[0, ROUNDING, :count]
        self.slopes = (distances[1:-1] - distances[0]) / changes[:, None]
        self.change = sizes @ np.abs(self.slopes)
        self.drift = (distances[-1] - distances[0]) / (times[-1] - t)

    def at(self, states: ndarray) -> tuple[ndarray, ndarray, Schedule, ndarray]:
        """Return arguments of the callee for states at this time."""
        times = np.full(len(states), self.time)
        return times, states, self.segments, self.parameters

    @property
    def undecided(self) -> ndarray:
        """Return for each decision whether it is about to change."""
        return np.abs(self.distance) < NEAR * (self.rounding + GRAIN * self.change)

    def switches(self, chosen: ndarray, changed: ndarray) -> list[HeldSwitch]:
        """Return the switches of chosen decisions: their slopes are parallel."""
        steepness = np.linalg.norm(self.slopes, axis=0)
        candidates = np.flatnonzero(chosen & (steepness > 0.0)).tolist()
        # those that changed come first, the steepest before others
        candidates.sort(key=lambda k: (not changed[k], -steepness[k]))
        switches = []
        while candidates:
            switch = candidates[0]
            slope = self.slopes[:, [switch]]
            slopes = self.slopes[:, candidates]
            shares, *_ = np.linalg.lstsq(slope, slopes, rcond=None)
            perpendicular = np.linalg.norm(slopes - slope @ shares, axis=0)
            parallel = perpendicular <= PARALLEL * steepness[candidates]
            decisions = np.compress(parallel, candidates).tolist()
            switches.append(HeldSwitch(tuple(sorted(decisions)), switch))
            candidates = [k for k in candidates if k not in decisions]
        return switches


# --- sides ----------------------------------------------------------------------------------------


class Sides(NamedTuple):
    """Decisions and rates on the sides of switches, and the linear problem d' = b + A w."""

    switches: list[HeldSwitch]
    decisions: ndarray  # on one side of all, then with each switch flipped
    matrix: ndarray
    slopes: ndarray


def sides_of(crossing: Crossing, switches: list[HeldSwitch]) -> Sides:
    """Evaluate the sides of switches; those that do not change the rates are left out."""
    # 1. states on one side of all switches, beyond single ones, pairs, and all
    normals = normals_of(crossing, switches)
    count = len(switches)
    flipped = [set[int](), *({k} for k in range(count))]
    flipped += [{*pair} for pair in combinations(range(count), 2)]
    flipped.append(set(range(count)))
    numbers = [locked.switch for locked in switches]
    rounding = GRAINS * crossing.rounding[numbers]
    aside = np.maximum(ASIDE * crossing.change[numbers], rounding)
    signs = [[-1.0 if k in flips else 1.0 for k in range(count)] for flips in flipped]
    moves = aside * signs - crossing.distance[numbers]
    states = crossing.state + moves @ normals.T
    # 2. decisions and rates there
    callee, at = crossing.callee, crossing.at(states)
    rates = callee.evaluate(DERIVATIVE, *at)
    if not np.isfinite(rates).all():
        raise Refused("have rates that are not finite", switches)
    largest = np.abs(rates).max()
    changes = rates - rates[0]
    effective = np.abs(changes[1 : 1 + count]).max(axis=1) > NEGLIGIBLE * largest
    if not effective.all():
        remaining = [
            locked for locked, has in zip(switches, effective, strict=True) if has
        ]
        return sides_of(crossing, remaining)
    # 3. sides together change the rates as they do one by one
    for flips, change in zip(flipped, changes, strict=True):
        single = changes[[1 + k for k in flips]].sum(axis=0)
        if np.abs(change - single).max(initial=0.0) > NEGLIGIBLE * largest:
            raise Refused("do not act on the rates one by one (not affine)", switches)
    events = callee.events_at(*at)
    decisions = np.tile(events[0, DECISION, : callee.decided], (1 + count, 1))
    for k, locked in enumerate(switches):
        fixed = [*locked.decisions]
        decisions[1 + k, fixed] = events[1 + k, DECISION, fixed]
    slopes = crossing.slopes[:, numbers].T
    matrix = slopes @ changes[1 : 1 + count].T
    return Sides(
        switches, decisions, matrix, slopes @ rates[0] + crossing.drift[numbers]
    )


def normals_of(crossing: Crossing, switches: Sequence[HeldSwitch]) -> ndarray:
    """Return directions along which one distance changes by 1 and no other does."""
    slopes = crossing.slopes[:, [locked.switch for locked in switches]]
    lengths = np.linalg.norm(slopes, axis=0)
    if np.linalg.matrix_rank(slopes / lengths, PARALLEL) < len(switches):
        raise Refused("depend on each other", switches)
    return np.linalg.pinv(slopes).T


# --- active sets ----------------------------------------------------------------------------------


def active_set(sides: Sides, forced: Mapping[int, int] = {}) -> ndarray:
    """Return of each switch 0, 1 or `SLIDES`; a forced one stays on its side."""
    A, b = sides.matrix, sides.slopes
    _check_minors(sides)
    free = np.array([k not in forced for k in range(len(b))], dtype=bool)
    state = np.full(len(b), SLIDES)
    for k, side in forced.items():
        state[k] = side
    for _ in range(MOST_CHANGES):
        w = shares_of(sides, state)
        slopes = b + A @ w
        rounding = NEGLIGIBLE * (np.abs(A) @ w + np.abs(b))
        slides = state == SLIDES
        below = slides & (w < 0.0)
        above = slides & (w > 1.0)
        returns = (state == 0) & (slopes < -rounding) | (state == 1) & (
            slopes > rounding
        )
        wrong = np.flatnonzero(free & (below | above | returns))
        if not len(wrong):
            return state
        k = wrong[0]
        state[k] = SLIDES if returns[k] else int(above[k])
    raise Refused("have no motion that slides", sides.switches)


def shares_of(sides: Sides, state: ndarray) -> ndarray:
    """Return the shares w with which the switches that slide keep their distance."""
    slides = state == SLIDES
    w = np.where(slides, 0.0, state)
    target = -(sides.slopes + sides.matrix @ w)[slides]
    w[slides] = np.linalg.solve(sides.matrix[np.ix_(slides, slides)], target)
    return w


def _check_minors(sides: Sides) -> None:
    """Refuse switches unless all principal minors are above 0, so that there is one motion."""
    steepness = np.abs(np.diag(sides.matrix))
    if not len(steepness):
        return
    if not np.all(np.diag(sides.matrix) > 0.0):
        raise Refused("do not lead back to themselves", sides.switches)
    scaled = sides.matrix / steepness[:, None]
    groups, group_of = connected_components(np.abs(scaled) > NEGLIGIBLE)
    for group in range(groups):
        members = np.flatnonzero(group_of == group)
        if len(members) > MOST_COUPLED:
            raise Refused(f"are more than {MOST_COUPLED}", sides.switches)
        for size in range(2, len(members) + 1):
            for chosen in combinations(members, size):
                if not np.linalg.det(scaled[np.ix_(chosen, chosen)]) > NEGLIGIBLE:
                    raise Refused("have more than one motion", sides.switches)


# --- runs on switches -----------------------------------------------------------------------------


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
    crossing = Crossing(diagram, batch, batch.now, state)
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
    crossing = Crossing(diagram, batch, t, state)
    with suppress(Refused):
        sides = sides_of(crossing, [*sliding.held])
        state_of = active_set(sides, {k // 2: k % 2})
        return _sliding_on(diagram, batch, crossing, sides, state_of)
    return None


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
    time, states, segments, _ = crossing.at(state[None])
    events = runner.callee().events_at(time, states, segments, parameters)
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
