"""The closed loop on symbols for a generic number of basis functions.

Blocks are read one by one with N a symbol (`generic`), then put together
through the diagram's own connections, port by port.
"""

from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import Any

import control
import sympy

from ..blocks import Block
from ..blocks.ports import states_as_outputs
from ..errors import DiagramError
from ..wiring import Node, read
from .generic import (
    KNOWN_SIZES,
    K,
    N,
    ParameterArray,
    Size,
    Summed,
    element_symbol,
    generic_size,
    read_function,
)
from .symbols import POSITIVE, SPELLING


@dataclass
class GenericLoop:
    """A diagram's equations for every N.

    Attributes
    ----------
    signals, rates : dict
        (port, row, None) -> element k of a row of N, an expression in k;
        (port, None, j) -> `Summed`.
    states : dict
        Port -> Size, for the states.
    """

    signals: dict = field(default_factory=dict)
    rates: dict = field(default_factory=dict)
    states: dict[str, Size] = field(default_factory=dict)

    def derivative(self, value: Summed) -> Summed:
        """Differentiate base + sum_k term(k) along the equations.

        Parameters
        ----------
        value : Summed
            In terms of the states.

        Returns
        -------
        Summed
            Its rate, multiplied out.
        """
        rate = Summed(sympy.Integer(0))
        for port, size in self.states.items():
            for j in range(size.more):
                symbol = element_symbol(port, None, j)
                slope = Summed(sympy.diff(value.base, symbol), sympy.diff(value.term, symbol))
                rate = rate + slope.expanded().times(self.rates[(port, None, j)])
            for row in range(size.rows):
                symbol = element_symbol(port, row, K)
                slope = sympy.diff(value.term, symbol)
                if value.base.has(symbol.base):
                    raise DiagramError(f"a single {symbol.base} stands outside every sum")
                rate = rate + Summed(sympy.Integer(0), slope * self.rates[(port, row, None)])
        return rate.expanded()


def generic_parameters(block: Block) -> Any:
    """Give a block's parameters on symbols, N among them.

    Examples
    --------
    >>> from clpt_control.blocks.adaptation import LearnedFlowParameters, adaptation
    >>> generic_parameters(adaptation(LearnedFlowParameters(3, 0.8)))
    LearnedFlowParameters(N=N, gain=gamma)
    """
    values: list[Any] = []
    for name, value in zip(block.parameters._fields, block.parameters, strict=True):
        if name == "N":
            values.append(N)
        elif isinstance(value, int):
            values.append(value)
        elif isinstance(value, float):
            sort = {"positive": True} if name in POSITIVE else {"real": True}
            values.append(sympy.Symbol(SPELLING.get(name, name), **sort))
        else:
            values.append(ParameterArray(name, name in POSITIVE))
    return type(block.parameters)(*values)


def generic_trace(diagram: control.NonlinearIOSystem, opaque: Iterable[str] = ()) -> GenericLoop:
    """Read a diagram's equations with N a symbol.

    Parameters
    ----------
    diagram : control.NonlinearIOSystem
        Blocks wired for some N; ports of N and 2N signals are told by name
        (`phi_x`, `phi_z`, `alpha`, `eta`), others by size where N > 4.
    opaque : iterable of str, optional
        Blocks to leave undefined: their outputs stay symbols at each instant.

    Returns
    -------
    GenericLoop
        Signals and rates for every N.

    Raises
    ------
    DiagramError
        If the diagram holds a system that is not a block, or a gain other
        than 1 feeds a port of N signals.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> loop = generic_trace(clpt.closed_loop(clpt.paper_scenario()), ("basis_x", "basis_z"))
    >>> loop.signals[("e", None, 0)].base
    x_1 - z_1
    """
    wiring, kept = read(diagram), set(opaque)
    loop = GenericLoop()
    order = [wiring.nodes[k] for k in wiring.order]
    for node in order:
        if not isinstance(node.system, Block):
            raise DiagramError(f"{node.name} is no block, so its equations cannot be read")
    functions = _number_of_functions(order)
    outside = list(dict.fromkeys(label.split("[")[0] for label in diagram.input_labels))
    for port in outside:
        count = sum(label.split("[")[0] == port for label in diagram.input_labels)
        size = generic_size(port, count, functions)
        for row in range(size.rows):
            loop.signals[(port, row, None)] = element_symbol(port, row, K)
        for j in range(size.more):
            loop.signals[(port, None, j)] = Summed(element_symbol(port, None, j))
    sources = _sources(wiring.nodes, diagram.input_labels)
    found: dict[str, dict] = {}
    for node in order:
        block = node.system
        outputs = _sizes(block.output_ports, functions)
        loop.states.update(_sizes(block.state_ports, functions))
        if block.opaque or block.name in kept or block.output_function is states_as_outputs:
            for port, size in outputs.items():
                for row in range(size.rows):
                    loop.signals[(port, row, None)] = element_symbol(port, row, K)
                for j in range(size.more):
                    loop.signals[(port, None, j)] = Summed(element_symbol(port, None, j))
            continue
        found[block.name] = read_function(
            block.output_function,
            block,
            generic_parameters(block),
            _both(block, functions),
            outputs,
        )
        loop.signals.update(_composed(found[block.name], block, sources, loop, functions))
    for node in order:
        block = node.system
        if block.update_function is not None:
            states = _sizes(block.state_ports, functions)
            rates = read_function(
                block.update_function, block, generic_parameters(block),
                _both(block, functions), states,
            )  # fmt: skip
            loop.rates.update(_composed(rates, block, sources, loop, functions))
    return loop


