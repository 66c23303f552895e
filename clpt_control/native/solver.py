"""Integrate many runs, exactly to every breakpoint: the order of what happens in a step.

The same text serves one run and several side by side (lanes).  It is printed once as LLVM's text
(`make solver`) and is machine code for every run.  Every lane has its own run, time, step and piece
of time; a lane whose run has ended takes the next.  Nothing is summed across lanes, so a run gives
the same numbers beside any others.

All numbers are computed through `call`, by the diagram's functions and the formulas of `method`.
Arguments that all functions share:

    code      addresses of functions, in the order of the places below
    shape     numbers of lanes, of states and of the method's stages; 1 if guards are watched, 1
              if states jump; first place of decisions in P, and how many numbers they are
    runs      initial states (m, n), parameters (m, nP) and schedule of each run (m,)
    schedule  the first piece of time of each (g,), the places in P that a piece sets; then of
              each piece its end, inf behind the last, the values that it sets (pieces, places),
              and 1 if it goes on with the rates and the step of the piece before
    times     when states are wanted; a run starts at the first
    results   of each run: states at `times`, how it ended, samples done, numbers of
              steps, evaluations, restarts and rejected steps
    lane      of each lane: numbers (rows TIME ...), whole numbers (rows MEMBER ...);
              then the queue: next run, the one behind the last, ANEW or ON if a lane begins a piece
    arrays    Z (states and stages), P, T, W and D, as the functions take them
    linear    of Rodas5P, which takes one run at a time (empty without): df/dx, the factors of
              I/(h g) - df/dx, column by column, and pivots; how many diagonals lie below and above,
              and whether there is `slope`; the place of each state in the matrix; the group of each
              state, then of time, or -1; where the elements of each group begin; of each element
              its row, its column and its place in df/dx

Number i of row r of Z in lane k lies at (r n + i) lanes + k.
"""

import math

# how a run ended; STIFF: an implicit method is to go on from where it is
RUNNING, FINISHED, TOO_SMALL, NOT_FINITE, LEFT, TOO_MANY, CHATTERS, STIFF = range(8)
# rows of Z: the state; rates of stages 0 to 15; the argument of a stage; terms of the interpolant.
# In place of the last rates: a state within the step, and the rates there, with the decisions in
# force (LOCKED) and with those made there (FREE)
STATE, RATE, ARGUMENT, TERMS, ROWS, LOOKED, LOCKED, FREE = 0, 1, 17, 18, 25, 16, 14, 15
# the methods, each known by the number of its stages, the new state among them.  DOP853 has three
# more stages for its interpolant.  The last stage of DOPRI5 is the new state, in the row of its
# rate.  MAP is discrete time, where the rate is the state at the next sample
DOP853, RODAS5P, DOPRI5, RK4, MAP = 12, 9, 7, 4, 1
# rows of Z for Rodas5P: solutions of its stages begin at SOLVED; then the term that is added to a
# rate on the right-hand side, df/dt, and room, two rows
SOLVED, ADDEND, TIME_SLOPE, ROOM = 2, 10, 11, 12
# rows of a lane's numbers
# WEIGHT, of the last rate in the argument of a stage, lies behind AT: `staged` reads both
TIME, STEP, END, FRESH, REJECTED, GOOD, TAKEN, NEW, AT, WEIGHT, FAILING, SIZE, TROUBLE = range(13)
# a step that passes a decision (`decisions`) or leaves a guard: whether it ends behind a kink, the
# shares of the step between which that is, and the time of the last kink
KINK, LOW, HIGH, LAST = range(13, 17)
AT_LOW, AT_HIGH = 17, 18  # there: the least distance of a decision from its turn
EFFECT, ASKED = 19, 20  # of new decisions on the step, in tolerances; whether it is measured
OTHER_STEPS, DIAGONAL = 21, 22  # checked steps since a stiff one; the matrix's diagonal, 1/(h g)
# the time of the next look at a lane, or the tries until then; whether it is now; good and rejected
# steps since the last look
NEXT, TRIES_LEFT, LOOK, GOOD_ONES, BAD_ONES = range(23, 28)
CHECKED = 28  # whether a lane's step is checked for stiffness
# the error of the interpolant; above 1 no sample is taken from it, and the step is tried again, up
# to STOP_AT
WITHIN, STOP_AT = 29, 30
STIFF_STEPS, LONGEST, FIRST_STEP = 31, 32, 33  # a run that begins in a lane keeps these
NUMBERS = 34  # rows of numbers
MEMBER, EDGE, DONE, BURST, WHICH = range(5)  # rows of a lane's whole numbers
STEPS, EVALUATIONS, RESTARTS, REJECTIONS = range(4)  # of the counts
# places of `code`: the diagram's functions, then the method's; stage s stands at STAGE + s
DERIVATIVE, PREPARE, MARGIN, SIGNALS, JUMP, DECIDE, SLOPE, STAGED = range(8)
ATTEMPT, CONTROL, SIZES, TRIAL, FIRST, ACCEPT, DENSE, CUBIC, STIFFNESS = range(8, 17)
STAGE = 16
ANEW, ON = 1, 2  # a piece begins with new rates and a new step, or goes on with those of the last
OUTSIDE = 1e-9  # grid steps beyond the edge that count as outside
GLANCES = 8  # places within a step at which decisions and guards are looked at
# shares of the step at which these lie: quarters, and places between them at which
# nothing periodic looks as it does at the quarters, up to 240 periods a step
SHARES = (0.0, 0.0803, 0.25, 0.3333, 0.5, 0.6575, 0.75, 0.8889, 1.0)
# of the polynomial through the quarters at each place between them: the factors of the quarters
FACTORS = tuple(
    math.prod((SHARES[a] - SHARES[c]) / (SHARES[b] - SHARES[c]) for c in range(0, 9, 2) if c != b)
    for a in range(1, 9, 2)
    for b in range(0, 9, 2)
)
CLEAR = 10.0  # from a turn: a distance, in errors between looks
BEHIND = GLANCES + 1  # the look right behind a kink
BEFORE = BEHIND + 1  # -1 for what has been passed before it, else 1
DECIDED = 3 * BEFORE + 1  # numbers of a decision in D: `decide` at each look
CROSSED = 1.0  # a step ends behind a kink
RESOLVED = 1e-12  # how close to a kink a step ends, as a share of it or of the time
MOST_TRIALS = 45  # to find a kink so closely by halving, and one more
CLOSE = 1e-5  # how far behind a kink its effect is measured, as a share of the step
PASSAGES = 32  # that a step may have, one after the other, without being felt
SHORTEST = 1e-13  # step up to a kink, of a run: in a shorter one states move by rounding alone
FELT = 0.1  # effect up to which a step crosses a kink as it is
MOST_KINKS, NEAR = 1000, 1e-7  # one after the other, each within that share of the run
UNFELT = 5e-6  # or within this share, if states hardly move from one to the next
# steps between checks for stiffness; steps that make a run stiff; steps ahead for it to matter
OFTEN, MANY, AHEAD = 128, 15, 5_000
CHANGE = 6e-6  # for differences of rates, of the size of a state: the third root of a rounding


