"""Event location: where a step crosses switching conditions, and the restart behind the event.

A step holds every decision of the rates (``u > 1``, ``max(a, b)``, ``floor(x)``) as it was when the
step began.  If a decision has changed within the step, the step is valid up to that event x only:

    0 -------- low --x-- high -------- 1     shares of the step

1. Measure the effect of the events: step times difference of the rates with new and with held
   decisions, in tolerances.  Below `NEGLIGIBLE` the step stays as it is; otherwise rounding would
   decide where steps end.  The effect of a guard is infinite.
2. Bracket the first event between two sample points of the step, and narrow the bracket.
3. If the event is a guard, stop the run at `high` and reject the step.  Otherwise try the step
   again up to `high`.  The next step begins there, with new decisions.
"""

import math

from .event_checks import (
    SHARES,
    SHORTEST,
    TIME_ROUNDING,
    first_crossed,
    may_hide,
    row_of,
)
from .solver_layout import (
    ACCEPTED,
    ANEW,
    BEGINNING,
    BEHIND,
    BURST,
    DECISION,
    DISTANCE,
    DISTANCE_HIGH,
    DISTANCE_LOW,
    EVENT_CROSSED,
    EVENT_EFFECT,
    EVENT_INDEX,
    FRESH,
    HELD_RATE,
    HIGH,
    LAST_EVENT,
    LOW,
    NEW_RATE,
    OUTSIDE,
    RATE,
    ROUNDING,
    SAMPLE_POINTS,
    STAGE_TIME,
    STATE,
    TIME,
    TRIAL_END,
    TRIAL_SIZE,
    WITHIN,
    Status,
    decide,
    derivative,
    fail,
    first_outside,
    prepare,
    put_state_within,
    retry,
)

CROSSED = 1.0  # value of `event_crossed`: the step ends right behind an event
RESOLVED = 1e-12  # distance from an event at which a step ends, as a share of it
WIDTH = 0.1 * RESOLVED  # final width of the bracket
STOP_WIDTH = 1e-14  # of the bracket at which a run stops
CLOSE = 1e-5  # width of the bracket behind which the effect of an event is measured
MOST_TRIALS = 45  # halvings that reach WIDTH, and one more
NEGLIGIBLE = 0.1  # effect, in tolerances, up to which a step may pass an event
MOST_NEGLIGIBLE = 32  # events with a negligible effect in one step
MOST_EVENTS = 1000  # in a row, each soon after the other
# "soon", as a share of the run: if a state moves by its tolerance meanwhile, and otherwise
SHORT_MOVING, SHORT_RESTING = 1e-7, 5e-6


def locate_events(solver):
    """Locate the first event of a step that has an effect; shorten a step that ends beyond it."""
    lane, integers = solver.lane, solver.integers
    measure_effects(solver)
    if bracket_next(solver, True, 0):
        low = lane[LOW, 0]
        narrow(solver, WIDTH)
        if solver.shape.guarded > 0 and stops_run(solver, low):
            return
    size = lane[TRIAL_SIZE, 0]
    end = lane[TRIAL_END, 0]
    lane[STAGE_TIME, 0] = end
    if integers[EVENT_INDEX, 0] < 0:
        return
    shortest = SHORTEST * (solver.times[-1] - solver.times[0])
    divisible = size > 2.0 * shortest
    if lane[EVENT_EFFECT, 0] > NEGLIGIBLE:
        resolution = max(RESOLVED * size, 4.0 * TIME_ROUNDING * abs(end))
        if divisible and (1.0 - lane[LOW, 0]) * size > resolution:
            retry(solver, 0, max(lane[HIGH, 0] * size, shortest))
        else:
            lane[EVENT_CROSSED, 0] = CROSSED
        return
    # the bracket is still open if more events than MOST_NEGLIGIBLE were passed
    too_many = lane[LOW, 0] < lane[HIGH, 0]
    if divisible and (too_many or may_hide(solver.points, SAMPLE_POINTS, end, size)):
        retry(solver, 0, 0.5 * size)
    elif first_crossed(solver.points, SAMPLE_POINTS) >= 0:
        lane[EVENT_CROSSED, 0] = CROSSED


