"""Products of arrays of the record, and linear equations.

    A x = b by elimination, det A as the product of its pivots

Pivots are chosen by `where`, as np.linalg.solve chooses them by size.
"""

from collections.abc import Callable
from functools import reduce
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
        return np.sqrt(np.sum(elementwise("mul", a, a), axis, keepdims=keepdims))
    return on_objects(a._tape, np.linalg.norm, (a, ord, axis, keepdims), {})


def _rows(matrix: Any) -> list[Any]:
    if len(matrix) > MOST_ROWS:
        raise Unread(f"linear equations of more than {MOST_ROWS} rows with signals in their matrix")
    return [matrix[k] for k in range(len(matrix))]


def _eliminated(rows: list[Any], pivot: Callable = lambda a: a) -> Any:
    """Make rows triangular, in place; return whether they changed places an odd number of times."""
    sign: Any = 1.0
    n = len(rows)
    if in_a_try() and any(map(moves, rows)):  # where they have no solution
        refuse_in_a_try()
    for k in range(n):
        for i in range(k + 1, n):
            larger = np.greater(np.fabs(rows[i][k]), np.fabs(rows[k][k]))
            rows[k], rows[i] = where(larger, rows[i], rows[k]), where(larger, rows[k], rows[i])
            sign = where(larger, -sign, sign)
        for i in range(k + 1, n):
            rows[i] = rows[i] - rows[k] * (rows[i][k] / pivot(rows[k][k]))
    return sign


def solve(A: Any, b: Any) -> Any:
    """Return the x of A x = b, as np.linalg.solve does."""
    n = A.shape[0]
    if A.ndim != 2 or A.shape != (n, n) or b.shape[0] != n:
        raise ValueError("solve: A must be square, b as long")
    columns = b[:, None] if b.ndim == 1 else b
    rows = [np.concatenate([row, columns[k]]) for k, row in enumerate(_rows(A))]
    _eliminated(rows)
    solved: list[Any] = [None] * n
    for k in range(n - 1, -1, -1):
        total = rows[k][n:]
        for i in range(k + 1, n):
            total = total - solved[i] * rows[k][i]
        solved[k] = total / rows[k][k]
    x = np.stack(solved)
    return x[:, 0] if b.ndim == 1 else x


def determinant(A: Any) -> Any:
    """Return the determinant: the product of the pivots."""
    rows = _rows(A)
    sign = _eliminated(rows, lambda a: where(a == 0.0, 1.0, a))  # below it all are 0
    return reduce(lambda v, w: v * w, (rows[k][k] for k in range(len(rows)))) * sign
