"""The SymPy reading of a record: its elements as expressions of symbols.

Words with kinks, comparisons and remainders are undefined functions, so a proof holds
for any functions in their place.  An opaque helper is an undefined function of its
arguments.
"""

from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import lru_cache
from math import copysign, isfinite
from typing import Any

import numpy as np
import sympy

from ..errors import BlockError
from . import numbers
from .block import Block
from .elements import Elements, Index
from .record import Operation, Ref, Shape

Leaf = Callable[[tuple[str, str], Shape, Index], Any]  # (group, name), its shape, a place -> symbol


@lru_cache(maxsize=10_000)
def exact(number: float) -> sympy.Expr:
    """Return a constant as a rational: 0.1 is 1/10."""
    return sympy.nsimplify(number, rational=True)


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


# what loses its digits, or its range, written out: log1p(a) as log(1 + a)
KEPT = {name: sympy.Function(f"{name}_", real=True) for name in ("hypot", "log1p", "expm1")}
CIRCULAR = ("sin", "cos", "tan")  # NaN beyond MOST_ANGLE, as in every reading


class _Uses(Elements):
    """How often each operation on single numbers is used, in the order in which they come."""

    def __init__(self, operations: Sequence[Operation], sizes: Mapping[str, int]):
        super().__init__(operations, sizes)
        self.count: list[int] = []

    def leaf(self, at: tuple[str, str], shape: Shape, index: Index) -> Any:
        """Count no leaves."""

    def number(self, value: float) -> Any:
        """Count no numbers."""

    def picked(self, ref: int, table: Ref, place: Any) -> Any:
        """Count the place alone where a row is a parameter."""
        return self.apply(ref, "pick", (place, *([] if _row(self, table) else self.all_of(table))))

    def apply(self, ref: int, kind: str, arguments: tuple) -> Any:
        """Count the arguments."""
        for a in arguments:
            if a is not None:
                self.count[a] += 1
        self.count.append(0)
        return len(self.count) - 1


def _row(elements: Elements, table: Ref) -> tuple[str, Any] | None:
    """Return parameter and view of a row that is a parameter, or part of one."""
    kind, arguments, shape, at = elements.operations[table]
    view = None
    if kind == "view":
        view = at, elements.sized(shape)
        kind, arguments, shape, at = elements.operations[arguments[0]]
    return (at[1], view) if kind == "leaf" and at[0] == "p" else None


class SymbolicFunction(Symbols):
    """A block's equations as SymPy's expressions, to be called with numbers.

    What is used twice is a symbol of its own, so that expressions stay short.
    """

    def __init__(self, block: Block, role: str):
        record = block.array_record(role)
        super().__init__(record.operations, self._leaf, sizes=block.sizes)
        uses = _Uses(record.operations, block.sizes)
        uses.outputs(record)
        self.often = iter([n > 1 for n in uses.count])
        self.leaves: dict[tuple, sympy.Symbol] = {}
        self.steps: list[tuple[sympy.Symbol, sympy.Expr]] = []
        values = self.outputs(record)
        for value in (*values, *(value for _, value in self.steps)):
            if value.has(sympy.zoo, sympy.nan, sympy.I):
                raise BlockError(f"SymPy finds that the equations divide by zero: {value}")
        self._compiled = self._function(values)

    def _symbol(self, *key: Any) -> sympy.Symbol:
        return self.leaves.setdefault(key, sympy.Symbol(f"leaf{len(self.leaves)}", real=True))

    def _leaf(self, at: tuple[str, str], shape: Shape, index: Index) -> Any:
        return self._symbol(*at, index)

    def number(self, value: float) -> Any:
        """Return a number; what SymPy would make more of is a symbol, as 0 * x."""
        known = value and isfinite(value)
        return sympy.Float(value) if known else self._symbol("", value, copysign(1.0, value))

    def opaque(self, at: tuple, arguments: tuple, index: Index) -> Any:
        """Return what a helper computes."""
        return Elements.opaque(self, at, arguments, index)

    def picked(self, ref: int, table: Ref, place: Any) -> Any:
        """Return what stands in a row, which is one symbol where it is a parameter."""
        row = _row(self, table)
        if row is None:
            return super().picked(ref, table, place)
        return self._step(sympy.Function("picked", real=True)(self._symbol("row", *row), place))

    def apply(self, ref: int, kind: str, arguments: tuple) -> Any:
        """Return what SymPy makes of an operation, as a symbol where it is used again."""
        if kind in KEPT:
            return self._step(KEPT[kind](*arguments))
        if kind == "pow" and arguments[1] in (2.0, 3.0, 4.0):
            arguments = arguments[0], sympy.Integer(arguments[1])
        return self._step(super().apply(ref, kind, arguments))

    def _step(self, value: Any) -> Any:
        if not next(self.often) or not isinstance(value, sympy.Expr):
            return value
        symbol = sympy.Symbol(f"step{len(self.steps)}", real=True)
        self.steps.append((symbol, value))
        return symbol

    def _function(self, values: Iterable[Any]) -> Callable:
        from sympy.printing.numpy import SciPyPrinter

        settings = {
            "fully_qualified_modules": True,
            "allow_unknown_functions": True,
            "user_functions": {name: f"{name}_" for name in CIRCULAR},
        }
        printer = SciPyPrinter(settings)
        lines = [f"    {symbol} = {printer.doprint(value)}" for symbol, value in self.steps]
        outputs = ", ".join(printer.doprint(value) for value in values)
        arguments = ", ".join(map(str, self.leaves.values()))
        text = "\n".join([f"def values({arguments}):", *lines, f"    return [{outputs}]"])
        space: dict[str, Any] = {"numpy": np, "picked": numbers.picked}
        space |= NUMBERS
        space |= {f"{name}_": numbers.OPERATIONS[name] for name in (*KEPT, *CIRCULAR)}
        if "scipy" in text:
            import scipy.special

            space["scipy"] = scipy
        exec(compile(text, "<the SymPy reading>", "exec"), space)
        return space["values"]

    def __call__(self, given: Callable[[str, str], np.ndarray]) -> np.ndarray:
        """Return the value of each output; ``given("x", "alpha")`` is an array."""
        values = []
        for group, name, *more in self.leaves:
            if group == "":
                values.append(name)
            elif group == "row":
                row = given("p", name)
                values.append(row if more[0] is None else numbers.viewed(row, *more[0]))
            else:
                values.append(np.asarray(given(group, name))[more[0]])
        with np.errstate(all="ignore"):
            return np.array(
                self._compiled(*(np.asarray(v, dtype=float)[()] for v in values)), dtype=float
            )
