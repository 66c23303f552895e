"""The symbols of a diagram's states, ports and parameters, and where equations have a value.

A port `x[2]` becomes x_1, x_2; one of shape (2, N), such as `alpha`, becomes alpha_1[1] ...
alpha_2[N], axis then basis function, both from 1, or alpha_1[k] for every N.  A state that is no
port of the diagram carries its block's name, and so does every parameter; fields that
are one number in the paper (`ONE`) are one symbol where they hold the same values.
A parameter has the sign of its value, and one that is zero is zero.

SymPy cancels z z/z to z; the equations that run give NaN at z = 0.  So every operation of a record
that has no value somewhere is checked (`DEMANDS`): may it get there?
"""

from collections.abc import Callable, Iterable, Sequence
from functools import lru_cache
from typing import Any

import numpy as np
import sympy

from ...engine.diagram.symbol_names import Names
from ...engine.diagram.wiring import Node, Wiring
from ...engine.model.block import Block
from ...engine.model.ports import named, split
from ...engine.record.graph import Shape
from ...engine.record.scalar_graph import Index
from ...engine.record.symbolic import extent
from ...paper.scenario.quantities import QUANTITIES
from .facts import interval, positive_maximum

# fields that stand for one thing, by its name in the paper
ONE = {one.symbol: one.parameters.split() for one in QUANTITIES.values() if one.symbol}
ONE["kappa"] = ["consensus.coupling"]
SHARED = ("theta", "gamma", "kappa")  # by all vehicles of a team
SCALARS = ("gamma",)  # one number in the paper, whatever shape a block keeps it in
_NAMES = {field: name for name, fields in ONE.items() for field in fields}


def _indexed(name: str, index: Index, axis: bool) -> str:
    """Return a name with its index, counted from 1; the first may be the paper's axis."""
    places = [place if isinstance(place, str) else str(place + 1) for place in index]
    first = f"_{places.pop(0)}" if axis and places else ""
    return name + first + "".join(f"[{place}]" for place in places)


def paper_name(block: str, field: str) -> str | None:
    """Return what the paper calls a field, with the vehicle's name where it is its own."""
    vehicle, kind = split(block)
    name = _NAMES.get(f"{kind}.{field}")
    return (
        name if name is None or not vehicle or name in SHARED else named(vehicle, name)
    )


def parameter_names(blocks: Sequence[Block]) -> dict[tuple[str, str], str]:
    """Return (block, field) -> the paper's name where all fields of it agree, else block.field."""
    values: dict[str, list[Any]] = {}
    for block in blocks:
        for field, value in block.parameters._asdict().items():
            name = paper_name(block.name, field)
            if name is not None:
                values.setdefault(name, []).append(value)
    ports = {port for b in blocks for port in (*b.input_ports, *b.output_ports)}
    shared = {name for name, own in values.items() if _same(name, own)} - ports
    names = {}
    for block in blocks:
        for field in block.parameters._fields:
            name = paper_name(block.name, field)
            names[block.name, field] = (
                name if name in shared else f"{block.name}.{field}"
            )
    return names


def parameter_symbol(name: str, value: Any, index: Index) -> sympy.Expr:
    """Return the symbol of a parameter's element; it has the sign that all values have."""
    if name in SCALARS or not index:
        return signed(name, value)
    axis = split(name)[1] in ONE and np.shape(value)[0] == 2
    return signed(_indexed(name, index, axis), value)


def signed(name: str, value: Any) -> sympy.Expr:
    """Return a symbol with the sign that all values have, or zero."""
    # an interval's own value, -1, says only that it is counted
    signs = (
        set()
        if name.endswith(".interval")
        else {*np.sign(np.asarray(value, float)).flat}
    )
    if signs == {0}:
        return sympy.Integer(0)
    sign = "positive" if signs == {1} else "negative" if signs == {-1} else "real"
    return sympy.Symbol(name, **{sign: True})


def _same(name: str, values: list) -> bool:
    if name in SCALARS:  # in whatever shape
        return all(
            np.all(np.asarray(value) == np.ravel(values[0])[0]) for value in values
        )
    return all(np.array_equal(value, values[0]) for value in values)


