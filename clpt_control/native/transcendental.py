"""exp, log, sin and their kin: polynomials and the bits of a double.

    exp(x) = 2^k exp(r),        k = round(x / ln 2), |r| <= ln(2)/2
    log(x) = k ln 2 + log(m),   x = 2^k m, m in [sqrt(1/2), sqrt(2)]
    sin, cos: x = n pi + r,     |r| <= pi/2
    tan: x = n pi/2 + (r + d),  |r| <= pi/4

The coefficients interpolate (exp(r) - 1 - r)/r^2, with s = (m-1)/(m+1) (log(m)/s - 2)/s^2, and
(sin(r)/r - 1)/r^2, (cos(r) - 1 + r^2/2)/r^4 and (atan(r)/r - 1)/r^2 in r^2, at Chebyshev nodes,
computed with 60 digits; what the polynomials leave out is below 2e-17.  ln 2 is subtracted in two
parts, pi in three (Cody and Waite) with fused multiply-add; the first difference is exact, and what
the second rounds off is kept in d.  sin and cos are within 2.3e-16 of the true value, relative, for
|x| <= 1e5 and within 5e-15 for |x| < 2^50, where doubles are a quarter of a radian apart.  Beyond
it an angle means nothing and gives NaN, in every reading.
"""

import math

