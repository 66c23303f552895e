"""The words and `math` in lanes, and the lane reading of a block's equations.

The words are written again with `select`, which also takes numbers that all
runs share.  Functions of `math` get a lane reading beside their own, so the
block's code stays as it is: what the operand is decides.
"""

import math
from collections.abc import Callable
from functools import cache
from types import FunctionType

from numba import njit
from numba.extending import overload

from ...blocks.readers import rebind
from . import circular, exponentials, memory, remainders, tables  # noqa: F401
from .intrinsics import (
    absolute,
    lane_get,
    lane_set,
    round_down,
    round_to_zero,
    select,
    splat,
    square_root,
)
from .kinds import LANES, jit
from .operators import is_laned, is_number


@jit
def where(condition, a, b):
    """Give `a` in the lanes where the condition holds, else `b`."""
    return select(condition, a, b)


@jit
def minimum(a, b):
    """Give the smaller of two numbers, lane by lane."""
    return select(a < b, a, b)


@jit
def maximum(a, b):
    """Give the larger of two numbers, lane by lane."""
    return select(a > b, a, b)


@jit
def clip(value, low, high):
    """Limit a number to the interval [low, high], lane by lane."""
    return select(value < low, low, select(value > high, high, value))


@jit
def sign(value):
    """Give the sign of a number: -1.0, 0.0 or 1.0, lane by lane."""
    return select(value > 0, 1.0, select(value < 0, -1.0, 0.0))


@jit
def floor(value):
    """Give the largest whole number not above `value`, lane by lane."""
    return round_down(value)


@jit
def lookup(table, index):
    """Read a table at a whole number given as a float, lane by lane."""
    return table[int(index)]


WORDS: dict[str, Callable] = {
    "where": where,
    "minimum": minimum,
    "maximum": maximum,
    "clip": clip,
    "sign": sign,
    "floor": floor,
    "lookup": lookup,
}


# --- builtins and math --------------------------------------------------------------------


@overload(float)
def _float(a):
    return (lambda a: splat(a)) if is_laned(a) else None


@overload(int)
def _int(a):
    # a whole number, still in lanes: an index, or a term of one
    return (lambda a: round_to_zero(splat(a))) if is_laned(a) else None


@jit
def _ceil(a):
    return -round_down(-a)


@jit
def _degrees(a):
    return a * (180.0 / math.pi)


@jit
def _radians(a):
    return a * (math.pi / 180.0)


UNARY = {
    "sqrt": square_root,
    "fabs": absolute,
    "ceil": _ceil,
    "floor": floor,
    "degrees": _degrees,
    "radians": _radians,
    **{
        name: getattr(exponentials, name)
        for name in (
            *("exp", "expm1", "log", "log1p", "log2", "log10"),
            *("sinh", "cosh", "tanh", "asinh", "acosh", "atanh"),
        )
    },
    **{name: getattr(circular, name) for name in ("sin", "cos", "tan", "asin", "acos", "atan")},
}
BINARY = {"atan2": circular.atan2, "hypot": exponentials.hypot}
LANE_BY_LANE = ("erf", "erfc")  # no polynomial here: the scalar function, eight times


def _each(function):
    """Make the reading that calls a scalar function for one lane after another."""

    @njit(error_model="numpy")
    def reading(a):
        for k in range(LANES):
            a = lane_set(a, k, function(lane_get(a, k)))
        return a

    return reading


def _read_unary(name, reading) -> None:
    @overload(getattr(math, name))
    def choose(a):
        return (lambda a: reading(splat(a))) if is_laned(a) else None


def _read_binary(name, reading) -> None:
    @overload(getattr(math, name))
    def choose(a, b):
        if (is_laned(a) or is_laned(b)) and is_number(a) and is_number(b):
            return lambda a, b: reading(splat(a), splat(b))
        return None


for _name, _reading in UNARY.items():
    _read_unary(_name, _reading)
for _name, _reading in BINARY.items():
    _read_binary(_name, _reading)
for _name in LANE_BY_LANE:
    _read_unary(_name, _each(getattr(math, _name)))


@cache
def lane_compiled(function: FunctionType) -> Callable:
    """Compile a block's equations, and their helpers, for lanes.

    Parameters
    ----------
    function : function
        ``f(t, x, u, p, out)`` as a block holds it.

    Returns
    -------
    callable
        For use in compiled code: `t` a number or lanes; `x`, `u` and `out`
        lane vectors; `p` the block's NamedTuple, each field a shared number or
        array, lanes, a lane vector or a lane matrix.

    Examples
    --------
    >>> import numba, numpy as np
    >>> from clpt_control.blocks import vehicle
    >>> from clpt_control.native.lanes import lane_compiled, lane_vector
    >>> kinematics = lane_compiled(vehicle.kinematics)
    >>> @numba.njit
    ... def rates(u, dx):
    ...     kinematics(0.0, lane_vector(dx), lane_vector(u), (), lane_vector(dx))
    >>> u, dx = np.arange(32.0).reshape(4, 8), np.zeros((2, 8))
    >>> rates(u, dx)
    >>> dx[0]
    array([16., 18., 20., 22., 24., 26., 28., 30.])
    """
    return rebind(function, WORDS, njit(error_model="numpy"))
