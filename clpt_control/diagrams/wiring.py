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

from ..equations.arrays import Unread
from ..equations.block import Block
from ..equations.declaration import Parameters
from ..equations.elements import InputsOf
from ..equations.linear import linear
from ..equations.ports import places as inputs_of
from ..equations.sampled import Sampled
from ..equations.system import System
from ..errors import DiagramError

TRIED = 3  # points at which what cannot be read is tried
SMALL = 40_000  # entries of a matrix that is kept whole
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
    dt: Any = 0  # of discrete time: from one step to the next, or True


class _Flat(NamedTuple):
    """A system as leaves with U = C Y + D u and y = E Y + F u, sparse."""

    leaves: list[tuple[str, control.NonlinearIOSystem]]
    C: Any
    D: Any
    E: Any
    F: Any


def _flatten(system: control.NonlinearIOSystem, name: str) -> _Flat:
    if not isinstance(system, control.NonlinearIOSystem):
        raise DiagramError(
            f"{name} is a {type(system).__name__}: must be blocks, wired, or a system with states, "
            "such as control.ss(...)"
        )
    if not isinstance(system, control.InterconnectedSystem):
        m, n = system.ninputs or 0, system.noutputs or 0
        return _Flat([(name, system)], _zeros(m, n), _eye(m), _eye(n), _zeros(n, m))
    connections, inputs, outputs = map(
        _kept, (system.connect_map, system.input_map, system.output_map)
    )
    split = connections.shape[1]
    from_outputs, from_inputs = outputs[:, :split], outputs[:, split:]
    if not any(isinstance(part, control.InterconnectedSystem) for part in system.syslist):
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
    C, D, E, F = (_diagonal([part[k] for part in parts]) for k in range(1, 5))
    U_from_Y, U_from_u = connections @ E, inputs
    through = connections @ F
    for _ in range(len(parts)):  # signals that pass straight through nested diagrams
        if not _count(through):
            break
        U_from_Y, U_from_u = U_from_Y + through @ U_from_Y, U_from_u + through @ U_from_u
        through = through @ through
    if _count(through):
        raise DiagramError(f"{name}: nested diagrams feed each other without a block")
    return _Flat(
        leaves,
        C + D @ U_from_Y,
        D @ U_from_u,
        from_outputs @ (E + F @ U_from_Y) + from_inputs @ U_from_Y,
        (from_outputs @ F + from_inputs) @ U_from_u,
    )


# --- matrices: small ones as they are, large ones sparse -----------------------------------------


def _kept(matrix: Any) -> Any:
    from scipy.sparse import csr_array

    small = np.prod(matrix.shape) <= SMALL
    return np.asarray(matrix, dtype=float) if small else csr_array(matrix)


def _zeros(rows: int, columns: int) -> Any:
    from scipy.sparse import csr_array

    return np.zeros((rows, columns)) if rows * columns <= SMALL else csr_array((rows, columns))


def _eye(n: int) -> Any:
    from scipy.sparse import eye_array

    return np.eye(n) if n * n <= SMALL else eye_array(n, format="csr")


def _diagonal(parts: list[Any]) -> Any:
    from scipy import linalg, sparse

    shape = sum(part.shape[0] for part in parts), sum(part.shape[1] for part in parts)
    if shape[0] * shape[1] <= SMALL and all(isinstance(part, np.ndarray) for part in parts):
        return linalg.block_diag(*parts).reshape(shape)
    return sparse.block_diag(parts, format="csr")


def _count(matrix: Any) -> int:
    return int(np.count_nonzero(matrix) if isinstance(matrix, np.ndarray) else matrix.nnz)


def _beside(left: Any, right: Any) -> Any:
    from scipy.sparse import hstack

    if isinstance(left, np.ndarray) and isinstance(right, np.ndarray):
        return np.hstack([left, right])
    return hstack([left, right], format="csr")


def entries(matrix: Any) -> Rows:
    """Return the rows of a connection matrix."""
    if isinstance(matrix, np.ndarray):
        to, source = np.nonzero(matrix)
        columns = [to.tolist(), source.tolist(), matrix[to, source].tolist()]
    else:
        found = matrix.tocoo()
        columns = [column.tolist() for column in (*found.coords, found.data)]
    rows: Rows = {}
    for to, source, gain in zip(*columns, strict=True):
        if gain != 0.0:
            rows.setdefault(to, []).append((source, gain))
    return rows


