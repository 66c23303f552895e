"""Event checks: does a step cross a switching condition or a guard, or may it do so unseen?

Events are evaluated at `SAMPLE_POINTS` points of a step, at states of the step's interpolant.  All
but the guards are switching conditions (`switching_conditions`).  Guards are the last events, and
stop the run.  Diagrams with events run in one lane.

    points[point, DISTANCE, j]   distance of event j: below 0 behind the event
    points[point, ROUNDING, j]   rounding error of that distance
"""

import math

from .solver_layout import (
    ACCEPTED,
    ARGUMENT,
    DECISION,
    DISTANCE,
    ENTERED,
    EVENT_INDEX,
    FRESH,
    ROUNDING,
    RUN_INDEX,
    SAMPLE_POINTS,
    STAGE_TIME,
    STATE,
    TIME,
    TRIAL_END,
    TRIAL_SIZE,
    WITHIN,
    Bracket,
    decide,
    differs,
    prepare,
    put_state_within,
    retry,
)

# Shares of the step at which conditions are evaluated: quarters, and points between them at which
# nothing periodic looks as it does at the quarters, up to 240 periods a step
SHARES = (0.0, 0.0803, 0.25, 0.3333, 0.5, 0.6575, 0.75, 0.8889, 1.0)
# of the polynomial through the quarters at each point between them: the factors of the quarters
FACTORS = tuple(
    math.prod(
        (SHARES[a] - SHARES[c]) / (SHARES[b] - SHARES[c])
        for c in range(0, 9, 2)
        if c != b
    )
    for a in range(1, 9, 2)
    for b in range(0, 9, 2)
)
QUARTERS = SAMPLE_POINTS // 2
CLEAR = 10.0  # errors between points that a distance must exceed
# of the time: rounding moves what changes in it by so much of its change
TIME_ROUNDING = 1e-15
# step up to an event, of a run, and of the time: in a shorter one states move by rounding alone
SHORTEST, SHORTEST_OF_TIME = 1e-13, 4e-15
NEAR = 0.25  # of the change of a distance in a step: so wrong may the cubic through its ends be
SUBNORMAL = 1e-320  # rounding of sums of the smallest numbers
DEEPER = 1.5  # so much deeper than the vertex of a parabola may a distance fall


def hold_decisions(solver):
    """Hold the decisions of this time until the next event, where integration begins anew.

    It begins anew where decisions change as a segment begins: an input may reach a threshold where
    a segment ends, and stay there, so that no step crosses it.
    """
    lane, P, points = solver.lane, solver.memory.P, solver.points
    first = solver.shape.first_decision
    decide(solver, lane[TIME], STATE, 0)
    if lane[FRESH, 0] == ENTERED:
        lane[FRESH, 0] = 1.0 if decisions_differ(solver, 0) else 0.0
    if lane[FRESH, 0] > 0.5:
        for j in range(solver.shape.decisions):
            P[first + j] = points[0, DECISION, j]
        prepare(solver, lane[TIME])


def decisions_differ(solver, point):
    """Return whether decisions of a sample point differ from those in force."""
    first = solver.shape.first_decision
    for j in range(solver.shape.decisions):
        if differs(solver.points[point, DECISION, j], solver.memory.P[first + j]):
            return True
    return False


def evaluate_points(solver):
    """Evaluate the events at the sample points of the step."""
    for point in range(SAMPLE_POINTS + 1):
        put_state_within(solver, SHARES[point])
        # the last one is the new state
        row = WITHIN if point < SAMPLE_POINTS else ARGUMENT
        decide(solver, solver.lane[STAGE_TIME], row, point)


def comes_near(solver):
    """Return whether a distance comes near 0, by the cubic through the ends of the step."""
    evaluate_points(solver)
    lane, points = solver.lane, solver.points
    lane[STAGE_TIME, 0] = lane[TRIAL_END, 0]
    for j in range(points.shape[2]):
        least, most = math.inf, -math.inf
        for point in range(SAMPLE_POINTS + 1):
            least = min(least, points[point, DISTANCE, j])
            most = max(most, points[point, DISTANCE, j])
        near = NEAR * (most - least) + CLEAR * error_between(points, j)
        rounding = points[0, ROUNDING, j]
        if least < (near if near > rounding else -rounding):
            return True
    return False


def check_events(solver):
    """Find the first event of the step; return its bracket.

    The step is halved if a distance may cross 0 and return between the points before that event.
    """
    evaluate_points(solver)
    set_edges(solver)
    return find_crossing(solver, 0.0)


def shortest_step(solver):
    """Return the length of the shortest step up to an event."""
    run = solver.times[-1] - solver.times[0]
    return max(SHORTEST * run, SHORTEST_OF_TIME * abs(solver.lane[TIME, 0]))


