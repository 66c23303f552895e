"""The SymPy reading of a record: its elements as expressions of symbols.

Words with kinks, comparisons and remainders are undefined functions, so a proof holds
for any functions in their place.  An opaque helper is an undefined function of its
arguments.
"""

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from functools import lru_cache
from typing import Any

import numpy as np
import sympy

from . import numbers
from .block import Block
from .elements import Elements, Index
from .record import Operation, Shape

ROUNDED = Fraction(1, 2**50)  # of a number: what a few roundings change
Leaf = Callable[[tuple[str, str], Shape, Index], Any]  # (group, name), its shape, a place -> symbol


@lru_cache(maxsize=10_000)
def exact(number: float) -> sympy.Expr:
    """Return a constant as a rational: 0.1 is 1/10, 0.333... is 1/3, 1 + 1e-12 is not 1.

    It is a simple fraction that a few roundings give, else the decimal number that is printed.
    """
    if not np.isfinite(number):
        return sympy.sympify(float(number))
    own = Fraction(repr(float(number)))
    simple = own.limit_denominator(10_000)
    return sympy.Rational(simple if abs(simple - own) <= abs(own) * ROUNDED else own)


# what SymPy leaves as it stands, by the name it has there
UNEXPANDED = {
    **{
        name: name
        for name in (
            *("where", "minimum", "maximum", "clip", "sign", "floor", "trunc", "ceil"),
            *("mod", "floordiv", "lt", "le", "gt", "ge", "pick"),
        )
    },
    **{name: f"{name}_" for name in ("and", "or", "not")},
}
OPERATIONS: dict[str, Callable[..., Any]] = {
    "add": lambda a, b: a + b,
    "sum": sympy.Add,
    "sub": lambda a, b: a - b,
    "mul": lambda a, b: a * b,
    "div": lambda a, b: a / b,
    "pow": lambda a, b: a**b,
    "neg": lambda a: -a,
    "fabs": sympy.Abs,
    "hypot": lambda a, b: sympy.sqrt(a**2 + b**2),
    "log1p": lambda a: sympy.log(1 + a),
    "expm1": lambda a: sympy.exp(a) - 1,
    "log2": lambda a: sympy.log(a) / sympy.log(2),
    "log10": lambda a: sympy.log(a) / sympy.log(10),
    **{
        name: getattr(sympy, name)
        for name in (
            *("exp", "log", "sqrt", "sin", "cos", "tan", "asin", "acos", "atan", "atan2"),
            *("sinh", "cosh", "tanh", "asinh", "acosh", "atanh", "erf", "erfc"),
        )
    },
    **{name: sympy.Function(own, real=True) for name, own in UNEXPANDED.items()},
}


class Symbols(Elements):
    """Elements as expressions; `leaf` makes those of leaves, `watch` gets each operation."""

    def __init__(
        self,
        operations: Sequence[Operation],
        leaf: Leaf,
        watch: Callable[[int, str, tuple], Any] = lambda ref, kind, arguments: None,
        sizes: Mapping[str, int] | None = None,
    ):
        super().__init__(operations, sizes)
        self.given, self.watch = leaf, watch

    def number(self, value: float) -> Any:
        """Return a rational."""
        return exact(value)

    def leaf(self, at: tuple[str, str], shape: Shape, index: Index) -> Any:
        """Return what was given for an element of a leaf."""
        return sympy.sympify(self.given(at, shape, index))

    def opaque(self, at: tuple, arguments: tuple, index: Index) -> Any:
        """Return an undefined function of all that a helper is given, one for each place."""
        name = "_".join([f"{at[0]}()", *(str(k) for k in (at[1], *index) if k)])
        return sympy.Function(name, real=True)(*(e for a in arguments[1:] for e in self.all_of(a)))

    def apply(self, ref: int, kind: str, arguments: tuple) -> Any:
        """Return what SymPy makes of an operation."""
        self.watch(ref, kind, arguments)
        if kind in ("eq", "ne"):
            same = OPERATIONS["and"](OPERATIONS["le"](*arguments), OPERATIONS["ge"](*arguments))
            return same if kind == "eq" else OPERATIONS["not"](same)
        if kind == "minimum":  # np.clip(u, low, high) is minimum(maximum(u, low), high)
            for inner, high in (arguments, arguments[::-1]):
                if getattr(inner, "func", None) == OPERATIONS["maximum"]:
                    u, low = inner.args if inner.args[0].free_symbols else inner.args[::-1]
                    return OPERATIONS["clip"](u, low, high)
        return OPERATIONS[kind](*arguments)


def expressions(block: Block, role: str, leaf: Leaf) -> list[sympy.Expr]:
    """Return what a block computes, on symbols, port by port, row by row."""
    record = block.array_record(role)
    return Symbols(record.operations, leaf, sizes=block.sizes).outputs(record)


def _picked(place: Any, *row: Any) -> Any:
    at, *values = np.broadcast_arrays(place, *row)
    return numbers.picked(np.array(values), at, many=at.ndim > 0)


# UNEXPANDED on numbers
NUMBERS: dict[str, Callable[..., Any]] = {
    **{
        own: numbers.OPERATIONS[name]
        for name, own in UNEXPANDED.items()
        if name not in ("clip", "pick")
    },
    "clip": lambda a, low, high: np.minimum(np.maximum(a, low), high),
    "pick": _picked,
}
