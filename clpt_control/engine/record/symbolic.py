"""The SymPy reading of a record: its elements as expressions.

    add(a, b), of shape (2,)  ->  a[0] + b[0], a[1] + b[1]

Words with kinks, comparisons and remainders are undefined functions, so a proof holds for any
functions in their place.
"""

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from functools import lru_cache
from typing import Any

import numpy as np
import sympy

from ..trace.arrays import COMPARISONS
from .graph import OPERATIONS, Operation, Shape, picked, searched
from .scalar_graph import Elements, Index

ROUNDED = Fraction(1, 2**50)  # of a number: what a few roundings change
Leaf = Callable[[tuple[str, str], Shape, Index], Any]  # (group, name), its shape, a place -> symbol


@lru_cache(maxsize=10_000)
def rational(number: float) -> sympy.Expr:
    """Return a constant as a rational: 0.1 is 1/10, 0.333... is 1/3, 1 + 1e-12 is not 1.

    It is a simple fraction that a few roundings give, else the decimal number that is printed.
    """
    if not np.isfinite(number):
        return sympy.sympify(float(number))
    fraction = Fraction(repr(float(number)))
    simple = fraction.limit_denominator(10_000)
    return sympy.Rational(simple if abs(simple - fraction) <= abs(fraction) * ROUNDED else fraction)


@lru_cache(maxsize=100_000)
def extent(expression: sympy.Basic) -> tuple[int, int]:
    """Return how many parts an expression has, written out, and how many levels."""
    parts = [extent(part) for part in expression.args]
    return 1 + sum(size for size, _ in parts), 1 + max((depth for _, depth in parts), default=0)


LONG = 5_000  # parts of an expression; what has more SymPy takes too long to print or to simplify


# what SymPy leaves as it stands, by the name it has there
UNEXPANDED = {
    **{
        name: name
        for name in (
            *("where", "minimum", "maximum", "clip", "sign", "floor", "trunc", "ceil"),
            *("mod", "floordiv", "lt", "le", "gt", "ge", "pick", "search", "argmin"),
        )
    },
    **{name: f"{name}_" for name in ("and", "or", "not")},
}
SYMPY: dict[str, Callable[..., Any]] = {
    "add": lambda a, b: a + b,
    "sum": sympy.Add,
    "sub": lambda a, b: a - b,
    "mul": lambda a, b: a * b,
    "div": lambda a, b: a / b,
    "pow": lambda a, b: a**b,
    "neg": lambda a: -a,
    "fabs": lambda a: sympy.Abs(a, evaluate=extent(a)[0] <= LONG),
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
MOST_COMPARED = 64  # rows of a table that are compared one by one
NO_LIMIT = {"minimum": sympy.oo, "maximum": -sympy.oo}
TRUTHS = {sympy.true, sympy.false}
COMPARED = {name: getattr(sympy, name.title()) for name in COMPARISONS}


def _decided(kind: str, arguments: tuple) -> Any:
    """Return what a comparison with infinity decides, of symbols that are numbers; else None."""
    if kind in COMPARED and {sympy.oo, -sympy.oo}.intersection(arguments):
        found = COMPARED[kind](*arguments)
        return found if found in TRUTHS else None
    if not TRUTHS.intersection(arguments):
        return None
    if kind == "where":
        return arguments[1 if arguments[0] else 2]
    if kind == "not":
        return ~arguments[0]
    ends = sympy.sympify(kind == "or")
    rest = [one for one in arguments if one not in TRUTHS]
    return ends if ends in arguments else [*rest, ~ends][0]


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
        self.leaf_symbol, self.watch = leaf, watch

    def number(self, value: float) -> Any:
        """Return a rational."""
        return rational(value)

    def leaf(self, at: tuple[str, str], shape: Shape, index: Index) -> Any:
        """Return the symbol of an element of a leaf."""
        return sympy.sympify(self.leaf_symbol(at, shape, index))

    def apply(self, ref: int, kind: str, arguments: tuple) -> Any:
        """Return what SymPy makes of an operation."""
        if (decided := _decided(kind, arguments)) is not None:
            return decided
        self.watch(ref, kind, arguments)
        if kind == "search":
            row, side = self.operations[ref].arguments[0], self.operations[ref].at[0]
            points = [self.at(row, (k,)) for k in range(*self.operations[row].shape)]
            compare = SYMPY["ge" if side == "right" else "gt"]
            if len(points) > MOST_COMPARED:
                return SYMPY[kind](*arguments, int(side == "right"), *points)
            return sympy.Add(*(SYMPY["where"](compare(*arguments, one), 1, 0) for one in points))
        if kind in ("eq", "ne"):
            same = SYMPY["and"](SYMPY["le"](*arguments), SYMPY["ge"](*arguments))
            return same if kind == "eq" else SYMPY["not"](same)
        if kind in NO_LIMIT and NO_LIMIT[kind] in arguments:
            return arguments[arguments[0] == NO_LIMIT[kind]]
        if kind == "minimum":  # np.clip(u, low, high) is minimum(maximum(u, low), high)
            for inner, high in (arguments, arguments[::-1]):
                if getattr(inner, "func", None) == SYMPY["maximum"]:
                    u, low = inner.args if inner.args[0].free_symbols else inner.args[::-1]
                    return SYMPY["clip"](u, low, high)
        return SYMPY[kind](*arguments)


def _picked(place: Any, *row: Any) -> Any:
    at, *values = np.broadcast_arrays(place, *row)
    return picked(np.array(values), at)


def _searched(value: Any, side: Any, *points: Any) -> Any:
    row = np.array(points, dtype=float)[:, None]
    return searched(row, np.asarray(value, dtype=float), "right" if side else "left")


# UNEXPANDED on numbers
ON_NUMBERS: dict[str, Callable[..., Any]] = {
    **{own: OPERATIONS[name] for name, own in UNEXPANDED.items() if name in OPERATIONS},
    "clip": lambda a, low, high: np.minimum(np.maximum(a, low), high),
    "pick": _picked,
    "search": _searched,
    "argmin": lambda *row: np.argmin(np.broadcast_arrays(*row), axis=0),
}
