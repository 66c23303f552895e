"""LLVM code of a program's functions.

    void name(double *t, double *X, double *P, double *T, double *W, double *D)

With eight lanes, every array but T has eight columns, one for each run, and a loop does one
iteration at a time.  With one lane, a loop does eight iterations at once, the last ones with a
mask.  Its sums have eight partial sums, which are added in the same order on every processor, and
with eight lanes: a run has the same numbers in either form.  If an iteration is a long chain, such
as exp, two are printed at once.
"""

from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Sequence
from itertools import chain
from typing import Any

import numpy as np
from llvmlite import ir

from ..record.graph import deep
from .fused_expressions import Loops, Write
from .loop_nests import NO_LOOP, Body, Element, Key, LoopPrinter
from .machine import LANES
from .plan import Nest, Program
from .vectors import (
    BIT,
    DOUBLE,
    INT32,
    WORD,
    calculate,
    calculate_on_row,
    constant,
    declared,
    elements,
    gathered,
    horizontal_sum,
    splat,
    sum_of_parts,
    vector,
    width_of,
    word,
)

ARRAYS = ("t", "X", "P", "T", "W", "D")
UNROLLED = 4  # the longest loop of one run that unrolls
UNROLLED_RUNS = 8  # the longest inner loop, or loop of eight runs, that unrolls
CHAINS = ("exp", "sin", "cos")  # always inlined, where there are few
# calls of a function; LLVM takes minutes for thousands in one piece of code
MOST_INLINED = 64
SLOW = 5  # a root or a quotient takes as long as so many operations


def print_program(program: Program, names: tuple[str, ...], lanes: int) -> ir.Module:
    """Return a module of LLVM with some of a program's functions, for 1 or `LANES` runs."""
    module = ir.Module()
    calls = Counter(component.name for component in program.components)
    inlined = {name for name in CHAINS if calls[name] <= MOST_INLINED}
    with deep():
        for name in names:
            LLVMPrinter(module, name, lanes, program, inlined).print_function()
    for function in module.functions:
        name = function.name.partition(".")[0]
        if name in inlined:
            function.attributes.add("alwaysinline")
        elif calls[name] > MOST_INLINED:
            function.attributes.add("noinline")
    return module


