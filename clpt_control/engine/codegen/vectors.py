"""Operations in LLVM code: on a double, or on the doubles of a SIMD register.

About thirty operations are primitives: instructions, intrinsics and functions of the C library.
The others are functions in NumPy (`elementary`), which are traced and printed as primitives.  Every
primitive follows IEEE 754 for each number.  Nothing is reassociated or contracted, so a result does
not depend on the processor or on other lanes.  Functions of rows of numbers are LLVM's text.
"""

from collections.abc import Callable, Sequence
from functools import cache, lru_cache
from math import copysign
from typing import Any

from llvmlite import ir

from ...base.errors import BlockError
from ..record.graph import Operation, Record, compact, replayed
from ..record.operations import TABLE
from ..trace.arrays import Tape, operand
from .elementary import FUNCTIONS, MAGIC
from .fused_expressions import OUT_OF_LINE
from .machine import LANES, ROWS, scales

DOUBLE = ir.DoubleType()
BIT = ir.IntType(1)
WORD = ir.IntType(64)
INT32 = ir.IntType(32)


def vector(width: int, entry: ir.Type = DOUBLE) -> ir.Type:
    """Return the type of `width` numbers at once, or of their bits."""
    return entry if width == 1 else ir.VectorType(entry, width)


def width_of(value: Any) -> int:
    """Return how many numbers a value is."""
    return value.type.count if isinstance(value.type, ir.VectorType) else 1


def constant(value: float, width: int, entry: ir.Type = DOUBLE) -> ir.Constant:
    """Return a constant, the same number in every place."""
    return _constant(value, copysign(1.0, value), width, entry)


def word(value: int) -> ir.Constant:
    """Return a whole number of 64 bits, such as an index."""
    return ir.Constant(WORD, value)


@lru_cache(maxsize=4096)
def _constant(value: float, sign: float, width: int, entry: ir.Type) -> ir.Constant:
    """Return a constant; it is cached because LLVM's text of it takes long to make."""
    return ir.Constant(vector(width, entry), value if width == 1 else [value] * width)


def splat(builder: ir.IRBuilder, value: Any, width: int) -> Any:
    """Return one number or truth value in every place."""
    if width == width_of(value):
        return value
    empty = ir.Constant(vector(width, value.type), ir.Undefined)
    vector_of_one = builder.insert_element(empty, value, ir.Constant(INT32, 0))
    return builder.shuffle_vector(vector_of_one, empty, constant(0, width, INT32))


def gathered(builder: ir.IRBuilder, numbers: list[Any]) -> Any:
    """Return single numbers as one vector."""
    if len(numbers) == 1:
        return numbers[0]
    value = ir.Constant(vector(len(numbers)), ir.Undefined)
    for k, number in enumerate(numbers):
        value = builder.insert_element(value, number, ir.Constant(INT32, k))
    return value


def elements(builder: ir.IRBuilder, value: Any) -> list[Any]:
    """Return the numbers of a vector one by one."""
    width = width_of(value)
    if width == 1:
        return [value]
    return [builder.extract_element(value, ir.Constant(INT32, k)) for k in range(width)]


def horizontal_sum(builder: ir.IRBuilder, value: Any, count: int) -> Any:
    """Return the sum of a vector, of `count` numbers at most; halves are added first."""
    width = width_of(value)
    while width > 1:
        width //= 2
        low = _lanes(builder, value, range(width))
        high = _lanes(builder, value, range(width, 2 * width))
        value = builder.fadd(low, high) if count > width else low
    return builder.extract_element(value, ir.Constant(INT32, 0))


def sum_of_parts(builder: ir.IRBuilder, parts: Sequence[Any], count: int) -> Any:
    """Return the sum of eight values in the order of `horizontal_sum`."""
    while len(parts) > 1:
        half = len(parts) // 2
        low, high = parts[:half], parts[half:]
        parts = low
        if count > half:
            parts = [builder.fadd(a, b) for a, b in zip(low, high, strict=True)]
    return parts[0]


def _lanes(builder: ir.IRBuilder, value: Any, lanes: range) -> Any:
    """Return some lanes of a vector."""
    mask_type = ir.VectorType(INT32, len(lanes))
    return builder.shuffle_vector(value, value, ir.Constant(mask_type, list(lanes)))


def declared(
    module: ir.Module, name: str, result: ir.Type, arguments: list[ir.Type]
) -> Any:
    """Return a function of the module; declare it if it is new."""
    if name in module.globals:
        return module.globals[name]
    signature = ir.FunctionType(result, arguments)
    return ir.Function(module, signature, name)