from .vectors import (
    MAGIC,
    copysign,
    fma,
    nearest,
    negative_sign,
    odd,
    power_of_two,
    round_down,
    select,
    split,
    square_root,
    times_power_of_two,
    turned_where_odd,
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
    size = abs(a)
    logarithm, rest = _precise_log(size)
    high = b * logarithm
    low = fma(b, logarithm, -high) + b * rest
    value = exp(high)
    value = select(abs(low) < 1.0, fma(value, low, value), value)
    value = select(abs(value) < math.inf, value, exp(high))
    whole = round_down(b) == b
    is_odd = whole & (abs(b) < 4503599627370496.0) & odd(select(whole, b, 0.0))
    value = select((size == 1.0) & (abs(b) == math.inf), 1.0, value)
    value = select(is_odd, copysign(value, a), value)
    negative = (a < 0.0) & (size < math.inf) & ~whole
    return select((b == 0.0) | (a == 1.0), 1.0, select(negative, math.nan, value))


def sinh(a):
    """Return the hyperbolic sine."""
    size = abs(a)
    less = expm1(size)
    value = 0.5 * (less + less / (less + 1.0))
    root = exp(0.5 * size)
    return copysign(select(size > 700.0, 0.5 * root * root, value), a)


def cosh(a):
    """Return the hyperbolic cosine."""
    size = abs(a)
    root = exp(0.5 * size)
    e = exp(size)
    return select(size > 700.0, 0.5 * root * root, 0.5 * (e + 1.0 / e))


def tanh(a):
    """Return the hyperbolic tangent."""
    size = abs(a)
    less = expm1(select(size > 20.0, 40.0, 2.0 * size))
    value = select(size > 20.0, 1.0, less / (less + 2.0))
    return select(a == a, copysign(value, a), a)


def asinh(a):
    """Return the inverse hyperbolic sine."""
    size = abs(a)
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
    size = abs(a)
    return copysign(0.5 * log1p(2.0 * size / (1.0 - size)), a)


def hypot(a, b):
    """Return sqrt(a^2 + b^2) without overflow between."""
    a, b = abs(a), abs(b)
    large = select(a > b, a, b)
    up = power_of_two(select(large > 1e150, -600.0, select(large < 1e-150, 600.0, 0.0)))
    down = power_of_two(select(large > 1e150, 600.0, select(large < 1e-150, -600.0, 0.0)))
    a_scaled, b_scaled = a * up, b * up
    value = square_root(fma(a_scaled, a_scaled, b_scaled * b_scaled)) * down
    return select((a == math.inf) | (b == math.inf), math.inf, value)


# --- circular functions ---------------------------------------------------------------------

TWO_OVER_PI, ONE_OVER_PI = 0.6366197723675814, 0.3183098861837907
PI, PI_MIDDLE, PI_LOW = 3.141592653589793, 1.2246467991473532e-16, -2.9947698097183397e-33
HALF_PI, HALF_PI_MIDDLE = 1.5707963267948966, 6.123233995736766e-17
HALF_PI_LOW = -1.4973849048591698e-33
RANGE = 1125899906842624.0  # 2^50


def _quarters(a):
    """Return (n, r, d)."""
    a = select(abs(a) < RANGE, a, math.nan)
    n = nearest(a * TWO_OVER_PI)
    first = fma(-n, HALF_PI, a)
    middle = n * HALF_PI_MIDDLE
    r = first - middle
    d = fma(-n, HALF_PI_LOW, ((first - r) - middle) - fma(n, HALF_PI_MIDDLE, -middle))
    return n, r, d


def _both(r, d):
    """Return (sin, cos) of r + d."""
    z = r * r
    q = fma(z, 1.591810123027412e-10, -2.5051131455427946e-08)
    q = fma(z, q, 2.755731610068303e-06)
    q = fma(z, q, -0.0001984126983675497)
    q = fma(z, q, 0.008333333333330946)
    q = fma(z, q, -0.16666666666666666)
    # derivative of sin and cos at r, times d, to first order
    sine = r + fma(z * r, q, fma(-0.5 * z, d, d))
    c = fma(z, -1.1382614868556325e-11, 2.0876146024689747e-09)
    c = fma(z, c, -2.7557317270560326e-07)
    c = fma(z, c, 2.4801587298763433e-05)
    c = fma(z, c, -0.0013888888888887395)
    c = fma(z, c, 0.041666666666666664)
    half = 0.5 * z
    most = 1.0 - half
    cosine = most + (((1.0 - most) - half) + fma(z * z, c, -r * d))
    return sine, cosine


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
    return fma(r * z, fma(z, odds, even), r)


def sin(a):
    """Return the sine of an angle in radians: (-1)^n sin(a - n pi)."""
    n = fma(a, ONE_OVER_PI, MAGIC)
    value = select(a == 0.0, a, turned_where_odd(_sine(a, n - MAGIC), n, 0))
    return select(abs(a) < RANGE, value, math.nan)


def cos(a):
    """Return the cosine of an angle in radians: -(-1)^n sin(a - (n + 1/2) pi)."""
    n = fma(a, ONE_OVER_PI, -0.5) + MAGIC
    value = turned_where_odd(_sine(a, (n - MAGIC) + 0.5), n, 1)
    return select(abs(a) < RANGE, value, math.nan)


def tan(a):
    """Return the tangent of an angle in radians."""
    n, r, d = _quarters(a)
    sine, cosine = _both(r, d)
    turned = odd(n)
    value = select(turned, -cosine, sine) / select(turned, sine, cosine)
    return select(a == 0.0, a, value)


def atan2(b, a):
    """Return the angle of the point (a, b), in [-pi, pi]."""
    up, right = abs(b), abs(a)
    steep, middle = up > 2.414213562373095 * right, up > 0.41421356237309503 * right
    # the angle from 0, pi/4 or pi/2 to the point
    rise = select(steep, -right, select(middle, up - right, up))
    run = select(steep, up, select(middle, up + right, right))
    base = select(steep, HALF_PI, select(middle, 0.5 * HALF_PI, 0.0))
    low = select(steep, HALF_PI_MIDDLE, select(middle, 0.5 * HALF_PI_MIDDLE, 0.0))
    ratio = rise / run
    corner = (up == math.inf) & (right == math.inf)
    ratio = select(corner | ((up == 0.0) & (right == 0.0)), 0.0, ratio)
    base = select(corner, 0.5 * HALF_PI, base)
    z = ratio * ratio
    q = fma(z, 0.016282993238924487, -0.034568068014968874)
    q = fma(z, q, 0.0455149623749493)
    q = fma(z, q, -0.052304330074828924)
    q = fma(z, q, 0.05878926110528101)
    q = fma(z, q, -0.06666424634599337)
    q = fma(z, q, 0.07692296361048218)
    q = fma(z, q, -0.09090908753017178)
    q = fma(z, q, 0.11111111105145725)
    q = fma(z, q, -0.14285714285659729)
    q = fma(z, q, 0.19999999999999804)
    q = fma(z, q, -0.3333333333333333)
    left = negative_sign(a)
    # pi - angle, with the parts of pi that double precision cuts off
    base = select(left, 2.0 * HALF_PI - base, base)
    low = select(left, 2.0 * HALF_PI_MIDDLE - low, low)
    ratio = select(left, -ratio, ratio)
    angle = base + (ratio + fma(z * ratio, q, low))
    return copysign(angle, b)


def atan(a):
    """Return the angle in [-pi/2, pi/2] whose tangent is `a`."""
    return atan2(a, a.kind.number(1.0))


def asin(a):
    """Return the angle in [-pi/2, pi/2] whose sine is `a`."""
    return atan2(a, square_root((1.0 - a) * (1.0 + a)))


def acos(a):
    """Return the angle in [0, pi] whose cosine is `a`."""
    return atan2(square_root((1.0 - a) * (1.0 + a)), a)
