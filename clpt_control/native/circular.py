"""sin, cos, tan and their inverses.

    x = n pi + r,  |r| <= pi/2         of sin and cos
    x = n pi/2 + (r + d),  |r| <= pi/4 of tan

pi is subtracted in three parts (Cody and Waite) with fused multiply-add; the first difference is
exact, and what the second rounds off is kept in d.  sin and cos are within 2.3e-16 of the true
value, relative, for |x| <= 1e5 and within 5e-15 for |x| < 2^50, where doubles are a quarter of a
radian apart.  Beyond it an angle means nothing and gives NaN, in every reading.

Coefficients as in `exponentials`: interpolants of (sin(r)/r - 1)/r^2,
(cos(r) - 1 + r^2/2)/r^4 and (atan(r)/r - 1)/r^2 in r^2.
"""

import math

from .vectors import (
    MAGIC,
    absolute,
    copysign,
    fma,
    nearest,
    negative_sign,
    odd,
    select,
    square_root,
    turned_where_odd,
)

TWO_OVER_PI, ONE_OVER_PI = 0.6366197723675814, 0.3183098861837907
PI, PI_MIDDLE, PI_LOW = 3.141592653589793, 1.2246467991473532e-16, -2.9947698097183397e-33
HALF_PI, HALF_PI_MIDDLE = 1.5707963267948966, 6.123233995736766e-17
HALF_PI_LOW = -1.4973849048591698e-33
RANGE = 1125899906842624.0  # 2^50


def _reduced(a):
    """Return (n, r, d)."""
    a = select(absolute(a) < RANGE, a, math.nan)
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
    return select(absolute(a) < RANGE, value, math.nan)


def cos(a):
    """Return the cosine of an angle in radians: -(-1)^n sin(a - (n + 1/2) pi)."""
    n = fma(a, ONE_OVER_PI, -0.5) + MAGIC
    value = turned_where_odd(_sine(a, (n - MAGIC) + 0.5), n, 1)
    return select(absolute(a) < RANGE, value, math.nan)


def tan(a):
    """Return the tangent of an angle in radians."""
    n, r, d = _reduced(a)
    sine, cosine = _both(r, d)
    turned = odd(n)
    value = select(turned, -cosine, sine) / select(turned, sine, cosine)
    return select(a == 0.0, a, value)


def atan2(b, a):
    """Return the angle of the point (a, b), in [-pi, pi]."""
    up, right = absolute(b), absolute(a)
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