def units_of(wiring: Wiring) -> tuple[list[str], list[str]]:
    """Return the units of all block outputs, and of the diagram's inputs; "" where none is said.

    An input of the diagram has the unit of what takes it.
    """
    made = [unit for node in wiring.nodes for unit in node.system.units_of("output")]
    given = [""] * wiring.ninputs
    for node in wiring.nodes:
        taken = node.system.units_of("input")
        for wire in (one for one in node.wires if one.external and one.gain == 1.0):
            for k in range(wire.size):
                given[wire.source + k] = given[wire.source + k] or taken[wire.to + k]
    return made, given


def joined_wires(rows: Rows, first: int, last: int, external: bool) -> list[Wire]:
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


def asked_at_once(block: Block) -> Block:
    """Return the block whose equations say what reaches the outputs when all is sampled."""
    return block.inner if isinstance(block, Sampled) else block


def reaches_outputs(block: Block) -> bool:
    """Return whether inputs reach outputs at once, or once sampled; what is not read is tried."""
    block = asked_at_once(block)
    return bool(block.ninputs and block.feedthrough and any(_through(block, by_signal=False)))


def _through(block: Block, by_signal: bool = True) -> list[set[int]]:
    """Return for each output the inputs that reach it at once; else whether any does."""
    block = asked_at_once(block)
    try:
        if not by_signal:
            return [{0}] if block.array_record("output").leaves("u") else []
        record = block.array_record("output")
        reaching = InputsOf(record.operations, block.sizes).outputs(record)
        places = {
            (port, k): own.start + k
            for port, (own, _) in inputs_of(block.input_shapes).items()
            for k in range(own.stop - own.start)
        }
        return [{places[one] for one in own} for own in reaching]
    except Unread:
        found = _tried(block)
    return found if by_signal else [set().union(*found)]


def _tried(block: Block) -> list[set[int]]:
    """Return the inputs that change each output at some points."""
    random, p = np.random.default_rng(0), block.parameters_at(0.0)
    found: list[set[int]] = [set() for _ in range(block.noutputs)]
    for _ in range(TRIED):
        x, u = (random.standard_normal((n,)) for n in (block.nstates, block.ninputs))
        before = block.values("output", block.noutputs, 0.0, x, u, p)
        for j in range(block.ninputs):
            moved = u.copy()
            moved[j] = random.standard_normal()
            after = block.values("output", block.noutputs, 0.0, x, moved, p)
            for i in np.flatnonzero((after != before) & ~(np.isnan(after) & np.isnan(before))):
                found[i].add(j)
    return found


def wiring_of(
    diagram: control.NonlinearIOSystem,
    params: Mapping[str, Any] | None = None,
    sizes: tuple[int | None, int | None] = (None, None),
) -> Wiring:
    """Return the wiring of a diagram, nested ones included, of blocks alone.

    python-control's systems become blocks, given `params` as python-control hands them down, and
    `sizes`, of states and inputs, where they leave them open.  What is truly circular is refused.
    """
    flat = _flatten(diagram, getattr(diagram, "name", repr(diagram)))
    if not flat.leaves:
        raise DiagramError(f"{diagram.name}: has no blocks; give at least one")
    handed, declared = _handed_down(diagram, params or {}), _handed_down(diagram, {})
    systems = [
        (name, _as_block(system, own, sizes, _own(known)))
        for (name, system), own, known in zip(flat.leaves, handed, declared, strict=True)
    ]
    if None in (diagram.nstates, diagram.ninputs, diagram.noutputs):  # which its block knows
        ((name, block),) = systems
        flat = _flatten(block, name)
        diagram = block
    output_map = _beside(flat.E, flat.F)
    rows = entries(flat.C), entries(flat.D)
    return ordered_wiring(systems, *rows, diagram.ninputs or 0, output_map, diagram.dt or 0)


