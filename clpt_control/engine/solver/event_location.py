"""Event location: where a step crosses switching conditions, and the restart behind the event.

A step holds every decision (``u > 1``, ``max(a, b)``, ``floor(x)``) as it was when the step began.
If a decision has changed within the step, the step is valid up to that event x only:

    0 -------- low --x-- high -------- 1     shares of the step

1. Bracket the first event between two sample points of the step, and narrow the bracket.
2. If the event is a guard, write the samples up to `high`, stop the run there, reject the step.
3. If the rates behind the event are the same with the new decisions, the new ones hold for the
   rest of the step, which is checked as a step that begins there.
4. Otherwise the step ends at `high`: with the interpolant's state if that is exact enough, else it
   is tried again up to there.  The next step begins anew, with new decisions.
"""

import math

from .event_checks import (
    SHARES,
    TIME_ROUNDING,
    check_events,
    decisions_differ,
    evaluate_points,
    find_crossing,
    first_crossed,
    least_distance,
    shortest_step,
)
from .segments import write_samples_until
from .solver_layout import (
    ACCEPTED,
    ANEW,
    ARGUMENT,
    BEFORE,
    BEGINNING,
    BEHIND,
    BURST,
    DECISION,
    DISTANCE,
    END_RATE,
    EVENT_CROSSED,
    EVENT_INDEX,
    FRESH,
    HELD_RATE,
    HIGH,
    INTERPOLANT_ERROR,
    LAST_EVENT,
    LOW,
    NEW_RATE,
    RATE,
    ROUNDING,
    SAMPLE_POINTS,
    STAGE_TIME,
    STATE,
    TIME,
    TRIAL_END,
    TRIAL_SIZE,
    WITHIN,
    Bracket,
    Status,
    decide,
    derivative,
    fail,
    prepare,
    put_state_within,
    retry,
)

CROSSED = (
    1.0  # value of `event_crossed`: the step, or the next, ends right behind an event
)
EXACT = 5e-4  # error of the interpolant from whose state a run goes on; of samples it is below 1
NEGLIGIBLE = 0.1  # effect of an event that is passed, in tolerances
MOST_PASSED = 32  # events in one step
RESOLVED = 1e-12  # distance from an event at which a step ends, as a share of it
WIDTH = 0.1 * RESOLVED  # final width of the bracket
STOP_WIDTH = 1e-14  # of the bracket at which a run stops
MOST_TRIALS = 45  # halvings that reach WIDTH, and one more
MOST_EVENTS = 1000  # in a row, each soon after the other
# "soon", as a share of the run: if a state moves by its tolerance meanwhile, and otherwise
SHORT_MOVING, SHORT_RESTING = 1e-7, 5e-6


def locate_events(solver):
    """Locate the first event of a step; end the step there unless the rest stays as it is."""
    lane = solver.lane
    points_around = check_events(solver)
    if solver.integers[EVENT_INDEX, 0] < 0:
        return
    size = lane[TRIAL_SIZE, 0]
    run = solver.times[-1] - solver.times[0]
    is_soon = lane[TRIAL_END, 0] - lane[LAST_EVENT, 0] < SHORT_RESTING * run
    bracket = narrow(solver, points_around, WIDTH)
    if solver.shape.guarded > 0:
        if stops_run(solver, points_around.low, bracket):
            return
    elif not is_soon and (pass_events(solver, bracket) or lane[ACCEPTED, 0] < 0.5):
        return
    # 1. the shortest step ends behind the event all the same
    lane[EVENT_CROSSED, 0] = CROSSED
    shortest = shortest_step(solver)
    share = max(bracket.high, shortest / size)
    if share >= 1.0:
        return
    # 2. end the step if its interpolant is exact there
    middle = 4.0 * share * (1.0 - share)  # 1 in the middle of the step, 0 at its ends
    error = lane[INTERPOLANT_ERROR, 0] * middle * middle
    if solver.shape.dense_stages > 0 and error < EXACT:
        end_step(solver, share)
        return
    # 3. or try it again, up to there
    resolution = max(RESOLVED * size, 4.0 * TIME_ROUNDING * abs(lane[TRIAL_END, 0]))
    if size > 2.0 * shortest and (1.0 - bracket.low) * size > resolution:
        retry(solver, 0, share * size)


def end_step(solver, share):
    """End the step at a share of it, with the state of its interpolant."""
    lane, states = solver.lane, solver.states
    put_state_within(solver, share)
    lane[TRIAL_END, 0] = lane[STAGE_TIME, 0]
    for i in range(solver.shape.states):
        states[ARGUMENT, i, 0] = states[WITHIN, i, 0]
    derivative(solver, lane[STAGE_TIME], ARGUMENT, END_RATE)
    decide(solver, lane[STAGE_TIME], ARGUMENT, SAMPLE_POINTS)


# --- events that change nothing -------------------------------------------------------------------


def pass_events(solver, bracket):
    """Pass events that do not change the rates; return whether the step holds up to its end.

    The step is halved if it may hide another event behind one of them.
    """
    lane = solver.lane
    for j in range(solver.shape.decisions):
        solver.points[BEFORE, DECISION, j] = solver.memory.P[
            solver.shape.first_decision + j
        ]
    for _ in range(MOST_PASSED):
        if rates_change(solver, bracket.high):
            break
        evaluate_points(solver)
        points_around = find_crossing(solver, bracket.high)
        if solver.integers[EVENT_INDEX, 0] < 0:
            if lane[ACCEPTED, 0] > 0.5:
                derivative(solver, lane[TRIAL_END], ARGUMENT, END_RATE)
                lane[LAST_EVENT, 0] = lane[TRIAL_END, 0]
                return True
            break
        # two events may be close to each other
        bracket = narrow(solver, points_around, WIDTH)
    exchange_decisions(solver, BEFORE)
    return False


