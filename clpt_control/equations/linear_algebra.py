"""NumPy's products, norms and linear equations, of arrays of the record.

    A x = b by elimination, det A as the product of its pivots, A = L L^T

Pivots are chosen by `where`, as np.linalg.solve chooses them by size.
"""

from collections.abc import Callable
from functools import reduce
from typing import Any

import numpy as np

from .arrays import Array, Unread
from .elementwise import elementwise, lifted, refuse_in_a_try, where
from .ufuncs import matmul
from .views import on_objects, refuse

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


def cross(
    a: Any, b: Any, axisa: int = -1, axisb: int = -1, axisc: int = -1, axis: Any = None
) -> Any:
    """Return the vector product, in one order of operations for all versions of NumPy."""
    at, of, to = (axisa, axisb, axisc) if axis is None else (axis, axis, axis)
    a, b = np.moveaxis(a, at, 0), np.moveaxis(b, of, 0)
    if len(a) != 3 or len(b) != 3:
        raise Unread("np.cross of vectors that are not of three numbers")
    parts = [a[i - 2] * b[i - 1] - a[i - 1] * b[i - 2] for i in range(3)]
    return np.moveaxis(np.stack(parts), 0, to)


def norm(a: Any, ord: Any = None, axis: Any = None, keepdims: Any = False) -> Any:
    """Return a norm of a vector, or of rows or columns."""
    vector = a.ndim == 1 or isinstance(axis, int)
    if ord in (None, "fro") or (ord == 2 and vector):
        return np.sqrt(np.sum(elementwise("mul", a, a), axis, keepdims=keepdims))
    if not vector or not isinstance(ord, int | float):
        return refuse(f"a norm of order {ord}")
    if ord in (np.inf, -np.inf):
        return (np.max if ord > 0 else np.min)(np.fabs(a), axis, keepdims=keepdims)
    size = np.sum(np.fabs(a) ** ord if ord != 1 else np.fabs(a), axis, keepdims=keepdims)
    return size ** (1.0 / ord) if ord != 1 else size


def diag(a: Array, k: int = 0) -> Any:
    """Return the diagonal of a matrix, or the matrix of a diagonal."""
    return np.diagonal(a, k) if a.ndim == 2 else on_objects(a._tape, np.diag, (a, k), {})


# --- linear equations: elimination, with pivots by `where` -----------------------------------


def _rows(matrix: Any) -> list[Any]:
    if len(matrix) > MOST_ROWS:
        raise Unread(f"linear equations of more than {MOST_ROWS} rows with signals in their matrix")
    return [matrix[k] for k in range(len(matrix))]


def _eliminated(rows: list[Any], pivot: Callable = lambda a: a) -> Any:
    """Make rows triangular, in place; return whether they changed places an odd number of times."""
    sign: Any = 1.0
    n = len(rows)
    refuse_in_a_try(*rows)  # where they have no solution
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
    right = b[:, None] if b.ndim == 1 else b
    rows = [np.concatenate([row, right[k]]) for k, row in enumerate(_rows(A))]
    _eliminated(rows)
    solved: list[Any] = [None] * n
    for k in range(n - 1, -1, -1):
        rest = rows[k][n:]
        for i in range(k + 1, n):
            rest = rest - solved[i] * rows[k][i]
        solved[k] = rest / rows[k][k]
    x = np.stack(solved)
    return x[:, 0] if b.ndim == 1 else x


def determinant(A: Any) -> Any:
    """Return the determinant: the product of the pivots."""
    rows = _rows(A)
    sign = _eliminated(rows, lambda a: where(a == 0.0, 1.0, a))  # below it all are 0
    return reduce(lambda v, w: v * w, (rows[k][k] for k in range(len(rows)))) * sign


def cholesky(A: Any, upper: bool = False) -> Any:
    """Return the triangle L of A = L L^T, or L^T; of A its lower triangle counts, or its upper."""
    A, n = (A.T if upper else A), len(_rows(A))
    refuse_in_a_try(A)  # where it has none
    L: list[list[Any]] = [[0.0] * n for _ in range(n)]
    for i in range(n):
        for j in range(i + 1):
            rest = reduce(lambda v, k: v - L[i][k] * L[j][k], range(j), A[i, j])
            L[i][j] = np.sqrt(rest) if i == j else rest / L[j][j]
    triangle = lifted(A._tape, np.array(L, dtype=object))
    return triangle.T if upper else triangle
