"""Segments of time: the run of each lane, and the actions where its segments begin and end.

A segment ends where an event in time is known beforehand: a breakpoint of a block, a bend of an
input, a sample of a discrete block.  It sets parameters, such as the `interval` of blocks.
"""

import math

from .event_checks import edge_of, shortest_step
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
    ENTERED,
    EVALUATIONS,
    EVENT_INDEX,
    FIRST_STEP,
    FRESH,
    HELD_RATE,
    HIGH,
    JUMP,
    LAST_EVENT,
    LOOK_TIME,
    NEXT_LOOK,
    NEXT_RUN,
    NEXT_STOP,
    NOT_FINITE,
    ON,
    REJECTED,
    RESTARTS,
    ROUNDING,
    RUN_INDEX,
    RUNS_END,
    SAMPLES_DONE,
    SEGMENT,
    SEGMENT_END,
    STAGE_TIME,
    STATE,
    STIFF_STEPS,
    STOP_AT,
    TIME,
    TRIAL_END,
    TRIAL_SIZE,
    WITHIN,
    Status,
    call,
    decide,
    derivative,
    fail,
    interpolate,
    prepare,
)

FIRST_LOOK = 5_000.0  # tries before the pace of a run is measured


def note_next_stop(solver, k):
    """Note the next sample of a lane, or the end of its segment."""
    lane, integers = solver.lane, solver.integers
    lane[NEXT_STOP, k] = lane[SEGMENT_END, k]
    done = integers[SAMPLES_DONE, k]
    if done < len(solver.times):
        lane[NEXT_STOP, k] = min(solver.times[done], lane[SEGMENT_END, k])


def take_run(solver, k):
    """Begin the next run in a lane; if there is none the lane stays as it is, next to others."""
    lane, integers = solver.lane, solver.integers
    runs, queue = solver.runs, solver.queue
    lane[FRESH, k] = 0.0
    m = queue[NEXT_RUN]
    if m == queue[RUNS_END]:
        return
    queue[NEXT_RUN] = m + 1
    queue[BEGINNING] = ANEW
    integers[RUN_INDEX, k] = m
    integers[SEGMENT, k] = solver.segments.first[runs.schedule[m]]
    integers[SAMPLES_DONE, k] = 1
    integers[BURST, k] = 0
    lanes, P = solver.shape.lanes, solver.memory.P
    for j in range(runs.parameters.shape[1]):
        P[j * lanes + k] = runs.parameters[m, j]
    set_segment(solver, integers[SEGMENT, k], k)
    for i in range(solver.shape.states):
        solver.states[STATE, i, k] = runs.states[m, i]
    clear_lane(solver, k)
    lane[TIME, k] = solver.times[0]
    lane[LOOK_TIME, k] = solver.times[0]
    lane[SEGMENT_END, k] = solver.segments.ends[integers[SEGMENT, k]]


def clear_lane(solver, k):
    """Reset the numbers of a lane, except those that stay for the next run."""
    lane = solver.lane
    for number in range(FIRST_STEP):
        if number < STIFF_STEPS or lane[number, k] != -math.inf:
            lane[number, k] = 0.0
    lane[NEXT_LOOK, k] = FIRST_LOOK
    lane[FRESH, k] = 1.0
    lane[LAST_EVENT, k] = -math.inf
    lane[STOP_AT, k] = math.inf


def set_segment(solver, segment, k):
    """Put the values that a segment sets into the parameters."""
    segments, lanes = solver.segments, solver.shape.lanes
    for j in range(len(segments.indices)):
        solver.memory.P[segments.indices[j] * lanes + k] = segments.values[segment, j]


def begin_segment(solver):
    """Begin a segment in the lanes that are fresh; end a run that cannot begin it."""
    lane, integers = solver.lane, solver.integers
    counts, shape = solver.results.counts, solver.shape
    for k in range(shape.lanes):
        if lane[FRESH, k] < 0.5:
            continue
        lane[FRESH, k] = 0.0
        lane[REJECTED, k] = 0.0
        lane[FIRST_STEP, k] = 0.0
        counts[integers[RUN_INDEX, k], EVALUATIONS] += 0 if shape.discrete > 0 else 2
        counts[integers[RUN_INDEX, k], RESTARTS] += 0 if shape.discrete > 0 else 1
        if lane[NOT_FINITE, k] != 0.0:
            fail(solver, k, Status.NOT_FINITE)
        stop_outside(solver, k, STATE)
        note_next_stop(solver, k)


