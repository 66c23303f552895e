"""Print a program as LLVM's code: for one run, or for eight side by side.

    void name(double *t, double *X, double *P, double *T, double *W, double *D)

For eight runs every array but T holds eight columns, a run in each.  For one run
the innermost loops take eight turns at once: nothing is carried between turns but
sums, which are gathered in eight parts and then joined, in the same order on
every processor.
"""

from typing import Any

from llvmlite import ir

from .elementary import OPERATIONS
from .optimise import LONG, Abreast, abreast
from .program import Item, Load, Loop, Step, Steps, Store
from .vectors import DOUBLE, INT32, WORD, Kind, Mask, Number, round_to_zero, select

ARRAYS = ("t", "X", "P", "T", "W", "D")
APART = LONG | {"mod", "floordiv"}  # printed once a module, and called


def print_module(
    functions: dict[str, tuple[Item, ...]], constants: tuple[float, ...], lanes: int
) -> ir.Module:
    """Return a module of LLVM with a program's functions, for 1 run or `LANES` side by side."""
    module = ir.Module()
    for name, items in functions.items():
        print_function(module, name, items, constants, lanes)
    return module


def print_function(
    module: ir.Module, name: str, items: tuple[Item, ...], constants: tuple[float, ...], lanes: int
) -> None:
    """Add a program's function to a module of LLVM."""
    pointer = DOUBLE.as_pointer()
    function = ir.Function(module, ir.FunctionType(ir.VoidType(), [pointer] * 6), name)
    arrays = {}
    for argument, array in zip(function.args, ARRAYS, strict=True):
        argument.add_attribute("noalias")
        argument.name = array
        arrays[array] = argument
    builder = ir.IRBuilder(function.append_basic_block())
    if constants:
        arrays["K"] = _constants(module, builder, constants)
    printer = _Printer(builder, arrays, lanes)
    printer.print_items(abreast(items) if lanes == 1 else items, Kind(builder, lanes), {}, {})
    builder.ret_void()


def _constants(module: ir.Module, builder: ir.IRBuilder, values: tuple[float, ...]) -> Any:
    kind = ir.ArrayType(DOUBLE, len(values))
    if "K" not in module.globals:
        table = ir.GlobalVariable(module, kind, "K")
        table.linkage, table.global_constant = "internal", True
        table.initializer = ir.Constant(kind, list(values))
    zero = ir.Constant(INT32, 0)
    return builder.gep(module.globals["K"], [zero, zero])


