"""Arrays of lanes: their making, indices and slices.

A block's states, inputs and outputs are `LaneVector`s in lanes, its (2, N)
parameters `LaneMatrix`.  They are made inside compiled code from float64
arrays of shape (n, 8) and (m, n, 8), or, for signals that live inside one
function, with `lane_buffer`, which the compiler may keep in registers.
"""

import operator

from llvmlite import ir
from numba.core import cgutils, errors, types
from numba.core.typing.templates import AbstractTemplate, infer_global, signature
from numba.cpython import slicing
from numba.extending import lower_builtin, overload
from numba.np import arrayobj

from .kinds import (
    DOUBLE,
    LANES,
    VECTOR,
    LaneMatrixType,
    LanesType,
    LaneVectorType,
    intrinsic,
    lane_matrix_type,
    lane_vector_type,
    lanes,
)
from .operators import is_number

UNALIGNED = 8  # bytes: NumPy promises no more


def _view(context, builder, data, size, rows=None):
    """Build the struct of a vector or, with `rows`, of a matrix."""
    kind = lane_vector_type if rows is None else lane_matrix_type
    view = cgutils.create_struct_proxy(kind)(context, builder)
    view.data, view.size = data, size
    if rows is not None:
        view.rows = rows
    return view._getvalue()


def _opened(context, builder, kind, value):
    return cgutils.create_struct_proxy(kind)(context, builder, value=value)


def _from_array(dimensions):
    """Make the function that views an array of `dimensions` axes, the last one the lane."""

    def declared(typingctx, array):
        kind = types.unliteral(array)
        if not (isinstance(kind, types.Array) and kind.dtype == types.float64):
            return None
        if kind.ndim != dimensions or kind.layout != "C":
            raise errors.TypingError(
                f"lanes: a C-contiguous float64 array of {dimensions} axes is wanted, not {kind}"
            )

        def build(context, builder, sig, args):
            struct = arrayobj.make_array(kind)(context, builder, args[0])
            shape = cgutils.unpack_tuple(builder, struct.shape)
            rows = shape[0] if dimensions == 3 else None
            return _view(context, builder, struct.data, shape[dimensions - 2], rows)

        return (lane_vector_type if dimensions == 2 else lane_matrix_type)(array), build

    return declared


@intrinsic
def lane_vector(typingctx, array):
    """View an array of shape (n, 8) as n lanes.

    Parameters
    ----------
    array : ndarray, shape (n, 8)
        C-contiguous float64; the view does not keep it alive, so it should be
        an argument of the compiled function, not made inside it.

    Returns
    -------
    LaneVector
        ``v[i]`` is lanes, ``v[i] = a`` writes the array, ``v[a:b]`` is a view.
    """
    return _from_array(2)(typingctx, array)


@intrinsic
def lane_matrix(typingctx, array):
    """View an array of shape (m, n, 8) as m times n lanes.

    Parameters
    ----------
    array : ndarray, shape (m, n, 8)
        C-contiguous float64, kept alive by the caller.

    Returns
    -------
    LaneMatrix
        ``m[i, k]`` is lanes, ``m[i]`` a lane vector.
    """
    return _from_array(3)(typingctx, array)


@intrinsic(prefer_literal=True)
def lane_buffer(typingctx, n):
    """Give room for `n` lanes until the function returns.

    Parameters
    ----------
    n : int
        Written as a number in the code; what is small and indexed by numbers
        known at compile time may stay in registers.

    Returns
    -------
    LaneVector
        Holds nothing sensible until it is written.
    """
    if not isinstance(n, types.IntegerLiteral):
        return None
    size = n.literal_value

    def build(context, builder, sig, args):
        with builder.goto_entry_block():
            room = builder.alloca(ir.ArrayType(VECTOR, max(size, 1)))
            room.align = 8 * LANES
        data = builder.bitcast(room, DOUBLE.as_pointer())
        return _view(context, builder, data, context.get_constant(types.intp, size))

    return lane_vector_type(n), build