def set_edges(solver):
    """Set how far beyond its edge each guard is left in this step, in place of rounding errors.

    To the rounding error of a distance its change in the shortest step is added: so late may an
    event be that set the state at the edge.  Where states jump, it is passed at 0 if the step
    begins above it.
    """
    points, shape = solver.points, solver.shape
    share = min(1.0, shortest_step(solver) / solver.lane[TRIAL_SIZE, 0])
    for guard in range(shape.decisions, shape.decisions + shape.guarded):
        least, most, rounding = math.inf, -math.inf, 0.0
        for point in range(SAMPLE_POINTS + 1):
            rounding = max(rounding, points[point, ROUNDING, guard])
            if abs(points[point, DISTANCE, guard]) < math.inf:
                least = min(least, points[point, DISTANCE, guard])
                most = max(most, points[point, DISTANCE, guard])
        edge = edge_of(rounding, share * (most - least))
        is_above = points[0, DISTANCE, guard] > 0.0
        is_level = solver.levels[guard - shape.decisions] > 0.5
        points[0, ROUNDING, guard] = edge
        for point in range(1, SAMPLE_POINTS + 1):
            points[point, ROUNDING, guard] = 0.0 if is_level and is_above else edge


def edge_of(rounding, change):
    """Return how far beyond its edge a guard is left; the change may not be finite."""
    return rounding + change if change < math.inf else rounding


def find_crossing(solver, start):
    """Find the first event behind a share of the step; return the bracket of the points around it.

    Set `event_index`, to -1 if there is no event.
    A step of discrete time is checked at its end only, and not halved.
    """
    lane, integers, points = solver.lane, solver.integers, solver.points
    discrete = solver.shape.discrete > 0
    integers[EVENT_INDEX, 0] = -1
    lane[STAGE_TIME, 0] = lane[TRIAL_END, 0]
    if integers[RUN_INDEX, 0] < 0 or lane[ACCEPTED, 0] < 0.5:
        return Bracket(0.0, 0.0, 0.0, 0.0)
    point = SAMPLE_POINTS - 1 if discrete else 0
    while point < SAMPLE_POINTS - 1 and SHARES[point + 1] <= start:
        point += 1
    first = point + 1
    while point < SAMPLE_POINTS and integers[EVENT_INDEX, 0] < 0:
        point += 1
        integers[EVENT_INDEX, 0] = first_crossed(points, point)
    before = 0 if discrete else point - 1
    bracket = Bracket(
        low=max(start, SHARES[before]),
        high=SHARES[point],
        distance_low=max(least_distance(points, before), 0.0),
        distance_high=least_distance(points, point),
    )
    clear_until = point if integers[EVENT_INDEX, 0] < 0 else point - 1
    divisible = not discrete and lane[TRIAL_SIZE, 0] > 2.0 * shortest_step(solver)
    if divisible and may_hide(
        points, first, clear_until, lane[TRIAL_END, 0], lane[TRIAL_SIZE, 0]
    ):
        retry(solver, 0, 0.5 * lane[TRIAL_SIZE, 0])
        integers[EVENT_INDEX, 0] = -1
    return bracket


def first_crossed(points, point):
    """Return the first condition that has changed at a sample point of the step, or -1."""
    for j in range(points.shape[2]):
        if points[point, DISTANCE, j] < -points[point, ROUNDING, j]:
            return j
    return -1


def least_distance(points, point):
    """Return the least distance of the events, and its rounding; below 0 behind one."""
    least = math.inf
    for j in range(points.shape[2]):
        least = min(least, points[point, DISTANCE, j] + points[point, ROUNDING, j])
    return least


# --- events between the points --------------------------------------------------------------------


def may_hide(points, first, last, end, size):
    """Return whether a condition may cross and return between sample points, up to the last.

    The step is too long to tell unless every distance within it, and the vertex of each parabola
    through three of them, is above 0, and `CLEAR` times as large as the error between; except those
    around a crossing that is seen.  Rounding errors of the distances, or of the time, are no error.
    """
    time_rounding = TIME_ROUNDING * abs(end) / size
    for j in range(points.shape[2]):
        error = error_between(points, j)
        rounding = SUBNORMAL + abs(points[0, ROUNDING, j])
        for point in range(SAMPLE_POINTS):
            change = points[point + 1, DISTANCE, j] - points[point, DISTANCE, j]
            rounding += time_rounding * abs(change)
        least = least_distance_of(points, j, first, last, error)
        if least < -rounding or (error > rounding and least <= CLEAR * error):
            return True
    return False


def error_between(points, j):
    """Return the error, between the quarters of a step, of the quartic through their distances."""
    error = 0.0
    for m in range(QUARTERS):
        difference = points[2 * m + 1, DISTANCE, j]
        for i in range(QUARTERS + 1):
            difference -= FACTORS[5 * m + i] * points[2 * i, DISTANCE, j]
        error = max(error, abs(difference))
    return error


def least_distance_of(points, j, first, last, error):
    """Return the least distance of a condition at sample points and vertices of parabolas."""
    least = math.inf
    for point in range(first, min(last + 1, SAMPLE_POINTS)):
        a = points[point - 1, DISTANCE, j]
        b = points[point, DISTANCE, j]
        c = points[point + 1, DISTANCE, j]
        least = min(least, b)
        if point < last and b < CLEAR * error + 3.0 * (abs(a - b) + abs(c - b)):
            before = SHARES[point] - SHARES[point - 1]
            after = SHARES[point + 1] - SHARES[point]
            curvature = ((c - b) / after - (b - a) / before) / (before + after)
            slope = (b - a) / before + curvature * before
            if curvature > 0.0 and -after < 0.5 * slope / curvature < before:
                least = min(least, b - DEEPER * 0.25 * slope * slope / curvature)
    return least
