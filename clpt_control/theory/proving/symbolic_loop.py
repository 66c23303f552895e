"""The closed loop on symbols, from the records of the blocks that run.

Every block's update and output are read on symbols, through the diagram's own
connections, block by block in the order of the wiring.  Sources of time and tables
stay undefined functions of time and their inputs, and so does any block named in
`opaque`: what is proved then holds for all of them.
"""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from itertools import combinations
from typing import Any

import control
import numpy as np
import sympy

from ...diagrams.wiring import Wiring, wiring_of
from ...equations.block import Block
from ...equations.scalars import Scalars
from ...equations.symbolic import exact, expressions
from ...errors import DiagramError
from .paper_symbols import parameter_names, parameter_symbols, port_symbols, state_names
from .undefined import extent, undefined

LONGEST, DEEPEST = 5_000, 30  # parts and levels of an expression
TIME = sympy.Symbol("t", real=True)


@dataclass
class SymbolicLoop:
    """A diagram's equations on symbols, ports as ndarrays.

    A state that is no port of the diagram stands under ``"block:port"``.
    """

    states: dict[str, np.ndarray] = field(default_factory=dict)  # symbols
    signals: dict[str, np.ndarray] = field(default_factory=dict)  # expressions
    rates: dict[str, np.ndarray] = field(default_factory=dict)  # time derivatives of the states
    jumps: dict[str, dict] = field(default_factory=dict)  # block -> state: what it jumps to
    inputs: dict[str, np.ndarray] = field(default_factory=dict)  # symbols, of the diagram
    parameters: dict[str, Any] = field(default_factory=dict)  # block -> NamedTuple of symbols
    N: int | None = None  # number of basis functions, where the blocks have one
    undefined: list[str] = field(default_factory=list)  # where there may be no value, sentences

    def derivative(self, expression: sympy.Expr) -> sympy.Expr:
        """Differentiate an expression of the states along the equations.

        Opaque functions and inputs are differentiated in time as well.
        """
        rate = sympy.diff(expression, TIME)
        for port, symbols in self.states.items():
            for symbol, value in zip(symbols, self.rates[port], strict=True):
                rate += sympy.diff(expression, symbol) * value
        return rate

    def jumps_at_once(self) -> Iterator[dict[Any, Any]]:
        """Return state -> what it jumps to, for every set of blocks that may jump at once."""
        for count in range(1, len(self.jumps) + 1):
            for together in combinations(self.jumps.values(), count):
                yield {s: new for one in together for s, new in one.items()}


