"""Jumps of the rates that no decision announces, as in functions that Python runs.

The error of a step is estimated from a few rates, and a step across a jump may look exact.  So the
rates are compared with the slope of the interpolant at places between the stages, and at samples:

    defect = h |f(t, X(t)) - X'(t)|, in tolerances

Where a defect is large, each interval between two places is divided into quarters.  Smooth rates
change in the quarters nearly alike; a quarter in which they change otherwise, however narrow, has a
jump.  The step is then tried again up to the jump, and integration begins anew behind it.
Arguments are those of `numbering`; a diagram that runs in Python has one lane.
"""

import math

from . import solver_layout as row
from .solver_layout import call, slope_within, state_within, try_again

PLACES = (0.18, 0.46, 0.75, 0.93)  # shares of the step, between the stages of DOP853
LARGE = 50.0  # tolerances: the defect of nineteen smooth steps in twenty is smaller
UNUSUAL = 6.0  # of the mean of the steps before: where stability limits them it may be hundreds
KINKED = 2.0  # times as large: the step is halved, also where rates do not jump
SUDDEN = 0.3  # share of the odd change that is left in a quarter of the interval if rates jump
QUARTERINGS, HALVINGS = 4, 44  # to find where they jump
CLOSE = 1e-13  # how near to a jump a step ends, as a share of it
MOST_JUMPS, NEAR = 1000, 1e-7  # one after the other, each within that share of the run
# rows of Z, of stages that are no longer needed: rates at the ends of an interval, and in it
LOWER, UPPER, WITHIN = row.RATE + 1, row.RATE + 5, row.RATE + 6


def put_rates(share, to, code, n, tolerances, numbers, arrays):
    """Put h f, in tolerances, at a share of the step into a row; return the largest defect."""
    Z, P, T, W, _ = arrays
    largest, h = 0.0, numbers[row.TAKEN, 0]
    state_within(n, 1, 0, numbers, Z, share)
    call(code[row.DERIVATIVE], numbers[row.AT], Z, row.LOOKED * n, P, T, W, Z, row.FREE * n)
    for i in range(n):
        size = tolerances[1] + tolerances[0] * max(abs(Z[i]), abs(Z[row.LOOKED * n + i]))
        Z[to * n + i] = h * Z[row.FREE * n + i] / size
        largest = max(largest, abs(Z[to * n + i] - slope_within(Z, n, i, share) / size))
    return largest


def copy_row(n, a, b, Z):
    """Copy the row a of Z to the row b."""
    for i in range(n):
        Z[b * n + i] = Z[a * n + i]


def odd_quarter(n, Z):
    """Return the quarter in which rates change otherwise than in the others, and by how much."""
    odd, most = 0, -1.0
    for k in range(4):
        largest = 0.0
        for i in range(n):
            whole = Z[UPPER * n + i] - Z[LOWER * n + i]
            own = Z[(LOWER + k + 1) * n + i] - Z[(LOWER + k) * n + i]
            largest = max(largest, abs(4.0 * own - whole) / 3.0)
        if largest > most:
            odd, most = k, largest
    return odd, most


def quarter(low, high, code, n, tolerances, numbers, arrays):
    """Return the ends of the odd quarter of an interval, and its odd change."""
    Z, width = arrays[0], 0.25 * (high - low)
    for k in range(1, 4):
        put_rates(low + k * width, LOWER + k, code, n, tolerances, numbers, arrays)
    k, odd = odd_quarter(n, Z)
    copy_row(n, LOWER + k + 1, WITHIN, Z)
    copy_row(n, LOWER + k, LOWER, Z)
    copy_row(n, WITHIN, UPPER, Z)
    return low + k * width, low + (k + 1) * width, odd


def halve(low, high, code, n, tolerances, numbers, arrays):
    """Return the ends of the half of an interval in which rates change more."""
    Z, below, above = arrays[0], 0.0, 0.0
    put_rates(0.5 * (low + high), WITHIN, code, n, tolerances, numbers, arrays)
    for i in range(n):
        below = max(below, abs(Z[WITHIN * n + i] - Z[LOWER * n + i]))
        above = max(above, abs(Z[UPPER * n + i] - Z[WITHIN * n + i]))
    if below >= above:
        copy_row(n, WITHIN, UPPER, Z)
        return low, 0.5 * (low + high)
    copy_row(n, WITHIN, LOWER, Z)
    return 0.5 * (low + high), high


