"""Linear equations with signals in them: elimination, with pivots by `where`.

Row by row, as Gauss did: what is largest in a column is brought up, and its multiples are
subtracted from the rows below.
"""

from functools import reduce
from typing import Any

import numpy as np

from .arrays import Array, Unread, where

MOST = 24  # rows


def _rows(matrix: Any) -> list[Any]:
    if len(matrix) > MOST:
        raise Unread(f"linear equations of more than {MOST} rows with signals in their matrix")
    return [matrix[k] for k in range(len(matrix))]


def _eliminated(rows: list[Any]) -> Any:
    """Make rows triangular, in place; return whether they changed places an odd number of times."""
    sign: Any = 1.0
    n = len(rows)
    for k in range(n):
        for i in range(k + 1, n):
            larger = np.greater(np.fabs(rows[i][k]), np.fabs(rows[k][k]))
            rows[k], rows[i] = where(larger, rows[i], rows[k]), where(larger, rows[k], rows[i])
            sign = where(larger, -sign, sign)
        for i in range(k + 1, n):
            rows[i] = rows[i] - rows[k] * (rows[i][k] / rows[k][k])
    return sign


def solve(A: Any, b: Any) -> Any:
    """Return the x of A x = b, as np.linalg.solve does."""
    n = A.shape[0]
    if A.ndim != 2 or A.shape != (n, n) or b.shape[0] != n:
        raise ValueError("solve: A must be square, b as long")
    if not isinstance(A, Array):
        return np.linalg.inv(A) @ b
    right = b[:, None] if b.ndim == 1 else b
    rows = [np.concatenate([row, right[k]]) for k, row in enumerate(_rows(A))]
    _eliminated(rows)
    found: list[Any] = [None] * n
    for k in range(n - 1, -1, -1):
        rest = rows[k][n:]
        for i in range(k + 1, n):
            rest = rest - found[i] * rows[k][i]
        found[k] = rest / rows[k][k]
    x = np.stack(found)
    return x[:, 0] if b.ndim == 1 else x


def inverse(A: Any) -> Any:
    """Return the inverse of a square matrix."""
    return solve(A, np.eye(A.shape[0]))


def determinant(A: Any) -> Any:
    """Return the determinant: the product of the pivots."""
    rows = _rows(A)
    sign = _eliminated(rows)
    return reduce(lambda v, w: v * w, (rows[k][k] for k in range(len(rows)))) * sign
