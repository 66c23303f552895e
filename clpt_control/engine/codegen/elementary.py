"""Elementary functions of machine code: exp, log, sin, remainders, choices.

Each function is written in NumPy and traced into the primitives of `vectors`:

    exp(x) = 2^k exp(r),        k = round(x / ln 2), |r| <= ln(2)/2
    log(x) = k ln 2 + log(m),   x = 2^k m, m in [sqrt(1/2), sqrt(2)]
    sin, cos: x = n pi + r,     |r| <= pi/2

The polynomials interpolate at Chebyshev nodes, with an error below 2e-17: (exp(r) - 1 - r)/r^2,
(log(m)/s - 2)/s^2 with s = (m-1)/(m+1), (sin(r)/r - 1)/r^2 and (atan(r)/r - 1)/r^2.  ln 2 is
subtracted in two parts, pi in three (Cody and Waite).  The relative error of sin and cos is at most
2.3e-16 for |x| <= 1e5 and 5e-15 for |x| < 2^50.  Larger angles give NaN.
"""

from collections.abc import Callable
from functools import partial, reduce
from math import inf, nan
from typing import Any

import numpy as np

from ..trace.elementwise import elementwise, where

# 1.5 * 2^52: added to a whole number, it stands in the low bits
MAGIC = 6755399441055744.0
LN2 = 0.6931471805599453
LN2_LOW = 2.3190468138462996e-17
LOG2_E = 1.4426950408889634
TINY = 2.2250738585072014e-308

# coefficients of the highest power first
LOG = (
    0.14616721179861816,
    0.15331699633543858,
    0.18182889786191042,
    0.2222221112572281,
    0.28571428626031065,
    0.3999999999989938,
    0.666666666666667,
)
ATAN = (
    0.016282993238924487,
    -0.034568068014968874,
    0.0455149623749493,
    -0.052304330074828924,
    0.05878926110528101,
    -0.06666424634599337,
    0.07692296361048218,
    -0.09090908753017178,
    0.11111111105145725,
    -0.14285714285659729,
    0.19999999999999804,
    -0.3333333333333333,
)

# --- primitives -----------------------------------------------------------------------------

fma = partial(elementwise, "fma")
copysign = partial(elementwise, "copysign")
round_down = partial(elementwise, "round_down")  # to the largest whole number not above
round_to_zero = partial(elementwise, "round_to_zero")
times_power_of_two = partial(elementwise, "times_power_of_two")
negated_where_odd = partial(elementwise, "negated_where_odd")


def _polynomial(z, coefficients):
    return reduce(lambda q, c: fma(z, q, c), coefficients)


def power_of_two(k):
    """Return 2^k for whole numbers k in [-1022, 1023]."""
    return elementwise("power_of_two", k + (MAGIC + 1023.0))


# --- powers and logarithms --------------------------------------------------------------------


def _exp_less_one(r):
    """Return exp(r) - 1 for |r| <= ln(2)/2; pairs of powers side by side."""
    z = r * r
    y = z * z
    c0 = fma(r, 0.16666666666666669, 0.5000000000000001)
    c1 = fma(r, 0.008333333333330039, 0.041666666666623824)
    c2 = fma(r, 0.00019841269863171557, 0.0013888888917367081)
    c3 = fma(r, 2.7557268276905696e-06, 2.4801521057868204e-05)
    c4 = fma(r, 2.5100472505694996e-08, 2.7620201591031547e-07)
    high = fma(y, c4, fma(z, c3, c2))
    low = fma(z, c1, c0)
    return fma(z, fma(y, high, low), r)


def exp(a):
    """Return e^a."""
    k = fma(a, LOG2_E, MAGIC)
    half_k = fma(a, 0.5 * LOG2_E, MAGIC)
    r = fma(k - MAGIC, -LN2_LOW, fma(k - MAGIC, -LN2, a))
    value = times_power_of_two(1.0 + _exp_less_one(r), k, half_k)
    return where(a > 710.0, inf, where(a < -746.0, 0.0, value))


def _clipped(a, low, high):
    return where(a > high, high, where(a < low, low, a))


def expm1(a):
    """Return e^a - 1, accurate near 0."""
    inside = _clipped(a, -746.0, 710.0)
    k = (inside * LOG2_E + MAGIC) - MAGIC  # the nearest whole number
    r = fma(-k, LN2_LOW, fma(-k, LN2, inside))
    k = _clipped(k, -60.0, 1023.0)
    scale = power_of_two(k)
    value = fma(scale, _exp_less_one(r), scale - 1.0)
    return where(a > 709.0, exp(a), where(a < -40.0, -1.0, where(a == 0.0, a, value)))