def symbolic_loop(
    diagram: control.NonlinearIOSystem, opaque: Iterable[str] = (), jumps: bool = False
) -> SymbolicLoop:
    """Read a diagram's equations on symbols; blocks named in `opaque` stay undefined.

    States that jump are refused unless `jumps`: the caller then judges what V does there.
    """
    wiring, undefined_blocks = wiring_of(diagram), set(opaque)
    blocks = blocks_of(wiring)
    if not jumps:
        refuse_jumps(blocks)
    loop = SymbolicLoop(parameters=parameter_symbols(blocks))
    sizes = {N for b in blocks if isinstance(N := getattr(b.parameters, "N", None), int)}
    loop.N = sizes.pop() if len(sizes) == 1 else None
    states, fields = state_names(blocks), parameter_names(blocks)
    outside = _external(diagram, loop)
    bus = np.full(wiring.nodes[-1].outputs.stop, sympy.Integer(0), dtype=object)

    def inputs_of(k: int) -> np.ndarray:
        node = wiring.nodes[k]
        u = np.full(node.system.ninputs, sympy.Integer(0), dtype=object)
        for wire in node.wires:
            source = outside if wire.external else bus
            gained = exact(wire.gain) * source[wire.source : wire.source + wire.size]
            u[wire.to : wire.to + wire.size] += gained
        return u

    def outcome(record: Scalars, role: str, block: Block, u: np.ndarray) -> np.ndarray:
        x = _flat({port: loop.states[states[block.name, port]] for port in block.state_ports})
        p = loop.parameters[block.name]

        def leaf(name: str, *where: Any) -> Any:
            if name == "t":
                return TIME
            if name == "p":
                return np.ravel(np.asarray(getattr(p, where[0]), dtype=object))[where[1]]
            if name == "table":
                (own, *places) = where[0]
                return f"{fields[block.name, own]}_{'_'.join(map(str, places))}"
            return (x if name == "x" else u)[where[0]]

        def watch(name: str, arguments: tuple) -> None:
            sizes = [extent(a) for a in arguments if isinstance(a, sympy.Basic)]
            if any(parts > LONGEST or levels > DEEPEST for parts, levels in sizes):
                raise DiagramError(
                    f"{block.name}.{role} has more than {LONGEST} parts or {DEEPEST} levels on "
                    "symbols, too long to prove anything of; make it simpler or its N smaller"
                )
            sentence = undefined(name, arguments)
            if sentence is not None:
                loop.undefined.append(f"{block.name}.{role} {sentence}")

        found = expressions(record, leaf, watch=watch)
        return np.array([sympy.sympify(e) for e in found], dtype=object)

    for block in blocks:
        for port, size in block.state_ports.items():
            name = states[block.name, port]
            loop.states[name] = port_symbols(name, size, loop.N)
    for k in wiring.order:
        node, block = wiring.nodes[k], blocks[k]
        u = inputs_of(k)
        if block.opaque or block.name in undefined_blocks:
            y = _flat(
                {
                    port: port_symbols(port, size, loop.N, (TIME, *u))
                    for port, size in block.output_ports.items()
                }
            )
        else:
            y = outcome(block.output_record, "output", block, u)
        bus[node.outputs] = y
        at = 0
        for port, size in block.output_ports.items():
            loop.signals[port] = y[at : at + size]
            at += size
    for k in wiring.order:
        block = blocks[k]
        if block.update_record is None:
            continue
        dx, at = outcome(block.update_record, "update", block, inputs_of(k)), 0
        for port, size in block.state_ports.items():
            loop.rates[states[block.name, port]] = dx[at : at + size]
            at += size
        if block.jump_record is not None:
            own = _flat({port: loop.states[states[block.name, port]] for port in block.state_ports})
            new = outcome(block.jump_record, "jump", block, inputs_of(k))
            loop.jumps[block.name] = dict(zip(own, new, strict=True))
    return loop


def refuse_jumps(blocks: Iterable[Block]) -> None:
    """Refuse blocks whose states jump, where nobody judges what V does there."""
    for block in blocks:
        if block.jump_function is not None:
            raise DiagramError(
                f"{block.name}: its states jump, and this proof speaks of no jumps; prove the "
                "block without its `jump`"
            )


def blocks_of(wiring: Wiring) -> list[Block]:
    """Return the blocks of a wiring; refuse what has no equations."""
    blocks = []
    for node in wiring.nodes:
        if not isinstance(node.system, Block):
            raise DiagramError(
                f"{node.name} is no block, so its equations cannot be read; make it a Block"
            )
        blocks.append(node.system)
    names = [block.name for block in blocks] + [p for block in blocks for p in block.output_ports]
    twice = sorted({name for name in names if names.count(name) > 1 and name})
    if len({block.name for block in blocks}) < len(blocks) or any(
        sum(port in block.output_ports for block in blocks) > 1 for port in twice
    ):
        raise DiagramError(f"'{twice[0]}' is the name of two; rename one to tell them apart")
    return blocks


def _external(diagram: control.NonlinearIOSystem, loop: SymbolicLoop) -> np.ndarray:
    ports: dict[str, int] = {}
    for label in diagram.input_labels:
        port = label.split("[")[0]
        ports[port] = ports.get(port, 0) + 1
    loop.inputs = {p: port_symbols(p, n, loop.N, (TIME,)) for p, n in ports.items()}
    return _flat(loop.inputs)


def _flat(ports: dict[str, np.ndarray]) -> np.ndarray:
    return np.concatenate([np.zeros(0, dtype=object), *ports.values()])
