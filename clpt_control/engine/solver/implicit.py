"""Linear equations of the implicit method: (I/(h gamma) - df/dx) U = a rate and its addend.

df/dx is computed anew for each step, by differences; states whose rates depend on no common state
share a difference (`jacobian`).  Rodas5P takes one run at a time, in lane 0.
"""

from .solver_layout import (
    ADDEND,
    ARGUMENT,
    DIAGONAL,
    RATE,
    REJECTED,
    ROOM,
    STAGE_TIME,
    STATE,
    TERMS,
    TIME,
    TIME_SLOPE,
    TRIAL_SIZE,
    derivative,
)

# of a state, for differences of rates: the third root of a rounding error
RELATIVE_CHANGE = 6e-6


def factor_matrix(solver):
    """Factor I/(h gamma) - df/dx for the step to try; after a rejected step df/dx is kept."""
    lane = solver.lane
    n, linear = solver.shape.states, solver.linear
    low, high = linear.band
    if lane[REJECTED, 0] < 0.5:
        differentiate(solver)
    for j in range(n):
        for i in range(max(0, j - low - high), min(n, j + low + 1)):
            linear.factors[j * n + i] = -linear.jacobian[j * n + i]
        linear.factors[j * n + j] += lane[DIAGONAL, 0]
    factor(n, low, high, linear.factors, linear.pivots)


def differentiate(solver):
    """Compute df/dx and df/dt."""
    n, linear, states = solver.shape.states, solver.linear, solver.states
    for i in range(n):
        states[ARGUMENT, i, 0] = states[STATE, i, 0]
        states[TIME_SLOPE, i, 0] = 0.0
    # of the states, then of time
    changes = solver.memory.Z[TERMS * n : TERMS * n + n + 1]
    for group in range(len(linear.begins) - 1):
        set_changes(solver, group, changes)
        difference_rates(solver, changes)
        for element in range(linear.begins[group], linear.begins[group + 1]):
            i, column = linear.rows[element], linear.columns[element]
            slope = states[ROOM, i, 0] / changes[column]
            slope = slope if slope - slope == 0.0 else 0.0
            if column == n:
                states[TIME_SLOPE, i, 0] = slope
            else:
                linear.jacobian[linear.positions[element]] = slope


def set_changes(solver, group, changes):
    """Set the changes of the states and of time in a group; the others do not change."""
    lane = solver.lane
    n, groups = solver.shape.states, solver.linear.groups
    # a smaller state is as good as zero
    least = solver.tolerances[1] / solver.tolerances[0]
    for j in range(n):
        size = max(abs(solver.states[STATE, j, 0]), least)
        change = 2.0 * RELATIVE_CHANGE * (size if size > 0.0 else 1.0)
        changes[j] = change if groups[j] == group else 0.0
    changes[n] = 1e-3 * lane[TRIAL_SIZE, 0] if groups[n] == group else 0.0


def difference_rates(solver, changes):
    """Write the central difference of the rates along changes into ROOM."""
    lane = solver.lane
    n, states = solver.shape.states, solver.states
    for side in range(2):
        half = 0.5 - side
        for j in range(n):
            states[ARGUMENT, j, 0] = states[STATE, j, 0] + half * changes[j]
        lane[STAGE_TIME, 0] = lane[TIME, 0] + half * changes[n]
        derivative(solver, lane[STAGE_TIME], ARGUMENT, ROOM + side)
    for i in range(n):
        states[ARGUMENT, i, 0] = states[STATE, i, 0]
        ahead, behind = states[ROOM, i, 0], states[ROOM + 1, i, 0]
        if behind - behind == 0.0:
            states[ROOM, i, 0] = ahead - behind
        else:  # beyond an edge, such as that of a root
            states[ROOM, i, 0] = 2.0 * (ahead - states[RATE, i, 0])


def solve_stage(solver, stage):
    """Replace the rate of a stage by the solution of its equations."""
    n, linear, states = solver.shape.states, solver.linear, solver.states
    low, high = linear.band
    for i in range(n):
        right_side = states[RATE + stage, i, 0] + states[ADDEND, i, 0]
        states[ARGUMENT, linear.order[i], 0] = right_side
    find_nonzero(n, linear, solver.memory.Z, ARGUMENT * n)
    solve(n, low, high, linear.factors, linear.pivots, solver.memory.Z, ARGUMENT * n)
    for i in range(n):
        j = linear.order[i]
        states[RATE + stage, i, 0] = (
            states[ARGUMENT, j, 0] if linear.nonzero[j] else 0.0
        )


def find_nonzero(n, linear, b, at):
    """Find which components of the solution may differ from 0, for the right-hand side b[at:].

    The others form a group without right-hand side, whose equations have no other components: an
    absent species, or several that only turn into each other.  Their exact solution is 0; rounding
    errors of the elimination would make them grow.
    """
    low, high = linear.band
    nonzero, queue = linear.nonzero, linear.queue
    count = 0
    for i in range(n):
        nonzero[i] = b[at + i] != 0.0
        if nonzero[i]:
            queue[count] = i
            count += 1
    done = 0
    while done < count < n:
        j = queue[done]
        done += 1
        for i in range(max(0, j - high), min(n, j + low + 1)):
            if linear.jacobian[j * n + i] != 0.0 and not nonzero[i]:
                nonzero[i] = 1
                queue[count] = i
                count += 1


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
            moved = M[j * n + p]
            M[j * n + p] = M[j * n + k]
            M[j * n + k] = moved
            if moved != 0.0:
                for i in range(k + 1, below):
                    M[j * n + i] -= M[column + i] * moved


def solve(n, low, high, M, pivots, b, at):
    """Replace b[at:] by the solution of M x = b, given the factors of M."""
    for k in range(n):
        p = at + pivots[k]
        moved = b[p]
        b[p] = b[at + k]
        b[at + k] = moved
        for i in range(k + 1, min(n, k + low + 1)):
            b[at + i] -= M[k * n + i] * moved
    for k in range(n - 1, -1, -1):
        b[at + k] /= M[k * n + k]
        moved = b[at + k]
        for i in range(max(0, k - low - high), k):
            b[at + i] -= M[k * n + i] * moved
