"""The closed loop on symbols for every number N of basis functions.

Blocks are read in the order of the wiring, each for any N (`every_n_function`), on what feeds
it.  A signal of a row of N is an expression of k, any other base + sum_k term(k).
"""

from dataclasses import dataclass, field
from typing import Any

import control
import numpy as np
import sympy

from ...diagrams.wiring import Node, Wire, wiring_of
from ...equations.block import Block
from ...equations.declaration import states_as_outputs
from ...equations.namespaces import split
from ...equations.symbolic import exact
from ...errors import BlockError
from .every_n_function import read_function
from .every_n_signals import Key, Size, Summed, keys, port_size
from .paper_symbols import ONE, SCALARS, parameter_names, signed, state_names
from .symbolic_loop import TIME, blocks_of, refuse_jumps


@dataclass
class EveryNLoop:
    """A diagram's equations for every N.

    Signals and rates are found by (port, row, None) -> element k of a row of N, an expression
    of k, and by (port, None, j) -> `Summed`.  States stand under their names.
    """

    signals: dict[Key, Any] = field(default_factory=dict)
    rates: dict[Key, Any] = field(default_factory=dict)
    states: dict[str, Size] = field(default_factory=dict)
    given: set = field(default_factory=set)  # symbols of the inputs and of opaque blocks
    names: dict[tuple[str, str], str] = field(default_factory=dict)  # (block, parameter) -> name
    values: dict[str, Any] = field(default_factory=dict)  # name -> value, whose sign is kept
    undefined: list[str] = field(default_factory=list)  # where there may be no value, sentences

    def parameter(self, name: str, *places: int | None) -> sympy.Expr:
        """Return a parameter's symbol; a place None is the index k."""
        value = self.values[name]
        if not places or name in SCALARS:
            return signed(name, value)
        shown = [f"[{'k' if place is None else place + 1}]" for place in places]
        if split(name)[1] in ONE and np.shape(value)[0] == 2 and places[0] is not None:
            shown[0] = f"_{places[0] + 1}"
        return signed(name + "".join(shown), value)

    def derivative(self, value: Summed) -> Summed:
        """Differentiate base + sum_k term(k) along the equations, multiplied out."""
        own = value.base.free_symbols | value.term.free_symbols
        if own & (self.given | {TIME}) or value.base.atoms(sympy.core.function.AppliedUndef):
            raise BlockError("V depends on time or an input, which is not read for every N")
        rate = Summed(sympy.Integer(0))
        for port, size in self.states.items():
            for j in range(size.more):
                symbol = element_symbol(port, None, j)
                slope = Summed(sympy.diff(value.base, symbol), sympy.diff(value.term, symbol))
                rate = rate.plus(slope.expanded().times(self.rates[port, None, j]))
            for row in range(size.rows):
                symbol = element_symbol(port, row)
                if value.base.has(symbol):
                    raise BlockError(f"{symbol} stands outside every sum")
                slope = sympy.diff(value.term, symbol)
                rate = rate.plus(Summed(sympy.Integer(0), slope * self.rates[port, row, None]))
        return rate.expanded()


def element_symbol(name: str, row: int | None, number: int | None = None) -> sympy.Symbol:
    """Return the symbol of one signal: alpha_1[k], phi_x[k], K_2."""
    if row is None:
        return sympy.Symbol(f"{name}_{(number or 0) + 1}", real=True)
    own = split(name)[1].startswith("phi")
    return sympy.Symbol(f"{name}[k]" if own else f"{name}_{row + 1}[k]", real=True)


