"""Integrate many runs, exactly to every breakpoint: the order of what happens in a step.

The same text serves one run and several side by side (lanes).  It is printed once as LLVM's text
(`make solver`) and is machine code for every run.  Every lane has its own run, time, step and piece
of time; a lane whose run has ended takes the next.  Nothing is summed across lanes, so a run gives
the same numbers beside any others.

All numbers are computed through `call`, by the diagram's functions and the formulas of `method`.
Arguments are those of `numbering`.  Decisions are watched by `looks`; `kinks` finds kinks.
"""

import math

from . import solver_layout as row
from .event_checks import decide, is_decided_anew, mark_passed, watch_guards
from .event_location import decide_anew, locate_kinks
from .implicit import linearise, solve_stage
from .rate_jumps import locate_jump, pass_jump
from .segments import begin_piece, enter_piece, jump, look_ahead, take_run
from .solver_layout import call, fail, interpolate, try_again

# steps between checks for stiffness; steps ahead for it to matter
OFTEN, AHEAD = 128, 5_000


def advance(code, shape, tolerances, batch, linear, budget, most):
    """Take at most `budget` steps in every lane; return how many lanes are at work.

    A run that has taken `most` tries ends.  No more steps are taken once a lane looks stiff.
    """
    lanes, n, stages, guarded, jumping, _, decided, unannounced = shape
    runs, schedule, times, results, lane, arrays = batch
    (_, status, reached, counts), (numbers, whole, queue) = results, lane
    Z, P, T, W, D = arrays
    span, now, at = n * lanes, numbers[row.TIME], numbers[row.AT]
    implicit, fixed, dense = stages == row.RODAS5P, stages <= row.RK4, stages == row.DOP853
    fsal = stages == row.DOPRI5  # its last stage is the first of the next step
    first = row.RATE + (row.DOP853 + 1 - stages if fsal else 0)  # behind it are the stages' rates
    argument, derivative = row.ARGUMENT * span, code[row.DERIVATIVE]
    rates = code[row.STAGED] if code[row.STAGED] != 0 else derivative
    active = 0
    for k in range(lanes):
        if whole[row.MEMBER, k] < 0:
            take_run(k, shape, runs, schedule, times, lane, Z, P)
        active += 1 if whole[row.MEMBER, k] >= 0 else 0
    while active > 0 and budget > 0:
        budget -= 1
        anew = queue[2] == row.ANEW
        if queue[2] > 0:
            queue[2] = 0
            call(code[row.PREPARE], now, Z, 0, P, T, W, D, 0)
            if decided > 0:
                anew = is_decided_anew(code, shape, numbers, arrays) or anew
        if anew:
            if decided > 0:
                decide(code, shape, numbers, arrays)
            if guarded:
                call(code[row.MARGIN], now, Z, 0, P, T, W, D, 0)
            if not fixed:
                call(derivative, now, Z, 0, P, T, W, Z, (row.RATE + 1) * span)
                call(code[row.SIZES], numbers, Z, 0, P, tolerances, W, D, 0)
                call(code[row.TRIAL], numbers, Z, 0, P, T, W, D, 0)
                call(derivative, at, Z, argument, P, T, W, Z, (row.RATE + 2) * span)
                call(code[row.FIRST], numbers, Z, 0, P, tolerances, W, D, 0)
            begin_piece(lanes, stages, times, results, lane, D, guarded)
        again = numbers[row.REJECTED, 0] > 0.5
        call(code[row.ATTEMPT], numbers, Z, 0, P, T, W, D, 0)
        if fixed:
            call(derivative, now, Z, 0, P, T, W, Z, row.RATE * span)
        if implicit:
            linearise(code, n, tolerances, numbers, linear, arrays)
        for s in range(1, stages):
            call(code[row.STAGE + s], numbers, Z, 0, P, T, W, D, 0)
            call(rates, at, Z, argument, P, T, W, Z, (first + s) * span)
            if implicit:
                solve_stage(n, s, linear, Z)
        call(code[row.CONTROL], numbers, Z, 0, P, tolerances, W, D, 0)
        good, within, checked = False, False, False
        looked = anew or implicit or guarded > 0 or decided > 0 or unannounced > 0
        for k in range(lanes):
            good = good or numbers[row.GOOD, k] > 0.5
            looked = looked or numbers[row.LOOK, k] > 0.5
        if looked:
            count_steps(shape, counts, lane)
            for k in range(lanes):
                m, done = whole[row.MEMBER, k], whole[row.DONE, k]
                numbers[row.CHECKED, k] = 0.0
                if m >= 0 and numbers[row.FAILING, k] > 0.5:
                    fail(status, whole, k, int(numbers[row.FAILING, k]))
                if m >= 0 and numbers[row.GOOD, k] > 0.5:
                    within = within or guarded > 0
                    if counts[m, row.STEPS] % OFTEN == 0 or numbers[row.STIFF_STEPS, k] > 0:
                        numbers[row.CHECKED, k], checked = 1.0, True
                    if done < len(times) and times[done] < numbers[row.NEW, k]:
                        within = True
        # where rates may jump, a step that is good is watched, and one that is rejected twice
        watched = unannounced > 0 and dense and (good or again)
        if (good and not (fixed or fsal)) or watched:
            call(derivative, at, Z, argument, P, T, W, Z, (row.RATE + row.DOP853) * span)
        if checked and (dense or fsal):
            call(code[row.STIFFNESS], numbers, Z, 0, P, T, W, D, 0)
        beyond = False
        if decided > 0 and good:
            call(code[row.CUBIC], numbers, Z, 0, P, T, W, D, 0)
            beyond = mark_passed(code, row.DECIDE, shape, decided, times, results, lane, arrays)
        if within or beyond or watched:
            if dense:
                for s in range(stages + 1, stages + 4):
                    call(code[row.STAGE + s], numbers, Z, 0, P, T, W, D, 0)
                    call(derivative, at, Z, argument, P, T, W, Z, (row.RATE + s) * span)
                call(code[row.STAGE + stages], numbers, Z, 0, P, T, W, D, 0)
            call(code[row.DENSE], numbers, Z, 0, P, tolerances, W, D, 0)
            if dense and good:
                check_interpolant(lanes, times, results, lane)
            if beyond:
                beyond = mark_passed(code, row.DECIDE, shape, decided, times, results, lane, arrays)
            if beyond:
                locate_kinks(code, shape, tolerances, times, results, lane, arrays)
            if guarded:
                watch_guards(code, shape, times, results, lane, arrays)
            if watched:
                locate_jump(code, shape, tolerances, times, results, lane, arrays)
        if looked and good:
            sample(shape, times, results, lane, Z, 3 if within and dense else 0)
        if lanes > 1 or numbers[row.GOOD, 0] > 0.5:
            call(code[row.ACCEPT], numbers, Z, 0, P, T, W, D, 0)
        if decided > 0 and good:
            decide_anew(shape, tolerances, times, status, lane, Z)
        if unannounced > 0 and numbers[row.GOOD, 0] > 0.5:
            pass_jump(times, lane)
        if jumping and looked:
            jump(code, shape, schedule, times, results, lane, arrays)
        if looked:
            active = 0
            for k in range(lanes):
                m = whole[row.MEMBER, k]
                if m < 0:
                    continue
                spare = most - counts[m, row.STEPS] - counts[m, row.REJECTIONS]
                if spare <= 0:
                    fail(status, whole, k, row.TOO_MANY)
                if numbers[row.GOOD, k] > 0.5 and numbers[row.TIME, k] == numbers[row.END, k]:
                    enter_piece(k, lanes, schedule, status, lane, P)
                if status[m] != row.RUNNING:
                    reached[m], whole[row.MEMBER, k] = whole[row.DONE, k], -1
                    take_run(k, shape, runs, schedule, times, lane, Z, P)
                elif numbers[row.STIFF_STEPS, k] >= row.MANY:
                    if times[len(times) - 1] - numbers[row.TIME, k] > AHEAD * numbers[row.STEP, k]:
                        budget = 0
                    else:
                        numbers[row.STIFF_STEPS, k] = 0.0
                if whole[row.MEMBER, k] >= 0:
                    active += 1
                    tries = min(spare, OFTEN - counts[whole[row.MEMBER, k], row.STEPS] % OFTEN)
                    numbers[row.TRIES_LEFT, k] = 1.0 if numbers[row.STIFF_STEPS, k] > 0 else tries
                    look_ahead(k, times, lane)
    count_steps(shape, counts, lane)
    return active


