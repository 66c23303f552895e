"""What all functions in machine code share: arrays, loops, sums and calls.

    void name(double *t, double *X, double *P, double *T, double *W, double *D)

For eight runs side by side every array but T holds eight columns, a run in each, and loops take
one turn at a time.  For one run a loop takes eight turns at once, the last of them with a mask; a
sum over it is gathered in eight parts and then joined, in the same order on every processor.
"""

from collections.abc import Callable, Mapping, Sequence
from typing import Any

from llvmlite import ir

from .components import FUNCTIONS
from .elementary import OPERATIONS
from .formula import Formula
from .machine import LANES
from .vectors import BIT, DOUBLE, INT32, WORD, Abreast, Kind, Number, declared, select

Moves = Sequence[tuple[Any, int]]  # turns of loops, and by how much each moves on
ARRAYS = ("t", "X", "P", "T", "W", "D")
APART = frozenset({*FUNCTIONS, "pow", "mod", "floordiv"})  # printed once a module, and called
INLINE = frozenset({"exp", "sin", "cos"})  # always put in where they are called


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
            self.arrays["K"] = _table(module, self.builder, constants)
        self.lanes = lanes
        self.one, self.wide = Kind(self.builder, lanes), Kind(self.builder, LANES)
        self.turns = LANES  # of a round, how many there are

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

    def load(self, array: str, first: int, moves: Moves = (), apart: int | None = None) -> Number:
        """Read a number, or one for each run; or those of eight turns, which lie so `apart`."""
        builder, kind = self.builder, self.one if apart is None else self.wide
        if apart not in (None, 1):
            places = [first + k * apart for k in range(self.turns)]
            ones = [builder.load(self.address(array, place, moves)) for place in places]
            return gathered(kind, ones + ones[:1] * (kind.width - self.turns))
        address = self.address(array, first, moves)
        if apart is None and self.columns(array) == 1:
            return kind.number(builder.load(address))
        many = builder.bitcast(address, kind.type().as_pointer())
        if apart is None or self.turns == kind.width:
            return Number(kind, builder.load(many, align=8))
        given = [many, ir.Constant(INT32, 8), self.valid().value, kind.constant(1.0)]
        return Number(kind, self._masked("load", kind.type(), given))

    def store(
        self, value: Number, array: str, first: int, moves: Moves = (), apart: int | None = None
    ) -> None:
        """Write a number, or one for each run; or the numbers of eight turns."""
        builder, kind = self.builder, self.one if apart is None else self.wide
        if apart not in (None, 1):
            for k in range(self.turns):
                one = builder.extract_element(value.value, ir.Constant(INT32, k))
                builder.store(one, self.address(array, first + k * apart, moves))
            return
        address = self.address(array, first, moves)
        if apart == 1 or self.columns(array) > 1:
            address = builder.bitcast(address, kind.type().as_pointer())
        if apart is None or self.turns == kind.width:
            builder.store(value.value, address, align=8)
            return
        given = [value.value, address, ir.Constant(INT32, 8), self.valid().value]
        self._masked("store", ir.VoidType(), given)

    def _masked(self, name: str, result: ir.Type, given: list[Any]) -> Any:
        """Read or write the turns that there are."""
        width = self.wide.width
        own = f"llvm.masked.{name}.v{width}f64.p0v{width}f64"
        types = [one.type for one in given]
        return self.builder.call(declared(self.builder.module, own, result, types), given)

    def valid(self) -> Number:
        """Return which turns of a round there are."""
        bits = [int(k < self.turns) for k in range(self.wide.width)]
        return Number(self.wide, ir.Constant(self.wide.type(BIT), bits))

    # --- loops ----------------------------------------------------------------------------

    def widen(self, count: int) -> None:
        """Take eight of so many turns at once, or four where there are no more."""
        self.wide = Kind(self.builder, LANES if count > LANES // 2 else LANES // 2)
        self.turns = self.wide.width

    def rounds(
        self, count: int, unrolled: int, turn: Callable[[Any, list], list], sums: list
    ) -> list:
        """Print a loop of several turns at once; return what sums are after it."""
        width = self.wide.width
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
            phi = builder.phi(first.kind.type())
            phi.add_incoming(first.value, before)
            held.append(phi)
        turned = turn(number, [Number(s.kind, p) for s, p in zip(sums, held, strict=True)])
        following = builder.add(number, ir.Constant(WORD, which.step))
        number.add_incoming(following, builder.block)
        for phi, value in zip(held, turned, strict=True):
            phi.add_incoming(value.value, builder.block)
        more = builder.icmp_signed("<", following, ir.Constant(WORD, which.stop))
        builder.cbranch(more, body, after)
        builder.position_at_end(after)
        return turned


def _table(module: ir.Module, builder: ir.IRBuilder, values: Sequence[float]) -> Any:
    kind = ir.ArrayType(DOUBLE, len(values))
    if "K" not in module.globals:
        table = ir.GlobalVariable(module, kind, "K")
        table.linkage, table.global_constant = "internal", True
        table.initializer = ir.Constant(kind, list(values))
    zero = ir.Constant(INT32, 0)
    return builder.gep(module.globals["K"], [zero, zero])


def called(name: str, kind: Kind, arguments: list[Any]) -> Any:
    """Calculate an operation; a long one is printed once a module."""
    if name not in APART or (name in INLINE and type(kind.builder) is Abreast):
        return OPERATIONS[name](*arguments)
    module = kind.builder.module
    own = f"{name}.{kind.width}"
    if own not in module.globals:
        signature = ir.FunctionType(kind.type(), [kind.type()] * len(arguments))
        function = ir.Function(module, signature, own)
        function.linkage = "internal"
        if name in INLINE:
            function.attributes.add("alwaysinline")
        inner = Kind(ir.IRBuilder(function.append_basic_block()), kind.width)
        inner.builder.ret(OPERATIONS[name](*(Number(inner, a) for a in function.args)).value)
    values = [a.value for a in arguments]
    return Number(kind, kind.builder.call(module.globals[own], values))


def gathered(kind: Kind, ones: list[Any]) -> Number:
    """Return single numbers as one vector."""
    if kind.width == 1:
        return Number(kind, ones[0])
    found: Any = ir.Constant(kind.type(), ir.Undefined)
    for k, one in enumerate(ones):
        found = kind.builder.insert_element(found, one, ir.Constant(INT32, k))
    return Number(kind, found)


def joined(part: Number, turns: int) -> Number:
    """Add up the numbers of a vector, halves first; so many turns that there are at most."""
    builder, value, width = part.kind.builder, part.value, part.kind.width
    while width > 1:
        width //= 2
        low, high = (
            builder.shuffle_vector(
                value, value, ir.Constant(ir.VectorType(INT32, width), list(range(at, at + width)))
            )
            for at in (0, width)
        )
        value = builder.fadd(low, high) if turns > width else low
    return Number(Kind(builder, 1), builder.extract_element(value, ir.Constant(INT32, 0)))


# --- formulas of a method: numbers of a lane are t, Z is X ----------------------------------


def print_formulas(formulas: Mapping[str, Formula], n: int, lanes: int) -> ir.Module:
    """Return a module of LLVM with formulas for n states, of 1 run or `LANES` side by side."""
    module = ir.Module()
    for name, formula in formulas.items():
        function = Function(module, name, lanes)
        sums = _each(function, formula, n) if formula.each is not None else []
        if formula.after is not None:
            found = formula.after(_rows(function, "t", function.one), sums)
            for r, value in found.items():
                function.store(function.one.number(value), "t", r)
        function.builder.ret_void()
    return module


def _rows(function: Function, array: str, kind: Kind) -> Any:
    """Return what reads a number of an array, each once."""
    found: dict[int, Number] = {}

    def row(r: int) -> Number:
        if r not in found:
            found[r] = kind.spread(function.load(array, r))
        return found[r]

    return row


def _each(function: Function, formula: Formula, n: int) -> list[Number]:
    """Print what is computed for each state; return what is summed over them."""
    wide = function.lanes == 1 and n > 2
    function.widen(n)
    kind = function.wide if wide else function.one

    def turn(place: Any, sums: list[Number]) -> list[Number]:
        found: dict[int, Number] = {}

        def z(r: int) -> Number:
            if r not in found:
                moves = [(place, 1)]
                found[r] = function.load("X", r * n, moves, 1 if wide else None)
            return found[r]

        assert formula.each is not None
        own = _rows(function, "t", kind), _rows(function, "T", kind)
        rows, summed = formula.each(z, *own)
        for r, value in rows.items():
            function.store(value, "X", r * n, [(place, 1)], 1 if wide else None)
        if wide and function.turns < kind.width:
            summed = [select(function.valid(), value, 0.0) for value in summed]
        return [a + b for a, b in zip(sums, summed, strict=True)]

    zeros = [kind.number(0.0) for _ in range(formula.sums)]
    if not wide:
        return function.loop(range(n), 2, turn, zeros)
    return [joined(value, n) for value in function.rounds(n, 1, turn, zeros)]
