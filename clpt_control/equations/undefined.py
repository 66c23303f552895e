"""Helpers that SymPy reads as undefined functions."""

from collections.abc import Callable
from functools import wraps
from typing import Any

from ..arguments import public
from .arrays import Array, lifted, operand


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
