"""Products of tracer arrays, and linear equations.

    A x = b by elimination, det A as the product of its pivots

Pivots are chosen by `where`: the largest number of a column, as np.linalg.solve chooses them.
"""

from collections.abc import Callable
from functools import reduce
from operator import mul
from typing import Any

import numpy as np

from .arrays import Unread, moves
from .elementwise import elementwise, in_a_try, refuse_in_a_try, where
from .ufuncs import matmul
from .views import on_objects

MOST_ROWS = 24  # of linear equations


def dot(a: Any, b: Any) -> Any:
    """Return np.dot(a, b)."""
    if np.ndim(a) and np.ndim(b) > 2:
        return np.tensordot(a, b, (-1, -2))
    return matmul(a, b) if np.ndim(a) and np.ndim(b) else elementwise("mul", a, b)


def outer(a: Any, b: Any) -> Any:
    """Return a b^T."""
    a, b = (v if np.ndim(v) == 1 else np.reshape(v, -1) for v in (a, b))
    return elementwise("mul", a[:, None], b[None, :])


def norm(a: Any, ord: Any = None, axis: Any = None, keepdims: Any = False) -> Any:
    """Return the root of a sum of squares; other norms are NumPy's own, of each element."""
    if ord in (None, "fro") or (ord == 2 and (a.ndim == 1 or isinstance(axis, int))):
        squares = elementwise("mul", a, a)
        return np.sqrt(np.sum(squares, axis, keepdims=keepdims))
    return on_objects(a._tape, np.linalg.norm, (a, ord, axis, keepdims), {})


def _rows(matrix: Any) -> list[Any]:
    count = len(matrix)
    if count > MOST_ROWS:
        raise Unread(
            f"linear equations of more than {MOST_ROWS} rows with signals in their matrix"
        )
    return [matrix[k] for k in range(count)]


def _eliminate(rows: list[Any], divisor: Callable = lambda pivot: pivot) -> Any:
    """Make rows triangular, in place; return the sign of their permutation."""
    sign: Any = 1.0
    count = len(rows)
    if in_a_try() and any(map(moves, rows)):  # a singular matrix would raise
        refuse_in_a_try()
    for k in range(count):
        # the row with the largest number in column k comes first
        for i in range(k + 1, count):
            upper = rows[k]
            lower = rows[i]
            is_larger = np.greater(np.fabs(lower[k]), np.fabs(upper[k]))
            rows[k] = where(is_larger, lower, upper)
            rows[i] = where(is_larger, upper, lower)
            sign = where(is_larger, -sign, sign)
        for i in range(k + 1, count):
            factor = rows[i][k] / divisor(rows[k][k])
            rows[i] = rows[i] - rows[k] * factor
    return sign


def solve(A: Any, b: Any) -> Any:
    """Return the x of A x = b, as np.linalg.solve does."""
    n = A.shape[0]
    if A.ndim != 2 or A.shape != (n, n) or b.shape[0] != n:
        raise ValueError("solve: A must be square, b as long")
    columns = b[:, None] if b.ndim == 1 else b
    rows = [np.concatenate([row, columns[k]]) for k, row in enumerate(_rows(A))]
    _eliminate(rows)
    solved: list[Any] = [None] * n
    for k in reversed(range(n)):
        total = rows[k][n:]
        for i in range(k + 1, n):
            total = total - solved[i] * rows[k][i]
        solved[k] = total / rows[k][k]
    x = np.stack(solved)
    return x[:, 0] if b.ndim == 1 else x


def determinant(A: Any) -> Any:
    """Return the determinant: the product of the pivots."""
    rows = _rows(A)
    sign = _eliminate(rows, lambda pivot: where(pivot == 0.0, 1.0, pivot))
    return reduce(mul, (row[k] for k, row in enumerate(rows))) * sign
