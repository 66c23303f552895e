"""Print the nests of a program as LLVM's code."""

from collections import Counter
from collections.abc import Callable, Sequence
from typing import Any

from llvmlite import ir

from ..record.graph import deep
from .fused_expressions import Write, row_strides
from .llvm_function import Function
from .machine import LANES
from .plan import Nest, Program
from .searches import SEARCHES
from .vectors import WORD, calculate, constant, elements, gathered, horizontal_sum, splat, width_of

UNROLLED, UNROLLED_RUNS = 4, 8  # the longest loop that unrolls: most loops, inner ones in lanes
CHAINS = ("exp", "sin", "cos")  # always inlined, where there are few
MOST_INLINED = 64  # calls of a function; LLVM takes minutes for thousands in one piece of code
ROWS = {"lookup": 1, "search": 1, "argmin": 0}  # which argument is a row
Key = tuple[int, tuple[int, ...], bool]  # component, loops of its axes, for eight iterations


def print_program(program: Program, names: tuple[str, ...], lanes: int) -> ir.Module:
    """Return a module of LLVM with some of a program's functions."""
    module, calls = ir.Module(), Counter(one.name for one in program.components)
    few = {one for one in CHAINS if calls[one] <= MOST_INLINED}
    with deep():
        for name in names:
            _Nests(module, name, lanes, program, few)
    for function in module.functions:
        name = function.name.partition(".")[0]
        if name in few or calls[name] > MOST_INLINED:
            function.attributes.add("alwaysinline" if name in few else "noinline")
    return module


