"""Whether a decision is passed within a step, or may pass and come back unseen.

A decision (`decisions`) is looked at in `GLANCES` places within a step, at states of the step's
interpolant.  A guard is looked at as a decision is, whose distance is the margin.  Arguments are
those of `numbering`.
"""

import math

from . import solver_layout as row
from .solver_layout import GLANCES, call, fail, state_within, try_again

# shares of the step at which these looks lie: quarters, and places between them at which
# nothing periodic looks as it does at the quarters, up to 240 periods a step
SHARES = (0.0, 0.0803, 0.25, 0.3333, 0.5, 0.6575, 0.75, 0.8889, 1.0)
# of the polynomial through the quarters at each place between them: the factors of the quarters
FACTORS = tuple(
    math.prod((SHARES[a] - SHARES[c]) / (SHARES[b] - SHARES[c]) for c in range(0, 9, 2) if c != b)
    for a in range(1, 9, 2)
    for b in range(0, 9, 2)
)
CLEAR = 10.0  # from a turn: a distance, in errors between looks
BLURRED = 1e-15  # of the time: rounding moves what changes in it by so much of its change
SHORTEST = 1e-13  # step up to a kink, of a run: in a shorter one states move by rounding alone


def decide(code, shape, numbers, arrays):
    """Put the decisions of now into P, in lanes that begin."""
    lanes, decided_at, decided, (Z, P, T, W, D) = shape[0], shape[5], shape[6], arrays
    call(code[row.DECIDE], numbers[row.TIME], Z, 0, P, T, W, D, 0)
    for k in range(lanes):
        if numbers[row.FRESH, k] > 0.5:
            for j in range(decided):
                P[(decided_at + j) * lanes + k] = D[j * lanes + k]
    call(code[row.PREPARE], numbers[row.TIME], Z, 0, P, T, W, D, 0)


def is_decided_anew(code, shape, numbers, arrays):
    """Mark lanes as fresh in whose new piece of time decisions are others; return if any are.

    An input may come to a threshold where a piece ends, and stay there: no step passes it.
    """
    lanes, decided_at, decided, (Z, P, T, W, D) = shape[0], shape[5], shape[6], arrays
    some = False
    call(code[row.DECIDE], numbers[row.TIME], Z, 0, P, T, W, D, 0)
    for k in range(lanes):
        if numbers[row.FRESH, k] == row.ENTERED:
            numbers[row.FRESH, k] = 0.0
            for j in range(decided):
                if D[j * lanes + k] != P[(decided_at + j) * lanes + k]:
                    numbers[row.FRESH, k], some = 1.0, True
    return some


def first_passed(k, lanes, decided, look, D):
    """Return the first decision of a lane that has been passed at a look at its step, or -1."""
    for j in range(decided):
        at = (3 * look * decided + decided + j) * lanes + k
        if D[at] < -D[at + decided * lanes]:
            return j
    return -1