def read_anew(system: Any) -> None:
    """Read the functions of a diagram's blocks again: what they name may have changed."""
    for part in getattr(system, "syslist", [system]):
        if isinstance(part, control.InterconnectedSystem):
            read_anew(part)
        elif isinstance(part, Block):
            part.read_anew()


def _as_block(system: Any, *given: Any) -> Block:
    if isinstance(system, Block):
        return system
    return linear(system) if isinstance(system, control.StateSpace) else System(system, *given)


def _own(params: Mapping[str, Any]) -> set[str]:
    """Return the names of params, without the blocks that python-control merges with them."""
    return {name for name, value in params.items() if not isinstance(value, Parameters)}


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
        above = {
            **({} if isinstance(part, Block) else part.params),
            **system.params,
            **given,
            **own,
        }
        yield from _handed_down(part, above, inner)


def ordered_wiring(
    systems: Sequence[tuple[str, control.NonlinearIOSystem]],
    from_outputs: Rows,
    from_inputs: Rows,
    ninputs: int,
    output_map: Any,
    dt: Any = 0,
) -> Wiring:
    """Return the wiring of named systems, given what feeds each block input, in order."""
    nodes, x, u, y = [], 0, 0, 0
    for name, system in systems:
        states = slice(x, x := x + (system.nstates or 0))
        inputs = slice(u, u := u + (system.ninputs or 0))
        outputs = slice(y, y := y + (system.noutputs or 0))
        inner = joined_wires(from_outputs, inputs.start, inputs.stop, False)
        outer = joined_wires(from_inputs, inputs.start, inputs.stop, True)
        nodes.append(Node(system, name, states, inputs, outputs, (*inner, *outer)))
    return Wiring(tuple(nodes), _order(nodes), ninputs, output_map, dt)


def _order(nodes: list[Node]) -> tuple[int, ...]:
    """Return the order in which blocks are computed; one stands twice if half of it comes first."""
    owner = [k for k, node in enumerate(nodes) for _ in range(node.system.noutputs or 0)]
    waits = {
        k: {owner[w.source + j] for w in node.wires if not w.external for j in range(w.size)}
        if reaches_outputs(node.system)
        else set()
        for k, node in enumerate(nodes)
    }
    order: list[int] = []
    done: set[int] = set()
    while waits:
        ready = next((k for k, feeding in waits.items() if feeding <= done), None)
        if ready is None:
            return _by_signals(nodes, order, waits)
        order.append(ready)
        done.add(ready)
        del waits[ready]
    return tuple(order)


def _by_signals(nodes: list[Node], order: list[int], waits: dict[int, set[int]]) -> tuple[int, ...]:
    """Return the order of what is circular by block: an output comes after its own inputs."""
    known = {s for k in order for s in range(nodes[k].outputs.start, nodes[k].outputs.stop)}
    needed: dict[int, dict[int, set[int]]] = {}  # block -> signal -> the signals that it waits for
    for k in waits:
        fed: dict[int, set[int]] = {}
        for wire in nodes[k].wires:
            for j in range(0 if wire.external else wire.size):
                fed.setdefault(wire.to + j, set()).add(wire.source + j)
        first = nodes[k].outputs.start
        needed[k] = {
            first + i: set().union(*(fed.get(j, set()) for j in inputs))
            for i, inputs in enumerate(_through(nodes[k].system))
        }
    while needed:
        turns = {k: {s for s, own in needed[k].items() if own <= known} for k in needed}
        ready = next((k for k in needed if len(turns[k]) == len(needed[k])), None)
        if ready is None:
            ready = next((k for k in needed if turns[k]), None)
        if ready is None:
            raise DiagramError(
                f"algebraic loop: {_circle(waits, nodes)} feed each other at once; "
                "break the circle with a block that has states"
            )
        order.append(ready)
        known |= turns[ready]
        needed[ready] = {s: own for s, own in needed[ready].items() if s not in known}
        if not needed[ready]:
            del needed[ready], waits[ready]
    return tuple(order)


def _circle(waits: dict[int, set[int]], nodes: list[Node]) -> str:
    path = [next(iter(waits))]
    while path.count(path[-1]) < 2:
        path.append(next(k for k in waits[path[-1]] if k in waits))
    return " <- ".join(nodes[k].name for k in path[path.index(path[-1]) :])
