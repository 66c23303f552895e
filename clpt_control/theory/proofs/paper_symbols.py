"""Symbols of a diagram's states, ports and parameters, and domains of operations.

A port `x[2]` becomes x_1, x_2; one of shape (2, N), such as `alpha`, becomes alpha_1[1] ...
alpha_2[N], axis then basis function, both from 1, or alpha_1[k] for every N.  A state that is no
port of the diagram has the prefix of its block, and so does every parameter; fields that are one
number in the paper (`PAPER_FIELDS`) are one symbol if they have the same values.  A parameter has
the sign of its value, and one that is zero is zero.

SymPy cancels z z/z to z; the equations that run return NaN at z = 0.  So every operation of a
record that is undefined somewhere is checked against its domain (`DOMAINS`).
"""

from collections.abc import Callable, Iterable, Sequence
from functools import lru_cache
from typing import Any, NamedTuple

import numpy as np
import sympy
from sympy import Expr, S

from ...engine.diagram.symbol_names import Names
from ...engine.diagram.wiring import Node, Wiring
from ...engine.model.block import Block
from ...engine.model.ports import named, split
from ...engine.record.graph import Shape
from ...engine.record.scalar_graph import Index
from ...engine.record.symbolic import extent
from ...paper.scenario.quantities import QUANTITIES
from ..algebra.facts import interval, is_positive_maximum, stays_off_zero

# name in the paper -> fields of blocks
PAPER_FIELDS = {q.symbol: q.parameters.split() for q in QUANTITIES.values() if q.symbol}
PAPER_FIELDS["kappa"] = ["consensus.coupling"]
PAPER_NAMES = {field: name for name, fields in PAPER_FIELDS.items() for field in fields}
SHARED = ("theta", "gamma", "kappa")  # by all vehicles of a team
SCALARS = ("gamma",)  # one number in the paper, in any shape in a block


def _indexed(name: str, index: Index, has_axis: bool) -> str:
    """Return a name with its index, counted from 1; the first may be the paper's axis."""
    numbers = [k if isinstance(k, str) else str(k + 1) for k in index]
    if has_axis and numbers:
        name = f"{name}_{numbers.pop(0)}"
    return name + "".join(f"[{number}]" for number in numbers)


def paper_name(block: str, field: str) -> str | None:
    """Return the paper's name of a field, with the vehicle's name unless all share it."""
    vehicle, kind = split(block)
    name = PAPER_NAMES.get(f"{kind}.{field}")
    if name is None or name in SHARED or not vehicle:
        return name
    return named(vehicle, name)


def parameter_names(blocks: Sequence[Block]) -> dict[tuple[str, str], str]:
    """Return (block, field) -> the paper's name if all its fields agree, otherwise block.field."""
    values: dict[str, list[Any]] = {}
    for block in blocks:
        for field, value in block.parameters._asdict().items():
            name = paper_name(block.name, field)
            if name is not None:
                values.setdefault(name, []).append(value)
    ports = {port for b in blocks for port in (*b.input_ports, *b.output_ports)}
    equal = {name for name in values if _are_equal(name, values[name])} - ports
    names = {}
    for block in blocks:
        for field in block.parameters._fields:
            name = paper_name(block.name, field)
            own_name = f"{block.name}.{field}"
            names[block.name, field] = name if name in equal and name else own_name
    return names


def _are_equal(name: str, values: list) -> bool:
    """Return whether all values of a name are equal; scalars in any shape."""
    if name in SCALARS:
        values = np.concatenate([np.ravel(value) for value in values]).tolist()
    return all(np.array_equal(value, values[0]) for value in values)


def parameter_symbol(name: str, value: Any, index: Index) -> Expr:
    """Return the symbol of a parameter's element, or zero; it has the sign that all values have."""
    signs = {*np.sign(np.asarray(value, float)).flat}
    if name.endswith(".interval"):
        signs = set()  # its value, -1, only marks that intervals are counted
    if signs == {0}:
        return S.Zero
    if index and name not in SCALARS:
        has_axis = split(name)[1] in PAPER_FIELDS and np.shape(value)[0] == 2
        name = _indexed(name, index, has_axis)
    sign = "positive" if signs == {1} else "negative" if signs == {-1} else "real"
    return sympy.Symbol(name, **{sign: True})