def _number_of_functions(order: list[Node]) -> int:
    found = {n.system.parameters.N for n in order if "N" in n.system.parameters._fields}
    if len(found) != 1:
        raise DiagramError(f"blocks have different numbers of functions: {sorted(found)}")
    return found.pop()


def _sizes(ports: dict[str, int], functions: int) -> dict[str, Size]:
    return {port: generic_size(port, size, functions) for port, size in ports.items()}


def _both(block: Block, functions: int) -> dict[str, dict[str, Size]]:
    return {
        "states": _sizes(block.state_ports, functions),
        "inputs": _sizes(block.input_ports, functions),
    }


def _sources(
    nodes: Iterable[Node], inputs: list[str]
) -> dict[tuple[str, str], tuple[str, sympy.Expr]]:
    """Tell, through the wires, which port feeds each input port, and its gain."""
    place = {}
    for node in nodes:
        at = node.outputs.start
        for port, size in node.system.output_ports.items():
            place.update({at + k: (port, k) for k in range(size)})
            at += size
    found: dict = {}
    for node in nodes:
        feeds = {}
        for wire in node.wires:
            for k in range(wire.size):
                if wire.to + k in feeds:
                    raise DiagramError(f"{node.name}: a generic N needs one source per input")
                if wire.external:
                    port, number = inputs[wire.source + k].rstrip("]").split("[")
                    feeds[wire.to + k] = (port, int(number), wire.gain)
                else:
                    feeds[wire.to + k] = (*place[wire.source + k], wire.gain)
        at = 0
        for port, size in node.system.input_ports.items():
            nothing = ("", -1, 0.0)
            run = [feeds.get(at + k, nothing) for k in range(size)]
            at += size
            source, _, gain = run[0]
            if not source or run != [(source, k, gain) for k in range(size)]:
                raise DiagramError(
                    f"{node.name}.{port}: must be fed by one port, whole and in order"
                )
            found[(node.system.name, port)] = (source, sympy.nsimplify(gain))
    return found


def _composed(values: dict, block: Block, sources: dict, loop: GenericLoop, functions: int) -> dict:
    """Put what feeds a block in place of its input symbols."""
    plain: dict[sympy.Expr, Summed] = {}
    rows: dict[sympy.Expr, sympy.Expr] = {}
    for port, size in _sizes(block.input_ports, functions).items():
        source, gain = sources[(block.name, port)]
        for row in range(size.rows):
            rows[element_symbol(port, row, K)] = gain * loop.signals[(source, row, None)]
        for j in range(size.more):
            fed = loop.signals[(source, None, j)]
            symbol = element_symbol(port, None, j)
            if gain != 1 or fed != Summed(symbol):
                plain[symbol] = Summed(gain * fed.base, gain * fed.term)
    own = {a: b for a, b in rows.items() if a != b}
    composed = {}
    for key, value in values.items():
        if isinstance(value, Summed):
            composed[key] = _substituted(value, own, plain).expanded()
        else:
            whole = _substituted(Summed(value), own, plain)
            if whole.term != 0:
                raise DiagramError(f"{key[0]}[k]: a sum inside an element cannot be read")
            composed[key] = whole.base
    return composed


def _substituted(value: Summed, rows: dict, plain: dict[sympy.Expr, Summed]) -> Summed:
    base, term = (part.subs(rows, simultaneous=True) for part in value)
    simple = {symbol: fed.base for symbol, fed in plain.items() if fed.term == 0}
    sums = {symbol: fed for symbol, fed in plain.items() if fed.term != 0}
    marks = {symbol: sympy.Dummy(str(symbol), real=True) for symbol in sums}
    base, term = (part.subs({**simple, **marks}, simultaneous=True) for part in (base, term))
    result = Summed(base.subs(dict.fromkeys(marks.values(), 0)), term)
    for symbol, mark in marks.items():
        slope = sympy.diff(base, mark)
        if slope.has(*marks.values()) or term.has(mark):
            raise DiagramError(f"{symbol} holds a sum over N and is used in a way not linear")
        result = result + Summed(slope).times(sums[symbol])
    return result


__all__ = ["KNOWN_SIZES", "GenericLoop", "generic_parameters", "generic_trace"]
