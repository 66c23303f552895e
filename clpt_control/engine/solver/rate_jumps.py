"""Jumps of the rates that no decision announces, as in functions that Python runs.

The error of a step is estimated from a few rates, and a step across a jump may look exact.  So the
rates are compared with the slope of the interpolant at points between the stages, and at samples:

    defect = h |f(t, X(t)) - X'(t)|, in tolerances

Where a defect is large, each interval between two points is divided into quarters.  Smooth rates
change nearly equally in the quarters; a quarter in which they change differently, however narrow,
has a jump.  The step is then tried again up to the jump, and integration begins anew behind it.
A diagram that runs in Python has one lane.
"""

import math

from .solver_layout import (
    ACCEPTED,
    ANEW,
    BEGINNING,
    BURST,
    EVALUATIONS,
    FRESH,
    JUMP_TIME,
    LAST_EVENT,
    NEW_RATE,
    RATE,
    RUN_INDEX,
    SAMPLES_DONE,
    SEGMENT_END,
    STAGE_TIME,
    STATE,
    STEP_SIZE,
    TERMS,
    TIME,
    TRIAL_END,
    TRIAL_SIZE,
    USUAL_DEFECT,
    WITHIN,
    derivative,
    put_state_within,
    retry,
)

CHECKED_SHARES = (
    0.18,
    0.46,
    0.75,
    0.93,
)  # shares of the step, between the stages of DOP853
LARGE = 50.0  # tolerances: the defect of nineteen smooth steps in twenty is smaller
UNUSUAL = 6.0  # of the mean of the steps before: where stability limits them it may be hundreds
KINKED = 2.0  # times as large: the step is halved, also where rates do not jump
SUDDEN = 0.3  # share of the odd change that remains in a quarter of the interval if rates jump
QUARTERINGS, HALVINGS = 4, 44  # to find where they jump
CLOSE = 1e-13  # distance from a jump at which a step ends, as a share of it
MOST_JUMPS, NEAR = 1000, 1e-7  # one after the other, each within that share of the run
# rows of stages that are no longer needed: rates at the ends of an interval, and in it
LOWER, UPPER, MIDDLE = RATE + 1, RATE + 5, RATE + 6


def locate_jump(solver):
    """Try a step again up to the first jump of the rates within it."""
    lane, integers = solver.lane, solver.integers
    if integers[BURST, 0] > MOST_JUMPS:
        # crossed to and fro, in steps as small as need be
        return
    # Step 1: is any defect large?
    usual = lane[USUAL_DEFECT, 0]
    limit = max(LARGE, UNUSUAL * usual)
    defect = largest_defect(solver, KINKED * limit)
    # if rates do not jump
    smooth = usual + 0.25 * (min(defect, LARGE + 1.5 * usual) - usual)
    if defect <= limit:
        lane[USUAL_DEFECT, 0] = smooth
        return
    # Step 2: between which two points do rates jump?
    found, low, high = find_jump(solver, limit)
    size = lane[TRIAL_SIZE, 0]
    if not found:
        lane[USUAL_DEFECT, 0] = smooth
        if defect > KINKED * limit and lane[ACCEPTED, 0] > 0.5:
            retry(solver, 0, 0.5 * size)
        return
    # Step 3: where do they jump?
    low, high = narrow_jump(solver, low, high)
    # Step 4: end the step there
    time = lane[TIME, 0]
    lane[JUMP_TIME, 0] = time + high * size
    at_start = low * size <= 1e-14 * abs(time)
    if at_start and time + high * size >= lane[SEGMENT_END, 0]:
        return
    if lane[ACCEPTED, 0] > 0.5:
        retry(solver, 0, size)
    lane[STEP_SIZE, 0] = size if at_start else low * size
    if at_start:
        pass_jump(solver)


def largest_defect(solver, enough):
    """Return the largest defect at points and samples of the step; stop where it is enough."""
    integers = solver.integers
    largest, share, point, done = 0.0, 0.0, 0, integers[SAMPLES_DONE, 0]
    while share < 1.0 and largest <= enough:
        share, point, done = next_point(solver, point, done)
        if share < 1.0:
            count_evaluations(solver, 1)
            largest = max(largest, put_rates(solver, share, MIDDLE))
    return largest


def find_jump(solver, limit):
    """Return whether rates jump within the step, and the ends of a short interval around it."""
    integers = solver.integers
    put_rates(solver, 0.0, LOWER)
    share, point, done = 0.0, 0, integers[SAMPLES_DONE, 0]
    while share < 1.0:
        low = share
        share, point, done = next_point(solver, point, done)
        put_rates(solver, share, UPPER)
        count_evaluations(solver, 8)
        low, high, odd_change = quarter(solver, low, share)
        low, high, remaining = quarter(solver, low, high)
        if remaining > max(limit, SUDDEN * odd_change):
            # the next one tells a jump from a kink
            count_evaluations(solver, 3)
            low, high, remaining = quarter(solver, low, high)
            if remaining > max(limit, SUDDEN * odd_change):
                return True, low, high
        put_rates(solver, share, LOWER)
    return False, 0.0, 0.0


