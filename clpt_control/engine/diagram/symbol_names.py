"""Names of states, inputs, outputs and parameters in symbolic equations.

A state or input has the label of python-control, "y", or "x[0]" for an element of a port.  A
parameter has its own name.  If two have the same name, the block's name is a prefix: "plant.y".  A
state and another output of one block may have the same name: the state gets the prefix.  A
parameter with the name of a state or an output of its block is "plant.parameter.y".  `Names` has
these rules; a theory may define other rules in a subclass.
"""

from collections import Counter
from collections.abc import Iterable, Set
from math import prod
from typing import Any, NamedTuple

import numpy as np
import sympy

from ..model.ports import ports_of
from ..model.system import System, is_linear
from ..record.graph import Shape
from ..record.symbolic import rational
from .wiring import Node, Wiring

TIME = sympy.Symbol("t", real=True)


def element_name(port: str, shape: Shape, index: tuple) -> str:
    """Return the name of one element of a port: y, x[0], P[0,1]."""
    if prod(shape) == 1:
        return port
    numbers = ",".join(map(str, index))
    return f"{port}[{numbers}]"


class Group(NamedTuple):
    """Signals of a block whose labels form a port."""

    name: str
    indices: list[int]  # among the block's signals
    shape: Shape


def groups(system: Any, kind: str) -> list[Group]:
    """Return the ports that a block's labels of states or outputs form."""
    shapes = getattr(system, f"{kind}_shapes")
    ports = []
    for port, indices in ports_of(getattr(system, f"{kind}_labels")).items():
        size = len(indices)
        shape = shapes.get(port, (size,))
        if prod(shape) != size:
            shape = (size,)
        ports.append(Group(port, indices, shape))
    return ports


def fields_of(system: Any) -> list[str]:
    """Return a block's parameters; of python-control's params only those that functions read."""
    if not isinstance(system, System):
        return list(system.parameters._fields)
    records = system.records.values()
    return sorted({name for record in records for name in record.leaves("p")})


class Names:
    """The names of ports and parameters of a diagram."""

    unsigned: Set[str] = frozenset()  # parameters that are any real numbers
    above: Set[str] = frozenset()  # states that stay above 0

    def __init__(self, wiring: Wiring, inputs: Iterable[str]):
        self.count = Counter([*inputs])
        self.kinds: dict[
            tuple[str, str], list[str]
        ] = {}  # (block, name) -> kinds with this name
        owners: dict[str, list[Any]] = {}  # of parameters
        for node in wiring.nodes:
            outputs = [group.name for group in groups(node.system, "output")]
            states = [group.name for group in groups(node.system, "state")]
            if node.system.states_are_outputs and outputs == states:
                states = []
            fields = fields_of(node.system)
            self.count.update({*outputs, *states})
            for kind, names in (
                ("output", outputs),
                ("state", states),
                ("parameter", fields),
            ):
                for name in names:
                    self.kinds.setdefault((node.name, name), []).append(kind)
            for name in fields:
                owners.setdefault(name, []).append(node.system)
        for name, systems in owners.items():
            values = [getattr(system.parameters, name) for system in systems]
            # python-control gives all its systems the same value
            is_shared = all(isinstance(system, System) for system in systems)
            is_shared = is_shared and all(
                np.array_equal(value, values[0]) for value in values
            )
            self.count[name] += 1 if is_shared else len(systems)

    def port(self, node: Node, group: str, kind: str) -> str:
        """Return the name of a port of a block, of kind state or output, or of a parameter."""
        is_unique = self.count[group] == 1
        if kind not in self.kinds.get((node.name, group), ())[1:]:
            return group if is_unique else f"{node.name}.{group}"
        is_unique = is_unique and kind == "state"
        return f"{node.name}.{group}" if is_unique else f"{node.name}.{kind}.{group}"

    def block(self, node: Node) -> str:
        """Return the name of a block."""
        return node.name

    def element(self, port: str, shape: Shape, declared: Shape, index: tuple) -> str:
        """Return the name of an element of a port."""
        return element_name(port, shape, index)

    def state(self, element: str) -> sympy.Symbol:
        """Return the symbol of a state's element."""
        sign = "positive" if element in self.above else "real"
        return sympy.Symbol(element, **{sign: True})

    def parameter(
        self, node: Node, name: str, value: np.ndarray, index: tuple
    ) -> sympy.Expr:
        """Return the symbol of a parameter's element, with the sign of its value."""
        number = float(value[index])
        if is_linear(node.system) or not np.isfinite(number):
            return rational(number)
        sign = "positive" if number > 0 else "negative" if number < 0 else "real"
        label = element_name(self.port(node, name, "parameter"), value.shape, index)
        # an interval's value -1 means that it is not set
        if name == "interval" or label in self.unsigned:
            sign = "real"
        return sympy.Symbol(label, **{sign: True})


class NamesWithNumbers(Names):
    """The same, with parameters as their numbers, except for some."""

    symbols: Set[str] = frozenset()  # parameters that are symbols

    def parameter(
        self, node: Node, name: str, value: np.ndarray, index: tuple
    ) -> sympy.Expr:
        """Return the number of a parameter's element, except for the interval."""
        symbol = super().parameter(node, name, value, index)
        is_symbol = name == "interval" or f"{symbol}" in self.symbols
        return symbol if is_symbol else rational(float(value[index]))
