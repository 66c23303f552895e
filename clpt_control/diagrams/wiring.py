"""What is wired to what in an interconnected system, in an order to compute it.

python-control keeps a diagram as matrices: `connect_map` (block outputs to
block inputs), `input_map` and `output_map`.  Here they become a list of blocks
in the order in which one pass computes every signal once: a block's turn comes
when all signals that reach its outputs at once are known.  The engine, the
proofs and the drawing all take a diagram from here.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

import control
import numpy as np

from ..equations.block import Block
from ..equations.linear import linear
from ..equations.system import System
from ..errors import DiagramError
from .parts import check_continuous

Rows = dict[int, list[tuple[int, float]]]  # block input -> (signal, gain) of all that feed it


class Wire(NamedTuple):
    """Consecutive signals, ``u += gain * source``."""

    to: int  # first input of the block that is fed
    source: int  # first signal among all block outputs, or among the diagram's inputs
    size: int  # number of consecutive signals
    gain: float  # factor on each
    external: bool  # true where the source is an input of the diagram


@dataclass(frozen=True)
class Node:
    """One block in its place."""

    system: control.NonlinearIOSystem  # the block
    name: str  # its name; inside a nested diagram ``"outer.inner"``
    states: slice  # where its states stand among all states
    inputs: slice  # among all block inputs
    outputs: slice  # among all block outputs
    wires: tuple[Wire, ...]  # what feeds it


@dataclass(frozen=True)
class Wiring:
    """A diagram as an ordered list of blocks."""

    nodes: tuple[Node, ...]  # blocks in the diagram's own order
    order: tuple[int, ...]  # indices into `nodes`, in which outputs can be computed one by one
    ninputs: int  # inputs of the diagram
    output_map: Any  # diagram outputs from all block outputs and then all diagram inputs


class _Flat(NamedTuple):
    """A system as leaves with U = C Y + D u and y = E Y + F u, sparse."""

    leaves: list[tuple[str, control.NonlinearIOSystem]]
    C: Any
    D: Any
    E: Any
    F: Any


def _flatten(system: control.NonlinearIOSystem, name: str) -> _Flat:
    from scipy.sparse import block_diag, csr_array, eye_array

    if not isinstance(system, control.NonlinearIOSystem):
        raise DiagramError(
            f"{name} is a {type(system).__name__}: must be blocks, wired, or a system with states, "
            "such as control.ss(...)"
        )
    check_continuous(system, name)
    if not isinstance(system, control.InterconnectedSystem):
        m, n = system.ninputs or 0, system.noutputs or 0
        C, D = csr_array((m, n)), eye_array(m, format="csr")
        return _Flat([(name, system)], C, D, eye_array(n, format="csr"), csr_array((n, m)))
    connections, inputs = csr_array(system.connect_map), csr_array(system.input_map)
    split = connections.shape[1]
    from_outputs = csr_array(system.output_map[:, :split])
    from_inputs = csr_array(system.output_map[:, split:])
    if not any(isinstance(part, control.InterconnectedSystem) for part in system.syslist):
        for part in system.syslist:
            check_continuous(part, part.name)
        leaves = [(part.name, part) for part in system.syslist]
        E, F = from_outputs + from_inputs @ connections, from_inputs @ inputs
        return _Flat(leaves, connections, inputs, E, F)
    parts = []
    for part in system.syslist:
        inner = _flatten(part, part.name)
        if isinstance(part, control.InterconnectedSystem):
            inner = inner._replace(leaves=[(f"{part.name}.{n}", s) for n, s in inner.leaves])
        parts.append(inner)
    leaves = [leaf for part in parts for leaf in part.leaves]
    C, D, E, F = (block_diag([part[k] for part in parts], format="csr") for k in range(1, 5))
    U_from_Y, U_from_u = connections @ E, inputs
    through = connections @ F
    for _ in range(len(parts)):  # signals that pass straight through nested diagrams
        if not through.nnz:
            break
        U_from_Y, U_from_u = U_from_Y + through @ U_from_Y, U_from_u + through @ U_from_u
        through = through @ through
    if through.nnz:
        raise DiagramError(f"{name}: nested diagrams feed each other without a block")
    return _Flat(
        leaves,
        C + D @ U_from_Y,
        D @ U_from_u,
        from_outputs @ (E + F @ U_from_Y) + from_inputs @ U_from_Y,
        (from_outputs @ F + from_inputs) @ U_from_u,
    )


def _entries(matrix: Any) -> Rows:
    """Return the rows of a connection matrix."""
    found = matrix.tocoo()
    rows: Rows = {}
    columns = [column.tolist() for column in (*found.coords, found.data)]
    for to, source, gain in zip(*columns, strict=True):
        if gain != 0.0:
            rows.setdefault(to, []).append((source, gain))
    return rows


def _wires(rows: Rows, first: int, last: int, external: bool) -> list[Wire]:
    """Join the signals that feed inputs first to last - 1 where they are consecutive."""
    following: dict[tuple, int] = {}  # what would continue a wire -> its place
    wires: list[Wire] = []
    for to in range(first, last):
        for source, gain in sorted(rows.get(to, ())):
            k = following.pop((to, source, gain), len(wires))
            if k == len(wires):
                wires.append(Wire(to - first, source, 0, gain, external))
            wires[k] = wires[k]._replace(size=wires[k].size + 1)
            following[to + 1, source + 1, gain] = k
    return wires


def reaches_outputs(system: control.NonlinearIOSystem) -> bool:
    """Return whether inputs reach outputs at once; a system that is no Block is tried."""
    if isinstance(system, Block):
        return system.feedthrough and system.ninputs > 0
    if not system.ninputs or not system.noutputs:
        return False
    random = np.random.default_rng(0)
    for _ in range(3):
        x = random.standard_normal(system.nstates or 0)
        u = random.standard_normal((2, system.ninputs))
        if not np.array_equal(system._out(0, x, u[0]), system._out(0, x, u[1])):
            return True
    return False


def wiring_of(
    diagram: control.NonlinearIOSystem,
    params: Mapping[str, Any] | None = None,
    sizes: tuple[int | None, int | None] = (None, None),
) -> Wiring:
    """Return the wiring of a diagram, nested ones included; python-control's systems become blocks.

    They are given `params` as python-control hands them down, and `sizes`, of states and inputs,
    where they leave them open.  Blocks that feed each other at once in a circle and systems of
    discrete time are refused.
    """
    from scipy.sparse import hstack

    flat = _flatten(diagram, getattr(diagram, "name", repr(diagram)))
    if not flat.leaves:
        raise DiagramError(f"{diagram.name}: has no blocks; give at least one")
    handed = _handed_down(diagram, params or {})
    systems = [
        (name, _as_block(system, own, sizes))
        for (name, system), own in zip(flat.leaves, handed, strict=True)
    ]
    if None in (diagram.nstates, diagram.ninputs, diagram.noutputs):  # which its block knows
        ((name, block),) = systems
        flat = _flatten(block, name)
        diagram = block
    output_map = hstack([flat.E, flat.F], format="csr")
    rows = _entries(flat.C), _entries(flat.D)
    return ordered_wiring(systems, *rows, diagram.ninputs or 0, output_map)


def read_anew(system: Any) -> None:
    """Read the functions of a diagram's blocks again: what they name may have changed."""
    for part in getattr(system, "syslist", [system]):
        if isinstance(part, control.InterconnectedSystem):
            read_anew(part)
        elif isinstance(part, Block):
            part.read_anew()


