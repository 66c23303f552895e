"""Specifications of runs: texts, or functions of named signals, as margins.

    level < 0.9             0.9 - level
    a < b and c >= d        min(b - a, c - d)

A margin is above 0 where a specification holds.  One function serves boxes (`Node`s of a program)
and runs (arrays over time).  Names are those of outputs and states, and t.
"""

import ast
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import reduce
from types import SimpleNamespace
from typing import Any

import numpy as np

from ...base.arguments import brief, known
from ...base.errors import ArgumentError, ClptError, Uncompiled
from ...engine.codegen.series import Node
from ...engine.record.operations import UFUNCS

GRAMMAR = (
    "Give a comparison such as 'level < 0.9', or several with `and`, of names, numbers and "
    "functions of NumPy"
)
NO_FUNCTION = (
    "is no number of the signals. Use operators and functions of NumPy such as np.hypot and "
    "np.minimum, on single signals"
)
OPERATORS: dict[type, Callable[..., Any]] = {
    ast.Add: np.add,
    ast.Sub: np.subtract,
    ast.Mult: np.multiply,
    ast.Div: np.true_divide,
    ast.Pow: np.power,
    ast.USub: np.negative,
    ast.UAdd: lambda a: a,
}
NAMES = {"abs": np.absolute, "min": np.minimum, "max": np.maximum, "pi": np.pi}
FUNCTIONS = {u.__name__: u for u in UFUNCS if isinstance(u, np.ufunc)} | NAMES


@dataclass(frozen=True)
class Specification:
    """A condition of runs from a time on: `margin` of the signals is above 0, or 0 unless `strict`.

    `sign` is -1 of what must never hold.
    """

    claim: str  # "always level < 0.9"
    margin: Callable[[Any], Any]
    strict: bool | None  # None where parts differ: 0 then decides nothing
    begin: float
    sign: float

    def of(self, signals: Mapping[str, Any]) -> Any:
        """Return the margin of signals by name."""
        try:
            value = self.margin(SimpleNamespace(**signals))
            value = value if self.sign > 0.0 else np.negative(value)
        except AttributeError as error:
            names = [*signals]
            raise ArgumentError(
                f"{self.claim}: has no signal '{error.name}'. {known(str(error.name), names)}"
            ) from None
        except ClptError as error:
            if not isinstance(error, Uncompiled):
                raise
            raise ArgumentError(f"{self.claim}: {NO_FUNCTION}") from None
        except Exception as error:
            cause = f"{self.claim}: {NO_FUNCTION}"
            raise ArgumentError(cause) from error
        if isinstance(value, np.ndarray) and value.dtype == object:
            raise ArgumentError(
                f"{self.claim}: has several values. Name one element of a port, such as x[0]"
            )
        if not isinstance(value, Node | np.ndarray | float | int | np.number):
            raise ArgumentError(f"{self.claim}: {NO_FUNCTION}")
        return value

    def holds(self, lower: Any) -> Any:
        """Return whether lower bounds of the margin show that it holds."""
        return (lower >= 0.0) if self.strict is False else (lower > 0.0)

    def fails(self, upper: Any) -> Any:
        """Return whether upper bounds of the margin show that it does not hold."""
        return (upper <= 0.0) if self.strict is True else (upper < 0.0)


