"""Closed loops on the paper's symbols: with a number of basis functions, or as arrays for every N.

`SymbolicLoop` has an expression for each element of an array.  `ArrayLoop` has the records of the
blocks, connected as in the diagram; theorems are stated on it, in its signals, states, parameters
and rates, as on NumPy arrays: ``-np.sum(KD * e**2)``.  `elements` then returns expressions for
every N where sizes are open.  Sources of time and tables are inputs of the diagram: a proof holds
for all of them.
"""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any, NamedTuple

import control
import numpy as np
import sympy
from sympy import Expr, S, sympify

from ...base.errors import DiagramError
from ...engine.diagram.merged_record import TapeRecord
from ...engine.diagram.symbol_names import TIME
from ...engine.diagram.symbolic_equations import Equations, on_symbols
from ...engine.diagram.wiring import Node, Wiring, wiring_of
from ...engine.model.declaration import Parameters
from ...engine.record.graph import Shape
from ...engine.record.scalar_graph import Index
from ...engine.record.symbolic import LONG, extent
from ...engine.trace.arrays import Tape
from ...engine.trace.derivative import Direction
from ..algebra.every_n import EveryN
from ..algebra.exact import nonzero_residual, vanishes
from ..algebra.facts import NUMPY_OF
from ..algebra.numeric_values import NO_VALUE
from ..algebra.slopes import along
from ..algebra.texts import short
from .paper_symbols import PaperNames, parameter_symbol, undefined


@dataclass
class SymbolicLoop(Equations):
    """A diagram's equations on the paper's symbols.

    A state that is no port of the diagram is named ``"block:port"``.
    """

    diagram: Any = None

    def derivative(self, expression: Any) -> Any:
        """Differentiate expressions along the equations, functions with kinks as well."""
        rates = {TIME: sympy.S.One, **self.motion}
        along_rates = np.vectorize(lambda e: along(sympify(e), rates), otypes=[object])
        return along_rates(expression)[()]

    def numbers_of(self, *blocks: str) -> dict[Any, Expr]:
        """Return the symbols of parameters that only these blocks have -> their numbers."""
        others = self.parameters.keys() - {*blocks}
        hidden = {s for name in others for s in flat(self.parameters[name])}
        return {s: number for s, number in self.values.items() if s not in hidden}


def symbolic_loop(
    diagram: control.NonlinearIOSystem, opaque: Iterable[str] = (), jumps: bool = False
) -> SymbolicLoop:
    """Return a diagram's equations on symbols; blocks named in `opaque` stay undefined.

    States that jump are rejected unless `jumps`: the caller then checks V at jumps.
    """
    refuse_unproved(wiring_of(diagram), jumps)
    loop = on_symbols(diagram, PaperNames, opaque, no_value)
    refuse_levels(loop)
    refuse_names(diagram.name, {*loop.states, *loop.inputs.keys() - {"V"}})
    refuse_pinned(loop.pinned)
    return SymbolicLoop(**vars(loop), diagram=diagram)


class Point(NamedTuple):
    """Arguments of the running blocks: ``diagram.dynamics(*point)``."""

    t: float
    x: np.ndarray  # states of the diagram
    u: np.ndarray  # its inputs


def flat(parameters: Any) -> list[Any]:
    """Return the symbols of a block's parameters, one after the other."""
    fields = (np.asarray(field, dtype=object) for field in parameters)
    return [symbol for field in fields for symbol in field.flat]


def equated(
    ports: Mapping[str, np.ndarray], values: Mapping[str, Any]
) -> dict[Any, Expr]:
    """Return symbols of ports -> their values, element by element."""
    return {
        symbol: sympify(value)
        for port in values
        for symbol, value in zip(ports[port].flat, np.ravel(values[port]), strict=True)
    }


def refuse_names(name: str, names: Iterable[str]) -> None:
    """Reject a state, a signal or a parameter with the name of time, V or a function."""
    for reserved in sorted({"t", "V", "Abs", *NUMPY_OF} & {*names}):
        raise DiagramError(
            f"{name}: has a {reserved}, as time, V or a function is called. Rename it"
        )


