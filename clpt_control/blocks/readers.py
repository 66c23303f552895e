"""The three readers of a block's equations, from one mechanism.

A reader rebinds the names that a function finds in its module (`math`, the
words, its helpers) and leaves the function's own code as it is.  So what Numba
compiles and what SymPy traces is the very code that python-control runs.
"""

from collections.abc import Callable, Mapping
from functools import cache
from types import FunctionType
from typing import Any

import numpy as np

from .rules import helpers_of
from .words import WORDS, symbolic_substitutes


def rebind(
    function: Callable,
    substitutes: Mapping[str, Any],
    wrap: Callable[[FunctionType], Any] = lambda f: f,
    opaque: Callable[[FunctionType], Any] | None = None,
) -> Any:
    """Make the same code read other words.

    Parameters
    ----------
    function : function
        Equations or a helper of them; left as it is.
    substitutes : mapping
        What ``math``, a word or a builtin such as ``range`` shall mean.
    wrap : callable, optional
        Applied to each rebound function, helpers first.
    opaque : callable, optional
        Gives the stand-in of a helper that is marked opaque.

    Returns
    -------
    object
        What `wrap` made of the rebound function.

    Examples
    --------
    >>> from clpt_control.blocks import words
    >>> def half(a):
    ...     return floor(a / 2)
    >>> half.__globals__["floor"] = words.floor
    >>> rebind(half, {"floor": lambda a: -1.0})(5.0)
    -1.0
    """
    assert isinstance(function, FunctionType)
    space = dict(function.__globals__)
    for name in function.__code__.co_names:
        value = space.get(name)
        word = getattr(value, "__name__", "")
        if value is None and name in substitutes:
            space[name] = substitutes[name]
        elif word in substitutes and (WORDS.get(word) is value or word == "math"):
            space[name] = substitutes[word]
        elif getattr(value, "__module__", None) == "math" and "math" in substitutes:
            space[name] = getattr(substitutes["math"], word or name)
    for name, helper in helpers_of(function).items():
        if opaque is not None and getattr(helper, "opaque", False):
            space[name] = opaque(helper)
        else:
            space[name] = rebind(helper, substitutes, wrap, opaque)
    rebound = FunctionType(function.__code__, space, function.__name__, function.__defaults__)
    rebound.__doc__, rebound.__module__ = function.__doc__, function.__module__
    return wrap(rebound)


@cache
def compiled(function: FunctionType) -> Callable:
    """Compile a block's equations, and their helpers, with Numba.

    Parameters
    ----------
    function : function
        ``f(t, x, u, p, out)`` as a block holds it.

    Returns
    -------
    callable
        The compiled function; NaN and infinity are values, not exceptions.

    Examples
    --------
    >>> from clpt_control.blocks import vehicle
    >>> rate = np.zeros(2)
    >>> compiled(vehicle.kinematics)(0.0, rate, np.array([1.0, 2, 3, 4]), (), rate)
    >>> rate
    array([4., 6.])
    """
    import numba

    jit = numba.njit(error_model="numpy")
    return rebind(function, {name: jit(word) for name, word in WORDS.items()}, jit)


def traced(function: Callable, t: Any, x: Any, u: Any, p: Any, size: int) -> np.ndarray:
    """Read a block's equations on symbols with SymPy.

    Parameters
    ----------
    function : function
        ``f(t, x, u, p, out)`` as a block holds it.
    t, x, u, p : symbols
        A symbol, two object arrays of symbols, and a NamedTuple of them.
    size : int
        Length of `out`.

    Returns
    -------
    ndarray
        The expressions left in `out`, dtype object.

    Examples
    --------
    >>> import sympy
    >>> from clpt_control.blocks import vehicle
    >>> u = np.array(sympy.symbols("F1 F2 v1 v2"), dtype=object)
    >>> traced(vehicle.kinematics, 0, None, u, None, 2)
    array([F1 + v1, F2 + v2], dtype=object)
    """
    import sympy

    out = np.full(size, sympy.Integer(0), dtype=object)
    rebind(function, symbolic_substitutes(), opaque=undefined)(t, x, u, p, out)
    return out


def undefined(helper: FunctionType) -> Callable:
    """Give the undefined function that stands for a helper.

    Examples
    --------
    >>> import sympy
    >>> def gust(t):
    ...     return 0.1
    >>> undefined(gust)(sympy.Symbol("t"))
    gust(t)
    """
    import sympy

    def stand_in(*arguments):
        return sympy.Function(helper.__name__)(
            *(a for a in arguments if isinstance(a, sympy.Basic | int | float))
        )

    return stand_in