# --- primitives: builder, values -> value -----------------------------------------------------

Primitive = Callable[..., Any]


def _instruction(name: str) -> Primitive:
    return lambda builder, *a: getattr(builder, name)(*a)


def _comparison(symbol: str) -> Primitive:
    # NaN differs from each number
    ordered = "unordered" if symbol == "!=" else "ordered"
    return lambda builder, a, b: getattr(builder, f"fcmp_{ordered}")(symbol, a, b)


def _intrinsic(name: str) -> Primitive:
    def call(builder: ir.IRBuilder, *a: Any) -> Any:
        width = width_of(a[0])
        types = [argument.type for argument in a]
        suffix = "f64" if width == 1 else f"v{width}f64"
        function_name = f"llvm.{name}.{suffix}"
        function = declared(builder.module, function_name, types[0], types)
        return builder.call(function, a)

    return call


def _library(name: str) -> Primitive:
    """Call a function of the C library number by number."""

    def call(builder: ir.IRBuilder, *a: Any) -> Any:
        function = declared(builder.module, name, DOUBLE, [DOUBLE] * len(a))
        operands = [elements(builder, vector) for vector in a]
        numbers = [
            builder.call(function, scalars) for scalars in zip(*operands, strict=True)
        ]
        return gathered(builder, numbers)

    return call


def _bits(builder: ir.IRBuilder, a: Any) -> Any:
    return builder.bitcast(a, vector(width_of(a), WORD))


def _number(builder: ir.IRBuilder, bits: Any) -> Any:
    return builder.bitcast(bits, vector(width_of(bits)))


def _word(value: int, a: Any) -> ir.Constant:
    return constant(value, width_of(a), WORD)


def _power_of_two(builder: ir.IRBuilder, k: Any) -> Any:
    """2^k for whole numbers k in [-1022, 1023], to which `MAGIC` and 1023 are added."""
    bits = builder.shl(_bits(builder, k), _word(52, k))
    return _number(builder, bits)


def _times_power_of_two(builder: ir.IRBuilder, a: Any, k: Any, half_bits: Any) -> Any:
    """2^k a, rounded once at the end; k and half of k have `MAGIC` added."""
    width = width_of(a)
    if width > 1 and scales():
        exponent = builder.fsub(k, constant(MAGIC, width))
        all_lanes = ir.Constant(ir.IntType(8), -1)
        values = [a, exponent, a, all_lanes]
        if width == LANES:
            usual_rounding = ir.Constant(INT32, 4)
            values.append(usual_rounding)
        name = f"llvm.x86.avx512.mask.scalef.pd.{64 * width}"
        types = [argument.type for argument in values]
        return builder.call(declared(builder.module, name, a.type, types), values)
    exponent_shift = _word(52, a)
    half_bits = _bits(builder, half_bits)
    remaining_bits = builder.sub(_bits(builder, k), half_bits)
    high = builder.shl(remaining_bits, exponent_shift)
    scaled_bits = builder.add(_bits(builder, a), high)
    partly_scaled = _number(builder, scaled_bits)
    biased_bits = builder.add(half_bits, _word(1023, a))
    low = builder.shl(biased_bits, exponent_shift)
    return builder.fmul(partly_scaled, _number(builder, low))


def _negated_where_odd(builder: ir.IRBuilder, a: Any, k: Any) -> Any:
    """-a where k is odd, else a; k has `MAGIC` added."""
    sign = builder.shl(_bits(builder, k), _word(63, k))
    bits = builder.xor(_bits(builder, a), sign)
    return _number(builder, bits)


HALF_ROOT = 0x3FE6A09E667F3BCD  # bits of sqrt(1/2)


def _above(builder: ir.IRBuilder, a: Any) -> Any:
    above = builder.sub(_bits(builder, a), _word(HALF_ROOT, a))
    return builder.add(above, _word(0x3FF0000000000000, a))  # bits of 1


def _exponent(builder: ir.IRBuilder, a: Any) -> Any:
    """k + 2^52 + 1023 of a = 2^k m with sqrt(1/2) <= m < sqrt(2), for normal a > 0."""
    k = builder.lshr(_above(builder, a), _word(52, a))
    bits = builder.or_(k, _word(0x4330000000000000, a))
    return _number(builder, bits)