def count_steps(shape, counts, lane):
    """Add the steps of lanes since the last look to the counts of their runs."""
    lanes, stages, (numbers, whole, _) = shape[0], shape[2], lane
    for k in range(lanes):
        m = whole[row.MEMBER, k]
        if m >= 0:
            good, bad = int(numbers[row.GOOD_ONES, k]), int(numbers[row.BAD_ONES, k])
            counts[m, row.STEPS] += good
            counts[m, row.REJECTIONS] += bad
            counts[m, row.EVALUATIONS] += (stages - 1) * (good + bad)
            counts[m, row.EVALUATIONS] += 0 if stages == row.DOPRI5 else good
            numbers[row.GOOD_ONES, k], numbers[row.BAD_ONES, k] = 0.0, 0.0
            numbers[row.TRIES_LEFT, k] -= good + bad


def sample(shape, times, results, lane, Z, more):
    """Write the states at times within the step, for which `more` evaluations were made."""
    lanes, n = shape[0], shape[1]
    (out, status, _, counts), (numbers, whole, _) = results, lane
    for k in range(lanes):
        m, done = whole[row.MEMBER, k], whole[row.DONE, k]
        if m < 0 or numbers[row.GOOD, k] < 0.5 or status[m] != row.RUNNING:
            continue
        counts[m, row.EVALUATIONS] += more
        t, h, new = numbers[row.TIME, k], numbers[row.TAKEN, k], numbers[row.NEW, k]
        while done < len(times) and times[done] <= new:
            for i in range(n):
                if times[done] == new:
                    out[m, done, i] = Z[(row.ARGUMENT * n + i) * lanes + k]
                else:
                    out[m, done, i] = interpolate(Z, n, lanes, k, i, (times[done] - t) / h)
            done += 1
            numbers[row.STOP_AT, k] = math.inf
        whole[row.DONE, k] = done


def check_interpolant(lanes, times, results, lane):
    """Try a step again, up to its first sample, if its interpolant is not exact enough."""
    counts, (numbers, whole, _) = results[3], lane
    for k in range(lanes):
        m, done = whole[row.MEMBER, k], whole[row.DONE, k]
        if m < 0 or numbers[row.GOOD, k] < 0.5 or done >= len(times):
            continue
        if times[done] < numbers[row.NEW, k] and numbers[row.WITHIN, k] > 1.0:
            try_again(k, numbers[row.TAKEN, k], counts, lane)
            numbers[row.STOP_AT, k] = times[done]
            counts[m, row.EVALUATIONS] += 3


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
            call(code[row.PREPARE], t, states, k * n, P, T, W, W, 0)
        if role == row.DERIVATIVE and decided > 0:
            call(code[row.DECIDE], t, states, k * n, P, T, W, D, 0)
            for j in range(decided):
                P[decided_at + j] = D[j]
            call(code[row.PREPARE], t, states, k * n, P, T, W, W, 0)
        call(code[role], t, states, k * n, P, T, W, D, 0)
        for j in range(out.shape[1]):
            out[k, j] = W[j] if role == row.SIGNALS else D[j]
