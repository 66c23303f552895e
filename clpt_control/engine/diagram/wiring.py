"""The wires of an interconnected system: a diagram as a list of blocks.

python-control stores a diagram as matrices: `connect_map` (block outputs to block inputs),
`input_map` and `output_map`.  Here they become a list of blocks, in an order (`order`) in which one
pass computes every signal once.  The engine, the proofs and the drawing all take a diagram from
here.
"""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, NamedTuple, TypeAlias

import control
import numpy as np

from ...errors import DiagramError
from ..model.block import Block
from ..model.sampled import Sampled
from ..model.system import System, linear
from .evaluation_order import order_of

SMALL = 40_000  # entries of the largest matrix that is not sparse
Part: TypeAlias = control.NonlinearIOSystem  # of a diagram
Params = Mapping[str, Any] | None  # at call time, as python-control takes them
Sizes = tuple[int | None, int | None]  # of states and inputs, for a system that leaves them open
Row = dict[int, float]  # a sum: signal, or ~k for the diagram's input k -> its gain


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

    system: Part  # the block
    name: str  # its name; inside a nested diagram ``"outer.inner"``
    states: slice  # where its states stand among all states
    inputs: slice  # among all block inputs
    outputs: slice  # among all block outputs
    rows: tuple[Row, ...]  # what feeds each of its inputs

    def fed(self, external: bool = False) -> Iterator[tuple[int, int, float]]:
        """Yield each input that blocks feed, or that the diagram's inputs do: it, source, gain."""
        for to, row in enumerate(self.rows):
            for k, gain in row.items():
                if (k < 0) is external:
                    yield to, ~k if external else k, gain

    @cached_property
    def wires(self) -> tuple[Wire, ...]:
        """What feeds it, one wire for consecutive signals; those of the diagram's inputs last."""
        wires: list[Wire] = []
        for external in (False, True):
            following: dict[tuple, int] = {}  # the signal that would continue a wire -> its place
            for to, source, gain in sorted(self.fed(external)):
                k = following.pop((to, source, gain), len(wires))
                if k == len(wires):
                    wires.append(Wire(to, source, 0, gain, external))
                wires[k] = wires[k]._replace(size=wires[k].size + 1)
                following[to + 1, source + 1, gain] = k
        return tuple(wires)


@dataclass(frozen=True)
class Wiring:
    """A diagram as an ordered list of blocks."""

    nodes: tuple[Node, ...]  # blocks in the diagram's own order
    order: tuple[int, ...]  # indices into `nodes`, in which outputs can be computed one by one
    ninputs: int  # inputs of the diagram
    outputs: tuple[Row, ...]  # of the diagram
    dt: Any = 0  # of discrete time: from one step to the next, or True

    @property
    def blocks(self) -> list[tuple[str, Any]]:
        """The blocks with their names."""
        return [(node.name, node.system) for node in self.nodes]

    @cached_property
    def output_map(self) -> Any:
        """Outputs of all block outputs and then all inputs, as a matrix; sparse if large."""
        return self.matrix_of(self.outputs)

    def matrix_of(self, rows: Sequence[Row]) -> Any:
        """Return rows as a matrix, of all block outputs and then all inputs; sparse if large."""
        from scipy.sparse import dok_array

        signals = self.nodes[-1].outputs.stop
        shape = len(rows), signals + self.ninputs
        matrix: Any = np.zeros(shape) if shape[0] * shape[1] <= SMALL else dok_array(shape)
        for to, row in enumerate(rows):
            for k, gain in row.items():
                matrix[to, k if k >= 0 else signals + ~k] = gain
        return matrix if isinstance(matrix, np.ndarray) else matrix.tocsr()


