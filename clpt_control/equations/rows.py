"""A row of numbers read at a place that the run computes."""

from typing import Any

import numpy as np

from ..arguments import public, shown
from ..errors import ArgumentError
from .arrays import Array, lifted, operand
from .numbers import picked


@public
def lookup(table: Any, index: Any) -> Any:
    """Return a row's number at a whole place; NaN outside.

    Parameters
    ----------
    table : array_like, shape (n,)
        Numbers.
    index : float or array_like
        A place, cut to a whole number; a negative one counts from the end.

    Returns
    -------
    float or ndarray
        One number for each place.

    Examples
    --------
    >>> lookup([3.0, 5.0, 7.0], 1.0)
    np.float64(5.0)
    """
    tape = next((a._tape for a in (table, index) if isinstance(a, Array)), None)
    if tape is None:
        try:
            return picked(np.asarray(table, dtype=float), np.asarray(index, dtype=float))[()]
        except (TypeError, ValueError):
            raise ArgumentError(
                f"lookup: table = {shown(table)}, index = {shown(index)}: must be a row of numbers "
                "and a place"
            ) from None
    table = lifted(tape, table)
    return tape.add("pick", [operand(table), operand(index)], getattr(index, "shape", ()))