class PaperNames(Names):
    """What the paper calls ports and parameters, as in the reading for every N."""

    def __init__(self, wiring: Wiring, inputs: Iterable[str]):
        blocks = [node.system for node in wiring.nodes]
        self.fields = parameter_names(blocks)
        maker = {port: block.name for block in blocks for port in block.output_ports}
        self.states = {  # its port, or block:port
            (b.name, port): port if maker.get(port) == b.name else f"{b.name}:{port}"
            for b in blocks
            for port in b.state_ports
        }

    def port(self, node: Node, group: str, kind: str) -> str:
        """Return what a port or a parameter is called."""
        known = {"state": self.states, "parameter": self.fields}.get(kind, {})
        return known.get((node.system.name, group), group)

    def block(self, node: Node) -> str:
        """Return a block's own name."""
        return node.system.name

    def element(self, port: str, shape: Shape, declared: Shape, index: tuple) -> str:
        """Return the name of one signal: x_1, alpha_1[2], phi_x[k], P[k][j].

        A first axis of known length is the paper's axis; `declared` has names where a size has one.
        """
        return _indexed(port, index, bool(declared) and isinstance(declared[0], int))

    def parameter(
        self, node: Node, name: str, value: np.ndarray, index: tuple
    ) -> sympy.Expr:
        """Return a symbol of the sign that all values have."""
        return parameter_symbol(self.port(node, name, "parameter"), value, index)


MOST_EXP = 700  # of which exp is a number
DEEPEST = 12  # levels of operations; deeper ones would take SymPy too long


def _nonzero(b: sympy.Expr) -> bool:
    """Return whether a divisor is known not to be zero; maximum(a, b) is not where b > 0."""

    def apart(f: sympy.Expr) -> bool:
        low, high = interval(f)
        return bool(f.is_nonzero or low.is_positive or high.is_negative)

    return (
        positive_maximum(b)
        or apart(sympy.expand(b))
        or all(map(apart, sympy.Mul.make_args(b)))
    )


def _not_huge(*exponents: sympy.Expr) -> bool:
    """Return whether exp of each stays a number; parameters are what their block makes of them."""
    moving = (a for a in exponents if not all("." in s.name for s in a.free_symbols))
    return all(interval(a)[1] <= MOST_EXP for a in moving)


def _power(base: sympy.Expr, exponent: sympy.Expr) -> bool:
    integer = bool(exponent.is_integer)
    return bool(
        (integer and (exponent.is_nonnegative or base.is_nonzero))
        or base.is_positive
        or (base.is_nonnegative and exponent.is_positive)
    )


def _in_table(place: sympy.Expr, *row: sympy.Expr) -> bool:
    """Return whether a place is known to be one of a row; places below zero count from its end."""
    low, high = interval(place)
    counted = place.func.__name__ == "mod" and place.args[1] == len(row)
    return bool(
        counted or ((low + len(row) + 1).is_positive and (len(row) - high).is_positive)
    )


DEMANDS: dict[str, tuple[str, Callable[..., bool | None]]] = {
    name: (f"{sentence}, which may {fails}", allowed)
    for names, sentence, fails, allowed in (  # whether arguments are known to be allowed
        ("div floordiv", "divides by {1}", "be zero", lambda a, b: _nonzero(b)),
        ("mod", "takes the remainder by {1}", "be zero", lambda a, b: _nonzero(b)),
        ("pow", "raises {0} to the power {1}", "have no value", _power),
        ("sqrt", "takes the root of {0}", "be negative", lambda a: a.is_nonnegative),
        ("log1p", "takes log(1 + {0})", "have no value", lambda a: (1 + a).is_positive),
        ("tan", "takes the tangent of {0}", "have no value", lambda a: False),
        (
            "atanh",
            "takes atanh of {0}",
            "have no value",
            lambda a: (1 - a**2).is_positive,
        ),
        (
            "acosh",
            "takes acosh of {0}",
            "have no value",
            lambda a: (a - 1).is_nonnegative,
        ),
        ("exp expm1", "takes exp of {0}", "be too large", lambda a: _not_huge(a)),
        (
            "sinh cosh",
            "takes sinh or cosh of {0}",
            "be too large",
            lambda a: _not_huge(a, -a),
        ),
        (
            "log log2 log10",
            "takes the logarithm of {0}",
            "have no value",
            lambda a: a.is_positive,
        ),
        ("pick", "reads a table at {0}", "be outside of it", _in_table),
        (
            "asin acos",
            "takes an angle of {0}",
            "have none",
            lambda a: (1 - a**2).is_nonnegative,
        ),
    )
    for name in names.split()
}


@lru_cache(maxsize=10_000)
def undefined(name: str, arguments: tuple) -> str | None:
    """Return what may have no value, such as "divides by z, which may be zero", or None.

    `name` is an operation of a record, the arguments are expressions.
    """
    if name not in DEMANDS:
        return None
    sentence, allowed = DEMANDS[name]
    arguments = tuple(map(sympy.sympify, arguments))
    if name == "div" and positive_maximum(arguments[1]):
        return None
    shallow = name == "pick" or all(extent(a)[1] <= DEEPEST for a in arguments)
    return None if shallow and allowed(*arguments) else sentence.format(*arguments)