def refuse_no_value(loop: SymbolicLoop, name: str) -> None:
    """Reject equations without a value at any state."""
    ports = *loop.rates.values(), *loop.signals.values()
    if any(element.has(*NO_VALUE) for port in ports for element in port.flat):
        cause = f" ({loop.undefined[0]})" if loop.undefined else ""
        raise DiagramError(
            f"{name}: with the parameters as they are its equations have no value{cause}"
        )


# --- for every N -------------------------------------------------------------------------------


DEEPEST = 30  # levels of an expression
Substitution = Callable[[Expr, Index], Any]


class ArrayLoop:
    """A diagram's equations as arrays, by port.

    A state that is no port of the diagram is named ``"block:port"``.  Sizes that have names stay
    open.  `substitute` returns the value of a parameter's element: by default its symbol.  States
    that jump are rejected unless `jumps`: the values after a jump are those of `jumps`.
    """

    def __init__(
        self,
        diagram: control.NonlinearIOSystem,
        substitute: Substitution = lambda symbol, index: symbol,
        jumps: bool = False,
    ):
        wiring = wiring_of(diagram)
        refuse_unproved(wiring, jumps)
        self.diagram = diagram
        self.substitute = substitute
        self.tape = Tape()
        self.names = PaperNames(wiring, ())
        record = TapeRecord(diagram, wiring, self.tape, self._name_of)
        refuse_pinned(record.pinned)
        self.inputs = record.external
        self.signals = {port: value for (_, port), value in record.signals.items()}
        block_of = {node.name: node.system.name for node in wiring.nodes}
        self.rates, self.jumps = (
            {
                self.names.states[block_of[node], port]: value
                for (node, port), value in values.items()
            }
            for values in (record.rates, record.jumps)
        )
        self.parameters: dict[str, Parameters] = {}  # block -> arrays
        for k, node in enumerate(wiring.nodes):
            block = node.system
            fields = block.parameters._asdict()
            for field, value in fields.items():
                if not isinstance(value, int):
                    shape = block.parameter_shapes.get(field, np.shape(value))
                    fields[field] = self.tape.value(record.leaf(k, "p", field, shape))
            self.parameters[block.name] = Parameters(**fields)
        self.values: dict[str, Any] = {}  # of parameters
        self.declared = record.declared
        self.states: dict[str, Any] = {}
        for (group, name), (node, own_name, leaf) in record.leaves.items():
            if group == "p":
                self.values[name] = getattr(node.system.parameters, own_name)
            else:
                self.declared[name] = node.system.declared["states"][own_name]
                self.states[name] = leaf
        self.undefined_so_far: list[str] = []  # in the elements computed so far

        def watch(row: int, name: str, arguments: tuple) -> None:
            owner = record.owners.get(row)
            sentence = no_value(owner, name, arguments) if owner else None
            if sentence:
                self.undefined_so_far.append(f"{owner} {sentence}")

        self.elements = EveryN(self.tape.operations, self._element, watch)

    @property
    def undefined(self) -> list[str]:
        """Sentences on operations that may have no value; computes all elements."""
        for value in (*self.signals.values(), *self.rates.values()):
            self.elements.of(value)
        return self.undefined_so_far

    def derivative(self, value: Any) -> Any:
        """Return the time derivative along the equations, as an array.

        The derivative of an input is another input.
        """
        return self._direction.of(value)

    def read(self, value: Any) -> list[Any]:
        """Return a value's elements on symbols, row by row."""
        return list(np.ravel(self.elements.of(value)))

    def zero(self, *residuals: Any) -> tuple[bool, str]:
        """Return whether arrays are zero for every N, and the first element that is not."""
        for residual in residuals:
            for element in self.read(residual):
                if problem := nonzero_residual(element):
                    return False, problem
        return (False, self.undefined[0]) if self.undefined else (True, "")

    @cached_property
    def _direction(self) -> Direction:
        def rate_of(k: int) -> Any:
            _, _, shape, (group, *name) = self.tape.operations[k]
            if group == "t":
                return 1.0
            if group == "u":
                return self.tape.add("leaf", (), shape, ("u'", *name))
            return self.rates[name[0]] if group == "x" else None

        return Direction(self.tape, rate_of, smooth=True)

    # --- the leaves, by the paper's names ----------------------------------------------------

    def _name_of(self, group: str, node: Node, name: str) -> str:
        """Return the name of a state or a parameter of a block."""
        names = self.names.fields if group == "p" else self.names.states
        return names[node.system.name, name]

    def _element(self, leaf: tuple, shape: Shape, index: Index) -> Any:
        """Return the symbol of an element, or its value."""
        group, name = leaf
        if group == "t":
            return TIME
        if group == "p":
            symbol = parameter_symbol(name, self.values[name], index)
            return self.substitute(symbol, index)
        port = name + "'" * group.endswith("'")
        element = self.names.element(port, shape, self.declared[name], index)
        return sympy.Symbol(element, real=True)


