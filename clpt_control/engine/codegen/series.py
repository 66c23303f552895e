"""Printer of Taylor series: LLVM text of coefficients, from the components of a program's rates.

    x(t + s tau) = x + sum a_k tau^k,    a_k = s/k (coefficient k - 1 of the rates),  k = 1 ... p

Each smooth operation has a recurrence of its coefficients in the table of operations
(`operations.Recurrence`), a power its own here.  s is the scale of a step, which what is divided by
limits.  A `Node` may also be computed on balls, as guaranteed runs do.
"""

from collections.abc import Callable, Iterable
from functools import partial
from math import inf
from typing import Any

import numpy as np
from llvmlite import ir
from numpy.lib.mixins import NDArrayOperatorsMixin

from ...base.errors import Uncompiled
from ..record.operations import NO_ROW, SMOOTH, TABLE, UFUNCS, Recurrence, Smoothness
from .fused_expressions import Component, whole_power
from .llvm_text import LLVMPrinter
from .plan import Program
from .vectors import PRIMITIVES

# of an argument in a step: a part of what is divided by, and the change of another one
RELATIVE, ABSOLUTE = 0.75, 4.0
MOST_LINES = 15_000  # of coefficients; LLVM takes five seconds for them
MOST_DEGREE = 64  # of a function; its peaks are as narrow as its degree is high
ALL_SMOOTH = (SMOOTH, Smoothness.FOLDS)


class Node(NDArrayOperatorsMixin):
    """A component as a number, for the slopes of the table of operations."""

    def __init__(self, printer: "Coefficients", argument: Any):
        self.printer = printer
        self.argument = argument

    def __array_ufunc__(self, ufunc: Any, method: str, *values: Any) -> "Node":
        arguments = [v.argument if isinstance(v, Node) else float(v) for v in values]
        return Node(self.printer, self.printer.new(UFUNCS[ufunc], *arguments))

    def clip(self, low: Any, high: Any, out: None = None) -> "Node":
        """Return the number between limits, as NumPy's function asks for it."""
        low, high = -inf if low is None else low, inf if high is None else high
        value: Any = self
        limited: Node = np.minimum(np.maximum(value, low), high)
        return limited

    def __bool__(self) -> bool:
        raise Uncompiled("has a function whose slope is not smooth")


