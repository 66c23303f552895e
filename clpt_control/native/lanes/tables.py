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


def _gather(builder, data, index, size, place):
    """Read doubles lane by lane; NaN where there is no such entry.

    ``place(whole)`` turns whole numbers into bytes behind `data`.
    """
    top = builder.sitofp(size, DOUBLE)
    inside = builder.and_(
        builder.fcmp_ordered(">=", index, repeat(builder, builder.fneg(top))),
        builder.fcmp_ordered("<", index, repeat(builder, top)),
    )
    whole = builder.fptosi(index, WORDS)  # undefined outside, where nothing is read
    from_end = builder.add(whole, repeat(builder, size, WORDS))
    below = builder.icmp_signed("<", whole, constant(0, WORDS))
    offsets = place(builder.select(below, from_end, whole))
    start = repeat(builder, builder.ptrtoint(data, WORD), WORDS)
    pointers = ir.VectorType(data.type, LANES)
    addresses = builder.inttoptr(builder.add(start, offsets), pointers)
    kinds = (pointers, ir.IntType(32), MASK, VECTOR)
    function = cgutils.get_or_insert_function(
        builder.module, ir.FunctionType(VECTOR, kinds), "llvm.masked.gather.v8f64.v8p0"
    )
    missing = constant(float("nan"))
    return builder.call(function, (addresses, ir.Constant(ir.IntType(32), 8), inside, missing))


@lower_builtin(operator.getitem, types.Array, LanesType)
def _read_shared_table(context, builder, sig, args):
    table = arrayobj.make_array(sig.args[0])(context, builder, args[0])
    (size,), (stride,) = (
        cgutils.unpack_tuple(builder, part) for part in (table.shape, table.strides)
    )
    steps = constant(8, WORDS) if sig.args[0].layout == "C" else repeat(builder, stride, WORDS)
    return _gather(builder, table.data, args[1], size, lambda whole: builder.mul(whole, steps))


@lower_builtin(operator.getitem, LaneVectorType, LanesType)
def _read_own_table(context, builder, sig, args):
    table = cgutils.create_struct_proxy(sig.args[0])(context, builder, value=args[0])
    columns = ir.Constant(WORDS, [8 * k for k in range(LANES)])
    row = constant(8 * LANES, WORDS)
    return _gather(
        builder,
        table.data,
        args[1],
        table.size,
        lambda whole: builder.add(builder.mul(whole, row), columns),
    )
