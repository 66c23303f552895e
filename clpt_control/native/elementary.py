"""exp, cos and sin without calls or branches, so that loops become vectors.

    exp(x) = 2^n exp(r),     n = round(x / ln 2),     |r| <= ln 2 / 2
    cos(x) = +-cos(r) or +-sin(r),  q = round(x 2 / pi),  r = x - q pi/2

n ln 2 and q pi/2 are taken off in two and three parts with fused multiply-add
(Cody and Waite, Software Manual for the Elementary Functions, 1980); what is
left goes through its Taylor polynomial, cut below 1e-17.  Errors stay within
1.5 units in the last place for exp, 2e-16 for cos and sin up to |x| of 1e9.
NaN and infinities pass as in `math`, but for cos and sin of infinity: NaN.
"""

import math
from fractions import Fraction

from numba import njit, types
from numba.extending import intrinsic

OPTIONS = {"error_model": "numpy", "fastmath": {"contract"}}
ROUNDER = 6755399441055744.0  # 1.5 * 2^52: adding it rounds to a whole number


@intrinsic
def fma(typingctx, a, b, c):
    """a b + c with one rounding."""

    def codegen(context, builder, signature, arguments):
        return builder.fma(*arguments)

    return types.float64(types.float64, types.float64, types.float64), codegen


@intrinsic
def bits(typingctx, a):
    """The 64 bits of a double as a whole number."""

    def codegen(context, builder, signature, arguments):
        return builder.bitcast(arguments[0], context.get_value_type(types.int64))

    return types.int64(types.float64), codegen


@intrinsic
def number(typingctx, a):
    """The double with these 64 bits."""

    def codegen(context, builder, signature, arguments):
        return builder.bitcast(arguments[0], context.get_value_type(types.float64))

    return types.float64(types.int64), codegen


def _parts(value: Fraction, count: int) -> list[float]:
    """Split a number into doubles that add up to it, largest first."""
    parts = []
    for _ in range(count):
        parts.append(float(value))
        value -= Fraction(parts[-1])
    return parts


PI = Fraction(3141592653589793238462643383279502884197169399375105820974944592307816406286, 10**75)
LN2 = Fraction(693147180559945309417232121458176568075500134360255254120680009493393621969, 10**75)
P1, P2, P3 = _parts(PI / 2, 3)
L1, L2 = _parts(LN2, 2)
PER_LN2, PER_RIGHT_ANGLE = float(1 / LN2), float(2 / PI)
E = tuple(1.0 / math.factorial(k) for k in range(14))
S = tuple((-1.0) ** k / math.factorial(2 * k + 1) for k in range(9))
C = tuple((-1.0) ** k / math.factorial(2 * k) for k in range(9))


@njit(**OPTIONS)
def exp(x):
    """Exponential of x."""
    held = x if x > -746.0 else -746.0
    held = held if held < 710.0 else 710.0
    shifted = fma(held, PER_LN2, ROUNDER)
    n = shifted - ROUNDER
    r = fma(-n, L2, fma(-n, L1, held))
    rr = r * r
    low = fma(rr, fma(rr, fma(E[5], r, E[4]), fma(E[3], r, E[2])), fma(E[1], r, E[0]))
    top = fma(rr, fma(rr, fma(E[11], r, E[10]), fma(E[9], r, E[8])), fma(E[7], r, E[6]))
    top = fma(rr * rr * rr, fma(E[13], r, E[12]), top)
    p = fma(rr * rr * rr, top, low)
    whole = bits(shifted) - bits(ROUNDER)
    half = whole >> 1
    scaled = p * number((half + 1023) << 52) * number((whole - half + 1023) << 52)
    return scaled if x == x else x


@njit(**OPTIONS)
def _turned(x, quarter):
    """cos(x - quarter pi/2)."""
    shifted = fma(x, PER_RIGHT_ANGLE, ROUNDER)
    q = shifted - ROUNDER
    r = fma(-q, P3, fma(-q, P2, fma(-q, P1, x)))
    rr = r * r
    r4 = rr * rr
    sine = fma(r4, fma(r4, fma(S[7], rr, S[6]), fma(S[5], rr, S[4])), fma(S[3], rr, S[2]))
    sine = fma(r4 * r4 * r4, S[8], sine)
    sine = fma(r * rr, fma(rr, sine, S[1]), r)
    cosine = fma(r4, fma(r4, fma(C[8], rr, C[7]), fma(C[6], rr, C[5])), fma(C[4], rr, C[3]))
    cosine = fma(r4, fma(rr, cosine, C[2]), fma(rr, C[1], 1.0))
    turn = bits(shifted) - quarter
    value = sine if turn & 1 else cosine
    return -value if (turn + 1) & 2 else value


@njit(**OPTIONS)
def cos(x):
    """Cosine of x."""
    return _turned(x, 0)


@njit(**OPTIONS)
def sin(x):
    """Sine of x."""
    return _turned(x, 1)
