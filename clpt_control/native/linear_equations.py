"""Linear equations of a band matrix: factors with partial pivoting, and solutions.

Element (i, j) of a matrix of order n lies at j n + i.  It is zero below the `low`-th diagonal under
the main one and above the `high`-th over it; a full matrix has n - 1 of both.  Plain loops, one
column after the other, so that numbers that lie in turn are worked on together.
"""


def factor(n, low, high, M, pivots):
    """Replace a matrix by its factors; `pivots` says which rows change places."""
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
