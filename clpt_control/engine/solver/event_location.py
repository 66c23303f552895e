"""Where a step crosses a kink, and whether states feel it.

A step that crosses a kink which states feel is tried again up to it, and integration begins anew
behind it.  Arguments are those of `numbering`.
"""

import math

from . import solver_layout as row
from .event_checks import BLURRED, SHARES, SHORTEST, first_passed, may_hide
from .solver_layout import BEFORE, BEHIND, GLANCES, call, fail, state_within, try_again

CROSSED = 1.0  # a step ends behind a kink
RESOLVED = 1e-12  # how close to a kink a step ends, as a share of it, if time tells that apart
MOST_TRIALS = 45  # to find a kink so closely by halving, and one more
CLOSE = 1e-5  # how far behind a kink its effect is measured, as a share of the step
PASSAGES = 32  # that a step may have, one after the other, without being felt
FELT = 0.1  # effect up to which a step crosses a kink as it is
MOST_KINKS, NEAR = 1000, 1e-7  # one after the other, each within that share of the run
UNFELT = 5e-6  # or within this share, if states hardly move from one to the next


def to_turn(k, lanes, decided, look, D):
    """Return the least distance of a lane's decisions from their turns; negative behind one."""
    least = math.inf
    for j in range(decided):
        at = (3 * look * decided + decided + j) * lanes + k
        side = D[(3 * BEFORE * decided + j) * lanes + k]
        least = min(least, side * D[at] + D[at + decided * lanes])
    return least


def bracket(felt, last, shape, lane, D):
    """Put the next kink of steps between LOW and HIGH; return whether there is one.

    It is behind a look, the first one or `BEHIND` the kink before, and before the first look at
    which decisions are others.  Only lanes are asked that feel a kink, or only those that do not.
    """
    lanes, decided, some, (numbers, whole, _) = shape[0], shape[6], False, lane
    for k in range(lanes):
        if whole[row.WHICH, k] < 0 or (numbers[row.EFFECT, k] > FELT) != felt:
            continue
        for j in range(decided):
            at = (3 * last * decided + decided + j) * lanes + k
            passed = last == BEHIND and D[at] < -D[at + decided * lanes]
            D[(3 * BEFORE * decided + j) * lanes + k] = -1.0 if passed else 1.0
        low, look = numbers[row.HIGH, k] if last == BEHIND else 0.0, 1
        here, ahead = to_turn(k, lanes, decided, last, D), 0.0
        while look <= GLANCES and ahead >= 0.0:
            if SHARES[look] > low:
                ahead = to_turn(k, lanes, decided, look, D)
                if ahead >= 0.0:
                    low, here = SHARES[look], ahead
            look += 1
        numbers[row.LOW, k], numbers[row.HIGH, k] = low, low if ahead >= 0.0 else SHARES[look - 1]
        numbers[row.AT_LOW, k], numbers[row.AT_HIGH, k] = here, ahead
        some = some or ahead < 0.0
    return some


def tried(k, numbers, width, trial):
    """Return where the kink between LOW and HIGH is looked for next: ITP's rule.

    The bracket is `width` after at most one trial more than by halving.

    Source: Oliveira, Takahashi, An enhancement of the bisection method average performance
    preserving minmax optimality, ACM Trans. Math. Softw. 47(1), 2021.
    """
    a, b = numbers[row.LOW, k], numbers[row.HIGH, k]
    low, high = numbers[row.AT_LOW, k], numbers[row.AT_HIGH, k]
    middle = 0.5 * (a + b)
    free = 0.5 * (width * 2.0 ** (MOST_TRIALS - trial) - (b - a))  # from the middle
    guess = (a * high - b * low) / (high - low)
    guess = guess if a < guess < b else middle
    toward = math.copysign(1.0, middle - guess)
    guess += toward * min((b - a) * (b - a), abs(middle - guess))
    if abs(guess - middle) <= free:
        return guess
    return middle - toward * max(free, 0.0)


def narrow(width, code, shape, numbers, arrays):
    """Narrow what lies between LOW and HIGH to a share of the step: the kink is still between."""
    lanes, n, decided, (Z, P, T, W, D) = shape[0], shape[1], shape[6], arrays
    for trial in range(MOST_TRIALS):
        wide = False
        for k in range(lanes):
            wide = wide or numbers[row.HIGH, k] - numbers[row.LOW, k] > width
            state_within(n, lanes, k, numbers, Z, tried(k, numbers, width, trial))
        if not wide:
            return
        to = 3 * BEHIND * decided * lanes
        call(code[row.DECIDE], numbers[row.AT], Z, row.LOOKED * n * lanes, P, T, W, D, to)
        for k in range(lanes):
            if numbers[row.HIGH, k] - numbers[row.LOW, k] > width:
                share = tried(k, numbers, width, trial)
                distance = to_turn(k, lanes, decided, BEHIND, D)
                if distance < 0.0:
                    numbers[row.HIGH, k], numbers[row.AT_HIGH, k] = share, distance
                else:
                    numbers[row.LOW, k], numbers[row.AT_LOW, k] = share, distance