def call(address, t, X, first, P, T, W, D, to):
    """Call the function at an address on t, X[first:], P, T, W, D[to:], as `make solver` has it."""


def advance(code, shape, tolerances, batch, linear, budget, most):
    """Take at most `budget` steps in every lane; return how many lanes are at work.

    A run that has taken `most` tries ends.  No more steps are taken once a lane looks stiff.
    """
    lanes, n, stages, guarded, jumping, _, decided = shape
    runs, schedule, times, results, lane, arrays = batch
    (_, status, reached, counts), (numbers, whole, queue) = results, lane
    Z, P, T, W, D = arrays
    span, now, at = n * lanes, numbers[TIME], numbers[AT]
    implicit, fixed, dense = stages == RODAS5P, stages <= RK4, stages == DOP853
    fsal = stages == DOPRI5  # its last stage is the first of the next step
    first = RATE + DOP853 + 1 - stages if fsal else RATE  # behind it are the stages' rates
    rates = code[STAGED] if code[STAGED] != 0 else code[DERIVATIVE]
    active = 0
    for k in range(lanes):
        if whole[MEMBER, k] < 0:
            take_run(k, shape, runs, schedule, times, lane, Z, P)
        active += 1 if whole[MEMBER, k] >= 0 else 0
    while active > 0 and budget > 0:
        budget -= 1
        anew = queue[2] == ANEW
        if queue[2] > 0:
            queue[2] = 0
            call(code[PREPARE], now, Z, 0, P, T, W, D, 0)
        if anew:
            if decided > 0:
                decide(code, shape, numbers, arrays)
            if guarded:
                call(code[MARGIN], now, Z, 0, P, T, W, D, 0)
            if not fixed:
                call(code[DERIVATIVE], now, Z, 0, P, T, W, Z, (RATE + 1) * span)
                call(code[SIZES], numbers, Z, 0, P, tolerances, W, D, 0)
                call(code[TRIAL], numbers, Z, 0, P, T, W, D, 0)
                call(code[DERIVATIVE], at, Z, ARGUMENT * span, P, T, W, Z, (RATE + 2) * span)
                call(code[FIRST], numbers, Z, 0, P, tolerances, W, D, 0)
            begin_piece(lanes, stages, times, results, lane, D, guarded)
        call(code[ATTEMPT], numbers, Z, 0, P, T, W, D, 0)
        if fixed:
            call(code[DERIVATIVE], now, Z, 0, P, T, W, Z, RATE * span)
        if implicit:
            linearise(code, n, tolerances, numbers, linear, arrays)
        for s in range(1, stages):
            call(code[STAGE + s], numbers, Z, 0, P, T, W, D, 0)
            call(rates, at, Z, ARGUMENT * span, P, T, W, Z, (first + s) * span)
            if implicit:
                solve_stage(n, s, linear, Z)
        call(code[CONTROL], numbers, Z, 0, P, tolerances, W, D, 0)
        good, within, checked = False, False, False
        looked = anew or implicit or guarded > 0 or decided > 0
        for k in range(lanes):
            good = good or numbers[GOOD, k] > 0.5
            looked = looked or numbers[LOOK, k] > 0.5
        if looked:
            count_steps(shape, counts, lane)
            for k in range(lanes):
                m, done = whole[MEMBER, k], whole[DONE, k]
                numbers[CHECKED, k] = 0.0
                if m >= 0 and numbers[FAILING, k] > 0.5:
                    fail(status, whole, k, int(numbers[FAILING, k]))
                if m >= 0 and numbers[GOOD, k] > 0.5:
                    within = within or guarded > 0
                    if counts[m, STEPS] % OFTEN == 0 or numbers[STIFF_STEPS, k] > 0:
                        numbers[CHECKED, k], checked = 1.0, True
                    if done < len(times) and times[done] < numbers[NEW, k]:
                        within = True
        if good and not (fixed or fsal):
            call(code[DERIVATIVE], at, Z, ARGUMENT * span, P, T, W, Z, (RATE + DOP853) * span)
        if checked and (dense or fsal):
            call(code[STIFFNESS], numbers, Z, 0, P, T, W, D, 0)
        beyond = False
        if decided > 0 and good:
            call(code[CUBIC], numbers, Z, 0, P, T, W, D, 0)
            beyond = mark_passed(code, DECIDE, shape, decided, times, results, lane, arrays)
        if within or beyond:
            if dense:
                for s in range(stages + 1, stages + 4):
                    call(code[STAGE + s], numbers, Z, 0, P, T, W, D, 0)
                    call(code[DERIVATIVE], at, Z, ARGUMENT * span, P, T, W, Z, (RATE + s) * span)
                call(code[STAGE + stages], numbers, Z, 0, P, T, W, D, 0)
            call(code[DENSE], numbers, Z, 0, P, tolerances, W, D, 0)
            if dense:
                check_interpolant(lanes, times, results, lane)
            if beyond and mark_passed(code, DECIDE, shape, decided, times, results, lane, arrays):
                locate_kinks(code, shape, tolerances, times, results, lane, arrays)
            if guarded:
                watch_guards(code, shape, times, results, lane, arrays)
        if looked and good:
            sample(shape, times, results, lane, Z, 3 if within and dense else 0)
        if lanes > 1 or numbers[GOOD, 0] > 0.5:
            call(code[ACCEPT], numbers, Z, 0, P, T, W, D, 0)
        if decided > 0 and good:
            decide_anew(shape, tolerances, times, status, lane, Z)
        if jumping and looked:
            jump(code, shape, schedule, times, results, lane, arrays)
        if looked:
            active = 0
            for k in range(lanes):
                m = whole[MEMBER, k]
                if m < 0:
                    continue
                spare = most - counts[m, STEPS] - counts[m, REJECTIONS]
                if spare <= 0:
                    fail(status, whole, k, TOO_MANY)
                if numbers[GOOD, k] > 0.5 and numbers[TIME, k] == numbers[END, k]:
                    enter_piece(k, lanes, schedule, status, lane, P)
                if status[m] != RUNNING:
                    reached[m], whole[MEMBER, k] = whole[DONE, k], -1
                    take_run(k, shape, runs, schedule, times, lane, Z, P)
                elif numbers[STIFF_STEPS, k] >= MANY:
                    if times[len(times) - 1] - numbers[TIME, k] > AHEAD * numbers[STEP, k]:
                        budget = 0
                    else:
                        numbers[STIFF_STEPS, k] = 0.0
                if whole[MEMBER, k] >= 0:
                    active += 1
                    tries = min(spare, OFTEN - counts[whole[MEMBER, k], STEPS] % OFTEN)
                    numbers[TRIES_LEFT, k] = 1.0 if numbers[STIFF_STEPS, k] > 0 else tries
                    look_ahead(k, times, lane)
    count_steps(shape, counts, lane)
    return active


