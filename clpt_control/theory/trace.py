"""The closed loop on symbols, from the functions that run.

Every block's own update and output are called on symbols, through the
diagram's own connections, block by block in the order of the wiring.  Sources
of time and tables stay undefined functions of time and their inputs, and so
does any block named in `opaque`: what is proved then holds for all of them.
"""

from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import Any

import control
import numpy as np
import sympy

from ..blocks import Block
from ..blocks.readers import traced
from ..errors import DiagramError
from ..wiring import read
from .symbols import parameter_symbols, port_symbols

TIME = sympy.Symbol("t", real=True)


@dataclass
class SymbolicLoop:
    """A diagram's equations on symbols.

    Attributes
    ----------
    states : dict
        Port -> ndarray of symbols, such as ``states["alpha"]``.
    signals : dict
        Port -> ndarray of expressions in states, inputs and opaque functions.
    rates : dict
        Port -> ndarray of expressions, the time derivatives of its states.
    inputs : dict
        Port -> ndarray of symbols, the diagram's inputs.
    parameters : dict
        Block name -> NamedTuple of symbols.
    N : int or None
        Number of basis functions, where the blocks have one.
    """

    states: dict[str, np.ndarray] = field(default_factory=dict)
    signals: dict[str, np.ndarray] = field(default_factory=dict)
    rates: dict[str, np.ndarray] = field(default_factory=dict)
    inputs: dict[str, np.ndarray] = field(default_factory=dict)
    parameters: dict[str, Any] = field(default_factory=dict)
    N: int | None = None

    def derivative(self, expression: sympy.Expr) -> sympy.Expr:
        """Differentiate an expression of the states along the equations.

        Opaque functions and inputs are differentiated in time as well.
        """
        rate = sympy.diff(expression, TIME)
        for port, symbols in self.states.items():
            for symbol, value in zip(symbols, self.rates[port], strict=True):
                rate += sympy.diff(expression, symbol) * value
        return rate


def trace(diagram: control.NonlinearIOSystem, opaque: Iterable[str] = ()) -> SymbolicLoop:
    """Read a diagram's equations on symbols.

    Parameters
    ----------
    diagram : control.NonlinearIOSystem
        Blocks, wired; each port name made by one block.
    opaque : iterable of str, optional
        Names of blocks to leave undefined beside those that say so
        themselves, such as ``("basis_x", "basis_z")`` to keep phi.

    Returns
    -------
    SymbolicLoop
        States, signals and rates.

    Raises
    ------
    DiagramError
        If the diagram holds a system that is not a block.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> loop = trace(clpt.closed_loop(clpt.paper_scenario()), opaque=("basis_x", "basis_z"))
    >>> loop.signals["e"]
    array([x_1 - z_1, x_2 - z_2], dtype=object)
    """
    wiring = read(diagram)
    kept = set(opaque)
    for node in wiring.nodes:
        if not isinstance(node.system, Block):
            raise DiagramError(
                f"{node.name} is no block, so its equations cannot be read; make it a Block"
            )
    blocks = [node.system for node in wiring.nodes]
    loop = SymbolicLoop(parameters=parameter_symbols(blocks))
    sizes = {b.parameters.N for b in blocks if "N" in b.parameters._fields}
    loop.N = sizes.pop() if len(sizes) == 1 else None
    outside = _external(diagram, loop)
    bus = np.full(wiring.nodes[-1].outputs.stop, sympy.Integer(0), dtype=object)
    gathered: dict[int, np.ndarray] = {}

    def inputs_of(k: int) -> np.ndarray:
        node = wiring.nodes[k]
        u = np.full(node.system.ninputs, sympy.Integer(0), dtype=object)
        for wire in node.wires:
            source = outside if wire.external else bus
            gain = sympy.nsimplify(wire.gain)
            u[wire.to : wire.to + wire.size] += gain * source[wire.source : wire.source + wire.size]
        return u

    for k in wiring.order:
        node, block = wiring.nodes[k], wiring.nodes[k].system
        own = {port: port_symbols(port, size, loop.N) for port, size in block.state_ports.items()}
        loop.states.update(own)
        x = _flat(own)
        u = inputs_of(k)
        p = loop.parameters[block.name]
        if block.opaque or block.name in kept:
            y = _flat({port: port_symbols(port, size, loop.N, (TIME, *u))
                       for port, size in block.output_ports.items()})  # fmt: skip
        else:
            y = traced(block.output_function, TIME, x, u, p, block.noutputs)
        bus[node.outputs] = [_exact(value) for value in y]
        gathered[k] = x
        at = node.outputs.start
        for port, size in block.output_ports.items():
            loop.signals[port] = bus[at : at + size]
            at += size
    for k in wiring.order:
        block = wiring.nodes[k].system
        if not block.state_ports:
            continue
        p = loop.parameters[block.name]
        dx = traced(block.update_function, TIME, gathered[k], inputs_of(k), p, block.nstates)
        at = 0
        for port, size in block.state_ports.items():
            loop.rates[port] = np.array([_exact(value) for value in dx[at : at + size]], object)
            at += size
    return loop


def _external(diagram: control.NonlinearIOSystem, loop: SymbolicLoop) -> np.ndarray:
    ports: dict[str, int] = {}
    for label in diagram.input_labels:
        port = label.split("[")[0]
        ports[port] = ports.get(port, 0) + 1
    loop.inputs = {p: port_symbols(p, n, loop.N, (TIME,)) for p, n in ports.items()}
    return _flat(loop.inputs)


def _flat(ports: dict[str, np.ndarray]) -> np.ndarray:
    return np.concatenate([np.zeros(0, dtype=object), *ports.values()])


def _exact(value: Any) -> sympy.Expr:
    """Turn floats such as 0.5 into rationals."""
    return sympy.nsimplify(sympy.sympify(value), rational=True)
