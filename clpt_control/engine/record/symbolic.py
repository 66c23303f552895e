"""SymPy expressions of a record: one for each element of its arrays.

    add(a, b), of shape (2,)  ->  a[0] + b[0], a[1] + b[1]

Operations with kinks, comparisons and remainders are undefined functions, so a proof holds for any
functions in their place.
"""

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from functools import lru_cache, partial
from typing import Any

import numpy as np
import sympy

from .graph import Operation, Shape, picked, searched
from .operations import COMPARISONS, KINK, LOGICAL, TABLE, Row, named
from .scalar_graph import Elements, Index

# (group, name), its shape, a place -> symbol
Leaf = Callable[[tuple[str, str], Shape, Index], Any]


@lru_cache(maxsize=10_000)
def rational(number: float) -> sympy.Expr:
    """Return a constant as a rational: 0.1 is 1/10, 0.333... is 1/3, the next number is not.

    It is the simple fraction that this number stands for, else the decimal number that is printed.
    """
    if not np.isfinite(number):
        return sympy.sympify(float(number))
    fraction = Fraction(repr(float(number)))
    simple = fraction.limit_denominator(10_000)
    return sympy.Rational(simple if float(simple) == number else fraction)


@lru_cache(maxsize=100_000)
def extent(expression: sympy.Basic) -> tuple[int, int]:
    """Return the number of nodes of an expression tree, and its depth."""
    extents = [extent(argument) for argument in expression.args]
    size = sum(size for size, _ in extents)
    depth = max((depth for _, depth in extents), default=0)
    return 1 + size, 1 + depth


LONG = 5_000  # parts of an expression; what has more SymPy takes too long to print or to simplify


# operations with kinks and jumps; SymPy leaves them as they are
UNDEFINED = LOGICAL | named(lambda row: row.smoothness >= KINK and not row.sympy)


_undefined = partial(sympy.Function, real=True)


def _in_sympy(name: str, row: Row) -> Callable[..., Any]:
    """Return an operation on expressions."""
    if callable(row.sympy):
        return partial(row.sympy, sympy)
    sympy_name = row.sympy or name
    if name in UNDEFINED:
        return _undefined(sympy_name)
    return getattr(sympy, sympy_name)


SYMPY: dict[str, Callable[..., Any]] = {
    **{name: _in_sympy(name, row) for name, row in TABLE.items()},
    "sum": sympy.Add,
    "fabs": lambda a: sympy.Abs(a, evaluate=extent(a)[0] <= LONG),
    "clip": _undefined("clip"),
}
MOST_COMPARED = 64  # rows of a table that are compared one by one
NO_LIMIT = {"minimum": sympy.oo, "maximum": -sympy.oo}
TRUTHS = {sympy.true, sympy.false}
COMPARED = {name: getattr(sympy, name.title()) for name in COMPARISONS}


def _decided(kind: str, arguments: tuple) -> Any:
    """Return the outcome of an operation on infinities or truth values; None if it is open."""
    infinities = {sympy.oo, -sympy.oo}
    if kind in COMPARED and infinities.intersection(arguments):
        decision = COMPARED[kind](*arguments)
        return decision if decision in TRUTHS else None
    if not TRUTHS.intersection(arguments):
        return None
    if kind == "where":
        return arguments[1 if arguments[0] else 2]
    if kind == "not":
        return ~arguments[0]
    ends = sympy.sympify(kind == "or")
    undecided = [argument for argument in arguments if argument not in TRUTHS]
    return ends if ends in arguments else [*undecided, ~ends][0]


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
        self.leaf_symbol = leaf
        self.watch = watch

    def number(self, value: float) -> Any:
        """Return a rational."""
        return rational(value)

    def leaf(self, key: tuple[str, str], shape: Shape, index: Index) -> Any:
        """Return the symbol of an element of a leaf."""
        return sympy.sympify(self.leaf_symbol(key, shape, index))

    def apply(self, ref: int, kind: str, arguments: tuple) -> Any:
        """Return the SymPy expression of an operation."""
        decision = _decided(kind, arguments)
        if decision is not None:
            return decision
        self.watch(ref, kind, arguments)
        if kind == "search":
            return self._searched(ref, arguments[0])
        if kind in ("eq", "ne"):
            is_at_most = SYMPY["le"](*arguments)
            is_at_least = SYMPY["ge"](*arguments)
            is_equal = SYMPY["and"](is_at_most, is_at_least)
            return is_equal if kind == "eq" else SYMPY["not"](is_equal)
        if kind in NO_LIMIT and NO_LIMIT[kind] in arguments:
            a, b = arguments
            return b if a == NO_LIMIT[kind] else a
        if kind == "minimum":  # np.clip(u, low, high) is minimum(maximum(u, low), high)
            for inner, high in (arguments, arguments[::-1]):
                if getattr(inner, "func", None) == SYMPY["maximum"]:
                    u, low = (
                        inner.args if inner.args[0].free_symbols else inner.args[::-1]
                    )
                    return SYMPY["clip"](u, low, high)
        return SYMPY[kind](*arguments)

    def _searched(self, ref: int, value: Any) -> Any:
        """Return how many points of a sorted row are below a value."""
        operation = self.operations[ref]
        row = operation.arguments[0]
        is_right = operation.at[0] == "right"  # equal ones too
        points = [self.at(row, (k,)) for k in range(*self.operations[row].shape)]
        if len(points) > MOST_COMPARED:
            return SYMPY["search"](value, int(is_right), *points)
        compare = SYMPY["ge" if is_right else "gt"]
        counts = [SYMPY["where"](compare(value, point), 1, 0) for point in points]
        return sympy.Add(*counts)


def _picked(position, *row):
    positions, *values = np.broadcast_arrays(position, *row)
    return picked(np.array(values), positions)


def _searched(value, side, *points):
    row = np.array(points, dtype=float)
    values = np.asarray(value, dtype=float)
    return searched(row[:, None], values, "right" if side else "left")


# undefined functions on numbers
ON_NUMBERS: dict[str, Callable[..., Any]] = {
    **{
        row.sympy or name: row.numpy
        for name, row in TABLE.items()
        if name in UNDEFINED and row.numpy
    },
    "clip": lambda a, low, high: np.minimum(np.maximum(a, low), high),
    "pick": _picked,
    "search": _searched,
    "argmin": lambda *row: np.argmin(np.broadcast_arrays(*row), axis=0),
}