def write_samples_until(solver, k, end):
    """Write the states at times up to `end`, within the step of a lane or at its end."""
    lane, integers = solver.lane, solver.integers
    results, times, states = solver.results, solver.times, solver.states
    m, done = integers[RUN_INDEX, k], integers[SAMPLES_DONE, k]
    while done < len(times) and times[done] <= end:
        share = (times[done] - lane[TIME, k]) / lane[TRIAL_SIZE, k]
        for i in range(solver.shape.states):
            if times[done] == lane[TRIAL_END, k]:
                results.states[m, done, i] = states[ARGUMENT, i, k]
            else:
                results.states[m, done, i] = interpolate(states, i, k, share)
        done += 1
        lane[STOP_AT, k] = math.inf
    integers[SAMPLES_DONE, k] = done


def stop_outside(solver, k, state_row):
    """Stop the run of a lane if a row of states is beyond the edge of a guard.

    In place of a decision guards have the distance with the decisions made there.  As in
    `set_edges` the edge is as wide as the distance changes in the shortest step.
    """
    lane, states, points = solver.lane, solver.states, solver.points
    if solver.shape.guarded == 0:
        return
    shortest = shortest_step(solver)
    lane[STAGE_TIME, 0] = lane[TIME, 0] + shortest
    derivative(solver, lane[TIME], state_row, HELD_RATE)
    for i in range(solver.shape.states):
        states[WITHIN, i, 0] = (
            states[state_row, i, 0] + shortest * states[HELD_RATE, i, 0]
        )
    decide(solver, lane[TIME], state_row, BEHIND)
    decide(solver, lane[STAGE_TIME], WITHIN, BEFORE)
    for guard in range(solver.shape.decisions, points.shape[2]):
        change = abs(points[BEFORE, DISTANCE, guard] - points[BEHIND, DISTANCE, guard])
        edge = edge_of(points[BEHIND, ROUNDING, guard], change)
        if not points[BEHIND, DECISION, guard] >= -edge:
            solver.integers[EVENT_INDEX, k] = guard
            fail(solver, k, Status.GUARD_LEFT)
            lane[SEGMENT_END, k] = lane[TIME, k]
            lane[HIGH, k] = 0.0
            return


def enter_segment(solver, k):
    """Enter the next segment, or end the run."""
    lane, integers = solver.lane, solver.integers
    segments, queue = solver.segments, solver.queue
    integers[SEGMENT, k] += 1
    segment = integers[SEGMENT, k]
    if segments.ends[segment] == math.inf:
        m = integers[RUN_INDEX, k]
        if solver.results.status[m] == Status.RUNNING:
            solver.results.status[m] = Status.FINISHED
        return
    lane[SEGMENT_END, k] = segments.ends[segment]
    if segments.smooth[segment] == 0:
        lane[FRESH, k] = 1.0
        queue[BEGINNING] = ANEW
    else:
        lane[FRESH, k] = max(lane[FRESH, k], ENTERED)
        queue[BEGINNING] = max(queue[BEGINNING], ON)
    set_segment(solver, segment, k)


def jump_states(solver):
    """Make states jump in lanes at the end of a segment; a sample there is after the jump.

    The next segment, which says what jumps, is set first; behind the last there is one for the end.
    """
    lane, integers = solver.lane, solver.integers
    lanes = solver.shape.lanes
    jumping = False
    for k in range(lanes):
        if at_segment_end(solver, k):
            jumping = True
            set_segment(solver, integers[SEGMENT, k] + 1, k)
    if not jumping:
        return
    prepare(solver, lane[TIME])
    Z, P, T, W, _ = solver.memory
    span = solver.shape.states * lanes
    call(solver.code[JUMP], lane[TIME], Z, 0, P, T, W, Z, ARGUMENT * span)
    for k in range(lanes):
        if at_segment_end(solver, k):
            accept_jump(solver, k)


def accept_jump(solver, k):
    """Take the states after a jump as those of a lane."""
    lane, integers = solver.lane, solver.integers
    states, results = solver.states, solver.results
    m, done = integers[RUN_INDEX, k], integers[SAMPLES_DONE, k]
    is_sample = done > 0 and solver.times[done - 1] == lane[TIME, k]
    not_finite = 0.0
    for i in range(solver.shape.states):
        new = states[ARGUMENT, i, k]
        not_finite += 0.0 * new
        states[STATE, i, k] = new
        if is_sample:
            results.states[m, done - 1, i] = new
    if not_finite != 0.0:
        fail(solver, k, Status.NOT_FINITE)
    stop_outside(solver, k, ARGUMENT)


def at_segment_end(solver, k):
    """Return whether the run of a lane is at the end of a segment."""
    lane, integers = solver.lane, solver.integers
    m = integers[RUN_INDEX, k]
    if m < 0 or solver.results.status[m] != Status.RUNNING or lane[ACCEPTED, k] < 0.5:
        return False
    return lane[TIME, k] == lane[SEGMENT_END, k]