def specification_of(
    argument: str, given: Any, begin: float, sign: float
) -> Specification:
    """Read an argument of `verify`: a text, or a function of signals."""
    when = f"from t = {begin:.9g} on" if argument == "by" else argument
    if callable(given):
        return Specification(
            f"{when} the function's condition", given, sign > 0.0, begin, sign
        )
    if not isinstance(given, str):
        raise ArgumentError(f"{argument} = {brief(given)}: is no text. {GRAMMAR}")
    try:
        body = ast.parse(given.strip(), mode="eval").body
    except SyntaxError:
        raise ArgumentError(
            f"{argument} = '{given}': is no formula. {GRAMMAR}"
        ) from None
    terms = body.values if isinstance(body, ast.BoolOp) else [body]
    is_and = not isinstance(body, ast.BoolOp) or isinstance(body.op, ast.And)
    if not (is_and and all(isinstance(term, ast.Compare) for term in terms)):
        raise ArgumentError(f"{argument} = '{given}': is no comparison. {GRAMMAR}")
    pairs, kinds = [], set()
    for term in terms:
        sides = [term.left, *term.comparators]  # type: ignore[attr-defined]
        for left, kind, right in zip(sides, term.ops, sides[1:], strict=False):  # type: ignore[attr-defined]
            if not isinstance(kind, ast.Lt | ast.LtE | ast.Gt | ast.GtE):
                raise ArgumentError(
                    f"{argument} = '{given}': compares by other than <, <=, > and >=. {GRAMMAR}"
                )
            kinds.add(isinstance(kind, ast.Lt | ast.Gt))
            is_less = isinstance(kind, ast.Lt | ast.LtE)
            pairs.append((left, right) if is_less else (right, left))
    where = f"{argument} = '{given}'"
    functions = [(_formula(where, low), _formula(where, high)) for low, high in pairs]

    def margin(s: Any) -> Any:
        return reduce(np.minimum, (high(s) - low(s) for low, high in functions))

    # what must never hold fails where it holds, bounds included or not
    strict = None if len(kinds) > 1 else kinds == {sign > 0.0}
    return Specification(f"{when} {given.strip()}", margin, strict, begin, sign)


def element(port: Any, k: int) -> Any:
    """Return an element of a port; that of one element is its number 0."""
    is_port = isinstance(port, np.ndarray) and port.dtype == object
    return port[k] if is_port else [port][k]


def _formula(where: str, node: ast.expr) -> Callable[[Any], Any]:
    """Return a formula as a function of signals; nothing of it is run by Python."""
    match node:
        case ast.Constant(value=int() | float() as value) if value is not True:
            return lambda s: float(value)
        case ast.Name(id=name):
            return lambda s: NAMES["pi"] if name == "pi" else getattr(s, name)
        case ast.Subscript(
            value=ast.Name(id=name), slice=ast.Constant(value=int() as k)
        ):
            return lambda s: element(getattr(s, name), k)
        case ast.BinOp(left=a, op=op, right=b) if type(op) in OPERATORS:
            return _call(where, OPERATORS[type(op)], [a, b])
        case ast.UnaryOp(operand=a, op=op) if type(op) in OPERATORS:
            return _call(where, OPERATORS[type(op)], [a])
        case ast.Call(
            func=ast.Name(id=name) | ast.Attribute(value=ast.Name(id="np"), attr=name),
            args=parts,
            keywords=[],
        ) if callable(function := FUNCTIONS.get(name)) and len(parts) == getattr(
            function, "nin", 1
        ):
            return _call(where, function, parts)
    raise ArgumentError(f"{where}: '{ast.unparse(node)}' is not read. {GRAMMAR}")


def _call(
    where: str, function: Callable[..., Any], parts: list[ast.expr]
) -> Callable[[Any], Any]:
    """Return a function of formulas."""
    functions = [_formula(where, part) for part in parts]
    return lambda s: function(*(of(s) for of in functions))


def named(labels: list[str], values: Any, signals: dict[str, Any]) -> dict[str, Any]:
    """Return signals with those of labels such as x[0] and x[1], an array, or y[0], a number."""
    ports: dict[str, list[Any]] = {}
    for label, value in zip(labels, values, strict=True):
        name = label.rpartition("[")[0] if label.endswith("]") else label
        ports.setdefault(name, []).append(value)
    for name, of in ports.items():
        array = np.empty(len(of), dtype=object)
        array[:] = of
        signals.setdefault(name, of[0] if len(of) == 1 else array)
    return signals