class LLVMPrinter(LoopPrinter):
    """Printer of one function, for 1 run or `LANES` side by side."""

    def __init__(
        self,
        module: ir.Module,
        name: str,
        lanes: int,
        program: Program,
        inlined: set[str],
    ):
        super().__init__(
            program.components, {} if name == "prepare" else program.prepared
        )
        self.lanes = lanes
        self.active = LANES  # of eight iterations at once, those that the mask leaves
        # whether the current loop has a long chain of operations
        self.has_chain = False
        self.inlined = inlined if name == "derivative" else set()
        self.nests = program.functions[name]
        self.begins: dict[int, ir.Block] = {}  # first block inside so many loops
        self._declare(module, name, program.constants)

    def _declare(
        self, module: ir.Module, name: str, constants: Sequence[float]
    ) -> None:
        """Declare the function, its arrays and the array of constants, K."""
        pointer = DOUBLE.as_pointer()
        arguments = self.signature()
        signature = ir.FunctionType(ir.VoidType(), [*arguments.values()])
        function = ir.Function(module, signature, name)
        function.attributes.add("nounwind")
        # a register that is saved lies in one line of cache
        function.attributes.alignstack = 64
        self.arrays: dict[str, Any] = dict(zip(arguments, function.args, strict=True))
        for array, argument in self.arrays.items():
            argument.add_attribute("noalias")
            argument.name = array
        self.builder = ir.IRBuilder(function.append_basic_block())
        if not constants:
            return
        if "K" not in module.globals:
            # printed sooner than doubles
            numbers = bytearray(np.array(constants).tobytes())
            kind = ir.ArrayType(ir.IntType(8), len(numbers))
            table = ir.GlobalVariable(module, kind, "K")
            table.linkage = "internal"
            table.global_constant = True
            table.align = 8
            table.initializer = ir.Constant(kind, numbers)
        self.arrays["K"] = self.builder.bitcast(module.globals["K"], pointer)

    def signature(self) -> dict[str, ir.Type]:
        """Return names and types of the arguments."""
        return dict.fromkeys(ARRAYS, DOUBLE.as_pointer())

    def print_function(self) -> None:
        """Print the nests of the function."""
        for nest in self.nests:
            self.print_nest(nest)
        self.builder.ret_void()

    def print_nest(self, nest: Nest) -> None:
        """Print a nest of loops, one of which does eight iterations at once for one run."""
        has_vectors = nest.lengths and self.lanes == 1
        self.vector_loop = nest.vector if has_vectors else NO_LOOP
        super().print_nest(nest)

    def begin_body(self, depth: int) -> None:
        """Begin the statements inside `depth` loops."""
        self.begins[depth] = self.builder.block

    def insert(self, depth: int, key: Key, printer: Callable[[], Any]) -> Any:
        """Print a value at the beginning of the statements inside `depth` loops."""
        with self.builder.goto_block(self.begins[depth]):
            return printer()

    # --- arrays ---------------------------------------------------------------------------

    def columns(self, array: str) -> int:
        """Return how many runs an array holds side by side."""
        return 1 if array in "TK" else self.lanes

    def address(self, element: Element) -> Any:
        """Return the address of an element."""
        array, offset, terms, _ = element
        builder = self.builder
        position = None
        for index, stride in terms:
            if isinstance(index, int):
                offset += index * stride
                continue
            step = index
            if stride != 1:
                step = builder.mul(index, word(stride))
            position = step if position is None else builder.add(position, step)
        columns = self.columns(array)
        if position is None:
            return builder.gep(self.arrays[array], [word(offset * columns)])
        if offset:
            position = builder.add(position, word(offset))
        if columns > 1:
            position = builder.mul(position, word(columns))
        return builder.gep(self.arrays[array], [position])

    def load(self, element: Element) -> Any:
        """Read a number, or one for each run; or those of eight iterations."""
        builder = self.builder
        if element.apart not in (None, 1):
            scalars = [builder.load(address) for address in self._addresses(element)]
            inactive = scalars[:1] * (LANES - self.active)
            return gathered(builder, scalars + inactive)
        address = self.address(element)
        width = self.width(element.apart is not None)
        if element.apart is None and self.columns(element.array) == 1:
            return splat(builder, builder.load(address), width)
        address = builder.bitcast(address, vector(width).as_pointer())
        if element.apart is None or self.active == width:
            return builder.load(address, align=8)
        arguments = [address, ir.Constant(INT32, 8), self.mask(), constant(1.0, width)]
        return self._masked("load", vector(width), arguments)

    def store(self, value: Any, element: Element) -> None:
        """Write a number, or one for each run; or the numbers of eight iterations."""
        builder = self.builder
        if element.apart not in (None, 1):
            scalars = elements(builder, value)[: self.active]
            for scalar, address in zip(scalars, self._addresses(element), strict=True):
                builder.store(scalar, address)
            return
        address = builder.bitcast(self.address(element), value.type.as_pointer())
        if element.apart is None or self.active == LANES:
            builder.store(value, address, align=8)
            return
        arguments = [value, address, ir.Constant(INT32, 8), self.mask()]
        self._masked("store", ir.VoidType(), arguments)

    def _addresses(self, element: Element) -> Iterator[Any]:
        """Yield the address of the element in each active iteration."""
        for k in range(self.active):
            offset = element.offset + k * (element.apart or 0)
            yield self.address(element._replace(offset=offset))

    def _masked(self, name: str, result: ir.Type, arguments: list[Any]) -> Any:
        """Read or write the active iterations."""
        intrinsic = f"llvm.masked.{name}.v{LANES}f64.p0v{LANES}f64"
        types = [argument.type for argument in arguments]
        function = declared(self.builder.module, intrinsic, result, types)
        return self.builder.call(function, arguments)

    def mask(self) -> ir.Constant:
        """Return a truth value for each of eight iterations: is the iteration active?"""
        bits = [int(k < self.active) for k in range(LANES)]
        return ir.Constant(vector(LANES, BIT), bits)

    # --- loops ----------------------------------------------------------------------------

    def print_loop(self, depth: int, body: Body, totals: list[Write]) -> Iterable[Any]:
        """Print the loop inside `depth` others; return the sums after it."""
        count = self.current_nest.lengths[depth]
        if self.lanes > 1 and depth == self.current_nest.vector and totals:
            is_long = count > UNROLLED_RUNS
            printer = self._parts_in_memory if is_long else self._unrolled_parts
            partial_sums = printer(count, body, len(totals))
            return [
                sum_of_parts(self.builder, partial_sum, count)
                for partial_sum in partial_sums
            ]
        if depth != self.vector_loop:
            zero = constant(0.0, self.width(self.vector_loop >= 0))
            unrolled = UNROLLED if self.lanes == 1 else UNROLLED_RUNS
            return self._loop(range(count), unrolled, body, [zero] * len(totals))
        # iterations that are masked add zeros
        full = count // LANES * LANES
        zero = constant(0.0, LANES) if full else None
        unrolled = UNROLLED_RUNS if depth else 1
        sums = self._loop(range(0, full, LANES), unrolled, body, [zero] * len(totals))
        if count > full:
            self.active = count - full
            sums = body(full, sums)
            self.active = LANES
        return (horizontal_sum(self.builder, value, count) for value in sums)

    def _unrolled_parts(self, count: int, body: Body, sums: int) -> Iterable[Any]:
        """Print an unrolled loop of eight runs; return the eight partial sums of each sum."""
        zero = constant(0.0, self.lanes)
        starts = [None if count < LANES else zero] * sums
        iterations = [body(index, starts) for index in range(count)]
        iterations += [[zero] * sums] * (LANES - count)
        return zip(*iterations, strict=True)

    def _parts_in_memory(self, count: int, body: Body, sums: int) -> Iterable[Any]:
        """Print a loop of eight runs; return the eight partial sums of each sum.

        They are in memory: the code of an iteration does not depend on its partial sum.
        """
        builder = self.builder
        zero = constant(0.0, self.lanes)
        first = word(0)
        positions = [word(k) for k in range(LANES)]
        with builder.goto_entry_block():
            kind = ir.ArrayType(zero.type, LANES)
            arrays = [builder.alloca(kind) for _ in range(sums)]
        addresses = [
            [builder.gep(array, [first, position]) for position in positions]
            for array in arrays
        ]
        for address in chain(*addresses):
            builder.store(zero, address)

        def add_to_parts(index: Any, _: list) -> list:
            if type(index) is int:
                current = [of_sum[index % LANES] for of_sum in addresses]
            else:
                position = builder.and_(index, word(LANES - 1))
                current = [builder.gep(array, [first, position]) for array in arrays]
            totals = body(index, [builder.load(address) for address in current])
            for total, address in zip(totals, current, strict=True):
                builder.store(total, address)
            return []

        self._loop(range(count), UNROLLED_RUNS, add_to_parts, [])
        return [[builder.load(address) for address in of_sum] for of_sum in addresses]

    def add(self, total, value):
        """Return a sum with one more value, of the active iterations."""
        if self.active < LANES:
            value = self.builder.select(self.mask(), value, constant(0.0, LANES))
        return value if total is None else self.builder.fadd(total, value)

    def _loop(self, indices: range, unrolled: int, body: Body, sums: list) -> list:
        """Print a loop; return the sums after it.  One of at most `unrolled` iterations unrolls."""
        if len(indices) <= unrolled:
            for index in indices:
                sums = body(index, sums)
            return sums
        # begin the loop
        builder = self.builder
        before = builder.block
        inside = builder.append_basic_block()
        after = builder.append_basic_block()
        builder.branch(inside)
        builder.position_at_end(inside)
        index_phi = self.phi(word(indices.start), before)
        sum_phis = [self.phi(start, before) for start in sums]
        # print an iteration, or two side by side if it is a long chain
        self.has_chain = False
        results = body(index_phi, sum_phis)
        remaining = indices[:0]
        if self.has_chain and builder.block is inside:
            if len(indices) >= 4:
                second_index = builder.add(index_phi, word(indices.step))
                results = body(second_index, results)
                paired = len(indices) // 2 * 2
                remaining = indices[paired:]
                indices = indices[:paired:2]
            sort_by_start(inside)
        # end the loop
        next_index = builder.add(index_phi, word(indices.step))
        index_phi.add_incoming(next_index, builder.block)
        for phi, value in zip(sum_phis, results, strict=True):
            phi.add_incoming(value, builder.block)
        continues = builder.icmp_signed("<", next_index, word(indices.stop))
        builder.cbranch(continues, inside, after)
        builder.position_at_end(after)
        for index in remaining:
            results = body(index, results)
        return results

    def phi(self, value: Any, block: Any) -> Any:
        """Return a value that begins as that of a block."""
        node = self.builder.phi(value.type)
        node.add_incoming(value, block)
        return node

    # --- operations -----------------------------------------------------------------------

    def width(self, vectorized: bool) -> int:
        """Return how many numbers a value has."""
        return LANES if vectorized else self.lanes

    def number(self, value: float, vectorized: bool) -> Any:
        """Return a constant."""
        return constant(value, self.width(vectorized))

    def broadcast(self, scalar):
        """Return one number for each of eight iterations."""
        return splat(self.builder, scalar, LANES)

    def operation(self, name: str, loops: Loops, values: list) -> Any:
        """Return the result of an operation; a long chain in a loop is printed inline."""
        in_loop = bool(loops) and type(self.indices[loops[-1]]) is not int
        inline = in_loop and name in self.inlined
        self.has_chain |= inline
        return calculate(self.builder, name, width_of(values[0]), values, inline)

    def row_operation(self, name: str, row: tuple, values: list) -> Any:
        """Return the result of an operation on a row, for each number of a value or each lane."""
        array, offset, stride, count = row
        builder = self.builder
        columns = self.columns(array)
        width = width_of(values[0]) if values else self.lanes

        def number(name: str, *arguments: Any) -> Any:
            return calculate(builder, name, width, arguments)

        is_pick = name == "pick"
        if is_pick:
            position = number("place", values[0], float(count))
            inside = number("ge", position, 0.0)
            values = [number("where", inside, position, 0.0)]
        scalars = [elements(builder, value) for value in values]
        results = []
        for lane in range(width):
            numbers = [scalar[lane] for scalar in scalars]
            terms = [(builder.fptosi(numbers[0], WORD), stride)] if is_pick else []
            address = self.address(Element(array, offset, terms))
            if columns > 1:
                address = builder.gep(address, [word(lane)])
            if is_pick:
                results.append(builder.load(address))
                continue
            sizes = [word(size) for size in (stride * columns, count)]
            arguments = [address, *sizes, *numbers]
            results.append(calculate_on_row(builder, name, arguments))
        result = gathered(builder, results)
        if is_pick:  # NaN where there is no such element
            return number("where", inside, result, float("nan"))
        return result


def sort_by_start(block: ir.Block) -> None:
    """Sort operations of a block by the time when their arguments are known.

    The processor looks ahead a limited distance: long chains run at the same time only if their
    operations alternate.
    """
    ends: dict[int, int] = {}
    starts = {}
    for operation in block.instructions:
        start = max(
            (ends.get(id(argument), 0) for argument in operation.operands), default=0
        )
        is_root = operation.opname == "call" and "sqrt" in operation.callee.name
        slow = operation.opname == "fdiv" or is_root
        starts[id(operation)] = start
        ends[id(operation)] = start + (SLOW if slow else 1)
    block.instructions.sort(key=lambda operation: starts[id(operation)])
