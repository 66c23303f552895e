"""Print the nests of a program as LLVM's code."""

from collections.abc import Callable, Sequence
from typing import Any

from llvmlite import ir

from .components import Write, deep, rows
from .machine import LANES
from .plan import Nest, Program
from .printing import Function
from .vectors import WORD, apart, called, constant, gathered, joined, spread, width_of

UNROLLED, UNROLLED_RUNS = 4, 8  # turns that are printed one by one: of most loops, of inner ones
ABREAST = 4  # of those, how many are worked on at once
Key = tuple[int, tuple[int, ...], bool]  # component, loops that its axes are, for eight turns


def print_program(program: Program, names: tuple[str, ...], lanes: int) -> ir.Module:
    """Return a module of LLVM with some of a program's functions."""
    module = ir.Module()
    with deep():
        for name in names:
            _Nests(module, name, lanes, program)
    return module


class _Nests(Function):
    """A function's nests, printed one after the other.

    A value is printed when it is first asked for, where the innermost of its loops begins a turn.
    """

    def __init__(self, module: ir.Module, name: str, lanes: int, program: Program):
        super().__init__(module, name, lanes, program.constants)
        self.all, self.prepared = program.components, {} if name == "prepare" else program.prepared
        self.saved: dict[int, int] = {}  # what lies in W by now
        self.numbers: dict[Key, list] = {}  # what is outside all loops
        for nest in program.functions[name]:
            self.nest(nest)
        self.builder.ret_void()

    # --- nests ----------------------------------------------------------------------------

    def nest(self, nest: Nest) -> None:
        """Print a nest of loops, or what is outside all of them."""
        self.now, self.inner = nest, len(nest.lengths) - 1
        self.places: list[Any] = [None] * len(nest.lengths)  # the turn of each loop
        # of each loop: where a turn begins, and its values, of each turn that is worked on at once
        self.begins: list[Any] = [None] * (len(nest.lengths) + 1)
        self.values: list[dict[Key, list]] = [{} for _ in self.begins]
        self.vector = nest.vector if nest.lengths and self.lanes == 1 else -1
        if self.vector >= 0:
            few = nest.lengths[self.vector] <= LANES // 2
            self.wide = self.turns = LANES // 2 if few else LANES
        self.totals = [item for item in nest.items if item.summed]
        self.within(0, [])
        for item in nest.items:
            if item.saves >= 0 and item.strides:
                self.saved[item.saves] = item.first

    def read(self, c: int) -> tuple[str, int, tuple[int, ...]] | None:
        """Return array, first place and strides of a component that is read."""
        name, arguments, lengths = self.all[c]
        if c in self.prepared:
            return "P", self.prepared[c], rows(lengths)
        if c in self.saved:
            return "W", self.saved[c], rows(lengths)
        return arguments[:3] if name == "load" else None

    def within(self, depth: int, sums: list) -> list:
        """Print what is within so many loops; return the sums over the last."""
        self.begins[depth], self.values[depth] = self.builder.block, {}
        if depth > self.inner:
            return self.items(sums)
        # zeros are among what is masked
        masked = depth == self.vector and self.now.lengths[depth] < self.wide
        zero = None if masked else constant(0.0, self.width(self.vector >= 0))
        found = self.turned(depth, [zero] * len(self.totals) if depth == self.inner else [])
        for total, value in zip(self.totals, found, strict=False):
            self.finish(total, value)
        return []

    def turned(self, number: int, sums: list) -> list:
        """Print a loop; return the sums."""

        def turn(place: Any, held: list) -> list:
            self.places[number] = place
            return self.within(number + 1, held)

        count = self.now.lengths[number]
        if self.lanes > 1 and number == self.inner and count <= UNROLLED_RUNS:
            for first in range(0, count, ABREAST):
                sums = turn(tuple(range(first, min(count, first + ABREAST))), sums)
            return sums
        if number == self.vector:
            most = UNROLLED_RUNS if number else 1
            return self.rounds(count, most, turn, sums)
        unrolled = UNROLLED if self.lanes == 1 else UNROLLED_RUNS
        return self.loop(range(count), unrolled, turn, sums)

    def items(self, sums: list) -> list:
        """Print what turns of all loops do, one after the other; return the sums."""
        turns, wide = tuple(range(self.inner + 1)), self.vector >= 0
        values = [self.argument(item.value, turns, wide) for item in self.now.items]
        for k, place in enumerate(self.together(self.inner)):
            found: list[Any] = []
            for item, own in zip(self.now.items, values, strict=True):
                value = own[k % len(own)]
                if item.summed:
                    found.append(self.summed(sums[len(found)], value))
                else:
                    self.write(value, item, place)
            sums = found
        return sums

    def finish(self, total: Write, value: Any) -> None:
        """Keep a sum."""
        if self.vector == self.inner:
            value = joined(self.builder, value, self.now.lengths[self.inner])
        if self.inner:
            self.write(value, total)
        else:
            self.numbers[total.saves, (), False] = [value]

    # --- values ---------------------------------------------------------------------------

    def width(self, wide: bool) -> int:
        """Return how many numbers a value is."""
        return self.wide if wide else self.lanes

    def together(self, *turns: int) -> tuple:
        """Return the turns of the inner loop that are worked on at once; one of what is outside."""
        place = self.places[-1] if self.inner in turns and self.places else None
        return place if type(place) is tuple else (place,)

    def value(self, key: Key) -> list:
        """Return a value, of each turn that is worked on at once."""
        _, turns, wide = key
        depth = max(turns, default=-1) + 1
        known = self.values[depth] if depth or wide else self.numbers
        if key not in known:
            printed = self.printed(*key)
            with self.builder.goto_block(self.begins[depth]):
                known[key] = printed()
        return known[key]

    def printed(self, c: int, turns: tuple[int, ...], wide: bool) -> Callable[[], list]:
        """Return what prints a value; what that is made of has been printed."""
        builder, width = self.builder, self.width(wide)
        if wide and self.vector not in turns:
            own = self.value((c, turns, False))
            return lambda: [spread(builder, one, width) for one in own]
        read = self.read(c)
        if read is not None:
            array, first, strides = read
            ways = [self.way(turns, strides, wide, place) for place in self.together(*turns)]
            return lambda: [self.load(array, first, *way) for way in ways]
        name, arguments, _ = self.all[c]
        if name == "lookup":
            table, index = self.all[arguments[1][0]], self.argument(arguments[0], turns, wide)
            return lambda: [self.lookup(one, *table.arguments[:4]) for one in index]
        given = [self.argument(a, turns, wide) for a in arguments]
        return lambda: called(builder, name, width, given)

    def argument(self, a: Any, turns: tuple[int, ...], wide: bool) -> list:
        """Return an argument: a constant, or what is computed."""
        if type(a) is not tuple:
            return [constant(a, self.width(wide))]
        return self.value((a[0], tuple([turns[k] for k in a[1]]), wide))

    def way(
        self, turns: Sequence[int], strides: tuple[int, ...], wide: bool, place: Any
    ) -> tuple[list[tuple[Any, int]], int | None]:
        """Return how far each loop moves on, and the eight turns that are taken at once.

        `place` is the turn of the inner loop.
        """
        pairs = list(zip(turns, strides, strict=True))
        stride = sum(s for turn, s in pairs if turn == self.vector) if wide else None
        moves = [(place if turn == self.inner else self.places[turn], s) for turn, s in pairs]
        return moves, stride

    def write(self, value: Any, item: Write, place: Any = None) -> None:
        """Write what has been computed, in a turn of the inner loop or behind it."""
        array, first, strides, *_ = item
        wide = self.vector >= 0 and width_of(value) > 1
        self.store(value, array, first, *self.way(range(len(strides)), strides, wide, place))

    def lookup(self, index: Any, array: str, first: int, stride: int, count: int) -> Any:
        """Read array[first + stride * whole], NaN where there is no such entry."""
        builder, width = self.builder, width_of(index)

        def ask(name: str, *own: Any) -> Any:
            given = [a if type(a) is float else [a] for a in own]
            return called(builder, name, width, given)[0]

        place = ask("place", index, float(count))
        inside = ask("ge", place, 0.0)
        ones = []
        for k, one in enumerate(apart(builder, ask("where", inside, place, 0.0))):
            address = self.address(array, first, [(builder.fptosi(one, WORD), stride)])
            if self.columns(array) > 1:
                address = builder.gep(address, [ir.Constant(WORD, k)])
            ones.append(builder.load(address))
        return ask("where", inside, gathered(builder, ones), float("nan"))
