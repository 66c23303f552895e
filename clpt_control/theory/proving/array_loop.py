"""The closed loop as arrays: what the theorems are written on.

The blocks' records, joined at the diagram's own wires.  A claim about it is made of its signals,
states, parameters and rates as NumPy's arrays are: ``-np.sum(KD * e**2)``; `elements` reads what
comes of it, for every N where sizes are open, or for the diagram's own.  Sources of time and tables
are inputs of the diagram: what is proved then holds for all of them.
"""

from collections.abc import Callable, Iterable
from functools import cached_property
from typing import Any

import control
import numpy as np
import sympy

from ...diagrams.merged_record import merged_record
from ...diagrams.symbol_names import TIME
from ...diagrams.wiring import Node, Wiring, wiring_of
from ...equations.arrays import Tape, operand
from ...equations.block import Block
from ...equations.declaration import Parameters
from ...equations.derivative import Direction
from ...equations.elements import Index
from ...equations.record import Shape
from ...equations.symbolic import LONG, EveryN, extent
from ...errors import DiagramError
from .symbols import element_name, parameter_names, parameter_symbol, state_names, undefined

DEEPEST = 30  # levels of an expression
Known = Callable[[sympy.Expr, Index], Any]


class ArrayLoop:
    """A diagram's equations as arrays, by port.

    A state that is no port of the diagram stands under ``"block:port"``.  Sizes that have names
    stay open unless `closed`.  States that jump are refused unless `jumps`: the caller then checks
    what V does there.  `known` gives what stands for a parameter's element.
    """

    def __init__(
        self,
        diagram: control.NonlinearIOSystem,
        jumps: bool = False,
        closed: bool = False,
        known: Known = lambda symbol, index: symbol,
    ):
        wiring = wiring_of(diagram)
        refuse_unproved(wiring, jumps)
        blocks = [node.system for node in wiring.nodes]
        self.tape, self.known = Tape(), known
        self.fields, self.names = parameter_names(blocks), state_names(blocks)
        self.values: dict[str, Any] = {}  # of parameters
        self.declared: dict[str, Shape] = {}
        self.states: dict[str, Any] = {}
        found = merged_record(
            diagram, wiring, self._leaf, self._input, tape=self.tape, closed=closed
        )
        refuse_pinned(found.pinned)
        self.inputs = found.inputs
        self.signals = {port: value for (_, port), value in found.signals.items()}
        of = {node.name: node.system.name for node in wiring.nodes}
        self.rates = {
            self.names[of[node], port]: value for (node, port), value in found.rates.items()
        }
        self.jumps: dict[str, dict[str, Any]] = {}  # block -> state: its new value
        for (node, port), value in found.jumps.items():
            self.jumps.setdefault(of[node], {})[self.names[of[node], port]] = value
        self.parameters: dict[str, Parameters] = {}  # block -> arrays
        for one in wiring.nodes:
            block = one.system
            fields = {
                field: value
                if isinstance(value, int)
                else self._parameter(block, field, found.fields[one.name][field])
                for field, value in block.parameters._asdict().items()
            }
            self.parameters[block.name] = Parameters(**fields)
        self.undefined_so_far: list[str] = []  # in what was read

        def watch(place: int, name: str, arguments: tuple) -> None:
            owner = found.owners.get(place)
            if owner and (sentence := no_value(owner, name, arguments)):
                self.undefined_so_far.append(f"{owner} {sentence}")

        self.elements = EveryN(self.tape.operations, self._element, watch)

    @property
    def undefined(self) -> list[str]:
        """Where there may be no value, in sentences; reads everything."""
        for ports in (self.signals, self.rates, *self.jumps.values()):
            for value in ports.values():
                self.elements.of(value)
        return self.undefined_so_far

    def derivative(self, value: Any) -> Any:
        """Return the time derivative along the equations, as an array.

        That of an input is an input of its own.
        """
        return self._direction.of(value)

    def read(self, value: Any) -> list[Any]:
        """Return a value's elements on symbols, row by row."""
        return list(np.ravel(self.elements.of(value)))

    def direction(self, state: str) -> Any:
        """Return a direction of a state, any one, as an array of its shape."""
        return self.tape.add("leaf", (), self.states[state].shape, ("d", state))

    @cached_property
    def _direction(self) -> Direction:
        along: dict[Any, Any] = {operand(s): self.rates[name] for name, s in self.states.items()}
        for k, operation in enumerate(self.tape.operations):
            if operation.kind == "leaf" and operation.at[0] == "u":
                along[k] = self.tape.add("leaf", (), operation.shape, ("u'", operation.at[1]))
            elif operation.kind == "leaf" and operation.at[0] == "t":
                along[k] = 1.0
        return Direction(self.tape, along, smooth=True)

    # --- the leaves, by the paper's names ----------------------------------------------------

    def _parameter(self, block: Block, parameter: str, shape: Shape) -> Any:
        name = self.fields[block.name, parameter]
        self.values[name] = getattr(block.parameters, parameter)
        return self.tape.add("leaf", (), shape, ("p", name))

    def _leaf(self, group: str, node: Node, name: str, shape: Shape) -> Any:
        """Return a state or a parameter of a block."""
        block = node.system
        if group == "p":
            return self._parameter(block, name, shape)
        state = self.names[block.name, name]
        self.declared[state] = block.declared["states"][name]
        return self.states.setdefault(state, self.tape.add("leaf", (), shape, ("x", state)))

    def _input(self, port: str, shape: Shape, declared: Shape) -> Any:
        self.declared[port] = declared
        return self.tape.add("leaf", (), shape, ("u", port))

    def _element(self, at: tuple, shape: Shape, index: Index) -> Any:
        """Return the symbol of an element, or what is known of it."""
        group, name = at
        if group == "t":
            return TIME
        if group == "p":
            return self.known(parameter_symbol(name, self.values[name], index), index)
        port = ("d " if group == "d" else "") + name + ("'" if group.endswith("'") else "")
        return sympy.Symbol(element_name(port, self.declared[name], index), real=True)


def no_value(owner: str, name: str, arguments: tuple) -> str | None:
    """Return where an operation may have no value; refuse what is too long to be judged."""
    sizes = [extent(a) for a in arguments if isinstance(a, sympy.Basic)]
    if any(parts > LONG or levels > DEEPEST for parts, levels in sizes):
        raise DiagramError(
            f"{owner} has more than {LONG} parts or {DEEPEST} levels on "
            "symbols, too long to prove anything of; make it simpler or its N smaller"
        )
    return undefined(name, arguments)


def refuse_pinned(pinned: Iterable[tuple[str, str]]) -> None:
    """Refuse parameters on whose values the equations depend, as by an `if`."""
    for name, own in sorted(pinned):
        raise DiagramError(
            f"{name}: asks for the value of its parameter {own}, as an `if` does, so nothing would "
            f"be proved of other values; write np.where, or give {own} as a whole number"
        )


def refuse_unproved(wiring: Wiring, jumps: bool) -> None:
    """Refuse discrete time, blocks that sample, and jumps unless `jumps`: no proof is of them."""
    blocks = [node.system for node in wiring.nodes]
    name = next((block.name for block in blocks if block.first_held is not None or wiring.dt), None)
    if name is not None:
        raise DiagramError(
            f"{name}: is of discrete time, and proofs speak of continuous time alone; prove the "
            "design that it was sampled from"
        )
    for block in blocks if not jumps else ():
        if block.jump_function is not None:
            raise DiagramError(
                f"{block.name}: its states jump, and this proof speaks of no jumps; prove the "
                "block without its `jump`"
            )
