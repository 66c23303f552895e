"""Layout of the solver's arrays: statuses, numbers of a lane, rows of states, functions called.

The solver integrates several runs side by side, one in each lane.  All functions take a
`Solver`:

    lane[TIME, k]           time reached by the run of lane k
    states[RATE + s, i, k]  rate of state i at stage s of the step that lane k tries

Numba compiles these pages (`make solver`), so they are plain loops over arrays.
"""

import math
from enum import IntEnum
from typing import Any, NamedTuple


class Status(IntEnum):
    """State of a run: its number in the solver, its name in datasets, and a sentence for users."""

    label: str
    sentence: str

    def __new__(cls, value: int, label: str = "", sentence: str = "") -> "Status":
        """Make a status whose number is `value`."""
        status = int.__new__(cls, value)
        status._value_ = value
        status.label = label
        status.sentence = sentence
        return status

    RUNNING = 0, "not_run", "under way"
    FINISHED = 1, "finished", "completed"
    STEP_TOO_SMALL = (
        2,
        "step_too_small",
        "the step became too small; loosen rtol and atol, look for a singularity, count large "
        "times from the first, or give a switch that is met without number a boundary layer",
    )
    NOT_FINITE = (
        3,
        "not_finite",
        "a number is not finite. Check parameters and the initial state",
    )
    GUARD_LEFT = 4, "left_the_field", "a guard was left"
    TOO_MANY_STEPS = (
        5,
        "too_many_steps",
        "too many steps: rates change much faster than the run is long, or a switch chatters. "
        "Lower the gains, give a switch a hysteresis, or loosen rtol and atol",
    )
    CHATTERING = (
        6,
        "chatters",
        "switches without end (chattering). Give the switch a hysteresis, a boundary layer "
        "(np.clip in place of np.sign), or sample it",
    )
    ACCUMULATING = (
        7,
        "accumulates",
        "jumps at its level without end. End the run before, with a guard that stops it, or let "
        "the jump hold the states at rest",
    )
    DIVERGING = (
        8,
        "diverges",
        "the states grow while the steps shrink, and at this pace the end is out of reach. Check "
        "signs and sizes of the gains, or stop the run with a guard",
    )
    STIFF = 9, "stiff", "left to an implicit method"
    STOPPED = 10, "stopped", "stopped by a guard"
    SERIES_ENDED = 11, "series_ended", "left to steps by stages"
    UNDECIDED = (
        12,
        "undecided",
        "compares a value that is not a number, and the rates depend on the answer. Keep the "
        "arguments of that block in range",
    )


# Real numbers of a lane, by index in `lane`.  The formulas of the methods (`methods`) read and
# write them, too.
TIME = 0  # reached by the run
STEP_SIZE = 1  # of the next step to try
SEGMENT_END = 2  # time at which the segment ends
FRESH = 3  # 1: integration begins anew; ENTERED: a segment goes on with the same rates
REJECTED = 4  # 1 if the last step was rejected
ACCEPTED = 5  # 1 if the step that was tried is accepted
TRIAL_SIZE = 6  # length of the step that is tried
TRIAL_END = 7  # time at its end
STAGE_TIME = 8  # time at which a function is evaluated
FAILURE = 9  # status with which the run has failed, or 0
RATE_NORM = 10  # size of the rates where a segment begins
NOT_FINITE = 11  # NaN if state or rates are not finite where a segment begins, else 0
EVENT_CROSSED = 12  # 1 if the step ends right behind an event
LOW = 13  # bracket of the guard that stops a run: shares of the step before it
HIGH = 14  # and behind it
LAST_EVENT = 15  # time of the last event
CALM_STEPS = 16  # checked steps since a stiff one
DIAGONAL = 17  # 1/(h gamma) of the matrix of the implicit method
NEXT_STOP = 18  # next sample, or the end of the segment
TRIES_LEFT = 19  # steps until the lane is checked
DUE = 20  # 1 if the lane is checked after this step
ACCEPTED_COUNT = 21  # steps since the last check
REJECTED_COUNT = 22
CHECKS_STIFFNESS = 23  # 1 if the step is checked for stiffness
INTERPOLANT_ERROR = 24  # above 1 no sample is taken from the interpolant
STOP_AT = 25  # time up to which a step may go, for a sample at its end
NEXT_LOOK = 26  # tries after which the pace of the run is measured
LOOK_TIME = 27  # time at the last measurement
LOOK_ADVANCE = 28  # advance in time between the last two measurements
LOOK_SIZE = 29  # largest state at the last measurement with a pace that did not fall
# Numbers that stay for the next run of the lane; of these two -inf, which says that none count
STIFF_STEPS = 30  # checked steps that look stiff; below 0 they do not count
FALLS = (
    31  # measurements with a falling pace since `LOOK_SIZE`; below 0 they do not count
)
FIRST_STEP = 32  # to try, or 0
MAX_STEP = 33
SHARE = 34  # of the step, at which a state within it is computed
REALS = 35
# Whole numbers of a lane, by index in `integers`
RUN_INDEX = 0  # -1 without a run
SEGMENT = 1
SAMPLES_DONE = 2
BURST = 3  # events in a row, one soon after the other
EVENT_INDEX = 4  # switching condition that the step crosses first, or -1
STEPS, EVALUATIONS, RESTARTS, REJECTIONS = range(4)  # columns of `counts`
STIFF_AFTER = 15  # stiff steps
ENTERED = 0.25


