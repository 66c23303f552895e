"""Read what is wired to what out of an interconnected system.

python-control keeps a diagram as matrices: `connect_map` (block outputs to
block inputs), `input_map` and `output_map`.  Here they become a list of blocks
in the order in which one pass computes every signal once: a block's turn comes
when all signals that reach its outputs at once are known.  The engine, the
proofs and the drawing all read a diagram through this file.
"""

from dataclasses import dataclass
from typing import Any, NamedTuple

import control
import numpy as np

from .blocks import Block
from .errors import DiagramError


class Wire(NamedTuple):
    """A run of consecutive signals, ``u += gain * source``.

    Attributes
    ----------
    to : int
        First input of the block that is fed.
    source : int
        First signal among all block outputs, or among the diagram's inputs.
    size : int
        Number of consecutive signals.
    gain : float
        Factor on each.
    external : bool
        True where the source is an input of the diagram.
    """

    to: int
    source: int
    size: int
    gain: float
    external: bool


@dataclass(frozen=True)
class Node:
    """One block in its place.

    Attributes
    ----------
    system : control.NonlinearIOSystem
        The block.
    name : str
        Its name; inside a nested diagram ``"outer.inner"``.
    states, inputs, outputs : slice
        Where its signals stand among all states, block inputs, block outputs.
    wires : tuple of Wire
        What feeds it.
    """

    system: control.NonlinearIOSystem
    name: str
    states: slice
    inputs: slice
    outputs: slice
    wires: tuple[Wire, ...]


@dataclass(frozen=True)
class Wiring:
    """A diagram as an ordered list of blocks.

    Attributes
    ----------
    nodes : tuple of Node
        Blocks in the diagram's own order.
    order : tuple of int
        Indices into `nodes`, in which outputs can be computed one by one.
    output_map : scipy.sparse array
        Diagram outputs from all block outputs and then all diagram inputs.
    """

    nodes: tuple[Node, ...]
    order: tuple[int, ...]
    output_map: Any


class _Flat(NamedTuple):
    """A system as leaves with U = C Y + D u and y = E Y + F u, sparse."""

    leaves: list[tuple[str, control.NonlinearIOSystem]]
    C: Any
    D: Any
    E: Any
    F: Any


def _flatten(system: control.NonlinearIOSystem, name: str) -> _Flat:
    from scipy.sparse import block_diag, csr_array, eye_array

    if not isinstance(system, control.InterconnectedSystem):
        m, n = system.ninputs, system.noutputs
        return _Flat(
            [(name, system)],
            csr_array((m, n)),
            eye_array(m, format="csr"),
            eye_array(n, format="csr"),
            csr_array((n, m)),
        )
    parts = []
    for part in system.syslist:
        inner = _flatten(part, part.name)
        if isinstance(part, control.InterconnectedSystem):
            inner = inner._replace(leaves=[(f"{part.name}.{n}", s) for n, s in inner.leaves])
        parts.append(inner)
    leaves = [leaf for part in parts for leaf in part.leaves]
    C, D, E, F = (block_diag([part[k] for part in parts], format="csr") for k in range(1, 5))
    connections = csr_array(system.connect_map)
    nested_outputs = connections.shape[1]
    U_from_Y, U_from_u = connections @ E, csr_array(system.input_map)
    through = connections @ F
    for _ in range(len(parts)):  # signals that pass straight through nested diagrams
        if not through.nnz:
            break
        U_from_Y, U_from_u = U_from_Y + through @ U_from_Y, U_from_u + through @ U_from_u
        through = through @ through
    if through.nnz:
        raise DiagramError(f"{name}: nested diagrams feed each other without a block")
    from_outputs = csr_array(system.output_map[:, :nested_outputs])
    from_inputs = csr_array(system.output_map[:, nested_outputs:])
    return _Flat(
        leaves,
        C + D @ U_from_Y,
        D @ U_from_u,
        from_outputs @ (E + F @ U_from_Y) + from_inputs @ U_from_Y,
        (from_outputs @ F + from_inputs) @ U_from_u,
    )


def _runs(matrix: Any, external: bool) -> list[Wire]:
    """Gather a connection matrix into runs of consecutive signals."""
    wires: list[Wire] = []
    found = matrix.tocoo()
    order = np.lexsort((found.coords[1], found.coords[0]))
    for at in order:
        to, source, gain = found.coords[0][at], found.coords[1][at], float(found.data[at])
        if gain == 0.0:
            continue
        for k, last in enumerate(wires):
            follows = (to, source) == (last.to + last.size, last.source + last.size)
            if follows and gain == last.gain:
                wires[k] = last._replace(size=last.size + 1)
                break
        else:
            wires.append(Wire(int(to), int(source), 1, gain, external))
    return wires


def reaches_outputs(system: control.NonlinearIOSystem) -> bool:
    """Tell whether a system's inputs reach its outputs at once.

    Parameters
    ----------
    system : control.NonlinearIOSystem
        A block says so itself; others are asked with a few random inputs.

    Returns
    -------
    bool
        True where there is feedthrough.

    Examples
    --------
    >>> import control
    >>> reaches_outputs(control.ss(-1, 1, 1, 0))
    False
    """
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


def read(diagram: control.NonlinearIOSystem) -> Wiring:
    """Read a diagram, nested ones included, into an ordered wiring.

    Parameters
    ----------
    diagram : control.NonlinearIOSystem
        An interconnected system of blocks and any python-control systems.

    Returns
    -------
    Wiring
        Blocks, wires, and an order of evaluation.

    Raises
    ------
    DiagramError
        If blocks feed each other at once in a circle; the blocks are named.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> diagram = clpt.closed_loop(clpt.paper_scenario())
    >>> [node.name for node in read(diagram).nodes][:3]
    ['reference', 'basis_x', 'basis_z']
    """
    from scipy.sparse import hstack

    flat = _flatten(diagram, diagram.name)
    nodes, x, u, y = [], 0, 0, 0
    for name, system in flat.leaves:
        states = slice(x, x := x + (system.nstates or 0))
        inputs = slice(u, u := u + system.ninputs)
        outputs = slice(y, y := y + system.noutputs)
        wires = _runs(flat.C[inputs], False) + _runs(flat.D[inputs], True)
        nodes.append(Node(system, name, states, inputs, outputs, tuple(wires)))
    order = _order(nodes)
    return Wiring(tuple(nodes), order, hstack([flat.E, flat.F], format="csr"))


def _order(nodes: list[Node]) -> tuple[int, ...]:
    owner = [k for k, node in enumerate(nodes) for _ in range(node.system.noutputs)]
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
