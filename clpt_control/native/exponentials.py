"""exp, log and their kin: polynomials and the bits of a double.

    exp(x) = 2^k exp(r),        k = round(x / ln 2), |r| <= ln(2)/2
    log(x) = k ln 2 + log(m),   x = 2^k m, m in [sqrt(1/2), sqrt(2)]

The coefficients interpolate (exp(r) - 1 - r)/r^2 and, with s = (m-1)/(m+1),
(log(m)/s - 2)/s^2 at Chebyshev nodes, computed with 60 digits; what the
polynomials leave out is below 2e-17.  ln 2 is subtracted in two parts.
"""

import math

from .vectors import (
    MAGIC,
    absolute,
    copysign,
    fma,
    nearest,
    odd,
    power_of_two,
    round_down,
    select,
    split,
    square_root,
    times_power_of_two,
)

LN2, LN2_LOW = 0.6931471805599453, 2.3190468138462996e-17
LOG2_E, LOG2_E_LOW = 1.4426950408889634, 2.0355273740931033e-17
LOG10_E, LOG10_E_LOW = 0.4342944819032518, 1.098319650216765e-17
TINY, HUGE = 2.2250738585072014e-308, 1.7976931348623157e308


def _reduced(a):
    """Return (k, r) with a = k ln 2 + r, k within what doubles can hold."""
    a = select(a > 710.0, 710.0, select(a < -746.0, -746.0, a))
    k = nearest(a * LOG2_E)
    return k, fma(-k, LN2_LOW, fma(-k, LN2, a))


def _exp_less_one(r):
    """Return exp(r) - 1 for |r| <= ln(2)/2; pairs of powers side by side."""
    z = r * r
    y = z * z
    c0 = fma(r, 0.16666666666666669, 0.5000000000000001)
    c1 = fma(r, 0.008333333333330039, 0.041666666666623824)
    c2 = fma(r, 0.00019841269863171557, 0.0013888888917367081)
    c3 = fma(r, 2.7557268276905696e-06, 2.4801521057868204e-05)
    c4 = fma(r, 2.5100472505694996e-08, 2.7620201591031547e-07)
    late = fma(y, c4, fma(z, c3, c2))
    return fma(z, fma(y, late, fma(z, c1, c0)), r)


def exp(a):
    """Return e^a."""
    a = select(a < -746.0, -746.0, a)
    a = select(a > 710.0, 710.0, a)
    k, half = fma(a, LOG2_E, MAGIC), fma(a, 0.5 * LOG2_E, MAGIC)
    r = fma(k - MAGIC, -LN2_LOW, fma(k - MAGIC, -LN2, a))
    return times_power_of_two(1.0 + _exp_less_one(r), k, half)


def expm1(a):
    """Return e^a - 1, accurate near 0."""
    k, r = _reduced(a)
    k = select(k > 1023.0, 1023.0, select(k < -60.0, -60.0, k))
    scale = power_of_two(k)
    value = fma(scale, _exp_less_one(r), scale - 1.0)
    return select(a > 709.0, exp(a), select(a < -40.0, -1.0, select(a == 0.0, a, value)))


def _split_log(a):
    """Return (k, log m) of a normal a > 0."""
    k, m = split(a)
    f = m - 1.0
    s = f / (2.0 + f)
    z = s * s
    q = fma(z, 0.14616721179861816, 0.15331699633543858)
    q = fma(z, q, 0.18182889786191042)
    q = fma(z, q, 0.2222221112572281)
    q = fma(z, q, 0.28571428626031065)
    q = fma(z, q, 0.3999999999989938)
    q = fma(z, q, 0.666666666666667)
    # log m = f - (f^2/2 - s (f^2/2 + z q)): only small terms are rounded
    half = 0.5 * f * f
    return k, f, half - s * fma(z, q, half)


def _where_log_is(a, value):
    """Return a logarithm, replaced where `a` is 0, infinite, negative or NaN."""
    value = select(a == math.inf, a, value)
    value = select(a == 0.0, -math.inf, value)
    return select(a >= 0.0, value, math.nan)


def _normal(a):
    """Return (a, shift), multiplied into the normal numbers by 2^-shift."""
    small = a < TINY
    return select(small, a * 18014398509481984.0, a), select(small, -54.0, 0.0)