def _flatten(system: Part, name: str) -> tuple[list[Row], list[Row]]:
    """Return the sum that feeds each input of a system's leaves, and that each output is."""
    if not isinstance(system, control.NonlinearIOSystem):
        raise DiagramError(
            f"{name} is a {type(system).__name__}: must be blocks, wired, or a system with states, "
            "such as control.ss(...)"
        )
    if not isinstance(system, control.InterconnectedSystem):
        outside: list[Row] = [{~k: 1.0} for k in range(system.ninputs or 0)]
        return outside, [{k: 1.0} for k in range(system.noutputs or 0)]
    fed, made = list[Row](), list[Row]()
    signals = taken = 0  # of the parts so far; in their rows ~k is an input of a part
    for part in system.syslist:
        for rows, own in zip((fed, made), _flatten(part, part.name), strict=True):
            rows += [{k + signals if k >= 0 else k - taken: g for k, g in r.items()} for r in own]
        signals += sum(int(one.noutputs or 0) for _, one in leaves([part]))
        taken += int(part.ninputs or 0)
    wires, inputs, shown = map(_entries, (system.connect_map, system.input_map, system.output_map))
    count, known = len(made), dict[int, Row | None]()

    def flat(k: int) -> Row:
        """Return the sum that output k of the parts is, or behind them their input k - count."""
        if k not in known:
            known[k], to = None, k - count
            sources = [(flat(source), gain) for source, gain in wires.get(to, ())]
            outer: Row = {~source: gain for source, gain in inputs.get(to, ())}
            known[k] = closed(made[k]) if to < 0 else added([(outer, 1.0), *sources])
        if (row := known[k]) is None:
            raise DiagramError(f"{name}: nested diagrams feed each other without a block")
        return row

    def closed(row: Row) -> Row:
        return added([({k: 1.0} if k >= 0 else flat(count + ~k), gain) for k, gain in row.items()])

    outputs = [
        added([(flat(k), gain) for k, gain in shown.get(to, ())])
        for to in range(len(system.output_map))
    ]
    return [closed(row) for row in fed], outputs


def leaves(
    parts: Iterable[Part], between: str = ".", space: str = ""
) -> Iterator[tuple[str, Part]]:
    """Yield the parts of a diagram with their names, those of nested diagrams too."""
    for part in parts:
        if isinstance(part, control.InterconnectedSystem):
            yield from leaves(part.syslist, between, f"{space}{part.name}{between}")
        else:
            yield space + part.name, part


def added(rows: Iterable[tuple[Row, float]]) -> Row:
    """Return the sum of rows, each by its factor."""
    total: Row = {}
    for row, factor in rows:
        for k, gain in row.items():
            total[k] = total.get(k, 0.0) + factor * gain
    return total


def _entries(matrix: np.ndarray) -> dict[int, list[tuple[int, float]]]:
    """Return the rows of a matrix: (column, number) of all that is not 0."""
    rows: dict[int, list[tuple[int, float]]] = {}
    to, source = np.nonzero(matrix)
    for i, j, number in zip(*(a.tolist() for a in (to, source, matrix[to, source])), strict=True):
        rows.setdefault(i, []).append((j, float(number)))
    return rows


def units_of(wiring: Wiring) -> tuple[list[str], list[str]]:
    """Return the units of all block outputs, and of the diagram's inputs; "" where there is none.

    A signal to which nothing gives a unit has that of a block input that takes it.
    """
    made = [unit for node in wiring.nodes for unit in node.system.units_of("output")]
    given = [""] * wiring.ninputs
    for node in wiring.nodes:
        taken = node.system.units_of("input")
        for row, external in ((made, False), (given, True)):
            for to, source, gain in node.fed(external):
                if gain == 1.0:
                    row[source] = row[source] or taken[to]
    return made, given


def wiring_of(diagram: Part, params: Params = None, sizes: Sizes = (None, None)) -> Wiring:
    """Return the wiring of a diagram, nested ones included, of blocks alone.

    python-control's systems become blocks, with `params` as python-control hands them down, and
    `sizes`, of states and inputs, where they leave them open.  An algebraic loop is refused.
    """
    fed, shown = _flatten(diagram, getattr(diagram, "name", repr(diagram)))
    systems = blocks_of(diagram, params, sizes)
    if not systems:
        raise DiagramError(f"{diagram.name}: has no blocks; give at least one")
    if None in (diagram.nstates, diagram.ninputs, diagram.noutputs):  # which its block knows
        ((name, diagram),) = systems
        fed, shown = _flatten(diagram, name)
    return ordered_wiring(systems, fed, int(diagram.ninputs or 0), shown, diagram.dt or 0)


