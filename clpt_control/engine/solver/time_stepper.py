"""Time stepper: integrate runs from event to event; the order of what happens in a step.

The same functions serve one run and several side by side (lanes).  They are printed once as LLVM
text (`make solver`).  Every lane has its own run, time, step and segment of time; a lane whose run
has ended takes the next.  Nothing is summed across lanes, so a run gives the same numbers next to
any others.  One pass of `advance`:

1. `start_segments`: rates, decisions and first step where integration begins anew.
2. `attempt_step`: the stages, the new state and its error estimate.
3. `check_lanes`: count steps, fail, find out if an interpolant is needed for samples.
4. `handle_events`: events in state (`event_checks`, `event_location`); a step that
   crosses one is rejected, to be tried again up to the event.
5. `write_samples`, then the state of accepted steps; the restart behind an event.
6. `end_segments`: jumps of states, the next segment, the next run.

All numbers are computed by the diagram's functions and the formulas of the method (`methods`).
"""

from .event_checks import comes_near, hold_decisions
from .event_location import locate_events, restart_behind_event
from .implicit import factor_matrix, solve_stage
from .segments import (
    begin_segment,
    enter_segment,
    jump_states,
    note_next_stop,
    take_run,
    write_samples_until,
)
from .solver_layout import (
    ACCEPT,
    ACCEPTED,
    ACCEPTED_COUNT,
    ANEW,
    ARGUMENT,
    ATTEMPT,
    BEGINNING,
    CHECKS_STIFFNESS,
    CONTROL,
    CUBIC,
    DECIDE,
    DENSE,
    DERIVATIVE,
    DUE,
    END_RATE,
    EVALUATIONS,
    FAILURE,
    FALLS,
    FIRST,
    FRESH,
    INTERPOLANT_ERROR,
    LOOK_ADVANCE,
    LOOK_SIZE,
    LOOK_TIME,
    NEXT_LOOK,
    PREPARE,
    RATE,
    REJECTED_COUNT,
    REJECTIONS,
    RUN_INDEX,
    SAMPLES_DONE,
    SEGMENT_END,
    SIGNALS,
    SIZES,
    STAGE,
    STAGE_TIME,
    STATE,
    STEP_SIZE,
    STEPS,
    STIFF_AFTER,
    STIFF_STEPS,
    STIFFNESS,
    STOP_AT,
    TIME,
    TRIAL,
    TRIAL_END,
    TRIAL_SIZE,
    TRIES_LEFT,
    Status,
    call,
    derivative,
    fail,
    formula,
    prepare,
    retry,
)

CHECK_EVERY = 128  # steps between checks for stiffness
FALLS_OF_RUNAWAY = 5  # measurements in a row
FALLING = 1.05  # twice the tries: a steady pace has 2, rates that grow exponentially 1
GROWTH = 2.0  # of the largest state
MANY_TRIES = 500_000  # of a run that may be ended for its pace alone
OUT_OF_REACH = 1e11  # tries, a day of computing
OUT_OF_REACH_AFTER_BURST = (
    1e15  # tries; rates that read time or have events may come to rest
)
STEPS_AHEAD = 250  # for which stiffness may matter


def advance(solver, budget, most):
    """Take at most `budget` steps in every lane; return how many lanes are at work.

    A run that has taken `most` tries ends.  No more steps are taken once a lane looks stiff.
    """
    lane, integers = solver.lane, solver.integers
    shape = solver.shape
    watched = shape.guarded > 0 or shape.decisions > 0
    active = 0
    for k in range(shape.lanes):
        if integers[RUN_INDEX, k] < 0:
            take_run(solver, k)
        active += 1 if integers[RUN_INDEX, k] >= 0 else 0
    while active > 0 and budget > 0:
        budget -= 1
        started = start_segments(solver)
        attempt_step(solver)
        accepted = False
        due = started or watched or shape.implicit > 0
        for k in range(shape.lanes):
            accepted = accepted or lane[ACCEPTED, k] > 0.5
            due = due or lane[DUE, k] > 0.5
        between, stiffness = False, False
        if due:
            between, stiffness = check_lanes(solver)
        interpolated = handle_events(solver, accepted, between, stiffness)
        if due and accepted:
            write_samples(solver, interpolated)
        if shape.lanes > 1 or lane[ACCEPTED, 0] > 0.5:
            formula(solver, ACCEPT)
        if shape.decisions > 0 and accepted:
            restart_behind_event(solver)
        if shape.jumping and due:
            jump_states(solver)
        if due:
            active, stiff = end_segments(solver, most)
            budget = 0 if stiff else budget
    count_steps(solver)
    return active


def start_segments(solver):
    """Start segments in lanes that enter one; return whether integration begins anew in any."""
    lane = solver.lane
    queue, shape = solver.queue, solver.shape
    if queue[BEGINNING] == 0:
        return False
    anew = queue[BEGINNING] == ANEW
    queue[BEGINNING] = 0
    # 1. parameters of the segment, and the decisions that hold in it
    prepare(solver, lane[TIME])
    if shape.decisions > 0:
        hold_decisions(solver)
        anew = anew or lane[FRESH, 0] > 0.5
    if not anew:
        return False
    # 2. the first step, from the change of the rates over a trial step
    if shape.discrete == 0:
        derivative(solver, lane[TIME], STATE, RATE + 1)
        formula(solver, SIZES)
        formula(solver, TRIAL)
        derivative(solver, lane[STAGE_TIME], ARGUMENT, RATE + 2)
        formula(solver, FIRST)
    begin_segment(solver)
    return True