def _split_log(a):
    """Return (k, log m), the latter in two parts, of a > 0."""
    small = a < TINY
    a = where(small, a * 18014398509481984.0, a)  # into the normal numbers
    exponent = elementwise("exponent", a) - float(2**52 + 1023)
    k = exponent + where(small, -54.0, 0.0)
    m = elementwise("fraction", a)
    f = m - 1.0
    s = f / (2.0 + f)
    z = s * s
    q = _polynomial(z, LOG)
    # log m = f - (f^2/2 - s (f^2/2 + z q)): only small terms are rounded
    half_square = 0.5 * f * f
    return k, f, half_square - s * fma(z, q, half_square)


def _where_log_is(a, value):
    """Return a logarithm, replaced where `a` is 0, infinite, negative or NaN."""
    value = where(a == inf, a, value)
    value = where(a == 0.0, -inf, value)
    return where(a >= 0.0, value, nan)


def log(a):
    """Return the natural logarithm."""
    k, f, less = _split_log(a)
    low = f - fma(-k, LN2_LOW, less)
    value = fma(k, LN2, low)
    return _where_log_is(a, value)


def _precise_log(a):
    """Return (log a, what its rounding left out)."""
    k, f, less = _split_log(a)
    multiple = k * LN2
    high = multiple + f
    sum_error = where(k == 0.0, 0.0, f - (high - multiple))
    dropped = sum_error + fma(k, LN2, -multiple)
    less = fma(-k, LN2_LOW, less) - dropped
    value = high - less
    return _where_log_is(a, value), (high - value) - less


def power(a, b):
    """Return a^b; error about 2e-16 + 4e-17 |b log a|."""
    size = abs(a)
    logarithm, log_error = _precise_log(size)
    high = b * logarithm
    low = fma(b, logarithm, -high) + b * log_error
    value = exp(high)
    value = where(abs(low) < 1.0, fma(value, low, value), value)
    value = where(abs(value) < inf, value, exp(high))
    is_whole = round_down(b) == b
    is_exact = is_whole & (abs(b) < 4503599627370496.0)
    is_odd = is_exact & (round_down(0.5 * b) != 0.5 * b)
    is_one = (size == 1.0) & (abs(b) == inf)
    value = where(is_one, 1.0, value)
    value = where(is_odd, copysign(value, a), value)
    negative = (a < 0.0) & (size < inf) & ~is_whole
    always_one = (b == 0.0) | (a == 1.0)
    return where(always_one, 1.0, where(negative, nan, value))


def tanh(a):
    """Return the hyperbolic tangent."""
    size = abs(a)
    less = expm1(where(size > 20.0, 40.0, 2.0 * size))
    value = where(size > 20.0, 1.0, less / (less + 2.0))
    return where(a == a, copysign(value, a), a)


def hypot(a, b):
    """Return sqrt(a^2 + b^2) without overflow between."""
    a = abs(a)
    b = abs(b)
    large = where(a > b, a, b)
    up = power_of_two(where(large > 1e150, -600.0, where(large < 1e-150, 600.0, 0.0)))
    down = power_of_two(where(large > 1e150, 600.0, where(large < 1e-150, -600.0, 0.0)))
    a_scaled = a * up
    b_scaled = b * up
    square = fma(a_scaled, a_scaled, b_scaled * b_scaled)
    value = np.sqrt(square) * down
    is_infinite = (a == inf) | (b == inf)
    return where(is_infinite, inf, value)


# --- circular functions ---------------------------------------------------------------------

ONE_OVER_PI = 0.3183098861837907
PI = 3.141592653589793
PI_MIDDLE = 1.2246467991473532e-16
PI_LOW = -2.9947698097183397e-33
HALF_PI = 1.5707963267948966
HALF_PI_MIDDLE = 6.123233995736766e-17
RANGE = 1125899906842624.0  # 2^50


def _sine(a, n):
    """Return sin(a - n pi), for n near a/pi."""
    r = fma(n, -PI_LOW, fma(n, -PI_MIDDLE, fma(n, -PI, a)))
    z = r * r
    y = z * z  # even and odd powers of z side by side
    even = fma(y, -7.643969663988074e-13, -2.505210761669045e-08)
    odds = fma(y, 2.7314368769379893e-15, 1.6058977292642743e-10)
    even = fma(y, even, -0.00019841269841254966)
    odds = fma(y, odds, 2.7557319219160833e-06)
    even = fma(y, even, -0.16666666666666666)
    odds = fma(y, odds, 0.008333333333333316)
    value = fma(r * z, fma(z, odds, even), r)
    value = where(value > 1.0, 1.0, value)  # which asin and sqrt refuse
    return where(value < -1.0, -1.0, value)


def sin(a):
    """Return the sine of an angle in radians: (-1)^n sin(a - n pi)."""
    n = fma(a, ONE_OVER_PI, MAGIC)
    value = where(a == 0.0, a, negated_where_odd(_sine(a, n - MAGIC), n))
    return where(abs(a) < RANGE, value, nan)


