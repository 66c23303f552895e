"""Which run a lane works on, and what happens where its pieces of time begin and end.

Arguments are those of `numbering`.
"""

import math

from . import solver_layout as row
from .solver_layout import call, fail


def look_ahead(k, times, lane):
    """Note the next sample of a lane, or the end of its piece of time."""
    numbers, whole, _ = lane
    done = whole[row.DONE, k]
    numbers[row.NEXT, k] = numbers[row.END, k]
    if done < len(times):
        numbers[row.NEXT, k] = min(times[done], numbers[row.END, k])


def take_run(k, shape, runs, schedule, times, lane, Z, P):
    """Begin the next run in a lane; if there is none the lane stays as it is, beside others."""
    lanes, n = shape[0], shape[1]
    (X0, Ps, group), (numbers, whole, queue) = runs, lane
    m, numbers[row.FRESH, k] = queue[0], 0.0
    if m == queue[1]:
        return
    queue[0], queue[2] = m + 1, row.ANEW
    whole[row.MEMBER, k], whole[row.EDGE, k] = m, schedule[0][group[m]]
    whole[row.DONE, k], whole[row.BURST, k] = 1, 0
    for j in range(Ps.shape[1]):
        P[j * lanes + k] = Ps[m, j]
    set_piece(k, lanes, schedule, whole[row.EDGE, k], P)
    for i in range(n):
        Z[i * lanes + k] = X0[m, i]
    for number in range(row.STIFF_STEPS):
        numbers[number, k] = 0.0
    numbers[row.TIME, k], numbers[row.END, k] = times[0], schedule[2][whole[row.EDGE, k]]
    numbers[row.FRESH, k], numbers[row.LAST, k], numbers[row.STOP_AT, k] = 1.0, -math.inf, math.inf
    if numbers[row.STIFF_STEPS, k] > -math.inf:
        numbers[row.STIFF_STEPS, k] = 0.0


def set_piece(k, lanes, schedule, piece, P):
    """Put into P the values that a piece of time sets."""
    _, places, _, values, _ = schedule
    for j in range(len(places)):
        P[places[j] * lanes + k] = values[piece, j]


def begin_piece(lanes, stages, times, results, lane, D, guarded):
    """Begin a piece of time in the lanes that are fresh; end a run that cannot begin it."""
    (_, status, _, counts), (numbers, whole, _) = results, lane
    for k in range(lanes):
        if numbers[row.FRESH, k] > 0.5:
            numbers[row.FRESH, k], numbers[row.REJECTED, k] = 0.0, 0.0
            numbers[row.FIRST_STEP, k] = 0.0
            counts[whole[row.MEMBER, k], row.EVALUATIONS] += 0 if stages <= row.RK4 else 2
            counts[whole[row.MEMBER, k], row.RESTARTS] += 0 if stages == row.MAP else 1
            if numbers[row.TROUBLE, k] != 0.0:
                fail(status, whole, k, row.NOT_FINITE)
            if guarded and D[k] < -row.OUTSIDE:
                fail(status, whole, k, row.LEFT)
                numbers[row.END, k] = numbers[row.TIME, k]
            look_ahead(k, times, lane)


def enter_piece(k, lanes, schedule, status, lane, P):
    """Enter the next piece of time, or end the run."""
    _, _, edges, _, smooth = schedule
    numbers, whole, queue = lane
    m = whole[row.MEMBER, k]
    whole[row.EDGE, k] += 1
    piece = whole[row.EDGE, k]
    if edges[piece] == math.inf:
        if status[m] == row.RUNNING:
            status[m] = row.FINISHED
        return
    numbers[row.END, k] = edges[piece]
    if smooth[piece] == 0:
        numbers[row.FRESH, k], queue[2] = 1.0, row.ANEW
    else:
        numbers[row.FRESH, k] = max(numbers[row.FRESH, k], row.ENTERED)
        queue[2] = max(queue[2], row.ON)
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
            set_piece(k, lanes, schedule, whole[row.EDGE, k] + 1, P)
    if not some:
        return
    call(code[row.PREPARE], numbers[row.TIME], Z, 0, P, T, W, D, 0)
    call(code[row.JUMP], numbers[row.TIME], Z, 0, P, T, W, Z, row.ARGUMENT * n * lanes)
    if shape[3]:
        call(code[row.MARGIN], numbers[row.TIME], Z, row.ARGUMENT * n * lanes, P, T, W, D, 0)
    for k in range(lanes):
        if at_end(k, status, numbers, whole):
            m, done, trouble = whole[row.MEMBER, k], whole[row.DONE, k], 0.0
            sampled = done > 0 and times[done - 1] == numbers[row.TIME, k]
            for i in range(n):
                new = Z[(row.ARGUMENT * n + i) * lanes + k]
                trouble += 0.0 * new
                Z[i * lanes + k] = new
                if sampled:
                    out[m, done - 1, i] = new
            if trouble != 0.0:
                fail(status, whole, k, row.NOT_FINITE)
            if shape[3] and D[k] < -row.OUTSIDE:
                fail(status, whole, k, row.LEFT)


def at_end(k, status, numbers, whole):
    """Whether the run of a lane is at the end of a piece of time."""
    m = whole[row.MEMBER, k]
    if m < 0 or status[m] != row.RUNNING or numbers[row.GOOD, k] < 0.5:
        return False
    return numbers[row.TIME, k] == numbers[row.END, k]
