"""Numbers of machine code: a double, or several at once in a SIMD register.

A `Number` is a value of LLVM with Python's operators, so that a formula reads
the same for one run, for eight runs side by side, and for eight turns of a loop.
Every operation is IEEE's own, number by number: nothing is reassociated or
contracted, so that a result depends on no neighbour and on no processor.
"""

import math
from collections.abc import Callable
from functools import lru_cache
from typing import Any, Union

from llvmlite import ir

DOUBLE, BIT, WORD, INT32 = ir.DoubleType(), ir.IntType(1), ir.IntType(64), ir.IntType(32)
MAGIC = 6755399441055744.0  # 1.5 * 2^52: added to a whole number, it stands in the low bits


class Abreast:
    """A builder of LLVM that does with several values in a tuple what it does with one.

    Functions of several numbers then wait for each other no more than need be, and read a
    constant once.
    """

    def __init__(self, builder: ir.IRBuilder):
        self.builder, self.module = builder, builder.module

    def __getattr__(self, name: str) -> Callable[..., Any]:
        build = getattr(self.builder, name)

        def each(*given: Any) -> Any:
            count = next((len(a) for a in _flat(given) if type(a) is tuple), 0)
            if not count:
                return build(*given)
            return tuple(build(*(_part(a, k) for a in given)) for k in range(count))

        return each


def _flat(given: Any) -> list[Any]:
    return [a for one in given for a in (one if type(one) is list else [one])]


def _part(given: Any, k: int) -> Any:
    if type(given) is list:
        return [_part(one, k) for one in given]
    return given[k] if type(given) is tuple else given


class Kind:
    """How many numbers are worked on at once (1, 2, 4 or 8), and where code goes."""

    def __init__(self, builder: Any, width: int):
        self.builder, self.width = builder, width

    def type(self, entry: ir.Type = DOUBLE) -> ir.Type:
        """Return the type of numbers, or of their bits."""
        return entry if self.width == 1 else ir.VectorType(entry, self.width)

    def constant(self, value: float, entry: ir.Type = DOUBLE) -> ir.Constant:
        """Return a constant, the same in every place."""
        return _constant(self.type(entry), value, math.copysign(1.0, value), self.width)

    def number(self, value: Any) -> "Number":
        """Return a number of a constant, or of one value or several; one stands in every place."""
        if isinstance(value, Number):
            return value
        if isinstance(value, int | float):
            return Number(self, self.constant(float(value)))
        if self.width > 1 and not isinstance(value.type, ir.VectorType):
            empty = ir.Constant(self.type(value.type), ir.Undefined)
            first = self.builder.insert_element(empty, value, ir.Constant(INT32, 0))
            zeros = ir.Constant(ir.VectorType(INT32, self.width), [0] * self.width)
            value = self.builder.shuffle_vector(first, empty, zeros)
        return Number(self, value)

    def spread(self, value: "Number") -> "Number":
        """Return one number or answer in every place."""
        return value if value.kind.width == self.width else self.number(value.value)

    def call(self, name: str, *arguments: "Number") -> "Number":
        """Call an intrinsic of LLVM, such as ``"fma"``."""
        suffix = "f64" if self.width == 1 else f"v{self.width}f64"
        function = declared(
            self.builder.module,
            f"llvm.{name}.{suffix}",
            self.type(),
            [self.type()] * len(arguments),
        )
        return Number(self, self.builder.call(function, [a.value for a in arguments]))

    def each(self, name: str, *arguments: "Number") -> "Number":
        """Call a function of the C library number by number."""
        function = declared(self.builder.module, name, DOUBLE, [DOUBLE] * len(arguments))
        if self.width == 1:
            return Number(self, self.builder.call(function, [a.value for a in arguments]))
        result: Any = ir.Constant(self.type(), ir.Undefined)
        for k in range(self.width):
            place = ir.Constant(INT32, k)
            one = [self.builder.extract_element(a.value, place) for a in arguments]
            result = self.builder.insert_element(result, self.builder.call(function, one), place)
        return Number(self, result)


@lru_cache(maxsize=4096)
def _constant(kind: ir.Type, value: float, sign: float, width: int) -> ir.Constant:
    """Return a constant; the same one again, for LLVM's text of it is long to make."""
    return ir.Constant(kind, value if width == 1 else [value] * width)


def declared(module: ir.Module, name: str, result: ir.Type, arguments: list[ir.Type]) -> Any:
    """Return a function of the module, declared if it is not."""
    if name in module.globals:
        return module.globals[name]
    return ir.Function(module, ir.FunctionType(result, arguments), name)


Like = Union["Number", float, int]


def _arithmetic(instruction: str, swapped: bool = False) -> Callable[["Number", Like], "Number"]:
    def operator(a: "Number", b: Like) -> "Number":
        values = [a.value, a.kind.number(b).value]
        build = getattr(a.kind.builder, instruction)
        return Number(a.kind, build(*(values[::-1] if swapped else values)))

    return operator


def _comparison(symbol: str, ordered: bool = True) -> Callable[["Number", Any], Any]:
    def operator(a: "Number", b: Like) -> "Number":
        compare = a.kind.builder.fcmp_ordered if ordered else a.kind.builder.fcmp_unordered
        return Number(a.kind, compare(symbol, a.value, a.kind.number(b).value))

    return operator