def cos(a):
    """Return the cosine of an angle in radians: -(-1)^n sin(a - (n + 1/2) pi)."""
    n = fma(a, ONE_OVER_PI, -0.5) + MAGIC
    value = negated_where_odd(_sine(a, (n - MAGIC) + 0.5), n + 1.0)
    return where(abs(a) < RANGE, value, nan)


def tan(a):
    """Return the tangent of an angle in radians."""
    return where(a == 0.0, a, sin(a) / cos(a))


def atan2(b, a):
    """Return the angle of the point (a, b), in [-pi, pi]."""
    rise_size = abs(b)
    run_size = abs(a)
    steep = rise_size > 2.414213562373095 * run_size
    middle = rise_size > 0.41421356237309503 * run_size
    # the angle from 0, pi/4 or pi/2 to the point
    rise = where(steep, -run_size, where(middle, rise_size - run_size, rise_size))
    run = where(steep, rise_size, where(middle, rise_size + run_size, run_size))
    base = where(steep, HALF_PI, where(middle, 0.5 * HALF_PI, 0.0))
    low = where(steep, HALF_PI_MIDDLE, where(middle, 0.5 * HALF_PI_MIDDLE, 0.0))
    ratio = rise / run
    corner = (rise_size == inf) & (run_size == inf)
    origin = (rise_size == 0.0) & (run_size == 0.0)
    ratio = where(corner | origin, 0.0, ratio)
    base = where(corner, 0.5 * HALF_PI, base)
    z = ratio * ratio
    q = _polynomial(z, ATAN)
    is_left = copysign(1.0, a) < 0.0  # of -0.0 too
    # pi - angle, with the parts of pi that double precision cuts off
    base = where(is_left, 2.0 * HALF_PI - base, base)
    low = where(is_left, 2.0 * HALF_PI_MIDDLE - low, low)
    ratio = where(is_left, -ratio, ratio)
    remainder_of_angle = ratio + fma(z * ratio, q, low)
    angle = base + remainder_of_angle
    return copysign(angle, b)


def atan(a):
    """Return the angle in [-pi/2, pi/2] whose tangent is `a`."""
    return atan2(a, where(a == a, 1.0, 1.0))


def asin(a):
    """Return the angle in [-pi/2, pi/2] whose sine is `a`."""
    return atan2(a, np.sqrt((1.0 - a) * (1.0 + a)))


def acos(a):
    """Return the angle in [0, pi] whose cosine is `a`."""
    return atan2(np.sqrt((1.0 - a) * (1.0 + a)), a)


# --- remainders and choices -----------------------------------------------------------------


def remainder(a, b):
    """Return a % b, with the sign of b."""
    rest_of_a = elementwise("rem", a, b)
    turned = where(opposite_signs(rest_of_a, b), rest_of_a + b, rest_of_a)
    return where(rest_of_a == 0.0, copysign(0.0, b), turned)


def quotient(a, b):
    """Return a // b."""
    rest_of_a = elementwise("rem", a, b)
    ratio = (a - rest_of_a) / b
    is_above = (rest_of_a != 0.0) & opposite_signs(rest_of_a, b)
    ratio = where(is_above, ratio - 1.0, ratio)
    result = round_down(ratio)
    result = where(ratio - result > 0.5, result + 1.0, result)
    result = where(ratio == 0.0, copysign(0.0, a / b), result)
    return where(b == 0.0, a / b, result)


def opposite_signs(a, b):
    """Return whether one of two numbers is below zero and the other is not."""
    any_negative = (a < 0.0) | (b < 0.0)
    both_negative = (a < 0.0) & (b < 0.0)
    return any_negative & ~both_negative


def minimum(a, b):
    """Return the smaller; NaN where one is NaN."""
    return where((a < b) | (a != a), a, b)


def maximum(a, b):
    """Return the larger; NaN where one is NaN."""
    return where((a > b) | (a != a), a, b)


def sign(a):
    """Return -1, 0 or 1."""
    return where(a > 0.0, 1.0, where(a < 0.0, -1.0, 0.0 * a)) + 0.0


def position_in_row(index, count):
    """Return the position of an index in a row of `count` numbers; -1 outside."""
    position = round_to_zero(index)
    position = where(position < 0.0, position + count, position)
    is_inside = (position >= 0.0) & (position < count)
    return where(is_inside, position, -1.0)


BY_NAME = (
    exp,
    expm1,
    log,
    tanh,
    hypot,
    sin,
    cos,
    tan,
    asin,
    acos,
    atan,
    atan2,
    minimum,
    maximum,
    sign,
)
FUNCTIONS: dict[str, Callable[..., Any]] = {
    **{function.__name__: function for function in BY_NAME},
    "place": position_in_row,
    "pow": power,
    "mod": remainder,
    "floordiv": quotient,
    "floor": round_down,
    "trunc": round_to_zero,
    "ceil": lambda a: -round_down(-a),
}