def locate_kinks(code, shape, tolerances, times, results, lane, arrays):
    """Locate the kinks that steps cross and states feel; a step well beyond one is tried up to it.

    A kink that is not felt is crossed by the step as it is, else rounding might decide where a step
    ends: at a tangent, or where errors are small.  The effect is measured at all looks and right
    behind each kink, one after the other, for one that is not felt may make another one felt.  A
    step is halved where there are too many of these, or a decision may hide behind the first.
    """
    lanes, n, decided = shape[0], shape[1], shape[6]
    shortest = SHORTEST * (times[-1] - times[0])
    counts, (numbers, whole, _), (Z, P, T, W, D) = results[3], lane, arrays
    for k in range(lanes):
        numbers[row.EFFECT, k] = 0.0
    for look in range(GLANCES, 0, -1):
        for k in range(lanes):
            state_within(n, lanes, k, numbers, Z, SHARES[look])
        measure_effect(code, shape, tolerances, lane, look, arrays)
    for passage in range(PASSAGES):
        if not bracket(False, BEHIND if passage > 0 else 0, shape, lane, D):
            break
        narrow(CLOSE, code, shape, numbers, arrays)
        for k in range(lanes):
            state_within(n, lanes, k, numbers, Z, numbers[row.HIGH, k])
        to = 3 * BEHIND * decided * lanes
        call(code[row.DECIDE], numbers[row.AT], Z, row.LOOKED * n * lanes, P, T, W, D, to)
        measure_effect(code, shape, tolerances, lane, BEHIND, arrays)
    if bracket(True, 0, shape, lane, D):
        narrow(0.1 * RESOLVED, code, shape, numbers, arrays)
    for k in range(lanes):
        numbers[row.AT, k] = numbers[row.NEW, k]
        if whole[row.WHICH, k] < 0:
            continue
        h, least = numbers[row.TAKEN, k], 4.0 * BLURRED * abs(numbers[row.NEW, k])
        long, more = h > 2.0 * shortest, numbers[row.LOW, k] < numbers[row.HIGH, k]
        if numbers[row.EFFECT, k] > FELT:
            met = (1.0 - numbers[row.LOW, k]) * h <= max(RESOLVED * h, least)
            if long and not met:
                try_again(k, max(numbers[row.HIGH, k] * h, shortest), counts, lane)
            else:
                numbers[row.KINK, k] = CROSSED
        elif long and (more or may_hide(k, lanes, decided, GLANCES, numbers, D)):
            try_again(k, 0.5 * h, counts, lane)
        elif first_passed(k, lanes, decided, GLANCES, D) >= 0:
            numbers[row.KINK, k] = CROSSED


def measure_effect(code, shape, tolerances, lane, look, arrays):
    """Raise EFFECT to h |f free - f locked|, the error by decisions as they are at a look.

    D holds these decisions.  Lanes are asked that feel no kink yet, have one between LOW and HIGH,
    and have passed a decision at the look.
    """
    lanes, n, _, _, _, decided_at, decided, _ = shape
    (numbers, whole, _), (Z, P, T, W, D), some = lane, arrays, False
    for k in range(lanes):
        asked = whole[row.WHICH, k] >= 0 and numbers[row.EFFECT, k] <= FELT
        asked = asked and numbers[row.LOW, k] < numbers[row.HIGH, k]
        asked = asked and first_passed(k, lanes, decided, look, D) >= 0
        some, numbers[row.ASKED, k] = some or asked, 1.0 if asked else 0.0
    if not some:
        return
    first = (row.LOOKED if look != GLANCES else row.ARGUMENT) * n * lanes
    now, count = 3 * look * decided * lanes, decided * lanes
    call(code[row.DERIVATIVE], numbers[row.AT], Z, first, P, T, W, Z, row.LOCKED * n * lanes)
    exchange(P, decided_at * lanes, D, now, count)
    call(code[row.PREPARE], numbers[row.AT], Z, first, P, T, W, D, 0)
    call(code[row.DERIVATIVE], numbers[row.AT], Z, first, P, T, W, Z, row.FREE * n * lanes)
    exchange(P, decided_at * lanes, D, now, count)
    call(code[row.PREPARE], numbers[row.AT], Z, first, P, T, W, D, 0)
    for k in range(lanes):
        for i in range(n if numbers[row.ASKED, k] > 0.5 else 0):
            x, at = Z[i * lanes + k], i * lanes + k
            apart = abs(Z[row.FREE * n * lanes + at] - Z[row.LOCKED * n * lanes + at])
            effect = numbers[row.TAKEN, k] * apart / (tolerances[1] + tolerances[0] * abs(x))
            effect = effect if effect - effect == 0.0 else math.inf
            numbers[row.EFFECT, k] = max(numbers[row.EFFECT, k], effect)


def exchange(a, first, b, second, count):
    """Exchange `count` numbers of two arrays, each from a place on."""
    for j in range(count):
        a[first + j], b[second + j] = b[second + j], a[first + j]


def decide_anew(shape, tolerances, times, status, lane, Z):
    """Begin anew behind a kink; end a run that crosses kinks again and again without going on."""
    lanes, n = shape[0], shape[1]
    numbers, whole, queue = lane
    for k in range(lanes):
        if numbers[row.KINK, k] == CROSSED and numbers[row.GOOD, k] > 0.5:
            passed, felt = numbers[row.TIME, k] - numbers[row.LAST, k], False
            for i in range(n):  # whether a state moves by its tolerance
                moved = abs(Z[(row.RATE * n + i) * lanes + k]) * passed
                felt = felt or moved > tolerances[1] + tolerances[0] * abs(Z[i * lanes + k])
            near = passed < (NEAR if felt else UNFELT) * (times[-1] - times[0])
            whole[row.BURST, k] = whole[row.BURST, k] + 1 if near else 0
            numbers[row.LAST, k] = numbers[row.TIME, k]
            numbers[row.FRESH, k], queue[2] = 1.0, row.ANEW
            if whole[row.BURST, k] > MOST_KINKS:
                fail(status, whole, k, row.CHATTERS)
        numbers[row.KINK, k] = 0.0