class Shape(NamedTuple):
    """Sizes of the problem."""

    lanes: int
    states: int
    stages: int  # of the method
    dense_stages: int  # further ones, for its interpolant
    implicit: int  # 1 if its stages are solved with a matrix
    discrete: int  # 1 if a step leads to the next sample of discrete time
    guarded: int  # number of guards, which stop the run: the last events
    jumping: int  # 1 if states jump
    first_decision: int  # index of the decisions in the parameters
    decisions: int


class Bracket(NamedTuple):
    """Shares of a step before and behind an event, and the least distance of events there."""

    low: float
    high: float
    distance_low: float
    distance_high: float  # below 0


class Runs(NamedTuple):
    """Initial values of the runs."""

    states: Any  # (m, n)
    parameters: Any  # (m, nP)
    schedule: Any  # (m,): number of each run's schedule


class Segments(NamedTuple):
    """Segments of time of all schedules, one behind the other."""

    first: Any  # of each schedule
    indices: Any  # of the parameters that a segment sets
    ends: Any  # times; inf behind the last segment of a schedule
    values: Any  # (segments, indices)
    smooth: Any  # 1 if a segment goes on with the rates and the step of the one before


class Results(NamedTuple):
    """Results of the runs."""

    states: Any  # (m, samples, n)
    status: Any  # (m,)
    reached: Any  # (m,): samples done
    counts: Any  # (m, 4): steps, evaluations, restarts, rejected steps


class Memory(NamedTuple):
    """Arrays that the diagram's functions and the formulas take, flat; number i of row r of Z in
    lane k is at (r n + i) lanes + k.
    """

    Z: Any  # rows of states
    P: Any  # parameters
    T: Any  # tables
    W: Any  # signals, and values that a function saves
    D: Any  # results; of `decide` the switching conditions at each sample point of a step


class Linear(NamedTuple):
    """Jacobian matrix of the implicit method; the arrays are empty for other methods."""

    jacobian: Any  # df/dx, column by column
    factors: Any  # of I/(h gamma) - df/dx
    pivots: Any
    nonzero: Any  # 1 where the solution may differ from 0
    queue: Any  # indices of these
    band: Any  # numbers of diagonals below and above the main one
    order: Any  # index of each state in the matrix
    groups: Any  # of each state, then of time: columns that share a difference
    begins: Any  # first element of each group
    rows: Any  # of each element
    columns: Any
    positions: Any  # of each element in `jacobian`


class Solver(NamedTuple):
    """Everything that the solver works on."""

    code: Any  # addresses of functions, in the order of the constants below
    shape: Shape
    tolerances: Any  # relative, absolute
    runs: Runs
    segments: Segments
    times: Any  # at which states are wanted; a run begins at the first
    results: Results
    lane: Any  # (REALS, lanes): real numbers of the lanes
    integers: Any  # (5, lanes): whole numbers of the lanes
    queue: Any  # by index NEXT_RUN, RUNS_END, BEGINNING
    memory: Memory
    states: Any  # Z as (rows, states, lanes)
    points: Any  # D as (sample points, 3, events): decision, distance, rounding error
    levels: Any  # of each guard: 1 if states jump there
    linear: Linear


NEXT_RUN, RUNS_END, BEGINNING = range(3)  # index in `queue`
# BEGINNING is 0 if no lane begins a segment, ON if one continues with the rates and the step of the
# segment before, ANEW if integration begins anew in one (then FRESH is 1 in its lane)
ON, ANEW = 1, 2