class _Printer:
    """Prints items; turns of loops are whole numbers of LLVM."""

    def __init__(self, builder: ir.IRBuilder, arrays: dict[str, Any], lanes: int):
        self.builder, self.arrays, self.lanes = builder, arrays, lanes

    def print_items(
        self,
        items: tuple[Item | Abreast, ...],
        kind: Kind,
        values: dict[int, Any],
        turns: dict[int, Any],
    ) -> None:
        """Print items one after the other; `values` takes what they compute."""
        for item in items:
            if isinstance(item, Load):
                values[item.value] = self.load(item, kind, turns)
            elif isinstance(item, Step):
                values[item.value] = self.step(item, kind, values, turns)
            elif isinstance(item, Store):
                self.store(item, kind, values, turns)
            elif isinstance(item, Abreast):
                self.abreast(item.steps, values)
            else:
                self.loop(item, kind, values, turns)

    # --- arrays -------------------------------------------------------------------------

    def _whole(self, number: int) -> ir.Constant:
        return ir.Constant(WORD, number)

    def _place(self, base: int, steps: Steps, turns: dict[int, Any]) -> Any:
        place: Any = self._whole(base)
        for level, step in steps:
            place = self.builder.add(place, self.builder.mul(turns[level], self._whole(step)))
        return place

    def _columns(self, array: str) -> int:
        return 1 if array in "TK" else self.lanes

    def _address(self, array: str, place: Any, columns: int) -> Any:
        if columns > 1:
            place = self.builder.mul(place, self._whole(columns))
        return self.builder.gep(self.arrays[array], [place])

    def _stride(self, steps: Steps, kind: Kind) -> int:
        """By how much places differ in what is worked on at once: turns of level 0."""
        return dict(steps).get(0, 0) if kind.width != self.lanes else 0

    def load(self, item: Load, kind: Kind, turns: dict[int, Any]) -> Number:
        columns = self._columns(item.array)
        place = self._place(item.base, item.steps, turns)
        stride = self._stride(item.steps, kind)
        if kind.width == 1 or (columns == 1 and stride == 0):
            return kind.number(self.builder.load(self._address(item.array, place, columns)))
        if columns > 1 or stride == 1:
            address = self._address(item.array, place, columns)
            many = self.builder.bitcast(address, kind.type().as_pointer())
            return Number(kind, self.builder.load(many, align=8))
        places = [self.builder.add(place, self._whole(k * stride)) for k in range(kind.width)]
        ones = [self.builder.load(self._address(item.array, at, 1)) for at in places]
        return _gathered(kind, ones)

    def store(self, item: Store, kind: Kind, values: dict, turns: dict[int, Any]) -> None:
        columns = self._columns(item.array)
        place = self._place(item.base, item.steps, turns)
        stride = self._stride(item.steps, kind)
        value = self.number(item.value, kind, values).value
        if kind.width == 1:
            self.builder.store(value, self._address(item.array, place, columns))
        elif columns > 1 or stride == 1:
            address = self._address(item.array, place, columns)
            self.builder.store(
                value, self.builder.bitcast(address, kind.type().as_pointer()), align=8
            )
        else:
            for k in range(kind.width):
                at = self.builder.add(place, self._whole(k * stride))
                one = self.builder.extract_element(value, ir.Constant(INT32, k))
                self.builder.store(one, self._address(item.array, at, 1))

    # --- arithmetic ---------------------------------------------------------------------

    def number(self, ref: Any, kind: Kind, values: dict[int, Any]) -> Any:
        """Return what an argument is, repeated where more is worked on at once."""
        value = values[ref] if type(ref) is int else ref
        if isinstance(value, Number | Mask) and value.kind.width == kind.width:
            return value
        if isinstance(value, Mask):
            one = self.builder.select(value.value, *(ir.Constant(DOUBLE, v) for v in (1.0, 0.0)))
            return kind.number(one) > 0.5
        return kind.number(value.value if isinstance(value, Number) else value)

    def step(self, item: Step, kind: Kind, values: dict, turns: dict[int, Any]) -> Any:
        if item.name == "table":
            index = self.number(item.arguments[0], kind, values)
            return self.table(index, item.arguments[1], kind, turns)
        arguments = [self.number(a, kind, values) for a in item.arguments]
        return calculated(item.name, kind, arguments)

    def abreast(self, steps: tuple[Step, ...], values: dict) -> None:
        """Calculate a function of several numbers at once."""
        while steps:
            width = next(w for w in (8, 4, 2, 1) if w <= len(steps) or w // 2 < len(steps) > 2)
            now, steps = steps[:width], steps[width:]
            kind = Kind(self.builder, width)
            filled = [*now, *now[:1] * (width - len(now))]
            arguments = []
            for place in range(len(now[0].arguments)):
                ones = [
                    self.number(step.arguments[place], Kind(self.builder, 1), values).value
                    for step in filled
                ]
                arguments.append(_gathered(kind, ones))
            found = calculated(now[0].name, kind, arguments)
            for k, step in enumerate(now):
                value = found.value
                if width > 1:
                    value = self.builder.extract_element(value, ir.Constant(INT32, k))
                values[step.value] = Number(Kind(self.builder, 1), value)

    def table(self, index: Number, run: tuple, kind: Kind, turns: dict[int, Any]) -> Number:
        """Read array[base + stride * whole], NaN where there is no such entry."""
        array, base, steps, stride, count = run
        whole = round_to_zero(index)
        whole = select(whole < 0.0, whole + float(count), whole)
        inside = (whole >= 0.0) & (whole < float(count))
        first, columns = self._place(base, steps, turns), self._columns(array)
        moved = self._stride(steps, kind)
        safe = select(inside, whole, 0.0).value
        ones = []
        for k in range(kind.width):
            lane = ir.Constant(INT32, k)
            one = safe if kind.width == 1 else self.builder.extract_element(safe, lane)
            place = self.builder.mul(self.builder.fptosi(one, WORD), self._whole(stride))
            place = self.builder.add(self.builder.add(place, first), self._whole(moved * k))
            address = self._address(array, place, columns)
            if columns > 1:
                address = self.builder.gep(address, [self._whole(k)])
            ones.append(self.builder.load(address))
        return select(inside, _gathered(kind, ones), float("nan"))

    # --- loops --------------------------------------------------------------------------

    def loop(self, item: Loop, kind: Kind, values: dict, turns: dict[int, Any]) -> None:
        inner = not any(isinstance(part, Loop) for part in item.body)
        widths = (8, 4, 2, 1) if inner and self.lanes == 1 else (kind.width,)
        sums: list[Any] = [self.number(s.first, kind, values) for s in item.sums]
        start = 0
        for width in widths:
            wide = Kind(self.builder, width)
            at_once = width if len(widths) > 1 else 1
            rounds = (item.count - start) // at_once
            if not rounds:
                continue
            parts = [wide.number(0.0) for _ in sums] if width != kind.width else sums
            stop = start + rounds * at_once
            parts = self._rounds(item, wide, values, turns, parts, range(start, stop, at_once))
            if width != kind.width:
                parts = [s + _joined(part, kind) for s, part in zip(sums, parts, strict=True)]
            sums, start = parts, stop
        values.update({s.result: total for s, total in zip(item.sums, sums, strict=True)})

    def _rounds(
        self, item: Loop, kind: Kind, values: dict, turns: dict, sums: list, which: range
    ) -> list:
        """Print rounds, of which each takes as many turns at once as `which` steps ahead."""

        def turn(number: Any, held: list) -> list:
            own = {**values, **{s.within: v for s, v in zip(item.sums, held, strict=True)}}
            self.print_items(item.body, kind, own, {**turns, item.level: number})
            return [own[s.turned] for s in item.sums]

        if len(which) == 1:
            return turn(self._whole(which.start), sums)
        builder, before = self.builder, self.builder.block
        body, after = builder.append_basic_block(), builder.append_basic_block()
        builder.branch(body)
        builder.position_at_end(body)
        number = builder.phi(WORD)
        number.add_incoming(self._whole(which.start), before)
        held = []
        for first in sums:
            phi = builder.phi(kind.type())
            phi.add_incoming(first.value, before)
            held.append(phi)
        turned = turn(number, [Number(kind, phi) for phi in held])
        following = builder.add(number, self._whole(which.step))
        number.add_incoming(following, builder.block)
        for phi, value in zip(held, turned, strict=True):
            phi.add_incoming(value.value, builder.block)
        more = builder.icmp_signed("<", following, self._whole(which.stop))
        builder.cbranch(more, body, after)
        builder.position_at_end(after)
        return turned


def calculated(name: str, kind: Kind, arguments: list[Any]) -> Any:
    """Calculate an operation; a long one is printed once a module."""
    if name not in APART:
        return OPERATIONS[name](*arguments)
    module = kind.builder.module
    own = f"{name}.{kind.width}"
    if own not in module.globals:
        signature = ir.FunctionType(kind.type(), [kind.type()] * len(arguments))
        function = ir.Function(module, signature, own)
        function.linkage = "internal"
        inner = Kind(ir.IRBuilder(function.append_basic_block()), kind.width)
        inner.builder.ret(OPERATIONS[name](*(Number(inner, a) for a in function.args)).value)
    values = [a.value for a in arguments]
    return Number(kind, kind.builder.call(module.globals[own], values))


def _gathered(kind: Kind, ones: list[Any]) -> Number:
    """Return single numbers as one vector."""
    if kind.width == 1:
        return Number(kind, ones[0])
    found: Any = ir.Constant(kind.type(), ir.Undefined)
    for k, one in enumerate(ones):
        found = kind.builder.insert_element(found, one, ir.Constant(INT32, k))
    return Number(kind, found)


def _joined(part: Number, kind: Kind) -> Number:
    """Add up the numbers of a vector, halves first."""
    builder, value, width = part.kind.builder, part.value, part.kind.width
    while width > 1:
        width //= 2
        halves = [
            builder.shuffle_vector(
                value, value, ir.Constant(ir.VectorType(INT32, width), list(range(at, at + width)))
            )
            for at in (0, width)
        ]
        value = builder.fadd(*halves)
    return Number(kind, builder.extract_element(value, ir.Constant(INT32, 0)))