def rates_change(solver, share):
    """Return whether rates change behind a share with the decisions there; otherwise hold them."""
    lane = solver.lane
    decide_within(solver, share)
    for point in range(SAMPLE_POINTS, -1, -1):
        within = SHARES[point] if point > 0 else share
        if within >= share:
            put_state_within(solver, within)
            if rates_differ(solver, lane[STAGE_TIME], WITHIN):
                return True
    exchange_decisions(solver, BEHIND)
    return False


def rates_differ(solver, times, row):
    """Return whether rates at a row of states change with the decisions right behind an event.

    A change below `NEGLIGIBLE` tolerances over the step is none.
    """
    derivative(solver, times, row, HELD_RATE)
    exchange_decisions(solver, BEHIND)
    derivative(solver, times, row, NEW_RATE)
    exchange_decisions(solver, BEHIND)
    states = solver.states
    relative, absolute = solver.tolerances[0], solver.tolerances[1]
    for i in range(solver.shape.states):
        difference = abs(states[NEW_RATE, i, 0] - states[HELD_RATE, i, 0])
        tolerance = absolute + relative * abs(states[STATE, i, 0])
        if not solver.lane[TRIAL_SIZE, 0] * difference <= NEGLIGIBLE * tolerance:
            return True
    return False


def exchange_decisions(solver, point):
    """Exchange the decisions that are held in P with those of a sample point."""
    P, points = solver.memory.P, solver.points
    first = solver.shape.first_decision
    for j in range(solver.shape.decisions):
        held = P[first + j]
        P[first + j] = points[point, DECISION, j]
        points[point, DECISION, j] = held
    prepare(solver, solver.lane[TIME])


def stops_run(solver, low, bracket):
    """Stop the run if the event in the bracket is a guard; return whether it is.

    The run stops at the guard's edge, which lies between `low` and the bracket, or before `low` if
    the edge is passed there by rounding; at the step's beginning if no point is inside.
    """
    lane, points = solver.lane, solver.points
    high = bracket.high
    decide_within(solver, high)
    # guards are the last events: a switching condition in the same bracket comes first
    guard = first_crossed(points, BEHIND)
    if guard < solver.shape.decisions:
        return False
    distance_high = points[BEHIND, DISTANCE, guard]
    share = low
    for trial in range(MOST_TRIALS):
        decide_within(solver, share)
        low = share
        distance_low = points[BEHIND, DISTANCE, guard]
        if distance_low > 0.0:
            break
        share = 0.5 * (share if trial > 0 else high)
    if distance_low > 0.0:
        points[SAMPLE_POINTS, ROUNDING, guard] = 0.0
        bracket = Bracket(low, high, distance_low, distance_high)
        bracket = narrow(solver, bracket, STOP_WIDTH)
        low, high = bracket.low, bracket.high
    else:
        high = 0.0
    lane[LOW, 0], lane[HIGH, 0] = low, high
    end = lane[TIME, 0] + high * lane[TRIAL_SIZE, 0]
    write_samples_until(solver, 0, end)
    solver.integers[EVENT_INDEX, 0] = guard
    fail(solver, 0, Status.GUARD_LEFT)
    lane[ACCEPTED, 0] = 0.0
    return True


def decide_within(solver, share):
    """Evaluate the events at a share of the step into BEHIND; guards keep the edges of the step."""
    put_state_within(solver, share)
    decide(solver, solver.lane[STAGE_TIME], WITHIN, BEHIND)
    points = solver.points
    for guard in range(solver.shape.decisions, points.shape[2]):
        points[BEHIND, ROUNDING, guard] = points[SAMPLE_POINTS, ROUNDING, guard]


# --- the bracket ----------------------------------------------------------------------------------


def narrow(solver, bracket, width):
    """Return the bracket narrowed to a width; the event stays between `low` and `high`."""
    low, high, distance_low, distance_high = bracket
    for trial in range(MOST_TRIALS):
        if high - low <= width:
            break
        share = next_share(
            Bracket(low, high, distance_low, distance_high), width, trial
        )
        decide_within(solver, share)
        distance = least_distance(solver.points, BEHIND)
        if distance < 0.0:
            high, distance_high = share, distance
        else:
            low, distance_low = share, distance
    return Bracket(low, high, distance_low, distance_high)


def next_share(bracket, width, trial):
    """Return the share at which the bracket is divided: the ITP rule.

    It takes at most one trial more than halving does.

    Source: Oliveira, Takahashi, An enhancement of the bisection method average performance
    preserving minmax optimality, ACM Trans. Math. Softw. 47(1), 2021.
    """
    low, high, distance_low, distance_high = bracket
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
    if lane[ACCEPTED, 0] < 0.5:
        return
    crossed = lane[EVENT_CROSSED, 0] == CROSSED
    if crossed and decisions_differ(solver, SAMPLE_POINTS):
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
    elif not crossed and is_undecided(solver):
        fail(solver, 0, Status.UNDECIDED)
    lane[EVENT_CROSSED, 0] = 0.0


def is_undecided(solver):
    """Return whether rates would be others if decisions about NaN, which are no, were yes."""
    for j in range(solver.shape.decisions):
        held = solver.memory.P[solver.shape.first_decision + j]
        solver.points[BEHIND, DECISION, j] = held
        if held != held:
            solver.points[BEHIND, DECISION, j] = 1.0
            solver.integers[EVENT_INDEX, 0] = j
    differ = decisions_differ(solver, BEHIND)
    return differ and rates_differ(solver, solver.lane[TIME], STATE)