class _Nests(Function):
    """A function's nests, printed one after the other.

    A value is printed when it is first used, at the beginning of the innermost of its loops.
    """

    def __init__(self, module: ir.Module, name: str, lanes: int, program: Program, few: set):
        super().__init__(module, name, lanes, program.constants)
        self.all, self.prepared = program.components, {} if name == "prepare" else program.prepared
        self.inline = few if name == "derivative" else set()
        self.saved: dict[int, int] = {}  # component -> its place in W, once it is written
        self.numbers: dict[Key, Any] = {}  # values outside all loops
        for nest in program.functions[name]:
            self.nest(nest)
        self.builder.ret_void()

    # --- nests ----------------------------------------------------------------------------

    def nest(self, nest: Nest) -> None:
        """Print a nest of loops, or what is outside all of them."""
        self.now, self.inner = nest, len(nest.lengths) - 1
        self.indices: list[Any] = [None] * len(nest.lengths)  # of each loop
        # of each loop: where an iteration begins, and values
        self.begins: list[Any] = [None] * (len(nest.lengths) + 1)
        self.values: list[dict[Key, Any]] = [{} for _ in self.begins]
        self.vector = nest.vector if nest.lengths and self.lanes == 1 else -1
        self.totals = [item for item in nest.items if item.summed]
        self.within(0, [])
        for item in nest.items:
            if item.saves >= 0 and item.strides:
                self.saved[item.saves] = item.first

    def read(self, c: int) -> tuple[str, int, tuple[int, ...]] | None:
        """Return array, first place and strides of a component that is read, else None."""
        name, arguments, lengths = self.all[c]
        if c in self.prepared:
            return "P", self.prepared[c], row_strides(lengths)
        if c in self.saved:
            return "W", self.saved[c], row_strides(lengths)
        return arguments[:3] if name == "load" else None

    def within(self, depth: int, sums: list) -> list:
        """Print what is within `depth` loops; return the sums over the innermost."""
        self.begins[depth], self.values[depth] = self.builder.block, {}
        if depth > self.inner:
            return self.items(sums)
        # iterations that are masked add zeros
        masked = depth == self.vector and self.now.lengths[depth] < LANES
        zero = None if masked else constant(0.0, self.width(self.vector >= 0))
        sums = self.print_loop(depth, [zero] * len(self.totals) if depth == self.inner else [])
        for total, value in zip(self.totals, sums, strict=False):
            self.write_sum(total, value)
        return []

    def print_loop(self, number: int, sums: list) -> list:
        """Print a loop; return the sums after it."""

        def body(index: Any, sums: list) -> list:
            self.indices[number] = index
            return self.within(number + 1, sums)

        count = self.now.lengths[number]
        if number == self.vector:
            return self.vector_loop(count, UNROLLED_RUNS if number else 1, body, sums)
        unrolled = UNROLLED if self.lanes == 1 else UNROLLED_RUNS
        return self.loop(range(count), unrolled, body, sums)

    def items(self, sums: list) -> list:
        """Print what an iteration of all loops writes and adds; return the sums."""
        loops, wide = tuple(range(self.inner + 1)), self.vector >= 0
        values, new = [self.argument(i.value, loops, wide) for i in self.now.items], list[Any]()
        for item, value in zip(self.now.items, values, strict=True):
            if item.summed:
                new.append(self.add_to(sums[len(new)], value))
            else:
                self.write(value, item)
        return new

    def write_sum(self, total: Write, value: Any) -> None:
        """Write a sum, or hold it as a number."""
        if self.vector == self.inner:
            value = horizontal_sum(self.builder, value, self.now.lengths[self.inner])
        if self.inner:
            self.write(value, total)
        else:
            self.numbers[total.saves, (), False] = value

    # --- values ---------------------------------------------------------------------------

    def width(self, wide: bool) -> int:
        """Return how many numbers a value is."""
        return LANES if wide else self.lanes

    def value(self, key: Key) -> Any:
        """Return a value; print it if it is new."""
        _, loops, wide = key
        depth = max(loops, default=-1) + 1
        known = self.values[depth] if depth or wide else self.numbers
        if key not in known:
            printer = self.printer(*key)
            with self.builder.goto_block(self.begins[depth]):
                known[key] = printer()
        return known[key]

    def printer(self, c: int, loops: tuple[int, ...], wide: bool) -> Callable[[], Any]:
        """Return a function that prints a value, whose arguments are printed by now."""
        builder, width = self.builder, self.width(wide)
        if wide and self.vector not in loops:
            narrow = self.value((c, loops, False))
            return lambda: splat(builder, narrow, width)
        if (read := self.read(c)) is not None:
            array, first, strides = read
            moves = self.moves(loops, strides, wide)
            return lambda: self.load(array, first, *moves)
        name, arguments, _ = self.all[c]
        if name in ROWS:
            row = self.all[arguments[ROWS[name]][0]].arguments[:4]
            place = self.argument(arguments[0], loops, wide) if ROWS[name] else None
            if name == "lookup":
                return lambda: self.lookup(place, *row)
            return lambda: self.found_in(name, width, row, place, *arguments[2:])
        values = [self.argument(a, loops, wide) for a in arguments]
        inline = bool(loops) and name in self.inline and type(self.indices[loops[-1]]) is not int
        self.chained |= inline
        return lambda: calculate(builder, name, width, values, inline)

    def argument(self, a: Any, loops: tuple[int, ...], wide: bool) -> Any:
        """Return an argument: a constant, or a computed value."""
        if type(a) is not tuple:
            return constant(a, self.width(wide))
        return self.value((a[0], tuple([loops[k] for k in a[1]]), wide))

    def moves(
        self, loops: Sequence[int], strides: tuple[int, ...], wide: bool
    ) -> tuple[list[tuple[Any, int]], int | None]:
        """Return index and stride of each loop, and the stride of eight iterations at once."""
        pairs = list(zip(loops, strides, strict=True))
        stride = sum(s for loop, s in pairs if loop == self.vector) if wide else None
        return [(self.indices[loop], s) for loop, s in pairs], stride

    def write(self, value: Any, item: Write) -> None:
        """Write a value, in an iteration of the inner loop or behind it."""
        array, first, strides, *_ = item
        wide = self.vector >= 0 and width_of(value) > 1
        self.store(value, array, first, *self.moves(range(len(strides)), strides, wide))

    def lookup(self, index: Any, array: str, first: int, stride: int, count: int) -> Any:
        """Read array[first + stride * index], NaN where there is no such entry."""
        builder, width = self.builder, width_of(index)

        def number(name: str, *arguments: Any) -> Any:
            return calculate(builder, name, width, arguments)

        place = number("place", index, float(count))
        inside = number("ge", place, 0.0)
        ones = []
        for k, one in enumerate(elements(builder, number("where", inside, place, 0.0))):
            address = self.address(array, first, [(builder.fptosi(one, WORD), stride)])
            if self.columns(array) > 1:
                address = builder.gep(address, [ir.Constant(WORD, k)])
            ones.append(builder.load(address))
        return number("where", inside, gathered(builder, ones), float("nan"))

    def found_in(self, name: str, width: int, row: tuple, value: Any, *more: float) -> Any:
        """Return a place in a row, for each number of a value or each lane, by a loop."""
        builder, (array, first, stride, count) = self.builder, row
        lanes, ones = self.columns(array), list[Any]()
        for k, one in enumerate([None] * width if value is None else elements(builder, value)):
            address = self.address(array, first)
            if lanes > 1:
                address = builder.gep(address, [ir.Constant(WORD, k)])
            given = [address, ir.Constant(WORD, stride * lanes), ir.Constant(WORD, count)]
            given += [] if one is None else [one, *(constant(m, 1) for m in more)]
            function = SEARCHES[name](builder.module)
            ones.append(builder.call(function, given))
        return gathered(builder, ones)