# --- decisions ------------------------------------------------------------------------------


def decide(code, shape, numbers, arrays):
    """Put the decisions of now into P, in lanes that begin."""
    lanes, decided_at, decided, (Z, P, T, W, D) = shape[0], shape[5], shape[6], arrays
    call(code[DECIDE], numbers[TIME], Z, 0, P, T, W, D, 0)
    for k in range(lanes):
        if numbers[FRESH, k] > 0.5:
            for j in range(decided):
                P[(decided_at + j) * lanes + k] = D[j * lanes + k]
    call(code[PREPARE], numbers[TIME], Z, 0, P, T, W, D, 0)


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
    fixed = stages <= RK4
    for look in range(GLANCES if fixed else 0, GLANCES + 1):
        for k in range(lanes):
            state_within(n, lanes, k, numbers, Z, SHARES[look])
        first, to = LOOKED if look < GLANCES else ARGUMENT, 3 * look * decided * lanes
        to += lanes if function == MARGIN else 0
        call(code[function], numbers[AT], Z, first * n * lanes, P, T, W, D, to)
    for k in range(lanes):
        whole[WHICH, k], numbers[AT, k] = -1, numbers[NEW, k]
        if whole[MEMBER, k] >= 0 and numbers[GOOD, k] > 0.5:
            last = GLANCES - 1 if fixed else 0
            while last < GLANCES and whole[WHICH, k] < 0:
                last += 1
                whole[WHICH, k] = first_passed(k, lanes, decided, last, D)
            numbers[LOW, k] = 0.0 if fixed else SHARES[last - 1]
            numbers[HIGH, k] = SHARES[last]
            clear = last if whole[WHICH, k] < 0 else last - 1
            long = not fixed and numbers[TAKEN, k] > 2.0 * shortest
            if long and may_hide(k, lanes, decided, clear, D):
                try_again(k, 0.5 * numbers[TAKEN, k], counts, lane)
                whole[WHICH, k] = -1
            some = some or whole[WHICH, k] >= 0
    return some


