"""What an integrator written in lanes needs beside arithmetic.

Repeat a number, choose, read and set one lane, ask a mask, round, and look at
the bits of a double.  All are functions for compiled code.
"""

from typing import Any

from llvmlite import ir
from numba.core import types

from .kinds import (
    LANES,
    VECTOR,
    WORDS,
    LaneMaskType,
    LanesType,
    constant,
    intrinsic,
    intrinsic_call,
    jit,
    lane_mask,
    lanes,
)
from .operators import is_laned, is_number

EVERY = 2**LANES - 1  # the bits of a mask that holds everywhere
MAGIC = 6755399441055744.0  # 1.5 * 2^52: added to a whole number, it stands in the low bits
MAGIC_BITS = 0x4338000000000000
ONE_BITS = 0x3FF0000000000000
HALF_ROOT_BITS = 0x3FE6A09E667F3BCD  # sqrt(1/2)
MANTISSA_BITS = 0x000FFFFFFFFFFFFF
TWO_52_BITS = 0x4330000000000000


@intrinsic(prefer_literal=False)
def splat(typingctx, value):
    """Repeat a number in every lane.

    Parameters
    ----------
    value : float, int, bool or Lanes
        Lanes stay as they are; a mask becomes 1.0 and 0.0.

    Returns
    -------
    Lanes
        The number, eight times.
    """
    if not is_number(value):
        return None
    return lanes(lanes), lambda context, builder, sig, args: args[0]


@intrinsic
def select(typingctx, condition, a, b):
    """Give `a` in the lanes where the condition holds, else `b`.

    Parameters
    ----------
    condition : LaneMask or bool
        A bool chooses for all lanes.
    a, b : Lanes, LaneMask or number
        Both are computed.

    Returns
    -------
    Lanes, LaneMask or number
        A number where nothing is in lanes.
    """
    if not isinstance(condition, LaneMaskType | types.Boolean):
        return None
    if not (is_number(a) and is_number(b)):
        return None
    if any(map(is_laned, (condition, a, b))):
        masks = all(isinstance(kind, LaneMaskType | types.Boolean) for kind in (a, b))
        kind = lane_mask if masks else lanes
        sig = kind(lane_mask, kind, kind)
    else:
        kind = typingctx.unify_types(types.unliteral(a), types.unliteral(b))
        sig = kind(types.boolean, kind, kind)
    return sig, lambda context, builder, sig, args: builder.select(*args)


@intrinsic
def lane_get(typingctx, value, k):
    """Give the number in lane `k`."""
    if not (is_laned(value) and isinstance(k, types.Integer)):
        return None
    result = types.float64 if isinstance(value, LanesType) else types.boolean

    def build(context, builder, sig, args):
        return builder.extract_element(*args)

    return result(value, types.intp), build


@intrinsic
def lane_set(typingctx, value, k, number):
    """Give the lanes with another number in lane `k`."""
    if not (is_laned(value) and isinstance(k, types.Integer)):
        return None
    entry = types.float64 if isinstance(value, LanesType) else types.boolean

    def build(context, builder, sig, args):
        return builder.insert_element(args[0], args[2], args[1])

    return value(value, types.intp, entry), build


@intrinsic
def mask_bits(typingctx, mask):
    """Give a mask as a whole number, lane k being bit k."""
    if not isinstance(mask, LaneMaskType):
        return None

    def build(context, builder, sig, args):
        return builder.zext(builder.bitcast(args[0], ir.IntType(LANES)), ir.IntType(64))

    return types.int64(mask), build


@intrinsic
def lane_numbers(typingctx):
    """Give the lanes 0, 1, ... 7."""
    return lanes(), lambda context, builder, sig, args: ir.Constant(
        VECTOR, [float(k) for k in range(LANES)]
    )


def _elementwise(name, count, text):
    """Make the function of an LLVM intrinsic that works lane by lane, or on one number."""

    def typed(typingctx, arguments):
        if not all(map(is_number, arguments)):
            return None
        laned = any(map(is_laned, arguments))
        kind = lanes if laned else types.float64

        def build(context, builder, sig, args):
            return intrinsic_call(builder, name, *args, suffix="v8f64" if laned else "f64")

        return kind(*[kind] * count), build

    def unary(typingctx, a):
        return typed(typingctx, (a,))

    def binary(typingctx, a, b):
        return typed(typingctx, (a, b))

    def ternary(typingctx, a, b, c):
        return typed(typingctx, (a, b, c))

    declared: Any = (unary, binary, ternary)[count - 1]
    declared.__name__ = declared.__qualname__ = name
    declared.__doc__ = text
    return intrinsic(declared)


fma = _elementwise("fma", 3, "Give a b + c, rounded once.")
copysign = _elementwise("copysign", 2, "Give `a` with the sign of `b`.")
nearest = _elementwise("roundeven", 1, "Give the nearest whole number, ties to even.")
round_down = _elementwise("floor", 1, "Give the largest whole number not above.")
round_to_zero = _elementwise("trunc", 1, "Give the whole number next towards zero.")
square_root = _elementwise("sqrt", 1, "Give the square root, correctly rounded.")
absolute = _elementwise("fabs", 1, "Give the absolute value.")


@intrinsic
def power_of_two(typingctx, k):
    """Give 2^k for whole numbers k in [-1022, 1023]."""

    def build(context, builder, sig, args):
        shifted = builder.fadd(args[0], constant(MAGIC + 1023.0))
        bits = builder.shl(builder.bitcast(shifted, WORDS), constant(52, WORDS))
        return builder.bitcast(bits, VECTOR)

    return lanes(lanes), build


@intrinsic
def odd(typingctx, k):
    """Tell which of the whole numbers are odd, for |k| < 2^51."""

    def build(context, builder, sig, args):
        bits = builder.bitcast(builder.fadd(args[0], constant(MAGIC)), WORDS)
        one = builder.and_(bits, constant(1, WORDS))
        return builder.icmp_unsigned("!=", one, constant(0, WORDS))

    return lane_mask(lanes), build


@intrinsic
def split(typingctx, a):
    """Give (k, m) with a = 2^k m and sqrt(1/2) <= m < sqrt(2), for normal a > 0."""

    def build(context, builder, sig, args):
        bits = builder.bitcast(args[0], WORDS)
        above = builder.add(
            builder.sub(bits, constant(HALF_ROOT_BITS, WORDS)), constant(ONE_BITS, WORDS)
        )
        k = builder.lshr(above, constant(52, WORDS))  # exponent + 1023
        number = builder.bitcast(builder.or_(k, constant(TWO_52_BITS, WORDS)), VECTOR)
        exponent = builder.fsub(number, constant(float(2**52 + 1023)))
        fraction = builder.and_(above, constant(MANTISSA_BITS, WORDS))
        m = builder.bitcast(builder.add(fraction, constant(HALF_ROOT_BITS, WORDS)), VECTOR)
        return context.make_tuple(builder, sig.return_type, (exponent, m))

    return types.UniTuple(lanes, 2)(lanes), build


@intrinsic
def negative_sign(typingctx, a):
    """Tell where the sign bit is set, of -0.0 and NaN too."""

    def build(context, builder, sig, args):
        return builder.icmp_signed("<", builder.bitcast(args[0], WORDS), constant(0, WORDS))

    return lane_mask(lanes), build


@jit
def any_lane(mask):
    """Tell whether the mask holds in any lane."""
    return mask_bits(mask) != 0


@jit
def all_lanes(mask):
    """Tell whether the mask holds in every lane."""
    return mask_bits(mask) == EVERY
