"""What each operation of a record is in machine code.

A name of the record (`blocks.record`) -> a function of numbers (`vectors`), the
same for one run and for eight side by side.  Words and operators keep what they
mean in Python, NaN, signed zeros and division by zero as NumPy has them.
"""

import math
from collections.abc import Callable
from typing import Any

from . import transcendental
from .components import FUNCTIONS
from .vectors import (
    Number,
    copysign,
    round_down,
    round_to_zero,
    select,
    square_root,
)


def _fmod(a: Number, b: Number) -> Number:
    return Number(a.kind, a.kind.builder.frem(a.value, b.value))


def remainder(a: Number, b: Number) -> Number:
    """Return a % b, with the sign of b."""
    left = _fmod(a, b)
    turned = select((left < 0.0) ^ (b < 0.0), left + b, left)
    return select(left == 0.0, copysign(a.kind.number(0.0), b), turned)


def quotient(a: Number, b: Number) -> Number:
    """Return a // b."""
    left = _fmod(a, b)
    ratio = (a - left) / b
    ratio = select((left != 0.0) & ((left < 0.0) ^ (b < 0.0)), ratio - 1.0, ratio)
    whole = round_down(ratio)
    whole = select(ratio - whole > 0.5, whole + 1.0, whole)
    whole = select(ratio == 0.0, copysign(a.kind.number(0.0), a / b), whole)
    return select(b == 0.0, a / b, whole)


def minimum(a: Number, b: Number) -> Number:
    """Return the smaller; NaN where one is NaN."""
    return select((a < b) | (a != a), a, b)


def maximum(a: Number, b: Number) -> Number:
    """Return the larger; NaN where one is NaN."""
    return select((a > b) | (a != a), a, b)


def sign(value: Number) -> Number:
    """Return -1, 0 or 1."""
    return select(value > 0.0, 1.0, select(value < 0.0, -1.0, 0.0 * value))


def pick(index: Number, *numbers: Number) -> Number:
    """Return the number at a whole index; NaN outside."""
    whole, count = round_to_zero(index), len(numbers)
    whole = select(whole < 0.0, whole + float(count), whole)
    found = index.kind.number(math.nan)
    for k, number in enumerate(numbers):
        found = select(whole == float(k), number, found)
    return found


def _each(name: str) -> Callable[..., Number]:
    return lambda *arguments: arguments[0].kind.each(name, *arguments)


# adding 0.0 makes -0.0 what Python makes of whole numbers: 0.0
OPERATIONS: dict[str, Callable[..., Any]] = {
    "add": lambda a, b: a + b,
    "sub": lambda a, b: a - b,
    "mul": lambda a, b: a * b,
    "div": lambda a, b: a / b,
    "mod": remainder,
    "floordiv": quotient,
    "pow": transcendental.power,
    "neg": lambda a: -a,
    "fmuladd": lambda a, b, c: a.kind.call("fmuladd", a, b, c),
    "lt": lambda a, b: a < b,
    "le": lambda a, b: a <= b,
    "gt": lambda a, b: a > b,
    "ge": lambda a, b: a >= b,
    "eq": lambda a, b: a == b,
    "ne": lambda a, b: a != b,
    "and": lambda a, b: a & b,
    "or": lambda a, b: a | b,
    "not": lambda a: ~a,
    "where": select,
    "minimum": minimum,
    "maximum": maximum,
    "sign": sign,
    "floor": lambda a: round_down(a) + 0.0,
    "trunc": lambda a: round_to_zero(a) + 0.0,
    "ceil": lambda a: 0.0 - round_down(-a),
    "pick": pick,
    "fabs": abs,
    "sqrt": square_root,
    "erf": _each("erf"),
    "erfc": _each("erfc"),
    **{name: getattr(transcendental, name) for name in FUNCTIONS},
}