def stops_run(solver, low):
    """Stop the run if the event in the bracket is a guard; return whether it is.

    The run stops at the guard's edge, which lies between `low` and the bracket, or before `low` if
    the edge is passed there by less than `OUTSIDE`; at the step's beginning if no point is inside.
    """
    lane, points = solver.lane, solver.points
    decide_within(solver, lane[HIGH, 0])
    # guards are the last events: a switching condition in the same bracket comes first
    guard = first_crossed(points, BEHIND)
    if guard < solver.shape.decisions:
        return False
    lane[DISTANCE_HIGH, 0] = points[BEHIND, DISTANCE, guard]
    share = low
    for trial in range(MOST_TRIALS):
        decide_within(solver, share)
        lane[LOW, 0] = share
        lane[DISTANCE_LOW, 0] = points[BEHIND, DISTANCE, guard]
        if lane[DISTANCE_LOW, 0] > 0.0:
            break
        share = 0.5 * (share if trial > 0 else lane[HIGH, 0])
    if lane[DISTANCE_LOW, 0] > 0.0:
        points[BEHIND, ROUNDING, guard] = 0.0
        narrow(solver, STOP_WIDTH)
        points[BEHIND, ROUNDING, guard] = OUTSIDE
    else:
        lane[HIGH, 0] = 0.0
    solver.integers[EVENT_INDEX, 0] = guard
    fail(solver, 0, Status.GUARD_LEFT)
    lane[ACCEPTED, 0] = 0.0
    return True


# --- the effect of events -------------------------------------------------------------------------


def measure_effects(solver):
    """Set `event_effect` to the largest effect at a sample point, or behind an event.

    Events without effect are passed one after the other, for one may give effect to the next.
    """
    lane = solver.lane
    lane[EVENT_EFFECT, 0] = 0.0
    for point in range(SAMPLE_POINTS, 0, -1):
        put_state_within(solver, SHARES[point])
        measure_effect(solver, point)
    for passage in range(MOST_NEGLIGIBLE):
        if not bracket_next(solver, False, BEHIND if passage > 0 else 0):
            return
        narrow(solver, CLOSE)
        decide_within(solver, lane[HIGH, 0])
        measure_effect(solver, BEHIND)


def measure_effect(solver, point):
    """Raise the effect of the events to that of the decisions at a point, if negligible so far."""
    lane, integers = solver.lane, solver.integers
    in_bracket = lane[LOW, 0] < lane[HIGH, 0]
    if (
        integers[EVENT_INDEX, 0] < 0
        or lane[EVENT_EFFECT, 0] > NEGLIGIBLE
        or not in_bracket
    ):
        return
    if first_crossed(solver.points, point) < 0:
        return
    if first_outside(solver, point) >= 0:  # of a guard
        lane[EVENT_EFFECT, 0] = math.inf
        return
    # rates with the decisions held, which are in P; then with those of the point
    row = WITHIN if point == BEHIND else row_of(point)
    derivative(solver, lane[STAGE_TIME], row, HELD_RATE)
    exchange_decisions(solver, point)
    prepare(solver, lane[STAGE_TIME])
    derivative(solver, lane[STAGE_TIME], row, NEW_RATE)
    exchange_decisions(solver, point)
    prepare(solver, lane[STAGE_TIME])
    states = solver.states
    relative, absolute = solver.tolerances[0], solver.tolerances[1]
    for i in range(solver.shape.states):
        difference = abs(states[NEW_RATE, i, 0] - states[HELD_RATE, i, 0])
        tolerance = absolute + relative * abs(states[STATE, i, 0])
        effect = lane[TRIAL_SIZE, 0] * difference / tolerance
        effect = effect if effect - effect == 0.0 else math.inf
        lane[EVENT_EFFECT, 0] = max(lane[EVENT_EFFECT, 0], effect)


def decide_within(solver, share):
    """Evaluate the events at a share of the step into the point BEHIND."""
    put_state_within(solver, share)
    decide(solver, solver.lane[STAGE_TIME], WITHIN, BEHIND)


def exchange_decisions(solver, point):
    """Exchange the decisions that are held in P with those of a sample point."""
    P, points = solver.memory.P, solver.points
    first = solver.shape.first_decision
    for j in range(solver.shape.decisions):
        held = P[first + j]
        P[first + j] = points[point, DECISION, j]
        points[point, DECISION, j] = held


# --- the bracket ----------------------------------------------------------------------------------


