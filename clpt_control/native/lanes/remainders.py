"""Python's `%`, `//` and `**` in lanes.

    a % b = a - b floor(a/b), with the sign of b

The quotient is rounded, so the difference (exact, by fused multiply-add) is
taken again until it is below |b|; a lane that is done does not change.
"""

import math
import operator

from numba.core import types
from numba.extending import overload

from .exponentials import power, whole_power
from .intrinsics import (
    absolute,
    any_lane,
    copysign,
    fma,
    round_down,
    round_to_zero,
    select,
    splat,
)
from .kinds import LanesType, jit
from .operators import is_laned, is_number


@jit
def remainder(a, b):
    """Give a % b as Python does; NaN where a/b overflows."""
    size = absolute(b)
    left = select(absolute(a) < math.inf, a, math.nan)
    going = (absolute(left) >= size) & (size > 0.0)
    while any_lane(going):
        left = select(going, fma(-round_to_zero(left / size), size, left), left)
        going = (absolute(left) >= size) & (size > 0.0)
    left = select(size > 0.0, left, math.nan)
    other_side = (left != 0.0) & ((left < 0.0) != (b < 0.0))
    return select(left == 0.0, copysign(0.0, b), select(other_side, left + b, left))


@jit
def quotient(a, b):
    """Give a // b as Python does."""
    ratio = (a - remainder(a, b)) / b
    whole = round_down(ratio)
    return select(ratio - whole > 0.5, whole + 1.0, whole)


@overload(operator.mod)
@overload(operator.imod)
def _mod(a, b):
    return _binary(a, b, lambda a, b: remainder(splat(a), splat(b)))


@overload(operator.floordiv)
@overload(operator.ifloordiv)
def _floordiv(a, b):
    return _binary(a, b, lambda a, b: quotient(splat(a), splat(b)))


@overload(operator.pow)
@overload(operator.ipow)
@overload(math.pow)
def _pow(a, b):
    if isinstance(a, LanesType) and isinstance(b, types.Integer):
        return lambda a, b: whole_power(a, b)
    return _binary(a, b, lambda a, b: power(splat(a), splat(b)))


def _binary(a, b, reading):
    """Give the reading where a lane is among the operands."""
    laned = (is_laned(a) or is_laned(b)) and is_number(a) and is_number(b)
    return reading if laned else None
