"""The SymPy reading of a record: expressions of symbols.

Words with kinks, comparisons and remainders are undefined functions, so a proof holds
for any functions in their place.  An opaque helper is an undefined function of its
arguments, `lookup` one of the table's name and the index.
"""

from collections.abc import Callable
from functools import cache, lru_cache
from math import copysign, isfinite
from typing import Any

import numpy as np
import sympy

from ..errors import BlockError
from . import at_many
from .scalars import Scalars


@lru_cache(maxsize=10_000)
def exact(number: float) -> sympy.Expr:
    """Return a constant as a rational: 0.1 is 1/10."""
    return sympy.nsimplify(number, rational=True)


def expressions(
    record: Scalars,
    leaf: Callable[..., Any],
    constant: Callable[[float], Any] = exact,
    watch: Callable[[str, tuple], Any] = lambda name, arguments: None,
) -> list[sympy.Expr]:
    """Return what a record computes, on symbols.

    ``leaf("x", 0)`` is an expression, ``leaf("table", (field, first, stride, count))`` a name for
    these numbers of a parameter; `watch` gets each operation and its arguments.
    """

    def read(value: Any) -> Any:
        return constant(value) if type(value) is float else value

    def apply(name: str, *arguments: Any) -> Any:
        if name == "table":
            return sympy.Function(f"lookup_{leaf(name, arguments[1])}", real=True)(arguments[0])
        if name == "opaque":
            (helper, *places), _, *given = arguments
            parts = [str(leaf("table", s) if isinstance(s, tuple) else s) for s in places if s != 0]
            named = "_".join([f"{helper}()", *parts])
            return sympy.Function(named, real=True)(*map(read, given))
        numbers = tuple(map(read, arguments))
        watch(name, numbers)
        return OPERATIONS[name](*numbers)

    return [read(value) for value in record.replay(leaf, apply)]


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


# what loses its digits, or its range, written out: log1p(a) as log(1 + a)
KEPT = {name: sympy.Function(f"{name}_", real=True) for name in ("hypot", "log1p", "expm1")}
CIRCULAR = ("sin", "cos", "tan")  # NaN beyond MOST_ANGLE, as in every reading


class SymbolicFunction:
    """A record as SymPy's expressions, to be called with numbers.

    What is used twice is a symbol of its own, so that expressions stay short.
    """

    def __init__(self, record: Scalars):
        self.record = record
        self.leaves: dict[tuple, sympy.Symbol] = {}
        self.steps: list[tuple[sympy.Symbol, sympy.Expr]] = []
        uses = [0] * len(record.operations)
        for name, *arguments in record.operations:
            for a in arguments if name not in ("x", "u", "p", "t") else ():
                if type(a) is int:
                    uses[a] += 1
        names = iter(range(len(uses)))
        often = (
            uses[k] > 1
            for k, (name, *_) in enumerate(record.operations)
            if name not in ("x", "u", "p", "t")
        )

        def leaf(*where: Any) -> Any:
            return self.leaves.setdefault(where, sympy.Symbol(f"leaf{len(self.leaves)}", real=True))

        def constant(number: float) -> Any:
            known = number and isfinite(number)  # SymPy makes no more of 0 * x than of x
            return sympy.Float(number) if known else leaf("constant", number, copysign(1.0, number))

        def apply(name: str, *arguments: Any) -> Any:
            shared = next(often)
            read = [constant(a) if type(a) is float else a for a in arguments]
            if name == "table":
                value = sympy.Function("picked", real=True)(leaf(name, *arguments[1]), read[0])
            elif name == "opaque":
                value = read[1]
            else:
                value = KEPT.get(name, OPERATIONS[name])(*read)
            if not shared or not isinstance(value, sympy.Expr):
                return value
            symbol = sympy.Symbol(f"step{next(names)}", real=True)
            self.steps.append((symbol, value))
            return symbol

        found = record.replay(leaf, apply)
        self.outputs = [constant(v) if type(v) is float else sympy.sympify(v) for v in found]
        for value in (*self.outputs, *(value for _, value in self.steps)):
            if value.has(sympy.zoo, sympy.nan, sympy.I):
                raise BlockError(f"SymPy finds that the equations divide by zero: {value}")
        self._compiled = self._function()

    def _function(self) -> Callable:
        from sympy.printing.numpy import SciPyPrinter

        settings = {
            "fully_qualified_modules": True,
            "allow_unknown_functions": True,
            "user_functions": {name: f"{name}_" for name in CIRCULAR},
        }
        printer = SciPyPrinter(settings)
        lines = [f"    {symbol} = {printer.doprint(value)}" for symbol, value in self.steps]
        outputs = ", ".join(printer.doprint(value) for value in self.outputs)
        arguments = ", ".join(map(str, self.leaves.values()))
        text = "\n".join([f"def values({arguments}):", *lines, f"    return [{outputs}]"])
        space: dict[str, Any] = {"numpy": np, "picked": at_many.picked}
        space |= {own: at_many.OPERATIONS[name] for name, own in UNEXPANDED.items()}
        space |= {f"{name}_": at_many.OPERATIONS[name] for name in (*KEPT, *CIRCULAR)}
        if "scipy" in text:
            import scipy.special

            space["scipy"] = scipy
        exec(compile(text, "<the SymPy reading>", "exec"), space)
        return space["values"]

    def __call__(self, t: float, x: Any, u: Any, p: Any) -> np.ndarray:
        """Return the value of each output; p has `interval` filled in."""
        numbers = []
        for name, *where in self.leaves:
            if name == "t":
                numbers.append(t)
            elif name == "p":
                numbers.append(np.ravel(getattr(p, where[0]))[where[1]])
            elif name == "constant":
                numbers.append(where[0])
            elif name == "table":
                field, first, stride, count = where
                places = first + stride * np.arange(count)
                numbers.append(np.ravel(getattr(p, field))[places])
            else:
                numbers.append((x if name == "x" else u)[where[0]])
        with np.errstate(all="ignore"):
            return np.array(
                self._compiled(*(np.asarray(n, dtype=float)[()] for n in numbers)), dtype=float
            )


@cache
def in_sympy(record: Scalars) -> SymbolicFunction:
    """Return the SymPy reading of a record, made once."""
    return SymbolicFunction(record)
