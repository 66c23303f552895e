"""The call of machine code at an address, as Numba compiles it into the solver."""

from llvmlite import ir
from numba.core import types
from numba.extending import intrinsic


@intrinsic
def call_address(typingctx, address, t, X, first, P, T, W, D, to):
    """Call the function at an address with pointers into arrays, in compiled code."""
    signature = types.void(types.int64, t, X, types.int64, P, T, W, D, types.int64)

    def build(context, builder, signature, arguments):
        def pointer(k):
            return context.make_array(signature.args[k])(context, builder, arguments[k]).data

        double = ir.DoubleType().as_pointer()
        kind = ir.FunctionType(ir.VoidType(), [double] * 6).as_pointer()
        given = [
            pointer(1),
            builder.gep(pointer(2), [arguments[3]]),
            *(pointer(k) for k in (4, 5, 6)),
            builder.gep(pointer(7), [arguments[8]]),
        ]
        builder.call(builder.inttoptr(arguments[0], kind), given)
        return context.get_dummy_value()

    return signature, build