def mark_passed(code, function, shape, decided, times, results, lane, arrays):
    """Note which decision each lane's step passes first, and between which looks; return if any.

    States within the step are those of its interpolant.  A step is halved where a decision may hide
    from the looks before that; one of a fixed length is looked at where it ends.  A guard is as a
    decision, whose distance is the margin.
    """
    lanes, n, stages, some = shape[0], shape[1], shape[2], False
    shortest = SHORTEST * (times[-1] - times[0])
    counts, (numbers, whole, _), (Z, P, T, W, D) = results[3], lane, arrays
    fixed = stages <= row.RK4
    for look in range(GLANCES if fixed else 0, GLANCES + 1):
        for k in range(lanes):
            state_within(n, lanes, k, numbers, Z, SHARES[look])
        first, to = row.LOOKED if look < GLANCES else row.ARGUMENT, 3 * look * decided * lanes
        to += lanes if function == row.MARGIN else 0
        call(code[function], numbers[row.AT], Z, first * n * lanes, P, T, W, D, to)
    for k in range(lanes):
        whole[row.WHICH, k], numbers[row.AT, k] = -1, numbers[row.NEW, k]
        if whole[row.MEMBER, k] >= 0 and numbers[row.GOOD, k] > 0.5:
            last = GLANCES - 1 if fixed else 0
            while last < GLANCES and whole[row.WHICH, k] < 0:
                last += 1
                whole[row.WHICH, k] = first_passed(k, lanes, decided, last, D)
            numbers[row.LOW, k] = 0.0 if fixed else SHARES[last - 1]
            numbers[row.HIGH, k] = SHARES[last]
            clear = last if whole[row.WHICH, k] < 0 else last - 1
            long = not fixed and numbers[row.TAKEN, k] > 2.0 * shortest
            if long and may_hide(k, lanes, decided, clear, numbers, D):
                try_again(k, 0.5 * numbers[row.TAKEN, k], counts, lane)
                whole[row.WHICH, k] = -1
            some = some or whole[row.WHICH, k] >= 0
    return some


def watch_guards(code, shape, times, results, lane, arrays):
    """End the run of a lane that leaves a guard within the step; the step is not taken."""
    lanes, status, (numbers, whole, _), D = shape[0], results[1], lane, arrays[4]
    for look in range(GLANCES + 1):
        for k in range(lanes):
            D[(3 * look + 2) * lanes + k] = row.OUTSIDE
    if mark_passed(code, row.MARGIN, shape, 1, times, results, lane, arrays):
        for k in range(lanes):
            if whole[row.WHICH, k] >= 0:
                fail(status, whole, k, row.LEFT)
                numbers[row.GOOD, k] = 0.0


def error_between(d, stride, D):
    """Return by how much the quartic through distances at the quarters of a step is off between.

    They lie at d, and `stride` further for each look.
    """
    error = 0.0
    for m in range(GLANCES // 2):
        apart = D[d + (2 * m + 1) * stride]
        for i in range(GLANCES // 2 + 1):
            apart -= FACTORS[5 * m + i] * D[d + 2 * i * stride]
        error = max(error, abs(apart))
    return error


def may_hide(k, lanes, decided, last, numbers, D):
    """Return whether a decision may pass and come back between looks at a step, up to the last.

    The step is too long to tell unless every distance within it, and the vertex of each parabola
    through three of them, is `CLEAR` times as large as the error between; but for those about a
    passage that is seen.  What rounding of the distances, or of the time, makes is no error.
    """
    stride = 3 * decided * lanes  # from one look to the next
    blurred = BLURRED * abs(numbers[row.NEW, k]) / numbers[row.TAKEN, k]
    for j in range(decided):
        d, nearest = (decided + j) * lanes + k, math.inf
        error, rounding = error_between(d, stride, D), D[(2 * decided + j) * lanes + k]
        for look in range(GLANCES):
            rounding += blurred * abs(D[d + (look + 1) * stride] - D[d + look * stride])
        if error <= rounding:
            continue
        for look in range(1, min(last + 1, GLANCES)):
            a, b, c = D[d + (look - 1) * stride], D[d + look * stride], D[d + (look + 1) * stride]
            if b < 0.0:
                a, b, c = -a, -b, -c
            if (look == 1 or a > 0.0) and (look == last or c > 0.0):
                nearest = min(nearest, b)
            if look < last and b < CLEAR * error + 3.0 * (abs(a - b) + abs(c - b)):
                before, after = SHARES[look] - SHARES[look - 1], SHARES[look + 1] - SHARES[look]
                bend = ((c - b) / after - (b - a) / before) / (before + after)
                slope = (b - a) / before + bend * before
                if bend > 0.0 and -after < 0.5 * slope / bend < before:
                    nearest = min(nearest, b - 0.25 * slope * slope / bend)
        if nearest <= CLEAR * error:
            return True
    return False