def narrow_jump(solver, low, high):
    """Return the ends of the smallest interval around a jump."""
    lane = solver.lane
    closest = max(CLOSE, 4e-16 * abs(lane[TRIAL_END, 0]) / lane[TRIAL_SIZE, 0])
    for _ in range(QUARTERINGS):
        low, high, _ = quarter(solver, low, high)
    for _ in range(HALVINGS):
        if high - low > closest:
            low, high = halve(solver, low, high)
    count_evaluations(solver, 3 * QUARTERINGS + HALVINGS)
    return low, high


def pass_jump(solver):
    """Begin anew behind a jump of the rates, once a step ends right before it."""
    lane, integers = solver.lane, solver.integers
    ahead = lane[JUMP_TIME, 0] - lane[TIME, 0]
    if 0.0 < ahead <= 1e-8 * lane[TRIAL_SIZE, 0] + 4e-15 * abs(lane[TIME, 0]):
        since_last = lane[JUMP_TIME, 0] - lane[LAST_EVENT, 0]
        is_near = since_last < NEAR * (solver.times[-1] - solver.times[0])
        integers[BURST, 0] = integers[BURST, 0] + 1 if is_near else 0
        lane[LAST_EVENT, 0] = lane[JUMP_TIME, 0]
        lane[TIME, 0] = lane[JUMP_TIME, 0]
        for i in range(solver.shape.states):  # the state passes the jump, too
            solver.states[STATE, i, 0] += ahead * solver.states[RATE, i, 0]
        lane[FRESH, 0] = 1.0
        solver.queue[BEGINNING] = ANEW
    lane[JUMP_TIME, 0] = -math.inf


# --- rates within the step ------------------------------------------------------------------------


def count_evaluations(solver, count):
    """Add evaluations to the counts of the run."""
    integers = solver.integers
    solver.results.counts[integers[RUN_INDEX, 0], EVALUATIONS] += count


def next_point(solver, point, done):
    """Return the next share of the step to check, and the counts of points and samples so far."""
    lane = solver.lane
    share = CHECKED_SHARES[point] if point < len(CHECKED_SHARES) else 1.0
    time, size, times = lane[TIME, 0], lane[TRIAL_SIZE, 0], solver.times
    at_samples = solver.shape.unannounced > 1
    if at_samples and done < len(times) and times[done] < time + share * size:
        return (times[done] - time) / size, point, done + 1
    return share, point + 1, done


def put_rates(solver, share, to_row):
    """Put h f, in tolerances, at a share of the step into a row; return the largest defect."""
    lane = solver.lane
    states = solver.states
    largest = 0.0
    put_state_within(solver, share)
    derivative(solver, lane[STAGE_TIME], WITHIN, NEW_RATE)
    for i in range(solver.shape.states):
        size = max(abs(states[STATE, i, 0]), abs(states[WITHIN, i, 0]))
        tolerance = solver.tolerances[1] + solver.tolerances[0] * size
        change = lane[TRIAL_SIZE, 0] * states[NEW_RATE, i, 0] / tolerance
        states[to_row, i, 0] = change
        largest = max(largest, abs(change - slope_within(states, i, share) / tolerance))
    return largest


def slope_within(states, i, share):
    """Return the derivative of `interpolate` in the share, of state i."""
    y, slope = 0.0, 0.0
    for r in range(7):
        y += states[TERMS + 6 - r, i, 0]
        slope = slope * (share if r % 2 == 0 else 1.0 - share) + (
            y if r % 2 == 0 else -y
        )
        y *= share if r % 2 == 0 else 1.0 - share
    return slope


def copy_row(states, source, target):
    """Copy a row of states to another."""
    for i in range(states.shape[1]):
        states[target, i, 0] = states[source, i, 0]


def quarter(solver, low, high):
    """Return the ends of the odd quarter of an interval, and its odd change."""
    width = 0.25 * (high - low)
    for k in range(1, 4):
        put_rates(solver, low + k * width, LOWER + k)
    k, odd_change = odd_quarter(solver.states)
    copy_row(solver.states, LOWER + k + 1, MIDDLE)
    copy_row(solver.states, LOWER + k, LOWER)
    copy_row(solver.states, MIDDLE, UPPER)
    return low + k * width, low + (k + 1) * width, odd_change


def odd_quarter(states):
    """Return the quarter in which rates change differently from the others, and by how much."""
    odd, largest = 0, -1.0
    for k in range(4):
        deviation = 0.0
        for i in range(states.shape[1]):
            total = states[UPPER, i, 0] - states[LOWER, i, 0]
            change = states[LOWER + k + 1, i, 0] - states[LOWER + k, i, 0]
            deviation = max(deviation, abs(4.0 * change - total) / 3.0)
        if deviation > largest:
            odd, largest = k, deviation
    return odd, largest


def halve(solver, low, high):
    """Return the ends of the half of an interval in which rates change more."""
    states, below, above = solver.states, 0.0, 0.0
    middle = 0.5 * (low + high)
    put_rates(solver, middle, MIDDLE)
    for i in range(solver.shape.states):
        below = max(below, abs(states[MIDDLE, i, 0] - states[LOWER, i, 0]))
        above = max(above, abs(states[UPPER, i, 0] - states[MIDDLE, i, 0]))
    if below >= above:
        copy_row(states, MIDDLE, UPPER)
        return low, middle
    copy_row(states, MIDDLE, LOWER)
    return middle, high