def _fraction(builder: ir.IRBuilder, a: Any) -> Any:
    """m of a = 2^k m."""
    fraction = builder.and_(_above(builder, a), _word(0x000FFFFFFFFFFFFF, a))
    bits = builder.add(fraction, _word(HALF_ROOT, a))
    return _number(builder, bits)


def _primitive(name: str, llvm: str) -> Primitive:
    """Return the primitive that a row of the table of operations names."""
    kind, _, argument = llvm.partition(" ")
    if kind == "compare":
        return _comparison(argument)
    if kind == "intrinsic":
        return _intrinsic(argument)
    if kind == "libm":
        return _library(name)
    return _instruction(kind)


PRIMITIVES: dict[str, Primitive] = {
    **{
        name: _primitive(name, row.llvm)
        for name, row in TABLE.items()
        if row.llvm not in ("function", "inline")
    },
    "rem": _instruction("frem"),
    **{
        name: _intrinsic(name)
        for name in ("fma", "fmuladd", "copysign", "maxnum", "minnum")
    },
    "round_down": _intrinsic("floor"),
    "round_to_zero": _intrinsic("trunc"),
    "power_of_two": _power_of_two,
    "times_power_of_two": _times_power_of_two,
    "negated_where_odd": _negated_where_odd,
    "exponent": _exponent,
    "fraction": _fraction,
}


# --- operations -----------------------------------------------------------------------------


@cache
def record_of(name: str, count: int) -> Record:
    """Return the record of a function of `count` leaves."""
    if name not in FUNCTIONS:
        raise BlockError(
            f"{name}: has no machine code. Write it in engine/codegen/elementary.py and enter it "
            "in FUNCTIONS, or give llvm"
        )
    tape = Tape()
    leaves = [tape.add("leaf", (), (), ("u", k)) for k in range(count)]
    return compact(tape.operations, [operand(FUNCTIONS[name](*leaves))])


def calculate(
    builder: ir.IRBuilder,
    name: str,
    width: int,
    arguments: Sequence[Any],
    inline: bool = False,
) -> Any:
    """Return the value of an operation; a long one is a function, printed once a module.

    With `inline` it is printed in place.
    """
    values = [constant(a, width) if type(a) is float else a for a in arguments]
    if name in PRIMITIVES:
        return PRIMITIVES[name](builder, *values)
    record = record_of(name, len(values))
    if inline or name not in OUT_OF_LINE:
        return _calculate_record(builder, record, width, values)
    function_name = f"{name}.{width}"
    functions = builder.module.globals
    if function_name not in functions:
        signature = ir.FunctionType(vector(width), [vector(width)] * len(values))
        function = ir.Function(builder.module, signature, function_name)
        function.linkage = "internal"
        inner = ir.IRBuilder(function.append_basic_block())
        result = _calculate_record(inner, record, width, function.args)
        inner.ret(result)
    return builder.call(functions[function_name], values)


def _calculate_record(
    builder: ir.IRBuilder, record: Record, width: int, leaves: Sequence[Any]
) -> Any:
    """Return the value of a record."""

    def put(operation: Operation, operands: list[Any]) -> Any:
        return calculate(builder, operation.kind, width, operands)

    (value,) = replayed(record, lambda group, k, shape: leaves[k], put)
    return value


# --- rows of numbers -------------------------------------------------------------------------


BODIES = {  # by name
    head.partition("@")[2].partition("(")[0]: body
    for head, _, body in (
        text.partition("{") for text in ROWS.read_text("utf-8").split("\n}\n")
    )
}


class RowFunction(ir.Function):
    """A function of a row of numbers, with its body in `rows.ll`."""

    def __init__(self, module: ir.Module, name: str, arguments: Sequence[Any]):
        types = [argument.type for argument in arguments]
        super().__init__(module, ir.FunctionType(DOUBLE, types), name)
        self.linkage = "internal"
        self.append_basic_block()  # in whose place the body is printed
        names = "row", "stride", "count", "value", "right"
        for argument, argument_name in zip(self.args, names, strict=False):
            argument.name = argument_name

    def descr_body(self, buf: list[str]) -> None:
        """Print the body."""
        buf += [BODIES[self.name], "\n"]


def calculate_on_row(builder: ir.IRBuilder, name: str, arguments: Sequence[Any]) -> Any:
    """Return the value of a function of a row: its address, stride and count, and numbers."""
    module = builder.module
    if name not in module.globals:
        RowFunction(module, name, arguments)
    return builder.call(module.globals[name], arguments)