class Number:
    """One number or answer, or several at once, as a value of LLVM."""

    __slots__ = ("kind", "value")

    def __init__(self, kind: Kind, value: Any):
        self.kind, self.value = kind, value

    __add__, __radd__ = _arithmetic("fadd"), _arithmetic("fadd", True)
    __sub__, __rsub__ = _arithmetic("fsub"), _arithmetic("fsub", True)
    __mul__, __rmul__ = _arithmetic("fmul"), _arithmetic("fmul", True)
    __truediv__, __rtruediv__ = _arithmetic("fdiv"), _arithmetic("fdiv", True)
    __lt__, __le__ = _comparison("<"), _comparison("<=")
    __gt__, __ge__ = _comparison(">"), _comparison(">=")
    __eq__, __ne__ = _comparison("=="), _comparison("!=", False)
    __and__, __or__, __xor__ = _arithmetic("and_"), _arithmetic("or_"), _arithmetic("xor")
    __hash__ = None  # type: ignore[assignment]

    def __neg__(self) -> "Number":
        return Number(self.kind, self.kind.builder.fneg(self.value))

    def __invert__(self) -> "Number":
        return Number(self.kind, self.kind.builder.xor(self.value, self.kind.constant(1, BIT)))

    def __abs__(self) -> "Number":
        return self.kind.call("fabs", self)

    def bits(self) -> Any:
        """The bits, as whole numbers of 64 bits."""
        return self.kind.builder.bitcast(self.value, self.kind.type(WORD))


def select(mask: Number, a: Like, b: Like) -> Number:
    """`a` where the mask holds, else `b`; both are computed."""
    kind = mask.kind
    chosen = kind.builder.select(mask.value, kind.number(a).value, kind.number(b).value)
    return Number(kind, chosen)


def fma(a: Like, b: Like, c: Like) -> Number:
    """Return a b + c, rounded once."""
    kind = next(n.kind for n in (a, b, c) if isinstance(n, Number))
    return kind.call("fma", *(kind.number(n) for n in (a, b, c)))


def _intrinsic(name: str, meaning: str) -> Callable[..., Number]:
    def call(*arguments: Number) -> Number:
        return arguments[0].kind.call(name, *arguments)

    call.__doc__ = f"Return {meaning}."
    return call


square_root = _intrinsic("sqrt", "the square root, correctly rounded")
round_down = _intrinsic("floor", "the largest whole number not above")
round_to_zero = _intrinsic("trunc", "the whole number next towards zero")
copysign = _intrinsic("copysign", "the first number with the sign of the second")


def nearest(a: Number) -> Number:
    """Return the nearest whole number, for |a| < 2^51."""
    return (a + MAGIC) - MAGIC


def odd(k: Number) -> Number:
    """Whether whole numbers are odd, for |k| < 2^51."""
    kind = k.kind
    one = kind.builder.and_((k + MAGIC).bits(), kind.constant(1, WORD))
    return Number(kind, kind.builder.icmp_unsigned("!=", one, kind.constant(0, WORD)))


def negative_sign(a: Number) -> Number:
    """Whether the sign bit is set, of -0.0 and NaN too."""
    return Number(a.kind, a.kind.builder.icmp_signed("<", a.bits(), a.kind.constant(0, WORD)))


def power_of_two(k: Number) -> Number:
    """Return 2^k for whole numbers k in [-1022, 1023]."""
    kind = k.kind
    shifted = kind.builder.shl((k + (MAGIC + 1023.0)).bits(), kind.constant(52, WORD))
    return Number(kind, kind.builder.bitcast(shifted, kind.type()))


def times_power_of_two(a: Number, k: Number, half: Number) -> Number:
    """Return 2^k a, rounded once at the end; k and half of k have `MAGIC` added."""
    kind, builder = a.kind, a.kind.builder
    high = builder.shl(builder.sub(k.bits(), half.bits()), kind.constant(52, WORD))
    near = Number(kind, builder.bitcast(builder.add(a.bits(), high), kind.type()))
    low = builder.shl(builder.add(half.bits(), kind.constant(1023, WORD)), kind.constant(52, WORD))
    return near * Number(kind, builder.bitcast(low, kind.type()))


def turned_where_odd(a: Number, k: Number, more: int) -> Number:
    """Return -a where k + more is odd, else a; k has `MAGIC` added."""
    kind, builder = a.kind, a.kind.builder
    whole = builder.add(k.bits(), kind.constant(more, WORD)) if more else k.bits()
    sign = builder.shl(whole, kind.constant(63, WORD))
    return Number(kind, builder.bitcast(builder.xor(a.bits(), sign), kind.type()))


def split(a: Number) -> tuple[Number, Number]:
    """Return (k, m) with a = 2^k m and m near 1, for normal a > 0.

    sqrt(1/2) <= m < sqrt(2).
    """
    kind, builder = a.kind, a.kind.builder
    half_root, one = 0x3FE6A09E667F3BCD, 0x3FF0000000000000  # bits of sqrt(1/2) and of 1
    above = builder.add(
        builder.sub(a.bits(), kind.constant(half_root, WORD)), kind.constant(one, WORD)
    )
    k = builder.lshr(above, kind.constant(52, WORD))  # exponent + 1023
    number = builder.bitcast(builder.or_(k, kind.constant(0x4330000000000000, WORD)), kind.type())
    exponent = Number(kind, number) - float(2**52 + 1023)
    fraction = builder.and_(above, kind.constant(0x000FFFFFFFFFFFFF, WORD))
    m = builder.bitcast(builder.add(fraction, kind.constant(half_root, WORD)), kind.type())
    return exponent, Number(kind, m)