class PaperNames(Names):
    """The paper's names of ports and parameters."""

    def __init__(self, wiring: Wiring, inputs: Iterable[str]):
        blocks = [node.system for node in wiring.nodes]
        self.fields = parameter_names(blocks)
        owners = {port: block.name for block in blocks for port in block.output_ports}
        self.states = {}
        for block in blocks:
            for port in block.state_ports:
                is_output = owners.get(port) == block.name
                name = port if is_output else f"{block.name}:{port}"
                self.states[block.name, port] = name

    def port(self, node: Node, group: str, kind: str) -> str:
        """Return the name of a port or a parameter."""
        names = {"state": self.states, "parameter": self.fields}.get(kind, {})
        return names.get((node.system.name, group), group)

    def block(self, node: Node) -> str:
        """Return the name of a block."""
        return node.system.name

    def element(self, port: str, shape: Shape, declared: Shape, index: tuple) -> str:
        """Return the name of one signal: x_1, alpha_1[2], phi_x[k], P[k][j].

        A first axis of known length is the paper's axis; in `declared`, sizes may have names.
        """
        has_axis = bool(declared) and isinstance(declared[0], int)
        return _indexed(port, index, has_axis)

    def parameter(self, node: Node, name: str, value: np.ndarray, index: tuple) -> Expr:
        """Return a symbol of the sign that all values have."""
        return parameter_symbol(self.port(node, name, "parameter"), value, index)


# --- domains of operations ------------------------------------------------------------------

MOST_EXP = 700  # exp of larger numbers overflows
DEEPEST = 12  # levels of operations; SymPy takes too long for deeper ones


class Domain(NamedTuple):
    """Arguments at which an operation has a value."""

    problem: str  # of other arguments
    contains: Callable[..., bool | None]


def _has_quotient(a: Expr, b: Expr) -> bool:
    """Return whether a divisor b is known to be nonzero."""

    def excludes_zero(e: Expr) -> bool:
        return bool(e.is_nonzero) or stays_off_zero(e)

    if is_positive_maximum(b) or excludes_zero(sympy.expand(b)):
        return True
    return all(map(excludes_zero, sympy.Mul.make_args(b)))


def _no_overflow(*exponents: Expr) -> bool:
    """Return whether exp of each is a number; expressions of parameters are not checked."""
    varying = (a for a in exponents if not all("." in s.name for s in a.free_symbols))
    return all(interval(a)[1] <= MOST_EXP for a in varying)


def _has_power(base: Expr, exponent: Expr) -> bool:
    """Return whether a power is known to have a value."""
    low, _ = interval(base)
    if low.is_positive or base.is_positive or (low == 0 and exponent.is_positive):
        return True
    is_finite = exponent.is_nonnegative or base.is_nonzero
    return bool(exponent.is_integer and is_finite)


def _in_row(index: Expr, *row: Expr) -> bool:
    """Return whether an index is in a row; a negative one counts from the end of the row."""
    size = len(row)
    if index.func.__name__ == "mod" and index.args[1] == size:
        return True
    low, high = interval(index)
    return bool((low + size + 1).is_positive and (size - high).is_positive)


QUOTIENT = Domain("divides by {1}, which may be zero", _has_quotient)
EXPONENTIAL = Domain("takes exp of {0}, which may be too large", _no_overflow)
HYPERBOLIC = Domain(
    "takes sinh or cosh of {0}, which may be too large", lambda a: _no_overflow(a, -a)
)
LOGARITHM = Domain(
    "takes the logarithm of {0}, which may have no value",
    lambda a: a.is_positive or interval(a)[0].is_positive,
)
ARC = Domain(
    "takes an angle of {0}, which may have none", lambda a: (1 - a**2).is_nonnegative
)
DOMAINS = {
    "div": QUOTIENT,
    "floordiv": QUOTIENT,
    "mod": Domain("takes the remainder by {1}, which may be zero", _has_quotient),
    "pow": Domain("raises {0} to the power {1}, which may have no value", _has_power),
    "sqrt": Domain(
        "takes the root of {0}, which may be negative",
        lambda a: interval(a)[0].is_nonnegative,
    ),
    "log1p": Domain(
        "takes log(1 + {0}), which may have no value", lambda a: (1 + a).is_positive
    ),
    "tan": Domain("takes the tangent of {0}, which may have no value", lambda a: False),
    "atanh": Domain(
        "takes atanh of {0}, which may have no value", lambda a: (1 - a**2).is_positive
    ),
    "acosh": Domain(
        "takes acosh of {0}, which may have no value", lambda a: (a - 1).is_nonnegative
    ),
    "pick": Domain("reads a table at {0}, which may be outside of it", _in_row),
    **dict.fromkeys(("exp", "expm1"), EXPONENTIAL),
    **dict.fromkeys(("sinh", "cosh"), HYPERBOLIC),
    **dict.fromkeys(("log", "log2", "log10"), LOGARITHM),
    **dict.fromkeys(("asin", "acos"), ARC),
}


@lru_cache(maxsize=10_000)
def undefined(name: str, arguments: tuple) -> str | None:
    """Return a problem, such as "divides by z, which may be zero", or None.

    `name` is an operation of a record, the arguments are expressions.
    """
    if name not in DOMAINS:
        return None
    domain = DOMAINS[name]
    arguments = tuple(map(sympy.sympify, arguments))
    if name == "div" and is_positive_maximum(arguments[1]):
        return None
    is_shallow = name == "pick" or all(extent(a)[1] <= DEEPEST for a in arguments)
    if is_shallow and domain.contains(*arguments):
        return None
    return domain.problem.format(*arguments)