# --- indices ----------------------------------------------------------------------------


def _place(builder, data, index):
    """Give the address of the lanes with a number."""
    start = builder.mul(index, ir.Constant(index.type, LANES))
    return builder.bitcast(builder.gep(data, [start]), VECTOR.as_pointer())


def _counted(builder, index, size):
    """Count a negative index from the end."""
    below = builder.icmp_signed("<", index, ir.Constant(index.type, 0))
    return builder.select(below, builder.add(index, size), index)


def _is_pair(kind) -> bool:
    parts = getattr(kind, "types", ())
    return len(parts) == 2 and all(isinstance(part, types.Integer) for part in parts)


PAIR = types.UniTuple(types.intp, 2)


@infer_global(operator.getitem)
class _Read(AbstractTemplate):
    def generic(self, args, kws):
        view, index = args
        if isinstance(view, LaneVectorType):
            if isinstance(index, types.Integer):
                return signature(lanes, view, types.intp)
            if isinstance(index, types.SliceType) and not index.has_step:
                return signature(view, view, index)
        if isinstance(view, LaneMatrixType):
            if isinstance(index, types.Integer):
                return signature(lane_vector_type, view, types.intp)
            if _is_pair(index):
                return signature(lanes, view, PAIR)
        return None


@infer_global(operator.setitem)
class _Write(AbstractTemplate):
    def generic(self, args, kws):
        view, index, value = args
        if not is_number(value):
            return None
        if isinstance(view, LaneVectorType) and isinstance(index, types.Integer):
            return signature(types.none, view, types.intp, lanes)
        if isinstance(view, LaneMatrixType) and _is_pair(index):
            return signature(types.none, view, PAIR, lanes)
        return None


def _address(context, builder, kind, view, index):
    """Give the address of entry [index] or [row, column]."""
    opened = _opened(context, builder, kind, view)
    if isinstance(kind, LaneVectorType):
        return _place(builder, opened.data, _counted(builder, index, opened.size))
    row, column = cgutils.unpack_tuple(builder, index)
    start = builder.mul(_counted(builder, row, opened.rows), opened.size)
    return _place(builder, opened.data, builder.add(start, _counted(builder, column, opened.size)))


@lower_builtin(operator.getitem, LaneVectorType, types.Integer)
@lower_builtin(operator.getitem, LaneMatrixType, types.UniTuple)
def _read(context, builder, sig, args):
    return builder.load(_address(context, builder, sig.args[0], *args), align=UNALIGNED)


@lower_builtin(operator.setitem, LaneVectorType, types.Integer, LanesType)
@lower_builtin(operator.setitem, LaneMatrixType, types.UniTuple, LanesType)
def _write(context, builder, sig, args):
    address = _address(context, builder, sig.args[0], *args[:2])
    builder.store(args[2], address, align=UNALIGNED)


@lower_builtin(operator.getitem, LaneMatrixType, types.Integer)
def _row(context, builder, sig, args):
    matrix = _opened(context, builder, sig.args[0], args[0])
    first = builder.mul(_counted(builder, args[1], matrix.rows), matrix.size)
    start = builder.mul(first, ir.Constant(first.type, LANES))
    return _view(context, builder, builder.gep(matrix.data, [start]), matrix.size)


@lower_builtin(operator.getitem, LaneVectorType, types.SliceType)
def _slice(context, builder, sig, args):
    vector = _opened(context, builder, sig.args[0], args[0])
    part = context.make_helper(builder, sig.args[1], args[1])
    slicing.fix_slice(builder, part, vector.size)
    size = slicing.get_slice_length(builder, part)
    start = builder.mul(part.start, ir.Constant(part.start.type, LANES))
    return _view(context, builder, builder.gep(vector.data, [start]), size)


@overload(len)
def _length(view):
    if isinstance(view, LaneVectorType):
        return lambda view: view.size
    if isinstance(view, LaneMatrixType):
        return lambda view: view.rows
    return None
