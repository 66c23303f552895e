"""The Numba types of a SIMD lane reading: eight runs in one register.

`Lanes` is LLVM's ``<8 x double>`` and `LaneMask` its ``<8 x i1>``.  A number
shared by all runs (float, int, bool) becomes lanes by being repeated, wherever
lanes are wanted; a variable that starts as 0.0 and gathers lanes is lanes.
`LaneVector` and `LaneMatrix` are views of ``(n, 8)`` and ``(m, n, 8)`` float64
memory, the last axis being the run; they own nothing, so whoever makes one
keeps the memory alive.
"""

from typing import Any

import numba.extending
from llvmlite import ir
from numba.core import cgutils, types
from numba.core.typeconv import Conversion
from numba.extending import lower_cast, make_attribute_wrapper, models, register_model

# typed loosely: what these make is called with other arguments than what they are given
intrinsic: Any = numba.extending.intrinsic
jit: Any = numba.njit(error_model="numpy", forceinline=True)

LANES = 8
DOUBLE, BIT, WORD = ir.DoubleType(), ir.IntType(1), ir.IntType(64)
VECTOR, MASK, WORDS = (ir.VectorType(kind, LANES) for kind in (DOUBLE, BIT, WORD))
SHARED = (types.Number, types.Boolean)  # what may be repeated over the lanes


class LanesType(types.Type):
    """Eight doubles, each of another run."""

    def __init__(self) -> None:
        super().__init__(name="Lanes")

    def unify(self, typingctx, other):
        """Give lanes for what is a number first and lanes later."""
        if isinstance(other, (*SHARED, LaneMaskType)) and not isinstance(other, types.Complex):
            return self
        return None

    def can_convert_from(self, typingctx, other):
        """Say that a shared number can be repeated."""
        return Conversion.safe if self.unify(typingctx, other) else None


class LaneMaskType(types.Type):
    """Eight answers, yes or no, each of another run."""

    def __init__(self) -> None:
        super().__init__(name="LaneMask")

    def unify(self, typingctx, other):
        """Give a mask for what is a bool first and a mask later."""
        return self if isinstance(other, types.Boolean) else None

    def can_convert_from(self, typingctx, other):
        """Say that a shared bool can be repeated."""
        return Conversion.safe if isinstance(other, types.Boolean) else None


class LaneVectorType(types.Type):
    """A view of n lanes in memory of shape (n, 8)."""

    def __init__(self) -> None:
        super().__init__(name="LaneVector")


class LaneMatrixType(types.Type):
    """A view of m times n lanes in memory of shape (m, n, 8)."""

    def __init__(self) -> None:
        super().__init__(name="LaneMatrix")


lanes, lane_mask = LanesType(), LaneMaskType()
lane_vector_type, lane_matrix_type = LaneVectorType(), LaneMatrixType()
pointer = types.CPointer(types.float64)


@register_model(LanesType)
class _LanesModel(models.PrimitiveModel):
    def __init__(self, manager, kind):
        super().__init__(manager, kind, VECTOR)


@register_model(LaneMaskType)
class _LaneMaskModel(models.PrimitiveModel):
    def __init__(self, manager, kind):
        super().__init__(manager, kind, MASK)


@register_model(LaneVectorType)
class _LaneVectorModel(models.StructModel):
    def __init__(self, manager, kind):
        super().__init__(manager, kind, [("data", pointer), ("size", types.intp)])


@register_model(LaneMatrixType)
class _LaneMatrixModel(models.StructModel):
    def __init__(self, manager, kind):
        members = [("data", pointer), ("rows", types.intp), ("size", types.intp)]
        super().__init__(manager, kind, members)


make_attribute_wrapper(LaneVectorType, "size", "size")
make_attribute_wrapper(LaneMatrixType, "size", "columns")
make_attribute_wrapper(LaneMatrixType, "rows", "rows")


def repeat(builder, value, kind=VECTOR):
    """Build the vector that holds one scalar in every lane."""
    empty = ir.Constant(kind, ir.Undefined)
    first = builder.insert_element(empty, value, ir.Constant(ir.IntType(32), 0))
    zeros = ir.Constant(ir.VectorType(ir.IntType(32), LANES), [0] * LANES)
    return builder.shuffle_vector(first, empty, zeros)


def constant(value, kind=VECTOR):
    """Give the constant vector that holds one number in every lane."""
    return ir.Constant(kind, [value] * LANES)


def intrinsic_call(builder, name, *values, suffix="v8f64"):
    """Build the call of an LLVM intrinsic such as ``llvm.fma``."""
    kind = ir.FunctionType(values[0].type, [value.type for value in values])
    function = cgutils.get_or_insert_function(builder.module, kind, f"llvm.{name}.{suffix}")
    return builder.call(function, values)


@lower_cast(types.Number, LanesType)
@lower_cast(types.Boolean, LanesType)
@lower_cast(types.IntegerLiteral, LanesType)
@lower_cast(types.BooleanLiteral, LanesType)
def _repeat_number(context, builder, fromty, toty, value):
    return repeat(builder, context.cast(builder, value, fromty, types.float64))


@lower_cast(types.Boolean, LaneMaskType)
@lower_cast(types.BooleanLiteral, LaneMaskType)
def _repeat_bool(context, builder, fromty, toty, value):
    return repeat(builder, context.cast(builder, value, fromty, types.boolean), MASK)


@lower_cast(LaneMaskType, LanesType)
def _mask_as_numbers(context, builder, fromty, toty, value):
    return builder.select(value, constant(1.0), constant(0.0))