def every_n_loop(diagram: control.NonlinearIOSystem) -> EveryNLoop:
    """Read a diagram's equations for every N.

    It is wired for some N; the ports phi_x, phi_z, alpha and eta grow with N.
    """
    wiring = wiring_of(diagram)
    blocks = blocks_of(wiring)
    refuse_jumps(blocks)
    N = _number_of_functions(blocks)
    states = state_names(blocks)
    loop = EveryNLoop(names=parameter_names(blocks))
    for block in blocks:
        for name, value in zip(block.parameters._fields, block.parameters, strict=True):
            loop.values[loop.names[block.name, name]] = value
    place = _places(wiring.nodes, blocks, N)
    outside = _ports(_counted(diagram.input_labels), N)
    for key in keys(outside).values():
        _add_given(loop, key)

    def feed(k: int, key: Key) -> Any:
        return _fed(wiring.nodes[k], blocks[k], key, N, place, outside, loop)

    def outcome(k: int, role: str) -> dict[Key, Any]:
        block = blocks[k]
        out = block.output_ports if role == "output" else block.state_ports
        sizes = {
            "x": _ports(block.state_ports, N),
            "u": _ports(block.input_ports, N),
            "out": _ports(out, N),
        }

        def leaf(name: str, *where: Any) -> Any:
            if name == "t":
                return TIME
            if name == "u":
                return feed(k, where[0])
            if name == "x":
                port, *rest = where[0]
                return _state(states[block.name, port], *rest)
            return loop.parameter(loop.names[block.name, where[0]], *(where[1:] and where[1]))

        def warn(sentence: str) -> None:
            loop.undefined.append(f"{block.name}.{role} {sentence}")

        return read_function(block, role, sizes, leaf, warn)

    for k in wiring.order:
        if blocks[k].opaque:
            for key in keys(_ports(blocks[k].output_ports, N)).values():
                _add_given(loop, key)
        elif blocks[k].output_function is states_as_outputs:
            own = _ports(blocks[k].state_ports, N)
            loop.signals.update({key: _state(*key) for key in keys(own).values()})
        else:
            loop.signals.update(outcome(k, "output"))
    for k, block in enumerate(blocks):
        if block.update_function is None:
            continue
        for (port, *rest), value in outcome(k, "update").items():
            loop.rates[(states[block.name, port], *rest)] = value  # type: ignore[index]
        for port, size in _ports(block.state_ports, N).items():
            loop.states[states[block.name, port]] = size
    return loop


def _state(name: str, row: int | None, number: int | None) -> Any:
    symbol = element_symbol(name, row, number)
    return symbol if row is not None else Summed(symbol)


def _add_given(loop: EveryNLoop, key: Key) -> None:
    loop.given.add(element_symbol(*key))
    loop.signals[key] = _state(*key)


def _number_of_functions(blocks: list[Block]) -> int:
    found = {N for b in blocks if isinstance(N := getattr(b.parameters, "N", None), int)}
    if len(found) != 1:
        raise BlockError(f"blocks have different numbers of functions: {sorted(found)}")
    return found.pop()


def _counted(labels: list[str]) -> dict[str, int]:
    ports: dict[str, int] = {}
    for label in labels:
        port = label.split("[")[0]
        ports[port] = ports.get(port, 0) + 1
    return ports


def _ports(ports: dict[str, int], N: int) -> dict[str, Size]:
    return {port: port_size(port, size, N) for port, size in ports.items()}


def _keys_by_place(ports: dict[str, int], N: int) -> list[tuple[Key, int]]:
    """Return, for every signal of ports as they are for this N, its key and function."""
    return [
        (key, j)
        for port, size in ports.items()
        for key in keys({port: port_size(port, size, N)}).values()
        for j in range(N if key[1] is not None else 1)
    ]


def _places(nodes: tuple[Node, ...], blocks: list[Block], N: int) -> dict[int, tuple[Key, int]]:
    place = {}
    for node, block in zip(nodes, blocks, strict=True):
        for j, key in enumerate(_keys_by_place(block.output_ports, N)):
            place[node.outputs.start + j] = key
    return place


def _fed(
    node: Node, block: Block, key: Key, N: int, place: dict, outside: dict, loop: EveryNLoop
) -> Any:
    """Return what feeds a row or a single input, a sum of gains times signals."""
    external = [
        pair
        for port, size in outside.items()
        for pair in _keys_by_place({port: size.rows * N + size.more}, N)
    ]
    own = _keys_by_place(block.input_ports, N)
    turns: list[list[tuple[Key, float]]] = []
    for at in (k for k, (one, _) in enumerate(own) if one == key):
        feeds = []
        for wire in node.wires:
            if wire.to <= at < wire.to + wire.size:
                source, j = _source(wire, at, external, place)
                if key[1] is not None and (source[1] is None or j != own[at][1]):
                    raise BlockError(f"{node.name}.{key[0]} is not fed function by function")
                if key[1] is None and source[1] is not None:
                    raise BlockError(f"{node.name}.{key[0]} is fed by one function of N")
                feeds.append((source, wire.gain))
        turns.append(sorted(feeds, key=str))
    if any(feeds != turns[0] for feeds in turns):
        raise BlockError(f"{node.name}.{key[0]} is not fed alike for every function")
    if key[1] is not None:
        return sum((exact(g) * loop.signals[s] for s, g in turns[0]), sympy.Integer(0))
    total = Summed(sympy.Integer(0))
    for source, gain in turns[0]:
        total = total.plus(loop.signals[source].times(Summed(exact(gain))))
    return total


def _source(wire: Wire, at: int, external: list, place: dict) -> tuple[Key, int]:
    number = wire.source + at - wire.to
    return external[number] if wire.external else place[number]
