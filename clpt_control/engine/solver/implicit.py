"""What the implicit method solves at each stage: (I/(h g) - df/dx) U = a rate and its addend.

df/dx is computed anew for each step, by `slope` or by differences.  Arguments are those of
`numbering`; Rodas5P takes one run at a time, in lane 0.
"""

from . import solver_layout as row
from .solver_layout import call

CHANGE = 6e-6  # for differences of rates, of the size of a state: the third root of a rounding


def linearise(code, n, tolerances, numbers, linear, arrays):
    """Factor I/(h g) - df/dx for the step to try; after a rejected step df/dx is that of before."""
    slopes, M, pivots, (low, high, _), _, _, _, _, _, _ = linear
    if numbers[row.REJECTED, 0] < 0.5:
        differentiate(code, n, tolerances, numbers, linear, arrays)
    for j in range(n):
        for i in range(max(0, j - low - high), min(n, j + low + 1)):
            M[j * n + i] = -slopes[j * n + i]
        M[j * n + j] += numbers[row.DIAGONAL, 0]
    factor(n, low, high, M, pivots)


def differentiate(code, n, tolerances, numbers, linear, arrays):
    """Compute df/dx and df/dt; states whose rates have nothing in common go together."""
    slopes, _, _, (_, _, exact), _, groups, begins, rows, columns, to = linear
    Z, P, T, W, _ = arrays
    for i in range(n):
        Z[row.ARGUMENT * n + i] = Z[i]
        Z[row.TIME_SLOPE * n + i] = 0.0
    for group in range(len(begins) - 1):
        known = exact > 0
        if known:
            for j in range(n + 1):
                Z[row.TERMS * n + j] = 1.0 if groups[j] == group else 0.0
            call(code[row.SLOPE], numbers[row.TIME], Z, row.ARGUMENT * n, P, T, W, Z, row.ROOM * n)
            for e in range(begins[group], begins[group + 1]):
                known = known and Z[row.ROOM * n + rows[e]] - Z[row.ROOM * n + rows[e]] == 0.0
        if not known:
            by_differences(code, n, group, tolerances, numbers, groups, arrays)
        for e in range(begins[group], begins[group + 1]):
            slope = Z[row.ROOM * n + rows[e]] / Z[row.TERMS * n + columns[e]]
            slope = slope if slope - slope == 0.0 else 0.0
            if columns[e] == n:
                Z[row.TIME_SLOPE * n + rows[e]] = slope
            else:
                slopes[to[e]] = slope


def by_differences(code, n, group, tolerances, numbers, groups, arrays):
    """Write a group's changes of states and time into TERMS, and the changes of rates into ROOM."""
    Z, P, T, W, _ = arrays
    least = tolerances[1] / tolerances[0]  # a smaller state is as good as zero
    for j in range(n):
        size = max(abs(Z[j]), least)
        change = 2.0 * CHANGE * (size if size > 0.0 else 1.0)
        Z[row.TERMS * n + j] = change if groups[j] == group else 0.0
    Z[row.TERMS * n + n] = 1e-3 * numbers[row.TAKEN, 0] if groups[n] == group else 0.0
    for side in range(2):
        half = 0.5 - side
        for j in range(n):
            Z[row.ARGUMENT * n + j] = Z[j] + half * Z[row.TERMS * n + j]
        numbers[row.AT, 0] = numbers[row.TIME, 0] + half * Z[row.TERMS * n + n]
        to = (row.ROOM + side) * n
        call(code[row.DERIVATIVE], numbers[row.AT], Z, row.ARGUMENT * n, P, T, W, Z, to)
    for i in range(n):
        Z[row.ARGUMENT * n + i] = Z[i]
        ahead, behind, here = Z[row.ROOM * n + i], Z[(row.ROOM + 1) * n + i], Z[row.RATE * n + i]
        if behind - behind == 0.0:
            Z[row.ROOM * n + i] = ahead - behind
        else:  # beyond an edge, as that of a root
            Z[row.ROOM * n + i] = 2.0 * (ahead - here)


def solve_stage(n, s, linear, Z):
    """Replace the rate of a stage by the solution of its equations."""
    _, M, pivots, (low, high, _), places, _, _, _, _, _ = linear
    for i in range(n):
        Z[row.ARGUMENT * n + places[i]] = Z[(row.RATE + s) * n + i] + Z[row.ADDEND * n + i]
    solve(n, low, high, M, pivots, Z, row.ARGUMENT * n)
    for i in range(n):
        Z[(row.RATE + s) * n + i] = Z[row.ARGUMENT * n + places[i]]


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