def least_distance(solver, point):
    """Return the least distance of the events; below 0 behind one."""
    points, signs = solver.points, solver.signs
    least = math.inf
    for j in range(points.shape[2]):
        distance = signs[j] * points[point, DISTANCE, j]
        least = min(least, distance + points[point, ROUNDING, j])
    return least


def bracket_next(solver, effective, start):
    """Put the next event between `low` and `high`; return whether there is one.

    The search begins at the point `start`, the first or that BEHIND the last event.  It is done if
    the events are `effective`, or only if they are not.
    """
    lane, integers = solver.lane, solver.integers
    if (
        integers[EVENT_INDEX, 0] < 0
        or (lane[EVENT_EFFECT, 0] > NEGLIGIBLE) != effective
    ):
        return False
    points = solver.points
    for j in range(points.shape[2]):
        changed = points[start, DISTANCE, j] < -points[start, ROUNDING, j]
        solver.signs[j] = -1.0 if start == BEHIND and changed else 1.0
    low = lane[HIGH, 0] if start == BEHIND else 0.0
    distance_low = least_distance(solver, start)
    point, distance = 1, 0.0
    while point <= SAMPLE_POINTS and distance >= 0.0:
        if SHARES[point] > low:
            distance = least_distance(solver, point)
            if distance >= 0.0:
                low, distance_low = SHARES[point], distance
        point += 1
    lane[LOW, 0] = low
    lane[HIGH, 0] = SHARES[point - 1] if distance < 0.0 else low
    lane[DISTANCE_LOW, 0] = distance_low
    lane[DISTANCE_HIGH, 0] = distance
    return distance < 0.0


def narrow(solver, width):
    """Narrow the bracket to a width; the event stays between `low` and `high`."""
    lane = solver.lane
    for trial in range(MOST_TRIALS):
        if lane[HIGH, 0] - lane[LOW, 0] <= width:
            return
        share = next_share(solver, width, trial)
        decide_within(solver, share)
        distance = least_distance(solver, BEHIND)
        if distance < 0.0:
            lane[HIGH, 0] = share
            lane[DISTANCE_HIGH, 0] = distance
        else:
            lane[LOW, 0] = share
            lane[DISTANCE_LOW, 0] = distance


def next_share(solver, width, trial):
    """Return the share at which the bracket is divided: the ITP rule.

    It takes at most one trial more than halving does.

    Source: Oliveira, Takahashi, An enhancement of the bisection method average performance
    preserving minmax optimality, ACM Trans. Math. Softw. 47(1), 2021.
    """
    lane = solver.lane
    low, high = lane[LOW, 0], lane[HIGH, 0]
    distance_low, distance_high = lane[DISTANCE_LOW, 0], lane[DISTANCE_HIGH, 0]
    middle = 0.5 * (low + high)
    radius = 0.5 * (width * 2.0 ** (MOST_TRIALS - trial) - (high - low))
    # interpolate
    share = (low * distance_high - high * distance_low) / (distance_high - distance_low)
    share = share if low < share < high else middle
    # truncate
    toward_middle = math.copysign(1.0, middle - share)
    share += toward_middle * min((high - low) * (high - low), abs(middle - share))
    # project
    if abs(share - middle) <= radius:
        return share
    return middle - toward_middle * max(radius, 0.0)


# --- behind an event ------------------------------------------------------------------------------


def restart_behind_event(solver):
    """Begin anew behind an event; end a run that meets event after event without advancing."""
    lane, integers = solver.lane, solver.integers
    if lane[EVENT_CROSSED, 0] == CROSSED and lane[ACCEPTED, 0] > 0.5:
        states = solver.states
        since_last = lane[TIME, 0] - lane[LAST_EVENT, 0]
        moves = False
        for i in range(solver.shape.states):
            tolerance = solver.tolerances[1] + solver.tolerances[0] * abs(
                states[STATE, i, 0]
            )
            moves = moves or abs(states[RATE, i, 0]) * since_last > tolerance
        share = SHORT_MOVING if moves else SHORT_RESTING
        is_short = since_last < share * (solver.times[-1] - solver.times[0])
        integers[BURST, 0] = integers[BURST, 0] + 1 if is_short else 0
        lane[LAST_EVENT, 0] = lane[TIME, 0]
        lane[FRESH, 0] = 1.0
        solver.queue[BEGINNING] = ANEW
        if integers[BURST, 0] > MOST_EVENTS:
            fail(solver, 0, Status.CHATTERING)
    lane[EVENT_CROSSED, 0] = 0.0