def _as_block(system: Any, params: Any, sizes: tuple[int | None, int | None]) -> Block:
    if isinstance(system, Block):
        return system
    return linear(system) if isinstance(system, control.StateSpace) else System(system, params, sizes)


def _handed_down(
    system: control.NonlinearIOSystem, given: Mapping[str, Any], path: str = ""
) -> Iterator[dict[str, Any]]:
    """Yield the params of each leaf, as python-control's `_update_params` leaves them.

    A key with the path of a nested diagram, ``"plant.mass"``, is for that diagram alone.
    """
    own = {k.removeprefix(path): v for k, v in given.items() if path and k.startswith(path)}
    if not isinstance(system, control.InterconnectedSystem):
        yield {} if isinstance(system, Block) else {**system.params, **given, **own}
        return
    for part in system.syslist:
        inner = f"{path}{part.name}." if isinstance(part, control.InterconnectedSystem) else path
        above = {**({} if isinstance(part, Block) else part.params), **system.params, **given, **own}
        yield from _handed_down(part, above, inner)


def ordered_wiring(
    systems: Sequence[tuple[str, control.NonlinearIOSystem]],
    from_outputs: Rows,
    from_inputs: Rows,
    ninputs: int,
    output_map: Any,
) -> Wiring:
    """Return the wiring of named systems, given what feeds each block input, in order."""
    nodes, x, u, y = [], 0, 0, 0
    for name, system in systems:
        states = slice(x, x := x + (system.nstates or 0))
        inputs = slice(u, u := u + (system.ninputs or 0))
        outputs = slice(y, y := y + (system.noutputs or 0))
        inner = _wires(from_outputs, inputs.start, inputs.stop, False)
        outer = _wires(from_inputs, inputs.start, inputs.stop, True)
        nodes.append(Node(system, name, states, inputs, outputs, (*inner, *outer)))
    return Wiring(tuple(nodes), _order(nodes), ninputs, output_map)


def _order(nodes: list[Node]) -> tuple[int, ...]:
    owner = [k for k, node in enumerate(nodes) for _ in range(node.system.noutputs or 0)]
    waits = {
        k: {owner[w.source + j] for w in node.wires if not w.external for j in range(w.size)}
        if reaches_outputs(node.system)
        else set()
        for k, node in enumerate(nodes)
    }
    order: list[int] = []
    while waits:
        ready = [k for k in waits if not waits[k] - set(order)]
        if not ready:
            raise DiagramError(
                f"algebraic loop: {_circle(waits, nodes)} feed each other at once; "
                "break the circle with a block that has states"
            )
        order.append(ready[0])
        del waits[ready[0]]
    return tuple(order)


def _circle(waits: dict[int, set[int]], nodes: list[Node]) -> str:
    path = [next(iter(waits))]
    while path.count(path[-1]) < 2:
        path.append(next(k for k in waits[path[-1]] if k in waits))
    return " <- ".join(nodes[k].name for k in path[path.index(path[-1]) :])
