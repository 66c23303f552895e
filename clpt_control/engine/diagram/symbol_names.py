"""What states, inputs, outputs and parameters are called where equations are on symbols.

A state or input is called as python-control labels it, "y", or "x[0]" where there are several; a
parameter has its own name.  If two have one name, the block comes first: "plant.y"; of a state and
another output of one block, before the state; "plant.parameter.y" is a parameter called as a state
or an output of its block.  `Names` holds these rules; a theory may have others.
"""

from collections import Counter
from collections.abc import Iterable
from math import prod
from typing import Any

import numpy as np
import sympy
from sympy.core.function import AppliedUndef

from ..model.ports import ports_of
from ..model.system import System, is_linear
from ..record.graph import Shape
from ..record.symbolic import rational
from .wiring import Node, Wiring

TIME = sympy.Symbol("t", real=True)


def typeset(expression: Any) -> str:
    """Return an expression as LaTeX, ``plant.x[0]`` as an x with its place and its block."""
    expression = sympy.sympify(expression)
    inputs = {
        f: sympy.Symbol(str(f.func)) for f in expression.atoms(AppliedUndef) if f.args == (TIME,)
    }
    expression = expression.xreplace(inputs)
    latex = {}
    for symbol in expression.free_symbols:
        space, _, own = str(symbol).rpartition(".")
        name, _, place = own.rstrip("]").partition("[")
        base = sympy.latex(sympy.Symbol(name))
        base = rf"\mathrm{{{name}}}" if base == name and name[1:] else base
        base = f"{{{base}}}_{{{place}}}" if place else base
        space = space.replace("_", r"\_")
        latex[symbol] = base + (rf"^{{\mathrm{{{space}}}}}" if space else "")
    return sympy.latex(expression, symbol_names=latex, mul_symbol=r"\,")


def element_name(port: str, shape: Shape, index: tuple) -> str:
    """Return the name of one element of a port: y, x[0], P[0,1]."""
    return port if prod(shape) == 1 else f"{port}[{','.join(map(str, index))}]"


Group = tuple[str, list[int], Shape]  # a name, its places among a block's signals, its shape


def groups(system: Any, kind: str) -> list[Group]:
    """Return the ports that a block's labels of states or outputs form."""
    shapes = getattr(system, f"{kind}_shapes")
    found = []
    for port, places in ports_of(getattr(system, f"{kind}_labels")).items():
        own = shapes.get(port, (len(places),))
        found.append((port, places, own if prod(own) == len(places) else (len(places),)))
    return found


def fields_of(system: Any) -> list[str]:
    """Return a block's parameters; of python-control's params only those that functions read."""
    if not isinstance(system, System):
        return list(system.parameters._fields)
    records = [system.array_record(role) for role in {*system._roles, "output"}]
    return sorted({name for record in records for name in record.leaves("p")})


class Names:
    """The names of ports and parameters of a diagram."""

    def __init__(self, wiring: Wiring, inputs: Iterable[str]):
        found, shared = [*inputs], dict[str, list[Any]]()
        self.kinds: dict[tuple[str, str], list[str]] = {}  # of what a block has by a name
        for node in wiring.nodes:
            made, own = ([g for g, *_ in groups(node.system, kind)] for kind in ("output", "state"))
            own = [] if node.system.states_are_outputs and made == own else own
            found += dict.fromkeys(made + own)
            fields = fields_of(node.system)
            for kind, names in (("output", made), ("state", own), ("parameter", fields)):
                for name in names:
                    self.kinds.setdefault((node.name, name), []).append(kind)
            for name in fields:
                shared.setdefault(name, []).append(node.system)
        for name, systems in shared.items():  # python-control hands one value down to all
            values = [getattr(system.parameters, name) for system in systems]
            one = all(isinstance(system, System) for system in systems)
            one = one and all(np.array_equal(value, values[0]) for value in values)
            found += [name] * (1 if one else len(systems))
        self.count = Counter(found)

    def port(self, node: Node, group: str, kind: str) -> str:
        """Return the name of a port of a block, of kind state or output, or of a parameter."""
        alone = self.count[group] == 1
        if kind not in self.kinds.get((node.name, group), ())[1:]:
            return group if alone else f"{node.name}.{group}"
        alone = alone and kind == "state"
        return f"{node.name}.{group}" if alone else f"{node.name}.{kind}.{group}"

    def block(self, node: Node) -> str:
        """Return the name of a block."""
        return node.name

    def element(self, port: str, shape: Shape, declared: Shape, index: tuple) -> str:
        """Return the name of an element of a port."""
        return element_name(port, shape, index)

    def parameter(self, node: Node, own: str, value: np.ndarray, index: tuple) -> sympy.Expr:
        """Return the symbol of a parameter's element, which has the sign of its value."""
        number = float(value[index])
        if is_linear(node.system) or not np.isfinite(number):
            return rational(number)
        sign = "positive" if number > 0 else "negative" if number < 0 else "real"
        sign = "real" if own == "interval" else sign  # its own value, -1, says that it is counted
        name = element_name(self.port(node, own, "parameter"), value.shape, index)
        return sympy.Symbol(name, **{sign: True})


class Numbers(Names):
    """The same, with parameters as their numbers."""

    def parameter(self, node: Node, own: str, value: np.ndarray, index: tuple) -> sympy.Expr:
        """Return the number of a parameter's element, but of which interval it is."""
        if own == "interval":
            return super().parameter(node, own, value, index)
        return rational(float(value[index]))