def error_between(d, row, D):
    """Return by how much the quartic through distances at the quarters of a step is off between.

    They lie at d, and `row` further for each look.
    """
    error = 0.0
    for m in range(GLANCES // 2):
        apart = D[d + (2 * m + 1) * row]
        for i in range(GLANCES // 2 + 1):
            apart -= FACTORS[5 * m + i] * D[d + 2 * i * row]
        error = max(error, abs(apart))
    return error


def may_hide(k, lanes, decided, last, D):
    """Return whether a decision may pass and come back between looks at a step, up to the last.

    The step is too long to tell unless every distance within it, and the vertex of each parabola
    through three of them, is `CLEAR` times as large as the error between; but for those about a
    passage that is seen.
    """
    row = 3 * decided * lanes  # from one look to the next
    for j in range(decided):
        d, nearest = (decided + j) * lanes + k, math.inf
        error = error_between(d, row, D)
        for look in range(1, min(last + 1, GLANCES)):
            a, b, c = D[d + (look - 1) * row], D[d + look * row], D[d + (look + 1) * row]
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
        if error > D[d + decided * lanes] and nearest <= CLEAR * error:
            return True
    return False


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
        if whole[WHICH, k] < 0 or (numbers[EFFECT, k] > FELT) != felt:
            continue
        for j in range(decided):
            at = (3 * last * decided + decided + j) * lanes + k
            passed = last == BEHIND and D[at] < -D[at + decided * lanes]
            D[(3 * BEFORE * decided + j) * lanes + k] = -1.0 if passed else 1.0
        low, look = numbers[HIGH, k] if last == BEHIND else 0.0, 1
        here, ahead = to_turn(k, lanes, decided, last, D), 0.0
        while look <= GLANCES and ahead >= 0.0:
            if SHARES[look] > low:
                ahead = to_turn(k, lanes, decided, look, D)
                if ahead >= 0.0:
                    low, here = SHARES[look], ahead
            look += 1
        numbers[LOW, k], numbers[HIGH, k] = low, low if ahead >= 0.0 else SHARES[look - 1]
        numbers[AT_LOW, k], numbers[AT_HIGH, k] = here, ahead
        some = some or ahead < 0.0
    return some


def tried(k, numbers, width, trial):
    """Return where the kink between LOW and HIGH is looked for next: ITP's rule.

    The bracket is `width` after at most one trial more than by halving.

    Source: Oliveira, Takahashi, An enhancement of the bisection method average performance
    preserving minmax optimality, ACM Trans. Math. Softw. 47(1), 2021.
    """
    a, b, low, high = numbers[LOW, k], numbers[HIGH, k], numbers[AT_LOW, k], numbers[AT_HIGH, k]
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
            wide = wide or numbers[HIGH, k] - numbers[LOW, k] > width
            state_within(n, lanes, k, numbers, Z, tried(k, numbers, width, trial))
        if not wide:
            return
        to = 3 * BEHIND * decided * lanes
        call(code[DECIDE], numbers[AT], Z, LOOKED * n * lanes, P, T, W, D, to)
        for k in range(lanes):
            if numbers[HIGH, k] - numbers[LOW, k] > width:
                share = tried(k, numbers, width, trial)
                distance = to_turn(k, lanes, decided, BEHIND, D)
                if distance < 0.0:
                    numbers[HIGH, k], numbers[AT_HIGH, k] = share, distance
                else:
                    numbers[LOW, k], numbers[AT_LOW, k] = share, distance


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
        numbers[EFFECT, k] = 0.0
    for look in range(GLANCES, 0, -1):
        for k in range(lanes):
            state_within(n, lanes, k, numbers, Z, SHARES[look])
        measure_effect(code, shape, tolerances, lane, look, arrays)
    for passage in range(PASSAGES):
        if not bracket(False, BEHIND if passage > 0 else 0, shape, lane, D):
            break
        narrow(CLOSE, code, shape, numbers, arrays)
        for k in range(lanes):
            state_within(n, lanes, k, numbers, Z, numbers[HIGH, k])
        to = 3 * BEHIND * decided * lanes
        call(code[DECIDE], numbers[AT], Z, LOOKED * n * lanes, P, T, W, D, to)
        measure_effect(code, shape, tolerances, lane, BEHIND, arrays)
    if bracket(True, 0, shape, lane, D):
        narrow(0.1 * RESOLVED, code, shape, numbers, arrays)
    for k in range(lanes):
        numbers[AT, k] = numbers[NEW, k]
        if whole[WHICH, k] < 0:
            continue
        h, least = numbers[TAKEN, k], 2.0 * RESOLVED * abs(numbers[NEW, k])
        long, more = h > 2.0 * shortest, numbers[LOW, k] < numbers[HIGH, k]
        if numbers[EFFECT, k] > FELT:
            met = (1.0 - numbers[LOW, k]) * h <= max(RESOLVED * h, least)
            if long and not met:
                try_again(k, max(numbers[HIGH, k] * h, shortest), counts, lane)
            else:
                numbers[KINK, k] = CROSSED
        elif long and (more or may_hide(k, lanes, decided, GLANCES, D)):
            try_again(k, 0.5 * h, counts, lane)
        elif first_passed(k, lanes, decided, GLANCES, D) >= 0:
            numbers[KINK, k] = CROSSED


def measure_effect(code, shape, tolerances, lane, look, arrays):
    """Raise EFFECT to h |f free - f locked|, the error by decisions as they are at a look.

    D holds these decisions.  Lanes are asked that feel no kink yet, have one between LOW and HIGH,
    and have passed a decision at the look.
    """
    lanes, n, _, _, _, decided_at, decided = shape
    (numbers, whole, _), (Z, P, T, W, D), some = lane, arrays, False
    for k in range(lanes):
        asked = whole[WHICH, k] >= 0 and numbers[EFFECT, k] <= FELT
        asked = asked and numbers[LOW, k] < numbers[HIGH, k]
        asked = asked and first_passed(k, lanes, decided, look, D) >= 0
        some, numbers[ASKED, k] = some or asked, 1.0 if asked else 0.0
    if not some:
        return
    first = (LOOKED if look != GLANCES else ARGUMENT) * n * lanes
    now, count = 3 * look * decided * lanes, decided * lanes
    call(code[DERIVATIVE], numbers[AT], Z, first, P, T, W, Z, LOCKED * n * lanes)
    exchange(P, decided_at * lanes, D, now, count)
    call(code[PREPARE], numbers[AT], Z, first, P, T, W, D, 0)
    call(code[DERIVATIVE], numbers[AT], Z, first, P, T, W, Z, FREE * n * lanes)
    exchange(P, decided_at * lanes, D, now, count)
    call(code[PREPARE], numbers[AT], Z, first, P, T, W, D, 0)
    for k in range(lanes):
        for i in range(n if numbers[ASKED, k] > 0.5 else 0):
            x, at = Z[i * lanes + k], i * lanes + k
            apart = abs(Z[FREE * n * lanes + at] - Z[LOCKED * n * lanes + at])
            effect = numbers[TAKEN, k] * apart / (tolerances[1] + tolerances[0] * abs(x))
            effect = effect if effect - effect == 0.0 else math.inf
            numbers[EFFECT, k] = max(numbers[EFFECT, k], effect)


def exchange(a, first, b, second, count):
    """Exchange `count` numbers of two arrays, each from a place on."""
    for j in range(count):
        a[first + j], b[second + j] = b[second + j], a[first + j]


def decide_anew(shape, tolerances, times, status, lane, Z):
    """Begin anew behind a kink; end a run that crosses kinks again and again without going on."""
    lanes, n = shape[0], shape[1]
    numbers, whole, queue = lane
    for k in range(lanes):
        if numbers[KINK, k] == CROSSED and numbers[GOOD, k] > 0.5:
            passed, fastest = numbers[TIME, k] - numbers[LAST, k], 0.0
            for i in range(n):
                fastest = max(fastest, abs(Z[(RATE * n + i) * lanes + k]))
            felt = fastest * passed > tolerances[1]  # else no state moves by its tolerance
            near = passed < (NEAR if felt else UNFELT) * (times[-1] - times[0])
            whole[BURST, k] = whole[BURST, k] + 1 if near else 0
            numbers[LAST, k], numbers[FRESH, k], queue[2] = numbers[TIME, k], 1.0, ANEW
            if whole[BURST, k] > MOST_KINKS:
                fail(status, whole, k, CHATTERS)
        numbers[KINK, k] = 0.0


def count_steps(shape, counts, lane):
    """Add the steps of lanes since the last look to the counts of their runs."""
    lanes, stages, (numbers, whole, _) = shape[0], shape[2], lane
    for k in range(lanes):
        m = whole[MEMBER, k]
        if m >= 0:
            good, bad = int(numbers[GOOD_ONES, k]), int(numbers[BAD_ONES, k])
            counts[m, STEPS] += good
            counts[m, REJECTIONS] += bad
            counts[m, EVALUATIONS] += (stages - 1) * (good + bad)
            counts[m, EVALUATIONS] += 0 if stages == DOPRI5 else good
            numbers[GOOD_ONES, k], numbers[BAD_ONES, k] = 0.0, 0.0
            numbers[TRIES_LEFT, k] -= good + bad


def try_again(k, step, counts, lane):
    """Try a step that was good again, with another length."""
    numbers, whole, _ = lane
    numbers[GOOD, k], numbers[REJECTED, k], numbers[STEP, k] = 0.0, 0.0, step
    counts[whole[MEMBER, k], STEPS] -= 1
    counts[whole[MEMBER, k], REJECTIONS] += 1


def look_ahead(k, times, lane):
    """Note the next sample of a lane, or the end of its piece of time."""
    numbers, whole, _ = lane
    done = whole[DONE, k]
    numbers[NEXT, k] = numbers[END, k]
    if done < len(times):
        numbers[NEXT, k] = min(times[done], numbers[END, k])


def fail(status, whole, k, why):
    """End the run of a lane."""
    m = whole[MEMBER, k]
    if m >= 0 and status[m] == RUNNING:
        status[m] = why


# --- which run a lane works on --------------------------------------------------------------


def take_run(k, shape, runs, schedule, times, lane, Z, P):
    """Begin the next run in a lane; if there is none the lane stays as it is, beside others."""
    lanes, n = shape[0], shape[1]
    (X0, Ps, group), (numbers, whole, queue) = runs, lane
    m, numbers[FRESH, k] = queue[0], 0.0
    if m == queue[1]:
        return
    queue[0], queue[2] = m + 1, ANEW
    whole[MEMBER, k], whole[EDGE, k] = m, schedule[0][group[m]]
    whole[DONE, k], whole[BURST, k] = 1, 0
    for j in range(Ps.shape[1]):
        P[j * lanes + k] = Ps[m, j]
    set_piece(k, lanes, schedule, whole[EDGE, k], P)
    for i in range(n):
        Z[i * lanes + k] = X0[m, i]
    for row in range(STIFF_STEPS):
        numbers[row, k] = 0.0
    numbers[TIME, k], numbers[END, k] = times[0], schedule[2][whole[EDGE, k]]
    numbers[FRESH, k], numbers[LAST, k], numbers[STOP_AT, k] = 1.0, -math.inf, math.inf
    if numbers[STIFF_STEPS, k] > -math.inf:
        numbers[STIFF_STEPS, k] = 0.0


def set_piece(k, lanes, schedule, piece, P):
    """Put into P the values that a piece of time sets."""
    _, places, _, values, _ = schedule
    for j in range(len(places)):
        P[places[j] * lanes + k] = values[piece, j]


def begin_piece(lanes, stages, times, results, lane, D, guarded):
    """Begin a piece of time in the lanes that are fresh; end a run that cannot begin it."""
    (_, status, _, counts), (numbers, whole, _) = results, lane
    for k in range(lanes):
        if numbers[FRESH, k] > 0.5:
            numbers[FRESH, k], numbers[REJECTED, k], numbers[FIRST_STEP, k] = 0.0, 0.0, 0.0
            counts[whole[MEMBER, k], EVALUATIONS] += 0 if stages <= RK4 else 2
            counts[whole[MEMBER, k], RESTARTS] += 0 if stages == MAP else 1
            if numbers[TROUBLE, k] != 0.0:
                fail(status, whole, k, NOT_FINITE)
            if guarded and D[k] < -OUTSIDE:
                fail(status, whole, k, LEFT)
                numbers[END, k] = numbers[TIME, k]
            look_ahead(k, times, lane)


def enter_piece(k, lanes, schedule, status, lane, P):
    """Enter the next piece of time, or end the run."""
    _, _, edges, _, smooth = schedule
    numbers, whole, queue = lane
    m = whole[MEMBER, k]
    whole[EDGE, k] += 1
    piece = whole[EDGE, k]
    if edges[piece] == math.inf:
        if status[m] == RUNNING:
            status[m] = FINISHED
        return
    numbers[END, k] = edges[piece]
    if smooth[piece] == 0:
        numbers[FRESH, k], queue[2] = 1.0, ANEW
    elif queue[2] == 0:
        queue[2] = ON
    set_piece(k, lanes, schedule, piece, P)


def jump(code, shape, schedule, times, results, lane, arrays):
    """Make states jump in lanes that are at the end of a piece; a sample there is after the jump.

    The next piece, which says what jumps, is set in P; behind the last there is one for the end.
    """
    lanes, n = shape[0], shape[1]
    (out, status, _, _), (numbers, whole, _) = results, lane
    Z, P, T, W, D = arrays
    some = False
    for k in range(lanes):
        if at_end(k, status, numbers, whole):
            some = True
            set_piece(k, lanes, schedule, whole[EDGE, k] + 1, P)
    if not some:
        return
    call(code[PREPARE], numbers[TIME], Z, 0, P, T, W, D, 0)
    call(code[JUMP], numbers[TIME], Z, 0, P, T, W, Z, ARGUMENT * n * lanes)
    if shape[3]:
        call(code[MARGIN], numbers[TIME], Z, ARGUMENT * n * lanes, P, T, W, D, 0)
    for k in range(lanes):
        if at_end(k, status, numbers, whole):
            m, done, trouble = whole[MEMBER, k], whole[DONE, k], 0.0
            sampled = done > 0 and times[done - 1] == numbers[TIME, k]
            for i in range(n):
                new = Z[(ARGUMENT * n + i) * lanes + k]
                trouble += 0.0 * new
                Z[i * lanes + k] = new
                if sampled:
                    out[m, done - 1, i] = new
            if trouble != 0.0:
                fail(status, whole, k, NOT_FINITE)
            if shape[3] and D[k] < -OUTSIDE:
                fail(status, whole, k, LEFT)


def at_end(k, status, numbers, whole):
    """Whether the run of a lane is at the end of a piece of time."""
    m = whole[MEMBER, k]
    if m < 0 or status[m] != RUNNING or numbers[GOOD, k] < 0.5:
        return False
    return numbers[TIME, k] == numbers[END, k]


# --- within a step --------------------------------------------------------------------------


def interpolate(Z, n, lanes, k, i, share):
    """Return state i of a lane at a share of the step."""
    y = 0.0
    for r in range(7):
        y += Z[((TERMS + 6 - r) * n + i) * lanes + k]
        y *= share if r % 2 == 0 else 1.0 - share
    return y + Z[i * lanes + k]


def sample(shape, times, results, lane, Z, more):
    """Write the states at times within the step, for which `more` evaluations were made."""
    lanes, n = shape[0], shape[1]
    (out, status, _, counts), (numbers, whole, _) = results, lane
    for k in range(lanes):
        m, done = whole[MEMBER, k], whole[DONE, k]
        if m < 0 or numbers[GOOD, k] < 0.5 or status[m] != RUNNING:
            continue
        counts[m, EVALUATIONS] += more
        t, h, new = numbers[TIME, k], numbers[TAKEN, k], numbers[NEW, k]
        while done < len(times) and times[done] <= new:
            for i in range(n):
                if times[done] == new:
                    out[m, done, i] = Z[(ARGUMENT * n + i) * lanes + k]
                else:
                    out[m, done, i] = interpolate(Z, n, lanes, k, i, (times[done] - t) / h)
            done += 1
            numbers[STOP_AT, k] = math.inf
        whole[DONE, k] = done


def check_interpolant(lanes, times, results, lane):
    """Try a step again, up to its first sample, if its interpolant is not exact enough."""
    counts, (numbers, whole, _) = results[3], lane
    for k in range(lanes):
        m, done = whole[MEMBER, k], whole[DONE, k]
        if m < 0 or numbers[GOOD, k] < 0.5 or done >= len(times) or times[done] >= numbers[NEW, k]:
            continue
        if numbers[WITHIN, k] > 1.0:
            try_again(k, numbers[TAKEN, k], counts, lane)
            numbers[STOP_AT, k] = times[done]
            counts[m, EVALUATIONS] += 3


def state_within(n, lanes, k, numbers, Z, share):
    """Put time and state of a lane at a share of the step into AT and LOOKED."""
    numbers[AT, k] = numbers[TIME, k] + share * numbers[TAKEN, k]
    for i in range(n):
        Z[(LOOKED * n + i) * lanes + k] = interpolate(Z, n, lanes, k, i, share)


def watch_guards(code, shape, times, results, lane, arrays):
    """End the run of a lane that leaves a guard within the step; the step is not taken."""
    lanes, status, (numbers, whole, _), D = shape[0], results[1], lane, arrays[4]
    for look in range(GLANCES + 1):
        for k in range(lanes):
            D[(3 * look + 2) * lanes + k] = OUTSIDE
    if mark_passed(code, MARGIN, shape, 1, times, results, lane, arrays):
        for k in range(lanes):
            if whole[WHICH, k] >= 0:
                fail(status, whole, k, LEFT)
                numbers[GOOD, k] = 0.0


# --- what an implicit method solves ---------------------------------------------------------


def linearise(code, n, tolerances, numbers, linear, arrays):
    """Factor I/(h g) - df/dx for the step to try; after a rejected step df/dx is that of before."""
    slopes, M, pivots, (low, high, _), _, _, _, _, _, _ = linear
    if numbers[REJECTED, 0] < 0.5:
        differentiate(code, n, tolerances, numbers, linear, arrays)
    for j in range(n):
        for i in range(max(0, j - low - high), min(n, j + low + 1)):
            M[j * n + i] = -slopes[j * n + i]
        M[j * n + j] += numbers[DIAGONAL, 0]
    factor(n, low, high, M, pivots)


def differentiate(code, n, tolerances, numbers, linear, arrays):
    """Compute df/dx and df/dt; states whose rates have nothing in common go together."""
    slopes, _, _, (_, _, exact), _, groups, begins, rows, columns, to = linear
    Z, P, T, W, _ = arrays
    for i in range(n):
        Z[ARGUMENT * n + i] = Z[i]
        Z[TIME_SLOPE * n + i] = 0.0
    for group in range(len(begins) - 1):
        known = exact > 0
        if known:
            for j in range(n + 1):
                Z[TERMS * n + j] = 1.0 if groups[j] == group else 0.0
            call(code[SLOPE], numbers[TIME], Z, ARGUMENT * n, P, T, W, Z, ROOM * n)
            for e in range(begins[group], begins[group + 1]):
                known = known and Z[ROOM * n + rows[e]] - Z[ROOM * n + rows[e]] == 0.0
        if not known:
            by_differences(code, n, group, tolerances, numbers, groups, arrays)
        for e in range(begins[group], begins[group + 1]):
            slope = Z[ROOM * n + rows[e]] / Z[TERMS * n + columns[e]]
            slope = slope if slope - slope == 0.0 else 0.0
            if columns[e] == n:
                Z[TIME_SLOPE * n + rows[e]] = slope
            else:
                slopes[to[e]] = slope


def by_differences(code, n, group, tolerances, numbers, groups, arrays):
    """Write a group's changes of states and time into TERMS, and the changes of rates into ROOM."""
    Z, P, T, W, _ = arrays
    least = tolerances[1] / tolerances[0]  # a smaller state is as good as zero
    for j in range(n):
        size = max(abs(Z[j]), least)
        change = 2.0 * CHANGE * (size if size > 0.0 else 1.0)
        Z[TERMS * n + j] = change if groups[j] == group else 0.0
    Z[TERMS * n + n] = 1e-3 * numbers[TAKEN, 0] if groups[n] == group else 0.0
    for side in range(2):
        half = 0.5 - side
        for j in range(n):
            Z[ARGUMENT * n + j] = Z[j] + half * Z[TERMS * n + j]
        numbers[AT, 0] = numbers[TIME, 0] + half * Z[TERMS * n + n]
        call(code[DERIVATIVE], numbers[AT], Z, ARGUMENT * n, P, T, W, Z, (ROOM + side) * n)
    for i in range(n):
        Z[ARGUMENT * n + i] = Z[i]
        ahead, behind, here = Z[ROOM * n + i], Z[(ROOM + 1) * n + i], Z[RATE * n + i]
        if behind - behind == 0.0:
            Z[ROOM * n + i] = ahead - behind
        else:  # beyond an edge, as that of a root
            Z[ROOM * n + i] = 2.0 * (ahead - here)


def solve_stage(n, s, linear, Z):
    """Replace the rate of a stage by the solution of its equations."""
    _, M, pivots, (low, high, _), places, _, _, _, _, _ = linear
    for i in range(n):
        Z[ARGUMENT * n + places[i]] = Z[(RATE + s) * n + i] + Z[ADDEND * n + i]
    solve(n, low, high, M, pivots, Z, ARGUMENT * n)
    for i in range(n):
        Z[(RATE + s) * n + i] = Z[ARGUMENT * n + places[i]]


# --- linear equations of a band matrix ------------------------------------------------------

# Element (i, j) of a matrix of order n lies at j n + i.  It is zero below the `low`-th diagonal
# under the main one and above the `high`-th over it; a full matrix has n - 1 of both.  Plain loops,
# one column after the other, so that numbers that lie in turn are worked on together.


def factor(n, low, high, M, pivots):
    """Replace a matrix by its factors, pivoted in part; `pivots` says which rows change places."""
    for k in range(n):
        column, below, right = k * n, min(n, k + low + 1), min(n, k + low + high + 1)
        p, largest = k, abs(M[column + k])
        for i in range(k + 1, below):
            if abs(M[column + i]) > largest:
                p, largest = i, abs(M[column + i])
        pivots[k] = p
        M[column + k], M[column + p] = M[column + p], M[column + k]
        for i in range(k + 1, below):
            M[column + i] /= M[column + k]
        for j in range(k + 1, right):
            row = M[j * n + p]
            M[j * n + p] = M[j * n + k]
            M[j * n + k] = row
            if row != 0.0:
                for i in range(k + 1, below):
                    M[j * n + i] -= M[column + i] * row


def solve(n, low, high, M, pivots, b, at):
    """Replace b[at:] by the solution of M x = b, given the factors of M."""
    for k in range(n):
        p = at + pivots[k]
        row = b[p]
        b[p] = b[at + k]
        b[at + k] = row
        for i in range(k + 1, min(n, k + low + 1)):
            b[at + i] -= M[k * n + i] * row
    for k in range(n - 1, -1, -1):
        b[at + k] /= M[k * n + k]
        row = b[at + k]
        for i in range(max(0, k - low - high), k):
            b[at + i] -= M[k * n + i] * row


# --- at given states ------------------------------------------------------------------------


def evaluate(code, role, n, decisions, points, pieces, arrays, out):
    """Call a function at times and states; put its results, signals from W, into the rows of `out`.

    `decisions` are their first place in P and how many numbers they are; rates are computed with
    those made there.  `points` are times, the piece of each, room for one time, and states, n each.
    `pieces` are places in P, and values.
    """
    (times, which, t, states), (places, values), (P, T, W, D) = points, pieces, arrays
    (decided_at, decided), piece = decisions, -1
    for k in range(len(times)):
        t[0] = times[k]
        if which[k] != piece:
            piece = which[k]
            for j in range(len(places)):
                P[places[j]] = values[piece, j]
            call(code[PREPARE], t, states, k * n, P, T, W, W, 0)
        if role == DERIVATIVE and decided > 0:
            call(code[DECIDE], t, states, k * n, P, T, W, D, 0)
            for j in range(decided):
                P[decided_at + j] = D[j]
            call(code[PREPARE], t, states, k * n, P, T, W, W, 0)
        call(code[role], t, states, k * n, P, T, W, D, 0)
        for j in range(out.shape[1]):
            out[k, j] = W[j] if role == SIGNALS else D[j]
