"""Words of equations: a row of numbers read at a place, helpers that SymPy leaves undefined."""

from collections.abc import Callable
from functools import wraps
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


@public
def opaque(function: Callable) -> Callable:
    """Mark a helper that SymPy reads as an undefined function.

    It is an undefined function of its arguments: theorems then hold for any
    function in its place.

    Parameters
    ----------
    function : callable
        A helper called by a block's equations, with its arguments by position.

    Returns
    -------
    callable
        The same function, marked.

    Examples
    --------
    >>> @opaque
    ... def gust(t):
    ...     return 0.1
    >>> gust(3.0)
    0.1
    """

    @wraps(function)
    def called(*arguments: Any) -> Any:
        found = function(*arguments)
        tape = next((a._tape for a in arguments if isinstance(a, Array)), None)
        if tape is None:
            return found
        given = [operand(lifted(tape, a)) for a in arguments]
        name = f"{function.__module__}.{function.__qualname__}"

        def hidden(k: int, value: Any) -> Any:
            value = lifted(tape, value)
            shape = getattr(value, "shape", ())
            return tape.add("opaque", [operand(value), *given], shape, (name, k))

        if isinstance(found, tuple):
            return tuple(hidden(k, value) for k, value in enumerate(found))
        return hidden(0, found)

    return called
