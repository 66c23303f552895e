"""What all functions in machine code share: arrays and loops.

    void name(double *t, double *X, double *P, double *T, double *W, double *D)

For eight runs side by side every array but T holds eight columns, a run in each, and loops take
one turn at a time.  For one run a loop takes eight turns at once, the last of them with a mask; a
sum over it is gathered in eight parts and then joined, in the same order on every processor.
"""

from collections.abc import Callable, Sequence
from typing import Any

from llvmlite import ir

from .machine import LANES
from .vectors import BIT, DOUBLE, INT32, WORD, apart, constant, declared, gathered, spread, vector

Moves = Sequence[tuple[Any, int]]  # turns of loops, and by how much each moves on
ARRAYS = ("t", "X", "P", "T", "W", "D")


class Function:
    """A function of the arrays that is being printed, for 1 run or `LANES` side by side."""

    def __init__(self, module: ir.Module, name: str, lanes: int, constants: Sequence[float] = ()):
        pointer = DOUBLE.as_pointer()
        function = ir.Function(module, ir.FunctionType(ir.VoidType(), [pointer] * 6), name)
        self.arrays: dict[str, Any] = {}
        for argument, array in zip(function.args, ARRAYS, strict=True):
            argument.add_attribute("noalias")
            argument.name = array
            self.arrays[array] = argument
        self.builder = ir.IRBuilder(function.append_basic_block())
        if constants:
            kind = ir.ArrayType(DOUBLE, len(constants))
            if "K" not in module.globals:
                table = ir.GlobalVariable(module, kind, "K")
                table.linkage, table.global_constant = "internal", True
                table.initializer = ir.Constant(kind, list(constants))
            zero = ir.Constant(INT32, 0)
            self.arrays["K"] = self.builder.gep(module.globals["K"], [zero, zero])
        self.lanes = lanes
        self.wide = self.turns = LANES  # turns that are taken at once, and how many there are

    # --- arrays ---------------------------------------------------------------------------

    def columns(self, array: str) -> int:
        """Return how many runs an array holds side by side."""
        return 1 if array in "TK" else self.lanes

    def address(self, array: str, first: int, moves: Moves = ()) -> Any:
        """Return where array[first + sum of turn * stride] lies."""
        builder, place = self.builder, None
        for turn, stride in moves:
            if isinstance(turn, int):
                first += turn * stride
                continue
            moved = turn if stride == 1 else builder.mul(turn, ir.Constant(WORD, stride))
            place = moved if place is None else builder.add(place, moved)
        if place is None:
            return builder.gep(self.arrays[array], [ir.Constant(WORD, first * self.columns(array))])
        if first:
            place = builder.add(place, ir.Constant(WORD, first))
        if self.columns(array) > 1:
            place = builder.mul(place, ir.Constant(WORD, self.columns(array)))
        return builder.gep(self.arrays[array], [place])

    def load(self, array: str, first: int, moves: Moves = (), stride: int | None = None) -> Any:
        """Read a number, or one for each run; or those of eight turns, a `stride` apart."""
        builder = self.builder
        if stride not in (None, 1):
            places = [first + k * stride for k in range(self.turns)]
            ones = [builder.load(self.address(array, place, moves)) for place in places]
            return gathered(builder, ones + ones[:1] * (self.wide - self.turns))
        address, width = self.address(array, first, moves), self.wide if stride else self.lanes
        if stride is None and self.columns(array) == 1:
            return spread(builder, builder.load(address), width)
        many = builder.bitcast(address, vector(width).as_pointer())
        if stride is None or self.turns == width:
            return builder.load(many, align=8)
        given = [many, ir.Constant(INT32, 8), self.valid(), constant(1.0, width)]
        return self._masked("load", vector(width), given)

    def store(
        self, value: Any, array: str, first: int, moves: Moves = (), stride: int | None = None
    ) -> None:
        """Write a number, or one for each run; or the numbers of eight turns."""
        builder = self.builder
        if stride not in (None, 1):
            for k, one in enumerate(apart(builder, value)[: self.turns]):
                builder.store(one, self.address(array, first + k * stride, moves))
            return
        address = builder.bitcast(self.address(array, first, moves), value.type.as_pointer())
        if stride is None or self.turns == self.wide:
            builder.store(value, address, align=8)
            return
        given = [value, address, ir.Constant(INT32, 8), self.valid()]
        self._masked("store", ir.VoidType(), given)

    def _masked(self, name: str, result: ir.Type, given: list[Any]) -> Any:
        """Read or write the turns that there are."""
        own = f"llvm.masked.{name}.v{self.wide}f64.p0v{self.wide}f64"
        types = [one.type for one in given]
        return self.builder.call(declared(self.builder.module, own, result, types), given)

    def valid(self) -> ir.Constant:
        """Return which turns of a round there are."""
        bits = [int(k < self.turns) for k in range(self.wide)]
        return ir.Constant(vector(self.wide, BIT), bits)

    def summed(self, held: Any, value: Any) -> Any:
        """Return what a sum is with one more value, of the turns that there are."""
        if self.turns < self.wide:
            value = self.builder.select(self.valid(), value, constant(0.0, self.wide))
        return value if held is None else self.builder.fadd(held, value)

    # --- loops ----------------------------------------------------------------------------

    def rounds(
        self, count: int, unrolled: int, turn: Callable[[Any, list], list], sums: list
    ) -> list:
        """Print a loop of several turns at once; return what sums are after it."""
        width = self.wide
        whole = count // width * width
        sums = self.loop(range(0, whole, width), unrolled, turn, sums)
        if count > whole:
            self.turns = count - whole
            sums = turn(whole, sums)
            self.turns = width
        return sums

    def loop(
        self, which: range, unrolled: int, turn: Callable[[Any, list], list], sums: list
    ) -> list:
        """Print a loop; return what sums are after it.  A short one is printed turn by turn."""
        if len(which) <= unrolled:
            for place in which:
                sums = turn(place, sums)
            return sums
        builder, before = self.builder, self.builder.block
        body, after = builder.append_basic_block(), builder.append_basic_block()
        builder.branch(body)
        builder.position_at_end(body)
        number = builder.phi(WORD)
        number.add_incoming(ir.Constant(WORD, which.start), before)
        held = []
        for first in sums:
            held.append(builder.phi(first.type))
            held[-1].add_incoming(first, before)
        turned = turn(number, held)
        following = builder.add(number, ir.Constant(WORD, which.step))
        number.add_incoming(following, builder.block)
        for phi, value in zip(held, turned, strict=True):
            phi.add_incoming(value, builder.block)
        more = builder.icmp_signed("<", following, ir.Constant(WORD, which.stop))
        builder.cbranch(more, body, after)
        builder.position_at_end(after)
        return turned