def blocks_of(
    diagram: Part, params: Params = None, sizes: Sizes = (None, None)
) -> list[tuple[str, Block]]:
    """Return the blocks of a diagram with their names, in its own order."""
    handed = _handed_down(diagram, params or {})
    named = leaves(getattr(diagram, "syslist", [diagram]))
    return [
        (name, _as_block(system, own, sizes))
        for (name, system), own in zip(named, handed, strict=True)
    ]


def read_anew(system: Any) -> None:
    """Read the functions of a diagram's blocks again: objects that they name may have changed."""
    for part in getattr(system, "syslist", [system]):
        if isinstance(part, control.InterconnectedSystem):
            read_anew(part)
        elif isinstance(part, Block):
            part.read_anew()


def read_unsampled(system: Any, params: Params = None) -> Wiring:
    """Return the wiring of a diagram as it is now; refuse one in which a part samples."""
    read_anew(system)
    wiring = wiring_of(system, params)
    name = next((n.name for n in wiring.nodes if isinstance(n.system, Sampled)), None)
    if name is not None:
        raise DiagramError(f"{name}: samples its inputs; give the design that it was sampled from")
    return wiring


def _as_block(system: Any, *given: Any) -> Block:
    if isinstance(system, Block):
        return system
    return linear(system) if isinstance(system, control.StateSpace) else System(system, *given)


def _handed_down(
    system: Part, given: Mapping[str, Any], path: str = ""
) -> Iterator[dict[str, Any]]:
    """Yield the params of each leaf, as python-control's `_update_params` leaves them."""
    if not isinstance(system, control.InterconnectedSystem):
        own = {**system.params, **own_params(path + system.name, given)}
        yield {} if isinstance(system, Block) else own
        return
    for part in system.syslist:
        inner = f"{path}{part.name}." if isinstance(part, control.InterconnectedSystem) else path
        above = {} if isinstance(part, Block) else part.params
        yield from _handed_down(part, {**above, **system.params, **given}, inner)


def own_params(name: str, params: Mapping[str, Any]) -> dict[str, Any]:
    """Return the params of one system, a key under its name or that of a diagram around it too."""
    found = dict(params)
    for space in spaces_of(name)[1:]:
        found |= {k.removeprefix(space): v for k, v in params.items() if str(k).startswith(space)}
    return found


def call_names(name: str, block: Block) -> dict[str, str]:
    """Return names that a call may give a block's parameters, ``a.plant.k``, and the fields.

    Those of python-control's systems, sampled or not, are called ``k`` and ``a.k`` too.
    """
    spaces, inner = spaces_of(name), getattr(block, "inner", block)
    around, paths = spaces[: len(spaces) // 2], spaces[len(spaces) // 2 :]
    fields = inner.parameters._fields if isinstance(inner, System) else ()
    names = {space + field: field for space in around for field in fields}
    return names | {space + field: field for space in paths for field in block.parameters._fields}


def spaces_of(name: str) -> list[str]:
    """Return what may stand before a param of ``a.plant``; the last counts.

    First the diagrams around it, nothing and ``a.``, then what calls it, ``plant.``, ``a.plant.``.
    """
    path = name.split(".")
    around = [path[:k] for k in range(len(path))]
    calling = [path[k:] for k in reversed(range(len(path)))]
    return [".".join([*one, ""]) for one in (*around, *calling)]


def ordered_wiring(
    systems: Sequence[tuple[str, Part]],
    fed: Sequence[Row],
    ninputs: int,
    shown: Iterable[Row],
    dt: Any = 0,
    order: tuple[int, ...] = (),
) -> Wiring:
    """Return the wiring of named systems; `fed` has the sources of each block input, in order.

    The order in which they are computed is found, unless it is known.
    """
    nodes, x, u, y = [], 0, 0, 0
    for name, system in systems:
        states = slice(x, x := x + system.nstates)
        inputs = slice(u, u := u + system.ninputs)
        outputs = slice(y, y := y + system.noutputs)
        rows = tuple({k: gain for k, gain in row.items() if gain != 0.0} for row in fed[inputs])
        nodes.append(Node(system, name, states, inputs, outputs, rows))
    order = order or order_of(nodes)
    return Wiring(tuple(nodes), order, ninputs, tuple(shown), dt)
