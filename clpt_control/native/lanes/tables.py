"""Tables read lane by lane: each lane asks for an entry of its own.

The table is a float64 array that all lanes share, or a lane vector, of which
every lane reads its own column.  The index is a whole number held in a double.
An entry that does not exist (or is asked for with NaN) is NaN: nothing outside
the table is read.
"""

import operator

from llvmlite import ir
from numba.core import cgutils, types
from numba.core.typing.templates import AbstractTemplate, infer_global, signature
from numba.extending import lower_builtin
from numba.np import arrayobj

from .kinds import (
    DOUBLE,
    LANES,
    MASK,
    VECTOR,
    WORD,
    WORDS,
    LanesType,
    LaneVectorType,
    constant,
    lanes,
    repeat,
)


def _is_table(kind) -> bool:
    shared = isinstance(kind, types.Array) and kind.ndim == 1 and kind.dtype == types.float64
    return shared or isinstance(kind, LaneVectorType)


@infer_global(operator.getitem)
class _ReadTable(AbstractTemplate):
    def generic(self, args, kws):
        table, index = args
        if _is_table(table) and isinstance(index, LanesType):
            return signature(lanes, table, lanes)
        return None


def _gather(builder, index, data, size, stride, first=None):
    """Read a table of doubles lane by lane; NaN where there is no such entry.

    Entry i of lane k is ``first[k] + i stride`` bytes behind `data`.
    """
    tops, zero = repeat(builder, builder.sitofp(size, DOUBLE)), constant(0.0)
    from_end = builder.fadd(index, tops)
    index = builder.select(builder.fcmp_ordered("<", index, zero), from_end, index)
    inside = builder.and_(
        builder.fcmp_ordered(">=", index, zero), builder.fcmp_ordered("<", index, tops)
    )
    whole = builder.fptosi(builder.select(inside, index, zero), WORDS)
    start = repeat(builder, builder.ptrtoint(data, WORD), WORDS)
    address = builder.add(start, builder.mul(whole, repeat(builder, stride, WORDS)))
    if first is not None:
        address = builder.add(address, first)
    places = builder.inttoptr(address, ir.VectorType(DOUBLE.as_pointer(), LANES))
    kinds = (places.type, ir.IntType(32), MASK, VECTOR)
    function = cgutils.get_or_insert_function(
        builder.module, ir.FunctionType(VECTOR, kinds), "llvm.masked.gather.v8f64.v8p0"
    )
    missing = constant(float("nan"))
    return builder.call(function, (places, ir.Constant(ir.IntType(32), 8), inside, missing))


@lower_builtin(operator.getitem, types.Array, LanesType)
def _read_shared_table(context, builder, sig, args):
    table = arrayobj.make_array(sig.args[0])(context, builder, args[0])
    (size,), (stride,) = (
        cgutils.unpack_tuple(builder, part) for part in (table.shape, table.strides)
    )
    return _gather(builder, args[1], table.data, size, stride)


@lower_builtin(operator.getitem, LaneVectorType, LanesType)
def _read_own_table(context, builder, sig, args):
    table = cgutils.create_struct_proxy(sig.args[0])(context, builder, value=args[0])
    stride = ir.Constant(WORD, 8 * LANES)
    first = ir.Constant(WORDS, [8 * k for k in range(LANES)])
    return _gather(builder, args[1], table.data, table.size, stride, first)
