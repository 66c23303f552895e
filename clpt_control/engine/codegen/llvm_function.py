"""What all functions in machine code share: arrays and loops.

    void name(double *t, double *X, double *P, double *T, double *W, double *D)

For eight runs side by side every array but T holds eight columns, a run in each, and a loop does
one iteration at a time.  For one run a loop does eight iterations at once, the last ones with a
mask; its sums have eight parts, which are added in the same order on every processor.  Where an
iteration is a long chain, such as exp, two are printed at once.
"""

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from llvmlite import ir

from .machine import LANES
from .vectors import BIT, DOUBLE, INT32, WORD, constant, declared, elements, gathered, splat, vector

Moves = Sequence[tuple[Any, int]]  # the indices of loops, each with its stride
Body = Callable[[Any, list], list]  # prints an iteration: index, sums before it -> sums after it
SLOW = 5  # a root or a quotient takes as long as so many operations
ARRAYS = ("t", "X", "P", "T", "W", "D")


class Function:
    """A function of the arrays that is being printed, for 1 run or `LANES` side by side."""

    def __init__(self, module: ir.Module, name: str, lanes: int, constants: Sequence[float] = ()):
        pointer = DOUBLE.as_pointer()
        function = ir.Function(module, ir.FunctionType(ir.VoidType(), [pointer] * 6), name)
        function.attributes.add("nounwind")
        function.attributes.alignstack = 64  # a register that is saved lies in one line of cache
        self.arrays: dict[str, Any] = {}
        for argument, array in zip(function.args, ARRAYS, strict=True):
            argument.add_attribute("noalias")
            argument.name = array
            self.arrays[array] = argument
        self.builder = ir.IRBuilder(function.append_basic_block())
        if constants:
            if "K" not in module.globals:
                numbers = bytearray(np.array(constants).tobytes())  # printed sooner than doubles
                kind = ir.ArrayType(ir.IntType(8), len(numbers))
                table = ir.GlobalVariable(module, kind, "K")
                table.linkage, table.global_constant, table.align = "internal", True, 8
                table.initializer = ir.Constant(kind, numbers)
            self.arrays["K"] = self.builder.bitcast(module.globals["K"], pointer)
        self.lanes = lanes
        self.chained = False  # whether a long chain of operations was printed
        self.active = LANES  # iterations of those at once that the mask leaves

    # --- arrays ---------------------------------------------------------------------------

    def columns(self, array: str) -> int:
        """Return how many runs an array holds side by side."""
        return 1 if array in "TK" else self.lanes

    def address(self, array: str, first: int, moves: Moves = ()) -> Any:
        """Return the address of array[first + sum of index * stride]."""
        builder, place = self.builder, None
        for index, stride in moves:
            if isinstance(index, int):
                first += index * stride
                continue
            step = index if stride == 1 else builder.mul(index, ir.Constant(WORD, stride))
            place = step if place is None else builder.add(place, step)
        if place is None:
            return builder.gep(self.arrays[array], [ir.Constant(WORD, first * self.columns(array))])
        if first:
            place = builder.add(place, ir.Constant(WORD, first))
        if self.columns(array) > 1:
            place = builder.mul(place, ir.Constant(WORD, self.columns(array)))
        return builder.gep(self.arrays[array], [place])

    def load(self, array: str, first: int, moves: Moves = (), stride: int | None = None) -> Any:
        """Read a number, or one for each run; or those of eight iterations, a `stride` apart."""
        builder = self.builder
        if stride not in (None, 1):
            places = [first + k * stride for k in range(self.active)]
            ones = [builder.load(self.address(array, place, moves)) for place in places]
            return gathered(builder, ones + ones[:1] * (LANES - self.active))
        address, width = self.address(array, first, moves), LANES if stride else self.lanes
        if stride is None and self.columns(array) == 1:
            return splat(builder, builder.load(address), width)
        many = builder.bitcast(address, vector(width).as_pointer())
        if stride is None or self.active == width:
            return builder.load(many, align=8)
        arguments = [many, ir.Constant(INT32, 8), self.mask(), constant(1.0, width)]
        return self._masked("load", vector(width), arguments)

    def store(
        self, value: Any, array: str, first: int, moves: Moves = (), stride: int | None = None
    ) -> None:
        """Write a number, or one for each run; or the numbers of eight iterations."""
        builder = self.builder
        if stride not in (None, 1):
            for k, one in enumerate(elements(builder, value)[: self.active]):
                builder.store(one, self.address(array, first + k * stride, moves))
            return
        address = builder.bitcast(self.address(array, first, moves), value.type.as_pointer())
        if stride is None or self.active == LANES:
            builder.store(value, address, align=8)
            return
        arguments = [value, address, ir.Constant(INT32, 8), self.mask()]
        self._masked("store", ir.VoidType(), arguments)

    def _masked(self, name: str, result: ir.Type, arguments: list[Any]) -> Any:
        """Read or write the active iterations."""
        intrinsic = f"llvm.masked.{name}.v{LANES}f64.p0v{LANES}f64"
        types = [one.type for one in arguments]
        return self.builder.call(declared(self.builder.module, intrinsic, result, types), arguments)

    def mask(self) -> ir.Constant:
        """Return for each of the iterations at once whether it is active."""
        bits = [int(k < self.active) for k in range(LANES)]
        return ir.Constant(vector(LANES, BIT), bits)

    def add_to(self, total: Any, value: Any) -> Any:
        """Return a sum with one more value, of the active iterations."""
        if self.active < LANES:
            value = self.builder.select(self.mask(), value, constant(0.0, LANES))
        return value if total is None else self.builder.fadd(total, value)

    # --- loops ----------------------------------------------------------------------------

    def vector_loop(self, count: int, unrolled: int, body: Body, sums: list) -> list:
        """Print a loop of several iterations at once; return the sums after it."""
        whole = count // LANES * LANES
        sums = self.loop(range(0, whole, LANES), unrolled, body, sums)
        if count > whole:
            self.active = count - whole
            sums = body(whole, sums)
            self.active = LANES
        return sums

    def loop(self, indices: range, unrolled: int, body: Body, sums: list) -> list:
        """Print a loop; return the sums after it.  One of at most `unrolled` iterations unrolls."""
        if len(indices) <= unrolled:
            for place in indices:
                sums = body(place, sums)
            return sums
        builder, before = self.builder, self.builder.block
        inside, after = builder.append_basic_block(), builder.append_basic_block()
        builder.branch(inside)
        builder.position_at_end(inside)
        index = builder.phi(WORD)
        index.add_incoming(ir.Constant(WORD, indices.start), before)
        phis = []
        for first in sums:
            phis.append(builder.phi(first.type))
            phis[-1].add_incoming(first, before)
        self.chained = False
        results, left = body(index, phis), indices[:0]
        if self.chained and builder.block is inside:
            if len(indices) >= 4:
                results = body(builder.add(index, ir.Constant(WORD, indices.step)), results)
                pairs = len(indices) // 2 * 2
                left, indices = indices[pairs:], indices[:pairs:2]
            spread(inside)
        following = builder.add(index, ir.Constant(WORD, indices.step))
        index.add_incoming(following, builder.block)
        for phi, value in zip(phis, results, strict=True):
            phi.add_incoming(value, builder.block)
        more = builder.icmp_signed("<", following, ir.Constant(WORD, indices.stop))
        builder.cbranch(more, inside, after)
        builder.position_at_end(after)
        for place in left:
            results = body(place, results)
        return results


def spread(block: ir.Block) -> None:
    """Put operations of a block in the order in which their arguments are known.

    The processor looks only so far ahead: long chains run side by side if they stand so.
    """
    known: dict[int, int] = {}
    begins: dict[int, int] = {}
    for one in block.instructions:
        begins[id(one)] = max((known.get(id(a), 0) for a in one.operands), default=0)
        slow = one.opname == "fdiv" or (one.opname == "call" and "sqrt" in one.callee.name)
        known[id(one)] = begins[id(one)] + (SLOW if slow else 1)
    block.instructions.sort(key=lambda one: begins[id(one)])