def attempt_step(solver):
    """Compute the stages of a step, the new state and whether its error is small enough."""
    lane = solver.lane
    shape = solver.shape
    formula(solver, ATTEMPT)
    if shape.discrete > 0:
        derivative(solver, lane[TIME], STATE, RATE)
    if shape.implicit > 0:
        factor_matrix(solver)
    for stage in range(1, shape.stages):
        formula(solver, STAGE + stage)
        derivative(solver, lane[STAGE_TIME], ARGUMENT, RATE + stage)
        if shape.implicit > 0:
            solve_stage(solver, stage)
    formula(solver, CONTROL)


def check_lanes(solver):
    """Check all lanes after a step; return whether samples lie within it, and if it may be stiff.

    A guard is checked by the interpolant, as samples are.
    """
    lane, integers = solver.lane, solver.integers
    between, stiffness = False, False
    count_steps(solver)
    for k in range(solver.shape.lanes):
        m, done = integers[RUN_INDEX, k], integers[SAMPLES_DONE, k]
        lane[CHECKS_STIFFNESS, k] = 0.0
        if m >= 0 and lane[FAILURE, k] > 0.5:
            fail(solver, k, int(lane[FAILURE, k]))
        if m >= 0 and lane[ACCEPTED, k] > 0.5:
            between = between or solver.shape.guarded > 0
            if done < len(solver.times) and solver.times[done] < lane[TRIAL_END, k]:
                between = True
            is_check = solver.results.counts[m, STEPS] % CHECK_EVERY == 0
            if is_check or lane[STIFF_STEPS, k] > 0:
                lane[CHECKS_STIFFNESS, k] = 1.0
                stiffness = True
    return between, stiffness


def handle_events(solver, accepted, between, stiffness):
    """Handle events in state within the step; return whether its interpolant was computed.

    A step that crosses an event with an effect is rejected here, to be tried again up to the event.
    """
    lane = solver.lane
    shape = solver.shape
    explicit = shape.discrete == 0 and shape.implicit == 0
    # 1. the rate at the new state
    if accepted and shape.discrete == 0:
        derivative(solver, lane[STAGE_TIME], ARGUMENT, END_RATE)
    if stiffness and explicit:
        formula(solver, STIFFNESS)
    # 2. may there be an event, by the cubic through both ends?  Guards need the interpolant
    crossed = accepted and shape.guarded > 0
    if shape.decisions > 0 and accepted and not crossed:
        formula(solver, CUBIC)
        crossed = comes_near(solver)
    if not (between or crossed):
        return False
    # 3. the interpolant of the method
    if shape.dense_stages > 0:
        interpolant_stages(solver)
    formula(solver, DENSE)
    if explicit and accepted:
        check_interpolant(solver)
    # 4. the events by this interpolant
    if crossed:
        locate_events(solver)
    return between and explicit


def interpolant_stages(solver):
    """Compute further stages, then the new state again, in whose place their arguments were."""
    lane, shape = solver.lane, solver.shape
    for stage in range(1, shape.dense_stages + 1):
        formula(solver, STAGE + shape.stages + stage)
        derivative(solver, lane[STAGE_TIME], ARGUMENT, END_RATE + stage)
    formula(solver, STAGE + shape.stages)


def end_segments(solver, most):
    """Enter next segments and take next runs; return the lanes at work, and if one is stiff."""
    lane, integers = solver.lane, solver.integers
    active, stiff = 0, False
    times, status = solver.times, solver.results.status
    counts = solver.results.counts
    for k in range(solver.shape.lanes):
        m = integers[RUN_INDEX, k]
        if m < 0:
            continue
        tries = counts[m, STEPS] + counts[m, REJECTIONS]
        if tries >= most:
            fail(solver, k, Status.TOO_MANY_STEPS)
        elif tries >= lane[NEXT_LOOK, k]:
            check_pace(solver, k, tries, most)
        if lane[ACCEPTED, k] > 0.5 and lane[TIME, k] == lane[SEGMENT_END, k]:
            enter_segment(solver, k)
        if status[m] != Status.RUNNING:
            solver.results.reached[m] = integers[SAMPLES_DONE, k]
            integers[RUN_INDEX, k] = -1
            take_run(solver, k)
        elif lane[STIFF_STEPS, k] >= STIFF_AFTER:
            if times[-1] - lane[TIME, k] > STEPS_AHEAD * lane[STEP_SIZE, k]:
                stiff = True
            else:
                lane[STIFF_STEPS, k] = 0.0
        if integers[RUN_INDEX, k] >= 0:
            active += 1
            until_check = (
                CHECK_EVERY - counts[integers[RUN_INDEX, k], STEPS] % CHECK_EVERY
            )
            spare = min(most, lane[NEXT_LOOK, k]) - tries
            lane[TRIES_LEFT, k] = (
                1.0 if lane[STIFF_STEPS, k] > 0 else min(spare, until_check)
            )
            note_next_stop(solver, k)
    return active, stiff