# Rows of Z: the state; rates of stages 0 to 15; the argument of a stage; terms of the interpolant
STATE, RATE, ARGUMENT, TERMS, ROWS = 0, 1, 17, 18, 25
END_RATE = RATE + 12  # the rate at the end of the step, of each method
# in place of the last rates: a state within the step, and rates there, with the decisions of the
# step's beginning and with those behind an event
WITHIN, HELD_RATE, NEW_RATE = 16, 14, 15
# of Rodas5P: solutions of its stages; the term that is added to a rate on the right-hand side;
# df/dt; room, two rows
SOLVED, ADDEND, TIME_SLOPE, ROOM = 2, 10, 11, 12

# Functions in `code`: those of the diagram, then the formulas of the method; stage s is STAGE + s
DERIVATIVE, PREPARE, SIGNALS, JUMP, DECIDE = range(5)
ATTEMPT, CONTROL, SIZES, TRIAL, FIRST = range(5, 10)
ACCEPT, DENSE, CUBIC, STATE_WITHIN, STIFFNESS = range(10, 15)
STAGE = 14

SAMPLE_POINTS = 8  # of a step, without its beginning
BEHIND = SAMPLE_POINTS + 1  # the sample point right behind an event
# decisions with which the step began; where a segment begins, events a shortest step later
BEFORE = BEHIND + 1
POINTS = BEFORE + 1
DECISION, DISTANCE, ROUNDING = range(3)


def call(address, t, X, first, P, T, W, D, to):
    """Call the function at an address on t, X[first:], P, T, W, D[to:], as `make solver` has it."""


def formula(solver, number):
    """Evaluate a formula of the method in all lanes."""
    Z, P, _, W, D = solver.memory
    call(solver.code[number], solver.lane, Z, 0, P, solver.tolerances, W, D, 0)


def derivative(solver, times, state_row, rate_row):
    """Write the rates at times, and at the states in a row, into another row."""
    Z, P, T, W, _ = solver.memory
    span = solver.shape.states * solver.shape.lanes
    call(
        solver.code[DERIVATIVE], times, Z, state_row * span, P, T, W, Z, rate_row * span
    )


def prepare(solver, times):
    """Compute what depends on parameters and decisions alone."""
    Z, P, T, W, D = solver.memory
    call(solver.code[PREPARE], times, Z, 0, P, T, W, D, 0)


def decide(solver, times, state_row, point):
    """Write decisions, distances and rounding errors at a row of states into a sample point.

    A distance that is NaN is infinite: below 0 if the decision has changed, and of a guard.  One of
    0 is on neither side: a run that meets a switch exactly may slide on it.
    """
    Z, P, T, W, D = solver.memory
    shape, points = solver.shape, solver.points
    to = 3 * point * points.shape[2]
    call(solver.code[DECIDE], times, Z, state_row * shape.states, P, T, W, D, to)
    for j in range(points.shape[2]):
        size = abs(points[point, DISTANCE, j])
        if size + points[point, ROUNDING, j] < math.inf:
            continue
        points[point, ROUNDING, j] = 0.0
        is_new = j >= shape.decisions or differs(
            points[point, DECISION, j], P[shape.first_decision + j]
        )
        if size != size:
            points[point, DISTANCE, j] = -math.inf if is_new else math.inf


def differs(decision, held):
    """Return whether a decision differs from the one in force; both may be NaN."""
    return decision != held and (decision == decision or held == held)


def interpolate(states, i, k, share):
    """Return state i of lane k at a share of the step."""
    y = 0.0
    for r in range(7):
        y += states[TERMS + 6 - r, i, k]
        y *= share if r % 2 == 0 else 1.0 - share
    return y + states[STATE, i, k]


def put_state_within(solver, share):
    """Put time and state of lane 0 at a share of the step into `stage_time` and WITHIN."""
    solver.lane[SHARE, 0] = share
    formula(solver, STATE_WITHIN)


def retry(solver, k, step_size):
    """Reject an accepted step, to try it again with another length."""
    lane, integers = solver.lane, solver.integers
    lane[ACCEPTED, k] = 0.0
    lane[REJECTED, k] = 0.0
    lane[STEP_SIZE, k] = step_size
    counts = solver.results.counts
    counts[integers[RUN_INDEX, k], STEPS] -= 1
    counts[integers[RUN_INDEX, k], REJECTIONS] += 1


def fail(solver, k, status):
    """End the run of a lane."""
    integers = solver.integers
    m = integers[RUN_INDEX, k]
    if m >= 0 and solver.results.status[m] == Status.RUNNING:
        solver.results.status[m] = status
