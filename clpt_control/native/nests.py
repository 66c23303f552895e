"""Print the nests of a program as LLVM's code."""

from typing import Any

from llvmlite import ir

from .plan import Nest, Program, Saved, Total, rows
from .printing import Function, called, gathered, joined
from .vectors import INT32, WORD, Abreast, Kind, Number, round_to_zero, select

UNROLLED, UNROLLED_RUNS = (
    4,
    8,
)  # turns of a loop that are printed one by one: of most, of inner ones
ABREAST = 4  # of those, how many are worked on at once
Key = tuple[int, tuple[int, ...], bool]  # component, loops that its axes are, for eight turns


def print_program(program: Program, names: tuple[str, ...], lanes: int) -> ir.Module:
    """Return a module of LLVM with some of a program's functions."""
    module = ir.Module()
    for name in names:
        made = Function(module, name, lanes, program.constants)
        printer = _Printer(program, made, {} if name == "prepare" else program.prepared)
        for nest in program.functions[name]:
            printer.nest(nest)
        made.builder.ret_void()
    return module


class _Printer:
    """Prints the nests of a function, one after the other."""

    def __init__(self, program: Program, function: Function, prepared: dict[int, int]):
        self.all, self.function, self.prepared = program.components, function, prepared
        self.saved: dict[int, int] = {}  # what lies in W by now
        self.values: dict[Key, Any] = {}

    # --- nests ----------------------------------------------------------------------------

    def nest(self, nest: Nest) -> None:
        """Print a nest of loops, or what is outside all of them."""
        self.now, self.inner = nest, len(nest.lengths) - 1
        self.places: list[Any] = [None] * len(nest.lengths)  # the turn of each loop
        self.vector = nest.vector if nest.lengths and self.function.lanes == 1 else -1
        if self.vector >= 0:
            self.function.widen(nest.lengths[self.vector])
        self.kind = self.function.wide if self.vector >= 0 else self.function.one
        self.totals = [item for item in nest.items if isinstance(item, Total)]
        self.needed: list[list[Key]] = [[] for _ in range(len(nest.lengths) + 1)]
        seen: set[Key] = set()
        for item in nest.items:
            self.need(item.value, seen)
        self.within(0, [])
        for key in [key for key in self.values if key[1] or key[2]]:
            del self.values[key]
        for item in nest.items:
            if isinstance(item, Saved) or (isinstance(item, Total) and item.place >= 0):
                self.saved[item.component] = item.place

    def need(self, value: Any, seen: set[Key]) -> None:
        """Note what a value needs, in the order of computing, each within its own loops."""
        if type(value) is not tuple:
            return
        stack: list[tuple[Key, bool]] = [((*value, self.vector >= 0), False)]
        while stack:
            key, ready = stack.pop()
            if ready:
                self.needed[max(key[1], default=-1) + 1].append(key)
            elif key not in seen and key not in self.values:
                seen.add(key)
                stack += [(key, True), *((k, False) for k in reversed(self.made_of(key)))]

    def made_of(self, key: Key) -> list[Key]:
        """Return the values that one is made of."""
        c, turns, wide = key
        if wide and self.vector not in turns:
            return [(c, turns, False)]
        if self.read(c) is not None:
            return []
        arguments = [a for a in self.all[c].arguments if type(a) is tuple]
        own = [(a, tuple([turns[k] for k in axes]), wide) for a, axes in arguments]
        return [key for key in own if self.all[key[0]].name != "table"]

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
        for key in self.needed[depth]:
            self.values[key] = self.value(key)
        if depth > self.inner:
            return self.items(sums)
        masked = (
            depth == self.vector and self.now.lengths[depth] < self.kind.width
        )  # zeros are among them
        zeros = [None if masked else self.kind.number(0.0) for _ in self.totals]
        zeros = zeros if depth == self.inner else []
        found = self.loop(depth, zeros)
        for total, value in zip(self.totals, found, strict=False):
            self.finish(total, value)
        return []

    def loop(self, number: int, sums: list) -> list:
        """Print a loop; return the sums."""

        def turn(place: Any, held: list) -> list:
            self.places[number] = place
            return self.within(number + 1, held)

        count = self.now.lengths[number]
        if self.function.lanes > 1 and number == self.inner and count <= UNROLLED_RUNS:
            for first in range(0, count, ABREAST):
                sums = turn(tuple(range(first, min(count, first + ABREAST))), sums)
            return sums
        if number == self.vector:
            most = UNROLLED_RUNS if number else 1
            return self.function.rounds(count, most, turn, sums)
        unrolled = UNROLLED if self.function.lanes == 1 else UNROLLED_RUNS
        return self.function.loop(range(count), unrolled, turn, sums)

    def items(self, sums: list) -> list:
        """Print what turns of all loops do; return the sums."""
        together = self.places[-1] if self.places else None
        if type(together) is not tuple:
            return self.item(sums, None)
        for k, self.places[-1] in enumerate(together):
            sums = self.item(sums, k)
        return sums

    def item(self, sums: list, k: int | None) -> list:
        """Print what one turn of all loops does, the k-th of those that are worked on at once."""
        found: list[Any] = []
        for item in self.now.items:
            value = _part(self.argument(item.value, None, self.kind), k, self.kind)
            if isinstance(item, Total):
                if self.vector == self.inner and self.function.turns < self.kind.width:
                    value = select(self.function.valid(), value, 0.0)
                held = sums[len(found)]
                found.append(value if held is None else held + value)
            elif isinstance(item, Saved):
                self.store(value, "W", item.place, rows(self.all[item.component].lengths))
            else:
                self.store(value, item.array, item.first, item.strides)
        return found

    def finish(self, total: Total, value: Number) -> None:
        """Keep a sum."""
        if self.vector == self.inner:
            value = joined(value, self.now.lengths[self.inner])
        if self.inner:
            self.store(value, "W", total.place, rows(self.all[total.component].lengths))
        else:
            self.values[total.component, (), False] = value

    # --- values ---------------------------------------------------------------------------

    def value(self, key: Key) -> Any:
        """Print a value, of several turns where they are worked on at once."""
        c, turns, wide = key
        kind = self.function.wide if wide else self.function.one
        if wide and self.vector not in turns:
            return kind.spread(self.values[c, turns, False])
        together = self.places[-1] if self.inner in turns else None
        if type(together) is not tuple:
            return self.one(key, kind, None)
        abreast = Kind(Abreast(self.function.builder), kind.width)
        if self.read(c) is None and self.all[c].name != "lookup":
            return self.one(key, abreast, None)
        made = []
        for k, self.places[-1] in enumerate(together):
            made.append(self.one(key, kind, k).value)
        self.places[-1] = together
        return Number(abreast, tuple(made))

    def one(self, key: Key, kind: Kind, k: int | None) -> Any:
        """Print a value of one turn, or eight, or of what is worked on at once."""
        c, turns, wide = key
        read = self.read(c)
        if read is not None:
            array, first, strides = read
            moves = [(self.places[turn], s) for turn, s in zip(turns, strides, strict=True)]
            apart = self.stride(turns, strides) if wide else None
            return self.function.load(array, first, moves, apart)
        name, arguments, _ = self.all[c]
        if name == "lookup":
            index = _part(self.argument(arguments[0], turns, kind), k, kind)
            return self.lookup(index, *self.all[arguments[1][0]].arguments[:4])
        own = [_part(self.argument(a, turns, kind), k, kind) for a in arguments]
        return called(name, kind, own)

    def argument(self, a: Any, turns: tuple[int, ...] | None, kind: Kind) -> Any:
        """Return an argument: a constant, or what has been computed."""
        if type(a) is not tuple:
            return kind.number(a)
        axes = a[1] if turns is None else tuple([turns[k] for k in a[1]])
        return self.values[a[0], axes, self.vector >= 0 and kind is self.function.wide]

    def stride(self, turns: Any, strides: tuple[int, ...]) -> int:
        """Return by how much the loop that takes eight turns moves on."""
        return sum(s for turn, s in zip(turns, strides, strict=True) if turn == self.vector)

    def store(self, value: Number, array: str, first: int, strides: tuple[int, ...]) -> None:
        """Write what the outer loops have computed."""
        moves = [(place, s) for place, s in zip(self.places, strides, strict=False)]
        wide = value.kind is self.function.wide and self.vector >= 0
        apart = self.stride(range(len(strides)), strides) if wide else None
        self.function.store(value, array, first, moves, apart)

    def lookup(self, index: Number, array: str, first: int, stride: int, count: int) -> Number:
        """Read array[first + stride * whole], NaN where there is no such entry."""
        kind, builder, function = index.kind, self.function.builder, self.function
        whole = round_to_zero(index)
        whole = select(whole < 0.0, whole + float(count), whole)
        inside = (whole >= 0.0) & (whole < float(count))
        safe = select(inside, whole, 0.0).value
        ones = []
        for k in range(kind.width):
            lane = ir.Constant(INT32, k)
            one = safe if kind.width == 1 else builder.extract_element(safe, lane)
            address = function.address(array, first, [(builder.fptosi(one, WORD), stride)])
            if function.columns(array) > 1:
                address = builder.gep(address, [ir.Constant(WORD, k)])
            ones.append(builder.load(address))
        return select(inside, gathered(kind, ones), float("nan"))


def _part(value: Any, k: int | None, kind: Kind) -> Any:
    """Return the k-th of several values, or all of them, as values of a kind."""
    of = value.value[k] if k is not None and type(value.value) is tuple else value.value
    return type(value)(kind, of) if value.kind is not kind else value