def check_pace(solver, k, tries, most):
    """End a run that cannot reach the end of its segment; the pace is measured as tries double.

    The pace falls if these tries advance no further in time than the half as many before.  A run
    diverges if its pace falls `FALLS_OF_RUNAWAY` times in a row while the states grow, and even
    twice the pace is too slow.  After `MANY_TRIES` a run ends if the end is out of reach.
    """
    lane = solver.lane
    size = 0.0
    for i in range(solver.shape.states):
        size = max(size, abs(solver.states[STATE, i, k]))
    advance = lane[TIME, k] - lane[LOOK_TIME, k]
    lane[FALLS, k] += 1.0
    if advance > FALLING * lane[LOOK_ADVANCE, k]:
        lane[FALLS, k] = min(lane[FALLS, k], 0.0)
        lane[LOOK_SIZE, k] = size
    lane[LOOK_TIME, k] = lane[TIME, k]
    lane[LOOK_ADVANCE, k] = advance
    lane[NEXT_LOOK, k] = 2.0 * tries
    ahead = lane[SEGMENT_END, k] - lane[TIME, k]
    needed = 0.5 * tries * ahead / advance
    most_needed = OUT_OF_REACH
    if lane[FALLS, k] < 0.0:
        most_needed = OUT_OF_REACH_AFTER_BURST
    if tries >= MANY_TRIES and needed > most_needed:
        fail(solver, k, Status.TOO_MANY_STEPS)
    grows = size > GROWTH * lane[LOOK_SIZE, k]
    if lane[FALLS, k] >= FALLS_OF_RUNAWAY and grows and needed > 2.0 * (most - tries):
        fail(solver, k, Status.DIVERGING)


def count_steps(solver):
    """Add the steps of lanes since the last check to the counts of their runs."""
    lane, integers = solver.lane, solver.integers
    counts, stages = solver.results.counts, solver.shape.stages
    for k in range(solver.shape.lanes):
        m = integers[RUN_INDEX, k]
        if m >= 0:
            accepted = int(lane[ACCEPTED_COUNT, k])
            rejected = int(lane[REJECTED_COUNT, k])
            counts[m, STEPS] += accepted
            counts[m, REJECTIONS] += rejected
            counts[m, EVALUATIONS] += (stages - 1) * (accepted + rejected) + accepted
            lane[ACCEPTED_COUNT, k] = 0.0
            lane[REJECTED_COUNT, k] = 0.0
            lane[TRIES_LEFT, k] -= accepted + rejected


def write_samples(solver, interpolated):
    """Write the states at times within the step, for which further evaluations were made."""
    lane, results = solver.lane, solver.results
    for k in range(solver.shape.lanes):
        m = solver.integers[RUN_INDEX, k]
        if m < 0 or lane[ACCEPTED, k] < 0.5 or results.status[m] != Status.RUNNING:
            continue
        results.counts[m, EVALUATIONS] += (
            solver.shape.dense_stages if interpolated else 0
        )
        write_samples_until(solver, k, lane[TRIAL_END, k])


def check_interpolant(solver):
    """Try a step again, up to its first sample, if its interpolant is not exact enough."""
    lane, integers = solver.lane, solver.integers
    times = solver.times
    for k in range(solver.shape.lanes):
        m, done = integers[RUN_INDEX, k], integers[SAMPLES_DONE, k]
        if m < 0 or lane[ACCEPTED, k] < 0.5 or done >= len(times):
            continue
        if times[done] < lane[TRIAL_END, k] and lane[INTERPOLANT_ERROR, k] > 1.0:
            retry(solver, k, lane[TRIAL_SIZE, k])
            lane[STOP_AT, k] = times[done]
            solver.results.counts[m, EVALUATIONS] += solver.shape.dense_stages


def evaluate(
    code, role, states, first_decision, decisions, points, segments, arrays, out
):
    """Call a function at times and states; put its results, signals from W, into the rows of `out`.

    `points` are times, the segment of each, room for one time, and states, n each.  `segments` are
    indices of parameters, and values.  Rates are computed with the decisions made there.
    """
    times, segment_of, now, x = points
    indices, values = segments
    P, T, W, D = arrays
    segment = -1
    for k in range(len(times)):
        now[0] = times[k]
        if segment_of[k] != segment:
            segment = segment_of[k]
            for j in range(len(indices)):
                P[indices[j]] = values[segment, j]
            call(code[PREPARE], now, x, k * states, P, T, W, W, 0)
        if role == DERIVATIVE and decisions > 0:
            call(code[DECIDE], now, x, k * states, P, T, W, D, 0)
            for j in range(decisions):
                P[first_decision + j] = D[j]
            call(code[PREPARE], now, x, k * states, P, T, W, W, 0)
        call(code[role], now, x, k * states, P, T, W, D, 0)
        for j in range(out.shape[1]):
            out[k, j] = W[j] if role == SIGNALS else D[j]