def no_value(owner: str, name: str, arguments: tuple) -> str | None:
    """Return a sentence if an operation may have no value; reject long expressions."""
    sizes = [extent(a) for a in arguments if isinstance(a, sympy.Basic)]
    if any(count > LONG or depth > DEEPEST for count, depth in sizes):
        raise DiagramError(
            f"{owner} has more than {LONG} parts or {DEEPEST} levels on "
            "symbols, too long for a proof. Make it simpler or its N smaller"
        )
    return undefined(name, arguments)


def refuse_pinned(pinned: Iterable[tuple[str, str]]) -> None:
    """Reject parameters whose values select the equations, as an `if` does."""
    for name, parameter in sorted(pinned):
        raise DiagramError(
            f"{name}: asks for the value of its parameter {parameter}, as an `if` does, so a "
            f"proof would not cover other values. Write np.where, or give {parameter} as a whole "
            "number"
        )


def refuse_levels(loop: Equations) -> None:
    """Reject states that jump at a level."""
    for name in loop.levels:
        raise DiagramError(
            f"{name}: its states jump at a level, and proofs are for jumps in time. Prove the "
            "block without its `jump`"
        )


def refuse_no_rates(eq: Equations, motion: Mapping[Any, Expr]) -> None:
    """Reject equations without states, with states that jump at a level, or without a value."""
    refuse_levels(eq)
    if not motion:
        raise DiagramError(f"{eq.name}: has no states, so V' is not defined")
    outputs = eq.signals.keys() - {"V"}  # V may be an output
    refuse_names(eq.name, {*outputs, *eq.states, *eq.inputs, *eq.fields})
    for s, rate in motion.items():
        if rate.xreplace(eq.values).has(*NO_VALUE):
            raise DiagramError(
                f"{eq.name}: with the parameters as they are {s}' has no value"
            )


def moving_at(eq: Equations, rest: Mapping[Any, Expr]) -> str:
    """Return a state and its rate at states that are no rest with inputs of 0, or ""."""
    still = {s: S.Zero for port in eq.inputs.values() for s in port.flat}
    for s, rate in eq.motion.items():
        kept, mark = (rest[s], "+") if eq.discrete else (S.Zero, "'")
        value = rate.xreplace(eq.values).xreplace(rest).xreplace(still)
        if value.is_number and not vanishes(value - kept):
            number = f"= {short(value)}" if value.is_finite else "has no value"
            return f"{s}{mark} {number}"
    return ""


def place_of(eq: Equations, rest: Mapping[Any, Expr]) -> str:
    """Return the words for a point that is given as a rest."""
    moving = moving_at(eq, rest)
    return f"`at` (no rest: {moving})" if moving else "rest"


def refuse_unproved(wiring: Wiring, jumps: bool) -> None:
    """Reject discrete time, blocks that sample, and, unless `jumps`, states that jump."""
    for block in [node.system for node in wiring.nodes]:
        if block.first_held is not None or wiring.dt:
            raise DiagramError(
                f"{block.name}: is of discrete time, and proofs are for continuous time. "
                "Prove the design that it was sampled from"
            )
        if block.jump_function is not None and not jumps:
            raise DiagramError(
                f"{block.name}: its states jump, and proofs are for states without "
                "jumps. Prove the "
                "block without its `jump`"
            )
