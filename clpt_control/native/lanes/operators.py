"""Arithmetic and comparisons in lanes, as LLVM vector instructions.

Every operation is the IEEE one, lane by lane: nothing is reassociated or
contracted, so a lane's result does not depend on its neighbours.
"""

import operator

from numba.core import types
from numba.core.typing.templates import AbstractTemplate, infer_global, signature
from numba.extending import lower_builtin

from .kinds import (
    SHARED,
    LaneMaskType,
    LanesType,
    constant,
    intrinsic_call,
    lane_mask,
    lanes,
)

ARITHMETIC = {
    (operator.add, operator.iadd): "fadd",
    (operator.sub, operator.isub): "fsub",
    (operator.mul, operator.imul): "fmul",
    (operator.truediv, operator.itruediv): "fdiv",
}
COMPARISONS = {
    operator.lt: "<",
    operator.le: "<=",
    operator.gt: ">",
    operator.ge: ">=",
    operator.eq: "==",
    operator.ne: "!=",
}
LOGIC = {operator.and_: "and_", operator.or_: "or_", operator.xor: "xor"}


def is_laned(kind) -> bool:
    """Tell whether a type is lanes or a mask."""
    return isinstance(kind, LanesType | LaneMaskType)


def is_number(kind) -> bool:
    """Tell whether a type is lanes or can be repeated over them."""
    return is_laned(kind) or (isinstance(kind, SHARED) and not isinstance(kind, types.Complex))


def _declare(function, result, operand, accepts) -> None:
    """Tell Numba the type of a binary operator."""

    class Template(AbstractTemplate):
        def generic(self, args, kws):
            if len(args) == 2 and any(map(is_laned, args)) and all(map(accepts, args)):
                return signature(result, operand, operand)
            return None

    Template.__name__ = f"Lanes_{function.__name__}"
    infer_global(function)(Template)


def _arithmetic(functions, instruction) -> None:
    for function in functions:
        _declare(function, lanes, lanes, is_number)

        @lower_builtin(function, LanesType, LanesType)
        def build(context, builder, sig, args):
            return getattr(builder, instruction)(*args)


def _comparison(function, symbol) -> None:
    _declare(function, lane_mask, lanes, is_number)

    @lower_builtin(function, LanesType, LanesType)
    def build(context, builder, sig, args):
        compare = builder.fcmp_unordered if symbol == "!=" else builder.fcmp_ordered
        return compare(symbol, *args)


def _logic(function, instruction) -> None:
    _declare(
        function,
        lane_mask,
        lane_mask,
        lambda kind: isinstance(kind, LaneMaskType | types.Boolean),
    )

    @lower_builtin(function, LaneMaskType, LaneMaskType)
    def build(context, builder, sig, args):
        return getattr(builder, instruction)(*args)


def _unary(function, operand, result, build) -> None:
    class Template(AbstractTemplate):
        def generic(self, args, kws):
            return signature(result, operand) if args == (operand,) else None

    Template.__name__ = f"Lanes_{function.__name__}"
    infer_global(function)(Template)
    lower_builtin(function, type(operand))(build)


def _negative(context, builder, sig, args):
    return builder.fneg(args[0])


def _absolute(context, builder, sig, args):
    return intrinsic_call(builder, "fabs", args[0])


def _itself(context, builder, sig, args):
    return args[0]


def _invert(context, builder, sig, args):
    return builder.xor(args[0], constant(1, args[0].type))


for _functions, _instruction in ARITHMETIC.items():
    _arithmetic(_functions, _instruction)
for _function, _symbol in COMPARISONS.items():
    _comparison(_function, _symbol)
for _function, _symbol in LOGIC.items():
    _logic(_function, _symbol)
_unary(operator.neg, lanes, lanes, _negative)
_unary(operator.pos, lanes, lanes, _itself)
_unary(operator.invert, lane_mask, lane_mask, _invert)
_unary(abs, lanes, lanes, _absolute)