class Coefficients(LLVMPrinter):
    """Printer of coefficients; each is a value, or a number known now."""

    def __init__(self, module: ir.Module, program: Program, lanes: int, order: int):
        super().__init__(module, "derivative", lanes, program, set())
        self.order = order
        self.components: Any = list(program.components)
        self.known = {component: c for c, component in enumerate(self.components)}
        self.constants: dict[int, bool] = {}  # whether a component is one along the run
        self.coefficients: dict[Any, Any] = {}
        self.degrees: dict[Any, int] = {}
        # what must not change by more in a step, and whether that is a part of it
        self.limits: dict[tuple[Any, bool], float] = {}
        self.lines = 0
        # time, states and scale of the step, once they are known
        self.time: Any = None
        self.states: list[Any] = []
        self.scale: Any = None
        items = [item for nest in self.nests for item in nest.items]
        if any(nest.lengths for nest in self.nests):
            raise Uncompiled("has loops")
        values = {item.first: item.value for item in items if item.array == "D"}
        self.rates = [values[k] for k in range(len(values))]
        self.highest = max(map(self.degree, self.rates), default=0)
        if self.highest > MOST_DEGREE:
            raise Uncompiled(
                f"has a function of degree {self.highest}, at most {MOST_DEGREE}"
            )

    # --- numbers known now, and values --------------------------------------------------------

    def operate(self, name: str, a: Any, b: Any) -> Any:
        """Return a sum, product or difference of coefficients."""
        if type(a) is type(b) is float:
            return {"add": a + b, "sub": a - b, "mul": a * b}[name]
        if name == "mul" and 0.0 in (a, b):
            return 0.0
        if name == "mul" and 1.0 in (a, b):
            return b if a == 1.0 else a
        if b == 0.0 or (name == "add" and a == 0.0):
            return b if a == 0.0 else a
        self.lines += 1
        if self.lines > MOST_LINES:
            raise Uncompiled(f"has more than {MOST_LINES} operations")
        return self.call(name, a, b)

    def as_value(self, value: Any) -> Any:
        """Return a number as a constant, a value as it is."""
        return self.number(value, False) if type(value) is float else value

    def call(self, name: str, *values: Any) -> Any:
        """Return the result of a primitive or an intrinsic."""
        return PRIMITIVES[name](self.builder, *map(self.as_value, values))

    def sum_of_products(
        self, pairs: Iterable[tuple[Any, Any]], total: Any = 0.0
    ) -> Any:
        """Return a sum of products, one after the other."""
        for a, b in pairs:
            if total == 0.0 or {0.0, 1.0} & {x for x in (a, b) if type(x) is float}:
                total = self.operate("add", self.operate("mul", a, b), total)
            else:
                self.lines += 1
                total = self.call("fmuladd", a, b, total)
        return total

    # --- coefficients -------------------------------------------------------------------------

    def load(self, element: Any) -> Any:
        """Read a number; states and time are those of the step."""
        if element.array == "X":
            return self.states[element.offset]
        return self.time if element.array == "t" else super().load(element)

    def new(self, name: str, *arguments: Any) -> Any:
        """Return a component as an argument; an equal one is the same."""
        component = Component(name, arguments, ())
        if component not in self.known:
            self.known[component] = len(self.components)
            self.components.append(component)
        return self.known[component], ()

    def is_constant(self, argument: Any) -> bool:
        """Return whether an argument is constant along a segment of time."""
        if type(argument) is float:
            return True
        c = argument[0]
        if c not in self.constants:
            name, arguments, _ = self.components[c]
            reads = name in ("load", "table")
            self.constants[c] = c in self.prepared or (
                arguments[0] in "PTK"
                if reads
                else all(map(self.is_constant, arguments))
            )
        return self.constants[c]

    def at(self, argument: Any, k: int) -> Any:
        """Return coefficient k of an argument."""
        if k and self.is_constant(argument):
            return 0.0
        if k == 0:
            return (
                self.argument(argument, (), False)
                if type(argument) is tuple
                else argument
            )
        return self.cached((argument[0], k), partial(self.coefficient, argument, k))

    def degree(self, argument: Any) -> int:
        """Return the degree of an argument as a polynomial; a function has that of its argument."""
        if self.is_constant(argument):
            return 0
        name, arguments, _ = self.components[argument[0]]
        if name == "load":
            return 1
        if argument not in self.degrees:
            degrees = [self.degree(a) for a in arguments]
            degree = sum(degrees) if name == "mul" else max(degrees)
            if name == "pow" and is_whole(arguments[1]):
                degree *= int(arguments[1])
            self.degrees[argument] = degree
        return self.degrees[argument]

    def cached(self, key: Any, make: Callable[[], Any]) -> Any:
        """Return a value that several coefficients use."""
        if key not in self.coefficients:
            self.coefficients[key] = make()
        return self.coefficients[key]

    def coefficient(self, argument: Any, k: int) -> Any:
        """Return coefficient k > 0 of a component that varies along a step."""
        name, arguments, _ = self.components[argument[0]]
        at = self.at
        if name == "load":
            if arguments[0] == "X":
                return self.state_coefficient(arguments[1], k)
            return self.scale if k == 1 else 0.0  # of time
        if (row := TABLE.get(name, NO_ROW).series) is not None:
            return self.by_recurrence(row, (*arguments, argument), k)
        if name == "pow" and self.is_constant(arguments[1]):
            return self.power(argument, k)
        if name == "where" and self.is_of_nan(arguments[0]):
            return at(arguments[2], k)
        return self.by_slopes(argument, k)

    def is_of_nan(self, condition: Any) -> bool:
        """Return whether a condition holds only if a value is NaN, where a series ends."""
        name, arguments, _ = self.components[condition[0]]
        if name == "and":
            return any(map(self.is_of_nan, arguments))
        return name == "ne" and arguments[0] == arguments[1]

    def power(self, argument: Any, k: int) -> Any:
        """Return coefficient k of f = a^b: sum of (b (k - j) - j) / k a_(k - j) f_j over a_0."""
        a, exponent = self.components[argument[0]].arguments
        if is_whole(exponent):
            # products have a series where a is 0
            product = whole_power(partial(self.new, "mul"), a, int(exponent))
            return self.at(product, k)
        pairs = []
        for j in outside_in(0, k - 1):
            product = self.operate("mul", self.at(exponent, 0), (k - j) / k)
            factor = self.operate("sub", product, j / k)
            term = self.operate("mul", factor, self.at(a, k - j))
            pairs.append((term, self.at(argument, j)))
        return self.operate("mul", self.sum_of_products(pairs), self.inverse(a, 1.0))

    def state_coefficient(self, state: int, k: int) -> Any:
        """Return coefficient k of a state, s/k times coefficient k - 1 of its rate."""
        make = partial(self.operate, "mul", 1.0 / k, self.scale)
        scale = self.cached(("scale", k), make)
        make = partial(self.operate, "mul", scale, self.at(self.rates[state], k - 1))
        return self.cached(("state", state, k), make)

    def by_recurrence(self, row: Recurrence, operands: tuple, k: int) -> Any:
        """Return coefficient k of an operation with a recurrence of its own."""
        total: Any = 0.0
        for sign, value in zip(row.signs, operands, strict=False):
            operation = "add" if sign > 0 else "sub"
            total = self.operate(operation, total, self.at(value, k))
        if row.products is not None:
            u, v = (operands[place] for place in row.products)
            if u == v:
                products = self.square(u, k, row.first)
            else:
                products = self.sum_of_products(
                    (self.at(u, j), self.at(v, k - j))
                    for j in outside_in(row.first, k - row.last)
                )
            total = self.operate("sub", total, products) if row.signs else products
        if row.divisor is None:
            return total
        inverse = self.inverse(operands[row.divisor], row.factor)
        return self.operate("mul", total, inverse)

    def square(self, a: Any, k: int, first: int) -> Any:
        """Return the sum of a_j a_(k - j) for j from `first` to k - `first`."""
        pairs = [(self.at(a, j), self.at(a, k - j)) for j in range(first, (k + 1) // 2)]
        half = self.sum_of_products(reversed(pairs))
        total = self.operate("mul", 2.0, half)
        if k % 2 or k // 2 < first:
            return total
        middle = self.at(a, k // 2)
        return self.sum_of_products([(middle, middle)], total)

    def inverse(self, argument: Any, factor: float) -> Any:
        """Return 1 / (factor a_0); a_0 must not reach 0 within a step."""
        self.keep_from_zero(argument)
        value = self.operate("mul", factor, self.at(argument, 0))
        make = partial(self.call, "div", 1.0, value)
        return self.cached(("inverse", argument, factor), make)

    def keep_from_zero(self, argument: Any) -> None:
        """Limit the change of what must not reach 0 within a step, or of its factors."""
        if self.is_constant(argument):
            return
        name, arguments, _ = self.components[argument[0]]
        if name not in ("mul", "sqrt"):
            self.limits[argument, True] = RELATIVE
            return
        for factor in arguments:
            self.keep_from_zero(factor)

    def by_slopes(self, argument: Any, k: int) -> Any:
        """Return coefficient k of an operation with the slopes of its row."""
        name, arguments, _ = self.components[argument[0]]
        row = TABLE.get(name, NO_ROW)
        if not row.slopes or row.smoothness not in ALL_SMOOTH:
            raise Uncompiled(f"has the operation {name}")
        nodes = [
            Node(self, a) if type(a) is tuple else a for a in (*arguments, argument)
        ]
        pairs = []
        for a, slope in zip(arguments, row.slopes, strict=True):
            if self.is_constant(a):
                continue
            value = slope(*nodes)
            of_slope = value.argument if isinstance(value, Node) else float(value)
            if not self.divides(of_slope):
                self.limits[a, False] = ABSOLUTE
            for j in outside_in(1, k):
                make = partial(self.operate, "mul", float(j), self.at(a, j))
                times_j = self.cached(("times", a, j), make)
                pairs.append((times_j, self.at(of_slope, k - j)))
        return self.operate("mul", 1.0 / k, self.sum_of_products(pairs))

    def divides(self, argument: Any) -> bool:
        """Return whether an argument is a quotient, whose divisor has a limit of its own."""
        return type(argument) is tuple and self.components[argument[0]].name == "div"


def is_whole(exponent: Any) -> bool:
    """Return whether a power is a product."""
    return type(exponent) is float and exponent >= 1.0 and exponent.is_integer()


def outside_in(first: int, last: int) -> list[int]:
    """Return numbers from the middle to the ends: products of the latest coefficients come last."""
    return sorted(range(first, last + 1), key=lambda j: -min(j, last - j))