def log(a):
    """Return the natural logarithm."""
    scaled, shift = _normal(a)
    k, f, less = _split_log(scaled)
    k = k + shift
    return _where_log_is(a, fma(k, LN2, f - fma(-k, LN2_LOW, less)))


def log2(a):
    """Return the logarithm to base 2, exact for powers of two."""
    scaled, shift = _normal(a)
    k, f, less = _split_log(scaled)
    m = f - less
    return _where_log_is(a, k + shift + fma(m, LOG2_E, m * LOG2_E_LOW))


def log10(a):
    """Return the logarithm to base 10."""
    value = log(a)
    return fma(value, LOG10_E, value * LOG10_E_LOW)


def log1p(a):
    """Return log(1 + a), accurate near 0."""
    u = 1.0 + a
    value = log(u) + (a - (u - 1.0)) / u
    return select((u == math.inf) | (u == 0.0), log(u), select(u == 1.0, a, value))


def _precise_log(a):
    """Return (log a, what its rounding left out) of a normal a > 0."""
    scaled, shift = _normal(a)
    k, f, less = _split_log(scaled)
    k = k + shift
    whole = k * LN2
    high = whole + f
    dropped = select(k == 0.0, 0.0, f - (high - whole)) + fma(k, LN2, -whole)
    less = fma(-k, LN2_LOW, less) - dropped
    value = high - less
    return _where_log_is(a, value), (high - value) - less


def power(a, b):
    """Return a^b; error about 2e-16 + 4e-17 |b log a|."""
    size = absolute(a)
    logarithm, rest = _precise_log(size)
    high = b * logarithm
    low = fma(b, logarithm, -high) + b * rest
    value = exp(high)
    value = select(absolute(low) < 1.0, fma(value, low, value), value)
    value = select(absolute(value) < math.inf, value, exp(high))
    whole = round_down(b) == b
    is_odd = whole & (absolute(b) < 4503599627370496.0) & odd(select(whole, b, 0.0))
    value = select((size == 1.0) & (absolute(b) == math.inf), 1.0, value)
    value = select(is_odd, copysign(value, a), value)
    negative = (a < 0.0) & (size < math.inf) & ~whole
    return select((b == 0.0) | (a == 1.0), 1.0, select(negative, math.nan, value))


def sinh(a):
    """Return the hyperbolic sine."""
    size = absolute(a)
    less = expm1(size)
    value = 0.5 * (less + less / (less + 1.0))
    root = exp(0.5 * size)
    return copysign(select(size > 700.0, 0.5 * root * root, value), a)


def cosh(a):
    """Return the hyperbolic cosine."""
    size = absolute(a)
    root = exp(0.5 * size)
    e = exp(size)
    return select(size > 700.0, 0.5 * root * root, 0.5 * (e + 1.0 / e))


def tanh(a):
    """Return the hyperbolic tangent."""
    size = absolute(a)
    less = expm1(select(size > 20.0, 40.0, 2.0 * size))
    value = select(size > 20.0, 1.0, less / (less + 2.0))
    return select(a == a, copysign(value, a), a)


def asinh(a):
    """Return the inverse hyperbolic sine."""
    size = absolute(a)
    square = size * size
    near = log1p(size + square / (1.0 + square_root(square + 1.0)))
    return copysign(select(size > 1e150, log(size) + LN2, near), a)


def acosh(a):
    """Return the inverse hyperbolic cosine."""
    less = a - 1.0
    near = log1p(less + square_root(less * (a + 1.0)))
    return select(a > 1e150, log(a) + LN2, select(a >= 1.0, near, math.nan))


def atanh(a):
    """Return the inverse hyperbolic tangent."""
    size = absolute(a)
    return copysign(0.5 * log1p(2.0 * size / (1.0 - size)), a)


def hypot(a, b):
    """Return sqrt(a^2 + b^2) without overflow between."""
    a, b = absolute(a), absolute(b)
    large = select(a > b, a, b)
    up = power_of_two(select(large > 1e150, -600.0, select(large < 1e-150, 600.0, 0.0)))
    down = power_of_two(select(large > 1e150, 600.0, select(large < 1e-150, -600.0, 0.0)))
    a_scaled, b_scaled = a * up, b * up
    value = square_root(fma(a_scaled, a_scaled, b_scaled * b_scaled)) * down
    return select((a == math.inf) | (b == math.inf), math.inf, value)
