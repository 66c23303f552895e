"""Differences of a record from its function.

A record is a function in another form: array operations in NumPy, machine code, C or SymPy's
expressions.  Both give a row of numbers at each point; callers choose the points, and the words
for a difference.  Two numbers differ if

    |record - function| > relative |function| + of_largest max |function| of the row

and the error is above `least`.  An infinite number equals itself alone, and NaN equals NaN.
"""

from collections.abc import Iterable, Iterator
from typing import Any, NamedTuple

import numpy as np
from numpy import ndarray


class Tolerance(NamedTuple):
    """Largest error of a number that is no difference."""

    relative: float = 0.0
    of_largest: float = 0.0  # relative to the largest finite number of the row
    least: float = 0.0


# rounding of terms that cancel, not another execution path
RECORD = Tolerance(relative=1e-7, of_largest=1e-10)
EXACT = Tolerance()


def differences(
    record: Iterable[ndarray],
    function: Iterable[ndarray | None],
    tolerance: Tolerance = RECORD,
) -> Iterator[tuple[int, ndarray, ndarray]]:
    """Yield points by number, which numbers differ there, and those of the function.

    A row of the function is None to skip a point.
    """
    for point, (row, expected) in enumerate(zip(record, function, strict=True)):
        if expected is not None:
            is_different = differ(row, expected, tolerance)
            if is_different.any():
                yield point, is_different, expected


@np.errstate(invalid="ignore")  # of differences of infinite numbers
def differ(record: Any, function: Any, tolerance: Tolerance = RECORD) -> ndarray:
    """Return which numbers differ; all if shapes differ."""
    relative, of_largest, least = tolerance
    if np.shape(record) != np.shape(function):
        return np.ones(1, dtype=bool)
    error = np.abs(record - function)
    size = np.abs(function)
    is_close = error <= relative * size
    if is_close.all():
        return ~is_close
    largest = size.max(initial=0.0, where=size < np.inf)
    is_close |= error <= np.maximum(relative * size + of_largest * largest, least)
    both_nan = np.isnan(record) & np.isnan(function)
    return ~(is_close | (record == function) | both_nan)
