"""What lies where in the solver's arrays, and the numbers that mean something, by name.

Arguments that all functions share:

    code      addresses of functions, in the order of the places below
    shape     numbers of lanes, of states and of the method's stages; 1 if guards are watched, 1
              if states jump; first place of decisions in P, and how many numbers they are; 1 if
              rates may jump unannounced, 2 if they may at samples
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
MANY = 15  # steps that make a run stiff
JUMP_TIME = 34  # right behind a jump of the rates, where the step is to end (`rate_jumps`)
USUAL = 35  # mean of the largest defects of the steps before
NUMBERS = 36  # rows of numbers
MEMBER, EDGE, DONE, BURST, WHICH = range(5)  # rows of a lane's whole numbers
STEPS, EVALUATIONS, RESTARTS, REJECTIONS = range(4)  # of the counts
# places of `code`: the diagram's functions, then the method's; stage s stands at STAGE + s
DERIVATIVE, PREPARE, MARGIN, SIGNALS, JUMP, DECIDE, SLOPE, STAGED = range(8)
ATTEMPT, CONTROL, SIZES, TRIAL, FIRST, ACCEPT, DENSE, CUBIC, STIFFNESS = range(8, 17)
STAGE = 16
ON, ANEW = 1, 2  # a piece goes on with the rates and the step of the last, or begins with new ones
ENTERED = 0.25  # FRESH of a lane that goes on in a new piece
GLANCES = 8  # places within a step at which decisions and guards are looked at
BEHIND = GLANCES + 1  # the look right behind a kink
BEFORE = BEHIND + 1  # -1 for what has been passed before it, else 1
DECIDED = 3 * BEFORE + 1  # numbers of a decision in D: `decide` at each look
OUTSIDE = 1e-9  # grid steps beyond the edge that count as outside


def call(address, t, X, first, P, T, W, D, to):
    """Call the function at an address on t, X[first:], P, T, W, D[to:], as `make solver` has it."""


def interpolate(Z, n, lanes, k, i, share):
    """Return state i of a lane at a share of the step."""
    y = 0.0
    for r in range(7):
        y += Z[((TERMS + 6 - r) * n + i) * lanes + k]
        y *= share if r % 2 == 0 else 1.0 - share
    return y + Z[i * lanes + k]


def slope_within(Z, n, i, share):
    """Return the derivative of `interpolate` in the share, of state i of the only lane."""
    y, slope = 0.0, 0.0
    for r in range(7):
        y += Z[(TERMS + 6 - r) * n + i]
        slope = slope * (share if r % 2 == 0 else 1.0 - share) + (y if r % 2 == 0 else -y)
        y *= share if r % 2 == 0 else 1.0 - share
    return slope


def state_within(n, lanes, k, numbers, Z, share):
    """Put time and state of a lane at a share of the step into AT and LOOKED."""
    numbers[AT, k] = numbers[TIME, k] + share * numbers[TAKEN, k]
    for i in range(n):
        Z[(LOOKED * n + i) * lanes + k] = interpolate(Z, n, lanes, k, i, share)


def try_again(k, step, counts, lane):
    """Try a step that was good again, with another length."""
    numbers, whole, _ = lane
    numbers[GOOD, k], numbers[REJECTED, k], numbers[STEP, k] = 0.0, 0.0, step
    counts[whole[MEMBER, k], STEPS] -= 1
    counts[whole[MEMBER, k], REJECTIONS] += 1


def fail(status, whole, k, why):
    """End the run of a lane."""
    m = whole[MEMBER, k]
    if m >= 0 and status[m] == RUNNING:
        status[m] = why