def next_place(place, done, shape, times, numbers):
    """Return the next share of the step to look at, and the counts of places and samples so far."""
    t, h = numbers[row.TIME, 0], numbers[row.TAKEN, 0]
    following = PLACES[place] if place < len(PLACES) else 1.0
    if shape[7] > 1 and done < len(times) and times[done] < t + following * h:
        return (times[done] - t) / h, place, done + 1
    return following, place + 1, done


def locate_jump(code, shape, tolerances, times, results, lane, arrays):
    """Try a step again up to the first jump of the rates within it."""
    n, counts, (numbers, whole, _) = shape[1], results[3], lane
    if whole[row.BURST, 0] > MOST_JUMPS:  # crossed to and fro, in steps as small as need be
        return
    t, h, m = numbers[row.TIME, 0], numbers[row.TAKEN, 0], whole[row.MEMBER, 0]
    # Step 1: is any defect large?
    limit = max(LARGE, UNUSUAL * numbers[row.USUAL, 0])
    largest, share, place, done = 0.0, 0.0, 0, whole[row.DONE, 0]
    while share < 1.0 and largest <= KINKED * limit:
        share, place, done = next_place(place, done, shape, times, numbers)
        if share < 1.0:
            counts[m, row.EVALUATIONS] += 1
            defect = put_rates(share, WITHIN, code, n, tolerances, numbers, arrays)
            largest = max(largest, defect)
    usual = numbers[row.USUAL, 0]
    smooth = usual + 0.25 * (min(largest, LARGE + 1.5 * usual) - usual)  # if rates do not jump
    if largest <= limit:
        numbers[row.USUAL, 0] = smooth
        return
    # Step 2: between which two places do rates jump?
    put_rates(0.0, LOWER, code, n, tolerances, numbers, arrays)
    share, place, done, low, high, found = 0.0, 0, whole[row.DONE, 0], 0.0, 0.0, False
    while share < 1.0 and not found:
        low = share
        share, place, done = next_place(place, done, shape, times, numbers)
        put_rates(share, UPPER, code, n, tolerances, numbers, arrays)
        counts[m, row.EVALUATIONS] += 8
        low, high, odd = quarter(low, share, code, n, tolerances, numbers, arrays)
        low, high, left = quarter(low, high, code, n, tolerances, numbers, arrays)
        if left > max(limit, SUDDEN * odd):  # the next one tells a jump from a kink
            counts[m, row.EVALUATIONS] += 3
            low, high, left = quarter(low, high, code, n, tolerances, numbers, arrays)
            found = left > max(limit, SUDDEN * odd)
        if not found:
            put_rates(share, LOWER, code, n, tolerances, numbers, arrays)
    if not found:
        numbers[row.USUAL, 0] = smooth
        if largest > KINKED * limit and numbers[row.GOOD, 0] > 0.5:
            try_again(0, 0.5 * h, counts, lane)
        return
    # Step 3: where do they jump?
    closest = max(CLOSE, 4e-16 * abs(numbers[row.NEW, 0]) / h)
    for _ in range(QUARTERINGS):
        low, high, left = quarter(low, high, code, n, tolerances, numbers, arrays)
    for _ in range(HALVINGS):
        if high - low > closest:
            low, high = halve(low, high, code, n, tolerances, numbers, arrays)
    counts[m, row.EVALUATIONS] += 3 * QUARTERINGS + HALVINGS
    # Step 4: end the step there
    numbers[row.JUMP_TIME, 0] = t + high * h
    at_start = low * h <= 1e-14 * abs(t)
    if at_start and t + high * h >= numbers[row.END, 0]:
        return
    if numbers[row.GOOD, 0] > 0.5:
        try_again(0, h, counts, lane)
    numbers[row.STEP, 0] = h if at_start else low * h
    if at_start:
        pass_jump(times, lane)


def pass_jump(times, lane):
    """Begin anew behind a jump of the rates, once a step ends right before it."""
    numbers, whole, queue = lane
    ahead = numbers[row.JUMP_TIME, 0] - numbers[row.TIME, 0]
    if 0.0 < ahead <= 1e-8 * numbers[row.TAKEN, 0] + 4e-15 * abs(numbers[row.TIME, 0]):
        passed = numbers[row.JUMP_TIME, 0] - numbers[row.LAST, 0]
        near = passed < NEAR * (times[-1] - times[0])
        whole[row.BURST, 0] = whole[row.BURST, 0] + 1 if near else 0
        numbers[row.TIME, 0] = numbers[row.LAST, 0] = numbers[row.JUMP_TIME, 0]
        numbers[row.FRESH, 0], queue[2] = 1.0, row.ANEW
    numbers[row.JUMP_TIME, 0] = -math.inf
